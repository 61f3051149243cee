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

/// What becomes of a number. The variants have numbers of their own, and lie in buffers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, bytemuck::NoUninit)]
#[repr(u32)]
pub enum Operation {
    /// Nothing.
    Keep = 3,
    /// The amount is added.
    Add,
    /// All bits are inverted.
    Invert = 0x8000_0001,
    /// The amount takes its place.
    Replace = 0,
}

/// An operation with its amount, and another where the first leaves an even number. 12 bytes.
#[derive(Clone, Copy, Debug, bytemuck::NoUninit)]
#[repr(C)]
pub struct Step {
    /// What is done.
    pub operation: Operation,
    /// By how much.
    pub amount: u32,
    /// What is done to an even number.
    pub then: Operation,
}

/// Steps, and what comes before them.
#[derive(Clone, Copy, Debug)]
pub struct Recipe<'a> {
    /// What is done first, by 1.
    pub first: Operation,
    /// What follows.
    pub steps: &'a [Step],
}

impl Operation {
    const LAST: Operation = Operation::Invert;

    fn apply(self, n: u32, amount: u32) -> u32 {
        match self {
            Operation::Keep => n,
            Operation::Add => n.wrapping_add(amount),
            Operation::Invert => !n,
            Operation::Replace => amount,
        }
    }
}

impl Step {
    fn apply(&self, n: u32) -> u32 {
        let made = self.operation.apply(n, self.amount);
        if made % 2 == 0 && self.then != Operation::Keep {
            self.then.apply(made, self.amount)
        } else {
            made
        }
    }
}

/// Read from params, from a view, from a slice, and from structs in both; numbers are written.
pub fn buffered(
    id: u32,
    own: Operation,
    step: &Step,
    recipe: Recipe<'_>,
    operations: &[Operation],
) -> [u32; 4] {
    let mut n = recipe.first.apply(id, 1);
    for i in 0..recipe.steps.len() {
        n = recipe.steps[i].apply(n);
    }
    let read = operations[id as usize % operations.len()];
    let number = match read {
        Operation::Keep | Operation::Replace => read as u32,
        Operation::LAST => 7,
        other => other as u32 + 100,
    };
    let is_own = read == own;
    [
        n,
        number,
        own.apply(step.apply(id), 5),
        is_own as u32 + 2 * (own as u32),
    ]
}
