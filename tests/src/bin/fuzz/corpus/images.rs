//! Host file: pictures, each read as light, as a photograph of a mirror ball, and as a plate.

use super::{Maker, Seed, exr};
use crate::mutate::repair;
use image::codecs::hdr::HdrEncoder;
use image::codecs::jpeg::JpegEncoder;
use image::{DynamicImage, ImageFormat, Rgb, RgbImage};
use std::io::Cursor;

/// Width and height of the pictures: that of light in all directions.
pub(super) const SIZE: [u32; 2] = [20, 10];

pub(super) fn add(maker: &mut Maker<'_>) -> Result<(), String> {
    for (bytes, is_refused) in exr::all()? {
        add_image(maker, "exr", bytes, "lat-long")?.is_refused = is_refused;
    }
    for bytes in hdr()? {
        add_image(maker, "hdr", bytes, "lat-long")?;
    }
    let faces = "-Y 10 +X 60\n";
    add_image(maker, "hdr", radiance(faces, 600), "cube")?;
    for bytes in png()? {
        add_image(maker, "png", bytes, "lat-long")?;
    }
    for bytes in jpeg()? {
        add_image(maker, "jpg", bytes, "lat-long")?;
    }
    for bytes in tiff() {
        add_image(maker, "tif", bytes, "lat-long")?;
    }
    for bytes in pfm() {
        add_image(maker, "pfm", bytes, "lat-long")?;
    }
    Ok(())
}

/// Adds a picture: light in all directions, which lie in it by `mapping`, a photograph of a mirror ball, and a plate.
fn add_image<'a>(
    maker: &'a mut Maker<'_>,
    extension: &'static str,
    bytes: Vec<u8>,
    mapping: &str,
) -> Result<&'a mut Seed, String> {
    let name = format!("a.{extension}");
    let shot = |probe: &str, more: &str| {
        format!(
            "[image]\nsize = [8, 6]\nrays_per_pixel = 1\n[probe]\nframes = \"{probe}\"\n{more}\n\
             [[object]]\nmesh = \"plane\"\n"
        )
    };
    let light = shot(&name, &format!("mapping = \"{mapping}\""));
    let ball = shot(
        &name,
        "mapping = \"mirror-ball\"\n[probe.ball]\ncentre_px = [5.0, 5.0]\nradius_px = 4.5\n",
    );
    let plate = format!(
        "{}[backplate]\nframes = \"{name}\"\n",
        shot("light.hdr", "")
    );
    let small = radiance_flat();
    let fixed: [(&str, &[u8]); 4] = [
        ("light.toml", light.as_bytes()),
        ("ball.toml", ball.as_bytes()),
        ("plate.toml", plate.as_bytes()),
        ("light.hdr", &small),
    ];
    let info = format!("info {name}");
    let commands = [
        info.as_str(),
        "load light.toml",
        "load ball.toml",
        "load plate.toml",
    ];
    maker.add(extension, vec![(name, bytes)], &fixed, &commands)
}

/// A picture of some colours, with an edge and a gradient.
pub(super) fn picture() -> RgbImage {
    RgbImage::from_fn(SIZE[0], SIZE[1], |x, y| {
        let edge = if x > 8 { 200 } else { 20 };
        Rgb([(x * 16) as u8, (y * 31) as u8, edge])
    })
}

/// A picture as a PNG.
pub(super) fn png_of(image: &DynamicImage) -> Result<Vec<u8>, String> {
    encoded(image, ImageFormat::Png)
}

/// A picture in a format.
pub(super) fn encoded(image: &DynamicImage, format: ImageFormat) -> Result<Vec<u8>, String> {
    let mut bytes = Cursor::new(Vec::new());
    image
        .write_to(&mut bytes, format)
        .map_err(|e| format!("a picture as {format:?}: {e}"))?;
    Ok(bytes.into_inner())
}

fn png() -> Result<Vec<Vec<u8>>, String> {
    let image = DynamicImage::from(picture());
    let kinds = [
        image.clone(),
        image.to_luma8().into(),
        image.to_luma_alpha8().into(),
        image.to_rgba8().into(),
        image.to_luma16().into(),
        image.to_rgb16().into(),
        image.to_rgba16().into(),
    ];
    let mut all: Vec<Vec<u8>> = kinds.iter().map(png_of).collect::<Result<_, _>>()?;
    // After the header come chunks of colour, of the size of a pixel, and of the camera.
    let chunks: [(&[u8; 4], &[u8]); 6] = [
        (b"gAMA", &100_000u32.to_be_bytes()),
        (b"cICP", &[9, 13, 0, 1]),
        (b"sRGB", &[0]),
        (b"cHRM", &[0; 32]),
        (b"pHYs", &[0, 0, 0, 2, 0, 0, 0, 1, 0]),
        (b"eXIf", EXIF),
    ];
    for (kind, data) in chunks {
        let mut bytes = all[0].clone();
        let chunk = repair::png_chunk(*kind, data);
        bytes.splice(33..33, chunk);
        all.push(bytes);
    }
    Ok(all)
}

/// What a camera says: that the picture is to be turned.
const EXIF: &[u8] = b"II*\0\x08\0\0\0\x01\0\x12\x01\x03\0\x01\0\0\0\x06\0\0\0\0\0\0\0";

fn jpeg() -> Result<Vec<Vec<u8>>, String> {
    let image = DynamicImage::from(picture());
    let mut all = Vec::new();
    for image in [image.clone(), image.to_luma8().into()] {
        let mut bytes = Vec::new();
        image
            .write_with_encoder(JpegEncoder::new_with_quality(&mut bytes, 80))
            .map_err(|e| e.to_string())?;
        all.push(bytes);
    }
    let mut turned = all[0].clone();
    let mut segment = vec![0xff, 0xe1];
    segment.extend((2 + 6 + EXIF.len() as u16).to_be_bytes());
    segment.extend(b"Exif\0\0");
    segment.extend(EXIF);
    turned.splice(2..2, segment);
    all.push(turned);
    Ok(all)
}

/// A picture of Radiance's, with rows that are not packed.
pub(super) fn radiance_flat() -> Vec<u8> {
    let [width, height] = SIZE;
    radiance(&format!("-Y {height} +X {width}\n"), width * height)
}

fn radiance(size: &str, texels: u32) -> Vec<u8> {
    let mut bytes = format!("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n{size}").into_bytes();
    for i in 0..texels {
        bytes.extend([100, 128 + i as u8 % 64, 90, 129]);
    }
    bytes
}

fn hdr() -> Result<Vec<Vec<u8>>, String> {
    let mut packed = Vec::new();
    let texels: Vec<Rgb<f32>> = picture()
        .pixels()
        .map(|p| Rgb(p.0.map(f32::from)))
        .collect();
    HdrEncoder::new(&mut packed)
        .encode(&texels, SIZE[0] as usize, SIZE[1] as usize)
        .map_err(|e| e.to_string())?;
    let flat = radiance_flat();
    let lines = b"EXPOSURE=2.5\nPRIMARIES=0.64 0.33 0.29 0.60 0.15 0.06 0.333 0.333\nCOLORCORR=1 1 1\nPIXASPECT=1\n";
    let mut said = flat.clone();
    said.splice(11..11, lines.iter().copied());
    // The old way to pack: a texel of ones repeats the one before it.
    let mut old = b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 10 +X 20\n".to_vec();
    for _ in 0..10 {
        old.extend([9, 8, 7, 128, 1, 1, 1, 19]);
    }
    Ok(vec![packed, flat, said, old])
}

/// Floats, of grey and of colours, of both orders of bytes.
fn pfm() -> Vec<Vec<u8>> {
    let [width, height] = SIZE;
    let values = |n: u32| (0..n * width * height).map(|i| 0.5 + i as f32 * 0.25);
    let mut grey = format!("Pf\n{width} {height}\n-1.0\n").into_bytes();
    grey.extend(values(1).flat_map(f32::to_le_bytes));
    let mut colour = format!("PF\n{width} {height}\n2.5\n").into_bytes();
    colour.extend(values(3).flat_map(f32::to_be_bytes));
    vec![grey, colour]
}

/// Codes of 8 and 16 bits and floats, of both orders of bytes, in two strips.
fn tiff() -> Vec<Vec<u8>> {
    let kinds = [(8, 1), (16, 1), (32, 3)];
    let orders = [false, true];
    let each = |&(bits, format): &(u16, u16)| orders.map(|is_big| tiff_of(bits, format, is_big));
    kinds.iter().flat_map(each).collect()
}

fn tiff_of(bits: u16, format: u16, is_big_endian: bool) -> Vec<u8> {
    let word = |n: u32| match is_big_endian {
        true => n.to_be_bytes(),
        false => n.to_le_bytes(),
    };
    let short = |n: u16| match is_big_endian {
        true => n.to_be_bytes(),
        false => n.to_le_bytes(),
    };
    let [width, height] = SIZE;
    let sample = |i: u32| -> Vec<u8> {
        match bits {
            8 => vec![i as u8],
            16 => short(i as u16 * 300).to_vec(),
            _ => word((0.1 * i as f32).to_bits()).to_vec(),
        }
    };
    let strip = u32::from(bits / 8) * 3 * width * height / 2;
    // The header and the lists of bits, formats, offsets and lengths; then two strips, then the directory.
    let (lists, data) = (8, 8 + 6 + 6 + 8 + 8);
    let mut file = if is_big_endian {
        b"MM".to_vec()
    } else {
        b"II".to_vec()
    };
    file.extend(short(42));
    file.extend(word(data + 2 * strip));
    file.extend([bits; 3].map(short).concat());
    file.extend([format; 3].map(short).concat());
    file.extend([data, data + strip, strip, strip].map(word).concat());
    file.extend((0..3 * width * height).flat_map(sample));
    // A tag, its type (3 is of 16 bits, 4 of 32), how many values, and the value or where they stand.
    let entries: [(u16, u16, u32, u32); 12] = [
        (256, 4, 1, width),
        (257, 4, 1, height),
        (258, 3, 3, lists),
        (259, 3, 1, 1),
        (262, 3, 1, 2),
        (273, 4, 2, lists + 12),
        (274, 3, 1, 1),
        (277, 3, 1, 3),
        (278, 4, 1, height / 2),
        (279, 4, 2, lists + 20),
        (284, 3, 1, 1),
        (339, 3, 3, lists + 6),
    ];
    file.extend(short(entries.len() as u16));
    for (tag, kind, count, value) in entries {
        file.extend([short(tag), short(kind)].concat());
        file.extend(word(count));
        match kind == 3 && count == 1 {
            true => file.extend([short(value as u16), [0; 2]].concat()),
            false => file.extend(word(value)),
        }
    }
    file.extend(word(0));
    file
}
