//! Host file: the renderer's stages on both processors, ray by ray: integers exactly, floats within what is said here.
//!
//! A decision that depends on a float (which side of an edge, which texel a direction falls into) may differ where its margin is
//! below the float's tolerance: such rays are counted and bounded.

use bytemuck::{AnyBitPattern, NoUninit};
use glam::{Mat4, UVec2, UVec4, Vec3, Vec4};
use glimt_executor::Entry;
use glimt_render_gpu::generated;
use glimt_render_gpu::gpu::{Arg, GpuContext, GpuEnv, GpuScene};
use glimt_render_gpu::kernels::diagnose::{self, EnvRecord, HitRecord, SurfaceRecord};
use glimt_render_gpu::kernels::environment::Environment;
use glimt_render_gpu::kernels::frame::FrameParams;
use glimt_render_gpu::kernels::layers::LayerSample;
use glimt_render_gpu::kernels::mis::Mis;
use glimt_render_gpu::kernels::shade::shade;
use glimt_render_gpu::methods::{self, Method};
use glimt_render_gpu::prepare::env::{EnvMap, PreparedEnv};
use glimt_render_gpu::prepare::render::RenderSettings;
use glimt_render_gpu::prepare::scene::{
    Camera, Material, Mesh, Object, Reflection, SceneDescription,
};
use glimt_render_gpu::prepare::scene_build::SceneBuffers;
use glimt_tests::gpu::adapter_or_skip;

/// Directions and positions, relative to the largest.
const FLOATS: f32 = 2e-5;
/// Whatever holds a power, on software adapters.
const POWERS: f32 = 3e-3;
/// Share of rays whose decisions may fall differently.
const DECISIONS: f64 = 1e-3;

/// A bumpy sheet in the sun.
fn scene() -> SceneBuffers {
    SceneBuffers::build(&describe()).unwrap()
}

fn describe() -> SceneDescription {
    let n = 40u32;
    let mut sheet = Mesh {
        name: "sheet".into(),
        materials: vec![0],
        ..Mesh::default()
    };
    for j in 0..=n {
        for i in 0..=n {
            let (x, y) = (
                i as f32 / n as f32 * 6.0 - 3.0,
                j as f32 / n as f32 * 6.0 - 3.0,
            );
            sheet
                .positions
                .push(Vec3::new(x, y, 0.4 * (2.0 * x).sin() * (3.0 * y).cos()));
        }
    }
    for j in 0..n {
        for i in 0..n {
            let (a, b) = (j * (n + 1) + i, (j + 1) * (n + 1) + i);
            sheet.indices.extend([[a, a + 1, b + 1], [a, b + 1, b]]);
        }
    }
    SceneDescription {
        meshes: vec![sheet],
        objects: vec![Object {
            mesh: 0,
            transform: Mat4::IDENTITY,
            material: None,
            catcher: false,
        }],
        materials: vec![Material::from(Reflection::BlinnPhong {
            diffuse: Vec3::new(0.4, 0.3, 0.2),
            specular: Vec3::splat(0.4),
            exponent: 60.0,
        })],
        textures: Vec::new(),
    }
}

fn env() -> PreparedEnv {
    let size = UVec2::new(64, 32);
    let texel = |i: u32| {
        let (x, y) = (i % 64, i / 64);
        let sky = 0.2 + 0.01 * f32::from((x % 7) as u8) + 0.02 * f32::from((y % 5) as u8);
        if (x, y) == (12, 6) {
            Vec4::splat(2e4)
        } else {
            Vec4::splat(sky)
        }
    };
    EnvMap::new(size, (0..64 * 32).map(texel).collect())
        .unwrap()
        .prepare(25.0)
        .unwrap()
}

struct Fixture {
    context: GpuContext,
    /// Whose tables of the light are used.
    method: Method,
    scene: SceneBuffers,
    env: PreparedEnv,
    frame: FrameParams,
    rays: u32,
}

/// One sample of each strategy.
const MIS: Mis = Mis {
    brdf_samples: 1,
    env_samples: 1,
};

impl Fixture {
    fn new() -> Option<Fixture> {
        let context = adapter_or_skip("parity")?;
        let camera = Camera {
            eye: Vec3::new(5.0, -4.0, 3.5),
            target: Vec3::ZERO,
            up: Vec3::Z,
            fov_x: 0.8,
        };
        let settings = RenderSettings {
            rays_per_pixel: 4,
            ..RenderSettings::new(UVec2::new(96, 64), camera)
        };
        let frame = settings.frame_params().unwrap();
        Some(Fixture {
            context,
            scene: scene(),
            method: Method::default(),
            env: env(),
            frame,
            rays: 96 * 64 * 4,
        })
    }

    /// The same without compensation, whose tables draw from all of the sky.
    fn plain(self) -> Fixture {
        let plain = methods::Mis {
            compensation: false,
            ..methods::Mis::default()
        };
        let method = plain.into();
        Fixture { method, ..self }
    }

    /// What kernels on the CPU see of the light.
    fn light(&self) -> Environment<'_> {
        self.env.view_for(&self.method).unwrap()
    }

    /// What the GPU makes of an entry for every ray.
    fn run<T: AnyBitPattern + NoUninit>(&self, entry: &Entry) -> Vec<T> {
        let scene = GpuScene::new(&self.context, &self.scene).unwrap();
        let env = GpuEnv::new(&self.context, &self.env, &self.method).unwrap();
        let out = self
            .context
            .buffer("out", u64::from(self.rays) * size_of::<T>() as u64)
            .unwrap();
        let mut args = vec![
            ("frame", Arg::Value(bytemuck::bytes_of(&self.frame))),
            ("out", Arg::Buffer(&out)),
        ];
        let wanted = |path: &str| {
            entry.params.iter().any(|p| p.path == path)
                || entry.buffers.iter().any(|b| b.path == path)
        };
        args.extend(
            scene
                .args()
                .into_iter()
                .chain(env.args())
                .chain([
                    ("mis", Arg::Value(bytemuck::bytes_of(&MIS))),
                    ("estimator", Arg::Value(bytemuck::bytes_of(&MIS))),
                ])
                .filter(|(path, _)| wanted(path)),
        );
        self.context.launch(entry, &args, 0, self.rays).unwrap();
        self.context.read(&out, self.rays as usize).unwrap()
    }
}

/// Counts the pairs for which `same` is false, and holds them to the share allowed.
fn hold<T>(
    what: &str,
    gpu: &[T],
    cpu: impl Fn(u32) -> T,
    allowed: f64,
    same: impl Fn(&T, &T) -> bool,
) -> Result<(), String> {
    let off = (0u32..)
        .zip(gpu)
        .filter(|(i, g)| !same(g, &cpu(*i)))
        .count();
    println!("{what}: {off} of {} differ", gpu.len());
    if off as f64 <= allowed * gpu.len() as f64 {
        Ok(())
    } else {
        Err(format!("{what}: {off} of {} differ", gpu.len()))
    }
}

fn near(a: f32, b: f32, tolerance: f32) -> bool {
    (a - b).abs() <= tolerance
}

fn near3(a: Vec3, b: Vec3, tolerance: f32) -> bool {
    (a - b).abs().max_element() <= tolerance
}

#[test]
fn uniforms_are_the_same_bits() {
    let Some(f) = Fixture::new() else { return };
    let gpu: Vec<[u32; 4]> = f.run(&generated::entries::DIAGNOSE_UNIFORMS);
    let cpu = |ray| diagnose::uniforms(ray, &f.frame, &MIS).to_array();
    hold("uniforms", &gpu, cpu, 0.0, |a, b| a == b).unwrap();
    let other = |ray| diagnose::uniforms(ray + 1, &f.frame, &MIS).to_array();
    assert!(hold("another ray's uniforms", &gpu, other, 0.0, |a, b| a == b).is_err());
    assert_ne!(UVec4::from_array(gpu[0]), UVec4::ZERO);
}

#[test]
fn environment_samples_are_the_same_texels() {
    let Some(compensated) = Fixture::new() else {
        return;
    };
    assert_eq!(environment_samples(&compensated), 1.0);
    let sun = environment_samples(&compensated.plain());
    assert!(sun > 0.1 && sun < 0.99, "the sun draws its share: {sun}");
}

/// Holds them against each other; the share of the sun.
fn environment_samples(f: &Fixture) -> f64 {
    let gpu: Vec<EnvRecord> = f.run(&generated::entries::DIAGNOSE_ENV_SAMPLE);
    let view = f.light();
    let cpu = |ray| diagnose::env_sample(ray, &f.frame, &MIS, view);
    hold("texel drawn", &gpu, cpu, 0.0, |a, b| a.texel == b.texel).unwrap();
    hold("its density", &gpu, cpu, 0.0, |a, b| {
        near(a.pdf_sr, b.pdf_sr, FLOATS * b.pdf_sr)
    })
    .unwrap();
    hold("its direction", &gpu, cpu, 0.0, |a, b| {
        near3(a.direction, b.direction, FLOATS)
    })
    .unwrap();
    hold("texel looked up", &gpu, cpu, DECISIONS, |a, b| {
        a.looked_up == b.looked_up
    })
    .unwrap();
    let sun = gpu.iter().filter(|r| r.texel == UVec2::new(12, 6)).count();
    sun as f64 / gpu.len() as f64
}

#[test]
fn hits_and_surfaces_agree() {
    let Some(f) = Fixture::new() else { return };
    let view = f.scene.view();
    let gpu: Vec<HitRecord> = f.run(&generated::entries::DIAGNOSE_PRIMARY_HIT);
    let cpu = |ray| diagnose::primary_hit(ray, &f.frame, view);
    hold("triangle", &gpu, cpu, DECISIONS, |a, b| {
        a.triangle == b.triangle
    })
    .unwrap();
    hold("distance", &gpu, cpu, DECISIONS, |a, b| {
        near(a.t, b.t, FLOATS * b.t)
    })
    .unwrap();
    let hits = gpu.iter().filter(|h| h.triangle != u32::MAX).count();
    assert!(
        hits > gpu.len() / 4 && hits < gpu.len(),
        "{hits} hits of {}",
        gpu.len()
    );
    let gpu: Vec<SurfaceRecord> = f.run(&generated::entries::DIAGNOSE_SURFACE);
    let cpu = |ray| diagnose::surface(ray, &f.frame, view);
    hold("where shadow rays start", &gpu, cpu, DECISIONS, |a, b| {
        near3(a.origin, b.origin, 8.0 * FLOATS)
    })
    .unwrap();
    hold("normal", &gpu, cpu, DECISIONS, |a, b| {
        near3(a.normal, b.normal, 1e-3)
    })
    .unwrap();
    hold("material", &gpu, cpu, DECISIONS, |a, b| {
        a.diffuse == b.diffuse && a.exponent == b.exponent
    })
    .unwrap();
}

#[test]
fn brdf_samples_agree() {
    let Some(f) = Fixture::new() else { return };
    let gpu: Vec<[f32; 4]> = f.run(&generated::entries::DIAGNOSE_BRDF_SAMPLE);
    let cpu = |ray| diagnose::brdf_sample(ray, &f.frame, &MIS, f.scene.view()).to_array();
    let largest = (0..f.rays).map(|ray| cpu(ray)[3]).fold(0.0, f32::max);
    assert!(largest > 1.0);
    let direction = |a: &[f32; 4]| Vec4::from_array(*a).truncate();
    hold("sampled direction", &gpu, cpu, DECISIONS, |a, b| {
        near3(direction(a), direction(b), POWERS)
    })
    .unwrap();
    hold("its density", &gpu, cpu, DECISIONS, |a, b| {
        near(a[3], b[3], POWERS * largest)
    })
    .unwrap();
}

/// What a ray shows in a scene of which a part is a catcher: an object, the catcher with and without its light, or nothing.
#[test]
fn layers_agree() {
    let Some(mut f) = Fixture::new() else { return };
    let mut description = describe();
    // A catcher that cuts through the sheet, so that the sheet's ridges are before it, and shadow it.
    let mut plane = description.meshes[0].clone();
    plane.positions.iter_mut().for_each(|p| p.z = 0.1);
    description.meshes.push(plane);
    description.objects.push(Object {
        mesh: 1,
        catcher: true,
        ..description.objects[0].clone()
    });
    f.scene = SceneBuffers::build(&description).unwrap();
    let gpu: Vec<LayerSample> = f.run(&generated::entries::SHADE_MIS_LAYERS);
    let shade = |ray| shade(ray, &f.frame, &MIS, f.light(), f.scene.view());
    let samples: Vec<LayerSample> = (0..f.rays).map(shade).collect();
    let cpu = |ray: u32| samples[ray as usize];
    let largest = samples
        .iter()
        .map(|s| (s.radiance + s.blocked).max_element());
    let largest = largest.fold(0.0, f32::max);
    let kind = |s: &LayerSample| (s.alpha, s.catcher);
    hold("kind", &gpu, cpu, DECISIONS, |a, b| kind(a) == kind(b)).unwrap();
    hold("radiance", &gpu, cpu, DECISIONS, |a, b| {
        near3(a.radiance, b.radiance, 1e-4 * largest)
    })
    .unwrap();
    let blocked = |a: &LayerSample, b: &LayerSample| {
        near3(a.blocked, b.blocked, 1e-4 * largest)
            && (a.blocked == Vec3::ZERO) == (b.blocked == Vec3::ZERO)
    };
    hold("blocked", &gpu, cpu, DECISIONS, blocked).unwrap();
    let unshadowed = |ray| LayerSample {
        blocked: Vec3::ZERO,
        ..cpu(ray)
    };
    assert!(hold("no shadow", &gpu, unshadowed, DECISIONS, blocked).is_err());
    let share = |kind: fn(&LayerSample) -> bool| {
        gpu.iter().filter(|s| kind(s)).count() as f64 / gpu.len() as f64
    };
    assert!(share(|s| s.alpha == 1.0) > 0.1 && share(|s| s.catcher == 1.0) > 0.1);
    assert!(share(|s| s.blocked != Vec3::ZERO) > 0.02);
}

#[test]
fn radiance_agrees() {
    let Some(compensated) = Fixture::new() else {
        return;
    };
    hold_radiance(&compensated);
    hold_radiance(&compensated.plain());
}

fn hold_radiance(f: &Fixture) {
    let gpu: Vec<[f32; 4]> = f.run(&generated::entries::SHADE_MIS);
    let shade = |ray| {
        let sample: glam::Vec4 = shade(ray, &f.frame, &MIS, f.light(), f.scene.view());
        sample.to_array()
    };
    let radiance = |a: &[f32; 4]| Vec4::from_array(*a).truncate();
    let largest = (0..f.rays)
        .map(|ray| radiance(&shade(ray)).max_element())
        .fold(0.0, f32::max);
    let same = |a: &[f32; 4], b: &[f32; 4]| {
        near3(radiance(a), radiance(b), 1e-4 * largest) && a[3] == b[3]
    };
    hold("radiance", &gpu, shade, DECISIONS, same).unwrap();
    let sum = |values: &mut dyn Iterator<Item = Vec3>| {
        values.map(|v| f64::from(v.element_sum())).sum::<f64>()
    };
    let (g, c) = (
        sum(&mut gpu.iter().map(radiance)),
        sum(&mut (0..f.rays).map(|r| radiance(&shade(r)))),
    );
    println!("mean energy: GPU / CPU = {}", g / c);
    assert!((g / c - 1.0).abs() <= 1e-3, "GPU / CPU = {}", g / c);
}
