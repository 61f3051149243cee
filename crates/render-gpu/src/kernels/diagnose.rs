//! Shared file: kernels that return one stage of [`shade`](super::shade) each, so that tests can compare processors
//! stage by stage. One element is one ray, and each stage is fed by the shipped functions.

use glam::{UVec2, UVec4, Vec2, Vec3, Vec4};
use glimt_sampling::uniform::unit_vec2;

use super::environment::Environment;
use super::frame::FrameParams;
use super::mis::Mis;
use super::pattern::{BRDF, ENVIRONMENT, FILM};
use super::scene::Scene;

/// An environment sample. 32 bytes.
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct EnvRecord {
    /// Its direction in the world.
    pub direction: Vec3,
    /// Its density in 1/sr.
    pub pdf_sr: f32,
    /// The texel it was drawn from.
    pub texel: UVec2,
    /// The texel that its direction falls into.
    pub looked_up: UVec2,
}

/// A primary hit. 16 bytes.
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct HitRecord {
    /// Barycentric weights of the second and third corner; 0 for a miss.
    pub barycentrics: Vec2,
    /// Distance from the eye; 0 for a miss.
    pub t: f32,
    /// The triangle; [`u32::MAX`] for a miss.
    pub triangle: u32,
}

/// A shading point. 64 bytes, all 0 for a miss.
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct SurfaceRecord {
    /// Where shadow rays start.
    pub origin: Vec3,
    /// Blinn-Phong exponent.
    pub exponent: f32,
    /// Shading normal.
    pub normal: Vec3,
    /// Cosine between the geometric normal and the direction to the eye.
    pub facing: f32,
    /// Diffuse albedo.
    pub diffuse: Vec3,
    /// 1 for a hit.
    pub hit: f32,
    /// Specular albedo.
    pub specular: Vec3,
    /// Fills 16 bytes.
    pub unused: f32,
}

/// One uniform for the film and three for the BRDF.
#[must_use]
pub fn uniforms(ray: u32, frame: &FrameParams, mis: &Mis) -> UVec4 {
    let pattern = frame.pattern_of(ray);
    let film = pattern.pair(FILM, 0, 1);
    let brdf = pattern.triple(BRDF, 0, mis.brdf_samples);
    UVec4::new(film.x, brdf.x, brdf.y, brdf.z)
}

/// The ray's first environment sample.
#[must_use]
pub fn env_sample(ray: u32, frame: &FrameParams, mis: &Mis, env: Environment<'_>) -> EnvRecord {
    let pattern = frame.pattern_of(ray);
    let u = pattern.pair(ENVIRONMENT, 0, mis.env_samples);
    let sample = env.sample(u);
    EnvRecord {
        direction: sample.direction,
        pdf_sr: sample.pdf_sr,
        texel: sample.texel,
        looked_up: env.texel(sample.direction),
    }
}

/// What the ray hits first.
#[must_use]
pub fn primary_hit(ray: u32, frame: &FrameParams, scene: Scene<'_>) -> HitRecord {
    let camera_ray = frame.camera_ray(&frame.pattern_of(ray));
    if let Some(hit) = scene.closest_hit(&camera_ray) {
        HitRecord {
            barycentrics: hit.barycentrics,
            t: hit.t,
            triangle: hit.triangle,
        }
    } else {
        HitRecord {
            barycentrics: Vec2::ZERO,
            t: 0.0,
            triangle: u32::MAX,
        }
    }
}

/// The shading point of the ray's hit.
#[must_use]
pub fn surface(ray: u32, frame: &FrameParams, scene: Scene<'_>) -> SurfaceRecord {
    let camera_ray = frame.camera_ray(&frame.pattern_of(ray));
    if let Some(hit) = scene.closest_hit(&camera_ray) {
        let point = scene.shading_point(&camera_ray, &hit);
        SurfaceRecord {
            origin: point.origin,
            exponent: point.brdf.exponent,
            normal: point.frame.n,
            facing: -point.geometric_normal.dot(camera_ray.direction),
            diffuse: point.brdf.diffuse,
            hit: 1.0,
            specular: point.brdf.specular,
            unused: 0.0,
        }
    } else {
        SurfaceRecord {
            origin: Vec3::ZERO,
            exponent: 0.0,
            normal: Vec3::ZERO,
            facing: 0.0,
            diffuse: Vec3::ZERO,
            hit: 0.0,
            specular: Vec3::ZERO,
            unused: 0.0,
        }
    }
}

/// The ray's first BRDF sample in local coordinates, with its density in 1/sr; 0 for a miss.
#[must_use]
pub fn brdf_sample(ray: u32, frame: &FrameParams, mis: &Mis, scene: Scene<'_>) -> Vec4 {
    let pattern = frame.pattern_of(ray);
    let camera_ray = frame.camera_ray(&pattern);
    if let Some(hit) = scene.closest_hit(&camera_ray) {
        let point = scene.shading_point(&camera_ray, &hit);
        let u = pattern.triple(BRDF, 0, mis.brdf_samples);
        let sample = point.brdf.sample(point.wo, u.z, unit_vec2(u.truncate()));
        return sample.wi.extend(sample.pdf_sr);
    }
    Vec4::ZERO
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn layout_is_that_of_wgsl() {
        assert_eq!(core::mem::size_of::<EnvRecord>(), 32);
        assert_eq!(core::mem::offset_of!(EnvRecord, texel), 16);
        assert_eq!(core::mem::size_of::<HitRecord>(), 16);
        assert_eq!(core::mem::size_of::<SurfaceRecord>(), 64);
        assert_eq!(core::mem::offset_of!(SurfaceRecord, normal), 16);
        assert_eq!(core::mem::offset_of!(SurfaceRecord, diffuse), 32);
        assert_eq!(core::mem::offset_of!(SurfaceRecord, specular), 48);
    }
}
