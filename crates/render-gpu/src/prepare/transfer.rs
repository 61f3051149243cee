//! Host file: precomputed radiance transfer of a scene's vertices (Hajisharif 2012, Eqs. 3 and 8).

use std::sync::Arc;

use glam::Vec3;

use crate::kernels::prt::Surface;

/// A vertex of a scene in the world: where transfer is precomputed.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SurfaceVertex {
    /// Its place.
    pub position: Vec3,
    /// Its unit shading normal; zero where its mesh has none to speak of, as at a vertex without faces.
    pub normal: Vec3,
    /// Where rays start: a little above the surface, and where the surface ends, as much inside its edge. So walls that meet in an edge
    /// see each other, and what stands in the same plane is not missed.
    pub origin: Vec3,
    /// A point just beneath the surface.
    pub inner: Vec3,
    /// Index of the object that it belongs to.
    pub object: u32,
}

/// Coefficients of the transfer at each vertex of a scene, `∫ V(x, ω) ⟨n·ω⟩ y_lm(ω) dω`, in world coordinates, parted like
/// [`Reflected`](crate::kernels::estimator::Reflected): by V, and by 1 − V in its place. Their sum is the transfer without
/// shadows.
///
/// Vertices are numbered as in [`SceneBuffers::vertices`](super::scene_build::SceneBuffers::vertices). Each has `bands²`
/// coefficients in each of the two lists, k = l(l + 1) + m.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Transfer {
    /// Bands n, 1 to 6.
    pub bands: u32,
    /// Light that arrives.
    pub lit: Vec<f32>,
    /// Light that objects keep away.
    pub blocked: Vec<f32>,
}

/// Why a transfer was refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum TransferError {
    /// The number of bands is not in 1 to 6.
    #[error("a transfer has 1 to 6 bands, not {0}")]
    Bands(u32),
    /// It is of another number of vertices.
    #[error("a transfer of {found} coefficients does not fit a scene that needs {expected}")]
    Length {
        /// Coefficients in one of its lists.
        found: usize,
        /// What the scene's vertices need.
        expected: usize,
    },
    /// The scene is in a pose that has a tree of its own.
    #[error("objects have moved too far from where the scene was built: build it where they stand")]
    Moved,
    /// Kernels count coefficients in 32 bits.
    #[error("{0} coefficients in each list of a transfer; there may be 2^32")]
    TooMany(usize),
    /// A coefficient is not finite.
    #[error("the transfer of vertex {0} is not finite")]
    NotFinite(usize),
}

impl Transfer {
    /// Coefficients of one vertex.
    #[must_use]
    pub fn coefficients(&self) -> usize {
        (self.bands * self.bands) as usize
    }

    /// Checks it to be one of `vertices` vertices.
    ///
    /// # Errors
    /// A [`TransferError`].
    pub fn check(&self, vertices: usize) -> Result<(), TransferError> {
        if !(1..=glimt_sh::MAX_BANDS).contains(&self.bands) {
            return Err(TransferError::Bands(self.bands));
        }
        let expected = vertices.saturating_mul(self.coefficients());
        if expected > 1 << 32 {
            return Err(TransferError::TooMany(expected));
        }
        for list in [&self.lit, &self.blocked] {
            if list.len() != expected {
                return Err(TransferError::Length {
                    found: list.len(),
                    expected,
                });
            }
            if let Some(bad) = list.iter().position(|c| !c.is_finite()) {
                return Err(TransferError::NotFinite(bad / self.coefficients()));
            }
        }
        Ok(())
    }
}

/// A transfer, and how a scene's triangles are joined to it.
#[derive(Clone, Debug)]
pub struct SceneTransfer {
    id: u64,
    transfer: Arc<Transfer>,
    corner_vertices: Vec<u32>,
    reflections: Vec<f32>,
}

impl SceneTransfer {
    pub(super) fn new(
        id: u64,
        transfer: Arc<Transfer>,
        corner_vertices: Vec<u32>,
        reflections: Vec<f32>,
    ) -> Self {
        Self {
            id,
            transfer,
            corner_vertices,
            reflections,
        }
    }

    /// A number that no other one of this process has: tells an executor whether it has uploaded this one.
    #[must_use]
    pub fn id(&self) -> u64 {
        self.id
    }

    /// The coefficients.
    #[must_use]
    pub fn transfer(&self) -> &Transfer {
        &self.transfer
    }

    /// How many vertices there are.
    #[must_use]
    pub fn vertices(&self) -> u32 {
        (self.transfer.lit.len() / self.transfer.coefficients().max(1)) as u32
    }

    /// What kernels see of the surface, with a frame's light at its vertices.
    #[must_use]
    pub fn surface<'a>(&'a self, lights: &'a [crate::kernels::prt::VertexLight]) -> Surface<'a> {
        Surface {
            corner_vertices: &self.corner_vertices,
            reflections: &self.reflections,
            lights,
        }
    }
}
