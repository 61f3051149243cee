//! Host file: what results depend on: a digest of all shaders of a role.
//!
//! Made from Rust by naga-front-rust; do not edit. This command writes it: cargo run --release -p glimt-generate

/// SHA-256, in hexadecimal, of the shaders that the pixels of a rendered frame depend on.
pub const PIXELS: &str = "14cf16f88976c2c422c20365ae5a5150382c1b95cb86f82526795cbff139705d";

/// SHA-256, in hexadecimal, of the shaders that precomputed transfer depend on.
pub const BAKE: &str = "d223cd87f18ffcb7d81341736f6e4bb4426d0fd2cdc5730d6a7507ef7d1d8f81";

/// SHA-256, in hexadecimal, of the shaders that a simulated capture depend on.
pub const SYNTH: &str = "552785a5a1ad066512e57e4f83c85a8d89fe26e7350be1c2d5d049ca02d0f287";
