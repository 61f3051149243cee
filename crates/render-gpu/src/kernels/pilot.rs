//! Shared file: pilot rays, which count what arrives of each cell of the light before a frame is rendered.

use glimt_light_cells::CellSurface;
use glimt_probe::rotate::rotate_z;
use glimt_sampling::math::luminance;
use glimt_sampling::uniform::UniformSource;

use super::cell_state::{COUNT_WORDS, ENTRIES, Even, TileEntry, count, slot_of};
use super::environment::Environment;
use super::frame::FrameParams;
use super::groups::Representative;
use super::pattern::{PILOT, PILOT_THROUGH};
use super::proposal::Proposal;
use super::scene::Scene;
use super::scout::{CellParams, tile_end};
use super::seen::{SeenPoint, see_by};

/// Pixels from one that sends out pilot rays to the next, across and down.
const STEP: u32 = 2;

/// What one hit is to cells.
#[inline]
fn alone(point: &SeenPoint, env: Environment<'_>) -> Representative {
    Representative {
        mean_normal: env.to_map(point.normal),
        diffuse: point.diffuse,
        specular: point.specular,
        surface: CellSurface::new(
            env.to_map(point.normal),
            env.to_map(point.wo),
            luminance(point.diffuse),
            luminance(point.specular),
            point.exponent,
            1.0,
            0.0,
        ),
    }
}

/// Sends out the pilot rays of tile `tile` of the image, which begins at pixel 0, and adds them to the counts of its entries.
///
/// The estimate may look at these counts, as their random words have a key of their own, and no pilot ray is shown.
pub fn pilot(
    tile: u32,
    frame: &FrameParams,
    cells: &CellParams,
    env: Environment<'_>,
    scene: Scene<'_>,
    entries: &[TileEntry],
    counts: &mut [u32],
) {
    let corner = cells.corner(tile);
    let end = tile_end(corner, frame);
    let first = tile * ENTRIES;
    let rays = (cells.rays * cells.pilot * (STEP * STEP) as f32).max(1.0) as u32;
    let light = env.cells();
    for row in 0..(end.y - corner.y).div_ceil(STEP) {
        for column in 0..(end.x - corner.x).div_ceil(STEP) {
            let pixel = (corner.y + STEP * row) * frame.width + corner.x + STEP * column;
            let pattern = frame.pattern_at(pixel, 0);
            let seen = see_by(&pattern, frame, scene);
            let slot = slot_of(seen.surface, entries, first);
            if seen.is_hit() && slot > 0 {
                let base = (slot - 1) * COUNT_WORDS;
                let point = seen.shading_point();
                let proposal = Proposal::new(&alone(&seen, env), &light, &Even, seen.is_catcher());
                let key = pattern.ray_key(PILOT_THROUGH);
                let own = if proposal.total > 0.0 { rays } else { 0 };
                for s in 0..own {
                    let u = pattern.point(PILOT, s).next_uvec2();
                    let drawn = proposal.sample_cells(u, &light, &Even);
                    let direction = rotate_z(drawn.direction, env.rotation);
                    if point.frame.n.dot(direction) > 0.0
                        && point.geometric_normal.dot(direction) > 0.0
                    {
                        let arrives = scene.is_lit(&point, direction, key.wrapping_add(s));
                        let at = (base + drawn.cell / 2) as usize;
                        counts[at] = count(counts[at], drawn.cell, arrives);
                    }
                }
            }
        }
    }
}
