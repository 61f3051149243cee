//! Shared file: the Blinn-Phong lobe as a function of the half vector.

use core::f32::consts::FRAC_1_PI;

use glam::Vec3;

/// The greatest exponent: beyond it the lobe, 0.8° wide, is narrower than f32 directions can shape.
pub const MAX_EXPONENT: f32 = 10_000.0;

/// The half vector `h = (wo + wi)/|wo + wi|` of two directions above the horizon, as far as the lobe needs it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct HalfVector {
    cos2_theta: f32,
    sin2_theta: f32,
    /// `wo·h`, which for unit vectors is half the length of their sum.
    wo_dot_h: f32,
}

impl HalfVector {
    pub(crate) fn new(wo: Vec3, wi: Vec3) -> HalfVector {
        let sum = wo + wi;
        // Opposite directions along the horizon: keep the square from running out of f32.
        let length2 = sum.length_squared().max(1e-20);
        HalfVector {
            cos2_theta: sum.z * sum.z / length2,
            sin2_theta: (sum.x * sum.x + sum.y * sum.y) / length2,
            wo_dot_h: 0.5 * libm::sqrtf(length2),
        }
    }

    /// `(n·h)^e`.
    pub(crate) fn lobe(&self, exponent: f32) -> f32 {
        cosine_power(self.cos2_theta, self.sin2_theta, exponent)
    }

    /// Density of the reflected direction when half vectors are drawn with `(e + 1)/2π cosᵉ θ_h`, in 1/sr.
    pub(crate) fn pdf_sr(&self, exponent: f32) -> f32 {
        (exponent + 1.0) * (0.5 * FRAC_1_PI) * self.lobe(exponent) / (4.0 * self.wo_dot_h)
    }
}

/// `cosᵉ θ` for `e ≥ 0`, from the squares of cosine and sine.
///
/// A cosine near 1 is too coarse for a great power: at e = 10⁴ the last bit of f32 is worth 6·10⁻⁴. The sine has the
/// missing bits, and so this has a relative error of a few 10⁻⁶ wherever the result is above 10⁻⁶. `0⁰` is 1; what
/// would be below 10⁻³⁷ is 0.
///
/// ```
/// use glimt_brdf::cosine_power;
/// assert!((cosine_power(0.75, 0.25, 2.0) - 0.75).abs() < 1e-6);
/// assert_eq!((cosine_power(0.0, 1.0, 0.0), cosine_power(0.0, 1.0, 3.0)), (1.0, 0.0));
/// // cos θ = 1 − 5·10⁻⁵, to the power 10⁴.
/// let sin2 = 1e-4_f32;
/// let exact = (5_000.0 * (-1e-4_f64).ln_1p()).exp();
/// assert!((f64::from(cosine_power(1.0 - sin2, sin2, 1e4)) / exact - 1.0).abs() < 1e-6);
/// ```
#[inline]
#[must_use]
pub fn cosine_power(cos2_theta: f32, sin2_theta: f32, exponent: f32) -> f32 {
    let log_cos2 = if sin2_theta < 1.0 / 16.0 {
        // ln(1 − s) = −2 artanh(s/(2 − s)); the first term left out is below 2·10⁻¹⁰ of the sum.
        let t = sin2_theta / (2.0 - sin2_theta);
        let t2 = t * t;
        -2.0 * t * (1.0 + t2 * (1.0 / 3.0 + t2 * (1.0 / 5.0)))
    } else {
        libm::logf(cos2_theta.max(1e-37))
    };
    let log_power = 0.5 * exponent * log_cos2;
    if log_power < -85.0 {
        return 0.0;
    }
    libm::expf(log_power)
}

/// The factor that gives the lobe `c(e) (n·h)^e` an albedo of exactly 1 at normal incidence, in 1/sr:
/// `c(e) = (e + 2)(e + 4)/(8π (2^(−e/2) + e))` (Giesen 2009).
///
/// ```
/// use core::f32::consts::{FRAC_1_PI, PI};
/// use glimt_brdf::normalisation;
/// assert!((normalisation(0.0) - FRAC_1_PI).abs() < 1e-7);
/// assert!((normalisation(2.0) - 24.0 / (8.0 * PI * 2.5)).abs() < 1e-6);
/// ```
#[inline]
#[must_use]
pub fn normalisation(exponent: f32) -> f32 {
    let tail = libm::exp2f((-0.5 * exponent).max(-60.0));
    (exponent + 2.0) * (exponent + 4.0) * (0.125 * FRAC_1_PI) / (tail + exponent)
}
