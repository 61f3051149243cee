//! Host file: the light of a shot: its frames as lat-long maps that the renderer accepts.

mod angular;
pub mod colour;
mod cube;

use crate::capture::{Capture, Poses, locate};
use crate::error::{Error, Result};
use crate::input::Reading;
use crate::input::frames::{FrameFiles, check_size};
use crate::input::light_image::{self, LightImage};
use crate::notes::Notes;
use crate::shot::digest::{Hash, join, of_file, of_text};
use crate::shot::{self, Mapping, Shot};
use angular::angular_to_latlong;
use cube::{Layout, cube_to_latlong};
use glam::{UVec2, Vec4};
use glimt_probe::gather::ColourMatrix;
use glimt_render_gpu::prepare::env::{EnvMap, MAX_RADIANCE};
use glimt_render_gpu::prepare::unwarp::BallPose;
use rayon::prelude::*;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// The frames of a light probe, all of one size.
#[derive(Clone, Debug)]
pub struct Probe {
    files: FrameFiles,
    mapping: Mapping,
    reading: Reading,
    scale: f32,
    size: UVec2,
    /// Where the ball is, in film of one.
    capture: Option<Arc<Capture>>,
    colour: ColourMatrix,
}

/// The first image of a probe that is still being filmed.
#[derive(Clone, Copy, Debug)]
pub struct FirstImage<'a> {
    /// Its file.
    pub file: &'a Path,
    /// The image.
    pub image: &'a LightImage,
    /// Where the mirror ball is in it, if it shows one.
    pub pose: Option<BallPose>,
}

/// The files of a probe, and which of its frames are wanted.
#[derive(Clone, Debug)]
pub struct Selection<'a> {
    /// The files.
    pub files: FrameFiles,
    /// The frames that are asked for, in order, at least one.
    pub frames: &'a [i32],
    /// All frames of the shot, in order.
    pub of_shot: &'a [i32],
}

impl Probe {
    /// Checks the headers of all frames that are asked for: that they are images, of one size, and fit the mapping. In film of a
    /// mirror ball, the ball is looked for in all frames of the shot, whichever are asked for: what is smoothed over a shot must not
    /// depend on which part of it is rendered. `progress` is called with how many are done, and of how many.
    ///
    /// # Errors
    /// The first frame that is not as it should be.
    pub fn open(
        selection: Selection<'_>,
        shot: &Shot,
        notes: &mut Notes,
        progress: &(dyn Fn(usize, usize) + Sync),
    ) -> Result<Self> {
        let keys = &shot.probe;
        let reading = Reading::of_probe(shot);
        let size = size_of_all(&selection, &reading)?;
        let first = selection.files.path(selection.frames[0]);
        // What is said of the image now is said again when it is rendered by.
        let pixels = || {
            let image = read_frame(None, &first, &reading, &mut Notes::default())?;
            Ok(image.pixels)
        };
        let mapping = mapping_of(keys.mapping, size, &first, &pixels, notes)?;
        let capture = match mapping {
            Mapping::MirrorBall => {
                let ball = keys.ball.clone().unwrap_or_default();
                let poses = match Poses::given(&ball) {
                    Some(given) => given,
                    None => found_poses(&selection, &ball, &reading, notes, progress)?,
                };
                Some(Arc::new(Capture::new(&ball, poses)))
            }
            _ => None,
        };
        Ok(Self::new(selection.files, mapping, shot, size, capture))
    }

    /// A probe whose images have this size.
    fn new(
        files: FrameFiles,
        mapping: Mapping,
        shot: &Shot,
        size: UVec2,
        capture: Option<Arc<Capture>>,
    ) -> Self {
        Self {
            files,
            mapping,
            reading: Reading::of_probe(shot),
            scale: shot.probe.scale,
            size,
            capture,
            colour: ColourMatrix::IDENTITY,
        }
    }

    /// A probe that is still being filmed, by its first image.
    ///
    /// # Errors
    /// The image does not fit the mapping.
    pub fn live(
        files: FrameFiles,
        shot: &Shot,
        first: &FirstImage<'_>,
        notes: &mut Notes,
    ) -> Result<Self> {
        let FirstImage { file, image, .. } = first;
        let pixels = || Ok(image.pixels.clone());
        let mapping = mapping_of(shot.probe.mapping, image.size, file, &pixels, notes)?;
        let ball = shot.probe.ball.clone().unwrap_or_default();
        let capture = first
            .pose
            .map(|pose| Arc::new(Capture::new(&ball, Poses::Fixed(pose))));
        Ok(Self::new(files, mapping, shot, image.size, capture))
    }

    /// Sets how its colours are changed.
    pub fn set_colour(&mut self, colour: ColourMatrix) {
        self.colour = colour;
    }

    /// Film of a mirror ball, if it is.
    pub fn capture(&self) -> Option<&Arc<Capture>> {
        self.capture.as_ref()
    }

    /// How its files are read.
    pub fn reading(&self) -> &Reading {
        &self.reading
    }

    /// Size of its images.
    pub fn size(&self) -> UVec2 {
        self.size
    }

    /// Size of its lat-long maps.
    pub fn map_size(&self) -> UVec2 {
        match (&self.capture, self.mapping) {
            (Some(capture), _) => capture.size(),
            (None, Mapping::Angular) => UVec2::new(2 * self.size.x, self.size.x),
            (None, Mapping::Cube) => {
                let side = Layout::of(self.size).map_or(1, |(_, side)| side);
                UVec2::new(4 * side, 2 * side)
            }
            (None, _) => self.size,
        }
    }

    /// Whether every frame is the same image.
    pub fn is_still(&self) -> bool {
        self.files.is_still()
    }

    /// The file of a frame.
    pub fn file(&self, frame: i32) -> PathBuf {
        self.files.path(frame)
    }

    /// Hash of the file of each of these frames, and of where the ball is in it.
    ///
    /// # Errors
    /// A file cannot be read.
    pub fn digests(&self, frames: &[i32]) -> Result<Vec<Hash>> {
        let files = if self.files.is_still() {
            vec![of_file(&self.files.path(1))?; frames.len()]
        } else {
            let paths = frames.par_iter().map(|&frame| self.files.path(frame));
            paths.map(|path| of_file(&path)).collect::<Result<_>>()?
        };
        let with_pose = |(file, frame): (Hash, &i32)| self.digest_at(&file, self.pose(*frame));
        Ok(files.into_iter().zip(frames).map(with_pose).collect())
    }

    /// Hash of an image with this one, in which the ball is there.
    pub fn digest_at(&self, file: &Hash, pose: Option<BallPose>) -> Hash {
        // Both print so that they read back as the same numbers.
        join([file, &of_text(&format!("{pose:?} {:?}", self.colour))])
    }

    /// Where the ball is in a frame, in film of one.
    fn pose(&self, frame: i32) -> Option<BallPose> {
        self.capture.as_ref()?.poses().of(frame)
    }

    /// Reads the light of a frame. The hash is that of its file and of where the ball is in it: as in [`Probe::digests`], unless the
    /// file was replaced.
    ///
    /// # Errors
    /// The file cannot be read, is broken, or has bad texels and `notes` is strict.
    pub fn load(&self, frame: i32, notes: &mut Notes) -> Result<(EnvMap, Hash)> {
        let file = self.files.path(frame);
        let pose = self.pose(frame);
        let image = read_frame(Some(self.mapping), &file, &self.reading, notes)?;
        let hash = self.digest_at(&image.hash, pose);
        Ok((self.light_of(image, &file, pose, notes)?, hash))
    }

    /// The light of an image that was read from `file`, in which the ball is at `pose`.
    ///
    /// # Errors
    /// It has another size than the probe, or does not hold the ball.
    pub fn light_of(
        &self,
        image: LightImage,
        file: &Path,
        pose: Option<BallPose>,
        notes: &mut Notes,
    ) -> Result<EnvMap> {
        self.check_size(file, image.size)?;
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

    /// Checks that an image has the size of the probe.
    ///
    /// # Errors
    /// It has another size.
    pub fn check_size(&self, file: &Path, size: UVec2) -> Result<()> {
        let all = self.files.folder().join(self.files.pattern());
        check_size(file, size, self.size, &all)
    }

    /// An image of all directions as a lat-long map.
    fn map_of(&self, image: LightImage) -> (UVec2, Vec<Vec4>) {
        let (size, mut texels) = match self.mapping {
            Mapping::Angular => angular_to_latlong(image.size, &image.pixels),
            Mapping::Cube => match Layout::of(image.size) {
                Some((layout, side)) => cube_to_latlong(image.size, layout, side, &image.pixels),
                None => (image.size, image.pixels),
            },
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

/// The size of all frames that are asked for, by their headers.
fn size_of_all(selection: &Selection<'_>, reading: &Reading) -> Result<UVec2> {
    let Selection { files, frames, .. } = selection;
    let first = files.path(frames[0]);
    let size = light_image::read_size(&first, reading)?;
    let others = if files.is_still() { &[] } else { &frames[1..] };
    for &frame in others {
        let path = files.path(frame);
        check_size(&path, light_image::read_size(&path, reading)?, size, &first)?;
    }
    Ok(size)
}

/// Where the ball is found in the frames of the shot.
fn found_poses(
    selection: &Selection<'_>,
    ball: &shot::Ball,
    reading: &Reading,
    notes: &mut Notes,
    progress: &(dyn Fn(usize, usize) + Sync),
) -> Result<Poses> {
    let Selection {
        files,
        frames,
        of_shot,
    } = selection;
    let mut all = match files.is_still() {
        true => frames.to_vec(),
        false => files.existing()?,
    };
    all.retain(|frame| of_shot.binary_search(frame).is_ok() || frames.binary_search(frame).is_ok());
    locate::poses(files, &all, ball, reading, notes, progress)
}

/// Reads an image of a probe: a photograph of a mirror ball, or an image of all directions.
///
/// # Errors
/// The file cannot be read or is broken; or it has bad texels and `notes` is strict.
pub fn read_frame(
    mapping: Option<Mapping>,
    file: &Path,
    reading: &Reading,
    notes: &mut Notes,
) -> Result<LightImage> {
    match mapping {
        Some(Mapping::MirrorBall) => light_image::read_photo(file, reading, notes),
        _ => light_image::read_all_directions(file, reading, notes),
    }
}

/// The mapping of an image: the one that is stated, or the one that its proportions tell. `pixels` are asked for where it may be a
/// cross.
///
/// # Errors
/// It cannot hold what is stated, or nothing is stated and its proportions tell nothing.
fn mapping_of(
    stated: Option<Mapping>,
    size: UVec2,
    file: &Path,
    pixels: &dyn Fn() -> Result<Vec<Vec4>>,
    notes: &mut Notes,
) -> Result<Mapping> {
    if let Some(mapping) = stated {
        check_shape(mapping, size, file, notes)?;
        return Ok(mapping);
    }
    let is_cube = match Layout::of(size) {
        Some((layout, _)) if layout.is_strip() => true,
        Some(_) => cube::has_blank_corners(size, &pixels()?),
        None => false,
    };
    if is_cube {
        let what = format!(
            "{} × {} are six faces: it is taken as a cube map (probe.mapping says otherwise)",
            size.x, size.y
        );
        notes.note(file, what);
        return Ok(Mapping::Cube);
    }
    let (width, height) = (u64::from(size.x), u64::from(size.y));
    if 50 * width.abs_diff(2 * height) > 2 * height {
        let what = format!(
            "{} × {} is not 2:1, so it is no lat-long map",
            size.x, size.y
        );
        return Err(Error::input(file, what).fix(
            "set probe.mapping to what it is: \"mirror-ball\", \"cube\", \"angular\" or \"lat-long\"",
        ));
    }
    check_shape(Mapping::LatLong, size, file, notes)?;
    Ok(Mapping::LatLong)
}

/// Checks that an image can hold what its mapping says.
///
/// # Errors
/// Its proportions are others.
pub fn check_shape(mapping: Mapping, size: UVec2, file: &Path, notes: &mut Notes) -> Result<()> {
    let is = format!("{} × {}", size.x, size.y);
    match mapping {
        Mapping::Angular if size.x != size.y => Err(Error::input(
            file,
            format!("an angular map is square, and this is {is}"),
        )
        .fix("crop it to the square around the disc, or set probe.mapping = \"lat-long\"")),
        Mapping::Cube if Layout::of(size).is_none() => Err(Error::input(
            file,
            format!("a cube map is 6:1, 1:6, 4:3 or 3:4, and this is {is}"),
        )
        .fix("crop it to its six faces, or set probe.mapping to what it is")),
        Mapping::LatLong if size.x != 2 * size.y => {
            notes.note(
                file,
                format!("{is} is not 2:1; it is taken as a lat-long map all the same"),
            );
            Ok(())
        }
        _ => Ok(()),
    }
}
