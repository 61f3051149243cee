//! Host file: the shared files of the examples, as modules for rustc and as text for the front end.

pub mod gray_scott;

/// [`gray_scott`]'s file, as `naga_front_rust::CrateSource` wants it. A file alone is its crate's root.
pub const GRAY_SCOTT: (&str, &[(&str, &str)]) = (
    "gray_scott",
    &[("gray_scott.rs", include_str!("gray_scott.rs"))],
);
