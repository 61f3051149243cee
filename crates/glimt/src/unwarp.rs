//! Host file: `glimt unwarp`: film of a mirror ball to a sequence of lat-long maps.

use crate::capture::{Capture, Poses, locate};
use crate::cli::UnwarpFlags;
use crate::device::{self, Processor};
use crate::error::{Error, Kind, Result};
use crate::input::Reading;
use crate::input::frames::{FrameFiles, check_size};
use crate::input::light_image::{LightImage, read_photo, read_size};
use crate::interrupt;
use crate::notes::Notes;
use crate::output::atomic::Folder;
use crate::output::target::{Guard, Target};
use crate::output::{SOFTWARE, Stamp, exr, png, write_text};
use crate::printable::path_in_line;
use crate::report::{FrameStatus, Reporter, count, shown};
use crate::shot::digest::{self, Hash};
use crate::shot::{Ball, Shot, check, parse, range};
use crate::synth::{MASK_HIDDEN, MASK_RIG, MASK_RIM, MASK_SEEN};
use glam::{UVec2, Vec4};
use glimt_probe::gather::ColourMatrix;
use glimt_probe::unwarp::Visibility;
use glimt_render_gpu::gpu::GpuUnwarp;
use glimt_render_gpu::prepare::unwarp::{Look, UnwarpMap};
use serde_json::json;
use std::path::Path;
use std::sync::Arc;
use std::time::Instant;

/// Unwarps a capture: `latlong.####.exr`, `mask.####.png` where it changes, and `track.json`, into the folder of the flags.
///
/// # Errors
/// The first thing that fails; all files written before it stay, whole.
pub fn run(frames: &Path, flags: &UnwarpFlags, reporter: &Reporter) -> Result<()> {
    let began = Instant::now();
    let ball = keys(flags)?;
    let mut notes = Notes::new(flags.strict);
    let files = FrameFiles::new(Path::new(""), &frames.to_string_lossy())?;
    let numbers = frames_of(&files, flags)?;
    files.note_gaps(&numbers, "no map is made for what is not there", &mut notes);
    let mut guard = Guard::new(flags.write.overwrite);
    guard.reads_sequence("the film", &files);
    for &frame in &numbers {
        guard.target(&flags.out.join(name("latlong", frame, "exr")))?;
        guard.target(&flags.out.join(name("mask", frame, "png")))?;
    }
    let track_file = guard.target(&flags.out.join("track.json"))?;
    let _folder = Folder::claim(&flags.out, flags.write.share)?;
    let processor = device::open_processor(flags.device)?;
    reporter.start_filming(numbers.len(), &flags.out, &processor.name());

    reporter.notes(notes.take());
    let poses = match Poses::given(&ball) {
        Some(given) => {
            write_track(&track_file, given_track(&numbers, &given))?;
            given
        }
        None => {
            let found = |done, all| reporter.stage("looking for the ball", done, all);
            // In all that there are: what is smoothed over a shot must not depend on which part of it is asked for.
            let all = match files.is_still() {
                true => numbers.clone(),
                false => files.existing()?,
            };
            let tracked = locate::track(
                &files,
                &all,
                ball.steady,
                &Reading::default(),
                &mut notes,
                &found,
            );
            reporter.notes(notes.take());
            let tracked = tracked?;
            let poses = locate::of_track(&tracked);
            write_track(&track_file, track(&tracked, &poses))?;
            poses
        }
    };
    let mut maps = Maps {
        flags,
        capture: Capture::new(&ball, poses),
        ball,
        unwarper: Unwarper {
            processor,
            ready: None,
        },
        files: &files,
        guard,
        last: None,
    };
    let mut written = 0;
    for (done, &frame) in (1..).zip(&numbers) {
        interrupt::check(|| format!("{} of {} maps are there", done - 1, numbers.len()))?;
        let status = maps.write(frame, &mut notes);
        reporter.notes(notes.take());
        let status = status?;
        written += usize::from(status != FrameStatus::Skipped);
        reporter.frame(frame, status, done, numbers.len());
    }
    let size = maps.capture.size();
    let skipped = numbers.len() - written;
    let seconds = began.elapsed().as_secs_f64();
    let summary = json!({
        "unwarped": written, "skipped": skipped, "seconds": seconds, "out": shown(&flags.out), "size": size.to_array(),
    });
    let text = format!(
        "{} of {} × {} unwarped, {skipped} there already, in {seconds:.1} s: {}",
        count(written, "map"),
        size.x,
        size.y,
        path_in_line(&flags.out)
    );
    reporter.finish(summary, &text);
    Ok(())
}

/// The frames that are asked for, or all that there are, checked to be of one size.
fn frames_of(files: &FrameFiles, flags: &UnwarpFlags) -> Result<Vec<i32>> {
    let numbers = match &flags.frames {
        Some(text) => {
            let asked = range::parse(text).map_err(|e| e.at("--frames"))?;
            files.require(&asked)?;
            asked
        }
        None if files.is_still() => {
            files.require(&[1])?;
            vec![1]
        }
        None => files.existing().map_err(|e| {
            e.fix("check the path: each # stands for a digit of the frame's number")
        })?,
    };
    let first = files.path(numbers[0]);
    let size = read_size(&first, &Reading::default())?;
    for &frame in &numbers[1..] {
        let file = files.path(frame);
        check_size(&file, read_size(&file, &Reading::default())?, size, &first)?;
    }
    Ok(numbers)
}

fn write_track(file: &Target, mut track: serde_json::Value) -> Result<()> {
    track["software"] = SOFTWARE.into();
    write_text(file, &format!("{track:#}"))
}

/// Makes and writes the maps, frame after frame.
struct Maps<'a> {
    flags: &'a UnwarpFlags,
    ball: Ball,
    capture: Capture,
    unwarper: Unwarper,
    files: &'a FrameFiles,
    /// What may be written: nothing that is read.
    guard: Guard,
    /// The frame before.
    last: Option<LastFrame>,
}

/// What is known of the frame before: one mask serves until it changes.
struct LastFrame {
    number: i32,
    /// Size of its photograph.
    photo: UVec2,
    /// Its mask, if that was made.
    mask: Option<Vec<u8>>,
}

impl Maps<'_> {
    /// Writes the mask and then the map of a frame, unless they are there already.
    fn write(&mut self, frame: i32, notes: &mut Notes) -> Result<FrameStatus> {
        let file = &self.files.path(frame);
        let there = stamp(&digest::of_file(file)?, frame, &self.ball, &self.capture)?;
        let map_file = self.flags.out.join(name("latlong", frame, "exr"));
        let began = Instant::now();
        // The first frame has a mask in any case.
        let mask_is_there =
            || self.last.is_some() || self.flags.out.join(name("mask", frame, "png")).is_file();
        if exr::read_hash(&map_file, &[]).as_ref() == Some(&there.hash) && mask_is_there() {
            // Frames whose ball was looked for were read already. What is there may have been made without --strict.
            if self.flags.strict && matches!(self.capture.poses(), Poses::Fixed(_)) {
                read_photo(file, &Reading::default(), notes)?;
            }
            self.last = Some(LastFrame {
                number: frame,
                photo: read_size(file, &Reading::default())?,
                mask: None,
            });
            return Ok(FrameStatus::Skipped);
        }
        let photo = read_photo(file, &Reading::default(), notes)?;
        let stamp = stamp(&photo.hash, frame, &self.ball, &self.capture)?;
        let map = self.capture.map(frame, file, photo.size)?;
        let look = self.capture.look(&ColourMatrix::IDENTITY);
        let texels = self.unwarper.apply(&map, &photo, &look)?;
        let mask = mask_of(&map);
        // The map comes last: where it is there, the mask is as it should be.
        self.write_mask(frame, &map, &mask)?;
        let target = self.guard.target(&map_file)?;
        exr::write_rgb(&target, map.size(), &texels, &stamp, exr::Storage::Float)?;
        self.last = Some(LastFrame {
            number: frame,
            photo: photo.size,
            mask: Some(mask),
        });
        Ok(FrameStatus::Rendered(began.elapsed().as_secs_f64()))
    }

    /// Writes the mask of a frame where it differs from that of the frame before; else none is there.
    fn write_mask(&self, frame: i32, map: &UnwarpMap, mask: &[u8]) -> Result<()> {
        let target = self
            .guard
            .target(&self.flags.out.join(name("mask", frame, "png")))?;
        let before = match &self.last {
            None => None,
            Some(LastFrame {
                mask: Some(mask), ..
            }) => Some(mask.clone()),
            Some(last) => {
                let file = self.files.path(last.number);
                let map = self.capture.map(last.number, &file, last.photo)?;
                Some(mask_of(&map))
            }
        };
        if before.as_deref() != Some(mask) {
            return png::write_mask(&target, map.size(), mask);
        }
        match std::fs::remove_file(target.path()) {
            Err(e) if e.kind() != std::io::ErrorKind::NotFound => {
                Err(Error::writing(target.path(), &e))
            }
            _ => Ok(()),
        }
    }
}

/// The keys of `[probe.ball]` that the flags give.
fn keys(flags: &UnwarpFlags) -> Result<Ball> {
    let set: Vec<String> = flags
        .distance_mm
        .map(|d| format!("probe.ball.distance_mm={d:?}"))
        .into_iter()
        .chain(
            flags
                .radius_mm
                .map(|r| format!("probe.ball.radius_mm={r:?}")),
        )
        .chain(
            flags
                .size
                .map(|s| format!("probe.ball.size=[{}, {}]", s.x, s.y)),
        )
        .chain(flags.set.iter().map(|item| format!("probe.ball.{item}")))
        .collect();
    let text = "[probe]\nframes = \"given\"\nmapping = \"mirror-ball\"\n[probe.ball]\n";
    let (shot, source): (Shot, _) =
        parse::parse(Path::new("the command line"), text.to_owned(), &set)?;
    let ball = shot.probe.ball.unwrap_or_default();
    // The text above is not a file in which a line could be looked up.
    check::check_ball(&ball, &source).map_err(|e| Error {
        place: e.place.filter(|_| e.file.is_none()),
        ..e
    })?;
    Ok(ball)
}

fn name(what: &str, frame: i32, extension: &str) -> String {
    format!("{what}.{frame:04}.{extension}")
}

/// The identity of the map of a frame whose file has this hash.
fn stamp(file: &Hash, frame: i32, ball: &Ball, capture: &Capture) -> Result<Stamp> {
    let keys = serde_json::to_string(ball).map_err(|e| Error::new(Kind::Internal, e))?;
    let pose = format!(
        "glimt unwarp {} {keys} {:?}",
        digest::VERSION,
        capture.poses().of(frame)
    );
    let parts = [*file, digest::of_text(&pose)];
    Ok(Stamp {
        hash: digest::hex(&digest::join(parts.iter())),
        frame,
    })
}

/// What became of each texel, in the values that a simulated capture's own mask has.
fn mask_of(map: &UnwarpMap) -> Vec<u8> {
    let value = |seen: &Visibility| match seen {
        Visibility::Seen => MASK_SEEN,
        Visibility::Hidden => MASK_HIDDEN,
        Visibility::Rig => MASK_RIG,
        Visibility::Rim => MASK_RIM,
    };
    map.visibility().iter().map(value).collect()
}

/// What was found, for people and programs.
fn track(tracked: &glimt_ball::Tracked, poses: &Poses) -> serde_json::Value {
    let frame = |p: &glimt_ball::TrackedPose| {
        // Roll as it is removed: counter-clockwise, against the mean.
        let roll = poses.of(p.frame).map_or(0.0, |pose| pose.roll.to_degrees());
        json!({
            "frame": p.frame, "centre_px": [p.centre.x, p.centre.y], "radius_px": p.radius, "roll_deg": roll,
            "state": format!("{:?}", p.state).to_lowercase(),
        })
    };
    json!({
        "radius_px": tracked.radius,
        "radius_standard_error_px": tracked.radius_sigma,
        "lost": tracked.lost,
        "rejected": tracked.rejected,
        "notes": tracked.notes,
        "frames": tracked.poses.iter().map(frame).collect::<Vec<_>>(),
    })
}

/// The same where it was given.
fn given_track(frames: &[i32], poses: &Poses) -> serde_json::Value {
    let frame = |&frame: &i32| {
        let outline = poses.of(frame).map(|pose| pose.outline);
        json!({
            "frame": frame, "centre_px": outline.map(|o| o.centre.to_array()), "radius_px": outline.map(|o| o.radius),
            "roll_deg": 0.0, "state": "given",
        })
    };
    json!({ "frames": frames.iter().map(frame).collect::<Vec<_>>() })
}

/// What unwarps: the CPU, or a GPU with the table that it has at the moment.
struct Unwarper {
    processor: Processor,
    ready: Option<(Arc<UnwarpMap>, GpuUnwarp)>,
}

impl Unwarper {
    fn apply(
        &mut self,
        map: &Arc<UnwarpMap>,
        photo: &LightImage,
        look: &Look,
    ) -> Result<Vec<Vec4>> {
        let Processor::Gpu(context) = &self.processor else {
            return Ok(map.apply(&photo.pixels, look));
        };
        let mut run = || {
            let gpu = match self.ready.take() {
                Some((known, gpu)) if Arc::ptr_eq(&known, map) => gpu,
                _ => GpuUnwarp::new(context, map)?,
            };
            gpu.run(context, &photo.pixels, look)?;
            let texels = gpu.read(context)?;
            self.ready = Some((Arc::clone(map), gpu));
            Ok(texels)
        };
        run().map_err(|e| device::gpu_failure(&e))
    }
}
