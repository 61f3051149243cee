//! Host file: `glimt bake`: transfer to a file and back, and everything that must not be taken for it.

mod common;

use common::{Ran, Scratch, glb, glb_mesh};
use glam::Vec3;
use glimt::bake;
use glimt::cli::RenderFlags;
use glimt::error::Result;
use glimt::notes::Notes;
use glimt::setup::Setup;
use glimt::shot::{Shot, parse};
use glimt_render_gpu::prepare::bake::BakeSettings;
use glimt_render_gpu::prepare::scene_build::SceneBuffers;
use glimt_render_gpu::prepare::transfer::Transfer;
use serde_json::Value;
use std::path::Path;

/// A ball over a floor, few directions.
const PLACED: &str = "translate = [0, 0, 1]\n[[object]]\nmesh = \"plane\"\nscale = 3\nsubdivide = 2\n\
                      [render.prt]\nbands = 3\ndirections = 25\n";

fn baked(scratch: &Scratch, args: &[&str]) -> Ran {
    let all = ["bake", "shot.toml", "--device", "cpu"];
    scratch.run(&[&all, args].concat())
}

fn setup(shot: &Path, set: &[&str]) -> (Setup, SceneBuffers) {
    let set: Vec<String> = set.iter().map(|s| (*s).to_owned()).collect();
    let (read, source) = parse::read::<Shot>(shot, &set).expect("a shot");
    let flags = RenderFlags::default();
    let setup = Setup::load(read, source, 1, &flags, &mut Notes::default()).expect("meshes");
    let scene = SceneBuffers::build(&setup.scene).expect("a scene");
    (setup, scene)
}

fn load(shot: &Path, set: &[&str]) -> Result<Transfer> {
    let (setup, scene) = setup(shot, set);
    let file = bake::file_of(&setup.shot, &setup.source);
    bake::load(&setup, &setup.shot, &scene, &file)
}

#[test]
fn a_transfer_comes_back_as_it_was_computed() {
    let scratch = Scratch::new("bake-round");
    let shot = scratch.shot("none.exr", PLACED);
    let ran = baked(&scratch, &["--json"]).ok();
    let summary: Value =
        serde_json::from_str(ran.out.lines().last().expect("a line")).expect("JSON");
    assert_eq!(summary["event"], "summary");
    assert_eq!(summary["vertices"], 65 * 129 + 25);
    let file = scratch.file("shot.prt.glb");
    let length = std::fs::metadata(&file).expect("the file").len();
    assert_eq!(summary["bytes"], length);
    assert!(summary["rays"].as_u64().expect("rays") > 100_000);
    assert_eq!(scratch.list(""), ["shot.prt.glb", "shot.toml"]);

    let (setup, scene) = setup(&shot, &[]);
    let settings = BakeSettings {
        bands: 3,
        directions: 25,
        seed: 1,
    };
    let direct =
        glimt_render_gpu::prepare::bake::bake(&scene, &settings, &|_| ()).expect("a transfer");
    assert_eq!(summary["rays"], direct.rays);
    let read = bake::load(&setup, &setup.shot, &scene, &file).expect("the transfer");
    assert_eq!(read, direct.transfer);
    assert!(read.blocked.iter().any(|c| *c != 0.0));

    // Another program's reader.
    let (document, buffers, _) = gltf::import(&file).expect("glTF");
    let counts = document.meshes().map(|mesh| {
        let primitive = mesh.primitives().next().expect("a primitive");
        let reader = primitive.reader(|buffer| Some(&buffers[buffer.index()]));
        let normals = reader.read_normals().expect("normals");
        let positions = reader.read_positions().expect("positions");
        let low = positions.map(Vec3::from).reduce(Vec3::min);
        let said: [f32; 3] = primitive.bounding_box().min;
        assert_eq!(low.expect("a vertex").to_array(), said);
        assert!(
            normals
                .into_iter()
                .all(|n| (Vec3::from(n).length() - 1.0).abs() < 1e-5)
        );
        let custom = primitive.attributes().filter(|(name, accessor)| {
            matches!(name, gltf::Semantic::Extras(name) if name.starts_with("SH_"))
                && accessor.count() == reader.read_positions().expect("positions").count()
        });
        let indices = reader.read_indices().expect("faces").into_u32().count();
        (custom.count(), indices / 3)
    });
    assert_eq!(counts.collect::<Vec<_>>(), [(6, 2 * 128 * 63), (6, 32)]);
    scratch.run(&["info", "shot.prt.glb"]).ok();

    // It is not computed again, unless it would be another one.
    let before = std::fs::read(&file).expect("the file");
    baked(&scratch, &[]).ok().says(&["there already"]);
    assert_eq!(std::fs::read(&file).expect("the file"), before);
    for other in [
        ["--directions", "16"],
        ["--bands", "2"],
        ["--set", "render.seed=9"],
    ] {
        let ran = baked(&scratch, &other).ok();
        assert!(!ran.err.contains("there already"), "{other:?}: {ran:?}");
        assert_ne!(std::fs::read(&file).expect("the file"), before);
    }
    // Half a file is not there already.
    std::fs::write(&file, &before[..before.len() / 2]).expect("a file");
    baked(&scratch, &[]).ok().says(&["vertices"]);
    assert_eq!(std::fs::read(&file).expect("the file"), before);

    // Elsewhere.
    baked(&scratch, &["-o", "other.glb", "--directions", "1"]).ok();
    let set = ["render.prt.bake=other.glb"];
    assert_ne!(load(&shot, &set).expect("the other"), read);
    baked(&scratch, &["--set", "render.prt.bake=third.glb"]).ok();
    assert!(scratch.file("third.glb").exists());
}

/// Loading fails with one line that names the file, what to do, and all of these.
fn refused(result: Result<Transfer>, file: &str, words: &[&str]) {
    let text = result
        .map(drop)
        .expect_err("a transfer that must not be taken")
        .to_string();
    assert_eq!(text.lines().count(), 1);
    for word in [&[file, "run `glimt bake"][..], words].concat() {
        assert!(text.contains(word), "`{word}` is not in: {text}");
    }
    println!("{text}");
}

#[test]
fn what_is_of_something_else_is_refused() {
    let scratch = Scratch::new("bake-refused");
    let shot = scratch.shot("none.exr", PLACED);
    let name = "shot.prt.glb";
    refused(load(&shot, &[]), name, &["there is no such file"]);
    baked(&scratch, &[]).ok();
    load(&shot, &[]).expect("the transfer");

    let stale = [
        (
            "object.1.translate=[0,0,-1]",
            "object.1 (`plane`)",
            "stands elsewhere",
        ),
        (
            "object.0.rotate_deg=[0,0,1]",
            "object.0 (`sphere`)",
            "stands elsewhere",
        ),
        (
            "object.1.subdivide=3",
            "object.1 (`plane`)",
            "81 vertices now and had 25",
        ),
        ("object.1.catcher=true", "object.1 (`plane`)", "catcher"),
        ("object.0.mesh=helicopter", "stale", "objects now and had 2"),
    ];
    for (set, whose, what) in stale {
        refused(load(&shot, &[set]), name, &["it is stale", whose, what]);
    }
    let bands = [
        "it has 3 bands, and render.prt.bands is 4",
        "set render.prt.bands=3",
    ];
    refused(load(&shot, &["render.prt.bands=4"]), name, &bands);
    // What does not change light at the vertices does not matter.
    let same = [
        "object.0.material.diffuse=[1,0,0]",
        "camera.fov_x_deg=20",
        "render.seed=4",
    ];
    load(&shot, &same).expect("the transfer");
    load(&shot, &["render.prt.directions=900"]).expect("the transfer");

    let file = scratch.file(name);
    let whole = std::fs::read(&file).expect("the file");
    for (length, what) in [
        (0, "not a file of transfer"),
        (11, "not a file of transfer"),
        (100, "ends too early"),
        (whole.len() / 2, "ends too early"),
        (whole.len() - 1, "ends too early"),
    ] {
        std::fs::write(&file, &whole[..length]).expect("a file");
        refused(load(&shot, &[]), name, &[what]);
    }
    for (bytes, what) in [
        (
            glb(r#"{"asset":{"version":"2.0"}}"#, b"1234"),
            "not a file of transfer",
        ),
        (
            b"P6 8 8 255 and some more bytes".to_vec(),
            "not a file of transfer",
        ),
        (
            glb(
                r#"{"asset":{"version":"2.0","extras":{"glimt_bake":{"version":9}}}}"#,
                b"1234",
            ),
            "a version that is not known",
        ),
    ] {
        std::fs::write(&file, bytes).expect("a file");
        refused(load(&shot, &[]), name, &[what]);
    }

    // Another kernel than this program's.
    let text_end = 20 + u32::from_le_bytes(whole[12..16].try_into().expect("a word")) as usize;
    let document: Value = serde_json::from_slice(&whole[20..text_end]).expect("JSON");
    let kernel = &document["asset"]["extras"]["glimt_bake"]["kernel"];
    let kernel = kernel.as_str().expect("a hash").as_bytes();
    let mut old = whole.clone();
    let place = whole.windows(64).position(|w| w == kernel);
    old[place.expect("the hash")..][..64].fill(b'0');
    std::fs::write(&file, &old).expect("a file");
    refused(load(&shot, &[]), name, &["it is stale", "kernel"]);
    baked(&scratch, &[]).ok();
    assert_eq!(std::fs::read(&file).expect("the file"), whole);

    // A coefficient that is no number; an attribute that is not there.
    let accessor = &document["meshes"][1]["primitives"][0]["attributes"]["_SH_BLOCKED_1"];
    let view = &document["bufferViews"][accessor.as_u64().expect("a number") as usize];
    let offset = text_end + 8 + view["byteOffset"].as_u64().expect("a number") as usize;
    let mut broken = whole.clone();
    broken[offset + 32..offset + 36].copy_from_slice(&f32::NAN.to_le_bytes());
    std::fs::write(&file, &broken).expect("a file");
    let what = ["object.1 (`plane`)", "vertex 2 is not a finite number"];
    refused(load(&shot, &[]), name, &what);
    // The command that is named mends it.
    baked(&scratch, &[]).ok();
    assert_eq!(std::fs::read(&file).expect("the file"), whole);
    let mut broken = whole.clone();
    let place = whole
        .windows(8)
        .position(|w| w == b"\"_SH_1\":")
        .expect("an attribute");
    broken[place + 5] = b'9';
    std::fs::write(&file, &broken).expect("a file");
    refused(load(&shot, &[]), name, &["object 0", "_SH_1 is missing"]);
    // Of another scene, it is not looked at.
    let moved = ["object.1.translate=[0,0,-1]"];
    refused(
        load(&shot, &moved),
        name,
        &["it is stale", "stands elsewhere"],
    );
    baked(&scratch, &[]).ok();
    assert_eq!(std::fs::read(&file).expect("the file"), whole);
    // More vertices than there are bytes for; values on top of each other.
    let mut forged = document.clone();
    forged["asset"]["extras"]["glimt_bake"]["objects"][0]["vertices"] = 1_000_000.into();
    std::fs::write(&file, glb(&forged.to_string(), &whole[text_end + 8..])).expect("a file");
    refused(load(&shot, &[]), name, &["fewer vertices than it says"]);
    let mut forged = document.clone();
    for view in forged["bufferViews"].as_array_mut().expect("a list") {
        view["byteStride"] = 0.into();
    }
    std::fs::write(&file, glb(&forged.to_string(), &whole[text_end + 8..])).expect("a file");
    refused(load(&shot, &[]), name, &["object 0", "_SH_0 is missing"]);
    std::fs::write(&file, &whole).expect("a file");
    load(&shot, &[]).expect("the transfer");
}

/// What an error says to run makes the transfer that was asked for.
#[test]
fn the_command_that_is_named_helps() {
    let scratch = Scratch::new("bake-named");
    let shot = scratch.shot("none.exr", PLACED);
    baked(&scratch, &[]).ok();
    let set = [
        "object.1.translate=[0, 0, -1]",
        "camera.fov_x_deg=20",
        "render.prt.bands=2",
        "render.prt.bake=it's.glb",
    ];
    let text = load(&shot, &set).expect_err("no such file").to_string();
    let command = text.split('`').nth(1).expect("a command");
    let more = "--set 'object.1.translate=[0, 0, -1]' --set render.prt.bands=2 \
                --set 'render.prt.bake=it'\\''s.glb'";
    assert!(command.starts_with("glimt bake /"), "{command}");
    assert!(command.ends_with(more), "{command}");
    let program = env!("CARGO_BIN_EXE_glimt");
    let command = command.replacen("glimt", program, 1);
    let status = std::process::Command::new("sh")
        .args(["-c", &format!("{command} --device cpu -q")])
        .status();
    assert!(status.expect("a shell").success(), "{command}");
    load(&shot, &set).expect("the transfer");
}

/// Nothing is written over but transfer.
#[test]
fn what_others_made_stays() {
    let scratch = Scratch::new("bake-over");
    scratch.lights(1);
    let triangle = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let model = glb_mesh(&triangle, &[0, 1, 2]);
    scratch.put("model.glb", &model);
    scratch.put("other.glb", &model);
    scratch.put("half.glb", &model[..100]);
    scratch.put("folder/inside", "kept");
    let model = "[[object]]\nmesh = \"model.glb\"\n[render.prt]\nbands = 1\ndirections = 1\n";
    scratch.shot("light.0001.exr", model);
    let files = [
        "half.glb",
        "light.0001.exr",
        "model.glb",
        "other.glb",
        "shot.toml",
    ];
    let contents = || files.map(|name| std::fs::read(scratch.file(name)).expect("a file"));
    let before = contents();
    for (name, what) in [
        ("model.glb", "the mesh of object.1"),
        ("folder/../model.glb", "the mesh of object.1"),
        ("shot.toml", "the shot"),
        ("light.0001.exr", "glimt did not write it"),
        ("other.glb", "glimt did not write it"),
        ("half.glb", "glimt did not write it"),
        ("folder", "a folder"),
    ] {
        let words = [name, what, "--out"];
        let status = if name == "folder" { 4 } else { 2 };
        baked(&scratch, &["-o", name]).fails(status, &words);
        let set = format!("render.prt.bake={name}");
        baked(&scratch, &["--set", &set]).fails(status, &words);
    }
    let render = [
        "render",
        "shot.toml",
        "--method",
        "prt",
        "--set",
        "render.prt.bake=other.glb",
    ];
    let words = ["other.glb", "remove it", "then run `glimt bake"];
    scratch.run(&render).fails(3, &words);
    assert_eq!(contents(), before);
    assert_eq!(scratch.list("folder"), ["inside"]);

    // Transfer may be a mesh, too.
    baked(&scratch, &["-o", "first.glb"]).ok();
    let set = ["--set", "object.1.mesh=first.glb", "-o", "first.glb"];
    baked(&scratch, &set).fails(2, &["first.glb", "the mesh of object.1"]);
    // Nothing is lost with these.
    scratch.put("empty.glb", "");
    baked(&scratch, &["-o", "empty.glb"]).ok();
    baked(&scratch, &["-o", "first.glb", "--bands", "2"]).ok();
}

/// Bakes take minutes: whether their file can be written is known before.
#[test]
fn what_cannot_be_written_is_not_computed() {
    let scratch = Scratch::new("bake-unwritten");
    scratch.shot("none.exr", PLACED);
    let at_once = |ran: Ran, words: &[&str]| {
        assert!(!ran.err.contains("directions in"), "{ran:?}");
        ran.fails(4, words);
        assert_eq!(scratch.list(""), ["shot.toml"]);
    };
    let folder = baked(&scratch, &["-o", "no/such/folder/a.glb"]);
    at_once(folder, &["a.glb", "--out"]);
    // A file of a megabyte where half of one may be written.
    let program = env!("CARGO_BIN_EXE_glimt");
    let limited =
        format!("trap '' XFSZ; ulimit -f 500; exec '{program}' bake shot.toml --device cpu");
    let output = std::process::Command::new("sh")
        .args(["-c", &limited])
        .current_dir(&scratch.path)
        .output()
        .expect("a shell");
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).expect("UTF-8");
    let ran = Ran {
        status: output.status.code().unwrap_or(-1),
        out: text(output.stdout),
        err: text(output.stderr),
    };
    at_once(ran, &["shot.prt.glb", "cannot be written", "--out"]);
    // The long name of -o that other commands have, and the one it had.
    baked(&scratch, &["--out", "a.glb"])
        .ok()
        .says(&["directions in"]);
    baked(&scratch, &["--output", "a.glb"])
        .ok()
        .says(&["there already"]);
}

#[test]
fn what_cannot_be_computed_is_said_with_its_key() {
    let scratch = Scratch::new("bake-keys");
    scratch.shot("none.exr", PLACED);
    let usage: [(&[&str], &str); 6] = [
        (&["--bands", "0"], "render.prt.bands"),
        (&["--bands", "7"], "render.prt.bands"),
        (&["--directions", "0"], "render.prt.directions"),
        (&["--directions", "9999999"], "render.prt.directions"),
        (&["--set", "object.1.subdivide=11"], "object.1.subdivide"),
        (&["--set", "object.0.subdivide=10"], "object.0.subdivide"),
    ];
    for (args, key) in usage {
        baked(&scratch, args).fails(2, &[key]);
    }
    assert_eq!(scratch.list(""), ["shot.toml"]);

    let spin = "[[object]]\nmesh = \"helicopter\"\n[[object.spin]]\nnode = \"main rotor\"\ndeg_per_frame = 5\n";
    scratch.shot("none.exr", spin);
    baked(&scratch, &[]).fails(2, &["object.1.spin", "main rotor", "another method"]);
    // The method does not matter: a shot that is to be rendered by transfer is one to compute it for.
    scratch.shot(
        "none.exr",
        "[render]\nmethod = \"prt\"\n[render.prt]\nbands = 1\ndirections = 1\n",
    );
    baked(&scratch, &[]).ok();
}

#[test]
fn meshes_as_they_come_are_computed() {
    let scratch = Scratch::new("bake-meshes");
    // Neither has normals. The first has a vertex that no face uses and an edge of three faces.
    scratch.put(
        "odd.obj",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 -1 -1\nv 9 9 9\nf 1 2 3\nf 1 2 4\nf 2 1 5\n",
    );
    scratch.put(
        "plain.ply",
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n\
         element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
    );
    let unused = Vec3::new(9.0, 9.0, 9.0);
    for (mesh, is_open) in [("odd.obj", false), ("plain.ply", true)] {
        let more = format!(
            "[[object]]\nmesh = \"{mesh}\"\nup = \"z\"\ntranslate = [20, 0, 0]\n\
             [render.prt]\nbands = 6\ndirections = 400\n"
        );
        let shot = scratch.shot("none.exr", &more);
        baked(&scratch, &[]).ok();
        let read = load(&shot, &[]).expect("the transfer");
        let (_, scene) = setup(&shot, &[]);
        let vertices = scene.vertices().expect("vertices");
        let pairs = read.lit.chunks(36).zip(read.blocked.chunks(36));
        let mut lit_vertices = 0;
        for (vertex, (lit, blocked)) in vertices.iter().zip(pairs) {
            if vertex.position == unused + Vec3::new(20.0, 0.0, 0.0) {
                assert_eq!(vertex.normal, Vec3::ZERO);
                assert!(lit.iter().chain(blocked).all(|c| *c == 0.0));
                continue;
            }
            // Without shadows: π Y of band 0, and 2π/3 Y of band 1 along the normal.
            let all = |k: usize| lit[k] + blocked[k];
            assert!((all(0) - 0.8862).abs() < 0.05, "{}", all(0));
            let along = Vec3::new(all(3), all(1), all(2));
            let expected = 1.0233 * vertex.normal;
            assert!((along - expected).length() < 0.1, "{along} {expected}");
            lit_vertices += usize::from(lit[0] > 0.8);
            if is_open && vertex.object == 1 {
                assert!(blocked[0] < 0.02, "{}", blocked[0]);
            }
        }
        // Far from each other, the ball and the face are in full light.
        assert!(lit_vertices > vertices.len() * 9 / 10, "{lit_vertices}");
        gltf::import(scratch.file("shot.prt.glb")).expect("glTF");
    }
}
