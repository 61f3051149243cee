//! Host file: what results depend on: a digest of all shaders of a role.
//!
//! Made from Rust by naga-front-rust; do not edit. This command writes it: cargo run --release -p glimt-generate

/// SHA-256, in hexadecimal, of the shaders that the pixels of a rendered frame depend on.
pub const PIXELS: &str = "f2214b853a0bec6c58a8b77af2cdba0e4e85181b97dafe3c473cf721e0ba4b19";

/// SHA-256, in hexadecimal, of the shaders that precomputed transfer depend on.
pub const BAKE: &str = "cc4db5aee828b1dcdc8ea3b6acbd42799bc9ec92ddf22686b61bf49327b4bf04";

/// SHA-256, in hexadecimal, of the shaders that a simulated capture depend on.
pub const SYNTH: &str = "7ed8cd11455b4dd75a5aab300d26a91879691c7e40373ce9ef45599bff7e893e";
