//! Host file: one frame of footage: PNG and JPEG as they are, or OpenEXR and Radiance as linear colour.

use super::{BadTexels, decode_image, read_bytes, read_header, require_room, start_of};
use crate::error::{Error, Result};
use crate::notes::Notes;
use crate::shot::digest::{self, Hash};
use glam::{UVec2, Vec3};
use glimt_render_gpu::prepare::plate::{srgb_decode, srgb8_to_linear};
use image::{ColorType, DynamicImage, ImageDecoder, ImageError, ImageReader};
use rayon::prelude::*;
use std::fs::File;
use std::io::{BufRead, BufReader, Cursor, Seek};
use std::path::Path;
use std::sync::LazyLock;

/// The largest plate that is taken, in pixels.
const MAX_PIXELS: u64 = 1 << 28;

/// A frame of footage, rows from the top.
#[derive(Clone, Debug)]
pub struct PlateImage {
    /// Width and height in pixels.
    pub size: UVec2,
    /// Its colours.
    pub colours: Colours,
    /// Hash of the bytes that they were decoded from.
    pub hash: Hash,
}

/// Colours in the precision of their file.
#[derive(Clone, Debug)]
pub enum Colours {
    /// 8 bits, by the sRGB curve.
    Srgb8(Vec<[u8; 3]>),
    /// Linear, with Rec. 709 primaries; of any sign and size, but finite.
    Linear(Vec<Vec3>),
}

impl Colours {
    /// All of them linear.
    #[must_use]
    pub fn into_linear(self) -> Vec<Vec3> {
        match self {
            Self::Linear(linear) => linear,
            Self::Srgb8(codes) => {
                let linear = |code: &[u8; 3]| Vec3::from(code.map(srgb8_to_linear));
                codes.par_iter().map(linear).collect()
            }
        }
    }
}

/// What kind of file a plate is.
enum Format {
    /// PNG or JPEG.
    Display(image::ImageFormat),
    /// OpenEXR or Radiance.
    Linear,
}

fn format_by(file: &Path, start: &[u8]) -> Result<Format> {
    match start[..] {
        [0x89, b'P', b'N', b'G', ..] => Ok(Format::Display(image::ImageFormat::Png)),
        [0xff, 0xd8, ..] => Ok(Format::Display(image::ImageFormat::Jpeg)),
        [0x76, 0x2f, 0x31, 0x01, ..] | [b'#', b'?', ..] => Ok(Format::Linear),
        _ => Err(Error::input(file, "it is neither PNG, JPEG nor OpenEXR")
            .fix("convert it to one of these")),
    }
}

/// Width and height of a plate, by its header.
///
/// # Errors
/// The file cannot be read, or is not a plate.
pub fn read_size(file: &Path) -> Result<UVec2> {
    let Format::Display(format) = format_by(file, &start_of(file)?)? else {
        return Ok(read_header(file)?.size);
    };
    let reader = File::open(file).map_err(|e| Error::reading(file, &e))?;
    let mut decoder = decoder(file, BufReader::new(reader), format)?;
    let (width, height) = decoder.dimensions();
    let orientation = decoder.orientation().map_err(|e| broken(file, e))?;
    // A blank of these proportions, turned as the picture will be.
    let mut blank =
        DynamicImage::new_luma8(u32::from(width > height) + 1, u32::from(height > width) + 1);
    let before = (blank.width(), blank.height());
    blank.apply_orientation(orientation);
    match (blank.width(), blank.height()) == before {
        true => Ok(UVec2::new(width, height)),
        false => Ok(UVec2::new(height, width)),
    }
}

/// Reads a plate.
///
/// # Errors
/// The file cannot be read, is broken or truncated; or has pixels that are not colours and `notes` is strict.
pub fn read(file: &Path, notes: &mut Notes) -> Result<PlateImage> {
    decode(file, &read_bytes(file)?, notes)
}

/// Decodes a plate that was read from `file`.
pub(super) fn decode(file: &Path, bytes: &[u8], notes: &mut Notes) -> Result<PlateImage> {
    match format_by(file, bytes)? {
        Format::Display(format) => decode_display(file, bytes, format, notes),
        Format::Linear => decode_linear(file, bytes, notes),
    }
}

fn decode_linear(file: &Path, bytes: &[u8], notes: &mut Notes) -> Result<PlateImage> {
    let image = decode_image(file, bytes, notes)?;
    // A colour outside the gamut is a colour; light that is negative is none.
    let bad = BadTexels {
        negative: 0,
        ..BadTexels::count(&image.texels)
    };
    let mut colours: Vec<Vec3> = image.texels.iter().map(|t| t.truncate()).collect();
    if bad.total() > 0 {
        let what = format!(
            "{} of {} pixels are not colours: {bad}",
            bad.total(),
            colours.len()
        );
        notes.defect(file, &what, "those are taken as black")?;
    }
    for colour in &mut colours {
        // Far below zero is as bad as far above, but nothing writes such values.
        if !(colour.abs().max_element() <= glimt_render_gpu::prepare::env::MAX_RADIANCE)
            || colour.is_nan()
        {
            *colour = Vec3::ZERO;
        }
    }
    Ok(PlateImage {
        size: image.header.size,
        colours: Colours::Linear(colours),
        hash: image.hash,
    })
}

fn decode_display(
    file: &Path,
    bytes: &[u8],
    format: image::ImageFormat,
    notes: &mut Notes,
) -> Result<PlateImage> {
    if format == image::ImageFormat::Jpeg && !jpeg_is_whole(bytes) {
        return Err(Error::input(file, "the file ends too early")
            .fix("it is probably truncated: copy or export it again"));
    }
    let mut decoder = decoder(file, Cursor::new(bytes), format)?;
    require_room(file, decoder.dimensions().into())?;
    let orientation = decoder.orientation().map_err(|e| broken(file, e))?;
    if let Ok(Some(profile)) = decoder.icc_profile()
        && !names_srgb(&profile)
    {
        notes.note(file, "its colour profile is not read: it is taken as sRGB");
    }
    if decoder.color_type().has_alpha() {
        notes.note(file, "its alpha is not used: a plate is opaque");
    }
    let sixteen = matches!(
        decoder.color_type(),
        ColorType::L16 | ColorType::La16 | ColorType::Rgb16 | ColorType::Rgba16
    );
    let mut image = DynamicImage::from_decoder(decoder).map_err(|e| broken(file, e))?;
    image.apply_orientation(orientation);
    let size = UVec2::new(image.width(), image.height());
    let colours = if sixteen {
        let samples = image.into_rgb16().into_raw();
        static LINEAR: LazyLock<Vec<f32>> = LazyLock::new(|| {
            let linear = |code: u16| srgb_decode(f64::from(code) / 65_535.0) as f32;
            (0..=u16::MAX).map(linear).collect()
        });
        let linear = |code: u16| LINEAR[usize::from(code)];
        let (pixels, _) = samples.as_chunks::<3>();
        Colours::Linear(
            pixels
                .par_iter()
                .map(|p| Vec3::from(p.map(linear)))
                .collect(),
        )
    } else {
        Colours::Srgb8(image.into_rgb8().into_raw().as_chunks::<3>().0.to_vec())
    };
    Ok(PlateImage {
        size,
        colours,
        hash: digest::of_bytes(bytes),
    })
}

fn decoder<'a, R: BufRead + Seek + 'a>(
    file: &Path,
    reader: R,
    format: image::ImageFormat,
) -> Result<impl ImageDecoder + use<'a, R>> {
    let mut reader = ImageReader::with_format(reader, format);
    reader.no_limits();
    let decoder = reader.into_decoder().map_err(|e| broken(file, e))?;
    let (width, height) = decoder.dimensions();
    if u64::from(width) * u64::from(height) > MAX_PIXELS {
        return Err(
            Error::input(file, format!("it has {width} × {height} pixels"))
                .fix("2^28 are the most that are taken: scale it down"),
        );
    }
    Ok(decoder)
}

fn broken(file: &Path, error: ImageError) -> Error {
    match error {
        ImageError::IoError(e) => Error::reading(file, &e),
        e => Error::input(file, format!("it is broken: {e}")).fix("copy or export it again"),
    }
}

/// Whether a JPEG's picture ends before the file does (ITU T.81, § B.1). Decoders fill in grey for what is missing. What follows
/// the picture is not looked at: phones append thumbnails and films.
fn jpeg_is_whole(bytes: &[u8]) -> bool {
    let mut rest = bytes;
    while let Some(at) = rest.iter().position(|byte| *byte == 0xff) {
        rest = &rest[at + 1..];
        let Some((&code, after)) = rest.split_first() else {
            return false;
        };
        match code {
            // The end of the image.
            0xd9 => return true,
            // A byte of data; markers without a segment; a byte that fills the space before a marker, itself still to come.
            0x00 | 0x01 | 0xd0..=0xd8 => rest = after,
            0xff => {}
            // A segment, which begins with its length.
            _ => {
                let length = after.first_chunk().map_or(0, |l| u16::from_be_bytes(*l));
                let Some(next) = after.get(usize::from(length.max(2))..) else {
                    return false;
                };
                rest = next;
            }
        }
    }
    false
}

/// Whether an ICC profile calls itself sRGB, in one of the two ways that text is stored there.
fn names_srgb(profile: &[u8]) -> bool {
    let has = |name: &[u8]| profile.windows(name.len()).any(|window| window == name);
    has(b"sRGB") || has(b"s\0R\0G\0B")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_end_of_a_jpeg_is_found() {
        let mut bytes = Vec::new();
        let noise = image::RgbImage::from_fn(40, 30, |x, y| {
            image::Rgb([x * y, x ^ y, 7 * x + y].map(|c| (c % 256) as u8))
        });
        let mut cursor = Cursor::new(&mut bytes);
        noise
            .write_to(&mut cursor, image::ImageFormat::Jpeg)
            .unwrap();
        assert!(jpeg_is_whole(&bytes));
        for cut in 0..bytes.len() {
            assert!(!jpeg_is_whole(&bytes[..cut]), "{cut} of {}", bytes.len());
        }
        // A film behind it is none of the picture's.
        bytes.extend([0xff, 0xda, 0, 9, 0xff]);
        assert!(jpeg_is_whole(&bytes));
    }
}
