//! Shared file: the latitude-longitude map (also called equirectangular).
//!
//! `θ = πv`, `φ = π − 2πu`, `D = (sin θ cos φ, sin θ sin φ, cos θ)`: row 0 lies at +z, the image's centre looks along
//! +x, its left half towards +y. Texel `(i, j)` covers `u ∈ [i/w, (i+1)/w)`, `v ∈ [j/h, (j+1)/h)`; its value stands at
//! the centre. Sizes are `(w, h)` in texels; a zero counts as one.

use core::f32::consts::{FRAC_1_PI, PI};

use glam::{UVec2, Vec2, Vec3};

use crate::trig::cos_sin_pi;

/// Direction (unit length) of the image point `uv`, `u ∈ [0, 1]` from left to right, `v ∈ [0, 1]` from the top.
///
/// Differs from Hajisharif 2012, Eq. 9, which prints `φ = 2πu` and so mirrors photographs in a right-handed z-up world.
///
/// ```
/// use glam::{Vec2, Vec3};
/// use glimt_probe::latlong::uv_to_direction;
/// assert_eq!(uv_to_direction(Vec2::new(0.5, 0.5)), Vec3::X);
/// assert_eq!(uv_to_direction(Vec2::new(0.25, 0.5)), Vec3::Y);
/// assert_eq!(uv_to_direction(Vec2::new(0.7, 0.0)), Vec3::Z);
/// ```
#[inline]
#[must_use]
pub fn uv_to_direction(uv: Vec2) -> Vec3 {
    let theta = cos_sin_pi(uv.y);
    let phi = cos_sin_pi(1.0 - 2.0 * uv.x);
    Vec3::new(theta.y * phi.x, theta.y * phi.y, theta.x)
}

/// Image point of the direction `d` (any length but zero): `u ∈ [0, 1)`, `v ∈ [0, 1]`.
///
/// The seam (−x) is `u = 0`. At a pole, where every `u` would do, `u = 0.5`; the zero vector counts as +z.
///
/// ```
/// use glam::{Vec2, Vec3};
/// use glimt_probe::latlong::direction_to_uv;
/// assert_eq!(direction_to_uv(Vec3::new(2.0, 0.0, 0.0)), Vec2::new(0.5, 0.5));
/// assert_eq!(direction_to_uv(Vec3::NEG_X), Vec2::new(0.0, 0.5));
/// assert_eq!(direction_to_uv(Vec3::NEG_Z), Vec2::new(0.5, 1.0));
/// ```
#[inline]
#[must_use]
pub fn direction_to_uv(d: Vec3) -> Vec2 {
    let horizontal = libm::sqrtf(d.x * d.x + d.y * d.y);
    if horizontal <= 0.0 {
        let v = if d.z < 0.0 { 1.0 } else { 0.0 };
        return Vec2::new(0.5, v);
    }
    // The arctangent keeps its precision at the poles, where the arccosine of z has none.
    let v = libm::atan2f(horizontal, d.z) * FRAC_1_PI;
    let u = 0.5 - 0.5 * FRAC_1_PI * libm::atan2f(d.y, d.x);
    Vec2::new(if u < 1.0 { u.max(0.0) } else { 0.0 }, v.clamp(0.0, 1.0))
}

/// Texel that the direction `d` (any length but zero) falls into: `(column, row)`, each below `size`.
///
/// A direction within rounding of a texel's edge may come out on the other side; who knows the texel keeps it.
///
/// ```
/// use glam::{UVec2, Vec3};
/// use glimt_probe::latlong::direction_to_texel;
/// assert_eq!(direction_to_texel(Vec3::new(1.0, -0.1, 0.1), UVec2::new(8, 4)), UVec2::new(4, 1));
/// ```
#[inline]
#[must_use]
pub fn direction_to_texel(d: Vec3, size: UVec2) -> UVec2 {
    let size = size.max(UVec2::ONE);
    let position = direction_to_uv(d) * size.as_vec2();
    position.as_uvec2().min(size - UVec2::ONE)
}

/// Direction (unit length) of the centre of a texel.
///
/// ```
/// use glam::{UVec2, Vec2};
/// use glimt_probe::latlong::{texel_direction, uv_to_direction};
/// let centre = texel_direction(UVec2::new(2, 1), UVec2::new(8, 4));
/// assert_eq!(centre, uv_to_direction(Vec2::new(2.5 / 8.0, 1.5 / 4.0)));
/// ```
#[inline]
#[must_use]
pub fn texel_direction(texel: UVec2, size: UVec2) -> Vec3 {
    uv_to_direction((texel.as_vec2() + Vec2::splat(0.5)) / size.max(UVec2::ONE).as_vec2())
}

/// `cos θ` of the edge above row `edge`, `edge ∈ 0..=height`: exactly 1 and −1 at the poles, exactly 0 at the equator,
/// and exactly antisymmetric about it.
///
/// The difference of two neighbours loses all precision near a pole: take [`texel_solid_angle_sr`] for areas.
///
/// ```
/// use glimt_probe::latlong::row_cos_theta;
/// assert_eq!([row_cos_theta(0, 6), row_cos_theta(3, 6), row_cos_theta(6, 6)], [1.0, 0.0, -1.0]);
/// assert!((row_cos_theta(2, 6) - 0.5).abs() < 1e-7);
/// ```
#[inline]
#[must_use]
pub fn row_cos_theta(edge: u32, height: u32) -> f32 {
    let height = height.max(1) as f32;
    // The latitude in units of π, signed; its numerator is exact.
    cos_sin_pi((height - 2.0 * edge as f32) / (2.0 * height)).y
}

/// Solid angle of one texel of row `row`, in steradians: `(2π/w) (cos θ₀ − cos θ₁)`, the exact area of the band.
///
/// Written as `(4π/w) sin(θ at the middle of the row) sin(π/2h)`, measured from the nearer pole, it keeps f32's
/// relative precision in every row. Differs from Hajisharif 2012, Eq. 12, which takes `2π² sin θ/(w h)`. A row beyond
/// the last counts as the last.
///
/// ```
/// use glam::UVec2;
/// use glimt_probe::latlong::texel_solid_angle_sr;
/// let size = UVec2::new(4, 2);
/// let octant = core::f32::consts::FRAC_PI_2;
/// assert!((texel_solid_angle_sr(0, size) - octant).abs() < 1e-6);
/// ```
#[inline]
#[must_use]
pub fn texel_solid_angle_sr(row: u32, size: UVec2) -> f32 {
    let size = size.max(UVec2::ONE);
    let row = row.min(size.y - 1);
    let from_pole = row.min(size.y - 1 - row);
    let half_row = 0.5 / size.y as f32;
    let middle = (2 * from_pole + 1) as f32 * half_row;
    4.0 * PI / size.x as f32 * cos_sin_pi(middle).y * cos_sin_pi(half_row).y
}

/// Direction (unit length) inside a texel, at `r ∈ [0, 1)²`: `r.x` uniform in φ from the left edge, `r.y` uniform in
/// cos θ from the upper edge, and so uniform in solid angle. Its density is one over [`texel_solid_angle_sr`].
///
/// ```
/// use glam::{UVec2, Vec2, Vec3};
/// use glimt_probe::latlong::direction_in_texel;
/// // A map of one texel is the whole sphere.
/// let d = direction_in_texel(UVec2::ZERO, UVec2::ONE, Vec2::new(0.5, 0.5));
/// assert!((d - Vec3::X).length() < 1e-6);
/// ```
#[inline]
#[must_use]
pub fn direction_in_texel(texel: UVec2, size: UVec2, r: Vec2) -> Vec3 {
    let size = size.max(UVec2::ONE);
    let row = texel.y.min(size.y - 1);
    // Uniform in cos θ is uniform in s = sin²(θ/2) = (1 − cos θ)/2, which is precise at the pole θ is measured from.
    let southern = 2 * row >= size.y;
    let upper = if southern { size.y - row } else { row };
    let lower = if southern { size.y - row - 1 } else { row + 1 };
    let half = 0.5 / size.y as f32;
    let sin_upper = cos_sin_pi(upper as f32 * half).y;
    let sin_lower = cos_sin_pi(lower as f32 * half).y;
    let s_upper = sin_upper * sin_upper;
    let s = s_upper + (sin_lower * sin_lower - s_upper) * r.y;
    let sin_theta = 2.0 * libm::sqrtf((s * (1.0 - s)).max(0.0));
    let cos_theta = if southern {
        2.0 * s - 1.0
    } else {
        1.0 - 2.0 * s
    };
    let phi = cos_sin_pi(1.0 - 2.0 * (texel.x as f32 + r.x) / size.x as f32);
    Vec3::new(sin_theta * phi.x, sin_theta * phi.y, cos_theta)
}
