//! Host file: `glimt sh`: light maps to coefficients of spherical harmonics.

mod lights;
mod text;

use crate::cli::{ShConvention, ShFlags, ShFormat, Up};
use crate::error::{Error, Kind, Result};
use crate::interrupt;
use crate::notes::Notes;
use crate::output::atomic::{self, Pending};
use crate::output::target::Guard;
use crate::printable::path_in_line;
use crate::report::{FrameStatus, Reporter, count, shown};
use glam::{Mat3, UVec2};
use glimt_render_gpu::prepare::env::EnvMap;
use glimt_render_gpu::prepare::projection::Projector;
use glimt_sh::{LightCoefficients, Z_UP_TO_Y_UP, rotated, temporally_filtered, windowed};
use lights::{Found, Lights};
use serde_json::json;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// A frame's coefficients, as they are written.
struct Projected {
    frame: i32,
    /// Whether the number is not a frame's, but says which file it is.
    still: bool,
    file: PathBuf,
    size: UVec2,
    coefficients: LightCoefficients,
}

/// Projects the frames that `inputs` name, and writes their coefficients to the flags' file or to standard output.
///
/// # Errors
/// The first thing that fails; a file that was there before stays as it was.
pub fn run(inputs: &[PathBuf], flags: &ShFlags, reporter: &Reporter) -> Result<()> {
    let began = Instant::now();
    if reporter.is_json() && flags.out.is_none() {
        return Err(
            Error::usage("--json and the coefficients would share standard output")
                .fix("name a file for the coefficients, with -o"),
        );
    }
    let bands = bands_written(flags)?;
    let mut notes = Notes::new(flags.strict);
    let found = Found::find(inputs, flags, &mut notes);
    reporter.notes(notes.take());
    let found = found?;
    // Before the work, so that it is not in vain.
    let mut pending = match &flags.out {
        Some(out) => Some(begin(out, inputs, &found, flags.overwrite)?),
        None => None,
    };
    let looked = |done, all| reporter.stage("looking for the ball", done, all);
    let lights = found.open(&mut notes, &looked);
    reporter.notes(notes.take());
    let lights = lights?;
    let into = flags.out.as_deref().unwrap_or(Path::new("standard output"));
    reporter.start_filming(lights.len(), into, "the CPU");

    let axes = match flags.up {
        Up::Z => lights.turn(),
        Up::Y => Z_UP_TO_Y_UP * lights.turn(),
    };
    let task = Task {
        lights,
        bands,
        axes,
        flags,
    };
    let projected = task.run(&mut notes, reporter)?;
    let written = match flags.format {
        ShFormat::Csv => text::csv(&projected, flags, &axes),
        ShFormat::Json => text::json(&projected, flags, bands, &axes),
        ShFormat::Engine => text::engine(&projected, flags, &axes),
    };
    match &mut pending {
        Some(pending) => {
            let text = pending.write_all(written.as_bytes());
            text.map_err(|e| pending.error(&e))?;
            pending.commit()?;
        }
        None => print(&written)?,
    }
    let seconds = began.elapsed().as_secs_f64();
    let out = flags.out.as_deref().map(shown);
    let summary = json!({
        "projected": projected.len(), "bands": bands, "seconds": seconds, "out": out,
    });
    let text = format!(
        "{} in {seconds:.1} s: {}",
        count(projected.len(), "light"),
        path_in_line(into)
    );
    reporter.finish(summary, &text);
    Ok(())
}

/// What is projected, and how.
struct Task<'a> {
    lights: Lights,
    bands: u32,
    /// From a map's own directions to those of what is written.
    axes: Mat3,
    flags: &'a ShFlags,
}

impl Task<'_> {
    /// Projects the lights, one after another.
    fn run(&self, notes: &mut Notes, reporter: &Reporter) -> Result<Vec<Projected>> {
        let mut projector = None;
        let mut projected: Vec<Projected> = Vec::new();
        let mut before: Option<LightCoefficients> = None;
        for i in 0..self.lights.len() {
            interrupt::check(|| "no coefficients are written".to_owned())?;
            let started = Instant::now();
            let map = self.lights.load(i, notes);
            reporter.notes(notes.take());
            let map = map?;
            let raw = project(&mut projector, &map, self.bands)
                .map_err(|e| e.file(&self.lights.file(i)))?;
            let light = windowed(&raw, self.flags.window);
            // The filter continues from what it gave, not from what is written: turned or in another convention.
            let light = match &before {
                Some(before) => temporally_filtered(&light, before, self.flags.temporal),
                None => light,
            };
            before = Some(light);
            projected.push(Projected {
                frame: self.lights.frame(i),
                still: self.lights.is_still(i),
                file: self.lights.file(i),
                size: map.size(),
                coefficients: if self.axes == Mat3::IDENTITY {
                    light
                } else {
                    rotated(&light, &self.axes)
                },
            });
            let status = FrameStatus::Rendered(started.elapsed().as_secs_f64());
            reporter.frame(self.lights.frame(i), status, i + 1, self.lights.len());
        }
        Ok(projected)
    }
}

/// The bands that are written: the nine coefficients that engines take are those of three.
fn bands_written(flags: &ShFlags) -> Result<u32> {
    if flags.format != ShFormat::Engine && flags.convention != ShConvention::Filament {
        return Ok(flags.bands);
    }
    if flags.bands < 3 {
        let what = format!(
            "engines take nine coefficients, and --bands {} has fewer",
            flags.bands
        );
        return Err(
            Error::usage(what).fix("leave --bands out, or choose another format and convention")
        );
    }
    Ok(3)
}

/// The coefficients of a map, by a projector that is kept while the size stays.
fn project(kept: &mut Option<Projector>, map: &EnvMap, bands: u32) -> Result<LightCoefficients> {
    let projector = match kept.take() {
        Some(projector) if projector.size() == map.size() => projector,
        _ => Projector::new(map.size(), bands, 4)
            .map_err(|e| Error::new(Kind::Input, e).fix("resize it"))?,
    };
    let light = projector.project_vec4(map.texels());
    *kept = Some(projector);
    light.map_err(|e| Error::new(Kind::Internal, e))
}

/// Begins to write the file, which must be nothing that is read, nor another frame of a sequence of which a part is read.
fn begin(out: &Path, inputs: &[PathBuf], found: &Found, overwrite: bool) -> Result<Pending> {
    let mut guard = Guard::new(overwrite);
    for files in found.files() {
        guard.reads_sequence("one of the lights", files);
    }
    guard.reads_all("the shot", inputs.iter().cloned());
    let target = guard.target(out)?;
    atomic::prepare_folder_of(&target)?;
    Pending::create(&target)
}

fn print(text: &str) -> Result<()> {
    let mut out = std::io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        // A closed pipe (`glimt sh light.hdr | head`) is not an error of ours.
        Err(e) if e.kind() != std::io::ErrorKind::BrokenPipe => {
            Err(Error::writing(Path::new("standard output"), &e))
        }
        _ => Ok(()),
    }
}
