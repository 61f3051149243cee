//! Shared file: pass 1 of rendering (Kronander 2014, § 7): one element is one ray.

use glam::Vec4;

use super::environment::Environment;
use super::environment::RadianceMap;
use super::estimator::{Estimator, Reflected};
use super::frame::{Background, FrameParams};
use super::layers::LayerSample;
use super::ray::Ray;
use super::scene::Scene;

/// What one ray shows, as a pass writes it.
pub trait RaySample {
    /// A surface that reflects this light; `is_catcher` says whether it stands for something in the footage.
    fn of_surface(light: &Reflected, is_catcher: bool) -> Self;

    /// The background.
    fn of_background(ray: &Ray, frame: &FrameParams, map: RadianceMap<'_>) -> Self;
}

/// Radiance with alpha, which is 1 on objects and before a visible background.
impl RaySample for Vec4 {
    #[inline]
    fn of_surface(light: &Reflected, _is_catcher: bool) -> Vec4 {
        light.lit.extend(1.0)
    }

    #[inline]
    fn of_background(ray: &Ray, frame: &FrameParams, map: RadianceMap<'_>) -> Vec4 {
        if frame.background == Background::Environment {
            return map.background(ray.direction).extend(1.0);
        }
        Vec4::ZERO
    }
}

/// Objects and catchers apart. The same samples tell a catcher's light with and without the objects.
impl RaySample for LayerSample {
    #[inline]
    fn of_surface(light: &Reflected, is_catcher: bool) -> LayerSample {
        LayerSample::of(light, is_catcher)
    }

    #[inline]
    fn of_background(_ray: &Ray, _frame: &FrameParams, _map: RadianceMap<'_>) -> LayerSample {
        LayerSample::NOTHING
    }
}

/// What the tile's ray `ray` shows, by an estimator that keeps nothing between frames.
#[must_use]
pub fn shade<E: Estimator, S: RaySample>(
    ray: u32,
    frame: &FrameParams,
    estimator: &E,
    env: Environment<'_>,
    scene: Scene<'_>,
) -> S {
    let pattern = frame.pattern_of(ray);
    let camera_ray = frame.camera_ray(&pattern);
    if let Some(hit) = scene.closest_hit(&camera_ray) {
        let point = scene.shading_point(&camera_ray, &hit);
        let mut light = estimator.reflected(&point, &pattern, env, scene);
        let is_catcher = scene.triangles[hit.triangle as usize].is_catcher();
        if !is_catcher {
            light.lit += point.emission;
        }
        return S::of_surface(&light, is_catcher);
    }
    S::of_background(&camera_ray, frame, env.map())
}
