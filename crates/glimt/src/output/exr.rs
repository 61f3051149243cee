//! Host file: linear frames as OpenEXR: 32-bit float RGBA, premultiplied, or RGB of 32 or 16 bits; Rec. 709 primaries, ZIP.

use super::{HASH_KEY, SOFTWARE, Stamp, atomic::Pending};
use crate::error::{Error, Result};
use crate::input::primaries::REC_709;
use ::exr::image::write::channels::WritableChannels;
use ::exr::image::write::layers::WritableLayers;
use ::exr::math::Vec2;
use ::exr::meta::attribute::{AttributeValue, Chromaticities, Text};
use ::exr::prelude::{
    Blocks, Compression, Encoding, Image, Layer, LayerAttributes, LineOrder, SpecificChannels,
    WritableImage, f16,
};
use glam::{UVec2, Vec4};
use std::fs::File;
use std::io::BufReader;
use std::path::Path;

/// Key of the frame's number.
const FRAME_KEY: &str = "glimtFrame";

/// Writes a frame with alpha, whole or not at all.
///
/// # Errors
/// The file cannot be written.
pub fn write(file: &Path, size: UVec2, pixels: &[Vec4], stamp: &Stamp) -> Result<()> {
    let width = size.x as usize;
    let channels = SpecificChannels::rgba(|at: Vec2<usize>| {
        let pixel = pixels[at.y() * width + at.x()];
        (pixel.x, pixel.y, pixel.z, pixel.w)
    });
    store(file, &frame_image(size, channels, stamp))
}

/// How a frame without alpha is stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Storage {
    /// 32-bit floats, ZIP.
    Float,
    /// 32-bit floats as they are: of an image with noise, ZIP takes a third of the time and gains 6 %.
    Noisy,
    /// 16-bit floats, ZIP; values above 65504 become that.
    Half,
}

/// Writes a frame without alpha, whole or not at all.
///
/// # Errors
/// The file cannot be written.
pub fn write_rgb(
    file: &Path,
    size: UVec2,
    pixels: &[Vec4],
    stamp: &Stamp,
    storage: Storage,
) -> Result<()> {
    let width = size.x as usize;
    let pixel = |at: Vec2<usize>| pixels[at.y() * width + at.x()];
    if storage == Storage::Half {
        let channels = SpecificChannels::rgb(|at: Vec2<usize>| {
            let p = pixel(at).min(Vec4::splat(f16::MAX.to_f32()));
            (f16::from_f32(p.x), f16::from_f32(p.y), f16::from_f32(p.z))
        });
        return store(file, &frame_image(size, channels, stamp));
    }
    let channels = SpecificChannels::rgb(|at: Vec2<usize>| {
        let p = pixel(at);
        (p.x, p.y, p.z)
    });
    let mut image = frame_image(size, channels, stamp);
    if storage == Storage::Noisy {
        image.layer_data.encoding.compression = Compression::Uncompressed;
    }
    store(file, &image)
}

/// An image with what is stored beside its pixels.
fn frame_image<'c, C>(size: UVec2, channels: C, stamp: &Stamp) -> Image<Layer<C>>
where
    C: WritableChannels<'c> + 'c,
{
    let mut attributes = LayerAttributes {
        software_name: Some(Text::from(SOFTWARE)),
        ..LayerAttributes::default()
    };
    let hash = AttributeValue::Text(Text::from(stamp.hash.as_str()));
    attributes.other.insert(Text::from(HASH_KEY), hash);
    let frame = AttributeValue::I32(stamp.frame.cast_signed());
    attributes.other.insert(Text::from(FRAME_KEY), frame);

    let layer = Layer::new(
        (size.x as usize, size.y as usize),
        attributes,
        Encoding {
            compression: Compression::ZIP16,
            blocks: Blocks::ScanLines,
            line_order: LineOrder::Increasing,
        },
        channels,
    );
    let mut image = Image::from_layer(layer);
    let [red, green, blue, white] = REC_709.map(|p| Vec2(p[0], p[1]));
    image.attributes.chromaticities = Some(Chromaticities {
        red,
        green,
        blue,
        white,
    });
    image
}

fn store<'i, L>(file: &Path, image: &'i Image<L>) -> Result<()>
where
    L: WritableLayers<'i>,
{
    let mut pending = Pending::create(file)?;
    image
        .write()
        .to_buffered(&mut pending)
        .map_err(|e| match e {
            ::exr::error::Error::Io(e) => Error::writing(file, &e),
            e => Error::output(file, e),
        })?;
    pending.commit()
}

/// The identity that a frame was stored with; `None` if there is no such frame, none of ours, or not all of it.
pub fn read_hash(file: &Path) -> Option<String> {
    let reader = ::exr::block::read(BufReader::new(File::open(file).ok()?), false).ok()?;
    let attributes = &reader.headers().first()?.own_attributes.other;
    let hash = match attributes.get(&Text::from(HASH_KEY))? {
        AttributeValue::Text(hash) => hash.to_string(),
        _ => return None,
    };
    let mut chunks = reader.all_chunks(false).ok()?;
    chunks.all(|chunk| chunk.is_ok()).then_some(hash)
}

/// Reads back the pixels of a frame that [`write()`] stored.
///
/// # Errors
/// The file cannot be read.
pub fn read_pixels(file: &Path) -> Result<Vec<Vec4>> {
    let image = ::exr::prelude::read_first_rgba_layer_from_file(
        file,
        |size, _| (vec![Vec4::ZERO; size.x() * size.y()], size.x()),
        |(pixels, width): &mut (Vec<Vec4>, usize), at, (r, g, b, a): (f32, f32, f32, f32)| {
            pixels[at.y() * *width + at.x()] = Vec4::new(r, g, b, a);
        },
    );
    let broken = |e| Error::input(file, e).fix("remove it, and render it again");
    Ok(image.map_err(broken)?.layer_data.channel_data.pixels.0)
}
