//! Host file: the kernels of [`crate::sampler_step`] for many sets at once, on either processor.

use glam::UVec4;
use glimt_executor::Entry;
use glimt_render_gpu::gpu::{Arg, GpuContext, GpuError};
use glimt_smc::Particle;
use naga_front_rust::{EntryDesc, Program};

use crate::sampler_step::{self, Outcome, Plan};

/// The kernels' text, as a crate for the front end.
pub const SHADER_SOURCE: (&str, &[(&str, &str)]) = (
    "sampler_step",
    &[("lib.rs", include_str!("sampler_step.rs"))],
);

/// One of the kernels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kernel {
    /// [`sampler_step::start`].
    Start,
    /// [`sampler_step::step`].
    Step,
    /// [`sampler_step::ancestors`].
    Ancestors,
}

/// Sets of particles, all of one size, with their generators.
#[derive(Clone, Debug)]
pub struct Sets {
    /// Particles in a set.
    pub size: usize,
    /// The sets, one after the other.
    pub particles: Vec<Particle>,
    /// What the last kernel gave for each.
    pub outcomes: Vec<Outcome>,
}

impl Sets {
    /// `count` sets of `size` particles, not started yet.
    #[must_use]
    pub fn new(count: usize, size: usize) -> Sets {
        Sets {
            size,
            particles: vec![bytemuck::Zeroable::zeroed(); count * size],
            outcomes: vec![bytemuck::Zeroable::zeroed(); count],
        }
    }

    fn streams(&self) -> Vec<UVec4> {
        self.outcomes.iter().map(|outcome| outcome.stream).collect()
    }

    /// Runs a kernel by rustc's code.
    pub fn on_cpu(&mut self, kernel: Kernel, plan: &Plan) {
        let streams = self.streams();
        let sets = self.particles.chunks_mut(self.size);
        for ((id, set), outcome) in sets.enumerate().zip(&mut self.outcomes) {
            let id = id as u32;
            *outcome = match kernel {
                Kernel::Start => sampler_step::start(id, plan, set),
                Kernel::Step => sampler_step::step(id, plan, &streams, set),
                Kernel::Ancestors => sampler_step::ancestors(id, plan, set),
            };
        }
    }

    /// Runs a kernel by the shader made of its text.
    ///
    /// # Errors
    ///
    /// The GPU's.
    pub fn on_gpu(
        &mut self,
        gpu: &SamplerShaders<'_>,
        kernel: Kernel,
        plan: &Plan,
    ) -> Result<(), GpuError> {
        let context = gpu.context;
        let count = self.outcomes.len();
        let out = context.buffer("out", (count * size_of::<Outcome>()) as u64)?;
        let streams = context.buffer_of("streams", &self.streams())?;
        let particles = context.buffer_of("particles", &self.particles)?;
        let mut args = vec![
            ("plan", Arg::Value(bytemuck::bytes_of(plan))),
            ("particles", Arg::Chunk(&particles, self.size as u32)),
            ("out", Arg::Buffer(&out)),
        ];
        if kernel == Kernel::Step {
            args.push(("streams", Arg::Buffer(&streams)));
        }
        context.launch(&gpu.entries[kernel as usize], &args, 0, count as u32)?;
        self.particles = context.read(&particles, self.particles.len())?;
        self.outcomes = context.read(&out, count)?;
        Ok(())
    }
}

/// The kernels as shaders, made of their text just now.
pub struct SamplerShaders<'a> {
    context: &'a GpuContext,
    entries: [Entry; 3],
}

impl<'a> SamplerShaders<'a> {
    /// Lowers the kernels of a program that holds [`SHADER_SOURCE`] and the algorithm crates.
    ///
    /// # Panics
    /// Where the front end refuses them.
    #[must_use]
    pub fn new(program: &Program, context: &'a GpuContext) -> Self {
        let entries = ["start", "step", "ancestors"].map(|name| {
            let kernel = format!("sampler_step::{name}");
            let desc = EntryDesc {
                name: "entry",
                kernel: &kernel,
                workgroup_size: 64,
            };
            Entry::from(
                &program
                    .entry(&desc)
                    .unwrap_or_else(|error| panic!("{error}")),
            )
        });
        Self { context, entries }
    }
}
