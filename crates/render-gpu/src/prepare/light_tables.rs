//! Host file: the tables of a light map, one after the other in buffers of words.
//!
//! A table is a file of [`light_tables`](self) with its [`LightTable`], and a line of [`BUFFERS`]. Kernels see one buffer, and find
//! a table there by the function that is its [`LightTable::first`].

mod cdf;
mod compensated_cdf;
mod light_cells;

use glam::{UVec2, Vec4};
use glimt_envmap_cdf::{BuildError, required_len};

use crate::methods::Method;

/// All tables, in the order in which they lie in their buffers. Whatever a method reads lies in one buffer. The first two are tables
/// of directions, so kernels draw from either by the same words.
const BUFFERS: [&[LightTable]; 3] = [
    &[cdf::TABLE],
    &[compensated_cdf::TABLE],
    &[light_cells::TABLE],
];

/// A table of words that is made of each light map.
struct LightTable {
    /// What methods call it that read it.
    name: &'static str,
    /// Index of its first word, for a map of this size: the sum of the words of the tables before it in its buffer.
    first: fn(UVec2) -> u32,
    /// How many words it has, for a map of this size.
    words: fn(UVec2) -> u32,
    /// Fills its own words, which are 0.
    build: Build,
}

type Build = fn(light: &mut Light<'_>, own: &mut [u32]) -> Result<(), BuildError>;

/// A light map, and what its tables find out on the way.
pub(super) struct Light<'a> {
    /// Columns and rows.
    pub(super) size: UVec2,
    /// Rows from the top.
    pub(super) texels: &'a [Vec4],
    /// The sum of each row's luminance. Empty before the first table is built.
    pub(super) row_luminance: Vec<f64>,
}

/// Tables that kernels see together.
#[derive(Clone, Debug)]
pub(super) struct TableBuffer {
    /// Words of all of its tables. Those of a table that was not built are 0, as of a black map.
    pub(super) words: Vec<u32>,
    pub(super) built: BuiltTables,
}

/// Names of the tables that a buffer holds.
#[derive(Clone, Debug, Default)]
pub(crate) struct BuiltTables(Vec<&'static str>);

impl BuiltTables {
    /// Whether a method finds all here that it reads.
    pub(crate) fn serve(&self, method: &Method) -> bool {
        let mut all = BUFFERS.iter().copied().flatten();
        all.all(|table| !method.reads(table.name) || self.0.contains(&table.name))
    }
}

/// The buffers of a map, with those tables that are `wanted`. The first has all of its words in any case.
///
/// # Errors
/// [`BuildError::Size`].
pub(super) fn build(
    light: &mut Light<'_>,
    wanted: &dyn Fn(&str) -> bool,
) -> Result<Vec<TableBuffer>, BuildError> {
    let size = light.size;
    required_len(size.x, size.y)?;
    let mut buffers = Vec::new();
    for tables in BUFFERS {
        let built: Vec<&LightTable> = tables.iter().filter(|table| wanted(table.name)).collect();
        let is_there = buffers.is_empty() || !built.is_empty();
        let count: u32 = tables.iter().map(|table| (table.words)(size)).sum();
        let mut words = vec![0; if is_there { count as usize } else { 0 }];
        for table in &built {
            let own = &mut words[(table.first)(size) as usize..][..(table.words)(size) as usize];
            (table.build)(light, own)?;
        }
        let built = BuiltTables(built.iter().map(|table| table.name).collect());
        buffers.push(TableBuffer { words, built });
    }
    Ok(buffers)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_lie_one_after_the_other() {
        for (x, y) in [(1, 1), (2, 1), (1, 9), (64, 32), (1628, 814)] {
            let size = UVec2::new(x, y);
            let texels = vec![Vec4::ONE; (x * y) as usize];
            let mut light = Light {
                size,
                texels: &texels,
                row_luminance: Vec::new(),
            };
            let buffers = build(&mut light, &|_| true).unwrap();
            for (tables, buffer) in BUFFERS.iter().zip(buffers) {
                let mut end = 0;
                for table in *tables {
                    assert_eq!((table.first)(size), end);
                    end += (table.words)(size);
                }
                assert_eq!(buffer.words.len(), end as usize);
            }
        }
    }
}
