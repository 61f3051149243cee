//! Host file: a control variate over cells of the light, and what it knows of a frame before it renders it, on any device.

use glam::UVec2;
use glimt_executor::gpu::Gpu;
use glimt_executor::{Device, Entry, Executor, Memory, Pass};

use super::{Inputs, per_pixel};
use crate::film::SamplesOut;
use crate::generated::passes::{
    AddWorths, Expect, Pilot, Scout, SeeInTile, ShadeCells, ShadeCellsLayers, Worth,
};
use crate::kernels::cell_state::{
    COUNT_WORDS, ENTRIES, TILE_HEIGHT, TILE_WIDTH, TileEntry, VISIBILITY_WORDS, WORTHS,
};
use crate::kernels::scout::CellParams;
use crate::kernels::seen::SeenPoint;
use crate::prepare::render::RenderSettings;
use crate::settings::{any, between, settings};

settings! {
    /// Light cells: what 512 cells of the light send to a surface is summed up, and rays correct the sum. They look where it may be
    /// wrong: where the visibility of a cell, which other rays have counted, is neither 0 nor 1.
    Cells in "cells" {
        /// Shadow rays of a pixel, on average over the image.
        rays: u32 = 32, between(1, 65_536), "32 is usual";
        /// Pilot rays, as a share of those: they count visibilities before the frame is rendered.
        pilot: f32 = 0.2, between(0.0, 1.0), "0.2 is usual";
        /// Whether rays go where they are worth most, and not to all pixels alike.
        adaptive: bool = true, any, "";
    }
}

impl Cells {
    /// What kernels read for an image of this size.
    #[must_use]
    pub fn params(&self, size: UVec2) -> CellParams {
        let tiles = tiles(size);
        CellParams {
            rays: self.rays as f32,
            pilot: self.pilot,
            tiles_across: tiles.x,
            tiles: tiles.element_product(),
            is_adaptive: self.adaptive.into(),
            unused_a: 0,
            unused_b: 0,
            unused_c: 0,
        }
    }

    /// Counts that the cost of a ray depends on.
    pub(super) fn cost(&self) -> [u32; 3] {
        [self.rays, (self.pilot * 1000.0) as u32, 0]
    }
}

/// Tiles of an image, across and down.
fn tiles(size: UVec2) -> UVec2 {
    UVec2::new(size.x.div_ceil(TILE_WIDTH), size.y.div_ceil(TILE_HEIGHT))
}

/// The entries of its passes.
pub(super) fn entries() -> Vec<&'static Entry> {
    vec![
        Scout::<Gpu>::entry(),
        Pilot::<Gpu>::entry(),
        Expect::<Gpu>::entry(),
        Worth::<Gpu>::entry(),
        AddWorths::<Gpu>::entry(),
        SeeInTile::<Gpu>::entry(),
        ShadeCells::<Gpu>::entry(),
        ShadeCellsLayers::<Gpu>::entry(),
    ]
}

/// What is known of a frame before it is rendered.
pub(crate) struct Known<M: Memory> {
    params: CellParams,
    entries: M::Buffer<TileEntry>,
    counts: M::Buffer<u32>,
    /// Of all entries, then the parts of the sum of what rays are worth.
    visibility: M::Buffer<u32>,
    worths: M::Buffer<f32>,
}

impl<M: Memory> std::fmt::Debug for Known<M> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Known")
            .field("params", &self.params)
            .finish_non_exhaustive()
    }
}

impl<M: Memory> Known<M> {
    /// Room for an image.
    fn room<D: Device<Memory = M>>(
        device: &D,
        settings: &RenderSettings,
        own: &Cells,
    ) -> Result<Self, D::Error> {
        let params = own.params(settings.size);
        let tiles = params.tiles as usize;
        let entries = tiles * ENTRIES as usize;
        let words = entries * VISIBILITY_WORDS as usize;
        Ok(Self {
            params,
            entries: device.zeroed("tile entries", entries)?,
            counts: device.zeroed("counts of cells", entries * COUNT_WORDS as usize)?,
            visibility: device.zeroed("visibilities", words + WORTHS as usize)?,
            worths: device.zeroed("worths", tiles)?,
        })
    }

    /// Sends out scouts and pilots of the whole image, which `inputs` begin.
    pub(crate) fn begin<D: Device<Memory = M>, E: Executor<Memory = M, Error = D::Error>>(
        device: &D,
        executor: &mut E,
        inputs: Inputs<'_, M>,
        settings: &RenderSettings,
        own: &Cells,
    ) -> Result<Self, D::Error> {
        let mut made = Self::room(device, settings, own)?;
        let Inputs { frame, env, scene } = inputs;
        let (cells, tiles) = (&made.params, made.params.tiles);
        let entries = (tiles * ENTRIES) as usize;
        let pass = Scout {
            frame,
            cells,
            scene: scene.shorten(),
            entries: M::chunks(&mut made.entries, 0..entries, ENTRIES),
        };
        executor.run(pass, 0..tiles)?;
        let words = entries * COUNT_WORDS as usize;
        let pass = Pilot {
            frame,
            cells,
            env: env.shorten(),
            scene: scene.shorten(),
            entries: M::slice(&made.entries, 0..entries),
            counts: M::chunks(&mut made.counts, 0..words, ENTRIES * COUNT_WORDS),
        };
        executor.run(pass, 0..tiles)?;
        let visibilities = entries * VISIBILITY_WORDS as usize;
        let per_tile = ENTRIES * VISIBILITY_WORDS;
        let pass = Expect {
            cells,
            entries: M::slice(&made.entries, 0..entries),
            counts: M::slice(&made.counts, 0..words),
            visibility: M::chunks(&mut made.visibility, 0..visibilities, per_tile),
        };
        executor.run(pass, 0..tiles)?;
        if !own.adaptive {
            return Ok(made);
        }
        let pass = Worth {
            env: env.shorten(),
            entries: M::slice(&made.entries, 0..entries),
            visibility: M::slice(&made.visibility, 0..visibilities),
            out: M::chunks(&mut made.worths, 0..tiles as usize, 1),
        };
        executor.run(pass, 0..tiles)?;
        let behind = visibilities..visibilities + WORTHS as usize;
        let pass = AddWorths {
            cells,
            parts: WORTHS,
            worths: M::slice(&made.worths, 0..tiles as usize),
            out: M::chunks(&mut made.visibility, behind, 1),
        };
        executor.run(pass, 0..WORTHS)?;
        Ok(made)
    }

    /// What tiles read of it.
    pub(crate) fn reading(&self) -> Reading<'_, M> {
        let entries = (self.params.tiles * ENTRIES) as usize;
        let words = entries * VISIBILITY_WORDS as usize + WORTHS as usize;
        Reading {
            params: &self.params,
            entries: M::slice(&self.entries, 0..entries),
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

impl<M: Memory> Reading<'_, M> {
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
