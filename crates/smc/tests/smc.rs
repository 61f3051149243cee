//! Host file: the sequential sampler keeps its identity, `E[Z_t Σ Wⁱ φ(ωⁱ)] = ∫ γ_t φ`, under every plan and proposal.

mod targets;

use std::fmt::Debug;

use glam::Vec3;
use glimt_sampling::resample::{Scheme, words};
use glimt_sampling::ris::{RisPicks, RisSum};
use glimt_sampling::warp::cap_height;
use glimt_sampling::{UniformSource, Xoshiro128PlusPlus};
use glimt_smc::{
    Bridge, CapMove, Independent, LOG_ZERO, Mixture, Particle, Path, Proposal, Report, Sampler,
    StateSampler, is_log_zero, weights,
};
use glimt_statistics::films::{Film, Glossy, Map, PHIS, Phi, Product};
use glimt_statistics::stats::{Mean, sidak, within, z_test};
use targets::{Between, Candidates};

const SCHEMES: [Scheme; 4] = [
    Scheme::Systematic,
    Scheme::Stratified,
    Scheme::Multinomial,
    Scheme::Residual,
];
/// Frames at which the identity is checked.
const FRAMES: [u32; 3] = [1, 5, 10];
/// Identities of all tests of this file, which share one level.
const IDENTITIES: usize = (96 + 33) * 9;

const PLAN: Sampler = Sampler {
    bridge: Bridge {
        path: Path::Linear,
        intermediate: 3,
    },
    scheme: Scheme::Systematic,
    ess_threshold: 2.0 / 3.0,
};

/// How a set starts.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Start {
    /// N draws with their weights.
    Weighted,
    /// N of 24 candidates, resampled.
    Ris,
}

/// A set for γ_0 with the logarithm of its normaliser.
fn start(
    how: Start,
    film: &dyn Film,
    from: Candidates,
    n: usize,
    source: &mut Xoshiro128PlusPlus,
) -> (Vec<Particle>, f64) {
    let mut draw = || {
        let u = source.next_uvec2().extend(source.next_u32());
        let drawn = from.sample(u);
        let possible = drawn.pdf > 0.0;
        let weight = if possible {
            film.gamma(0, drawn.state) / drawn.pdf
        } else {
            0.0
        };
        (drawn.state, weight)
    };
    if how == Start::Weighted {
        let particle = |(state, weight): (Vec3, f32)| Particle {
            state,
            log_weight: if weight > 0.0 {
                (weight / n as f32).ln()
            } else {
                LOG_ZERO
            },
        };
        let mut set: Vec<Particle> = (0..n).map(|_| particle(draw())).collect();
        let log_normaliser = weights::normalise(&mut set);
        return (set, f64::from(log_normaliser));
    }
    let candidates: Vec<(Vec3, f32)> = (0..24).map(|_| draw()).collect();
    let mut sum = RisSum::new();
    candidates.iter().for_each(|c| sum.add(c.1));
    let mut picks = RisPicks::new(&sum, n as u32, source.next_u32());
    let mut set = Vec::new();
    for (state, weight) in candidates {
        let log_weight = -(n as f32).ln();
        set.extend((0..picks.take(weight)).map(|_| Particle { state, log_weight }));
    }
    // Without a possible candidate there is no set; the estimate is 0.
    set.resize(
        n,
        Particle {
            state: Vec3::Z,
            log_weight: LOG_ZERO,
        },
    );
    let log_normaliser = if sum.normaliser() > 0.0 {
        f64::from(sum.normaliser()).ln()
    } else {
        f64::from(LOG_ZERO)
    };
    (set, log_normaliser)
}

/// What a test varies, beside the proposal.
#[derive(Clone, Copy)]
struct Run<'a> {
    film: &'a dyn Film,
    start: Start,
    from: Candidates,
    sampler: Sampler,
    particles: usize,
    repetitions: u32,
    seed: u32,
}

impl Run<'_> {
    /// `Z_t Σ Wⁱ φ(ωⁱ)` of one repetition for each of [`FRAMES`] and [`PHIS`], and the sum of the reports.
    fn estimates<P: Proposal>(
        &self,
        proposal: impl Fn(u32) -> P,
        repetition: u32,
    ) -> ([[f64; 3]; 3], Report) {
        let mut source = Xoshiro128PlusPlus::stream(self.seed, 0, repetition);
        let (mut set, mut log_normaliser) = start(
            self.start,
            self.film,
            self.from,
            self.particles,
            &mut source,
        );
        let mut estimates = [[0.0; 3]; 3];
        let mut all = Report {
            log_ratio: 0.0,
            ess: 0.0,
            resampled: 0,
            accepted: 0,
        };
        for t in 1..=FRAMES[2] {
            let between = Between {
                film: self.film,
                t,
                scale: 1.0,
            };
            let report = self
                .sampler
                .advance(&between, &proposal(t), &mut set, &mut source);
            log_normaliser += f64::from(report.log_ratio);
            all.resampled += report.resampled;
            all.accepted += report.accepted;
            if let Some(k) = FRAMES.iter().position(|frame| *frame == t) {
                for (estimate, phi) in estimates[k].iter_mut().zip(PHIS) {
                    let mean: f64 = set
                        .iter()
                        .map(|p| f64::from(p.weight()) * phi.at(p.state))
                        .sum();
                    *estimate = log_normaliser.exp() * mean;
                }
            }
        }
        (estimates, all)
    }

    /// Checks the identity at every frame for every φ. Returns the largest `sd(Z)/Z`, and the mean report per repetition:
    /// resamplings and accepted moves.
    fn identity<P: Proposal>(
        &self,
        what: &dyn Debug,
        proposal: impl Fn(u32) -> P,
    ) -> (f64, [f64; 2]) {
        let runs: Vec<_> = (0..self.repetitions)
            .map(|r| self.estimates(&proposal, r))
            .collect();
        let mut spread = 0.0f64;
        for (k, t) in FRAMES.into_iter().enumerate() {
            for (i, phi) in PHIS.into_iter().enumerate() {
                let exact = self.film.exact(t, phi);
                let mean = Mean::of(runs.iter().map(|run| run.0[k][i]));
                if phi == Phi::One {
                    let deviation = mean.standard_error * f64::from(self.repetitions).sqrt();
                    spread = spread.max(deviation / exact);
                }
                if let Err(evidence) = z_test(mean, exact, sidak(0.01, IDENTITIES)) {
                    panic!("{what:?}: frame {t}, {phi:?}: {evidence}");
                }
            }
        }
        assert!(
            spread <= 1.0,
            "{what:?}: sd(Z)/Z = {spread} leaves the test without power"
        );
        let mean = |f: &dyn Fn(&Report) -> u32| {
            let sum: f64 = runs.iter().map(|run| f64::from(f(&run.1))).sum();
            sum / f64::from(self.repetitions)
        };
        (spread, [mean(&|r| r.resampled), mean(&|r| r.accepted)])
    }
}

fn mixed(t: u32) -> Mixture<CapMove, Independent<Candidates>> {
    Mixture {
        pmf_first: 0.5,
        first: CapMove {
            height: cap_height(0.3),
        },
        second: Independent {
            sampler: Candidates::Mixture(t),
        },
    }
}

/// Every resampling scheme, both bridges, K of them, and every threshold; the film and the start change along with them.
fn every_plan(scheme: Scheme) {
    let films: [(&dyn Film, Candidates); 3] = [
        (&Product, Candidates::Uniform),
        (&Glossy, Candidates::Brdf),
        (&Map, Candidates::Uniform),
    ];
    let mut at = scheme as usize;
    let mut triggered = 0;
    for path in [Path::Linear, Path::Geometric] {
        for intermediate in [0, 1, 3, 8] {
            for ess_threshold in [0.0, 2.0 / 3.0, 1.1] {
                let (film, from) = films[(at + at / 3) % 3];
                let run = Run {
                    film,
                    start: [Start::Weighted, Start::Ris][at % 2],
                    from,
                    sampler: Sampler {
                        bridge: Bridge { path, intermediate },
                        scheme,
                        ess_threshold,
                    },
                    particles: 16,
                    repetitions: if intermediate == 8 { 500 } else { 1000 },
                    seed: 100 + at as u32,
                };
                let (spread, [resampled, accepted]) = run.identity(&(run.sampler, at), mixed);
                println!(
                    "{scheme:?} {path:?} K = {intermediate} ESS < {ess_threshold:.2} N: sd(Z)/Z = {spread:.2}, {resampled:.1} resampled, {accepted:.1} accepted"
                );
                let steps = f64::from(10 * (intermediate + 1));
                let share = resampled / steps;
                let expected = match ess_threshold {
                    0.0 => share == 0.0,
                    x if x > 1.0 => share == 1.0,
                    _ => share < 1.0,
                };
                assert!(expected, "{share} of the steps resampled");
                let rate = accepted / (steps * 16.0);
                assert!(0.05 < rate && rate < 0.95, "{rate} of the moves accepted");
                triggered += u32::from(share > 0.0 && share < 1.0);
                at += 1;
            }
        }
    }
    assert!(
        triggered >= 6,
        "the threshold decided in {triggered} of 8 plans"
    );
}

#[test]
fn identity_with_systematic_resampling() {
    every_plan(Scheme::Systematic);
}

#[test]
fn identity_with_stratified_resampling() {
    every_plan(Scheme::Stratified);
}

#[test]
fn identity_with_multinomial_resampling() {
    every_plan(Scheme::Multinomial);
}

#[test]
fn identity_with_residual_resampling() {
    every_plan(Scheme::Residual);
}

/// A proposal that never moves.
struct Still;

impl Proposal for Still {
    fn propose(&self, _: Vec3, _: glam::UVec3) -> glimt_smc::Proposed {
        glimt_smc::Proposed::IMPOSSIBLE
    }
}

/// Each kind of proposal on each film, nested mixtures among them.
#[test]
fn identity_with_every_proposal() {
    let films: [(&dyn Film, Candidates); 3] = [
        (&Product, Candidates::Uniform),
        (&Glossy, Candidates::Brdf),
        (&Map, Candidates::Uniform),
    ];
    for (f, (film, from)) in films.into_iter().enumerate() {
        for (h, how) in [Start::Weighted, Start::Ris].into_iter().enumerate() {
            let run = |k: usize| Run {
                film,
                start: how,
                from,
                sampler: PLAN,
                particles: 16,
                repetitions: 1200,
                seed: 1000 + (100 * f + 50 * h + k) as u32,
            };
            let cap = CapMove {
                height: cap_height(0.3),
            };
            let independent = |sampler| Independent { sampler };
            let show = |name: &str, (spread, [_, accepted]): (f64, [f64; 2])| {
                println!(
                    "film {f}, {how:?}, {name}: sd(Z)/Z = {spread:.2}, {:.0} % accepted",
                    accepted / 6.4
                );
            };
            if how == Start::Ris {
                show("still", run(0).identity(&(f, "still"), |_| Still));
                continue;
            }
            show("cap", run(1).identity(&(f, "cap"), |_| cap));
            show(
                "uniform",
                run(2).identity(&(f, "uniform"), |_| independent(Candidates::Uniform)),
            );
            show(
                "brdf",
                run(3).identity(&(f, "brdf"), |_| independent(Candidates::Brdf)),
            );
            for (k, nu) in [0.0, 0.5, 1.0].into_iter().enumerate() {
                for (l, mu) in [0.25, 0.75].into_iter().enumerate() {
                    let nested = |t| Mixture {
                        pmf_first: nu,
                        first: cap,
                        second: Mixture {
                            pmf_first: mu,
                            first: independent(Candidates::Brdf),
                            second: independent(Candidates::Mixture(t)),
                        },
                    };
                    show("nested", run(4 + 2 * k + l).identity(&(f, nu, mu), nested));
                }
            }
        }
    }
}

/// Units of the target change neither weights nor moves: at powers of two to the last bit but for logarithms.
#[test]
fn the_unit_of_the_target_does_not_matter() {
    for path in [Path::Linear, Path::Geometric] {
        for key in 0..50 {
            let run = |scale: f32| {
                let mut source = Xoshiro128PlusPlus::stream(41, 0, key);
                let (mut set, _) = start(Start::Ris, &Glossy, Candidates::Brdf, 12, &mut source);
                let sampler = Sampler {
                    bridge: Bridge {
                        path,
                        intermediate: 3,
                    },
                    ..PLAN
                };
                let mut log_ratio = 0.0;
                for t in 1..=6 {
                    let between = Between {
                        film: &Glossy,
                        t,
                        scale,
                    };
                    log_ratio += sampler
                        .advance(&between, &mixed(t), &mut set, &mut source)
                        .log_ratio;
                }
                (set, log_ratio)
            };
            let (base, base_ratio) = run(1.0);
            for scale in [2f32.powi(-100), 2f32.powi(100)] {
                let (set, ratio) = run(scale);
                assert!(
                    within(f64::from(ratio), f64::from(base_ratio), 1e-3).is_ok(),
                    "{ratio} {base_ratio}"
                );
                // A geometric bridge's powers are rounded otherwise.
                let tolerance = 1e-3;
                for (a, b) in base.iter().zip(set) {
                    assert!(
                        a.state.distance(b.state) <= 1e-6,
                        "{path:?} {key} {scale:e}"
                    );
                    assert!((a.weight() - b.weight()).abs() <= tolerance * a.weight());
                }
            }
        }
    }
}

/// γ that falls by 1000 in each of 10⁴ steps: far below what f32 holds.
#[test]
fn a_long_product_of_small_ratios_does_not_die() {
    struct Falling;
    impl glimt_smc::Target for Falling {
        fn densities(&self, state: Vec3) -> glimt_smc::Endpoints {
            let shape = 1.5 + state.z;
            glimt_smc::Endpoints {
                previous: shape,
                current: 1e-3 * shape,
            }
        }
    }
    let mut source = Xoshiro128PlusPlus::stream(42, 0, 0);
    let equal = Particle {
        state: Vec3::X,
        log_weight: 0.0,
    };
    let mut set = [equal; 8];
    weights::normalise(&mut set);
    let mut log_normaliser = 0.0;
    let sampler = Sampler {
        bridge: Bridge::linear(0),
        ..PLAN
    };
    let cap = CapMove {
        height: cap_height(0.3),
    };
    for _ in 0..10_000 {
        let report = sampler.advance(&Falling, &cap, &mut set, &mut source);
        log_normaliser += f64::from(report.log_ratio);
        assert!(report.ess > 7.9 && report.resampled == 0, "{report:?}");
    }
    assert!(
        within(log_normaliser / (1e4 * 1e-3f64.ln()), 1.0, 1e-5).is_ok(),
        "{log_normaliser}"
    );
    // No drift of states and weights over ten thousand moves.
    for p in set {
        assert!(
            (p.state.length() - 1.0).abs() < 1e-6 && (p.weight() - 0.125).abs() < 1e-4,
            "{p:?}"
        );
    }
}

/// Counts the words drawn.
struct Counting {
    source: Xoshiro128PlusPlus,
    drawn: u32,
}

impl UniformSource for Counting {
    fn next_u32(&mut self) -> u32 {
        self.drawn += 1;
        self.source.next_u32()
    }
}

/// A set without weight stays so, and draws what any other draws.
#[test]
fn a_set_of_weight_zero_stays_so_and_every_step_draws_the_same() {
    for scheme in SCHEMES {
        for n in [1usize, 2, 7, 64] {
            for ess_threshold in [0.0, 2.0 / 3.0, 1.1] {
                for dead in [false, true] {
                    let mut source = Counting {
                        source: Xoshiro128PlusPlus::stream(43, 0, n as u32),
                        drawn: 0,
                    };
                    let particle = |i: usize| Particle {
                        state: Vec3::new(0.6, 0.0, if dead { -0.8 } else { 0.8 }),
                        log_weight: i as f32,
                    };
                    let mut set: Vec<Particle> = (0..n).map(particle).collect();
                    weights::normalise(&mut set);
                    let sampler = Sampler {
                        scheme,
                        ess_threshold,
                        ..PLAN
                    };
                    let between = Between {
                        film: &Glossy,
                        t: 1,
                        scale: 1.0,
                    };
                    for k in 1..=4 {
                        let before = source.drawn;
                        let report = sampler.step(k, &between, &mixed(1), &mut set, &mut source);
                        assert_eq!(
                            source.drawn - before,
                            words(scheme, n as u32) + 4 * n as u32
                        );
                        assert_eq!(is_log_zero(report.log_ratio), dead);
                        assert_eq!(report.ess == 0.0, dead);
                        assert!(report.accepted <= n as u32);
                        if dead {
                            assert_eq!((report.log_ratio, report.resampled), (LOG_ZERO, 0));
                            assert!(
                                set.iter()
                                    .all(|p| p.log_weight == LOG_ZERO && p.weight() == 0.0)
                            );
                        } else {
                            let sum: f32 = set.iter().map(Particle::weight).sum();
                            assert!((sum - 1.0).abs() < 1e-5);
                        }
                    }
                    if dead {
                        let report = sampler.advance(&between, &mixed(1), &mut set, &mut source);
                        assert_eq!(report.log_ratio, LOG_ZERO);
                    }
                }
            }
        }
    }
}
