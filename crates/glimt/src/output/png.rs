//! Host file: display frames as PNG, 8 bits, sRGB.

use super::{HASH_KEY, SOFTWARE, Stamp, atomic::Pending, display_bytes, target::Target};
use crate::error::{Error, Result};
use ::png::{
    BitDepth, ColorType, Compression, Decoder, Encoder, EncodingError, PixelDimensions,
    SrgbRenderingIntent, Unit,
};
use glam::UVec2;
use glimt_render_gpu::prepare::render::FrameImage;
use std::io::Cursor;
use std::path::Path;

/// Writes a frame whose pixels have this aspect, whole or not at all.
///
/// # Errors
/// The file cannot be written.
pub fn write(file: &Target, image: &FrameImage, pixel_aspect: f32, stamp: &Stamp) -> Result<()> {
    let fail = |e| refused(file, e);
    let (bytes, alpha) = display_bytes(image);
    let mut pending = Pending::create(file)?;
    let mut encoder = Encoder::new(&mut pending, image.size.x, image.size.y);
    encoder.set_color(if alpha {
        ColorType::Rgba
    } else {
        ColorType::Rgb
    });
    encoder.set_depth(BitDepth::Eight);
    encoder.set_compression(Compression::Balanced);
    encoder.set_source_srgb(SrgbRenderingIntent::Perceptual);
    if pixel_aspect != 1.0 {
        encoder.set_pixel_dims(Some(PixelDimensions {
            xppu: ASPECT_UNIT,
            yppu: (ASPECT_UNIT as f32 * pixel_aspect).round() as u32,
            unit: Unit::Unspecified,
        }));
    }
    let texts = [
        (HASH_KEY, stamp.hash.clone()),
        ("Software", SOFTWARE.to_owned()),
        ("Comment", format!("frame {}", stamp.frame)),
    ];
    for (key, text) in texts {
        encoder.add_text_chunk(key.to_owned(), text).map_err(fail)?;
    }
    let mut writer = encoder.write_header().map_err(fail)?;
    writer.write_image_data(&bytes).map_err(fail)?;
    writer.finish().map_err(fail)?;
    pending.commit()
}

/// Writes an image of one byte a pixel that are numbers, not brightnesses, whole or not at all.
///
/// # Errors
/// The file cannot be written.
pub fn write_mask(file: &Target, size: UVec2, values: &[u8]) -> Result<()> {
    write_plain(file, size, values, ColorType::Grayscale)
}

/// Writes a picture of three sRGB bytes a pixel, whole or not at all.
///
/// # Errors
/// The file cannot be written.
pub fn write_rgb(file: &Target, size: UVec2, codes: &[u8]) -> Result<()> {
    write_plain(file, size, codes, ColorType::Rgb)
}

fn write_plain(file: &Target, size: UVec2, bytes: &[u8], colour: ColorType) -> Result<()> {
    let fail = |e| refused(file, e);
    let mut pending = Pending::create(file)?;
    let mut encoder = Encoder::new(&mut pending, size.x, size.y);
    encoder.set_color(colour);
    encoder.set_depth(BitDepth::Eight);
    encoder
        .add_text_chunk("Software".to_owned(), SOFTWARE.to_owned())
        .map_err(fail)?;
    let mut writer = encoder.write_header().map_err(fail)?;
    writer.write_image_data(bytes).map_err(fail)?;
    writer.finish().map_err(fail)?;
    pending.commit()
}

fn refused(file: &Target, error: EncodingError) -> Error {
    match error {
        EncodingError::IoError(e) => Error::writing(file.path(), &e),
        e => Error::output(file.path(), e),
    }
}

/// Pixels to a unit of length across, where their aspect is written: it has so many digits.
const ASPECT_UNIT: u32 = 10_000;

/// The last chunk of every PNG: no data, its name, its checksum.
const END: &[u8] = b"\0\0\0\0IEND\xae\x42\x60\x82";

/// The identity that a frame was stored with; `None` if there is no such frame, none of ours, or not all of it.
pub fn read_hash(file: &Path) -> Option<String> {
    let bytes = std::fs::read(file).ok()?;
    if !bytes.ends_with(END) {
        return None;
    }
    let reader = Decoder::new(Cursor::new(bytes)).read_info().ok()?;
    let texts = &reader.info().uncompressed_latin1_text;
    let text = texts.iter().find(|chunk| chunk.keyword == HASH_KEY)?;
    Some(text.text.clone())
}

/// Reads back the pixels of a frame that [`write()`] stored.
///
/// # Errors
/// The file cannot be read.
pub fn read_pixels(file: &Path) -> Result<Vec<[u8; 4]>> {
    let image = image::open(file)
        .map_err(|e| Error::input(file, e).fix("remove it, and render it again"))?;
    Ok(image.to_rgba8().into_raw().as_chunks::<4>().0.to_vec())
}
