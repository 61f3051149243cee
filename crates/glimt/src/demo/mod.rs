//! Host file: the built-in shot, made of formulas alone: an armillary sphere on a sundial while the sun climbs.
//!
//! It needs no file. World axes are the project's: right-handed, z up, lengths in metres; the sun rises on the left of
//! the image (+y), lamps stand behind the camera (−x).

mod armillary;
mod lamps;
mod sky;
mod solid;
mod sun;

pub use armillary::scene;
pub(crate) use lamps::flicker;
pub(crate) use sky::clear_sky;
pub use sky::environment;
pub(crate) use sun::irradiance as sun_irradiance;

use glam::{UVec2, Vec3, vec3};
use glimt_render_gpu::host::render::{
    Background, Filter, Method, Pattern, RenderSettings, Shadow, Tonemap,
};
use glimt_render_gpu::host::scene::Camera;

/// Frames of the shot, numbered from 0.
pub const FRAMES: u32 = 24;

/// Frames per second at which it is meant to be seen.
pub const FPS: u32 = 12;

/// Image width and height in pixels.
pub const IMAGE_SIZE: UVec2 = UVec2::new(480, 270);

/// Width and height of the light maps in texels: a texel is 0.35° wide at the horizon.
pub const ENV_SIZE: UVec2 = UVec2::new(1024, 512);

/// Place of a frame in the shot, 0 at its first frame and 1 at its last; frames beyond it stay there.
fn shot_time(frame: u32) -> f32 {
    frame.min(FRAMES - 1) as f32 / (FRAMES - 1) as f32
}

/// The camera of a frame: it drifts a few degrees around the sculpture.
pub fn camera(frame: u32) -> Camera {
    let time = shot_time(frame);
    let azimuth = (192.0 - 20.0 * time).to_radians();
    let distance = 7.5;
    let height = 1.85 + 0.3 * time;
    Camera {
        eye: vec3(distance * azimuth.cos(), distance * azimuth.sin(), height),
        target: vec3(0.0, -0.6, 1.2),
        up: Vec3::Z,
        fov_x: 40_f32.to_radians(),
    }
}

/// The settings of a frame: the program's defaults (Owen-scrambled Sobol, 16 rays a pixel, one BRDF and one light sample
/// on each) with the shot's exposure.
pub fn settings(frame: u32) -> RenderSettings {
    RenderSettings {
        size: IMAGE_SIZE,
        camera: camera(frame),
        rays_per_pixel: 16,
        brdf_samples: 1,
        env_samples: 1,
        method: Method::Mis,
        pattern: Pattern::OwenSobol,
        filter: Filter::Box,
        background: Background::Environment,
        seed: 1,
        frame,
        exposure_ev: -4.75,
        tonemap: Tonemap::Srgb,
        shadow: Shadow::Multiply,
        layers: false,
    }
}
