//! Host file: helpers of the tests.

pub mod analytic;
pub mod ball;
pub mod data;
pub mod differential;
pub mod golden;
pub mod gpu;
#[allow(
    clippy::all,
    non_camel_case_types,
    reason = "each form of the language is there to be lowered, the unusual ones above all"
)]
pub mod kernels;
pub mod light;
pub mod random;
pub mod sampler_sets;
pub mod sampler_step;
pub mod shaders;
pub mod shared_image;
pub mod unbiased;

pub use glimt_statistics::{harmonics, quadrature, stats, worst};
