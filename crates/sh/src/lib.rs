//! Host file: real spherical harmonics for low-frequency light. `no_std`, no alloc; glam types.
//!
//! **This version is empty.** The crate is where the parts of Hajisharif, Kronander, Miandji, Unger: *Real-time image based
//! lighting with streaming HDR-light probe sequences* (SIGRAD 2012) will be: the basis (Eq. 5), the projection of a light map
//! (Eqs. 9 to 12), the filter over time (Eq. 13), and precomputed radiance transfer (Eqs. 2, 3, 8 and 14).

#![no_std]
