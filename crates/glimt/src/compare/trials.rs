//! Host file: contestants render: every measured frame with every seed.

use super::contestants::Contestant;
use super::flip;
use super::lineage::Lineage;
use super::measures::{mean_offset, square_error, square_flicker};
use super::moments::{Kept, Moments};
use super::reference::Reference;
use super::shadow_rays::ShadowRays;
use super::trial_renderer::{Rendered, TrialRenderer, luminance_of};
use crate::error::Result;
use crate::output::target::Guard;
use crate::output::{SOFTWARE, write_text};
use crate::shot::digest;
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// How long unsaved work may be.
const SAVE_EVERY: Duration = Duration::from_secs(5);

/// Seeds of the trial run that says how small errors are.
const PILOT_SEEDS: u32 = 2;

/// What one image of one frame was measured to be.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Record {
    /// Its seed.
    pub seed: u32,
    /// E².
    pub square_error: f64,
    /// Bias of this image alone.
    pub offset: f64,
    /// F², where there is a frame before.
    pub square_flicker: Option<f64>,
    /// FLIP, where it is there.
    pub flip: Option<f64>,
    /// Seconds of rendering.
    pub seconds: f64,
    /// How its rays fare, where they continue from frame to frame.
    #[serde(default)]
    pub lineage: Option<Lineage>,
    /// Its shadow rays, where the method chose their number.
    #[serde(default)]
    pub rays: Option<ShadowRays>,
}

/// Images of one contestant in one frame: moments, the first image, and what each was measured to be.
pub type Trial = Kept<Vec<Record>>;

/// Where and what to render.
#[derive(Clone, Debug)]
pub struct TrialPlan {
    /// Frames of the shot, in order, and their identities.
    pub frames: Vec<(i32, String)>,
    /// Frames in which errors are measured, in order.
    pub measured: Vec<i32>,
    /// Independent scramblings.
    pub seeds: u32,
    /// Where it is kept.
    pub folder: PathBuf,
    /// What may be written there.
    pub guard: Guard,
}

impl TrialPlan {
    /// The frame before, if the shot has it.
    #[must_use]
    pub fn before(&self, frame: i32) -> Option<i32> {
        let before = frame.checked_sub(1)?;
        self.frames.iter().any(|f| f.0 == before).then_some(before)
    }

    /// Measured frames and those before them, in order.
    #[must_use]
    pub fn needed(&self) -> Vec<i32> {
        let all = self
            .measured
            .iter()
            .flat_map(|&f| [self.before(f), Some(f)]);
        let mut needed: Vec<i32> = all.flatten().collect();
        needed.sort_unstable();
        needed.dedup();
        needed
    }

    /// The frames that a contestant renders, in order: one that continues from the frame before renders all.
    #[must_use]
    pub fn sequence(&self, contestant: &Contestant) -> Vec<i32> {
        let last = self.measured.last().copied().unwrap_or(0);
        match contestant.is_stateful() {
            true => self
                .frames
                .iter()
                .map(|f| f.0)
                .take_while(|f| *f <= last)
                .collect(),
            false => self.needed(),
        }
    }

    /// The seeds, which count up from the shot's.
    #[must_use]
    pub fn seed(&self, contestant: &Contestant, index: u32) -> u32 {
        contestant.shot.render.seed.wrapping_add(index)
    }

    /// The identity of a contestant's images of a frame: all that they are made of.
    fn identity(&self, contestant: &Contestant, frame: i32, what: &str) -> String {
        let mut text = format!("{what} {}", digest::hex(&contestant.digest()));
        let needed = self
            .frames
            .iter()
            .filter(|(number, _)| match contestant.is_stateful() {
                true => *number <= frame,
                false => *number == frame || Some(*number) == self.before(frame),
            });
        for (_, identity) in needed {
            text.push(' ');
            text.push_str(identity);
        }
        digest::hex(&digest::of_text(&text))
    }

    fn file(&self, contestant: &Contestant, frame: i32) -> PathBuf {
        // Names may differ in what a file's name cannot hold.
        let hash = digest::hex(&digest::of_text(&contestant.name));
        let name = format!("{}-{}.{frame:04}.moments", contestant.slug(), &hash[..8]);
        self.folder.join(name)
    }
}

/// Says what the images of a contestant are measured against.
fn tag(references: &[Reference]) -> String {
    let mut text = String::new();
    for r in references {
        text.push_str(&format!(
            "{} {} {:e} {:?} {};",
            r.frame,
            r.moments.n,
            r.mean_luminance,
            r.noise,
            r.pixels.len()
        ));
    }
    digest::hex(&digest::of_text(&text))
}

/// Relative RMSE of each measured frame, as the difference of few seeds shows it without a reference. `progress` is called with the
/// seconds of each frame.
///
/// # Errors
/// A frame cannot be rendered.
pub fn pilot(
    plan: &TrialPlan,
    contestant: &Contestant,
    renderer: &mut TrialRenderer<'_>,
    progress: &mut dyn FnMut(f64),
) -> Result<Vec<f64>> {
    let last = plan.measured.last().copied().unwrap_or(0);
    let identity = plan.identity(contestant, last, &format!("pilot 1 {:?}", plan.measured));
    let identity = format!("{SOFTWARE} {identity}");
    let hash = digest::hex(&digest::of_text(&contestant.name));
    let file = plan
        .folder
        .join(format!("{}-{}.pilot.json", contestant.slug(), &hash[..8]));
    let kept = std::fs::read(&file).ok();
    let kept = kept.and_then(|bytes| serde_json::from_slice::<(String, Vec<f64>)>(&bytes).ok());
    if let Some((_, errors)) =
        kept.filter(|(i, e)| *i == identity && e.len() == plan.measured.len())
    {
        return Ok(errors);
    }
    let mut moments = vec![Moments::new(renderer.size()); plan.measured.len()];
    let frames = match contestant.is_stateful() {
        true => plan.sequence(contestant),
        false => plan.measured.clone(),
    };
    for k in 0..PILOT_SEEDS {
        // Others than those of the trials.
        let seed = plan.seed(contestant, k).wrapping_add(1 << 30);
        renderer.forget_past();
        for &frame in &frames {
            let image = renderer.render(&contestant.shot, frame, seed)?;
            progress(image.seconds);
            if let Ok(i) = plan.measured.binary_search(&frame) {
                moments[i].push(&image.pixels);
            }
        }
    }
    let error = |m: &Moments| {
        let seen: Vec<usize> = (0..m.mean.len()).filter(|p| m.mean[*p].w > 0.0).collect();
        let sum =
            |f: &dyn Fn(usize) -> f64| seen.iter().map(|p| f(*p)).sum::<f64>() / seen.len() as f64;
        let variance = sum(&|p| f64::from(m.variance(p).truncate().element_sum()) / 3.0);
        let error = variance.sqrt() / sum(&|p| luminance_of(m.mean[p]));
        // A frame without objects is refused when the reference is made.
        if error.is_finite() { error } else { 0.0 }
    };
    let errors: Vec<f64> = moments.iter().map(error).collect();
    let text = serde_json::to_string(&(identity, &errors)).unwrap_or_default();
    write_text(&plan.guard.target(&file)?, &text)?;
    Ok(errors)
}

/// What a contestant's trials have in common.
pub struct Trials<'a> {
    /// What to render.
    pub plan: &'a TrialPlan,
    /// References of [`TrialPlan::needed`], in that order.
    pub references: &'a [Reference],
    /// What they display, where FLIP is measured.
    shown: Vec<Vec<u8>>,
    tag: String,
}

impl<'a> Trials<'a> {
    /// Against these references.
    ///
    /// # Errors
    /// The shot's settings are refused.
    pub fn new(
        plan: &'a TrialPlan,
        references: &'a [Reference],
        of: &Contestant,
        renderer: &TrialRenderer<'_>,
    ) -> Result<Self> {
        let mut shown = Vec::new();
        if flip::IS_THERE {
            for reference in references {
                shown.push(renderer.display(&of.shot, &reference.moments.mean)?);
            }
        }
        Ok(Self {
            plan,
            references,
            shown,
            tag: tag(references),
        })
    }

    fn index(&self, frame: i32) -> Option<usize> {
        self.references
            .binary_search_by_key(&frame, |r| r.frame)
            .ok()
    }

    /// The reference of a frame.
    ///
    /// # Panics
    /// The frame is none of the needed ones.
    #[must_use]
    pub fn reference(&self, frame: i32) -> &'a Reference {
        let index = self.index(frame).expect("a frame that is needed");
        &self.references[index]
    }

    fn identity(&self, contestant: &Contestant, frame: i32) -> String {
        let what = format!("trial 1 {} {}", self.tag, flip::IS_THERE);
        self.plan.identity(contestant, frame, &what)
    }

    fn open(&self, contestant: &Contestant, frame: i32, renderer: &TrialRenderer<'_>) -> Trial {
        let file = self.plan.file(contestant, frame);
        let kept = Trial::read(&file, &self.identity(contestant, frame), renderer.size());
        // A run with more seeds continues; what one with fewer finds cannot be divided.
        let kept = kept.filter(|k| k.about.len() <= self.plan.seeds as usize);
        kept.unwrap_or_else(|| Trial {
            moments: Moments::new(renderer.size()),
            sample: None,
            about: Vec::new(),
        })
    }

    /// Renders what is not there; one trial for each measured frame. `progress` is called with the seconds of each frame.
    ///
    /// # Errors
    /// A frame cannot be rendered, or a file not be written.
    pub fn run(
        &self,
        contestant: &Contestant,
        renderer: &mut TrialRenderer<'_>,
        progress: &mut dyn FnMut(f64),
    ) -> Result<Vec<Trial>> {
        let plan = self.plan;
        let mut trials: Vec<Trial> = plan
            .measured
            .iter()
            .map(|&frame| self.open(contestant, frame, renderer))
            .collect();
        let mut saved = Instant::now();
        let mut changed = false;
        let frames = plan.sequence(contestant);
        for k in 0..plan.seeds {
            let waits = |t: &Trial| t.about.len() as u32 <= k;
            if !trials.iter().any(waits) {
                continue;
            }
            let seed = plan.seed(contestant, k);
            renderer.forget_past();
            let mut before: Option<Rendered> = None;
            for &frame in &frames {
                let image = renderer.render(&contestant.shot, frame, seed)?;
                progress(image.seconds);
                if let Ok(i) = plan.measured.binary_search(&frame)
                    && waits(&trials[i])
                {
                    let before = before
                        .as_ref()
                        .filter(|before| Some(before.frame) == plan.before(frame));
                    let picture = match self.shown.is_empty() {
                        true => None,
                        false => Some(renderer.display(&contestant.shot, &image.pixels)?),
                    };
                    let record = self.measure(&image, before, picture.as_deref());
                    let trial = &mut trials[i];
                    trial.about.push(record);
                    trial.moments.push(&image.pixels);
                    if trial.sample.is_none() {
                        trial.sample = Some(image.pixels.clone());
                    }
                    changed = true;
                }
                before = Some(image);
            }
            if changed && (saved.elapsed() > SAVE_EVERY || k + 1 == plan.seeds) {
                self.save(contestant, &trials)?;
                (saved, changed) = (Instant::now(), false);
            }
        }
        Ok(trials)
    }

    /// What an image is measured to be: against the reference, against the image of the frame `before`, and as the `picture` that
    /// is displayed of it, where those are there.
    fn measure(
        &self,
        image: &Rendered,
        before: Option<&Rendered>,
        picture: Option<&[u8]>,
    ) -> Record {
        let reference = self.reference(image.frame);
        let flicker = |then: &Rendered| {
            let reference_then = self.reference(then.frame);
            square_flicker(&image.pixels, &then.pixels, reference, reference_then)
        };
        let shown = self.index(image.frame).and_then(|i| self.shown.get(i));
        let flip = |(shown, picture): (&Vec<u8>, &[u8])| {
            flip::mean(reference.moments.size, shown, picture)
        };
        Record {
            seed: image.seed,
            square_error: square_error(&image.pixels, reference),
            offset: mean_offset(&image.pixels, reference),
            square_flicker: before.map(flicker),
            flip: shown.zip(picture).and_then(flip),
            seconds: image.seconds,
            lineage: image.lineage,
            rays: image.rays,
        }
    }

    fn save(&self, contestant: &Contestant, trials: &[Trial]) -> Result<()> {
        for (trial, &frame) in trials.iter().zip(&self.plan.measured) {
            let file = self.plan.file(contestant, frame);
            let target = self.plan.guard.target(&file)?;
            trial.write(&target, &self.identity(contestant, frame))?;
        }
        Ok(())
    }

    /// Frames that a contestant has still to render, about.
    #[must_use]
    pub fn left(&self, contestant: &Contestant, renderer: &TrialRenderer<'_>) -> usize {
        let there = self.plan.measured.iter();
        let there = there
            .map(|&f| self.open(contestant, f, renderer).about.len())
            .min();
        let seeds = self.plan.seeds as usize - there.unwrap_or(0);
        seeds * self.plan.sequence(contestant).len()
    }
}

/// The folder of what is kept, below the outputs.
#[must_use]
pub fn cache(out: &Path) -> PathBuf {
    out.join("cache")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cli::{CompareFlags, RenderFlags};
    use crate::compare::contestants::{Field, gather};
    use crate::shot::{Filter, Method};

    /// Each test has a folder of its own: tests of one process run side by side.
    fn contestant(test: &str) -> Contestant {
        let folder = format!("glimt-trials-{test}-{}", std::process::id());
        let folder = std::env::temp_dir().join(folder);
        std::fs::create_dir_all(&folder).unwrap();
        let file = folder.join("shot.toml");
        let text = "[probe]\nframes = \"l.####.exr\"\n[[object]]\nmesh = \"sphere\"\n";
        std::fs::write(&file, text).unwrap();
        let field = Field {
            file: &file,
            flags: &RenderFlags::default(),
            filter: Filter::Centre,
        };
        let flags = CompareFlags {
            preset: vec!["shot".to_owned()],
            ..CompareFlags::default()
        };
        let all = gather(&field, &flags, &mut Vec::new());
        std::fs::remove_dir_all(&folder).unwrap();
        all.unwrap().remove(0)
    }

    fn plan() -> TrialPlan {
        TrialPlan {
            frames: (3..=12).map(|f| (f, format!("identity of {f}"))).collect(),
            measured: vec![3, 5, 10],
            seeds: 2,
            folder: PathBuf::new(),
            guard: Guard::default(),
        }
    }

    /// One that continues from the frame before renders all frames from the first to the last that is measured.
    #[test]
    fn frames_are_rendered_in_order() {
        let mut contestant = contestant("order");
        let plan = plan();
        assert_eq!(plan.needed(), [3, 4, 5, 9, 10]);
        assert_eq!(plan.before(3), None);
        assert_eq!(plan.sequence(&contestant), [3, 4, 5, 9, 10]);
        contestant.shot.render.method = Method::Smc;
        assert_eq!(plan.sequence(&contestant), [3, 4, 5, 6, 7, 8, 9, 10]);
    }

    /// What images are made of is their identity: for one that continues, all frames before.
    #[test]
    fn identities_tell_inputs_apart() {
        let mut contestant = contestant("identities");
        let of = |change: Option<i32>, contestant: &Contestant, frame| {
            let mut plan = plan();
            for f in plan.frames.iter_mut().filter(|f| Some(f.0) == change) {
                f.1.push('!');
            }
            plan.identity(contestant, frame, "trial")
        };
        let is_other = |changed, c: &Contestant| of(Some(changed), c, 10) != of(None, c, 10);
        assert!(is_other(10, &contestant) && is_other(9, &contestant));
        assert!(!is_other(8, &contestant) && !is_other(11, &contestant));
        contestant.shot.render.method = Method::Smc;
        assert!(is_other(3, &contestant) && is_other(10, &contestant));
        assert!(!is_other(11, &contestant));
        let before = of(None, &contestant, 10);
        contestant.shot.render.seed += 1;
        assert_ne!(of(None, &contestant, 10), before);
    }
}
