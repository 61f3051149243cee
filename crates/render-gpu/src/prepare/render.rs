//! Host file: what an executor is asked for and what it gives back.

use std::time::Duration;

use glam::{UVec2, Vec4};
use glimt_probe::gather::ColourMatrix;
use glimt_sh::ShError;

use super::env::PreparedEnv;
use super::plate::Plate;
use super::scene::Camera;
use super::scene_build::SceneBuffers;
use crate::kernels::camera::CameraView;
use crate::kernels::frame::FrameParams;
pub use crate::kernels::frame::{Background, Filter, Pattern, Shadow, Tonemap};
use crate::kernels::group_health::GroupHealth;
use crate::kernels::layers::PixelLayers;
use crate::kernels::smc::SmcHealth;
use crate::methods::{Method, MethodMemory, Prt};
use crate::settings::SettingError;

/// All that one frame needs beside the scene and its light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RenderSettings {
    /// Image width and height in pixels.
    pub size: UVec2,
    /// Where it is seen from.
    pub camera: Camera,
    /// Rays per pixel R, at least 1.
    pub rays_per_pixel: u32,
    /// How reflected light is estimated by renderers that trace rays.
    pub method: Method,
    /// How light is projected by renderers that draw with precomputed transfer.
    pub prt: Prt,
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
    /// Width of a pixel over its height; 1 for square pixels.
    pub pixel_aspect: f32,
    /// From the primaries of light and materials to those of the display, Rec. 709. A plate has its own: [`Plate::own_to_display`].
    pub to_display: ColourMatrix,
    /// Whether the image comes with its layers.
    pub layers: bool,
    /// Whether the image is to have [`FrameImage::diagnostics`].
    pub diagnostics: bool,
}

/// Kernels' files cannot say which variant is the default.
macro_rules! defaults {
    ($($type:ident::$variant:ident),+) => {
        $(impl Default for $type {
            fn default() -> Self {
                Self::$variant
            }
        })+
    };
}

defaults!(
    Pattern::OwenSobol,
    Filter::Box,
    Background::Environment,
    Tonemap::Srgb,
    Shadow::Multiply
);

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
    /// How its method fared, where it was asked for, and the method says so.
    pub diagnostics: Option<Diagnostics>,
}

/// How a method fared in each pixel of a frame, rows from the top.
#[derive(Clone, Debug, PartialEq)]
pub enum Diagnostics {
    /// Of [`Method::Smc`].
    Particles(Vec<SmcHealth>),
    /// Of methods that estimate the light of a pixel's hits together: [`Method::Cells`] and [`Method::Product`].
    Groups {
        /// Each pixel.
        pixels: Vec<GroupHealth>,
        /// Pilot rays of a pixel, on average over the image.
        pilot_rays: f64,
    },
}

/// Something that turns scenes into frames: the CPU or a GPU.
pub trait Renderer {
    /// What it is, for messages: the processor's or adapter's name.
    fn name(&self) -> String;

    /// Renders one frame over a plate of the same size, or over the background of the settings. `progress` gets the
    /// fraction that is done, from any thread.
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

    /// What its method keeps of the frame that was rendered last; `None` before the first, and where it keeps nothing.
    ///
    /// By [`Method::Smc`] a frame continues from that one where both have the same image size, rays per pixel, particles, seed and
    /// objects, by [`Method::Cells`] with a memory where both have the same image size, seed and objects; else it starts.
    ///
    /// # Errors
    /// A [`RenderError`].
    fn memory(&mut self) -> Result<Option<MethodMemory>, RenderError>;

    /// Makes the next frame continue from another one.
    ///
    /// # Errors
    /// [`SettingsError::Memory`] where the renderer keeps nothing of the kind; other [`RenderError`]s.
    fn set_memory(&mut self, memory: MethodMemory) -> Result<(), RenderError>;

    /// Forgets all frames: the next one starts.
    fn forget(&mut self);
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
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum SettingsError {
    /// Width, height or rays per pixel is 0.
    #[error("an image needs a width, a height and at least one ray per pixel")]
    Empty,
    /// A setting of a method is out of its range.
    #[error(transparent)]
    Setting(#[from] SettingError),
    /// Pixels, or the samples of one, outgrow 32 bits.
    #[error("width × height, and the samples of a pixel, must each stay below 2^32")]
    TooMany,
    /// The camera looks nowhere.
    #[error("the camera needs finite eye, target and up, with up not along the line of sight")]
    Camera,
    /// The field of view is not in (0, π).
    #[error("the horizontal field of view must lie between 0 and 180 degrees")]
    FieldOfView,
    /// The pixels' aspect is not above 0, or not finite.
    #[error("the aspect of a pixel must be above 0 and finite")]
    PixelAspect,
    /// The exposure's factor outgrows 32 bits.
    #[error("2 to the power of the exposure must be finite")]
    Exposure,
    /// The light lacks a table that the method reads.
    #[error("the light was prepared for another method: prepare it for the one that renders")]
    Tables,
    /// What was saved belongs to another method.
    #[error("this renderer cannot continue from what another method keeps")]
    Memory,
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
            method: Method::default(),
            prt: Prt::default(),
            pattern: Pattern::OwenSobol,
            filter: Filter::Box,
            background: Background::Environment,
            seed: 1,
            frame: 0,
            exposure_ev: 0.0,
            tonemap: Tonemap::Srgb,
            shadow: Shadow::Multiply,
            pixel_aspect: 1.0,
            to_display: ColourMatrix::IDENTITY,
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
        Ok(FrameParams {
            to_plate: *plate.scene_to_own(),
            to_display: *plate.own_to_display(),
            ..over.frame_params()?
        })
    }

    /// Checks the settings and makes of them what kernels read, with the first tile at pixel 0.
    ///
    /// # Errors
    /// A [`SettingsError`].
    pub fn frame_params(&self) -> Result<FrameParams, SettingsError> {
        if self.size.min_element() == 0 || self.rays_per_pixel == 0 {
            return Err(SettingsError::Empty);
        }
        self.method.check()?;
        self.prt.check()?;
        // Kernels number rays within a tile, so all rays of an image may be more.
        let pixels = self.size.x.checked_mul(self.size.y);
        let samples = self
            .rays_per_pixel
            .checked_mul(self.method.samples_per_ray());
        if pixels.is_none() || samples.is_none() {
            return Err(SettingsError::TooMany);
        }
        let exposure = self.exposure_ev.exp2();
        if !(exposure <= f32::MAX) {
            return Err(SettingsError::Exposure);
        }
        let view = self.view()?;
        Ok(FrameParams {
            eye: view.eye,
            width: self.size.x,
            forward: view.forward,
            height: self.size.y,
            right: view.right,
            rays_per_pixel: self.rays_per_pixel,
            up: view.up,
            first_pixel: 0,
            pattern: self.pattern,
            filter: self.filter,
            background: self.background,
            seed: self.seed,
            frame: self.frame,
            tonemap: self.tonemap,
            exposure,
            shadow: self.shadow,
            // Particles stay with their rays, so those must stand still.
            film_frame: if self.method.leads_particles() {
                0
            } else {
                self.frame
            },
            unused_a: 0,
            unused_b: 0,
            unused_c: 0,
            to_plate: ColourMatrix::IDENTITY,
            to_display: self.to_display,
        })
    }

    /// The camera as kernels see it.
    ///
    /// # Errors
    /// As [`Camera::view`]; [`SettingsError::PixelAspect`].
    pub fn view(&self) -> Result<CameraView, SettingsError> {
        let aspect = self.pixel_aspect;
        if !(aspect > 0.0 && aspect.is_finite()) {
            return Err(SettingsError::PixelAspect);
        }
        let mut view = self.camera.view(self.size)?;
        // The field of view is that of the image's width, so wide pixels make the image lower.
        if aspect != 1.0 {
            view.up /= aspect;
        }
        Ok(view)
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
