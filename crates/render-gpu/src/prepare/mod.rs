//! Host file: the buffers and parameters that kernels read: scenes, light tables, plates, settings.

mod attributes;
pub mod bake;
pub mod cells_state;
pub mod env;
mod geometry;
pub(crate) mod light_change;
pub mod light_sh;
pub(crate) mod light_tables;
mod materials;
pub mod past_frame;
pub mod plate;
pub mod projection;
pub mod render;
pub mod scene;
pub mod scene_build;
pub mod scene_error;
pub mod smc_state;
pub mod transfer;
mod tree;
pub mod unwarp;
mod vertex_fans;
