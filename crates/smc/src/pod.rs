//! Host file: particles and choices as plain bytes, for uploads.

use bytemuck::{NoUninit, Pod, Zeroable};

use crate::bridge::Path;
use crate::particle::Particle;

// SAFETY: a `repr(C)` struct of four four-byte numbers without padding; every bit pattern is a value.
unsafe impl Zeroable for Particle {}
// SAFETY: as above.
unsafe impl Pod for Particle {}
// SAFETY: a fieldless `repr(u32)` enum: four bytes, all of them set. Not every number is a value, so it only goes up.
unsafe impl NoUninit for Path {}
