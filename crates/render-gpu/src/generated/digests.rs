//! Host file: what results depend on: a digest of all shaders of a role.
//!
//! Made from Rust by naga-front-rust; do not edit. This command writes it: cargo run --release -p glimt-generate

/// SHA-256, in hexadecimal, of the shaders that the pixels of a rendered frame depend on.
pub const PIXELS: &str = "073f41e1f7843f8726e6bff8dfcde443d0e8c935637ff1e8479912b508598463";

/// SHA-256, in hexadecimal, of the shaders that precomputed transfer depend on.
pub const BAKE: &str = "a17ab6959a051991cafa6d5193cd98756beacccdfaa49dc4d5671b74797d29d1";

/// SHA-256, in hexadecimal, of the shaders that a simulated capture depend on.
pub const SYNTH: &str = "31aa047851bfd91213aadbab8ae4201b49c826ad321b41c0d2421e4408c2b22c";
