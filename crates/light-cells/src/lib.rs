//! Host file: a light map in 512 cells of nearly equal area. `no_std`, no alloc; glam types.
//!
//! A *cell* is a rectangle of texels. Its sums say how much light it holds and where that comes from. So one loop over the cells
//! tells what a surface reflects of the map: weights for sampling the product of light and reflection, and a function whose integral is
//! known, for a control variate. Inside a cell a texel is drawn in proportion to its luminance, with its density.
//!
//! ```
//! use glam::{UVec2, Vec3, Vec4};
//! use glimt_light_cells::{CellSurface, LightCells, QUADS, build_into, field, required_words};
//!
//! // A dim sky with a lamp in it.
//! let size = UVec2::new(64, 32);
//! let mut map = [[Vec4::splat(0.1); 64]; 32];
//! map[5][40] = Vec4::splat(900.0);
//! let mut words = [0; 20_000];
//! let words = &mut words[..required_words(size)?];
//! build_into(size, |y| &map[y as usize], words)?;
//! let cells = LightCells { size, words, start: 0 };
//!
//! // The weights of a white floor: most of its light comes from the lamp's cell.
//! let floor = CellSurface::new(Vec3::Z, Vec3::Z, 1.0, 0.0, 1.0, 1.0, 0.0);
//! let weights = |quad| floor.product_weights(&cells.terms(&floor, quad), cells.quad(field::FLUX, quad));
//! let total: f32 = (0..QUADS).map(|quad| weights(quad).element_sum()).sum();
//! let lamp = cells.cell_of(UVec2::new(40, 5));
//! let share = weights(lamp / 4)[(lamp % 4) as usize] / total;
//! assert!(share > 0.7);
//! // In the cell the lamp is drawn.
//! let drawn = cells.sample(lamp, UVec2::splat(1 << 31));
//! assert_eq!(drawn.texel, UVec2::new(40, 5));
//! assert!(drawn.pmf > 0.98);
//! # Ok::<(), glimt_light_cells::BuildError>(())
//! ```
//!
//! # Conventions
//!
//! - Maps and directions are those of [`glimt_probe::latlong`]: z up, row 0 at +z. Radiance is linear RGB, at least 0.
//! - Cells are numbered row by row, [`COLUMNS`] in each of [`ROWS`] rows. Rows are equal steps in cos θ, as near as rows of texels
//!   allow. A map of fewer texels has cells without any, which are black.
//! - A texel's row in its cell has an edge in units of 2⁻³¹, its column one in units of 2⁻¹⁵. Each texel with light has one unit at
//!   least. Densities are those of the stored edges.
//! - Sums are exact integrals over the piecewise constant map: moments use each texel's mean direction, not that of its centre.
//!
//! # Which file runs where
//!
//! `partition` and `surface` are *shared files*: plain Rust without heap or standard library that also lowers to WGSL; with the feature
//! `shader-source` their text is available as `SHADER_SOURCE`. Building the table is the host's work.
//!
//! # Bibliography
//!
//! - J. Kronander, J. Dahlin, D. Jönsson, M. Kok, T. B. Schön, J. Unger: *Real-time video based lighting using GPU raytracing*,
//!   EUSIPCO 2014, § 8 (control variates as future work).
//! - P. Clarberg, W. Jarosz, T. Akenine-Möller, H. W. Jensen: *Wavelet importance sampling: efficiently evaluating products of complex
//!   functions*, ACM Transactions on Graphics 24 (3), 2005.
//! - M. Toksvig: *Mipmapping normal maps*, Journal of Graphics Tools 10 (3), 2005.

#![deny(unsafe_code)]
#![no_std]

mod build;
mod partition;
mod surface;

pub use build::{
    BandSums, BandWords, BuildError, build_band, build_into, first_row, required_words,
    split_bands, store_sums,
};
pub use partition::{
    CELLS, COLUMN_UNITS, COLUMNS, LightCells, QUADS, ROWS, TexelDraw, column_of, field,
    first_column, table_words,
};
pub use surface::{CellSurface, CellTerms, UNKNOWN_VISIBILITY, cosine_power4};

/// The crate's name and its shared files, `(path below src/, text)`, for a front end that lowers them to WGSL.
#[cfg(feature = "shader-source")]
pub const SHADER_SOURCE: (&str, &[(&str, &str)]) = (
    "glimt_light_cells",
    &[
        ("lib.rs", include_str!("lib.rs")),
        ("partition.rs", include_str!("partition.rs")),
        ("surface.rs", include_str!("surface.rs")),
    ],
);

/// The crate's functions as WGSL, made from its shared files: to be pasted into a shader of one's own.
///
/// WGSL wants a name once. `find_bin` stands in `glimt_envmap_cdf::WGSL` too, `normalisation` in `glimt_brdf::WGSL`: in a shader of
/// both, leave out one copy of each. They are the same.
#[cfg(feature = "shader-source")]
pub const WGSL: &str = include_str!("../wgsl/light_cells.wgsl");
