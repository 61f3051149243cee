//! Host file: the tables that draw directions in proportion to a light map's luminance.

use glam::Vec4;
use glimt_envmap_cdf::{BuildError, build_marginal_into, build_row_into};
use glimt_sampling::luminance;
use rayon::prelude::*;

use super::{Light, LightTable};
use crate::kernels::environment::{cdf_words, marginal_words};
use crate::methods::CDF;

/// The table of rows, then the tables of columns, a row after the other.
pub(super) const TABLE: LightTable = LightTable {
    name: CDF,
    first: |_| 0,
    words: cdf_words,
    build,
};

fn build(light: &mut Light<'_>, own: &mut [u32]) -> Result<(), BuildError> {
    light.row_luminance = fill(light, own, |luminance| luminance)?;
    Ok(())
}

/// The luminance of each texel of a row.
pub(super) fn luminances(row: &[Vec4]) -> impl ExactSizeIterator<Item = f32> + '_ {
    row.iter().map(|texel| luminance(texel.truncate()))
}

/// Fills the tables by a weight of each texel's luminance. Returns the sum of each row's weights.
pub(super) fn fill(
    light: &Light<'_>,
    own: &mut [u32],
    weight: impl Fn(f32) -> f32 + Copy + Sync,
) -> Result<Vec<f64>, BuildError> {
    let (marginal, conditional) = own.split_at_mut(marginal_words(light.size) as usize);
    let width = light.size.x as usize;
    let sums = conditional
        .par_chunks_mut(width + 1)
        .zip(light.texels.par_chunks(width))
        .map(|(edges, row)| {
            build_row_into(luminances(row).map(weight), edges).map(|report| report.weight_sum)
        })
        .collect::<Result<Vec<_>, _>>()?;
    build_marginal_into(&sums, marginal)?;
    Ok(sums)
}
