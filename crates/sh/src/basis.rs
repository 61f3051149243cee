//! Shared file: the basis, its first six bands written out, and where its coefficients stand.
//!
//! Real spherical harmonics `y_lm`, `l ∈ 0..n`, `m ∈ −l..=l`, orthonormal over the sphere, with z the axis, as Hajisharif
//! 2012, Eq. 5, has them (with the factor √2 for m ≠ 0, which is missing in print), and **without** the Condon–Shortley
//! sign: `y_{1,−1} = √(3/4π) y`, `y_{1,0} = √(3/4π) z`, `y_{1,1} = +√(3/4π) x`. Positive m go with `cos mφ`, negative
//! ones with `sin |m|φ`. A band is a polynomial of the unit vector: a zonal factor in z times the real or imaginary part
//! of `(x + iy)^|m|`, so no angle is ever computed and the poles are points like all others.

use glam::{Vec2, Vec3};

/// The most bands n that this crate knows: l = 0..=5.
pub const MAX_BANDS: u32 = 6;

/// The number of coefficients of [`MAX_BANDS`] bands.
pub const MAX_COEFFICIENTS: usize = 36;

/// `n²`, the number of coefficients of the first n bands. More than [`MAX_BANDS`] count as that.
///
/// ```
/// use glimt_sh::coefficient_count;
/// assert_eq!([1, 2, 3, 4, 5, 6, 7].map(coefficient_count), [1, 4, 9, 16, 25, 36, 36]);
/// ```
#[inline]
#[must_use]
pub fn coefficient_count(bands: u32) -> u32 {
    let n = bands.min(MAX_BANDS);
    n * n
}

/// `l(l + 1) + m`, where the coefficient of `y_lm` stands, `−l ≤ m ≤ l`.
///
/// ```
/// use glimt_sh::coefficient_index;
/// assert_eq!([(0, 0), (1, -1), (1, 0), (1, 1), (2, -2)].map(|(l, m)| coefficient_index(l, m)), [0, 1, 2, 3, 4]);
/// ```
#[inline]
#[must_use]
pub fn coefficient_index(l: u32, m: i32) -> u32 {
    ((l * (l + 1)) as i32 + m) as u32
}

/// The band l that coefficient `k` belongs to, `k < 36`; more count as the last band.
///
/// ```
/// use glimt_sh::coefficient_band;
/// assert_eq!([0, 1, 3, 4, 24, 25, 35].map(coefficient_band), [0, 1, 1, 2, 4, 5, 5]);
/// ```
#[inline]
#[must_use]
pub fn coefficient_band(k: u32) -> u32 {
    let mut l = 0;
    while l < 5 && k >= (l + 1) * (l + 1) {
        l += 1;
    }
    l
}

/// The order m of coefficient `k`, from −l to l.
///
/// ```
/// use glimt_sh::coefficient_order;
/// assert_eq!([0, 1, 2, 3, 4].map(coefficient_order), [0, -1, 0, 1, -2]);
/// ```
#[inline]
#[must_use]
pub fn coefficient_order(k: u32) -> i32 {
    let l = coefficient_band(k);
    k as i32 - (l * (l + 1)) as i32
}

/// `y_00`.
pub const Y_00: f32 = 0.282_094_791_8;
/// `y_1m` of the direction along its own axis: `√(3/4π)`.
pub(crate) const Y_1: f32 = 0.488_602_511_9;

/// The zonal factors of band 2, for m = 0, 1, 2: `y_lm = zonal · ring`, with [`ring`](crate::ring) of (x, y).
#[inline]
#[must_use]
pub(crate) fn zonal_2(z: f32) -> [f32; 3] {
    [
        0.315_391_565_3 * (3.0 * z * z - 1.0),
        1.092_548_430_6 * z,
        0.546_274_215_3,
    ]
}

/// The zonal factors of band 3, for m = 0 to 3.
#[inline]
#[must_use]
pub(crate) fn zonal_3(z: f32) -> [f32; 4] {
    let t = z * z;
    [
        0.373_176_332_6 * z * (5.0 * t - 3.0),
        0.457_045_799_5 * (5.0 * t - 1.0),
        1.445_305_721_3 * z,
        0.590_043_589_9,
    ]
}

/// The zonal factors of band 4, for m = 0 to 4.
#[inline]
#[must_use]
pub(crate) fn zonal_4(z: f32) -> [f32; 5] {
    let t = z * z;
    [
        0.105_785_546_9 * ((35.0 * t - 30.0) * t + 3.0),
        0.669_046_543_6 * z * (7.0 * t - 3.0),
        0.473_087_347_9 * (7.0 * t - 1.0),
        1.770_130_769_8 * z,
        0.625_835_735_4,
    ]
}

/// The zonal factors of band 5, for m = 0 to 5.
#[inline]
#[must_use]
pub(crate) fn zonal_5(z: f32) -> [f32; 6] {
    let t = z * z;
    [
        0.116_950_322_5 * z * ((63.0 * t - 70.0) * t + 15.0),
        0.452_946_651_2 * ((21.0 * t - 14.0) * t + 1.0),
        2.396_768_392_5 * z * (3.0 * t - 1.0),
        0.489_238_299_4 * (9.0 * t - 1.0),
        2.075_662_314_9 * z,
        0.656_382_056_8,
    ]
}

/// `p · (x + iy)`, complex numbers as (real, imaginary).
#[inline]
#[must_use]
pub(crate) fn turn(p: Vec2, x: f32, y: f32) -> Vec2 {
    Vec2::new(p.x * x - p.y * y, p.x * y + p.y * x)
}

/// All 36 basis functions of the unit vector `d`, at [`coefficient_index`]. A vector of another length gives polynomials
/// of it that mean nothing.
///
/// Error below 10⁻⁶ of each function's maximum.
///
/// ```
/// use glam::Vec3;
/// use glimt_sh::basis;
/// let y = basis(Vec3::new(0.48, -0.6, 0.64));
/// let (k, pi) = ((0.75 / core::f32::consts::PI).sqrt(), core::f32::consts::PI);
/// // No Condon–Shortley sign: band 1 is (y, z, x).
/// assert!((y[1] + 0.6 * k).abs() < 1e-6 && (y[2] - 0.64 * k).abs() < 1e-6 && (y[3] - 0.48 * k).abs() < 1e-6);
/// // Unsöld: the squares of band l add up to (2l + 1)/4π.
/// let band_5: f32 = y[25..].iter().map(|y| y * y).sum();
/// assert!((band_5 - 11.0 / (4.0 * pi)).abs() < 1e-5);
/// ```
#[inline]
#[must_use]
pub fn basis(d: Vec3) -> [f32; 36] {
    let p1 = Vec2::new(d.x, d.y);
    let p2 = turn(p1, d.x, d.y);
    let p3 = turn(p2, d.x, d.y);
    let p4 = turn(p3, d.x, d.y);
    let p5 = turn(p4, d.x, d.y);
    let q2 = zonal_2(d.z);
    let q3 = zonal_3(d.z);
    let q4 = zonal_4(d.z);
    let q5 = zonal_5(d.z);
    [
        Y_00,
        // l = 1
        Y_1 * p1.y,
        Y_1 * d.z,
        Y_1 * p1.x,
        // l = 2
        q2[2] * p2.y,
        q2[1] * p1.y,
        q2[0],
        q2[1] * p1.x,
        q2[2] * p2.x,
        // l = 3
        q3[3] * p3.y,
        q3[2] * p2.y,
        q3[1] * p1.y,
        q3[0],
        q3[1] * p1.x,
        q3[2] * p2.x,
        q3[3] * p3.x,
        // l = 4
        q4[4] * p4.y,
        q4[3] * p3.y,
        q4[2] * p2.y,
        q4[1] * p1.y,
        q4[0],
        q4[1] * p1.x,
        q4[2] * p2.x,
        q4[3] * p3.x,
        q4[4] * p4.x,
        // l = 5
        q5[5] * p5.y,
        q5[4] * p4.y,
        q5[3] * p3.y,
        q5[2] * p2.y,
        q5[1] * p1.y,
        q5[0],
        q5[1] * p1.x,
        q5[2] * p2.x,
        q5[3] * p3.x,
        q5[4] * p4.x,
        q5[5] * p5.x,
    ]
}

/// `sums[k] += weight · y_k(d)` for the first `bands` bands; the other sums stay as they are. No bands are none, more than
/// [`MAX_BANDS`] are that.
///
/// Written out, with no index that is computed, so that the sums stay in registers on a GPU.
///
/// ```
/// use glam::Vec3;
/// use glimt_sh::{add_basis, basis};
/// let d = Vec3::new(0.36, 0.48, -0.8);
/// let mut sums = [1.0; 36];
/// add_basis(3, d, 2.0, &mut sums);
/// assert_eq!(sums[8], 1.0 + 2.0 * basis(d)[8]);
/// assert_eq!(sums[9], 1.0);
/// ```
#[inline]
pub fn add_basis(bands: u32, d: Vec3, weight: f32, sums: &mut [f32; 36]) {
    if bands > 0 {
        sums[0] += weight * Y_00;
    }
    if bands > 1 {
        let p1 = Vec2::new(d.x, d.y);
        sums[1] += weight * (Y_1 * p1.y);
        sums[2] += weight * (Y_1 * d.z);
        sums[3] += weight * (Y_1 * p1.x);
        if bands > 2 {
            let p2 = turn(p1, d.x, d.y);
            let q2 = zonal_2(d.z);
            sums[4] += weight * (q2[2] * p2.y);
            sums[5] += weight * (q2[1] * p1.y);
            sums[6] += weight * q2[0];
            sums[7] += weight * (q2[1] * p1.x);
            sums[8] += weight * (q2[2] * p2.x);
            if bands > 3 {
                let p3 = turn(p2, d.x, d.y);
                let q3 = zonal_3(d.z);
                sums[9] += weight * (q3[3] * p3.y);
                sums[10] += weight * (q3[2] * p2.y);
                sums[11] += weight * (q3[1] * p1.y);
                sums[12] += weight * q3[0];
                sums[13] += weight * (q3[1] * p1.x);
                sums[14] += weight * (q3[2] * p2.x);
                sums[15] += weight * (q3[3] * p3.x);
                if bands > 4 {
                    let p4 = turn(p3, d.x, d.y);
                    let q4 = zonal_4(d.z);
                    sums[16] += weight * (q4[4] * p4.y);
                    sums[17] += weight * (q4[3] * p3.y);
                    sums[18] += weight * (q4[2] * p2.y);
                    sums[19] += weight * (q4[1] * p1.y);
                    sums[20] += weight * q4[0];
                    sums[21] += weight * (q4[1] * p1.x);
                    sums[22] += weight * (q4[2] * p2.x);
                    sums[23] += weight * (q4[3] * p3.x);
                    sums[24] += weight * (q4[4] * p4.x);
                    if bands > 5 {
                        let p5 = turn(p4, d.x, d.y);
                        let q5 = zonal_5(d.z);
                        sums[25] += weight * (q5[5] * p5.y);
                        sums[26] += weight * (q5[4] * p4.y);
                        sums[27] += weight * (q5[3] * p3.y);
                        sums[28] += weight * (q5[2] * p2.y);
                        sums[29] += weight * (q5[1] * p1.y);
                        sums[30] += weight * q5[0];
                        sums[31] += weight * (q5[1] * p1.x);
                        sums[32] += weight * (q5[2] * p2.x);
                        sums[33] += weight * (q5[3] * p3.x);
                        sums[34] += weight * (q5[4] * p4.x);
                        sums[35] += weight * (q5[5] * p5.x);
                    }
                }
            }
        }
    }
}
