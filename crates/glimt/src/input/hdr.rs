//! Host file: Radiance pictures (RGBE).

use super::{HdrImage, Header, require_room};
use crate::error::{Error, Result};
use crate::notes::Notes;
use crate::shot::digest;
use glam::{UVec2, Vec4};
use image::ImageDecoder;
use image::codecs::hdr::HdrDecoder;
use std::fs::File;
use std::io::{BufRead, BufReader};
use std::path::Path;

/// Lines of the header that concern us.
struct Lines {
    size: UVec2,
    exposure: f32,
    primaries: Option<String>,
}

/// Reads the header.
///
/// # Errors
/// It is broken, or of a kind that is not supported.
pub fn read_header(file: &Path) -> Result<Header> {
    let reader = File::open(file).map_err(|e| Error::reading(file, &e))?;
    Ok(header(&read_lines(file, BufReader::new(reader))?))
}

fn header(lines: &Lines) -> Header {
    let mut remarks = Vec::new();
    if lines.exposure != 1.0 {
        remarks.push(format!("exposure {} (divided out)", lines.exposure));
    }
    if let Some(primaries) = &lines.primaries {
        remarks.push(format!("primaries {primaries} (taken as Rec. 709)"));
    }
    Header {
        format: "Radiance",
        size: lines.size,
        channels: ["R", "G", "B"]
            .map(|c| format!("{c} (shared exponent)"))
            .into(),
        storage: "RGBE".to_owned(),
        data_origin: [0, 0],
        data_size: lines.size,
        display_origin: [0, 0],
        layers: 1,
        remarks,
    }
}

/// Decodes the picture that was read from `file`; the exposure of its header is divided out.
///
/// # Errors
/// It is broken or truncated, or of a kind that is not supported.
pub fn decode(file: &Path, bytes: &[u8], notes: &mut Notes) -> Result<HdrImage> {
    let lines = read_lines(file, bytes)?;
    if let Some(primaries) = &lines.primaries {
        notes.note(
            file,
            format!("its PRIMARIES ({primaries}) are taken as Rec. 709"),
        );
    }
    let broken = |e: image::ImageError| match e {
        image::ImageError::IoError(e) => Error::reading(file, &e),
        e => Error::input(file, format!("it is broken: {e}")).fix("copy or export it again"),
    };
    // However well a row is packed, it takes as many bytes as one texel.
    if (bytes.len() as u64) < 4 * u64::from(lines.size.y) {
        return Err(too_short(file, "file"));
    }
    require_room(file, lines.size)?;
    let decoder = HdrDecoder::new_nonstrict(bytes).map_err(broken)?;
    let mut channels = vec![0; decoder.total_bytes() as usize];
    decoder.read_image(&mut channels).map_err(broken)?;
    let gain = 1.0 / lines.exposure;
    let texels = channels
        .as_chunks::<12>()
        .0
        .iter()
        .map(|b| {
            let channel =
                |i: usize| f32::from_ne_bytes([b[i], b[i + 1], b[i + 2], b[i + 3]]) * gain;
            Vec4::new(channel(0), channel(4), channel(8), 1.0)
        })
        .collect();
    Ok(HdrImage {
        header: header(&lines),
        texels,
        hash: digest::of_bytes(bytes),
    })
}

fn too_short(file: &Path, what: &str) -> Error {
    Error::input(file, format!("the {what} ends too early"))
        .fix("it is probably truncated: copy or export it again")
}

fn read_lines(file: &Path, reader: impl BufRead) -> Result<Lines> {
    let mut exposure = 1.0;
    let mut primaries = None;
    let mut in_header = true;
    for line in reader.split(b'\n').take(1000) {
        let line = line.map_err(|e| Error::reading(file, &e))?;
        let line = String::from_utf8_lossy(&line);
        let line = line.trim();
        if !in_header {
            return Ok(Lines {
                size: dimensions(file, line)?,
                exposure,
                primaries,
            });
        }
        in_header = !line.is_empty();
        match line.split_once('=') {
            Some(("EXPOSURE", value)) => {
                let factor: f32 = value.trim().parse().unwrap_or(f32::NAN);
                if !(factor > 0.0 && factor.is_finite()) {
                    return Err(
                        Error::input(file, format!("EXPOSURE={value} is not an exposure"))
                            .at("header")
                            .fix("remove that line"),
                    );
                }
                exposure *= factor;
            }
            // Some programs write a row of zeros, which says nothing.
            Some(("PRIMARIES", value)) if value.contains(|c| ('1'..='9').contains(&c)) => {
                primaries = Some(value.trim().to_owned());
            }
            Some(("FORMAT", value)) if value.trim() != "32-bit_rle_rgbe" => {
                return Err(
                    Error::input(file, format!("FORMAT={value} is not supported"))
                        .at("header")
                        .fix("convert it to 32-bit_rle_rgbe or to OpenEXR"),
                );
            }
            _ => {}
        }
    }
    Err(too_short(file, "header"))
}

/// Reads `-Y height +X width`.
fn dimensions(file: &Path, line: &str) -> Result<UVec2> {
    let words: Vec<&str> = line.split_whitespace().collect();
    if let ["-Y", height, "+X", width] = words[..]
        && let (Ok(height), Ok(width)) = (height.parse(), width.parse())
        && height > 0
        && width > 0
    {
        return Ok(UVec2::new(width, height));
    }
    Err(Error::input(file, format!("its resolution is `{line}`"))
        .at("header")
        .fix("only `-Y height +X width` is supported: convert it"))
}
