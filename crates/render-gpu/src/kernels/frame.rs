//! Shared file: the numbers that a frame's kernels share.

use glam::{UVec2, Vec2, Vec3};
use glimt_sampling::uniform::unit_vec2;

use super::camera::CameraView;
use super::pattern::{FILM, PixelPattern};
use super::ray::Ray;

/// [`FrameParams::pattern`]: Owen-scrambled Sobol points.
pub const PATTERN_OWEN_SOBOL: u32 = 0;
/// [`FrameParams::pattern`]: independent uniforms.
pub const PATTERN_INDEPENDENT: u32 = 1;
/// [`FrameParams::pattern`]: one uniform in each stratum.
pub const PATTERN_STRATIFIED: u32 = 2;

/// [`FrameParams::filter`]: rays anywhere in the pixel.
pub const FILTER_BOX: u32 = 0;
/// [`FrameParams::filter`]: rays through the pixel's centre.
pub const FILTER_CENTRE: u32 = 1;

/// [`FrameParams::background`]: the environment, with alpha 1.
pub const BACKGROUND_ENVIRONMENT: u32 = 0;
/// [`FrameParams::background`]: black, with alpha 0.
pub const BACKGROUND_TRANSPARENT: u32 = 1;

/// [`FrameParams::tonemap`]: clipping.
pub const TONEMAP_SRGB: u32 = 0;
/// [`FrameParams::tonemap`]: `x / (1 + x)`.
pub const TONEMAP_REINHARD: u32 = 1;

/// [`FrameParams::shadow`]: the plate is multiplied by the share of light that is left.
pub const SHADOW_MULTIPLY: u32 = 0;
/// [`FrameParams::shadow`]: the light that is lost is subtracted from the plate.
pub const SHADOW_ADD: u32 = 1;

/// All that a frame's kernels know beside the scene and its light. 112 bytes.
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct FrameParams {
    /// [`CameraView::eye`].
    pub eye: Vec3,
    /// Width of the image in pixels.
    pub width: u32,
    /// [`CameraView::forward`].
    pub forward: Vec3,
    /// Height of the image in pixels.
    pub height: u32,
    /// [`CameraView::right`].
    pub right: Vec3,
    /// Rays per pixel R.
    pub rays_per_pixel: u32,
    /// [`CameraView::up`].
    pub up: Vec3,
    /// Index in the image, row by row, of the tile's first pixel.
    pub first_pixel: u32,
    /// BRDF samples N_ρ on each ray.
    pub brdf_samples: u32,
    /// Environment samples N_L on each ray.
    pub env_samples: u32,
    /// One of the `PATTERN_…` constants.
    pub pattern: u32,
    /// One of the `FILTER_…` constants.
    pub filter: u32,
    /// One of the `BACKGROUND_…` constants.
    pub background: u32,
    /// First key of the random streams.
    pub seed: u32,
    /// Second key of the random streams.
    pub frame: u32,
    /// One of the `TONEMAP_…` constants.
    pub tonemap: u32,
    /// Factor on linear values before the tonemap.
    pub exposure: f32,
    /// One of the `SHADOW_…` constants.
    pub shadow: u32,
    /// Second key of the rays' places in their pixels: [`FrameParams::frame`] where they are new in every frame, the same number
    /// in all frames where they stand still.
    pub film_frame: u32,
    /// Fills 16 bytes.
    pub unused_c: u32,
}

impl FrameParams {
    /// The sample pattern of the tile's ray `ray`.
    #[inline]
    #[must_use]
    pub fn pattern_of(&self, ray: u32) -> PixelPattern {
        PixelPattern {
            kind: self.pattern,
            seed: self.seed,
            frame: self.frame,
            pixel: self.first_pixel + ray / self.rays_per_pixel,
            ray: ray % self.rays_per_pixel,
            rays: self.rays_per_pixel,
        }
    }

    /// The ray that the pattern belongs to, from the camera through its pixel. Its direction has unit length.
    #[inline]
    #[must_use]
    pub fn camera_ray(&self, pattern: &PixelPattern) -> Ray {
        let place = if self.filter == FILTER_CENTRE {
            Vec2::splat(0.5)
        } else {
            let film = PixelPattern {
                frame: self.film_frame,
                ..*pattern
            };
            unit_vec2(film.pair(FILM, 0, 1))
        };
        Ray::new(self.eye, self.direction(pattern.pixel, place))
    }

    /// Unit direction from the eye through pixel `pixel` of the image, at `place` in it: (0, 0) is its upper left corner.
    #[inline]
    #[must_use]
    pub fn direction(&self, pixel: u32, place: Vec2) -> Vec3 {
        let corner = UVec2::new(pixel % self.width, pixel / self.width).as_vec2();
        let view = CameraView {
            eye: self.eye,
            forward: self.forward,
            right: self.right,
            up: self.up,
        };
        view.direction(corner + place, UVec2::new(self.width, self.height))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn layout_is_that_of_wgsl() {
        assert_eq!(core::mem::size_of::<FrameParams>(), 112);
        assert_eq!(core::mem::offset_of!(FrameParams, forward), 16);
        assert_eq!(core::mem::offset_of!(FrameParams, right), 32);
        assert_eq!(core::mem::offset_of!(FrameParams, up), 48);
        assert_eq!(core::mem::offset_of!(FrameParams, brdf_samples), 64);
        assert_eq!(core::mem::offset_of!(FrameParams, background), 80);
        assert_eq!(core::mem::offset_of!(FrameParams, exposure), 96);
        assert_eq!(core::mem::offset_of!(FrameParams, shadow), 100);
    }
}
