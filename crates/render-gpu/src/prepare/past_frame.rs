//! Host file: the frame before, as methods that continue from it know it.

use glam::{Mat4, UVec2, Vec2};

use super::env::PreparedEnv;
use super::render::{RenderSettings, SettingsError};
use super::scene_build::SceneBuffers;
use crate::kernels::camera::CameraView;

/// The frame before: from where it was seen, where its objects were, and how its light stood.
#[derive(Clone, Debug)]
pub struct PastFrame {
    /// Its number.
    pub frame: u32,
    /// From where it was seen.
    pub view: CameraView,
    /// Where its objects were: from each one's own coordinates to the world's.
    pub transforms: Vec<Mat4>,
    /// Size of its light map.
    pub light_size: UVec2,
    /// How that was turned: [`RadianceMap::rotation`](crate::kernels::environment::RadianceMap::rotation).
    pub light_rotation: Vec2,
    /// The map's mean luminance.
    pub light_mean: f32,
}

impl PastFrame {
    /// A frame, once it is rendered.
    ///
    /// # Errors
    /// A [`SettingsError`] of the camera.
    pub fn new(
        settings: &RenderSettings,
        scene: &SceneBuffers,
        env: &PreparedEnv,
    ) -> Result<Self, SettingsError> {
        let light = env.view();
        Ok(Self {
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
