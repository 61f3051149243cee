//! Host file: a row's sums over φ, on any processor.

use glam::Vec4;

use crate::ring_table::{LANES, Layout, RingSums};

/// Groups whose products are summed in f32 before they go to f64: so few that a small texel beside a sun is not lost.
pub(crate) const BLOCK: usize = 32;

/// `K` sums of twelve lanes: whole texels of 3 and of 4 channels.
pub(crate) type Lanes<const K: usize> = [[f64; 12]; K];

/// `P` vectors of a group.
pub(crate) type Group<const P: usize> = [[f32; LANES]; P];

/// A quarter of a row as whole groups.
pub(crate) fn groups<const P: usize>(quarter: &[f32]) -> &[Group<P>] {
    quarter.as_chunks::<LANES>().0.as_chunks::<P>().0
}

/// The four quarters of a row, as far as they fill groups.
pub(crate) fn quarters<const P: usize>(row: &[f32]) -> [&[Group<P>]; 4] {
    let quarter = row.len() / 4;
    let at = |i: usize| groups::<P>(&row[i * quarter..(i + 1) * quarter]);
    [at(0), at(1), at(2), at(3)]
}

/// Calls `sum::<K, T, P>` for the number of vectors in a group and the number of bands.
macro_rules! by_shape {
    ($vectors:expr, $bands:expr, $sum:ident($($arg:expr),*)) => {
        match ($vectors, $bands) {
            (1, ..=2) => $sum::<3, 2, 1>($($arg),*),
            (1, 3) => $sum::<5, 4, 1>($($arg),*),
            (1, 4) => $sum::<7, 6, 1>($($arg),*),
            (1, 5) => $sum::<9, 8, 1>($($arg),*),
            (1, _) => $sum::<11, 10, 1>($($arg),*),
            (_, ..=2) => $sum::<3, 2, 3>($($arg),*),
            (_, 3) => $sum::<5, 4, 3>($($arg),*),
            (_, 4) => $sum::<7, 6, 3>($($arg),*),
            (_, 5) => $sum::<9, 8, 3>($($arg),*),
            _ => $sum::<11, 10, 3>($($arg),*),
        }
    };
}
#[cfg(all(feature = "std", target_arch = "x86_64"))]
pub(crate) use by_shape;

/// The sums of a row's groups. `grouped` is the table's part for them. One band has the sums of two.
pub(crate) fn sum_groups(layout: &Layout, bands: u32, row: &[f32], grouped: &[f32]) -> RingSums {
    let mut out = RingSums::default();
    if layout.groups > 0 {
        by_shape!(layout.vectors, bands, sum(row, grouped, &mut out));
    }
    out
}

/// Adds the lanes of each channel; `P` = 3 vectors hold texels of three channels.
#[inline(always)]
pub(crate) fn add_lanes<const K: usize, const P: usize>(lanes: &Lanes<K>, out: &mut RingSums) {
    for (sums, lanes) in out.sums.iter_mut().zip(lanes) {
        for (c, sum) in sums.iter_mut().enumerate() {
            *sum = match P {
                3 => (lanes[c] + lanes[c + 3]) + (lanes[c + 6] + lanes[c + 9]),
                _ => lanes[c] + lanes[c + 4] + lanes[c + 8],
            };
        }
    }
}

/// Four texels a quarter of a turn apart, `a` first, combined to what their cosines and sines are multiplied by: see
/// [`step`].
#[derive(Clone, Copy)]
struct Turned<T> {
    /// m = 0, 4.
    all: T,
    /// m = 2.
    alternating: T,
    /// m odd: the first and the third.
    along: T,
    /// m odd: the second and the fourth.
    across: T,
}

/// `K` = 2n − 1 sums of `T` = K − 1 factors and 1, in groups of `P` vectors; halves of vectors are what glam has
/// registers for.
fn sum<const K: usize, const T: usize, const P: usize>(
    row: &[f32],
    grouped: &[f32],
    out: &mut RingSums,
) {
    let mut lanes: Lanes<K> = [[0.0; 12]; K];
    let [a, b, c, d] = quarters::<P>(row);
    let table = grouped.as_chunks::<LANES>().0.as_chunks::<T>().0;
    let table = table.as_chunks::<P>().0;
    let blocks = a.chunks(BLOCK).zip(b.chunks(BLOCK)).zip(c.chunks(BLOCK));
    let blocks = blocks.zip(d.chunks(BLOCK)).zip(table.chunks(BLOCK));
    for ((((a, b), c), d), table) in blocks {
        for p in 0..P {
            for half in 0..2 {
                let load =
                    |vector: &[f32; LANES]| Vec4::from_slice(&vector[4 * half..4 * half + 4]);
                let mut sums = [Vec4::ZERO; K];
                for ((((a, b), c), d), table) in a.iter().zip(b).zip(c).zip(d).zip(table) {
                    let (a, b, c, d) = (load(&a[p]), load(&b[p]), load(&c[p]), load(&d[p]));
                    let (even, odd) = (a + c, b + d);
                    let turned = Turned {
                        all: even + odd,
                        alternating: even - odd,
                        along: a - c,
                        across: b - d,
                    };
                    sums[0] += turned.all;
                    let factor = |i: usize| load(&table[p][i]);
                    step::<K, T>(turned, factor, &mut sums);
                }
                let place = (2 * p + half) % 3 * 4;
                for k in 0..K {
                    for i in 0..4 {
                        lanes[k][place + i] += f64::from(sums[k][i]);
                    }
                }
            }
        }
    }
    add_lanes::<K, P>(&lanes, out);
}

/// Adds the products of all m ≥ 1: of the four texels `cos m(φ − qπ/2)` and `sin m(φ − qπ/2)` are cosines and sines of
/// mφ, up to sign and order.
#[inline(always)]
fn step<const K: usize, const T: usize>(
    turned: Turned<Vec4>,
    factor: impl Fn(usize) -> Vec4,
    sums: &mut [Vec4; K],
) {
    let Turned {
        all,
        alternating,
        along,
        across,
    } = turned;
    // m = 1
    let (cos, sin) = (factor(0), factor(1));
    sums[1] += along * cos + across * sin;
    sums[2] += along * sin - across * cos;
    if T > 2 {
        let (cos, sin) = (factor(2), factor(3));
        sums[3] += alternating * cos;
        sums[4] += alternating * sin;
    }
    if T > 4 {
        let (cos, sin) = (factor(4), factor(5));
        sums[5] += along * cos - across * sin;
        sums[6] += along * sin + across * cos;
    }
    if T > 6 {
        let (cos, sin) = (factor(6), factor(7));
        sums[7] += all * cos;
        sums[8] += all * sin;
    }
    if T > 8 {
        let (cos, sin) = (factor(8), factor(9));
        sums[9] += along * cos + across * sin;
        sums[10] += along * sin - across * cos;
    }
}

/// Adds the columns that fill no group.
pub(crate) fn add_tail(
    layout: &Layout,
    bands: u32,
    row: &[f32],
    tail: &[f32],
    mut out: RingSums,
) -> RingSums {
    out.bands = bands;
    if bands == 1 {
        out.sums[1..].fill([0.0; 3]);
    }
    let first = layout.columns - layout.tail;
    let quarter = layout.columns * layout.channels;
    for (i, factors) in tail.chunks_exact(layout.factors).enumerate() {
        let texel = (first + i) * layout.channels;
        for channel in 0..3 {
            let at = |q: usize| f64::from(row[texel + channel + q * quarter]);
            let a = at(0);
            let turned = if layout.folded {
                let (b, c, d) = (at(1), at(2), at(3));
                Turned {
                    all: (a + c) + (b + d),
                    alternating: (a + c) - (b + d),
                    along: a - c,
                    across: b - d,
                }
            } else {
                Turned {
                    all: a,
                    alternating: a,
                    along: a,
                    across: 0.0,
                }
            };
            out.sums[0][channel] += turned.all;
            for m in 1..bands as usize {
                let (cos, sin) = (factors[2 * m - 2].into(), factors[2 * m - 1].into());
                let (for_cos, for_sin) = match m {
                    2 => (turned.alternating * cos, turned.alternating * sin),
                    4 => (turned.all * cos, turned.all * sin),
                    3 => cross(turned.along, -turned.across, cos, sin),
                    _ => cross(turned.along, turned.across, cos, sin),
                };
                out.sums[2 * m - 1][channel] += for_cos;
                out.sums[2 * m][channel] += for_sin;
            }
        }
    }
    out
}

fn cross(along: f64, across: f64, cos: f64, sin: f64) -> (f64, f64) {
    (along * cos + across * sin, along * sin - across * cos)
}
