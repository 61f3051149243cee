//! Host file: filming: the kernels of a simulated capture, on the CPU or the GPU.

use super::geometry::{FrameTruth, capture_params, plate_camera, truth_of};
use super::settings::Synth;
use super::world::{Base, World};
use crate::device::{self, Processor};
use crate::error::Result;
use glam::{UVec2, Vec3, Vec4};
use glimt_executor::gpu::Direct;
use glimt_executor::{Cpu, Device, Executor, Memory, Pass, Rayon};
use glimt_render_gpu::generated::passes::{Expose, FilmBall, FilmLatlong, FilmPlate, StageArg};
use glimt_render_gpu::kernels::capture::{CaptureParams, LatLongParams};
use glimt_render_gpu::kernels::film::tonemap;
use glimt_render_gpu::kernels::frame::FrameParams;
use glimt_render_gpu::kernels::sensor::SensorParams;
use glimt_render_gpu::kernels::stage::Stage;
use glimt_render_gpu::prepare::render::{FrameImage, RenderError, RenderSettings};
use rayon::prelude::*;
use std::sync::OnceLock;

/// A capture that is ready to be filmed: all that does not change from frame to frame.
#[derive(Debug)]
pub struct Filming {
    synth: Synth,
    base: Base,
    /// What the plate's camera looks at instead.
    panorama: Option<World>,
    clip: OnceLock<f32>,
}

/// A frame of the ball.
#[derive(Clone, Debug)]
pub struct SynthFrame {
    /// Width and height in pixels.
    pub size: UVec2,
    /// Linear RGB, rows from the top.
    pub pixels: Vec<Vec4>,
    /// What is true of it.
    pub truth: FrameTruth,
}

impl Filming {
    /// A capture in a lat-long map of radiance (size and texels, rows from +z), or in the built-in sky; the plate's camera may
    /// look at another map, a still one. Settings are taken as they are: see [`super::check`].
    pub fn new(
        synth: Synth,
        map: Option<(UVec2, Vec<Vec4>)>,
        panorama: Option<(UVec2, Vec<Vec4>)>,
    ) -> Self {
        let base = map.map_or_else(Base::sky, |(size, texels)| {
            Base::of_map(&synth, size, texels)
        });
        let panorama = panorama.map(|(size, texels)| World::still(&synth, size, texels));
        Self {
            synth,
            base,
            panorama,
            clip: OnceLock::new(),
        }
    }

    /// The settings.
    pub fn synth(&self) -> &Synth {
        &self.synth
    }

    /// What surrounds the ball in a frame.
    pub fn world(&self, frame: u32) -> World {
        self.base.world(&self.synth, frame)
    }

    /// What is true of a frame.
    pub fn truth(&self, world: &World, frame: u32) -> FrameTruth {
        truth_of(&self.synth, frame, world.sun())
    }

    /// The same for one whose surroundings are not available.
    pub fn truth_of(&self, frame: u32) -> FrameTruth {
        truth_of(&self.synth, frame, self.base.sun(&self.synth, frame))
    }

    /// The ball as the camera films it.
    ///
    /// # Errors
    /// The GPU fails.
    pub fn film_frame(
        &self,
        processor: &Processor,
        world: &World,
        frame: u32,
    ) -> Result<SynthFrame> {
        let rig = world.mean_radiance() * self.synth.rig.albedo;
        let capture = capture_params(&self.synth, frame, rig);
        let sensor = self.sensor(frame);
        let size = UVec2::from(self.synth.capture.size);
        let count = size.x * size.y;
        let stage = world.stage();
        let shoot = Shoot { stage, count };
        let pixels = match processor {
            Processor::Cpu => shoot.ball(&Cpu, &mut threads(), &capture, &sensor),
            Processor::Gpu(gpu) => shoot.ball(&**gpu, &mut Direct::new(gpu), &capture, &sensor),
        };
        let pixels = pixels.map_err(device::failure)?;
        Ok(SynthFrame {
            size,
            pixels,
            truth: self.truth(world, frame),
        })
    }

    /// The backplate: linear, and as it is displayed.
    ///
    /// # Errors
    /// The GPU fails, or the plate's camera is not a camera.
    pub fn film_plate(
        &self,
        processor: &Processor,
        world: &World,
        frame: u32,
    ) -> Result<FrameImage> {
        let plate = &self.synth.plate;
        let size = UVec2::from(plate.size);
        let settings = RenderSettings {
            rays_per_pixel: plate.rays_per_pixel,
            seed: self.synth.seed,
            frame,
            exposure_ev: plate.exposure_ev,
            ..RenderSettings::new(size, plate_camera(&self.synth, frame))
        };
        let params: FrameParams = settings
            .frame_params()
            .map_err(|e| device::failure(RenderError::Settings(e)))?;
        let stage = self.panorama.as_ref().unwrap_or(world).stage();
        let count = size.x * size.y;
        let shoot = Shoot { stage, count };
        let linear = match processor {
            Processor::Cpu => shoot.plate(&Cpu, &mut threads(), &params),
            Processor::Gpu(gpu) => shoot.plate(&**gpu, &mut Direct::new(gpu), &params),
        };
        let linear = linear.map_err(device::failure)?;
        let display = |i| tonemap(i, &params, &linear).to_le_bytes();
        let display = (0..count).into_par_iter().map(display).collect();
        Ok(FrameImage {
            size,
            linear,
            display,
            layers: None,
            diagnostics: None,
        })
    }

    /// The lat-long map that an ideal probe at the ball's centre records, without ball and rig: the mean radiance over each
    /// texel's solid angle, `size.x × size.y` texels.
    ///
    /// # Errors
    /// The GPU fails.
    pub fn truth_map(
        &self,
        processor: &Processor,
        world: &World,
        frame: u32,
        size: UVec2,
    ) -> Result<Vec<Vec4>> {
        let stage = world.stage();
        // Two samples across a texel of the light map, along each side, and no fewer than four.
        let coarse = stage.params.size.as_vec2() / size.as_vec2();
        let params = LatLongParams {
            position: super::geometry::probe_and_eye(&self.synth, frame)
                .0
                .as_vec3(),
            grid: ((2.0 * coarse.max_element()).ceil() as u32).clamp(4, 64),
            size,
            unused: UVec2::ZERO,
        };
        let count = size.x * size.y;
        let shoot = Shoot { stage, count };
        let map = match processor {
            Processor::Cpu => shoot.map(&Cpu, &mut threads(), &params),
            Processor::Gpu(gpu) => shoot.map(&**gpu, &mut Direct::new(gpu), &params),
        };
        map.map_err(device::failure)
    }

    /// Radiance at which the shortest exposure clips: as it is set, or a quarter above the brightest that there is in the
    /// whole capture.
    pub fn clip_radiance(&self) -> f32 {
        *self.clip.get_or_init(|| {
            let ends = [1, self.synth.frames].map(|frame| self.world(frame));
            let found = ends.iter().map(World::brightest).fold(0.0, f32::max);
            // A disc that falls onto a texel whole is brighter than one that is shared among several.
            let drawn = ends.iter().filter_map(World::sun).map(|sun| {
                let irradiance = glam::DVec3::from(sun.irradiance);
                super::sun::disc_radiance(irradiance, self.synth.sun.radius_deg).max_element()
            });
            let lamps = self.synth.lamps.iter();
            let lamps: f32 = lamps
                .map(|lamp| Vec3::from(lamp.radiance).max_element())
                .sum();
            let most = drawn.fold(found, f32::max) + lamps;
            let given = self.synth.noise.clip_radiance;
            given.unwrap_or(1.25 * most).max(1e-20)
        })
    }

    /// The sensor's numbers in a frame.
    pub fn sensor(&self, frame: u32) -> SensorParams {
        let noise = &self.synth.noise;
        let step = noise.stops.exp2();
        let shortest = match noise.exposures {
            0 => 1.0,
            _ => noise.full_well / self.clip_radiance(),
        };
        SensorParams {
            longest_gain: shortest * step.powi(noise.exposures.saturating_sub(1).cast_signed()),
            step,
            exposures: noise.exposures,
            full_well: noise.full_well,
            read_noise: noise.read_noise,
            electrons_per_code: noise.full_well / ((1_u64 << noise.bits.min(32)) - 1) as f32,
            seed: self.synth.seed,
            frame,
            unused_a: 0,
            unused_b: 0,
            unused_c: 0,
            unused_d: 0,
        }
    }
}

/// All threads, with enough pixels for each at a time to be worth handing out.
fn threads() -> Rayon {
    Rayon { grain: 64 }
}

/// Pixels that look at a stage.
#[derive(Clone, Copy)]
struct Shoot<'a> {
    stage: Stage<'a>,
    count: u32,
}

impl Shoot<'_> {
    /// A frame of the ball, as a sensor records it; without exposures, its radiance.
    fn ball<D: Device, E: Executor<Memory = D::Memory>>(
        self,
        device: &D,
        executor: &mut E,
        capture: &CaptureParams,
        sensor: &SensorParams,
    ) -> std::result::Result<Vec<Vec4>, RenderError> {
        let texels = self.texels(device)?;
        let stage = self.arg::<D>(&texels);
        let mut filmed = self.room(device)?;
        let out = self.out::<D>(&mut filmed);
        let pass = FilmBall {
            capture,
            stage,
            out,
        };
        self.run::<D, E>(executor, pass)?;
        if sensor.exposures == 0 {
            return self.read(device, &filmed);
        }
        let mut exposed = self.room(device)?;
        let pass = Expose {
            sensor,
            radiance: D::Memory::slice(&filmed, 0..self.count as usize),
            out: self.out::<D>(&mut exposed),
        };
        self.run::<D, E>(executor, pass)?;
        self.read(device, &exposed)
    }

    /// The backplate.
    fn plate<D: Device, E: Executor<Memory = D::Memory>>(
        self,
        device: &D,
        executor: &mut E,
        frame: &FrameParams,
    ) -> std::result::Result<Vec<Vec4>, RenderError> {
        let texels = self.texels(device)?;
        let stage = self.arg::<D>(&texels);
        let mut filmed = self.room(device)?;
        let out = self.out::<D>(&mut filmed);
        self.run::<D, E>(executor, FilmPlate { frame, stage, out })?;
        self.read(device, &filmed)
    }

    /// The map of an ideal probe.
    fn map<D: Device, E: Executor<Memory = D::Memory>>(
        self,
        device: &D,
        executor: &mut E,
        latlong: &LatLongParams,
    ) -> std::result::Result<Vec<Vec4>, RenderError> {
        let texels = self.texels(device)?;
        let stage = self.arg::<D>(&texels);
        let mut filmed = self.room(device)?;
        let out = self.out::<D>(&mut filmed);
        let pass = FilmLatlong {
            latlong,
            stage,
            out,
        };
        self.run::<D, E>(executor, pass)?;
        self.read(device, &filmed)
    }

    fn texels<D: Device>(self, device: &D) -> std::result::Result<Buffer<D>, RenderError> {
        device
            .holding("stage.texels", self.stage.texels)
            .map_err(failed)
    }

    fn arg<D: Device>(self, texels: &Buffer<D>) -> StageArg<'_, D::Memory> {
        StageArg {
            params: self.stage.params,
            texels: D::Memory::slice(texels, 0..self.stage.texels.len()),
        }
    }

    fn room<D: Device>(self, device: &D) -> std::result::Result<Buffer<D>, RenderError> {
        device.zeroed("pixels", self.count as usize).map_err(failed)
    }

    fn out<D: Device>(self, room: &mut Buffer<D>) -> <D::Memory as Memory>::Chunks<'_, Vec4> {
        D::Memory::chunks(room, 0..self.count as usize, 1)
    }

    fn run<D: Device, E: Executor<Memory = D::Memory>>(
        self,
        executor: &mut E,
        pass: impl Pass<Memory = D::Memory>,
    ) -> std::result::Result<(), RenderError> {
        executor.run(pass, 0..self.count).map_err(failed)
    }

    fn read<D: Device>(
        self,
        device: &D,
        pixels: &Buffer<D>,
    ) -> std::result::Result<Vec<Vec4>, RenderError> {
        device.get(pixels, self.count as usize).map_err(failed)
    }
}

type Buffer<D> = <<D as Device>::Memory as Memory>::Buffer<Vec4>;

fn failed<E: std::error::Error + Send + Sync + 'static>(error: E) -> RenderError {
    RenderError::Device(Box::new(error))
}
