//! Shared file: how a pixel fared whose light was estimated by groups of its hits.

use super::frame::FrameParams;
use super::seen::SeenPoint;

/// How a pixel fared. 8 bytes.
#[derive(Clone, Copy, Debug, Default, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct GroupHealth {
    /// Its shadow rays.
    pub rays: f32,
    /// The standard deviation, in luminance, that a shadow ray was expected to have: for `cells`, of what the control variate leaves.
    pub residual: f32,
}

/// How the tile's pixel `pixel` fared, of its points once they are shaded.
#[must_use]
pub fn diagnose_groups(pixel: u32, frame: &FrameParams, points: &[SeenPoint]) -> GroupHealth {
    let first = pixel * frame.rays_per_pixel;
    let mut rays = 0;
    let mut residual = 0.0;
    for ray in first..first + frame.rays_per_pixel {
        rays += points[ray as usize].shadow_rays;
        residual += points[ray as usize].residual;
    }
    GroupHealth {
        rays: rays as f32,
        residual,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn layout_is_that_of_wgsl() {
        assert_eq!(core::mem::size_of::<GroupHealth>(), 8);
        assert_eq!(core::mem::offset_of!(GroupHealth, residual), 4);
    }
}
