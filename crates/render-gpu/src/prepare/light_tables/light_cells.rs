//! Host file: a light map's cells.

use glimt_envmap_cdf::BuildError;
use glimt_light_cells::{build_band, split_bands, store_sums, table_words};
use rayon::prelude::*;

use super::{Light, LightTable};
use crate::methods::LIGHT_CELLS;

/// That of `glimt_light_cells`.
pub(super) const TABLE: LightTable = LightTable {
    name: LIGHT_CELLS,
    first: |_| 0,
    words: table_words,
    build,
};

fn build(light: &mut Light<'_>, own: &mut [u32]) -> Result<(), BuildError> {
    let (size, texels) = (light.size, light.texels);
    let width = size.x as usize;
    let failed = |_| BuildError::Size(size);
    let (head, bands) = split_bands(size, own).map_err(failed)?;
    let texels_of_row = |y: u32| &texels[y as usize * width..][..width];
    let sums = bands
        .into_par_iter()
        .enumerate()
        .map(|(row, band)| build_band(size, row as u32, texels_of_row, band))
        .collect::<Result<Vec<_>, _>>()
        .map_err(failed)?;
    for (row, sums) in (0..).zip(&sums) {
        store_sums(size, row, sums, head);
    }
    Ok(())
}
