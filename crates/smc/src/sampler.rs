//! Shared file: the sampler: a set of particles led from one frame's target to the next one's (Del Moral, Doucet, Jasra
//! 2006; for light Ghosh, Doucet, Heidrich 2006; Kronander 2014, § 6).

use glam::UVec4;
use glimt_sampling::resample::{Scheme, skip};
use glimt_sampling::uniform::UniformSource;

use crate::bridge::Bridge;
use crate::metropolis::metropolis;
use crate::particle::{LOG_ZERO, Particle, is_log_zero};
use crate::proposal::Proposal;
use crate::resample::resample;
use crate::reweight::reweight;
use crate::target::Target;
use crate::weights::ess;

/// How a set is led from target to target.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sampler {
    /// The targets between.
    pub bridge: Bridge,
    /// How particles are resampled.
    pub scheme: Scheme,
    /// They are when the effective sample size falls below this share of N: 2/3 in the paper, 0 for never, above 1 for always.
    pub ess_threshold: f32,
}

/// How one step went, or all steps of a frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Report {
    /// `ln Z_k/Z_{k−1}`, summed over the steps: by it the normaliser grows. [`LOG_ZERO`] where all weights became 0.
    pub log_ratio: f32,
    /// The effective sample size before the (last) resampling; of a frame, the least.
    pub ess: f32,
    /// Steps with resampling.
    pub resampled: u32,
    /// Moves that were accepted, of N in a step.
    pub accepted: u32,
}

impl Sampler {
    /// One step, from γ_{k−1} to γ_k, k from 1 to K + 1: reweight, resample, move, in this order.
    ///
    /// Draws [`words`](glimt_sampling::resample::words) words, then four for each particle, whatever it decides. Where all weights
    /// are 0 they stay so.
    #[inline]
    pub fn step<T: Target, P: Proposal, U: UniformSource>(
        &self,
        k: u32,
        target: &T,
        proposal: &P,
        particles: &mut [Particle],
        source: &mut U,
    ) -> Report {
        let n = particles.len();
        let log_ratio = reweight(k, &self.bridge, target, particles);
        let size = ess(particles);
        let resampled = size < self.ess_threshold * n as f32 && size > 0.0;
        if resampled {
            resample(self.scheme, particles, source);
        } else {
            skip(self.scheme, n as u32, source);
        }
        let mut accepted = 0;
        for i in 0..n {
            let plane = source.next_uvec2();
            let choice = source.next_u32();
            let decision = source.next_u32();
            let u = UVec4::new(plane.x, plane.y, choice, decision);
            if metropolis(k, &self.bridge, target, proposal, &mut particles[i], u) {
                accepted += 1;
            }
        }
        Report {
            log_ratio,
            ess: size,
            resampled: if resampled { 1 } else { 0 },
            accepted,
        }
    }

    /// All steps of a frame, from γ_{t−1} to γ_t: `ln Z_t = ln Z_{t−1} + log_ratio`, and
    /// `Z_t Σ Wⁱ f(ωⁱ)/γ_t(ωⁱ)` estimates `∫ f` (Kronander 2014, Eq. 7), without bias where no set is re-initialised.
    #[inline]
    pub fn advance<T: Target, P: Proposal, U: UniformSource>(
        &self,
        target: &T,
        proposal: &P,
        particles: &mut [Particle],
        source: &mut U,
    ) -> Report {
        let mut frame = Report {
            log_ratio: 0.0,
            ess: particles.len() as f32,
            resampled: 0,
            accepted: 0,
        };
        for k in 1..self.bridge.steps() + 1 {
            let step = self.step(k, target, proposal, particles, source);
            frame.log_ratio = if is_log_zero(step.log_ratio) || is_log_zero(frame.log_ratio) {
                LOG_ZERO
            } else {
                frame.log_ratio + step.log_ratio
            };
            frame.ess = frame.ess.min(step.ess);
            frame.resampled += step.resampled;
            frame.accepted += step.accepted;
        }
        frame
    }
}
