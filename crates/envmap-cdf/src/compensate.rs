//! Host file: the weights of MIS compensation, and their tables.

use glam::UVec2;

use crate::build::{BuildError, BuildReport, band_area, build_into, required_len, weight_or_zero};
use crate::edges::LANES;

/// Sum of a row's weights, as [`RowReport::weight_sum`](crate::RowReport) has it, without building the row. A weight that is NaN,
/// infinite or negative counts as 0.
///
/// ```
/// assert_eq!(glimt_envmap_cdf::weight_sum([1.0, f32::NAN, 2.5].into_iter()), 3.5);
/// ```
#[must_use]
pub fn weight_sum(mut weights: impl Iterator<Item = f32>) -> f64 {
    // One sum alone would wait for each addition.
    let mut sums = [0.0; LANES];
    loop {
        for sum in &mut sums {
            match weights.next() {
                Some(weight) => *sum += f64::from(weight_or_zero(weight)),
                None => return sums.iter().sum(),
            }
        }
    }
}

/// Mean weight of a map over the sphere, each row's sum multiplied by the exact area of its texels.
///
/// `weight_sums` are the rows' sums of weights from row 0 at +z ([`RowReport::weight_sum`](crate::RowReport)), `width`
/// is the number of texels in a row. 0 where there are none.
///
/// ```
/// // Two rows of two texels each: one of weight 1, one of weight 3.
/// assert!((glimt_envmap_cdf::mean_weight(&[2.0, 6.0], 2) - 2.0).abs() < 1e-6);
/// ```
#[must_use]
pub fn mean_weight(weight_sums: &[f64], width: u32) -> f32 {
    let height = weight_sums.len();
    let mean: f64 = (0..height)
        .map(|row| weight_sums[row] * band_area(row, height))
        .sum();
    (mean / f64::from(width.max(1))) as f32
}

/// The compensated weight `max(0, weight − mean)` (Karlík et al. 2019; the mean over the sphere, not over the texels).
/// A NaN, infinite or negative weight stays bad, so that building counts it.
///
/// ```
/// use glimt_envmap_cdf::compensated_weight;
/// assert_eq!([3.0, 1.0].map(|w| compensated_weight(w, 2.0)), [1.0, 0.0]);
/// assert_eq!(compensated_weight(-1.0, 2.0), -1.0);
/// ```
#[inline]
#[must_use]
pub fn compensated_weight(weight: f32, mean: f32) -> f32 {
    if weight >= 0.0 && weight <= mean {
        0.0
    } else if weight > mean {
        weight - mean
    } else {
        weight
    }
}

/// Builds the tables of [`CompensatedCdf`](crate::CompensatedCdf), as [`build_into`] does those of
/// [`EnvCdf`](crate::EnvCdf). `weights_of_row` gives the plain weights; it is called twice for each row.
///
/// To build in parallel, take each row's [`weight_sum`] first and their [`mean_weight`], then call
/// [`build_row_into`](crate::build_row_into) with each weight passed through [`compensated_weight`].
///
/// # Errors
/// As [`build_into`].
pub fn build_compensated_into<W: IntoIterator<IntoIter: ExactSizeIterator<Item = f32>>>(
    size: UVec2,
    mut weights_of_row: impl FnMut(u32) -> W,
    marginal: &mut [u32],
    conditional: &mut [u32],
) -> Result<BuildReport, BuildError> {
    required_len(size.x, size.y)?;
    let height = size.y as usize;
    let mut mean = 0.0;
    for y in 0..size.y {
        mean += weight_sum(weights_of_row(y).into_iter()) * band_area(y as usize, height);
    }
    let mean = (mean / f64::from(size.x)) as f32;
    build_into(
        size,
        |y| {
            weights_of_row(y)
                .into_iter()
                .map(move |weight| compensated_weight(weight, mean))
        },
        marginal,
        conditional,
    )
}
