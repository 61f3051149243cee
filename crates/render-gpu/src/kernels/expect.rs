//! Shared file: from counts of rays to what is expected of the visibility of a light's cells, and to what a ray is worth.

use glam::Vec4;

use super::cell_state::{
    COUNT_WORDS, ENTRIES, Expected, NOTHING_KNOWN, TileEntry, VISIBILITY_WORDS, pack, quad_counts,
};
use super::environment::Environment;
use super::frame::FrameParams;
use super::groups::Representative;
use super::proposal::Proposal;
use super::scout::CellParams;

/// κ: how many rays of a tile its neighbours' are worth.
const NEIGHBOURS: f32 = 4.0;

/// Tiles that a tile looks at: itself and those around it.
const AROUND: u32 = 9;

/// The expected visibilities of the cells for the entries of tile `tile`:
/// `p̂ = (S + κ p⁰)/(N + κ)`, `p⁰ = (Σ S + ¾)/(Σ N + 1)` over the object's counts in the tiles around.
pub fn expect(
    tile: u32,
    cells: &CellParams,
    entries: &[TileEntry],
    counts: &[u32],
    visibility: &mut [u32],
) {
    for slot in 0..ENTRIES {
        let own = tile * ENTRIES + slot;
        let surface = entries[own as usize].surface;
        if surface != 0 {
            let mut near = [own; AROUND as usize];
            let mut found = 0;
            let (x, y) = (tile % cells.tiles_across, tile / cells.tiles_across);
            for i in 0..AROUND {
                // One more than the neighbour's column and row.
                let column = x + i % 3;
                let row = y + i / 3;
                let rows = cells.tiles / cells.tiles_across;
                if column > 0 && row > 0 && column <= cells.tiles_across && row <= rows {
                    let other = ((row - 1) * cells.tiles_across + column - 1) * ENTRIES;
                    for k in other..other + ENTRIES {
                        if entries[k as usize].surface == surface {
                            near[found as usize] = k;
                            found += 1;
                        }
                    }
                }
            }
            for word in 0..VISIBILITY_WORDS {
                // Of four cells.
                let mut n = Vec4::ZERO;
                let mut s = Vec4::ZERO;
                let mut all_n = Vec4::ONE;
                let mut all_s = Vec4::splat(NOTHING_KNOWN);
                for i in 0..found {
                    let entry = near[i as usize];
                    let at = (entry * COUNT_WORDS + 2 * word) as usize;
                    let of_entry = quad_counts(counts[at], counts[at + 1]);
                    all_n += of_entry.rays;
                    all_s += of_entry.arrived;
                    if entry == own {
                        n = of_entry.rays;
                        s = of_entry.arrived;
                    }
                }
                let prior = all_s / all_n;
                let expected = (s + prior * NEIGHBOURS) / (n + Vec4::splat(NEIGHBOURS));
                visibility[(slot * VISIBILITY_WORDS + word) as usize] = pack(expected);
            }
        }
    }
}

/// What an entry's point is to cells.
#[inline]
#[must_use]
pub fn representative_of(
    entry: &TileEntry,
    frame: &FrameParams,
    env: Environment<'_>,
) -> Representative {
    let wo = (frame.eye - entry.position).normalize();
    Representative::alone(
        entry.normal,
        wo,
        entry.diffuse,
        entry.specular,
        entry.exponent,
        env,
    )
}

/// What the rays of tile `tile` are worth in all: the sum over its pixels of the standard deviation that the control variate leaves.
#[must_use]
pub fn worth(
    tile: u32,
    frame: &FrameParams,
    env: Environment<'_>,
    entries: &[TileEntry],
    visibility: &[u32],
) -> f32 {
    let light = env.cells();
    let mut sum = 0.0;
    for slot in 0..ENTRIES {
        let entry = entries[(tile * ENTRIES + slot) as usize];
        if entry.surface != 0 {
            let expected = Expected {
                words: visibility,
                first: tile * ENTRIES,
                slot: slot + 1,
            };
            let of = representative_of(&entry, frame, env);
            let proposal = Proposal::new(&of, &light, &expected, entry.catcher != 0);
            sum += entry.hits as f32 * (proposal.total + proposal.lobe_worth);
        }
    }
    sum
}

/// Part `part` of the sum over all tiles: every [`WORTHS`](super::cell_state::WORTHS)-th of them.
#[must_use]
pub fn add_worths(part: u32, cells: &CellParams, parts: u32, worths: &[f32]) -> u32 {
    let mut sum = 0.0;
    for i in 0..cells.tiles.div_ceil(parts) {
        let tile = i * parts + part;
        if tile < cells.tiles {
            sum += worths[tile as usize];
        }
    }
    sum.to_bits()
}

/// τ, the worth of one ray, of the parts behind the visibilities of all tiles; 0 where all groups of equal size get equally many.
#[inline]
#[must_use]
pub fn threshold(frame: &FrameParams, cells: &CellParams, parts: u32, visibility: &[u32]) -> f32 {
    if cells.is_adaptive == 0 {
        return 0.0;
    }
    let behind = cells.tiles * ENTRIES * VISIBILITY_WORDS;
    let mut sum = 0.0;
    for part in 0..parts {
        sum += f32::from_bits(visibility[(behind + part) as usize]);
    }
    sum / ((frame.width * frame.height) as f32 * cells.rays)
}
