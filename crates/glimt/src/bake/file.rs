//! Host file: transfer in a binary glTF file: one mesh for each object, in the world, with custom attributes of its vertices.
//!
//! `_SH_0`, `_SH_1`, … hold four coefficients of the light that arrives each, `_SH_BLOCKED_0`, … of the light that is blocked;
//! the last is filled up with zeros. `asset.extras.glimt_bake` holds a [`Header`].

use super::glb::{self, FLOAT, UNSIGNED_INT};
use super::identity::Header;
use crate::error::{Error, Result};
use crate::output::atomic::Pending;
use crate::output::target::Target;
use glam::{Mat4, Vec3};
use glimt_render_gpu::prepare::scene_build::SceneBuffers;
use glimt_render_gpu::prepare::transfer::{SurfaceVertex, Transfer};
use serde_json::{Value, json};
use std::io::{self, Write};
use std::path::Path;

/// The names of the attributes, without their numbers.
pub(super) const LIT: &str = "_SH_";
pub(super) const BLOCKED: &str = "_SH_BLOCKED_";

/// Bytes that the file of a scene will have, but for its document of some kilobytes.
#[must_use]
pub fn size(vertices: u64, triangles: u64, bands: u32) -> u64 {
    let vectors = u64::from((bands * bands).div_ceil(4));
    let vertex = 24 + 2 * 16 * vectors;
    vertices
        .saturating_mul(vertex)
        .saturating_add(triangles.saturating_mul(12))
}

/// The buffer of a file while its parts are named.
struct Layout {
    views: Vec<Value>,
    accessors: Vec<Value>,
    length: u64,
}

impl Layout {
    /// Names `count` values of some bytes each, which are next in the buffer; returns the number of their accessor.
    fn add(&mut self, target: u64, bytes: u64, count: usize, mut accessor: Value) -> usize {
        let length = bytes * count as u64;
        self.views.push(json!({
            "buffer": 0, "byteOffset": self.length, "byteLength": length, "target": target,
        }));
        accessor["bufferView"] = json!(self.views.len() - 1);
        accessor["count"] = json!(count);
        self.accessors.push(accessor);
        self.length += length;
        self.accessors.len() - 1
    }
}

/// A file of which all is known but the coefficients: how long it will be, before any of them is computed.
#[derive(Debug)]
pub struct FilePlan {
    head: Vec<u8>,
    bytes: u64,
}

impl FilePlan {
    /// The plan of a scene's transfer, that `header` describes, in `file`.
    ///
    /// # Errors
    /// The file would be too long.
    pub fn new(file: &Path, scene: &SceneBuffers, header: &Header) -> Result<Self> {
        let vectors = (header.bands * header.bands).div_ceil(4);
        let mut layout = Layout {
            views: Vec::new(),
            accessors: Vec::new(),
            length: 0,
        };
        let (mut meshes, mut nodes) = (Vec::new(), Vec::new());
        for (object, transform) in scene.transforms().iter().enumerate() {
            let name = &header.objects[object].name;
            let mesh = scene.mesh(object);
            let count = mesh.positions.len();
            if count == 0 {
                nodes.push(json!({"name": name}));
                continue;
            }
            let (low, high) = bounds(&mesh.positions, transform);
            let vector = json!({"componentType": FLOAT, "type": "VEC3"});
            let mut position = vector.clone();
            position["min"] = json!(low.to_array());
            position["max"] = json!(high.to_array());
            let mut attributes = json!({
                "POSITION": layout.add(34962, 12, count, position),
                "NORMAL": layout.add(34962, 12, count, vector),
            });
            for prefix in [LIT, BLOCKED] {
                for i in 0..vectors {
                    let vector = json!({"componentType": FLOAT, "type": "VEC4"});
                    attributes[format!("{prefix}{i}")] =
                        json!(layout.add(34962, 16, count, vector));
                }
            }
            let mut primitive = json!({"attributes": attributes, "mode": 0});
            if !mesh.indices.is_empty() {
                let word = json!({"componentType": UNSIGNED_INT, "type": "SCALAR"});
                let corners = 3 * mesh.indices.len();
                primitive["indices"] = json!(layout.add(34963, 4, corners, word));
                primitive["mode"] = json!(4);
            }
            nodes.push(json!({"name": name, "mesh": meshes.len()}));
            meshes.push(json!({
                "name": name, "primitives": [primitive], "extras": {"glimt_object": object},
            }));
        }
        // glTF has y up, the world here z.
        let half = std::f32::consts::FRAC_1_SQRT_2;
        let children: Vec<usize> = (0..nodes.len()).collect();
        let root = nodes.len();
        nodes.push(
            json!({"name": "world", "rotation": [-half, 0.0, 0.0, half], "children": children}),
        );
        let document = json!({
            "asset": {
                "version": "2.0",
                "generator": crate::output::SOFTWARE,
                "extras": {"glimt_bake": header},
            },
            "scene": 0,
            "scenes": [{"nodes": [root]}],
            "nodes": nodes,
            "meshes": meshes,
            "accessors": layout.accessors,
            "bufferViews": layout.views,
            "buffers": [{"byteLength": layout.length}],
        });
        let bytes = layout.length;
        let head = glb::head(&document, bytes).ok_or_else(|| too_long(file, bytes))?;
        Ok(Self { head, bytes })
    }

    /// Bytes that the file will have.
    #[must_use]
    pub fn size(&self) -> u64 {
        self.head.len() as u64 + self.bytes
    }

    /// Begins the file, and takes room on its disk for all of it.
    ///
    /// # Errors
    /// Its folder cannot be written to, or the disk is full.
    pub fn begin(&self, file: &Target) -> Result<Pending> {
        let mut pending = Pending::create(file)?;
        pending.reserve(self.size())?;
        Ok(pending)
    }

    /// Writes transfer into a file that was begun, and gives it its name.
    ///
    /// # Errors
    /// It cannot be written.
    pub fn write(
        &self,
        mut pending: Pending,
        scene: &SceneBuffers,
        vertices: &[SurfaceVertex],
        transfer: &Transfer,
    ) -> Result<()> {
        write_parts(&mut pending, &self.head, scene, vertices, transfer)
            .map_err(|e| pending.error(&e))?;
        pending.commit()
    }
}

/// The box around a mesh's vertices in the world, to the bit as [`SceneBuffers::vertices`] has them.
fn bounds(positions: &[Vec3], transform: &Mat4) -> (Vec3, Vec3) {
    let transform = transform.as_dmat4();
    let place = |p: &Vec3| transform.transform_point3(p.as_dvec3()).as_vec3();
    positions
        .iter()
        .map(place)
        .fold((Vec3::MAX, Vec3::MIN), |(low, high), p| {
            (low.min(p), high.max(p))
        })
}

/// The error of a file that would be too long.
pub fn too_long(file: &Path, bytes: u64) -> Error {
    let gigabytes = bytes as f64 / (1u64 << 30) as f64;
    Error::output(
        file,
        format!("it would be {gigabytes:.1} GiB long, and a .glb has 4 GiB at most"),
    )
    .fix("lower render.prt.bands or object.N.subdivide")
}

/// Writes what stands in the buffer, in the order in which it was named.
fn write_parts(
    out: &mut impl Write,
    head: &[u8],
    scene: &SceneBuffers,
    vertices: &[SurfaceVertex],
    transfer: &Transfer,
) -> io::Result<()> {
    out.write_all(head)?;
    let n = transfer.coefficients();
    let mut first = 0;
    for (object, count) in scene.vertex_counts().into_iter().enumerate() {
        let own = &vertices[first..first + count];
        for vertex in own {
            out.write_all(bytemuck::bytes_of(&vertex.position))?;
        }
        for vertex in own {
            // glTF wants unit normals. Where there is none, nothing is lit.
            let normal = match vertex.normal == Vec3::ZERO {
                true => Vec3::Z,
                false => vertex.normal,
            };
            out.write_all(bytemuck::bytes_of(&normal))?;
        }
        for list in [&transfer.lit, &transfer.blocked] {
            let own = &list[first * n..(first + count) * n];
            for from in (0..n).step_by(4) {
                for coefficients in own.chunks(n) {
                    let mut four = [0.0f32; 4];
                    let part = &coefficients[from..n.min(from + 4)];
                    four[..part.len()].copy_from_slice(part);
                    out.write_all(bytemuck::bytes_of(&four))?;
                }
            }
        }
        out.write_all(bytemuck::cast_slice(
            scene.mesh(object).indices.as_flattened(),
        ))?;
        first += count;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_ten_million_vertices_take_is_known_before() {
        // 9 vectors of each kind, position and normal; two triangles for each vertex.
        assert_eq!(size(10_000_000, 20_000_000, 6), 3_360_000_000);
        assert!(size(20_000_000, 40_000_000, 6) > u64::from(u32::MAX));
        let error = too_long(Path::new("a.glb"), size(20_000_000, 40_000_000, 6));
        let text = error.to_string();
        assert!(text.contains("a.glb: it would be 6.3 GiB long"), "{text}");
        assert_eq!(size(u64::MAX, 1, 6), u64::MAX);
    }
}
