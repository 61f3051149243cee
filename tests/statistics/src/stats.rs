//! Host file: statistical tests whose verdict is a value, so that a self-check can show each of them failing.
//!
//! Every test compares one statistic with one limit and fails unless `statistic <= limit`; NaN therefore fails. Seeds
//! are fixed and nothing is retried, so a verdict is the same on every run; when many are asked for, correct their
//! level by [`sidak`].

use std::f64::consts::TAU;
use std::fmt;

use statrs::distribution::{ChiSquared, ContinuousCDF, Normal};

use crate::quadrature::{self, Direction};

/// What a test saw.
#[derive(Clone, Debug)]
pub struct Evidence {
    /// Name of the test.
    pub test: &'static str,
    /// The statistic that was judged.
    pub statistic: f64,
    /// The largest value that passes.
    pub limit: f64,
    /// The circumstances in words: counts, degrees of freedom, the worst cell.
    pub detail: String,
}

impl fmt::Display for Evidence {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (test, statistic, limit, detail) =
            (self.test, self.statistic, self.limit, &self.detail);
        write!(
            f,
            "{test}: statistic {statistic:.6e}, limit {limit:.6e} ({detail})"
        )
    }
}

/// `Ok` where the test passed, `Err` where it did not; the evidence either way.
pub type Verdict = Result<Evidence, Evidence>;

/// The one place where a statistic meets its limit.
fn judge(test: &'static str, statistic: f64, limit: f64, detail: String) -> Verdict {
    let evidence = Evidence {
        test,
        statistic,
        limit,
        detail,
    };
    if statistic <= limit {
        Ok(evidence)
    } else {
        Err(evidence)
    }
}

/// Level of each of `tests` independent tests so that all pass with probability `1 − alpha` (Šidák 1967).
#[must_use]
pub fn sidak(alpha: f64, tests: usize) -> f64 {
    -f64::exp_m1(f64::ln_1p(-alpha) / tests.max(1) as f64)
}

/// The `x ≥ 0` at which a falling tail probability reaches `alpha`.
fn critical_value(tail: impl Fn(f64) -> f64, alpha: f64) -> f64 {
    let mut high = 1.0;
    while tail(high) > alpha && high < 1e12 {
        high *= 2.0;
    }
    let mut low = 0.0;
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if tail(middle) > alpha {
            low = middle;
        } else {
            high = middle;
        }
    }
    high
}

/// Pearson's χ² of counts against expected counts, with cells pooled (smallest first) until each expects at least 5.
///
/// `expected` must sum to the number of samples, to one part in a thousand: a density that does not integrate to 1
/// fails here whatever its shape. A sample in a cell that expects none fails too. One cell alone passes if it holds all.
///
/// # Errors
/// The evidence of a failed test, also for empty input, differing lengths, or values that are no counts.
pub fn chi_square(observed: &[u64], expected: &[f64], alpha: f64) -> Verdict {
    const TEST: &str = "chi-square";
    let n: u64 = observed.iter().sum();
    let fail = |detail: String| judge(TEST, f64::INFINITY, 0.0, detail);
    if observed.len() != expected.len() || n == 0 || expected.iter().any(|e| !(*e >= 0.0)) {
        return fail(format!(
            "{} cells, {} expectations, {n} samples",
            observed.len(),
            expected.len()
        ));
    }
    let total: f64 = expected.iter().sum();
    if !((total - n as f64).abs() <= 1e-3 * n as f64) {
        return fail(format!("{total:.3} samples expected in all, {n} seen"));
    }
    let mut cells: Vec<(f64, u64)> = expected
        .iter()
        .copied()
        .zip(observed.iter().copied())
        .collect();
    if let Some((e, o)) = cells.iter().find(|(e, o)| *e == 0.0 && *o > 0) {
        return fail(format!("{o} samples in a cell that expects {e}"));
    }
    cells.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut pooled: Vec<(f64, f64)> = Vec::new();
    let (mut pool_expected, mut pool_observed) = (0.0, 0.0);
    for (e, o) in cells {
        pool_expected += e;
        pool_observed += o as f64;
        if pool_expected >= 5.0 {
            pooled.push((pool_expected, pool_observed));
            (pool_expected, pool_observed) = (0.0, 0.0);
        }
    }
    match pooled.last_mut() {
        Some(last) => *last = (last.0 + pool_expected, last.1 + pool_observed),
        None => return fail(format!("{n} samples are too few for any cell")),
    }
    let statistic = pooled.iter().map(|(e, o)| (o - e).powi(2) / e).sum();
    let freedom = pooled.len() - 1;
    let detail = format!(
        "{n} samples, {} cells pooled to {}",
        expected.len(),
        pooled.len()
    );
    let Ok(distribution) = ChiSquared::new(freedom as f64) else {
        // No freedom: all samples lie in the one cell, and the statistic holds but the rounding of its expectation.
        return judge(TEST, statistic, 1e-3 * n as f64, detail);
    };
    judge(
        TEST,
        statistic,
        critical_value(|x| distribution.sf(x), alpha),
        detail,
    )
}

/// Kolmogorov and Smirnov's test of samples against a distribution function. Sorts `samples`.
///
/// The statistic is `(√n + 0.12 + 0.11/√n) D` (Stephens 1970), its limit that of Kolmogorov's distribution.
///
/// # Errors
/// The evidence of a failed test, also for fewer than 8 samples.
pub fn kolmogorov_smirnov(samples: &mut [f64], cdf: impl Fn(f64) -> f64, alpha: f64) -> Verdict {
    const TEST: &str = "Kolmogorov-Smirnov";
    let n = samples.len() as f64;
    if samples.len() < 8 {
        return judge(TEST, f64::INFINITY, 0.0, format!("{n} samples are too few"));
    }
    samples.sort_by(f64::total_cmp);
    let mut distance = 0.0f64;
    for (i, x) in samples.iter().enumerate() {
        let f = cdf(*x);
        let step = (f - i as f64 / n).abs().max((f - (i + 1) as f64 / n).abs());
        // `max` would drop a NaN.
        distance = if step <= distance { distance } else { step };
        if distance.is_nan() {
            break;
        }
    }
    let tail = |x: f64| {
        let term =
            |k: i32| f64::from(1 - 2 * ((k + 1) % 2)) * (-2.0 * f64::from(k * k) * x * x).exp();
        (2.0 * (1..=100).map(term).sum::<f64>()).clamp(0.0, 1.0)
    };
    // Below 0.2 the series converges slowly and the tail is 1 to all digits.
    let limit = critical_value(|x| if x < 0.2 { 1.0 } else { tail(x) }, alpha);
    let statistic = (n.sqrt() + 0.12 + 0.11 / n.sqrt()) * distance;
    judge(
        TEST,
        statistic,
        limit,
        format!("{n} samples, D = {distance:.3e}"),
    )
}

/// A mean with its standard error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mean {
    /// Arithmetic mean.
    pub mean: f64,
    /// Standard deviation of the mean: that of the values over √n.
    pub standard_error: f64,
    /// How many *independent* values it is of.
    pub n: usize,
}

impl Mean {
    /// Mean of independent values. Points of one low-discrepancy pattern are not: pass one mean per scrambling.
    #[must_use]
    pub fn of(values: impl IntoIterator<Item = f64>) -> Mean {
        let (mut n, mut mean, mut squares) = (0usize, 0.0, 0.0);
        for value in values {
            n += 1;
            let delta = value - mean;
            mean += delta / n as f64;
            squares += delta * (value - mean);
        }
        let variance = if n > 1 {
            squares / (n - 1) as f64
        } else {
            f64::NAN
        };
        Mean {
            mean,
            standard_error: (variance / n as f64).sqrt(),
            n,
        }
    }
}

/// Two-sided z-test of a mean against a value. The statistic is the distance in standard errors.
///
/// A standard error of zero passes only where the mean is the value to twelve digits.
///
/// # Errors
/// The evidence of a failed test, also for fewer than 16 values, whose spread is too uncertain for a z-test.
pub fn z_test(mean: Mean, value: f64, alpha: f64) -> Verdict {
    const TEST: &str = "z-test";
    let Mean {
        mean: m,
        standard_error: e,
        n,
    } = mean;
    let detail = format!("mean {m:.6e} ± {e:.1e} of {n} against {value:.6e}");
    if n < 16 {
        return judge(TEST, f64::INFINITY, 0.0, detail);
    }
    let normal = Normal::standard();
    let limit = critical_value(|z| 2.0 * normal.sf(z), alpha);
    let distance = (m - value).abs();
    let same = distance <= 1e-12 * value.abs() && e == 0.0;
    judge(TEST, if same { 0.0 } else { distance / e }, limit, detail)
}

/// Whether `value` is within `tolerance` of `truth`, absolutely.
///
/// # Errors
/// The evidence where it is not, or where anything is NaN.
pub fn within(value: f64, truth: f64, tolerance: f64) -> Verdict {
    judge(
        "within",
        (value - truth).abs(),
        tolerance,
        format!("{value:.9e} against {truth:.9e}"),
    )
}

/// Bins of equal solid angle over the sphere: `rows` in cos θ from +z down, `columns` in azimuth from −π.
#[derive(Clone, Copy, Debug)]
pub struct SphereBins {
    /// Bands of equal height.
    pub rows: usize,
    /// Sectors of each band.
    pub columns: usize,
}

impl SphereBins {
    /// Index of the bin that holds the unit vector `d`. The edge between two bands belongs to the upper one, so that a
    /// hemisphere holds its horizon.
    #[must_use]
    pub fn index(&self, d: Direction) -> usize {
        let bands_above = (1.0 - d[2]) * 0.5 * self.rows as f64;
        let row = (bands_above.ceil() as usize).saturating_sub(1);
        let column = ((d[1].atan2(d[0]) / TAU + 0.5) * self.columns as f64) as usize;
        row.min(self.rows - 1) * self.columns + column.min(self.columns - 1)
    }

    /// Integral of a density over every bin.
    #[must_use]
    pub fn masses(&self, pdf_sr: impl Fn(Direction) -> f64) -> Vec<f64> {
        let mut masses = Vec::with_capacity(self.rows * self.columns);
        let edge = |i: usize, n: usize| i as f64 / n as f64;
        for row in 0..self.rows {
            let z = [
                1.0 - 2.0 * edge(row + 1, self.rows),
                1.0 - 2.0 * edge(row, self.rows),
            ];
            for column in 0..self.columns {
                let phi = [
                    TAU * (edge(column, self.columns) - 0.5),
                    TAU * (edge(column + 1, self.columns) - 0.5),
                ];
                masses.push(quadrature::integrate_patch(&pdf_sr, z, phi, 1e-7).value);
            }
        }
        masses
    }

    /// χ² of sampled directions against a density over the sphere; `None` is an impossible sample, of which as many are
    /// expected as the density's integral falls short of 1. Discontinuities of the density should lie on bin edges, or
    /// the quadrature over a bin is slow.
    ///
    /// # Errors
    /// The evidence of a failed test.
    pub fn chi_square(
        &self,
        samples: impl IntoIterator<Item = Option<Direction>>,
        pdf_sr: impl Fn(Direction) -> f64,
        alpha: f64,
    ) -> Verdict {
        let mut expected = self.masses(pdf_sr);
        let missing = 1.0 - expected.iter().sum::<f64>();
        let mut observed = vec![0u64; expected.len() + 1];
        for sample in samples {
            if let Some(d) = sample
                && !((d.iter().map(|x| x * x).sum::<f64>() - 1.0).abs() <= 1e-3)
            {
                return judge(
                    "chi-square",
                    f64::INFINITY,
                    0.0,
                    format!("{d:?} is no unit vector"),
                );
            }
            observed[sample.map_or(expected.len(), |d| self.index(d))] += 1;
        }
        // Below this the integral is 1 to the quadrature's precision, and no sample may be impossible.
        expected.push(if missing.abs() <= 1e-5 {
            0.0
        } else {
            missing.max(0.0)
        });
        let n: u64 = observed.iter().sum();
        expected.iter_mut().for_each(|mass| *mass *= n as f64);
        chi_square(&observed, &expected, alpha)
    }
}
