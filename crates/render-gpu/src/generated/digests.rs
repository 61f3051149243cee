//! Host file: what results depend on: a digest of all shaders of a role.
//!
//! Made from Rust by naga-front-rust; do not edit. This command writes it: cargo run --release -p glimt-generate

/// SHA-256, in hexadecimal, of the shaders that the pixels of a rendered frame depend on.
pub const PIXELS: &str = "7cde2c4d85f0d7d7bf970893999cb2a2330e77496dcb3a54abce2d8aa677c88e";

/// SHA-256, in hexadecimal, of the shaders that precomputed transfer depend on.
pub const BAKE: &str = "cc4db5aee828b1dcdc8ea3b6acbd42799bc9ec92ddf22686b61bf49327b4bf04";

/// SHA-256, in hexadecimal, of the shaders that a simulated capture depend on.
pub const SYNTH: &str = "d9c8139407027b36b97c03ecbc2de3fabea231984f97591ef0cfecfce8ab8201";
