//! Host file: what the program says while it works: a bar on a terminal, lines elsewhere, JSON lines if asked for.

use crate::cli::PrintFlags;
use crate::error::{Error, Result};
use crate::notes::{Note, Severity};
use crate::printable::{in_line, path_in_line, printable};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use serde_json::{Value, json};
use std::io::{IsTerminal, Write};
use std::path::Path;
use std::sync::{Arc, Mutex, MutexGuard, OnceLock, PoisonError};
use std::time::{Duration, Instant};

/// Steps of the bar for each frame.
const STEPS: u64 = 1000;

/// Says what happens. It can be shared between threads.
#[derive(Debug)]
pub struct Reporter {
    flags: PrintFlags,
    bar: Mutex<Option<ProgressBar>>,
    /// The first error of writing to standard output.
    failed: OnceLock<Error>,
    silence: Mutex<Silence>,
}

/// How long nothing has been said, and about what.
#[derive(Debug)]
struct Silence {
    since: Instant,
    /// What is done meanwhile; nothing where that says itself how far it is.
    work: Option<&'static str>,
    /// How long it may last before that is said.
    patience: Duration,
}

/// How long nothing may be said at first.
const FIRST_SILENCE: Duration = Duration::from_millis(350);

/// How long nothing may be said about the same work again.
const SILENCE: Duration = Duration::from_secs(5);

/// `1 frame`, `2 frames`.
pub fn count(n: usize, noun: &str) -> String {
    match n {
        1 => format!("1 {noun}"),
        n => format!("{n} {noun}s"),
    }
}

/// Seconds in words: `12 s`, `3 min 20 s`, `2 h 5 min`.
pub fn duration(seconds: f64) -> String {
    let seconds = seconds.max(0.0).round() as u64;
    match seconds {
        0..60 => format!("{seconds} s"),
        60..3600 => format!("{} min {} s", seconds / 60, seconds % 60),
        _ => format!("{} h {} min", seconds / 3600, seconds / 60 % 60),
    }
}

/// A path as text: `json!` panics at one that is not UTF-8.
#[must_use]
pub fn shown(path: &Path) -> String {
    path.display().to_string()
}

/// What became of a frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FrameStatus {
    /// It was there already.
    Skipped,
    /// It was rendered, in this many seconds.
    Rendered(f64),
}

impl FrameStatus {
    /// Its name, and the seconds of rendering.
    fn in_short(self) -> (&'static str, f64) {
        match self {
            Self::Skipped => ("skipped", 0.0),
            Self::Rendered(seconds) => ("rendered", seconds),
        }
    }
}

impl Reporter {
    /// A reporter that prints what the flags say.
    pub fn new(flags: PrintFlags) -> Self {
        Self {
            flags,
            bar: Mutex::new(None),
            failed: OnceLock::new(),
            silence: Mutex::new(Silence {
                since: Instant::now(),
                work: None,
                patience: FIRST_SILENCE,
            }),
        }
    }

    /// Begins work that reports nothing itself. If it takes long, its name is printed.
    pub fn busy(&self, work: &'static str) {
        *self.silence() = Silence {
            since: Instant::now(),
            work: Some(work),
            patience: FIRST_SILENCE,
        };
    }

    /// Breaks silences that are too long, on a thread of its own.
    ///
    /// # Errors
    /// The system has no thread for it.
    pub fn watch(self: &Arc<Self>) -> std::io::Result<()> {
        let reporter = Arc::clone(self);
        let watch = move || {
            loop {
                std::thread::sleep(FIRST_SILENCE / 4);
                reporter.break_silence();
            }
        };
        std::thread::Builder::new()
            .name("silence".to_owned())
            .spawn(watch)
            .map(drop)
    }

    fn break_silence(&self) {
        let work = {
            let mut silence = self.silence();
            if silence.since.elapsed() < silence.patience {
                return;
            }
            silence.patience = SILENCE;
            silence.work
        };
        if let Some(work) = work.filter(|_| !self.draws()) {
            self.step(work);
        }
    }

    fn silence(&self) -> MutexGuard<'_, Silence> {
        self.silence.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Whether all that was meant for standard output was written there.
    ///
    /// # Errors
    /// It was not: a disk is full, for example. A closed pipe (`glimt info | head`) is not an error.
    pub fn check_output(&self) -> Result<()> {
        match self.failed.get() {
            Some(error) => Err(error.clone()),
            None => Ok(()),
        }
    }

    /// Writes a line to standard output.
    fn print(&self, line: &str) {
        let mut out = std::io::stdout().lock();
        let written = writeln!(out, "{line}").and_then(|()| out.flush());
        if let Err(error) = written
            && error.kind() != std::io::ErrorKind::BrokenPipe
        {
            let error = Error::writing(Path::new("standard output"), &error);
            let _ = self.failed.set(error);
        }
    }

    /// Whether events go to standard output.
    pub fn is_json(&self) -> bool {
        self.flags.json
    }

    /// What comes says itself how far it is.
    fn begun(&self) {
        self.silence().work = None;
    }

    /// Work on `frames` frames begins.
    pub fn start(&self, frames: usize, out: &Path, device: &str, triangles: usize) {
        self.event(&json!({
            "event": "start", "frames": frames, "out": shown(out), "device": device, "triangles": triangles,
        }));
        let what = format!("{}, {triangles} triangles", count(frames, "frame"));
        self.begin(&what, frames, out, device);
    }

    /// Filming of `frames` frames begins.
    pub fn start_filming(&self, frames: usize, out: &Path, device: &str) {
        self.event(
            &json!({"event": "start", "frames": frames, "out": shown(out), "device": device}),
        );
        self.begin(&count(frames, "frame"), frames, out, device);
    }

    fn begin(&self, what: &str, frames: usize, out: &Path, device: &str) {
        self.begun();
        if self.flags.quiet || self.flags.json {
            return;
        }
        self.line(&format!("{what}, on {device}, into {}", path_in_line(out)));
        if std::io::stderr().is_terminal() {
            let style = ProgressStyle::with_template("{bar:32} {msg}, {elapsed} gone, {eta} to go")
                .unwrap_or_else(|_| ProgressStyle::default_bar());
            let bar = ProgressBar::with_draw_target(
                Some(frames as u64 * STEPS),
                ProgressDrawTarget::stderr(),
            );
            let bar = bar
                .with_style(style)
                .with_message(format!("0/{frames} frames"));
            *self.lock() = Some(bar);
        }
    }

    /// A comparison of so many contestants begins.
    pub fn start_comparing(&self, contestants: &[String], frames: usize, out: &Path, device: &str) {
        self.event(&json!({
            "event": "start", "contestants": contestants, "frames": frames, "out": shown(out), "device": device,
        }));
        self.plain(&format!(
            "{} in {}, on {device}, into {}",
            count(contestants.len(), "contestant"),
            count(frames, "measured frame"),
            path_in_line(out)
        ));
        self.start_bar();
    }

    /// A bar for [`progress`](Self::progress), on a terminal.
    pub fn start_bar(&self) {
        self.begun();
        if self.flags.quiet || self.flags.json {
            return;
        }
        if std::io::stderr().is_terminal() {
            let style = ProgressStyle::with_template("{bar:32} {msg}")
                .unwrap_or_else(|_| ProgressStyle::default_bar());
            let target = ProgressDrawTarget::stderr();
            let bar = ProgressBar::with_draw_target(Some(STEPS), target).with_style(style);
            *self.lock() = Some(bar);
        }
    }

    /// How far work of many kinds is: a share, and the seconds that are probably left, where that is known.
    pub fn progress(&self, what: &str, share: f64, left: Option<f64>) {
        self.event(&json!({"event": "progress", "what": what, "share": share, "left": left}));
        let text = match left {
            Some(left) => format!("{what}, {} to go", duration(left)),
            None => what.to_owned(),
        };
        if let Some(bar) = self.lock().as_ref() {
            bar.set_position((share * STEPS as f64) as u64);
            bar.set_message(text);
            return;
        }
        self.plain(&format!("{:3.0} %: {text}", share * 100.0));
    }

    /// Whether progress is drawn, and not printed line by line.
    pub fn draws(&self) -> bool {
        self.lock().is_some()
    }

    /// Frames are rendered as they appear.
    pub fn start_following(&self, files: &Path, out: &Path, device: &str, triangles: usize) {
        self.begun();
        self.event(&json!({
            "event": "start", "follow": shown(files), "out": shown(out), "device": device, "triangles": triangles,
        }));
        self.plain(&format!(
            "following {}, {triangles} triangles, on {device}, into {}",
            path_in_line(files),
            path_in_line(out)
        ));
    }

    /// A frame that was followed is done, `lag` seconds after it came; `dropped` have been dropped so far.
    pub fn live_frame(&self, frame: i32, status: FrameStatus, lag: f64, dropped: usize) {
        let (name, seconds) = status.in_short();
        self.event(&json!({
            "event": "frame", "frame": frame, "status": name, "seconds": seconds, "lag": lag, "dropped": dropped,
        }));
        self.plain(&match status {
            FrameStatus::Skipped => format!("frame {frame}: was there already"),
            FrameStatus::Rendered(_) => {
                format!("frame {frame}: {seconds:.2} s, {lag:.2} s after it came")
            }
        });
    }

    /// A frame that was followed is not rendered. If the reason is a fault of it, --quiet does not hide that.
    pub fn dropped(&self, frame: i32, file: &Path, reason: &str, is_fault: bool) {
        self.event(
            &json!({"event": "dropped", "frame": frame, "file": shown(file), "reason": reason}),
        );
        match (is_fault, self.flags.json) {
            (true, false) => {
                self.line(&format!(
                    "warning: frame {frame} is dropped: {reason} ({})",
                    path_in_line(file)
                ));
            }
            _ => self.plain(&format!("frame {frame}: dropped, {reason}")),
        }
    }

    /// A frame is done, and `done` of `frames` with it.
    pub fn frame(&self, frame: i32, status: FrameStatus, done: usize, frames: usize) {
        let (name, seconds) = status.in_short();
        self.event(&json!({"event": "frame", "frame": frame, "status": name, "seconds": seconds}));
        if let Some(bar) = self.lock().as_ref() {
            // The renderer may be further on already than what is written.
            bar.set_position(bar.position().max(done as u64 * STEPS));
            bar.set_message(format!("{done}/{frames} frames"));
            return;
        }
        let text = match status {
            FrameStatus::Skipped => "was there already".to_owned(),
            FrameStatus::Rendered(seconds) => format!("{seconds:.2} s"),
        };
        self.plain(&format!("frame {frame}: {text} ({done}/{frames})"));
    }

    /// A part of the frame after the first `done` is rendered.
    pub fn part(&self, done: usize, fraction: f32) {
        if let Some(bar) = self.lock().as_ref() {
            let part = (f64::from(fraction) * STEPS as f64) as u64;
            bar.set_position(done as u64 * STEPS + part.min(STEPS));
        }
    }

    /// One of several parts of the work begins.
    pub fn step(&self, what: &str) {
        self.event(&json!({"event": "step", "what": what}));
        self.plain(what);
    }

    /// A step before the first frame: `done` of `all` parts of it are.
    pub fn stage(&self, what: &str, done: usize, all: usize) {
        self.event(&json!({"event": "stage", "what": what, "done": done, "all": all}));
        if let Some(bar) = self.lock().as_ref() {
            bar.set_message(format!("{what}: {done}/{all}"));
            return;
        }
        // A line for each would drown what matters; ten show that it continues.
        if done == all || done * 10 / all != (done - 1) * 10 / all {
            self.plain(&format!("{what}: {done}/{all}"));
        }
    }

    /// Remarks on inputs.
    pub fn notes(&self, notes: Vec<Note>) {
        for note in notes {
            let name = match note.severity {
                Severity::Note => "note",
                Severity::Warning => "warning",
            };
            self.event(&json!({"event": name, "file": shown(&note.file), "message": note.text}));
            let hidden = self.flags.quiet && note.severity == Severity::Note;
            if !hidden && !self.flags.json {
                self.line(&format!(
                    "{name}: {}: {}",
                    path_in_line(&note.file),
                    note.text
                ));
            }
        }
    }

    /// A remark on the run itself.
    pub fn remark(&self, text: &str) {
        self.event(&json!({"event": "note", "message": text}));
        self.plain(&format!("note: {text}"));
    }

    /// A warning about the run itself.
    pub fn warn(&self, text: &str) {
        self.event(&json!({"event": "warning", "message": text}));
        if !self.flags.json {
            self.line(&format!("warning: {text}"));
        }
    }

    /// The work is done; `summary` holds its numbers, `text` says them in words.
    pub fn finish(&self, mut summary: Value, text: &str) {
        if let Some(bar) = self.lock().take() {
            bar.finish_and_clear();
        }
        summary["event"] = json!("summary");
        self.event(&summary);
        if !self.flags.quiet && !self.flags.json {
            text.lines().for_each(|line| self.line(line));
        }
    }

    /// The program ends with an error.
    pub fn error(&self, error: &Error) {
        if let Some(bar) = self.lock().take() {
            bar.abandon();
        }
        self.event(&json!({
            "event": "error",
            "file": error.file.as_deref().map(shown),
            "place": error.place.as_ref().map(ToString::to_string),
            "message": error.what,
            "fix": error.fix,
            "exit": error.kind as u8,
        }));
        self.line(&format!("error: {error}"));
    }

    /// An answer on standard output: `text`, or `value` as JSON.
    pub fn answer(&self, value: &Value, text: &str) {
        match self.flags.json {
            true => self.print(&value.to_string()),
            false => self.print(&printable(text.trim_end())),
        }
    }

    /// A line of progress, which --quiet and --json leave out.
    fn plain(&self, text: &str) {
        if !self.flags.quiet && !self.flags.json {
            self.line(text);
        }
    }

    fn line(&self, text: &str) {
        self.silence().since = Instant::now();
        let print = || {
            let _ = writeln!(std::io::stderr(), "{}", in_line(text));
        };
        match self.lock().as_ref() {
            Some(bar) => bar.suspend(print),
            None => print(),
        }
    }

    fn event(&self, value: &Value) {
        if self.flags.json {
            self.silence().since = Instant::now();
            self.print(&value.to_string());
        }
    }

    fn lock(&self) -> MutexGuard<'_, Option<ProgressBar>> {
        self.bar.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
