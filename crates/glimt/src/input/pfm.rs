//! Host file: portable float maps: a header of three lines, then floats, rows from the bottom.

use super::{HdrImage, Header, Reading, apply_transfer, require_bound, require_room};
use crate::colour::encoding::Transfer;
use crate::colour::primaries::REC_709;
use crate::error::{Error, Result};
use crate::notes::Notes;
use crate::shot::digest;
use glam::{UVec2, Vec3, Vec4};
use std::fs::File;
use std::io::Read;
use std::path::Path;

/// The longest header that is looked at, in bytes.
const LONGEST: usize = 4096;

/// What the header says.
struct Lines {
    size: UVec2,
    channels: usize,
    little_endian: bool,
    /// Where the floats begin.
    data: usize,
}

/// Reads the header.
///
/// # Errors
/// It is broken, or the image is larger than `reading` allows.
pub fn read_header(file: &Path, reading: &Reading) -> Result<Header> {
    let mut start = Vec::new();
    let reader = File::open(file).map_err(|e| Error::reading(file, &e))?;
    let mut reader = reader.take(LONGEST as u64);
    reader
        .read_to_end(&mut start)
        .map_err(|e| Error::reading(file, &e))?;
    let lines = lines(file, &start)?;
    require_bound(file, lines.size, reading)?;
    Ok(header(&lines, reading))
}

/// Decodes the image that was read from `file`.
///
/// # Errors
/// It is broken or truncated, or larger than `reading` allows.
pub fn decode(
    file: &Path,
    bytes: &[u8],
    reading: &Reading,
    _notes: &mut Notes,
) -> Result<HdrImage> {
    let lines = lines(file, bytes)?;
    require_bound(file, lines.size, reading)?;
    let row = lines.size.x as usize * lines.channels * 4;
    let data = &bytes[lines.data..];
    if data.len() / row < lines.size.y as usize {
        return Err(Error::input(file, "the file ends too early")
            .fix("it is probably truncated: copy or export it again"));
    }
    require_room(file, lines.size, reading)?;
    let value = |bytes: &[u8; 4]| match lines.little_endian {
        true => f32::from_le_bytes(*bytes),
        false => f32::from_be_bytes(*bytes),
    };
    let rows = data.chunks_exact(row).take(lines.size.y as usize).rev();
    let mut texels: Vec<Vec4> = rows
        .flat_map(|row| row.as_chunks::<4>().0.chunks_exact(lines.channels))
        .map(|texel| match texel {
            [r, g, b] => Vec4::new(value(r), value(g), value(b), 1.0),
            _ => Vec3::splat(value(&texel[0])).extend(1.0),
        })
        .collect();
    apply_transfer(&mut texels, reading.transfer.unwrap_or(Transfer::Linear));
    Ok(HdrImage {
        header: header(&lines, reading),
        texels,
        primaries: reading.primaries.unwrap_or(REC_709),
        hash: digest::of_bytes(bytes),
    })
}

fn header(lines: &Lines, reading: &Reading) -> Header {
    let channels: &[&str] = match lines.channels {
        3 => &["R", "G", "B"],
        _ => &["Y"],
    };
    let order = match lines.little_endian {
        true => "little-endian",
        false => "big-endian",
    };
    Header {
        format: "PFM",
        size: lines.size,
        channels: channels.iter().map(|c| format!("{c} f32")).collect(),
        storage: format!("uncompressed, {order}"),
        data_origin: [0, 0],
        data_size: lines.size,
        display_origin: [0, 0],
        parts: 1,
        layer: String::new(),
        other_layers: Vec::new(),
        primaries: reading.told_primaries(REC_709, "the format names none"),
        transfer: reading.transfer.unwrap_or(Transfer::Linear).to_string(),
        pixel_aspect: 1.0,
        remarks: Vec::new(),
    }
}

/// Reads `PF` or `Pf`, width and height, and a number whose sign is the order of bytes. Its size is a unit that no two programs
/// agree on, so it is left alone, as others leave it.
fn lines(file: &Path, bytes: &[u8]) -> Result<Lines> {
    let broken = |what: &str| {
        Error::input(file, what)
            .at("header")
            .fix("copy or export it again, or convert it to OpenEXR")
    };
    let mut words = Vec::new();
    let mut at = 0;
    while words.len() < 4 {
        let rest = bytes.get(at..bytes.len().min(LONGEST)).unwrap_or_default();
        let begin = rest
            .iter()
            .position(|b| !b.is_ascii_whitespace())
            .ok_or_else(|| broken("the header ends too early"))?;
        let len = rest[begin..].iter().position(u8::is_ascii_whitespace);
        let len = len.ok_or_else(|| broken("the header ends too early"))?;
        let word = &rest[begin..begin + len];
        // One white space ends the header; the next byte is data.
        at += begin + len + 1;
        match word.first() {
            Some(b'#') => {
                let line = bytes[at - 1..].iter().position(|b| *b == b'\n');
                at += line.ok_or_else(|| broken("the header ends too early"))?;
            }
            _ => words.push(String::from_utf8_lossy(word).into_owned()),
        }
    }
    // Text that Windows wrote ends the last line by two bytes.
    if bytes.get(at - 1) == Some(&b'\r') && bytes.get(at) == Some(&b'\n') {
        at += 1;
    }
    let side = |word: &str| word.parse::<u32>().ok().filter(|n| *n > 0);
    let (Some(width), Some(height)) = (side(&words[1]), side(&words[2])) else {
        return Err(broken("its width and height are no numbers above 0"));
    };
    let order: f32 = words[3].parse().unwrap_or(0.0);
    if !(order != 0.0 && order.is_finite()) {
        return Err(broken("its third line is no number other than 0"));
    }
    Ok(Lines {
        size: UVec2::new(width, height),
        channels: if words[0] == "PF" { 3 } else { 1 },
        little_endian: order < 0.0,
        data: at,
    })
}
