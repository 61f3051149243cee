//! Shared file: what the stages of drawing and projecting call, as kernels of their own.

use glam::{UVec2, Vec2, Vec4};
use glimt_probe::latlong::texel_solid_angle_sr;
use glimt_render_gpu::kernels::prt::Surface;
use glimt_render_gpu::kernels::raster::{
    RasterParams, clip_position, corner_position, corner_weights, draw,
};
use glimt_render_gpu::kernels::scene::Scene;
use glimt_sh::separable::{column_ring, row_meridian};

/// Corner `id`, in the clip's coordinates, and what its triangle shows between that corner and its middle.
#[must_use]
pub fn drawn(
    id: u32,
    raster: &RasterParams,
    texels: &[Vec4],
    scene: Scene<'_>,
    surface: Surface<'_>,
) -> [Vec4; 4] {
    let place = clip_position(&raster.frame, raster.near, corner_position(id, scene));
    let weights = (corner_weights(id) + Vec2::splat(0.5)) / 2.5;
    let shown = draw(id / 3, weights, raster, texels, scene, surface);
    [place, shown.object, shown.lit, shown.blocked]
}

/// The factors of texel `id` of a map.
#[must_use]
pub fn factors(id: u32, size: UVec2) -> [f32; 33] {
    let of_phi = column_ring(id % size.x, size.x);
    let of_theta = row_meridian(id / size.x, size);
    let mut out = [texel_solid_angle_sr(id / size.x, size); 33];
    for i in 0..11 {
        out[i as usize] *= of_phi[i as usize];
    }
    for i in 0..21 {
        out[(11 + i) as usize] *= of_theta[i as usize];
    }
    out
}
