//! Host file: `glimt-light-cells` linked alone, without std and alloc.

#![no_std]
#![no_main]

#[path = "../rt.rs"]
mod rt;

use core::hint::black_box;
use glam::{UVec2, Vec3, Vec4};
use glimt_light_cells::{CellSurface, LightCells, build_into, field, required_words};

/// The cells of a map with one bright texel are built into an array on the stack. A floor weighs the texel's cell most, and the texel
/// is drawn of it.
fn is_right() -> bool {
    let size = UVec2::new(32, 16);
    let bright = black_box(UVec2::new(20, 3));
    let mut map = [[Vec4::splat(1e-3); 32]; 16];
    map[bright.y as usize][bright.x as usize] = Vec4::splat(1e6);
    let mut words = [0; 12_000];
    let Ok(count) = required_words(size) else {
        return false;
    };
    let words = &mut words[..count];
    if build_into(size, |y| &map[y as usize], words).is_err() {
        return false;
    }
    let cells = LightCells {
        size,
        words,
        start: 0,
    };
    let floor = CellSurface::new(Vec3::Z, Vec3::Z, 0.5, 0.5, black_box(20.0), 1.0, 0.0);
    let cell = cells.cell_of(bright);
    let quad = cell / 4;
    let flux = cells.quad(field::FLUX, quad);
    let weights = floor.product_weights(&cells.terms(&floor, quad), flux);
    let drawn = cells.sample(cell, black_box(UVec2::new(1 << 30, 3 << 30)));
    weights[(cell % 4) as usize] > 1.0 && drawn.texel == bright && drawn.pmf > 0.99
}
