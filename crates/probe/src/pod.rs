//! Host file: the buffer structs as plain bytes, for uploads.

use bytemuck::{Pod, Zeroable};

use crate::gather::{ColourMatrix, TexelTaps};

// SAFETY: `repr(C)` structs of four-byte numbers without padding; every bit pattern is a value.
unsafe impl Zeroable for TexelTaps {}
// SAFETY: as above.
unsafe impl Pod for TexelTaps {}
// SAFETY: `repr(C)`, three vectors of four floats.
unsafe impl Zeroable for ColourMatrix {}
// SAFETY: as above.
unsafe impl Pod for ColourMatrix {}
