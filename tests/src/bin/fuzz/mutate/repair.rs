//! Host file: what formats say about themselves, made true again: checksums, hashes, lengths of the whole.

use super::Kind;
use crate::corpus::gzip;
use flate2::Crc;
use flate2::read::MultiGzDecoder;
use sha2::{Digest, Sha256};
use std::io::Read;

/// Bytes of the line that a state begins with; the length of its header follows.
pub(super) const STATE_MAGIC: usize = b"glimt state of a method 2\n".len();

/// Makes a file of a kind true to itself.
pub(super) fn repair(kind: Kind, bytes: &mut Vec<u8>) {
    match kind {
        Kind::Png => png(bytes),
        Kind::Glb if bytes.len() >= 20 => {
            let length = (bytes.len() as u32).to_le_bytes();
            bytes[8..12].copy_from_slice(&length);
        }
        Kind::State if bytes.len() > 32 => {
            bytes.truncate(bytes.len() - 32);
            let hash = Sha256::digest(&bytes);
            bytes.extend(hash);
        }
        _ => {}
    }
}

/// A chunk of a PNG.
pub(crate) fn png_chunk(kind: [u8; 4], data: &[u8]) -> Vec<u8> {
    let mut chunk = (data.len() as u32).to_be_bytes().to_vec();
    chunk.extend(kind);
    chunk.extend(data);
    chunk.extend(crc(&chunk[4..]).to_be_bytes());
    chunk
}

fn crc(bytes: &[u8]) -> u32 {
    let mut crc = Crc::new();
    crc.update(bytes);
    crc.sum()
}

/// Mends the checksums of all chunks that are whole.
fn png(bytes: &mut [u8]) {
    let mut at: usize = 8;
    while let Some(length) = bytes.get(at..at + 4).and_then(|l| l.first_chunk::<4>()) {
        let Some(end) = at.checked_add(8 + u32::from_be_bytes(*length) as usize) else {
            return;
        };
        if bytes.len() < end + 4 {
            return;
        }
        let sum = crc(&bytes[at + 4..end]);
        bytes[end..end + 4].copy_from_slice(&sum.to_be_bytes());
        at = end + 4;
    }
}

/// A packed file with its content changed; as it is where it cannot be unpacked.
pub(super) fn repacked(bytes: &[u8], change: impl FnOnce(&[u8]) -> Vec<u8>) -> Vec<u8> {
    let mut inner = Vec::new();
    match MultiGzDecoder::new(bytes).read_to_end(&mut inner) {
        Ok(_) => gzip(&change(&inner)).unwrap_or_else(|_| bytes.to_vec()),
        Err(_) => bytes.to_vec(),
    }
}
