//! Host file: `glimt info`: what a file holds, or which devices there are.

mod image;
mod mesh;

use crate::error::{Error, Result};
use crate::input::footage;
use crate::notes::Notes;
use crate::report::Reporter;
use crate::shot::{check, parse};
use glimt_render_gpu::gpu;
use serde_json::json;
use std::path::Path;

/// Says what a file holds, by its extension.
///
/// # Errors
/// The file cannot be read, or is of no kind that is known.
pub fn file(file: &Path, set: &[String], reporter: &Reporter) -> Result<()> {
    let name = file.file_name().unwrap_or_default().to_string_lossy();
    let lower = name.to_ascii_lowercase();
    let lower = lower.strip_suffix(".gz").unwrap_or(&lower);
    let extension = lower.rsplit_once('.').map_or("", |(_, e)| e);
    if extension != "toml" && !set.is_empty() {
        return Err(Error::usage("--set belongs to shots alone").file(file));
    }
    let mut notes = Notes::new(false);
    let (value, text) = match extension {
        "toml" => shot(file, set)?,
        "glb" | "gltf" | "obj" | "ply" => mesh::describe(file, &mut notes)?,
        _ => image::describe(file, &mut notes)?,
    };
    reporter.notes(notes.take());
    reporter.answer(&value, &text);
    Ok(())
}

/// The shot with every key.
fn shot(file: &Path, set: &[String]) -> Result<(serde_json::Value, String)> {
    let (mut shot, source) = parse::read(file, set)?;
    let base = file.parent().unwrap_or(Path::new(""));
    footage::adopt_size(&mut shot, &source, base)?;
    check::check(&shot, &source)?;
    let fail = |e: &dyn std::fmt::Display| Error::new(crate::error::Kind::Internal, e);
    let value = serde_json::to_value(&shot).map_err(|e| fail(&e))?;
    // By way of JSON floats would turn into doubles with all their digits; TOML takes the shot itself.
    let text = toml::to_string(&shot).map_err(|e| fail(&e))?;
    Ok((value, text))
}

/// Lists versions and devices.
pub fn devices(reporter: &Reporter) {
    let threads = rayon::current_num_threads();
    let adapters = gpu::enumerate();
    let mut lines = vec![
        format!("glimt     {}", env!("CARGO_PKG_VERSION")),
        format!("cpu       {threads} threads"),
    ];
    let mut list = Vec::new();
    for adapter in &adapters {
        lines.push(format!("gpu       {adapter}, {}", adapter.driver));
        lines.push(format!(
            "          bindings up to {} MiB, {} storage buffers a stage, {}",
            adapter.max_binding_bytes >> 20,
            adapter.max_storage_buffers,
            if adapter.timestamps {
                "timestamps"
            } else {
                "no timestamps"
            },
        ));
        list.push(json!({
            "name": adapter.name, "kind": adapter.kind, "backend": adapter.backend, "driver": adapter.driver,
            "max_binding_bytes": adapter.max_binding_bytes, "max_buffer_bytes": adapter.max_buffer_bytes,
            "max_storage_buffers": adapter.max_storage_buffers, "timestamps": adapter.timestamps,
        }));
    }
    if adapters.is_empty() {
        lines.push("gpu       none that runs compute shaders".to_owned());
    }
    let value = json!({"version": env!("CARGO_PKG_VERSION"), "cpu_threads": threads, "gpus": list});
    reporter.answer(&value, &lines.join("\n"));
}
