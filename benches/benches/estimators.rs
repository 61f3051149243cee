//! Claim: Owen-scrambled Sobol points with 1 + 1 samples on each of 16 rays are at least 4 times as efficient (error² × time)
//! as the preset `kronander`, 15 + 15 independent samples on one ray. A diffuse bunny on a plane under three maps.

use glam::{UVec2, Vec4};
use glimt_benches::inputs::{bunny, light_maps};
use glimt_benches::scene::{camera, on_a_plane};
use glimt_benches::{Contest, claim};
use glimt_render_gpu::cpu::CpuRenderer;
use glimt_render_gpu::host::env::PreparedEnv;
use glimt_render_gpu::host::render::{
    Background, Filter, Method, Pattern, RenderSettings, Renderer, Tonemap,
};
use glimt_render_gpu::host::scene_build::SceneBuffers;

const SIZE: UVec2 = UVec2::new(128, 96);
/// Independent scramblings over which the error is averaged.
const SEEDS: u32 = 8;
const ROUNDS: usize = 5;

fn main() {
    let scene = SceneBuffers::build(&on_a_plane(&bunny())).expect("a scene");
    let mut all = Vec::new();
    for (name, map) in light_maps() {
        let env = map.prepare(0.0).expect("tables");
        // One ray through the centre of a pixel sees no edge in part, so that light alone is compared.
        let reference = render(&scene, &env, &settings(Pattern::OwenSobol, 2048, 1, 1000));
        let sobol = |seed| settings(Pattern::OwenSobol, 16, 1, seed);
        let kronander = |seed| settings(Pattern::Independent, 1, 15, seed);
        let scores = Contest::new(
            &format!("{name}, a frame of {}×{}", SIZE.x, SIZE.y),
            "pixel",
            f64::from(SIZE.x * SIZE.y),
        )
        .entry("kronander: 15 + 15 on 1 ray", || {
            render(&scene, &env, &kronander(1))
        })
        .entry("Owen-Sobol: 1 + 1 on 16 rays", || {
            render(&scene, &env, &sobol(1))
        })
        .run(ROUNDS);
        let error2 = |of: &dyn Fn(u32) -> RenderSettings| {
            let images = (1..=SEEDS).map(|seed| render(&scene, &env, &of(seed)));
            images
                .map(|image| mean_square(&image, &reference))
                .sum::<f64>()
                / f64::from(SEEDS)
        };
        let (a, b) = (error2(&kronander), error2(&sobol));
        let gain = a / b / scores[1].ratio;
        println!("  error² {a:.3e} and {b:.3e}; error² × time {gain:.2} times better");
        all.push(gain);
    }
    let mean = all.iter().sum::<f64>() / all.len() as f64;
    claim(
        &format!("{mean:.1} times as efficient on average, at least 4"),
        mean >= 4.0,
    );
}

fn settings(pattern: Pattern, rays_per_pixel: u32, samples: u32, seed: u32) -> RenderSettings {
    RenderSettings {
        size: SIZE,
        camera: camera(),
        rays_per_pixel,
        brdf_samples: samples,
        env_samples: samples,
        method: Method::Mis,
        pattern,
        filter: Filter::Centre,
        background: Background::Transparent,
        seed,
        frame: 0,
        exposure_ev: 0.0,
        tonemap: Tonemap::Srgb,
    }
}

fn render(scene: &SceneBuffers, env: &PreparedEnv, settings: &RenderSettings) -> Vec<Vec4> {
    let image = CpuRenderer::default().render_frame(scene, env, settings, &|_| ());
    image.expect("a frame").linear
}

/// Mean square of the relative difference of luminance, against the reference's mean so that no dark pixel rules.
fn mean_square(image: &[Vec4], reference: &[Vec4]) -> f64 {
    let luminance = |pixel: &Vec4| f64::from(glimt_sampling::luminance(pixel.truncate()));
    let mean = reference.iter().map(luminance).sum::<f64>() / reference.len() as f64;
    let pairs = image.iter().zip(reference);
    let squares = pairs.map(|(a, b)| ((luminance(a) - luminance(b)) / mean).powi(2));
    squares.sum::<f64>() / image.len() as f64
}
