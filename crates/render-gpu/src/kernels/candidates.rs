//! Shared file: candidates for the product of light and reflection, drawn from one of the two or from both.

use glam::Vec3;
use glimt_sampling::math::luminance;
use glimt_sampling::uniform::unit_vec2;

use super::environment::Environment;
use super::pattern::{CANDIDATE_BRDF, CANDIDATE_ENVIRONMENT, PixelPattern};
use super::scene::ShadingPoint;

/// Where candidates come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, bytemuck::NoUninit)]
#[repr(u32)]
pub enum CandidateSource {
    /// The BRDF's sampler: the paper's choice.
    Brdf = 0,
    /// The environment's tables.
    Environment = 1,
    /// Half of each, with the density of their mixture.
    Mixture = 2,
}

/// Candidates ω_j ~ q for the target `γ(ω) = (Y(L(ω)) + floor) Y(ρ(ωo, ω)) ⟨ω·n⟩`, Y the luminance: each a function of its
/// index, so that they can be drawn again.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Candidates {
    /// M.
    pub count: u32,
    /// Where they come from.
    pub source: CandidateSource,
    /// What the target adds to the luminance.
    pub floor: f32,
}

/// A candidate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Candidate {
    /// Unit vector in the world.
    pub direction: Vec3,
    /// The same in the point's frame.
    pub wi: Vec3,
    /// Radiance that comes from there.
    pub radiance: Vec3,
    /// The target γ there.
    pub target: f32,
    /// `γ/q`; 0 where it is impossible.
    pub weight: f32,
}

impl Candidate {
    /// One that counts for nothing but itself.
    pub const IMPOSSIBLE: Candidate = Candidate {
        direction: Vec3::Z,
        wi: Vec3::Z,
        radiance: Vec3::ZERO,
        target: 0.0,
        weight: 0.0,
    };
}

impl Candidates {
    /// How many come from the BRDF.
    #[inline]
    #[must_use]
    pub fn of_brdf(&self) -> u32 {
        if self.source == CandidateSource::Brdf {
            self.count
        } else if self.source == CandidateSource::Environment {
            0
        } else {
            self.count.div_ceil(2)
        }
    }

    /// Candidate `index` of a point.
    #[inline]
    #[must_use]
    pub fn draw(
        &self,
        index: u32,
        point: &ShadingPoint,
        pattern: &PixelPattern,
        env: Environment<'_>,
    ) -> Candidate {
        let of_brdf = self.of_brdf();
        let of_env = self.count - of_brdf;
        // Of the mixture `(M_ρ q_ρ + M_L q_L)/M`, times M.
        let mut density = 0.0;
        let direction;
        let wi;
        let radiance;
        if index < of_brdf {
            let u = pattern.triple(CANDIDATE_BRDF, index, of_brdf);
            let drawn = point.brdf.sample(point.wo, u.z, unit_vec2(u.truncate()));
            if !(drawn.pdf_sr > 0.0) {
                return Candidate::IMPOSSIBLE;
            }
            wi = drawn.wi;
            direction = point.frame.to_world(wi);
            let texel = env.texel(direction);
            radiance = env.radiance(texel);
            density += of_brdf as f32 * drawn.pdf_sr;
            if of_env > 0 {
                density += of_env as f32 * env.cdf().texel_pdf_sr(texel);
            }
        } else {
            let u = pattern.pair(CANDIDATE_ENVIRONMENT, index - of_brdf, of_env);
            let drawn = env.sample(u);
            if !(drawn.pdf_sr > 0.0) {
                return Candidate::IMPOSSIBLE;
            }
            direction = drawn.direction;
            wi = point.frame.to_local(direction);
            radiance = env.radiance(drawn.texel);
            density += of_env as f32 * drawn.pdf_sr;
            if of_brdf > 0 {
                density += of_brdf as f32 * point.brdf.pdf_sr(point.wo, wi);
            }
        }
        if !(wi.z > 0.0) {
            return Candidate::IMPOSSIBLE;
        }
        let reflected = luminance(point.brdf.eval(point.wo, wi)) * wi.z;
        let target = (luminance(radiance) + self.floor) * reflected;
        Candidate {
            direction,
            wi,
            radiance,
            target,
            weight: target * (self.count as f32 / density),
        }
    }
}
