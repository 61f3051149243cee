//! Shared file: warps of the unit square onto the disc and the sphere, each as sample, density and inverse.
//!
//! Directions are in a local frame whose pole is +z. A sampler takes `u ∈ [0, 1)²` and gives a direction with its
//! density per steradian; the density of a given direction and the point `u` that leads to it have functions of their
//! own. Samplers are continuous and keep area, so stratified `u` give stratified directions.

use core::f32::consts::{FRAC_1_PI, FRAC_PI_4, TAU};

use glam::{Vec2, Vec3};

/// A sampled direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DirectionSample {
    /// Unit vector in the local frame.
    pub direction: Vec3,
    /// Density of `direction`, in 1/sr; 0 marks an impossible sample, to be counted and to contribute nothing.
    pub pdf_sr: f32,
}

/// Concentric map of the square onto the unit disc (Shirley and Chiu 1997): squares become rings, areas keep their
/// ratio. The density is 1/π per unit area.
///
/// ```
/// use glam::Vec2;
/// use glimt_sampling::warp::sample_concentric_disk;
/// assert_eq!(sample_concentric_disk(Vec2::splat(0.5)), Vec2::ZERO);
/// assert_eq!(sample_concentric_disk(Vec2::new(0.75, 0.5)), Vec2::new(0.5, 0.0));
/// ```
#[inline]
#[must_use]
pub fn sample_concentric_disk(u: Vec2) -> Vec2 {
    let a = 2.0 * u.x - 1.0;
    let b = 2.0 * u.y - 1.0;
    if a == 0.0 && b == 0.0 {
        return Vec2::ZERO;
    }
    if a * a > b * b {
        let phi = FRAC_PI_4 * (b / a);
        return Vec2::new(a * libm::cosf(phi), a * libm::sinf(phi));
    }
    let phi = FRAC_PI_4 * (a / b);
    Vec2::new(b * libm::sinf(phi), b * libm::cosf(phi))
}

/// Density of [`sample_concentric_disk`] per unit area: 1/π on the disc, 0 outside.
#[inline]
#[must_use]
pub fn pdf_concentric_disk(p: Vec2) -> f32 {
    if p.length_squared() <= 1.0 {
        FRAC_1_PI
    } else {
        0.0
    }
}

/// The point of `[0, 1]²` that [`sample_concentric_disk`] maps to `p`, for `|p| ≤ 1`.
#[inline]
#[must_use]
pub fn invert_concentric_disk(p: Vec2) -> Vec2 {
    let r = p.length();
    if r <= 0.0 {
        return Vec2::splat(0.5);
    }
    // Both angles are taken within 45° of an axis, where the divisor is not zero.
    let square = if p.x.abs() > p.y.abs() {
        let a = if p.x < 0.0 { -r } else { r };
        Vec2::new(a, a * libm::atanf(p.y / p.x) / FRAC_PI_4)
    } else {
        let b = if p.y < 0.0 { -r } else { r };
        Vec2::new(b * libm::atanf(p.x / p.y) / FRAC_PI_4, b)
    };
    ((square + Vec2::ONE) * 0.5).clamp(Vec2::ZERO, Vec2::ONE)
}

/// A direction of the upper hemisphere, distributed as its cosine: the concentric disc lifted up (Malley's method).
///
/// Where a coordinate of `u` is 0 the direction is horizontal and its density 0.
///
/// ```
/// use glam::{Vec2, Vec3};
/// use glimt_sampling::warp::sample_cosine_hemisphere;
/// let up = sample_cosine_hemisphere(Vec2::splat(0.5));
/// assert_eq!(up.direction, Vec3::Z);
/// assert!((up.pdf_sr - core::f32::consts::FRAC_1_PI).abs() < 1e-7);
/// ```
#[inline]
#[must_use]
pub fn sample_cosine_hemisphere(u: Vec2) -> DirectionSample {
    let p = sample_concentric_disk(u);
    // The radius on the disc is that on the square, which is exact; the point's own length is not, and near the horizon
    // z would be made of its rounding.
    let r = (2.0 * u - Vec2::ONE).abs().max_element();
    let z = libm::sqrtf((1.0 - r) * (1.0 + r));
    DirectionSample {
        direction: p.extend(z),
        pdf_sr: z * FRAC_1_PI,
    }
}

/// Density of [`sample_cosine_hemisphere`], in 1/sr: `cos θ/π`, 0 at and below the horizon.
#[inline]
#[must_use]
pub fn pdf_cosine_hemisphere_sr(direction: Vec3) -> f32 {
    direction.z.max(0.0) * FRAC_1_PI
}

/// The point of `[0, 1]²` that [`sample_cosine_hemisphere`] maps to `direction`, which must not be below the horizon.
#[inline]
#[must_use]
pub fn invert_cosine_hemisphere(direction: Vec3) -> Vec2 {
    invert_concentric_disk(direction.truncate())
}

/// A direction uniform on the sphere (Archimedes): `u.x` runs from +z to −z, `u.y` around counter-clockwise from +x.
///
/// ```
/// use glam::Vec2;
/// use glimt_sampling::warp::sample_uniform_sphere;
/// let s = sample_uniform_sphere(Vec2::new(0.25, 0.0));
/// assert_eq!(s.direction.z, 0.5);
/// assert_eq!(s.pdf_sr, 0.25 * core::f32::consts::FRAC_1_PI);
/// ```
#[inline]
#[must_use]
pub fn sample_uniform_sphere(u: Vec2) -> DirectionSample {
    sample_cap(u, 2.0)
}

/// Density of [`sample_uniform_sphere`], in 1/sr: `1/4π`.
#[inline]
#[must_use]
pub fn pdf_uniform_sphere_sr() -> f32 {
    0.25 * FRAC_1_PI
}

/// The point of `[0, 1]²` that [`sample_uniform_sphere`] maps to `direction`.
#[inline]
#[must_use]
pub fn invert_uniform_sphere(direction: Vec3) -> Vec2 {
    invert_cap(direction, 2.0)
}

/// Height of the cap of all directions within `radius_rad` of +z: `1 − cos α`, precise for small angles too.
///
/// ```
/// use glimt_sampling::warp::cap_height;
/// assert!((cap_height(core::f32::consts::PI) - 2.0).abs() < 1e-6);
/// assert!((cap_height(1e-4) / 5e-9 - 1.0).abs() < 1e-6);
/// ```
#[inline]
#[must_use]
pub fn cap_height(radius_rad: f32) -> f32 {
    let s = libm::sinf(0.5 * radius_rad);
    2.0 * s * s
}

/// A direction uniform on the cap of height `height = 1 − cos α ∈ (0, 2]` about +z, from [`cap_height`].
///
/// `u.x` runs from the pole to the rim, `u.y` around. Density `1/(2π height)`, the area's inverse (Archimedes).
///
/// ```
/// use glam::{Vec2, Vec3};
/// use glimt_sampling::warp::sample_cap;
/// assert_eq!(sample_cap(Vec2::ZERO, 0.1).direction, Vec3::Z);
/// assert_eq!(sample_cap(Vec2::new(0.5, 0.3), 0.5).direction.z, 0.75);
/// ```
#[inline]
#[must_use]
pub fn sample_cap(u: Vec2, height: f32) -> DirectionSample {
    let h = u.x * height;
    // sin²θ = (1 − z)(1 + z), with no difference of nearly equal numbers.
    let sin_theta = libm::sqrtf((h * (2.0 - h)).max(0.0));
    let around = cos_sin_turns(u.y);
    DirectionSample {
        direction: Vec3::new(sin_theta * around.x, sin_theta * around.y, 1.0 - h),
        pdf_sr: 0.5 * FRAC_1_PI / height,
    }
}

/// Cosine and sine of an angle in turns, in `[0, 1]`; halved to ±1/2 first, where a GPU's sine is at its best.
#[inline]
fn cos_sin_turns(turns: f32) -> Vec2 {
    let signed = if turns < 0.5 { turns } else { turns - 1.0 };
    let phi = TAU * signed;
    Vec2::new(libm::cosf(phi), libm::sinf(phi))
}

/// `1 − cos θ` of a unit vector, precise near the pole.
#[inline]
fn height_of(direction: Vec3) -> f32 {
    if direction.z > 0.0 {
        (direction.x * direction.x + direction.y * direction.y) / (1.0 + direction.z)
    } else {
        1.0 - direction.z
    }
}

/// `ln cos θ` of a unit vector above the horizon, precise near the pole too, where the rounding of `z` would be raised
/// to a large power.
#[inline]
fn ln_cos_theta(direction: Vec3) -> f32 {
    let h = height_of(direction);
    if h < 0.1 {
        let tail = 1.0 / 3.0 + h * (0.25 + h * (0.2 + h * (1.0 / 6.0 + h / 7.0)));
        return 0.0 - h * (1.0 + h * (0.5 + h * tail));
    }
    libm::logf(direction.z)
}

/// Density of [`sample_cap`], in 1/sr: `1/(2π height)` inside the cap, 0 outside.
#[inline]
#[must_use]
pub fn pdf_cap_sr(direction: Vec3, height: f32) -> f32 {
    if height_of(direction) <= height {
        0.5 * FRAC_1_PI / height
    } else {
        0.0
    }
}

/// Azimuth in turns, in `[0, 1)`, counter-clockwise from +x; 0 at the poles.
#[inline]
fn turns_of(direction: Vec3) -> f32 {
    if direction.x == 0.0 && direction.y == 0.0 {
        return 0.0;
    }
    let turns = 0.5 * FRAC_1_PI * libm::atan2f(direction.y, direction.x);
    let turns = if turns < 0.0 { turns + 1.0 } else { turns };
    // A tiny negative angle rounds to a whole turn.
    if turns < 1.0 { turns } else { 0.0 }
}

/// The point of `[0, 1]²` that [`sample_cap`] maps to `direction`, which must lie in the cap.
#[inline]
#[must_use]
pub fn invert_cap(direction: Vec3, height: f32) -> Vec2 {
    Vec2::new(
        (height_of(direction) / height).clamp(0.0, 1.0),
        turns_of(direction),
    )
}

/// A direction of the upper hemisphere with density `(e + 1)/2π · cosᵉ θ`, `e ≥ 0` (Phong's lobe; Lafortune and Willems
/// 1994): `cos θ = u.x^(1/(e + 1))`, azimuth from `u.y`.
///
/// `u.x = 0` is the horizon, whose density is 0 unless `e = 0`.
///
/// ```
/// use glam::Vec2;
/// use glimt_sampling::warp::sample_power_cosine;
/// let s = sample_power_cosine(Vec2::new(0.125, 0.0), 2.0);
/// assert!((s.direction.z - 0.5).abs() < 1e-6);
/// assert!((s.pdf_sr - 3.0 * 0.25 / core::f32::consts::TAU).abs() < 1e-6);
/// ```
#[inline]
#[must_use]
pub fn sample_power_cosine(u: Vec2, exponent: f32) -> DirectionSample {
    if u.x <= 0.0 {
        return DirectionSample {
            direction: Vec3::X,
            pdf_sr: pdf_power_cosine_sr(Vec3::X, exponent),
        };
    }
    // cos²θ = exp(−t) with t = −2 ln u/(e + 1). For a narrow lobe t is small, and sin²θ = 1 − exp(−t) is taken by its
    // series: f32 cosines near 1 are too coarse to place a highlight. Near the horizon it is the cosine that is small.
    let t = 2.0 / (exponent + 1.0) * (0.0 - libm::logf(u.x));
    let sin2_theta;
    let cos_theta;
    if t < 0.25 {
        let tail = 1.0 / 6.0 - t * (1.0 / 24.0 - t * (1.0 / 120.0 - t / 720.0));
        sin2_theta = (t * (1.0 - t * (0.5 - t * tail))).max(0.0);
        cos_theta = libm::sqrtf(1.0 - sin2_theta);
    } else {
        cos_theta = libm::expf(-0.5 * t);
        sin2_theta = 1.0 - cos_theta * cos_theta;
    }
    let sin_theta = libm::sqrtf(sin2_theta);
    let around = cos_sin_turns(u.y);
    let direction = Vec3::new(sin_theta * around.x, sin_theta * around.y, cos_theta);
    DirectionSample {
        direction,
        pdf_sr: pdf_power_cosine_sr(direction, exponent),
    }
}

/// Density of [`sample_power_cosine`], in 1/sr: `(e + 1)/2π · cosᵉ θ`, 0 below the horizon.
#[inline]
#[must_use]
pub fn pdf_power_cosine_sr(direction: Vec3, exponent: f32) -> f32 {
    let normalisation = (exponent + 1.0) * (0.5 * FRAC_1_PI);
    if exponent <= 0.0 {
        return if direction.z >= 0.0 {
            normalisation
        } else {
            0.0
        };
    }
    if direction.z <= 0.0 {
        return 0.0;
    }
    normalisation * libm::expf(exponent * ln_cos_theta(direction))
}

/// The point of `[0, 1]²` that [`sample_power_cosine`] maps to `direction`, which must not be below the horizon:
/// `u.x = cosᵉ⁺¹ θ`.
#[inline]
#[must_use]
pub fn invert_power_cosine(direction: Vec3, exponent: f32) -> Vec2 {
    let u = if direction.z > 0.0 {
        libm::expf((exponent + 1.0) * ln_cos_theta(direction)).min(1.0)
    } else {
        0.0
    };
    Vec2::new(u, turns_of(direction))
}
