//! Host file: a file of transfer that is there: its header at once, its coefficients when they are asked for.

use super::file::{BLOCKED, LIT};
use super::glb::{self, Broken, Vectors};
use super::identity::{Header, VERSION};
use crate::error::{Error, Result};
use glimt_render_gpu::prepare::bake::{MAX_BANDS, required_bytes};
use glimt_render_gpu::prepare::transfer::Transfer;
use serde_json::Value;
use std::fs::File;
use std::io::{self, BufReader};
use std::ops::Range;
use std::path::{Path, PathBuf};

/// A file of transfer, which is as long as it says, and of which nothing but the document has been read.
#[derive(Debug)]
pub struct Stored {
    file: PathBuf,
    reader: BufReader<File>,
    document: Value,
    header: Header,
    /// Where in the file the bytes of its attributes stand.
    bytes: Range<u64>,
}

impl Stored {
    /// Opens a file.
    ///
    /// # Errors
    /// It cannot be read, or is not a file of transfer that is whole; the error has no fix yet where a new one would do.
    pub fn open(file: &Path) -> Result<Self> {
        let mut reader = open(file)?;
        let document = glb::read_document(&mut reader).map_err(|e| broken(file, e))?;
        let bytes = glb::bytes(&mut reader).map_err(|e| broken(file, e))?;
        Ok(Self {
            file: file.to_owned(),
            header: header(file, &document)?,
            reader,
            document,
            bytes,
        })
    }

    /// What the file says of itself.
    #[must_use]
    pub fn header(&self) -> &Header {
        &self.header
    }

    /// The coefficients, read one attribute after the other into their places.
    ///
    /// # Errors
    /// Attributes are missing, or of other lengths than the header says; or there is not enough memory.
    pub fn transfer(mut self) -> Result<Transfer> {
        let file = &self.file;
        let n = (self.header.bands * self.header.bands) as usize;
        let vectors = n.div_ceil(4);
        // What the header says is believed only as far as there are bytes for it.
        let objects = self.header.objects.iter();
        let vertices = objects.fold(0u64, |sum, o| sum.saturating_add(o.vertices));
        let length = self.bytes.end - self.bytes.start;
        if vertices.saturating_mul(32 * vectors as u64) > length {
            return Err(Error::input(file, "it has fewer vertices than it says"));
        }
        let mut transfer = Transfer {
            bands: self.header.bands,
            ..Transfer::default()
        };
        for list in [&mut transfer.lit, &mut transfer.blocked] {
            list.try_reserve_exact(vertices as usize * n).map_err(|_| {
                let bytes = required_bytes(vertices, self.header.bands);
                let what = format!("it takes {bytes} bytes, and there is not enough memory");
                Error::device(what)
                    .file(file)
                    .fix("lower render.prt.bands or object.N.subdivide")
            })?;
        }
        let meshes = self.document["meshes"].as_array();
        let meshes = meshes.map_or(&[][..], Vec::as_slice);
        for (object, identity) in self.header.objects.iter().enumerate() {
            let count = identity.vertices as usize;
            if count == 0 {
                continue;
            }
            let mesh = meshes
                .iter()
                .find(|mesh| mesh["extras"]["glimt_object"] == object)
                .ok_or_else(|| Error::input(file, format!("it has no mesh for object {object}")))?;
            let attributes = &mesh["primitives"][0]["attributes"];
            for (prefix, list) in [(LIT, &mut transfer.lit), (BLOCKED, &mut transfer.blocked)] {
                let begin = list.len();
                list.resize(begin + count * n, 0.0);
                for i in 0..vectors {
                    let name = format!("{prefix}{i}");
                    let found = attributes[&name]
                        .as_u64()
                        .and_then(|accessor| Vectors::find(&self.document, accessor, length))
                        .filter(|vectors| vectors.count() == count as u64)
                        .ok_or_else(|| {
                            let what =
                                format!("its attribute {name} is missing or of another length");
                            Error::input(file, what).at(format!("object {object}"))
                        })?;
                    let mut own = list[begin..].chunks_mut(n);
                    found
                        .read(&mut self.reader, self.bytes.start, |four| {
                            if let Some(own) = own.next() {
                                let own = &mut own[4 * i..n.min(4 * i + 4)];
                                own.copy_from_slice(&four[..own.len()]);
                            }
                        })
                        .map_err(|e| Error::reading(file, &e))?;
                }
            }
        }
        Ok(transfer)
    }
}

fn open(file: &Path) -> Result<BufReader<File>> {
    let reader = File::open(file).map_err(|e| match e.kind() {
        io::ErrorKind::NotFound => Error::input(file, "there is no such file"),
        _ => Error::reading(file, &e),
    })?;
    Ok(BufReader::new(reader))
}

fn broken(file: &Path, broken: Broken) -> Error {
    match broken {
        Broken::Io(e) => Error::reading(file, &e),
        Broken::NotGlb => Error::input(file, "it is not a file of transfer"),
        Broken::Short(there, said) => Error::input(
            file,
            format!("the file ends too early: {there} of {said} bytes are there"),
        ),
    }
}

fn header(file: &Path, document: &Value) -> Result<Header> {
    let header = &document["asset"]["extras"]["glimt_bake"];
    if header.is_null() {
        return Err(Error::input(file, "it is not a file of transfer"));
    }
    let known: Option<Header> = serde_json::from_value(header.clone()).ok();
    known
        .filter(|header| header.version == VERSION && header.shadowed)
        .filter(|header| (1..=MAX_BANDS).contains(&header.bands))
        .ok_or_else(|| Error::input(file, "its transfer is of a version that is not known"))
}
