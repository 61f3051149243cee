//! Shared file: traits.

use super::input::{Counter, float, uint};

/// Something that scales.
pub trait Scaler {
    /// Added by users of the trait.
    const OFFSET: f32;
    /// May be left as it is.
    const FACTOR: f32 = 2.0;

    /// Scales.
    fn scale(&self, x: f32) -> f32;

    /// Scales twice: a default that calls what the type gives.
    fn twice(&self, x: f32) -> f32 {
        self.scale(self.scale(x)) * Self::FACTOR
    }
}

/// Multiplies by its field and 2.
#[derive(Clone, Copy, Debug)]
pub struct Doubler {
    /// The factor.
    pub by: f32,
}

impl Scaler for Doubler {
    const OFFSET: f32 = 0.5;

    fn scale(&self, x: f32) -> f32 {
        x * self.by * 2.0
    }
}

impl Scaler for f32 {
    const OFFSET: f32 = -1.0;
    const FACTOR: f32 = 3.0;

    fn scale(&self, x: f32) -> f32 {
        x + *self
    }

    fn twice(&self, x: f32) -> f32 {
        x * *self
    }
}

/// Something with an area and a name of its own making.
pub trait Shape {
    /// Corners.
    const CORNERS: u32;

    /// The area.
    fn area(&self) -> f32;

    /// Makes one: no receiver.
    fn unit() -> Self;
}

/// A square.
#[derive(Clone, Copy, Debug)]
pub struct Square {
    /// Its side.
    pub side: f32,
}

impl Shape for Square {
    const CORNERS: u32 = 4;

    fn area(&self) -> f32 {
        self.side * self.side
    }

    fn unit() -> Self {
        Self { side: 1.0 }
    }
}

struct Triangle {
    base: f32,
    height: f32,
}

impl Shape for Triangle {
    const CORNERS: u32 = 3;

    fn area(&self) -> f32 {
        0.5 * self.base * self.height
    }

    fn unit() -> Self {
        Triangle {
            base: 1.0,
            height: 1.0,
        }
    }
}

/// A source of numbers, held by `&mut`.
pub trait Source {
    /// The next number.
    fn draw(&mut self) -> u32;

    /// Two of them, in order.
    fn draw_two(&mut self) -> (u32, u32) {
        let first = self.draw();
        (first, self.draw())
    }
}

impl Source for Counter {
    fn draw(&mut self) -> u32 {
        self.next()
    }
}

/// Counts upward.
struct Upward {
    at: u32,
}

impl Source for Upward {
    fn draw(&mut self) -> u32 {
        self.at = self.at.wrapping_add(1);
        self.at
    }

    fn draw_two(&mut self) -> (u32, u32) {
        (self.draw(), 7)
    }
}

fn draws(source: &mut impl Source) -> u32 {
    let (a, b) = source.draw_two();
    a.wrapping_mul(31).wrapping_add(b) ^ more(source)
}

fn more<S: Source>(source: &mut S) -> u32 {
    source.draw() ^ source.draw().rotate_left(7)
}

fn corners<S: Shape>() -> f32 {
    S::unit().area() + S::CORNERS as f32
}

/// Methods, defaults, overridden defaults, associated consts and functions.
pub fn dispatch(id: u32, _ints: &[u32], floats: &[f32]) -> [f32; 8] {
    let f = float(id, floats, 0);
    let doubler = Doubler { by: 1.5 };
    [
        doubler.scale(f),
        doubler.twice(f),
        f.scale(1.0),
        f.twice(2.0),
        corners::<Square>() + corners::<Triangle>(),
        Triangle {
            base: f,
            height: 2.0,
        }
        .area(),
        <f32 as Scaler>::OFFSET + Doubler::FACTOR,
        Shape::area(&Square { side: f }) + Scaler::scale(&doubler, 1.0),
    ]
}

/// Traits with `&mut self`.
pub fn sources(id: u32, ints: &[u32], _floats: &[f32]) -> [u32; 3] {
    let mut counter = Counter {
        state: uint(id, ints, 0),
    };
    let mut upward = Upward {
        at: uint(id, ints, 1),
    };
    let (a, b) = (draws(&mut counter), draws(&mut upward));
    [a, b, counter.state ^ upward.at]
}
