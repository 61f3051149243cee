//! Host file: the state that a long run of frames which continue from one another saves on its way, so that it continues where it was
//! killed.

use crate::error::Result;
use crate::job::Job;
use crate::memory;
use crate::output::atomic::Pending;
use crate::output::state::{self, Saved};
use crate::report::{Reporter, count};
use crate::shot::digest::Hash;
use std::fs;
use std::path::PathBuf;

/// Name of its file, beside the frames.
const NAME: &str = ".glimt.state";

/// Frames from one to the next.
const EVERY: usize = 32;

/// The largest that is saved on the way.
const MOST_BYTES: u64 = 1 << 30;

/// Where a run saves on its way.
#[derive(Clone, Debug)]
pub struct Checkpoint {
    file: PathBuf,
    /// Frames computed since the last one.
    since: usize,
}

impl Checkpoint {
    /// Of a run, if its frames continue from one another and no other run shares its folder.
    pub fn of(job: &Job) -> Option<Self> {
        (job.is_chain() && !job.share).then(|| Self {
            file: job.setup.out.join(NAME),
            since: 0,
        })
    }

    /// The frame, by its index, from whose state the run can continue, with the state: the one that is saved, if no frame up to it is
    /// missing. `chains` are hashes of all that each frame came from; `missing` is the index of the first frame that is to be made.
    pub fn find(&self, job: &Job, chains: &[Hash], missing: usize) -> Option<(usize, Saved)> {
        let [chain, setup] = state::read_hashes(&self.file)?;
        let index = chains.iter().position(|own| *own == chain)?;
        if index >= missing || setup != job.setup.digest {
            return None;
        }
        // A damaged state counts as missing.
        let saved = state::read(&self.file).ok()?;
        Some((index, saved))
    }

    /// Counts a frame that was computed; whether it is time to save.
    pub fn is_due(&mut self) -> bool {
        self.since += 1;
        self.since >= EVERY
    }

    /// Saves a state. Where that fails the run warns and continues without it.
    pub fn save(&mut self, job: &Job, saved: &Saved, reporter: &Reporter) {
        self.since = 0;
        let write = || -> Result<()> {
            let target = job.setup.guard.target(&self.file)?;
            state::write(&mut Pending::create(&target)?, saved)
        };
        if let Err(error) = write() {
            reporter.warn(&format!(
                "the run cannot be continued from here if it is stopped: {error}"
            ));
        }
    }

    /// Says where a state is too large to be saved on the way; whether it is.
    pub fn is_too_large(job: &Job, frames: usize, reporter: &Reporter) -> bool {
        let bytes = job.state_bytes();
        let is_too_large = bytes > MOST_BYTES;
        if is_too_large && frames > EVERY {
            reporter.remark(&format!(
                "what the method keeps takes {}, so it is not saved every {}: a run that is stopped begins again; shorter runs with \
                 --state-out and --state-in do not",
                memory::in_words(bytes),
                count(EVERY, "frame")
            ));
        }
        is_too_large
    }

    /// Removes the file: all frames are there.
    pub fn remove(&self) {
        let _ = fs::remove_file(&self.file);
    }
}
