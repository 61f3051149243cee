//! Shared file: the uniform numbers of a ray, by one of three sample patterns.

use glam::{UVec2, UVec3, UVec4};
use glimt_sampling::hash::{hash_u32, hash2, hash3};
use glimt_sampling::sobol::OwenSobol;
use glimt_sampling::uniform::UniformSource;
use glimt_sampling::xoshiro::Xoshiro128PlusPlus;

use super::frame::Pattern;

/// What uniforms are for: the ray's place in the pixel.
pub const FILM: u32 = 1;
/// What uniforms are for: BRDF samples.
pub const BRDF: u32 = 2;
/// What uniforms are for: environment samples.
pub const ENVIRONMENT: u32 = 3;

/// What uniforms are for: candidates from the BRDF.
pub const CANDIDATE_BRDF: u32 = 4;
/// What uniforms are for: candidates from the environment.
pub const CANDIDATE_ENVIRONMENT: u32 = 5;
/// What uniforms are for: picking among candidates.
pub const RESAMPLE: u32 = 6;
/// What uniforms are for: leading particles from one frame to the next.
pub const PARTICLES: u32 = 7;
/// What uniforms are for: the camera's way through surfaces that let light pass.
pub const SEEN_THROUGH: u32 = 8;
/// What uniforms are for: that of shadow rays.
pub const LIT_THROUGH: u32 = 9;
/// What uniforms are for: directions by cells of the light, and the members of a group that look there.
pub const CELLS: u32 = 10;
/// What uniforms are for: directions by the lobes of a group's members.
pub const LOBE: u32 = 11;
/// What uniforms are for: how many samples a group takes, and by which technique.
pub const COUNT: u32 = 12;
/// What uniforms are for: directions of pilot rays.
pub const PILOT: u32 = 13;
/// What uniforms are for: the way of pilot rays through surfaces that let light pass.
pub const PILOT_THROUGH: u32 = 14;
/// What uniforms are for: the frames in which it is a ray's turn to start particles.
pub const TURN: u32 = 15;

/// The pattern of one pixel, as one of its rays sees it.
///
/// The n samples that each of R rays takes for one purpose are spread together over all R n; purposes are independent
/// of each other, and so are pixels, frames and seeds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PixelPattern {
    /// Where its uniforms come from.
    pub kind: Pattern,
    /// First key.
    pub seed: u32,
    /// Second key.
    pub frame: u32,
    /// Third key: the index of the pixel in the image.
    pub pixel: u32,
    /// Which of the pixel's rays.
    pub ray: u32,
    /// Rays per pixel.
    pub rays: u32,
}

impl PixelPattern {
    /// Two uniform words for sample `sample` of the ray's `samples` for a purpose.
    #[inline]
    #[must_use]
    pub fn pair(&self, purpose: u32, sample: u32, samples: u32) -> UVec2 {
        let index = self.ray * samples + sample;
        if self.kind == Pattern::OwenSobol {
            return self.sobol_point(purpose, index).next_uvec2();
        }
        let jitter = self.generator(purpose, index).next_uvec2();
        if self.kind == Pattern::Independent {
            return jitter;
        }
        jittered_pair(index, self.rays * samples, jitter, self.key(purpose))
    }

    /// The two words of [`PixelPattern::pair`], and a third one.
    #[inline]
    #[must_use]
    pub fn triple(&self, purpose: u32, sample: u32, samples: u32) -> UVec3 {
        let index = self.ray * samples + sample;
        let words = self.point_triple(purpose, index);
        if self.kind != Pattern::Stratified {
            return words;
        }
        let (jitter, single) = (words.truncate(), words.z);
        let (count, key) = (self.rays * samples, self.key(purpose));
        jittered_pair(index, count, jitter, key).extend(jittered(index, count, single, key))
    }

    /// As many uniform words as are wanted for a purpose: the dimensions of one point, of which each ray of the pixel has
    /// one; or a generator of the ray's own, where the pattern has no points.
    #[inline]
    #[must_use]
    pub fn source(&self, purpose: u32) -> PatternSource {
        self.point(purpose, self.ray)
    }

    /// As many uniform words as are wanted for point `index` of the pixel's for a purpose, whichever of its rays asks: its dimensions,
    /// or a generator of the point's own, where the pattern has no points.
    #[inline]
    #[must_use]
    pub fn point(&self, purpose: u32, index: u32) -> PatternSource {
        PatternSource {
            is_sobol: self.kind == Pattern::OwenSobol,
            point: self.sobol_point(purpose, index),
            generator: self.generator(purpose, index),
        }
    }

    /// The first three words of [`PixelPattern::point`].
    #[inline]
    #[must_use]
    pub fn point_triple(&self, purpose: u32, index: u32) -> UVec3 {
        if self.kind == Pattern::OwenSobol {
            let mut point = self.sobol_point(purpose, index);
            let pair = point.next_uvec2();
            return pair.extend(point.next_u32());
        }
        let mut generator = self.generator(purpose, index);
        let pair = generator.next_uvec2();
        pair.extend(generator.next_u32())
    }

    /// The [key](super::ray::Ray::key) of rays for a purpose: of this ray, the number is its own for each ray that it sends out. Keys of
    /// neighbouring numbers are neighbours.
    #[inline]
    #[must_use]
    pub fn ray_key(&self, purpose: u32) -> u32 {
        hash2(self.key(purpose), self.ray)
    }

    #[inline]
    fn sobol_point(&self, purpose: u32, index: u32) -> OwenSobol {
        OwenSobol::new(hash2(self.seed, purpose), self.frame, self.pixel, index)
    }

    #[inline]
    fn generator(&self, purpose: u32, index: u32) -> Xoshiro128PlusPlus {
        Xoshiro128PlusPlus::stream(hash3(self.seed, purpose, index), self.frame, self.pixel)
    }

    #[inline]
    fn key(&self, purpose: u32) -> u32 {
        hash3(hash2(self.seed, purpose), self.frame, self.pixel)
    }
}

/// A stream of words from a pattern.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PatternSource {
    /// Whether the words are the point's and not the generator's.
    is_sobol: bool,
    point: OwenSobol,
    generator: Xoshiro128PlusPlus,
}

impl PatternSource {
    /// The generator's state, by which two processors' streams are compared.
    #[inline]
    #[must_use]
    pub fn generator_state(&self) -> UVec4 {
        self.generator.state
    }
}

impl UniformSource for PatternSource {
    #[inline]
    fn next_u32(&mut self) -> u32 {
        if self.is_sobol {
            self.point.next_u32()
        } else {
            self.generator.next_u32()
        }
    }

    #[inline]
    fn next_uvec2(&mut self) -> UVec2 {
        if self.is_sobol {
            self.point.next_uvec2()
        } else {
            self.generator.next_uvec2()
        }
    }
}

/// Point `index` of `count` points, jittered in the cells of a grid that is as square as `count` allows, with the
/// columns' and rows' own strata shuffled (Kensler 2013, "Correlated multi-jittered sampling", for any `count`).
#[inline]
fn jittered_pair(index: u32, count: u32, jitter: UVec2, key: u32) -> UVec2 {
    let columns = (libm::sqrtf(count as f32) as u32).max(1);
    let rows = count.div_ceil(columns);
    let s = permute(index, count, hash2(key, 1));
    let column = permute(s % columns, columns, hash2(key, 2));
    let row = permute(s / columns, rows, hash2(key, 3));
    UVec2::new(
        stratum(column * rows + row, columns * rows, jitter.x),
        stratum(s, count, jitter.y),
    )
}

/// Word `index` of `count` words, one in each stratum.
#[inline]
fn jittered(index: u32, count: u32, jitter: u32, key: u32) -> u32 {
    stratum(permute(index, count, hash2(key, 4)), count, jitter)
}

/// A word in stratum `cell` of `count` equal ones.
#[inline]
fn stratum(cell: u32, count: u32, jitter: u32) -> u32 {
    cell * (u32::MAX / count) + jitter / count
}

/// Where `index` goes in the permutation of `0..length` that `key` picks: a bijection of the next power of two, walked
/// until it comes back below `length`, and then a rotation.
///
/// The rotation makes every place equally likely for every index, which the bijections of a few bits do not.
#[inline]
fn permute(index: u32, length: u32, key: u32) -> u32 {
    if length <= 1 {
        return 0;
    }
    let bits = u32::BITS - (length - 1).leading_zeros();
    let mask = u32::MAX >> (u32::BITS - bits);
    let mut x = index;
    loop {
        let mut round_key = key;
        for _ in 0..3 {
            round_key = hash_u32(round_key);
            // Each step is a bijection of the low bits.
            x = (x ^ round_key).wrapping_mul(0x9e37_79b1) & mask;
            x ^= x >> bits.div_ceil(2);
        }
        if x < length {
            return (x + hash_u32(!key) % length) % length;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn permutations_are_permutations() {
        for length in [1, 2, 3, 15, 16, 17, 1000] {
            for key in 0..8 {
                let mut seen = [false; 1000];
                for i in 0..length {
                    let p = permute(i, length, hash_u32(key)) as usize;
                    assert!(p < length as usize && !seen[p]);
                    seen[p] = true;
                }
            }
        }
    }

    #[test]
    fn every_stratum_of_a_pixel_gets_one_point() {
        let (rays, samples) = (5, 3);
        let mut seen = [UVec3::ZERO; 15];
        for ray in 0..rays {
            let pattern = PixelPattern {
                kind: Pattern::Stratified,
                seed: 7,
                frame: 1,
                pixel: 99,
                ray,
                rays,
            };
            for sample in 0..samples {
                let u = pattern.triple(BRDF, sample, samples) / (u32::MAX / 15);
                seen[u.y as usize].y += 1;
                seen[u.z as usize].z += 1;
                // Three columns of five.
                seen[u.x as usize].x += 1;
            }
        }
        assert_eq!(seen, [UVec3::ONE; 15]);
    }
}
