//! Host file: frames taken from a folder as they come, one ahead of the renderer.

use super::ball::Ball;
use super::plates::{Laid, Plates};
use super::tally::{Tally, Why};
use super::watch::{POLL, State, Watcher, choose};
use super::{Follow, read_live};
use crate::error::Result;
use crate::frame::Frames;
use crate::light::{self, Probe, colour};
use crate::notes::Notes;
use crate::output::Stamp;
use crate::shot::Mapping;
use crate::shot::digest::{self, Hash};
use glimt_render_gpu::host::env::PreparedEnv;
use glimt_render_gpu::host::plate::Plate;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::sleep;
use std::time::{Instant, SystemTime};

/// A frame that has been taken.
pub(super) struct Taken {
    /// Its number and identity.
    pub(super) stamp: Stamp,
    /// When its light came.
    pub(super) arrived: SystemTime,
    /// What it is rendered from; nothing where its outputs are there.
    pub(super) inputs: Option<Inputs>,
}

/// What a frame is rendered from.
pub(super) struct Inputs {
    /// The light, with its tables.
    pub(super) light: PreparedEnv,
    /// The footage behind it.
    pub(super) plate: Option<Arc<Plate>>,
}

/// Takes frames.
pub(super) struct Taker<'a> {
    follow: &'a Follow<'a>,
    tally: &'a Tally<'a>,
    watch: Watcher,
    plates: Option<Plates>,
    ball: Option<Ball>,
    /// The light, once its first frame has come.
    probe: Option<Probe>,
    has_colour: bool,
    /// Hash of all lights so far, for frames that go on from one another.
    chain: Hash,
    notes: Notes,
}

impl<'a> Taker<'a> {
    /// Takes the frames of `watch`.
    pub(super) fn new(
        follow: &'a Follow<'a>,
        tally: &'a Tally<'a>,
        mut watch: Watcher,
        plates: Option<Plates>,
        notes: Notes,
    ) -> Self {
        watch.begin();
        let keys = &follow.setup.shot.probe;
        let ball = (keys.mapping == Mapping::MirrorBall)
            .then(|| Ball::new(&keys.ball.clone().unwrap_or_default()));
        Self {
            follow,
            tally,
            watch,
            plates,
            ball,
            probe: None,
            chain: [0; 32],
            has_colour: false,
            notes,
        }
    }

    /// The next frame, waiting for it; `None` when there are no more, or `stop` says so.
    ///
    /// # Errors
    /// A defect of an input that `--strict` refuses, or an input that does not fit the shot.
    pub(super) fn next(&mut self, stop: &AtomicBool) -> Result<Option<Taken>> {
        while !stop.load(Ordering::Relaxed) {
            self.watch.look();
            if let Some(plates) = &mut self.plates {
                plates.look();
            }
            for frame in self.watch.take_late() {
                let why = "it came after a later one was taken".to_owned();
                self.tally
                    .drop(frame, &self.watch.files().path(frame), Why::Wrong(why));
            }
            let waiting = self.watch.waiting(self.follow.last, self.follow.wait);
            let choice = choose(&waiting);
            for unwanted in choice.drop {
                let why = match (unwanted.state, self.watch.failure(unwanted.frame)) {
                    (State::Whole, _) => Why::Behind,
                    (_, Some(error)) => Why::Wrong(error.to_string()),
                    (_, None) => Why::Wrong("it is still being written".to_owned()),
                };
                self.drop(unwanted.frame, why);
            }
            if let Some(frame) = choice.take {
                let taken = self.take(frame);
                self.follow.reporter.notes(self.notes.take());
                if let Some(taken) = taken? {
                    return Ok(Some(taken));
                }
            } else if self.is_over() {
                return Ok(None);
            } else {
                sleep(POLL);
            }
        }
        Ok(None)
    }

    /// Whether no frame will come: the last one has passed, or nothing has happened for too long.
    fn is_over(&self) -> bool {
        let last = self.follow.last;
        let waits = !self.watch.waiting(last, self.follow.wait).is_empty();
        let passed = last.is_some_and(|last| {
            self.watch.highest() > Some(last) || self.watch.next_wanted() > last
        });
        !waits && (passed || self.watch.idle() > self.follow.wait)
    }

    fn drop(&mut self, frame: u32, why: Why) {
        let gap = self.watch.pass(frame);
        self.tally.drop(frame, &self.watch.files().path(frame), why);
        if let Some(gap) = gap {
            self.tally.missing(gap);
        }
    }

    /// Takes a frame; `None` where it is dropped, or cannot be read yet.
    fn take(&mut self, frame: u32) -> Result<Option<Taken>> {
        let began = Instant::now();
        let file = self.watch.files().path(frame);
        let mapping = self.follow.setup.shot.probe.mapping;
        let read = read_live(&mut self.notes, |notes| {
            light::read_frame(mapping, &file, notes)
        })?;
        let image = match read {
            Ok(image) => image,
            Err(error) => {
                self.watch.failed(frame, error);
                return Ok(None);
            }
        };
        let read = began.elapsed();
        let arrived = self.watch.arrival(frame);
        if let Some(gap) = self.watch.pass(frame) {
            self.tally.missing(gap);
        }
        let wrong = |what: String| {
            self.tally.drop(frame, &file, Why::Wrong(what));
            Ok(None)
        };
        if let Some(probe) = &self.probe
            && let Err(error) = probe.check_size(&file, image.size)
        {
            return wrong(error.what);
        }
        let pose = match &mut self.ball {
            None => None,
            Some(ball) => match ball.locate(frame, &file, &image, &mut self.notes) {
                Ok(pose) => Some(pose),
                Err(error) => return wrong(error.what),
            },
        };
        let located = began.elapsed() - read;
        let laid = match &mut self.plates {
            None => None,
            Some(plates) => {
                let first = self.watch.lowest().unwrap_or(frame);
                let setup = &self.follow.setup;
                match plates.of_frame(frame, first, setup, &mut self.notes)? {
                    None => return wrong("there has been no backplate yet".to_owned()),
                    laid => laid,
                }
            }
        };
        let setup = &self.follow.setup;
        if self.probe.is_none() {
            let files = self.watch.files().clone();
            let keys = &setup.shot.probe;
            let probe = Probe::live(files, keys, &file, image.size, pose, &mut self.notes)?;
            self.probe = Some(probe);
        }
        self.match_colours(frame, &file, laid.as_ref())?;
        let Some(probe) = &self.probe else {
            return Ok(None);
        };
        let mut inputs = probe.digest_at(&digest::of_file(&file)?, pose);
        if let Some(laid) = &laid {
            inputs = digest::join([&inputs, &laid.hash]);
        }
        let is_chain = setup.shot.render.goes_on();
        if is_chain {
            self.chain = digest::join([&self.chain, &inputs]);
            inputs = self.chain;
        }
        let hash = digest::of_frame(&setup.digest, &inputs, frame);
        let stamp = Stamp { hash, frame };
        let mut taken = Taken {
            stamp,
            arrived,
            inputs: None,
        };
        // Of frames that go on from one another none is left out.
        if !is_chain && Frames::of(setup).are_there(&taken.stamp) {
            return Ok(Some(taken));
        }
        let tables = Instant::now();
        let light = match probe.light_of(image, &file, pose, &mut self.notes) {
            Ok(map) => setup.tables(map, Some(&file))?,
            Err(error) => return wrong(error.what),
        };
        tracing::info!(
            "light of frame {frame}: read in {read:.2?}, ball found in {located:.2?}, map and tables in {:.2?}",
            tables.elapsed()
        );
        taken.inputs = Some(Inputs {
            light,
            plate: laid.map(|laid| laid.plate),
        });
        Ok(Some(taken))
    }

    /// Fits the colours, on the first frame that is taken.
    fn match_colours(&mut self, frame: u32, file: &Path, laid: Option<&Laid>) -> Result<()> {
        let setup = &self.follow.setup;
        let (Some(keys), false, Some(probe)) =
            (&setup.shot.probe.colour, self.has_colour, &mut self.probe)
        else {
            return Ok(());
        };
        if let Some(other) = keys.frame.filter(|other| *other != frame) {
            let what = format!(
                "colours are matched here, not in frame {other}, which live frames are not waited for"
            );
            self.notes.note(file, what);
        }
        let plate = laid.map(|laid| laid.file.as_path());
        let colour = colour::correction(keys, &setup.source, file, plate, &mut self.notes)?;
        probe.set_colour(colour);
        self.has_colour = true;
        Ok(())
    }
}
