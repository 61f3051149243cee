//! Host file: `glimt-smc` linked alone, without std and alloc.

#![no_std]
#![no_main]

#[path = "../rt.rs"]
mod rt;

use core::hint::black_box;
use glam::Vec3;
use glimt_sampling::Xoshiro128PlusPlus;
use glimt_sampling::resample::Scheme;
use glimt_smc::{Bridge, CapMove, Endpoints, Particle, Sampler, Target, is_log_zero, weights};

/// A slope over the sphere that becomes three times as strong.
struct Slope;

impl Target for Slope {
    fn densities(&self, state: Vec3) -> Endpoints {
        let slope = 1.5 + state.z;
        Endpoints {
            previous: slope,
            current: 3.0 * slope,
        }
    }
}

/// A frame multiplies the normaliser by three, whatever the moves, and the weights still add up to one.
fn is_right() -> bool {
    let mut source = Xoshiro128PlusPlus::stream(black_box(1), 2, 3);
    let equal = Particle {
        state: Vec3::X,
        log_weight: 0.0,
    };
    let mut set = [equal; 16];
    weights::normalise(&mut set);
    let sampler = Sampler {
        bridge: Bridge::linear(black_box(3)),
        scheme: Scheme::Residual,
        ess_threshold: 2.0,
    };
    let moves = CapMove { height: 0.1 };
    let report = sampler.advance(&Slope, &moves, &mut set, &mut source);
    let sum: f32 = set.iter().map(Particle::weight).sum();
    report.resampled == 4
        && report.accepted > 0
        && !is_log_zero(report.log_ratio)
        && (report.log_ratio - 1.098_612_3).abs() < 1e-4
        && (sum - 1.0).abs() < 1e-5
}
