//! Shared file: a light map halved, by a Gaussian that keeps what it sums.
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

/// The columns that a column of the smaller map is the mean of, or the rows of a row. 32 bytes.
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct Taps {
    /// The first; the others follow, and the map's first column its last.
    pub first: u32,
    /// How many there are, at most six.
    pub count: u32,
    /// Their weights, which add up to 1.
    pub weights: [f32; 6],
}

/// The taps of column `index` of the half of a lat-long map of size `size`, at least 1 × 1; behind the columns come the rows.
#[must_use]
pub fn taps(index: u32, size: UVec2) -> Taps {
    let half = half_size(size);
    let is_row = index >= half.x;
    let span = if is_row {
        Span::new(index - half.x, size.y, half.y)
    } else {
        Span::new(index, size.x, half.x)
    };
    let mut weights = [0.0; 6];
    let mut count = 0;
    let mut sum = 0.0;
    // One more than the column: it begins at −1. So do rows, of which there is none at −1.
    let mut next = span.first;
    if is_row {
        next = next.max(1);
    }
    let begin = next;
    while next <= span.end() + 1 && count < 6 && !(is_row && next > size.y) {
        let weight = if is_row {
            span.weight_of_row(next - 1, size.y)
        } else {
            span.weight_of_column(next)
        };
        weights[count as usize] = weight;
        sum += weight;
        count += 1;
        next += 1;
    }
    for i in 0..6 {
        weights[i as usize] /= sum;
    }
    let first = if is_row {
        begin - 1
    } else {
        (begin + size.x - 1) % size.x
    };
    Taps {
        first,
        count,
        weights,
    }
}

/// The texel `texel` of the half of a lat-long map of size `size`, whose [`taps`] are known.
#[must_use]
pub fn halve(texel: u32, size: UVec2, taps: &[Taps], texels: &[Vec4]) -> Vec4 {
    let half = half_size(size);
    let columns = &taps[(texel % half.x) as usize];
    let rows = &taps[(half.x + texel / half.x) as usize];
    let mut sum = Vec4::ZERO;
    for j in 0..rows.count {
        let row = (rows.first + j) * size.x;
        let mut of_row = Vec4::ZERO;
        let mut column = columns.first;
        for i in 0..columns.count {
            of_row += texels[(row + column) as usize] * columns.weights[i as usize];
            column += 1;
            if column == size.x {
                column = 0;
            }
        }
        sum += of_row * rows.weights[j as usize];
    }
    sum
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
        let mut weight = 0.0;
        if own > 0.0 {
            weight += own * sine(2 * row + 1, rows);
        }
        if row > 0 {
            weight += 0.25 * across(self.covers_row(row - 1, rows) - own, row, rows);
        }
        if row + 1 < rows {
            weight += 0.25 * across(self.covers_row(row + 1, rows) - own, row + 1, rows);
        }
        weight
    }
}

/// What crosses the edge above row `row` where the shares of both sides differ by so much.
#[inline]
fn across(difference: f32, row: u32, rows: u32) -> f32 {
    if difference == 0.0 {
        return 0.0;
    }
    difference * sine(2 * row, rows)
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn layout_is_that_of_wgsl() {
        assert_eq!(core::mem::size_of::<Taps>(), 32);
        assert_eq!(core::mem::offset_of!(Taps, weights), 8);
    }

    #[test]
    fn even_sizes_have_the_weights_of_a_spline() {
        let column = taps(1, UVec2::new(8, 4));
        assert_eq!((column.first, column.count), (1, 4));
        assert_eq!(column.weights, [0.125, 0.375, 0.375, 0.125, 0.0, 0.0]);
        assert_eq!(taps(0, UVec2::new(8, 4)).first, 7, "across the seam");
    }

    #[test]
    fn no_size_has_more_taps_than_there_is_room_for() {
        for side in 1..400 {
            let size = UVec2::new(side, side);
            let half = half_size(size);
            for index in 0..half.x + half.y {
                let taps = taps(index, size);
                assert!((1..6).contains(&taps.count), "{side} {index}");
                let sum: f32 = taps.weights.iter().sum();
                assert!((sum - 1.0).abs() < 1e-6 && taps.weights.iter().all(|w| *w >= 0.0));
            }
        }
    }
}
