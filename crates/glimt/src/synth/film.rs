//! Host file: filming: the kernels of a simulated capture, on the CPU or the GPU.

use super::geometry::{FrameTruth, capture_params, plate_camera, truth_of};
use super::settings::Synth;
use super::world::{Base, World};
use crate::device::{self, Processor};
use crate::error::Result;
use glam::{UVec2, Vec3, Vec4};
use glimt_render_gpu::entry::Entry;
use glimt_render_gpu::generated::{EXPOSE, FILM_BALL, FILM_LATLONG, FILM_PLATE};
use glimt_render_gpu::gpu::{Arg, GpuContext, GpuError};
use glimt_render_gpu::host::render::{FrameImage, RenderError, RenderSettings};
use glimt_render_gpu::kernels::capture::{LatLongParams, film_ball, film_latlong, film_plate};
use glimt_render_gpu::kernels::film::tonemap;
use glimt_render_gpu::kernels::frame::FrameParams;
use glimt_render_gpu::kernels::sensor::{SensorParams, expose};
use glimt_render_gpu::kernels::stage::Stage;
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
        let pixels = match processor {
            Processor::Cpu => {
                let filmed = on_threads(count, |i| film_ball(i, &capture, stage));
                match sensor.exposures {
                    0 => filmed,
                    _ => on_threads(count, |i| expose(i, &sensor, &filmed)),
                }
            }
            Processor::Gpu(gpu) => on_gpu(|| {
                let filmed = buffer(gpu, "radiance", count)?;
                let param = ("capture", Arg::Value(bytemuck::bytes_of(&capture)));
                launch(gpu, &FILM_BALL, param, stage, &filmed, count)?;
                let exposed = buffer(gpu, "exposed", count)?;
                let args = [
                    ("sensor", Arg::Value(bytemuck::bytes_of(&sensor))),
                    ("radiance", Arg::Buffer(&filmed)),
                    ("out", Arg::Buffer(&exposed)),
                ];
                gpu.launch(&EXPOSE, &args, 0, count)?;
                gpu.read(&exposed, count as usize)
            })?,
        };
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
        let linear = match processor {
            Processor::Cpu => on_threads(count, |i| film_plate(i, &params, stage)),
            Processor::Gpu(gpu) => on_gpu(|| {
                let out = buffer(gpu, "plate", count)?;
                let param = ("frame", Arg::Value(bytemuck::bytes_of(&params)));
                launch(gpu, &FILM_PLATE, param, stage, &out, count)?;
                gpu.read(&out, count as usize)
            })?,
        };
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
        match processor {
            Processor::Cpu => Ok(on_threads(count, |i| film_latlong(i, &params, stage))),
            Processor::Gpu(gpu) => on_gpu(|| {
                let out = buffer(gpu, "truth", count)?;
                let param = ("latlong", Arg::Value(bytemuck::bytes_of(&params)));
                launch(gpu, &FILM_LATLONG, param, stage, &out, count)?;
                gpu.read(&out, count as usize)
            }),
        }
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

/// Elements `0..count`, computed by all threads.
fn on_threads(count: u32, element: impl Fn(u32) -> Vec4 + Send + Sync) -> Vec<Vec4> {
    (0..count)
        .into_par_iter()
        .with_min_len(64)
        .map(element)
        .collect()
}

fn on_gpu<T>(work: impl FnOnce() -> std::result::Result<T, GpuError>) -> Result<T> {
    work().map_err(|e| device::failure(RenderError::Device(Box::new(e))))
}

fn buffer(
    gpu: &GpuContext,
    label: &str,
    count: u32,
) -> std::result::Result<glimt_render_gpu::gpu::GpuBuffer, GpuError> {
    gpu.buffer(label, u64::from(count) * size_of::<Vec4>() as u64)
}

/// Runs a kernel that looks at a stage.
fn launch(
    gpu: &GpuContext,
    entry: &Entry,
    param: (&'static str, Arg<'_>),
    stage: Stage<'_>,
    out: &glimt_render_gpu::gpu::GpuBuffer,
    count: u32,
) -> std::result::Result<(), GpuError> {
    let texels = gpu.buffer_of("stage.texels", stage.texels)?;
    let args = [
        param,
        (
            "stage.params",
            Arg::Value(bytemuck::bytes_of(&stage.params)),
        ),
        ("stage.texels", Arg::Buffer(&texels)),
        ("out", Arg::Buffer(out)),
    ];
    gpu.launch(entry, &args, 0, count).map(drop)
}
