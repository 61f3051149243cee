//! Host file: `glimt compare`: estimators side by side on one shot, in figures that can be cited and made again.
//!
//! [`contestants`] says who takes part, [`fit`] finds the counts that make them equally long, [`mod@reference`] renders what they are
//! held against, [`trials`] renders them, [`measures`] defines the figures, [`statistics`] their spreads, and [`report`] writes all
//! of it. What is rendered is kept below the outputs as [`moments`]; a run that was stopped goes on there.

pub mod contestants;
pub mod count;
pub mod fit;
pub mod flip;
pub mod lineage;
pub mod measures;
pub mod moments;
pub mod outcome;
pub mod progress;
pub mod reference;
pub mod report;
pub mod stage;
pub mod statistics;
pub mod trials;

use crate::cli::{CompareFlags, RenderFlags};
use crate::error::{Error, Result};
use crate::input::footage;
use crate::job::Job;
use crate::notes::Notes;
use crate::output::{SOFTWARE, Stamp, atomic, exr, write_text};
use crate::report::{Reporter, shown};
use crate::setup;
use crate::shot::{Filter, Shot, digest, parse};
use contestants::{Contestant, Field};
use fit::{Budget, Clock, Fitted};
use outcome::{About, Measured, Mode, Outcome, Phase};
use progress::Progress;
use reference::{CRITERION, Growing, Reference};
use serde_json::json;
use stage::Stage;
use statistics::Quartiles;
use std::path::{Path, PathBuf};
use trials::{Plan, Trial, Trials};

/// Most frames that are measured where none are named.
const MOST_FRAMES: usize = 8;

/// Share of the criterion that the reference is grown to by the errors of the trial run: those of few seeds may come out too large.
const MARGIN: f64 = 0.8;

/// How often the reference is grown and the contestants are held against it once more.
const RETRIES: usize = 3;

/// Relative noise that counts as none: precomputed transfer through pixel centres hangs on no seed.
const NOISELESS: f64 = 1e-6;

/// Compares what the flags say and writes the report.
///
/// # Errors
/// The flags, the shot or a contestant is wrong, or something cannot be rendered or written. What is rendered stays.
pub fn run(
    file: &Path,
    flags: &RenderFlags,
    compare: &CompareFlags,
    reporter: &Reporter,
) -> Result<()> {
    let began = std::time::Instant::now();
    let base = file.parent().unwrap_or(Path::new(""));
    let field = Field {
        file,
        flags,
        filter: common_filter(file, flags)?,
    };
    let mut remarks = Vec::new();
    let contestants = contestants::gather(&field, compare, &mut remarks)?;
    for remark in &remarks {
        reporter.remark(remark);
    }

    let mut notes = Notes::new(flags.strict);
    let job = Job::from_file(file, &of_reference(&field), &mut notes, reporter);
    reporter.notes(notes.take());
    let job = job?;
    let out = flags.out.clone().unwrap_or_else(|| base.join("compare"));
    let cache = trials::cache(&out);
    atomic::prepare_folder(&cache)?;
    let plan = Plan {
        measured: measured(&job.frames, compare)?,
        frames: job
            .frames
            .iter()
            .copied()
            .zip(job.identities()?.0)
            .collect(),
        seeds: compare.seeds,
        folder: cache.clone(),
    };
    let mut stage = Stage::open(job, flags.device, notes, reporter)?;
    for contestant in &contestants {
        stage.check(contestant)?;
    }
    let names: Vec<String> = contestants.iter().map(|c| c.name.clone()).collect();
    reporter.start_comparing(&names, plan.measured.len(), &out, &stage.device());

    let mut progress = Progress::new(reporter);
    let times = Times::measure(
        &contestants,
        &plan,
        compare,
        &field,
        &mut stage,
        &mut progress,
    )?;
    let contestants: Vec<Contestant> = contestants
        .iter()
        .zip(&times.fitted)
        .map(|(c, fitted)| field.with_count(c, fitted.count))
        .collect::<Result<_>>()?;

    let mut course = Course {
        plan: &plan,
        contestants: &contestants,
        times: &times,
        compare,
        stage,
        progress,
    };
    let (outcome, references, trials) = course.run(|stage, reference| About {
        shot: file.display().to_string(),
        command: command_line(),
        software: SOFTWARE.to_owned(),
        machine: machine(),
        device: stage.device(),
        size: stage.size().to_array(),
        filter: filter_name(field.filter).to_owned(),
        frames: plan.measured.clone(),
        seeds: (0..plan.seeds)
            .map(|k| plan.seed(&contestants[0], k))
            .collect(),
        reference,
        remarks: remarks.clone(),
    })?;

    let seen: Vec<&Reference> = references_of(&references, &plan.measured);
    let written = report::write(
        &out,
        &outcome,
        &contestants,
        &seen,
        &trials,
        &mut course.stage,
    )?;
    if compare.keep {
        keep(&out, &contestants, &references, &trials, &plan)?;
    }
    let summary = json!({
        "verdict": outcome.verdict, "reference_criterion": outcome.reference_criterion,
        "time_criterion": outcome.time_criterion, "out": shown(&out), "files": written.iter().map(|file| shown(file)).collect::<Vec<_>>(),
        "seconds": began.elapsed().as_secs_f64(),
    });
    let text = format!(
        "{}\n{}",
        report::text::table(&outcome),
        written[0].display()
    );
    reporter.finish(summary, &text);
    Ok(())
}

/// The filter of all: as the shot or a flag gives it, else rays through the pixel's centre, since light is what is compared.
fn common_filter(file: &Path, flags: &RenderFlags) -> Result<Filter> {
    let (mut shot, source) = parse::read::<Shot>(file, &setup::overrides(flags))?;
    footage::adopt_size(&mut shot, &source, file.parent().unwrap_or(Path::new("")))?;
    Ok(match source.gives("image.filter") {
        true => shot.image.filter,
        false => Filter::Centre,
    })
}

fn filter_name(filter: Filter) -> &'static str {
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
fn measured(frames: &[u32], compare: &CompareFlags) -> Result<Vec<u32>> {
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

fn references_of<'a>(references: &'a [Reference], frames: &[u32]) -> Vec<&'a Reference> {
    let wanted = |r: &&Reference| frames.contains(&r.frame);
    references.iter().filter(wanted).collect()
}

/// Counts and times of the contestants.
struct Times {
    fitted: Vec<Fitted>,
    phases: Vec<Vec<Phase>>,
    budget: Option<f64>,
    mode: Mode,
}

impl Times {
    /// Measures them, or takes those of a run before.
    fn measure(
        contestants: &[Contestant],
        plan: &Plan,
        compare: &CompareFlags,
        field: &Field<'_>,
        stage: &mut Stage<'_>,
        progress: &mut Progress<'_>,
    ) -> Result<Self> {
        let budget = match (compare.equal_samples, compare.equal_time) {
            (true, _) => Budget::Free,
            (false, Some(ms)) => Budget::Seconds(ms * 1e-3),
            (false, None) => Budget::First,
        };
        let mode = match budget {
            Budget::Free => Mode::EqualSamples,
            _ => Mode::EqualTime,
        };
        let shots = contestants.iter().map(|c| digest::hex(&c.digest()));
        let identities = plan.frames.iter().filter(|f| plan.measured.contains(&f.0));
        let identity = format!(
            "times 1 {budget:?} {} {} {:?} {:?}",
            compare.rounds,
            stage.device(),
            shots.collect::<Vec<_>>(),
            identities.collect::<Vec<_>>()
        );
        let identity = digest::hex(&digest::of_text(&identity));
        let file = plan.folder.join("times.json");
        type Kept = (String, Vec<Fitted>, Vec<Vec<Phase>>, Option<f64>);
        let kept = std::fs::read(&file).ok();
        let kept = kept.and_then(|bytes| serde_json::from_slice::<Kept>(&bytes).ok());
        if let Some((_, fitted, phases, budget)) = kept.filter(|k| k.0 == identity) {
            return Ok(Self {
                fitted,
                phases,
                budget,
                mode,
            });
        }
        let mut clock = StageClock {
            contestants,
            current: contestants.to_vec(),
            phases: vec![Vec::new(); contestants.len()],
            plan,
            field,
            stage,
            progress,
        };
        let count = |c: &Contestant| (!c.knob.is_fixed()).then(|| c.knob.count());
        let counts: Vec<Option<u32>> = contestants.iter().map(count).collect();
        let rounds = compare.rounds as usize;
        let (fitted, budget) = fit::fit(&mut clock, &counts, budget, rounds)?;
        let phases: Vec<Vec<Phase>> = clock.phases.iter().map(|p| phases(p, rounds)).collect();
        let kept = (&identity, &fitted, &phases, budget);
        write_text(&file, &serde_json::to_string(&kept).unwrap_or_default())?;
        Ok(Self {
            fitted,
            phases,
            budget,
            mode,
        })
    }
}

/// Phases of one frame: names and seconds.
type Phases = Vec<(&'static str, f64)>;

/// Quartiles of the phases of the last `rounds` frames.
fn phases(frames: &[Phases], rounds: usize) -> Vec<Phase> {
    let last = &frames[frames.len().saturating_sub(rounds)..];
    let Some(first) = last.first() else {
        return Vec::new();
    };
    let of = |i: usize| {
        let seconds: Vec<f64> = last.iter().filter_map(|f| Some(f.get(i)?.1)).collect();
        Phase {
            name: first[i].0.to_owned(),
            seconds: Quartiles::of(&seconds),
        }
    };
    (0..first.len()).map(of).collect()
}

/// Times contestants on the stage.
struct StageClock<'a, 'b, 'c> {
    contestants: &'a [Contestant],
    /// Those, with the counts that were timed last.
    current: Vec<Contestant>,
    phases: Vec<Vec<Phases>>,
    plan: &'a Plan,
    field: &'a Field<'a>,
    stage: &'a mut Stage<'b>,
    progress: &'a mut Progress<'c>,
}

impl Clock for StageClock<'_, '_, '_> {
    fn time(&mut self, who: usize, count: u32, round: usize) -> Result<f64> {
        let given = &self.contestants[who];
        if self.current[who].count() != count {
            self.current[who] = self.field.with_count(given, count)?;
        }
        let contestant = &self.current[who];
        let frame = self.plan.measured[round % self.plan.measured.len()];
        // A seed of no trial.
        let seed = self.plan.seed(contestant, 0).wrapping_add(3 << 30);
        if contestant.is_stateful()
            && let Some(before) = self.plan.before(frame)
        {
            // What is timed is a frame in the middle of a shot.
            self.stage.break_off()?;
            self.stage.render(&contestant.shot, before, seed)?;
        }
        let image = self.stage.render(&contestant.shot, frame, seed)?;
        self.phases[who].push(image.phases);
        self.progress
            .rendered("fitting counts to the time", image.seconds);
        Ok(image.seconds)
    }
}

/// References and trials, until the one is good enough for the other.
struct Course<'a, 'b> {
    plan: &'a Plan,
    contestants: &'a [Contestant],
    times: &'a Times,
    compare: &'a CompareFlags,
    stage: Stage<'b>,
    progress: Progress<'b>,
}

impl Course<'_, '_> {
    fn run(
        &mut self,
        about: impl Fn(&Stage<'_>, String) -> About,
    ) -> Result<(Outcome, Vec<Reference>, Vec<Vec<Trial>>)> {
        let needed = self.plan.needed();
        if let Some(folder) = &self.compare.reference {
            let references = reference::read(folder, &needed, self.stage.size())?;
            self.check_given(&references)?;
            let how = format!("given: {}", folder.display());
            let trials = self.trials(&references)?;
            let outcome = self.outcome(about(&self.stage, how), &references, &trials);
            return Ok((outcome, references, trials));
        }

        // The trial run, the least reference, the trials.
        let ahead = self.trial_seconds(None) * 1.2;
        self.progress.plan(ahead);
        let mut pilots = Vec::new();
        for contestant in self.contestants {
            let what = format!("trial run of {}", contestant.name);
            let progress = &mut self.progress;
            let told = &mut |seconds| progress.rendered(&what, seconds);
            pilots.push(trials::pilot(self.plan, contestant, &mut self.stage, told)?);
        }
        // The error of one without noise is its bias, which only the trials tell.
        let is_noisy = |error: &f64| *error > NOISELESS;
        let smallest = |i: usize| {
            let errors = pilots.iter().map(|p| p[i]);
            errors.filter(is_noisy).fold(f64::INFINITY, f64::min)
        };
        let mut targets: Vec<f64> = (0..self.plan.measured.len())
            .map(|i| smallest(i) * CRITERION * MARGIN)
            .collect();

        let frames: Vec<(u32, String)> = self
            .plan
            .frames
            .iter()
            .filter(|f| needed.contains(&f.0))
            .cloned()
            .collect();
        let shot = self.stage.job.setup.shot.clone();
        let mut growing = Growing::open(&shot, &self.plan.folder, &frames, self.stage.size());
        for attempt in 1.. {
            let of_needed: Vec<f64> = needed.iter().map(|f| self.target(*f, &targets)).collect();
            let left = self.trial_seconds(None);
            let progress = &mut self.progress;
            let told = &mut |seconds: f64, more: f64| {
                progress.plan(more + left + seconds);
                progress.rendered("reference", seconds);
            };
            let limit = self.compare.reference_time;
            let references = growing.grow(&mut self.stage, &of_needed, limit, told)?;
            let trials = self.trials(&references)?;
            let how = format!(
                "MIS, {} rays with 1 + 1 Owen-Sobol samples in each of its independent scramblings",
                reference::RAYS
            );
            let outcome = self.outcome(about(&self.stage, how), &references, &trials);
            let over = limit.is_some_and(|limit| growing.seconds >= limit);
            if outcome.reference_criterion == Some(true) || over || attempt == RETRIES {
                return Ok((outcome, references, trials));
            }
            for (i, target) in targets.iter_mut().enumerate() {
                let errors = outcome.contestants.iter().map(|c| c.frames[i].error.value);
                let smallest = errors.fold(f64::INFINITY, f64::min);
                *target = target.min(smallest * CRITERION * 0.95);
            }
        }
        unreachable!("the last attempt returns")
    }

    /// The target of a needed frame: that of the measured frame that it is, or comes before.
    fn target(&self, frame: u32, targets: &[f64]) -> f64 {
        let pairs = self.plan.measured.iter().zip(targets);
        let needs = pairs.filter(|(m, _)| **m == frame || self.plan.before(**m) == Some(frame));
        needs
            .map(|(_, target)| *target)
            .fold(f64::INFINITY, f64::min)
    }

    /// A given reference that shows more or less than the contestants do was made with other settings.
    fn check_given(&mut self, references: &[Reference]) -> Result<()> {
        let shot = self.contestants[0].shot.clone();
        for reference in references {
            let image = self.stage.render(&shot, reference.frame, 1)?;
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
        let trials = Trials::new(self.plan, references, &self.contestants[0], &mut self.stage)?;
        let left = self.trial_seconds(Some(&trials));
        self.progress.plan(left);
        let mut all = Vec::new();
        for contestant in self.contestants {
            let progress = &mut self.progress;
            let told = &mut |seconds| progress.rendered(&contestant.name, seconds);
            all.push(trials.run(contestant, &mut self.stage, told)?);
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
                let all = self.plan.sequence(c).len() * self.plan.seeds as usize;
                let frames = trials.map_or(all, |t| t.left(c, &self.stage));
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
        let seen = references_of(references, &self.plan.measured);
        Outcome::of(about, self.times.mode, self.times.budget, &seen, &measured)
    }
}

/// Writes means and references as EXR.
fn keep(
    out: &Path,
    contestants: &[Contestant],
    references: &[Reference],
    trials: &[Vec<Trial>],
    plan: &Plan,
) -> Result<()> {
    let write = |folder: PathBuf, frame: u32, moments: &moments::Moments| {
        atomic::prepare_folder(&folder)?;
        let stamp = Stamp {
            hash: String::new(),
            frame,
        };
        let file = folder.join(format!("frame.{frame:04}.exr"));
        exr::write(
            &file,
            moments.size,
            &moments.mean,
            exr::Layers::default(),
            &stamp,
        )
    };
    for reference in references {
        write(out.join("reference"), reference.frame, &reference.moments)?;
    }
    for (contestant, trials) in contestants.iter().zip(trials) {
        for (trial, &frame) in trials.iter().zip(&plan.measured) {
            write(
                out.join("mean").join(contestant.slug()),
                frame,
                &trial.moments,
            )?;
        }
    }
    Ok(())
}

/// The command line, quoted for a shell.
fn command_line() -> String {
    let quoted = |arg: String| {
        let plain = |c: char| c.is_ascii_alphanumeric() || "-_./=,:+@%".contains(c);
        match !arg.is_empty() && arg.chars().all(plain) {
            true => arg,
            false => format!("'{}'", arg.replace('\'', r"'\''")),
        }
    };
    let args = std::env::args().skip(1).map(quoted);
    std::iter::once("glimt".to_owned())
        .chain(args)
        .collect::<Vec<_>>()
        .join(" ")
}

/// The processor and the system.
fn machine() -> String {
    let info = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let model = info.lines().find_map(|l| {
        l.strip_prefix("model name")?
            .split_once(':')
            .map(|p| p.1.trim().to_owned())
    });
    let threads = std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
    format!(
        "{}, {threads} threads, {} {}",
        model.unwrap_or_else(|| "a processor".to_owned()),
        std::env::consts::OS,
        std::env::consts::ARCH
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frames_are_chosen() {
        let frames: Vec<u32> = (11..=106).collect();
        let of = |flags: &CompareFlags| measured(&frames, flags);
        let default = CompareFlags::default();
        assert_eq!(of(&default).unwrap(), [22, 34, 46, 58, 70, 82, 94, 106]);
        let stride = CompareFlags {
            stride: Some(40),
            ..CompareFlags::default()
        };
        assert_eq!(of(&stride).unwrap(), [11, 51, 91]);
        let named = |list: &[u32]| CompareFlags {
            measure: list.to_vec(),
            ..CompareFlags::default()
        };
        assert_eq!(of(&named(&[90, 15, 90])).unwrap(), [15, 90]);
        let error = of(&named(&[5])).unwrap_err().to_string();
        assert!(error.contains("frame 5 is not among 11-106"), "{error}");
    }
}
