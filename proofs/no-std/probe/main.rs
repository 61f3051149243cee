//! Host file: `glimt-probe` linked alone, without std and alloc.

#![no_std]
#![no_main]

#[path = "../rt.rs"]
mod rt;

use core::hint::black_box;
use glam::{UVec2, Vec3};
use glimt_probe::latlong;

/// A direction comes back from the texel that it falls into, and all texels together are the sphere.
fn is_right() -> bool {
    let size = black_box(UVec2::new(64, 32));
    let direction = black_box(Vec3::new(0.48, -0.6, 0.64));
    let texel = latlong::direction_to_texel(direction, size);
    let close = latlong::texel_direction(texel, size).dot(direction) > 0.99;
    let mut sphere = 0.0;
    for row in 0..size.y {
        sphere += size.x as f32 * latlong::texel_solid_angle_sr(row, size);
    }
    close && (sphere - 4.0 * core::f32::consts::PI).abs() < 1e-4
}
