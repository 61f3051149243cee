//! Shared file: `match`.

use super::input::{int, uint};

const SPECIAL: u32 = 77;
const LOW: i32 = -5;

/// On integers: literals, `|`, ranges, consts, bindings, guards, an expression and a statement.
pub fn integers(id: u32, ints: &[u32], _floats: &[f32]) -> [u32; 6] {
    let a = uint(id, ints, 0) % 100;
    let i = int(id, ints, 1) % 20;
    let first = match a {
        0 => 1,
        1 | 2 | 3 => 2,
        4..=9 => 3,
        10..20 => 4,
        SPECIAL => 5,
        n if n % 7 == 0 => n * 10,
        50.. => 6,
        _ => 7,
    };
    let second = match i {
        LOW => 1,
        i32::MIN..=-10 => 2,
        -9..0 => 3,
        0 => 4,
        n @ 1..=5 => n as u32 * 100,
        other => other as u32,
    };
    let mut third = 0;
    match a & 3 {
        0 => third += 1,
        1 => {
            third += 2;
            third *= 3;
        }
        2 => {}
        _ => return [0, 1, 2, 3, 4, 5],
    }
    let fourth = match (a & 1, i > 0) {
        (0, true) => 10,
        (1, true) => 11,
        (n, false) => n,
        _ => 13,
    };
    [first, second, third, fourth, on_bool(i > 3), in_loop(a)]
}

fn on_bool(b: bool) -> u32 {
    match b {
        true => 3,
        false => 4,
    }
}

/// `break` and `continue` inside a match belong to the loop.
fn in_loop(a: u32) -> u32 {
    let mut n = a;
    let mut count = 0;
    loop {
        match n % 4 {
            0 if n == 0 => break,
            1 => {
                n -= 1;
                continue;
            }
            2 => n -= 2,
            _ => n /= 2,
        }
        count += 1;
        if count > 50 {
            return 1000 + n;
        }
    }
    count
}

/// Matches on structs and tuples inside options.
pub fn patterns(id: u32, ints: &[u32], _floats: &[f32]) -> [u32; 3] {
    let spot = Spot {
        x: uint(id, ints, 0) % 4,
        y: uint(id, ints, 1) % 4,
    };
    let first = match spot {
        Spot { x: 0, y } => y,
        Spot { x, y: 1 | 2 } => x * 10,
        Spot { x, y: _ } if x == 3 => 99,
        Spot { .. } => 7,
    };
    let second = match Some((spot.x, spot)) {
        Some((1, Spot { y, .. })) => y + 20,
        Some((n, _)) => n,
        None => 0,
    };
    let Spot { x, y: renamed } = spot;
    let third = if let Spot { x: 2, y } = spot {
        y
    } else {
        x + renamed
    };
    [first, second, third]
}

#[derive(Clone, Copy)]
struct Spot {
    x: u32,
    y: u32,
}
