//! Host file: mean and variance of images, pixel by pixel, and the file in which they wait for the next run.

use crate::error::{Error, Result};
use crate::output::atomic::Pending;
use crate::output::target::Target;
use glam::{UVec2, Vec4};
use glimt_sampling::luminance;
use serde::{Deserialize, Serialize, de::DeserializeOwned};
use std::io::Write;
use std::path::Path;

/// First bytes of the file.
const MAGIC: &[u8; 8] = b"glimtMO1";

/// Mean and squared deviations of independent images of one size (Welford 1962).
#[derive(Clone, Debug, PartialEq)]
pub struct Moments {
    /// Width and height.
    pub size: UVec2,
    /// Images so far.
    pub n: u32,
    /// Mean of red, green, blue and alpha.
    pub mean: Vec<Vec4>,
    /// Sums of squared deviations of red, green, blue and luminance.
    pub squares: Vec<Vec4>,
}

impl Moments {
    /// Of no image.
    #[must_use]
    pub fn new(size: UVec2) -> Self {
        let pixels = size.x as usize * size.y as usize;
        Self {
            size,
            n: 0,
            mean: vec![Vec4::ZERO; pixels],
            squares: vec![Vec4::ZERO; pixels],
        }
    }

    /// An image that is taken as it is, its noise unknown: its standard errors are 0.
    #[must_use]
    pub fn exact(size: UVec2, pixels: Vec<Vec4>) -> Self {
        let squares = vec![Vec4::ZERO; pixels.len()];
        Self {
            size,
            n: 1,
            mean: pixels,
            squares,
        }
    }

    /// Takes one more image of the same size.
    pub fn push(&mut self, image: &[Vec4]) {
        self.n += 1;
        let share = 1.0 / self.n as f32;
        let rest = 1.0 - share;
        let moments = self.mean.iter_mut().zip(&mut self.squares);
        for ((mean, squares), value) in moments.zip(image) {
            let delta = *value - *mean;
            *mean += delta * share;
            let delta = delta.truncate();
            let delta = delta.extend(luminance(delta));
            // Both deviations of Welford's product are multiples of the first.
            *squares += delta * delta * rest;
        }
    }

    /// Variance of the mean of a pixel: red, green, blue and luminance. 0 of one image alone.
    #[must_use]
    pub fn mean_variance(&self, pixel: usize) -> Vec4 {
        let n = self.n as f32;
        self.squares[pixel] / (n * (n - 1.0).max(1.0))
    }

    /// Variance of one image in a pixel, likewise.
    #[must_use]
    pub fn variance(&self, pixel: usize) -> Vec4 {
        self.squares[pixel] / (self.n as f32 - 1.0).max(1.0)
    }
}

/// What is stored beside the moments.
#[derive(Serialize, Deserialize)]
struct Header<T> {
    identity: String,
    n: u32,
    size: [u32; 2],
    /// Whether one of the images is stored, too.
    sample: bool,
    about: T,
}

/// Moments with what is known of the images that they are of.
#[derive(Clone, Debug)]
pub struct Kept<T> {
    /// The moments.
    pub moments: Moments,
    /// The first of the images, where it is kept.
    pub sample: Option<Vec<Vec4>>,
    /// Further knowledge.
    pub about: T,
}

impl<T: Serialize + DeserializeOwned> Kept<T> {
    /// Writes a file, whole or not at all.
    ///
    /// # Errors
    /// It cannot be written.
    pub fn write(&self, file: &Target, identity: &str) -> Result<()> {
        let header = Header {
            identity: identity.to_owned(),
            n: self.moments.n,
            size: self.moments.size.to_array(),
            sample: self.sample.is_some(),
            about: &self.about,
        };
        let header = serde_json::to_vec(&header).map_err(|e| Error::output(file.path(), e))?;
        let mut pending = Pending::create(file)?;
        let words = [
            &MAGIC[..],
            &(header.len() as u32).to_le_bytes(),
            &header,
            bytemuck::cast_slice(&self.moments.mean),
            bytemuck::cast_slice(&self.moments.squares),
            bytemuck::cast_slice(self.sample.as_deref().unwrap_or_default()),
        ];
        for bytes in words {
            pending.write_all(bytes).map_err(|e| pending.error(&e))?;
        }
        pending.commit()
    }

    /// Reads such a file; `None` if there is none, or one of another identity or size, or not all of it.
    #[must_use]
    pub fn read(file: &Path, identity: &str, size: UVec2) -> Option<Self> {
        let bytes = std::fs::read(file).ok()?;
        let rest = bytes.strip_prefix(MAGIC)?;
        let (len, rest) = rest.split_first_chunk::<4>()?;
        let (header, data) = rest.split_at_checked(u32::from_le_bytes(*len) as usize)?;
        let header: Header<T> = serde_json::from_slice(header).ok()?;
        if header.identity != identity || header.size != size.to_array() {
            return None;
        }
        let pixels = size.x as usize * size.y as usize;
        let images = if header.sample { 3 } else { 2 };
        if data.len() != images * pixels * size_of::<Vec4>() {
            return None;
        }
        let mut values = data.as_chunks::<16>().0.iter().map(|b| {
            let word = |i: usize| f32::from_le_bytes([b[i], b[i + 1], b[i + 2], b[i + 3]]);
            Vec4::new(word(0), word(4), word(8), word(12))
        });
        let mut image = || values.by_ref().take(pixels).collect::<Vec<_>>();
        let (mean, squares) = (image(), image());
        let sample = header.sample.then(image);
        Some(Self {
            moments: Moments {
                size,
                n: header.n,
                mean,
                squares,
            },
            sample,
            about: header.about,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::target::Guard;

    fn images() -> Vec<Vec<Vec4>> {
        let value = |i: u32, p: u32| ((i * 7 + p * 5) % 11) as f32;
        let pixel = |i, p| Vec4::new(value(i, p), value(i, p + 1), value(i + 2, p), 1.0);
        (0..9)
            .map(|i| (0..6).map(|p| pixel(i, p)).collect())
            .collect()
    }

    #[test]
    fn moments_are_those_of_two_passes() {
        let images = images();
        let mut moments = Moments::new(UVec2::new(3, 2));
        images.iter().for_each(|image| moments.push(image));
        for p in 0..6 {
            let n = images.len() as f32;
            let mean = images.iter().map(|i| i[p]).sum::<Vec4>() / n;
            assert!((moments.mean[p] - mean).abs().max_element() < 1e-5);
            let square = |v: Vec4| {
                let d = (v - mean).truncate();
                let d = d.extend(luminance(d));
                d * d
            };
            let variance = images.iter().map(|i| square(i[p])).sum::<Vec4>() / (n - 1.0);
            let off = (moments.variance(p) - variance).abs().max_element();
            assert!(off < 1e-4 * variance.max_element(), "{off}");
            let off = (moments.mean_variance(p) * n - variance)
                .abs()
                .max_element();
            assert!(off < 1e-4 * variance.max_element(), "{off}");
        }
    }

    #[test]
    fn a_file_is_itself_whole_or_nothing() {
        let folder = std::env::temp_dir().join(format!("glimt-moments-{}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        let file = folder.join("m.bin");
        let size = UVec2::new(3, 2);
        let mut moments = Moments::new(size);
        images().iter().for_each(|image| moments.push(image));
        let kept = Kept {
            moments,
            sample: Some(images().swap_remove(0)),
            about: vec![1u32, 2],
        };
        let target = Guard::default().target(&file).unwrap();
        kept.write(&target, "me").unwrap();
        let back = Kept::<Vec<u32>>::read(&file, "me", size).unwrap();
        assert_eq!(back.moments, kept.moments);
        assert_eq!(back.sample, kept.sample);
        assert_eq!(back.about, [1, 2]);
        assert!(Kept::<Vec<u32>>::read(&file, "you", size).is_none());
        assert!(Kept::<Vec<u32>>::read(&file, "me", UVec2::new(2, 3)).is_none());
        let whole = std::fs::read(&file).unwrap();
        for len in [0, 5, 40, whole.len() - 1] {
            std::fs::write(&file, &whole[..len]).unwrap();
            assert!(Kept::<Vec<u32>>::read(&file, "me", size).is_none(), "{len}");
        }
        std::fs::remove_dir_all(&folder).unwrap();
    }
}
