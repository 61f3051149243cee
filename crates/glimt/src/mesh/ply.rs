//! Host file: PLY meshes, ASCII or binary, plain or gzipped.

use super::model::Model;
use crate::error::{Error, Result};
use crate::notes::Notes;
use flate2::bufread::MultiGzDecoder;
use glam::{Vec2, Vec3};
use glimt_render_gpu::prepare::scene::Mesh;
use ply_rs_bw::parser::{Parser, Reader};
use ply_rs_bw::ply::{ElementDef, Header, PropertyAccess, PropertyAccessResult};
use std::fs::File;
use std::io::{BufRead, BufReader};
use std::path::Path;

/// Reads a PLY file.
///
/// # Errors
/// It cannot be read, or is broken.
pub fn load(file: &Path, notes: &mut Notes) -> Result<Model> {
    let opened = File::open(file).map_err(|e| Error::reading(file, &e))?;
    let mut plain = BufReader::new(opened);
    let start = plain.fill_buf().map_err(|e| Error::reading(file, &e))?;
    let mesh = if start.starts_with(&[0x1f, 0x8b]) {
        read(file, BufReader::new(MultiGzDecoder::new(plain)), notes)?
    } else {
        read(file, plain, notes)?
    };
    Ok(Model {
        files: vec![file.to_owned()],
        ..Model::of_mesh(mesh)
    })
}

fn read(file: &Path, reader: impl BufRead, notes: &mut Notes) -> Result<Mesh> {
    let broken = |e: ply_rs_bw::parser::ParseError| {
        let error = match e.kind() {
            std::io::ErrorKind::UnexpectedEof => Error::reading(file, &e.kind().into()),
            // The library quotes the file's line; its own words are the last of its lines.
            _ => Error::input(file, last_words(&e.to_string()))
                .fix("the file is broken: export it again"),
        };
        match e.line() {
            Some(line) => error.at_line(line, 1),
            None => error,
        }
    };
    let mut reader = Reader::new(reader);
    let header: Header = Parser::<Skipped>::new()
        .read_header(&mut reader)
        .map_err(broken)?;

    let mut mesh = Mesh {
        name: file
            .file_name()
            .unwrap_or_default()
            .to_string_lossy()
            .into_owned(),
        materials: vec![0],
        ..Mesh::default()
    };
    for (name, element) in &header.elements {
        match name.as_str() {
            "vertex" => {
                let vertices = Parser::<Vertex>::new()
                    .read_payload_for_element(&mut reader, element, &header)
                    .map_err(broken)?;
                store_vertices(&mut mesh, element, &vertices);
            }
            "face" | "tristrips" => {
                let faces = Parser::<Face>::new()
                    .read_payload_for_element(&mut reader, element, &header)
                    .map_err(broken)?;
                let strips = name == "tristrips";
                for (i, face) in faces.iter().enumerate() {
                    let corners = corners(face, file, name, i, mesh.positions.len())?;
                    if strips {
                        push_strips(&mut mesh.indices, &corners);
                    } else {
                        push_polygon(&mut mesh.indices, &corners);
                    }
                }
            }
            other => {
                Parser::<Skipped>::new()
                    .read_payload_for_element(&mut reader, element, &header)
                    .map_err(broken)?;
                notes.note(file, format!("its element `{other}` is not used"));
            }
        }
    }
    Ok(mesh)
}

fn last_words(message: &str) -> String {
    let last = message.lines().last().unwrap_or_default();
    last.trim().trim_start_matches("Error: ").to_owned()
}

fn store_vertices(mesh: &mut Mesh, element: &ElementDef, vertices: &[Vertex]) {
    let has = |names: &[&str]| names.iter().all(|n| element.properties.contains_key(*n));
    mesh.positions = vertices.iter().map(|v| v.position).collect();
    if has(&["nx", "ny", "nz"]) {
        mesh.normals = vertices.iter().map(|v| v.normal).collect();
    }
    let uv_names = [["s", "t"], ["u", "v"], ["texture_u", "texture_v"]];
    if uv_names.iter().any(|names| has(names)) {
        // PLY counts v from the bottom of the image.
        mesh.uvs = vertices
            .iter()
            .map(|v| Vec2::new(v.uv.x, 1.0 - v.uv.y))
            .collect();
    }
}

/// The corners of a face as indices; −1, which ends a strip, is `u32::MAX`.
fn corners(face: &Face, file: &Path, element: &str, index: usize, len: usize) -> Result<Vec<u32>> {
    let strips = element == "tristrips";
    face.indices
        .iter()
        .map(|&i| match u32::try_from(i) {
            Ok(i) if (i as usize) < len => Ok(i),
            Err(_) if strips && i == -1 => Ok(u32::MAX),
            _ => Err(Error::input(
                file,
                format!("its corner {i} does not exist: there are {len} vertices"),
            )
            .at(format!("{element} {index}"))
            .fix("the file is broken: export it again")),
        })
        .collect()
}

fn push_polygon(triangles: &mut Vec<[u32; 3]>, corners: &[u32]) {
    for pair in corners.windows(2).skip(1) {
        triangles.push([corners[0], pair[0], pair[1]]);
    }
}

fn push_strips(triangles: &mut Vec<[u32; 3]>, corners: &[u32]) {
    for strip in corners.split(|&i| i == u32::MAX) {
        for (i, t) in strip.windows(3).enumerate() {
            // Every second triangle of a strip runs the other way round.
            let swap = i % 2 == 1;
            triangles.push(if swap {
                [t[1], t[0], t[2]]
            } else {
                [t[0], t[1], t[2]]
            });
        }
    }
}

/// A corner. Properties that are not named here are skipped.
#[derive(Default)]
struct Vertex {
    position: Vec3,
    normal: Vec3,
    uv: Vec2,
}

impl Vertex {
    fn set(&mut self, name: &str, value: f64) -> PropertyAccessResult {
        let value = value as f32;
        match name {
            "x" => self.position.x = value,
            "y" => self.position.y = value,
            "z" => self.position.z = value,
            "nx" => self.normal.x = value,
            "ny" => self.normal.y = value,
            "nz" => self.normal.z = value,
            "s" | "u" | "texture_u" => self.uv.x = value,
            "t" | "v" | "texture_v" => self.uv.y = value,
            _ => return PropertyAccessResult::Ignored,
        }
        PropertyAccessResult::Set
    }
}

/// A polygon or the strips of a mesh.
#[derive(Default)]
struct Face {
    indices: Vec<i64>,
}

impl Face {
    fn set<I: Into<i64>>(&mut self, name: &str, list: Vec<I>) -> PropertyAccessResult {
        if !matches!(name, "vertex_indices" | "vertex_index") {
            return PropertyAccessResult::Ignored;
        }
        self.indices = list.into_iter().map(Into::into).collect();
        PropertyAccessResult::Set
    }
}

/// An element that is read past.
struct Skipped;

macro_rules! setters {
    ($set:ident: $($name:ident($value:ty)),+) => {
        $(fn $name(&mut self, name: &str, value: $value) -> PropertyAccessResult {
            $set!(self, name, value)
        })+
    };
}

macro_rules! set_vertex {
    ($self:ident, $name:ident, $value:ident) => {
        $self.set($name, f64::from($value))
    };
}

macro_rules! set_face {
    ($self:ident, $name:ident, $value:ident) => {
        $self.set($name, $value)
    };
}

impl PropertyAccess for Vertex {
    fn new() -> Self {
        Self::default()
    }
    setters!(set_vertex: set_char(i8), set_uchar(u8), set_short(i16), set_ushort(u16), set_int(i32), set_uint(u32),
        set_float(f32), set_double(f64));
}

impl PropertyAccess for Face {
    fn new() -> Self {
        Self::default()
    }
    setters!(set_face: set_list_char(Vec<i8>), set_list_uchar(Vec<u8>), set_list_short(Vec<i16>),
        set_list_ushort(Vec<u16>), set_list_int(Vec<i32>), set_list_uint(Vec<u32>));
}

impl PropertyAccess for Skipped {
    fn new() -> Self {
        Self
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn strips_and_polygons() {
        let mut triangles = Vec::new();
        push_strips(&mut triangles, &[0, 1, 2, 3, u32::MAX, 4, 5, 6]);
        assert_eq!(triangles, [[0, 1, 2], [2, 1, 3], [4, 5, 6]]);
        triangles.clear();
        push_polygon(&mut triangles, &[0, 1, 2, 3]);
        assert_eq!(triangles, [[0, 1, 2], [0, 2, 3]]);
    }
}
