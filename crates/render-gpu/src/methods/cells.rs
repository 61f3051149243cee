//! Host file: a control variate over cells of the light: what it counts of their visibility, and keeps for the next frame, on any device.

use bytemuck::Zeroable;
use glam::{Mat4, UVec2, Vec2};
use glimt_executor::gpu::Gpu;
use glimt_executor::{Device, Entry, Executor, Memory, Pass};
use glimt_light_cells::COLUMNS;

use super::{Inputs, KeptBytes, per_pixel};
use crate::film::SamplesOut;
use crate::generated::passes::{
    AddWorths, Carry, Expect, Pilot, Scout, SeeInTile, ShadeCells, ShadeCellsLayers, Worth,
};
use crate::kernels::cell_state::{
    COUNT_WORDS, ENTRIES, TILE_HEIGHT, TILE_WIDTH, TileEntry, VISIBILITY_WORDS, WORTHS,
};
use crate::kernels::past::PastView;
use crate::kernels::pilot::STEP;
use crate::kernels::scout::CellParams;
use crate::kernels::seen::SeenPoint;
use crate::prepare::cells_state::{CellsKey, CellsState};
use crate::prepare::past_frame::PastFrame;
use crate::prepare::render::{RenderError, RenderSettings};
use crate::prepare::scene_build::SceneBuffers;
use crate::settings::{any, between, settings};

settings! {
    /// Light cells: what 512 cells of the light send to a surface is summed up, and rays correct the sum. They look where it may be
    /// wrong: where the visibility of a cell, which other rays have counted, is neither 0 nor 1.
    Cells in "cells" {
        /// Shadow rays of a pixel, on average over the image.
        rays: u32 = 32, between(1, 65_536), "32 is usual";
        /// Pilot rays, as a share of those, where little is known: they count visibilities before the frame is rendered.
        pilot: f32 = 0.2, between(0.0, 1.0), "0.2 is usual";
        /// Whether a frame takes over what the frame before counted. Then it continues from that one.
        memory: bool = true, any, "";
        /// Pilot rays where that tells enough.
        upkeep: f32 = 0.1, between(0.0, 1.0), "0.1 is usual";
        /// Whether rays go where they are worth most, and not to all pixels alike.
        adaptive: bool = true, any, "";
    }
}

impl Cells {
    /// What kernels read for an image of this size, in a first frame.
    #[must_use]
    pub fn params(&self, size: UVec2) -> CellParams {
        let tiles = tiles(size);
        CellParams {
            rays: self.rays as f32,
            pilot: self.pilot,
            upkeep: self.upkeep,
            tiles_across: tiles.x,
            tiles: tiles.element_product(),
            is_adaptive: self.adaptive.into(),
            has_past: 0,
            turned: 0,
        }
    }

    /// Counts that the cost of a ray depends on.
    pub(super) fn cost(&self) -> [u32; 3] {
        [
            self.rays,
            (self.pilot * 1000.0) as u32,
            u32::from(self.memory),
        ]
    }
}

/// Tiles of an image, across and down.
fn tiles(size: UVec2) -> UVec2 {
    UVec2::new(size.x.div_ceil(TILE_WIDTH), size.y.div_ceil(TILE_HEIGHT))
}

/// Entries of all tiles of an image.
pub(crate) fn entries(size: UVec2) -> usize {
    let tiles = tiles(size);
    tiles.x as usize * tiles.y as usize * ENTRIES as usize
}

/// What is kept of a frame of this size.
pub(super) fn kept_bytes(size: UVec2) -> KeptBytes {
    let entries = entries(size) as u64;
    let counts = entries * u64::from(COUNT_WORDS) * size_of::<u32>() as u64;
    KeptBytes {
        largest: counts,
        all: counts + entries * size_of::<TileEntry>() as u64,
    }
}

/// How many columns of cells a light has turned between two frames. Add it to a cell's column in the first map: the second map shows the
/// same direction there.
fn turned_columns(before: Vec2, now: Vec2) -> u32 {
    let turn = before.angle_to(now) / std::f32::consts::TAU;
    ((turn * COLUMNS as f32).round() as i32).rem_euclid(COLUMNS as i32) as u32
}

/// The entries of its passes.
pub(super) fn pass_entries() -> Vec<&'static Entry> {
    vec![
        Scout::<Gpu>::entry(),
        Carry::<Gpu>::entry(),
        Pilot::<Gpu>::entry(),
        Expect::<Gpu>::entry(),
        Worth::<Gpu>::entry(),
        AddWorths::<Gpu>::entry(),
        SeeInTile::<Gpu>::entry(),
        ShadeCells::<Gpu>::entry(),
        ShadeCellsLayers::<Gpu>::entry(),
    ]
}

/// What the tiles of a frame showed, and what was counted there.
struct Counts<M: Memory> {
    entries: M::Buffer<TileEntry>,
    counts: M::Buffer<u32>,
}

impl<M: Memory> Counts<M> {
    fn new<D: Device<Memory = M>>(device: &D, entries: usize) -> Result<Self, D::Error> {
        Ok(Self {
            entries: device.zeroed("tile entries", entries)?,
            counts: device.zeroed("counts of cells", entries * COUNT_WORDS as usize)?,
        })
    }
}

/// What is known of a frame before it is rendered, and what of the frame before.
pub(crate) struct Counting<M: Memory> {
    key: CellsKey,
    params: CellParams,
    /// The frame before, once there is one.
    past: Option<PastFrame>,
    /// Its counts; room for one entry alone as long as no frame is kept.
    before: Counts<M>,
    now: Counts<M>,
    /// Of all entries, then the parts of the sum of what rays are worth.
    visibility: M::Buffer<u32>,
    worths: M::Buffer<f32>,
    motions: M::Buffer<Mat4>,
    view: PastView,
}

impl<M: Memory> std::fmt::Debug for Counting<M> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Counting")
            .field("key", &self.key)
            .finish_non_exhaustive()
    }
}

impl<M: Memory> Counting<M> {
    /// Room for a first frame of this size.
    fn new<D: Device<Memory = M>>(
        device: &D,
        key: CellsKey,
        before: Counts<M>,
    ) -> Result<Self, D::Error> {
        let params = Cells::default().params(key.size);
        let (tiles, entries) = (params.tiles as usize, key.entries());
        let words = entries * VISIBILITY_WORDS as usize;
        Ok(Self {
            key,
            params,
            past: None,
            before,
            now: Counts::new(device, entries)?,
            visibility: device.zeroed("visibilities", words + WORTHS as usize)?,
            worths: device.zeroed("worths", tiles)?,
            motions: device.zeroed("past.motions", key.objects as usize)?,
            view: PastView::zeroed(),
        })
    }

    /// Continues from `known` where the frame that is to come can, else starts.
    pub(crate) fn begin<D: Device<Memory = M>>(
        known: Option<Self>,
        device: &D,
        scene: &SceneBuffers,
        settings: &RenderSettings,
        own: &Cells,
    ) -> Result<Self, RenderError> {
        let key = CellsKey::new(settings, scene);
        let failed = RenderError::device::<D::Error>;
        let mut made = match known.filter(|known| known.key == key) {
            Some(known) => known,
            None => {
                let nothing = Counts::new(device, 1).map_err(failed)?;
                Self::new(device, key, nothing).map_err(failed)?
            }
        };
        made.params = own.params(key.size);
        if !own.memory {
            made.past = None;
        }
        if let Some(past) = &made.past {
            made.params.has_past = 1;
            made.view = PastView::of(&past.view);
            let motions = past.motions(scene);
            device.put(&mut made.motions, &motions).map_err(failed)?;
        }
        Ok(made)
    }

    /// Whether there is a frame before.
    pub(crate) fn has_past(&self) -> bool {
        self.past.is_some()
    }

    /// Sends out scouts and pilots of the whole image, which `inputs` begin.
    pub(crate) fn find<E: Executor<Memory = M>>(
        &mut self,
        executor: &mut E,
        inputs: Inputs<'_, M>,
    ) -> Result<(), E::Error> {
        let Inputs { frame, env, scene } = inputs;
        if let Some(past) = &self.past {
            self.params.turned = turned_columns(past.light_rotation, env.rotation);
        }
        let (cells, tiles) = (&self.params, self.params.tiles);
        let entries = self.key.entries();
        let pass = Scout {
            frame,
            cells,
            scene: scene.shorten(),
            entries: M::chunks(&mut self.now.entries, 0..entries, ENTRIES),
        };
        executor.run(pass, 0..tiles)?;
        let known = if self.past.is_some() { entries } else { 1 };
        let words = entries * COUNT_WORDS as usize;
        let known_words = known * COUNT_WORDS as usize;
        let pass = Carry {
            frame,
            cells,
            view: &self.view,
            env: env.shorten(),
            motions: M::slice(&self.motions, 0..self.key.objects.max(1) as usize),
            past_entries: M::slice(&self.before.entries, 0..known),
            past_counts: M::slice(&self.before.counts, 0..known_words),
            entries: M::chunks(&mut self.now.entries, 0..entries, ENTRIES),
        };
        executor.run(pass, 0..tiles)?;
        let pass = Pilot {
            frame,
            cells,
            env: env.shorten(),
            scene: scene.shorten(),
            entries: M::slice(&self.now.entries, 0..entries),
            past_counts: M::slice(&self.before.counts, 0..known_words),
            counts: M::chunks(&mut self.now.counts, 0..words, ENTRIES * COUNT_WORDS),
        };
        executor.run(pass, 0..tiles)?;
        let visibilities = entries * VISIBILITY_WORDS as usize;
        let per_tile = ENTRIES * VISIBILITY_WORDS;
        let pass = Expect {
            cells,
            entries: M::slice(&self.now.entries, 0..entries),
            counts: M::slice(&self.now.counts, 0..words),
            visibility: M::chunks(&mut self.visibility, 0..visibilities, per_tile),
        };
        executor.run(pass, 0..tiles)?;
        if cells.is_adaptive == 0 {
            return Ok(());
        }
        let pass = Worth {
            frame,
            env: env.shorten(),
            entries: M::slice(&self.now.entries, 0..entries),
            visibility: M::slice(&self.visibility, 0..visibilities),
            out: M::chunks(&mut self.worths, 0..tiles as usize, 1),
        };
        executor.run(pass, 0..tiles)?;
        let behind = visibilities..visibilities + WORTHS as usize;
        let pass = AddWorths {
            cells,
            parts: WORTHS,
            worths: M::slice(&self.worths, 0..tiles as usize),
            out: M::chunks(&mut self.visibility, behind, 1),
        };
        executor.run(pass, 0..WORTHS)
    }

    /// Pilot rays of a pixel of this frame, on average over the image.
    pub(crate) fn pilot_rays<D: Device<Memory = M>>(&self, device: &D) -> Result<f64, D::Error> {
        let entries = device.get(&self.now.entries, self.key.entries())?;
        // One pixel of each block of them sends pilots out.
        let rays = |entry: &TileEntry| f64::from(entry.hits) * f64::from(entry.pilots);
        let all: f64 = entries.iter().map(rays).sum();
        let pixels = f64::from(self.key.size.x) * f64::from(self.key.size.y);
        Ok(all / f64::from(STEP * STEP) / pixels)
    }

    /// This frame becomes the frame before.
    pub(crate) fn end<D: Device<Memory = M>>(
        &mut self,
        device: &D,
        past: PastFrame,
    ) -> Result<(), D::Error> {
        if self.past.is_none() {
            self.before = Counts::new(device, self.key.entries())?;
        }
        std::mem::swap(&mut self.before, &mut self.now);
        self.past = Some(past);
        Ok(())
    }

    /// The frame before, copied.
    pub(crate) fn read<D: Device<Memory = M>>(
        &self,
        device: &D,
    ) -> Result<Option<CellsState>, D::Error> {
        let Some(past) = &self.past else {
            return Ok(None);
        };
        let entries = self.key.entries();
        Ok(Some(CellsState {
            key: self.key,
            past: past.clone(),
            entries: device.get(&self.before.entries, entries)?,
            counts: device.get(&self.before.counts, entries * COUNT_WORDS as usize)?,
        }))
    }

    /// A frame before, from the host.
    pub(crate) fn resume<D: Device<Memory = M>>(
        device: &D,
        state: CellsState,
    ) -> Result<Self, D::Error> {
        let before = Counts {
            entries: device.holding("tile entries", &state.entries)?,
            counts: device.holding("counts of cells", &state.counts)?,
        };
        let made = Self::new(device, state.key, before)?;
        Ok(Self {
            past: Some(state.past),
            ..made
        })
    }

    /// What tiles read of it.
    pub(crate) fn reading(&self) -> Reading<'_, M> {
        let entries = (self.params.tiles * ENTRIES) as usize;
        let words = entries * VISIBILITY_WORDS as usize + WORTHS as usize;
        Reading {
            params: &self.params,
            entries: M::slice(&self.now.entries, 0..entries),
            visibility: M::slice(&self.visibility, 0..words),
        }
    }
}

/// What a tile reads of what is known of the frame.
pub(crate) struct Reading<'a, M: Memory> {
    params: &'a CellParams,
    entries: M::Slice<'a, TileEntry>,
    visibility: M::Slice<'a, u32>,
}

impl<M: Memory> Clone for Reading<'_, M> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<M: Memory> Copy for Reading<'_, M> {}

impl<'a, M: Memory> Reading<'a, M> {
    /// The same for a shorter time: [`Memory::shorten`].
    pub(crate) fn shorten<'b>(self) -> Reading<'b, M>
    where
        'a: 'b,
    {
        Reading {
            params: self.params,
            entries: M::shorten(self.entries),
            visibility: M::shorten(self.visibility),
        }
    }

    /// Runs the passes of a tile of `rays` rays. `points` takes their hits.
    pub(super) fn shade<E: Executor<Memory = M>>(
        self,
        executor: &mut E,
        inputs: Inputs<'_, M>,
        mut points: M::Chunks<'_, SeenPoint>,
        rays: u32,
        out: SamplesOut<'_, M>,
    ) -> Result<(), E::Error> {
        let Inputs { frame, env, scene } = inputs;
        let Reading {
            params: cells,
            entries,
            visibility,
        } = self;
        let pass = SeeInTile {
            frame,
            cells,
            scene: scene.shorten(),
            entries: M::shorten(entries),
            out: M::reborrow(&mut points),
        };
        executor.run(pass, 0..rays)?;
        let (per_pixel, pixels) = per_pixel(frame, rays);
        let points = M::in_chunks_of(M::shorten_chunks(points), per_pixel);
        let (env, scene) = (env.shorten(), scene.shorten());
        let visibility = M::shorten(visibility);
        match out {
            SamplesOut::Flat(out) => executor.run(
                ShadeCells {
                    frame,
                    cells,
                    env,
                    scene,
                    visibility,
                    points,
                    samples: M::in_chunks_of(M::shorten_chunks(out), per_pixel),
                },
                0..pixels,
            ),
            SamplesOut::Layered(out) => executor.run(
                ShadeCellsLayers {
                    frame,
                    cells,
                    env,
                    scene,
                    visibility,
                    points,
                    samples: M::in_chunks_of(M::shorten_chunks(out), per_pixel),
                },
                0..pixels,
            ),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glimt_probe::rotate::cos_sin_degrees;

    #[test]
    fn at_most_24_bytes_of_a_pixel_are_kept() {
        let size = UVec2::new(1920, 1080);
        let bytes = kept_bytes(size).all as f64 / f64::from(size.element_product());
        assert!(bytes <= 24.0, "{bytes}");
    }

    #[test]
    fn columns_turn_with_the_light() {
        let columns = |before, now| turned_columns(cos_sin_degrees(before), cos_sin_degrees(now));
        assert_eq!([columns(0.0, 0.0), columns(0.0, 5.0)], [0, 0]);
        assert_eq!([columns(0.0, 11.25), columns(350.0, 12.5)], [1, 2]);
        assert_eq!(columns(90.0, 0.0), 24);
    }
}
