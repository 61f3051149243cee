//! Shared file: the order in which things happen, seen through a generator whose every call counts.

use super::input::{Counter, mix, uint};

fn three(a: u32, b: u32, c: u32) -> u32 {
    mix(mix(a, b), c)
}

fn noisy(counter: &mut Counter, answer: bool) -> bool {
    counter.next();
    answer
}

struct Parts {
    first: u32,
    second: u32,
    third: u32,
}

/// Operands, arguments, array elements, tuple and struct fields.
pub fn operands(id: u32, ints: &[u32], _floats: &[f32]) -> [u32; 8] {
    let mut rng = Counter {
        state: uint(id, ints, 0),
    };
    let difference = rng.next().wrapping_sub(rng.next());
    let product = (rng.next() | 1) * 3 + rng.next() / ((rng.next() & 15) + 1);
    let called = three(rng.next(), rng.next(), rng.next());
    let list = [rng.next(), rng.next(), called];
    let (b, a) = (rng.next(), rng.next());
    // Fields are evaluated as they are written, not as they are declared.
    let parts = Parts {
        third: rng.next(),
        first: rng.next(),
        second: rng.next(),
    };
    let state = rng.state;
    let mixed = state ^ {
        rng.next();
        rng.state
    };
    [
        difference,
        product,
        called,
        list[0] ^ (list[1] >> 3),
        a ^ (b >> 5),
        parts.first,
        parts.second ^ (parts.third >> 1),
        mixed,
    ]
}

/// Branches draw or do not.
pub fn branches(id: u32, ints: &[u32], _floats: &[f32]) -> [u32; 4] {
    let mut rng = Counter {
        state: uint(id, ints, 0),
    };
    let flag = uint(id, ints, 1) & 1 == 0;
    let sum = rng.next() + if flag { rng.next() } else { 0 } + rng.next();
    let picked = match rng.next() % 3 {
        0 => rng.next(),
        1 => rng.next() ^ rng.next(),
        _ => 4,
    };
    let last = three(rng.next(), if flag { 1 } else { rng.next() }, rng.next());
    [sum, picked, last, rng.state]
}

/// The right side of `&&` and `||` is not evaluated when the left decides.
pub fn short_circuits(id: u32, ints: &[u32], _floats: &[f32]) -> [u32; 6] {
    let mut rng = Counter {
        state: uint(id, ints, 0),
    };
    let (p, q) = (uint(id, ints, 1) & 1 == 0, uint(id, ints, 1) & 2 == 0);
    let and = noisy(&mut rng, p) && noisy(&mut rng, q);
    let after_and = rng.state;
    let or = noisy(&mut rng, p) || noisy(&mut rng, q);
    let after_or = rng.state;
    let mixed =
        noisy(&mut rng, p) && (noisy(&mut rng, q) || noisy(&mut rng, p)) || noisy(&mut rng, q);
    // The index is only in bounds where the left side says so.
    let i = uint(id, ints, 2) as usize;
    let guarded = i < ints.len() && ints[i] > 5;
    let eager = noisy(&mut rng, p) & noisy(&mut rng, q) | noisy(&mut rng, p);
    [
        and as u32 + 2 * (or as u32),
        after_and,
        after_or,
        mixed as u32,
        guarded as u32,
        eager as u32 ^ rng.state,
    ]
}

/// A value read before a call keeps what it was; assignment evaluates its right side first.
pub fn reads(id: u32, ints: &[u32], _floats: &[f32]) -> [u32; 5] {
    let mut rng = Counter {
        state: uint(id, ints, 0),
    };
    let copied = rng;
    let first = rng.state.wrapping_add(rng.next()).wrapping_add(rng.state);
    let mut list = [1u32, 2, 3, 4];
    let mut at = 0usize;
    list[at] = {
        at += 2;
        at as u32 + 10
    };
    let mut total = 5u32;
    total += {
        rng.next();
        rng.state & 0xFF
    };
    let pair = (total, {
        total ^= 3;
        total
    });
    [
        first,
        copied.state,
        list[0] ^ (list[2] << 8),
        pair.0 ^ (pair.1 << 8),
        at as u32,
    ]
}

/// Method chains: the receiver comes before the arguments.
pub fn chains(id: u32, ints: &[u32], _floats: &[f32]) -> [u32; 3] {
    let mut rng = Counter {
        state: uint(id, ints, 0),
    };
    let a = rng
        .next()
        .rotate_left(rng.next() & 31)
        .wrapping_mul(rng.next());
    let b = rng
        .next()
        .clamp(rng.next() & 0xFFF, (rng.next() & 0xFFF) + 0x1000);
    let range_sum = {
        let mut sum = 0u32;
        for i in (rng.next() & 7)..(rng.next() & 15) {
            sum = mix(sum, i);
        }
        sum
    };
    [a, b, range_sum ^ rng.state]
}
