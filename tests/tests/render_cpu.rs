//! Host file: the CPU executor's images against quadrature in f64, and against themselves.

use glam::{DVec3, UVec2, Vec3, Vec4};
use glimt_render_gpu::cpu::CpuRenderer;
use glimt_render_gpu::methods::{Bis, CandidateSource, Method, Mis};
use glimt_render_gpu::prepare::env::{EnvMap, PreparedEnv};
use glimt_render_gpu::prepare::render::{
    Background, FrameImage, Pattern, RenderSettings, Renderer, Tonemap,
};
use glimt_render_gpu::prepare::scene::{
    Camera, Material, Mesh, Object, Reflection, SceneDescription,
};
use glimt_render_gpu::prepare::scene_build::SceneBuffers;
use glimt_tests::analytic::AnalyticScene;
use glimt_tests::quadrature::Integral;
use glimt_tests::unbiased::{
    Case, assert_unbiased, bis, camera, disagreements, map, means, mis, prepare, reference, render,
    scene, settings,
};

const SUN: f64 = 1e5;

fn under_a_sun() -> [Case; 4] {
    [
        mis("Owen-Sobol 1+1", [1, 1], Pattern::OwenSobol),
        mis("independent 1+1", [1, 1], Pattern::Independent),
        mis("stratified 2+3", [2, 3], Pattern::Stratified),
        Case {
            name: "Kronander 15+15",
            settings: RenderSettings {
                method: Mis {
                    brdf_samples: 15,
                    env_samples: 15,
                    compensation: false,
                }
                .into(),
                ..settings(1, Pattern::Independent)
            },
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
    // With compensation little is noise but the BRDF samples that hit the sun, two of all rays: too few for a standard error.
    // `--test compensation` judges this lobe under a lamp.
    let plain = under_a_sun().map(|case| match case.settings.method {
        Method::Mis(own) => Case {
            settings: RenderSettings {
                method: Mis {
                    compensation: false,
                    ..own
                }
                .into(),
                ..case.settings
            },
            ..case
        },
        _ => case,
    });
    assert_unbiased(&scene(0.1, 0.9, 500.0), SUN, &plain);
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

#[test]
fn picked_candidates_are_the_integral() {
    let cases = |candidates: [u32; 3], samples: [u32; 3]| {
        let settings = |i: usize, source| Bis {
            candidates: candidates[i],
            samples: samples[i],
            source,
        };
        [
            bis(
                "of the BRDF",
                4,
                settings(0, CandidateSource::Brdf),
                Pattern::OwenSobol,
            ),
            bis(
                "of the light",
                8,
                settings(1, CandidateSource::Environment),
                Pattern::Stratified,
            ),
            bis(
                "of both",
                4,
                settings(2, CandidateSource::Mixture),
                Pattern::Independent,
            ),
        ]
    };
    // Also where there are fewer candidates than picks, and one of each. A sun that outshines the sky a thousandfold would be
    // picked in its own shadow, too, and no number of repetitions would find the rest.
    for (material, cases) in [
        (scene(0.8, 0.0, 1.0), cases([16, 1, 2], [4, 1, 3])),
        (scene(0.3, 0.6, 50.0), cases([32, 9, 31], [1, 5, 2])),
        (scene(0.1, 0.9, 500.0), cases([8, 0, 31], [2, 0, 3])),
    ] {
        // The light alone finds a lobe of 3° too rarely to be judged.
        let judged: Vec<Case> = cases
            .into_iter()
            .filter(|case| case.settings.method.count() > 0)
            .collect();
        assert_unbiased(&material, 50.0, &judged);
    }
}

#[test]
fn the_papers_counts_of_candidates_are_the_integral() {
    let kronander = Bis {
        candidates: 400,
        samples: 20,
        source: CandidateSource::Brdf,
    };
    let case = bis("Kronander", 1, kronander, Pattern::Independent);
    assert_unbiased(&scene(0.3, 0.6, 50.0), 50.0, &[case]);
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
        let scene = one_triangle(Material::from(Reflection::BlinnPhong {
            diffuse: Vec3::splat(kd),
            specular: Vec3::splat(1.0 - kd),
            exponent,
        }));
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
    let largest = glimt_render_gpu::prepare::env::MAX_RADIANCE;
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
                    method: Mis {
                        brdf_samples,
                        env_samples,
                        ..Mis::default()
                    }
                    .into(),
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
    let scene = one_triangle(Material::from(Reflection::BlinnPhong {
        diffuse: Vec3::new(1.0, 0.25, 0.0),
        specular: Vec3::ZERO,
        exponent: 1.0,
    }));
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
