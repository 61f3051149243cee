//! Host file: MIS compensation is unbiased beside another strategy, better than plain tables there, and useless alone.

use std::f64::consts::PI;

use glam::{UVec2, Vec3};
use glimt_envmap_cdf::{
    CompensatedCdf, EnvCdf, build_compensated_into, build_into, build_marginal_into,
    build_row_into, compensated_weight, mean_weight, required_len,
};
use glimt_probe::latlong::{direction_to_texel, texel_solid_angle_sr};
use glimt_sampling::mis::multi_sample_density;
use glimt_sampling::warp::{pdf_cosine_hemisphere_sr, sample_cosine_hemisphere};
use glimt_sampling::{UniformSource, Xoshiro128PlusPlus, unit_vec2};
use glimt_statistics::quadrature::integrate_texels;
use glimt_statistics::stats::{Mean, within, z_test};

const SIZE: UVec2 = UVec2::new(16, 8);
const ALPHA: f64 = 0.01;

/// A bright sky, a dim ground, a lamp.
fn weight(x: u32, y: u32) -> f32 {
    if [x, y] == [5, 2] {
        40.0
    } else if y < 4 {
        1.0 + (x % 3) as f32
    } else {
        0.2
    }
}

fn row(y: u32) -> impl ExactSizeIterator<Item = f32> {
    (0..SIZE.x as usize).map(move |x| weight(x as u32, y))
}

struct Tables {
    marginal: Vec<u32>,
    conditional: Vec<u32>,
}

impl Tables {
    fn empty() -> Self {
        let len = required_len(SIZE.x, SIZE.y).unwrap();
        Self {
            marginal: vec![0; len.marginal],
            conditional: vec![0; len.conditional],
        }
    }

    fn plain() -> Self {
        let mut tables = Self::empty();
        build_into(SIZE, row, &mut tables.marginal, &mut tables.conditional).unwrap();
        tables
    }

    fn compensated() -> Self {
        let mut tables = Self::empty();
        build_compensated_into(SIZE, row, &mut tables.marginal, &mut tables.conditional).unwrap();
        tables
    }

    fn view(&self) -> CompensatedCdf<'_> {
        CompensatedCdf::new(SIZE, &self.marginal, &self.conditional).unwrap()
    }
}

/// Irradiance of an upward plane, by quadrature.
fn irradiance() -> f64 {
    let f = |[x, y]: [u32; 2], d: [f64; 3]| f64::from(weight(x, y)) * d[2].max(0.0);
    integrate_texels(SIZE.to_array(), f, 1e-7).value
}

fn radiance_cosine(texel: UVec2, d: Vec3) -> f64 {
    f64::from(weight(texel.x, texel.y) * d.z.max(0.0))
}

/// Estimates of the irradiance from one sample of the cosine and `n_env` of the compensated table.
fn compensated_estimates(n_env: u32, n: usize) -> impl Iterator<Item = f64> {
    let tables = Tables::compensated();
    let mut source = Xoshiro128PlusPlus::stream(4, 0, n_env);
    (0..n).map(move |_| {
        let env = tables.view();
        let d = sample_cosine_hemisphere(unit_vec2(source.next_uvec2())).direction;
        let texel = direction_to_texel(d, SIZE);
        let factor = env.balance_factor(texel, n_env, 1, pdf_cosine_hemisphere_sr(d));
        let mut sum = radiance_cosine(texel, d) * f64::from(factor);
        for _ in 0..n_env {
            let s = env.sample(source.next_uvec2());
            let factor = s.balance_factor(n_env, 1, pdf_cosine_hemisphere_sr(s.direction));
            sum += radiance_cosine(s.texel, s.direction) * f64::from(factor);
        }
        sum
    })
}

/// The same with plain tables.
fn plain_estimates(n: usize) -> impl Iterator<Item = f64> {
    let tables = Tables::plain();
    let mut source = Xoshiro128PlusPlus::stream(4, 0, 1);
    (0..n).map(move |_| {
        let env = EnvCdf::new(SIZE, &tables.marginal, &tables.conditional).unwrap();
        let d = sample_cosine_hemisphere(unit_vec2(source.next_uvec2())).direction;
        let s = env.sample(source.next_uvec2());
        let value = |texel: UVec2, d: Vec3| {
            let pdf_sr = env.texel_pdf_sr(texel);
            radiance_cosine(texel, d)
                / f64::from(multi_sample_density(
                    1,
                    pdf_sr,
                    1,
                    pdf_cosine_hemisphere_sr(d),
                ))
        };
        value(direction_to_texel(d, SIZE), d) + value(s.texel, s.direction)
    })
}

#[test]
fn beside_another_strategy_it_is_unbiased() {
    for n_env in [1, 3] {
        let mean = Mean::of(compensated_estimates(n_env, 200_000));
        z_test(mean, irradiance(), ALPHA).unwrap();
    }
}

#[test]
fn beside_another_strategy_it_has_less_variance() {
    let n = 200_000;
    let (plain, compensated) = (
        Mean::of(plain_estimates(n)),
        Mean::of(compensated_estimates(1, n)),
    );
    z_test(plain, irradiance(), ALPHA).unwrap();
    let ratio = (compensated.standard_error / plain.standard_error).powi(2);
    println!("variance {ratio:.2} of that of plain tables");
    assert!(ratio < 0.8, "{ratio}");
}

#[test]
fn alone_it_gives_nothing() {
    let tables = Tables::compensated();
    let mut source = Xoshiro128PlusPlus::stream(1, 0, 0);
    for _ in 0..1000 {
        let sample = tables.view().sample(source.next_uvec2());
        assert!(weight(sample.texel.x, sample.texel.y) > 1.5);
        assert!(sample.balance_factor(1, 1, 0.1) > 0.0);
        assert_eq!(sample.balance_factor(1, 0, 0.1), 0.0);
        assert_eq!(tables.view().balance_factor(sample.texel, 1, 0, 0.1), 0.0);
        assert_eq!(tables.view().balance_factor(sample.texel, 1, 1, 0.0), 0.0);
    }
    // What leaving the other strategy out would cost: the light below the mean is missed.
    let missed: f64 = (0..SIZE.y)
        .flat_map(|y| (0..SIZE.x).map(move |x| (x, y)))
        .filter(|(x, y)| weight(*x, *y) <= mean())
        .map(|(x, y)| f64::from(weight(x, y) * texel_solid_angle_sr(y, SIZE)))
        .sum();
    assert!(missed > 1.0);
}

fn sums() -> Vec<f64> {
    (0..SIZE.y).map(|y| row(y).map(f64::from).sum()).collect()
}

fn mean() -> f32 {
    mean_weight(&sums(), SIZE.x)
}

#[test]
fn the_mean_is_that_over_the_sphere() {
    let flux = integrate_texels(SIZE.to_array(), |[x, y], _| f64::from(weight(x, y)), 1e-7).value;
    within(f64::from(mean()), flux / (4.0 * PI), 1e-6).unwrap();
    // The mean over texels is another.
    let over_texels = sums().iter().sum::<f64>() / f64::from(SIZE.x * SIZE.y);
    assert!(within(f64::from(mean()), over_texels, 1e-2).is_err());
}

#[test]
fn rows_built_alone_give_the_same_tables() {
    let whole = Tables::compensated();
    let mut parts = Tables::empty();
    let mut compensated_sums = Vec::new();
    for (y, edges) in (0..).zip(parts.conditional.chunks_exact_mut(SIZE.x as usize + 1)) {
        let weights = row(y).map(|w| compensated_weight(w, mean()));
        compensated_sums.push(build_row_into(weights, edges).unwrap().weight_sum);
    }
    build_marginal_into(&compensated_sums, &mut parts.marginal).unwrap();
    assert_eq!(
        (parts.marginal, parts.conditional),
        (whole.marginal, whole.conditional)
    );
}

#[test]
fn a_constant_map_leaves_all_to_the_other_strategy() {
    let mut tables = Tables::empty();
    let constant = |_| [0.3; SIZE.x as usize];
    build_compensated_into(
        SIZE,
        constant,
        &mut tables.marginal,
        &mut tables.conditional,
    )
    .unwrap();
    let env = tables.view();
    assert!(env.is_black());
    let sample = env.sample(UVec2::splat(123_456_789));
    assert_eq!(sample.balance_factor(1, 1, 0.25), 0.0);
    assert_eq!(env.balance_factor(UVec2::ZERO, 1, 2, 0.25), 2.0);
}

#[test]
fn bad_weights_stay_bad() {
    let mut tables = Tables::empty();
    let rows = |y| row(y).map(move |w| if w == 40.0 { f32::NAN } else { w });
    let report =
        build_compensated_into(SIZE, rows, &mut tables.marginal, &mut tables.conditional).unwrap();
    assert_eq!(report.bad_texels, 1);
    for bad in [f32::NAN, f32::INFINITY, -1.0] {
        assert_eq!(compensated_weight(bad, 0.5).to_bits(), bad.to_bits());
    }
}
