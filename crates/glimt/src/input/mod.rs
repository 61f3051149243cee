//! Host file: HDR images in: what kind of file it is, how large, and its texels as linear Rec. 709 radiance.

pub mod bad_texels;
pub mod exr;
pub mod footage;
pub mod frames;
pub mod hdr;
pub mod light_image;
pub mod pattern;
pub mod plate;
pub mod primaries;
pub mod resample;

pub use bad_texels::BadTexels;

use crate::error::{Error, Result};
use crate::memory;
use crate::notes::Notes;
use crate::shot::digest::Hash;
use glam::{UVec2, Vec4};
use serde::Serialize;
use std::fs::File;
use std::io::Read;
use std::path::Path;

/// An image of linear radiance with Rec. 709 primaries. Its texels are as in the file: some may be no radiance at all.
#[derive(Clone, Debug)]
pub struct HdrImage {
    /// What the header says.
    pub header: Header,
    /// Texels, rows from the top; w is 1.
    pub texels: Vec<Vec4>,
    /// Hash of the bytes that they were decoded from.
    pub hash: Hash,
}

/// What the header of an image says.
#[derive(Clone, Debug, Serialize)]
pub struct Header {
    /// `OpenEXR` or `Radiance`.
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
    /// Layers (parts) of the file.
    pub layers: usize,
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

/// A kind of HDR file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// OpenEXR.
    Exr,
    /// Radiance RGBE.
    Hdr,
}

/// Finds the format of a file by its first bytes.
///
/// # Errors
/// The file cannot be read, or is not an HDR image.
pub fn format_of(file: &Path) -> Result<Format> {
    format_by(file, &start_of(file)?)
}

fn format_by(file: &Path, start: &[u8]) -> Result<Format> {
    match start[..] {
        [0x76, 0x2f, 0x31, 0x01, ..] => Ok(Format::Exr),
        [b'#', b'?', ..] => Ok(Format::Hdr),
        [0x89, b'P', b'N', b'G', ..] | [0xff, 0xd8, ..] => Err(Error::input(
            file,
            "a PNG or JPEG holds no high dynamic range",
        )
        .fix("light has to be OpenEXR (.exr) or Radiance (.hdr)")),
        _ => Err(Error::input(file, "it is neither OpenEXR nor Radiance HDR")
            .fix("convert it to one of these")),
    }
}

/// The first bytes of a file, up to eight, by which its format is known.
fn start_of(file: &Path) -> Result<Vec<u8>> {
    let mut start = Vec::new();
    let reader = File::open(file).map_err(|e| Error::reading(file, &e))?;
    let mut reader = reader.take(8);
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

/// Whether a file is a display image, PNG or JPEG, by its first bytes.
///
/// # Errors
/// The file cannot be read, or is empty.
pub fn is_display(file: &Path) -> Result<bool> {
    Ok(is_display_start(&start_of(file)?))
}

fn is_display_start(start: &[u8]) -> bool {
    matches!(start, [0x89, b'P', b'N', b'G', ..] | [0xff, 0xd8, ..])
}

/// Reads the header of an HDR image.
///
/// # Errors
/// The file cannot be read, or is not an HDR image that is understood.
pub fn read_header(file: &Path) -> Result<Header> {
    match format_of(file)? {
        Format::Exr => exr::read_header(file),
        Format::Hdr => hdr::read_header(file),
    }
}

/// The largest image that is taken, in texels: 4 GiB of them.
const MAX_TEXELS: u64 = 1 << 28;

/// Bytes at a texel while an image is decoded: of its channels, and of its texels.
const DECODED_BYTES: u64 = 32;

/// Sees that an image of this size can be decoded.
fn require_room(file: &Path, size: UVec2) -> Result<()> {
    let texels = u64::from(size.x) * u64::from(size.y);
    if texels > MAX_TEXELS {
        let what = format!("it has {} × {} texels", size.x, size.y);
        return Err(Error::input(file, what).fix("2^28 are the most that are taken: scale it down"));
    }
    let what = format!("an image of {} × {} texels", size.x, size.y);
    let room = memory::require(&what, texels * DECODED_BYTES);
    room.map_err(|e| {
        e.file(file)
            .fix("free some, raise its limit, or scale the image down")
    })
}

/// Reads an HDR image.
///
/// # Errors
/// The file cannot be read, or is not an HDR image that is understood.
pub fn read_image(file: &Path, notes: &mut Notes) -> Result<HdrImage> {
    decode_image(file, &read_bytes(file)?, notes)
}

/// Decodes an HDR image that was read from `file`.
fn decode_image(file: &Path, bytes: &[u8], notes: &mut Notes) -> Result<HdrImage> {
    match format_by(file, bytes)? {
        Format::Exr => exr::decode(file, bytes, notes),
        Format::Hdr => hdr::decode(file, bytes, notes),
    }
}
