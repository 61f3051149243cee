//! Host file: the tables of a light map, one after the other in one buffer of words.
//!
//! A table is a file of [`light_tables`](self) with its [`LightTable`], and a line of [`TABLES`]. Kernels find it by the function
//! that is its [`LightTable::first`].

mod cdf;
mod light_cells;

use glam::{UVec2, Vec4};
use glimt_envmap_cdf::{BuildError, required_len};

/// All tables, in the order in which they lie.
const TABLES: &[LightTable] = &[cdf::TABLE, light_cells::TABLE];

/// A table of words that is made of each light map.
struct LightTable {
    /// What methods call it that read it.
    name: &'static str,
    /// Index of its first word, for a map of this size: the sum of the words of the tables before it.
    first: fn(UVec2) -> u32,
    /// How many words it has, for a map of this size.
    words: fn(UVec2) -> u32,
    /// Fills its own words, which are 0. Those of the tables before it that are wanted are filled.
    build: Build,
}

type Build = fn(light: &mut Light<'_>, before: &[u32], own: &mut [u32]) -> Result<(), BuildError>;

/// A light map, and what its tables find out on the way.
pub(super) struct Light<'a> {
    /// Columns and rows.
    pub(super) size: UVec2,
    /// Rows from the top.
    pub(super) texels: &'a [Vec4],
    /// The sum of each row's luminance. Empty before the first table is built.
    pub(super) row_luminance: Vec<f64>,
}

/// Room for all tables of a map of this size, all words 0, as of a black map.
///
/// # Errors
/// [`BuildError::Size`].
pub(super) fn zeroed(size: UVec2) -> Result<Vec<u32>, BuildError> {
    required_len(size.x, size.y)?;
    let words: u32 = TABLES.iter().map(|table| (table.words)(size)).sum();
    Ok(vec![0; words as usize])
}

/// All tables of a map. Those that are not `wanted` have room, too, and stay 0.
///
/// # Errors
/// [`BuildError::Size`].
pub(super) fn build(
    light: &mut Light<'_>,
    wanted: &dyn Fn(&str) -> bool,
) -> Result<Vec<u32>, BuildError> {
    let size = light.size;
    let mut all = zeroed(size)?;
    for table in TABLES.iter().filter(|table| wanted(table.name)) {
        let (before, rest) = all.split_at_mut((table.first)(size) as usize);
        let own = &mut rest[..(table.words)(size) as usize];
        (table.build)(light, before, own)?;
    }
    Ok(all)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_lie_one_after_the_other() {
        for (x, y) in [(1, 1), (2, 1), (1, 9), (64, 32), (1628, 814)] {
            let size = UVec2::new(x, y);
            let mut end = 0;
            for table in TABLES {
                assert_eq!((table.first)(size), end);
                end += (table.words)(size);
            }
            assert_eq!(zeroed(size).unwrap().len(), end as usize);
        }
    }
}
