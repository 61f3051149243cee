//! Host file: reflection models: Lambert and normalised Blinn-Phong. `no_std`, no alloc; glam types.
//!
//! Each model can be evaluated, sampled, and asked for the density of its samples, so that the estimator
//! `L = Σ ρ(wo, wi) L_i cos θ / pdf / N` can be computed:
//!
//! ```
//! use glam::{UVec2, Vec3};
//! use glimt_brdf::BlinnPhong;
//! use glimt_sampling::{UniformSource, Xoshiro128PlusPlus, unit_vec2};
//!
//! let brdf = BlinnPhong::new(Vec3::splat(0.3), Vec3::splat(0.6), 50.0)?;
//! let wo = Vec3::new(0.6, 0.0, 0.8);
//! // Reflected radiance under a sky of radiance 1: the albedo.
//! let mut source = Xoshiro128PlusPlus::stream(1, 0, 0);
//! let (mut radiance, n) = (Vec3::ZERO, 4096);
//! for _ in 0..n {
//!     let u_lobe = source.next_u32();
//!     let s = brdf.sample(wo, u_lobe, unit_vec2(source.next_uvec2()));
//!     // An impossible sample adds nothing but counts in n.
//!     if s.pdf_sr > 0.0 {
//!         radiance += brdf.eval(wo, s.wi) * s.wi.z / (s.pdf_sr * n as f32);
//!     }
//! }
//! assert!(radiance.max_element() <= brdf.albedo().max_element());
//! # Ok::<(), glimt_brdf::MaterialError>(())
//! ```
//!
//! # Conventions
//!
//! - Local frame: n = +z. `wo` (towards the viewer) and `wi` (towards the light) are unit vectors that point away from
//!   the surface.
//! - `eval` is ρ in 1/sr, per linear RGB channel, and **excludes the cosine**. `pdf_sr` is in 1/sr.
//! - A direction with `z ≤ 0` has ρ = 0 and density 0. A sample of density 0 is *impossible*: it contributes 0 and
//!   counts in N.
//!
//! # Which file runs where
//!
//! All files but `material` (checked constructors) are *shared files*: plain Rust without heap or standard library that
//! also lowers to WGSL; with the feature `shader-source` their text is available as `SHADER_SOURCE`.
//!
//! # Bibliography
//!
//! - J. F. Blinn: *Models of light reflection for computer synthesized pictures*, SIGGRAPH 1977.
//! - F. Giesen: *Phong and Blinn-Phong normalization factors*, 2009 (the exact factor of the half-vector lobe).
//! - R. R. Lewis: *Making shaders more physically plausible*, Eurographics 1993 (energy conservation of such lobes).
//! - B. Walter, S. R. Marschner, H. Li, K. E. Torrance: *Microfacet models for refraction through rough surfaces*,
//!   EGSR 2007, § 5 (`e = 2/α² − 2`; the Jacobian `1/(4 wo·h)`, Eq. 14).
//! - Khronos Group: *glTF 2.0 specification*, 2021, Appendix B (metallic-roughness materials).

#![deny(unsafe_code)]
#![no_std]

mod blinn_phong;
mod lambert;
mod lobe;
mod material;
mod metallic_roughness;
mod sample;

pub use blinn_phong::BlinnPhong;
pub use lambert::Lambert;
pub use lobe::{MAX_EXPONENT, cosine_power, normalisation};
pub use material::MaterialError;
pub use sample::BrdfSample;

/// The crate's name and its shared files, `(path below src/, text)`, for a front end that lowers them to WGSL.
#[cfg(feature = "shader-source")]
pub const SHADER_SOURCE: (&str, &[(&str, &str)]) = (
    "glimt_brdf",
    &[
        ("lib.rs", include_str!("lib.rs")),
        ("blinn_phong.rs", include_str!("blinn_phong.rs")),
        ("lambert.rs", include_str!("lambert.rs")),
        ("lobe.rs", include_str!("lobe.rs")),
        (
            "metallic_roughness.rs",
            include_str!("metallic_roughness.rs"),
        ),
        ("sample.rs", include_str!("sample.rs")),
    ],
);

/// The crate's functions as WGSL, made from its shared files: to be pasted into a shader of one's own.
///
/// WGSL wants a name once. `DirectionSample` and `cos_sin_turns` stand in `glimt_sampling::WGSL` and `glimt_sh::WGSL` too: in a
/// shader of both, leave out one copy of each. They are the same.
#[cfg(feature = "shader-source")]
pub const WGSL: &str = include_str!("../wgsl/brdf.wgsl");
