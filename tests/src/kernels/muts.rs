//! Shared file: `&mut` arguments.

use super::input::{Counter, uint};
use glam::{UVec2, Vec3};

fn bump(value: &mut u32, by: u32) -> u32 {
    let before = *value;
    *value = value.wrapping_add(by);
    before
}

fn swap(a: &mut u32, b: &mut u32) {
    let kept = *a;
    *a = *b;
    *b = kept;
}

fn twice(value: &mut u32) {
    bump(value, 3);
    bump(&mut *value, 4);
    *value ^= 1;
}

fn fill(list: &mut [u32; 4], from: u32) {
    for i in 0..4 {
        list[i] = from.wrapping_add(i as u32);
    }
    bump(&mut list[2], 100);
}

#[derive(Clone, Copy)]
struct State {
    counter: Counter,
    list: [u32; 4],
    place: UVec2,
    pair: (u32, u32),
}

impl State {
    fn step(&mut self) -> u32 {
        let drawn = self.counter.next();
        self.list[(drawn % 4) as usize] ^= drawn;
        self.touch();
        bump(&mut self.pair.0, drawn);
        self.list[0]
    }

    fn touch(&mut self) {
        self.place.x = self.place.x.wrapping_add(1);
    }
}

fn reset(state: &mut State, keep: u32) {
    *state = State {
        pair: (keep, 0),
        ..*state
    };
    state.counter.state ^= keep;
    fill(&mut state.list, keep);
}

/// Locals, elements, fields, components of fields, and what is already behind `&mut`.
pub fn places(id: u32, ints: &[u32], _floats: &[f32]) -> [u32; 8] {
    let mut a = uint(id, ints, 0);
    let mut b = uint(id, ints, 1);
    let before = bump(&mut a, 5);
    swap(&mut a, &mut b);
    twice(&mut b);
    let mut list = [1, 2, 3, 4];
    let k = (a % 4) as usize;
    bump(&mut list[k], a);
    fill(&mut list, b);
    let mut state = State {
        counter: Counter { state: a },
        list,
        place: UVec2::new(a, b),
        pair: (1, 2),
    };
    let step = state.step();
    bump(&mut state.list[k], 9);
    bump(&mut state.pair.1, a);
    reset(&mut state, before);
    let after = state.step();
    [
        before,
        a,
        b,
        step,
        after,
        state.list[k],
        state.pair.0 ^ state.pair.1,
        state.place.x,
    ]
}

/// An index is evaluated once, even when the call changes what it was made of.
pub fn index_once(id: u32, ints: &[u32], _floats: &[f32]) -> [u32; 4] {
    let mut list = [uint(id, ints, 0), 1, 2, 3];
    let mut counter = Counter {
        state: uint(id, ints, 1),
    };
    // Of a compound assignment to a number, the right side comes first.
    list[(counter.next() % 4) as usize] ^= counter.next() & 0xFF;
    let mut i = (counter.next() % 2) as usize;
    bump(&mut list[i], 10);
    i += 2;
    list[i] = bump(&mut list[1], 1);
    list
}

fn shorten(v: &mut Vec3, limit: f32) -> bool {
    if v.length() > limit {
        *v = v.normalize() * limit;
        v.z += 1.0;
        return true;
    }
    false
}

/// Vectors and booleans behind `&mut`.
pub fn vectors(id: u32, _ints: &[u32], floats: &[f32]) -> [f32; 4] {
    let mut v = Vec3::new(super::input::float(id, floats, 0), 2.0, 1.0);
    let changed = shorten(&mut v, 4.0);
    [v.x, v.y, v.z, changed as u32 as f32]
}

/// Parameters that are `mut` themselves, and shadowed ones.
pub fn parameters(id: u32, ints: &[u32], _floats: &[f32]) -> u32 {
    countdown(uint(id, ints, 0) % 32, 7)
}

fn countdown(mut n: u32, step: u32) -> u32 {
    let step = step | 1;
    let mut total = 0;
    while n > 0 {
        total += n * step;
        n -= 1;
    }
    let total = total ^ n;
    total
}
