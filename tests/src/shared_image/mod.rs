//! Host file: images that together show every shared function, from the CPU and from freshly made shaders.
//!
//! `scripts/mutate-shared.sh` builds them from sources in which one constant is changed.

pub mod atlas;
mod capture;
mod drawing;
pub mod drawn;
mod estimators;
mod frame;
mod groups;
mod layered;
mod light;
pub mod sampler;
mod transfer;

use bytemuck::NoUninit;
use glam::{UVec2, Vec4};
use glimt_envmap_cdf::{CompensatedCdf, build_compensated_into, required_len};
use glimt_executor::Entry;
use glimt_render_gpu::gpu::{Arg, GpuBuffer, GpuContext};
use naga_front_rust::{EntryDesc, Program};

use crate::{golden, sampler_sets};

pub use capture::capture_pair;
pub use drawing::{drawing_pair, projection_pair};
pub use frame::frame_pairs;
pub use light::light_pair;
pub use sampler::sampler_pair;
pub use transfer::transfer_pair;

/// One image on both processors, as words.
#[derive(Clone, Debug)]
pub struct Pair {
    /// What it shows.
    pub name: String,
    /// From the functions that rustc compiled.
    pub cpu: Vec<u32>,
    /// From the shader that was made of the same text, just now.
    pub gpu: Vec<u32>,
}

/// The shared text of all crates that this program was built from.
///
/// # Panics
/// Where the front end refuses it.
#[must_use]
pub fn program() -> Program {
    let atlas: (&str, &[(&str, &str)]) = ("atlas", &[("lib.rs", include_str!("atlas.rs"))]);
    let drawn: (&str, &[(&str, &str)]) = ("drawn", &[("lib.rs", include_str!("drawn.rs"))]);
    let own = [atlas, drawn, sampler_sets::SHADER_SOURCE];
    let sources = [&golden::SOURCES[..], &own].concat();
    golden::program(&sources).unwrap_or_else(|error| panic!("{error}"))
}

/// Runs a kernel for elements `0..count` by a shader made of its text, and keeps what it returns, if anything, in `out`. Arguments
/// that the kernel does not have are left out.
fn launch(
    context: &GpuContext,
    program: &Program,
    kernel: &str,
    args: &[(&str, Arg<'_>)],
    out: &GpuBuffer,
    count: u32,
) {
    let desc = EntryDesc {
        name: "entry",
        kernel,
        workgroup_size: 64,
    };
    let shader = program.entry(&desc);
    let entry = Entry::from(&shader.unwrap_or_else(|error| panic!("{error}")));
    let known = |path: &str| {
        entry.params.iter().any(|param| param.path == path)
            || entry.buffers.iter().any(|slot| slot.path == path)
    };
    let all = args.iter().copied().chain([("out", Arg::Buffer(out))]);
    let args: Vec<_> = all.filter(|arg| known(arg.0)).collect();
    let result = context.launch(&entry, &args, 0, count);
    result.unwrap_or_else(|error| panic!("{kernel}: {error}"));
}

/// A buffer for `count` values, and what is in it.
struct Output {
    buffer: GpuBuffer,
    words: usize,
}

impl Output {
    fn new<T>(context: &GpuContext, count: u32) -> Self {
        let bytes = size_of::<T>() * count as usize;
        let buffer = context.buffer("out", bytes as u64);
        Self {
            buffer: buffer.unwrap_or_else(|error| panic!("{error}")),
            words: bytes / 4,
        }
    }

    fn read(&self, context: &GpuContext) -> Vec<u32> {
        let words = context.read(&self.buffer, self.words);
        words.unwrap_or_else(|error| panic!("{error}"))
    }
}

fn words<T: NoUninit>(values: &[T]) -> Vec<u32> {
    bytemuck::pod_collect_to_vec(values)
}

/// The shared functions that no frame shows.
///
/// # Panics
/// Where the GPU or the front end fails.
#[must_use]
pub fn atlas_pair(program: &Program, context: &GpuContext) -> Pair {
    let size = UVec2::new(8, 4);
    let len = required_len(size.x, size.y).expect("a size that tables have");
    let (mut marginal, mut conditional) = (vec![0; len.marginal], vec![0; len.conditional]);
    let row = |y: u32| (0..size.x).map(move |x| (x * y) as f32);
    build_compensated_into(size, row, &mut marginal, &mut conditional).expect("tables");
    let env = CompensatedCdf::new(size, &marginal, &conditional).expect("tables");
    let count = atlas::PAGES * atlas::PAGE_SIZE * atlas::PAGE_SIZE;
    let cpu: Vec<Vec4> = (0..count).map(|id| atlas::atlas(id, env)).collect();

    let upload = |edges: &[u32]| context.buffer_of("table", edges).expect("a small buffer");
    let (marginal, conditional) = (upload(&marginal), upload(&conditional));
    let args = [
        ("env.env.size", Arg::Value(bytemuck::bytes_of(&size))),
        ("env.env.marginal", Arg::Buffer(&marginal)),
        ("env.env.conditional", Arg::Buffer(&conditional)),
    ];
    let out = Output::new::<Vec4>(context, count);
    launch(context, program, "atlas::atlas", &args, &out.buffer, count);
    Pair {
        name: "atlas".to_owned(),
        cpu: words(&cpu),
        gpu: out.read(context),
    }
}
