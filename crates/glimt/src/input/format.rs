//! Host file: which format a file of an image has, by its first bytes.

use crate::error::{Error, Result};
use std::path::Path;

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
    format_by(file, &super::start_of(file)?)
}

pub(super) fn format_by(file: &Path, start: &[u8]) -> Result<Format> {
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
