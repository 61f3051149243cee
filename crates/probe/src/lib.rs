//! Host file: image ↔ direction mappings for light probes. `no_std`, no alloc; glam types.
//!
//! A light probe is a picture of all directions around a point. This crate says which direction a pixel shows and
//! where a direction lies in the picture, for the [lat-long map](latlong), the [angular map](angular) and the
//! [mirror ball](mirror_ball), and gives each texel's solid angle exactly.
//!
//! ```
//! use glam::{UVec2, Vec3};
//! use glimt_probe::latlong;
//!
//! // Average radiance of a tiny map that is lit from above alone.
//! let size = UVec2::new(4, 2);
//! let map = [[1.0f32; 4], [0.0; 4]];
//! let mut flux = 0.0;
//! for row in 0..size.y {
//!     for column in 0..size.x {
//!         flux += map[row as usize][column as usize] * latlong::texel_solid_angle_sr(row, size);
//!     }
//! }
//! assert!((flux - 2.0 * core::f32::consts::PI).abs() < 1e-5);
//! assert_eq!(latlong::direction_to_texel(Vec3::new(0.1, 0.1, 1.0), size).y, 0);
//! ```
//!
//! # Conventions
//!
//! - World: right-handed, **z up**. Directions have unit length and point away from the probe.
//! - Image points `uv ∈ [0, 1]²`: `u` from left to right, `v` from top to bottom, as pixels are stored.
//! - The lat-long and the angular map look along **+x** at their centre, with +y to the *left* and +z up: a photograph taken from inside reads
//!   the right way round. It is the convention of Blender's environment textures.
//! - Values stand at texel centres; a texel is the bin of every table made over the map.
//! - Solid angles are in steradians, angles in radians unless a name says degrees.
//!
//! # One source, two processors
//!
//! All modules but [`unwarp`], which makes tables, are *shared files*: plain Rust without heap or standard library that
//! also lowers to WGSL. With the
//! feature `shader-source` their text is available as `SHADER_SOURCE`.
//!
//! # Bibliography
//!
//! - P. Debevec: *Rendering synthetic objects into real scenes*, SIGGRAPH 1998 (the angular map).
//! - S. Hajisharif, J. Kronander, E. Miandji, J. Unger: *Real-time image based lighting with streaming HDR-light probe
//!   sequences*, SIGRAD 2012, Eqs. 9–12 (the lat-long map; where this crate differs, the item says so), § 4.1 (the mirror
//!   ball at 1250 mm).

#![no_std]

pub mod angular;
pub mod gather;
pub mod latlong;
pub mod mirror_ball;
#[cfg(feature = "bytemuck")]
mod pod;
pub mod rotate;
pub mod trig;
pub mod unwarp;

/// The crate's name and its shared files, `(path below src/, text)`, for a front end that lowers them to WGSL.
#[cfg(feature = "shader-source")]
pub const SHADER_SOURCE: (&str, &[(&str, &str)]) = (
    "glimt_probe",
    &[
        ("lib.rs", include_str!("lib.rs")),
        ("angular.rs", include_str!("angular.rs")),
        ("gather.rs", include_str!("gather.rs")),
        ("latlong.rs", include_str!("latlong.rs")),
        ("mirror_ball.rs", include_str!("mirror_ball.rs")),
        ("rotate.rs", include_str!("rotate.rs")),
        ("trig.rs", include_str!("trig.rs")),
    ],
);

/// The crate's functions as WGSL, made from its shared files: to be pasted into a shader of one's own.
///
/// WGSL wants a name once. `cos_sin_pi` stands in `glimt_envmap_cdf::WGSL` too: in a shader of both, leave out one copy. They
/// are the same.
#[cfg(feature = "shader-source")]
pub const WGSL: &str = include_str!("../wgsl/probe.wgsl");
