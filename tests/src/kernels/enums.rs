//! Shared file: enums without fields.

use super::input::uint;
use Mode::{Add, Second, Subtract, Xor};

/// A way to combine two numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// Sum.
    Add,
    /// Difference.
    Subtract,
    /// Exclusive or.
    Xor,
    /// The second number.
    Second,
}

impl Mode {
    const DEFAULT: Mode = Mode::Xor;

    fn from_number(n: u32) -> Self {
        match n % 5 {
            0 => Self::Add,
            1 => Self::Subtract,
            2 => Mode::Second,
            _ => Self::DEFAULT,
        }
    }

    fn apply(self, a: u32, b: u32) -> u32 {
        match self {
            Add => a.wrapping_add(b),
            Subtract => a.wrapping_sub(b),
            Xor | Second if a == 0 => 1,
            Xor => a ^ b,
            Second => b,
        }
    }

    fn swaps(&self) -> bool {
        *self == Mode::Add || *self == Mode::Xor
    }
}

/// Made, passed, compared, matched.
pub fn modes(id: u32, ints: &[u32], _floats: &[f32]) -> [u32; 4] {
    let mode = Mode::from_number(uint(id, ints, 0));
    let (a, b) = (uint(id, ints, 1), uint(id, ints, 2));
    let other = if mode != Mode::Second {
        mode
    } else {
        Mode::Add
    };
    let optional = if a > b { Some(other) } else { None };
    let picked = match optional {
        Some(Mode::Add | Mode::Subtract) => 1,
        Some(_) => 2,
        None => 3,
    };
    [
        mode.apply(a, b),
        other.apply(b, a),
        mode.swaps() as u32,
        picked,
    ]
}
