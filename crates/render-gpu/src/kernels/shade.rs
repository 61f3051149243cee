//! Shared file: pass 1 of rendering (Kronander 2014, § 7): one element is one ray.

use glam::Vec4;

use super::bis::Bis;
use super::environment::Environment;
use super::estimator::Estimator;
use super::frame::{BACKGROUND_ENVIRONMENT, FrameParams};
use super::layers::LayerSample;
use super::mis::Mis;
use super::scene::Scene;

/// Radiance along the tile's ray `ray`, with alpha, by multiple importance sampling.
#[must_use]
pub fn shade_mis(ray: u32, frame: &FrameParams, env: Environment<'_>, scene: Scene<'_>) -> Vec4 {
    shade(ray, frame, env, scene, &mis(frame))
}

/// What the tile's ray `ray` shows in a scene with catchers, by multiple importance sampling.
#[must_use]
pub fn shade_mis_layers(
    ray: u32,
    frame: &FrameParams,
    env: Environment<'_>,
    scene: Scene<'_>,
) -> LayerSample {
    shade_layers(ray, frame, env, scene, &mis(frame))
}

/// Radiance along the tile's ray `ray`, with alpha, by bidirectional importance sampling.
#[must_use]
pub fn shade_bis(
    ray: u32,
    frame: &FrameParams,
    bis: &Bis,
    env: Environment<'_>,
    scene: Scene<'_>,
) -> Vec4 {
    shade(ray, frame, env, scene, bis)
}

/// What the tile's ray `ray` shows in a scene with catchers, by bidirectional importance sampling.
#[must_use]
pub fn shade_bis_layers(
    ray: u32,
    frame: &FrameParams,
    bis: &Bis,
    env: Environment<'_>,
    scene: Scene<'_>,
) -> LayerSample {
    shade_layers(ray, frame, env, scene, bis)
}

#[inline]
fn mis(frame: &FrameParams) -> Mis {
    Mis {
        brdf_samples: frame.brdf_samples,
        env_samples: frame.env_samples,
    }
}

/// Radiance along the tile's ray `ray` by some estimator; alpha is 1 on objects and before a visible background.
#[inline]
fn shade<E: Estimator>(
    ray: u32,
    frame: &FrameParams,
    env: Environment<'_>,
    scene: Scene<'_>,
    estimator: &E,
) -> Vec4 {
    let pattern = frame.pattern_of(ray);
    let camera_ray = frame.camera_ray(&pattern);
    if let Some(hit) = scene.closest_hit(&camera_ray) {
        let point = scene.shading_point(&camera_ray, &hit);
        return estimator
            .reflected(&point, &pattern, env, scene)
            .lit
            .extend(1.0);
    }
    if frame.background == BACKGROUND_ENVIRONMENT {
        return env.background(camera_ray.direction).extend(1.0);
    }
    Vec4::ZERO
}

/// What a ray shows, by some estimator. The same samples tell a catcher's light with and without the objects.
#[inline]
fn shade_layers<E: Estimator>(
    ray: u32,
    frame: &FrameParams,
    env: Environment<'_>,
    scene: Scene<'_>,
    estimator: &E,
) -> LayerSample {
    let pattern = frame.pattern_of(ray);
    let camera_ray = frame.camera_ray(&pattern);
    if let Some(hit) = scene.closest_hit(&camera_ray) {
        let point = scene.shading_point(&camera_ray, &hit);
        let light = estimator.reflected(&point, &pattern, env, scene);
        let is_catcher = scene.triangles[hit.triangle as usize].is_catcher();
        return LayerSample::of(&light, is_catcher);
    }
    LayerSample::NOTHING
}
