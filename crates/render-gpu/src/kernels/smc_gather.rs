//! Shared file: the light that particles carry to the eye: the last pass of the sequential sampler (Kronander 2014, Eq. 7).

use glimt_sampling::math::luminance;
use glimt_smc::{Particle, is_log_zero};

use super::environment::Environment;
use super::estimator::{LightSample, Reflected};
use super::frame::FrameParams;
use super::light_target::LightLobe;
use super::past::RayState;
use super::pattern::LIT_THROUGH;
use super::scene::Scene;
use super::shade::RaySample;
use super::smc_point::SmcPoint;

/// `L̂ = Z_t Σ Wⁱ L_t(ωⁱ) ρ V ⟨ωⁱ·n⟩ / γ_t(ωⁱ)` (Kronander 2014, Eq. 7): light that a point reflects, from all particles of its ray.
#[inline]
fn estimate(
    seen: &SmcPoint,
    log_normaliser: f32,
    floor: f32,
    key: u32,
    env: Environment<'_>,
    scene: Scene<'_>,
    particles: &[Particle],
) -> Reflected {
    let mut sum = Reflected::NONE;
    if is_log_zero(log_normaliser) {
        return sum;
    }
    let point = seen.shading_point();
    let lobe = LightLobe::of_point(&point);
    for i in 0..particles.len() {
        let particle = particles[i];
        if !is_log_zero(particle.log_weight) {
            let direction = particle.state;
            let radiance = env.radiance(env.texel(direction));
            let target = (luminance(radiance) + floor) * lobe.value(direction);
            let density = target * libm::expf(-(log_normaliser + particle.log_weight));
            let wi = point.frame.to_local(direction);
            let sample = LightSample::new(&point, direction, wi, radiance, density);
            sum.gather(sample.traced(&point, scene, key.wrapping_add(i as u32)));
        }
    }
    sum
}

/// The last pass of the sequential sampler: what the tile's ray `ray` shows by its particles, `particles_per_ray` of them. `floor` is
/// what this frame's target adds to the light's luminance.
#[must_use]
pub fn gather_smc<S: RaySample>(
    ray: u32,
    frame: &FrameParams,
    floor: f32,
    particles_per_ray: u32,
    env: Environment<'_>,
    scene: Scene<'_>,
    points: &[SmcPoint],
    states: &[RayState],
    particles: &[Particle],
) -> S {
    let seen = &points[ray as usize];
    if seen.is_hit() {
        let first = (ray * particles_per_ray) as usize;
        let own = &particles[first..first + particles_per_ray as usize];
        let log_normaliser = states[ray as usize].log_normaliser;
        let key = frame.pattern_of(ray).ray_key(LIT_THROUGH);
        let mut light = estimate(seen, log_normaliser, floor, key, env, scene, own);
        light.lit += seen.emission;
        return S::of_surface(&light, seen.catcher != 0);
    }
    let camera_ray = frame.camera_ray(&frame.pattern_of(ray));
    S::of_background(&camera_ray, frame, env.map())
}
