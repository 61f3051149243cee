//! Host file: OpenEXR pictures of every compression, in lines and in tiles, of one part and of several.

use super::images::SIZE;
use exr::image::{AnyChannel, AnyChannels, Blocks, Encoding, FlatSamples, Image, Layer};
use exr::math::Vec2;
use exr::meta::attribute::{AttributeValue, Chromaticities, EnvironmentMap, IntegerBounds, Text};
use exr::meta::header::{ImageAttributes, LayerAttributes};
use exr::prelude::{Compression, LineOrder, WritableImage, f16};
use std::io::Cursor;

type Channels = AnyChannels<FlatSamples>;

/// All of them, and whether each is refused.
pub(super) fn all() -> Result<Vec<(Vec<u8>, bool)>, String> {
    let lines = |compression| Encoding {
        compression,
        blocks: Blocks::ScanLines,
        line_order: LineOrder::Increasing,
    };
    let compressions = [
        Compression::Uncompressed,
        Compression::RLE,
        Compression::ZIP1,
        Compression::ZIP16,
        Compression::PIZ,
        Compression::PXR24,
        Compression::B44,
        Compression::B44A,
        Compression::DWAA(None),
        Compression::DWAB(None),
    ];
    let mut all = Vec::new();
    for compression in compressions {
        all.push(one(layer(
            lines(compression),
            halves(&["R", "G", "B", "A"]),
        ))?);
    }
    for compression in [
        Compression::PIZ,
        Compression::PXR24,
        Compression::DWAA(None),
    ] {
        all.push(one(layer(lines(compression), floats(&["R", "G", "B"])))?);
    }
    let zip = lines(Compression::ZIP16);
    all.push(one(layer(zip, whole_numbers()))?);
    all.push(one(layer(zip, floats(&["Y"])))?);
    all.push(one(layer(zip, floats(&["Y", "RY", "BY"])))?);
    all.push(one(layer(
        zip,
        halves(&["left.R", "left.G", "left.B", "Z"]),
    ))?);
    for compression in [
        Compression::ZIP16,
        Compression::Uncompressed,
        Compression::PIZ,
    ] {
        let tiles = Encoding {
            compression,
            blocks: Blocks::Tiles(Vec2(8, 4)),
            line_order: LineOrder::Increasing,
        };
        all.push(one(layer(tiles, halves(&["R", "G", "B"])))?);
    }
    all.push(windows()?);
    all.push(attributes()?);
    all.push(parts()?);
    let plain = all[0].clone();
    let mut all: Vec<(Vec<u8>, bool)> = all.into_iter().map(|bytes| (bytes, false)).collect();
    // Of deep data, as its header says; there is none.
    let mut deep = plain;
    deep[5] |= 0x08;
    let kind = b"type\0string\0\x0c\0\0\0deepscanlineversion\0int\0\x04\0\0\0\x01\0\0\0";
    deep.splice(8..8, kind.iter().copied());
    all.push((deep, true));
    Ok(all)
}

fn size() -> Vec2<usize> {
    Vec2(SIZE[0] as usize, SIZE[1] as usize)
}

fn value(channel: usize, i: usize) -> f32 {
    0.25 + channel as f32 + (i % 16) as f32 * 0.37 + if i > 60 { 100.0 } else { 0.0 }
}

fn channels(names: &[&str], samples: impl Fn(usize) -> FlatSamples) -> Channels {
    let list = names.iter().enumerate();
    let list = list.map(|(c, name)| AnyChannel::new(*name, samples(c)));
    AnyChannels::sort(list.collect())
}

fn halves(names: &[&str]) -> Channels {
    let half = |c| move |i| f16::from_f32(value(c, i));
    channels(names, |c| {
        FlatSamples::F16((0..size().area()).map(half(c)).collect())
    })
}

fn floats(names: &[&str]) -> Channels {
    channels(names, |c| {
        FlatSamples::F32((0..size().area()).map(|i| value(c, i)).collect())
    })
}

fn whole_numbers() -> Channels {
    channels(&["R", "G", "B"], |c| {
        FlatSamples::U32((0..size().area()).map(|i| (c * 1000 + i) as u32).collect())
    })
}

fn layer(encoding: Encoding, channels: Channels) -> Layer<Channels> {
    Layer::new(size(), LayerAttributes::default(), encoding, channels)
}

fn one(layer: Layer<Channels>) -> Result<Vec<u8>, String> {
    write(vec![layer], display())
}

/// A display window of the size of all parts, from 0.
fn display() -> ImageAttributes {
    ImageAttributes::new(IntegerBounds::from_dimensions(size()))
}

fn write(layers: Vec<Layer<Channels>>, attributes: ImageAttributes) -> Result<Vec<u8>, String> {
    let mut bytes = Cursor::new(Vec::new());
    Image::from_layers(attributes, layers)
        .write()
        .to_buffered(&mut bytes)
        .map_err(|e| format!("an EXR: {e}"))?;
    Ok(bytes.into_inner())
}

/// A data window that is not the display window.
fn windows() -> Result<Vec<u8>, String> {
    let mut layer = layer(Encoding::SMALL_LOSSLESS, halves(&["R", "G", "B"]));
    layer.attributes.layer_position = Vec2(-3, 2);
    one(layer)
}

/// Attributes that say which colours, which shape, which picture of several this is.
fn attributes() -> Result<Vec<u8>, String> {
    let mut layer = layer(Encoding::FAST_LOSSLESS, halves(&["R", "G", "B"]));
    layer.attributes.environment_map = Some(EnvironmentMap::LatitudeLongitude);
    layer.attributes.software_name = Some(Text::from("a program"));
    layer.attributes.multi_view_names = Some(vec![Text::from("left"), Text::from("right")]);
    layer.attributes.frames_per_second = Some((24000, 1001));
    let others = [
        ("colorInteropID", "lin_ap1_scene"),
        ("oiio:ColorSpace", "ACEScg"),
    ];
    for (name, value) in others {
        let value = AttributeValue::Text(Text::from(value));
        layer.attributes.other.insert(Text::from(name), value);
    }
    let mut shared = display();
    shared.pixel_aspect = 2.0;
    shared.chromaticities = Some(Chromaticities {
        red: Vec2(0.713, 0.293),
        green: Vec2(0.165, 0.830),
        blue: Vec2(0.128, 0.044),
        white: Vec2(0.32168, 0.33767),
    });
    write(vec![layer], shared)
}

/// Several parts, the first of which is no light.
fn parts() -> Result<Vec<u8>, String> {
    let part = |name: &str, channels| {
        let attributes = LayerAttributes::named(name);
        Layer::new(size(), attributes, Encoding::FAST_LOSSLESS, channels)
    };
    let layers = vec![
        part("depth", halves(&["Z"])),
        part("beauty", halves(&["R", "G", "B"])),
        part("albedo", halves(&["albedo.R", "albedo.G", "albedo.B"])),
    ];
    write(layers, display())
}
