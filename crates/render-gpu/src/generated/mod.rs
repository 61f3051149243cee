//! Host file: what the front end made of the renderer's kernels.
//!
//! Made from Rust by naga-front-rust; do not edit. This command writes it: cargo run --release -p glimt-generate

pub mod digests;
pub mod entries;
#[cfg(test)]
mod layout;
pub mod passes;
#[cfg(feature = "shader-source")]
pub(crate) mod sources;
