//! Host file: SIGINT and SIGTERM: work ends after the frame that is under way, or is abandoned if that takes too long.
//!
//! The first signal asks the loops over frames to end, which look at [`check`] or [`requested`]. Where the program is not at its end
//! a little later, what is half written is removed and the program ends. A second signal ends it at once.

use crate::error::{Error, Kind, Result};
use crate::output::atomic;
use crate::report::Reporter;
use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::flag;
use std::io;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Arc, OnceLock};
use std::time::Duration;

/// How long a frame may take to its end after a signal.
const GRACE: Duration = Duration::from_secs(3);

/// Time between two looks at whether a signal has come.
const LOOK: Duration = Duration::from_millis(20);

/// Whether what is left to do may take longer.
static FINISHING: AtomicBool = AtomicBool::new(false);

/// No frame is under way any more: what is still to be done is not abandoned, however long it takes.
pub fn finishing() {
    FINISHING.store(true, Ordering::Relaxed);
}

/// The number of the signal that came, once one has.
static SIGNAL: OnceLock<Arc<AtomicUsize>> = OnceLock::new();

/// The signal that asks the program to end, if one has come.
#[must_use]
pub fn requested() -> Option<Kind> {
    match SIGNAL.get()?.load(Ordering::Relaxed) as i32 {
        SIGINT => Some(Kind::Interrupted),
        SIGTERM => Some(Kind::Terminated),
        _ => None,
    }
}

/// Sees that no signal has asked the program to end.
///
/// # Errors
/// One has; `done` says what is there then.
pub fn check(done: impl FnOnce() -> String) -> Result<()> {
    match requested() {
        Some(kind) => Err(ended(kind, &done())),
        None => Ok(()),
    }
}

/// The end by a signal; `done` says what is there.
#[must_use]
pub fn ended(kind: Kind, done: &str) -> Error {
    let signal = match kind {
        Kind::Terminated => "SIGTERM",
        _ => "SIGINT",
    };
    Error::new(kind, format!("ended by {signal}: {done}"))
        .fix("the same command continues from there")
}

/// Begins to listen for signals. What `reporter` says last, if work has to be abandoned, is that it was.
///
/// # Errors
/// The system refuses.
pub fn listen(reporter: &Arc<Reporter>) -> io::Result<()> {
    let came = Arc::new(AtomicUsize::new(0));
    let again = Arc::new(AtomicBool::new(false));
    for signal in [SIGINT, SIGTERM] {
        // In this order: the second signal finds the flag that the first one sets.
        flag::register_conditional_shutdown(signal, 128 + signal, Arc::clone(&again))?;
        flag::register(signal, Arc::clone(&again))?;
        flag::register_usize(signal, Arc::clone(&came), signal as usize)?;
    }
    let _ = SIGNAL.set(came);
    let reporter = Arc::clone(reporter);
    std::thread::Builder::new()
        .name("signals".to_owned())
        .spawn(move || abandon_late(&reporter))?;
    Ok(())
}

fn abandon_late(reporter: &Reporter) {
    let kind = loop {
        match requested() {
            Some(kind) => break kind,
            None => std::thread::sleep(LOOK),
        }
    };
    std::thread::sleep(GRACE);
    if FINISHING.load(Ordering::Relaxed) {
        return;
    }
    atomic::remove_unfinished();
    let done = "what was under way is abandoned; all files that are there are whole";
    reporter.error(&ended(kind, done));
    std::process::exit(kind.status());
}
