//! Shared file: pass 2 of rendering (Kronander 2014, § 7): from the rays' radiance to pixels. One element is one pixel.

use glam::{Vec3, Vec4};

use super::frame::{FrameParams, Tonemap};

/// Linear value of the tile's pixel `pixel`: the mean of its rays, which is the box filter where the rays are spread
/// over the pixel. Alpha is the mean alpha, and the colour is premultiplied by it.
#[must_use]
pub fn reconstruct(pixel: u32, frame: &FrameParams, samples: &[Vec4]) -> Vec4 {
    let first = pixel * frame.rays_per_pixel;
    let mut sum = Vec4::ZERO;
    for i in first..first + frame.rays_per_pixel {
        sum += samples[i as usize];
    }
    sum / frame.rays_per_pixel as f32
}

/// Display value of the tile's pixel `pixel`, red in the lowest byte and straight alpha in the highest.
///
/// The colour is freed from alpha, multiplied by the exposure, mapped to [0, 1] and encoded by the sRGB curve.
#[must_use]
pub fn tonemap(pixel: u32, frame: &FrameParams, linear: &[Vec4]) -> u32 {
    let value = linear[pixel as usize];
    let alpha = value.w.clamp(0.0, 1.0);
    if alpha == 0.0 {
        return 0;
    }
    let exposed = (value.truncate() / alpha * frame.exposure).clamp(Vec3::ZERO, Vec3::splat(1e37));
    display_code(tone_curve(frame, displayed(frame, exposed)), alpha)
}

/// A colour, at most 1e37, with the primaries of the display, at least 0.
#[inline]
#[must_use]
pub fn displayed(frame: &FrameParams, colour: Vec3) -> Vec3 {
    frame.to_display.apply(colour.extend(1.0)).truncate()
}

/// The tonemap's curve: from exposed values, at least 0, to linear display values in [0, 1].
#[inline]
#[must_use]
pub fn tone_curve(frame: &FrameParams, exposed: Vec3) -> Vec3 {
    if frame.tonemap == Tonemap::Reinhard {
        Vec3::ONE - Vec3::ONE / (Vec3::ONE + exposed)
    } else {
        exposed.min(Vec3::ONE)
    }
}

/// Linear display values and straight alpha, all in [0, 1], in 8 bits each: red in the lowest byte, encoded by the sRGB
/// curve, and alpha in the highest, which is not.
#[inline]
#[must_use]
pub fn display_code(linear: Vec3, alpha: f32) -> u32 {
    code(srgb_encode(linear.x))
        | code(srgb_encode(linear.y)) << 8
        | code(srgb_encode(linear.z)) << 16
        | code(alpha) << 24
}

/// The sRGB curve (IEC 61966-2-1): from linear in [0, 1] to encoded in [0, 1].
#[inline]
#[must_use]
pub fn srgb_encode(linear: f32) -> f32 {
    if linear <= 0.003_130_8 {
        12.92 * linear
    } else {
        1.055 * libm::powf(linear, 1.0 / 2.4) - 0.055
    }
}

/// The nearest 8-bit code of a value in [0, 1].
#[inline]
fn code(value: f32) -> u32 {
    (value.clamp(0.0, 1.0) * 255.0 + 0.5) as u32
}
