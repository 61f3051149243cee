//! Host file: `rand_core`'s traits for the generator, so that it serves wherever the `rand` crates do.

use core::convert::Infallible;

use glam::UVec4;
use rand_core::{SeedableRng, TryRng, utils};

use crate::uniform::UniformSource;
use crate::xoshiro::Xoshiro128PlusPlus;

/// ```
/// use glimt_sampling::Xoshiro128PlusPlus;
/// use rand_core::{Rng, SeedableRng};
/// let mut generator = Xoshiro128PlusPlus::seed_from_u64(7);
/// let _: u64 = generator.next_u64();
/// ```
impl TryRng for Xoshiro128PlusPlus {
    type Error = Infallible;

    #[inline]
    fn try_next_u32(&mut self) -> Result<u32, Infallible> {
        Ok(UniformSource::next_u32(self))
    }

    #[inline]
    fn try_next_u64(&mut self) -> Result<u64, Infallible> {
        utils::next_u64_via_u32(self)
    }

    #[inline]
    fn try_fill_bytes(&mut self, dst: &mut [u8]) -> Result<(), Infallible> {
        utils::fill_bytes_via_next_word(dst, || self.try_next_u32())
    }
}

/// The seed's sixteen bytes are the state, little-endian; a single `u64` is drawn out to them by SplitMix64 (Steele, Lea,
/// Flood 2014), as its authors advise for this generator. Both as the crate `rand_xoshiro` has it.
impl SeedableRng for Xoshiro128PlusPlus {
    type Seed = [u8; 16];

    fn from_seed(seed: [u8; 16]) -> Self {
        let words: [u32; 4] = utils::read_words(&seed);
        Xoshiro128PlusPlus::from_state(UVec4::from_array(words))
    }

    fn seed_from_u64(seed: u64) -> Self {
        let mut counter = seed;
        let mut split = || {
            counter = counter.wrapping_add(0x9e37_79b9_7f4a_7c15);
            let mut z = counter;
            z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
            z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
            z ^ (z >> 31)
        };
        let (xy, zw) = (split(), split());
        Xoshiro128PlusPlus::from_state(UVec4::new(
            xy as u32,
            (xy >> 32) as u32,
            zw as u32,
            (zw >> 32) as u32,
        ))
    }
}
