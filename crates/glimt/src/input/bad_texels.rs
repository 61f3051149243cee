//! Host file: texels of a light that are not radiance, counted by what is wrong with them, and repaired.

use glam::{Vec3, Vec4};
use glimt_render_gpu::prepare::env::MAX_RADIANCE;
use rayon::prelude::*;

/// The largest number of 16 bits.
const HALF_MAX: f32 = 65_504.0;

/// Texels that are not radiance, by what is wrong with them. A texel counts once, for the first of these.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize)]
pub struct BadTexels {
    /// With a channel that is not a number.
    pub nan: usize,
    /// With an infinite channel.
    pub infinite: usize,
    /// With a channel above the largest radiance that the renderer takes, or as far below 0.
    pub huge: usize,
    /// With a negative channel.
    pub negative: usize,
}

impl BadTexels {
    /// Counts them.
    pub fn count(texels: &[Vec4]) -> Self {
        let parts = texels.par_chunks(1 << 16);
        let counts = parts.map(|part| part.iter().fold(Self::default(), Self::and));
        counts.reduce(Self::default, Self::plus)
    }

    /// With one texel more.
    fn and(mut self, texel: &Vec4) -> Self {
        // Almost all are.
        let is_light = texel.cmpge(Vec4::ZERO) & texel.cmple(Vec4::splat(MAX_RADIANCE));
        if is_light.all() {
            return self;
        }
        let colour = texel.truncate();
        if colour.is_nan() {
            self.nan += 1;
        } else if !colour.is_finite() {
            self.infinite += 1;
        } else if colour.abs().max_element() > MAX_RADIANCE {
            self.huge += 1;
        } else if colour.min_element() < 0.0 {
            self.negative += 1;
        }
        self
    }

    fn plus(self, other: Self) -> Self {
        Self {
            nan: self.nan + other.nan,
            infinite: self.infinite + other.infinite,
            huge: self.huge + other.huge,
            negative: self.negative + other.negative,
        }
    }

    /// Counts them and makes all channels finite and at most 1e20: NaN and what is beyond become 0. Infinity says that a number was too large for the file's 16 bits:
    /// it becomes 65504, the largest of these, or the channel's largest finite value where that is larger.
    pub fn repair(texels: &mut [Vec4]) -> Self {
        let bad = Self::count(texels);
        if bad.nan + bad.infinite + bad.huge == 0 {
            return bad;
        }
        let light = |texel: &Vec4| {
            let is_light = texel.cmple(Vec4::splat(MAX_RADIANCE));
            Vec4::select(is_light, *texel, Vec4::ZERO)
        };
        let largest = texels
            .par_iter()
            .map(light)
            .reduce(|| Vec4::splat(HALF_MAX), Vec4::max);
        // Far below zero is as bad as far above, but nothing writes such values.
        let repaired = |value: f32, most: f32| match value {
            f32::INFINITY => most,
            value if value.abs() <= MAX_RADIANCE => value,
            _ => 0.0,
        };
        texels.par_iter_mut().for_each(|texel| {
            let channels = [0, 1, 2].map(|c| repaired(texel[c], largest[c]));
            *texel = Vec3::from(channels).extend(1.0);
        });
        bad
    }

    /// What becomes of them, for messages.
    pub fn workaround(self) -> &'static str {
        match (self.infinite, self.total()) {
            (0, _) => "those channels are taken as 0",
            (infinite, all) if infinite == all => {
                "those channels are taken as 65504, or as the largest finite value where that is larger"
            }
            _ => {
                "infinite channels are taken as 65504, or as the largest finite value where that is larger, all others are taken as 0"
            }
        }
    }

    /// All of them.
    pub fn total(self) -> usize {
        self.nan + self.infinite + self.huge + self.negative
    }
}

impl std::fmt::Display for BadTexels {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let parts = [
            (self.nan, "NaN"),
            (self.infinite, "infinite"),
            (self.huge, "beyond 1e20"),
            (self.negative, "negative"),
        ];
        let words: Vec<String> = parts
            .iter()
            .filter(|(n, _)| *n > 0)
            .map(|(n, name)| format!("{n} {name}"))
            .collect();
        f.write_str(&words.join(", "))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bad_texels_are_told_apart() {
        let texels = [
            Vec4::ONE,
            Vec4::new(f32::NAN, 0.0, 0.0, 1.0),
            Vec4::new(0.0, f32::INFINITY, 0.0, 1.0),
            Vec4::new(0.0, -1.0, 0.0, 1.0),
        ];
        let bad = BadTexels::count(&texels);
        assert_eq!(bad.total(), 3);
        assert_eq!(bad.to_string(), "1 NaN, 1 infinite, 1 negative");
    }

    #[test]
    fn an_overflow_is_at_least_the_largest_half() {
        let mut texels = [
            Vec4::new(1.0, 7e4, f32::NAN, 1.0),
            Vec4::new(f32::INFINITY, f32::INFINITY, -2.0, 1.0),
            Vec4::new(f32::NEG_INFINITY, 1e30, 3.0, 1.0),
        ];
        let bad = BadTexels::repair(&mut texels);
        assert_eq!(bad.to_string(), "1 NaN, 2 infinite");
        assert_eq!(texels[0], Vec4::new(1.0, 7e4, 0.0, 1.0));
        assert_eq!(texels[1], Vec4::new(65_504.0, 7e4, -2.0, 1.0));
        // What is beyond all light on either side is a mistake.
        assert_eq!(texels[2], Vec4::new(0.0, 0.0, 3.0, 1.0));
    }

    #[test]
    fn what_is_far_below_zero_is_repaired_where_nothing_else_is_bad() {
        let mut texels = [Vec4::new(1.0, -1e30, -2.0, 1.0)];
        let bad = BadTexels::repair(&mut texels);
        assert_eq!((bad.huge, bad.total()), (1, 1));
        assert_eq!(texels[0], Vec4::new(1.0, 0.0, -2.0, 1.0));
    }
}
