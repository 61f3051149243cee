//! Host file: one mesh of the vertices and faces of a PLY file.

use super::Content;
use crate::error::{Error, Result};
use crate::mesh::joiner::{Joiner, pick};
use crate::mesh::model::{Model, painted_material};
use crate::mesh::pictures::{Pictures, Use};
use crate::mesh::triangulate::Triangulator;
use crate::mesh::{colors, origin};
use crate::notes::Notes;
use glam::{Vec2, Vec3, Vec4};
use glimt_render_gpu::prepare::scene::{Material, Mesh, Reflection};
use std::path::Path;

/// The end of a strip.
const END: u32 = u32::MAX;

/// What distinguishes the corners of faces that have more than vertices.
type Kind = (Vec2, Vec4);

/// One mesh of all faces. Vertices are split where corners or faces have values of their own.
pub(super) fn assemble(content: Content, file: &Path, notes: &mut Notes) -> Result<Model> {
    let Content {
        vertices,
        faces,
        strips,
        pictures,
    } = content;
    let from = origin::of(&vertices.positions);
    let count = vertices.positions.len();
    let is_split = !faces.uvs.is_empty() || !faces.colors.is_empty();
    let mut joiner = Joiner::<Kind>::new(if is_split { count } else { 0 });
    let mut mesh = Mesh::default();
    let mut shown = Vec::new();
    let mut cutter = Triangulator::default();
    let mut corners = Vec::new();
    let mut polygon = Vec::new();
    for (index, range) in faces.ranges().enumerate() {
        let list = &faces.corners[range.clone()];
        list_corners(list, file, "face", index, count, &mut corners)?;
        let kind = |place: u32| {
            let uv = faces.uvs.get(range.start + place as usize);
            let color = faces.colors.get(index);
            (*uv.unwrap_or(&Vec2::ZERO), *color.unwrap_or(&Vec4::ONE))
        };
        let push = |t: [u32; 3]| {
            mesh.indices.push(t.map(|place| match is_split {
                true => joiner.vertex(corners[place as usize], kind(place)),
                false => corners[place as usize],
            }));
        };
        if corners.len() == 3 {
            Some([0, 1, 2]).into_iter().for_each(push);
        } else {
            polygon.clear();
            polygon.extend(corners.iter().map(|&i| vertices.positions[i as usize]));
            cutter.polygon(&polygon, push);
        }
        if let Some(texture) = faces.textures.get(index) {
            shown.resize(mesh.indices.len(), *texture);
        }
    }
    if cutter.crossing > 0 {
        let what = format!("{} of its polygons cross themselves", cutter.crossing);
        notes.defect(file, &what, "cut as well as it goes")?;
    }
    for (index, range) in strips.ranges().enumerate() {
        let list = &strips.corners[range];
        list_corners(list, file, "tristrips", index, count, &mut corners)?;
        push_strips(&corners, |t| {
            mesh.indices.push(match is_split {
                true => t.map(|corner| joiner.vertex(corner, (Vec2::ZERO, Vec4::ONE))),
                false => t,
            });
        });
    }
    mesh.positions = origin::relative(&vertices.positions, from, file, notes);
    // Programs that have no normals write zeros.
    if vertices.normals.iter().any(|n| *n != Vec3::ZERO) {
        mesh.normals = vertices.normals;
    }
    mesh.uvs = vertices.uvs;
    mesh.colors = vertices.colors;
    if is_split {
        let Joiner { points, kinds, .. } = joiner;
        mesh.positions = pick(&mesh.positions, &points);
        mesh.normals = pick(&mesh.normals, &points);
        mesh.uvs = match faces.uvs.is_empty() {
            true => pick(&mesh.uvs, &points),
            false => kinds.iter().map(|kind| kind.0).collect(),
        };
        mesh.colors = match mesh.colors.is_empty() && !faces.colors.is_empty() {
            true => kinds.iter().map(|kind| kind.1).collect(),
            false => pick(&mesh.colors, &points),
        };
    }
    // PLY counts v from the bottom of the image.
    for uv in &mut mesh.uvs {
        uv.y = 1.0 - uv.y;
    }
    mesh.materials = vec![0];
    mesh.name = file
        .file_name()
        .unwrap_or_default()
        .to_string_lossy()
        .into_owned();
    let mut model = Model {
        files: vec![file.to_owned()],
        origin: from,
        ..Model::of_mesh(mesh)
    };
    paint(&mut model, &pictures, shown, file, notes);
    Ok(model)
}

/// Gives the model its pictures, or else its vertex colours; `shown` is the picture of each triangle, if they differ.
fn paint(model: &mut Model, names: &[String], shown: Vec<u32>, file: &Path, notes: &mut Notes) {
    let has_uvs = !model.meshes[0].uvs.is_empty();
    if !names.is_empty() && !has_uvs {
        let what = "it names a picture (TextureFile), but has no texture coordinates; left out";
        notes.warn(file, what);
    }
    let mut materials = Vec::new();
    if has_uvs {
        let mut pictures = Pictures::new(file, model, notes);
        let read = |name: &String| pictures.texture(name, Use::Colour, false);
        materials = names.iter().filter_map(read).collect();
    }
    let mesh = &mut model.meshes[0];
    if materials.is_empty() || materials.len() < names.len() {
        if !mesh.colors.is_empty() {
            let opacity = colors::decode(&mut mesh.colors, file, notes);
            model.materials = vec![painted_material(opacity)];
            model.material_names = vec!["vertex colours".to_owned()];
        }
        return;
    }
    if !mesh.colors.is_empty() {
        let what = "it has a picture and vertex colours; the picture alone is used";
        notes.note(file, what);
        mesh.colors.clear();
    }
    let last = materials.len() as u32 - 1;
    if last > 0 && !shown.is_empty() {
        mesh.materials = shown;
        mesh.materials.resize(mesh.indices.len(), 0);
        let beyond = mesh.materials.iter().filter(|m| **m > last).count();
        if beyond > 0 {
            let what = format!(
                "{beyond} triangles show a picture that it does not name; the last is taken"
            );
            notes.warn(file, what);
        }
        for material in &mut mesh.materials {
            *material = (*material).min(last);
        }
    }
    model.materials = materials.into_iter().map(textured).collect();
    model.material_names = names.to_vec();
}

/// A matt surface of the colours of a texture.
fn textured(texture: u32) -> Material {
    Material::from(Reflection::MetallicRoughness {
        base_color: Vec3::ONE,
        metallic: 0.0,
        roughness: 1.0,
        base_color_texture: Some(texture.into()),
        metallic_roughness_texture: None,
        normal_texture: None,
        normal_scale: 1.0,
    })
}

/// Puts the corners of a face into a list, as indices; −1, which ends a strip, is [`END`].
fn list_corners(
    indices: &[i32],
    file: &Path,
    element: &str,
    index: usize,
    len: usize,
    list: &mut Vec<u32>,
) -> Result<()> {
    list.clear();
    for &i in indices {
        list.push(match u32::try_from(i) {
            Ok(i) if (i as usize) < len => i,
            Err(_) if i == -1 && element == "tristrips" => END,
            _ => {
                let what = format!("its corner {i} does not exist: there are {len} vertices");
                return Err(Error::input(file, what)
                    .at(format!("{element} {index}"))
                    .fix("the file is broken: export it again"));
            }
        });
    }
    Ok(())
}

fn push_strips(corners: &[u32], mut push: impl FnMut([u32; 3])) {
    for strip in corners.split(|&i| i == END) {
        for (i, t) in strip.windows(3).enumerate() {
            // Every second triangle of a strip runs the other way round.
            let swap = i % 2 == 1;
            push(if swap {
                [t[1], t[0], t[2]]
            } else {
                [t[0], t[1], t[2]]
            });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn strips_alternate() {
        let mut triangles = Vec::new();
        push_strips(&[0, 1, 2, 3, END, 4, 5, 6], |t| triangles.push(t));
        assert_eq!(triangles, [[0, 1, 2], [2, 1, 3], [4, 5, 6]]);
    }
}
