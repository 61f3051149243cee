//! Host file: digests of the shaders of each role, by which results that another version made are recognised.

use std::fmt::Write;
use std::io;
use std::path::PathBuf;

use naga_front_rust::Shader;
use sha2::{Digest, Sha256};

use crate::entries::{EntrySpec, Role};
use crate::root;

/// Stages that are written by hand; their results reach pixels.
const BY_HAND: [&str; 2] = [
    "crates/render-gpu/src/gpu/projection.wgsl",
    "crates/render-gpu/src/gpu/raster.wgsl",
];

/// What they call, where it is made from Rust.
const FUNCTIONS: &str = "crates/render-gpu/src/generated";

/// One constant for each role whose results are kept.
pub(crate) fn text(
    shaders: &[(EntrySpec, Shader)],
    exports: &[(PathBuf, String)],
) -> io::Result<String> {
    let mut by_hand = Vec::new();
    for file in BY_HAND {
        by_hand.push(std::fs::read_to_string(root().join(file))?);
    }
    let called = exports
        .iter()
        .filter(|(file, _)| file.starts_with(FUNCTIONS));
    by_hand.extend(called.map(|(_, text)| text.clone()));
    let mut out = String::new();
    for (name, what, role) in [
        ("PIXELS", "the pixels of a rendered frame", Role::Pixels),
        ("BAKE", "precomputed transfer", Role::Bake),
        ("SYNTH", "a simulated capture", Role::Synth),
    ] {
        let own = shaders.iter().filter(|(spec, _)| spec.role == role);
        let mut texts: Vec<&str> = own.map(|(_, shader)| &*shader.wgsl).collect();
        if role == Role::Pixels {
            texts.extend(by_hand.iter().map(|text| &**text));
        }
        let _ = writeln!(
            out,
            "/// SHA-256, in hexadecimal, of the shaders that {what} depend on.\npub const {name}: &str = \"{}\";\n",
            digest(&texts)
        );
    }
    out.truncate(out.trim_end().len());
    out.push('\n');
    Ok(out)
}

fn digest(texts: &[&str]) -> String {
    let mut hasher = Sha256::new();
    for text in texts {
        hasher.update((text.len() as u64).to_le_bytes());
        hasher.update(text.as_bytes());
    }
    let hash = hasher.finalize();
    hash.iter().fold(String::new(), |mut hex, byte| {
        let _ = write!(hex, "{byte:02x}");
        hex
    })
}
