//! Host file: what results depend on: a digest of all shaders of a role.
//!
//! Made from Rust by naga-front-rust; do not edit. This command writes it: cargo run --release -p glimt-generate

/// SHA-256, in hexadecimal, of the shaders that the pixels of a rendered frame depend on.
pub const PIXELS: &str = "c12ccc3820aa57705d59f5a78b9fca35e300f504e63e658d2307f759f774935e";

/// SHA-256, in hexadecimal, of the shaders that precomputed transfer depend on.
pub const BAKE: &str = "cc4db5aee828b1dcdc8ea3b6acbd42799bc9ec92ddf22686b61bf49327b4bf04";

/// SHA-256, in hexadecimal, of the shaders that a simulated capture depend on.
pub const SYNTH: &str = "d9c8139407027b36b97c03ecbc2de3fabea231984f97591ef0cfecfce8ab8201";
