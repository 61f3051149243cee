//! Host file: the estimators that a frame may be rendered by, with their settings.

use glimt_sampling::resample::Scheme;
use glimt_sampling::warp::cap_height;
use glimt_smc::Path;

use super::render::SettingsError;
use crate::kernels::bis::Bis;
use crate::kernels::camera::CameraView;
use crate::kernels::candidates;
use crate::kernels::past::PastView;
use crate::kernels::smc::{self, SmcParams};

/// An estimator of reflected radiance.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Method {
    /// Multiple importance sampling (Kronander 2014, Eq. 2).
    #[default]
    Mis,
    /// Bidirectional importance sampling (Kronander 2014, Eqs. 3 and 4).
    Bis,
    /// Sequential Monte Carlo (Kronander 2014, Eqs. 5 to 8): renderers keep particles from frame to frame.
    Smc,
    /// Precomputed radiance transfer (Hajisharif 2012): light and transfer as spherical harmonics; the scene must have a
    /// [`Transfer`](super::transfer::Transfer).
    Prt,
}

/// Where candidates for the product of light and reflection come from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum CandidateSource {
    /// The BRDF's sampler: the paper's choice.
    Brdf,
    /// The light's tables.
    Environment,
    /// Half of each.
    #[default]
    Mixture,
}

/// Settings of [`Method::Bis`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BisSettings {
    /// Candidates M on each ray, at least 1.
    pub candidates: u32,
    /// Directions N that are picked of them and traced, at least 1.
    pub samples: u32,
    /// Where candidates come from.
    pub source: CandidateSource,
}

/// Settings of [`Method::Prt`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PrtSettings {
    /// How often the light map is halved before it is projected.
    pub level: u32,
    /// Width w of the Hann window on the light's coefficients, at most 10⁶; 0 for none.
    pub window: f32,
    /// Share α of the frame before in the filter over time (Eq. 13), from 0 to 10⁶; 0 for none.
    pub temporal: f32,
    /// Whether objects cast shadows.
    pub shadows: bool,
}

impl Default for PrtSettings {
    fn default() -> Self {
        Self {
            level: 0,
            window: 0.0,
            temporal: 0.0,
            shadows: true,
        }
    }
}

impl PrtSettings {
    /// Checks the settings.
    ///
    /// # Errors
    /// [`SettingsError::Prt`].
    pub fn check(&self) -> Result<(), SettingsError> {
        let in_range = |x: f32| x >= 0.0 && x <= 1e6;
        if self.level > 31 || !in_range(self.window) || !in_range(self.temporal) {
            return Err(SettingsError::Prt);
        }
        Ok(())
    }
}

/// Settings of [`Method::Smc`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SmcSettings {
    /// Particles N on each ray, at least 1.
    pub particles: u32,
    /// Targets K between two frames.
    pub intermediate: u32,
    /// How those are mixed of both frames' targets.
    pub path: Path,
    /// How particles are picked anew.
    pub scheme: Scheme,
    /// Share of N below which the effective sample size calls for that; 0 for never.
    pub ess_threshold: f32,
    /// ε: what the target adds to the light's luminance, as a share of the map's mean. 0, as in the paper, loses light that moves onto
    /// what was black.
    pub floor: f32,
    /// Angular radius of the cap of local moves, in radians, in (0, π].
    pub cap_radius: f32,
    /// ν: probability of a local move.
    pub cap_share: f32,
    /// Of the independent draws, the share that comes from the light and not from the BRDF.
    pub light_share: f32,
    /// A set starts anew where Z_t/Z_{t−1} is above this or below its inverse, or all weights are 0; at least 1. 0 for never.
    pub reinitialise: f32,
    /// A set starts anew at this age in frames; 0 for never.
    pub max_age: u32,
    /// Candidates M of a start, at least 1.
    pub candidates: u32,
    /// Where those come from; not the environment alone, which misses where the floor is all there is.
    pub source: CandidateSource,
    /// How far off the surface that was seen in the frame before a point may lie to be found there, as a share of its distance.
    pub depth_tolerance: f32,
    /// The greatest angle between its normal there and here, in radians.
    pub normal_tolerance: f32,
}

impl Default for BisSettings {
    fn default() -> Self {
        Self {
            candidates: 32,
            samples: 2,
            // The paper's BRDF alone misses a sun on a glossy object: at 30 shadow rays its error was 15 to 20 times that of
            // the mixture.
            source: CandidateSource::Mixture,
        }
    }
}

impl Default for SmcSettings {
    fn default() -> Self {
        Self {
            particles: 8,
            intermediate: 3,
            path: Path::Linear,
            scheme: Scheme::Systematic,
            ess_threshold: 2.0 / 3.0,
            floor: 0.01,
            cap_radius: 5.0f32.to_radians(),
            cap_share: 0.5,
            light_share: 0.5,
            reinitialise: 1.25,
            max_age: 0,
            candidates: 64,
            source: CandidateSource::Mixture,
            depth_tolerance: 0.02,
            normal_tolerance: 25.0f32.to_radians(),
        }
    }
}

impl CandidateSource {
    fn code(self) -> u32 {
        match self {
            Self::Brdf => candidates::SOURCE_BRDF,
            Self::Environment => candidates::SOURCE_ENVIRONMENT,
            Self::Mixture => candidates::SOURCE_MIXTURE,
        }
    }
}

impl BisSettings {
    /// What kernels read.
    ///
    /// # Errors
    /// [`SettingsError::NoSamples`].
    pub fn params(&self) -> Result<Bis, SettingsError> {
        if self.candidates == 0 || self.samples == 0 {
            return Err(SettingsError::NoSamples);
        }
        Ok(Bis {
            candidates: self.candidates,
            samples: self.samples,
            source: self.source.code(),
            unused: 0,
        })
    }
}

impl SmcSettings {
    /// What kernels read, under lights of these mean luminances.
    ///
    /// # Errors
    /// [`SettingsError::NoSamples`], [`SettingsError::Smc`].
    pub fn params(&self, mean: f32, previous_mean: f32) -> Result<SmcParams, SettingsError> {
        if self.particles == 0 || self.candidates == 0 {
            return Err(SettingsError::NoSamples);
        }
        let share = |x: f32| x >= 0.0 && x <= 1.0;
        let fits = self.source != CandidateSource::Environment
            && share(self.cap_share)
            && share(self.light_share)
            && self.ess_threshold >= 0.0
            && self.floor >= 0.0
            && self.floor <= 1e6
            && self.cap_radius > 0.0
            && self.cap_radius <= core::f32::consts::PI
            && (self.reinitialise == 0.0 || self.reinitialise >= 1.0)
            && self.depth_tolerance >= 0.0
            && self.normal_tolerance >= 0.0
            && self.intermediate < 1 << 16;
        if !fits {
            return Err(SettingsError::Smc);
        }
        Ok(SmcParams {
            intermediate: self.intermediate,
            path: match self.path {
                Path::Linear => smc::PATH_LINEAR,
                Path::Geometric => smc::PATH_GEOMETRIC,
            },
            scheme: match self.scheme {
                Scheme::Systematic => smc::SCHEME_SYSTEMATIC,
                Scheme::Stratified => smc::SCHEME_STRATIFIED,
                Scheme::Multinomial => smc::SCHEME_MULTINOMIAL,
                Scheme::Residual => smc::SCHEME_RESIDUAL,
            },
            ess_threshold: self.ess_threshold,
            floor: self.floor * mean,
            previous_floor: self.floor * previous_mean,
            cap_height: cap_height(self.cap_radius),
            cap_share: self.cap_share,
            light_share: self.light_share,
            // 1 means at every frame, which a logarithm of 0 would not.
            band: if self.reinitialise == 0.0 {
                0.0
            } else {
                self.reinitialise.ln().max(f32::MIN_POSITIVE)
            },
            max_age: self.max_age,
            candidates: self.candidates,
            source: self.source.code(),
            unused_a: 0,
            unused_b: 0,
            unused_c: 0,
        })
    }

    /// From where the frame before was seen, with `pixels` pixels' rays at hand from `first_pixel` on.
    #[must_use]
    pub fn past_view(&self, view: &CameraView, first_pixel: u32, pixels: u32) -> PastView {
        PastView {
            eye: view.eye,
            first_pixel,
            forward: view.forward,
            pixels,
            right: view.right,
            depth_tolerance: self.depth_tolerance,
            up: view.up,
            normal_cosine: self.normal_tolerance.min(core::f32::consts::PI).cos(),
        }
    }
}
