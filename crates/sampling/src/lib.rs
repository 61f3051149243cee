//! Host file: uniform numbers, the warps that make directions of them, and weights that combine strategies. `no_std`,
//! no alloc; glam types.
//!
//! ```
//! use glam::Vec3;
//! use glimt_sampling::warp::{pdf_cosine_hemisphere_sr, sample_cap, sample_cosine_hemisphere};
//! use glimt_sampling::{OwenSobol, UniformSource, mis, unit_vec2};
//!
//! // Irradiance under a sky of radiance 1 with a lamp of radiance 100 overhead, by two strategies at once: the cosine
//! // for the sky, the lamp's own cap for the lamp. The truth is π (1 + 99 sin²α).
//! let height = glimt_sampling::warp::cap_height(0.1);
//! let pdf_lamp = |d: Vec3| glimt_sampling::warp::pdf_cap_sr(d, height);
//! let radiance = |d: Vec3| if pdf_lamp(d) > 0.0 { 100.0 } else { 1.0 };
//! let n = 1024;
//! let mut sum = 0.0;
//! for i in 0..n {
//!     let mut point = OwenSobol::new(1, 0, 0, i);
//!     let cosine = sample_cosine_hemisphere(unit_vec2(point.next_uvec2())).direction;
//!     let lamp = sample_cap(unit_vec2(point.next_uvec2()), height).direction;
//!     for d in [cosine, lamp] {
//!         let density = mis::multi_sample_density(n, pdf_cosine_hemisphere_sr(d), n, pdf_lamp(d));
//!         if density > 0.0 {
//!             sum += radiance(d) * d.z / density;
//!         }
//!     }
//! }
//! let truth = core::f32::consts::PI * (1.0 + 99.0 * 0.1f32.sin().powi(2));
//! assert!((sum / truth - 1.0).abs() < 0.01);
//! ```
//!
//! # What is here
//!
//! | module | what it holds |
//! |---|---|
//! | [`uniform`] | the rule from `u32` to `[0, 1)`, and the trait of everything that yields uniform words |
//! | [`xoshiro`] | a generator; behind `rand_core`'s traits too |
//! | [`sobol`] | Owen-scrambled Sobol points, the pattern to prefer |
//! | [`warp`] | disc, cosine hemisphere, sphere, cap, power-cosine lobe: sample, density, inverse |
//! | [`mis`] | the balance and power heuristics, multi-sample and one-sample estimators |
//! | [`resample`] | systematic, stratified, multinomial and residual resampling, without storage |
//! | [`ris`] | sampling-importance-resampling, without storage |
//! | [`math`] | luminance, shading frame |
//! | [`hash`] | integer hashes |
//!
//! # Conventions
//!
//! - Uniforms are `u32` at the bottom; floats are made of them by [`unit_f32`] alone, and are never 1.
//! - Streams are keyed by (seed, frame, pixel), never by the order of execution.
//! - A density's name ends in its measure: `_sr` per steradian; a discrete one starts with `pmf_`.
//! - An impossible sample has density 0, contributes 0, and counts.
//! - Transcendental functions are `libm`'s, so every host computes the same bits.
//!
//! # One source, two processors
//!
//! All modules but the `rand_core` implementations and `pod` (bytes for uploads, behind the feature `bytemuck`) are *shared
//! files*: plain Rust without heap or standard library that also lowers to WGSL. With the feature `shader-source` their text is
//! available as `SHADER_SOURCE`.
//!
//! # Bibliography
//!
//! - D. Blackman, S. Vigna: *Scrambled linear pseudorandom number generators*, ACM TOMS 47(4), 2021.
//! - B. Burley: *Practical hash-based Owen scrambling*, JCGT 9(4), 2020.
//! - T. Duff et al.: *Building an orthonormal basis, revisited*, JCGT 6(1), 2017.
//! - M. Jarzynski, M. Olano: *Hash functions for GPU rendering*, JCGT 9(3), 2020.
//! - S. Joe, F. Kuo: *Constructing Sobol sequences with better two-dimensional projections*, SIAM J. Sci. Comput. 30,
//!   2008.
//! - J. Kronander et al.: *Real-time video based lighting using GPU raytracing*, EUSIPCO 2014.
//! - E. Lafortune, Y. Willems: *Using the modified Phong reflectance model for physically based rendering*, 1994.
//! - S. Laine, T. Karras: *Stratified sampling for stochastic transparency*, EGSR 2011.
//! - P. Shirley, K. Chiu: *A low distortion map between disk and square*, JGT 2(3), 1997.
//! - E. Veach, L. Guibas: *Optimally combining sampling techniques for Monte Carlo rendering*, SIGGRAPH 1995.
//! - D. B. Rubin: *A noniterative sampling/importance resampling alternative to the data augmentation algorithm*, JASA
//!   82, 1987.
//! - J. Talbot, D. Cline, P. Egbert: *Importance resampling for global illumination*, EGSR 2005.
//! - R. Douc, O. Cappé, E. Moulines: *Comparison of resampling schemes for particle filtering*, ISPA 2005.
//! - G. Steele, D. Lea, C. Flood: *Fast splittable pseudorandom number generators*, OOPSLA 2014.
//! - N. Vegdahl: *Building a better LK hash*, 2021 (the constants of the scrambling).
//! - C. Wellons: *Prospecting for hash functions*, 2018 (`lowbias32`).

#![no_std]

pub mod hash;
pub mod math;
pub mod mis;
#[cfg(feature = "bytemuck")]
mod pod;
pub mod resample;
pub mod ris;
mod rng;
pub mod sobol;
pub mod uniform;
pub mod warp;
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
        ("resample.rs", include_str!("resample.rs")),
        ("ris.rs", include_str!("ris.rs")),
        ("sobol.rs", include_str!("sobol.rs")),
        ("uniform.rs", include_str!("uniform.rs")),
        ("warp.rs", include_str!("warp.rs")),
        ("xoshiro.rs", include_str!("xoshiro.rs")),
    ],
);

/// The crate's functions as WGSL, made from its shared files: to be pasted into a shader of one's own. Enums are numbers there,
/// in the order of their variants.
///
/// WGSL wants a name once. `DirectionSample` and `cos_sin_turns` stand in `glimt_brdf::WGSL` and `glimt_sh::WGSL` too, `sample_cap` in
/// `glimt_sh::WGSL`, `hash_u32_` and `hash2_` in `glimt_envmap_cdf::WGSL`: in a shader of both, leave out one copy of each. They
/// are the same.
#[cfg(feature = "shader-source")]
pub const WGSL: &str = include_str!("../wgsl/sampling.wgsl");
