//! Host file: frames out: EXR, PNG and mp4, each whole under its name or not there at all.

pub mod aov;
pub mod atomic;
pub mod exr;
pub mod png;
pub mod state;
pub mod target;
pub mod video;

use crate::error::Result;
use crate::printable::path_in_line;
use crate::report::Reporter;
use crate::shot::digest;
use atomic::Pending;
use glimt_render_gpu::prepare::render::FrameImage;
use std::io::Write;
use std::path::Path;
use target::{COMMENT, Guard, Target};

/// Key of the text that holds a frame's identity, in EXR attributes and PNG text chunks.
pub const HASH_KEY: &str = "glimtHash";

/// What is stored beside a frame's pixels.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Stamp {
    /// Identity of the frame, in hexadecimal.
    pub hash: String,
    /// Number of the frame.
    pub frame: i32,
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
pub fn write_text(file: &Target, text: &str) -> Result<()> {
    let mut pending = Pending::create(file)?;
    pending
        .write_all(text.as_bytes())
        .map_err(|e| pending.error(&e))?;
    pending.commit()
}

/// Writes a TOML file that people will edit: its first line tells what follows it, by which an edited file is known and left alone,
/// unless the guard overwrites.
///
/// # Errors
/// The file cannot be written, or something else wrote it.
pub fn write_editable(guard: &Guard, file: &Path, text: &str, reporter: &Reporter) -> Result<()> {
    let told = |text: &str| digest::hex(&digest::of_text(text));
    let start = format!("{COMMENT} ");
    let known = std::fs::read_to_string(file).unwrap_or_default();
    let known = known.split_once('\n').and_then(|(first, rest)| {
        let told = first.strip_prefix(&start)?.rsplit_once(' ')?.1;
        Some((told, rest))
    });
    if let Some((hash, rest)) = known
        && hash != told(rest)
        && !guard.overwrites()
    {
        reporter.remark(&format!(
            "{} was edited: it is left as it is (--overwrite writes it again)",
            path_in_line(file)
        ));
        return Ok(());
    }
    let version = env!("CARGO_PKG_VERSION");
    let text = format!(
        "{start}{version}, which leaves this file alone once it is edited. {}\n{text}",
        told(text)
    );
    write_text(&guard.target(file)?, &text)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cli::PrintFlags;

    #[test]
    fn what_was_edited_is_left_alone() {
        let folder = std::env::temp_dir().join(format!("glimt-editable-{}", std::process::id()));
        atomic::prepare_folder(&folder).unwrap();
        let file = folder.join("shot.toml");
        let quiet = PrintFlags {
            quiet: true,
            json: false,
            verbose: 0,
        };
        let reporter = Reporter::new(quiet);
        let write = |text: &str, overwrite| {
            let written = write_editable(&Guard::new(overwrite), &file, text, &reporter);
            let there = std::fs::read_to_string(&file).unwrap();
            (written.is_ok(), there)
        };
        let (written, there) = write("a = 1\n", false);
        assert!(written && there.ends_with("\na = 1\n"), "{there}");
        // One that nobody edited follows the program.
        assert!(write("a = 2\n", false).1.ends_with("\na = 2\n"));

        let edited = there.replace("a = 1", "a = 3");
        std::fs::write(&file, &edited).unwrap();
        assert_eq!(write("a = 2\n", false), (true, edited));
        assert!(write("a = 2\n", true).1.ends_with("\na = 2\n"));

        std::fs::write(&file, "a = 4\n").unwrap();
        assert_eq!(write("a = 2\n", false), (false, "a = 4\n".to_owned()));
        std::fs::remove_dir_all(&folder).unwrap();
    }
}
