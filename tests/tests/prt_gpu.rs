//! Host file: frames by precomputed transfer on the GPU: the CPU's coefficients and pictures, without a stall.

use glam::{UVec2, Vec4};
use glimt_render_gpu::gpu::{GpuContext, GpuLight};
use glimt_render_gpu::host::env::{EnvMap, PreparedEnv};
use glimt_render_gpu::host::light_sh::LightSh;
use glimt_render_gpu::host::render::PrtSettings;
use glimt_tests::gpu::adapter_or_skip;

/// A map like noise, with a small sun.
fn noise(size: UVec2, seed: u32, degrees: f32) -> PreparedEnv {
    let texel = |i: u32| {
        let word = glimt_sampling::hash::hash3(seed, i, 7);
        let part = |shift: u32| ((word >> shift) & 0xff) as f32 / 255.0;
        let sun = if i == size.x * size.y / 3 { 1e3 } else { 0.0 };
        Vec4::new(part(0) + sun, part(8) + sun, part(16) + 0.5 * sun, 1.0)
    };
    let texels = (0..size.x * size.y).map(texel).collect();
    EnvMap::new(size, texels)
        .unwrap()
        .untabled(degrees)
        .unwrap()
}

/// The largest difference of two lists, as a share of the largest coefficient.
fn difference(a: &[Vec4], b: &[Vec4]) -> f32 {
    let largest = b.iter().map(|c| c.abs().max_element()).fold(0.0, f32::max);
    let off = a.iter().zip(b).map(|(a, b)| (*a - *b).abs().max_element());
    off.fold(0.0, f32::max) / largest
}

fn coefficients(
    context: &GpuContext,
    light: &mut GpuLight,
    env: &PreparedEnv,
    bands: u32,
    settings: &PrtSettings,
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
                let settings = PrtSettings {
                    level,
                    window: [0.0, 3.5][(bands % 2) as usize],
                    temporal: 0.4,
                    ..PrtSettings::default()
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
    let right = PrtSettings {
        window: 4.0,
        temporal: 0.4,
        ..PrtSettings::default()
    };
    let expected = LightSh::default().project(&env, 4, &right).unwrap();
    let wrong = [
        (noise(UVec2::new(131, 67), 1, 10.1), right),
        (noise(UVec2::new(131, 67), 2, 10.0), right),
        (
            env.clone(),
            PrtSettings {
                window: 4.01,
                ..right
            },
        ),
        (env.clone(), PrtSettings { level: 1, ..right }),
    ];
    for (env, settings) in wrong {
        light.forget();
        let found = coefficients(&context, &mut light, &env, 4, &settings);
        assert!(difference(&found, &expected) > TOLERANCE);
    }
    let found = coefficients(&context, &mut light, &env, 4, &right);
    assert!(difference(&found, &expected) > TOLERANCE, "nothing is kept");
}

#[test]
fn a_large_map_has_many_parts() {
    let Some(context) = adapter_or_skip("a_large_map_has_many_parts") else {
        return;
    };
    let env = noise(UVec2::new(1628, 814), 5, 15.0);
    let mut light = GpuLight::new(&context, UVec2::new(1628, 814)).unwrap();
    for level in [0, 2] {
        let settings = PrtSettings {
            level,
            ..PrtSettings::default()
        };
        let expected = LightSh::default().project(&env, 6, &settings).unwrap();
        let found = coefficients(&context, &mut light, &env, 6, &settings);
        let off = difference(&found, &expected);
        assert!(off < TOLERANCE, "level {level}: {off:e}");
    }
}
