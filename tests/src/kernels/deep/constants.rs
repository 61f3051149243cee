//! Shared file: consts for other modules.

/// A number that others build on.
pub const BASE: u32 = 0x40;

/// An array of another module.
pub const TABLE: [u32; 3] = [BASE, BASE + 1, super::names::STEP * 2];
