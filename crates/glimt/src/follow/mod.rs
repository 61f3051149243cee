//! Host file: `glimt render --follow`: frames rendered as they appear, the oldest dropped when rendering is behind.
//!
//! One thread watches the folder, reads the light of the next frame, finds the ball in it, waits for its backplate and builds
//! its tables, while the frame before is rendered and the one before that is written.

mod ball;
mod plates;
mod take;
mod tally;
pub mod watch;

use crate::bake;
use crate::cli::{Device, FollowFlags, RenderFlags};
use crate::colour::primaries::Primaries;
use crate::device;
use crate::error::{Error, Result};
use crate::frame::Frames;
use crate::input::Reading;
use crate::input::frames::FrameFiles;
use crate::interrupt;
use crate::job::probe_files;
use crate::notes::Notes;
use crate::output::atomic::Folder;
use crate::output::target::Target;
use crate::output::video::{self, Encoder, Video};
use crate::output::{Stamp, rgb_over_black};
use crate::report::{FrameStatus, Reporter};
use crate::setup::{self, Setup};
use crate::shot::{Shot, check, parse, range};
use glimt_render_gpu::prepare::render::{FrameImage, Renderer};
use glimt_render_gpu::prepare::scene_build::SceneBuffers;
use plates::Plates;
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, SyncSender, sync_channel};
use std::time::{Duration, Instant, SystemTime};
use take::{Taken, Taker};
use tally::Tally;
use watch::Watcher;

/// What is followed, and how.
pub struct Follow<'a> {
    setup: Setup,
    /// The last frame that is wanted, if a range was asked for.
    last: Option<i32>,
    /// How long nothing may happen.
    wait: Duration,
    /// How long a frame may wait while the one before it is rendered.
    max_lag: Duration,
    device: Device,
    /// Whether other runs may write to the same folder.
    share: bool,
    began: Instant,
    reporter: &'a Reporter,
}

/// A frame on its way to the disk.
struct Finished {
    stamp: Stamp,
    arrived: SystemTime,
    /// What was rendered, with these primaries, in this many seconds; nothing where its files are there.
    image: Option<(FrameImage, Primaries, f64)>,
}

/// Renders the frames of a shot as they appear, until none has come for `live.wait` or the last one asked for is done.
///
/// # Errors
/// The shot is wrong, no frame could be rendered, or an output cannot be written. All frames written before stay, whole.
pub fn render(
    file: &Path,
    flags: &RenderFlags,
    live: &FollowFlags,
    reporter: &Reporter,
) -> Result<()> {
    let began = Instant::now();
    let wait = live.wait;
    let mut notes = Notes::new(flags.strict);
    let (mut shot, source) = parse::read(file, &setup::overrides(flags))?;
    check::check(&shot, &source)?;
    let files = probe_files(&shot, &source)?;
    if files.is_still() {
        return Err(source
            .error(
                "probe.frames",
                "it is one file, which leaves nothing to follow",
            )
            .fix("name a sequence, as light.####.exr, or leave out --follow"));
    }
    let range = match (&flags.frames, shot.render.frames.as_str()) {
        (Some(text), _) => Some(ends_of(text).map_err(|e| e.at("--frames"))?),
        (None, "") => None,
        (None, text) => Some(ends_of(text).map_err(|e| e.at("render.frames"))?),
    };
    // From here on frames count as new.
    let light = files.clone();
    let mut watch = Watcher::new(files, range.map(|[first, _]| first));
    watch.look();
    let mut plates = Plates::of(&shot, &source, wait / 2)?;
    if let Some(plates) = plates.as_mut().filter(|_| !source.gives("image.size")) {
        let header = plates.header(&Reading::of_plate(&shot), wait)?;
        shot.image.size = header.size.to_array();
        if !source.gives("image.pixel_aspect") {
            shot.image.pixel_aspect = header.pixel_aspect;
        }
        check::check(&shot, &source)?;
    }
    let first = first_frame(&shot, &watch)?;
    reporter.busy("reading the shot's meshes");
    let setup = Setup::load(shot, source, first, flags, &mut notes);
    reporter.notes(notes.take());
    let mut setup = setup?;
    setup.guard.reads_sequence("the shot's light", &light);
    if let Some(plates) = &plates {
        setup
            .guard
            .reads_sequence("the shot's backplate", plates.files());
    }
    bake::expect(&mut setup)?;
    // The frames that will come are not known, but their names are, and what is there of them.
    let outputs = Frames::of(&setup);
    outputs.may_write(first)?;
    for frame in outputs.listed() {
        outputs.may_write(frame)?;
    }
    let follow = Follow {
        setup,
        last: range.map(|[_, last]| last),
        wait,
        max_lag: live.max_lag,
        device: flags.device,
        share: flags.write.share,
        began,
        reporter,
    };
    follow.setup.check_settings(first)?;
    // Between the keys of the camera any frame may come.
    let keys = &follow.setup.shot.camera.keys;
    if let [start, .., end] = keys.as_slice() {
        for frame in start.frame..=end.frame {
            follow.setup.camera(frame)?;
        }
    }
    follow.run(watch, plates, notes)
}

/// The first and the last of the frames that are followed.
fn ends_of(text: &str) -> Result<[i32; 2]> {
    let frames = range::parse(text)?;
    match range::is_whole(&frames) {
        true => Ok([frames[0], frames[frames.len() - 1]]),
        false => Err(Error::usage(format!(
            "`{text}` leaves out frames, and --follow takes them as they come"
        ))
        .fix("name the first and the last, as 1-96")),
    }
}

/// The frame from which motion is counted: the shot's first, or the lowest that is there; 1 where none is yet.
fn first_frame(shot: &Shot, watch: &Watcher) -> Result<i32> {
    if !shot.render.frames.is_empty() {
        return Ok(range::parse(&shot.render.frames)?[0]);
    }
    let listed = watch.files().listed().unwrap_or_default();
    Ok(listed.first().copied().unwrap_or(1))
}

impl Follow<'_> {
    fn run(&self, watch: Watcher, plates: Option<Plates>, notes: Notes) -> Result<()> {
        let setup = &self.setup;
        let output = &setup.shot.output;
        let film = match output.video.as_str() {
            "" => None,
            name => {
                let file = setup.guard.target(&setup.out.join(name))?;
                let encoder = video::prepare(&file, setup.size(), output.codec)?;
                Some(Film { file, encoder })
            }
        };
        let _folder = Folder::claim(&setup.out, self.share)?;
        self.reporter.busy("building the tree of the triangles");
        let mut scene = setup.build_scene()?;
        bake::set_transfer(setup, &setup.shot, &mut scene)?;
        let mut renderers = device::open(self.device)?;
        renderers.require_memory(&setup.shot)?;
        let files = watch.files().clone();
        self.reporter.start_following(
            &files.folder().join(files.pattern()),
            &setup.out,
            &renderers.name(),
            setup.triangles,
        );
        let renderer = renderers.of(&setup.shot)?;
        let tally = Tally::new(self.reporter);
        let stop = AtomicBool::new(false);
        let stamps = std::thread::scope(|scope| {
            // A frame is handed over when the renderer asks for it: whoever waits longer is newer.
            let (hand_over, taken) = sync_channel(0);
            let (finish, finished) = sync_channel(1);
            let mut taker = Taker::new(self, &tally, watch, plates, notes);
            let (stop, film, tally) = (&stop, film.as_ref(), &tally);
            let taking = scope.spawn(move || take_frames(&mut taker, stop, &hand_over));
            let writing = scope.spawn(move || self.write_frames(film, tally, finished));
            let rendered = self.render_frames(renderer, &mut scene, &taken, &finish);
            stop.store(true, Ordering::Relaxed);
            drop((taken, finish));
            let taken = taking
                .join()
                .unwrap_or_else(|p| std::panic::resume_unwind(p));
            let written = writing
                .join()
                .unwrap_or_else(|p| std::panic::resume_unwind(p));
            rendered
                .and(written)
                .and_then(|stamps| taken.map(|()| stamps))
        })?;
        let signal = interrupt::requested();
        if tally.done() == 0 {
            return Err(match signal {
                Some(kind) => interrupt::ended(kind, "no frame had come"),
                None => self.nothing(&files, &tally),
            });
        }
        let video = match &film {
            Some(film) if self.make_video(film, &stamps)? => Some(film.file.path()),
            _ => None,
        };
        let (summary, text) = tally.summary(self, video);
        self.reporter.finish(summary, &text);
        match signal {
            Some(kind) => Err(interrupt::ended(kind, "the frames that came are there")),
            None => Ok(()),
        }
    }

    /// Renders what is taken and passes it on.
    fn render_frames(
        &self,
        renderer: &mut dyn Renderer,
        scene: &mut SceneBuffers,
        taken: &Receiver<Taken>,
        finish: &SyncSender<Finished>,
    ) -> Result<()> {
        for Taken {
            stamp,
            arrived,
            inputs,
        } in taken
        {
            let began = Instant::now();
            let image = match inputs {
                None => None,
                Some(inputs) => {
                    let setup = &self.setup;
                    let pose = setup.pose(stamp.frame)?;
                    let refused = |e| setup.refused_scene(stamp.frame, &e);
                    scene
                        .pose_shaped(&pose.transforms, &pose.shapes)
                        .map_err(refused)?;
                    let settings = setup.settings(stamp.frame, pose.camera);
                    let plate = inputs.plate.as_deref();
                    let image = renderer
                        .render_over(scene, &inputs.light, plate, &settings, &|_| ())
                        .map_err(device::failure)?;
                    let primaries = setup.primaries_over(plate);
                    Some((image, primaries, began.elapsed().as_secs_f64()))
                }
            };
            let finished = Finished {
                stamp,
                arrived,
                image,
            };
            // A writer that has failed takes no more; its error is reported when it is joined.
            if finish.send(finished).is_err() {
                break;
            }
        }
        Ok(())
    }

    /// Writes frames as they come, and a video at once where nothing else is written. Returns which there are now.
    fn write_frames(
        &self,
        film: Option<&Film>,
        tally: &Tally<'_>,
        finished: Receiver<Finished>,
    ) -> Result<Vec<Stamp>> {
        let files = Frames::of(&self.setup);
        let mut video = None;
        let mut stamps = Vec::new();
        for Finished {
            stamp,
            arrived,
            image,
        } in finished
        {
            let mut status = FrameStatus::Skipped;
            if let Some((image, primaries, seconds)) = image {
                files.write(&image, primaries, &stamp)?;
                if let Some(film) = film.filter(|_| !self.has_files()) {
                    let video = match &mut video {
                        Some(video) => video,
                        none => none.insert(film.begin(self, "live")?),
                    };
                    video.push(&rgb_over_black(&image.display))?;
                }
                status = FrameStatus::Rendered(seconds);
            }
            tally.frame(stamp.frame, status, arrived);
            stamps.push(stamp);
        }
        interrupt::finishing();
        match video {
            Some(video) if stamps.len() > 1 => video.finish()?,
            _ => {}
        }
        Ok(stamps)
    }

    /// Whether frames are written, not a video alone.
    fn has_files(&self) -> bool {
        let output = &self.setup.shot.output;
        output.exr || output.png
    }

    /// Makes the video of the frames that are there; says whether there is one.
    fn make_video(&self, film: &Film, stamps: &[Stamp]) -> Result<bool> {
        if stamps.len() < 2 || !self.has_files() {
            return Ok(stamps.len() > 1);
        }
        let files = Frames::of(&self.setup);
        let hash = files.video_identity(stamps);
        if video::is_current(film.file.path(), &hash) {
            return Ok(true);
        }
        let mut video = film.begin(self, &hash)?;
        for (done, stamp) in (1..).zip(stamps) {
            video.push(&rgb_over_black(&files.display(stamp.frame)?))?;
            self.reporter.stage("video", done, stamps.len());
        }
        video.finish()?;
        Ok(true)
    }

    /// The error of a run without a frame.
    fn nothing(&self, files: &FrameFiles, tally: &Tally<'_>) -> Error {
        let seconds = self.wait.as_secs_f64();
        if let Some((count, reason)) = tally.lost() {
            let what =
                format!("none of the frames that came ({count}) could be rendered: {reason}");
            return Error::input(files.folder(), what).fix("see what was said of each of them");
        }
        let pattern = files.pattern();
        let error = match files.folder().is_dir() {
            true => Error::input(
                files.folder(),
                format!("no frame named {pattern} came in {seconds} s"),
            ),
            false => Error::input(
                files.folder(),
                format!("there is no such folder, and none came in {seconds} s"),
            ),
        };
        error.fix(
            "check probe.frames and --frames, start the capture first, or wait longer with --wait",
        )
    }
}

/// Hands frames over until there are no more, or no one takes them.
fn take_frames(
    taker: &mut Taker<'_>,
    stop: &AtomicBool,
    hand_over: &SyncSender<Taken>,
) -> Result<()> {
    while let Some(taken) = taker.next(stop)? {
        if hand_over.send(taken).is_err() {
            break;
        }
    }
    Ok(())
}

/// A video that is to be made.
struct Film {
    file: Target,
    encoder: Encoder,
}

impl Film {
    fn begin(&self, follow: &Follow<'_>, hash: &str) -> Result<Video> {
        let fps = follow.setup.shot.probe.fps;
        Video::create(&self.file, follow.setup.size(), fps, self.encoder, hash)
    }
}

/// Reads a file that may not be whole: the inner error is one that may pass; the outer one is a defect that `--strict` refuses.
fn read_live<T>(notes: &mut Notes, read: impl Fn(&mut Notes) -> Result<T>) -> Result<Result<T>> {
    match read(notes) {
        Err(error) if notes.strict && read(&mut Notes::new(false)).is_ok() => Err(error),
        read => Ok(read),
    }
}
