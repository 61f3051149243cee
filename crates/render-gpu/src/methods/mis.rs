//! Host file: multiple importance sampling (Kronander 2014, Eq. 2).

use glimt_executor::{Executor, Memory};

use super::Inputs;
use crate::film::SamplesOut;
use crate::generated::passes::{ShadeMis, ShadeMisLayers};

pub(super) fn shade<M: Memory, E: Executor<Memory = M>>(
    executor: &mut E,
    inputs: Inputs<'_, M>,
    rays: u32,
    out: SamplesOut<'_, M>,
) -> Result<(), E::Error> {
    let Inputs { frame, env, scene } = inputs.shorten();
    match out {
        SamplesOut::Flat(out) => executor.run(
            ShadeMis {
                frame,
                env,
                scene,
                out: M::shorten_chunks(out),
            },
            0..rays,
        ),
        SamplesOut::Layered(out) => executor.run(
            ShadeMisLayers {
                frame,
                env,
                scene,
                out: M::shorten_chunks(out),
            },
            0..rays,
        ),
    }
}
