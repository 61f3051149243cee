//! Host file: from a scene's description to the kernels' buffers, and on to those of its other poses.

use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use bytemuck::Zeroable;
use glam::{Mat4, Vec3};

use super::geometry::{Flat, Geometry};
use super::materials::pack_surface;
use super::scene::{Mesh, SceneDescription, Shape};
use super::scene_error::SceneError;
use super::transfer::{SceneTransfer, SurfaceVertex, Transfer, TransferError};
use super::tree::{BuiltTree, build_tree, refit, sah_cost};
use crate::kernels::bvh::BvhNode;
use crate::kernels::scene::{Corner, Scene};
use crate::kernels::triangle::Triangle;

/// World coordinates must not exceed this, so that areas and volumes stay finite in f32.
pub const MAX_COORDINATE: f32 = 1e9;

/// A refitted tree whose rays are expected to cost this many times what they did in the reference pose is rebuilt instead.
/// Objects that turn and fall without taking each other's place stay within a hundredth; at 1.4, frames take up to thrice as
/// long (`benches/RESULTS.md`).
const REBUILD_COST: f64 = 1.1;

/// A scene as executors take it: the buffers that kernels read, all of them with at least one element.
///
/// The transforms and meshes of its description are the *reference pose*; [`pose`](Self::pose) and
/// [`pose_shaped`](Self::pose_shaped) move and deform the objects. What the buffers hold then depends on the reference pose and on
/// that pose alone, not on the ones between.
#[derive(Clone, Debug)]
pub struct SceneBuffers {
    id: u64,
    surface_id: u64,
    nodes: Vec<BvhNode>,
    triangles: Vec<Triangle>,
    corners: Vec<Corner>,
    surface: Arc<Vec<u32>>,
    is_see_through: bool,
    dropped: usize,
    geometry: Arc<Geometry>,
    transforms: Vec<Mat4>,
    reference: Arc<Reference>,
    /// Whether the triangles lie as they do in the reference pose.
    in_reference_order: bool,
    transfer: Option<Arc<SceneTransfer>>,
}

/// Where the tree of a pose comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tree {
    /// From the reference pose's, where that is good enough for rays.
    Best,
    /// From the reference pose's, wherever the same triangles have an area.
    Refitted,
    /// From the triangles.
    Rebuilt,
}

/// What poses are refitted from.
#[derive(Debug)]
struct Reference {
    geometry: Arc<Geometry>,
    nodes: Vec<BvhNode>,
    cost: f64,
    /// The place among the triangles of each one in the order of the description.
    places: Vec<u32>,
    /// In that place, the triangle's run.
    runs: Vec<u32>,
    /// The first of each object's triangles in that order.
    starts: Vec<usize>,
    /// Each object's faces without area.
    dropped: Vec<Vec<u32>>,
}

impl SceneBuffers {
    /// Checks a scene, brings its meshes into the world, and builds the tree over their triangles.
    ///
    /// Triangles without area are dropped and counted.
    ///
    /// # Errors
    /// A [`SceneError`] that names the place.
    pub fn build(description: &SceneDescription) -> Result<Self, SceneError> {
        let mut surface = pack_surface(&description.materials, &description.textures)?;
        let geometry = Geometry::new(description, &mut surface)?;
        let objects = description.objects.iter();
        let transforms: Vec<Mat4> = objects.map(|object| object.transform).collect();
        let flats = flatten_all(&geometry, &transforms)?;
        let Ordered {
            nodes,
            triangles,
            corners,
            order,
        } = Ordered::build(&flats)?;
        let mut places = vec![0; order.len()];
        for (place, &flat) in (0..).zip(&order) {
            places[flat as usize] = place;
        }
        let starts = flats.iter().scan(0, |next, flat| {
            let start = *next;
            *next += flat.triangles.len();
            Some(start)
        });
        let geometry = Arc::new(geometry);
        let reference = Reference {
            geometry: Arc::clone(&geometry),
            cost: sah_cost(&nodes, &triangles),
            nodes: nodes.clone(),
            places,
            runs: triangles.iter().map(|triangle| triangle.run).collect(),
            starts: starts.collect(),
            dropped: flats.iter().map(|flat| flat.dropped.clone()).collect(),
        };
        let id = new_id();
        Ok(Self {
            id,
            surface_id: id,
            is_see_through: triangles.iter().any(Triangle::is_see_through),
            nodes,
            triangles,
            corners,
            surface: Arc::new(surface),
            dropped: count_dropped(&flats),
            geometry,
            transforms,
            reference: Arc::new(reference),
            in_reference_order: true,
            transfer: None,
        })
    }

    /// Moves each object to its transform among `transforms`, from its mesh to the world: one for each object of the
    /// description, each an affine map that can be inverted.
    ///
    /// The buffers become those of a scene that is built there, up to the order of the triangles: the tree of the reference
    /// pose is refitted, or a new one built where that would cost rays too much or other triangles have no area. Poses between
    /// leave no trace. Where nothing has moved nothing is done; where something has, the scene's transfer is lost.
    ///
    /// # Errors
    /// A [`SceneError`] that names the object; the scene then stays as it was.
    pub fn pose(&mut self, transforms: &[Mat4]) -> Result<(), SceneError> {
        self.pose_by(transforms, Tree::Best)
    }

    /// As [`pose`](Self::pose), and deforms objects: those of which there is no shape have the reference pose's.
    ///
    /// # Errors
    /// As [`pose`](Self::pose); a shape that does not fit the mesh of its object.
    pub fn pose_shaped(&mut self, transforms: &[Mat4], shapes: &[Shape]) -> Result<(), SceneError> {
        self.pose_to(transforms, shapes, Tree::Best)
    }

    /// As [`pose`](Self::pose), with a choice of the tree: to measure what each costs.
    ///
    /// # Errors
    /// As [`pose`](Self::pose).
    pub fn pose_by(&mut self, transforms: &[Mat4], tree: Tree) -> Result<(), SceneError> {
        self.pose_to(transforms, &[], tree)
    }

    fn pose_to(
        &mut self,
        transforms: &[Mat4],
        shapes: &[Shape],
        tree: Tree,
    ) -> Result<(), SceneError> {
        let (found, expected) = (transforms.len(), self.transforms.len());
        if found != expected {
            return Err(SceneError::Pose { found, expected });
        }
        let geometry = self.reference.geometry.shaped(shapes, &self.geometry)?;
        let bits = |m: &Mat4| m.to_cols_array().map(f32::to_bits);
        let has_moved = |i: &usize| {
            bits(&transforms[*i]) != bits(&self.transforms[*i])
                || !geometry.is_same(&self.geometry, *i)
        };
        let mut moved: Vec<usize> = (0..expected).filter(has_moved).collect();
        if moved.is_empty() {
            return Ok(());
        }
        if !self.in_reference_order {
            moved = (0..expected).collect();
        }
        let flats = moved
            .iter()
            .map(|&i| geometry.flatten(i, &transforms[i]))
            .collect::<Result<Vec<_>, _>>()?;
        let mut pairs = moved.iter().zip(&flats);
        let same_faces = pairs.all(|(&i, flat)| flat.dropped == self.reference.dropped[i]);
        let may_refit = same_faces && tree != Tree::Rebuilt;
        if !(may_refit && (self.refit(&moved, &flats) || tree == Tree::Refitted)) {
            self.rebuild(&geometry, transforms)?;
        }
        self.geometry = Arc::new(geometry);
        self.transforms.copy_from_slice(transforms);
        self.id = new_id();
        self.transfer = None;
        Ok(())
    }

    /// All vertices where they stand now: object by object, each in the order of its mesh.
    ///
    /// # Errors
    /// [`SceneError::Position`].
    pub fn vertices(&self) -> Result<Vec<SurfaceVertex>, SceneError> {
        let objects = self.transforms.iter().enumerate();
        let each = objects.map(|(i, t)| self.geometry.vertices(i, t));
        Ok(each.collect::<Result<Vec<_>, _>>()?.concat())
    }

    /// How many vertices each object has.
    pub fn vertex_counts(&self) -> Vec<usize> {
        let objects = 0..self.transforms.len();
        objects.map(|i| self.geometry.vertex_count(i)).collect()
    }

    /// The mesh of an object, in its own coordinates, with normals.
    ///
    /// # Panics
    /// There is no such object.
    pub fn mesh(&self, object: usize) -> &Mesh {
        self.geometry.mesh(object)
    }

    /// Whether an object is a catcher.
    ///
    /// # Panics
    /// There is no such object.
    pub fn is_catcher(&self, object: usize) -> bool {
        self.geometry.is_catcher(object)
    }

    /// Gives the scene the transfer that was computed for it, where its objects stand now, and each object the weight c_k of its
    /// mirror reflection, in [0, 1]; what lacks in that list is 0.
    ///
    /// # Errors
    /// The transfer is not one of a scene with these vertices, or the scene is in a pose that has a tree of its own.
    pub fn set_transfer(
        &mut self,
        transfer: Arc<Transfer>,
        reflections: &[f32],
    ) -> Result<(), TransferError> {
        let counts = self.vertex_counts();
        transfer.check(counts.iter().sum())?;
        // The order of a tree of the pose's own is not kept.
        if !self.in_reference_order {
            return Err(TransferError::Moved);
        }
        let Reference {
            places, dropped, ..
        } = &*self.reference;
        let mut corner_vertices = vec![0; self.corners.len()];
        let mut places = places.iter();
        let mut first_vertex = 0;
        for (object, count) in counts.iter().enumerate() {
            for (face, &place) in self
                .geometry
                .faces(object, &dropped[object])
                .zip(&mut places)
            {
                let corners = &mut corner_vertices[3 * place as usize..][..3];
                for (corner, vertex) in corners.iter_mut().zip(face) {
                    *corner = first_vertex + vertex;
                }
            }
            first_vertex += *count as u32;
        }
        let mut weights = reflections.to_vec();
        weights.resize(counts.len().max(1), 0.0);
        let joined = SceneTransfer::new(new_id(), transfer, corner_vertices, weights);
        self.transfer = Some(Arc::new(joined));
        Ok(())
    }

    /// The transfer that the scene was given.
    pub fn transfer(&self) -> Option<&SceneTransfer> {
        self.transfer.as_deref()
    }

    /// Puts moved objects into the tree of the reference pose. Says whether that is good enough for rays.
    fn refit(&mut self, moved: &[usize], flats: &[Flat]) -> bool {
        let Reference {
            nodes,
            cost,
            places,
            runs,
            starts,
            dropped,
            ..
        } = &*self.reference;
        self.triangles.resize(places.len(), Zeroable::zeroed());
        self.corners.resize(3 * places.len(), Zeroable::zeroed());
        for (&object, flat) in moved.iter().zip(flats) {
            let places = &places[starts[object]..];
            for ((triangle, corners), &place) in
                flat.triangles.iter().zip(&flat.corners).zip(places)
            {
                let place = place as usize;
                self.triangles[place] = Triangle {
                    run: runs[place],
                    ..*triangle
                };
                self.corners[3 * place..][..3].copy_from_slice(corners);
            }
        }
        self.nodes.clone_from(nodes);
        refit(&mut self.nodes, &self.triangles);
        self.dropped = dropped.iter().map(Vec::len).sum();
        self.in_reference_order = true;
        sah_cost(&self.nodes, &self.triangles) <= REBUILD_COST * cost
    }

    /// Builds a tree of this pose's own.
    fn rebuild(&mut self, geometry: &Geometry, transforms: &[Mat4]) -> Result<(), SceneError> {
        let flats = flatten_all(geometry, transforms)?;
        let Ordered {
            nodes,
            triangles,
            corners,
            ..
        } = Ordered::build(&flats)?;
        self.nodes = nodes;
        self.triangles = triangles;
        self.corners = corners;
        self.dropped = count_dropped(&flats);
        self.in_reference_order = false;
        Ok(())
    }

    /// Where the objects stand: from the mesh of each to the world.
    pub fn transforms(&self) -> &[Mat4] {
        &self.transforms
    }

    /// What kernels see of it.
    pub fn view(&self) -> Scene<'_> {
        Scene {
            nodes: &self.nodes,
            triangles: &self.triangles,
            corners: &self.corners,
            surface: &self.surface,
        }
    }

    /// A number that no other scene of this process has, but for clones, nor this one in another pose: tells an executor
    /// whether it has uploaded this one.
    pub fn id(&self) -> u64 {
        self.id
    }

    /// The same for materials and textures, which a pose does not change.
    pub fn surface_id(&self) -> u64 {
        self.surface_id
    }

    /// Whether some surface lets light pass.
    pub fn is_see_through(&self) -> bool {
        self.is_see_through
    }

    /// Whether there is a catcher.
    pub fn has_catcher(&self) -> bool {
        self.geometry.has_catcher()
    }

    /// How many triangles were dropped because they have no area.
    pub fn dropped_triangles(&self) -> usize {
        self.dropped
    }

    /// What a ray through the box around all triangles is expected to cost, by the surface area heuristic: triangles that it is tested
    /// against, and nodes, each as much as two of them.
    pub fn expected_ray_cost(&self) -> f64 {
        sah_cost(&self.nodes, &self.triangles)
    }

    /// Lower and upper corner of the box around all triangles.
    pub fn bounds(&self) -> (Vec3, Vec3) {
        self.nodes[0].whole()
    }
}

fn new_id() -> u64 {
    static NEXT_ID: AtomicU64 = AtomicU64::new(0);
    NEXT_ID.fetch_add(1, Ordering::Relaxed)
}

fn flatten_all(geometry: &Geometry, transforms: &[Mat4]) -> Result<Vec<Flat>, SceneError> {
    let pairs = transforms.iter().enumerate();
    pairs.map(|(i, t)| geometry.flatten(i, t)).collect()
}

fn count_dropped(flats: &[Flat]) -> usize {
    flats.iter().map(|flat| flat.dropped.len()).sum()
}

/// A tree, and the triangles as its leaves want them.
struct Ordered {
    nodes: Vec<BvhNode>,
    triangles: Vec<Triangle>,
    corners: Vec<Corner>,
    /// Which triangle of the description each of them is.
    order: Vec<u32>,
}

impl Ordered {
    fn build(flats: &[Flat]) -> Result<Self, SceneError> {
        let triangles: Vec<Triangle> = flats.iter().flat_map(|f| &f.triangles).copied().collect();
        if triangles.is_empty() {
            let dropped = count_dropped(flats);
            return Err(SceneError::NoTriangles { dropped });
        }
        // Three corners each.
        if triangles.len() > (u32::MAX / 4) as usize {
            return Err(SceneError::TooLarge { what: "triangles" });
        }
        let corners: Vec<&[Corner; 3]> = flats.iter().flat_map(|f| &f.corners).collect();
        let BuiltTree { nodes, order, runs } = build_tree(&triangles);
        let ordered = order.iter().zip(runs).map(|(&i, run)| Triangle {
            run,
            ..triangles[i as usize]
        });
        Ok(Self {
            nodes,
            triangles: ordered.collect(),
            corners: order.iter().flat_map(|&i| *corners[i as usize]).collect(),
            order,
        })
    }
}
