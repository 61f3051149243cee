//! Host file: texels of a light that are not radiance, counted by what is wrong with them.

use glam::Vec4;
use glimt_render_gpu::prepare::env::MAX_RADIANCE;
use rayon::prelude::*;

/// Texels that are not radiance, by what is wrong with them. A texel counts once, for the first of these.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize)]
pub struct BadTexels {
    /// With a channel that is not a number.
    pub nan: usize,
    /// With an infinite channel.
    pub infinite: usize,
    /// With a channel above the largest radiance that the renderer takes.
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
        let colour = texel.truncate();
        if colour.is_nan() {
            self.nan += 1;
        } else if !colour.is_finite() {
            self.infinite += 1;
        } else if colour.max_element() > MAX_RADIANCE {
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
            (self.huge, "above 1e20"),
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
}
