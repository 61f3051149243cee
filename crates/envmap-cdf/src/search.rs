//! Shared file: finding the bin of a table that a number falls into.

/// A bin of a table, as found by [`find_bin`]; edges and widths in units of 2⁻³¹.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bin {
    /// Which bin, from 0.
    pub index: u32,
    /// Its lower edge.
    pub first: u32,
    /// Its width: its probability times 2³¹.
    pub units: u32,
}

/// The bin of `u` (31 bits) in a table of rising edges: the one above the last edge that is not above `u`.
///
/// `edges` holds one entry more than there are bins, and at least 2, with first edge 0 and last edge 2³¹. Then a bin
/// of no width is never found. The search takes the same `log₂` steps for every `u`, and reads no entry twice.
///
/// ```
/// use glimt_envmap_cdf::{Bin, find_bin};
/// let edges = [0, 1 << 30, 1 << 30, 1 << 31];
/// assert_eq!(find_bin(&edges, (1 << 30) - 1).index, 0);
/// assert_eq!(find_bin(&edges, 1 << 30), Bin { index: 2, first: 1 << 30, units: 1 << 30 });
/// ```
#[inline]
#[must_use]
pub fn find_bin(edges: &[u32], u: u32) -> Bin {
    // The answer is one of the `bins` bins from `index` on.
    let mut index = 0usize;
    let mut bins = edges.len() - 1;
    while bins > 1 {
        let half = bins / 2;
        if edges[index + half] <= u {
            index += half;
        }
        bins -= half;
    }
    let first = edges[index];
    Bin {
        index: index as u32,
        first,
        units: edges[index + 1] - first,
    }
}
