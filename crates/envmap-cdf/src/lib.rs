//! Host file: importance sampling of a lat-long environment map by inversion. `no_std`, no alloc; glam types.
//!
//! A table of row probabilities and one of column probabilities per row turn two uniform words into a direction whose
//! density is proportional to the map's radiance, texel by texel.
//!
//! ```
//! use glam::UVec2;
//! use glimt_envmap_cdf::{EnvCdf, build_into, luminance_weights, required_len};
//!
//! // A dim sky of 8 × 4 texels with a lamp in it.
//! let size = UVec2::new(8, 4);
//! let mut map = [[[0.5_f32; 3]; 8]; 4];
//! map[1][3] = [900.0, 800.0, 600.0];
//!
//! let len = required_len(size.x, size.y)?;
//! let (mut marginal, mut conditional) = (vec![0; len.marginal], vec![0; len.conditional]);
//! build_into(
//!     size,
//!     |y| luminance_weights(&map[y as usize]),
//!     &mut marginal,
//!     &mut conditional,
//! )?;
//! let env = EnvCdf::new(size, &marginal, &conditional).unwrap();
//!
//! // Irradiance of an upward plane: most samples find the lamp.
//! let (mut irradiance, n) = (0.0, 4096_u32);
//! for i in 0..n {
//!     let u = UVec2::new(i.wrapping_mul(2_654_435_769), i << 20);
//!     let sample = env.sample(u);
//!     let radiance = map[sample.texel.y as usize][sample.texel.x as usize][1];
//!     irradiance += radiance * sample.direction.z.max(0.0) / sample.pdf_sr / n as f32;
//! }
//! // 0.5 π from the sky, and the lamp: 799.5 times (1/4 of the azimuth's 2π = π/4) times (cos²45° − cos²90°)/2.
//! let exact = core::f32::consts::PI * (0.5 + 799.5 / 16.0);
//! assert!((irradiance / exact - 1.0).abs() < 0.02);
//! # Ok::<(), glimt_envmap_cdf::BuildError>(())
//! ```
//!
//! # Conventions
//!
//! - Maps and directions are those of [`glimt_probe::latlong`]: z up, row 0 at +z, the centre of the image along +x.
//! - Weights are the caller's, usually luminance, one per texel and linear; the sphere's areas are multiplied in here,
//!   exactly, so a weight carries no `sin θ`. A bin is a texel: inside it the density is constant.
//! - Densities are in solid angle, 1/sr, and end in `_sr`.
//! - Tables are `u32` edges in units of 2⁻³¹, one more than bins, the first 0 and the last 2³¹. A texel of positive
//!   weight has at least one unit, taken from the largest texel of its row where it must be; a texel of weight 0 has
//!   none, so it is never drawn. Densities are those of the stored edges: sampling and density cannot disagree.
//!   (f32 edges, on a studio map of 1024×512, were wrong by more than 1 % for 4.6 % of the texels, and lost 0.3 %.)
//! - A row without light has all its edges 0, and no units in the table of rows. A map without light has all edges 0:
//!   its samples have density 0, and so has every direction.
//! - Bad weights (NaN, infinite, negative) count as 0, and their number is returned.
//!
//! # Which file runs where
//!
//! `env_cdf`, `search` and `compensated` are *shared files*: plain Rust without heap or standard library that also
//! lowers to WGSL; with the feature `shader-source` their text is available as `SHADER_SOURCE`. Building the tables
//! ([`build_into`] and its parts) is the host's work, with sums in f64.
//!
//! # Bibliography
//!
//! - M. Pharr, W. Jakob, G. Humphreys: *Physically Based Rendering*, 4th ed., 2023, §§ 2.4, 12.5.2 (sampling
//!   piecewise-constant densities by inversion; image infinite lights).
//! - O. Karlík, M. Šik, P. Vévoda, T. Skřivan, J. Křivánek: *MIS compensation: optimizing sampling techniques in
//!   multiple importance sampling*, ACM Transactions on Graphics 38 (6), 2019.
//! - J. Kronander, J. Dahlin, D. Jönsson, M. Kok, T. B. Schön, J. Unger: *Real-time video based lighting using GPU
//!   raytracing*, EUSIPCO 2014, § 7 (tabulated row and column distributions on the GPU).

#![deny(unsafe_code)]
#![no_std]

mod build;
mod compensate;
mod compensated;
mod edges;
mod env_cdf;
mod search;
mod view;

pub use build::{
    BuildError, BuildReport, MAX_SIZE, RowReport, TableLen, build_into, build_marginal_into,
    build_row_into, luminance_weights, required_len,
};
pub use compensate::{build_compensated_into, compensated_weight, mean_weight, weight_sum};
pub use compensated::{CompensatedCdf, CompensatedSample};
pub use edges::UNITS;
pub use env_cdf::{EnvCdf, EnvSample};
pub use search::{Bin, find_bin};
pub use view::TableError;

/// The crate's name and its shared files, `(path below src/, text)`, for a front end that lowers them to WGSL.
#[cfg(feature = "shader-source")]
pub const SHADER_SOURCE: (&str, &[(&str, &str)]) = (
    "glimt_envmap_cdf",
    &[
        ("lib.rs", include_str!("lib.rs")),
        ("compensated.rs", include_str!("compensated.rs")),
        ("env_cdf.rs", include_str!("env_cdf.rs")),
        ("search.rs", include_str!("search.rs")),
    ],
);

/// The crate's functions as WGSL, made from its shared files: to be pasted into a shader of one's own.
///
/// WGSL wants a name once. `cos_sin_pi` stands in `glimt_probe::WGSL` too, `hash_u32_` and `hash2_` in `glimt_sampling::WGSL`: in
/// a shader of both, leave out one copy of each. They are the same.
#[cfg(feature = "shader-source")]
pub const WGSL: &str = include_str!("../wgsl/envmap_cdf.wgsl");
