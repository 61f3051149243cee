//! Host file: the pipeline. While a frame renders, the light of the next one is read, and the one before is written.

use crate::cli::Device;
use crate::device;
use crate::error::{Error, Kind, Result};
use crate::job::Job;
use crate::notes::{Note, Notes};
use crate::output::aov;
use crate::output::video::{self, Encoder, Video};
use crate::output::{Stamp, atomic, exr, png, rgb_over_black};
use crate::report::{FrameStatus, Reporter, count};
use crate::shot::digest;
use glam::UVec2;
use glimt_render_gpu::host::env::PreparedEnv;
use glimt_render_gpu::host::plate::Plate;
use glimt_render_gpu::host::render::{FrameImage, Renderer};
use glimt_render_gpu::host::scene_build::SceneBuffers;
use glimt_render_gpu::kernels::film::tonemap;
use glimt_render_gpu::sequence::Prefetch;
use serde_json::json;
use sha2::{Digest, Sha256};
use std::path::PathBuf;
use std::sync::Arc;
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

/// What a run is asked to write.
struct Plan<'a> {
    job: &'a Job,
    /// Identity of each frame.
    stamps: Vec<Stamp>,
    /// Whether each frame is there already.
    current: Vec<bool>,
    /// The video, where one is to be made.
    video: Option<VideoPlan>,
}

/// A video that is to be made.
struct VideoPlan {
    file: PathBuf,
    /// Its identity.
    hash: String,
    encoder: Encoder,
}

/// Renders a job and writes its outputs. Frames that are there already, of the same identity, are skipped.
///
/// # Errors
/// The first thing that fails; all frames written before it stay, whole.
pub fn render(job: Job, device: Device, mut notes: Notes, reporter: &Reporter) -> Result<()> {
    let began = Instant::now();
    let job = Arc::new(job);
    atomic::prepare_folder(&job.out)?;
    let plan = Plan::new(&job, reporter)?;
    check_current(&plan, &mut notes, reporter)?;
    let mut stage = match plan.current.iter().all(|c| *c) {
        true => None,
        false => Some(Stage {
            scene: SceneBuffers::build(&job.scene).map_err(|e| job.refused_scene(&e))?,
            renderer: device::open(device)?,
        }),
    };
    tracing::info!("scene and device are ready after {:.2?}", began.elapsed());
    let name = match &stage {
        Some(stage) => stage.renderer.name(),
        None => "no device".to_owned(),
    };
    reporter.start(job.frames.len(), &job.out, &name, job.triangles);

    let inputs = read_inputs(&job, &plan, notes)?;
    let rendered = std::thread::scope(|scope| {
        let (finish, finished) = sync_channel(1);
        let writer = scope.spawn(|| write_frames(&plan, reporter, finished));
        let rendered = render_frames(&plan, stage.as_mut(), inputs, &finish, reporter);
        // The writer waits for more as long as there is a sender.
        drop(finish);
        let written = writer
            .join()
            .unwrap_or_else(|panic| std::panic::resume_unwind(panic));
        rendered.and_then(|count| written.map(|()| count))
    })?;

    let seconds = began.elapsed().as_secs_f64();
    let skipped = job.frames.len() - rendered;
    let video = plan.video.as_ref().map(|video| &video.file);
    let summary = json!({
        "rendered": rendered, "skipped": skipped, "seconds": seconds, "out": job.out, "video": video,
    });
    let also = video.map_or(String::new(), |v| format!(" and {}", v.display()));
    let text = format!(
        "{} rendered, {skipped} there already, in {seconds:.1} s: {}{also}",
        count(rendered, "frame"),
        job.out.display()
    );
    reporter.finish(summary, &text);
    Ok(())
}

/// What renders, and what is rendered.
struct Stage {
    renderer: Box<dyn Renderer>,
    scene: SceneBuffers,
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
        let mut channels: Vec<String> = output
            .aovs
            .iter()
            .map(|a| aov::first_channel(aov::name(*a)))
            .collect();
        channels.extend(keeps_display(job).then(|| aov::first_channel(aov::DISPLAY)));
        let is_current = |stamp: &Stamp| {
            let hash = Some(&stamp.hash);
            let exr_there = exr::read_hash(&frame_file(job, stamp.frame, "exr"), &channels);
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
        let size = UVec2::from(job.shot.image.size);
        let encoder = video::prepare(&file, size, output.codec)?;
        plan.video = Some(VideoPlan {
            file,
            hash,
            encoder,
        });
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

/// Whether what is displayed goes into the EXR: a video may have to be made of frames that are there, and what the plate and
/// the tonemapped objects gave cannot be had from their sum.
fn keeps_display(job: &Job) -> bool {
    let output = &job.shot.output;
    job.has_plate() && output.exr && !output.png && !output.video.is_empty()
}

/// With `--strict`, light or footage with defects is refused, also that of frames that were rendered without it.
fn check_current(plan: &Plan<'_>, notes: &mut Notes, reporter: &Reporter) -> Result<()> {
    if !notes.strict {
        return Ok(());
    }
    let pairs = plan.stamps.iter().zip(&plan.current);
    let current = pairs.filter(|(_, current)| **current).map(|(s, _)| s.frame);
    // A still is one image for all frames.
    let most = match plan.job.is_still() && plan.job.is_still_plate() {
        true => 1,
        false => usize::MAX,
    };
    for frame in current.take(most) {
        let checked = plan.job.check_light(frame, notes);
        let checked = checked.and_then(|()| plan.job.plate(frame, notes).map(drop));
        reporter.notes(notes.take());
        checked?;
    }
    Ok(())
}

/// What a frame is rendered from.
struct Inputs {
    light: Arc<PreparedEnv>,
    plate: Option<Arc<Plate>>,
}

/// The inputs of a frame, and what there is to say about them.
type Read = (Result<Inputs>, Vec<Note>);

/// Reads light and footage of each frame that is to be rendered and builds the light's tables, one frame ahead of the
/// renderer. A still is read once.
fn read_inputs(job: &Arc<Job>, plan: &Plan<'_>, mut notes: Notes) -> Result<Prefetch<Read>> {
    let pairs = plan.stamps.iter().zip(&plan.current);
    let missing: Vec<u32> = pairs
        .filter(|(_, current)| !**current)
        .map(|(s, _)| s.frame)
        .collect();
    let job = Arc::clone(job);
    let mut last: Option<Inputs> = None;
    let mut inputs = move |frame, notes: &mut Notes| -> Result<Inputs> {
        let light = match &last {
            Some(last) if job.is_still() => Arc::clone(&last.light),
            _ => Arc::new(job.light(frame, notes)?),
        };
        let plate = match &last {
            Some(last) if job.is_still_plate() => last.plate.clone(),
            _ => job.plate(frame, notes)?.map(Arc::new),
        };
        last = Some(Inputs {
            light: Arc::clone(&light),
            plate: plate.clone(),
        });
        Ok(Inputs { light, plate })
    };
    let read = move |frame| {
        let inputs = inputs(frame, &mut notes);
        (inputs, notes.take())
    };
    Prefetch::new(missing, 1, read).map_err(|e| Error::new(Kind::Internal, e))
}

/// Renders what is not there and passes it on; says how many frames were rendered.
fn render_frames(
    plan: &Plan<'_>,
    mut stage: Option<&mut Stage>,
    mut inputs: Prefetch<Read>,
    finish: &SyncSender<Finished>,
    reporter: &Reporter,
) -> Result<usize> {
    let mut rendered = 0;
    for (done, (stamp, &current)) in plan.stamps.iter().zip(&plan.current).enumerate() {
        let frame = match (&mut stage, current) {
            (Some(stage), false) => {
                let Some((read, notes)) = inputs.next() else {
                    break;
                };
                reporter.notes(notes);
                let Inputs { light, plate } = read?;
                let began = Instant::now();
                let settings = plan.job.settings(stamp.frame);
                let part = |fraction| reporter.part(done, fraction);
                let image = stage
                    .renderer
                    .render_over(&stage.scene, &light, plate.as_deref(), &settings, &part)
                    .map_err(device::failure)?;
                rendered += 1;
                Finished::Rendered(stamp.clone(), image, began.elapsed().as_secs_f64())
            }
            _ => Finished::Skipped(stamp.frame),
        };
        // A writer that has failed takes no more; its error is told when it is joined.
        if finish.send(frame).is_err() {
            return Ok(rendered);
        }
    }
    // The same holds here.
    let _ = finish.send(Finished::End);
    Ok(rendered)
}

/// Writes frames as they come; the video gets its name at the end alone.
fn write_frames(plan: &Plan<'_>, reporter: &Reporter, finished: Receiver<Finished>) -> Result<()> {
    let job = plan.job;
    let output = &job.shot.output;
    let mut video = match &plan.video {
        Some(VideoPlan {
            file,
            hash,
            encoder,
        }) => {
            let size = UVec2::from(job.shot.image.size);
            let fps = job.shot.probe.fps;
            Some(Video::create(file, size, fps, *encoder, hash)?)
        }
        None => None,
    };
    for (done, frame) in (1..).zip(finished) {
        let (number, status) = match frame {
            Finished::Rendered(stamp, image, seconds) => {
                if output.exr {
                    let file = frame_file(job, stamp.frame, "exr");
                    let layers = layers_of(job, &image, stamp.frame);
                    exr::write(&file, image.size, &image.linear, layers, &stamp)?;
                }
                if output.png {
                    png::write(&frame_file(job, stamp.frame, "png"), &image, &stamp)?;
                }
                if let Some(video) = &mut video {
                    video.push(&rgb_over_black(&image.display))?;
                }
                (stamp.frame, FrameStatus::Rendered(seconds))
            }
            Finished::Skipped(number) => {
                if let Some(video) = &mut video {
                    video.push(&rgb_over_black(&fetch_display(job, number)?))?;
                }
                (number, FrameStatus::Skipped)
            }
            Finished::End => return video.map_or(Ok(()), Video::finish),
        };
        reporter.frame(number, status, done, job.frames.len());
    }
    Ok(())
}

/// The layers that go into a frame's EXR beside the image.
fn layers_of(job: &Job, image: &FrameImage, frame: u32) -> exr::Layers {
    let aovs = &job.shot.output.aovs;
    let mut channels = aov::channels(image, aovs, &job.settings(frame), job.has_plate());
    if keeps_display(job) {
        channels.extend(aov::display(image));
    }
    let shadow = job.shot.backplate.as_ref().map(|plate| plate.shadow);
    let formula = (!aovs.is_empty()).then(|| aov::formula(shadow.unwrap_or_default()));
    exr::Layers { channels, formula }
}

/// The display image of a frame that is there already: its PNG, or else its EXR, by its layer of that name over a plate, once
/// more exposed and tonemapped without one.
fn fetch_display(job: &Job, frame: u32) -> Result<Vec<[u8; 4]>> {
    if job.shot.output.png {
        return png::read_pixels(&frame_file(job, frame, "png"));
    }
    if keeps_display(job) {
        return exr::read_display(&frame_file(job, frame, "exr"));
    }
    let linear = exr::read_pixels(&frame_file(job, frame, "exr"))?;
    let settings = job.settings(frame).frame_params();
    let params = settings.map_err(|e| Error::new(Kind::Usage, e))?;
    let pixels = 0..linear.len() as u32;
    Ok(pixels
        .map(|i| tonemap(i, &params, &linear).to_le_bytes())
        .collect())
}
