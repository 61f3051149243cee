//! Host file: colours of any primaries, curves and sizes: what becomes of light, and that plates keep theirs.

mod common;

use common::{Ran, Scratch};
use exr::math::Vec2;
use exr::meta::attribute::{AttributeValue, Chromaticities, Text};
use exr::prelude::{AnyChannel, AnyChannels, FlatSamples, Image, Layer, WritableImage};
use exr::prelude::{Encoding, LayerAttributes, read_first_flat_layer_from_file};
use std::collections::HashMap;

const AP0: [[f32; 2]; 4] = [
    [0.7347, 0.2653],
    [0.0, 1.0],
    [0.0001, -0.077],
    [0.32168, 0.33767],
];
const AP1: [[f32; 2]; 4] = [
    [0.713, 0.293],
    [0.165, 0.83],
    [0.128, 0.044],
    [0.32168, 0.33767],
];

/// AP0 to Rec. 709, white adapted by Bradford; rows as published with ACES.
const AP0_TO_709: [[f32; 3]; 3] = [
    [2.521_69, -1.134_13, -0.387_56],
    [-0.276_48, 1.372_72, -0.096_24],
    [-0.015_38, -0.152_98, 1.168_35],
];

/// Rec. 709 to AP1, likewise.
const REC_709_TO_AP1: [[f32; 3]; 3] = [
    [0.613_10, 0.339_52, 0.047_38],
    [0.070_19, 0.916_35, 0.013_45],
    [0.020_62, 0.109_57, 0.869_81],
];

fn times(rows: [[f32; 3]; 3], colour: [f32; 3]) -> [f32; 3] {
    rows.map(|row| (0..3).map(|i| row[i] * colour[i]).sum())
}

/// What an EXR says beside its pixels.
#[derive(Default)]
struct Said<'a> {
    chromaticities: Option<[[f32; 2]; 4]>,
    pixel_aspect: Option<f32>,
    texts: &'a [(&'a str, &'a str)],
}

fn exr(
    t: &Scratch,
    name: &str,
    [w, h]: [usize; 2],
    said: &Said<'_>,
    f: impl Fn(usize, usize) -> [f32; 3],
) {
    let plane = |c: usize| -> Vec<f32> { (0..w * h).map(|i| f(i % w, i / w)[c]).collect() };
    let channel = |(c, name): (usize, &str)| AnyChannel::new(name, FlatSamples::F32(plane(c)));
    let list = ["R", "G", "B"].into_iter().enumerate().map(channel);
    let mut attributes = LayerAttributes::default();
    for (key, text) in said.texts {
        let value = AttributeValue::Text(Text::from(*text));
        attributes.other.insert(Text::from(*key), value);
    }
    let channels = AnyChannels::sort(list.collect());
    let layer = Layer::new((w, h), attributes, Encoding::SMALL_LOSSLESS, channels);
    let mut image = Image::from_layer(layer);
    image.attributes.chromaticities = said.chromaticities.map(|points| {
        let [red, green, blue, white] = points.map(|[x, y]| Vec2(x, y));
        Chromaticities {
            red,
            green,
            blue,
            white,
        }
    });
    image.attributes.pixel_aspect = said.pixel_aspect.unwrap_or(1.0);
    image.write().to_file(t.file(name)).unwrap();
}

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
    let size = expected.iter().fold(0.0_f32, |m, c| m.max(c.abs()));
    let off = (0..3).map(|c| (got[c] - expected[c]).abs() / size);
    let off = off.fold(0.0, f32::max);
    assert!(off <= tolerance, "{got:?} is not {expected:?}");
}

/// A frame's channels, and its primaries.
fn frame(t: &Scratch) -> (HashMap<String, Vec<f32>>, [[f32; 2]; 4], f32) {
    let image = read_first_flat_layer_from_file(t.file("out/frame.0001.exr")).unwrap();
    let c = image.attributes.chromaticities.unwrap();
    let points = [c.red, c.green, c.blue, c.white].map(|v| [v.x(), v.y()]);
    let list = image.layer_data.channel_data.list;
    let channels = list
        .iter()
        .map(|c| (c.name.to_string(), c.sample_data.values_as_f32().collect()));
    (channels.collect(), points, image.attributes.pixel_aspect)
}

fn pixel(channels: &HashMap<String, Vec<f32>>, layer: &str, i: usize) -> [f32; 3] {
    ["R", "G", "B"].map(|c| channels[&format!("{layer}{c}")][i])
}

/// A shot of a sphere over a plate, seen by a camera that looks straight at it, or past it.
fn over(t: &Scratch, material: &str, looks_at_it: bool, more: &str) -> Ran {
    let target = if looks_at_it {
        "[0, 0, 0]"
    } else {
        "[0, 0, 500]"
    };
    let text = format!(
        "[image]\nrays_per_pixel = 4\n[probe]\nframes = \"light.exr\"\n[[object]]\nmesh = \"sphere\"\n\
         material = {{ diffuse = {material} }}\n[camera]\neye = [-6, 0, 0]\ntarget = {target}\nfov_x_deg = 40\n\
         [backplate]\nframes = \"plate.exr\"\n{more}"
    );
    t.put("shot.toml", text);
    t.run(&["render", "shot.toml"]).ok()
}

/// What is outside of Rec. 709 or below 0 comes out as it is, with the primaries that it has; others are chosen by a key.
#[test]
fn plates_keep_their_primaries() {
    let t = Scratch::new("plate-primaries");
    t.exr("light.exr", 8, 4, |_, _, _| 1.0);
    let colour = |x: usize, y: usize| [0.5, 0.3 + y as f32 * 0.01, 0.02 - x as f32 * 0.003];
    let said = Said {
        chromaticities: Some(AP0),
        ..Said::default()
    };
    exr(&t, "plate.exr", [16, 12], &said, colour);
    let expected: Vec<[f32; 3]> = (0..16 * 12).map(|i| colour(i % 16, i / 16)).collect();
    over(&t, "[0.5, 0.5, 0.5]", false, "");
    let (channels, points, _) = frame(&t);
    assert_eq!(points, AP0);
    let got: Vec<[f32; 3]> = (0..16 * 12).map(|i| pixel(&channels, "", i)).collect();
    assert_eq!(got, expected);
    // A ramp has no edge, on the display neither.
    let shown = image::open(t.file("out/frame.0001.png")).unwrap().to_rgb8();
    for x in 1..16 {
        let step = shown[(x, 0)].0[0].abs_diff(shown[(x - 1, 0)].0[0]);
        assert!(step <= 2, "an edge of {step} at {x}");
    }

    over(
        &t,
        "[0.5, 0.5, 0.5]",
        false,
        "[output]\nprimaries = \"rec709\"\n",
    );
    let (channels, points, _) = frame(&t);
    assert_eq!(points[0], [0.64, 0.33]);
    for (i, colour) in expected.iter().enumerate() {
        near(pixel(&channels, "", i), times(AP0_TO_709, *colour), 1e-3);
    }
    let t709 = channels["R"][0];
    over(
        &t,
        "[0.5, 0.5, 0.5]",
        false,
        "[output]\nprimaries = \"acescg\"\n",
    );
    let (channels, points, _) = frame(&t);
    assert_eq!(points[0], AP1[0]);
    assert!(channels["R"][0] < t709);
}

/// Over a plate of AP1 an object has the colour there that it has over one of Rec. 709.
#[test]
fn objects_are_brought_to_the_plate() {
    let t = Scratch::new("objects-primaries");
    t.exr("light.exr", 8, 4, |_, _, c| [1.0, 0.8, 0.3][c]);
    let render = |chromaticities, more: &str| {
        let said = Said {
            chromaticities,
            ..Said::default()
        };
        exr(&t, "plate.exr", [16, 12], &said, |_, _| [0.2, 0.6, 0.2]);
        over(&t, "[0.8, 0.1, 0.05]", true, more);
        frame(&t)
    };
    let layers = "[output]\naovs = [\"object\"]\n";
    let (plain, _, _) = render(None, layers);
    let (wide, _, _) = render(Some(AP1), layers);
    let middle = 6 * 16 + 8;
    assert_eq!(plain["object.A"][middle], 1.0);
    for layer in ["", "object."] {
        let of_plain = pixel(&plain, layer, middle);
        assert!(of_plain[0] > 0.1);
        near(
            pixel(&wide, layer, middle),
            times(REC_709_TO_AP1, of_plain),
            1e-3,
        );
    }
    assert_eq!(pixel(&wide, "", 0), [0.2, 0.6, 0.2]);
    // Without a plate the EXR has the primaries that are asked for, and the display does not change.
    let shot = |output: &str| {
        let text = format!(
            "[image]\nsize = [16, 12]\n[probe]\nframes = \"light.exr\"\n[[object]]\nmesh = \"sphere\"\n[output]\n{output}"
        );
        t.put("shot.toml", text);
        t.run(&["render", "shot.toml"]).ok();
        let shown = image::open(t.file("out/frame.0001.png")).unwrap();
        (frame(&t), shown.to_rgb8())
    };
    let ((plain, _, _), shown) = shot("");
    let ((wide, points, _), shown_wide) = shot("primaries = \"acescg\"\n");
    assert_eq!((points, shown), (AP1, shown_wide));
    near(
        pixel(&wide, "", middle),
        times(REC_709_TO_AP1, pixel(&plain, "", middle)),
        1e-3,
    );
}

/// A grey object reflects the light's own colour, whatever primaries it is rendered with.
#[test]
fn grey_is_grey_in_every_working_space() {
    let t = Scratch::new("working-space");
    t.exr("light.exr", 8, 4, |_, _, c| [0.9, 0.5, 0.2][c]);
    let render = |image: &str| {
        let text = format!(
            "[image]\nsize = [16, 12]\n{image}[probe]\nframes = \"light.exr\"\n[[object]]\nmesh = \"sphere\"\n"
        );
        t.put("shot.toml", text);
        t.run(&["render", "shot.toml"]).ok();
        let shown = image::open(t.file("out/frame.0001.png")).unwrap();
        (frame(&t), shown.to_rgb8())
    };
    let ((plain, _, _), shown) = render("");
    let ((wide, points, _), shown_wide) = render("primaries = \"acescg\"\n");
    assert_eq!(points, AP1);
    for i in [0, 6 * 16 + 8] {
        let expected = times(REC_709_TO_AP1, pixel(&plain, "", i));
        near(pixel(&wide, "", i), expected, 2e-3);
    }
    for (a, b) in shown.iter().zip(shown_wide.iter()) {
        assert!(a.abs_diff(*b) <= 1);
    }
}

/// The conversion is linear: light with a channel a little below 0 is nearly that with one a little above.
#[test]
fn negative_channels_take_part_in_the_conversion() {
    let t = Scratch::new("negative-light");
    let said = Said {
        chromaticities: Some(AP0),
        ..Said::default()
    };
    let of = |blue: f32| {
        exr(&t, "light.exr", [8, 4], &said, |_, _| [0.5, 0.3, blue]);
        mean(&t, &["light.exr"]).0
    };
    let [above, below] = [0.001, -0.001].map(of);
    near(below, above, 5e-3);
    let mut expected = times(AP0_TO_709, [0.5, 0.3, -0.001]);
    expected[2] = expected[2].max(0.0);
    near(below, expected, 1e-3);
}

#[test]
fn an_overflow_is_bright() {
    let t = Scratch::new("overflow");
    let of = |sun: f32, other: f32| {
        t.exr("light.exr", 8, 4, |x, y, _| match (x, y) {
            (2, 1) => sun,
            (5, 2) => other,
            _ => 0.25,
        });
        mean(&t, &["light.exr"])
    };
    let (expected, _) = of(65_504.0, 1.0);
    let (got, ran) = of(f32::INFINITY, 1.0);
    assert_eq!(got, expected);
    ran.says(&["warning:", "1 of 32", "1 infinite", "65504"]);
    let (expected, _) = of(80_000.0, 80_000.0);
    assert_eq!(of(f32::INFINITY, 80_000.0).0, expected);
}

/// Attributes that name a colour space count, the first of them that is understood; what is not is said.
#[test]
fn attributes_name_the_primaries() {
    let t = Scratch::new("attributes");
    let of = |chromaticities, texts: &[(&str, &str)]| {
        let said = Said {
            chromaticities,
            texts,
            ..Said::default()
        };
        exr(&t, "light.exr", [8, 4], &said, |_, _| [0.4, 0.3, 0.2]);
        mean(&t, &["light.exr"])
    };
    let (plain, _) = of(None, &[]);
    near(plain, [0.4, 0.3, 0.2], 1e-5);
    let (wide, _) = of(Some(AP1), &[]);
    near(times(REC_709_TO_AP1, wide), plain, 1e-3);
    for texts in [
        ("colorInteropID", "lin_ap1_scene"),
        ("oiio:ColorSpace", "ACEScg"),
    ] {
        assert_eq!(of(None, &[texts]).0, wide);
    }
    let (got, ran) = of(Some(AP0), &[("colorInteropID", "lin_ap1_scene")]);
    assert_eq!(got, wide);
    ran.says(&["warning:", "chromaticities are not those"]);
    let (got, ran) = of(Some(AP1), &[("oiio:ColorSpace", "house look 3")]);
    assert_eq!(got, wide);
    ran.says(&["warning:", "house look 3", "primaries"]);
    let (srgb, _) = of(None, &[("oiio:ColorSpace", "sRGB")]);
    // By the curve of sRGB: 0.4, 0.3 and 0.2 are 0.1329, 0.0732 and 0.0331.
    near(srgb, [0.132_868, 0.073_239, 0.033_105], 1e-3);
    let said = Said {
        texts: &[("oiio:ColorSpace", "pq_rec2020_display")],
        ..Said::default()
    };
    exr(&t, "light.exr", [8, 4], &said, |_, _| [0.4; 3]);
    t.run(&["sh", "light.exr"])
        .fails(3, &["pq_rec2020_display", "convert it"]);
    let ran = t.run(&["info", "light.exr"]);
    assert!(ran.err.contains("pq_rec2020_display"), "{ran:?}");
}

#[test]
fn lines_of_radiance_headers() {
    let t = Scratch::new("hdr-lines");
    let put = |header: &str, end: &str| {
        let lines = format!("#?RADIANCE\n{header}FORMAT=32-bit_rle_rgbe\n\n-Y 4 +X 8\n");
        let texels = [128, 64, 32, 129].repeat(32);
        t.put(
            "light.hdr",
            [lines.replace('\n', end).as_bytes(), &texels].concat(),
        );
    };
    let of = |header: &str, end: &str| {
        put(header, end);
        mean(&t, &["light.hdr"])
    };
    let (plain, _) = of("", "\n");
    near(plain, [1.0, 0.5, 0.25], 0.01);
    assert_eq!(of("", "\r\n").0, plain);
    let (got, ran) = of("EXPOSURE=0\n", "\n");
    assert_eq!(got, plain);
    ran.says(&["note:", "EXPOSURE is 0"]);
    let (got, _) = of("COLORCORR=2 1 0.5\nCOLORCORR=2 1 1\n", "\n");
    near(got, [plain[0] / 4.0, plain[1], plain[2] * 2.0], 1e-5);
    let (got, _) = of(
        "PRIMARIES=0.713 0.293 0.165 0.83 0.128 0.044 0.32168 0.33767\n",
        "\n",
    );
    near(times(REC_709_TO_AP1, got), plain, 2e-3);
    assert_eq!(of("PRIMARIES=0 0 0 0 0 0 0 0\n", "\n").0, plain);
    for line in ["EXPOSURE=-1\n", "COLORCORR=1 2\n", "PRIMARIES=1 2 3\n"] {
        put(line, "\n");
        let key = line.split('=').next().unwrap();
        t.run(&["sh", "light.hdr"]).fails(3, &["light.hdr", key]);
    }
}

/// Chunks of a PNG say how its codes stand for light; keys override them.
#[test]
fn curves_of_display_plates() {
    let t = Scratch::new("png-chunks");
    t.exr("light.exr", 8, 4, |_, _, _| 1.0);
    let put = |change: &dyn Fn(&mut png::Info<'_>)| {
        let mut info = png::Info::with_size(16, 12);
        info.color_type = png::ColorType::Rgb;
        info.bit_depth = png::BitDepth::Eight;
        change(&mut info);
        let file = std::fs::File::create(t.file("plate.exr")).unwrap();
        let mut writer = png::Encoder::with_info(file, info)
            .unwrap()
            .write_header()
            .unwrap();
        writer.write_image_data(&[128; 16 * 12 * 3]).unwrap();
    };
    let of = |more: &str| {
        over(&t, "[0.5, 0.5, 0.5]", false, more);
        let (channels, points, aspect) = frame(&t);
        (channels["G"][0], points, aspect)
    };
    let code = 128.0_f32 / 255.0;
    let srgb = ((code + 0.055) / 1.055).powf(2.4);
    let close =
        |got: f32, expected: f32| assert!((got - expected).abs() < 1e-5, "{got} {expected}");
    put(&|_| ());
    close(of("").0, srgb);
    close(of("transfer = \"linear\"\n").0, code);
    close(
        of("transfer = \"rec709\"\n").0,
        ((code + 0.099) / 1.099).powf(1.0 / 0.45),
    );
    assert_eq!(of("primaries = \"acescg\"\n").1, AP1);
    put(&|info| info.source_gamma = Some(png::ScaledFloat::new(1.0)));
    close(of("").0, code);
    put(&|info| info.source_gamma = Some(png::ScaledFloat::new(0.5)));
    close(of("").0, code * code);
    put(&|info| {
        info.pixel_dims = Some(png::PixelDimensions {
            xppu: 1000,
            yppu: 2000,
            unit: png::Unit::Unspecified,
        });
    });
    assert_eq!(of("").2, 2.0);
}

/// Pixels twice as wide as high show a round sphere half as wide as high.
#[test]
fn anamorphic_plates() {
    let t = Scratch::new("anamorphic");
    t.exr("light.exr", 8, 4, |_, _, _| 1.0);
    let said = Said {
        pixel_aspect: Some(2.0),
        ..Said::default()
    };
    exr(&t, "plate.exr", [64, 72], &said, |_, _| [0.2; 3]);
    over(
        &t,
        "[0.5, 0.5, 0.5]",
        true,
        "[output]\naovs = [\"object\"]\n",
    );
    let (channels, _, aspect) = frame(&t);
    assert_eq!(aspect, 2.0);
    let alpha = &channels["object.A"];
    let width = (0..64).map(|x| alpha[36 * 64 + x]).sum::<f32>();
    let height = (0..72).map(|y| alpha[y * 64 + 32]).sum::<f32>();
    // The outline of a sphere of radius 1 at distance 6, in an image 2 tan 20° wide.
    let expected = (1.0_f32 / 35.0_f32.sqrt()) / 20.0_f32.to_radians().tan() * 64.0;
    assert!((width - expected).abs() < 0.5, "{width} {expected}");
    assert!((height / width - 2.0).abs() < 0.06, "{width} {height}");
    let bytes = std::fs::read(t.file("out/frame.0001.png")).unwrap();
    let reader = png::Decoder::new(std::io::Cursor::new(bytes)).read_info();
    let dims = reader.unwrap().info().pixel_dims.unwrap();
    assert_eq!(dims.yppu, 2 * dims.xppu);
    // In an image of the proportions that it is seen with, its pixels become squares.
    let wide = ["render", "shot.toml", "--set", "image.size=[128,72]"];
    t.run(&wide).ok();
    let (channels, _, aspect) = frame(&t);
    assert_eq!(aspect, 1.0);
    let alpha = &channels["object.A"];
    let width = (0..128).map(|x| alpha[36 * 128 + x]).sum::<f32>();
    let height = (0..72).map(|y| alpha[y * 128 + 64]).sum::<f32>();
    assert!((height / width - 1.0).abs() < 0.03, "{width} {height}");
}
