//! Host file: Lambert and Blinn-Phong held against quadrature, χ², and an f64 oracle.

use std::f64::consts::{FRAC_1_PI, FRAC_PI_2, PI, TAU};

use glam::Vec3;
use glimt_brdf::{BlinnPhong, Lambert, MAX_EXPONENT, MaterialError, cosine_power, normalisation};
use glimt_sampling::{UniformSource, Xoshiro128PlusPlus, unit_vec2};
use glimt_statistics::quadrature::{Direction, direction, gauss_legendre, integrate_hemisphere};
use glimt_statistics::stats::{Mean, SphereBins, Verdict, chi_square, sidak, within, z_test};
use proptest::prelude::{
    ProptestConfig, Strategy, any, prop_assert, prop_assert_eq, prop_assume, proptest,
};

const EXPONENTS: [f32; 6] = [0.0, 1.0, 5.0, 50.0, 500.0, 10_000.0];
/// Cosines of `wo` from the normal to grazing.
const COSINES: [f64; 4] = [1.0, 0.8, 0.3, 0.04];
const ALPHA: f64 = 0.01;

fn to_f32(d: Direction) -> Vec3 {
    Vec3::from_array(d.map(|x| x as f32))
}

fn to_f64(d: Vec3) -> Direction {
    d.to_array().map(f64::from)
}

fn tilted(cosine: f64) -> Vec3 {
    to_f32(direction(cosine, 0.0))
}

/// A white material whose specular lobe has the share `specular` of the albedo.
fn material(specular: f32, exponent: f32) -> BlinnPhong {
    BlinnPhong::new(Vec3::splat(1.0 - specular), Vec3::splat(specular), exponent).unwrap()
}

/// Polar coordinates about the mirror direction of a `wo` in the plane y = 0: `α` from it, `β` from the upward side.
/// A narrow lobe is smooth in them, and the horizon is a known `α` for each `β`.
struct MirrorFrame {
    sine: f64,
    cosine: f64,
    /// How strongly radii crowd towards the lobe's centre.
    grading: f64,
    /// How much narrower the lobe is across the plane of incidence than along it: by the cosine of `wo`, if it is
    /// narrow at all.
    squeeze: f64,
}

impl MirrorFrame {
    fn new(wo: Vec3, exponent: f32) -> Self {
        let (sine, cosine) = (f64::from(wo.x), f64::from(wo.z));
        let length = sine.hypot(cosine);
        Self {
            sine: sine / length,
            cosine: cosine / length,
            grading: (1.0 + f64::from(exponent)).sqrt().ln().max(0.1) + 1.0,
            squeeze: (4.0 / (1.0 + f64::from(exponent)).sqrt())
                .min(1.0)
                .max(cosine / length),
        }
    }

    fn direction(&self, alpha: f64, beta: f64) -> Vec3 {
        // The mirror direction is (−sine, 0, cosine), the upward one (cosine, 0, sine).
        let (along, up, across) = (
            alpha.cos(),
            alpha.sin() * beta.cos(),
            alpha.sin() * beta.sin(),
        );
        to_f32([
            self.cosine * up - self.sine * along,
            across,
            self.cosine * along + self.sine * up,
        ])
    }

    fn horizon(&self, beta: f64) -> f64 {
        self.cosine.atan2(-self.sine * beta.cos())
    }

    /// Azimuths for `t ∈ [0, 1]`, with their derivative: in each quarter they crowd towards the plane of incidence.
    fn crowded(&self, t: f64) -> (f64, f64) {
        let quarter = (4.0 * t).floor();
        let from_plane = quarter % 2.0 == 0.0;
        let s = 4.0 * t - quarter;
        let k = 1.0 - self.squeeze.ln();
        let x = k * if from_plane { s } else { 1.0 - s };
        let scale = FRAC_PI_2 / k.sinh();
        let angle = scale * x.sinh();
        let beta = if from_plane {
            quarter * FRAC_PI_2 + angle
        } else {
            (quarter + 1.0) * FRAC_PI_2 - angle
        };
        (beta, 4.0 * scale * k * x.cosh())
    }

    /// Radii for `t ∈ [0, 1]` up to `alpha_max`, with their derivative.
    fn graded(&self, t: f64, alpha_max: f64) -> (f64, f64) {
        let scale = alpha_max / self.grading.sinh();
        let x = self.grading * t;
        (scale * x.sinh(), scale * self.grading * x.cosh())
    }

    /// `α` and `β` of a direction.
    fn coordinates(&self, d: Vec3) -> (f64, f64) {
        let [x, y, z] = to_f64(d);
        let along = self.cosine * z - self.sine * x;
        let up = self.cosine * x + self.sine * z;
        let beta = y.atan2(up);
        (
            up.hypot(y).atan2(along),
            if beta < 0.0 { beta + TAU } else { beta },
        )
    }

    /// Integral of a function over the hemisphere above the horizon.
    fn integrate(&self, f: impl Fn(Vec3) -> f64) -> f64 {
        const PANELS: usize = 16;
        let rule = gauss_legendre(12);
        let nodes: Vec<(f64, f64)> = (0..PANELS)
            .flat_map(|panel| {
                rule.iter().map(move |(x, weight)| {
                    let half = 0.5 / PANELS as f64;
                    (
                        (panel as f64 + 0.5) / PANELS as f64 + half * x,
                        half * weight,
                    )
                })
            })
            .collect();
        let mut sum = 0.0;
        for (b, weight_b) in &nodes {
            let (beta, slope_b) = self.crowded(*b);
            let horizon = self.horizon(beta);
            for (t, weight_t) in &nodes {
                let (alpha, slope) = self.graded(*t, horizon);
                let area = weight_b * slope_b * weight_t * slope * alpha.sin();
                sum += area * f(self.direction(alpha, beta));
            }
        }
        sum
    }
}

const RINGS: usize = 16;
const SECTORS: usize = 12;

/// Cells of rings and sectors about the mirror direction, and a last one for impossible samples. Rings are drawn in where
/// the horizon is near, so that it cuts no sliver off a cell that the quadrature's points would miss.
fn cell(frame: &MirrorFrame, edges: &[f64], d: Option<Vec3>) -> usize {
    let Some(d) = d else { return RINGS * SECTORS };
    let (alpha, beta) = frame.coordinates(d);
    let drawn_out = alpha * PI / frame.horizon(beta);
    let ring = edges[1..RINGS].partition_point(|edge| *edge <= drawn_out);
    let sector = ((beta / TAU * SECTORS as f64) as usize).min(SECTORS - 1);
    ring * SECTORS + sector
}

fn ring_edges(frame: &MirrorFrame) -> Vec<f64> {
    (0..=RINGS)
        .map(|i| frame.graded(i as f64 / RINGS as f64, PI).0)
        .collect()
}

/// Integral of a density over each cell; the last gets what `impossible` says.
fn cell_masses(frame: &MirrorFrame, pdf_sr: impl Fn(Vec3) -> f64, impossible: f64) -> Vec<f64> {
    let rule = gauss_legendre(8);
    let edges = ring_edges(frame);
    let mut masses = vec![0.0; RINGS * SECTORS + 1];
    for ring in 0..RINGS {
        for sector in 0..SECTORS {
            // Halves of a sector, so that the horizon's bend costs little.
            for half in 0..2 {
                let width = TAU / (2 * SECTORS) as f64;
                for (x, weight_b) in &rule {
                    let beta = width * ((2 * sector + half) as f64 + 0.5 + 0.5 * x);
                    let scale = frame.horizon(beta) / PI;
                    let (inner, outer) = (scale * edges[ring], scale * edges[ring + 1]);
                    let width_a = outer - inner;
                    for (y, weight_a) in &rule {
                        let alpha = inner + width_a * (0.5 + 0.5 * y);
                        let area = 0.25 * width * width_a * weight_a * weight_b * alpha.sin();
                        masses[ring * SECTORS + sector] +=
                            area * pdf_sr(frame.direction(alpha, beta));
                    }
                }
            }
        }
    }
    masses[RINGS * SECTORS] = impossible;
    masses
}

/// Probability that the half-vector sampling reflects `wo` below the horizon, by one integral over `u` with the
/// azimuths solved for: independent of the density under test.
fn impossible_reflection(cosine: f64, exponent: f32) -> f64 {
    let sine = (1.0 - cosine * cosine).sqrt();
    let panels = 2000;
    let rule = gauss_legendre(4);
    let mut sum = 0.0;
    for panel in 0..panels {
        for (x, weight) in &rule {
            let u = (panel as f64 + 0.5 + 0.5 * x) / panels as f64;
            let ch = u.powf(1.0 / (f64::from(exponent) + 1.0));
            let sh = ((1.0 - ch) * (1.0 + ch)).sqrt();
            // wi.z = 2 (wo·h) ch − cos θo > 0, with wo·h = so sh cos φ + co ch.
            let least = cosine * (1.0 - 2.0 * ch * ch);
            let possible = if sine * sh * ch <= 1e-15 {
                if least < 0.0 { 1.0 } else { 0.0 }
            } else {
                (least / (2.0 * ch * sh * sine)).clamp(-1.0, 1.0).acos() * FRAC_1_PI
            };
            sum += 0.5 * weight * (1.0 - possible) / panels as f64;
        }
    }
    sum
}

fn draws(brdf: &BlinnPhong, wo: Vec3, seed: u32, n: usize) -> Vec<Option<Vec3>> {
    let mut source = Xoshiro128PlusPlus::stream(seed, 0, 0);
    (0..n)
        .map(|_| {
            let u_lobe = source.next_u32();
            let s = brdf.sample(wo, u_lobe, unit_vec2(source.next_uvec2()));
            (s.pdf_sr > 0.0).then_some(s.wi)
        })
        .collect()
}

fn chi_square_of(
    samples: &[Option<Vec3>],
    frame: &MirrorFrame,
    pdf_sr: impl Fn(Vec3) -> f64,
    impossible: f64,
    alpha: f64,
) -> Verdict {
    let edges = ring_edges(frame);
    let mut observed = vec![0; RINGS * SECTORS + 1];
    for d in samples {
        observed[cell(frame, &edges, *d)] += 1;
    }
    let n = samples.len() as f64;
    let expected: Vec<f64> = cell_masses(frame, pdf_sr, impossible)
        .into_iter()
        .map(|m| m * n)
        .collect();
    chi_square(&observed, &expected, alpha)
}

/// The density with the Jacobian `1/(4 cos θ_h)` instead of `1/(4 wo·h)`: a plausible slip.
fn wrong_jacobian(brdf: &BlinnPhong, wo: Vec3, wi: Vec3) -> f64 {
    let h = (wo + wi).normalize();
    f64::from(brdf.pdf_sr(wo, wi) * wo.dot(h) / h.z)
}

#[test]
fn density_and_impossible_samples_make_one() {
    for exponent in EXPONENTS {
        for cosine in COSINES {
            for specular in [1.0, 0.3] {
                let (brdf, wo) = (material(specular, exponent), tilted(cosine));
                let frame = MirrorFrame::new(wo, exponent);
                let mass = frame.integrate(|wi| f64::from(brdf.pdf_sr(wo, wi)));
                let pmf = f64::from(brdf.pmf_specular());
                let impossible = pmf * impossible_reflection(f64::from(wo.z), exponent);
                within(mass + impossible, 1.0, 2e-5).unwrap_or_else(|e| {
                    panic!("e = {exponent}, cosine {cosine}, specular {specular}: {e}")
                });
            }
        }
    }
}

#[test]
fn a_wrong_jacobian_does_not_make_one() {
    for exponent in [5.0, 50.0, 10_000.0] {
        let (brdf, wo) = (material(1.0, exponent), tilted(0.3));
        let frame = MirrorFrame::new(wo, exponent);
        let mass = frame.integrate(|wi| wrong_jacobian(&brdf, wo, wi));
        let impossible = impossible_reflection(f64::from(wo.z), exponent);
        assert!(
            within(mass + impossible, 1.0, 2e-5).is_err(),
            "e = {exponent}: {mass}"
        );
    }
}

#[test]
fn half_of_a_wide_lobe_is_impossible_at_grazing() {
    within(impossible_reflection(1e-6, 1.0), 0.5, 1e-3).unwrap();
    within(impossible_reflection(1.0, 10_000.0), 0.0, 1e-9).unwrap();
}

#[test]
fn samples_have_their_density() {
    let n = 200_000;
    let alpha = sidak(ALPHA, EXPONENTS.len() * COSINES.len() * 2);
    let mut seed = 0;
    for exponent in EXPONENTS {
        for cosine in COSINES {
            for specular in [1.0, 0.3] {
                seed += 1;
                let (brdf, wo) = (material(specular, exponent), tilted(cosine));
                let frame = MirrorFrame::new(wo, exponent);
                let impossible = f64::from(brdf.pmf_specular())
                    * impossible_reflection(f64::from(wo.z), exponent);
                let samples = draws(&brdf, wo, seed, n);
                let pdf_sr = |wi| f64::from(brdf.pdf_sr(wo, wi));
                chi_square_of(&samples, &frame, pdf_sr, impossible, alpha).unwrap_or_else(|e| {
                    panic!("e = {exponent}, cosine {cosine}, specular {specular}: {e}")
                });
            }
        }
    }
}

#[test]
fn chi_square_sees_wrong_densities_and_wrong_samples() {
    let n = 200_000;
    for exponent in [5.0, 500.0, 10_000.0] {
        let (brdf, wo) = (material(1.0, exponent), tilted(0.3));
        let frame = MirrorFrame::new(wo, exponent);
        let impossible = impossible_reflection(f64::from(wo.z), exponent);
        let samples = draws(&brdf, wo, 7, n);
        let right = |wi| f64::from(brdf.pdf_sr(wo, wi));
        chi_square_of(&samples, &frame, right, impossible, ALPHA).unwrap();
        let wrong = |wi| wrong_jacobian(&brdf, wo, wi);
        assert!(
            chi_square_of(&samples, &frame, wrong, impossible, ALPHA).is_err(),
            "Jacobian, e = {exponent}"
        );
        // A lobe narrower by a tenth.
        let narrow = draws(&material(1.0, exponent * 1.2), wo, 7, n);
        if exponent < MAX_EXPONENT {
            assert!(
                chi_square_of(&narrow, &frame, right, impossible, ALPHA).is_err(),
                "exponent, e = {exponent}"
            );
        }
        // Impossible samples drawn again instead of counted.
        let redrawn: Vec<_> = samples.iter().filter(|s| s.is_some()).copied().collect();
        if impossible > 0.01 {
            assert!(
                chi_square_of(&redrawn, &frame, right, impossible, ALPHA).is_err(),
                "redrawn, e = {exponent}"
            );
        }
    }
}

fn albedo(brdf: &BlinnPhong, cosine: f64) -> f64 {
    let wo = tilted(cosine);
    let frame = MirrorFrame::new(wo, brdf.exponent);
    frame.integrate(|wi| f64::from(brdf.eval(wo, wi).x) * f64::from(wi.z))
}

#[test]
fn white_furnace_gains_no_light() {
    for exponent in EXPONENTS {
        for degrees in [0.0, 15.0, 30.0, 45.0, 60.0, 75.0, 85.0, 89.0f64] {
            let cosine = degrees.to_radians().cos();
            let specular = albedo(&material(1.0, exponent), cosine);
            assert!(
                specular <= 1.0 + 2e-5,
                "e = {exponent}, {degrees}°: {specular}"
            );
            let mixed = albedo(&material(0.4, exponent), cosine);
            within(mixed, 0.6 + 0.4 * specular, 2e-5).unwrap();
        }
        within(albedo(&material(1.0, exponent), 1.0), 1.0, 2e-5)
            .unwrap_or_else(|e| panic!("e = {exponent}: {e}"));
    }
}

/// The table in the documentation of `BlinnPhong`.
const DOCUMENTED_ALBEDO: [(f32, [f64; 6]); 6] = [
    (0.0, [1.000, 1.000, 1.000, 1.000, 1.000, 1.000]),
    (1.0, [1.000, 0.955, 0.898, 0.819, 0.716, 0.633]),
    (5.0, [1.000, 0.853, 0.695, 0.515, 0.340, 0.238]),
    (50.0, [1.000, 0.760, 0.520, 0.281, 0.104, 0.039]),
    (500.0, [1.000, 0.751, 0.502, 0.253, 0.071, 0.012]),
    (10_000.0, [1.000, 0.750, 0.500, 0.250, 0.067, 0.008]),
];

#[test]
fn the_lobe_darkens_as_documented() {
    for (exponent, row) in DOCUMENTED_ALBEDO {
        for (degrees, documented) in [0.0f64, 30.0, 45.0, 60.0, 75.0, 85.0].into_iter().zip(row) {
            let measured = albedo(&material(1.0, exponent), degrees.to_radians().cos());
            within(measured, documented, 6e-4).unwrap_or_else(|e| panic!("e = {exponent}: {e}"));
        }
    }
}

#[test]
fn the_furnace_sees_a_wrong_normalisation() {
    // The common approximation (e + 8)/8π is too bright for wide lobes.
    let brdf = material(1.0, 1.0);
    let ratio = 9.0 / (8.0 * PI) / f64::from(normalisation(1.0));
    assert!(within(ratio * albedo(&brdf, 1.0), 1.0, 2e-5).is_err());
}

#[test]
fn the_estimator_finds_the_albedo() {
    let tests = EXPONENTS.len() * COSINES.len();
    for exponent in EXPONENTS {
        for cosine in COSINES {
            let (brdf, wo) = (material(0.5, exponent), tilted(cosine));
            let mut source = Xoshiro128PlusPlus::stream(11, 0, exponent as u32);
            let values = (0..100_000).map(|_| {
                let u_lobe = source.next_u32();
                let s = brdf.sample(wo, u_lobe, unit_vec2(source.next_uvec2()));
                if s.pdf_sr > 0.0 {
                    f64::from(brdf.eval(wo, s.wi).x * s.wi.z / s.pdf_sr)
                } else {
                    0.0
                }
            });
            z_test(Mean::of(values), albedo(&brdf, cosine), sidak(ALPHA, tests))
                .unwrap_or_else(|e| panic!("e = {exponent}, cosine {cosine}: {e}"));
        }
    }
}

#[test]
fn cosine_power_agrees_with_f64() {
    for exponent in [0.0f32, 0.5, 1.0, 7.0, 50.0, 500.0, 9_999.0, 10_000.0] {
        let (mut worst, mut worst_plain) = (0.0f64, 0.0f64);
        for i in 0..20_000 {
            // Sines from 10⁻⁶ to 1.
            let sine = 10f64.powf(-6.0 * f64::from(i) / 20_000.0) as f32;
            let (sin2, cos2) = (sine * sine, 1.0 - sine * sine);
            let exact = (0.5 * f64::from(exponent) * (-f64::from(sin2)).ln_1p()).exp();
            if exact > 1e-6 {
                let difference = |found: f32| (f64::from(found) / exact - 1.0).abs();
                worst = worst.max(difference(cosine_power(cos2, sin2, exponent)));
                worst_plain = worst_plain.max(difference(cos2.sqrt().powf(exponent)));
            }
        }
        assert!(worst <= 5e-6, "e = {exponent}: {worst:.1e}");
        // What it is for: the plain power of a cosine loses two digits more.
        assert!(
            exponent < 9_999.0 || worst_plain > 1e-4,
            "e = {exponent}: {worst_plain:.1e}"
        );
    }
}

/// `ρ` and the specular density in f64, straight from their definitions.
fn oracle(brdf: &BlinnPhong, wo: Vec3, wi: Vec3) -> (f64, f64) {
    let unit = |d: Direction| {
        let length = d.iter().map(|x| x * x).sum::<f64>().sqrt();
        d.map(|x| x / length)
    };
    let (wo, wi) = (unit(to_f64(wo)), unit(to_f64(wi)));
    let h = unit([wo[0] + wi[0], wo[1] + wi[1], wo[2] + wi[2]]);
    let wo_dot_h = wo[0] * h[0] + wo[1] * h[1] + wo[2] * h[2];
    let e = f64::from(brdf.exponent);
    let power = h[2].powf(e);
    let c = (e + 2.0) * (e + 4.0) / (8.0 * PI * ((-0.5 * e).exp2() + e));
    let rho = f64::from(brdf.diffuse.x) * FRAC_1_PI + f64::from(brdf.specular.x) * c * power;
    let pmf = f64::from(brdf.pmf_specular());
    let lobe = (e + 1.0) / TAU * power / (4.0 * wo_dot_h);
    (rho, pmf * lobe + (1.0 - pmf) * wi[2] * FRAC_1_PI)
}

#[test]
fn f32_agrees_with_the_definitions_in_f64() {
    for exponent in EXPONENTS {
        let mut worst = (0.0f64, 0.0f64);
        for cosine in [1.0, 0.8, 0.3] {
            for specular in [1.0, 0.5] {
                let (brdf, wo) = (material(specular, exponent), tilted(cosine));
                for wi in draws(&brdf, wo, 3, 20_000).into_iter().flatten() {
                    let (rho, pdf_sr) = oracle(&brdf, wo, wi);
                    let difference =
                        |found: f32, exact: f64| (f64::from(found) / exact - 1.0).abs();
                    worst.0 = worst.0.max(difference(brdf.eval(wo, wi).x, rho));
                    worst.1 = worst.1.max(difference(brdf.pdf_sr(wo, wi), pdf_sr));
                }
            }
        }
        assert!(
            worst.0 <= 1e-4 && worst.1 <= 1e-4,
            "e = {exponent}: {worst:?}"
        );
    }
}

#[test]
fn lambert_has_its_density() {
    let white = Lambert::new(Vec3::ONE).unwrap();
    let pdf_sr = |d: [f64; 3]| f64::from(white.pdf_sr(Vec3::Z, to_f32(d)));
    within(
        integrate_hemisphere(pdf_sr, 1e-6).converged(1e-5).unwrap(),
        1.0,
        1e-5,
    )
    .unwrap();
    let mut source = Xoshiro128PlusPlus::stream(5, 0, 0);
    let samples: Vec<_> = (0..200_000)
        .map(|_| white.sample(Vec3::Z, unit_vec2(source.next_uvec2())))
        .map(|s| (s.pdf_sr > 0.0).then(|| to_f64(s.wi)))
        .collect();
    let bins = SphereBins {
        rows: 16,
        columns: 12,
    };
    bins.chi_square(samples.iter().copied(), pdf_sr, ALPHA)
        .unwrap();
    // The uniform hemisphere is not it.
    let uniform = |d: [f64; 3]| if d[2] > 0.0 { 0.5 * FRAC_1_PI } else { 0.0 };
    assert!(bins.chi_square(samples, uniform, ALPHA).is_err());
}

#[test]
fn constructors_refuse_what_is_no_material() {
    let half = Vec3::splat(0.5);
    let refused = [
        (BlinnPhong::new(-half, half, 1.0), "albedo"),
        (
            BlinnPhong::new(half, Vec3::new(0.1, f32::NAN, 0.1), 1.0),
            "albedo",
        ),
        (BlinnPhong::new(half, half, -1.0), "exponent"),
        (BlinnPhong::new(half, half, f32::NAN), "exponent"),
        (
            BlinnPhong::new(half, Vec3::new(0.1, 0.1, 0.6), 1.0),
            "energy",
        ),
    ];
    for (result, why) in refused {
        let found = match result.unwrap_err() {
            MaterialError::Albedo(_) => "albedo",
            MaterialError::Exponent(_) => "exponent",
            MaterialError::Energy(_) => "energy",
        };
        assert_eq!(found, why);
    }
    assert!(BlinnPhong::new_scaled(Vec3::splat(f32::INFINITY), half, 1.0).is_err());
    let (kept, scale) = BlinnPhong::new_scaled(half, half, 9.0).unwrap();
    assert_eq!(
        (kept, scale),
        (BlinnPhong::new(half, half, 9.0).unwrap(), 1.0)
    );
}

fn above_horizon() -> impl Strategy<Value = Vec3> {
    // Cosines down to 10⁻⁷, so that grazing pairs come up.
    (0.0..7.0f64, 0.0..TAU).prop_map(|(depth, phi)| to_f32(direction(10f64.powf(-depth), phi)))
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: 2000,
        rng_seed: proptest::test_runner::RngSeed::Fixed(1),
        failure_persistence: None,
        ..ProptestConfig::default()
    })]

    #[test]
    fn values_are_finite_and_reciprocal(
        wo in above_horizon(), wi in above_horizon(), specular in 0.0..=1.0f32, e in 0.0..4.0f32,
    ) {
        let brdf = material(specular, 10f32.powf(e));
        for (a, b) in [(wo, wi), (wo, wo), (wo, Vec3::new(-wo.x, -wo.y, wo.z)), (wo, Vec3::Z)] {
            let (rho, pdf_sr) = (brdf.eval(a, b), brdf.pdf_sr(a, b));
            prop_assert!(rho.is_finite() && rho.min_element() >= 0.0, "{rho}");
            prop_assert!(pdf_sr.is_finite() && pdf_sr >= 0.0, "{pdf_sr}");
            prop_assert_eq!(rho, brdf.eval(b, a));
            for (x, y) in [(a, -b), (-a, b), (-a, -b)] {
                prop_assert_eq!((brdf.eval(x, y), brdf.pdf_sr(x, y)), (Vec3::ZERO, 0.0));
            }
        }
    }

    #[test]
    fn samples_are_unit_vectors_with_the_density_of_their_direction(
        wo in above_horizon(), specular in 0.0..=1.0f32, e in 0.0..4.0f32, words in any::<[u32; 3]>(),
    ) {
        let brdf = material(specular, 10f32.powf(e));
        for u in [[words[1], words[2]], [0, 0], [u32::MAX, 0], [0, u32::MAX], [u32::MAX; 2], [1 << 31; 2]] {
            let s = brdf.sample(wo, words[0], unit_vec2(u.into()));
            prop_assert!((s.wi.length() - 1.0).abs() < 2e-6, "{}", s.wi.length());
            prop_assert_eq!(s.pdf_sr, brdf.pdf_sr(wo, s.wi));
            prop_assert!(s.pdf_sr.is_finite());
            prop_assert_eq!(s.pdf_sr > 0.0 && s.wi.z <= 0.0, false);
        }
        prop_assert_eq!(brdf.sample(-wo, words[0], unit_vec2([words[1], words[2]].into())).pdf_sr, 0.0);
    }

    #[test]
    fn gltf_materials_are_materials(base in any::<[f32; 3]>(), metallic in -0.5..1.5f32, roughness in -0.5..1.5f32) {
        prop_assume!(base.iter().all(|c| c.is_finite()));
        for base in [Vec3::from_array(base), Vec3::ONE] {
            let brdf = BlinnPhong::from_metallic_roughness(base, metallic, roughness);
            prop_assert!(brdf.exponent >= 0.0 && brdf.exponent <= MAX_EXPONENT);
            prop_assert_eq!(BlinnPhong::new(brdf.diffuse, brdf.specular, brdf.exponent), Ok(brdf));
        }
    }
}
