//! Host file: what an executor is asked for and what it gives back.

use super::scene::Camera;
use glam::{UVec2, Vec4};

/// All that one frame needs beside the scene and its light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RenderSettings {
    /// Image width and height in pixels.
    pub size: UVec2,
    /// Where it is seen from.
    pub camera: Camera,
    /// Rays per pixel R, at least 1.
    pub rays_per_pixel: u32,
    /// BRDF samples N_ρ on each ray; 0 leaves the environment's alone.
    pub brdf_samples: u32,
    /// Environment samples N_L on each ray; 0 leaves the BRDF's alone.
    pub env_samples: u32,
    /// How reflected light is estimated.
    pub method: Method,
    /// Where the uniforms come from.
    pub pattern: Pattern,
    /// Where in its pixel a ray passes.
    pub filter: Filter,
    /// What is seen where no object is.
    pub background: Background,
    /// Key of the random streams.
    pub seed: u32,
    /// Number of the frame, the second key of the random streams.
    pub frame: u32,
    /// Exposure of the display image: linear values are multiplied by 2^exposure_ev.
    pub exposure_ev: f32,
    /// Curve of the display image.
    pub tonemap: Tonemap,
}

/// An estimator of reflected radiance.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Method {
    /// Multiple importance sampling (Kronander 2014, Eq. 2).
    #[default]
    Mis,
}

/// A sample pattern.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Pattern {
    /// Owen-scrambled Sobol points, one sequence for each pixel (Burley 2020).
    #[default]
    OwenSobol,
    /// Independent uniforms, as in the papers.
    Independent,
    /// Independent uniforms, of which each set of n samples is spread over n strata.
    Stratified,
}

/// A reconstruction filter.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Filter {
    /// Rays anywhere in the pixel, averaged.
    #[default]
    Box,
    /// All rays through the pixel's centre.
    Centre,
}

/// What is seen where no object is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Background {
    /// The light map, with alpha 1.
    #[default]
    Environment,
    /// Nothing: black with alpha 0, to be laid over a plate.
    Transparent,
}

/// The curve of the display image, applied after the exposure.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Tonemap {
    /// Clipped to [0, 1], then the sRGB curve.
    #[default]
    Srgb,
    /// `x / (1 + x)` in each channel, then the sRGB curve.
    Reinhard,
}

/// A rendered frame, rows from the top.
#[derive(Clone, Debug)]
pub struct FrameImage {
    /// Width and height in pixels.
    pub size: UVec2,
    /// Linear radiance, alpha in w; colours are premultiplied by it.
    pub linear: Vec<Vec4>,
    /// The same after exposure and tonemapping: red, green, blue, alpha (premultiplied before the curve).
    pub display: Vec<[u8; 4]>,
}
