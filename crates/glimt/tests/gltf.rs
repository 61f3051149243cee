//! Host file: what glTF files may hold beyond plain meshes, against values that the specification gives.

mod common;

use common::{Scratch, glb, read_exr};
use glam::{Affine2, Mat4, Quat, Vec2, Vec3, Vec4};
use glimt::cli::{Device, PrintFlags, RenderFlags};
use glimt::error::Result;
use glimt::job::Job;
use glimt::mesh;
use glimt::mesh::model::Model;
use glimt::notes::{Notes, Severity};
use glimt::report::Reporter;
use glimt::setup::Setup;
use glimt_render_gpu::prepare::scene::{Opacity, Reflection};
use glimt_render_gpu::prepare::scene_build::SceneBuffers;
use serde_json::{Value, json};
use std::io::Cursor;

const BYTE: u32 = 5120;
const UNSIGNED_BYTE: u32 = 5121;
const SHORT: u32 = 5122;
const UNSIGNED_SHORT: u32 = 5123;
const UNSIGNED_INT: u32 = 5125;
const FLOAT: u32 = 5126;

/// A file that is being made.
struct File {
    json: Value,
    binary: Vec<u8>,
}

fn floats(values: &[f32]) -> Vec<u8> {
    values.iter().flat_map(|f| f.to_le_bytes()).collect()
}

fn shorts(values: &[i32]) -> Vec<u8> {
    let two = |i: &i32| [i.to_le_bytes()[0], i.to_le_bytes()[1]];
    values.iter().flat_map(two).collect()
}

fn bytes(values: &[i32]) -> Vec<u8> {
    values.iter().map(|i| i.to_le_bytes()[0]).collect()
}

/// Of a unit square in z = 0: four corners.
const SQUARE: [f32; 12] = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 0.0];

impl File {
    /// A square with normals along z, at node 0.
    fn square() -> Self {
        let mut file = Self {
            json: json!({
                "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
                "meshes": [{"name": "square", "primitives": [{"attributes": {}, "material": 0}]}],
                "materials": [{"name": "paint"}], "accessors": [], "bufferViews": [], "buffers": [{}],
            }),
            binary: Vec::new(),
        };
        file.attribute("POSITION", FLOAT, "VEC3", floats(&SQUARE));
        file.attribute("NORMAL", FLOAT, "VEC3", floats(&[0.0, 0.0, 1.0].repeat(4)));
        let faces: Vec<u8> = [0u32, 1, 2, 0, 2, 3]
            .iter()
            .flat_map(|i| i.to_le_bytes())
            .collect();
        let faces = file.accessor(UNSIGNED_INT, "SCALAR", faces);
        file.primitive()["indices"] = json!(faces);
        file
    }

    fn primitive(&mut self) -> &mut Value {
        &mut self.json["meshes"][0]["primitives"][0]
    }

    fn list(&mut self, key: &str) -> &mut Vec<Value> {
        if self.json[key].is_null() {
            self.json[key] = json!([]);
        }
        self.json[key].as_array_mut().expect("a list")
    }

    fn view(&mut self, bytes: Vec<u8>) -> usize {
        self.binary.resize(self.binary.len().next_multiple_of(4), 0);
        let view = json!({"buffer": 0, "byteOffset": self.binary.len(), "byteLength": bytes.len()});
        self.binary.extend(bytes);
        self.list("bufferViews").push(view);
        self.list("bufferViews").len() - 1
    }

    /// Packed values; whole ones are fractions, but for indices and joints.
    fn accessor(&mut self, component: u32, kind: &str, bytes: Vec<u8>) -> usize {
        let size = match component {
            BYTE | UNSIGNED_BYTE => 1,
            SHORT | UNSIGNED_SHORT => 2,
            _ => 4,
        };
        let width = match kind {
            "SCALAR" => 1,
            "VEC2" => 2,
            "VEC3" => 3,
            "MAT4" => 16,
            _ => 4,
        };
        let count = bytes.len() / (size * width);
        let view = self.view(bytes);
        self.list("accessors").push(json!({
            "bufferView": view, "componentType": component, "count": count, "type": kind,
            "min": [0, 0, 0], "max": [1, 1, 1],
        }));
        self.list("accessors").len() - 1
    }

    fn attribute(&mut self, name: &str, component: u32, kind: &str, bytes: Vec<u8>) -> usize {
        let accessor = self.accessor(component, kind, bytes);
        self.primitive()["attributes"][name] = json!(accessor);
        accessor
    }

    fn animate(
        &mut self,
        name: &str,
        node: usize,
        path: &str,
        how: &str,
        times: &[f32],
        values: &[f32],
    ) {
        let input = self.accessor(FLOAT, "SCALAR", floats(times));
        let kind = match path {
            "weights" => "SCALAR",
            "rotation" => "VEC4",
            _ => "VEC3",
        };
        let output = self.accessor(FLOAT, kind, floats(values));
        self.list("animations").push(json!({
            "name": name,
            "channels": [{"sampler": 0, "target": {"node": node, "path": path}}],
            "samplers": [{"input": input, "output": output, "interpolation": how}],
        }));
    }

    fn texture(&mut self, format: image::ImageFormat, texels: [[u8; 4]; 2]) -> usize {
        let mut encoded = Cursor::new(Vec::new());
        let picture = image::RgbaImage::from_raw(2, 1, texels.concat()).expect("two texels");
        picture.write_to(&mut encoded, format).expect("an image");
        let view = self.view(encoded.into_inner());
        let images = self.list("images");
        images.push(json!({"bufferView": view, "mimeType": "image/png"}));
        images.len() - 1
    }

    fn used(&mut self, extension: &str) {
        self.list("extensionsUsed").push(json!(extension));
    }

    fn bytes(&self) -> Vec<u8> {
        let mut json = self.json.clone();
        json["buffers"][0]["byteLength"] = json!(self.binary.len());
        glb(&json.to_string(), &self.binary)
    }

    fn load(&self, t: &Scratch) -> (Result<Model>, Notes) {
        t.put("a.glb", self.bytes());
        let mut notes = Notes::new(false);
        (mesh::load(&t.path, "a.glb", 40.0, &mut notes), notes)
    }

    /// Loads what is right; no remark is more than a note.
    fn model(&self) -> Model {
        let (model, warnings) = self.warned();
        assert_eq!(warnings, [""; 0]);
        model
    }

    fn warned(&self) -> (Model, Vec<String>) {
        let t = Scratch::new(&format!("gltf-{:?}", std::thread::current().id()));
        let (model, mut notes) = self.load(&t);
        let said = notes.take().into_iter();
        let warnings = said.filter(|note| note.severity == Severity::Warning);
        let model = model.unwrap_or_else(|e| panic!("{e}"));
        (model, warnings.map(|note| note.text).collect())
    }

    fn fails(&self, words: &[&str]) {
        let t = Scratch::new(&format!("gltf-{:?}", std::thread::current().id()));
        let error = self.load(&t).0.expect_err("an error").to_string();
        for word in words {
            assert!(error.contains(word), "`{word}` is not in: {error}");
        }
    }
}

fn close(found: &[Vec3], expected: &[Vec3]) {
    assert_eq!(found.len(), expected.len());
    for (a, b) in found.iter().zip(expected) {
        assert!(
            a.abs_diff_eq(*b, 2e-6 * (1.0 + b.length())),
            "{a} is not {b}"
        );
    }
}

fn square() -> Vec<Vec3> {
    SQUARE
        .as_chunks::<3>()
        .0
        .iter()
        .map(|p| Vec3::from(*p))
        .collect()
}

#[test]
fn vertex_colours_are_linear_fractions() {
    let expected = [
        Vec4::new(1.0, 0.0, 0.2, 1.0),
        Vec4::new(0.0, 1.0, 0.4, 1.0),
        Vec4::new(0.6, 0.0, 0.0, 1.0),
        Vec4::new(0.0, 0.0, 1.0, 1.0),
    ];
    let rgb: Vec<f32> = expected
        .iter()
        .flat_map(|c| c.to_array()[..3].to_vec())
        .collect();
    let whole = |range: f32, alpha: i32| -> Vec<i32> {
        let each = expected.iter().flat_map(|c| {
            let [r, g, b, _] = c.to_array().map(|c| (c * range).round() as i32);
            [r, g, b, alpha]
        });
        each.collect()
    };
    let kinds = [
        (FLOAT, "VEC3", floats(&rgb), 1.0),
        (UNSIGNED_BYTE, "VEC4", bytes(&whole(255.0, 51)), 0.2),
        (UNSIGNED_SHORT, "VEC4", shorts(&whole(65535.0, 13107)), 0.2),
    ];
    for (component, kind, packed, alpha) in kinds {
        let mut file = File::square();
        file.attribute("COLOR_0", component, kind, packed);
        let colors = &file.model().meshes[0].colors;
        assert_eq!(colors.len(), 4);
        for (found, expected) in colors.iter().zip(&expected) {
            let expected = expected.truncate().extend(alpha);
            assert!(found.abs_diff_eq(expected, 1e-6), "{found} {expected}");
        }
    }
    let mut bright = File::square();
    bright.attribute(
        "COLOR_0",
        FLOAT,
        "VEC3",
        floats(&[2.0, -1.0, 0.5].repeat(4)),
    );
    assert_eq!(
        bright.model().meshes[0].colors[0],
        Vec4::new(1.0, 0.0, 0.5, 1.0)
    );
    bright.attribute("COLOR_0", FLOAT, "VEC3", floats(&[f32::NAN; 12]));
    bright.fails(&["COLOR_0", "not finite", "mesh `square`, primitive 0"]);
}

#[test]
fn materials_let_light_pass_and_glow() {
    let mut file = File::square();
    file.attribute("TEXCOORD_0", FLOAT, "VEC2", floats(&[0.0; 8]));
    let image = file.texture(
        image::ImageFormat::Png,
        [[255, 0, 0, 128], [0, 255, 0, 255]],
    );
    file.json["textures"] = json!([{"source": image}]);
    let base = json!({"baseColorFactor": [0.5, 0.25, 1, 0.75], "baseColorTexture": {"index": 0}});
    let mut with = |key: &str, value: Value| {
        let mut material = json!({"name": "paint", "pbrMetallicRoughness": base});
        material[key] = value;
        file.json["materials"] = json!([material]);
        file.model().materials.swap_remove(0)
    };
    assert_eq!(with("alphaMode", json!("OPAQUE")).opacity, Opacity::Opaque);
    let Opacity::Mask { cutoff, alpha } = with("alphaMode", json!("MASK")).opacity else {
        panic!("not a mask");
    };
    assert_eq!((cutoff, alpha.factor), (0.5, 0.75));
    assert_eq!(alpha.texture.expect("a texture").texture, 0);
    let Opacity::Blend { alpha } = with("alphaMode", json!("BLEND")).opacity else {
        panic!("not blended");
    };
    assert_eq!(alpha.factor, 0.75);
    let glowing = with("emissiveFactor", json!([1, 0.5, 0.25]));
    assert_eq!(glowing.emission, Vec3::new(1.0, 0.5, 0.25));
    assert_eq!(glowing.emission_texture, None);

    file.json["materials"] = json!([{
        "emissiveFactor": [1, 0.5, 0.25], "emissiveTexture": {"index": 0},
        "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 8}},
        "alphaMode": "MASK", "alphaCutoff": 0.9,
    }]);
    let strong = &file.model().materials[0];
    assert_eq!(strong.emission, Vec3::new(8.0, 4.0, 2.0));
    assert!(strong.emission_texture.is_some());
    assert!(matches!(strong.opacity, Opacity::Mask { cutoff: 0.9, .. }));

    file.json["materials"] = json!([{
        "pbrMetallicRoughness": base, "emissiveFactor": [1, 1, 1], "extensions": {"KHR_materials_unlit": {}},
    }]);
    let unlit = &file.model().materials[0];
    assert_eq!(unlit.emission, Vec3::ZERO);
    let Reflection::Unlit {
        color,
        color_texture,
    } = unlit.reflection
    else {
        panic!("it is lit");
    };
    assert_eq!(color, Vec3::new(0.5, 0.25, 1.0));
    assert!(color_texture.is_some());
}

#[test]
fn textures_are_moved_and_may_be_webp() {
    let texels = [[10, 200, 30, 255], [250, 20, 120, 77]];
    for (required, rotation) in [(false, 0.0), (true, std::f32::consts::FRAC_PI_2)] {
        let mut file = File::square();
        file.attribute("TEXCOORD_1", FLOAT, "VEC2", floats(&[0.5; 8]));
        let image = file.texture(image::ImageFormat::WebP, texels);
        file.json["textures"] = json!([{"extensions": {"EXT_texture_webp": {"source": image}}}]);
        let extension =
            json!({"offset": [0.1, 0.2], "scale": [3, 2], "rotation": rotation, "texCoord": 1});
        file.json["materials"] = json!([{"pbrMetallicRoughness": {
            "baseColorTexture": {"index": 0, "extensions": {"KHR_texture_transform": extension}},
        }}]);
        for extension in ["EXT_texture_webp", "KHR_texture_transform"] {
            file.used(extension);
            if required {
                file.list("extensionsRequired").push(json!(extension));
            }
        }
        let model = file.model();
        assert_eq!(model.textures[0].texels, texels);
        assert_eq!(model.meshes[0].uvs, [Vec2::splat(0.5); 4]);
        let Reflection::MetallicRoughness {
            base_color_texture, ..
        } = model.materials[0].reflection
        else {
            panic!("another reflection");
        };
        let map: Affine2 = base_color_texture.expect("a texture").transform;
        // v grows downwards, so that a turn counter-clockwise takes +u to −v.
        let expected = match required {
            false => [
                Vec2::new(0.1, 0.2),
                Vec2::new(3.1, 0.2),
                Vec2::new(0.1, 2.2),
            ],
            true => [
                Vec2::new(0.1, 0.2),
                Vec2::new(0.1, -2.8),
                Vec2::new(2.1, 0.2),
            ],
        };
        for (point, expected) in [Vec2::ZERO, Vec2::X, Vec2::Y].into_iter().zip(expected) {
            let found = map.transform_point2(point);
            assert!(found.abs_diff_eq(expected, 1e-6), "{point}: {found}");
        }
    }
}

#[test]
fn what_a_material_loses_is_said() {
    let mut file = File::square();
    file.attribute("TEXCOORD_0", FLOAT, "VEC2", floats(&[0.0; 8]));
    let image = file.texture(
        image::ImageFormat::Png,
        [[255, 20, 0, 255], [255, 30, 0, 255]],
    );
    file.json["textures"] = json!([{}, {"source": image}]);
    let mut with = |material: Value| {
        file.json["materials"] = json!([material]);
        file.warned()
    };
    let (model, said) = with(json!({"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}));
    assert!(model.textures.is_empty());
    assert!(
        said.len() == 1 && said[0].contains("texture 0 has no image"),
        "{said:?}"
    );

    let transmission = json!({"KHR_materials_transmission": {"transmissionFactor": 1}});
    let (_, said) = with(json!({"name": "glass", "extensions": transmission}));
    assert!(
        said[0].contains("`glass` uses KHR_materials_transmission"),
        "{said:?}"
    );
    let off = json!({"KHR_materials_transmission": {"transmissionFactor": 0}});
    assert_eq!(with(json!({"extensions": off})).1, [""; 0]);

    let (_, said) = with(json!({"name": "chrome", "pbrMetallicRoughness": {"roughnessFactor": 0}}));
    assert!(said[0].contains("`chrome` has roughness 0.00"), "{said:?}");
    // The texture's mean is 25/255.
    let texture = json!({"metallicRoughnessTexture": {"index": 1}});
    let (_, said) = with(json!({"pbrMetallicRoughness": texture}));
    assert!(said[0].contains("roughness 0.10"), "{said:?}");

    let two = json!({
        "pbrMetallicRoughness": {"baseColorTexture": {"index": 1}}, "normalTexture": {"index": 1, "texCoord": 1},
    });
    assert!(with(two).1[0].contains("several sets of texture coordinates"));
    let elsewhere =
        json!({"pbrMetallicRoughness": {"baseColorTexture": {"index": 1, "texCoord": 3}}});
    assert!(with(elsewhere).1[0].contains("no texture coordinates 3"));
}

/// With `--strict` each of these is an error.
#[test]
fn strict_runs_refuse_what_looks_otherwise() {
    let t = Scratch::new("strict");
    let strict = |file: &File| {
        t.put("a.glb", file.bytes());
        mesh::load(&t.path, "a.glb", 40.0, &mut Notes::new(true))
    };
    let mut file = File::square();
    assert!(strict(&file).is_ok());
    for (material, word) in [
        (
            json!({"pbrMetallicRoughness": {"roughnessFactor": 0.1}}),
            "roughness 0.10",
        ),
        (
            json!({"extensions": {"KHR_materials_clearcoat": {"clearcoatFactor": 0.5}}}),
            "KHR_materials_clearcoat",
        ),
        (
            json!({"extensions": {"KHR_materials_sheen": {"sheenColorFactor": [0, 0, 1]}}}),
            "KHR_materials_sheen",
        ),
        (
            json!({"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}),
            "no image",
        ),
    ] {
        file.json["textures"] = json!([{}]);
        file.json["materials"] = json!([material]);
        let error = strict(&file).expect_err("an error").to_string();
        assert!(
            error.contains(word) && error.contains("--strict"),
            "{error}"
        );
    }
}

#[test]
fn without_normals_faces_are_flat() {
    // A ridge: two triangles at a right angle that share an edge.
    let mut file = File::square();
    let corners = [0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0];
    file.attribute("POSITION", FLOAT, "VEC3", floats(&corners));
    let faces: Vec<u8> = [0u32, 2, 1, 0, 1, 3]
        .iter()
        .flat_map(|i| i.to_le_bytes())
        .collect();
    let faces = file.accessor(UNSIGNED_INT, "SCALAR", faces);
    file.primitive()["indices"] = json!(faces);
    let attributes = file.primitive()["attributes"]
        .as_object_mut()
        .expect("a map");
    attributes.remove("NORMAL");
    let mesh = &file.model().meshes[0];
    let [first, second] = [0, 1].map(|face| mesh.indices[face].map(|i| mesh.normals[i as usize]));
    assert_eq!(first, [Vec3::Z; 3]);
    assert_eq!(second, [Vec3::X; 3]);
}

/// Each pose of a mesh without normals has those of its own faces.
#[test]
fn deformed_faces_are_flat_too() {
    let t = Scratch::new("flat-morph");
    let mut file = File::square();
    let attributes = file.primitive()["attributes"].as_object_mut();
    attributes.expect("a map").remove("NORMAL");
    // One corner rises: the triangle that has it leans by 45 degrees, the other stays.
    let mut corner = [0.0; 12];
    corner[11] = 1.0;
    let corner = file.accessor(FLOAT, "VEC3", floats(&corner));
    file.primitive()["targets"] = json!([{"POSITION": corner}]);
    file.animate("go", 0, "weights", "LINEAR", &[0.0, 1.0], &[0.0, 1.0]);
    let setup = load(&t, &file, "");
    let mut scene = SceneBuffers::build(&setup.scene).expect("a scene");
    let leaning = Vec3::new(1.0, -1.0, 1.0).normalize();
    for (frame, second) in [(15, leaning), (5, Vec3::Z), (15, leaning)] {
        let pose = setup.pose(frame).expect("a pose");
        let posed = scene.pose_shaped(&pose.transforms, &pose.shapes);
        posed.expect("it fits");
        let mesh = scene.mesh(0);
        let normals = mesh
            .indices
            .as_flattened()
            .iter()
            .map(|&i| mesh.normals[i as usize].normalize());
        let normals: Vec<Vec3> = normals.collect();
        close(&normals, &[[Vec3::Z; 3], [second; 3]].concat());
    }
}

#[test]
fn quantised_meshes_equal_their_float_twins() {
    let cases: [(u32, f32, bool); 8] = [
        (BYTE, 127.0, true),
        (UNSIGNED_BYTE, 255.0, true),
        (SHORT, 32767.0, true),
        (UNSIGNED_SHORT, 65535.0, true),
        (BYTE, 100.0, false),
        (UNSIGNED_BYTE, 200.0, false),
        (SHORT, 30000.0, false),
        (UNSIGNED_SHORT, 60000.0, false),
    ];
    for (component, range, normalised) in cases {
        let mut file = File::square();
        file.used("KHR_mesh_quantization");
        file.list("extensionsRequired")
            .push(json!("KHR_mesh_quantization"));
        let wide = matches!(component, SHORT | UNSIGNED_SHORT);
        // Elements begin at multiples of four bytes.
        let pack = |values: &[f32], width: usize| {
            let mut packed = Vec::new();
            for element in values.chunks(width) {
                let whole: Vec<i32> = element.iter().map(|v| (v * range) as i32).collect();
                let element = if wide { shorts(&whole) } else { bytes(&whole) };
                packed.extend(&element);
                packed.resize(packed.len().next_multiple_of(4), 0);
            }
            packed
        };
        let uvs = [0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0, 1.0];
        let normals = [0.0, 0.0, 1.0].repeat(4);
        let tangents = [1.0, 0.0, 0.0, 1.0].repeat(4);
        let lists: [(&str, &str, &[f32], usize); 4] = [
            ("POSITION", "VEC3", &SQUARE, 3),
            ("NORMAL", "VEC3", &normals, 3),
            ("TANGENT", "VEC4", &tangents, 4),
            ("TEXCOORD_0", "VEC2", &uvs, 2),
        ];
        for (name, kind, values, width) in lists {
            let view = file.view(pack(values, width));
            let size = if wide { 2 } else { 1 };
            file.json["bufferViews"][view]["byteStride"] =
                json!((width * size).next_multiple_of(4));
            file.list("accessors").push(json!({
                "bufferView": view, "componentType": component, "count": 4, "type": kind,
                "normalized": normalised, "min": [0, 0, 0], "max": [1, 1, 1],
            }));
            let accessor = file.list("accessors").len() - 1;
            file.primitive()["attributes"][name] = json!(accessor);
        }
        let mesh = &file.model().meshes[0];
        let scale = if normalised { 1.0 } else { range };
        let expected: Vec<Vec3> = square().iter().map(|p| *p * scale).collect();
        assert_eq!(mesh.positions, expected);
        assert!(mesh.normals.iter().all(|n| n.normalize() == Vec3::Z));
        let uvs: Vec<Vec2> = square().iter().map(|p| p.truncate() * scale).collect();
        assert_eq!(mesh.uvs, uvs);
        assert_eq!(mesh.tangents[0].truncate().normalize(), Vec3::X);
    }
    // The least whole number is −1, too.
    let mut file = File::square();
    file.used("KHR_mesh_quantization");
    let least: Vec<i32> = [-128, -127, 127, 0].repeat(4);
    file.attribute("POSITION", BYTE, "VEC4", bytes(&least));
    file.fails(&["POSITION has the wrong type"]);
    file.attribute("NORMAL", BYTE, "VEC3", bytes(&[-128, -127, 127].repeat(4)));
    let last = file.list("accessors").len() - 1;
    file.json["accessors"][last]["normalized"] = json!(true);
    file.primitive()["attributes"]["POSITION"] = json!(0);
    assert_eq!(
        file.model().meshes[0].normals[0],
        Vec3::new(-1.0, -1.0, 1.0)
    );
    // Core glTF has floats alone.
    file.json["extensionsUsed"] = json!([]);
    file.fails(&["NORMAL has the wrong type", "mesh `square`, primitive 0"]);
}

#[test]
fn all_instances_are_placed() {
    let mut file = File::square();
    let translations = file.accessor(FLOAT, "VEC3", floats(&[1.0, 2.0, 3.0, -4.0, 0.0, 0.0]));
    let scales = file.accessor(FLOAT, "VEC3", floats(&[1.0, 1.0, 1.0, 2.0, 3.0, 1.0]));
    // A quarter turn about z, as whole numbers.
    let half = (std::f32::consts::FRAC_1_SQRT_2 * 32767.0).round() as i32;
    let rotations = file.accessor(SHORT, "VEC4", shorts(&[0, 0, 0, 32767, 0, 0, half, half]));
    file.json["nodes"] = json!([{"mesh": 0, "translation": [0, 0, 10], "extensions": {"EXT_mesh_gpu_instancing":
        {"attributes": {"TRANSLATION": translations, "ROTATION": rotations, "SCALE": scales}}}}]);
    let model = file.model();
    let rest = model.rest();
    let places: Vec<Mat4> = model
        .parts
        .iter()
        .map(|part| rest.to_file[part.node])
        .collect();
    assert_eq!(places.len(), 2);
    let corner = Vec3::new(1.0, 1.0, 0.0);
    let found = [places[0], places[1]].map(|place| place.transform_point3(corner));
    close(
        &found,
        &[Vec3::new(2.0, 3.0, 13.0), Vec3::new(-7.0, 2.0, 10.0)],
    );
    file.json["accessors"][scales]["count"] = json!(1);
    file.fails(&[
        "node 0, EXT_mesh_gpu_instancing",
        "different numbers of instances",
    ]);
    file.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["SCALE"] =
        json!(99);
    file.fails(&["SCALE has no accessor"]);
}

/// A square whose left side follows joint 1 and whose right side follows joint 2. Its own node is far smaller.
fn skinned() -> File {
    let mut file = File::square();
    let joints = [0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0];
    file.attribute("JOINTS_0", UNSIGNED_BYTE, "VEC4", bytes(&joints));
    // They need not add up to 1.
    file.attribute(
        "WEIGHTS_0",
        FLOAT,
        "VEC4",
        floats(&[0.5, 0.0, 0.0, 0.0].repeat(4)),
    );
    let bind = [Mat4::IDENTITY, Mat4::from_translation(Vec3::NEG_X)];
    let bind: Vec<f32> = bind.iter().flat_map(Mat4::to_cols_array).collect();
    let bind = file.accessor(FLOAT, "MAT4", floats(&bind));
    file.json["skins"] = json!([{"name": "rig", "joints": [1, 2], "inverseBindMatrices": bind}]);
    file.json["scenes"] = json!([{"nodes": [1, 3]}]);
    file.json["nodes"] = json!([
        {"name": "body", "mesh": 0, "skin": 0},
        {"name": "root", "children": [2]},
        {"name": "tip", "translation": [1, 0, 0]},
        {"name": "armature", "scale": [0.01, 0.01, 0.01], "children": [0]},
    ]);
    file
}

fn load(t: &Scratch, file: &File, object: &str) -> Setup {
    t.put("a.glb", file.bytes());
    t.exr("light.exr", 8, 4, |x, y, c| {
        (1 + (x * 3 + y + c) % 5) as f32
    });
    t.put(
        "shot.toml",
        format!(
            "[image]\nsize = [24, 18]\nrays_per_pixel = 2\n[probe]\nframes = \"light.exr\"\nfps = 10\n\
             [render]\nframes = \"5-30\"\n[output]\nvideo = \"\"\n[[object]]\nmesh = \"a.glb\"\nup = \"z\"\n{object}\n"
        ),
    );
    let flags = RenderFlags {
        device: Device::Cpu,
        ..RenderFlags::default()
    };
    let reporter = Reporter::new(PrintFlags {
        quiet: true,
        json: false,
        verbose: 0,
    });
    let mut notes = Notes::new(false);
    let job = Job::from_file(&t.file("shot.toml"), &flags, &mut notes, &reporter);
    job.unwrap_or_else(|e| panic!("{e}")).setup
}

/// The vertices of the first object in the world, in a frame.
fn positions(setup: &Setup, frame: i32) -> Vec<Vec3> {
    let pose = setup.pose(frame).expect("a pose");
    let mesh = setup.scene.objects[0].mesh as usize;
    let rest = &setup.scene.meshes[mesh].positions;
    let list = pose.shapes.first().map_or(rest, |shape| &shape.positions);
    list.iter()
        .map(|p| pose.transforms[0].transform_point3(*p))
        .collect()
}

#[test]
fn a_skin_ignores_its_own_node() {
    let t = Scratch::new("skin");
    let setup = load(&t, &skinned(), "");
    close(&positions(&setup, 5), &square());
    assert!(
        setup.pose(5).expect("a pose").shapes.is_empty(),
        "nothing moves"
    );
    // Where the object stands counts.
    let setup = load(&t, &skinned(), "scale = 3\ntranslate = [0, 0, 1]");
    let placed: Vec<Vec3> = square().iter().map(|p| *p * 3.0 + Vec3::Z).collect();
    close(&positions(&setup, 5), &placed);
}

#[test]
fn joints_bend_meshes() {
    let t = Scratch::new("joints");
    let mut file = skinned();
    // The tip turns by a right angle about y from frame 5 to 15, the root rises to 2.
    let quarter = Quat::from_rotation_y(std::f32::consts::FRAC_PI_2).to_array();
    let turn = [[0.0, 0.0, 0.0, 1.0], quarter].concat();
    file.animate("turn", 2, "rotation", "LINEAR", &[0.0, 1.0], &turn);
    let rise = [0.0, 0.0, 0.0, 0.0, 0.0, 2.0];
    file.animate("rise", 1, "translation", "LINEAR", &[0.0, 1.0], &rise);
    let setup = load(&t, &file, "");
    for frame in [5, 10, 15, 30] {
        let s = ((frame as f32 - 5.0) / 10.0).min(1.0);
        let turned = Mat4::from_rotation_y(s * std::f32::consts::FRAC_PI_2);
        let up = Vec3::Z * 2.0 * s;
        let expected: Vec<Vec3> = square()
            .iter()
            .map(|p| match p.x > 0.5 {
                true => Vec3::X + turned.transform_point3(*p - Vec3::X) + up,
                false => *p + up,
            })
            .collect();
        close(&positions(&setup, frame), &expected);
        let pose = setup.pose(frame).expect("a pose");
        let normal = turned.transform_vector3(Vec3::Z);
        close(&pose.shapes[0].normals[1..3], &[normal; 2]);
        close(&pose.shapes[0].normals[..1], &[Vec3::Z]);
    }
    // A joint moves the object, its node does not.
    let moved = setup.moving_object().expect("something moves");
    assert_eq!((moved.0, moved.1), (0, "animation"));
    let mut still = skinned();
    still.animate("armature", 3, "translation", "LINEAR", &[0.0, 1.0], &rise);
    let setup = load(&t, &still, "");
    assert_eq!(setup.moving_object(), None);
    close(&positions(&setup, 15), &square());
}

#[test]
fn weights_blend_and_broken_skins_are_refused() {
    let t = Scratch::new("weights");
    let mut file = skinned();
    // A quarter of the first joint, three of the second, over two sets.
    file.attribute("JOINTS_0", UNSIGNED_SHORT, "VEC4", shorts(&[0; 16]));
    file.attribute(
        "WEIGHTS_0",
        UNSIGNED_BYTE,
        "VEC4",
        bytes(&[51, 0, 0, 0].repeat(4)),
    );
    file.attribute("JOINTS_1", UNSIGNED_BYTE, "VEC4", bytes(&[1; 16]));
    file.attribute(
        "WEIGHTS_1",
        UNSIGNED_SHORT,
        "VEC4",
        shorts(&[13107, 26214, 0, 0].repeat(4)),
    );
    file.json["nodes"][2]["translation"] = json!([1, 0, 4]);
    let setup = load(&t, &file, "ground = true");
    // All rise by 3, and `ground` sees it.
    close(&positions(&setup, 5), &square());
    let setup = load(&t, &file, "");
    let risen: Vec<Vec3> = square().iter().map(|p| *p + Vec3::Z * 3.0).collect();
    close(&positions(&setup, 5), &risen);

    let mut file = skinned();
    file.attribute("WEIGHTS_0", FLOAT, "VEC4", floats(&[0.0; 16]));
    assert!(file.warned().1[0].contains("4 vertices without weights"));
    file.attribute("WEIGHTS_0", FLOAT, "VEC4", floats(&[-1.0; 16]));
    file.fails(&["weight of vertex 0", "mesh `square`, primitive 0"]);
    let mut file = skinned();
    file.attribute("JOINTS_0", UNSIGNED_BYTE, "VEC4", bytes(&[7; 16]));
    file.fails(&["skin 0", "follows a joint"]);
    // Without weight it does not.
    let mut file = skinned();
    let far = [0, 0, 99, 0, 1, 99, 0, 0, 1, 0, 0, 0, 0, 0, 0, 99];
    file.attribute("JOINTS_0", UNSIGNED_BYTE, "VEC4", bytes(&far));
    close(&positions(&load(&t, &file, ""), 5), &square());
    let mut file = skinned();
    file.json["scenes"] = json!([{"nodes": [3]}]);
    file.fails(&["skin 0", "node 1", "not in the scene"]);
    let mut file = skinned();
    file.json["skins"][0]["inverseBindMatrices"] = json!(0);
    file.fails(&["skin 0", "wrong type"]);
}

/// A square with two targets: the first raises all corners, the second stretches the right side, by a sparse accessor.
fn morphing() -> File {
    let mut file = File::square();
    let raise = file.accessor(FLOAT, "VEC3", floats(&[0.0, 0.0, 1.0].repeat(4)));
    let lean = file.accessor(FLOAT, "VEC3", floats(&[0.0, 1.0, 0.0].repeat(4)));
    let indices = file.view(vec![1, 2]);
    let values = file.view(floats(&[1.0, 0.0, 0.0].repeat(2)));
    file.list("accessors").push(json!({
        "componentType": FLOAT, "count": 4, "type": "VEC3",
        "sparse": {"count": 2, "indices": {"bufferView": indices, "componentType": UNSIGNED_BYTE},
                   "values": {"bufferView": values}},
    }));
    let stretch = file.list("accessors").len() - 1;
    file.primitive()["targets"] =
        json!([{"POSITION": raise, "NORMAL": lean}, {"POSITION": stretch}]);
    file
}

fn morphed(raise: f32, stretch: f32) -> Vec<Vec3> {
    let moved = |p: &Vec3| *p + Vec3::Z * raise + Vec3::X * (stretch * p.x);
    square().iter().map(moved).collect()
}

#[test]
fn morph_targets_add_up() {
    let t = Scratch::new("morph");
    let mut file = morphing();
    close(&positions(&load(&t, &file, ""), 5), &square());
    file.json["meshes"][0]["weights"] = json!([0.5, 2.0]);
    let setup = load(&t, &file, "");
    close(&positions(&setup, 5), &morphed(0.5, 2.0));
    let mesh = &setup.scene.meshes[setup.scene.objects[0].mesh as usize];
    close(&mesh.normals, &[Vec3::new(0.0, 0.5, 1.0); 4]);
    file.json["nodes"][0]["weights"] = json!([-1.0, 0.0]);
    close(&positions(&load(&t, &file, ""), 5), &morphed(-1.0, 0.0));
    // Automatic cameras and `ground` see the deformed mesh.
    close(
        &positions(&load(&t, &file, "ground = true"), 5),
        &morphed(0.0, 0.0),
    );
    // Triangles are cut once they are deformed.
    let setup = load(&t, &file, "subdivide = 1");
    assert_eq!((setup.triangles, positions(&setup, 5).len()), (8, 9));
    assert!(positions(&setup, 5).iter().all(|p| p.z == -1.0));
    // Joints come after targets.
    let mut both = skinned();
    let raise = both.accessor(FLOAT, "VEC3", floats(&[0.0, 0.0, 1.0].repeat(4)));
    both.primitive()["targets"] = json!([{"POSITION": raise}]);
    both.json["meshes"][0]["weights"] = json!([1]);
    both.json["nodes"][1]["scale"] = json!([2, 2, 2]);
    let doubled: Vec<Vec3> = morphed(1.0, 0.0).iter().map(|p| *p * 2.0).collect();
    close(&positions(&load(&t, &both, ""), 5), &doubled);
}

#[test]
fn weights_of_targets_are_animated() {
    let t = Scratch::new("morph-animated");
    let mut linear = morphing();
    linear.animate(
        "go",
        0,
        "weights",
        "LINEAR",
        &[0.0, 1.0],
        &[0.0, 1.0, 2.0, 0.0],
    );
    let setup = load(&t, &linear, "");
    for frame in [5, 7, 15, 29] {
        let s = ((frame as f32 - 5.0) / 10.0).min(1.0);
        close(&positions(&setup, frame), &morphed(2.0 * s, 1.0 - s));
    }
    assert_eq!(setup.moving_object().map(|m| m.1), Some("animation"));
    let mut step = morphing();
    step.animate(
        "go",
        0,
        "weights",
        "STEP",
        &[0.0, 1.0],
        &[0.0, 1.0, 2.0, 0.0],
    );
    close(&positions(&load(&t, &step, ""), 14), &morphed(0.0, 1.0));
    // Weights t³ and t² − t, with their slopes: a cubic is met exactly.
    let key = |t: f32| {
        [
            3.0 * t * t,
            2.0 * t - 1.0,
            t * t * t,
            t * t - t,
            3.0 * t * t,
            2.0 * t - 1.0,
        ]
    };
    let mut cubic = morphing();
    cubic.animate(
        "go",
        0,
        "weights",
        "CUBICSPLINE",
        &[0.0, 2.0],
        &[key(0.0), key(2.0)].concat(),
    );
    let setup = load(&t, &cubic, "");
    for frame in 5..=25 {
        let s = (frame as f32 - 5.0) / 10.0;
        close(&positions(&setup, frame), &morphed(s * s * s, s * s - s));
    }
    let mut short = morphing();
    short.animate("go", 0, "weights", "LINEAR", &[0.0, 1.0], &[0.0, 1.0, 2.0]);
    short.fails(&["animation `go`, channel 0", "3 values for 2 keys"]);
}

#[test]
fn deformed_frames_do_not_depend_on_each_other() {
    let t = Scratch::new("deformed-chunks");
    let mut file = skinned();
    let turn = Quat::from_rotation_y(1.2).to_array();
    file.animate(
        "turn",
        2,
        "rotation",
        "LINEAR",
        &[0.0, 0.5],
        &[[0.0, 0.0, 0.0, 1.0], turn].concat(),
    );
    load(&t, &file, "");
    let render = |out: &str, frames: &str, more: &[&str]| {
        let args = ["render", "shot.toml", "--out", out, "--frames", frames];
        t.run(&[&args[..], more].concat()).ok()
    };
    let bytes = |folder: &str, frame: u32| {
        std::fs::read(t.file(&format!("{folder}/frame.{frame:04}.exr"))).expect("a frame")
    };
    for method in ["mis", "smc"] {
        let more = ["--method", method];
        let whole = format!("whole-{method}");
        render(&whole, "5-9", &more);
        let frame = |number: u32| read_exr(&t.file(&format!("{whole}/frame.{number:04}.exr")));
        assert_ne!(frame(5), frame(8));
        assert!(frame(8).iter().flatten().all(|value| value.is_finite()));
        if method == "mis" {
            render("single", "8", &more);
            assert!(bytes(&whole, 8) == bytes("single", 8));
        }
    }
}

#[test]
fn transfer_is_of_a_still_skin() {
    let t = Scratch::new("skin-prt");
    let mut file = skinned();
    file.json["nodes"]
        .as_array_mut()
        .expect("nodes")
        .push(json!({"name": "view", "camera": 0, "translation": [0.5, 0.5, 4]}));
    file.json["cameras"] =
        json!([{"type": "perspective", "perspective": {"yfov": 0.6, "znear": 0.1}}]);
    file.json["scenes"] = json!([{"nodes": [1, 3, 4]}]);
    file.json["nodes"][2]["translation"] = json!([1, 0, 1]);
    let fly = [0.5, 0.5, 4.0, 0.5, 0.5, 5.0];
    file.animate("fly", 4, "translation", "LINEAR", &[0.0, 1.0], &fly);
    let more = "[camera]\ngltf = \"view\"\n[render.prt]\nbands = 2\ndirections = 20";
    load(&t, &file, more);
    let method = ["--set", "render.method=prt"];
    let run = |args: &[&str]| t.run(&[args, &method].concat());
    run(&["bake", "shot.toml", "--device", "cpu"]).ok();
    run(&["render", "shot.toml", "--frames", "5-6"]).ok();
    let frame = |number: u32| read_exr(&t.file(&format!("out/frame.{number:04}.exr")));
    assert_ne!(frame(5), frame(6));
    // What bends cannot be baked.
    let rise = [0.0, 0.0, 0.0, 0.0, 0.0, 1.0];
    file.animate("rise", 2, "translation", "LINEAR", &[0.0, 1.0], &rise);
    t.put("a.glb", file.bytes());
    run(&["bake", "shot.toml"]).fails(2, &["object.0.animation", "`rise`", "moves"]);
}

#[test]
fn hidden_nodes_are_left_out() {
    let mut file = File::square();
    let hidden = json!({"KHR_node_visibility": {"visible": false}});
    let shown = json!({"KHR_node_visibility": {"visible": true}});
    file.used("KHR_node_visibility");
    file.json["nodes"] = json!([
        {"mesh": 0, "extensions": shown}, {"children": [2], "extensions": hidden}, {"mesh": 0, "extensions": shown},
    ]);
    file.json["scenes"] = json!([{"nodes": [0, 1]}]);
    assert_eq!(file.model().parts.len(), 1);
    file.json["nodes"][1]["extensions"] = shown;
    assert_eq!(file.model().parts.len(), 2);
}

#[test]
fn of_animations_on_one_node_the_first_plays() {
    let t = Scratch::new("clips");
    let mut file = File::square();
    file.json["nodes"] = json!([{"mesh": 0}, {"name": "other"}]);
    file.json["scenes"] = json!([{"nodes": [0, 1]}]);
    let rise = [0.0, 0.0, 0.0, 0.0, 0.0, 1.0];
    let sink = [0.0, 0.0, 0.0, 0.0, 0.0, -1.0];
    file.animate("rise", 0, "translation", "LINEAR", &[0.0, 1.0], &rise);
    file.animate("sink", 0, "translation", "LINEAR", &[0.0, 1.0], &sink);
    file.animate("other", 1, "translation", "LINEAR", &[0.0, 1.0], &rise);
    let height = |object: &str| positions(&load(&t, &file, object), 15)[0].z;
    assert_eq!(height(""), 1.0);
    t.run(&["render", "shot.toml", "--frames", "5"])
        .ok()
        .says(&[
            "warning",
            "a.glb",
            "`rise` plays",
            "`sink` do not",
            "`animation`",
        ]);
    let told = t.run(&["info", "shot.toml"]).ok().out;
    assert!(
        told.contains("animation `rise`") && told.contains("animation `other`"),
        "{told}"
    );
    assert!(!told.contains("animation `sink`"), "{told}");
    assert_eq!(height("animation = \"sink\""), -1.0);
    assert_eq!(height("animation = \"off\""), 0.0);
}

#[test]
fn channels_that_move_no_node_are_left_out() {
    let mut file = File::square();
    let rise = [0.0, 0.0, 0.0, 0.0, 0.0, 1.0];
    file.animate("rise", 0, "translation", "LINEAR", &[0.0, 1.0], &rise);
    let channel = file.json["animations"][0]["channels"][0].clone();
    let mut without = channel.clone();
    without["target"] = json!({"path": "translation"});
    let mut pointer = channel.clone();
    pointer["target"] = json!({"node": 0, "path": "pointer",
        "extensions": {"KHR_animation_pointer": {"pointer": "/nodes/0/translation"}}});
    file.json["animations"][0]["channels"] = json!([without, channel]);
    assert_eq!(file.model().animations[0].channels.len(), 1);
    file.json["animations"][0]["channels"] = json!([pointer, channel]);
    let (model, said) = file.warned();
    assert_eq!(model.animations[0].channels.len(), 1);
    assert!(
        said[0].contains("`rise` uses KHR_animation_pointer"),
        "{said:?}"
    );
    let mut bad = channel.clone();
    bad["target"]["node"] = json!(9);
    file.json["animations"][0]["channels"] = json!([bad]);
    file.fails(&["animations[0].channels[0].target.node", "out of bounds"]);
    bad["target"] = json!({"node": 0, "path": "colour"});
    file.json["animations"][0]["channels"] = json!([bad]);
    file.fails(&["animations[0].channels[0].target.path"]);
}

#[test]
fn what_is_required_and_not_supported_is_refused() {
    for (extension, advice) in [
        (
            "KHR_draco_mesh_compression",
            "gltf-transform copy in.glb out.glb",
        ),
        (
            "EXT_meshopt_compression",
            "gltf-transform copy in.glb out.glb",
        ),
        (
            "KHR_texture_basisu",
            "gltf-transform ktxdecompress in.glb out.glb",
        ),
        ("VENDOR_thing", "without this extension"),
    ] {
        let mut file = File::square();
        file.list("extensionsRequired").push(json!(extension));
        file.fails(&[extension, advice]);
    }
}

/// Neither bounds nor data are needed: an accessor without data is zero.
#[test]
fn what_others_leave_out_is_not_missed() {
    let mut file = morphing();
    for accessor in file.list("accessors") {
        let accessor = accessor.as_object_mut().expect("a map");
        accessor.remove("min");
        accessor.remove("max");
    }
    let zero = json!({"componentType": FLOAT, "count": 4, "type": "VEC3"});
    file.list("accessors").push(zero);
    let zero = file.list("accessors").len() - 1;
    file.primitive()["targets"][0]["NORMAL"] = json!(zero);
    let model = file.model();
    assert_eq!(model.meshes[0].positions, square());
    assert_eq!(model.deforms[&0].targets[0].normals, [Vec3::ZERO; 4]);
    // Nothing bounds how many there are.
    let zeros = file.list("accessors").len() - 1;
    file.json["accessors"][zeros]["count"] = json!(1u64 << 60);
    file.fails(&["a.glb"]);
}

/// Each number of a file in turn becomes others: what comes of it is a model or an error, and never the end of the program.
#[test]
fn broken_numbers_do_not_end_the_program() {
    let mut file = skinned();
    file.attribute("TEXCOORD_0", FLOAT, "VEC2", floats(&[0.0; 8]));
    let image = file.texture(image::ImageFormat::Png, [[255; 4]; 2]);
    file.json["textures"] = json!([{"source": image, "sampler": 0}]);
    file.json["samplers"] = json!([{"wrapS": 33071}]);
    file.json["materials"] =
        json!([{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}, "alphaMode": "MASK"}]);
    file.json["cameras"] =
        json!([{"type": "perspective", "perspective": {"yfov": 0.6, "znear": 0.1}}]);
    file.json["nodes"][3]["camera"] = json!(0);
    let morph = morphing();
    let targets = json!([{"POSITION": 0}]);
    file.primitive()["targets"] = targets;
    let count = file.accessor(FLOAT, "VEC3", floats(&[1.0, 2.0, 3.0]));
    file.json["nodes"]
        .as_array_mut()
        .expect("nodes")
        .push(json!({"mesh": 0, "extensions":
        {"EXT_mesh_gpu_instancing": {"attributes": {"TRANSLATION": count}}}}));
    file.json["scenes"][0]["nodes"] = json!([1, 3, 4]);
    file.animate("go", 0, "weights", "LINEAR", &[0.0, 1.0], &[0.0, 1.0]);
    file.animate(
        "turn",
        2,
        "rotation",
        "LINEAR",
        &[0.0],
        &[0.0, 0.0, 0.0, 1.0],
    );
    file.model();
    let t = Scratch::new("broken-numbers");
    let (mut tried, mut refused) = (0, 0);
    for file in [file, morph] {
        let mut paths = Vec::new();
        numbers(&file.json, String::new(), &mut paths);
        for path in paths {
            for value in [
                json!(-1),
                json!(0),
                json!(3),
                json!(99),
                json!(4_294_967_295u32),
                json!(1e18),
                json!("x"),
                Value::Null,
            ] {
                let mut broken = File {
                    json: file.json.clone(),
                    binary: file.binary.clone(),
                };
                *broken.json.pointer_mut(&path).expect("a number") = value;
                tried += 1;
                refused += usize::from(broken.load(&t).0.is_err());
            }
        }
    }
    assert!(tried > 1000 && refused > tried / 3, "{refused} of {tried}");
}

/// The places of all numbers and words in a document.
fn numbers(json: &Value, at: String, to: &mut Vec<String>) {
    match json {
        Value::Array(list) => {
            for (i, value) in list.iter().enumerate() {
                numbers(value, format!("{at}/{i}"), to);
            }
        }
        Value::Object(map) => {
            for (key, value) in map {
                numbers(value, format!("{at}/{key}"), to);
            }
        }
        _ => to.push(at),
    }
}
