//! Host file: PLY meshes, ASCII or binary, plain or gzipped.

mod assemble;
mod elements;

use super::contents;
use super::model::Model;
use crate::error::{Error, Result};
use crate::notes::Notes;
use elements::{Face, Faces, Skipped, Vertex, Vertices};
use ply_rs_bw::parser::{Parser, Reader};
use ply_rs_bw::ply::{ElementDef, Header};
use std::path::Path;

/// Reads a PLY file.
///
/// # Errors
/// It cannot be read, or is broken.
pub fn load(file: &Path, notes: &mut Notes) -> Result<Model> {
    assemble::assemble(read(file, notes)?, file, notes)
}

/// How many elements are read before they are put into lists.
const CHUNK: usize = 1 << 14;

/// What a file holds.
#[derive(Default)]
struct Content {
    vertices: Vertices,
    faces: Faces,
    strips: Faces,
    /// Names of pictures.
    pictures: Vec<String>,
}

fn read(file: &Path, notes: &mut Notes) -> Result<Content> {
    let broken = |e: ply_rs_bw::parser::ParseError| {
        let error = match e.kind() {
            std::io::ErrorKind::UnexpectedEof => Error::reading(file, &e.kind().into()),
            // The library quotes the file's line; its own words are the last of its lines.
            _ => Error::input(file, last_words(&e.to_string()))
                .fix("the file is broken: export it again"),
        };
        match e.line() {
            Some(line) => error.at_line(line, 1),
            None => error,
        }
    };
    let mut reader = Reader::new(contents::open(file)?);
    let header: Header = Parser::<Skipped>::new()
        .read_header(&mut reader)
        .map_err(broken)?;
    let mut content = Content {
        pictures: header.comments.iter().filter_map(|c| picture(c)).collect(),
        ..Content::default()
    };
    for (name, element) in &header.elements {
        // The file's length bounds how many there are of all but those that take no bytes.
        let mut left = match element.properties.is_empty() {
            true => 0,
            false => element.count,
        };
        while left > 0 {
            let part = ElementDef {
                count: left.min(CHUNK),
                ..element.clone()
            };
            left -= part.count;
            match name.as_str() {
                "vertex" => {
                    let list = Parser::<Vertex>::new()
                        .read_payload_for_element(&mut reader, &part, &header)
                        .map_err(broken)?;
                    content.vertices.extend(&list, element);
                }
                "face" | "tristrips" => {
                    let list = Parser::<Face>::new()
                        .read_payload_for_element(&mut reader, &part, &header)
                        .map_err(broken)?;
                    let faces = match name.as_str() {
                        "face" => &mut content.faces,
                        _ => &mut content.strips,
                    };
                    faces.extend(&list, element);
                }
                other => {
                    Parser::<Skipped>::new()
                        .read_payload_for_element(&mut reader, &part, &header)
                        .map_err(broken)?;
                    notes.note(file, format!("its element `{other}` is not used"));
                }
            }
        }
    }
    Ok(content)
}

/// The name of a picture in a comment, as MeshLab writes it.
fn picture(comment: &str) -> Option<String> {
    let (word, name) = comment.trim().split_once(char::is_whitespace)?;
    let is_picture = word.eq_ignore_ascii_case("TextureFile");
    is_picture.then(|| name.trim().trim_matches('"').to_owned())
}

fn last_words(message: &str) -> String {
    let last = message.lines().last().unwrap_or_default();
    last.trim().trim_start_matches("Error: ").to_owned()
}
