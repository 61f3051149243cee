//! Host file: `glimt-probe` linked alone, without std and alloc.

#![no_std]
#![no_main]

#[path = "../rt.rs"]
mod rt;

use core::hint::black_box;
use glam::{UVec2, Vec2, Vec3};
use glimt_probe::latlong;
use glimt_probe::mirror_ball::MirrorBall;
use glimt_probe::unwarp::{Outline, Unwarp, corner};

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
    close && unwarps() && (sphere - 4.0 * core::f32::consts::PI).abs() < 1e-4
}

/// A texel of an unwarped ball takes pixels from within its outline.
fn unwarps() -> bool {
    let ball = MirrorBall::new(Vec3::X, Vec3::Z, black_box(0.04));
    let outline = Outline {
        centre: Vec2::splat(50.0),
        radius: 40.0,
    };
    let size = UVec2::new(16, 8);
    let Ok(unwarp) = Unwarp::new(ball, outline, UVec2::splat(100), size, 1.5) else {
        return false;
    };
    let texel = black_box(UVec2::new(3, 4));
    let at = |x, y| corner(&ball, texel + UVec2::new(x, y), size);
    let (mut count, mut inside) = (0, true);
    unwarp.texel(texel, [at(0, 0), at(1, 0), at(0, 1), at(1, 1)], |tap| {
        count += 1;
        inside &= (tap.pixel.as_vec2() + 0.5).distance(outline.centre) < outline.radius;
    });
    count > 0 && inside
}
