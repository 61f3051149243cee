//! Shared file: cosine and sine of multiples of π, by one polynomial on every processor.
//!
//! Taking the angle in units of π makes the reduction to the first octant exact, so the poles, the equator and the
//! four quarters of the horizon come out as exact zeros and ones. A GPU's own `sin` has an *absolute* error (WGSL
//! allows 2⁻¹¹), which near a pole is a large relative one: texel areas need better.

use core::f32::consts::PI;

use glam::Vec2;

/// `(cos πx, sin πx)` for `|x| ≤ 1` (further out the error grows with `|x|`).
///
/// Relative error of each component below 3·10⁻⁷; exact where the true value is 0 or ±1.
///
/// ```
/// use glam::Vec2;
/// use glimt_probe::trig::cos_sin_pi;
/// assert_eq!(cos_sin_pi(0.0), Vec2::new(1.0, 0.0));
/// assert_eq!(cos_sin_pi(0.5), Vec2::new(0.0, 1.0));
/// assert_eq!(cos_sin_pi(-1.0), Vec2::new(-1.0, 0.0));
/// assert!((cos_sin_pi(0.25).x - 0.5f32.sqrt()).abs() < 1e-7);
/// ```
#[inline]
#[must_use]
pub fn cos_sin_pi(x: f32) -> Vec2 {
    // x = quarter/2 + y, |y| ≤ 1/4; the subtraction is exact.
    let quarter = libm::floorf(2.0 * x + 0.5);
    let y = x - 0.5 * quarter;
    let y2 = y * y;
    // Taylor series of cos πy and sin πy; the first term left out is below 2·10⁻⁹.
    let c = 1.0
        + y2 * (-4.934_802_2
            + y2 * (4.058_712_1 + y2 * (-1.335_262_7 + y2 * (0.235_330_63 + y2 * -0.025_806_89))));
    let s = y
        * (PI + y2 * (-5.167_712_8 + y2 * (2.550_164 + y2 * (-0.599_264_53 + y2 * 0.082_145_887))));
    // `+ 0.0` turns a negative zero into a positive one, so that `atan2` of the result has one answer at the seam.
    match (quarter as i32) & 3 {
        0 => Vec2::new(c, s + 0.0),
        1 => Vec2::new(0.0 - s, c),
        2 => Vec2::new(0.0 - c, 0.0 - s),
        _ => Vec2::new(s + 0.0, 0.0 - c),
    }
}
