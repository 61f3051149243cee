//! Host file: the sequential sampler's rays on the GPU, which stay there from frame to frame.

use glam::{Mat4, UVec2, Vec2, Vec4};
use glimt_smc::Particle;

use super::buffer::GpuBuffer;
use super::device::GpuContext;
use super::error::GpuError;
use super::launch::Arg;
use super::upload::GpuEnv;
use crate::host::env::PreparedEnv;
use crate::host::render::{RenderError, RenderSettings, SmcSettings};
use crate::host::scene_build::SceneBuffers;
use crate::host::smc_state::{PastFrame, SmcKey, SmcState};
use crate::kernels::camera::CameraView;
use crate::kernels::frame::FrameParams;
use crate::kernels::past::{PastView, RayState};
use crate::kernels::smc::SmcParams;

/// Tiles begin at multiples of so many pixels: then what their rays keep begins at multiples of 256 bytes, the most that an
/// adapter asks for.
pub(super) const TILE_GRANULE: u32 = 16;

/// The rays of a frame.
#[derive(Debug)]
struct Rays {
    states: GpuBuffer,
    particles: GpuBuffer,
}

/// The rays of the frame before and of the one that renders.
#[derive(Debug)]
pub(super) struct GpuSmc {
    key: SmcKey,
    /// The frame before, once there is one.
    past: Option<PastFrame>,
    /// Of the frame before, and of this one.
    rays: [Rays; 2],
    /// Light of the frame before.
    light: GpuBuffer,
    motions: GpuBuffer,
    /// What kernels read in this frame.
    params: SmcParams,
    settings: SmcSettings,
    view: CameraView,
    light_size: UVec2,
    light_rotation: Vec2,
}

impl Rays {
    fn new(context: &GpuContext, key: &SmcKey) -> Result<Self, GpuError> {
        let rays = u64::from(key.size.x) * u64::from(key.size.y) * u64::from(key.rays_per_pixel);
        let sets = rays * u64::from(key.particles);
        Ok(Self {
            states: context.buffer("the rays' states", rays * size_of::<RayState>() as u64)?,
            particles: context.buffer("the particles", sets * size_of::<Particle>() as u64)?,
        })
    }
}

/// A plain value's bytes.
fn value<T: bytemuck::NoUninit>(value: &T) -> Arg<'_> {
    Arg::Value(bytemuck::bytes_of(value))
}

impl GpuSmc {
    /// Gets ready for a frame: goes on from `known`, or starts.
    pub(super) fn begin(
        known: Option<Self>,
        context: &GpuContext,
        scene: &SceneBuffers,
        env: &PreparedEnv,
        settings: &RenderSettings,
    ) -> Result<Self, RenderError> {
        let key = SmcKey::new(settings, scene);
        let now = env.view();
        let mean = env.mean_luminance();
        let view = settings.camera.view(settings.size)?;
        let device = super::renderer::device;
        let mut smc = match known.filter(|known| known.key == key) {
            Some(known) => known,
            None => Self {
                key,
                past: None,
                rays: [
                    Rays::new(context, &key).map_err(device)?,
                    Rays::new(context, &key).map_err(device)?,
                ],
                light: context
                    .buffer_of("before.texels", now.texels)
                    .map_err(device)?,
                motions: context
                    .buffer_of(
                        "past.motions",
                        &vec![Mat4::IDENTITY; scene.transforms().len()],
                    )
                    .map_err(device)?,
                params: settings.smc.params(mean, mean)?,
                settings: settings.smc,
                view,
                light_size: now.cdf.size,
                light_rotation: now.rotation,
            },
        };
        smc.settings = settings.smc;
        match &smc.past {
            Some(past) => {
                smc.params = settings.smc.params(mean, past.light_mean)?;
                smc.view = past.view;
                smc.light_size = past.light_size;
                smc.light_rotation = past.light_rotation;
                let motions = past.motions(scene);
                context.write(&smc.motions, &motions).map_err(device)?;
            }
            None => {
                smc.params = settings.smc.params(mean, mean)?;
                smc.view = view;
            }
        }
        Ok(smc)
    }

    /// Whether there is a frame before.
    pub(super) fn has_past(&self) -> bool {
        self.past.is_some()
    }

    /// Pixels whose rays a binding holds.
    pub(super) fn fitting_pixels(context: &GpuContext, settings: &RenderSettings) -> u64 {
        let set = u64::from(settings.smc.particles) * size_of::<Particle>() as u64;
        let ray = set.max(size_of::<RayState>() as u64);
        context.max_binding_bytes() / (ray * u64::from(settings.rays_per_pixel))
    }

    /// The part of the frame before that the tile `first .. first + count` can look into: all of it where it fits a binding.
    pub(super) fn window(&self, fitting: u64, first: u32, count: u32) -> PastView {
        let pixels = self.key.size.element_product();
        let (from, to) = if u64::from(pixels) <= fitting {
            (0, pixels)
        } else {
            let spare = (fitting as u32).saturating_sub(count) / 2;
            let margin = spare / TILE_GRANULE * TILE_GRANULE;
            let end = first.saturating_add(count).saturating_add(margin);
            (first.saturating_sub(margin), end.min(pixels))
        };
        let there = if self.past.is_some() { to - from } else { 0 };
        let mut view = self.settings.past_view(&self.view, from, there);
        // Without a frame before, something has to be bound all the same.
        if self.past.is_none() {
            view.first_pixel = from;
        }
        view
    }

    /// The arguments of `shade_smc` beside those of every method.
    pub(super) fn args<'a>(
        &'a self,
        frame: &FrameParams,
        view: &'a PastView,
        count: u32,
    ) -> Vec<(&'static str, Arg<'a>)> {
        let rays = frame.rays_per_pixel;
        let [before, now] = &self.rays;
        let first = view.first_pixel * rays;
        let bound = view.pixels.max(count.min(TILE_GRANULE)) * rays;
        let n = self.key.particles;
        let ray = frame.first_pixel * rays;
        vec![
            ("smc", value(&self.params)),
            ("view", value(view)),
            ("before.size", value(&self.light_size)),
            ("before.rotation", value(&self.light_rotation)),
            ("before.texels", Arg::Buffer(&self.light)),
            ("past.motions", Arg::Buffer(&self.motions)),
            ("past.states", Arg::Window(&before.states, first, bound)),
            (
                "past.particles",
                Arg::Window(&before.particles, first * n, bound * n),
            ),
            ("state", Arg::ChunkFrom(&now.states, 1, ray)),
            ("particles", Arg::ChunkFrom(&now.particles, n, ray)),
        ]
    }

    /// The arguments of `diagnose_smc` beside `frame` and `out`.
    pub(super) fn diagnose_args(
        &self,
        frame: &FrameParams,
        count: u32,
    ) -> [(&'static str, Arg<'_>); 2] {
        let rays = frame.rays_per_pixel;
        let window = Arg::Window(&self.rays[1].states, frame.first_pixel * rays, count * rays);
        [
            ("states", window),
            ("particles_per_ray", value(&self.key.particles)),
        ]
    }

    /// This frame becomes the frame before.
    pub(super) fn end(
        &mut self,
        context: &GpuContext,
        env: &GpuEnv,
        past: PastFrame,
    ) -> Result<(), GpuError> {
        let texels = env.texels();
        if self.light.len() != texels.len() {
            self.light = context.buffer("before.texels", texels.len())?;
        }
        context.copy(texels, &self.light, texels.len())?;
        self.rays.swap(0, 1);
        self.past = Some(past);
        Ok(())
    }

    /// The frame before, copied back.
    pub(super) fn read(&self, context: &GpuContext) -> Result<Option<SmcState>, GpuError> {
        let Some(past) = &self.past else {
            return Ok(None);
        };
        let rays = self.key.size.element_product() as usize * self.key.rays_per_pixel as usize;
        let texels = self.light.len() as usize / size_of::<Vec4>();
        Ok(Some(SmcState {
            past: past.clone(),
            light: context.read(&self.light, texels)?,
            rays: context.read(&self.rays[0].states, rays)?,
            particles: context.read(&self.rays[0].particles, rays * self.key.particles as usize)?,
        }))
    }

    /// A frame before, from the host.
    pub(super) fn upload(context: &GpuContext, state: SmcState) -> Result<Self, GpuError> {
        let key = state.past.key;
        let before = Rays {
            states: context.buffer_of("the rays' states", &state.rays)?,
            particles: context.buffer_of("the particles", &state.particles)?,
        };
        Ok(Self {
            key,
            rays: [before, Rays::new(context, &key)?],
            light: context.buffer_of("before.texels", &state.light)?,
            motions: context.buffer_of("past.motions", &state.past.transforms)?,
            params: bytemuck::Zeroable::zeroed(),
            settings: SmcSettings::default(),
            view: state.past.view,
            light_size: state.past.light_size,
            light_rotation: state.past.light_rotation,
            past: Some(state.past),
        })
    }
}
