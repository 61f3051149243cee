//! Host file: what the front end makes of the workspace's kernels: the files under `generated/` and `wgsl/`.
//!
//! `cargo run --release -p glimt-tests --bin regenerate` writes them; the test `golden` compares.

mod entries;
mod exports;
mod passes;

use std::path::{Path, PathBuf};

use glimt_render_gpu::entries::{ENTRIES, EntrySpec};
use naga_front_rust::{CrateSource, Diagnostic, EntryDesc, ExportDesc, Program, Shader};

use exports::EXPORTS;

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
const ENTRY_FOLDER: &str = "crates/render-gpu/src/generated";
const COMMAND: &str = "cargo run --release -p glimt-tests --bin regenerate";

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
    let mut out = Vec::new();
    let mut shaders: Vec<(&EntrySpec, Shader)> = Vec::new();
    for spec in ENTRIES {
        shaders.push((spec, lower(&program, spec)?));
    }
    for (spec, shader) in &shaders {
        let text = format!("{}{}", head("//"), shader.wgsl);
        out.push((folder.join(format!("{}.wgsl", spec.name)), text));
    }
    let doc = |what: &str| format!("//! Host file: {what}\n//!\n{}", head("//!"));
    let modules = [
        (
            "mod.rs",
            doc("what the front end made of the renderer's kernels."),
            MODULES.to_owned(),
        ),
        (
            "entries.rs",
            doc("the compute shaders."),
            entries::text(&shaders),
        ),
        (
            "passes.rs",
            doc("the kernels with their arguments, for executors."),
            passes::text(&shaders),
        ),
        (
            "layout.rs",
            doc("the same bytes in Rust and in WGSL."),
            entries::layout(&shaders),
        ),
    ];
    for (name, doc, text) in modules {
        out.push((folder.join(name), format!("{doc}\n{text}")));
    }
    for export in EXPORTS {
        let shader = program.exports(&ExportDesc {
            functions: export.functions,
            buffers: export.buffers,
        })?;
        out.push((export.file.into(), format!("{}{}", head("//"), shader.wgsl)));
    }
    Ok(out)
}

/// The first lines of a generated file, behind a comment's mark.
fn head(mark: &str) -> String {
    format!(
        "{mark} Made from Rust by naga-front-rust; do not edit. This command writes it: {COMMAND}\n\n"
    )
}

const MODULES: &str = "pub mod entries;
#[cfg(test)]
mod layout;
pub mod passes;
";

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

/// The workspace's root.
#[must_use]
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}
