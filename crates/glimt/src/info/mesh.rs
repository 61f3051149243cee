//! Host file: what a mesh file holds.

use crate::error::Result;
use crate::mesh;
use crate::mesh::model::Model;
use crate::mesh::node::names;
use crate::notes::Notes;
use crate::report::shown;
use crate::shot::CREASE_DEG;
use glam::{DVec3, Mat4, Vec3};
use glimt_render_gpu::prepare::scene::{Material, Opacity, Reflection};
use serde_json::{Value, json};
use std::path::Path;

pub(super) fn describe(file: &Path, notes: &mut Notes) -> Result<(Value, String)> {
    let model = mesh::load(Path::new(""), &file.to_string_lossy(), CREASE_DEG, notes)?;
    let vertices: usize = model.meshes.iter().map(|m| m.positions.len()).sum();
    let (low, high) = model
        .bounds(&model.rest(), Mat4::IDENTITY)
        .unwrap_or_default();

    let mut lines = Vec::new();
    let mut line = |name: &str, text: String| lines.push(format!("{name:<12}{text}"));
    line("triangles", model.triangles().to_string());
    line("vertices", vertices.to_string());
    line(
        "meshes",
        format!("{}, placed {} times", model.meshes.len(), model.parts.len()),
    );
    line(
        "bounds",
        format!("{} to {} (the file's axes)", point(low), point(high)),
    );
    if model.origin != DVec3::ZERO {
        let DVec3 { x, y, z } = model.origin;
        line(
            "origin",
            format!("({x}, {y}, {z}): bounds are relative to it"),
        );
    }
    line("normals", normals(&model));
    line("uvs", share(&model, |m| !m.uvs.is_empty()));
    line("colours", share(&model, |m| !m.colors.is_empty()));
    for (material, name) in model.materials.iter().zip(&model.material_names) {
        line(
            "material",
            format!("{name}: {}", describe_material(material)),
        );
    }
    for (i, texture) in model.textures.iter().enumerate() {
        let kind = if texture.srgb { "colour" } else { "data" };
        line(
            "texture",
            format!("{i}: {} × {}, {kind}", texture.size.x, texture.size.y),
        );
    }
    for camera in &model.cameras {
        let fov = camera.fov_y.to_degrees();
        line("camera", format!("{}: {fov:.1}° high", camera.name));
    }
    for name in names(&model.nodes) {
        line("node", name.to_owned());
    }
    for (mesh, deform) in &model.deforms {
        let (name, targets) = (&model.meshes[*mesh].name, deform.targets.len());
        if targets > 0 {
            line("morph", format!("{name}: {targets} targets"));
        }
    }
    for skin in &model.skins {
        line(
            "skin",
            format!("{}: {} joints", skin.name, skin.joints.len()),
        );
    }
    for animation in &model.animations {
        let (seconds, channels) = (animation.duration_s(), animation.channels.len());
        line(
            "animation",
            format!("{}: {seconds} s, {channels} channels", animation.name),
        );
    }
    let skins = model.skins.iter();
    let skins: Vec<Value> = skins
        .map(|skin| json!({"name": skin.name, "joints": skin.joints.len()}))
        .collect();
    let morphs = model.deforms.iter();
    let morphs: Vec<Value> = morphs
        .filter(|(_, deform)| !deform.targets.is_empty())
        .map(|(mesh, deform)| {
            json!({"mesh": model.meshes[*mesh].name, "targets": deform.targets.len()})
        })
        .collect();
    let cameras: Vec<&str> = model.cameras.iter().map(|c| c.name.as_str()).collect();
    let animations: Vec<Value> = model
        .animations
        .iter()
        .map(|a| json!({"name": a.name, "duration_s": a.duration_s()}))
        .collect();
    let alpha: Vec<&str> = model
        .materials
        .iter()
        .map(|material| match material.opacity {
            Opacity::Opaque => "opaque",
            Opacity::Mask { .. } => "mask",
            Opacity::Blend { .. } => "blend",
        })
        .collect();
    let files: Vec<String> = model.files.iter().map(|file| shown(file)).collect();
    let value = json!({
        "file": shown(file), "kind": "mesh", "triangles": model.triangles(), "vertices": vertices,
        "meshes": model.meshes.len(), "parts": model.parts.len(),
        "bounds": [low.to_array(), high.to_array()], "materials": model.material_names,
        "textures": model.textures.len(), "cameras": cameras, "nodes": names(&model.nodes), "animations": animations,
        "files": files, "origin": model.origin.to_array(), "alpha": alpha, "skins": skins, "morphs": morphs,
        "colours": model.meshes.iter().filter(|mesh| !mesh.colors.is_empty()).count(),
        "normals": {"flat": model.made_normals.flat, "grouped": model.made_normals.grouped,
            "creased": model.made_normals.creased},
    });
    Ok((value, lines.join("\n")))
}

/// Where normals come from, in words.
fn normals(model: &Model) -> String {
    let made = model.made_normals;
    let total: usize = model.meshes.iter().map(|mesh| mesh.indices.len()).sum();
    let given = total.saturating_sub(made.flat + made.grouped + made.creased);
    let sources = [
        ("the file's", given),
        ("flat", made.flat),
        ("smooth within its groups", made.grouped),
        ("by the crease angle", made.creased),
    ];
    let used = sources.iter().filter(|(_, count)| *count > 0);
    match *used.clone().collect::<Vec<_>>() {
        [(name, _)] => (*name).to_owned(),
        _ => used
            .map(|(name, count)| format!("{name} ({count} triangles)"))
            .collect::<Vec<_>>()
            .join(", "),
    }
}

fn share(model: &Model, has: fn(&glimt_render_gpu::prepare::scene::Mesh) -> bool) -> String {
    match model.meshes.iter().filter(|m| has(m)).count() {
        0 => "none".to_owned(),
        n if n == model.meshes.len() => "all meshes".to_owned(),
        n => format!("{n} of {} meshes", model.meshes.len()),
    }
}

fn point(p: Vec3) -> String {
    format!("({}, {}, {})", p.x, p.y, p.z)
}

fn colour(c: Vec3) -> String {
    format!("({:.3}, {:.3}, {:.3})", c.x, c.y, c.z)
}

fn describe_material(material: &Material) -> String {
    let mut text = describe_reflection(&material.reflection);
    if material.emission != Vec3::ZERO {
        text.push_str(&format!(", emits {}", colour(material.emission)));
        if let Some(texture) = material.emission_texture {
            text.push_str(&format!(" by texture {}", texture.texture));
        }
    }
    let (mode, alpha) = match &material.opacity {
        Opacity::Opaque => return text,
        Opacity::Mask { cutoff, alpha } => (format!("cut out below {cutoff}"), alpha),
        Opacity::Blend { alpha } => ("see-through".to_owned(), alpha),
    };
    text.push_str(&format!(", {mode}, alpha {:.3}", alpha.factor));
    if let Some(texture) = alpha.texture {
        text.push_str(&format!(" by texture {}", texture.texture));
    }
    text
}

fn describe_reflection(reflection: &Reflection) -> String {
    match reflection {
        Reflection::BlinnPhong {
            diffuse,
            specular,
            exponent,
        } => format!(
            "diffuse {}, specular {}, exponent {exponent}",
            colour(*diffuse),
            colour(*specular)
        ),
        Reflection::MetallicRoughness {
            base_color,
            metallic,
            roughness,
            base_color_texture,
            metallic_roughness_texture,
            normal_texture,
            ..
        } => {
            let mut text = format!(
                "base colour {}, metallic {metallic:.2}, roughness {roughness:.2}",
                colour(*base_color)
            );
            let textures = [
                ("base colour", base_color_texture),
                ("metallic-roughness", metallic_roughness_texture),
                ("normal", normal_texture),
            ];
            for (name, texture) in textures {
                if let Some(texture) = texture {
                    text.push_str(&format!(", {name} texture {}", texture.texture));
                }
            }
            text
        }
        Reflection::Unlit {
            color,
            color_texture,
        } => {
            let mut text = format!("unlit, colour {}", colour(*color));
            if let Some(texture) = color_texture {
                text.push_str(&format!(", texture {}", texture.texture));
            }
            text
        }
    }
}
