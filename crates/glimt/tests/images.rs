//! Host file: images in and out: channels, primaries, mappings, round trips.

mod common;

use common::{Scratch, read_exr, shared_data};
use exr::math::Vec2;
use exr::prelude::{
    AnyChannel, AnyChannels, Compression, Encoding, FlatSamples, Image, Layer, LayerAttributes,
    WritableImage,
};
use glimt::input::read_image;
use glimt::notes::Notes;
use serde_json::Value;

fn info(t: &Scratch, name: &str) -> Value {
    let ran = t.run(&["info", "--json", name]).ok();
    serde_json::from_str(ran.out.lines().last().unwrap()).unwrap()
}

#[test]
fn any_channels() {
    let t = Scratch::new("channels");
    let flat = |v: f32| FlatSamples::F32(vec![v; 8]);
    let mean = |name: &str| info(&t, name)["light"]["mean"].as_f64().unwrap();
    let check = |channels: &[(&str, FlatSamples)], expected: f64| {
        t.exr_channels("a.exr", 4, 2, Compression::PIZ, channels);
        let got = mean("a.exr");
        assert!(
            !((got - expected).abs() > 1e-4),
            "{channels:?}: {got} is not {expected}"
        );
    };
    check(&[("Y", flat(2.0))], 2.0);
    check(
        &[
            ("R", flat(1.0)),
            ("G", flat(0.0)),
            ("B", flat(0.0)),
            ("A", flat(0.5)),
        ],
        0.2126,
    );
    check(
        &[
            ("sky.R", flat(0.0)),
            ("sky.G", flat(1.0)),
            ("sky.B", flat(0.0)),
        ],
        0.7152,
    );
    // R = (RY + 1) Y, B = (BY + 1) Y, and the luminance is Y.
    check(
        &[("Y", flat(3.0)), ("RY", flat(0.5)), ("BY", flat(-0.5))],
        3.0,
    );
    check(&[("Y", FlatSamples::U32(vec![7; 8]))], 7.0);
}

/// An image is its display window: what lies outside is cropped, and what is not stored is black.
#[test]
fn windows_are_placed() {
    let t = Scratch::new("windows");
    let write = |name: &str, at: [i32; 2], data: [usize; 2], display: [usize; 2]| {
        let ramp: Vec<f32> = (1..=data[0] * data[1]).map(|i| i as f32).collect();
        let channels = ["B", "G", "R"].map(|c| AnyChannel::new(c, FlatSamples::F32(ramp.clone())));
        let layer = Layer::new(
            (data[0], data[1]),
            LayerAttributes::default().with_position(Vec2(at[0], at[1])),
            Encoding::UNCOMPRESSED,
            AnyChannels::sort(channels.into_iter().collect()),
        );
        let mut image = Image::from_layer(layer);
        image.attributes.display_window.position = Vec2(-3, 5);
        image.attributes.display_window.size = Vec2(display[0], display[1]);
        image.write().to_file(t.file(name)).unwrap();
    };
    let red = |name: &str, notes: &mut Notes| -> Vec<f32> {
        let image = read_image(&t.file(name), notes).unwrap();
        image.texels.iter().map(|texel| texel.x).collect()
    };

    // A region of the image: one column from the left, one row from the top.
    write("region.exr", [-2, 6], [2, 1], [4, 2]);
    let mut notes = Notes::new(false);
    let texels = red("region.exr", &mut notes);
    assert_eq!(texels, [0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 2.0, 0.0]);
    let told = notes.take();
    assert_eq!(told.len(), 1);
    assert!(
        told[0].text.contains("data window is 2 × 1 from (-2, 6)"),
        "{told:?}"
    );
    assert!(
        told[0].text.contains("display window 4 × 2 from (-3, 5)"),
        "{told:?}"
    );
    // Overscan: a column and a row more on the upper left, two columns more on the right.
    write("overscan.exr", [-4, 4], [7, 3], [4, 2]);
    let texels = red("overscan.exr", &mut notes);
    assert_eq!(texels, [9.0, 10.0, 11.0, 12.0, 16.0, 17.0, 18.0, 19.0]);
    // All of it, though not from the origin: nothing to remark.
    write("whole.exr", [-3, 5], [4, 2], [4, 2]);
    let mut notes = Notes::new(false);
    assert_eq!(
        red("whole.exr", &mut notes),
        [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0]
    );
    assert_eq!(notes.take(), []);

    // Frames that store more or less of one image are of one size; the file says so, and the run.
    let value = info(&t, "region.exr");
    assert_eq!(value["header"]["size"], serde_json::json!([4, 2]));
    assert_eq!(value["header"]["data_size"], serde_json::json!([2, 1]));
    for (i, name) in ["region.exr", "overscan.exr"].iter().enumerate() {
        let frame = t.file(&format!("light.{}.exr", i + 1));
        std::fs::rename(t.file(name), frame).unwrap();
    }
    t.shot("light.#.exr", "[output]\nvideo = \"\"\n");
    t.run(&["render", "shot.toml"])
        .ok()
        .says(&["note: ", "light.1.exr", "display window 4 × 2"]);
    write("light.2.exr", [-3, 5], [4, 2], [6, 3]);
    t.run(&["render", "shot.toml"])
        .fails(3, &["light.2.exr", "it is 6 × 3", "is 4 × 2"]);
    write("light.1.exr", [-3, 5], [4, 2], [40_000, 40_000]);
    t.run(&["render", "shot.toml"])
        .fails(3, &["light.1.exr", "display window: it has 40000 × 40000"]);
}

/// What is written is what was rendered: the linear frame of the demo of light alone, read back as light.
#[test]
fn exr_round_trip() {
    let t = Scratch::new("round");
    t.lights(1);
    t.shot("light.0001.exr", "");
    t.run(&["render", "shot.toml"]).ok();
    let planes = read_exr(&t.file("out/frame.0001.exr"));
    assert_eq!(planes.len(), 4, "A, B, G, R");
    assert!(planes.iter().all(|p| p.len() == 16 * 12));
    let value = info(&t, "out/frame.0001.exr");
    assert_eq!(value["header"]["size"], serde_json::json!([16, 12]));
    let remarks = value["header"]["remarks"].to_string();
    assert!(remarks.contains("written by glimt"), "{remarks}");
    assert!(
        !remarks.contains("primaries"),
        "Rec. 709 needs no conversion: {remarks}"
    );
}

/// The middle of the image looks along +x, the middle of the map; +y is to the left, +z up.
#[test]
fn the_light_is_seen_the_right_way_round() {
    let t = Scratch::new("orientation");
    // Red to the left of the middle, green above, blue to the right.
    t.exr("light.exr", 64, 32, |x, y, c| {
        let hit = match c {
            0 => (26..30).contains(&x) && (14..18).contains(&y),
            1 => (30..34).contains(&x) && (10..13).contains(&y),
            _ => (34..38).contains(&x) && (14..18).contains(&y),
        };
        f32::from(u8::from(hit))
    });
    // The sphere stands behind the camera.
    let more =
        "translate = [-9, 0, 0]\n[camera]\neye = [0, 0, 0]\ntarget = [1, 0, 0]\nfov_x_deg = 100\n";
    t.shot("light.exr", more);
    let centroid = |turn: &str| {
        let turn = format!("probe.rotate_z_deg={turn}");
        t.run(&[
            "render",
            "shot.toml",
            "--set",
            "image.size=[60,60]",
            "--set",
            &turn,
        ])
        .ok();
        let planes = read_exr(&t.file("out/frame.0001.exr"));
        // B, G, R after A.
        [3, 2, 1].map(|c: usize| {
            let mut sums = [0.0_f32; 3];
            for (i, v) in planes[c].iter().enumerate() {
                sums[0] += v;
                sums[1] += v * (i % 60) as f32;
                sums[2] += v * (i / 60) as f32;
            }
            (sums[1] / sums[0], sums[2] / sums[0])
        })
    };
    let [red, green, blue] = centroid("0");
    assert!(red.0 < 26.0 && blue.0 > 33.0, "{red:?} {blue:?}");
    assert!(green.1 < 24.0 && (green.0 - 29.5).abs() < 3.0, "{green:?}");
    // Counter-clockwise seen from above: toward +y, to the left.
    let [turned, ..] = centroid("5");
    assert!((red.0 - turned.0 - 2.6).abs() < 0.6, "{turned:?} {red:?}");
}

/// Both processors render the same picture, up to rays that pass an edge on either side.
#[test]
fn the_gpu_renders_the_same() {
    let t = Scratch::new("gpu-image");
    let devices: Value = serde_json::from_str(&t.run(&["info", "--json"]).ok().out).unwrap();
    if devices["gpus"].as_array().unwrap().is_empty() {
        assert!(
            std::env::var("REQUIRE_GPU").as_deref() != Ok("1"),
            "REQUIRE_GPU=1, and there is none"
        );
        println!("skipped: there is no GPU");
        return;
    }
    t.lights(1);
    t.shot("light.0001.exr", "[camera]\nfov_x_deg = 60\n");
    let picture = |device: &str| {
        let size = [
            "--set",
            "image.size=[48,36]",
            "--set",
            "image.rays_per_pixel=8",
        ];
        let args = [
            &["render", "shot.toml", "--device", device, "--out", device],
            &size[..],
        ]
        .concat();
        t.run(&args).ok();
        read_exr(&t.file(device).join("frame.0001.exr"))
    };
    let (cpu, gpu) = (picture("cpu"), picture("gpu"));
    for (a, b) in cpu.iter().zip(&gpu) {
        let (sum_a, sum_b) = (a.iter().sum::<f32>(), b.iter().sum::<f32>());
        assert!(!((sum_a / sum_b - 1.0).abs() > 1e-3), "{sum_a} {sum_b}");
        let off = a
            .iter()
            .zip(b)
            .filter(|(x, y)| !((*x - *y).abs() <= 0.01 * x.max(1.0)))
            .count();
        assert!(
            off <= a.len() / 100,
            "{off} of {} pixels are off by more than 1 %",
            a.len()
        );
    }
    // A frame is the same frame wherever it was rendered.
    t.run(&[
        "render",
        "shot.toml",
        "--device",
        "cpu",
        "--out",
        "gpu",
        "--set",
        "image.size=[48,36]",
        "--set",
        "image.rays_per_pixel=8",
    ])
    .ok()
    .says(&["0 frames rendered, 1 there already"]);
}

#[test]
fn an_angular_map_shows_the_same() {
    let t = Scratch::new("angular");
    t.exr("light.exr", 64, 64, |x, y, c| {
        let (dx, dy) = (x as f32 - 31.5, y as f32 - 31.5);
        let ahead = dx.hypot(dy) < 8.0;
        f32::from(u8::from(ahead && c == 0))
    });
    let more =
        "translate = [-9, 0, 0]\n[camera]\neye = [0, 0, 0]\ntarget = [1, 0, 0]\nfov_x_deg = 120\n";
    t.shot("light.exr", more);
    t.run(&[
        "render",
        "shot.toml",
        "--set",
        "probe.mapping=angular",
        "--set",
        "image.size=[61,61]",
    ])
    .ok();
    let planes = read_exr(&t.file("out/frame.0001.exr"));
    let red = &planes[3];
    // 8 of 32 pixels are 45°, and tan 45° / tan 60° of half the image.
    assert!(red[30 * 61 + 30] > 0.99);
    assert!(red[30 * 61 + 30 + 15] > 0.9 && red[30 * 61 + 30 + 20] < 0.1);
    t.exr("light.exr", 8, 4, |_, _, _| 1.0);
    t.run(&["render", "shot.toml", "--set", "probe.mapping=angular"])
        .fails(3, &["an angular map is square", "8 × 4"]);
}

#[test]
fn exposure_of_a_radiance_file_is_divided_out() {
    let t = Scratch::new("exposure");
    let texels = [128, 128, 128, 129].repeat(8);
    let file = |header: &str| {
        [
            format!("#?RADIANCE\n{header}FORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 4\n").as_bytes(),
            &texels,
        ]
        .concat()
    };
    t.put("a.hdr", file(""));
    t.put("b.hdr", file("EXPOSURE=4\nEXPOSURE=0.5\n"));
    let mean = |name: &str| info(&t, name)["light"]["mean"].as_f64().unwrap();
    assert!((mean("a.hdr") / mean("b.hdr") - 2.0).abs() < 1e-5);
    t.put(
        "c.hdr",
        String::from_utf8_lossy(&file("")).replace("rgbe", "xyze"),
    );
    t.run(&["info", "c.hdr"])
        .fails(3, &["c.hdr", "xyze", "OpenEXR"]);
}

#[test]
fn real_files_are_read() {
    let Some(data) = shared_data() else {
        return;
    };
    let t = Scratch::new("real");
    let path = |name: &str| data.join(name).to_string_lossy().into_owned();
    // Lossy files with negative texels; the counts are stable for a decoder.
    for (name, least) in [("hdri_dwab/forest.exr", 500), ("hdri_dwab/park.exr", 50)] {
        let value = info(&t, &path(name));
        let bad = value["bad_texels"]["negative"].as_u64().unwrap();
        assert!(bad > least, "{name}: {bad}");
        assert!(
            value["header"]["storage"]
                .as_str()
                .unwrap()
                .contains("dwab")
        );
        t.shot(&path(name), "");
        t.run(&["render", "shot.toml", "--strict"])
            .fails(3, &["negative"]);
        t.run(&["render", "shot.toml"])
            .ok()
            .says(&["warning:", "negative"]);
    }
    for (name, size, max) in [
        ("hdri/KernerEnvLatLong.exr", [1024, 512], 1678.0),
        ("hdri/StageEnvLatLong.exr", [1000, 500], 4096.0),
        ("hdri/spruit_sunrise_1k.hdr", [1024, 512], 1.61e5),
    ] {
        let value = info(&t, &path(name));
        assert_eq!(value["header"]["size"], serde_json::json!(size), "{name}");
        let got = value["light"]["max"].as_f64().unwrap();
        assert!((got / max - 1.0).abs() < 0.01, "{name}: {got}");
    }
    for (name, triangles) in [
        ("models/Ingenuity.glb", 9060),
        ("models/stanford-bunny.obj", 69_451),
        ("models/dragon_vrip_res3.ply.gz", 47_794),
    ] {
        assert_eq!(info(&t, &path(name))["triangles"], triangles, "{name}");
    }
}
