//! Shared file: what sampling a BRDF gives.

use glam::Vec3;

/// A direction drawn from a BRDF's sampling density, in the local frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BrdfSample {
    /// Unit vector that points away from the surface.
    pub wi: Vec3,
    /// Density of `wi`, in 1/sr: the same as `pdf_sr(wo, wi)`. 0 marks an impossible sample (below the horizon), which
    /// contributes 0 and counts all the same.
    pub pdf_sr: f32,
}
