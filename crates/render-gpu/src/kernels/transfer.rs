//! Shared file: precomputed radiance transfer of one vertex (Hajisharif 2012, Eqs. 3 and 8).

use core::f32::consts::PI;

use glam::{UVec2, UVec4, Vec2, Vec3};
use glimt_probe::trig::cos_sin_pi;
use glimt_sampling::hash::hash3;
use glimt_sampling::uniform::{UniformSource, unit_vec2};
use glimt_sampling::xoshiro::Xoshiro128PlusPlus;
use glimt_sh::basis::add_basis;

use super::bvh::{Asked, BvhNode, any_hit, any_hit_of};
use super::ray::Ray;
use super::triangle::Triangle;

/// Marks the streams of transfer: those of pixels have the frame's number in this place.
const STREAM: u32 = 0x7472_616e;

/// Words that a vertex keeps from part to part.
pub const STATE: usize = 5;

/// What is the same for all vertices. 24 bytes.
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct TransferParams {
    /// Bands n, 1 to 6.
    pub bands: u32,
    /// Directions N of the whole sphere, 1 to 2²⁰.
    pub directions: u32,
    /// Rows of strata, at most √N.
    pub rows: u32,
    /// Seed of the directions.
    pub seed: u32,
    /// The first row that is computed now.
    pub first_row: u32,
    /// The row that comes after the last of them.
    pub end_row: u32,
}

/// A vertex, as rays leave it. 48 bytes.
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct TransferVertex {
    /// Where rays start: a little above the surface, and a little to its middle where it ends.
    pub origin: Vec3,
    /// Index of the object that it belongs to.
    pub object: u32,
    /// Its unit normal; zero where it has none.
    pub normal: Vec3,
    /// Its number, which keys its stream.
    pub number: u32,
    /// A point beneath the surface: what the way from there to `origin` crosses from outside, and is another object's, lies on the
    /// surface.
    pub inner: Vec3,
    /// Fills 16 bytes.
    pub unused: f32,
}

/// Transfer of the vertex `vertex`, `(4π/N) Σ T(ω) y_lm(ω)` with `T = V ⟨n·ω⟩` over N directions (Eqs. 3 and 8), in world
/// coordinates: `lit` by V, `blocked` by 1 − V in its place, n² coefficients each. Returns how many rays were traced.
///
/// Both come from the same directions, so where nothing is blocked `blocked` is exactly 0, and where everything is, `lit`. A
/// vertex without a normal has zeros. Catchers block no light.
///
/// The rows of strata may be gone through in parts, from the first on: what a part finds is added to `lit` and `blocked`, and `state`,
/// [`STATE`] words, leads on to the next. The first part of all begins them. The last word is how many directions have been gone
/// through.
#[must_use]
pub fn transfer(
    vertex: u32,
    params: &TransferParams,
    nodes: &[BvhNode],
    triangles: &[Triangle],
    surface: &[u32],
    vertices: &[TransferVertex],
    state: &mut [u32],
    lit: &mut [f32],
    blocked: &mut [f32],
) -> u32 {
    let at = vertices[vertex as usize];
    let (n, bands) = (params.directions, params.bands);
    let mut arrives = [0.0_f32; 36];
    let mut kept_away = [0.0_f32; 36];
    let mut rays = 0;
    // Where another object lies on the surface, no point is above the one and before the other. What is crossed from inside lies
    // under the surface, or in its plane and faces as it does: that keeps no light from it.
    let way = at.origin - at.inner;
    let across = Ray::new(at.inner, way);
    let others = Asked {
        object: at.object,
        own: false,
        near: 1.0,
        way,
    };
    let touched = any_hit_of(nodes, triangles, surface, &across, 1.0, &others);
    let own = Asked {
        own: true,
        near: 0.0,
        ..others
    };
    let height = at.normal.dot(way);
    let mut source = Xoshiro128PlusPlus::stream(params.seed, STREAM, at.number);
    let mut kept = 0.0;
    let mut gone = 0;
    if params.first_row > 0 {
        let words = UVec4::new(state[0], state[1], state[2], state[3]);
        source = Xoshiro128PlusPlus::from_state(words);
        kept = 1.0;
        gone = state[4];
    }
    for row in params.first_row..params.end_row {
        let strata = strata_of_row(params, row);
        let (first, columns) = (strata.x, strata.y);
        for column in 0..columns {
            gone += 1;
            let u = unit_vec2(source.next_uvec2());
            let direction = direction_in_row(n, first, columns, column, u);
            let cosine = at.normal.dot(direction);
            if cosine > 0.0 {
                rays += 1;
                let key = hash3(params.seed, at.number, gone);
                let ray = Ray::keyed(at.origin, direction, key);
                let is_blocked = if touched {
                    // What lies under the surface is passed over until the ray has come through it.
                    let above = Asked {
                        near: height / cosine,
                        ..others
                    };
                    let beneath = Ray::keyed(at.inner, direction, key);
                    any_hit_of(nodes, triangles, surface, &beneath, f32::MAX, &above)
                        || any_hit_of(nodes, triangles, surface, &ray, f32::MAX, &own)
                } else {
                    any_hit(nodes, triangles, surface, &ray, f32::MAX)
                };
                if is_blocked {
                    add_basis(bands, direction, cosine, &mut kept_away);
                } else {
                    add_basis(bands, direction, cosine, &mut arrives);
                }
            }
        }
    }
    let scale = 4.0 * PI / n as f32;
    store(bands, kept, scale, &arrives, lit);
    store(bands, kept, scale, &kept_away, blocked);
    state[0] = source.state.x;
    state[1] = source.state.y;
    state[2] = source.state.z;
    state[3] = source.state.w;
    state[4] = gone;
    rays
}

/// The first stratum of row `row` of `params.rows`, and their number.
///
/// Rows are as high as their strata are many, so all strata have the area 4π/N, whatever N is; a square N has √N rows and
/// columns.
#[inline]
#[must_use]
pub fn strata_of_row(params: &TransferParams, row: u32) -> UVec2 {
    let first = row * params.directions / params.rows;
    let next = (row + 1) * params.directions / params.rows;
    UVec2::new(first, next - first)
}

/// A direction that is uniform in a stratum: that of column `column` in a row whose strata are `first`, `first + 1`, …, as many as
/// `columns`, of `n` in all. Rows run from +z to −z, columns from −x by −y, +x and +y around.
///
/// [`glimt_sh::stratified_direction`] wants as many columns in each row; `n` may be any number here.
#[inline]
#[must_use]
pub fn direction_in_row(n: u32, first: u32, columns: u32, column: u32, u: Vec2) -> Vec3 {
    let down = (first as f32 + u.x * columns as f32) / n as f32;
    let radius = 2.0 * libm::sqrtf(down * (1.0 - down));
    let around = cos_sin_pi((column as f32 + u.y) * (2.0 / columns as f32) - 1.0) * radius;
    Vec3::new(around.x, around.y, 1.0 - 2.0 * down)
}

/// `out[k] = kept · out[k] + scale · sums[k]` for the coefficients of `bands` bands. Written out, as in [`add_basis`].
fn store(bands: u32, kept: f32, scale: f32, sums: &[f32; 36], out: &mut [f32]) {
    out[0] = kept * out[0] + scale * sums[0];
    if bands > 1 {
        out[1] = kept * out[1] + scale * sums[1];
        out[2] = kept * out[2] + scale * sums[2];
        out[3] = kept * out[3] + scale * sums[3];
        if bands > 2 {
            out[4] = kept * out[4] + scale * sums[4];
            out[5] = kept * out[5] + scale * sums[5];
            out[6] = kept * out[6] + scale * sums[6];
            out[7] = kept * out[7] + scale * sums[7];
            out[8] = kept * out[8] + scale * sums[8];
            if bands > 3 {
                out[9] = kept * out[9] + scale * sums[9];
                out[10] = kept * out[10] + scale * sums[10];
                out[11] = kept * out[11] + scale * sums[11];
                out[12] = kept * out[12] + scale * sums[12];
                out[13] = kept * out[13] + scale * sums[13];
                out[14] = kept * out[14] + scale * sums[14];
                out[15] = kept * out[15] + scale * sums[15];
                if bands > 4 {
                    out[16] = kept * out[16] + scale * sums[16];
                    out[17] = kept * out[17] + scale * sums[17];
                    out[18] = kept * out[18] + scale * sums[18];
                    out[19] = kept * out[19] + scale * sums[19];
                    out[20] = kept * out[20] + scale * sums[20];
                    out[21] = kept * out[21] + scale * sums[21];
                    out[22] = kept * out[22] + scale * sums[22];
                    out[23] = kept * out[23] + scale * sums[23];
                    out[24] = kept * out[24] + scale * sums[24];
                    if bands > 5 {
                        out[25] = kept * out[25] + scale * sums[25];
                        out[26] = kept * out[26] + scale * sums[26];
                        out[27] = kept * out[27] + scale * sums[27];
                        out[28] = kept * out[28] + scale * sums[28];
                        out[29] = kept * out[29] + scale * sums[29];
                        out[30] = kept * out[30] + scale * sums[30];
                        out[31] = kept * out[31] + scale * sums[31];
                        out[32] = kept * out[32] + scale * sums[32];
                        out[33] = kept * out[33] + scale * sums[33];
                        out[34] = kept * out[34] + scale * sums[34];
                        out[35] = kept * out[35] + scale * sums[35];
                    }
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn layout_is_that_of_wgsl() {
        assert_eq!(core::mem::size_of::<TransferParams>(), 24);
        assert_eq!(core::mem::size_of::<TransferVertex>(), 48);
        assert_eq!(core::mem::offset_of!(TransferVertex, object), 12);
        assert_eq!(core::mem::offset_of!(TransferVertex, normal), 16);
        assert_eq!(core::mem::offset_of!(TransferVertex, inner), 32);
        assert_eq!(core::mem::offset_of!(TransferVertex, unused), 44);
    }
}
