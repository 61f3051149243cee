//! Host file: photographs of a mirror ball to light maps: the table of pixels and weights, made and applied by rayon.

use glam::{UVec2, Vec2, Vec3, Vec4};
use glimt_probe::gather::{ColourMatrix, GatherMap, TexelTaps};
use glimt_probe::mirror_ball::MirrorBall;
use glimt_probe::unwarp::{Outline, Tap, Unwarp, UnwarpError, Visibility, corner};
use rayon::prelude::*;

use crate::kernels::unwarp::unwarp;

/// Where a ball stands in a photograph.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BallPose {
    /// Its outline, in pixels.
    pub outline: Outline,
    /// Angle in radians by which the photograph is turned counter-clockwise against an upright camera's.
    pub roll: f32,
}

/// What is done beside the mapping.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UnwarpOptions {
    /// Pixels that reach nearer to the rim than this less one are not taken, since the background may be mixed into them.
    pub rim_px: f32,
    /// Half-angle in radians of the cone about the camera that is filled; 0 for none.
    pub rig_half_angle: f32,
}

impl Default for UnwarpOptions {
    /// 1.5, for an outline that is known to half a pixel; no rig.
    fn default() -> Self {
        Self {
            rim_px: 1.5,
            rig_half_angle: 0.0,
        }
    }
}

/// What is undone and done to the colours of a photograph.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Look {
    /// Reflectance of the ball at normal incidence, in (0, 1] for each channel.
    pub reflectance: Vec3,
    /// Applied to the light that the ball reflected.
    pub colour: ColourMatrix,
}

impl Look {
    /// A perfect mirror, whose colours stay as they are.
    pub const IDENTITY: Look = Look {
        reflectance: Vec3::ONE,
        colour: ColourMatrix::IDENTITY,
    };
}

/// The part of the mapping that is the same for all frames of a capture: where the corners of the map's texels are seen on
/// the ball.
#[derive(Clone, Debug)]
pub struct UnwarpGrid {
    ball: MirrorBall,
    size: UVec2,
    corners: Vec<Vec2>,
}

impl UnwarpGrid {
    /// The grid of a map of `size` texels. A size of 0 counts as 1.
    #[must_use]
    pub fn new(ball: MirrorBall, size: UVec2) -> Self {
        let size = size.max(UVec2::ONE);
        let width = size.x as usize + 1;
        let mut corners = vec![Vec2::ZERO; width * (size.y as usize + 1)];
        let rows = corners.par_chunks_mut(width).enumerate();
        rows.for_each(|(y, row)| {
            for (x, p) in row.iter_mut().enumerate() {
                *p = corner(&ball, UVec2::new(x as u32, y as u32), size);
            }
        });
        Self {
            ball,
            size,
            corners,
        }
    }

    /// Size of the map in texels.
    #[must_use]
    pub fn size(&self) -> UVec2 {
        self.size
    }

    /// The table for photographs of `photo` pixels in which the ball stands as `pose` says.
    ///
    /// # Errors
    /// An [`UnwarpError`].
    pub fn map(
        &self,
        pose: &BallPose,
        photo: UVec2,
        options: &UnwarpOptions,
    ) -> Result<UnwarpMap, UnwarpError> {
        let (sin, cos) = pose.roll.sin_cos();
        let ball = self.ball.image_turned(Vec2::new(cos, sin));
        let unwarp = Unwarp::new(ball, pose.outline, photo, self.size, options.rim_px)?
            .with_rig(options.rig_half_angle);
        // Turning the ball's image turns its points.
        let turned = |p: Vec2| Vec2::new(p.x * cos + p.y * sin, p.y * cos - p.x * sin);
        let width = self.size.x as usize + 1;
        let row = |y: u32| -> Row {
            let mut row = Row::default();
            let mut loose = Loose::default();
            let at = |x: u32, y: u32| turned(self.corners[y as usize * width + x as usize]);
            for x in 0..self.size.x {
                let corners = [at(x, y), at(x + 1, y), at(x, y + 1), at(x + 1, y + 1)];
                let seen = unwarp.texel(UVec2::new(x, y), corners, |tap| loose.push(tap));
                row.visibility.push(seen);
                let begin = loose.pack(photo.x, &mut row.taps);
                row.texels.push(TexelTaps {
                    grazing: unwarp.grazing(corners),
                    ..begin
                });
            }
            row
        };
        let rows: Vec<Row> = (0..self.size.y).into_par_iter().map(row).collect();
        let total = rows.iter().map(|row| row.taps.len()).sum();
        let count = self.size.x as usize * self.size.y as usize;
        let mut map = UnwarpMap {
            size: self.size,
            photo,
            texels: Vec::with_capacity(count + 1),
            taps: Vec::with_capacity(total),
            visibility: Vec::with_capacity(count),
        };
        for row in rows {
            let first = map.taps.len() as u32;
            map.texels.extend(row.texels.iter().map(|texel| TexelTaps {
                tap: first + texel.tap,
                ..*texel
            }));
            map.taps.extend_from_slice(&row.taps);
            map.visibility.extend_from_slice(&row.visibility);
        }
        map.texels.push(TexelTaps {
            tap: map.taps.len() as u32,
            pixel: 0,
            grazing: 0.0,
        });
        Ok(map)
    }
}

#[derive(Default)]
struct Row {
    taps: Vec<u32>,
    texels: Vec<TexelTaps>,
    visibility: Vec<Visibility>,
}

/// Side of the blocks of texels that are made one after the other: neighbours share pixels, above and below too.
const BLOCK: usize = 32;

/// How many texels ahead pixels are asked for.
const AHEAD: usize = 16;

/// Asks for a pixel that is soon to be read: neighbours in a map lie along a curve in the photograph, which no processor
/// foresees.
#[inline(always)]
fn fetch(pixels: &[Vec4], index: usize) {
    #[cfg(target_arch = "x86_64")]
    if let Some(pixel) = pixels.get(index) {
        use std::arch::x86_64::{_MM_HINT_T0, _mm_prefetch};
        // SAFETY: a hint; the address is that of a value that is there.
        unsafe { _mm_prefetch::<_MM_HINT_T0>(std::ptr::from_ref(pixel).cast()) };
    }
    #[cfg(not(target_arch = "x86_64"))]
    let _ = (pixels, index);
}

/// Side of the square of pixels in which a texel's taps are added up; larger ones are sorted.
const SQUARE: usize = 16;

/// Taps with less than this share of a texel are left out: a sliver of a pixel costs as much as a whole one.
const SMALLEST: f32 = 1.0 / 40.0;

/// The taps of one texel as they come.
struct Loose {
    list: Vec<Tap>,
    sum: f32,
    low: UVec2,
    high: UVec2,
    square: [f32; SQUARE * SQUARE],
    merged: Vec<(u32, f32)>,
}

impl Default for Loose {
    fn default() -> Self {
        Self {
            list: Vec::new(),
            sum: 0.0,
            low: UVec2::MAX,
            high: UVec2::ZERO,
            square: [0.0; SQUARE * SQUARE],
            merged: Vec::new(),
        }
    }
}

impl Loose {
    fn push(&mut self, tap: Tap) {
        self.list.push(tap);
        self.sum += tap.weight;
        self.low = self.low.min(tap.pixel);
        self.high = self.high.max(tap.pixel);
    }

    /// Adds up what a pixel got several times, in the order of the pixels.
    fn merge(&mut self, width: u32) {
        self.merged.clear();
        let extent = self.high - self.low + UVec2::ONE;
        if extent.max_element() as usize > SQUARE {
            self.list
                .sort_unstable_by_key(|tap| (tap.pixel.y, tap.pixel.x));
            for tap in &self.list {
                let pixel = tap.pixel.y * width + tap.pixel.x;
                match self.merged.last_mut() {
                    Some(last) if last.0 == pixel => last.1 += tap.weight,
                    _ => self.merged.push((pixel, tap.weight)),
                }
            }
            return;
        }
        let columns = extent.x as usize;
        for tap in &self.list {
            let at = tap.pixel - self.low;
            self.square[at.y as usize * columns + at.x as usize] += tap.weight;
        }
        let first = self.low.y * width + self.low.x;
        for y in 0..extent.y {
            for x in 0..extent.x {
                let weight = std::mem::take(&mut self.square[y as usize * columns + x as usize]);
                if weight > 0.0 {
                    self.merged.push((first + y * width + x, weight));
                }
            }
        }
    }

    /// Appends the taps to `taps`, packed, and forgets them. Says where they begin.
    fn pack(&mut self, width: u32, taps: &mut Vec<u32>) -> TexelTaps {
        let begin = taps.len() as u32;
        if self.list.is_empty() {
            return TexelTaps {
                tap: begin,
                pixel: 0,
                grazing: 0.0,
            };
        }
        self.merge(width);
        // A texel of very many pixels has none with much of a share.
        let average = self.sum / self.merged.len() as f32;
        let least = (SMALLEST * self.sum).min(0.25 * average);
        self.merged.retain(|&(_, weight)| weight >= least);
        let kept: f32 = self.merged.iter().map(|m| m.1).sum();

        // Rounding the running sum makes the weights sum to the whole exactly.
        let (mut pixel, mut running, mut given) = (self.merged[0].0, 0.0, 0);
        let start = TexelTaps {
            tap: begin,
            pixel,
            grazing: 0.0,
        };
        for &(at, weight) in &self.merged {
            running += weight;
            let upto = ((running / kept * 65_535.0 + 0.5) as u32).min(65_535);
            let units = upto - given;
            if units == 0 {
                continue;
            }
            given = upto;
            while at - pixel > 0xffff {
                taps.push(0xffff << 16);
                pixel += 0xffff;
            }
            taps.push((at - pixel) << 16 | units);
            pixel = at;
        }
        // The kernel takes two at a time.
        taps.resize(taps.len().next_multiple_of(2), 0);
        self.list.clear();
        self.sum = 0.0;
        self.low = UVec2::MAX;
        self.high = UVec2::ZERO;
        start
    }
}

/// Which pixels of a photograph make each texel of a light map.
#[derive(Clone, Debug)]
pub struct UnwarpMap {
    size: UVec2,
    photo: UVec2,
    texels: Vec<TexelTaps>,
    taps: Vec<u32>,
    visibility: Vec<Visibility>,
}

impl UnwarpMap {
    /// Size of the light map in texels.
    #[must_use]
    pub fn size(&self) -> UVec2 {
        self.size
    }

    /// Size of the photographs in pixels.
    #[must_use]
    pub fn photo(&self) -> UVec2 {
        self.photo
    }

    /// What became of the middle of each texel, row by row.
    #[must_use]
    pub fn visibility(&self) -> &[Visibility] {
        &self.visibility
    }

    /// What kernels see of it.
    #[must_use]
    pub fn view(&self) -> GatherMap<'_> {
        GatherMap {
            texels: &self.texels,
            taps: &self.taps,
        }
    }

    /// The light map of one photograph, on all of rayon's threads, into `texels`.
    ///
    /// # Panics
    /// Where `pixels` is not of the size that the table was made for, or `texels` not of the map's.
    pub fn apply_into(&self, pixels: &[Vec4], look: &Look, texels: &mut [Vec4]) {
        let count = |size: UVec2| size.x as usize * size.y as usize;
        assert_eq!(pixels.len(), count(self.photo), "pixels of the photograph");
        assert_eq!(texels.len(), count(self.size), "texels of the map");
        let map = self.view();
        let (colour, reflectance) = (&look.colour, look.reflectance.extend(1.0));
        let width = self.size.x as usize;
        let photo_width = self.photo.x as usize;
        let bands = texels.par_chunks_mut(BLOCK * width).enumerate();
        bands.for_each(|(band, rows)| {
            let first = band * BLOCK * width;
            for left in (0..width).step_by(BLOCK) {
                let right = (left + BLOCK).min(width);
                for start in (0..rows.len()).step_by(width) {
                    for (x, value) in (left..right).zip(&mut rows[start + left..start + right]) {
                        if let Some(soon) = map.texels.get(first + start + x + AHEAD) {
                            let pixel = soon.pixel as usize;
                            fetch(pixels, pixel);
                            fetch(pixels, pixel + photo_width);
                            fetch(pixels, pixel + 2 * photo_width);
                        }
                        *value =
                            unwarp((first + start + x) as u32, map, colour, reflectance, pixels);
                    }
                }
            }
        });
    }

    /// As [`UnwarpMap::apply_into`], into a new list.
    ///
    /// # Panics
    /// As [`UnwarpMap::apply_into`].
    #[must_use]
    pub fn apply(&self, pixels: &[Vec4], look: &Look) -> Vec<Vec4> {
        let mut texels = vec![Vec4::ZERO; self.size.x as usize * self.size.y as usize];
        self.apply_into(pixels, look, &mut texels);
        texels
    }
}
