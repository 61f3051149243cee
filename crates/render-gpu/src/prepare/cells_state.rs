//! Host file: what light cells carry from frame to frame.

use glam::UVec2;

use super::past_frame::PastFrame;
use super::render::RenderSettings;
use super::scene_build::SceneBuffers;
use crate::kernels::cell_state::TileEntry;
use crate::methods::cells::entries;

/// What two frames must have in common for counts to go from one to the other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CellsKey {
    /// Size of the image.
    pub size: UVec2,
    /// Key of the random streams: another seed is another experiment.
    pub seed: u32,
    /// Objects of the scene.
    pub objects: u32,
}

/// All that light cells need to continue from a frame.
#[derive(Clone, Debug)]
pub struct CellsState {
    /// What the next frame must have in common with it.
    pub key: CellsKey,
    /// The frame.
    pub past: PastFrame,
    /// The objects that its tiles showed, [`ENTRIES`](crate::kernels::cell_state::ENTRIES) of each tile.
    pub entries: Vec<TileEntry>,
    /// How many rays went to each cell, and how many arrived: [`COUNT_WORDS`](crate::kernels::cell_state::COUNT_WORDS) words of each
    /// entry.
    pub counts: Vec<u32>,
}

impl CellsKey {
    /// Entries of all tiles of the image.
    #[must_use]
    pub fn entries(&self) -> usize {
        entries(self.size)
    }

    /// Of a frame of these settings.
    #[must_use]
    pub fn new(settings: &RenderSettings, scene: &SceneBuffers) -> Self {
        Self {
            size: settings.size,
            seed: settings.seed,
            objects: scene.transforms().len() as u32,
        }
    }
}
