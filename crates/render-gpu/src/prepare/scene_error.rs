//! Host file: why a scene was refused.

use glimt_brdf::MaterialError;

/// Why a scene was refused. Every index is into the lists of a [`SceneDescription`](super::scene::SceneDescription).
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SceneError {
    /// Nothing is left to be hit.
    #[error("the scene has no triangles (besides {dropped} without area)")]
    NoTriangles {
        /// Triangles that were dropped because they have no area.
        dropped: usize,
    },
    /// An object refers to something that there is not.
    #[error("object {object}: there is no {what} {index}")]
    Missing {
        /// The object.
        object: usize,
        /// What it refers to.
        what: &'static str,
        /// The index that it gives.
        index: u32,
    },
    /// An object's transform is not finite or cannot be inverted.
    #[error("object {object}: its transform flattens it, or is not finite")]
    Transform {
        /// The object.
        object: usize,
    },
    /// A vertex of an object lies, in the world, at a place that is not finite or beyond
    /// [`MAX_COORDINATE`](super::scene_build::MAX_COORDINATE).
    #[error("object {object}, mesh '{mesh}': vertex {vertex} is not finite, or beyond 1e9 units")]
    Position {
        /// The object.
        object: usize,
        /// Name of its mesh.
        mesh: String,
        /// The vertex.
        vertex: usize,
    },
    /// A triangle of a mesh refers to a vertex or material that there is not.
    #[error("mesh '{mesh}', triangle {triangle}: {what} {index} of {count}")]
    Index {
        /// Name of the mesh.
        mesh: String,
        /// The triangle.
        triangle: usize,
        /// What it refers to.
        what: &'static str,
        /// The index that it gives.
        index: u32,
        /// How many there are.
        count: usize,
    },
    /// A list of a mesh has the wrong length.
    #[error("mesh '{mesh}': {found} {what}, expected {expected}")]
    Length {
        /// Name of the mesh.
        mesh: String,
        /// What the list holds.
        what: &'static str,
        /// Its length.
        found: usize,
        /// The length that it must have.
        expected: usize,
    },
    /// A normal, texture coordinate or tangent of a mesh is not finite.
    #[error("mesh '{mesh}', vertex {vertex}: its {what} is not finite")]
    Attribute {
        /// Name of the mesh.
        mesh: String,
        /// What it is.
        what: &'static str,
        /// The vertex.
        vertex: usize,
    },
    /// A material's numbers are out of range.
    #[error("material {material}: {source}")]
    Material {
        /// The material.
        material: usize,
        /// What is wrong with it.
        source: MaterialError,
    },
    /// A factor of a metallic-roughness material is not a number, or negative.
    #[error("material {material}: its {what} is negative or not finite")]
    Factor {
        /// The material.
        material: usize,
        /// Which factor.
        what: &'static str,
    },
    /// A material refers to a texture that there is not.
    #[error("material {material}: there is no texture {texture}")]
    MissingTexture {
        /// The material.
        material: usize,
        /// The texture.
        texture: u32,
    },
    /// A texture is empty, or the number of its texels is not width × height.
    #[error("texture {texture}: {len} texels do not make {width} × {height}")]
    Texture {
        /// The texture.
        texture: usize,
        /// Its width.
        width: u32,
        /// Its height.
        height: u32,
        /// Its number of texels.
        len: usize,
    },
    /// A pose has another number of transforms than the scene has objects.
    #[error("a pose of {found} transforms for {expected} objects")]
    Pose {
        /// Its transforms.
        found: usize,
        /// The objects.
        expected: usize,
    },
    /// The scene outgrows 32-bit indices.
    #[error("the scene has too many {what} for 32-bit indices")]
    TooLarge {
        /// Of what.
        what: &'static str,
    },
}
