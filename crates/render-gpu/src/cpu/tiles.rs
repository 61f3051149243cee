//! Host file: an image in tiles, which threads make one at a time: pass 1 as the renderer has it, then pass 2.

use std::sync::atomic::{AtomicUsize, Ordering};

use glam::Vec4;
use glimt_executor::{Chunks, Cpu, Device, Host, HostError, HostMemory, Serial};
use rayon::prelude::*;

use crate::film::{Pixels, Samples};
use crate::generated::passes::{EnvironmentArg, SceneArg};
use crate::kernels::composite::PlatePixel;
use crate::kernels::environment::Environment;
use crate::kernels::frame::FrameParams;
use crate::kernels::group_health::GroupHealth;
use crate::kernels::layers::PixelLayers;
use crate::methods::smc::Own;
use crate::methods::{Method, Points};
use crate::prepare::plate::Plate;
use crate::prepare::render::{Diagnostics, FrameImage, RenderSettings};
use crate::prepare::scene_build::SceneBuffers;

/// Pixels of a tile, where nothing else is asked for.
pub(super) const PIXELS: usize = 128;

/// What the renderers on the CPU call themselves.
pub(super) fn name() -> String {
    format!("CPU, {} threads", rayon::current_num_threads())
}

/// The image that tiles are put into; what is not asked for is empty.
pub(super) struct Image {
    linear: Vec<Vec4>,
    display: Vec<[u8; 4]>,
    layers: Vec<PixelLayers>,
    pub(super) health: Vec<GroupHealth>,
}

impl Image {
    pub(super) fn new(settings: &RenderSettings) -> Result<Self, HostError> {
        let pixels = settings.size.element_product() as usize;
        Ok(Self {
            linear: Cpu.zeroed("linear", pixels)?,
            display: Cpu.zeroed("display", pixels)?,
            layers: match settings.layers {
                true => Cpu.zeroed("layers", pixels)?,
                false => Vec::new(),
            },
            health: match settings.diagnostics && settings.method.takes_groups() {
                true => Cpu.zeroed("diagnostics", pixels)?,
                false => Vec::new(),
            },
        })
    }

    pub(super) fn finish(
        self,
        settings: &RenderSettings,
        diagnostics: Option<Diagnostics>,
    ) -> FrameImage {
        FrameImage {
            size: settings.size,
            linear: self.linear,
            display: self.display,
            layers: settings.layers.then_some(self.layers),
            diagnostics,
        }
    }
}

/// A frame to render.
pub(super) struct Job<'a> {
    pub(super) env: EnvironmentArg<'a, Host>,
    pub(super) scene: SceneArg<'a, Host>,
    whole: FrameParams,
    plate: Option<&'a [PlatePixel]>,
    method: Method,
    in_layers: bool,
}

/// A tile whose rays are to be followed.
pub(super) struct Tile<'a> {
    /// Where it begins.
    pub(super) frame: FrameParams,
    /// Its pixels.
    pub(super) pixels: u32,
    /// Its rays.
    pub(super) rays: u32,
    /// What they keep, by a method that keeps them.
    pub(super) own: Option<Own<'a, Host>>,
    /// Where the passes of its method meet.
    pub(super) points: &'a mut Points<Host>,
}

/// What is written of a tile.
struct Part<'a> {
    first: usize,
    linear: &'a mut [Vec4],
    display: &'a mut [[u8; 4]],
    /// Empty where layers are not asked for.
    layers: &'a mut [PixelLayers],
    /// Empty where it is not asked for.
    health: &'a mut [GroupHealth],
    own: Option<Own<'a, Host>>,
}

/// What a thread computes its tiles in.
struct Scratch {
    samples: Samples<Host>,
    points: Points<Host>,
    pixels: Pixels<Host>,
}

impl Scratch {
    fn new(
        method: &Method,
        pixels: usize,
        rays: usize,
        in_layers: bool,
    ) -> Result<Self, HostError> {
        Ok(Self {
            points: Points::new(&Cpu, method, rays)?,
            samples: match in_layers {
                false => Samples::Flat(Cpu.zeroed("samples", rays)?),
                true => Samples::Layered(Cpu.zeroed("samples", rays)?),
            },
            pixels: Pixels::new(&Cpu, pixels, if in_layers { pixels } else { 1 })?,
        })
    }
}

/// Finds what the rays of a tile show.
type Shade<'s> = dyn Fn(Tile<'_>, &mut Samples<Host>) -> Result<(), HostError> + Sync + 's;

impl<'a> Job<'a> {
    pub(super) fn new(
        whole: FrameParams,
        env: Environment<'a>,
        scene: &'a SceneBuffers,
        plate: Option<&'a Plate>,
        settings: &RenderSettings,
    ) -> Self {
        Self {
            env: env.into(),
            scene: scene.view().into(),
            whole,
            plate: plate.map(Plate::pixels),
            method: settings.method,
            in_layers: settings.in_layers(scene, plate),
        }
    }

    /// Renders all tiles. `own` is what all rays keep.
    pub(super) fn render(
        &self,
        tile_pixels: usize,
        own: Option<Own<'_, Host>>,
        image: &mut Image,
        progress: &(dyn Fn(f32) + Sync),
        shade: &Shade<'_>,
    ) -> Result<(), HostError> {
        let rays_per_pixel = self.whole.rays_per_pixel as usize;
        let pixels = image.linear.len();
        // A tile's rays are numbered in 32 bits.
        let most = u32::MAX as usize / rays_per_pixel;
        let tile_pixels = tile_pixels.clamp(1, most).min(pixels);
        let tile_rays = tile_pixels * rays_per_pixel;
        let parts = image.parts(tile_pixels, tile_rays, own.map(Own::shorten));
        let done = AtomicUsize::new(0);
        let scratch = || Scratch::new(&self.method, tile_pixels, tile_rays, self.in_layers);
        parts
            .into_par_iter()
            .try_for_each_init(scratch, |scratch, part| {
                let scratch = scratch.as_mut().map_err(|error| error.clone())?;
                let count = part.linear.len();
                self.tile(scratch, part, shade)?;
                let done = done.fetch_add(count, Ordering::Relaxed) + count;
                progress(done as f32 / pixels as f32);
                Ok(())
            })
    }

    fn tile(
        &self,
        scratch: &mut Scratch,
        part: Part<'_>,
        shade: &Shade<'_>,
    ) -> Result<(), HostError> {
        let frame = FrameParams {
            first_pixel: part.first as u32,
            ..self.whole
        };
        let count = part.linear.len();
        let Scratch {
            samples,
            points,
            pixels,
        } = scratch;
        let tile = Tile {
            frame,
            pixels: count as u32,
            rays: count as u32 * frame.rays_per_pixel,
            own: part.own.map(Own::shorten),
            points,
        };
        shade(tile, samples)?;
        if !part.health.is_empty() {
            let out = Chunks::new(part.health, 1);
            points.diagnose(&mut Serial, &frame, out, count as u32)?;
        }
        let plate = self.plate.map(|plate| &plate[part.first..][..count]);
        let env = self.env.shorten();
        pixels.develop(&mut Serial, &frame, env, samples, plate, count as u32)?;
        part.linear.copy_from_slice(&pixels.linear[..count]);
        for (code, own) in part.display.iter_mut().zip(&pixels.display) {
            *code = own.to_le_bytes();
        }
        if !part.layers.is_empty() {
            part.layers.copy_from_slice(&pixels.layers[..count]);
        }
        Ok(())
    }
}

impl Image {
    /// The tiles, each with what its rays keep.
    fn parts<'a>(
        &'a mut self,
        tile_pixels: usize,
        tile_rays: usize,
        own: Option<Own<'a, Host>>,
    ) -> Vec<Part<'a>> {
        let mut layers = self.layers.chunks_mut(tile_pixels);
        let mut health = self.health.chunks_mut(tile_pixels);
        let mut rest = own;
        let lists = self
            .linear
            .chunks_mut(tile_pixels)
            .zip(self.display.chunks_mut(tile_pixels));
        (0..)
            .step_by(tile_pixels)
            .zip(lists)
            .map(|(first, (linear, display))| {
                let own = rest.take().map(|own| {
                    let (tile, others) = own.split_at(tile_rays);
                    rest = Some(others);
                    tile
                });
                Part {
                    first,
                    linear,
                    display,
                    layers: layers.next().unwrap_or_default(),
                    health: health.next().unwrap_or_default(),
                    own,
                }
            })
            .collect()
    }
}

impl<'a> Own<'a, Host> {
    /// The same for a shorter time.
    pub(super) fn shorten<'b>(self) -> Own<'b, Host>
    where
        'a: 'b,
    {
        Own {
            states: self.states,
            particles: self.particles,
        }
    }

    /// What the first `rays` rays keep, and the others.
    fn split_at(self, rays: usize) -> (Self, Self) {
        let (states, other_states) = Host::split_at(self.states, rays);
        let (particles, other_particles) = Host::split_at(self.particles, rays);
        let others = Self {
            states: other_states,
            particles: other_particles,
        };
        (Self { states, particles }, others)
    }
}
