//! Host file: a light map's cells, summed up in slices that the caller owns.

use core::f64::consts::{FRAC_PI_2, PI};
use core::fmt;

use glam::{DVec3, UVec2, Vec3, Vec4};
use glimt_envmap_cdf::{BuildError as TableError, MAX_SIZE, build_row_into};
use glimt_sampling::luminance;

use crate::partition::{
    CELLS, COLUMN_UNITS, COLUMNS, ROWS, column_words, field, first_column, first_column_word,
    first_row_word, table_words,
};

/// Points of each edge of a cell that its radius is measured at, and what may lie beyond them, in radians.
const EDGE_POINTS: usize = 9;
const BEYOND_POINTS: f64 = 2e-3;

/// The most texel rows of a row of cells: those at the poles have 16 % of the map's.
const MOST_ROWS: usize = MAX_SIZE as usize / 6;

/// A number whose neighbours are one apart: the bits of a sum with it, less its own, are the other number, if that is whole.
const LOW_BITS: f32 = 8_388_608.0;

/// Sums that are added up side by side.
const LANES: usize = 8;

/// The most texel columns of a column of cells.
const MOST_COLUMNS: usize = (MAX_SIZE / COLUMNS) as usize;

/// Why no table was built.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum BuildError {
    /// Width or height is 0 or above [`MAX_SIZE`].
    Size(UVec2),
    /// A slice of words, or a row of texels, has the wrong length.
    Len {
        /// The length that it must have.
        expected: usize,
        /// The length that it has.
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
            Self::Len { expected, found } => write!(f, "length {found}, expected {expected}"),
        }
    }
}

impl core::error::Error for BuildError {}

/// What one row of cells adds up to: see [`build_band`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BandSums {
    /// A cell's numbers, by their [`field`]s.
    cells: [[f32; field::COUNT as usize]; COLUMNS as usize],
}

/// The words of one row of cells that [`build_band`] fills.
#[derive(Debug)]
pub struct BandWords<'a> {
    /// Edges of the texel rows of its cells.
    rows: &'a mut [u32],
    /// Edges of the texel columns of its texel rows.
    columns: &'a mut [u32],
}

/// How many words the table of a map of `size` texels takes.
///
/// # Errors
/// [`BuildError::Size`].
pub fn required_words(size: UVec2) -> Result<usize, BuildError> {
    match size.min_element() == 0 || size.max_element() > MAX_SIZE {
        true => Err(BuildError::Size(size)),
        false => Ok(table_words(size) as usize),
    }
}

/// The first row of texels of row `row` of cells: equal steps in cos θ. Of the one behind the last, the map's height.
#[must_use]
pub fn first_row(row: u32, height: u32) -> u32 {
    let cos = 1.0 - 2.0 * f64::from(row.min(ROWS)) / f64::from(ROWS);
    // To the nearest; there is no `round` without std.
    (f64::from(height) * libm::acos(cos) / PI + 0.5) as u32
}

/// Parts a table's words into those of each row of cells, from +z down, and the words before them, which [`store_sums`] fills.
///
/// # Errors
/// A [`BuildError`] of the size and of the number of words.
pub fn split_bands(
    size: UVec2,
    words: &mut [u32],
) -> Result<(&mut [u32], [BandWords<'_>; ROWS as usize]), BuildError> {
    let expected = required_words(size)?;
    if words.len() != expected {
        let found = words.len();
        return Err(BuildError::Len { expected, found });
    }
    let (head, rest) = words.split_at_mut(first_row_word() as usize);
    let (mut rows, mut columns) =
        rest.split_at_mut((first_column_word(size) - first_row_word()) as usize);
    let bands = core::array::from_fn(|row| {
        let row = row as u32;
        let height = (first_row(row + 1, size.y) - first_row(row, size.y)) as usize;
        let (own_rows, other_rows) =
            core::mem::take(&mut rows).split_at_mut(COLUMNS as usize * (height + 1));
        let (own_columns, other_columns) =
            core::mem::take(&mut columns).split_at_mut(height * column_words(size.x) as usize);
        (rows, columns) = (other_rows, other_columns);
        BandWords {
            rows: own_rows,
            columns: own_columns,
        }
    });
    Ok((head, bands))
}

/// Sums up row `row` of cells, and fills its words. `texels_of_row` gives a row of texels, linear RGB, their w ignored, each at
/// least 0 and finite; it is called once for each.
///
/// # Errors
/// [`BuildError::Len`] for a row of texels of the wrong length.
pub fn build_band<'t>(
    size: UVec2,
    row: u32,
    mut texels_of_row: impl FnMut(u32) -> &'t [Vec4],
    words: BandWords<'_>,
) -> Result<BandSums, BuildError> {
    let (top, bottom) = (first_row(row, size.y), first_row(row + 1, size.y));
    let mut cells = [Sums::default(); COLUMNS as usize];
    let turns = Turns::new(size.x);
    let mut weights = [0.0_f32; MOST_COLUMNS];
    let height = (bottom - top) as usize;
    let BandWords { rows, columns } = words;
    // The fluxes of a cell's texel rows wait in the words of its edges.
    for y in top..bottom {
        let texels = texels_of_row(y);
        if texels.len() != size.x as usize {
            return Err(BuildError::Len {
                expected: size.x as usize,
                found: texels.len(),
            });
        }
        let ring = Ring::new(y, size);
        let line = (y - top) as usize;
        let edges = &mut columns[line * column_words(size.x) as usize..];
        let edges = &mut edges[..column_words(size.x) as usize];
        edges.fill(0);
        for (column, cell) in (0..).zip(&mut cells) {
            let left = first_column(column, size.x);
            let own = &texels[left as usize..first_column(column + 1, size.x) as usize];
            let column = column as usize;
            let weights = &mut weights[..own.len()];
            for (weight, texel) in weights.iter_mut().zip(own) {
                *weight = luminance(texel.truncate());
            }
            let flux = cell.add(own, weights, &ring, &turns, column);
            rows[column * (height + 1) + 1 + line] = flux.to_bits();
            column_edges(weights, left, edges);
        }
    }
    for column in 0..COLUMNS as usize {
        let own = &mut rows[column * (height + 1)..][..=height];
        row_edges(own)?;
    }
    let mut numbers = [[0.0; field::COUNT as usize]; COLUMNS as usize];
    for (column, (numbers, cell)) in (0..).zip(numbers.iter_mut().zip(&cells)) {
        let columns = [column, column + 1].map(|c| first_column(c, size.x));
        *numbers = cell.finish(columns, [top, bottom], size);
    }
    Ok(BandSums { cells: numbers })
}

/// Stores the sums of row `row` of cells in the words before those of the bands.
pub fn store_sums(size: UVec2, row: u32, sums: &BandSums, head: &mut [u32]) {
    head[row as usize] = first_row(row, size.y);
    head[row as usize + 1] = first_row(row + 1, size.y);
    let fields = head.len() - (field::COUNT * CELLS) as usize;
    for (column, numbers) in (0..).zip(&sums.cells) {
        let cell = row * COLUMNS + column;
        for (list, number) in (0..).zip(numbers) {
            head[fields + (list * CELLS + cell) as usize] = number.to_bits();
        }
    }
}

/// Builds the table of a map, on this thread. To build in parallel, call [`build_band`] on the parts of [`split_bands`].
///
/// # Errors
/// A [`BuildError`].
///
/// ```
/// use glam::{UVec2, Vec4};
/// use glimt_light_cells::{LightCells, build_into, field, required_words};
///
/// let size = UVec2::new(64, 32);
/// let map = [[Vec4::ONE; 64]; 32];
/// let mut words = [0; 20_000];
/// let words = &mut words[..required_words(size)?];
/// build_into(size, |y| &map[y as usize], words)?;
/// let cells = LightCells { size, words, start: 0 };
/// // All the light of a white sphere.
/// let flux: f32 = (0..512).map(|cell| cells.value(field::FLUX, cell)).sum();
/// assert!((flux / (4.0 * core::f32::consts::PI) - 1.0).abs() < 1e-5);
/// # Ok::<(), glimt_light_cells::BuildError>(())
/// ```
pub fn build_into<'t>(
    size: UVec2,
    mut texels_of_row: impl FnMut(u32) -> &'t [Vec4],
    words: &mut [u32],
) -> Result<(), BuildError> {
    let (head, bands) = split_bands(size, words)?;
    for (row, band) in (0..).zip(bands) {
        let sums = build_band(size, row, &mut texels_of_row, band)?;
        store_sums(size, row, &sums, head);
    }
    Ok(())
}

/// A row of texels: the exact means of directions over its texels.
struct Ring {
    /// Solid angle of a texel.
    area: f64,
    /// Mean of cos θ.
    z: f64,
    /// Mean of sin θ, times the mean of cos(φ − φ₀) over a texel.
    horizontal: f64,
}

/// Cosines and sines of φ along a row of texels.
struct Turns {
    /// At the centre of each cell's first texel.
    first: [[f32; 2]; COLUMNS as usize],
    /// Of a step to the next texel, and of four steps.
    step: [f32; 2],
    four_steps: [f32; 2],
}

impl Turns {
    fn new(width: u32) -> Turns {
        let cos_sin = |angle: f64| [libm::cos(angle) as f32, libm::sin(angle) as f32];
        let turn = 2.0 * PI / f64::from(width);
        let first =
            |column: usize| PI - turn * (0.5 + f64::from(first_column(column as u32, width)));
        Turns {
            first: core::array::from_fn(|column| cos_sin(first(column))),
            step: cos_sin(-turn),
            four_steps: cos_sin(-4.0 * turn),
        }
    }
}

impl Turns {
    /// Cosines and sines at the first four texels of a column of cells.
    fn first_four(&self, column: usize) -> (Vec4, Vec4) {
        let mut turn = self.first[column];
        let mut both = [[0.0; 4]; 2];
        for lane in 0..4 {
            [both[0][lane], both[1][lane]] = turn;
            turn = turned(turn, self.step);
        }
        (both[0].into(), both[1].into())
    }
}

impl Ring {
    fn new(y: u32, size: UVec2) -> Ring {
        let (width, height) = (f64::from(size.x), f64::from(size.y));
        let edge = |y: u32| PI * f64::from(y) / height;
        let (upper, lower) = (edge(y), edge(y + 1));
        let half = FRAC_PI_2 / height;
        let middle = (f64::from(y) + 0.5) * PI / height;
        // ∫ sin θ dθ = 2 sin θ_m sin δ, ∫ sin θ cos θ dθ = sin θ_m cos θ_m sin 2δ …
        let sine = 2.0 * libm::sin(middle) * libm::sin(half);
        let polar =
            0.5 * (libm::sin(lower) + libm::sin(upper)) * (libm::sin(lower) - libm::sin(upper));
        // ∫ sin² θ dθ = δ − cos 2θ_m sin 2δ / 2, δ half of the row.
        let level = half - 0.5 * libm::cos(2.0 * middle) * libm::sin(2.0 * half);
        let turn = PI / width;
        let across = libm::sin(turn) / turn;
        Ring {
            area: 2.0 * turn * sine,
            z: polar / sine,
            horizontal: level / sine * across,
        }
    }
}

/// A cell in the making.
#[derive(Clone, Copy, Default)]
struct Sums {
    flux: f64,
    square: f64,
    radiance: DVec3,
    /// Sums of L ω: of its x, y and z.
    moments: [DVec3; 3],
}

/// A cosine and a sine, after a turn by another angle's.
#[inline]
fn turned([cos, sin]: [f32; 2], by: [f32; 2]) -> [f32; 2] {
    [cos * by[0] - sin * by[1], sin * by[0] + cos * by[1]]
}

impl Sums {
    /// Adds the cell's part of a row of texels, whose luminances are `weights`, from the first of column `column` of cells on. Returns
    /// its flux in luminance.
    fn add(
        &mut self,
        texels: &[Vec4],
        weights: &[f32],
        ring: &Ring,
        turns: &Turns,
        column: usize,
    ) -> f32 {
        // Within a row f32 will do: a cell's row has a few hundred texels at most.
        // Of even and of odd texels, as one sum would wait for itself.
        let (mut sum, mut x, mut y) = ([Vec4::ZERO; 2], [Vec4::ZERO; 2], [Vec4::ZERO; 2]);
        let mut square = 0.0;
        let mut add = |lane: usize, texel: Vec4, own: f32, cos: Vec4, sin: Vec4| {
            let texel = texel.truncate().extend(own);
            sum[lane % 2] += texel;
            x[lane % 2] += texel * cos[lane];
            y[lane % 2] += texel * sin[lane];
        };
        // Four angles turn side by side, as each waits for its own multiplication.
        let (mut cos, mut sin) = turns.first_four(column);
        let [step_cos, step_sin] = turns.four_steps;
        let (chunks, last_texels) = texels.as_chunks::<4>();
        let (weight_chunks, last_weights) = weights.as_chunks::<4>();
        for (texels, weights) in chunks.iter().zip(weight_chunks) {
            let own = Vec4::from_array(*weights);
            square += own.length_squared();
            for lane in 0..4 {
                add(lane, texels[lane], weights[lane], cos, sin);
            }
            (cos, sin) = (
                cos * step_cos - sin * step_sin,
                sin * step_cos + cos * step_sin,
            );
        }
        for (lane, (texel, own)) in last_texels.iter().zip(last_weights).enumerate() {
            square += own * own;
            add(lane, *texel, *own, cos, sin);
        }
        let (sum, x, y) = (sum[0] + sum[1], x[0] + x[1], y[0] + y[1]);
        let flux = f64::from(sum.w) * ring.area;
        self.flux += flux;
        self.square += f64::from(square) * ring.area;
        self.radiance += sum.truncate().as_dvec3() * ring.area;
        let level = ring.area * ring.horizontal;
        self.moments[0] += x.truncate().as_dvec3() * level;
        self.moments[1] += y.truncate().as_dvec3() * level;
        self.moments[2] += sum.truncate().as_dvec3() * (ring.area * ring.z);
        flux as f32
    }

    /// The cell's numbers, by their fields.
    fn finish(
        &self,
        columns: [u32; 2],
        rows: [u32; 2],
        size: UVec2,
    ) -> [f32; field::COUNT as usize] {
        let towards: DVec3 = self.moments.map(|m| m.element_sum()).into();
        let outline = Outline {
            columns,
            rows,
            size,
        };
        let mean = towards.try_normalize();
        let direction = mean.unwrap_or_else(|| outline.middle()).as_vec3();
        let radius = outline.radius(direction);
        let mut numbers = [0.0; field::COUNT as usize];
        let mut put = |list: u32, values: &[f64]| {
            for (at, value) in (list as usize..).zip(values) {
                numbers[at] = *value as f32;
            }
        };
        put(field::FLUX, &[self.flux]);
        put(field::RADIANCE, &self.radiance.to_array());
        let [x, y, z] = self.moments;
        for (channel, list) in (field::MOMENT..).step_by(3).take(3).enumerate() {
            put(list, &[x[channel], y[channel], z[channel]]);
        }
        put(field::SQUARE, &[self.square]);
        put(field::SOLID_ANGLE, &[outline.solid_angle()]);
        put(field::DIRECTION, &direction.as_dvec3().to_array());
        put(field::RADIUS, &[radius]);
        let length = towards.length() / self.radiance.element_sum();
        // Of a black cell the length is not a number, which `max` makes 0.
        let spread = libm::sqrt(6.0 * (1.0 - length).max(0.0)).min(radius);
        put(field::SPREAD, &[spread]);
        numbers
    }
}

/// The place between two columns or rows of `n`, as a share of all.
fn mix([a, b]: [u32; 2], t: f64, n: u32) -> f64 {
    (f64::from(a) * (1.0 - t) + f64::from(b) * t) / f64::from(n)
}

/// The direction of a place across and down.
fn towards([cos_phi, sin_phi]: [f64; 2], [cos, sin]: [f64; 2]) -> DVec3 {
    DVec3::new(sin * cos_phi, sin * sin_phi, cos)
}

/// Where a cell lies.
struct Outline {
    columns: [u32; 2],
    rows: [u32; 2],
    size: UVec2,
}

impl Outline {
    /// Cosine and sine of φ at a place across it, from 0 to 1.
    fn across(&self, place: f64) -> [f64; 2] {
        let phi = PI - 2.0 * PI * mix(self.columns, place, self.size.x);
        [libm::cos(phi), libm::sin(phi)]
    }

    /// Cosine and sine of θ at a place down it, from 0 to 1.
    fn down(&self, place: f64) -> [f64; 2] {
        let theta = PI * mix(self.rows, place, self.size.y);
        [libm::cos(theta), libm::sin(theta)]
    }

    fn middle(&self) -> DVec3 {
        towards(self.across(0.5), self.down(0.5))
    }

    fn solid_angle(&self) -> f64 {
        let cos = self
            .rows
            .map(|y| libm::cos(PI * f64::from(y) / f64::from(self.size.y)));
        let columns = f64::from(self.columns[1] - self.columns[0]);
        2.0 * PI * columns / f64::from(self.size.x) * (cos[0] - cos[1])
    }

    /// The largest angle from a direction to its points, or a little more; 0 where it has none.
    fn radius(&self, direction: Vec3) -> f64 {
        if self.columns[0] == self.columns[1] || self.rows[0] == self.rows[1] {
            return 0.0;
        }
        let from = direction.as_dvec3();
        // A cell may span more than half of the sphere: points inside it count, too.
        let place = |k: usize| k as f64 / (EDGE_POINTS - 1) as f64;
        let across: [[f64; 2]; EDGE_POINTS] = core::array::from_fn(|k| self.across(place(k)));
        let mut farthest = from;
        for down in (0..EDGE_POINTS).map(|k| self.down(place(k))) {
            for across in across {
                let own = towards(across, down);
                if from.dot(own) < from.dot(farthest) {
                    farthest = own;
                }
            }
        }
        let largest = libm::atan2(from.cross(farthest).length(), from.dot(farthest));
        let extent = f64::from(self.columns[1] - self.columns[0]) / f64::from(self.size.x);
        // Of small cells the points miss less than the constant; a map of few texels has wide ones.
        let coarse = if extent > 2.0 / f64::from(COLUMNS) {
            PI
        } else {
            0.0
        };
        (largest + BEYOND_POINTS + coarse).min(PI)
    }
}

/// Turns the fluxes that wait behind the first of a cell's words into edges of its rows; all 0 in a cell without light.
fn row_edges(edges: &mut [u32]) -> Result<(), BuildError> {
    let count = edges.len() - 1;
    edges[0] = 0;
    if count == 0 {
        return Ok(());
    }
    if count > MOST_ROWS {
        return Err(BuildError::Len {
            expected: MOST_ROWS,
            found: count,
        });
    }
    // They are read while the edges are written, so they step aside.
    let mut waiting = [0.0_f32; MOST_ROWS];
    for (weight, bits) in waiting.iter_mut().zip(&edges[1..]) {
        *weight = f32::from_bits(*bits);
    }
    let built = build_row_into(waiting[..count].iter().copied(), edges);
    built.map(drop).map_err(|error| match error {
        TableError::TexelCount { expected, found } => BuildError::Len { expected, found },
        _ => BuildError::Size(UVec2::new(1, count as u32)),
    })
}

/// Writes the edges of a cell's texels in one row, of these luminances, from column `left` on, into the row's words, which are 0.
///
/// Each texel with light has a unit of its own; the others are shared out by luminance, what rounding leaves to the last. So no texel is
/// lost, and the density is that of the luminance mixed with an even one, of a thousandth for 32 texels.
fn column_edges(weights: &[f32], left: u32, words: &mut [u32]) {
    // In lanes, as one sum would wait for itself.
    let (mut sums, mut counts) = ([0.0_f32; LANES], [0_u32; LANES]);
    let (chunks, rest) = weights.as_chunks::<LANES>();
    for chunk in chunks {
        for (lane, own) in chunk.iter().enumerate() {
            sums[lane] += own;
            counts[lane] += u32::from(*own > 0.0);
        }
    }
    for (lane, own) in rest.iter().enumerate() {
        sums[lane] += own;
        counts[lane] += u32::from(*own > 0.0);
    }
    let (total, lights) = (sums.iter().sum::<f32>(), counts.iter().sum::<u32>());
    let Some(last) = weights.iter().rposition(|own| *own > 0.0) else {
        return;
    };
    let shared = COLUMN_UNITS - lights;
    // Of a sum near the smallest number, a quotient would be infinite.
    let scale = (shared as f32 / total).min(f32::MAX);
    let mut edges = [0_u32; MOST_COLUMNS];
    for (edge, own) in edges.iter_mut().zip(weights) {
        // Whole units, or one fewer. What is added moves them to the lowest bits, which no conversion does on many at once.
        let units = (own * scale - 0.5).max(0.0) + LOW_BITS;
        *edge = (units.to_bits() - LOW_BITS.to_bits()) + u32::from(*own > 0.0);
    }
    let mut sum = 0;
    for edge in &mut edges[..last] {
        sum += *edge;
        *edge = sum;
    }
    edges[last..weights.len()].fill(COLUMN_UNITS);
    let (mut edges, mut left) = (&edges[..weights.len()], left);
    if left % 2 == 1 {
        words[(left / 2) as usize] |= edges[0] << 16;
        (edges, left) = (&edges[1..], left + 1);
    }
    let (pairs, rest) = edges.as_chunks::<2>();
    let words = &mut words[(left / 2) as usize..];
    for (word, pair) in words.iter_mut().zip(pairs) {
        *word = pair[0] | pair[1] << 16;
    }
    if let [edge] = rest {
        words[pairs.len()] = *edge;
    }
}
