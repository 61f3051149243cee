//! Host file: frames by precomputed transfer, for the probes of Hajisharif 2012, Table 2: the whole path from the light map to the
//! composite, its parts, and the projection against a plain copy of the map.
//!
//! `GLIMT_BENCH_SIZE=2400x1700` draws as large as the paper's capture; the default suits a software adapter. The transfer is that
//! of convex surfaces, in closed form: a frame's time does not hang on its values.

use std::hint::black_box;
use std::sync::Arc;
use std::time::Instant;

use glam::{UVec2, Vec4};
use glimt_benches::inputs::{bunny, procedural_map};
use glimt_benches::scene::{camera, on_a_plane};
use glimt_benches::{Contest, claim};
use glimt_render_gpu::cpu::CpuDrawing;
use glimt_render_gpu::gpu::{AdapterPreference, GpuContext, GpuDrawing, GpuLight};
use glimt_render_gpu::methods::Prt;
use glimt_render_gpu::prepare::env::{EnvMap, PreparedEnv};
use glimt_render_gpu::prepare::light_sh::LightSh;
use glimt_render_gpu::prepare::render::{Filter, RenderSettings, Renderer};
use glimt_render_gpu::prepare::scene_build::SceneBuffers;
use glimt_render_gpu::prepare::transfer::Transfer;

/// Bands, as many as there are.
const BANDS: u32 = 6;
const PROBE: UVec2 = UVec2::new(1628, 814);
/// Frames that are handed over before anyone waits.
const FRAMES: u32 = 8;
const ROUNDS: usize = 5;

fn main() {
    let mut gpu = match GpuContext::new(AdapterPreference::Fastest).and_then(GpuDrawing::on) {
        Ok(gpu) => gpu,
        Err(error) => {
            println!("skipped: {error}");
            return;
        }
    };
    let mut cpu = CpuDrawing::default();
    println!("{} and {}", cpu.name(), gpu.name());
    let scene = scene();
    let env = probe(PROBE);
    projection(&gpu, &env);
    frames(&mut gpu, &mut cpu, &scene, &env);
}

fn settings(level: u32) -> RenderSettings {
    let size = std::env::var("GLIMT_BENCH_SIZE").ok().and_then(|text| {
        let (width, height) = text.split_once('x')?;
        Some(UVec2::new(width.parse().ok()?, height.parse().ok()?))
    });
    RenderSettings {
        prt: Prt {
            level,
            window: 6.0,
            temporal: 0.2,
            ..Prt::default()
        },
        rays_per_pixel: 4,
        ..RenderSettings::new(size.unwrap_or(UVec2::new(600, 425)), camera())
    }
}

fn scene() -> SceneBuffers {
    let mut scene = SceneBuffers::build(&on_a_plane(&bunny())).expect("a scene");
    let vertices = scene.vertices().expect("vertices");
    let coefficients = |normal| {
        let y = glimt_sh::basis(normal);
        (0..BANDS * BANDS)
            .map(move |k| glimt_sh::cosine_lobe(glimt_sh::coefficient_band(k)) * y[k as usize])
    };
    let lit: Vec<f32> = vertices
        .iter()
        .flat_map(|vertex| coefficients(vertex.normal))
        .collect();
    println!(
        "{} vertices, {} faces, {BANDS} bands",
        vertices.len(),
        scene.view().triangles.len()
    );
    let transfer = Transfer {
        bands: BANDS,
        blocked: vec![0.0; lit.len()],
        lit,
    };
    let set = scene.set_transfer(Arc::new(transfer), &[]);
    set.expect("a transfer that fits");
    scene
}

fn probe(size: UVec2) -> PreparedEnv {
    let texels = procedural_map(size);
    let texels = texels.iter().map(|&[r, g, b]| Vec4::new(r, g, b, 1.0));
    let map = EnvMap::new(size, texels.collect()).expect("a map");
    map.without_tables(20.0).expect("a size that maps have")
}

/// The projection of the whole map, against a copy of it, both on the GPU, and against the CPU's.
fn projection(gpu: &GpuDrawing, env: &PreparedEnv) {
    let context = gpu.context();
    let settings = settings(0).prt;
    let mut light = GpuLight::new(context, PROBE).expect("room for a map");
    light.upload(context, env).expect("an upload");
    light
        .project(context, BANDS, &settings)
        .expect("a projection");
    let found = light.read(context).expect("coefficients");
    let mut own = LightSh::default();
    let expected = own.project(env, BANDS, &settings).expect("coefficients");
    let largest = expected
        .iter()
        .map(|c| c.abs().max_element())
        .fold(0.0, f32::max);
    let off = found
        .iter()
        .zip(&expected)
        .map(|(a, b)| (*a - *b).abs().max_element());
    let off = off.fold(0.0, f32::max) / largest;
    println!("coefficients of both processors differ by {off:.1e} of the largest");

    let texels = env.view().texels;
    let bytes = size_of_val(texels) as u64;
    let from = context.buffer_of("map", texels).expect("a buffer");
    let to = context.buffer("copy", bytes).expect("a buffer");
    let mut copied = texels.to_vec();
    let title = format!("{PROBE} onto {BANDS} bands, {FRAMES} times");
    let work = f64::from(PROBE.element_product() * FRAMES);
    let scores = Contest::new(&title, "texel", work)
        .entry("GPU: a copy of the map", || {
            for _ in 0..FRAMES {
                context.copy(&from, &to, bytes).expect("a copy");
            }
            context.finish().expect("an end");
        })
        .entry("GPU: its projection", || {
            for _ in 0..FRAMES {
                light
                    .project(context, BANDS, &settings)
                    .expect("a projection");
            }
            context.finish().expect("an end");
        })
        .entry("CPU: a copy of the map", || {
            for _ in 0..FRAMES {
                black_box(&mut copied).copy_from_slice(black_box(texels));
            }
        })
        .entry("CPU: its projection", || {
            (0..FRAMES)
                .map(|_| own.project(env, BANDS, &settings).expect("coefficients")[0])
                .sum::<Vec4>()
        })
        .run(ROUNDS);
    for pair in scores.chunks(2) {
        // A copy reads and writes.
        let moved = 2.0 * bytes as f64 * f64::from(FRAMES) / pair[0].median.as_secs_f64();
        let read = bytes as f64 * f64::from(FRAMES) / pair[1].median.as_secs_f64();
        println!(
            "  {}: reads {:.2} GB/s, {:.0} % of a copy's {:.2} GB/s",
            pair[1].name,
            1e-9 * read,
            100.0 * read / moved,
            1e-9 * moved
        );
    }
}

/// Frames per second for each probe of the table.
fn frames(gpu: &mut GpuDrawing, cpu: &mut CpuDrawing, scene: &SceneBuffers, env: &PreparedEnv) {
    let mut one = settings(0);
    one.rays_per_pixel = 1;
    one.filter = Filter::Centre;
    let on_cpu = cpu
        .render_frame(scene, env, &one, &|_| ())
        .expect("a frame");
    let on_gpu = gpu
        .render_frame(scene, env, &one, &|_| ())
        .expect("a frame");
    let pairs = on_cpu.linear.iter().zip(&on_gpu.linear);
    let far =
        pairs.filter(|(a, b)| (**a - **b).abs().max_element() > 3e-3 * a.max_element().max(1.0));
    println!(
        "\n{} of {} pixels differ from the CPU's by more than 0.3 %",
        far.count(),
        on_cpu.linear.len()
    );

    println!(
        "\nframes of {} on the GPU, {FRAMES} at a time, 4 samples a pixel: the map halved to the probe's size, or of that size",
        one.size
    );
    println!(
        "  {:<12} {:>10} {:>10} {:>10}   {:>9} {:>9} {:>9} {:>9}",
        "probe", "halved/s", "of size/s", "CPU/s", "upload", "light", "draw", "read back"
    );
    let mut size = PROBE;
    let mut rates = Vec::new();
    for level in 0..6 {
        let (whole, half) = (settings(level), settings(0));
        let small = probe(size);
        let mut seconds = [Vec::new(), Vec::new(), Vec::new()];
        // The first round warms up.
        for round in 0..=ROUNDS {
            let mut times = [0.0; 3];
            for turn in 0..3 {
                let who = (turn + round) % 3;
                let start = Instant::now();
                let frames = if who == 2 { 1 } else { FRAMES };
                for _ in 0..frames {
                    match who {
                        0 => gpu.draw_over(scene, env, None, &whole),
                        1 => gpu.draw_over(scene, &small, None, &half),
                        _ => cpu
                            .render_frame(
                                scene,
                                env,
                                &RenderSettings {
                                    prt: whole.prt,
                                    ..one
                                },
                                &|_| (),
                            )
                            .map(drop),
                    }
                    .expect("a frame");
                }
                gpu.context().finish().expect("an end");
                times[who] = start.elapsed().as_secs_f64() / f64::from(frames);
            }
            if round > 0 {
                for (all, time) in seconds.iter_mut().zip(times) {
                    all.push(time);
                }
            }
        }
        let rate = seconds.map(|mut all| {
            all.sort_by(f64::total_cmp);
            1.0 / all[all.len() / 2]
        });
        gpu.render_frame(scene, env, &whole, &|_| ())
            .expect("a frame");
        let phases: Vec<String> = gpu
            .phases()
            .iter()
            .map(|(_, time)| format!("{:>6.1} ms", 1e3 * time.as_secs_f64()))
            .collect();
        println!(
            "  {:<12} {:>10.1} {:>10.1} {:>10.1}   {}",
            format!("{}×{}", size.x, size.y),
            rate[0],
            rate[1],
            rate[2],
            phases.join(" ")
        );
        rates.push(rate[0]);
        size = glimt_render_gpu::kernels::pyramid::half_size(size);
    }
    claim(
        "30 frames per second with the whole probe, where the paper has 9",
        rates[0] >= 30.0,
    );
}
