//! Host file: the shared sources that this program was built from.

use naga_front_rust::{CrateSource, Diagnostic, Program};

/// The shared sources of every crate of the workspace that has them.
pub const SOURCES: [(&str, &[(&str, &str)]); 8] = [
    glimt_probe::SHADER_SOURCE,
    glimt_sampling::SHADER_SOURCE,
    glimt_envmap_cdf::SHADER_SOURCE,
    glimt_brdf::SHADER_SOURCE,
    glimt_light_cells::SHADER_SOURCE,
    glimt_smc::SHADER_SOURCE,
    glimt_sh::SHADER_SOURCE,
    glimt_render_gpu::SHADER_SOURCE,
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
