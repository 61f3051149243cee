//! Host file: what the front end makes of the workspace's kernels: the files under `generated/` and `wgsl/`.
//!
//! `cargo run --release -p glimt-tests --bin regenerate` writes them; the test `golden` compares.

use std::fmt::Write;
use std::path::{Path, PathBuf};

use glimt_render_gpu::entries::{ENTRIES, EntrySpec};
use naga_front_rust::{
    CrateSource, Diagnostic, EntryDesc, ExportDesc, Program, Shader, StructLayout,
};

/// The shared sources of every crate of the workspace that has them.
pub const SOURCES: [(&str, &[(&str, &str)]); 7] = [
    glimt_probe::SHADER_SOURCE,
    glimt_sampling::SHADER_SOURCE,
    glimt_envmap_cdf::SHADER_SOURCE,
    glimt_brdf::SHADER_SOURCE,
    glimt_smc::SHADER_SOURCE,
    glimt_sh::SHADER_SOURCE,
    glimt_render_gpu::SHADER_SOURCE,
];

/// Where the renderer's entries are written.
pub const ENTRY_FOLDER: &str = "crates/render-gpu/src/generated";
const COMMAND: &str = "cargo run --release -p glimt-tests --bin regenerate";

/// A crate's functions for people who write their own shaders.
struct Export {
    /// File, from the workspace's root.
    file: &'static str,
    functions: &'static [(&'static str, &'static str)],
    /// Group and binding of each buffer.
    buffers: &'static [(&'static str, u32, u32)],
}

const EXPORTS: &[Export] = &[
    Export {
        file: "crates/envmap-cdf/wgsl/envmap_cdf.wgsl",
        functions: &[
            ("env_sample", "glimt_envmap_cdf::EnvCdf::sample"),
            ("env_pdf_sr", "glimt_envmap_cdf::EnvCdf::pdf_sr"),
            ("env_texel_pdf_sr", "glimt_envmap_cdf::EnvCdf::texel_pdf_sr"),
            ("env_invert", "glimt_envmap_cdf::EnvCdf::invert"),
            ("env_is_black", "glimt_envmap_cdf::EnvCdf::is_black"),
        ],
        buffers: &[("marginal", 0, 1), ("conditional", 0, 2)],
    },
    Export {
        file: "crates/brdf/wgsl/brdf.wgsl",
        functions: &[
            ("blinn_phong_eval", "glimt_brdf::BlinnPhong::eval"),
            ("blinn_phong_sample", "glimt_brdf::BlinnPhong::sample"),
            ("blinn_phong_pdf_sr", "glimt_brdf::BlinnPhong::pdf_sr"),
            ("lambert_eval", "glimt_brdf::Lambert::eval"),
            ("lambert_sample", "glimt_brdf::Lambert::sample"),
            ("lambert_pdf_sr", "glimt_brdf::Lambert::pdf_sr"),
        ],
        buffers: &[],
    },
    Export {
        file: "crates/probe/wgsl/probe.wgsl",
        functions: &[
            (
                "lat_long_direction",
                "glimt_probe::latlong::uv_to_direction",
            ),
            ("lat_long_uv", "glimt_probe::latlong::direction_to_uv"),
            ("lat_long_texel", "glimt_probe::latlong::direction_to_texel"),
            (
                "lat_long_texel_direction",
                "glimt_probe::latlong::texel_direction",
            ),
            (
                "lat_long_texel_solid_angle_sr",
                "glimt_probe::latlong::texel_solid_angle_sr",
            ),
            (
                "mirror_ball_direction",
                "glimt_probe::mirror_ball::MirrorBall::image_to_direction",
            ),
            (
                "mirror_ball_image",
                "glimt_probe::mirror_ball::MirrorBall::direction_to_image",
            ),
            (
                "mirror_ball_solid_angle_sr_per_area",
                "glimt_probe::mirror_ball::MirrorBall::solid_angle_sr_per_area",
            ),
            ("gather_texel", "glimt_probe::gather::gather"),
        ],
        buffers: &[("map_texels", 0, 1), ("map_taps", 0, 2), ("pixels", 0, 3)],
    },
    Export {
        file: "crates/sampling/wgsl/sampling.wgsl",
        functions: &[
            ("unit_float", "glimt_sampling::uniform::unit_f32"),
            ("unit_pair", "glimt_sampling::uniform::unit_vec2"),
            (
                "balance_heuristic",
                "glimt_sampling::mis::balance_heuristic",
            ),
            ("power_heuristic", "glimt_sampling::mis::power_heuristic"),
            (
                "shading_frame",
                "glimt_sampling::math::ShadingFrame::from_normal",
            ),
            ("sample_cap", "glimt_sampling::warp::sample_cap"),
            ("owen_sobol", "glimt_sampling::sobol::OwenSobol::new"),
            (
                "owen_sobol_next",
                "<glimt_sampling::sobol::OwenSobol as glimt_sampling::uniform::UniformSource>::next_uvec2",
            ),
            (
                "xoshiro_stream",
                "glimt_sampling::xoshiro::Xoshiro128PlusPlus::stream",
            ),
            (
                "xoshiro_next",
                "<glimt_sampling::xoshiro::Xoshiro128PlusPlus as glimt_sampling::uniform::UniformSource>::next_u32",
            ),
            ("ris_sum", "glimt_sampling::ris::RisSum::new"),
            ("ris_add", "glimt_sampling::ris::RisSum::add"),
            ("ris_normaliser", "glimt_sampling::ris::RisSum::normaliser"),
            ("ris_picks", "glimt_sampling::ris::RisPicks::new"),
            ("ris_take", "glimt_sampling::ris::RisPicks::take"),
            ("ris_is_done", "glimt_sampling::ris::RisPicks::is_done"),
            (
                "resample_comb",
                "glimt_sampling::resample::Comb::new::<glimt_sampling::xoshiro::Xoshiro128PlusPlus>",
            ),
            (
                "resample_take",
                "glimt_sampling::resample::Comb::take::<glimt_sampling::xoshiro::Xoshiro128PlusPlus>",
            ),
            (
                "resample_finish",
                "glimt_sampling::resample::Comb::finish::<glimt_sampling::xoshiro::Xoshiro128PlusPlus>",
            ),
        ],
        buffers: &[],
    },
    Export {
        file: "crates/smc/wgsl/smc.wgsl",
        functions: &[
            ("smc_accept", "glimt_smc::metropolis::accept"),
            ("smc_bridge_density", "glimt_smc::Bridge::density"),
            ("smc_bridge_steps", "glimt_smc::Bridge::steps"),
            ("smc_split_word", "glimt_smc::split_word"),
            ("smc_particle_weight", "glimt_smc::Particle::weight"),
            ("smc_is_log_zero", "glimt_smc::is_log_zero"),
        ],
        buffers: &[],
    },
    Export {
        file: "crates/sh/wgsl/sh.wgsl",
        functions: &[
            ("sh_basis", "glimt_sh::basis::basis"),
            ("sh_add_basis", "glimt_sh::basis::add_basis"),
            ("sh_ring", "glimt_sh::separable::ring"),
            ("sh_meridian", "glimt_sh::separable::meridian"),
            ("sh_hann", "glimt_sh::hann"),
            ("sh_cosine_lobe", "glimt_sh::cosine_lobe"),
            ("sh_coefficient_band", "glimt_sh::coefficient_band"),
            ("sh_coefficient_order", "glimt_sh::coefficient_order"),
            ("sh_temporal_filter", "glimt_sh::temporal_filter"),
            ("sh_rotate_z", "glimt_sh::rotate_z"),
            ("sh_stratified_direction", "glimt_sh::stratified_direction"),
        ],
        buffers: &[],
    },
    // What the stages that are written by hand call.
    Export {
        file: "crates/render-gpu/src/generated/projection_functions.wgsl",
        functions: &[
            ("column_ring", "glimt_sh::separable::column_ring"),
            ("row_meridian", "glimt_sh::separable::row_meridian"),
            ("row_area", "glimt_probe::latlong::texel_solid_angle_sr"),
            ("coefficient_band", "glimt_sh::coefficient_band"),
            ("coefficient_order", "glimt_sh::coefficient_order"),
            ("ring_index", "glimt_sh::separable::ring_index"),
            ("meridian_index", "glimt_sh::separable::meridian_index"),
        ],
        buffers: &[],
    },
    Export {
        file: "crates/render-gpu/src/generated/raster_functions.wgsl",
        functions: &[
            (
                "corner_position",
                "glimt_render_gpu::kernels::raster::corner_position",
            ),
            (
                "corner_weights",
                "glimt_render_gpu::kernels::raster::corner_weights",
            ),
            (
                "clip_position",
                "glimt_render_gpu::kernels::raster::clip_position",
            ),
            ("draw", "glimt_render_gpu::kernels::raster::draw"),
        ],
        buffers: &[
            ("scene_triangles", 0, 1),
            ("scene_corners", 0, 2),
            ("scene_materials", 0, 3),
            ("scene_texels", 0, 4),
            ("surface_corner_vertices", 0, 5),
            ("surface_reflections", 0, 6),
            ("surface_lights", 0, 7),
            ("texels", 0, 8),
            // No stage reads them.
            ("scene_nodes", 0, 9),
        ],
    },
];

/// Parses the given crates; `SOURCES` for the workspace as it was compiled.
///
/// # Errors
///
/// The front end's own.
pub fn program(sources: &[(&str, &[(&str, &str)])]) -> Result<Program, Diagnostic> {
    let crates: Vec<CrateSource<'_>> = sources.iter().map(|&s| s.into()).collect();
    Program::parse(&crates)
}

/// Lowers one entry of the renderer.
///
/// # Errors
///
/// The front end's own.
pub fn lower(program: &Program, spec: &EntrySpec) -> Result<Shader, Diagnostic> {
    program.entry(&EntryDesc {
        name: spec.name,
        kernel: spec.kernel,
        workgroup_size: spec.workgroup_size,
    })
}

/// Every generated file: its path from the workspace's root, and its text.
///
/// # Errors
///
/// The front end's own.
pub fn files() -> Result<Vec<(PathBuf, String)>, Diagnostic> {
    let program = program(&SOURCES)?;
    let folder = Path::new(ENTRY_FOLDER);
    let head = format!(
        "// Made from Rust by naga-front-rust; do not edit. To make it anew: {COMMAND}\n\n"
    );
    let mut out = Vec::new();
    let mut structs: Vec<StructLayout> = Vec::new();
    let mut consts = String::new();
    for spec in ENTRIES {
        let shader = lower(&program, spec)?;
        for s in &shader.structs {
            if !structs.contains(s) {
                structs.push(s.clone());
            }
        }
        entry_const(&mut consts, spec, &shader);
        out.push((
            folder.join(format!("{}.wgsl", spec.name)),
            format!("{head}{}", shader.wgsl),
        ));
    }
    out.push((folder.join("mod.rs"), module(&consts, &structs)));
    for export in EXPORTS {
        let shader = program.exports(&ExportDesc {
            functions: export.functions,
            buffers: export.buffers,
        })?;
        out.push((export.file.into(), format!("{head}{}", shader.wgsl)));
    }
    Ok(out)
}

/// What lies in the folders of generated files and is none of `files`, as paths from the workspace's root: what an entry or
/// an export that was renamed or removed left behind.
///
/// # Errors
///
/// A folder cannot be read.
pub fn stale(files: &[(PathBuf, String)]) -> std::io::Result<Vec<PathBuf>> {
    let mut folders = vec![PathBuf::from(ENTRY_FOLDER)];
    for krate in std::fs::read_dir(root().join("crates"))? {
        let folder = Path::new("crates").join(krate?.file_name()).join("wgsl");
        if root().join(&folder).is_dir() {
            folders.push(folder);
        }
    }
    let mut out = Vec::new();
    for folder in folders {
        for file in std::fs::read_dir(root().join(&folder))? {
            let path = folder.join(file?.file_name());
            if files.iter().all(|(known, _)| *known != path) {
                out.push(path);
            }
        }
    }
    out.sort();
    Ok(out)
}

fn entry_const(out: &mut String, spec: &EntrySpec, shader: &Shader) {
    let name = spec.name;
    let _ = write!(
        out,
        "\n/// [`{}`](crate{}) as a compute entry point.\npub const {}: Entry = Entry {{\n    name: \"{name}\",\n    kernel: \"{}\",\n    wgsl: include_str!(\"{name}.wgsl\"),\n    workgroup_size: {},\n    params_size: {},\n    params: &[\n",
        spec.kernel.rsplit("::").next().unwrap_or(name),
        spec.kernel.trim_start_matches("glimt_render_gpu"),
        name.to_uppercase(),
        spec.kernel,
        shader.workgroup_size,
        shader.params_size,
    );
    for p in &shader.params {
        let _ = writeln!(
            out,
            "        param(\"{}\", {}, {}),",
            p.path, p.offset, p.size
        );
    }
    let _ = write!(out, "    ],\n    buffers: &[\n");
    for b in &shader.buffers {
        let _ = writeln!(
            out,
            "        slot(\"{}\", {}, {}, {}),",
            b.path, b.binding, b.stride, b.writable
        );
    }
    let _ = write!(out, "    ],\n}};\n");
}

fn module(consts: &str, structs: &[StructLayout]) -> String {
    let mut out = format!(
        "//! Host file: the renderer's entry points, made from Rust by naga-front-rust. Do not edit; to make it anew:\n//! `{COMMAND}`\n\n#[cfg(test)]\nuse core::mem::{{offset_of, size_of}};\n\nuse crate::entry::{{BufferSlot, Entry, ParamField}};\n\nconst fn param(path: &'static str, offset: u32, size: u32) -> ParamField {{\n    ParamField {{ path, offset, size }}\n}}\n\nconst fn slot(path: &'static str, binding: u32, stride: u32, writable: bool) -> BufferSlot {{\n    BufferSlot {{\n        path,\n        binding,\n        stride,\n        writable,\n    }}\n}}\n"
    );
    out.push_str(consts);
    out.push_str(
        "\n// The same bytes in Rust and in WGSL. Checked where tests are built, since a struct that has just changed must not\n// keep this file from being made anew.\n#[cfg(test)]\nconst _: () = {\n",
    );
    let mut sorted: Vec<&StructLayout> = structs.iter().collect();
    sorted.sort_by(|a, b| a.path.cmp(&b.path));
    for s in sorted {
        let path = s.path.replace("glimt_render_gpu::", "crate::");
        let _ = writeln!(out, "    assert!(size_of::<{path}>() == {});", s.size);
        for (field, offset) in &s.fields {
            let _ = writeln!(out, "    assert!(offset_of!({path}, {field}) == {offset});");
        }
    }
    out.push_str("};\n");
    out
}

/// The workspace's root.
#[must_use]
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}
