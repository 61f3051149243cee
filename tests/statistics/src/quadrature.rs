//! Host file: integrals over the sphere in f64, against which densities and estimators are held.
//!
//! All integrals are in solid angle: the variables are `z = cos θ` and the azimuth φ, whose product is the area.

use std::f64::consts::{PI, TAU};

/// A unit vector.
pub type Direction = [f64; 3];

/// The unit vector with cosine `z` from +z and azimuth `phi` (radians, counter-clockwise from +x).
#[must_use]
pub fn direction(z: f64, phi: f64) -> Direction {
    let r = ((1.0 - z) * (1.0 + z)).max(0.0).sqrt();
    [r * phi.cos(), r * phi.sin(), z]
}

/// An integral with an estimate of its absolute error: the difference from the coarser rule.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Integral {
    /// The finest estimate.
    pub value: f64,
    /// Sum of the differences that were accepted, or could not be brought down.
    pub error: f64,
}

impl Integral {
    /// The value, if its error is at most `relative` of it.
    ///
    /// # Errors
    /// The integral itself where it did not converge.
    pub fn converged(self, relative: f64) -> Result<f64, Integral> {
        if self.error <= relative * self.value.abs() {
            Ok(self.value)
        } else {
            Err(self)
        }
    }
}

/// Nodes and weights of the Gauss-Legendre rule with `n ≥ 1` points on `[−1, 1]`, exact up to degree `2n − 1`.
#[must_use]
pub fn gauss_legendre(n: usize) -> Vec<(f64, f64)> {
    let mut rule = Vec::with_capacity(n);
    for i in 0..n {
        // Newton's method from Tricomi's estimate of the root.
        let mut x = (PI * (i as f64 + 0.75) / (n as f64 + 0.5)).cos();
        let mut slope = 1.0;
        for _ in 0..100 {
            let (mut p, mut previous) = (x, 1.0);
            for k in 2..=n {
                let k = k as f64;
                (p, previous) = (((2.0 * k - 1.0) * x * p - (k - 1.0) * previous) / k, p);
            }
            slope = if n == 1 {
                1.0
            } else {
                n as f64 * (x * p - previous) / (x * x - 1.0)
            };
            let step = p / slope;
            x -= step;
            if step.abs() < 1e-15 {
                break;
            }
        }
        rule.push((x, 2.0 / ((1.0 - x * x) * slope * slope)));
    }
    rule
}

/// Integral of a smooth function over the band `z ∈ [z₀, z₁]`: Gauss-Legendre in z times uniform points in φ, both
/// doubled until two rounds agree to `relative`. Converges exponentially; at a discontinuity inside the band it does
/// not, and the error says so.
#[must_use]
pub fn integrate_band(f: impl Fn(Direction) -> f64, z: [f64; 2], relative: f64) -> Integral {
    let (middle, half) = (0.5 * (z[0] + z[1]), 0.5 * (z[1] - z[0]));
    let round = |n: usize| {
        let columns = 2 * n;
        let mut sum = 0.0;
        for (x, weight) in gauss_legendre(n) {
            let row = (0..columns).map(|k| {
                f(direction(
                    middle + half * x,
                    TAU * (k as f64 + 0.5) / columns as f64,
                ))
            });
            sum += weight * row.sum::<f64>();
        }
        sum * half * TAU / columns as f64
    };
    let mut n = 16;
    let mut value = round(n);
    loop {
        n *= 2;
        let finer = round(n);
        let error = (finer - value).abs();
        value = finer;
        if error <= relative * value.abs() || n >= 1024 {
            return Integral { value, error };
        }
    }
}

/// Integral of a function that is smooth in each of the two hemispheres `z < 0` and `z > 0`.
#[must_use]
pub fn integrate_sphere(f: impl Fn(Direction) -> f64, relative: f64) -> Integral {
    let upper = integrate_band(&f, [0.0, 1.0], relative);
    let lower = integrate_band(&f, [-1.0, 0.0], relative);
    Integral {
        value: upper.value + lower.value,
        error: upper.error + lower.error,
    }
}

/// Integral of a smooth function over the hemisphere `z > 0`.
#[must_use]
pub fn integrate_hemisphere(f: impl Fn(Direction) -> f64, relative: f64) -> Integral {
    integrate_band(f, [0.0, 1.0], relative)
}

/// How often a patch may be quartered.
const MAX_DEPTH: u32 = 14;

/// How often [`integrate_patch`] quarters a patch before it believes that two rules agree: a narrow lobe that both miss
/// looks smooth.
const MIN_DEPTH: u32 = 3;

/// Integral over the patch `z ∈ [z₀, z₁]`, `φ ∈ [φ₀, φ₁]`, quartered where needed until the error is about `absolute`
/// (shared out by area). Discontinuities are followed down to the smallest quarter.
#[must_use]
pub fn integrate_patch(
    f: impl Fn(Direction) -> f64,
    z: [f64; 2],
    phi: [f64; 2],
    absolute: f64,
) -> Integral {
    let coarse = patch_rule(&f, z, phi);
    refine(&f, z, phi, coarse, absolute, MAX_DEPTH + MIN_DEPTH)
}

/// The product of two Gauss-Legendre rules of three points.
fn patch_rule(f: &impl Fn(Direction) -> f64, z: [f64; 2], phi: [f64; 2]) -> f64 {
    const NODE: f64 = 0.774_596_669_241_483_4;
    const RULE: [(f64, f64); 3] = [(-NODE, 5.0 / 9.0), (0.0, 8.0 / 9.0), (NODE, 5.0 / 9.0)];
    let half = [0.5 * (z[1] - z[0]), 0.5 * (phi[1] - phi[0])];
    let mut sum = 0.0;
    for (x, weight_x) in RULE {
        for (y, weight_y) in RULE {
            sum += weight_x
                * weight_y
                * f(direction(
                    z[0] + half[0] * (1.0 + x),
                    phi[0] + half[1] * (1.0 + y),
                ));
        }
    }
    sum * half[0] * half[1]
}

/// Quarters a patch whose coarse integral is known, and goes on where the quarters disagree with it. A depth above
/// [`MAX_DEPTH`] goes on in any case.
fn refine(
    f: &impl Fn(Direction) -> f64,
    z: [f64; 2],
    phi: [f64; 2],
    coarse: f64,
    absolute: f64,
    depth: u32,
) -> Integral {
    let (zm, pm) = (0.5 * (z[0] + z[1]), 0.5 * (phi[0] + phi[1]));
    let quarters = [
        ([z[0], zm], [phi[0], pm]),
        ([z[0], zm], [pm, phi[1]]),
        ([zm, z[1]], [phi[0], pm]),
        ([zm, z[1]], [pm, phi[1]]),
    ];
    let parts = quarters.map(|(z, phi)| patch_rule(f, z, phi));
    let value: f64 = parts.iter().sum();
    let error = (value - coarse).abs();
    // Of what is not a number no refinement makes one.
    if (error <= absolute && depth <= MAX_DEPTH) || depth == 0 || !error.is_finite() {
        return Integral { value, error };
    }
    let mut total = Integral::default();
    for ((z, phi), part) in quarters.into_iter().zip(parts) {
        let quarter = refine(f, z, phi, part, 0.25 * absolute, depth - 1);
        total.value += quarter.value;
        total.error += quarter.error;
    }
    total
}

/// Integral over the whole sphere of a function that is smooth inside each texel of a lat-long map of `size` (width,
/// height): `f(texel, direction)`, the texel as (column, row). Texels are first divided into patches no larger than
/// 1/64 of a turn, then quartered until the sum is stable to `relative`.
#[must_use]
pub fn integrate_texels(
    size: [u32; 2],
    f: impl Fn([u32; 2], Direction) -> f64,
    relative: f64,
) -> Integral {
    let divisions = [
        64u32.div_ceil(size[0]).max(1),
        32u32.div_ceil(size[1]).max(1),
    ];
    let fine = [size[0] * divisions[0], size[1] * divisions[1]];
    let patch = |column: u32, row: u32| {
        let edge = |row: u32| (PI * f64::from(row) / f64::from(fine[1])).cos();
        let azimuth = |column: u32| PI - TAU * f64::from(column) / f64::from(fine[0]);
        (
            [edge(row + 1), edge(row)],
            [azimuth(column + 1), azimuth(column)],
        )
    };
    // A first round fixes the scale of the tolerance; then every patch is refined to its share.
    let mut coarse = Vec::with_capacity((fine[0] * fine[1]) as usize);
    for row in 0..fine[1] {
        for column in 0..fine[0] {
            let texel = [column / divisions[0], row / divisions[1]];
            let (z, phi) = patch(column, row);
            coarse.push(patch_rule(&|d| f(texel, d), z, phi));
        }
    }
    let scale = relative * coarse.iter().map(|part| part.abs()).sum::<f64>();
    let mut total = Integral::default();
    for (i, part) in coarse.into_iter().enumerate() {
        let (column, row) = (i as u32 % fine[0], i as u32 / fine[0]);
        let texel = [column / divisions[0], row / divisions[1]];
        let (z, phi) = patch(column, row);
        let share = (z[1] - z[0]) * (phi[1] - phi[0]) / (4.0 * PI);
        let fine = refine(&|d| f(texel, d), z, phi, part, scale * share, MAX_DEPTH);
        total.value += fine.value;
        total.error += fine.error;
    }
    total
}
