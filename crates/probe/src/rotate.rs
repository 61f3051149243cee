//! Shared file: turning directions about the world's vertical.

use glam::{Vec2, Vec3};

use crate::trig::cos_sin_pi;

/// Cosine and sine of an angle in degrees, exact at multiples of 90°.
///
/// ```
/// use glam::Vec2;
/// use glimt_probe::rotate::cos_sin_degrees;
/// assert_eq!(cos_sin_degrees(90.0), Vec2::new(0.0, 1.0));
/// assert_eq!(cos_sin_degrees(-450.0), Vec2::new(0.0, -1.0));
/// ```
#[inline]
#[must_use]
pub fn cos_sin_degrees(degrees: f32) -> Vec2 {
    let turns = libm::floorf(degrees / 360.0 + 0.5);
    cos_sin_pi((degrees - 360.0 * turns) / 180.0)
}

/// `d` turned about +z by the angle whose cosine and sine are given, counter-clockwise seen from above (+z).
///
/// A probe that stands turned by an angle is looked up in the direction turned by minus that angle: negate the sine.
///
/// ```
/// use glam::{Vec2, Vec3};
/// use glimt_probe::rotate::rotate_z;
/// assert_eq!(rotate_z(Vec3::X, Vec2::new(0.0, 1.0)), Vec3::Y);
/// ```
#[inline]
#[must_use]
pub fn rotate_z(d: Vec3, cos_sin: Vec2) -> Vec3 {
    Vec3::new(
        d.x * cos_sin.x - d.y * cos_sin.y,
        d.x * cos_sin.y + d.y * cos_sin.x,
        d.z,
    )
}
