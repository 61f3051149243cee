//! Host file: glTF 2.0 files, `.gltf` and `.glb`: the scene graph, its meshes, materials and cameras.

mod accessor;
mod animation;
mod document;
mod material;
mod mesh;
mod scene;
mod texture;
mod uri;

use super::model::Model;
use crate::error::{Error, Result};
use crate::notes::Notes;
use ::gltf::Document;
use std::collections::HashMap;
use std::path::Path;

/// Reads a glTF file and all that it refers to.
///
/// # Errors
/// A file cannot be read, is broken, or requires an extension that is not supported.
pub fn load(file: &Path, notes: &mut Notes) -> Result<Model> {
    let bytes = std::fs::read(file).map_err(|e| Error::reading(file, &e))?;
    let (document, blob) = document::parse(file, &bytes, notes)?;
    drop(bytes);
    let mut reader = Reader {
        file,
        folder: file.parent().unwrap_or(Path::new("")),
        document: &document,
        buffers: Vec::new(),
        model: Model {
            files: vec![file.to_owned()],
            ..Model::default()
        },
        textures: HashMap::new(),
        materials: HashMap::new(),
        notes,
    };
    reader.remark();
    reader.read_buffers(blob)?;
    reader.read_scene()?;
    Ok(reader.model)
}

/// What is available while a file is read.
struct Reader<'a> {
    file: &'a Path,
    folder: &'a Path,
    document: &'a Document,
    buffers: Vec<Vec<u8>>,
    model: Model,
    /// By texture and whether it holds colours; `None` of one without an image.
    textures: HashMap<(usize, bool), Option<u32>>,
    /// By material; `None` is glTF's default.
    materials: HashMap<Option<usize>, u32>,
    notes: &'a mut Notes,
}

impl Reader<'_> {
    fn error(&self, what: impl std::fmt::Display) -> Error {
        Error::input(self.file, what).fix("the file is broken: export it again")
    }

    /// Says what the file has that the renderer has not.
    fn remark(&mut self) {
        for extension in self.document.extensions_used() {
            let what = match extension {
                known if document::SUPPORTED.contains(&known) => continue,
                // Said where they are used.
                known if material::is_remarked(known) => continue,
                "KHR_animation_pointer" => continue,
                "KHR_lights_punctual" => {
                    "its lights are left out: the light comes from the probe alone".to_owned()
                }
                other => format!("its extension {other} is not used"),
            };
            self.notes.note(self.file, what);
        }
    }

    fn read_buffers(&mut self, mut blob: Option<Vec<u8>>) -> Result<()> {
        let document = self.document;
        for (index, buffer) in document.as_json().buffers.iter().enumerate() {
            let place = format!("buffer {index}");
            let (file, data) = match (&buffer.uri, blob.take()) {
                (Some(uri), other) => {
                    blob = other;
                    self.fetch(uri)?
                }
                (None, Some(data)) => (self.file.to_owned(), data),
                (None, None) => return Err(self.error("it has no data").at(place)),
            };
            let (found, length) = (data.len() as u64, buffer.byte_length.0);
            if found < length {
                let what = format!("{found} of {length} bytes are there");
                return Err(Error::input(&file, what)
                    .at(place)
                    .fix("it is probably truncated: copy or export it again"));
            }
            self.buffers.push(data);
        }
        Ok(())
    }
}
