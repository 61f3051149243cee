//! Host file: what numbers of an image mean: the primaries of its colours, and the curve by which they stand for light.

pub mod encoding;
pub mod primaries;
