//! Shared file: one step of the Gray-Scott reaction-diffusion system on a grid that wraps around.
//!
//! Two substances, `u` and `v`, diffuse; `u + 2v → 3v` turns one into the other, `u` is fed and `v` removed.
//! Gray and Scott 1984; the patterns are those of Pearson 1993.

use glam::{UVec2, Vec2};

/// What the pattern depends on. 16 bytes.
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct Rates {
    /// Diffusion of u and of v, in cells² a step.
    pub diffusion: Vec2,
    /// How fast u is fed, a step.
    pub feed: f32,
    /// How fast v is removed beyond that, a step.
    pub kill: f32,
}

/// A grid of `(u, v)`, row by row.
#[derive(Clone, Copy, Debug)]
pub struct Grid<'a> {
    /// Columns and rows.
    pub size: UVec2,
    /// `size.x * size.y` cells.
    pub cells: &'a [Vec2],
}

impl Grid<'_> {
    /// The cell at `x` and `y`, which may lie one grid beyond the last.
    #[must_use]
    pub fn at(&self, x: u32, y: u32) -> Vec2 {
        self.cells[((y % self.size.y) * self.size.x + x % self.size.x) as usize]
    }

    /// The nine-point Laplacian: the weighted mean of the eight neighbours less the cell itself.
    #[must_use]
    pub fn laplacian(&self, x: u32, y: u32) -> Vec2 {
        // One grid's size more, so that the neighbours before the first are not negative.
        let (x, y) = (x + self.size.x, y + self.size.y);
        let mut sum = -self.at(x, y);
        for j in 0..3 {
            for i in 0..3 {
                if i != 1 || j != 1 {
                    let weight = if i == 1 || j == 1 { 0.2 } else { 0.05 };
                    sum += weight * self.at(x + i - 1, y + j - 1);
                }
            }
        }
        sum
    }
}

/// The value of cell `id` after a step.
#[must_use]
pub fn step(id: u32, grid: Grid<'_>, rates: &Rates) -> Vec2 {
    let (x, y) = (id % grid.size.x, id / grid.size.x);
    let cell = grid.at(x, y);
    let reaction = cell.x * cell.y * cell.y;
    let change = Vec2::new(
        rates.feed * (1.0 - cell.x) - reaction,
        reaction - (rates.feed + rates.kill) * cell.y,
    );
    (cell + rates.diffusion * grid.laplacian(x, y) + change).clamp(Vec2::ZERO, Vec2::ONE)
}
