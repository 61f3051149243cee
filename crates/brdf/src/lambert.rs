//! Shared file: the ideal diffuse reflector.

use core::f32::consts::FRAC_1_PI;

use glam::{Vec2, Vec3};
use glimt_sampling::warp::{pdf_cosine_hemisphere_sr, sample_cosine_hemisphere};

use crate::sample::BrdfSample;

/// Lambert's law: `ρ = kd/π`, the same from everywhere.
///
/// ```
/// use glam::{Vec2, Vec3};
/// use glimt_brdf::Lambert;
/// let white = Lambert { diffuse: Vec3::ONE };
/// let s = white.sample(Vec3::Z, Vec2::new(0.2, 0.7));
/// // Sampling is in proportion to ρ cos θ: every sample is worth the albedo.
/// assert!((white.eval(Vec3::Z, s.wi) * s.wi.z / s.pdf_sr - Vec3::ONE).length() < 1e-6);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lambert {
    /// Albedo kd per channel, 0 to 1.
    pub diffuse: Vec3,
}

impl Lambert {
    /// `ρ(wo, wi)` in 1/sr, without the cosine; 0 where either direction is not above the horizon.
    #[inline]
    #[must_use]
    pub fn eval(&self, wo: Vec3, wi: Vec3) -> Vec3 {
        if wo.z > 0.0 && wi.z > 0.0 {
            self.diffuse * FRAC_1_PI
        } else {
            Vec3::ZERO
        }
    }

    /// Draws `wi` in proportion to its cosine; impossible where `wo` is not above the horizon.
    #[inline]
    #[must_use]
    pub fn sample(&self, wo: Vec3, u: Vec2) -> BrdfSample {
        let wi = sample_cosine_hemisphere(u).direction;
        BrdfSample {
            wi,
            pdf_sr: self.pdf_sr(wo, wi),
        }
    }

    /// Density of [`Lambert::sample`], in 1/sr: `cos θ/π`; 0 where either direction is not above the horizon.
    #[inline]
    #[must_use]
    pub fn pdf_sr(&self, wo: Vec3, wi: Vec3) -> f32 {
        if wo.z > 0.0 {
            pdf_cosine_hemisphere_sr(wi)
        } else {
            0.0
        }
    }

    /// Share of light reflected, per channel: kd, from everywhere.
    #[inline]
    #[must_use]
    pub fn albedo(&self) -> Vec3 {
        self.diffuse
    }
}
