//! Host file: keys of the estimators of reflected light.

use super::words;
use glimt_render_gpu::host::bake::BakeSettings;
use glimt_render_gpu::host::render::{self, BisSettings, PrtSettings, SmcSettings};
use glimt_sampling::resample;
use serde::{Deserialize, Serialize};

/// Bidirectional importance sampling, `render.method = "bis"`.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct Bis {
    /// Candidates on each ray.
    pub candidates: u32,
    /// Directions that are picked of them, each with a shadow ray.
    pub samples: u32,
    /// Where candidates come from.
    pub source: Source,
}

/// The sequential sampler, `render.method = "smc"`.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct Smc {
    /// Particles on each ray, each with a shadow ray.
    pub particles: u32,
    /// Distributions between two frames.
    pub intermediate: u32,
    /// How those are mixed of both frames'.
    pub path: Path,
    /// How particles are picked anew.
    pub resampling: Resampling,
    /// Share of the particles below which the effective sample size calls for that; 0 for never.
    pub ess_threshold: f32,
    /// What is added to the light's luminance, as a share of the map's mean; 0 as in the paper.
    pub floor: f32,
    /// Angular radius of local moves, in degrees.
    pub cap_deg: f32,
    /// Probability of a local move.
    pub cap_share: f32,
    /// Of the independent draws, the share that comes from the light.
    pub light_share: f32,
    /// A ray starts anew where its normaliser grows or shrinks by more than this factor in a frame; 0 for never.
    pub reinitialise: f32,
    /// A ray starts anew after so many frames; 0 for never.
    pub max_age: u32,
    /// Candidates of a start.
    pub candidates: u32,
    /// Where those come from.
    pub source: Source,
    /// How far off the surface seen in the frame before a point may lie to be found there, as a share of its distance.
    pub depth_tolerance: f32,
    /// How far its normal may be off, in degrees.
    pub normal_tolerance_deg: f32,
}

/// Precomputed radiance transfer, `render.method = "prt"` and `glimt bake`.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct Prt {
    /// File of the transfer that `glimt bake` computes; beside the shot, as `SHOT.prt.glb`, if empty.
    pub bake: String,
    /// Bands of spherical harmonics, 1 to 6.
    pub bands: u32,
    /// Directions of the whole sphere in which visibility is looked for, at each vertex.
    pub directions: u32,
    /// How often the light map is halved before it is projected.
    pub level: u32,
    /// Width of the Hann window on the light's bands, against ringing: as wide as there are bands is usual; 0 for none.
    pub window: f32,
    /// How much of the frame before goes into the light of a frame: `(now + temporal · before)/(1 + temporal)`.
    pub temporal: f32,
    /// Whether objects cast shadows.
    pub shadows: bool,
}

impl Default for Prt {
    fn default() -> Self {
        let (bake, default) = (BakeSettings::default(), PrtSettings::default());
        Self {
            bake: String::new(),
            bands: bake.bands,
            directions: bake.directions,
            level: default.level,
            window: default.window,
            temporal: default.temporal,
            shadows: default.shadows,
        }
    }
}

impl Prt {
    /// As the renderer takes them.
    pub fn settings(&self) -> PrtSettings {
        PrtSettings {
            level: self.level,
            window: self.window,
            temporal: self.temporal,
            shadows: self.shadows,
        }
    }
}

words! {
    /// Where candidates come from.
    Source {
        /// The material.
        Brdf = "brdf",
        /// The light.
        Environment = "environment",
        /// Half of each.
        #[default] Mixture = "mixture",
    }
}
words! {
    /// How distributions between two frames are mixed.
    Path {
        /// `(1 − β) a + β b`.
        #[default] Linear = "linear",
        /// `a^(1 − β) b^β`.
        Geometric = "geometric",
    }
}
words! {
    /// How particles are picked anew.
    Resampling {
        /// Equally spaced picks.
        #[default] Systematic = "systematic",
        /// One pick in each stratum.
        Stratified = "stratified",
        /// Independent picks.
        Multinomial = "multinomial",
        /// Sure copies, and independent picks for the rest.
        Residual = "residual",
    }
}

impl Default for Bis {
    fn default() -> Self {
        let BisSettings {
            candidates,
            samples,
            source,
        } = BisSettings::default();
        Self {
            candidates,
            samples,
            source: Source::of(source),
        }
    }
}

impl Default for Smc {
    fn default() -> Self {
        let default = SmcSettings::default();
        Self {
            particles: default.particles,
            intermediate: default.intermediate,
            path: Path::Linear,
            resampling: Resampling::Systematic,
            ess_threshold: default.ess_threshold,
            floor: default.floor,
            cap_deg: 5.0,
            cap_share: default.cap_share,
            light_share: default.light_share,
            reinitialise: default.reinitialise,
            max_age: default.max_age,
            candidates: default.candidates,
            source: Source::of(default.source),
            depth_tolerance: default.depth_tolerance,
            normal_tolerance_deg: 25.0,
        }
    }
}

impl Source {
    fn of(source: render::CandidateSource) -> Self {
        match source {
            render::CandidateSource::Brdf => Self::Brdf,
            render::CandidateSource::Environment => Self::Environment,
            render::CandidateSource::Mixture => Self::Mixture,
        }
    }

    fn setting(self) -> render::CandidateSource {
        match self {
            Self::Brdf => render::CandidateSource::Brdf,
            Self::Environment => render::CandidateSource::Environment,
            Self::Mixture => render::CandidateSource::Mixture,
        }
    }
}

impl Bis {
    /// As the renderer takes them.
    pub fn settings(&self) -> BisSettings {
        BisSettings {
            candidates: self.candidates,
            samples: self.samples,
            source: self.source.setting(),
        }
    }
}

impl Smc {
    /// As the renderer takes them.
    pub fn settings(&self) -> SmcSettings {
        SmcSettings {
            particles: self.particles,
            intermediate: self.intermediate,
            path: match self.path {
                Path::Linear => glimt_smc::Path::Linear,
                Path::Geometric => glimt_smc::Path::Geometric,
            },
            scheme: match self.resampling {
                Resampling::Systematic => resample::Scheme::Systematic,
                Resampling::Stratified => resample::Scheme::Stratified,
                Resampling::Multinomial => resample::Scheme::Multinomial,
                Resampling::Residual => resample::Scheme::Residual,
            },
            ess_threshold: self.ess_threshold,
            floor: self.floor,
            cap_radius: self.cap_deg.to_radians(),
            cap_share: self.cap_share,
            light_share: self.light_share,
            reinitialise: self.reinitialise,
            max_age: self.max_age,
            candidates: self.candidates,
            source: self.source.setting(),
            depth_tolerance: self.depth_tolerance,
            normal_tolerance: self.normal_tolerance_deg.to_radians(),
        }
    }
}
