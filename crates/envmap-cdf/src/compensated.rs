//! Shared file: MIS compensation, an environment density that leaves to the other strategy what that does well.

use glam::{UVec2, Vec3};
use glimt_sampling::mis::multi_sample_density;

use crate::env_cdf::EnvCdf;

/// Tables of *compensated* weights `max(0, L − L̄)`, `L̄` the mean weight over the sphere (Karlík et al. 2019): all
/// samples go where the map is brighter than its mean.
///
/// Where the map is darker the density is 0, so these samples **cannot stand alone**: an estimate from them misses that
/// light. They are right in multiple importance sampling together with a strategy whose density is positive wherever
/// the integrand is, as sampling the BRDF. So this type gives no density away, only the factor of the balance
/// heuristic, which asks for the other strategy's count and density:
///
/// `F = Σ f(ω_i) · balance_factor(ω_i)`, the sum over the samples of **both** strategies, those of the environment by
/// [`CompensatedSample::balance_factor`], the others by [`CompensatedCdf::balance_factor`].
///
/// The constant map has nothing above its mean and is black here: its samples are impossible, and the other strategy
/// does all the work.
///
/// ```
/// use glam::UVec2;
/// use glimt_envmap_cdf::{CompensatedCdf, build_compensated_into, required_len};
///
/// let size = UVec2::new(2, 1);
/// let len = required_len(2, 1)?;
/// let (mut marginal, mut conditional) = (vec![0; len.marginal], vec![0; len.conditional]);
/// build_compensated_into(size, |_| [1.0, 3.0], &mut marginal, &mut conditional)?;
/// let env = CompensatedCdf::new(size, &marginal, &conditional).unwrap();
///
/// // Every environment sample lies in the bright half, of density 1/2π, beside a uniform density of 1/4π.
/// let uniform_pdf_sr = 0.25 * core::f32::consts::FRAC_1_PI;
/// let sample = env.sample(UVec2::ZERO);
/// assert_eq!(sample.texel, UVec2::new(1, 0));
/// assert!((sample.balance_factor(1, 1, uniform_pdf_sr) * 3.0 * uniform_pdf_sr - 1.0).abs() < 1e-6);
/// // A uniform sample in the dark half has all of the weight.
/// let factor = env.balance_factor(UVec2::ZERO, 1, 1, uniform_pdf_sr);
/// assert!((factor * uniform_pdf_sr - 1.0).abs() < 1e-6);
/// # Ok::<(), glimt_envmap_cdf::BuildError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct CompensatedCdf<'a> {
    pub(crate) env: EnvCdf<'a>,
}

/// A direction drawn from [`CompensatedCdf`], for use beside another strategy.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CompensatedSample {
    /// The texel, `(column, row)`, which gives the sample's radiance.
    pub texel: UVec2,
    /// Unit vector towards the environment.
    pub direction: Vec3,
    pdf_sr: f32,
}

impl<'a> CompensatedCdf<'a> {
    /// Whether no texel is brighter than the mean: all samples are then impossible.
    #[inline]
    #[must_use]
    pub fn is_black(&self) -> bool {
        self.env.is_black()
    }

    /// Draws a direction, as [`EnvCdf::sample`] does.
    #[inline]
    #[must_use]
    pub fn sample(&self, u: UVec2) -> CompensatedSample {
        let sample = self.env.sample(u);
        CompensatedSample {
            texel: sample.texel,
            direction: sample.direction,
            pdf_sr: sample.pdf_sr,
        }
    }

    /// What a sample of the *other* strategy in this texel is multiplied by: `1 / (n_env p_env + n_other p_other)`, in
    /// sr. `other_pdf_sr` is its own density, in 1/sr; where that is 0 the sample is impossible and the factor is 0.
    #[inline]
    #[must_use]
    pub fn balance_factor(&self, texel: UVec2, n_env: u32, n_other: u32, other_pdf_sr: f32) -> f32 {
        if n_other > 0 && other_pdf_sr > 0.0 {
            let pdf_sr = self.env.texel_pdf_sr(texel);
            return 1.0 / multi_sample_density(n_env, pdf_sr, n_other, other_pdf_sr);
        }
        0.0
    }
}

impl CompensatedSample {
    /// What this sample is multiplied by: `1 / (n_env p_env + n_other p_other)`, in sr; `other_pdf_sr` is the other
    /// strategy's density in this direction, in 1/sr.
    ///
    /// 0 for an impossible sample, and 0 where `n_other` is 0: without another strategy the estimate would be biased
    /// unseen, so it is black instead.
    #[inline]
    #[must_use]
    pub fn balance_factor(&self, n_env: u32, n_other: u32, other_pdf_sr: f32) -> f32 {
        if n_env > 0 && n_other > 0 && self.pdf_sr > 0.0 {
            return 1.0 / multi_sample_density(n_env, self.pdf_sr, n_other, other_pdf_sr);
        }
        0.0
    }
}
