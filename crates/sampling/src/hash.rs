//! Shared file: integer hashes, to make streams of a (seed, frame, pixel) and to scramble.

use glam::UVec4;

/// A bijective hash of one word, `lowbias32` (Wellons 2018, hash-prospector) on `n` with some bits flipped, so that
/// zero does not stay zero.
///
/// ```
/// use glimt_sampling::hash::hash_u32;
/// assert_ne!(hash_u32(0), 0);
/// assert_ne!(hash_u32(1) ^ hash_u32(0), 1);
/// ```
#[inline]
#[must_use]
pub fn hash_u32(n: u32) -> u32 {
    let mut x = n ^ 0xe6fe_3beb;
    x ^= x >> 16;
    x = x.wrapping_mul(0x7feb_352d);
    x ^= x >> 15;
    x = x.wrapping_mul(0x846c_a68b);
    x ^ (x >> 16)
}

/// A hash of two words, in order: `hash2(a, b)` and `hash2(b, a)` differ. A bijection in each of its arguments.
#[inline]
#[must_use]
pub fn hash2(a: u32, b: u32) -> u32 {
    hash_u32(hash_u32(a).wrapping_add(b))
}

/// A hash of three words, in order. A bijection in each of its arguments.
#[inline]
#[must_use]
pub fn hash3(a: u32, b: u32, c: u32) -> u32 {
    hash_u32(hash2(a, b).wrapping_add(c))
}

/// A bijection of four words in which each depends on all: PCG4D (Jarzynski and Olano 2020).
///
/// Differs from the paper in that each word first goes through [`hash_u32`] and at the end through one more xorshift:
/// without, the highest bits of the input hardly reach the lowest ones of the output, which are those of one product.
///
/// ```
/// use glam::UVec4;
/// use glimt_sampling::hash::hash_uvec4;
/// assert_ne!(hash_uvec4(UVec4::ZERO), hash_uvec4(UVec4::W));
/// ```
#[inline]
#[must_use]
pub fn hash_uvec4(v: UVec4) -> UVec4 {
    let mut x = hash_u32(v.x)
        .wrapping_mul(1_664_525)
        .wrapping_add(1_013_904_223);
    let mut y = hash_u32(v.y)
        .wrapping_mul(1_664_525)
        .wrapping_add(1_013_904_223);
    let mut z = hash_u32(v.z)
        .wrapping_mul(1_664_525)
        .wrapping_add(1_013_904_223);
    let mut w = hash_u32(v.w)
        .wrapping_mul(1_664_525)
        .wrapping_add(1_013_904_223);
    // Each line is a bijection of the four: a word changes by a function of the others.
    x = x.wrapping_add(y.wrapping_mul(w));
    y = y.wrapping_add(z.wrapping_mul(x));
    z = z.wrapping_add(x.wrapping_mul(y));
    w = w.wrapping_add(y.wrapping_mul(z));
    x ^= x >> 16;
    y ^= y >> 16;
    z ^= z >> 16;
    w ^= w >> 16;
    x = x.wrapping_add(y.wrapping_mul(w));
    y = y.wrapping_add(z.wrapping_mul(x));
    z = z.wrapping_add(x.wrapping_mul(y));
    w = w.wrapping_add(y.wrapping_mul(z));
    UVec4::new(x ^ (x >> 16), y ^ (y >> 16), z ^ (z >> 16), w ^ (w >> 16))
}
