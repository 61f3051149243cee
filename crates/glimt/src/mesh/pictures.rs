//! Host file: pictures that mesh files name, as textures.

use super::contents::find;
use super::model::Model;
use crate::notes::Notes;
use glam::{UVec2, Vec3};
use glimt_render_gpu::prepare::scene::{Texture, Wrap};
use image::{ImageReader, RgbaImage};
use std::collections::HashMap;
use std::path::{Path, PathBuf};

/// What is made of a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Use {
    /// A colour, encoded as sRGB.
    Colour,
    /// Data.
    Data,
    /// Its share of light that is stopped, in alpha: that of its alpha channel, or its luminance if it has none.
    Alpha,
    /// The share that passes, in the same way.
    Transparency,
    /// A tangent-space normal map of the heights that it shows. White lies `f32::from_bits` of this in texels above black.
    Heights(u32),
}

/// Reads the pictures of one file, each once for each use.
pub struct Pictures<'a> {
    /// The file that names them.
    pub file: &'a Path,
    /// Where textures and names of files go.
    pub model: &'a mut Model,
    /// Where is said what cannot be read.
    pub notes: &'a mut Notes,
    known: HashMap<(PathBuf, Use, bool), u32>,
}

impl<'a> Pictures<'a> {
    /// None are read yet.
    pub fn new(file: &'a Path, model: &'a mut Model, notes: &'a mut Notes) -> Self {
        let known = HashMap::new();
        Self {
            file,
            model,
            notes,
            known,
        }
    }

    fn locate(&self, name: &str) -> Option<PathBuf> {
        // Some programs mean the folder of the mesh, wherever the material library lies.
        let mesh = self.model.files.first().map(PathBuf::as_path);
        let folders = [Some(self.file), mesh].into_iter().flatten();
        let mut folders = folders.filter_map(Path::parent);
        folders.find_map(|folder| find(folder, name))
    }

    /// The pixels of a picture; a warning and `None` if it cannot be read.
    pub fn read(&mut self, name: &str) -> Option<(PathBuf, RgbaImage)> {
        let Some(path) = self.locate(name) else {
            let what = format!("its picture {name} is missing; left out");
            self.notes.warn(self.file, what);
            return None;
        };
        let read = || -> image::ImageResult<_> {
            ImageReader::open(&path)?.with_guessed_format()?.decode()
        };
        match read() {
            Ok(picture) => {
                if !self.model.files.contains(&path) {
                    self.model.files.push(path.clone());
                }
                Some((path, picture.into_rgba8()))
            }
            Err(e) => {
                let what = format!("{} cannot be read ({e}); left out", path.display());
                self.notes.warn(self.file, what);
                None
            }
        }
    }

    /// The index of a picture as a texture.
    pub fn texture(&mut self, name: &str, usage: Use, clamp: bool) -> Option<u32> {
        let key = (PathBuf::from(name), usage, clamp);
        if let Some(index) = self.known.get(&key) {
            return Some(*index);
        }
        let (_, picture) = self.read(name)?;
        let wrap = if clamp { Wrap::Clamp } else { Wrap::Repeat };
        let made = match usage {
            Use::Colour | Use::Data => picture,
            Use::Alpha => alpha(picture, false),
            Use::Transparency => alpha(picture, true),
            Use::Heights(bump) => slopes(&picture, f32::from_bits(bump), wrap),
        };
        let index = self.push(made, usage == Use::Colour, wrap);
        self.known.insert(key, index);
        Some(index)
    }

    /// Adds a texture, and returns its index.
    pub fn push(&mut self, picture: RgbaImage, srgb: bool, wrap: Wrap) -> u32 {
        self.model.textures.push(Texture {
            size: UVec2::new(picture.width(), picture.height()),
            texels: picture.pixels().map(|p| p.0).collect(),
            srgb,
            wrap: [wrap; 2],
        });
        self.model.textures.len() as u32 - 1
    }
}

/// Whether a picture is a normal map rather than heights: heights are grey, and normals are mostly along +z, which is blue.
pub fn is_normal_map(picture: &RgbaImage) -> bool {
    let mut sum = Vec3::ZERO;
    for pixel in picture.pixels() {
        let [r, g, b, _] = pixel.0.map(f32::from);
        sum += Vec3::new(r, g, b);
    }
    let count = picture.width() as f32 * picture.height() as f32;
    let mean = sum / count.max(1.0);
    let is_middle = |c: f32| (c - 127.5).abs() < 32.0;
    mean.z > 160.0 && is_middle(mean.x) && is_middle(mean.y)
}

fn alpha(mut picture: RgbaImage, inverted: bool) -> RgbaImage {
    let has_alpha = picture.pixels().any(|p| p.0[3] != 255);
    for pixel in picture.pixels_mut() {
        let share = if has_alpha { pixel.0[3] } else { luma(pixel.0) };
        pixel.0[3] = if inverted { 255 - share } else { share };
    }
    picture
}

/// The luminance of a texel that holds data.
fn luma([r, g, b, _]: [u8; 4]) -> u8 {
    glimt_sampling::math::luminance(Vec3::new(r.into(), g.into(), b.into())).round() as u8
}

/// The normal map of heights, by differences of neighbours. Its y points up in the picture.
fn slopes(picture: &RgbaImage, bump: f32, wrap: Wrap) -> RgbaImage {
    let (width, height) = (picture.width() as i64, picture.height() as i64);
    let inside = |i: i64, n: i64| match wrap {
        Wrap::Clamp => i.clamp(0, n - 1),
        _ => i.rem_euclid(n),
    };
    let at = |x: i64, y: i64| {
        let pixel = picture.get_pixel(inside(x, width) as u32, inside(y, height) as u32);
        f32::from(luma(pixel.0)) / 255.0 * bump
    };
    RgbaImage::from_fn(picture.width(), picture.height(), |x, y| {
        let (x, y) = (i64::from(x), i64::from(y));
        let along_x = 0.5 * (at(x + 1, y) - at(x - 1, y));
        let along_y = 0.5 * (at(x, y - 1) - at(x, y + 1));
        let normal = Vec3::new(-along_x, -along_y, 1.0).normalize();
        let code = ((0.5 * normal + 0.5) * 255.0).round();
        image::Rgba([code.x as u8, code.y as u8, code.z as u8, 255])
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slopes_of_heights() {
        // A ramp that rises by 1/16 of white a texel to the right, and wraps at its edges; of bump 4.
        let ramp = RgbaImage::from_fn(17, 3, |x, _| {
            let code = (255.0 * x as f32 / 16.0).round() as u8;
            image::Rgba([code, code, code, 255])
        });
        let map = slopes(&ramp, 4.0, Wrap::Clamp);
        let decoded =
            |x| Vec3::from([0, 1, 2].map(|c| f32::from(map.get_pixel(x, 1).0[c]))) / 127.5 - 1.0;
        let exact = Vec3::new(-0.25, 0.0, 1.0).normalize();
        assert!(decoded(8).abs_diff_eq(exact, 0.01), "{}", decoded(8));
        // At a clamped edge half as steep, at a repeated one the other way.
        let half = Vec3::new(-0.125, 0.0, 1.0).normalize();
        assert!(decoded(0).abs_diff_eq(half, 0.01), "{}", decoded(0));
        let wrapped = slopes(&ramp, 4.0, Wrap::Repeat);
        assert!(wrapped.get_pixel(0, 1).0[0] > 200);
        // Heights that grow upwards in the picture: y of the normal points down.
        let up = slopes(&image::imageops::rotate270(&ramp), 4.0, Wrap::Clamp);
        let y = f32::from(up.get_pixel(1, 8).0[1]) / 127.5 - 1.0;
        assert!((y - exact.x).abs() < 0.01, "{y}");
        assert!(is_normal_map(&map) && !is_normal_map(&ramp));
    }

    #[test]
    fn alpha_of_a_picture() {
        let grey = RgbaImage::from_pixel(1, 1, image::Rgba([100, 100, 100, 255]));
        assert_eq!(alpha(grey.clone(), false).get_pixel(0, 0).0[3], 100);
        assert_eq!(alpha(grey, true).get_pixel(0, 0).0[3], 155);
        let clear = RgbaImage::from_pixel(1, 1, image::Rgba([100, 100, 100, 7]));
        assert_eq!(alpha(clear, false).get_pixel(0, 0).0[3], 7);
    }
}
