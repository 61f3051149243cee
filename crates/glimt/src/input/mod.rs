//! Host file: HDR images in: what kind of file it is, how large, and its texels as linear radiance.

pub mod bad_texels;
pub mod encoding;
pub mod exr;
pub mod footage;
pub mod frames;
pub mod hdr;
pub mod light_image;
pub mod pattern;
pub mod pfm;
pub mod plate;
mod png_colour;
pub mod primaries;
pub mod resample;

pub use bad_texels::BadTexels;

use crate::error::{Error, Result};
use crate::memory;
use crate::notes::Notes;
use crate::shot::digest::Hash;
use crate::shot::{self, Shot};
use encoding::Transfer;
use glam::{UVec2, Vec4};
use primaries::{Primaries, REC_709};
use rayon::prelude::*;
use serde::Serialize;
use std::fs::File;
use std::io::Read;
use std::path::Path;

/// How files of images are read, where their headers are not to decide.
#[derive(Clone, Debug, PartialEq)]
pub struct Reading {
    /// The table of the shot that the keys below stand in, for messages; empty for what no shot names.
    pub table: &'static str,
    /// The layer, part or view to read; empty for the one that is a picture.
    pub layer: String,
    /// The primaries of its colours; those that the header names, if not given.
    pub primaries: Option<Primaries>,
    /// The curve of its numbers; that of its format and header, if not given.
    pub transfer: Option<Transfer>,
    /// The most texels that are taken.
    pub max_texels: u64,
    /// The primaries that light is converted to.
    pub working: Primaries,
}

impl Default for Reading {
    fn default() -> Self {
        Self {
            table: "",
            layer: String::new(),
            primaries: None,
            transfer: None,
            max_texels: shot::MAX_TEXELS,
            working: REC_709,
        }
    }
}

impl Reading {
    /// How a shot's light is read.
    #[must_use]
    pub fn of_probe(shot: &Shot) -> Self {
        Self {
            table: "probe",
            layer: shot.probe.layer.clone(),
            primaries: shot.probe.primaries.map(shot::NamedPrimaries::primaries),
            ..Self::of_images(shot)
        }
    }

    /// How a shot's backplate is read.
    #[must_use]
    pub fn of_plate(shot: &Shot) -> Self {
        let keys = shot.backplate.clone().unwrap_or_default();
        Self {
            table: "backplate",
            layer: keys.layer,
            primaries: keys.primaries.map(shot::NamedPrimaries::primaries),
            transfer: keys.transfer.map(shot::NamedTransfer::transfer),
            ..Self::of_images(shot)
        }
    }

    fn of_images(shot: &Shot) -> Self {
        Self {
            max_texels: shot.image.max_texels,
            working: shot.image.primaries.primaries(),
            ..Self::default()
        }
    }

    /// The key of this name, or how to say it where no shot gives it.
    fn key(&self, name: &str) -> String {
        match self.table {
            "" => format!("probe.{name} or backplate.{name}"),
            table => format!("{table}.{name}"),
        }
    }
}

/// An image of linear radiance. Its texels are as in the file: some may be no radiance at all.
#[derive(Clone, Debug)]
pub struct HdrImage {
    /// What the header says.
    pub header: Header,
    /// Texels, rows from the top; w is 1.
    pub texels: Vec<Vec4>,
    /// The primaries of their colours.
    pub primaries: Primaries,
    /// Hash of the bytes that they were decoded from.
    pub hash: Hash,
}

impl HdrImage {
    /// Converts the finite texels to these primaries: the conversion is linear, so negative channels take part.
    pub fn convert_to(&mut self, target: &Primaries) {
        let Some(matrix) = self.primaries.matrix_to(target) else {
            return;
        };
        self.primaries = *target;
        self.texels.par_iter_mut().for_each(|texel| {
            if texel.is_finite() {
                let converted = matrix * texel.truncate().as_dvec3();
                *texel = converted.as_vec3().extend(1.0);
            }
        });
    }
}

/// What the header of an image says.
#[derive(Clone, Debug, Serialize)]
pub struct Header {
    /// `OpenEXR`, `Radiance` or `PFM`.
    pub format: &'static str,
    /// Width and height of the image in texels: of its display window.
    #[serde(serialize_with = "as_array")]
    pub size: UVec2,
    /// Each channel's name and type.
    pub channels: Vec<String>,
    /// How the texels are stored.
    pub storage: String,
    /// First texel of the data window.
    pub data_origin: [i32; 2],
    /// Size of the data window: the texels that are stored.
    #[serde(serialize_with = "as_array")]
    pub data_size: UVec2,
    /// First texel of the display window.
    pub display_origin: [i32; 2],
    /// Parts of the file.
    pub parts: usize,
    /// The layer that is read, if it has a name.
    #[serde(skip_serializing_if = "String::is_empty")]
    pub layer: String,
    /// The other layers that hold colours.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub other_layers: Vec<String>,
    /// The primaries, and where that is known from.
    pub primaries: String,
    /// The curve of the numbers.
    pub transfer: String,
    /// Width of a pixel over its height.
    pub pixel_aspect: f32,
    /// What else is worth knowing.
    pub remarks: Vec<String>,
}

impl Header {
    /// Whether the stored texels are the image's: otherwise the image is cropped, or black where nothing is stored.
    pub fn data_is_display(&self) -> bool {
        self.data_origin == self.display_origin && self.data_size == self.size
    }
}

fn as_array<S: serde::Serializer>(
    size: &UVec2,
    serializer: S,
) -> std::result::Result<S::Ok, S::Error> {
    size.to_array().serialize(serializer)
}

/// A kind of image file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// OpenEXR.
    Exr,
    /// Radiance RGBE.
    Hdr,
    /// Portable float map.
    Pfm,
    /// PNG.
    Png,
    /// JPEG.
    Jpeg,
    /// TIFF.
    Tiff,
}

impl Format {
    /// Whether its numbers are linear light, of any size: none of a display.
    #[must_use]
    pub fn is_hdr(self) -> bool {
        matches!(self, Self::Exr | Self::Hdr | Self::Pfm)
    }
}

/// Finds the format of a file by its first bytes.
///
/// # Errors
/// The file cannot be read, or is not an image.
pub fn format_of(file: &Path) -> Result<Format> {
    format_by(file, &start_of(file)?)
}

fn format_by(file: &Path, start: &[u8]) -> Result<Format> {
    match start {
        [0x76, 0x2f, 0x31, 0x01, ..] => Ok(Format::Exr),
        [b'#', b'?', ..] => Ok(Format::Hdr),
        [b'P', b'F' | b'f', b'\n' | b'\r' | b' ' | b'\t', ..] => Ok(Format::Pfm),
        [0x89, b'P', b'N', b'G', ..] => Ok(Format::Png),
        [0xff, 0xd8, ..] => Ok(Format::Jpeg),
        [b'I', b'I', 42, 0, ..] | [b'M', b'M', 0, 42, ..] => Ok(Format::Tiff),
        _ if is_movie(file, start) => Err(movie(file)),
        _ => Err(Error::input(
            file,
            "it is neither OpenEXR, Radiance, PFM, PNG, JPEG nor TIFF",
        )
        .fix("convert it to one of these")),
    }
}

/// Whether a file is a movie: by its first bytes, or where these say nothing, by its name.
fn is_movie(file: &Path, start: &[u8]) -> bool {
    let by_name = file.extension().is_some_and(|extension| {
        let known = [
            "mp4", "mov", "m4v", "mkv", "webm", "avi", "mxf", "mpg", "mpeg", "mts", "m2ts", "ogv",
            "wmv",
        ];
        known
            .iter()
            .any(|name| extension.eq_ignore_ascii_case(name))
    });
    match start {
        [_, _, _, _, b'f', b't', b'y', b'p', ..] => true,
        [0x1a, 0x45, 0xdf, 0xa3, ..] => true,
        [b'R', b'I', b'F', b'F', _, _, _, _, b'A', b'V', b'I', ..] => true,
        _ => by_name,
    }
}

/// The error of a movie, with the command that makes frames of it.
fn movie(file: &Path) -> Error {
    let stem = file.file_stem().unwrap_or_default().to_string_lossy();
    let name = file.file_name().unwrap_or_default().to_string_lossy();
    Error::input(file, "it is a movie, and frames are read").fix(format!(
        "run `ffmpeg -i \"{name}\" -start_number 1 \"{stem}.%04d.png\"` in its folder, and name \"{stem}.####.png\""
    ))
}

/// The first bytes of a file, by which its format is known.
fn start_of(file: &Path) -> Result<Vec<u8>> {
    let mut start = Vec::new();
    let reader = File::open(file).map_err(|e| Error::reading(file, &e))?;
    let mut reader = reader.take(16);
    reader
        .read_to_end(&mut start)
        .map_err(|e| Error::reading(file, &e))?;
    match start.is_empty() {
        true => Err(empty(file)),
        false => Ok(start),
    }
}

/// All of a file's bytes, at least one. What is decoded of them and their hash belong together, even if the file is replaced.
fn read_bytes(file: &Path) -> Result<Vec<u8>> {
    let bytes = std::fs::read(file).map_err(|e| Error::reading(file, &e))?;
    match bytes.is_empty() {
        true => Err(empty(file)),
        false => Ok(bytes),
    }
}

fn empty(file: &Path) -> Error {
    Error::input(file, "the file is empty").fix("copy or export it again")
}

/// Whether a file is a display image, as PNG or JPEG, by its first bytes.
///
/// # Errors
/// The file cannot be read, or is not an image.
pub fn is_display(file: &Path) -> Result<bool> {
    Ok(!format_of(file)?.is_hdr())
}

/// Reads the header of an HDR image.
///
/// # Errors
/// The file cannot be read, is not an HDR image that is understood, or is larger than `reading` allows.
pub fn read_header(file: &Path, reading: &Reading) -> Result<Header> {
    match format_of(file)? {
        Format::Exr => exr::read_header(file, reading),
        Format::Hdr => hdr::read_header(file, reading),
        Format::Pfm => pfm::read_header(file, reading),
        Format::Png | Format::Jpeg | Format::Tiff => Err(no_hdr(file)),
    }
}

fn no_hdr(file: &Path) -> Error {
    Error::input(file, "it holds no high dynamic range")
        .fix("light has to be OpenEXR (.exr) or Radiance (.hdr) here")
}

/// Bytes at a texel while an image is decoded: of its channels, and of its texels.
const DECODED_BYTES: u64 = 32;

/// Sees that an image of this size is not too large.
fn require_bound(file: &Path, size: UVec2, reading: &Reading) -> Result<()> {
    if size.min_element() == 0 {
        return Err(Error::input(file, "it has no texels").fix("copy or export it again"));
    }
    let texels = u64::from(size.x) * u64::from(size.y);
    if texels > reading.max_texels {
        let what = format!("it has {} × {} texels", size.x, size.y);
        return Err(Error::input(file, what).fix(format!(
            "{} are the most that are taken: scale it down, or raise image.max_texels",
            reading.max_texels
        )));
    }
    Ok(())
}

/// Sees that an image of this size can be decoded.
fn require_room(file: &Path, size: UVec2, reading: &Reading) -> Result<()> {
    require_bound(file, size, reading)?;
    let texels = u64::from(size.x) * u64::from(size.y);
    let what = format!("an image of {} × {} texels", size.x, size.y);
    let room = memory::require(&what, texels * DECODED_BYTES);
    room.map_err(|e| {
        e.file(file)
            .fix("free some, raise its limit, or scale the image down")
    })
}

/// Reads an HDR image, converted to Rec. 709 primaries.
///
/// # Errors
/// The file cannot be read, or is not an HDR image that is understood.
pub fn read_image(file: &Path, notes: &mut Notes) -> Result<HdrImage> {
    let mut image = read_as(file, &Reading::default(), notes)?;
    image.convert_to(&REC_709);
    Ok(image)
}

/// Reads an HDR image, with the primaries that it has.
///
/// # Errors
/// The file cannot be read, is not an HDR image that is understood, or is larger than `reading` allows.
pub fn read_as(file: &Path, reading: &Reading, notes: &mut Notes) -> Result<HdrImage> {
    decode_image(file, &read_bytes(file)?, reading, notes)
}

/// Decodes an HDR image that was read from `file`.
fn decode_image(
    file: &Path,
    bytes: &[u8],
    reading: &Reading,
    notes: &mut Notes,
) -> Result<HdrImage> {
    match format_by(file, bytes)? {
        Format::Exr => exr::decode(file, bytes, reading, notes),
        Format::Hdr => hdr::decode(file, bytes, reading, notes),
        Format::Pfm => pfm::decode(file, bytes, reading, notes),
        Format::Png | Format::Jpeg | Format::Tiff => Err(no_hdr(file)),
    }
}

/// The curve that the key gives, applied to an image whose numbers are otherwise linear.
fn apply_transfer(texels: &mut [Vec4], transfer: Transfer) {
    if transfer == Transfer::Linear {
        return;
    }
    texels.par_iter_mut().for_each(|texel| {
        let light = texel
            .truncate()
            .to_array()
            .map(|c| transfer.decode(f64::from(c)) as f32);
        *texel = glam::Vec3::from(light).extend(1.0);
    });
}

/// Primaries and where they are known from, for those who look at a file.
fn told_primaries(reading: &Reading, of_file: Primaries, source: &str) -> String {
    match reading.primaries {
        Some(given) => format!("{given} ({})", reading.key("primaries")),
        None => format!("{of_file} ({source})"),
    }
}
