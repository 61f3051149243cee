//! Host file: objects, nodes and cameras that move, against closed forms; and frames that do not hang on which others are
//! rendered.

mod common;

use common::{Scratch, glb, read_exr};
use glam::{Mat4, Quat, Vec3};
use glimt::cli::{Device, PrintFlags, RenderFlags};
use glimt::error::Result;
use glimt::job::Job;
use glimt::notes::Notes;
use glimt::report::Reporter;
use glimt::setup::Setup;
use std::fmt::Write as _;

/// A channel: node, property, interpolation, times, values.
type Channel<'a> = (usize, &'a str, &'a str, &'a [f32], &'a [f32]);

/// A GLB of one triangle at mesh 0 and a camera of 0.6 rad at camera 0, with these nodes and animations.
fn animated(nodes: &str, roots: &str, animations: &[(&str, &[Channel<'_>])]) -> Vec<u8> {
    let mut binary: Vec<u8> = Vec::new();
    let (mut views, mut accessors) = (String::new(), String::new());
    let mut accessor = |values: &[f32], kind: &str, width: usize, more: &str| -> usize {
        let index = views.matches("buffer\":").count();
        let comma = if index > 0 { "," } else { "" };
        let (offset, len) = (binary.len(), 4 * values.len());
        write!(
            views,
            r#"{comma}{{"buffer":0,"byteOffset":{offset},"byteLength":{len}}}"#
        )
        .unwrap();
        let count = values.len() / width;
        write!(
            accessors,
            r#"{comma}{{"bufferView":{index},"componentType":5126,"count":{count},"type":"{kind}"{more}}}"#
        )
        .unwrap();
        binary.extend(values.iter().flat_map(|f| f.to_le_bytes()));
        index
    };
    let bounds = r#","min":[0,0,0],"max":[1,1,0]"#;
    accessor(
        &[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0],
        "VEC3",
        3,
        bounds,
    );
    let mut all = Vec::new();
    for (name, list) in animations {
        let (mut channels, mut samplers) = (Vec::new(), Vec::new());
        for (index, (node, path, interpolation, times, values)) in list.iter().enumerate() {
            let (low, high) = (times[0], times[times.len() - 1]);
            let bounds = format!(r#","min":[{low}],"max":[{high}]"#);
            let input = accessor(times, "SCALAR", 1, &bounds);
            let (kind, width) = match *path {
                "rotation" => ("VEC4", 4),
                _ => ("VEC3", 3),
            };
            let output = accessor(values, kind, width, "");
            samplers.push(format!(
                r#"{{"input":{input},"output":{output},"interpolation":"{interpolation}"}}"#
            ));
            channels.push(format!(
                r#"{{"sampler":{index},"target":{{"node":{node},"path":"{path}"}}}}"#
            ));
        }
        all.push(format!(
            r#"{{"name":"{name}","channels":[{}],"samplers":[{}]}}"#,
            channels.join(","),
            samplers.join(",")
        ));
    }
    let animations = match all.is_empty() {
        true => String::new(),
        false => format!(r#""animations":[{}],"#, all.join(",")),
    };
    let json = format!(
        r#"{{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[{roots}]}}],"nodes":[{nodes}],
        "meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}}}}]}}],
        "cameras":[{{"type":"perspective","perspective":{{"yfov":0.6,"znear":0.1}}}}],
        {animations}"buffers":[{{"byteLength":{}}}],"bufferViews":[{views}],"accessors":[{accessors}]}}"#,
        binary.len()
    );
    glb(&json, &binary)
}

fn load(t: &Scratch, set: &[&str]) -> Result<Job> {
    let flags = RenderFlags {
        device: Device::Cpu,
        set: set.iter().map(|&s| s.to_owned()).collect(),
        ..RenderFlags::default()
    };
    let reporter = Reporter::new(PrintFlags {
        quiet: true,
        json: false,
        verbose: 0,
    });
    Job::from_file(
        &t.file("shot.toml"),
        &flags,
        &mut Notes::new(false),
        &reporter,
    )
}

fn setup(t: &Scratch, set: &[&str]) -> Setup {
    load(t, set).unwrap_or_else(|e| panic!("{e}")).setup
}

/// A shot of frames 5 to 30 at 10 frames a second under one light, of `object` and `more`.
fn shot(t: &Scratch, object: &str, more: &str) {
    t.exr("light.exr", 8, 4, |x, y, c| {
        (1 + (x * 3 + y + c) % 5) as f32
    });
    t.put(
        "shot.toml",
        format!(
            "[image]\nsize = [24, 18]\nrays_per_pixel = 2\n[probe]\nframes = \"light.exr\"\nfps = 10\n\
             [render]\nframes = \"5-30\"\n{more}\n[[object]]\nup = \"z\"\n{object}\n"
        ),
    );
}

fn close(a: Vec3, b: Vec3) {
    assert!(
        (a - b).length() <= 2e-6 * (1.0 + b.length()),
        "{a} is not {b}"
    );
}

/// Where a point of the first object's mesh is in a frame.
fn at(setup: &Setup, frame: i32, point: Vec3) -> Vec3 {
    setup.pose(frame).unwrap().transforms[0].transform_point3(point)
}

#[test]
fn translations_follow_each_interpolation() {
    let t = Scratch::new("translations");
    shot(&t, "mesh = \"a.glb\"", "");
    let times = [0.5, 1.0, 2.0];
    let values = [0.0, 0.0, 1.0, 2.0, 0.0, 1.0, 2.0, 4.0, 1.0];
    let node = r#"{"mesh":0,"translation":[9,9,9]}"#;
    let put = |interpolation: &str, values: &[f32]| {
        let channel = (0, "translation", interpolation, &times[..], values);
        t.put("a.glb", animated(node, "0", &[("move", &[channel])]));
        setup(&t, &[])
    };
    // Frame 5 is time 0, and each frame is 0.1 s.
    let linear = put("LINEAR", &values);
    for (frame, x, y) in [
        (2, 0.0, 0.0),
        (5, 0.0, 0.0),
        (10, 0.0, 0.0),
        (12, 0.8, 0.0),
        (15, 2.0, 0.0),
        (20, 2.0, 2.0),
        (25, 2.0, 4.0),
        (29, 2.0, 4.0),
    ] {
        close(at(&linear, frame, Vec3::ZERO), Vec3::new(x, y, 1.0));
    }
    let step = put("STEP", &values);
    for (frame, x, y) in [
        (9, 0.0, 0.0),
        (14, 0.0, 0.0),
        (15, 2.0, 0.0),
        (24, 2.0, 0.0),
        (25, 2.0, 4.0),
    ] {
        close(at(&step, frame, Vec3::ZERO), Vec3::new(x, y, 1.0));
    }
    // x(t) = t³ − t, y(t) = t²: a cubic is met exactly by its values and slopes.
    let curve = |t: f32| [t * t * t - t, t * t, 1.0];
    let slope = |t: f32| [3.0 * t * t - 1.0, 2.0 * t, 0.0];
    let keys: Vec<f32> = times
        .iter()
        .flat_map(|&t| [slope(t), curve(t), slope(t)].concat())
        .collect();
    let cubic = put("CUBICSPLINE", &keys);
    for frame in 1..=30 {
        let time = ((frame as f32 - 5.0) * 0.1).clamp(0.5, 2.0);
        close(at(&cubic, frame, Vec3::ZERO), curve(time).into());
    }
}

#[test]
fn rotations_take_the_shorter_arc() {
    let t = Scratch::new("rotations");
    shot(&t, "mesh = \"a.glb\"", "");
    let turn = |deg: f32| Quat::from_rotation_z(deg.to_radians());
    let node = r#"{"mesh":0,"rotation":[1,0,0,0]}"#;
    let put = |interpolation: &str, keys: &[Quat]| {
        let values: Vec<f32> = keys.iter().flat_map(|q| q.to_array()).collect();
        let channel = (0, "rotation", interpolation, &[0.0, 1.0][..], &values[..]);
        t.put("a.glb", animated(node, "0", &[("turn", &[channel])]));
        setup(&t, &[])
    };
    for far in [turn(120.0), -turn(120.0)] {
        let linear = put("LINEAR", &[turn(0.0), far]);
        for tenth in 0..=10 {
            let (sin, cos) = (12.0 * tenth as f32).to_radians().sin_cos();
            close(at(&linear, 5 + tenth, Vec3::X), Vec3::new(cos, sin, 0.0));
        }
    }
    // A spline of quaternions is one of their numbers, brought back to length 1.
    let zero = Quat::from_xyzw(0.0, 0.0, 0.0, 0.0);
    let [a, b] = [turn(10.0), turn(100.0)];
    let spline = put("CUBICSPLINE", &[zero, a, zero, zero, b, zero]);
    for tenth in 0..=10 {
        let s = tenth as f32 / 10.0;
        let ease = s * s * (3.0 - 2.0 * s);
        let between = (a * (1.0 - ease) + b * ease).normalize();
        close(at(&spline, 5 + tenth, Vec3::X), between * Vec3::X);
    }
}

#[test]
fn children_follow_and_objects_are_placed() {
    let t = Scratch::new("hierarchy");
    let object = "mesh = \"a.glb\"\nscale = 2\ntranslate = [0, 0, 7]\nrotate_deg = [0, 0, 90]";
    shot(&t, object, "");
    // A turning arm, on which a mesh grows; beside it one that stands.
    let nodes = r#"{"name":"arm","children":[1],"translation":[0,0,1]},
        {"name":"hand","mesh":0,"translation":[3,0,0]},{"name":"post","mesh":0,"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,4,5,6,1]}"#;
    let half = Quat::from_rotation_z(90_f32.to_radians()).to_array();
    let turn = [Quat::IDENTITY.to_array(), half].concat();
    let animations: [(&str, &[Channel<'_>]); 2] = [
        ("turn", &[(0, "rotation", "LINEAR", &[0.0, 1.0], &turn)]),
        (
            "grow",
            &[(
                1,
                "scale",
                "LINEAR",
                &[0.0, 2.0],
                &[1.0, 1.0, 1.0, 3.0, 1.0, 1.0],
            )],
        ),
    ];
    t.put("a.glb", animated(nodes, "0,2", &animations));
    let to_world = Mat4::from_translation(Vec3::new(0.0, 0.0, 7.0))
        * Mat4::from_rotation_z(90_f32.to_radians())
        * Mat4::from_scale(Vec3::splat(2.0));
    let check = |setup: &Setup, turns: bool, grows: bool| {
        for frame in [5, 9, 15, 20, 25, 28] {
            let time = (frame as f32 - 5.0) / 10.0;
            let angle = if turns { 90.0 * time.min(1.0) } else { 0.0 };
            let size = if grows { 1.0 + time.min(2.0) } else { 1.0 };
            let (sin, cos) = angle.to_radians().sin_cos();
            let point = (3.0 + size) * Vec3::new(cos, sin, 0.0) + Vec3::Z;
            let transforms = setup.pose(frame).unwrap().transforms;
            let places = transforms.iter().map(|m| m.transform_point3(Vec3::X));
            let places: Vec<Vec3> = places.collect();
            let expected = [point, Vec3::new(5.0, 5.0, 6.0)].map(|p| to_world.transform_point3(p));
            assert_eq!(places.len(), 2);
            let fits = |p: &Vec3| places.iter().any(|q| (*p - *q).length() < 1e-4);
            assert!(
                expected.iter().all(fits),
                "{frame}: {places:?}, {expected:?}"
            );
        }
    };
    check(&setup(&t, &[]), true, true);
    check(&setup(&t, &["object.0.animation=turn"]), true, false);
    check(&setup(&t, &["object.0.animation=grow"]), false, true);
    check(&setup(&t, &["object.0.animation=off"]), false, false);
    t.run(&["render", "shot.toml", "--set", "object.0.animation=gro"])
        .fails(
            2,
            &[
                "object.0.animation",
                "a.glb has no animation `gro`",
                "did you mean `grow`?",
                "turn",
            ],
        );
    t.run(&["info", "a.glb"]).ok();
    let told = t.run(&["info", "a.glb"]).ok().out;
    for word in ["arm", "hand", "post", "turn: 1 s", "grow: 2 s"] {
        assert!(told.contains(word), "{told}");
    }
}

#[test]
fn loops_and_offsets_shift_time() {
    let t = Scratch::new("loops");
    shot(&t, "mesh = \"a.glb\"", "");
    let channel = (
        0,
        "translation",
        "LINEAR",
        &[0.5, 1.5][..],
        &[0.0, 0.0, 0.0, 1.0, 0.0, 0.0][..],
    );
    t.put(
        "a.glb",
        animated(r#"{"mesh":0}"#, "0", &[("move", &[channel])]),
    );
    let x = |set: &[&str], frame| at(&setup(&t, set), frame, Vec3::ZERO).x;
    let near = |a: f32, b: f32| assert!((a - b).abs() < 1e-5, "{a} is not {b}");
    near(x(&[], 15), 0.5);
    near(x(&[], 30), 1.0);
    near(x(&["object.0.animation_offset_s=0.25"], 15), 0.75);
    near(x(&["object.0.animation_offset_s=-0.25"], 15), 0.25);
    // It ends at 1.5 s, so frame 30 (2.5 s) is 1 s again, and frame 22 (1.7 s) is 0.2 s: before the first key.
    near(x(&["object.0.animation_loop=true"], 30), 0.5);
    near(x(&["object.0.animation_loop=true"], 22), 0.0);
    near(x(&["object.0.animation_loop=true"], 19), 0.9);
    // Another rate and another beginning are other times.
    near(x(&["probe.fps=20"], 25), 0.5);
    near(x(&["render.frames=10-30"], 15), 0.0);
}

#[test]
fn cameras_follow_their_nodes() {
    let t = Scratch::new("node-camera");
    shot(
        &t,
        "mesh = \"a.glb\"\ntranslate = [0, 0, 2]",
        "[camera]\ngltf = \"eye\"",
    );
    let nodes = r#"{"mesh":0},{"name":"crane","children":[2]},{"name":"eye","camera":0,"translation":[0,1,0]}"#;
    let turn = Quat::from_rotation_y(90_f32.to_radians()).to_array();
    let turn = [Quat::IDENTITY.to_array(), turn].concat();
    let channels = [
        (
            1,
            "translation",
            "LINEAR",
            &[0.0, 1.0][..],
            &[0.0, 0.0, 0.0, 5.0, 0.0, 0.0][..],
        ),
        (1, "rotation", "STEP", &[0.0, 1.0], &turn),
    ];
    t.put("a.glb", animated(nodes, "0,1", &[("fly", &channels)]));
    let setup = setup(&t, &[]);
    let camera = setup.camera(9).unwrap();
    close(camera.eye, Vec3::new(2.0, 1.0, 2.0));
    close(camera.target - camera.eye, Vec3::NEG_Z);
    close(camera.up, Vec3::Y);
    let camera = setup.camera(15).unwrap();
    close(camera.eye, Vec3::new(5.0, 1.0, 2.0));
    close(camera.target - camera.eye, Vec3::NEG_X);
    assert_eq!(setup.pose(15).unwrap().camera, camera);
    let fov = 2.0 * ((0.3_f32).tan() * 24.0 / 18.0).atan();
    assert!((camera.fov_x - fov).abs() < 1e-6);
}

/// Precomputed transfer is of what stands still; a file may move its camera alone.
#[test]
fn transfer_is_of_parts_and_not_of_cameras() {
    let t = Scratch::new("motion-prt");
    let more = "method = \"prt\"\nprt = { bands = 2, directions = 20 }\n[output]\nvideo = \"\"";
    shot(&t, "mesh = \"a.glb\"", more);
    let fly = (
        2,
        "translation",
        "LINEAR",
        &[0.0, 1.0][..],
        &[0.0, 0.0, 3.0, 0.5, 0.0, 4.0][..],
    );
    let rig = r#"{"mesh":0},{"camera":0},{"name":"rig","children":[1]}"#;
    t.put("a.glb", animated(rig, "0,2", &[("fly", &[fly])]));
    let spin = "\n[[object.spin]]\nnode = \"rig\"\ndeg_per_frame = 3.0";
    for more_object in ["", spin] {
        shot(&t, &format!("mesh = \"a.glb\"{more_object}"), more);
        t.run(&["bake", "shot.toml", "--device", "cpu"]).ok();
        t.run(&["render", "shot.toml", "--frames", "5-6"]).ok();
        let frame = |number: u32| read_exr(&t.file(&format!("out/frame.{number:04}.exr")));
        assert_ne!(frame(5), frame(6));
    }
    // The camera's node carries the mesh, too.
    let with_mesh = r#"{"mesh":0},{"camera":0},{"name":"rig","children":[0,1]}"#;
    t.put("a.glb", animated(with_mesh, "2", &[("fly", &[fly])]));
    for command in ["bake", "render"] {
        let words = ["object.0.animation", "`fly`", "moves", "\"off\""];
        t.run(&[command, "shot.toml"]).fails(2, &words);
    }
    let off = ["bake", "shot.toml", "--set", "object.0.animation=off"];
    t.run(&off).fails(2, &["object.0.spin", "`rig`"]);
}

#[test]
fn nodes_spin() {
    let t = Scratch::new("spin");
    let spin = "[[object.spin]]\nnode = \"rotor\"\naxis = [0, 0, 2]\ndeg_per_frame = 37\n";
    shot(&t, &format!("mesh = \"a.glb\"\n{spin}"), "");
    let nodes = r#"{"name":"body","mesh":0,"children":[1]},
        {"name":"rotor","children":[2],"translation":[1,2,3],"rotation":[0.70710678,0,0,0.70710678]},
        {"name":"blade","mesh":0,"translation":[1,0,0]}"#;
    t.put("a.glb", animated(nodes, "0", &[]));
    let moved = |set: &[&str]| {
        let setup = setup(&t, set);
        for frame in [5, 6, 17, 30] {
            // Its own z axis is the file's −y after the turn about x.
            let angle = (37.0 * (frame as f32 - 5.0)).to_radians();
            let place = Vec3::new(1.0, 2.0, 3.0) + Vec3::new(angle.cos(), 0.0, angle.sin());
            let transforms = setup.pose(frame).unwrap().transforms;
            close(transforms[0].transform_point3(Vec3::ZERO), Vec3::ZERO);
            close(transforms[1].transform_point3(Vec3::ZERO), place);
        }
    };
    moved(&[]);
    // Whole turns more are no difference.
    moved(&["object.0.spin.0.deg_per_frame=397"]);
    // About the blade's own place nothing but its direction changes.
    let own = setup(&t, &["object.0.spin.0.centre=[1,0,0]"]);
    let transforms = own.pose(11).unwrap().transforms;
    close(
        transforms[1].transform_point3(Vec3::ZERO),
        Vec3::new(2.0, 2.0, 3.0),
    );
    assert!((transforms[1].transform_vector3(Vec3::X) - Vec3::X).length() > 0.1);

    let fails = |set: &str, words: &[&str]| {
        t.run(&["render", "shot.toml", "--set", set])
            .fails(2, words);
    };
    fails(
        "object.0.spin.0.node=rotr",
        &[
            "object.0.spin.0.node",
            "no node `rotr`",
            "did you mean `rotor`?",
            "body, rotor, blade",
        ],
    );
    fails(
        "object.0.spin.0.axis=[0,0,0]",
        &["spin.0.axis", "no length"],
    );
    fails(
        "object.0.mesh=sphere",
        &["sphere has no node `rotor`", "there are: sphere"],
    );
    fails("object.0.spin.0.rpm=3", &["unknown key `rpm`"]);
    let sphere = setup(&t, &["object.0.mesh=sphere", "object.0.spin.0.node=sphere"]);
    assert!(at(&sphere, 6, Vec3::X).y > 0.5);
}

#[test]
fn the_camera_runs_through_its_keys() {
    let t = Scratch::new("keys-camera");
    // x(f) = f²/10, which the curve meets exactly between inner keys; y is a line.
    let key = |frame: f32| {
        let (x, y) = (frame * frame / 10.0, 2.0 * frame);
        format!("[[camera.key]]\nframe = {frame}\neye = [{x}, {y}, 5]\ntarget = [0, 0, 0]\n")
    };
    let keys: String = [8.0, 10.0, 14.0, 16.0, 22.0].map(key).concat();
    shot(
        &t,
        "mesh = \"sphere\"",
        &format!("[camera]\nfov_x_deg = 30\n{keys}"),
    );
    let smooth = setup(&t, &[]);
    for frame in 1..=30 {
        let held = (frame as f32).clamp(8.0, 22.0);
        let eye = smooth.camera(frame).unwrap().eye;
        assert!((eye.y - 2.0 * held).abs() < 1e-4, "{frame}: {eye}");
        if !(10.0..=16.0).contains(&held) && held != 8.0 && held != 22.0 {
            continue;
        }
        assert!((eye.x - held * held / 10.0).abs() < 1e-4, "{frame}: {eye}");
    }
    let linear = setup(&t, &["camera.interpolation=linear"]);
    let eye = linear.camera(12).unwrap().eye;
    close(eye, Vec3::new(0.5 * (10.0 + 19.6), 24.0, 5.0));
    assert!((smooth.camera(12).unwrap().eye.x - 14.4).abs() < 1e-4);
    let zoom = setup(
        &t,
        &["camera.interpolation=linear", "camera.key.1.fov_x_deg=60"],
    );
    let degrees = |frame| zoom.camera(frame).unwrap().fov_x.to_degrees();
    assert!((degrees(9) - 45.0).abs() < 1e-3 && (degrees(14) - 30.0).abs() < 1e-3);
}

#[test]
fn bad_keys_are_refused() {
    let t = Scratch::new("bad-keys");
    let keys = "[[camera.key]]\nframe = 10\neye = [4, 0, 0]\ntarget = [0, 0, 0]\n\
                [[camera.key]]\nframe = 20\neye = [-4, 0, 0]\ntarget = [0, 0, 0]\n";
    shot(&t, "mesh = \"sphere\"", keys);
    let fails = |set: &str, words: &[&str]| {
        t.run(&["render", "shot.toml", "--set", set])
            .fails(2, words);
    };
    fails(
        "camera.key.1.frame=10",
        &["camera.key.1.frame", "two keys are at frame 10"],
    );
    fails(
        "camera.key.1.frame=7",
        &["camera.key.1.frame", "after the key at frame 10"],
    );
    fails(
        "camera.eye=[1,0,0]",
        &["camera.key", "camera.eye or target is given too"],
    );
    fails("camera.gltf=x", &["camera.key", "camera.gltf is given too"]);
    fails("camera.key.0.fov_x_deg=200", &["camera.key.0.fov_x_deg"]);
    fails(
        "camera.key.0.eyes=[1,2,3]",
        &["unknown key `eyes`", "`eye`"],
    );
    // Halfway the eye passes through the target.
    t.run(&["render", "shot.toml"])
        .fails(2, &["shot.toml:9", "frame 15", "where the eye is"]);
    fails("camera.up=[1,0,0]", &["frame 5", "along the line of sight"]);
    t.put("none.toml", "[probe]\nframes = \"light.exr\"\n[[object]]\nmesh = \"sphere\"\n[[camera.key]]\nframe = 1\n");
    t.run(&["render", "none.toml"])
        .fails(2, &["none.toml:5", "missing field `eye`"]);
}

#[test]
fn broken_animations_are_refused() {
    let t = Scratch::new("broken-animations");
    shot(&t, "mesh = \"a.glb\"", "");
    let put = |times: &[f32], values: &[f32]| {
        let channel = (0, "translation", "LINEAR", times, values);
        t.put(
            "a.glb",
            animated(r#"{"mesh":0}"#, "0", &[("move", &[channel])]),
        );
        t.run(&["info", "a.glb"])
    };
    let two = [0.0; 6];
    put(&[0.0, 1.0], &two).ok();
    put(&[1.0, 1.0], &two).fails(3, &["a.glb", "animation `move`, channel 0", "do not grow"]);
    put(&[0.0, 1.0, 2.0], &two).fails(3, &["2 values for 3 keys"]);
    put(&[0.0, 1.0], &[f32::NAN; 6]).fails(3, &["not finite"]);
}

#[test]
fn what_is_scaled_to_nothing_is_hidden() {
    let t = Scratch::new("hidden");
    shot(
        &t,
        "mesh = \"a.glb\"",
        "[output]\nvideo = \"\"\npng = false\n[camera]\neye = [0.3, 0.3, 3]\ntarget = [0.3, 0.3, 0]\nup = [0, 1, 0]",
    );
    let nodes = r#"{"mesh":0},{"mesh":0,"translation":[0,0,1]}"#;
    let channel = (
        1,
        "scale",
        "STEP",
        &[0.0, 0.2][..],
        &[0.0, 0.0, 0.0, 1.0, 1.0, 1.0][..],
    );
    t.put("a.glb", animated(nodes, "0,1", &[("show", &[channel])]));
    let set = ["--set", "image.background=transparent"];
    let render = |frames: &str| {
        t.run(&[&["render", "shot.toml", "--frames", frames][..], &set].concat())
            .ok();
    };
    render("5-8");
    let covered = |frame: u32| {
        let alpha = &read_exr(&t.file(&format!("out/frame.{frame:04}.exr")))[0];
        alpha.iter().sum::<f32>()
    };
    let (first, second) = (covered(5), covered(6));
    assert!(
        first > 10.0 && (first / second - 1.0).abs() < 0.1,
        "{first} {second}"
    );
    assert!(
        covered(7) > 1.3 * covered(6),
        "{} {}",
        covered(6),
        covered(7)
    );
}

/// Everything moves: a spinning object, an animated one, the camera.
fn lively(t: &Scratch) {
    let keys = "[[camera.key]]\nframe = 1\neye = [-4, -3, 2]\ntarget = [0, 0, 0]\n\
                [[camera.key]]\nframe = 6\neye = [-3, -4, 3]\ntarget = [0, 0, 0.5]\n";
    t.lights(6);
    t.put(
        "a.glb",
        animated(
            r#"{"mesh":0}"#,
            "0",
            &[(
                "move",
                &[(
                    0,
                    "translation",
                    "LINEAR",
                    &[0.0, 1.0],
                    &[0.0, 0.0, 0.0, 4.0, 2.0, 1.0],
                )],
            )],
        ),
    );
    t.put(
        "shot.toml",
        format!(
            "[image]\nsize = [40, 30]\nrays_per_pixel = 2\n[render]\nmethod = \"mis\"\n\
             [probe]\nframes = \"light.####.exr\"\nfps = 5\n[output]\nvideo = \"\"\npng = false\n{keys}\
             [[object]]\nmesh = \"a.glb\"\nscale = 2\n[[object]]\nmesh = \"armillary\"\n\
             [[object.spin]]\nnode = \"armillary\"\ndeg_per_frame = 20\naxis = [0, 1, 1]\n\
             [[object]]\nmesh = \"plane\"\nscale = 4\n"
        ),
    );
}

#[test]
fn chunks_are_the_whole_bit_by_bit() {
    let t = Scratch::new("chunks");
    lively(&t);
    let render = |out: &str, frames: &str| {
        t.run(&[
            "render",
            "shot.toml",
            "--out",
            out,
            "--frames",
            frames,
            "--json",
        ])
        .ok()
    };
    render("whole", "1-6");
    render("parts", "4-6");
    render("parts", "1-3");
    render("single", "5");
    let bytes = |folder: &str, frame: u32| {
        std::fs::read(t.file(&format!("{folder}/frame.{frame:04}.exr"))).unwrap()
    };
    for frame in 1..=6 {
        assert!(
            bytes("whole", frame) == bytes("parts", frame),
            "frame {frame}"
        );
    }
    assert!(bytes("whole", 5) == bytes("single", 5));
    assert_ne!(
        read_exr(&t.file("whole/frame.0001.exr")),
        read_exr(&t.file("whole/frame.0005.exr"))
    );
    let told = t.run(&["info", "shot.toml"]).ok().out;
    for words in [
        "# object.0: animation `move`, 1 s, from frame 1 on",
        "# object.1: node `armillary` turns by 20 degrees a frame",
        "# camera in frame 6: eye [-3, -4, 3], target [0, 0, 0.5]",
    ] {
        assert!(told.contains(words), "{told}");
    }
    // It is a shot file itself.
    t.put("told.toml", &told);
    assert_eq!(t.run(&["info", "told.toml"]).ok().out, told);
    // Nothing is rendered again, until the beginning or the rate of the motion is another.
    let rendered = |set: &[&str]| {
        let base = [
            "render",
            "shot.toml",
            "--out",
            "whole",
            "--frames",
            "3-6",
            "--json",
        ];
        let ran = t.run(&[&base[..], set].concat()).ok();
        let last = ran.out.lines().last().unwrap().to_owned();
        let summary: serde_json::Value = serde_json::from_str(&last).unwrap();
        summary["rendered"].as_u64().unwrap()
    };
    assert_eq!(rendered(&[]), 0);
    assert_eq!(rendered(&["--set", "render.frames=2-6"]), 4);
    assert_eq!(rendered(&[]), 4);
    assert_eq!(rendered(&["--set", "probe.fps=6"]), 4);
}

#[test]
fn the_gpu_renders_motion_too() {
    let t = Scratch::new("gpu-motion");
    lively(&t);
    let ran = t.run(&[
        "render",
        "shot.toml",
        "--out",
        "gpu",
        "--frames",
        "3-5",
        "--device",
        "gpu",
    ]);
    if ran.status == 5 && std::env::var_os("REQUIRE_GPU").is_none() {
        println!("skipped: no GPU: {}", ran.err);
        return;
    }
    ran.ok();
    t.run(&["render", "shot.toml", "--out", "cpu", "--frames", "3-5"])
        .ok();
    for frame in 3..=5 {
        let [a, b] =
            ["gpu", "cpu"].map(|f| read_exr(&t.file(&format!("{f}/frame.{frame:04}.exr"))));
        let pairs = a[1..].iter().flatten().zip(b[1..].iter().flatten());
        let odd = pairs
            .filter(|(a, b)| !((*a - *b).abs() <= 1e-3 * (1.0 + b.abs())))
            .count();
        assert!(odd <= 12, "frame {frame}: {odd} values differ");
    }
}

#[test]
fn a_followed_shot_moves_as_a_rendered_one() {
    let t = Scratch::new("follow-motion");
    lively(&t);
    t.run(&["render", "shot.toml", "--out", "whole", "--frames", "6"])
        .ok();
    t.run(&[
        "render",
        "shot.toml",
        "--out",
        "live",
        "--follow",
        "--wait",
        "0.5",
    ])
    .ok();
    // The newest frame is taken first, and motion is counted from the first that is there.
    let bytes = |folder: &str| std::fs::read(t.file(&format!("{folder}/frame.0006.exr"))).unwrap();
    assert!(bytes("whole") == bytes("live"));
}
