//! Shared file: a basis function as a factor of the ring (φ) times a factor of the meridian (θ).
//!
//! `y_lm = meridian[l, |m|] · ring[m]`. A map in latitude and longitude is projected a row at a time by it: first 2n − 1
//! sums over φ, then n² products, so that a texel costs 2n − 1 multiplications and not n².

use glam::{UVec2, Vec2};
use glimt_probe::trig::cos_sin_pi;

use crate::basis::{Y_00, Y_1, turn, zonal_2, zonal_3, zonal_4, zonal_5};

/// Where `cos mφ` (m ≥ 0) or `sin |m|φ` (m < 0) stands in [`ring`]: 0, then 2m − 1 and 2|m|.
///
/// ```
/// use glimt_sh::separable::ring_index;
/// assert_eq!([ring_index(0), ring_index(1), ring_index(-1), ring_index(5), ring_index(-5)], [0, 1, 2, 9, 10]);
/// ```
#[inline]
#[must_use]
pub fn ring_index(m: i32) -> u32 {
    if m > 0 {
        (2 * m - 1) as u32
    } else {
        (-2 * m) as u32
    }
}

/// Where the factor of (l, |m|) stands in [`meridian`]: l(l + 1)/2 + |m|.
///
/// ```
/// use glimt_sh::separable::meridian_index;
/// assert_eq!([meridian_index(0, 0), meridian_index(1, 1), meridian_index(5, 5)], [0, 2, 20]);
/// ```
#[inline]
#[must_use]
pub fn meridian_index(l: u32, m: u32) -> u32 {
    l * (l + 1) / 2 + m
}

/// `(1, cos φ, sin φ, cos 2φ, sin 2φ, …, sin 5φ)` for `x = cos φ`, `y = sin φ`: 2n − 1 factors of six bands.
///
/// Of another point of the plane, at distance ρ from the origin, the pair of m comes out times ρ^m.
///
/// ```
/// use glimt_sh::ring;
/// let phi = 0.7f32;
/// let r = ring(phi.cos(), phi.sin());
/// assert!((r[0] - 1.0).abs() < 1e-6 && (r[5] - (3.0 * phi).cos()).abs() < 1e-6 && (r[10] - (5.0 * phi).sin()).abs() < 1e-6);
/// ```
#[inline]
#[must_use]
pub fn ring(x: f32, y: f32) -> [f32; 11] {
    let p1 = Vec2::new(x, y);
    let p2 = turn(p1, x, y);
    let p3 = turn(p2, x, y);
    let p4 = turn(p3, x, y);
    let p5 = turn(p4, x, y);
    [1.0, x, y, p2.x, p2.y, p3.x, p3.y, p4.x, p4.y, p5.x, p5.y]
}

/// `K_lm P_l^|m|(cos θ)`, with √2 where m ≠ 0 and without the Condon–Shortley sign, for `z = cos θ`, `s = sin θ ≥ 0`, at
/// [`meridian_index`]: (0,0), (1,0), (1,1), (2,0), …, (5,5), n(n + 1)/2 factors of six bands.
///
/// ```
/// use glam::Vec3;
/// use glimt_sh::{basis, coefficient_index, meridian, ring, separable::{meridian_index, ring_index}};
/// // y_{4,−3} of θ = arccos 0.6, φ = arccos 0.8.
/// let d = Vec3::new(0.8 * 0.8, 0.8 * 0.6, 0.6);
/// let product = meridian(0.6, 0.8)[meridian_index(4, 3) as usize] * ring(0.8, 0.6)[ring_index(-3) as usize];
/// assert!((product - basis(d)[coefficient_index(4, -3) as usize]).abs() < 1e-6);
/// ```
#[inline]
#[must_use]
pub fn meridian(z: f32, s: f32) -> [f32; 21] {
    let s2 = s * s;
    let s3 = s2 * s;
    let s4 = s2 * s2;
    let s5 = s4 * s;
    let q2 = zonal_2(z);
    let q3 = zonal_3(z);
    let q4 = zonal_4(z);
    let q5 = zonal_5(z);
    [
        Y_00,
        Y_1 * z,
        Y_1 * s,
        q2[0],
        q2[1] * s,
        q2[2] * s2,
        q3[0],
        q3[1] * s,
        q3[2] * s2,
        q3[3] * s3,
        q4[0],
        q4[1] * s,
        q4[2] * s2,
        q4[3] * s3,
        q4[4] * s4,
        q5[0],
        q5[1] * s,
        q5[2] * s2,
        q5[3] * s3,
        q5[4] * s4,
        q5[5] * s5,
    ]
}

/// [`ring`] at the centre of column `column` of a lat-long map that is `width` texels wide: `φ = π − 2π(column + ½)/width`.
///
/// ```
/// use glimt_sh::separable::column_ring;
/// // The first of four columns: φ = 3π/4.
/// let r = column_ring(0, 4);
/// assert!((r[1] + 0.5f32.sqrt()).abs() < 1e-6 && (r[2] - 0.5f32.sqrt()).abs() < 1e-6);
/// ```
#[inline]
#[must_use]
pub fn column_ring(column: u32, width: u32) -> [f32; 11] {
    let phi = cos_sin_pi(1.0 - (2 * column + 1) as f32 / width as f32);
    ring(phi.x, phi.y)
}

/// [`meridian`] at the centre of row `row` of a lat-long map of `size` (width, height) texels: `θ = π(row + ½)/height`.
///
/// ```
/// use glam::UVec2;
/// use glimt_sh::{meridian, separable::row_meridian};
/// // The second of three rows is the equator.
/// let (m, equator) = (row_meridian(1, UVec2::new(6, 3)), meridian(0.0, 1.0));
/// assert!(m.iter().zip(equator).all(|(a, b)| (a - b).abs() < 1e-6));
/// ```
#[inline]
#[must_use]
pub fn row_meridian(row: u32, size: UVec2) -> [f32; 21] {
    let theta = cos_sin_pi((2 * row + 1) as f32 / (2 * size.y) as f32);
    meridian(theta.x, theta.y)
}
