//! Host file: real spherical harmonics for low-frequency light. `no_std`, no alloc; glam types.
//!
//! A light is described by the n² coefficients of its first n bands, up to six: enough for what diffuse objects make of it.
//!
//! ```
//! use glam::{UVec2, Vec3};
//! use glimt_sh::{Projection, RingTable, ShError, build_ring_table_into, evaluate, irradiance, ring_table_len, windowed};
//!
//! // The map of a sky of radiance 1 above a black ground, projected onto three bands.
//! let (size, bands) = (UVec2::new(64, 32), 3);
//! let mut table = vec![0.0; ring_table_len(size.x, bands, 3)?];
//! build_ring_table_into(size.x, bands, 3, &mut table)?;
//! let table = RingTable::new(size.x, bands, 3, &table)?;
//! let map: Vec<[f32; 3]> = (0..size.x * size.y).map(|i| if i / size.x < 16 { [1.0; 3] } else { [0.0; 3] }).collect();
//! let mut projection = Projection::new(bands, size)?;
//! projection.add_rows(&table, 0, map.as_flattened())?;
//! let light = projection.coefficients();
//! // Irradiance from above is π, and π/2 where a wall stands upright.
//! let e = irradiance(&light);
//! assert!((evaluate(&e, Vec3::Z).x - 3.14).abs() < 0.1);
//! assert!((evaluate(&e, Vec3::X).x - 1.57).abs() < 1e-3);
//! // Against ringing, where the light itself is looked at.
//! let soft = windowed(&light, 3.0);
//! assert!(evaluate(&soft, Vec3::NEG_Z).x.abs() < evaluate(&light, Vec3::NEG_Z).x.abs());
//! # Ok::<(), ShError>(())
//! ```
//!
//! # What is here
//!
//! | module | what it holds |
//! |---|---|
//! | [`mod@basis`] | the basis, written out, and the order of its coefficients |
//! | [`separable`] | a basis function as a factor of φ times one of θ |
//! | [`hann`], [`cosine_lobe`], [`temporal_filter`], [`rotate_z`] | what is done to one coefficient, on both processors |
//! | [`RingTable`], [`Projection`] | a lat-long map's coefficients, a row at a time |
//! | [`SampledProjection`], [`stratified_direction`] | any function's coefficients, from samples |
//! | [`evaluate`], [`dot`](fn@dot), [`windowed`], [`irradiance`], [`temporally_filtered`] | what is done with a light's coefficients |
//! | [`rotated`] | turning a light any way |
//! | [`condon_shortley`], [`filament_irradiance`] | the same coefficients as others write them |
//!
//! # Conventions
//!
//! - World: right-handed, **z up**. Directions have unit length. Maps are those of [`glimt_probe::latlong`]: row 0 at +z,
//!   `φ = π − 2πu`.
//! - The basis is real and orthonormal, **without the Condon–Shortley sign**: band 1 is `√(3/4π) (y, z, x)`. The
//!   coefficient of (l, m) stands at l(l + 1) + m.
//! - n bands are l = 0, …, n − 1. Coefficients are in radiance times √sr: those of a light of radiance 1 all around are
//!   (√4π, 0, 0, …).
//! - A texel is a bin: the basis at its centre times its exact area. Projection is linear: it looks at no texel's value.
//!
//! # One source, two processors
//!
//! [`mod@basis`], [`separable`], and the modules of [`stratified_direction`] and [`hann`] are *shared files*: plain
//! Rust that also lowers to WGSL. With the feature `shader-source` their text is available as `SHADER_SOURCE`, and `WGSL`
//! holds their functions.
//!
//! With the feature `std`, which is off unless asked for, [`RingTable::row_sums`] looks at run time whether the processor has
//! AVX2 and FMA. Without them, rows are projected at about half that pace.
//!
//! # Bibliography
//!
//! 1. S. Hajisharif, J. Kronander, E. Miandji, J. Unger: *Real-time image based lighting with streaming HDR-light probe
//!    sequences*, SIGRAD 2012. Eq. 5 (the basis; √2 for m ≠ 0 is missing in print), Eqs. 8 and 11 (projection; the exact
//!    area instead of Eq. 12), Eq. 13 (the filter over time), Eqs. 2 and 14 (products).
//! 2. R. Ramamoorthi, P. Hanrahan: *An efficient representation for irradiance environment maps*, SIGGRAPH 2001. Eqs. 7–10.
//! 3. P.-P. Sloan: *Stupid spherical harmonics (SH) tricks*, GDC 2008 (windows).
//! 4. P.-P. Sloan, J. Kautz, J. Snyder: *Precomputed radiance transfer for real-time rendering in dynamic, low-frequency
//!    lighting environments*, SIGGRAPH 2002.
//! 5. W. Gautschi: *Orthogonal polynomials: computation and approximation*, 2004 (Gauss's rules, by which lights are
//!    turned).

#![no_std]
#[cfg(feature = "std")]
extern crate std;

pub mod basis;
mod convention;
mod directions;
mod error;
mod filter;
mod light;
mod projection;
mod ring_table;
mod rotate;
mod row;
pub mod separable;
#[cfg(all(feature = "std", target_arch = "x86_64"))]
mod wide;

pub use basis::{
    MAX_BANDS, MAX_COEFFICIENTS, add_basis, basis, coefficient_band, coefficient_count,
    coefficient_index, coefficient_order,
};
pub use convention::{
    Z_UP_TO_Y_UP, condon_shortley, filament_irradiance, from_filament_irradiance,
};
pub use directions::stratified_direction;
pub use error::ShError;
pub use filter::{cosine_lobe, hann, rotate_z, temporal_filter};
pub use light::{LightCoefficients, dot, evaluate, irradiance, temporally_filtered, windowed};
pub use projection::{Projection, SampledProjection};
pub use ring_table::{RingSums, RingTable, build_ring_table_into, ring_table_len};
pub use rotate::rotated;
pub use separable::{meridian, ring};

/// The crate's name and its shared files, `(path below src/, text)`, for a front end that lowers them to WGSL.
#[cfg(feature = "shader-source")]
pub const SHADER_SOURCE: (&str, &[(&str, &str)]) = (
    "glimt_sh",
    &[
        ("lib.rs", include_str!("lib.rs")),
        ("basis.rs", include_str!("basis.rs")),
        ("directions.rs", include_str!("directions.rs")),
        ("filter.rs", include_str!("filter.rs")),
        ("separable.rs", include_str!("separable.rs")),
    ],
);

/// The crate's functions as WGSL, made from its shared files: to be pasted into a shader of one's own.
///
/// WGSL wants a name once. `DirectionSample`, `cos_sin_turns` and `sample_cap` stand in `glimt_sampling::WGSL` too, the first
/// two in `glimt_brdf::WGSL`: in a shader of both, leave out one copy of each. They are the same.
#[cfg(feature = "shader-source")]
pub const WGSL: &str = include_str!("../wgsl/sh.wgsl");
