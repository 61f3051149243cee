//! Host file: frames by precomputed transfer on the GPU: the CPU's coefficients and pictures, without a stall.

use std::sync::Arc;
use std::time::Duration;

use glam::{Mat4, UVec2, Vec2, Vec3, Vec4};
use glimt_render_gpu::cpu::CpuDrawing;
use glimt_render_gpu::gpu::{GpuContext, GpuDrawing, GpuLight, GpuOptions};
use glimt_render_gpu::methods::Prt;
use glimt_render_gpu::prepare::env::{EnvMap, PreparedEnv};
use glimt_render_gpu::prepare::light_sh::LightSh;
use glimt_render_gpu::prepare::plate::Plate;
use glimt_render_gpu::prepare::render::{
    Background, Filter, FrameImage, RenderSettings, Renderer, Shadow, Tonemap,
};
use glimt_render_gpu::prepare::scene::{
    Camera, Material, Mesh, Object, Reflection, SceneDescription, Texture, Wrap,
};
use glimt_render_gpu::prepare::scene_build::SceneBuffers;
use glimt_render_gpu::prepare::transfer::{SurfaceVertex, Transfer};
use glimt_tests::gpu::adapter_or_skip;
use glimt_tests::light;
use glimt_tests::worst::largest_share;

/// A map like noise, turned.
fn noise(size: UVec2, seed: u32, degrees: f32) -> PreparedEnv {
    let map = EnvMap::new(size, light::noise(size, seed)).unwrap();
    map.without_tables(degrees).unwrap()
}

/// The largest difference of two lists, as a share of the largest coefficient; without end where one is no number.
fn difference(a: &[Vec4], b: &[Vec4]) -> f32 {
    largest_share(a.iter().zip(b).map(|(a, b)| (a.as_dvec4(), b.as_dvec4()))) as f32
}

fn coefficients(
    context: &GpuContext,
    light: &mut GpuLight,
    env: &PreparedEnv,
    bands: u32,
    settings: &Prt,
) -> Vec<Vec4> {
    light.upload(context, env).unwrap();
    light.project(context, bands, settings).unwrap();
    light.read(context).unwrap()
}

/// Coefficients of both processors agree to this share of the largest.
const TOLERANCE: f32 = 1e-5;

#[test]
fn coefficients_are_the_cpus() {
    let Some(context) = adapter_or_skip("coefficients_are_the_cpus") else {
        return;
    };
    let sizes = [
        UVec2::new(128, 64),
        UVec2::new(257, 131),
        UVec2::new(131, 67),
        UVec2::new(50, 25),
        UVec2::new(7, 3),
        UVec2::new(1, 5),
        UVec2::ONE,
    ];
    let mut light = GpuLight::new(&context, UVec2::new(640, 320)).unwrap();
    let mut worst = 0.0f32;
    for (i, size) in (0..).zip(sizes) {
        for bands in 1..=6 {
            for level in [0, 1, 3] {
                let settings = Prt {
                    level,
                    window: [0.0, 3.5][(bands % 2) as usize],
                    temporal: 0.4,
                    ..Prt::default()
                };
                light.forget();
                let mut cpu = LightSh::default();
                for frame in 0..3 {
                    let env = noise(size, 3 * i + frame, 50.0 * frame as f32 - 20.0);
                    let expected = cpu.project(&env, bands, &settings).unwrap();
                    let found = coefficients(&context, &mut light, &env, bands, &settings);
                    let off = difference(&found, &expected);
                    worst = worst.max(off);
                    assert!(
                        off < TOLERANCE,
                        "{size}, {bands} bands, level {level}, frame {frame}: {off:e}"
                    );
                }
            }
        }
    }
    println!("coefficients differ by {worst:e} of the largest at most");
    // What a wrong angle, window or share of the frame before would do.
    let env = noise(UVec2::new(131, 67), 1, 10.0);
    let right = Prt {
        window: 4.0,
        temporal: 0.4,
        ..Prt::default()
    };
    let expected = LightSh::default().project(&env, 4, &right).unwrap();
    let wrong = [
        (noise(UVec2::new(131, 67), 1, 10.1), right),
        (noise(UVec2::new(131, 67), 2, 10.0), right),
        (
            env.clone(),
            Prt {
                window: 4.01,
                ..right
            },
        ),
        (env.clone(), Prt { level: 1, ..right }),
    ];
    for (env, settings) in wrong {
        light.forget();
        let found = coefficients(&context, &mut light, &env, 4, &settings);
        assert!(difference(&found, &expected) > TOLERANCE);
    }
    let found = coefficients(&context, &mut light, &env, 4, &right);
    assert!(difference(&found, &expected) > TOLERANCE, "nothing is kept");

    let endless = Prt {
        temporal: f32::MAX,
        ..right
    };
    for (bands, settings, words) in [(7, right, "7 bands"), (4, endless, "temporal")] {
        let error = light.project(&context, bands, &settings).unwrap_err();
        assert!(error.to_string().contains(words), "{error}");
    }
}

#[test]
fn a_large_map_has_many_parts() {
    let Some(context) = adapter_or_skip("a_large_map_has_many_parts") else {
        return;
    };
    let env = noise(UVec2::new(1628, 814), 5, 15.0);
    let mut light = GpuLight::new(&context, UVec2::new(1628, 814)).unwrap();
    for level in [0, 2] {
        let settings = Prt {
            level,
            ..Prt::default()
        };
        let expected = LightSh::default().project(&env, 6, &settings).unwrap();
        let found = coefficients(&context, &mut light, &env, 6, &settings);
        let off = difference(&found, &expected);
        assert!(off < TOLERANCE, "level {level}: {off:e}");
    }
}

/// A ball of 40 × 20 faces that floats over a floor of 16 × 16, which may be a catcher, with a texture on the floor.
fn scene(catcher: bool, reflection: f32) -> SceneBuffers {
    let (columns, rows, cells) = (40u32, 20u32, 16u32);
    let grid = |columns: u32, rows: u32| {
        let mut faces = Vec::new();
        for j in 0..rows {
            for i in 0..columns {
                let (a, b) = (j * (columns + 1) + i, (j + 1) * (columns + 1) + i);
                faces.extend([[a, b, b + 1], [a, b + 1, a + 1]]);
            }
        }
        faces
    };
    let mut ball = Mesh {
        name: "ball".into(),
        indices: grid(columns, rows),
        materials: vec![0],
        ..Mesh::default()
    };
    for j in 0..=rows {
        for i in 0..=columns {
            let theta = std::f32::consts::PI * j as f32 / rows as f32;
            let phi = std::f32::consts::TAU * i as f32 / columns as f32;
            let normal = Vec3::new(
                theta.sin() * phi.cos(),
                theta.sin() * phi.sin(),
                theta.cos(),
            );
            ball.positions.push(normal + Vec3::Z * 1.2);
            ball.normals.push(normal);
        }
    }
    let mut floor = Mesh {
        name: "floor".into(),
        indices: grid(cells, cells),
        materials: vec![1],
        ..Mesh::default()
    };
    for j in 0..=cells {
        for i in 0..=cells {
            let uv = Vec2::new(i as f32, j as f32) / cells as f32;
            floor
                .positions
                .push(((uv - Vec2::splat(0.5)) * 8.0).extend(0.0));
            floor.uvs.push(uv * 3.0);
        }
    }
    let mut scene = SceneBuffers::build(&SceneDescription {
        meshes: vec![ball, floor],
        materials: vec![
            Material::from(Reflection::BlinnPhong {
                diffuse: Vec3::new(0.6, 0.4, 0.2),
                specular: Vec3::ZERO,
                exponent: 0.0,
            }),
            Material::from(Reflection::MetallicRoughness {
                base_color: Vec3::ONE,
                metallic: 0.0,
                roughness: 0.8,
                base_color_texture: Some(0.into()),
                metallic_roughness_texture: None,
                normal_texture: None,
                normal_scale: 1.0,
            }),
        ],
        textures: vec![Texture {
            size: UVec2::splat(4),
            texels: (0..16u8)
                .map(|i| [40 + 10 * i, 200 - 9 * i, 90, 255])
                .collect(),
            srgb: true,
            wrap: [Wrap::Repeat, Wrap::Mirror],
        }],
        objects: [(0, false), (1, catcher)]
            .map(|(mesh, catcher)| Object {
                mesh,
                transform: Mat4::IDENTITY,
                material: None,
                catcher,
            })
            .to_vec(),
    })
    .unwrap();
    let transfer = transfer(&scene.vertices().unwrap());
    scene
        .set_transfer(Arc::new(transfer), &[reflection])
        .unwrap();
    scene
}

/// That of convex surfaces, part of which is blocked on the floor under the ball.
fn transfer(vertices: &[SurfaceVertex]) -> Transfer {
    let (mut lit, mut blocked) = (Vec::new(), Vec::new());
    for vertex in vertices {
        let p = vertex.position;
        let shadow = if p.z == 0.0 && p.length() < 2.5 {
            0.6 * (-0.5 * p.length_squared()).exp()
        } else {
            0.0
        };
        let y = glimt_sh::basis(vertex.normal);
        for k in 0..16 {
            let whole = glimt_sh::cosine_lobe((k as f32).sqrt() as u32) * y[k];
            lit.push(whole * (1.0 - shadow));
            blocked.push(whole * shadow);
        }
    }
    Transfer {
        bands: 4,
        lit,
        blocked,
    }
}

/// A sky that brightens upward, with a broad sun.
fn sky() -> PreparedEnv {
    let size = UVec2::new(96, 48);
    let sun = Vec3::new(0.6, -0.48, 0.64);
    let texel = |i: u32| {
        let place = UVec2::new(i % size.x, i / size.x);
        let d = glimt_probe::latlong::texel_direction(place, size);
        let lobe = (10.0 * (d.dot(sun) - 1.0)).exp();
        Vec4::new(0.3 + 6.0 * lobe, 0.4 + 5.0 * lobe, 0.5 + 0.2 * d.z, 1.0)
    };
    let texels = (0..size.x * size.y).map(texel).collect();
    EnvMap::new(size, texels)
        .unwrap()
        .without_tables(25.0)
        .unwrap()
}

fn settings() -> RenderSettings {
    let camera = Camera {
        eye: Vec3::new(6.0, 1.0, 3.0),
        target: Vec3::new(0.0, 0.0, 0.8),
        up: Vec3::Z,
        fov_x: 0.8,
    };
    RenderSettings {
        rays_per_pixel: 1,
        filter: Filter::Centre,
        exposure_ev: -1.0,
        prt: Prt {
            level: 1,
            window: 5.0,
            temporal: 0.3,
            ..Prt::default()
        },
        layers: true,
        ..RenderSettings::new(UVec2::new(131, 97), camera)
    }
}

fn plate(size: UVec2) -> Plate {
    let codes: Vec<[u8; 3]> = (0..size.x * size.y)
        .map(|i| [i * 7, i * 11, i * 13].map(|code| (40 + code % 200) as u8))
        .collect();
    Plate::from_srgb8(size, &codes).unwrap()
}

/// Pixels that are alike to what 16 bits resolve, with a share of `edges` that may not be.
fn compare(cpu: &FrameImage, gpu: &FrameImage, edges: f64) -> Result<f64, String> {
    let mean = cpu
        .linear
        .iter()
        .map(|v| v.truncate().element_sum())
        .sum::<f32>()
        / (3 * cpu.linear.len()) as f32;
    let alike = |a: &Vec4, b: &Vec4| {
        let off = (*a - *b).abs();
        let allowed = (a.abs() + Vec4::splat(mean)) * 1.5e-3;
        off.cmple(allowed).all()
    };
    let pairs = cpu.linear.iter().zip(&gpu.linear);
    let linear = pairs.filter(|(a, b)| !alike(a, b)).count();
    let pairs = cpu.display.iter().zip(&gpu.display);
    let display = pairs
        .filter(|(a, b)| a.iter().zip(b.iter()).any(|(a, b)| a.abs_diff(*b) > 1))
        .count();
    let share = linear.max(display) as f64 / cpu.linear.len() as f64;
    if share > edges {
        return Err(format!(
            "{linear} linear and {display} displayed pixels differ"
        ));
    }
    Ok(share)
}

fn both(
    gpu: &mut GpuDrawing,
    scene: &SceneBuffers,
    plate: Option<&Plate>,
    settings: &RenderSettings,
) -> [FrameImage; 2] {
    let cpu = CpuDrawing::default()
        .render_over(scene, &sky(), plate, settings, &|_| ())
        .unwrap();
    gpu.forget();
    let gpu = gpu
        .render_over(scene, &sky(), plate, settings, &|_| ())
        .unwrap();
    [cpu, gpu]
}

/// A renderer, where there is a GPU for one.
fn renderer(test: &str, options: GpuOptions) -> Option<GpuDrawing> {
    adapter_or_skip(test)?;
    Some(GpuDrawing::on(GpuContext::with_options(Default::default(), options).unwrap()).unwrap())
}

/// The share of pixels that edges may change: of a pixel that a triangle's edge passes, two processors may see either side.
const EDGES: f64 = 2e-3;

#[test]
fn pictures_are_the_cpus() {
    let Some(mut gpu) = renderer("pictures_are_the_cpus", GpuOptions::default()) else {
        return;
    };
    let plate = plate(settings().size);
    let add = RenderSettings {
        shadow: Shadow::Add,
        tonemap: Tonemap::Reinhard,
        ..settings()
    };
    let transparent = RenderSettings {
        background: Background::Transparent,
        layers: false,
        ..settings()
    };
    let unshadowed = RenderSettings {
        prt: Prt {
            shadows: false,
            ..settings().prt
        },
        ..settings()
    };
    let cases = [
        ("before the environment", false, 0.0, None, settings()),
        ("a transparent background", true, 0.0, None, transparent),
        ("a catcher, no plate", true, 0.0, None, settings()),
        ("over a plate", true, 0.0, Some(&plate), settings()),
        ("shadows added", true, 0.4, Some(&plate), add),
        ("no shadows", true, 0.0, Some(&plate), unshadowed),
        ("a reflection", false, 0.4, None, settings()),
    ];
    for (name, catcher, reflection, plate, settings) in cases {
        let scene = scene(catcher, reflection);
        let [cpu, found] = both(&mut gpu, &scene, plate, &settings);
        let share = compare(&cpu, &found, EDGES).unwrap_or_else(|e| panic!("{name}: {e}"));
        println!("{name}: {share:.5} of the pixels differ");
        assert_eq!(found.layers.is_some(), settings.layers, "{name}");
        if let (Some(cpu), Some(found)) = (&cpu.layers, &found.layers) {
            let pairs = cpu.iter().zip(found);
            let unlike = pairs.filter(|(a, b)| {
                let off = |a: Vec3, b: Vec3| (a - b).abs().max_element() > 2e-3;
                a.object.w != b.object.w
                    || a.catcher != b.catcher
                    || off(a.lit, b.lit)
                    || off(a.blocked, b.blocked)
                    || off(a.behind, b.behind)
            });
            let share = unlike.count() as f64 / cpu.len() as f64;
            assert!(share < EDGES, "{name}: {share} of the layers differ");
        }
        // Another light, another pose of the camera, another transfer: each is another picture.
        let wrong = RenderSettings {
            exposure_ev: settings.exposure_ev + 0.2,
            ..settings
        };
        let moved = RenderSettings {
            camera: Camera {
                eye: settings.camera.eye + Vec3::Y * 0.03,
                ..settings.camera
            },
            ..settings
        };
        for wrong in [wrong, moved] {
            let [_, found] = both(&mut gpu, &scene, plate, &wrong);
            assert!(compare(&cpu, &found, EDGES).is_err(), "{name}");
        }
    }
}

/// A sky with a disc of one brightness, which is sharp.
fn sky_with_disc(radiance: f32, disc: f32) -> PreparedEnv {
    let size = UVec2::new(96, 48);
    let sun = Vec3::new(0.8, 0.0, 0.6);
    let texel = |i: u32| {
        let place = UVec2::new(i % size.x, i / size.x);
        let d = glimt_probe::latlong::texel_direction(place, size);
        let is_sun = d.dot(sun) > 0.97;
        (Vec3::new(1.0, 0.9, 0.8) * if is_sun { disc } else { radiance }).extend(1.0)
    };
    let texels = (0..size.x * size.y).map(texel).collect();
    EnvMap::new(size, texels)
        .unwrap()
        .without_tables(0.0)
        .unwrap()
}

#[test]
fn no_exposure_takes_light_from_the_linear_image() {
    let test = "no_exposure_takes_light_from_the_linear_image";
    let Some(mut gpu) = renderer(test, GpuOptions::default()) else {
        return;
    };
    let plate = plate(settings().size);
    let cases = [
        // Light, a disc in it, c_k, a catcher, the exposure.
        (1.0, 1.0, 0.0, false, -30.0),
        (100.0, 100.0, 0.0, false, 10.0),
        (1e-6, 1e-6, 0.0, false, 0.0),
        (1e9, 1e9, 0.3, false, 20.0),
        (1.0, 1e6, 0.5, false, 0.0),
        (1.0, 1.0, 0.0, true, 30.0),
        (1.0, 1.0, 0.0, true, -30.0),
        (1.0, 1.0, 0.0, true, 100.0),
    ];
    for (radiance, disc, reflection, catcher, exposure_ev) in cases {
        let settings = RenderSettings {
            exposure_ev,
            prt: Prt::default(),
            ..settings()
        };
        let env = sky_with_disc(radiance, disc);
        let scene = scene(catcher, reflection);
        for plate in [None, catcher.then_some(&plate)] {
            gpu.forget();
            let [cpu, found] =
                [&mut CpuDrawing::default() as &mut dyn Renderer, &mut gpu].map(|r| {
                    r.render_over(&scene, &env, plate, &settings, &|_| ())
                        .unwrap()
                });
            let what = format!("{radiance} {disc} {reflection} {catcher} {exposure_ev}");
            // Pixels at the mirrored disc's edge are of either side.
            compare(&cpu, &found, 2.0 * EDGES).unwrap_or_else(|e| panic!("{what}: {e}"));
            let share = |image: &FrameImage| -> Vec<Vec3> {
                let layers = image.layers.as_ref().unwrap();
                layers.iter().map(|l| l.transmission()).collect()
            };
            let (a, b) = (share(&cpu), share(&found));
            let off = a
                .iter()
                .zip(&b)
                .filter(|(a, b)| !((**a - **b).abs().max_element() < 2e-3));
            assert!(
                (off.count() as f64) < 2.0 * EDGES * a.len() as f64,
                "{what}"
            );
        }
    }
}

#[test]
fn four_samples_are_close_to_many_rays() {
    let Some(mut gpu) = renderer("four_samples_are_close_to_many_rays", GpuOptions::default())
    else {
        return;
    };
    let scene = scene(true, 0.0);
    let settings = RenderSettings {
        rays_per_pixel: 64,
        filter: Filter::Box,
        ..settings()
    };
    let plate = plate(settings.size);
    let [cpu, found] = both(&mut gpu, &scene, Some(&plate), &settings);
    let alphas = |image: &FrameImage| -> Vec<f32> {
        let layers = image.layers.as_ref().unwrap();
        layers
            .iter()
            .flat_map(|l| [l.object.w, l.catcher])
            .collect()
    };
    let (a, b) = (alphas(&cpu), alphas(&found));
    let partly = b.iter().filter(|a| **a > 0.0 && **a < 1.0).count();
    assert!(partly > 200, "{partly} values of coverage between");
    assert!(b.iter().all(|a| *a * 4.0 == (*a * 4.0).round()), "quarters");
    let pairs = || a.iter().zip(&b).map(|(a, b)| (a - b).abs());
    let (worst, mean) = (
        pairs().fold(0.0, f32::max),
        pairs().sum::<f32>() / a.len() as f32,
    );
    println!("coverage differs by {worst} at most, {mean} on average");
    assert!(worst < 0.4 && mean < 0.004, "{worst} {mean}");
    let one = RenderSettings {
        rays_per_pixel: 1,
        ..settings
    };
    let [_, single] = both(&mut gpu, &scene, Some(&plate), &one);
    let rough = a.iter().zip(alphas(&single)).map(|(a, b)| (a - b).abs());
    assert!(rough.fold(0.0, f32::max) > 0.5, "one sample is worse");
}

#[test]
fn faces_around_the_eye_are_clipped() {
    let Some(mut gpu) = renderer("faces_around_the_eye_are_clipped", GpuOptions::default()) else {
        return;
    };
    let scene = scene(false, 0.2);
    for (eye, target) in [
        // Inside the ball; close above the floor, which reaches behind the eye; on its edge.
        (Vec3::new(0.1, 0.2, 1.1), Vec3::new(3.0, 1.0, 0.5)),
        (Vec3::new(2.0, -1.0, 0.01), Vec3::new(0.0, 0.0, 0.3)),
        (Vec3::new(4.0, 4.0, 0.5), Vec3::new(-4.0, -3.0, 0.0)),
    ] {
        let settings = RenderSettings {
            camera: Camera {
                eye,
                target,
                up: Vec3::Z,
                fov_x: 1.6,
            },
            ..settings()
        };
        let [cpu, found] = both(&mut gpu, &scene, None, &settings);
        let share = compare(&cpu, &found, 2.0 * EDGES).unwrap_or_else(|e| panic!("{eye}: {e}"));
        println!("{eye}: {share:.5} of the pixels differ");
    }
}

#[test]
fn a_floor_that_reaches_far_cuts_nothing_near() {
    let test = "a_floor_that_reaches_far_cuts_nothing_near";
    let Some(mut gpu) = renderer(test, GpuOptions::default()) else {
        return;
    };
    let square = |corner: Vec3, u: Vec3, v: Vec3| Mesh {
        positions: vec![corner, corner + u, corner + u + v, corner + v],
        indices: vec![[0, 1, 2], [0, 2, 3]],
        materials: vec![0],
        ..Mesh::default()
    };
    let far = 1e5;
    let meshes = vec![
        square(
            Vec3::new(-far, -far, 0.0),
            Vec3::X * 2.0 * far,
            Vec3::Y * 2.0 * far,
        ),
        // Between the eye and what it looks at.
        square(Vec3::new(5.5, 0.85, 2.77), Vec3::Y * 0.14, Vec3::Z * 0.1),
    ];
    let mut scene = SceneBuffers::build(&SceneDescription {
        objects: (0..2)
            .map(|mesh| Object {
                mesh,
                transform: Mat4::IDENTITY,
                material: None,
                catcher: false,
            })
            .collect(),
        meshes,
        materials: vec![Material::from(Reflection::BlinnPhong {
            diffuse: Vec3::splat(0.5),
            specular: Vec3::ZERO,
            exponent: 0.0,
        })],
        textures: Vec::new(),
    })
    .unwrap();
    let transfer = transfer(&scene.vertices().unwrap());
    scene.set_transfer(Arc::new(transfer), &[]).unwrap();
    let [cpu, found] = both(&mut gpu, &scene, None, &settings());
    compare(&cpu, &found, 2.0 * EDGES).unwrap();
    // The square is in the picture, before the floor.
    let blue = |y: usize| cpu.linear[y * 131 + 65].z;
    assert!(blue(48) < 0.9 * blue(10), "{} {}", blue(48), blue(10));
}

#[test]
fn nothing_is_waited_for() {
    let Some(mut gpu) = renderer("nothing_is_waited_for", GpuOptions::default()) else {
        return;
    };
    let scene = scene(true, 0.3);
    let plate = plate(settings().size);
    let context = Arc::clone(gpu.context());
    let before = context.waits();
    for frame in 0..3 {
        let settings = RenderSettings {
            frame,
            ..settings()
        };
        gpu.draw_over(&scene, &sky(), Some(&plate), &settings)
            .unwrap();
    }
    assert_eq!(context.waits(), before, "from the upload to the composite");
    // What counts does count.
    let read = gpu.render_over(&scene, &sky(), Some(&plate), &settings(), &|_| ());
    assert!(context.waits() > before);
    let phases = gpu.phases();
    let names: Vec<_> = phases.iter().map(|(name, _)| *name).collect();
    assert_eq!(names, ["upload", "light", "draw", "read back"]);
    // Three frames under the same light and one more: the filter over time has seen all of them.
    let mut cpu = CpuDrawing::default();
    for _ in 0..3 {
        cpu.render_over(&scene, &sky(), Some(&plate), &settings(), &|_| ())
            .unwrap();
    }
    let cpu = cpu.render_over(&scene, &sky(), Some(&plate), &settings(), &|_| ());
    compare(&cpu.unwrap(), &read.unwrap(), EDGES).unwrap();
}

#[test]
fn a_frame_that_was_given_up_spoils_no_other() {
    let hasty = GpuOptions {
        time_out: Duration::from_millis(40),
        ..GpuOptions::default()
    };
    let Some(mut gpu) = renderer("a_frame_that_was_given_up_spoils_no_other", hasty) else {
        return;
    };
    let scene = scene(true, 0.3);
    let of_size = |size: UVec2| RenderSettings {
        size,
        rays_per_pixel: 4,
        filter: Filter::Box,
        ..settings()
    };
    let mut draw = |size| {
        let image = gpu.render_over(&scene, &sky(), None, &of_size(size), &|_| ());
        while gpu.context().finish().is_err() {}
        image.map(drop).map_err(|error| error.to_string())
    };
    // A fast GPU gives none up.
    let Err(error) = draw(UVec2::new(1600, 1200)) else {
        return;
    };
    assert!(error.contains("within 0.04 s"), "{error}");
    // A small frame is in time, if not the first; none fails for any other reason.
    for _ in 0..100 {
        match draw(UVec2::new(8, 6)) {
            Ok(()) => return,
            Err(error) => assert!(error.contains("within 0.04 s"), "{error}"),
        }
    }
    panic!("no frame was in time any more");
}

#[test]
fn bands_of_rows_change_no_bit() {
    let small = |kilobytes: u64| GpuOptions {
        max_binding_bytes: kilobytes << 10,
        ..GpuOptions::default()
    };
    let test = "bands_of_rows_change_no_bit";
    let (Some(mut whole), Some(mut bands), Some(mut odd)) = (
        renderer(test, GpuOptions::default()),
        renderer(test, small(256)),
        renderer(test, small(600)),
    ) else {
        return;
    };
    let scene = scene(true, 0.0);
    let even = UVec2::new(192, 160);
    // Of a width that shares no factor with what bands begin at multiples of.
    let cases = [(even, false), (even, true), (UVec2::new(131, 97), true)];
    for (size, layers) in cases {
        let bands = match size == even {
            true => &mut bands,
            false => &mut odd,
        };
        let settings = RenderSettings {
            size,
            layers,
            ..settings()
        };
        let plate = plate(settings.size);
        let [_, a] = both(&mut whole, &scene, Some(&plate), &settings);
        let [_, b] = both(bands, &scene, Some(&plate), &settings);
        assert_eq!(a.linear, b.linear);
        assert_eq!(a.display, b.display);
        assert_eq!(a.layers, b.layers);
    }
    // A map that no binding holds is an error that says so.
    let env = noise(UVec2::new(256, 128), 0, 0.0);
    let error = bands
        .render_over(&scene, &env, None, &settings(), &|_| ())
        .unwrap_err();
    assert!(error.to_string().contains("the light map"), "{error}");
}

#[test]
fn other_sizes_and_scenes_follow_each_other() {
    let Some(mut gpu) = renderer(
        "other_sizes_and_scenes_follow_each_other",
        GpuOptions::default(),
    ) else {
        return;
    };
    let (floor, catcher) = (scene(false, 0.5), scene(true, 0.0));
    for (scene, size) in [(&floor, [64, 40]), (&catcher, [33, 50]), (&floor, [64, 40])] {
        let settings = RenderSettings {
            size: UVec2::from(size),
            ..settings()
        };
        let [cpu, found] = both(&mut gpu, scene, None, &settings);
        compare(&cpu, &found, 4.0 * EDGES).unwrap();
    }
    let mut moved = scene(true, 0.0);
    let by = Mat4::from_translation(Vec3::X);
    moved.pose(&[by, Mat4::IDENTITY]).unwrap();
    let error = gpu
        .render_over(&moved, &sky(), None, &settings(), &|_| ())
        .unwrap_err();
    assert!(
        error.to_string().contains("no precomputed transfer"),
        "{error}"
    );
}
