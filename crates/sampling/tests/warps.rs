//! Host file: warps, frames and weights of `glimt-sampling`.

use glam::{Vec2, Vec3};
use glimt_sampling::warp::{self, DirectionSample};
use glimt_sampling::{ShadingFrame, UniformSource, Xoshiro128PlusPlus, mis, unit_f32, unit_vec2};
use glimt_statistics::quadrature::{
    Direction, integrate_band, integrate_hemisphere, integrate_sphere,
};
use glimt_statistics::stats::{
    Mean, SphereBins, chi_square, kolmogorov_smirnov, sidak, within, z_test,
};

/// Level of all statistical tests of this file together.
const ALPHA: f64 = 0.01;
/// No fewer than there are.
const TESTS: usize = 80;

fn alpha() -> f64 {
    sidak(ALPHA, TESTS)
}

fn generator(key: u32) -> Xoshiro128PlusPlus {
    Xoshiro128PlusPlus::stream(2026, 0, key)
}

fn to_f64(d: Vec3) -> Direction {
    [f64::from(d.x), f64::from(d.y), f64::from(d.z)]
}

fn to_f32(d: Direction) -> Vec3 {
    Vec3::new(d[0] as f32, d[1] as f32, d[2] as f32)
}

// --- Warps ---

type Sampler = Box<dyn Fn(Vec2) -> DirectionSample>;
type Density = Box<dyn Fn(Vec3) -> f32>;
type Inverse = Box<dyn Fn(Vec3) -> Vec2>;

/// One warp onto the sphere with what the tests need to know of it.
struct Warp {
    name: String,
    sample: Sampler,
    pdf_sr: Density,
    invert: Inverse,
    /// The band of cosines that holds its support, for the quadrature.
    band: [f64; 2],
    /// Distribution of the cosine.
    cdf: Box<dyn Fn(f64) -> f64>,
    /// Steepness: rounding of a cosine is magnified so much in `u`.
    gain: f32,
}

fn warps() -> Vec<Warp> {
    let mut all = vec![
        Warp {
            name: "cosine hemisphere".into(),
            sample: Box::new(warp::sample_cosine_hemisphere),
            pdf_sr: Box::new(warp::pdf_cosine_hemisphere_sr),
            invert: Box::new(warp::invert_cosine_hemisphere),
            band: [0.0, 1.0],
            cdf: Box::new(|z| z * z),
            gain: 1.0,
        },
        Warp {
            name: "uniform sphere".into(),
            sample: Box::new(warp::sample_uniform_sphere),
            pdf_sr: Box::new(|_| warp::pdf_uniform_sphere_sr()),
            invert: Box::new(warp::invert_uniform_sphere),
            band: [-1.0, 1.0],
            cdf: Box::new(|z| 0.5 * (z + 1.0)),
            gain: 1.0,
        },
    ];
    for radius in [0.02f32, 0.1, 1.0, 2.0, 3.0] {
        let height = warp::cap_height(radius);
        let h = f64::from(height);
        all.push(Warp {
            name: format!("cap of {radius} rad"),
            sample: Box::new(move |u| warp::sample_cap(u, height)),
            pdf_sr: Box::new(move |d| warp::pdf_cap_sr(d, height)),
            invert: Box::new(move |d| warp::invert_cap(d, height)),
            band: [1.0 - h, 1.0],
            cdf: Box::new(move |z| 1.0 - (1.0 - z) / h),
            gain: 1.0 / height,
        });
    }
    for exponent in [0.0f32, 0.5, 1.0, 5.0, 50.0, 500.0, 10_000.0] {
        let e = f64::from(exponent);
        all.push(Warp {
            name: format!("power cosine {exponent}"),
            sample: Box::new(move |u| warp::sample_power_cosine(u, exponent)),
            pdf_sr: Box::new(move |d| warp::pdf_power_cosine_sr(d, exponent)),
            invert: Box::new(move |d| warp::invert_power_cosine(d, exponent)),
            band: [0.0, 1.0],
            cdf: Box::new(move |z| z.max(0.0).powf(e + 1.0)),
            gain: exponent + 1.0,
        });
    }
    all
}

#[test]
fn densities_integrate_to_one() {
    for w in warps() {
        let pdf = |d: Direction| f64::from((w.pdf_sr)(to_f32(d)));
        let inside = integrate_band(pdf, w.band, 1e-6);
        within(inside.value, 1.0, 1e-5).unwrap_or_else(|e| panic!("{}: {e}", w.name));
        // And to nothing outside of the band, but for directions within rounding of its edge.
        if w.band[0] > -1.0 {
            let outside = integrate_band(pdf, [-1.0, w.band[0] - 1e-6], 1e-6);
            assert_eq!(outside.value, 0.0, "{}", w.name);
        }
    }
}

#[test]
fn samples_carry_their_density() {
    for w in warps() {
        let mut source = generator(4);
        for _ in 0..10_000 {
            let s = (w.sample)(unit_vec2(source.next_uvec2()));
            assert!(
                (s.direction.length() - 1.0).abs() <= 1e-6,
                "{}: {s:?}",
                w.name
            );
            let pdf = (w.pdf_sr)(s.direction);
            assert!(
                (s.pdf_sr - pdf).abs() <= 1e-6 * pdf,
                "{}: {s:?}, {pdf}",
                w.name
            );
        }
    }
}

#[test]
fn corners_of_the_square_are_harmless() {
    let last = unit_f32(u32::MAX);
    for w in warps() {
        for x in [0.0, f32::EPSILON / 2.0, 0.5, last] {
            for y in [0.0, 0.25, 0.5, 0.75, last] {
                let s = (w.sample)(Vec2::new(x, y));
                assert!(
                    (s.direction.length() - 1.0).abs() <= 1e-6,
                    "{}: {s:?}",
                    w.name
                );
                assert!(s.pdf_sr >= 0.0 && s.pdf_sr < 1e6, "{}: {s:?}", w.name);
                let u = (w.invert)(s.direction);
                assert!(
                    u.min_element() >= 0.0 && u.max_element() <= 1.0,
                    "{}: {u}",
                    w.name
                );
            }
        }
    }
}

#[test]
fn samples_follow_their_density() {
    const N: usize = 200_000;
    for (i, w) in warps().into_iter().enumerate() {
        let mut source = generator(10 + i as u32);
        let samples: Vec<Direction> = (0..N)
            .map(|_| to_f64((w.sample)(unit_vec2(source.next_uvec2())).direction))
            .collect();
        // χ² over the sphere, against the density's quadrature; narrow warps have their edge off the bins' edges.
        if w.gain < 10.0 && (w.band[0] * 16.0).fract() == 0.0 {
            let bins = SphereBins {
                rows: 32,
                columns: 32,
            };
            let pdf = |d: Direction| f64::from((w.pdf_sr)(to_f32(d)));
            bins.chi_square(samples.iter().copied().map(Some), pdf, alpha())
                .unwrap_or_else(|e| panic!("{}: {e}", w.name));
        }
        // Both marginals against their closed forms, and both together: the two of a product are independent.
        let turns = |d: &Direction| d[1].atan2(d[0]) / std::f64::consts::TAU + 0.5;
        let mut z: Vec<f64> = samples.iter().map(|d| d[2]).collect();
        let mut around: Vec<f64> = samples.iter().map(turns).collect();
        kolmogorov_smirnov(&mut z, &w.cdf, alpha()).unwrap_or_else(|e| panic!("{}: {e}", w.name));
        kolmogorov_smirnov(&mut around, |x| x, alpha())
            .unwrap_or_else(|e| panic!("{}: {e}", w.name));
        let mut counts = vec![0u64; 1024];
        for d in &samples {
            let row = ((w.cdf)(d[2]) * 32.0).clamp(0.0, 31.0) as usize;
            let column = (turns(d) * 32.0).clamp(0.0, 31.0) as usize;
            counts[row * 32 + column] += 1;
        }
        chi_square(&counts, &vec![N as f64 / 1024.0; 1024], alpha())
            .unwrap_or_else(|e| panic!("{}: {e}", w.name));
    }
}

#[test]
fn warps_invert() {
    for w in warps() {
        let mut source = generator(5);
        for _ in 0..20_000 {
            let u = unit_vec2(source.next_uvec2());
            let d = (w.sample)(u).direction;
            let back = (w.invert)(d);
            // Azimuth is lost at the pole and jumps at the seam: compare there by direction alone.
            let sin_theta = d.truncate().length();
            let tolerance = 1e-6 + 2e-7 * w.gain.min(10.0) + 2e-7 / sin_theta;
            let wrapped = (back.y - u.y).abs();
            assert!(
                (back.x - u.x).abs() <= tolerance
                    && (wrapped <= tolerance
                        || 1.0 - wrapped <= tolerance
                        || w.name == "cosine hemisphere"),
                "{}: {u} → {d} → {back}",
                w.name
            );
            // Rounding of u next to 1 (lobes) or of the disc's radius at the horizon comes back under a square root.
            let again = (w.sample)(back).direction;
            let steep = sin_theta.min(d.z.abs()).max(1e-7);
            let spread = 2e-6 + (2e-7 / steep).min(7e-4);
            assert!(
                (again - d).length() <= spread,
                "{}: {d} → {back} → {again}",
                w.name
            );
        }
    }
}

#[test]
fn concentric_disk_is_uniform_and_inverts() {
    const N: usize = 200_000;
    let mut source = generator(6);
    let mut counts = vec![0u64; 1024];
    let mut radii = Vec::with_capacity(N);
    for _ in 0..N {
        let u = unit_vec2(source.next_uvec2());
        let p = warp::sample_concentric_disk(u);
        assert_eq!(
            warp::pdf_concentric_disk(p * 0.9999),
            std::f32::consts::FRAC_1_PI
        );
        assert!(
            (warp::invert_concentric_disk(p) - u).abs().max_element() <= 1e-6,
            "{u} → {p}"
        );
        let r2 = f64::from(p.length_squared());
        let turns = f64::from(p.y).atan2(f64::from(p.x)) / std::f64::consts::TAU + 0.5;
        counts[(r2 * 32.0).min(31.0) as usize * 32 + (turns * 32.0).min(31.0) as usize] += 1;
        radii.push(r2);
    }
    chi_square(&counts, &vec![N as f64 / 1024.0; 1024], alpha()).unwrap();
    kolmogorov_smirnov(&mut radii, |x| x, alpha()).unwrap();
    assert_eq!(warp::pdf_concentric_disk(Vec2::new(0.8, 0.7)), 0.0);
}

// --- Weights ---

#[test]
fn heuristics_sum_to_one() {
    let mut source = generator(7);
    for _ in 0..10_000 {
        // Densities over many decades.
        let mut pdf = || libm::expf(80.0 * (unit_f32(source.next_u32()) - 0.5));
        let (f, g) = (pdf(), pdf());
        for (n_f, n_g) in [(1, 1), (1, 15), (15, 1), (3, 0)] {
            for heuristic in [mis::balance_heuristic, mis::power_heuristic] {
                let sum = heuristic(n_f, f, n_g, g) + heuristic(n_g, g, n_f, f);
                assert!((sum - 1.0).abs() <= 1e-6, "{n_f} × {f}, {n_g} × {g}: {sum}");
            }
        }
    }
    for heuristic in [mis::balance_heuristic, mis::power_heuristic] {
        assert_eq!(heuristic(1, 0.0, 1, 2.0), 0.0);
        assert_eq!(heuristic(1, 2.0, 1, 0.0), 1.0);
        assert_eq!(heuristic(0, 0.0, 0, 0.0), 0.0);
    }
}

/// Every way to combine a lobe and the cosine has the mean of the quadrature, with unequal counts too.
#[test]
fn combined_estimators_are_unbiased() {
    const EXPONENT: f32 = 30.0;
    // A wide glow and a narrow one, neither centred, cut off by the horizon.
    let axis = Vec3::new(0.6, 0.0, 0.8);
    let f = move |d: Vec3| {
        if d.z > 0.0 {
            d.z * (1.0 + 40.0 * libm::expf(60.0 * (d.dot(axis) - 1.0)))
        } else {
            0.0
        }
    };
    let truth = integrate_hemisphere(|d| f64::from(f(to_f32(d))), 1e-7)
        .converged(1e-6)
        .unwrap();
    let frame = ShadingFrame::from_normal(axis);
    let lobe = move |d: Vec3| warp::pdf_power_cosine_sr(frame.to_local(d), EXPONENT);
    let cosine = warp::pdf_cosine_hemisphere_sr;
    let sample_lobe =
        move |u: Vec2| frame.to_world(warp::sample_power_cosine(u, EXPONENT).direction);
    let sample_cosine = |u: Vec2| warp::sample_cosine_hemisphere(u).direction;

    let mut source = generator(8);
    for (n_l, n_c) in [(1, 1), (3, 2), (1, 7)] {
        let mut weighted = |heuristic: fn(u32, f32, u32, f32) -> f32| {
            Mean::of((0..60_000).map(|_| {
                let mut sum = 0.0;
                for _ in 0..n_l {
                    let d = sample_lobe(unit_vec2(source.next_uvec2()));
                    sum += heuristic(n_l, lobe(d), n_c, cosine(d)) * f(d) / (n_l as f32 * lobe(d));
                }
                for _ in 0..n_c {
                    let d = sample_cosine(unit_vec2(source.next_uvec2()));
                    sum +=
                        heuristic(n_c, cosine(d), n_l, lobe(d)) * f(d) / (n_c as f32 * cosine(d));
                }
                f64::from(sum)
            }))
        };
        z_test(weighted(mis::balance_heuristic), truth, alpha()).unwrap();
        z_test(weighted(mis::power_heuristic), truth, alpha()).unwrap();
        let summed = Mean::of((0..60_000).map(|_| {
            let mut sum = 0.0;
            for i in 0..n_l + n_c {
                let u = unit_vec2(source.next_uvec2());
                let d = if i < n_l {
                    sample_lobe(u)
                } else {
                    sample_cosine(u)
                };
                sum += f(d) / mis::multi_sample_density(n_l, lobe(d), n_c, cosine(d));
            }
            f64::from(sum)
        }));
        z_test(summed, truth, alpha()).unwrap();
    }
    for pmf in [0.1, 0.5, 0.9] {
        let picked = Mean::of((0..200_000).map(|_| {
            let (choice, u) = (unit_f32(source.next_u32()), unit_vec2(source.next_uvec2()));
            let d = if choice < pmf {
                sample_lobe(u)
            } else {
                sample_cosine(u)
            };
            f64::from(f(d) / mis::one_sample_density(pmf, lobe(d), cosine(d)))
        }));
        z_test(picked, truth, alpha()).unwrap();
    }
}

// --- Frames ---

#[test]
fn frames_are_orthonormal_everywhere() {
    let mut source = generator(9);
    let mut normals = vec![
        Vec3::X,
        Vec3::Y,
        Vec3::Z,
        Vec3::NEG_X,
        Vec3::NEG_Y,
        Vec3::NEG_Z,
    ];
    normals.push(Vec3::new(1.0, 0.0, -0.0));
    normals.push(Vec3::new(1e-4, 1e-4, -1.0).normalize());
    normals.extend(
        (0..10_000).map(|_| warp::sample_uniform_sphere(unit_vec2(source.next_uvec2())).direction),
    );
    for n in normals {
        let frame = ShadingFrame::from_normal(n);
        let (t, b) = (frame.t, frame.b);
        assert!((t.cross(b) - n).length() <= 1e-6, "{n}: {t}, {b}");
        assert!((t.length() - 1.0).abs() <= 1e-6 && (b.length() - 1.0).abs() <= 1e-6);
        assert!(t.dot(b).abs() <= 1e-6 && t.dot(n).abs() <= 1e-6 && b.dot(n).abs() <= 1e-6);
        let v = Vec3::new(0.3, -0.5, 0.7);
        assert!((frame.to_local(frame.to_world(v)) - v).length() <= 1e-6);
        assert_eq!(frame.to_world(Vec3::Z), n);
    }
}

/// The quadrature that the densities were held against knows the sphere's area and a polynomial's integral.
#[test]
fn quadrature_knows_closed_forms() {
    let four_pi = 4.0 * std::f64::consts::PI;
    within(integrate_sphere(|_| 1.0, 1e-12).value, four_pi, 1e-12).unwrap();
    within(
        integrate_sphere(|d| d[0] * d[0], 1e-12).value,
        four_pi / 3.0,
        1e-12,
    )
    .unwrap();
    within(
        integrate_sphere(|d| (d[0] * d[1] * d[2]).powi(2), 1e-12).value,
        four_pi / 105.0,
        1e-12,
    )
    .unwrap();
}
