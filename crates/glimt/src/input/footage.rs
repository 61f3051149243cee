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
use crate::shot::{Backplate, Fit, Shot};
use glam::{UVec2, Vec3};
use glimt_render_gpu::prepare::env::MAX_RADIANCE;
use glimt_render_gpu::prepare::plate::Plate;
use rayon::prelude::*;
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
    span: [i32; 2],
    pairing: Pairing,
}

/// How frames of the footage belong to those of the shot: `first_plate + round((frame − first) · ratio)`.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Pairing {
    /// A frame of the shot.
    first: i64,
    /// The frame of the footage that belongs to it.
    first_plate: i64,
    /// Frames of the footage in the time of one of the shot.
    ratio: f64,
}

impl Pairing {
    /// The number of the footage's frame, which may be one that is not there.
    fn of(self, frame: i64) -> i64 {
        let steps = (frame - self.first) as f64 * self.ratio;
        self.first_plate + steps.round() as i64
    }
}

/// The first and the last frame of the light that the footage is paired with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LightSpan {
    /// It is a still.
    Still,
    /// Its first and its last frame.
    Sequence([i32; 2]),
    /// Its first frame; it is still being filmed, and so is the footage.
    Live(i32),
}

impl LightSpan {
    /// That of a probe.
    ///
    /// # Errors
    /// There is none of its files.
    pub fn of(probe: &FrameFiles) -> Result<Self> {
        if probe.is_still() {
            return Ok(Self::Still);
        }
        let there = probe.existing()?;
        Ok(Self::Sequence([there[0], there[there.len() - 1]]))
    }

    /// Whether both are sequences from a first to a last frame, and these are equally far apart.
    fn is_as_long_as(self, [from, to]: [i32; 2]) -> bool {
        let length = |[a, b]: [i32; 2]| i64::from(b) - i64::from(a);
        matches!(self, Self::Sequence(span) if length(span) == length([from, to]))
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
fn span(files: &FrameFiles) -> Result<[i32; 2]> {
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

/// Gives the shot the rate of its backplate, where the shot says no `probe.fps`, and the light has no other: it is a still, or a
/// sequence as long as the backplate.
///
/// # Errors
/// The backplate cannot be named so; or the light's rate is a guess, and `notes` is strict.
pub fn adopt_rate(
    shot: &mut Shot,
    source: &Source,
    probe: &FrameFiles,
    notes: &mut Notes,
) -> Result<()> {
    let (Some(fps), Some(plates)) = (
        shot.backplate.as_ref().and_then(|keys| keys.fps),
        files(shot, source)?,
    ) else {
        return Ok(());
    };
    if source.gives("probe.fps") || plates.is_still() || fps == shot.probe.fps {
        return Ok(());
    }
    // What cannot be read is said where it is needed.
    let (Ok(span), Ok(light)) = (span(&plates), LightSpan::of(probe)) else {
        return Ok(());
    };
    let what = match light {
        LightSpan::Still => {
            format!("{fps} frames a second, as backplate.fps says: a still light has no rate")
        }
        _ if light.is_as_long_as(span) => format!(
            "{fps} frames a second, as backplate.fps says, for the light too: it is as long, and probe.fps is not given"
        ),
        _ => {
            let guess = format!(
                "probe.fps is not given, and backplate.fps is {fps}: the light is taken to have {} frames a second",
                shot.probe.fps
            );
            return notes.guess(probe.folder(), &guess, "give probe.fps");
        }
    };
    notes.note(&plates.path(span[0]), what);
    shot.probe.fps = fps;
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
    /// The footage of a shot, if it has one: finds its frames and how they belong to those of the probe.
    ///
    /// # Errors
    /// There is none of its files; or which frames belong together is a guess, and `notes` is strict.
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
        Self::new(files, shot, LightSpan::of(probe)?, span, notes).map(Some)
    }

    /// Footage whose first and last frame have these numbers; the first is there.
    ///
    /// # Errors
    /// Its first frame cannot be read; or which frames belong together is a guess, and `notes` is strict.
    pub fn new(
        files: FrameFiles,
        shot: &Shot,
        light: LightSpan,
        span: [i32; 2],
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
            pairing: Pairing {
                first: 0,
                first_plate: 0,
                ratio: 1.0,
            },
            files,
        };
        if !footage.is_still() {
            footage.pairing = footage.pair(&keys, shot.probe.fps, light, notes)?;
        }
        Ok(footage)
    }

    /// Which of its frames belong to those of a shot of `fps` frames a second. As `backplate.offset` says; else by time where the
    /// rates differ; else the first to the first where the lengths are equal; else by number.
    fn pair(
        &self,
        keys: &Backplate,
        fps: f32,
        light: LightSpan,
        notes: &mut Notes,
    ) -> Result<Pairing> {
        let [from, to] = self.span;
        let file = self.files.path(from);
        let own = keys.fps.unwrap_or(fps);
        let ratio = match own == fps {
            true => 1.0,
            false => f64::from(own) / f64::from(fps),
        };
        if ratio != 1.0 {
            notes.note(
                &file,
                format!("the footage has {own} frames a second, the probe {fps}: they are matched by time"),
            );
        }
        let from_first_to = |first: i32, first_plate: i64| Pairing {
            first: first.into(),
            first_plate,
            ratio,
        };
        Ok(match (light, keys.offset) {
            // A still light has no numbers of its own.
            (LightSpan::Still, offset) => Pairing {
                first: i64::from(from) - i64::from(offset.unwrap_or(0)),
                first_plate: from.into(),
                ratio,
            },
            (LightSpan::Sequence([first, _]) | LightSpan::Live(first), Some(offset)) => {
                from_first_to(first, i64::from(first) + i64::from(offset))
            }
            (LightSpan::Sequence([first, _]) | LightSpan::Live(first), None) if ratio != 1.0 => {
                from_first_to(first, from.into())
            }
            (LightSpan::Sequence([first, last]), None)
                if first != from && light.is_as_long_as(self.span) =>
            {
                let what = format!(
                    "light and backplate are equally long, so frame {from} of the backplate belongs to frame {first}"
                );
                match first <= to && from <= last {
                    true => notes.guess(
                        &file,
                        &format!("{what}, though both have frames of one number"),
                        &format!(
                            "backplate.offset = {} says so, and 0 matches them by number",
                            i64::from(from) - i64::from(first)
                        ),
                    )?,
                    false => notes.note(&file, format!("{what}; backplate.offset says otherwise")),
                }
                from_first_to(first, from.into())
            }
            (LightSpan::Sequence([first, _]) | LightSpan::Live(first), None) => {
                from_first_to(first, first.into())
            }
        })
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
    fn covers(&self, frame: i32) -> bool {
        let [first, last] = self.span.map(i64::from);
        self.is_still() || (first..=last).contains(&self.pairing.of(frame.into()))
    }

    /// The number of the footage's frame that belongs to a frame of the shot, whether it is there or not.
    pub fn number(&self, frame: i32) -> i32 {
        let number = self.pairing.of(frame.into());
        number.clamp(i32::MIN.into(), i32::MAX.into()) as i32
    }

    /// The file that belongs to a frame of the shot.
    pub fn file(&self, frame: i32) -> PathBuf {
        self.files.path(self.number(frame))
    }

    /// The first and the last frame that both probe and footage have; says which are left out.
    ///
    /// # Errors
    /// There is none.
    pub fn shared(&self, probe: &FrameFiles, notes: &mut Notes) -> Result<[i32; 2]> {
        let there = match (probe.is_still(), self.is_still()) {
            (true, false) => self.own_frames(),
            _ => probe.existing()?,
        };
        let covered: Vec<i32> = there.iter().copied().filter(|f| self.covers(*f)).collect();
        let (&low, &high) = (there.first().zip(there.last())).unwrap_or((&1, &1));
        let [from, to] = self.span;
        let Some((&first, &last)) = covered.first().zip(covered.last()) else {
            let what = format!(
                "the backplate has frames {from} to {to}, the probe {low} to {high}: none belong together"
            );
            return Err(Error::input(&self.files.path(from), what)
                .fix(format!(
                    "backplate.offset = {} lays frame {low} over {from}, the first over the first; or number both alike",
                    i64::from(from) - i64::from(low)
                )));
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
            let [before, after] = [ends[0] - 1, ends[1] + 1].map(|f| self.pairing.of(f));
            left_out("backplate", "probe", [from.into(), before]);
            left_out("backplate", "probe", [after, to.into()]);
        }
        Ok([first, last])
    }

    /// The frames of a shot whose light is a still: as long as the footage lasts.
    fn own_frames(&self) -> Vec<i32> {
        let first = self.pairing.first;
        let frames = (first..).map_while(|f| i32::try_from(f).ok());
        frames.take_while(|f| self.covers(*f)).collect()
    }

    /// Sees that all of these frames of the shot have footage, of one size.
    ///
    /// # Errors
    /// The first that has not.
    pub fn require(&self, frames: &[i32], image: UVec2, notes: &mut Notes) -> Result<()> {
        for &frame in frames {
            let file = self.file(frame);
            if !file.is_file() && !self.is_still() {
                let [from, to] = self.span;
                let what = format!("the backplate of frame {frame} is missing");
                return Err(Error::input(&file, what).fix(format!(
                    "supply it, choose other frames with --frames (there are frames {from} to {to}), or say with backplate.offset which belong together"
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
    pub fn digests(&self, frames: &[i32]) -> Result<Vec<Hash>> {
        if self.is_still() {
            return Ok(vec![of_file(&self.file(1))?; frames.len()]);
        }
        frames.par_iter().map(|&f| of_file(&self.file(f))).collect()
    }

    /// Reads the footage of a frame of the shot and brings it to the image's size. The hash is that of its file.
    ///
    /// # Errors
    /// The file cannot be read, is broken or of another size than the first; or it has defects and `notes` is strict.
    pub fn load(&self, frame: i32, image: UVec2, notes: &mut Notes) -> Result<(Plate, Hash)> {
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
                // What was just within the bound may be beyond it with other primaries.
                let most = Vec3::splat(MAX_RADIANCE);
                let convert =
                    |c: &mut Vec3| *c = (matrix * c.as_dvec3()).as_vec3().clamp(-most, most);
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
        let pairing = |first, first_plate, ratio| Pairing {
            first,
            first_plate,
            ratio,
        };
        let faster = pairing(10, 1001, 2.0);
        assert_eq!(
            [9, 10, 11, 14].map(|f| faster.of(f)),
            [999, 1001, 1003, 1009]
        );
        let slower = pairing(1, 1, 24.0 / 60.0);
        assert_eq!([1, 2, 3, 4, 6].map(|f| slower.of(f)), [1, 1, 2, 2, 3]);
        assert_eq!(pairing(-3, -3, 1.0).of(7), 7);
    }

    #[test]
    fn lengths_are_compared() {
        let light = LightSpan::Sequence([-1, 3]);
        assert!(light.is_as_long_as([1001, 1005]) && !light.is_as_long_as([1, 4]));
        assert!(LightSpan::Sequence([i32::MIN, i32::MAX]).is_as_long_as([i32::MIN, i32::MAX]));
        assert!(
            !LightSpan::Still.is_as_long_as([1, 1]) && !LightSpan::Live(1).is_as_long_as([1, 1])
        );
    }
}
