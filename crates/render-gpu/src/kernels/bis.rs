//! Shared file: bidirectional importance sampling of reflected light (Kronander 2014, Eqs. 3 and 4).

use glimt_sampling::ris::{RisPicks, RisSum};

use super::candidates::{CandidateSource, Candidates};
use super::environment::Environment;
use super::estimator::{Estimator, LightSample, Reflected};
use super::pattern::{LIT_THROUGH, PixelPattern, RESAMPLE};
use super::scene::{Scene, ShadingPoint};

/// Sampling-importance-resampling for the product of light and reflection: of M candidates, N directions are picked in
/// proportion to `γ/q` with `γ = Y(L) Y(ρ) ⟨ω·n⟩`, and shadow rays are traced for those alone. With Ẑ the mean of γ/q,
///
/// `L̂ = Ẑ (1/N) Σ L(ω_i) ρ(ω_i) V(ω_i) / (Y(L(ω_i)) Y(ρ(ω_i)))`,
///
/// unbiased for any M, N ≥ 1 (Talbot 2005). No candidate is stored: they are drawn twice. A direction that is picked more than once
/// is traced once. 12 bytes.
///
/// Differs from the paper, whose print omits 1/N, and the division by q in Ẑ.
#[derive(Clone, Copy, Debug, PartialEq, Eq, bytemuck::NoUninit)]
#[repr(C)]
pub struct Bis {
    /// M.
    pub candidates: u32,
    /// N.
    pub samples: u32,
    /// Where candidates come from.
    pub source: CandidateSource,
}

impl Estimator for Bis {
    #[inline]
    fn reflected(
        &self,
        point: &ShadingPoint,
        pattern: &PixelPattern,
        env: Environment<'_>,
        scene: Scene<'_>,
    ) -> Reflected {
        let candidates = Candidates {
            count: self.candidates,
            source: self.source,
            floor: 0.0,
        };
        let mut weights = RisSum::new();
        for j in 0..self.candidates {
            weights.add(candidates.draw(j, point, pattern, env).weight);
        }
        let key = pattern.ray_key(LIT_THROUGH);
        let mut sum = Reflected::NONE;
        let mut picks = RisPicks::new(&weights, self.samples, pattern.pair(RESAMPLE, 0, 1).x);
        let scale = self.samples as f32 / weights.normaliser().max(f32::MIN_POSITIVE);
        let mut j = 0;
        while j < self.candidates && !picks.is_done() {
            let candidate = candidates.draw(j, point, pattern, env);
            let copies = picks.take(candidate.weight);
            if copies > 0 {
                let density = candidate.target * (scale / copies as f32);
                let sample = LightSample::new(
                    point,
                    candidate.direction,
                    candidate.wi,
                    candidate.radiance,
                    density,
                );
                sum.gather(sample.traced(point, scene, key.wrapping_add(j)));
            }
            j += 1;
        }
        sum
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn layout_is_that_of_wgsl() {
        assert_eq!(core::mem::size_of::<Bis>(), 12);
        assert_eq!(core::mem::offset_of!(Bis, source), 8);
    }
}
