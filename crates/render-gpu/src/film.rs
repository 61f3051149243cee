//! Host file: pass 2 of rendering: from what a tile's rays show to its pixels, on any executor.

use std::ops::Range;

use glam::Vec4;
use glimt_executor::{Device, Executor, Memory};

use crate::generated::passes::{
    CompositeAlone, CompositeOverPlate, DisplayOverPlate, EnvironmentArg, Reconstruct,
    ReconstructLayers, Tonemap,
};
use crate::kernels::composite::PlatePixel;
use crate::kernels::frame::FrameParams;
use crate::kernels::layers::{LayerSample, PixelLayers};

/// What the rays of a tile show.
#[derive(Debug)]
pub(crate) enum Samples<M: Memory> {
    /// Radiance with alpha.
    Flat(M::Buffer<Vec4>),
    /// Objects and catchers apart.
    Layered(M::Buffer<LayerSample>),
}

/// [`Samples`], to be written.
pub(crate) enum SamplesOut<'a, M: Memory> {
    /// See [`Samples::Flat`].
    Flat(M::Chunks<'a, Vec4>),
    /// See [`Samples::Layered`].
    Layered(M::Chunks<'a, LayerSample>),
}

impl<M: Memory> Samples<M> {
    /// Those of the first `rays` rays.
    pub(crate) fn out(&mut self, rays: u32) -> SamplesOut<'_, M> {
        let rays = 0..rays as usize;
        match self {
            Self::Flat(samples) => SamplesOut::Flat(M::chunks(samples, rays, 1)),
            Self::Layered(samples) => SamplesOut::Layered(M::chunks(samples, rays, 1)),
        }
    }
}

/// What pixels are computed in: a tile's, a band's or all of an image's.
pub(crate) struct Pixels<M: Memory> {
    /// Of frames in layers; of one pixel for others.
    pub(crate) layers: M::Buffer<PixelLayers>,
    /// Linear values.
    pub(crate) linear: M::Buffer<Vec4>,
    /// Red, green, blue and alpha of the display, from the lowest byte on.
    pub(crate) display: M::Buffer<u32>,
}

impl<M: Memory> Pixels<M> {
    /// Room for so many pixels, and for the layers of `layered`.
    pub(crate) fn new<D: Device<Memory = M>>(
        device: &D,
        pixels: usize,
        layered: usize,
    ) -> Result<Self, D::Error> {
        Ok(Self {
            layers: device.zeroed("layers", layered)?,
            linear: device.zeroed("linear", pixels)?,
            display: device.zeroed("display", pixels)?,
        })
    }

    /// Makes the pixels of the tile that `frame` begins, `count` of them, from what their rays show.
    pub(crate) fn develop<E: Executor<Memory = M>>(
        &mut self,
        executor: &mut E,
        frame: &FrameParams,
        env: EnvironmentArg<'_, M>,
        samples: &Samples<M>,
        plate: Option<M::Slice<'_, PlatePixel>>,
        count: u32,
    ) -> Result<(), E::Error> {
        let (pixels, rays) = (count as usize, (count * frame.rays_per_pixel) as usize);
        match samples {
            Samples::Flat(samples) => {
                let pass = Reconstruct {
                    frame,
                    samples: M::slice(samples, 0..rays),
                    out: M::chunks(&mut self.linear, 0..pixels, 1),
                };
                executor.run(pass, 0..count)?;
                self.tonemap(executor, frame, 0..pixels)
            }
            Samples::Layered(samples) => {
                let pass = ReconstructLayers {
                    frame,
                    env: env.shorten(),
                    samples: M::slice(samples, 0..rays),
                    out: M::chunks(&mut self.layers, 0..pixels, 1),
                };
                executor.run(pass, 0..count)?;
                self.composite(executor, frame, plate, 0..pixels, 0..pixels)
            }
        }
    }

    /// Makes pixels `part` of the layers `layers`, over their part of a plate or before the background.
    pub(crate) fn composite<E: Executor<Memory = M>>(
        &mut self,
        executor: &mut E,
        frame: &FrameParams,
        plate: Option<M::Slice<'_, PlatePixel>>,
        layers: Range<usize>,
        part: Range<usize>,
    ) -> Result<(), E::Error> {
        let count = part.len() as u32;
        let layers = M::slice(&self.layers, layers);
        let Some(plate) = plate else {
            let out = M::chunks(&mut self.linear, part.clone(), 1);
            let pass = CompositeAlone { frame, layers, out };
            executor.run(pass, 0..count)?;
            return self.tonemap(executor, frame, part);
        };
        let pass = CompositeOverPlate {
            frame,
            layers,
            plate: M::shorten(plate),
            out: M::chunks(&mut self.linear, part.clone(), 1),
        };
        executor.run(pass, 0..count)?;
        let pass = DisplayOverPlate {
            frame,
            layers,
            plate: M::shorten(plate),
            out: M::chunks(&mut self.display, part, 1),
        };
        executor.run(pass, 0..count)
    }

    fn tonemap<E: Executor<Memory = M>>(
        &mut self,
        executor: &mut E,
        frame: &FrameParams,
        part: Range<usize>,
    ) -> Result<(), E::Error> {
        let count = part.len() as u32;
        let pass = Tonemap {
            frame,
            linear: M::slice(&self.linear, part.clone()),
            out: M::chunks(&mut self.display, part, 1),
        };
        executor.run(pass, 0..count)
    }
}
