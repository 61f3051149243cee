//! Shared file: the functions that run for every ray and pixel, on the CPU and, lowered, on the GPU.
//!
//! A kernel computes one element of a buffer. All ids are local to a tile; [`frame::FrameParams::first_pixel`] places
//! the tile in the image, and random streams are keyed by the pixel of the image, so that an image has the same bits
//! whatever its tiles.
//!
//! The list is generated with the shaders: a new kernel is a new file.

pub mod bis;
pub mod bvh;
pub mod camera;
pub mod candidates;
pub mod capture;
pub mod carry;
pub mod cell_state;
pub mod cells;
pub mod composite;
pub mod diagnose;
pub mod environment;
pub mod estimator;
pub mod expect;
pub mod film;
pub mod frame;
pub mod group_health;
pub mod group_light;
pub mod groups;
pub mod layers;
pub mod light_sh;
pub mod light_target;
pub mod material;
pub mod mis;
pub mod opacity;
pub mod past;
pub mod pattern;
pub mod pilot;
pub mod product;
pub mod proposal;
pub mod prt;
pub mod pyramid;
pub mod raster;
pub mod ray;
pub mod scene;
pub mod scout;
pub mod seen;
pub mod sensor;
pub mod shade;
pub mod smc;
pub mod smc_gather;
pub mod smc_point;
pub mod stage;
pub mod texture;
pub mod transfer;
pub mod triangle;
pub mod unwarp;
