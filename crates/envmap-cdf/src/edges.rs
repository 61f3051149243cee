//! Host file: running sums of weights, turned into `u32` edges in units of 2⁻³¹.

/// The whole of a table, in its units: the last edge of every table that is not black.
pub const UNITS: u32 = 1 << 31;

/// The edges of one table in the making: a running sum in f64, scaled and rounded to units.
///
/// A bin of positive weight that rounds to no unit at all is raised to one, which shifts all edges after it;
/// [`Edges::finish`] takes those units back from the largest bin. A bin of zero weight leaves the sum, and so the
/// edge, exactly as it was.
pub(crate) struct Edges {
    sum: f64,
    scale: f64,
    rounded: u32,
    raised: u32,
}

/// Bins per step of the fast path. Their sums are formed as a tree, so that the next step waits for one addition.
pub(crate) const LANES: usize = 8;

impl Edges {
    /// Starts a table whose weights add up to `total > 0`.
    pub(crate) fn new(total: f64) -> Self {
        Self {
            sum: 0.0,
            scale: f64::from(UNITS) / total,
            rounded: 0,
            raised: 0,
        }
    }

    /// The edge after the next bin.
    pub(crate) fn push(&mut self, weight: f64) -> u32 {
        self.sum += weight;
        self.advance(weight, nearest(self.sum * self.scale))
    }

    /// The edges after each of the next [`LANES`] bins.
    #[inline(always)]
    pub(crate) fn push_lanes(&mut self, w: &[f64; LANES]) -> [u32; LANES] {
        // Whatever the tree, adding a zero changes no sum and adding a positive weight lowers none, so the edges stay
        // in order and those around a zero weight stay equal.
        let w01 = w[0] + w[1];
        let w03 = w01 + (w[2] + w[3]);
        let w45 = w[4] + w[5];
        let low = self.sum;
        let high = low + w03;
        self.sum = high + (w45 + (w[6] + w[7]));
        let sums = [
            low + w[0],
            low + w01,
            low + (w01 + w[2]),
            high,
            high + w[4],
            high + w45,
            high + (w45 + w[6]),
            self.sum,
        ];
        let rounded = sums.map(|sum| nearest(sum * self.scale));
        let mut lost = (w[0] > 0.0) & (rounded[0] == self.rounded);
        for k in 1..LANES {
            lost |= (w[k] > 0.0) & (rounded[k] == rounded[k - 1]);
        }
        if lost {
            let mut edges = rounded;
            for k in 0..LANES {
                edges[k] = self.advance(w[k], rounded[k]);
            }
            edges
        } else {
            self.rounded = rounded[LANES - 1];
            rounded.map(|edge| edge + self.raised)
        }
    }

    fn advance(&mut self, weight: f64, rounded: u32) -> u32 {
        if weight > 0.0 && rounded == self.rounded {
            self.raised += 1;
        }
        self.rounded = rounded;
        rounded + self.raised
    }

    /// Ends the table: takes the units given to raised bins from the largest one. `edges` are all of them, with the
    /// leading 0. Returns how many bins were raised.
    pub(crate) fn finish(self, edges: &mut [u32]) -> u32 {
        if self.raised > 0 {
            let mut largest = (0, 0);
            for (bin, pair) in edges.windows(2).enumerate() {
                if pair[1] - pair[0] > largest.1 {
                    largest = (bin, pair[1] - pair[0]);
                }
            }
            for edge in &mut edges[largest.0 + 1..] {
                *edge -= self.raised;
            }
        }
        self.raised
    }
}

/// The integer nearest to `x ∈ [0, 2³²)`: added to 2⁵², whose last place is one, it stands in the low bits.
fn nearest(x: f64) -> u32 {
    const TWO_TO_52: f64 = 4_503_599_627_370_496.0;
    (x + TWO_TO_52).to_bits() as u32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lanes_and_single_bins_agree() {
        let weights = [1.0, 0.0, 1e-30, 5.0, 0.0, 0.0, 2.0, 1e-12];
        let total: f64 = weights.iter().sum();
        let (mut one, mut many) = (Edges::new(total), Edges::new(total));
        let single = weights.map(|w| one.push(w));
        assert_eq!(single, many.push_lanes(&weights));
        assert_eq!((one.raised, many.raised), (2, 2));
    }

    #[test]
    fn raised_units_come_from_the_largest_bin() {
        let weights = [1e-30, 1.0, 3.0, 0.0, 1e-30];
        let mut edges = [0; 6];
        let mut table = Edges::new(4.0);
        for (edge, w) in edges[1..].iter_mut().zip(weights) {
            *edge = table.push(w);
        }
        assert_eq!(table.finish(&mut edges), 2);
        let quarter = UNITS / 4;
        assert_eq!(edges, [0, 1, quarter + 1, UNITS - 1, UNITS - 1, UNITS]);
    }
}
