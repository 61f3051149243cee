//! Host file: the tables that draw directions where a light map is brighter than its mean, for `mis` (Karlík et al. 2019).

use glimt_envmap_cdf::{BuildError, compensated_weight, mean_weight, weight_sum};
use rayon::prelude::*;

use super::{Light, LightTable, cdf};
use crate::kernels::environment::cdf_words;
use crate::methods::mis::COMPENSATED_CDF;

/// As [`cdf::TABLE`], of the weights `max(0, L − L̄)`, L̄ the mean luminance over the sphere. Black under a constant map.
pub(super) const TABLE: LightTable = LightTable {
    name: COMPENSATED_CDF,
    first: |_| 0,
    words: cdf_words,
    build,
};

fn build(light: &mut Light<'_>, own: &mut [u32]) -> Result<(), BuildError> {
    let width = light.size.x;
    if light.row_luminance.is_empty() {
        let rows = light.texels.par_chunks(width as usize);
        let sums = rows.map(|row| weight_sum(cdf::luminances(row)));
        light.row_luminance = sums.collect();
    }
    let mean = mean_weight(&light.row_luminance, width);
    cdf::fill(light, own, |luminance| compensated_weight(luminance, mean)).map(drop)
}
