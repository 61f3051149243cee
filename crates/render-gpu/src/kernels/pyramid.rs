//! Shared file: a light map halved, by a Gaussian that keeps what it sums. One element is one texel of the smaller map.
//!
//! The map is blurred by (1 2 1)/4 in rows and columns, then averaged over the texels of the smaller map: where a side is
//! even, the weights are (1 3 3 1)/8, those of a quadratic B-spline. On the sphere the blur exchanges light between
//! neighbours in the same measure both ways, and the average goes by solid angle. So a constant map stays constant and the
//! flux is kept, at the poles, across the seam and for any size; nothing has to be mirrored, since no light crosses a row's edge
//! of no length.

use glam::{UVec2, Vec4};
use glimt_probe::trig::cos_sin_pi;

/// Size of the map that a map of size `size` is halved to: half as many columns and rows, rounded down, but one at least.
///
/// ```
/// use glam::UVec2;
/// use glimt_render_gpu::kernels::pyramid::half_size;
/// assert_eq!(half_size(UVec2::new(1628, 407)), UVec2::new(814, 203));
/// assert_eq!(half_size(UVec2::ONE), UVec2::ONE);
/// ```
#[inline]
#[must_use]
pub fn half_size(size: UVec2) -> UVec2 {
    UVec2::new((size.x / 2).max(1), (size.y / 2).max(1))
}

/// The texel `texel` of the half of a lat-long map of size `size`, at least 1 × 1.
#[must_use]
pub fn halve(texel: u32, size: UVec2, texels: &[Vec4]) -> Vec4 {
    let half = half_size(size);
    let columns = Span::new(texel % half.x, size.x, half.x);
    let rows = Span::new(texel / half.x, size.y, half.y);
    let mut sum = Vec4::ZERO;
    let mut weights = 0.0;
    let mut row = rows.first.max(1) - 1;
    while row < size.y && row <= rows.end() {
        let row_weight = rows.weight_of_row(row, size.y);
        let mut of_row = Vec4::ZERO;
        let mut of_weights = 0.0;
        // One more than the column: it begins at −1.
        let mut next = columns.first;
        while next <= columns.end() + 1 {
            let weight = columns.weight_of_column(next);
            of_row += texels[(row * size.x + (next + size.x - 1) % size.x) as usize] * weight;
            of_weights += weight;
            next += 1;
        }
        sum += of_row * row_weight;
        weights += of_weights * row_weight;
        row += 1;
    }
    sum / weights
}

/// What a texel of the smaller map covers of the larger one, in rows or in columns.
#[derive(Clone, Copy, Debug)]
struct Span {
    /// The first that it covers.
    first: u32,
    /// How much of that one lies before it.
    before: f32,
    /// The last that it covers, or the one after.
    last: u32,
    /// How much it covers of that one; 0 for the one after.
    within: f32,
}

impl Span {
    /// Of `size` reduced to `half`, by number `index`.
    #[inline]
    fn new(index: u32, size: u32, half: u32) -> Span {
        let (from, to) = (index * size, (index + 1) * size);
        Span {
            first: from / half,
            before: (from % half) as f32 / half as f32,
            last: to / half,
            within: (to % half) as f32 / half as f32,
        }
    }

    /// The last with a weight.
    #[inline]
    fn end(&self) -> u32 {
        if self.within > 0.0 {
            self.last + 1
        } else {
            self.last
        }
    }

    /// Share of column `next − 1` that is covered.
    #[inline]
    fn covers_column(&self, next: u32) -> f32 {
        if next < self.first + 1 || next > self.last + 1 {
            return 0.0;
        }
        if next == self.last + 1 {
            return self.within;
        }
        if next == self.first + 1 {
            return 1.0 - self.before;
        }
        1.0
    }

    /// Weight of column `next − 1`.
    #[inline]
    fn weight_of_column(&self, next: u32) -> f32 {
        let left = if next > 0 {
            self.covers_column(next - 1)
        } else {
            0.0
        };
        0.5 * self.covers_column(next) + 0.25 * (left + self.covers_column(next + 1))
    }

    /// Share of row `row`'s area that is covered.
    #[inline]
    fn covers_row(&self, row: u32, rows: u32) -> f32 {
        if row < self.first || row > self.last {
            return 0.0;
        }
        if row == self.last {
            return area_above(row, self.within, rows);
        }
        if row == self.first {
            return 1.0 - area_above(row, self.before, rows);
        }
        1.0
    }

    /// Weight of row `row`, in units of area: what is covered of it and of what it gives to its neighbours, for what they
    /// give to it.
    #[inline]
    fn weight_of_row(&self, row: u32, rows: u32) -> f32 {
        let own = self.covers_row(row, rows);
        let mut weight = own * sine(2 * row + 1, rows);
        if row > 0 {
            weight += 0.25 * sine(2 * row, rows) * (self.covers_row(row - 1, rows) - own);
        }
        if row + 1 < rows {
            weight += 0.25 * sine(2 * row + 2, rows) * (self.covers_row(row + 1, rows) - own);
        }
        weight
    }
}

/// Sine of the angle from the pole after `half_rows` half rows of `rows`.
#[inline]
fn sine(half_rows: u32, rows: u32) -> f32 {
    cos_sin_pi(half_rows.min(2 * rows - half_rows) as f32 / (2 * rows) as f32).y
}

/// Share of a row's area in its upper `part`.
#[inline]
fn area_above(row: u32, part: f32, rows: u32) -> f32 {
    if part == 0.0 {
        return 0.0;
    }
    // Of both, the smaller keeps the precision.
    let from_pole = f32::min(row as f32 + 0.5 * part, (rows - row) as f32 - 0.5 * part);
    let whole = sine(2 * row + 1, rows) * cos_sin_pi(0.5 / rows as f32).y;
    cos_sin_pi(from_pole / rows as f32).y * cos_sin_pi(0.5 * part / rows as f32).y / whole
}
