//! Host file: the tables that draw directions where a light map is brighter than its mean, for `mis` (Karlík et al. 2019).

use glimt_envmap_cdf::{BuildError, compensated_weight, mean_weight};
use glimt_sampling::luminance;
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
    if light.row_luminance.is_empty() {
        light.row_luminance = row_luminance(light);
    }
    let mean = mean_weight(&light.row_luminance, light.size.x);
    cdf::fill(light, own, |luminance| compensated_weight(luminance, mean)).map(drop)
}

/// The sum of each row's luminance.
fn row_luminance(light: &Light<'_>) -> Vec<f64> {
    let of_row = |row: &[glam::Vec4]| {
        let each = row.iter().map(|t| f64::from(luminance(t.truncate())));
        each.sum()
    };
    let rows = light.texels.par_chunks(light.size.x as usize);
    rows.map(of_row).collect()
}
