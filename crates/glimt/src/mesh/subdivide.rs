//! Host file: triangles cut in four by the middles of their edges.

use glam::Vec3;
use glimt_render_gpu::prepare::scene::Mesh;
use std::collections::HashMap;

/// The most triangles that a model is cut into.
pub const MOST_TRIANGLES: u64 = 50_000_000;

/// How many triangles a model of so many has when each was cut in four so many times.
#[must_use]
pub fn triangles_after(triangles: u64, times: u32) -> u64 {
    triangles.saturating_mul(1u64.checked_shl(2 * times).unwrap_or(u64::MAX))
}

/// Cuts each triangle of a mesh in four, so many times. The surface looks as before: what a mesh lacks of normals and tangents is
/// made of the faces that it came with.
pub fn subdivide(mesh: &mut Mesh, times: u32) {
    if times > 0 {
        mesh.complete();
    }
    for _ in 0..times {
        *mesh = once(mesh);
    }
}

/// Cuts each triangle in four. Two that share an edge share its middle; what stands at vertices is interpolated.
fn once(mesh: &Mesh) -> Mesh {
    let mut cut = Mesh {
        indices: Vec::with_capacity(4 * mesh.indices.len()),
        ..mesh.clone()
    };
    cut.indices.clear();
    let mut middles: HashMap<(u32, u32), u32> = HashMap::with_capacity(3 * mesh.indices.len() / 2);
    for &[a, b, c] in &mesh.indices {
        let [ab, bc, ca] = [(a, b), (b, c), (c, a)].map(|(a, b)| {
            let edge = (a.min(b), a.max(b));
            *middles
                .entry(edge)
                .or_insert_with(|| add_middle(&mut cut, edge))
        });
        let parts = [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]];
        cut.indices.extend(parts);
    }
    if mesh.materials.len() != 1 {
        cut.materials = mesh.materials.iter().flat_map(|&m| [m; 4]).collect();
    }
    cut
}

/// Adds the middle of an edge. Where the edge's ends are given twice, for two normals, so are its middles, in the same place to
/// the bit: the edge's lower end comes first in both.
fn add_middle(mesh: &mut Mesh, (a, b): (u32, u32)) -> u32 {
    let index = mesh.positions.len() as u32;
    let (a, b) = (a as usize, b as usize);
    // Addition does not depend on the order of two.
    let position = 0.5 * mesh.positions[a] + 0.5 * mesh.positions[b];
    mesh.positions.push(position);
    if !mesh.normals.is_empty() {
        let mixed = direction(mesh.normals[a]) + direction(mesh.normals[b]);
        let normal = mixed.try_normalize().unwrap_or(mesh.normals[a]);
        mesh.normals.push(normal);
    }
    if !mesh.uvs.is_empty() {
        mesh.uvs.push(0.5 * (mesh.uvs[a] + mesh.uvs[b]));
    }
    if !mesh.colors.is_empty() {
        mesh.colors.push(0.5 * (mesh.colors[a] + mesh.colors[b]));
    }
    if !mesh.tangents.is_empty() {
        let (s, t) = (mesh.tangents[a], mesh.tangents[b]);
        let mixed = direction(s.truncate()) + direction(t.truncate());
        let tangent = mixed.try_normalize().unwrap_or(s.truncate());
        mesh.tangents.push(tangent.extend(s.w));
    }
    index
}

fn direction(v: Vec3) -> Vec3 {
    v.normalize_or_zero()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::builtin;
    use crate::mesh::model::Model;

    fn model(name: &str, times: u32) -> Model {
        let mut model = builtin::load(name).expect("a built-in mesh");
        for mesh in &mut model.meshes {
            subdivide(mesh, times);
        }
        model
    }

    /// How often each edge occurs, by the places of its ends.
    fn edges(mesh: &Mesh) -> HashMap<[[u32; 3]; 2], usize> {
        let mut edges = HashMap::new();
        for &[a, b, c] in &mesh.indices {
            for (a, b) in [(a, b), (b, c), (c, a)] {
                let mut ends = [a, b].map(|i| {
                    mesh.positions[i as usize]
                        .to_array()
                        .map(|x| (x + 0.0).to_bits())
                });
                ends.sort_unstable();
                *edges.entry(ends).or_default() += 1;
            }
        }
        edges
    }

    #[test]
    fn a_plane_has_the_vertices_and_faces_of_a_grid() {
        for times in 0..=5 {
            let model = model("plane", times);
            let (mesh, side) = (&model.meshes[0], 1usize << times);
            assert_eq!(mesh.positions.len(), (side + 1) * (side + 1));
            assert_eq!(mesh.indices.len(), 2 * side * side);
            assert_eq!(triangles_after(2, times), mesh.indices.len() as u64);
            assert!(mesh.normals.iter().all(|n| *n == Vec3::Z));
            let area: f32 = mesh.indices.iter().map(|t| area_of(mesh, *t)).sum();
            assert!((area - 4.0).abs() < 1e-5, "{area}");
            // Each edge has two triangles, but for those of the rim.
            let rim = edges(mesh).values().filter(|n| **n == 1).count();
            assert_eq!(rim, 4 * side);
            assert!(edges(mesh).values().all(|n| *n <= 2));
        }
    }

    fn area_of(mesh: &Mesh, [a, b, c]: [u32; 3]) -> f32 {
        let p = |i: u32| mesh.positions[i as usize];
        0.5 * (p(b) - p(a)).cross(p(c) - p(a)).z
    }

    #[test]
    fn a_sphere_stays_closed_across_its_seam() {
        let model = model("sphere", 1);
        let mesh = &model.meshes[0];
        assert!(edges(mesh).values().all(|n| *n == 2));
        assert!(mesh.normals.iter().all(|n| (n.length() - 1.0).abs() < 1e-6));
        let mut torn = mesh.clone();
        // On the seam, where it is given twice.
        torn.positions[10 * (128 + 1)].x += 1e-6;
        assert!(edges(&torn).values().any(|n| *n != 2));
    }

    /// A tetrahedron without normals is smooth, whose faces would be flat were its normals made of those that were cut.
    #[test]
    fn what_is_smooth_stays_smooth() {
        let mesh = Mesh {
            positions: vec![Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::Z],
            indices: vec![[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]],
            materials: vec![0],
            ..Mesh::default()
        };
        let mut smooth = mesh.clone();
        smooth.complete();
        let mut cut = mesh;
        subdivide(&mut cut, 2);
        assert_eq!(cut.normals.len(), cut.positions.len());
        let along = |i: usize| smooth.normals[i].normalize();
        for (p, n) in cut.positions.iter().zip(&cut.normals) {
            // In the middle of a face's side.
            if *p == Vec3::new(0.5, 0.5, 0.0) {
                assert!(
                    n.abs_diff_eq((along(1) + along(2)).normalize(), 1e-6),
                    "{n}"
                );
            }
        }
        let corner = cut.normals[0].normalize();
        assert!(
            corner.abs_diff_eq(Vec3::NEG_ONE.normalize(), 1e-6),
            "{corner}"
        );
        // Inside a face, off its edges: between the corners, and not the face's own.
        let inside = Vec3::new(0.25, 0.25, 0.5);
        let at = cut
            .positions
            .iter()
            .position(|p| *p == inside)
            .expect("a vertex");
        let face = Vec3::ONE.normalize();
        assert!(cut.normals[at].normalize().dot(face) < 0.99);
    }

    #[test]
    fn each_part_keeps_its_material() {
        let mesh = Mesh {
            positions: vec![Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::ONE],
            indices: vec![[0, 1, 2], [1, 3, 2]],
            materials: vec![4, 7],
            ..Mesh::default()
        };
        let cut = once(&mesh);
        assert_eq!(cut.materials, [4, 4, 4, 4, 7, 7, 7, 7]);
        assert_eq!((cut.positions.len(), cut.indices.len()), (9, 8));
        assert_eq!(triangles_after(u64::MAX, 3), u64::MAX);
    }
}
