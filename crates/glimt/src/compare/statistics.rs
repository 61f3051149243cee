//! Host file: means with standard errors, medians, and the tails by which a difference is distinguished from noise.

use serde::{Deserialize, Serialize};
use std::f64::consts::SQRT_2;

/// A figure with its spread.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Estimate {
    /// The figure.
    pub value: f64,
    /// Its standard error; `None` where there was but one value.
    pub error: Option<f64>,
}

impl Estimate {
    /// Mean of independent values with its standard error, their standard deviation over √n. NaN of none.
    #[must_use]
    pub fn mean(values: &[f64]) -> Self {
        let n = values.len() as f64;
        let mean = values.iter().sum::<f64>() / n;
        let squares: f64 = values.iter().map(|v| (v - mean).powi(2)).sum();
        Self {
            value: mean,
            error: (values.len() > 1).then(|| (squares / (n - 1.0) / n).sqrt()),
        }
    }

    /// Root of the mean of squares, of independent squares at least 0. The error is that of the mean, by the slope of the root
    /// (delta method).
    #[must_use]
    pub fn root_mean(squares: &[f64]) -> Self {
        let mean = Self::mean(squares);
        let value = mean.value.sqrt();
        let slope = if value > 0.0 { 0.5 / value } else { 0.0 };
        Self {
            value,
            error: mean.error.map(|e| e * slope),
        }
    }

    /// The error as a share of the value; 0 where it is not known.
    #[must_use]
    pub fn relative(self) -> f64 {
        match self.error {
            Some(error) if self.value != 0.0 => error / self.value.abs(),
            _ => 0.0,
        }
    }
}

/// Median and quartiles.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Quartiles {
    /// A quarter of the values is below.
    pub lower: f64,
    /// Half of the values is below.
    pub median: f64,
    /// Three quarters of the values are below.
    pub upper: f64,
}

impl Quartiles {
    /// Of any number of values, between neighbours linearly; NaN of none.
    #[must_use]
    pub fn of(values: &[f64]) -> Self {
        let mut sorted = values.to_vec();
        sorted.sort_by(f64::total_cmp);
        let at = |share: f64| -> f64 {
            let Some(last) = sorted.len().checked_sub(1) else {
                return f64::NAN;
            };
            let place = share * last as f64;
            let (below, above) = (place.floor() as usize, place.ceil() as usize);
            sorted[below] + (sorted[above] - sorted[below]) * place.fract()
        };
        Self {
            lower: at(0.25),
            median: at(0.5),
            upper: at(0.75),
        }
    }

    /// Standard error of the median of `n` values, as if they were normal: 1.253 σ / √n, with σ from the quartiles.
    #[must_use]
    pub fn median_error(self, n: usize) -> f64 {
        let sigma = (self.upper - self.lower) / 1.349;
        1.253 * sigma / (n as f64).sqrt()
    }
}

/// Probability that a standard normal variable is at least `|z|` away from 0. NaN stays NaN.
#[must_use]
pub fn normal_two_sided(z: f64) -> f64 {
    libm::erfc(z.abs() / SQRT_2)
}

/// Probability that Student's t with `freedom` degrees is at least `|t|` away from 0.
#[must_use]
pub fn student_two_sided(t: f64, freedom: f64) -> f64 {
    if t.is_nan() || !(freedom > 0.0) {
        return f64::NAN;
    }
    if t.is_infinite() {
        return 0.0;
    }
    incomplete_beta(freedom / (freedom + t * t), 0.5 * freedom, 0.5)
}

/// Probability that the least of `n` independent p-values is `p` or less (Šidák 1967).
#[must_use]
pub fn sidak(p: f64, n: usize) -> f64 {
    -f64::exp_m1(n as f64 * f64::ln_1p(-p))
}

/// Regularised incomplete beta function `I_x(a, b)` by its continued fraction (Lentz's method; DiDonato and Morris 1992).
fn incomplete_beta(x: f64, a: f64, b: f64) -> f64 {
    if x <= 0.0 {
        return 0.0;
    }
    if x >= 1.0 {
        return 1.0;
    }
    // The fraction converges fast on this side of the mean.
    if x > (a + 1.0) / (a + b + 2.0) {
        return 1.0 - incomplete_beta(1.0 - x, b, a);
    }
    let front =
        libm::lgamma(a + b) - libm::lgamma(a) - libm::lgamma(b) + a * x.ln() + b * f64::ln_1p(-x);
    let away_from_zero = |v: f64| if v.abs() < 1e-300 { 1e-300 } else { v };
    let mut c = 1.0;
    let mut d = 1.0 / away_from_zero(1.0 - (a + b) * x / (a + 1.0));
    let mut fraction = d;
    for m in 1..500 {
        let m = f64::from(m);
        let even = m * (b - m) * x / ((a + 2.0 * m - 1.0) * (a + 2.0 * m));
        let odd = -(a + m) * (a + b + m) * x / ((a + 2.0 * m) * (a + 2.0 * m + 1.0));
        let mut change = 1.0;
        for term in [even, odd] {
            d = 1.0 / away_from_zero(1.0 + term * d);
            c = away_from_zero(1.0 + term / c);
            change = d * c;
            fraction *= change;
        }
        if (change - 1.0).abs() < 1e-14 {
            break;
        }
    }
    front.exp() / a * fraction
}

/// Share of a normal variable's mass beyond `z`, for the text of a report: 0.01 at 2.576.
pub const ONE_PERCENT: f64 = 2.575_829_303_548_901;

#[cfg(test)]
mod tests {
    use super::*;

    fn near(a: f64, b: f64, tolerance: f64) -> bool {
        (a - b).abs() <= tolerance
    }

    /// Against printed tables of quantiles.
    #[test]
    fn tails() {
        for (z, p) in [
            (1.959_963_985, 0.05),
            (ONE_PERCENT, 0.01),
            (3.290_526_731, 0.001),
        ] {
            assert!(near(normal_two_sided(z), p, 1e-9), "{z}");
            assert!(near(normal_two_sided(-z), p, 1e-9), "{z}");
        }
        // t, degrees of freedom, two-sided probability.
        for (t, freedom, p) in [
            (12.706_204_7, 1.0, 0.05),
            (2.131_449_5, 15.0, 0.05),
            (2.946_712_9, 15.0, 0.01),
            (4.072_765_2, 15.0, 0.001),
            (1.971_956_5, 199.0, 0.05),
            (0.0, 7.0, 1.0),
        ] {
            assert!(
                near(student_two_sided(t, freedom), p, 1e-7),
                "{t} {freedom}"
            );
        }
        assert!(student_two_sided(f64::NAN, 15.0).is_nan());
        // With many degrees of freedom it is the normal distribution.
        assert!(near(
            student_two_sided(2.0, 1e6),
            normal_two_sided(2.0),
            1e-6
        ));
    }

    #[test]
    fn means_and_medians() {
        let m = Estimate::mean(&[1.0, 2.0, 3.0, 4.0]);
        assert_eq!(m.value, 2.5);
        assert!(near(m.error.unwrap(), (5.0f64 / 3.0 / 4.0).sqrt(), 1e-15));
        assert_eq!(Estimate::mean(&[3.0]).error, None);
        let r = Estimate::root_mean(&[4.0, 4.0]);
        assert_eq!((r.value, r.error), (2.0, Some(0.0)));
        let q = Quartiles::of(&[4.0, 1.0, 3.0, 2.0, 5.0]);
        assert_eq!((q.lower, q.median, q.upper), (2.0, 3.0, 4.0));
        assert!(Quartiles::of(&[]).median.is_nan());
        assert!(near(sidak(0.01, 1), 0.01, 1e-15));
        assert!(near(sidak(0.01, 100), 0.633_967_659, 1e-8));
    }
}
