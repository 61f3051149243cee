//! Host file: one image of light without its bad texels: a photograph of a mirror ball, or an image of all directions.

use super::{
    BadTexels, HdrImage, decode_image, is_display, is_display_start, plate, read_bytes,
    read_header, read_image,
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

/// Width and height of a photograph (HDR, PNG or JPEG), by its header.
///
/// # Errors
/// The file cannot be read, or is not an image.
pub fn read_photo_size(file: &Path) -> Result<UVec2> {
    match is_display(file)? {
        true => plate::read_size(file),
        false => Ok(read_header(file)?.size),
    }
}

/// Reads a photograph of a mirror ball: HDR, or a PNG or JPEG, which is made linear.
///
/// # Errors
/// The file cannot be read or is broken; or has bad pixels and `notes` is strict.
pub fn read_photo(file: &Path, notes: &mut Notes) -> Result<LightImage> {
    let bytes = read_bytes(file)?;
    if is_display_start(&bytes) {
        return decode_display(file, &bytes, notes);
    }
    let HdrImage {
        header,
        mut texels,
        hash,
    } = decode_image(file, &bytes, notes)?;
    let bad = BadTexels::count(&texels);
    // Sensors read a little below zero where it is dark; that is noise, not a defect.
    let worth_a_note = bad.total() - bad.negative;
    if worth_a_note > 0 {
        let what = format!(
            "{worth_a_note} of {} pixels are not light: {bad}",
            texels.len()
        );
        notes.defect(file, &what, "those channels are taken as 0")?;
    }
    if bad.total() > 0 {
        EnvMap::repair(&mut texels);
    }
    Ok(LightImage {
        size: header.size,
        pixels: texels,
        hash,
    })
}

/// Reads an HDR image of all directions. Channels that are not light become 0.
///
/// # Errors
/// The file cannot be read or is broken; or it has bad texels and `notes` is strict.
pub fn read_all_directions(file: &Path, notes: &mut Notes) -> Result<LightImage> {
    let HdrImage {
        header,
        mut texels,
        hash,
    } = read_image(file, notes)?;
    let bad = BadTexels::count(&texels);
    if bad.total() > 0 {
        let noun = if bad.total() == 1 {
            "texel is"
        } else {
            "texels are"
        };
        let what = format!(
            "{} of {} {noun} not light: {bad}",
            bad.total(),
            texels.len()
        );
        notes.defect(file, &what, "those channels are taken as 0")?;
        EnvMap::repair(&mut texels);
    }
    Ok(LightImage {
        size: header.size,
        pixels: texels,
        hash,
    })
}

fn decode_display(file: &Path, bytes: &[u8], notes: &mut Notes) -> Result<LightImage> {
    let image = plate::decode(file, bytes, notes)?;
    let (size, hash) = (image.size, image.hash);
    let linear = image.colours.into_linear();
    let pixels: Vec<Vec4> = linear
        .par_iter()
        .map(|c| c.max(Vec3::ZERO).extend(1.0))
        .collect();
    let white = |p: &&Vec4| p.truncate().max_element() >= 0.999;
    let clipped = pixels.par_iter().filter(white).count();
    let share = 100.0 * clipped as f64 / pixels.len() as f64;
    notes.warn(
        file,
        format!(
            "a PNG or JPEG holds nothing brighter than white: lamps and sun are clipped ({share:.1} % of the pixels), and \
             light from it is too dim and too flat; film the ball in HDR"
        ),
    );
    Ok(LightImage { size, pixels, hash })
}
