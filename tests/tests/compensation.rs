//! Host file: MIS compensation in the renderer: what its tables draw, that means stay the integral, and that no method gets the
//! tables of another.

use glam::{DVec3, UVec2, Vec4};
use glimt_probe::latlong::texel_solid_angle_sr;
use glimt_render_gpu::cpu::CpuRenderer;
use glimt_render_gpu::gpu::{GpuEnv, GpuRenderer};
use glimt_render_gpu::kernels::environment::Environment;
use glimt_render_gpu::kernels::estimator::{Estimator, LightSample, Reflected};
use glimt_render_gpu::kernels::mis;
use glimt_render_gpu::kernels::pattern::{BRDF, ENVIRONMENT, LIT_THROUGH, PixelPattern};
use glimt_render_gpu::kernels::scene::{Scene, ShadingPoint};
use glimt_render_gpu::kernels::shade::shade;
use glimt_render_gpu::methods::{Bis, Method, Mis, Product, Smc};
use glimt_render_gpu::prepare::env::{EnvMap, PreparedEnv};
use glimt_render_gpu::prepare::render::{
    Pattern, RenderError, RenderSettings, Renderer, SettingsError,
};
use glimt_render_gpu::prepare::scene_build::SceneBuffers;
use glimt_sampling::luminance;
use glimt_sampling::uniform::{UniformSource, unit_vec2};
use glimt_sampling::xoshiro::Xoshiro128PlusPlus;
use glimt_statistics::stats::{Mean, Verdict, chi_square};
use glimt_tests::analytic::AnalyticMap;
use glimt_tests::gpu::adapter_or_skip;
use glimt_tests::unbiased::{
    SCRAMBLINGS, SIZE, assert_unbiased, assert_unbiased_under, channel, disagreements, map, mis,
    prepare, reference, scene, settings,
};

/// Faint beside the sky as a whole, so that other texels are above the mean, too.
const LAMP: f64 = 50.0;

fn compensated() -> Method {
    Mis::default().into()
}

fn plain() -> Method {
    let plain = Mis {
        compensation: false,
        ..Mis::default()
    };
    plain.into()
}

fn env_map(map: &AnalyticMap) -> EnvMap {
    let texels = map.texels.iter().map(|t| t.as_vec3().extend(1.0)).collect();
    EnvMap::new(UVec2::from_array(map.size), texels).unwrap()
}

fn constant() -> AnalyticMap {
    AnalyticMap {
        size: [32, 16],
        texels: vec![DVec3::new(0.5, 0.75, 1.25); 512],
    }
}

fn texels(env: Environment<'_>) -> impl Iterator<Item = UVec2> {
    let size = env.size;
    (0..size.x * size.y).map(move |i| UVec2::new(i % size.x, i / size.x))
}

/// Each texel's share of draws: `max(0, L − L̄) ΔΩ` over its sum, in f64.
fn shares(env: Environment<'_>) -> Vec<f64> {
    let area = |texel: UVec2| f64::from(texel_solid_angle_sr(texel.y, env.size));
    let light = |texel: UVec2| f64::from(luminance(env.radiance(texel)));
    let flux: f64 = texels(env).map(|t| light(t) * area(t)).sum();
    let mean = flux / texels(env).map(area).sum::<f64>();
    let above = |texel: UVec2| (light(texel) - mean).max(0.0) * area(texel);
    let total: f64 = texels(env).map(above).sum();
    texels(env).map(|texel| above(texel) / total).collect()
}

#[test]
fn the_density_is_that_of_light_above_the_mean() {
    for lamp in [LAMP, 1e5] {
        let env = env_map(&map(lamp)).prepare_for(&compensated(), 70.0);
        let env = env.unwrap();
        let env = env.view_for(&compensated()).unwrap();
        let mut sum = 0.0;
        for (texel, share) in texels(env).zip(shares(env)) {
            let area = texel_solid_angle_sr(texel.y, env.size);
            let mass = f64::from(env.cdf().texel_pdf_sr(texel) * area);
            assert!((mass - share).abs() < 1e-6, "{texel}: {mass}, not {share}");
            assert_eq!(mass > 0.0, share > 0.0, "{texel}");
            sum += mass;
        }
        assert!((sum - 1.0).abs() < 1e-5, "{sum}");
    }
}

fn judge(drawn_from: Environment<'_>, shares: &[f64]) -> Verdict {
    const DRAWS: u32 = 400_000;
    let mut counts = vec![0; shares.len()];
    let mut random = Xoshiro128PlusPlus::stream(3, 1, 4);
    for _ in 0..DRAWS {
        let texel = drawn_from.sample(random.next_uvec2()).texel;
        counts[(texel.y * drawn_from.size.x + texel.x) as usize] += 1;
    }
    let expected: Vec<f64> = shares.iter().map(|s| s * f64::from(DRAWS)).collect();
    chi_square(&counts, &expected, 0.01)
}

#[test]
fn texels_are_drawn_by_their_light_above_the_mean() {
    let env = env_map(&map(LAMP)).prepare(0.0).unwrap();
    let [own, other] = [compensated(), plain()].map(|m| env.view_for(&m).unwrap());
    judge(own, &shares(own)).unwrap();
    assert!(judge(other, &shares(own)).is_err(), "plain draws passed");
}

#[test]
fn means_are_the_integral() {
    let cases = [
        mis("Owen-Sobol 1 + 1", [1, 1], Pattern::OwenSobol),
        mis("independent 1 + 3", [1, 3], Pattern::Independent),
        mis("stratified 2 + 1", [2, 1], Pattern::Stratified),
    ];
    for (diffuse, specular, exponent) in [(0.8, 0.0, 1.0), (0.3, 0.6, 50.0), (0.1, 0.9, 500.0)] {
        let material = scene(diffuse, specular, exponent);
        assert_unbiased(&material, LAMP, &cases);
        assert_unbiased_under(&constant(), &material, &cases);
    }
}

/// The environment's samples come from one light, the densities that they are judged by from another.
struct Judged<'a> {
    by: Environment<'a>,
    mis: mis::Mis,
}

impl Estimator for Judged<'_> {
    fn reflected(
        &self,
        point: &ShadingPoint,
        pattern: &PixelPattern,
        env: Environment<'_>,
        scene: Scene<'_>,
    ) -> Reflected {
        let mut sum = Reflected::NONE;
        let (n_brdf, n_env) = (self.mis.brdf_samples, self.mis.env_samples);
        let key = pattern.ray_key(LIT_THROUGH);
        let density = |of_brdf: f32, texel| {
            n_brdf as f32 * of_brdf + n_env as f32 * self.by.cdf().texel_pdf_sr(texel)
        };
        for i in 0..n_brdf {
            let u = pattern.triple(BRDF, i, n_brdf);
            let drawn = point.brdf.sample(point.wo, u.z, unit_vec2(u.truncate()));
            if drawn.pdf_sr > 0.0 {
                let direction = point.frame.to_world(drawn.wi);
                let texel = env.texel(direction);
                let density = density(drawn.pdf_sr, texel);
                let light = env.radiance(texel);
                let sample = LightSample::new(point, direction, drawn.wi, light, density);
                sum.gather(sample.traced(point, scene, key));
            }
        }
        for i in 0..n_env {
            let drawn = env.sample(pattern.pair(ENVIRONMENT, i, n_env));
            let wi = point.frame.to_local(drawn.direction);
            let density = density(point.brdf.pdf_sr(point.wo, wi), drawn.texel);
            let light = env.radiance(drawn.texel);
            let sample = LightSample::new(point, drawn.direction, wi, light, density);
            sum.gather(sample.traced(point, scene, key));
        }
        sum
    }
}

/// Means of an estimator's pixels under a light, whatever the renderer would make of the two.
fn means_of(estimator: &impl Estimator, env: Environment<'_>, scene: &SceneBuffers) -> Vec<Mean> {
    const RAYS: u32 = 16;
    let frames: Vec<_> = (0..SCRAMBLINGS)
        .map(|seed| {
            let of_seed = RenderSettings {
                seed,
                ..settings(RAYS, Pattern::OwenSobol)
            };
            of_seed.frame_params().unwrap()
        })
        .collect();
    let pixel = |pixel: u32| {
        Mean::of(frames.iter().map(|frame| {
            let rays = pixel * RAYS..(pixel + 1) * RAYS;
            let each = rays.map(|ray| shade::<_, Vec4>(ray, frame, estimator, env, scene.view()));
            each.map(|sample| f64::from(sample[channel(pixel)]))
                .sum::<f64>()
                / f64::from(RAYS)
        }))
    };
    (0..SIZE.x * SIZE.y).map(pixel).collect()
}

/// The test of means can fail: tables that were mixed up, and compensated draws alone, are noticed.
#[test]
fn wrong_densities_are_noticed() {
    let (material, map) = (scene(0.3, 0.6, 50.0), map(LAMP));
    let reference = reference(&material, &map);
    let scene = SceneBuffers::build(&material.describe(200)).unwrap();
    let env = prepare(&map);
    let [own, other] = [compensated(), plain()].map(|m| env.view_for(&m).unwrap());
    let both = mis::Mis {
        brdf_samples: 1,
        env_samples: 1,
    };
    let alone = mis::Mis {
        brdf_samples: 0,
        env_samples: 2,
    };
    let bad = |means: &[Mean]| disagreements(means, &reference, 0.01).len();
    let judged = |by| Judged { by, mis: both };
    assert_eq!(bad(&means_of(&both, own, &scene)), 0);
    assert_eq!(bad(&means_of(&judged(own), own, &scene)), 0);
    assert!(bad(&means_of(&judged(other), own, &scene)) > 10);
    assert!(bad(&means_of(&judged(own), other, &scene)) > 10);
    assert!(bad(&means_of(&alone, own, &scene)) > 10);
}

fn is_refused(result: Result<impl Sized, RenderError>) -> bool {
    match result {
        Err(RenderError::Settings(error)) => error == SettingsError::Tables,
        _ => false,
    }
}

/// Lights as they are prepared for each method, all at last; and the methods.
fn lights() -> (Vec<PreparedEnv>, Vec<Method>) {
    let alone = Mis {
        brdf_samples: 0,
        ..Mis::default()
    };
    let methods = vec![
        compensated(),
        plain(),
        alone.into(),
        Bis::default().into(),
        Smc::default().into(),
        Product::default().into(),
    ];
    let map = env_map(&map(LAMP));
    let mut lights: Vec<PreparedEnv> = methods
        .iter()
        .map(|method| map.clone().prepare_for(method, 10.0).unwrap())
        .collect();
    lights.push(map.clone().without_tables(10.0).unwrap());
    lights.push(map.prepare(10.0).unwrap());
    (lights, methods)
}

/// What [`lights`] serve which methods, in their order: those that compensate, those that read plain tables, and `product`, which
/// reads cells.
const SERVED: [[bool; 6]; 8] = {
    const NONE: [bool; 6] = [false; 6];
    const OF_ONE: [bool; 6] = [true, false, false, false, false, false];
    const OF_LIGHT: [bool; 6] = [false, true, true, true, true, false];
    const OF_PRODUCT: [bool; 6] = [false, false, false, false, false, true];
    [
        OF_ONE, OF_LIGHT, OF_LIGHT, OF_LIGHT, OF_LIGHT, OF_PRODUCT, NONE, [true; 6],
    ]
};

#[test]
fn a_method_refuses_tables_of_another() {
    let scene = SceneBuffers::build(&scene(0.5, 0.2, 20.0).describe(8)).unwrap();
    let (lights, methods) = lights();
    let mut renderers: Vec<Box<dyn Renderer>> = vec![Box::new(CpuRenderer::default())];
    let context = adapter_or_skip("a_method_refuses_tables_of_another").map(std::sync::Arc::new);
    if let Some(context) = &context {
        renderers.push(Box::new(GpuRenderer::on(context.clone()).unwrap()));
    }
    for (light, served) in lights.iter().zip(SERVED) {
        for (method, served) in methods.iter().zip(served) {
            let settings = RenderSettings {
                method: *method,
                ..settings(1, Pattern::OwenSobol)
            };
            for renderer in &mut renderers {
                let image = renderer.render_frame(&scene, light, &settings, &|_| ());
                assert_eq!(is_refused(image), !served, "{method:?}");
            }
            let (Some(context), true) = (&context, served) else {
                continue;
            };
            // What was uploaded for one method is refused by others.
            let uploaded = GpuEnv::new(context, light, method).unwrap();
            let mut renderer = GpuRenderer::on(context.clone()).unwrap();
            for other in [compensated(), plain()] {
                let image = renderer.render(
                    &scene,
                    &uploaded,
                    None,
                    &RenderSettings {
                        method: other,
                        ..settings
                    },
                    &|_| (),
                );
                let fits = !matches!(method, Method::Product(_))
                    && (other == compensated()) == (*method == compensated());
                assert_eq!(is_refused(image), !fits, "{method:?}, {other:?}");
            }
        }
    }
}

#[test]
fn the_mean_stays_that_of_the_map() {
    let (lights, _) = lights();
    let [own, other] = [lights[0].mean_luminance(), lights[1].mean_luminance()];
    assert!((own / other - 1.0).abs() < 1e-6, "{own}, {other}");
    assert!(own > 0.5);
}

#[test]
fn where_a_count_is_0_the_setting_has_no_effect() {
    let scene = SceneBuffers::build(&scene(0.5, 0.2, 20.0).describe(8)).unwrap();
    let env = prepare(&map(LAMP));
    let render = |brdf_samples, env_samples, compensation| {
        let method = Mis {
            brdf_samples,
            env_samples,
            compensation,
        };
        let settings = RenderSettings {
            method: method.into(),
            ..settings(4, Pattern::OwenSobol)
        };
        glimt_tests::unbiased::render(&scene, &env, &settings).linear
    };
    assert!(render(0, 2, true) == render(0, 2, false));
    assert!(render(2, 0, true) == render(2, 0, false));
    assert!(render(1, 1, true) != render(1, 1, false));
}
