//! Shared file: consts.

use super::deep::constants::{BASE, TABLE};
use super::input::{float, uint};
use glam::{UVec2, Vec3};

const COUNT: usize = 4;
const SHIFTED: u32 = BASE << 2 | 1;
const PRIMES: [u32; COUNT * 2] = [2, 3, 5, 7, 11, 13, 17, 19];
const AXES: [Vec3; 3] = [Vec3::X, Vec3::Y, Vec3::new(0.0, 0.5, -1.0)];
const GRID: [[i32; 2]; 3] = [[1, -2], [3, -4], [5, -6]];
const HALF: f32 = 1.0 / 2.0;
const WHOLE: f32 = HALF + HALF * 1.0;
const LIMITS: Limits = Limits {
    low: 3,
    high: SHIFTED + 100,
    size: UVec2::new(7, 9),
};
const LOCAL: u32 = 99;
const NEGATIVE: i32 = -(COUNT as i32) - 1;

#[derive(Clone, Copy)]
struct Limits {
    low: u32,
    high: u32,
    size: UVec2,
}

impl Limits {
    const EMPTY: Limits = Limits {
        low: 0,
        high: 0,
        ..LIMITS
    };
}

/// Computed consts, and const arrays at a dynamic index.
pub fn integers(id: u32, ints: &[u32], _floats: &[f32]) -> [u32; 8] {
    let a = uint(id, ints, 0);
    let k = (a % 8) as usize;
    [
        PRIMES[k],
        TABLE[k % 3] ^ a,
        GRID[k % 3][k & 1] as u32,
        a.clamp(LIMITS.low, LIMITS.high),
        SHIFTED ^ LOCAL,
        LIMITS.size.y + Limits::EMPTY.size.x + Limits::EMPTY.high,
        NEGATIVE as u32,
        COUNT as u32 * BASE,
    ]
}

/// Float and vector consts.
pub fn floats(id: u32, ints: &[u32], floats: &[f32]) -> [f32; 4] {
    let axis = AXES[(uint(id, ints, 0) % 3) as usize];
    let f = float(id, floats, 0);
    [axis.x * f, axis.y * f, axis.z + f, f * HALF + WHOLE]
}
