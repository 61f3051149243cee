//! Host file: the kernels that are lowered to entry points, one `generated/NAME.wgsl` for each.

/// An entry point to generate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct EntrySpec {
    /// Name of the entry point and of its files.
    pub name: &'static str,
    /// Path of the kernel, from the crate's name on.
    pub kernel: &'static str,
    /// Invocations in a workgroup.
    pub workgroup_size: u32,
}

const fn entry(name: &'static str, kernel: &'static str) -> EntrySpec {
    // Two warps, or one wave: a ray's traversal keeps many registers, and more per group would leave cores idle.
    EntrySpec {
        name,
        kernel,
        workgroup_size: 64,
    }
}

/// All entry points: the passes of rendering, then the stages that parity tests compare.
pub const ENTRIES: &[EntrySpec] = &[
    entry("shade_mis", "glimt_render_gpu::kernels::shade::shade_mis"),
    entry("shade_bis", "glimt_render_gpu::kernels::shade::shade_bis"),
    entry(
        "shade_bis_layers",
        "glimt_render_gpu::kernels::shade::shade_bis_layers",
    ),
    entry("find_smc", "glimt_render_gpu::kernels::smc_point::find_smc"),
    entry("advance_smc", "glimt_render_gpu::kernels::smc::advance_smc"),
    entry(
        "gather_smc",
        "glimt_render_gpu::kernels::smc_gather::gather_smc",
    ),
    entry(
        "gather_smc_layers",
        "glimt_render_gpu::kernels::smc_gather::gather_smc_layers",
    ),
    entry(
        "diagnose_smc",
        "glimt_render_gpu::kernels::smc::diagnose_smc",
    ),
    entry(
        "reconstruct",
        "glimt_render_gpu::kernels::film::reconstruct",
    ),
    entry("tonemap", "glimt_render_gpu::kernels::film::tonemap"),
    entry("transfer", "glimt_render_gpu::kernels::transfer::transfer"),
    entry("unwarp", "glimt_render_gpu::kernels::unwarp::unwarp"),
    entry(
        "shade_mis_layers",
        "glimt_render_gpu::kernels::shade::shade_mis_layers",
    ),
    entry(
        "reconstruct_layers",
        "glimt_render_gpu::kernels::layers::reconstruct_layers",
    ),
    entry(
        "composite_over_plate",
        "glimt_render_gpu::kernels::composite::composite_over_plate",
    ),
    entry(
        "display_over_plate",
        "glimt_render_gpu::kernels::composite::display_over_plate",
    ),
    entry(
        "composite_alone",
        "glimt_render_gpu::kernels::composite::composite_alone",
    ),
    entry("taps", "glimt_render_gpu::kernels::pyramid::taps"),
    entry("halve", "glimt_render_gpu::kernels::pyramid::halve"),
    entry(
        "light_coefficient",
        "glimt_render_gpu::kernels::light_sh::light_coefficient",
    ),
    entry(
        "vertex_light",
        "glimt_render_gpu::kernels::prt::vertex_light",
    ),
    entry(
        "unpack_layers",
        "glimt_render_gpu::kernels::raster::unpack_layers",
    ),
    entry("film_ball", "glimt_render_gpu::kernels::capture::film_ball"),
    entry(
        "film_plate",
        "glimt_render_gpu::kernels::capture::film_plate",
    ),
    entry(
        "film_latlong",
        "glimt_render_gpu::kernels::capture::film_latlong",
    ),
    entry("expose", "glimt_render_gpu::kernels::sensor::expose"),
    entry(
        "diagnose_uniforms",
        "glimt_render_gpu::kernels::diagnose::uniforms",
    ),
    entry(
        "diagnose_env_sample",
        "glimt_render_gpu::kernels::diagnose::env_sample",
    ),
    entry(
        "diagnose_primary_hit",
        "glimt_render_gpu::kernels::diagnose::primary_hit",
    ),
    entry(
        "diagnose_surface",
        "glimt_render_gpu::kernels::diagnose::surface",
    ),
    entry(
        "diagnose_brdf_sample",
        "glimt_render_gpu::kernels::diagnose::brdf_sample",
    ),
];
