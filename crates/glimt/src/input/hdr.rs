//! Host file: Radiance pictures (RGBE).

use super::{HdrImage, Header, Reading, apply_transfer, require_bound, require_room};
use crate::colour::encoding::Transfer;
use crate::colour::primaries::{Primaries, REC_709};
use crate::error::{Error, Result};
use crate::notes::Notes;
use crate::shot::digest;
use glam::{UVec2, Vec3, Vec4};
use image::ImageDecoder;
use image::codecs::hdr::HdrDecoder;
use std::fs::File;
use std::io::{BufRead, BufReader, Read};
use std::path::Path;

/// Lines of the header that concern us.
struct Lines {
    size: UVec2,
    /// What was multiplied into the picture, and is divided out: `EXPOSURE` and `COLORCORR`, all of each.
    gain: Vec3,
    primaries: Option<Primaries>,
    /// What there is to say.
    notes: Vec<String>,
    /// Where the pixels begin.
    data: usize,
}

impl Lines {
    fn primaries(&self, reading: &Reading) -> Primaries {
        let of_file = self.primaries.unwrap_or(REC_709);
        reading.primaries.unwrap_or(of_file)
    }
}

/// The longest header that is looked at, in bytes.
const LONGEST: u64 = 1 << 16;

/// Reads the header.
///
/// # Errors
/// It is broken, of a kind that is not supported, or of an image that is larger than `reading` allows.
pub fn read_header(file: &Path, reading: &Reading) -> Result<Header> {
    let opened = File::open(file).map_err(|e| Error::reading(file, &e))?;
    let lines = read_lines(file, BufReader::new(opened.take(LONGEST)))?;
    require_bound(file, lines.size, reading)?;
    Ok(header(&lines, reading))
}

fn header(lines: &Lines, reading: &Reading) -> Header {
    let mut remarks = Vec::new();
    let gain = lines.gain;
    if gain == Vec3::splat(gain.x) && gain.x != 1.0 {
        remarks.push(format!("exposure {} (divided out)", gain.x));
    } else if gain != Vec3::ONE {
        remarks.push(format!(
            "exposure and colour correction {gain} (divided out)"
        ));
    }
    let (of_file, source) = match lines.primaries {
        Some(named) => (named, "PRIMARIES"),
        None => (REC_709, "the header names none"),
    };
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
        parts: 1,
        layer: String::new(),
        other_layers: Vec::new(),
        primaries: reading.told_primaries(of_file, source),
        transfer: reading.transfer.unwrap_or(Transfer::Linear).to_string(),
        pixel_aspect: 1.0,
        remarks,
    }
}

/// Decodes the picture that was read from `file`; the exposure and the colour correction of its header are divided out.
///
/// # Errors
/// It is broken or truncated, of a kind that is not supported, or larger than `reading` allows.
pub fn decode(file: &Path, bytes: &[u8], reading: &Reading, notes: &mut Notes) -> Result<HdrImage> {
    let lines = read_lines(file, bytes)?;
    for note in &lines.notes {
        notes.note(file, note.as_str());
    }
    let broken = |e: image::ImageError| match e {
        image::ImageError::IoError(e) => Error::reading(file, &e),
        e => Error::input(file, format!("it is broken: {e}")).fix("copy or export it again"),
    };
    require_bound(file, lines.size, reading)?;
    // However well a row is packed, it takes as many bytes as one texel.
    if (bytes.len() as u64) < 4 * u64::from(lines.size.y) {
        return Err(too_short(file, "file"));
    }
    require_room(file, lines.size, reading)?;
    // A header of our own: the decoder takes no lines that end as those of Windows do.
    let plain = format!(
        "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {} +X {}\n",
        lines.size.y, lines.size.x
    );
    let picture = bytes.get(lines.data..).unwrap_or_default();
    let decoder = HdrDecoder::new_nonstrict(plain.as_bytes().chain(picture)).map_err(broken)?;
    let mut channels = vec![0; decoder.total_bytes() as usize];
    decoder.read_image(&mut channels).map_err(broken)?;
    let gain = lines.gain.recip();
    let mut texels: Vec<Vec4> = channels
        .as_chunks::<12>()
        .0
        .iter()
        .map(|b| {
            let channel = |i: usize| f32::from_ne_bytes([b[i], b[i + 1], b[i + 2], b[i + 3]]);
            (Vec3::new(channel(0), channel(4), channel(8)) * gain).extend(1.0)
        })
        .collect();
    apply_transfer(&mut texels, reading.transfer.unwrap_or(Transfer::Linear));
    Ok(HdrImage {
        header: header(&lines, reading),
        texels,
        primaries: lines.primaries(reading),
        hash: digest::of_bytes(bytes),
    })
}

fn too_short(file: &Path, what: &str) -> Error {
    Error::input(file, format!("the {what} ends too early"))
        .fix("it is probably truncated: copy or export it again")
}

fn read_lines(file: &Path, mut reader: impl BufRead) -> Result<Lines> {
    let mut lines = Lines {
        size: UVec2::ZERO,
        gain: Vec3::ONE,
        primaries: None,
        notes: Vec::new(),
        data: 0,
    };
    let mut in_header = true;
    for _ in 0..1000 {
        let mut line = Vec::new();
        let mut limited = reader.by_ref().take(LONGEST);
        limited
            .read_until(b'\n', &mut line)
            .map_err(|e| Error::reading(file, &e))?;
        if line.is_empty() {
            break;
        }
        lines.data += line.len();
        let line = String::from_utf8_lossy(&line);
        let line = line.trim();
        if !in_header {
            lines.size = dimensions(file, line)?;
            return Ok(lines);
        }
        in_header = !line.is_empty();
        if let Some((key, value)) = line.split_once('=') {
            lines.take(file, key.trim(), value.trim())?;
        }
    }
    Err(too_short(file, "header"))
}

impl Lines {
    /// Takes a line of the header.
    fn take(&mut self, file: &Path, key: &str, value: &str) -> Result<()> {
        let numbers: Vec<f32> = value
            .split_whitespace()
            .map_while(|word| word.parse().ok())
            .collect();
        let is_factor = |n: &f32| *n > 0.0 && n.is_finite();
        let refused = |what: &str| {
            Error::input(file, format!("{key}={value} is not {what}"))
                .at("header")
                .fix("remove that line")
        };
        match (key, &numbers[..]) {
            // Some programs write 0 where they mean that they changed nothing.
            ("EXPOSURE", [0.0]) => self
                .notes
                .push("its EXPOSURE is 0: it is taken as 1".to_owned()),
            ("EXPOSURE", [factor]) if is_factor(factor) => self.gain *= *factor,
            ("EXPOSURE", _) => return Err(refused("an exposure")),
            ("COLORCORR", [r, g, b]) if [r, g, b].into_iter().all(is_factor) => {
                self.gain *= Vec3::new(*r, *g, *b);
            }
            ("COLORCORR", _) => return Err(refused("a colour correction")),
            // Some programs write a row of zeros, which says nothing.
            ("PRIMARIES", all) if all.iter().all(|n| *n == 0.0) => {}
            ("PRIMARIES", [rx, ry, gx, gy, bx, by, wx, wy]) => {
                let named = Primaries([[*rx, *ry], [*gx, *gy], [*bx, *by], [*wx, *wy]]);
                if !named.are_possible() {
                    return Err(refused("a set of primaries"));
                }
                self.primaries = Some(named);
            }
            ("PRIMARIES", _) => return Err(refused("a set of primaries")),
            ("FORMAT", _) if value != "32-bit_rle_rgbe" => {
                return Err(
                    Error::input(file, format!("FORMAT={value} is not supported"))
                        .at("header")
                        .fix("convert it to 32-bit_rle_rgbe or to OpenEXR"),
                );
            }
            ("PIXASPECT", [aspect]) if *aspect != 1.0 => self
                .notes
                .push(format!("its PIXASPECT of {aspect} is not used")),
            _ => {}
        }
        if !(self.gain.min_element() > 0.0 && self.gain.recip().is_finite()) {
            return Err(refused("an exposure that leaves anything of the light"));
        }
        Ok(())
    }
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
