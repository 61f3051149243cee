//! Host file: what the rim of a mirror ball looks like across a few pixels: the terms that a piece of it is fitted with.
//!
//! At the rim the ball reflects at grazing incidence what lies straight behind it, so there need be no step. But the
//! reflected angle, and with it everything that depends on it, grows like the square root of the depth `x = R − r` below
//! the rim. So inside the value is a polynomial in `√x`; outside, where the background is seen directly, it is smooth.

use std::sync::OnceLock;

/// Standard deviations in pixels of the blurs that are tried, on top of a pixel's own width.
pub(crate) const BLURS: [f64; 12] = [
    0.1, 0.3, 0.5, 0.65, 0.8, 1.0, 1.2, 1.45, 1.75, 2.1, 2.6, 3.2,
];
/// The blur that is assumed where it is not searched for.
pub(crate) const USUAL_BLUR: usize = 3;

/// Powers of `√x`: 0 (a step) to 3.
pub(crate) const POWERS: usize = 4;

const FIRST: f64 = -14.0;
const LAST: f64 = 34.0;
const STEPS_PER_PX: f64 = 16.0;

/// For each blur, the terms at depths from `FIRST` on.
type Table = Vec<Vec<[f64; POWERS]>>;

/// The mean of `max(x, 0)^(m/2)`, m = 0…3, over a pixel that is seen with the blur, at the depth `x` in pixels.
pub(crate) fn terms(blur: usize, x: f64) -> [f64; POWERS] {
    static TABLE: OnceLock<Table> = OnceLock::new();
    let table = &TABLE.get_or_init(make)[blur];
    let at = (x.clamp(FIRST, LAST) - FIRST) * STEPS_PER_PX;
    let i = (at as usize).min(table.len() - 2);
    let f = at - i as f64;
    std::array::from_fn(|m| table[i][m] + (table[i + 1][m] - table[i][m]) * f)
}

/// The index of the blur next to a standard deviation.
pub(crate) fn nearest(sigma: f64) -> usize {
    let off = |i: &usize| (BLURS[*i] - sigma).abs();
    (0..BLURS.len())
        .min_by(|a, b| off(a).total_cmp(&off(b)))
        .unwrap_or(USUAL_BLUR)
}

fn make() -> Table {
    let count = ((LAST - FIRST) * STEPS_PER_PX) as usize + 1;
    let one = |sigma: f64| {
        (0..count)
            .map(|i| {
                let x = FIRST + i as f64 / STEPS_PER_PX;
                let mut sum = [0.0; POWERS];
                let mut total = 0.0;
                for tap in -24..=24 {
                    let z = f64::from(tap) / 6.0;
                    let weight = (-0.5 * z * z).exp();
                    total += weight;
                    let y = x + z * sigma;
                    for (m, s) in sum.iter_mut().enumerate() {
                        *s += weight * over_pixel(m, y);
                    }
                }
                sum.map(|s| s / total)
            })
            .collect()
    };
    BLURS.iter().map(|&sigma| one(sigma)).collect()
}

/// Mean of `max(y, 0)^(m/2)` over `x − ½ … x + ½`.
fn over_pixel(m: usize, x: f64) -> f64 {
    let power = m as f64 / 2.0 + 1.0;
    let integral = |y: f64| y.max(0.0).powf(power) / power;
    integral(x + 0.5) - integral(x - 0.5)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn terms_are_powers_away_from_the_rim() {
        for blur in 0..BLURS.len() {
            let [step, root, line, _] = terms(blur, 25.0);
            assert!((step - 1.0).abs() < 1e-6);
            assert!((root - 5.0).abs() < 0.02);
            assert!((line - 25.0).abs() < 1e-3);
            assert!(terms(blur, -14.0).iter().all(|t| t.abs() < 1e-4));
            let half = terms(blur, 0.0);
            assert!((half[0] - 0.5).abs() < 1e-6);
        }
    }
}
