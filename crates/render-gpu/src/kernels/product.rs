//! Shared file: samples of the light in proportion to its product with the reflection, by cells of the light map, combined with
//! samples of the BRDF.

use glam::{UVec2, UVec3, Vec3};
use glimt_brdf::BlinnPhong;
use glimt_envmap_cdf::{Bin, find_bin};
use glimt_probe::latlong::{direction_in_texel, texel_solid_angle_sr};
use glimt_probe::rotate::rotate_z;
use glimt_sampling::hash::hash2;
use glimt_sampling::math::luminance;
use glimt_sampling::mis::multi_sample_density;
use glimt_sampling::uniform::{unit_f32, unit_vec2};

use super::environment::{Environment, cdf_words, marginal_words};
use super::estimator::{Estimator, LightSample, Reflected};
use super::pattern::{BRDF, ENVIRONMENT, LIT_THROUGH, PixelPattern};
use super::scene::{Scene, ShadingPoint};

/// Columns of cells.
pub const COLUMNS: u32 = 32;
/// Rows of cells, equal steps in cos θ, each of whole rows of texels.
pub const ROWS: u32 = 16;
/// Cells of a map.
pub const CELLS: u32 = COLUMNS * ROWS;
/// Words of a cell: its mean direction in the map's coordinates, its flux `∫ Y(L) dω` in luminance, and the largest angle from that
/// direction to its edge, in radians.
pub const CELL_WORDS: u32 = 5;

/// Where the cells' table begins among a light's tables: the first of the texel rows at which rows of cells begin, one more than there
/// are. The cells follow, row by row, then for each of them the edges of its texel rows.
#[inline]
#[must_use]
pub fn first_word(size: UVec2) -> u32 {
    cdf_words(size)
}

/// Words of the cells' table of a map of this size.
#[inline]
#[must_use]
pub fn words(size: UVec2) -> u32 {
    ROWS + 1 + CELLS * CELL_WORDS + COLUMNS * (size.y + ROWS)
}

/// The first column of texels of column `column` of cells; of the one behind the last, the map's width.
#[inline]
#[must_use]
pub fn first_column(column: u32, width: u32) -> u32 {
    column * width / COLUMNS
}

/// Where the edges of a cell's texel rows begin, from the table's first word on: one more than it has rows, in units of 2⁻³¹, from 0
/// to 2³¹; all 0 in a black cell. `first_row` is its first row of texels.
#[inline]
#[must_use]
pub fn first_edge(column: u32, row: u32, first_row: u32, height: u32) -> u32 {
    ROWS + 1 + CELLS * CELL_WORDS + column * (height + ROWS) + first_row + row
}

/// `L̂ = Σ L(ω) ρ(ωo, ω) V(ω) ⟨ω·n⟩ / (N_ρ q_ρ(ω) + N_P q_P(ω))` over N_ρ ≥ 1 samples of the BRDF and N_P of the product: the balance
/// heuristic of Veach and Guibas 1995.
///
/// q_P draws a cell j in proportion to `w_j = Φ_j Y(ρ'(ωo, d_j)) c_j`, Φ_j its flux, d_j its mean direction, ρ' the BRDF with a lobe
/// as wide as the cell shows it, c_j the cosine; then a texel of the cell in proportion to its luminance and solid angle, then a
/// direction uniformly in the texel. A cell that the horizon cuts counts with a quarter of the highest cosine in it at least. Where
/// w_j is 0 the BRDF's samples alone find the light. 8 bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, bytemuck::NoUninit)]
#[repr(C)]
pub struct Product {
    /// N_ρ.
    pub brdf_samples: u32,
    /// N_P.
    pub env_samples: u32,
}

/// What a cell's weight needs of a shading point: its frame in the map's coordinates, and its reflection in luminance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CellLobe {
    tangent: Vec3,
    bitangent: Vec3,
    normal: Vec3,
    wo: Vec3,
    diffuse: f32,
    specular: f32,
    exponent: f32,
}

impl CellLobe {
    /// That of a shading point.
    #[inline]
    #[must_use]
    pub fn new(point: &ShadingPoint, env: Environment<'_>) -> CellLobe {
        CellLobe {
            tangent: env.to_map(point.frame.t),
            bitangent: env.to_map(point.frame.b),
            normal: env.to_map(point.frame.n),
            wo: point.wo,
            diffuse: luminance(point.brdf.diffuse),
            specular: luminance(point.brdf.specular),
            exponent: point.brdf.exponent,
        }
    }

    /// w_j of cell `cell`: 0 where it is black or below the horizon.
    #[inline]
    #[must_use]
    pub fn weight(&self, cell: u32, env: Environment<'_>) -> f32 {
        let at = (first_word(env.size) + ROWS + 1 + cell * CELL_WORDS) as usize;
        let flux = f32::from_bits(env.tables[at + 3]);
        if !(flux > 0.0) {
            return 0.0;
        }
        let d = Vec3::new(
            f32::from_bits(env.tables[at]),
            f32::from_bits(env.tables[at + 1]),
            f32::from_bits(env.tables[at + 2]),
        );
        let radius = f32::from_bits(env.tables[at + 4]);
        let z = self.normal.dot(d);
        let cosine = z.max(0.25 * (z + radius));
        if !(cosine > 0.0) {
            return 0.0;
        }
        let wi = Vec3::new(self.tangent.dot(d), self.bitangent.dot(d), cosine).normalize();
        let widened = BlinnPhong {
            diffuse: Vec3::splat(self.diffuse),
            specular: Vec3::splat(self.specular),
            exponent: 4.0 / (4.0 / self.exponent.max(1e-3) + 0.7 * radius * radius),
        };
        flux * (widened.eval(self.wo, wi).x * cosine)
    }
}

/// A texel with the probability by which it was drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TexelDraw {
    /// Column and row.
    pub texel: UVec2,
    /// Its probability within the cell.
    pub pmf: f32,
}

/// Texel rows `first .. end` of row `row` of cells.
#[inline]
fn texel_rows(row: u32, env: Environment<'_>) -> UVec2 {
    let at = (first_word(env.size) + row) as usize;
    UVec2::new(env.tables[at], env.tables[at + 1])
}

/// Texel columns `first .. end` of column `column` of cells.
#[inline]
fn texel_columns(column: u32, width: u32) -> UVec2 {
    UVec2::new(first_column(column, width), first_column(column + 1, width))
}

/// The cell that a texel belongs to.
#[inline]
#[must_use]
pub fn cell_of(texel: UVec2, env: Environment<'_>) -> u32 {
    let start = first_word(env.size) as usize;
    let row = find_bin(env.tables, start, ROWS as usize, texel.y).index;
    let column = (COLUMNS * (texel.x + 1) - 1) / env.size.x;
    row * COLUMNS + column
}

/// The upper 32 bits of `a · b`.
#[inline]
#[must_use]
pub fn multiply_high(a: u32, b: u32) -> u32 {
    let (a_high, a_low) = (a >> 16, a & 0xffff);
    let (b_high, b_low) = (b >> 16, b & 0xffff);
    let middle = a_high * b_low + ((a_low * b_low) >> 16);
    let other = a_low * b_high + (middle & 0xffff);
    a_high * b_high + (middle >> 16) + (other >> 16)
}

/// Column `column`'s bin in the table of texel row `y`, and the units of all of the cell's columns `columns.x .. columns.y` there.
#[inline]
fn column_units(y: u32, columns: UVec2, env: Environment<'_>) -> UVec2 {
    let start = (marginal_words(env.size) + y * (env.size.x + 1)) as usize;
    let low = env.tables[start + columns.x as usize];
    UVec2::new(low, env.tables[start + columns.y as usize] - low)
}

/// Draws a texel of a cell that is not black, in proportion to its luminance and solid angle.
#[inline]
#[must_use]
pub fn sample_in_cell(cell: u32, u: UVec2, env: Environment<'_>) -> TexelDraw {
    let (column, row) = (cell % COLUMNS, cell / COLUMNS);
    let rows = texel_rows(row, env);
    let edges = first_word(env.size) + first_edge(column, row, rows.x, env.size.y);
    let of_row = find_bin(
        env.tables,
        edges as usize,
        (rows.y - rows.x) as usize,
        u.y >> 1,
    );
    let y = rows.x + of_row.index;
    let columns = texel_columns(column, env.size.x);
    let units = column_units(y, columns, env);
    let start = marginal_words(env.size) + y * (env.size.x + 1) + columns.x;
    let within = units.x + multiply_high(u.x, units.y);
    let of_column = find_bin(
        env.tables,
        start as usize,
        (columns.y - columns.x) as usize,
        within,
    );
    TexelDraw {
        texel: UVec2::new(columns.x + of_column.index, y),
        pmf: pmf(of_row, of_column, units.y),
    }
}

/// Probability of a texel of a cell by [`sample_in_cell`]; 0 for a black one.
#[inline]
#[must_use]
pub fn pmf_in_cell(texel: UVec2, cell: u32, env: Environment<'_>) -> f32 {
    let (column, row) = (cell % COLUMNS, cell / COLUMNS);
    let rows = texel_rows(row, env);
    let edges = (first_word(env.size) + first_edge(column, row, rows.x, env.size.y)) as usize;
    let at = edges + (texel.y - rows.x) as usize;
    let of_row = Bin {
        index: 0,
        first: 0,
        units: env.tables[at + 1] - env.tables[at],
    };
    let columns = texel_columns(column, env.size.x);
    let units = column_units(texel.y, columns, env);
    let start = (marginal_words(env.size) + texel.y * (env.size.x + 1) + texel.x) as usize;
    let of_column = Bin {
        index: 0,
        first: 0,
        units: env.tables[start + 1] - env.tables[start],
    };
    pmf(of_row, of_column, units.y)
}

/// `row/2³¹ · column/all`; 0 where there is nothing in the row.
#[inline]
fn pmf(row: Bin, column: Bin, all: u32) -> f32 {
    if all == 0 {
        return 0.0;
    }
    row.units as f32 * (1.0 / 2_147_483_648.0) * (column.units as f32 / all as f32)
}

impl Product {
    /// Σ w_j over all cells.
    #[inline]
    #[must_use]
    pub fn total(&self, lobe: &CellLobe, env: Environment<'_>) -> f32 {
        let mut total = 0.0;
        for cell in 0..CELLS {
            total += lobe.weight(cell, env);
        }
        total
    }

    /// Density of the product's strategy at a texel, in 1/sr, where all weights sum to `total`.
    #[inline]
    #[must_use]
    pub fn pdf_sr(&self, texel: UVec2, total: f32, lobe: &CellLobe, env: Environment<'_>) -> f32 {
        if !(total > 0.0) {
            return 0.0;
        }
        let cell = cell_of(texel, env);
        let pmf = lobe.weight(cell, env) / total * pmf_in_cell(texel, cell, env);
        pmf / texel_solid_angle_sr(texel.y, env.size)
    }

    /// Draws a texel for the product, where all weights sum to `total` above 0: the cell by `u.z`, the texel in it by the others.
    #[inline]
    #[must_use]
    pub fn sample(&self, u: UVec3, total: f32, lobe: &CellLobe, env: Environment<'_>) -> TexelDraw {
        let target = unit_f32(u.z) * total;
        let mut sum = 0.0;
        let mut cell = 0;
        let mut weight = 0.0;
        let mut next = 0;
        // Rounding may leave the target beyond the last sum: then the last cell of positive weight stands.
        while next < CELLS && !(sum > target) {
            let own = lobe.weight(next, env);
            if own > 0.0 {
                cell = next;
                weight = own;
                sum += own;
            }
            next += 1;
        }
        let drawn = sample_in_cell(cell, UVec2::new(u.x, u.y), env);
        TexelDraw {
            texel: drawn.texel,
            pmf: drawn.pmf * (weight / total),
        }
    }

    #[inline]
    fn density(&self, brdf_pdf_sr: f32, product_pdf_sr: f32) -> f32 {
        multi_sample_density(
            self.brdf_samples,
            brdf_pdf_sr,
            self.env_samples,
            product_pdf_sr,
        )
    }

    #[inline]
    fn brdf_sample(
        &self,
        sample: u32,
        total: f32,
        lobe: &CellLobe,
        point: &ShadingPoint,
        pattern: &PixelPattern,
        env: Environment<'_>,
    ) -> LightSample {
        let u = pattern.triple(BRDF, sample, self.brdf_samples);
        let drawn = point.brdf.sample(point.wo, u.z, unit_vec2(u.truncate()));
        if !(drawn.pdf_sr > 0.0) {
            return LightSample::IMPOSSIBLE;
        }
        let direction = point.frame.to_world(drawn.wi);
        let texel = env.texel(direction);
        let density = self.density(drawn.pdf_sr, self.pdf_sr(texel, total, lobe, env));
        LightSample::new(point, direction, drawn.wi, env.radiance(texel), density)
    }

    #[inline]
    fn product_sample(
        &self,
        sample: u32,
        total: f32,
        lobe: &CellLobe,
        point: &ShadingPoint,
        pattern: &PixelPattern,
        env: Environment<'_>,
    ) -> LightSample {
        let u = pattern.triple(ENVIRONMENT, sample, self.env_samples);
        let drawn = self.sample(u, total, lobe, env);
        if !(drawn.pmf > 0.0) {
            return LightSample::IMPOSSIBLE;
        }
        let place = hash2(u.x, u.y);
        let place = UVec2::new(place << 16, place & 0xffff_0000);
        let of_map = direction_in_texel(drawn.texel, env.size, unit_vec2(place));
        let direction = rotate_z(of_map, env.rotation);
        let wi = point.frame.to_local(direction);
        let pdf_sr = drawn.pmf / texel_solid_angle_sr(drawn.texel.y, env.size);
        let density = self.density(point.brdf.pdf_sr(point.wo, wi), pdf_sr);
        LightSample::new(point, direction, wi, env.radiance(drawn.texel), density)
    }
}

impl Estimator for Product {
    #[inline]
    fn reflected(
        &self,
        point: &ShadingPoint,
        pattern: &PixelPattern,
        env: Environment<'_>,
        scene: Scene<'_>,
    ) -> Reflected {
        let lobe = CellLobe::new(point, env);
        let total = self.total(&lobe, env);
        let key = pattern.ray_key(LIT_THROUGH);
        let mut sum = Reflected::NONE;
        for i in 0..self.brdf_samples {
            let sample = self.brdf_sample(i, total, &lobe, point, pattern, env);
            sum.gather(sample.traced(point, scene, key.wrapping_add(i)));
        }
        if total > 0.0 {
            for i in 0..self.env_samples {
                let sample = self.product_sample(i, total, &lobe, point, pattern, env);
                sum.gather(sample.traced(point, scene, key.wrapping_add(self.brdf_samples + i)));
            }
        }
        sum
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn products_keep_their_upper_half() {
        let words = [
            0,
            1,
            2,
            0xffff,
            0x1_0000,
            0x1234_5678,
            u32::MAX - 1,
            u32::MAX,
        ];
        for a in words {
            for b in words {
                let exact = (u64::from(a) * u64::from(b)) >> 32;
                assert_eq!(u64::from(multiply_high(a, b)), exact, "{a} {b}");
            }
        }
    }

    #[test]
    fn every_column_belongs_to_the_cells_that_hold_it() {
        for width in [1, 2, 31, 32, 33, 100, 1628] {
            for x in 0..width {
                let column = (COLUMNS * (x + 1) - 1) / width;
                assert!(first_column(column, width) <= x && x < first_column(column + 1, width));
            }
        }
    }
}
