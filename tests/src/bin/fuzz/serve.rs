//! Host file: the child's side: reads what it is told to, as the program does, and answers with what came of it.

use clap::Parser;
use glimt::bake;
use glimt::cli::{Cli, PrintFlags, RenderFlags};
use glimt::error::{Error, Kind, Result};
use glimt::job::Job;
use glimt::notes::Notes;
use glimt::report::Reporter;
use glimt::shot::parse;
use glimt::synth::Synth;
use serde_json::Value;
use std::io::{BufRead, Write};
use std::path::Path;
use std::process::ExitCode;

/// What an answer begins with; other lines are the program's.
pub(crate) const ANSWER: &str = "answer: ";

/// Serves trials until standard input ends. A panic of any thread ends the process, even where someone would catch it: it would be
/// seen on the user's terminal.
pub(crate) fn run() -> ExitCode {
    std::panic::set_hook(Box::new(|info| {
        let place = info.location().map(ToString::to_string);
        let what = info.payload_as_str().unwrap_or("no message");
        let line = format!("{}: {what}", place.unwrap_or_default());
        answer(&format!("panic {}", line.replace('\n', " ")));
        std::process::exit(101);
    }));
    for line in std::io::stdin().lock().lines() {
        let Ok(line) = line else { break };
        let outcome = match serve(&line) {
            Ok(()) => "read".to_owned(),
            Err(error) if error.kind == Kind::Internal => format!("panic internal error: {error}"),
            Err(error) => format!("refused {error}"),
        };
        answer(&outcome);
    }
    ExitCode::SUCCESS
}

fn answer(text: &str) {
    let mut out = std::io::stdout().lock();
    let _ = writeln!(out, "{ANSWER}{text}");
    let _ = out.flush();
}

/// Does what a line of JSON asks for: `["info", "FILE"]`, `["load", "SHOT"]`.
fn serve(line: &str) -> Result<()> {
    let command: Vec<String> = serde_json::from_str(line).map_err(Error::usage)?;
    let words: Vec<&str> = command.iter().map(String::as_str).collect();
    match words[..] {
        ["load", shot] => load(Path::new(shot)),
        ["synth", file] => check_synth(Path::new(file)),
        _ => program(&words),
    }
}

fn reporter() -> Reporter {
    Reporter::new(PrintFlags {
        quiet: true,
        json: false,
        verbose: 0,
    })
}

/// A command of the program, with its arguments.
///
/// # Errors
/// Those of the program; and [`Kind::Usage`] where there is no such command.
pub(crate) fn program(words: &[&str]) -> Result<()> {
    let line = ["glimt", "--quiet"].iter().chain(words);
    let cli = Cli::try_parse_from(line).map_err(Error::usage)?;
    glimt::command::run(cli.command, &reporter())
}

/// Reads all that a shot names, and makes what rendering needs of it.
fn load(shot: &Path) -> Result<()> {
    let mut notes = Notes::new(false);
    let job = Job::from_file(shot, &RenderFlags::default(), &mut notes, &reporter())?;
    let frames = [job.frames.first(), job.frames.last()];
    for &frame in frames.into_iter().flatten() {
        job.light(frame, &mut notes)?;
        job.plate(frame, &mut notes)?;
        job.setup.pose(frame)?;
    }
    let mut scene = job.setup.build_scene()?;
    bake::set_transfer(&job.setup, &job.setup.shot, &mut scene)
}

/// Reads the settings of simulated film.
fn check_synth(file: &Path) -> Result<()> {
    let (synth, source) = parse::read::<Synth>(file, &[])?;
    glimt::synth::check::check(&synth, &source)?;
    serde_json::to_value(&synth)
        .map(|_: Value| ())
        .map_err(Error::usage)
}
