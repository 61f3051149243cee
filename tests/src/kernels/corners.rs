//! Shared file: where lowering could go wrong without a word.

use super::input::{Counter, float, int, mix, uint};
use super::traits::Scaler;
use glam::{Mat3, UVec2, Vec3, Vec4};

fn bump(value: &mut u32, by: u32) -> u32 {
    *value = value.wrapping_add(by);
    *value
}

fn three(a: u32, b: u32, c: u32) -> u32 {
    mix(mix(a, b), c)
}

struct Triple {
    first: u32,
    second: u32,
    third: u32,
}

/// A variable is read where it stands, before a later operand changes it.
pub fn reads_between(id: u32, ints: &[u32], _floats: &[f32]) -> [u32; 8] {
    let mut a = uint(id, ints, 0);
    let called = three(a, bump(&mut a, 3), a);
    let list = [a, bump(&mut a, 5), a];
    let triple = Triple {
        third: a,
        first: bump(&mut a, 7),
        second: a,
    };
    let sum = a.wrapping_add(bump(&mut a, 9)).wrapping_add(a);
    let pair = (a, bump(&mut a, 11), a);
    let mut i = 0usize;
    let items = [uint(id, ints, 1), uint(id, ints, 2), uint(id, ints, 3)];
    let indexed = items[i] ^ {
        i += 2;
        items[i]
    };
    let compared = (a < bump(&mut a, 13)) as u32;
    [
        called,
        three(list[0], list[1], list[2]),
        three(triple.first, triple.second, triple.third),
        sum,
        three(pair.0, pair.1, pair.2),
        indexed,
        compared,
        a,
    ]
}

/// Of `=` and of `+=` on numbers the right side comes first; of `+=` on anything else, the left.
pub fn assignments(id: u32, ints: &[u32], _floats: &[f32]) -> [u32; 8] {
    let mut rng = Counter {
        state: uint(id, ints, 0),
    };
    let mut list = [0u32; 4];
    list[(rng.next() & 3) as usize] = rng.next();
    list[(rng.next() & 3) as usize] ^= rng.next();
    let mut vectors = [UVec2::ZERO; 2];
    vectors[(rng.next() & 1) as usize] += UVec2::splat(rng.next());
    vectors[(rng.next() & 1) as usize].x = rng.next();
    let mut i = 0usize;
    list[{
        i += 1;
        i
    }] = {
        i *= 2;
        i as u32 + 5
    };
    [
        list[0],
        list[1],
        list[2],
        list[3],
        vectors[0].x,
        vectors[0].y,
        vectors[1].x,
        vectors[1].y,
    ]
}

/// What is declared in a loop is made again each time round.
pub fn fresh_in_loops(id: u32, ints: &[u32], _floats: &[f32]) -> [u32; 4] {
    let mut totals = [0u32; 4];
    for k in 0..5 {
        let mut sum = 0;
        let mut list = [0u32; 3];
        let later;
        let mut maybe: Option<u32> = None;
        if k & 1 == 0 {
            later = k;
            maybe = Some(k);
        } else {
            later = 9;
        }
        for j in 0..3 {
            if j == k {
                continue;
            }
            sum += uint(id, ints, j) & 0xFF;
            list[j as usize] += sum;
        }
        totals[0] += sum;
        totals[1] += list[2] + later;
        totals[2] += maybe.unwrap_or(100);
        totals[3] = mix(totals[3], list[0]);
    }
    totals
}

fn odd(a: u32) -> Option<u32> {
    if a & 1 == 1 { Some(a >> 1) } else { None }
}

fn leave_early(a: u32, rng: &mut Counter) -> Option<u32> {
    let before = rng.next();
    let sum = before ^ three(odd(a)?, rng.next(), odd(rng.next())?);
    Some(sum ^ if a > 100 { return Some(7) } else { rng.next() })
}

/// `?` and `return` in the middle of an expression.
pub fn leaving(id: u32, ints: &[u32], _floats: &[f32]) -> [u32; 3] {
    let mut rng = Counter {
        state: uint(id, ints, 0),
    };
    let result = leave_early(uint(id, ints, 1), &mut rng).unwrap_or(3);
    let from_loop = rng.state
        ^ loop {
            if rng.next() & 3 == 0 {
                break rng.next();
            }
        };
    [result, from_loop, rng.state]
}

/// Names that mean something in WGSL, or in the entry point around the kernel.
pub fn names(id: u32, ints: &[u32], _floats: &[f32]) -> u32 {
    let var = uint(id, ints, 0);
    let array = var ^ 1;
    let vec3 = array.rotate_left(3);
    let select = vec3 ^ 5;
    let params = select.wrapping_add(1);
    let out = params ^ 0xF0;
    let first = out >> 1;
    let count = first ^ out;
    let function = count;
    let texture = function ^ id;
    let local = texture;
    let groups = local ^ 2;
    let f32_ = groups;
    let _e1 = f32_ ^ 9;
    let x1 = _e1 ^ 3;
    let x1_ = x1 ^ 8;
    entry(main(x1_))
}

fn main(discard: u32) -> u32 {
    discard ^ 77
}

fn entry(override_: u32) -> u32 {
    let enable = override_ ^ 1;
    enable.wrapping_mul(3)
}

struct Params {
    first: u32,
}

#[derive(Clone, Copy)]
struct Option_u32 {
    value: u32,
}

/// Types whose names are those of what the lowering itself makes.
pub fn type_names(id: u32, ints: &[u32], _floats: &[f32]) -> u32 {
    let params = Params {
        first: uint(id, ints, 0),
    };
    let own = Option_u32 {
        value: params.first ^ 1,
    };
    let real = odd(own.value);
    let pair = (own.value, params.first);
    real.unwrap_or(pair.1) ^ pair.0
}

struct Measure {
    length: f32,
}

impl Measure {
    /// Hides the trait's method of the same name.
    fn scale(&self, x: f32) -> f32 {
        x + 100.0
    }
}

impl Scaler for Measure {
    const OFFSET: f32 = 4.0;

    fn scale(&self, x: f32) -> f32 {
        x * self.length
    }
}

/// A type's own method comes before a trait's.
pub fn hidden_methods(id: u32, _ints: &[u32], floats: &[f32]) -> [f32; 3] {
    let measure = Measure {
        length: float(id, floats, 0),
    };
    [
        measure.scale(2.0),
        Scaler::scale(&measure, 2.0),
        Measure::scale(&measure, 3.0),
    ]
}

const BIG: u32 = 0xFFFF_FFF0;
const STEP: i32 = i32::MAX;
const ROLLED: u32 = BIG << 3 >> 1;
const NEGATIVE: i32 = -17 / 5 * 10 + -17 % 5;
const FRACTION: f32 = 1.0 / 3.0;
const TINY: f32 = 1.5e-38;
const FLAGS: [bool; 3] = [true, false, true];

/// Constants that wrap, and whose folding must not be refused or done otherwise.
pub fn folded(id: u32, ints: &[u32], _floats: &[f32]) -> [u32; 8] {
    let k = (uint(id, ints, 0) % 3) as usize;
    [
        BIG.wrapping_add(100),
        5u32.wrapping_sub(7),
        BIG.wrapping_mul(0x9E37_79B9),
        STEP.wrapping_add(1) as u32,
        1u32.wrapping_shl(33) ^ 3u32.rotate_right(34),
        ROLLED ^ NEGATIVE as u32,
        FRACTION.to_bits() ^ TINY.to_bits(),
        FLAGS[k] as u32 ^ (i32::MIN.wrapping_neg() as u32) ^ (-5i32 as u32 >> 28),
    ]
}

/// Literals whose last bit counts.
pub fn exact_literals(id: u32, ints: &[u32], _floats: &[f32]) -> [u32; 8] {
    let salt = uint(id, ints, 0);
    [
        0.1f32.to_bits() ^ salt,
        3.402_823_5e38f32.to_bits() ^ salt,
        1.175_494_4e-38f32.to_bits() ^ salt,
        16_777_217.0f32.to_bits() ^ salt,
        0.333_333_34f32.to_bits() ^ salt,
        (1.0f32 - 0.9).to_bits() ^ salt,
        core::f32::consts::PI.to_bits() ^ salt,
        1e-7f32.to_bits() ^ salt,
    ]
}

#[derive(Clone, Copy)]
struct Inner {
    v: Vec3,
    weight: u32,
}

#[derive(Clone, Copy)]
struct Outer {
    list: [Inner; 3],
    pair: (Counter, u32),
}

fn add(value: &mut f32, by: f32) {
    *value += by;
}

fn exchange(a: &mut u32, b: &mut u32) {
    let kept = *a;
    *a = *b;
    *b = kept;
}

/// `&mut` of components, columns, elements of fields, and of two fields at once.
pub fn deep_places(id: u32, ints: &[u32], floats: &[f32]) -> [f32; 8] {
    let inner = Inner {
        v: Vec3::splat(float(id, floats, 0)),
        weight: uint(id, ints, 0) & 0xFF,
    };
    let mut outer = Outer {
        list: [inner; 3],
        pair: (
            Counter {
                state: uint(id, ints, 1),
            },
            5,
        ),
    };
    let k = (uint(id, ints, 2) % 3) as usize;
    add(&mut outer.list[k].v.y, 1.5);
    add(&mut outer.list[0].v[k], 0.25);
    outer.list[k].v.z *= 2.0;
    outer.list[1].v[k] -= 1.0;
    bump(&mut outer.list[k].weight, 3);
    let drawn = outer.pair.0.next() & 0xFF;
    exchange(&mut outer.pair.0.state, &mut outer.pair.1);
    let mut m = Mat3::IDENTITY;
    add(&mut m.y_axis.x, outer.list[2].v.y);
    m.x_axis.z = 3.0;
    let mut v = Vec4::ZERO;
    add(&mut v.w, m.y_axis.x);
    let total = outer.list[0].v + outer.list[1].v + outer.list[2].v;
    [
        total.x,
        total.y,
        total.z,
        outer.list[k].weight as f32,
        drawn as f32,
        outer.pair.0.state as f32,
        v.w,
        m.x_axis.z + outer.list[k].v[k],
    ]
}

fn by_value(mut inner: Inner) -> f32 {
    inner.v.x += 10.0;
    inner.weight += 1;
    inner.v.x + inner.weight as f32
}

fn parts(Inner { v, weight }: Inner, (a, _): (f32, u32), _: u32) -> f32 {
    v.y + weight as f32 * a
}

/// Values are copied: into functions, out of them, between variables.
pub fn copies(id: u32, ints: &[u32], floats: &[f32]) -> [f32; 4] {
    let mut inner = Inner {
        v: Vec3::splat(float(id, floats, 0)),
        weight: uint(id, ints, 0) & 0xFF,
    };
    let kept = inner;
    let first = by_value(inner);
    inner.v.x = 3.0;
    let list = [inner, kept];
    inner.v.y = -7.0;
    let _ = by_value(list[0]);
    by_value(list[1]);
    [
        first,
        kept.v.x,
        list[0].v.y + list[0].v.x,
        parts(inner, (2.0, 1), 4),
    ]
}

fn hash_all(list: &[u32]) -> u32 {
    let mut h = list.len() as u32;
    for i in 0..list.len() {
        h = mix(h, list[i]);
    }
    h
}

fn minus(a: &[u32], b: &[u32]) -> u32 {
    hash_all(a).wrapping_sub(hash_all(b))
}

#[derive(Clone, Copy)]
struct Two<'a> {
    left: &'a [u32],
    right: &'a [u32],
}

impl<'a> Two<'a> {
    fn flipped(&self) -> Two<'a> {
        Two {
            left: self.right,
            right: self.left,
        }
    }

    fn difference(&self) -> u32 {
        minus(self.left, self.right)
    }
}

/// One function over slices of several buffers, and of several parts of one.
pub fn two_buffers(id: u32, a: &[u32], b: &[u32]) -> [u32; 4] {
    let k = id as usize % 8;
    let two = Two {
        left: &a[..k],
        right: &b[k..12],
    };
    [
        two.difference(),
        two.flipped().difference(),
        minus(&a[k..k + 2], &a[k + 1..k + 4]),
        minus(b, &a[2..][..k]),
    ]
}

/// Conditions, guards and short-circuits that change what they test.
pub fn guards(id: u32, ints: &[u32], _floats: &[f32]) -> [u32; 4] {
    let mut rng = Counter {
        state: uint(id, ints, 0),
    };
    let picked = match int(id, ints, 1) & 3 {
        0 if rng.next() & 1 == 0 => 1,
        0 | 1 if rng.next() & 1 == 0 => 2,
        n if rng.next() & 1 == n as u32 & 1 => 3,
        _ => rng.next() & 0xF,
    };
    let mut loops = 0;
    while rng.next() & 7 != 0 && loops < 9 {
        loops += 1;
        if rng.next() & 3 == 0 {
            continue;
        }
        rng.next();
    }
    let flagged = if let Some(n) = odd(rng.next())
        && n & 2 == 0
        && let Some(m) = odd(n)
    {
        m
    } else if rng.next() & 1 == 0 {
        5
    } else {
        rng.next()
    };
    [picked, loops, flagged, rng.state]
}
