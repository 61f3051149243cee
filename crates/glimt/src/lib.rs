//! Host file: the program's parts as a library, so that tests and benchmarks load the same scenes and lights.
//!
//! `glimt` turns a shot (a TOML file: light, objects, camera) into frames. See [`shot`] for its keys, [`input`] and
//! [`mesh`] for what is read, [`output`] for what is written, and [`render`] for the pipeline between them.

#![deny(unsafe_code)]

pub mod bake;
pub mod capture;
pub mod checkpoint;
pub mod cli;
pub mod colour;
pub mod command;
pub mod compare;
pub mod demo;
pub mod device;
pub mod error;
pub mod follow;
pub mod frame;
pub mod info;
pub mod input;
pub mod interrupt;
pub mod job;
pub mod light;
pub mod memory;
pub mod mesh;
pub mod notes;
pub mod output;
pub mod printable;
pub mod render;
pub mod report;
pub mod scene;
pub mod setup;
pub mod sh;
pub mod shot;
pub mod synth;
pub mod unwarp;
