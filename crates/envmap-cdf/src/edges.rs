//! Host file: running sums of weights, turned into `u32` edges in units of 2⁻³¹.

/// The whole of a table, in its units: the last edge of every table that is not black.
pub const UNITS: u32 = 1 << 31;

/// Bits below the unit in running sums. Each weight is rounded to 2⁻²¹ units, so that even after 2¹⁵ of them an edge is
/// within 2⁻⁶ units of its place before it is rounded itself; and a whole table, 2⁵¹, still fits the integers of f64.
const FRACTION_BITS: u32 = 20;

/// One unit, in running sums.
const ONE: u64 = 1 << FRACTION_BITS;

/// Bins per step of the fast path.
pub(crate) const LANES: usize = 8;

/// The edges of one table in the making: a running sum of weights, as integers.
///
/// A bin of positive weight that moves the edge by no unit at all is raised by one, which shifts all edges after it;
/// [`Edges::finish`] takes those units back from the largest bin. A bin of zero weight leaves the sum, and so the
/// edge, as it was.
pub(crate) struct Edges {
    sum: u64,
    scale: f64,
    raised: u32,
}

impl Edges {
    /// Starts a table whose weights add up to `total > 0`.
    pub(crate) fn new(total: f64) -> Self {
        let unit = total / f64::from(UNITS);
        Self {
            // Edges are rounded down from here, and so to the nearest.
            sum: ONE / 2,
            scale: ONE as f64 / unit,
            raised: 0,
        }
    }

    /// The edge after the next bin.
    pub(crate) fn push(&mut self, weight: f64) -> u32 {
        let mut sum = self.sum.wrapping_add(nearest(weight * self.scale));
        if weight > 0.0 && edge_at(sum) == edge_at(self.sum) {
            sum = sum.wrapping_add(ONE);
            self.raised += 1;
        }
        self.sum = sum;
        edge_at(sum)
    }

    /// Whether a bin of this weight is worth a unit, so that neither it nor a larger one can ask to be raised.
    pub(crate) fn has_unit(&self, weight: f32) -> bool {
        nearest(f64::from(weight) * self.scale) % TWO_TO_52 >= ONE
    }

    /// The edges after each of the next [`LANES`] bins, of which each [has a unit](Edges::has_unit) or weighs nothing.
    #[inline]
    pub(crate) fn push_lanes(&mut self, weights: [f32; LANES]) -> [u32; LANES] {
        let mut sums = weights.map(|weight| nearest(f64::from(weight) * self.scale));
        for sum in &mut sums {
            self.sum = self.sum.wrapping_add(*sum);
            *sum = self.sum;
        }
        sums.map(edge_at)
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

/// Bits 20 to 51 of a sum; above them, exponents have piled up.
fn edge_at(sum: u64) -> u32 {
    (sum >> FRACTION_BITS) as u32
}

/// The integer nearest to `x ∈ [0, 2⁵²)` in the low 52 bits, below an exponent to be ignored: added to 2⁵², whose last
/// place is one, `x` stands in the mantissa. Unlike a conversion, it is an instruction that all vector units have.
fn nearest(x: f64) -> u64 {
    (x + TWO_TO_52 as f64).to_bits()
}

const TWO_TO_52: u64 = 1 << 52;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lanes_and_single_bins_agree() {
        let weights = [3.0f32, 0.0, 1.0, 0.5, 0.0, 1e-5, 2.0, 7.0];
        let (mut one, mut many) = (Edges::new(13.50001), Edges::new(13.50001));
        assert!(one.has_unit(1e-5) && !one.has_unit(1e-9));
        let single = weights.map(|w| one.push(f64::from(w)));
        assert_eq!(single, many.push_lanes(weights));
        assert_eq!((single[7], one.raised), (UNITS, 0));
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

    #[test]
    fn the_least_weights_have_a_unit_too() {
        let least = f32::from_bits(1);
        let mut table = Edges::new(f64::from(least) + 1.0);
        assert_eq!(table.push(f64::from(least)), 1);
        let mut alone = Edges::new(8.0 * f64::from(least));
        assert!(alone.has_unit(least));
        assert_eq!(alone.push_lanes([least; 8])[7], UNITS);
    }
}
