//! Host file: sets of particles that are started and led to another light, under each resampling scheme and bridge.

use glam::{Vec3, Vec4};
use glimt_render_gpu::gpu::GpuContext;
use naga_front_rust::Program;

use super::{Pair, words};
use crate::sampler_sets::{Kernel, SamplerShaders, Sets};
use crate::sampler_step::Plan;

/// The light's way above the plane, from one frame to the next.
#[must_use]
pub fn plan(scheme: u32, geometric: u32, k: u32) -> Plan {
    let light = |x: f32| -> Vec4 { Vec3::new(x, 0.3, 0.8).normalize().extend(0.0) };
    Plan {
        before: light(-0.2),
        now: light(0.5),
        scheme,
        geometric,
        intermediate: 3,
        k,
    }
}

/// Sets after their start and after each of four steps, and ancestors.
///
/// # Panics
/// Where the GPU or the front end fails.
#[must_use]
pub fn sampler_pair(program: &Program, context: &GpuContext) -> Pair {
    let shaders = SamplerShaders::new(program, context);
    let (mut cpu, mut gpu) = (Vec::new(), Vec::new());
    for scheme in 0..4 {
        let mut sets = [Sets::new(64, 8), Sets::new(64, 8)];
        let mut run = |kernel, k| {
            let plan = plan(scheme, scheme % 2, k);
            sets[0].on_cpu(kernel, &plan);
            let launched = sets[1].on_gpu(&shaders, kernel, &plan);
            launched.unwrap_or_else(|error| panic!("{error}"));
            for (sets, image) in sets.iter().zip([&mut cpu, &mut gpu]) {
                image.extend(words(&sets.particles));
                image.extend(words(&sets.outcomes));
            }
        };
        run(Kernel::Start, 0);
        (1..=4).for_each(|k| run(Kernel::Step, k));
        run(Kernel::Ancestors, 0);
    }
    Pair {
        name: "sampler".to_owned(),
        cpu,
        gpu,
    }
}
