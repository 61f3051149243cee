//! Host file: the tables of lat-long maps, and what is drawn from them, held against the weights they were built of.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use glam::{UVec2, Vec2, Vec3};
use glimt_envmap_cdf::{
    BuildError, BuildReport, EnvCdf, MAX_SIZE, TableError, UNITS, build_into, build_marginal_into,
    build_row_into, find_bin, required_len,
};
use glimt_probe::latlong;
use glimt_sampling::{UniformSource, Xoshiro128PlusPlus};
use glimt_statistics::quadrature::integrate_texels;
use glimt_statistics::stats::{Verdict, chi_square, kolmogorov_smirnov, sidak, within};
use proptest::prelude::{
    Just, ProptestConfig, Strategy, any, prop, prop_assert, prop_assert_eq, prop_oneof, proptest,
};

const ALPHA: f64 = 0.01;

/// A map of weights, row after row.
#[derive(Clone, Debug)]
struct Map {
    size: UVec2,
    weights: Vec<f32>,
}

impl Map {
    fn new(width: u32, height: u32, weight: impl Fn(u32, u32) -> f32) -> Self {
        let texels = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
        Self {
            size: UVec2::new(width, height),
            weights: texels.map(|(x, y)| weight(x, y)).collect(),
        }
    }

    fn one_hot(width: u32, height: u32, texel: [u32; 2]) -> Self {
        Self::new(
            width,
            height,
            |x, y| if [x, y] == texel { 3.0 } else { 0.0 },
        )
    }

    fn row(&self, y: u32) -> &[f32] {
        let width = self.size.x as usize;
        &self.weights[y as usize * width..][..width]
    }

    fn weight(&self, texel: UVec2) -> f32 {
        self.row(texel.y)[texel.x as usize]
    }

    fn texels(&self) -> impl Iterator<Item = UVec2> + use<> {
        let size = self.size;
        (0..size.y).flat_map(move |y| (0..size.x).map(move |x| UVec2::new(x, y)))
    }

    fn row_sums(&self) -> Vec<f64> {
        (0..self.size.y)
            .map(|y| self.row(y).iter().map(|w| f64::from(*w)).sum())
            .collect()
    }

    /// Probability of each texel, from the weights.
    fn masses(&self) -> Vec<f64> {
        let mass = |texel: UVec2| f64::from(self.weight(texel)) * area_sr(texel.y, self.size);
        let total: f64 = self.texels().map(mass).sum();
        self.texels().map(|texel| mass(texel) / total).collect()
    }
}

/// Solid angle of a texel, by the textbook difference.
fn area_sr(row: u32, size: UVec2) -> f64 {
    let cosine = |edge: u32| (PI * f64::from(edge) / f64::from(size.y)).cos();
    TAU / f64::from(size.x) * (cosine(row) - cosine(row + 1))
}

struct Tables {
    size: UVec2,
    marginal: Vec<u32>,
    conditional: Vec<u32>,
    report: BuildReport,
}

impl Tables {
    fn of(map: &Map) -> Self {
        let len = required_len(map.size.x, map.size.y).unwrap();
        // Stale entries must not show through.
        let (mut marginal, mut conditional) = (vec![77; len.marginal], vec![77; len.conditional]);
        let rows = |y| map.row(y).iter().copied();
        let report = build_into(map.size, rows, &mut marginal, &mut conditional).unwrap();
        Self {
            size: map.size,
            marginal,
            conditional,
            report,
        }
    }

    fn view(&self) -> EnvCdf<'_> {
        EnvCdf::new(self.size, &self.marginal, &self.conditional).unwrap()
    }

    fn row(&self, y: u32) -> &[u32] {
        let edges = self.size.x as usize + 1;
        &self.conditional[y as usize * edges..][..edges]
    }
}

fn fixed_maps() -> Vec<(&'static str, Map)> {
    let sun = |x, y| {
        if [x, y] == [11, 3] {
            1e6
        } else {
            1.0 + ((3 * x + y) % 5) as f32
        }
    };
    vec![
        ("one texel inside", Map::one_hot(16, 8, [5, 3])),
        ("one texel in the corner", Map::one_hot(16, 8, [15, 7])),
        ("one texel at the pole", Map::one_hot(16, 8, [9, 0])),
        ("one texel at the seam", Map::one_hot(16, 8, [0, 4])),
        (
            "one texel at the pole of a tall map",
            Map::one_hot(4, 4096, [1, 0]),
        ),
        (
            "one texel at the other pole of a tall map",
            Map::one_hot(4, 4096, [2, 4095]),
        ),
        ("constant", Map::new(16, 8, |_, _| 0.25)),
        ("1×1", Map::new(1, 1, |_, _| 7.0)),
        ("3×2", Map::new(3, 2, |x, y| (1 + x + 3 * y) as f32)),
        (
            "zero rows",
            Map::new(9, 7, |x, y| if y % 3 == 1 { (x % 4) as f32 } else { 0.0 }),
        ),
        ("sun", Map::new(16, 8, sun)),
        ("one column", Map::new(1, 9, |_, y| (y % 4) as f32)),
        ("one row", Map::new(13, 1, |x, _| (x % 3) as f32)),
    ]
}

/// Weights as maps have them: alike, spread over many magnitudes, mostly dark, with a sun, or with tiny lights.
fn drawn_map() -> impl Strategy<Value = Map> {
    let weight = prop_oneof![
        Just(prop_oneof![Just(1.0f32)].boxed()),
        Just((-30.0..30.0f32).prop_map(f32::exp2).boxed()),
        Just(prop_oneof![4 => Just(0.0f32), 1 => 0.1..2.0f32].boxed()),
        Just(prop_oneof![30 => 0.5..2.0f32, 1 => Just(1e6f32)].boxed()),
        Just(prop_oneof![3 => 0.5..2.0f32, 1 => Just(1e-30f32), 1 => Just(f32::MAX)].boxed()),
    ];
    (1..40u32, 1..24u32, weight).prop_flat_map(|(width, height, weight)| {
        prop::collection::vec(weight, (width * height) as usize).prop_map(move |weights| Map {
            size: UVec2::new(width, height),
            weights,
        })
    })
}

/// Checks one table against its weights: ends, order, zero and positive bins, and each bin's width.
fn check_table(edges: &[u32], weights: &[f64]) -> Result<(), String> {
    let total: f64 = weights.iter().sum();
    if total == 0.0 {
        return if edges.iter().all(|e| *e == 0) {
            Ok(())
        } else {
            Err("a black table with edges".into())
        };
    }
    if edges[0] != 0 || edges[edges.len() - 1] != UNITS {
        return Err(format!("ends {} and {}", edges[0], edges[edges.len() - 1]));
    }
    if edges.windows(2).any(|pair| pair[0] > pair[1]) {
        return Err("edges out of order".into());
    }
    let units: Vec<f64> = edges
        .windows(2)
        .map(|pair| f64::from(pair[1] - pair[0]))
        .collect();
    let exact = |w: &f64| w / total * f64::from(UNITS);
    let raised = weights
        .iter()
        .filter(|w| **w > 0.0 && exact(w) < 1.0)
        .count();
    let largest = (0..units.len())
        .max_by(|a, b| weights[*a].total_cmp(&weights[*b]))
        .unwrap();
    for (bin, (found, weight)) in units.iter().zip(weights).enumerate() {
        if (*weight > 0.0) != (*found > 0.0) {
            return Err(format!("bin {bin}: weight {weight}, {found} units"));
        }
        // Among equal weights, any may be the one that gives.
        let allowed = if *weight >= weights[largest] * (1.0 - 1e-9) {
            raised
        } else {
            0
        };
        let difference = (found - exact(weight)).abs();
        if !(difference <= 2.0 + allowed as f64) {
            return Err(format!(
                "bin {bin}: {found} units instead of {}",
                exact(weight)
            ));
        }
    }
    Ok(())
}

fn check_tables(map: &Map, tables: &Tables) -> Result<(), String> {
    for y in 0..map.size.y {
        let weights: Vec<f64> = map.row(y).iter().map(|w| f64::from(*w)).collect();
        check_table(tables.row(y), &weights).map_err(|e| format!("row {y}: {e}"))?;
    }
    let sums = map.row_sums();
    let rows: Vec<f64> = (0..map.size.y)
        .map(|y| sums[y as usize] * area_sr(y, map.size))
        .collect();
    check_table(&tables.marginal, &rows).map_err(|e| format!("rows: {e}"))
}

/// Column, row (whole) and place in `[0, 1]²` inside the texel, of a direction, in f64.
fn locate(d: Vec3, size: UVec2) -> (UVec2, [f64; 2]) {
    let [x, y, z] = d.to_array().map(f64::from);
    let theta = x.hypot(y).atan2(z);
    let column = (0.5 - y.atan2(x) / TAU).rem_euclid(1.0) * f64::from(size.x);
    let row = ((theta / PI * f64::from(size.y)) as u32).min(size.y - 1);
    // cos a − cos b = 2 sin((a+b)/2) sin((b−a)/2), precise at the poles.
    let upper = PI * f64::from(row) / f64::from(size.y);
    let band = PI / f64::from(size.y);
    let difference = |to: f64| (0.5 * (upper + to)).sin() * (0.5 * (to - upper)).sin();
    let texel = UVec2::new((column as u32).min(size.x - 1), row);
    (
        texel,
        [column.fract(), difference(theta) / difference(upper + band)],
    )
}

/// χ² of drawn directions over quarters of texels against the map's own weights.
fn chi_square_of(map: &Map, directions: impl IntoIterator<Item = Vec3>, alpha: f64) -> Verdict {
    let mut observed = vec![0u64; 4 * map.weights.len()];
    for d in directions {
        let (texel, place) = locate(d, map.size);
        let quarter = usize::from(place[0] >= 0.5) + 2 * usize::from(place[1] >= 0.5);
        observed[4 * (texel.y * map.size.x + texel.x) as usize + quarter] += 1;
    }
    let n = observed.iter().sum::<u64>() as f64;
    let quarters = map
        .masses()
        .into_iter()
        .flat_map(|mass| [0.25 * mass * n; 4]);
    // A direction at a texel's very edge may round into a dark neighbour: not even one in a thousand may.
    let dark: f64 = 1e-3;
    let (mut expected, mut counts, mut strays) = (Vec::new(), Vec::new(), 0);
    for (e, o) in quarters.zip(observed) {
        if e > 0.0 {
            expected.push(e);
            counts.push(o);
        } else {
            strays += o;
        }
    }
    within(strays as f64 / n, 0.0, dark)?;
    let kept = 1.0 - strays as f64 / n;
    expected.iter_mut().for_each(|e| *e *= kept);
    chi_square(&counts, &expected, alpha)
}

fn directions(env: EnvCdf<'_>, seed: u32, n: usize) -> impl Iterator<Item = Vec3> {
    let mut source = Xoshiro128PlusPlus::stream(seed, 0, 0);
    (0..n).map(move |_| env.sample(source.next_uvec2()).direction)
}

#[test]
fn tables_hold_their_weights() {
    for (name, map) in fixed_maps() {
        check_tables(&map, &Tables::of(&map)).unwrap_or_else(|e| panic!("{name}: {e}"));
    }
}

#[test]
fn the_table_check_sees_what_is_wrong() {
    let map = Map::new(7, 5, |x, y| ((x + y) % 3) as f32);
    let good = || Tables::of(&map);
    check_tables(&map, &good()).unwrap();
    let mut three_units = good();
    three_units.conditional[2] += 3;
    assert!(check_tables(&map, &three_units).is_err());
    let mut zero_texel = good();
    zero_texel.conditional[1] = 1;
    assert!(check_tables(&map, &zero_texel).is_err());
    let mut short = good();
    *short.marginal.last_mut().unwrap() -= 1;
    assert!(check_tables(&map, &short).is_err());
    // No sin θ: rows by their sums alone.
    let mut flat = good();
    let sums = map.row_sums();
    let unweighted: Vec<f64> = (0..5)
        .map(|y| sums[y as usize] / area_sr(y, map.size))
        .collect();
    build_marginal_into(&unweighted, &mut flat.marginal).unwrap();
    assert!(check_tables(&map, &flat).is_err());
}

#[test]
fn densities_integrate_to_one() {
    for (name, map) in fixed_maps() {
        let tables = Tables::of(&map);
        let env = tables.view();
        let texel_sum: f64 = map
            .texels()
            .map(|texel| f64::from(env.texel_pdf_sr(texel)) * area_sr(texel.y, map.size))
            .sum();
        within(texel_sum, 1.0, 2e-6).unwrap_or_else(|e| panic!("{name}: {e}"));
        // The density of a direction, at points inside the texels. (A tall map takes too long.)
        if map.size.y < 100 {
            let pdf_sr =
                |_, d: [f64; 3]| f64::from(env.pdf_sr(Vec3::from_array(d.map(|x| x as f32))));
            let whole = integrate_texels(map.size.to_array(), pdf_sr, 1e-5);
            within(whole.value, 1.0, 2e-5).unwrap_or_else(|e| panic!("{name}: {e}"));
        }
    }
}

#[test]
fn samples_have_the_density_of_the_map() {
    let maps = fixed_maps();
    let alpha = sidak(ALPHA, maps.len());
    for (seed, (name, map)) in (1..).zip(&maps) {
        let tables = Tables::of(map);
        chi_square_of(map, directions(tables.view(), seed, 400_000), alpha)
            .unwrap_or_else(|e| panic!("{name}: {e}"));
    }
}

#[test]
fn chi_square_sees_the_usual_mistakes() {
    let map = Map::new(16, 8, |x, y| 1.0 + ((3 * x + 5 * y) % 7) as f32);
    let tables = Tables::of(&map);
    let n = 400_000;
    let draws = || directions(tables.view(), 3, n);
    chi_square_of(&map, draws(), ALPHA).unwrap();
    // Shifted by half a texel, or by a tenth.
    for shift in [0.5f32, 0.1] {
        let (sin, cos) = (shift * core::f32::consts::TAU / 16.0).sin_cos();
        let turned = draws().map(|d| Vec3::new(d.x * cos - d.y * sin, d.x * sin + d.y * cos, d.z));
        assert!(chi_square_of(&map, turned, ALPHA).is_err(), "shift {shift}");
    }
    // Mirrored.
    assert!(chi_square_of(&map, draws().map(|d| Vec3::new(d.x, -d.y, d.z)), ALPHA).is_err());
    // Texels sampled at their centres, or in θ instead of cos θ.
    let centres = draws()
        .map(|d| latlong::texel_direction(latlong::direction_to_texel(d, map.size), map.size));
    assert!(chi_square_of(&map, centres, ALPHA).is_err());
    let in_theta = draws().map(|d| {
        let (texel, place) = locate(d, map.size);
        let uv =
            (texel.as_vec2() + Vec2::new(place[0] as f32, place[1] as f32)) / map.size.as_vec2();
        latlong::uv_to_direction(uv)
    });
    assert!(chi_square_of(&map, in_theta, ALPHA).is_err());
    // Built without the rows' areas.
    let mut flat = Tables::of(&map);
    let sums = map.row_sums();
    let unweighted: Vec<f64> = (0..8)
        .map(|y| sums[y as usize] / area_sr(y, map.size))
        .collect();
    build_marginal_into(&unweighted, &mut flat.marginal).unwrap();
    assert!(chi_square_of(&map, directions(flat.view(), 3, n), ALPHA).is_err());
}

#[test]
fn a_texel_of_one_unit_is_sampled_all_over() {
    // Two dark texels beside a sun, in two rows of which one is nearly black: one unit each way.
    let map = Map::new(3, 2, |x, y| {
        if [x, y] == [1, 0] {
            1e12
        } else if y == 0 {
            1.0
        } else {
            1e-6
        }
    });
    let tables = Tables::of(&map);
    let (row_edge, column_edge) = (tables.marginal[1], tables.row(0)[2]);
    assert_eq!((UNITS - row_edge, UNITS - column_edge), (1, 1));
    let mut source = Xoshiro128PlusPlus::stream(9, 0, 0);
    let mut places: [Vec<f64>; 2] = Default::default();
    let mut products = [0.0; 2];
    for _ in 0..20_000 {
        let random = source.next_uvec2();
        // The column's unit with any row: x is placed by the hash alone; and the other way round.
        let u = [
            UVec2::new(
                (column_edge << 1) | (random.x & 1),
                random.y % (row_edge << 1),
            ),
            UVec2::new(random.x, row_edge << 1),
        ];
        for axis in 0..2 {
            let sample = tables.view().sample(u[axis]);
            let (texel, place) = locate(sample.direction, map.size);
            assert_eq!(
                (texel, texel.to_array()[axis]),
                (sample.texel, [2, 1][axis])
            );
            places[axis].push(place[axis]);
            products[axis] += (place[0] - 0.5) * (place[1] - 0.5) * 12.0 / 20_000.0;
        }
    }
    for (axis, places) in places.iter_mut().enumerate() {
        kolmogorov_smirnov(places, |x| x.clamp(0.0, 1.0), sidak(ALPHA, 2)).unwrap();
        // No correlation between the axes: its standard error is 0.007.
        within(products[axis], 0.0, 0.03).unwrap();
    }
}

#[test]
fn sampling_in_proportion_to_radiance_has_no_variance() {
    let map = Map::new(64, 32, |x, y| 1.0 + ((7 * x + 11 * y) % 13) as f32);
    let tables = Tables::of(&map);
    let total: f64 = map
        .texels()
        .map(|t| f64::from(map.weight(t)) * area_sr(t.y, map.size))
        .sum();
    let mut source = Xoshiro128PlusPlus::stream(2, 0, 0);
    for _ in 0..10_000 {
        let s = tables.view().sample(source.next_uvec2());
        let estimate = f64::from(map.weight(s.texel)) / f64::from(s.pdf_sr);
        within(estimate / total, 1.0, 2e-6).unwrap();
        assert_eq!(s.pdf_sr, tables.view().texel_pdf_sr(s.texel));
    }
}

#[test]
fn black_maps_and_rows_have_a_documented_outcome() {
    let map = Map::new(5, 3, |_, _| 0.0);
    let tables = Tables::of(&map);
    let env = tables.view();
    assert!(env.is_black());
    for word in [0, 1, 1 << 31, u32::MAX] {
        let sample = env.sample(UVec2::splat(word));
        assert_eq!(
            (sample.texel, sample.direction, sample.pdf_sr),
            (UVec2::ZERO, Vec3::Z, 0.0)
        );
    }
    assert_eq!(env.pdf_sr(Vec3::X), 0.0);
    // There is no answer, but no panic either.
    let _ = env.invert(Vec3::X);
    let rows = Map::new(5, 3, |_, y| if y == 1 { 1.0 } else { 0.0 });
    let tables = Tables::of(&rows);
    assert!(!tables.view().is_black());
    assert_eq!(
        (tables.view().pdf_sr(Vec3::Z), tables.row(0)),
        (0.0, &[0; 6][..])
    );
}

#[test]
fn bad_weights_are_counted_and_taken_as_zero() {
    let mut bad = Map::new(11, 4, |x, y| (1 + x + y) as f32);
    let mut clean = bad.clone();
    for (i, weight) in [
        (3, f32::NAN),
        (17, f32::INFINITY),
        (18, -1.0),
        (25, -0.0),
        (43, f32::NEG_INFINITY),
    ] {
        bad.weights[i] = weight;
        clean.weights[i] = 0.0;
    }
    let (bad, clean) = (Tables::of(&bad), Tables::of(&clean));
    assert_eq!((bad.report.bad_texels, clean.report.bad_texels), (4, 0));
    assert_eq!(
        (bad.marginal, bad.conditional),
        (clean.marginal, clean.conditional)
    );
}

#[test]
fn raised_texels_are_counted() {
    let map = Map::new(20, 2, |x, y| if [x, y] == [4, 1] { 1e15 } else { 1.0 });
    // 19 texels beside the sun, and the row without it.
    assert_eq!(Tables::of(&map).report.raised, 20);
}

#[test]
fn sizes_and_lengths_are_checked() {
    let row = |_| [1.0; 4];
    let (mut m, mut c) = ([0; 3], [0; 10]);
    assert!(build_into(UVec2::new(4, 2), row, &mut m, &mut c).is_ok());
    let error = |size: [u32; 2], m: &mut [u32], c: &mut [u32]| {
        build_into(size.into(), row, m, c).unwrap_err()
    };
    assert_eq!(
        error([0, 2], &mut m, &mut c),
        BuildError::Size(UVec2::new(0, 2))
    );
    assert_eq!(
        error([MAX_SIZE + 1, 2], &mut m, &mut c),
        BuildError::Size(UVec2::new(MAX_SIZE + 1, 2))
    );
    let (expected, found) = (3, 2);
    assert_eq!(
        error([4, 2], &mut m[..2], &mut c),
        BuildError::MarginalLen { expected, found }
    );
    let (expected, found) = (10, 9);
    assert_eq!(
        error([4, 2], &mut m, &mut c[..9]),
        BuildError::ConditionalLen { expected, found }
    );
    let (expected, found) = (9, 4);
    assert_eq!(
        error([9, 1], &mut m[..2], &mut c),
        BuildError::TexelCount { expected, found }
    );
    assert!(build_row_into([], &mut []).is_err() && build_row_into([], &mut [0]).is_err());
    assert!(build_marginal_into(&[], &mut [0]).is_err());
    assert_eq!(
        EnvCdf::new(UVec2::new(4, 2), &m[..2], &c).unwrap_err(),
        TableError::Len
    );
    assert!(matches!(
        EnvCdf::new(UVec2::ZERO, &m, &c),
        Err(TableError::Size(_))
    ));
    // The largest size: every bin but one is raised, and the largest can pay.
    let len = MAX_SIZE as usize;
    let mut edges = vec![0; len + 1];
    let weights = (0..len).map(|x| if x == 999 { 1e30 } else { 1e-30 });
    assert_eq!(
        build_row_into(weights, &mut edges).unwrap().raised,
        MAX_SIZE - 1
    );
    assert_eq!(
        (edges[999], edges[1000], edges[len]),
        (999, UNITS - (MAX_SIZE - 1000), UNITS)
    );
}

#[test]
fn what_lies_behind_the_tables_is_not_read() {
    for (name, map) in fixed_maps() {
        let tables = Tables::of(&map);
        let exact = tables.view();
        for behind in [0, 1 << 29, u32::MAX] {
            let padded = |table: &[u32]| [table, &[behind; 4096]].concat();
            let (marginal, conditional) = (padded(&tables.marginal), padded(&tables.conditional));
            let longer = EnvCdf {
                size: map.size,
                marginal: &marginal,
                conditional: &conditional,
            };
            let mut source = Xoshiro128PlusPlus::stream(31, 0, behind);
            for _ in 0..1000 {
                let u = source.next_uvec2();
                assert_eq!(longer.sample(u), exact.sample(u), "{name}, {behind} behind");
            }
        }
    }
}

#[test]
fn f32_uniforms_miss_narrow_texels() {
    let map = Map::new(3, 1, |x, _| [1.0, 3e-8, 0.7][x as usize]);
    let tables = Tables::of(&map);
    let (first, last) = (tables.row(0)[1], tables.row(0)[2]);
    assert!(
        first.next_multiple_of(1 << 7) >= last,
        "units {first} to {last}"
    );
    let env = tables.view();
    let texel = |u: f32| env.sample_f32(Vec2::new(u, 0.5)).texel.x;
    let near = first as f32 / UNITS as f32;
    let step = 2f32.powi(-24);
    assert!((-1000..1000).all(|k| texel(near + k as f32 * step) != 1));
    assert_eq!(env.sample(UVec2::new(first << 1, 1 << 31)).texel.x, 1);
    for outside in [-1.0, 1.0, 2.0, f32::NAN] {
        assert!(texel(outside) < 3);
    }
}

/// The first and the last word of each bin, and some between.
fn words(edges: &[u32], bin: usize) -> [u32; 3] {
    let (first, last) = (edges[bin], edges[bin + 1] - 1);
    [
        first << 1,
        (last << 1) | 1,
        (first + (last - first) / 3) << 1,
    ]
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: 300,
        rng_seed: proptest::test_runner::RngSeed::Fixed(2),
        failure_persistence: None,
        ..ProptestConfig::default()
    })]

    #[test]
    fn drawn_tables_hold_their_weights(map in drawn_map()) {
        let tables = Tables::of(&map);
        check_tables(&map, &tables).map_err(proptest::test_runner::TestCaseError::fail)?;
        prop_assert_eq!(tables.report.bad_texels, 0);
        // Rows built one by one, as a parallel caller does, are the same.
        let mut row = vec![0; map.size.x as usize + 1];
        let mut sums = Vec::new();
        for y in 0..map.size.y {
            sums.push(build_row_into(map.row(y).iter().copied(), &mut row).unwrap().weight_sum);
            prop_assert_eq!(&row[..], tables.row(y));
        }
        let mut marginal = vec![0; map.size.y as usize + 1];
        build_marginal_into(&sums, &mut marginal).unwrap();
        prop_assert_eq!(marginal, tables.marginal);
    }

    #[test]
    fn lit_texels_are_reached_and_dark_ones_never(map in drawn_map()) {
        let tables = Tables::of(&map);
        let env = tables.view();
        for texel in map.texels() {
            let pdf_sr = env.texel_pdf_sr(texel);
            prop_assert_eq!(pdf_sr > 0.0, map.weight(texel) > 0.0);
            if pdf_sr > 0.0 {
                let columns = words(tables.row(texel.y), texel.x as usize);
                let rows = words(&tables.marginal, texel.y as usize);
                for (x, y) in columns.into_iter().flat_map(|x| rows.map(|y| (x, y))) {
                    let sample = env.sample(UVec2::new(x, y));
                    prop_assert_eq!(sample.texel, texel);
                    prop_assert_eq!(sample.pdf_sr, pdf_sr);
                    prop_assert!((sample.direction.length() - 1.0).abs() < 1e-6);
                }
            }
        }
    }

    #[test]
    fn search_agrees_with_counting(
        mut inner in prop::collection::vec(0..=UNITS, 0..70),
        u in 0..UNITS,
        around in prop::array::uniform2(prop::collection::vec(any::<u32>(), 0..70)),
    ) {
        inner.sort_unstable();
        let edges: Vec<u32> = [0].into_iter().chain(inner).chain([UNITS]).collect();
        let [before, behind] = &around;
        let slice = [before, edges.as_slice(), behind].concat();
        for u in edges.iter().copied().filter(|e| *e < UNITS).chain([u]) {
            let last = edges.iter().rposition(|e| *e <= u).unwrap();
            let bin = find_bin(&slice, before.len(), edges.len() - 1, u);
            prop_assert_eq!(bin.index as usize, last);
            prop_assert_eq!((bin.first, bin.units), (edges[last], edges[last + 1] - edges[last]));
        }
    }

    #[test]
    fn inversion_leads_back(map in drawn_map(), place in (0.001..0.999f32, 0.001..0.999f32), random in any::<[u32; 2]>()) {
        let tables = Tables::of(&map);
        let env = tables.view();
        for texel in map.texels().filter(|t| map.weight(*t) > 0.0) {
            let d = latlong::direction_in_texel(texel, map.size, Vec2::new(place.0, place.1));
            prop_assert_eq!(latlong::direction_to_texel(d, map.size), texel);
            let back = env.sample(env.invert(d));
            prop_assert_eq!(back.texel, texel);
            let row = tables.row(texel.y);
            let x = texel.x as usize;
            let units = [row[x + 1] - row[x], tables.marginal[texel.y as usize + 1] - tables.marginal[texel.y as usize]];
            let (_, found) = locate(back.direction, map.size);
            let (_, wanted) = locate(d, map.size);
            for axis in 0..2 {
                // One unit of the bin, and f32.
                let allowed = 1.0 / f64::from(units[axis]) + 2e-5;
                prop_assert!((found[axis] - wanted[axis]).abs() <= allowed, "{:?} {:?} {:?}", found, wanted, units);
            }
        }
        if env.is_black() {
            return Ok(());
        }
        let u = UVec2::from_array(random);
        let sample = env.sample(u);
        if latlong::direction_to_texel(sample.direction, map.size) == sample.texel {
            let back = env.invert(sample.direction);
            let x = sample.texel.x as usize;
            let row = tables.row(sample.texel.y);
            let width = [row[x + 1] - row[x], tables.marginal[sample.texel.y as usize + 1] - tables.marginal[sample.texel.y as usize]];
            for (axis, units) in width.into_iter().enumerate() {
                let difference = f64::from(back[axis]) - f64::from(u[axis]);
                prop_assert!(difference.abs() <= 4.0 + 4e-5 * f64::from(units), "{} of {}", difference, units);
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: DRAWN_CHI_SQUARES as u32,
        rng_seed: proptest::test_runner::RngSeed::Fixed(3),
        failure_persistence: None,
        ..ProptestConfig::default()
    })]

    #[test]
    fn samples_have_the_density_of_drawn_maps(map in drawn_map(), seed in any::<u32>()) {
        let tables = Tables::of(&map);
        if !tables.view().is_black() {
            let verdict = chi_square_of(&map, directions(tables.view(), seed, 100_000), sidak(ALPHA, DRAWN_CHI_SQUARES));
            prop_assert!(verdict.is_ok(), "{}", verdict.unwrap_err());
        }
    }
}

const DRAWN_CHI_SQUARES: usize = 60;

#[test]
fn areas_of_the_test_are_the_sphere() {
    let size = UVec2::new(6, 5);
    let sphere: f64 = (0..5).map(|y| 6.0 * area_sr(y, size)).sum();
    within(sphere, 8.0 * FRAC_PI_2, 1e-12).unwrap();
}
