//! Shared file: Owen-scrambled Sobol points by hashing (Burley 2020), born as `u32` and never rounded.
//!
//! Four dimensions of Sobol's sequence (Joe and Kuo 2008), and any number of them by padding: each set of four gets its
//! own scrambling and its own shuffling of the points, so that dimensions of one set are stratified together and those
//! of different sets are independent (Burley 2020, section 5). There are no tables, which a GPU would keep in slow
//! private memory: two dimensions are closed forms, the other two recurrences that live in registers.
//!
//! Words called *reversed* have their bits in reverse order: the lowest is worth one half.

use glam::UVec2;

use crate::hash::{hash_u32, hash2, hash3};
use crate::uniform::UniformSource;

/// Nested uniform (Owen) scrambling of a reversed word: a permutation in which each bit is flipped or not as a hash of
/// the bits below it says (Laine and Karras 2011, with Vegdahl's constants of 2021).
///
/// `scramble` picks the permutation and must itself be well mixed, as by [`hash_u32`].
#[inline]
#[must_use]
pub fn owen_scramble_reversed(n: u32, scramble: u32) -> u32 {
    let mut x = n ^ n.wrapping_mul(0x3d20_adea);
    x = x.wrapping_add(scramble);
    x = x.wrapping_mul((scramble >> 16) | 1);
    x ^= x.wrapping_mul(0x0552_6c56);
    x ^ x.wrapping_mul(0x53a2_2864)
}

/// Coordinate `dimension`, 0 to 3 (the higher bits are ignored), of point `index` of Sobol's sequence, reversed. Only
/// the low 16 bits of `index` count, so the sequence repeats after 2¹⁶ points.
///
/// Polynomials and initial numbers are the first four of Joe and Kuo's `new-joe-kuo-6`.
///
/// ```
/// use glimt_sampling::sobol::sobol_reversed;
/// let point = |i| [0, 1, 2, 3].map(|d| sobol_reversed(i, d).reverse_bits() as f32 / 4_294_967_296.0);
/// assert_eq!(point(1), [0.5, 0.5, 0.5, 0.5]);
/// assert_eq!(point(2), [0.25, 0.75, 0.75, 0.75]);
/// assert_eq!(point(4), [0.125, 0.625, 0.375, 0.125]);
/// ```
#[inline]
#[must_use]
pub fn sobol_reversed(index: u32, dimension: u32) -> u32 {
    let index = index & 0xffff;
    match dimension & 3 {
        // Van der Corput's sequence, which is the index itself.
        0 => index,
        1 => pascal(index),
        2 => recurrence_2(index),
        _ => recurrence_3(index),
    }
}

/// Dimension 1, whose direction numbers are Pascal's triangle modulo 2: a product of four sparse matrices.
#[inline]
fn pascal(index: u32) -> u32 {
    let mut x = index;
    x ^= (x >> 1) & 0x5555;
    x ^= (x >> 2) & 0x3333;
    x ^= (x >> 4) & 0x0f0f;
    x ^ ((x >> 8) & 0x00ff)
}

/// Dimension 2: polynomial x² + x + 1, initial numbers 1, 3.
#[inline]
fn recurrence_2(index: u32) -> u32 {
    let mut bits = index;
    let mut v0 = 1;
    let mut v1 = 3;
    let mut sum = 0;
    // Always as many turns, so that a compiler unrolls them and knows all v.
    for _ in 0..16 {
        sum ^= v0 & (bits & 1).wrapping_neg();
        let v2 = v1 ^ v0 ^ (v0 << 2);
        v0 = v1;
        v1 = v2;
        bits >>= 1;
    }
    sum
}

/// Dimension 3: polynomial x³ + x + 1, initial numbers 1, 3, 1 (here shifted to their places: 1, 3, 4).
#[inline]
fn recurrence_3(index: u32) -> u32 {
    let mut bits = index;
    let mut v0 = 1;
    let mut v1 = 3;
    let mut v2 = 4;
    let mut sum = 0;
    for _ in 0..16 {
        sum ^= v0 & (bits & 1).wrapping_neg();
        let v3 = v1 ^ v0 ^ (v0 << 3);
        v0 = v1;
        v1 = v2;
        v2 = v3;
        bits >>= 1;
    }
    sum
}

/// Where point `index` stands in the sequence that `seed` shuffles. Every aligned block of 2ᵏ points stays a block, so
/// that the first 2ᵏ samples of a pattern are a net.
#[inline]
fn shuffle(index: u32, seed: u32) -> u32 {
    owen_scramble_reversed(index.reverse_bits(), hash_u32(seed ^ 0x79c6_8e4a)).reverse_bits()
}

/// Owen's scrambling of a reversed coordinate, by a permutation of its own for every seed and dimension.
#[inline]
fn scramble(reversed: u32, dimension: u32, seed: u32) -> u32 {
    let salt = match dimension & 3 {
        0 => 0x912f_69ba,
        1 => 0x174f_18ab,
        2 => 0x691e_72ca,
        _ => 0xb40c_c1b8,
    };
    // The product keeps a seed that counts up from cancelling against the salt.
    let key = hash_u32(seed.wrapping_mul(0x9c8f_2d3b) ^ salt);
    owen_scramble_reversed(reversed, key).reverse_bits()
}

/// Coordinate `dimension`, 0 to 3, of point `index < 2¹⁶` of the Owen-scrambled, shuffled Sobol sequence that `seed`
/// picks, as a word: the coordinate in `[0, 1)` times 2³².
///
/// The top 23 bits are those of the crate `sobol_burley`, which gives no more.
///
/// ```
/// use glimt_sampling::sobol::owen_sobol;
/// // Four points, one in each quarter, whatever the seed.
/// let mut quarters = [0, 1, 2, 3].map(|i| owen_sobol(i, 1, 2026) >> 30);
/// quarters.sort();
/// assert_eq!(quarters, [0, 1, 2, 3]);
/// ```
#[inline]
#[must_use]
pub fn owen_sobol(index: u32, dimension: u32, seed: u32) -> u32 {
    scramble(
        sobol_reversed(shuffle(index, seed), dimension),
        dimension,
        seed,
    )
}

/// The coordinates of one point of a pixel's Owen-scrambled Sobol pattern, dimension after dimension.
///
/// Dimension `k` is dimension `k & 3` of the padded set `k >> 2`. The points `sample_index = 0, 1, 2, …` of one (seed,
/// frame, pixel) are stratified together; different keys are independent scramblings, and so is each further block of
/// 2¹⁶ points. Points of one pattern are *not* independent: a standard error comes from several seeds.
///
/// ```
/// use glimt_sampling::{OwenSobol, UniformSource};
/// // The mean of x over 16 points is within half a stratum of 1/2.
/// let mean: f64 = (0..16)
///     .map(|i| f64::from(OwenSobol::new(1, 0, 0, i).next_u32()) / 4_294_967_296.0 / 16.0)
///     .sum();
/// assert!((mean - 0.5).abs() < 1.0 / 32.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OwenSobol {
    /// Picks the scramblings and shufflings of all sets.
    seed: u32,
    /// Which point, below 2¹⁶.
    index: u32,
    /// The dimension that is drawn next.
    dimension: u32,
}

impl OwenSobol {
    /// Point `sample_index` of the pattern of one pixel of one frame under one seed, before its first dimension.
    #[inline]
    #[must_use]
    pub fn new(seed: u32, frame: u32, pixel: u32, sample_index: u32) -> OwenSobol {
        OwenSobol {
            seed: hash2(hash3(seed, frame, pixel), sample_index >> 16),
            index: sample_index & 0xffff,
            dimension: 0,
        }
    }
}

impl UniformSource for OwenSobol {
    #[inline]
    fn next_u32(&mut self) -> u32 {
        let dimension = self.dimension;
        self.dimension = dimension + 1;
        owen_sobol(self.index, dimension, hash2(self.seed, dimension >> 2))
    }

    /// Two dimensions of one set, 0 and 1 or 2 and 3: after an odd number of single draws one dimension is left out.
    #[inline]
    fn next_uvec2(&mut self) -> UVec2 {
        let dimension = (self.dimension + 1) & !1;
        self.dimension = dimension + 2;
        let seed = hash2(self.seed, dimension >> 2);
        let index = shuffle(self.index, seed);
        UVec2::new(
            scramble(sobol_reversed(index, dimension), dimension, seed),
            scramble(sobol_reversed(index, dimension + 1), dimension + 1, seed),
        )
    }
}
