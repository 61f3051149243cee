//! Shared file: where uniform numbers come from, and the one rule that makes a float of a word.

use glam::{UVec2, Vec2};

/// A float in `[0, 1)` from a uniform word: its top 24 bits times 2⁻²⁴, so never 1, and exact on every processor.
///
/// ```
/// use glimt_sampling::uniform::unit_f32;
/// assert_eq!(unit_f32(0), 0.0);
/// assert_eq!(unit_f32(1 << 31), 0.5);
/// assert_eq!(unit_f32(u32::MAX), 1.0 - 1.0 / 16_777_216.0);
/// ```
#[inline]
#[must_use]
pub fn unit_f32(u: u32) -> f32 {
    (u >> 8) as f32 * (1.0 / 16_777_216.0)
}

/// A point of `[0, 1)²` from two uniform words, by [`unit_f32`].
#[inline]
#[must_use]
pub fn unit_vec2(u: UVec2) -> Vec2 {
    Vec2::new(unit_f32(u.x), unit_f32(u.y))
}

/// A stream of uniform words: a generator, or the coordinates of one point of a sample pattern.
pub trait UniformSource {
    /// The next word, uniform over all of `u32`.
    fn next_u32(&mut self) -> u32;

    /// The next two words. A pattern gives two that are stratified together, so a two-dimensional sample should be
    /// made of one such call, not of two draws.
    #[inline]
    fn next_uvec2(&mut self) -> UVec2 {
        let x = self.next_u32();
        let y = self.next_u32();
        UVec2::new(x, y)
    }
}
