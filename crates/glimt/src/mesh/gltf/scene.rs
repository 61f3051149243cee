//! Host file: the scene of a glTF file: its nodes, and what stands at them.

use super::Reader;
use super::accessor::Whole;
use crate::error::{Error, Result};
use crate::mesh::deform::Skin;
use crate::mesh::model::{ModelCamera, Part};
use crate::mesh::node::{Node, Trs};
use ::gltf::accessor::{Accessor, DataType};
use glam::{Mat4, Quat, Vec3};
use serde_json::Value;
use std::collections::HashMap;
use std::collections::hash_map::Entry;

const FLOATS: [DataType; 1] = [DataType::F32];
const ROTATIONS: [DataType; 3] = [DataType::F32, DataType::I8, DataType::I16];

impl<'a> Reader<'a> {
    /// Reads the nodes of the scene, with meshes, skins, cameras and animations.
    pub(super) fn read_scene(&mut self) -> Result<()> {
        let document = self.document;
        let scene = document
            .default_scene()
            .or_else(|| document.scenes().next());
        let Some(scene) = scene else {
            return Err(Error::input(self.file, "it has no scene").fix("export it with one"));
        };
        // Meshes that stand in several places are read once.
        let mut meshes: HashMap<usize, Vec<usize>> = HashMap::new();
        let mut nodes: HashMap<usize, usize> = HashMap::new();
        // Parts that joints move, with the number of the skin.
        let mut skinned: Vec<(usize, usize)> = Vec::new();
        let is_animated = document.animations().next().is_some();
        let top = |node| (node, None, Mat4::IDENTITY, true);
        let mut stack: Vec<_> = scene.nodes().map(top).collect();
        while let Some((node, parent, to_file, is_shown)) = stack.pop() {
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
                weights: weights(&node),
            });
            let visibility = node.extension_value("KHR_node_visibility");
            let is_shown =
                is_shown && visibility.is_none_or(|v| v["visible"] != Value::Bool(false));
            if let Some(mesh) = mesh.filter(|_| is_shown) {
                let list = match meshes.entry(mesh.index()) {
                    Entry::Occupied(known) => known.into_mut(),
                    Entry::Vacant(new) => new.insert(self.read_mesh(&mesh)?),
                };
                let list = list.clone();
                self.place(&node, own, transform, is_animated, &list, &mut skinned)?;
            }
            if let Some(camera) = node.camera() {
                self.read_camera(&node, &camera, own);
            }
            let inner = |child| (child, Some(own), transform, is_shown);
            stack.extend(node.children().map(inner));
        }
        self.read_skins(&nodes, &skinned)?;
        self.read_animations(&nodes)
    }

    /// Places the meshes of a node, which is number `own`.
    fn place(
        &mut self,
        node: &::gltf::Node<'a>,
        own: usize,
        transform: Mat4,
        is_animated: bool,
        meshes: &[usize],
        skinned: &mut Vec<(usize, usize)>,
    ) -> Result<()> {
        let skin = node.skin().map(|skin| skin.index());
        let follows_joints = |mesh: &usize| {
            let deform = self.model.deforms.get(mesh);
            deform.is_some_and(|deform| !deform.joints.is_empty())
        };
        let instances = self.read_instances(node)?;
        let (bound, free): (Vec<usize>, Vec<usize>) = meshes
            .iter()
            .partition(|mesh| skin.is_some() && follows_joints(mesh));
        for mesh in bound {
            skinned.extend(skin.map(|skin| (self.model.parts.len(), skin)));
            let part = Part {
                mesh,
                node: own,
                skin: None,
            };
            self.model.parts.push(part);
        }
        if free.is_empty() {
            return Ok(());
        }
        // An animation may well unfold it.
        if !(transform.is_finite() && (is_animated || transform.determinant() != 0.0)) {
            let name = node.name().unwrap_or("without a name");
            let what = format!("node `{name}` is scaled to nothing; left out");
            self.notes.warn(self.file, what);
            return Ok(());
        }
        let part = |mesh, node| Part {
            mesh,
            node,
            skin: None,
        };
        match instances {
            None => self
                .model
                .parts
                .extend(free.iter().map(|&mesh| part(mesh, own))),
            Some(instances) => {
                for parts in instances {
                    let inner = self.model.nodes.len();
                    self.model.nodes.push(Node {
                        name: String::new(),
                        parent: Some(own),
                        local: parts.matrix(),
                        parts,
                        weights: weights(node),
                    });
                    self.model
                        .parts
                        .extend(free.iter().map(|&mesh| part(mesh, inner)));
                }
            }
        }
        Ok(())
    }

    /// Where `EXT_mesh_gpu_instancing` places a node's mesh, within the node.
    fn read_instances(&self, node: &::gltf::Node<'_>) -> Result<Option<Vec<Trs>>> {
        let Some(extension) = node.extension_value("EXT_mesh_gpu_instancing") else {
            return Ok(None);
        };
        let place = format!("node {}, EXT_mesh_gpu_instancing", node.index());
        let accessor = |key: &str| -> Result<Option<Accessor<'_>>> {
            let Some(index) = extension["attributes"].get(key) else {
                return Ok(None);
            };
            let index = index.as_u64().and_then(|index| usize::try_from(index).ok());
            let found = index.and_then(|index| self.document.accessors().nth(index));
            let missing = || self.error(format!("{key} has no accessor")).at(&place);
            found.map(Some).ok_or_else(missing)
        };
        let vectors = |key: &str| -> Result<Option<Vec<Vec3>>> {
            let Some(accessor) = accessor(key)? else {
                return Ok(None);
            };
            let read = self.floats(&accessor, &FLOATS, Whole::AsMarked, key);
            let read = read.map_err(|e| e.at(&place))?;
            Ok(Some(read.into_iter().map(Vec3::from_array).collect()))
        };
        let (translations, scales) = (vectors("TRANSLATION")?, vectors("SCALE")?);
        let rotations: Option<Vec<Quat>> = match accessor("ROTATION")? {
            None => None,
            Some(accessor) => {
                let read = self.floats(&accessor, &ROTATIONS, Whole::Fractions, "ROTATION");
                let read = read.map_err(|e| e.at(&place))?;
                let unit = |q| Quat::from_array(q).normalize();
                Some(read.into_iter().map(unit).collect())
            }
        };
        let counts = [
            translations.as_ref().map(Vec::len),
            rotations.as_ref().map(Vec::len),
            scales.as_ref().map(Vec::len),
        ];
        let mut counts = counts.into_iter().flatten();
        let count = counts.next().unwrap_or(0);
        if counts.any(|other| other != count) {
            let what = "its attributes have different numbers of instances";
            return Err(self.error(what).at(&place));
        }
        let instance = |i: usize| Trs {
            translation: translations.as_ref().map_or(Vec3::ZERO, |list| list[i]),
            rotation: rotations.as_ref().map_or(Quat::IDENTITY, |list| list[i]),
            scale: scales.as_ref().map_or(Vec3::ONE, |list| list[i]),
        };
        let all: Vec<Trs> = (0..count).map(instance).collect();
        match all.iter().all(|parts| parts.matrix().is_finite()) {
            true => Ok(Some(all)),
            false => Err(self.error("an instance is not finite").at(&place)),
        }
    }

    /// Reads the skins of these parts, once all nodes are known.
    fn read_skins(
        &mut self,
        nodes: &HashMap<usize, usize>,
        parts: &[(usize, usize)],
    ) -> Result<()> {
        let mut known: HashMap<usize, usize> = HashMap::new();
        for &(part, skin) in parts {
            let read = match known.get(&skin) {
                Some(&read) => read,
                None => {
                    let read = self.read_skin(nodes, skin)?;
                    self.model.skins.push(read);
                    let read = self.model.skins.len() - 1;
                    known.insert(skin, read);
                    read
                }
            };
            let mesh = self.model.parts[part].mesh;
            let deform = self.model.deforms.get(&mesh);
            let last = deform.and_then(|deform| deform.joints.iter().max().copied());
            let count = self.model.skins[read].joints.len();
            if last.is_some_and(|last| last as usize >= count) {
                let name = &self.model.meshes[mesh].name;
                let what =
                    format!("mesh `{name}` follows a joint that the skin has not: it has {count}");
                return Err(self.error(what).at(format!("skin {skin}")));
            }
            self.model.parts[part].skin = Some(read);
        }
        Ok(())
    }

    fn read_skin(&self, nodes: &HashMap<usize, usize>, index: usize) -> Result<Skin> {
        let error = |what: String| self.error(what).at(format!("skin {index}"));
        let Some(skin) = self.document.skins().nth(index) else {
            return Err(error("it does not exist".to_owned()));
        };
        let joint = |node: ::gltf::Node<'_>| {
            let found = nodes.get(&node.index()).copied();
            found.ok_or_else(|| {
                error(format!(
                    "its joint, node {}, is not in the scene",
                    node.index()
                ))
            })
        };
        let joints = skin.joints().map(joint).collect::<Result<Vec<usize>>>()?;
        let inverse_bind = match skin.inverse_bind_matrices() {
            None => vec![Mat4::IDENTITY; joints.len()],
            Some(accessor) => {
                let what = "the list of its inverse bind matrices";
                let read = self.floats::<16>(&accessor, &FLOATS, Whole::AsMarked, what);
                let read = read.map_err(|e| e.at(format!("skin {index}")))?;
                read.iter().map(Mat4::from_cols_array).collect()
            }
        };
        if inverse_bind.len() < joints.len() || !inverse_bind.iter().all(Mat4::is_finite) {
            let what = "its inverse bind matrices are fewer than its joints, or not finite";
            return Err(error(what.to_owned()));
        }
        let unnamed = format!("skin {index}");
        Ok(Skin {
            name: skin.name().unwrap_or(&unnamed).to_owned(),
            joints,
            inverse_bind,
        })
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
}

/// The weights of the morph targets of a node's mesh: the node's own, or else the mesh's; 0 where neither says one.
fn weights(node: &::gltf::Node<'_>) -> Vec<f32> {
    let Some(mesh) = node.mesh() else {
        return Vec::new();
    };
    let targets = mesh
        .primitives()
        .map(|primitive| primitive.morph_targets().count());
    let mut weights = node
        .weights()
        .or(mesh.weights())
        .unwrap_or_default()
        .to_vec();
    weights.resize(targets.max().unwrap_or(0), 0.0);
    weights
}
