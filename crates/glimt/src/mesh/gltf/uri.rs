//! Host file: what glTF files keep beside or within them, by its URI.

use super::Reader;
use super::document::broken;
use crate::error::{Error, Result};
use crate::mesh::require_room;
use ::gltf::buffer::{Data, Source};
use std::path::PathBuf;

impl Reader<'_> {
    /// The bytes that a URI names, and the file that they are in, which is remembered.
    pub(super) fn fetch(&mut self, uri: &str) -> Result<(PathBuf, Vec<u8>)> {
        let file = self.file.to_owned();
        if uri.starts_with("data:") {
            let data = Data::from_source(Source::Uri(uri), None).map_err(|e| broken(&file, e))?;
            return Ok((file, data.0));
        }
        if uri.contains("://") && !uri.starts_with("file://") {
            let what = format!("it refers to `{uri}`, which is not a file");
            return Err(Error::input(&file, what).fix("export it with its data beside it"));
        }
        let path = percent_decode(uri.strip_prefix("file://").unwrap_or(uri));
        let path = self.folder.join(path);
        if !self.model.files.contains(&path) {
            self.model.files.push(path.clone());
        }
        require_room(&path)?;
        let bytes = std::fs::read(&path).map_err(|e| Error::reading(&path, &e))?;
        Ok((path, bytes))
    }
}

/// `%20` and its like as the bytes that they stand for.
fn percent_decode(uri: &str) -> String {
    let mut bytes = Vec::with_capacity(uri.len());
    let mut rest = uri.as_bytes();
    while let [first, tail @ ..] = rest {
        let escaped = (*first == b'%' && tail.len() >= 2)
            .then(|| std::str::from_utf8(&tail[..2]).ok())
            .flatten()
            .and_then(|hex| u8::from_str_radix(hex, 16).ok());
        match escaped {
            Some(byte) => {
                bytes.push(byte);
                rest = &tail[2..];
            }
            None => {
                bytes.push(*first);
                rest = tail;
            }
        }
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn escaped_names() {
        assert_eq!(percent_decode("a%20b%C3%A5.bin"), "a bå.bin");
        assert_eq!(percent_decode("100%"), "100%");
    }
}
