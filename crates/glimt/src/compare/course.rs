//! Host file: references and trials, until the one is good enough for the other.

use super::comparison::{Comparison, filter_name};
use super::contestants::Contestant;
use super::outcome::{About, Measured, Outcome};
use super::reference::{self, CRITERION, Growing, Reference};
use super::statistics::Quartiles;
use super::times::Times;
use super::trials::{self, Trial, Trials};
use crate::error::{Error, Result};
use std::path::Path;

/// Share of the criterion that the reference is grown to by the errors of the trial run: those of few seeds may come out too large.
const MARGIN: f64 = 0.8;

/// How often the reference is grown and the contestants are held against it once more.
const RETRIES: usize = 3;

/// Relative noise that counts as none: precomputed transfer through pixel centres does not depend on the seed.
const NOISELESS: f64 = 1e-6;

/// What was found against one set of references.
type Round = (Outcome, Vec<Reference>, Vec<Vec<Trial>>);

/// References and trials, until the one is good enough for the other.
pub(super) struct Course<'a> {
    comparison: Comparison<'a>,
    contestants: Vec<Contestant>,
    times: Times,
    about: About,
}

/// What a comparison found, and the images that it was found in.
pub struct Findings {
    /// The figures.
    pub outcome: Outcome,
    /// Who was compared, with the counts that they were given.
    pub contestants: Vec<Contestant>,
    /// References of all frames that are needed.
    pub references: Vec<Reference>,
    /// Trials of each contestant, one for each measured frame.
    pub trials: Vec<Vec<Trial>>,
}

impl<'a> Course<'a> {
    /// Of contestants with these counts; `about` describes the run, but for its reference.
    pub(super) fn new(
        comparison: Comparison<'a>,
        contestants: Vec<Contestant>,
        times: Times,
        about: About,
    ) -> Self {
        Self {
            comparison,
            contestants,
            times,
            about,
        }
    }

    /// Renders references and trials. Returns what they show, with what rendered them.
    ///
    /// # Errors
    /// A frame cannot be rendered or written, or a given reference does not fit.
    pub(super) fn run(mut self) -> Result<(Findings, Comparison<'a>)> {
        let (outcome, references, trials) = match &self.comparison.flags.reference {
            Some(folder) => self.against_given(folder)?,
            None => self.against_own()?,
        };
        let findings = Findings {
            outcome,
            contestants: self.contestants,
            references,
            trials,
        };
        Ok((findings, self.comparison))
    }

    /// Holds the contestants against the reference in a folder.
    fn against_given(&mut self, folder: &Path) -> Result<Round> {
        let needed = self.comparison.plan.needed();
        let size = self.comparison.renderer.size();
        let references = reference::read(folder, &needed, size)?;
        self.check_given(&references)?;
        self.round(references, format!("given: {}", folder.display()))
    }

    /// Grows a reference until the contestants can be held against it, or the time for it is over.
    fn against_own(&mut self) -> Result<Round> {
        let needed = self.comparison.plan.needed();
        let mut targets = self.first_targets()?;
        let frames: Vec<(i32, String)> = self
            .comparison
            .plan
            .frames
            .iter()
            .filter(|f| needed.contains(&f.0))
            .cloned()
            .collect();
        let Comparison { plan, renderer, .. } = &self.comparison;
        let shot = renderer.job.setup.shot.clone();
        let mut growing = Growing::open(&shot, plan, &frames, renderer.size());
        let limit = self.comparison.flags.reference_time;
        for attempt in 1.. {
            let of_needed: Vec<f64> = needed.iter().map(|f| self.target(*f, &targets)).collect();
            let left = self.trial_seconds(None);
            let Comparison {
                renderer, progress, ..
            } = &mut self.comparison;
            let rendered = &mut |seconds: f64, more: f64| {
                progress.plan(more + left + seconds);
                progress.rendered("reference", seconds);
            };
            let references = growing.grow(renderer, &of_needed, limit, rendered)?;
            let how = format!(
                "MIS, {} rays with 1 + 1 Owen-Sobol samples in each of its independent scramblings",
                reference::RAYS
            );
            let round = self.round(references, how)?;
            let outcome = &round.0;
            let over = limit.is_some_and(|limit| growing.seconds >= limit);
            if outcome.reference_criterion == Some(true) || over || attempt == RETRIES {
                return Ok(round);
            }
            for (i, target) in targets.iter_mut().enumerate() {
                let errors = outcome.contestants.iter().map(|c| c.frames[i].error.value);
                let smallest = errors.fold(f64::INFINITY, f64::min);
                *target = target.min(smallest * CRITERION * 0.95);
            }
        }
        unreachable!("the last attempt returns")
    }

    /// The noise that the reference of each measured frame may have, by a trial run.
    fn first_targets(&mut self) -> Result<Vec<f64>> {
        let ahead = self.trial_seconds(None) * 1.2;
        let Comparison {
            plan,
            renderer,
            progress,
            ..
        } = &mut self.comparison;
        progress.plan(ahead);
        let mut pilots = Vec::new();
        for contestant in &self.contestants {
            let what = format!("trial run of {}", contestant.name);
            let rendered = &mut |seconds| progress.rendered(&what, seconds);
            pilots.push(trials::pilot(plan, contestant, renderer, rendered)?);
        }
        // The error of one without noise is its bias, which only the trials show.
        let is_noisy = |error: &f64| *error > NOISELESS;
        let smallest = |i: usize| {
            let errors = pilots.iter().map(|p| p[i]);
            errors.filter(is_noisy).fold(f64::INFINITY, f64::min)
        };
        Ok((0..plan.measured.len())
            .map(|i| smallest(i) * CRITERION * MARGIN)
            .collect())
    }

    /// Renders the trials, and holds them against these references, which were made as `how` says.
    fn round(&mut self, references: Vec<Reference>, how: String) -> Result<Round> {
        let trials = self.trials(&references)?;
        let about = About {
            reference: how,
            ..self.about.clone()
        };
        let outcome = self.outcome(about, &references, &trials);
        Ok((outcome, references, trials))
    }

    /// The target of a needed frame: that of the measured frame that it is, or comes before.
    fn target(&self, frame: i32, targets: &[f64]) -> f64 {
        let pairs = self.comparison.plan.measured.iter().zip(targets);
        let needs =
            pairs.filter(|(m, _)| **m == frame || self.comparison.plan.before(**m) == Some(frame));
        needs
            .map(|(_, target)| *target)
            .fold(f64::INFINITY, f64::min)
    }

    /// A given reference that shows more or less than the contestants do was made with other settings.
    fn check_given(&mut self, references: &[Reference]) -> Result<()> {
        let shot = &self.contestants[0].shot;
        for reference in references {
            let image = self.comparison.renderer.render(shot, reference.frame, 1)?;
            let pairs = image.pixels.iter().zip(&reference.moments.mean);
            let differ = pairs.filter(|(a, b)| (a.w > 0.0) != (b.w > 0.0)).count();
            // With the box filter, few rays may miss what many touch.
            if differ * 20 > reference.pixels.len() {
                return Err(Error::usage(format!(
                    "frame {} of the reference covers other pixels than the contestants do",
                    reference.frame
                ))
                .at("--reference")
                .fix(format!(
                    "render it with --set image.background=transparent --set image.filter={}",
                    filter_name(shot.image.filter)
                )));
            }
        }
        Ok(())
    }

    fn trials(&mut self, references: &[Reference]) -> Result<Vec<Vec<Trial>>> {
        // The plan is borrowed while the renderer works.
        let plan = self.comparison.plan.clone();
        let first = &self.contestants[0];
        let trials = Trials::new(&plan, references, first, &self.comparison.renderer)?;
        let left = self.trial_seconds(Some(&trials));
        let Comparison {
            renderer, progress, ..
        } = &mut self.comparison;
        progress.plan(left);
        let mut all = Vec::new();
        for contestant in &self.contestants {
            let rendered = &mut |seconds| progress.rendered(&contestant.name, seconds);
            all.push(trials.run(contestant, renderer, rendered)?);
        }
        Ok(all)
    }

    /// Seconds of rendering that the trials have left, about.
    fn trial_seconds(&self, trials: Option<&Trials<'_>>) -> f64 {
        let seconds = self
            .contestants
            .iter()
            .zip(&self.times.fitted)
            .map(|(c, fitted)| {
                let all =
                    self.comparison.plan.sequence(c).len() * self.comparison.plan.seeds as usize;
                let frames = trials.map_or(all, |t| t.left(c, &self.comparison.renderer));
                frames as f64 * Quartiles::of(&fitted.times).median
            });
        seconds.sum()
    }

    fn outcome(&self, about: About, references: &[Reference], trials: &[Vec<Trial>]) -> Outcome {
        let measured: Vec<Measured<'_>> = self
            .contestants
            .iter()
            .enumerate()
            .map(|(i, contestant)| Measured {
                contestant,
                fitted: &self.times.fitted[i],
                phases: &self.times.phases[i],
                trials: &trials[i],
            })
            .collect();
        let frames = &self.comparison.plan.measured;
        let is_measured = |r: &&Reference| frames.contains(&r.frame);
        let seen: Vec<&Reference> = references.iter().filter(is_measured).collect();
        Outcome::of(about, self.times.mode, self.times.budget, &seen, &measured)
    }
}
