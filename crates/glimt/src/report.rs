//! Host file: what the program says while it works: a bar on a terminal, lines elsewhere, JSON lines if asked for.

use crate::cli::Talk;
use crate::error::Error;
use crate::notes::{Note, Severity};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use serde_json::{Value, json};
use std::io::{IsTerminal, Write};
use std::path::Path;
use std::sync::Mutex;

/// Steps of the bar for each frame.
const STEPS: u64 = 1000;

/// Says what happens. It can be shared between threads.
#[derive(Debug)]
pub struct Reporter {
    talk: Talk,
    bar: Mutex<Option<ProgressBar>>,
}

/// `1 frame`, `2 frames`.
pub fn count(n: usize, noun: &str) -> String {
    match n {
        1 => format!("1 {noun}"),
        n => format!("{n} {noun}s"),
    }
}

/// What became of a frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FrameStatus {
    /// It was there already.
    Skipped,
    /// It was rendered, in this many seconds.
    Rendered(f64),
}

impl Reporter {
    /// A reporter that talks as asked.
    pub fn new(talk: Talk) -> Self {
        Self {
            talk,
            bar: Mutex::new(None),
        }
    }

    /// Work on `frames` frames begins.
    pub fn start(&self, frames: usize, out: &Path, device: &str, triangles: usize) {
        self.event(&json!({
            "event": "start", "frames": frames, "out": out, "device": device, "triangles": triangles,
        }));
        let what = format!("{}, {triangles} triangles", count(frames, "frame"));
        self.begin(&what, frames, out, device);
    }

    /// Filming of `frames` frames begins.
    pub fn start_filming(&self, frames: usize, out: &Path, device: &str) {
        self.event(&json!({"event": "start", "frames": frames, "out": out, "device": device}));
        self.begin(&count(frames, "frame"), frames, out, device);
    }

    fn begin(&self, what: &str, frames: usize, out: &Path, device: &str) {
        if self.talk.quiet || self.talk.json {
            return;
        }
        self.line(&format!("{what}, on {device}, into {}", out.display()));
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

    /// A frame is done, and `done` of `frames` with it.
    pub fn frame(&self, frame: u32, status: FrameStatus, done: usize, frames: usize) {
        let (name, seconds) = match status {
            FrameStatus::Skipped => ("skipped", 0.0),
            FrameStatus::Rendered(seconds) => ("rendered", seconds),
        };
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

    /// A step before the first frame: `done` of `all` parts of it are.
    pub fn stage(&self, what: &str, done: usize, all: usize) {
        self.event(&json!({"event": "stage", "what": what, "done": done, "all": all}));
        if let Some(bar) = self.lock().as_ref() {
            bar.set_message(format!("{what}: {done}/{all}"));
            return;
        }
        // A line for each would drown what matters; ten tell that it goes on.
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
            self.event(&json!({"event": name, "file": note.file, "message": note.text}));
            let hidden = self.talk.quiet && note.severity == Severity::Note;
            if !hidden && !self.talk.json {
                self.line(&format!("{name}: {}: {}", note.file.display(), note.text));
            }
        }
    }

    /// A remark on the run itself.
    pub fn remark(&self, text: &str) {
        self.event(&json!({"event": "note", "message": text}));
        self.plain(&format!("note: {text}"));
    }

    /// The work is done; `summary` holds its numbers, `text` says them in words.
    pub fn finish(&self, mut summary: Value, text: &str) {
        if let Some(bar) = self.lock().take() {
            bar.finish_and_clear();
        }
        summary["event"] = json!("summary");
        self.event(&summary);
        self.plain(text);
    }

    /// The program ends with an error.
    pub fn error(&self, error: &Error) {
        if let Some(bar) = self.lock().take() {
            bar.abandon();
        }
        self.event(&json!({
            "event": "error",
            "file": error.file,
            "place": error.place.as_ref().map(ToString::to_string),
            "message": error.what,
            "fix": error.fix,
            "exit": error.kind as u8,
        }));
        self.line(&format!("error: {error}"));
    }

    /// An answer on standard output: `text`, or `value` as JSON.
    pub fn answer(&self, value: &Value, text: &str) {
        let mut out = std::io::stdout().lock();
        // A closed pipe (`glimt info | head`) is no error of ours.
        let _ = if self.talk.json {
            writeln!(out, "{value}")
        } else {
            writeln!(out, "{}", text.trim_end())
        };
    }

    /// A line of progress, which --quiet and --json leave out.
    fn plain(&self, text: &str) {
        if !self.talk.quiet && !self.talk.json {
            self.line(text);
        }
    }

    fn line(&self, text: &str) {
        let print = || {
            let _ = writeln!(std::io::stderr(), "{text}");
        };
        match self.lock().as_ref() {
            Some(bar) => bar.suspend(print),
            None => print(),
        }
    }

    fn event(&self, value: &Value) {
        if self.talk.json {
            let _ = writeln!(std::io::stdout().lock(), "{value}");
        }
    }

    fn lock(&self) -> std::sync::MutexGuard<'_, Option<ProgressBar>> {
        self.bar
            .lock()
            .unwrap_or_else(std::sync::PoisonError::into_inner)
    }
}
