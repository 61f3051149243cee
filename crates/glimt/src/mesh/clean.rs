//! Host file: what every mesh must fulfil, whatever file it came from.

use super::model::Model;
use crate::error::{Error, Result};
use crate::notes::Notes;
use glam::{DVec3, Vec3};
use glimt_render_gpu::prepare::scene::{Mesh, Reflection};
use std::path::Path;

/// Checks and mends a model: indices must be in range and coordinates finite; triangles without area are dropped, normals
/// without length replaced, materials that reflect more than they receive scaled down.
///
/// # Errors
/// An index out of range, a coordinate that is not finite, no triangle at all; with strict `notes` also triangles without
/// area.
pub fn clean(model: &mut Model, file: &Path, notes: &mut Notes) -> Result<()> {
    let mut degenerate = 0;
    for (index, mesh) in model.meshes.iter_mut().enumerate() {
        check_vertices(mesh, file)?;
        check_indices(mesh, file)?;
        // Others may have an area in another pose.
        if !model.deforms.contains_key(&index) {
            degenerate += drop_degenerate(mesh);
        }
        mend_normals(mesh, file, notes);
    }
    let total = model.triangles();
    if degenerate > 0 && total > 0 {
        let noun = if degenerate == 1 {
            "triangle has"
        } else {
            "triangles have"
        };
        let what = format!("{degenerate} {noun} no area");
        notes.defect(file, &what, "left out")?;
    }
    if total == 0 {
        let what = match degenerate {
            0 => "it has no triangles".to_owned(),
            n => format!("none of its {n} triangles has an area"),
        };
        return Err(
            Error::input(file, what).fix("export it with faces; points and lines are not rendered")
        );
    }
    model.parts.retain(|part| {
        let mesh = &model.meshes[part.mesh];
        !mesh.indices.is_empty()
    });
    scale_materials(model, file, notes);
    Ok(())
}

fn named(mesh: &Mesh, what: &str, index: usize) -> String {
    if mesh.name.is_empty() {
        return format!("{what} {index}");
    }
    format!("mesh `{}`, {what} {index}", mesh.name)
}

fn check_vertices(mesh: &Mesh, file: &Path) -> Result<()> {
    let found = [
        (
            "position",
            mesh.positions.iter().position(|p| !p.is_finite()),
        ),
        (
            "texture coordinate",
            mesh.uvs.iter().position(|p| !p.is_finite()),
        ),
        ("tangent", mesh.tangents.iter().position(|p| !p.is_finite())),
    ];
    for (what, index) in found {
        if let Some(index) = index {
            return Err(Error::input(file, format!("its {what} is not finite"))
                .at(named(mesh, "vertex", index))
                .fix("mend it in the program that it comes from"));
        }
    }
    Ok(())
}

fn check_indices(mesh: &Mesh, file: &Path) -> Result<()> {
    let len = mesh.positions.len();
    let outside = |t: &[u32; 3]| t.iter().any(|&i| i as usize >= len);
    match mesh.indices.iter().position(outside) {
        None => Ok(()),
        Some(index) => {
            let [a, b, c] = mesh.indices[index];
            let what = format!("its corners are {a}, {b}, {c}, but there are only {len} vertices");
            Err(Error::input(file, what)
                .at(named(mesh, "triangle", index))
                .fix("the file is broken: export it again"))
        }
    }
}

/// The cross product of two sides, in f64 so that small triangles keep their area.
fn area_vector(mesh: &Mesh, [a, b, c]: [u32; 3]) -> DVec3 {
    let p = |i: u32| mesh.positions[i as usize].as_dvec3();
    (p(b) - p(a)).cross(p(c) - p(a))
}

fn drop_degenerate(mesh: &mut Mesh) -> usize {
    let has_area = |t: &[u32; 3]| area_vector(mesh, *t).length_squared() > 0.0;
    let keep: Vec<bool> = mesh.indices.iter().map(has_area).collect();
    let dropped = keep.iter().filter(|k| !**k).count();
    if dropped > 0 {
        let mut kept = keep.iter();
        mesh.indices.retain(|_| *kept.next().unwrap_or(&true));
        if mesh.materials.len() > 1 {
            let mut kept = keep.iter();
            mesh.materials.retain(|_| *kept.next().unwrap_or(&true));
        }
    }
    dropped
}

/// Replaces normals that have no direction by those of the faces around them.
fn mend_normals(mesh: &mut Mesh, file: &Path, notes: &mut Notes) {
    let bad: Vec<usize> = (0..mesh.normals.len())
        .filter(|&i| {
            let length = mesh.normals[i].length();
            !(length > 1e-20 && length.is_finite())
        })
        .collect();
    if bad.is_empty() {
        return;
    }
    let mut sums = vec![DVec3::ZERO; mesh.positions.len()];
    for &t in &mesh.indices {
        let area = area_vector(mesh, t);
        for i in t {
            sums[i as usize] += area;
        }
    }
    for &i in &bad {
        mesh.normals[i] = sums[i].try_normalize().map_or(Vec3::Z, |n| n.as_vec3());
    }
    notes.warn(
        file,
        format!(
            "{} normals have no direction; made from the faces",
            bad.len()
        ),
    );
}

fn scale_materials(model: &mut Model, file: &Path, notes: &mut Notes) {
    for (material, name) in model.materials.iter_mut().zip(&model.material_names) {
        match &mut material.reflection {
            Reflection::BlinnPhong {
                diffuse, specular, ..
            } => {
                *diffuse = channels(*diffuse);
                *specular = channels(*specular);
                let largest = (*diffuse + *specular).max_element();
                if largest > 1.0 {
                    // A hair below 1, so that rounding does not lift the sum over it again.
                    let factor = (1.0 - 1e-6) / largest;
                    *diffuse *= factor;
                    *specular *= factor;
                    notes.note(
                        file,
                        format!(
                            "material `{name}` reflects {largest:.2} of the light; scaled down to 1"
                        ),
                    );
                }
            }
            Reflection::MetallicRoughness {
                base_color,
                metallic,
                roughness,
                ..
            } => {
                *base_color = channels(*base_color).min(Vec3::ONE);
                *metallic = metallic.clamp(0.0, 1.0);
                *roughness = roughness.clamp(0.0, 1.0);
            }
            Reflection::Unlit { color, .. } => *color = channels(*color),
        }
    }
}

/// A colour without negative or undefined channels.
fn channels(colour: Vec3) -> Vec3 {
    colour
        .to_array()
        .map(|c| if c > 0.0 { c } else { 0.0 })
        .into()
}
