//! Host file: the identity of a frame: a hash of everything that its pixels depend on.

use super::{Output, Shot};
use crate::error::{Error, Result};
use glimt_render_gpu::generated::digests;
use sha2::{Digest, Sha256};
use std::fs::File;
use std::io::Read;
use std::path::Path;

/// SHA-256.
pub type Hash = [u8; 32];

/// The version that takes part in the identity of a frame.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");

/// Hash of a file's content.
///
/// # Errors
/// The file cannot be read.
pub fn of_file(file: &Path) -> Result<Hash> {
    let fail = |e: std::io::Error| Error::reading(file, &e);
    let mut reader = File::open(file).map_err(fail)?;
    let mut hasher = Sha256::new();
    let mut buffer = vec![0; 1 << 16];
    loop {
        let n = reader.read(&mut buffer).map_err(fail)?;
        if n == 0 {
            return Ok(hasher.finalize().into());
        }
        hasher.update(&buffer[..n]);
    }
}

/// Hash of a file's content that was read.
#[must_use]
pub fn of_bytes(bytes: &[u8]) -> Hash {
    Sha256::digest(bytes).into()
}

/// Hash of the keys of a shot that its pixels depend on: neither paths (contents count), nor outputs, nor which frames.
pub fn of_shot(shot: &Shot) -> Hash {
    let mut shot = shot.clone();
    let default = Shot::default();
    shot.output = Output {
        primaries: shot.output.primaries,
        ..default.output
    };
    shot.image.max_texels = default.image.max_texels;
    shot.probe.frames.clear();
    shot.probe.fps = default.probe.fps;
    shot.render.frames.clear();
    if let Some(plate) = &mut shot.backplate {
        plate.frames.clear();
        plate.fps = None;
        plate.offset = None;
    }
    // Of a bake its content counts, and who renders by it adds that: the directions are those that it was made of.
    shot.render.prt.bake.clear();
    shot.render.prt.directions = default.render.prt.directions;
    for object in &mut shot.objects {
        object.mesh.clear();
    }
    let canonical = serde_json::to_string(&shot).expect("a shot is plain data");
    Sha256::digest(canonical.as_bytes()).into()
}

/// Hash of a text.
pub fn of_text(text: &str) -> Hash {
    Sha256::digest(text.as_bytes()).into()
}

/// Joins hashes in order.
pub fn join<'a>(parts: impl IntoIterator<Item = &'a Hash>) -> Hash {
    let mut hasher = Sha256::new();
    for part in parts {
        hasher.update(part);
    }
    hasher.finalize().into()
}

/// The identity of one frame: version, kernels, shot, meshes, inputs (light and footage) and number, in hexadecimal.
pub fn of_frame(scene: &Hash, inputs: &Hash, frame: i32) -> String {
    let mut hasher = Sha256::new();
    hasher.update(b"glimt frame ");
    hasher.update(VERSION.as_bytes());
    hasher.update([0]);
    // What the kernels compute, whatever the version says: their shaders are made from them.
    hasher.update(digests::PIXELS.as_bytes());
    hasher.update(scene);
    hasher.update(inputs);
    hasher.update(frame.to_le_bytes());
    hex(&hasher.finalize().into())
}

/// A hash in hexadecimal.
pub fn hex(hash: &Hash) -> String {
    hash.iter().map(|byte| format!("{byte:02x}")).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pixels_decide() {
        let base = Shot::default();
        let mut same = base.clone();
        same.output.dir = "elsewhere".into();
        same.probe.frames = "renamed.exr".into();
        assert_eq!(of_shot(&base), of_shot(&same));
        let mut other = base.clone();
        other.render.seed = 2;
        assert_ne!(of_shot(&base), of_shot(&other));
        let mut other = base.clone();
        other.render.compensation = false;
        assert_ne!(of_shot(&base), of_shot(&other));
        let zero = [0; 32];
        assert_ne!(of_frame(&zero, &zero, 1), of_frame(&zero, &zero, 2));
    }
}
