//! Host file: the pipeline. While a frame renders, the light of the next one is read, and the one before is written.

use crate::device::{self, Renderer};
use crate::error::Result;
use crate::job::Job;
use crate::notes::Notes;
use crate::output::video::{self, Video};
use crate::output::{Stamp, atomic, exr, png};
use crate::report::{FrameStatus, Reporter};
use crate::shot::digest;
use glam::UVec2;
use glimt_render_gpu::host::env::EnvMap;
use glimt_render_gpu::host::render::FrameImage;
use serde_json::json;
use sha2::{Digest, Sha256};
use std::path::PathBuf;
use std::sync::mpsc::{Receiver, SyncSender, sync_channel};
use std::time::Instant;

/// A frame on its way to the disk.
enum Finished {
    /// It was there already.
    Skipped(u32),
    /// It was rendered, in this many seconds.
    Rendered(Stamp, FrameImage, f64),
    /// There is nothing more to come.
    End,
}

/// A frame that is to be rendered, or is there already.
enum Next {
    Skip(u32),
    Render(Stamp, EnvMap),
}

/// What a run is asked to write.
struct Plan<'a> {
    job: &'a Job,
    /// Identity of each frame.
    stamps: Vec<Stamp>,
    /// Whether each frame is there already.
    current: Vec<bool>,
    /// The video and its identity, where one is to be made.
    video: Option<(PathBuf, String)>,
}

/// Renders a job and writes its outputs. Frames that are there already, of the same identity, are skipped.
///
/// # Errors
/// The first thing that fails; all frames written before it stay, whole.
pub fn render(
    job: &Job,
    device: crate::cli::Device,
    strict: bool,
    reporter: &Reporter,
) -> Result<()> {
    let began = Instant::now();
    atomic::prepare_folder(&job.out)?;
    let plan = Plan::new(job, reporter)?;
    let all_current = plan.current.iter().all(|c| *c);
    let renderer = match all_current {
        true => None,
        false => Some(device::open(device, &job.scene)?),
    };
    let name = renderer.as_ref().map_or("no device", |r| r.name());
    reporter.start(job.frames.len(), &job.out, name, job.triangles);

    let rendered = std::thread::scope(|scope| {
        let (load, loaded) = sync_channel(1);
        let (finish, finished) = sync_channel(1);
        scope.spawn(|| read_lights(&plan, strict, reporter, load));
        let writer = scope.spawn(|| write_frames(&plan, reporter, finished));
        let rendered = render_frames(job, renderer, &loaded, &finish);
        // Both ends must go, or a thread that still sends or waits would never end.
        drop((loaded, finish));
        let written = writer
            .join()
            .unwrap_or_else(|panic| std::panic::resume_unwind(panic));
        rendered.and_then(|count| written.map(|()| count))
    })?;

    let seconds = began.elapsed().as_secs_f64();
    let skipped = job.frames.len() - rendered;
    let video = plan.video.as_ref().map(|(file, _)| file);
    let summary = json!({
        "rendered": rendered, "skipped": skipped, "seconds": seconds, "out": job.out, "video": video,
    });
    let also = video.map_or(String::new(), |v| format!(" and {}", v.display()));
    let text = format!(
        "{rendered} frames rendered, {skipped} there already, in {seconds:.1} s: {}{also}",
        job.out.display()
    );
    reporter.finish(summary, &text);
    Ok(())
}

impl<'a> Plan<'a> {
    fn new(job: &'a Job, reporter: &Reporter) -> Result<Self> {
        let stamps: Vec<Stamp> = job
            .identities()?
            .into_iter()
            .zip(&job.frames)
            .map(|(hash, &frame)| Stamp { hash, frame })
            .collect();
        let output = &job.shot.output;
        let is_current = |stamp: &Stamp| {
            let hash = Some(&stamp.hash);
            let exr_there = exr::read_hash(&frame_file(job, stamp.frame, "exr"));
            let png_there = png::read_hash(&frame_file(job, stamp.frame, "png"));
            (output.exr || output.png)
                && (!output.exr || exr_there.as_ref() == hash)
                && (!output.png || png_there.as_ref() == hash)
        };
        let current: Vec<bool> = stamps.iter().map(is_current).collect();

        let mut plan = Self {
            job,
            stamps,
            current,
            video: None,
        };
        if output.video.is_empty() || job.frames.len() < 2 {
            return Ok(plan);
        }
        let file = job.out.join(&output.video);
        if !job.whole {
            reporter.remark("the video is made when all frames of the shot are asked for");
            return Ok(plan);
        }
        let hash = plan.video_identity();
        let alone = !output.exr && !output.png;
        let frames_there = alone || plan.current.iter().all(|c| *c);
        if frames_there && video::is_current(&file, &hash) {
            plan.current.fill(true);
            return Ok(plan);
        }
        plan.video = Some((file, hash));
        // Frames that are skipped are fetched from their PNG.
        if !output.png {
            plan.current.fill(false);
        }
        Ok(plan)
    }

    fn video_identity(&self) -> String {
        let mut hasher = Sha256::new();
        for stamp in &self.stamps {
            hasher.update(stamp.hash.as_bytes());
        }
        hasher.update(self.job.shot.probe.fps.to_le_bytes());
        hasher.update(format!("{:?}", self.job.shot.output.codec));
        digest::hex(&hasher.finalize().into())
    }
}

fn frame_file(job: &Job, frame: u32, extension: &str) -> PathBuf {
    job.out.join(format!("frame.{frame:04}.{extension}"))
}

/// Reads the light of each frame that is to be rendered, one ahead of the renderer.
fn read_lights(plan: &Plan<'_>, strict: bool, reporter: &Reporter, load: SyncSender<Result<Next>>) {
    for (stamp, &current) in plan.stamps.iter().zip(&plan.current) {
        let next = if current {
            Ok(Next::Skip(stamp.frame))
        } else {
            let mut notes = Notes::new(strict);
            let light = plan.job.light(stamp.frame, &mut notes);
            reporter.notes(notes.take());
            light.map(|light| Next::Render(stamp.clone(), light))
        };
        let failed = next.is_err();
        if load.send(next).is_err() || failed {
            return;
        }
    }
}

/// Renders what comes and passes it on; says how many frames were rendered.
fn render_frames(
    job: &Job,
    mut renderer: Option<Box<dyn Renderer>>,
    loaded: &Receiver<Result<Next>>,
    finish: &SyncSender<Finished>,
) -> Result<usize> {
    let mut rendered = 0;
    for next in loaded {
        let done = match (next?, &mut renderer) {
            (Next::Render(stamp, light), Some(renderer)) => {
                let began = Instant::now();
                let image = renderer.render(&light, &job.settings(stamp.frame))?;
                rendered += 1;
                Finished::Rendered(stamp, image, began.elapsed().as_secs_f64())
            }
            (Next::Skip(frame), _) => Finished::Skipped(frame),
            (Next::Render(..), None) => {
                unreachable!("a device is open where a frame is to be rendered")
            }
        };
        // The writer has failed; its error is told when it is joined.
        if finish.send(done).is_err() {
            return Ok(rendered);
        }
    }
    let _ = finish.send(Finished::End);
    Ok(rendered)
}

/// Writes frames as they come; the video gets its name at the end alone.
fn write_frames(plan: &Plan<'_>, reporter: &Reporter, finished: Receiver<Finished>) -> Result<()> {
    let job = plan.job;
    let output = &job.shot.output;
    let mut video = match &plan.video {
        Some((file, hash)) => {
            let size = UVec2::from(job.shot.image.size);
            Some(Video::create(
                file,
                size,
                job.shot.probe.fps,
                output.codec,
                hash,
            )?)
        }
        None => None,
    };
    for (done, frame) in (1..).zip(finished) {
        let (number, status) = match frame {
            Finished::Rendered(stamp, image, seconds) => {
                if output.exr {
                    let file = frame_file(job, stamp.frame, "exr");
                    exr::write(&file, image.size, &image.linear, &stamp)?;
                }
                if output.png {
                    png::write(&frame_file(job, stamp.frame, "png"), &image, &stamp)?;
                }
                if let Some(video) = &mut video {
                    let rgb: Vec<u8> = image
                        .display
                        .iter()
                        .flat_map(|p| [p[0], p[1], p[2]])
                        .collect();
                    video.push(&rgb)?;
                }
                (stamp.frame, FrameStatus::Rendered(seconds))
            }
            Finished::Skipped(number) => {
                if let Some(video) = &mut video {
                    let (_, rgb) = png::read_rgb(&frame_file(job, number, "png"))?;
                    video.push(&rgb)?;
                }
                (number, FrameStatus::Skipped)
            }
            Finished::End => return video.map_or(Ok(()), Video::finish),
        };
        reporter.frame(number, status, done, job.frames.len());
    }
    Ok(())
}
