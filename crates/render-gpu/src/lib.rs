//! Monte Carlo rendering of objects lit by video environment maps.
//!
//! Kernels ([`kernels`], shared files) compute one ray or one pixel each; executors run them over an image: [`gpu`] by
//! wgpu, from the WGSL that the front end makes of the same files.

pub mod entry;
pub mod gpu;
pub mod host;
pub mod kernels;
