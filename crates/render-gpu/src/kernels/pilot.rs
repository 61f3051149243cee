//! Shared file: pilot rays, which count what arrives of each cell of the light before a frame is rendered.

use glimt_probe::rotate::rotate_z;
use glimt_sampling::math::luminance;
use glimt_sampling::uniform::UniformSource;

use super::cell_state::{COUNT_WORDS, ENTRIES, TileEntry, count, slot_of};
use super::environment::Environment;
use super::frame::FrameParams;
use super::groups::Representative;
use super::pattern::{PILOT, PILOT_THROUGH};
use super::proposal::Proposal;
use super::scene::Scene;
use super::scout::{CellParams, tile_end};
use super::seen::{SeenPoint, see_by};

/// Pixels from one that sends out pilot rays to the next, across and down.
pub const STEP: u32 = 2;

/// Pixels of a tile that may send some out, rounded up to a power of two, and the bits of their numbers.
const PLACES: u32 = 64;
const PLACE_BITS: u32 = 6;

/// Takes over what the counts of the frame before tell of the entries of tile `tile` of the image, which begins at pixel 0, and adds the
/// tile's pilot rays to them.
///
/// The estimate may look at these counts, as their random words have a key of their own, and no pilot ray is shown.
pub fn pilot(
    tile: u32,
    frame: &FrameParams,
    cells: &CellParams,
    env: Environment<'_>,
    scene: Scene<'_>,
    entries: &[TileEntry],
    past_counts: &[u32],
    counts: &mut [u32],
) {
    let first = tile * ENTRIES;
    for slot in 0..ENTRIES {
        let remembered = entries[(first + slot) as usize].remembered(past_counts, cells.turned);
        for word in 0..COUNT_WORDS {
            counts[(slot * COUNT_WORDS + word) as usize] = remembered.word(word);
        }
    }
    let corner = cells.corner(tile);
    let end = tile_end(corner, frame);
    let columns = (end.x - corner.x).div_ceil(STEP);
    let rows = (end.y - corner.y).div_ceil(STEP);
    let light = env.cells();
    for i in 0..PLACES {
        // A count that is full forgets, so the last rays must come from all of the tile.
        let place = i.reverse_bits() >> (32 - PLACE_BITS);
        let pixel =
            (corner.y + place / columns * STEP) * frame.width + corner.x + place % columns * STEP;
        let pattern = frame.pattern_at(pixel, 0);
        let mut seen = SeenPoint::NONE;
        if place < columns * rows {
            seen = see_by(&pattern, frame, scene);
        }
        let slot = slot_of(seen.surface, entries, first);
        if seen.is_hit() && slot > 0 {
            let entry = entries[(first + slot - 1) as usize];
            let base = (slot - 1) * COUNT_WORDS;
            let remembered = entry.remembered(past_counts, cells.turned);
            let point = seen.shading_point();
            let of = Representative::alone(
                seen.normal,
                seen.wo,
                luminance(seen.diffuse),
                luminance(seen.specular),
                seen.exponent,
                env,
            );
            let proposal = Proposal::new(&of, &light, &remembered, seen.is_catcher());
            let key = pattern.ray_key(PILOT_THROUGH);
            let rays = if proposal.total > 0.0 {
                entry.pilots
            } else {
                0
            };
            for s in 0..rays {
                let u = pattern.point(PILOT, s).next_uvec2();
                let drawn = proposal.sample_cells(u, &light, &remembered);
                let direction = rotate_z(drawn.direction, env.rotation);
                if point.frame.n.dot(direction) > 0.0 && point.geometric_normal.dot(direction) > 0.0
                {
                    let arrives = scene.is_lit(&point, direction, key.wrapping_add(s));
                    let at = (base + drawn.cell / 2) as usize;
                    counts[at] = count(counts[at], drawn.cell, arrives);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kernels::cell_state::{TILE_HEIGHT, TILE_WIDTH};

    #[test]
    fn all_pixels_have_a_place() {
        let pixels = TILE_WIDTH.div_ceil(STEP) * TILE_HEIGHT.div_ceil(STEP);
        assert!(pixels <= PLACES && PLACES == 1 << PLACE_BITS);
    }
}
