//! Host file: what the sequential sampler carries from frame to frame.

use glam::{Mat4, UVec2, Vec2, Vec4};
use glimt_smc::Particle;

use super::env::PreparedEnv;
use super::render::{RenderSettings, SettingsError};
use super::scene_build::SceneBuffers;
use crate::kernels::camera::CameraView;
use crate::kernels::environment::RadianceMap;
use crate::kernels::past::RayState;
use crate::methods::Smc;

/// What two frames must have in common for particles to go from one to the other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SmcKey {
    /// Size of the image.
    pub size: UVec2,
    /// Rays per pixel R.
    pub rays_per_pixel: u32,
    /// Particles per ray N.
    pub particles: u32,
    /// Key of the random streams: another seed is another experiment.
    pub seed: u32,
    /// Objects of the scene.
    pub objects: u32,
}

/// The frame before, without its rays.
#[derive(Clone, Debug)]
pub struct PastFrame {
    /// What the next frame must have in common with it.
    pub key: SmcKey,
    /// Its number.
    pub frame: u32,
    /// From where it was seen.
    pub view: CameraView,
    /// Where its objects were: from each one's own coordinates to the world's.
    pub transforms: Vec<Mat4>,
    /// Size of its light map.
    pub light_size: UVec2,
    /// How that was turned: [`RadianceMap::rotation`].
    pub light_rotation: Vec2,
    /// The map's mean luminance.
    pub light_mean: f32,
}

/// All that the sampler needs to continue from a frame.
#[derive(Clone, Debug)]
pub struct SmcState {
    /// The frame.
    pub past: PastFrame,
    /// Its light map.
    pub light: Vec<Vec4>,
    /// Its rays, pixel by pixel.
    pub rays: Vec<RayState>,
    /// N particles of each ray.
    pub particles: Vec<Particle>,
}

impl SmcKey {
    /// Of a frame of these settings.
    #[must_use]
    pub fn new(settings: &RenderSettings, smc: &Smc, scene: &SceneBuffers) -> Self {
        Self {
            size: settings.size,
            rays_per_pixel: settings.rays_per_pixel,
            particles: smc.particles,
            seed: settings.seed,
            objects: scene.transforms().len() as u32,
        }
    }

    /// Rays of the image.
    pub(crate) fn rays(&self) -> usize {
        self.size.element_product() as usize * self.rays_per_pixel as usize
    }
}

impl PastFrame {
    /// A frame, once it is rendered.
    ///
    /// # Errors
    /// A [`SettingsError`] of the camera.
    pub fn new(
        settings: &RenderSettings,
        smc: &Smc,
        scene: &SceneBuffers,
        env: &PreparedEnv,
    ) -> Result<Self, SettingsError> {
        let light = env.view();
        Ok(Self {
            key: SmcKey::new(settings, smc, scene),
            frame: settings.frame,
            view: settings.view()?,
            transforms: scene.transforms().to_vec(),
            light_size: light.size,
            light_rotation: light.rotation,
            light_mean: env.mean_luminance(),
        })
    }

    /// For each object, the map from where it is to where it was in this frame.
    #[must_use]
    pub fn motions(&self, scene: &SceneBuffers) -> Vec<Mat4> {
        let pairs = self.transforms.iter().zip(scene.transforms());
        pairs
            .map(|(before, now)| match before == now {
                true => Mat4::IDENTITY,
                false => (before.as_dmat4() * now.as_dmat4().inverse()).as_mat4(),
            })
            .collect()
    }
}

impl SmcState {
    /// Its light, to be looked up.
    #[must_use]
    pub fn light(&self) -> RadianceMap<'_> {
        RadianceMap {
            texels: &self.light,
            size: self.past.light_size,
            rotation: self.past.light_rotation,
        }
    }
}
