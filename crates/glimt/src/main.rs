//! Host file: the command line, from arguments to an exit status.

#![deny(unsafe_code)]

use clap::Parser;
use glimt::cli::{Cli, PrintFlags};
use glimt::command;
use glimt::error::{Error, Kind};
use glimt::interrupt;
use glimt::report::Reporter;
use std::io::IsTerminal;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::process::ExitCode;
use std::sync::Arc;
use tracing_subscriber::EnvFilter;

fn main() -> ExitCode {
    let cli = match Cli::try_parse() {
        Ok(cli) => cli,
        Err(error) => return refuse(&error),
    };
    start_log(cli.print.verbose);
    let reporter = Arc::new(Reporter::new(cli.print));
    if let Err(error) = interrupt::listen(&reporter) {
        tracing::warn!("signals end the program at once: {error}");
    }
    if let Err(error) = reporter.watch() {
        tracing::warn!("long silences are not broken: {error}");
    }
    let outcome = catch_unwind(AssertUnwindSafe(|| command::run(cli.command, &reporter)))
        .unwrap_or_else(|_| {
            Err(Error::new(
                Kind::Internal,
                "this is a fault of glimt; please report it",
            ))
        });
    match outcome.and_then(|()| reporter.check_output()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            reporter.error(&error);
            ExitCode::from(error.kind as u8)
        }
    }
}

/// Says what is wrong with the command line, or what it asks for: help, the version. Programs that read events get an event.
fn refuse(error: &clap::Error) -> ExitCode {
    let mut before_files = std::env::args_os().take_while(|arg| arg != "--");
    if error.use_stderr() && before_files.any(|arg| arg == "--json") {
        let text = error.to_string();
        let text = text.strip_prefix("error: ").unwrap_or(&text);
        let (what, help) = text.split_once("\n\n").unwrap_or((text, ""));
        let flags = PrintFlags {
            quiet: false,
            json: true,
            verbose: 0,
        };
        Reporter::new(flags).error(&Error::usage(what).fix(help));
        return ExitCode::from(Kind::Usage as u8);
    }
    let _ = error.print();
    ExitCode::from(error.exit_code() as u8)
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
