//! Shared file: the angular map (Debevec 1998): a disc whose radius is proportional to the angle from its axis.
//!
//! The disc's centre looks along +x, its top towards +z, its left towards +y, like the lat-long map's centre; the rim
//! is −x. The disc touches the four sides of the unit square of `uv`; points outside it look nowhere.

use core::f32::consts::{FRAC_1_PI, PI};

use glam::{Vec2, Vec3};

use crate::trig::cos_sin_pi;

/// Direction (unit length) of the image point `uv ∈ [0, 1]²`, `v` from the top; `None` outside the disc.
///
/// ```
/// use glam::{Vec2, Vec3};
/// use glimt_probe::angular::uv_to_direction;
/// assert_eq!(uv_to_direction(Vec2::new(0.5, 0.5)), Some(Vec3::X));
/// assert_eq!(uv_to_direction(Vec2::new(0.5, 0.25)), Some(Vec3::Z));
/// assert_eq!(uv_to_direction(Vec2::new(0.01, 0.01)), None);
/// ```
#[inline]
#[must_use]
pub fn uv_to_direction(uv: Vec2) -> Option<Vec3> {
    let p = 2.0 * uv - Vec2::ONE;
    let r = p.length();
    if r > 1.0 {
        return None;
    }
    if r <= 0.0 {
        return Some(Vec3::X);
    }
    let axial = cos_sin_pi(r);
    let across = axial.y / r;
    Some(Vec3::new(axial.x, 0.0 - p.x * across, 0.0 - p.y * across))
}

/// Image point of the direction `d` (any length but zero).
///
/// −x, which is the whole rim, gives its leftmost point `(0, 0.5)`; the zero vector counts as +x.
///
/// ```
/// use glam::{Vec2, Vec3};
/// use glimt_probe::angular::direction_to_uv;
/// assert_eq!(direction_to_uv(Vec3::Y), Vec2::new(0.25, 0.5));
/// assert_eq!(direction_to_uv(Vec3::NEG_X), Vec2::new(0.0, 0.5));
/// ```
#[inline]
#[must_use]
pub fn direction_to_uv(d: Vec3) -> Vec2 {
    let across = libm::sqrtf(d.y * d.y + d.z * d.z);
    if across <= 0.0 {
        let u = if d.x < 0.0 { 0.0 } else { 0.5 };
        return Vec2::new(u, 0.5);
    }
    let r = (libm::atan2f(across, d.x) * FRAC_1_PI).min(1.0);
    Vec2::splat(0.5) - Vec2::new(d.y, d.z) * (0.5 * r / across)
}

/// Solid angle per unit area of the unit square at `uv`, in steradians: `4π sin(πr)/r`, `r` the distance from the
/// centre in units of the disc's radius; 0 outside the disc. Its integral over the square is 4π.
///
/// ```
/// use core::f32::consts::PI;
/// use glam::Vec2;
/// use glimt_probe::angular::solid_angle_sr_per_uv;
/// assert!((solid_angle_sr_per_uv(Vec2::splat(0.5)) - 4.0 * PI * PI).abs() < 1e-5);
/// assert_eq!(solid_angle_sr_per_uv(Vec2::ZERO), 0.0);
/// ```
#[inline]
#[must_use]
pub fn solid_angle_sr_per_uv(uv: Vec2) -> f32 {
    let r = (2.0 * uv - Vec2::ONE).length();
    if r > 1.0 {
        return 0.0;
    }
    if r <= 0.0 {
        return 4.0 * PI * PI;
    }
    4.0 * PI * cos_sin_pi(r).y / r
}
