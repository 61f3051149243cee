//! Host file: materials and textures, checked and packed into the surface buffer.

use glam::{Affine2, UVec2, Vec2, Vec3, Vec4};
use glimt_brdf::BlinnPhong;

use super::scene::{Material, Mesh, Opacity, Reflection, Texture, TextureRef, Wrap};
use super::scene_error::SceneError;
use crate::kernels::material::{
    self as kernel, BLINN_PHONG, CORNER_WORDS, EMITS, FLAG_TRANSFORMED, MATERIAL_WORDS,
    METALLIC_ROUGHNESS, TexturePlace, UNLIT,
};
use crate::kernels::texture::{
    FLAG_SRGB, SRGB_TABLE_LEN, TextureView, WRAP_CLAMP, WRAP_MIRROR, WRAP_REPEAT, WRAP_SHIFT,
};

/// Words of the attributes of a face.
pub(super) const FACE_WORDS: usize = 3 * CORNER_WORDS;

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

/// Whether light may pass a material somewhere, as far as vertex colours do not matter.
pub(super) fn may_pass(material: &Material, textures: &[Texture]) -> bool {
    let (least, alpha) = match material.opacity {
        Opacity::Opaque => return false,
        Opacity::Mask { cutoff, alpha } => (cutoff, alpha),
        Opacity::Blend { alpha } => (1.0, alpha),
    };
    let texture = alpha.texture.and_then(|t| textures.get(t.texture as usize));
    // Many files say that opaque pictures are see-through.
    let thinnest = texture.map_or(u8::MAX, |texture| {
        let alphas = texture.texels.iter().map(|texel| texel[3]);
        alphas.min().unwrap_or(u8::MAX)
    });
    alpha.factor * (f32::from(thinnest) / 255.0) < least
}

/// A factor that must be finite and not negative.
fn factor(material: usize, what: &'static str, value: f32) -> Result<f32, SceneError> {
    if value >= 0.0 && value <= f32::MAX {
        Ok(value)
    } else {
        Err(SceneError::Factor { material, what })
    }
}

/// A colour of which each channel is such a factor.
fn color(material: usize, what: &'static str, value: Vec3) -> Result<Vec3, SceneError> {
    for channel in value.to_array() {
        factor(material, what, channel)?;
    }
    Ok(value)
}

/// A material as kernels read it.
fn pack_material(
    index: usize,
    material: &Material,
    textures: &[TextureView],
) -> Result<kernel::Material, SceneError> {
    let place = |texture: Option<TextureRef>| match texture {
        None => Ok(TexturePlace::default()),
        Some(TextureRef { texture, transform }) => {
            let view = textures.get(texture as usize);
            let mut view = *view.ok_or(SceneError::MissingTexture {
                material: index,
                texture,
            })?;
            if !transform.is_finite() {
                let what = "transform of texture coordinates";
                return Err(SceneError::Factor {
                    material: index,
                    what,
                });
            }
            if transform != Affine2::IDENTITY {
                view.flags |= FLAG_TRANSFORMED;
            }
            Ok(TexturePlace {
                view,
                transform: transform.to_cols_array(),
                unused: [0; 2],
            })
        }
    };
    let factor = |what, value| factor(index, what, value);
    let color = |what, value| color(index, what, value);
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
            packed.kind = METALLIC_ROUGHNESS;
            packed.color = color("base colour", base_color)?;
            packed.metallic = factor("metallic factor", metallic)?;
            packed.roughness = factor("roughness factor", roughness)?;
            packed.normal_scale = factor("normal scale", normal_scale)?;
            packed.color_texture = place(base_color_texture)?;
            packed.metallic_roughness_texture = place(metallic_roughness_texture)?;
            packed.normal_texture = place(normal_texture)?;
        }
        Reflection::Unlit {
            color: radiance,
            color_texture,
        } => {
            packed.kind = UNLIT;
            packed.color = color("colour", radiance)?;
            packed.color_texture = place(color_texture)?;
        }
    }
    if material.emission != Vec3::ZERO {
        packed.kind |= EMITS;
        packed.emission = color("emission", material.emission)?;
        packed.emission_texture = place(material.emission_texture)?;
    }
    let (alpha, cutoff) = match material.opacity {
        Opacity::Opaque => return Ok(packed),
        Opacity::Mask { cutoff, alpha } => (alpha, factor("alpha cutoff", cutoff)?),
        Opacity::Blend { alpha } => (alpha, -1.0),
    };
    packed.alpha = factor("alpha", alpha.factor)?;
    packed.alpha_cutoff = cutoff;
    packed.alpha_texture = place(alpha.texture)?;
    Ok(packed)
}

/// Appends the kernels' [`Attributes`](kernel::Attributes) of all faces of a mesh to the surface buffer. Returns the word at which those
/// of the first face begin.
pub(super) fn append_attributes(words: &mut Vec<u32>, mesh: &Mesh) -> Result<u32, SceneError> {
    let first = words.len();
    let added = mesh.indices.len() * FACE_WORDS;
    // The last word, too, must have a number.
    if first + added > u32::MAX as usize {
        let what = "vertex colours";
        return Err(SceneError::TooLarge { what });
    }
    words.reserve_exact(added);
    let of_vertex = |&vertex: &u32| {
        let uv = mesh.uvs.get(vertex as usize).copied().unwrap_or(Vec2::ZERO);
        let color = mesh.colors.get(vertex as usize).copied();
        let color = color.unwrap_or(Vec4::ONE).clamp(Vec4::ZERO, Vec4::ONE);
        let [r, g, b, a] = color.to_array().map(|c| (c * 65_535.0).round() as u32);
        [uv.x.to_bits(), uv.y.to_bits(), r | g << 16, b | a << 16]
    };
    words.extend(mesh.indices.as_flattened().iter().flat_map(of_vertex));
    Ok(first as u32)
}
