//! Shared file: surfaces that let light pass (glTF's alpha modes `MASK` and `BLEND`).

use glimt_sampling::hash::hash2;
use glimt_sampling::uniform::unit_f32;

use super::material::{Attributes, MaterialView};
use super::ray::Ray;
use super::scene::MIRRORED;
use super::triangle::{Triangle, barycentrics};

/// Alpha of triangle `index` where the ray crosses it: of a mask 0 or 1, else the share of light that it keeps away.
#[inline]
#[must_use]
pub fn alpha_at(triangle: &Triangle, surface: &[u32], u: f32, v: f32) -> f32 {
    let attributes = Attributes::at(surface, triangle.attributes, u, v);
    let material = MaterialView::new(surface, triangle.material & !MIRRORED);
    material.alpha(attributes.uv, attributes.color.w)
}

/// Whether a path with this key passes triangle `index` where that has this alpha: with probability `1 − alpha`, decided by the key and
/// the triangle's number.
///
/// So the mean over keys is light times `1 − alpha` of each surface on the way, whatever order a tree visits them in.
#[inline]
#[must_use]
pub fn passes(key: u32, index: u32, alpha: f32) -> bool {
    unit_f32(hash2(key, index)) >= alpha
}

/// Whether the ray [passes] triangle `index`, which it is known to hit.
#[inline]
#[must_use]
pub fn is_passed(index: u32, triangle: &Triangle, surface: &[u32], ray: &Ray) -> bool {
    let weights = barycentrics(triangle, ray);
    let alpha = alpha_at(triangle, surface, weights.x, weights.y);
    passes(ray.key, index, alpha)
}
