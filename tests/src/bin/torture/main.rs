//! Host file: what the program survives: kills at random moments, long runs, full disks, frames that come fast.
//!
//! `cargo build --release -p glimt`, then `cargo run --release -p glimt-tests --bin torture -- kill --minutes 10`. It prints counts, and ends
//! with status 1 at the first fault.

mod bench;
mod disk;
mod follow;
mod kill;
mod soak;

use clap::{Parser, Subcommand};
use std::process::ExitCode;

/// A fault of the program, in words.
type Outcome<T = ()> = Result<T, String>;

#[derive(Parser)]
struct Cli {
    #[command(subcommand)]
    test: Test,
    /// Seed of the random moments
    #[arg(long, global = true, default_value_t = 1)]
    seed: u64,
}

#[derive(Subcommand)]
enum Test {
    /// Kill each command at random moments, and run it again: every file is whole, and in the end all are as if it had not been killed
    Kill {
        #[arg(long, default_value_t = 1.0)]
        minutes: f64,
    },
    /// Render many frames: neither memory nor open files grow
    Soak {
        #[arg(long, default_value_t = 3000)]
        frames: u32,
    },
    /// Render onto disks of many sizes that are too small (needs the right to mount)
    Disk,
    /// Follow frames that come at a rate while nothing else is to be done: none is dropped
    Follow {
        #[arg(long, default_value_t = 60.0)]
        fps: f64,
        #[arg(long, default_value_t = 2000)]
        frames: u32,
    },
}

fn main() -> ExitCode {
    let cli = Cli::parse();
    let outcome = match cli.test {
        Test::Kill { minutes } => kill::run(minutes, cli.seed),
        Test::Soak { frames } => soak::run(frames),
        Test::Disk => disk::run(),
        Test::Follow { fps, frames } => follow::run(fps, frames),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(fault) => {
            eprintln!("fault: {fault}");
            ExitCode::FAILURE
        }
    }
}
