//! Host file: what the sequential sampler carries from frame to frame.

use glam::{UVec2, Vec4};
use glimt_smc::Particle;

use super::past_frame::PastFrame;
use super::render::RenderSettings;
use super::scene_build::SceneBuffers;
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

/// All that the sampler needs to continue from a frame.
#[derive(Clone, Debug)]
pub struct SmcState {
    /// What the next frame must have in common with it.
    pub key: SmcKey,
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
