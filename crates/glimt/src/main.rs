//! Host file: the command line, from arguments to an exit status.

use clap::Parser;
use glimt::capture::unwarp;
use glimt::cli::{Cli, Command, RenderFlags};
use glimt::error::{Error, Kind, Result};
use glimt::job::Job;
use glimt::notes::Notes;
use glimt::report::Reporter;
use glimt::{compare, demo, follow, info, render, sh, synth};
use std::io::IsTerminal;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::process::ExitCode;
use tracing_subscriber::EnvFilter;

fn main() -> ExitCode {
    let cli = Cli::parse();
    start_log(cli.talk.verbose);
    let reporter = Reporter::new(cli.talk);
    let outcome =
        catch_unwind(AssertUnwindSafe(|| run(cli.command, &reporter))).unwrap_or_else(|_| {
            Err(Error::new(
                Kind::Internal,
                "this is a fault of glimt; please report it",
            ))
        });
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            reporter.error(&error);
            ExitCode::from(error.kind as u8)
        }
    }
}

fn run(command: Command, reporter: &Reporter) -> Result<()> {
    match command {
        Command::Demo { flags } => demo::run(&flags, reporter),
        Command::Render {
            shot,
            flags,
            follow,
            ..
        } if follow.follow => follow::render(&shot, &flags, follow.wait, reporter),
        Command::Render {
            shot, flags, past, ..
        } => {
            let flags = RenderFlags { past, ..flags };
            let mut notes = Notes::new(flags.strict);
            let job = Job::from_file(&shot, &flags, &mut notes, reporter);
            reporter.notes(notes.take());
            render::render(job?, flags.device, notes, reporter)
        }
        Command::Compare {
            shot,
            flags,
            compare,
        } => compare::run(&shot, &flags, &compare, reporter),
        Command::Synth { input, flags } => synth::run(input.as_deref(), &flags, reporter),
        Command::Unwarp { input, flags } => unwarp::run(&input, &flags, reporter),
        Command::Sh { inputs, flags } => sh::run(&inputs, &flags, reporter),
        Command::Info { file: None, .. } => {
            info::devices(reporter);
            Ok(())
        }
        Command::Info {
            file: Some(file),
            set,
        } => info::file(&file, &set, reporter),
    }
}

/// Log lines go to standard error: errors alone, more with -v, or as the variable RUST_LOG says.
fn start_log(verbose: u8) {
    let default = match verbose {
        0 => "error",
        1 => "warn,glimt=info,glimt_render_gpu=info",
        _ => "info,glimt=debug,glimt_render_gpu=debug",
    };
    let filter = EnvFilter::try_from_default_env().unwrap_or_else(|_| EnvFilter::new(default));
    tracing_subscriber::fmt()
        .with_env_filter(filter)
        .with_ansi(std::io::stderr().is_terminal())
        .with_writer(std::io::stderr)
        .init();
}
