//! Shared file: floats and libm.

use super::input::{float, int, uint};
use core::f32::consts::{FRAC_1_PI, FRAC_PI_2, PI, SQRT_2, TAU};

/// The four operations and the remainder.
pub fn arithmetic(id: u32, _ints: &[u32], floats: &[f32]) -> [f32; 8] {
    let (a, b) = (float(id, floats, 0), float(id, floats, 1));
    let d = if libm::fabsf(b) < 0.01 { 0.5 } else { b };
    let mut c = a;
    c += b;
    c *= 0.5;
    c -= 1.25;
    c /= d;
    [
        a + b,
        a - b,
        a * b,
        a / d,
        -a,
        c,
        a * b + a,
        (a + b) * (a - b),
    ]
}

/// `%` truncates, as in C.
pub fn remainder(id: u32, _ints: &[u32], floats: &[f32]) -> [f32; 2] {
    // Quarters are exact, so that the quotient cannot fall on the wrong side of a whole number.
    let a = libm::floorf(float(id, floats, 0) * 4.0) * 0.25;
    [a % 1.5, a % -2.0]
}

/// Methods of `f32`.
pub fn methods(id: u32, _ints: &[u32], floats: &[f32]) -> [f32; 8] {
    let (a, b, c) = (
        float(id, floats, 0),
        float(id, floats, 1),
        float(id, floats, 2),
    );
    let d = if b.abs() < 0.01 { 0.5 } else { b };
    [
        a.min(b),
        a.max(b),
        a.clamp(-1.0, 2.5),
        a.abs(),
        a.copysign(b),
        d.recip(),
        a.mul_add(b, c),
        a.clamp(b.min(c), b.max(c)),
    ]
}

/// Bit patterns.
pub fn bit_patterns(id: u32, ints: &[u32], floats: &[f32]) -> [u32; 4] {
    let a = float(id, floats, 0);
    let exponent = 64 + uint(id, ints, 0) % 128;
    let made = f32::from_bits(exponent << 23 | uint(id, ints, 1) >> 9);
    [
        a.to_bits(),
        made.to_bits(),
        (-made).to_bits(),
        f32::from_bits(a.to_bits() & 0x7FFF_FFFF).to_bits(),
    ]
}

/// Comparisons.
pub fn comparisons(id: u32, _ints: &[u32], floats: &[f32]) -> u32 {
    let (a, b) = (float(id, floats, 0), float(id, floats, 1));
    (a < b) as u32
        | ((a <= b) as u32) << 1
        | ((a > b) as u32) << 2
        | ((a >= b) as u32) << 3
        | ((a == b) as u32) << 4
        | ((a != b) as u32) << 5
        | (!(a <= b) as u32) << 6
}

/// Whole numbers.
pub fn whole(id: u32, _ints: &[u32], floats: &[f32]) -> [f32; 8] {
    let (a, b) = (float(id, floats, 0), float(id, floats, 1));
    [
        libm::floorf(a),
        libm::ceilf(a),
        libm::truncf(a),
        libm::fabsf(a),
        libm::fminf(a, b),
        libm::fmaxf(a, b),
        a - libm::floorf(a),
        libm::floorf(a + 0.5),
    ]
}

/// Sine, cosine, tangent and their inverses.
pub fn trigonometry(id: u32, _ints: &[u32], floats: &[f32]) -> [f32; 8] {
    let a = float(id, floats, 0);
    let unit = a / 10.0;
    let (y, x) = (float(id, floats, 1), float(id, floats, 2));
    let x = if x.abs() < 0.01 { 1.0 } else { x };
    // Away from the branch cut along -x, where a rounded y jumps by a turn.
    let y = if y.abs() < 0.01 { 0.25 } else { y };
    [
        libm::sinf(a),
        libm::cosf(a),
        libm::tanf(unit),
        libm::asinf(unit),
        libm::acosf(unit),
        libm::atanf(a),
        libm::atan2f(y, x),
        libm::atan2f(-y, -x),
    ]
}

/// Roots, exponentials and logarithms.
pub fn exponentials(id: u32, _ints: &[u32], floats: &[f32]) -> [f32; 8] {
    let a = float(id, floats, 0);
    let positive = libm::fabsf(float(id, floats, 1)) + 0.01;
    [
        libm::sqrtf(positive),
        libm::expf(a * 0.3),
        libm::exp2f(a * 0.3),
        libm::logf(positive),
        libm::log2f(positive),
        libm::sinhf(a * 0.3),
        libm::coshf(a * 0.3),
        libm::tanhf(a * 0.3),
    ]
}

/// `powf`, and scaling by a power of two.
pub fn powers(id: u32, ints: &[u32], floats: &[f32]) -> [f32; 3] {
    let base = libm::fabsf(float(id, floats, 0)) * 0.1 + 0.01;
    let exponent = float(id, floats, 1) * 0.3;
    [
        libm::powf(base, exponent),
        libm::powf(base, 5.0),
        libm::ldexpf(base, int(id, ints, 0) % 20),
    ]
}

/// Constants, and literals in their spellings.
pub fn constants(id: u32, _ints: &[u32], floats: &[f32]) -> [f32; 8] {
    let a = float(id, floats, 0);
    [
        a * PI,
        a * TAU + FRAC_1_PI,
        a * SQRT_2 - FRAC_PI_2,
        a + core::f32::consts::LN_2,
        (a * 1e3 + 1.5e-2) + 1_000.0 + 2f32 + 3. + 0.25_f32,
        if a < f32::MAX && a > f32::MIN {
            f32::EPSILON
        } else {
            f32::MIN_POSITIVE
        },
        a / core::f32::consts::E,
        -1e-3 * a,
    ]
}
