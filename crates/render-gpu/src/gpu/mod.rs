//! Host file: the wgpu executor.
//!
//! [`GpuContext`] opens an adapter with the adapter's own limits; [`GpuContext::launch`] runs a generated
//! [`Entry`](crate::entry::Entry) over any number of elements, cut into dispatches that fit the adapter's limits and
//! stay short; [`GpuRenderer`] renders frames by it. Everything that can go wrong is a [`GpuError`] that names the adapter and the limit.

mod bake;
mod buffer;
mod device;
mod error;
mod kernel;
mod launch;
mod light;
mod prt;
mod raster;
mod record;
mod renderer;
mod smc;
mod timing;
mod unwarp;
mod upload;

/// The shaders that are written by hand, around functions made from Rust.
pub const HAND_WRITTEN: [&str; 2] = [light::WGSL, raster::WGSL];

pub use bake::bake;
pub use buffer::GpuBuffer;
pub use device::{AdapterPreference, AdapterSummary, GpuContext, GpuOptions, enumerate};
pub use error::GpuError;
pub use launch::{Arg, LaunchReport};
pub use light::GpuLight;
pub use prt::{DrawTimes, GpuPrt};
pub use renderer::{FrameTimes, GpuRenderer};
pub use unwarp::GpuUnwarp;
pub use upload::{GpuEnv, GpuScene};
