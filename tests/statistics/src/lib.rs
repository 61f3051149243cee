//! Host file: what a statistical test needs beside what it tests: judges, integrals in f64, oracles, densities to draw from.
//!
//! It depends on no crate of the project, so that the tests of each of them can use it, and has little to link.

pub mod films;
pub mod harmonics;
pub mod mirror_ball;
pub mod quadrature;
pub mod stats;
pub mod worst;
