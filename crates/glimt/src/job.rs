//! Host file: what there is to render: a shot file or the built-in shot, loaded and checked, ready for the pipeline.

use crate::capture::colour;
use crate::cli::RenderFlags;
use crate::demo;
use crate::error::{Error, Kind, Result};
use crate::input::footage::{self, Footage};
use crate::input::frames::FrameFiles;
use crate::input::probe::Probe;
use crate::mesh::place;
use crate::notes::Notes;
use crate::report::Reporter;
use crate::shot::digest::{self, Hash};
use crate::shot::parse::Source;
use crate::shot::{self, Shot, check, parse, range};
use glam::UVec2;
use glimt_render_gpu::host::env::PreparedEnv;
use glimt_render_gpu::host::plate::Plate;
use glimt_render_gpu::host::render::{
    Background, Filter, Method, Pattern, RenderSettings, SettingsError, Shadow, Tonemap,
};
use glimt_render_gpu::host::scene::{Camera, SceneDescription};
use glimt_render_gpu::host::scene_error::SceneError;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// Everything that rendering a shot needs.
pub struct Job {
    /// The shot, with all its keys.
    pub shot: Shot,
    /// What stands in it.
    pub scene: SceneDescription,
    /// Triangles, counting each placing of a mesh.
    pub triangles: usize,
    /// Hash of the shot and its meshes.
    pub digest: Hash,
    /// The frames to render, in order.
    pub frames: Vec<u32>,
    /// Whether these are all frames of the shot.
    pub whole: bool,
    /// Folder of the outputs.
    pub out: PathBuf,
    light: Light,
    footage: Option<Footage>,
    view: View,
    source: Source,
    /// Which of the shot's objects each object of the scene is a part of.
    owners: Vec<usize>,
}

/// Where the light comes from.
enum Light {
    Probe(Probe),
    Demo,
}

/// Where a frame is seen from.
enum View {
    Fixed(Camera),
    Demo,
}

impl Job {
    /// Loads a shot file, with the flags of the command line applied.
    ///
    /// # Errors
    /// The shot is wrong, or something that it names.
    pub fn from_file(
        file: &Path,
        flags: &RenderFlags,
        notes: &mut Notes,
        reporter: &Reporter,
    ) -> Result<Self> {
        let (mut shot, source) = parse::read(file, &overrides(flags))?;
        let base = file.parent().unwrap_or(Path::new(""));
        footage::adopt_size(&mut shot, &source, base)?;
        check::check(&shot, &source)?;

        let files = FrameFiles::new(base, &shot.probe.frames).map_err(|e| {
            source
                .error("probe.frames", e.what)
                .fix(e.fix.unwrap_or_default())
        })?;
        let footage = Footage::find(&shot, &source, base, &files, notes)?;
        let (frames, whole) = choose_frames(&shot, &files, footage.as_ref(), flags, notes)?;
        if let Some(footage) = &footage {
            footage.require(&frames, UVec2::from(shot.image.size), notes)?;
        }
        let found = |done| reporter.stage("looking for the ball", done, frames.len());
        let mut probe = Probe::open(files, &frames, &shot.probe, notes, &found)?;
        if let Some(keys) = &shot.probe.colour {
            let frame = keys.frame.unwrap_or(frames[0]);
            let plate = footage.as_ref().map(|footage| footage.file(frame));
            let photo = probe.file(frame);
            let colour = colour::correction(keys, &source, &photo, plate.as_deref(), notes)?;
            probe.set_colour(colour);
        }
        let placed = place::place(&shot, &source, base, notes)?;
        let job = Self {
            digest: digest::join([&digest::of_shot(&shot), &placed.digest]),
            triangles: placed.triangles,
            frames,
            whole,
            out: out_folder(flags, base.join(&shot.output.dir)),
            scene: placed.scene,
            light: Light::Probe(probe),
            footage,
            view: View::Fixed(placed.camera),
            owners: placed.owners,
            source,
            shot,
        };
        job.check_settings()?;
        Ok(job)
    }

    /// The renderer's own checks, told with the key that they are about.
    fn check_settings(&self) -> Result<()> {
        let refused = |e: SettingsError| {
            let key = match e {
                SettingsError::Empty => "image",
                SettingsError::NoSamples | SettingsError::TooMany => "render",
                SettingsError::Exposure => "image.exposure_ev",
                SettingsError::FieldOfView => "camera.fov_x_deg",
                SettingsError::Camera => "camera",
                SettingsError::PlateSize => "backplate",
            };
            self.source.error(key, e)
        };
        self.settings(self.frames[0])
            .frame_params()
            .map(drop)
            .map_err(refused)
    }

    /// The built-in shot, with the flags of the command line applied.
    ///
    /// # Errors
    /// The flags are wrong, or change what is built in.
    pub fn demo(flags: &RenderFlags) -> Result<Self> {
        let name = Path::new("built-in shot");
        let (shot, source) = parse::parse(name, demo_shot(), &overrides(flags))?;
        check::check(&shot, &source)?;
        let (plain, _) = parse::parse(name, demo_shot(), &[])?;
        let fixed = |s: &Shot| {
            let probe = shot::Probe {
                fps: 1.0,
                ..s.probe.clone()
            };
            (
                probe,
                s.objects.clone(),
                s.camera.clone(),
                s.backplate.clone(),
            )
        };
        if fixed(&shot) != fixed(&plain) {
            return Err(Error::usage(
                "the demo's light, objects, camera and background are built in",
            )
            .fix("set keys of image, render and output only, or write a shot file"));
        }
        let all = range::parse(&shot.render.frames)?;
        let asked = flags
            .frames
            .as_deref()
            .map_or(Ok(all.clone()), range::parse)?;
        let last = demo::FRAMES;
        if *asked.start() < 1 || *asked.end() > last {
            return Err(Error::usage(format!("the demo has the frames 1-{last}"))
                .fix(format!("choose among them with --frames, as 1-{last}")));
        }
        let scene = demo::scene();
        let triangle_count = |object: &glimt_render_gpu::host::scene::Object| {
            scene.meshes[object.mesh as usize].indices.len()
        };
        Ok(Self {
            digest: digest::of_shot(&shot),
            triangles: scene.objects.iter().map(triangle_count).sum(),
            whole: asked == all,
            frames: asked.collect(),
            out: out_folder(flags, PathBuf::from(&shot.output.dir)),
            scene,
            light: Light::Demo,
            footage: None,
            view: View::Demo,
            owners: Vec::new(),
            source,
            shot,
        })
    }

    /// What the renderer says of the scene, with the object of the shot that it is about.
    pub fn refused_scene(&self, error: &SceneError) -> Error {
        let told = match error {
            SceneError::NoTriangles { .. } => self
                .source
                .error("object", "all objects are too small to be seen")
                .fix("raise their scale"),
            SceneError::Transform { object } | SceneError::Position { object, .. } => {
                let index = self.owners.get(*object).copied().unwrap_or(*object);
                let key = format!("object.{index}");
                let what = "it is flattened to nothing, or reaches beyond 1e9 units";
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

    /// Settings of a frame.
    pub fn settings(&self, frame: u32) -> RenderSettings {
        let (image, render) = (&self.shot.image, &self.shot.render);
        RenderSettings {
            size: UVec2::from(image.size),
            camera: match &self.view {
                View::Fixed(camera) => *camera,
                View::Demo => demo::camera(frame - 1),
            },
            rays_per_pixel: image.rays_per_pixel,
            brdf_samples: render.brdf_samples,
            env_samples: render.env_samples,
            method: Method::Mis,
            pattern: match render.pattern {
                shot::Pattern::OwenSobol => Pattern::OwenSobol,
                shot::Pattern::Independent => Pattern::Independent,
                shot::Pattern::Stratified => Pattern::Stratified,
            },
            filter: match image.filter {
                shot::Filter::Box => Filter::Box,
                shot::Filter::Centre => Filter::Centre,
            },
            background: match image.background {
                shot::Background::Environment => Background::Environment,
                shot::Background::Transparent => Background::Transparent,
            },
            seed: render.seed,
            frame,
            exposure_ev: image.exposure_ev,
            tonemap: match image.tonemap {
                shot::Tonemap::Srgb => Tonemap::Srgb,
                shot::Tonemap::Reinhard => Tonemap::Reinhard,
            },
            shadow: match self.shot.backplate.as_ref().map(|plate| plate.shadow) {
                Some(shot::Shadow::Add) => Shadow::Add,
                Some(shot::Shadow::Multiply) | None => Shadow::Multiply,
            },
            layers: !self.shot.output.aovs.is_empty(),
        }
    }

    /// Whether every frame has the same light.
    pub fn is_still(&self) -> bool {
        matches!(&self.light, Light::Probe(probe) if probe.is_still())
    }

    /// Reads the light of a frame for what there is to say about it alone.
    ///
    /// # Errors
    /// As [`Job::light`].
    pub fn check_light(&self, frame: u32, notes: &mut Notes) -> Result<()> {
        match &self.light {
            Light::Probe(probe) => probe.load(frame, notes).map(drop),
            Light::Demo => Ok(()),
        }
    }

    /// The light of a frame, with its tables.
    ///
    /// # Errors
    /// It cannot be read.
    pub fn light(&self, frame: u32, notes: &mut Notes) -> Result<PreparedEnv> {
        let began = Instant::now();
        let map = match &self.light {
            Light::Probe(probe) => probe.load(frame, notes)?,
            Light::Demo => demo::environment(frame - 1, demo::ENV_SIZE)
                .map_err(|e| Error::new(Kind::Internal, e))?,
        };
        let read = began.elapsed();
        let prepared = map.prepare(self.shot.probe.rotate_z_deg).map_err(|e| {
            let error = Error::new(Kind::Input, e);
            match &self.light {
                Light::Probe(probe) => error.file(&probe.file(frame)),
                Light::Demo => error,
            }
        });
        let tables = began.elapsed() - read;
        tracing::info!("light of frame {frame}: read in {read:.2?}, tables in {tables:.2?}");
        prepared
    }

    /// Whether frames are laid over footage.
    pub fn has_plate(&self) -> bool {
        self.footage.is_some()
    }

    /// Whether every frame has the same footage, or none.
    pub fn is_still_plate(&self) -> bool {
        self.footage.as_ref().is_none_or(Footage::is_still)
    }

    /// The footage behind a frame, if there is any.
    ///
    /// # Errors
    /// It cannot be read.
    pub fn plate(&self, frame: u32, notes: &mut Notes) -> Result<Option<Plate>> {
        let Some(footage) = &self.footage else {
            return Ok(None);
        };
        let began = Instant::now();
        let size = UVec2::from(self.shot.image.size);
        let plate = footage.load(frame, size, notes)?;
        tracing::info!("plate of frame {frame}: read in {:.2?}", began.elapsed());
        Ok(Some(plate))
    }

    /// The identity of each frame, in the order of [`Job::frames`].
    ///
    /// # Errors
    /// A file of the light or the footage cannot be read.
    pub fn identities(&self) -> Result<Vec<String>> {
        let mut inputs = match &self.light {
            Light::Demo => vec![[0; 32]; self.frames.len()],
            Light::Probe(probe) => probe.digests(&self.frames)?,
        };
        if let Some(footage) = &self.footage {
            let plates = footage.digests(&self.frames)?;
            for (input, plate) in inputs.iter_mut().zip(&plates) {
                *input = digest::join([&*input, plate]);
            }
        }
        let pairs = inputs.iter().zip(&self.frames);
        Ok(pairs
            .map(|(input, &frame)| digest::of_frame(&self.digest, input, frame))
            .collect())
    }
}

/// The flags that are keys of the shot, before those given by --set.
fn overrides(flags: &RenderFlags) -> Vec<String> {
    let method = flags.method.iter().map(|m| format!("render.method={m}"));
    let seed = flags.seed.iter().map(|s| format!("render.seed={s}"));
    method
        .chain(seed)
        .chain(flags.set.iter().cloned())
        .collect()
}

fn out_folder(flags: &RenderFlags, of_shot: PathBuf) -> PathBuf {
    flags.out.clone().unwrap_or(of_shot)
}

/// The frames to render, and whether they are all of the shot's: those that it names, or all that light and footage both have.
fn choose_frames(
    shot: &Shot,
    files: &FrameFiles,
    footage: Option<&Footage>,
    flags: &RenderFlags,
    notes: &mut Notes,
) -> Result<(Vec<u32>, bool)> {
    let of_shot = match shot.render.frames.as_str() {
        "" => match footage {
            Some(footage) => footage.shared(files, notes)?,
            None => {
                let there = files.existing()?;
                there[0]..=there[there.len() - 1]
            }
        },
        text => range::parse(text)?,
    };
    let asked = match &flags.frames {
        Some(text) => range::parse(text).map_err(|e| e.at("--frames"))?,
        None => of_shot.clone(),
    };
    let frames = files.require(*asked.start(), *asked.end())?;
    Ok((frames, asked == of_shot))
}

/// The keys of the built-in shot; its light, objects and camera are functions.
fn demo_shot() -> String {
    let settings = demo::settings(0);
    let [width, height] = settings.size.to_array();
    format!(
        "[image]\nsize = [{width}, {height}]\nexposure_ev = {:?}\n\
         [probe]\nframes = \"built in\"\nfps = {}\n\
         [[object]]\nmesh = \"built in\"\n\
         [render]\nframes = \"1-{}\"\n\
         [output]\ndir = \"out\"\nvideo = \"demo.mp4\"\n",
        settings.exposure_ev,
        demo::FPS,
        demo::FRAMES,
    )
}
