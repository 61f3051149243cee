//! Host file: mesh files of each kind give the same geometry, material and camera.

mod common;

use common::{Scratch, glb_mesh, read_exr};
use flate2::Compression;
use flate2::write::GzEncoder;
use serde_json::Value;
use std::fmt::Write as _;
use std::io::Write as _;

/// A tetrahedron: no two of its sides look alike.
const CORNERS: [[f32; 3]; 4] = [
    [0.0, 0.0, 0.0],
    [1.0, 0.0, 0.2],
    [0.1, 1.2, 0.0],
    [0.2, 0.3, 0.9],
];
const FACES: [[u16; 3]; 4] = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];

fn obj() -> String {
    let mut text = String::new();
    for [x, y, z] in CORNERS {
        writeln!(text, "v {x} {y} {z}").unwrap();
    }
    for [a, b, c] in FACES {
        writeln!(text, "f {} {} {}", a + 1, b + 1, c + 1).unwrap();
    }
    text
}

fn ply(format: &str) -> Vec<u8> {
    let mut file = format!(
        "ply\nformat {format} 1.0\ncomment made here\nelement vertex 4\nproperty float x\nproperty float y\n\
         property float z\nproperty uchar red\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n"
    )
    .into_bytes();
    let float = |f: f32| match format {
        "ascii" => format!("{f} ").into_bytes(),
        "binary_big_endian" => f.to_be_bytes().to_vec(),
        _ => f.to_le_bytes().to_vec(),
    };
    let int = |i: i32| match format {
        "ascii" => format!("{i} ").into_bytes(),
        "binary_big_endian" => i.to_be_bytes().to_vec(),
        _ => i.to_le_bytes().to_vec(),
    };
    let byte = |b: u8| {
        if format == "ascii" {
            format!("{b} ").into_bytes()
        } else {
            vec![b]
        }
    };
    let end: &[u8] = if format == "ascii" { b"\n" } else { b"" };
    for corner in CORNERS {
        file.extend(corner.into_iter().flat_map(float));
        file.extend(byte(200));
        file.extend(end);
    }
    for face in FACES {
        file.extend(byte(3));
        file.extend(face.into_iter().flat_map(|i| int(i32::from(i))));
        file.extend(end);
    }
    file
}

/// Renders a mesh under a light that differs everywhere, seen so that all of it is in the image.
fn picture(t: &Scratch, mesh: &str, more: &[&str]) -> Vec<Vec<f32>> {
    t.exr("light.exr", 8, 4, |x, y, c| {
        ((x * 3 + y * 5 + c * 7) % 11) as f32
    });
    t.put(
        "shot.toml",
        format!(
            "[image]\nsize = [24, 24]\nrays_per_pixel = 4\nbackground = \"transparent\"\n\
             [probe]\nframes = \"light.exr\"\n[[object]]\nmesh = \"{mesh}\"\n\
             material = {{ diffuse = [0.5, 0.5, 0.5] }}\n"
        ),
    );
    let mut args = vec!["render", "shot.toml"];
    args.extend(more);
    t.run(&args).ok();
    read_exr(&t.file("out/frame.0001.exr"))
}

#[test]
fn every_format_gives_the_same_picture() {
    let t = Scratch::new("formats");
    t.put("a.obj", obj());
    t.put("a.glb", glb_mesh(&CORNERS, FACES.as_flattened()));
    for format in ["ascii", "binary_little_endian", "binary_big_endian"] {
        t.put(&format!("{format}.ply"), ply(format));
    }
    let mut gz = GzEncoder::new(Vec::new(), Compression::fast());
    gz.write_all(&ply("binary_little_endian")).unwrap();
    t.put("a.ply.gz", gz.finish().unwrap());

    let expected = picture(&t, "a.obj", &[]);
    let coverage: f32 = expected[0].iter().sum::<f32>() / 576.0;
    assert!(coverage > 0.1 && coverage < 0.9, "{coverage}");
    for name in [
        "a.glb",
        "ascii.ply",
        "binary_little_endian.ply",
        "binary_big_endian.ply",
        "a.ply.gz",
    ] {
        assert_eq!(picture(&t, name, &[]), expected, "{name}");
    }
    let tipped = picture(&t, "a.obj", &["--set", "object.0.up=z"]);
    assert_ne!(tipped, expected, "the axis that is up matters");
}

#[test]
fn ground_and_translate() {
    let t = Scratch::new("ground");
    t.put("a.obj", obj());
    // A camera level with the ground sees the upper half alone filled.
    let camera = [
        "--set",
        "camera.eye=[-9,0,0]",
        "--set",
        "camera.target=[0,0,0]",
        "--set",
        "camera.fov_x_deg=20",
    ];
    let rows = |more: &[&str]| {
        let args: Vec<&str> = camera.iter().chain(more).copied().collect();
        let alpha = picture(&t, "a.obj", &args).swap_remove(0);
        let half = |from: usize| alpha[from..from + 288].iter().sum::<f32>();
        (half(0), half(288))
    };
    let (above, below) = rows(&["--set", "object.0.ground=true"]);
    assert!(above > 1.0 && below == 0.0, "{above} {below}");
    let sink = [
        "--set",
        "object.0.ground=true",
        "--set",
        "object.0.translate=[0,0,-1.3]",
    ];
    let (above, below) = rows(&sink);
    assert!(above == 0.0 && below > 1.0, "{above} {below}");
}

#[test]
fn a_camera_by_its_name() {
    let t = Scratch::new("camera");
    // As `glb_mesh` makes it, the camera node is no part of the scene.
    let file = glb_mesh(&CORNERS, FACES.as_flattened());
    let text = String::from_utf8_lossy(&file[20..]).into_owned();
    let json = text.split("BIN\0").next().unwrap();
    let json = &json[..json.rfind('}').unwrap() + 1];
    let json = json
        .replace(
            r#""scenes":[{"nodes":[0]}]"#,
            r#""scenes":[{"nodes":[0,1]}]"#,
        )
        .replace(r#""camera":0,"#, r#""camera":0,"translation":[0.5,0.5,3],"#);
    let binary = &file[file.len() - (48 + 24)..];
    t.put("a.glb", common::glb(&json, binary));
    let info: Value = serde_json::from_str(&t.run(&["info", "a.glb", "--json"]).ok().out).unwrap();
    assert_eq!(info["cameras"], serde_json::json!(["view"]));
    let seen = picture(&t, "a.glb", &["--set", "camera.gltf=view"]);
    // The same by hand: (x, y, z) of the file is (x, −z, y) of the world; a square image is as wide as high.
    let by_hand = [
        "--set",
        "camera.eye=[0.5,-3,0.5]",
        "--set",
        "camera.target=[0.5,-2,0.5]",
        "--set",
        "camera.fov_x_deg=34.37746770784939",
    ];
    let expected = picture(&t, "a.glb", &by_hand);
    let difference = |a: &[f32], b: &[f32]| {
        a.iter().zip(b).map(|(x, y)| (x - y).abs()).sum::<f32>() / a.len() as f32
    };
    assert!(!(difference(&seen[0], &expected[0]) > 0.01));
    assert!(seen[0].iter().sum::<f32>() > 50.0);
    t.run(&["render", "shot.toml", "--set", "camera.gltf=veiw"])
        .fails(2, &["camera.gltf", "did you mean `view`?"]);
}

#[test]
fn an_obj_with_a_picture() {
    let t = Scratch::new("picture");
    // Left half red, right half green; the bottom row is blue.
    image::RgbImage::from_fn(8, 8, |x, y| match (x, y) {
        (_, 7) => image::Rgb([0, 0, 255]),
        (0..4, _) => image::Rgb([255, 0, 0]),
        _ => image::Rgb([0, 255, 0]),
    })
    .save(t.file("paint.png"))
    .unwrap();
    t.put("a.mtl", "newmtl paint\nKd 1 1 1\nmap_Kd paint.png\n");
    let quad = "mtllib a.mtl\nusemtl paint\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n\
                vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n";
    t.put("a.obj", quad);
    t.exr("light.exr", 2, 1, |_, _, _| 1.0);
    t.put(
        "shot.toml",
        "[image]\nsize = [16, 16]\n[camera]\neye = [0, 0, 4]\ntarget = [0, 0, 0]\nup = [0, 1, 0]\nfov_x_deg = 28\n\
         [probe]\nframes = \"light.exr\"\n[[object]]\nmesh = \"a.obj\"\nup = \"z\"\n",
    );
    t.run(&["render", "shot.toml"]).ok();
    let planes = read_exr(&t.file("out/frame.0001.exr"));
    let pixel = |x: usize, y: usize| [3, 2, 1].map(|c: usize| planes[c][y * 16 + x]);
    let [r, g, b] = pixel(3, 5);
    assert!(r > 5.0 * g && r > 5.0 * b, "left is red: {r} {g} {b}");
    let [r, g, b] = pixel(12, 5);
    assert!(g > 5.0 * r && g > 5.0 * b, "right is green: {r} {g} {b}");
    let [r, g, b] = pixel(8, 15);
    assert!(
        b > 2.0 * r && b > 2.0 * g,
        "the bottom is blue: {r} {g} {b}"
    );
    t.run(&["render", "shot.toml"])
        .ok()
        .says(&["0 frames rendered"]);
    image::RgbImage::new(8, 8)
        .save(t.file("paint.png"))
        .unwrap();
    t.run(&["render", "shot.toml"])
        .ok()
        .says(&["1 frame rendered"]);
}

/// A glTF file of `count` nodes, of which each names its children by `children`; the last has a triangle.
fn nodes(count: usize, children: impl Fn(usize) -> String) -> Vec<u8> {
    let nodes: Vec<String> = (0..count)
        .map(|node| match node + 1 < count {
            true => format!("{{\"children\":[{}]}}", children(node)),
            false => "{\"mesh\":0}".to_owned(),
        })
        .collect();
    let positions = [[0.0f32, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let binary: Vec<u8> = positions
        .as_flattened()
        .iter()
        .flat_map(|f| f.to_le_bytes())
        .collect();
    let json = format!(
        r#"{{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[0]}}],"nodes":[{}],
        "meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}}}}]}}],"buffers":[{{"byteLength":36}}],
        "bufferViews":[{{"buffer":0,"byteLength":36}}],
        "accessors":[{{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}}]}}"#,
        nodes.join(",")
    );
    common::glb(&json, &binary)
}

/// A node that is named twice at each of 40 levels would stand in 2³⁹ places.
#[test]
fn a_node_stands_in_one_place() {
    let t = Scratch::new("nodes");
    t.exr("light.exr", 8, 4, |_, _, _| 1.0);
    let shot = |mesh: &[u8]| {
        t.put("model.glb", mesh);
        t.put(
            "shot.toml",
            "[image]\nsize = [8, 8]\nrays_per_pixel = 1\n[probe]\nframes = \"light.exr\"\n[[object]]\nmesh = \"model.glb\"\n",
        );
        t.run(&["render", "shot.toml"])
    };
    let bomb = nodes(40, |node| format!("{0},{0}", node + 1));
    shot(&bomb).fails(3, &["model.glb", "node 39", "two places"]);
    let circle = nodes(3, |node| (1 - node).to_string());
    shot(&circle).fails(3, &["model.glb", "node 0"]);
    // As deep as one likes is legal.
    shot(&nodes(10_000, |node| (node + 1).to_string())).ok();
}
