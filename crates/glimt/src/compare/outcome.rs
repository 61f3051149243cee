//! Host file: what a comparison found: figures, whether its criteria hold, and the verdict in one sentence.

use super::contestants::Contestant;
use super::fit::{Fitted, Hold};
use super::lineage::Lineage;
use super::measures::{Bias, LocalBias, Score};
use super::reference::{CRITERION, LEAST, Reference};
use super::shadow_rays::ShadowRays;
use super::statistics::{Estimate, Quartiles, sidak};
use super::trials::{Record, Trial};
use serde::Serialize;

/// A bias is called one where noise gives as much less often than this, over all contestants.
const ALPHA: f64 = 0.01;

/// How contestants were made comparable.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Mode {
    /// Counts as given.
    EqualSamples,
    /// Counts fitted to a time of a frame.
    EqualTime,
}

/// The run: all that is needed to do it again.
#[derive(Clone, Debug, Serialize)]
pub struct About {
    /// The shot's file.
    pub shot: String,
    /// The command line.
    pub command: String,
    /// The program and its version.
    pub software: String,
    /// Processor and system.
    pub machine: String,
    /// What rendered.
    pub device: String,
    /// Width and height.
    pub size: [u32; 2],
    /// Where in its pixel a ray passed, for all.
    pub filter: String,
    /// Frames in which errors were measured.
    pub frames: Vec<i32>,
    /// Seeds of the contestants.
    pub seeds: Vec<u32>,
    /// How the reference was made.
    pub reference: String,
    /// Remarks: who was left out, and why.
    pub remarks: Vec<String>,
}

/// The reference of a measured frame.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct ReferenceFigures {
    /// The frame.
    pub frame: i32,
    /// Independent scramblings.
    pub scramblings: u32,
    /// Its relative noise.
    pub noise: Option<f64>,
    /// That over the smallest error of the frame.
    pub share_of_error: Option<f64>,
    /// Pixels that are compared.
    pub pixels: usize,
    /// Their mean luminance.
    pub mean_luminance: f64,
}

/// A phase of the renderer.
#[derive(Clone, Debug, PartialEq, Serialize, serde::Deserialize)]
pub struct Phase {
    /// Its name.
    pub name: String,
    /// Seconds of a frame.
    pub seconds: Quartiles,
}

/// A contestant's figures.
#[derive(Clone, Debug, Serialize)]
pub struct Figures {
    /// Its name.
    pub name: String,
    /// The keys that make it, with the fitted count.
    pub keys: Vec<String>,
    /// Its samples in words.
    pub samples: String,
    /// Whether others' efficiency is relative to its own.
    pub is_baseline: bool,
    /// Seconds of a frame.
    pub time: Quartiles,
    /// The same, of each round.
    pub times: Vec<f64>,
    /// Where they went.
    pub phases: Vec<Phase>,
    /// Whether they are the budget.
    pub hold: Hold,
    /// 1/(error² × time), relative to the baseline's.
    pub efficiency: Estimate,
    /// How its rays fare, where they continue from frame to frame.
    pub lineage: Option<Lineage>,
    /// Of all measured frames.
    pub overall: Score,
    /// Of each, in their order.
    pub frames: Vec<Score>,
    /// What each image was measured to be, of each frame.
    pub records: Vec<Vec<Record>>,
}

/// What a comparison found.
#[derive(Clone, Debug, Serialize)]
pub struct Outcome {
    /// All in one sentence.
    pub verdict: String,
    /// Whether the reference's noise is below a tenth of the smallest error in every frame; `None` where it is not known.
    pub reference_criterion: Option<bool>,
    /// Whether all times are within 5 % of the budget; `None` where there is none.
    pub time_criterion: Option<bool>,
    /// How contestants were made comparable.
    pub mode: Mode,
    /// The budget in seconds.
    pub budget: Option<f64>,
    /// The run.
    pub about: About,
    /// The references.
    pub references: Vec<ReferenceFigures>,
    /// The contestants.
    pub contestants: Vec<Figures>,
}

/// What was measured of one contestant.
pub struct Measured<'a> {
    /// Who.
    pub contestant: &'a Contestant,
    /// Its count and times.
    pub fitted: &'a Fitted,
    /// Where they went.
    pub phases: &'a [Phase],
    /// Its images.
    pub trials: &'a [Trial],
}

impl Outcome {
    /// Of trials and the references of the same frames. There is at least one of each.
    #[must_use]
    pub fn of(
        about: About,
        mode: Mode,
        budget: Option<f64>,
        references: &[&Reference],
        measured: &[Measured<'_>],
    ) -> Self {
        let mut contestants: Vec<Figures> =
            measured.iter().map(|m| figures(m, references)).collect();
        let baseline = contestants.iter().position(|c| c.is_baseline).unwrap_or(0);
        let base = contestants[baseline].clone();
        for (i, figures) in contestants.iter_mut().enumerate() {
            figures.efficiency = efficiency(figures, &base, i == baseline);
        }
        let references: Vec<ReferenceFigures> = references
            .iter()
            .enumerate()
            .map(|(i, r)| {
                let smallest = smallest(&contestants, i);
                ReferenceFigures {
                    frame: r.frame,
                    scramblings: r.moments.n,
                    noise: r.noise,
                    share_of_error: r.noise.map(|n| n / smallest),
                    pixels: r.pixels.len(),
                    mean_luminance: r.mean_luminance,
                }
            })
            .collect();
        let shares: Option<Vec<f64>> = references.iter().map(|r| r.share_of_error).collect();
        let reference_criterion = shares.map(|s| s.iter().all(|share| *share <= CRITERION));
        let time_criterion = budget.map(|_| {
            contestants
                .iter()
                .all(|c| matches!(c.hold, Hold::Held | Hold::Free))
        });
        let mut outcome = Self {
            verdict: String::new(),
            reference_criterion,
            time_criterion,
            mode,
            budget,
            about,
            references,
            contestants,
        };
        outcome.verdict = outcome.sentence();
        outcome
    }

    /// The largest share that the reference's noise has of a frame's smallest error.
    #[must_use]
    pub fn worst_share(&self) -> Option<f64> {
        let shares = self.references.iter().map(|r| r.share_of_error);
        shares.flatten().reduce(f64::max)
    }

    /// Contestants whose bias noise does not explain.
    #[must_use]
    pub fn biased(&self) -> Vec<&Figures> {
        let tests = self.contestants.len();
        let is_biased = |c: &&Figures| {
            c.overall
                .bias
                .p
                .is_some_and(|p| !(sidak(p, tests) >= ALPHA))
        };
        self.contestants.iter().filter(is_biased).collect()
    }

    fn sentence(&self) -> String {
        let share = self
            .worst_share()
            .map_or(String::new(), |s| format!("{s:.2}"));
        let reference = match self.reference_criterion {
            Some(true) => format!(
                "The reference criterion is met (its noise is at most {share} of the smallest error; {CRITERION} is allowed)"
            ),
            Some(false) => format!(
                "THE REFERENCE CRITERION IS NOT MET (its noise is up to {share} of the smallest error; {CRITERION} is allowed)"
            ),
            None => "THE REFERENCE CRITERION CANNOT BE CHECKED (the noise of a given reference is not known)".to_owned(),
        };
        let mut more = Vec::new();
        if (self.about.seeds.len() as u32) < LEAST {
            more.push(format!(
                "{} SEEDS ARE TOO FEW for a standard error, which needs {LEAST}",
                self.about.seeds.len()
            ));
        }
        for c in self.biased() {
            more.push(format!(
                "\u{201c}{}\u{201d} IS BIASED by {}",
                c.name,
                percent(c.overall.bias.of_image)
            ));
        }
        for c in &self.contestants {
            more.extend(c.lineage.map(|lineage| lineage.sentence(&c.name)));
        }
        more.extend(self.best());
        let time = self.time_sentence();
        format!("{reference}; {time}; {}.", more.join("; "))
    }

    /// Whether all contestants take the same time, in words.
    fn time_sentence(&self) -> String {
        let names = |hold: Hold| -> Vec<String> {
            let these = self.contestants.iter().filter(|c| c.hold == hold);
            these
                .map(|c| format!("\u{201c}{}\u{201d}", c.name))
                .collect()
        };
        let budget = milliseconds(self.budget.unwrap_or(0.0));
        let (coarse, missed) = (names(Hold::Granular), names(Hold::Missed));
        let fixed = names(Hold::Fixed);
        match self.time_criterion {
            None => "counts of samples are as given, times differ".to_owned(),
            Some(true) => {
                format!("the equal-time criterion is met (all medians are within 5 % of {budget})")
            }
            Some(false) => {
                let mut why = Vec::new();
                if !coarse.is_empty() {
                    why.push(format!(
                        "no whole count of {} takes {budget} to 5 %",
                        coarse.join(", ")
                    ));
                }
                if !fixed.is_empty() {
                    let fixed = fixed.join(", ");
                    why.push(format!("{fixed} has no count that would make it {budget}"));
                }
                if !missed.is_empty() {
                    why.push(format!("{} missed {budget}", missed.join(", ")));
                }
                format!("THE EQUAL-TIME CRITERION IS NOT MET ({})", why.join("; "))
            }
        }
    }

    /// The contestant of the smallest error, in words.
    fn best(&self) -> Option<String> {
        let best = self
            .contestants
            .iter()
            .min_by(|a, b| a.overall.error.value.total_cmp(&b.overall.error.value))?;
        let mut text = format!(
            "the smallest relative RMSE is that of \u{201c}{}\u{201d}, {}",
            best.name,
            plus_minus(best.overall.error)
        );
        let base = self
            .contestants
            .iter()
            .find(|c| c.is_baseline && !best.is_baseline);
        if let Some(base) = base {
            text.push_str(&format!(
                ", which is {} times as efficient as \u{201c}{}\u{201d}",
                plus_minus(best.efficiency),
                base.name
            ));
        }
        Some(text)
    }
}

/// The smallest error of a frame.
fn smallest(contestants: &[Figures], frame: usize) -> f64 {
    let errors = contestants.iter().map(|c| c.frames[frame].error.value);
    errors.fold(f64::INFINITY, f64::min)
}

fn figures(m: &Measured<'_>, references: &[&Reference]) -> Figures {
    let of_frame = |trial: &Trial, reference: &Reference| {
        let local = LocalBias::of(&trial.moments, reference);
        score(&[&trial.about], reference.mean_error, local)
    };
    let frames: Vec<Score> = m
        .trials
        .iter()
        .zip(references)
        .map(|(trial, reference)| of_frame(trial, reference))
        .collect();
    let records: Vec<&Vec<Record>> = m.trials.iter().map(|t| &t.about).collect();
    let count = references.len() as f64;
    let mean_error = references
        .iter()
        .map(|r| r.mean_error.powi(2))
        .sum::<f64>()
        .sqrt()
        / count;
    let overall = score(&records, mean_error, together(&frames));
    Figures {
        name: m.contestant.name.clone(),
        keys: m.contestant.set.clone(),
        samples: m.contestant.knob.describe(&m.contestant.shot),
        is_baseline: m.contestant.is_baseline,
        time: Quartiles::of(&m.fitted.times),
        times: m.fitted.times.clone(),
        phases: m.phases.to_vec(),
        hold: m.fitted.hold,
        efficiency: Estimate {
            value: 1.0,
            error: None,
        },
        lineage: lineage(m),
        overall,
        frames,
        records: m.trials.iter().map(|t| t.about.clone()).collect(),
    }
}

/// How a contestant's rays fare in all measured frames.
fn lineage(m: &Measured<'_>) -> Option<Lineage> {
    let of_frame = |trial: &Trial| trial.about.iter().filter_map(|r| r.lineage).collect();
    let frames: Vec<Vec<Lineage>> = m.trials.iter().map(of_frame).collect();
    Lineage::together(&frames)
}

/// Tests of all frames as one.
fn together(frames: &[Score]) -> Option<LocalBias> {
    let all: Option<Vec<LocalBias>> = frames.iter().map(|f| f.local).collect();
    let all = all?;
    let tiles = all.iter().map(|l| l.tiles).sum();
    let largest = all.iter().map(|l| l.largest).fold(0.0, f64::max);
    Some(LocalBias {
        tiles,
        beyond: all.iter().map(|l| l.beyond).sum(),
        largest,
        p: sidak(super::statistics::normal_two_sided(largest), tiles),
    })
}

/// Figures over the seeds, of one frame's records or of several, which are first averaged for each seed.
fn score(frames: &[&Vec<Record>], reference_error: f64, local: Option<LocalBias>) -> Score {
    let seeds = frames.first().map_or(0, |f| f.len());
    let over_frames = |f: &dyn Fn(&Record) -> Option<f64>| -> Option<Vec<f64>> {
        let of_seed = |k: usize| {
            let values: Vec<f64> = frames.iter().filter_map(|records| f(&records[k])).collect();
            (!values.is_empty()).then(|| values.iter().sum::<f64>() / values.len() as f64)
        };
        (0..seeds).map(of_seed).collect()
    };
    let all = |f: &dyn Fn(&Record) -> Option<f64>| over_frames(f).unwrap_or_default();
    Score {
        error: Estimate::root_mean(&all(&|r| Some(r.square_error))),
        bias: Bias::of(&all(&|r| Some(r.offset)), reference_error),
        local,
        flicker: over_frames(&|r| r.square_flicker).map(|f| Estimate::root_mean(&f)),
        flip: over_frames(&|r| r.flip).map(|f| Estimate::mean(&f)),
        rays: {
            let all: Option<Vec<ShadowRays>> =
                frames.iter().copied().flatten().map(|r| r.rays).collect();
            all.and_then(|all| ShadowRays::mean(&all))
        },
    }
}

fn efficiency(of: &Figures, base: &Figures, is_base: bool) -> Estimate {
    if is_base {
        return Estimate {
            value: 1.0,
            error: None,
        };
    }
    let cost = |f: &Figures| f.overall.error.value.powi(2) * f.time.median;
    let spread = |f: &Figures| {
        let time = f.time.median_error(f.times.len()) / f.time.median;
        (2.0 * f.overall.error.relative()).powi(2) + time.powi(2)
    };
    let value = cost(base) / cost(of);
    Estimate {
        value,
        error: Some(value * (spread(of) + spread(base)).sqrt()),
    }
}

/// `0.0312 ± 0.0004`, with two digits of the error.
#[must_use]
pub fn plus_minus(e: Estimate) -> String {
    match e.error {
        // What is left of rounding is not a spread.
        Some(error) if error > 1e-9 * e.value.abs() && error.is_finite() => {
            let digits = (1.0 - error.log10().floor()).clamp(0.0, 12.0) as usize;
            format!("{:.digits$} ± {error:.digits$}", e.value)
        }
        _ => format!("{:.3e}", e.value).replace("e0", ""),
    }
}

/// The same in per cent.
#[must_use]
pub fn percent(e: Estimate) -> String {
    let hundred = Estimate {
        value: 100.0 * e.value,
        error: e.error.map(|e| 100.0 * e),
    };
    format!("({}) %", plus_minus(hundred))
}

/// Seconds as milliseconds, with three digits.
#[must_use]
pub fn milliseconds(seconds: f64) -> String {
    let ms = seconds * 1e3;
    let digits = (2.0 - ms.abs().max(1e-9).log10().floor()).clamp(0.0, 6.0) as usize;
    format!("{ms:.digits$} ms")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn figures_are_written_with_their_spread() {
        let e = |value, error| plus_minus(Estimate { value, error });
        assert_eq!(e(0.031234, Some(0.00041)), "0.03123 ± 0.00041");
        assert_eq!(e(2.345, Some(0.1)), "2.35 ± 0.10");
        assert_eq!(e(234.5, Some(23.0)), "234 ± 23");
        assert_eq!(e(1.0, None), "1.000");
        assert_eq!(e(0.930859229755, Some(3e-13)), "9.309e-1");
        assert_eq!(milliseconds(0.012345), "12.3 ms");
        assert_eq!(milliseconds(1.2345), "1234 ms");
        let e = Estimate {
            value: -0.0213,
            error: Some(0.0011),
        };
        assert_eq!(percent(e), "(-2.13 ± 0.11) %");
    }

    #[test]
    fn scores_of_frames_are_averaged_by_seed() {
        let record = |seed, e2: f64, offset, f2| Record {
            seed,
            square_error: e2,
            offset,
            square_flicker: f2,
            flip: None,
            seconds: 1.0,
            lineage: None,
            rays: None,
        };
        let first = vec![record(1, 0.01, 0.1, None), record(2, 0.03, -0.1, None)];
        let second = vec![
            record(1, 0.02, 0.1, Some(0.04)),
            record(2, 0.02, -0.1, Some(0.04)),
        ];
        let s = score(&[&first, &second], 0.0, None);
        assert!((s.error.value - 0.02f64.sqrt()).abs() < 1e-12);
        // Means of 0.015 and 0.025 have a standard error of 0.005; the root halves it over its value.
        assert!((s.error.error.unwrap() - 0.0025 / 0.02f64.sqrt()).abs() < 1e-12);
        assert!(s.bias.of_image.value.abs() < 1e-12);
        assert!((s.flicker.unwrap().value - 0.2).abs() < 1e-12);
        assert!(s.flip.is_none());
    }
}
