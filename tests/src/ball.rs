//! Host file: photographs of a mirror ball in f64.

use glam::{DVec3, UVec2, Vec2, Vec4};
use glimt_probe::mirror_ball::MirrorBall;
use glimt_probe::unwarp::Outline;
use glimt_statistics::mirror_ball::reflected;

/// A photograph of `size` pixels of the ball under the light `radiance`, each pixel the mean of `side`² points; what is
/// beside the ball has the radiance `beside`.
pub fn photograph(
    ball: &MirrorBall,
    outline: &Outline,
    size: UVec2,
    side: u32,
    beside: Vec4,
    radiance: impl Fn(DVec3) -> Vec4 + Sync,
) -> Vec<Vec4> {
    use rayon::prelude::*;
    let axes = [ball.forward, ball.right, ball.up].map(|v| v.as_dvec3());
    let ratio = f64::from(ball.radius_over_distance);
    let centre = outline.centre.as_dvec2();
    let radius = f64::from(outline.radius);
    let pixel = |i: u32| {
        let corner = UVec2::new(i % size.x, i / size.x).as_dvec2();
        let middle = (corner + 0.5 - centre).length() / radius;
        if middle > 1.0 + 2.0 / radius {
            return beside;
        }
        let mut sum = Vec4::ZERO;
        for s in 0..side * side {
            let inside = (UVec2::new(s % side, s / side).as_dvec2() + 0.5) / f64::from(side);
            let p = (corner + inside - centre) / radius;
            sum += reflected(axes, ratio, p).map_or(beside, &radiance);
        }
        sum / (side * side) as f32
    };
    (0..size.x * size.y).into_par_iter().map(pixel).collect()
}

/// `ball` as filmed by a camera that rolls: its image turned counter-clockwise by `roll` radians.
#[must_use]
pub fn rolled(ball: &MirrorBall, roll: f32) -> MirrorBall {
    let (sin, cos) = roll.sin_cos();
    ball.image_turned(Vec2::new(cos, sin))
}
