//! Host file: the lights that `glimt sh` projects: a sequence, files, or what lights a shot.

use crate::cli::ShFlags;
use crate::error::{Error, Result};
use crate::input::footage::Footage;
use crate::input::frames::FrameFiles;
use crate::job::probe_files;
use crate::light::{Probe, Selection, colour};
use crate::notes::Notes;
use crate::shot::parse::Source;
use crate::shot::{self, Shot, check, parse, range};
use glam::Mat3;
use glimt_render_gpu::prepare::env::EnvMap;
use std::path::{Path, PathBuf};

/// What becomes of missing frames.
const NOT_THERE: &str = "there are no coefficients of what is not there";

/// Lights that are to be projected, of which nothing but their names is known.
pub(super) struct Found {
    /// A sequence or a still with the frames that are asked for; or files, each of them frame 1.
    sources: Vec<(FrameFiles, Vec<i32>)>,
    /// The frames among which a mirror ball is steadied.
    range: Vec<i32>,
    /// How far they are turned, in degrees about +z.
    turn: f32,
    /// What says how their colours are changed.
    shot: Option<(Shot, Source, Option<Footage>)>,
}

impl Found {
    /// Finds them.
    pub(super) fn find(inputs: &[PathBuf], flags: &ShFlags, notes: &mut Notes) -> Result<Self> {
        if let [file] = inputs {
            let extension = file.extension().unwrap_or_default();
            if extension.eq_ignore_ascii_case("toml") {
                return Self::of_shot(file, flags, notes);
            }
        }
        let files = inputs
            .iter()
            .map(|input| files_of(input))
            .collect::<Result<Vec<_>>>()?;
        if let [sequence] = &files[..]
            && !sequence.is_still()
        {
            let frames = frames_of(sequence, flags.frames.as_deref(), "check the path")?;
            sequence.note_gaps(&frames, NOT_THERE, notes);
            return Ok(Self {
                range: frames.clone(),
                sources: vec![(sequence.clone(), frames)],
                shot: None,
                turn: flags.rotate_z_deg,
            });
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
        for file in &files {
            file.require(&[1])?;
        }
        Ok(Self {
            sources: files.into_iter().map(|file| (file, vec![1])).collect(),
            range: vec![1],
            shot: None,
            turn: flags.rotate_z_deg,
        })
    }

    /// The light of a shot, as its `[probe]` says: mapping, scale, turn and colours.
    fn of_shot(file: &Path, flags: &ShFlags, notes: &mut Notes) -> Result<Self> {
        let (mut shot, source): (Shot, _) = parse::read(file, &[])?;
        // Coefficients are of Rec. 709, whatever the shot is rendered with.
        shot.image.primaries = shot::WorkingPrimaries::Rec709;
        check::check(&shot, &source)?;
        let files = probe_files(&shot, &source)?;
        // A backplate is looked at where colours are matched to it, and nowhere else.
        let matched = |keys: &shot::Colour| !keys.patches.is_empty();
        let footage = match shot.probe.colour.as_ref().is_some_and(matched) {
            true => Footage::find(&shot, &source, &files, notes)?,
            false => None,
        };
        let of_shot = match shot.render.frames.as_str() {
            "" => None,
            text => Some(text),
        };
        let asked = flags.frames.as_deref().or(of_shot);
        let frames = frames_of(&files, asked, "check probe.frames")?;
        files.note_gaps(&frames, NOT_THERE, notes);
        let range = match of_shot {
            Some(text) => range::parse(text)?,
            None => frames.clone(),
        };
        Ok(Self {
            sources: vec![(files, frames)],
            range,
            turn: shot.probe.rotate_z_deg + flags.rotate_z_deg,
            shot: Some((shot, source, footage)),
        })
    }

    /// The files of the lights, also of those frames of a sequence that are not asked for.
    pub(super) fn files(&self) -> impl Iterator<Item = &FrameFiles> {
        self.sources.iter().map(|(files, _)| files)
    }

    /// Reads their headers; in film of a mirror ball, looks for the ball.
    pub(super) fn open(
        self,
        notes: &mut Notes,
        progress: &(dyn Fn(usize, usize) + Sync),
    ) -> Result<Lights> {
        let (mut frames, mut probes) = (Vec::new(), Vec::new());
        let are_files = self.sources.len() > 1;
        let plain = Shot::default();
        for (files, mut numbers) in self.sources {
            let selection = Selection {
                files,
                frames: &numbers,
                of_shot: &self.range,
            };
            let shot = self.shot.as_ref().map_or(&plain, |(shot, ..)| shot);
            let mut probe = Probe::open(selection, shot, notes, progress)?;
            if let Some((shot, source, footage)) = &self.shot {
                colour::correct(
                    &mut probe,
                    shot,
                    source,
                    footage.as_ref(),
                    numbers[0],
                    notes,
                )?;
            }
            // One light all the time is one light.
            if probe.is_still() {
                numbers.truncate(1);
            }
            let number = |frame: i32| {
                if are_files {
                    probes.len() as i32 + 1
                } else {
                    frame
                }
            };
            let light = |frame: i32| LightOfProbe {
                number: number(frame),
                frame,
                probe: probes.len(),
            };
            frames.extend(numbers.into_iter().map(light));
            probes.push(probe);
        }
        Ok(Lights {
            frames,
            probes,
            turn: Mat3::from_rotation_z(self.turn.to_radians()),
        })
    }
}

/// Lights in the order in which they are projected.
pub(super) struct Lights {
    frames: Vec<LightOfProbe>,
    probes: Vec<Probe>,
    turn: Mat3,
}

/// A light among others.
struct LightOfProbe {
    /// What it is called: its frame, or of files, which of them it is.
    number: i32,
    /// Its frame.
    frame: i32,
    /// Of this probe.
    probe: usize,
}

impl Lights {
    /// How many there are.
    pub(super) fn len(&self) -> usize {
        self.frames.len()
    }

    /// The number of one's frame; of files, which of them it is.
    pub(super) fn frame(&self, i: usize) -> i32 {
        self.frames[i].number
    }

    /// Whether one is a file, and no frame of a sequence.
    pub(super) fn is_still(&self, i: usize) -> bool {
        self.probes[self.frames[i].probe].is_still()
    }

    /// One's file.
    pub(super) fn file(&self, i: usize) -> PathBuf {
        let LightOfProbe { frame, probe, .. } = self.frames[i];
        self.probes[probe].file(frame)
    }

    /// Reads one.
    pub(super) fn load(&self, i: usize, notes: &mut Notes) -> Result<EnvMap> {
        let LightOfProbe { frame, probe, .. } = self.frames[i];
        let (map, _) = self.probes[probe].load(frame, notes)?;
        Ok(map)
    }

    /// How they are turned in the world.
    pub(super) fn turn(&self) -> Mat3 {
        self.turn
    }
}

/// The files that an argument names. Its folder is taken as it is, whatever bytes it is made of, and so is a name that is no text.
fn files_of(input: &Path) -> Result<FrameFiles> {
    let name = input.file_name().and_then(|name| name.to_str());
    match (input.parent(), name) {
        (Some(folder), Some(name)) => FrameFiles::new(folder, name),
        _ => Ok(FrameFiles::Still(input.to_owned())),
    }
}

/// The frames that are asked for, or all that there are. `fix` says where the files' name is to be looked at if there are none.
fn frames_of(files: &FrameFiles, asked: Option<&str>, fix: &str) -> Result<Vec<i32>> {
    if files.is_still() && asked.is_none() {
        files.require(&[1])?;
        return Ok(vec![1]);
    }
    let there = files.existing().map_err(|e| {
        e.fix(format!(
            "{fix}: each # stands for a digit of the frame's number"
        ))
    })?;
    match asked {
        Some(text) => {
            let asked = range::parse(text).map_err(|e| e.at("--frames"))?;
            files.require(&asked)?;
            Ok(asked)
        }
        None => Ok(there),
    }
}
