//! Host file: choices as plain bytes, for uploads.

use bytemuck::NoUninit;

use crate::resample::Scheme;

// SAFETY: a fieldless `repr(u32)` enum: four bytes, all of them set. Not every number is a value, so it only goes up.
unsafe impl NoUninit for Scheme {}
