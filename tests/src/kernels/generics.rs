//! Shared file: generics over types and over numbers.

use super::input::{float, uint};
use super::traits::{Doubler, Scaler, Shape, Square};

#[derive(Clone, Copy)]
struct Both<A, B> {
    first: A,
    second: B,
}

impl<A: Copy, B: Copy> Both<A, B> {
    fn swapped(self) -> Both<B, A> {
        Both {
            first: self.second,
            second: self.first,
        }
    }
}

impl Both<u32, f32> {
    fn special(&self) -> u32 {
        self.first.wrapping_add(self.second as u32)
    }
}

fn pick<T: Copy>(which: bool, a: T, b: T) -> T {
    if which { a } else { b }
}

fn sum<const N: usize>(list: &[u32; N]) -> u32 {
    let mut total = 0u32;
    for i in 0..N {
        total = total.wrapping_add(list[i].wrapping_mul(i as u32 + 1));
    }
    total
}

#[derive(Clone, Copy)]
struct Ring<const N: usize> {
    slots: [u32; N],
    next: usize,
}

impl<const N: usize> Ring<N> {
    const LAST: usize = N - 1;

    fn new() -> Self {
        Self {
            slots: [0; N],
            next: 0,
        }
    }

    fn push(&mut self, value: u32) {
        self.slots[self.next] = value;
        self.next = if self.next == Self::LAST {
            0
        } else {
            self.next + 1
        };
    }
}

fn scaled<S: Scaler>(scaler: &S, x: f32) -> f32 {
    scaler.scale(x) + S::OFFSET
}

fn area_of(shape: &impl Shape, extra: impl Scaler) -> f32 {
    shape.area() + extra.scale(1.0)
}

fn doubled<T>(value: T) -> T
where
    T: core::ops::Add<Output = T> + Copy,
{
    value + value
}

/// Type parameters, inferred and written.
pub fn types(id: u32, ints: &[u32], floats: &[f32]) -> [u32; 4] {
    let a = uint(id, ints, 0);
    let both = Both {
        first: a,
        second: 3.5f32,
    };
    let back = both.swapped().swapped();
    let which = pick(a & 1 == 0, a, 5) ^ pick::<bool>(a > 5, true, false) as u32;
    let f = pick(a & 2 == 0, float(id, floats, 0), 1.0);
    [back.first, both.special(), which, (f * 8.0) as i32 as u32]
}

/// Numbers as parameters.
pub fn numbers(id: u32, ints: &[u32], _floats: &[f32]) -> [u32; 4] {
    let a = uint(id, ints, 0);
    let mut small = Ring::<3>::new();
    let mut large: Ring<5> = Ring::new();
    for k in 0..7 {
        small.push(a ^ k);
        large.push(a.wrapping_add(k));
    }
    [
        sum(&small.slots),
        sum(&large.slots),
        sum(&[a]),
        small.next as u32 + large.next as u32 * 10,
    ]
}

/// Traits as bounds, `impl Trait`, `where`.
pub fn bounds(id: u32, _ints: &[u32], floats: &[f32]) -> [f32; 4] {
    let f = float(id, floats, 0);
    [
        scaled(&Doubler { by: 3.0 }, f),
        scaled::<f32>(&2.0, f),
        area_of(&Square { side: f }, Doubler { by: 1.0 }),
        doubled(f) + doubled(2u32) as f32,
    ]
}
