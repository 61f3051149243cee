//! Shared file: names that hide others, or that cannot be seen from where they are used.

use super::input::{float, uint};

trait Get {
    const N: u32;
    fn get() -> u32;
}

struct Real;

impl Get for Real {
    const N: u32 = 4;

    fn get() -> u32 {
        2
    }
}

#[allow(non_snake_case)]
mod Any {
    pub(super) const N: u32 = 30;

    pub(super) fn get() -> u32 {
        10
    }
}

mod modes {
    #[derive(Clone, Copy)]
    pub(super) enum Mode {
        M,
        N,
    }
}

use modes::Mode;

fn by_module<Any: Get>() -> u32 {
    Any::get() + Any::N
}

fn by_enum<Mode: Get>() -> u32 {
    Mode::N
}

/// A generic parameter hides a module and an enum of its name.
pub fn parameters(id: u32, ints: &[u32], _floats: &[f32]) -> [u32; 3] {
    let a = uint(id, ints, 0) & 0xFFFF;
    [
        a + by_module::<Real>(),
        a + Any::get() + Any::N,
        a + by_enum::<Real>() + Mode::N as u32 + Mode::M as u32,
    ]
}

type Num = f32;

fn typed(a: Num) -> u32 {
    type Num = u32;
    let b: Num = 3;
    b + a as u32
}

/// A signature's types are those of where the function stands.
pub fn signatures(id: u32, ints: &[u32], _floats: &[f32]) -> u32 {
    typed((uint(id, ints, 0) & 0xFFFF) as f32 + 0.5)
}

mod part {
    fn hidden() -> u32 {
        1
    }

    pub(super) fn seen() -> u32 {
        hidden() + 10
    }
}

fn hidden() -> u32 {
    2
}

/// A glob brings in only what may be seen.
pub fn globs(id: u32, ints: &[u32], _floats: &[f32]) -> u32 {
    use part::*;
    uint(id, ints, 0) ^ (hidden() + seen())
}

trait Whole {}

impl Whole for u32 {}

trait Kind {
    fn kind(&self) -> u32;
}

struct Held<T> {
    held: T,
}

impl<T: Whole> Held<T> {
    fn kind(&self) -> u32 {
        1
    }
}

impl<T> Kind for Held<T> {
    fn kind(&self) -> u32 {
        2
    }
}

/// A type's own method is there only where its bounds hold.
pub fn bounds(id: u32, ints: &[u32], floats: &[f32]) -> [u32; 2] {
    let own = Held {
        held: uint(id, ints, 0),
    };
    let by_trait = Held {
        held: float(id, floats, 0),
    };
    [
        own.kind() ^ own.held,
        by_trait.kind() ^ by_trait.held.to_bits(),
    ]
}
