//! Host file: bidirectional importance sampling (Kronander 2014, Eqs. 3 and 4).

use glimt_executor::{Executor, Memory};

use super::Inputs;
use crate::film::SamplesOut;
use crate::generated::passes::{ShadeBis, ShadeBisLayers};
use crate::kernels::bis::Bis;

pub(super) fn shade<M: Memory, E: Executor<Memory = M>>(
    bis: &Bis,
    executor: &mut E,
    inputs: Inputs<'_, M>,
    rays: u32,
    out: SamplesOut<'_, M>,
) -> Result<(), E::Error> {
    let Inputs { frame, env, scene } = inputs.shorten();
    match out {
        SamplesOut::Flat(out) => executor.run(
            ShadeBis {
                frame,
                bis,
                env,
                scene,
                out: M::shorten_chunks(out),
            },
            0..rays,
        ),
        SamplesOut::Layered(out) => executor.run(
            ShadeBisLayers {
                frame,
                bis,
                env,
                scene,
                out: M::shorten_chunks(out),
            },
            0..rays,
        ),
    }
}
