//! Host file: light maps for tests.

use glam::{UVec2, Vec4};
use glimt_sampling::hash::hash3;

/// A map like noise, with a small sun.
#[must_use]
pub fn noise(size: UVec2, seed: u32) -> Vec<Vec4> {
    let texel = |i: u32| {
        let word = hash3(seed, i, 7);
        let part = |shift: u32| ((word >> shift) & 0xff) as f32 / 255.0;
        let sun = if i == size.x * size.y / 3 { 1e3 } else { 0.0 };
        Vec4::new(part(0) + sun, part(8) + sun, part(16) + 0.5 * sun, 1.0)
    };
    (0..size.x * size.y).map(texel).collect()
}
