//! Host file: what results depend on: a digest of all shaders of a role.
//!
//! Made from Rust by naga-front-rust; do not edit. This command writes it: cargo run --release -p glimt-generate

/// SHA-256, in hexadecimal, of the shaders that the pixels of a rendered frame depend on.
pub const PIXELS: &str = "d65f07d1ef1ac041a162f19109656637062bf3e3964e58b71a0a718bc7ec35f2";

/// SHA-256, in hexadecimal, of the shaders that precomputed transfer depend on.
pub const BAKE: &str = "d223cd87f18ffcb7d81341736f6e4bb4426d0fd2cdc5730d6a7507ef7d1d8f81";

/// SHA-256, in hexadecimal, of the shaders that a simulated capture depend on.
pub const SYNTH: &str = "2473d10ff64975d18d7d279455278e1e0d4807d81eaa84a15ef7ff5c8d04c7c3";
