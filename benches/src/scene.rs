//! Host file: the scene that images are compared on.

use crate::inputs::TriangleMesh;
use glam::{Mat4, Vec3, vec3};
use glimt_render_gpu::prepare::scene::{
    Camera, Material, Mesh, Object, Reflection, SceneDescription,
};

/// A camera before the mesh of [`on_a_plane`].
pub fn camera() -> Camera {
    Camera {
        eye: vec3(0.0, -3.2, 1.3),
        target: vec3(0.0, 0.0, 0.75),
        up: Vec3::Z,
        fov_x: 40_f32.to_radians(),
    }
}

/// The mesh, y up in its file, diffuse, 1.5 high, standing on a wide diffuse plane.
///
/// # Panics
/// Where the mesh has no points.
pub fn on_a_plane(mesh: &TriangleMesh) -> SceneDescription {
    let low = mesh
        .positions
        .iter()
        .copied()
        .reduce(Vec3::min)
        .expect("a point");
    let high = mesh
        .positions
        .iter()
        .copied()
        .reduce(Vec3::max)
        .expect("a point");
    let middle = 0.5 * (low + high);
    let scale = 1.5 / (high.y - low.y);
    let stand = Mat4::from_scale(Vec3::splat(scale))
        * Mat4::from_rotation_x(std::f32::consts::FRAC_PI_2)
        * Mat4::from_translation(vec3(-middle.x, -low.y, -middle.z));
    let plane = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
    let diffuse = |albedo| {
        Material::from(Reflection::BlinnPhong {
            diffuse: Vec3::splat(albedo),
            specular: Vec3::ZERO,
            exponent: 0.0,
        })
    };
    SceneDescription {
        meshes: vec![
            Mesh {
                name: mesh.name.clone(),
                positions: mesh.positions.clone(),
                indices: mesh.triangles.clone(),
                materials: vec![0],
                ..Mesh::default()
            },
            Mesh {
                name: "plane".to_owned(),
                positions: plane.map(|(x, y)| vec3(20.0 * x, 20.0 * y, 0.0)).to_vec(),
                indices: vec![[0, 1, 2], [0, 2, 3]],
                materials: vec![1],
                ..Mesh::default()
            },
        ],
        materials: vec![diffuse(0.7), diffuse(0.4)],
        textures: Vec::new(),
        objects: vec![
            Object {
                mesh: 0,
                transform: stand,
                material: None,
                catcher: false,
            },
            Object {
                mesh: 1,
                transform: Mat4::IDENTITY,
                material: None,
                catcher: false,
            },
        ],
    }
}
