//! Shared file: the language, feature by feature, as kernels that run on both processors.
//!
//! Each is `fn(id, ints, floats) -> T`, and reads the [`input::PER_ELEMENT`] random values of its element.

pub mod chunks;
pub mod consts;
pub mod control;
pub mod corners;
pub mod deep;
pub mod enums;
pub mod floats;
pub mod generics;
pub mod hidden;
pub mod input;
pub mod ints;
pub mod matches;
pub mod matrices;
pub mod modules;
pub mod muts;
pub mod operators;
pub mod options;
pub mod order;
pub mod slices;
pub mod structs;
pub mod traits;
pub mod vectors;
