//! Shared file: kernels that fill a chunk of their own.

use super::input::{Counter, float, uint};
use glam::Vec4;

/// Fills its chunk, which it also reads back.
pub fn fill(id: u32, ints: &[u32], _floats: &[f32], chunk: &mut [u32]) {
    let mut rng = Counter {
        state: uint(id, ints, 0),
    };
    for i in 0..chunk.len() {
        chunk[i] = rng.next();
    }
    for i in 1..chunk.len() {
        chunk[i] ^= chunk[i - 1] >> 1;
    }
    let last = chunk.len() - 1;
    chunk[last] = chunk[last].wrapping_add(id);
}

/// Changes what its chunk holds, through functions, and returns a value.
pub fn update(id: u32, ints: &[u32], floats: &[f32], particles: &mut [Vec4]) -> u32 {
    let mut moved = 0;
    for i in 0..particles.len() {
        let old = particles[i];
        particles[i] = old * 0.5 + Vec4::splat(float(id, floats, i as u32 % 8));
        particles[i].w = id as f32;
        if old.x > 0.0 {
            moved += 1;
        }
    }
    push(particles, uint(id, ints, 0) & 3);
    moved
}

fn push(particles: &mut [Vec4], by: u32) {
    nudge(&mut particles[0], by as f32);
}

fn nudge(particle: &mut Vec4, by: f32) {
    particle.y += by;
}

/// Two chunks of unlike lengths, and a result.
pub fn two(id: u32, ints: &[u32], _floats: &[f32], small: &mut [u32], large: &mut [i32]) -> f32 {
    if uint(id, ints, 0) % 5 == 0 {
        return -1.0;
    }
    for i in 0..large.len() {
        let from = small[i % small.len()];
        large[i] = from as i32 - i as i32;
    }
    small[0] = large.len() as u32;
    id as f32 * 0.5
}
