//! Host file: sequential Monte Carlo samplers for targets that change from frame to frame. `no_std`, no alloc; glam types.
//!
//! A set of N weighted particles stands for an unnormalised density γ_t, and with it a running estimate Z_t of its integral.
//! [`Sampler::advance`] leads the set to the next frame's density through K densities between the two: particles are
//! reweighted, resampled where few of them carry the weight, and moved by Metropolis-Hastings steps. In the end
//! `Z_t Σ Wⁱ f(ωⁱ)/γ_t(ωⁱ)` estimates `∫ f`. Sets are slices of the caller's, of any length.
//!
//! ```
//! use glam::{UVec3, Vec3};
//! use glimt_sampling::{Xoshiro128PlusPlus, resample::Scheme};
//! use glimt_smc::{Bridge, CapMove, Endpoints, Particle, Sampler, Target, weights};
//!
//! /// A lamp of von Mises-Fisher shape, `exp(8 (μ·ω − 1))`, that moves.
//! struct Lamp { before: Vec3, now: Vec3 }
//! impl Target for Lamp {
//!     fn densities(&self, state: Vec3) -> Endpoints {
//!         let lobe = |centre: Vec3| (8.0 * (centre.dot(state) - 1.0)).exp();
//!         Endpoints { previous: lobe(self.before), current: lobe(self.now) }
//!     }
//! }
//!
//! let sampler = Sampler { bridge: Bridge::linear(3), scheme: Scheme::Systematic, ess_threshold: 2.0 / 3.0 };
//! let centre = |t: u32| Vec3::new((0.1 * t as f32).cos(), (0.1 * t as f32).sin(), 0.0);
//! let truth = core::f32::consts::TAU / 8.0 * (1.0 - (-16.0f32).exp());
//! let (repetitions, mut mean) = (400, 0.0);
//! for repetition in 0..repetitions {
//!     let mut source = Xoshiro128PlusPlus::stream(1, 0, repetition);
//!     // Uniform over the sphere, weighed by the first frame's target.
//!     let first = Lamp { before: centre(0), now: centre(0) };
//!     let mut set = [Particle { state: Vec3::X, log_weight: 0.0 }; 32];
//!     for particle in &mut set {
//!         use glimt_sampling::{UniformSource, unit_vec2, warp::sample_uniform_sphere};
//!         particle.state = sample_uniform_sphere(unit_vec2(source.next_uvec2())).direction;
//!         particle.log_weight = (first.densities(particle.state).current * 4.0 * core::f32::consts::PI / 32.0).ln();
//!     }
//!     let mut log_normaliser = weights::normalise(&mut set);
//!     let moves = CapMove { height: 0.05 };
//!     for t in 1..=5 {
//!         let lamp = Lamp { before: centre(t - 1), now: centre(t) };
//!         log_normaliser += sampler.advance(&lamp, &moves, &mut set, &mut source).log_ratio;
//!     }
//!     mean += log_normaliser.exp() / repetitions as f32;
//! }
//! assert!((mean / truth - 1.0).abs() < 0.1, "{mean} {truth}");
//! ```
//!
//! # What is here
//!
//! | module | what it holds |
//! |---|---|
//! | [`Particle`] | a state with the logarithm of its weight, 16 bytes |
//! | [`weights`] | normalised weights, effective sample size |
//! | [`Target`], [`Bridge`] | what is sampled, and the densities between two frames |
//! | [`reweight`](mod@reweight), [`resample`](mod@resample), [`metropolis`](mod@metropolis) | the three parts of a step |
//! | [`Proposal`] | cap moves, independent draws, mixtures of both |
//! | [`Sampler`] | a step with its report, and all steps of a frame |
//!
//! # Conventions
//!
//! - Weights are kept as logarithms; a weight of 0 is [`LOG_ZERO`].
//! - A step draws a fixed number of words whatever it decides, so that two processors' generators stay in step.
//! - A set whose weights are all 0 stays so, with a normaliser of 0: it belongs to the mean. A set without particles is one.
//! - Densities have any unit as long as f32 holds them, and their products with proposals' densities.
//! - The sampler is unbiased for a fixed plan. To re-initialise a set *because of* its normaliser, or because all its weights are 0,
//!   biases it; at an age, or because of what its target is, does not.
//!
//! # One source, two processors
//!
//! All modules but `pod` (bytes for uploads, behind the feature `bytemuck`) are *shared files*: plain Rust without heap or
//! standard library that also lowers to WGSL. With the feature `shader-source` their text is available as `SHADER_SOURCE`, and `WGSL`
//! holds those functions that need neither a target nor a proposal of one's own.
//!
//! # Bibliography
//!
//! - R. Douc, O. Cappé, E. Moulines: *Comparison of resampling schemes for particle filtering*, ISPA 2005.
//! - J. Kronander et al.: *Real-time video based lighting using GPU raytracing*, EUSIPCO 2014.
//! - A. Ghosh, A. Doucet, W. Heidrich: *Sequential sampling for dynamic environment map illumination*, EGSR 2006.
//! - P. Del Moral, A. Doucet, A. Jasra: *Sequential Monte Carlo samplers*, J. R. Stat. Soc. B 68(3), 2006.
//! - L. Tierney: *Markov chains for exploring posterior distributions*, Ann. Statist. 22(4), 1994 (mixtures of kernels).

#![no_std]

mod bridge;
pub mod metropolis;
pub mod particle;
#[cfg(feature = "bytemuck")]
mod pod;
mod proposal;
pub mod resample;
pub mod reweight;
mod sampler;
mod target;
pub mod weights;

pub use bridge::{Bridge, Path};
pub use metropolis::accept;
pub use particle::{LOG_ZERO, Particle, is_log_zero};
pub use proposal::{
    CapMove, Independent, Mixture, Proposal, Proposed, Sampled, Split, StateSampler, split_word,
};
pub use sampler::{Report, Sampler};
pub use target::{Endpoints, Target};

/// The crate's name and its shared files, `(path below src/, text)`, for a front end that lowers them to WGSL.
#[cfg(feature = "shader-source")]
pub const SHADER_SOURCE: (&str, &[(&str, &str)]) = (
    "glimt_smc",
    &[
        ("lib.rs", include_str!("lib.rs")),
        ("bridge.rs", include_str!("bridge.rs")),
        ("metropolis.rs", include_str!("metropolis.rs")),
        ("particle.rs", include_str!("particle.rs")),
        ("proposal.rs", include_str!("proposal.rs")),
        ("resample.rs", include_str!("resample.rs")),
        ("reweight.rs", include_str!("reweight.rs")),
        ("sampler.rs", include_str!("sampler.rs")),
        ("target.rs", include_str!("target.rs")),
        ("weights.rs", include_str!("weights.rs")),
    ],
);

/// The crate's functions as WGSL, made from its shared files: to be pasted into a shader of one's own, beside
/// `glimt_sampling::WGSL` if need be. Enums are numbers there, in the order of their variants.
#[cfg(feature = "shader-source")]
pub const WGSL: &str = include_str!("../wgsl/smc.wgsl");
