//! Shared file: integers.

use super::input::{float, int, uint};

/// Unsigned arithmetic that wraps.
pub fn unsigned(id: u32, ints: &[u32], _floats: &[f32]) -> [u32; 8] {
    let (a, b) = (uint(id, ints, 0), uint(id, ints, 1));
    let d = b.max(1);
    [
        a.wrapping_add(b),
        a.wrapping_sub(b),
        a.wrapping_mul(b),
        a / d,
        a % d,
        a.wrapping_neg(),
        (a >> 1) + (b >> 1),
        a.wrapping_mul(b).wrapping_add(a) ^ b,
    ]
}

/// Signed arithmetic that wraps, division and remainder toward zero.
pub fn signed(id: u32, ints: &[u32], _floats: &[f32]) -> [i32; 8] {
    let (a, b) = (int(id, ints, 0), int(id, ints, 1));
    let d = if b == 0 || b == -1 { 3 } else { b };
    [
        a.wrapping_add(b),
        a.wrapping_sub(b),
        a.wrapping_mul(b),
        a / d,
        a % d,
        a.wrapping_neg(),
        -(a / 2),
        (a / 2) - (b / 2) * 1,
    ]
}

/// Bitwise operators and shifts.
pub fn bits(id: u32, ints: &[u32], _floats: &[f32]) -> [u32; 8] {
    let (a, b) = (uint(id, ints, 0), uint(id, ints, 1));
    let s = uint(id, ints, 2) & 31;
    [
        a & b,
        a | b,
        a ^ b,
        !a,
        a << s,
        a >> s,
        ((a as i32) >> s) as u32,
        ((b as i32) << s) as u32,
    ]
}

/// Shifts and rotations by any amount.
pub fn any_shift(id: u32, ints: &[u32], _floats: &[f32]) -> [u32; 8] {
    let (a, s) = (uint(id, ints, 0), uint(id, ints, 1));
    let i = a as i32;
    [
        a.wrapping_shl(s),
        a.wrapping_shr(s),
        i.wrapping_shl(s) as u32,
        i.wrapping_shr(s) as u32,
        a.rotate_left(s),
        a.rotate_right(s),
        i.rotate_left(s) as u32,
        i.rotate_right(s) as u32,
    ]
}

/// Counts of bits, and their reversal.
pub fn counts(id: u32, ints: &[u32], _floats: &[f32]) -> [u32; 8] {
    let a = uint(id, ints, 0);
    let i = int(id, ints, 1);
    [
        a.count_ones(),
        a.leading_zeros(),
        a.trailing_zeros(),
        a.reverse_bits(),
        i.count_ones(),
        i.leading_zeros(),
        i.trailing_zeros(),
        i.reverse_bits() as u32,
    ]
}

/// Operations that saturate or divide.
pub fn saturating(id: u32, ints: &[u32], _floats: &[f32]) -> [u32; 8] {
    let (a, b, c) = (uint(id, ints, 0), uint(id, ints, 1), uint(id, ints, 2));
    let lo = b.min(c);
    [
        a.saturating_add(b),
        a.saturating_sub(b),
        a.abs_diff(b),
        a.div_ceil(b.max(1)),
        a.is_power_of_two() as u32,
        a.min(b),
        a.max(b),
        a.clamp(lo, b.max(c)),
    ]
}

/// Signed minimum, maximum, clamp, magnitude, comparisons.
pub fn signed_order(id: u32, ints: &[u32], _floats: &[f32]) -> [i32; 8] {
    let (a, b, c) = (int(id, ints, 0), int(id, ints, 1), int(id, ints, 2));
    [
        a.min(b),
        a.max(b),
        a.clamp(b.min(c), b.max(c)),
        a.max(-i32::MAX).abs(),
        (a < b) as i32 + 2 * (a <= b) as i32,
        (a > b) as i32 + 2 * (a >= b) as i32,
        (a == b) as i32 + 2 * (a != b) as i32,
        if a < 0 { -1 } else { 1 },
    ]
}

/// Comparisons of unsigned numbers and of booleans, and the operators of `bool`.
pub fn comparisons(id: u32, ints: &[u32], _floats: &[f32]) -> [u32; 8] {
    let (a, b) = (uint(id, ints, 0), uint(id, ints, 1));
    let (p, q) = (a & 1 == 1, b & 1 == 1);
    [
        (a < b) as u32,
        (a <= b) as u32,
        (a > b) as u32,
        (a >= b) as u32,
        (p == q) as u32 + 2 * ((p != q) as u32),
        (p & q) as u32 + 2 * ((p | q) as u32) + 4 * ((p ^ q) as u32) + 8 * ((!p) as u32),
        (p && q || !p && !q) as u32,
        !(a == b) as u32,
    ]
}

/// Casts between integers, and to and from floats within range.
pub fn casts(id: u32, ints: &[u32], floats: &[f32]) -> [i32; 8] {
    let a = uint(id, ints, 0);
    let f = float(id, floats, 0);
    let big = float(id, floats, 1) * 1e7;
    let index = a as usize % 1000;
    [
        a as i32,
        (a as i32) as u32 as i32,
        f as i32,
        big as i32,
        libm::fabsf(big) as u32 as i32,
        index as i32,
        (f > 0.0) as i32,
        ((a & 0xFF_FFFF) as f32) as i32,
    ]
}

/// Integers to floats: exact or rightly rounded.
pub fn to_float(id: u32, ints: &[u32], _floats: &[f32]) -> [f32; 4] {
    let a = uint(id, ints, 0);
    [
        a as f32,
        (a as i32) as f32,
        (a & 1 == 0) as u32 as f32,
        (a % 1000) as usize as f32,
    ]
}

/// Compound assignment.
pub fn compound(id: u32, ints: &[u32], _floats: &[f32]) -> [u32; 8] {
    let (a, b) = (uint(id, ints, 0), uint(id, ints, 1) | 1);
    let s = b & 15;
    let mut v = [a >> 1; 8];
    v[0] += b >> 1;
    v[1] -= (a >> 1) / 2;
    v[2] /= b;
    v[3] %= b;
    v[4] &= b;
    v[5] |= b;
    v[6] ^= b;
    v[7] <<= s;
    v[7] >>= s + 1;
    let mut small = a & 0xFFFF;
    small *= b & 0xFFFF;
    v[0] = v[0].wrapping_add(small);
    v
}

/// Literals in all their spellings.
pub fn literals(id: u32, ints: &[u32], _floats: &[f32]) -> [u32; 8] {
    let a = uint(id, ints, 0);
    let minus = -7i32;
    let inferred: i32 = -2_147_483_648;
    [
        a ^ 0xDEAD_BEEF,
        a ^ 0b1010_0101,
        a ^ 0o777,
        a ^ 4_294_967_295,
        a ^ 1u32,
        (minus as u32) ^ a,
        inferred as u32 ^ a,
        u32::MAX ^ u32::MIN ^ u32::BITS ^ (i32::MAX as u32) ^ (i32::MIN as u32) ^ a,
    ]
}

/// `usize`, whose results stay below 2³².
pub fn sizes(id: u32, ints: &[u32], _floats: &[f32]) -> [u32; 4] {
    let (a, b) = (
        uint(id, ints, 0) as usize % 5000,
        uint(id, ints, 1) as usize % 5000,
    );
    let mut n = a * 3 + b / 2;
    n += 1;
    [
        n as u32,
        a.min(b) as u32,
        a.saturating_sub(b) as u32,
        (a % (b + 1)).max(2) as u32,
    ]
}
