//! Host file: a mirror ball in f64, written from the geometry alone.

use glam::{DVec2, DVec3};

/// The direction that the image point `p` (in units of the outline's radius, y down) shows, by intersecting a ray with a
/// sphere and reflecting it; `None` off the ball.
///
/// `axes` are unit vectors of the world: from the camera to the ball's centre, to the right in the image, up in the image.
/// `radius_over_distance` lies in [0, 1); where it is 0, rays are parallel.
#[must_use]
pub fn reflected(axes: [DVec3; 3], radius_over_distance: f64, p: DVec2) -> Option<DVec3> {
    let [f, r, u] = axes;
    let ratio = radius_over_distance;
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
