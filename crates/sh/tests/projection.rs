//! Host file: light maps onto spherical harmonics, against the sum in f64 and closed forms.

use std::f64::consts::{PI, TAU};

use glam::{UVec2, Vec3};
use glimt_probe::latlong;
use glimt_sampling::{UniformSource, Xoshiro128PlusPlus, unit_f32};
use glimt_sh::{
    LightCoefficients, Projection, RingTable, ShError, basis, build_ring_table_into,
    coefficient_band, cosine_lobe, ring_table_len,
};
use glimt_statistics::harmonics::{harmonic, indices};
use glimt_statistics::quadrature::{Direction, direction};
use glimt_statistics::worst::{larger, worst};

const SIZES: [(u32, u32); 12] = [
    (1, 1),
    (3, 2),
    (2, 3),
    (4, 2),
    (8, 4),
    (5, 1),
    (50, 25),
    (101, 50),
    (68, 7),
    (100, 6),
    (1628, 5),
    (1024, 3),
];

type Map = Vec<[f32; 3]>;

fn table(width: u32, bands: u32, channels: u32) -> Vec<f32> {
    let mut table = vec![f32::NAN; ring_table_len(width, bands, channels).unwrap()];
    build_ring_table_into(width, bands, channels, &mut table).unwrap();
    assert!(table.iter().all(|f| f.abs() < 1.000_001));
    table
}

/// Row by row, by the path of this processor or the plain one.
fn project(map: &Map, size: UVec2, bands: u32, plain: bool) -> LightCoefficients {
    let table = table(size.x, bands, 3);
    let table = RingTable::new(size.x, bands, 3, &table).unwrap();
    let mut projection = Projection::new(bands, size).unwrap();
    for (y, row) in (0..).zip(map.chunks(size.x as usize)) {
        let row = row.as_flattened();
        let sums = if plain {
            table.row_sums_plain(row)
        } else {
            table.row_sums(row)
        };
        projection.add_row(y, &sums.unwrap()).unwrap();
    }
    projection.coefficients()
}

/// `cos θ` of an edge between rows, and a texel's area and centre, in f64.
fn edge(row: u32, height: u32) -> f64 {
    (PI * f64::from(row) / f64::from(height)).cos()
}

fn area(row: u32, size: UVec2) -> f64 {
    TAU / f64::from(size.x) * (edge(row, size.y) - edge(row + 1, size.y))
}

fn centre(x: u32, y: u32, size: UVec2) -> Direction {
    let theta = PI * (f64::from(y) + 0.5) / f64::from(size.y);
    let phi = PI - TAU * (f64::from(x) + 0.5) / f64::from(size.x);
    direction(theta.cos(), phi)
}

/// `Σ L y ΔΩ` in f64.
fn by_formula(map: &Map, size: UVec2, bands: u32) -> Vec<[f64; 3]> {
    let indices = indices(bands);
    let mut sums = vec![[0.0; 3]; indices.len()];
    for (i, texel) in (0..).zip(map) {
        let (x, y) = (i % size.x, i / size.x);
        let (d, area) = (centre(x, y, size), area(y, size));
        for (sum, &(l, m)) in sums.iter_mut().zip(&indices) {
            let weight = area * harmonic(l, m, d);
            for (sum, value) in sum.iter_mut().zip(texel) {
                *sum += weight * f64::from(*value);
            }
        }
    }
    sums
}

/// The largest difference, relative to the flux of the map; NaN where there is one.
fn difference(found: &LightCoefficients, exact: &[[f64; 3]], flux: f64) -> f64 {
    let differences = found.iter().enumerate().flat_map(|(k, c)| {
        let exact = exact.get(k).copied().unwrap_or_default();
        (0..3).map(move |channel| (f64::from(c[channel]) - exact[channel]).abs() / flux)
    });
    worst(differences)
}

#[test]
fn a_nan_is_a_difference() {
    for k in [0, 17, 35] {
        for channel in 0..3 {
            let mut found = [Vec3::ONE; 36];
            found[k][channel] = f32::NAN;
            let error = difference(&found, &[[1.0; 3]; 36], 1.0);
            assert!(error.is_nan(), "{k} {channel}");
        }
    }
}

fn flux(map: &Map, size: UVec2) -> f64 {
    let texel =
        |(i, t): (u32, &[f32; 3])| area(i / size.x, size) * f64::from(t[0].max(t[1]).max(t[2]));
    (0..).zip(map).map(texel).sum()
}

fn random_map(size: UVec2) -> Map {
    let mut source = Xoshiro128PlusPlus::stream(21, size.x, size.y);
    let mut number = || (6.0 * unit_f32(source.next_u32())).exp();
    (0..size.x * size.y)
        .map(|_| [number(), number(), number()])
        .collect()
}

#[test]
fn maps_of_every_shape_are_the_formulas_sum() {
    let mut largest = 0.0f64;
    for (w, h) in SIZES {
        let size = UVec2::new(w, h);
        let map = random_map(size);
        let flux = flux(&map, size);
        for bands in 1..=6 {
            let exact = by_formula(&map, size, bands);
            for plain in [false, true] {
                let found = project(&map, size, bands, plain);
                let error = difference(&found, &exact, flux);
                assert!(
                    error <= 1e-6,
                    "{size}, {bands} bands, plain {plain}: {error:e}"
                );
                largest = larger(largest, error);
            }
        }
        let mut wrong = map.clone();
        wrong[0][1] += 1e-4 * flux as f32 / area(0, size) as f32;
        let wrong = difference(
            &project(&wrong, size, 4, false),
            &by_formula(&map, size, 4),
            flux,
        );
        assert!(!(wrong <= 1e-6), "another map passes");
    }
    println!("{largest:e} of the flux");
}

#[test]
fn a_single_texel() {
    for (w, h) in [(101, 50), (64, 32), (1628, 814), (3, 2)] {
        let size = UVec2::new(w, h);
        for (x, y) in [
            (0, 0),
            (w - 1, 0),
            (w / 2, h - 1),
            (0, h / 2),
            (w - 1, h / 2),
            (w / 3, h / 3),
        ] {
            let table = table(w, 6, 3);
            let table = RingTable::new(w, 6, 3, &table).unwrap();
            let mut row = vec![[0.0f32; 3]; w as usize];
            row[x as usize] = [2.0, 0.0, -1.0];
            let mut projection = Projection::new(6, size).unwrap();
            projection
                .add_row(y, &table.row_sums(row.as_flattened()).unwrap())
                .unwrap();
            let found = projection.coefficients();
            let mut furthest = 0.0f64;
            let direction = latlong::texel_direction(UVec2::new(x, y), size);
            for (k, &(l, m)) in indices(6).iter().enumerate() {
                let exact = area(y, size) * harmonic(l, m, centre(x, y, size));
                let relative = (f64::from(found[k].x) - 2.0 * exact) / area(y, size);
                assert!(relative.abs() < 3e-6, "{size} ({x}, {y}) {k}: {relative:e}");
                let beside = harmonic(l, m, centre(x + 1, y, size));
                let moved = (f64::from(found[k].x) / area(y, size) - 2.0 * beside).abs();
                furthest = larger(furthest, moved);
                assert_eq!((found[k].y, found[k].z), (0.0, -0.5 * found[k].x));
                assert!(
                    (f64::from(basis(direction)[k]) - harmonic(l, m, centre(x, y, size))).abs()
                        < 3e-6
                );
            }
            assert!(y != h / 2 || !(furthest < 3e-6), "another column passes");
        }
    }
}

#[test]
fn a_grey_map_is_its_mean() {
    for (w, h) in SIZES {
        let size = UVec2::new(w, h);
        let found = project(&vec![[1.5, 0.5, 0.0]; (w * h) as usize], size, 6, false);
        let exact = (4.0 * PI).sqrt();
        assert!((f64::from(found[0].x) / exact - 1.5).abs() < 1e-6, "{size}");
        assert!((f64::from(found[0].y) / exact - 0.5).abs() < 1e-6, "{size}");
        assert_eq!(found[0].z, 0.0);
    }
}

fn map_of(size: UVec2, f: impl Fn(Vec3) -> f32) -> Map {
    let texel = |i: u32| latlong::texel_direction(UVec2::new(i % size.x, i / size.x), size);
    (0..size.x * size.y).map(|i| [f(texel(i)); 3]).collect()
}

/// The error of a texel's centre standing for the texel goes with the square of its height.
#[test]
fn functions_of_the_basis_come_back() {
    let errors = [64, 128].map(|height| {
        let size = UVec2::new(2 * height, height);
        worst((0..36).flat_map(|k| {
            let found = project(&map_of(size, |d| basis(d)[k]), size, 6, false);
            let exact = move |i: usize| Vec3::splat(if i == k { 1.0 } else { 0.0 });
            let errors = found.into_iter().enumerate();
            errors.flat_map(move |(i, c)| (c - exact(i)).abs().to_array())
        }))
    });
    println!("{errors:?}");
    assert!(errors[0] < 6e-3 && errors[1] < 1.5e-3, "{errors:?}");
    assert!(errors[0] > 3.5 * errors[1], "{errors:?}");
}

#[test]
fn a_cosine_lobe() {
    let n = Vec3::new(0.48, -0.6, 0.64);
    let size = UVec2::new(404, 202);
    let found = project(&map_of(size, |d| d.dot(n).max(0.0)), size, 6, false);
    let far = |n: Vec3| {
        let y = basis(n);
        let one =
            |(k, c): (usize, &Vec3)| (c.x - cosine_lobe(coefficient_band(k as u32)) * y[k]).abs();
        worst(found.iter().enumerate().map(one))
    };
    println!("{:e}", far(n));
    assert!(far(n) < 2e-4);
    let beside = (n + 1e-3 * Vec3::X).normalize();
    assert!(!(far(beside) < 2e-4), "a lobe beside it passes");
}

/// A texel as bright as all others together, and the others: in f32, one sum after the other, their share would be lost.
#[test]
fn nothing_is_lost_beside_a_sun() {
    let size = UVec2::new(4096, 2048);
    let (sun_x, sun_y) = (1000, 700);
    let floor = 1e-3f32;
    let sun = (4.0 * PI / area(sun_y, size)) as f32 * floor;
    let table = table(size.x, 6, 3);
    let table = RingTable::new(size.x, 6, 3, &table).unwrap();
    let dark = vec![[floor; 3]; size.x as usize];
    let mut bright = dark.clone();
    bright[sun_x] = [sun; 3];
    let dark_sums = table.row_sums(dark.as_flattened()).unwrap();
    let bright_sums = table.row_sums(bright.as_flattened()).unwrap();
    let mut projection = Projection::new(6, size).unwrap();
    for y in 0..size.y {
        projection
            .add_row(y, if y == sun_y { &bright_sums } else { &dark_sums })
            .unwrap();
    }
    let flux = 4.0 * PI * f64::from(floor);
    let exact = |k: usize| {
        let (l, m) = indices(6)[k];
        let sun = f64::from(sun - floor) * area(sun_y, size);
        let floor = if k == 0 { flux * 0.5 / PI.sqrt() } else { 0.0 };
        floor + sun * harmonic(l, m, centre(sun_x as u32, sun_y, size))
    };
    for (k, c) in projection.coefficients().into_iter().enumerate() {
        let error = (f64::from(c.x) - exact(k)).abs() / flux;
        assert!(error < 1e-6, "{k}: {error:e}");
    }
    // A row's own floor beside its sun: a sum of f32 loses a part of it.
    let row_floor = f64::from(floor) * 4095.0;
    let found = bright_sums.sums[0][0] - f64::from(sun);
    assert!(
        (found / row_floor - 1.0).abs() < 1e-2,
        "{found} {row_floor}"
    );
    let mut naive = 0.0f32;
    for y in 0..size.y {
        let area = area(y, size) as f32;
        for x in 0..size.x as usize {
            let value = if (x, y) == (sun_x, sun_y) { sun } else { floor };
            naive += value * area * basis(Vec3::Z)[0];
        }
    }
    assert!(
        !((f64::from(naive) - exact(0)).abs() / flux < 1e-6),
        "a plain sum passes"
    );
}

#[test]
fn wide_and_plain_paths_agree() {
    for (width, channels) in [(4096, 3), (1024, 4), (36, 3), (404, 4), (7, 4)] {
        let mut source = Xoshiro128PlusPlus::stream(22, width, channels);
        let row: Vec<f32> = (0..width * channels)
            .map(|_| unit_f32(source.next_u32()) - 0.2)
            .collect();
        let magnitude: f64 = row.iter().map(|f| f64::from(f.abs())).sum();
        for bands in 1..=6 {
            let table = table(width, bands, channels);
            let table = RingTable::new(width, bands, channels, &table).unwrap();
            let (a, b) = (
                table.row_sums(&row).unwrap(),
                table.row_sums_plain(&row).unwrap(),
            );
            for (k, (a, b)) in a.sums.iter().zip(&b.sums).enumerate() {
                for (a, b) in a.iter().zip(b) {
                    assert!(
                        (a - b).abs() <= 1e-6 * magnitude,
                        "{width} {channels} {bands} {k}"
                    );
                    assert_eq!(*a == 0.0, k >= 2 * bands as usize - 1);
                }
            }
        }
    }
}

#[test]
fn what_is_no_light_stays_in_its_channel() {
    for width in [64, 7, 1024] {
        let size = UVec2::new(width, 1);
        for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
            let mut map = vec![[1.0f32, 1.0, 1.0]; width as usize];
            map[3][1] = bad;
            for plain in [false, true] {
                let found = project(&map, size, 6, plain);
                assert!(!found[0].y.is_finite());
                assert!(found.iter().all(|c| c.x.is_finite() && c.z.is_finite()));
            }
        }
        let negative = project(&vec![[-1.0, 0.0, 1.0]; width as usize], size, 3, false);
        assert_eq!(negative[0].x, -negative[0].z);
    }
}

#[test]
fn what_cannot_be_is_an_error() {
    assert_eq!(ring_table_len(8, 0, 3), Err(ShError::Bands(0)));
    assert_eq!(ring_table_len(8, 7, 3), Err(ShError::Bands(7)));
    assert_eq!(
        ring_table_len(0, 3, 3),
        Err(ShError::Size(UVec2::new(0, 1)))
    );
    assert_eq!(ring_table_len(8, 3, 2), Err(ShError::Channels(2)));
    assert!(matches!(
        build_ring_table_into(8, 3, 3, &mut [0.0; 3]),
        Err(ShError::Length { .. })
    ));
    assert!(matches!(
        RingTable::new(8, 3, 3, &[0.0; 3]),
        Err(ShError::Length { .. })
    ));
    let table = table(8, 3, 3);
    let table = RingTable::new(8, 3, 3, &table).unwrap();
    assert!(matches!(
        table.row_sums(&[0.0; 23]),
        Err(ShError::Length {
            expected: 24,
            found: 23
        })
    ));
    let mut projection = Projection::new(3, UVec2::new(8, 2)).unwrap();
    let sums = table.row_sums(&[0.0; 24]).unwrap();
    assert_eq!(
        projection.add_row(2, &sums),
        Err(ShError::Row { row: 2, height: 2 })
    );
    assert!(projection.add_rows(&table, 1, &[0.0; 48]).is_err());
    // Nor is there a row behind the largest number.
    let mut last = projection;
    for first in [u32::MAX, u32::MAX - 1] {
        let (row, height) = (first, 2);
        let error = Err(ShError::Row { row, height });
        assert_eq!(last.add_rows(&table, first, &[1.0; 72]), error);
    }
    assert_eq!(last, projection);
    // Fewer bands would lose coefficients; more are as good.
    let mut four = Projection::new(4, UVec2::new(8, 2)).unwrap();
    let (expected, found) = (4, 3);
    let few = Err(ShError::FewBands { expected, found });
    assert_eq!(four.add_row(0, &sums), few);
    assert_eq!(four.add_rows(&table, 0, &[1.0; 24]), few);
    assert_eq!(four.coefficients(), [Vec3::ZERO; 36]);
    let mut two = Projection::new(2, UVec2::new(8, 2)).unwrap();
    assert_eq!(two.add_rows(&table, 0, &[1.0; 48]), Ok(()));
    assert!(two.coefficients()[0].x > 0.0);
    // Another map's sums are no part of this one's.
    for other in [
        (3, UVec2::new(8, 2)),
        (2, UVec2::new(8, 3)),
        (2, UVec2::new(4, 2)),
    ] {
        let other = Projection::new(other.0, other.1).unwrap();
        assert_eq!(two.merge(&other), Err(ShError::Another));
    }
    let before = two.coefficients();
    assert_eq!(two.merge(&two.clone()), Ok(()));
    assert_eq!(two.coefficients()[0], 2.0 * before[0]);
    assert!(Projection::new(3, UVec2::new(8, 0)).is_err());
    for error in [
        ShError::Bands(9),
        ShError::Size(UVec2::ZERO),
        ShError::Channels(2),
        ShError::FewBands { expected, found },
        ShError::Another,
    ] {
        assert!(!error.to_string().is_empty());
    }
}
