//! Host file: statistical tests as values, and integrals in f64 to hold estimates against.
//!
//! A package of its own, with little to link, for `scripts/mutate-smc.sh`: it changes what is tested many times over.

pub mod quadrature;
pub mod stats;
