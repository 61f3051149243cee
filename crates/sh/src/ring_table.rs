//! Host file: the factors of φ of a map's columns, and the sums over a row that they are for.
//!
//! A quarter of a turn maps a column onto another, and its cosines and sines onto themselves up to sign and order. So
//! where the width is a multiple of four, the four texels of a quarter of a turn are first added and subtracted, and
//! share each multiplication; the table is a quarter as long. Lanes run forwards through all four quarters of the row.

use glam::UVec2;

use crate::error::{ShError, check_bands, check_len, check_size};
use crate::row;
use crate::separable::column_ring;

/// The numbers that stand side by side in the table.
pub(crate) const LANES: usize = 8;

/// How a table is laid out: first groups of lanes, `[group][vector][factor][lane]`, then the columns that fill no group,
/// `[column][factor]`. In a group a factor is repeated for each channel, as texels lie in memory.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Layout {
    /// Floats in a texel.
    pub(crate) channels: usize,
    /// Columns that have factors of their own: a quarter of the row, or all of it.
    pub(crate) columns: usize,
    /// Whether it is a quarter.
    pub(crate) folded: bool,
    /// Vectors of [`LANES`] floats in a group, which holds whole texels.
    pub(crate) vectors: usize,
    /// Factors of a column: all but the first, which is 1.
    pub(crate) factors: usize,
    /// Groups.
    pub(crate) groups: usize,
    /// Columns behind the groups.
    pub(crate) tail: usize,
}

impl Layout {
    fn new(width: u32, bands: u32, channels: u32) -> Result<Self, ShError> {
        check_bands(bands)?;
        check_size(UVec2::new(width, 1))?;
        let vectors = match channels {
            3 => 3,
            4 => 1,
            _ => return Err(ShError::Channels(channels)),
        };
        let (width, channels) = (width as usize, channels as usize);
        let folded = width.is_multiple_of(4);
        let columns = if folded { width / 4 } else { width };
        let per_group = vectors * LANES / channels;
        let groups = if folded { columns / per_group } else { 0 };
        Ok(Self {
            channels,
            columns,
            folded,
            vectors,
            // One band needs none; the table of two serves it.
            factors: 2 * (bands.max(2) as usize - 1),
            groups,
            tail: columns - groups * per_group,
        })
    }

    fn grouped_len(&self) -> usize {
        self.groups * self.vectors * self.factors * LANES
    }

    fn len(&self) -> usize {
        self.grouped_len() + self.tail * self.factors
    }
}

/// The number of floats in the table of a map that is `width` texels wide, each of `channels` floats (3 or 4).
///
/// # Errors
/// [`ShError::Bands`], [`ShError::Size`], [`ShError::Channels`].
pub fn ring_table_len(width: u32, bands: u32, channels: u32) -> Result<usize, ShError> {
    Ok(Layout::new(width, bands, channels)?.len())
}

/// Fills `table`, of [`ring_table_len`], with cosines and sines of multiples of the columns' azimuths `φ = π − 2π(j +
/// ½)/width`.
///
/// # Errors
/// Those of [`ring_table_len`], and [`ShError::Length`].
pub fn build_ring_table_into(
    width: u32,
    bands: u32,
    channels: u32,
    table: &mut [f32],
) -> Result<(), ShError> {
    let layout = Layout::new(width, bands, channels)?;
    check_len(table.len(), layout.len())?;
    let ring_of = |column: usize| column_ring(column as u32, width);
    let (groups, tail) = table.split_at_mut(layout.grouped_len());
    for (block, vector) in groups.chunks_mut(layout.factors * LANES).enumerate() {
        for lane in 0..LANES {
            let ring = ring_of((block * LANES + lane) / layout.channels);
            for factor in 0..layout.factors {
                vector[factor * LANES + lane] = ring[factor + 1];
            }
        }
    }
    let first = layout.columns - layout.tail;
    for (column, factors) in tail.chunks_mut(layout.factors).enumerate() {
        let ring = ring_of(first + column);
        factors.copy_from_slice(&ring[1..=layout.factors]);
    }
    Ok(())
}

/// The sums over a row of red, green and blue times 1, cos φ, sin φ, cos 2φ, …, at
/// [`ring_index`](crate::separable::ring_index); 0 beyond the bands.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RingSums {
    /// The number of bands n, whose 2n − 1 sums are known.
    pub bands: u32,
    /// The sums of each factor.
    pub sums: [[f64; 3]; 11],
}

/// A table, with the map's width and the bands that it is for. One serves all rows, on any thread.
///
/// ```
/// use glimt_sh::{RingTable, ShError, build_ring_table_into, ring_table_len};
/// // A row of eight texels, of which the third is white: φ = π − 2π·2.5/8.
/// let mut table = vec![0.0; ring_table_len(8, 3, 3)?];
/// build_ring_table_into(8, 3, 3, &mut table)?;
/// let table = RingTable::new(8, 3, 3, &table)?;
/// let mut row = [[0.0f32; 3]; 8];
/// row[2] = [1.0; 3];
/// let sums = table.row_sums(row.as_flattened())?.sums;
/// let phi = 3.0 * core::f64::consts::FRAC_PI_8;
/// assert!((sums[0][0] - 1.0).abs() < 1e-6 && (sums[2][1] - phi.sin()).abs() < 1e-6 && (sums[3][2] - (2.0 * phi).cos()).abs() < 1e-6);
/// # Ok::<(), ShError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct RingTable<'a> {
    width: u32,
    bands: u32,
    layout: Layout,
    grouped: &'a [f32],
    tail: &'a [f32],
}

impl<'a> RingTable<'a> {
    /// The table that [`build_ring_table_into`] made for the same width, bands and channels.
    ///
    /// # Errors
    /// Those of [`build_ring_table_into`].
    pub fn new(width: u32, bands: u32, channels: u32, table: &'a [f32]) -> Result<Self, ShError> {
        let layout = Layout::new(width, bands, channels)?;
        check_len(table.len(), layout.len())?;
        let (grouped, tail) = table.split_at(layout.grouped_len());
        Ok(Self {
            width,
            bands,
            layout,
            grouped,
            tail,
        })
    }

    /// The map's width in texels.
    #[must_use]
    pub fn width(&self) -> u32 {
        self.width
    }

    /// The number of bands.
    #[must_use]
    pub fn bands(&self) -> u32 {
        self.bands
    }

    /// The number of floats in a row.
    #[must_use]
    pub fn row_len(&self) -> usize {
        self.width as usize * self.layout.channels
    }

    /// Sums a row, given as floats: `row.as_flattened()` of texels `[f32; 3]`, or of `[f32; 4]`, whose fourth channel is
    /// left out.
    ///
    /// Blocks of 32 products are summed in f32, blocks in f64. Nothing is checked: what is negative counts as it is, and
    /// a NaN or an infinity makes the sums of its own channel NaN or infinite, and no others. Who would take such texels
    /// as no light puts zeros there first.
    ///
    /// With the feature `std`, on an x86-64 with AVX2 and FMA, eight products are made at a time; the result differs
    /// from the plain path's by rounding, below 10⁻⁶ of the sum of the magnitudes.
    ///
    /// # Errors
    /// [`ShError::Length`] where the row has not `width · channels` floats.
    pub fn row_sums(&self, row: &[f32]) -> Result<RingSums, ShError> {
        check_len(row.len(), self.row_len())?;
        #[cfg(all(feature = "std", target_arch = "x86_64"))]
        if let Some(sums) = crate::wide::sum_groups(&self.layout, self.bands, row, self.grouped) {
            return Ok(row::add_tail(
                &self.layout,
                self.bands,
                row,
                self.tail,
                sums,
            ));
        }
        Ok(self.plain(row))
    }

    /// As [`RingTable::row_sums`], by the path that every processor has.
    ///
    /// # Errors
    /// [`ShError::Length`] where the row has not `width · channels` floats.
    pub fn row_sums_plain(&self, row: &[f32]) -> Result<RingSums, ShError> {
        check_len(row.len(), self.row_len())?;
        Ok(self.plain(row))
    }

    fn plain(&self, row: &[f32]) -> RingSums {
        let sums = row::sum_groups(&self.layout, self.bands, row, self.grouped);
        row::add_tail(&self.layout, self.bands, row, self.tail, sums)
    }
}
