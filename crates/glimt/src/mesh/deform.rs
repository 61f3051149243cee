//! Host file: meshes whose vertices move: by morph targets first, then by the joints of a skin (glTF 2.0, sections 3.7.2.2 and 3.7.3).

use super::node::NodePose;
use super::subdivide::subdivide;
use glam::{Mat3, Mat4, Vec3, Vec4};
use glimt_render_gpu::prepare::scene::Mesh;
use rayon::prelude::*;

/// What the vertices of a mesh follow.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Deform {
    /// Morph targets.
    pub targets: Vec<Target>,
    /// The joints of each vertex, as indices into a skin's list, in as many places for each; empty where joints do not move it.
    pub joints: Vec<u32>,
    /// A weight for each of `joints`; those of a vertex add up to 1.
    pub weights: Vec<f32>,
}

/// Where vertices go at weight 1: what is added to each, by property; empty where that does not change.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Target {
    /// To positions.
    pub positions: Vec<Vec3>,
    /// To normals.
    pub normals: Vec<Vec3>,
    /// To the directions of tangents.
    pub tangents: Vec<Vec3>,
}

/// The joints that move a mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct Skin {
    /// Its name.
    pub name: String,
    /// The nodes that are joints.
    pub joints: Vec<usize>,
    /// From the mesh to each joint, where the mesh was bound to it.
    pub inverse_bind: Vec<Mat4>,
}

impl Skin {
    /// From the mesh to the file's world, as each joint moves it.
    pub fn matrices(&self, pose: &NodePose) -> Vec<Mat4> {
        let pairs = self.joints.iter().zip(&self.inverse_bind);
        pairs
            .map(|(&joint, bind)| pose.to_file[joint] * *bind)
            .collect()
    }
}

impl Deform {
    /// The mesh with these weights of its targets, moved by these joints if it has a skin: it is in the file's world then.
    pub fn apply(&self, mesh: &Mesh, weights: &[f32], joints: Option<&[Mat4]>) -> Mesh {
        let mut moved = mesh.clone();
        for (target, &weight) in self.targets.iter().zip(weights) {
            if weight != 0.0 {
                add(&mut moved.positions, &target.positions, weight);
                add(&mut moved.normals, &target.normals, weight);
                let tangents = moved.tangents.iter_mut().zip(&target.tangents);
                for (tangent, offset) in tangents {
                    *tangent += (*offset * weight).extend(0.0);
                }
            }
        }
        if let Some(joints) = joints {
            self.skin(&mut moved, joints);
        }
        moved
    }

    fn skin(&self, mesh: &mut Mesh, matrices: &[Mat4]) {
        let vertices = mesh.positions.len();
        let each = self.joints.len() / vertices.max(1);
        let blend = |vertex: usize| {
            let range = vertex * each..(vertex + 1) * each;
            let pairs = self.joints[range.clone()].iter().zip(&self.weights[range]);
            let mut sum = Mat4::ZERO;
            for (&joint, &weight) in pairs.filter(|(_, weight)| **weight != 0.0) {
                sum += matrices[joint as usize] * weight;
            }
            sum
        };
        let blended: Vec<Mat4> = (0..vertices)
            .into_par_iter()
            .with_min_len(256)
            .map(blend)
            .collect();
        for (position, matrix) in mesh.positions.iter_mut().zip(&blended) {
            *position = matrix.transform_point3(*position);
        }
        for (normal, matrix) in mesh.normals.iter_mut().zip(&blended) {
            let turned = cofactors(&Mat3::from_mat4(*matrix)) * *normal;
            *normal = turned.try_normalize().unwrap_or(*normal);
        }
        for (tangent, matrix) in mesh.tangents.iter_mut().zip(&blended) {
            let linear = Mat3::from_mat4(*matrix);
            let along = (linear * tangent.truncate()).normalize_or_zero();
            // A mirrored surface has its bitangent on the other side.
            let side = if linear.determinant() < 0.0 {
                -1.0
            } else {
                1.0
            };
            *tangent = Vec4::from((along, side * tangent.w));
        }
    }
}

fn add(list: &mut [Vec3], offsets: &[Vec3], weight: f32) {
    for (value, offset) in list.iter_mut().zip(offsets) {
        *value += *offset * weight;
    }
}

/// What normals are turned by: the inverse's transpose times the absolute value of the determinant, so that a map that flattens has one.
fn cofactors(linear: &Mat3) -> Mat3 {
    let Mat3 {
        x_axis: x,
        y_axis: y,
        z_axis: z,
    } = *linear;
    let side = if linear.determinant() < 0.0 {
        -1.0
    } else {
        1.0
    };
    Mat3::from_cols(y.cross(z), z.cross(x), x.cross(y)) * side
}

/// A mesh that deforms, at a place of its file.
#[derive(Clone, Debug)]
pub struct Deformer {
    /// The mesh as its file has it.
    pub mesh: Mesh,
    /// What its vertices follow.
    pub deform: Deform,
    /// What moves it, if it is not its node.
    pub skin: Option<Skin>,
    /// The node that it stands at, whose weights its targets have.
    pub node: usize,
    /// How many times each triangle is cut in four, once it is deformed.
    pub subdivide: u32,
}

impl Deformer {
    /// The mesh where the nodes stand so: in the file's world if it has a skin, else at its node.
    pub fn mesh_at(&self, pose: &NodePose) -> Mesh {
        let joints = self.skin.as_ref().map(|skin| skin.matrices(pose));
        let weights = &pose.weights[self.node];
        let mut mesh = self.deform.apply(&self.mesh, weights, joints.as_deref());
        subdivide(&mut mesh, self.subdivide);
        mesh
    }
}
