//! Shared file: light by a control variate over cells of the light, whose visibility has been counted.

use super::cell_state::{ENTRIES, Expected, WORTHS};
use super::environment::Environment;
use super::expect::threshold;
use super::frame::FrameParams;
use super::product::shade_groups;
use super::scene::Scene;
use super::scout::CellParams;
use super::seen::SeenPoint;
use super::shade::RaySample;

/// What the camera rays of the tile's pixel `pixel` show: `points` are their hits, whose groups it finds.
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
