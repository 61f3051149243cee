//! Host file: what results depend on: a digest of all shaders of a role.
//!
//! Made from Rust by naga-front-rust; do not edit. This command writes it: cargo run --release -p glimt-generate

/// SHA-256, in hexadecimal, of the shaders that the pixels of a rendered frame depend on.
pub const PIXELS: &str = "b248354dafab2310ecc618fe9defa2d506f11e455f655a2b1073549ccb15d85a";

/// SHA-256, in hexadecimal, of the shaders that precomputed transfer depend on.
pub const BAKE: &str = "cc4db5aee828b1dcdc8ea3b6acbd42799bc9ec92ddf22686b61bf49327b4bf04";

/// SHA-256, in hexadecimal, of the shaders that a simulated capture depend on.
pub const SYNTH: &str = "99f21affbaebc4cfa38b726f21c8cd71dc8c2e9052c98decc201c359193782c9";
