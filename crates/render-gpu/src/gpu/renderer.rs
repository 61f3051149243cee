//! Host file: frames by wgpu. Pass 1 traces the rays of a tile, pass 2 makes its pixels of them (Kronander 2014, § 7).

use std::sync::Arc;
use std::time::{Duration, Instant};

use glam::Vec4;
use glimt_executor::gpu::{
    AdapterPreference, Direct, Gpu, GpuContext, GpuError, GpuOptions, GpuVec, LaunchReport,
};
use glimt_executor::{Device, Memory};

use super::upload::{GpuEnv, KeptScene};
use crate::film::{Pixels, Samples};
use crate::generated::entries::{RECONSTRUCT, SHADE_MIS, TONEMAP};
use crate::kernels::composite::PlatePixel;
use crate::kernels::frame::FrameParams;
use crate::kernels::group_health::GroupHealth;
use crate::kernels::layers::{LayerSample, PixelLayers};
use crate::kernels::smc::SmcHealth;
use crate::methods::smc::{Own, TILE_GRANULE};
use crate::methods::{Inputs, Kept, Method, MethodMemory, Points, Work};
use crate::prepare::env::PreparedEnv;
use crate::prepare::past_frame::PastFrame;
use crate::prepare::plate::Plate;
use crate::prepare::render::{
    Diagnostics, FrameImage, RenderError, RenderSettings, Renderer, SettingsError,
};
use crate::prepare::scene_build::SceneBuffers;

/// Bytes of a tile's rays: enough to fill any GPU, few enough for any memory.
const SAMPLE_BYTES: u64 = 64 << 20;

/// Where a frame's time went.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FrameTimes {
    /// Handing over the light, and the scene where it was new.
    pub upload: Duration,
    /// Pass 1: rays and shading.
    pub shade: LaunchReport,
    /// Pass 2: reconstruction and tonemap.
    pub film: LaunchReport,
    /// Copies back to the host.
    pub read_back: Duration,
}

/// Renders on a GPU by tracing rays.
pub struct GpuRenderer {
    context: Arc<GpuContext>,
    scene: KeptScene,
    /// Two, so that a frame's light is never written over that of the frame before.
    envs: [Option<GpuEnv>; 2],
    tile: Option<TileBuffers>,
    /// What the next frame continues from.
    kept: Kept<Gpu>,
    /// What the cost of a ray depended on in the last frame.
    cost: Option<Cost>,
    times: FrameTimes,
}

/// What the cost of a ray depends on: the scene, the method and its counts of samples.
type Cost = (u64, &'static str, [u32; 3]);

/// What one tile is computed in.
struct TileBuffers {
    count: u32,
    rays_per_pixel: u32,
    samples: Samples<Gpu>,
    points: Points<Gpu>,
    pixels: Pixels<Gpu>,
    plate: GpuVec<PlatePixel>,
    particles: GpuVec<SmcHealth>,
    groups: GpuVec<GroupHealth>,
}

impl GpuRenderer {
    /// A renderer on the adapter of choice.
    ///
    /// # Errors
    ///
    /// As [`GpuContext::new`]; also where the adapter cannot run the kernels.
    pub fn new(preference: AdapterPreference<'_>) -> Result<Self, GpuError> {
        Self::with_options(preference, GpuOptions::default())
    }

    /// As [`Self::new`], with options.
    ///
    /// # Errors
    ///
    /// As [`Self::new`].
    pub fn with_options(
        preference: AdapterPreference<'_>,
        options: GpuOptions,
    ) -> Result<Self, GpuError> {
        Self::on(GpuContext::with_options(preference, options)?)
    }

    /// On a GPU that is open.
    ///
    /// # Errors
    ///
    /// [`GpuError::Refused`] where wgpu finds fault with a shader, and other failures of the device.
    pub fn on(context: impl Into<Arc<GpuContext>>) -> Result<Self, GpuError> {
        let context = context.into();
        for entry in [&SHADE_MIS, &RECONSTRUCT, &TONEMAP] {
            context.prepare(entry)?;
        }
        Ok(Self {
            context,
            scene: KeptScene::default(),
            envs: [None, None],
            tile: None,
            kept: Kept::Nothing,
            cost: None,
            times: FrameTimes::default(),
        })
    }

    /// The GPU, to be cloned for uploads from other threads.
    #[must_use]
    pub fn context(&self) -> &Arc<GpuContext> {
        &self.context
    }

    /// Where the last frame's time went.
    #[must_use]
    pub fn times(&self) -> &FrameTimes {
        &self.times
    }

    /// Renders a frame under a light that is on the GPU already, over a plate of the same size or without one, by a method that keeps
    /// nothing between frames.
    ///
    /// # Errors
    ///
    /// As [`Renderer::render_frame`]; [`SettingsError::Memory`] by another method, which would need the host's light, too;
    /// [`SettingsError::Tables`] where the light was uploaded for another method.
    pub fn render(
        &mut self,
        scene: &SceneBuffers,
        env: &GpuEnv,
        plate: Option<&Plate>,
        settings: &RenderSettings,
        progress: &(dyn Fn(f32) + Sync),
    ) -> Result<FrameImage, RenderError> {
        if settings.method.has_memory() {
            return Err(SettingsError::Memory.into());
        }
        if !env.serves(&settings.method) {
            return Err(SettingsError::Tables.into());
        }
        self.times = FrameTimes::default();
        let known = std::mem::replace(&mut self.kept, Kept::Nothing);
        let mut kept = known.begin(&*self.context, scene, None, settings)?;
        let image = self.render_tiles(scene, env, &mut kept, plate, settings, progress);
        self.kept = kept;
        image
    }

    fn render_tiles(
        &mut self,
        scene: &SceneBuffers,
        env: &GpuEnv,
        kept: &mut Kept<Gpu>,
        plate: Option<&Plate>,
        settings: &RenderSettings,
        progress: &(dyn Fn(f32) + Sync),
    ) -> Result<FrameImage, RenderError> {
        let whole = settings.frame_params_over(plate)?;
        let in_layers = settings.in_layers(scene, plate);
        let started = Instant::now();
        self.scene.keep(&self.context, scene).map_err(device)?;
        self.times.upload += started.elapsed();
        self.keep_tile(&whole, in_layers, settings)
            .map_err(device)?;
        let has_past = kept.has_past();
        let method = &settings.method;
        let cost = (scene.surface_id(), method.word(), method.cost(has_past));
        if self.cost != Some(cost) {
            for entry in method.entries() {
                self.context.forget_pace(entry).map_err(device)?;
            }
            self.cost = Some(cost);
        }
        let (Some(uploaded), Some(tile)) = (self.scene.get(), &mut self.tile) else {
            unreachable!("both were just made");
        };
        let inputs = Inputs {
            frame: &whole,
            env: env.arg(),
            scene: uploaded.arg(),
        };
        if let Kept::Cells(counting) = kept {
            let mut executor = Direct::new(&self.context);
            counting.find(&mut executor, inputs).map_err(device)?;
            self.times.shade += executor.take_report();
        }
        let pixels = whole.width * whole.height;
        let mut image = FrameImage {
            size: settings.size,
            linear: Vec::with_capacity(pixels as usize),
            display: Vec::with_capacity(pixels as usize),
            layers: settings.layers.then(Vec::new),
            diagnostics: None,
        };
        if settings.diagnostics && method.leads_particles() {
            image.diagnostics = Some(Diagnostics::Particles(Vec::new()));
        } else if settings.diagnostics && method.takes_groups() {
            let pilot_rays = match kept {
                Kept::Cells(counting) => counting.pilot_rays(&*self.context).map_err(device)?,
                Kept::Nothing | Kept::Smc(_) => 0.0,
            };
            image.diagnostics = Some(Diagnostics::Groups {
                pixels: Vec::new(),
                pilot_rays,
            });
        }
        let fitting = fitting_pixels(&self.context, settings);
        let mut first = 0;
        while first < pixels {
            let count = tile.count.min(pixels - first);
            let rays = f64::from(pixels) * f64::from(whole.rays_per_pixel);
            let earlier = f64::from(first) * f64::from(whole.rays_per_pixel);
            let passes = f64::from(method.passes());
            let tell = |done: u64| progress(((earlier + done as f64 / passes) / rays) as f32);
            let work = TileWork {
                context: &self.context,
                inputs: Inputs {
                    frame: &FrameParams {
                        first_pixel: first,
                        ..whole
                    },
                    env: env.arg(),
                    scene: uploaded.arg(),
                },
                count,
                plate: plate.map(|plate| &plate.pixels()[first as usize..(first + count) as usize]),
            };
            work.render(method, kept, fitting, tile, &tell, &mut self.times)
                .and_then(|()| work.read(tile, &mut self.times, &mut image))
                .map_err(device)?;
            first += count;
        }
        Ok(image)
    }

    fn keep_tile(
        &mut self,
        frame: &FrameParams,
        in_layers: bool,
        settings: &RenderSettings,
    ) -> Result<(), GpuError> {
        let largest = self.largest_tile(frame, in_layers, settings);
        let pixels = frame.width * frame.height;
        let fits = |tile: &TileBuffers| {
            tile.rays_per_pixel == frame.rays_per_pixel
                && matches!(tile.samples, Samples::Layered(_)) == in_layers
                && tile.points.fit(&settings.method)
                && (tile.count == pixels || tile.count == largest)
        };
        if !self.tile.as_ref().is_some_and(fits) {
            self.tile = None;
            self.tile = Some(TileBuffers::new(
                &self.context,
                largest,
                frame.rays_per_pixel,
                in_layers,
                &settings.method,
            )?);
        }
        Ok(())
    }

    /// Pixels whose rays fit a binding, and no more than there are.
    fn largest_tile(&self, frame: &FrameParams, in_layers: bool, settings: &RenderSettings) -> u32 {
        let bytes = self.context.max_binding_bytes().min(SAMPLE_BYTES);
        let ray_bytes = sample_bytes(in_layers).max(settings.method.bytes_between_passes());
        let pixel_bytes = ray_bytes * u64::from(frame.rays_per_pixel);
        let fitting = match in_layers {
            false => bytes / pixel_bytes,
            true => bytes / pixel_bytes.max(size_of::<PixelLayers>() as u64),
        };
        let pixels = u64::from(frame.width * frame.height);
        // One pixel at least; where its rays do not fit, the launch says so.
        let fitting = fitting.clamp(1, pixels);
        let rays = fitting_pixels(&self.context, settings);
        if !settings.method.has_memory() || fitting.min(rays) == pixels {
            return fitting as u32;
        }
        // Half of what the frame before may show at once, so that a tile sees beyond its own edges.
        let half = match rays >= pixels {
            true => pixels,
            false => rays / 2,
        };
        let granule = u64::from(TILE_GRANULE);
        (fitting.min(half) / granule * granule).max(granule) as u32
    }
}

impl Renderer for GpuRenderer {
    fn name(&self) -> String {
        format!("GPU, {}", self.context.adapter())
    }

    fn render_over(
        &mut self,
        scene: &SceneBuffers,
        env: &PreparedEnv,
        plate: Option<&Plate>,
        settings: &RenderSettings,
        progress: &(dyn Fn(f32) + Sync),
    ) -> Result<FrameImage, RenderError> {
        let started = Instant::now();
        self.envs.swap(0, 1);
        let current = match self.envs[0].take() {
            Some(mut old) => old
                .update(&self.context, env, &settings.method)
                .map(|()| old),
            None => GpuEnv::new(&self.context, env, &settings.method),
        };
        let current = current?;
        self.times = FrameTimes {
            upload: started.elapsed(),
            ..FrameTimes::default()
        };
        let known = std::mem::replace(&mut self.kept, Kept::Nothing);
        let mut kept = known.begin(&*self.context, scene, Some(env), settings)?;
        let image = self.render_tiles(scene, &current, &mut kept, plate, settings, progress);
        if image.is_ok() && settings.method.has_memory() {
            let past = PastFrame::new(settings, scene, env)?;
            match &mut kept {
                Kept::Nothing => {}
                Kept::Cells(counting) => counting.end(&*self.context, past).map_err(device)?,
                Kept::Smc(following) => {
                    let (light, texels) = (following.light_mut(), current.texels());
                    if light.len() != texels.len() {
                        *light = self
                            .context
                            .zeroed("before.texels", texels.count())
                            .map_err(device)?;
                    }
                    self.context
                        .copy(texels, light, texels.len())
                        .map_err(device)?;
                    following.end(past, env.view().map());
                }
            }
        }
        self.kept = kept;
        self.envs[0] = Some(current);
        image
    }

    fn phases(&self) -> Vec<(&'static str, Duration)> {
        let times = &self.times;
        // As the host saw them, like the whole that they are parts of.
        vec![
            ("upload", times.upload),
            ("shade", times.shade.wall),
            ("film", times.film.wall),
            ("read back", times.read_back),
        ]
    }

    fn memory(&mut self) -> Result<Option<MethodMemory>, RenderError> {
        self.kept.read(&*self.context).map_err(device)
    }

    fn set_memory(&mut self, memory: MethodMemory) -> Result<(), RenderError> {
        // There may not be room for two.
        self.kept = Kept::Nothing;
        self.kept = Kept::resume(&*self.context, memory).map_err(device)?;
        Ok(())
    }

    fn forget(&mut self) {
        self.kept = Kept::Nothing;
    }
}

pub(super) fn device(error: GpuError) -> RenderError {
    RenderError::Device(Box::new(error))
}

/// Pixels for whose rays a binding holds what the method keeps.
fn fitting_pixels(context: &GpuContext, settings: &RenderSettings) -> u64 {
    let ray = settings.method.bytes_kept();
    let pixel = ray * u64::from(settings.rays_per_pixel);
    context
        .max_binding_bytes()
        .checked_div(pixel)
        .unwrap_or(u64::MAX)
}

impl TileBuffers {
    fn new(
        context: &GpuContext,
        count: u32,
        rays_per_pixel: u32,
        in_layers: bool,
        method: &Method,
    ) -> Result<Self, GpuError> {
        let (pixels, rays) = (count as usize, u64::from(count) * u64::from(rays_per_pixel));
        let layered = if in_layers { pixels } else { 1 };
        Ok(Self {
            count,
            rays_per_pixel,
            samples: match in_layers {
                false => Samples::Flat(context.zeroed("samples", rays)?),
                true => Samples::Layered(context.zeroed("samples", rays)?),
            },
            points: Points::new(context, method, rays as usize)?,
            pixels: Pixels::new(context, pixels, layered)?,
            particles: context.zeroed("diagnostics", pixels as u64)?,
            groups: context.zeroed("diagnostics", pixels as u64)?,
            plate: context.zeroed("plate", layered as u64)?,
        })
    }
}

/// Bytes of one ray's sample.
fn sample_bytes(in_layers: bool) -> u64 {
    match in_layers {
        false => size_of::<Vec4>() as u64,
        true => size_of::<LayerSample>() as u64,
    }
}

/// One tile to render.
struct TileWork<'a> {
    context: &'a GpuContext,
    inputs: Inputs<'a, Gpu>,
    count: u32,
    /// The tile's part of the plate.
    plate: Option<&'a [PlatePixel]>,
}

impl TileWork<'_> {
    fn render(
        &self,
        method: &Method,
        kept: &mut Kept<Gpu>,
        fitting: u64,
        tile: &mut TileBuffers,
        progress: &dyn Fn(u64),
        times: &mut FrameTimes,
    ) -> Result<(), GpuError> {
        let (frame, count) = (self.inputs.frame, self.count);
        let rays = count * frame.rays_per_pixel;
        if let Some(plate) = self.plate {
            let started = Instant::now();
            self.context.write(&tile.plate, plate)?;
            times.upload += started.elapsed();
        }
        let mut executor = Direct::with_progress(self.context, progress);
        let out = tile.samples.out(rays);
        match (kept, &mut tile.points) {
            (Kept::Smc(following), Points::Smc(points)) => {
                let first = frame.first_pixel as usize * frame.rays_per_pixel as usize;
                let own_rays = first..first + rays as usize;
                let view = following.window(fitting, frame.first_pixel, count);
                let n = following.particles();
                let (now, reading) = following.parts();
                let sets = own_rays.start * n as usize..own_rays.end * n as usize;
                let own = Own {
                    states: Gpu::chunks(&mut now.states, own_rays.clone(), 1),
                    particles: Gpu::chunks(&mut now.particles, sets, n),
                };
                let points = Gpu::chunks(points, 0..rays as usize, 1);
                let work = Work::Smc(reading.tile(&view, count, points, own));
                method.shade(work, &mut executor, self.inputs, rays, out)?;
                let mut film = Direct::new(self.context);
                let out = Gpu::chunks(&mut tile.particles, 0..count as usize, 1);
                following.diagnose(&mut film, frame, own_rays, out, count)?;
                times.film += film.take_report();
            }
            (kept, points) => {
                let counted = match kept {
                    Kept::Cells(counting) => Some(counting.reading()),
                    Kept::Nothing | Kept::Smc(_) => None,
                };
                let work = points.work(counted, rays);
                method.shade(work, &mut executor, self.inputs, rays, out)?;
            }
        }
        times.shade += executor.take_report();
        let mut executor = Direct::new(self.context);
        let plate = &tile.plate;
        let plate = self.plate.map(|_| Gpu::slice(plate, 0..count as usize));
        let (env, samples) = (self.inputs.env, &tile.samples);
        tile.pixels
            .develop(&mut executor, frame, env, samples, plate, count)?;
        times.film += executor.take_report();
        Ok(())
    }

    /// Copies the tile to the end of the image.
    fn read(
        &self,
        tile: &mut TileBuffers,
        times: &mut FrameTimes,
        image: &mut FrameImage,
    ) -> Result<(), GpuError> {
        let (started, count) = (Instant::now(), self.count as usize);
        let (context, pixels) = (self.context, &tile.pixels);
        image.linear.extend(context.get(&pixels.linear, count)?);
        let codes: Vec<[u8; 4]> = context.read(&pixels.display, count)?;
        image.display.extend(codes);
        if let Some(layers) = &mut image.layers {
            layers.extend(context.get(&pixels.layers, count)?);
        }
        match &mut image.diagnostics {
            None => {}
            Some(Diagnostics::Particles(all)) => all.extend(context.get(&tile.particles, count)?),
            Some(Diagnostics::Groups { pixels: all, .. }) => {
                let mut executor = Direct::new(context);
                let out = Gpu::chunks(&mut tile.groups, 0..count, 1);
                tile.points
                    .diagnose(&mut executor, self.inputs.frame, out, self.count)?;
                times.film += executor.take_report();
                all.extend(context.get(&tile.groups, count)?);
            }
        }
        times.read_back += started.elapsed();
        Ok(())
    }
}
