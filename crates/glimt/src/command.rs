//! Host file: the commands, each handed over to who does it.

use crate::cli::{Command, RenderFlags};
use crate::error::Result;
use crate::job::Job;
use crate::notes::Notes;
use crate::report::Reporter;
use crate::{bake, compare, demo, follow, info, render, sh, synth, unwarp};

/// Does what a command asks for.
///
/// # Errors
/// The first thing that fails.
pub fn run(command: Command, reporter: &Reporter) -> Result<()> {
    reporter.busy("reading what the command names");
    match command {
        Command::Demo { flags } => demo::run(&flags, reporter),
        Command::Render {
            shot,
            flags,
            follow,
            ..
        } if follow.follow => follow::render(&shot, &flags, &follow, reporter),
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
        Command::Bake { shot, flags } => bake::run(&shot, &flags, reporter),
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
