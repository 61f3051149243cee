//! Host file: the command line, from arguments to an exit status.

use clap::Parser;
use glimt::cli::Cli;
use glimt::command;
use glimt::error::{Error, Kind};
use glimt::report::Reporter;
use std::io::IsTerminal;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::process::ExitCode;
use tracing_subscriber::EnvFilter;

fn main() -> ExitCode {
    let cli = Cli::parse();
    start_log(cli.print.verbose);
    let reporter = Reporter::new(cli.print);
    let outcome = catch_unwind(AssertUnwindSafe(|| command::run(cli.command, &reporter)))
        .unwrap_or_else(|_| {
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
