//! Host file: images that together show every shared function, from the CPU and from freshly made shaders.
//!
//! `scripts/mutate-shared.sh` builds them from sources in which one constant is changed.

pub mod atlas;

use glam::{UVec2, Vec4};
use glimt_envmap_cdf::{CompensatedCdf, build_compensated_into, required_len};
use glimt_render_gpu::entry::Entry;
use glimt_render_gpu::gpu::{Arg, GpuContext};
use naga_front_rust::{CrateSource, EntryDesc, Program};

use crate::gpu::entry_of;

/// One image on both processors, as words.
#[derive(Clone, Debug)]
pub struct Pair {
    /// What it shows.
    pub name: &'static str,
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
    let crates = [
        glimt_probe::SHADER_SOURCE,
        glimt_sampling::SHADER_SOURCE,
        glimt_envmap_cdf::SHADER_SOURCE,
        glimt_brdf::SHADER_SOURCE,
        // glimt_render_gpu::SHADER_SOURCE,
        ("atlas", &[("lib.rs", include_str!("atlas.rs"))]),
    ];
    Program::parse(&crates.map(CrateSource::from)).unwrap_or_else(|error| panic!("{error}"))
}

fn entry(program: &Program, kernel: &str) -> Entry {
    let desc = EntryDesc {
        name: "entry",
        kernel,
        workgroup_size: 64,
    };
    entry_of(
        &program
            .entry(&desc)
            .unwrap_or_else(|error| panic!("{error}")),
    )
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

    let run = || {
        let marginal = context.buffer_of("marginal", &marginal)?;
        let conditional = context.buffer_of("conditional", &conditional)?;
        let out = context.buffer("out", 16 * u64::from(count))?;
        let args = [
            ("env.env.size", Arg::Value(bytemuck::bytes_of(&size))),
            ("env.env.marginal", Arg::Buffer(&marginal)),
            ("env.env.conditional", Arg::Buffer(&conditional)),
            ("out", Arg::Buffer(&out)),
        ];
        context.launch(&entry(program, "atlas::atlas"), &args, 0, count)?;
        context.read(&out, 4 * count as usize)
    };
    Pair {
        name: "atlas",
        cpu: bytemuck::cast_slice(&cpu).to_vec(),
        gpu: run().unwrap_or_else(|error| panic!("atlas: {error}")),
    }
}
