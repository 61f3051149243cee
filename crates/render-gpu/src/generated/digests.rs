//! Host file: what results depend on: a digest of all shaders of a role.
//!
//! Made from Rust by naga-front-rust; do not edit. This command writes it: cargo run --release -p glimt-generate

/// SHA-256, in hexadecimal, of the shaders that the pixels of a rendered frame depend on.
pub const PIXELS: &str = "c1dcce535f8e87ac5fd587ea8422b6f1f585dd9e08ea6f7bfca32475ce675f41";

/// SHA-256, in hexadecimal, of the shaders that precomputed transfer depend on.
pub const BAKE: &str = "e6d10553a9de673d2803da500d236f721763296e3698f3c0efbc6ba8daa2f43a";

/// SHA-256, in hexadecimal, of the shaders that a simulated capture depend on.
pub const SYNTH: &str = "83e19319241281d0ddf7d1c94eb05aa984f71771b68efb21b688651a56cf21e8";
