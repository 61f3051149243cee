//! Shared file: the numbers that a frame's kernels share.

use glam::{UVec2, Vec2, Vec3};
use glimt_probe::gather::ColourMatrix;
use glimt_sampling::uniform::unit_vec2;

use super::camera::CameraView;
use super::pattern::{FILM, PixelPattern, SEEN_THROUGH};
use super::ray::Ray;

/// A sample pattern.
#[derive(Clone, Copy, Debug, PartialEq, Eq, bytemuck::NoUninit)]
#[repr(u32)]
pub enum Pattern {
    /// Owen-scrambled Sobol points, one sequence for each pixel (Burley 2020).
    OwenSobol = 0,
    /// Independent uniforms, as in the papers.
    Independent = 1,
    /// Independent uniforms, of which each set of n samples is spread over n strata.
    Stratified = 2,
}

/// A reconstruction filter.
#[derive(Clone, Copy, Debug, PartialEq, Eq, bytemuck::NoUninit)]
#[repr(u32)]
pub enum Filter {
    /// Rays anywhere in the pixel, averaged.
    Box = 0,
    /// All rays through the pixel's centre.
    Centre = 1,
}

/// What is seen where no object is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, bytemuck::NoUninit)]
#[repr(u32)]
pub enum Background {
    /// The light map, with alpha 1.
    Environment = 0,
    /// Nothing: black with alpha 0, to be laid over a plate.
    Transparent = 1,
}

/// The curve of the display image, applied after the exposure.
#[derive(Clone, Copy, Debug, PartialEq, Eq, bytemuck::NoUninit)]
#[repr(u32)]
pub enum Tonemap {
    /// Clipped to [0, 1], then the sRGB curve.
    Srgb = 0,
    /// `x / (1 + x)` in each channel, then the sRGB curve.
    Reinhard = 1,
}

/// How a plate takes the shadows of objects on catchers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, bytemuck::NoUninit)]
#[repr(u32)]
pub enum Shadow {
    /// It is multiplied by the share of the catchers' light that is left: the plate keeps its texture, and the catcher's
    /// albedo cancels out.
    Multiply = 0,
    /// The light that the catchers lose is subtracted (Debevec 1998): right where the catchers' albedo is the plate's, and
    /// the light map is in the plate's units after the exposure.
    Add = 1,
}

/// All that a frame's kernels know beside the scene and its light. 208 bytes.
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::NoUninit)]
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
    /// Where uniforms come from.
    pub pattern: Pattern,
    /// Where in its pixel a ray passes.
    pub filter: Filter,
    /// What is seen where no object is.
    pub background: Background,
    /// First key of the random streams.
    pub seed: u32,
    /// Second key of the random streams.
    pub frame: u32,
    /// The display's curve.
    pub tonemap: Tonemap,
    /// Factor on linear values before the tonemap.
    pub exposure: f32,
    /// How a plate takes shadows.
    pub shadow: Shadow,
    /// Second key of the rays' places in their pixels: [`FrameParams::frame`] where they are new in every frame, the same number
    /// in all frames where they stand still.
    pub film_frame: u32,
    /// Fills 16 bytes, as the two below.
    pub unused_a: u32,
    /// See above.
    pub unused_b: u32,
    /// See above.
    pub unused_c: u32,
    /// From the primaries that light and materials have to those of the plate.
    pub to_plate: ColourMatrix,
    /// From the primaries of the plate, or without one those of light and materials, to those of the display: Rec. 709.
    pub to_display: ColourMatrix,
}

impl FrameParams {
    /// The sample pattern of the tile's ray `ray`.
    #[inline]
    #[must_use]
    pub fn pattern_of(&self, ray: u32) -> PixelPattern {
        self.pattern_at(
            self.first_pixel + ray / self.rays_per_pixel,
            ray % self.rays_per_pixel,
        )
    }

    /// The sample pattern of ray `ray` of pixel `pixel` of the image.
    #[inline]
    #[must_use]
    pub fn pattern_at(&self, pixel: u32, ray: u32) -> PixelPattern {
        PixelPattern {
            kind: self.pattern,
            seed: self.seed,
            frame: self.frame,
            pixel,
            ray,
            rays: self.rays_per_pixel,
        }
    }

    /// The ray that the pattern belongs to, from the camera through its pixel. Its direction has unit length.
    #[inline]
    #[must_use]
    pub fn camera_ray(&self, pattern: &PixelPattern) -> Ray {
        let film = PixelPattern {
            frame: self.film_frame,
            ..*pattern
        };
        let place = if self.filter == Filter::Centre {
            Vec2::splat(0.5)
        } else {
            unit_vec2(film.pair(FILM, 0, 1))
        };
        let direction = self.direction(pattern.pixel, place);
        Ray::keyed(self.eye, direction, film.ray_key(SEEN_THROUGH))
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
        assert_eq!(core::mem::size_of::<FrameParams>(), 208);
        assert_eq!(core::mem::offset_of!(FrameParams, to_plate), 112);
        assert_eq!(core::mem::offset_of!(FrameParams, to_display), 160);
        assert_eq!(core::mem::offset_of!(FrameParams, forward), 16);
        assert_eq!(core::mem::offset_of!(FrameParams, right), 32);
        assert_eq!(core::mem::offset_of!(FrameParams, up), 48);
        assert_eq!(core::mem::offset_of!(FrameParams, pattern), 64);
        assert_eq!(core::mem::offset_of!(FrameParams, background), 72);
        assert_eq!(core::mem::offset_of!(FrameParams, exposure), 88);
        assert_eq!(core::mem::offset_of!(FrameParams, shadow), 92);
    }
}
