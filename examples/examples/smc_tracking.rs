//! Host file: a sequential sampler far from light: where is the leak, and how strong is it?
//!
//! Twelve gauges in a field read a gas, with noise. Its source drifts, and its strength changes, from one reading to the
//! next. What the readings of one moment say about x, y and strength is a density over three numbers,
//!
//! ```text
//! γ_t(x, y, s) = prior(x, y, s) · exp(−½ Σ_i (reading_t,i − model_i(x, y, s))² / σ²),
//! ```
//!
//! and the sampler leads one set of particles from γ_{t−1} to γ_t: it starts as draws of the prior and is annealed to the
//! first readings. Its weighted mean is the estimate, and Z_t, how well the readings can be explained at all.
//!
//! Below, a state is any three numbers, `RandomWalk` is a proposal of one's own, and a grid says what is true.
//!
//! ```text
//! cargo run --release --example smc_tracking
//! ```

use std::process::ExitCode;

use glam::{UVec3, Vec2, Vec3};
use glimt_sampling::resample::Scheme;
use glimt_sampling::{UniformSource, Xoshiro128PlusPlus, unit_f32};
use glimt_smc::{
    Bridge, Endpoints, Mixture, Particle, Proposal, Proposed, Sampler, Target, weights,
};

const FRAMES: u32 = 12;
const PARTICLES: usize = 2000;
/// Targets between two readings: what each says lies some of the other's deviations off.
const BETWEEN: u32 = 100;
/// Metres, metres, grams a second: the prior is uniform in this box.
const BOX: [Vec3; 2] = [Vec3::new(0.0, 0.0, 1.0), Vec3::new(10.0, 10.0, 21.0)];
const GAUGES: usize = 12;
const NOISE: f32 = 0.5;

/// What gauge `i` reads of a source without noise.
fn model(i: usize, source: Vec3) -> f32 {
    let gauge =
        Vec2::new((i % 4) as f32, (i / 4) as f32) * Vec2::new(3.0, 4.0) + Vec2::new(0.5, 1.0);
    source.z / (1.0 + gauge.distance_squared(source.truncate()))
}

/// The source's true way.
fn truth(frame: u32) -> Vec3 {
    let t = frame as f32 / FRAMES as f32;
    Vec3::new(2.0 + 5.5 * t, 7.0 - 4.0 * t * t, 8.0 + 6.0 * t)
}

type Readings = [f32; GAUGES];

fn readings(frame: u32, source: &mut Xoshiro128PlusPlus) -> Readings {
    std::array::from_fn(|i| {
        // Twelve uniforms make a normal number, nearly.
        let normal = (0..12).map(|_| unit_f32(source.next_u32())).sum::<f32>() - 6.0;
        model(i, truth(frame)) + NOISE * normal
    })
}

/// γ for the given readings; without any, the prior.
fn density(readings: Option<&Readings>, state: Vec3) -> f32 {
    if state.cmplt(BOX[0]).any() || state.cmpgt(BOX[1]).any() {
        return 0.0;
    }
    let Some(readings) = readings else {
        return 1.0;
    };
    let errors = (0..GAUGES).map(|i| (readings[i] - model(i, state)) / NOISE);
    // Far off, the exponential would be 0 in f32, and a particle there lost.
    (-0.5 * errors.map(|e| e * e).sum::<f32>()).max(-80.0).exp()
}

struct Posterior<'a> {
    before: Option<&'a Readings>,
    now: &'a Readings,
}

impl Target for Posterior<'_> {
    fn densities(&self, state: Vec3) -> Endpoints {
        Endpoints {
            previous: density(self.before, state),
            current: density(Some(self.now), state),
        }
    }
}

/// A step of up to `reach` either way, in each number. There and back are equally likely, so both densities are 1.
struct RandomWalk {
    reach: Vec3,
}

impl Proposal for RandomWalk {
    fn propose(&self, from: Vec3, u: UVec3) -> Proposed {
        let step = Vec3::new(unit_f32(u.x), unit_f32(u.y), unit_f32(u.z)) * 2.0 - Vec3::ONE;
        Proposed {
            state: from + self.reach * step,
            forward: 1.0,
            backward: 1.0,
        }
    }
}

/// Mean of the state under γ, and the logarithm of γ's mean over the box, by a grid.
fn grid(readings: &Readings) -> (Vec3, f64) {
    const CELLS: [u32; 3] = [100, 100, 80];
    let (mut sum, mut moment) = (0.0f64, [0.0f64; 3]);
    for x in 0..CELLS[0] {
        for y in 0..CELLS[1] {
            for s in 0..CELLS[2] {
                let place = Vec3::new(x as f32, y as f32, s as f32) + Vec3::splat(0.5);
                let state =
                    BOX[0] + place / Vec3::from(CELLS.map(|c| c as f32)) * (BOX[1] - BOX[0]);
                let density = f64::from(density(Some(readings), state));
                sum += density;
                for (m, x) in moment.iter_mut().zip(state.to_array()) {
                    *m += density * f64::from(x);
                }
            }
        }
    }
    let cells = CELLS.iter().map(|c| f64::from(*c)).product::<f64>();
    let mean = Vec3::from(moment.map(|m| (m / sum) as f32));
    (mean, (sum / cells).ln())
}

fn main() -> ExitCode {
    let mut nature = Xoshiro128PlusPlus::stream(3, 0, 0);
    let mut source = Xoshiro128PlusPlus::stream(4, 0, 0);

    // Draws of the prior, whose normaliser is 1 in units of the box.
    let mut set = [Particle {
        state: Vec3::ZERO,
        log_weight: 0.0,
    }; PARTICLES];
    for particle in &mut set {
        let unit = Vec3::from([(); 3].map(|()| unit_f32(source.next_u32())));
        particle.state = BOX[0] + unit * (BOX[1] - BOX[0]);
    }
    weights::normalise(&mut set);
    let mut log_normaliser = 0.0;

    // Long steps find the place, short ones settle in it.
    let walk = Mixture {
        pmf_first: 0.3,
        first: RandomWalk {
            reach: Vec3::new(2.0, 2.0, 4.0),
        },
        second: RandomWalk {
            reach: Vec3::new(0.3, 0.3, 0.8),
        },
    };

    println!(
        "frame        truth (x, y, s)       estimate ± deviation                       grid        ln Z   grid  moved"
    );
    let mut before: Option<Readings> = None;
    let mut worst = 0.0f32;
    for frame in 0..FRAMES {
        let now = readings(frame, &mut nature);
        let sampler = Sampler {
            bridge: Bridge::geometric(BETWEEN),
            scheme: Scheme::Systematic,
            ess_threshold: 2.0 / 3.0,
        };
        let posterior = Posterior {
            before: before.as_ref(),
            now: &now,
        };
        let report = sampler.advance(&posterior, &walk, &mut set, &mut source);
        log_normaliser += f64::from(report.log_ratio);

        let mean: Vec3 = set.iter().map(|p| p.weight() * p.state).sum();
        let square = |p: &Particle| p.weight() * (p.state - mean) * (p.state - mean);
        let deviation = Vec3::from(
            set.iter()
                .map(square)
                .sum::<Vec3>()
                .to_array()
                .map(f32::sqrt),
        );
        let (exact, log_exact) = grid(&now);
        let moves = (BETWEEN + 1) * PARTICLES as u32;
        let show = |v: Vec3| format!("{:5.2} {:5.2} {:5.2}", v.x, v.y, v.z);
        println!(
            "{frame:5}    {}    {} ± {}    {}    {log_normaliser:6.2} {log_exact:6.2}   {:2.0} %",
            show(truth(frame)),
            show(mean),
            show(deviation),
            show(exact),
            100.0 * report.accepted as f32 / moves as f32,
        );
        worst = worst.max(((mean - exact) / deviation).abs().max_element());
        before = Some(now);
    }
    println!("largest distance of the estimate from the grid: {worst:.2} deviations");
    // The mean of as many independent draws would be off by 0.02; the set's are fewer than that.
    if worst < 0.3 {
        ExitCode::SUCCESS
    } else {
        eprintln!("that is more than a set of {PARTICLES} should be off");
        ExitCode::FAILURE
    }
}
