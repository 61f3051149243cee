//! Host file: glTF files with all that a file may have: pictures, skins, morph targets, animations, cameras, instances, extensions.

use super::images::{encoded, picture, png_of};
use image::ImageFormat;
use serde_json::{Value, json};

type Files = Vec<(String, Vec<u8>)>;

const FLOAT: u32 = 5126;
const USHORT: u32 = 5123;
const UBYTE: u32 = 5121;

/// The buffer of a file, and what names its parts.
#[derive(Default)]
struct Parts {
    bytes: Vec<u8>,
    views: Vec<Value>,
    accessors: Vec<Value>,
}

impl Parts {
    fn view(&mut self, bytes: &[u8]) -> usize {
        self.bytes.resize(self.bytes.len().next_multiple_of(4), 0);
        let (offset, length) = (self.bytes.len(), bytes.len());
        self.views
            .push(json!({"buffer": 0, "byteOffset": offset, "byteLength": length}));
        self.bytes.extend(bytes);
        self.views.len() - 1
    }

    fn accessor(&mut self, bytes: &[u8], component: u32, kind: &str, count: usize) -> usize {
        let view = self.view(bytes);
        self.accessors.push(json!({
            "bufferView": view, "byteOffset": 0, "componentType": component, "count": count, "type": kind,
        }));
        self.accessors.len() - 1
    }

    /// Vectors of floats.
    fn floats(&mut self, kind: &str, width: usize, values: &[f32]) -> usize {
        let bytes: Vec<u8> = values.iter().flat_map(|v| v.to_le_bytes()).collect();
        self.accessor(&bytes, FLOAT, kind, values.len() / width)
    }

    fn words(&mut self, values: &[u16]) -> usize {
        let bytes: Vec<u8> = values.iter().flat_map(|v| v.to_le_bytes()).collect();
        self.accessor(&bytes, USHORT, "SCALAR", values.len())
    }
}

const QUAD: [f32; 12] = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 0.0];

/// A document without its buffers, and their bytes.
fn everything() -> Result<(Value, Vec<u8>), String> {
    let mut parts = Parts::default();
    let position = parts.floats("VEC3", 3, &QUAD);
    parts.accessors[position]["min"] = json!([0, 0, 0]);
    parts.accessors[position]["max"] = json!([1, 1, 0]);
    let normal = parts.floats("VEC3", 3, &[0.0, 0.0, 1.0].repeat(4));
    let tangent = parts.floats("VEC4", 4, &[1.0, 0.0, 0.0, 1.0].repeat(4));
    let uv = parts.floats("VEC2", 2, &[0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0, 1.0]);
    let colour = parts.floats("VEC4", 4, &[1.0, 0.5, 0.2, 1.0].repeat(4));
    let joints = parts.accessor(&[0, 1, 0, 0].repeat(4), UBYTE, "VEC4", 4);
    let weights = parts.floats("VEC4", 4, &[0.5, 0.5, 0.0, 0.0].repeat(4));
    let corners = parts.words(&[0, 1, 2, 0, 2, 3]);
    let morph = parts.floats("VEC3", 3, &[0.0, 0.0, 0.5].repeat(4));
    let identity = glam::Mat4::IDENTITY.to_cols_array();
    let inverse = parts.floats("MAT4", 16, &identity.repeat(2));
    let times = parts.floats("SCALAR", 1, &[0.0, 0.02, 0.08]);
    let moves = parts.floats("VEC3", 3, &[0.0, 0.0, 0.0, 0.1, 0.0, 0.0, 0.0, 0.2, 0.0]);
    let turns = parts.floats("VEC4", 4, &[0.0, 0.0, 0.0, 1.0].repeat(9));
    let sizes = parts.floats("VEC3", 3, &[1.0; 9]);
    let morphs = parts.floats("SCALAR", 1, &[0.0, 0.5, 1.0]);
    let places = parts.floats("VEC3", 3, &[0.0, 0.0, 0.0, 2.0, 0.0, 0.0]);
    let (sparse_at, sparse) = (parts.view(&[1, 0]), parts.view(&[0; 12]));
    let picture = parts.view(&png_of(&picture().into())?);
    let sparse_position = parts.floats("VEC3", 3, &QUAD);
    parts.accessors[sparse_position]["min"] = json!([0, 0, 0]);
    parts.accessors[sparse_position]["max"] = json!([1, 1, 0]);
    parts.accessors[sparse_position]["sparse"] = json!({
        "count": 1, "indices": {"bufferView": sparse_at, "componentType": USHORT}, "values": {"bufferView": sparse},
    });
    let document = json!({
        "asset": {"version": "2.0", "generator": "glimt"},
        "extensionsUsed": ["KHR_texture_transform", "KHR_materials_unlit", "KHR_materials_emissive_strength", "EXT_mesh_gpu_instancing",
            "KHR_lights_punctual"],
        "extensions": {"KHR_lights_punctual": {"lights": [{"type": "point", "intensity": 3.0}]}},
        "scene": 0,
        "scenes": [{"name": "all", "nodes": [0, 1, 4, 6]}],
        "nodes": [
            {"name": "root", "translation": [0, 0, 1], "rotation": [0, 0, 0, 1], "scale": [1, 1, 1], "children": [2, 3], "mesh": 0},
            {"name": "skinned", "mesh": 1, "skin": 0, "weights": [0.25]},
            {"name": "bone", "children": [5]},
            {"name": "inner", "matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 3, 0, 0, 1], "mesh": 2},
            {"name": "view", "camera": 0, "translation": [0, 0, 5]},
            {"name": "tip"},
            {"name": "many", "mesh": 0, "extensions": {"EXT_mesh_gpu_instancing": {"attributes": {"TRANSLATION": places}}}},
        ],
        "cameras": [
            {"name": "seen", "type": "perspective", "perspective": {"yfov": 0.6, "znear": 0.1, "zfar": 100, "aspectRatio": 1.5}},
            {"type": "orthographic", "orthographic": {"xmag": 1, "ymag": 1, "zfar": 10, "znear": 0.1}},
        ],
        "skins": [{"joints": [2, 5], "skeleton": 2, "inverseBindMatrices": inverse}],
        "meshes": [
            {"name": "quad", "primitives": [
                {"attributes": {"POSITION": position, "NORMAL": normal, "TANGENT": tangent, "TEXCOORD_0": uv, "COLOR_0": colour},
                    "indices": corners, "material": 0},
                {"attributes": {"POSITION": position}, "mode": 5, "material": 1},
                {"attributes": {"POSITION": position}, "mode": 6, "material": 2},
                {"attributes": {"POSITION": position}, "mode": 1},
            ]},
            {"name": "moved", "weights": [0.5], "primitives": [
                {"attributes": {"POSITION": position, "JOINTS_0": joints, "WEIGHTS_0": weights, "TEXCOORD_0": uv},
                    "indices": corners, "targets": [{"POSITION": morph, "NORMAL": morph}], "material": 3},
            ]},
            {"name": "sparse", "primitives": [{"attributes": {"POSITION": sparse_position}, "indices": corners}]},
        ],
        "materials": [
            {"name": "all", "pbrMetallicRoughness": {"baseColorFactor": [0.8, 0.7, 0.6, 0.5], "metallicFactor": 0.5, "roughnessFactor": 0.4,
                "baseColorTexture": {"index": 0, "texCoord": 0,
                    "extensions": {"KHR_texture_transform": {"offset": [0.5, 0.25], "rotation": 0.3, "scale": [2, 2], "texCoord": 0}}},
                "metallicRoughnessTexture": {"index": 0}},
                "normalTexture": {"index": 0, "scale": 0.5}, "occlusionTexture": {"index": 0, "strength": 0.5},
                "emissiveFactor": [1, 0.5, 0], "emissiveTexture": {"index": 0}, "doubleSided": true, "alphaMode": "BLEND",
                "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 4.0}}},
            {"name": "mask", "alphaMode": "MASK", "alphaCutoff": 0.5, "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}},
            {"name": "unlit", "extensions": {"KHR_materials_unlit": {}}},
            {"name": "plain"},
        ],
        "textures": [{"source": 0, "sampler": 0}],
        "images": [{"bufferView": picture, "mimeType": "image/png"}],
        "samplers": [{"magFilter": 9729, "minFilter": 9987, "wrapS": 33071, "wrapT": 33648}],
        "animations": [{"name": "all", "channels": [
                {"sampler": 0, "target": {"node": 0, "path": "translation"}},
                {"sampler": 1, "target": {"node": 5, "path": "rotation"}},
                {"sampler": 2, "target": {"node": 3, "path": "scale"}},
                {"sampler": 3, "target": {"node": 1, "path": "weights"}},
            ], "samplers": [
                {"input": times, "output": moves, "interpolation": "LINEAR"},
                {"input": times, "output": turns, "interpolation": "CUBICSPLINE"},
                {"input": times, "output": sizes, "interpolation": "STEP"},
                {"input": times, "output": morphs},
            ]}],
        "accessors": parts.accessors,
        "bufferViews": parts.views,
    });
    // What cannot be animated where a matrix stands is not.
    let mut document = document;
    document["nodes"][3] = json!({"name": "inner", "translation": [3, 0, 0], "mesh": 2});
    Ok((document, parts.bytes))
}

/// A small one, of one triangle, and one whose nodes are a long chain.
fn small(nodes: usize) -> (Value, Vec<u8>) {
    let mut parts = Parts::default();
    let position = parts.floats("VEC3", 3, &QUAD);
    parts.accessors[position]["min"] = json!([0, 0, 0]);
    parts.accessors[position]["max"] = json!([1, 1, 0]);
    let corners = parts.words(&[0, 1, 2]);
    let mut chain: Vec<Value> = (1..nodes).map(|i| json!({"children": [i]})).collect();
    chain.push(json!({"mesh": 0}));
    let document = json!({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": chain,
        "meshes": [{"primitives": [{"attributes": {"POSITION": position}, "indices": corners}]}],
        "accessors": parts.accessors, "bufferViews": parts.views,
    });
    (document, parts.bytes)
}

fn documents() -> Result<[(Value, Vec<u8>); 3], String> {
    Ok([everything()?, small(1), small(40)])
}

/// As JSON with a file of bytes, and as JSON that holds them.
pub(super) fn text() -> Result<Vec<Files>, String> {
    let mut all = Vec::new();
    for (mut document, bytes) in documents()? {
        document["buffers"] = json!([{"byteLength": bytes.len(), "uri": "a%20b.bin"}]);
        all.push(vec![
            ("a.gltf".to_owned(), document.to_string().into_bytes()),
            ("a b.bin".to_owned(), bytes),
        ]);
    }
    let (mut document, _) = small(1);
    // The four corners, and the indices 0, 1, 2.
    let data = "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAACAPwAAgD8AAAAAAAAAAAAAgD8AAAAAAAABAAIA";
    document["buffers"] = json!([{
        "byteLength": 54, "uri": format!("data:application/octet-stream;base64,{data}"),
    }]);
    all.push(vec![(
        "a.gltf".to_owned(),
        document.to_string().into_bytes(),
    )]);
    Ok(all)
}

/// A triangle with a picture in a file of its own, in each format that a picture may have.
pub(super) fn textured() -> Result<Vec<Files>, String> {
    let mut all = Vec::new();
    for (extension, format) in [
        ("png", ImageFormat::Png),
        ("jpg", ImageFormat::Jpeg),
        ("webp", ImageFormat::WebP),
    ] {
        let name = format!("a.{extension}");
        let (mut document, mut bytes) = small(1);
        let uv = bytes.len().next_multiple_of(4);
        bytes.resize(uv + 32, 0);
        if let Some(views) = document["bufferViews"].as_array_mut() {
            views.push(json!({"buffer": 0, "byteOffset": uv, "byteLength": 32}));
        }
        if let Some(accessors) = document["accessors"].as_array_mut() {
            accessors
                .push(json!({"bufferView": 2, "componentType": FLOAT, "count": 4, "type": "VEC2"}));
        }
        document["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"] = json!(2);
        document["meshes"][0]["primitives"][0]["material"] = json!(0);
        document["materials"] =
            json!([{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}]);
        document["images"] = json!([{"uri": name}]);
        document["textures"] = json!([{"source": 0}]);
        if extension == "webp" {
            document["extensionsUsed"] = json!(["EXT_texture_webp"]);
            document["textures"] = json!([{"extensions": {"EXT_texture_webp": {"source": 0}}}]);
        }
        document["buffers"] = json!([{"byteLength": bytes.len(), "uri": "a.bin"}]);
        all.push(vec![
            ("a.gltf".to_owned(), document.to_string().into_bytes()),
            ("a.bin".to_owned(), bytes),
            (name, encoded(&picture().into(), format)?),
        ]);
    }
    Ok(all)
}

/// In one file.
pub(super) fn binary() -> Result<Vec<Vec<u8>>, String> {
    let mut all = Vec::new();
    for (mut document, bytes) in documents()? {
        document["buffers"] = json!([{"byteLength": bytes.len()}]);
        let mut bytes = bytes;
        bytes.resize(bytes.len().next_multiple_of(4), 0);
        let head = glimt::bake::glb::head(&document, bytes.len() as u64);
        let mut file = head.ok_or("a .glb: it is too long")?;
        file.extend(bytes);
        all.push(file);
    }
    Ok(all)
}
