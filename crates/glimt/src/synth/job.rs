//! Host file: `glimt synth`, from its arguments to the files.

use super::check;
use super::film::Filming;
use super::geometry::FrameTruth;
use super::settings::{PlateFormat, Synth};
use super::truth::{mask, shot_toml, truth_json};
use super::world::World;
use crate::cli::SynthFlags;
use crate::colour::primaries::REC_709;
use crate::device::{self, Processor};
use crate::error::{Error, Result};
use crate::input::Reading;
use crate::input::light_image::{LightImage, read_all_directions};
use crate::input::plate;
use crate::interrupt;
use crate::light::check_shape;
use crate::notes::Notes;
use crate::output::atomic::Folder;
use crate::output::exr::Storage;
use crate::output::target::Guard;
use crate::output::{Stamp, exr, png, write_editable, write_text};
use crate::printable::path_in_line;
use crate::report::{FrameStatus, Reporter, count, shown};
use crate::shot::digest::{self, Hash};
use crate::shot::{Mapping, parse, range};
use glam::UVec2;
use glimt_render_gpu::generated::digests;
use rayon::prelude::*;
use serde_json::json;
use sha2::{Digest, Sha256};
use std::path::{Path, PathBuf};
use std::time::Instant;

/// Films what the arguments say and writes it. Frames that are there already, of the same identity, are skipped.
///
/// # Errors
/// The first thing that fails; all frames written before it stay, whole.
pub fn run(input: Option<&Path>, flags: &SynthFlags, reporter: &Reporter) -> Result<()> {
    let began = Instant::now();
    let mut notes = Notes::new(flags.strict);
    let job = Job::load(input, flags, &mut notes);
    reporter.notes(notes.take());
    let job = job?;
    let synth = job.filming.synth();
    let current: Vec<bool> = job.frames.par_iter().map(|f| job.is_current(*f)).collect();
    job.check_targets(&current)?;
    let folder = Folder::claim(&job.out, flags.write.share)?;
    for (name, on) in [
        ("capture", synth.capture.on),
        ("plate", synth.plate.on),
        ("truth", true),
    ] {
        if on {
            folder.within(name)?;
        }
    }
    let processor = match current.iter().all(|c| *c) {
        true => None,
        false => Some(device::open_processor(flags.device)?),
    };
    let name = match &processor {
        None => "no device".to_owned(),
        Some(processor) => processor.name(),
    };
    reporter.start_filming(job.frames.len(), &job.out, &name);
    job.write_truth(reporter)?;
    let mut filmed = 0;
    for (done, (&frame, current)) in (1..).zip(job.frames.iter().zip(current)) {
        interrupt::check(|| format!("{} of {} frames are there", done - 1, job.frames.len()))?;
        let status = match &processor {
            Some(processor) if !current => {
                let began = Instant::now();
                job.film(processor, frame)?;
                filmed += 1;
                FrameStatus::Rendered(began.elapsed().as_secs_f64())
            }
            _ => FrameStatus::Skipped,
        };
        reporter.frame(frame.cast_signed(), status, done, job.frames.len());
    }
    let seconds = began.elapsed().as_secs_f64();
    let skipped = job.frames.len() - filmed;
    let summary = json!({
        "rendered": filmed, "skipped": skipped, "seconds": seconds, "out": shown(&job.out),
    });
    let text = format!(
        "{} filmed, {skipped} there already, in {seconds:.1} s: {}",
        count(filmed, "frame"),
        path_in_line(&job.out)
    );
    reporter.finish(summary, &text);
    Ok(())
}

/// What is filmed, and where it goes.
struct Job {
    filming: Filming,
    /// Hash of settings and maps.
    digest: Hash,
    frames: Vec<u32>,
    out: PathBuf,
    /// What may be written: nothing that is read.
    guard: Guard,
}

impl Job {
    fn load(input: Option<&Path>, flags: &SynthFlags, notes: &mut Notes) -> Result<Self> {
        let is_toml = |file: &Path| {
            file.extension()
                .is_some_and(|e| e.eq_ignore_ascii_case("toml"))
        };
        let settings = input.filter(|file| is_toml(file));
        let seed = flags.seed.iter().map(|seed| format!("seed={seed}"));
        let set: Vec<String> = seed.chain(flags.set.iter().cloned()).collect();
        let (mut synth, source) = match settings {
            Some(file) => parse::read::<Synth>(file, &set)?,
            None => parse::parse(Path::new("settings"), String::new(), &set)?,
        };
        let base = settings.and_then(Path::parent).unwrap_or(Path::new(""));
        let light = match input.filter(|file| !is_toml(file)) {
            Some(file) => {
                synth.light.map = file.to_string_lossy().into_owned();
                Some(file.to_owned())
            }
            None if synth.light.map.is_empty() => None,
            None => Some(base.join(&synth.light.map)),
        };
        check::check(&synth, &source)?;
        let frames: Vec<u32> = match &flags.frames {
            Some(text) => {
                let asked = range::parse(text).map_err(|e| e.at("--frames"))?;
                let last = synth.frames;
                let filmed = |frame: &i32| {
                    u32::try_from(*frame)
                        .ok()
                        .filter(|f| (1..=last).contains(f))
                };
                let frames: Option<Vec<u32>> = asked.iter().map(filmed).collect();
                frames.ok_or_else(|| {
                    Error::usage(format!("the capture has the frames 1-{last}"))
                        .at("--frames")
                        .fix("choose among them, or raise the key frames")
                })?
            }
            None => (1..=synth.frames).collect(),
        };
        let panorama = match synth.plate.panorama.as_str() {
            "" => None,
            name => Some(base.join(name)),
        };

        let mut hasher = Sha256::new();
        hasher.update(digest::VERSION.as_bytes());
        hasher.update(digests::SYNTH.as_bytes());
        let mut plain = synth.clone();
        // Contents count, not names.
        plain.light.map.clear();
        plain.plate.panorama.clear();
        plain.output = super::Output::default();
        hasher.update(serde_json::to_vec(&plain).expect("settings are plain data"));
        let mut guard = Guard::new(flags.write.overwrite);
        guard.reads_all("the settings", settings.map(Path::to_owned));
        guard.reads_all("the light map", light.clone());
        guard.reads_all("the panorama", panorama.clone());
        let map = light.map(|file| read_light(&file, notes)).transpose()?;
        let panorama = panorama.map(|file| read_panorama(&file)).transpose()?;
        for read in [&map, &panorama] {
            hasher.update(read.as_ref().map_or([0; 32], |read| read.hash));
        }
        let [map, panorama] = [map, panorama].map(|read| read.map(|read| (read.size, read.pixels)));
        let out = flags.out.clone();
        Ok(Self {
            out: out.unwrap_or_else(|| base.join(&synth.output.dir)),
            filming: Filming::new(synth, map, panorama),
            digest: hasher.finalize().into(),
            frames,
            guard,
        })
    }

    fn stamp(&self, frame: u32) -> Stamp {
        let frame_hash = digest::join([&self.digest, &Sha256::digest(frame.to_le_bytes()).into()]);
        Stamp {
            hash: digest::hex(&frame_hash),
            frame: frame.cast_signed(),
        }
    }

    fn ball_file(&self, frame: u32) -> PathBuf {
        self.out.join(format!("capture/ball.{frame:04}.exr"))
    }

    fn plate_file(&self, frame: u32) -> PathBuf {
        let extension = match self.filming.synth().plate.format {
            PlateFormat::Png => "png",
            PlateFormat::Exr => "exr",
        };
        self.out.join(format!("plate/plate.{frame:04}.{extension}"))
    }

    fn map_file(&self, frame: u32) -> PathBuf {
        self.out.join(format!("truth/latlong.{frame:04}.exr"))
    }

    fn is_current(&self, frame: u32) -> bool {
        let hash = Some(self.stamp(frame).hash);
        let plate = &self.filming.synth().plate;
        let plate_there = || match plate.format {
            PlateFormat::Png => png::read_hash(&self.plate_file(frame)) == hash,
            PlateFormat::Exr => exr::read_hash(&self.plate_file(frame), &[]) == hash,
        };
        let ball_there = || exr::read_hash(&self.ball_file(frame), &[]) == hash;
        (!self.filming.synth().capture.on || ball_there())
            && exr::read_hash(&self.map_file(frame), &[]) == hash
            && (!plate.on || plate_there())
    }

    /// Sees that what is to be written may be.
    fn check_targets(&self, current: &[bool]) -> Result<()> {
        let synth = self.filming.synth();
        for name in ["truth/truth.json", "truth/mask.png"] {
            self.guard.target(&self.out.join(name))?;
        }
        for (&frame, _) in self
            .frames
            .iter()
            .zip(current)
            .filter(|(_, current)| !**current)
        {
            for (file, on) in [
                (self.ball_file(frame), synth.capture.on),
                (self.plate_file(frame), synth.plate.on),
                (self.map_file(frame), true),
            ] {
                if on {
                    self.guard.target(&file)?;
                }
            }
        }
        Ok(())
    }

    /// What does not depend on filming: the numbers of all frames, the mask, and the shot.
    fn write_truth(&self, reporter: &Reporter) -> Result<()> {
        let synth = self.filming.synth();
        let truth: Vec<FrameTruth> = (1..=synth.frames)
            .map(|frame| self.filming.truth_of(frame))
            .collect();
        let json = serde_json::to_string_pretty(&truth_json(synth, &truth))
            .expect("numbers are plain data");
        let target = |name: &str| self.guard.target(&self.out.join(name));
        write_text(&target("truth/truth.json")?, &json)?;
        let shot = self.out.join("shot.toml");
        write_editable(&self.guard, &shot, &shot_toml(synth), reporter)?;
        let size = UVec2::from(synth.truth.size);
        png::write_mask(&target("truth/mask.png")?, size, &mask(synth, size))
    }

    fn film(&self, processor: &Processor, frame: u32) -> Result<()> {
        let (filming, stamp) = (&self.filming, self.stamp(frame));
        let synth = filming.synth();
        let world: World = filming.world(frame);
        if synth.capture.on {
            let ball = filming.film_frame(processor, &world, frame)?;
            let storage = match (synth.capture.half, synth.noise.exposures) {
                (true, _) => Storage::Half,
                (false, 0) => Storage::Float,
                (false, _) => Storage::Noisy,
            };
            let file = self.guard.target(&self.ball_file(frame))?;
            exr::write_rgb(&file, ball.size, &ball.pixels, &stamp, storage)?;
        }
        let size = UVec2::from(synth.truth.size);
        let map = filming.truth_map(processor, &world, frame, size)?;
        let file = self.guard.target(&self.map_file(frame))?;
        exr::write_rgb(&file, size, &map, &stamp, Storage::Float)?;
        if synth.plate.on {
            let plate = filming.film_plate(processor, &world, frame)?;
            let file = self.guard.target(&self.plate_file(frame))?;
            match synth.plate.format {
                PlateFormat::Png => png::write(&file, &plate, 1.0, &stamp)?,
                PlateFormat::Exr => {
                    exr::write_rgb(&file, plate.size, &plate.linear, &stamp, Storage::Float)?;
                }
            }
        }
        Ok(())
    }
}

/// Reads a lat-long map of light.
fn read_light(file: &Path, notes: &mut Notes) -> Result<LightImage> {
    let image = read_all_directions(file, &Reading::default(), notes)?;
    check_shape(Mapping::LatLong, image.size, file, notes)?;
    Ok(image)
}

/// Reads a display-referred lat-long picture; its sRGB curve is undone.
fn read_panorama(file: &Path) -> Result<LightImage> {
    let image = plate::read(file, &Reading::default(), &mut Notes::default())?;
    let matrix = image.primaries.colour_matrix_to(&REC_709);
    let linear = image.colours.into_linear();
    Ok(LightImage {
        size: image.size,
        pixels: linear.iter().map(|c| matrix.apply(c.extend(1.0))).collect(),
        hash: image.hash,
    })
}
