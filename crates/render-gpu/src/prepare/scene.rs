//! Host file: the scene as a program describes it, before it is flattened into the kernels' buffers.
//!
//! World axes are right-handed with z up; lengths have no unit of their own, only the same one everywhere.

use glam::{Affine2, Mat4, UVec2, Vec2, Vec3, Vec4};

/// Meshes, materials and textures, and the objects that place them in the world. Every index below is into these lists.
#[derive(Clone, Debug, Default)]
pub struct SceneDescription {
    /// Geometry, each in its own coordinates.
    pub meshes: Vec<Mesh>,
    /// Reflection models.
    pub materials: Vec<Material>,
    /// Images that the materials refer to.
    pub textures: Vec<Texture>,
    /// What stands in the world.
    pub objects: Vec<Object>,
}

/// An indexed triangle mesh.
#[derive(Clone, Debug, Default)]
pub struct Mesh {
    /// Name for messages, such as the file it came from.
    pub name: String,
    /// Corners.
    pub positions: Vec<Vec3>,
    /// Shading normals, one for each position and of any length but zero; or empty, and they are made as the
    /// area-weighted mean of the faces around each position.
    pub normals: Vec<Vec3>,
    /// Texture coordinates, one for each position, with v = 0 at the image's first row; or empty.
    pub uvs: Vec<Vec2>,
    /// Tangents (xyz along growing u, w = ±1 the sign of the bitangent `w n × t`), one for each position; or empty, and
    /// they are made from `uvs` where a material has a normal map.
    pub tangents: Vec<Vec4>,
    /// Linear colour and alpha, one for each position, in [0, 1]; they multiply those of the material. Or empty.
    pub colors: Vec<Vec4>,
    /// Corners of each triangle, counter-clockwise seen from outside.
    pub indices: Vec<[u32; 3]>,
    /// Material of each triangle; or of length one, for the whole mesh.
    pub materials: Vec<u32>,
}

/// What a surface is made of. All colours are linear, in the scene's primaries (Rec. 709 by default).
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// How it reflects.
    pub reflection: Reflection,
    /// Radiance that it emits towards all sides; seen, but it does not light other surfaces. Not negative.
    pub emission: Vec3,
    /// Texture that multiplies `emission`.
    pub emission_texture: Option<TextureRef>,
    /// What it lets pass.
    pub opacity: Opacity,
}

/// How a surface reflects; colours in [0, 1].
#[derive(Clone, Debug, PartialEq)]
pub enum Reflection {
    /// `ρ = kd/π + ks · c(e) · (n·h)^e`, of which `kd + ks ≤ 1` in each channel.
    BlinnPhong {
        /// Diffuse albedo kd; vertex colours multiply it.
        diffuse: Vec3,
        /// Specular albedo ks at normal incidence.
        specular: Vec3,
        /// Exponent e, 0 to 10⁴.
        exponent: f32,
    },
    /// glTF's metallic-roughness parameters, mapped to Blinn-Phong after its textures are read.
    MetallicRoughness {
        /// Base colour factor; vertex colours multiply it.
        base_color: Vec3,
        /// Metallic factor, 0 to 1.
        metallic: f32,
        /// Roughness factor, 0 to 1; acts as 0.12 below that.
        roughness: f32,
        /// Texture that multiplies `base_color`.
        base_color_texture: Option<TextureRef>,
        /// Texture of which green multiplies `roughness` and blue multiplies `metallic`.
        metallic_roughness_texture: Option<TextureRef>,
        /// Tangent-space normal map.
        normal_texture: Option<TextureRef>,
        /// Factor on the normal map's x and y.
        normal_scale: f32,
    },
    /// It reflects nothing, and shows its own colour as radiance, in any light (glTF's `KHR_materials_unlit`).
    Unlit {
        /// Radiance; vertex colours multiply it.
        color: Vec3,
        /// Texture that multiplies `color`.
        color_texture: Option<TextureRef>,
    },
}

/// What a surface lets pass, along rays of the camera and of shadows.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Opacity {
    /// Nothing.
    #[default]
    Opaque,
    /// All where its alpha is below `cutoff`, elsewhere nothing.
    Mask {
        /// See above.
        cutoff: f32,
        /// See [`Alpha`].
        alpha: Alpha,
    },
    /// The share `1 − alpha`. Nothing is refracted or tinted.
    Blend {
        /// See [`Alpha`].
        alpha: Alpha,
    },
}

/// Alpha of a surface: `factor` times the alpha of `texture`, times that of the vertex colours.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Alpha {
    /// In [0, 1].
    pub factor: f32,
    /// Texture of which the alpha channel is taken.
    pub texture: Option<TextureRef>,
}

/// A texture, and where it is looked up: at `transform` of a mesh's texture coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TextureRef {
    /// Index of the texture.
    pub texture: u32,
    /// From the mesh's coordinates to those of the lookup (glTF's `KHR_texture_transform`).
    pub transform: Affine2,
}

impl From<u32> for TextureRef {
    /// The texture at the mesh's own coordinates.
    fn from(texture: u32) -> Self {
        Self {
            texture,
            transform: Affine2::IDENTITY,
        }
    }
}

impl From<Reflection> for Material {
    /// An opaque material that emits nothing.
    fn from(reflection: Reflection) -> Self {
        Self {
            reflection,
            emission: Vec3::ZERO,
            emission_texture: None,
            opacity: Opacity::Opaque,
        }
    }
}

impl Material {
    /// All references to textures.
    pub fn textures_mut(&mut self) -> impl Iterator<Item = &mut TextureRef> {
        let reflected = match &mut self.reflection {
            Reflection::BlinnPhong { .. } => [None, None, None],
            Reflection::MetallicRoughness {
                base_color_texture,
                metallic_roughness_texture,
                normal_texture,
                ..
            } => [
                base_color_texture.as_mut(),
                metallic_roughness_texture.as_mut(),
                normal_texture.as_mut(),
            ],
            Reflection::Unlit { color_texture, .. } => [color_texture.as_mut(), None, None],
        };
        let alpha = match &mut self.opacity {
            Opacity::Opaque => None,
            Opacity::Mask { alpha, .. } | Opacity::Blend { alpha } => alpha.texture.as_mut(),
        };
        let others = [self.emission_texture.as_mut(), alpha];
        reflected.into_iter().chain(others).flatten()
    }
}

/// An 8-bit RGBA image, rows from the top.
#[derive(Clone, Debug)]
pub struct Texture {
    /// Width and height in texels, both at least one.
    pub size: UVec2,
    /// `size.x * size.y` texels.
    pub texels: Vec<[u8; 4]>,
    /// Whether red, green and blue are sRGB-encoded (a colour) or linear (data).
    pub srgb: bool,
    /// What lies beyond the edges, along u and v.
    pub wrap: [Wrap; 2],
}

/// What a texture shows beyond its edge.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Wrap {
    /// The image again.
    #[default]
    Repeat,
    /// The image mirrored at every second repetition.
    Mirror,
    /// The edge's texel.
    Clamp,
}

/// A mesh placed in the world.
#[derive(Clone, Debug)]
pub struct Object {
    /// Index of the mesh.
    pub mesh: u32,
    /// From the mesh's coordinates to the world's: an affine map that can be inverted (scale, then rotation, then
    /// translation).
    pub transform: Mat4,
    /// A material for all of the mesh in place of its own.
    pub material: Option<u32>,
    /// Whether it stands for something that is in the footage already. It takes the objects' shadows and hides what is behind
    /// it, but blocks no light.
    pub catcher: bool,
}

/// The vertices of an object's mesh in a pose, in the mesh's coordinates.
#[derive(Clone, Debug, PartialEq)]
pub struct Shape {
    /// Index of the object.
    pub object: usize,
    /// As many as the mesh has.
    pub positions: Vec<Vec3>,
    /// As many; or empty, and they are made as those of a [`Mesh`].
    pub normals: Vec<Vec3>,
    /// As many; or empty, and they are made as those of a [`Mesh`].
    pub tangents: Vec<Vec4>,
}

/// A pinhole camera.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// Centre of projection.
    pub eye: Vec3,
    /// A point that the image's centre shows; differs from `eye`.
    pub target: Vec3,
    /// A direction that is up in the image; not parallel to the line of sight.
    pub up: Vec3,
    /// Horizontal field of view in radians, in (0, π).
    pub fov_x: f32,
}
