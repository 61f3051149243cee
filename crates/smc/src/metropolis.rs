//! Shared file: Metropolis-Hastings moves (Kronander 2014, Eq. 6).

use glam::UVec4;
use glimt_sampling::uniform::unit_f32;

use crate::bridge::Bridge;
use crate::particle::Particle;
use crate::proposal::Proposal;
use crate::target::Target;

/// Whether a move is accepted, with probability `min(1, γ(ω′) q(ω′→ω) / (γ(ω) q(ω→ω′)))`, by `u ∈ [0, 1)`.
///
/// Two products are compared, so nothing is divided by zero. What cannot be proposed, `forward = 0`, or has `γ(ω′) = 0` is
/// rejected.
///
/// Differs from the paper, whose print has q(ω→ω′) in the numerator, too.
///
/// ```
/// use glimt_smc::accept;
/// assert!(accept(0.49, 2.0, 1.0, 1.0, 1.0) && !accept(0.51, 2.0, 1.0, 1.0, 1.0));
/// assert!(accept(0.9, 0.0, 1.0, 1.0, 1.0) && !accept(0.0, 1.0, 1.0, 0.0, 1.0));
/// ```
#[inline]
#[must_use]
pub fn accept(u: f32, density: f32, forward: f32, proposed_density: f32, backward: f32) -> bool {
    forward > 0.0 && u * (density * forward) < proposed_density * backward
}

/// Moves a particle by one Metropolis-Hastings step that leaves γ_k invariant, and says whether the move was accepted. The
/// first three words propose, the fourth decides.
#[inline]
pub fn metropolis<T: Target, P: Proposal>(
    k: u32,
    bridge: &Bridge,
    target: &T,
    proposal: &P,
    particle: &mut Particle,
    u: UVec4,
) -> bool {
    let proposed = proposal.propose(particle.state, u.truncate());
    let density = bridge.density(k, target.densities(particle.state));
    let proposed_density = bridge.density(k, target.densities(proposed.state));
    let accepted = accept(
        unit_f32(u.w),
        density,
        proposed.forward,
        proposed_density,
        proposed.backward,
    );
    if accepted {
        particle.state = proposed.state;
    }
    accepted
}
