//! Host file: linear frames as OpenEXR: 32-bit float RGBA, premultiplied, with further layers beside them where they are asked
//! for; or RGB of 32 or 16 bits. ZIP.

use super::aov::{Channel, DISPLAY, FORMULA_KEY};
use super::{HASH_KEY, SOFTWARE, Stamp, atomic::Pending, target::Target};
use crate::colour::primaries::{Primaries, REC_709};
use crate::error::{Error, Result};
use ::exr::error::UnitResult;
use ::exr::math::Vec2;
use ::exr::meta::attribute::{self, AttributeValue, Chromaticities, Text};
use ::exr::meta::header::Header;
use ::exr::prelude::{
    AnyChannel, AnyChannels, Blocks, Compression, Encoding, FlatSamples, Image, Layer,
    LayerAttributes, LineOrder, ReadChannels, ReadLayers, ReadSpecificChannel, SmallVec,
    WritableImage, f16,
};
use glam::{UVec2, Vec4};
use std::fs::File;
use std::io::{BufReader, Seek, SeekFrom, Write};
use std::path::Path;

/// Key of the frame's number.
const FRAME_KEY: &str = "glimtFrame";

/// What a frame's pixels are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Picture {
    /// The primaries of their colours.
    pub primaries: Primaries,
    /// Width of a pixel over its height.
    pub pixel_aspect: f32,
}

impl Default for Picture {
    /// Rec. 709 and squares.
    fn default() -> Self {
        Self {
            primaries: REC_709,
            pixel_aspect: 1.0,
        }
    }
}

/// What is written beside a frame's pixels.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Layers {
    /// Channels of any names but R, G, B and A.
    pub channels: Vec<Channel>,
    /// How the image is made of them.
    pub formula: Option<&'static str>,
    /// What the pixels are.
    pub picture: Picture,
}

/// Writes a frame, whole or not at all.
///
/// # Errors
/// The file cannot be written.
pub fn write(
    file: &Target,
    size: UVec2,
    pixels: &[Vec4],
    layers: Layers,
    stamp: &Stamp,
) -> Result<()> {
    let names = ["R", "G", "B", "A"];
    let further = layers.channels.into_iter().map(|channel| {
        let samples = match channel.half {
            true => FlatSamples::F16(channel.samples.into_iter().map(f16::from_f32).collect()),
            false => FlatSamples::F32(channel.samples),
        };
        AnyChannel::new(channel.name.as_str(), samples)
    });
    let channels = planes(pixels, &names, false).chain(further).collect();
    store(
        file,
        size,
        channels,
        Compression::ZIP16,
        layers.formula,
        layers.picture,
        stamp,
    )
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
    file: &Target,
    size: UVec2,
    pixels: &[Vec4],
    stamp: &Stamp,
    storage: Storage,
) -> Result<()> {
    let channels = planes(pixels, &["R", "G", "B"], storage == Storage::Half).collect();
    let compression = match storage {
        Storage::Noisy => Compression::Uncompressed,
        _ => Compression::ZIP16,
    };
    let picture = Picture::default();
    store(file, size, channels, compression, None, picture, stamp)
}

/// One channel for each name, of the pixels' components in turn.
fn planes<'a>(
    pixels: &'a [Vec4],
    names: &'a [&'static str],
    half: bool,
) -> impl Iterator<Item = AnyChannel<FlatSamples>> + 'a {
    let plane = move |c: usize| match half {
        true => {
            let narrow = |p: &Vec4| f16::from_f32(p[c].min(f16::MAX.to_f32()));
            FlatSamples::F16(pixels.iter().map(narrow).collect())
        }
        false => FlatSamples::F32(pixels.iter().map(|p| p[c]).collect()),
    };
    let names = names.iter().enumerate();
    names.map(move |(c, name)| AnyChannel::new(*name, plane(c)))
}

fn store(
    file: &Target,
    size: UVec2,
    channels: SmallVec<[AnyChannel<FlatSamples>; 4]>,
    compression: Compression,
    formula: Option<&'static str>,
    picture: Picture,
    stamp: &Stamp,
) -> Result<()> {
    let mut attributes = LayerAttributes {
        software_name: Some(Text::from(SOFTWARE)),
        ..LayerAttributes::default()
    };
    let hash = AttributeValue::Text(Text::from(stamp.hash.as_str()));
    attributes.other.insert(Text::from(HASH_KEY), hash);
    let frame = AttributeValue::I32(stamp.frame);
    attributes.other.insert(Text::from(FRAME_KEY), frame);
    if let Some(formula) = formula {
        let formula = AttributeValue::Text(Text::from(formula));
        attributes.other.insert(Text::from(FORMULA_KEY), formula);
    }

    let layer = Layer::new(
        (size.x as usize, size.y as usize),
        attributes,
        Encoding {
            compression,
            blocks: Blocks::ScanLines,
            line_order: LineOrder::Increasing,
        },
        AnyChannels::sort(channels),
    );
    let mut image = Image::from_layer(layer);
    let [red, green, blue, white] = picture.primaries.0.map(|p| Vec2(p[0], p[1]));
    image.attributes.pixel_aspect = picture.pixel_aspect;
    image.attributes.chromaticities = Some(Chromaticities {
        red,
        green,
        blue,
        white,
    });

    let mut pending = Pending::create(file)?;
    let writer = image.write();
    let headers = writer.infer_meta_data();
    writer
        .to_buffered(&mut pending)
        .and_then(|()| sort_attributes(&headers[0], &mut pending))
        .map_err(|e| match e {
            ::exr::error::Error::Io(e) => Error::writing(file.path(), &e),
            e => Error::output(file.path(), e),
        })?;
    pending.commit()
}

/// Bytes before the attributes: the magic number and the version.
const PREAMBLE: u64 = 8;

/// Writes the attributes of a file with one part again, over those that are there, in the order of their names. `exr` keeps
/// further attributes in a hash map, whose order differs from run to run; the same image must make the same file.
fn sort_attributes(header: &Header, file: &mut (impl Write + Seek)) -> UnitResult {
    let mut attributes: Vec<_> = header.all_named_attributes().collect();
    attributes.sort_by_key(|&(name, _)| name);
    file.seek(SeekFrom::Start(PREAMBLE))?;
    for (name, value) in &attributes {
        attribute::write(name, value, file)?;
    }
    Ok(())
}

/// The identity that a frame was stored with; `None` if there is no such frame, none of ours, not all of it, or one without
/// all of these channels.
pub fn read_hash(file: &Path, channels: &[String]) -> Option<String> {
    let reader = ::exr::block::read(BufReader::new(File::open(file).ok()?), false).ok()?;
    let header = reader.headers().first()?;
    let has = |name: &String| {
        header
            .channels
            .list
            .iter()
            .any(|c| c.name.eq(name.as_str()))
    };
    if !channels.iter().all(has) {
        return None;
    }
    let attributes = &header.own_attributes.other;
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

/// Reads back what a frame displays, from its layer [`DISPLAY`].
///
/// # Errors
/// The file cannot be read.
pub fn read_display(file: &Path) -> Result<Vec<[u8; 4]>> {
    let broken = |e| Error::input(file, e).fix("remove it, and render it again");
    let image = ::exr::prelude::read()
        .no_deep_data()
        .largest_resolution_level()
        .specific_channels()
        .required(&*format!("{DISPLAY}.R"))
        .required(&*format!("{DISPLAY}.G"))
        .required(&*format!("{DISPLAY}.B"))
        .collect_pixels(
            |size, _| (vec![[0; 4]; size.x() * size.y()], size.x()),
            |(pixels, width): &mut (Vec<[u8; 4]>, usize), at, (r, g, b): (f32, f32, f32)| {
                let code = |value: f32| (value * 255.0).round() as u8;
                pixels[at.y() * *width + at.x()] = [code(r), code(g), code(b), 255];
            },
        )
        .first_valid_layer()
        .all_attributes()
        .from_file(file);
    Ok(image.map_err(broken)?.layer_data.channel_data.pixels.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::target::Guard;
    use crate::shot::Shadow;

    /// Each image is encoded with hash maps of its own, as in another run of the program.
    #[test]
    fn the_same_image_makes_the_same_file() {
        let folder = std::env::temp_dir().join(format!("glimt-exr-{}", std::process::id()));
        super::super::atomic::prepare_folder(&folder).unwrap();
        let file = folder.join("frame.exr");
        let size = UVec2::new(5, 70);
        let pixels: Vec<_> = (0..size.element_product())
            .map(|i| Vec4::splat(i as f32))
            .collect();
        let stamp = Stamp {
            hash: "0123abcd".to_owned(),
            frame: 7,
        };
        let encoded = || {
            let channel = |name: &str| Channel {
                name: name.to_owned(),
                samples: pixels.iter().map(|p| p.x * 0.5).collect(),
                half: false,
            };
            let layers = Layers {
                channels: vec![channel("object.R"), channel("smc.age")],
                formula: Some(super::super::aov::formula(Shadow::Add)),
                picture: Picture::default(),
            };
            let target = Guard::default().target(&file).unwrap();
            write(&target, size, &pixels, layers, &stamp).unwrap();
            std::fs::read(&file).unwrap()
        };
        let first = encoded();
        for _ in 0..32 {
            assert!(encoded() == first, "the same image, other bytes");
        }
        let channels = ["object.R".to_owned(), "smc.age".to_owned()];
        assert_eq!(read_hash(&file, &channels), Some(stamp.hash));
        assert_eq!(read_pixels(&file).unwrap(), pixels);
        std::fs::remove_dir_all(&folder).unwrap();
    }
}
