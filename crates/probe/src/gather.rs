//! Shared file: resampling an image by a table of weights, made once and used for every frame.

use glam::{Mat3, Vec4};

/// Where a texel's taps begin. 12 bytes.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct TexelTaps {
    /// Index of its first tap; the taps of the next texel follow its last.
    pub tap: u32,
    /// The pixel from which its first tap counts.
    pub pixel: u32,
    /// `(1 − cos i)^5`, i the angle of incidence at which the mirror is seen: 0 in the ball's middle, 1 at its rim.
    pub grazing: f32,
}

/// Which pixels make each texel, in four bytes a pixel: the table is read once for each texel of each frame, and its bytes
/// are what that costs.
#[derive(Clone, Copy, Debug)]
pub struct GatherMap<'a> {
    /// One entry for each texel, and one more that ends the last.
    pub texels: &'a [TexelTaps],
    /// In the upper half of a tap the steps from the last tap's pixel to its own, rows counted from the top one after the
    /// other; in the lower its weight in units of 1/65535. The weights of a texel sum to 65535. A weight of 0 is a
    /// step alone, where one is too far for 16 bits, or fills up a texel: each has an even number.
    pub taps: &'a [u32],
}

/// The unit of a tap's weight.
pub const WEIGHT_UNIT: f32 = 1.0 / 65_535.0;

/// A linear change of colours, the columns of a matrix. 48 bytes.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct ColourMatrix {
    /// What becomes of red; w is 0, here and below.
    pub red: Vec4,
    /// What becomes of green.
    pub green: Vec4,
    /// What becomes of blue.
    pub blue: Vec4,
}

impl ColourMatrix {
    /// Leaves colours as they are.
    pub const IDENTITY: ColourMatrix = ColourMatrix {
        red: Vec4::new(1.0, 0.0, 0.0, 0.0),
        green: Vec4::new(0.0, 1.0, 0.0, 0.0),
        blue: Vec4::new(0.0, 0.0, 1.0, 0.0),
    };

    /// The matrix whose columns are those of `matrix`.
    #[must_use]
    pub fn from_mat3(matrix: Mat3) -> ColourMatrix {
        ColourMatrix {
            red: matrix.x_axis.extend(0.0),
            green: matrix.y_axis.extend(0.0),
            blue: matrix.z_axis.extend(0.0),
        }
    }

    /// The changed colour, a channel below 0 as 0; alpha is 1.
    ///
    /// ```
    /// use glam::{Mat3, Vec3, Vec4};
    /// use glimt_probe::gather::ColourMatrix;
    /// let warmer = ColourMatrix::from_mat3(Mat3::from_diagonal(Vec3::new(2.0, 1.0, 0.5)));
    /// assert_eq!(warmer.apply(Vec4::ONE), Vec4::new(2.0, 1.0, 0.5, 1.0));
    /// ```
    #[inline]
    #[must_use]
    pub fn apply(&self, colour: Vec4) -> Vec4 {
        let changed = self.red * colour.x + self.green * colour.y + self.blue * colour.z;
        // The columns' w are 0, so this sets alpha, too.
        changed.max(Vec4::W)
    }
}

/// Texel `texel`: the weighted mean of its pixels over what the mirror reflects, its colours then changed by `colour`. Black
/// where it has no taps.
///
/// `reflectance` is the mirror's at normal incidence, in (0, 1] for each channel, w 1; towards grazing incidence it grows to
/// 1 as `r + (1 − r)(1 − cos i)^5` (Schlick 1994).
///
/// ```
/// use glam::Vec4;
/// use glimt_probe::gather::{ColourMatrix, GatherMap, TexelTaps, gather};
/// let texels = [0, 2].map(|tap| TexelTaps { tap, pixel: 0, grazing: 0.0 });
/// // A fifth of pixel 0, four fifths of pixel 2.
/// let map = GatherMap { texels: &texels, taps: &[13_107, 2 << 16 | 52_428] };
/// let pixels = [Vec4::ZERO, Vec4::splat(9.0), Vec4::splat(5.0)];
/// let texel = gather(0, map, &ColourMatrix::IDENTITY, Vec4::ONE, &pixels);
/// assert_eq!(texel, Vec4::new(4.0, 4.0, 4.0, 1.0));
/// // A mirror that keeps half of the light shows a world of half the radiance.
/// let texel = gather(0, map, &ColourMatrix::IDENTITY, Vec4::new(0.5, 0.5, 0.5, 1.0), &pixels);
/// assert_eq!(texel, Vec4::new(8.0, 8.0, 8.0, 1.0));
/// ```
#[inline(always)]
#[must_use]
pub fn gather(
    texel: u32,
    map: GatherMap<'_>,
    colour: &ColourMatrix,
    reflectance: Vec4,
    pixels: &[Vec4],
) -> Vec4 {
    let begin = map.texels[texel as usize];
    let end = map.texels[texel as usize + 1].tap as usize;
    let mut pixel = begin.pixel;
    // Two sums and two taps a turn: additions wait for each other, and so do turns.
    let mut even = Vec4::ZERO;
    let mut odd = Vec4::ZERO;
    let mut i = begin.tap as usize;
    while i + 2 <= end {
        let (tap_a, tap_b) = (map.taps[i], map.taps[i + 1]);
        let a = pixel + (tap_a >> 16);
        let b = a + (tap_b >> 16);
        even += pixels[a as usize] * weight(tap_a);
        odd += pixels[b as usize] * weight(tap_b);
        pixel = b;
        i += 2;
    }
    let reflected = reflectance + (Vec4::ONE - reflectance) * begin.grazing;
    colour.apply((even + odd) * WEIGHT_UNIT / reflected)
}

/// The weight of a tap, in its units.
#[inline]
fn weight(tap: u32) -> f32 {
    (tap & 0xffff) as i32 as f32
}
