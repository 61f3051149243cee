//! Host file: how far a comparison is, and how long it will still take.

use crate::report::Reporter;
use std::time::{Duration, Instant};

/// Counts seconds of rendering that are done and that are planned.
pub struct Progress<'a> {
    reporter: &'a Reporter,
    began: Instant,
    reported: Option<Instant>,
    done: f64,
    planned: f64,
}

impl<'a> Progress<'a> {
    /// Nothing is done or planned.
    #[must_use]
    pub fn new(reporter: &'a Reporter) -> Self {
        Self {
            reporter,
            began: Instant::now(),
            reported: None,
            done: 0.0,
            planned: 0.0,
        }
    }

    /// So many seconds of rendering are left from here.
    pub fn plan(&mut self, seconds: f64) {
        self.planned = seconds;
    }

    /// A frame took so many seconds; it is a part of what was planned.
    pub fn rendered(&mut self, what: &str, seconds: f64) {
        self.done += seconds;
        self.planned = (self.planned - seconds).max(0.0);
        let every = match self.reporter.draws() {
            true => Duration::from_millis(100),
            false => Duration::from_secs(5),
        };
        if self.reported.is_some_and(|at| at.elapsed() < every) {
            return;
        }
        self.reported = Some(Instant::now());
        // Reading and measuring take time beside rendering.
        let slower = (self.began.elapsed().as_secs_f64() / self.done.max(1e-9)).clamp(1.0, 20.0);
        if self.planned == 0.0 {
            // How long it will be is what is being measured.
            return self.reporter.progress(what, 0.0, None);
        }
        let share = self.done / (self.done + self.planned);
        self.reporter
            .progress(what, share, Some(self.planned * slower));
    }
}
