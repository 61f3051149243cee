//! Host file: particles as plain bytes, for uploads.

use bytemuck::{Pod, Zeroable};

use crate::particle::Particle;

// SAFETY: a `repr(C)` struct of four four-byte numbers without padding; every bit pattern is a value.
unsafe impl Zeroable for Particle {}
// SAFETY: as above.
unsafe impl Pod for Particle {}
