//! Host file: uniform numbers, the warps that make directions of them, and weights that combine strategies. `no_std`,
//! no alloc; glam types.

#![no_std]

pub mod hash;
pub mod math;
pub mod mis;
mod rng;
pub mod sobol;
pub mod uniform;
pub mod xoshiro;

pub use math::{ShadingFrame, luminance};
pub use sobol::OwenSobol;
pub use uniform::{UniformSource, unit_f32, unit_vec2};
pub use xoshiro::Xoshiro128PlusPlus;

/// The crate's name and its shared files, `(path below src/, text)`, for a front end that lowers them to WGSL.
#[cfg(feature = "shader-source")]
pub const SHADER_SOURCE: (&str, &[(&str, &str)]) = (
    "glimt_sampling",
    &[
        ("lib.rs", include_str!("lib.rs")),
        ("hash.rs", include_str!("hash.rs")),
        ("math.rs", include_str!("math.rs")),
        ("mis.rs", include_str!("mis.rs")),
        ("sobol.rs", include_str!("sobol.rs")),
        ("uniform.rs", include_str!("uniform.rs")),
        ("xoshiro.rs", include_str!("xoshiro.rs")),
    ],
);
