//! Host file: what became of the frames that came: rendered, there already, dropped, and how far behind.

use super::Follow;
use crate::printable::path_in_line;
use crate::report::{FrameStatus, Reporter, count, shown};
use serde_json::{Value, json};
use std::path::Path;
use std::sync::{Mutex, PoisonError};
use std::time::{Instant, SystemTime};

/// Counts, and reports. It can be shared between threads.
pub(super) struct Tally<'a> {
    reporter: &'a Reporter,
    counts: Mutex<Counts>,
}

#[derive(Default)]
struct Counts {
    rendered: usize,
    skipped: usize,
    dropped: Vec<i32>,
    missing: Vec<[i32; 2]>,
    lags: Vec<f64>,
    /// When the first and the last frame were written.
    written: Option<[Instant; 2]>,
    last_reason: Option<String>,
}

/// DropReason a frame is dropped.
pub(super) enum DropReason {
    /// Later ones are there.
    Behind,
    /// Something is wrong with it.
    Wrong(String),
}

impl<'a> Tally<'a> {
    /// Nothing yet.
    pub(super) fn new(reporter: &'a Reporter) -> Self {
        Self {
            reporter,
            counts: Mutex::default(),
        }
    }

    /// A frame is written or was there; `arrived` is when its light came.
    pub(super) fn frame(&self, frame: i32, status: FrameStatus, arrived: SystemTime) {
        let lag = arrived.elapsed().map_or(0.0, |lag| lag.as_secs_f64());
        let mut counts = self.lock();
        match status {
            FrameStatus::Skipped => counts.skipped += 1,
            FrameStatus::Rendered(_) => {
                counts.rendered += 1;
                counts.lags.push(lag);
                let now = Instant::now();
                let first = counts.written.map_or(now, |[first, _]| first);
                counts.written = Some([first, now]);
            }
        }
        self.reporter
            .live_frame(frame, status, lag, counts.dropped.len());
    }

    /// A frame is dropped.
    pub(super) fn drop(&self, frame: i32, file: &Path, why: DropReason) {
        let mut counts = self.lock();
        counts.dropped.push(frame);
        let (reason, is_fault) = match why {
            DropReason::Behind => ("later frames are there already".to_owned(), false),
            DropReason::Wrong(reason) => (reason, true),
        };
        self.reporter.dropped(frame, file, &reason, is_fault);
        counts.last_reason = Some(reason);
    }

    /// Frames never came.
    pub(super) fn missing(&self, [first, last]: [i32; 2]) {
        self.lock().missing.push([first, last]);
        let which = match first == last {
            true => format!("frame {first} is"),
            false => format!("frames {first} to {last} are"),
        };
        self.reporter
            .remark(&format!("{which} missing: later ones came first"));
    }

    /// How many frames are there now, whether rendered or from before.
    pub(super) fn done(&self) -> usize {
        let counts = self.lock();
        counts.rendered + counts.skipped
    }

    /// How many were dropped, and why the last one was.
    pub(super) fn lost(&self) -> Option<(usize, String)> {
        let counts = self.lock();
        Some((counts.dropped.len(), counts.last_reason.clone()?))
    }

    /// The numbers at the end, and the same in words.
    pub(super) fn summary(&self, follow: &Follow<'_>, video: Option<&Path>) -> (Value, String) {
        let mut counts = self.lock();
        counts.lags.sort_unstable_by(f64::total_cmp);
        counts.dropped.sort_unstable();
        let median = counts.lags.get(counts.lags.len() / 2).copied();
        let largest = counts.lags.last().copied();
        let fps = counts.written.and_then(|[first, last]| {
            let seconds = (last - first).as_secs_f64();
            (seconds > 0.0).then(|| (counts.rendered - 1) as f64 / seconds)
        });
        let out = &follow.setup.out;
        let seconds = follow.began.elapsed().as_secs_f64();
        let summary = json!({
            "rendered": counts.rendered, "skipped": counts.skipped, "dropped": counts.dropped,
            "missing": counts.missing, "lag_median": median, "lag_largest": largest, "fps": fps,
            "seconds": seconds, "out": shown(out), "video": video.map(shown),
        });
        let mut text = format!("{} rendered", count(counts.rendered, "frame"));
        if counts.skipped > 0 {
            text += &format!(", {} there already", counts.skipped);
        }
        text += &match counts.dropped.len() {
            0 => ", none dropped".to_owned(),
            n => format!(", {n} dropped ({})", in_words(&counts.dropped)),
        };
        if let (Some(median), Some(largest)) = (median, largest) {
            text += &format!("; lag {median:.2} s, at most {largest:.2} s");
        }
        if let Some(fps) = fps {
            text += &format!("; {fps:.1} frames a second");
        }
        text += &format!("; in {seconds:.1} s: {}", path_in_line(out));
        if let Some(video) = video {
            text += &format!(" and {}", path_in_line(video));
        }
        (summary, text)
    }

    fn lock(&self) -> std::sync::MutexGuard<'_, Counts> {
        self.counts.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Numbers in order, as `3, 5-7`.
fn in_words(numbers: &[i32]) -> String {
    let mut runs: Vec<[i32; 2]> = Vec::new();
    for &number in numbers {
        match runs.last_mut() {
            Some([_, last]) if number <= last.saturating_add(1) => *last = number,
            _ => runs.push([number; 2]),
        }
    }
    let run = |[first, last]: &[i32; 2]| match first == last {
        true => first.to_string(),
        false => format!("{first}-{last}"),
    };
    let words: Vec<String> = runs.iter().map(run).collect();
    words.join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn runs_are_joined() {
        assert_eq!(in_words(&[3, 5, 6, 7, 9]), "3, 5-7, 9");
        assert_eq!(in_words(&[]), "");
    }
}
