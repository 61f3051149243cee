//! Shared file: light by precomputed radiance transfer (Hajisharif 2012, Eqs. 2, 14 and 15).

use core::f32::consts::FRAC_1_PI;

use glam::{Vec3, Vec4};

use super::environment::RadianceMap;
use super::estimator::Reflected;
use super::frame::FrameParams;
use super::ray::{Hit, Ray};
use super::scene::{Scene, ShadingPoint};
use super::shade::RaySample;

/// Irradiance at a vertex by band-limited light, parted like [`Reflected`]. Either part may be negative, as band-limited
/// light may. 32 bytes.
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct VertexLight {
    /// By the light that arrives.
    pub lit: Vec3,
    /// Fills 16 bytes.
    pub unused_a: f32,
    /// By the light that objects keep away.
    pub blocked: Vec3,
    /// Fills 16 bytes.
    pub unused_b: f32,
}

/// How triangles are joined to the vertices whose light is known.
#[derive(Clone, Copy, Debug)]
pub struct Surface<'a> {
    /// The vertex of each corner, three for each triangle of the scene.
    pub corner_vertices: &'a [u32],
    /// Weight c_k of the mirror reflection, in [0, 1], for each object (Eq. 15).
    pub reflections: &'a [f32],
    /// Light of each vertex.
    pub lights: &'a [VertexLight],
}

/// Light of the vertex `vertex`: the product of the light's coefficients and the transfer's (Eq. 14, without the albedo),
/// without shadows where `shadows` is 0. Each vertex has `coefficients` of them.
///
/// Since interpolation across a triangle is linear, interpolating these gives what interpolated coefficients would.
#[must_use]
pub fn vertex_light(
    vertex: u32,
    coefficients: u32,
    shadows: u32,
    light: &[Vec4],
    lit: &[f32],
    blocked: &[f32],
) -> VertexLight {
    let first = vertex * coefficients;
    let mut arrives = Vec3::ZERO;
    let mut kept_away = Vec3::ZERO;
    for k in 0..coefficients {
        let radiance = light[k as usize].truncate();
        arrives += radiance * lit[(first + k) as usize];
        kept_away += radiance * blocked[(first + k) as usize];
    }
    if shadows == 0 {
        arrives += kept_away;
        kept_away = Vec3::ZERO;
    }
    VertexLight {
        lit: arrives,
        unused_a: 0.0,
        blocked: kept_away,
        unused_b: 0.0,
    }
}

/// Radiance of a diffuse surface of albedo `albedo` under irradiance `lit`, and what `blocked` would add:
/// `L = albedo/π Σ c^L c^T` (Eq. 14).
///
/// Light below zero counts as none, and shadows take no more than there is. Where `blocked` is 0, so is what is blocked.
#[inline]
#[must_use]
pub fn diffuse(albedo: Vec3, lit: Vec3, blocked: Vec3) -> Reflected {
    let arrives = lit.max(Vec3::ZERO);
    let all = (lit + blocked).max(Vec3::ZERO);
    let scale = albedo * FRAC_1_PI;
    Reflected {
        lit: arrives * scale,
        blocked: (all - arrives).max(Vec3::ZERO) * scale,
    }
}

/// Light that a shading point sends back to the eye: its diffuse part, and, weighed by the object's c_k, the light map in the
/// mirror direction (Eq. 15).
#[inline]
#[must_use]
pub fn reflected(
    point: &ShadingPoint,
    lit: Vec3,
    blocked: Vec3,
    reflection: f32,
    map: RadianceMap<'_>,
) -> Reflected {
    let mut light = diffuse(point.brdf.diffuse, lit, blocked);
    if reflection > 0.0 {
        let wo = point.wo;
        let mirror = point.frame.to_world(Vec3::new(-wo.x, -wo.y, wo.z));
        light.lit += map.background(mirror) * reflection;
    }
    light
}

impl Surface<'_> {
    /// Light at a hit, interpolated from the triangle's corners.
    #[inline]
    #[must_use]
    pub fn light_at(&self, hit: &Hit) -> VertexLight {
        let first = 3 * hit.triangle as usize;
        let a = &self.lights[self.corner_vertices[first] as usize];
        let b = &self.lights[self.corner_vertices[first + 1] as usize];
        let c = &self.lights[self.corner_vertices[first + 2] as usize];
        let (u, v) = (hit.barycentrics.x, hit.barycentrics.y);
        let w = 1.0 - u - v;
        VertexLight {
            lit: a.lit * w + b.lit * u + c.lit * v,
            unused_a: 0.0,
            blocked: a.blocked * w + b.blocked * u + c.blocked * v,
            unused_b: 0.0,
        }
    }

    /// Weight of the mirror reflection of the object that is hit.
    #[inline]
    #[must_use]
    pub fn reflection(&self, object: u32) -> f32 {
        self.reflections[object as usize]
    }
}

/// What the tile's ray `ray` shows by precomputed transfer.
#[must_use]
pub fn shade_prt<S: RaySample>(
    ray: u32,
    frame: &FrameParams,
    map: RadianceMap<'_>,
    scene: Scene<'_>,
    surface: Surface<'_>,
) -> S {
    let camera_ray = frame.camera_ray(&frame.pattern_of(ray));
    if let Some(hit) = scene.closest_hit(&camera_ray) {
        let light = at_hit(&camera_ray, &hit, map, scene, surface);
        let is_catcher = scene.triangles[hit.triangle as usize].is_catcher();
        return S::of_surface(&light, is_catcher);
    }
    S::of_background(&camera_ray, frame, map)
}

/// What the surface that a ray hits sends back along it.
#[inline]
#[must_use]
pub fn at_hit(
    ray: &Ray,
    hit: &Hit,
    map: RadianceMap<'_>,
    scene: Scene<'_>,
    surface: Surface<'_>,
) -> Reflected {
    let point = scene.shading_point(ray, hit);
    let triangle = &scene.triangles[hit.triangle as usize];
    let at = surface.light_at(hit);
    let c_k = surface.reflection(triangle.object_index());
    let mut light = reflected(&point, at.lit, at.blocked, c_k, map);
    if !triangle.is_catcher() {
        light.lit += point.emission;
    }
    light
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn layout_is_that_of_wgsl() {
        assert_eq!(core::mem::size_of::<VertexLight>(), 32);
        assert_eq!(core::mem::offset_of!(VertexLight, blocked), 16);
    }

    #[test]
    fn shadows_take_no_more_than_there_is() {
        let one = Vec3::ONE * core::f32::consts::PI;
        let at = |lit: f32, blocked: f32| {
            let light = diffuse(one, Vec3::splat(lit), Vec3::splat(blocked));
            (light.lit.x, light.blocked.x)
        };
        let near = |(a, b): (f32, f32), (c, d): (f32, f32)| {
            assert!(
                (a - c).abs() < 1e-6 && (b - d).abs() < 1e-6,
                "{a} {b}, not {c} {d}"
            );
        };
        near(at(2.0, 1.0), (2.0, 1.0));
        // The ripples of band-limited light: below zero, and brighter in the shadow.
        near(at(-1.0, 3.0), (0.0, 2.0));
        near(at(2.0, -1.0), (2.0, 0.0));
        near(at(-1.0, 0.5), (0.0, 0.0));
        assert_eq!(at(0.3, 0.0).1, 0.0);
        assert_eq!(at(-0.3, 0.0).1, 0.0);
    }
}
