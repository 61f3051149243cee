//! Host file: the sequential sampler (Kronander 2014, Eqs. 5 to 8), and what it keeps from frame to frame on any device.

use std::ops::Range;

use glam::{Mat4, UVec2, Vec2, Vec4};
use glimt_executor::gpu::Gpu;
use glimt_executor::{Device, Entry, Executor, Memory, Pass};
use glimt_sampling::resample::Scheme;
use glimt_sampling::warp::cap_height;
use glimt_smc::{Particle, Path};

use super::{CandidateSource, Inputs, KeptBytes};
use crate::film::SamplesOut;
use crate::generated::passes::{
    AdvanceSmc, DiagnoseSmc, FindSmc, GatherSmc, GatherSmcLayers, PastArg, RadianceMapArg,
};
use crate::kernels::camera::CameraView;
use crate::kernels::environment::RadianceMap;
use crate::kernels::frame::FrameParams;
use crate::kernels::past::{PastView, RayState};
use crate::kernels::smc::{SmcHealth, SmcParams};
use crate::kernels::smc_point::SmcPoint;
use crate::prepare::env::PreparedEnv;
use crate::prepare::light_change::LightBefore;
use crate::prepare::past_frame::PastFrame;
use crate::prepare::render::{RenderError, RenderSettings};
use crate::prepare::scene_build::SceneBuffers;
use crate::prepare::smc_state::{SmcKey, SmcState};
use crate::settings::{any, at_most, between, settings};

settings! {
    /// Sequential Monte Carlo: particles of each ray are led from the light of the frame before to that of this one.
    Smc in "smc" {
        /// Particles N on each ray, each with a shadow ray.
        particles: u32 = 8, between(1, 4096), "8 is usual";
        /// Distributions K between two frames.
        intermediate: u32 = 3, at_most(1000), "3 is usual";
        /// How those are mixed of both frames'.
        #[serde(with = "crate::words")]
        path: Path = Path::Linear, any, "";
        /// How particles are resampled.
        #[serde(with = "crate::words")]
        resampling: Scheme = Scheme::Systematic, any, "";
        /// Share of N below which the effective sample size calls for that; 0 for never.
        ess_threshold: f32 = 2.0 / 3.0, between(0.0, 2.0), "0.67 is usual, 0 for never";
        /// ε: what the target adds to the light's luminance, as a share of the map's mean. 0, as in the paper, loses light that
        /// moves onto what was black.
        floor: f32 = 0.01, between(0.0, 1e6), "0.01 is usual";
        /// Angular radius of the cap of local moves, in degrees, above 0.
        cap_deg: f32 = 5.0, is_cap, "5 is usual";
        /// ν: probability of a local move.
        cap_share: f32 = 0.5, between(0.0, 1.0), "0.5 is usual";
        /// Of the independent draws, the share that comes from the light and not from the BRDF.
        light_share: f32 = 0.5, between(0.0, 1.0), "0.5 is usual";
        /// A ray is re-initialised every so many frames, rays in turns, and particles that pass from ray to ray at this age at the
        /// latest; 0 for never.
        max_age: u32 = 8, any, "8 is usual, 0 for never";
        /// All rays are re-initialised where more than this share of the light moved since the frame before: half the integral of
        /// the difference between both maps' luminances, each scaled to an integral of 1. 0 where anything moved, 1 for never.
        max_change: f32 = 0.2, between(0.0, 1.0), "0.2 is usual, 1 for never";
        /// *Biased*, for comparison: a ray is also re-initialised where its normaliser grows or shrinks by more than this factor in a
        /// frame, or all weights are 0; at least 1. 0 for never.
        reinitialise: f32 = 0.0, is_factor, "0 has no bias, 1.25 is what the preset \"kronander\" takes";
        /// Candidates M of a start.
        candidates: u32 = 64, between(1, 65_536), "64 is usual";
        /// Where those come from; not the environment alone, which misses where the floor is all there is.
        #[serde(with = "crate::words")]
        source: CandidateSource = CandidateSource::Mixture, covers, "take \"brdf\" or \"mixture\"";
        /// How far off the surface that was seen in the frame before a point may lie to be found there, as a share of its
        /// distance.
        depth_tolerance: f32 = 0.02, between(0.0, f32::MAX), "0.02 is usual";
        /// The greatest angle between its normal there and here, in degrees.
        normal_tolerance_deg: f32 = 25.0, between(0.0, 180.0), "25 is usual";
    }
}

fn is_cap(degrees: &f32) -> Option<String> {
    let fits = *degrees > 0.0 && *degrees <= 180.0;
    (!fits).then(|| "it is not between 0 and 180".to_owned())
}

fn is_factor(factor: &f32) -> Option<String> {
    let fits = *factor == 0.0 || (*factor >= 1.0 && *factor <= 1e30);
    (!fits).then(|| "it is a factor below 1".to_owned())
}

fn covers(source: &CandidateSource) -> Option<String> {
    (*source == CandidateSource::Environment).then(|| {
        "the light alone misses directions where it is black and the target is not".to_owned()
    })
}

impl Smc {
    /// What kernels read, under lights of these mean luminances, of whose light the share `change` moved.
    #[must_use]
    pub fn params(&self, mean: f32, previous_mean: f32, change: f32) -> SmcParams {
        SmcParams {
            intermediate: self.intermediate,
            path: self.path,
            scheme: self.resampling,
            ess_threshold: self.ess_threshold,
            floor: self.floor * mean,
            previous_floor: self.floor * previous_mean,
            cap_height: cap_height(self.cap_deg.to_radians()),
            cap_share: self.cap_share,
            light_share: self.light_share,
            // 1 means at every frame, which a logarithm of 0 would not.
            band: if self.reinitialise == 0.0 {
                0.0
            } else {
                self.reinitialise.ln().max(f32::MIN_POSITIVE)
            },
            max_age: self.max_age,
            candidates: self.candidates,
            source: self.source,
            changed: u32::from(change > self.max_change),
            unused_a: 0,
            unused_b: 0,
        }
    }

    /// From where the frame before was seen, with `pixels` pixels' rays available from `first_pixel` on.
    #[must_use]
    pub fn past_view(&self, view: &CameraView, first_pixel: u32, pixels: u32) -> PastView {
        PastView {
            eye: view.eye,
            first_pixel,
            forward: view.forward,
            pixels,
            right: view.right,
            depth_tolerance: self.depth_tolerance,
            up: view.up,
            normal_cosine: self.normal_tolerance_deg.to_radians().cos(),
        }
    }

    /// The counts on a ray, and a bias that comes from the settings, in words.
    pub(super) fn describe(&self) -> String {
        let biased = match self.reinitialise > 0.0 {
            true => " (biased: re-initialised by the normaliser's ratio)",
            false => "",
        };
        format!("N = {}{biased}", self.particles)
    }

    /// Bytes of a ray in the larger of the buffers that are kept.
    pub(super) fn bytes_kept(&self) -> u64 {
        let particles = u64::from(self.particles) * size_of::<Particle>() as u64;
        particles.max(size_of::<RayState>() as u64)
    }

    /// What the method keeps of a frame with `rays` rays.
    pub(super) fn kept_bytes(&self, rays: u64) -> KeptBytes {
        let particles = u64::from(self.particles) * size_of::<Particle>() as u64;
        KeptBytes {
            largest: rays * self.bytes_kept(),
            all: rays * (particles + size_of::<RayState>() as u64),
        }
    }

    /// Counts that the cost of a ray depends on: a first frame leads no particles.
    pub(super) fn cost(&self, has_past: bool) -> [u32; 3] {
        let steps = if has_past { self.intermediate + 1 } else { 0 };
        [self.particles, self.candidates, steps]
    }
}

/// The entries of the first passes.
pub(super) fn entries() -> Vec<&'static Entry> {
    vec![
        FindSmc::<Gpu>::entry(),
        AdvanceSmc::<Gpu>::entry(),
        GatherSmc::<Gpu>::entry(),
        GatherSmcLayers::<Gpu>::entry(),
    ]
}

/// Tiles begin at multiples of so many pixels: then what their rays keep begins at multiples of 256 bytes, the most that an
/// adapter asks for.
pub(crate) const TILE_GRANULE: u32 = 16;

/// Passes of a tile.
pub(super) const PASSES: u32 = 3;

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
    /// The same for the host: as long as there is no frame before, of the one that renders.
    light_before: LightBefore,
    motions: M::Buffer<Mat4>,
    /// What kernels read in this frame.
    params: SmcParams,
    settings: Smc,
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
        own: &Smc,
    ) -> Result<Self, RenderError> {
        let key = SmcKey::new(settings, own, scene);
        let now = env.view();
        let mean = env.mean_luminance();
        let view = settings.view()?;
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
                light_before: LightBefore::new(now.map()),
                params: own.params(mean, mean, 0.0),
                settings: *own,
                view,
                light_size: now.size,
                light_rotation: now.rotation,
            },
        };
        made.settings = *own;
        match &made.past {
            Some(past) => {
                let change = made.light_before.change(now.map());
                made.params = own.params(mean, past.light_mean, change);
                made.view = past.view;
                made.light_size = past.light_size;
                made.light_rotation = past.light_rotation;
                let motions = past.motions(scene);
                device.put(&mut made.motions, &motions).map_err(failed)?;
            }
            None => {
                made.params = own.params(mean, mean, 0.0);
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
        out: M::Chunks<'_, SmcHealth>,
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

    /// This frame, lit by `light`, becomes the frame before, once its light is in [`Following::light_mut`].
    pub(crate) fn end(&mut self, past: PastFrame, light: RadianceMap<'_>) {
        std::mem::swap(&mut self.before, &mut self.now);
        self.light_before = LightBefore::new(light);
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
            key: self.key,
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
        let key = state.key;
        Ok(Self {
            key,
            before: Rays {
                states: device.holding("the rays' states", &state.rays)?,
                particles: device.holding("the particles", &state.particles)?,
            },
            now: Rays::new(device, &key)?,
            light: device.holding("before.texels", &state.light)?,
            motions: device.holding("past.motions", &state.past.transforms)?,
            light_before: LightBefore::new(state.light()),
            params: Smc::default().params(0.0, 0.0, 0.0),
            settings: Smc::default(),
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
