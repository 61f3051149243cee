//! Host file: sampling-importance-resampling is unbiased for any number of candidates and samples.

use glam::{UVec3, Vec3};
use glimt_sampling::ris::{RisPicks, RisSum};
use glimt_sampling::warp::{
    pdf_cosine_hemisphere_sr, pdf_power_cosine_sr, pdf_uniform_sphere_sr, sample_cosine_hemisphere,
    sample_power_cosine, sample_uniform_sphere,
};
use glimt_sampling::{OwenSobol, ShadingFrame, UniformSource, Xoshiro128PlusPlus, unit_vec2};
use glimt_statistics::films::{Film, Glossy, Map, PHIS, Product};
use glimt_statistics::stats::{Mean, sidak, z_test};

const SEED: u32 = 21;
const COUNTS: [u32; 5] = [1, 2, 3, 16, 64];

/// Where the words of candidate j come from. Each repetition has a stream, or a scrambling, of its own.
#[derive(Clone, Copy, Debug)]
enum Pattern {
    Independent,
    OwenSobol,
}

impl Pattern {
    fn candidates(self, repetition: u32, m: u32) -> Vec<UVec3> {
        let mut stream = Xoshiro128PlusPlus::stream(SEED, 0, repetition);
        let words = |j| match self {
            Pattern::Independent => stream.next_uvec2().extend(stream.next_u32()),
            Pattern::OwenSobol => {
                let mut point = OwenSobol::new(SEED, 0, repetition, j);
                point.next_uvec2().extend(point.next_u32())
            }
        };
        (0..m).map(words).collect()
    }

    fn pick(self, repetition: u32) -> u32 {
        match self {
            Pattern::Independent => Xoshiro128PlusPlus::stream(SEED, 1, repetition).next_u32(),
            Pattern::OwenSobol => OwenSobol::new(SEED, 1, repetition, 0).next_u32(),
        }
    }
}

/// Where candidates come from.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Candidates {
    /// The whole sphere evenly.
    Uniform,
    /// The hemisphere by the cosine or a lobe about the mirrored direction, half each; what lies below the horizon is impossible.
    Brdf,
    /// Half as `Brdf`, half as `Uniform`.
    Mixture,
}

/// A candidate and its density q, in 1/sr; 0 marks an impossible one.
#[derive(Clone, Copy, Debug)]
struct Candidate {
    direction: Vec3,
    pdf_sr: f32,
}

impl Candidates {
    fn sample(self, u: UVec3) -> Candidate {
        let plane = unit_vec2(u.truncate());
        // The first bit of a word chooses, the others choose again.
        let (first, rest) = (u.z < 1 << 31, UVec3::new(u.x, u.y, u.z << 1));
        let direction = match self {
            Candidates::Uniform => sample_uniform_sphere(plane).direction,
            Candidates::Brdf if first => sample_cosine_hemisphere(plane).direction,
            Candidates::Brdf => {
                let local = sample_power_cosine(plane, Glossy::EXPONENT).direction;
                ShadingFrame::from_normal(Glossy::MIRRORED).to_world(local)
            }
            Candidates::Mixture => {
                let half = if first {
                    Candidates::Brdf
                } else {
                    Candidates::Uniform
                };
                let drawn = half.sample(rest);
                if drawn.pdf_sr == 0.0 {
                    return drawn;
                }
                drawn.direction
            }
        };
        Candidate {
            direction,
            pdf_sr: self.pdf_sr(direction),
        }
    }

    fn pdf_sr(self, d: Vec3) -> f32 {
        match self {
            Candidates::Uniform => pdf_uniform_sphere_sr(),
            Candidates::Brdf if !(d.z > 0.0) => 0.0,
            Candidates::Brdf => {
                let local = ShadingFrame::from_normal(Glossy::MIRRORED).to_local(d);
                0.5 * pdf_cosine_hemisphere_sr(d)
                    + 0.5 * pdf_power_cosine_sr(local, Glossy::EXPONENT)
            }
            Candidates::Mixture => {
                0.5 * Candidates::Brdf.pdf_sr(d) + 0.5 * Candidates::Uniform.pdf_sr(d)
            }
        }
    }
}

/// γ/q.
fn weight(film: &dyn Film, t: u32, drawn: &Candidate) -> f32 {
    if drawn.pdf_sr > 0.0 {
        film.gamma(t, drawn.direction) / drawn.pdf_sr
    } else {
        0.0
    }
}

/// One estimate of ∫ γ φ for each φ, and of the normaliser.
fn estimate(film: &dyn Film, t: u32, drawn: &[Candidate], samples: u32, word: u32) -> [f64; 4] {
    let mut weights = RisSum::new();
    for candidate in drawn {
        weights.add(weight(film, t, candidate));
    }
    let normaliser = f64::from(weights.normaliser());
    let mut picks = RisPicks::new(&weights, samples, word);
    let mut estimates = [0.0; 4];
    for candidate in drawn {
        let copies = picks.take(weight(film, t, candidate));
        if copies > 0 {
            for (estimate, phi) in estimates.iter_mut().zip(PHIS) {
                *estimate += normaliser * f64::from(copies) / f64::from(samples)
                    * phi.at(candidate.direction);
            }
        }
    }
    assert!(picks.is_done(), "not all picks were made");
    estimates[3] = normaliser;
    estimates
}

/// All candidates, patterns and counts for one film. Levels are shared by `TESTS` tests of each film.
fn unbiased(film: &dyn Film, candidates: &[Candidates]) {
    const TESTS: usize = 3 * 2 * 25 * 4;
    let alpha = sidak(0.01, TESTS);
    let t = 2;
    let exact: Vec<f64> = PHIS.iter().map(|phi| film.exact(t, *phi)).collect();
    let exact = [exact[0], exact[1], exact[2], exact[0]];
    let mut largest = 0.0f64;
    for candidate in candidates {
        for pattern in [Pattern::Independent, Pattern::OwenSobol] {
            for m in COUNTS {
                let repetitions = (200_000 / m).clamp(4000, 12_000);
                let drawn: Vec<Vec<Candidate>> = (0..repetitions)
                    .map(|r| {
                        let words = pattern.candidates(r, m);
                        words.into_iter().map(|u| candidate.sample(u)).collect()
                    })
                    .collect();
                if *candidate != Candidates::Uniform {
                    let impossible = drawn.iter().flatten().filter(|d| d.pdf_sr == 0.0).count();
                    assert!(impossible * 50 > drawn.len(), "{impossible} are impossible");
                }
                for n in COUNTS {
                    let estimates: Vec<[f64; 4]> = (0..repetitions)
                        .map(|r| estimate(film, t, &drawn[r as usize], n, pattern.pick(r)))
                        .collect();
                    for k in 0..4 {
                        let mean = Mean::of(estimates.iter().map(|e| e[k]));
                        largest = largest.max(mean.standard_error / exact[0]);
                        if let Err(evidence) = z_test(mean, exact[k], alpha) {
                            panic!("{candidate:?} {pattern:?} M = {m}, N = {n}, {k}: {evidence}");
                        }
                    }
                }
            }
        }
    }
    println!(
        "largest standard error: {:.2} % of the normaliser",
        100.0 * largest
    );
    assert!(largest < 0.05, "too uncertain to show anything");
}

#[test]
fn unbiased_under_a_product_of_lobes() {
    unbiased(&Product, &[Candidates::Uniform]);
}

#[test]
fn unbiased_under_a_texel_map() {
    unbiased(&Map, &[Candidates::Uniform]);
}

#[test]
fn unbiased_under_light_over_a_glossy_surface() {
    let candidates = [Candidates::Uniform, Candidates::Brdf, Candidates::Mixture];
    unbiased(&Glossy, &candidates);
}

/// Candidates that are all impossible but one, in any place, give that one all picks and M its count.
#[test]
fn impossible_candidates_count() {
    for m in 1..10 {
        for possible in 0..m {
            let mut weights = RisSum::new();
            let weight = |j| if j == possible { 3.0 } else { 0.0 };
            (0..m).for_each(|j| weights.add(weight(j)));
            assert_eq!(weights.normaliser(), 3.0 / m as f32);
            let mut picks = RisPicks::new(&weights, 5, u32::MAX);
            let copies: Vec<u32> = (0..m).map(|j| picks.take(weight(j))).collect();
            assert_eq!(copies[possible as usize], 5);
            assert_eq!(copies.iter().sum::<u32>(), 5);
        }
    }
}

/// The same picks whatever unit γ has.
#[test]
fn the_unit_of_the_target_does_not_matter() {
    for key in 0..500 {
        let mut source = Xoshiro128PlusPlus::stream(SEED, 3, key);
        let base: Vec<f32> = (0..20).map(|_| (source.next_u32() >> 20) as f32).collect();
        let word = source.next_u32();
        let copies = |power: i32| {
            let scale = 2f64.powi(power);
            let scaled = base.iter().map(|w| (f64::from(*w) * scale) as f32);
            let mut weights = RisSum::new();
            scaled.clone().for_each(|w| weights.add(w));
            let mut picks = RisPicks::new(&weights, 64, word);
            scaled.map(|w| picks.take(w)).collect::<Vec<_>>()
        };
        for power in [-140, -127, -100, 100] {
            assert_eq!(copies(power), copies(0), "2^{power}");
        }
    }
}
