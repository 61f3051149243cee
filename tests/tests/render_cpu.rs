//! Host file: the CPU executor's images against quadrature in f64, and against themselves.

use glam::{DVec3, UVec2, Vec3, Vec4};
use glimt_render_gpu::cpu::CpuRenderer;
use glimt_render_gpu::host::env::{EnvMap, PreparedEnv};
use glimt_render_gpu::host::render::{
    Background, Filter, FrameImage, Pattern, RenderSettings, Renderer, Tonemap,
};
use glimt_render_gpu::host::scene::{Camera, Material, Mesh, Object, SceneDescription};
use glimt_render_gpu::host::scene_build::SceneBuffers;
use glimt_tests::analytic::{AnalyticMap, AnalyticScene};
use glimt_tests::quadrature::Integral;
use glimt_tests::stats::{Evidence, Mean, sidak, z_test};
use rayon::prelude::*;

const SIZE: UVec2 = UVec2::new(8, 5);
const SCRAMBLINGS: u32 = 256;

fn scene(diffuse: f64, specular: f64, exponent: f64) -> AnalyticScene {
    AnalyticScene {
        cuboid: [DVec3::new(-0.3, 0.9, 0.4), DVec3::new(1.1, 2.0, 1.5)],
        centre: DVec3::new(0.5, -0.8, 1.1),
        radius: 0.9,
        diffuse: diffuse * DVec3::new(1.0, 0.8, 0.5),
        specular: specular * DVec3::new(0.9, 1.0, 0.8),
        exponent,
    }
}

fn camera() -> Camera {
    Camera {
        eye: Vec3::new(-5.0, 0.7, 2.6),
        target: Vec3::new(0.5, 0.25, 0.6),
        up: Vec3::Z,
        fov_x: 0.7,
    }
}

/// A sky that varies, half black below, with a sun of `sun` times its radiance in one texel.
fn map(sun: f64) -> AnalyticMap {
    let size = [32, 16];
    let mut texels = Vec::new();
    for row in 0..size[1] {
        for column in 0..size[0] {
            let wave = 1.0 + 0.5 * (f64::from(column) * 0.7 + f64::from(row)).sin();
            let below = row >= 10 && column % 3 == 0;
            texels.push(if below {
                DVec3::ZERO
            } else {
                DVec3::new(0.9, 1.0, 1.2) * wave
            });
        }
    }
    texels[(4 * size[0] + 22) as usize] = DVec3::new(1.2, 1.0, 0.8) * sun;
    // Every number as the renderer has it.
    let texels = texels.into_iter().map(|t| t.as_vec3().as_dvec3()).collect();
    AnalyticMap { size, texels }
}

fn prepare(map: &AnalyticMap) -> PreparedEnv {
    let texels = map.texels.iter().map(|t| t.as_vec3().extend(1.0)).collect();
    EnvMap::new(UVec2::from_array(map.size), texels)
        .unwrap()
        .prepare(0.0)
        .unwrap()
}

fn render(scene: &SceneBuffers, env: &PreparedEnv, settings: &RenderSettings) -> FrameImage {
    CpuRenderer::default()
        .render_frame(scene, env, settings, &|_| ())
        .unwrap()
}

/// The direction of a pixel's centre, by the formula of the documentation, in f64.
fn pixel_direction(camera: &Camera, size: UVec2, x: u32, y: u32) -> DVec3 {
    let dir = (camera.target - camera.eye).as_dvec3().normalize();
    let right = dir.cross(camera.up.as_dvec3()).normalize();
    let up = right.cross(dir);
    let t = (0.5 * f64::from(camera.fov_x)).tan();
    let (w, h) = (f64::from(size.x), f64::from(size.y));
    let across = 2.0 * (f64::from(x) + 0.5) / w - 1.0;
    let down = 2.0 * (f64::from(y) + 0.5) / h - 1.0;
    (dir + across * t * right - down * t * (h / w) * up).normalize()
}

/// What each pixel's centre shows, one channel each in turn, by quadrature. `None` where the sphere is seen so flatly
/// that its facets matter.
fn reference(scene: &AnalyticScene, map: &AnalyticMap) -> Vec<Option<Integral>> {
    let camera = camera();
    (0..SIZE.x * SIZE.y)
        .into_par_iter()
        .map(|pixel| {
            let d = pixel_direction(&camera, SIZE, pixel % SIZE.x, pixel / SIZE.x);
            let eye = camera.eye.as_dvec3();
            let (_, n) = scene.hit(eye, d)?;
            if -n.dot(d) < 0.15 {
                return None;
            }
            let integral = scene.reflected(eye, d, map, channel(pixel))?;
            assert!(
                integral.error <= 5e-3 * integral.value,
                "pixel {pixel}: {integral:?}"
            );
            Some(integral)
        })
        .collect()
}

fn channel(pixel: u32) -> usize {
    (pixel % 3) as usize
}

struct Case {
    name: &'static str,
    rays: u32,
    samples: [u32; 2],
    pattern: Pattern,
}

/// Means over independent scramblings, pixel by pixel.
fn means(scene: &SceneBuffers, env: &PreparedEnv, case: &Case) -> Vec<Mean> {
    let images: Vec<FrameImage> = (0..SCRAMBLINGS)
        .map(|seed| {
            let settings = RenderSettings {
                rays_per_pixel: case.rays,
                brdf_samples: case.samples[0],
                env_samples: case.samples[1],
                pattern: case.pattern,
                filter: Filter::Centre,
                seed,
                ..RenderSettings::new(SIZE, camera())
            };
            render(scene, env, &settings)
        })
        .collect();
    (0..SIZE.x * SIZE.y)
        .map(|pixel| {
            let value =
                |image: &FrameImage| f64::from(image.linear[pixel as usize][channel(pixel)]);
            Mean::of(images.iter().map(value))
        })
        .collect()
}

/// Every pixel's mean against its reference; the pixels that disagree.
fn disagreements(
    means: &[Mean],
    reference: &[Option<Integral>],
    alpha: f64,
) -> Vec<(usize, Evidence)> {
    let pixels = reference.iter().flatten().count();
    assert!(pixels >= 30, "only {pixels} pixels have a reference");
    let judged = means.iter().zip(reference).enumerate();
    judged
        .filter_map(|(pixel, (mean, reference))| {
            let Integral { value, error } = (*reference)?;
            // What the quadrature may be off by counts as noise.
            let standard_error = mean.standard_error.hypot(error);
            let mean = Mean {
                standard_error,
                ..*mean
            };
            let verdict = z_test(mean, value, sidak(alpha, pixels));
            verdict.err().map(|evidence| (pixel, evidence))
        })
        .collect()
}

fn assert_unbiased(analytic: &AnalyticScene, sun: f64, cases: &[Case]) {
    let map = map(sun);
    let reference = reference(analytic, &map);
    let (scene, env) = (
        SceneBuffers::build(&analytic.describe(200)).unwrap(),
        prepare(&map),
    );
    for case in cases {
        let means = means(&scene, &env, case);
        let judged = means.iter().zip(&reference);
        let mut errors: Vec<f64> = judged
            .filter_map(|(mean, truth)| Some(100.0 * mean.standard_error / (*truth)?.value))
            .collect();
        errors.sort_by(f64::total_cmp);
        let (median, largest) = (errors[errors.len() / 2], errors[errors.len() - 1]);
        println!(
            "{}: standard errors {median:.2} %, up to {largest:.2} %",
            case.name
        );
        let bad = disagreements(&means, &reference, 0.01 / cases.len() as f64);
        assert!(bad.is_empty(), "{}: {}", case.name, bad[0].1);
    }
}

const SUN: f64 = 1e5;

const fn mis(name: &'static str, samples: [u32; 2], pattern: Pattern) -> Case {
    Case {
        name,
        rays: 16,
        samples,
        pattern,
    }
}

fn under_a_sun() -> [Case; 4] {
    [
        mis("Owen-Sobol 1+1", [1, 1], Pattern::OwenSobol),
        mis("independent 1+1", [1, 1], Pattern::Independent),
        mis("stratified 2+3", [2, 3], Pattern::Stratified),
        Case {
            rays: 1,
            ..mis("Kronander 15+15", [15, 15], Pattern::Independent)
        },
    ]
}

#[test]
fn diffuse_under_a_sun_is_the_integral() {
    assert_unbiased(&scene(0.8, 0.0, 1.0), SUN, &under_a_sun());
}

#[test]
fn glossy_under_a_sun_is_the_integral() {
    assert_unbiased(&scene(0.3, 0.6, 50.0), SUN, &under_a_sun());
}

#[test]
fn near_mirror_under_a_sun_is_the_integral() {
    assert_unbiased(&scene(0.1, 0.9, 500.0), SUN, &under_a_sun());
}

#[test]
fn either_strategy_alone_is_the_integral() {
    for (diffuse, specular, exponent) in [(0.8, 0.0, 1.0), (0.3, 0.6, 50.0)] {
        let cases = [
            mis("BRDF alone", [2, 0], Pattern::OwenSobol),
            mis("environment alone", [0, 2], Pattern::OwenSobol),
            mis("more of one", [1, 4], Pattern::OwenSobol),
        ];
        assert_unbiased(&scene(diffuse, specular, exponent), 50.0, &cases);
    }
}

/// The test above can fail: a scene that differs a little from the reference's is noticed.
#[test]
fn small_mistakes_are_noticed() {
    let truth = scene(0.3, 0.6, 50.0);
    let map = map(SUN);
    let mut turned = map.clone();
    turned.texels.rotate_right(1);
    let mut blue = map.clone();
    blue.texels
        .iter_mut()
        .for_each(|t| *t = DVec3::new(t.z, t.y, t.x));
    let wrong_scenes = [
        AnalyticScene {
            exponent: 60.0,
            ..truth
        },
        AnalyticScene {
            diffuse: truth.diffuse * 1.03,
            ..truth
        },
        AnalyticScene {
            radius: 0.8,
            ..truth
        },
    ];
    let (scene, env) = (
        SceneBuffers::build(&truth.describe(200)).unwrap(),
        prepare(&map),
    );
    let means = means(&scene, &env, &under_a_sun()[0]);
    let noticed =
        |reference: Vec<Option<Integral>>| !disagreements(&means, &reference, 0.01).is_empty();
    for wrong in wrong_scenes {
        assert!(noticed(reference(&wrong, &map)), "not noticed: {wrong:?}");
    }
    assert!(noticed(reference(&truth, &turned)));
    assert!(noticed(reference(&truth, &blue)));
}

fn white_sky() -> PreparedEnv {
    EnvMap::new(UVec2::new(16, 8), vec![Vec4::ONE; 128])
        .unwrap()
        .prepare(0.0)
        .unwrap()
}

/// One large triangle that fills the view.
fn one_triangle(material: Material) -> SceneBuffers {
    SceneBuffers::build(&SceneDescription {
        meshes: vec![Mesh {
            positions: vec![
                Vec3::new(-90.0, -90.0, 0.0),
                Vec3::new(90.0, -90.0, 0.0),
                Vec3::new(0.0, 90.0, 0.0),
            ],
            indices: vec![[0, 1, 2]],
            materials: vec![0],
            ..Mesh::default()
        }],
        materials: vec![material],
        objects: vec![Object {
            mesh: 0,
            transform: glam::Mat4::IDENTITY,
            material: None,
            catcher: false,
        }],
        ..SceneDescription::default()
    })
    .unwrap()
}

#[test]
fn a_white_furnace_gains_no_light() {
    let env = white_sky();
    for (kd, exponent) in [
        (1.0, 1.0),
        (0.5, 0.0),
        (0.2, 50.0),
        (0.0, 500.0),
        (0.0, 1e4),
    ] {
        let scene = one_triangle(Material::BlinnPhong {
            diffuse: Vec3::splat(kd),
            specular: Vec3::splat(1.0 - kd),
            exponent,
        });
        for (height, cos) in [(4.0, 1.0), (2.0, 0.5)] {
            let x = -(16.0f32 - height * height).sqrt();
            let eye = Vec3::new(x, 0.0, height);
            let camera = Camera {
                eye,
                target: Vec3::ZERO,
                up: Vec3::Y,
                fov_x: 0.01,
            };
            let settings = RenderSettings {
                rays_per_pixel: 4096,
                ..RenderSettings::new(UVec2::ONE, camera)
            };
            let value = render(&scene, &env, &settings).linear[0].x;
            assert!(value <= 1.005, "kd {kd}, e {exponent}, cos {cos}: {value}");
            // At normal incidence, and at any where the lobe is flat, nothing is lost either.
            if cos == 1.0 || kd == 1.0 || exponent == 0.0 {
                assert!(value >= 0.995, "kd {kd}, e {exponent}, cos {cos}: {value}");
            }
        }
    }
}

#[test]
fn tiles_and_threads_change_no_bit() {
    let analytic = scene(0.3, 0.6, 50.0);
    let (scene, env) = (
        SceneBuffers::build(&analytic.describe(24)).unwrap(),
        prepare(&map(SUN)),
    );
    let settings = RenderSettings {
        rays_per_pixel: 3,
        ..RenderSettings::new(UVec2::new(37, 23), camera())
    };
    let whole = render(&scene, &env, &settings);
    for tile_pixels in [1, 7, 64, 100_000] {
        let tiled = CpuRenderer::with_tiles(tile_pixels)
            .render_frame(&scene, &env, &settings, &|_| ())
            .unwrap();
        assert!(tiled.linear == whole.linear && tiled.display == whole.display);
    }
    let one_thread = rayon::ThreadPoolBuilder::new()
        .num_threads(1)
        .build()
        .unwrap();
    assert!(
        one_thread
            .install(|| render(&scene, &env, &settings))
            .linear
            == whole.linear
    );
    // The comparison can fail.
    let other = RenderSettings {
        seed: 2,
        ..settings
    };
    assert!(render(&scene, &env, &other).linear != whole.linear);
}

#[test]
fn progress_ends_at_one() {
    let analytic = scene(0.5, 0.0, 1.0);
    let (scene, env) = (
        SceneBuffers::build(&analytic.describe(8)).unwrap(),
        white_sky(),
    );
    let most = std::sync::Mutex::new(0.0f32);
    let settings = RenderSettings::new(UVec2::new(40, 30), camera());
    let told = |part: f32| {
        let mut most = most.lock().unwrap();
        *most = most.max(part);
    };
    CpuRenderer::default()
        .render_frame(&scene, &env, &settings, &told)
        .unwrap();
    assert_eq!(*most.lock().unwrap(), 1.0);
}

#[test]
fn extreme_light_makes_no_nan() {
    let analytic = scene(0.3, 0.6, 500.0);
    let scene = SceneBuffers::build(&analytic.describe(24)).unwrap();
    let settings = RenderSettings {
        rays_per_pixel: 8,
        ..RenderSettings::new(UVec2::new(24, 16), camera())
    };
    let largest = glimt_render_gpu::host::env::MAX_RADIANCE;
    for (size, texels) in [
        (UVec2::ONE, vec![Vec4::ZERO]),
        (UVec2::ONE, vec![Vec4::splat(largest)]),
        (UVec2::new(2, 1), vec![Vec4::splat(largest), Vec4::ZERO]),
        (
            UVec2::new(2, 2),
            vec![
                Vec4::splat(1e-38),
                Vec4::splat(largest),
                Vec4::splat(1e-45),
                Vec4::ONE,
            ],
        ),
    ] {
        let black = texels.iter().all(|t| *t == Vec4::ZERO);
        let env = EnvMap::new(size, texels).unwrap().prepare(30.0).unwrap();
        for pattern in [
            Pattern::OwenSobol,
            Pattern::Independent,
            Pattern::Stratified,
        ] {
            for (brdf_samples, env_samples) in [(1, 1), (1, 0), (0, 1)] {
                let settings = RenderSettings {
                    pattern,
                    brdf_samples,
                    env_samples,
                    ..settings
                };
                let image = render(&scene, &env, &settings);
                assert!(
                    image
                        .linear
                        .iter()
                        .all(|v| v.is_finite() && v.min_element() >= 0.0)
                );
                assert!(!black || image.linear.iter().all(|v| v.truncate() == Vec3::ZERO));
            }
        }
    }
}

#[test]
fn a_turned_map_is_a_map_with_its_columns_moved() {
    // A quarter turn counter-clockwise brings what was at +x to +y, the left.
    let map = map(100.0);
    let [w, h] = map.size;
    let mut moved = map.clone();
    for row in 0..h {
        for column in 0..w {
            let from = row * w + (column + w / 4) % w;
            moved.texels[(row * w + column) as usize] = map.texels[from as usize];
        }
    }
    let texels = map.texels.iter().map(|t| t.as_vec3().extend(1.0)).collect();
    let turned = EnvMap::new(UVec2::from_array(map.size), texels)
        .unwrap()
        .prepare(90.0)
        .unwrap();
    let scene = SceneBuffers::build(&scene(0.5, 0.3, 50.0).describe(64)).unwrap();
    let settings = RenderSettings {
        rays_per_pixel: 256,
        ..RenderSettings::new(UVec2::new(48, 32), camera())
    };
    let (a, b) = (
        render(&scene, &turned, &settings),
        render(&scene, &prepare(&moved), &settings),
    );
    let unturned = render(&scene, &prepare(&map), &settings);
    let distance = |a: &FrameImage, b: &FrameImage| -> f32 {
        let sum = |i: &FrameImage| i.linear.iter().map(|v| v.y).sum::<f32>();
        let differences = a
            .linear
            .iter()
            .zip(&b.linear)
            .map(|(a, b)| (a.y - b.y).abs());
        differences.sum::<f32>() / sum(b)
    };
    assert!(distance(&a, &b) < 0.02, "{}", distance(&a, &b));
    assert!(
        distance(&a, &unturned) > 0.05,
        "{}",
        distance(&a, &unturned)
    );
}

#[test]
fn display_and_alpha() {
    let scene = one_triangle(Material::BlinnPhong {
        diffuse: Vec3::new(1.0, 0.25, 0.0),
        specular: Vec3::ZERO,
        exponent: 1.0,
    });
    let down = Camera {
        eye: Vec3::new(0.0, -30.0, 5.0),
        target: Vec3::new(0.0, -30.0, 0.0),
        up: Vec3::Y,
        fov_x: 0.1,
    };
    let up = Camera {
        target: Vec3::new(0.0, -30.0, 9.0),
        ..down
    };
    let env = white_sky();
    let settings = RenderSettings {
        rays_per_pixel: 1024,
        background: Background::Transparent,
        exposure_ev: -1.0,
        ..RenderSettings::new(UVec2::ONE, down)
    };
    let seen = render(&scene, &env, &settings);
    // sRGB codes of 1/2 and 1/8.
    assert!(
        seen.display[0]
            .iter()
            .zip([188u8, 99, 0, 255])
            .all(|(a, b)| a.abs_diff(b) <= 1),
        "{:?}",
        seen.display[0]
    );
    let reinhard = render(
        &scene,
        &env,
        &RenderSettings {
            tonemap: Tonemap::Reinhard,
            ..settings
        },
    );
    // Of 1/3 and 1/9.
    assert!(
        reinhard.display[0]
            .iter()
            .zip([156u8, 94, 0, 255])
            .all(|(a, b)| a.abs_diff(b) <= 1)
    );
    let empty = render(
        &scene,
        &env,
        &RenderSettings {
            camera: up,
            ..settings
        },
    );
    assert_eq!((empty.linear[0], empty.display[0]), (Vec4::ZERO, [0; 4]));
    let sky = render(
        &scene,
        &env,
        &RenderSettings {
            camera: up,
            background: Background::Environment,
            ..settings
        },
    );
    assert_eq!(sky.linear[0], Vec4::ONE);
    assert_eq!(sky.display[0][3], 255);
}
