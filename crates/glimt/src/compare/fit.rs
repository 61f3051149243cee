//! Host file: counts that make all contestants take the same time, found by measuring.
//!
//! Contestants are timed in interleaved rounds, each once a round, so that what slows the machine slows all of them alike.

use super::count::MOST;
use super::statistics::Quartiles;
use crate::error::Result;
use serde::{Deserialize, Serialize};

/// How far a median time may be from the budget, as a share of it.
pub const TOLERANCE: f64 = 0.05;

/// While searching, times are held to less, so that a later measurement of the same count is inside, too.
const CLOSER: f64 = 0.03;

/// Rounds of one step of the search.
const STEP_ROUNDS: usize = 3;

/// Steps of the search before it is given up.
const STEPS: usize = 24;

/// Something that times one frame of a contestant.
pub trait Clock {
    /// Seconds that contestant `who` took for one frame with `count` of what it counts; `round` says which frame of several to
    /// take.
    ///
    /// # Errors
    /// The frame cannot be rendered.
    fn time(&mut self, who: usize, count: u32, round: usize) -> Result<f64>;
}

/// What times are to be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Budget {
    /// Whatever the given counts take.
    Free,
    /// So many seconds.
    Seconds(f64),
    /// That of the first contestant with its given count, measured in the same rounds.
    First,
}

/// How a contestant's time compares with the budget.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Hold {
    /// There is none.
    Free,
    /// Within [`TOLERANCE`].
    Held,
    /// It is not, and the count is a whole number: one step less is too little, this or one step more is too much.
    Granular,
    /// It is not, and there is no count to change.
    Fixed,
    /// It is not.
    Missed,
}

/// A contestant's count and times.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Fitted {
    /// The count.
    pub count: u32,
    /// Seconds of a frame, of each round.
    pub times: Vec<f64>,
    /// Whether they are the budget.
    pub hold: Hold,
}

/// Finds the counts and times them in `rounds` rounds (at least 1); who has no count has the count 1.
///
/// # Errors
/// As the clock's.
pub fn fit(
    clock: &mut dyn Clock,
    counts: &[Option<u32>],
    budget: Budget,
    rounds: usize,
) -> Result<(Vec<Fitted>, Option<f64>)> {
    let mut searches: Vec<Search> = counts.iter().map(|&n| Search::new(n)).collect();
    // What is done once (shaders, memory) is not part of a frame.
    measure(clock, &searches, 1)?;
    let mut steps = STEPS;
    loop {
        let settled = searches
            .iter()
            .enumerate()
            .all(|(i, s)| s.settled || is_given(budget, i));
        let full = settled || budget == Budget::Free || steps == 0;
        let times = measure(
            clock,
            &searches,
            if full { rounds.max(1) } else { STEP_ROUNDS },
        )?;
        let medians: Vec<f64> = times.iter().map(|t| Quartiles::of(t).median).collect();
        let target = match budget {
            Budget::Free => None,
            Budget::Seconds(seconds) => Some(seconds),
            Budget::First => medians.first().copied(),
        };
        let holds = |tolerance: f64| -> Vec<bool> {
            let near = |m: &f64| target.is_none_or(|t| (m / t - 1.0).abs() <= tolerance);
            medians.iter().map(near).collect()
        };
        if full {
            let held = holds(TOLERANCE);
            // One more takes at most this much longer; where that is less than the tolerance is wide, some count fits, and only
            // noise hid it.
            for (i, search) in searches.iter_mut().enumerate() {
                let step = medians[i] / f64::from(search.count);
                search.granular &= target.is_some_and(|t| step > 2.0 * TOLERANCE * t)
                    || [1, MOST].contains(&search.count);
            }
            let over = |i: usize| searches[i].granular || searches[i].fixed;
            let done = |i: usize| held[i] || over(i) || is_given(budget, i);
            if steps == 0 || (0..held.len()).all(done) {
                let fitted = searches
                    .iter()
                    .zip(times)
                    .zip(held)
                    .map(|((search, times), held)| Fitted {
                        count: search.count,
                        times,
                        hold: match (target, held, search.granular) {
                            (None, ..) => Hold::Free,
                            (_, true, _) => Hold::Held,
                            _ if search.fixed => Hold::Fixed,
                            (_, _, true) => Hold::Granular,
                            _ => Hold::Missed,
                        },
                    });
                return Ok((fitted.collect(), target));
            }
        }
        steps = steps.saturating_sub(1);
        let held = holds(CLOSER);
        for (i, search) in searches.iter_mut().enumerate() {
            if !is_given(budget, i)
                && let Some(target) = target
            {
                search.settled = held[i] || search.fixed || search.step(medians[i], target, full);
            }
        }
    }
}

/// Whether the budget is this contestant's own time.
fn is_given(budget: Budget, who: usize) -> bool {
    budget == Budget::Free || (budget == Budget::First && who == 0)
}

fn measure(clock: &mut dyn Clock, searches: &[Search], rounds: usize) -> Result<Vec<Vec<f64>>> {
    let mut times = vec![Vec::with_capacity(rounds); searches.len()];
    for round in 0..rounds {
        for (who, (search, times)) in searches.iter().zip(&mut times).enumerate() {
            times.push(clock.time(who, search.count, round)?);
        }
    }
    Ok(times)
}

/// The search for one contestant's count.
struct Search {
    count: u32,
    /// There is no count to change.
    fixed: bool,
    /// Largest count that was too short, and its time; smallest that was too long.
    low: Option<(u32, f64)>,
    high: Option<(u32, f64)>,
    /// The count before, and its time.
    last: Option<(u32, f64)>,
    settled: bool,
    /// No whole number fits.
    granular: bool,
}

impl Search {
    fn new(count: Option<u32>) -> Self {
        Self {
            count: count.unwrap_or(1),
            fixed: count.is_none(),
            low: None,
            high: None,
            last: None,
            settled: false,
            granular: false,
        }
    }

    /// The count took `time`, which is not the target: chooses another. Whether there is none to choose.
    fn step(&mut self, time: f64, target: f64, afresh: bool) -> bool {
        if afresh {
            // What was measured before is not to be trusted.
            (self.low, self.high, self.last, self.granular) = (None, None, None, false);
        }
        let here = (self.count, time);
        match time < target {
            true => self.low = Some(here),
            false => self.high = Some(here),
        }
        if let (Some(low), Some(high)) = (self.low, self.high)
            && low.0 >= high.0
        {
            // Noise: the newer one holds.
            match time < target {
                true => self.high = None,
                false => self.low = None,
            }
        }
        let slope = match self.last {
            // A fixed part of the time does not grow with the count.
            Some((count, t))
                if count != here.0 && (time - t) * (f64::from(here.0) - f64::from(count)) > 0.0 =>
            {
                (time - t) / (f64::from(here.0) - f64::from(count))
            }
            _ => time / f64::from(here.0),
        };
        self.last = Some(here);
        let next = match (self.low, self.high) {
            (Some(low), Some(high)) => {
                if high.0 - low.0 == 1 {
                    let lower_is_nearer = target - low.1 <= high.1 - target;
                    self.count = if lower_is_nearer { low.0 } else { high.0 };
                    self.granular = true;
                    return true;
                }
                let share = (target - low.1) / (high.1 - low.1);
                let guess = f64::from(low.0) + share * f64::from(high.0 - low.0);
                guess
                    .round()
                    .clamp(f64::from(low.0 + 1), f64::from(high.0 - 1))
            }
            _ => {
                let now = f64::from(here.0);
                let guess = (now + (target - time) / slope)
                    .clamp(now / 8.0, now * 8.0)
                    .round();
                let moved = match time < target {
                    true => guess.max(now + 1.0),
                    false => guess.min(now - 1.0),
                };
                moved.clamp(1.0, f64::from(MOST))
            }
        } as u32;
        // There is nothing below 1, nor above the most.
        self.granular = next == self.count;
        self.count = next;
        self.granular
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A renderer on a synthetic clock: `fixed + each · count` seconds, times what the machine is slowed by, which changes from
    /// one frame to the next.
    struct Fake {
        fixed: Vec<f64>,
        each: Vec<f64>,
        noise: f64,
        /// Factor on all times after so many frames.
        slower: Option<(usize, f64)>,
        frames: usize,
        state: u32,
        log: Vec<usize>,
    }

    impl Fake {
        fn new(fixed: &[f64], each: &[f64], noise: f64) -> Self {
            Self {
                fixed: fixed.to_vec(),
                each: each.to_vec(),
                noise,
                slower: None,
                frames: 0,
                state: 1,
                log: Vec::new(),
            }
        }

        fn exact(&self, who: usize, count: u32) -> f64 {
            self.fixed[who] + self.each[who] * f64::from(count)
        }
    }

    impl Clock for Fake {
        fn time(&mut self, who: usize, count: u32, _round: usize) -> Result<f64> {
            self.state = self
                .state
                .wrapping_mul(1_664_525)
                .wrapping_add(1_013_904_223);
            let u = f64::from(self.state) / f64::from(u32::MAX) - 0.5;
            self.frames += 1;
            self.log.push(who);
            let slowed = match self.slower {
                Some((after, factor)) if self.frames > after => factor,
                _ => 1.0,
            };
            Ok(self.exact(who, count) * (1.0 + self.noise * u) * slowed)
        }
    }

    #[test]
    fn times_become_the_budget() {
        let mut fake = Fake::new(
            &[0.001, 0.0, 0.004, 0.02],
            &[0.001, 5e-5, 0.003, 1e-4],
            0.04,
        );
        let budget = Budget::Seconds(0.1);
        let (fitted, target) = fit(&mut fake, &[16, 15, 20, 8].map(Some), budget, 9).unwrap();
        assert_eq!(target, Some(0.1));
        for (who, fit) in fitted.iter().enumerate() {
            let time = fake.exact(who, fit.count);
            assert_eq!(fit.hold, Hold::Held, "{fit:?}");
            assert!((time / 0.1 - 1.0).abs() < 0.07, "{who}: {time}");
            assert_eq!(fit.times.len(), 9);
        }
        // Each contestant once a round.
        let last: Vec<usize> = fake.log[fake.log.len() - 8..].to_vec();
        assert_eq!(last, [0, 1, 2, 3, 0, 1, 2, 3]);
    }

    #[test]
    fn who_has_no_count_keeps_others_from_nothing() {
        let mut fake = Fake::new(&[0.01, 0.0], &[0.0, 0.001], 0.02);
        let (fitted, _) = fit(&mut fake, &[None, Some(3)], Budget::Seconds(0.1), 5).unwrap();
        assert_eq!((fitted[0].count, fitted[0].hold), (1, Hold::Fixed));
        assert_eq!(fitted[1].hold, Hold::Held);
        // In time by chance, or as the one whose time it is, it holds as others do.
        let (fitted, _) = fit(&mut fake, &[None, Some(3)], Budget::First, 5).unwrap();
        assert!(fitted.iter().all(|f| f.hold == Hold::Held), "{fitted:?}");
    }

    #[test]
    fn the_first_is_the_budget() {
        let mut fake = Fake::new(&[0.0, 0.01], &[0.002, 0.0005], 0.02);
        // Halfway through, the machine slows: both alike, so the ratio holds.
        fake.slower = Some((9, 1.7));
        let (fitted, _) = fit(&mut fake, &[30, 4].map(Some), Budget::First, 9).unwrap();
        assert_eq!(fitted[0].count, 30);
        let ratio = fake.exact(1, fitted[1].count) / fake.exact(0, 30);
        assert!((ratio - 1.0).abs() < 0.06, "{ratio}");
    }

    #[test]
    fn a_coarse_count_is_said() {
        // 1 takes 60 ms, 2 take 120: neither is 100. The other cannot be below 300.
        let mut fake = Fake::new(&[0.0, 0.2], &[0.06, 0.1], 0.0);
        let (fitted, _) = fit(&mut fake, &[7, 3].map(Some), Budget::Seconds(0.1), 5).unwrap();
        assert_eq!((fitted[0].count, fitted[0].hold), (2, Hold::Granular));
        assert_eq!((fitted[1].count, fitted[1].hold), (1, Hold::Granular));
    }

    /// Noise may make neighbours look too short and too long; where the steps are fine, that is not an excuse.
    #[test]
    fn noise_is_no_coarse_count() {
        let mut fake = Fake::new(&[0.0], &[0.006], 0.3);
        let (fitted, _) = fit(&mut fake, &[40].map(Some), Budget::Seconds(0.1), 15).unwrap();
        assert_eq!(fitted[0].hold, Hold::Held, "{fitted:?}");
    }

    #[test]
    fn a_wild_clock_misses() {
        let mut fake = Fake::new(&[0.0], &[0.001], 1.9);
        fake.slower = None;
        let (fitted, _) = fit(&mut fake, &[50].map(Some), Budget::Seconds(0.1), 1).unwrap();
        let held = (fitted[0].times[0] / 0.1 - 1.0).abs() <= TOLERANCE;
        assert_eq!(held, fitted[0].hold == Hold::Held, "{fitted:?}");
    }

    #[test]
    fn given_counts_stay() {
        let mut fake = Fake::new(&[0.0, 0.0], &[0.001, 0.01], 0.1);
        let (fitted, target) = fit(&mut fake, &[3, 4].map(Some), Budget::Free, 4).unwrap();
        assert_eq!(target, None);
        assert!(
            fitted
                .iter()
                .all(|f| f.hold == Hold::Free && f.times.len() == 4)
        );
        assert_eq!((fitted[0].count, fitted[1].count), (3, 4));
    }
}
