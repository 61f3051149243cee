//! Host file: materials and textures, checked and packed into the surface buffer.

use glam::UVec2;
use glimt_brdf::BlinnPhong;

use super::scene::{Material, Reflection, Texture, TextureRef, Wrap};
use super::scene_error::SceneError;
use crate::kernels::material::{self as kernel, BLINN_PHONG, MATERIAL_WORDS, METALLIC_ROUGHNESS};
use crate::kernels::texture::{
    FLAG_SRGB, SRGB_TABLE_LEN, TextureView, WRAP_CLAMP, WRAP_MIRROR, WRAP_REPEAT, WRAP_SHIFT,
};

/// The surface buffer of a scene with these materials and textures.
pub(super) fn pack_surface(
    materials: &[Material],
    textures: &[Texture],
) -> Result<Vec<u32>, SceneError> {
    let texels: usize = textures.iter().map(|texture| texture.texels.len()).sum();
    let first_material = SRGB_TABLE_LEN as usize;
    let first_texel = first_material + materials.len() * MATERIAL_WORDS;
    let mut words = Vec::with_capacity(first_texel + texels);
    words.extend((0..SRGB_TABLE_LEN).map(|code| srgb_decode(code).to_bits()));
    words.resize(first_texel, 0);
    let views = append_textures(&mut words, textures)?;
    let places = words[first_material..first_texel].chunks_exact_mut(MATERIAL_WORDS);
    for (index, (material, place)) in materials.iter().zip(places).enumerate() {
        let packed = pack_material(index, material, &views)?;
        place.copy_from_slice(bytemuck::cast_slice(&[packed]));
    }
    Ok(words)
}

/// Puts the texels of all textures behind the words that are there. Says where each texture lies.
fn append_textures(
    words: &mut Vec<u32>,
    textures: &[Texture],
) -> Result<Vec<TextureView>, SceneError> {
    let mut views = Vec::with_capacity(textures.len());
    for (index, texture) in textures.iter().enumerate() {
        let UVec2 {
            x: width,
            y: height,
        } = texture.size;
        let len = texture.texels.len();
        if len == 0 || len as u64 != u64::from(width) * u64::from(height) {
            return Err(SceneError::Texture {
                texture: index,
                width,
                height,
                len,
            });
        }
        let first = u32::try_from(words.len())
            .ok()
            .filter(|first| first.checked_add(len as u32).is_some());
        let first = first.ok_or(SceneError::TooLarge { what: "texels" })?;
        let wrap = wrap_code(texture.wrap[0]) | wrap_code(texture.wrap[1]) << 2;
        let flags = wrap << WRAP_SHIFT | if texture.srgb { FLAG_SRGB } else { 0 };
        words.extend(
            texture
                .texels
                .iter()
                .map(|&texel| u32::from_le_bytes(texel)),
        );
        views.push(TextureView {
            first,
            width,
            height,
            flags,
        });
    }
    Ok(views)
}

fn wrap_code(wrap: Wrap) -> u32 {
    match wrap {
        Wrap::Repeat => WRAP_REPEAT,
        Wrap::Mirror => WRAP_MIRROR,
        Wrap::Clamp => WRAP_CLAMP,
    }
}

/// Linear value of an 8-bit sRGB code (IEC 61966-2-1).
fn srgb_decode(code: u32) -> f32 {
    let encoded = f64::from(code) / 255.0;
    let linear = if encoded <= 0.040_45 {
        encoded / 12.92
    } else {
        ((encoded + 0.055) / 1.055).powf(2.4)
    };
    linear as f32
}

/// A material as kernels read it.
fn pack_material(
    index: usize,
    material: &Material,
    textures: &[TextureView],
) -> Result<kernel::Material, SceneError> {
    let view = |texture: Option<TextureRef>| match texture {
        None => Ok(TextureView::default()),
        Some(TextureRef { texture, .. }) => {
            textures
                .get(texture as usize)
                .copied()
                .ok_or(SceneError::MissingTexture {
                    material: index,
                    texture,
                })
        }
    };
    let factor = |what, value: f32| {
        if value >= 0.0 && value <= f32::MAX {
            Ok(value)
        } else {
            Err(SceneError::Factor {
                material: index,
                what,
            })
        }
    };
    let mut packed: kernel::Material = bytemuck::Zeroable::zeroed();
    match material.reflection {
        Reflection::BlinnPhong {
            diffuse,
            specular,
            exponent,
        } => {
            let brdf = BlinnPhong::new(diffuse, specular, exponent).map_err(|source| {
                SceneError::Material {
                    material: index,
                    source,
                }
            })?;
            packed.kind = BLINN_PHONG;
            packed.color = brdf.diffuse;
            packed.specular = brdf.specular;
            packed.exponent = brdf.exponent;
        }
        Reflection::MetallicRoughness {
            base_color,
            metallic,
            roughness,
            base_color_texture,
            metallic_roughness_texture,
            normal_texture,
            normal_scale,
        } => {
            for channel in base_color.to_array() {
                factor("base colour", channel)?;
            }
            packed.kind = METALLIC_ROUGHNESS;
            packed.color = base_color;
            packed.metallic = factor("metallic factor", metallic)?;
            packed.roughness = factor("roughness factor", roughness)?;
            packed.normal_scale = factor("normal scale", normal_scale)?;
            packed.base_color_texture = view(base_color_texture)?;
            packed.metallic_roughness_texture = view(metallic_roughness_texture)?;
            packed.normal_texture = view(normal_texture)?;
        }
        Reflection::Unlit { .. } => {}
    }
    Ok(packed)
}
