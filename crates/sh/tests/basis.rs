//! Host file: the basis, and what is done with a light's coefficients.

use std::f64::consts::{PI, TAU};

use glam::{Mat3, UVec2, Vec2, Vec3};
use glimt_sampling::{UniformSource, Xoshiro128PlusPlus, unit_f32, unit_vec2, warp};
use glimt_sh::separable::{meridian_index, ring_index};
use glimt_sh::{
    LightCoefficients, SampledProjection, Z_UP_TO_Y_UP, add_basis, basis, coefficient_band,
    coefficient_index, coefficient_order, condon_shortley, cosine_lobe, evaluate,
    filament_irradiance, from_filament_irradiance, hann, irradiance, meridian, ring, rotate_z,
    rotated, stratified_direction, temporal_filter, temporally_filtered, windowed,
};
use glimt_statistics::harmonics::{harmonic, indices, sphere_rule};
use glimt_statistics::quadrature::{Direction, direction, gauss_legendre};
use glimt_statistics::worst::{larger, worst};

fn to_f64(d: Vec3) -> Direction {
    [f64::from(d.x), f64::from(d.y), f64::from(d.z)]
}

fn to_f32(d: Direction) -> Vec3 {
    Vec3::new(d[0] as f32, d[1] as f32, d[2] as f32)
}

/// Directions all over the sphere, with the axes and the neighbourhood of the poles.
fn directions() -> Vec<Vec3> {
    let mut source = Xoshiro128PlusPlus::stream(11, 0, 0);
    let mut all = vec![
        Vec3::X,
        Vec3::Y,
        Vec3::Z,
        Vec3::NEG_X,
        Vec3::NEG_Y,
        Vec3::NEG_Z,
        Vec3::new(1e-4, -1e-4, 1.0).normalize(),
        Vec3::new(-1e-20, 1e-20, -1.0),
    ];
    let uniform = || warp::sample_uniform_sphere(unit_vec2(source.next_uvec2())).direction;
    all.extend(std::iter::repeat_with(uniform).take(4000));
    all
}

/// A light whose coefficients are random in [−1, 1].
fn light(seed: u32) -> LightCoefficients {
    let mut source = Xoshiro128PlusPlus::stream(seed, 0, 1);
    let mut number = || 2.0 * unit_f32(source.next_u32()) - 1.0;
    std::array::from_fn(|_| Vec3::new(number(), number(), number()))
}

/// The largest difference of two lights, relative to the largest coefficient; NaN where there is one.
fn difference(a: &LightCoefficients, b: &LightCoefficients) -> f64 {
    let differences = a
        .iter()
        .zip(b)
        .flat_map(|(a, b)| (*a - *b).abs().to_array());
    worst(differences) / worst(a.iter().flat_map(|c| c.abs().to_array()))
}

#[test]
fn a_nan_is_a_difference() {
    let c = light(3);
    for k in [0, 17, 35] {
        for channel in 0..3 {
            let mut wrong = c;
            wrong[k][channel] = f32::NAN;
            assert!(difference(&c, &wrong).is_nan(), "{k} {channel}");
            assert!(difference(&wrong, &c).is_nan(), "{k} {channel}");
        }
    }
    let (error, k) = worst_function(|d, k| if k == 7 { f32::NAN } else { basis(d)[k] });
    assert!(error.is_nan() && k == 7);
    // Of one direction among many.
    let (error, _) = worst_function(|d, k| if d == Vec3::Z { f32::NAN } else { basis(d)[k] });
    assert!(error.is_nan());
}

/// How far values are from the oracle's, relative to the largest that the oracle has for the function, and for which
/// function.
fn worst_function(value: impl Fn(Vec3, usize) -> f32) -> (f64, usize) {
    let indices = indices(6);
    let (mut error, mut size) = ([0.0f64; 36], [0.0f64; 36]);
    for d in directions() {
        for (k, &(l, m)) in indices.iter().enumerate() {
            let exact = harmonic(l, m, to_f64(d));
            error[k] = larger(error[k], (f64::from(value(d, k)) - exact).abs());
            size[k] = size[k].max(exact.abs());
        }
    }
    let relative: [f64; 36] = std::array::from_fn(|k| error[k] / size[k]);
    let largest = worst(relative);
    let which = relative
        .iter()
        .position(|one| one.total_cmp(&largest).is_eq());
    (largest, which.unwrap_or(0))
}

#[test]
fn the_oracle_is_orthonormal() {
    let indices = indices(12);
    let mut products = vec![0.0; indices.len() * indices.len()];
    for (d, weight) in sphere_rule(22) {
        let values: Vec<f64> = indices.iter().map(|&(l, m)| harmonic(l, m, d)).collect();
        for (row, a) in products.chunks_mut(values.len()).zip(&values) {
            for (sum, b) in row.iter_mut().zip(&values) {
                *sum += weight * a * b;
            }
        }
    }
    for (i, product) in products.iter().enumerate() {
        let same = i / indices.len() == i % indices.len();
        let exact = f64::from(u8::from(same));
        assert!((product - exact).abs() < 1e-12, "{i}: {product}");
    }
}

#[test]
fn the_basis_is_the_oracle() {
    let (error, k) = worst_function(|d, k| basis(d)[k]);
    println!("basis: {error:e} at {k}");
    assert!(error <= 1e-6, "{error:e} at {k}");
    let (error, k) = worst_function(|d, k| {
        let (l, m) = (coefficient_band(k as u32), coefficient_order(k as u32));
        let (z, s) = (d.z, d.x.hypot(d.y));
        let phi = if s > 0.0 { d.truncate() / s } else { Vec2::X };
        let along = meridian(z, s)[meridian_index(l, m.unsigned_abs()) as usize];
        along * ring(phi.x, phi.y)[ring_index(m) as usize]
    });
    println!("ring and meridian: {error:e} at {k}");
    assert!(error <= 1e-6, "{error:e} at {k}");
    // Another sign of odd m, and another place of y_2m, are noticed.
    let (wrong, _) = worst_function(|d, k| condon_shortley(&[Vec3::ONE; 36])[k].x * basis(d)[k]);
    assert!(!(wrong <= 1e-6));
    let (wrong, _) = worst_function(|d, k| basis(d)[if k == 5 { 7 } else { k }]);
    assert!(!(wrong <= 1e-6));
}

#[test]
fn the_basis_is_orthonormal() {
    let mut products = [[0.0f64; 36]; 36];
    for (d, weight) in sphere_rule(10) {
        let y = basis(to_f32(d)).map(f64::from);
        for (row, a) in products.iter_mut().zip(y) {
            for (sum, b) in row.iter_mut().zip(y) {
                *sum += weight * a * b;
            }
        }
    }
    for (i, row) in products.iter().enumerate() {
        for (j, product) in row.iter().enumerate() {
            let exact = f64::from(u8::from(i == j));
            assert!((product - exact).abs() <= 1e-6, "{i} {j}: {product}");
        }
    }
}

#[test]
fn only_the_bands_asked_for_are_added() {
    for bands in 0..=8 {
        for d in directions().into_iter().take(50) {
            let mut sums = [0.25; 36];
            add_basis(bands, d, -1.5, &mut sums);
            let y = basis(d);
            for (k, sum) in sums.iter().enumerate() {
                let added = coefficient_band(k as u32) < bands;
                let exact = if added { 0.25 - 1.5 * y[k] } else { 0.25 };
                assert_eq!(*sum, exact, "{bands} bands, {k}");
            }
        }
    }
}

#[test]
fn indices_lead_there_and_back() {
    for (k, (l, m)) in indices(6).into_iter().enumerate() {
        assert_eq!(coefficient_index(l, m), k as u32);
        assert_eq!(
            (coefficient_band(k as u32), coefficient_order(k as u32)),
            (l, m)
        );
    }
}

#[test]
fn windows() {
    for l in 0..6 {
        for window in [0.5, 1.0, 3.0, 4.7, 6.0, 100.0f32] {
            let (l_exact, w) = (f64::from(l), f64::from(window));
            let exact = if l_exact <= w {
                0.5 * (1.0 + (PI * l_exact / w).cos())
            } else {
                0.0
            };
            assert!(
                (f64::from(hann(l, window)) - exact).abs() < 1e-6,
                "{l} {window}"
            );
        }
        for none in [0.0, -1.0, f32::NAN] {
            assert_eq!(hann(l, none), 1.0);
        }
    }
    let c = light(1);
    assert_eq!(windowed(&c, 0.0), c);
    assert_eq!(windowed(&c, 3.0)[9..], [Vec3::ZERO; 27]);
}

/// `A_l = 2π ∫ z P_l(z) dz` over z in [0, 1], from the oracle's zonal functions.
#[test]
fn the_clamped_cosine() {
    for l in 0..6 {
        let norm = (4.0 * PI / f64::from(2 * l + 1)).sqrt();
        let rule = gauss_legendre(12)
            .into_iter()
            .map(|(x, w)| (0.5 + 0.5 * x, 0.5 * w));
        let zonal = |z: f64| norm * harmonic(l, 0, direction(z, 0.0));
        let exact = TAU * rule.map(|(z, w)| w * z * zonal(z)).sum::<f64>();
        assert!(
            (f64::from(cosine_lobe(l)) - exact).abs() < 1e-6,
            "{l}: {exact}"
        );
    }
    assert_eq!([cosine_lobe(6), cosine_lobe(100)], [0.0; 2]);
}

/// Irradiance of a light at a normal, in f64: Gauss's rule over the hemisphere about the normal.
fn irradiance_by_quadrature(light: &LightCoefficients, normal: Vec3) -> f64 {
    let indices = indices(6);
    let to_normal = frame_of(unit(to_f64(normal)));
    let mut sum = 0.0;
    for (x, w) in gauss_legendre(8) {
        let z = 0.5 + 0.5 * x;
        for i in 0..12 {
            let local = direction(z, TAU * f64::from(i) / 12.0);
            let d: Direction =
                std::array::from_fn(|r| (0..3).map(|c| to_normal[c][r] * local[c]).sum::<f64>());
            let mut radiance = 0.0;
            for (c, &(l, m)) in light.iter().zip(&indices) {
                radiance += f64::from(c.y) * harmonic(l, m, d);
            }
            sum += 0.5 * w * TAU / 12.0 * z * radiance;
        }
    }
    sum
}

/// Two vectors at right angles to n and each other, and n.
fn frame_of(n: Direction) -> [Direction; 3] {
    let helper = if n[0].abs() < 0.5 {
        [1.0, 0.0, 0.0]
    } else {
        [0.0, 1.0, 0.0]
    };
    let tangent = unit(cross(helper, n));
    [tangent, cross(n, tangent), n]
}

fn cross(a: Direction, b: Direction) -> Direction {
    let at = |i: usize, j: usize| a[i] * b[j] - a[j] * b[i];
    [at(1, 2), at(2, 0), at(0, 1)]
}

fn unit(d: Direction) -> Direction {
    let length = d.iter().map(|x| x * x).sum::<f64>().sqrt();
    d.map(|x| x / length)
}

#[test]
fn irradiance_is_an_integral() {
    let c = light(2);
    let e = irradiance(&c);
    let (mut error, mut wrong) = (0.0f64, 0.0f64);
    for n in directions().into_iter().skip(2).take(60) {
        let exact = irradiance_by_quadrature(&c, n);
        error = larger(error, (f64::from(evaluate(&e, n).y) - exact).abs());
        wrong = larger(wrong, (f64::from(evaluate(&c, n).y) * PI - exact).abs());
    }
    println!("irradiance: {error:e}");
    assert!(error <= 5e-6, "{error:e}");
    assert!(!(wrong <= 5e-6), "radiance passes for irradiance");
}

#[test]
fn a_step_of_light_is_followed() {
    for alpha in [0.0, 0.25, 1.0, 9.0f32] {
        let (mut one, mut all) = (0.0f32, [Vec3::ZERO; 36]);
        for frame in 1..40 {
            one = temporal_filter(1.0, one, alpha);
            all = temporally_filtered(&[Vec3::ONE; 36], &all, alpha);
            let kept = f64::from(alpha) / (1.0 + f64::from(alpha));
            let exact = 1.0 - kept.powi(frame);
            assert!(
                (f64::from(one) - exact).abs() < 1e-5,
                "{alpha} {frame}: {one} {exact}"
            );
            assert_eq!(all, [Vec3::splat(one); 36]);
        }
    }
    for none in [-1.0, 0.0, f32::NAN] {
        assert_eq!(temporal_filter(2.0, 7.0, none), 2.0);
    }
    // However large, and whatever it is multiplied by.
    for all in [1e37, f32::MAX, f32::INFINITY] {
        assert_eq!(temporal_filter(1.0, 100.0, all), 100.0);
        assert!(temporal_filter(1.0, 0.0, all) <= 1e-37);
    }
    // Steady light stays as it is.
    for alpha in [0.3, 7.0, 1e6] {
        assert_eq!(temporal_filter(0.1, 0.1, alpha), 0.1);
    }
}

fn rotations() -> Vec<Mat3> {
    let mut source = Xoshiro128PlusPlus::stream(3, 0, 2);
    let mut all = vec![
        Mat3::IDENTITY,
        Mat3::from_diagonal(Vec3::new(1.0, -1.0, 1.0)),
        Z_UP_TO_Y_UP,
    ];
    for _ in 0..20 {
        let axis = warp::sample_uniform_sphere(unit_vec2(source.next_uvec2())).direction;
        all.push(Mat3::from_axis_angle(
            axis,
            6.0 * unit_f32(source.next_u32()),
        ));
    }
    all
}

/// The coefficients of the light turned, from the oracle's values of it.
fn projected_again(light: &LightCoefficients, rotation: &Mat3) -> LightCoefficients {
    let indices = indices(6);
    let mut sums = [[0.0f64; 3]; 36];
    for (d, weight) in sphere_rule(12) {
        let from = to_f64(rotation.transpose() * to_f32(d));
        let mut value = [0.0; 3];
        for (c, &(l, m)) in light.iter().zip(&indices) {
            let y = harmonic(l, m, from);
            for (value, c) in value.iter_mut().zip(c.to_array()) {
                *value += y * f64::from(c);
            }
        }
        for (sum, &(l, m)) in sums.iter_mut().zip(&indices) {
            let y = weight * harmonic(l, m, d);
            for (sum, value) in sum.iter_mut().zip(value) {
                *sum += y * value;
            }
        }
    }
    sums.map(|[r, g, b]| Vec3::new(r as f32, g as f32, b as f32))
}

#[test]
fn a_turned_light_is_the_light_of_turned_directions() {
    let c = light(4);
    for rotation in rotations() {
        let turned = rotated(&c, &rotation);
        let found = difference(&projected_again(&c, &rotation), &turned);
        assert!(found <= 2e-6, "{rotation}: {found:e}");
        let back = difference(&c, &rotated(&turned, &rotation.transpose()));
        assert!(back <= 2e-6, "{rotation}: {back:e}");
        if rotation != Mat3::IDENTITY {
            let wrong = difference(&projected_again(&c, &rotation.transpose()), &turned);
            let own_inverse = rotation.transpose() == rotation;
            assert!(own_inverse || !(wrong <= 2e-6), "the inverse passes");
        }
    }
}

#[test]
fn a_faint_band_survives_beside_a_bright_one() {
    let mut c = [Vec3::ZERO; 36];
    c[0] = Vec3::splat(1e6);
    for (k, c) in c.iter_mut().enumerate().skip(25) {
        *c = Vec3::splat(1e-3 * k as f32);
    }
    for rotation in rotations() {
        let turned = rotated(&c, &rotation);
        let norm =
            |c: &LightCoefficients| c[25..].iter().map(|c| f64::from(c.x).powi(2)).sum::<f64>();
        assert!((norm(&turned) / norm(&c) - 1.0).abs() < 1e-5, "{rotation}");
    }
}

#[test]
fn turning_about_the_vertical_is_cheap() {
    let c = light(5);
    for degrees in [0.0, 10.0, 90.0, 200.0, -35.0f32] {
        let angle = degrees.to_radians();
        let cos_sin = Vec2::new(angle.cos(), angle.sin());
        let cheap: LightCoefficients = std::array::from_fn(|k| {
            let (l, m) = (coefficient_band(k as u32), coefficient_order(k as u32));
            let opposite = c[coefficient_index(l, -m) as usize];
            let channel = |i: usize| rotate_z(m, c[k][i], opposite[i], cos_sin);
            Vec3::new(channel(0), channel(1), channel(2))
        });
        let found = difference(&rotated(&c, &Mat3::from_rotation_z(angle)), &cheap);
        assert!(found <= 2e-6, "{degrees}: {found:e}");
        let wrong = difference(&rotated(&c, &Mat3::from_rotation_z(angle + 0.01)), &cheap);
        assert!(!(wrong <= 2e-6));
    }
}

/// DirectX's first three bands as its documentation and constants have them; beyond, the sign alone.
#[test]
fn conventions_describe_the_same_light() {
    let c = light(6);
    let theirs = condon_shortley(&c);
    assert_eq!(condon_shortley(&theirs), c);
    for d in directions().into_iter().take(200) {
        let Vec3 { x, y, z } = d;
        let mut value: f64 = [
            0.282_094_8,
            -0.488_602_5 * y,
            0.488_602_5 * z,
            -0.488_602_5 * x,
            1.092_548_4 * x * y,
            -1.092_548_4 * y * z,
            0.315_391_6 * (3.0 * z * z - 1.0),
            -1.092_548_4 * x * z,
            0.546_274_2 * (x * x - y * y),
        ]
        .iter()
        .zip(&theirs)
        .map(|(y, c)| f64::from(y * c.x))
        .sum();
        for (&(l, m), c) in indices(6).iter().zip(&theirs).skip(9) {
            let sign = if m % 2 == 0 { 1.0 } else { -1.0 };
            value += sign * harmonic(l, m, to_f64(d)) * f64::from(c.x);
        }
        assert!((value - f64::from(evaluate(&c, d).x)).abs() < 1e-5);
    }
}

#[test]
fn engines_irradiance() {
    let mut c = light(7);
    c[9..].fill(Vec3::ZERO);
    let e = filament_irradiance(&c);
    // The scales that engines document.
    let scales = [
        0.282095, 0.325735, 0.325735, 0.325735, 0.273137, 0.273137, 0.078848, 0.273137, 0.136569,
    ];
    for (k, scale) in scales.into_iter().enumerate() {
        assert!((e[k] - c[k] * scale).length() < 2e-6, "{k}");
    }
    for n in directions().into_iter().skip(2).take(30) {
        let polynomial = e[0]
            + e[1] * n.y
            + e[2] * n.z
            + e[3] * n.x
            + e[4] * (n.x * n.y)
            + e[5] * (n.y * n.z)
            + e[6] * (3.0 * n.z * n.z - 1.0)
            + e[7] * (n.z * n.x)
            + e[8] * (n.x * n.x - n.y * n.y);
        let exact = irradiance_by_quadrature(&c, n) / PI;
        assert!((f64::from(polynomial.y) - exact).abs() < 2e-6);
    }
    let back = from_filament_irradiance(&e);
    assert!(difference(&c, &back) < 1e-6);
    assert!(!(difference(&c, &windowed(&back, 5.0)) < 1e-6));
}

#[test]
fn strata_are_equal_parts() {
    let strata = UVec2::new(5, 7);
    let mut source = Xoshiro128PlusPlus::stream(8, 0, 3);
    for i in 0..70 {
        let d = stratified_direction(i, strata, unit_vec2(source.next_uvec2()));
        let row = (0.5 - 0.5 * d.z) * 5.0;
        let column = d.y.atan2(d.x).rem_euclid(TAU as f32) / TAU as f32 * 7.0;
        let place = UVec2::new(i / 7 % 5, i % 7).as_vec2();
        let inside = Vec2::new(row, column) - place;
        assert!(
            inside.min_element() > -1e-4 && inside.max_element() < 1.0 + 1e-4,
            "{i}: {inside}"
        );
        assert!((d.length() - 1.0).abs() < 1e-6);
    }
    assert_eq!(stratified_direction(3, UVec2::ZERO, Vec2::ZERO), Vec3::Z);
}

/// The transfer of an open point, from samples: within five standard errors of its closed form, over 64 independent
/// estimates.
#[test]
fn samples_find_the_clamped_cosine() {
    let n = Vec3::new(0.48, -0.6, 0.64);
    let exact: [f64; 36] = {
        let y = basis(n);
        std::array::from_fn(|k| f64::from(cosine_lobe(coefficient_band(k as u32)) * y[k]))
    };
    let strata = UVec2::splat(10);
    let (mut sum, mut squares) = ([0.0f64; 36], [0.0f64; 36]);
    let runs = 64;
    for run in 0..runs {
        let mut source = Xoshiro128PlusPlus::stream(9, run, 4);
        let [mut first, mut second] = [SampledProjection::new(); 2];
        for i in 0..100 {
            let d = stratified_direction(i, strata, unit_vec2(source.next_uvec2()));
            let half = if i % 2 == 0 { &mut first } else { &mut second };
            half.add(d, d.dot(n).max(0.0));
        }
        first.merge(&second);
        assert_eq!(first.count(), 100);
        for (k, c) in first.coefficients().into_iter().enumerate() {
            sum[k] += f64::from(c);
            squares[k] += f64::from(c).powi(2);
        }
    }
    let far = |exact: &[f64; 36]| {
        let count = f64::from(runs);
        let z = (0..36).map(|k| {
            let mean = sum[k] / count;
            let variance = (squares[k] / count - mean * mean) / (count - 1.0);
            (mean - exact[k]).abs() / variance.sqrt()
        });
        worst(z)
    };
    println!("{} standard errors", far(&exact));
    assert!(far(&exact) < 5.0);
    let mut wrong = exact;
    wrong[2] *= 1.1;
    assert!(
        !(far(&wrong) < 5.0),
        "a coefficient that is off by a tenth passes"
    );
    assert_eq!(SampledProjection::default().coefficients(), [0.0; 36]);
}
