//! Host file: what results depend on: a digest of all shaders of a role.
//!
//! Made from Rust by naga-front-rust; do not edit. This command writes it: cargo run --release -p glimt-generate

/// SHA-256, in hexadecimal, of the shaders that the pixels of a rendered frame depend on.
pub const PIXELS: &str = "01336efb8fa1d5ded7bea5233f73bdd4910774bfadb2b11b71d66560efaef6db";

/// SHA-256, in hexadecimal, of the shaders that precomputed transfer depend on.
pub const BAKE: &str = "a17ab6959a051991cafa6d5193cd98756beacccdfaa49dc4d5671b74797d29d1";

/// SHA-256, in hexadecimal, of the shaders that a simulated capture depend on.
pub const SYNTH: &str = "22679a1e8f81ca5e74c49525700d0dfdc154bfc588415bbbdc32346153391073";
