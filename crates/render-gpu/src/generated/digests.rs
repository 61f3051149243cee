//! Host file: what results depend on: a digest of all shaders of a role.
//!
//! Made from Rust by naga-front-rust; do not edit. This command writes it: cargo run --release -p glimt-generate

/// SHA-256, in hexadecimal, of the shaders that the pixels of a rendered frame depend on.
pub const PIXELS: &str = "6f2ffd6ff8c5281d3511361adbf79e74105c21af4a8369c2c57b935ed008ecd5";

/// SHA-256, in hexadecimal, of the shaders that precomputed transfer depend on.
pub const BAKE: &str = "e6d10553a9de673d2803da500d236f721763296e3698f3c0efbc6ba8daa2f43a";

/// SHA-256, in hexadecimal, of the shaders that a simulated capture depend on.
pub const SYNTH: &str = "2fb866978e9751bd8b2e85da9c3dc15c47b78218406eb7497064d826517c831a";
