//! Host file: building the tables of a lat-long map in slices that the caller owns.

use core::fmt;

use glam::UVec2;

use crate::edges::{Edges, LANES, UNITS};

/// Greatest width and height of a map, in texels: up to here the largest bin of a row always has units to spare for
/// all the others.
pub const MAX_SIZE: u32 = 1 << 15;

/// How many `u32` the tables of a map take.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TableLen {
    /// Edges of the rows: `h + 1`.
    pub marginal: usize,
    /// Edges of the columns of each row, row after row: `h (w + 1)`.
    pub conditional: usize,
}

/// What building a table found in the map.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct BuildReport {
    /// Weights that were NaN, infinite or negative, and were taken as 0.
    pub bad_texels: u32,
    /// Texels and rows of positive weight too small for one unit, and raised to one.
    pub raised: u32,
}

/// What building one row found in it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RowReport {
    /// Sum of the row's weights (bad ones as 0), for [`build_marginal_into`]. It knows nothing of solid angles.
    pub weight_sum: f64,
    /// Weights that were NaN, infinite or negative, and were taken as 0.
    pub bad_texels: u32,
    /// Texels of positive weight too small for one unit, and raised to one.
    pub raised: u32,
}

/// Why no table was built.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BuildError {
    /// Width or height is 0 or above [`MAX_SIZE`].
    Size(UVec2),
    /// The slice for the rows' edges has the wrong length.
    MarginalLen {
        /// The length that it must have.
        expected: usize,
        /// The length that it has.
        found: usize,
    },
    /// The slice for the columns' edges has the wrong length.
    ConditionalLen {
        /// The length that it must have.
        expected: usize,
        /// The length that it has.
        found: usize,
    },
    /// The map, or a row of it, has the wrong number of texels.
    TexelCount {
        /// The number that it must have.
        expected: usize,
        /// The number that it has.
        found: usize,
    },
}

impl fmt::Display for BuildError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Size(size) => write!(
                f,
                "a map of {} x {} texels: both must lie in 1..={MAX_SIZE}",
                size.x, size.y
            ),
            Self::MarginalLen { expected, found } => {
                write!(f, "marginal table of length {found}, expected {expected}")
            }
            Self::ConditionalLen { expected, found } => {
                write!(
                    f,
                    "conditional table of length {found}, expected {expected}"
                )
            }
            Self::TexelCount { expected, found } => {
                write!(f, "{found} texels, expected {expected}")
            }
        }
    }
}

impl core::error::Error for BuildError {}

/// Lengths of the slices that [`build_into`] fills for a map of `w` × `h` texels.
///
/// # Errors
/// [`BuildError::Size`] where `w` or `h` is 0 or above [`MAX_SIZE`].
///
/// ```
/// let len = glimt_envmap_cdf::required_len(8, 4)?;
/// assert_eq!((len.marginal, len.conditional), (5, 36));
/// # Ok::<(), glimt_envmap_cdf::BuildError>(())
/// ```
pub const fn required_len(w: u32, h: u32) -> Result<TableLen, BuildError> {
    if w == 0 || h == 0 || w > MAX_SIZE || h > MAX_SIZE {
        return Err(BuildError::Size(UVec2::new(w, h)));
    }
    let (w, h) = (w as usize, h as usize);
    Ok(TableLen {
        marginal: h + 1,
        conditional: h * (w + 1),
    })
}

/// Weights of a row of RGB or RGBA pixels (`C` of 3 or more; channels beyond the third are ignored): their luminance.
///
/// ```
/// let row = [[1.0, 1.0, 1.0], [0.0, 2.0, 0.0]];
/// let mut weights = glimt_envmap_cdf::luminance_weights(&row);
/// assert!((weights.next().unwrap() - 1.0).abs() < 1e-6);
/// assert!((weights.next().unwrap() - 2.0 * 0.7152).abs() < 1e-6);
/// ```
pub fn luminance_weights<const C: usize>(
    row: &[[f32; C]],
) -> impl ExactSizeIterator<Item = f32> + '_ {
    const { assert!(C >= 3, "a pixel has at least three channels") };
    row.iter()
        .map(|p| glimt_sampling::math::luminance(glam::Vec3::new(p[0], p[1], p[2])))
}

/// Builds the edges of one row's columns from its weights, and returns what [`build_marginal_into`] needs of the row.
///
/// `weights` are those of the row's texels from left to right, `conditional_row` takes one edge more. Rows depend on
/// nothing but their weights, so they can be built in parallel. A weight that is NaN, infinite or negative counts as 0
/// and is reported. A row without a positive weight is black: all its edges are 0.
///
/// # Errors
/// [`BuildError::Size`] where `conditional_row` has fewer than 2 or more than [`MAX_SIZE`]` + 1` entries,
/// [`BuildError::TexelCount`] where the number of weights is not one less.
///
/// ```
/// use glimt_envmap_cdf::{UNITS, build_row_into};
/// let mut edges = [0; 4];
/// let row = build_row_into([1.0, f32::NAN, 3.0], &mut edges)?;
/// assert_eq!(edges, [0, UNITS / 4, UNITS / 4, UNITS]);
/// assert_eq!((row.weight_sum, row.bad_texels), (4.0, 1));
/// # Ok::<(), glimt_envmap_cdf::BuildError>(())
/// ```
pub fn build_row_into(
    weights: impl IntoIterator<IntoIter: ExactSizeIterator<Item = f32>>,
    conditional_row: &mut [u32],
) -> Result<RowReport, BuildError> {
    let width = conditional_row.len().saturating_sub(1);
    if width == 0 || width > MAX_SIZE as usize {
        return Err(BuildError::Size(UVec2::new(width as u32, 1)));
    }
    let weights = weights.into_iter();
    if weights.len() != width {
        return Err(BuildError::TexelCount {
            expected: width,
            found: weights.len(),
        });
    }
    // The weights' bits wait in the row itself until the sum is known.
    let bad_texels = store_weights(weights, &mut conditional_row[1..]);
    let (weight_sum, least) = sum_and_least(&conditional_row[1..]);
    conditional_row[0] = 0;
    let mut raised = 0;
    if weight_sum > 0.0 {
        let mut edges = Edges::new(weight_sum);
        // Most rows have no texel that must be raised, and need not look for any.
        let least = if least > 0.0 {
            least
        } else {
            least_positive(&conditional_row[1..])
        };
        let fast = if edges.has_unit(least) {
            width - width % LANES
        } else {
            0
        };
        let (fast, careful) = conditional_row[1..].split_at_mut(fast);
        for chunk in fast.as_chunks_mut::<LANES>().0 {
            *chunk = edges.push_lanes(chunk.map(f32::from_bits));
        }
        for bin in careful {
            *bin = edges.push(f64::from(f32::from_bits(*bin)));
        }
        raised = edges.finish(conditional_row);
    }
    Ok(RowReport {
        weight_sum,
        bad_texels,
        raised,
    })
}

/// Writes the bits of the weights, bad ones as 0. Returns how many were bad.
fn store_weights(weights: impl Iterator<Item = f32>, bits: &mut [u32]) -> u32 {
    let mut bad = 0;
    for (bits, weight) in bits.iter_mut().zip(weights) {
        // A negative zero becomes a positive one; the bits of positive numbers are in their order, all others beyond.
        let number = (weight + 0.0).to_bits();
        let good = number <= f32::MAX.to_bits();
        *bits = if good { number } else { 0 };
        bad += u32::from(!good);
    }
    bad
}

fn is_weight(x: f32) -> bool {
    // Without a short circuit the loop over a row needs no branch.
    (x >= 0.0) & (x <= f32::MAX)
}

/// A bad weight as 0.
pub(crate) fn weight_or_zero(x: f32) -> f32 {
    if is_weight(x) { x } else { 0.0 }
}

/// Sum of the weights, and the least of them.
fn sum_and_least(bits: &[u32]) -> (f64, f32) {
    let mut sums = [0.0; LANES];
    let mut least = [f32::MAX; LANES];
    let mut add = |lane: usize, weight: f32| {
        sums[lane] += f64::from(weight);
        least[lane] = if weight < least[lane] {
            weight
        } else {
            least[lane]
        };
    };
    let (chunks, rest) = bits.as_chunks::<LANES>();
    for chunk in chunks {
        for (lane, weight) in chunk.map(f32::from_bits).into_iter().enumerate() {
            add(lane, weight);
        }
    }
    for (lane, bits) in rest.iter().enumerate() {
        add(lane, f32::from_bits(*bits));
    }
    (
        sums.iter().sum(),
        least.into_iter().fold(f32::MAX, f32::min),
    )
}

/// The least positive weight of those that have one: the bits of zero, less one, are beyond those of all others.
fn least_positive(bits: &[u32]) -> f32 {
    let before = bits
        .iter()
        .fold(u32::MAX, |least, bits| least.min(bits.wrapping_sub(1)));
    f32::from_bits(before.wrapping_add(1))
}

/// Builds the edges of the rows from the sums of their weights ([`RowReport::weight_sum`], from row 0 at +z), each
/// multiplied here by the exact area of its band of the sphere. Returns how many rows were raised to one unit.
///
/// A map without a positive sum is black: all edges are 0. A sum that is not positive and finite counts as 0.
///
/// # Errors
/// [`BuildError::Size`] where there are no rows or more than [`MAX_SIZE`], [`BuildError::MarginalLen`] where `marginal`
/// is not longer by one than `weight_sums`.
///
/// ```
/// use glimt_envmap_cdf::{UNITS, build_marginal_into};
/// // Three rows of equal sums: their bands hold 1/4, 1/2 and 1/4 of the sphere's area.
/// let mut edges = [0; 4];
/// build_marginal_into(&[5.0; 3], &mut edges)?;
/// assert_eq!(edges, [0, UNITS / 4, UNITS / 4 * 3, UNITS]);
/// # Ok::<(), glimt_envmap_cdf::BuildError>(())
/// ```
pub fn build_marginal_into(weight_sums: &[f64], marginal: &mut [u32]) -> Result<u32, BuildError> {
    let height = weight_sums.len();
    if height == 0 || height > MAX_SIZE as usize {
        return Err(BuildError::Size(UVec2::new(1, height as u32)));
    }
    marginal_from(|row| weight_sums[row], height, marginal)
}

fn marginal_from(
    weight_sum: impl Fn(usize) -> f64,
    height: usize,
    marginal: &mut [u32],
) -> Result<u32, BuildError> {
    if marginal.len() != height + 1 {
        return Err(BuildError::MarginalLen {
            expected: height + 1,
            found: marginal.len(),
        });
    }
    let mass = |row| {
        let sum = weight_sum(row);
        if sum > 0.0 && sum <= f64::MAX {
            sum * band_area(row, height)
        } else {
            0.0
        }
    };
    marginal.fill(0);
    let total: f64 = (0..height).map(mass).sum();
    if !(total > 0.0) {
        return Ok(0);
    }
    let mut edges = Edges::new(total);
    for (row, edge) in marginal[1..].iter_mut().enumerate() {
        *edge = edges.push(mass(row));
    }
    Ok(edges.finish(marginal))
}

/// Share of the sphere's area in a row: `(cos θ₀ − cos θ₁)/2`, as a product so that it keeps its precision at the poles.
pub(crate) fn band_area(row: usize, height: usize) -> f64 {
    let half_row = core::f64::consts::FRAC_PI_2 / height as f64;
    libm::sin((2 * row + 1) as f64 * half_row) * libm::sin(half_row)
}

/// Builds both tables of a map: `weights_of_row(y)` gives the weights of row `y` (row 0 at +z) from left to right.
///
/// `marginal` and `conditional` have the lengths of [`required_len`]; all their entries are written. A weight that is
/// NaN, infinite or negative counts as 0 and is reported. A map without a positive weight is black: its rows' edges
/// are all 0, and [`EnvCdf::sample`](crate::EnvCdf::sample) gives impossible samples. To build in parallel, call
/// [`build_row_into`] on the rows and [`build_marginal_into`] on the result.
///
/// # Errors
/// A [`BuildError`], where a size, the length of a table or the number of weights in a row is wrong; the tables then
/// hold no meaningful entries.
///
/// ```
/// use glam::UVec2;
/// use glimt_envmap_cdf::{EnvCdf, build_into, luminance_weights, required_len};
///
/// let size = UVec2::new(4, 2);
/// let mut pixels = [[0.1_f32; 3]; 8];
/// pixels[2] = [9.0, 8.0, 7.0];
/// let len = required_len(size.x, size.y)?;
/// let (mut marginal, mut conditional) = (vec![0; len.marginal], vec![0; len.conditional]);
/// let report = build_into(
///     size,
///     |y| luminance_weights(&pixels[4 * y as usize..][..4]),
///     &mut marginal,
///     &mut conditional,
/// )?;
/// assert_eq!(report.bad_texels, 0);
/// let env = EnvCdf { size, marginal: &marginal, conditional: &conditional };
/// assert!(env.texel_pdf_sr(UVec2::new(2, 0)) > 70.0 * env.texel_pdf_sr(UVec2::new(1, 0)));
/// # Ok::<(), glimt_envmap_cdf::BuildError>(())
/// ```
pub fn build_into<W: IntoIterator<IntoIter: ExactSizeIterator<Item = f32>>>(
    size: UVec2,
    mut weights_of_row: impl FnMut(u32) -> W,
    marginal: &mut [u32],
    conditional: &mut [u32],
) -> Result<BuildReport, BuildError> {
    let len = required_len(size.x, size.y)?;
    if conditional.len() != len.conditional {
        return Err(BuildError::ConditionalLen {
            expected: len.conditional,
            found: conditional.len(),
        });
    }
    let (width, height) = (size.x as usize, size.y as usize);
    let mut report = BuildReport::default();
    for (y, edges) in (0..).zip(conditional.chunks_exact_mut(width + 1)) {
        let row = build_row_into(weights_of_row(y), edges)?;
        report.bad_texels += row.bad_texels;
        report.raised += row.raised;
        // A row's first and last edge are known (0 and all units, or 0): they hold its f64 sum until the rows are
        // built, which spares the caller a scratch slice.
        let bits = row.weight_sum.to_bits();
        edges[0] = bits as u32;
        edges[width] = (bits >> 32) as u32;
    }
    let weight_sum = |row: usize| {
        let edges = &conditional[row * (width + 1)..];
        f64::from_bits(u64::from(edges[0]) | (u64::from(edges[width]) << 32))
    };
    report.raised += marginal_from(weight_sum, height, marginal)?;
    for row in 0..height {
        let edges = &mut conditional[row * (width + 1)..][..=width];
        let black = edges[0] == 0 && edges[width] == 0;
        edges[0] = 0;
        edges[width] = if black { 0 } else { UNITS };
    }
    Ok(report)
}
