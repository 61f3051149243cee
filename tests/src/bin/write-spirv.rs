//! Host file: writes every shader of the workspace as SPIR-V, made by naga from its WGSL:
//! `cargo run --release --bin write-spirv -- FOLDER`. `scripts/check-spirv.sh` validates them.
//!
//! A folder below `FOLDER` is named by the environment whose rules they keep: Vulkan's, or, for functions without an entry
//! point, SPIR-V's own, since Vulkan has no libraries.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use glimt_tests::shaders;
use naga::back::spv;
use naga::valid::{Capabilities, ValidationFlags, Validator};

fn main() -> ExitCode {
    let Some(folder) = std::env::args_os().nth(1).map(PathBuf::from) else {
        eprintln!("usage: write-spirv FOLDER");
        return ExitCode::FAILURE;
    };
    match write(&folder) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

fn write(folder: &Path) -> Result<(), Box<dyn std::error::Error>> {
    for shader in shaders::all()? {
        let module = shaders::module(&shader.wgsl)?;
        let info = Validator::new(ValidationFlags::all(), Capabilities::default())
            .validate(&module)
            .map_err(|e| format!("{}: {}", shader.name, e.emit_to_string(&shader.wgsl)))?;
        let words = spv::write_vec(&module, &info, &spv::Options::default(), None)
            .map_err(|e| format!("{}: {e}", shader.name))?;
        let bytes: Vec<u8> = words.into_iter().flat_map(u32::to_le_bytes).collect();
        let environment = match module.entry_points.is_empty() {
            true => "spv1.0",
            false => "vulkan1.1",
        };
        let folder = folder.join(environment);
        std::fs::create_dir_all(&folder)?;
        let name = shader.name.replace(['/', ' ', ':', ','], "_");
        std::fs::write(folder.join(format!("{name}.spv")), bytes)?;
    }
    Ok(())
}
