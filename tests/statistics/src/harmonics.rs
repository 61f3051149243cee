//! Host file: real spherical harmonics of any band in f64, by the textbook's recurrences: slow, and written apart from
//! the crate's.

use std::f64::consts::{PI, TAU};

use crate::quadrature::{Direction, direction, gauss_legendre};

/// `y_lm(d)`, orthonormal, without the Condon–Shortley sign.
#[must_use]
pub fn harmonic(l: u32, m: i32, d: Direction) -> f64 {
    let (n, z) = (m.unsigned_abs(), d[2]);
    let s = d[0].hypot(d[1]);
    // P_n^n, then upwards in l.
    let mut p = (0..n).fold(1.0, |p, i| p * f64::from(2 * i + 1) * s);
    let mut before = 0.0;
    for k in n + 1..=l {
        let next = f64::from(2 * k - 1) * z * p - f64::from(k + n - 1) * before;
        (before, p) = (p, next / f64::from(k - n));
    }
    let ratio = (l - n + 1..=l + n).fold(1.0, |r, i| r / f64::from(i));
    let norm = (f64::from(2 * l + 1) / (4.0 * PI) * ratio).sqrt();
    let phi = f64::from(n) * d[1].atan2(d[0]);
    match m {
        0 => norm * p,
        1.. => norm * p * 2f64.sqrt() * phi.cos(),
        _ => norm * p * 2f64.sqrt() * phi.sin(),
    }
}

/// (l, m) of the first n bands, in the order of the coefficients.
#[must_use]
pub fn indices(bands: u32) -> Vec<(u32, i32)> {
    let band = |l: u32| (-(l as i32)..=l as i32).map(move |m| (l, m));
    (0..bands).flat_map(band).collect()
}

/// Directions and weights of a rule that is exact for polynomials up to `degree`, over the whole sphere.
#[must_use]
pub fn sphere_rule(degree: u32) -> Vec<(Direction, f64)> {
    let around = degree + 1;
    let rings = gauss_legendre((degree / 2 + 1) as usize).into_iter();
    rings
        .flat_map(|(z, weight)| {
            (0..around).map(move |i| {
                let phi = TAU * (f64::from(i) + 0.3) / f64::from(around);
                (direction(z, phi), weight * TAU / f64::from(around))
            })
        })
        .collect()
}
