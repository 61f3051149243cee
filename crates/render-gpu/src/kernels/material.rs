//! Shared file: materials in the surface buffer, and the reflection model that they give at a point.
//!
//! The *surface buffer* of a scene holds all that its materials need, as words: the table that decodes sRGB
//! ([`SRGB_TABLE_LEN`] words), then the materials ([`MATERIAL_WORDS`] words each), then the texels of all textures, which
//! [`TextureView::first`] finds.

use glam::{Vec2, Vec3};
use glimt_brdf::BlinnPhong;

use super::scene::unit_or;
use super::texture::{SRGB_TABLE_LEN, TextureView};

/// Words of a [`Material`] in the surface buffer.
pub const MATERIAL_WORDS: usize = 24;

/// The word of a material at which [`Material::color`] begins.
const COLOR: usize = 0;
/// That of [`Material::kind`].
const KIND: usize = 3;
/// That of [`Material::specular`].
const SPECULAR: usize = 4;
/// That of [`Material::exponent`].
const EXPONENT: usize = 7;
/// That of [`Material::metallic`].
const METALLIC: usize = 8;
/// That of [`Material::roughness`].
const ROUGHNESS: usize = 9;
/// That of [`Material::normal_scale`].
const NORMAL_SCALE: usize = 10;
/// That of [`Material::base_color_texture`].
const BASE_COLOR_TEXTURE: usize = 12;
/// That of [`Material::metallic_roughness_texture`].
const METALLIC_ROUGHNESS_TEXTURE: usize = 16;
/// That of [`Material::normal_texture`].
const NORMAL_TEXTURE: usize = 20;

/// [`Material::kind`]: Blinn-Phong, by `diffuse`, `specular` and `exponent`.
pub const BLINN_PHONG: u32 = 0;
/// [`Material::kind`]: metallic-roughness, by `color`, `metallic`, `roughness` and the textures.
pub const METALLIC_ROUGHNESS: u32 = 1;

/// A material, as the host puts it into the surface buffer. 96 bytes.
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct Material {
    /// Diffuse albedo, or base colour.
    pub color: Vec3,
    /// [`BLINN_PHONG`] or [`METALLIC_ROUGHNESS`].
    pub kind: u32,
    /// Specular albedo.
    pub specular: Vec3,
    /// Blinn-Phong exponent.
    pub exponent: f32,
    /// Metallic factor.
    pub metallic: f32,
    /// Roughness factor.
    pub roughness: f32,
    /// Factor on the normal map's x and y.
    pub normal_scale: f32,
    /// Fills 16 bytes.
    pub unused: u32,
    /// Multiplies the base colour.
    pub base_color_texture: TextureView,
    /// Green multiplies roughness, blue multiplies metallic.
    pub metallic_roughness_texture: TextureView,
    /// Tangent-space normals.
    pub normal_texture: TextureView,
}

/// A material in the surface buffer. Its fields are read where they are needed.
#[derive(Clone, Copy, Debug)]
pub struct MaterialView<'a> {
    /// The surface buffer.
    surface: &'a [u32],
    /// The part of it that holds this material.
    words: &'a [u32],
}

impl<'a> MaterialView<'a> {
    /// The material of this index.
    #[inline]
    #[must_use]
    pub fn new(surface: &'a [u32], index: u32) -> MaterialView<'a> {
        let first = SRGB_TABLE_LEN as usize + index as usize * MATERIAL_WORDS;
        MaterialView {
            surface,
            words: &surface[first..first + MATERIAL_WORDS],
        }
    }

    #[inline]
    fn number(&self, word: usize) -> f32 {
        f32::from_bits(self.words[word])
    }

    #[inline]
    fn vector(&self, word: usize) -> Vec3 {
        Vec3::new(
            self.number(word),
            self.number(word + 1),
            self.number(word + 2),
        )
    }

    #[inline]
    fn texture(&self, word: usize) -> TextureView {
        TextureView {
            first: self.words[word],
            width: self.words[word + 1],
            height: self.words[word + 2],
            flags: self.words[word + 3],
        }
    }

    /// The reflection model at texture coordinates `uv`.
    #[inline]
    #[must_use]
    pub fn brdf(&self, uv: Vec2) -> BlinnPhong {
        let mut color = self.vector(COLOR);
        if self.words[KIND] == BLINN_PHONG {
            return BlinnPhong {
                diffuse: color,
                specular: self.vector(SPECULAR),
                exponent: self.number(EXPONENT),
            };
        }
        let base_color = self.texture(BASE_COLOR_TEXTURE);
        if base_color.exists() {
            color *= base_color.sample(self.surface, uv).truncate();
        }
        let mut metallic = self.number(METALLIC);
        let mut roughness = self.number(ROUGHNESS);
        let metallic_roughness = self.texture(METALLIC_ROUGHNESS_TEXTURE);
        if metallic_roughness.exists() {
            let factors = metallic_roughness.sample(self.surface, uv);
            roughness *= factors.y;
            metallic *= factors.z;
        }
        BlinnPhong::from_metallic_roughness(color, metallic, roughness)
    }

    /// The unit shading normal at texture coordinates `uv`, from the interpolated one (unit length) and tangent.
    ///
    /// Without a normal map, or where the tangent is parallel to the normal, it is the interpolated one.
    #[inline]
    #[must_use]
    pub fn bumped_normal(&self, uv: Vec2, normal: Vec3, tangent: Vec3, handedness: f32) -> Vec3 {
        let map = self.texture(NORMAL_TEXTURE);
        let across = tangent - normal * normal.dot(tangent);
        if !map.exists() || !(across.length_squared() > 1e-12) {
            return normal;
        }
        let t = across.normalize();
        let b = normal.cross(t) * handedness;
        let bump = map.sample(self.surface, uv).truncate() * 2.0 - Vec3::ONE;
        let tilt = (t * bump.x + b * bump.y) * self.number(NORMAL_SCALE);
        unit_or(tilt + normal * bump.z, normal)
    }
}

#[cfg(test)]
mod tests {
    use core::mem::offset_of;

    use super::*;

    #[test]
    fn words_are_those_of_the_struct() {
        assert_eq!(size_of::<Material>(), 4 * MATERIAL_WORDS);
        for (word, offset) in [
            (COLOR, offset_of!(Material, color)),
            (KIND, offset_of!(Material, kind)),
            (SPECULAR, offset_of!(Material, specular)),
            (EXPONENT, offset_of!(Material, exponent)),
            (METALLIC, offset_of!(Material, metallic)),
            (ROUGHNESS, offset_of!(Material, roughness)),
            (NORMAL_SCALE, offset_of!(Material, normal_scale)),
            (BASE_COLOR_TEXTURE, offset_of!(Material, base_color_texture)),
            (
                METALLIC_ROUGHNESS_TEXTURE,
                offset_of!(Material, metallic_roughness_texture),
            ),
            (NORMAL_TEXTURE, offset_of!(Material, normal_texture)),
        ] {
            assert_eq!(4 * word, offset);
        }
        for (word, offset) in [
            (0, offset_of!(TextureView, first)),
            (1, offset_of!(TextureView, width)),
            (2, offset_of!(TextureView, height)),
            (3, offset_of!(TextureView, flags)),
        ] {
            assert_eq!(4 * word, offset);
        }
    }
}
