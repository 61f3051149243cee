//! Shared file: the generator xoshiro128++ 1.0 (Blackman and Vigna 2021).

use glam::UVec4;

use crate::hash::hash_uvec4;
use crate::uniform::UniformSource;

/// xoshiro128++: 128 bits of state, period 2¹²⁸ − 1, four adds and a few shifts a draw.
///
/// ```
/// use glimt_sampling::{UniformSource, Xoshiro128PlusPlus};
/// use glam::UVec4;
/// let mut generator = Xoshiro128PlusPlus::from_state(UVec4::new(1, 2, 3, 4));
/// assert_eq!([generator.next_u32(), generator.next_u32()], [641, 1_573_767]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(C)]
pub struct Xoshiro128PlusPlus {
    /// The state; not all zero, or the generator stands still.
    pub state: UVec4,
}

impl Xoshiro128PlusPlus {
    /// A generator in the given state. All zeros, the one state that leads nowhere, counts as what `seed_from_u64(0)`
    /// gives.
    #[inline]
    #[must_use]
    pub fn from_state(state: UVec4) -> Xoshiro128PlusPlus {
        let any = state.x | state.y | state.z | state.w;
        if any == 0 {
            return Xoshiro128PlusPlus {
                state: UVec4::new(0x7b1d_cdaf, 0xe220_a839, 0xa1b9_65f4, 0x6e78_9e6a),
            };
        }
        Xoshiro128PlusPlus { state }
    }

    /// The stream of one pixel of one frame under one seed.
    ///
    /// The state is a bijective hash of the three, so different keys start in different states whatever the order in
    /// which pixels are rendered.
    ///
    /// ```
    /// use glimt_sampling::Xoshiro128PlusPlus;
    /// assert_ne!(Xoshiro128PlusPlus::stream(1, 0, 7), Xoshiro128PlusPlus::stream(1, 7, 0));
    /// ```
    #[inline]
    #[must_use]
    pub fn stream(seed: u32, frame: u32, pixel: u32) -> Xoshiro128PlusPlus {
        Xoshiro128PlusPlus::from_state(hash_uvec4(UVec4::new(pixel, frame, seed, 0x9e37_79b9)))
    }
}

impl UniformSource for Xoshiro128PlusPlus {
    #[inline]
    fn next_u32(&mut self) -> u32 {
        let s = self.state;
        let result = s.x.wrapping_add(s.w).rotate_left(7).wrapping_add(s.x);
        let z = s.z ^ s.x;
        let w = s.w ^ s.y;
        self.state = UVec4::new(s.x ^ w, s.y ^ z, z ^ (s.y << 9), w.rotate_left(11));
        result
    }
}
