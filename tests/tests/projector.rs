//! Host file: light maps projected by several threads, against the sum in f64.

use std::f64::consts::{PI, TAU};

use glam::{UVec2, Vec3, Vec4};
use glimt_render_gpu::prepare::projection::Projector;
use glimt_sampling::{UniformSource, Xoshiro128PlusPlus, unit_f32};
use glimt_sh::LightCoefficients;
use glimt_tests::harmonics::{harmonic, indices};
use glimt_tests::quadrature::direction;
use glimt_tests::worst::worst;

const SIZE: UVec2 = UVec2::new(404, 203);
const BANDS: u32 = 5;

fn random_map() -> Vec<[f32; 3]> {
    let mut source = Xoshiro128PlusPlus::stream(21, SIZE.x, SIZE.y);
    let mut number = || (6.0 * unit_f32(source.next_u32())).exp();
    (0..SIZE.x * SIZE.y)
        .map(|_| [number(), number(), number()])
        .collect()
}

/// `Σ L y ΔΩ` over the flux of the map, in f64.
fn by_formula(map: &[[f32; 3]]) -> (Vec<[f64; 3]>, f64) {
    let indices = indices(BANDS);
    let mut sums = vec![[0.0; 3]; indices.len()];
    let mut flux = 0.0;
    let theta = |edge: f64| PI * edge / f64::from(SIZE.y);
    for (i, texel) in (0..).zip(map) {
        let (x, y) = (f64::from(i % SIZE.x), f64::from(i / SIZE.x));
        let d = direction(
            theta(y + 0.5).cos(),
            PI - TAU * (x + 0.5) / f64::from(SIZE.x),
        );
        let area = TAU / f64::from(SIZE.x) * (theta(y).cos() - theta(y + 1.0).cos());
        flux += area * f64::from(texel[0].max(texel[1]).max(texel[2]));
        for (sum, &(l, m)) in sums.iter_mut().zip(&indices) {
            let weight = area * harmonic(l, m, d);
            for (sum, value) in sum.iter_mut().zip(texel) {
                *sum += weight * f64::from(*value);
            }
        }
    }
    (sums, flux)
}

/// The largest difference, relative to the flux of the map; NaN where there is one.
fn difference(found: &LightCoefficients, (exact, flux): &(Vec<[f64; 3]>, f64)) -> f64 {
    worst(found.iter().enumerate().flat_map(|(k, c)| {
        let exact = exact.get(k).copied().unwrap_or_default();
        (0..3).map(move |channel| (f64::from(c[channel]) - exact[channel]).abs() / flux)
    }))
}

#[test]
fn threads_change_no_bit() {
    let map = random_map();
    let fourth: Vec<Vec4> = map
        .iter()
        .map(|t| Vec3::from_array(*t).extend(1e9))
        .collect();
    let projector = Projector::new(SIZE, BANDS, 3).unwrap();
    assert_eq!((projector.size(), projector.bands()), (SIZE, BANDS));
    let found = projector.project(&map).unwrap();
    let one = rayon::ThreadPoolBuilder::new()
        .num_threads(1)
        .build()
        .unwrap();
    assert_eq!(one.install(|| projector.project(&map)).unwrap(), found);
    let exact = by_formula(&map);
    assert!(difference(&found, &exact) <= 1e-6);
    let wide = Projector::new(SIZE, BANDS, 4)
        .unwrap()
        .project_vec4(&fourth)
        .unwrap();
    assert!(difference(&wide, &exact) <= 1e-6);
    let mut wrong = found;
    wrong[7].y = f32::NAN;
    assert!(difference(&wrong, &exact).is_nan());
    assert!(projector.project(&map[1..]).is_err());
    assert!(projector.project_vec4(&fourth).is_err());
}
