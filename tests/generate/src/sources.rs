//! Host file: the shared sources of the workspace, as they lie on the disk.

use std::io;
use std::path::{Path, PathBuf};

use naga_front_rust::{CrateSource, Diagnostic, Program};

use crate::root;

/// Folders below `crates/` and names of the crates that have shared files.
const CRATES: [(&str, &str); 8] = [
    ("probe", "glimt_probe"),
    ("sampling", "glimt_sampling"),
    ("envmap-cdf", "glimt_envmap_cdf"),
    ("brdf", "glimt_brdf"),
    ("light-cells", "glimt_light_cells"),
    ("smc", "glimt_smc"),
    ("sh", "glimt_sh"),
    ("render-gpu", "glimt_render_gpu"),
];

/// A crate's shared files, read.
#[derive(Clone, Debug)]
pub struct SharedCrate {
    /// Its name, as other crates `use` it.
    pub name: String,
    /// Path below `src/` and text, its root first, then in the order of their paths.
    pub files: Vec<(String, String)>,
}

/// The module of the renderer's kernels, which lists its files.
pub(crate) const KERNELS: &str = "crates/render-gpu/src/kernels/mod.rs";

/// Its text: a line for each file beside it.
///
/// # Errors
/// The folder cannot be read.
pub fn kernels_module() -> io::Result<String> {
    let file = root().join(KERNELS);
    let mut names = Vec::new();
    for entry in std::fs::read_dir(file.parent().unwrap_or(&file))? {
        let name = entry?.file_name().to_string_lossy().into_owned();
        names.extend(name.strip_suffix(".rs").map(str::to_owned));
    }
    names.retain(|name| name != "mod");
    names.sort();
    let mut text = String::from(
        "//! Shared file: the functions that run for every ray and pixel, on the CPU and, lowered, on the GPU.\n\
         //!\n\
         //! A kernel computes one element of a buffer. All ids are local to a tile; [`frame::FrameParams::first_pixel`] places\n\
         //! the tile in the image, and random streams are keyed by the pixel of the image, so that an image has the same bits\n\
         //! whatever its tiles.\n\
         //!\n\
         //! The list is generated with the shaders: a new kernel is a new file.\n\n",
    );
    for name in names {
        text.push_str(&format!("pub mod {name};\n"));
    }
    Ok(text)
}

/// The shared files of all crates. A crate's root counts as one, whatever its first line says.
///
/// # Errors
/// A file or folder cannot be read.
pub fn read() -> io::Result<Vec<SharedCrate>> {
    let each = CRATES.iter().map(|(folder, name)| {
        let src = root().join("crates").join(folder).join("src");
        Ok(SharedCrate {
            name: (*name).to_owned(),
            files: shared_files(&src)?,
        })
    });
    each.collect()
}

/// Parses crates.
///
/// # Errors
/// The front end's own.
pub fn parse(crates: &[SharedCrate]) -> Result<Program, Diagnostic> {
    let files: Vec<Vec<(&str, &str)>> = crates
        .iter()
        .map(|own| own.files.iter().map(|(p, t)| (&**p, &**t)).collect())
        .collect();
    let sources: Vec<CrateSource<'_>> = crates
        .iter()
        .zip(&files)
        .map(|(own, files)| CrateSource {
            name: &own.name,
            files,
        })
        .collect();
    Program::parse(&sources)
}

fn shared_files(src: &Path) -> io::Result<Vec<(String, String)>> {
    let mut paths = Vec::new();
    let mut folders = vec![PathBuf::new()];
    while let Some(below) = folders.pop() {
        for entry in std::fs::read_dir(src.join(&below))? {
            let entry = entry?;
            let path = below.join(entry.file_name());
            match entry.file_type()?.is_dir() {
                true => folders.push(path),
                false if path.extension().is_some_and(|e| e == "rs") => paths.push(path),
                false => {}
            }
        }
    }
    paths.sort();
    let mut files = Vec::new();
    for path in paths {
        let text = std::fs::read_to_string(src.join(&path))?;
        let name = path.to_string_lossy().replace('\\', "/");
        // As it will be: a kernel that was just added is not in its list yet.
        let is_list = src.join(&path) == root().join(KERNELS);
        let text = if is_list { kernels_module()? } else { text };
        if name == "lib.rs" {
            files.insert(0, (name, text));
        } else if text.starts_with("//! Shared file:") {
            files.push((name, text));
        }
    }
    Ok(files)
}
