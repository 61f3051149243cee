//! Host file: objects laid over footage: what comes through, what the layers say, and which frames belong together.

mod common;

use common::Scratch;
use exr::prelude::{Compression, FlatSamples};
use glimt_render_gpu::prepare::plate::srgb_decode;
use std::collections::HashMap;
use std::fs;
use std::path::Path;

/// A sphere on a catcher, under a lamp; the camera looks down on both.
const SCENE: &str = "ground = true\ntranslate = [0, 0, 0.2]\n\
    [[object]]\nmesh = \"plane\"\nscale = 30\ncatcher = true\n\
    [camera]\neye = [-9, 0, 7]\ntarget = [0, 0, 0]\nfov_x_deg = 50\n";

/// What the scene is laid over.
fn backplate(frames: &str, more: &str) -> String {
    format!("{SCENE}[backplate]\nframes = \"{frames}\"\n{more}")
}

/// A lamp above and to the left, in weak light from everywhere.
fn lamp(t: &Scratch, name: &str) {
    t.exr(
        name,
        16,
        8,
        |x, y, _| {
            if (x, y) == (5, 1) { 40.0 } else { 0.02 }
        },
    );
}

fn lamps(t: &Scratch, frames: std::ops::RangeInclusive<u32>) {
    for frame in frames {
        lamp(t, &format!("light.{frame:04}.exr"));
    }
}

/// Pixels of 8-bit codes, none alike.
fn codes(w: u32, h: u32, salt: u32) -> Vec<[u8; 3]> {
    let code = |i: u32| [i * 7 + salt, i * 11 + 3, i * 13 + 5].map(|c| (c % 256) as u8);
    (0..w * h).map(code).collect()
}

fn png(t: &Scratch, name: &str, w: u32, h: u32, salt: u32) {
    let bytes = codes(w, h, salt).into_flattened();
    let image = image::RgbImage::from_raw(w, h, bytes).unwrap();
    image.save(t.file(name)).unwrap();
}

fn read_png(path: &Path) -> Vec<[u8; 3]> {
    let bytes = image::open(path).unwrap().to_rgb8().into_raw();
    bytes.as_chunks::<3>().0.to_vec()
}

/// An EXR's channels by name.
fn channels(path: &Path) -> HashMap<String, Vec<f32>> {
    let image = exr::prelude::read_first_flat_layer_from_file(path).unwrap();
    let list = image.layer_data.channel_data.list;
    list.iter()
        .map(|c| {
            let samples = c.sample_data.values_as_f32().collect();
            (c.name.to_string(), samples)
        })
        .collect()
}

fn linear(code: u8) -> f32 {
    srgb_decode(f64::from(code) / 255.0) as f32
}

#[test]
fn plates_come_through_untouched() {
    let t = Scratch::new("untouched");
    lamp(&t, "light.exr");
    png(&t, "plate.png", 16, 12, 0);
    // Up and away, the sphere shades nothing that is seen.
    let away = backplate("plate.png", "").replace("[0, 0, 0.2]", "[0, 0, 500]");
    t.shot("light.exr", &away);
    let extreme = [
        "--set",
        "image.exposure_ev=3",
        "--set",
        "image.tonemap=reinhard",
    ];
    t.run(&[&["render", "shot.toml"], &extreme[..]].concat())
        .ok();
    let expected = codes(16, 12, 0);
    assert_eq!(read_png(&t.file("out/frame.0001.png")), expected);
    let planes = channels(&t.file("out/frame.0001.exr"));
    for (c, name) in ["R", "G", "B"].iter().enumerate() {
        let codes: Vec<f32> = expected.iter().map(|p| linear(p[c])).collect();
        assert_eq!(planes[*name], codes);
    }
    assert!(planes["A"].iter().all(|a| *a == 1.0));
    assert_eq!(planes.len(), 4);

    // With the sphere in view some of it changes, and its shadow, and no more.
    t.shot("light.exr", &backplate("plate.png", ""));
    t.run(&["render", "shot.toml"]).ok();
    let shown = read_png(&t.file("out/frame.0001.png"));
    let changed = shown.iter().zip(&expected).filter(|(a, b)| a != b).count();
    assert!((8..100).contains(&changed), "{changed}");
}

/// EXR plates keep colours that no display shows; 16-bit files and JPEGs are read as they are.
#[test]
fn every_format_is_read() {
    let t = Scratch::new("formats");
    lamp(&t, "light.exr");
    let away = |frames: &str| backplate(frames, "").replace("[0, 0, 0.2]", "[0, 0, 500]");
    let planes = |frames: &str| {
        t.shot("light.exr", &away(frames));
        t.run(&["render", "shot.toml"]).ok();
        channels(&t.file("out/frame.0001.exr"))
    };
    let value = |i: usize| [-0.25, 0.5, 7.0, 0.0][i % 4] + i as f32 * 1e-3;
    t.exr("plate.exr", 16, 12, |x, y, c| {
        value(y * 16 + x) * (c + 1) as f32
    });
    let got = planes("plate.exr");
    for (c, name) in ["R", "G", "B"].iter().enumerate() {
        let expected: Vec<f32> = (0..16 * 12).map(|i| value(i) * (c + 1) as f32).collect();
        assert_eq!(got[*name], expected);
    }

    let deep: Vec<u16> = (0..16 * 12 * 3)
        .map(|i| (i * 113 % 65_536) as u16)
        .collect();
    let image = image::ImageBuffer::<image::Rgb<u16>, _>::from_raw(16, 12, deep.clone()).unwrap();
    image::DynamicImage::from(image)
        .save(t.file("deep.png"))
        .unwrap();
    let got = planes("deep.png");
    for (i, pixel) in deep.as_chunks::<3>().0.iter().enumerate() {
        let expected = pixel.map(|c| srgb_decode(f64::from(c) / 65_535.0) as f32);
        assert_eq!([got["R"][i], got["G"][i], got["B"][i]], expected);
    }

    let grey = image::GrayImage::from_fn(16, 12, |x, y| image::Luma([(x * 9 + y * 5) as u8]));
    grey.save(t.file("plate.jpg")).unwrap();
    let shown = image::open(t.file("plate.jpg"))
        .unwrap()
        .to_rgb8()
        .into_raw();
    let got = planes("plate.jpg");
    let expected: Vec<f32> = shown
        .as_chunks::<3>()
        .0
        .iter()
        .map(|p| linear(p[1]))
        .collect();
    assert_eq!(got["G"], expected);

    let clear = image::RgbaImage::from_pixel(16, 12, image::Rgba([10, 20, 30, 40]));
    clear.save(t.file("clear.png")).unwrap();
    t.shot("light.exr", &away("clear.png"));
    t.run(&["render", "shot.toml"])
        .ok()
        .says(&["note:", "clear.png", "alpha is not used"]);
    assert_eq!(
        read_png(&t.file("out/frame.0001.png")),
        vec![[10, 20, 30]; 192]
    );
}

/// A compositor who has the layers and the plate gets the image.
#[test]
fn layers_and_plate_make_the_image() {
    let t = Scratch::new("layers");
    lamp(&t, "light.exr");
    png(&t, "plate.png", 40, 30, 9);
    let plate = codes(40, 30, 9);
    let aovs = "[output]\naovs = [\"object\", \"catcher\", \"difference\"]\n";
    for shadow in ["multiply", "add"] {
        let keys = format!("shadow = \"{shadow}\"\n{aovs}");
        t.shot("light.exr", &backplate("plate.png", &keys));
        t.run(&[
            "render",
            "shot.toml",
            "--set",
            "image.size=[40,30]",
            "--set",
            "image.exposure_ev=-0.7",
        ])
        .ok();
        let file = t.file("out/frame.0001.exr");
        let planes = channels(&file);
        assert_eq!(planes.len(), 4 + 4 + 3 + 3);
        let mut redone = [0.0_f32; 2];
        let (mut objects, mut shadows) = (0, 0);
        for (i, codes) in plate.iter().enumerate() {
            let a = planes["object.A"][i];
            objects += usize::from(a == 1.0);
            shadows += usize::from(a == 0.0 && planes["catcher.G"][i] < 0.6);
            for (c, letter) in ["R", "G", "B"].iter().enumerate() {
                let at = |layer: &str| planes[&format!("{layer}.{letter}")][i];
                let p = linear(codes[c]);
                let out = match shadow {
                    "multiply" => at("object") + p * at("catcher") * (1.0 - a),
                    _ => (at("object") + p * (1.0 - a) + at("difference")).max(0.0),
                };
                let image = planes[*letter][i];
                redone[0] = redone[0].max((out - image).abs());
                redone[1] = redone[1].max((at("object") + p * (1.0 - a) - image).abs());
                assert!(
                    at("difference") <= 0.0 && (at("difference") == 0.0) == (at("catcher") == 1.0)
                );
            }
        }
        assert!(redone[0] <= 1e-6, "{shadow}: {redone:?}");
        assert!(
            redone[1] > 0.05,
            "without the shadow it is another image: {redone:?}"
        );
        assert!(objects > 20 && shadows > 20, "{objects} {shadows}");
        let bytes = fs::read(&file).unwrap();
        let formula = match shadow {
            "multiply" => &b"out = object.rgb + plate * catcher * (1 - object.a)"[..],
            _ => b"out = max(0, object.rgb + plate * (1 - object.a) + difference)",
        };
        assert!(bytes.windows(formula.len()).any(|w| w == formula));
        // The file is light, too, and its image is what is read of it.
        t.run(&["info", "out/frame.0001.exr"]).ok();
    }
    // Layers that are asked for later are not there yet.
    t.shot("light.exr", &backplate("plate.png", ""));
    let small = |set: &str| t.run(&["render", "shot.toml", "--set", set]).ok();
    small("image.rays_per_pixel=2").says(&["1 frame rendered"]);
    small("image.rays_per_pixel=2").says(&["0 frames rendered, 1 there already"]);
    t.shot("light.exr", &backplate("plate.png", aovs));
    small("image.rays_per_pixel=2").says(&["1 frame rendered"]);
    small("image.rays_per_pixel=2").says(&["0 frames rendered, 1 there already"]);
    t.run(&["render", "shot.toml", "--set", "output.exr=false"])
        .fails(2, &["output.aovs", "output.exr"]);
    t.run(&["render", "shot.toml", "--set", "output.aovs=[\"catchers\"]"])
        .fails(2, &["did you mean `catcher`?"]);
}

/// Without a plate the shadow is alpha, or lies on the environment.
#[test]
fn shadows_without_a_plate() {
    let t = Scratch::new("no-plate");
    lamp(&t, "light.exr");
    t.shot("light.exr", SCENE);
    t.run(&[
        "render",
        "shot.toml",
        "--set",
        "image.background=transparent",
        "--set",
        "output.aovs=[\"object\"]",
    ])
    .ok();
    let planes = channels(&t.file("out/frame.0001.exr"));
    let pairs = || planes["A"].iter().zip(&planes["object.A"]);
    assert!(
        pairs()
            .filter(|(a, object)| **object == 0.0 && **a > 0.3)
            .count()
            > 3
    );
    assert!(pairs().filter(|(a, _)| **a == 0.0).count() > 50);
    assert!(pairs().all(|(a, object)| a >= object && *a <= 1.0));
    let pixels = image::open(t.file("out/frame.0001.png"))
        .unwrap()
        .to_rgba8();
    assert!(
        pixels
            .pixels()
            .any(|p| p.0[..3] == [0, 0, 0] && p.0[3] > 80 && p.0[3] < 255)
    );
    t.run(&["render", "shot.toml"]).ok();
    let planes = channels(&t.file("out/frame.0001.exr"));
    assert!(planes["A"].iter().all(|a| *a == 1.0));
}

#[test]
fn the_image_is_as_large_as_its_plate() {
    let t = Scratch::new("plate-size");
    lamp(&t, "light.exr");
    png(&t, "plate.png", 23, 17, 0);
    let shot = |keys: &str| {
        let text = format!(
            "[probe]\nframes = \"light.exr\"\n[image]\nrays_per_pixel = 1\n{keys}\
             [backplate]\nframes = \"plate.png\"\n[[object]]\nmesh = \"sphere\"\n"
        );
        t.put("shot.toml", text);
    };
    let size = |more: &[&str]| {
        t.run(&[&["render", "shot.toml"], more].concat()).ok();
        image::image_dimensions(t.file("out/frame.0001.png")).unwrap()
    };
    shot("");
    assert_eq!(size(&[]), (23, 17));
    let told = t.run(&["info", "--json", "shot.toml"]).ok().out;
    let told: serde_json::Value = serde_json::from_str(&told).unwrap();
    assert_eq!(told["image"]["size"], serde_json::json!([23, 17]));
    assert_eq!(size(&["--set", "image.size=[9,8]"]), (9, 8));
    shot("size = [12, 10]\n");
    assert_eq!(size(&[]), (12, 10));
    t.run(&["render", "shot.toml"]).ok().says(&[
        "note:",
        "plate.png",
        "23 × 17 pixels are stretched to 12 × 10",
        "crop",
    ]);
    let cropped = t
        .run(&["render", "shot.toml", "--set", "backplate.fit=crop"])
        .ok();
    assert!(!cropped.err.contains("stretched"), "{}", cropped.err);
    // A plate of one pixel is a plate.
    png(&t, "plate.png", 1, 1, 40);
    assert_eq!(size(&[]), (12, 10));
    let corner = read_png(&t.file("out/frame.0001.png"))[0];
    assert_eq!(corner, codes(1, 1, 40)[0]);
    shot("");
    assert_eq!(size(&[]), (1, 1));
}

#[test]
fn bad_plates_are_named() {
    let t = Scratch::new("bad-plates");
    lamp(&t, "light.exr");
    let render = |frames: &str| {
        t.shot("light.exr", &backplate(frames, ""));
        t.run(&["render", "shot.toml"])
    };
    render("gone.png").fails(3, &["gone.png", "no such file"]);
    render("gone.####.png").fails(3, &["gone.####.png", "backplate.frames"]);
    t.put("text.png", "a plate");
    render("text.png").fails(3, &["text.png", "neither OpenEXR", "convert"]);
    t.put("empty.png", "");
    render("empty.png").fails(3, &["empty.png", "empty"]);
    render("a##b##.png").fails(2, &["backplate.frames", "two numbers"]);
    render("").fails(2, &["backplate", "names no footage"]);

    png(&t, "cut.png", 64, 48, 0);
    let jpeg = image::RgbImage::from_fn(64, 48, |x, y| image::Rgb([x as u8, y as u8, 7]));
    jpeg.save(t.file("cut.jpg")).unwrap();
    t.exr("cut.exr", 64, 48, |x, y, c| (x * y + c) as f32);
    for name in ["cut.png", "cut.jpg", "cut.exr"] {
        render(name).ok();
        let whole = fs::read(t.file(name)).unwrap();
        for part in [2, 3] {
            fs::write(t.file(name), &whole[..whole.len() - whole.len() / part]).unwrap();
            render(name).fails(3, &[name]);
        }
    }

    let mut red = vec![0.5_f32; 192];
    (red[5], red[9], red[20]) = (f32::NAN, f32::INFINITY, -0.5);
    let plane = |v: &[f32]| FlatSamples::F32(v.to_vec());
    let rest = vec![0.5_f32; 192];
    let list = [("R", plane(&red)), ("G", plane(&rest)), ("B", plane(&rest))];
    t.exr_channels("nan.exr", 16, 12, Compression::ZIP16, &list);
    render("nan.exr").ok().says(&[
        "warning:",
        "nan.exr",
        "2 of 192 pixels are not colours: 1 NaN, 1 infinite",
    ]);
    t.run(&["render", "shot.toml", "--strict"])
        .fails(3, &["nan.exr", "2 of 192 pixels"]);

    png(&t, "fine.png", 16, 12, 0);
    t.shot("light.exr", &backplate("fine.png", "fps = 0\n"));
    t.run(&["render", "shot.toml"])
        .fails(2, &["backplate.fps", "0.1 and 1000"]);
    t.shot("light.exr", &backplate("fine.png", "shadow = \"mult\"\n"));
    t.run(&["render", "shot.toml"])
        .fails(2, &["did you mean `multiply`?"]);
}

/// A backplate's frames, each of another salt, so that it can be told which one was taken.
fn sequence(t: &Scratch, frames: std::ops::RangeInclusive<u32>) {
    for frame in frames {
        png(t, &format!("plate.{frame:04}.png"), 16, 12, frame * 20);
    }
}

/// The plate frame that a rendered frame shows in its corner.
fn shown(t: &Scratch, frame: u32) -> u32 {
    let pixel = read_png(&t.file(&format!("out/frame.{frame:04}.png")))[0];
    u32::from(pixel[0]) / 20
}

#[test]
fn sequences_of_different_lengths() {
    let t = Scratch::new("lengths");
    lamps(&t, 1..=4);
    sequence(&t, 2..=6);
    let away = backplate("plate.####.png", "[output]\nvideo = \"\"\n")
        .replace("[0, 0, 0.2]", "[0, 0, 500]");
    t.shot("light.####.exr", &away);
    t.run(&["render", "shot.toml"])
        .ok()
        .says(&["3 frames rendered"])
        .says(&["warning:", "frame 1 of the probe is left out"])
        .says(&["warning:", "frames 5 to 6 of the backplate are left out"]);
    assert_eq!([2, 3, 4].map(|f| shown(&t, f)), [2, 3, 4]);
    // Frames that are asked for must be there.
    t.run(&["render", "shot.toml", "--set", "render.frames=1-3"])
        .fails(
            3,
            &[
                "plate.0001.png",
                "frame 1",
                "missing",
                "there are frames 2 to 6",
            ],
        );
    t.run(&["render", "shot.toml", "--set", "render.frames=3-5"])
        .fails(3, &["light.0005.exr"]);
    let exact = t
        .run(&["render", "shot.toml", "--set", "render.frames=2-4"])
        .ok();
    assert!(!exact.err.contains("left out"), "{}", exact.err);
    fs::remove_file(t.file("plate.0003.png")).unwrap();
    t.run(&["render", "shot.toml"])
        .fails(3, &["plate.0003.png", "missing"]);
    png(&t, "plate.0003.png", 20, 12, 0);
    t.run(&["render", "shot.toml"]).fails(
        3,
        &[
            "plate.0003.png",
            "it is 20 × 12",
            "plate.0002.png is 16 × 12",
        ],
    );
    // Numbers that never meet.
    for frame in 2..=6 {
        fs::remove_file(t.file(&format!("plate.{frame:04}.png"))).unwrap();
    }
    sequence(&t, 11..=12);
    t.run(&["render", "shot.toml"]).fails(
        3,
        &[
            "frames 11 to 12",
            "the probe 1 to 4",
            "none belong together",
        ],
    );
    // A still light lasts as long as the footage.
    lamp(&t, "still.exr");
    t.shot("still.exr", &away);
    t.run(&["render", "shot.toml"])
        .ok()
        .says(&["2 frames rendered"]);
    assert_eq!([11, 12].map(|f| shown(&t, f)), [11, 12]);
}

#[test]
fn sequences_of_different_rates() {
    let t = Scratch::new("rates");
    lamps(&t, 5..=8);
    sequence(&t, 1..=7);
    let keys = "fps = 50\n[output]\nvideo = \"\"\n";
    let away = backplate("plate.####.png", keys).replace("[0, 0, 0.2]", "[0, 0, 500]");
    t.shot("light.####.exr", &away);
    t.run(&["render", "shot.toml"])
        .ok()
        .says(&["4 frames rendered"])
        .says(&[
            "note:",
            "50 frames a second, the probe 25",
            "matched by time",
        ]);
    assert_eq!([5, 6, 7, 8].map(|f| shown(&t, f)), [1, 3, 5, 7]);
    // By half the rate each is shown twice; 0.5 rounds up.
    t.run(&["render", "shot.toml", "--set", "backplate.fps=12.5"])
        .ok();
    assert_eq!([5, 6, 7, 8].map(|f| shown(&t, f)), [1, 2, 2, 3]);
    // The same rate needs no matching.
    t.run(&["render", "shot.toml", "--set", "backplate.fps=25"])
        .ok()
        .says(&["3 frames rendered"])
        .says(&["frame 8 of the probe is left out"]);
    assert_eq!(shown(&t, 5), 5);
}

/// A frame depends on its plate's content, not on its name.
#[test]
fn plates_are_part_of_a_frame() {
    let t = Scratch::new("plate-identity");
    lamps(&t, 1..=2);
    sequence(&t, 1..=2);
    let keys = |name: &str| backplate(name, "[output]\nvideo = \"\"\n");
    let render = |name: &str| {
        t.shot("light.####.exr", &keys(name));
        t.run(&["render", "shot.toml"]).ok()
    };
    render("plate.####.png").says(&["2 frames rendered"]);
    render("plate.####.png").says(&["0 frames rendered, 2 there already"]);
    png(&t, "plate.0002.png", 16, 12, 99);
    render("plate.####.png").says(&["1 frame rendered, 1 there already"]);
    for frame in 1..=2 {
        let names = ["plate", "other"].map(|n| t.file(&format!("{n}.{frame:04}.png")));
        fs::rename(&names[0], &names[1]).unwrap();
    }
    render("other.####.png").says(&["0 frames rendered, 2 there already"]);
    t.run(&["render", "shot.toml", "--set", "backplate.shadow=add"])
        .ok()
        .says(&["2 frames rendered"]);
}

/// A video of frames that are there as EXR alone has the pixels that it would have had at once.
#[test]
fn a_resumed_video_shows_the_composite() {
    let t = Scratch::new("plate-video");
    lamps(&t, 1..=2);
    for frame in 1..=2 {
        png(&t, &format!("plate.{frame:04}.png"), 40, 30, frame);
    }
    let output = "[output]\ncodec = \"av1\"\npng = false\n";
    t.shot("light.####.exr", &backplate("plate.####.png", output));
    let render = |more: &[&str]| {
        let fixed = [
            "render",
            "shot.toml",
            "--set",
            "image.size=[40,30]",
            "--set",
            "image.tonemap=reinhard",
        ];
        t.run(&[&fixed, more].concat()).ok()
    };
    render(&[]).says(&["2 frames rendered"]);
    let video = t.file("out/shot.mp4");
    let at_once = fs::read(&video).unwrap();
    fs::remove_file(&video).unwrap();
    render(&[]).says(&["0 frames rendered, 2 there already", "shot.mp4"]);
    assert!(fs::read(&video).unwrap() == at_once);
    // The layer is what the PNG shows.
    let display = channels(&t.file("out/frame.0001.exr"));
    render(&["--set", "output.png=true", "--out", "png"]);
    let pixels = read_png(&t.file("png/frame.0001.png"));
    for (i, pixel) in pixels.iter().enumerate() {
        let stored =
            ["R", "G", "B"].map(|c| (display[&format!("display.{c}")][i] * 255.0).round() as u8);
        assert_eq!(stored, *pixel);
    }
    // EXRs that were written beside PNGs lack it, and are made again.
    let planes = channels(&t.file("png/frame.0001.exr"));
    assert!(!planes.contains_key("display.R"));
    fs::remove_file(t.file("png/frame.0001.png")).unwrap();
    fs::remove_file(t.file("png/shot.mp4")).unwrap();
    render(&["--out", "png"]).says(&["2 frames rendered"]);
    assert!(fs::read(t.file("png/shot.mp4")).unwrap() == at_once);
}

/// Both processors lay the objects over the plate alike.
#[test]
fn the_gpu_composites_the_same() {
    let t = Scratch::new("plate-gpu");
    let devices = t.run(&["info", "--json"]).ok().out;
    let devices: serde_json::Value = serde_json::from_str(&devices).unwrap();
    if devices["gpus"].as_array().unwrap().is_empty() {
        assert!(
            std::env::var("REQUIRE_GPU").as_deref() != Ok("1"),
            "REQUIRE_GPU=1, and there is none"
        );
        println!("skipped: there is no GPU");
        return;
    }
    lamp(&t, "light.exr");
    png(&t, "plate.png", 48, 36, 3);
    let aovs = "[output]\naovs = [\"object\", \"catcher\"]\n";
    t.shot("light.exr", &backplate("plate.png", aovs));
    for primaries in ["rec709", "acescg"] {
        let of_plate = format!("backplate.primaries={primaries}");
        both_processors_agree(&t, &of_plate);
    }
}

fn both_processors_agree(t: &Scratch, of_plate: &str) {
    let picture = |device: &str| {
        let size = "image.size=[48,36]";
        t.run(&[
            "render",
            "shot.toml",
            "--set",
            size,
            "--set",
            of_plate,
            "--device",
            device,
            "--out",
            device,
        ])
        .ok();
        channels(&t.file(&format!("{device}/frame.0001.exr")))
    };
    let (cpu, gpu) = (picture("cpu"), picture("gpu"));
    assert_eq!(cpu.len(), 4 + 4 + 3);
    for (name, plane) in &cpu {
        let pairs = plane.iter().zip(&gpu[name]);
        let off = pairs
            .filter(|(a, b)| !((*a - *b).abs() <= 0.01 * a.abs().max(0.1)))
            .count();
        assert!(
            off <= plane.len() / 100,
            "{name}: {off} of {} are off",
            plane.len()
        );
    }
    // Where the plate shows alone, it does so bit by bit.
    let alone = |planes: &HashMap<String, Vec<f32>>, i: usize| {
        planes["object.A"][i] == 0.0 && planes["catcher.R"][i] == 1.0
    };
    let both: Vec<usize> = (0..48 * 36)
        .filter(|i| alone(&cpu, *i) && alone(&gpu, *i))
        .collect();
    assert!(both.len() > 200, "{}", both.len());
    assert!(
        both.iter()
            .all(|i| cpu["R"][*i].to_bits() == gpu["R"][*i].to_bits())
    );
}
