//! Host file: every comparator and statistical test is fed a wrong input and must fail, and the right one and must pass.

use std::f64::consts::{FRAC_1_PI, PI};

use glam::{UVec2, Vec2, Vec3};
use glimt_probe::latlong;
use glimt_sampling::{UniformSource, Xoshiro128PlusPlus, unit_vec2, warp};
use glimt_statistics::quadrature::{
    Direction, Integral, integrate_band, integrate_hemisphere, integrate_sphere, integrate_texels,
};
use glimt_statistics::stats::{
    Mean, SphereBins, Verdict, chi_square, kolmogorov_smirnov, sidak, within, z_test,
};

const ALPHA: f64 = 0.01;

fn generator(key: u32) -> Xoshiro128PlusPlus {
    Xoshiro128PlusPlus::stream(11, 0, key)
}

fn to_f64(d: Vec3) -> Direction {
    [f64::from(d.x), f64::from(d.y), f64::from(d.z)]
}

#[track_caller]
fn passes(verdict: Verdict) {
    if let Err(evidence) = verdict {
        panic!("should pass: {evidence}");
    }
}

#[track_caller]
fn fails(verdict: Verdict) {
    if let Ok(evidence) = verdict {
        panic!("should fail: {evidence}");
    }
}

// --- Densities over the sphere ---

const BINS: SphereBins = SphereBins {
    rows: 16,
    columns: 32,
};

fn cosine_samples(n: usize) -> impl Iterator<Item = Option<Direction>> {
    let mut source = generator(0);
    (0..n).map(move |_| {
        let u = unit_vec2(source.next_uvec2());
        Some(to_f64(warp::sample_cosine_hemisphere(u).direction))
    })
}

#[test]
fn chi_square_sees_two_percent() {
    const N: usize = 2_000_000;
    let power = |d: Direction, e: f64| (e + 1.0) / (2.0 * PI) * d[2].max(0.0).powf(e);
    passes(BINS.chi_square(cosine_samples(N), |d| power(d, 1.0), ALPHA));
    // 2 % too much everywhere, too little everywhere, and 2 % in the exponent with the integral right.
    fails(BINS.chi_square(cosine_samples(N), |d| 1.02 * power(d, 1.0), ALPHA));
    fails(BINS.chi_square(cosine_samples(N), |d| 0.98 * power(d, 1.0), ALPHA));
    fails(BINS.chi_square(cosine_samples(N), |d| power(d, 1.02), ALPHA));
    // A ripple around the azimuth.
    let ripple = |d: Direction| power(d, 1.0) * (1.0 + 0.02 * (2.0 * d[1].atan2(d[0])).cos());
    fails(BINS.chi_square(cosine_samples(N), ripple, ALPHA));
}

#[test]
fn chi_square_sees_impossible_samples() {
    const N: usize = 100_000;
    let cosine = |d: Direction| d[2].max(0.0) * FRAC_1_PI;
    let with_gaps = |every: usize| {
        cosine_samples(N)
            .enumerate()
            .map(move |(i, d)| if i % every == 0 { None } else { d })
    };
    // A tenth is impossible, and the density says so.
    passes(BINS.chi_square(with_gaps(10), |d| 0.9 * cosine(d), ALPHA));
    fails(BINS.chi_square(with_gaps(10), cosine, ALPHA));
    fails(BINS.chi_square(with_gaps(9), |d| 0.9 * cosine(d), ALPHA));
    fails(BINS.chi_square(with_gaps(N), cosine, ALPHA));
}

#[test]
fn chi_square_sees_samples_where_there_should_be_none() {
    let cosine = |d: Direction| d[2].max(0.0) * FRAC_1_PI;
    let one_below = cosine_samples(10_000).chain([Some([0.0, 0.0, -1.0])]);
    fails(BINS.chi_square(one_below, cosine, ALPHA));
    for bad in [[f64::NAN; 3], [0.0; 3], [0.0, 0.0, 1.1]] {
        fails(BINS.chi_square(cosine_samples(10_000).chain([Some(bad)]), cosine, ALPHA));
    }
    fails(BINS.chi_square(cosine_samples(10_000), |_| f64::NAN, ALPHA));
    fails(BINS.chi_square(std::iter::empty(), cosine, ALPHA));
}

#[test]
fn chi_square_sees_bad_counts() {
    passes(chi_square(&[500, 490, 510], &[500.0; 3], ALPHA));
    fails(chi_square(&[600, 400, 500], &[500.0; 3], ALPHA));
    fails(chi_square(&[500, 500], &[500.0; 3], ALPHA));
    fails(chi_square(&[500, 500], &[500.0, f64::NAN], ALPHA));
    fails(chi_square(&[500, 500], &[1010.0, -10.0], ALPHA));
    fails(chi_square(&[500, 500], &[500.0, 510.0], ALPHA));
    fails(chi_square(&[], &[], ALPHA));
    fails(chi_square(&[1, 1], &[1.0, 1.0], ALPHA));
    // All in one cell is no freedom, and right.
    passes(chi_square(&[0, 1000], &[0.0, 1000.0], ALPHA));
    fails(chi_square(&[1, 999], &[0.0, 1000.0], ALPHA));
    // Many small cells are wrong together although each expects less than 5: they are pooled.
    let (mut observed, mut expected) = (vec![2u64; 1000], vec![1.0; 1000]);
    observed.push(8000);
    expected.push(9000.0);
    fails(chi_square(&observed, &expected, ALPHA));
}

/// The level is what it says: of many right inputs about 1 % fail at 0.01, and none at Šidák's level.
#[test]
fn levels_are_kept() {
    const RUNS: usize = 1000;
    let mut failures = [0; 3];
    let mut corrected = 0;
    for run in 0..RUNS {
        let mut source = generator(1000 + run as u32);
        let mut counts = vec![0u64; 64];
        let mut uniform = Vec::new();
        for _ in 0..2000 {
            let word = source.next_u32();
            counts[(word >> 26) as usize] += 1;
            uniform.push(f64::from(word) / 4_294_967_296.0);
        }
        let mean = Mean::of(uniform.iter().copied());
        let expected = vec![2000.0 / 64.0; 64];
        let mut judge = |alpha: f64| {
            [
                chi_square(&counts, &expected, alpha).is_err(),
                kolmogorov_smirnov(&mut uniform, |x| x, alpha).is_err(),
                z_test(mean, 0.5, alpha).is_err(),
            ]
        };
        for (count, failed) in failures.iter_mut().zip(judge(0.01)) {
            *count += usize::from(failed);
        }
        corrected += judge(sidak(0.01, 3 * RUNS))
            .into_iter()
            .filter(|failed| *failed)
            .count();
    }
    println!("of {RUNS} right inputs failed at 1 %: {failures:?}; at Šidák's level: {corrected}");
    // Binomial: mean 10, standard deviation 3.1.
    assert!(failures.iter().all(|count| (1..=22).contains(count)));
    assert_eq!(corrected, 0);
}

#[test]
fn sidak_is_sidak() {
    within(sidak(0.01, 1), 0.01, 1e-15).unwrap();
    within((1.0 - sidak(0.01, 100)).powi(100), 0.99, 1e-12).unwrap();
    assert_eq!(sidak(0.01, 0), sidak(0.01, 1));
}

// --- One dimension ---

#[test]
fn kolmogorov_smirnov_sees_two_percent() {
    let mut source = generator(1);
    let mut samples: Vec<f64> = (0..50_000)
        .map(|_| f64::from(source.next_u32()) / 4_294_967_296.0)
        .collect();
    passes(kolmogorov_smirnov(&mut samples, |x| x, ALPHA));
    fails(kolmogorov_smirnov(
        &mut samples,
        |x| (1.02 * x).min(1.0),
        ALPHA,
    ));
    fails(kolmogorov_smirnov(&mut samples, |x| x.powf(1.05), ALPHA));
    fails(kolmogorov_smirnov(&mut samples, |x| 1.0 - x, ALPHA));
    fails(kolmogorov_smirnov(&mut samples, |_| f64::NAN, ALPHA));
    fails(kolmogorov_smirnov(&mut samples[..4], |x| x, ALPHA));
    samples[7] = f64::NAN;
    fails(kolmogorov_smirnov(&mut samples, |x| x, ALPHA));
}

#[test]
fn z_test_sees_a_bias() {
    let mut source = generator(2);
    let values: Vec<f64> = (0..10_000)
        .map(|_| f64::from(source.next_u32()) / 4_294_967_296.0)
        .collect();
    let mean = Mean::of(values.iter().copied());
    within(mean.standard_error, (1.0f64 / 12.0).sqrt() / 100.0, 1e-4).unwrap();
    passes(z_test(mean, 0.5, ALPHA));
    // 3 % is ten standard errors here.
    fails(z_test(mean, 0.515, ALPHA));
    fails(z_test(mean, 0.485, ALPHA));
    fails(z_test(mean, f64::NAN, ALPHA));
    fails(z_test(
        Mean::of(values.iter().copied().chain([f64::NAN])),
        0.5,
        ALPHA,
    ));
    fails(z_test(
        Mean::of(values.iter().copied().chain([f64::INFINITY])),
        0.5,
        ALPHA,
    ));
    fails(z_test(Mean::of(values[..15].iter().copied()), 0.5, ALPHA));
    fails(z_test(Mean::of([]), 0.0, ALPHA));
    // Without spread only the value itself will do.
    passes(z_test(Mean::of([2.0; 20]), 2.0, ALPHA));
    passes(z_test(Mean::of([0.0; 20]), 0.0, ALPHA));
    fails(z_test(Mean::of([2.0; 20]), 2.000_001, ALPHA));
}

#[test]
fn within_lets_no_nan_pass() {
    passes(within(1.0, 1.1, 0.11));
    fails(within(1.0, 1.1, 0.09));
    fails(within(f64::NAN, 1.0, 1e9));
    fails(within(1.0, f64::NAN, 1e9));
    fails(within(1.0, 1.0, f64::NAN));
    fails(within(f64::INFINITY, f64::INFINITY, 1.0));
}

// --- A map of texels ---

const SIZE: UVec2 = UVec2::new(16, 8);

/// A map with structure in both directions.
fn weight(texel: UVec2) -> f64 {
    f64::from(1 + (texel.x * 7 + texel.y * 5 + texel.x * texel.y) % 11)
}

fn flux() -> f64 {
    (0..SIZE.x * SIZE.y)
        .map(|i| UVec2::new(i % SIZE.x, i / SIZE.x))
        .map(|texel| weight(texel) * f64::from(latlong::texel_solid_angle_sr(texel.y, SIZE)))
        .sum()
}

/// Density proportional to the map, looked up at the image point that `place` makes of the direction's own.
fn map_density(d: Direction, flux: f64, place: impl Fn(Vec2) -> Vec2) -> f64 {
    let uv = place(latlong::direction_to_uv(Vec3::new(
        d[0] as f32,
        d[1] as f32,
        d[2] as f32,
    )));
    let uv = Vec2::new(uv.x - uv.x.floor(), uv.y.clamp(0.0, 1.0));
    let texel = (uv * SIZE.as_vec2()).as_uvec2().min(SIZE - UVec2::ONE);
    weight(texel) / flux
}

/// Directions that follow the map: plain inversion in f64, uniform inside the texel.
fn map_samples(n: usize) -> impl Iterator<Item = Option<Direction>> {
    let mut source = generator(3);
    let total = flux();
    (0..n).map(move |_| {
        let mut rest = f64::from(source.next_u32()) / 4_294_967_296.0 * total;
        let mut chosen = SIZE - UVec2::ONE;
        for i in 0..SIZE.x * SIZE.y {
            let texel = UVec2::new(i % SIZE.x, i / SIZE.x);
            let mass = weight(texel) * f64::from(latlong::texel_solid_angle_sr(texel.y, SIZE));
            if rest < mass {
                chosen = texel;
                break;
            }
            rest -= mass;
        }
        Some(to_f64(latlong::direction_in_texel(
            chosen,
            SIZE,
            unit_vec2(source.next_uvec2()),
        )))
    })
}

/// Counts over half texels, whose edges are the map's, against the density at their centres times their area.
fn judge_map(place: impl Fn(Vec2) -> Vec2) -> Verdict {
    const N: usize = 400_000;
    let half = SIZE * 2;
    let mut observed = vec![0u64; (half.x * half.y) as usize];
    for d in map_samples(N).flatten() {
        let bin =
            latlong::direction_to_texel(Vec3::new(d[0] as f32, d[1] as f32, d[2] as f32), half);
        observed[(bin.y * half.x + bin.x) as usize] += 1;
    }
    let mut expected: Vec<f64> = (0..half.x * half.y)
        .map(|i| {
            let bin = UVec2::new(i % half.x, i / half.x);
            let centre = to_f64(latlong::texel_direction(bin, half));
            let area = f64::from(latlong::texel_solid_angle_sr(bin.y, half));
            map_density(centre, flux(), &place) * area
        })
        .collect();
    // Shapes are compared, also where the wrong placement changes the sum.
    let sum: f64 = expected.iter().sum();
    expected.iter_mut().for_each(|mass| *mass *= N as f64 / sum);
    chi_square(&observed, &expected, ALPHA)
}

#[test]
fn chi_square_sees_a_misplaced_map() {
    let texel = Vec2::ONE / SIZE.as_vec2();
    passes(judge_map(|uv| uv));
    fails(judge_map(|uv| uv + Vec2::new(0.5 * texel.x, 0.0)));
    fails(judge_map(|uv| uv - Vec2::new(0.5 * texel.x, 0.0)));
    fails(judge_map(|uv| uv + Vec2::new(0.0, 0.5 * texel.y)));
    fails(judge_map(|uv| Vec2::new(1.0 - uv.x, uv.y)));
    fails(judge_map(|uv| Vec2::new(uv.x, 1.0 - uv.y)));
    fails(judge_map(|uv| Vec2::new(uv.y, uv.x)));
    fails(judge_map(|uv| Vec2::new(uv.x + 0.5, uv.y)));
}

/// `sin θ` forgotten in the weights.
#[test]
fn chi_square_sees_a_forgotten_sine() {
    let bins = SphereBins {
        rows: 8,
        columns: 16,
    };
    let mut source = generator(4);
    let samples = (0..100_000).map(|_| {
        let uv = unit_vec2(source.next_uvec2());
        Some(to_f64(latlong::uv_to_direction(uv)))
    });
    fails(bins.chi_square(samples, |_| 0.25 * FRAC_1_PI, ALPHA));
}

// --- Quadrature ---

#[test]
fn quadrature_sees_two_percent() {
    let cosine = |d: Direction| d[2].max(0.0) * FRAC_1_PI;
    passes(within(integrate_hemisphere(cosine, 1e-9).value, 1.0, 1e-9));
    fails(within(
        integrate_hemisphere(|d| 1.02 * cosine(d), 1e-9).value,
        1.0,
        1e-3,
    ));
    // A density that forgets that it is per steradian.
    fails(within(
        integrate_sphere(|d| d[2].max(0.0), 1e-9).value,
        1.0,
        1e-3,
    ));
    fails(within(
        integrate_hemisphere(|_| f64::NAN, 1e-9).value,
        1.0,
        1e-3,
    ));
}

#[test]
fn quadrature_says_where_it_did_not_converge() {
    let step = |d: Direction| f64::from(u8::from(d[2] > 0.123_456));
    assert!(
        integrate_band(step, [0.0, 1.0], 1e-9)
            .converged(1e-9)
            .is_err()
    );
    assert!(
        Integral {
            value: 1.0,
            error: f64::NAN
        }
        .converged(1.0)
        .is_err()
    );
    assert!(
        Integral {
            value: f64::NAN,
            error: 0.0
        }
        .converged(1.0)
        .is_err()
    );
    // Cut at the step, it does.
    assert!(
        integrate_band(step, [0.123_456, 1.0], 1e-9)
            .converged(1e-9)
            .is_ok()
    );
}

/// The rule by texels: a map's own flux, and a lobe far narrower than a texel.
#[test]
fn texels_are_subdivided_until_stable() {
    let size = [SIZE.x, SIZE.y];
    let sum = integrate_texels(size, |t, _| weight(UVec2::new(t[0], t[1])), 1e-9);
    within(sum.converged(1e-8).unwrap() / flux(), 1.0, 1e-6).unwrap();
    let axis = to_f64(Vec3::new(0.3, -0.5, 0.4).normalize());
    let lobe = |d: Direction| {
        let cosine = axis[0] * d[0] + axis[1] * d[1] + axis[2] * d[2];
        501.0 / (2.0 * PI) * cosine.max(0.0).powf(500.0)
    };
    for size in [[1, 1], [3, 2], [64, 32]] {
        let whole = integrate_texels(size, |_, d| lobe(d), 1e-6);
        within(whole.converged(1e-5).unwrap(), 1.0, 1e-5).unwrap();
    }
    // The texel that a direction is given with is the one it lies in.
    let mixed = integrate_texels(
        size,
        |t, d| {
            let own =
                latlong::direction_to_texel(Vec3::new(d[0] as f32, d[1] as f32, d[2] as f32), SIZE);
            f64::from(u8::from([own.x, own.y] == t))
        },
        1e-6,
    );
    within(mixed.value, 4.0 * PI, 1e-5).unwrap();
}
