//! Host file: the lights that `glimt sh` projects: a sequence, files, or what lights a shot.

use crate::cli::ShFlags;
use crate::error::{Error, Result};
use crate::input::footage;
use crate::input::frames::FrameFiles;
use crate::input::probe::Probe;
use crate::job::probe_files;
use crate::notes::Notes;
use crate::shot::{self, Shot, check, parse, range};
use glam::Mat3;
use glimt_render_gpu::host::env::EnvMap;
use std::path::{Path, PathBuf};

/// What becomes of missing frames.
const NOT_THERE: &str = "there are no coefficients of what is not there";

/// Lights in the order in which they are projected.
pub(super) struct Lights {
    /// Each with the number of its frame, and where it is read.
    frames: Vec<(u32, usize)>,
    probes: Vec<Probe>,
    turn: Option<Mat3>,
}

impl Lights {
    /// Finds them and reads their headers.
    pub(super) fn open(
        inputs: &[PathBuf],
        flags: &ShFlags,
        notes: &mut Notes,
        progress: &(dyn Fn(usize, usize) + Sync),
    ) -> Result<Self> {
        if let [file] = inputs {
            let extension = file.extension().unwrap_or_default();
            if extension.eq_ignore_ascii_case("toml") {
                return Self::of_shot(file, flags, notes, progress);
            }
        }
        let keys = shot::Probe::default();
        let files = inputs
            .iter()
            .map(|input| FrameFiles::new(Path::new(""), &input.to_string_lossy()))
            .collect::<Result<Vec<_>>>()?;
        if let [sequence] = &files[..]
            && !sequence.is_still()
        {
            let frames = frames_of(sequence, flags.frames.as_deref())?;
            sequence.tell_gaps(&frames, NOT_THERE, notes);
            let range = frames[0]..=frames[frames.len() - 1];
            let probe = Probe::open(sequence.clone(), &frames, range, &keys, notes, progress)?;
            return Ok(Self::of_probe(probe, frames, 0.0));
        }
        if let Some(sequence) = files.iter().find(|files| !files.is_still()) {
            return Err(Error::usage(format!(
                "`{}` is a sequence, and there are other lights beside it",
                sequence.pattern()
            ))
            .fix("give one sequence, or files alone"));
        }
        if flags.frames.is_some() {
            return Err(
                Error::usage("--frames chooses frames of a sequence, and these are files")
                    .fix("leave it out, or name a sequence as 'light.####.exr'"),
            );
        }
        let probes = files.into_iter().map(|file| {
            file.require(1, 1)?;
            Probe::open(file, &[1], 1..=1, &keys, notes, progress)
        });
        let probes = probes.collect::<Result<Vec<_>>>()?;
        Ok(Self {
            frames: (1..).zip(0..probes.len()).collect(),
            probes,
            turn: None,
        })
    }

    /// The light of a shot, as its keys say: mapping, scale and turn. Its colours stay the probe's.
    fn of_shot(
        file: &Path,
        flags: &ShFlags,
        notes: &mut Notes,
        progress: &(dyn Fn(usize, usize) + Sync),
    ) -> Result<Self> {
        let (mut shot, source): (Shot, _) = parse::read(file, &[])?;
        let base = file.parent().unwrap_or(Path::new(""));
        footage::adopt_size(&mut shot, &source, base)?;
        check::check(&shot, &source)?;
        let files = probe_files(&shot, &source, base)?;
        if shot.probe.colour.is_some() {
            notes.warn(
                file,
                "[probe.colour] is left out: coefficients are in the probe's colours",
            );
        }
        let of_shot = match shot.render.frames.as_str() {
            "" => None,
            text => Some(text),
        };
        let frames = frames_of(&files, flags.frames.as_deref().or(of_shot))?;
        files.tell_gaps(&frames, NOT_THERE, notes);
        let range = match of_shot {
            Some(text) => range::parse(text)?,
            None => frames[0]..=frames[frames.len() - 1],
        };
        let probe = Probe::open(files, &frames, range, &shot.probe, notes, progress)?;
        Ok(Self::of_probe(probe, frames, shot.probe.rotate_z_deg))
    }

    fn of_probe(probe: Probe, mut frames: Vec<u32>, rotate_z_deg: f32) -> Self {
        // One light all the time is one light.
        if probe.is_still() {
            frames.truncate(1);
        }
        Self {
            frames: frames.into_iter().map(|frame| (frame, 0)).collect(),
            probes: vec![probe],
            turn: (rotate_z_deg != 0.0).then(|| Mat3::from_rotation_z(rotate_z_deg.to_radians())),
        }
    }

    /// How many there are.
    pub(super) fn len(&self) -> usize {
        self.frames.len()
    }

    /// The number of one's frame; of files, which of them it is.
    pub(super) fn frame(&self, i: usize) -> u32 {
        self.frames[i].0
    }

    /// One's file.
    pub(super) fn file(&self, i: usize) -> PathBuf {
        let (frame, probe) = self.frames[i];
        self.probes[probe].file(frame)
    }

    /// Reads one.
    pub(super) fn load(&self, i: usize, notes: &mut Notes) -> Result<EnvMap> {
        let (frame, probe) = self.frames[i];
        self.probes[probe].load(frame, notes)
    }

    /// How they are turned in the world.
    pub(super) fn turn(&self) -> Option<Mat3> {
        self.turn
    }
}

/// The frames that are asked for, or all that there are.
fn frames_of(files: &FrameFiles, asked: Option<&str>) -> Result<Vec<u32>> {
    match asked {
        Some(text) => {
            let asked = range::parse(text).map_err(|e| e.at("--frames"))?;
            files.require(*asked.start(), *asked.end())
        }
        None if files.is_still() => files.require(1, 1),
        None => files
            .existing()
            .map_err(|e| e.fix("check the path: each # stands for a digit of the frame's number")),
    }
}
