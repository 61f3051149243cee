//! Host file: the footage that objects are laid over, as kernels read it.

use glam::{UVec2, Vec3};
use glimt_probe::gather::ColourMatrix;
use rayon::prelude::*;
use std::sync::LazyLock;

use super::env::MAX_RADIANCE;
use crate::kernels::composite::PlatePixel;

/// One frame of footage, of the image's size, rows from the top: linear colour, and the codes that display it.
#[derive(Clone, Debug, PartialEq)]
pub struct Plate {
    size: UVec2,
    pixels: Vec<PlatePixel>,
    primaries: Option<[[f32; 2]; 4]>,
    from_scene: ColourMatrix,
    to_display: ColourMatrix,
}

/// Why a plate was refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum PlateError {
    /// There is no pixel, or their number is not width × height.
    #[error("a plate of {width} × {height} pixels cannot hold {len} of them")]
    Size {
        /// Width that was asked for.
        width: u32,
        /// Height that was asked for.
        height: u32,
        /// Pixels given.
        len: usize,
    },
    /// A channel is not a number, or beyond [`MAX_RADIANCE`] on either side.
    #[error("pixel ({column}, {row}) is not finite, or beyond 1e20")]
    Pixel {
        /// Column of the first such pixel.
        column: u32,
        /// Row of the first such pixel.
        row: u32,
    },
}

impl Plate {
    /// A plate of 8-bit sRGB codes, which are displayed as they are.
    ///
    /// # Errors
    /// [`PlateError::Size`].
    pub fn from_srgb8(size: UVec2, codes: &[[u8; 3]]) -> Result<Self, PlateError> {
        check_size(size, codes.len())?;
        let pixel = |code: &[u8; 3]| PlatePixel {
            linear: Vec3::from(code.map(srgb8_to_linear)),
            code: pack(*code),
        };
        Ok(Self {
            size,
            pixels: codes.par_iter().map(pixel).collect(),
            primaries: None,
            from_scene: ColourMatrix::IDENTITY,
            to_display: ColourMatrix::IDENTITY,
        })
    }

    /// A plate of linear colours. Those outside [0, 1] stay as they are, and are displayed clipped.
    ///
    /// # Errors
    /// A [`PlateError`].
    pub fn from_linear(size: UVec2, colours: &[Vec3]) -> Result<Self, PlateError> {
        check_size(size, colours.len())?;
        let is_bad = |c: &Vec3| !(c.abs().max_element() <= MAX_RADIANCE) || c.is_nan();
        if let Some(bad) = colours.iter().position(is_bad) {
            let bad = bad as u32;
            return Err(PlateError::Pixel {
                column: bad % size.x,
                row: bad / size.x,
            });
        }
        let pixel = |colour: &Vec3| PlatePixel {
            linear: *colour,
            code: pack(colour.to_array().map(linear_to_srgb8)),
        };
        Ok(Self {
            size,
            pixels: colours.par_iter().map(pixel).collect(),
            primaries: None,
            from_scene: ColourMatrix::IDENTITY,
            to_display: ColourMatrix::IDENTITY,
        })
    }

    /// The plate with primaries of its own, CIE xy of red, green, blue and white: `from_scene` leads from those of light and materials to its, `to_display` from its
    /// to Rec. 709. Its linear colours stay as they are. Where `to_display` changes colours, its display codes become those of the
    /// changed ones, clipped to [0, 1].
    #[must_use]
    pub fn with_primaries(
        mut self,
        primaries: [[f32; 2]; 4],
        from_scene: ColourMatrix,
        to_display: ColourMatrix,
    ) -> Self {
        if to_display != self.to_display {
            self.pixels.par_iter_mut().for_each(|pixel| {
                let shown = to_display.apply(pixel.linear.extend(1.0)).truncate();
                pixel.code = pack(shown.to_array().map(linear_to_srgb8));
            });
        }
        self.primaries = Some(primaries);
        self.from_scene = from_scene;
        self.to_display = to_display;
        self
    }

    /// CIE xy of its red, green, blue and white, where they were given.
    #[must_use]
    pub fn primaries(&self) -> Option<[[f32; 2]; 4]> {
        self.primaries
    }

    /// From the primaries of light and materials to the plate's.
    #[must_use]
    pub fn scene_to_own(&self) -> &ColourMatrix {
        &self.from_scene
    }

    /// From the plate's primaries to those of the display, Rec. 709.
    #[must_use]
    pub fn own_to_display(&self) -> &ColourMatrix {
        &self.to_display
    }

    /// Width and height in pixels.
    #[must_use]
    pub fn size(&self) -> UVec2 {
        self.size
    }

    /// What kernels see of it.
    #[must_use]
    pub fn pixels(&self) -> &[PlatePixel] {
        &self.pixels
    }
}

fn check_size(size: UVec2, len: usize) -> Result<(), PlateError> {
    if len > 0 && len as u64 == u64::from(size.x) * u64::from(size.y) {
        return Ok(());
    }
    Err(PlateError::Size {
        width: size.x,
        height: size.y,
        len,
    })
}

fn pack([r, g, b]: [u8; 3]) -> u32 {
    u32::from_le_bytes([r, g, b, 255])
}

/// The inverse of the sRGB curve (IEC 61966-2-1), from encoded in [0, 1] to linear in [0, 1].
#[must_use]
pub fn srgb_decode(encoded: f64) -> f64 {
    if encoded <= 0.040_45 {
        encoded / 12.92
    } else {
        ((encoded + 0.055) / 1.055).powf(2.4)
    }
}

/// Linear value of an 8-bit code.
#[must_use]
pub fn srgb8_to_linear(code: u8) -> f32 {
    static LINEAR: LazyLock<[f32; 256]> =
        LazyLock::new(|| std::array::from_fn(|code| srgb_decode(code as f64 / 255.0) as f32));
    LINEAR[usize::from(code)]
}

/// The 8-bit code nearest to a linear value, clipped to [0, 1]; the inverse of [`srgb8_to_linear`].
#[must_use]
pub fn linear_to_srgb8(linear: f32) -> u8 {
    // Where one code ends and the next begins. A search in them is exact, and faster than a power.
    static ENDS: LazyLock<[f64; 255]> =
        LazyLock::new(|| std::array::from_fn(|code| srgb_decode((code as f64 + 0.5) / 255.0)));
    let linear = f64::from(linear);
    ENDS.partition_point(|end| *end <= linear) as u8
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_codes_come_back() {
        for code in 0..=255 {
            assert_eq!(linear_to_srgb8(srgb8_to_linear(code)), code);
        }
        let clipped = [-1.0, -0.0, 1.0, 7.0].map(linear_to_srgb8);
        assert_eq!(clipped, [0, 0, 255, 255]);
        // The middle between two codes, a little to either side.
        let middle = srgb_decode(100.5 / 255.0) as f32;
        let near = [middle * 0.999_99, middle * 1.000_01].map(linear_to_srgb8);
        assert_eq!(near, [100, 101]);
    }

    #[test]
    fn wrong_plates_are_refused() {
        let size = UVec2::new(2, 1);
        assert!(Plate::from_srgb8(size, &[[1, 2, 3]]).is_err());
        assert!(Plate::from_linear(UVec2::ZERO, &[]).is_err());
        let bad = Plate::from_linear(size, &[Vec3::ONE, Vec3::new(0.0, f32::NAN, 0.0)]);
        assert_eq!(bad, Err(PlateError::Pixel { column: 1, row: 0 }));
        assert!(Plate::from_linear(size, &[Vec3::NEG_ONE, Vec3::splat(9.0)]).is_ok());
    }
}
