//! Host file: each kind of bad input gives one clear line and a status, and leaves earlier outputs whole.

mod common;

use common::{Scratch, glb, glb_mesh};
use exr::prelude::{Compression, FlatSamples};
use std::fs;

const TRIANGLE: [[f32; 3]; 3] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];

#[test]
fn a_missing_frame() {
    let t = Scratch::new("missing");
    t.lights(4);
    fs::remove_file(t.file("light.0003.exr")).unwrap();
    t.shot("light.####.exr", "");
    t.run(&["render", "shot.toml"]).fails(
        3,
        &["light.0003.exr", "frame 3 of 1-4 is missing", "--frames"],
    );
    assert!(t.list("out").is_empty());
    t.run(&["render", "shot.toml", "--frames", "4-6"])
        .fails(3, &["light.0005.exr", "frame 5 of 4-6"]);
    t.run(&["render", "shot.toml", "--frames", "1-2"]).ok();
    assert_eq!(t.list("out").len(), 4);
}

#[test]
fn no_frame_at_all() {
    let t = Scratch::new("none");
    t.shot("light.####.exr", "");
    t.run(&["render", "shot.toml"])
        .fails(3, &["no file is named light.####.exr", "probe.frames"]);
    t.shot("gone.exr", "");
    t.run(&["render", "shot.toml"])
        .fails(3, &["gone.exr", "no such file"]);
}

#[test]
fn frames_of_differing_size() {
    let t = Scratch::new("sizes");
    t.lights(2);
    t.exr("light.0003.exr", 16, 8, |_, _, _| 1.0);
    t.shot("light.####.exr", "");
    t.run(&["render", "shot.toml"]).fails(
        3,
        &["light.0003.exr", "it is 16 × 8", "light.0001.exr is 8 × 4"],
    );
}

#[test]
fn maps_of_any_shape() {
    let t = Scratch::new("shapes");
    t.exr("light.exr", 5, 3, |_, _, _| 1.0);
    t.shot("light.exr", "");
    let words = ["light.exr", "5 × 3 is not 2:1"];
    let mappings = ["mirror-ball", "cube", "angular", "lat-long"];
    t.run(&["render", "shot.toml"])
        .fails(3, &[&words[..], &mappings].concat());
    let lat_long = ["render", "shot.toml", "--set", "probe.mapping=lat-long"];
    t.run(&lat_long).ok().says(&words);
    // Within 2 % it is meant to be one.
    t.exr("near.exr", 101, 50, |_, _, _| 1.0);
    t.shot("near.exr", "");
    t.run(&["render", "shot.toml"])
        .ok()
        .says(&["near.exr", "101 × 50 is not 2:1"]);
    t.exr("one.exr", 1, 1, |_, _, _| 1.0);
    t.shot("one.exr", "");
    t.run(&lat_long).ok();
    let image = common::read_exr(&t.file("out/frame.0001.exr"));
    assert!(image.iter().flatten().all(|v| v.is_finite()));
    assert!(image.iter().flatten().any(|v| *v > 0.0));
}

#[test]
fn texels_that_are_no_light() {
    let t = Scratch::new("texels");
    let bad = [f32::NAN, f32::INFINITY, -1.0, 1.0];
    t.exr("light.exr", 8, 4, |x, y, c| {
        if y == 2 && c == 1 { bad[x % 4] } else { 1.0 }
    });
    t.shot("light.exr", "");
    t.run(&["render", "shot.toml", "--strict"]).fails(
        3,
        &[
            "light.exr",
            "6 of 32 texels are not light: 2 NaN, 2 infinite, 2 negative",
            "--strict",
        ],
    );
    t.run(&["render", "shot.toml"])
        .ok()
        .says(&["warning: ", "6 of 32 texels", "taken as 0"]);
    let image = common::read_exr(&t.file("out/frame.0001.exr"));
    assert!(image.iter().flatten().all(|v| v.is_finite() && *v >= 0.0));
}

#[test]
fn a_black_map() {
    let t = Scratch::new("black");
    t.exr("light.exr", 8, 4, |_, _, _| 0.0);
    t.shot("light.exr", "");
    t.run(&["render", "shot.toml"])
        .ok()
        .says(&["warning:", "black"]);
    let image = common::read_exr(&t.file("out/frame.0001.exr"));
    // Channels are A, B, G, R.
    assert!(image[1..].iter().flatten().all(|v| *v == 0.0));
    assert!(image[0].iter().all(|v| *v == 1.0));
}

#[test]
fn truncated_images() {
    let t = Scratch::new("truncated");
    t.exr("whole.exr", 64, 32, |x, y, _| (x * y) as f32 * 0.37);
    let whole = fs::read(t.file("whole.exr")).unwrap();
    for length in [0, 3, 40, 200, whole.len() / 2, whole.len() - 10] {
        t.put("light.exr", &whole[..length]);
        t.shot("light.exr", "");
        t.run(&["render", "shot.toml"]).fails(3, &["light.exr"]);
        t.run(&["info", "light.exr"]).fails(3, &["light.exr"]);
    }
    let mut hdr = b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 4 +X 8\n".to_vec();
    hdr.extend([100, 50, 25, 129].repeat(20));
    t.put("light.hdr", &hdr);
    t.shot("light.hdr", "");
    t.run(&["render", "shot.toml"])
        .fails(3, &["light.hdr", "ends too early", "truncated"]);
    t.put("light.hdr", &hdr[..34]);
    t.run(&["render", "shot.toml"])
        .fails(3, &["light.hdr", "header ends too early"]);
}

#[test]
fn earlier_frames_stay_whole() {
    let t = Scratch::new("earlier");
    t.lights(3);
    let whole = fs::read(t.file("light.0003.exr")).unwrap();
    t.put("light.0003.exr", &whole[..whole.len() - 20]);
    t.shot("light.####.exr", "");
    t.run(&["render", "shot.toml", "--set", "image.size=[32,16]"])
        .fails(3, &["light.0003.exr"]);
    // Two frames, and neither video nor remains.
    let expected = [
        "frame.0001.exr",
        "frame.0001.png",
        "frame.0002.exr",
        "frame.0002.png",
    ];
    assert_eq!(t.list("out"), expected);
    for name in ["frame.0001.exr", "frame.0002.exr"] {
        common::read_exr(&t.file("out").join(name));
    }
}

#[test]
fn files_that_are_something_else() {
    let t = Scratch::new("else");
    t.put("light.exr", b"\x89PNG\r\n\x1a\n");
    t.shot("light.exr", "");
    t.run(&["render", "shot.toml"])
        .fails(3, &["light.exr", "ends too early"]);
    t.put("light.exr", b"hello");
    t.run(&["render", "shot.toml"])
        .fails(3, &["neither OpenEXR"]);
    let depth = FlatSamples::F32(vec![1.0; 32]);
    t.exr_channels(
        "light.exr",
        8,
        4,
        Compression::Uncompressed,
        &[("Z", depth.clone()), ("A", depth)],
    );
    t.run(&["render", "shot.toml"])
        .fails(3, &["its channels (A, Z) hold no colour"]);
}

/// Runs `info` on a mesh, which loads it as `render` does.
fn mesh(t: &Scratch, name: &str, content: impl AsRef<[u8]>) -> common::Ran {
    t.put(name, content);
    t.run(&["info", name])
}

#[test]
fn truncated_glb() {
    let t = Scratch::new("glb");
    let whole = glb_mesh(&TRIANGLE, &[0, 1, 2]);
    mesh(&t, "a.glb", &whole).ok();
    for length in [0, 3, 11, 30, 400, whole.len() - 4] {
        mesh(&t, "a.glb", &whole[..length]).fails(3, &["a.glb"]);
    }
    mesh(&t, "a.glb", &whole[..400]).fails(3, &["too early"]);
    t.exr("light.exr", 2, 1, |_, _, _| 1.0);
    t.shot("light.exr", "[[object]]\nmesh = \"a.glb\"\n");
    t.run(&["render", "shot.toml"]).fails(3, &["a.glb"]);
}

#[test]
fn meshes_without_triangles() {
    let t = Scratch::new("empty");
    mesh(&t, "a.obj", "v 0 0 0\nv 1 0 0\n").fails(3, &["a.obj", "no triangles"]);
    mesh(&t, "a.glb", glb_mesh(&TRIANGLE, &[])).fails(3, &["a.glb"]);
    let ply = "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n\
               end_header\n0 0 0\n";
    mesh(&t, "a.ply", ply).fails(3, &["a.ply", "no triangles"]);
}

#[test]
fn degenerate_triangles() {
    let t = Scratch::new("degenerate");
    let some = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 0 0\nf 1 2 3\nf 1 2 4\nf 2 2 3\n";
    mesh(&t, "a.obj", some)
        .ok()
        .says(&["warning:", "2 triangles have no area", "left out"]);
    t.exr("light.exr", 2, 1, |_, _, _| 1.0);
    t.shot("light.exr", "[[object]]\nmesh = \"a.obj\"\n");
    t.run(&["render", "shot.toml", "--strict"])
        .fails(3, &["a.obj", "2 triangles have no area"]);
    mesh(&t, "a.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n")
        .fails(3, &["none of its 1 triangles has an area"]);
}

#[test]
fn indices_out_of_range() {
    let t = Scratch::new("indices");
    mesh(
        &t,
        "a.obj",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\n\nf 1 2 3\nf 1 2 7\n",
    )
    .fails(3, &["a.obj:6:1", "position 7 does not exist", "has 3"]);
    mesh(&t, "a.glb", glb_mesh(&TRIANGLE, &[0, 1, 9]))
        .fails(3, &["a.glb", "triangle 0", "0, 1, 9", "3 vertices"]);
    let ply = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n\
               element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -4\n";
    mesh(&t, "a.ply", ply).fails(3, &["a.ply", "face 0", "corner -4 does not exist"]);
}

#[test]
fn other_broken_meshes() {
    let t = Scratch::new("broken");
    mesh(&t, "a.obj", "v 0 0 zero\n").fails(3, &["a.obj:1:1"]);
    mesh(&t, "a.obj", "v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        .fails(3, &["vertex 0", "not finite"]);
    mesh(
        &t,
        "a.ply",
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nend_header\n0\n",
    )
    .fails(3, &["a.ply"]);
    let required = r#"{"asset":{"version":"2.0"},"extensionsRequired":["EXT_meshopt_compression"],
                       "extensionsUsed":["EXT_meshopt_compression"]}"#;
    mesh(&t, "a.glb", glb(required, b"")).fails(3, &["EXT_meshopt_compression", "gltf-transform"]);
    let outside = r#"{"asset":{"version":"2.0"},"buffers":[{"byteLength":8,"uri":"gone.bin"}],"scenes":[{"nodes":[]}]}"#;
    mesh(&t, "a.gltf", outside).fails(3, &["gone.bin", "no such file"]);
    mesh(&t, "a.gltf", "{").fails(3, &["a.gltf", "too early"]);
    mesh(&t, "a.stl", "solid").fails(3, &["a.stl", "no triangles"]);
    mesh(&t, "a.stl", "not").fails(3, &["a.stl", "too early"]);
    t.put("a.fbx", "Kaydara");
    t.exr("light.exr", 2, 1, |_, _, _| 1.0);
    t.shot("light.exr", "[[object]]\nmesh = \"a.fbx\"\n");
    t.run(&["render", "shot.toml"]).fails(3, &["a.fbx", ".glb"]);
}

#[test]
fn outputs_that_cannot_be_written() {
    let t = Scratch::new("unwritable");
    t.lights(1);
    t.shot("light.0001.exr", "");
    t.put("file", "not a folder");
    t.run(&["render", "shot.toml", "--out", "file/below"])
        .fails(4, &["file/below", "--out"]);
    t.run(&["render", "shot.toml", "--out", "file"])
        .fails(4, &["file", "--out"]);
    // A name that is taken by a folder cannot be renamed to.
    fs::create_dir_all(t.file("out/frame.0001.exr")).unwrap();
    t.run(&["render", "shot.toml"])
        .fails(4, &["frame.0001.exr"]);
    assert_eq!(t.list("out"), ["frame.0001.exr"]);
}

/// A limit on the size of files stands in for a full disk.
#[cfg(unix)]
#[test]
fn a_full_disk() {
    let t = Scratch::new("full");
    // Noise does not compress.
    let noise = |x: usize, y: usize, c: usize| ((x * 7919 + y * 104_729 + c * 31) % 997) as f32;
    t.exr("light.exr", 256, 128, noise);
    t.shot("light.exr", "");
    let command = t.command(&["render", "shot.toml", "--set", "image.size=[256,256]"]);
    let words: Vec<String> = std::iter::once(command.get_program())
        .chain(command.get_args())
        .map(|w| format!("'{}'", w.to_string_lossy()))
        .collect();
    let script = format!("trap '' XFSZ; ulimit -f 8; exec {}", words.join(" "));
    let output = std::process::Command::new("sh")
        .current_dir(&t.path)
        .args(["-c", &script])
        .output()
        .unwrap();
    let ran = common::Ran {
        status: output.status.code().unwrap_or(-1),
        out: String::new(),
        err: String::from_utf8_lossy(&output.stderr).into_owned(),
    };
    ran.fails(4, &["frame.0001.exr", "--out"]);
    assert!(t.list("out").is_empty());
}

#[test]
fn no_gpu() {
    let t = Scratch::new("gpu");
    t.lights(1);
    t.shot("light.0001.exr", "");
    // The loader finds no driver in an empty folder.
    let output = t
        .command(&["render", "shot.toml", "--device", "gpu"])
        .env("VK_DRIVER_FILES", t.file("none"))
        .env("VK_ICD_FILENAMES", t.file("none"))
        .output()
        .unwrap();
    let err = String::from_utf8_lossy(&output.stderr).into_owned();
    let ran = common::Ran {
        status: output.status.code().unwrap_or(-1),
        out: String::new(),
        err,
    };
    if cfg!(target_os = "linux") {
        ran.fails(5, &["--device cpu"]);
    }
}

/// Names of files may be any bytes, also where events tell programs of them.
#[cfg(target_os = "linux")]
#[test]
fn names_that_are_no_text() {
    use std::ffi::OsStr;
    use std::os::unix::ffi::OsStrExt;
    let t = Scratch::new("bytes");
    t.lights(1);
    t.shot("light.0001.exr", "");
    let image = OsStr::from_bytes(b"l\xff.exr");
    std::fs::copy(t.file("light.0001.exr"), t.path.join(image)).unwrap();
    let render = ["render", "shot.toml", "--json", "--device", "cpu", "--out"];
    let folder = OsStr::from_bytes(b"f\xff");
    for (args, name) in [(&render[..], folder), (&["info", "--json"], image)] {
        let output = t.command(args).arg(name).output().unwrap();
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(0), "{said}");
    }
    assert!(t.path.join(folder).join("frame.0001.exr").is_file());
}

#[test]
fn plates_far_beyond_white() {
    let t = Scratch::new("beyond");
    // One value is far below zero, and one is within the bound of 1e20 with the plate's primaries alone: in Rec. 709 it is 1.7 times that.
    t.exr("plate.exr", 16, 12, |x, y, c| match (x, y, c) {
        (0, 0, 0) => -1e30,
        (15, 0, 0) => 9e19,
        _ => 0.0,
    });
    t.exr("light.exr", 8, 4, |_, _, _| 1.0);
    t.shot(
        "light.exr",
        "[backplate]\nframes = \"plate.exr\"\nprimaries = \"acescg\"\n[output]\nprimaries = \"rec709\"\n",
    );
    t.run(&["render", "shot.toml"]).ok().says(&[
        "warning: ",
        "plate.exr",
        "1 of 192",
        "beyond 1e20",
    ]);
    let image = common::read_exr(&t.file("out/frame.0001.exr"));
    // Channels are A, B, G, R.
    assert_eq!(image[3][0], 0.0);
    assert_eq!(image[3][15], 1e20);
}

#[test]
fn vertices_without_bytes_take_no_memory() {
    let t = Scratch::new("ply-empty");
    t.put(
        "a.ply",
        "ply\nformat binary_little_endian 1.0\nelement vertex 18446744073709551615\nend_header\n",
    );
    t.run(&["info", "a.ply"])
        .fails(3, &["a.ply", "no triangles"]);
}
