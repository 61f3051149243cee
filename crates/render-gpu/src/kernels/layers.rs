//! Shared file: a frame in layers: the objects, and the light that they take from what is in the footage already.
//!
//! A *catcher* stands for a part of the footage. Differential rendering (Debevec 1998, § 5.2) shades it with and without the
//! objects and adds the change to the plate; here one set of samples gives both, so that their noise is the same and
//! the change is zero where nothing is blocked.

use glam::{Vec3, Vec4};

use super::environment::Environment;
use super::estimator::Reflected;
use super::frame::{Background, FrameParams};

/// What one ray shows: an object, a catcher, or the background. 32 bytes.
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct LayerSample {
    /// Radiance that an object reflects, or a catcher by the light that the objects leave.
    pub radiance: Vec3,
    /// 1 for an object.
    pub alpha: f32,
    /// Radiance that a catcher would reflect by the light that the objects take from it.
    pub blocked: Vec3,
    /// 1 for a catcher.
    pub catcher: f32,
}

impl LayerSample {
    /// The background.
    pub const NOTHING: LayerSample = LayerSample {
        radiance: Vec3::ZERO,
        alpha: 0.0,
        blocked: Vec3::ZERO,
        catcher: 0.0,
    };

    /// An object or a catcher that reflects this light.
    #[inline]
    #[must_use]
    pub fn of(light: &Reflected, is_catcher: bool) -> LayerSample {
        if is_catcher {
            return LayerSample {
                radiance: light.lit,
                alpha: 0.0,
                blocked: light.blocked,
                catcher: 1.0,
            };
        }
        LayerSample {
            radiance: light.lit,
            alpha: 1.0,
            blocked: Vec3::ZERO,
            catcher: 0.0,
        }
    }
}

/// The layers of one pixel, means over all its rays: [`lit`](Self::lit) and [`blocked`](Self::blocked) are premultiplied by
/// the catchers' coverage. 64 bytes.
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct PixelLayers {
    /// Radiance of the objects, premultiplied, and their alpha.
    pub object: Vec4,
    /// Radiance of the catchers with the objects in place.
    pub lit: Vec3,
    /// Share of rays that show a catcher.
    pub catcher: f32,
    /// Radiance that the catchers lack because of the objects: without them it would be `lit + blocked`.
    pub blocked: Vec3,
    /// Fills 16 bytes.
    pub unused_a: u32,
    /// Radiance of the light map behind catchers and gaps, the mean of the rays that show no object; 0 where the background
    /// is transparent.
    pub behind: Vec3,
    /// Fills 16 bytes.
    pub unused_b: u32,
}

impl PixelLayers {
    /// Whether the pixel shows nothing but the plate, untouched: no object, and no catcher in shadow.
    #[inline]
    #[must_use]
    pub fn is_plate(&self) -> bool {
        self.object.w == 0.0 && !(self.blocked.max_element() > 0.0)
    }

    /// What is left of the plate's light where no object covers it: `t = (1 − a − c (1 − r)) / (1 − a)` in each channel,
    /// a the objects' alpha, c the catchers' coverage, `r = lit / (lit + blocked)` the ratio of the catchers' radiance with
    /// and without the objects. In [0, 1], and exactly 1 where nothing is blocked; 1 behind an object, where it has no
    /// meaning.
    #[inline]
    #[must_use]
    pub fn transmission(&self) -> Vec3 {
        let clear = 1.0 - self.object.w;
        if !(clear > 0.0) {
            return Vec3::ONE;
        }
        let lost = Vec3::new(
            share(self.blocked.x, self.lit.x),
            share(self.blocked.y, self.lit.y),
            share(self.blocked.z, self.lit.z),
        );
        (Vec3::ONE - lost * (self.catcher / clear)).max(Vec3::ZERO)
    }
}

/// `part / (part + rest)`: 1 − r, where the difference would lose digits. 0 where both are 0.
#[inline]
fn share(part: f32, rest: f32) -> f32 {
    if part > 0.0 {
        part / (part + rest)
    } else {
        0.0
    }
}

/// The layers of the tile's pixel `pixel`, means of its rays.
#[must_use]
pub fn reconstruct_layers(
    pixel: u32,
    frame: &FrameParams,
    env: Environment<'_>,
    samples: &[LayerSample],
) -> PixelLayers {
    let first = pixel * frame.rays_per_pixel;
    let mut object = Vec4::ZERO;
    let mut lit = Vec3::ZERO;
    let mut catcher = 0.0;
    let mut blocked = Vec3::ZERO;
    let mut behind = Vec3::ZERO;
    let mut clear = 0.0;
    for ray in first..first + frame.rays_per_pixel {
        let sample = samples[ray as usize];
        if sample.catcher > 0.0 {
            lit += sample.radiance;
            blocked += sample.blocked;
            catcher += 1.0;
        } else {
            object += sample.radiance.extend(sample.alpha);
        }
        if frame.background == Background::Environment && sample.alpha == 0.0 {
            let direction = frame.camera_ray(&frame.pattern_of(ray)).direction;
            behind += env.background(direction);
            clear += 1.0;
        }
    }
    let rays = frame.rays_per_pixel as f32;
    PixelLayers {
        object: object / rays,
        lit: lit / rays,
        catcher: catcher / rays,
        blocked: blocked / rays,
        unused_a: 0,
        behind: behind / f32::max(clear, 1.0),
        unused_b: 0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn layout_is_that_of_wgsl() {
        assert_eq!(core::mem::size_of::<LayerSample>(), 32);
        assert_eq!(core::mem::offset_of!(LayerSample, blocked), 16);
        assert_eq!(core::mem::size_of::<PixelLayers>(), 64);
        assert_eq!(core::mem::offset_of!(PixelLayers, lit), 16);
        assert_eq!(core::mem::offset_of!(PixelLayers, blocked), 32);
        assert_eq!(core::mem::offset_of!(PixelLayers, behind), 48);
    }
}
