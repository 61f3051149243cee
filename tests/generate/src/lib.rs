//! Host file: what the front end makes of the workspace's kernels: the files under `generated/` and `wgsl/`.
//!
//! `cargo run --release -p glimt-generate` writes them; the test `golden` compares. It reads kernels and the list of entries from the
//! disk and builds nothing that depends on what it writes. So a new kernel needs no more than its file and its line in the list.

mod describe;
mod digests;
mod exports;
mod passes;
pub mod sources;

/// The list of entries, which the renderer has, too.
#[path = "../../../crates/render-gpu/src/entries.rs"]
#[macro_use]
pub mod entries;

use std::path::{Path, PathBuf};

use entries::EntrySpec;
use naga_front_rust::{Diagnostic, EntryDesc, ExportDesc, Program, Shader};

use exports::EXPORTS;

/// Where the renderer's entries are written.
pub const ENTRY_FOLDER: &str = "crates/render-gpu/src/generated";
const COMMAND: &str = "cargo run --release -p glimt-generate";

/// Why nothing was generated.
#[derive(Debug)]
pub enum GenerateError {
    /// A file or folder cannot be read.
    Read(std::io::Error),
    /// The front end refuses a kernel.
    Lower(Diagnostic),
}

impl std::fmt::Display for GenerateError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Read(error) => write!(f, "{error}"),
            Self::Lower(error) => write!(f, "{error}"),
        }
    }
}

impl std::error::Error for GenerateError {}

impl From<std::io::Error> for GenerateError {
    fn from(error: std::io::Error) -> Self {
        Self::Read(error)
    }
}

impl From<Diagnostic> for GenerateError {
    fn from(error: Diagnostic) -> Self {
        Self::Lower(error)
    }
}

/// Lowers one entry of the renderer.
///
/// # Errors
///
/// The front end's own.
pub fn lower(program: &Program, spec: &EntrySpec) -> Result<Shader, Diagnostic> {
    program.entry(&EntryDesc {
        name: &spec.name,
        kernel: &spec.kernel,
        workgroup_size: spec.workgroup_size,
    })
}

/// Every generated file: its path from the workspace's root, and its text.
///
/// # Errors
///
/// A [`GenerateError`].
pub fn files() -> Result<Vec<(PathBuf, String)>, GenerateError> {
    let crates = sources::read()?;
    let program = sources::parse(&crates)?;
    let mut shaders: Vec<(EntrySpec, Shader)> = Vec::new();
    for spec in entries::all() {
        let shader = lower(&program, &spec)?;
        shaders.push((spec, shader));
    }
    let mut exports: Vec<(PathBuf, String)> = Vec::new();
    for export in EXPORTS {
        let shader = program.exports(&ExportDesc {
            functions: export.functions,
            buffers: export.buffers,
        })?;
        let text = format!("{}{}", head("//"), shader.wgsl);
        exports.push((export.file.into(), text));
    }
    let folder = Path::new(ENTRY_FOLDER);
    let mut out = Vec::new();
    for (spec, shader) in &shaders {
        let text = format!("{}{}", head("//"), shader.wgsl);
        out.push((folder.join(format!("{}.wgsl", spec.name)), text));
    }
    let modules = [
        (
            "mod.rs",
            "what the front end made of the renderer's kernels.",
            MODULES.to_owned(),
        ),
        (
            "entries.rs",
            "the compute shaders.",
            describe::entries(&shaders),
        ),
        (
            "passes.rs",
            "the kernels with their arguments, for executors.",
            passes::text(&shaders),
        ),
        (
            "layout.rs",
            "the same bytes in Rust and in WGSL.",
            describe::layout(&shaders),
        ),
        (
            "digests.rs",
            "what results depend on: a digest of all shaders of a role.",
            digests::text(&shaders, &exports)?,
        ),
        (
            "sources.rs",
            "the shared files of this crate.",
            describe::sources(&crates),
        ),
    ];
    for (name, what, text) in modules {
        let doc = format!("//! Host file: {what}\n//!\n{}", head("//!"));
        out.push((folder.join(name), format!("{doc}{text}")));
    }
    out.extend(exports);
    out.push((sources::KERNELS.into(), sources::kernels_module()?));
    Ok(out)
}

/// The first lines of a generated file, behind a comment's mark.
fn head(mark: &str) -> String {
    format!(
        "{mark} Made from Rust by naga-front-rust; do not edit. This command writes it: {COMMAND}\n\n"
    )
}

const MODULES: &str = "pub mod digests;
pub mod entries;
#[cfg(test)]
mod layout;
pub mod passes;
#[cfg(feature = \"shader-source\")]
pub(crate) mod sources;
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
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}
