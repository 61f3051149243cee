//! Host file: real spherical harmonics for low-frequency light. `no_std`, no alloc; glam types.

#![no_std]

pub mod basis;
pub mod separable;

pub use basis::{
    MAX_BANDS, MAX_COEFFICIENTS, add_basis, basis, coefficient_count, coefficient_index,
    cosine_lobe, hann,
};
pub use separable::{meridian, ring};

/// The crate's name and its shared files, `(path below src/, text)`, for a front end that lowers them to WGSL.
#[cfg(feature = "shader-source")]
pub const SHADER_SOURCE: (&str, &[(&str, &str)]) = (
    "glimt_sh",
    &[
        ("lib.rs", include_str!("lib.rs")),
        ("basis.rs", include_str!("basis.rs")),
        ("separable.rs", include_str!("separable.rs")),
    ],
);

/// The crate's functions as WGSL, made from its shared files: to be pasted into a shader of one's own.
#[cfg(feature = "shader-source")]
pub const WGSL: &str = include_str!("../wgsl/sh.wgsl");
