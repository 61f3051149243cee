//! Host file: shading normals and tangents for meshes that have none.

use glam::{Vec3, Vec4};

use super::scene::Mesh;

impl Mesh {
    /// Gives the mesh what the renderer would make of its faces: normals, and tangents where it has texture coordinates. Those
    /// that there are stay. Who changes the faces calls this before, so that the surface looks as it did.
    ///
    /// A mesh with an index that is out of range, or with lists of other lengths, stays as it is; to render it is an error.
    pub fn complete(&mut self) {
        let count = self.positions.len();
        let mut corners = self.indices.as_flattened().iter();
        if corners.any(|i| *i as usize >= count) || ![0, count].contains(&self.uvs.len()) {
            return;
        }
        if self.normals.is_empty() {
            self.normals = area_weighted_normals(self);
        }
        if self.tangents.is_empty() && !self.uvs.is_empty() {
            self.tangents = uv_tangents(self);
        }
    }
}

/// For each position the mean of its faces' normals, weighted by their areas; zero where it has no face.
///
/// All indices are known to be in range.
fn area_weighted_normals(mesh: &Mesh) -> Vec<Vec3> {
    let mut normals = vec![Vec3::ZERO; mesh.positions.len()];
    for face in &mesh.indices {
        let [a, b, c] = face.map(|i| mesh.positions[i as usize]);
        let area_normal = (b - a).cross(c - a);
        for &i in face {
            normals[i as usize] += area_normal;
        }
    }
    normals
}

/// For each position the mean direction of growing u, in w the sign of the bitangent `w n × t`, which points where the
/// image's up does (towards shrinking v). Zero where texture coordinates say nothing.
///
/// All indices are known to be in range, and `mesh.uvs` to have one entry for each position.
fn uv_tangents(mesh: &Mesh) -> Vec<Vec4> {
    let mut tangents = vec![Vec4::ZERO; mesh.positions.len()];
    for face in &mesh.indices {
        let [a, b, c] = face.map(|i| mesh.positions[i as usize]);
        let [uv_a, uv_b, uv_c] = face.map(|i| mesh.uvs[i as usize]);
        let (ab, ac) = (uv_b - uv_a, uv_c - uv_a);
        // Twice the face's area in the image; positive where the image, whose v grows downwards, is seen mirrored.
        let area = ab.perp_dot(ac);
        if area == 0.0 {
            continue;
        }
        let along_u = ((b - a) * ac.y - (c - a) * ab.y) * area.signum();
        let weighted = along_u.extend(-area.signum() * along_u.length());
        for &i in face {
            tangents[i as usize] += weighted;
        }
    }
    for tangent in &mut tangents {
        tangent.w = if tangent.w < 0.0 { -1.0 } else { 1.0 };
    }
    tangents
}
