//! Host file: the backplate of a frame while both are still being filmed: waited for a bounded time, else the one before.

use super::watch::Watcher;
use crate::error::{Error, Result};
use crate::input::Reading;
use crate::input::footage::{self, Footage, LightSpan};
use crate::input::frames::FrameFiles;
use crate::input::plate::{PlateHeader, read_plate_header};
use crate::notes::Notes;
use crate::setup::Setup;
use crate::shot::Shot;
use crate::shot::digest::Hash;
use crate::shot::parse::Source;
use glimt_render_gpu::prepare::plate::Plate;
use std::path::PathBuf;
use std::sync::Arc;
use std::thread::sleep;
use std::time::{Duration, Instant};

/// A backplate that has been read.
#[derive(Clone, Debug)]
pub(super) struct PlateOfFrame {
    number: i32,
    /// The file that it came from.
    pub(super) file: PathBuf,
    /// Hash of that file.
    pub(super) hash: Hash,
    /// Its pixels, at the image's size.
    pub(super) plate: Arc<Plate>,
}

/// Backplates as they come.
pub(super) struct Plates {
    watch: Watcher,
    /// What is known of them once there is one.
    footage: Option<Footage>,
    last: Option<PlateOfFrame>,
    /// The highest number that there was when one was waited for in vain: no other is waited for until it rises.
    in_vain: Option<Option<i32>>,
    wait: Duration,
}

impl Plates {
    /// Those of a shot, if it has any. None is waited for longer than `wait`.
    ///
    /// # Errors
    /// They cannot be named so.
    pub(super) fn of(shot: &Shot, source: &Source, wait: Duration) -> Result<Option<Self>> {
        let files = footage::files(shot, source)?;
        let plates = |files: FrameFiles| Self {
            watch: Watcher::new(files, Some(i32::MIN)),
            footage: None,
            last: None,
            in_vain: None,
            wait,
        };
        Ok(files.map(plates))
    }

    /// Their files.
    pub(super) fn files(&self) -> &FrameFiles {
        self.watch.files()
    }

    /// Looks at the folder.
    pub(super) fn look(&mut self) {
        self.watch.look();
    }

    /// The header of the first one, waiting for it at most so long.
    ///
    /// # Errors
    /// None came.
    pub(super) fn header(&mut self, reading: &Reading, most: Duration) -> Result<PlateHeader> {
        let until = Instant::now() + most;
        loop {
            self.watch.look();
            if let Some(number) = self.watch.whole_before(i32::MAX)
                && let Ok(header) = read_plate_header(&self.watch.files().path(number), reading)
            {
                return Ok(header);
            }
            if Instant::now() > until {
                let seconds = most.as_secs_f64();
                let files = self.watch.files();
                let what = format!("no backplate named {} came in {seconds} s", files.pattern());
                return Err(Error::input(files.folder(), what).fix(
                    "check backplate.frames, or give image.size and the frames are rendered when one comes",
                ));
            }
            sleep(self.watch.pause());
        }
    }

    /// The backplate of a frame, `first` being the probe's first: its own, if that comes in time; else the last before it,
    /// of which is warned; `None` if there is none.
    ///
    /// # Errors
    /// It has defects and `notes` is strict.
    pub(super) fn of_frame(
        &mut self,
        frame: i32,
        first: i32,
        setup: &Setup,
        notes: &mut Notes,
    ) -> Result<Option<PlateOfFrame>> {
        let until = Instant::now() + self.wait;
        let mut wanted = frame;
        let mut waited = true;
        loop {
            self.watch.look();
            self.open(first, setup, notes);
            if let Some(footage) = &self.footage {
                wanted = match footage.is_still() {
                    true => 1,
                    false => footage.number(frame),
                };
                if let Some(last) = self.last.as_ref().filter(|last| last.number == wanted) {
                    return Ok(Some(last.clone()));
                }
                if self.watch.is_whole(wanted)
                    && let Some(laid) = self.load(wanted, setup, notes)?
                {
                    return Ok(Some(laid));
                }
            }
            // A gap in the numbers will hardly be filled, and a camera that has stopped will not continue for this frame.
            let skipped =
                !self.watch.is_there(wanted) && self.watch.whole_before(i32::MAX) > Some(wanted);
            if skipped || self.in_vain == Some(self.watch.highest()) {
                waited = false;
                break;
            }
            if Instant::now() > until {
                self.in_vain = Some(self.watch.highest());
                break;
            }
            sleep(self.watch.pause());
        }
        let file = self.watch.files().path(wanted);
        let older = match self.last.clone() {
            Some(last) => Some(last),
            None => self.newest_before(wanted, setup, notes)?,
        };
        if let Some(older) = &older {
            let why = match (self.watch.failure(wanted), waited) {
                (Some(error), _) => format!("it cannot be read ({})", error.what),
                (None, true) => format!("it did not come in {} s", self.wait.as_secs_f64()),
                (None, false) => "it is not there".to_owned(),
            };
            notes.warn(
                &file,
                format!(
                    "{why}: frame {frame} is laid over backplate {}",
                    older.number
                ),
            );
        }
        Ok(older)
    }

    /// Learns of the footage what its first frame says, as soon as there is one.
    fn open(&mut self, first: i32, setup: &Setup, notes: &mut Notes) {
        let (None, Some(lowest)) = (&self.footage, self.watch.lowest()) else {
            return;
        };
        // It may still be written; the next look sees.
        let files = self.watch.files().clone();
        if let Ok(footage) = Footage::new(
            files,
            &setup.shot,
            LightSpan::Live(first),
            [lowest; 2],
            notes,
        ) {
            footage.note_stretch(setup.size(), notes);
            self.footage = Some(footage);
        }
    }

    fn newest_before(
        &mut self,
        number: i32,
        setup: &Setup,
        notes: &mut Notes,
    ) -> Result<Option<PlateOfFrame>> {
        while let Some(older) = self.watch.whole_before(number) {
            if let Some(laid) = self.load(older, setup, notes)? {
                return Ok(Some(laid));
            }
        }
        Ok(None)
    }

    /// Reads one; `None` where that fails, which may be because it is still being written.
    fn load(
        &mut self,
        number: i32,
        setup: &Setup,
        notes: &mut Notes,
    ) -> Result<Option<PlateOfFrame>> {
        let Some(footage) = &self.footage else {
            return Ok(None);
        };
        let file = self.watch.files().path(number);
        let read = |notes: &mut Notes| footage.load_file(&file, setup.size(), notes);
        let (plate, hash) = match super::read_live(notes, read)? {
            Ok(read) => read,
            Err(error) => {
                self.watch.failed(number, error);
                return Ok(None);
            }
        };
        let laid = PlateOfFrame {
            number,
            hash,
            file,
            plate: Arc::new(plate),
        };
        self.last = Some(laid.clone());
        self.watch.forget_before(number);
        Ok(Some(laid))
    }
}
