//! Host file: the ways to estimate reflected light. Each is one file: its settings, its passes, and what it keeps of a frame.
//!
//! The list of those that keep nothing stands in [`entries`](crate::entries); the macro below makes all of it that is the same
//! for each.

pub mod prt;
pub mod smc;

use std::fmt::Debug;

use glimt_executor::gpu::Gpu;
use glimt_executor::{Entry, Executor, Memory, Pass};

use crate::film::SamplesOut;
use crate::generated::passes::{self, EnvironmentArg, SceneArg};
use crate::kernels::frame::FrameParams;
use crate::kernels::smc_point::SmcPoint;
use crate::prepare::smc_state::SmcState;
use crate::settings::SettingError;

pub use crate::kernels::candidates::CandidateSource;
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

/// What a renderer keeps between frames, by the method that keeps it: saved, restored, forgotten as one.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub enum MethodMemory {
    /// Of [`Method::Smc`].
    Smc(SmcState),
}

macro_rules! methods {
    ($($settings:ident in $module:ident = $word:literal, $estimator:literal, $flat:ident, $layers:ident;)+) => {
        $(
            pub mod $module;
            pub use $module::$settings;
        )+

        /// An estimator of reflected radiance, with its settings.
        #[derive(Clone, Copy, Debug, PartialEq)]
        #[non_exhaustive]
        pub enum Method {
            $(#[doc = concat!("`", $word, "`")] $settings($settings),)+
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
                    Self::Smc(own) => own.check(),
                }
            }

            /// The most samples that a ray takes for one purpose.
            #[must_use]
            pub fn samples_per_ray(&self) -> u32 {
                match self {
                    $(Self::$settings(own) => own.samples_per_ray(),)+
                    Self::Smc(own) => own.candidates.max(own.particles),
                }
            }

            /// What more time buys on a ray: the count as it is.
            #[must_use]
            pub fn count(&self) -> u32 {
                match self {
                    $(Self::$settings(own) => own.count(),)+
                    Self::Smc(own) => own.particles,
                }
            }

            /// The keys, below `render`, that give another [`Method::count`], with their values. Other counts keep their
            /// proportion to it.
            #[must_use]
            pub fn with_count(&self, count: u32) -> Vec<(&'static str, u32)> {
                match self {
                    $(Self::$settings(own) => own.with_count(count),)+
                    Self::Smc(_) => vec![("smc.particles", count)],
                }
            }

            /// The counts on a ray, in words.
            #[must_use]
            pub fn describe(&self) -> String {
                match self {
                    $(Self::$settings(own) => own.describe(),)+
                    Self::Smc(own) => own.describe(),
                }
            }

            /// Whether it reads a table of the light, by the table's name.
            pub(crate) fn reads(&self, table: &str) -> bool {
                match self {
                    $(Self::$settings(own) => own.reads(table),)+
                    Self::Smc(_) => table == CDF,
                }
            }

            /// Whether it keeps particles from frame to frame.
            #[must_use]
            pub fn has_memory(&self) -> bool {
                matches!(self, Self::Smc(_))
            }

            /// Passes that find what the rays of a tile show.
            pub(crate) fn passes(&self) -> u32 {
                match self {
                    Self::Smc(_) => smc::PASSES,
                    _ => 1,
                }
            }

            /// Bytes of a ray that go from one of those passes to the next.
            pub(crate) fn bytes_between_passes(&self) -> u64 {
                match self {
                    Self::Smc(_) => size_of::<SmcPoint>() as u64,
                    _ => 0,
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
                    Self::Smc(own) => own.cost(has_past),
                }
            }

            /// The entries of its first passes on a GPU, over rays and in layers.
            pub(crate) fn entries(&self) -> Vec<&'static Entry> {
                match self {
                    $(Self::$settings(_) => vec![
                        passes::$flat::<Gpu>::entry(),
                        passes::$layers::<Gpu>::entry(),
                    ],)+
                    Self::Smc(_) => smc::entries(),
                }
            }

            /// Pass 1: finds what the first `rays` rays of a tile show. `tile` is what the sequential sampler needs of one.
            pub(crate) fn shade<M: Memory, E: Executor<Memory = M>>(
                &self,
                tile: Option<smc::Tile<'_, M>>,
                executor: &mut E,
                inputs: Inputs<'_, M>,
                rays: u32,
                out: SamplesOut<'_, M>,
            ) -> Result<(), E::Error> {
                let Inputs { frame, env, scene } = inputs.shorten();
                match (self, out) {
                    $(
                        (Self::$settings(own), SamplesOut::Flat(out)) => {
                            let (estimator, out) = (&own.params(), M::shorten_chunks(out));
                            executor.run(passes::$flat { frame, estimator, env, scene, out }, 0..rays)
                        }
                        (Self::$settings(own), SamplesOut::Layered(out)) => {
                            let (estimator, out) = (&own.params(), M::shorten_chunks(out));
                            executor.run(passes::$layers { frame, estimator, env, scene, out }, 0..rays)
                        }
                    )+
                    (Self::Smc(_), out) => match tile {
                        Some(tile) => tile.shade(executor, inputs, rays, out),
                        None => unreachable!("a tile of the sequential sampler comes with its rays"),
                    },
                }
            }
        }
    };
}

each_estimator!(methods);
