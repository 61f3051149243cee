//! Host file: the counts that make contestants equally long, and how long their frames take.

use super::comparison::Comparison;
use super::contestants::Contestant;
use super::fit::{self, Budget, Clock, Fitted};
use super::outcome::{Mode, Phase};
use super::statistics::Quartiles;
use crate::error::Result;
use crate::output::{SOFTWARE, write_text};
use crate::shot::digest;

/// Counts and times of the contestants.
pub(super) struct Times {
    pub(super) fitted: Vec<Fitted>,
    pub(super) phases: Vec<Vec<Phase>>,
    pub(super) budget: Option<f64>,
    pub(super) mode: Mode,
}

impl Times {
    /// Measures them, or takes those of a run before.
    ///
    /// # Errors
    /// A frame cannot be rendered, or the times cannot be written.
    pub(super) fn measure(
        comparison: &mut Comparison<'_>,
        contestants: &[Contestant],
    ) -> Result<Self> {
        let (flags, plan) = (comparison.flags, &comparison.plan);
        let budget = match (flags.equal_samples, flags.equal_time) {
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
            flags.rounds,
            comparison.renderer.device(),
            shots.collect::<Vec<_>>(),
            identities.collect::<Vec<_>>()
        );
        let identity = format!("{SOFTWARE} {}", digest::hex(&digest::of_text(&identity)));
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
        let target = plan.guard.target(&file)?;
        let mut clock = FrameClock {
            contestants,
            current: contestants.to_vec(),
            phases: vec![Vec::new(); contestants.len()],
            comparison,
        };
        let count = |c: &Contestant| (!c.knob.is_fixed()).then(|| c.knob.count());
        let counts: Vec<Option<u32>> = contestants.iter().map(count).collect();
        let rounds = flags.rounds as usize;
        let (fitted, budget) = fit::fit(&mut clock, &counts, budget, rounds)?;
        let phases: Vec<Vec<Phase>> = clock.phases.iter().map(|p| phases(p, rounds)).collect();
        let kept = (&identity, &fitted, &phases, budget);
        write_text(&target, &serde_json::to_string(&kept).unwrap_or_default())?;
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

/// Times frames of contestants.
struct FrameClock<'a, 'b> {
    contestants: &'a [Contestant],
    /// Those, with the counts that were timed last.
    current: Vec<Contestant>,
    phases: Vec<Vec<Phases>>,
    comparison: &'a mut Comparison<'b>,
}

impl Clock for FrameClock<'_, '_> {
    fn time(&mut self, who: usize, count: u32, round: usize) -> Result<f64> {
        let given = &self.contestants[who];
        if self.current[who].count() != count {
            self.current[who] = self.comparison.field.with_count(given, count)?;
        }
        let contestant = &self.current[who];
        let Comparison {
            plan,
            renderer,
            progress,
            ..
        } = &mut *self.comparison;
        let frame = plan.measured[round % plan.measured.len()];
        // A seed of no trial.
        let seed = plan.seed(contestant, 0).wrapping_add(3 << 30);
        if contestant.is_stateful()
            && let Some(before) = plan.before(frame)
        {
            // What is timed is a frame in the middle of a shot.
            renderer.forget_past();
            renderer.render(&contestant.shot, before, seed)?;
        }
        let image = renderer.render(&contestant.shot, frame, seed)?;
        self.phases[who].push(image.phases);
        progress.rendered("fitting counts to the time", image.seconds);
        Ok(image.seconds)
    }
}
