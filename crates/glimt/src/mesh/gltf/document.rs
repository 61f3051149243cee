//! Host file: a glTF file's container and its JSON, checked before anything is read of it.

use crate::error::{Error, Result};
use crate::notes::Notes;
use ::gltf::json::camera::Type as CameraType;
use ::gltf::json::validation::Error::Missing;
use ::gltf::json::validation::{Checked, Validate};
use ::gltf::json::{Path as JsonPath, Root, deserialize};
use ::gltf::{Document, Glb, binary};
use serde_json::Value;
use std::path::Path;

/// The extensions that are honoured.
pub(super) const SUPPORTED: [&str; 7] = [
    "EXT_mesh_gpu_instancing",
    "EXT_texture_webp",
    "KHR_materials_emissive_strength",
    "KHR_materials_unlit",
    "KHR_mesh_quantization",
    "KHR_node_visibility",
    "KHR_texture_transform",
];

/// The document of a file and the data that a `.glb` brings along. What is allowed but cannot be used is taken out of it, with a
/// remark.
///
/// # Errors
/// The file is truncated, its JSON is not glTF, refers to things that it has not, or requires an extension that is not supported.
pub(super) fn parse(
    file: &Path,
    bytes: &[u8],
    notes: &mut Notes,
) -> Result<(Document, Option<Vec<u8>>)> {
    let (json, blob) = split(bytes).map_err(|e| broken(file, e))?;
    let not_json = |e| broken(file, ::gltf::Error::Deserialize(e));
    let mut json: Value = deserialize::from_slice(&json).map_err(not_json)?;
    // Extensions first: a file that requires one may well be invalid without it.
    refuse_extensions(file, &mut json)?;
    leave_out_channels(file, &mut json, notes)?;
    let root: Root = deserialize::from_value(json).map_err(not_json)?;
    check(file, &root)?;
    validate(file, &root)?;
    Ok((Document::from_json_without_validation(root), blob))
}

/// The crate's own checks, but for two things that it wants and that nothing here needs: bounds of positions, and the buffer view of
/// an accessor, which is zero without one.
fn validate(file: &Path, root: &Root) -> Result<()> {
    let mut first = None;
    root.validate(root, JsonPath::new, &mut |path, error| {
        let path = path();
        let place = path.as_str();
        let is_needless = error == Missing
            && (place.ends_with(".min") || place.ends_with(".max"))
            && place.starts_with("meshes[")
            || error == Missing
                && place.ends_with("].bufferView")
                && place.starts_with("accessors[");
        if !is_needless && first.is_none() {
            first = Some((path, error));
        }
    });
    match first {
        None => Ok(()),
        Some((path, error)) => Err(invalid(file, path, error)),
    }
}

/// The JSON of a file, and the data behind it.
fn split(bytes: &[u8]) -> std::result::Result<(Vec<u8>, Option<Vec<u8>>), ::gltf::Error> {
    if !bytes.starts_with(b"glTF") {
        let json = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
        return Ok((json.to_vec(), None));
    }
    // The crate takes the header's length off this number.
    let length = bytes.get(8..12).map(|b| [b[0], b[1], b[2], b[3]]);
    if length.is_some_and(|length| u32::from_le_bytes(length) < 12) {
        let (length, length_read) = (12, bytes.len());
        return Err(binary::Error::Length {
            length,
            length_read,
        }
        .into());
    }
    let glb = Glb::from_slice(bytes)?;
    Ok((glb.json.into_owned(), glb.bin.map(|bin| bin.into_owned())))
}

pub(super) fn broken(file: &Path, error: ::gltf::Error) -> Error {
    use ::gltf::Error as E;
    use ::gltf::binary::Error as B;
    let truncated = "it is probably truncated: copy or export it again";
    match error {
        E::Io(e) | E::Binary(B::Io(e)) => Error::reading(file, &e),
        E::Binary(B::Length {
            length,
            length_read,
        }) => {
            let what =
                format!("the file ends too early: {length_read} of {length} bytes are there");
            Error::input(file, what).fix(truncated)
        }
        E::Binary(B::ChunkLength {
            length,
            length_read,
            ..
        }) => {
            let what = format!("a chunk ends too early: {length_read} of {length} bytes are there");
            Error::input(file, what).fix(truncated)
        }
        E::Deserialize(e) if e.is_eof() => {
            Error::input(file, "the file ends too early").fix(truncated)
        }
        E::Deserialize(e) => Error::input(file, format!("its JSON is not glTF: {e}")),
        e => Error::input(file, format!("it is broken: {e}")).fix("export it again"),
    }
}

fn invalid(file: &Path, place: impl std::fmt::Display, what: impl std::fmt::Display) -> Error {
    Error::input(file, what)
        .at(place)
        .fix("the file is broken: export it again")
}

/// Refuses what is required and not supported. Otherwise the list is emptied: the crate knows less than this reader.
fn refuse_extensions(file: &Path, json: &mut Value) -> Result<()> {
    let Some(required) = json.get_mut("extensionsRequired").map(Value::take) else {
        return Ok(());
    };
    json["extensionsRequired"] = Value::Array(Vec::new());
    let names = required.as_array().into_iter().flatten();
    for name in names.filter_map(Value::as_str) {
        if SUPPORTED.contains(&name) {
            continue;
        }
        let fix = match name {
            "KHR_draco_mesh_compression"
            | "EXT_meshopt_compression"
            | "KHR_meshopt_compression" => "`gltf-transform copy in.glb out.glb` decodes it",
            "KHR_texture_basisu" => {
                "`gltf-transform ktxdecompress in.glb out.glb` decodes it, with `ktx` of KTX-Software"
            }
            "KHR_materials_pbrSpecularGlossiness" => {
                "`gltf-transform metalrough in.glb out.glb` converts it"
            }
            _ => "export it without this extension",
        };
        let what = format!("it requires {name}, which is not supported");
        return Err(Error::input(file, what).fix(fix));
    }
    Ok(())
}

/// Takes out the channels of animations that move no node, and those that move what is not supported.
fn leave_out_channels(file: &Path, json: &mut Value, notes: &mut Notes) -> Result<()> {
    let nodes = json["nodes"].as_array().map_or(0, Vec::len) as u64;
    let Some(animations) = json.get_mut("animations").and_then(Value::as_array_mut) else {
        return Ok(());
    };
    for (index, animation) in animations.iter_mut().enumerate() {
        let unnamed = format!("animation {index}");
        let name = animation["name"].as_str().unwrap_or(&unnamed).to_owned();
        let Some(channels) = animation.get_mut("channels").and_then(Value::as_array_mut) else {
            continue;
        };
        let mut kept = Vec::with_capacity(channels.len());
        for (number, channel) in channels.drain(..).enumerate() {
            let target = &channel["target"];
            let path = target["path"].as_str().unwrap_or_default();
            if path == "pointer" || target["extensions"]["KHR_animation_pointer"].is_object() {
                let what = format!(
                    "animation `{name}` uses KHR_animation_pointer, which is not supported"
                );
                let workaround = "what it moves stands still; bake it into node animations";
                notes.defect(file, &what, workaround)?;
                continue;
            }
            let Some(node) = target.get("node") else {
                let what =
                    format!("a channel of animation `{name}` has no node, and moves nothing");
                notes.note(file, what);
                continue;
            };
            let place = format!("animations[{index}].channels[{number}].target");
            if node.as_u64().is_none_or(|node| node >= nodes) {
                return Err(invalid(file, place + ".node", "Index out of bounds"));
            }
            if !["translation", "rotation", "scale", "weights"].contains(&path) {
                return Err(invalid(file, place + ".path", "Invalid value"));
            }
            kept.push(channel);
        }
        *channels = kept;
    }
    Ok(())
}

/// What the crate relies on without checking it.
fn check(file: &Path, root: &Root) -> Result<()> {
    for (i, mesh) in root.meshes.iter().enumerate() {
        for (j, primitive) in mesh.primitives.iter().enumerate() {
            let mut values = primitive.attributes.values();
            if values.any(|accessor| accessor.value() >= root.accessors.len()) {
                let place = format!("meshes[{i}].primitives[{j}].attributes");
                return Err(invalid(file, place, "Index out of bounds"));
            }
        }
    }
    for (i, camera) in root.cameras.iter().enumerate() {
        let is_there = match camera.type_ {
            Checked::Valid(CameraType::Perspective) => camera.perspective.is_some(),
            Checked::Valid(CameraType::Orthographic) => camera.orthographic.is_some(),
            Checked::Invalid => false,
        };
        if !is_there {
            return Err(invalid(file, format!("cameras[{i}]"), "Missing data"));
        }
    }
    Ok(())
}
