//! Shared file: directions over the whole sphere, one in each of its equal parts.

use glam::{UVec2, Vec2, Vec3};
use glimt_sampling::warp::sample_uniform_sphere;

/// Direction (unit length) in part `i` of the sphere's `strata.x · strata.y` parts of equal area: `strata.x` rings of
/// equal height from +z to −z, each cut into `strata.y` from +x counter-clockwise. `u ∈ [0, 1)²` places it in its part.
///
/// With uniform `u` it estimates integrals without bias: Hajisharif 2012 takes 10 × 10 to 50 × 50 for a transfer (Eq. 8).
/// Numbers beyond the last begin again; no parts count as one.
///
/// ```
/// use glam::{UVec2, Vec2};
/// use glimt_sh::stratified_direction;
/// let d = stratified_direction(0, UVec2::new(2, 4), Vec2::new(0.5, 0.5));
/// assert!((d.z - 0.5).abs() < 1e-6 && (d.x - d.y).abs() < 1e-6 && d.x > 0.0);
/// ```
#[inline]
#[must_use]
pub fn stratified_direction(i: u32, strata: UVec2, u: Vec2) -> Vec3 {
    let strata = strata.max(UVec2::ONE);
    let part = Vec2::new((i / strata.y % strata.x) as f32, (i % strata.y) as f32);
    sample_uniform_sphere((part + u) / strata.as_vec2()).direction
}
