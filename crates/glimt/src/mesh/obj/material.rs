//! Host file: MTL materials as the renderer's.

use super::mtl::{Map, Mtl};
use crate::mesh::pictures::{Pictures, Use, is_normal_map};
use glam::{Affine2, Mat2, Vec2, Vec3};
use glimt_render_gpu::prepare::scene::{Alpha, Material, Opacity, Reflection, TextureRef, Wrap};
use image::imageops::{self, FilterType};

/// The renderer's material of an MTL's. `Kd`, `Ks` and `Ns` are its Blinn-Phong; with a picture, `Pr` or `Pm` it is the
/// metallic-roughness material nearest to them.
pub(super) fn convert(m: &Mtl, pictures: &mut Pictures<'_>) -> Material {
    say_what_is_unused(m, pictures);
    let reflection = reflection(m, pictures);
    let (emission, emission_texture) = emission(m, pictures);
    Material {
        reflection,
        emission,
        emission_texture,
        opacity: opacity(m, pictures),
    }
}

fn say_what_is_unused(m: &Mtl, pictures: &mut Pictures<'_>) {
    let mut list = m.unused.clone();
    match m.model {
        Some(0) => list.push("illum 0, a constant colour".to_owned()),
        Some(4 | 6 | 7 | 9) => {
            list.push("refraction (illum 4, 6, 7 or 9): light passes straight".to_owned())
        }
        _ => {}
    }
    if !list.is_empty() {
        let what = format!("material `{}`: not used are {}", m.name, list.join(", "));
        pictures.notes.warn(pictures.file, what);
    }
}

fn reflection(m: &Mtl, pictures: &mut Pictures<'_>) -> Reflection {
    let diffuse = m.diffuse.unwrap_or(Vec3::splat(0.6));
    // illum 0 and 1 have no highlights.
    let specular = match m.model {
        Some(0 | 1) => Vec3::ZERO,
        _ => m.specular.unwrap_or(Vec3::ZERO),
    };
    let exponent = m.exponent.unwrap_or(1.0).clamp(0.0, 1e4);
    let base_color_texture = texture(m.diffuse_map.as_ref(), Use::Colour, pictures);
    let metallic_roughness_texture = metallic_roughness(m, pictures);
    let (normal_texture, normal_scale) = normals(m, pictures);
    let textures = [
        &base_color_texture,
        &metallic_roughness_texture,
        &normal_texture,
    ];
    let is_physical = m.roughness.is_some() || m.metallic.is_some();
    if textures.iter().all(|t| t.is_none()) && !is_physical {
        return Reflection::BlinnPhong {
            diffuse,
            specular,
            exponent,
        };
    }
    if !is_physical && specular != Vec3::ZERO {
        let what = format!(
            "material `{}` has a picture; its specular colour is taken as 0.04",
            m.name
        );
        pictures.notes.note(pictures.file, what);
    }
    let is_black = base_color_texture.is_some() && diffuse == Vec3::ZERO;
    if is_black {
        let what = format!(
            "material `{}` has a picture and a black Kd, which is taken as white",
            m.name
        );
        pictures.notes.note(pictures.file, what);
    }
    // A map without its factor stands alone.
    let alone = |map: Option<&Map>| if map.is_some() { 1.0 } else { 0.0 };
    // e = 2/α² − 2, α = roughness².
    let by_exponent = (2.0 / (exponent + 2.0)).powf(0.25);
    let roughness = match m.roughness_map {
        Some(_) => 1.0,
        None => by_exponent,
    };
    Reflection::MetallicRoughness {
        base_color: match (is_black, base_color_texture.is_some()) {
            (true, _) => Vec3::ONE,
            (_, true) => m.diffuse.unwrap_or(Vec3::ONE),
            _ => diffuse,
        },
        metallic: m.metallic.unwrap_or(alone(m.metallic_map.as_ref())),
        roughness: m.roughness.unwrap_or(roughness),
        base_color_texture,
        metallic_roughness_texture,
        normal_texture,
        normal_scale,
    }
}

fn emission(m: &Mtl, pictures: &mut Pictures<'_>) -> (Vec3, Option<TextureRef>) {
    let picture = texture(m.emission_map.as_ref(), Use::Colour, pictures);
    let own = m.emission.unwrap_or(Vec3::ZERO).max(Vec3::ZERO);
    let emission = match picture.is_some() && own == Vec3::ZERO {
        true => Vec3::ONE,
        false => own,
    };
    if emission != Vec3::ZERO {
        let what = format!(
            "material `{}` glows: that is seen, but lights nothing else",
            m.name
        );
        pictures.notes.note(pictures.file, what);
    }
    (emission, picture)
}

fn opacity(m: &Mtl, pictures: &mut Pictures<'_>) -> Opacity {
    // Programs that write both mean the first.
    let through = m.transparency.map(|t| 1.0 - t);
    let factor = m.dissolve.or(through).unwrap_or(1.0).clamp(0.0, 1.0);
    let texture = match (&m.dissolve_map, &m.transparency_map) {
        (Some(map), _) => texture(Some(map), Use::Alpha, pictures),
        (None, map) => texture(map.as_ref(), Use::Transparency, pictures),
    };
    if factor == 0.0 {
        let what = format!(
            "material `{}` is fully transparent: nothing of it is seen; write `d 1` into the MTL file if that is a mistake",
            m.name
        );
        pictures.notes.warn(pictures.file, what);
    }
    match factor == 1.0 && texture.is_none() {
        true => Opacity::Opaque,
        false => Opacity::Blend {
            alpha: Alpha { factor, texture },
        },
    }
}

fn texture(map: Option<&Map>, usage: Use, pictures: &mut Pictures<'_>) -> Option<TextureRef> {
    let map = map?;
    let texture = pictures.texture(&map.file, usage, map.clamp)?;
    Some(placed(map, texture))
}

/// Where a map is looked up. Its v grows upwards, that of the renderer downwards.
fn placed(map: &Map, texture: u32) -> TextureRef {
    let shift = Vec2::new(map.offset.x, 1.0 - map.scale.y - map.offset.y);
    TextureRef {
        texture,
        transform: Affine2::from_mat2_translation(Mat2::from_diagonal(map.scale), shift),
    }
}

/// The normal map, and its strength: `norm`, or made of the heights of `bump`. Many programs write a normal map as `bump`.
fn normals(m: &Mtl, pictures: &mut Pictures<'_>) -> (Option<TextureRef>, f32) {
    if let Some(map) = &m.normal_map {
        return (texture(Some(map), Use::Data, pictures), map.bump);
    }
    let Some(map) = &m.bump_map else {
        return (None, 1.0);
    };
    let Some((_, picture)) = pictures.read(&map.file) else {
        return (None, 1.0);
    };
    if is_normal_map(&picture) {
        let what = format!(
            "the bump map of material `{}` is a normal map, and used as one",
            m.name
        );
        pictures.notes.note(pictures.file, what);
        return (texture(Some(map), Use::Data, pictures), map.bump);
    }
    let usage = Use::Heights(map.bump.to_bits());
    (texture(Some(map), usage, pictures), 1.0)
}

/// `map_Pr` as green and `map_Pm` as blue, in the size of the larger.
fn metallic_roughness(m: &Mtl, pictures: &mut Pictures<'_>) -> Option<TextureRef> {
    let map = m.roughness_map.as_ref().or(m.metallic_map.as_ref())?;
    let mut read = |map: &Option<Map>| {
        let (_, picture) = pictures.read(&map.as_ref()?.file)?;
        Some(picture)
    };
    let both = [read(&m.roughness_map), read(&m.metallic_map)];
    let sizes = both.iter().flatten().map(|picture| picture.dimensions());
    let (width, height) = sizes.max_by_key(|(w, h)| u64::from(*w) * u64::from(*h))?;
    let [rough, metal] = both.map(|picture| {
        picture.map(|picture| match picture.dimensions() == (width, height) {
            true => picture,
            false => imageops::resize(&picture, width, height, FilterType::Triangle),
        })
    });
    if let (Some(a), Some(b)) = (&m.roughness_map, &m.metallic_map)
        && (a.scale, a.offset, a.clamp) != (b.scale, b.offset, b.clamp)
    {
        let what = format!(
            "material `{}`: the options of map_Pr hold for map_Pm too",
            m.name
        );
        pictures.notes.warn(pictures.file, what);
    }
    let joined = image::RgbaImage::from_fn(width, height, |x, y| {
        let value = |picture: &Option<image::RgbaImage>| {
            picture.as_ref().map_or(255, |p| p.get_pixel(x, y).0[0])
        };
        image::Rgba([0, value(&rough), value(&metal), 255])
    });
    let wrap = if map.clamp { Wrap::Clamp } else { Wrap::Repeat };
    let texture = pictures.push(joined, false, wrap);
    Some(placed(map, texture))
}
