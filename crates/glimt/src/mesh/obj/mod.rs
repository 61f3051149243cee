//! Host file: Wavefront OBJ meshes and their MTL materials.

mod build;
mod material;
mod mtl;
mod parse;

use super::model::{Model, Part, default_material, painted_material};
use super::node::Node;
use super::pictures::Pictures;
use super::{colors, contents, origin};
use crate::error::Result;
use crate::notes::Notes;
use build::{Built, build};
use glam::Vec3;
use glimt_render_gpu::prepare::scene::Opacity;
use parse::{NONE, Parsed, parse};
use std::collections::HashMap;
use std::path::{Path, PathBuf};

/// Reads an OBJ file, plain or packed by gzip, and the material libraries that it names. Normals that it lacks are made, by
/// `crease_deg` where it does not say how.
///
/// # Errors
/// It cannot be read, or is broken. What is missing of materials is a warning.
pub fn load(file: &Path, crease_deg: f32, notes: &mut Notes) -> Result<Model> {
    let bytes = contents::read(file)?;
    let mut parsed = parse(file, &bytes)?;
    drop(bytes);
    for (what, count) in &parsed.skipped {
        notes.note(file, format!("its {what} are left out ({count})"));
    }
    let name = file.file_name().unwrap_or_default().to_string_lossy();
    let mut model = Model {
        files: vec![file.to_owned()],
        nodes: vec![Node::at(&name, None, Vec3::ZERO)],
        parts: vec![Part {
            mesh: 0,
            node: 0,
            skin: None,
        }],
        origin: origin::of(&parsed.positions),
        ..Model::default()
    };
    let positions = origin::relative(&parsed.positions, model.origin, file, notes);
    let painted = match parsed.colors.is_empty() {
        true => None,
        false => Some(colors::decode(&mut parsed.colors, file, notes)),
    };
    let mut built = build(&mut parsed, &positions, crease_deg);
    if built.crossing > 0 {
        let what = format!("{} of its polygons cross themselves", built.crossing);
        notes.defect(file, &what, "cut as well as it goes")?;
    }
    give_materials(&parsed, &mut built, painted, &mut model, notes)?;
    built.mesh.name = name.into_owned();
    model.made_normals = built.normals;
    model.meshes.push(built.mesh);
    Ok(model)
}

/// Reads the materials that faces use, and makes the mesh's indices those of the model.
fn give_materials(
    parsed: &Parsed,
    built: &mut Built,
    painted: Option<Opacity>,
    model: &mut Model,
    notes: &mut Notes,
) -> Result<()> {
    let file = model.files[0].clone();
    let libraries = find_libraries(&file, &parsed.libraries, notes);
    let mut known = HashMap::new();
    for library in &libraries {
        let bytes = contents::read(library)?;
        for material in mtl::parse(library, &bytes, notes)? {
            // The first of a name counts, with whatever file it came.
            known
                .entry(material.name.clone())
                .or_insert((library, material));
        }
    }
    model.files.extend(libraries.iter().cloned());
    let is_used = |name: u32| built.mesh.materials.contains(&name);
    let mut index_of = vec![None; parsed.materials.len()];
    for (name, index) in (0..).zip(&mut index_of) {
        let text = &parsed.materials[name as usize];
        let Some((library, material)) = known.get(text) else {
            if is_used(name) {
                let what = match libraries.is_empty() {
                    true => format!(
                        "it uses material `{text}`, but has no material library; grey is used"
                    ),
                    false => {
                        format!("its material `{text}` is in none of its libraries; grey is used")
                    }
                };
                notes.warn(&file, what);
            }
            continue;
        };
        let mut pictures = Pictures::new(library, model, notes);
        let mut converted = material::convert(material, &mut pictures);
        if let Some(opacity @ Opacity::Blend { .. }) = painted
            && converted.opacity == Opacity::Opaque
        {
            converted.opacity = opacity;
        }
        let has_texture = converted.textures_mut().next().is_some();
        let bare = built.without_uv[name as usize];
        if has_texture && bare > 0 {
            let what = format!(
                "{bare} triangles of material `{text}` have no texture coordinates; they show one texel of its picture"
            );
            notes.warn(&file, what);
        }
        *index = Some(model.materials.len() as u32);
        model.materials.push(converted);
        model.material_names.push(text.clone());
    }
    let none = model.materials.len() as u32;
    let found = |name: u32| {
        index_of
            .get(name as usize)
            .copied()
            .flatten()
            .unwrap_or(none)
    };
    for material in &mut built.mesh.materials {
        *material = if *material == NONE {
            none
        } else {
            found(*material)
        };
    }
    if built.mesh.materials.contains(&none) {
        let (material, name) = match painted {
            Some(opacity) => (painted_material(opacity), "vertex colours"),
            None => (default_material(), "grey"),
        };
        model.materials.push(material);
        model.material_names.push(name.to_owned());
    }
    Ok(())
}

/// The files of `mtllib`: one, whose name may have spaces, or several.
fn find_libraries(file: &Path, names: &[String], notes: &mut Notes) -> Vec<PathBuf> {
    let folder = file.parent().unwrap_or(Path::new(""));
    let mut found = Vec::new();
    let mut missing = Vec::new();
    for line in names {
        if let Some(path) = contents::find(folder, line) {
            found.push(path);
            continue;
        }
        for name in line.split_whitespace() {
            match contents::find(folder, name) {
                Some(path) => found.push(path),
                None => missing.push(name),
            }
        }
    }
    for name in missing {
        let what = format!("its material library {name} is missing; grey is used");
        notes.warn(file, what);
    }
    let mut known = Vec::new();
    found.retain(|path| {
        let is_new = !known.contains(path);
        known.push(path.clone());
        is_new
    });
    found
}
