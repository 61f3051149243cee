//! Host file: what results depend on: a digest of all shaders of a role.
//!
//! Made from Rust by naga-front-rust; do not edit. This command writes it: cargo run --release -p glimt-generate

/// SHA-256, in hexadecimal, of the shaders that the pixels of a rendered frame depend on.
pub const PIXELS: &str = "d0e261f015b888274b764c3832c7244da64e68f206b23ff68eec5debbe5fc0e8";

/// SHA-256, in hexadecimal, of the shaders that precomputed transfer depend on.
pub const BAKE: &str = "a17ab6959a051991cafa6d5193cd98756beacccdfaa49dc4d5671b74797d29d1";

/// SHA-256, in hexadecimal, of the shaders that a simulated capture depend on.
pub const SYNTH: &str = "22679a1e8f81ca5e74c49525700d0dfdc154bfc588415bbbdc32346153391073";
