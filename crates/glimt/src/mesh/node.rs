//! Host file: the nodes of a mesh file: named places, each within another.

use glam::{Mat4, Quat, Vec3};
use std::collections::HashSet;

/// A place in a file, at which meshes, cameras and other nodes stand.
#[derive(Clone, Debug, PartialEq)]
pub struct Node {
    /// Its name; empty if it has none.
    pub name: String,
    /// The node that it stands in, which comes before it in the list.
    pub parent: Option<usize>,
    /// To its parent, or to the file's world, as the file has it.
    pub local: Mat4,
    /// The same in parts, which animations replace.
    pub parts: Trs,
    /// Weights of the morph targets of its mesh; empty where that has none.
    pub weights: Vec<f32>,
}

/// How the nodes of a file stand at a time.
#[derive(Clone, Debug, PartialEq)]
pub struct NodePose {
    /// From each node to the file's world.
    pub to_file: Vec<Mat4>,
    /// Of each node the weights of its mesh's morph targets.
    pub weights: Vec<Vec<f32>>,
}

/// Scale, then rotation, then translation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trs {
    /// Where the node's origin is moved to.
    pub translation: Vec3,
    /// A unit quaternion.
    pub rotation: Quat,
    /// A factor along each axis.
    pub scale: Vec3,
}

impl Trs {
    /// The node where its parent is.
    pub const IDENTITY: Self = Self {
        translation: Vec3::ZERO,
        rotation: Quat::IDENTITY,
        scale: Vec3::ONE,
    };

    /// As a matrix.
    pub fn matrix(&self) -> Mat4 {
        Mat4::from_scale_rotation_translation(self.scale, self.rotation, self.translation)
    }
}

impl Node {
    /// A node in `parent`, moved to `translation`.
    pub fn at(name: &str, parent: Option<usize>, translation: Vec3) -> Self {
        Self {
            name: name.to_owned(),
            parent,
            local: Mat4::from_translation(translation),
            parts: Trs {
                translation,
                ..Trs::IDENTITY
            },
            weights: Vec::new(),
        }
    }
}

/// From each node to the file's world, given what takes each to its parent.
pub fn to_file(nodes: &[Node], local: impl Fn(usize, &Node) -> Mat4) -> Vec<Mat4> {
    let mut all: Vec<Mat4> = Vec::with_capacity(nodes.len());
    for (index, node) in nodes.iter().enumerate() {
        let own = local(index, node);
        all.push(match node.parent.and_then(|parent| all.get(parent)) {
            Some(parent) => *parent * own,
            None => own,
        });
    }
    all
}

/// The names of nodes, each once, in the order of the list.
pub fn names(nodes: &[Node]) -> Vec<&str> {
    let mut known = HashSet::new();
    let names = nodes.iter().map(|node| node.name.as_str());
    names
        .filter(|name| !name.is_empty() && known.insert(*name))
        .collect()
}
