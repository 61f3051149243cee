//! Host file: the objects of a scene with their meshes, and their triangles in the world at given transforms.

use std::collections::HashMap;
use std::collections::hash_map::Entry;
use std::sync::Arc;

use glam::{DMat3, Mat3, Mat4, Vec2, Vec3, Vec4};
use rayon::prelude::*;

use super::materials::{FACE_WORDS, append_attributes, may_pass};
use super::scene::{Mesh, Opacity, SceneDescription, Shape};
use super::scene_build::MAX_COORDINATE;
use super::scene_error::SceneError;
use super::transfer::SurfaceVertex;
use super::vertex_fans::Fans;
use crate::kernels::scene::{Corner, MIRRORED};
use crate::kernels::triangle::{CATCHER, INSIDE_OUT, SEE_THROUGH, Triangle};

/// A triangle is dropped when it is this many times longer than high: rounding alone decides where such a face looks.
const MAX_ASPECT: f64 = 1e7;

/// What does not change when the objects of a scene move, but for the shapes that they take.
#[derive(Debug)]
pub(super) struct Geometry {
    bodies: Vec<Body>,
}

/// An object without its place.
#[derive(Clone, Debug)]
struct Body {
    /// With normals, and with tangents where it has texture coordinates.
    mesh: Arc<Mesh>,
    material: Option<u32>,
    catcher: bool,
    /// Word of the surface buffer at which the attributes of its first face begin; 0 where it has none.
    attributes: u32,
    /// Of each material of the scene, whether light may pass it here.
    passes: Arc<[bool]>,
}

/// Of each material of a scene, whether light may pass it.
struct Opacities {
    /// Where the vertices' alpha is 1.
    of_material: Arc<[bool]>,
    /// Where it is less.
    of_vertices: Arc<[bool]>,
}

impl Opacities {
    fn of(description: &SceneDescription) -> Self {
        let materials = || description.materials.iter();
        Self {
            of_material: materials()
                .map(|material| may_pass(material, &description.textures))
                .collect(),
            of_vertices: materials()
                .map(|material| material.opacity != Opacity::Opaque)
                .collect(),
        }
    }

    fn of_mesh(&self, mesh: &Mesh) -> Arc<[bool]> {
        let is_thin = mesh.colors.iter().any(|color| color.w < 1.0);
        Arc::clone(match is_thin {
            true => &self.of_vertices,
            false => &self.of_material,
        })
    }
}

/// Triangles of an object in the world, in the order of its mesh.
#[derive(Default)]
pub(super) struct Flat {
    pub(super) triangles: Vec<Triangle>,
    pub(super) corners: Vec<[Corner; 3]>,
    /// Faces that were dropped because they have no area.
    pub(super) dropped: Vec<u32>,
}

impl Geometry {
    /// Checks the meshes of a scene, and makes the normals and tangents that they lack. Appends the attributes that kernels want of
    /// them to the surface buffer.
    pub(super) fn new(
        description: &SceneDescription,
        surface: &mut Vec<u32>,
    ) -> Result<Self, SceneError> {
        let materials = description.materials.len();
        let opacity = Opacities::of(description);
        let mut attributes: HashMap<u32, u32> = HashMap::new();
        let mut meshes: HashMap<u32, Arc<Mesh>> = HashMap::new();
        let mut bodies = Vec::with_capacity(description.objects.len());
        for (index, object) in description.objects.iter().enumerate() {
            let missing = |what, index_given| SceneError::Missing {
                object: index,
                what,
                index: index_given,
            };
            let mesh = description
                .meshes
                .get(object.mesh as usize)
                .ok_or(missing("mesh", object.mesh))?;
            let known = meshes.get(&object.mesh).cloned();
            let complete = match known {
                Some(known) => known,
                None => {
                    check_mesh(mesh)?;
                    let mut complete = mesh.clone();
                    complete.complete();
                    let complete = Arc::new(complete);
                    meshes.insert(object.mesh, Arc::clone(&complete));
                    complete
                }
            };
            match object.material {
                Some(own) if own as usize >= materials => return Err(missing("material", own)),
                Some(_) => {}
                None => check_materials(mesh, materials)?,
            }
            let passes = opacity.of_mesh(&complete);
            let seen_through = match object.material {
                Some(own) => passes[own as usize],
                None => {
                    let mut named = complete.materials.iter();
                    named.any(|&m| passes.get(m as usize).is_some_and(|&passes| passes))
                }
            };
            // A material of the object's own takes the place of colours, too.
            let is_coloured = object.material.is_none() && !complete.colors.is_empty();
            let attributes = match (seen_through || is_coloured, attributes.entry(object.mesh)) {
                (false, _) => 0,
                (true, Entry::Occupied(known)) => *known.get(),
                (true, Entry::Vacant(new)) => *new.insert(append_attributes(surface, &complete)?),
            };
            bodies.push(Body {
                mesh: complete,
                material: object.material,
                catcher: object.catcher,
                attributes,
                passes,
            });
        }
        Ok(Self { bodies })
    }

    /// The same objects, of which some have another shape. What `current` has in the same shape is taken from there.
    pub(super) fn shaped(&self, shapes: &[Shape], current: &Self) -> Result<Self, SceneError> {
        let mut bodies = self.bodies.clone();
        for shape in shapes {
            let object = shape.object;
            let Some(body) = bodies.get_mut(object) else {
                return Err(SceneError::Missing {
                    object,
                    what: "object of that number; a shape has index",
                    index: object as u32,
                });
            };
            let mut mesh = Mesh {
                positions: shape.positions.clone(),
                normals: shape.normals.clone(),
                tangents: shape.tangents.clone(),
                ..(*body.mesh).clone()
            };
            let (found, expected) = (mesh.positions.len(), body.mesh.positions.len());
            if found != expected {
                return Err(SceneError::Length {
                    mesh: mesh.name,
                    what: "positions of a shape",
                    found,
                    expected,
                });
            }
            check_mesh(&mesh)?;
            mesh.complete();
            let known = &current.bodies[object].mesh;
            body.mesh = match is_same_shape(&mesh, known) {
                true => Arc::clone(known),
                false => Arc::new(mesh),
            };
        }
        Ok(Self { bodies })
    }

    /// Whether an object has the very shape that it has in `other`.
    pub(super) fn is_same(&self, other: &Self, object: usize) -> bool {
        Arc::ptr_eq(&self.bodies[object].mesh, &other.bodies[object].mesh)
    }

    /// Whether there is a catcher with a triangle.
    pub(super) fn has_catcher(&self) -> bool {
        let mut bodies = self.bodies.iter();
        bodies.any(|body| body.catcher && !body.mesh.indices.is_empty())
    }

    /// The vertices of an object that stands at `transform`, in the order of its mesh.
    pub(super) fn vertices(
        &self,
        object: usize,
        transform: &Mat4,
    ) -> Result<Vec<SurfaceVertex>, SceneError> {
        let mesh = &*self.bodies[object].mesh;
        let positions = world_positions(object, mesh, transform)?;
        let linear = DMat3::from_mat4(transform.as_dmat4());
        let normal = world_normals(mesh, &linear);
        let fans = Fans::new(mesh, &positions, normal);
        let vertices = (0..positions.len()).into_par_iter().with_min_len(256);
        Ok(vertices
            .map(|i| fans.vertex(i, positions[i], object as u32))
            .collect())
    }

    /// The mesh of an object.
    pub(super) fn mesh(&self, object: usize) -> &Mesh {
        &self.bodies[object].mesh
    }

    /// Whether an object is a catcher.
    pub(super) fn is_catcher(&self, object: usize) -> bool {
        self.bodies[object].catcher
    }

    /// How many vertices the mesh of an object has.
    pub(super) fn vertex_count(&self, object: usize) -> usize {
        self.bodies[object].mesh.positions.len()
    }

    /// Faces of an object's mesh without those dropped, of which there is a sorted list.
    pub(super) fn faces<'a>(
        &'a self,
        object: usize,
        dropped: &'a [u32],
    ) -> impl Iterator<Item = [u32; 3]> + 'a {
        let faces = (0u32..).zip(&self.bodies[object].mesh.indices);
        faces
            .filter(|(i, _)| dropped.binary_search(i).is_err())
            .map(|(_, face)| *face)
    }

    /// The triangles of an object that stands at `transform`, an affine map.
    pub(super) fn flatten(&self, object: usize, transform: &Mat4) -> Result<Flat, SceneError> {
        let body = &self.bodies[object];
        let mesh = &*body.mesh;
        let linear = DMat3::from_mat4(transform.as_dmat4());
        let determinant = linear.determinant();
        if !(determinant.abs() > 0.0 && determinant.abs() <= f64::MAX) {
            return Err(SceneError::Transform { object });
        }
        let positions = world_positions(object, mesh, transform)?;
        let to_world = world_normals(mesh, &linear);
        let tangent_map = Mat3::from_mat4(*transform);
        let corner = |vertex: usize| {
            let uv = mesh.uvs.get(vertex).copied().unwrap_or(Vec2::ZERO);
            let tangent = mesh.tangents.get(vertex).copied().unwrap_or(Vec4::ZERO);
            Corner {
                normal: to_world(vertex),
                u: uv.x,
                tangent: (tangent_map * tangent.truncate()).normalize_or_zero(),
                v: uv.y,
            }
        };
        let corners: Vec<Corner> = (0..positions.len()).into_par_iter().map(corner).collect();
        let number = if body.catcher {
            object as u32 | CATCHER
        } else {
            object as u32
        };
        let triangle = |(index, face): (usize, &[u32; 3])| {
            let [v0, v1, v2] = face.map(|i| positions[i as usize]);
            if is_degenerate(v0, v1, v2) {
                return None;
            }
            let own = match mesh.materials.len() {
                1 => mesh.materials[0],
                _ => mesh.materials[index],
            };
            let material = body.material.unwrap_or(own);
            let handedness = mesh
                .tangents
                .get(face[0] as usize)
                .map_or(1.0, |t| f64::from(t.w));
            let mirrored = handedness * determinant < 0.0;
            let up: Vec3 = face.iter().map(|i| corners[*i as usize].normal).sum();
            let is_inside_out = (v1 - v0).cross(v2 - v0).dot(up) < 0.0;
            let mut bits = number;
            if is_inside_out {
                bits |= INSIDE_OUT;
            }
            if body.passes[material as usize] {
                bits |= SEE_THROUGH;
            }
            Some(Triangle {
                material: if mirrored {
                    material | MIRRORED
                } else {
                    material
                },
                object: bits,
                attributes: match body.attributes {
                    0 => 0,
                    first => first + (index * FACE_WORDS) as u32,
                },
                ..Triangle::new(v0, v1, v2)
            })
        };
        let made: Vec<Option<Triangle>> = mesh
            .indices
            .par_iter()
            .enumerate()
            .with_min_len(256)
            .map(triangle)
            .collect();
        let mut flat = Flat::default();
        flat.triangles.reserve_exact(made.len());
        flat.corners.reserve_exact(made.len());
        for (index, (made, face)) in made.into_iter().zip(&mesh.indices).enumerate() {
            match made {
                Some(triangle) => {
                    flat.triangles.push(triangle);
                    flat.corners.push(face.map(|i| corners[i as usize]));
                }
                None => flat.dropped.push(index as u32),
            }
        }
        Ok(flat)
    }
}

/// Whether the vertices of two meshes are the same to the bit.
fn is_same_shape(a: &Mesh, b: &Mesh) -> bool {
    fn bytes<T: bytemuck::NoUninit>(list: &[T]) -> &[u8] {
        bytemuck::cast_slice(list)
    }
    bytes(&a.positions) == bytes(&b.positions)
        && bytes(&a.normals) == bytes(&b.normals)
        && bytes(&a.tangents) == bytes(&b.tangents)
}

/// The materials that a mesh names itself.
fn check_materials(mesh: &Mesh, count: usize) -> Result<(), SceneError> {
    let named = &mesh.materials[..mesh.materials.len().min(mesh.indices.len())];
    match named.iter().position(|&index| index as usize >= count) {
        None => Ok(()),
        Some(triangle) => Err(SceneError::Index {
            mesh: mesh.name.clone(),
            triangle,
            what: "material",
            index: named[triangle],
            count,
        }),
    }
}

/// Unit normals in the world, by their numbers; zero where there is none.
fn world_normals<'a>(mesh: &'a Mesh, linear: &DMat3) -> impl Fn(usize) -> Vec3 + Sync + 'a {
    let normal_map = linear.inverse().transpose();
    move |vertex| {
        (normal_map * mesh.normals[vertex].as_dvec3())
            .normalize_or_zero()
            .as_vec3()
    }
}

fn world_positions(object: usize, mesh: &Mesh, transform: &Mat4) -> Result<Vec<Vec3>, SceneError> {
    let transform = transform.as_dmat4();
    let mut used = vec![false; mesh.positions.len()];
    for &vertex in mesh.indices.iter().flatten() {
        used[vertex as usize] = true;
    }
    let positions: Vec<Vec3> = mesh
        .positions
        .par_iter()
        .with_min_len(256)
        .map(|p| transform.transform_point3(p.as_dvec3()).as_vec3())
        .collect();
    let bad = |(p, used): (&Vec3, &bool)| {
        *used && !(p.is_finite() && p.abs().max_element() <= MAX_COORDINATE)
    };
    match positions.iter().zip(&used).position(bad) {
        Some(vertex) => Err(SceneError::Position {
            object,
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
    if !mesh.colors.is_empty() {
        length("colours", mesh.colors.len(), vertices)?;
        finite("colour", mesh.colors.iter().position(|c| !c.is_finite()))?;
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
