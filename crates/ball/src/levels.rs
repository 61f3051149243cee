//! Host file: how bright a frame's ball is, in cells, so that a frame of another exposure is told from changed light.

use crate::circle::Circle;
use crate::plane::Pyramid;
use glam::{DVec2, UVec2, Vec4};
use std::f64::consts::TAU;

const RINGS: usize = 4;
const SECTORS: usize = 16;

/// Mean log₂ luminance in 64 cells of the ball, from the rig's edge almost to the rim; `None` where a cell is black.
#[derive(Clone, Debug, PartialEq)]
pub struct Levels {
    cells: Vec<Option<f32>>,
}

/// How one frame's brightness differs from another's.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Change {
    /// Median difference over the cells, in stops.
    pub stops: f64,
    /// Median deviation from that, in stops: small where all cells changed by the same factor.
    pub spread: f64,
}

impl Change {
    /// Whether all cells changed by one factor, which lets it be another exposure.
    #[must_use]
    pub fn is_uniform(self) -> bool {
        self.spread < 0.05 + 0.1 * self.stops.abs()
    }

    /// Whether it is a step that another exposure makes.
    #[must_use]
    pub fn is_step(self) -> bool {
        self.stops.abs() > 0.15 && self.is_uniform()
    }
}

impl Levels {
    /// The levels of the ball `circle` in an image, rows from the top. Cells outside the image are `None`, and all of them
    /// where `pixels` does not fit `size`.
    #[must_use]
    pub fn new(size: UVec2, pixels: &[Vec4], circle: Circle) -> Self {
        if pixels.len() as u64 != u64::from(size.x) * u64::from(size.y) || pixels.is_empty() {
            let cells = vec![None; RINGS * SECTORS];
            return Self { cells };
        }
        Self::of(&Pyramid::new(size, pixels), circle)
    }

    pub(crate) fn of(pyramid: &Pyramid, circle: Circle) -> Self {
        let (plane, circle) = pyramid.at_radius(circle, 120.0);
        let (w, h) = (plane.width as f64, plane.height as f64);
        let cell = |index: usize| {
            let (ring, sector) = (index / SECTORS, index % SECTORS);
            let (mut sum, mut n) = (0.0, 0);
            for k in 0..64 {
                let (u, v) = (f64::from(k / 8) + 0.5, f64::from(k % 8) + 0.5);
                let r = 0.3 + 0.6 * (ring as f64 + u / 8.0) / RINGS as f64;
                let angle = TAU * (sector as f64 + v / 8.0) / SECTORS as f64;
                let p = circle.centre + circle.radius * r * DVec2::new(angle.cos(), angle.sin());
                if !(p.x >= 0.0 && p.y >= 0.0 && p.x < w && p.y < h) {
                    return None;
                }
                let value = plane.at(p.x, p.y);
                if value > 0.0 {
                    sum += value.log2();
                    n += 1;
                }
            }
            (n >= 32).then(|| sum / n as f32)
        };
        Self {
            cells: (0..RINGS * SECTORS).map(cell).collect(),
        }
    }

    /// What changed from `before` to this; `None` where fewer than 16 cells can be compared.
    #[must_use]
    pub fn change_from(&self, before: &Self) -> Option<Change> {
        let mut differences: Vec<f64> = self
            .cells
            .iter()
            .zip(&before.cells)
            .filter_map(|(a, b)| Some(f64::from((*a)? - (*b)?)))
            .collect();
        if differences.len() < 16 {
            return None;
        }
        let stops = median(&mut differences);
        let mut off: Vec<f64> = differences.iter().map(|d| (d - stops).abs()).collect();
        let spread = median(&mut off);
        Some(Change { stops, spread })
    }
}

/// The middle of the values, the upper one of two. They must not be empty.
pub(crate) fn median(values: &mut [f64]) -> f64 {
    let middle = values.len() / 2;
    *values.select_nth_unstable_by(middle, f64::total_cmp).1
}
