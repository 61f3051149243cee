//! Shared file: finding the bin of a table that a number falls into.

/// A bin of a table, as found by [`find_bin`]; edges and widths in units of 2⁻³¹.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bin {
    /// Which bin of the table, from 0.
    pub index: u32,
    /// Its lower edge.
    pub first: u32,
    /// Its width: its probability times 2³¹.
    pub units: u32,
}

/// The bin of `u` (31 bits) in a table of rising edges: the one above the last edge that is not above `u`.
///
/// The table is `edges[start ..= start + bins]`: one entry more than there are bins, and at least one bin, with first edge 0
/// and last edge 2³¹. Then a bin of no width is never found. What lies outside the table is not read, so several tables can
/// share a slice, and a slice may be longer than its tables. The search takes the same `log₂` steps for every `u`, and reads
/// no entry twice. Without bins it reads as if there were one; it panics where an entry that it reads lies outside the slice.
///
/// ```
/// use glimt_envmap_cdf::{Bin, find_bin};
/// let edges = [0, 1 << 30, 1 << 30, 1 << 31];
/// assert_eq!(find_bin(&edges, 0, 3, (1 << 30) - 1).index, 0);
/// assert_eq!(find_bin(&edges, 0, 3, 1 << 30), Bin { index: 2, first: 1 << 30, units: 1 << 30 });
/// // The second of two tables of one bin each.
/// assert_eq!(find_bin(&[0, 1 << 31, 0, 1 << 31], 2, 1, 7).index, 0);
/// ```
#[inline]
#[must_use]
pub fn find_bin(edges: &[u32], start: usize, bins: usize, u: u32) -> Bin {
    // The answer is one of the `left` bins whose first edge is at `at` and behind it.
    let mut at = start;
    let mut left = bins;
    while left > 1 {
        let half = left / 2;
        if edges[at + half] <= u {
            at += half;
        }
        left -= half;
    }
    let first = edges[at];
    Bin {
        index: (at - start) as u32,
        first,
        units: edges[at + 1] - first,
    }
}
