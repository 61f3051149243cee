//! Host file: files that are broken in any way give an error, and never a panic, an abort, a long wait or too much memory.
//!
//! `cargo run --release -p glimt-tests --bin fuzz -- --minutes 5 --seed 7` makes small files of every format, mutates them, and has
//! child processes read them as the program does. It prints counts, keeps the files of each fault, and ends with status 1 where there
//! is one.

mod child;
mod corpus;
mod mutate;
mod serve;
mod tally;
mod trial;

use child::{Child, Outcome};
use clap::Parser;
use corpus::Seed;
use glimt_tests::random::Random;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Instant;
use tally::Tally;
use trial::Trial;

#[derive(Parser)]
struct Cli {
    /// How long
    #[arg(long, default_value_t = 1.0)]
    minutes: f64,
    /// Stop after so many trials, if the time is not over before
    #[arg(long, default_value_t = u64::MAX)]
    trials: u64,
    /// Begin with this trial: each depends on the seed and on its own number alone
    #[arg(long, default_value_t = 0)]
    from: u64,
    /// Seed of the mutations
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// These formats alone
    #[arg(long, value_name = "FORMAT")]
    only: Vec<String>,
    /// Folder for the files of faults
    #[arg(long, value_name = "DIR")]
    keep: Option<PathBuf>,
    /// Read the trials that come on standard input: what the children do
    #[arg(long, hide = true)]
    serve: bool,
}

fn main() -> ExitCode {
    let cli = Cli::parse();
    if cli.serve {
        return serve::run();
    }
    match run(&cli) {
        Ok(0) => ExitCode::SUCCESS,
        Ok(_) => ExitCode::FAILURE,
        Err(why) => {
            eprintln!("error: {why}");
            ExitCode::FAILURE
        }
    }
}

/// A folder of one's own, removed at the end.
struct Work(PathBuf);

impl Work {
    fn new() -> Result<Self, String> {
        // In memory where that can be: each trial writes files.
        let shared = Path::new("/dev/shm");
        let root = match shared.is_dir() {
            true => shared.to_owned(),
            false => std::env::temp_dir(),
        };
        let path = root.join(format!("glimt-fuzz-{}", std::process::id()));
        let _ = std::fs::remove_dir_all(&path);
        std::fs::create_dir_all(&path).map_err(|e| format!("{}: {e}", path.display()))?;
        Ok(Self(path))
    }
}

impl Drop for Work {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

/// The number of faults.
fn run(cli: &Cli) -> Result<usize, String> {
    let work = Work::new()?;
    let seeds = corpus::make(&work.0)?;
    let mut formats: Vec<&'static str> = seeds.iter().map(|seed| seed.format).collect();
    formats.dedup();
    if let Some(unknown) = cli.only.iter().find(|f| !formats.contains(&f.as_str())) {
        let known = formats.join(", ");
        return Err(format!("there is no format {unknown}; there are: {known}"));
    }
    formats.retain(|format| cli.only.is_empty() || cli.only.iter().any(|only| only == format));

    let keep = cli.keep.clone();
    let keep = keep.unwrap_or_else(|| std::env::temp_dir().join("glimt-fuzz-faults"));
    let mut tally = Tally::new(keep);
    let mut child = Child::start(&work.0)?;
    check_whole(&seeds, &formats, &mut child)?;
    let began = Instant::now();
    let mut number = cli.from;
    while number - cli.from < cli.trials && began.elapsed().as_secs_f64() < 60.0 * cli.minutes {
        let format = formats[(number % formats.len() as u64) as usize];
        let of_format: Vec<&Seed> = seeds.iter().filter(|seed| seed.format == format).collect();
        let mut random = Random(cli.seed ^ number.wrapping_mul(0x2545_f491_4f6c_dd1d));
        let trial = Trial::new(&of_format, &mut random);
        trial.write()?;
        let begun = Instant::now();
        let outcome = child.ask(trial.seed)?;
        tally.add(number, &trial, &outcome, begun.elapsed())?;
        trial.restore()?;
        number += 1;
    }
    tally.print(cli.seed, began.elapsed());
    Ok(tally.faults())
}

/// What is not mutated is read without an error: otherwise mutations would not reach far.
fn check_whole(seeds: &[Seed], formats: &[&str], child: &mut Child) -> Result<(), String> {
    let mut wrong = String::new();
    for seed in seeds.iter().filter(|seed| formats.contains(&seed.format)) {
        let outcome = child.ask(seed)?;
        let is_as_expected = match &outcome {
            Outcome::Read => !seed.is_refused,
            Outcome::Refused(_) => seed.is_refused,
            _ => false,
        };
        if !is_as_expected {
            wrong.push_str(&format!("\n{}: {outcome:?}", seed.folder.display()));
        }
    }
    match wrong.is_empty() {
        true => Ok(()),
        false => Err(format!(
            "whole files are not read as they should be:{wrong}"
        )),
    }
}
