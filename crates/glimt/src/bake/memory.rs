//! Host file: how much memory a bake takes, and whether there is so much.

use crate::error::{Error, Result};
use crate::memory::{in_words, require};
use glimt_render_gpu::prepare::bake::required_bytes;
use glimt_render_gpu::prepare::scene::SceneDescription;
use std::hint::black_box;

/// Bytes at a vertex: of the meshes as they came, and of those that the scene has, with all attributes.
const VERTEX: u64 = 96;
/// Bytes at a triangle once the scene is built: of itself, its corners, and the nodes of the tree, in the pose and in the reference
/// pose.
const TRIANGLE: u64 = 300;
/// The same while the tree is built.
const TRIANGLE_BUILT: u64 = 500;
/// Bytes at a texel: of the image, and as kernels have it.
const TEXEL: u64 = 8;
/// Bytes of the program itself.
const PROGRAM: u64 = 16 << 20;

/// What a bake is of, and how much memory it takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Need {
    /// Vertices of all objects.
    pub vertices: u64,
    /// Triangles of all objects.
    pub triangles: u64,
    /// Bytes of memory at the most.
    pub bytes: u64,
}

impl Need {
    /// Of a scene, before anything is built of it. Meshes that stand in several places are counted in each.
    #[must_use]
    pub fn of(scene: &SceneDescription, bands: u32) -> Self {
        let meshes = scene.objects.iter();
        let meshes = meshes.filter_map(|object| scene.meshes.get(object.mesh as usize));
        let (vertices, triangles) = meshes.fold((0, 0), |(vertices, triangles), mesh| {
            let more = (mesh.positions.len() as u64, mesh.indices.len() as u64);
            (vertices + more.0, triangles + more.1)
        });
        let texels: u64 = scene.textures.iter().map(|t| t.texels.len() as u64).sum();
        let built = triangles * TRIANGLE_BUILT;
        let computed = (triangles * TRIANGLE).saturating_add(required_bytes(vertices, bands));
        let both = PROGRAM + vertices * VERTEX + texels * TEXEL;
        Self {
            vertices,
            triangles,
            bytes: both.saturating_add(built.max(computed)),
        }
    }

    /// Sees that there is so much memory, by asking for it at once: where a part of it is missing later, a program ends without
    /// a word.
    ///
    /// # Errors
    /// There is less.
    pub fn check(&self) -> Result<()> {
        let fix = "lower render.prt.bands or object.N.subdivide";
        let (vertices, triangles) = (self.vertices, self.triangles);
        let what = format!("transfer at {vertices} vertices of {triangles} triangles");
        require(&what, self.bytes).map_err(|e| e.fix(fix))?;
        let there = usize::try_from(self.bytes).is_ok_and(|bytes| {
            let mut room: Vec<u8> = Vec::new();
            let there = room.try_reserve_exact(bytes).is_ok();
            // Or it would never be asked for.
            black_box(&mut room);
            there
        });
        if there {
            return Ok(());
        }
        let takes = in_words(self.bytes);
        let what = format!("{what} takes {takes} of memory, and there is less");
        Err(Error::device(what).fix(fix))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glimt_render_gpu::prepare::scene::{Mesh, Object};

    #[test]
    fn each_place_of_a_mesh_counts() {
        let mesh = Mesh {
            positions: vec![glam::Vec3::ZERO; 1000],
            indices: vec![[0, 1, 2]; 2000],
            ..Mesh::default()
        };
        let object = Object {
            mesh: 0,
            transform: glam::Mat4::IDENTITY,
            material: None,
            catcher: false,
        };
        let scene = SceneDescription {
            meshes: vec![mesh],
            objects: vec![object.clone(), object],
            ..SceneDescription::default()
        };
        let need = Need::of(&scene, 1);
        assert_eq!((need.vertices, need.triangles), (2000, 4000));
        // The tree takes more than one band, less than six.
        assert_eq!(need.bytes, (16 << 20) + 2000 * 96 + 4000 * 500);
        let more = Need::of(&scene, 6).bytes;
        assert_eq!(more, (16 << 20) + 2000 * (96 + 400) + 4000 * 300);
    }

    #[test]
    fn what_is_not_there_is_an_error() {
        let need = |bytes| Need {
            vertices: 3,
            triangles: 1,
            bytes,
        };
        assert!(need(1 << 20).check().is_ok());
        for bytes in [isize::MAX as u64 / 2, u64::MAX] {
            let error = need(bytes).check().expect_err("no such memory").to_string();
            assert!(error.contains("3 vertices"), "{error}");
            assert!(error.contains("lower render.prt.bands"), "{error}");
        }
    }
}
