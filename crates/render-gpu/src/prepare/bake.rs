//! Host file: transfer at all vertices of a scene (Hajisharif 2012, Eqs. 3 and 8), by rayon; what both processors need for it.

use std::collections::TryReserveError;
use std::sync::atomic::{AtomicU64, Ordering};

use rayon::prelude::*;

use super::scene_build::SceneBuffers;
use super::scene_error::SceneError;
use super::transfer::{SurfaceVertex, Transfer};
use crate::gpu::GpuError;
use crate::kernels::transfer::{STATE, TransferParams, TransferVertex, transfer};

/// The most bands of a transfer.
pub const MAX_BANDS: u32 = glimt_sh::MAX_BANDS;

/// The most directions at a vertex.
pub const MAX_DIRECTIONS: u32 = 1 << 20;

/// Vertices that are handed to a processor at a time.
pub(crate) const BLOCK: usize = 1 << 16;

/// How transfer is computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BakeSettings {
    /// Bands n, 1 to [`MAX_BANDS`].
    pub bands: u32,
    /// Directions N of the whole sphere at each vertex, 1 to [`MAX_DIRECTIONS`]; about half of them need a ray.
    pub directions: u32,
    /// Seed of the directions.
    pub seed: u32,
}

impl Default for BakeSettings {
    /// The paper's.
    fn default() -> Self {
        Self {
            bands: 5,
            directions: 2500,
            seed: 1,
        }
    }
}

/// Transfer that was computed.
#[derive(Clone, Debug, PartialEq)]
pub struct Baked {
    /// The coefficients.
    pub transfer: Transfer,
    /// The vertices that they are of.
    pub vertices: Vec<SurfaceVertex>,
    /// How many rays were traced.
    pub rays: u64,
}

/// Why transfer was not computed.
#[derive(Debug, thiserror::Error)]
pub enum BakeError {
    /// The number of bands is not in 1 to 6.
    #[error("a transfer has 1 to 6 bands, not {0}")]
    Bands(u32),
    /// The number of directions is not in 1 to 2²⁰.
    #[error("a transfer is computed from 1 to 1048576 directions, not {0}")]
    Directions(u32),
    /// There is not enough memory.
    #[error(
        "the transfer of {vertices} vertices takes {bytes} bytes, and there is not enough memory"
    )]
    Memory {
        /// How many vertices there are.
        vertices: u64,
        /// What they take.
        bytes: u64,
    },
    /// The scene's vertices lie beyond the world.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// The GPU failed.
    #[error(transparent)]
    Gpu(#[from] GpuError),
}

impl BakeSettings {
    /// Checks the settings.
    ///
    /// # Errors
    /// [`BakeError::Bands`], [`BakeError::Directions`].
    pub fn check(&self) -> Result<(), BakeError> {
        if !(1..=MAX_BANDS).contains(&self.bands) {
            return Err(BakeError::Bands(self.bands));
        }
        if !(1..=MAX_DIRECTIONS).contains(&self.directions) {
            return Err(BakeError::Directions(self.directions));
        }
        Ok(())
    }

    /// As the kernel takes them, for all rows of strata at once.
    #[must_use]
    pub fn params(&self) -> TransferParams {
        let rows = self.directions.isqrt();
        TransferParams {
            bands: self.bands,
            directions: self.directions,
            rows,
            seed: self.seed,
            first_row: 0,
            end_row: rows,
        }
    }

    /// As the kernel takes them, in parts of up to `directions` directions. A row that has more is one part.
    pub(crate) fn parts(&self, directions: u32) -> impl Iterator<Item = TransferParams> + use<> {
        let whole = self.params();
        let columns = self.directions.div_ceil(whole.rows.max(1));
        let step = (directions / columns.max(1)).max(1);
        let firsts = (0..whole.rows).step_by(step as usize);
        firsts.map(move |first_row| TransferParams {
            first_row,
            end_row: (first_row + step).min(whole.rows),
            ..whole
        })
    }
}

/// Bytes that the transfer of so many vertices takes in memory while it is computed; more than 2⁶⁴ count as that.
///
/// ```
/// use glimt_render_gpu::prepare::bake::required_bytes;
/// // Two lists of 25 floats, and twice the vertex while the objects' are put together.
/// assert_eq!(required_bytes(1, 5), 200 + 2 * 52);
/// assert_eq!(required_bytes(10_000_000, 6), 3_920_000_000);
/// ```
#[must_use]
pub fn required_bytes(vertices: u64, bands: u32) -> u64 {
    let n = u64::from(bands);
    let lists = (2 * size_of::<f32>() as u64).saturating_mul(n * n);
    vertices.saturating_mul(lists.saturating_add(2 * size_of::<SurfaceVertex>() as u64))
}

/// What kernels know of vertices. `first` is the number of the first.
#[must_use]
pub fn for_kernels(vertices: &[SurfaceVertex], first: usize) -> Vec<TransferVertex> {
    let numbered = (first as u32..).zip(vertices);
    let vertex = |(number, vertex): (u32, &SurfaceVertex)| TransferVertex {
        origin: vertex.origin,
        object: vertex.object,
        normal: vertex.normal,
        number,
        inner: vertex.inner,
        unused: 0.0,
    };
    numbered.map(vertex).collect()
}

/// Room for the transfer of so many vertices, all 0.
pub(crate) fn room(vertices: usize, bands: u32) -> Result<Transfer, BakeError> {
    let count = vertices.saturating_mul((bands * bands) as usize);
    let list = || {
        let mut list = Vec::new();
        list.try_reserve_exact(count)?;
        list.resize(count, 0.0);
        Ok::<_, TryReserveError>(list)
    };
    let no_room = |_| BakeError::Memory {
        vertices: vertices as u64,
        bytes: required_bytes(vertices as u64, bands),
    };
    Ok(Transfer {
        bands,
        lit: list().map_err(no_room)?,
        blocked: list().map_err(no_room)?,
    })
}

/// Computes the transfer at all vertices of a scene where its objects stand now, on all of rayon's threads. `progress` gets the
/// share that is done.
///
/// Each vertex has directions of its own, keyed by the seed and its number; threads change no bit.
///
/// # Errors
/// A [`BakeError`].
pub fn bake(
    scene: &SceneBuffers,
    settings: &BakeSettings,
    progress: &(dyn Fn(f32) + Sync),
) -> Result<Baked, BakeError> {
    settings.check()?;
    let total: usize = scene.vertex_counts().iter().sum();
    let mut made = room(total, settings.bands)?;
    let vertices = scene.vertices()?;
    let (params, view) = (settings.params(), scene.view());
    let count = made.coefficients();
    // Enough work for a thread to be worth handing out, little enough to tell of progress.
    let piece = (1 << 18) / settings.directions as usize;
    let piece = piece.clamp(1, 1024);
    let (rays, done) = (AtomicU64::new(0), AtomicU64::new(0));
    made.lit
        .par_chunks_mut(piece * count)
        .zip(made.blocked.par_chunks_mut(piece * count))
        .enumerate()
        .for_each(|(index, (lit, blocked))| {
            let first = index * piece;
            let own = &vertices[first..(first + piece).min(total)];
            let known = for_kernels(own, first);
            let chunks = lit.chunks_mut(count).zip(blocked.chunks_mut(count));
            let traced = (0..).zip(chunks).map(|(i, (lit, blocked))| {
                let (nodes, triangles, surface) = (view.nodes, view.triangles, view.surface);
                let state = &mut [0; STATE];
                u64::from(transfer(
                    i, &params, nodes, triangles, surface, &known, state, lit, blocked,
                ))
            });
            rays.fetch_add(traced.sum(), Ordering::Relaxed);
            let own = own.len() as u64;
            let done = done.fetch_add(own, Ordering::Relaxed) + own;
            progress(done as f32 / total as f32);
        });
    Ok(Baked {
        transfer: made,
        vertices,
        rays: rays.into_inner(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_cannot_be_computed_is_said() {
        let with = |bands, directions| {
            let settings = BakeSettings {
                bands,
                directions,
                seed: 1,
            };
            settings.check()
        };
        assert!(with(1, 1).is_ok() && with(6, MAX_DIRECTIONS).is_ok());
        for bands in [0, 7] {
            assert!(matches!(with(bands, 100), Err(BakeError::Bands(n)) if n == bands));
        }
        for directions in [0, MAX_DIRECTIONS + 1] {
            assert!(matches!(with(5, directions), Err(BakeError::Directions(_))));
        }
    }

    #[test]
    fn parts_are_the_whole() {
        for directions in [1, 2, 37, 2500, MAX_DIRECTIONS] {
            let settings = BakeSettings {
                directions,
                ..BakeSettings::default()
            };
            let rows = settings.params().rows;
            for most in [1, 256, 1 << 30] {
                let mut next = 0;
                for part in settings.parts(most) {
                    assert_eq!(part.first_row, next);
                    assert!(part.end_row > next);
                    let own = (part.end_row - next) * directions.div_ceil(rows);
                    assert!(own <= most || part.end_row == next + 1);
                    next = part.end_row;
                }
                assert_eq!(next, rows);
            }
        }
    }

    #[test]
    fn no_memory_is_an_error() {
        let error = room(usize::MAX / 8, 6).unwrap_err();
        assert!(matches!(error, BakeError::Memory { .. }), "{error}");
    }
}
