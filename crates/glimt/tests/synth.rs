//! Host file: `glimt synth` from the command line: what it writes, what it refuses, and how it goes on.

mod common;

use common::{Scratch, read_exr};
use glimt::input::read_image;
use glimt::notes::Notes;
use serde_json::Value;
use std::fs;

const SMALL: &str = "frames = 3\n[light]\nmap = \"light.exr\"\n[capture]\nsize = [24, 17]\npixel_um = 500\n\
    jitter_px = 0.1\n[plate]\nsize = [16, 9]\n[truth]\nsize = [32, 16]\n";

/// A folder with a light map and settings.
fn scratch(name: &str, settings: &str) -> Scratch {
    let t = Scratch::new(name);
    t.exr("light.exr", 16, 8, |x, y, c| {
        0.2 + 0.1 * (x + c) as f32 + if y == 2 && x == 5 { 50.0 } else { 0.0 }
    });
    t.put("synth.toml", settings);
    t
}

#[test]
fn a_capture_is_whole_and_goes_on_where_it_was() {
    let t = scratch("synth-whole", SMALL);
    let args = ["synth", "synth.toml", "--device", "cpu"];
    t.run(&args).ok().says(&["3 frames filmed"]);
    let names = |kind: &str, ext: &str| -> Vec<String> {
        (1..=3).map(|f| format!("{kind}.000{f}.{ext}")).collect()
    };
    assert_eq!(t.list("synth/capture"), names("ball", "exr"));
    assert_eq!(t.list("synth/plate"), names("plate", "png"));
    let mut truth = names("latlong", "exr");
    truth.extend(["mask.png".to_owned(), "truth.json".to_owned()]);
    assert_eq!(t.list("synth/truth"), truth);

    let text = fs::read_to_string(t.file("synth/truth/truth.json")).unwrap();
    let json: Value = serde_json::from_str(&text).unwrap();
    assert_eq!(json["frames"].as_array().unwrap().len(), 3);
    let radius = json["frames"][0]["radius_px"].as_f64().unwrap();
    assert!((radius - 8.006).abs() < 0.01, "{radius}");
    assert!(json["frames"][1]["sun"]["direction"].is_array());

    let mut notes = Notes::default();
    let ball = read_image(&t.file("synth/capture/ball.0002.exr"), &mut notes).unwrap();
    assert_eq!(ball.header.size.to_array(), [24, 17]);
    assert!(ball.texels.iter().all(|p| p.min_element() >= 0.0));
    let mask = image::open(t.file("synth/truth/mask.png"))
        .unwrap()
        .into_luma8();
    assert_eq!(mask.dimensions(), (32, 16));
    assert!(mask.pixels().all(|p| p.0[0] <= 2));

    // What is there stays, what is not comes back with the same bits, and another seed is another capture.
    let file = t.file("synth/capture/ball.0002.exr");
    let first = fs::read(&file).unwrap();
    t.run(&args)
        .ok()
        .says(&["0 frames filmed, 3 there already"]);
    fs::write(&file, &first[..first.len() / 2]).unwrap();
    t.run(&args).ok().says(&["1 frame filmed, 2 there already"]);
    assert_eq!(fs::read(&file).unwrap(), first);
    t.run(&["synth", "synth.toml", "--device", "cpu", "--seed", "9"])
        .ok()
        .says(&["3 frames filmed"]);
    assert_ne!(fs::read(&file).unwrap(), first);
}

#[test]
fn a_map_alone_is_enough_and_frames_come_out_alone() {
    let t = scratch("synth-map", SMALL);
    let set = |out: &'static str, frames: &'static str| -> Vec<&'static str> {
        let mut args = vec!["synth", "light.exr", "--device", "cpu", "--out", out];
        args.extend(["--frames", frames]);
        for key in [
            "capture.size=[24,17]",
            "capture.pixel_um=500",
            "capture.jitter_px=0.1",
            "plate.size=[8,6]",
            "plate.format=exr",
            "truth.size=[16,8]",
        ] {
            args.extend(["--set", key]);
        }
        args
    };
    t.run(&set("a", "1-4")).ok();
    t.run(&set("b", "3")).ok();
    let read = |folder: &str| read_exr(&t.file(&format!("{folder}/capture/ball.0003.exr")));
    assert_eq!(read("a"), read("b"));
    assert_eq!(t.list("b/plate"), ["plate.0003.exr"]);
}

#[test]
fn what_is_wrong_is_named() {
    let t = scratch("synth-wrong", SMALL);
    let run = |args: &[&str]| {
        let mut all = vec!["synth"];
        all.extend(args);
        t.run(&all)
    };
    run(&["nothing.hdr"]).fails(3, &["nothing.hdr", "no such file", "check the path"]);
    run(&["nothing.toml"]).fails(3, &["nothing.toml", "no such file"]);
    t.put("broken.hdr", "not an image");
    run(&["broken.hdr"]).fails(3, &["broken.hdr", "neither OpenEXR"]);
    t.put("bad.toml", "[capture]\nraduis_mm = 3\n");
    run(&["bad.toml"]).fails(
        2,
        &["bad.toml:2:1", "`raduis_mm`", "did you mean `radius_mm`?"],
    );
    run(&["synth.toml", "--set", "lamp.0.flikker=1"]).fails(2, &["did you mean `flicker`?"]);
    run(&["synth.toml", "--set", "capture"]).fails(2, &["no `=`", "capture.radius_mm=40"]);
    for (key, word) in [
        ("capture.radius_mm=1250", "capture.distance_mm"),
        ("capture.size=[0,4]", "a side is 0"),
        ("capture.size=[32768,32768]", "2^26"),
        ("capture.forward=[0,0,2]", "capture.up"),
        ("capture.jitter_px=5000", "more than a degree"),
        ("stage.shape=cube", "unknown value"),
        ("noise.bits=3", "14 is usual"),
        ("ball.tint=[1,2,1]", "between 0 and 1"),
        ("plate.fov_x_deg=nan", "not between"),
        ("rig.half_size_m=[0.1,0.1,1.3]", "reaches into the ball"),
        ("sun.to_deg=[1,2]", "sun.from_deg"),
        ("frames=0", "between 1"),
        ("plate.panorama=none.jpg", "no such file"),
    ] {
        let ran = run(&["synth.toml", "--set", key]);
        let status = if key.contains("panorama") { 3 } else { 2 };
        ran.fails(status, &[word]);
    }
    run(&[
        "synth.toml",
        "--set",
        "stage.shape=box",
        "--set",
        "stage.size_m=[1,1,1]",
    ])
    .fails(2, &["outside the stage"]);
    run(&["synth.toml", "--frames", "2-9"]).fails(2, &["--frames", "1-3"]);
    t.put("synth-file", "");
    run(&["synth.toml", "--out", "synth-file"]).fails(4, &["synth-file"]);
    t.exr(
        "nan.exr",
        4,
        2,
        |x, _, _| if x == 0 { f32::NAN } else { 1.0 },
    );
    run(&["nan.exr", "--strict"]).fails(3, &["nan.exr", "not light"]);
}

#[test]
fn odd_sizes_are_filmed() {
    let t = scratch("synth-odd", SMALL);
    let film = |keys: &[&str]| {
        let mut args = vec!["synth", "synth.toml", "--device", "cpu", "--frames", "1"];
        for key in keys {
            args.extend(["--set", key]);
        }
        t.run(&args).ok();
        let channels = read_exr(&t.file("synth/capture/ball.0001.exr"));
        assert!(
            channels
                .iter()
                .flatten()
                .all(|v| v.is_finite() && *v >= 0.0)
        );
    };
    film(&["capture.size=[1,1]", "plate.size=[1,1]", "truth.size=[1,1]"]);
    film(&["capture.pixel_um=10", "capture.half=true"]);
    film(&[
        "capture.radius_mm=1100",
        "rig.on=false",
        "capture.distance_mm=1250",
    ]);
    film(&["noise.exposures=0", "plate.on=false", "light.scale=0"]);
    film(&[
        "clouds.cover=0.6",
        "lamp.0.flicker=1",
        "occluder.radius_m=1",
        "sun.from_deg=[10,90]",
    ]);
}
