//! Host file: the claim that Owen-scrambled Sobol points with 1 + 1 samples on each of 16 rays, the default, are at least 4 times
//! as efficient (error² × time) as the preset `kronander`, 15 + 15 independent samples on the ray through a pixel's
//! centre. A diffuse bunny on a plane under three maps.
//!
//! Told in two ways: as both are shipped, against the box-filtered image that a viewer wants, where one ray a pixel cannot
//! know what share of an edge pixel it sees; and for light alone, with all rays of both through the pixel's centre.

use glam::{UVec2, Vec4};
use glimt_benches::inputs::{bunny, light_maps};
use glimt_benches::scene::{camera, on_a_plane};
use glimt_benches::{Contest, claim};
use glimt_render_gpu::cpu::CpuRenderer;
use glimt_render_gpu::methods::Mis;
use glimt_render_gpu::prepare::env::PreparedEnv;
use glimt_render_gpu::prepare::render::{Background, Filter, Pattern, RenderSettings, Renderer};
use glimt_render_gpu::prepare::scene_build::SceneBuffers;

const SIZE: UVec2 = UVec2::new(128, 96);
/// Independent scramblings over which the error is averaged.
const SEEDS: u32 = 8;
const ROUNDS: usize = 5;

fn main() {
    let scene = SceneBuffers::build(&on_a_plane(&bunny())).expect("a scene");
    let mut gains = [Vec::new(), Vec::new()];
    for (name, map) in light_maps() {
        let env = map.prepare(0.0).expect("tables");
        let kronander = |seed| settings(Pattern::Independent, Filter::Centre, 1, 15, seed);
        for (filter, gains) in [Filter::Box, Filter::Centre].into_iter().zip(&mut gains) {
            let sobol = |seed| settings(Pattern::OwenSobol, filter, 16, 1, seed);
            let truth = settings(Pattern::OwenSobol, filter, 2048, 1, 1000);
            let truth = render(&scene, &env, &truth);
            let title = format!("{name}, {}×{}, {filter:?} filter", SIZE.x, SIZE.y);
            let scores = Contest::new(&title, "pixel", f64::from(SIZE.x * SIZE.y))
                .entry("kronander: 15 + 15 on 1 ray", || {
                    render(&scene, &env, &kronander(1))
                })
                .entry("Owen-Sobol: 1 + 1 on 16 rays", || {
                    render(&scene, &env, &sobol(1))
                })
                .run(ROUNDS);
            let error2 = |of: &dyn Fn(u32) -> RenderSettings| {
                let images = (1..=SEEDS).map(|seed| render(&scene, &env, &of(seed)));
                let errors = images.map(|image| mean_square(&image, &truth));
                errors.sum::<f64>() / f64::from(SEEDS)
            };
            let (a, b) = (error2(&kronander), error2(&sobol));
            let gain = a / b / scores[1].ratio;
            println!("  error² {a:.3e} and {b:.3e}; error² × time {gain:.2} times better");
            gains.push(gain);
        }
    }
    println!();
    for (what, gains) in ["as shipped", "light alone"].iter().zip(gains) {
        let mean = gains.iter().sum::<f64>() / gains.len() as f64;
        let text = format!("{what}: {mean:.1} times as efficient on average, at least 4");
        claim(&text, mean >= 4.0);
    }
}

fn settings(
    pattern: Pattern,
    filter: Filter,
    rays_per_pixel: u32,
    samples: u32,
    seed: u32,
) -> RenderSettings {
    RenderSettings {
        rays_per_pixel,
        method: Mis {
            brdf_samples: samples,
            env_samples: samples,
            compensation: pattern == Pattern::OwenSobol,
        }
        .into(),
        pattern,
        filter,
        background: Background::Transparent,
        seed,
        ..RenderSettings::new(SIZE, camera())
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
