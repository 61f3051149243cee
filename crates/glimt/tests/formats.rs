//! Host file: which files are read as light and plates, which of their images is taken, and what is refused at once.

mod common;

use common::{Ran, Scratch};
use exr::prelude::{
    AnyChannel, AnyChannels, Compression, Encoding, FlatSamples, Image, ImageAttributes,
    IntegerBounds, Layer, LayerAttributes, WritableImage,
};
use std::fs;

/// The mean colour of a light: its first coefficient over that of a light of 1.
fn mean(t: &Scratch, args: &[&str]) -> ([f32; 3], Ran) {
    let ran = t.run(&[&["sh"], args].concat()).ok();
    let row = ran.out.lines().find(|line| line.starts_with("1,0,0,"));
    let numbers: Vec<f32> = row
        .expect("a row")
        .split(',')
        .map(|n| n.parse().unwrap())
        .collect();
    let of_one = (4.0 * std::f32::consts::PI).sqrt();
    let mean = [3, 4, 5].map(|i| numbers[i] / of_one);
    (mean, ran)
}

fn near(got: [f32; 3], expected: [f32; 3], tolerance: f32) {
    let off = (0..3).map(|c| (got[c] - expected[c]).abs());
    assert!(
        off.fold(0.0, f32::max) <= tolerance,
        "{got:?} is not {expected:?}"
    );
}

/// An EXR of one part with these layers, of which each has one value everywhere.
fn layered(t: &Scratch, layers: &[(&str, f32)]) {
    let names: Vec<String> = layers
        .iter()
        .flat_map(|(layer, _)| ["R", "G", "B"].map(|c| format!("{layer}{c}")))
        .collect();
    let channels: Vec<(&str, FlatSamples)> = names
        .iter()
        .zip(layers.iter().flat_map(|(_, value)| [*value; 3]))
        .map(|(name, value)| (name.as_str(), FlatSamples::F32(vec![value; 32])))
        .collect();
    t.exr_channels("light.exr", 8, 4, Compression::ZIP16, &channels);
    t.shot("light.exr", "");
}

/// The mean of the light that a shot takes, with these settings.
fn taken(t: &Scratch, probe: &str) -> (f32, Ran) {
    let text = format!("[probe]\nframes = \"light.exr\"\n{probe}[[object]]\nmesh = \"sphere\"\n");
    t.put("shot.toml", text);
    let (mean, ran) = mean(t, &["shot.toml"]);
    (mean[0], ran)
}

#[test]
fn the_picture_of_a_file_is_taken() {
    let t = Scratch::new("layers");
    let close =
        |got: f32, expected: f32| assert!((got - expected).abs() < 1e-4, "{got} {expected}");
    layered(&t, &[("albedo.", 9.0), ("beauty.", 1.0), ("normal.", 8.0)]);
    let (got, ran) = taken(&t, "");
    close(got, 1.0);
    ran.says(&["note:", "beauty is taken", "albedo, normal", "probe.layer"]);
    close(taken(&t, "layer = \"albedo\"\n").0, 9.0);
    t.run(&["sh", "shot.toml"]).ok();

    layered(&t, &[("ViewLayer.AO.", 9.0), ("ViewLayer.Combined.", 2.0)]);
    close(taken(&t, "").0, 2.0);
    close(taken(&t, "layer = \"AO\"\n").0, 9.0);
    // Plain channels come before all layers.
    layered(&t, &[("beauty.", 9.0), ("", 3.0)]);
    close(taken(&t, "").0, 3.0);
    layered(&t, &[("beauty.left.", 4.0), ("beauty.right.", 9.0)]);
    close(taken(&t, "").0, 4.0);
    close(taken(&t, "layer = \"right\"\n").0, 9.0);
    // One of many that nobody knows is a guess, which is refused where guesses are.
    layered(&t, &[("fill.", 9.0), ("key.", 5.0)]);
    let (got, ran) = taken(&t, "");
    close(got, 9.0);
    ran.says(&["warning:", "fill is taken", "key"]);
    t.run(&["render", "shot.toml", "--strict"])
        .fails(3, &["light.exr", "fill, key"]);
    layered(&t, &[("key.", 5.0)]);
    close(taken(&t, "").0, 5.0);

    layered(&t, &[("albedo.", 9.0), ("normal.", 8.0)]);
    let words = [
        "light.exr",
        "none of its layers is a picture",
        "albedo",
        "probe.layer",
    ];
    t.run(&["render", "shot.toml"]).fails(3, &words);
    t.run(&["render", "shot.toml", "--set", "probe.layer=albdo"])
        .fails(3, &["no layer `albdo`", "did you mean `albedo`"]);
    let ran = t.run(&["info", "light.exr"]);
    assert_eq!(ran.status, 3);
}

#[test]
fn the_picture_of_many_parts_is_taken() {
    let t = Scratch::new("parts");
    let part = |name: &str, view: Option<&str>, value: f32| {
        let channel = |c: &str| AnyChannel::new(c, FlatSamples::F32(vec![value; 32]));
        let list = ["R", "G", "B"].into_iter().map(channel).collect();
        let mut attributes = LayerAttributes::named(name);
        attributes.view_name = view.map(|view| view.into());
        Layer::new(
            (8, 4),
            attributes,
            Encoding::FAST_LOSSLESS,
            AnyChannels::sort(list),
        )
    };
    let write = |parts: Vec<Layer<AnyChannels<FlatSamples>>>| {
        let window = IntegerBounds::from_dimensions((8, 4));
        Image::from_layers(ImageAttributes::new(window), parts)
            .write()
            .to_file(t.file("light.exr"))
            .unwrap();
    };
    write(vec![part("albedo", None, 9.0), part("beauty", None, 1.0)]);
    let (got, ran) = taken(&t, "");
    assert!((got - 1.0).abs() < 1e-4, "{got}");
    ran.says(&["note:", "beauty is taken", "albedo"]);
    write(vec![
        part("rgba_right", Some("right"), 9.0),
        part("rgba_left", Some("left"), 2.0),
    ]);
    assert!((taken(&t, "").0 - 2.0).abs() < 1e-4);
    assert!((taken(&t, "layer = \"right\"\n").0 - 9.0).abs() < 1e-4);
    let ran = t.run(&["info", "light.exr"]).ok();
    for word in [
        "rgba_left",
        "rgba_right",
        "parts       2",
        "primaries",
        "Rec. 709",
    ] {
        assert!(ran.out.contains(word), "{word}: {}", ran.out);
    }
}

#[test]
fn portable_float_maps() {
    let t = Scratch::new("pfm");
    // Rows from the bottom: the lower half is brighter.
    let rows = |order: fn(f32) -> [u8; 4], channels: usize| -> Vec<u8> {
        (0..32)
            .flat_map(|i| {
                let value = if i < 16 { 3.0 } else { 1.0 };
                (0..channels).flat_map(move |_| order(value))
            })
            .collect()
    };
    let put = |header: &str, data: &[u8]| {
        t.put("light.pfm", [header.as_bytes(), data].concat());
    };
    put("PF\n8 4\n-1.0\n", &rows(f32::to_le_bytes, 3));
    let (got, ran) = mean(&t, &["light.pfm"]);
    near(got, [2.0; 3], 1e-4);
    let z = ran.out.lines().find(|line| line.starts_with("1,1,0,"));
    let z: f32 = z.unwrap().split(',').nth(3).unwrap().parse().unwrap();
    assert!(z < -1.0, "it is brighter below: {z}");
    put("PF\n# made by hand\n8 4\n1\n", &rows(f32::to_be_bytes, 3));
    near(mean(&t, &["light.pfm"]).0, [2.0; 3], 1e-4);
    put("Pf 8 4 -1\n", &rows(f32::to_le_bytes, 1));
    near(mean(&t, &["light.pfm"]).0, [2.0; 3], 1e-4);
    let whole = fs::read(t.file("light.pfm")).unwrap();
    for cut in [2, 5, 9, whole.len() - 1] {
        t.put("light.pfm", &whole[..cut]);
        t.run(&["sh", "light.pfm"]).fails(3, &["light.pfm"]);
    }
    t.shot("light.pfm", "");
    put("PF\n8 4\n-1.0\n", &rows(f32::to_le_bytes, 3));
    t.run(&["render", "shot.toml", "--set", "probe.layer=beauty"])
        .fails(3, &["it has no layers", "probe.layer"]);
    put("PF\n100000 100000\n-1.0\n", &[0; 64]);
    t.run(&["sh", "light.pfm"])
        .fails(3, &["100000 × 100000", "image.max_texels"]);
}

/// TIFFs of 8 and 16 bits are of a display, those of floats are linear.
#[test]
fn tiffs_are_light_and_plates() {
    let t = Scratch::new("tiff");
    let srgb = |code: f64| ((code + 0.055) / 1.055).powf(2.4) as f32;
    image::RgbImage::from_pixel(16, 8, image::Rgb([200, 100, 50]))
        .save(t.file("8.tif"))
        .unwrap();
    let deep = image::ImageBuffer::from_pixel(16, 8, image::Rgb([40_000_u16, 20_000, 10_000]));
    image::DynamicImage::ImageRgb16(deep.clone())
        .save(t.file("16.tif"))
        .unwrap();
    image::DynamicImage::ImageRgb16(deep)
        .save(t.file("16.png"))
        .unwrap();
    image::Rgb32FImage::from_pixel(16, 8, image::Rgb([7.5, 1.0, 0.25]))
        .save(t.file("float.tif"))
        .unwrap();
    let of_8 = [200.0, 100.0, 50.0].map(|c| srgb(c / 255.0));
    let of_16 = [40_000.0, 20_000.0, 10_000.0].map(|c| srgb(c / 65_535.0));
    for (name, expected) in [("8.tif", of_8), ("16.tif", of_16), ("16.png", of_16)] {
        let (got, ran) = mean(&t, &[name]);
        near(got, expected, 1e-4);
        ran.says(&["warning:", name, "clipped"]);
    }
    let (got, ran) = mean(&t, &["float.tif"]);
    near(got, [7.5, 1.0, 0.25], 1e-4);
    assert!(!ran.err.contains("clipped"), "{}", ran.err);

    for (name, expected) in [
        ("8.tif", of_8),
        ("16.tif", of_16),
        ("float.tif", [7.5, 1.0, 0.25]),
    ] {
        let text = format!(
            "[probe]\nframes = \"8.tif\"\n[[object]]\nmesh = \"sphere\"\n[camera]\neye = [9, 0, 0]\ntarget = [99, 0, 0]\n\
             [backplate]\nframes = \"{name}\"\n"
        );
        t.put("shot.toml", text);
        t.run(&["render", "shot.toml"]).ok();
        let planes = common::read_exr(&t.file("out/frame.0001.exr"));
        near([planes[3][5], planes[2][5], planes[1][5]], expected, 1e-6);
    }
}

#[test]
fn movies_are_refused_with_the_command() {
    let t = Scratch::new("movies");
    t.exr("light.exr", 8, 4, |_, _, _| 1.0);
    let mut mp4 = b"\0\0\0\x18ftypisom".to_vec();
    mp4.extend([0; 64]);
    t.put("take 1.mp4", &mp4);
    t.put("take.mkv", [0x1a, 0x45, 0xdf, 0xa3, 1, 2, 3]);
    t.put("take.mxf", [6, 14, 43, 52]);
    for name in ["take 1.mp4", "take.mkv", "take.mxf"] {
        t.shot("light.exr", &format!("[backplate]\nframes = \"{name}\"\n"));
        let stem = name.rsplit_once('.').unwrap().0;
        let command = format!("ffmpeg -i \"{name}\" -start_number 1 \"{stem}.%04d.png\"");
        t.run(&["render", "shot.toml"])
            .fails(3, &[name, "movie", &command, &format!("{stem}.####.png")]);
        t.shot(name, "");
        t.run(&["render", "shot.toml"]).fails(3, &[name, &command]);
    }
}

/// Six faces of one light each; where they lie is told by the proportions.
#[test]
fn cube_maps_are_light() {
    let t = Scratch::new("cube");
    // All of the light comes from the face +Y, which is above: mean 1/6 of it, direction +z.
    let strip = |w: usize, h: usize, bright: fn(usize, usize) -> bool| {
        t.exr("light.exr", w, h, |x, y, _| {
            if bright(x / 8, y / 8) { 6.0 } else { 0.0 }
        });
        let text = "[probe]\nframes = \"light.exr\"\n[[object]]\nmesh = \"sphere\"\n";
        t.put("shot.toml", text);
        mean(&t, &["shot.toml"])
    };
    type Upper = fn(usize, usize) -> bool;
    let shapes: [(usize, usize, Upper); 4] = [
        (48, 8, |x, _| x == 2),
        (8, 48, |_, y| y == 2),
        (32, 24, |x, y| (x, y) == (1, 0)),
        (24, 32, |x, y| (x, y) == (1, 0)),
    ];
    for (w, h, bright) in shapes {
        let (got, ran) = strip(w, h, bright);
        near(got, [1.0; 3], 0.01);
        // ∫ z over the upper face: 4 ∫∫ 1/(1 + x² + y²)² dx dy over a quarter of it.
        let n = 400;
        let cell = |i: usize| (i as f64 + 0.5) / f64::from(n);
        let sum: f64 = (0..n as usize)
            .flat_map(|i| (0..n as usize).map(move |j| (i, j)))
            .map(|(i, j)| (1.0 + cell(i).powi(2) + cell(j).powi(2)).powi(-2))
            .sum();
        let integral = 4.0 * sum / f64::from(n * n);
        let expected = 6.0 * integral * (3.0 / (4.0 * std::f64::consts::PI)).sqrt();
        let row = |start: &str| -> f64 {
            let row = ran.out.lines().find(|line| line.starts_with(start));
            row.unwrap().split(',').nth(3).unwrap().parse().unwrap()
        };
        let z = row("1,1,0,");
        assert!((z / expected - 1.0).abs() < 0.01, "{z} {expected}");
        assert!(row("1,1,-1,").abs() < 0.02 && row("1,1,1,").abs() < 0.02);
        ran.says(&["note:", "light.exr", "cube map"]);
    }
    // A photograph of these proportions has no blank corners.
    t.exr("light.exr", 32, 24, |x, y, _| (x * y) as f32);
    t.run(&["render", "shot.toml"])
        .fails(3, &["32 × 24 is not 2:1", "mirror-ball"]);
    t.run(&["render", "shot.toml", "--set", "probe.mapping=cube"])
        .ok();
    t.exr("light.exr", 32, 16, |_, _, _| 1.0);
    t.run(&["render", "shot.toml", "--set", "probe.mapping=cube"])
        .fails(3, &["a cube map is 6:1"]);
}

/// Where the value of an attribute of an EXR of one part begins, and where its chunk table does.
fn places(bytes: &[u8], wanted: &str) -> (usize, usize) {
    let text = |at: usize| {
        let len = bytes[at..].iter().position(|b| *b == 0).unwrap();
        (String::from_utf8_lossy(&bytes[at..at + len]), at + len + 1)
    };
    let (mut at, mut found) = (8, 0);
    while bytes[at] != 0 {
        let (name, after) = text(at);
        let (_, after) = text(after);
        let size = u32::from_le_bytes(bytes[after..after + 4].try_into().unwrap());
        if name == wanted {
            found = after + 4;
        }
        at = after + 4 + size as usize;
    }
    (found, at + 1)
}

#[test]
fn hostile_headers_are_refused_at_once() {
    let t = Scratch::new("hostile");
    t.exr("light.exr", 8, 4, |_, _, _| 1.0);
    t.shot("light.exr", "");
    let whole = fs::read(t.file("light.exr")).unwrap();
    for window in ["dataWindow", "displayWindow"] {
        let mut bytes = whole.clone();
        let (at, _) = places(&bytes, window);
        bytes[at + 8..at + 12].copy_from_slice(&99_999_i32.to_le_bytes());
        bytes[at + 12..at + 16].copy_from_slice(&99_999_i32.to_le_bytes());
        t.put("light.exr", &bytes);
        for command in [["render", "shot.toml"], ["info", "light.exr"]] {
            let ran = t.run(&command);
            assert_eq!(ran.status, 3, "{window}: {ran:?}");
            assert!(!ran.err.contains("panicked"), "{ran:?}");
        }
    }
    t.put("light.exr", &whole);
    let bound = ["render", "shot.toml", "--set", "image.max_texels=31"];
    t.run(&bound)
        .fails(3, &["8 × 4 texels", "31 are the most", "image.max_texels"]);
    t.put(
        "light.hdr",
        "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 200000 +X 200000\n\x02\x02",
    );
    t.run(&["info", "light.hdr"])
        .fails(3, &["200000 × 200000", "image.max_texels"]);

    // A block by DWA that says that it holds 2^46 bytes.
    let plane = |c: f32| {
        FlatSamples::F16(
            (0..64 * 32)
                .map(|i| exr::prelude::f16::from_f32(c + i as f32 * 0.01))
                .collect(),
        )
    };
    let list = [("R", plane(0.1)), ("G", plane(0.2)), ("B", plane(0.3))];
    t.exr_channels("light.exr", 64, 32, Compression::DWAB(None), &list);
    t.run(&["render", "shot.toml"]).ok();
    let mut bytes = fs::read(t.file("light.exr")).unwrap();
    let (_, table) = places(&bytes, "");
    let chunk = u64::from_le_bytes(bytes[table..table + 8].try_into().unwrap()) as usize;
    // Behind its row and its length stand the counters: the second is the size of what is not compressed.
    for counter in [1, 5, 6, 7, 8, 9] {
        let at = chunk + 8 + counter * 8;
        let kept: [u8; 8] = bytes[at..at + 8].try_into().unwrap();
        bytes[at..at + 8].copy_from_slice(&(1_u64 << 46).to_le_bytes());
        t.put("light.exr", &bytes);
        t.run(&["render", "shot.toml"])
            .fails(3, &["light.exr", "holds more than its texels"]);
        bytes[at..at + 8].copy_from_slice(&kept);
    }
}
