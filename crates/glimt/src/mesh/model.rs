//! Host file: what a mesh file holds, whatever its format: meshes, materials, textures, nodes, cameras, animations.

use super::animation::Animation;
use super::deform::{Deform, Deformer, Skin};
use super::node::{self, Node, NodePose};
use crate::error::{Error, Result};
use crate::shot::digest::{self, Hash};
use glam::{DVec3, Mat4, Vec3};
use glimt_render_gpu::prepare::scene::{Material, Mesh, Opacity, Reflection, Texture};
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::path::PathBuf;

/// What a mesh file holds. Indices are into its own lists.
#[derive(Clone, Debug, Default)]
pub struct Model {
    /// Geometry.
    pub meshes: Vec<Mesh>,
    /// What the vertices of meshes follow, by the meshes' indices.
    pub deforms: BTreeMap<usize, Deform>,
    /// Joints that move meshes.
    pub skins: Vec<Skin>,
    /// Reflection models; at least one where there is a mesh.
    pub materials: Vec<Material>,
    /// Name of each material.
    pub material_names: Vec<String>,
    /// Images.
    pub textures: Vec<Texture>,
    /// Places in the file, in its own axes.
    pub nodes: Vec<Node>,
    /// Where the meshes stand.
    pub parts: Vec<Part>,
    /// Cameras.
    pub cameras: Vec<ModelCamera>,
    /// What moves the nodes.
    pub animations: Vec<Animation>,
    /// The file and all that it refers to.
    pub files: Vec<PathBuf>,
    /// Whether z is up, rather than y, if a shot does not say.
    pub z_up: bool,
    /// Where the origin of nodes without a parent lies in the file's world. Not zero where coordinates are too far away for 32 bits.
    pub origin: DVec3,
    /// How many triangles have made normals; the others have the file's.
    pub made_normals: NormalCounts,
}

/// Numbers of triangles whose normals are made.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct NormalCounts {
    /// Flat, as the file or its format demands.
    pub flat: usize,
    /// Smooth within smoothing groups.
    pub grouped: usize,
    /// By the crease angle.
    pub creased: usize,
}

/// A mesh placed in its file.
#[derive(Clone, Copy, Debug)]
pub struct Part {
    /// Index of the mesh.
    pub mesh: usize,
    /// Index of the node that it stands at.
    pub node: usize,
    /// Index of the skin that moves it in place of its node.
    pub skin: Option<usize>,
}

/// A perspective camera of a file.
#[derive(Clone, Debug)]
pub struct ModelCamera {
    /// Its name.
    pub name: String,
    /// Index of its node; it looks along −z with +y up.
    pub node: usize,
    /// Vertical field of view, in radians.
    pub fov_y: f32,
}

impl Model {
    /// One grey mesh, where its file has it, at a node of its name.
    pub fn of_mesh(mesh: Mesh) -> Model {
        Model {
            nodes: vec![Node::at(&mesh.name, None, Vec3::ZERO)],
            meshes: vec![mesh],
            materials: vec![default_material()],
            material_names: vec!["grey".to_owned()],
            parts: vec![Part {
                mesh: 0,
                node: 0,
                skin: None,
            }],
            ..Model::default()
        }
    }

    /// Number of triangles, counting each placing of a mesh.
    pub fn triangles(&self) -> usize {
        let count = |part: &Part| self.meshes[part.mesh].indices.len();
        self.parts.iter().map(count).sum()
    }

    /// How the nodes stand, as the file has it.
    pub fn rest(&self) -> NodePose {
        NodePose {
            to_file: node::to_file(&self.nodes, |_, node| node.local),
            weights: self.nodes.iter().map(|node| node.weights.clone()).collect(),
        }
    }

    /// What deforms a part, if something does.
    pub fn deformer(&self, part: &Part) -> Option<Deformer> {
        let deform = self.deforms.get(&part.mesh)?;
        let skin = part.skin.map(|skin| self.skins[skin].clone());
        let deforms = skin.is_some() || !deform.targets.is_empty();
        deforms.then(|| Deformer {
            mesh: self.meshes[part.mesh].clone(),
            deform: deform.clone(),
            skin,
            node: part.node,
            subdivide: 0,
        })
    }

    /// Bounds of all its parts, where the nodes stand so, after a further transform; `None` without any. Parts that are scaled to
    /// nothing have none.
    pub fn bounds(&self, pose: &NodePose, transform: Mat4) -> Option<(Vec3, Vec3)> {
        let mut bounds: Option<(Vec3, Vec3)> = None;
        for part in &self.parts {
            let to_world = match part.skin {
                Some(_) => transform,
                None => transform * pose.to_file[part.node],
            };
            if to_world.determinant() == 0.0 {
                continue;
            }
            let mesh = match self.deformer(part) {
                Some(deformer) => Cow::Owned(deformer.mesh_at(pose)),
                None => Cow::Borrowed(&self.meshes[part.mesh]),
            };
            for &index in mesh.indices.as_flattened() {
                let p = to_world.transform_point3(mesh.positions[index as usize]);
                let (low, high) = bounds.unwrap_or((p, p));
                bounds = Some((low.min(p), high.max(p)));
            }
        }
        bounds
    }

    /// Hash of the contents of all its files; of its name, if it is built in. `before` is the hash of the first file before the model
    /// was read from it.
    ///
    /// # Errors
    /// A file cannot be read, or the first one was replaced meanwhile.
    pub fn digest(&self, name: &str, before: Option<Hash>) -> Result<Hash> {
        if self.files.is_empty() {
            let mut hash = [0; 32];
            let n = name.len().min(32);
            hash[..n].copy_from_slice(&name.as_bytes()[..n]);
            return Ok(hash);
        }
        let hashes: Vec<Hash> = self
            .files
            .iter()
            .map(|file| digest::of_file(file))
            .collect::<Result<_>>()?;
        if before.is_some_and(|before| before != hashes[0]) {
            let what = "it was replaced while it was read";
            return Err(Error::input(&self.files[0], what).fix("run it again"));
        }
        Ok(digest::join(&hashes))
    }
}

/// Grey paint, for meshes that have no material.
pub fn default_material() -> Material {
    Material::from(Reflection::BlinnPhong {
        diffuse: Vec3::splat(0.6),
        specular: Vec3::ZERO,
        exponent: 1.0,
    })
}

/// White paint, which vertex colours and their alpha multiply.
pub fn painted_material(opacity: Opacity) -> Material {
    Material {
        opacity,
        ..Material::from(Reflection::BlinnPhong {
            diffuse: Vec3::ONE,
            specular: Vec3::ZERO,
            exponent: 1.0,
        })
    }
}
