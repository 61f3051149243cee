//! Shared file: what is sampled: an unnormalised density that changes from one frame to the next.

use glam::Vec3;

/// The two targets between which a frame's steps lie, at one state. Each is at least 0 and finite, in any unit as long as it is
/// the same for both: only normalisers carry it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Endpoints {
    /// `γ_{t−1}`, the frame before.
    pub previous: f32,
    /// `γ_t`, this frame.
    pub current: f32,
}

/// A target that changes from γ_{t−1} to γ_t. Where γ_t > 0, γ_{t−1} must be so, too: what moves onto states where the old
/// target was zero is lost, and no weight tells.
///
/// A log-density is handed over as the exponential of its difference to a constant, the same for both frames, which keeps it
/// within f32.
pub trait Target {
    /// γ_{t−1} and γ_t at `state`.
    fn densities(&self, state: Vec3) -> Endpoints;
}
