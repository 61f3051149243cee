//! Shared file: a module with modules below it.

pub mod constants;
pub mod names;

/// Named like others elsewhere.
pub fn who() -> u32 {
    200
}
