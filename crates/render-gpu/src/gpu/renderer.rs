//! Host file: frames by wgpu. Pass 1 traces the rays of a tile, pass 2 makes its pixels of them (Kronander 2014, § 7).

use std::sync::Arc;
use std::time::{Duration, Instant};

use glam::Vec4;

use super::device::{AdapterPreference, GpuContext};
use super::error::GpuError;
use super::launch::{Arg, LaunchReport};
use super::prt::{DrawTimes, GpuPrt};
use super::smc::{self, GpuSmc};
use super::upload::{GpuEnv, GpuScene};
use super::{GpuBuffer, GpuOptions};
use crate::entry::Entry;
use crate::generated::{
    COMPOSITE_ALONE, COMPOSITE_OVER_PLATE, DIAGNOSE_SMC, DISPLAY_OVER_PLATE, RECONSTRUCT,
    RECONSTRUCT_LAYERS, SHADE_BIS, SHADE_BIS_LAYERS, SHADE_MIS, SHADE_MIS_LAYERS, SHADE_SMC,
    SHADE_SMC_LAYERS, TONEMAP,
};
use crate::host::env::PreparedEnv;
use crate::host::plate::Plate;
use crate::host::render::{
    FrameImage, Method, RenderError, RenderSettings, Renderer, SettingsError,
};
use crate::host::scene_build::SceneBuffers;
use crate::host::smc_state::{PastFrame, SmcState};
use crate::kernels::composite::PlatePixel;
use crate::kernels::frame::FrameParams;
use crate::kernels::layers::{LayerSample, PixelLayers};

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
    /// Of a frame by precomputed transfer, which has no passes but these.
    pub drawn: Option<DrawTimes>,
}

/// Renders on a GPU.
#[derive(Debug)]
pub struct GpuRenderer {
    context: Arc<GpuContext>,
    scene: Option<GpuScene>,
    /// Two, so that a frame's light is never written over that of the frame before.
    envs: [Option<GpuEnv>; 2],
    tile: Option<TileBuffers>,
    /// What the sequential sampler goes on from.
    smc: Option<GpuSmc>,
    /// What draws frames by precomputed transfer.
    prt: Option<GpuPrt>,
    /// What the cost of a ray hung on in the last frame.
    cost: Option<Cost>,
    times: FrameTimes,
}

/// What the cost of a ray hangs on: the scene, the method and its counts of samples.
type Cost = (u64, Method, [u32; 4]);

/// What one tile is computed in.
#[derive(Debug)]
struct TileBuffers {
    pixels: u32,
    rays_per_pixel: u32,
    in_layers: bool,
    samples: GpuBuffer,
    linear: GpuBuffer,
    display: GpuBuffer,
    /// For frames in layers; of one pixel for others.
    layers: GpuBuffer,
    plate: GpuBuffer,
    diagnostics: GpuBuffer,
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
    pub fn on(context: GpuContext) -> Result<Self, GpuError> {
        let context = Arc::new(context);
        for entry in [&SHADE_MIS, &RECONSTRUCT, &TONEMAP] {
            context.prepare(entry)?;
        }
        Ok(Self {
            context,
            scene: None,
            envs: [None, None],
            tile: None,
            smc: None,
            prt: None,
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

    /// Renders a frame under a light that is on the GPU already, over a plate of the same size or without one: by any method but
    /// the sequential sampler and precomputed transfer, which have to know of the host's light, too.
    ///
    /// # Errors
    ///
    /// As [`Renderer::render_frame`]; [`SettingsError::Smc`] by the first of those methods, [`GpuError::Argument`] by the other.
    pub fn render(
        &mut self,
        scene: &SceneBuffers,
        env: &GpuEnv,
        plate: Option<&Plate>,
        settings: &RenderSettings,
        progress: &(dyn Fn(f32) + Sync),
    ) -> Result<FrameImage, RenderError> {
        if settings.method == Method::Smc {
            return Err(SettingsError::Smc.into());
        }
        self.times = FrameTimes::default();
        self.render_tiles(scene, env, None, plate, settings, progress)
    }

    fn render_tiles(
        &mut self,
        scene: &SceneBuffers,
        env: &GpuEnv,
        smc: Option<&GpuSmc>,
        plate: Option<&Plate>,
        settings: &RenderSettings,
        progress: &(dyn Fn(f32) + Sync),
    ) -> Result<FrameImage, RenderError> {
        let whole = settings.frame_params_over(plate)?;
        let in_layers = settings.in_layers(scene, plate);
        self.keep_scene(scene).map_err(device)?;
        self.keep_tile(&whole, in_layers, settings)
            .map_err(device)?;
        let (Some(uploaded), Some(tile)) = (&self.scene, &self.tile) else {
            unreachable!("both were just made");
        };
        let bis = match settings.method {
            Method::Bis => Some(settings.bis.params()?),
            _ => None,
        };
        let shade = match (settings.method, in_layers) {
            (Method::Mis, false) => &SHADE_MIS,
            (Method::Mis, true) => &SHADE_MIS_LAYERS,
            (Method::Bis, false) => &SHADE_BIS,
            (Method::Bis, true) => &SHADE_BIS_LAYERS,
            (Method::Smc, false) => &SHADE_SMC,
            (Method::Smc, true) => &SHADE_SMC_LAYERS,
            (Method::Prt, _) => return Err(device(host_light())),
        };
        let counts = match settings.method {
            Method::Mis => [whole.brdf_samples, whole.env_samples, 0, 0],
            Method::Bis => [settings.bis.candidates, settings.bis.samples, 0, 0],
            Method::Prt => [0; 4],
            Method::Smc => {
                // The first frame of a sequence has nothing to go on from, and another cost.
                let steps = match smc {
                    Some(smc) if smc.has_past() => settings.smc.intermediate + 1,
                    _ => 0,
                };
                [settings.smc.particles, settings.smc.candidates, steps, 0]
            }
        };
        let cost = Some((scene.surface_id(), settings.method, counts));
        if self.cost != cost {
            self.context.forget_pace(shade).map_err(device)?;
            self.cost = cost;
        }
        let pixels = whole.width * whole.height;
        let mut image = FrameImage {
            size: settings.size,
            linear: Vec::with_capacity(pixels as usize),
            display: Vec::with_capacity(pixels as usize),
            layers: settings.layers.then(Vec::new),
            diagnostics: (settings.diagnostics && smc.is_some()).then(Vec::new),
        };
        let mut first = 0;
        while first < pixels {
            let frame = FrameParams {
                first_pixel: first,
                ..whole
            };
            let count = tile.pixels.min(pixels - first);
            let rays = f64::from(pixels) * f64::from(whole.rays_per_pixel);
            let before = f64::from(first) * f64::from(whole.rays_per_pixel);
            let tell = |done: u32| progress(((before + f64::from(done)) / rays) as f32);
            let fitting = GpuSmc::fitting_pixels(&self.context, settings);
            let window = smc.map(|smc| smc.window(fitting, first, count));
            let of_method = match (&bis, smc, &window) {
                (Some(bis), ..) => vec![("bis", Arg::Value(bytemuck::bytes_of(bis)))],
                (None, Some(smc), Some(window)) => smc.args(&frame, window, count),
                _ => Vec::new(),
            };
            let work = Work {
                context: &self.context,
                scene: uploaded,
                env,
                of_method,
                smc,
                tile,
                frame: &frame,
                count,
                plate: plate.map(|plate| &plate.pixels()[first as usize..(first + count) as usize]),
            };
            work.render(shade, &tell, &mut self.times, &mut image)
                .map_err(device)?;
            first += count;
        }
        Ok(image)
    }

    /// Draws a frame by precomputed transfer, as [`Renderer::render_over`] does by [`Method::Prt`], but leaves it on the GPU and
    /// waits for nothing: for frames that are shown there, or measured. [`GpuContext::finish`] waits for all of them.
    ///
    /// # Errors
    ///
    /// As [`GpuPrt::draw`].
    pub fn draw_over(
        &mut self,
        scene: &SceneBuffers,
        env: &PreparedEnv,
        plate: Option<&Plate>,
        settings: &RenderSettings,
    ) -> Result<(), RenderError> {
        let mut prt = match self.prt.take() {
            Some(prt) => prt,
            None => GpuPrt::new(&self.context).map_err(device)?,
        };
        self.times = FrameTimes::default();
        let drawn = self.keep_scene(scene).map_err(device).and_then(|()| {
            let Some(uploaded) = &self.scene else {
                unreachable!("it was just made");
            };
            prt.draw(&self.context, scene, uploaded, env, plate, settings)
        });
        self.prt = Some(prt);
        drawn
    }

    /// The frame that was drawn last.
    fn read_drawn(&mut self) -> Result<FrameImage, RenderError> {
        let Some(prt) = &mut self.prt else {
            return Err(device(host_light()));
        };
        let image = prt.read(&self.context).map_err(device)?;
        self.times.drawn = Some(*prt.times());
        Ok(image)
    }

    fn keep_scene(&mut self, scene: &SceneBuffers) -> Result<(), GpuError> {
        let started = Instant::now();
        // Another scene goes first: there may not be room for two. One that cannot be updated is none.
        let known = self.scene.take();
        let same = known.filter(|known| known.surface_id() == scene.surface_id());
        self.scene = Some(match same {
            Some(mut posed) => {
                posed.update(&self.context, scene)?;
                posed
            }
            None => GpuScene::new(&self.context, scene)?,
        });
        self.times.upload += started.elapsed();
        Ok(())
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
                && tile.in_layers == in_layers
                && (tile.pixels == pixels || tile.pixels == largest)
        };
        if !self.tile.as_ref().is_some_and(fits) {
            self.tile = None;
            self.tile = Some(TileBuffers::new(
                &self.context,
                largest,
                frame.rays_per_pixel,
                in_layers,
            )?);
        }
        Ok(())
    }

    /// Pixels whose rays fit a binding, and no more than there are.
    fn largest_tile(&self, frame: &FrameParams, in_layers: bool, settings: &RenderSettings) -> u32 {
        let bytes = self.context.max_binding_bytes().min(SAMPLE_BYTES);
        let pixel_bytes = sample_bytes(in_layers) * u64::from(frame.rays_per_pixel);
        let fitting = match in_layers {
            false => bytes / pixel_bytes,
            true => bytes / pixel_bytes.max(size_of::<PixelLayers>() as u64),
        };
        let pixels = u64::from(frame.width * frame.height);
        // One pixel at least; where its rays do not fit, the launch says so.
        let fitting = fitting.clamp(1, pixels);
        let rays = GpuSmc::fitting_pixels(&self.context, settings);
        if settings.method != Method::Smc || fitting.min(rays) == pixels {
            return fitting as u32;
        }
        // Half of what the frame before may show at once, so that a tile sees beyond its own edges.
        let half = match rays >= pixels {
            true => pixels,
            false => rays / 2,
        };
        let granule = u64::from(smc::TILE_GRANULE);
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
        if settings.method == Method::Prt {
            self.draw_over(scene, env, plate, settings)?;
            let image = self.read_drawn()?;
            progress(1.0);
            return Ok(image);
        }
        let started = Instant::now();
        self.envs.swap(0, 1);
        let current = match self.envs[0].take() {
            Some(mut old) => old.update(&self.context, env).map(|()| old),
            None => GpuEnv::new(&self.context, env),
        };
        let current = current.map_err(device)?;
        self.times = FrameTimes {
            upload: started.elapsed(),
            ..FrameTimes::default()
        };
        let mut smc = match settings.method {
            Method::Smc => {
                let known = self.smc.take();
                Some(GpuSmc::begin(known, &self.context, scene, env, settings)?)
            }
            _ => None,
        };
        let image = self.render_tiles(scene, &current, smc.as_ref(), plate, settings, progress);
        if let (Some(smc), Ok(_)) = (&mut smc, &image) {
            let past = PastFrame::new(settings, scene, env)?;
            smc.end(&self.context, &current, past).map_err(device)?;
        }
        if let Some(smc) = smc {
            self.smc = Some(smc);
        }
        self.envs[0] = Some(current);
        image
    }

    fn phases(&self) -> Vec<(&'static str, Duration)> {
        let times = &self.times;
        if let Some(drawn) = &times.drawn {
            return vec![
                ("upload", times.upload + drawn.upload),
                ("light", drawn.light),
                ("draw", drawn.draw),
                ("read back", drawn.read_back),
            ];
        }
        // As the host saw them, like the whole that they are parts of.
        vec![
            ("upload", times.upload),
            ("shade", times.shade.wall),
            ("film", times.film.wall),
            ("read back", times.read_back),
        ]
    }

    fn smc_state(&mut self) -> Result<Option<SmcState>, RenderError> {
        match &self.smc {
            Some(smc) => smc.read(&self.context).map_err(device),
            None => Ok(None),
        }
    }

    fn set_smc_state(&mut self, state: Option<SmcState>) -> Result<(), RenderError> {
        self.smc = None;
        if let Some(prt) = &mut self.prt {
            prt.forget();
        }
        if let Some(state) = state {
            self.smc = Some(GpuSmc::upload(&self.context, state).map_err(device)?);
        }
        Ok(())
    }
}

/// The answer to a frame by precomputed transfer under a light that the host does not know.
fn host_light() -> GpuError {
    GpuError::Argument {
        entry: "precomputed transfer".to_owned(),
        problem: "it has to be given the host's light map".to_owned(),
    }
}

pub(super) fn device(error: GpuError) -> RenderError {
    RenderError::Device(Box::new(error))
}

impl TileBuffers {
    fn new(
        context: &GpuContext,
        pixels: u32,
        rays_per_pixel: u32,
        in_layers: bool,
    ) -> Result<Self, GpuError> {
        let (count, rays) = (u64::from(pixels), u64::from(rays_per_pixel));
        let layered = if in_layers { count } else { 1 };
        Ok(Self {
            pixels,
            rays_per_pixel,
            in_layers,
            samples: context.buffer("samples", count * rays * sample_bytes(in_layers))?,
            linear: context.buffer("linear", count * size_of::<Vec4>() as u64)?,
            display: context.buffer("display", count * 4)?,
            layers: context.buffer("layers", layered * size_of::<PixelLayers>() as u64)?,
            diagnostics: context.buffer("diagnostics", count * size_of::<Vec4>() as u64)?,
            plate: context.buffer("plate", layered * size_of::<PlatePixel>() as u64)?,
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
struct Work<'a> {
    context: &'a GpuContext,
    scene: &'a GpuScene,
    env: &'a GpuEnv,
    /// Arguments of the method's own.
    of_method: Vec<(&'static str, Arg<'a>)>,
    smc: Option<&'a GpuSmc>,
    tile: &'a TileBuffers,
    frame: &'a FrameParams,
    count: u32,
    /// The tile's part of the plate.
    plate: Option<&'a [PlatePixel]>,
}

impl Work<'_> {
    fn render(
        &self,
        shade: &Entry,
        progress: &dyn Fn(u32),
        times: &mut FrameTimes,
        image: &mut FrameImage,
    ) -> Result<(), GpuError> {
        let tile = self.tile;
        let frame = ("frame", Arg::Value(bytemuck::bytes_of(self.frame)));
        let mut args = vec![frame, ("out", Arg::Buffer(&tile.samples))];
        args.extend(self.scene.args());
        args.extend(self.env.args());
        args.extend(&self.of_method);
        let rays = self.count * tile.rays_per_pixel;
        times.shade += self
            .context
            .launch_telling(shade, &args, 0, rays, progress)?;

        if tile.in_layers {
            self.composite(times)?;
        } else {
            let samples = ("samples", Arg::Buffer(&tile.samples));
            self.film(&RECONSTRUCT, &[samples], &tile.linear, times)?;
        }
        match self.plate {
            Some(_) => self.film(
                &DISPLAY_OVER_PLATE,
                &self.over_plate(),
                &tile.display,
                times,
            )?,
            None => {
                let linear = ("linear", Arg::Buffer(&tile.linear));
                self.film(&TONEMAP, &[linear], &tile.display, times)?;
            }
        }

        if let (Some(smc), Some(diagnostics)) = (self.smc, &mut image.diagnostics) {
            let args = smc.diagnose_args(self.frame, self.count);
            self.film(&DIAGNOSE_SMC, &args, &tile.diagnostics, times)?;
            diagnostics.extend(
                self.context
                    .read::<Vec4>(&tile.diagnostics, self.count as usize)?,
            );
        }
        let started = Instant::now();
        image.linear.extend(
            self.context
                .read::<Vec4>(&tile.linear, self.count as usize)?,
        );
        image.display.extend(
            self.context
                .read::<[u8; 4]>(&tile.display, self.count as usize)?,
        );
        if let Some(layers) = &mut image.layers {
            layers.extend(
                self.context
                    .read::<PixelLayers>(&tile.layers, self.count as usize)?,
            );
        }
        times.read_back += started.elapsed();
        Ok(())
    }

    /// Linear values of the tile by way of its layers.
    fn composite(&self, times: &mut FrameTimes) -> Result<(), GpuError> {
        let tile = self.tile;
        let mut args = vec![("samples", Arg::Buffer(&tile.samples))];
        args.extend(self.env.args());
        self.film(&RECONSTRUCT_LAYERS, &args, &tile.layers, times)?;
        match self.plate {
            Some(plate) => {
                let started = Instant::now();
                self.context.write(&tile.plate, plate)?;
                times.upload += started.elapsed();
                self.film(
                    &COMPOSITE_OVER_PLATE,
                    &self.over_plate(),
                    &tile.linear,
                    times,
                )
            }
            None => {
                let layers = ("layers", Arg::Buffer(&tile.layers));
                self.film(&COMPOSITE_ALONE, &[layers], &tile.linear, times)
            }
        }
    }

    fn over_plate(&self) -> [(&str, Arg<'_>); 2] {
        [
            ("layers", Arg::Buffer(&self.tile.layers)),
            ("plate", Arg::Buffer(&self.tile.plate)),
        ]
    }

    /// Runs a kernel of pass 2, one call a pixel.
    fn film(
        &self,
        entry: &Entry,
        inputs: &[(&str, Arg<'_>)],
        out: &GpuBuffer,
        times: &mut FrameTimes,
    ) -> Result<(), GpuError> {
        let frame = ("frame", Arg::Value(bytemuck::bytes_of(self.frame)));
        let args = [&[frame, ("out", Arg::Buffer(out))], inputs].concat();
        times.film += self.context.launch(entry, &args, 0, self.count)?;
        Ok(())
    }
}
