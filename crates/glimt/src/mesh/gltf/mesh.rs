//! Host file: the meshes of a glTF file: vertices, faces, morph targets, and the joints that vertices follow.

use super::accessor::Whole;
use super::{Reader, material};
use crate::error::{Error, Result};
use crate::mesh::deform::{Deform, Target};
use crate::mesh::normals::flat;
use ::gltf::accessor::{Accessor, DataType};
use ::gltf::mesh::{Mode, Primitive};
use ::gltf::{Document, Semantic};
use glam::{Vec2, Vec3, Vec4};
use glimt_render_gpu::prepare::scene::Mesh;

const FLOATS: [DataType; 1] = [DataType::F32];
const FRACTIONS: [DataType; 3] = [DataType::F32, DataType::U8, DataType::U16];
const SMALL: [DataType; 5] = [
    DataType::F32,
    DataType::I8,
    DataType::U8,
    DataType::I16,
    DataType::U16,
];

/// A primitive that is read, and what its messages name.
struct Place<'a> {
    primitive: &'a Primitive<'a>,
    name: String,
    /// Types that positions, normals, tangents and texture coordinates may have.
    vectors: &'static [DataType],
    coordinates: &'static [DataType],
}

/// Whether the file says that its meshes are quantised.
fn is_quantized(document: &Document) -> bool {
    let mut used = document.extensions_used();
    used.any(|extension| extension == "KHR_mesh_quantization")
}

impl Reader<'_> {
    /// One host mesh for each primitive that has triangles.
    pub(super) fn read_mesh(&mut self, mesh: &::gltf::Mesh<'_>) -> Result<Vec<usize>> {
        let mut list = Vec::new();
        let unnamed = format!("mesh {}", mesh.index());
        let name = mesh.name().unwrap_or(&unnamed);
        let quantized = is_quantized(self.document);
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
            let place = Place {
                primitive: &primitive,
                name: format!("mesh `{name}`, primitive {}", primitive.index()),
                vectors: if quantized { &SMALL } else { &FLOATS },
                coordinates: if quantized { &SMALL } else { &FRACTIONS },
            };
            let index = self.model.meshes.len();
            let (read, deform) = self.read_primitive(&place, name)?;
            self.model.meshes.push(read);
            if deform != Deform::default() {
                self.model.deforms.insert(index, deform);
            }
            list.push(index);
        }
        Ok(list)
    }

    fn read_primitive(&mut self, place: &Place<'_>, name: &str) -> Result<(Mesh, Deform)> {
        let primitive = place.primitive;
        let material = primitive.material();
        let set = material::texture_set(&material);
        let mut mesh = self.read_vertices(place, set.unwrap_or(0))?;
        mesh.name = name.to_owned();
        let corners = match primitive.indices() {
            None => (0..mesh.positions.len() as u32).collect(),
            Some(accessor) => self.read_corners(place, &accessor)?,
        };
        mesh.indices = triangles(&corners, primitive.mode());
        mesh.materials = vec![self.material(&material)?];
        if let Some(set) = set
            && mesh.uvs.is_empty()
        {
            let what = format!("`{name}` has no texture coordinates {set}");
            let workaround = "its texture shows one colour";
            self.notes.defect(self.file, &what, workaround)?;
        }
        let mut deform = self.read_deform(place, mesh.positions.len())?;
        self.check_finite(place, &mesh, &deform)?;
        let count = mesh.positions.len();
        let in_range = |face: &[u32; 3]| face.iter().all(|&i| (i as usize) < count);
        if mesh.normals.is_empty() && mesh.indices.iter().all(in_range) {
            // Tangents belong to normals.
            mesh.tangents.clear();
            self.model.made_normals.flat += mesh.indices.len();
            match deform == Deform::default() {
                true => drop(flat(&mut mesh)),
                // The faces of each pose have normals of their own.
                false => deform = unshared(&mut mesh, &deform),
            }
        }
        Ok((mesh, deform))
    }

    fn read_vertices(&self, place: &Place<'_>, set: u32) -> Result<Mesh> {
        let of = |semantic: &Semantic| self.usable(place, semantic);
        let Some(positions) = place.primitive.get(&Semantic::Positions) else {
            return Err(self.error("it has no positions").at(&place.name));
        };
        let mut mesh = Mesh::default();
        if positions.count() > 0 {
            mesh.positions = self.vectors(place, &positions, place.vectors, "POSITION")?;
        }
        if let Some(accessor) = of(&Semantic::Normals)? {
            mesh.normals = self.vectors(place, &accessor, place.vectors, "NORMAL")?;
        }
        if let Some(accessor) = of(&Semantic::Tangents)? {
            let read = self.floats::<4>(&accessor, place.vectors, Whole::AsMarked, "TANGENT");
            let read = read.map_err(|e| e.at(&place.name))?;
            mesh.tangents = read.into_iter().map(Vec4::from).collect();
        }
        if let Some(accessor) = of(&Semantic::TexCoords(set))? {
            let whole = match place.coordinates == FRACTIONS {
                true => Whole::Fractions,
                false => Whole::AsMarked,
            };
            let read = self.floats::<2>(&accessor, place.coordinates, whole, "TEXCOORD");
            let read = read.map_err(|e| e.at(&place.name))?;
            mesh.uvs = read.into_iter().map(Vec2::from).collect();
        }
        if let Some(accessor) = of(&Semantic::Colors(0))? {
            mesh.colors = self.read_colors(place, &accessor)?;
        }
        Ok(mesh)
    }

    fn read_colors(&self, place: &Place<'_>, accessor: &Accessor<'_>) -> Result<Vec<Vec4>> {
        let has_alpha = accessor.dimensions() == ::gltf::accessor::Dimensions::Vec4;
        let (what, whole) = ("COLOR_0", Whole::Fractions);
        let colors: Vec<Vec4> = if has_alpha {
            let read = self.floats::<4>(accessor, &FRACTIONS, whole, what);
            let read = read.map_err(|e| e.at(&place.name))?;
            read.into_iter().map(Vec4::from).collect()
        } else {
            let read = self.floats::<3>(accessor, &FRACTIONS, whole, what);
            let read = read.map_err(|e| e.at(&place.name))?;
            read.into_iter()
                .map(|c| Vec3::from(c).extend(1.0))
                .collect()
        };
        if let Some(vertex) = colors.iter().position(|c| !c.is_finite()) {
            let error = self.error(format!("{what} of vertex {vertex} is not finite"));
            return Err(error.at(&place.name));
        }
        Ok(colors
            .into_iter()
            .map(|c| c.clamp(Vec4::ZERO, Vec4::ONE))
            .collect())
    }

    fn read_deform(&mut self, place: &Place<'_>, count: usize) -> Result<Deform> {
        let mut deform = Deform::default();
        for target in place.primitive.morph_targets() {
            let read = |accessor: Option<Accessor<'_>>, what: &str| match accessor {
                Some(a) if a.count() != count => {
                    Err(self.wrong_count(place, what, a.count(), count))
                }
                Some(a) if count > 0 => self.vectors(place, &a, place.vectors, what),
                _ => Ok(Vec::new()),
            };
            deform.targets.push(Target {
                positions: read(target.positions(), "POSITION of a morph target")?,
                normals: read(target.normals(), "NORMAL of a morph target")?,
                tangents: read(target.tangents(), "TANGENT of a morph target")?,
            });
        }
        self.read_influences(place, count, &mut deform)?;
        Ok(deform)
    }

    /// Joints and weights, four of each in a set.
    fn read_influences(&mut self, place: &Place<'_>, count: usize, to: &mut Deform) -> Result<()> {
        let (mut joints, mut weights) = (Vec::new(), Vec::new());
        for set in 0.. {
            let (of_joints, of_weights) = (Semantic::Joints(set), Semantic::Weights(set));
            let of_joints = self.usable(place, &of_joints)?;
            let of_weights = self.usable(place, &of_weights)?;
            let (Some(of_joints), Some(of_weights)) = (of_joints, of_weights) else {
                break;
            };
            let at = |e: Error| e.at(&place.name);
            let whole = [DataType::U8, DataType::U16];
            let read = self.integers::<4>(&of_joints, &whole, "JOINTS");
            joints.push(read.map_err(at)?);
            let read = self.floats::<4>(&of_weights, &FRACTIONS, Whole::Fractions, "WEIGHTS");
            weights.push(read.map_err(at)?);
        }
        let mut unbound = 0;
        for vertex in 0..if joints.is_empty() { 0 } else { count } {
            let weights = weights.iter().flat_map(|set| set[vertex]);
            let sum: f32 = weights.clone().sum();
            if !(sum <= f32::MAX) || weights.clone().any(|weight| weight < 0.0) {
                let what = format!("a weight of vertex {vertex} is negative or not finite");
                return Err(self.error(what).at(&place.name));
            }
            let first = to.weights.len();
            let joints = joints.iter().flat_map(|set| set[vertex]);
            // What has no weight may name a joint that there is not.
            let used = |(joint, weight)| if weight > 0.0 { joint } else { 0 };
            to.joints.extend(joints.zip(weights.clone()).map(used));
            if sum > 0.0 {
                to.weights.extend(weights.map(|weight| weight / sum));
            } else {
                unbound += 1;
                to.weights.extend(weights);
                to.weights[first] = 1.0;
            }
        }
        if unbound > 0 {
            let what = format!("{} has {unbound} vertices without weights", place.name);
            let workaround = "they follow the skin's first joint";
            self.notes.defect(self.file, &what, workaround)?;
        }
        Ok(())
    }

    fn check_finite(&self, place: &Place<'_>, mesh: &Mesh, deform: &Deform) -> Result<()> {
        let mut offsets = deform.targets.iter().flat_map(|target| {
            let Target {
                positions,
                normals,
                tangents,
            } = target;
            positions.iter().chain(normals).chain(tangents)
        });
        let is_finite = offsets.all(|offset| offset.is_finite());
        let deforms = *deform != Deform::default();
        match is_finite && (!deforms || mesh.normals.iter().all(|n| n.is_finite())) {
            true => Ok(()),
            false => Err(self.error("a morph target is not finite").at(&place.name)),
        }
    }

    fn vectors(
        &self,
        place: &Place<'_>,
        accessor: &Accessor<'_>,
        types: &[DataType],
        what: &str,
    ) -> Result<Vec<Vec3>> {
        let read = self.floats::<3>(accessor, types, Whole::AsMarked, what);
        let read = read.map_err(|e| e.at(&place.name))?;
        Ok(read.into_iter().map(Vec3::from).collect())
    }

    /// An attribute that has a value for each vertex, if there is one.
    fn usable<'a>(&self, place: &Place<'a>, semantic: &Semantic) -> Result<Option<Accessor<'a>>> {
        let Some(accessor) = place.primitive.get(semantic) else {
            return Ok(None);
        };
        let count = place
            .primitive
            .get(&Semantic::Positions)
            .map_or(0, |a| a.count());
        if accessor.count() != count || count == 0 {
            let what = semantic.to_string();
            return Err(self.wrong_count(place, &what, accessor.count(), count));
        }
        Ok(Some(accessor))
    }

    fn wrong_count(&self, place: &Place<'_>, what: &str, found: usize, count: usize) -> Error {
        let what = format!("{what} has {found} values for {count} vertices");
        self.error(what).at(&place.name)
    }

    /// The indices of a primitive.
    fn read_corners(&self, place: &Place<'_>, indices: &Accessor<'_>) -> Result<Vec<u32>> {
        if indices.count() == 0 {
            return Ok(Vec::new());
        }
        let whole = [DataType::U8, DataType::U16, DataType::U32];
        let read = self.integers::<1>(indices, &whole, "the list of its indices");
        let read = read.map_err(|e| e.at(&place.name))?;
        Ok(read.into_iter().map(|[index]| index).collect())
    }
}

/// Gives each corner of a mesh a vertex of its own; returns what these follow.
fn unshared(mesh: &mut Mesh, deform: &Deform) -> Deform {
    let corners = std::mem::take(&mut mesh.indices);
    let corners = corners.as_flattened();
    let each = deform.joints.len() / mesh.positions.len().max(1);
    mesh.positions = copied(&mesh.positions, 1, corners);
    mesh.uvs = copied(&mesh.uvs, 1, corners);
    mesh.colors = copied(&mesh.colors, 1, corners);
    let whole = (0..corners.len() as u32).collect::<Vec<_>>();
    mesh.indices = whole.as_chunks().0.to_vec();
    let target = |target: &Target| Target {
        positions: copied(&target.positions, 1, corners),
        ..Target::default()
    };
    Deform {
        targets: deform.targets.iter().map(target).collect(),
        joints: copied(&deform.joints, each, corners),
        weights: copied(&deform.weights, each, corners),
    }
}

/// The values of these vertices, of which each has so many; nothing where there are none.
fn copied<T: Copy>(list: &[T], each: usize, vertices: &[u32]) -> Vec<T> {
    if list.is_empty() {
        return Vec::new();
    }
    let values = vertices
        .iter()
        .flat_map(|&i| &list[i as usize * each..][..each]);
    values.copied().collect()
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
}
