//! Host file: means and lines that a few wrong values do not move.

use crate::levels::median;

/// Residuals beyond this many standard deviations count less.
const HUBER: f64 = 1.5;
/// Frames on either side of a running median.
const NEIGHBOURS: usize = 5;

/// A line through values over time, and its standard errors.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Line {
    /// Mean time.
    middle: f64,
    /// Value there.
    pub(crate) mean: f64,
    pub(crate) mean_sigma: f64,
    /// Change in a unit of time.
    pub(crate) slope: f64,
    pub(crate) slope_sigma: f64,
}

impl Line {
    /// Iteratively reweighted least squares with Huber's weights, through (time, value). `sigmas` are the values' own
    /// standard errors; where there are none, all count alike. Fewer than three values have no slope and no errors.
    pub(crate) fn fit(points: &[(f64, f64)], sigmas: &[f64]) -> Self {
        if points.len() < 3 {
            let n = points.len().max(1) as f64;
            return Self {
                middle: points.iter().map(|p| p.0).sum::<f64>() / n,
                mean: points.iter().map(|p| p.1).sum::<f64>() / n,
                ..Self::default()
            };
        }
        let mut values: Vec<f64> = points.iter().map(|p| p.1).collect();
        let centre = median(&mut values);
        let off: Vec<f64> = points.iter().map(|p| p.1 - centre).collect();
        let mut scatter = spread(&off).max(1e-9);
        let mut line = Self {
            mean: centre,
            ..Self::default()
        };
        // A scene that is seen well is not trusted beyond what the frames scatter by.
        let prior: Vec<f64> = (0..points.len())
            .map(|i| {
                let own = sigmas.get(i).copied().unwrap_or(0.0);
                1.0 / (1.0 + (own / scatter).powi(2))
            })
            .collect();
        let mut sums = [0.0; 3];
        for _ in 0..30 {
            let residuals: Vec<f64> = points.iter().map(|p| p.1 - line.at(p.0)).collect();
            scatter = spread(&residuals).max(1e-9);
            let weights: Vec<f64> = residuals
                .iter()
                .zip(&prior)
                .map(|(r, prior)| prior * (HUBER * scatter / r.abs().max(1e-300)).min(1.0))
                .collect();
            let sum = |f: &dyn Fn(&(f64, f64)) -> f64| -> f64 {
                points.iter().zip(&weights).map(|(p, w)| w * f(p)).sum()
            };
            let total = sum(&|_| 1.0);
            line.middle = sum(&|p| p.0) / total;
            line.mean = sum(&|p| p.1) / total;
            let tt = sum(&|p| (p.0 - line.middle).powi(2));
            line.slope = sum(&|p| (p.0 - line.middle) * (p.1 - line.mean)) / tt.max(1e-300);
            sums = [total, tt, 0.0];
        }
        let residuals: Vec<f64> = points.iter().map(|p| p.1 - line.at(p.0)).collect();
        let widened = scatter * together(&residuals);
        line.mean_sigma = widened / sums[0].sqrt();
        line.slope_sigma = widened / sums[1].max(1e-300).sqrt();
        line
    }

    pub(crate) fn at(&self, time: f64) -> f64 {
        self.mean + self.slope * (time - self.middle)
    }
}

/// By how much the error of a mean grows since neighbours move together: √((1 + ρ) / (1 − ρ)).
fn together(residuals: &[f64]) -> f64 {
    let limit = 3.0 * spread(residuals);
    let kept: Vec<f64> = residuals.iter().map(|r| r.clamp(-limit, limit)).collect();
    let all: f64 = kept.iter().map(|r| r * r).sum();
    let pairs: f64 = kept.windows(2).map(|p| p[0] * p[1]).sum();
    let rho = if all > 0.0 {
        (pairs / all).clamp(0.0, 0.95)
    } else {
        0.0
    };
    ((1.0 + rho) / (1.0 - rho)).sqrt()
}

/// Standard deviation by the median of the absolute values.
pub(crate) fn spread(residuals: &[f64]) -> f64 {
    if residuals.is_empty() {
        return 0.0;
    }
    let mut sizes: Vec<f64> = residuals.iter().map(|r| r.abs()).collect();
    1.4826 * median(&mut sizes)
}

/// Each value less the median of it and its neighbours.
pub(crate) fn running_median_residuals(values: &[f64]) -> Vec<f64> {
    (0..values.len())
        .map(|i| {
            let from = i.saturating_sub(NEIGHBOURS);
            let to = (i + NEIGHBOURS + 1).min(values.len());
            let mut window = values[from..to].to_vec();
            values[i] - median(&mut window)
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_survives_outliers_and_knows_its_error() {
        let noise = |i: usize| ((i * 7919 % 101) as f64 / 101.0 - 0.5) * 0.2;
        let mut points: Vec<(f64, f64)> = (0..100)
            .map(|i| (i as f64, 5.0 + 0.02 * i as f64 + noise(i)))
            .collect();
        points[10].1 = 80.0;
        points[55].1 = -40.0;
        let line = Line::fit(&points, &[]);
        assert!((line.slope - 0.02).abs() < 4.0 * line.slope_sigma);
        assert!(line.slope_sigma < 1e-3 && line.slope_sigma > 1e-5);
    }
}
