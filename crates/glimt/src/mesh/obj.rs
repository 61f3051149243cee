//! Host file: Wavefront OBJ meshes and their MTL materials.

use super::model::{Model, Part, default_material};
use super::node::Node;
use crate::error::{Error, Result};
use crate::notes::Notes;
use glam::{Vec2, Vec3};
use glimt_render_gpu::prepare::scene::{Material, Mesh, Reflection, Texture, Wrap};
use std::cell::{Cell, RefCell};
use std::collections::HashMap;
use std::fs::File;
use std::io::{BufRead, BufReader, Read};
use std::path::{Path, PathBuf};

/// Reads an OBJ file and the material libraries that it names.
///
/// # Errors
/// It cannot be read, or is broken. A material library that is missing is remarked upon only.
pub fn load(file: &Path, notes: &mut Notes) -> Result<Model> {
    let opened = File::open(file).map_err(|e| Error::reading(file, &e))?;
    let lines = Cell::new(0);
    let mut reader = Counting {
        inner: BufReader::new(opened),
        lines: &lines,
    };
    let folder = file.parent().unwrap_or(Path::new(""));
    let libraries: RefCell<Vec<PathBuf>> = RefCell::default();
    let load_library = |name: &Path| {
        let path = folder.join(name);
        let materials = tobj::load_mtl(&path);
        libraries.borrow_mut().push(path);
        materials
    };
    let options = tobj::GPU_LOAD_OPTIONS;
    let (groups, materials) = tobj::load_obj_buf(&mut reader, &options, load_library)
        .map_err(|e| broken(file, e, lines.get()))?;

    let libraries = libraries.into_inner();
    let (there, missing): (Vec<_>, Vec<_>) = libraries.into_iter().partition(|p| p.is_file());
    for library in missing {
        let what = format!(
            "its material library {} is missing; grey is used",
            library.display()
        );
        notes.warn(file, what);
    }
    let materials = materials.unwrap_or_else(|e| {
        if !there.is_empty() {
            notes.warn(
                file,
                format!("its materials cannot be read ({e}); grey is used"),
            );
        }
        Vec::new()
    });

    let mut model = Model {
        files: [file.to_owned()].into_iter().chain(there).collect(),
        ..Model::default()
    };
    for material in &materials {
        let converted = convert(material, folder, &mut model, notes);
        model.materials.push(converted);
        model.material_names.push(material.name.clone());
    }
    let grey = model.materials.len() as u32;
    if groups.iter().any(|g| material_of(g, grey) == grey) {
        model.materials.push(default_material());
        model.material_names.push("grey".to_owned());
    }
    let mut mesh = join(&groups, grey);
    mesh.name = file
        .file_name()
        .unwrap_or_default()
        .to_string_lossy()
        .into_owned();
    model.nodes.push(Node::at(&mesh.name, None, Vec3::ZERO));
    model.meshes.push(mesh);
    model.parts.push(Part {
        mesh: 0,
        node: 0,
        skin: None,
    });
    Ok(model)
}

fn material_of(group: &tobj::Model, none: u32) -> u32 {
    let id = group.mesh.material_id.filter(|id| *id < none as usize);
    id.map_or(none, |id| id as u32)
}

/// All groups as one mesh. Corners that differ in nothing are one, so that normals made for them run smoothly from one
/// group to the next.
fn join(groups: &[tobj::Model], no_material: u32) -> Mesh {
    let every = |has: fn(&tobj::Mesh) -> bool| groups.iter().all(|g| has(&g.mesh));
    let normals = every(|m| m.normals.len() == m.positions.len());
    let uvs = every(|m| m.texcoords.len() / 2 == m.positions.len() / 3);
    let mut mesh = Mesh::default();
    let mut known: HashMap<[u32; 8], u32> = HashMap::new();
    for group in groups {
        let material = material_of(group, no_material);
        let group = &group.mesh;
        let mut corner = |index: u32| {
            let i = index as usize;
            let take3 = |v: &[f32]| Vec3::new(v[3 * i], v[3 * i + 1], v[3 * i + 2]);
            let p = take3(&group.positions);
            let n = if normals {
                take3(&group.normals)
            } else {
                Vec3::ZERO
            };
            let uv = if uvs {
                // OBJ counts v from the bottom of the image.
                Vec2::new(group.texcoords[2 * i], 1.0 - group.texcoords[2 * i + 1])
            } else {
                Vec2::ZERO
            };
            let key = [p.x, p.y, p.z, n.x, n.y, n.z, uv.x, uv.y].map(f32::to_bits);
            *known.entry(key).or_insert_with(|| {
                mesh.positions.push(p);
                if normals {
                    mesh.normals.push(n);
                }
                if uvs {
                    mesh.uvs.push(uv);
                }
                mesh.positions.len() as u32 - 1
            })
        };
        let (triangles, _) = group.indices.as_chunks::<3>();
        let triangles: Vec<[u32; 3]> = triangles.iter().map(|t| t.map(&mut corner)).collect();
        mesh.materials.extend(triangles.iter().map(|_| material));
        mesh.indices.extend(triangles);
    }
    mesh
}

/// `Kd`, `Ks`, `Ns`; with a picture (`map_Kd`), the metallic-roughness material nearest to them.
fn convert(m: &tobj::Material, folder: &Path, model: &mut Model, notes: &mut Notes) -> Material {
    let file = model.files[0].clone();
    let diffuse = m.diffuse.map_or(Vec3::splat(0.6), Vec3::from);
    let specular = m.specular.map_or(Vec3::ZERO, Vec3::from);
    let exponent = m.shininess.unwrap_or(1.0).clamp(0.0, 1e4);
    if m.dissolve.is_some_and(|d| d < 1.0) {
        notes.note(&file, format!("material `{}` is taken as opaque", m.name));
    }
    let picture = m.diffuse_texture.as_ref().and_then(|name| {
        let path = folder.join(name.replace('\\', "/"));
        match image::open(&path) {
            Ok(picture) => Some((path, picture.to_rgba8())),
            Err(e) => {
                notes.warn(
                    &file,
                    format!("{} cannot be read ({e}); left out", path.display()),
                );
                None
            }
        }
    });
    let Some((path, picture)) = picture else {
        return Material::from(Reflection::BlinnPhong {
            diffuse,
            specular,
            exponent,
        });
    };
    notes.note(
        &file,
        format!(
            "material `{}` has a picture; its specular colour is taken as 0.04",
            m.name
        ),
    );
    model.files.push(path);
    model.textures.push(Texture {
        size: glam::UVec2::new(picture.width(), picture.height()),
        texels: picture.pixels().map(|p| p.0).collect(),
        srgb: true,
        wrap: [Wrap::Repeat; 2],
    });
    Material::from(Reflection::MetallicRoughness {
        base_color: if diffuse == Vec3::ZERO {
            Vec3::ONE
        } else {
            diffuse
        },
        metallic: 0.0,
        // e = 2/α² − 2, α = roughness².
        roughness: (2.0 / (exponent + 2.0)).powf(0.25),
        base_color_texture: Some((model.textures.len() as u32 - 1).into()),
        metallic_roughness_texture: None,
        normal_texture: None,
        normal_scale: 1.0,
    })
}

fn broken(file: &Path, error: tobj::LoadError, lines: usize) -> Error {
    use tobj::LoadError as E;
    let outside = matches!(
        error,
        E::FaceVertexOutOfBounds | E::FaceTexCoordOutOfBounds | E::FaceNormalOutOfBounds
    );
    // The library finds such an index at the end of its group; the line is found again here.
    if outside && let Some((line, what)) = find_outside(file) {
        return Error::input(file, what)
            .at_line(line, 1)
            .fix("the file is broken: export it again");
    }
    Error::input(file, error)
        .at_line(lines.max(1), 1)
        .fix("the file is broken: export it again")
}

/// The first face with an index beyond what the file holds.
fn find_outside(file: &Path) -> Option<(usize, String)> {
    let mut text = String::new();
    File::open(file).ok()?.read_to_string(&mut text).ok()?;
    let kinds = [
        ("v ", "position"),
        ("vt ", "texture coordinate"),
        ("vn ", "normal"),
    ];
    let counts = kinds.map(|(start, _)| text.lines().filter(|l| l.starts_with(start)).count());
    for (number, line) in text.lines().enumerate() {
        let Some(corners) = line.strip_prefix("f ") else {
            continue;
        };
        for corner in corners.split_whitespace() {
            for (kind, word) in corner.split('/').take(3).enumerate() {
                let Ok(index) = word.parse::<i64>() else {
                    continue;
                };
                let count = counts[kind];
                if index == 0 || index.unsigned_abs() > count as u64 {
                    let name = kinds[kind].1;
                    let what = format!("{name} {index} does not exist: the file has {count}");
                    return Some((number + 1, what));
                }
            }
        }
    }
    None
}

/// Counts the lines that are read through it.
struct Counting<'a, R> {
    inner: R,
    lines: &'a Cell<usize>,
}

impl<R: Read> Read for Counting<'_, R> {
    fn read(&mut self, buffer: &mut [u8]) -> std::io::Result<usize> {
        self.inner.read(buffer)
    }
}

impl<R: BufRead> BufRead for Counting<'_, R> {
    fn fill_buf(&mut self) -> std::io::Result<&[u8]> {
        self.inner.fill_buf()
    }

    fn consume(&mut self, amount: usize) {
        self.inner.consume(amount);
    }

    fn read_line(&mut self, line: &mut String) -> std::io::Result<usize> {
        self.lines.set(self.lines.get() + 1);
        self.inner.read_line(line)
    }
}
