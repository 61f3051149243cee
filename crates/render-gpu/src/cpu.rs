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
        let in_layers = plate.is_some() || settings.layers || scene.has_catcher();
        let (env, scene) = (env.view(), scene.view());
        // A tile's rays are numbered in 32 bits.
        let most = (u32::MAX / whole.rays_per_pixel) as usize;
        let tile_pixels = self.tile_pixels.clamp(1, most);
        let pixels = (whole.width * whole.height) as usize;
        let mut linear = filled(Vec4::ZERO, pixels)?;
        let mut display = filled([0; 4], pixels)?;
        let kept = if settings.layers { pixels } else { 0 };
        let mut layers = filled(PixelLayers::zeroed(), kept)?;
        let (done, pixels_of_all) = (AtomicUsize::new(0), pixels);
        let tiles = linear
            .par_chunks_mut(tile_pixels)
            .zip(display.par_chunks_mut(tile_pixels))
            .enumerate();
        let finish = |pixels: usize| {
            let done = done.fetch_add(pixels, Ordering::Relaxed) + pixels;
            progress(done as f32 / pixels_of_all as f32);
        };
        if in_layers {
            // Where the layers are not kept, a tile makes room for its own.
            let keep: Vec<&mut [PixelLayers]> = match settings.layers {
                true => layers.chunks_mut(tile_pixels).collect(),
                false => Vec::new(),
            };
            let work = Layered {
                method: settings.method,
                whole,
                env,
                scene,
                plate: plate.map(Plate::pixels),
            };
            let keep = keep
                .into_iter()
                .map(Some)
                .chain(std::iter::repeat_with(|| None));
            let keep: Vec<_> = keep.take(pixels.div_ceil(tile_pixels)).collect();
            tiles
                .zip(keep)
                .for_each_init(Scratch::default, |scratch, ((tile, out), keep)| {
                    let (linear, display) = out;
                    work.tile(tile * tile_pixels, scratch, linear, display);
                    if let Some(keep) = keep {
                        keep.copy_from_slice(&scratch.layers);
                    }
                    finish(linear.len());
                });
        } else {
            let shade = match settings.method {
                Method::Mis => shade_mis,
            };
            tiles.for_each_init(Vec::new, |samples, (tile, (linear, display))| {
                let frame = FrameParams {
                    first_pixel: (tile * tile_pixels) as u32,
                    ..whole
                };
                let rays = linear.len() as u32 * frame.rays_per_pixel;
                samples.clear();
                samples.extend((0..rays).map(|ray| shade(ray, &frame, env, scene)));
                for (pixel, value) in (0..).zip(linear.iter_mut()) {
                    *value = reconstruct(pixel, &frame, samples);
                }
                for (pixel, value) in (0..).zip(display.iter_mut()) {
                    *value = tonemap(pixel, &frame, linear).to_le_bytes();
                }
                finish(linear.len());
            });
        }
        Ok(FrameImage {
            size: settings.size,
            linear,
            display,
            layers: settings.layers.then_some(layers),
        })
    }
}

/// A frame that is made in layers.
struct Layered<'a> {
    method: Method,
    whole: FrameParams,
    env: Environment<'a>,
    scene: Scene<'a>,
    plate: Option<&'a [PlatePixel]>,
}

/// What a thread computes its tiles in.
#[derive(Default)]
struct Scratch {
    samples: Vec<LayerSample>,
    layers: Vec<PixelLayers>,
}

impl Layered<'_> {
    /// The tile that begins at pixel `first`; its layers stay in the scratch.
    fn tile(
        &self,
        first: usize,
        scratch: &mut Scratch,
        linear: &mut [Vec4],
        display: &mut [[u8; 4]],
    ) {
        let shade = match self.method {
            Method::Mis => shade_mis_layers,
        };
        let frame = &FrameParams {
            first_pixel: first as u32,
            ..self.whole
        };
        let pixels = linear.len() as u32;
        let Scratch { samples, layers } = scratch;
        samples.clear();
        samples.extend(
            (0..pixels * frame.rays_per_pixel).map(|ray| shade(ray, frame, self.env, self.scene)),
        );
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
