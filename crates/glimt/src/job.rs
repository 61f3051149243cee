//! Host file: what there is to render: a shot file or the built-in shot, loaded and checked, ready for the pipeline.

use crate::capture::colour;
use crate::cli::RenderFlags;
use crate::demo;
use crate::error::{Error, Kind, Result};
use crate::input::footage::{self, Footage};
use crate::input::frames::FrameFiles;
use crate::input::probe::Probe;
use crate::notes::Notes;
use crate::report::Reporter;
use crate::setup::{self, Setup, View};
use crate::shot::digest;
use crate::shot::parse::Source;
use crate::shot::{self, Shot, check, parse, range};
use glam::UVec2;
use glimt_render_gpu::host::env::PreparedEnv;
use glimt_render_gpu::host::plate::Plate;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// Everything that rendering a shot needs.
pub struct Job {
    /// What stays the same in all frames.
    pub setup: Setup,
    /// The frames to render, in order.
    pub frames: Vec<u32>,
    /// Whether these are all frames of the shot.
    pub whole: bool,
    light: Light,
    footage: Option<Footage>,
}

/// Where the light comes from.
enum Light {
    Probe(Probe),
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
        let (mut shot, source) = parse::read(file, &setup::overrides(flags))?;
        let base = file.parent().unwrap_or(Path::new(""));
        footage::adopt_size(&mut shot, &source, base)?;
        check::check(&shot, &source)?;

        let files = probe_files(&shot, &source, base)?;
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
            let missing = [Some(&photo), plate.as_ref()]
                .into_iter()
                .flatten()
                .find(|file| keys.frame.is_some() && !file.is_file());
            if let Some(file) = missing {
                return Err(source
                    .error(
                        "probe.colour.frame",
                        format!("{} is not there", file.display()),
                    )
                    .fix("choose a frame that probe and backplate have, or leave it out for the first"));
            }
            let colour = colour::correction(keys, &source, &photo, plate.as_deref(), notes)?;
            probe.set_colour(colour);
        }
        let job = Self {
            setup: Setup::load(shot, source, base, flags, notes)?,
            frames,
            whole,
            light: Light::Probe(probe),
            footage,
        };
        job.setup.check_settings(job.frames[0])?;
        Ok(job)
    }

    /// The built-in shot, with the flags of the command line applied.
    ///
    /// # Errors
    /// The flags are wrong, or change what is built in.
    pub fn demo(flags: &RenderFlags) -> Result<Self> {
        let name = Path::new("built-in shot");
        let (shot, source) = parse::parse(name, demo_shot(), &setup::overrides(flags))?;
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
            whole: asked == all,
            frames: asked.collect(),
            light: Light::Demo,
            footage: None,
            setup: Setup {
                digest: digest::of_shot(&shot),
                triangles: scene.objects.iter().map(triangle_count).sum(),
                out: setup::out_folder(flags, PathBuf::from(&shot.output.dir)),
                scene,
                view: View::Demo,
                owners: Vec::new(),
                source,
                shot,
            },
        })
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
        let file = match &self.light {
            Light::Probe(probe) => Some(probe.file(frame)),
            Light::Demo => None,
        };
        let prepared = self.setup.tables(map, file.as_deref());
        let tables = began.elapsed() - read;
        tracing::info!("light of frame {frame}: read in {read:.2?}, tables in {tables:.2?}");
        prepared
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
        let plate = footage.load(frame, self.setup.size(), notes)?;
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
            .map(|(input, &frame)| digest::of_frame(&self.setup.digest, input, frame))
            .collect())
    }
}

/// The files of the shot's light.
///
/// # Errors
/// They cannot be named so.
pub fn probe_files(shot: &Shot, source: &Source, base: &Path) -> Result<FrameFiles> {
    FrameFiles::new(base, &shot.probe.frames).map_err(|e| {
        source
            .error("probe.frames", e.what)
            .fix(e.fix.unwrap_or_default())
    })
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
