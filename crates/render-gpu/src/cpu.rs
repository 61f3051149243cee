//! Host file: the CPU executor: the kernels, run by rayon.

use rayon::prelude::*;
use std::ops::Range;
use std::sync::atomic::{AtomicUsize, Ordering};

use bytemuck::Zeroable;
use glam::{Mat4, Vec3, Vec4};
use glimt_smc::{LOG_ZERO, Particle};

use crate::host::env::PreparedEnv;
use crate::host::light_sh::LightSh;
use crate::host::plate::Plate;
use crate::host::render::{
    FrameImage, Method, RenderError, RenderSettings, Renderer, SettingsError,
};
use crate::host::scene_build::SceneBuffers;
use crate::host::smc_state::{PastFrame, SmcKey, SmcState};
use crate::kernels::bis::Bis;
use crate::kernels::composite::{
    PlatePixel, composite_alone, composite_over_plate, display_over_plate,
};
use crate::kernels::environment::{Environment, RadianceMap};
use crate::kernels::film::{reconstruct, tonemap};
use crate::kernels::frame::FrameParams;
use crate::kernels::layers::{LayerSample, PixelLayers, reconstruct_layers};
use crate::kernels::past::{Past, PastView, RayState};
use crate::kernels::prt::{Surface, VertexLight, shade_prt, shade_prt_layers, vertex_light};
use crate::kernels::scene::Scene;
use crate::kernels::shade::{shade_bis, shade_bis_layers, shade_mis, shade_mis_layers};
use crate::kernels::smc::{SmcParams, diagnose_smc, shade_smc, shade_smc_layers};

/// Renders on all of rayon's threads.
#[derive(Clone, Debug)]
pub struct CpuRenderer {
    /// Pixels in a tile, a run of the image's pixels. It changes no bit of the image, only how work is shared out.
    pub tile_pixels: usize,
    /// What the sequential sampler goes on from.
    smc: Option<SmcState>,
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
    ) -> Result<Vec<VertexLight>, RenderError> {
        let known = scene.transfer().ok_or(SettingsError::NoTransfer)?;
        let transfer = known.transfer();
        let light = self.light.project(env, transfer.bands, &settings.prt)?;
        let count = transfer.coefficients() as u32;
        let shadows = u32::from(settings.prt.shadows);
        let of_vertex =
            |v| vertex_light(v, count, shadows, &light, &transfer.lit, &transfer.blocked);
        Ok((0..known.vertices())
            .into_par_iter()
            .with_min_len(256)
            .map(of_vertex)
            .collect())
    }

    /// The rays of the frame that is to come, and the frame before them where it can be gone on from.
    fn begin_smc(
        &mut self,
        scene: &SceneBuffers,
        env: &PreparedEnv,
        settings: &RenderSettings,
    ) -> Result<(Option<SmcState>, SmcState), RenderError> {
        let past = self.smc.take();
        let past = past.filter(|past| past.past.key == SmcKey::new(settings, scene));
        let rays = settings.size.element_product() as usize * settings.rays_per_pixel as usize;
        let particle = Particle {
            state: Vec3::Z,
            log_weight: LOG_ZERO,
        };
        let next = SmcState {
            past: PastFrame::new(settings, scene, env)?,
            light: env.view().texels.to_vec(),
            rays: filled(RayState::NONE, rays)?,
            particles: filled(particle, rays * settings.smc.particles as usize)?,
        };
        Ok((past, next))
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
        let (past, mut next) = match settings.method {
            Method::Smc => {
                let (past, next) = self.begin_smc(scene, env, settings)?;
                (past, Some(next))
            }
            _ => (None, None),
        };
        let motions = past.as_ref().map_or_else(
            || vec![Mat4::IDENTITY; scene.transforms().len()],
            |past| past.past.motions(scene),
        );
        let lights = match settings.method {
            Method::Prt => self.vertex_lights(scene, env, settings)?,
            _ => Vec::new(),
        };
        let surface = scene.transfer().map(|transfer| transfer.surface(&lights));
        let work = Work {
            method: WorkMethod::new(settings, env, past.as_ref(), &motions, surface, &whole)?,
            whole,
            env: env.view(),
            scene: scene.view(),
            plate: plate.map(Plate::pixels),
        };
        // A tile's rays are numbered in 32 bits.
        let most = (u32::MAX / whole.rays_per_pixel) as usize;
        let tile_pixels = self.tile_pixels.clamp(1, most);
        let tile_rays = tile_pixels * whole.rays_per_pixel as usize;
        let pixels = (whole.width * whole.height) as usize;
        let tiles = pixels.div_ceil(tile_pixels);
        let mut linear = filled(Vec4::ZERO, pixels)?;
        let mut display = filled([0; 4], pixels)?;
        let mut layers = filled(
            PixelLayers::zeroed(),
            if settings.layers { pixels } else { 0 },
        )?;
        let is_diagnosed = settings.diagnostics && next.is_some();
        let mut diagnostics = filled(Vec4::ZERO, if is_diagnosed { pixels } else { 0 })?;
        let (rays, particles): (&mut [RayState], &mut [Particle]) = match &mut next {
            Some(next) => (&mut next.rays, &mut next.particles),
            None => (&mut [], &mut []),
        };
        // What is not kept has no chunks, and a tile sees none of it.
        let per_ray = settings.smc.particles as usize;
        let kept = chunks(&mut layers, tile_pixels, tiles)
            .into_iter()
            .zip(chunks(&mut diagnostics, tile_pixels, tiles))
            .zip(chunks(rays, tile_rays, tiles))
            .zip(chunks(particles, tile_rays * per_ray, tiles))
            .map(|(((layers, diagnostics), rays), particles)| Kept {
                layers,
                diagnostics,
                rays,
                particles,
            })
            .collect::<Vec<_>>();
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
                        work.layered_tile(first, scratch, linear, display, kept);
                    } else {
                        work.tile(first, scratch, linear, display, kept);
                    }
                    let done = done.fetch_add(linear.len(), Ordering::Relaxed) + linear.len();
                    progress(done as f32 / pixels as f32);
                },
            );
        if let Some(next) = next {
            self.smc = Some(next);
        }
        Ok(FrameImage {
            size: settings.size,
            linear,
            display,
            layers: settings.layers.then_some(layers),
            diagnostics: is_diagnosed.then_some(diagnostics),
        })
    }

    fn smc_state(&mut self) -> Result<Option<SmcState>, RenderError> {
        Ok(self.smc.clone())
    }

    fn set_smc_state(&mut self, state: Option<SmcState>) -> Result<(), RenderError> {
        self.smc = state;
        self.light = LightSh::default();
        Ok(())
    }
}

/// A list in tiles, as many as there are: empty ones where the list is.
fn chunks<T>(list: &mut [T], size: usize, tiles: usize) -> Vec<&mut [T]> {
    let mut chunks = list.chunks_mut(size);
    (0..tiles)
        .map(|_| chunks.next().unwrap_or_default())
        .collect()
}

/// A frame to render.
struct Work<'a> {
    method: WorkMethod<'a>,
    whole: FrameParams,
    env: Environment<'a>,
    scene: Scene<'a>,
    plate: Option<&'a [PlatePixel]>,
}

/// How its light is estimated.
enum WorkMethod<'a> {
    Mis,
    Bis(Bis),
    Smc {
        params: SmcParams,
        view: PastView,
        before: RadianceMap<'a>,
        past: Past<'a>,
        per_ray: usize,
    },
    Prt(Surface<'a>),
}

impl<'a> WorkMethod<'a> {
    fn new(
        settings: &RenderSettings,
        env: &'a PreparedEnv,
        past: Option<&'a SmcState>,
        motions: &'a [Mat4],
        surface: Option<Surface<'a>>,
        frame: &FrameParams,
    ) -> Result<Self, RenderError> {
        Ok(match settings.method {
            Method::Mis => Self::Mis,
            Method::Prt => Self::Prt(surface.ok_or(SettingsError::NoTransfer)?),
            Method::Bis => Self::Bis(settings.bis.params()?),
            Method::Smc => {
                let now = env.view();
                // Without a frame before, this one stands in for it, and no pixel of it is at hand.
                let mean = env.mean_luminance();
                let before = past.map_or(now.map(), SmcState::light);
                let view = match past {
                    Some(past) => past.past.view,
                    None => settings.camera.view(settings.size)?,
                };
                let pixels = past.map_or(0, |_| frame.width * frame.height);
                Self::Smc {
                    params: settings
                        .smc
                        .params(mean, past.map_or(mean, |past| past.past.light_mean))?,
                    view: settings.smc.past_view(&view, 0, pixels),
                    before,
                    past: Past {
                        motions,
                        states: past.map_or(&[], |past| &past.rays),
                        particles: past.map_or(&[], |past| &past.particles),
                    },
                    per_ray: settings.smc.particles as usize,
                }
            }
        })
    }
}

/// `shade_mis` and its twin in layers.
type ShadeMis<S> = fn(u32, &FrameParams, Environment<'_>, Scene<'_>) -> S;
/// `shade_bis` and its twin.
type ShadeBis<S> = fn(u32, &FrameParams, &Bis, Environment<'_>, Scene<'_>) -> S;
/// `shade_smc` and its twin.
type ShadeSmc<S> = fn(
    u32,
    &FrameParams,
    &SmcParams,
    &PastView,
    Environment<'_>,
    RadianceMap<'_>,
    Scene<'_>,
    Past<'_>,
    &mut [RayState],
    &mut [Particle],
) -> S;

/// `shade_prt` and its twin.
type ShadePrt<S> = fn(u32, &FrameParams, RadianceMap<'_>, Scene<'_>, Surface<'_>) -> S;

/// What one ray shows, and the kernels that say it.
trait Shaded: Sized {
    const MIS: ShadeMis<Self>;
    const BIS: ShadeBis<Self>;
    const SMC: ShadeSmc<Self>;
    const PRT: ShadePrt<Self>;
}

impl Shaded for Vec4 {
    const MIS: ShadeMis<Self> = shade_mis;
    const BIS: ShadeBis<Self> = shade_bis;
    const SMC: ShadeSmc<Self> = shade_smc;
    const PRT: ShadePrt<Self> = shade_prt;
}

impl Shaded for LayerSample {
    const MIS: ShadeMis<Self> = shade_mis_layers;
    const BIS: ShadeBis<Self> = shade_bis_layers;
    const SMC: ShadeSmc<Self> = shade_smc_layers;
    const PRT: ShadePrt<Self> = shade_prt_layers;
}

/// What a thread computes its tiles in.
#[derive(Default)]
struct Scratch {
    rays: Vec<Vec4>,
    samples: Vec<LayerSample>,
    layers: Vec<PixelLayers>,
}

/// What is kept of a tile beside its image; empty where it is not.
struct Kept<'a> {
    layers: &'a mut [PixelLayers],
    diagnostics: &'a mut [Vec4],
    rays: &'a mut [RayState],
    particles: &'a mut [Particle],
}

impl Work<'_> {
    fn params(&self, first: usize) -> FrameParams {
        FrameParams {
            first_pixel: first as u32,
            ..self.whole
        }
    }

    /// What the rays of a tile show.
    fn trace<S: Shaded>(
        &self,
        frame: &FrameParams,
        rays: Range<u32>,
        states: &mut [RayState],
        particles: &mut [Particle],
        samples: &mut Vec<S>,
    ) {
        let (env, scene) = (self.env, self.scene);
        samples.clear();
        match &self.method {
            WorkMethod::Mis => samples.extend(rays.map(|ray| S::MIS(ray, frame, env, scene))),
            WorkMethod::Bis(bis) => {
                samples.extend(rays.map(|ray| S::BIS(ray, frame, bis, env, scene)));
            }
            WorkMethod::Smc {
                params,
                view,
                before,
                past,
                per_ray,
            } => {
                let sets = particles.chunks_mut(*per_ray);
                let own = states.chunks_mut(1).zip(sets);
                samples.extend(rays.zip(own).map(|(ray, (state, set))| {
                    S::SMC(
                        ray, frame, params, view, env, *before, scene, *past, state, set,
                    )
                }));
            }
            WorkMethod::Prt(surface) => {
                let map = env.map();
                samples.extend(rays.map(|ray| S::PRT(ray, frame, map, scene, *surface)));
            }
        }
    }

    /// The tile that begins at pixel `first`.
    fn tile(
        &self,
        first: usize,
        scratch: &mut Scratch,
        linear: &mut [Vec4],
        display: &mut [[u8; 4]],
        kept: Kept<'_>,
    ) {
        let frame = &self.params(first);
        let rays = 0..linear.len() as u32 * frame.rays_per_pixel;
        let samples = &mut scratch.rays;
        self.trace(frame, rays, kept.rays, kept.particles, samples);
        for (pixel, value) in (0..).zip(linear.iter_mut()) {
            *value = reconstruct(pixel, frame, samples);
        }
        for (pixel, value) in (0..).zip(display) {
            *value = tonemap(pixel, frame, linear).to_le_bytes();
        }
        self.diagnose(frame, kept.diagnostics, kept.rays);
    }

    /// The same by way of its layers.
    fn layered_tile(
        &self,
        first: usize,
        scratch: &mut Scratch,
        linear: &mut [Vec4],
        display: &mut [[u8; 4]],
        kept: Kept<'_>,
    ) {
        let frame = &self.params(first);
        let pixels = linear.len() as u32;
        let rays = 0..pixels * frame.rays_per_pixel;
        let Scratch {
            samples, layers, ..
        } = scratch;
        self.trace(frame, rays, kept.rays, kept.particles, samples);
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
        if !kept.layers.is_empty() {
            kept.layers.copy_from_slice(layers);
        }
        self.diagnose(frame, kept.diagnostics, kept.rays);
    }

    fn diagnose(&self, frame: &FrameParams, diagnostics: &mut [Vec4], rays: &[RayState]) {
        if let WorkMethod::Smc { per_ray, .. } = self.method {
            for (pixel, value) in (0..).zip(diagnostics) {
                *value = diagnose_smc(pixel, frame, rays, per_ray as u32);
            }
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
