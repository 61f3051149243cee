//! Shared file: the sphere in 32 × 16 cells of nearly equal area, each a rectangle of texels, and where a map's table has what.

use glam::{UVec2, Vec4};
use glimt_envmap_cdf::{Bin, find_bin};

/// Columns of cells.
pub const COLUMNS: u32 = 32;
/// Rows of cells: equal steps in cos θ, each of whole rows of texels.
pub const ROWS: u32 = 16;
/// Cells of a map.
pub const CELLS: u32 = COLUMNS * ROWS;
/// Quads of a map: four cells of a row, which are computed together. A row of cells has eight of them.
pub const QUADS: u32 = CELLS / 4;

/// Units of a row of texels within a cell: the last of its edges, where it is not black.
pub const COLUMN_UNITS: u32 = 1 << 15;

/// Words before the sums: the first texel rows of the rows of cells, one more than there are, and some to spare.
const HEAD: u32 = 32;

/// What is known of a cell, each a list of [`CELLS`] f32.
pub mod field {
    /// `Λ = Σ Y(L) dω`, the flux in luminance.
    pub const FLUX: u32 = 0;
    /// `R = Σ L dω`, three lists.
    pub const RADIANCE: u32 = 1;
    /// `M = Σ L ω dω`: x, y and z for red, then for green, then for blue, nine lists.
    pub const MOMENT: u32 = 4;
    /// `Q = Σ Y(L)² dω`.
    pub const SQUARE: u32 = 13;
    /// `Ω`, the solid angle in steradians.
    pub const SOLID_ANGLE: u32 = 14;
    /// `d`, the mean direction by radiance, or of the area where the cell is black: three lists.
    pub const DIRECTION: u32 = 15;
    /// `ρ`, no less than the largest angle from `d` to the cell's points, in radians.
    pub const RADIUS: u32 = 18;
    /// `√3 √(2 (1 − |M|/R))`, M and R summed over the channels, and no more than ρ: about ρ where the cell's light is even, and less where
    /// it lies close together, as that of a lamp. 0 for a black cell.
    pub const SPREAD: u32 = 19;
    /// How many lists there are.
    pub const COUNT: u32 = 20;
}

/// A light map's cells, in its own coordinates: a view of the words that [`build_band`](crate::build_band) and
/// [`store_sums`](crate::store_sums) fill.
#[derive(Clone, Copy, Debug)]
pub struct LightCells<'a> {
    /// Columns and rows of texels of the map.
    pub size: UVec2,
    /// Words that hold its table, among others.
    pub words: &'a [u32],
    /// Index of its first word.
    pub start: u32,
}

/// A texel with the probability by which it was drawn in its cell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TexelDraw {
    /// Column and row.
    pub texel: UVec2,
    /// Its probability within the cell; 0 for a cell without light.
    pub pmf: f32,
}

/// Words of the table of a map of this size.
#[inline]
#[must_use]
pub fn table_words(size: UVec2) -> u32 {
    first_column_word(size) + size.y * column_words(size.x)
}

/// The first of the edges of rows.
#[inline]
pub(crate) fn first_row_word() -> u32 {
    HEAD + field::COUNT * CELLS
}

/// The first of the edges of columns.
#[inline]
pub(crate) fn first_column_word(size: UVec2) -> u32 {
    first_row_word() + COLUMNS * (size.y + ROWS)
}

/// Words for the edges of columns in a row of texels: two edges a word.
#[inline]
pub(crate) fn column_words(width: u32) -> u32 {
    width.div_ceil(2)
}

/// The first column of texels of column `column` of cells; of the one behind the last, the map's width.
#[inline]
#[must_use]
pub fn first_column(column: u32, width: u32) -> u32 {
    column * width / COLUMNS
}

/// The column of cells that a column of texels belongs to.
#[inline]
#[must_use]
pub fn column_of(x: u32, width: u32) -> u32 {
    (COLUMNS * (x + 1) - 1) / width
}

/// The upper 15 bits of a word's place among 2³².
#[inline]
fn column_unit(u: u32) -> u32 {
    u >> 17
}

impl LightCells<'_> {
    /// Four numbers of a list of [`field`], of cells `4 · quad` on.
    #[inline]
    #[must_use]
    pub fn quad(&self, list: u32, quad: u32) -> Vec4 {
        let at = (self.start + HEAD + list * CELLS + 4 * quad) as usize;
        Vec4::new(
            f32::from_bits(self.words[at]),
            f32::from_bits(self.words[at + 1]),
            f32::from_bits(self.words[at + 2]),
            f32::from_bits(self.words[at + 3]),
        )
    }

    /// A cell's number of a list of [`field`].
    #[inline]
    #[must_use]
    pub fn value(&self, list: u32, cell: u32) -> f32 {
        f32::from_bits(self.words[(self.start + HEAD + list * CELLS + cell) as usize])
    }

    /// The cell that a texel belongs to.
    #[inline]
    #[must_use]
    pub fn cell_of(&self, texel: UVec2) -> u32 {
        let row = find_bin(self.words, self.start as usize, ROWS as usize, texel.y).index;
        row * COLUMNS + column_of(texel.x, self.size.x)
    }

    /// Texel rows `first .. end` of row `row` of cells.
    #[inline]
    fn texel_rows(&self, row: u32) -> UVec2 {
        let at = (self.start + row) as usize;
        UVec2::new(self.words[at], self.words[at + 1])
    }

    /// Where the edges of a cell's texel rows begin, in units of 2⁻³¹: one more than it has rows.
    #[inline]
    fn row_edges(&self, cell: u32, rows: UVec2) -> u32 {
        let (column, row) = (cell % COLUMNS, cell / COLUMNS);
        let of_band = COLUMNS * (rows.x + row);
        self.start + first_row_word() + of_band + column * (rows.y - rows.x + 1)
    }

    /// The upper edge of texel `x` of row `y` among those of its cell's row, in units of 2⁻¹⁵.
    #[inline]
    fn column_edge(&self, x: u32, y: u32) -> u32 {
        let at = self.start + first_column_word(self.size) + y * column_words(self.size.x) + x / 2;
        (self.words[at as usize] >> (16 * (x & 1))) & 0xffff
    }

    /// Draws a texel of a cell in proportion to its luminance and solid angle, `u.x` for the column and `u.y` for the row.
    #[inline]
    #[must_use]
    pub fn sample(&self, cell: u32, u: UVec2) -> TexelDraw {
        let rows = self.texel_rows(cell / COLUMNS);
        let edges = self.row_edges(cell, rows);
        let of_row = find_bin(
            self.words,
            edges as usize,
            (rows.y - rows.x) as usize,
            u.y >> 1,
        );
        let y = rows.x + of_row.index;
        let column = cell % COLUMNS;
        let first = first_column(column, self.size.x);
        // The texel whose upper edge is the first above u.
        let unit = column_unit(u.x);
        let mut at = first;
        let mut left = first_column(column + 1, self.size.x) - first;
        while left > 1 {
            let half = left / 2;
            if self.column_edge(at + half - 1, y) <= unit {
                at += half;
            }
            left -= half;
        }
        TexelDraw {
            texel: UVec2::new(at, y),
            pmf: self.pmf(of_row, UVec2::new(at, y), first),
        }
    }

    /// Probability of a texel among those of its cell by [`LightCells::sample`]; 0 for a black one.
    #[inline]
    #[must_use]
    pub fn pmf_in_cell(&self, texel: UVec2, cell: u32) -> f32 {
        let rows = self.texel_rows(cell / COLUMNS);
        let at = (self.row_edges(cell, rows) + texel.y - rows.x) as usize;
        let of_row = Bin {
            index: 0,
            first: 0,
            units: self.words[at + 1] - self.words[at],
        };
        let first = first_column(cell % COLUMNS, self.size.x);
        self.pmf(of_row, texel, first)
    }

    /// The product of a row's and a column's probability. `first` is the cell's first column of texels.
    #[inline]
    fn pmf(&self, row: Bin, texel: UVec2, first: u32) -> f32 {
        let lower = if texel.x > first {
            self.column_edge(texel.x - 1, texel.y)
        } else {
            0
        };
        let units = self.column_edge(texel.x, texel.y) - lower;
        row.units as f32 * (1.0 / 2_147_483_648.0) * (units as f32 * (1.0 / 32_768.0))
    }
}
