//! Shared file: multiple importance sampling of reflected light (Kronander 2014, Eq. 2).

use glimt_sampling::mis::multi_sample_density;
use glimt_sampling::uniform::unit_vec2;

use super::environment::Environment;
use super::estimator::{Estimator, LightSample, Reflected};
use super::pattern::{BRDF, ENVIRONMENT, LIT_THROUGH, PixelPattern};
use super::scene::{Scene, ShadingPoint};

/// `L̂ = Σ L(ω) ρ(ωo, ω) V(ω) ⟨ω·n⟩ / (N_ρ q_ρ(ω) + N_L q_L(ω))` over N_ρ samples of the BRDF and N_L of the
/// environment: the balance heuristic of Veach and Guibas 1995.
///
/// q_L is the density of the environment's tables, whichever the host built. Compensated ones (Karlík et al. 2019) are 0 where there
/// is light, so they need an N_ρ above 0.
///
/// With one of the counts zero it is importance sampling of the other alone. Impossible samples contribute 0 and count.
///
/// Differs from the paper, whose print omits the counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct Mis {
    /// N_ρ.
    pub brdf_samples: u32,
    /// N_L.
    pub env_samples: u32,
}

impl Mis {
    /// Direction `sample` of the BRDF's strategy.
    #[inline]
    #[must_use]
    pub fn brdf_sample(
        &self,
        sample: u32,
        point: &ShadingPoint,
        pattern: &PixelPattern,
        env: Environment<'_>,
    ) -> LightSample {
        let u = pattern.triple(BRDF, sample, self.brdf_samples);
        let drawn = point.brdf.sample(point.wo, u.z, unit_vec2(u.truncate()));
        if !(drawn.pdf_sr > 0.0) {
            return LightSample::IMPOSSIBLE;
        }
        let direction = point.frame.to_world(drawn.wi);
        let texel = env.texel(direction);
        let density = self.density(drawn.pdf_sr, env.cdf().texel_pdf_sr(texel));
        LightSample::new(point, direction, drawn.wi, env.radiance(texel), density)
    }

    /// Direction `sample` of the environment's strategy.
    #[inline]
    #[must_use]
    pub fn env_sample(
        &self,
        sample: u32,
        point: &ShadingPoint,
        pattern: &PixelPattern,
        env: Environment<'_>,
    ) -> LightSample {
        let u = pattern.pair(ENVIRONMENT, sample, self.env_samples);
        let drawn = env.sample(u);
        if !(drawn.pdf_sr > 0.0) {
            return LightSample::IMPOSSIBLE;
        }
        let wi = point.frame.to_local(drawn.direction);
        let density = self.density(point.brdf.pdf_sr(point.wo, wi), drawn.pdf_sr);
        LightSample::new(
            point,
            drawn.direction,
            wi,
            env.radiance(drawn.texel),
            density,
        )
    }

    #[inline]
    fn density(&self, brdf_pdf_sr: f32, env_pdf_sr: f32) -> f32 {
        multi_sample_density(self.brdf_samples, brdf_pdf_sr, self.env_samples, env_pdf_sr)
    }
}

impl Estimator for Mis {
    #[inline]
    fn reflected(
        &self,
        point: &ShadingPoint,
        pattern: &PixelPattern,
        env: Environment<'_>,
        scene: Scene<'_>,
    ) -> Reflected {
        let key = pattern.ray_key(LIT_THROUGH);
        let mut sum = Reflected::NONE;
        for i in 0..self.brdf_samples {
            let sample = self.brdf_sample(i, point, pattern, env);
            sum.gather(sample.traced(point, scene, key.wrapping_add(i)));
        }
        for i in 0..self.env_samples {
            let sample = self.env_sample(i, point, pattern, env);
            sum.gather(sample.traced(point, scene, key.wrapping_add(self.brdf_samples + i)));
        }
        sum
    }
}
