//! Shared file: what each tile takes over from the frame before, and how many pilot rays it needs beside that.

use glam::{Mat4, Vec2, Vec4};
use glimt_light_cells::{QUADS, field};

use super::cell_state::{ENTRIES, Remembered, TILE_HEIGHT, TILE_WIDTH, TileEntry, slot_of};
use super::environment::Environment;
use super::expect::representative_of;
use super::frame::FrameParams;
use super::past::PastView;
use super::pilot::STEP;
use super::proposal::Expectation;
use super::scout::CellParams;

/// The share of the weights in cells that no ray has looked at above which a tile needs a whole pilot.
const IGNORANT: f32 = 0.4;

/// Finds for each entry of a tile the one of the frame before that holds its point's counts, and sets how many pilot rays its pixels send
/// out.
///
/// They are few where those counts tell enough: where `U = Σ w/(N + 1) / Σ w` over the cells is at most 0.4, for weights w of the cells
/// and counts N. U looks at earlier rays alone.
pub fn carry(
    _tile: u32,
    frame: &FrameParams,
    cells: &CellParams,
    view: &PastView,
    env: Environment<'_>,
    motions: &[Mat4],
    past_entries: &[TileEntry],
    past_counts: &[u32],
    entries: &mut [TileEntry],
) {
    for slot in 0..ENTRIES as usize {
        let entry = entries[slot];
        if entry.surface != 0 {
            let from = came_from(&entry, frame, cells, view, motions, past_entries);
            let remembered = Remembered {
                words: past_counts,
                from,
                turned: cells.turned,
            };
            let mut share = cells.pilot;
            if from > 0 && unknown(&entry, frame, env, &remembered) <= IGNORANT {
                share = cells.upkeep;
            }
            let rays = cells.rays * share * (STEP * STEP) as f32;
            entries[slot].from = from;
            entries[slot].pilots = if share > 0.0 { rays.max(1.0) as u32 } else { 0 };
        }
    }
}

/// [`TileEntry::from`] of an entry: by where its point was seen.
#[inline]
fn came_from(
    entry: &TileEntry,
    frame: &FrameParams,
    cells: &CellParams,
    view: &PastView,
    motions: &[Mat4],
    past_entries: &[TileEntry],
) -> u32 {
    if cells.has_past == 0 {
        return 0;
    }
    let motion = motions[(entry.surface - 1) as usize];
    let was_at = (motion * entry.position.extend(1.0)).truncate();
    let size = Vec2::new(frame.width as f32, frame.height as f32);
    let Some(seen) = view.project(was_at, size) else {
        return 0;
    };
    if !(seen.x >= 0.0 && seen.y >= 0.0 && seen.x < size.x && seen.y < size.y) {
        return 0;
    }
    let (column, row) = (seen.x as u32 / TILE_WIDTH, seen.y as u32 / TILE_HEIGHT);
    let first = (row * cells.tiles_across + column) * ENTRIES;
    let slot = slot_of(entry.surface, past_entries, first);
    if slot == 0 { 0 } else { first + slot }
}

/// U of an entry.
#[inline]
fn unknown(
    entry: &TileEntry,
    frame: &FrameParams,
    env: Environment<'_>,
    remembered: &Remembered<'_>,
) -> f32 {
    let light = env.cells();
    let surface = representative_of(entry, frame, env).surface;
    let mut all = 0.0;
    let mut unseen = 0.0;
    for quad in 0..QUADS {
        let flux = light.quad(field::FLUX, quad);
        let terms = light.terms(&surface, quad);
        let weights = surface.residual_weights(&terms, flux, remembered.quad(quad));
        all += weights.element_sum();
        unseen += (weights / (remembered.counts(quad).rays + Vec4::ONE)).element_sum();
    }
    // Where nothing is to be seen nothing is unknown.
    if all > 0.0 { unseen / all } else { 0.0 }
}
