//! Host file: what is prepared outside the kernels: scene descriptions, light maps, settings.

pub mod env;
pub mod render;
pub mod scene;
