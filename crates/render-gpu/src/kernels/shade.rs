//! Shared file: pass 1 of rendering (Kronander 2014, § 7): one element is one ray.

use glam::Vec4;

use super::environment::Environment;
use super::estimator::Estimator;
use super::frame::{BACKGROUND_ENVIRONMENT, FrameParams};
use super::mis::Mis;
use super::scene::Scene;

/// Radiance along the tile's ray `ray`, with alpha, by multiple importance sampling.
#[must_use]
pub fn shade_mis(ray: u32, frame: &FrameParams, env: Environment<'_>, scene: Scene<'_>) -> Vec4 {
    let estimator = Mis {
        brdf_samples: frame.brdf_samples,
        env_samples: frame.env_samples,
    };
    shade(ray, frame, env, scene, &estimator)
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
            .extend(1.0);
    }
    if frame.background == BACKGROUND_ENVIRONMENT {
        return env.background(camera_ray.direction).extend(1.0);
    }
    Vec4::ZERO
}
