//! Host file: the objects of a shot placed in the world, in each frame.

use super::motion::Motion;
use super::view::{FileCamera, View};
use crate::error::Result;
use crate::mesh::deform::Deformer;
use crate::mesh::load;
use crate::mesh::model::Model;
use crate::mesh::node::NodePose;
use crate::mesh::origin;
use crate::mesh::subdivide::{MOST_TRIANGLES, subdivide, triangles_after};
use crate::notes::Notes;
use crate::shot::digest::{Hash, join, of_file};
use crate::shot::parse::Source;
use crate::shot::{self, Shot, Up};
use glam::{DMat3, DMat4, DQuat, DVec3, EulerRot, Mat4, Vec3};
use glimt_render_gpu::prepare::scene::{Material, Mesh, Object, Reflection, SceneDescription};
use glimt_render_gpu::prepare::scene_build::MAX_COORDINATE;
use std::collections::HashMap;
use std::collections::hash_map::Entry;
use std::path::PathBuf;

/// A scene, and what moves in it.
#[derive(Clone, Debug)]
pub struct Placed {
    /// Meshes, materials, and objects where they stand in the first frame.
    pub scene: SceneDescription,
    /// Where it is seen from.
    pub view: View,
    /// How it moves: each of the shot's objects.
    pub movers: Vec<Mover>,
    /// Of each of the shot's objects its mesh file, and what that refers to; none of a built-in mesh.
    pub files: Vec<Vec<PathBuf>>,
    /// Hash of the contents of all mesh files.
    pub digest: Hash,
    /// Triangles, counting each placing of a mesh.
    pub triangles: usize,
    /// Which of the shot's objects each object of the scene is a part of.
    pub owners: Vec<usize>,
}

/// An object of a shot, whose parts move.
#[derive(Clone, Debug)]
pub struct Mover {
    /// From its file to the world, relative to the world's origin.
    pub to_world: DMat4,
    /// What moves its nodes.
    pub motion: Motion,
    /// Its parts, which are the next objects of the scene.
    pub parts: Vec<MoverPart>,
}

/// A part of an object of a shot.
#[derive(Clone, Debug)]
pub struct MoverPart {
    /// The node that it stands at.
    pub node: usize,
    /// What deforms it, if something does.
    pub deformer: Option<Deformer>,
}

impl Mover {
    /// From the mesh of each part to the world, where the nodes of its file stand so.
    pub fn parts_at(&self, pose: &NodePose) -> impl Iterator<Item = Mat4> {
        self.parts.iter().map(|part| match &part.deformer {
            // Its joints bring it into the file's world.
            Some(deformer) if deformer.skin.is_some() => self.to_world.as_mat4(),
            _ => unfolded((self.to_world * pose.to_file[part.node].as_dmat4()).as_mat4()),
        })
    }

    /// The mesh of each part as it is deformed where the nodes stand so; `None` where nothing deforms it.
    pub fn meshes_at(&self, pose: &NodePose) -> impl Iterator<Item = Option<Mesh>> {
        let deformers = self.parts.iter().map(|part| part.deformer.as_ref());
        deformers.map(|deformer| Some(deformer?.mesh_at(pose)))
    }
}

/// A transform that can be inverted. What is scaled to nothing becomes so small that none of its triangles has an area: files
/// hide things so.
fn unfolded(transform: Mat4) -> Mat4 {
    let flat = DMat3::from_mat4(transform.as_dmat4()).determinant() == 0.0;
    match flat {
        true => {
            Mat4::from_translation(transform.w_axis.truncate())
                * Mat4::from_scale(Vec3::splat(1e-20))
        }
        false => transform,
    }
}

/// Loads the meshes of a shot and places them where they stand in the first frame.
///
/// # Errors
/// A mesh cannot be loaded, has no node, animation or camera that the shot names, or lies beyond the world's end.
pub fn place(shot: &Shot, source: &Source, notes: &mut Notes) -> Result<Placed> {
    let mut loaded: HashMap<(&str, u32, u32), Loaded> = HashMap::new();
    let mut placing = Placing::default();
    let mut standing = Vec::new();
    for (index, object) in shot.objects.iter().enumerate() {
        let name = object.mesh.as_str();
        let key = (name, object.subdivide, object.crease_deg.to_bits());
        let entry = match loaded.entry(key) {
            Entry::Occupied(known) => &*known.into_mut(),
            Entry::Vacant(vacant) => {
                // Nothing for a built-in mesh; what cannot be read is said by who loads it.
                let before = of_file(&source.folder().join(name)).ok();
                let mut model = load(source.folder(), name, object.crease_deg, notes)?;
                let digest = model.digest(name, before)?;
                cut(&mut model, object.subdivide, index, source)?;
                &*vacant.insert(Loaded::new(model, digest, &mut placing.scene))
            }
        };
        let motion = Motion::new(object, index, &entry.model, source, notes)?;
        let pose = motion.nodes_at(0, shot.probe.fps);
        let to_world = transform(object, &entry.model, &pose);
        let bounds = bounds(&entry.model, &pose, to_world);
        let parts = entry.model.parts.iter().map(|part| MoverPart {
            node: part.node,
            deformer: entry.model.deformer(part).map(|deformer| Deformer {
                subdivide: object.subdivide,
                ..deformer
            }),
        });
        let mover = Mover {
            to_world,
            parts: parts.collect(),
            motion,
        };
        standing.push((key, mover, pose, bounds));
    }
    // Where all is far away, it is rendered relative to its middle: 32 bits hold it there.
    let corners: Vec<DVec3> = standing
        .iter()
        .flat_map(|(_, _, _, bounds)| *bounds)
        .flat_map(|(low, high)| [low, high])
        .collect();
    let origin = origin::of(&corners);
    let shift = DMat4::from_translation(-origin);
    for ((index, object), (key, mut mover, pose, bounds)) in
        shot.objects.iter().enumerate().zip(standing)
    {
        let entry = &loaded[&key];
        mover.to_world = shift * mover.to_world;
        if let Some((low, high)) = bounds {
            let bounds = (low - origin, high - origin);
            let name = format!("object.{index}");
            say_if_coarse(&name, bounds, source, notes);
            let bounds = (bounds.0.as_vec3(), bounds.1.as_vec3());
            placing.add_bounds(object, bounds).map_err(|what| {
                source
                    .error(&format!("{name}.scale"), what)
                    .fix("the world ends at 1e9 units: lower its scale, or move it nearer")
            })?;
        }
        placing.digests.push(entry.digest);
        placing.files.push(entry.model.files.clone());
        placing.add(object, entry, mover, &pose);
    }
    let bounds = placing.subject.or(placing.all);
    let bounds = bounds.unwrap_or((Vec3::NEG_ONE, Vec3::ONE));
    Ok(Placed {
        view: View::new(shot, source, bounds, origin, &placing.cameras)?,
        movers: placing.movers,
        scene: placing.scene,
        files: placing.files,
        digest: join(&placing.digests),
        triangles: placing.triangles,
        owners: placing.owners,
    })
}

/// Warns where an object is so far from the origin that 32 bits do not hold its shape.
fn say_if_coarse(name: &str, (low, high): (DVec3, DVec3), source: &Source, notes: &mut Notes) {
    let step = low.abs().max(high.abs()).max_element() * f64::from(f32::EPSILON);
    let size = (high - low).max_element();
    if size > 0.0 && step * 4096.0 > size {
        let what = format!(
            "{name} is {size:.3} units large and so far from the others that its points are rounded to {step:.3}; move it nearer"
        );
        notes.warn(&source.file, what);
    }
}

/// The objects of a shot that are placed so far.
#[derive(Default)]
struct Placing {
    scene: SceneDescription,
    movers: Vec<Mover>,
    /// Which of the shot's objects each object of the scene is a part of.
    owners: Vec<usize>,
    cameras: Vec<FileCamera>,
    files: Vec<Vec<PathBuf>>,
    digests: Vec<Hash>,
    triangles: usize,
    /// Bounds of all objects.
    all: Option<(Vec3, Vec3)>,
    /// Bounds of those that a camera looks at when a shot does not say.
    subject: Option<(Vec3, Vec3)>,
}

impl Placing {
    /// Adds the parts and the cameras of the shot's next object.
    fn add(&mut self, object: &shot::Object, entry: &Loaded, mover: Mover, pose: &NodePose) {
        let index = self.movers.len();
        let model = &entry.model;
        let scene = &mut self.scene;
        let material = object.material.as_ref().map(|m| {
            scene.materials.push(Material::from(Reflection::BlinnPhong {
                diffuse: m.diffuse.into(),
                specular: m.specular.into(),
                exponent: m.exponent,
            }));
            scene.materials.len() as u32 - 1
        });
        let places = model.parts.iter().zip(mover.parts_at(pose));
        for ((part, transform), deformed) in places.zip(mover.meshes_at(pose)) {
            let mut mesh = entry.first_mesh + part.mesh as u32;
            if let Some(deformed) = deformed {
                let materials = scene.meshes[mesh as usize].materials.clone();
                mesh = scene.meshes.len() as u32;
                scene.meshes.push(Mesh {
                    materials,
                    ..deformed
                });
            }
            self.triangles += scene.meshes[mesh as usize].indices.len();
            scene.objects.push(Object {
                mesh,
                transform,
                material,
                catcher: object.catcher,
            });
        }
        self.owners.resize(scene.objects.len(), index);
        let cameras = model.cameras.iter().map(|camera| FileCamera {
            name: camera.name.clone(),
            object: index,
            node: camera.node,
            fov_y: camera.fov_y,
        });
        self.cameras.extend(cameras);
        self.movers.push(mover);
    }

    /// Extends the bounds by those of an object, or says how it lies beyond the world's end.
    fn add_bounds(
        &mut self,
        object: &shot::Object,
        bounds: (Vec3, Vec3),
    ) -> std::result::Result<(), String> {
        let reach = bounds.0.abs().max(bounds.1.abs()).max_element();
        if !(reach <= MAX_COORDINATE) {
            return Err(format!(
                "the object reaches {reach:.1e} units from the origin"
            ));
        }
        grow(&mut self.all, bounds);
        // What is in the footage already is as little the subject as a floor.
        if object.mesh != "plane" && !object.catcher {
            grow(&mut self.subject, bounds);
        }
        Ok(())
    }
}

/// Cuts the triangles of a model, which the shot's object `index` stands for.
fn cut(model: &mut Model, times: u32, index: usize, source: &Source) -> Result<()> {
    let of_mesh = model.meshes.iter().map(|mesh| mesh.indices.len() as u64);
    let before = of_mesh.sum();
    let after = triangles_after(before, times);
    if times > 0 && after > MOST_TRIANGLES {
        let what =
            format!("it would make {after} triangles of {before}, more than {MOST_TRIANGLES}");
        return Err(source
            .error(&format!("object.{index}.subdivide"), what)
            .fix("lower it: each step makes four triangles of one"));
    }
    for (index, mesh) in model.meshes.iter_mut().enumerate() {
        // Others are cut once they are deformed.
        if !model.deforms.contains_key(&index) {
            subdivide(mesh, times);
        }
    }
    Ok(())
}

/// A model whose meshes are in the scene, from `first_mesh` on.
struct Loaded {
    model: Model,
    /// Of its files.
    digest: Hash,
    first_mesh: u32,
}

impl Loaded {
    /// Moves a model's lists into the scene, and makes their indices the scene's.
    fn new(mut model: Model, digest: Hash, scene: &mut SceneDescription) -> Self {
        let first_mesh = scene.meshes.len() as u32;
        let first_material = scene.materials.len() as u32;
        let first_texture = scene.textures.len() as u32;
        for material in &mut model.materials {
            for texture in material.textures_mut() {
                texture.texture += first_texture;
            }
        }
        // The model keeps its meshes for bounds and counts; materials and textures are the scene's from here on.
        scene.materials.append(&mut model.materials);
        scene.textures.append(&mut model.textures);
        scene
            .meshes
            .extend(model.meshes.iter().cloned().map(|mut mesh| {
                for material in &mut mesh.materials {
                    *material += first_material;
                }
                mesh
            }));
        Self {
            model,
            digest,
            first_mesh,
        }
    }
}

fn grow(bounds: &mut Option<(Vec3, Vec3)>, (low, high): (Vec3, Vec3)) {
    let (a, b) = bounds.unwrap_or((low, high));
    *bounds = Some((a.min(low), b.max(high)));
}

/// Bounds of a model in the world, in 64 bits.
fn bounds(model: &Model, pose: &NodePose, to_world: DMat4) -> Option<(DVec3, DVec3)> {
    let place = to_world.w_axis.truncate();
    let turned = DMat4::from_mat3(DMat3::from_mat4(to_world)).as_mat4();
    let (low, high) = model.bounds(pose, turned)?;
    Some((place + low.as_dvec3(), place + high.as_dvec3()))
}

/// From the model's origin: to the world's axes, scaled, turned about x, y, z (fixed axes), set on the ground, moved.
fn transform(object: &shot::Object, model: &Model, pose: &NodePose) -> DMat4 {
    let default_up = if model.z_up { Up::Z } else { Up::Y };
    let up = match object.up.unwrap_or(default_up) {
        Up::Y => DMat4::from_mat3(DMat3::from_cols(DVec3::X, DVec3::Z, DVec3::NEG_Y)),
        Up::Z => DMat4::IDENTITY,
    };
    let [x, y, z] = object.rotate_deg.map(|angle| f64::from(angle).to_radians());
    // Fixed axes x, y, z in this order are the moving axes z, y, x.
    let rotation = DMat4::from_quat(DQuat::from_euler(EulerRot::ZYX, z, y, x));
    let scale = DMat4::from_scale(DVec3::splat(f64::from(object.scale)));
    let turned = rotation * scale * up * DMat4::from_translation(model.origin);
    let mut translate = DVec3::from(object.translate);
    if object.ground
        && let Some((low, _)) = bounds(model, pose, turned)
    {
        translate.z -= low.z;
    }
    DMat4::from_translation(translate) * turned
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn turns_about_fixed_axes_in_order() {
        let object = shot::Object {
            rotate_deg: [90.0, 0.0, 90.0],
            scale: 2.0,
            translate: [0.0, 0.0, 1.0],
            up: Some(Up::Z),
            ..shot::Object::default()
        };
        let matrix = transform(&object, &Model::default(), &Model::default().rest());
        // y → z by the turn about x, and stays so about z; x → y about z.
        let y = matrix.transform_point3(DVec3::Y);
        assert!((y - DVec3::new(0.0, 0.0, 3.0)).length() < 1e-12, "{y}");
        let x = matrix.transform_point3(DVec3::X);
        assert!((x - DVec3::new(0.0, 2.0, 1.0)).length() < 1e-12, "{x}");
    }

    #[test]
    fn y_up_becomes_z_up() {
        let model = Model::default();
        let matrix = transform(&shot::Object::default(), &model, &model.rest());
        assert_eq!(matrix.transform_point3(DVec3::Y), DVec3::Z);
        assert_eq!(matrix.transform_point3(DVec3::Z), DVec3::NEG_Y);
    }
}
