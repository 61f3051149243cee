//! Host file: the renderer's entry points, made from Rust by naga-front-rust. Do not edit; to make it anew:
//! `cargo run --release -p glimt-tests --bin regenerate`

#[cfg(test)]
use core::mem::{offset_of, size_of};

use crate::entry::{BufferSlot, Entry, ParamField, ParamsSpace};

const fn param(path: &'static str, offset: u32, size: u32) -> ParamField {
    ParamField { path, offset, size }
}

const fn slot(path: &'static str, binding: u32, stride: u32, writable: bool) -> BufferSlot {
    BufferSlot {
        path,
        binding,
        stride,
        writable,
    }
}

/// [`shade_mis`](crate::kernels::shade::shade_mis) as a compute entry point.
pub const SHADE_MIS: Entry = Entry {
    name: "shade_mis",
    kernel: "glimt_render_gpu::kernels::shade::shade_mis",
    wgsl: include_str!("shade_mis.wgsl"),
    workgroup_size: 64,
    params_size: 144,
    params_in: ParamsSpace::Uniform,
    params: &[
        param("first", 0, 4),
        param("count", 4, 4),
        param("frame", 16, 112),
        param("env.cdf.size", 128, 8),
        param("env.rotation", 136, 8),
    ],
    buffers: &[
        slot("env.texels", 1, 16, false),
        slot("env.cdf.marginal", 2, 4, false),
        slot("env.cdf.conditional", 3, 4, false),
        slot("scene.nodes", 4, 32, false),
        slot("scene.triangles", 5, 48, false),
        slot("scene.corners", 6, 32, false),
        slot("scene.materials", 7, 96, false),
        slot("scene.texels", 8, 4, false),
        slot("out", 9, 16, true),
    ],
};

/// [`shade_bis`](crate::kernels::shade::shade_bis) as a compute entry point.
pub const SHADE_BIS: Entry = Entry {
    name: "shade_bis",
    kernel: "glimt_render_gpu::kernels::shade::shade_bis",
    wgsl: include_str!("shade_bis.wgsl"),
    workgroup_size: 64,
    params_size: 160,
    params_in: ParamsSpace::Uniform,
    params: &[
        param("first", 0, 4),
        param("count", 4, 4),
        param("frame", 16, 112),
        param("bis", 128, 16),
        param("env.cdf.size", 144, 8),
        param("env.rotation", 152, 8),
    ],
    buffers: &[
        slot("env.texels", 1, 16, false),
        slot("env.cdf.marginal", 2, 4, false),
        slot("env.cdf.conditional", 3, 4, false),
        slot("scene.nodes", 4, 32, false),
        slot("scene.triangles", 5, 48, false),
        slot("scene.corners", 6, 32, false),
        slot("scene.materials", 7, 96, false),
        slot("scene.texels", 8, 4, false),
        slot("out", 9, 16, true),
    ],
};

/// [`shade_bis_layers`](crate::kernels::shade::shade_bis_layers) as a compute entry point.
pub const SHADE_BIS_LAYERS: Entry = Entry {
    name: "shade_bis_layers",
    kernel: "glimt_render_gpu::kernels::shade::shade_bis_layers",
    wgsl: include_str!("shade_bis_layers.wgsl"),
    workgroup_size: 64,
    params_size: 160,
    params_in: ParamsSpace::Uniform,
    params: &[
        param("first", 0, 4),
        param("count", 4, 4),
        param("frame", 16, 112),
        param("bis", 128, 16),
        param("env.cdf.size", 144, 8),
        param("env.rotation", 152, 8),
    ],
    buffers: &[
        slot("env.texels", 1, 16, false),
        slot("env.cdf.marginal", 2, 4, false),
        slot("env.cdf.conditional", 3, 4, false),
        slot("scene.nodes", 4, 32, false),
        slot("scene.triangles", 5, 48, false),
        slot("scene.corners", 6, 32, false),
        slot("scene.materials", 7, 96, false),
        slot("scene.texels", 8, 4, false),
        slot("out", 9, 32, true),
    ],
};

/// [`shade_smc`](crate::kernels::smc::shade_smc) as a compute entry point.
pub const SHADE_SMC: Entry = Entry {
    name: "shade_smc",
    kernel: "glimt_render_gpu::kernels::smc::shade_smc",
    wgsl: include_str!("shade_smc.wgsl"),
    workgroup_size: 64,
    params_size: 288,
    params_in: ParamsSpace::Uniform,
    params: &[
        param("first", 0, 4),
        param("count", 4, 4),
        param("state_len", 8, 4),
        param("particles_len", 12, 4),
        param("frame", 16, 112),
        param("smc", 128, 64),
        param("view", 192, 64),
        param("env.cdf.size", 256, 8),
        param("env.rotation", 264, 8),
        param("before.size", 272, 8),
        param("before.rotation", 280, 8),
    ],
    buffers: &[
        slot("env.texels", 1, 16, false),
        slot("env.cdf.marginal", 2, 4, false),
        slot("env.cdf.conditional", 3, 4, false),
        slot("before.texels", 4, 16, false),
        slot("scene.nodes", 5, 32, false),
        slot("scene.triangles", 6, 48, false),
        slot("scene.corners", 7, 32, false),
        slot("scene.materials", 8, 96, false),
        slot("scene.texels", 9, 4, false),
        slot("past.motions", 10, 64, false),
        slot("past.states", 11, 64, false),
        slot("past.particles", 12, 16, false),
        slot("state", 13, 64, true),
        slot("particles", 14, 16, true),
        slot("out", 15, 16, true),
    ],
};

/// [`shade_smc_layers`](crate::kernels::smc::shade_smc_layers) as a compute entry point.
pub const SHADE_SMC_LAYERS: Entry = Entry {
    name: "shade_smc_layers",
    kernel: "glimt_render_gpu::kernels::smc::shade_smc_layers",
    wgsl: include_str!("shade_smc_layers.wgsl"),
    workgroup_size: 64,
    params_size: 288,
    params_in: ParamsSpace::Uniform,
    params: &[
        param("first", 0, 4),
        param("count", 4, 4),
        param("state_len", 8, 4),
        param("particles_len", 12, 4),
        param("frame", 16, 112),
        param("smc", 128, 64),
        param("view", 192, 64),
        param("env.cdf.size", 256, 8),
        param("env.rotation", 264, 8),
        param("before.size", 272, 8),
        param("before.rotation", 280, 8),
    ],
    buffers: &[
        slot("env.texels", 1, 16, false),
        slot("env.cdf.marginal", 2, 4, false),
        slot("env.cdf.conditional", 3, 4, false),
        slot("before.texels", 4, 16, false),
        slot("scene.nodes", 5, 32, false),
        slot("scene.triangles", 6, 48, false),
        slot("scene.corners", 7, 32, false),
        slot("scene.materials", 8, 96, false),
        slot("scene.texels", 9, 4, false),
        slot("past.motions", 10, 64, false),
        slot("past.states", 11, 64, false),
        slot("past.particles", 12, 16, false),
        slot("state", 13, 64, true),
        slot("particles", 14, 16, true),
        slot("out", 15, 32, true),
    ],
};

/// [`diagnose_smc`](crate::kernels::smc::diagnose_smc) as a compute entry point.
pub const DIAGNOSE_SMC: Entry = Entry {
    name: "diagnose_smc",
    kernel: "glimt_render_gpu::kernels::smc::diagnose_smc",
    wgsl: include_str!("diagnose_smc.wgsl"),
    workgroup_size: 64,
    params_size: 144,
    params_in: ParamsSpace::Uniform,
    params: &[
        param("first", 0, 4),
        param("count", 4, 4),
        param("frame", 16, 112),
        param("particles_per_ray", 128, 4),
    ],
    buffers: &[
        slot("states", 1, 64, false),
        slot("out", 2, 16, true),
    ],
};

/// [`reconstruct`](crate::kernels::film::reconstruct) as a compute entry point.
pub const RECONSTRUCT: Entry = Entry {
    name: "reconstruct",
    kernel: "glimt_render_gpu::kernels::film::reconstruct",
    wgsl: include_str!("reconstruct.wgsl"),
    workgroup_size: 64,
    params_size: 128,
    params_in: ParamsSpace::Uniform,
    params: &[
        param("first", 0, 4),
        param("count", 4, 4),
        param("frame", 16, 112),
    ],
    buffers: &[
        slot("samples", 1, 16, false),
        slot("out", 2, 16, true),
    ],
};

/// [`tonemap`](crate::kernels::film::tonemap) as a compute entry point.
pub const TONEMAP: Entry = Entry {
    name: "tonemap",
    kernel: "glimt_render_gpu::kernels::film::tonemap",
    wgsl: include_str!("tonemap.wgsl"),
    workgroup_size: 64,
    params_size: 128,
    params_in: ParamsSpace::Uniform,
    params: &[
        param("first", 0, 4),
        param("count", 4, 4),
        param("frame", 16, 112),
    ],
    buffers: &[
        slot("linear", 1, 16, false),
        slot("out", 2, 4, true),
    ],
};

/// [`transfer`](crate::kernels::transfer::transfer) as a compute entry point.
pub const TRANSFER: Entry = Entry {
    name: "transfer",
    kernel: "glimt_render_gpu::kernels::transfer::transfer",
    wgsl: include_str!("transfer.wgsl"),
    workgroup_size: 64,
    params_size: 64,
    params_in: ParamsSpace::Uniform,
    params: &[
        param("first", 0, 4),
        param("count", 4, 4),
        param("state_len", 8, 4),
        param("lit_len", 12, 4),
        param("blocked_len", 16, 4),
        param("params", 32, 24),
    ],
    buffers: &[
        slot("nodes", 1, 32, false),
        slot("triangles", 2, 48, false),
        slot("vertices", 3, 48, false),
        slot("state", 4, 4, true),
        slot("lit", 5, 4, true),
        slot("blocked", 6, 4, true),
        slot("out", 7, 4, true),
    ],
};

/// [`unwarp`](crate::kernels::unwarp::unwarp) as a compute entry point.
pub const UNWARP: Entry = Entry {
    name: "unwarp",
    kernel: "glimt_render_gpu::kernels::unwarp::unwarp",
    wgsl: include_str!("unwarp.wgsl"),
    workgroup_size: 64,
    params_size: 80,
    params_in: ParamsSpace::Uniform,
    params: &[
        param("first", 0, 4),
        param("count", 4, 4),
        param("colour", 16, 48),
        param("reflectance", 64, 16),
    ],
    buffers: &[
        slot("map.texels", 1, 12, false),
        slot("map.taps", 2, 4, false),
        slot("pixels", 3, 16, false),
        slot("out", 4, 16, true),
    ],
};

/// [`shade_mis_layers`](crate::kernels::shade::shade_mis_layers) as a compute entry point.
pub const SHADE_MIS_LAYERS: Entry = Entry {
    name: "shade_mis_layers",
    kernel: "glimt_render_gpu::kernels::shade::shade_mis_layers",
    wgsl: include_str!("shade_mis_layers.wgsl"),
    workgroup_size: 64,
    params_size: 144,
    params_in: ParamsSpace::Uniform,
    params: &[
        param("first", 0, 4),
        param("count", 4, 4),
        param("frame", 16, 112),
        param("env.cdf.size", 128, 8),
        param("env.rotation", 136, 8),
    ],
    buffers: &[
        slot("env.texels", 1, 16, false),
        slot("env.cdf.marginal", 2, 4, false),
        slot("env.cdf.conditional", 3, 4, false),
        slot("scene.nodes", 4, 32, false),
        slot("scene.triangles", 5, 48, false),
        slot("scene.corners", 6, 32, false),
        slot("scene.materials", 7, 96, false),
        slot("scene.texels", 8, 4, false),
        slot("out", 9, 32, true),
    ],
};

/// [`reconstruct_layers`](crate::kernels::layers::reconstruct_layers) as a compute entry point.
pub const RECONSTRUCT_LAYERS: Entry = Entry {
    name: "reconstruct_layers",
    kernel: "glimt_render_gpu::kernels::layers::reconstruct_layers",
    wgsl: include_str!("reconstruct_layers.wgsl"),
    workgroup_size: 64,
    params_size: 144,
    params_in: ParamsSpace::Uniform,
    params: &[
        param("first", 0, 4),
        param("count", 4, 4),
        param("frame", 16, 112),
        param("env.cdf.size", 128, 8),
        param("env.rotation", 136, 8),
    ],
    buffers: &[
        slot("env.texels", 1, 16, false),
        slot("samples", 2, 32, false),
        slot("out", 3, 64, true),
    ],
};

/// [`composite_over_plate`](crate::kernels::composite::composite_over_plate) as a compute entry point.
pub const COMPOSITE_OVER_PLATE: Entry = Entry {
    name: "composite_over_plate",
    kernel: "glimt_render_gpu::kernels::composite::composite_over_plate",
    wgsl: include_str!("composite_over_plate.wgsl"),
    workgroup_size: 64,
    params_size: 128,
    params_in: ParamsSpace::Uniform,
    params: &[
        param("first", 0, 4),
        param("count", 4, 4),
        param("frame", 16, 112),
    ],
    buffers: &[
        slot("layers", 1, 64, false),
        slot("plate", 2, 16, false),
        slot("out", 3, 16, true),
    ],
};

/// [`display_over_plate`](crate::kernels::composite::display_over_plate) as a compute entry point.
pub const DISPLAY_OVER_PLATE: Entry = Entry {
    name: "display_over_plate",
    kernel: "glimt_render_gpu::kernels::composite::display_over_plate",
    wgsl: include_str!("display_over_plate.wgsl"),
    workgroup_size: 64,
    params_size: 128,
    params_in: ParamsSpace::Uniform,
    params: &[
        param("first", 0, 4),
        param("count", 4, 4),
        param("frame", 16, 112),
    ],
    buffers: &[
        slot("layers", 1, 64, false),
        slot("plate", 2, 16, false),
        slot("out", 3, 4, true),
    ],
};

/// [`composite_alone`](crate::kernels::composite::composite_alone) as a compute entry point.
pub const COMPOSITE_ALONE: Entry = Entry {
    name: "composite_alone",
    kernel: "glimt_render_gpu::kernels::composite::composite_alone",
    wgsl: include_str!("composite_alone.wgsl"),
    workgroup_size: 64,
    params_size: 128,
    params_in: ParamsSpace::Uniform,
    params: &[
        param("first", 0, 4),
        param("count", 4, 4),
        param("frame", 16, 112),
    ],
    buffers: &[
        slot("layers", 1, 64, false),
        slot("out", 2, 16, true),
    ],
};

/// [`taps`](crate::kernels::pyramid::taps) as a compute entry point.
pub const TAPS: Entry = Entry {
    name: "taps",
    kernel: "glimt_render_gpu::kernels::pyramid::taps",
    wgsl: include_str!("taps.wgsl"),
    workgroup_size: 64,
    params_size: 16,
    params_in: ParamsSpace::Uniform,
    params: &[
        param("first", 0, 4),
        param("count", 4, 4),
        param("size", 8, 8),
    ],
    buffers: &[
        slot("out", 1, 32, true),
    ],
};

/// [`halve`](crate::kernels::pyramid::halve) as a compute entry point.
pub const HALVE: Entry = Entry {
    name: "halve",
    kernel: "glimt_render_gpu::kernels::pyramid::halve",
    wgsl: include_str!("halve.wgsl"),
    workgroup_size: 64,
    params_size: 16,
    params_in: ParamsSpace::Uniform,
    params: &[
        param("first", 0, 4),
        param("count", 4, 4),
        param("size", 8, 8),
    ],
    buffers: &[
        slot("taps", 1, 32, false),
        slot("texels", 2, 16, false),
        slot("out", 3, 16, true),
    ],
};

/// [`light_coefficient`](crate::kernels::light_sh::light_coefficient) as a compute entry point.
pub const LIGHT_COEFFICIENT: Entry = Entry {
    name: "light_coefficient",
    kernel: "glimt_render_gpu::kernels::light_sh::light_coefficient",
    wgsl: include_str!("light_coefficient.wgsl"),
    workgroup_size: 64,
    params_size: 48,
    params_in: ParamsSpace::Uniform,
    params: &[
        param("first", 0, 4),
        param("count", 4, 4),
        param("light", 16, 32),
    ],
    buffers: &[
        slot("sums", 1, 16, false),
        slot("previous", 2, 16, false),
        slot("out", 3, 16, true),
    ],
};

/// [`vertex_light`](crate::kernels::prt::vertex_light) as a compute entry point.
pub const VERTEX_LIGHT: Entry = Entry {
    name: "vertex_light",
    kernel: "glimt_render_gpu::kernels::prt::vertex_light",
    wgsl: include_str!("vertex_light.wgsl"),
    workgroup_size: 64,
    params_size: 16,
    params_in: ParamsSpace::Uniform,
    params: &[
        param("first", 0, 4),
        param("count", 4, 4),
        param("coefficients", 8, 4),
        param("shadows", 12, 4),
    ],
    buffers: &[
        slot("light", 1, 16, false),
        slot("lit", 2, 4, false),
        slot("blocked", 3, 4, false),
        slot("out", 4, 32, true),
    ],
};

/// [`unpack_layers`](crate::kernels::raster::unpack_layers) as a compute entry point.
pub const UNPACK_LAYERS: Entry = Entry {
    name: "unpack_layers",
    kernel: "glimt_render_gpu::kernels::raster::unpack_layers",
    wgsl: include_str!("unpack_layers.wgsl"),
    workgroup_size: 64,
    params_size: 160,
    params_in: ParamsSpace::Uniform,
    params: &[
        param("first", 0, 4),
        param("count", 4, 4),
        param("frame", 16, 112),
        param("layout", 128, 16),
        param("map_rotation", 144, 8),
    ],
    buffers: &[
        slot("map_texels", 1, 16, false),
        slot("object", 2, 8, false),
        slot("lit", 3, 8, false),
        slot("blocked", 4, 8, false),
        slot("out", 5, 64, true),
    ],
};

/// [`film_ball`](crate::kernels::capture::film_ball) as a compute entry point.
pub const FILM_BALL: Entry = Entry {
    name: "film_ball",
    kernel: "glimt_render_gpu::kernels::capture::film_ball",
    wgsl: include_str!("film_ball.wgsl"),
    workgroup_size: 64,
    params_size: 256,
    params_in: ParamsSpace::Uniform,
    params: &[
        param("first", 0, 4),
        param("count", 4, 4),
        param("capture", 16, 176),
        param("stage.params", 192, 64),
    ],
    buffers: &[
        slot("stage.texels", 1, 16, false),
        slot("out", 2, 16, true),
    ],
};

/// [`film_plate`](crate::kernels::capture::film_plate) as a compute entry point.
pub const FILM_PLATE: Entry = Entry {
    name: "film_plate",
    kernel: "glimt_render_gpu::kernels::capture::film_plate",
    wgsl: include_str!("film_plate.wgsl"),
    workgroup_size: 64,
    params_size: 192,
    params_in: ParamsSpace::Uniform,
    params: &[
        param("first", 0, 4),
        param("count", 4, 4),
        param("frame", 16, 112),
        param("stage.params", 128, 64),
    ],
    buffers: &[
        slot("stage.texels", 1, 16, false),
        slot("out", 2, 16, true),
    ],
};

/// [`film_latlong`](crate::kernels::capture::film_latlong) as a compute entry point.
pub const FILM_LATLONG: Entry = Entry {
    name: "film_latlong",
    kernel: "glimt_render_gpu::kernels::capture::film_latlong",
    wgsl: include_str!("film_latlong.wgsl"),
    workgroup_size: 64,
    params_size: 112,
    params_in: ParamsSpace::Uniform,
    params: &[
        param("first", 0, 4),
        param("count", 4, 4),
        param("latlong", 16, 32),
        param("stage.params", 48, 64),
    ],
    buffers: &[
        slot("stage.texels", 1, 16, false),
        slot("out", 2, 16, true),
    ],
};

/// [`expose`](crate::kernels::sensor::expose) as a compute entry point.
pub const EXPOSE: Entry = Entry {
    name: "expose",
    kernel: "glimt_render_gpu::kernels::sensor::expose",
    wgsl: include_str!("expose.wgsl"),
    workgroup_size: 64,
    params_size: 64,
    params_in: ParamsSpace::Uniform,
    params: &[
        param("first", 0, 4),
        param("count", 4, 4),
        param("sensor", 16, 48),
    ],
    buffers: &[
        slot("radiance", 1, 16, false),
        slot("out", 2, 16, true),
    ],
};

/// [`uniforms`](crate::kernels::diagnose::uniforms) as a compute entry point.
pub const DIAGNOSE_UNIFORMS: Entry = Entry {
    name: "diagnose_uniforms",
    kernel: "glimt_render_gpu::kernels::diagnose::uniforms",
    wgsl: include_str!("diagnose_uniforms.wgsl"),
    workgroup_size: 64,
    params_size: 128,
    params_in: ParamsSpace::Uniform,
    params: &[
        param("first", 0, 4),
        param("count", 4, 4),
        param("frame", 16, 112),
    ],
    buffers: &[
        slot("out", 1, 16, true),
    ],
};

/// [`env_sample`](crate::kernels::diagnose::env_sample) as a compute entry point.
pub const DIAGNOSE_ENV_SAMPLE: Entry = Entry {
    name: "diagnose_env_sample",
    kernel: "glimt_render_gpu::kernels::diagnose::env_sample",
    wgsl: include_str!("diagnose_env_sample.wgsl"),
    workgroup_size: 64,
    params_size: 144,
    params_in: ParamsSpace::Uniform,
    params: &[
        param("first", 0, 4),
        param("count", 4, 4),
        param("frame", 16, 112),
        param("env.cdf.size", 128, 8),
        param("env.rotation", 136, 8),
    ],
    buffers: &[
        slot("env.cdf.marginal", 1, 4, false),
        slot("env.cdf.conditional", 2, 4, false),
        slot("out", 3, 32, true),
    ],
};

/// [`primary_hit`](crate::kernels::diagnose::primary_hit) as a compute entry point.
pub const DIAGNOSE_PRIMARY_HIT: Entry = Entry {
    name: "diagnose_primary_hit",
    kernel: "glimt_render_gpu::kernels::diagnose::primary_hit",
    wgsl: include_str!("diagnose_primary_hit.wgsl"),
    workgroup_size: 64,
    params_size: 128,
    params_in: ParamsSpace::Uniform,
    params: &[
        param("first", 0, 4),
        param("count", 4, 4),
        param("frame", 16, 112),
    ],
    buffers: &[
        slot("scene.nodes", 1, 32, false),
        slot("scene.triangles", 2, 48, false),
        slot("out", 3, 16, true),
    ],
};

/// [`surface`](crate::kernels::diagnose::surface) as a compute entry point.
pub const DIAGNOSE_SURFACE: Entry = Entry {
    name: "diagnose_surface",
    kernel: "glimt_render_gpu::kernels::diagnose::surface",
    wgsl: include_str!("diagnose_surface.wgsl"),
    workgroup_size: 64,
    params_size: 128,
    params_in: ParamsSpace::Uniform,
    params: &[
        param("first", 0, 4),
        param("count", 4, 4),
        param("frame", 16, 112),
    ],
    buffers: &[
        slot("scene.nodes", 1, 32, false),
        slot("scene.triangles", 2, 48, false),
        slot("scene.corners", 3, 32, false),
        slot("scene.materials", 4, 96, false),
        slot("scene.texels", 5, 4, false),
        slot("out", 6, 64, true),
    ],
};

/// [`brdf_sample`](crate::kernels::diagnose::brdf_sample) as a compute entry point.
pub const DIAGNOSE_BRDF_SAMPLE: Entry = Entry {
    name: "diagnose_brdf_sample",
    kernel: "glimt_render_gpu::kernels::diagnose::brdf_sample",
    wgsl: include_str!("diagnose_brdf_sample.wgsl"),
    workgroup_size: 64,
    params_size: 128,
    params_in: ParamsSpace::Uniform,
    params: &[
        param("first", 0, 4),
        param("count", 4, 4),
        param("frame", 16, 112),
    ],
    buffers: &[
        slot("scene.nodes", 1, 32, false),
        slot("scene.triangles", 2, 48, false),
        slot("scene.corners", 3, 32, false),
        slot("scene.materials", 4, 96, false),
        slot("scene.texels", 5, 4, false),
        slot("out", 6, 16, true),
    ],
};

// The same bytes in Rust and in WGSL. Checked where tests are built, since a struct that has just changed must not
// keep this file from being made anew.
#[cfg(test)]
const _: () = {
    assert!(size_of::<glimt_probe::gather::ColourMatrix>() == 48);
    assert!(offset_of!(glimt_probe::gather::ColourMatrix, red) == 0);
    assert!(offset_of!(glimt_probe::gather::ColourMatrix, green) == 16);
    assert!(offset_of!(glimt_probe::gather::ColourMatrix, blue) == 32);
    assert!(size_of::<glimt_probe::gather::TexelTaps>() == 12);
    assert!(offset_of!(glimt_probe::gather::TexelTaps, tap) == 0);
    assert!(offset_of!(glimt_probe::gather::TexelTaps, pixel) == 4);
    assert!(offset_of!(glimt_probe::gather::TexelTaps, grazing) == 8);
    assert!(size_of::<crate::kernels::bis::Bis>() == 16);
    assert!(offset_of!(crate::kernels::bis::Bis, candidates) == 0);
    assert!(offset_of!(crate::kernels::bis::Bis, samples) == 4);
    assert!(offset_of!(crate::kernels::bis::Bis, source) == 8);
    assert!(offset_of!(crate::kernels::bis::Bis, unused) == 12);
    assert!(size_of::<crate::kernels::bvh::BvhNode>() == 32);
    assert!(offset_of!(crate::kernels::bvh::BvhNode, min) == 0);
    assert!(offset_of!(crate::kernels::bvh::BvhNode, count) == 12);
    assert!(offset_of!(crate::kernels::bvh::BvhNode, max) == 16);
    assert!(offset_of!(crate::kernels::bvh::BvhNode, first) == 28);
    assert!(size_of::<crate::kernels::capture::CaptureParams>() == 176);
    assert!(offset_of!(crate::kernels::capture::CaptureParams, shake_x) == 0);
    assert!(offset_of!(crate::kernels::capture::CaptureParams, width) == 12);
    assert!(offset_of!(crate::kernels::capture::CaptureParams, shake_y) == 16);
    assert!(offset_of!(crate::kernels::capture::CaptureParams, height) == 28);
    assert!(offset_of!(crate::kernels::capture::CaptureParams, shake_z) == 32);
    assert!(offset_of!(crate::kernels::capture::CaptureParams, focal_px) == 44);
    assert!(offset_of!(crate::kernels::capture::CaptureParams, ball_centre) == 48);
    assert!(offset_of!(crate::kernels::capture::CaptureParams, ball_radius) == 60);
    assert!(offset_of!(crate::kernels::capture::CaptureParams, forward) == 64);
    assert!(offset_of!(crate::kernels::capture::CaptureParams, radius_over_distance) == 76);
    assert!(offset_of!(crate::kernels::capture::CaptureParams, right) == 80);
    assert!(offset_of!(crate::kernels::capture::CaptureParams, outline) == 92);
    assert!(offset_of!(crate::kernels::capture::CaptureParams, up) == 96);
    assert!(offset_of!(crate::kernels::capture::CaptureParams, samples) == 108);
    assert!(offset_of!(crate::kernels::capture::CaptureParams, tint) == 112);
    assert!(offset_of!(crate::kernels::capture::CaptureParams, fresnel) == 124);
    assert!(offset_of!(crate::kernels::capture::CaptureParams, eye) == 128);
    assert!(offset_of!(crate::kernels::capture::CaptureParams, unused_a) == 140);
    assert!(offset_of!(crate::kernels::capture::CaptureParams, rig_half_size) == 144);
    assert!(offset_of!(crate::kernels::capture::CaptureParams, unused_b) == 156);
    assert!(offset_of!(crate::kernels::capture::CaptureParams, rig_radiance) == 160);
    assert!(offset_of!(crate::kernels::capture::CaptureParams, unused_c) == 172);
    assert!(size_of::<crate::kernels::capture::LatLongParams>() == 32);
    assert!(offset_of!(crate::kernels::capture::LatLongParams, position) == 0);
    assert!(offset_of!(crate::kernels::capture::LatLongParams, grid) == 12);
    assert!(offset_of!(crate::kernels::capture::LatLongParams, size) == 16);
    assert!(offset_of!(crate::kernels::capture::LatLongParams, unused) == 24);
    assert!(size_of::<crate::kernels::composite::PlatePixel>() == 16);
    assert!(offset_of!(crate::kernels::composite::PlatePixel, linear) == 0);
    assert!(offset_of!(crate::kernels::composite::PlatePixel, code) == 12);
    assert!(size_of::<crate::kernels::diagnose::EnvRecord>() == 32);
    assert!(offset_of!(crate::kernels::diagnose::EnvRecord, direction) == 0);
    assert!(offset_of!(crate::kernels::diagnose::EnvRecord, pdf_sr) == 12);
    assert!(offset_of!(crate::kernels::diagnose::EnvRecord, texel) == 16);
    assert!(offset_of!(crate::kernels::diagnose::EnvRecord, looked_up) == 24);
    assert!(size_of::<crate::kernels::diagnose::HitRecord>() == 16);
    assert!(offset_of!(crate::kernels::diagnose::HitRecord, barycentrics) == 0);
    assert!(offset_of!(crate::kernels::diagnose::HitRecord, t) == 8);
    assert!(offset_of!(crate::kernels::diagnose::HitRecord, triangle) == 12);
    assert!(size_of::<crate::kernels::diagnose::SurfaceRecord>() == 64);
    assert!(offset_of!(crate::kernels::diagnose::SurfaceRecord, origin) == 0);
    assert!(offset_of!(crate::kernels::diagnose::SurfaceRecord, exponent) == 12);
    assert!(offset_of!(crate::kernels::diagnose::SurfaceRecord, normal) == 16);
    assert!(offset_of!(crate::kernels::diagnose::SurfaceRecord, facing) == 28);
    assert!(offset_of!(crate::kernels::diagnose::SurfaceRecord, diffuse) == 32);
    assert!(offset_of!(crate::kernels::diagnose::SurfaceRecord, hit) == 44);
    assert!(offset_of!(crate::kernels::diagnose::SurfaceRecord, specular) == 48);
    assert!(offset_of!(crate::kernels::diagnose::SurfaceRecord, unused) == 60);
    assert!(size_of::<crate::kernels::frame::FrameParams>() == 112);
    assert!(offset_of!(crate::kernels::frame::FrameParams, eye) == 0);
    assert!(offset_of!(crate::kernels::frame::FrameParams, width) == 12);
    assert!(offset_of!(crate::kernels::frame::FrameParams, forward) == 16);
    assert!(offset_of!(crate::kernels::frame::FrameParams, height) == 28);
    assert!(offset_of!(crate::kernels::frame::FrameParams, right) == 32);
    assert!(offset_of!(crate::kernels::frame::FrameParams, rays_per_pixel) == 44);
    assert!(offset_of!(crate::kernels::frame::FrameParams, up) == 48);
    assert!(offset_of!(crate::kernels::frame::FrameParams, first_pixel) == 60);
    assert!(offset_of!(crate::kernels::frame::FrameParams, brdf_samples) == 64);
    assert!(offset_of!(crate::kernels::frame::FrameParams, env_samples) == 68);
    assert!(offset_of!(crate::kernels::frame::FrameParams, pattern) == 72);
    assert!(offset_of!(crate::kernels::frame::FrameParams, filter) == 76);
    assert!(offset_of!(crate::kernels::frame::FrameParams, background) == 80);
    assert!(offset_of!(crate::kernels::frame::FrameParams, seed) == 84);
    assert!(offset_of!(crate::kernels::frame::FrameParams, frame) == 88);
    assert!(offset_of!(crate::kernels::frame::FrameParams, tonemap) == 92);
    assert!(offset_of!(crate::kernels::frame::FrameParams, exposure) == 96);
    assert!(offset_of!(crate::kernels::frame::FrameParams, shadow) == 100);
    assert!(offset_of!(crate::kernels::frame::FrameParams, film_frame) == 104);
    assert!(offset_of!(crate::kernels::frame::FrameParams, unused_c) == 108);
    assert!(size_of::<crate::kernels::layers::LayerSample>() == 32);
    assert!(offset_of!(crate::kernels::layers::LayerSample, radiance) == 0);
    assert!(offset_of!(crate::kernels::layers::LayerSample, alpha) == 12);
    assert!(offset_of!(crate::kernels::layers::LayerSample, blocked) == 16);
    assert!(offset_of!(crate::kernels::layers::LayerSample, catcher) == 28);
    assert!(size_of::<crate::kernels::layers::PixelLayers>() == 64);
    assert!(offset_of!(crate::kernels::layers::PixelLayers, object) == 0);
    assert!(offset_of!(crate::kernels::layers::PixelLayers, lit) == 16);
    assert!(offset_of!(crate::kernels::layers::PixelLayers, catcher) == 28);
    assert!(offset_of!(crate::kernels::layers::PixelLayers, blocked) == 32);
    assert!(offset_of!(crate::kernels::layers::PixelLayers, unused_a) == 44);
    assert!(offset_of!(crate::kernels::layers::PixelLayers, behind) == 48);
    assert!(offset_of!(crate::kernels::layers::PixelLayers, unused_b) == 60);
    assert!(size_of::<crate::kernels::light_sh::LightParams>() == 32);
    assert!(offset_of!(crate::kernels::light_sh::LightParams, rotation) == 0);
    assert!(offset_of!(crate::kernels::light_sh::LightParams, window) == 8);
    assert!(offset_of!(crate::kernels::light_sh::LightParams, temporal) == 12);
    assert!(offset_of!(crate::kernels::light_sh::LightParams, bands) == 16);
    assert!(offset_of!(crate::kernels::light_sh::LightParams, unused_a) == 20);
    assert!(offset_of!(crate::kernels::light_sh::LightParams, unused_b) == 24);
    assert!(offset_of!(crate::kernels::light_sh::LightParams, unused_c) == 28);
    assert!(size_of::<crate::kernels::material::Material>() == 96);
    assert!(offset_of!(crate::kernels::material::Material, color) == 0);
    assert!(offset_of!(crate::kernels::material::Material, kind) == 12);
    assert!(offset_of!(crate::kernels::material::Material, specular) == 16);
    assert!(offset_of!(crate::kernels::material::Material, exponent) == 28);
    assert!(offset_of!(crate::kernels::material::Material, metallic) == 32);
    assert!(offset_of!(crate::kernels::material::Material, roughness) == 36);
    assert!(offset_of!(crate::kernels::material::Material, normal_scale) == 40);
    assert!(offset_of!(crate::kernels::material::Material, unused) == 44);
    assert!(offset_of!(crate::kernels::material::Material, base_color_texture) == 48);
    assert!(offset_of!(crate::kernels::material::Material, metallic_roughness_texture) == 64);
    assert!(offset_of!(crate::kernels::material::Material, normal_texture) == 80);
    assert!(size_of::<crate::kernels::past::PastView>() == 64);
    assert!(offset_of!(crate::kernels::past::PastView, eye) == 0);
    assert!(offset_of!(crate::kernels::past::PastView, first_pixel) == 12);
    assert!(offset_of!(crate::kernels::past::PastView, forward) == 16);
    assert!(offset_of!(crate::kernels::past::PastView, pixels) == 28);
    assert!(offset_of!(crate::kernels::past::PastView, right) == 32);
    assert!(offset_of!(crate::kernels::past::PastView, depth_tolerance) == 44);
    assert!(offset_of!(crate::kernels::past::PastView, up) == 48);
    assert!(offset_of!(crate::kernels::past::PastView, normal_cosine) == 60);
    assert!(size_of::<crate::kernels::past::RayState>() == 64);
    assert!(offset_of!(crate::kernels::past::RayState, normal) == 0);
    assert!(offset_of!(crate::kernels::past::RayState, log_normaliser) == 12);
    assert!(offset_of!(crate::kernels::past::RayState, wo) == 16);
    assert!(offset_of!(crate::kernels::past::RayState, depth) == 28);
    assert!(offset_of!(crate::kernels::past::RayState, diffuse) == 32);
    assert!(offset_of!(crate::kernels::past::RayState, specular) == 36);
    assert!(offset_of!(crate::kernels::past::RayState, exponent) == 40);
    assert!(offset_of!(crate::kernels::past::RayState, age) == 44);
    assert!(offset_of!(crate::kernels::past::RayState, ess) == 48);
    assert!(offset_of!(crate::kernels::past::RayState, log_ratio) == 52);
    assert!(offset_of!(crate::kernels::past::RayState, started) == 56);
    assert!(offset_of!(crate::kernels::past::RayState, accepted) == 60);
    assert!(size_of::<crate::kernels::prt::VertexLight>() == 32);
    assert!(offset_of!(crate::kernels::prt::VertexLight, lit) == 0);
    assert!(offset_of!(crate::kernels::prt::VertexLight, unused_a) == 12);
    assert!(offset_of!(crate::kernels::prt::VertexLight, blocked) == 16);
    assert!(offset_of!(crate::kernels::prt::VertexLight, unused_b) == 28);
    assert!(size_of::<crate::kernels::pyramid::Taps>() == 32);
    assert!(offset_of!(crate::kernels::pyramid::Taps, first) == 0);
    assert!(offset_of!(crate::kernels::pyramid::Taps, count) == 4);
    assert!(offset_of!(crate::kernels::pyramid::Taps, weights) == 8);
    assert!(size_of::<crate::kernels::raster::DrawnLayout>() == 16);
    assert!(offset_of!(crate::kernels::raster::DrawnLayout, map_size) == 0);
    assert!(offset_of!(crate::kernels::raster::DrawnLayout, pitch) == 8);
    assert!(offset_of!(crate::kernels::raster::DrawnLayout, scale) == 12);
    assert!(size_of::<crate::kernels::scene::Corner>() == 32);
    assert!(offset_of!(crate::kernels::scene::Corner, normal) == 0);
    assert!(offset_of!(crate::kernels::scene::Corner, u) == 12);
    assert!(offset_of!(crate::kernels::scene::Corner, tangent) == 16);
    assert!(offset_of!(crate::kernels::scene::Corner, v) == 28);
    assert!(size_of::<crate::kernels::sensor::SensorParams>() == 48);
    assert!(offset_of!(crate::kernels::sensor::SensorParams, longest_gain) == 0);
    assert!(offset_of!(crate::kernels::sensor::SensorParams, step) == 4);
    assert!(offset_of!(crate::kernels::sensor::SensorParams, exposures) == 8);
    assert!(offset_of!(crate::kernels::sensor::SensorParams, full_well) == 12);
    assert!(offset_of!(crate::kernels::sensor::SensorParams, read_noise) == 16);
    assert!(offset_of!(crate::kernels::sensor::SensorParams, electrons_per_code) == 20);
    assert!(offset_of!(crate::kernels::sensor::SensorParams, seed) == 24);
    assert!(offset_of!(crate::kernels::sensor::SensorParams, frame) == 28);
    assert!(offset_of!(crate::kernels::sensor::SensorParams, unused_a) == 32);
    assert!(offset_of!(crate::kernels::sensor::SensorParams, unused_b) == 36);
    assert!(offset_of!(crate::kernels::sensor::SensorParams, unused_c) == 40);
    assert!(offset_of!(crate::kernels::sensor::SensorParams, unused_d) == 44);
    assert!(size_of::<crate::kernels::smc::SmcParams>() == 64);
    assert!(offset_of!(crate::kernels::smc::SmcParams, intermediate) == 0);
    assert!(offset_of!(crate::kernels::smc::SmcParams, path) == 4);
    assert!(offset_of!(crate::kernels::smc::SmcParams, scheme) == 8);
    assert!(offset_of!(crate::kernels::smc::SmcParams, ess_threshold) == 12);
    assert!(offset_of!(crate::kernels::smc::SmcParams, floor) == 16);
    assert!(offset_of!(crate::kernels::smc::SmcParams, previous_floor) == 20);
    assert!(offset_of!(crate::kernels::smc::SmcParams, cap_height) == 24);
    assert!(offset_of!(crate::kernels::smc::SmcParams, cap_share) == 28);
    assert!(offset_of!(crate::kernels::smc::SmcParams, light_share) == 32);
    assert!(offset_of!(crate::kernels::smc::SmcParams, band) == 36);
    assert!(offset_of!(crate::kernels::smc::SmcParams, max_age) == 40);
    assert!(offset_of!(crate::kernels::smc::SmcParams, candidates) == 44);
    assert!(offset_of!(crate::kernels::smc::SmcParams, source) == 48);
    assert!(offset_of!(crate::kernels::smc::SmcParams, unused_a) == 52);
    assert!(offset_of!(crate::kernels::smc::SmcParams, unused_b) == 56);
    assert!(offset_of!(crate::kernels::smc::SmcParams, unused_c) == 60);
    assert!(size_of::<crate::kernels::stage::StageParams>() == 64);
    assert!(offset_of!(crate::kernels::stage::StageParams, half_size) == 0);
    assert!(offset_of!(crate::kernels::stage::StageParams, shape) == 12);
    assert!(offset_of!(crate::kernels::stage::StageParams, occluder_centre) == 16);
    assert!(offset_of!(crate::kernels::stage::StageParams, occluder_radius) == 28);
    assert!(offset_of!(crate::kernels::stage::StageParams, occluder_radiance) == 32);
    assert!(offset_of!(crate::kernels::stage::StageParams, unused) == 44);
    assert!(offset_of!(crate::kernels::stage::StageParams, size) == 48);
    assert!(offset_of!(crate::kernels::stage::StageParams, rotation) == 56);
    assert!(size_of::<crate::kernels::texture::TextureView>() == 16);
    assert!(offset_of!(crate::kernels::texture::TextureView, first) == 0);
    assert!(offset_of!(crate::kernels::texture::TextureView, width) == 4);
    assert!(offset_of!(crate::kernels::texture::TextureView, height) == 8);
    assert!(offset_of!(crate::kernels::texture::TextureView, flags) == 12);
    assert!(size_of::<crate::kernels::transfer::TransferParams>() == 24);
    assert!(offset_of!(crate::kernels::transfer::TransferParams, bands) == 0);
    assert!(offset_of!(crate::kernels::transfer::TransferParams, directions) == 4);
    assert!(offset_of!(crate::kernels::transfer::TransferParams, rows) == 8);
    assert!(offset_of!(crate::kernels::transfer::TransferParams, seed) == 12);
    assert!(offset_of!(crate::kernels::transfer::TransferParams, first_row) == 16);
    assert!(offset_of!(crate::kernels::transfer::TransferParams, end_row) == 20);
    assert!(size_of::<crate::kernels::transfer::TransferVertex>() == 48);
    assert!(offset_of!(crate::kernels::transfer::TransferVertex, origin) == 0);
    assert!(offset_of!(crate::kernels::transfer::TransferVertex, object) == 12);
    assert!(offset_of!(crate::kernels::transfer::TransferVertex, normal) == 16);
    assert!(offset_of!(crate::kernels::transfer::TransferVertex, number) == 28);
    assert!(offset_of!(crate::kernels::transfer::TransferVertex, inner) == 32);
    assert!(offset_of!(crate::kernels::transfer::TransferVertex, unused) == 44);
    assert!(size_of::<crate::kernels::triangle::Triangle>() == 48);
    assert!(offset_of!(crate::kernels::triangle::Triangle, v0) == 0);
    assert!(offset_of!(crate::kernels::triangle::Triangle, material) == 12);
    assert!(offset_of!(crate::kernels::triangle::Triangle, v1) == 16);
    assert!(offset_of!(crate::kernels::triangle::Triangle, object) == 28);
    assert!(offset_of!(crate::kernels::triangle::Triangle, v2) == 32);
    assert!(offset_of!(crate::kernels::triangle::Triangle, ray_offset) == 44);
    assert!(size_of::<glimt_smc::particle::Particle>() == 16);
    assert!(offset_of!(glimt_smc::particle::Particle, state) == 0);
    assert!(offset_of!(glimt_smc::particle::Particle, log_weight) == 12);
};
