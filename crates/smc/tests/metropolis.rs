//! Host file: one Metropolis-Hastings kernel alone: it leaves γ_k invariant, and is reversible.

mod targets;

use std::f64::consts::TAU;
use std::fmt::Debug;

use glam::{UVec4, Vec3};
use glimt_sampling::warp::{cap_height, sample_uniform_sphere};
use glimt_sampling::{UniformSource, Xoshiro128PlusPlus, unit_f32, unit_vec2};
use glimt_smc::metropolis::metropolis;
use glimt_smc::{Bridge, CapMove, Independent, Mixture, Particle, Path, Proposal, Target};
use glimt_statistics::films::{Film, Glossy, Map, Product};
use glimt_statistics::quadrature::{Direction, direction};
use glimt_statistics::stats::{Mean, SphereBins, chi_square, sidak, z_test};
use targets::{Between, Candidates};

/// Cells on whose edges lie the horizon and the edges of [`Map`]'s texels.
const CELLS: SphereBins = SphereBins {
    rows: 8,
    columns: 16,
};
const FILMS: [&dyn Film; 3] = [&Product, &Glossy, &Map];
const T: u32 = 4;
const MOVES: u32 = 12;

fn to_f64(d: Vec3) -> Direction {
    [f64::from(d.x), f64::from(d.y), f64::from(d.z)]
}

/// γ_k of a bridge, and exact draws of it.
#[derive(Clone, Copy)]
struct Stationary {
    film: &'static dyn Film,
    bridge: Bridge,
    k: u32,
}

impl Stationary {
    fn target(&self) -> Between<'static, dyn Film> {
        Between {
            film: self.film,
            t: T,
            scale: 1.0,
        }
    }

    fn density(&self, d: Vec3) -> f32 {
        self.bridge.density(self.k, self.target().densities(d))
    }

    /// A draw by rejection, which knows nothing of proposals.
    fn draw(&self, source: &mut Xoshiro128PlusPlus) -> Vec3 {
        loop {
            let d = sample_uniform_sphere(unit_vec2(source.next_uvec2())).direction;
            if unit_f32(source.next_u32()) * self.film.bound() < self.density(d) {
                return d;
            }
        }
    }

    /// The probability of each of [`CELLS`], by 24 × 24 points in each.
    fn masses(&self) -> Vec<f64> {
        const POINTS: usize = 24;
        let mut masses = vec![0.0; CELLS.rows * CELLS.columns];
        let place = |i: usize, n: usize| (i as f64 + 0.5) / (POINTS * n) as f64;
        for row in 0..POINTS * CELLS.rows {
            for column in 0..POINTS * CELLS.columns {
                let z = 1.0 - 2.0 * place(row, CELLS.rows);
                let d = direction(z, TAU * (place(column, CELLS.columns) - 0.5));
                let density = self.density(Vec3::from_array(d.map(|x| x as f32)));
                masses[row / POINTS * CELLS.columns + column / POINTS] += f64::from(density);
            }
        }
        let total: f64 = masses.iter().sum();
        masses.into_iter().map(|m| m / total).collect()
    }

    /// Where `count` exact draws are after `moves` moves, with where they were; and the share of moves that were accepted.
    fn moved<P: Proposal>(&self, proposal: &P, count: u32, moves: u32) -> (Vec<(Vec3, Vec3)>, f64) {
        let mut source = Xoshiro128PlusPlus::stream(51, self.k, moves);
        let mut accepted = 0;
        let pairs = (0..count)
            .map(|_| {
                let state = self.draw(&mut source);
                let mut particle = Particle {
                    state,
                    log_weight: 0.0,
                };
                for _ in 0..moves {
                    let u = source.next_uvec2();
                    let u = UVec4::new(u.x, u.y, source.next_u32(), source.next_u32());
                    let target = self.target();
                    let yes = metropolis(self.k, &self.bridge, &target, proposal, &mut particle, u);
                    accepted += u64::from(yes);
                }
                assert_eq!(particle.log_weight, 0.0);
                (state, particle.state)
            })
            .collect();
        (pairs, accepted as f64 / f64::from(count * moves))
    }
}

/// A check of one kernel on one target.
trait Check {
    fn run<P: Proposal>(&self, stationary: Stationary, proposal: &P, what: &dyn Debug);
}

/// Runs a check for every film and kind of proposal, at both ends of a bridge and between them.
fn every_kernel(check: &impl Check) {
    for (f, film) in FILMS.into_iter().enumerate() {
        let steps = [
            (Path::Linear, 1),
            (Path::Linear, 3),
            (Path::Geometric, 2),
            (Path::Geometric, 4),
        ];
        for (s, (path, k)) in steps.into_iter().enumerate() {
            let bridge = Bridge {
                path,
                intermediate: 3,
            };
            let stationary = Stationary { film, bridge, k };
            let cap = CapMove {
                height: cap_height(0.35),
            };
            let independent = |sampler| Independent { sampler };
            let mixed = Mixture {
                pmf_first: 0.4,
                first: cap,
                second: Mixture {
                    pmf_first: 0.6,
                    first: independent(Candidates::Mixture(T)),
                    second: independent(Candidates::Brdf),
                },
            };
            // Each film meets each kind of proposal once, and the mixture at every step.
            match s {
                0 => check.run(stationary, &cap, &(f, path, k, "cap")),
                1 => check.run(
                    stationary,
                    &independent(Candidates::Uniform),
                    &(f, "uniform"),
                ),
                2 => check.run(
                    stationary,
                    &independent(Candidates::Mixture(T)),
                    &(f, "mixture"),
                ),
                _ => check.run(stationary, &independent(Candidates::Brdf), &(f, "brdf")),
            }
            check.run(stationary, &mixed, &(f, path, k, "mixed"));
        }
    }
}

struct Invariance;

impl Check for Invariance {
    fn run<P: Proposal>(&self, stationary: Stationary, proposal: &P, what: &dyn Debug) {
        let (pairs, rate) = stationary.moved(proposal, 12_000, MOVES);
        println!("{what:?}: {:.0} % accepted", 100.0 * rate);
        assert!(0.02 < rate && rate < 0.98, "{what:?}: {rate}");
        let mut observed = vec![0; CELLS.rows * CELLS.columns];
        for (_, d) in &pairs {
            assert!((d.length() - 1.0).abs() < 1e-5);
            observed[CELLS.index(to_f64(*d))] += 1;
        }
        let expected: Vec<f64> = stationary
            .masses()
            .into_iter()
            .map(|m| m * pairs.len() as f64)
            .collect();
        if let Err(evidence) = chi_square(&observed, &expected, sidak(0.01, 24)) {
            panic!("{what:?}: {evidence}");
        }
    }
}

#[test]
fn moves_leave_the_target_invariant() {
    every_kernel(&Invariance);
}

struct Reversibility;

impl Check for Reversibility {
    fn run<P: Proposal>(&self, stationary: Stationary, proposal: &P, what: &dyn Debug) {
        const COARSE: SphereBins = SphereBins {
            rows: 4,
            columns: 4,
        };
        let (pairs, _) = stationary.moved(proposal, 60_000, 1);
        let mut flow = [[0u32; 16]; 16];
        for (from, to) in pairs {
            flow[COARSE.index(to_f64(from))][COARSE.index(to_f64(to))] += 1;
        }
        let mut tested = 0;
        for a in 0..16 {
            for b in 0..a {
                let (there, back) = (f64::from(flow[a][b]), f64::from(flow[b][a]));
                if there + back < 20.0 {
                    continue;
                }
                tested += 1;
                // Given how many pass between the two cells, half of them go either way.
                let mean = Mean {
                    mean: there - back,
                    standard_error: (there + back).sqrt(),
                    n: (there + back) as usize,
                };
                if let Err(evidence) = z_test(mean, 0.0, sidak(0.01, 24 * 60)) {
                    panic!("{what:?}: between cells {a} and {b}: {evidence}");
                }
            }
        }
        assert!(
            (5..=120).contains(&tested),
            "{what:?}: {tested} pairs of cells"
        );
    }
}

/// As many particles go from one cell to another as back (detailed balance).
#[test]
fn moves_are_reversible() {
    every_kernel(&Reversibility);
}

/// The draws that all of this starts from are those of γ_k.
#[test]
fn exact_draws_are_exact() {
    for film in FILMS {
        for (path, k) in [(Path::Linear, 2), (Path::Geometric, 2)] {
            let bridge = Bridge {
                path,
                intermediate: 3,
            };
            let stationary = Stationary { film, bridge, k };
            let mut source = Xoshiro128PlusPlus::stream(52, 0, k);
            let count = 40_000;
            let mut observed = vec![0; CELLS.rows * CELLS.columns];
            for _ in 0..count {
                observed[CELLS.index(to_f64(stationary.draw(&mut source)))] += 1;
            }
            let expected: Vec<f64> = stationary
                .masses()
                .into_iter()
                .map(|m| m * f64::from(count))
                .collect();
            chi_square(&observed, &expected, sidak(0.01, 6)).unwrap_or_else(|e| panic!("{e}"));
        }
    }
}
