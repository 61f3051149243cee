//! Host file: what there is to render: a shot file or the built-in shot, loaded and checked, ready for the pipeline.

use crate::bake;
use crate::cli::{PastFlags, RenderFlags};
use crate::error::{Error, Result};
use crate::input::footage::{self, Footage};
use crate::input::frames::FrameFiles;
use crate::light::{Probe, Selection, colour};
use crate::notes::Notes;
use crate::output::state::{self, Saved};
use crate::report::Reporter;
use crate::setup::{self, Setup};
use crate::shot::digest::{self, Hash};
use crate::shot::parse::Source;
use crate::shot::{Method, Render, Shot, check, parse, range};
use glam::UVec2;
use glimt_render_gpu::prepare::env::PreparedEnv;
use glimt_render_gpu::prepare::plate::Plate;
use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// Everything that rendering a shot needs.
pub struct Job {
    /// What stays the same in all frames.
    pub setup: Setup,
    /// The frames to render, in order.
    pub frames: Vec<i32>,
    /// Whether each of them is written; the others only lead up to these.
    pub written: Vec<bool>,
    /// What the first frame continues from.
    pub state_in: Option<Saved>,
    /// Where what comes after the last frame continues from is saved.
    pub state_out: Option<PathBuf>,
    /// Whether these are all frames of the shot.
    pub whole: bool,
    /// Whether other runs may write to the same folder.
    pub share: bool,
    probe: Probe,
    footage: Option<Footage>,
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
        footage::adopt_size(&mut shot, &source)?;
        check::check(&shot, &source)?;

        let files = probe_files(&shot, &source)?;
        footage::adopt_rate(&mut shot, &source, &files, notes)?;
        reporter.busy("reading the headers of light and backplate");
        let footage = Footage::find(&shot, &source, &files, notes)?;
        let (asked, of_shot) = choose_frames(&shot, &files, footage.as_ref(), flags, notes)?;
        check_past(&flags.past, &shot.render)?;
        let (frames, written) = with_past(&asked, &of_shot, &files, &shot, &flags.past, notes)?;
        if let Some(footage) = &footage {
            footage.require(&frames, UVec2::from(shot.image.size), notes)?;
        }
        let found = |done, all| reporter.stage("looking for the ball", done, all);
        let selection = Selection {
            files: files.clone(),
            frames: &frames,
            of_shot: &of_shot,
        };
        let mut probe = Probe::open(selection, &shot, notes, &found)?;
        colour::correct(
            &mut probe,
            &shot,
            &source,
            footage.as_ref(),
            frames[0],
            notes,
        )?;
        reporter.busy("reading the shot's meshes");
        let mut setup = Setup::load(shot, source, of_shot[0], flags, notes)?;
        setup.guard.reads_sequence("the shot's light", &files);
        if let Some(footage) = &footage {
            setup
                .guard
                .reads_sequence("the shot's backplate", footage.files());
        }
        if let Some(file) = &flags.past.state_in {
            setup.guard.reads("the state of --state-in", file);
        }
        bake::expect(&mut setup)?;
        let state_in = match &flags.past.state_in {
            Some(file) => Some(read_state(file, &setup, frames[0], notes)?),
            None => None,
        };
        let job = Self {
            setup,
            whole: asked == of_shot,
            frames,
            written,
            state_in,
            state_out: flags.past.state_out.clone(),
            share: flags.write.share,
            probe,
            footage,
        };
        job.setup.check_settings(job.frames[0])?;
        for &frame in &job.frames {
            job.setup.camera(frame)?;
        }
        Ok(job)
    }

    /// How many frames are written.
    pub fn count(&self) -> usize {
        self.written.iter().filter(|written| **written).count()
    }

    /// The most bytes that a state of the method has.
    pub fn state_bytes(&self) -> u64 {
        let (setup, render) = (&self.setup, &self.setup.shot.render);
        let map = self.probe.map_size();
        let texels = u64::from(map.x) * u64::from(map.y);
        let objects = setup.scene.objects.len() as u64;
        let rays_per_pixel = setup.shot.image.rays_per_pixel;
        let bytes = |method| state::bytes(&method, texels, setup.size(), rays_per_pixel, objects);
        render.estimator().map_or(0, bytes)
    }

    /// Whether every frame has the same light.
    pub fn is_still(&self) -> bool {
        self.probe.is_still()
    }

    /// Reads the light of a frame for what there is to say about it alone.
    ///
    /// # Errors
    /// As [`Job::light`].
    pub fn check_light(&self, frame: i32, notes: &mut Notes) -> Result<()> {
        self.probe.load(frame, notes).map(drop)
    }

    /// The light of a frame, with its tables, and the hash of what it was made of.
    ///
    /// # Errors
    /// It cannot be read.
    pub fn light(&self, frame: i32, notes: &mut Notes) -> Result<(PreparedEnv, Hash)> {
        let began = Instant::now();
        let (map, hash) = self.probe.load(frame, notes)?;
        let read = began.elapsed();
        let prepared = self.setup.tables(map, Some(&self.probe.file(frame)));
        let tables = began.elapsed() - read;
        tracing::info!("light of frame {frame}: read in {read:.2?}, tables in {tables:.2?}");
        Ok((prepared?, hash))
    }

    /// Whether every frame has the same footage, or none.
    pub fn is_still_plate(&self) -> bool {
        self.footage.as_ref().is_none_or(Footage::is_still)
    }

    /// The footage behind a frame, if there is any, and the hash of its file.
    ///
    /// # Errors
    /// It cannot be read.
    pub fn plate(&self, frame: i32, notes: &mut Notes) -> Result<Option<(Plate, Hash)>> {
        let Some(footage) = &self.footage else {
            return Ok(None);
        };
        let began = Instant::now();
        let plate = footage.load(frame, self.setup.size(), notes)?;
        tracing::info!("plate of frame {frame}: read in {:.2?}", began.elapsed());
        Ok(Some(plate))
    }

    /// Whether each frame continues from the one before it.
    pub fn is_chain(&self) -> bool {
        self.setup.shot.render.continues()
    }

    /// Hash of the light of each frame.
    ///
    /// # Errors
    /// A file cannot be read.
    pub fn light_hashes(&self) -> Result<HashMap<i32, Hash>> {
        let hashes = self.probe.digests(&self.frames)?;
        Ok(self.frames.iter().copied().zip(hashes).collect())
    }

    /// What a run's first frame continues from.
    pub fn chain(&self) -> Chain {
        Chain {
            hash: self.state_in.as_ref().map_or([0; 32], |saved| saved.chain),
            is_chain: self.is_chain(),
        }
    }

    /// The identity of each frame, in the order of [`Job::frames`], and the hash of all that it came from.
    ///
    /// # Errors
    /// A file of the light or the footage cannot be read.
    pub fn identities(&self) -> Result<Vec<(String, Hash)>> {
        let mut inputs = self.probe.digests(&self.frames)?;
        if let Some(footage) = &self.footage {
            let plates = footage.digests(&self.frames)?;
            for (input, plate) in inputs.iter_mut().zip(&plates) {
                *input = digest::join([&*input, plate]);
            }
        }
        let mut chain = self.chain();
        let pairs = inputs.iter().zip(&self.frames);
        let identities = pairs.map(|(input, &frame)| {
            let identity = chain.next(&self.setup.digest, input, frame);
            (identity, chain.hash)
        });
        Ok(identities.collect())
    }
}

/// What frames came from, one after another.
#[derive(Clone, Copy, Debug)]
pub struct Chain {
    /// Hash of all inputs so far, where each frame continues from the one before it.
    pub hash: Hash,
    is_chain: bool,
}

impl Chain {
    /// The identity of the next frame, of a setup and of inputs with these hashes.
    pub fn next(&mut self, setup: &Hash, input: &Hash, frame: i32) -> String {
        if !self.is_chain {
            return digest::of_frame(setup, input, frame);
        }
        self.hash = digest::join([&self.hash, input, &digest::of_text(&frame.to_string())]);
        digest::of_frame(setup, &self.hash, frame)
    }
}

/// Not all methods continue from frame to frame, and not all of those have a state that takes long to come by.
fn check_past(flags: &PastFlags, render: &Render) -> Result<()> {
    let given = [
        ("--state-in", flags.state_in.is_some()),
        ("--state-out", flags.state_out.is_some()),
        ("--preroll", flags.preroll > 0),
    ];
    match given.iter().find(|(_, given)| *given) {
        Some((flag, _)) if !render.continues() => {
            let prt = render.method == Method::Prt && *flag == "--preroll";
            let fix = match prt {
                true => "leave it out, or set render.prt.temporal above 0",
                false => "leave it out, or add --method cells",
            };
            Err(Error::usage(format!(
                "{flag} is for methods that continue from frame to frame: here each stands alone"
            ))
            .fix(fix))
        }
        Some((flag, _)) if *flag != "--preroll" && render.method == Method::Prt => {
            Err(Error::usage(format!(
                "{flag} is not for the method \"prt\": what it keeps of earlier frames fades fast"
            ))
            .fix("lead up to the first frame with --preroll 10"))
        }
        _ => Ok(()),
    }
}

/// The frames that are computed, and whether each of them is written. Where frames continue from one another, those between the
/// ones that are asked for are computed too, and so is the preroll: a frame is the same whichever others are written.
fn with_past(
    asked: &[i32],
    of_shot: &[i32],
    files: &FrameFiles,
    shot: &Shot,
    flags: &PastFlags,
    notes: &mut Notes,
) -> Result<(Vec<i32>, Vec<bool>)> {
    if !shot.render.continues() {
        return Ok((asked.to_vec(), vec![true; asked.len()]));
    }
    let (first, last) = (asked[0], asked[asked.len() - 1]);
    let begin = first
        .saturating_sub_unsigned(flags.preroll)
        .max(of_shot[0])
        .min(first);
    let preroll = first.abs_diff(begin);
    if preroll < flags.preroll {
        let text = format!(
            "of {} frames before frame {first} the shot has {preroll}: the preroll begins there",
            flags.preroll,
        );
        notes.note(Path::new("--preroll"), text);
    }
    let frames = range::between(begin, last)?;
    files.require(&frames)?;
    let is_asked = |frame: &i32| asked.binary_search(frame).is_ok();
    let written: Vec<bool> = frames.iter().map(is_asked).collect();
    let between = frames.len() - asked.len() - preroll as usize;
    if between > 0 {
        let text = format!(
            "frames continue from one another, so {between} between those that are asked for are rendered, and not written"
        );
        notes.note(Path::new("--frames"), text);
    }
    Ok((frames, written))
}

/// A saved state, checked to be of this shot.
fn read_state(file: &Path, setup: &Setup, first: i32, notes: &mut Notes) -> Result<Saved> {
    let saved = state::read(file)?;
    if saved.setup != setup.digest {
        return Err(
            Error::input(file, "the state is of another shot, or of other settings")
                .fix("save one with --state-out from this shot, with the same keys and seed"),
        );
    }
    let before = saved.frame();
    if before.checked_add(1) != Some(first) {
        let text = format!("the state is of frame {before}, and frame {first} continues from it");
        notes.note(file, text);
    }
    Ok(saved)
}

/// The files of the shot's light.
///
/// # Errors
/// They cannot be named so.
pub fn probe_files(shot: &Shot, source: &Source) -> Result<FrameFiles> {
    FrameFiles::new(source.folder(), &shot.probe.frames).map_err(|e| {
        source
            .error("probe.frames", e.what)
            .fix(e.fix.unwrap_or_default())
    })
}

/// The frames to write, and those of the shot: those that it names, or all that light and footage both have.
fn choose_frames(
    shot: &Shot,
    files: &FrameFiles,
    footage: Option<&Footage>,
    flags: &RenderFlags,
    notes: &mut Notes,
) -> Result<(Vec<i32>, Vec<i32>)> {
    let of_shot = match shot.render.frames.as_str() {
        "" => {
            let [first, last] = match footage {
                Some(footage) => footage.shared(files, notes)?,
                None => {
                    let there = files.existing()?;
                    [there[0], there[there.len() - 1]]
                }
            };
            if flags.frames.is_none() {
                files.check_signs(&files.existing()?, notes)?;
            }
            range::between(first, last)?
        }
        text => range::parse(text)?,
    };
    let asked = match &flags.frames {
        Some(text) => range::parse(text).map_err(|e| e.at("--frames"))?,
        None => of_shot.clone(),
    };
    files.require(&asked)?;
    Ok((asked, of_shot))
}
