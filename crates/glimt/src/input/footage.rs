//! Host file: the backplate of a shot: which frame of the footage belongs to which of the shot, brought to the image's size.

use super::Reading;
use super::frames::FrameFiles;
use super::plate::{Colours, PlateImage, read, read_plate_header, read_size};
use super::resample::{Window, resample};
use crate::colour::primaries::{Primaries, REC_709};
use crate::error::{Error, Kind, Result};
use crate::notes::Notes;
use crate::shot::digest::{Hash, of_file};
use crate::shot::parse::Source;
use crate::shot::{Fit, Shot};
use glam::{UVec2, Vec3};
use glimt_render_gpu::prepare::plate::Plate;
use rayon::prelude::*;
use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};

/// The footage behind the objects.
#[derive(Clone, Debug)]
pub struct Footage {
    files: FrameFiles,
    fit: Fit,
    reading: Reading,
    /// The primaries that it is brought to, if not its own.
    target: Option<Primaries>,
    /// Size of its images.
    size: UVec2,
    /// Numbers of its first and last frame.
    span: [u32; 2],
    rate: Rate,
}

/// How frames of the footage follow those of the shot.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Rate {
    /// By number.
    Same,
    /// By time: `first_plate + round((frame − first) · ratio)`.
    Other {
        first: u32,
        first_plate: u32,
        ratio: f64,
    },
}

impl Rate {
    /// The number of the footage's frame, which may be one that is not there.
    fn of(self, frame: u32) -> i64 {
        match self {
            Self::Same => i64::from(frame),
            Self::Other {
                first,
                first_plate,
                ratio,
            } => {
                let steps = (f64::from(frame) - f64::from(first)) * ratio;
                i64::from(first_plate) + steps.round() as i64
            }
        }
    }
}

/// The files of the shot's backplate, if it has one.
///
/// # Errors
/// They cannot be named so.
pub fn files(shot: &Shot, source: &Source) -> Result<Option<FrameFiles>> {
    let Some(keys) = &shot.backplate else {
        return Ok(None);
    };
    let files = FrameFiles::new(source.folder(), &keys.frames).map_err(|e| {
        source
            .error("backplate.frames", e.what)
            .fix(e.fix.unwrap_or_default())
    })?;
    Ok(Some(files))
}

/// Numbers of the first and last frame that are there.
fn span(files: &FrameFiles) -> Result<[u32; 2]> {
    let there = files.existing().map_err(|e| {
        e.fix("check backplate.frames: each # stands for a digit of the frame's number")
    })?;
    Ok([there[0], there[there.len() - 1]])
}

/// Gives the image the size of the backplate and the shape of its pixels, where there is one and the shot does not say these.
///
/// # Errors
/// The first frame of the footage cannot be read.
pub fn adopt_size(shot: &mut Shot, source: &Source) -> Result<()> {
    let gives = ["image.size", "image.pixel_aspect"].map(|key| source.gives(key));
    if gives == [true, true] {
        return Ok(());
    }
    if let Some(files) = files(shot, source)?.filter(|_| named(shot)) {
        let first = match span(&files) {
            Ok([first, _]) => first,
            // Whoever needs the frames will say that there are none.
            Err(_) if gives[0] => return Ok(()),
            Err(error) => return Err(error),
        };
        let header = read_plate_header(&files.path(first), &Reading::of_plate(shot))?;
        let own = header.size;
        if !gives[0] {
            shot.image.size = own.to_array();
        }
        if !gives[1] {
            let fit = shot
                .backplate
                .as_ref()
                .map_or(Fit::Stretch, |keys| keys.fit);
            let image = UVec2::from(shot.image.size);
            shot.image.pixel_aspect = image_aspect(own, header.pixel_aspect, image, fit);
        }
    }
    Ok(())
}

/// The shape of an image's pixels over a plate of this size, whose pixels have this shape: the plate's, unless the plate is
/// stretched to an image of just the proportions that it has when its pixels are made square.
fn image_aspect(plate: UVec2, aspect: f32, image: UVec2, fit: Fit) -> f32 {
    let proportions = |size: UVec2| size.x as f32 / size.y.max(1) as f32;
    let squeezed = proportions(plate) * aspect / proportions(image);
    match fit == Fit::Stretch && (squeezed - 1.0).abs() <= 0.01 {
        true => 1.0,
        false => aspect,
    }
}

/// Whether the backplate has a name; if not, the check of the shot will say so.
fn named(shot: &Shot) -> bool {
    shot.backplate
        .as_ref()
        .is_some_and(|keys| !keys.frames.is_empty())
}

impl Footage {
    /// The footage of a shot, if it has one: finds its frames and how they follow those of the probe.
    ///
    /// # Errors
    /// There is none of its files.
    pub fn find(
        shot: &Shot,
        source: &Source,
        probe: &FrameFiles,
        notes: &mut Notes,
    ) -> Result<Option<Self>> {
        let Some(files) = files(shot, source)? else {
            return Ok(None);
        };
        let span = span(&files)?;
        let first = match probe.is_still() {
            true => span[0],
            false => probe.existing()?[0],
        };
        Self::new(files, shot, first, span, notes).map(Some)
    }

    /// Footage with frames of these numbers, the first of which is there; `first` is the probe's first.
    ///
    /// # Errors
    /// Its first frame cannot be read.
    pub fn new(
        files: FrameFiles,
        shot: &Shot,
        first: u32,
        span: [u32; 2],
        notes: &mut Notes,
    ) -> Result<Self> {
        let keys = shot.backplate.clone().unwrap_or_default();
        let first_file = files.path(span[0]);
        let reading = Reading::of_plate(shot);
        let mut footage = Self {
            size: read_size(&first_file, &reading)?,
            reading,
            target: shot.output.primaries.primaries(),
            fit: keys.fit,
            span,
            rate: Rate::Same,
            files,
        };
        let fps = shot.probe.fps;
        if let (Some(own), false) = (keys.fps.filter(|own| *own != fps), footage.is_still()) {
            footage.rate = Rate::Other {
                first,
                first_plate: span[0],
                ratio: f64::from(own) / f64::from(fps),
            };
            notes.note(
                &first_file,
                format!("the footage has {own} frames a second, the probe {fps}: they are matched by time"),
            );
        }
        Ok(footage)
    }

    /// Its files.
    pub fn files(&self) -> &FrameFiles {
        &self.files
    }

    /// Whether every frame is the same image.
    pub fn is_still(&self) -> bool {
        self.files.is_still()
    }

    /// Whether there is footage for a frame of the shot, as far as first and last frame tell.
    fn covers(&self, frame: u32) -> bool {
        let [first, last] = self.span.map(i64::from);
        self.is_still() || (first..=last).contains(&self.rate.of(frame))
    }

    /// The number of the footage's frame that belongs to a frame of the shot, whether it is there or not.
    pub fn number(&self, frame: u32) -> u32 {
        self.rate.of(frame).clamp(0, u32::MAX.into()) as u32
    }

    /// The file that belongs to a frame of the shot.
    pub fn file(&self, frame: u32) -> PathBuf {
        self.files.path(self.number(frame))
    }

    /// The frames that both probe and footage have; says which are left out.
    ///
    /// # Errors
    /// There is none.
    pub fn shared(&self, probe: &FrameFiles, notes: &mut Notes) -> Result<RangeInclusive<u32>> {
        let there = match (probe.is_still(), self.is_still()) {
            (true, false) => self.own_frames(),
            _ => probe.existing()?,
        };
        let covered: Vec<u32> = there.iter().copied().filter(|f| self.covers(*f)).collect();
        let (&low, &high) = (there.first().zip(there.last())).unwrap_or((&1, &1));
        let [from, to] = self.span;
        let Some((&first, &last)) = covered.first().zip(covered.last()) else {
            let what = format!(
                "the backplate has frames {from} to {to}, the probe {low} to {high}: none belong together"
            );
            return Err(Error::input(&self.files.path(from), what)
                .fix("number both alike, or say the backplate's own rate as backplate.fps"));
        };
        let file = self.files.path(from);
        let mut left_out = |whose: &str, other: &str, [a, b]: [i64; 2]| {
            let which = match b - a {
                ..0 => return,
                0 => format!("frame {a} of the {whose} is left out"),
                _ => format!("frames {a} to {b} of the {whose} are left out"),
            };
            notes.warn(&file, format!("{which}: the {other} has none for it"));
        };
        let [low, high] = [low, high].map(i64::from);
        let ends = [i64::from(first), i64::from(last)];
        left_out("probe", "backplate", [low, ends[0] - 1]);
        left_out("probe", "backplate", [ends[1] + 1, high]);
        if !self.is_still() && !probe.is_still() {
            let before = first.checked_sub(1).map_or(-1, |f| self.rate.of(f));
            left_out("backplate", "probe", [from.into(), before]);
            let after = last.checked_add(1).map_or(i64::MAX, |f| self.rate.of(f));
            left_out("backplate", "probe", [after, to.into()]);
        }
        Ok(first..=last)
    }

    /// The frames of a shot whose light is a still: as long as the footage lasts.
    fn own_frames(&self) -> Vec<u32> {
        let [first, last] = self.span;
        match self.rate {
            Rate::Same => (first..=last).collect(),
            Rate::Other { .. } => (first..).take_while(|f| self.covers(*f)).collect(),
        }
    }

    /// Sees that all of these frames of the shot have footage, of one size.
    ///
    /// # Errors
    /// The first that has not.
    pub fn require(&self, frames: &[u32], image: UVec2, notes: &mut Notes) -> Result<()> {
        for &frame in frames {
            let file = self.file(frame);
            if !file.is_file() && !self.is_still() {
                let [from, to] = self.span;
                let what = format!("the backplate of frame {frame} is missing");
                return Err(Error::input(&file, what).fix(format!(
                    "supply it, or choose other frames with --frames (there are frames {from} to {to})"
                )));
            }
            let size = read_size(&file, &self.reading)?;
            if size != self.size {
                let what = format!(
                    "it is {} × {}, but {} is {} × {}",
                    size.x,
                    size.y,
                    self.files.path(self.span[0]).display(),
                    self.size.x,
                    self.size.y
                );
                return Err(Error::input(&file, what)
                    .fix("all frames of a sequence must have one size: resize it"));
            }
            if self.is_still() {
                break;
            }
        }
        self.note_stretch(image, notes);
        Ok(())
    }

    /// Says so where the image has other proportions.
    pub fn note_stretch(&self, image: UVec2, notes: &mut Notes) {
        let proportions = |size: UVec2| f64::from(size.x) / f64::from(size.y);
        let stretched = proportions(image) / proportions(self.size);
        if self.fit == Fit::Stretch && !((stretched - 1.0).abs() <= 0.01) {
            let (from, to) = (self.size, image);
            notes.note(
                &self.files.path(self.span[0]),
                format!(
                    "its {} × {} pixels are stretched to {} × {}; backplate.fit = \"crop\" keeps its proportions",
                    from.x, from.y, to.x, to.y
                ),
            );
        }
    }

    /// Hash of the file that belongs to each of these frames of the shot.
    ///
    /// # Errors
    /// A file cannot be read.
    pub fn digests(&self, frames: &[u32]) -> Result<Vec<Hash>> {
        if self.is_still() {
            return Ok(vec![of_file(&self.file(1))?; frames.len()]);
        }
        frames.par_iter().map(|&f| of_file(&self.file(f))).collect()
    }

    /// Reads the footage of a frame of the shot and brings it to the image's size. The hash is that of its file.
    ///
    /// # Errors
    /// The file cannot be read, is broken or of another size than the first; or it has defects and `notes` is strict.
    pub fn load(&self, frame: u32, image: UVec2, notes: &mut Notes) -> Result<(Plate, Hash)> {
        self.load_file(&self.file(frame), image, notes)
    }

    /// Reads one of the footage's files and brings it to the image's size. The hash is that of the file.
    ///
    /// # Errors
    /// The file cannot be read or is broken; or it has defects and `notes` is strict.
    pub fn load_file(&self, file: &Path, image: UVec2, notes: &mut Notes) -> Result<(Plate, Hash)> {
        let PlateImage {
            size,
            colours,
            primaries,
            hash,
            ..
        } = read(file, &self.reading, notes)?;
        let own = self.target.unwrap_or(primaries);
        let colours = match primaries.matrix_to(&own) {
            Some(matrix) => {
                let mut linear = colours.into_linear();
                let convert = |c: &mut Vec3| *c = (matrix * c.as_dvec3()).as_vec3();
                linear.par_iter_mut().for_each(convert);
                Colours::Linear(linear)
            }
            None => colours,
        };
        let plate = match colours {
            Colours::Srgb8(codes) if size == image => Plate::from_srgb8(size, &codes),
            Colours::Linear(linear) if size == image => Plate::from_linear(size, &linear),
            other => Plate::from_linear(image, &self.fitted(size, &other.into_linear(), image)),
        };
        let plate = plate.map_err(|e| Error::new(Kind::Internal, e).file(file))?;
        let plate = plate.with_primaries(
            own.0,
            self.reading.working.colour_matrix_to(&own),
            own.colour_matrix_to(&REC_709),
        );
        Ok((plate, hash))
    }

    fn fitted(&self, size: UVec2, linear: &[Vec3], image: UVec2) -> Vec<Vec3> {
        let window = match self.fit {
            Fit::Stretch => Window::whole(size),
            Fit::Crop => Window::middle(size, image),
        };
        resample(size, linear, window, image)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frames_are_matched_by_time() {
        let rate = Rate::Other {
            first: 10,
            first_plate: 1001,
            ratio: 2.0,
        };
        assert_eq!([9, 10, 11, 14].map(|f| rate.of(f)), [999, 1001, 1003, 1009]);
        let slower = Rate::Other {
            first: 1,
            first_plate: 1,
            ratio: 24.0 / 60.0,
        };
        assert_eq!([1, 2, 3, 4, 6].map(|f| slower.of(f)), [1, 1, 2, 2, 3]);
        assert_eq!(Rate::Same.of(7), 7);
    }
}
