//! Shared file: sequential Monte Carlo sampling of reflected light over frames (Kronander 2014, § 6). One element is one ray,
//! with a set of particles of its own.
//!
//! A frame has three passes: [`find_smc`](super::smc_point::find_smc) finds the point that a ray sees and the ray that saw it in
//! the frame before, [`advance_smc`] leads the particles, and [`gather_smc`](super::smc_gather::gather_smc) traces shadow rays
//! to them. None of them needs more buffers than WebGPU promises.
//!
//! A set that is led from frame to frame has a mean without bias, whenever it was started: so has any choice between such sets that
//! does not look at them. A set is therefore started where its ray has no past, at an age, and where the light map has changed much. It is not started because its own estimate moved, nor because all its weights are 0: such
//! a set stays dark until one of these comes, as dark sets belong to the mean. The rule by the ratio of normalisers, which
//! looks at the estimate and so is biased, is there to compare with ([`SmcParams::band`]).

use glimt_sampling::hash::{hash2, hash3};
use glimt_sampling::resample::Scheme;
use glimt_sampling::ris::{RisPicks, RisSum};
use glimt_smc::weights::make_equal;
use glimt_smc::{
    Bridge, CapMove, Independent, LOG_ZERO, Mixture, Particle, Path, Report, Sampler, is_log_zero,
};

use glam::Vec4;
use glimt_sampling::math::luminance;

use super::candidates::{CandidateSource, Candidates};
use super::environment::{Environment, RadianceMap};
use super::frame::FrameParams;
use super::light_target::{BrdfDraw, LightDraw, LightLobe, LightTarget};
use super::past::{
    RayState, STARTED_BY_AGE, STARTED_BY_CHANGE, STARTED_BY_RATIO, STARTED_NOT,
    STARTED_WITHOUT_PAST,
};
use super::pattern::{PARTICLES, PatternSource, PixelPattern, RESAMPLE, TURN};
use super::scene::ShadingPoint;
use super::smc_point::{NO_PREDECESSOR, SmcPoint};

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
    /// A set is re-initialised where `|ln Z_t/Z_{t−1}|` exceeds this, or all weights are 0, which is biased. 0 for never.
    pub band: f32,
    /// The age at which a set is re-initialised at the latest ([`SmcParams::is_due`]); 0 for never.
    pub max_age: u32,
    /// M, candidates of a start.
    pub candidates: u32,
    /// Where they come from; not the environment alone.
    pub source: CandidateSource,
    /// 1 where the light map has changed so much that all sets are re-initialised, else 0.
    pub changed: u32,
    /// Fills 16 bytes.
    pub unused_a: u32,
    /// Fills 16 bytes.
    pub unused_b: u32,
}

impl SmcParams {
    /// Whether a set is re-initialised for its age in a frame of this pattern: at [`SmcParams::max_age`], or before, where it is the
    /// ray's turn.
    ///
    /// Each ray has its turn in every `max_age`-th frame, by a phase from seed, pixel and ray: all rays start in the first frame and
    /// after a cut, and would otherwise start together again and again. The frame's own number decides, so a still ray that is
    /// followed for `max_age` frames has the state that it has in any longer run. Particles that pass from ray to ray may
    /// miss their turns: then the age itself ends them.
    #[inline]
    #[must_use]
    pub fn is_due(&self, age: u32, pattern: &PixelPattern) -> bool {
        if self.max_age == 0 {
            return false;
        }
        let phase = hash3(hash2(pattern.seed, TURN), pattern.pixel, pattern.ray) % self.max_age;
        let turn = pattern.frame.wrapping_add(phase) % self.max_age;
        age >= self.max_age || turn == 0
    }

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

/// The second pass of the sequential sampler: leads the particles of the tile's ray `ray` into this frame, or starts them here.
/// Fills the ray's state and particles for the last pass and for the next frame, from what the first pass found and from the
/// particles of the frame before.
pub fn advance_smc(
    ray: u32,
    frame: &FrameParams,
    smc: &SmcParams,
    env: Environment<'_>,
    before: RadianceMap<'_>,
    points: &[SmcPoint],
    past_particles: &[Particle],
    state: &mut [RayState],
    particles: &mut [Particle],
) {
    let seen = &points[ray as usize];
    if !seen.is_hit() {
        state[0] = RayState::NONE;
        return;
    }
    let pattern = frame.pattern_of(ray);
    let point = seen.shading_point();
    let n = particles.len();
    let mut now = RayState {
        normal: seen.normal,
        log_normaliser: LOG_ZERO,
        wo: seen.wo,
        depth: seen.depth,
        diffuse: luminance(point.brdf.diffuse),
        specular: luminance(point.brdf.specular),
        exponent: point.brdf.exponent,
        age: 0,
        ess: n as f32,
        log_ratio: 0.0,
        started: STARTED_WITHOUT_PAST,
        accepted: 0,
    };
    if seen.predecessor != NO_PREDECESSOR {
        let old = seen.before;
        now.age = old.age + 1;
        now.started = if smc.changed != 0 {
            STARTED_BY_CHANGE
        } else if smc.is_due(now.age, &pattern) {
            STARTED_BY_AGE
        } else {
            STARTED_NOT
        };
    }
    if now.started == STARTED_NOT {
        let old = seen.before;
        let first = seen.predecessor as usize * n;
        for i in 0..n {
            particles[i] = past_particles[first + i];
        }
        let target = LightTarget {
            previous_light: before,
            previous_floor: smc.previous_floor,
            previous_lobe: LightLobe::of_state(&old),
            light: env,
            floor: smc.floor,
            lobe: LightLobe::of_point(&point),
        };
        let mut source = pattern.source(PARTICLES);
        let report = smc.advance(&target, &point, particles, &mut source);
        let dead = is_log_zero(report.log_ratio) || is_log_zero(old.log_normaliser);
        now.log_ratio = report.log_ratio;
        now.ess = report.ess;
        now.accepted = report.accepted;
        if smc.band > 0.0 && (dead || report.log_ratio.abs() > smc.band) {
            now.started = STARTED_BY_RATIO;
        }
        now.log_normaliser = if dead {
            LOG_ZERO
        } else {
            old.log_normaliser + report.log_ratio
        };
    }
    if now.started != STARTED_NOT {
        now.age = 0;
        now.log_normaliser = smc.start(&point, &pattern, env, particles);
    }
    state[0] = now;
}

/// How the particles of a pixel fare: means over its rays that hit something. 0 where none hits. 20 bytes.
#[derive(Clone, Copy, Debug, Default, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct SmcHealth {
    /// The effective sample size as a share of N.
    pub ess: f32,
    /// ln Z_t/Z_{t−1}, of a set that dies −100.
    pub log_ratio: f32,
    /// The age in frames.
    pub age: f32,
    /// The share of sets that were started in this frame.
    pub started: f32,
    /// sd(Z)/Z: the standard deviation of Z over the rays, of n − 1 degrees of freedom, over its mean. The rays of a pixel that shows
    /// one smooth surface have nearly the same integral, so it is the noise of Z. At most √n. 0 where fewer than two rays hit, and where all Z are 0.
    pub spread: f32,
}

/// How the particles of the tile's pixel `pixel` fare, `particles_per_ray` on each of its rays.
#[must_use]
pub fn diagnose_smc(
    pixel: u32,
    frame: &FrameParams,
    states: &[RayState],
    particles_per_ray: u32,
) -> SmcHealth {
    let first = pixel * frame.rays_per_pixel;
    let end = first + frame.rays_per_pixel;
    let mut sum = Vec4::ZERO;
    let mut hits = 0.0;
    let mut largest = LOG_ZERO;
    for ray in first..end {
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
            largest = largest.max(state.log_normaliser);
        }
    }
    let mean = sum / f32::max(hits, 1.0);
    let mut spread = 0.0;
    if hits > 1.0 && !is_log_zero(largest) {
        // Relative to the largest, so that no scale of the light leaves the range.
        let mut total = 0.0;
        let mut squares = 0.0;
        for ray in first..end {
            let state = states[ray as usize];
            if state.depth > 0.0 && !is_log_zero(state.log_normaliser) {
                let z = libm::expf(state.log_normaliser - largest);
                total += z;
                squares += z * z;
            }
        }
        let variance = (squares - total * total / hits) / (hits - 1.0);
        spread = libm::sqrtf(variance.max(0.0)) * hits / total;
    }
    SmcHealth {
        ess: mean.x / particles_per_ray as f32,
        log_ratio: mean.y,
        age: mean.z,
        started: mean.w,
        spread,
    }
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
        assert_eq!(core::mem::size_of::<SmcHealth>(), 20);
    }
}
