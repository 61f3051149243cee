//! Host file: a mirror ball in f64, written from the geometry alone, and photographs of it.

use glam::{DVec2, DVec3, UVec2, Vec2, Vec4};
use glimt_probe::mirror_ball::MirrorBall;
use glimt_probe::unwarp::Outline;

/// The direction that the image point `p` (in units of the outline's radius, y down) shows, by intersecting a ray with a
/// sphere and reflecting it; `None` off the ball. Where r/D is 0 rays are parallel.
#[must_use]
pub fn reflected(ball: &MirrorBall, p: DVec2) -> Option<DVec3> {
    let [f, r, u] = [ball.forward, ball.right, ball.up].map(|v| v.as_dvec3());
    let ratio = f64::from(ball.radius_over_distance);
    let aside = r * p.x - u * p.y;
    let (origin, ray) = if ratio > 0.0 {
        // The eye at distance 1 from the centre of a ball of radius `ratio`.
        let tangent = ratio / (1.0 - ratio * ratio).sqrt();
        (-f / ratio, (f + aside * tangent).normalize())
    } else {
        (aside - 2.0 * f, f)
    };
    // |origin + t ray| = 1, in units of the ball's radius about its centre.
    let b = origin.dot(ray);
    let discriminant = b * b - (origin.length_squared() - 1.0);
    if discriminant < 0.0 {
        return None;
    }
    let normal = origin + ray * (-b - discriminant.sqrt());
    Some(ray - 2.0 * ray.dot(normal) * normal)
}

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
            sum += reflected(ball, p).map_or(beside, &radiance);
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
