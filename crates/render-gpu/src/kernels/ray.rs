//! Shared file: rays and what they hit.

use glam::{Vec2, Vec3};

/// A half-line, with what the traversal needs of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// Where it starts.
    pub origin: Vec3,
    /// Where it goes; of any length but zero. Distances along the ray are in units of this length.
    pub direction: Vec3,
    /// One over each component of `direction`, of which none counts as nearer to zero than [`Ray::SMALLEST`].
    pub inverse_direction: Vec3,
    /// What decides, with a triangle's number, whether the ray passes a surface that lets light through: equal rays with equal keys
    /// pass the same surfaces.
    pub key: u32,
}

/// What a ray hits first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// Index of the triangle.
    pub triangle: u32,
    /// Distance along the ray.
    pub t: f32,
    /// Barycentric weights of the triangle's second and third corner.
    pub barycentrics: Vec2,
}

impl Ray {
    /// Components of a direction nearer to zero count as this in box tests, so that no infinity appears.
    pub const SMALLEST: f32 = 1e-18;

    /// The ray from `origin` towards `direction`, with the key 0.
    #[inline]
    #[must_use]
    pub fn new(origin: Vec3, direction: Vec3) -> Ray {
        Ray::keyed(origin, direction, 0)
    }

    /// The ray from `origin` towards `direction`, with a key.
    #[inline]
    #[must_use]
    pub fn keyed(origin: Vec3, direction: Vec3, key: u32) -> Ray {
        Ray {
            origin,
            direction,
            inverse_direction: Vec3::new(
                inverse(direction.x),
                inverse(direction.y),
                inverse(direction.z),
            ),
            key,
        }
    }
}

#[inline]
fn inverse(x: f32) -> f32 {
    1.0 / x.abs().max(Ray::SMALLEST).copysign(x)
}
