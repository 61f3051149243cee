//! Shared file: drawing directions in proportion to the radiance of a lat-long map.

use glam::{UVec2, Vec2, Vec3};
use glimt_probe::latlong;
use glimt_probe::trig::cos_sin_pi;
use glimt_sampling::hash::hash2;

use crate::search::{Bin, find_bin};

/// One unit of a table, as a probability.
const UNIT: f32 = 1.0 / 2_147_483_648.0;

/// The greatest f32 below 1.
const BELOW_ONE: f32 = 1.0 - 1.0 / 16_777_216.0;

/// A lat-long map's tables, as a view of slices that the caller owns.
///
/// The tables are those of [`build_into`](crate::build_into); [`EnvCdf::new`] checks that they fit each other. `size` alone
/// says how long they are: what a slice, or a GPU's buffer, holds beyond the length of [`required_len`](crate::required_len)
/// is never read. On the CPU a view whose slices are shorter panics when it is used.
///
/// A **black** map (all edges 0) is sampled with density 0 and has density 0 everywhere.
#[derive(Clone, Copy, Debug)]
pub struct EnvCdf<'a> {
    /// Width and height of the map, in texels.
    pub size: UVec2,
    /// Edges of the rows in units of 2⁻³¹, from +z down: the first `h + 1` entries.
    pub marginal: &'a [u32],
    /// Edges of the columns of each row in units of 2⁻³¹, from left to right: the first `h (w + 1)` entries, `w + 1` a row.
    pub conditional: &'a [u32],
}

/// A direction drawn from an environment map.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EnvSample {
    /// The texel, `(column, row)`. The sample's radiance is that of this texel, never that of a second lookup.
    pub texel: UVec2,
    /// Unit vector towards the environment.
    pub direction: Vec3,
    /// Density, in 1/sr. 0 marks an impossible sample (of a black map), which contributes 0 and counts all the same.
    pub pdf_sr: f32,
}

impl<'a> EnvCdf<'a> {
    /// Whether the map holds no light at all.
    #[inline]
    #[must_use]
    pub fn is_black(&self) -> bool {
        self.marginal[self.size.y as usize] == 0
    }

    /// Draws a direction in proportion to the map's weights, from two uniform words: `u.y` gives the row, `u.x` the
    /// column.
    ///
    /// The tables are searched with the top 31 bits of a word, exactly. What is left of it within the bin, in units,
    /// plus a fraction of a unit, gives the place inside the texel, uniform in `cos θ` and `φ`; that fraction is 16
    /// bits per axis of one hash of both words, so that even a texel of a single unit is sampled all over. In a black
    /// map: texel `(0, 0)`, direction +z, density 0.
    #[inline]
    #[must_use]
    pub fn sample(&self, u: UVec2) -> EnvSample {
        if self.is_black() {
            return EnvSample {
                texel: UVec2::ZERO,
                direction: Vec3::Z,
                pdf_sr: 0.0,
            };
        }
        let row = find_bin(self.marginal, 0, self.size.y as usize, u.y >> 1);
        let row_start = (row.index * (self.size.x + 1)) as usize;
        let column = find_bin(self.conditional, row_start, self.size.x as usize, u.x >> 1);
        let texel = UVec2::new(column.index, row.index);
        let hash = hash2(u.x, u.y);
        let place = Vec2::new(
            place_in_bin(column, u.x >> 1, hash & 0xffff),
            place_in_bin(row, u.y >> 1, hash >> 16),
        );
        EnvSample {
            texel,
            direction: latlong::direction_in_texel(texel, self.size, place),
            pdf_sr: density_sr(row.units, column.units, row.index, self.size),
        }
    }

    /// [`EnvCdf::sample`] for callers whose uniforms are f32 in `[0, 1)` (clamped to it).
    ///
    /// Such a number carries 24 bits, so rows and columns narrower than 2⁷ units of 2⁻³¹ are missed by most, or all, of
    /// them: a small bias that `sample` does not have.
    ///
    /// ```
    /// # use glam::{UVec2, Vec2};
    /// # let env = glimt_envmap_cdf::EnvCdf {
    /// #     size: UVec2::new(2, 1), marginal: &[0, 1 << 31], conditional: &[0, 1 << 30, 1 << 31],
    /// # };
    /// let half = env.sample(UVec2::splat(1 << 31));
    /// assert_eq!(env.sample_f32(Vec2::splat(0.5)), half);
    /// ```
    #[inline]
    #[must_use]
    pub fn sample_f32(&self, u: Vec2) -> EnvSample {
        let clamped = u.max(Vec2::ZERO).min(Vec2::splat(BELOW_ONE));
        self.sample((clamped * 4_294_967_296.0).as_uvec2())
    }

    /// Density of [`EnvCdf::sample`] in the direction `d` (any length but zero), in 1/sr.
    ///
    /// It is that of the texel `d` falls into; a direction drawn within rounding of a texel's edge may find the
    /// neighbour's.
    #[inline]
    #[must_use]
    pub fn pdf_sr(&self, d: Vec3) -> f32 {
        self.texel_pdf_sr(latlong::direction_to_texel(d, self.size))
    }

    /// Density of [`EnvCdf::sample`] everywhere in a texel, in 1/sr: the stored probability over the texel's solid
    /// angle. `texel` lies below `size`.
    #[inline]
    #[must_use]
    pub fn texel_pdf_sr(&self, texel: UVec2) -> f32 {
        let row = self.row(texel);
        let column = self.column(texel);
        density_sr(row.units, column.units, texel.y, self.size)
    }

    /// Uniform words that [`EnvCdf::sample`] takes to the texel of `d`, and to `d` itself as nearly as a word can tell:
    /// to one unit of the texel's bin, and to f32's precision of an angle.
    ///
    /// A direction of density 0 has no such words; the result then belongs to some other texel, so ask
    /// [`EnvCdf::pdf_sr`] first.
    #[inline]
    #[must_use]
    pub fn invert(&self, d: Vec3) -> UVec2 {
        let texel = latlong::direction_to_texel(d, self.size);
        let position = latlong::direction_to_uv(d) * self.size.as_vec2() - texel.as_vec2();
        let place = position.clamp(Vec2::ZERO, Vec2::ONE);
        UVec2::new(
            word_in_bin(self.column(texel), place.x),
            word_in_bin(self.row(texel), area_above(texel.y, self.size.y, place.y)),
        )
    }

    #[inline]
    fn row(&self, texel: UVec2) -> Bin {
        let y = texel.y as usize;
        Bin {
            index: texel.y,
            first: self.marginal[y],
            units: self.marginal[y + 1] - self.marginal[y],
        }
    }

    #[inline]
    fn column(&self, texel: UVec2) -> Bin {
        let x = (texel.y * (self.size.x + 1) + texel.x) as usize;
        Bin {
            index: texel.x,
            first: self.conditional[x],
            units: self.conditional[x + 1] - self.conditional[x],
        }
    }
}

/// Density of a texel, from the units of its row and of its column in it.
#[inline]
fn density_sr(row_units: u32, column_units: u32, row: u32, size: UVec2) -> f32 {
    let pmf = (row_units as f32 * UNIT) * (column_units as f32 * UNIT);
    pmf / latlong::texel_solid_angle_sr(row, size)
}

/// Where in `[0, 1)` of its bin the number `u` (31 bits) lies, refined by 16 bits below the unit.
#[inline]
fn place_in_bin(bin: Bin, u: u32, fraction: u32) -> f32 {
    let below_unit = fraction as f32 * (1.0 / 65_536.0);
    (((u - bin.first) as f32 + below_unit) / bin.units as f32).min(BELOW_ONE)
}

/// The word whose top 31 bits lie at `place` (0 to 1) in the bin.
#[inline]
fn word_in_bin(bin: Bin, place: f32) -> u32 {
    let last = bin.units.max(1) - 1;
    let unit = ((place * bin.units as f32) as u32).min(last);
    // A bin of no width may lie at the very end of the table.
    (bin.first + unit).min(0x7fff_ffff) << 1
}

/// Share of the area of a row's band that lies above `v`, the distance from its upper edge in rows (0 to 1).
#[inline]
fn area_above(row: u32, height: u32, v: f32) -> f32 {
    // Differences of cosines as products of sines, from the nearer pole: precise there.
    let half = 0.5 / height as f32;
    let southern = 2 * row >= height;
    let from_pole = if southern { height - 1 - row } else { row };
    let f = if southern { 1.0 - v } else { v };
    let edge = (2 * from_pole) as f32;
    let part = cos_sin_pi((edge + f) * half).y * cos_sin_pi(f * half).y;
    let band = cos_sin_pi((edge + 1.0) * half).y * cos_sin_pi(half).y;
    let share = part / band;
    if southern { 1.0 - share } else { share }
}
