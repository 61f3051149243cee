//! Host file: estimators' images of an analytic scene, pixel by pixel against quadrature in f64.

use glam::{DVec3, UVec2, Vec3};
use glimt_render_gpu::cpu::CpuRenderer;
use glimt_render_gpu::methods::{Bis, Mis};
use glimt_render_gpu::prepare::env::{EnvMap, PreparedEnv};
use glimt_render_gpu::prepare::render::{Filter, FrameImage, Pattern, RenderSettings, Renderer};
use glimt_render_gpu::prepare::scene::Camera;
use glimt_render_gpu::prepare::scene_build::SceneBuffers;
use rayon::prelude::*;

use crate::analytic::{AnalyticMap, AnalyticScene};
use crate::quadrature::Integral;
use crate::stats::{Evidence, Mean, sidak, z_test};

/// The image.
pub const SIZE: UVec2 = UVec2::new(8, 5);
/// Independent scramblings that a mean is taken over.
pub const SCRAMBLINGS: u32 = 256;

/// A ground, a box and a sphere of one material.
#[must_use]
pub fn scene(diffuse: f64, specular: f64, exponent: f64) -> AnalyticScene {
    AnalyticScene {
        cuboid: [DVec3::new(-0.3, 0.9, 0.4), DVec3::new(1.1, 2.0, 1.5)],
        centre: DVec3::new(0.5, -0.8, 1.1),
        radius: 0.9,
        diffuse: diffuse * DVec3::new(1.0, 0.8, 0.5),
        specular: specular * DVec3::new(0.9, 1.0, 0.8),
        exponent,
    }
}

/// Where they are seen from.
#[must_use]
pub fn camera() -> Camera {
    Camera {
        eye: Vec3::new(-5.0, 0.7, 2.6),
        target: Vec3::new(0.5, 0.25, 0.6),
        up: Vec3::Z,
        fov_x: 0.7,
    }
}

/// A sky that varies, half black below, with a sun of `sun` times its radiance in one texel.
#[must_use]
pub fn map(sun: f64) -> AnalyticMap {
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

/// The map with its tables.
#[must_use]
pub fn prepare(map: &AnalyticMap) -> PreparedEnv {
    let texels = map.texels.iter().map(|t| t.as_vec3().extend(1.0)).collect();
    EnvMap::new(UVec2::from_array(map.size), texels)
        .unwrap()
        .prepare(0.0)
        .unwrap()
}

/// A frame by the CPU.
#[must_use]
pub fn render(scene: &SceneBuffers, env: &PreparedEnv, settings: &RenderSettings) -> FrameImage {
    CpuRenderer::default()
        .render_frame(scene, env, settings, &|_| ())
        .unwrap()
}

/// The direction of a pixel's centre, by the formula of the documentation, in f64.
#[must_use]
pub fn pixel_direction(camera: &Camera, size: UVec2, x: u32, y: u32) -> DVec3 {
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
#[must_use]
pub fn reference(scene: &AnalyticScene, map: &AnalyticMap) -> Vec<Option<Integral>> {
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

/// The channel in which a pixel is judged.
#[must_use]
pub fn channel(pixel: u32) -> usize {
    (pixel % 3) as usize
}

/// An estimator to be judged.
#[derive(Clone, Copy, Debug)]
pub struct Case {
    /// For messages.
    pub name: &'static str,
    /// How it is rendered, but for the seed.
    pub settings: RenderSettings,
}

/// Settings for [`SIZE`] pixels through their centres, `rays` in each.
#[must_use]
pub fn settings(rays: u32, pattern: Pattern) -> RenderSettings {
    RenderSettings {
        rays_per_pixel: rays,
        pattern,
        filter: Filter::Centre,
        ..RenderSettings::new(SIZE, camera())
    }
}

/// Multiple importance sampling with `samples` of the BRDF and of the light on each of 16 rays.
#[must_use]
pub fn mis(name: &'static str, [brdf_samples, env_samples]: [u32; 2], pattern: Pattern) -> Case {
    let settings = RenderSettings {
        method: Mis {
            brdf_samples,
            env_samples,
            ..Mis::default()
        }
        .into(),
        ..settings(16, pattern)
    };
    Case { name, settings }
}

/// Bidirectional importance sampling on each of `rays` rays.
#[must_use]
pub fn bis(name: &'static str, rays: u32, bis: Bis, pattern: Pattern) -> Case {
    let settings = RenderSettings {
        method: bis.into(),
        ..settings(rays, pattern)
    };
    Case { name, settings }
}

/// Means over independent scramblings, pixel by pixel.
#[must_use]
pub fn means(scene: &SceneBuffers, env: &PreparedEnv, case: &Case) -> Vec<Mean> {
    let images: Vec<FrameImage> = (0..SCRAMBLINGS)
        .map(|seed| {
            let settings = RenderSettings {
                seed,
                ..case.settings
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
#[must_use]
pub fn disagreements(
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

/// Every case's mean under [`map`] is the integral, in every pixel.
///
/// # Panics
/// Where one is not.
pub fn assert_unbiased(analytic: &AnalyticScene, sun: f64, cases: &[Case]) {
    assert_unbiased_under(&map(sun), analytic, cases);
}

/// Every case's mean under this map is the integral, in every pixel.
///
/// # Panics
/// Where one is not.
pub fn assert_unbiased_under(map: &AnalyticMap, analytic: &AnalyticScene, cases: &[Case]) {
    let reference = reference(analytic, map);
    let (scene, env) = (
        SceneBuffers::build(&analytic.describe(200)).unwrap(),
        prepare(map),
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
