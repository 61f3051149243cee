//! Host file: what an executor is asked for and what it gives back.

use std::time::Duration;

use glam::{UVec2, Vec4};
use glimt_sh::ShError;

use super::env::PreparedEnv;
pub use super::methods::{BisSettings, CandidateSource, Method, PrtSettings, SmcSettings};
use super::plate::Plate;
use super::scene::Camera;
use super::scene_build::SceneBuffers;
use super::smc_state::SmcState;
use crate::kernels::camera::CameraView;
use crate::kernels::frame::{self, FrameParams};
use crate::kernels::layers::PixelLayers;

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
    /// How, by [`Method::Bis`].
    pub bis: BisSettings,
    /// How, by [`Method::Smc`].
    pub smc: SmcSettings,
    /// How, by [`Method::Prt`].
    pub prt: PrtSettings,
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
    /// Curve of the display image. Over a plate, exposure and curve are those of the objects alone.
    pub tonemap: Tonemap,
    /// How a plate takes shadows.
    pub shadow: Shadow,
    /// Whether the image comes with its layers.
    pub layers: bool,
    /// Whether the image is to have [`FrameImage::diagnostics`].
    pub diagnostics: bool,
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

/// How a plate takes the shadows of objects on catchers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Shadow {
    /// It is multiplied by the share of the catchers' light that is left: the plate keeps its texture, and the catcher's
    /// albedo cancels out.
    #[default]
    Multiply,
    /// The light that the catchers lose is subtracted (Debevec 1998): right where the catchers' albedo is the plate's, and
    /// the light map is in the plate's units after the exposure.
    Add,
}

/// A rendered frame, rows from the top.
#[derive(Clone, Debug)]
pub struct FrameImage {
    /// Width and height in pixels.
    pub size: UVec2,
    /// Linear radiance, alpha in w; colours are premultiplied by it. Over a plate it is in the plate's units: the objects
    /// are exposed, but not tonemapped.
    pub linear: Vec<Vec4>,
    /// What is displayed, after exposure and tonemapping: red, green, blue and straight alpha.
    pub display: Vec<[u8; 4]>,
    /// The layers that it was composited of, not exposed, where they were asked for.
    pub layers: Option<Vec<PixelLayers>>,
    /// How the particles of [`Method::Smc`] fare, where it was asked for: as
    /// [`diagnose_smc`](crate::kernels::smc::diagnose_smc) has it.
    pub diagnostics: Option<Vec<Vec4>>,
}

/// Something that turns scenes into frames: the CPU or a GPU.
pub trait Renderer {
    /// What it is, for messages: the processor's or adapter's name.
    fn name(&self) -> String;

    /// Renders one frame over a plate of the same size, or over the background of the settings. `progress` is told, from any
    /// thread, the fraction that is done.
    ///
    /// # Errors
    /// A [`RenderError`].
    fn render_over(
        &mut self,
        scene: &SceneBuffers,
        env: &PreparedEnv,
        plate: Option<&Plate>,
        settings: &RenderSettings,
        progress: &(dyn Fn(f32) + Sync),
    ) -> Result<FrameImage, RenderError>;

    /// Renders one frame without a plate.
    ///
    /// # Errors
    /// A [`RenderError`].
    fn render_frame(
        &mut self,
        scene: &SceneBuffers,
        env: &PreparedEnv,
        settings: &RenderSettings,
        progress: &(dyn Fn(f32) + Sync),
    ) -> Result<FrameImage, RenderError> {
        self.render_over(scene, env, None, settings, progress)
    }

    /// Where the last frame's time went, where the renderer knows: names of phases with their times, none of them in another.
    fn phases(&self) -> Vec<(&'static str, Duration)> {
        Vec::new()
    }

    /// What [`Method::Smc`] would go on from; `None` before its first frame.
    ///
    /// A frame goes on from the one that was rendered before it where both have the same image size, rays per pixel, particles,
    /// seed and objects; else it starts anew.
    ///
    /// # Errors
    /// A [`RenderError`].
    fn smc_state(&mut self) -> Result<Option<SmcState>, RenderError>;

    /// Makes [`Method::Smc`] go on from another frame; with `None` the next one starts anew. By [`Method::Prt`], the next frame
    /// starts anew in either case.
    ///
    /// # Errors
    /// A [`RenderError`].
    fn set_smc_state(&mut self, state: Option<SmcState>) -> Result<(), RenderError>;
}

/// Why no frame was rendered.
#[derive(Debug, thiserror::Error)]
pub enum RenderError {
    /// The settings make no sense.
    #[error(transparent)]
    Settings(#[from] SettingsError),
    /// The device refused or failed.
    #[error(transparent)]
    Device(Box<dyn std::error::Error + Send + Sync>),
}

impl RenderError {
    /// The failure of a device.
    pub(crate) fn device<E: std::error::Error + Send + Sync + 'static>(error: E) -> Self {
        Self::Device(Box::new(error))
    }
}

/// Why settings were refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum SettingsError {
    /// Width, height or rays per pixel is 0.
    #[error("an image needs a width, a height and at least one ray per pixel")]
    Empty,
    /// The method's counts of samples, candidates or particles are 0.
    #[error(
        "there must be samples: of the BRDF or the environment, candidates and picks, or particles"
    )]
    NoSamples,
    /// Pixels, or the samples of one, outgrow 32 bits.
    #[error("width × height, and the samples of a pixel, must each stay below 2^32")]
    TooMany,
    /// The camera looks nowhere.
    #[error("the camera needs finite eye, target and up, with up not along the line of sight")]
    Camera,
    /// The field of view is not in (0, π).
    #[error("the horizontal field of view must lie between 0 and 180 degrees")]
    FieldOfView,
    /// The exposure's factor outgrows 32 bits.
    #[error("2 to the power of the exposure must be finite")]
    Exposure,
    /// A setting of the sequential sampler is out of range.
    #[error(
        "a setting of the sequential sampler is out of its range, or its candidates come from the environment alone"
    )]
    Smc,
    /// A setting of precomputed radiance transfer is out of range.
    #[error("level must be at most 31, window and temporal from 0 to 1e6")]
    Prt,
    /// The light has no such coefficients.
    #[error("the light's spherical harmonics: {0}")]
    Harmonics(ShError),
    /// The scene has no transfer, or lost it when an object moved.
    #[error("the scene has no precomputed transfer for where its objects stand")]
    NoTransfer,
    /// The plate is of another size than the image.
    #[error("the plate must have the image's size")]
    PlateSize,
}

impl RenderSettings {
    /// Settings for an image of `size` pixels with all else at its default: 16 rays a pixel with one sample of each
    /// kind.
    pub fn new(size: UVec2, camera: Camera) -> Self {
        Self {
            size,
            camera,
            rays_per_pixel: 16,
            brdf_samples: 1,
            env_samples: 1,
            method: Method::default(),
            bis: BisSettings::default(),
            smc: SmcSettings::default(),
            prt: PrtSettings::default(),
            pattern: Pattern::default(),
            filter: Filter::default(),
            background: Background::default(),
            seed: 1,
            frame: 0,
            exposure_ev: 0.0,
            tonemap: Tonemap::default(),
            shadow: Shadow::default(),
            layers: false,
            diagnostics: false,
        }
    }

    /// Whether such a frame is made in layers: over a plate, with catchers, or where the layers are asked for. Others are spared
    /// the cost.
    #[must_use]
    pub fn in_layers(&self, scene: &SceneBuffers, plate: Option<&Plate>) -> bool {
        self.layers || plate.is_some() || scene.has_catcher()
    }

    /// As [`RenderSettings::frame_params`], for a frame over this plate: what is behind the objects is the plate.
    ///
    /// # Errors
    /// A [`SettingsError`].
    pub fn frame_params_over(&self, plate: Option<&Plate>) -> Result<FrameParams, SettingsError> {
        let Some(plate) = plate else {
            return self.frame_params();
        };
        if plate.size() != self.size {
            return Err(SettingsError::PlateSize);
        }
        let over = Self {
            background: Background::Transparent,
            ..*self
        };
        over.frame_params()
    }

    /// Checks the settings and makes of them what kernels read, with the first tile at pixel 0.
    ///
    /// # Errors
    /// A [`SettingsError`].
    pub fn frame_params(&self) -> Result<FrameParams, SettingsError> {
        if self.size.min_element() == 0 || self.rays_per_pixel == 0 {
            return Err(SettingsError::Empty);
        }
        let per_ray = match self.method {
            Method::Mis => self.brdf_samples.max(self.env_samples),
            Method::Bis => {
                let bis = self.bis.params()?;
                bis.candidates.max(bis.samples)
            }
            Method::Smc => {
                self.smc.params(0.0, 0.0)?;
                self.smc.candidates.max(self.smc.particles)
            }
            Method::Prt => {
                self.prt.check()?;
                1
            }
        };
        if per_ray == 0 {
            return Err(SettingsError::NoSamples);
        }
        // Kernels number rays within a tile, so all rays of an image may be more.
        let pixels = self.size.x.checked_mul(self.size.y);
        let samples = self.rays_per_pixel.checked_mul(per_ray);
        if pixels.is_none() || samples.is_none() {
            return Err(SettingsError::TooMany);
        }
        let exposure = self.exposure_ev.exp2();
        if !(exposure <= f32::MAX) {
            return Err(SettingsError::Exposure);
        }
        let view = self.camera.view(self.size)?;
        Ok(FrameParams {
            eye: view.eye,
            width: self.size.x,
            forward: view.forward,
            height: self.size.y,
            right: view.right,
            rays_per_pixel: self.rays_per_pixel,
            up: view.up,
            first_pixel: 0,
            brdf_samples: self.brdf_samples,
            env_samples: self.env_samples,
            pattern: match self.pattern {
                Pattern::OwenSobol => frame::PATTERN_OWEN_SOBOL,
                Pattern::Independent => frame::PATTERN_INDEPENDENT,
                Pattern::Stratified => frame::PATTERN_STRATIFIED,
            },
            filter: match self.filter {
                Filter::Box => frame::FILTER_BOX,
                Filter::Centre => frame::FILTER_CENTRE,
            },
            background: match self.background {
                Background::Environment => frame::BACKGROUND_ENVIRONMENT,
                Background::Transparent => frame::BACKGROUND_TRANSPARENT,
            },
            seed: self.seed,
            frame: self.frame,
            tonemap: match self.tonemap {
                Tonemap::Srgb => frame::TONEMAP_SRGB,
                Tonemap::Reinhard => frame::TONEMAP_REINHARD,
            },
            exposure,
            shadow: match self.shadow {
                Shadow::Multiply => frame::SHADOW_MULTIPLY,
                Shadow::Add => frame::SHADOW_ADD,
            },
            // Particles stay with their rays, so those must stand still.
            film_frame: match self.method {
                Method::Smc => 0,
                Method::Mis | Method::Bis | Method::Prt => self.frame,
            },
            unused_c: 0,
        })
    }
}

impl Camera {
    /// The camera as kernels see it, for an image of `size` pixels: pixels are square.
    ///
    /// # Errors
    /// [`SettingsError::Camera`] and [`SettingsError::FieldOfView`].
    pub fn view(&self, size: UVec2) -> Result<CameraView, SettingsError> {
        if !(self.fov_x > 0.0 && self.fov_x < core::f32::consts::PI) {
            return Err(SettingsError::FieldOfView);
        }
        let eye = self.eye.as_dvec3();
        let forward = (self.target.as_dvec3() - eye)
            .try_normalize()
            .ok_or(SettingsError::Camera)?;
        let up = self
            .up
            .as_dvec3()
            .try_normalize()
            .ok_or(SettingsError::Camera)?;
        let across = forward.cross(up);
        if !(across.length() > 1e-6 && eye.is_finite()) {
            return Err(SettingsError::Camera);
        }
        let right = across.normalize();
        let half_width = f64::from(0.5 * self.fov_x).tan();
        let half_height = half_width * f64::from(size.y) / f64::from(size.x);
        Ok(CameraView {
            eye: self.eye,
            forward: forward.as_vec3(),
            right: (right * half_width).as_vec3(),
            up: (right.cross(forward) * half_height).as_vec3(),
        })
    }
}
