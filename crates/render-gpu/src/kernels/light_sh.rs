//! Shared file: a frame's light as spherical harmonics, made of the sums over its map (Hajisharif 2012, Eqs. 9 to 13).

use glam::{Vec2, Vec3, Vec4};
use glimt_sh::{
    coefficient_band, coefficient_index, coefficient_order, hann, rotate_z, temporal_filter,
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
