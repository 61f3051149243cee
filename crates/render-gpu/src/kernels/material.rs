//! Shared file: materials in a buffer, and the reflection model that they give at a point.

use glam::{Vec2, Vec3};
use glimt_brdf::BlinnPhong;

use super::scene::unit_or;
use super::texture::TextureView;

/// [`Material::kind`]: Blinn-Phong, by `diffuse`, `specular` and `exponent`.
pub const BLINN_PHONG: u32 = 0;
/// [`Material::kind`]: metallic-roughness, by `color`, `metallic`, `roughness` and the textures.
pub const METALLIC_ROUGHNESS: u32 = 1;

/// A material. 96 bytes.
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

impl Material {
    /// The reflection model at texture coordinates `uv`.
    #[inline]
    #[must_use]
    pub fn brdf(&self, texels: &[u32], uv: Vec2) -> BlinnPhong {
        if self.kind == BLINN_PHONG {
            return BlinnPhong {
                diffuse: self.color,
                specular: self.specular,
                exponent: self.exponent,
            };
        }
        let mut color = self.color;
        if self.base_color_texture.exists() {
            color *= self.base_color_texture.sample(texels, uv).truncate();
        }
        let mut metallic = self.metallic;
        let mut roughness = self.roughness;
        if self.metallic_roughness_texture.exists() {
            let factors = self.metallic_roughness_texture.sample(texels, uv);
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
    pub fn bumped_normal(
        &self,
        texels: &[u32],
        uv: Vec2,
        normal: Vec3,
        tangent: Vec3,
        handedness: f32,
    ) -> Vec3 {
        let across = tangent - normal * normal.dot(tangent);
        if !self.normal_texture.exists() || !(across.length_squared() > 1e-12) {
            return normal;
        }
        let t = across.normalize();
        let b = normal.cross(t) * handedness;
        let map = self.normal_texture.sample(texels, uv).truncate() * 2.0 - Vec3::ONE;
        let tilt = (t * map.x + b * map.y) * self.normal_scale;
        unit_or(tilt + normal * map.z, normal)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn layout_is_that_of_wgsl() {
        assert_eq!(core::mem::size_of::<Material>(), 96);
        assert_eq!(core::mem::offset_of!(Material, specular), 16);
        assert_eq!(core::mem::offset_of!(Material, metallic), 32);
        assert_eq!(core::mem::offset_of!(Material, base_color_texture), 48);
        assert_eq!(core::mem::offset_of!(Material, normal_texture), 80);
    }
}
