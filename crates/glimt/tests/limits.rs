//! Host file: what is too large, too small or out of range is refused before anything is made of it, with its key.

mod common;

use common::Scratch;
use std::fs;

#[test]
fn numbers_out_of_range_name_their_key() {
    let t = Scratch::new("limits");
    t.lights(1);
    t.shot("light.0001.exr", "");
    let refused = |items: &[&str], words: &[&str]| {
        let mut args = vec!["render", "shot.toml"];
        args.extend(items.iter().flat_map(|item| ["--set", item]));
        let key = items[0].split('=').next().unwrap();
        t.run(&args).fails(2, &[words, &[key, "--set"]].concat());
    };
    refused(&["image.size=[32000,32000]"], &["more than 2^28 pixels"]);
    refused(&["image.size=[40000,1]"], &["above 32768"]);
    refused(
        &["image.exposure_ev=200"],
        &["not between -100 and 100 stops"],
    );
    refused(&["image.exposure_ev=-200"], &["not between"]);
    refused(&["image.exposure_ev=nan"], &["not between"]);
    refused(
        &["image.rays_per_pixel=65536", "render.env_samples=65536"],
        &["65536 samples on each ray", "lower one"],
    );
    refused(&["object.0.scale=1e12"], &["not between 1e-9 and 1e9"]);
    refused(&["object.0.scale=-1e-12"], &["not between 1e-9 and 1e9"]);
    refused(&["object.0.translate=[0,0,2e9]"], &["beyond 1e9 units"]);
    refused(&["camera.eye=[1e30,0,0]"], &["beyond 1e9 units"]);
    // Neither is too much by itself.
    let both = ["object.0.scale=9e8", "object.0.translate=[9e8,0,0]"];
    refused(&both, &["1.8e9 units from the origin"]);
    t.run(&["render", "shot.toml", "--set", "object.0.scale=1e-9"])
        .fails(3, &["shot.toml:6:", "all objects are too small", "scale"]);
    // In the file, with line and column.
    t.shot("light.0001.exr", "scale = 1e12\n");
    t.run(&["render", "shot.toml"])
        .fails(2, &["shot.toml:8:1: object.0.scale"]);
    assert!(t.list("out").is_empty());
}

#[test]
fn ranges_of_frames_are_bounded() {
    let t = Scratch::new("ranges");
    t.lights(1);
    t.shot("light.0001.exr", "");
    let words = ["`1-4000000000` is more than 1000000 frames"];
    t.run(&["render", "shot.toml", "--frames", "1-4000000000"])
        .fails(2, &[words[0], "--frames"]);
    t.run(&["render", "shot.toml", "--set", "render.frames=1-4000000000"])
        .fails(2, &[words[0], "render.frames"]);
    t.run(&["render", "shot.toml", "--frames", "4294967295"])
        .fails(2, &["4294967295", "-2147483648 to 2147483647"]);
    t.run(&["render", "shot.toml", "--frames", "2147483647"])
        .ok();
}

#[test]
fn negative_numbers_reach_our_messages() {
    let t = Scratch::new("negative");
    t.lights(1);
    t.shot("light.0001.exr", "");
    t.run(&["render", "shot.toml", "--frames", "-1x"])
        .fails(2, &["`-1x` is not a list of frames", "1-96"]);
    t.run(&["render", "shot.toml", "--seed", "-1"])
        .fails(2, &["--seed", "whole number from 0 to 4294967295"]);
}

#[test]
fn another_up_is_suggested() {
    let t = Scratch::new("up");
    t.lights(1);
    for (eye, up, fix) in [
        ("[0, 0, 5]", "[0, 0, 1]", "as [1, 0, 0]"),
        ("[5, 0, 0]", "[1, 0, 0]", "as [0, 1, 0]"),
        ("[5, 5, 0]", "[-2, -2, 0]", "as [0, 0, 1]"),
    ] {
        let camera = format!("[camera]\neye = {eye}\ntarget = [0, 0, 0]\nup = {up}\n");
        t.shot("light.0001.exr", &camera);
        t.run(&["render", "shot.toml"])
            .fails(2, &["shot.toml:11:1", "camera.up", "line of sight", fix]);
        let suggested = fix.trim_start_matches("as ").replace(' ', "");
        let set = format!("camera.up={suggested}");
        t.run(&["render", "shot.toml", "--set", &set]).ok();
    }
}

/// What a video needs is known before the first frame is rendered.
#[test]
fn videos_are_checked_first() {
    let t = Scratch::new("video-first");
    t.lights(2);
    t.shot("light.####.exr", "[output]\ncodec = \"av1\"\n");
    t.run(&["render", "shot.toml"])
        .fails(4, &["shot.mp4", "16 × 16", "output.video="]);
    assert!(t.list("out").is_empty());

    let large = ["render", "shot.toml", "--set", "image.size=[20,18]"];
    let with = |item| [&large[..], &["--set", item]].concat();
    let none = t.file("none");
    let ran = t
        .command(&with("output.codec=h264"))
        .env("PATH", &none)
        .output();
    let ran = ran.unwrap();
    assert_eq!(ran.status.code(), Some(4));
    let err = String::from_utf8_lossy(&ran.stderr).into_owned();
    assert!(err.contains("ffmpeg cannot be started"), "{err}");
    assert!(t.list("out").is_empty());

    fs::create_dir_all(t.file("out/taken.mp4")).unwrap();
    t.run(&with("output.video=taken.mp4"))
        .fails(4, &["taken.mp4", "folder"]);
    assert_eq!(t.list("out"), ["taken.mp4"]);

    // A folder that is not there is made.
    t.run(&with("output.video=cuts/first/shot.mp4")).ok();
    assert_eq!(t.list("out/cuts/first"), ["shot.mp4"]);
}
