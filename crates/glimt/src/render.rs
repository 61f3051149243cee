//! Host file: the pipeline. While a frame renders, the light of the next one is read, and the one before is written.

use crate::bake;
use crate::checkpoint::Checkpoint;
use crate::cli::Device;
use crate::colour::primaries::Primaries;
use crate::device::{self, Renderers};
use crate::error::{Error, Kind, Result};
use crate::frame::Frames;
use crate::interrupt;
use crate::job::{Chain, Job};
use crate::notes::{Note, Notes};
use crate::output::atomic::{Folder, Pending};
use crate::output::state::{self, Saved};
use crate::output::target::Target;
use crate::output::video::{self, Encoder, Video};
use crate::output::{Stamp, rgb_over_black};
use crate::printable::path_in_line;
use crate::report::{FrameStatus, Reporter, count, shown};
use crate::shot::digest::{self, Hash};
use glimt_render_gpu::prepare::env::PreparedEnv;
use glimt_render_gpu::prepare::plate::Plate;
use glimt_render_gpu::prepare::render::FrameImage;
use glimt_render_gpu::prepare::scene_build::SceneBuffers;
use glimt_render_gpu::sequence::Prefetch;
use serde_json::json;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::mpsc::{Receiver, SyncSender, sync_channel};
use std::time::Instant;

/// A frame on its way to the disk.
enum Finished {
    /// It was there already.
    Skipped(i32),
    /// It was rendered with these primaries, in this many seconds.
    Rendered(Stamp, FrameImage, Primaries, f64),
    /// There is nothing more to come.
    End,
}

/// What a run is asked to write.
struct Plan<'a> {
    job: &'a Job,
    /// Identity of each frame.
    stamps: Vec<Stamp>,
    /// Whether each frame is there already, or need not be, as it only leads up to others.
    current: Vec<bool>,
    /// Whether each frame is computed: those that are not there, and those that they continue from.
    computed: Vec<bool>,
    /// Where the state after the last frame is to be saved, if that is not there already.
    state: Option<Target>,
    /// The video, where one is to be made.
    video: Option<VideoPlan>,
    /// Where states are saved on the way, and the one that the run continues from.
    checkpoint: Option<Checkpoint>,
    resumed: Option<Saved>,
}

/// A video that is to be made.
struct VideoPlan {
    file: Target,
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
    reporter.busy("looking which frames are there already");
    let plan = Plan::new(&job, reporter)?;
    let _folder = Folder::claim(&job.setup.out, job.share)?;
    let mut state = plan.begin_state()?;
    check_current(&plan, &mut notes, reporter)?;
    let mut ready = match plan.computed.contains(&true) {
        true => Some(SceneRenderer::open(&plan, device, reporter)?),
        false => None,
    };
    tracing::info!("scene and device are ready after {:.2?}", began.elapsed());
    let name = match &ready {
        Some(ready) => ready.renderers.name(),
        None => "no device".to_owned(),
    };
    let asked = job.count();
    reporter.start(asked, &job.setup.out, &name, job.setup.triangles);

    let inputs = read_inputs(&job, &plan, notes)?;
    let (rendered, chain) = std::thread::scope(|scope| {
        let (finish, finished) = sync_channel(1);
        let writer = scope.spawn(|| write_frames(&plan, reporter, finished));
        let rendered = render_frames(&plan, ready.as_mut(), inputs, &finish, reporter);
        // The writer waits for more as long as there is a sender.
        drop(finish);
        let written = writer
            .join()
            .unwrap_or_else(|panic| std::panic::resume_unwind(panic));
        rendered.and_then(|rendered| written.map(|()| rendered))
    })?;

    if let (Some(ready), Some(state)) = (&mut ready, &mut state) {
        ready.save(&plan, chain.hash, state)?;
    }

    if let Some(checkpoint) = &plan.checkpoint {
        checkpoint.remove();
    }
    let seconds = began.elapsed().as_secs_f64();
    let skipped = asked - rendered;
    let video = plan.video.as_ref().map(|video| video.file.path());
    let summary = json!({
        "rendered": rendered, "skipped": skipped, "seconds": seconds, "out": shown(&job.setup.out), "video": video.map(shown),
        "state": job.state_out.as_deref().map(shown),
    });
    let also = video.map_or(String::new(), |v| format!(" and {}", path_in_line(v)));
    let text = format!(
        "{} rendered, {skipped} there already, in {seconds:.1} s: {}{also}",
        count(rendered, "frame"),
        path_in_line(&job.setup.out)
    );
    reporter.finish(summary, &text);
    Ok(())
}

/// What renders, and what is rendered.
struct SceneRenderer {
    renderers: Renderers,
    scene: SceneBuffers,
}

impl SceneRenderer {
    fn open(plan: &Plan<'_>, device: Device, reporter: &Reporter) -> Result<Self> {
        let job = plan.job;
        reporter.busy("building the tree of the triangles");
        let mut opened = Self {
            scene: job.setup.build_scene()?,
            renderers: device::open(device)?,
        };
        opened.renderers.require_memory(&job.setup.shot)?;
        bake::set_transfer(&job.setup, &job.setup.shot, &mut opened.scene)?;
        if let Some(saved) = plan.resumed.as_ref().or(job.state_in.as_ref()) {
            let renderer = opened.renderers.of(&job.setup.shot)?;
            let memory = saved.memory.clone();
            renderer.set_memory(memory).map_err(device::failure)?;
        }
        Ok(opened)
    }

    /// Saves what the next frame would continue from.
    fn save(&mut self, plan: &Plan<'_>, chain: Hash, file: &mut Pending) -> Result<()> {
        match self.state(plan, chain)? {
            Some(saved) => state::write(file, &saved),
            None => Ok(()),
        }
    }

    /// What the next frame would continue from.
    fn state(&mut self, plan: &Plan<'_>, chain: Hash) -> Result<Option<Saved>> {
        let renderer = self.renderers.of(&plan.job.setup.shot)?;
        let memory = renderer.memory().map_err(device::failure)?;
        Ok(memory.map(|memory| Saved {
            memory,
            chain,
            setup: plan.job.setup.digest,
        }))
    }
}

impl<'a> Plan<'a> {
    fn new(job: &'a Job, reporter: &Reporter) -> Result<Self> {
        let (identities, chains): (Vec<String>, Vec<Hash>) = job.identities()?.into_iter().unzip();
        let chain = chains.last().copied().unwrap_or(job.chain().hash);
        let stamps: Vec<Stamp> = identities
            .into_iter()
            .zip(&job.frames)
            .map(|(hash, &frame)| Stamp { hash, frame })
            .collect();
        let files = Frames::of(&job.setup);
        let there = stamps.iter().enumerate();
        let current: Vec<bool> = there
            .map(|(i, stamp)| !job.written[i] || files.are_there(stamp))
            .collect();
        for (stamp, _) in stamps
            .iter()
            .zip(&current)
            .filter(|(_, current)| !**current)
        {
            files.may_write(stamp.frame)?;
        }
        let hashes = Some([chain, job.setup.digest]);
        let state_is_there = |file: &PathBuf| state::read_hashes(file) == hashes;
        let state = job.state_out.as_ref().filter(|file| !state_is_there(file));
        let state = state
            .map(|file| state::target(&job.setup.guard, file))
            .transpose()?;
        let mut plan = Self {
            job,
            stamps,
            current,
            computed: Vec::new(),
            state,
            video: None,
            checkpoint: None,
            resumed: None,
        };
        plan.plan_video(reporter)?;
        plan.computed = plan.current.iter().map(|current| !current).collect();
        if job.is_chain() {
            let needed = match &plan.state {
                Some(_) => plan.computed.len(),
                None => plan.computed.iter().rposition(|c| *c).map_or(0, |i| i + 1),
            };
            plan.computed[..needed].fill(true);
            plan.plan_checkpoint(&chains, needed, reporter);
        }
        Ok(plan)
    }

    /// Whether a video is made, and from which frames that must not be current then.
    fn plan_video(&mut self, reporter: &Reporter) -> Result<()> {
        let plan = self;
        let job = plan.job;
        let output = &job.setup.shot.output;
        let files = Frames::of(&job.setup);
        if output.video.is_empty() || job.count() < 2 {
            return Ok(());
        }
        let file = job.setup.out.join(&output.video);
        if !job.whole {
            reporter.remark("the video is made when all frames of the shot are asked for");
            return Ok(());
        }
        let hash = files.video_identity(&plan.stamps);
        let alone = !output.exr && !output.png;
        let frames_there = alone || plan.current.iter().all(|c| *c);
        if frames_there && video::is_current(&file, &hash) {
            plan.current.fill(true);
            return Ok(());
        }
        let aspect = job.setup.shot.image.pixel_aspect;
        if aspect != 1.0 {
            reporter.warn(&format!(
                "{}: a video has square pixels, and those of the shot are {aspect} times as wide as high: stretch it where it is shown",
                path_in_line(&file)
            ));
        }
        let file = job.setup.guard.target(&file)?;
        let encoder = video::prepare(&file, job.setup.size(), output.codec)?;
        plan.video = Some(VideoPlan {
            file,
            hash,
            encoder,
        });
        Ok(())
    }

    /// Where states are saved on the way to the first `needed` frames, and from which one the run continues.
    fn plan_checkpoint(&mut self, chains: &[Hash], needed: usize, reporter: &Reporter) {
        if needed == 0 || Checkpoint::is_too_large(self.job, needed, reporter) {
            return;
        }
        let missing = self.current[..needed].iter().position(|current| !current);
        // The last is computed in any case: a state may be wanted after it.
        let missing = missing.unwrap_or(needed).min(needed - 1);
        self.checkpoint = Checkpoint::of(self.job);
        let checkpoint = self.checkpoint.as_ref();
        if let Some((index, saved)) = checkpoint.and_then(|c| c.find(self.job, chains, missing)) {
            let frame = self.stamps[index].frame;
            reporter.remark(&format!(
                "the run continues from the state that one before it saved after frame {frame}"
            ));
            self.computed[..=index].fill(false);
            self.resumed = Some(saved);
        }
    }

    /// Begins the file of the state, and takes room for it: what cannot be saved is said before anything is rendered.
    fn begin_state(&self) -> Result<Option<Pending>> {
        let Some(target) = &self.state else {
            return Ok(None);
        };
        let mut pending = Pending::create(target)?;
        pending.reserve(self.job.state_bytes())?;
        Ok(Some(pending))
    }
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
#[derive(Clone)]
struct Inputs {
    light: Arc<PreparedEnv>,
    plate: Option<Arc<Plate>>,
    /// Hashes of what they were made of.
    of_light: Hash,
    of_plate: Option<Hash>,
}

impl Inputs {
    /// As [`Job::identities`] counts them.
    fn hash(&self) -> Hash {
        match &self.of_plate {
            Some(plate) => digest::join([&self.of_light, plate]),
            None => self.of_light,
        }
    }
}

/// The inputs of a frame, and what there is to say about them.
type Read = (Result<Inputs>, Vec<Note>);

/// Reads light and footage of each frame that is to be rendered and builds the light's tables, one frame ahead of the
/// renderer. A still is read once.
fn read_inputs(job: &Arc<Job>, plan: &Plan<'_>, mut notes: Notes) -> Result<Prefetch<Read>> {
    let pairs = plan.stamps.iter().zip(&plan.computed);
    let missing: Vec<i32> = pairs
        .filter(|(_, computed)| **computed)
        .map(|(s, _)| s.frame)
        .collect();
    let job = Arc::clone(job);
    let mut last: Option<Inputs> = None;
    let mut inputs = move |frame, notes: &mut Notes| -> Result<Inputs> {
        let (light, of_light) = match &last {
            Some(last) if job.is_still() => (Arc::clone(&last.light), last.of_light),
            _ => {
                let (light, hash) = job.light(frame, notes)?;
                (Arc::new(light), hash)
            }
        };
        let (plate, of_plate) = match &last {
            Some(last) if job.is_still_plate() => (last.plate.clone(), last.of_plate),
            _ => job
                .plate(frame, notes)?
                .map(|(plate, hash)| (Arc::new(plate), hash))
                .unzip(),
        };
        let read = Inputs {
            light,
            plate,
            of_light,
            of_plate,
        };
        last = Some(read.clone());
        Ok(read)
    };
    let read = move |frame| {
        let inputs = inputs(frame, &mut notes);
        (inputs, notes.take())
    };
    Prefetch::new(missing, 1, read).map_err(|e| Error::new(Kind::Internal, e))
}

/// Renders what is not there and passes it on; says how many frames were rendered, and what the last one came from.
fn render_frames(
    plan: &Plan<'_>,
    mut ready: Option<&mut SceneRenderer>,
    mut inputs: Prefetch<Read>,
    finish: &SyncSender<Finished>,
    reporter: &Reporter,
) -> Result<(usize, Chain)> {
    let mut rendered = 0;
    let mut chain = plan.job.chain();
    if let Some(saved) = &plan.resumed {
        chain.hash = saved.chain;
    }
    let mut checkpoint = plan.checkpoint.clone();
    let last = plan.computed.iter().rposition(|computed| *computed);
    let mut done = 0;
    for (index, planned) in plan.stamps.iter().enumerate() {
        interrupt::check(|| format!("{done} of {} frames are there", plan.job.count()))?;
        let frame = match (&mut ready, plan.computed[index]) {
            (Some(ready), true) => {
                let Some((read, notes)) = inputs.next() else {
                    break;
                };
                reporter.notes(notes);
                let read = read?;
                let hash = read.hash();
                let Inputs { light, plate, .. } = read;
                let began = Instant::now();
                let setup = &plan.job.setup;
                // Of what was read, whatever was there when the run began.
                let stamp = Stamp {
                    hash: chain.next(&setup.digest, &hash, planned.frame),
                    frame: planned.frame,
                };
                if stamp != *planned {
                    reporter.warn(&format!(
                        "light or backplate of frame {} changed since the run began: the frame is of what they are now",
                        stamp.frame
                    ));
                }
                let pose = setup.pose(stamp.frame)?;
                let refused = |e| setup.refused_scene(stamp.frame, &e);
                ready
                    .scene
                    .pose_shaped(&pose.transforms, &pose.shapes)
                    .map_err(refused)?;
                let settings = setup.settings(stamp.frame, pose.camera);
                let part = |fraction| reporter.part(done, fraction);
                let renderer = ready.renderers.of(&setup.shot)?;
                let image = renderer
                    .render_over(&ready.scene, &light, plate.as_deref(), &settings, &part)
                    .map_err(device::failure)?;
                if let Some(checkpoint) = &mut checkpoint
                    && checkpoint.is_due()
                    && last != Some(index)
                    && let Some(saved) = ready.state(plan, chain.hash)?
                {
                    checkpoint.save(plan.job, &saved, reporter);
                }
                match plan.current[index] {
                    // A later frame continues from it, no more.
                    true => Finished::Skipped(planned.frame),
                    false => {
                        rendered += 1;
                        let seconds = began.elapsed().as_secs_f64();
                        let primaries = setup.primaries_over(plate.as_deref());
                        Finished::Rendered(stamp, image, primaries, seconds)
                    }
                }
            }
            _ => Finished::Skipped(planned.frame),
        };
        if !plan.job.written[index] {
            continue;
        }
        done += 1;
        // A writer that has failed takes no more; its error is reported when it is joined.
        if finish.send(frame).is_err() {
            return Ok((rendered, chain));
        }
    }
    // The same holds here.
    let _ = finish.send(Finished::End);
    Ok((rendered, chain))
}

/// Writes frames as they come; the video gets its name at the end alone.
fn write_frames(plan: &Plan<'_>, reporter: &Reporter, finished: Receiver<Finished>) -> Result<()> {
    let job = plan.job;
    let files = Frames::of(&job.setup);
    let mut video = match &plan.video {
        Some(VideoPlan {
            file,
            hash,
            encoder,
        }) => {
            let size = job.setup.size();
            let fps = job.setup.shot.probe.fps;
            Some(Video::create(file, size, fps, *encoder, hash)?)
        }
        None => None,
    };
    for (done, frame) in (1..).zip(finished) {
        let (number, status) = match frame {
            Finished::Rendered(stamp, image, primaries, seconds) => {
                files.write(&image, primaries, &stamp)?;
                if let Some(video) = &mut video {
                    video.push(&rgb_over_black(&image.display))?;
                }
                (stamp.frame, FrameStatus::Rendered(seconds))
            }
            Finished::Skipped(number) => {
                if let Some(video) = &mut video {
                    video.push(&rgb_over_black(&files.display(number)?))?;
                }
                (number, FrameStatus::Skipped)
            }
            Finished::End => return video.map_or(Ok(()), Video::finish),
        };
        reporter.frame(number, status, done, job.count());
    }
    Ok(())
}
