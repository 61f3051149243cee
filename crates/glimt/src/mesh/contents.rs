//! Host file: the bytes of a file, unpacked, and files that others name.

use crate::error::{Error, Result};
use crate::memory;
use flate2::bufread::MultiGzDecoder;
use std::fs::File;
use std::io::{BufRead, BufReader, Read};
use std::path::{Path, PathBuf};

/// How much is unpacked before memory is looked at again.
const STEP: u64 = 64 << 20;

/// Opens a file; what is packed by gzip is unpacked, whatever its name.
///
/// # Errors
/// It cannot be read.
pub fn open(file: &Path) -> Result<Box<dyn BufRead>> {
    let opened = File::open(file).map_err(|e| Error::reading(file, &e))?;
    let mut plain = BufReader::with_capacity(1 << 18, opened);
    let start = plain.fill_buf().map_err(|e| Error::reading(file, &e))?;
    Ok(match start.starts_with(&[0x1f, 0x8b]) {
        true => Box::new(BufReader::new(MultiGzDecoder::new(plain))),
        false => Box::new(plain),
    })
}

/// All bytes of a file; what is packed by gzip is unpacked.
///
/// # Errors
/// It cannot be read, or there is no memory for what it unpacks to.
pub fn read(file: &Path) -> Result<Vec<u8>> {
    let mut reader = open(file)?;
    let mut bytes = Vec::new();
    loop {
        let mut part = reader.by_ref().take(STEP);
        let count = part.read_to_end(&mut bytes);
        if count.map_err(|e| Error::reading(file, &e))? == 0 {
            return Ok(bytes);
        }
        let room = memory::require("reading on in this file", STEP);
        room.map_err(|e| e.file(file).fix(memory::FIX))?;
    }
}

/// The file of a name that a file in `folder` gives, perhaps with the separators, the folders, or the capitals of another system.
/// `None` if there is no such file.
pub fn find(folder: &Path, name: &str) -> Option<PathBuf> {
    let name = name.replace('\\', "/");
    let name = name.strip_prefix("./").unwrap_or(&name);
    let as_said = folder.join(name);
    if as_said.is_file() {
        return Some(as_said);
    }
    let last = name.rsplit('/').next()?;
    let places = [as_said.parent()?.to_owned(), folder.to_owned()];
    for place in places {
        let Ok(entries) = place.read_dir() else {
            continue;
        };
        let mut names: Vec<_> = entries.flatten().map(|entry| entry.file_name()).collect();
        names.sort();
        let is_it = |other: &&std::ffi::OsString| {
            let other = other.to_string_lossy();
            other.to_lowercase() == last.to_lowercase()
        };
        if let Some(found) = names.iter().find(is_it) {
            let path = place.join(found);
            if path.is_file() {
                return Some(path);
            }
        }
    }
    None
}
