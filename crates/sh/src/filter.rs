//! Shared file: what is done to one coefficient at a time.

use glam::Vec2;

use crate::basis::turn;

/// The band l that coefficient `k` belongs to, `k < 36`; more count as the last band.
///
/// ```
/// use glimt_sh::coefficient_band;
/// assert_eq!([0, 1, 3, 4, 24, 25, 35].map(coefficient_band), [0, 1, 1, 2, 4, 5, 5]);
/// ```
#[inline]
#[must_use]
pub fn coefficient_band(k: u32) -> u32 {
    let mut l = 0;
    while l < 5 && k >= (l + 1) * (l + 1) {
        l += 1;
    }
    l
}

/// The order m of coefficient `k`, from −l to l.
///
/// ```
/// use glimt_sh::coefficient_order;
/// assert_eq!([0, 1, 2, 3, 4].map(coefficient_order), [0, -1, 0, 1, -2]);
/// ```
#[inline]
#[must_use]
pub fn coefficient_order(k: u32) -> i32 {
    let l = coefficient_band(k);
    k as i32 - (l * (l + 1)) as i32
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
