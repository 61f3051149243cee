//! Host file: the built-in meshes, made with z up.

mod armillary;
mod helicopter;
mod solid;

use super::model::Model;
use glam::{Vec2, Vec3};
use glimt_render_gpu::prepare::scene::Mesh;
use std::f32::consts::PI;

/// Rings and sectors of the sphere: its silhouette is off by 1/3000 of its radius at most.
const RINGS: u32 = 64;
const SECTORS: u32 = 128;

/// The mesh of that name, if there is one.
pub fn load(name: &str) -> Option<Model> {
    let mesh = match name {
        "armillary" => return Some(armillary::model()),
        "helicopter" => return Some(helicopter::model()),
        "sphere" => sphere(),
        "plane" => plane(),
        _ => return None,
    };
    Some(Model {
        z_up: true,
        ..Model::of_mesh(mesh)
    })
}

/// Two triangles over [−1, 1]² that face +z.
fn plane() -> Mesh {
    let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
    Mesh {
        name: "plane".to_owned(),
        positions: corners.map(|(x, y)| Vec3::new(x, y, 0.0)).into(),
        normals: vec![Vec3::Z; 4],
        uvs: corners
            .map(|(x, y)| Vec2::new(0.5 + 0.5 * x, 0.5 - 0.5 * y))
            .into(),
        indices: vec![[0, 1, 2], [0, 2, 3]],
        materials: vec![0],
        ..Mesh::default()
    }
}

/// The unit sphere around the origin, in rings of latitude.
fn sphere() -> Mesh {
    let mut mesh = Mesh {
        name: "sphere".to_owned(),
        materials: vec![0],
        ..Mesh::default()
    };
    for ring in 0..=RINGS {
        for sector in 0..=SECTORS {
            let uv = Vec2::new(sector as f32 / SECTORS as f32, ring as f32 / RINGS as f32);
            let (sin_theta, cos_theta) = (PI * uv.y).sin_cos();
            // The seam's two edges, and all corners at a pole, are the same points to the bit.
            let (sin_phi, cos_phi) = if sector == SECTORS {
                (0.0, 1.0)
            } else {
                (2.0 * PI * uv.x).sin_cos()
            };
            let n = match ring {
                0 => Vec3::Z,
                RINGS => Vec3::NEG_Z,
                _ => Vec3::new(sin_theta * cos_phi, sin_theta * sin_phi, cos_theta),
            };
            mesh.positions.push(n);
            mesh.normals.push(n);
            mesh.uvs.push(uv);
        }
    }
    let corner = |ring: u32, sector: u32| ring * (SECTORS + 1) + sector;
    for ring in 0..RINGS {
        for sector in 0..SECTORS {
            let (a, b) = (corner(ring, sector), corner(ring, sector + 1));
            let (c, d) = (corner(ring + 1, sector), corner(ring + 1, sector + 1));
            if ring > 0 {
                mesh.indices.push([a, c, b]);
            }
            if ring + 1 < RINGS {
                mesh.indices.push([b, c, d]);
            }
        }
    }
    mesh
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn faces_look_outward() {
        for mesh in [sphere(), plane()] {
            for [a, b, c] in mesh.indices.iter().map(|t| t.map(|i| i as usize)) {
                let p = &mesh.positions;
                let face = (p[b] - p[a]).cross(p[c] - p[a]);
                let normal = mesh.normals[a] + mesh.normals[b] + mesh.normals[c];
                assert!(face.length() > 0.0 && face.dot(normal) > 0.0);
            }
        }
    }
}
