//! Host file: meshes, each described, and rendered with its materials and animations in a small frame.

use super::images::{picture, png_of, radiance_flat};
use super::{Maker, Seed, gltf};
use flate2::Compression;
use flate2::write::GzEncoder;
use std::io::Write;

type Files = Vec<(String, Vec<u8>)>;

pub(super) fn add(maker: &mut Maker<'_>) -> Result<(), String> {
    for files in gltf::text()? {
        add_mesh(maker, "gltf", files, "")?;
    }
    for bytes in gltf::binary()? {
        add_mesh(maker, "glb", vec![("a.glb".to_owned(), bytes)], "")?;
    }
    for files in gltf::textured()? {
        add_mesh(maker, "texture", files, "")?;
    }
    let library = MTL.as_bytes().to_vec();
    let picture = png_of(&picture().into())?;
    for text in OBJ {
        let files = vec![
            ("a.obj".to_owned(), text.as_bytes().to_vec()),
            ("a.mtl".to_owned(), library.clone()),
            ("a.png".to_owned(), picture.clone()),
        ];
        add_mesh(maker, "obj", files, "")?;
    }
    for bytes in ply() {
        add_mesh(maker, "ply", vec![("a.ply".to_owned(), bytes)], "")?;
    }
    for bytes in ply() {
        let packed = gzip(&bytes)?;
        add_mesh(maker, "ply.gz", vec![("a.ply.gz".to_owned(), packed)], "")?;
    }
    for bytes in stl() {
        add_mesh(maker, "stl", vec![("a.stl".to_owned(), bytes)], "")?;
    }
    Ok(())
}

/// A file as gzip packs it.
pub(crate) fn gzip(bytes: &[u8]) -> Result<Vec<u8>, String> {
    let mut packer = GzEncoder::new(Vec::new(), Compression::fast());
    packer.write_all(bytes).map_err(|e| e.to_string())?;
    packer.finish().map_err(|e| e.to_string())
}

/// Adds a mesh, whose first file is the one that a shot names.
fn add_mesh<'a>(
    maker: &'a mut Maker<'_>,
    format: &'static str,
    files: Files,
    more: &str,
) -> Result<&'a mut Seed, String> {
    let name = files[0].0.clone();
    let shot = format!(
        "[image]\nsize = [8, 6]\nrays_per_pixel = 1\n[probe]\nframes = \"light.hdr\"\n[render]\nframes = \"1-2\"\n\
         [output]\nvideo = \"\"\npng = false\n[[object]]\nmesh = \"{name}\"\n{more}"
    );
    let light = radiance_flat();
    let fixed: [(&str, &[u8]); 2] = [("shot.toml", shot.as_bytes()), ("light.hdr", &light)];
    let info = format!("info {name}");
    maker.add(format, files, &fixed, &[&info, "load shot.toml", RENDER])
}

/// Renders a shot of a few pixels.
pub(super) const RENDER: &str = "render shot.toml --device cpu --out out";

const OBJ: [&str; 3] = [
    "# a box with everything\nmtllib a.mtl\no box\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.5 0.5 1\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n\
     vn 0 0 1\nvn 0 1 0\ng one\ns off\nusemtl red\nf 1/1/1 2/2/1 3/3/1 4/4/1\ng two\ns 1\nusemtl picture\nf 1/1 2/2 5/3\nf 2//2 3//2 5//2\n\
     f -3 -2 -1\nl 1 2\np 1\nusemtl unknown\nf 3 4 5\n",
    "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 1 2 0 0 0 1\nv 0.2 0.3 0 0.5 0.5 0.5\nv 0 2 0 1 1 1\nf 1 2 3 4 5\nf 1 2 \\\n 3\n",
    "\u{feff}mtllib .\\a.mtl\nv 500000.5 4000000.25 100\nv 500001.5 4000000.25 100\nv 500000.5 4000001.25 100\nf 1 2 3\n",
];

const MTL: &str = "newmtl red\nKa 0 0 0\nKd 0.8 0.1 0.1\nKs 0.2 0.2 0.2\nKe 0.5 0 0\nNs 40\nNi 1.5\nd 0.5\nillum 2\nPr 0.3\nPm 0.9\n\n\
    newmtl picture\nTr 0.25\nmap_Kd -s 2 2 1 -o 0.5 0 0 -clamp on a.png\nmap_d a.png\nmap_Bump -bm 0.5 a.png\n";

/// Four corners with all that a vertex may have, of which two faces are made.
fn ply() -> Vec<Vec<u8>> {
    let head = |format: &str, list: &str| {
        format!(
            "ply\nformat {format} 1.0\ncomment TextureFile a.png\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n\
             property float nx\nproperty float ny\nproperty float nz\nproperty float s\nproperty float t\n\
             property uchar red\nproperty uchar green\nproperty uchar blue\nelement face 2\nproperty list {list} vertex_indices\n\
             element other 1\nproperty double a\nend_header\n"
        )
    };
    let corners = [[0.0f32, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let faces: [&[i32]; 2] = [&[0, 1, 2, 3], &[2, 1, 0]];
    let mut text = head("ascii", "uchar int");
    for [x, y] in corners {
        text.push_str(&format!("{x} {y} 0.5 0 0 1 {x} {y} 255 128 0\n"));
    }
    text.push_str("4 0 1 2 3\n3 2 1 0\n1.5\n");
    let mut all = vec![text.into_bytes()];
    for (format, is_big) in [("binary_little_endian", false), ("binary_big_endian", true)] {
        let mut bytes = head(format, "uchar int").into_bytes();
        let ordered = |mut word: Vec<u8>| {
            if is_big {
                word.reverse();
            }
            word
        };
        for [x, y] in corners {
            for value in [x, y, 0.5, 0.0, 0.0, 1.0, x, y] {
                bytes.extend(ordered(value.to_le_bytes().to_vec()));
            }
            bytes.extend([255, 128, 0]);
        }
        for face in faces {
            bytes.push(face.len() as u8);
            for index in face {
                bytes.extend(ordered(index.to_le_bytes().to_vec()));
            }
        }
        bytes.extend(ordered(1.5f64.to_le_bytes().to_vec()));
        all.push(bytes);
    }
    let strips = "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\nproperty double z\nelement tristrips 1\n\
        property list int int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n5 0 1 2 -1 3\n";
    let early = "ply\nformat ascii 1.0\nelement vertex 3\nproperty short x\nproperty ushort y\nproperty char z\nelement face 1\n\
        property list ushort uint vertex_index\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    all.extend([strips, early].map(|text| text.as_bytes().to_vec()));
    all
}

/// Two triangles, in text and in bytes.
fn stl() -> [Vec<u8>; 2] {
    let triangles = [
        [[0.0f32, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
        [[1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]],
    ];
    let mut text = "solid a\n".to_owned();
    let mut bytes = vec![b' '; 80];
    bytes.extend((triangles.len() as u32).to_le_bytes());
    for corners in triangles {
        text.push_str("facet normal 0 0 1\nouter loop\n");
        bytes.extend([0.0f32, 0.0, 1.0].map(f32::to_le_bytes).concat());
        for [x, y, z] in corners {
            text.push_str(&format!("vertex {x} {y} {z}\n"));
            bytes.extend([x, y, z].map(f32::to_le_bytes).concat());
        }
        text.push_str("endloop\nendfacet\n");
        bytes.extend([0; 2]);
    }
    text.push_str("endsolid a\n");
    [text.into_bytes(), bytes]
}
