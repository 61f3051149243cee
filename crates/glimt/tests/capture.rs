//! Host file: film of a mirror ball through the program: unwarped, as the light of a shot, its colours matched, and what is
//! wrong with it said.

mod common;

use common::{Ran, Scratch};
use exr::prelude::attribute::Chromaticities;
use exr::prelude::{Image, Vec2, WritableImage};
use glam::{Mat3, Vec3};
use glimt::input::read_image;
use glimt::notes::Notes;
use serde_json::Value;
use std::fs;
use std::path::Path;

/// Size of the filmed frames; the ball's radius is 133 px in them.
const SIZE: [usize; 2] = [400, 300];
const BALL: &str = "capture/ball.####.exr";

/// A folder with a capture of the built-in sky: `count` frames without noise, with plates of 64 × 36 and the truth.
fn film(name: &str, count: u32) -> Scratch {
    film_with(name, count, "seed=1")
}

/// The same with another key.
fn film_with(name: &str, count: u32, key: &str) -> Scratch {
    let t = Scratch::new(name);
    let frames = format!("frames={count}");
    let mut args = vec!["synth", "--device", "cpu", "--out", "."];
    for key in [
        frames.as_str(),
        key,
        "capture.size=[400,300]",
        "capture.pixel_um=30",
        "noise.exposures=0",
        "plate.size=[64,36]",
        "truth.size=[128,64]",
    ] {
        args.extend(["--set", key]);
    }
    t.run(&args).ok();
    t
}

/// Runs `glimt unwarp` on the CPU.
fn unwarp(t: &Scratch, args: &[&str]) -> Ran {
    let mut all = vec!["unwarp"];
    all.extend(args);
    if !args.contains(&"--device") {
        all.extend(["--device", "cpu"]);
    }
    t.run(&all)
}

/// An image of linear colours.
#[derive(Clone)]
struct Picture {
    w: usize,
    h: usize,
    pixels: Vec<Vec3>,
}

impl Picture {
    fn read(path: &Path) -> Self {
        let image = read_image(path, &mut Notes::default()).expect("an image");
        let [w, h] = image.header.size.to_array().map(|n| n as usize);
        let pixels = image.texels.iter().map(|t| t.truncate()).collect();
        Self { w, h, pixels }
    }

    fn write(&self, t: &Scratch, name: &str) {
        t.exr(name, self.w, self.h, |x, y, c| {
            self.pixels[y * self.w + x][c]
        });
    }

    fn map(&self, f: impl Fn(Vec3) -> Vec3) -> Self {
        let pixels = self.pixels.iter().map(|p| f(*p)).collect();
        Self { pixels, ..*self }
    }

    /// A part of it.
    fn crop(&self, left: usize, top: usize, w: usize, h: usize) -> Self {
        let pixel = |i: usize| self.pixels[(top + i / w) * self.w + left + i % w];
        let pixels = (0..w * h).map(pixel).collect();
        Self { w, h, pixels }
    }

    /// Fills a box.
    fn paint(&mut self, [x, y, w, h]: [usize; 4], colour: Vec3) {
        for row in y..y + h {
            self.pixels[row * self.w + x..row * self.w + x + w].fill(colour);
        }
    }

    /// Relative RMS difference.
    fn off(&self, truth: &Self) -> f32 {
        assert_eq!((self.w, self.h), (truth.w, truth.h));
        let pairs = self.pixels.iter().zip(&truth.pixels);
        let difference: f32 = pairs.map(|(a, b)| (*a - *b).length_squared()).sum();
        let all: f32 = truth.pixels.iter().map(|p| p.length_squared()).sum();
        (difference / all).sqrt()
    }
}

fn ball(t: &Scratch, frame: u32) -> Picture {
    Picture::read(&t.file(&format!("capture/ball.{frame:04}.exr")))
}

/// A field without a ball in it.
fn empty() -> Picture {
    let [w, h] = SIZE;
    let pixel = |i: usize| Vec3::splat(0.2 + 0.3 * (i / w) as f32 / h as f32);
    let pixels = (0..w * h).map(pixel).collect();
    Picture { w, h, pixels }
}

fn json(path: &Path) -> Value {
    serde_json::from_str(&fs::read_to_string(path).expect("a file")).expect("JSON")
}

fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

/// Says which values of a mask there are.
fn mask(path: &Path) -> [usize; 4] {
    let mut counts = [0; 4];
    for pixel in image::open(path).expect("a mask").into_luma8().pixels() {
        counts[usize::from(pixel.0[0])] += 1;
    }
    counts
}

/// A shot of a sphere in this light, 24 × 18; its background is the light too.
fn shot(t: &Scratch, frames: &str, mapping: &str, more: &str) -> String {
    let text = format!(
        "[image]\nsize = [24, 18]\nrays_per_pixel = 4\n[camera]\neye = [-4, 0, 0.5]\ntarget = [0, 0, 0]\nfov_x_deg = 60\n\
         [probe]\nframes = \"{frames}\"\nmapping = \"{mapping}\"\n[[object]]\nmesh = \"sphere\"\n{more}"
    );
    t.put("own.toml", text);
    "own.toml".to_owned()
}

/// The image of the first frame that is rendered with these keys.
fn rendered(t: &Scratch, shot: &str, keys: &[&str]) -> (Ran, Picture) {
    let mut args = vec!["render", shot, "--frames", "1", "--out", "rendered"];
    for key in keys {
        args.extend(["--set", key]);
    }
    let _ = fs::remove_dir_all(t.file("rendered"));
    let ran = t.run(&args).ok();
    (ran, Picture::read(&t.file("rendered/frame.0001.exr")))
}

#[test]
fn a_capture_becomes_maps() {
    let t = film("capture-maps", 3);
    let args = |more: &[&'static str]| {
        let mut args = vec![BALL, "--out", "light", "--size", "128x64"];
        args.extend(["--set", "reflectance=[0.72,0.72,0.7]"]);
        args.extend(more);
        args
    };
    let with_rig = args(&["--set", "rig_deg=9.7"]);
    unwarp(&t, &with_rig)
        .ok()
        .says(&["3 maps of 128 × 64 unwarped, 0 there already"]);
    let names: Vec<String> = (1..=3).map(|f| format!("latlong.000{f}.exr")).collect();
    let mut all = names.clone();
    all.extend(["mask.0001.png".to_owned(), "track.json".to_owned()]);
    // A mask follows where the rim, which shakes by parts of a pixel, moves over a texel.
    let mut listed = t.list("light");
    listed.retain(|name| !name.starts_with("mask.") || name == "mask.0001.png");
    assert_eq!(listed, all);

    // The light is the truth's, and the ball was where it was.
    for (name, frame) in names.iter().zip(1..) {
        let map = Picture::read(&t.file("light").join(name));
        let truth = Picture::read(&t.file(&format!("truth/latlong.{frame:04}.exr")));
        let off = |map: &Picture| {
            let flux = |m: &Picture| -> Vec3 { m.pixels[..128 * 60].iter().copied().sum() };
            (flux(map) / flux(&truth) - 1.0).abs().max_element()
        };
        assert!(off(&map) < 0.05, "{name}: {}", off(&map));
        assert!(!(off(&map.map(|p| p * 0.9)) < 0.05));
    }
    let counts = mask(&t.file("light/mask.0001.png"));
    assert!(
        counts[0] > 128 * 60 && counts[1] > 0 && counts[2] > 10,
        "{counts:?}"
    );
    let (track, truth) = (
        json(&t.file("light/track.json")),
        json(&t.file("truth/truth.json")),
    );
    for i in 0..3 {
        let (found, known) = (&track["frames"][i], &truth["frames"][i]);
        assert_eq!(found["state"], "measured");
        assert_eq!(found["frame"], known["frame"]);
        for axis in 0..2 {
            let off = number(&found["centre_px"][axis]) - number(&known["centre_px"][axis]);
            assert!(off.abs() < 1.0, "frame {i}: {off}");
        }
        let off = number(&found["radius_px"]) - number(&known["radius_px"]);
        assert!(off.abs() < 1.0, "frame {i}: {off}");
    }

    // What is there stays; what is not comes back with the same bits; another key makes other maps.
    unwarp(&t, &with_rig)
        .ok()
        .says(&["0 maps", "3 there already"]);
    let file = t.file("light/latlong.0002.exr");
    let first = fs::read(&file).unwrap();
    fs::write(&file, &first[..first.len() / 2]).unwrap();
    unwarp(&t, &with_rig)
        .ok()
        .says(&["1 map", "2 there already"]);
    assert_eq!(fs::read(&file).unwrap(), first);
    fs::remove_file(t.file("light/mask.0001.png")).unwrap();
    unwarp(&t, &with_rig).ok();
    assert_eq!(mask(&t.file("light/mask.0001.png")), counts);
    unwarp(&t, &args(&["--set", "rig_deg=20"]))
        .ok()
        .says(&["3 maps"]);
    assert_ne!(fs::read(&file).unwrap(), first);
    assert!(mask(&t.file("light/mask.0001.png"))[2] > counts[2]);
}

#[test]
fn flags_do_what_they_say() {
    let t = film("capture-flags", 2);
    // As large as the ball, if nothing is said.
    unwarp(&t, &[BALL, "--out", "a"])
        .ok()
        .says(&["2 maps of 266 × 133"]);
    let a = Picture::read(&t.file("a/latlong.0001.exr"));
    assert_eq!((a.w, a.h), (266, 133));

    // The ball's place by hand is nearly the one that is found.
    let truth = &json(&t.file("truth/truth.json"))["frames"][0];
    let centre = format!("centre_px={}", truth["centre_px"]);
    let radius = format!("radius_px={}", truth["radius_px"]);
    let given = [
        BALL, "--out", "b", "--frames", "1", "--set", &centre, "--set", &radius, "--size",
        "266x133",
    ];
    let ran = unwarp(&t, &given).ok().says(&["1 map of 266 × 133"]);
    assert!(!ran.err.contains("looking for"), "{ran:?}");
    assert_eq!(
        t.list("b"),
        ["latlong.0001.exr", "mask.0001.png", "track.json"]
    );
    let track = json(&t.file("b/track.json"));
    assert_eq!(track["frames"][0]["state"], "given");
    assert!((number(&track["frames"][0]["radius_px"]) - number(&truth["radius_px"])).abs() < 1e-3);
    let b = Picture::read(&t.file("b/latlong.0001.exr"));
    // The sun is a few texels; what a pixel shifts there is left out.
    let mean = a.pixels.iter().sum::<Vec3>() / a.pixels.len() as f32;
    let calm = |p: &Picture| p.map(|v| v.min(3.0 * mean));
    let off = calm(&a).off(&calm(&b));
    assert!(off < 0.02, "{off}");
    let radius = "radius_px=120";
    let wrong = [
        BALL, "--out", "b", "--frames", "1", "--set", &centre, "--set", radius, "--size", "266x133",
    ];
    unwarp(&t, &wrong).ok().says(&["1 map"]);
    let off = calm(&a).off(&calm(&Picture::read(&t.file("b/latlong.0001.exr"))));
    assert!(!(off < 0.02), "{off}");

    // From afar nothing is hidden behind the ball, but for the ring at its rim.
    let mask_of = |distance: &str| {
        let args = [
            BALL,
            "--out",
            "c",
            "--size",
            "128x64",
            "--distance-mm",
            distance,
            "--radius-mm",
            "50",
        ];
        unwarp(&t, &args).ok().says(&["2 maps"]);
        mask(&t.file("c/mask.0001.png"))
    };
    let (near, far) = (mask_of("400"), mask_of("inf"));
    assert!(
        near[1] > 10 && far[1] == 0 && far[3] > 0,
        "{near:?} {far:?}"
    );

    // A still is one map, and has nothing to turn against.
    let ran = unwarp(&t, &["capture/ball.0002.exr", "--out", "d"])
        .ok()
        .says(&["1 map of"]);
    assert!(!ran.err.contains("warning"), "{ran:?}");
    assert!(t.list("d").contains(&"latlong.0001.exr".to_owned()));
    let ran = unwarp(&t, &[BALL, "--out", "d", "--set", "steady=false"]).ok();
    assert!(!ran.err.contains("warning"), "{ran:?}");
    // Lines for programs.
    let ran = unwarp(&t, &[BALL, "--out", "d", "--json"]).ok();
    let lines: Vec<Value> = ran
        .out
        .lines()
        .map(|l| serde_json::from_str(l).unwrap())
        .collect();
    assert_eq!(lines.last().unwrap()["skipped"], 0, "{lines:?}");
    assert_eq!(lines.last().unwrap()["unwarped"], 2, "{lines:?}");
}

#[test]
fn wrong_flags_are_named() {
    let t = Scratch::new("capture-wrong");
    fs::create_dir_all(t.file("capture")).unwrap();
    empty().write(&t, "capture/ball.0001.exr");
    let fails = |args: &[&str], status: i32, words: &[&str]| {
        let mut all = vec![BALL];
        all.extend(args);
        let ran = unwarp(&t, &all).fails(status, words);
        assert!(!ran.err.contains("the command line:"), "{ran:?}");
        assert!(t.list("unwarped").is_empty());
    };
    fails(
        &["--distance-mm", "40"],
        2,
        &["distance_mm", "camera would stand in the ball", "inf is"],
    );
    fails(&["--distance-mm", "nan"], 2, &["distance_mm"]);
    fails(&["--radius-mm", "0"], 2, &["radius_mm", "not above 0"]);
    fails(&["--size", "0x8"], 2, &["probe.ball.size", "a side is 0"]);
    fails(&["--set", "fov=3"], 2, &["unknown key `fov`", "rig_deg"]);
    fails(
        &["--set", "rig_deg=90"],
        2,
        &["rig_deg", "between 0 and 80"],
    );
    fails(
        &["--set", "reflectance=[0,1,1]"],
        2,
        &["reflectance", "steel"],
    );
    fails(
        &["--set", "up=[2,0,0]"],
        2,
        &["probe.ball.up", "along forward"],
    );
    fails(
        &["--frames", "1-2"],
        3,
        &["ball.0002.exr", "frame 2 of 1-2 is missing"],
    );
    let ran = unwarp(&t, &[BALL, "--set", "centre_px=[200,150]"]);
    ran.fails(2, &["radius_px", "belong together"]);
    let ran = unwarp(&t, &[BALL, "--size", "8"]);
    assert!(ran.status == 2 && ran.err.contains("1024x512"), "{ran:?}");
    unwarp(&t, &["nothing.####.exr"])
        .fails(3, &["no file is named nothing.####.exr", "check the path"]);
    unwarp(&t, &["nothing.exr"]).fails(3, &["nothing.exr", "no such file"]);
    t.put("text.exr", "not an image");
    unwarp(&t, &["text.exr"]).fails(3, &["text.exr", "neither"]);
    t.put("file", "");
    let centre = ["--set", "centre_px=[200,150]", "--set", "radius_px=133"];
    let mut args = vec![BALL, "--out", "file/below"];
    args.extend(centre);
    unwarp(&t, &args).fails(4, &["file/below", "--out"]);
    let mut args = vec![BALL, "--set", "centre_px=[20,150]"];
    args.extend(&centre[2..]);
    unwarp(&t, &args).fails(3, &["ball.0001.exr", "cut by the border", "radius_px"]);
}

#[test]
fn photographs_that_clip_say_so() {
    let t = film("capture-photo", 1);
    let srgb = |v: f32| match v {
        ..0.003_130_8 => 12.92 * v,
        _ => 1.055 * v.powf(1.0 / 2.4) - 0.055,
    };
    let photo = ball(&t, 1);
    let level = photo.pixels.iter().map(|p| p.y).sum::<f32>() / photo.pixels.len() as f32;
    let codes = photo.pixels.iter().flat_map(|p| {
        (*p * 0.2 / level)
            .to_array()
            .map(|v| (255.0 * srgb(v.clamp(0.0, 1.0)) + 0.5) as u8)
    });
    let image = image::RgbImage::from_raw(400, 300, codes.collect()).unwrap();
    for name in ["ball.png", "ball.jpg"] {
        image.save(t.file(name)).unwrap();
        unwarp(&t, &[name, "--out", name.trim_start_matches("ball.")])
            .ok()
            .says(&["warning:", name, "clipped", "HDR"])
            .says(&["1 map"]);
    }
    // Away from what clips they show what the HDR frame shows.
    unwarp(&t, &[BALL, "--out", "hdr"]).ok();
    let map = |folder: &str| {
        let map = Picture::read(&t.file(folder).join("latlong.0001.exr"));
        let scale = if folder == "hdr" { 0.2 / level } else { 1.0 };
        map.crop(0, 0, 266, 120)
            .map(|p| (p * scale).min(Vec3::splat(0.8)))
    };
    for folder in ["png", "jpg"] {
        let off = map(folder).off(&map("hdr"));
        assert!(off < 0.06, "{folder}: {off}");
    }
    let path = shot(&t, "ball.jpg", "mirror-ball", "");
    rendered(&t, &path, &[])
        .0
        .says(&["warning:", "ball.jpg", "clipped"]);
}

#[test]
fn the_gpu_unwarps_the_same() {
    let t = film("capture-gpu", 2);
    let devices = t.run(&["info", "--json"]).ok().out;
    let devices: Value = serde_json::from_str(&devices).unwrap();
    if devices["gpus"].as_array().unwrap().is_empty() {
        assert!(
            std::env::var("REQUIRE_GPU").as_deref() != Ok("1"),
            "REQUIRE_GPU=1, and there is none"
        );
        println!("skipped: there is no GPU");
        return;
    }
    unwarp(&t, &[BALL, "--device", "gpu", "--out", "gpu"])
        .ok()
        .says(&["GPU"])
        .says(&["2 maps"]);
    unwarp(&t, &[BALL, "--out", "cpu"]).ok();
    for frame in 1..=2 {
        let [a, b] =
            ["cpu", "gpu"].map(|d| Picture::read(&t.file(&format!("{d}/latlong.{frame:04}.exr"))));
        let pairs = a.pixels.iter().zip(&b.pixels);
        let far =
            pairs.filter(|(a, b)| !((**a - **b).abs().max_element() <= 1e-5 * a.max_element()));
        assert_eq!(far.count(), 0);
        assert!(!(b.map(|p| p * 1.001).off(&a) < 1e-5));
    }
    // A map is a map: what the GPU made is not made again.
    unwarp(&t, &[BALL, "--out", "gpu"])
        .ok()
        .says(&["2 there already"]);
}

#[test]
fn the_shot_of_a_capture_renders() {
    let t = film("capture-shot", 2);
    let few = ["--set", "image.rays_per_pixel=4", "--out"];
    let mut args = vec!["render", "shot.toml"];
    args.extend(few);
    args.push("a");
    t.run(&args).ok().says(&["2 frames rendered"]);
    t.run(&args)
        .ok()
        .says(&["0 frames rendered", "2 there already"]);
    let image = Picture::read(&t.file("a/frame.0001.exr"));
    assert_eq!((image.w, image.h), (64, 36));

    // The same light by way of files, and the same shot without a ball.
    let text = fs::read_to_string(t.file("shot.toml")).unwrap();
    let (start, rest) = text.split_once("[probe.ball]\n").unwrap();
    let (keys, end) = rest.split_once("\n\n").unwrap();
    let start = start
        .replace("mirror-ball", "lat-long")
        .replace("capture/ball", "light/latlong");
    t.put("maps.toml", format!("{start}{end}"));
    let mut args = vec![BALL, "--out", "light"];
    for key in keys.lines() {
        args.extend(["--set", key]);
    }
    unwarp(&t, &args).ok().says(&["2 maps"]);
    let mut args = vec!["render", "maps.toml"];
    args.extend(few);
    args.push("b");
    t.run(&args).ok().says(&["2 frames rendered"]);
    for frame in 1..=2 {
        let [a, b] =
            ["a", "b"].map(|d| Picture::read(&t.file(&format!("{d}/frame.{frame:04}.exr"))));
        assert!(b.off(&a) < 1e-6, "{}", b.off(&a));
    }
    // Not any light will do.
    let mut args = vec!["render", "maps.toml", "--set", "probe.scale=1.01"];
    args.extend(few);
    args.push("b");
    t.run(&args).ok();
    let [a, b] = ["a", "b"].map(|d| Picture::read(&t.file(&format!("{d}/frame.0001.exr"))));
    assert!(b.off(&a) > 1e-4);
}

/// Boxes in the corners of the frames, clear of the ball, and their colours.
const PATCHES: [([usize; 4], [f32; 3]); 4] = [
    ([0, 0, 24, 24], [0.8, 0.2, 0.1]),
    ([376, 0, 24, 24], [0.1, 0.7, 0.2]),
    ([0, 276, 24, 24], [0.1, 0.2, 0.6]),
    ([376, 276, 24, 24], [0.4, 0.4, 0.4]),
];

fn painted(t: &Scratch) -> Picture {
    let mut photo = ball(t, 1);
    for (area, colour) in PATCHES {
        photo.paint(area, Vec3::from(colour));
    }
    photo
}

#[test]
fn colours_are_matched() {
    let t = film("capture-colour", 1);
    let photo = painted(&t);
    photo.write(&t, "ball.exr");
    // Rows: (0.9, 0.1, 0.05), (0.05, 1.1, 0), (0, 0.1, 1.4).
    let matrix = Mat3::from_cols_array(&[0.9, 0.05, 0.0, 0.1, 1.1, 0.1, 0.05, 0.0, 1.4]);
    photo.map(|p| matrix * p).write(&t, "plate.exr");
    let patches: Vec<String> = PATCHES
        .iter()
        .map(|(area, _)| format!("{{ probe = {area:?}, plate = {area:?} }}"))
        .collect();
    let colour = format!(
        "[probe.colour]\npatches = [{}]\n[backplate]\nframes = \"plate.exr\"\n",
        patches.join(", ")
    );
    let path = shot(&t, "ball.exr", "mirror-ball", &colour);
    let (ran, matched) = rendered(&t, &path, &[]);
    ran.says(&[
        "note:",
        "ball.exr",
        "matched by 4 patches to 0.0 %",
        "[0.9000, 0.1000, 0.0500]",
        "1.4000",
    ]);

    let over = "[backplate]\nframes = \"plate.exr\"\n";
    let path = shot(&t, "ball.exr", "mirror-ball", over);
    let rows = "probe.colour.matrix=[[0.9,0.1,0.05],[0.05,1.1,0],[0,0.1,1.4]]";
    let (_, by_hand) = rendered(&t, &path, &[rows]);
    let (_, plain) = rendered(&t, &path, &[]);
    assert!(matched.off(&by_hand) < 1e-5, "{}", matched.off(&by_hand));
    assert!(plain.off(&by_hand) > 1e-3, "{}", plain.off(&by_hand));

    // Without a plate the light itself is seen: what is done to it is done to each pixel.
    let path = shot(&t, "ball.exr", "mirror-ball", "");
    let (_, plain) = rendered(&t, &path, &[]);
    let (_, changed) = rendered(&t, &path, &[rows]);
    let expected = plain.map(|p| matrix * p);
    assert!(!(plain.off(&expected) < 1e-3));
    let background = |p: &Picture| p.crop(0, 0, 24, 3);
    let off = background(&changed).off(&background(&expected));
    assert!(off < 1e-5, "{off}");
    let gains = Vec3::new(1.5, 1.0, 0.5);
    let (_, changed) = rendered(&t, &path, &["probe.colour.gains=[1.5,1,0.5]"]);
    let off = background(&changed).off(&background(&plain.map(|p| p * gains)));
    assert!(off < 1e-5, "{off}");
    // The first patch, of luminance 0.3203, made grey.
    let (_, changed) = rendered(&t, &path, &["probe.colour.grey=[2,2,20,20]"]);
    let grey = Vec3::splat(0.2126 * 0.8 + 0.7152 * 0.2 + 0.0722 * 0.1) / Vec3::from(PATCHES[0].1);
    let off = background(&changed).off(&background(&plain.map(|p| p * grey)));
    assert!(off < 1e-4, "{off}");
    // Gains come first, so that a grey patch is grey all the same, at its new luminance.
    let both = [
        "probe.colour.grey=[2,2,20,20]",
        "probe.colour.gains=[2,2,2]",
    ];
    let (_, changed) = rendered(&t, &path, &both);
    let off = background(&changed).off(&background(&plain.map(|p| p * grey * 2.0)));
    assert!(off < 1e-4, "{off}");
    // Lat-long maps take the same keys.
    unwarp(&t, &["ball.exr", "--out", "light"]).ok();
    let path = shot(&t, "light/latlong.0001.exr", "lat-long", "");
    let (_, by_map) = rendered(&t, &path, &[rows]);
    assert!(background(&by_map).off(&background(&expected)) < 1e-5);
}

#[test]
fn few_colours_give_gains() {
    let t = film("capture-few", 1);
    let photo = painted(&t);
    photo.write(&t, "ball.exr");
    photo
        .map(|p| p * Vec3::new(2.0, 1.0, 0.5))
        .write(&t, "plate.exr");
    let patch = "[probe.colour]\npatches = [{ probe = [380, 280, 9, 9], plate = [380, 280, 9, 9] }]\n\
                 [backplate]\nframes = \"plate.exr\"\n";
    let path = shot(&t, "ball.exr", "mirror-ball", patch);
    rendered(&t, &path, &[])
        .0
        .says(&["note:", "gains = [2.0000, 1.0000, 0.5000]", "1 patch"]);
}

#[test]
fn wrong_colours_are_named() {
    let t = film("capture-colour-wrong", 1);
    let mut photo = painted(&t);
    photo.paint([200, 0, 10, 10], Vec3::ZERO);
    photo.write(&t, "ball.exr");
    photo.write(&t, "plate.exr");
    let over = "[backplate]\nframes = \"plate.exr\"\n";
    let fails = |more: &str, status: i32, words: &[&str]| {
        let path = shot(&t, "ball.exr", "mirror-ball", more);
        t.run(&["render", &path]).fails(status, words);
        assert!(t.list("out").is_empty());
    };
    let patch = |probe: &str, plate: &str| {
        format!("{over}[probe.colour]\npatches = [{{ probe = {probe}, plate = {plate} }}]\n")
    };
    let fine = "[2, 2, 9, 9]";
    fails(
        &patch("[395, 2, 9, 9]", fine),
        2,
        &[
            "own.toml:",
            "patches.0.probe",
            "[395, 2, 9, 9]",
            "400 × 300",
            "a box is",
        ],
    );
    fails(
        &patch(fine, "[0, 4294967295, 2, 2]"),
        2,
        &["patches.0.plate", "plate.exr", "a box is"],
    );
    fails(
        &patch(fine, "[0, 0, 0, 2]"),
        2,
        &["patches.0.plate", "holds one at least"],
    );
    fails(&patch("[-1, 0, 2, 2]", fine), 2, &["own.toml:", "-1"]);
    fails(
        &patch("[200, 0, 9, 9]", fine),
        2,
        &["patches.0.probe", "black", "light falls on"],
    );
    fails(
        &patch(fine, "[200, 0, 9, 9]"),
        2,
        &["patches.0.plate", "black", "light falls on"],
    );
    fails(
        &patch(fine, fine).replace(over, ""),
        2,
        &[
            "own.toml:",
            "probe.colour.patches",
            "no backplate",
            "add [backplate]",
        ],
    );
    fails(
        &format!("{}grey = {fine}\n", patch(fine, fine)),
        2,
        &["probe.colour.grey", "patches are given too", "keep one"],
    );
    fails(
        "[probe.colour]\ngrey = [200, 0, 9, 9]\n",
        2,
        &["probe.colour.grey", "black", "light falls on"],
    );
    fails(
        "[probe.colour]\ngrey = [0, 299, 9, 9]\n",
        2,
        &["probe.colour.grey", "does not lie in", "ball.exr"],
    );
    fails(
        "[probe.colour]\ngains = [1, -1, 1]\n",
        2,
        &["probe.colour.gains", "below 0"],
    );
    fails(
        "[probe.colour]\ngains = [1, inf, 1]\n",
        2,
        &["probe.colour", "below 1e6"],
    );
    fails(
        "[probe.colour]\ngain = [1, 1, 1]\n",
        2,
        &["did you mean `gains`?"],
    );
    let frame = "[probe.colour]\ngrey = [2, 2, 9, 9]\nframe = 9\n";
    let path = shot(&t, BALL, "mirror-ball", frame);
    t.run(&["render", &path]).fails(
        2,
        &[
            "probe.colour.frame",
            "ball.0009.exr is not there",
            "leave it out",
        ],
    );
    fs::remove_file(t.file("plate.exr")).unwrap();
    fails(&patch(fine, fine), 3, &["plate.exr", "no such file"]);
    // Codes that clip say little.
    let white = image::RgbImage::from_pixel(400, 300, image::Rgb([255, 255, 255]));
    white.save(t.file("plate.png")).unwrap();
    let path = shot(
        &t,
        "ball.exr",
        "mirror-ball",
        &patch(fine, fine).replace("plate.exr", "plate.png"),
    );
    rendered(&t, &path, &[])
        .0
        .says(&["warning:", "plate.png", "patches.0.plate", "clipped"]);
}

/// Frames say what their primaries are, and the light has those of Rec. 709.
#[test]
fn primaries_of_the_frames_count() {
    let t = film("capture-aces", 1);
    let photo = ball(&t, 1);
    // Rec. 709 to ACES AP0, white adapted by Bradford; rows as published with ACES.
    let to_aces = Mat3::from_cols_array(&[
        0.439_632_3,
        0.382_988_7,
        0.177_379,
        0.089_776_4,
        0.813_439_4,
        0.096_784_1,
        0.017_541_2,
        0.111_546_6,
        0.870_891_1,
    ])
    .transpose();
    photo.map(|p| to_aces * p).write(&t, "unsaid.exr");
    let mut image = exr::prelude::read_first_flat_layer_from_file(t.file("unsaid.exr")).unwrap();
    image.attributes.chromaticities = Some(Chromaticities {
        red: Vec2(0.7347, 0.2653),
        green: Vec2(0.0, 1.0),
        blue: Vec2(0.0001, -0.077),
        white: Vec2(0.32168, 0.33767),
    });
    let image: Image<_> = image;
    image.write().to_file(t.file("aces.exr")).unwrap();
    let map = |name: &str| {
        let ran = unwarp(&t, &[name, "--out", name.trim_end_matches(".exr")]).ok();
        (
            ran,
            Picture::read(
                &t.file(name.trim_end_matches(".exr"))
                    .join("latlong.0001.exr"),
            ),
        )
    };
    let (_, plain) = map("capture/ball.0001.exr");
    let (ran, aces) = map("aces.exr");
    ran.says(&["note:", "aces.exr", "converted to Rec. 709"]);
    assert!(aces.off(&plain) < 2e-3, "{}", aces.off(&plain));
    let (_, unsaid) = map("unsaid.exr");
    assert!(!(unsaid.off(&plain) < 2e-3));
    let path = shot(&t, "aces.exr", "mirror-ball", "");
    let (ran, aces) = rendered(&t, &path, &[]);
    ran.says(&["note:", "converted to Rec. 709"]);
    let path = shot(&t, "capture/ball.0001.exr", "mirror-ball", "");
    let (_, plain) = rendered(&t, &path, &[]);
    assert!(aces.off(&plain) < 2e-3, "{}", aces.off(&plain));
}

/// Both commands refuse a still or a sequence alike.
fn both_fail(t: &Scratch, frames: &str, words: &[&str]) {
    unwarp(t, &[frames, "--out", "none"]).fails(3, words);
    let path = shot(t, frames, "mirror-ball", "");
    t.run(&["render", &path]).fails(3, words);
    assert!(t.list("out").is_empty());
    assert!(
        !t.list("none")
            .iter()
            .any(|name| name.starts_with("latlong"))
    );
}

#[test]
fn frames_without_one_whole_ball() {
    let t = film("capture-none", 1);
    empty().write(&t, "empty.exr");
    both_fail(
        &t,
        "empty.exr",
        &[
            "empty.exr",
            "no mirror ball was found",
            "centre_px and radius_px",
        ],
    );
    empty().map(|_| Vec3::ZERO).write(&t, "black.exr");
    both_fail(&t, "black.exr", &["black.exr", "no mirror ball was found"]);
    let photo = ball(&t, 1);
    photo.crop(110, 0, 290, 300).write(&t, "cut.exr");
    both_fail(
        &t,
        "cut.exr",
        &["cut.exr", "cut by the border (left)", "film the ball whole"],
    );
    photo.crop(0, 0, 400, 250).write(&t, "cut.exr");
    both_fail(&t, "cut.exr", &["cut.exr", "cut by the border (bottom)"]);
    photo.crop(150, 100, 50, 50).write(&t, "small.exr");
    both_fail(
        &t,
        "small.exr",
        &["small.exr", "50 × 50, too small", "64 × 64"],
    );
    let pixel = |i: usize| photo.pixels[i / 800 * 400 + i % 400];
    let two = Picture {
        w: 800,
        h: 300,
        pixels: (0..800 * 300).map(pixel).collect(),
    };
    two.write(&t, "two.exr");
    both_fail(
        &t,
        "two.exr",
        &["two.exr", "two balls were found", "crop the frames"],
    );
    // One of them is meant.
    let args = [
        "two.exr",
        "--out",
        "one",
        "--set",
        "centre_px=[600,150]",
        "--set",
        "radius_px=133",
    ];
    unwarp(&t, &args).ok();
}

#[test]
fn a_ball_lost_in_one_frame_is_interpolated() {
    let t = film("capture-lost", 5);
    empty().write(&t, "capture/ball.0003.exr");
    let said = ["warning:", "not found in frame 3", "interpolated"];
    unwarp(&t, &[BALL]).ok().says(&said).says(&["5 maps"]);
    let track = json(&t.file("unwarped/track.json"));
    assert_eq!(track["lost"], serde_json::json!([3]));
    let frames = &track["frames"];
    assert_eq!(frames[2]["state"], "interpolated");
    assert_eq!(frames[3]["state"], "measured");
    for axis in 0..2 {
        let at = |i: usize| number(&frames[i]["centre_px"][axis]);
        assert!((at(2) - 0.5 * (at(1) + at(3))).abs() < 1e-6);
    }
    let path = shot(&t, BALL, "mirror-ball", "");
    t.run(&["render", &path])
        .ok()
        .says(&said)
        .says(&["5 frames rendered"]);
    // One of five is too few.
    for frame in [1, 2, 4] {
        empty().write(&t, &format!("capture/ball.000{frame}.exr"));
    }
    let words = [
        "ball.0001.exr",
        "no mirror ball",
        "in 1 of 5 frames",
        "leave out the frames",
    ];
    unwarp(&t, &[BALL, "--out", "none"]).fails(3, &words);
}

#[test]
fn frames_of_another_exposure_are_said() {
    // A sun that stands still: so the light changes by the exposure alone.
    let t = film_with("capture-exposure", 5, "sun.from_deg=[60,30]");
    ball(&t, 3)
        .map(|p| p * 4.0)
        .write(&t, "capture/ball.0003.exr");
    let said = ["warning:", "frame 3 of another exposure", "4.0"];
    unwarp(&t, &[BALL]).ok().says(&said).says(&["5 maps"]);
    let path = shot(&t, BALL, "mirror-ball", "");
    t.run(&["render", &path]).ok().says(&said);
}

#[test]
fn frames_that_are_broken() {
    let t = film("capture-broken", 3);
    let file = t.file("capture/ball.0002.exr");
    let whole = fs::read(&file).unwrap();
    let photo = ball(&t, 2);

    photo
        .crop(20, 10, 360, 280)
        .write(&t, "capture/ball.0002.exr");
    both_fail(
        &t,
        BALL,
        &[
            "ball.0002.exr",
            "360 × 280",
            "ball.0001.exr is 400 × 300",
            "one size",
        ],
    );
    for length in [0, 40, whole.len() / 2, whole.len() - 20] {
        fs::write(&file, &whole[..length]).unwrap();
        both_fail(&t, BALL, &["ball.0002.exr"]);
    }
    // Where the ball's place is known, what comes before is made, and stays.
    let given = ["--set", "centre_px=[200,150]", "--set", "radius_px=130"];
    let mut args = vec![BALL, "--out", "given"];
    args.extend(given);
    unwarp(&t, &args).fails(3, &["ball.0002.exr", "ends too early", "truncated"]);
    let names = ["latlong.0001.exr", "mask.0001.png", "track.json"];
    assert_eq!(t.list("given"), names);

    fs::remove_file(&file).unwrap();
    unwarp(&t, &[BALL, "--out", "gap"])
        .ok()
        .says(&["warning:", "frame 2 is missing"])
        .says(&["2 maps"]);
    let path = shot(&t, BALL, "mirror-ball", "");
    t.run(&["render", &path])
        .fails(3, &["ball.0002.exr", "frame 2 of 1-3 is missing"]);
    unwarp(&t, &[BALL, "--out", "gap", "--frames", "1-3"]).fails(3, &["frame 2 of 1-3 is missing"]);
}

#[test]
fn pixels_that_are_no_light() {
    let t = film("capture-nan", 2);
    let mut photo = ball(&t, 2);
    photo.pixels[150 * 400 + 150] = Vec3::new(f32::NAN, 1.0, 1.0);
    photo.pixels[150 * 400 + 151] = Vec3::INFINITY;
    // Noise below zero is no defect.
    photo.pixels[150 * 400 + 152].x = -0.001;
    photo.write(&t, "capture/ball.0002.exr");
    let count = [
        "ball.0002.exr",
        "2 of 120000 pixels are not light",
        "1 NaN",
        "1 infinite",
    ];
    let mut said = vec!["warning:", "taken as 0"];
    said.extend(count);
    unwarp(&t, &[BALL]).ok().says(&said);
    let map = Picture::read(&t.file("unwarped/latlong.0002.exr"));
    assert!(
        map.pixels
            .iter()
            .all(|p| p.is_finite() && p.min_element() >= 0.0)
    );
    let mut refused = vec!["--strict"];
    refused.extend(count);
    unwarp(&t, &[BALL, "--out", "strict", "--strict"]).fails(3, &refused);
    let path = shot(&t, BALL, "mirror-ball", "");
    t.run(&["render", &path]).ok().says(&said);
    t.run(&["render", &path, "--strict"]).fails(3, &refused);
    // Maps that were made without --strict do not pass for good ones.
    let given = [
        BALL,
        "--out",
        "given",
        "--set",
        "centre_px=[200,150]",
        "--set",
        "radius_px=130",
    ];
    unwarp(&t, &given).ok().says(&said);
    let strict: Vec<&str> = given.into_iter().chain(["--strict"]).collect();
    unwarp(&t, &strict).fails(3, &refused);
}

#[test]
fn keys_of_the_ball() {
    let t = film("capture-keys", 1);
    let fails = |mapping: &str, more: &str, words: &[&str]| {
        let path = shot(&t, "capture/ball.0001.exr", mapping, more);
        t.run(&["render", &path]).fails(2, words);
    };
    let words = [
        "own.toml:",
        "probe.ball",
        "belongs to mapping = \"mirror-ball\" alone",
        "remove it",
    ];
    fails("lat-long", "[probe.ball]\nradius_mm = 40\n", &words);
    fails("angular", "[probe.ball]\nradius_mm = 40\n", &words);
    let words = [
        "own.toml:15:",
        "probe.ball.distance_mm",
        "stand in the ball",
        "ball's centre",
    ];
    fails(
        "mirror-ball",
        "[probe.ball]\nradius_mm = 40\ndistance_mm = 30\n",
        &words,
    );
    fails(
        "mirror-ball",
        "[probe.ball]\nradius_px = 40\n",
        &["probe.ball.centre_px", "belong together"],
    );
    fails(
        "mirror-ball",
        "[probe.ball]\nrim_px = -1\n",
        &["probe.ball.rim_px", "1.5 is usual"],
    );
    fails(
        "mirror-ball",
        "[probe.ball]\ndistanse_mm = 1\n",
        &["did you mean `distance_mm`?"],
    );
    fails("mirror-bal", "", &["mirror-bal", "mirror-ball"]);
}

/// Film and footage need not be of one length or rate; the ball is looked for only where it is needed.
#[test]
fn film_and_footage_of_different_lengths() {
    let t = film("capture-lengths", 3);
    fs::remove_file(t.file("plate/plate.0003.png")).unwrap();
    t.run(&["render", "shot.toml", "--out", "a"])
        .ok()
        .says(&["warning:", "frame 3 of the probe is left out"])
        .says(&["looking for the ball: 2/2"])
        .says(&["2 frames rendered"]);
    // At twice the rate every other frame of the footage is shown.
    let mut args = vec!["render", "shot.toml", "--out", "b"];
    args.extend(["--set", "backplate.fps=50"]);
    t.run(&args)
        .ok()
        .says(&["note:", "matched by time"])
        .says(&["frames 2 to 3 of the probe are left out"])
        .says(&["1 frame rendered"]);
    fs::remove_dir_all(t.file("plate")).unwrap();
    t.run(&["render", "shot.toml", "--out", "c"])
        .fails(3, &["plate", "no such file"]);
}
