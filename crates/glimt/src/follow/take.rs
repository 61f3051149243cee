//! Host file: frames taken from a folder as they come, one ahead of the renderer.

use super::ball::Ball;
use super::plates::{PlateOfFrame, Plates};
use super::tally::{DropReason, Tally};
use super::watch::{State, Waiting, Watcher, choose};
use super::{Follow, read_live};
use crate::error::{Error, Result};
use crate::frame::Frames;
use crate::input::Reading;
use crate::input::light_image::LightImage;
use crate::interrupt;
use crate::light::{self, FirstImage, Probe, colour};
use crate::notes::Notes;
use crate::output::Stamp;
use crate::shot::Mapping;
use crate::shot::digest::{self, Hash};
use glimt_render_gpu::prepare::env::PreparedEnv;
use glimt_render_gpu::prepare::plate::Plate;
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

/// Why a frame that was read is not taken.
enum NotTaken {
    /// It is dropped, for this reason.
    Dropped(String),
    /// Following ends.
    Failed(Error),
}

impl From<Error> for NotTaken {
    fn from(error: Error) -> Self {
        Self::Failed(error)
    }
}

/// What is wrong with a frame is a reason to drop it.
fn dropped(error: Error) -> NotTaken {
    NotTaken::Dropped(error.what)
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
    /// Hash of all lights so far, for frames that continue from one another.
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
        let ball = (keys.mapping == Some(Mapping::MirrorBall))
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
        while !stop.load(Ordering::Relaxed) && interrupt::requested().is_none() {
            self.watch.look();
            if let Some(plates) = &mut self.plates {
                plates.look();
            }
            for frame in self.watch.take_late() {
                let why = "it came after a later one was taken".to_owned();
                self.tally.drop(
                    frame,
                    &self.watch.files().path(frame),
                    DropReason::Wrong(why),
                );
            }
            let waiting = self.waiting();
            let choice = choose(&waiting);
            for unwanted in choice.drop {
                let why = match (unwanted.state, self.watch.failure(unwanted.frame)) {
                    (State::Whole | State::Late, _) => DropReason::Behind,
                    (_, Some(error)) => DropReason::Wrong(error.to_string()),
                    (_, None) => DropReason::Wrong("it is still being written".to_owned()),
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
                sleep(self.watch.pause());
            }
        }
        Ok(None)
    }

    /// The frames that wait.
    fn waiting(&self) -> Vec<Waiting> {
        let Follow {
            last,
            wait,
            max_lag,
            ..
        } = *self.follow;
        self.watch.waiting(last, wait, max_lag)
    }

    /// Whether no frame will come: the last one has passed, or nothing has happened for too long.
    fn is_over(&self) -> bool {
        let last = self.follow.last;
        let waits = !self.waiting().is_empty();
        let passed = last.is_some_and(|last| {
            self.watch.highest() > Some(last) || self.watch.next_wanted() > last
        });
        !waits && (passed || self.watch.idle() > self.follow.wait)
    }

    fn drop(&mut self, frame: i32, why: DropReason) {
        let gap = self.watch.pass(frame);
        self.tally.drop(frame, &self.watch.files().path(frame), why);
        if let Some(gap) = gap {
            self.tally.missing(gap);
        }
    }

    /// Takes a frame; `None` where it is dropped, or cannot be read yet.
    fn take(&mut self, frame: i32) -> Result<Option<Taken>> {
        let began = Instant::now();
        let file = self.watch.files().path(frame);
        let shot = &self.follow.setup.shot;
        let (mapping, reading) = (shot.probe.mapping, Reading::of_probe(shot));
        let read = read_live(&mut self.notes, |notes| {
            light::read_frame(mapping, &file, &reading, notes)
        })?;
        let image = match read {
            Ok(image) => image,
            Err(error) => {
                self.watch.failed(frame, error);
                return Ok(None);
            }
        };
        tracing::info!("light of frame {frame}: read in {:.2?}", began.elapsed());
        let arrived = self.watch.arrival(frame);
        if let Some(gap) = self.watch.pass(frame) {
            self.tally.missing(gap);
        }
        match self.prepare(frame, &file, image) {
            Ok((stamp, inputs)) => Ok(Some(Taken {
                stamp,
                arrived,
                inputs,
            })),
            Err(NotTaken::Dropped(reason)) => {
                self.tally.drop(frame, &file, DropReason::Wrong(reason));
                Ok(None)
            }
            Err(NotTaken::Failed(error)) => Err(error),
        }
    }

    /// The identity of a frame whose image was read, and what it is rendered from, where its outputs are not there.
    fn prepare(
        &mut self,
        frame: i32,
        file: &Path,
        image: LightImage,
    ) -> std::result::Result<(Stamp, Option<Inputs>), NotTaken> {
        let began = Instant::now();
        let setup = &self.follow.setup;
        if let Some(probe) = &self.probe {
            probe.check_size(file, image.size).map_err(dropped)?;
        }
        let pose = match &mut self.ball {
            None => None,
            Some(ball) => {
                let pose = ball.locate(frame, file, &image, &mut self.notes);
                Some(pose.map_err(dropped)?)
            }
        };
        let located = began.elapsed();
        let plate = self.plate_of(frame)?;
        if self.probe.is_none() {
            let files = self.watch.files().clone();
            let first = FirstImage {
                file,
                image: &image,
                pose,
            };
            let probe = Probe::live(files, &setup.shot, &first, &mut self.notes)?;
            self.probe = Some(probe);
        }
        self.match_colours(frame, file, plate.as_ref())?;
        let Some(probe) = &self.probe else {
            return Err(NotTaken::Dropped("there is no light yet".to_owned()));
        };
        let mut inputs = probe.digest_at(&image.hash, pose);
        if let Some(plate) = &plate {
            inputs = digest::join([&inputs, &plate.hash]);
        }
        let is_chain = setup.shot.render.continues();
        if is_chain {
            self.chain = digest::join([&self.chain, &inputs]);
            inputs = self.chain;
        }
        let hash = digest::of_frame(&setup.digest, &inputs, frame);
        let stamp = Stamp { hash, frame };
        // Of frames that continue from one another none is left out.
        if !is_chain && Frames::of(setup).are_there(&stamp) {
            return Ok((stamp, None));
        }
        let began = Instant::now();
        let map = probe.light_of(image, file, pose, &mut self.notes);
        let light = setup.tables(map.map_err(dropped)?, Some(file))?;
        tracing::info!(
            "light of frame {frame}: ball found in {located:.2?}, map and tables in {:.2?}",
            began.elapsed()
        );
        let plate = plate.map(|plate| plate.plate);
        Ok((stamp, Some(Inputs { light, plate })))
    }

    /// The backplate of a frame, if the shot has any.
    fn plate_of(&mut self, frame: i32) -> std::result::Result<Option<PlateOfFrame>, NotTaken> {
        let Some(plates) = &mut self.plates else {
            return Ok(None);
        };
        let first = self.watch.lowest().unwrap_or(frame);
        match plates.of_frame(frame, first, &self.follow.setup, &mut self.notes)? {
            None => Err(NotTaken::Dropped(
                "there has been no backplate yet".to_owned(),
            )),
            plate => Ok(plate),
        }
    }

    /// Fits the colours, on the first frame that is taken.
    fn match_colours(
        &mut self,
        frame: i32,
        file: &Path,
        plate: Option<&PlateOfFrame>,
    ) -> Result<()> {
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
        let plate = plate.map(|plate| plate.file.as_path());
        let colour = colour::correction(&setup.shot, &setup.source, file, plate, &mut self.notes)?;
        probe.set_colour(colour);
        self.has_colour = true;
        Ok(())
    }
}
