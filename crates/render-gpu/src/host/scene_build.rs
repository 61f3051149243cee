//! Host file: from a scene's description to the kernels' buffers.

use std::sync::atomic::{AtomicU64, Ordering};

use glam::{DMat3, Mat3, Mat4, Vec2, Vec3, Vec4};

use super::attributes::{area_weighted_normals, uv_tangents};
use super::materials::{pack_material, pack_textures};
use super::scene::{Mesh, Object, SceneDescription};
use super::scene_error::SceneError;
use super::tree::build_tree;
use crate::kernels::bvh::BvhNode;
use crate::kernels::material::Material;
use crate::kernels::scene::{Corner, MIRRORED, Scene};
use crate::kernels::triangle::{CATCHER, Triangle};

/// World coordinates must not exceed this, so that areas and volumes stay finite in f32.
pub const MAX_COORDINATE: f32 = 1e9;

/// Rays that leave a surface start this fraction of the triangle's largest coordinate away from it: 64 units in the
/// last place, of which about ten may be lost in the hit and in the next ray's test.
const RAY_OFFSET: f32 = 1.0 / 262_144.0;

/// A triangle is dropped when it is this many times longer than high: rounding alone decides where such a face looks.
const MAX_ASPECT: f64 = 1e7;

/// A scene as executors take it: the buffers that kernels read, all of them with at least one element.
#[derive(Clone, Debug)]
pub struct SceneBuffers {
    id: u64,
    nodes: Vec<BvhNode>,
    triangles: Vec<Triangle>,
    corners: Vec<Corner>,
    materials: Vec<Material>,
    texels: Vec<u32>,
    dropped: usize,
    has_catcher: bool,
    transforms: Vec<Mat4>,
}

impl SceneBuffers {
    /// Checks a scene, brings its meshes into the world, and builds the tree over their triangles.
    ///
    /// Triangles without area are dropped and counted.
    ///
    /// # Errors
    /// A [`SceneError`] that names the place.
    pub fn build(description: &SceneDescription) -> Result<Self, SceneError> {
        let (texels, textures) = pack_textures(&description.textures)?;
        let materials = description
            .materials
            .iter()
            .enumerate()
            .map(|(index, material)| pack_material(index, material, &textures))
            .collect::<Result<Vec<_>, _>>()?;
        let mut flat = Flat::default();
        for (index, object) in description.objects.iter().enumerate() {
            let mesh = description
                .meshes
                .get(object.mesh as usize)
                .ok_or(SceneError::Missing {
                    object: index,
                    what: "mesh",
                    index: object.mesh,
                })?;
            flat.add(index, object, mesh, &materials)?;
        }
        let Flat {
            triangles,
            corners,
            dropped,
        } = flat;
        if triangles.is_empty() {
            return Err(SceneError::NoTriangles { dropped });
        }
        // Three corners each, and nodes up to twice as many.
        if triangles.len() > (u32::MAX / 4) as usize {
            return Err(SceneError::TooLarge { what: "triangles" });
        }
        let (nodes, order) = build_tree(&triangles);
        static NEXT_ID: AtomicU64 = AtomicU64::new(0);
        Ok(Self {
            id: NEXT_ID.fetch_add(1, Ordering::Relaxed),
            nodes,
            triangles: order.iter().map(|&i| triangles[i as usize]).collect(),
            corners: order.iter().flat_map(|&i| corners[i as usize]).collect(),
            materials,
            texels,
            dropped,
            has_catcher: triangles.iter().any(Triangle::is_catcher),
            transforms: description.objects.iter().map(|o| o.transform).collect(),
        })
    }

    /// What kernels see of it.
    pub fn view(&self) -> Scene<'_> {
        Scene {
            nodes: &self.nodes,
            triangles: &self.triangles,
            corners: &self.corners,
            materials: &self.materials,
            texels: &self.texels,
        }
    }

    /// Where each object is: from its mesh's coordinates to the world's.
    #[must_use]
    pub fn transforms(&self) -> &[Mat4] {
        &self.transforms
    }

    /// A number that no other scene of this process has, but for clones: tells an executor whether it has uploaded
    /// this one.
    pub fn id(&self) -> u64 {
        self.id
    }

    /// Whether there is a catcher.
    pub fn has_catcher(&self) -> bool {
        self.has_catcher
    }

    /// How many triangles were dropped because they have no area.
    pub fn dropped_triangles(&self) -> usize {
        self.dropped
    }

    /// Lower and upper corner of the box around all triangles.
    pub fn bounds(&self) -> (Vec3, Vec3) {
        (self.nodes[0].min, self.nodes[0].max)
    }
}

/// Triangles of all objects, in the world, in the order of the description.
#[derive(Default)]
struct Flat {
    triangles: Vec<Triangle>,
    corners: Vec<[Corner; 3]>,
    dropped: usize,
}

impl Flat {
    fn add(
        &mut self,
        object_index: usize,
        object: &Object,
        mesh: &Mesh,
        materials: &[Material],
    ) -> Result<(), SceneError> {
        check_mesh(mesh)?;
        if let Some(index) = object.material.filter(|&m| m as usize >= materials.len()) {
            return Err(SceneError::Missing {
                object: object_index,
                what: "material",
                index,
            });
        }
        let linear = DMat3::from_mat4(object.transform.as_dmat4());
        let determinant = linear.determinant();
        if !(determinant.abs() > 0.0 && determinant.abs() <= f64::MAX) {
            return Err(SceneError::Transform {
                object: object_index,
            });
        }
        let positions = world_positions(object_index, object, mesh)?;
        let normal_map = linear.inverse().transpose();
        let made_normals;
        let normals = if mesh.normals.is_empty() {
            made_normals = area_weighted_normals(mesh);
            &made_normals
        } else {
            &mesh.normals
        };
        let made_tangents;
        let tangents = if !mesh.tangents.is_empty() || mesh.uvs.is_empty() {
            &mesh.tangents
        } else {
            made_tangents = uv_tangents(mesh);
            &made_tangents
        };
        let tangent_map = Mat3::from_mat4(object.transform);
        let corner = |vertex: u32| {
            let vertex = vertex as usize;
            let uv = mesh.uvs.get(vertex).copied().unwrap_or(Vec2::ZERO);
            let tangent = tangents.get(vertex).copied().unwrap_or(Vec4::ZERO);
            Corner {
                normal: (normal_map * normals[vertex].as_dvec3())
                    .normalize_or_zero()
                    .as_vec3(),
                u: uv.x,
                tangent: (tangent_map * tangent.truncate()).normalize_or_zero(),
                v: uv.y,
            }
        };
        for (index, face) in mesh.indices.iter().enumerate() {
            let [v0, v1, v2] = face.map(|i| positions[i as usize]);
            if is_degenerate(v0, v1, v2) {
                self.dropped += 1;
                continue;
            }
            let material = triangle_material(object, mesh, index, materials)?;
            let handedness = tangents
                .get(face[0] as usize)
                .map_or(1.0, |t| f64::from(t.w));
            let mirrored = handedness * determinant < 0.0;
            let extent = v0.abs().max(v1.abs()).max(v2.abs()).max_element();
            self.triangles.push(Triangle {
                v0,
                material: if mirrored {
                    material | MIRRORED
                } else {
                    material
                },
                v1,
                object: if object.catcher {
                    object_index as u32 | CATCHER
                } else {
                    object_index as u32
                },
                v2,
                ray_offset: RAY_OFFSET * extent,
            });
            self.corners.push(face.map(corner));
        }
        Ok(())
    }
}

fn triangle_material(
    object: &Object,
    mesh: &Mesh,
    triangle: usize,
    materials: &[Material],
) -> Result<u32, SceneError> {
    let own = if mesh.materials.len() == 1 {
        mesh.materials[0]
    } else {
        mesh.materials[triangle]
    };
    let index = object.material.unwrap_or(own);
    if (index as usize) < materials.len() {
        Ok(index)
    } else {
        Err(SceneError::Index {
            mesh: mesh.name.clone(),
            triangle,
            what: "material",
            index,
            count: materials.len(),
        })
    }
}

fn world_positions(
    object_index: usize,
    object: &Object,
    mesh: &Mesh,
) -> Result<Vec<Vec3>, SceneError> {
    let transform = object.transform.as_dmat4();
    let mut used = vec![false; mesh.positions.len()];
    for &vertex in mesh.indices.iter().flatten() {
        used[vertex as usize] = true;
    }
    let positions: Vec<Vec3> = mesh
        .positions
        .iter()
        .map(|p| transform.transform_point3(p.as_dvec3()).as_vec3())
        .collect();
    let bad = |(p, used): (&Vec3, &bool)| {
        *used && !(p.is_finite() && p.abs().max_element() <= MAX_COORDINATE)
    };
    match positions.iter().zip(&used).position(bad) {
        Some(vertex) => Err(SceneError::Position {
            object: object_index,
            mesh: mesh.name.clone(),
            vertex,
        }),
        None => Ok(positions),
    }
}

/// Lengths, indices and attributes of a mesh.
fn check_mesh(mesh: &Mesh) -> Result<(), SceneError> {
    let vertices = mesh.positions.len();
    for (triangle, face) in mesh.indices.iter().enumerate() {
        if let Some(&index) = face.iter().find(|&&i| i as usize >= vertices) {
            return Err(SceneError::Index {
                mesh: mesh.name.clone(),
                triangle,
                what: "vertex",
                index,
                count: vertices,
            });
        }
    }
    let length = |what, found: usize, expected: usize| {
        if found == expected {
            Ok(())
        } else {
            Err(SceneError::Length {
                mesh: mesh.name.clone(),
                what,
                found,
                expected,
            })
        }
    };
    let finite = |what, bad: Option<usize>| match bad {
        Some(vertex) => Err(SceneError::Attribute {
            mesh: mesh.name.clone(),
            what,
            vertex,
        }),
        None => Ok(()),
    };
    if !mesh.normals.is_empty() {
        length("normals", mesh.normals.len(), vertices)?;
        finite("normal", mesh.normals.iter().position(|n| !n.is_finite()))?;
    }
    if !mesh.uvs.is_empty() {
        length("texture coordinates", mesh.uvs.len(), vertices)?;
        finite(
            "texture coordinate",
            mesh.uvs.iter().position(|uv| !uv.is_finite()),
        )?;
    }
    if !mesh.tangents.is_empty() {
        length("tangents", mesh.tangents.len(), vertices)?;
        finite("tangent", mesh.tangents.iter().position(|t| !t.is_finite()))?;
    }
    if mesh.materials.len() != 1 {
        length("materials", mesh.materials.len(), mesh.indices.len())?;
    }
    Ok(())
}

/// Whether a face has no area, none that f32 could hold, or a height lost beside its length.
fn is_degenerate(v0: Vec3, v1: Vec3, v2: Vec3) -> bool {
    let [a, b, c] = [v0, v1, v2].map(|v| v.as_dvec3());
    let area2 = (b - a).cross(c - a).length();
    let longest2 = a
        .distance_squared(b)
        .max(b.distance_squared(c))
        .max(c.distance_squared(a));
    let in_f32 = (v1 - v0).cross(v2 - v0).length_squared();
    !(area2 * MAX_ASPECT > longest2) || !(in_f32 > f32::MIN_POSITIVE)
}
