//! Shared file: weights of a set of particles.

use crate::particle::{LOG_ZERO, Particle, is_log_zero};

/// Gives all particles the weight 1/N.
#[inline]
pub fn make_equal(particles: &mut [Particle]) {
    let n = particles.len();
    let log_weight = -libm::logf(n as f32);
    for i in 0..n {
        particles[i].log_weight = log_weight;
    }
}

/// Scales the weights so that they sum to 1, and returns the logarithm of what they summed to: [`LOG_ZERO`] where all are 0,
/// and then none is changed.
///
/// ```
/// use glam::Vec3;
/// use glimt_smc::{Particle, weights};
/// // Weights far below what f32 can hold.
/// let particle = |log_weight| Particle { state: Vec3::ZERO, log_weight };
/// let mut set = [particle(-1000.0), particle(-1000.0 + 3.0f32.ln())];
/// assert!((weights::normalise(&mut set) - (-1000.0 + 4.0f32.ln())).abs() < 1e-4);
/// assert!((set[1].weight() - 0.75).abs() < 1e-5);
/// ```
#[inline]
pub fn normalise(particles: &mut [Particle]) -> f32 {
    let n = particles.len();
    let mut largest = LOG_ZERO;
    for i in 0..n {
        largest = largest.max(particles[i].log_weight);
    }
    if is_log_zero(largest) {
        return LOG_ZERO;
    }
    let mut sum = 0.0;
    for i in 0..n {
        sum += libm::expf(particles[i].log_weight - largest);
    }
    let log_sum = largest + libm::logf(sum);
    for i in 0..n {
        if !is_log_zero(particles[i].log_weight) {
            particles[i].log_weight -= log_sum;
        }
    }
    log_sum
}

/// The effective sample size `1/Σ (Wⁱ)²` of normalised weights: 1 where one particle has all the weight, N where all have the
/// same; 0 where all are 0 (Kronander 2014, step 2 of the sampler).
///
/// Differs from the paper, which prints `Σ (Wⁱ)⁻²`.
///
/// ```
/// use glam::Vec3;
/// use glimt_smc::{Particle, weights};
/// let mut set = [Particle { state: Vec3::ZERO, log_weight: 0.0 }; 8];
/// weights::normalise(&mut set);
/// assert!((weights::ess(&set) - 8.0).abs() < 1e-4);
/// ```
#[inline]
#[must_use]
pub fn ess(particles: &[Particle]) -> f32 {
    let mut squares = 0.0;
    for i in 0..particles.len() {
        let weight = particles[i].weight();
        squares += weight * weight;
    }
    if squares > 0.0 { 1.0 / squares } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;

    #[test]
    fn nothing_stays_nothing() {
        let mut set = [Particle {
            state: Vec3::X,
            log_weight: LOG_ZERO,
        }; 3];
        assert_eq!(normalise(&mut set), LOG_ZERO);
        assert_eq!(ess(&set), 0.0);
        set[1].log_weight = 3.0;
        assert_eq!(normalise(&mut set), 3.0);
        assert_eq!(set[1].weight(), 1.0);
        assert_eq!(set[0].weight(), 0.0);
    }
}
