//! Host file: what results depend on: a digest of all shaders of a role.
//!
//! Made from Rust by naga-front-rust; do not edit. This command writes it: cargo run --release -p glimt-generate

/// SHA-256, in hexadecimal, of the shaders that the pixels of a rendered frame depend on.
pub const PIXELS: &str = "03390d6f005775d892dd476df77907e7c8c17ab8125a9eb14e3e83d0883ac031";

/// SHA-256, in hexadecimal, of the shaders that precomputed transfer depend on.
pub const BAKE: &str = "a17ab6959a051991cafa6d5193cd98756beacccdfaa49dc4d5671b74797d29d1";

/// SHA-256, in hexadecimal, of the shaders that a simulated capture depend on.
pub const SYNTH: &str = "0adf624f711c804a45e1897970266b236734e9c04ac5cc8f514fd47fbdf7118b";
