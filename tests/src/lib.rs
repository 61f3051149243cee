//! Host file: helpers of the tests.

pub mod gpu;
