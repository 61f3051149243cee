//! Host file: the CPU executor: the kernels, run by rayon.

use rayon::prelude::*;
use std::sync::atomic::{AtomicUsize, Ordering};

use bytemuck::Zeroable;
use glam::Vec4;

use crate::host::env::PreparedEnv;
use crate::host::plate::Plate;
use crate::host::render::{FrameImage, Method, RenderError, RenderSettings, Renderer};
use crate::host::scene_build::SceneBuffers;
use crate::kernels::composite::{
    PlatePixel, composite_alone, composite_over_plate, display_over_plate,
};
use crate::kernels::environment::Environment;
use crate::kernels::film::{reconstruct, tonemap};
use crate::kernels::frame::FrameParams;
use crate::kernels::layers::{LayerSample, PixelLayers, reconstruct_layers};
use crate::kernels::scene::Scene;
use crate::kernels::shade::{shade_mis, shade_mis_layers};

/// Renders on all of rayon's threads.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CpuRenderer {
    /// Pixels in a tile, a run of the image's pixels. It changes no bit of the image, only how work is shared out.
    pub tile_pixels: usize,
}

impl Default for CpuRenderer {
    fn default() -> Self {
        Self { tile_pixels: 128 }
    }
}

impl Renderer for CpuRenderer {
    fn name(&self) -> String {
        format!("CPU, {} threads", rayon::current_num_threads())
    }

    fn render_over(
        &mut self,
        scene: &SceneBuffers,
        env: &PreparedEnv,
        plate: Option<&Plate>,
        settings: &RenderSettings,
        progress: &(dyn Fn(f32) + Sync),
    ) -> Result<FrameImage, RenderError> {
        let whole = settings.frame_params_over(plate)?;
        let in_layers = settings.in_layers(scene, plate);
        let work = Work {
            method: settings.method,
            whole,
            env: env.view(),
            scene: scene.view(),
            plate: plate.map(Plate::pixels),
        };
        // A tile's rays are numbered in 32 bits.
        let most = (u32::MAX / whole.rays_per_pixel) as usize;
        let tile_pixels = self.tile_pixels.clamp(1, most);
        let pixels = (whole.width * whole.height) as usize;
        let mut linear = filled(Vec4::ZERO, pixels)?;
        let mut display = filled([0; 4], pixels)?;
        let kept = if settings.layers { pixels } else { 0 };
        let mut layers = filled(PixelLayers::zeroed(), kept)?;
        // Where the layers are not kept, a tile's are gone when it is done.
        let mut kept = layers.chunks_mut(tile_pixels);
        let kept: Vec<_> = (0..pixels.div_ceil(tile_pixels))
            .map(|_| kept.next())
            .collect();
        let done = AtomicUsize::new(0);
        linear
            .par_chunks_mut(tile_pixels)
            .zip(display.par_chunks_mut(tile_pixels))
            .zip(kept)
            .enumerate()
            .for_each_init(
                Scratch::default,
                |scratch, (tile, ((linear, display), kept))| {
                    let first = tile * tile_pixels;
                    if in_layers {
                        work.layered_tile(first, scratch, linear, display);
                    } else {
                        work.tile(first, scratch, linear, display);
                    }
                    if let Some(kept) = kept {
                        kept.copy_from_slice(&scratch.layers);
                    }
                    let done = done.fetch_add(linear.len(), Ordering::Relaxed) + linear.len();
                    progress(done as f32 / pixels as f32);
                },
            );
        Ok(FrameImage {
            size: settings.size,
            linear,
            display,
            layers: settings.layers.then_some(layers),
        })
    }
}

/// A frame to render.
struct Work<'a> {
    method: Method,
    whole: FrameParams,
    env: Environment<'a>,
    scene: Scene<'a>,
    plate: Option<&'a [PlatePixel]>,
}

/// What a thread computes its tiles in.
#[derive(Default)]
struct Scratch {
    rays: Vec<Vec4>,
    samples: Vec<LayerSample>,
    layers: Vec<PixelLayers>,
}

impl Work<'_> {
    fn params(&self, first: usize) -> FrameParams {
        FrameParams {
            first_pixel: first as u32,
            ..self.whole
        }
    }

    /// The tile that begins at pixel `first`.
    fn tile(
        &self,
        first: usize,
        scratch: &mut Scratch,
        linear: &mut [Vec4],
        display: &mut [[u8; 4]],
    ) {
        let shade = match self.method {
            Method::Mis => shade_mis,
        };
        let frame = &self.params(first);
        let count = linear.len() as u32 * frame.rays_per_pixel;
        let samples = &mut scratch.rays;
        samples.clear();
        samples.extend((0..count).map(|ray| shade(ray, frame, self.env, self.scene)));
        for (pixel, value) in (0..).zip(linear.iter_mut()) {
            *value = reconstruct(pixel, frame, samples);
        }
        for (pixel, value) in (0..).zip(display) {
            *value = tonemap(pixel, frame, linear).to_le_bytes();
        }
    }

    /// The same by way of its layers, which stay in the scratch.
    fn layered_tile(
        &self,
        first: usize,
        scratch: &mut Scratch,
        linear: &mut [Vec4],
        display: &mut [[u8; 4]],
    ) {
        let shade = match self.method {
            Method::Mis => shade_mis_layers,
        };
        let frame = &self.params(first);
        let pixels = linear.len() as u32;
        let count = pixels * frame.rays_per_pixel;
        let Scratch {
            samples, layers, ..
        } = scratch;
        samples.clear();
        samples.extend((0..count).map(|ray| shade(ray, frame, self.env, self.scene)));
        layers.clear();
        layers.extend((0..pixels).map(|pixel| reconstruct_layers(pixel, frame, self.env, samples)));
        let plate = self.plate.map(|plate| &plate[first..first + linear.len()]);
        for (pixel, value) in (0..).zip(linear.iter_mut()) {
            *value = match plate {
                Some(plate) => composite_over_plate(pixel, frame, layers, plate),
                None => composite_alone(pixel, frame, layers),
            };
        }
        for (pixel, value) in (0..).zip(display) {
            let code = match plate {
                Some(plate) => display_over_plate(pixel, frame, layers, plate),
                None => tonemap(pixel, frame, linear),
            };
            *value = code.to_le_bytes();
        }
    }
}

/// `len` times `value`, or the error of an allocation that was refused.
fn filled<T: Clone>(value: T, len: usize) -> Result<Vec<T>, RenderError> {
    let mut list = Vec::new();
    list.try_reserve_exact(len)
        .map_err(|e| RenderError::Device(Box::new(e)))?;
    list.resize(len, value);
    Ok(list)
}
