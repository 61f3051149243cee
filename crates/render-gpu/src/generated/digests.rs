//! Host file: what results depend on: a digest of all shaders of a role.
//!
//! Made from Rust by naga-front-rust; do not edit. This command writes it: cargo run --release -p glimt-generate

/// SHA-256, in hexadecimal, of the shaders that the pixels of a rendered frame depend on.
pub const PIXELS: &str = "9f0fd163efe567177d8609e9ad931bc2951043d4db5c35b62fda3247760e424c";

/// SHA-256, in hexadecimal, of the shaders that precomputed transfer depend on.
pub const BAKE: &str = "cc4db5aee828b1dcdc8ea3b6acbd42799bc9ec92ddf22686b61bf49327b4bf04";

/// SHA-256, in hexadecimal, of the shaders that a simulated capture depend on.
pub const SYNTH: &str = "2fb866978e9751bd8b2e85da9c3dc15c47b78218406eb7497064d826517c831a";
