//! Host file: a frame's light by precomputed transfer: maps halved, projected, turned, windowed, filtered.

use glam::{DVec3, UVec2, Vec3, Vec4};
use glimt_probe::latlong::{texel_direction, texel_solid_angle_sr};
use glimt_probe::rotate::rotate_z;
use glimt_render_gpu::kernels::pyramid::{Taps, half_size, halve, taps};
use glimt_render_gpu::methods::Prt;
use glimt_render_gpu::prepare::env::{EnvMap, PreparedEnv};
use glimt_render_gpu::prepare::light_sh::LightSh;
use glimt_tests::light::noise;
use glimt_tests::worst::largest_share;

/// Sizes that are multiples of nothing, and the smallest.
const SIZES: [UVec2; 9] = [
    UVec2::new(64, 32),
    UVec2::new(101, 50),
    UVec2::new(97, 53),
    UVec2::new(50, 25),
    UVec2::new(7, 3),
    UVec2::new(5, 1),
    UVec2::new(1, 9),
    UVec2::new(3, 2),
    UVec2::ONE,
];

/// A map with a broad sun, and little that changes within a texel of the smallest of maps.
fn smooth(size: UVec2) -> Vec<Vec4> {
    let sun = Vec3::new(0.6, -0.48, 0.64);
    let texel = |i: u32| {
        let d = texel_direction(UVec2::new(i % size.x, i / size.x), size);
        let lobe = (8.0 * (d.dot(sun) - 1.0)).exp();
        Vec4::new(0.2 + 5.0 * lobe, 0.3 + 4.0 * lobe, 0.5 + 0.2 * d.z, 1.0)
    };
    (0..size.x * size.y).map(texel).collect()
}

fn prepared(size: UVec2, texels: Vec<Vec4>, degrees: f32) -> PreparedEnv {
    let map = EnvMap::new(size, texels).unwrap();
    map.prepare(degrees).unwrap()
}

fn all_taps(size: UVec2) -> Vec<Taps> {
    let half = half_size(size);
    (0..half.x + half.y).map(|i| taps(i, size)).collect()
}

fn halved(size: UVec2, texels: &[Vec4]) -> (UVec2, Vec<Vec4>) {
    let (half, taps) = (half_size(size), all_taps(size));
    let texels = (0..half.x * half.y).map(|i| halve(i, size, &taps, texels));
    (half, texels.collect())
}

fn flux(size: UVec2, texels: &[Vec4]) -> f64 {
    let each = texels.iter().zip(0..);
    each.map(|(t, i)| f64::from(t.x) * f64::from(texel_solid_angle_sr(i / size.x, size)))
        .sum()
}

#[test]
fn constant_maps_stay_constant() {
    for mut size in SIZES {
        let mut texels = vec![Vec4::new(3.0, 0.1, 700.0, 1.0); (size.x * size.y) as usize];
        loop {
            let before = size;
            (size, texels) = halved(size, &texels);
            for t in &texels {
                let off = (*t / Vec4::new(3.0, 0.1, 700.0, 1.0) - Vec4::ONE).abs();
                assert!(off.max_element() < 2e-6, "{before} → {size}: {t}");
            }
            if size == UVec2::ONE {
                break;
            }
        }
    }
}

/// The largest share of its flux that a texel gains or loses when the map is halved, over texels everywhere.
fn largest_loss(size: UVec2, halve: impl Fn(u32, UVec2, &[Vec4]) -> Vec4) -> f64 {
    let half = half_size(size);
    let mut largest = 0.0f64;
    for row in [0, 1, size.y / 2, size.y - 1] {
        for column in [0, size.x / 3, size.x - 1] {
            let mut texels = vec![Vec4::ZERO; (size.x * size.y) as usize];
            texels[(row.min(size.y - 1) * size.x + column) as usize] = Vec4::ONE;
            let after: Vec<Vec4> = (0..half.x * half.y)
                .map(|i| halve(i, size, &texels))
                .collect();
            let (before, after) = (flux(size, &texels), flux(half, &after));
            largest = largest.max((after / before - 1.0).abs());
        }
    }
    largest
}

#[test]
fn flux_of_each_texel_is_kept() {
    for size in SIZES.into_iter().chain([UVec2::new(407, 203)]) {
        let taps = all_taps(size);
        let loss = largest_loss(size, |i, size, texels| halve(i, size, &taps, texels));
        assert!(loss < 1e-5, "{size}: {loss:e}");
    }
    // Texels weighed alike, as in an image: at the poles that is not light.
    let plain = |i: u32, size: UVec2, texels: &[Vec4]| {
        let (x, y) = (i % (size.x / 2), i / (size.x / 2));
        let at = |dx: u32, dy: u32| texels[((2 * y + dy) * size.x + 2 * x + dx) as usize];
        0.25 * (at(0, 0) + at(1, 0) + at(0, 1) + at(1, 1))
    };
    assert!(largest_loss(UVec2::new(64, 32), plain) > 0.3);
}

/// Coefficients by the definition, in f64.
fn reference(env: &PreparedEnv, bands: u32) -> [DVec3; 36] {
    let map = env.view().map();
    let mut sums = [DVec3::ZERO; 36];
    for (i, texel) in map.texels.iter().enumerate() {
        let place = UVec2::new(i as u32 % map.size.x, i as u32 / map.size.x);
        let d = rotate_z(texel_direction(place, map.size), map.rotation);
        let area = f64::from(texel_solid_angle_sr(place.y, map.size));
        let y = glimt_sh::basis(d);
        for k in 0..(bands * bands) as usize {
            sums[k] += texel.truncate().as_dvec3() * f64::from(y[k]) * area;
        }
    }
    sums
}

/// The largest difference of two lists, as a share of the largest coefficient; without end where one is no number.
fn difference(a: &[DVec3], b: &[DVec3]) -> f64 {
    let pairs = a.iter().zip(b);
    largest_share(pairs.map(|(a, b)| (a.extend(0.0), b.extend(0.0))))
}

fn wide(c: &[Vec4; 36]) -> [DVec3; 36] {
    c.map(|c| c.truncate().as_dvec3())
}

fn plain(level: u32) -> Prt {
    Prt {
        level,
        ..Prt::default()
    }
}

#[test]
fn projection_is_the_definition() {
    for (size, degrees) in SIZES
        .into_iter()
        .zip([0.0, 90.0, 33.0, -171.0, 5.0].into_iter().cycle())
    {
        let env = prepared(size, noise(size, 1), degrees);
        for bands in 1..=6 {
            let found = LightSh::default().project(&env, bands, &plain(0)).unwrap();
            let off = difference(&wide(&found), &reference(&env, bands));
            assert!(off < 3e-6, "{size} {bands} bands: {off:e}");
        }
        let turned = prepared(size, noise(size, 1), degrees + 1.0);
        let off = difference(&reference(&turned, 6), &reference(&env, 6));
        assert!(size.x == 1 || off > 1e-5, "{size}: a degree is seen");
    }
}

#[test]
fn low_bands_survive_being_halved() {
    let size = UVec2::new(1628, 814);
    let env = prepared(size, smooth(size), 20.0);
    let exact = wide(&LightSh::default().project(&env, 6, &plain(0)).unwrap());
    for (level, bound) in [(1, 4e-5), (2, 2e-4), (3, 1e-3), (4, 5e-3), (5, 2e-2)] {
        let found = LightSh::default().project(&env, 6, &plain(level)).unwrap();
        let off = difference(&wide(&found), &exact);
        println!("level {level}: {off:e} of the largest coefficient");
        assert!(off < bound, "level {level}: {off:e}");
    }
}

#[test]
fn levels_end_at_one_texel() {
    let size = UVec2::new(37, 18);
    let env = prepared(size, noise(size, 2), 0.0);
    let map = env.view().map();
    let mut light = LightSh::default();
    assert_eq!(light.level(&map, 2).0, UVec2::new(9, 4));
    let (size, texels) = light.level(&map, 31);
    assert_eq!((size, texels.len()), (UVec2::ONE, 1));
    // The mean over the sphere.
    let mean =
        reference(&env, 1)[0] / (4.0 * std::f64::consts::PI * f64::from(glimt_sh::basis::Y_00));
    assert!((f64::from(texels[0].x) / mean.x - 1.0).abs() < 1e-5);
}

#[test]
fn window_turn_and_filter_over_time() {
    let size = UVec2::new(61, 30);
    let settings = Prt {
        window: 4.0,
        temporal: 0.5,
        ..plain(0)
    };
    let mut light = LightSh::default();
    let mut expected = [DVec3::ZERO; 36];
    for frame in 0..3 {
        let env = prepared(size, noise(size, frame), 40.0 * frame as f32);
        let found = light.project(&env, 4, &settings).unwrap();
        let now = reference(&env, 4);
        for (k, expected) in expected.iter_mut().enumerate() {
            let window = f64::from(glimt_sh::hann((k as f32).sqrt() as u32, 4.0));
            let now = now[k] * window;
            *expected = if frame == 0 {
                now
            } else {
                (now + *expected * 0.5) / 1.5
            };
        }
        let off = difference(&wide(&found), &expected);
        assert!(off < 3e-6, "frame {frame}: {off:e}");
    }
    // Another number of bands resets the filter.
    let env = prepared(size, noise(size, 9), 0.0);
    let settings = Prt {
        temporal: 0.5,
        ..plain(0)
    };
    let found = light.project(&env, 2, &settings).unwrap();
    assert!(difference(&wide(&found), &reference(&env, 2)) < 3e-6);
}
