//! Host file: STL meshes, binary or ASCII.

use super::lines::{Lines, number, split_word, words};
use super::model::Model;
use super::{contents, normals, origin};
use crate::error::{Error, Result};
use crate::notes::Notes;
use glam::DVec3;
use glimt_render_gpu::prepare::scene::Mesh;
use std::path::Path;

/// Bytes before the triangles of a binary file: a title, and their number.
const HEAD: usize = 84;
/// Bytes of a triangle: a normal, three corners, and two bytes that programs use as they like.
const TRIANGLE: usize = 50;

/// Reads an STL file. Corners in the same place are one; the file's normals, one for each triangle, say nothing that corners do not.
///
/// # Errors
/// It cannot be read, or is broken.
pub fn load(file: &Path, notes: &mut Notes) -> Result<Model> {
    let bytes = contents::read(file)?;
    let corners = match read_binary(&bytes, file, notes) {
        Some(corners) => corners,
        None if bytes.trim_ascii_start().starts_with(b"solid") => read_ascii(&bytes, file)?,
        None => return Err(not_whole(&bytes, file)),
    };
    let from = origin::of(&corners);
    let positions = origin::relative(&corners, from, file, notes);
    let points = normals::points(&positions);
    let name = file.file_name().unwrap_or_default().to_string_lossy();
    let mesh = Mesh {
        name: name.into_owned(),
        positions,
        indices: points.as_chunks::<3>().0.to_vec(),
        materials: vec![0],
        ..Mesh::default()
    };
    Ok(Model {
        files: vec![file.to_owned()],
        origin: from,
        ..Model::of_mesh(mesh)
    })
}

fn triangles_said(bytes: &[u8]) -> Option<usize> {
    let count = bytes.get(HEAD - 4..HEAD)?.first_chunk::<4>()?;
    Some(u32::from_le_bytes(*count) as usize)
}

/// The corners of a binary file; `None` if its length is not that of one. Its title may well begin as an ASCII file does.
fn read_binary(bytes: &[u8], file: &Path, notes: &mut Notes) -> Option<Vec<DVec3>> {
    let count = triangles_said(bytes)?;
    let (triangles, rest) = bytes[HEAD..].as_chunks::<TRIANGLE>();
    if triangles.len() != count || !rest.is_empty() {
        return None;
    }
    let float = |bytes: &[u8]| bytes.first_chunk().map_or(0.0, |b| f32::from_le_bytes(*b));
    let corner = |bytes: &[u8]| {
        let [x, y, z] = [0, 4, 8].map(|at| f64::from(float(&bytes[at..])));
        DVec3::new(x, y, z)
    };
    let of_triangle = |t: &[u8; TRIANGLE]| [12, 24, 36].map(|at| corner(&t[at..]));
    // Two programs set the highest bit where a triangle has a colour, or where it has none.
    if triangles.iter().any(|t| t[48] != 0 || t[49] != 0) {
        notes.warn(file, "its triangles may have colours of their own, which STL does not define; they are left out");
    }
    Some(triangles.iter().flat_map(of_triangle).collect())
}

fn read_ascii(bytes: &[u8], file: &Path) -> Result<Vec<DVec3>> {
    let mut corners = Vec::new();
    for (line, text) in Lines::new(file, bytes)? {
        let (word, rest) = split_word(&text);
        let is_end = word.eq_ignore_ascii_case(b"endfacet");
        let wrong = match word.eq_ignore_ascii_case(b"vertex") {
            true => {
                let values: Vec<f64> = words(rest).map_while(number).collect();
                let corner = <[f64; 3]>::try_from(values);
                corners.extend(corner.iter().map(|&c| DVec3::from(c)));
                corner.err().map(|_| "a vertex needs three numbers")
            }
            false if is_end && !corners.len().is_multiple_of(3) => {
                Some("a facet needs three vertices")
            }
            false => None,
        };
        if let Some(what) = wrong {
            return Err(Error::input(file, what)
                .at_line(line, 1)
                .fix("the file is broken: export it again"));
        }
    }
    if !corners.len().is_multiple_of(3) {
        return Err(Error::input(file, "the file ends too early")
            .fix("it is probably truncated: copy or export it again"));
    }
    Ok(corners)
}

fn not_whole(bytes: &[u8], file: &Path) -> Error {
    let what = match triangles_said(bytes) {
        None => "the file ends too early".to_owned(),
        Some(count) => {
            let there = bytes.len() - HEAD;
            let need = count as u64 * TRIANGLE as u64;
            format!(
                "it is neither an ASCII nor a whole binary STL: {there} of {need} bytes are there"
            )
        }
    };
    Error::input(file, what).fix("it is probably truncated: copy or export it again")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn binary(title: &[u8], triangles: &[[[f32; 3]; 3]]) -> Vec<u8> {
        let mut bytes = title.to_vec();
        bytes.resize(80, b' ');
        bytes.extend((triangles.len() as u32).to_le_bytes());
        for triangle in triangles {
            bytes.extend([0; 12]);
            bytes.extend(triangle.as_flattened().iter().flat_map(|f| f.to_le_bytes()));
            bytes.extend([0; 2]);
        }
        bytes
    }

    const TRIANGLES: [[[f32; 3]; 3]; 2] = [
        [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.5, 0.0]],
        [[0.0, 0.0, 0.0], [0.0, 1.5, 0.0], [0.0, 0.0, 2.0]],
    ];

    #[test]
    fn binary_and_ascii_are_the_same() {
        let file = Path::new("a.stl");
        let mut notes = Notes::default();
        let mut text = "solid a thing\n".to_owned();
        for triangle in TRIANGLES {
            text.push_str("facet normal 0 0 0\r\n outer loop\n");
            for [x, y, z] in triangle {
                text.push_str(&format!("  vertex {x} {y:e} {z}\n"));
            }
            text.push_str(" endloop\nendfacet\n");
        }
        let ascii = read_ascii(text.as_bytes(), file).unwrap();
        assert!(read_binary(text.as_bytes(), file, &mut notes).is_none());
        for title in [&b"made here"[..], b"solid in name alone"] {
            let bytes = binary(title, &TRIANGLES);
            assert_eq!(read_binary(&bytes, file, &mut notes).unwrap(), ascii);
        }
        assert_eq!(ascii[2], DVec3::new(0.0, 1.5, 0.0));
        assert!(notes.take().is_empty());
    }

    #[test]
    fn broken_files() {
        let file = Path::new("a.stl");
        let whole = binary(b"", &TRIANGLES);
        for length in [0, 20, 84, 100, whole.len() - 1] {
            assert!(read_binary(&whole[..length], file, &mut Notes::default()).is_none());
            not_whole(&whole[..length], file);
        }
        let cases = [
            ("solid\nfacet\nvertex 0 0\n", "a.stl:3:1"),
            ("solid\nvertex 0 0 0\nendfacet\n", "a.stl:3:1"),
            ("solid\nvertex 0 0 0\n", "too early"),
        ];
        for (text, what) in cases {
            let error = read_ascii(text.as_bytes(), file).unwrap_err().to_string();
            assert!(error.contains(what), "{error}");
        }
    }
}
