//! Host file: the generated WGSL against the same functions on the CPU: the largest difference of the two images, and
//! frames per second.
//!
//! `GLIMT_BENCH_SIZE=1920x1080 GLIMT_BENCH_SAMPLES=15` renders as large and with as many samples as a video wants; the
//! default suits a software adapter.

use glam::{UVec2, Vec4};
use glimt_benches::Contest;
use glimt_benches::inputs::{bunny, light_maps};
use glimt_benches::scene::{camera, on_a_plane};
use glimt_render_gpu::cpu::CpuRenderer;
use glimt_render_gpu::gpu::{AdapterPreference, GpuRenderer};
use glimt_render_gpu::methods::Mis;
use glimt_render_gpu::prepare::render::{RenderSettings, Renderer};
use glimt_render_gpu::prepare::scene_build::SceneBuffers;

fn main() {
    let mut gpu = match GpuRenderer::new(AdapterPreference::Fastest) {
        Ok(gpu) => gpu,
        Err(error) => {
            println!("skipped: {error}");
            return;
        }
    };
    let settings = settings();
    let scene = SceneBuffers::build(&on_a_plane(&bunny())).expect("a scene");
    let (name, map) = light_maps().swap_remove(0);
    let env = map.prepare(0.0).expect("tables");
    let mut cpu = CpuRenderer::default();
    println!("{} and {}", cpu.name(), gpu.name());

    let on_cpu = cpu
        .render_frame(&scene, &env, &settings, &|_| ())
        .expect("a frame")
        .linear;
    let on_gpu = gpu
        .render_frame(&scene, &env, &settings, &|_| ())
        .expect("a frame")
        .linear;
    compare(&on_cpu, &on_gpu);

    let UVec2 { x, y } = settings.size;
    let title = format!(
        "{name}, a frame of {x}×{y}, {} rays a pixel with {} samples",
        settings.rays_per_pixel,
        settings.method.describe()
    );
    let scores = Contest::new(&title, "pixel", f64::from(x * y))
        .entry("rayon", || {
            cpu.render_frame(&scene, &env, &settings, &|_| ())
        })
        .entry("wgpu", || {
            gpu.render_frame(&scene, &env, &settings, &|_| ())
        })
        .run(5);
    for score in scores {
        println!(
            "  {}: {:.2} frames/s",
            score.name,
            1.0 / score.median.as_secs_f64()
        );
    }
    let times = gpu.times();
    println!(
        "  of the last frame on the GPU: upload {:.1?}, rays {:.1?} ({:.1?} by its own clock), film {:.1?}, read back {:.1?}",
        times.upload, times.shade.wall, times.shade.gpu, times.film.wall, times.read_back
    );
}

fn settings() -> RenderSettings {
    let number = |name: &str| std::env::var(name).ok().and_then(|text| text.parse().ok());
    let size = std::env::var("GLIMT_BENCH_SIZE").ok().and_then(|text| {
        let (width, height) = text.split_once('x')?;
        Some(UVec2::new(width.parse().ok()?, height.parse().ok()?))
    });
    let samples: Option<u32> = number("GLIMT_BENCH_SAMPLES");
    RenderSettings {
        rays_per_pixel: if samples.is_some() { 1 } else { 4 },
        method: Mis {
            brdf_samples: samples.unwrap_or(1),
            env_samples: samples.unwrap_or(1),
            ..Mis::default()
        }
        .into(),
        ..RenderSettings::new(size.unwrap_or(UVec2::new(320, 240)), camera())
    }
}

fn compare(cpu: &[Vec4], gpu: &[Vec4]) {
    let mean = |image: &[Vec4]| {
        let sum: f64 = image
            .iter()
            .map(|p| f64::from(p.truncate().element_sum()))
            .sum();
        sum / image.len() as f64
    };
    let pairs = || cpu.iter().zip(gpu);
    let largest = pairs()
        .map(|(a, b)| (*a - *b).abs().max_element())
        .fold(0.0, f32::max);
    let far =
        pairs().filter(|(a, b)| (**a - **b).abs().max_element() > 1e-3 * a.max_element().max(1.0));
    println!(
        "largest difference {largest:.3e} at a mean of {:.3}; {} of {} pixels differ by more than 0.1 %; energy by {:.4} %",
        mean(cpu) / 3.0,
        far.count(),
        cpu.len(),
        100.0 * (mean(gpu) / mean(cpu) - 1.0)
    );
}
