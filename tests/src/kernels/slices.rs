//! Shared file: slices, sub-slices, and structs that hold them.

use super::input::{PER_ELEMENT, uint};

#[derive(Clone, Copy)]
struct Table<'a> {
    width: u32,
    cells: &'a [u32],
}

impl<'a> Table<'a> {
    fn row(&self, y: u32) -> &'a [u32] {
        let from = (y * self.width) as usize;
        &self.cells[from..from + self.width as usize]
    }

    fn at(&self, x: u32, y: u32) -> u32 {
        self.row(y)[x as usize]
    }

    fn is_square(&self) -> bool {
        self.cells.len() as u32 == self.width * self.width
    }
}

#[derive(Clone, Copy)]
struct Both<'a> {
    table: Table<'a>,
    weights: &'a [f32],
}

fn total(list: &[u32]) -> u32 {
    let mut sum = 0u32;
    for i in 0..list.len() {
        sum = sum.wrapping_mul(3).wrapping_add(list[i]);
    }
    sum
}

fn last(list: &[u32]) -> u32 {
    if list.is_empty() {
        12345
    } else {
        list[list.len() - 1]
    }
}

fn weigh(both: &Both<'_>, k: u32) -> u32 {
    both.weights[k as usize % both.weights.len()] as i32 as u32
}

/// Sub-slices, of sub-slices, with every form of range, and empty ones.
pub fn ranges(id: u32, ints: &[u32], _floats: &[f32]) -> [u32; 8] {
    let from = (id * PER_ELEMENT) as usize;
    let mine = &ints[from..from + 8];
    let a = (mine[0] % 8) as usize;
    let b = a + (mine[1] as usize) % (9 - a);
    let middle = &mine[a..b];
    let inner = &mine[1..][1..3];
    [
        total(middle),
        total(&mine[a..]),
        total(&mine[..b]),
        last(middle),
        middle.len() as u32,
        total(inner),
        middle.is_empty() as u32,
        last(&mine[b..]),
    ]
}

/// Structs that hold slices, nested, passed by value and by reference.
pub fn views(id: u32, ints: &[u32], floats: &[f32]) -> [u32; 4] {
    let from = (id * PER_ELEMENT) as usize;
    let table = Table {
        width: 2,
        cells: &ints[from..from + 4],
    };
    let both = Both {
        table,
        weights: &floats[from..][..8],
    };
    let rest = Table {
        cells: &ints[from + 4..from + 8],
        ..table
    };
    [
        table.at(1, 1),
        both.table.at(0, 1) ^ rest.at(1, 0),
        weigh(&both, uint(id, ints, 0)),
        table.is_square() as u32,
    ]
}

/// A view as a kernel's argument, with plain fields beside its slices.
#[derive(Clone, Copy, Debug)]
pub struct Image<'a> {
    /// Width and height.
    pub size: glam::UVec2,
    /// Rows.
    pub pixels: &'a [u32],
}

impl Image<'_> {
    fn wrapped(&self, x: u32, y: u32) -> u32 {
        self.pixels[((y % self.size.y) * self.size.x + x % self.size.x) as usize]
    }
}

/// Plain arguments of buffer types.
#[derive(Clone, Copy, Debug, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct Settings {
    /// A vector.
    pub offset: glam::UVec2,
    /// A number.
    pub factor: u32,
    /// Another.
    pub bias: i32,
}

/// A kernel with a view, a struct by reference, and a plain number.
pub fn arguments(id: u32, image: Image<'_>, settings: &Settings, salt: u32) -> u32 {
    let x = id.wrapping_add(settings.offset.x);
    let found = image.wrapped(x, id / 7 + settings.offset.y);
    (found ^ salt)
        .wrapping_mul(settings.factor)
        .wrapping_add(settings.bias as u32)
}
