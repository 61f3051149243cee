//! Host file: the light of a shot: its frames as lat-long maps that the renderer accepts.

use super::frames::FrameFiles;
use super::{HdrImage, read_header, read_image};
use crate::capture::photo::Photo;
use crate::capture::{Capture, Poses, locate, photo};
use crate::error::{Error, Result};
use crate::notes::Notes;
use crate::shot::digest::{Hash, join, of_file, of_text};
use crate::shot::{self, Mapping};
use glam::{UVec2, Vec2, Vec4};
use glimt_probe::gather::ColourMatrix;
use glimt_probe::{angular, latlong};
use glimt_render_gpu::host::env::{EnvMap, MAX_RADIANCE};
use glimt_render_gpu::host::unwarp::BallPose;
use rayon::prelude::*;
use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Texels that are no radiance, by what is wrong with them. A texel counts once, for the first of these.
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
        let mut bad = Self::default();
        for texel in texels {
            let colour = texel.truncate();
            if colour.is_nan() {
                bad.nan += 1;
            } else if !colour.is_finite() {
                bad.infinite += 1;
            } else if colour.max_element() > MAX_RADIANCE {
                bad.huge += 1;
            } else if colour.min_element() < 0.0 {
                bad.negative += 1;
            }
        }
        bad
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

/// The frames of a light probe, all of one size.
#[derive(Clone, Debug)]
pub struct Probe {
    files: FrameFiles,
    mapping: Mapping,
    scale: f32,
    size: UVec2,
    /// Where the ball is, in film of one.
    capture: Option<Arc<Capture>>,
    colour: ColourMatrix,
}

impl Probe {
    /// Checks the headers of all frames: that they are images, of one size, and fit the mapping. In film of a mirror ball,
    /// the ball is looked for in all that `shot` has, whichever are asked for: what is smoothed over a shot must not hang on which
    /// part of it is rendered. `progress` is told how many are done, and of how many.
    ///
    /// # Errors
    /// The first frame that is not as it should be.
    pub fn open(
        files: FrameFiles,
        frames: &[u32],
        shot: RangeInclusive<u32>,
        keys: &shot::Probe,
        notes: &mut Notes,
        progress: &(dyn Fn(usize, usize) + Sync),
    ) -> Result<Self> {
        let mapping = keys.mapping;
        let read_size = |file: &Path| match mapping {
            Mapping::MirrorBall => photo::read_size(file),
            _ => Ok(read_header(file)?.size),
        };
        let first = files.path(frames[0]);
        let size = read_size(&first)?;
        check_shape(mapping, size, &first, notes)?;
        let others = if files.is_still() { &[] } else { &frames[1..] };
        for &frame in others {
            let path = files.path(frame);
            check_size(&path, read_size(&path)?, size, &first)?;
        }
        let capture = match mapping {
            Mapping::MirrorBall => {
                let ball = keys.ball.clone().unwrap_or_default();
                let poses = match Poses::given(&ball) {
                    Some(given) => given,
                    None => {
                        let mut all = match files.is_still() {
                            true => frames.to_vec(),
                            false => files.existing()?,
                        };
                        all.retain(|frame| shot.contains(frame) || frames.contains(frame));
                        locate::poses(&files, &all, &ball, notes, progress)?
                    }
                };
                Some(Arc::new(Capture::new(&ball, poses)))
            }
            _ => None,
        };
        Ok(Self::new(files, keys, size, capture))
    }

    /// A probe whose images have this size.
    fn new(
        files: FrameFiles,
        keys: &shot::Probe,
        size: UVec2,
        capture: Option<Arc<Capture>>,
    ) -> Self {
        Self {
            files,
            mapping: keys.mapping,
            scale: keys.scale,
            size,
            capture,
            colour: ColourMatrix::IDENTITY,
        }
    }

    /// A probe that is still being filmed, by its first image; `pose` is where the mirror ball is in it, if it shows one.
    ///
    /// # Errors
    /// The image does not fit the mapping.
    pub fn live(
        files: FrameFiles,
        keys: &shot::Probe,
        first: &Path,
        size: UVec2,
        pose: Option<BallPose>,
        notes: &mut Notes,
    ) -> Result<Self> {
        check_shape(keys.mapping, size, first, notes)?;
        let ball = keys.ball.clone().unwrap_or_default();
        let capture = pose.map(|pose| Arc::new(Capture::new(&ball, Poses::Fixed(pose))));
        Ok(Self::new(files, keys, size, capture))
    }

    /// Sets how its colours are changed.
    pub fn set_colour(&mut self, colour: ColourMatrix) {
        self.colour = colour;
    }

    /// Film of a mirror ball, if it is.
    pub fn capture(&self) -> Option<&Arc<Capture>> {
        self.capture.as_ref()
    }

    /// Size of its images.
    pub fn size(&self) -> UVec2 {
        self.size
    }

    /// Whether every frame is the same image.
    pub fn is_still(&self) -> bool {
        self.files.is_still()
    }

    /// The file of a frame.
    pub fn file(&self, frame: u32) -> PathBuf {
        self.files.path(frame)
    }

    /// Hash of the file of each of these frames, and of where the ball is in it.
    ///
    /// # Errors
    /// A file cannot be read.
    pub fn digests(&self, frames: &[u32]) -> Result<Vec<Hash>> {
        let files = if self.files.is_still() {
            vec![of_file(&self.files.path(1))?; frames.len()]
        } else {
            let paths = frames.par_iter().map(|&frame| self.files.path(frame));
            paths.map(|path| of_file(&path)).collect::<Result<_>>()?
        };
        let with_pose = |(file, frame): (Hash, &u32)| self.digest_at(&file, self.pose(*frame));
        Ok(files.into_iter().zip(frames).map(with_pose).collect())
    }

    /// Hash of an image with this one, in which the ball is there.
    pub fn digest_at(&self, file: &Hash, pose: Option<BallPose>) -> Hash {
        // Both print so that they read back as the same numbers.
        join([file, &of_text(&format!("{pose:?} {:?}", self.colour))])
    }

    /// Where the ball is in a frame, in film of one.
    fn pose(&self, frame: u32) -> Option<BallPose> {
        self.capture.as_ref()?.poses().of(frame)
    }

    /// Reads the light of a frame.
    ///
    /// # Errors
    /// The file cannot be read, is broken, or has bad texels and `notes` is strict.
    pub fn load(&self, frame: u32, notes: &mut Notes) -> Result<EnvMap> {
        let file = self.files.path(frame);
        let image = read(self.mapping, &file, notes)?;
        self.light_of(image, &file, self.pose(frame), notes)
    }

    /// The light of an image that was read from `file`, in which the ball is at `pose`.
    ///
    /// # Errors
    /// It has another size than the probe, or does not hold the ball.
    pub fn light_of(
        &self,
        image: Photo,
        file: &Path,
        pose: Option<BallPose>,
        notes: &mut Notes,
    ) -> Result<EnvMap> {
        self.fits(file, image.size)?;
        let (size, mut texels) = match (&self.capture, pose) {
            (Some(capture), Some(pose)) => {
                let map = capture.map_at(&pose, file, image.size)?;
                let look = capture.look(&self.colour);
                (capture.size(), map.apply(&image.pixels, &look))
            }
            (Some(_), None) => {
                return Err(Error::input(file, "the ball was not looked for in it"));
            }
            (None, _) => self.map_of(image),
        };
        if self.scale != 1.0 {
            for texel in &mut texels {
                *texel = (*texel * self.scale).min(Vec4::splat(MAX_RADIANCE));
            }
        }
        if texels.iter().all(|t| t.truncate().max_element() <= 0.0) {
            notes.warn(file, "the map is black: it lights nothing");
        }
        EnvMap::new(size, texels).map_err(|e| Error::input(file, e))
    }

    /// Sees that an image is of the probe's size.
    ///
    /// # Errors
    /// It is not.
    pub fn fits(&self, file: &Path, size: UVec2) -> Result<()> {
        let all = self.files.folder().join(self.files.pattern());
        check_size(file, size, self.size, &all)
    }

    /// An image of all directions as a lat-long map.
    fn map_of(&self, image: Photo) -> (UVec2, Vec<Vec4>) {
        let (size, mut texels) = match self.mapping {
            Mapping::Angular => angular_to_latlong(image.size, &image.pixels),
            _ => (image.size, image.pixels),
        };
        if self.colour != ColourMatrix::IDENTITY {
            texels
                .par_iter_mut()
                .for_each(|texel| *texel = self.colour.apply(*texel));
        }
        (size, texels)
    }
}

/// Reads an image of a probe: a photograph of a mirror ball, or an image of all directions without its bad texels.
///
/// # Errors
/// The file cannot be read or is broken; or it has bad texels and `notes` is strict.
pub fn read(mapping: Mapping, file: &Path, notes: &mut Notes) -> Result<Photo> {
    if mapping == Mapping::MirrorBall {
        return photo::read(file, notes);
    }
    let HdrImage { header, mut texels } = read_image(file, notes)?;
    let bad = BadTexels::count(&texels);
    if bad.total() > 0 {
        let noun = if bad.total() == 1 {
            "texel is"
        } else {
            "texels are"
        };
        let what = format!("{} of {} {noun} no light: {bad}", bad.total(), texels.len());
        notes.defect(file, &what, "those channels are taken as 0")?;
        EnvMap::repair(&mut texels);
    }
    Ok(Photo {
        size: header.size,
        pixels: texels,
    })
}

/// Sees that an image can hold what its mapping says.
pub fn check_shape(mapping: Mapping, size: UVec2, file: &Path, notes: &mut Notes) -> Result<()> {
    match mapping {
        Mapping::Angular if size.x != size.y => Err(Error::input(
            file,
            format!(
                "an angular map is square, and this is {} × {}",
                size.x, size.y
            ),
        )
        .fix("crop it to the square around the disc, or set probe.mapping = \"lat-long\"")),
        Mapping::LatLong if size.x != 2 * size.y => {
            notes.note(
                file,
                format!(
                    "{} × {} is not 2:1; it is taken as a lat-long map all the same",
                    size.x, size.y
                ),
            );
            Ok(())
        }
        _ => Ok(()),
    }
}

/// Sees that a frame has the size of the first.
///
/// # Errors
/// It has not.
pub fn check_size(file: &Path, size: UVec2, wanted: UVec2, first: &Path) -> Result<()> {
    if size == wanted {
        return Ok(());
    }
    let what = format!(
        "it is {} × {}, but {} is {} × {}",
        size.x,
        size.y,
        first.display(),
        wanted.x,
        wanted.y
    );
    Err(Error::input(file, what).fix("all frames of a sequence must have one size: resize it"))
}

/// Taps along each side of a lat-long texel. Near the disc's rim many pixels fall into one texel; a lamp must not fall
/// between the taps.
const TAPS: u32 = 4;

/// Resamples a square angular map into a lat-long map of twice its width and of its height.
pub fn angular_to_latlong(size: UVec2, texels: &[Vec4]) -> (UVec2, Vec<Vec4>) {
    let out = UVec2::new(2 * size.x, size.x);
    let weight = 1.0 / (TAPS * TAPS) as f32;
    let texel = |index: u32| -> Vec4 {
        let corner = UVec2::new(index % out.x, index / out.x).as_vec2();
        let mut sum = Vec4::ZERO;
        for tap in 0..TAPS * TAPS {
            let inside = (UVec2::new(tap % TAPS, tap / TAPS).as_vec2() + 0.5) / TAPS as f32;
            let direction = latlong::uv_to_direction((corner + inside) / out.as_vec2());
            sum += bilinear_in_disc(size, texels, angular::direction_to_uv(direction));
        }
        (sum * weight).truncate().extend(1.0)
    };
    let map = (0..out.x * out.y).into_par_iter().map(texel).collect();
    (out, map)
}

/// Bilinear look-up that takes no part of the corners outside the disc, which show nothing.
fn bilinear_in_disc(size: UVec2, texels: &[Vec4], uv: Vec2) -> Vec4 {
    let p = uv * size.as_vec2() - 0.5;
    let low = p.floor();
    let f = p - low;
    let (mut sum, mut total) = (Vec4::ZERO, 0.0);
    for (dx, dy, w) in [
        (0.0, 0.0, (1.0 - f.x) * (1.0 - f.y)),
        (1.0, 0.0, f.x * (1.0 - f.y)),
        (0.0, 1.0, (1.0 - f.x) * f.y),
        (1.0, 1.0, f.x * f.y),
    ] {
        let q = (low + Vec2::new(dx, dy)).clamp(Vec2::ZERO, size.as_vec2() - 1.0);
        let centre = (q + 0.5) / size.as_vec2();
        if angular::uv_to_direction(centre).is_some() {
            let index = q.y as usize * size.x as usize + q.x as usize;
            sum += texels[index] * w;
            total += w;
        }
    }
    if total > 0.0 {
        sum / total
    } else {
        nearest(size, texels, uv)
    }
}

/// At the rim all four neighbours may lie outside: the pixel under the point itself is then as near as any.
fn nearest(size: UVec2, texels: &[Vec4], uv: Vec2) -> Vec4 {
    let q = (uv * size.as_vec2()).as_uvec2().min(size - 1);
    texels[(q.y * size.x + q.x) as usize]
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

    /// Red ahead (+x), green behind; up is brighter than down.
    #[test]
    fn an_angular_map_keeps_its_directions() {
        let size = UVec2::splat(64);
        let texels: Vec<Vec4> = (0..64 * 64)
            .map(|i| {
                let uv = (UVec2::new(i % 64, i / 64).as_vec2() + 0.5) / 64.0;
                match angular::uv_to_direction(uv) {
                    Some(d) => Vec4::new(d.x.max(0.0), (-d.x).max(0.0), 0.5 + 0.5 * d.z, 1.0),
                    None => Vec4::splat(1e9),
                }
            })
            .collect();
        let (out, map) = angular_to_latlong(size, &texels);
        assert_eq!(out, UVec2::new(128, 64));
        for (i, texel) in map.iter().enumerate() {
            let at = UVec2::new(i as u32 % out.x, i as u32 / out.x);
            let d = latlong::texel_direction(at, out);
            let expected = Vec4::new(d.x.max(0.0), (-d.x).max(0.0), 0.5 + 0.5 * d.z, 1.0);
            let difference = (*texel - expected).abs().max_element();
            assert!(difference < 0.06, "{at}: {texel} is not {expected}");
        }
    }
}
