//! Host file: steps of the sequential sampler on both processors, from the same stored state.
//!
//! Generators are equal whatever happens. A decision that depends on a float (a tooth of the comb, an acceptance) may fall
//! differently where its margin is below the float's tolerance: such particles are counted and bounded.

use std::sync::OnceLock;

use glimt_render_gpu::gpu::GpuContext;
use glimt_smc::is_log_zero;
use glimt_tests::gpu::adapter_or_skip;
use glimt_tests::sampler_sets::{Kernel, SHADER_SOURCE, SamplerShaders, Sets};
use glimt_tests::sampler_step::Plan;
use glimt_tests::shared_image::sampler::plan;
use glimt_tests::{golden, stats};
use naga_front_rust::Program;

const COUNT: usize = 2000;
const SIZE: usize = 8;
/// Share of particles whose decisions may fall differently in one step.
const DECISIONS: f64 = 1e-3;
/// States and weights, where the decisions are the same.
const STATES: f32 = 1e-4;

fn context() -> Option<&'static GpuContext> {
    static CONTEXT: OnceLock<Option<GpuContext>> = OnceLock::new();
    CONTEXT
        .get_or_init(|| adapter_or_skip("sampler_parity"))
        .as_ref()
}

fn program() -> Program {
    let sources = [&golden::SOURCES[..], &[SHADER_SOURCE]].concat();
    golden::program(&sources).unwrap_or_else(|error| panic!("{error}"))
}

fn run(kernel: Kernel, plan: &Plan, cpu: &mut Sets, gpu: &mut Sets, shaders: &SamplerShaders<'_>) {
    cpu.on_cpu(kernel, plan);
    gpu.on_gpu(shaders, kernel, plan)
        .unwrap_or_else(|error| panic!("{error}"));
}

/// How many particles differ, in state or in weight.
fn differing(a: &Sets, b: &Sets) -> usize {
    let differ = |(a, b): &(&glimt_smc::Particle, &glimt_smc::Particle)| {
        let weights = match (is_log_zero(a.log_weight), is_log_zero(b.log_weight)) {
            (false, false) => (a.log_weight - b.log_weight).abs() <= STATES * 8.0,
            (a, b) => a && b,
        };
        !(weights && (a.state - b.state).abs().max_element() <= STATES)
    };
    a.particles
        .iter()
        .zip(&b.particles)
        .filter(|pair| differ(pair))
        .count()
}

#[track_caller]
fn same_streams(a: &Sets, b: &Sets) {
    for (i, (a, b)) in a.outcomes.iter().zip(&b.outcomes).enumerate() {
        assert_eq!(
            a.stream, b.stream,
            "the generators of set {i} are out of step"
        );
    }
}

#[track_caller]
fn few_differ(a: &Sets, b: &Sets, what: &str) {
    let count = differing(a, b);
    let share = count as f64 / a.particles.len() as f64;
    println!("{what}: {count} of {} particles differ", a.particles.len());
    assert!(share <= DECISIONS, "{what}: {share}");
}

#[test]
fn the_same_items_are_picked() {
    let program = program();
    let Some(context) = context() else { return };
    let shaders = SamplerShaders::new(&program, context);
    for scheme in 0..4 {
        let mut cpu = Sets::new(COUNT, SIZE);
        let mut gpu = cpu.clone();
        run(
            Kernel::Ancestors,
            &plan(scheme, 0, 0),
            &mut cpu,
            &mut gpu,
            &shaders,
        );
        same_streams(&cpu, &gpu);
        few_differ(&cpu, &gpu, &format!("scheme {scheme}"));
        // Another scheme's picks are others.
        let mut other = Sets::new(COUNT, SIZE);
        other.on_cpu(Kernel::Ancestors, &plan((scheme + 1) % 4, 0, 0));
        assert!(differing(&other, &gpu) * 20 > other.particles.len());
    }
}

/// One step from the same sets: each scheme, both bridges, every k.
#[test]
fn a_step_is_the_same_step() {
    let program = program();
    let Some(context) = context() else { return };
    let shaders = SamplerShaders::new(&program, context);
    for scheme in 0..4 {
        for geometric in 0..2 {
            let mut cpu = Sets::new(COUNT, SIZE);
            let mut gpu = cpu.clone();
            run(
                Kernel::Start,
                &plan(scheme, geometric, 0),
                &mut cpu,
                &mut gpu,
                &shaders,
            );
            same_streams(&cpu, &gpu);
            few_differ(&cpu, &gpu, "start");
            let mut resampled = 0;
            for k in 1..=4 {
                // Both from what the CPU has stored.
                gpu = cpu.clone();
                run(
                    Kernel::Step,
                    &plan(scheme, geometric, k),
                    &mut cpu,
                    &mut gpu,
                    &shaders,
                );
                same_streams(&cpu, &gpu);
                few_differ(
                    &cpu,
                    &gpu,
                    &format!("scheme {scheme}, geometric {geometric}, k = {k}"),
                );
                let pairs = cpu.outcomes.iter().zip(&gpu.outcomes);
                let moves = pairs
                    .clone()
                    .filter(|(a, b)| a.accepted != b.accepted || a.resampled != b.resampled);
                let moves = moves.count();
                assert!(
                    moves as f64 <= DECISIONS * (COUNT * SIZE) as f64,
                    "{moves} sets decide otherwise"
                );
                for (a, b) in pairs {
                    assert!((a.log_ratio - b.log_ratio).abs() <= 1e-3, "{a:?} {b:?}");
                    assert!((a.ess - b.ess).abs() <= 2e-3 * a.ess, "{a:?} {b:?}");
                    resampled += a.resampled as usize;
                }
            }
            assert!(0 < resampled && resampled < 4 * COUNT, "{resampled}");
            // The sets before the step are others.
            gpu = cpu.clone();
            cpu.on_cpu(Kernel::Step, &plan(scheme, geometric, 4));
            assert!(differing(&cpu, &gpu) * 4 > cpu.particles.len());
        }
    }
}

/// Twenty steps of five frames, each processor going its own way: the normaliser's mean and that of the directions agree, and are
/// the truth.
#[test]
fn means_agree_over_twenty_steps() {
    let program = program();
    let Some(context) = context() else { return };
    let shaders = SamplerShaders::new(&program, context);
    for scheme in 0..4 {
        let mut sets = [Sets::new(COUNT, SIZE), Sets::new(COUNT, SIZE)];
        let mut logs = [vec![0.0f64; COUNT], vec![0.0f64; COUNT]];
        let mut last = plan(scheme, 0, 0);
        for frame in 0..=5 {
            // There and back again.
            let mut frame_plan = plan(scheme, u32::from(frame % 2 == 0), 0);
            if frame % 2 == 0 {
                std::mem::swap(&mut frame_plan.before, &mut frame_plan.now);
            }
            let steps = if frame == 0 {
                frame_plan.before = plan(scheme, 0, 0).before;
                vec![(Kernel::Start, 0)]
            } else {
                (1..=4).map(|k| (Kernel::Step, k)).collect()
            };
            for (kernel, k) in steps {
                frame_plan.k = k;
                let [cpu, gpu] = &mut sets;
                run(kernel, &frame_plan, cpu, gpu, &shaders);
                same_streams(cpu, gpu);
                for (sets, logs) in sets.iter().zip(&mut logs) {
                    for (log, outcome) in logs.iter_mut().zip(&sets.outcomes) {
                        *log += f64::from(outcome.log_ratio);
                    }
                }
            }
            last = frame_plan;
        }
        let truth = {
            let now = last.now.truncate();
            let gamma = |d: [f64; 3]| {
                let [x, y, z] = now.to_array().map(f64::from);
                let cosine = x * d[0] + y * d[1] + z * d[2];
                (0.05 + (6.0 * (cosine - 1.0)).exp()) * d[2]
            };
            let whole = glimt_tests::quadrature::integrate_hemisphere(gamma, 1e-9);
            let x = glimt_tests::quadrature::integrate_hemisphere(|d| gamma(d) * d[0], 1e-9);
            [whole.value, x.value]
        };
        let means = [0, 1].map(|processor| {
            let sets = sets[processor].particles.chunks(SIZE);
            let estimates: Vec<[f64; 2]> = sets
                .zip(&logs[processor])
                .map(|(set, log)| {
                    let x = |p: &glimt_smc::Particle| f64::from(p.weight() * p.state.x);
                    [log.exp(), log.exp() * set.iter().map(x).sum::<f64>()]
                })
                .collect();
            [0, 1].map(|i| stats::Mean::of(estimates.iter().map(|e| e[i])))
        });
        for i in 0..2 {
            let [cpu, gpu] = [means[0][i], means[1][i]];
            for (mean, name) in [(cpu, "CPU"), (gpu, "GPU")] {
                let alpha = stats::sidak(0.01, 16);
                stats::z_test(mean, truth[i], alpha)
                    .unwrap_or_else(|e| panic!("scheme {scheme}, {name}, {i}: {e}"));
            }
            // Nearly all decisions are the same, so the two differ by far less than either from the truth.
            let apart = (cpu.mean - gpu.mean).abs();
            println!(
                "scheme {scheme}, {i}: CPU {:.5}, GPU {:.5} ± {:.5}, truth {:.5}",
                cpu.mean, gpu.mean, cpu.standard_error, truth[i]
            );
            assert!(apart <= cpu.standard_error, "{cpu:?} {gpu:?}");
        }
    }
}
