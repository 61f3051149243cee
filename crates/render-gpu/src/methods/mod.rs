//! Host file: the ways to estimate reflected light. Each is one file: its settings, its passes, and what it keeps of a frame.
//!
//! The list of those that keep nothing stands in [`entries`](crate::entries); the macro below makes all of it that is the same
//! for each.

pub mod cells;
mod kept;
pub mod prt;
pub mod smc;

use std::fmt::Debug;

use glimt_executor::gpu::Gpu;
use glimt_executor::{Device, Entry, Executor, Memory, Pass};

use crate::film::SamplesOut;
use crate::generated::passes::{self, DiagnoseGroups, EnvironmentArg, SceneArg, See};
use crate::kernels::frame::FrameParams;
use crate::kernels::group_health::GroupHealth;
use crate::kernels::seen::SeenPoint;
use crate::kernels::smc_point::SmcPoint;
use crate::settings::SettingError;

pub use crate::kernels::candidates::CandidateSource;
pub use cells::Cells;
pub(crate) use kept::Kept;
pub use kept::{KeptBytes, MethodMemory};
pub use prt::Prt;
pub use smc::Smc;

/// What each method without memory says of its settings.
trait Memoryless: Copy + Debug + PartialEq {
    /// What its estimator is in kernels.
    type Params;

    /// Checks the settings, each by itself and together.
    fn check_all(&self) -> Result<(), SettingError>;

    /// What kernels read.
    fn params(&self) -> Self::Params;

    /// Whether it reads a table of the light, by the table's name.
    fn reads(&self, table: &str) -> bool {
        table == CDF
    }

    /// The most samples that a ray takes for one purpose.
    fn samples_per_ray(&self) -> u32;

    /// Counts that the cost of a ray depends on.
    fn cost(&self) -> [u32; 2];

    /// What more time buys on a ray: the count as it is.
    fn count(&self) -> u32;

    /// The keys, below `render`, that give another count, with their values.
    fn with_count(&self, count: u32) -> Vec<(&'static str, u32)>;

    /// The counts in words.
    fn describe(&self) -> String;
}

/// Name of the tables that draw directions in proportion to a light's luminance.
pub(crate) const CDF: &str = "cdf";

/// Name of the table of a light's cells.
pub(crate) const LIGHT_CELLS: &str = "light cells";

/// The most of any count.
const MOST: u32 = 65_536;

/// `other` in the proportion that it has to `own`, where that becomes `count`. What there was of it stays.
fn scaled(other: u32, count: u32, own: u32) -> u32 {
    let n = f64::from(count) * f64::from(other) / f64::from(own.max(1));
    (n.round() as u32).clamp(other.min(1), MOST)
}

/// What the rays of a tile see, in the memory of an executor.
pub(crate) struct Inputs<'a, M: Memory> {
    /// The tile.
    pub(crate) frame: &'a FrameParams,
    /// The light.
    pub(crate) env: EnvironmentArg<'a, M>,
    /// The scene.
    pub(crate) scene: SceneArg<'a, M>,
}

impl<M: Memory> Clone for Inputs<'_, M> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<M: Memory> Copy for Inputs<'_, M> {}

impl<'a, M: Memory> Inputs<'a, M> {
    /// The same for a shorter time: [`Memory::shorten`].
    pub(crate) fn shorten<'b>(self) -> Inputs<'b, M>
    where
        'a: 'b,
    {
        Inputs {
            frame: self.frame,
            env: self.env.shorten(),
            scene: self.scene.shorten(),
        }
    }
}

/// Where the passes of a method meet, one value for each ray of a tile.
pub(crate) enum Points<M: Memory> {
    /// Of methods of one pass.
    None,
    /// Of methods that estimate a pixel's light at once.
    Seen(M::Buffer<SeenPoint>),
    /// Of [`Method::Smc`].
    Smc(M::Buffer<SmcPoint>),
}

impl<M: Memory> Points<M> {
    /// Room for `rays` rays.
    pub(crate) fn new<D: Device<Memory = M>>(
        device: &D,
        method: &Method,
        rays: usize,
    ) -> Result<Self, D::Error> {
        Ok(match method.way() {
            Way::Rays => Self::None,
            Way::Groups => Self::Seen(device.zeroed("points", rays)?),
            Way::Particles => Self::Smc(device.zeroed("points", rays)?),
        })
    }

    /// Whether they are those of a method.
    pub(crate) fn fit(&self, method: &Method) -> bool {
        matches!(
            (self, method.way()),
            (Self::None, Way::Rays) | (Self::Seen(_), Way::Groups) | (Self::Smc(_), Way::Particles)
        )
    }

    /// Writes how the pixels of a tile fared, where their hits were shaded together.
    pub(crate) fn diagnose<E: Executor<Memory = M>>(
        &self,
        executor: &mut E,
        frame: &FrameParams,
        out: M::Chunks<'_, GroupHealth>,
        pixels: u32,
    ) -> Result<(), E::Error> {
        let Self::Seen(points) = self else {
            return Ok(());
        };
        let rays = pixels as usize * frame.rays_per_pixel as usize;
        let points = M::slice(points, 0..rays);
        let out = M::shorten_chunks(out);
        executor.run(DiagnoseGroups { frame, points, out }, 0..pixels)
    }

    /// What a method without particles takes of a tile's first `rays` rays.
    /// `counted` is what [`Method::Cells`] knows of the frame.
    pub(crate) fn work<'a>(
        &'a mut self,
        counted: Option<cells::Reading<'a, M>>,
        rays: u32,
    ) -> Work<'a, M> {
        match (self, counted) {
            (Self::Seen(points), Some(reading)) => {
                Work::Cells(reading, M::chunks(points, 0..rays as usize, 1))
            }
            (Self::Seen(points), None) => Work::Groups(M::chunks(points, 0..rays as usize, 1)),
            (Self::None | Self::Smc(_), _) => Work::Rays,
        }
    }
}

/// What the passes of a method go over.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Way {
    /// One pass over rays.
    Rays,
    /// One over rays, then one over pixels.
    Groups,
    /// Those of [`Method::Smc`].
    Particles,
}

/// A tile as a method's passes take it, beside what all see of it.
pub(crate) enum Work<'a, M: Memory> {
    /// Each ray by itself.
    Rays,
    /// The hits of a pixel's rays together.
    Groups(M::Chunks<'a, SeenPoint>),
    /// As those, with what is known of the frame.
    Cells(cells::Reading<'a, M>, M::Chunks<'a, SeenPoint>),
    /// With particles.
    Smc(smc::Tile<'a, M>),
}

macro_rules! methods {
    (
        rays { $($ray:ident in $ray_module:ident = $ray_word:literal, $_re:literal, $ray_flat:ident, $ray_layers:ident;)+ }
        groups { $($group:ident in $group_module:ident = $group_word:literal, $_ge:literal, $group_flat:ident, $group_layers:ident;)+ }
    ) => {
        memoryless! {
            $($ray in $ray_module = $ray_word, $ray_flat, $ray_layers;)+
            $($group in $group_module = $group_word, $group_flat, $group_layers;)+
        }

        impl Method {
            /// What its passes go over.
            fn way(&self) -> Way {
                match self {
                    $(Self::$ray(_) => Way::Rays,)+
                    $(Self::$group(_) => Way::Groups,)+
                    Self::Cells(_) => Way::Groups,
                    Self::Smc(_) => Way::Particles,
                }
            }

            /// Pass 1: finds what the first `rays` rays of a tile show.
            pub(crate) fn shade<M: Memory, E: Executor<Memory = M>>(
                &self,
                work: Work<'_, M>,
                executor: &mut E,
                inputs: Inputs<'_, M>,
                rays: u32,
                out: SamplesOut<'_, M>,
            ) -> Result<(), E::Error> {
                let Inputs { frame, env, scene } = inputs.shorten();
                match (self, work, out) {
                    $(
                        (Self::$ray(own), _, SamplesOut::Flat(out)) => {
                            let (estimator, out) = (&own.params(), M::shorten_chunks(out));
                            executor.run(passes::$ray_flat { frame, estimator, env, scene, out }, 0..rays)
                        }
                        (Self::$ray(own), _, SamplesOut::Layered(out)) => {
                            let (estimator, out) = (&own.params(), M::shorten_chunks(out));
                            executor.run(passes::$ray_layers { frame, estimator, env, scene, out }, 0..rays)
                        }
                    )+
                    $(
                        (Self::$group(own), Work::Groups(mut seen), SamplesOut::Flat(out)) => {
                            see(executor, inputs, &mut seen, rays)?;
                            let (per_pixel, pixels) = per_pixel(frame, rays);
                            let points = M::in_chunks_of(M::shorten_chunks(seen), per_pixel);
                            let out = M::in_chunks_of(M::shorten_chunks(out), per_pixel);
                            let own = &own.params();
                            executor.run(passes::$group_flat { frame, $group_module: own, env, scene, points, samples: out }, 0..pixels)
                        }
                        (Self::$group(own), Work::Groups(mut seen), SamplesOut::Layered(out)) => {
                            see(executor, inputs, &mut seen, rays)?;
                            let (per_pixel, pixels) = per_pixel(frame, rays);
                            let points = M::in_chunks_of(M::shorten_chunks(seen), per_pixel);
                            let out = M::in_chunks_of(M::shorten_chunks(out), per_pixel);
                            let own = &own.params();
                            executor.run(passes::$group_layers { frame, $group_module: own, env, scene, points, samples: out }, 0..pixels)
                        }
                        (Self::$group(_), _, _) => unreachable!("points were made for this method"),
                    )+
                    (Self::Cells(_), Work::Cells(reading, points), out) => {
                        reading.shade(executor, inputs, points, rays, out)
                    }
                    (Self::Cells(_), _, _) => unreachable!("what is known was found for this method"),
                    (Self::Smc(_), Work::Smc(tile), out) => tile.shade(executor, inputs, rays, out),
                    (Self::Smc(_), _, _) => unreachable!("a tile of the sequential sampler comes with its rays"),
                }
            }
        }
    };
}

/// Finds what the rays of a tile hit.
fn see<M: Memory, E: Executor<Memory = M>>(
    executor: &mut E,
    inputs: Inputs<'_, M>,
    seen: &mut M::Chunks<'_, SeenPoint>,
    rays: u32,
) -> Result<(), E::Error> {
    let Inputs { frame, scene, .. } = inputs.shorten();
    let out = M::reborrow(seen);
    executor.run(See { frame, scene, out }, 0..rays)
}

/// How many rays a pixel has, and how many pixels have `rays` rays.
fn per_pixel(frame: &FrameParams, rays: u32) -> (usize, u32) {
    let per_pixel = frame.rays_per_pixel;
    (per_pixel as usize, rays / per_pixel)
}

macro_rules! memoryless {
    ($($settings:ident in $module:ident = $word:literal, $flat:ident, $layers:ident;)+) => {
        $(
            pub mod $module;
            pub use $module::$settings;
        )+

        /// An estimator of reflected radiance, with its settings.
        #[derive(Clone, Copy, Debug, PartialEq)]
        #[non_exhaustive]
        pub enum Method {
            $(#[doc = concat!("`", $word, "`")] $settings($settings),)+
            /// `cells`: a control variate over light cells, whose visibility is counted before the frame, and in the frames before it.
            Cells(Cells),
            /// `smc`: sequential Monte Carlo (Kronander 2014, Eqs. 5 to 8). Renderers keep particles from frame to frame.
            Smc(Smc),
        }

        impl Default for Method {
            fn default() -> Self {
                Self::Mis(Mis::default())
            }
        }

        $(impl From<$settings> for Method {
            fn from(settings: $settings) -> Self {
                Self::$settings(settings)
            }
        })+

        impl From<Cells> for Method {
            fn from(settings: Cells) -> Self {
                Self::Cells(settings)
            }
        }

        impl From<Smc> for Method {
            fn from(settings: Smc) -> Self {
                Self::Smc(settings)
            }
        }

        impl Method {
            /// Its word in a shot.
            #[must_use]
            pub fn word(&self) -> &'static str {
                match self {
                    $(Self::$settings(_) => $word,)+
                    Self::Cells(_) => "cells",
                    Self::Smc(_) => "smc",
                }
            }

            /// Checks its settings.
            ///
            /// # Errors
            /// The first that is wrong.
            pub fn check(&self) -> Result<(), SettingError> {
                match self {
                    $(Self::$settings(own) => own.check_all(),)+
                    Self::Cells(own) => own.check(),
                    Self::Smc(own) => own.check(),
                }
            }

            /// The most samples that a ray takes for one purpose.
            #[must_use]
            pub fn samples_per_ray(&self) -> u32 {
                match self {
                    $(Self::$settings(own) => own.samples_per_ray(),)+
                    Self::Cells(_) => 1,
                    Self::Smc(own) => own.candidates.max(own.particles),
                }
            }

            /// What more time buys on a ray: the count as it is.
            #[must_use]
            pub fn count(&self) -> u32 {
                match self {
                    $(Self::$settings(own) => own.count(),)+
                    Self::Cells(own) => own.rays,
                    Self::Smc(own) => own.particles,
                }
            }

            /// The keys, below `render`, that give another [`Method::count`], with their values. Other counts keep their
            /// proportion to it.
            #[must_use]
            pub fn with_count(&self, count: u32) -> Vec<(&'static str, u32)> {
                match self {
                    $(Self::$settings(own) => own.with_count(count),)+
                    Self::Cells(_) => vec![("cells.rays", count)],
                    Self::Smc(_) => vec![("smc.particles", count)],
                }
            }

            /// The counts on a ray, in words.
            #[must_use]
            pub fn describe(&self) -> String {
                match self {
                    $(Self::$settings(own) => own.describe(),)+
                    Self::Cells(own) => format!("{} rays a pixel", own.rays),
                    Self::Smc(own) => own.describe(),
                }
            }

            /// Whether it reads a table of the light, by the table's name.
            pub(crate) fn reads(&self, table: &str) -> bool {
                match self {
                    $(Self::$settings(own) => own.reads(table),)+
                    Self::Cells(_) => table == LIGHT_CELLS,
                    Self::Smc(_) => table == CDF,
                }
            }

            /// Whether each frame continues from the one before it.
            #[must_use]
            pub fn has_memory(&self) -> bool {
                match self {
                    Self::Cells(own) => own.memory,
                    Self::Smc(_) => true,
                    _ => false,
                }
            }

            /// Whether it says how it fared: [`Diagnostics`](crate::prepare::render::Diagnostics).
            #[must_use]
            pub fn has_diagnostics(&self) -> bool {
                self.way() != Way::Rays
            }

            /// Whether it estimates the light of a pixel's hits together.
            pub(crate) fn takes_groups(&self) -> bool {
                self.way() == Way::Groups
            }

            /// Whether it leads particles, which stay with their rays.
            pub(crate) fn leads_particles(&self) -> bool {
                self.way() == Way::Particles
            }

            /// Passes that find what the rays of a tile show.
            pub(crate) fn passes(&self) -> u32 {
                match self {
                    Self::Smc(_) => smc::PASSES,
                    _ if self.way() == Way::Groups => 2,
                    _ => 1,
                }
            }

            /// Bytes of a ray that go from one of those passes to the next.
            pub(crate) fn bytes_between_passes(&self) -> u64 {
                match self.way() {
                    Way::Rays => 0,
                    Way::Groups => size_of::<SeenPoint>() as u64,
                    Way::Particles => size_of::<SmcPoint>() as u64,
                }
            }

            /// Bytes of a ray in the larger of the buffers that it keeps for the next frame.
            pub(crate) fn bytes_kept(&self) -> u64 {
                match self {
                    Self::Smc(own) => own.bytes_kept(),
                    _ => 0,
                }
            }

            /// Counts that the cost of a ray depends on, in a frame that has one before it or not.
            pub(crate) fn cost(&self, has_past: bool) -> [u32; 3] {
                match self {
                    $(Self::$settings(own) => {
                        let [a, b] = own.cost();
                        [a, b, 0]
                    })+
                    Self::Cells(own) => own.cost(),
                    Self::Smc(own) => own.cost(has_past),
                }
            }

            /// The entries of its first passes on a GPU, over rays and in layers.
            pub(crate) fn entries(&self) -> Vec<&'static Entry> {
                match self {
                    $(Self::$settings(_) => {
                        let mut list = vec![
                            passes::$flat::<Gpu>::entry(),
                            passes::$layers::<Gpu>::entry(),
                        ];
                        if self.way() == Way::Groups {
                            list.push(See::<Gpu>::entry());
                        }
                        list
                    })+
                    Self::Cells(_) => cells::pass_entries(),
                    Self::Smc(_) => smc::entries(),
                }
            }
        }
    };
}

each_estimator!(methods);
