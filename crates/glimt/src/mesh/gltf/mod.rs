//! Host file: glTF 2.0 files, `.gltf` and `.glb`: the scene graph, its meshes, materials and cameras.

mod animation;
mod material;

use super::model::{Model, ModelCamera, Part};
use super::node::{Node, Trs};
use crate::error::{Error, Result};
use crate::notes::Notes;
use ::gltf::accessor::{DataType, Dimensions};
use ::gltf::buffer::{Data, Source};
use ::gltf::mesh::{Mode, Primitive};
use ::gltf::{Document, Gltf, Semantic};
use glam::{Mat4, Quat};
use glimt_render_gpu::prepare::scene::Mesh;
use std::collections::HashMap;
use std::collections::hash_map::Entry;
use std::path::{Path, PathBuf};

/// Reads a glTF file and all that it refers to.
///
/// # Errors
/// A file cannot be read, is broken, or requires an extension that is not supported.
pub fn load(file: &Path, notes: &mut Notes) -> Result<Model> {
    let bytes = std::fs::read(file).map_err(|e| Error::reading(file, &e))?;
    // Extensions first: a file that requires one may well be invalid without it.
    let raw = Gltf::from_slice_without_validation(&bytes).map_err(|e| broken(file, e))?;
    if let Some(extension) = raw.document.extensions_required().next() {
        return Err(Error::input(
            file,
            format!("it requires {extension}, which is not supported"),
        )
        .fix("convert it to plain glTF 2.0, as with `gltf-transform copy`"));
    }
    let Gltf { document, blob } = Gltf::from_slice(&bytes).map_err(|e| broken(file, e))?;
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

fn broken(file: &Path, error: ::gltf::Error) -> Error {
    use ::gltf::Error as E;
    use ::gltf::binary::Error as B;
    let truncated = "it is probably truncated: copy or export it again";
    match error {
        E::Io(e) | E::Binary(B::Io(e)) => Error::reading(file, &e),
        E::Binary(B::Length {
            length,
            length_read,
        }) => {
            let what =
                format!("the file ends too early: {length_read} of {length} bytes are there");
            Error::input(file, what).fix(truncated)
        }
        E::Binary(B::ChunkLength {
            length,
            length_read,
            ..
        }) => {
            let what = format!("a chunk ends too early: {length_read} of {length} bytes are there");
            Error::input(file, what).fix(truncated)
        }
        E::Deserialize(e) if e.is_eof() => {
            Error::input(file, "the file ends too early").fix(truncated)
        }
        E::Deserialize(e) => Error::input(file, format!("its JSON is not glTF: {e}")),
        E::Validation(list) => {
            let (path, e) = &list[0];
            Error::input(file, e)
                .at(path)
                .fix("the file is broken: export it again")
        }
        e => Error::input(file, format!("it is broken: {e}")).fix("export it again"),
    }
}

/// What is available while a file is read.
struct Reader<'a> {
    file: &'a Path,
    folder: &'a Path,
    document: &'a Document,
    buffers: Vec<Data>,
    model: Model,
    /// By texture and whether it holds colours.
    textures: HashMap<(usize, bool), u32>,
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
            let what = format!("its extension {extension} is not used");
            self.notes.note(self.file, what);
        }
        if self.document.skins().next().is_some() {
            let what = "its skins are not supported: meshes move with their nodes, not with bones";
            self.notes.note(self.file, what);
        }
    }

    fn read_buffers(&mut self, mut blob: Option<Vec<u8>>) -> Result<()> {
        for buffer in self.document.buffers() {
            let (source, place) = match buffer.source() {
                Source::Uri(uri) => match self.external(uri) {
                    Some(path) => (buffer.source(), path),
                    None => (buffer.source(), self.file.to_owned()),
                },
                Source::Bin => (buffer.source(), self.file.to_owned()),
            };
            let data = Data::from_source_and_blob(source, Some(self.folder), &mut blob)
                .map_err(|e| broken(&place, e))?;
            if data.len() < buffer.length() {
                let what = format!("{} of {} bytes are there", data.len(), buffer.length());
                return Err(Error::input(&place, what)
                    .at(format!("buffer {}", buffer.index()))
                    .fix("it is probably truncated: copy or export it again"));
            }
            self.buffers.push(data);
        }
        Ok(())
    }

    /// The file that a URI names, which is remembered; `None` for data inside the document.
    fn external(&mut self, uri: &str) -> Option<PathBuf> {
        if uri.starts_with("data:") {
            return None;
        }
        let path = self.folder.join(percent_decode(uri));
        if !self.model.files.contains(&path) {
            self.model.files.push(path.clone());
        }
        Some(path)
    }

    fn read_scene(&mut self) -> Result<()> {
        let scene = self
            .document
            .default_scene()
            .or_else(|| self.document.scenes().next());
        let Some(scene) = scene else {
            return Err(Error::input(self.file, "it has no scene").fix("export it with one"));
        };
        // Meshes that stand in several places are read once.
        let mut meshes: HashMap<usize, Vec<usize>> = HashMap::new();
        let mut nodes: HashMap<usize, usize> = HashMap::new();
        let is_animated = self.document.animations().next().is_some();
        let top = |node| (node, None, Mat4::IDENTITY);
        let mut stack: Vec<_> = scene.nodes().map(top).collect();
        while let Some((node, parent, to_file)) = stack.pop() {
            let local = Mat4::from_cols_array_2d(&node.transform().matrix());
            let transform = to_file * local;
            let own = self.model.nodes.len();
            // A node in several places would be as many nodes as there are ways to it: exponentially many.
            if nodes.insert(node.index(), own).is_some() {
                let what = "it stands in two places, or in itself, which glTF does not allow";
                return Err(self.error(what).at(format!("node {}", node.index())));
            }
            let (translation, rotation, scale) = node.transform().decomposed();
            let mesh = node.mesh();
            let mesh_name = mesh.as_ref().and_then(::gltf::Mesh::name);
            let unnamed = format!("node {}", node.index());
            self.model.nodes.push(Node {
                name: node.name().or(mesh_name).unwrap_or(&unnamed).to_owned(),
                parent,
                local,
                parts: Trs {
                    translation: translation.into(),
                    rotation: Quat::from_array(rotation),
                    scale: scale.into(),
                },
            });
            if let Some(mesh) = node.mesh() {
                let list = match meshes.entry(mesh.index()) {
                    Entry::Occupied(known) => known.into_mut(),
                    Entry::Vacant(new) => new.insert(self.read_mesh(&mesh)?),
                };
                // An animation may well unfold it.
                if transform.is_finite() && (is_animated || transform.determinant() != 0.0) {
                    let parts = list.iter().map(|&mesh| Part { mesh, node: own });
                    self.model.parts.extend(parts);
                } else {
                    let name = node.name().unwrap_or("without a name");
                    let what = format!("node `{name}` is scaled to nothing; left out");
                    self.notes.warn(self.file, what);
                }
            }
            if let Some(camera) = node.camera() {
                self.read_camera(&node, &camera, own);
            }
            let inner = |child| (child, Some(own), transform);
            stack.extend(node.children().map(inner));
        }
        self.read_animations(&nodes)
    }

    fn read_camera(&mut self, node: &::gltf::Node<'_>, camera: &::gltf::Camera<'_>, place: usize) {
        let unnamed = format!("camera {}", camera.index());
        let name = node.name().or(camera.name()).unwrap_or(&unnamed).to_owned();
        match camera.projection() {
            ::gltf::camera::Projection::Perspective(p) => self.model.cameras.push(ModelCamera {
                name,
                node: place,
                fov_y: p.yfov(),
            }),
            ::gltf::camera::Projection::Orthographic(_) => {
                let what = format!("camera `{name}` is orthographic; left out");
                self.notes.note(self.file, what);
            }
        }
    }

    /// One host mesh for each primitive that has triangles.
    fn read_mesh(&mut self, mesh: &::gltf::Mesh<'_>) -> Result<Vec<usize>> {
        let mut list = Vec::new();
        let unnamed = format!("mesh {}", mesh.index());
        let name = mesh.name().unwrap_or(&unnamed);
        for primitive in mesh.primitives() {
            let mode = primitive.mode();
            if !matches!(
                mode,
                Mode::Triangles | Mode::TriangleStrip | Mode::TriangleFan
            ) {
                let what = format!("`{name}` has points or lines; left out");
                self.notes.note(self.file, what);
                continue;
            }
            if primitive.morph_targets().next().is_some() {
                let what = format!("the morph targets of `{name}` are not used");
                self.notes.note(self.file, what);
            }
            let read = self.read_primitive(&primitive, name)?;
            self.model.meshes.push(read);
            list.push(self.model.meshes.len() - 1);
        }
        Ok(list)
    }

    fn read_primitive(&mut self, primitive: &Primitive<'_>, name: &str) -> Result<Mesh> {
        let place = format!("mesh `{name}`, primitive {}", primitive.index());
        let error = |what: &str| self.error(what).at(&place);
        let Some(positions) = primitive.get(&Semantic::Positions) else {
            return Err(error("it has no positions"));
        };
        let is_vec3 = |a: &::gltf::Accessor<'_>| {
            a.data_type() == DataType::F32 && a.dimensions() == Dimensions::Vec3
        };
        if !is_vec3(&positions) {
            return Err(error("its positions are not three floats"));
        }
        let count = positions.count();
        let mut mesh = Mesh {
            name: name.to_owned(),
            ..Mesh::default()
        };
        let reader = primitive.reader(|buffer| Some(&self.buffers[buffer.index()]));
        // A reader gives nothing where the accessor reaches beyond its buffer.
        let usable = |semantic: &Semantic, kinds: &[(DataType, Dimensions)]| -> Result<bool> {
            let Some(accessor) = primitive.get(semantic) else {
                return Ok(false);
            };
            if !kinds.contains(&(accessor.data_type(), accessor.dimensions())) {
                return Err(error(&format!("{semantic:?} has the wrong type")));
            }
            if accessor.count() != count || count == 0 {
                return Err(error(&format!(
                    "{semantic:?} has {} values for {count} vertices",
                    accessor.count()
                )));
            }
            Ok(true)
        };
        let beyond =
            |semantic: &Semantic| error(&format!("{semantic:?} reaches beyond its buffer"));

        if count > 0 {
            let list = reader
                .read_positions()
                .ok_or_else(|| beyond(&Semantic::Positions))?;
            mesh.positions = list.map(Into::into).collect();
        }
        if usable(&Semantic::Normals, &[(DataType::F32, Dimensions::Vec3)])? {
            let list = reader
                .read_normals()
                .ok_or_else(|| beyond(&Semantic::Normals))?;
            mesh.normals = list.map(Into::into).collect();
        }
        if usable(&Semantic::Tangents, &[(DataType::F32, Dimensions::Vec4)])? {
            let list = reader
                .read_tangents()
                .ok_or_else(|| beyond(&Semantic::Tangents))?;
            mesh.tangents = list.map(Into::into).collect();
        }
        let set = material::texture_set(&primitive.material());
        let semantic = Semantic::TexCoords(set);
        let uv_kinds = [DataType::F32, DataType::U8, DataType::U16].map(|t| (t, Dimensions::Vec2));
        if usable(&semantic, &uv_kinds)? {
            let list = reader
                .read_tex_coords(set)
                .ok_or_else(|| beyond(&semantic))?;
            mesh.uvs = list.into_f32().map(Into::into).collect();
        }
        let corners = match primitive.indices() {
            None => (0..count as u32).collect(),
            Some(accessor) => self.read_corners(primitive, &accessor, &place)?,
        };
        mesh.indices = triangles(&corners, primitive.mode());
        let material = self.material(&primitive.material())?;
        mesh.materials = vec![material];
        Ok(mesh)
    }

    /// The indices of a primitive, which `place` names.
    fn read_corners(
        &self,
        primitive: &Primitive<'_>,
        indices: &::gltf::Accessor<'_>,
        place: &str,
    ) -> Result<Vec<u32>> {
        let error = |what: &str| self.error(what).at(place);
        let whole = matches!(
            indices.data_type(),
            DataType::U8 | DataType::U16 | DataType::U32
        );
        if !whole || indices.dimensions() != Dimensions::Scalar {
            return Err(error("its indices have the wrong type"));
        }
        if indices.count() == 0 {
            return Ok(Vec::new());
        }
        let reader = primitive.reader(|buffer| Some(&self.buffers[buffer.index()]));
        let list = reader.read_indices();
        let list = list.ok_or_else(|| error("its indices reach beyond their buffer"))?;
        Ok(list.into_u32().collect())
    }
}

fn triangles(corners: &[u32], mode: Mode) -> Vec<[u32; 3]> {
    match mode {
        Mode::TriangleStrip => corners
            .windows(3)
            .enumerate()
            .map(|(i, t)| {
                if i % 2 == 1 {
                    [t[0], t[2], t[1]]
                } else {
                    [t[0], t[1], t[2]]
                }
            })
            .collect(),
        Mode::TriangleFan => corners
            .windows(2)
            .skip(1)
            .map(|pair| [pair[0], pair[1], corners[0]])
            .collect(),
        _ => corners.as_chunks::<3>().0.to_vec(),
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
    fn strips_and_fans_become_triangles() {
        let corners = [0, 1, 2, 3];
        assert_eq!(
            triangles(&corners, Mode::TriangleStrip),
            [[0, 1, 2], [1, 3, 2]]
        );
        assert_eq!(
            triangles(&corners, Mode::TriangleFan),
            [[1, 2, 0], [2, 3, 0]]
        );
        assert_eq!(triangles(&corners, Mode::Triangles), [[0, 1, 2]]);
    }

    #[test]
    fn escaped_names() {
        assert_eq!(percent_decode("a%20b%C3%A5.bin"), "a bå.bin");
        assert_eq!(percent_decode("100%"), "100%");
    }
}
