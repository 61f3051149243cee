//! Shared file: a diffuse base under a normalised Blinn-Phong lobe.

use core::f32::consts::FRAC_1_PI;

use glam::{Vec2, Vec3};
use glimt_sampling::math::luminance;
use glimt_sampling::uniform::unit_f32;
use glimt_sampling::warp::{
    pdf_cosine_hemisphere_sr, sample_cosine_hemisphere, sample_power_cosine,
};

use crate::lobe::{HalfVector, normalisation};
use crate::sample::BrdfSample;

/// `ρ(wo, wi) = kd/π + ks c(e) (n·h)^e`, with [`normalisation`] `c(e)`.
///
/// Directions are unit vectors in the local frame, n = +z, and point away from the surface. A direction that is not
/// above the horizon (`z > 0`) reflects nothing, is reflected nothing, and has density 0.
///
/// The fields are the caller's to fill; [`BlinnPhong::new`] and
/// [`BlinnPhong::new_scaled`] check them. Where `kd + ks ≤ 1` per channel, no light is gained at any angle.
///
/// # The lobe darkens at an angle
///
/// There is neither Fresnel's nor a masking term, and a lobe that has albedo ks at normal incidence has less at an
/// angle θ, in the limit of a mirror `ks cos² θ`. Measured by quadrature, for ks = 1:
///
/// | e | 0° | 30° | 45° | 60° | 75° | 85° |
/// |---|---|---|---|---|---|---|
/// | 0 | 1.000 | 1.000 | 1.000 | 1.000 | 1.000 | 1.000 |
/// | 1 | 1.000 | 0.955 | 0.898 | 0.819 | 0.716 | 0.633 |
/// | 5 | 1.000 | 0.853 | 0.695 | 0.515 | 0.340 | 0.238 |
/// | 50 | 1.000 | 0.760 | 0.520 | 0.281 | 0.104 | 0.039 |
/// | 500 | 1.000 | 0.751 | 0.502 | 0.253 | 0.071 | 0.012 |
/// | 10⁴ | 1.000 | 0.750 | 0.500 | 0.250 | 0.067 | 0.008 |
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BlinnPhong {
    /// Diffuse albedo kd per channel, 0 to 1.
    pub diffuse: Vec3,
    /// Albedo ks of the specular lobe at normal incidence, per channel, 0 to 1.
    pub specular: Vec3,
    /// Exponent e, 0 to [`MAX_EXPONENT`](crate::MAX_EXPONENT).
    pub exponent: f32,
}

impl BlinnPhong {
    /// `ρ(wo, wi)` in 1/sr, without the cosine; 0 where either direction is not above the horizon.
    ///
    /// ```
    /// use glam::Vec3;
    /// use glimt_brdf::{BlinnPhong, normalisation};
    /// let half = Vec3::splat(0.5);
    /// let brdf = BlinnPhong { diffuse: half, specular: half, exponent: 20.0 };
    /// let peak = 0.5 * core::f32::consts::FRAC_1_PI + 0.5 * normalisation(20.0);
    /// assert!((brdf.eval(Vec3::Z, Vec3::Z).x / peak - 1.0).abs() < 1e-6);
    /// ```
    #[inline]
    #[must_use]
    pub fn eval(&self, wo: Vec3, wi: Vec3) -> Vec3 {
        if wo.z <= 0.0 || wi.z <= 0.0 {
            return Vec3::ZERO;
        }
        let diffuse = self.diffuse * FRAC_1_PI;
        // Most surfaces of most scenes have no lobe, and it is the dear part.
        if self.specular.max_element() <= 0.0 {
            return diffuse;
        }
        let lobe = normalisation(self.exponent) * HalfVector::new(wo, wi).lobe(self.exponent);
        diffuse + self.specular * lobe
    }

    /// Draws `wi`: from the specular lobe with probability [`BlinnPhong::pmf_specular`], else in proportion to its
    /// cosine.
    ///
    /// `u_lobe` is a uniform word that chooses the lobe, `u ∈ [0, 1)²` places the direction in it. The specular lobe is
    /// sampled by its half vector, `cos θ_h = u^(1/(e+1))`, about which `wo` is reflected. It may reflect below the
    /// horizon (for half of all half vectors at e = 1 and grazing `wo`): that sample is impossible, of density 0.
    #[inline]
    #[must_use]
    pub fn sample(&self, wo: Vec3, u_lobe: u32, u: Vec2) -> BrdfSample {
        let wi = if unit_f32(u_lobe) < self.pmf_specular() {
            let h = sample_power_cosine(u, self.exponent).direction;
            2.0 * wo.dot(h) * h - wo
        } else {
            sample_cosine_hemisphere(u).direction
        };
        BrdfSample {
            wi,
            pdf_sr: self.pdf_sr(wo, wi),
        }
    }

    /// Density of [`BlinnPhong::sample`], in 1/sr: the mixture
    /// `P_s (e+1)/2π cosᵉ θ_h / (4 wo·h) + (1 − P_s) cos θ/π`; 0 where either direction is not above the horizon.
    ///
    /// Over all directions it integrates to 1 less the probability of an impossible sample.
    #[inline]
    #[must_use]
    pub fn pdf_sr(&self, wo: Vec3, wi: Vec3) -> f32 {
        if wo.z <= 0.0 || wi.z <= 0.0 {
            return 0.0;
        }
        let diffuse = pdf_cosine_hemisphere_sr(wi);
        let pmf_specular = self.pmf_specular();
        if pmf_specular <= 0.0 {
            return diffuse;
        }
        let specular = HalfVector::new(wo, wi).pdf_sr(self.exponent);
        pmf_specular * specular + (1.0 - pmf_specular) * diffuse
    }

    /// Probability that [`BlinnPhong::sample`] chooses the specular lobe: its share of the albedo's luminance; 0 for a
    /// black material.
    #[inline]
    #[must_use]
    pub fn pmf_specular(&self) -> f32 {
        let specular = luminance(self.specular);
        let both = luminance(self.diffuse) + specular;
        if both > 0.0 { specular / both } else { 0.0 }
    }

    /// Share of light reflected at normal incidence, per channel: kd + ks. At any other angle it is less.
    #[inline]
    #[must_use]
    pub fn albedo(&self) -> Vec3 {
        self.diffuse + self.specular
    }
}
