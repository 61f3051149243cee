//! Host file: the scene as a program describes it, before it is flattened into the kernels' buffers.
//!
//! World axes are right-handed with z up; lengths have no unit of their own, only the same one everywhere.

use glam::{Mat4, UVec2, Vec2, Vec3, Vec4};

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
    /// Corners of each triangle, counter-clockwise seen from outside.
    pub indices: Vec<[u32; 3]>,
    /// Material of each triangle; or of length one, for the whole mesh.
    pub materials: Vec<u32>,
}

/// How a surface reflects. All colours are linear, with Rec. 709 primaries, in [0, 1].
#[derive(Clone, Debug)]
pub enum Material {
    /// `ρ = kd/π + ks · c(e) · (n·h)^e`, of which `kd + ks ≤ 1` in each channel.
    BlinnPhong {
        /// Diffuse albedo kd.
        diffuse: Vec3,
        /// Specular albedo ks at normal incidence.
        specular: Vec3,
        /// Exponent e, 0 to 10⁴.
        exponent: f32,
    },
    /// glTF's metallic-roughness parameters, mapped to Blinn-Phong after its textures are read.
    MetallicRoughness {
        /// Base colour factor.
        base_color: Vec3,
        /// Metallic factor, 0 to 1.
        metallic: f32,
        /// Roughness factor, 0 to 1; acts as 0.12 below that.
        roughness: f32,
        /// Texture that multiplies `base_color`.
        base_color_texture: Option<u32>,
        /// Texture of which green multiplies `roughness` and blue multiplies `metallic`.
        metallic_roughness_texture: Option<u32>,
        /// Tangent-space normal map.
        normal_texture: Option<u32>,
        /// Factor on the normal map's x and y.
        normal_scale: f32,
    },
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
