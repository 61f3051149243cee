//! Host file: frames out: EXR, PNG and mp4, each whole under its name or not there at all.

pub mod aov;
pub mod atomic;
pub mod exr;
pub mod png;
pub mod state;
pub mod video;

use crate::error::Result;
use atomic::Pending;
use glimt_render_gpu::prepare::render::FrameImage;
use std::io::Write;
use std::path::Path;

/// Key of the text that holds a frame's identity, in EXR attributes and PNG text chunks.
pub const HASH_KEY: &str = "glimtHash";

/// What is stored beside a frame's pixels.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Stamp {
    /// Identity of the frame, in hexadecimal.
    pub hash: String,
    /// Number of the frame.
    pub frame: u32,
}

/// The program and its version, for the files it writes.
pub const SOFTWARE: &str = concat!("glimt ", env!("CARGO_PKG_VERSION"));

/// Rows of the display image as bytes: RGB where every pixel is opaque, else RGBA. The second value is whether there is
/// alpha.
pub fn display_bytes(image: &FrameImage) -> (Vec<u8>, bool) {
    let opaque = image.display.iter().all(|pixel| pixel[3] == 255);
    if opaque {
        return (rgb_over_black(&image.display), false);
    }
    (image.display.as_flattened().to_vec(), true)
}

/// Pixels with straight alpha laid over black.
pub fn rgb_over_black(pixels: &[[u8; 4]]) -> Vec<u8> {
    let over = |c: u8, a: u8| ((u32::from(c) * u32::from(a) + 127) / 255) as u8;
    pixels
        .iter()
        .flat_map(|&[r, g, b, a]| [over(r, a), over(g, a), over(b, a)])
        .collect()
}

/// Writes a text file, whole or not at all.
///
/// # Errors
/// The file cannot be written.
pub fn write_text(file: &Path, text: &str) -> Result<()> {
    let mut pending = Pending::create(file)?;
    pending
        .write_all(text.as_bytes())
        .map_err(|e| pending.error(&e))?;
    pending.commit()
}
