//! Shared file: the sequential sampler on a light that moves above a plane, as kernels: one set of particles an element.

use glam::{UVec3, UVec4, Vec3, Vec4};
use glimt_sampling::resample::Scheme;
use glimt_sampling::ris::{RisPicks, RisSum};
use glimt_sampling::uniform::unit_vec2;
use glimt_sampling::warp::{cap_height, pdf_cosine_hemisphere_sr, sample_cosine_hemisphere};
use glimt_sampling::{UniformSource, Xoshiro128PlusPlus};
use glimt_smc::resample::resample;
use glimt_smc::weights::normalise;
use glimt_smc::{
    Bridge, CapMove, Endpoints, Independent, LOG_ZERO, Mixture, Particle, Sampled, Sampler,
    StateSampler, Target,
};

/// Where the light is in two frames, and how a step is made.
#[derive(Clone, Copy, Debug, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct Plan {
    /// Unit vector to the light in the frame before.
    pub before: Vec4,
    /// The same in this frame.
    pub now: Vec4,
    /// 0 systematic, 1 stratified, 2 multinomial, 3 residual.
    pub scheme: u32,
    /// 0 for a linear bridge, 1 for a geometric one.
    pub geometric: u32,
    /// K.
    pub intermediate: u32,
    /// Which step, from 1 to K + 1.
    pub k: u32,
}

impl Plan {
    fn sampler(&self) -> Sampler {
        let bridge = if self.geometric == 1 {
            Bridge::geometric(self.intermediate)
        } else {
            Bridge::linear(self.intermediate)
        };
        Sampler {
            bridge,
            scheme: self.scheme(),
            ess_threshold: 2.0 / 3.0,
        }
    }

    fn scheme(&self) -> Scheme {
        match self.scheme {
            0 => Scheme::Systematic,
            1 => Scheme::Stratified,
            2 => Scheme::Multinomial,
            _ => Scheme::Residual,
        }
    }
}

/// What an element gives beside its set.
#[derive(Clone, Copy, Debug, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct Outcome {
    /// The generator's state in the end.
    pub stream: UVec4,
    /// `ln Z_k/Z_{k−1}`, or `ln Ẑ` of a start.
    pub log_ratio: f32,
    /// Effective sample size before the resampling.
    pub ess: f32,
    /// 1 if there was one.
    pub resampled: u32,
    /// Moves that were accepted.
    pub accepted: u32,
}

struct Light {
    before: Vec3,
    now: Vec3,
}

impl Light {
    fn of(plan: &Plan) -> Light {
        Light {
            before: plan.before.truncate(),
            now: plan.now.truncate(),
        }
    }

    fn radiance(centre: Vec3, direction: Vec3) -> f32 {
        0.05 + libm::expf(6.0 * (centre.dot(direction) - 1.0))
    }
}

impl Target for Light {
    fn densities(&self, state: Vec3) -> Endpoints {
        let cosine = state.z.max(0.0);
        Endpoints {
            previous: Light::radiance(self.before, state) * cosine,
            current: Light::radiance(self.now, state) * cosine,
        }
    }
}

struct Hemisphere;

impl StateSampler for Hemisphere {
    fn sample(&self, u: UVec3) -> Sampled {
        let drawn = sample_cosine_hemisphere(unit_vec2(u.truncate()));
        Sampled {
            state: drawn.direction,
            pdf: drawn.pdf_sr,
        }
    }

    fn pdf(&self, state: Vec3) -> f32 {
        pdf_cosine_hemisphere_sr(state)
    }
}

/// Fills a set for the frame before by importance resampling from 24 candidates.
pub fn start(id: u32, plan: &Plan, particles: &mut [Particle]) -> Outcome {
    let light = Light::of(plan);
    let mut source = Xoshiro128PlusPlus::stream(1, 0, id);
    let mut replay = source;
    let mut weights = RisSum::new();
    for _ in 0..24 {
        let u = source.next_uvec2().extend(0);
        let drawn = Hemisphere.sample(u);
        let weight = light.densities(drawn.state).previous / drawn.pdf.max(1e-6);
        weights.add(weight);
    }
    let n = particles.len();
    let mut picks = RisPicks::new(&weights, n as u32, source.next_u32());
    let mut filled = 0;
    for _ in 0..24 {
        let u = replay.next_uvec2().extend(0);
        let drawn = Hemisphere.sample(u);
        let weight = light.densities(drawn.state).previous / drawn.pdf.max(1e-6);
        for _ in 0..picks.take(weight) {
            particles[filled] = Particle {
                state: drawn.state,
                log_weight: -libm::logf(n as f32),
            };
            filled += 1;
        }
    }
    Outcome {
        stream: source.state,
        log_ratio: libm::logf(weights.normaliser()),
        ess: n as f32,
        resampled: 0,
        accepted: filled as u32,
    }
}

/// One step of a set, from the generator's stored state.
pub fn step(id: u32, plan: &Plan, streams: &[UVec4], particles: &mut [Particle]) -> Outcome {
    let proposal = Mixture {
        pmf_first: 0.6,
        first: CapMove {
            height: cap_height(0.2),
        },
        second: Independent {
            sampler: Hemisphere,
        },
    };
    let mut source = Xoshiro128PlusPlus::from_state(streams[id as usize]);
    let sampler = plan.sampler();
    let light = Light::of(plan);
    let report = sampler.step(plan.k, &light, &proposal, particles, &mut source);
    Outcome {
        stream: source.state,
        log_ratio: report.log_ratio,
        ess: report.ess,
        resampled: report.resampled,
        accepted: report.accepted,
    }
}

/// The ancestors, in x, of a set with random weights, of which a quarter is 0.
pub fn ancestors(id: u32, plan: &Plan, particles: &mut [Particle]) -> Outcome {
    let mut source = Xoshiro128PlusPlus::stream(2, plan.scheme, id);
    let n = particles.len();
    for i in 0..n {
        let word = source.next_u32();
        particles[i] = Particle {
            state: Vec3::splat(i as f32),
            log_weight: if word & 3 == 0 {
                LOG_ZERO
            } else {
                (word >> 8) as f32 * (4.0 / 16_777_216.0)
            },
        };
    }
    let log_ratio = normalise(particles);
    if log_ratio > LOG_ZERO {
        resample(plan.scheme(), particles, &mut source);
    }
    Outcome {
        stream: source.state,
        log_ratio,
        ess: n as f32,
        resampled: 0,
        accepted: 0,
    }
}
