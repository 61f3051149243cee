//! Host file: PLY meshes, ASCII or binary, plain or gzipped.

mod assemble;
mod elements;

use super::contents;
use super::model::Model;
use crate::error::{Error, Result};
use crate::notes::Notes;
use elements::{CHANNELS, Face, Skipped, Vertex};
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

/// What a file holds.
#[derive(Default)]
struct Content {
    vertices: Vec<Vertex>,
    faces: Vec<Face>,
    strips: Vec<Face>,
    /// Names of pictures.
    pictures: Vec<String>,
    has: Has,
}

/// What its vertices and faces have beside positions and indices.
#[derive(Clone, Copy, Default)]
struct Has {
    normals: bool,
    uvs: bool,
    colors: bool,
    face_uvs: bool,
    face_colors: bool,
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
        match name.as_str() {
            "vertex" => {
                content.vertices = Parser::<Vertex>::new()
                    .read_payload_for_element(&mut reader, element, &header)
                    .map_err(broken)?;
                content.has.of_vertices(element);
            }
            "face" | "tristrips" => {
                let faces = Parser::<Face>::new()
                    .read_payload_for_element(&mut reader, element, &header)
                    .map_err(broken)?;
                if name == "face" {
                    content.has.of_faces(element);
                    content.faces = faces;
                } else {
                    content.strips = faces;
                }
            }
            other => {
                Parser::<Skipped>::new()
                    .read_payload_for_element(&mut reader, element, &header)
                    .map_err(broken)?;
                notes.note(file, format!("its element `{other}` is not used"));
            }
        }
    }
    Ok(content)
}

impl Has {
    fn of_vertices(&mut self, element: &ElementDef) {
        let uvs = [["s", "t"], ["u", "v"], ["texture_u", "texture_v"]];
        self.normals = has_all(element, &["nx", "ny", "nz"]);
        self.uvs = uvs.iter().any(|names| has_all(element, names));
        self.colors = has_color(element);
    }

    fn of_faces(&mut self, element: &ElementDef) {
        self.face_uvs = has_all(element, &["texcoord"]) || has_all(element, &["texcoords"]);
        self.face_colors = has_color(element);
    }
}

fn has_all(element: &ElementDef, names: &[&str]) -> bool {
    let mut names = names.iter();
    names.all(|name| element.properties.contains_key(*name))
}

fn has_color(element: &ElementDef) -> bool {
    let mut channels = CHANNELS[..3].iter();
    channels.all(|names| names.iter().any(|name| has_all(element, &[name])))
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
