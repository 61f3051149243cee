//! Shared file: what is done to one coefficient at a time: windows, the clamped cosine, time, turning.

use core::f32::consts::PI;

use glam::Vec2;

use crate::basis::turn;

/// The Hann window `σ_l = (1 + cos(π l/w))/2` for `l ≤ w`, 0 beyond (Sloan 2008): band l of a light that a few bands
/// describe is multiplied by it against ringing. A window w that is not above 0 means none: 1.
///
/// ```
/// use glimt_sh::hann;
/// assert_eq!([hann(0, 4.0), hann(4, 4.0), hann(5, 4.0), hann(5, 0.0)], [1.0, 0.0, 0.0, 1.0]);
/// assert!((hann(2, 4.0) - 0.5).abs() < 1e-6);
/// ```
#[inline]
#[must_use]
pub fn hann(l: u32, window: f32) -> f32 {
    let l = l as f32;
    if !(window > 0.0) {
        1.0
    } else if l < window {
        0.5 + 0.5 * libm::cosf(PI * l / window)
    } else {
        0.0
    }
}

/// `A_l`, the band l of the clamped cosine (Ramamoorthi and Hanrahan 2001, Eqs. 7 and 8): the transfer of an unoccluded
/// point with normal n is `c_lm = A_l y_lm(n)`, and irradiance is `Σ A_l L_lm y_lm(n)`. π, 2π/3, π/4, 0, −π/24, 0; bands
/// beyond the sixth, which this crate has not, give 0.
///
/// ```
/// use glimt_sh::cosine_lobe;
/// use core::f32::consts::PI;
/// // ∫ max(cos θ, 0) over the sphere.
/// assert_eq!(cosine_lobe(0), PI);
/// assert_eq!([cosine_lobe(3), cosine_lobe(5)], [0.0, 0.0]);
/// ```
#[inline]
#[must_use]
pub fn cosine_lobe(l: u32) -> f32 {
    match l {
        0 => PI,
        1 => 2.0 / 3.0 * PI,
        2 => 0.25 * PI,
        4 => -PI / 24.0,
        _ => 0.0,
    }
}

/// `(c + α c_before)/(1 + α)`, the filter over time (Hajisharif 2012, Eq. 13), with `c_before` the last frame's
/// *filtered* coefficient. α = 0 filters nothing; an α that is not above 0 counts as that. An infinite one keeps
/// what was before.
///
/// After a step of the light what is left of the difference shrinks by `α/(1 + α)` a frame. The difference is what is
/// computed with: so light that stays the same stays so to the bit, and no α is too large for the product.
///
/// ```
/// use glimt_sh::temporal_filter;
/// assert_eq!(temporal_filter(1.0, 0.0, 3.0), 0.25);
/// assert_eq!(temporal_filter(1.0, 0.5, 0.0), 1.0);
/// assert_eq!(temporal_filter(1.0, 0.5, f32::INFINITY), 0.5);
/// ```
#[inline]
#[must_use]
pub fn temporal_filter(current: f32, before: f32, alpha: f32) -> f32 {
    if !(alpha > 0.0) {
        return current;
    }
    before + (current - before) / (1.0 + alpha)
}

/// A coefficient of order `m` of a light that has been turned about +z by an angle, counter-clockwise from above. `own`
/// is the coefficient before, `opposite` that of (l, −m), `angle` the angle's cosine and sine.
///
/// ```
/// use glam::Vec2;
/// use glimt_sh::rotate_z;
/// // A quarter of a turn takes x to y: (l, m) = (1, 1) and (1, −1).
/// let quarter = Vec2::new(0.0, 1.0);
/// assert_eq!([rotate_z(1, 1.0, 0.0, quarter), rotate_z(-1, 0.0, 1.0, quarter)], [0.0, 1.0]);
/// assert_eq!(rotate_z(0, 0.7, 0.7, quarter), 0.7);
/// ```
#[inline]
#[must_use]
pub fn rotate_z(m: i32, own: f32, opposite: f32, angle: Vec2) -> f32 {
    let mut whole = Vec2::new(1.0, 0.0);
    for _ in 0..m.abs() {
        whole = turn(whole, angle.x, angle.y);
    }
    if m > 0 {
        own * whole.x - opposite * whole.y
    } else {
        own * whole.x + opposite * whole.y
    }
}
