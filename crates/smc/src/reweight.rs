//! Shared file: from one target's weights to the next one's (Kronander 2014, Eqs. 5 and 8).

use crate::bridge::Bridge;
use crate::particle::{LOG_ZERO, Particle, is_log_zero};
use crate::target::Target;
use crate::weights::normalise;

/// `wⁱ = Wⁱ γ_k(ωⁱ)/γ_{k−1}(ωⁱ)`, then `Wⁱ = wⁱ/Σ w`. Returns `ln Σ w = ln Z_k/Z_{k−1}`; [`LOG_ZERO`] where all weights
/// are 0.
///
/// Comes before the particles move: weights belong to states that γ_{k−1} left, not to those that γ_k's kernel makes of them.
#[inline]
pub fn reweight<T: Target>(k: u32, bridge: &Bridge, target: &T, particles: &mut [Particle]) -> f32 {
    for i in 0..particles.len() {
        let ends = target.densities(particles[i].state);
        let before = bridge.density(k - 1, ends);
        let after = bridge.density(k, ends);
        let old = particles[i].log_weight;
        particles[i].log_weight = if before > 0.0 && after > 0.0 && !is_log_zero(old) {
            old + (libm::logf(after) - libm::logf(before))
        } else {
            LOG_ZERO
        };
    }
    normalise(particles)
}
