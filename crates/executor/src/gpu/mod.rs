//! Host file: executors on a GPU, by wgpu.
//!
//! [`GpuContext`] opens an adapter with the adapter's own limits. [`Direct`] runs a pass at once, cut into dispatches that fit
//! those limits and stay short; [`Recording`] collects passes and hands them over together. Everything that can go wrong is a
//! [`GpuError`] that names the adapter and the limit.

mod arguments;
mod buffer;
mod device;
mod error;
mod kernel;
mod launch;
mod memory;
mod record;
mod timing;

pub use arguments::Arg;
pub use buffer::{GpuBuffer, GpuVec};
pub use device::{AdapterPreference, AdapterSummary, GpuContext, GpuOptions, enumerate};
pub use error::GpuError;
pub use launch::{Direct, LaunchReport};
pub use memory::{Gpu, GpuChunks, GpuSlice};
pub use record::{ParamsPool, Recording};
pub use timing::Stopwatch;
