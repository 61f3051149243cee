//! Shared file: `Option`.

use super::input::{float, int, uint};
use glam::Vec2;

fn half(a: u32) -> Option<u32> {
    if a % 2 == 0 { Some(a / 2) } else { None }
}

fn quarter(a: u32) -> Option<u32> {
    let once = half(a)?;
    Some(half(once)? + 1)
}

fn eighth(a: u32) -> Option<u32> {
    let Some(b) = quarter(a) else {
        return None;
    };
    half(b - 1)
}

/// `?`, `let … else`, `if let`, `match`, `unwrap_or`, `is_some`, `is_none`.
pub fn forms(id: u32, ints: &[u32], _floats: &[f32]) -> [u32; 8] {
    let a = uint(id, ints, 0);
    let matched = match quarter(a) {
        Some(0) => 7,
        Some(n) if n > 100 => n,
        Some(n) => n + 1000,
        None => 5,
    };
    let chosen = if let Some(n) = half(a) { n } else { a };
    let both = if let Some(n) = half(a)
        && let Some(m) = half(uint(id, ints, 1))
        && n > m
    {
        n - m
    } else {
        3
    };
    [
        quarter(a).unwrap_or(9),
        eighth(a).unwrap_or(a),
        matched,
        chosen,
        half(a).is_some() as u32 + 2 * (eighth(a).is_none() as u32),
        both,
        nested(a),
        tuple(a, float_of(a)),
    ]
}

fn float_of(a: u32) -> Option<Vec2> {
    if a & 4 == 0 {
        Some(Vec2::new((a & 0xFF) as f32, 2.0))
    } else {
        None
    }
}

fn nested(a: u32) -> u32 {
    let both: Option<Option<u32>> = if a % 3 == 0 { Some(half(a)) } else { None };
    match both {
        Some(Some(n)) => n ^ 1,
        Some(None) => 11,
        None => 12,
    }
}

fn tuple(a: u32, v: Option<Vec2>) -> u32 {
    match (half(a), v) {
        (Some(n), Some(v)) => n ^ v.x as u32,
        (None, Some(v)) => v.y as u32,
        (Some(n), None) => n,
        (None, None) => 99,
    }
}

/// Options of structs and of tuples, assigned again.
pub fn assigned(id: u32, ints: &[u32], floats: &[f32]) -> [i32; 4] {
    let mut best: Option<(f32, i32)> = None;
    for k in 0..5 {
        let f = float(id, floats, k);
        let better = match best {
            Some((distance, _)) => f < distance,
            None => f > 0.0,
        };
        if better {
            best = Some((f, k as i32));
        }
    }
    let which = if let Some((_, k)) = best { k } else { -1 };
    let mut stack = Some(int(id, ints, 0) & 0xF);
    let mut steps = 0;
    while let Some(n) = stack {
        steps += n;
        stack = if n > 2 { Some(n - 2) } else { None };
    }
    let nothing: Option<i32> = None;
    let taken = stack.unwrap_or(steps) + nothing.unwrap_or(1);
    [which, steps, taken, try_in_loop(id, ints).unwrap_or(-5)]
}

fn try_in_loop(id: u32, ints: &[u32]) -> Option<i32> {
    let mut sum = 0i32;
    for k in 0..4u32 {
        sum = sum.wrapping_add(half(uint(id, ints, k))? as i32);
    }
    Some(sum)
}
