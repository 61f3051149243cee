//! Host file: what contestants have in common: the frames and seeds, what renders them, and how far it is.

use super::contestants::{Contestant, Field};
use super::progress::Progress;
use super::reference;
use super::trial_renderer::TrialRenderer;
use super::trials::TrialPlan;
use crate::cli::{CompareFlags, RenderFlags};
use crate::error::{Error, Result};
use crate::input::footage;
use crate::job::Job;
use crate::notes::Notes;
use crate::output::atomic;
use crate::report::Reporter;
use crate::setup;
use crate::shot::{Filter, Shot, parse, range};
use std::path::Path;

/// Most frames that are measured where none are named.
const MOST_FRAMES: usize = 8;

/// A comparison that is ready to render.
pub(super) struct Comparison<'a> {
    pub(super) field: &'a Field<'a>,
    pub(super) flags: &'a CompareFlags,
    pub(super) plan: TrialPlan,
    pub(super) renderer: TrialRenderer<'a>,
    pub(super) progress: Progress<'a>,
}

impl<'a> Comparison<'a> {
    /// Loads the shot and opens the device. What is rendered is kept in the folder `kept`.
    ///
    /// # Errors
    /// The shot is wrong, or names a file that cannot be read; the device cannot be opened.
    pub(super) fn open(
        field: &'a Field<'a>,
        flags: &'a CompareFlags,
        kept: &Path,
        reporter: &'a Reporter,
    ) -> Result<Self> {
        let mut notes = Notes::new(field.flags.strict);
        let job = Job::from_file(field.file, &of_reference(field), &mut notes, reporter);
        reporter.notes(notes.take());
        let job = job?;
        if !range::is_whole(&job.frames) {
            return Err(Error::usage(
                "frames are left out, and methods that continue from one to the next need all",
            )
            .at("--frames or render.frames")
            .fix("name the first and the last, and choose with --stride or --measure among them"));
        }
        atomic::prepare_folder(kept)?;
        let plan = TrialPlan {
            measured: measured(&job.frames, flags)?,
            frames: job
                .frames
                .iter()
                .copied()
                .zip(job.identities()?.into_iter().map(|(identity, _)| identity))
                .collect(),
            seeds: flags.seeds,
            folder: kept.to_owned(),
            guard: job.setup.guard.clone(),
        };
        Ok(Self {
            field,
            flags,
            plan,
            renderer: TrialRenderer::open(job, field.flags.device, notes, reporter)?,
            progress: Progress::new(reporter),
        })
    }

    /// Checks that the renderer accepts all contestants.
    ///
    /// # Errors
    /// One that it refuses.
    pub(super) fn check(&mut self, contestants: &[Contestant]) -> Result<()> {
        contestants
            .iter()
            .try_for_each(|contestant| self.renderer.check(contestant))
    }
}

/// The filter of all: as the shot or a flag gives it, else rays through the pixel's centre, since light is what is compared.
pub(super) fn common_filter(file: &Path, flags: &RenderFlags) -> Result<Filter> {
    let (mut shot, source) = parse::read::<Shot>(file, &setup::overrides(flags))?;
    footage::adopt_size(&mut shot, &source)?;
    Ok(match source.gives("image.filter") {
        true => shot.image.filter,
        false => Filter::Centre,
    })
}

pub(super) fn filter_name(filter: Filter) -> &'static str {
    match filter {
        Filter::Box => "box",
        Filter::Centre => "centre",
    }
}

/// The flags by which a shot makes the reference.
fn of_reference(field: &Field<'_>) -> RenderFlags {
    let mut flags = field.flags.clone();
    // Before the other settings a method would be overridden by them.
    flags.set = setup::overrides(field.flags);
    (flags.method, flags.seed) = (None, None);
    flags.set.extend(reference::keys());
    flags.set.extend([
        format!("image.filter={}", filter_name(field.filter)),
        "image.background=transparent".to_owned(),
        "output.aovs=[]".to_owned(),
    ]);
    flags
}

/// The frames in which errors are measured.
fn measured(frames: &[i32], compare: &CompareFlags) -> Result<Vec<i32>> {
    let (first, last) = (frames[0], frames[frames.len() - 1]);
    if let Some(missing) = compare.measure.iter().find(|f| !frames.contains(f)) {
        return Err(
            Error::usage(format!("frame {missing} is not among {first}-{last}"))
                .at("--measure")
                .fix("choose among the frames of the shot, or of --frames"),
        );
    }
    let mut chosen = compare.measure.clone();
    if chosen.is_empty() {
        chosen = match compare.stride {
            Some(stride) => frames.iter().copied().step_by(stride as usize).collect(),
            None if frames.len() <= MOST_FRAMES => frames.to_vec(),
            None => (1..=MOST_FRAMES)
                .map(|k| frames[k * frames.len() / MOST_FRAMES - 1])
                .collect(),
        };
    }
    chosen.sort_unstable();
    chosen.dedup();
    Ok(chosen)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frames_are_chosen() {
        let frames: Vec<i32> = (11..=106).collect();
        let of = |flags: &CompareFlags| measured(&frames, flags);
        let default = CompareFlags::default();
        assert_eq!(of(&default).unwrap(), [22, 34, 46, 58, 70, 82, 94, 106]);
        let stride = CompareFlags {
            stride: Some(40),
            ..CompareFlags::default()
        };
        assert_eq!(of(&stride).unwrap(), [11, 51, 91]);
        let named = |list: &[i32]| CompareFlags {
            measure: list.to_vec(),
            ..CompareFlags::default()
        };
        assert_eq!(of(&named(&[90, 15, 90])).unwrap(), [15, 90]);
        let error = of(&named(&[5])).unwrap_err().to_string();
        assert!(error.contains("frame 5 is not among 11-106"), "{error}");
    }
}
