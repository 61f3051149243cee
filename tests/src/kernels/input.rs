//! Shared file: the random values of one element, and a way to fold integers into one word.

/// Integers, and floats, that each element has.
pub const PER_ELEMENT: u32 = 8;

/// The `k`-th integer of element `id`.
#[inline]
pub fn uint(id: u32, ints: &[u32], k: u32) -> u32 {
    ints[(id * PER_ELEMENT + k) as usize]
}

/// The same as a signed integer.
#[inline]
pub fn int(id: u32, ints: &[u32], k: u32) -> i32 {
    uint(id, ints, k) as i32
}

/// The `k`-th float of element `id`, within ±10.
#[inline]
pub fn float(id: u32, floats: &[f32], k: u32) -> f32 {
    floats[(id * PER_ELEMENT + k) as usize]
}

/// Folds `value` into `state` so that neither a value nor its place can be lost.
#[must_use]
pub fn mix(state: u32, value: u32) -> u32 {
    let mut s = state ^ value.wrapping_mul(0x9E37_79B9);
    s = (s ^ (s >> 16)).wrapping_mul(0x85EB_CA6B);
    s.rotate_left(13).wrapping_add(0x27D4_EB2F)
}

/// A generator with state, for tests of the order in which things happen.
#[derive(Clone, Copy, Debug)]
pub struct Counter {
    /// The state.
    pub state: u32,
}

impl Counter {
    /// The next value: every call changes what all later calls give.
    pub fn next(&mut self) -> u32 {
        self.state = self
            .state
            .wrapping_mul(1_664_525)
            .wrapping_add(1_013_904_223);
        self.state >> 8
    }
}
