//! Shared file: from pixels to rays.

use glam::{UVec2, Vec2, Vec3};

/// A pinhole camera as kernels see it: the image plane at distance one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CameraView {
    /// Centre of projection.
    pub eye: Vec3,
    /// Unit vector through the image's centre.
    pub forward: Vec3,
    /// From the image's centre to the middle of its right edge.
    pub right: Vec3,
    /// From the image's centre to the middle of its upper edge.
    pub up: Vec3,
}

impl CameraView {
    /// Unit direction of the image point `p` in pixels, (0, 0) at the upper left corner and pixel (i, j)'s centre at
    /// (i + ½, j + ½): along `forward + (2 p.x/W − 1) right − (2 p.y/H − 1) up`.
    #[inline]
    #[must_use]
    pub fn direction(&self, p: Vec2, size: UVec2) -> Vec3 {
        let x = 2.0 * p.x / size.x as f32 - 1.0;
        let y = 2.0 * p.y / size.y as f32 - 1.0;
        (self.forward + self.right * x - self.up * y).normalize()
    }
}
