//! Host file: the sequential sampler (Kronander 2014, Eqs. 5 to 8), and what it keeps from frame to frame on any device.

use std::ops::Range;

use glam::{Mat4, UVec2, Vec2, Vec4};
use glimt_executor::{Device, Executor, Memory};
use glimt_smc::Particle;

use super::Inputs;
use crate::film::SamplesOut;
use crate::generated::passes::{
    AdvanceSmc, DiagnoseSmc, FindSmc, GatherSmc, GatherSmcLayers, PastArg, RadianceMapArg,
};
use crate::host::env::PreparedEnv;
use crate::host::render::{RenderError, RenderSettings, SmcSettings};
use crate::host::scene_build::SceneBuffers;
use crate::host::smc_state::{PastFrame, SmcKey, SmcState};
use crate::kernels::camera::CameraView;
use crate::kernels::frame::FrameParams;
use crate::kernels::past::{PastView, RayState};
use crate::kernels::smc::SmcParams;
use crate::kernels::smc_point::SmcPoint;

/// Tiles begin at multiples of so many pixels: then what their rays keep begins at multiples of 256 bytes, the most that an
/// adapter asks for.
pub(crate) const TILE_GRANULE: u32 = 16;

/// Passes of a tile.
pub(crate) const PASSES: u32 = 3;

/// What the rays of a frame keep.
pub(crate) struct Rays<M: Memory> {
    pub(crate) states: M::Buffer<RayState>,
    pub(crate) particles: M::Buffer<Particle>,
}

/// The rays of the frame before and of the one that renders.
pub(crate) struct Following<M: Memory> {
    key: SmcKey,
    /// The frame before, once there is one.
    past: Option<PastFrame>,
    before: Rays<M>,
    /// Of this frame.
    pub(crate) now: Rays<M>,
    /// Light of the frame before.
    light: M::Buffer<Vec4>,
    motions: M::Buffer<Mat4>,
    /// What kernels read in this frame.
    params: SmcParams,
    settings: SmcSettings,
    view: CameraView,
    light_size: UVec2,
    light_rotation: Vec2,
}

/// What one tile reads of the frame before and keeps for the next one.
pub(crate) struct Tile<'a, M: Memory> {
    params: &'a SmcParams,
    view: &'a PastView,
    before: RadianceMapArg<'a, M>,
    past: PastArg<'a, M>,
    past_particles: M::Slice<'a, Particle>,
    particles_per_ray: u32,
    /// What goes from pass to pass.
    points: M::Chunks<'a, SmcPoint>,
    own: Own<'a, M>,
}

/// What a tile's rays keep, to be written.
pub(crate) struct Own<'a, M: Memory> {
    pub(crate) states: M::Chunks<'a, RayState>,
    pub(crate) particles: M::Chunks<'a, Particle>,
}

impl<M: Memory> std::fmt::Debug for Following<M> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Following")
            .field("key", &self.key)
            .finish_non_exhaustive()
    }
}

impl<M: Memory> Tile<'_, M> {
    /// All passes of the tile, [`PASSES`] of them.
    pub(super) fn shade<E: Executor<Memory = M>>(
        mut self,
        executor: &mut E,
        inputs: Inputs<'_, M>,
        rays: u32,
        out: SamplesOut<'_, M>,
    ) -> Result<(), E::Error> {
        let Inputs { frame, env, scene } = inputs;
        let pass = FindSmc {
            frame,
            view: self.view,
            scene: scene.shorten(),
            past: self.past.shorten(),
            out: M::reborrow(&mut self.points),
        };
        executor.run(pass, 0..rays)?;
        let pass = AdvanceSmc {
            frame,
            smc: self.params,
            env: env.shorten(),
            before: self.before.shorten(),
            points: M::filled(&self.points),
            past_particles: M::shorten(self.past_particles),
            state: M::reborrow(&mut self.own.states),
            particles: M::reborrow(&mut self.own.particles),
        };
        executor.run(pass, 0..rays)?;
        let (floor, particles_per_ray) = (self.params.floor, self.particles_per_ray);
        let (env, scene) = (env.shorten(), scene.shorten());
        let points = M::filled(&self.points);
        let states = M::filled(&self.own.states);
        let particles = M::filled(&self.own.particles);
        match out {
            SamplesOut::Flat(out) => executor.run(
                GatherSmc {
                    frame,
                    floor,
                    particles_per_ray,
                    env,
                    scene,
                    points,
                    states,
                    particles,
                    out: M::shorten_chunks(out),
                },
                0..rays,
            ),
            SamplesOut::Layered(out) => executor.run(
                GatherSmcLayers {
                    floor,
                    particles_per_ray,
                    env,
                    scene,
                    points,
                    states,
                    particles,
                    out: M::shorten_chunks(out),
                },
                0..rays,
            ),
        }
    }
}

impl<M: Memory> Rays<M> {
    fn new<D: Device<Memory = M>>(device: &D, key: &SmcKey) -> Result<Self, D::Error> {
        let rays = key.rays();
        Ok(Self {
            states: device.zeroed("the rays' states", rays)?,
            particles: device.zeroed("the particles", rays * key.particles as usize)?,
        })
    }
}

impl<M: Memory> Following<M> {
    /// Continues from `known` where the frame that is to come can, else starts.
    pub(crate) fn begin<D: Device<Memory = M>>(
        known: Option<Self>,
        device: &D,
        scene: &SceneBuffers,
        env: &PreparedEnv,
        settings: &RenderSettings,
    ) -> Result<Self, RenderError> {
        let key = SmcKey::new(settings, scene);
        let now = env.view();
        let mean = env.mean_luminance();
        let view = settings.camera.view(settings.size)?;
        let failed = RenderError::device::<D::Error>;
        let mut made = match known.filter(|known| known.key == key) {
            Some(known) => known,
            None => Self {
                key,
                past: None,
                before: Rays::new(device, &key).map_err(failed)?,
                now: Rays::new(device, &key).map_err(failed)?,
                light: device
                    .holding("before.texels", now.texels)
                    .map_err(failed)?,
                motions: device
                    .holding(
                        "past.motions",
                        &vec![Mat4::IDENTITY; scene.transforms().len()],
                    )
                    .map_err(failed)?,
                params: settings.smc.params(mean, mean)?,
                settings: settings.smc,
                view,
                light_size: now.size,
                light_rotation: now.rotation,
            },
        };
        made.settings = settings.smc;
        match &made.past {
            Some(past) => {
                made.params = settings.smc.params(mean, past.light_mean)?;
                made.view = past.view;
                made.light_size = past.light_size;
                made.light_rotation = past.light_rotation;
                let motions = past.motions(scene);
                device.put(&mut made.motions, &motions).map_err(failed)?;
            }
            None => {
                made.params = settings.smc.params(mean, mean)?;
                made.view = view;
            }
        }
        Ok(made)
    }

    /// Particles on each ray.
    pub(crate) fn particles(&self) -> u32 {
        self.key.particles
    }

    /// Whether there is a frame before.
    pub(crate) fn has_past(&self) -> bool {
        self.past.is_some()
    }

    /// The part of the frame before that the tile `first .. first + count` can look into: all of it where `fitting` pixels are
    /// enough for that.
    pub(crate) fn window(&self, fitting: u64, first: u32, count: u32) -> PastView {
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

    /// What the frame that renders keeps, to be written, and what its tiles read.
    pub(crate) fn parts(&mut self) -> (&mut Rays<M>, Reading<'_, M>) {
        let reading = Reading {
            key: &self.key,
            params: &self.params,
            light: RadianceMapArg {
                texels: M::slice(&self.light, 0..self.light_size.element_product() as usize),
                size: self.light_size,
                rotation: self.light_rotation,
            },
            motions: M::slice(&self.motions, 0..self.key.objects.max(1) as usize),
            before: &self.before,
        };
        (&mut self.now, reading)
    }

    /// How the particles of a tile fare, whose states are values `rays` of those of this frame.
    pub(crate) fn diagnose<E: Executor<Memory = M>>(
        &self,
        executor: &mut E,
        frame: &FrameParams,
        rays: Range<usize>,
        out: M::Chunks<'_, Vec4>,
        count: u32,
    ) -> Result<(), E::Error> {
        let pass = DiagnoseSmc {
            frame,
            states: M::slice(&self.now.states, rays),
            particles_per_ray: self.key.particles,
            out: M::shorten_chunks(out),
        };
        executor.run(pass, 0..count)
    }

    /// Where the light of the frame that renders is to be, when it becomes the frame before.
    pub(crate) fn light_mut(&mut self) -> &mut M::Buffer<Vec4> {
        &mut self.light
    }

    /// This frame becomes the frame before, once its light is in [`Following::light_mut`].
    pub(crate) fn end(&mut self, past: PastFrame) {
        std::mem::swap(&mut self.before, &mut self.now);
        self.past = Some(past);
    }

    /// Forgets what rays that hit nothing left from two frames before, so that what is saved depends on the frame alone.
    pub(crate) fn clear<D: Device<Memory = M>>(&mut self, device: &D) -> Result<(), D::Error> {
        self.now = Rays::new(device, &self.key)?;
        Ok(())
    }

    /// The frame before, copied.
    pub(crate) fn read<D: Device<Memory = M>>(
        &self,
        device: &D,
    ) -> Result<Option<SmcState>, D::Error> {
        let Some(past) = &self.past else {
            return Ok(None);
        };
        let rays = self.key.rays();
        let texels = past.light_size.element_product() as usize;
        Ok(Some(SmcState {
            past: past.clone(),
            light: device.get(&self.light, texels)?,
            rays: device.get(&self.before.states, rays)?,
            particles: device.get(&self.before.particles, rays * self.key.particles as usize)?,
        }))
    }

    /// A frame before, from the host.
    pub(crate) fn resume<D: Device<Memory = M>>(
        device: &D,
        state: SmcState,
    ) -> Result<Self, D::Error> {
        let key = state.past.key;
        Ok(Self {
            key,
            before: Rays {
                states: device.holding("the rays' states", &state.rays)?,
                particles: device.holding("the particles", &state.particles)?,
            },
            now: Rays::new(device, &key)?,
            light: device.holding("before.texels", &state.light)?,
            motions: device.holding("past.motions", &state.past.transforms)?,
            params: bytemuck::Zeroable::zeroed(),
            settings: SmcSettings::default(),
            view: state.past.view,
            light_size: state.past.light_size,
            light_rotation: state.past.light_rotation,
            past: Some(state.past),
        })
    }
}

/// What the tiles of a frame read of the frame before.
pub(crate) struct Reading<'a, M: Memory> {
    key: &'a SmcKey,
    params: &'a SmcParams,
    light: RadianceMapArg<'a, M>,
    motions: M::Slice<'a, Mat4>,
    before: &'a Rays<M>,
}

impl<'a, M: Memory> Reading<'a, M> {
    /// For a tile of `count` pixels that sees the frame before through `view`, and keeps `own`. Its passes meet in `points`, one
    /// for each ray.
    pub(crate) fn tile<'b>(
        &self,
        view: &'b PastView,
        count: u32,
        points: M::Chunks<'b, SmcPoint>,
        own: Own<'b, M>,
    ) -> Tile<'b, M>
    where
        'a: 'b,
    {
        let rays = self.key.rays_per_pixel as usize;
        let first = view.first_pixel as usize * rays;
        let bound = view.pixels.max(count.min(TILE_GRANULE)) as usize * rays;
        let n = self.key.particles as usize;
        Tile {
            params: self.params,
            view,
            before: self.light.shorten(),
            past: PastArg {
                motions: M::shorten(self.motions),
                states: M::slice(&self.before.states, first..first + bound),
            },
            past_particles: M::slice(&self.before.particles, first * n..(first + bound) * n),
            particles_per_ray: self.key.particles,
            points,
            own,
        }
    }
}
