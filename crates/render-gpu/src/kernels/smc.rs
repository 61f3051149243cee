//! Shared file: sequential Monte Carlo sampling of reflected light over frames (Kronander 2014, § 6). One element is one ray,
//! with a set of particles of its own.

use glimt_sampling::resample::Scheme;
use glimt_sampling::ris::{RisPicks, RisSum};
use glimt_smc::weights::make_equal;
use glimt_smc::{
    Bridge, CapMove, Independent, LOG_ZERO, Mixture, Particle, Path, Report, Sampler, is_log_zero,
};

use glam::{Vec3, Vec4};
use glimt_sampling::math::luminance;

use super::candidates::{CandidateSource, Candidates};
use super::environment::{Environment, RadianceMap};
use super::estimator::{LightSample, Reflected};
use super::frame::{Background, FrameParams};
use super::layers::LayerSample;
use super::light_target::{BrdfDraw, LightDraw, LightLobe, LightTarget};
use super::past::{
    Past, PastView, RayState, STARTED_BY_AGE, STARTED_BY_RATIO, STARTED_NOT, STARTED_WITHOUT_PAST,
};
use super::pattern::{PARTICLES, PatternSource, PixelPattern, RESAMPLE};
use super::scene::{Scene, ShadingPoint};

/// How particles are led from frame to frame. 64 bytes.
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::NoUninit)]
#[repr(C)]
pub struct SmcParams {
    /// K, targets between two frames.
    pub intermediate: u32,
    /// How those are mixed of both frames' targets.
    pub path: Path,
    /// How particles are resampled.
    pub scheme: Scheme,
    /// Share of N below which the effective sample size calls for resampling.
    pub ess_threshold: f32,
    /// What this frame's target adds to the light's luminance.
    pub floor: f32,
    /// What that of the frame before did.
    pub previous_floor: f32,
    /// Height `1 − cos α` of the cap of local moves.
    pub cap_height: f32,
    /// ν: probability of a local move.
    pub cap_share: f32,
    /// Of the independent draws, the share that comes from the light and not from the BRDF.
    pub light_share: f32,
    /// A set starts anew where `|ln Z_t/Z_{t−1}|` exceeds this, or all weights are 0. 0 for never.
    pub band: f32,
    /// A set starts anew at this age; 0 for never.
    pub max_age: u32,
    /// M, candidates of a start.
    pub candidates: u32,
    /// Where they come from; not the environment alone.
    pub source: CandidateSource,
    /// Fills 16 bytes.
    pub unused_a: u32,
    /// Fills 16 bytes.
    pub unused_b: u32,
    /// Fills 16 bytes.
    pub unused_c: u32,
}

impl SmcParams {
    /// The sampler that they describe.
    #[inline]
    #[must_use]
    pub fn sampler(&self) -> Sampler {
        Sampler {
            bridge: Bridge {
                path: self.path,
                intermediate: self.intermediate,
            },
            scheme: self.scheme,
            ess_threshold: self.ess_threshold,
        }
    }

    /// Leads particles from the target of the frame before to that of this one.
    #[inline]
    #[must_use]
    pub fn advance(
        &self,
        target: &LightTarget<'_>,
        point: &ShadingPoint,
        particles: &mut [Particle],
        source: &mut PatternSource,
    ) -> Report {
        let proposal = Mixture {
            pmf_first: self.cap_share,
            first: CapMove {
                height: self.cap_height,
            },
            second: Mixture {
                pmf_first: self.light_share,
                first: Independent {
                    sampler: LightDraw {
                        light: target.light,
                    },
                },
                second: Independent {
                    sampler: BrdfDraw {
                        frame: point.frame,
                        wo: point.wo,
                        brdf: point.brdf,
                    },
                },
            },
        };
        self.sampler().advance(target, &proposal, particles, source)
    }

    /// Starts a set by importance resampling for this frame's target, and returns ln Z.
    #[inline]
    #[must_use]
    pub fn start(
        &self,
        point: &ShadingPoint,
        pattern: &PixelPattern,
        env: Environment<'_>,
        particles: &mut [Particle],
    ) -> f32 {
        let n = particles.len() as u32;
        let candidates = Candidates {
            count: self.candidates,
            source: self.source,
            floor: self.floor,
        };
        let mut weights = RisSum::new();
        for j in 0..self.candidates {
            weights.add(candidates.draw(j, point, pattern, env).weight);
        }
        let normaliser = weights.normaliser();
        if !(normaliser > 0.0) {
            for i in 0..n as usize {
                particles[i] = Particle {
                    state: point.frame.n,
                    log_weight: LOG_ZERO,
                };
            }
            return LOG_ZERO;
        }
        let mut picks = RisPicks::new(&weights, n, pattern.pair(RESAMPLE, 0, 1).x);
        let mut filled = 0;
        for j in 0..self.candidates {
            let candidate = candidates.draw(j, point, pattern, env);
            let copies = picks.take(candidate.weight);
            for _ in 0..copies {
                particles[filled].state = candidate.direction;
                filled += 1;
            }
        }
        make_equal(particles);
        libm::logf(normaliser)
    }
}

/// `L̂ = Z_t Σ Wⁱ L_t(ωⁱ) ρ V ⟨ωⁱ·n⟩ / γ_t(ωⁱ)` (Kronander 2014, Eq. 7).
#[inline]
fn estimate(
    point: &ShadingPoint,
    lobe: &LightLobe,
    floor: f32,
    log_normaliser: f32,
    env: Environment<'_>,
    scene: Scene<'_>,
    particles: &[Particle],
) -> Reflected {
    let mut sum = Reflected::NONE;
    for i in 0..particles.len() {
        let particle = particles[i];
        if !is_log_zero(particle.log_weight) {
            let direction = particle.state;
            let radiance = env.radiance(env.texel(direction));
            let target = (luminance(radiance) + floor) * lobe.value(direction);
            let density = target * libm::expf(-(log_normaliser + particle.log_weight));
            let wi = point.frame.to_local(direction);
            let sample = LightSample::new(point, direction, wi, radiance, density);
            sum.gather(sample.traced(point, scene));
        }
    }
    sum
}

/// Leads the particles of a ray's shading point into this frame, or starts them there, and estimates the light that it
/// reflects.
#[inline]
fn follow(
    point: &ShadingPoint,
    depth: f32,
    wo: Vec3,
    object: u32,
    frame: &FrameParams,
    smc: &SmcParams,
    view: &PastView,
    pattern: &PixelPattern,
    env: Environment<'_>,
    before: RadianceMap<'_>,
    scene: Scene<'_>,
    past: Past<'_>,
    state: &mut [RayState],
    particles: &mut [Particle],
) -> Reflected {
    let n = particles.len();
    let lobe = LightLobe::of_point(point);
    let mut now = RayState {
        normal: point.frame.n,
        log_normaliser: LOG_ZERO,
        wo,
        depth,
        diffuse: luminance(point.brdf.diffuse),
        specular: luminance(point.brdf.specular),
        exponent: point.brdf.exponent,
        age: 0,
        ess: n as f32,
        log_ratio: 0.0,
        started: STARTED_WITHOUT_PAST,
        accepted: 0,
    };
    if let Some(ray) = view.predecessor(point, object, frame, pattern, past) {
        let old = past.states[ray as usize];
        let first = ray as usize * n;
        for i in 0..n {
            particles[i] = past.particles[first + i];
        }
        let target = LightTarget {
            previous_light: before,
            previous_floor: smc.previous_floor,
            previous_lobe: LightLobe::of_state(&old),
            light: env,
            floor: smc.floor,
            lobe,
        };
        let mut source = pattern.source(PARTICLES);
        let report = smc.advance(&target, point, particles, &mut source);
        let dead = is_log_zero(report.log_ratio) || is_log_zero(old.log_normaliser);
        now.log_ratio = report.log_ratio;
        now.ess = report.ess;
        now.accepted = report.accepted;
        now.age = old.age + 1;
        now.started = if smc.band > 0.0 && (dead || report.log_ratio.abs() > smc.band) {
            STARTED_BY_RATIO
        } else if smc.max_age > 0 && now.age >= smc.max_age {
            STARTED_BY_AGE
        } else {
            STARTED_NOT
        };
        now.log_normaliser = if dead {
            LOG_ZERO
        } else {
            old.log_normaliser + report.log_ratio
        };
    }
    if now.started != STARTED_NOT {
        now.age = 0;
        now.log_normaliser = smc.start(point, pattern, env, particles);
    }
    let light = if is_log_zero(now.log_normaliser) {
        Reflected::NONE
    } else {
        estimate(
            point,
            &lobe,
            smc.floor,
            now.log_normaliser,
            env,
            scene,
            particles,
        )
    };
    state[0] = now;
    light
}

/// Radiance along the tile's ray `ray`, with alpha, by the sequential sampler. Fills the ray's state and particles for the next frame
/// from those of the frame before.
#[must_use]
pub fn shade_smc(
    ray: u32,
    frame: &FrameParams,
    smc: &SmcParams,
    view: &PastView,
    env: Environment<'_>,
    before: RadianceMap<'_>,
    scene: Scene<'_>,
    past: Past<'_>,
    state: &mut [RayState],
    particles: &mut [Particle],
) -> Vec4 {
    let pattern = frame.pattern_of(ray);
    let camera_ray = frame.camera_ray(&pattern);
    if let Some(hit) = scene.closest_hit(&camera_ray) {
        let point = scene.shading_point(&camera_ray, &hit);
        let object = scene.triangles[hit.triangle as usize].object_index();
        let wo = -camera_ray.direction;
        let light = follow(
            &point, hit.t, wo, object, frame, smc, view, &pattern, env, before, scene, past, state,
            particles,
        );
        return light.lit.extend(1.0);
    }
    state[0] = RayState::NONE;
    if frame.background == Background::Environment {
        return env.background(camera_ray.direction).extend(1.0);
    }
    Vec4::ZERO
}

/// What the tile's ray `ray` shows in a scene with catchers, by the sequential sampler; as [`shade_smc`].
#[must_use]
pub fn shade_smc_layers(
    ray: u32,
    frame: &FrameParams,
    smc: &SmcParams,
    view: &PastView,
    env: Environment<'_>,
    before: RadianceMap<'_>,
    scene: Scene<'_>,
    past: Past<'_>,
    state: &mut [RayState],
    particles: &mut [Particle],
) -> LayerSample {
    let pattern = frame.pattern_of(ray);
    let camera_ray = frame.camera_ray(&pattern);
    if let Some(hit) = scene.closest_hit(&camera_ray) {
        let point = scene.shading_point(&camera_ray, &hit);
        let triangle = &scene.triangles[hit.triangle as usize];
        let object = triangle.object_index();
        let wo = -camera_ray.direction;
        let light = follow(
            &point, hit.t, wo, object, frame, smc, view, &pattern, env, before, scene, past, state,
            particles,
        );
        return LayerSample::of(&light, triangle.is_catcher());
    }
    state[0] = RayState::NONE;
    LayerSample::NOTHING
}

/// How the particles of the tile's pixel `pixel` fare: means over its rays that hit something of the effective sample size as a
/// share of N, of ln Z_t/Z_{t−1}, of the age in frames, and of whether the set was started in this frame. 0 where none hits.
#[must_use]
pub fn diagnose_smc(
    pixel: u32,
    frame: &FrameParams,
    states: &[RayState],
    particles_per_ray: u32,
) -> Vec4 {
    let first = pixel * frame.rays_per_pixel;
    let mut sum = Vec4::ZERO;
    let mut hits = 0.0;
    for ray in first..first + frame.rays_per_pixel {
        let state = states[ray as usize];
        if state.depth > 0.0 {
            let started = if state.started == STARTED_NOT {
                0.0
            } else {
                1.0
            };
            // A set that died has no ratio to speak of.
            let ratio = state.log_ratio.clamp(-100.0, 100.0);
            sum += Vec4::new(state.ess, ratio, state.age as f32, started);
            hits += 1.0;
        }
    }
    let n = particles_per_ray as f32;
    let mean = sum / f32::max(hits, 1.0);
    Vec4::new(mean.x / n, mean.y, mean.z, mean.w)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn layout_is_that_of_wgsl() {
        assert_eq!(core::mem::size_of::<SmcParams>(), 64);
        assert_eq!(core::mem::offset_of!(SmcParams, floor), 16);
        assert_eq!(core::mem::offset_of!(SmcParams, light_share), 32);
        assert_eq!(core::mem::offset_of!(SmcParams, source), 48);
    }
}
