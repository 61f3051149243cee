//! Shared file: materials in the surface buffer, and the reflection model that they give at a point.
//!
//! The *surface buffer* of a scene holds all that its materials need, as words: the table that decodes sRGB
//! ([`SRGB_TABLE_LEN`] words), then the materials ([`MATERIAL_WORDS`] words each), then the texels of all textures, which
//! [`TextureView::first`] finds, then the [`Attributes`] of the triangles that have some.

use glam::{Vec2, Vec3, Vec4};
use glimt_brdf::BlinnPhong;

use super::scene::unit_or;
use super::texture::{SRGB_TABLE_LEN, TextureView};

/// Words of a [`Material`] in the surface buffer.
pub const MATERIAL_WORDS: usize = 76;

/// The word of a material at which [`Material::color`] begins.
const COLOR: usize = 0;
/// That of [`Material::kind`].
const KIND: usize = 3;
/// That of [`Material::specular`].
const SPECULAR: usize = 4;
/// That of [`Material::exponent`].
const EXPONENT: usize = 7;
/// That of [`Material::emission`].
const EMISSION: usize = 8;
/// That of [`Material::alpha`].
const ALPHA: usize = 11;
/// That of [`Material::metallic`].
const METALLIC: usize = 12;
/// That of [`Material::roughness`].
const ROUGHNESS: usize = 13;
/// That of [`Material::normal_scale`].
const NORMAL_SCALE: usize = 14;
/// That of [`Material::alpha_cutoff`].
const ALPHA_CUTOFF: usize = 15;
/// That of [`Material::color_texture`].
const COLOR_TEXTURE: usize = 16;
/// That of [`Material::metallic_roughness_texture`].
const METALLIC_ROUGHNESS_TEXTURE: usize = 28;
/// That of [`Material::normal_texture`].
const NORMAL_TEXTURE: usize = 40;
/// That of [`Material::emission_texture`].
const EMISSION_TEXTURE: usize = 52;
/// That of [`Material::alpha_texture`].
const ALPHA_TEXTURE: usize = 64;
/// The word of a [`TexturePlace`] at which its transform begins.
const TRANSFORM: usize = 4;

/// [`Material::kind`]: Blinn-Phong, by `color`, `specular` and `exponent`.
pub const BLINN_PHONG: u32 = 0;
/// [`Material::kind`]: metallic-roughness, by `color`, `metallic`, `roughness` and the textures.
pub const METALLIC_ROUGHNESS: u32 = 1;
/// [`Material::kind`]: reflects nothing, and shows `color` and its texture as radiance.
pub const UNLIT: u32 = 2;
/// Bit of [`Material::kind`] that says that it emits `emission`.
pub const EMITS: u32 = 1 << 31;

/// [`TextureView::flags`]: it is looked up at [`TexturePlace::transform`] of the coordinates.
pub const FLAG_TRANSFORMED: u32 = 1 << 16;

/// A texture, and where a material looks it up. 48 bytes.
#[derive(Clone, Copy, Debug, Default, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct TexturePlace {
    /// The texture; with [`FLAG_TRANSFORMED`] among its flags, `transform` applies.
    pub view: TextureView,
    /// The affine map of coordinates, column by column: `x' = t₀ u + t₂ v + t₄`, `y' = t₁ u + t₃ v + t₅`.
    pub transform: [f32; 6],
    /// Fills 16 bytes.
    pub unused: [u32; 2],
}

/// A material, as the host puts it into the surface buffer. 304 bytes.
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct Material {
    /// Diffuse albedo, base colour, or radiance.
    pub color: Vec3,
    /// [`BLINN_PHONG`], [`METALLIC_ROUGHNESS`] or [`UNLIT`], with the bit [`EMITS`].
    pub kind: u32,
    /// Specular albedo.
    pub specular: Vec3,
    /// Blinn-Phong exponent.
    pub exponent: f32,
    /// Radiance that it emits.
    pub emission: Vec3,
    /// Factor on alpha.
    pub alpha: f32,
    /// Metallic factor.
    pub metallic: f32,
    /// Roughness factor.
    pub roughness: f32,
    /// Factor on the normal map's x and y.
    pub normal_scale: f32,
    /// Alpha from which a mask is there; negative where alpha is a share.
    pub alpha_cutoff: f32,
    /// Multiplies the base colour, or radiance.
    pub color_texture: TexturePlace,
    /// Green multiplies roughness, blue multiplies metallic.
    pub metallic_roughness_texture: TexturePlace,
    /// Tangent-space normals.
    pub normal_texture: TexturePlace,
    /// Multiplies the emission.
    pub emission_texture: TexturePlace,
    /// Its alpha multiplies alpha.
    pub alpha_texture: TexturePlace,
}

/// Words of [`Attributes`] in the surface buffer for one corner of a triangle; three corners in a row.
pub const CORNER_WORDS: usize = 4;

/// What some triangles have at their corners beside a [`Corner`](super::scene::Corner), interpolated: texture coordinates again, so
/// that a ray that may pass needs no other buffer, and colours.
///
/// A corner has four words: u, v, and four whole numbers of 16 bits, the lower half first, that are 65 535 times red, green, blue and
/// alpha.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Attributes {
    /// Texture coordinates.
    pub uv: Vec2,
    /// Linear colour and alpha, in [0, 1].
    pub color: Vec4,
}

impl Attributes {
    /// Those of the triangle whose corners begin at word `first`, where its second and third corner have the weights u and v.
    #[inline]
    #[must_use]
    pub fn at(surface: &[u32], first: u32, u: f32, v: f32) -> Attributes {
        let a = Attributes::of_corner(surface, first as usize);
        let b = Attributes::of_corner(surface, first as usize + CORNER_WORDS);
        let c = Attributes::of_corner(surface, first as usize + 2 * CORNER_WORDS);
        let w = 1.0 - u - v;
        Attributes {
            uv: a.uv * w + b.uv * u + c.uv * v,
            color: a.color * w + b.color * u + c.color * v,
        }
    }

    #[inline]
    fn of_corner(surface: &[u32], first: usize) -> Attributes {
        let (low, high) = (surface[first + 2], surface[first + 3]);
        let color = Vec4::new(
            (low & 0xffff) as f32,
            (low >> 16) as f32,
            (high & 0xffff) as f32,
            (high >> 16) as f32,
        );
        Attributes {
            uv: Vec2::new(
                f32::from_bits(surface[first]),
                f32::from_bits(surface[first + 1]),
            ),
            color: color / 65_535.0,
        }
    }
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

    /// The value of the texture whose [`TexturePlace`] begins at `word`, at the mesh's coordinates `uv`.
    #[inline]
    fn sample(&self, word: usize, texture: TextureView, uv: Vec2) -> Vec4 {
        let mut place = uv;
        if texture.flags & FLAG_TRANSFORMED != 0 {
            let t = word + TRANSFORM;
            place = Vec2::new(self.number(t), self.number(t + 1)) * uv.x
                + Vec2::new(self.number(t + 2), self.number(t + 3)) * uv.y
                + Vec2::new(self.number(t + 4), self.number(t + 5));
        }
        texture.sample(self.surface, place)
    }

    /// [`Material::color`] times its texture's and the vertices' colour.
    #[inline]
    fn color(&self, uv: Vec2, vertex_color: Vec3) -> Vec3 {
        let color = self.vector(COLOR) * vertex_color;
        let texture = self.texture(COLOR_TEXTURE);
        if texture.exists() {
            return color * self.sample(COLOR_TEXTURE, texture, uv).truncate();
        }
        color
    }

    /// The reflection model at texture coordinates `uv`, where the vertices' colour is `vertex_color`.
    #[inline]
    #[must_use]
    pub fn brdf(&self, uv: Vec2, vertex_color: Vec3) -> BlinnPhong {
        let kind = self.words[KIND] & !EMITS;
        if kind == BLINN_PHONG {
            return BlinnPhong {
                diffuse: self.vector(COLOR) * vertex_color,
                specular: self.vector(SPECULAR),
                exponent: self.number(EXPONENT),
            };
        }
        if kind == UNLIT {
            return BlinnPhong {
                diffuse: Vec3::ZERO,
                specular: Vec3::ZERO,
                exponent: 0.0,
            };
        }
        let color = self.color(uv, vertex_color);
        let mut metallic = self.number(METALLIC);
        let mut roughness = self.number(ROUGHNESS);
        let texture = self.texture(METALLIC_ROUGHNESS_TEXTURE);
        if texture.exists() {
            let factors = self.sample(METALLIC_ROUGHNESS_TEXTURE, texture, uv);
            roughness *= factors.y;
            metallic *= factors.z;
        }
        BlinnPhong::from_metallic_roughness(color, metallic, roughness)
    }

    /// Radiance that the surface sends to all sides by itself.
    #[inline]
    #[must_use]
    pub fn emission(&self, uv: Vec2, vertex_color: Vec3) -> Vec3 {
        let mut radiance = Vec3::ZERO;
        if self.words[KIND] & EMITS != 0 {
            radiance = self.vector(EMISSION);
            let texture = self.texture(EMISSION_TEXTURE);
            if texture.exists() {
                radiance *= self.sample(EMISSION_TEXTURE, texture, uv).truncate();
            }
        }
        if self.words[KIND] & !EMITS == UNLIT {
            radiance += self.color(uv, vertex_color);
        }
        radiance
    }

    /// The share of light that the surface keeps away, where the vertices' alpha is `vertex_alpha`; of a mask 0 or 1.
    #[inline]
    #[must_use]
    pub fn alpha(&self, uv: Vec2, vertex_alpha: f32) -> f32 {
        let mut alpha = self.number(ALPHA) * vertex_alpha;
        let texture = self.texture(ALPHA_TEXTURE);
        if texture.exists() {
            alpha *= self.sample(ALPHA_TEXTURE, texture, uv).w;
        }
        let cutoff = self.number(ALPHA_CUTOFF);
        if cutoff < 0.0 {
            return alpha;
        }
        if alpha >= cutoff { 1.0 } else { 0.0 }
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
        let bump = self.sample(NORMAL_TEXTURE, map, uv).truncate() * 2.0 - Vec3::ONE;
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
            (EMISSION, offset_of!(Material, emission)),
            (ALPHA, offset_of!(Material, alpha)),
            (METALLIC, offset_of!(Material, metallic)),
            (ROUGHNESS, offset_of!(Material, roughness)),
            (NORMAL_SCALE, offset_of!(Material, normal_scale)),
            (ALPHA_CUTOFF, offset_of!(Material, alpha_cutoff)),
            (COLOR_TEXTURE, offset_of!(Material, color_texture)),
            (EMISSION_TEXTURE, offset_of!(Material, emission_texture)),
            (ALPHA_TEXTURE, offset_of!(Material, alpha_texture)),
            (
                METALLIC_ROUGHNESS_TEXTURE,
                offset_of!(Material, metallic_roughness_texture),
            ),
            (NORMAL_TEXTURE, offset_of!(Material, normal_texture)),
        ] {
            assert_eq!(4 * word, offset);
        }
        for (word, offset) in [
            (TRANSFORM, offset_of!(TexturePlace, transform)),
            (0, offset_of!(TextureView, first)),
            (1, offset_of!(TextureView, width)),
            (2, offset_of!(TextureView, height)),
            (3, offset_of!(TextureView, flags)),
        ] {
            assert_eq!(4 * word, offset);
        }
    }
}
