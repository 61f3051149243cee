//! Host file: frames on the CPU: tiles are shared out among rayon's threads, and each thread runs the passes of its tile.

use std::sync::atomic::{AtomicUsize, Ordering};

use glam::Vec4;
use glimt_executor::{Chunks, Cpu, Device, Executor, Host, HostError, HostMemory, Rayon, Serial};
use rayon::prelude::*;

use crate::film::{Pixels, Samples};
use crate::generated::passes::{EnvironmentArg, SceneArg, VertexLight};
use crate::host::env::PreparedEnv;
use crate::host::light_sh::LightSh;
use crate::host::plate::Plate;
use crate::host::render::{
    FrameImage, Method, RenderError, RenderSettings, Renderer, SettingsError,
};
use crate::host::scene_build::SceneBuffers;
use crate::host::smc_state::{PastFrame, SmcState};
use crate::kernels::composite::PlatePixel;
use crate::kernels::frame::FrameParams;
use crate::kernels::layers::PixelLayers;
use crate::kernels::past::PastView;
use crate::kernels::prt::{self, Surface, shade_prt, shade_prt_layers};
use crate::kernels::smc_point::SmcPoint;
use crate::methods::smc::{Following, Own, Reading};
use crate::methods::{Inputs, TileMethod};

/// Renders on all of rayon's threads.
#[derive(Debug)]
pub struct CpuRenderer {
    /// Pixels in a tile, a run of the image's pixels. It changes no bit of the image, only how work is shared out.
    pub tile_pixels: usize,
    /// What the sequential sampler continues from.
    smc: Option<Following<Host>>,
    /// The light of frames by precomputed transfer.
    light: LightSh,
}

impl Default for CpuRenderer {
    fn default() -> Self {
        Self::with_tiles(128)
    }
}

impl CpuRenderer {
    /// A renderer with tiles of so many pixels.
    #[must_use]
    pub fn with_tiles(tile_pixels: usize) -> Self {
        Self {
            tile_pixels,
            smc: None,
            light: LightSh::default(),
        }
    }

    /// Light at the vertices of a scene that has a transfer.
    fn vertex_lights(
        &mut self,
        scene: &SceneBuffers,
        env: &PreparedEnv,
        settings: &RenderSettings,
    ) -> Result<Vec<prt::VertexLight>, RenderError> {
        let known = scene.transfer().ok_or(SettingsError::NoTransfer)?;
        let transfer = known.transfer();
        let light = self.light.project(env, transfer.bands, &settings.prt)?;
        let vertices = known.vertices();
        let mut lights = Cpu
            .zeroed("light at vertices", vertices as usize)
            .map_err(RenderError::device)?;
        let pass = VertexLight::<Host> {
            coefficients: transfer.coefficients() as u32,
            shadows: u32::from(settings.prt.shadows),
            light: &light,
            lit: &transfer.lit,
            blocked: &transfer.blocked,
            out: Chunks::new(&mut lights, 1),
        };
        let run = Rayon::default().run(pass, 0..vertices);
        run.map_err(RenderError::device)?;
        Ok(lights)
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
        let lights = match settings.method {
            Method::Prt => self.vertex_lights(scene, env, settings)?,
            _ => Vec::new(),
        };
        let mut following = match settings.method {
            Method::Smc => {
                let known = self.smc.take();
                let mut begun = Following::begin(known, &Cpu, scene, env, settings)?;
                begun.clear(&Cpu).map_err(RenderError::device)?;
                Some(begun)
            }
            _ => None,
        };
        let view = following.as_ref().map(|f| f.window(u64::MAX, 0, 0));
        let is_diagnosed = settings.diagnostics && following.is_some();
        let job = Job {
            whole,
            method: match settings.method {
                Method::Mis => JobMethod::Mis,
                Method::Bis => JobMethod::Bis(settings.bis.params()?),
                Method::Smc => JobMethod::Smc,
                Method::Prt => {
                    let known = scene.transfer().ok_or(SettingsError::NoTransfer)?;
                    JobMethod::Prt(known.surface(&lights))
                }
            },
            env: env.view().into(),
            scene: scene.view().into(),
            plate: plate.map(Plate::pixels),
            in_layers: settings.in_layers(scene, plate),
        };
        let mut image = Image::new(settings, is_diagnosed).map_err(RenderError::device)?;
        job.render(
            self.tile_pixels,
            following.as_mut().zip(view.as_ref()),
            &mut image,
            progress,
        )
        .map_err(RenderError::device)?;
        if let Some(mut following) = following {
            if is_diagnosed {
                let pixels = whole.width * whole.height;
                let rays = pixels as usize * whole.rays_per_pixel as usize;
                let out = Chunks::new(&mut image.diagnostics, 1);
                following
                    .diagnose(&mut Rayon::default(), &whole, 0..rays, out, pixels)
                    .map_err(RenderError::device)?;
            }
            *following.light_mut() = env.view().texels.to_vec();
            following.end(PastFrame::new(settings, scene, env)?);
            self.smc = Some(following);
        }
        Ok(FrameImage {
            size: settings.size,
            linear: image.linear,
            display: image.display,
            layers: settings.layers.then_some(image.layers),
            diagnostics: is_diagnosed.then_some(image.diagnostics),
        })
    }

    fn smc_state(&mut self) -> Result<Option<SmcState>, RenderError> {
        match &self.smc {
            Some(following) => following.read(&Cpu).map_err(RenderError::device),
            None => Ok(None),
        }
    }

    fn set_smc_state(&mut self, state: Option<SmcState>) -> Result<(), RenderError> {
        let known = state.map(|state| Following::resume(&Cpu, state));
        self.smc = known.transpose().map_err(RenderError::device)?;
        self.light = LightSh::default();
        Ok(())
    }
}

/// The image that tiles are put into; what is not asked for is empty.
struct Image {
    linear: Vec<Vec4>,
    display: Vec<[u8; 4]>,
    layers: Vec<PixelLayers>,
    diagnostics: Vec<Vec4>,
}

impl Image {
    fn new(settings: &RenderSettings, is_diagnosed: bool) -> Result<Self, HostError> {
        let pixels = settings.size.element_product() as usize;
        let where_asked = |asked| if asked { pixels } else { 0 };
        let mut image = Self {
            linear: Cpu.zeroed("linear", pixels)?,
            display: Cpu.zeroed("display", pixels)?,
            layers: Cpu.zeroed("layers", where_asked(settings.layers))?,
            diagnostics: Cpu.zeroed("diagnostics", where_asked(is_diagnosed))?,
        };
        image.layers.truncate(where_asked(settings.layers));
        image.diagnostics.truncate(where_asked(is_diagnosed));
        Ok(image)
    }
}

/// A frame to render.
struct Job<'a> {
    method: JobMethod<'a>,
    whole: FrameParams,
    env: EnvironmentArg<'a, Host>,
    scene: SceneArg<'a, Host>,
    plate: Option<&'a [PlatePixel]>,
    in_layers: bool,
}

/// How its light is estimated.
enum JobMethod<'a> {
    Mis,
    Bis(crate::kernels::bis::Bis),
    Smc,
    Prt(Surface<'a>),
}

/// What is written of a tile.
struct Part<'a> {
    first: usize,
    linear: &'a mut [Vec4],
    display: &'a mut [[u8; 4]],
    /// Empty where layers are not asked for.
    layers: &'a mut [PixelLayers],
    own: Option<Own<'a, Host>>,
}

/// What a thread computes its tiles in.
struct Scratch {
    samples: Samples<Host>,
    /// Of the sequential sampler; empty for other methods.
    points: Vec<SmcPoint>,
    pixels: Pixels<Host>,
}

impl Scratch {
    fn new(
        pixels: usize,
        rays: usize,
        in_layers: bool,
        is_sequential: bool,
    ) -> Result<Self, HostError> {
        Ok(Self {
            points: match is_sequential {
                true => Cpu.zeroed("points", rays)?,
                false => Vec::new(),
            },
            samples: match in_layers {
                false => Samples::Flat(Cpu.zeroed("samples", rays)?),
                true => Samples::Layered(Cpu.zeroed("samples", rays)?),
            },
            pixels: Pixels::new(&Cpu, pixels, if in_layers { pixels } else { 1 })?,
        })
    }
}

impl Job<'_> {
    fn render(
        &self,
        tile_pixels: usize,
        following: Option<(&mut Following<Host>, &PastView)>,
        image: &mut Image,
        progress: &(dyn Fn(f32) + Sync),
    ) -> Result<(), HostError> {
        let rays_per_pixel = self.whole.rays_per_pixel as usize;
        let pixels = image.linear.len();
        // A tile's rays are numbered in 32 bits.
        let most = u32::MAX as usize / rays_per_pixel;
        let tile_pixels = tile_pixels.clamp(1, most).min(pixels);
        let tile_rays = tile_pixels * rays_per_pixel;
        let (now, past) = match following {
            Some((following, view)) => {
                let particles = following.particles() as usize;
                let (now, reading) = following.parts();
                let own = Own::<Host> {
                    states: Chunks::new(&mut now.states, 1),
                    particles: Chunks::new(&mut now.particles, particles),
                };
                (Some(own), Some((reading, view)))
            }
            None => (None, None),
        };
        let mut layers = image.layers.chunks_mut(tile_pixels);
        let mut rest = now;
        let firsts = (0..).step_by(tile_pixels);
        let lists = image
            .linear
            .chunks_mut(tile_pixels)
            .zip(image.display.chunks_mut(tile_pixels));
        let parts: Vec<Part<'_>> = firsts
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
                    own,
                }
            })
            .collect();
        let done = AtomicUsize::new(0);
        let is_sequential = matches!(self.method, JobMethod::Smc);
        let scratch = || Scratch::new(tile_pixels, tile_rays, self.in_layers, is_sequential);
        parts
            .into_par_iter()
            .try_for_each_init(scratch, |scratch, part| {
                let scratch = scratch.as_mut().map_err(|error| error.clone())?;
                let count = part.linear.len();
                self.tile(scratch, part, past.as_ref())?;
                let done = done.fetch_add(count, Ordering::Relaxed) + count;
                progress(done as f32 / pixels as f32);
                Ok(())
            })
    }

    fn tile(
        &self,
        scratch: &mut Scratch,
        part: Part<'_>,
        past: Option<&(Reading<'_, Host>, &PastView)>,
    ) -> Result<(), HostError> {
        let frame = FrameParams {
            first_pixel: part.first as u32,
            ..self.whole
        };
        let frame = &frame;
        let (count, executor) = (part.linear.len(), &mut Serial);
        let rays = count as u32 * frame.rays_per_pixel;
        let Scratch {
            samples,
            points,
            pixels,
        } = scratch;
        let (env, scene) = (self.env.shorten(), self.scene.shorten());
        let method = match (&self.method, past, part.own) {
            (JobMethod::Prt(surface), ..) => {
                self.draw(frame, *surface, samples, rays);
                None
            }
            (JobMethod::Smc, Some((reading, view)), Some(own)) => {
                let own = own.shorten();
                let points = Chunks::new(points, 1);
                let tile = reading.tile(view, count as u32, points, own);
                Some(TileMethod::Smc(tile))
            }
            (JobMethod::Bis(bis), ..) => Some(TileMethod::Bis(*bis)),
            _ => Some(TileMethod::Mis),
        };
        if let Some(method) = method {
            let inputs = Inputs { frame, env, scene };
            method.shade(executor, inputs, rays, samples.out(rays))?;
        }
        let plate = self.plate.map(|plate| &plate[part.first..][..count]);
        pixels.develop(executor, frame, env, samples, plate, count as u32)?;
        part.linear.copy_from_slice(&pixels.linear[..count]);
        for (code, own) in part.display.iter_mut().zip(&pixels.display) {
            *code = own.to_le_bytes();
        }
        if !part.layers.is_empty() {
            part.layers.copy_from_slice(&pixels.layers[..count]);
        }
        Ok(())
    }

    /// What rays show by precomputed transfer. On a GPU triangles are drawn instead, so this is no pass.
    fn draw(
        &self,
        frame: &FrameParams,
        surface: Surface<'_>,
        samples: &mut Samples<Host>,
        rays: u32,
    ) {
        let (map, scene) = (self.env.view().map(), self.scene.view());
        match samples {
            Samples::Flat(samples) => {
                for (ray, sample) in (0..rays).zip(samples) {
                    *sample = shade_prt(ray, frame, map, scene, surface);
                }
            }
            Samples::Layered(samples) => {
                for (ray, sample) in (0..rays).zip(samples) {
                    *sample = shade_prt_layers(ray, frame, map, scene, surface);
                }
            }
        }
    }
}

impl<'a> Own<'a, Host> {
    fn shorten<'b>(self) -> Own<'b, Host>
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
