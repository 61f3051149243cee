//! Host file: catchers, layers and plates on both processors: shadows against quadrature in f64, and plates that come through
//! untouched.

use glam::{DVec3, Mat4, UVec2, Vec3, Vec4};
use glimt_render_gpu::cpu::CpuRenderer;
use glimt_render_gpu::gpu::{AdapterPreference, GpuOptions, GpuRenderer};
use glimt_render_gpu::kernels::layers::PixelLayers;
use glimt_render_gpu::prepare::env::{EnvMap, PreparedEnv};
use glimt_render_gpu::prepare::plate::{Plate, srgb_decode};
use glimt_render_gpu::prepare::render::{
    Background, Filter, FrameImage, RenderError, RenderSettings, Renderer, SettingsError, Shadow,
    Tonemap,
};
use glimt_render_gpu::prepare::scene::{Camera, SceneDescription};
use glimt_render_gpu::prepare::scene_build::SceneBuffers;
use glimt_tests::analytic::{AnalyticMap, AnalyticScene};
use glimt_tests::gpu::adapter_or_skip;
use glimt_tests::quadrature::Integral;
use glimt_tests::stats::{Mean, sidak, z_test};
use rayon::prelude::*;

/// A box and a sphere over the ground.
fn objects(diffuse: f64, specular: f64, exponent: f64) -> AnalyticScene {
    AnalyticScene {
        cuboid: [DVec3::new(-0.3, 0.9, 0.4), DVec3::new(1.1, 2.0, 1.5)],
        centre: DVec3::new(0.5, -0.8, 1.1),
        radius: 0.9,
        diffuse: diffuse * DVec3::new(1.0, 0.8, 0.5),
        specular: specular * DVec3::new(0.9, 1.0, 0.8),
        exponent,
    }
}

/// As it is, with the ground as a catcher or not; the sphere has `2 rings²` faces.
fn describe(scene: &AnalyticScene, rings: u32, catcher: bool) -> SceneDescription {
    let mut description = scene.describe(rings);
    description.objects[0].catcher = catcher;
    description
}

fn build(description: &SceneDescription) -> SceneBuffers {
    SceneBuffers::build(description).unwrap()
}

fn camera() -> Camera {
    Camera {
        eye: Vec3::new(-5.0, 0.7, 3.6),
        target: Vec3::new(0.0, 0.25, 0.2),
        up: Vec3::Z,
        fov_x: 0.9,
    }
}

/// A sky that varies, with a lamp in one texel.
fn sky(lamp: f64) -> AnalyticMap {
    let size = [32, 16];
    let texel = |i: u32| {
        let (column, row) = (i % size[0], i / size[0]);
        let wave = 1.0 + 0.5 * (f64::from(column) * 0.7 + f64::from(row)).sin();
        match (column, row) {
            (22, 4) => DVec3::new(1.2, 1.0, 0.8) * lamp,
            _ => DVec3::new(0.9, 1.0, 1.2) * wave,
        }
    };
    let texels = (0..size[0] * size[1]).map(texel);
    // Every number as the renderer has it.
    let texels = texels.map(|t| t.as_vec3().as_dvec3()).collect();
    AnalyticMap { size, texels }
}

fn prepare(map: &AnalyticMap) -> PreparedEnv {
    let texels = map.texels.iter().map(|t| t.as_vec3().extend(1.0)).collect();
    let map = EnvMap::new(UVec2::from_array(map.size), texels);
    map.unwrap().prepare(0.0).unwrap()
}

/// A lamp alone: what is out of its shadow is lit by every sample.
fn lamp() -> PreparedEnv {
    let size = UVec2::new(32, 16);
    let texel = |i: u32| {
        let is_lamp = i == 4 * size.x + 22;
        Vec4::splat(if is_lamp { 50.0 } else { 0.0 })
    };
    let map = EnvMap::new(size, (0..size.x * size.y).map(texel).collect());
    map.unwrap().prepare(0.0).unwrap()
}

fn settings(size: UVec2) -> RenderSettings {
    RenderSettings {
        layers: true,
        ..RenderSettings::new(size, camera())
    }
}

/// Every 8-bit code in every channel, none beside its neighbours.
fn all_codes(size: UVec2) -> (Plate, Vec<[u8; 3]>) {
    let codes: Vec<[u8; 3]> = (0..size.x * size.y)
        .map(|i| [i * 37, i * 101 + 5, i * 59 + 9].map(|code| (code % 256) as u8))
        .collect();
    (Plate::from_srgb8(size, &codes).unwrap(), codes)
}

/// The processors that are there.
fn renderers(test: &str) -> Vec<Box<dyn Renderer>> {
    let mut list: Vec<Box<dyn Renderer>> = vec![Box::new(CpuRenderer::default())];
    if adapter_or_skip(test).is_some() {
        let small = GpuOptions {
            max_elements: 1000,
            ..GpuOptions::default()
        };
        // The largest buffer of a scene has 335,424 bytes: tiles of some hundred pixels.
        let narrow = GpuOptions {
            max_binding_bytes: 340_000,
            ..GpuOptions::default()
        };
        for options in [GpuOptions::default(), small, narrow] {
            let gpu = GpuRenderer::with_options(AdapterPreference::Fastest, options);
            list.push(Box::new(gpu.unwrap()));
        }
    }
    list
}

fn render(
    renderer: &mut dyn Renderer,
    scene: &SceneBuffers,
    env: &PreparedEnv,
    plate: Option<&Plate>,
    settings: &RenderSettings,
) -> FrameImage {
    renderer
        .render_over(scene, env, plate, settings, &|_| ())
        .unwrap()
}

fn cpu(
    scene: &SceneBuffers,
    env: &PreparedEnv,
    plate: Option<&Plate>,
    settings: &RenderSettings,
) -> FrameImage {
    render(&mut CpuRenderer::default(), scene, env, plate, settings)
}

fn layers(image: &FrameImage) -> &[PixelLayers] {
    image.layers.as_deref().unwrap()
}

mod against_quadrature {
    use super::*;

    const SIZE: UVec2 = UVec2::new(7, 5);
    const SCRAMBLINGS: u32 = 48;

    /// The direction of a pixel's centre, by the formula of the documentation, in f64.
    fn pixel_direction(x: u32, y: u32) -> DVec3 {
        let camera = camera();
        let dir = (camera.target - camera.eye).as_dvec3().normalize();
        let right = dir.cross(camera.up.as_dvec3()).normalize();
        let up = right.cross(dir);
        let t = (0.5 * f64::from(camera.fov_x)).tan();
        let (w, h) = (f64::from(SIZE.x), f64::from(SIZE.y));
        let across = 2.0 * (f64::from(x) + 0.5) / w - 1.0;
        let down = 2.0 * (f64::from(y) + 0.5) / h - 1.0;
        (dir + across * t * right - down * t * (h / w) * up).normalize()
    }

    fn channel(pixel: usize) -> usize {
        pixel % 3
    }

    /// The ground's radiance in each pixel that shows it, with the objects and without them.
    fn reference(scene: &AnalyticScene, map: &AnalyticMap) -> Vec<Option<[Integral; 2]>> {
        let away = DVec3::new(0.0, 0.0, -100.0);
        let bare = AnalyticScene {
            cuboid: scene.cuboid.map(|corner| corner + away),
            centre: scene.centre + away,
            ..*scene
        };
        let eye = camera().eye.as_dvec3();
        let pixels: Vec<usize> = (0..(SIZE.x * SIZE.y) as usize).collect();
        pixels
            .into_par_iter()
            .map(|pixel| {
                let d = pixel_direction(pixel as u32 % SIZE.x, pixel as u32 / SIZE.x);
                let (t, _) = scene.hit(eye, d)?;
                if (eye + t * d).z.abs() > 1e-9 {
                    return None;
                }
                let both = [scene, &bare].map(|scene| {
                    let integral = scene.reflected(eye, d, map, channel(pixel)).unwrap();
                    assert!(integral.error <= 5e-3 * integral.value, "{integral:?}");
                    integral
                });
                Some(both)
            })
            .collect()
    }

    /// Means of lit, lit + blocked in each pixel.
    fn means(scene: &SceneBuffers, env: &PreparedEnv) -> Vec<[Mean; 2]> {
        let images: Vec<FrameImage> = (0..SCRAMBLINGS)
            .map(|seed| {
                let settings = RenderSettings {
                    filter: Filter::Centre,
                    seed,
                    ..settings(SIZE)
                };
                cpu(scene, env, None, &settings)
            })
            .collect();
        (0..(SIZE.x * SIZE.y) as usize)
            .map(|pixel| {
                let mean = |f: fn(&PixelLayers) -> Vec3| {
                    let value = |i: &FrameImage| f64::from(f(&layers(i)[pixel])[channel(pixel)]);
                    Mean::of(images.iter().map(value))
                };
                [mean(|l| l.lit), mean(|l| l.lit + l.blocked)]
            })
            .collect()
    }

    /// How many values disagree, of how many.
    fn disagreements(means: &[[Mean; 2]], truth: &[Option<[Integral; 2]>]) -> (usize, usize) {
        let tests = 2 * truth.iter().flatten().count();
        let mut bad = 0;
        for (means, truth) in means.iter().zip(truth) {
            for (mean, truth) in means.iter().zip(truth.iter().flatten()) {
                let mean = Mean {
                    standard_error: mean.standard_error.hypot(truth.error),
                    ..*mean
                };
                bad += usize::from(z_test(mean, truth.value, sidak(0.01, tests)).is_err());
            }
        }
        (bad, tests)
    }

    #[test]
    fn shadows_are_the_integral() {
        for (diffuse, specular, exponent) in [(0.8, 0.0, 1.0), (0.3, 0.6, 50.0)] {
            let analytic = objects(diffuse, specular, exponent);
            let map = sky(200.0);
            let truth = reference(&analytic, &map);
            let scene = build(&describe(&analytic, 200, true));
            let means = means(&scene, &prepare(&map));
            let (bad, tests) = disagreements(&means, &truth);
            println!("{bad} of {tests} values disagree");
            assert!(tests >= 40, "{tests}");
            assert_eq!(bad, 0, "of {tests}");
            // Shadows there are, of all depths, and all of them are noticed.
            let depth = |t: &[Integral; 2]| t[0].value / t[1].value;
            let depths: Vec<f64> = truth.iter().flatten().map(depth).collect();
            assert!(depths.iter().any(|d| *d < 0.6) && depths.iter().any(|d| *d > 0.95));
            let swapped: Vec<_> = truth.iter().map(|t| t.map(|[a, b]| [b, a])).collect();
            assert!(disagreements(&means, &swapped).0 > 5);
        }
    }

    #[test]
    fn small_mistakes_are_noticed() {
        let analytic = objects(0.8, 0.0, 1.0);
        let map = sky(200.0);
        let means = means(&build(&describe(&analytic, 200, true)), &prepare(&map));
        let mut turned = map.clone();
        turned.texels.rotate_right(1);
        let smaller = AnalyticScene {
            radius: 0.75,
            ..analytic
        };
        let smaller = reference(&smaller, &map);
        assert!(disagreements(&means, &smaller).0 > 0);
        assert!(disagreements(&means, &reference(&analytic, &turned)).0 > 0);
        // A ground that is no catcher has no light to compare.
        let none = super::against_quadrature::means(
            &build(&describe(&analytic, 50, false)),
            &prepare(&map),
        );
        assert!(disagreements(&none, &smaller).0 > 10);
    }
}

/// Pixels that differ from the plate in any bit, of those that nothing touches; and how many these are.
fn touched(image: &FrameImage, plate: &Plate, codes: &[[u8; 3]]) -> (usize, usize) {
    let mut counts = (0, 0);
    for (i, layer) in layers(image).iter().enumerate() {
        if layer.object.w > 0.0 || layer.blocked != Vec3::ZERO {
            continue;
        }
        counts.1 += 1;
        let linear = plate.pixels()[i].linear.extend(1.0).to_array();
        let same = image.linear[i].to_array().map(f32::to_bits) == linear.map(f32::to_bits);
        let [r, g, b] = codes[i];
        counts.0 += usize::from(!same || image.display[i] != [r, g, b, 255]);
    }
    counts
}

#[test]
fn an_untouched_plate_keeps_every_bit() {
    let size = UVec2::new(61, 47);
    let (plate, codes) = all_codes(size);
    // The sRGB curve by the letter, for each code.
    for (pixel, code) in plate.pixels().iter().zip(&codes) {
        let linear = code.map(|c| srgb_decode(f64::from(c) / 255.0) as f32);
        assert_eq!(pixel.linear.to_array(), linear);
    }
    let scene = build(&describe(&objects(0.5, 0.3, 40.0), 30, true));
    for renderer in &mut renderers("an_untouched_plate_keeps_every_bit") {
        for (shadow, tonemap) in [
            (Shadow::Multiply, Tonemap::Srgb),
            (Shadow::Add, Tonemap::Reinhard),
        ] {
            let settings = RenderSettings {
                exposure_ev: 2.3,
                shadow,
                tonemap,
                ..settings(size)
            };
            let image = render(&mut **renderer, &scene, &lamp(), Some(&plate), &settings);
            let (wrong, untouched) = touched(&image, &plate, &codes);
            assert_eq!(wrong, 0, "{}: of {untouched}", renderer.name());
            assert!(untouched > image.linear.len() / 2, "{untouched}");
            let seen = |c: usize, code: u8| {
                let mut all = layers(&image).iter().zip(&codes);
                all.any(|(l, k)| l.is_plate() && k[c] == code)
            };
            assert!((0..3).all(|c| (0..=255).all(|code| seen(c, code))));
            // There is a shadow, and it changes the plate; a plate of other codes is noticed.
            let shadow = |l: &PixelLayers| l.object.w == 0.0 && l.blocked.min_element() > 0.0;
            assert!(layers(&image).iter().filter(|l| shadow(l)).count() > 20);
            let mut other = codes.clone();
            other[0][1] ^= 1;
            assert_eq!(touched(&image, &plate, &other).0, 1);
            let brighter: Vec<Vec3> = plate.pixels().iter().map(|p| p.linear * 1.01).collect();
            let brighter = Plate::from_linear(size, &brighter).unwrap();
            assert!(touched(&image, &brighter, &codes).0 > untouched / 2);
        }
    }
}

/// The composite once more, in f64, of layers and plate.
fn recomposed(image: &FrameImage, plate: &Plate, settings: &RenderSettings) -> Vec<[f64; 3]> {
    let exposure = f64::from(settings.exposure_ev).exp2();
    let channel = |l: &PixelLayers, p: f64, c: usize| {
        let (lit, blocked) = (f64::from(l.lit[c]), f64::from(l.blocked[c]));
        let (a, coverage) = (f64::from(l.object.w), f64::from(l.catcher));
        let object = f64::from(l.object[c]) * exposure;
        if settings.shadow == Shadow::Add {
            return (object + p * (1.0 - a) - blocked * exposure).max(0.0);
        }
        let without = lit + blocked;
        let ratio = if without > 0.0 { lit / without } else { 1.0 };
        let t = if a < 1.0 {
            (1.0 - a - coverage * (1.0 - ratio)) / (1.0 - a)
        } else {
            1.0
        };
        object + p * t * (1.0 - a)
    };
    let pixels = layers(image).iter().zip(plate.pixels());
    pixels
        .map(|(l, p)| [0, 1, 2].map(|c| channel(l, f64::from(p.linear[c]), c)))
        .collect()
}

fn largest_difference(image: &FrameImage, expected: &[[f64; 3]]) -> f64 {
    let values = image.linear.iter().zip(expected);
    let difference =
        values.flat_map(|(p, q)| [0, 1, 2].map(|c| (f64::from(p[c]) - q[c]).abs() / q[c].max(0.1)));
    difference.fold(0.0, f64::max)
}

#[test]
fn layers_add_up() {
    let size = UVec2::new(61, 47);
    let (plate, _) = all_codes(size);
    let scene = build(&describe(&objects(0.5, 0.3, 40.0), 30, true));
    let env = prepare(&sky(100.0));
    for renderer in &mut renderers("layers_add_up") {
        for shadow in [Shadow::Multiply, Shadow::Add] {
            let settings = RenderSettings {
                exposure_ev: -1.5,
                shadow,
                ..settings(size)
            };
            let image = render(&mut **renderer, &scene, &env, Some(&plate), &settings);
            for (l, pixel) in layers(&image).iter().zip(&image.linear) {
                assert!(l.object.w + l.catcher <= 1.0 + 1e-6, "{l:?}");
                let t = l.transmission();
                assert!(t.min_element() >= 0.0 && t.max_element() <= 1.0, "{t}");
                assert_eq!(pixel.w, 1.0);
            }
            let off = largest_difference(&image, &recomposed(&image, &plate, &settings));
            assert!(off <= 2e-6, "{}: {off}", renderer.name());
            let other = RenderSettings {
                exposure_ev: -1.4,
                ..settings
            };
            let off = largest_difference(&image, &recomposed(&image, &plate, &other));
            assert!(off > 1e-3, "a wrong exposure is noticed");
        }
    }
}

/// Frames of both processors, as in the tests of plain frames.
fn compare(cpu: &FrameImage, gpu: &FrameImage) -> Result<(), String> {
    let odd = |p: &[f32], q: &[f32]| {
        let differs = |(a, b): (&f32, &f32)| !((a - b).abs() <= 0.01 * a.abs().max(0.3));
        p.iter().zip(q).any(differs)
    };
    let floats = |l: &PixelLayers| {
        [
            l.object,
            l.lit.extend(l.catcher),
            l.blocked.extend(0.0),
            l.behind.extend(0.0),
        ]
        .map(|v| v.to_array())
    };
    let mut counts = [0; 3];
    for i in 0..cpu.linear.len() {
        let (a, b) = (&layers(cpu)[i], &layers(gpu)[i]);
        counts[0] += usize::from(odd(&cpu.linear[i].to_array(), &gpu.linear[i].to_array()));
        counts[1] += usize::from(odd(floats(a).as_flattened(), floats(b).as_flattened()));
        let off = |(a, b): (&u8, &u8)| a.abs_diff(*b) > 2;
        counts[2] += usize::from(cpu.display[i].iter().zip(&gpu.display[i]).any(off));
    }
    println!(
        "linear, layers, display: {counts:?} of {} differ",
        cpu.linear.len()
    );
    match counts.iter().all(|n| *n <= cpu.linear.len() / 200) {
        true => Ok(()),
        false => Err(format!("{counts:?} of {} differ", cpu.linear.len())),
    }
}

#[test]
fn both_processors_agree() {
    let Some(_) = adapter_or_skip("both_processors_agree") else {
        return;
    };
    let size = UVec2::new(97, 61);
    let (plate, _) = all_codes(size);
    let scene = build(&describe(&objects(0.5, 0.3, 40.0), 30, true));
    let env = prepare(&sky(100.0));
    let mut gpu = GpuRenderer::new(AdapterPreference::Fastest).unwrap();
    let base = settings(size);
    let transparent = RenderSettings {
        background: Background::Transparent,
        ..base
    };
    let add = RenderSettings {
        shadow: Shadow::Add,
        tonemap: Tonemap::Reinhard,
        exposure_ev: -2.0,
        ..base
    };
    let cases = [
        (Some(&plate), base),
        (Some(&plate), add),
        (None, base),
        (None, transparent),
    ];
    for (plate, settings) in cases {
        let right = cpu(&scene, &env, plate, &settings);
        compare(&right, &render(&mut gpu, &scene, &env, plate, &settings)).unwrap();
        let plain = build(&describe(&objects(0.5, 0.3, 40.0), 30, false));
        compare(&right, &render(&mut gpu, &plain, &env, plate, &settings)).unwrap_err();
    }
}

#[test]
fn tiles_change_no_bit_of_layers() {
    let size = UVec2::new(31, 17);
    let (plate, _) = all_codes(size);
    let scene = build(&describe(&objects(0.5, 0.3, 40.0), 10, true));
    let env = prepare(&sky(100.0));
    for plate in [Some(&plate), None] {
        let whole = cpu(&scene, &env, plate, &settings(size));
        let mut odd = CpuRenderer::with_tiles(7);
        let tiled = render(&mut odd, &scene, &env, plate, &settings(size));
        assert!(whole.linear == tiled.linear && whole.display == tiled.display);
        assert_eq!(layers(&whole), layers(&tiled));
        // Layers that are not kept are the same ones.
        let unkept = RenderSettings {
            layers: false,
            ..settings(size)
        };
        let unkept = render(&mut odd, &scene, &env, plate, &unkept);
        assert!(unkept.layers.is_none() && unkept.linear == whole.linear);
    }
}

/// Objects are lit as if no catcher were there; a floor that is none takes their light from below.
#[test]
fn a_catcher_blocks_no_light() {
    let size = UVec2::new(61, 47);
    let analytic = objects(0.5, 0.3, 40.0);
    let env = prepare(&sky(100.0));
    let catcher = describe(&analytic, 30, true);
    let floor = describe(&analytic, 30, false);
    let mut alone = catcher.clone();
    alone.objects.remove(0);
    let [catcher, floor, alone] =
        [catcher, floor, alone].map(|d| cpu(&build(&d), &env, None, &settings(size)));
    let whole = |i: &usize| {
        [&catcher, &alone]
            .iter()
            .all(|image| layers(image)[*i].object.w == 1.0)
    };
    let objects: Vec<usize> = (0..catcher.linear.len()).filter(whole).collect();
    assert!(objects.len() > 200, "{}", objects.len());
    let differing = |a: &FrameImage, b: &FrameImage| {
        let differs = |i: &&usize| layers(a)[**i].object != layers(b)[**i].object;
        objects.iter().filter(differs).count()
    };
    assert_eq!(differing(&catcher, &alone), 0);
    assert!(differing(&catcher, &floor) > objects.len() / 4);

    // Nor does one catcher for another: over a second ground that is higher, the first is not in its shadow.
    let mut two = describe(&analytic, 10, true);
    two.objects.truncate(1);
    two.objects.push(two.objects[0].clone());
    two.objects[1].transform = Mat4::from_translation(Vec3::new(44.0, 0.0, 2.0));
    let image = cpu(&build(&two), &env, None, &settings(size));
    assert!(layers(&image).iter().all(|l| l.blocked == Vec3::ZERO));
    two.objects[1].catcher = false;
    let image = cpu(&build(&two), &env, None, &settings(size));
    assert!(layers(&image).iter().any(|l| l.blocked != Vec3::ZERO));
}

/// What lies behind a catcher is hidden, and takes none of its light.
#[test]
fn a_catcher_hides_what_is_behind_it() {
    let size = UVec2::new(41, 31);
    let (plate, codes) = all_codes(size);
    let below = DVec3::new(0.0, 0.0, -4.0);
    let mut analytic = objects(0.5, 0.3, 40.0);
    analytic.cuboid = analytic.cuboid.map(|corner| corner + below);
    analytic.centre += below;
    let env = prepare(&sky(100.0));
    let hidden = build(&describe(&analytic, 30, true));
    for renderer in &mut renderers("a_catcher_hides_what_is_behind_it") {
        let image = render(
            &mut **renderer,
            &hidden,
            &env,
            Some(&plate),
            &settings(size),
        );
        let shows = |l: &&PixelLayers| l.object.w > 0.0;
        assert_eq!(layers(&image).iter().filter(shows).count(), 0);
        assert_eq!(touched(&image, &plate, &codes), (0, codes.len()));
        let mut open = describe(&analytic, 30, true);
        open.objects.remove(0);
        let image = render(
            &mut **renderer,
            &build(&open),
            &env,
            Some(&plate),
            &settings(size),
        );
        assert!(layers(&image).iter().filter(shows).count() > 20);
    }
}

/// Without catchers, layers are the plain frame; before the environment the light map is the plate.
#[test]
fn without_a_plate_the_background_is_behind() {
    let size = UVec2::new(41, 31);
    let analytic = objects(0.5, 0.3, 40.0);
    let env = prepare(&sky(100.0));
    let floor = build(&describe(&analytic, 30, false));
    let off = |a: &FrameImage, b: &FrameImage| {
        let values = a.linear.iter().zip(&b.linear);
        let off = values.map(|(p, q)| ((*p - *q).abs() / p.abs().max(Vec4::ONE)).max_element());
        off.fold(0.0, f32::max)
    };
    for background in [Background::Environment, Background::Transparent] {
        let layered = RenderSettings {
            background,
            ..settings(size)
        };
        let plain = RenderSettings {
            layers: false,
            ..layered
        };
        let [layered, plain] = [layered, plain].map(|s| cpu(&floor, &env, None, &s));
        assert!(off(&layered, &plain) <= 1e-5, "{}", off(&layered, &plain));
    }

    let catcher = build(&describe(&analytic, 30, true));
    let transparent = RenderSettings {
        background: Background::Transparent,
        ..settings(size)
    };
    let image = cpu(&catcher, &env, None, &transparent);
    let seen = cpu(&catcher, &env, None, &settings(size));
    let mut shadows = 0;
    for ((l, pixel), seen) in layers(&image).iter().zip(&image.linear).zip(&seen.linear) {
        let t = l.transmission();
        let lost = 1.0 - (0.2126 * t.x + 0.7152 * t.y + 0.0722 * t.z);
        let alpha = l.object.w + (1.0 - l.object.w) * lost;
        assert!((pixel.w - alpha).abs() <= 1e-5, "{pixel} {alpha}");
        assert_eq!(pixel.truncate(), l.object.truncate());
        shadows += usize::from(l.object.w == 0.0 && pixel.w > 0.1);
        assert_eq!(seen.w, 1.0);
    }
    assert!(shadows > 50, "{shadows}");
    // The environment shows through where the ground is, darker in the shadow.
    let (open, dark): (Vec<_>, Vec<_>) = layers(&seen)
        .iter()
        .zip(&seen.linear)
        .filter(|(l, _)| l.object.w == 0.0)
        .map(|(l, p)| (p.x / l.behind.x, l.transmission().x))
        .partition(|(_, t)| *t == 1.0);
    assert!(open.iter().all(|(ratio, _)| (ratio - 1.0).abs() < 1e-6));
    assert!(dark.iter().all(|(ratio, t)| (ratio - t).abs() < 1e-5));
    assert!(!dark.is_empty());
}

#[test]
fn a_plate_of_another_size_is_refused() {
    let size = UVec2::new(8, 6);
    let (plate, _) = all_codes(UVec2::new(6, 8));
    let scene = build(&describe(&objects(0.5, 0.3, 40.0), 10, true));
    for renderer in &mut renderers("a_plate_of_another_size_is_refused") {
        let result = renderer.render_over(&scene, &lamp(), Some(&plate), &settings(size), &|_| ());
        assert!(matches!(
            result,
            Err(RenderError::Settings(SettingsError::PlateSize))
        ));
    }
}

/// An exposure of any size makes no infinity of any radiance, and no NaN of two.
#[test]
fn huge_exposures_stay_finite() {
    let size = UVec2::new(20, 15);
    let (plate, _) = all_codes(size);
    let scene = build(&describe(&objects(0.5, 0.3, 40.0), 10, true));
    let env = prepare(&sky(1e12));
    for shadow in [Shadow::Multiply, Shadow::Add] {
        let settings = RenderSettings {
            exposure_ev: 100.0,
            shadow,
            ..settings(size)
        };
        let image = cpu(&scene, &env, Some(&plate), &settings);
        assert!(image.linear.iter().all(|p| p.is_finite()));
    }
}
