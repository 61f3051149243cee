//! Host file: one frame of footage: PNG, JPEG and TIFF as they are, or OpenEXR, Radiance and PFM as linear colour.

use super::png_colour::{self, DisplayColours};
use super::{
    BadTexels, Format, Reading, decode_image, format_by, format_of, read_bytes, read_header,
    require_bound, require_room,
};
use crate::colour::encoding::Transfer;
use crate::colour::primaries::Primaries;
use crate::error::{Error, Result};
use crate::notes::Notes;
use crate::shot::digest::{self, Hash};
use glam::{UVec2, Vec3, Vec4};
use glimt_render_gpu::prepare::plate::srgb8_to_linear;
use image::{ColorType, DynamicImage, ImageDecoder, ImageError, ImageReader};
use rayon::prelude::*;
use std::fs::File;
use std::io::{BufRead, BufReader, Cursor, Seek};
use std::path::Path;

/// A frame of footage, rows from the top.
#[derive(Clone, Debug)]
pub struct PlateImage {
    /// Width and height in pixels.
    pub size: UVec2,
    /// Its colours.
    pub colours: Colours,
    /// The primaries of its colours.
    pub primaries: Primaries,
    /// Whether nothing in it can be brighter than white.
    pub is_clipped: bool,
    /// Hash of the bytes that they were decoded from.
    pub hash: Hash,
}

/// Colours in the precision of their file.
#[derive(Clone, Debug)]
pub enum Colours {
    /// 8 bits, by the sRGB curve.
    Srgb8(Vec<[u8; 3]>),
    /// Linear; of any sign and size, but finite.
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

/// What the header of a plate says.
#[derive(Clone, Debug, PartialEq)]
pub struct PlateHeader {
    /// Width and height in pixels.
    pub size: UVec2,
    /// Width of a pixel over its height.
    pub pixel_aspect: f32,
    /// The primaries, and where that is known from.
    pub primaries: String,
    /// The curve of the numbers.
    pub transfer: String,
    /// Channels and bits.
    pub storage: String,
}

/// Reads the header of a plate.
///
/// # Errors
/// The file cannot be read, is not a plate, or is larger than `reading` allows.
pub fn read_plate_header(file: &Path, reading: &Reading) -> Result<PlateHeader> {
    let format = reading.fits(file, format_of(file)?)?;
    if format.is_hdr() {
        let header = read_header(file, reading)?;
        return Ok(PlateHeader {
            size: header.size,
            pixel_aspect: header.pixel_aspect,
            primaries: header.primaries,
            transfer: header.transfer,
            storage: header.storage,
        });
    }
    let open = || File::open(file).map_err(|e| Error::reading(file, &e));
    let mut decoder = decoder(file, BufReader::new(open()?), format, reading)?;
    let colours = display_colours(file, BufReader::new(open()?), format, decoder.color_type())?;
    let (size, turned) = size_of(file, &mut decoder)?;
    Ok(PlateHeader {
        size,
        pixel_aspect: match turned {
            true => 1.0 / colours.pixel_aspect,
            false => colours.pixel_aspect,
        },
        primaries: reading.told_primaries(colours.primaries, colours.source),
        transfer: reading.transfer.unwrap_or(colours.transfer).to_string(),
        storage: format!("{format:?}, {:?}", decoder.original_color_type()),
    })
}

/// Width and height of a plate, by its header.
///
/// # Errors
/// As [`read_plate_header`].
pub fn read_size(file: &Path, reading: &Reading) -> Result<UVec2> {
    Ok(read_plate_header(file, reading)?.size)
}

/// The size of a picture as it is turned, and whether its sides change places.
fn size_of(file: &Path, decoder: &mut impl ImageDecoder) -> Result<(UVec2, bool)> {
    let (width, height) = decoder.dimensions();
    let orientation = decoder.orientation().map_err(|e| broken(file, e))?;
    // A blank of these proportions, turned as the picture will be.
    let mut blank =
        DynamicImage::new_luma8(u32::from(width > height) + 1, u32::from(height > width) + 1);
    let before = (blank.width(), blank.height());
    blank.apply_orientation(orientation);
    match (blank.width(), blank.height()) == before {
        true => Ok((UVec2::new(width, height), false)),
        false => Ok((UVec2::new(height, width), true)),
    }
}

/// Reads a plate.
///
/// # Errors
/// The file cannot be read, is broken or truncated, or larger than `reading` allows; or has pixels that are not colours and `notes`
/// is strict.
pub fn read(file: &Path, reading: &Reading, notes: &mut Notes) -> Result<PlateImage> {
    decode(file, &read_bytes(file)?, reading, notes)
}

/// Decodes a plate that was read from `file`.
pub(super) fn decode(
    file: &Path,
    bytes: &[u8],
    reading: &Reading,
    notes: &mut Notes,
) -> Result<PlateImage> {
    match reading.fits(file, format_by(file, bytes)?)? {
        format if format.is_hdr() => decode_linear(file, bytes, reading, notes),
        format => decode_display(file, bytes, format, reading, notes),
    }
}

fn decode_linear(
    file: &Path,
    bytes: &[u8],
    reading: &Reading,
    notes: &mut Notes,
) -> Result<PlateImage> {
    let mut image = decode_image(file, bytes, reading, notes)?;
    // A colour outside the gamut is a colour; light that is negative is none.
    let bad = BadTexels {
        negative: 0,
        ..BadTexels::repair(&mut image.texels)
    };
    if bad.total() > 0 {
        let what = format!(
            "{} of {} pixels are not colours: {bad}",
            bad.total(),
            image.texels.len()
        );
        notes.defect(file, &what, bad.workaround())?;
    }
    Ok(PlateImage {
        size: image.header.size,
        colours: Colours::Linear(image.texels.iter().map(|t| t.truncate()).collect()),
        primaries: image.primaries,
        is_clipped: false,
        hash: image.hash,
    })
}

/// What a display file says of its colours: PNG has chunks for that, a TIFF of floats is linear by custom.
fn display_colours(
    file: &Path,
    reader: impl BufRead + Seek,
    format: Format,
    kind: ColorType,
) -> Result<DisplayColours> {
    match (format, kind) {
        (Format::Png, _) => png_colour::read(file, reader),
        (_, ColorType::Rgb32F | ColorType::Rgba32F) => Ok(DisplayColours {
            transfer: Transfer::Linear,
            source: "floats are linear",
            ..DisplayColours::srgb()
        }),
        _ => Ok(DisplayColours::srgb()),
    }
}

fn decode_display(
    file: &Path,
    bytes: &[u8],
    format: Format,
    reading: &Reading,
    notes: &mut Notes,
) -> Result<PlateImage> {
    if format == Format::Jpeg && !jpeg_is_whole(bytes) {
        return Err(Error::input(file, "the file ends too early")
            .fix("it is probably truncated: copy or export it again"));
    }
    let mut decoder = decoder(file, Cursor::new(bytes), format, reading)?;
    require_room(file, decoder.dimensions().into(), reading)?;
    let said = display_colours(file, Cursor::new(bytes), format, decoder.color_type())?;
    for remark in said.remarks.iter().filter(|_| reading.primaries.is_none()) {
        let taken = format!(
            "{} is taken ({} chooses)",
            said.primaries,
            reading.key("primaries")
        );
        notes.defect(file, remark, &taken)?;
    }
    let transfer = reading.transfer.unwrap_or(said.transfer);
    if said.transfer != Transfer::Srgb && format == Format::Png {
        let text = format!("its codes are read as {transfer} ({})", said.source);
        notes.note(file, text);
    }
    let orientation = decoder.orientation().map_err(|e| broken(file, e))?;
    if let Ok(Some(profile)) = decoder.icc_profile()
        && said.has_profile
        && reading.primaries.is_none()
        && !names_srgb(&profile)
    {
        notes.note(file, "its colour profile is not read: it is taken as sRGB");
    }
    if decoder.color_type().has_alpha() {
        notes.note(file, "its alpha is not used: a plate is opaque");
    }
    let kind = decoder.color_type();
    let mut image = DynamicImage::from_decoder(decoder).map_err(|e| broken(file, e))?;
    image.apply_orientation(orientation);
    let size = UVec2::new(image.width(), image.height());
    let colours = match kind {
        ColorType::Rgb32F | ColorType::Rgba32F => {
            linear_floats(file, &image.into_rgb32f(), transfer, notes)?
        }
        ColorType::L16 | ColorType::La16 | ColorType::Rgb16 | ColorType::Rgba16 => {
            let samples = image.into_rgb16().into_raw();
            let table = table(65_535, transfer);
            by_table(samples.as_chunks::<3>().0, |code| table[usize::from(code)])
        }
        _ => {
            let samples = image.into_rgb8().into_raw();
            let (pixels, _) = samples.as_chunks::<3>();
            match transfer {
                Transfer::Srgb => Colours::Srgb8(pixels.to_vec()),
                _ => {
                    let table = table(255, transfer);
                    by_table(pixels, |code| table[usize::from(code)])
                }
            }
        }
    };
    Ok(PlateImage {
        size,
        colours,
        primaries: reading.primaries.unwrap_or(said.primaries),
        is_clipped: !matches!(kind, ColorType::Rgb32F | ColorType::Rgba32F),
        hash: digest::of_bytes(bytes),
    })
}

/// Light of each code up to `most`.
fn table(most: u16, transfer: Transfer) -> Vec<f32> {
    let light = |code: u16| transfer.decode(f64::from(code) / f64::from(most)) as f32;
    (0..=most).map(light).collect()
}

fn by_table<T: Copy + Sync>(pixels: &[[T; 3]], light: impl Fn(T) -> f32 + Sync) -> Colours {
    let pixels = pixels.par_iter();
    Colours::Linear(pixels.map(|p| Vec3::from(p.map(&light))).collect())
}

/// Floats of a TIFF, which may be no colours at all.
fn linear_floats(
    file: &Path,
    image: &image::Rgb32FImage,
    transfer: Transfer,
    notes: &mut Notes,
) -> Result<Colours> {
    let pixels = image.as_raw().as_chunks::<3>().0.iter();
    let mut texels: Vec<Vec4> = pixels.map(|p| Vec3::from(*p).extend(1.0)).collect();
    super::apply_transfer(&mut texels, transfer);
    let bad = BadTexels {
        negative: 0,
        ..BadTexels::repair(&mut texels)
    };
    if bad.total() > 0 {
        let what = format!("{} pixels are not colours: {bad}", bad.total());
        notes.defect(file, &what, bad.workaround())?;
    }
    Ok(Colours::Linear(
        texels.iter().map(|t| t.truncate()).collect(),
    ))
}

fn decoder<'a, R: BufRead + Seek + 'a>(
    file: &Path,
    reader: R,
    format: Format,
    reading: &Reading,
) -> Result<impl ImageDecoder + use<'a, R>> {
    let format = match format {
        Format::Jpeg => image::ImageFormat::Jpeg,
        Format::Tiff => image::ImageFormat::Tiff,
        _ => image::ImageFormat::Png,
    };
    let mut reader = ImageReader::with_format(reader, format);
    let mut limits = image::Limits::no_limits();
    limits.max_alloc = Some(reading.max_texels.saturating_mul(MAX_PIXEL_BYTES));
    reader.limits(limits);
    let decoder = reader.into_decoder().map_err(|e| broken(file, e))?;
    require_bound(file, decoder.dimensions().into(), reading)?;
    Ok(decoder)
}

/// The most bytes of a pixel in a file: four floats.
const MAX_PIXEL_BYTES: u64 = 16;

fn broken(file: &Path, error: ImageError) -> Error {
    match error {
        ImageError::IoError(e) => Error::reading(file, &e),
        ImageError::Unsupported(e) => Error::input(file, format!("it is not supported: {e}"))
            .fix("export it as RGB of 8 or 16 bits, or as OpenEXR"),
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
