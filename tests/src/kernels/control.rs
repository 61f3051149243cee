//! Shared file: loops, blocks, early returns, shadowing.

use super::input::uint;

fn first_divisor(n: u32) -> u32 {
    if n < 2 {
        return 0;
    }
    for d in 2..n {
        if n % d == 0 {
            return d;
        }
    }
    n
}

fn search(a: u32, b: u32) -> u32 {
    for i in 0..10 {
        let mut j = 0;
        while j < 10 {
            if i * j == a {
                return i * 100 + j;
            }
            if (i + j) % 7 == b {
                j += 3;
                continue;
            }
            if i * j > a {
                break;
            }
            j += 1;
        }
        if i == b {
            break;
        }
    }
    9999
}

/// Returns from inside loops, nested loops, `break` and `continue`.
pub fn returns(id: u32, ints: &[u32], _floats: &[f32]) -> [u32; 4] {
    let (a, b) = (uint(id, ints, 0) % 90, uint(id, ints, 1) % 10);
    if a == 13 {
        return [13; 4];
    }
    [first_divisor(a), search(a, b), collatz(a + 1), deep(a, b)]
}

fn collatz(mut n: u32) -> u32 {
    let mut steps = 0;
    loop {
        if n == 1 {
            break steps;
        }
        n = if n % 2 == 0 { n / 2 } else { 3 * n + 1 };
        steps += 1;
    }
}

fn deep(a: u32, b: u32) -> u32 {
    let mut count = 0;
    loop {
        loop {
            count += 1;
            if count % 3 == b % 3 {
                break;
            }
            if count > a {
                return count;
            }
        }
        if count > 2 * a {
            return count + 500;
        }
    }
}

/// `for` over every kind of range: inclusive, empty, reversed bounds, up to the largest number.
pub fn ranges(id: u32, ints: &[u32], _floats: &[f32]) -> [u32; 6] {
    let (a, b) = (uint(id, ints, 0) % 20, uint(id, ints, 1) % 20);
    let mut sums = [0u32; 6];
    for i in a..b {
        sums[0] += i;
    }
    for i in a..=b {
        sums[1] += i + 1;
    }
    for i in -3..(b as i32 - 5) {
        sums[2] = sums[2].wrapping_add(i as u32);
    }
    for i in u32::MAX - 2..=u32::MAX {
        sums[3] = sums[3].wrapping_add(i ^ a);
    }
    for _ in 0..a {
        sums[4] += 1;
    }
    let mut end = b;
    for i in 0..end {
        // The range was made before the loop began.
        end = a;
        sums[5] += i + end;
    }
    sums
}

/// Blocks and `if` as values, shadowing, a variable assigned later.
pub fn values(id: u32, ints: &[u32], _floats: &[f32]) -> [u32; 6] {
    let x = uint(id, ints, 0);
    let y = {
        let x = x ^ 5;
        let x = x.rotate_left(3);
        x.wrapping_add(1)
    };
    let later;
    if x % 3 == 0 {
        later = y;
    } else if x % 3 == 1 {
        later = 1;
    } else {
        later = x ^ y;
    }
    let chosen = if x > y {
        x
    } else if x == y {
        0
    } else {
        y
    };
    let through: u32;
    {
        through = chosen ^ later;
    }
    let from_loop = loop {
        if x & 1 == 0 {
            break 5;
        }
        break x;
    };
    let x = if let 0..=1000 = x { x + 1 } else { 7 };
    [y, later, chosen, through, from_loop, x]
}

/// A loop that changes what its condition reads, and a condition that calls.
pub fn conditions(id: u32, ints: &[u32], _floats: &[f32]) -> [u32; 2] {
    let mut n = uint(id, ints, 0) % 1000;
    let mut calls = 0;
    while more(&mut n, &mut calls) && calls < 40 {
        calls += 1;
    }
    let mut m = n;
    while {
        m += 3;
        m % 5 != 0
    } {
        calls += 100;
    }
    [calls, m]
}

fn more(n: &mut u32, calls: &mut u32) -> bool {
    *n /= 2;
    *calls += 1;
    *n > 3
}
