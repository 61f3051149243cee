//! Shared file: sampling-importance-resampling (Rubin 1987; for rendering Talbot 2005) without storage.
//!
//! M candidates ω_j ~ q with weights `w_j = γ(ω_j)/q(ω_j)` stand for the unnormalised target γ: N of them, resampled in
//! proportion to w_j, are nearly distributed as γ, and `Ẑ = (1/M) Σ w_j` is an unbiased estimate of `∫ γ`. Together,
//! `Ẑ (1/N) Σ_i f(ω_i)/γ(ω_i)` is an unbiased estimate of `∫ f` for any M, N ≥ 1, wherever γ > 0 where f ≠ 0 and q > 0
//! where γ > 0 (Kronander 2014, Eqs. 3 and 4).
//!
//! No weights are stored: pass 1 draws the candidates and sums their weights, pass 2 draws *the same candidates again* and
//! picks by systematic resampling.
//!
//! Differs from the paper, whose print omits 1/N, and the division by q in Ẑ.
//!
//! ```
//! use glimt_sampling::ris::{RisPicks, RisSum};
//! use glimt_sampling::{UniformSource, Xoshiro128PlusPlus, unit_f32};
//!
//! // ∫ x³ over [0, 1], with γ = x² and uniform candidates. Picks are shared out among 1000 repetitions.
//! let (candidates, samples) = (16, 2);
//! let mut sum = 0.0;
//! for repetition in 0..1000 {
//!     let stream = || Xoshiro128PlusPlus::stream(1, 0, repetition);
//!     let mut weights = RisSum::new();
//!     let mut source = stream();
//!     for _ in 0..candidates {
//!         let x = unit_f32(source.next_u32());
//!         weights.add(x * x);
//!     }
//!     let mut picks = RisPicks::new(&weights, samples, source.next_u32());
//!     let mut replay = stream();
//!     for _ in 0..candidates {
//!         let x = unit_f32(replay.next_u32());
//!         let copies = picks.take(x * x) as f32;
//!         sum += weights.normaliser() * copies / samples as f32 * x;
//!     }
//! }
//! assert!((sum / 1000.0 - 0.25).abs() < 0.01);
//! ```

use crate::resample::{Comb, Scheme};
use crate::uniform::UniformSource;

/// Pass 1: the sum of the candidates' weights.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RisSum {
    sum: f32,
    candidates: u32,
    /// One more than the index of the last candidate of positive weight.
    end: u32,
}

impl Default for RisSum {
    fn default() -> Self {
        Self::new()
    }
}

impl RisSum {
    /// No candidates.
    #[inline]
    #[must_use]
    pub fn new() -> RisSum {
        RisSum {
            sum: 0.0,
            candidates: 0,
            end: 0,
        }
    }

    /// Adds a candidate of weight `γ/q ≥ 0`. An impossible one has weight 0 and counts in M.
    #[inline]
    pub fn add(&mut self, weight: f32) {
        self.candidates += 1;
        if weight > 0.0 {
            self.sum += weight;
            self.end = self.candidates;
        }
    }

    /// `Ẑ = (1/M) Σ w_j`; 0 without candidates.
    #[inline]
    #[must_use]
    pub fn normaliser(&self) -> f32 {
        if self.candidates > 0 {
            self.sum / self.candidates as f32
        } else {
            0.0
        }
    }
}

/// Pass 2: how often each candidate is picked. The candidates come in the order of pass 1, with the same weights (up to
/// rounding, which another processor may do otherwise in another loop).
#[derive(Clone, Copy, Debug)]
pub struct RisPicks {
    comb: Comb,
    /// Expected picks for one unit of weight.
    scale: f32,
    left: u32,
    candidate: u32,
    end: u32,
}

/// A word that is there already.
struct Word(u32);

impl UniformSource for Word {
    #[inline]
    fn next_u32(&mut self) -> u32 {
        self.0
    }
}

impl RisPicks {
    /// N = `samples` picks, systematic from the uniform word `u`. None at all where no candidate has a positive weight.
    #[inline]
    #[must_use]
    pub fn new(weights: &RisSum, samples: u32, u: u32) -> RisPicks {
        let possible = weights.sum > 0.0;
        RisPicks {
            comb: Comb::new(Scheme::Systematic, samples, 0, &mut Word(u)),
            scale: if possible {
                samples as f32 / weights.sum
            } else {
                0.0
            },
            left: if possible { samples } else { 0 },
            candidate: 0,
            end: weights.end,
        }
    }

    /// How often the next candidate, of this weight, is picked. The last of positive weight gets what rounding has left.
    #[inline]
    #[must_use]
    pub fn take(&mut self, weight: f32) -> u32 {
        self.candidate += 1;
        if !(weight > 0.0) || self.left == 0 {
            return 0;
        }
        let picks = if self.candidate == self.end {
            self.left
        } else {
            self.comb
                .take(weight * self.scale, &mut Word(0))
                .min(self.left)
        };
        self.left -= picks;
        picks
    }

    /// Whether all picks are made: no later candidate needs to be drawn.
    #[inline]
    #[must_use]
    pub fn is_done(&self) -> bool {
        self.left == 0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_picks_are_made_and_none_on_weight_zero() {
        let weights = [0.0, 0.1, 0.0, 0.3, 1e-30, 0.6, 0.0];
        for samples in [1, 2, 7, 400] {
            for u in [0, 1, u32::MAX / 3, u32::MAX - 1, u32::MAX] {
                let mut sum = RisSum::new();
                for w in weights {
                    sum.add(w);
                }
                let mut picks = RisPicks::new(&sum, samples, u);
                let copies = weights.map(|w| picks.take(w));
                assert_eq!(copies.iter().sum::<u32>(), samples);
                assert!(picks.is_done());
                for (w, c) in weights.iter().zip(copies) {
                    assert!(*w > 0.0 || c == 0);
                }
            }
        }
    }

    #[test]
    fn without_a_possible_candidate_nothing_is_picked() {
        let mut sum = RisSum::new();
        assert_eq!(sum.normaliser(), 0.0);
        sum.add(0.0);
        assert_eq!(sum.normaliser(), 0.0);
        let mut picks = RisPicks::new(&sum, 3, 9);
        assert!(picks.is_done());
        assert_eq!(picks.take(0.0), 0);
    }
}
