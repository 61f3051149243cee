//! Shared file: light by a control variate over cells of the light, whose visibility has been counted.

use super::cell_state::{COUNT_WORDS, ENTRIES, Expected, TILE_HEIGHT, WORTHS, cap, count};
use super::environment::Environment;
use super::expect::threshold;
use super::frame::FrameParams;
use super::product::shade_groups;
use super::scene::Scene;
use super::scout::{CellParams, tile_end};
use super::seen::SeenPoint;
use super::shade::RaySample;

/// What the camera rays of the tile's pixel `pixel` show: `points` are their hits, whose groups it finds, and keep what its shadow rays
/// find.
///
/// `L̂ = Γ + Σ (f_k V_k − g + p̂ (f̄ − f_k)) L/(D q)` over a group's samples, each for a member k drawn evenly: g is near the integrand
/// `f V L` of the group's mean, and Γ its integral, exactly. p̂, q and the number of samples depend on earlier rays alone, so the mean is
/// that of the integral.
pub fn shade_cells<S: RaySample>(
    pixel: u32,
    frame: &FrameParams,
    cells: &CellParams,
    env: Environment<'_>,
    scene: Scene<'_>,
    visibility: &[u32],
    points: &mut [SeenPoint],
    samples: &mut [S],
) {
    let tile = cells.tile_of(frame.first_pixel + pixel, frame);
    let expected = Expected {
        words: visibility,
        first: tile * ENTRIES,
        slot: 0,
    };
    let worth = threshold(frame, cells, WORTHS, visibility);
    shade_groups(
        pixel, frame, cells.rays, worth, &expected, env, scene, points, samples,
    );
}

/// Adds what the shadow rays of an image tile have found to the counts of its entries. `tile` counts from the first of the rows of pixels
/// that `points` are of.
pub fn gather_cells(
    tile: u32,
    frame: &FrameParams,
    cells: &CellParams,
    points: &[SeenPoint],
    counts: &mut [u32],
) {
    let first_row = frame.first_pixel / frame.width;
    let corner = cells.corner(first_row / TILE_HEIGHT * cells.tiles_across + tile);
    let end = tile_end(corner, frame);
    for y in corner.y..end.y {
        for x in corner.x..end.x {
            let pixel = (y - first_row) * frame.width + x;
            let first = pixel * frame.rays_per_pixel;
            for ray in first..first + frame.rays_per_pixel {
                let word = points[ray as usize].record;
                let slot = points[ray as usize].slot();
                if word != 0 && slot > 0 {
                    let base = (slot - 1) * COUNT_WORDS;
                    for half in 0..2 {
                        let found = word >> (16 * half);
                        if found & 0x8000 != 0 {
                            let cell = found & 0x1ff;
                            let at = (base + cell / 2) as usize;
                            counts[at] = count(counts[at], cell, found & 0x4000 != 0);
                        }
                    }
                }
            }
        }
    }
    for i in 0..(ENTRIES * COUNT_WORDS) as usize {
        counts[i] = cap(counts[i]);
    }
}
