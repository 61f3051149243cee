//! Host file: what a shot has that no frame changes: its keys, scene and settings, how things move, and where its outputs go.

use crate::cli::RenderFlags;
use crate::colour::primaries::{Primaries, REC_709};
use crate::error::{Error, Kind, Result};
use crate::memory;
use crate::mesh::node::NodePose;
use crate::notes::Notes;
use crate::output::aov;
use crate::output::target::Guard;
use crate::scene::colours;
use crate::scene::place::{self, Mover};
use crate::scene::view::View;
use crate::shot::digest::{self, Hash};
use crate::shot::parse::Source;
use crate::shot::{Shot, check};
use glam::{Mat4, UVec2};
use glimt_render_gpu::prepare::env::{EnvMap, PreparedEnv};
use glimt_render_gpu::prepare::plate::Plate;
use glimt_render_gpu::prepare::render::{RenderSettings, SettingsError, Shadow};
use glimt_render_gpu::prepare::scene::{Camera, SceneDescription, Shape};
use glimt_render_gpu::prepare::scene_build::SceneBuffers;
use glimt_render_gpu::prepare::scene_error::SceneError;
use std::path::{Path, PathBuf};

/// Bytes at a triangle while its tree is built.
const TREE_BYTES: u64 = 500;

/// What stays the same in all frames of a shot.
pub struct Setup {
    /// The shot, with all its keys.
    pub shot: Shot,
    /// Where those were given.
    pub source: Source,
    /// What stands in it.
    pub scene: SceneDescription,
    /// Triangles, counting each placing of a mesh.
    pub triangles: usize,
    /// Hash of the shot and its meshes.
    pub digest: Hash,
    /// Folder of the outputs.
    pub out: PathBuf,
    /// The first frame of the shot, from which its motion is counted.
    pub first: i32,
    view: View,
    movers: Vec<Mover>,
    /// Which of the shot's objects each object of the scene is a part of.
    pub owners: Vec<usize>,
    /// What may be written: nothing that is read.
    pub guard: Guard,
    /// Hash of the file of transfer that is a part of `digest`, if it is.
    pub transfer: Option<Hash>,
    /// Whether all tables of the light are built, and not those alone that the shot's method reads.
    pub all_tables: bool,
}

/// Where everything stands in a frame.
#[derive(Clone, Debug, PartialEq)]
pub struct Pose {
    /// Where it is seen from.
    pub camera: Camera,
    /// From the mesh of each object of the scene to the world.
    pub transforms: Vec<Mat4>,
    /// The objects that are deformed then.
    pub shapes: Vec<Shape>,
}

impl Setup {
    /// Loads what a shot that has been checked names, but for light and footage. Its motion begins in the frame `first`; the
    /// scene is as it is then.
    ///
    /// # Errors
    /// A mesh cannot be read, or lacks what the shot names in it.
    pub fn load(
        shot: Shot,
        source: Source,
        first: i32,
        flags: &RenderFlags,
        notes: &mut Notes,
    ) -> Result<Self> {
        let mut placed = place::place(&shot, &source, notes)?;
        colours::convert(&mut placed.scene, &shot.image.primaries.primaries());
        let mut guard = Guard::new(flags.write.overwrite);
        guard.reads("the shot", &source.file);
        for (object, files) in placed.files.iter().enumerate() {
            for (i, file) in files.iter().enumerate() {
                let what = match i {
                    0 => format!("the mesh of object.{object}"),
                    _ => format!("a part of the mesh of object.{object}"),
                };
                guard.reads(&what, file);
            }
        }
        let moves = placed.movers.iter().any(|m| m.motion.is_moving());
        let clock = match moves {
            true => digest::of_text(&format!("{first} {:?}", shot.probe.fps)),
            false => [0; 32],
        };
        Ok(Self {
            digest: digest::join([&digest::of_shot(&shot), &placed.digest, &clock]),
            first,
            view: placed.view,
            movers: placed.movers,
            triangles: placed.triangles,
            out: out_folder(flags, source.folder().join(&shot.output.dir)),
            scene: placed.scene,
            owners: placed.owners,
            guard,
            transfer: None,
            all_tables: false,
            source,
            shot,
        })
    }

    /// Size of the image.
    pub fn size(&self) -> UVec2 {
        UVec2::from(self.shot.image.size)
    }

    /// Whether frames are laid over footage.
    pub fn has_plate(&self) -> bool {
        self.shot.backplate.is_some()
    }

    /// The primaries of an image over this plate: the plate's, or those that are rendered with.
    pub fn primaries_over(&self, plate: Option<&Plate>) -> Primaries {
        let of_plate = plate.and_then(Plate::primaries).map(Primaries);
        of_plate.unwrap_or(self.shot.image.primaries.primaries())
    }

    /// Where everything stands in a frame, whatever frames are rendered beside it.
    ///
    /// # Errors
    /// The camera sees nothing then.
    pub fn pose(&self, frame: i32) -> Result<Pose> {
        let poses = self.nodes_at(frame);
        let pairs = || self.movers.iter().zip(&poses);
        // What never moves keeps the shape that it has in the scene.
        let meshes = pairs().flat_map(|(mover, pose)| {
            let moves = mover.motion.is_moving();
            mover.parts.iter().map(move |part| {
                let deformer = part.deformer.as_ref().filter(|_| moves)?;
                Some(deformer.mesh_at(pose))
            })
        });
        let shapes = meshes.enumerate().filter_map(|(object, mesh)| {
            let mesh = mesh?;
            Some(Shape {
                object,
                positions: mesh.positions,
                normals: mesh.normals,
                tangents: mesh.tangents,
            })
        });
        Ok(Pose {
            camera: self.camera_among(frame, &poses)?,
            shapes: shapes.collect(),
            transforms: pairs().flat_map(|(m, pose)| m.parts_at(pose)).collect(),
        })
    }

    /// What moves, in words: each with the object of the shot that it belongs to.
    pub fn motions(&self) -> Vec<(usize, String)> {
        let all = self.movers.iter().enumerate();
        let each =
            all.flat_map(|(i, m)| m.motion.describe().into_iter().map(move |what| (i, what)));
        each.collect()
    }

    /// The first object of the shot of which more than a camera moves, the key that makes it, and what moves, in words.
    pub fn moving_object(&self) -> Option<(usize, &'static str, String)> {
        let mut all = self.movers.iter().enumerate();
        all.find_map(|(i, m)| m.motion.moving_part().map(|(key, what)| (i, key, what)))
    }

    /// Whether the camera moves.
    pub fn has_moving_camera(&self) -> bool {
        !matches!(self.view, View::Fixed(_))
    }

    /// From where a frame is seen.
    ///
    /// # Errors
    /// The camera sees nothing then.
    pub fn camera(&self, frame: i32) -> Result<Camera> {
        match &self.view {
            View::Model { .. } => self.camera_among(frame, &self.nodes_at(frame)),
            _ => self.camera_among(frame, &[]),
        }
    }

    /// How the nodes of each object's file stand in a frame.
    fn nodes_at(&self, frame: i32) -> Vec<NodePose> {
        let frames = i64::from(frame) - i64::from(self.first);
        let fps = self.shot.probe.fps;
        let movers = self.movers.iter();
        movers.map(|m| m.motion.nodes_at(frames, fps)).collect()
    }

    fn camera_among(&self, frame: i32, poses: &[NodePose]) -> Result<Camera> {
        let place = |object: usize, node: usize| {
            let to_file = poses[object].to_file[node];
            (self.movers[object].to_world * to_file.as_dmat4()).as_mat4()
        };
        self.view.at(frame, &self.source, place)
    }

    /// The tables of a light map, which came from `file`.
    ///
    /// # Errors
    /// The map is too large.
    pub fn tables(&self, map: EnvMap, file: Option<&Path>) -> Result<PreparedEnv> {
        let rotate = self.shot.probe.rotate_z_deg;
        let prepared = match self.shot.render.estimator() {
            _ if self.all_tables => map.prepare(rotate),
            Some(method) => map.prepare_for(&method, rotate),
            None => map.without_tables(rotate),
        };
        prepared.map_err(|e| {
            let error = Error::new(Kind::Input, e);
            match file {
                Some(file) => error.file(file),
                None => error,
            }
        })
    }

    /// The renderer's own checks, told with the key that they are about.
    ///
    /// # Errors
    /// A setting that it refuses.
    pub fn check_settings(&self, frame: i32) -> Result<()> {
        let refused = |e: SettingsError| {
            let key = match &e {
                SettingsError::Setting(setting) => return check::refused(&self.source, setting),
                SettingsError::Empty => "image",
                SettingsError::TooMany | SettingsError::Memory | SettingsError::Tables => "render",
                SettingsError::Exposure => "image.exposure_ev",
                SettingsError::FieldOfView => "camera.fov_x_deg",
                SettingsError::PixelAspect => "image.pixel_aspect",
                SettingsError::Camera => "camera",
                SettingsError::Harmonics(_) | SettingsError::NoTransfer => "render.prt",
                SettingsError::PlateSize => "backplate",
            };
            self.source.error(key, e)
        };
        self.settings(frame, self.camera(frame)?)
            .frame_params()
            .map(drop)
            .map_err(refused)
    }

    /// Builds what rays are traced in: the triangles with their tree.
    ///
    /// # Errors
    /// The renderer refuses the scene, or there is too little memory for it.
    pub fn build_scene(&self) -> Result<SceneBuffers> {
        let bytes = self.triangles as u64 * TREE_BYTES;
        let what = format!("the tree of {} triangles", self.triangles);
        memory::require(&what, bytes).map_err(|e| e.fix(memory::FIX))?;
        SceneBuffers::build(&self.scene).map_err(|e| self.refused_scene(self.first, &e))
    }

    /// What the renderer says of the scene in a frame, with the object of the shot that it is about.
    pub fn refused_scene(&self, frame: i32, error: &SceneError) -> Error {
        let told = match error {
            SceneError::NoTriangles { .. } => self
                .source
                .error(
                    "object",
                    format!("in frame {frame} all objects are too small to be seen"),
                )
                .fix("raise their scale"),
            SceneError::Transform { object } | SceneError::Position { object, .. } => {
                let index = self.owners.get(*object).copied().unwrap_or(*object);
                let key = format!("object.{index}");
                let what = format!(
                    "in frame {frame} it is flattened to nothing, or reaches beyond 1e9 units"
                );
                self.source
                    .error(&key, what)
                    .fix("check its scale, and the transforms in its mesh file")
            }
            other => self.source.error("object", other),
        };
        Error {
            kind: Kind::Input,
            ..told
        }
    }

    /// Settings of a frame that is seen from `camera`.
    pub fn settings(&self, frame: i32, camera: Camera) -> RenderSettings {
        Self::settings_of(&self.shot, frame, camera)
    }

    /// Settings of a frame of `shot` that is seen from `camera`.
    pub fn settings_of(shot: &Shot, frame: i32, camera: Camera) -> RenderSettings {
        let (image, render) = (&shot.image, &shot.render);
        RenderSettings {
            size: UVec2::from(image.size),
            camera,
            rays_per_pixel: image.rays_per_pixel,
            method: render.estimator().unwrap_or_default(),
            prt: render.prt.settings(),
            pattern: render.pattern,
            filter: image.filter,
            background: image.background,
            seed: render.seed,
            // A key of the random streams; that of a frame before 0 counts down from 2^32.
            frame: frame.cast_unsigned(),
            exposure_ev: image.exposure_ev,
            tonemap: image.tonemap,
            shadow: shot
                .backplate
                .as_ref()
                .map_or(Shadow::Multiply, |plate| plate.shadow),
            pixel_aspect: image.pixel_aspect,
            to_display: image.primaries.primaries().colour_matrix_to(&REC_709),
            layers: aov::any_layer(&shot.output.aovs),
            diagnostics: aov::any_diagnostic(&shot.output.aovs),
        }
    }
}

/// The flags that are keys of the shot, before those given by --set.
pub fn overrides(flags: &RenderFlags) -> Vec<String> {
    let method = flags.method.iter().map(|m| format!("render.method={m}"));
    let seed = flags.seed.iter().map(|s| format!("render.seed={s}"));
    method
        .chain(seed)
        .chain(flags.set.iter().cloned())
        .collect()
}

/// Where outputs go: as the flags say, else as the shot does.
pub fn out_folder(flags: &RenderFlags, of_shot: PathBuf) -> PathBuf {
    flags.out.clone().unwrap_or(of_shot)
}
