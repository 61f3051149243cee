//! Shared file: structs, tuples and arrays.

use super::input::{float, int, uint};
use glam::{UVec2, Vec2, Vec3};

/// A buffer struct of mixed types.
#[derive(Clone, Copy, Debug, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct Mixed {
    /// A vector that WGSL wants at a multiple of 16, and a scalar that may follow it at once.
    pub direction: Vec3,
    /// That scalar.
    pub weight: f32,
    /// A vector at a multiple of 8.
    pub place: UVec2,
    /// A signed number.
    pub sign: i32,
    /// An unsigned one.
    pub bits: u32,
}

/// A struct as the result.
pub fn result(id: u32, ints: &[u32], floats: &[f32]) -> Mixed {
    let weight = float(id, floats, 0);
    Mixed {
        bits: uint(id, ints, 0),
        weight,
        direction: Vec3::new(weight, float(id, floats, 1), 1.0),
        place: UVec2::new(uint(id, ints, 1), 3),
        sign: int(id, ints, 2),
    }
}

/// Arrays and structs inside a struct.
#[derive(Clone, Copy, Debug, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct Nested {
    /// An array.
    pub list: [u32; 4],
    /// A struct.
    pub inner: Mixed,
    /// An array of vectors.
    pub spots: [Vec2; 2],
}

/// A nested struct as the result.
pub fn nested(id: u32, ints: &[u32], floats: &[f32]) -> Nested {
    let inner = result(id, ints, floats);
    let mut made = Nested {
        list: [1, 2, 3, inner.bits],
        inner,
        spots: [Vec2::new(inner.weight, 1.0), Vec2::ZERO],
    };
    made.list[1] = made.inner.place.x;
    made.inner.direction.y = 2.0 * made.spots[0].x;
    made.spots[1].x = made.inner.direction.x + 1.0;
    made
}

#[derive(Clone, Copy)]
struct Pair(u32, i32);

#[derive(Clone, Copy)]
struct Marker;

#[derive(Clone, Copy)]
struct Wide {
    pair: Pair,
    flags: [bool; 2],
    depth: usize,
    what: Marker,
}

impl Wide {
    const LIMIT: u32 = 100;

    fn new(a: u32, b: i32) -> Self {
        Self {
            pair: Pair(a, b),
            flags: [a > 5, b > 0],
            depth: 2,
            what: Marker,
        }
    }

    fn total(&self) -> u32 {
        let Self {
            pair: Pair(a, b),
            depth,
            ..
        } = *self;
        a.wrapping_add(b as u32).wrapping_add(depth as u32) % Self::LIMIT
    }

    fn deeper(self, by: usize) -> Self {
        Self {
            depth: self.depth + by,
            ..self
        }
    }
}

/// Local structs: tuple structs, unit structs, methods, patterns, `..base`.
pub fn local(id: u32, ints: &[u32], _floats: &[f32]) -> [u32; 6] {
    let wide = Wide::new(uint(id, ints, 0), int(id, ints, 1)).deeper(3);
    let Wide {
        pair,
        flags,
        what: Marker,
        ..
    } = wide.deeper(1);
    let first = flags[0];
    let other = Wide {
        pair: Pair(pair.0 ^ 1, 4),
        ..wide
    };
    [
        wide.total(),
        other.total(),
        pair.1 as u32,
        first as u32,
        other.flags[1] as u32 + wide.depth as u32,
        Wide::total(&other.deeper(40)),
    ]
}

fn divide(a: u32, b: u32) -> (u32, u32) {
    (a / b, a % b)
}

/// Tuples: made, returned, taken apart, nested.
pub fn tuples(id: u32, ints: &[u32], floats: &[f32]) -> [u32; 6] {
    let (quotient, remainder) = divide(uint(id, ints, 0), uint(id, ints, 1).max(1));
    let nested = ((quotient, float(id, floats, 0) > 0.0), remainder);
    let ((q, positive), _) = nested;
    let mut swap = (1u32, q);
    swap.0 += remainder >> 1;
    swap = (swap.1, swap.0);
    let (mut a, b) = swap;
    a ^= b;
    [quotient, nested.0.0, positive as u32, swap.0, a, nested.1]
}

/// Arrays: of arrays, of structs, indexed dynamically, copied by value.
pub fn arrays(id: u32, ints: &[u32], _floats: &[f32]) -> [u32; 8] {
    let mut table = [[0u32; 3]; 2];
    for i in 0..6 {
        table[i / 3][i % 3] = uint(id, ints, i as u32) >> i;
    }
    let copy = table;
    let k = (uint(id, ints, 6) % 3) as usize;
    table[1][k] = 42;
    let mut pairs = [Pair(1, 2), Pair(3, 4), Pair(5, 6)];
    pairs[k].0 += copy[0][k] >> 1;
    pairs[2] = pairs[k];
    let row = table[k % 2];
    [
        table[1][k],
        copy[1][k],
        pairs[2].0,
        pairs[0].0,
        pairs[k].1 as u32,
        row[2],
        0,
        table[0][0],
    ]
}
