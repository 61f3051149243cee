//! Host file: the ways to estimate reflected light. Each is one file: its settings, its passes, and what it keeps of a frame.

mod bis;
mod mis;
pub(crate) mod smc;

use glimt_executor::{Executor, Memory};

use crate::film::SamplesOut;
use crate::generated::passes::{EnvironmentArg, SceneArg};
use crate::kernels::frame::FrameParams;

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

/// A method with all that one tile needs.
pub(crate) enum TileMethod<'a, M: Memory> {
    /// Multiple importance sampling.
    Mis,
    /// Bidirectional importance sampling.
    Bis(crate::kernels::bis::Bis),
    /// Sequential Monte Carlo.
    Smc(smc::Tile<'a, M>),
}

impl<'a, M: Memory> TileMethod<'a, M> {
    /// Pass 1: finds what the first `rays` rays of the tile show.
    pub(crate) fn shade<E: Executor<Memory = M>>(
        self,
        executor: &mut E,
        inputs: Inputs<'_, M>,
        rays: u32,
        out: SamplesOut<'_, M>,
    ) -> Result<(), E::Error> {
        match self {
            Self::Mis => mis::shade(executor, inputs, rays, out),
            Self::Bis(params) => bis::shade(&params, executor, inputs, rays, out),
            Self::Smc(tile) => tile.shade(executor, inputs, rays, out),
        }
    }
}
