//! Shared file: a light map as spherical harmonics (Hajisharif 2012, Eqs. 9 to 13): the factors of its projection, and the
//! frame's coefficients made of the sums.

use glam::{UVec2, Vec2, Vec3, Vec4};
use glimt_probe::latlong::texel_solid_angle_sr;
use glimt_probe::trig::cos_sin_pi;
use glimt_sh::{
    coefficient_band, coefficient_index, coefficient_order, hann, meridian, ring, rotate_z,
    temporal_filter,
};

/// How sums over a map become the light of a frame. 32 bytes.
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct LightParams {
    /// Cosine and sine of the angle by which the map is turned, counter-clockwise seen from above.
    pub rotation: Vec2,
    /// Width of the Hann window; 0 for none.
    pub window: f32,
    /// α of the filter over time; 0 in the first frame.
    pub temporal: f32,
    /// Bands n, 1 to 6.
    pub bands: u32,
    /// Fills 16 bytes.
    pub unused_a: u32,
    /// Fills 16 bytes.
    pub unused_b: u32,
    /// Fills 16 bytes.
    pub unused_c: u32,
}

/// The factors of φ, [`ring`], at the centre of column `column` of a map that has `width`.
#[inline]
#[must_use]
pub fn column_ring(column: u32, width: u32) -> [f32; 11] {
    let phi = cos_sin_pi(1.0 - (2 * column + 1) as f32 / width as f32);
    ring(phi.x, phi.y)
}

/// The factors of θ, [`meridian`], at the centre of row `row` of a map of size `size`.
#[inline]
#[must_use]
pub fn row_meridian(row: u32, size: UVec2) -> [f32; 21] {
    let theta = cos_sin_pi((2 * row + 1) as f32 / (2 * size.y) as f32);
    meridian(theta.x, theta.y)
}

/// Solid angle of a texel of row `row`: `Δφ (cos θ₀ − cos θ₁)`. Differs from Eq. 12, which takes `2π² sin θ/(n_u n_v)`.
#[inline]
#[must_use]
pub fn row_area(row: u32, size: UVec2) -> f32 {
    texel_solid_angle_sr(row, size)
}

/// Coefficient k = l(l + 1) + m of a frame's light in world coordinates: the sums `Σ L y_k ΔΩ` over the map, turned with it,
/// windowed, and filtered over time with the filtered ones of the frame before (Eq. 13). 0 beyond n² of them.
#[must_use]
pub fn light_coefficient(k: u32, light: &LightParams, sums: &[Vec4], previous: &[Vec4]) -> Vec4 {
    if k >= light.bands * light.bands {
        return Vec4::ZERO;
    }
    // What goes with cos mφ and what goes with sin mφ turn into each other.
    let (l, m) = (coefficient_band(k), coefficient_order(k));
    let own = sums[k as usize];
    let opposite = sums[coefficient_index(l, -m) as usize];
    let turned = Vec3::new(
        rotate_z(m, own.x, opposite.x, light.rotation),
        rotate_z(m, own.y, opposite.y, light.rotation),
        rotate_z(m, own.z, opposite.z, light.rotation),
    );
    let now = turned * hann(l, light.window);
    let before = previous[k as usize];
    Vec4::new(
        temporal_filter(now.x, before.x, light.temporal),
        temporal_filter(now.y, before.y, light.temporal),
        temporal_filter(now.z, before.z, light.temporal),
        0.0,
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn layout_is_that_of_wgsl() {
        assert_eq!(core::mem::size_of::<LightParams>(), 32);
        assert_eq!(core::mem::offset_of!(LightParams, window), 8);
        assert_eq!(core::mem::offset_of!(LightParams, bands), 16);
    }
}
