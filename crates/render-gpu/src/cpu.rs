//! Host file: the CPU executor: the kernels, run by rayon.

use rayon::prelude::*;
use std::sync::atomic::{AtomicUsize, Ordering};

use glam::Vec4;

use crate::host::env::PreparedEnv;
use crate::host::render::{FrameImage, Method, RenderError, RenderSettings, Renderer};
use crate::host::scene_build::SceneBuffers;
use crate::kernels::film::{reconstruct, tonemap};
use crate::kernels::frame::FrameParams;
use crate::kernels::shade::shade_mis;

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

    fn render_frame(
        &mut self,
        scene: &SceneBuffers,
        env: &PreparedEnv,
        settings: &RenderSettings,
        progress: &(dyn Fn(f32) + Sync),
    ) -> Result<FrameImage, RenderError> {
        let whole = settings.frame_params()?;
        let (env, scene) = (env.view(), scene.view());
        let shade = match settings.method {
            Method::Mis => shade_mis,
        };
        // A tile's rays are numbered in 32 bits.
        let most = (u32::MAX / whole.rays_per_pixel) as usize;
        let tile_pixels = self.tile_pixels.clamp(1, most);
        let pixels = (whole.width * whole.height) as usize;
        let mut linear = filled(Vec4::ZERO, pixels)?;
        let mut display = filled([0; 4], pixels)?;
        let done = AtomicUsize::new(0);
        linear
            .par_chunks_mut(tile_pixels)
            .zip(display.par_chunks_mut(tile_pixels))
            .enumerate()
            .for_each_init(Vec::new, |samples, (tile, (linear, display))| {
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
                let done = done.fetch_add(linear.len(), Ordering::Relaxed) + linear.len();
                progress(done as f32 / pixels as f32);
            });
        Ok(FrameImage {
            size: settings.size,
            linear,
            display,
        })
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
