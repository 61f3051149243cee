//! Host file: frames by the GPU renderer: the CPU's, whatever the tiles; and what it cannot do.

use std::sync::Mutex;

use glam::{Mat4, UVec2, Vec2, Vec3, Vec4};
use glimt_render_gpu::cpu::CpuRenderer;
use glimt_render_gpu::gpu::{GpuEnv, GpuOptions, GpuRenderer};
use glimt_render_gpu::methods::{Cells, Mis, Product};
use glimt_render_gpu::prepare::env::{EnvMap, PreparedEnv};
use glimt_render_gpu::prepare::render::{
    Background, FrameImage, Pattern, RenderSettings, Renderer, Tonemap,
};
use glimt_render_gpu::prepare::scene::{
    Camera, Material, Mesh, Object, Reflection, SceneDescription, Texture, Wrap,
};
use glimt_render_gpu::prepare::scene_build::SceneBuffers;
use glimt_tests::gpu::adapter_or_skip;

/// A texture-mapped plane, and a glossy ball of 40 × 20 faces on it.
fn scene() -> SceneBuffers {
    let (columns, rows) = (40u32, 20u32);
    let mut ball = Mesh {
        name: "ball".into(),
        materials: vec![0],
        ..Mesh::default()
    };
    for j in 0..=rows {
        for i in 0..=columns {
            let (theta, phi) = (
                std::f32::consts::PI * j as f32 / rows as f32,
                std::f32::consts::TAU * i as f32 / columns as f32,
            );
            let normal = Vec3::new(
                theta.sin() * phi.cos(),
                theta.sin() * phi.sin(),
                theta.cos(),
            );
            ball.positions.push(normal + Vec3::Z);
            ball.normals.push(normal);
        }
    }
    for j in 0..rows {
        for i in 0..columns {
            let (a, b) = (j * (columns + 1) + i, (j + 1) * (columns + 1) + i);
            ball.indices.extend([[a, b, b + 1], [a, b + 1, a + 1]]);
        }
    }
    let plane = Mesh {
        name: "plane".into(),
        positions: [(-5.0, -5.0), (5.0, -5.0), (5.0, 5.0), (-5.0, 5.0)]
            .map(|(x, y)| Vec3::new(x, y, 0.0))
            .to_vec(),
        uvs: [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)]
            .map(|(u, v)| Vec2::new(u, v))
            .to_vec(),
        indices: vec![[0, 1, 2], [0, 2, 3]],
        materials: vec![1],
        ..Mesh::default()
    };
    let object = |mesh| Object {
        mesh,
        transform: Mat4::IDENTITY,
        material: None,
        catcher: false,
    };
    SceneBuffers::build(&SceneDescription {
        meshes: vec![ball, plane],
        materials: vec![
            Material::from(Reflection::BlinnPhong {
                diffuse: Vec3::new(0.4, 0.2, 0.1),
                specular: Vec3::splat(0.4),
                exponent: 60.0,
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
            size: UVec2::splat(2),
            texels: vec![
                [200, 200, 200, 255],
                [60, 80, 100, 255],
                [60, 80, 100, 255],
                [200, 200, 200, 255],
            ],
            srgb: true,
            wrap: [Wrap::Repeat, Wrap::Mirror],
        }],
        objects: vec![object(0), object(1)],
    })
    .unwrap()
}

/// A sky that brightens upward, with a sun 10⁴ times as bright.
fn sky(size: UVec2, rotate_z_deg: f32) -> PreparedEnv {
    let texel = |i: u32| {
        let (x, y) = (i % size.x, i / size.x);
        let height = 1.0 - y as f32 / size.y as f32;
        let sun = if x == size.x / 3 && y == size.y / 5 {
            1e4
        } else {
            0.0
        };
        Vec4::new(
            0.3 + sun,
            0.4 + 0.2 * height + sun,
            0.5 + 0.5 * height + 0.8 * sun,
            1.0,
        )
    };
    EnvMap::new(size, (0..size.x * size.y).map(texel).collect())
        .unwrap()
        .prepare(rotate_z_deg)
        .unwrap()
}

fn settings() -> RenderSettings {
    let camera = Camera {
        eye: Vec3::new(4.0, 1.0, 2.0),
        target: Vec3::new(0.0, 0.0, 0.8),
        up: Vec3::Z,
        fov_x: 0.7,
    };
    RenderSettings {
        rays_per_pixel: 4,
        exposure_ev: -1.0,
        ..RenderSettings::new(UVec2::new(97, 61), camera)
    }
}

fn frame(renderer: &mut dyn Renderer, env: &PreparedEnv, settings: &RenderSettings) -> FrameImage {
    renderer
        .render_frame(&scene(), env, settings, &|_| ())
        .unwrap()
}

/// A renderer, where there is a GPU for one.
fn gpu(test: &str, options: GpuOptions) -> Option<GpuRenderer> {
    adapter_or_skip(test)?;
    Some(GpuRenderer::with_options(Default::default(), options).unwrap())
}

/// Whether two images are of the same scene: pixels that differ by more than 1 % of their value or of the mean (rays
/// that hit the one face or its neighbour, picks between two lobes) are few, and the mean energy is the same.
fn compare(cpu: &FrameImage, gpu: &FrameImage) -> Result<(), String> {
    if cpu.size != gpu.size
        || cpu.linear.len() != gpu.linear.len()
        || cpu.display.len() != gpu.display.len()
    {
        return Err("the sizes differ".into());
    }
    let mean = |image: &FrameImage| {
        let sum: f64 = image
            .linear
            .iter()
            .map(|p| f64::from(p.x) + f64::from(p.y) + f64::from(p.z))
            .sum();
        sum / image.linear.len() as f64
    };
    let (a, b) = (mean(cpu), mean(gpu));
    if !((a - b).abs() <= 1e-3 * a) {
        return Err(format!("mean {a} and {b}"));
    }
    let differs = |(p, q): &(&Vec4, &Vec4)| {
        !((**p - **q).abs().max_element() <= 0.01 * p.max_element().max(a as f32 / 3.0))
    };
    let odd = cpu.linear.iter().zip(&gpu.linear).filter(differs).count();
    let off =
        |(p, q): &(&[u8; 4], &[u8; 4])| p.iter().zip(q.iter()).any(|(a, b)| a.abs_diff(*b) > 2);
    let odd_display = cpu.display.iter().zip(&gpu.display).filter(off).count();
    let bound = cpu.linear.len() / 500;
    println!(
        "{odd} and {odd_display} of {} pixels differ, mean {a} and {b}",
        cpu.linear.len()
    );
    if odd > bound || odd_display > bound {
        return Err(format!(
            "{odd} linear and {odd_display} display pixels differ, more than {bound}"
        ));
    }
    Ok(())
}

#[test]
fn frames_are_the_cpus() {
    let Some(mut gpu) = gpu("frames_are_the_cpus", GpuOptions::default()) else {
        return;
    };
    let base = settings();
    let variants = [
        base,
        RenderSettings {
            pattern: Pattern::Independent,
            method: Mis {
                brdf_samples: 3,
                env_samples: 2,
                ..Mis::default()
            }
            .into(),
            frame: 5,
            ..base
        },
        RenderSettings {
            pattern: Pattern::Stratified,
            method: Mis {
                brdf_samples: 4,
                env_samples: 4,
                compensation: false,
            }
            .into(),
            seed: 9,
            ..base
        },
        RenderSettings {
            method: Mis {
                brdf_samples: 0,
                ..Mis::default()
            }
            .into(),
            background: Background::Transparent,
            ..base
        },
        RenderSettings {
            method: Mis {
                env_samples: 0,
                ..Mis::default()
            }
            .into(),
            tonemap: Tonemap::Reinhard,
            ..base
        },
        RenderSettings {
            method: Product { rays: 6 }.into(),
            ..base
        },
        RenderSettings {
            method: Cells {
                rays: 6,
                ..Cells::default()
            }
            .into(),
            ..base
        },
    ];
    for (index, settings) in variants.iter().enumerate() {
        let env = sky(
            UVec2::new(64 + 16 * (index as u32 / 2), 32),
            40.0 * index as f32,
        );
        let cpu = frame(&mut CpuRenderer::default(), &env, settings);
        compare(&cpu, &frame(&mut gpu, &env, settings))
            .unwrap_or_else(|wrong| panic!("variant {index}: {wrong}"));
    }
}

#[test]
fn comparison_finds_a_wrong_frame() {
    let env = sky(UVec2::new(64, 32), 0.0);
    let right = frame(&mut CpuRenderer::default(), &env, &settings());
    compare(&right, &right).unwrap();
    let turned = frame(
        &mut CpuRenderer::default(),
        &sky(UVec2::new(64, 32), 10.0),
        &settings(),
    );
    compare(&right, &turned).unwrap_err();
    let mut wrong = right.clone();
    wrong.linear[7].x = f32::NAN;
    compare(&right, &wrong).unwrap_err();
    let mut wrong = right.clone();
    wrong.linear.iter_mut().for_each(|p| *p *= 1.002);
    compare(&right, &wrong).unwrap_err();
    let mut wrong = right.clone();
    wrong.display.iter_mut().for_each(|p| p[1] ^= 16);
    compare(&right, &wrong).unwrap_err();
}

#[test]
fn tiles_change_no_bit() {
    let Some(mut whole) = gpu("tiles_change_no_bit", GpuOptions::default()) else {
        return;
    };
    let env = sky(UVec2::new(32, 16), 0.0);
    let expected = frame(&mut whole, &env, &settings());
    let tiled = [
        // The largest buffer of the scene has 146,112 bytes.
        GpuOptions {
            max_binding_bytes: 150_000,
            ..Default::default()
        },
        GpuOptions {
            max_elements: 1000,
            ..Default::default()
        },
    ];
    for options in tiled {
        let mut renderer = gpu("tiles_change_no_bit", options).unwrap();
        let told = Mutex::new(Vec::new());
        let tell = |fraction| told.lock().unwrap().push(fraction);
        let image = renderer
            .render_frame(&scene(), &env, &settings(), &tell)
            .unwrap();
        assert!(image.linear == expected.linear && image.display == expected.display);
        let told = told.into_inner().unwrap();
        assert!(
            told.len() > 4 && told.windows(2).all(|pair| pair[0] < pair[1]),
            "{told:?}"
        );
        assert!((told[told.len() - 1] - 1.0).abs() < 1e-6);
        assert!(renderer.times().shade.dispatches as usize == told.len());
    }
}

#[test]
fn a_light_can_be_uploaded_while_another_renders() {
    let Some(mut renderer) = gpu(
        "a_light_can_be_uploaded_while_another_renders",
        GpuOptions::default(),
    ) else {
        return;
    };
    let lights = [0.0, 90.0].map(|turn| sky(UVec2::new(128, 64), turn));
    let scene_buffers = scene();
    let expected = [0, 1].map(|i| frame(&mut renderer, &lights[i], &settings()).linear);
    let context = renderer.context().clone();
    let method = &settings().method;
    let mut next = GpuEnv::new(&context, &lights[1], method).unwrap();
    for turn in 0..4 {
        let current = next;
        let (image, uploaded) = std::thread::scope(|scope| {
            let upload = scope.spawn(|| GpuEnv::new(&context, &lights[turn % 2], method).unwrap());
            let image = renderer
                .render(&scene_buffers, &current, None, &settings(), &|_| ())
                .unwrap();
            (image, upload.join().unwrap())
        });
        assert!(image.linear == expected[(turn + 1) % 2]);
        next = uploaded;
        next.update(&context, &lights[turn % 2], method).unwrap();
    }
}

#[test]
fn what_does_not_fit_is_named() {
    let options = GpuOptions {
        max_binding_bytes: 150_000,
        ..Default::default()
    };
    let Some(mut renderer) = gpu("what_does_not_fit_is_named", options) else {
        return;
    };
    let env = sky(UVec2::new(256, 128), 0.0);
    let error = renderer
        .render_frame(&scene(), &env, &settings(), &|_| ())
        .unwrap_err()
        .to_string();
    assert!(
        error.contains("env.texels") && error.contains("max_storage_buffer_binding_size"),
        "{error}"
    );
    let many = RenderSettings {
        rays_per_pixel: 10_000,
        size: UVec2::ONE,
        ..settings()
    };
    let mut renderer = gpu(
        "rays",
        GpuOptions {
            max_binding_bytes: 150_000,
            ..Default::default()
        },
    )
    .unwrap();
    let env = sky(UVec2::new(32, 16), 0.0);
    let error = renderer
        .render_frame(&scene(), &env, &many, &|_| ())
        .unwrap_err()
        .to_string();
    assert!(error.contains("samples"), "{error}");
}
