//! Host file: hashes of what image files decode to, to see that a change of the program changes no pixel:
//! `cargo run --release --bin pixel-hashes -- FOLDER`. `scripts/pixel-hashes.sh` renders what it hashes.
//!
//! It prints a line for each channel of each EXR, for each PNG, and for the binary part of each `.glb` (the coefficients of a
//! bake) below a folder: the path, what it is, its size and its hash. Lines are sorted, so `diff` compares two runs. What
//! decoding drops has no hash: attributes and their order, compression, text chunks, and the `.glb`'s JSON.

use std::error::Error;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use exr::prelude::{FlatSamples, ReadChannels, ReadLayers};
use sha2::{Digest, Sha256};

type Result<T> = std::result::Result<T, Box<dyn Error>>;

fn main() -> ExitCode {
    let Some(folder) = std::env::args_os().nth(1).map(PathBuf::from) else {
        eprintln!("usage: pixel-hashes FOLDER");
        return ExitCode::FAILURE;
    };
    match lines(&folder) {
        Ok(lines) if lines.is_empty() => {
            eprintln!("error: {}: there is no EXR, PNG or GLB", folder.display());
            ExitCode::FAILURE
        }
        Ok(lines) => {
            println!("{}", lines.join("\n"));
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

/// The sorted lines of all files below a folder.
fn lines(folder: &Path) -> Result<Vec<String>> {
    let mut out = Vec::new();
    let mut folders = vec![folder.to_owned()];
    while let Some(below) = folders.pop() {
        for entry in std::fs::read_dir(&below).map_err(|e| format!("{}: {e}", below.display()))? {
            let path = entry?.path();
            if path.is_dir() {
                folders.push(path);
                continue;
            }
            let hashed = match path.extension().and_then(|e| e.to_str()) {
                Some("exr") => exr_channels(&path),
                Some("png") => png(&path),
                Some("glb") => glb(&path),
                _ => continue,
            };
            let name = path.strip_prefix(folder)?.display();
            for line in hashed.map_err(|e| format!("{}: {e}", path.display()))? {
                out.push(format!("{name} {line}"));
            }
        }
    }
    out.sort();
    Ok(out)
}

/// Each channel of each layer: its samples' bits, rows from the top.
fn exr_channels(file: &Path) -> Result<Vec<String>> {
    let image = exr::prelude::read()
        .no_deep_data()
        .largest_resolution_level()
        .all_channels()
        .all_layers()
        .all_attributes()
        .from_file(file)?;
    let mut out = Vec::new();
    for layer in &image.layer_data {
        let prefix = match &layer.attributes.layer_name {
            Some(name) => format!("{name}/"),
            None => String::new(),
        };
        let size = layer.size;
        for channel in &layer.channel_data.list {
            let (kind, bytes): (_, Vec<u8>) = match &channel.sample_data {
                FlatSamples::F16(s) => {
                    let bytes = s.iter().flat_map(|v| v.to_bits().to_le_bytes());
                    ("f16", bytes.collect())
                }
                FlatSamples::F32(s) => {
                    let bytes = s.iter().flat_map(|v| v.to_bits().to_le_bytes());
                    ("f32", bytes.collect())
                }
                FlatSamples::U32(s) => ("u32", s.iter().flat_map(|v| v.to_le_bytes()).collect()),
            };
            out.push(format!(
                "{prefix}{} {kind} {}x{} {}",
                channel.name,
                size.x(),
                size.y(),
                hash(&bytes)
            ));
        }
    }
    Ok(out)
}

/// The codes of all pixels, rows from the top.
fn png(file: &Path) -> Result<Vec<String>> {
    let image = image::open(file)?;
    let (width, height) = (image.width(), image.height());
    Ok(vec![format!(
        "{:?} {width}x{height} {}",
        image.color(),
        hash(image.as_bytes())
    )])
}

/// The binary chunk, which holds geometry and coefficients.
fn glb(file: &Path) -> Result<Vec<String>> {
    let bytes = std::fs::read(file)?;
    let word = |at: usize| -> Result<usize> {
        let word = bytes.get(at..at + 4).ok_or("it ends early")?;
        Ok(u32::from_le_bytes(word.try_into()?) as usize)
    };
    let (header, chunk_header) = (12, 8);
    let mut at = header;
    while word(at + 4)?.to_le_bytes()[..4] != *b"BIN\0" {
        at += chunk_header + word(at)?;
    }
    let length = word(at)?;
    let begin = at + chunk_header;
    let data = bytes.get(begin..begin + length).ok_or("it ends early")?;
    Ok(vec![format!("binary {length} {}", hash(data))])
}

/// The first half of the SHA-256, in hexadecimal.
fn hash(bytes: &[u8]) -> String {
    let digest = Sha256::digest(bytes);
    digest[..16].iter().fold(String::new(), |mut text, byte| {
        let _ = write!(text, "{byte:02x}");
        text
    })
}
