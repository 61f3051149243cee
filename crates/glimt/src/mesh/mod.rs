//! Host file: meshes in: files and built-in shapes as the renderer's host types, checked.

pub mod animation;
pub mod builtin;
pub mod clean;
pub mod colors;
pub mod contents;
pub mod deform;
pub mod gltf;
pub mod joiner;
pub mod lines;
pub mod model;
pub mod node;
pub mod normals;
pub mod obj;
pub mod origin;
pub mod pictures;
pub mod ply;
pub mod stl;
pub mod subdivide;
pub mod triangulate;

use crate::error::{Error, Result};
use crate::memory;
use crate::notes::Notes;
use model::Model;
use std::path::Path;
use std::time::Instant;

/// Bytes that are taken for each byte of a mesh file while it is read; packed ones unfold.
const READ_BYTES: u64 = 6;

/// Sees that a mesh file can be read, by its length.
fn require_room(file: &Path) -> Result<()> {
    // What is not there is said by who reads it.
    let length = std::fs::metadata(file).map_or(0, |data| data.len());
    let packed = file.extension().is_some_and(|extension| extension == "gz");
    let bytes = length * if packed { 4 * READ_BYTES } else { READ_BYTES };
    let room = memory::require("reading this mesh", bytes);
    room.map_err(|e| e.file(file).fix(memory::FIX))
}

/// Loads a built-in mesh, as `sphere`, or a file by its extension; a relative path is relative to `base`. Normals that a file lacks
/// are made: faces that are turned by less than `crease_deg` degrees against each other are smooth, unless the file says otherwise.
///
/// # Errors
/// The file cannot be read, is broken, or holds no triangle; with strict `notes` also what would be a warning.
pub fn load(base: &Path, name: &str, crease_deg: f32, notes: &mut Notes) -> Result<Model> {
    if let Some(model) = builtin::load(name) {
        return Ok(model);
    }
    let began = Instant::now();
    let said = notes.waiting();
    let file = base.join(name);
    require_room(&file)?;
    let lower = name.to_ascii_lowercase();
    let lower = lower.strip_suffix(".gz").unwrap_or(&lower);
    let mut model = match lower
        .rsplit_once('.')
        .map_or("", |(_, extension)| extension)
    {
        "glb" | "gltf" => gltf::load(&file, notes)?,
        "obj" => obj::load(&file, crease_deg, notes)?,
        "ply" => ply::load(&file, notes)?,
        "stl" => stl::load(&file, notes)?,
        _ => {
            return Err(Error::input(&file, "it is not a known kind of mesh")
                .fix("known are .glb, .gltf, .obj, .ply, .stl, the latter three also as .gz, and the built-in \"sphere\", \"plane\", \"armillary\" and \"helicopter\""));
        }
    };
    clean::clean(&mut model, &file, notes)?;
    for (index, mesh) in model.meshes.iter_mut().enumerate() {
        // A mesh that deforms has normals of its faces, made in each pose.
        if mesh.normals.is_empty() && !model.deforms.contains_key(&index) {
            normals::creased(mesh, crease_deg);
            model.made_normals.creased += mesh.indices.len();
        }
    }
    let creased = model.made_normals.creased;
    if creased > 0 {
        let what = format!(
            "{creased} of its triangles have no normals; made smooth, but for edges of more than {crease_deg}° (`crease_deg`)"
        );
        notes.note(&file, what);
    }
    // What changes the look of an object.
    notes.refuse_after(said)?;
    let (triangles, time) = (model.triangles(), began.elapsed());
    tracing::info!(
        "{}: {triangles} triangles, read in {time:.2?}",
        file.display()
    );
    Ok(model)
}
