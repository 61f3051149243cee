//! Host file: measuring by interleaved rounds, and what the benchmarks share.
//!
//! A claim is a ratio of two times. Clocks drift, caches fill and other programs come and go, so the contestants take
//! turns: every round runs each of them once, in an order that rotates, and the ratio is taken within the round. Reported
//! are medians over rounds, with the quartiles of the ratio.

use std::hint::black_box;
use std::time::{Duration, Instant};

pub mod convergence;
pub mod inputs;
pub mod scene;

/// Contestants that are measured against each other.
pub struct Contest<'a> {
    title: String,
    unit: &'static str,
    work_per_run: f64,
    entries: Vec<Entry<'a>>,
}

struct Entry<'a> {
    name: String,
    run: Box<dyn FnMut() + 'a>,
    seconds: Vec<f64>,
}

/// What was measured of one contestant.
#[derive(Clone, Debug)]
pub struct Score {
    /// Name of the contestant.
    pub name: String,
    /// Median time of a run.
    pub median: Duration,
    /// Median over rounds of this contestant's time over the first one's in the same round.
    pub ratio: f64,
    /// Quartiles of that ratio.
    pub quartiles: [f64; 2],
}

impl<'a> Contest<'a> {
    /// A contest whose runs each do `work_per_run` units of work (`unit`, such as `"ray"`).
    pub fn new(title: &str, unit: &'static str, work_per_run: f64) -> Self {
        Self {
            title: title.to_owned(),
            unit,
            work_per_run,
            entries: Vec::new(),
        }
    }

    /// Adds a contestant; ratios are to the first. What `run` returns is kept from the optimiser.
    #[must_use]
    pub fn entry<T>(mut self, name: &str, mut run: impl FnMut() -> T + 'a) -> Self {
        self.entries.push(Entry {
            name: name.to_owned(),
            run: Box::new(move || {
                black_box(run());
            }),
            seconds: Vec::new(),
        });
        self
    }

    /// Runs everyone once to warm up, then `rounds` rounds, and prints a table.
    pub fn run(mut self, rounds: usize) -> Vec<Score> {
        let count = self.entries.len();
        for round in 0..=rounds {
            for turn in 0..count {
                let entry = &mut self.entries[(turn + round) % count];
                let start = Instant::now();
                (entry.run)();
                let seconds = start.elapsed().as_secs_f64();
                if round > 0 {
                    entry.seconds.push(seconds);
                }
            }
        }
        let scores = self.scores();
        self.print(&scores, rounds);
        scores
    }

    fn scores(&self) -> Vec<Score> {
        let first = &self.entries[0].seconds;
        let scores = self.entries.iter().map(|entry| {
            let pairs = entry.seconds.iter().zip(first);
            let mut ratios: Vec<f64> = pairs.map(|(own, first)| own / first).collect();
            let mut seconds = entry.seconds.clone();
            Score {
                name: entry.name.clone(),
                median: Duration::from_secs_f64(quantile(&mut seconds, 0.5)),
                ratio: quantile(&mut ratios, 0.5),
                quartiles: [quantile(&mut ratios, 0.25), quantile(&mut ratios, 0.75)],
            }
        });
        scores.collect()
    }

    fn print(&self, scores: &[Score], rounds: usize) {
        println!("\n{} ({rounds} rounds)", self.title);
        let rate_title = format!("M{}/s", self.unit);
        let unit_title = format!("ns/{}", self.unit);
        println!(
            "  {:<34} {:>11} {:>11} {:>11} {:>8}  quartiles",
            "", "median", unit_title, rate_title, "ratio"
        );
        for score in scores {
            let seconds = score.median.as_secs_f64();
            println!(
                "  {:<34} {:>8.3} ms {:>11.2} {:>11.2} {:>8.3}  {:.3}–{:.3}",
                score.name,
                1e3 * seconds,
                1e9 * seconds / self.work_per_run,
                1e-6 * self.work_per_run / seconds,
                score.ratio,
                score.quartiles[0],
                score.quartiles[1],
            );
        }
    }
}

/// The value below which a share `p` of the values lies, interpolated between neighbours.
fn quantile(values: &mut [f64], p: f64) -> f64 {
    values.sort_by(f64::total_cmp);
    let place = p * (values.len() - 1) as f64;
    let below = place.floor() as usize;
    let above = place.ceil() as usize;
    values[below] + (values[above] - values[below]) * (place - below as f64)
}

/// Prints whether a claim of the form `value ≤ bound` or `value ≥ bound` holds.
pub fn claim(text: &str, holds: bool) {
    println!("  {}: {text}", if holds { "holds" } else { "MISSED" });
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_of_known_values() {
        let mut values = [3.0, 1.0, 2.0, 5.0, 4.0];
        assert_eq!(quantile(&mut values, 0.5), 3.0);
        assert_eq!(quantile(&mut values, 0.25), 2.0);
        assert_eq!(quantile(&mut [1.0, 2.0], 0.5), 1.5);
    }

    #[test]
    fn a_slower_contestant_scores_worse() {
        let wait = |ms| move || std::thread::sleep(Duration::from_millis(ms));
        let scores = Contest::new("sleep", "nap", 1.0)
            .entry("short", wait(2))
            .entry("long", wait(8))
            .run(3);
        assert_eq!(scores[0].ratio, 1.0);
        assert!(scores[1].ratio > 2.0, "{scores:?}");
    }
}
