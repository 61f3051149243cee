//! Host file: HDR images in: what kind of file it is, how large, and its texels as linear radiance.

pub mod bad_texels;
pub mod exr;
pub mod footage;
mod format;
pub mod frames;
pub mod hdr;
pub mod light_image;
pub mod pattern;
pub mod pfm;
pub mod plate;
mod png_colour;
mod reading;
pub mod resample;

pub use bad_texels::BadTexels;
use format::format_by;
pub use format::{Format, format_of};
pub use reading::Reading;

use crate::colour::encoding::Transfer;
use crate::colour::primaries::{Primaries, REC_709};
use crate::error::{Error, Result};
use crate::memory;
use crate::notes::Notes;
use crate::shot::digest::Hash;
use glam::{UVec2, Vec4};
use rayon::prelude::*;
use serde::Serialize;
use std::fs::File;
use std::io::Read;
use std::path::Path;

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
    match reading.fits(file, format_of(file)?)? {
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
    match reading.fits(file, format_by(file, bytes)?)? {
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
