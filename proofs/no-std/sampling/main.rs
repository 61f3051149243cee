//! Host file: `glimt-sampling` linked alone, without std and alloc.

#![no_std]
#![no_main]

#[path = "../rt.rs"]
mod rt;

use core::hint::black_box;
use glimt_sampling::mis::balance_heuristic;
use glimt_sampling::uniform::{UniformSource, unit_f32};
use glimt_sampling::xoshiro::Xoshiro128PlusPlus;

/// The generator's numbers have the mean of a uniform variable, and two strategies' weights add up to one.
fn is_right() -> bool {
    let mut source = Xoshiro128PlusPlus::stream(black_box(1), 2, 3);
    let mut sum = 0.0_f32;
    for _ in 0..4096 {
        sum += unit_f32(source.next_u32());
    }
    let (f, g) = black_box((0.3, 1.7));
    let weights = balance_heuristic(2, f, 3, g) + balance_heuristic(3, g, 2, f);
    (sum / 4096.0 - 0.5).abs() < 0.03 && (weights - 1.0).abs() < 1e-6
}
