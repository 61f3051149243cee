//! Host file: `glimt info`: what a file holds, or which devices there are.

mod image;
mod mesh;

use crate::cli::RenderFlags;
use crate::error::{Error, Kind, Result};
use crate::input::footage;
use crate::job::probe_files;
use crate::memory;
use crate::notes::Notes;
use crate::report::Reporter;
use crate::setup::Setup;
use crate::shot::parse::Source;
use crate::shot::{Shot, check, parse, range};
use glam::UVec2;
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
        "toml" => shot(file, set, &mut notes)?,
        "glb" | "gltf" | "obj" | "ply" | "stl" => mesh::describe(file, &mut notes)?,
        _ => image::describe(file, &mut notes)?,
    };
    reporter.notes(notes.take());
    reporter.answer(&value, &text);
    Ok(())
}

/// The shot with every key; behind them, as comments, what moves.
fn shot(file: &Path, set: &[String], notes: &mut Notes) -> Result<(serde_json::Value, String)> {
    let (mut shot, source) = parse::read(file, set)?;
    footage::adopt_size(&mut shot, &source)?;
    check::check(&shot, &source)?;
    let light = probe_files(&shot, &source)?;
    footage::adopt_rate(&mut shot, &source, &light, notes)?;
    let fail = |e: &dyn std::fmt::Display| Error::new(crate::error::Kind::Internal, e);
    let value = serde_json::to_value(&shot).map_err(|e| fail(&e))?;
    // By way of JSON floats would turn into doubles with all their digits; TOML takes the shot itself.
    let mut text = toml::to_string(&shot).map_err(|e| fail(&e))?;
    text.extend(kept(&shot).map(|line| format!("# {line}\n")));
    for line in motion(shot, source, notes)? {
        text.push_str(&format!("# {line}\n"));
    }
    Ok((value, text))
}

/// What the shot's method keeps from frame to frame, if it keeps anything.
fn kept(shot: &Shot) -> Option<String> {
    let (method, size) = (shot.render.estimator()?, UVec2::from(shot.image.size));
    let all = method.kept_bytes(size, shot.image.rays_per_pixel).all;
    let of_pixel = all as f64 / f64::from(size.x) / f64::from(size.y);
    let (word, twice) = (method.word(), memory::in_words(2 * all));
    (all > 0).then(|| {
        format!("the method \"{word}\" keeps {of_pixel:.1} bytes of a pixel from frame to frame; two sets take {twice}")
    })
}

/// What moves in a shot: objects, and the camera at its keys or at both ends. A shot whose meshes are not all there says nothing.
fn motion(shot: Shot, source: Source, notes: &mut Notes) -> Result<Vec<String>> {
    let listed = probe_files(&shot, &source)?.listed().unwrap_or_default();
    let frames = match shot.render.frames.as_str() {
        "" => listed,
        text => range::parse(text)?,
    };
    let ends = [frames.first(), frames.last()].map(|frame| frame.copied().unwrap_or(1));
    let flags = RenderFlags::default();
    let setup = match Setup::load(shot, source, ends[0], &flags, notes) {
        Err(error) if error.kind == Kind::Input => return Ok(Vec::new()),
        setup => setup?,
    };
    let mut lines: Vec<String> = setup
        .motions()
        .into_iter()
        .map(|(object, what)| format!("object.{object}: {what}, from frame {} on", setup.first))
        .collect();
    let keys = &setup.shot.camera.keys;
    let shown = match keys.is_empty() {
        true => ends.to_vec(),
        false => keys.iter().map(|key| key.frame).collect(),
    };
    for frame in shown.into_iter().filter(|_| setup.has_moving_camera()) {
        let camera = setup.camera(frame)?;
        let (eye, target) = (camera.eye, camera.target);
        lines.push(format!(
            "camera in frame {frame}: eye {eye}, target {target}"
        ));
    }
    Ok(lines)
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
