//! Host file: by what a file of transfer says which scene it is of.

use crate::shot::digest::{self, Hash};
use glam::Vec3;
use glimt_render_gpu::generated::digests;
use glimt_render_gpu::prepare::bake::BakeSettings;
use glimt_render_gpu::prepare::scene_build::SceneBuffers;
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

/// The version of the file's format, and of where rays of a vertex start, which [`Header::kernel`] does not tell of: whoever changes
/// either raises it, and older files are refused.
pub const VERSION: u32 = 1;

/// What stands in the file's `asset.extras.glimt_bake`.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize, Serialize)]
pub struct Header {
    /// [`VERSION`].
    pub version: u32,
    /// Bands of spherical harmonics.
    pub bands: u32,
    /// Directions at each vertex.
    pub directions: u32,
    /// Their seed.
    pub seed: u32,
    /// Whether light that arrives and light that is blocked are stored apart. Always so in this version: their sum is the transfer
    /// without shadows.
    pub shadowed: bool,
    /// SHA-256 of the kernel that computed it, in hexadecimal.
    pub kernel: String,
    /// SHA-256 of all objects' hashes, in hexadecimal.
    pub scene: String,
    /// The objects, in the order of the scene.
    pub objects: Vec<ObjectIdentity>,
}

/// What a file knows of an object.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize, Serialize)]
pub struct ObjectIdentity {
    /// Name of its mesh, for messages.
    pub name: String,
    /// How many vertices it has.
    pub vertices: u64,
    /// SHA-256 of its positions, normals and faces, and whether it is a catcher, in hexadecimal.
    pub geometry: String,
    /// SHA-256 of its transform, in hexadecimal.
    pub transform: String,
}

impl Header {
    /// Of the transfer of a scene.
    #[must_use]
    pub fn new(scene: &SceneBuffers, settings: &BakeSettings) -> Self {
        let transforms = scene.transforms().iter().enumerate();
        let objects: Vec<ObjectIdentity> = transforms
            .map(|(i, transform)| ObjectIdentity {
                name: scene.mesh(i).name.clone(),
                vertices: scene.mesh(i).positions.len() as u64,
                geometry: digest::hex(&of_geometry(scene, i)),
                transform: digest::hex(&of_bytes([bytemuck::bytes_of(transform)])),
            })
            .collect();
        let hashes = objects
            .iter()
            .flat_map(|o| [o.geometry.as_bytes(), o.transform.as_bytes()]);
        Self {
            version: VERSION,
            bands: settings.bands,
            directions: settings.directions,
            seed: settings.seed,
            shadowed: true,
            kernel: digests::BAKE.to_owned(),
            scene: digest::hex(&of_bytes(hashes)),
            objects,
        }
    }

    /// How this one's scene and kernel, which are now, differ from those of a file, in words; `None` where they do not.
    #[must_use]
    pub fn differs(&self, file: &Header) -> Option<Difference> {
        if self.objects.len() != file.objects.len() {
            let (now, then) = (self.objects.len(), file.objects.len());
            return Some(Difference {
                object: None,
                what: format!("the scene has {now} objects now and had {then}"),
            });
        }
        let pairs = self.objects.iter().zip(&file.objects).enumerate();
        for (i, (now, then)) in pairs {
            let what = if now.geometry != then.geometry && now.vertices != then.vertices {
                let (now, then) = (now.vertices, then.vertices);
                format!("its mesh has {now} vertices now and had {then}")
            } else if now.geometry != then.geometry {
                "its mesh has changed, or whether it is a catcher".to_owned()
            } else if now.transform != then.transform {
                "it stands elsewhere now".to_owned()
            } else {
                continue;
            };
            return Some(Difference {
                object: Some(i),
                what,
            });
        }
        let what = if self.scene != file.scene {
            "its hash is of another scene"
        } else if self.kernel != file.kernel {
            "another version of glimt computed it, whose kernel was another"
        } else {
            return None;
        };
        Some(Difference {
            object: None,
            what: what.to_owned(),
        })
    }
}

/// How a scene, or what is computed of it, differs from another.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Difference {
    /// The object of the scene that differs, if it is one.
    pub object: Option<usize>,
    /// In words.
    pub what: String,
}

fn of_geometry(scene: &SceneBuffers, object: usize) -> Hash {
    let mesh = scene.mesh(object);
    let counts = [mesh.positions.len() as u64, mesh.indices.len() as u64];
    of_bytes([
        bytemuck::cast_slice::<u64, u8>(&counts),
        floats(&mesh.positions),
        floats(&mesh.normals),
        bytemuck::cast_slice(mesh.indices.as_flattened()),
        &[u8::from(scene.is_catcher(object))],
    ])
}

fn floats(list: &[Vec3]) -> &[u8] {
    bytemuck::cast_slice(list)
}

fn of_bytes<'a>(parts: impl IntoIterator<Item = &'a [u8]>) -> Hash {
    let mut hasher = Sha256::new();
    for part in parts {
        hasher.update(part);
    }
    hasher.finalize().into()
}
