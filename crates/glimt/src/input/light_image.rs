//! Host file: one image of light without its bad texels: a photograph of a mirror ball, or an image of all directions.

use super::{
    BadTexels, HdrImage, Reading, decode_image, format_by, format_of, plate, read_bytes,
    read_header,
};
use crate::error::Result;
use crate::notes::Notes;
use crate::shot::digest::Hash;
use glam::{UVec2, Vec3, Vec4};
use glimt_render_gpu::prepare::env::EnvMap;
use rayon::prelude::*;
use std::path::Path;

/// An image of light: linear radiance, rows from the top; w is 1.
#[derive(Clone, Debug)]
pub struct LightImage {
    /// Width and height in pixels.
    pub size: UVec2,
    /// Its pixels, all of them finite and none negative.
    pub pixels: Vec<Vec4>,
    /// Hash of the bytes that they were decoded from.
    pub hash: Hash,
}

/// Width and height of an image of light, by its header.
///
/// # Errors
/// The file cannot be read, is not an image, or is larger than `reading` allows.
pub fn read_size(file: &Path, reading: &Reading) -> Result<UVec2> {
    match format_of(file)?.is_hdr() {
        true => Ok(read_header(file, reading)?.size),
        false => plate::read_size(file, reading),
    }
}

/// Reads a photograph of a mirror ball. An image of 8 or 16 bits is made linear.
///
/// # Errors
/// The file cannot be read or is broken; or has bad pixels and `notes` is strict.
pub fn read_photo(file: &Path, reading: &Reading, notes: &mut Notes) -> Result<LightImage> {
    // Sensors read a little below zero where it is dark; that is noise, not a defect.
    read(file, reading, "pixel", false, notes)
}

/// Reads an image of all directions. Channels that are not light become 0; what overflowed becomes the brightest of the image.
///
/// # Errors
/// The file cannot be read or is broken; or it has bad texels and `notes` is strict.
pub fn read_all_directions(
    file: &Path,
    reading: &Reading,
    notes: &mut Notes,
) -> Result<LightImage> {
    read(file, reading, "texel", true, notes)
}

/// Reads light. `noun` is a word for its pixels; whether one below 0 is a defect is said by `negative_is_bad`.
fn read(
    file: &Path,
    reading: &Reading,
    noun: &str,
    negative_is_bad: bool,
    notes: &mut Notes,
) -> Result<LightImage> {
    let bytes = read_bytes(file)?;
    if !format_by(file, &bytes)?.is_hdr() {
        return decode_display(file, &bytes, reading, noun, notes);
    }
    let mut image = decode_image(file, &bytes, reading, notes)?;
    let bad = BadTexels::repair(&mut image.texels);
    let all = image.texels.len();
    // Told before the conversion: what the file holds, not what becomes of it.
    let defects = BadTexels {
        negative: if negative_is_bad { bad.negative } else { 0 },
        ..bad
    };
    let told = match defects.total() {
        0 => None,
        1 => Some(format!("1 of {all} {noun} is not light: {defects}")),
        n => Some(format!("{n} of {all} {noun}s are not light: {defects}")),
    };
    if !image.primaries.is(&reading.working) {
        notes.note(
            file,
            format!(
                "its colours, of {}, are converted to {}",
                image.primaries, reading.working
            ),
        );
    }
    let outside = to_working(&mut image, reading);
    if let Some(what) = told {
        notes.defect(file, &what, defects.workaround())?;
    }
    if outside > bad.negative {
        notes.note(
            file,
            format!(
                "{} {noun}s have colours outside {}; their negative channels are 0",
                outside - bad.negative,
                reading.working
            ),
        );
    }
    Ok(LightImage {
        size: image.header.size,
        pixels: image.texels,
        hash: image.hash,
    })
}

/// Converts light to the primaries that is rendered with, and sets what is negative then to 0; says how many texels had some.
fn to_working(image: &mut HdrImage, reading: &Reading) -> usize {
    image.convert_to(&reading.working);
    EnvMap::repair(&mut image.texels)
}

fn decode_display(
    file: &Path,
    bytes: &[u8],
    reading: &Reading,
    noun: &str,
    notes: &mut Notes,
) -> Result<LightImage> {
    let image = plate::decode(file, bytes, reading, notes)?;
    let (size, hash) = (image.size, image.hash);
    let matrix = image.primaries.colour_matrix_to(&reading.working);
    let is_clipped = image.is_clipped;
    let linear = image.colours.into_linear();
    if is_clipped {
        let white = |c: &&Vec3| c.max_element() >= 0.999;
        let clipped = linear.par_iter().filter(white).count();
        let share = 100.0 * clipped as f64 / linear.len() as f64;
        let what = format!(
            "a PNG, JPEG or TIFF holds nothing brighter than white: lamps and sun are clipped ({share:.1} % of the {noun}s)"
        );
        let workaround = "light from it is too dim and too flat; film it in HDR";
        notes.defect(file, &what, workaround)?;
    }
    // Where the primaries are the same, this sets what is negative to 0 and no more.
    let pixels: Vec<Vec4> = linear
        .par_iter()
        .map(|c| matrix.apply(c.extend(1.0)))
        .collect();
    Ok(LightImage { size, pixels, hash })
}
