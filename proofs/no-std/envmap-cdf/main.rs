//! Host file: `glimt-envmap-cdf` linked alone, without std and alloc.

#![no_std]
#![no_main]

#[path = "../rt.rs"]
mod rt;

use core::hint::black_box;
use glam::UVec2;
use glimt_envmap_cdf::{EnvCdf, build_into};

/// The tables of a map with one bright texel are built into arrays on the stack, and a sample comes from that texel.
fn is_right() -> bool {
    let size = UVec2::new(4, 2);
    let bright = black_box(UVec2::new(2, 1));
    let (mut marginal, mut conditional) = ([0; 3], [0; 2 * 5]);
    let row = |y| {
        (0..4).map(move |x| {
            if UVec2::new(x, y) == bright {
                1e6
            } else {
                1e-3
            }
        })
    };
    if build_into(size, row, &mut marginal, &mut conditional).is_err() {
        return false;
    }
    let env = EnvCdf {
        size,
        marginal: &marginal,
        conditional: &conditional,
    };
    let sample = env.sample(black_box(UVec2::new(1 << 30, 3 << 30)));
    sample.texel == bright && env.pdf_sr(sample.direction) == sample.pdf_sr
}
