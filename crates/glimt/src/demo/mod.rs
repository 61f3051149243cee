//! Host file: the built-in demonstration, made of formulas alone: the whole road from a filmed mirror ball to a composited shot.
//!
//! It films a simulated ball and a plate under a climbing sun, finds and unwarps the ball, lays a sculpture over the plate in
//! its light, and joins what came of it in one picture. Everything that it does is done by the commands that others use, on
//! two files that it writes: `film/synth.toml` and `shot.toml`.

mod sheet;

use crate::cli::{RenderFlags, SynthFlags, UnwarpFlags};
use crate::error::{Error, Result};
use crate::job::Job;
use crate::notes::Notes;
use crate::output::target::Guard;
use crate::output::{atomic, write_editable};
use crate::printable::path_in_line;
use crate::report::Reporter;
use crate::shot::range;
use crate::{render, synth, unwarp};
use glam::UVec2;
use std::path::{Path, PathBuf};

/// Frames of the shot, numbered from 1.
pub const FRAMES: i32 = 24;

/// Settings of the simulated capture.
const SYNTH: &str = include_str!("synth.toml");
/// The shot.
const SHOT: &str = include_str!("shot.toml");

/// Size of the unwarped maps: as the ball of the capture gives it.
const MAP: UVec2 = UVec2::new(640, 320);

/// Makes the demonstration.
///
/// # Errors
/// The flags are wrong, or something cannot be written. What is done stays, and another run continues from there.
pub fn run(flags: &RenderFlags, reporter: &Reporter) -> Result<()> {
    if let Some(text) = &flags.frames {
        let asked = range::parse(text).map_err(|e| e.at("--frames"))?;
        if asked.iter().any(|frame| !(1..=FRAMES).contains(frame)) {
            return Err(Error::usage(format!("the demo has the frames 1-{FRAMES}"))
                .fix(format!("choose among them with --frames, as 1-{FRAMES}")));
        }
    }
    let out = flags.out.clone().unwrap_or_else(|| PathBuf::from("out"));
    let film = out.join("film");
    let (settings, shot) = (film.join("synth.toml"), out.join("shot.toml"));
    let guard = Guard::new(flags.write.overwrite);
    let sheet = guard.target(&out.join("contact-sheet.png"))?;
    atomic::prepare_folder(&film)?;
    write_editable(&guard, &settings, SYNTH, reporter)?;
    write_editable(&guard, &shot, SHOT, reporter)?;
    // The shot is read first: what is wrong with the flags is said before anything is filmed.
    crate::shot::parse::read::<crate::shot::Shot>(&shot, &crate::setup::overrides(flags))?;

    reporter.step("1 of 4: a mirror ball and a plate are filmed");
    let filming = SynthFlags {
        frames: flags.frames.clone(),
        device: flags.device,
        set: Vec::new(),
        out: Some(film.clone()),
        seed: None,
        strict: flags.strict,
        write: flags.write,
    };
    synth::run(Some(&settings), &filming, reporter)?;

    reporter.step("2 of 4: the ball is found and unwarped");
    let light = UnwarpFlags {
        frames: flags.frames.clone(),
        device: flags.device,
        out: out.join("light"),
        size: Some(MAP),
        distance_mm: None,
        radius_mm: None,
        set: vec![
            "reflectance=[0.72, 0.72, 0.7]".to_owned(),
            "rig_deg=9".to_owned(),
        ],
        strict: flags.strict,
        write: flags.write,
    };
    unwarp::run(&film.join("capture/ball.####.exr"), &light, reporter)?;

    reporter.step("3 of 4: the sculpture is rendered into the plate");
    let flags = RenderFlags {
        out: Some(out.clone()),
        ..flags.clone()
    };
    let mut notes = Notes::new(flags.strict);
    let job = Job::from_file(&shot, &flags, &mut notes, reporter);
    reporter.notes(notes.take());
    let job = job?;
    let frames = job.frames.clone();
    render::render(job, flags.device, notes, reporter)?;

    reporter.step("4 of 4: the contact sheet");
    sheet::write(&sheet, &out, &frames)?;
    reporter.remark(&format!(
        "probe, unwarped map, render and composite side by side: {}",
        path_in_line(sheet.path())
    ));
    Ok(())
}

/// The file of a frame in a folder of the demonstration.
fn frame_file(folder: &Path, name: &str, frame: i32, extension: &str) -> PathBuf {
    folder.join(format!("{name}.{frame:04}.{extension}"))
}
