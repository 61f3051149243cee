//! Host file: how far a frame's ball image is turned against another's.
//!
//! Both are sampled in rings between the camera's own reflection in the middle and the rim. Each ring's logarithms of
//! luminance lose their slow part, which is where changed light shows most, and are limited. All turns are tried on coarse
//! rings; from the best one Gauss-Newton steps on fine rings find the turn to a fraction of a pixel's angle, together with
//! a small shift, since the centre is not known exactly. Pixels that differ much, where the light changed, hardly count.

use crate::circle::Circle;
use crate::plane::{Plane, Pyramid};
use glam::{DMat3, DVec3, UVec2, Vec4};
use rayon::prelude::*;
use std::f64::consts::{PI, TAU};

/// A frame's turn against the reference.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Roll {
    /// Angle in radians, in (−π, π]; positive from +x towards +y, clockwise on a screen.
    pub radians: f64,
    /// Its standard error in radians.
    pub sigma: f64,
    /// Correlation of the two images where they are laid on one another, in [0, 1].
    pub confidence: f64,
}

/// Radii of the rings over the ball's.
const RADII: [f64; 2] = [0.36, 0.9];
/// Rings and samples around each, for all turns.
const COARSE: [usize; 2] = [12, 360];
/// Rings of the fine image.
const RINGS: usize = 40;
/// Least correlation.
const CONFIDENT: f64 = 0.3;
/// Most Gauss-Newton steps.
const ROUNDS: usize = 30;
/// Largest standard error in radians that is a result: half a degree.
const LARGEST_SIGMA: f64 = 0.009;
/// The slow part of a ring is its mean over this share of the circle to either side.
const SLOW: f64 = 0.06;

/// Rings of one frame, by which others are compared with it.
#[derive(Clone, Debug)]
pub struct Reference {
    coarse: Rings,
    fine: Rings,
}

/// Values of rings: `rings` rows of `count` samples.
#[derive(Clone, Debug)]
struct Rings {
    rings: usize,
    count: usize,
    values: Vec<f32>,
}

impl Reference {
    /// Takes the ball `circle` of an image as the reference; rows from the top. `None` where `pixels` does not fit `size`,
    /// the rings leave the image, or they show nothing but one colour.
    #[must_use]
    pub fn new(size: UVec2, pixels: &[Vec4], circle: Circle) -> Option<Self> {
        if pixels.len() as u64 != u64::from(size.x) * u64::from(size.y) {
            return None;
        }
        Self::of(&Pyramid::new(size, pixels), circle)
    }

    pub(crate) fn of(pyramid: &Pyramid, circle: Circle) -> Option<Self> {
        if !(circle.radius >= 10.0) || !circle.centre.is_finite() {
            return None;
        }
        let (coarse, small) = pyramid.at_radius(circle, 70.0);
        let (fine, large) = pyramid.at_radius(circle, 450.0);
        let count = ((TAU * large.radius) as usize).clamp(360, 2880);
        let reference = Self {
            coarse: Rings::new(coarse, small, COARSE[0], COARSE[1])?,
            fine: Rings::new(fine, large, RINGS, count)?,
        };
        let energy: f32 = reference.fine.values.iter().map(|v| v * v).sum();
        // Standard deviation of the logarithm; below it there is only noise.
        (energy > 1e-5 * reference.fine.values.len() as f32).then_some(reference)
    }

    /// How far the ball `circle` of another image is turned against this one. `None` where [`Reference::new`] would be, or
    /// where the two have too little in common: a correlation below 0.3, steps that do not settle, or a standard error above half a degree.
    #[must_use]
    pub fn roll(&self, size: UVec2, pixels: &[Vec4], circle: Circle) -> Option<Roll> {
        self.roll_of(&Self::new(size, pixels, circle)?)
    }

    /// [`Reference::roll`] of a frame that was made a reference itself.
    #[must_use]
    pub fn roll_of(&self, frame: &Self) -> Option<Roll> {
        let start = coarse_turn(&self.coarse, &frame.coarse);
        fine_turn(&self.fine, &frame.fine, start)
    }
}

impl Rings {
    fn new(plane: &Plane, circle: Circle, rings: usize, count: usize) -> Option<Self> {
        let outer = circle.radius * RADII[1];
        let c = circle.centre;
        let inside = c.x - outer >= 0.0
            && c.y - outer >= 0.0
            && c.x + outer <= plane.width as f64
            && c.y + outer <= plane.height as f64;
        if !inside || plane.width < 2 || plane.height < 2 {
            return None;
        }
        let rows: Vec<Vec<f32>> = (0..rings)
            .into_par_iter()
            .map(|ring| {
                let r = circle.radius * radius(ring, rings);
                let mut row: Vec<f32> = (0..count)
                    .map(|k| {
                        let angle = TAU * k as f64 / count as f64;
                        plane.at(c.x + r * angle.cos(), c.y + r * angle.sin())
                    })
                    .collect();
                let mean = row.iter().sum::<f32>() / count as f32;
                let floor = (0.02 * mean).max(f32::MIN_POSITIVE);
                for value in &mut row {
                    *value = (*value + floor).ln();
                }
                without_slow_part(&row)
            })
            .collect();
        Some(Self {
            rings,
            count,
            values: rows.concat(),
        })
    }

    fn row(&self, ring: usize) -> &[f32] {
        &self.values[ring * self.count..(ring + 1) * self.count]
    }

    /// Value and slope per sample at a place of a ring, by Catmull-Rom.
    fn at(&self, ring: usize, place: f64) -> (f64, f64) {
        let row = self.row(ring);
        let base = place.floor();
        let f = place - base;
        let n = self.count as i64;
        let p = |k: i64| f64::from(row[(base as i64 + k).rem_euclid(n) as usize]);
        let (a, b, c, d) = (p(-1), p(0), p(1), p(2));
        let (k1, k2, k3) = (
            0.5 * (c - a),
            0.5 * (2.0 * a - 5.0 * b + 4.0 * c - d),
            0.5 * (3.0 * (b - c) + d - a),
        );
        (
            b + f * (k1 + f * (k2 + f * k3)),
            k1 + f * (2.0 * k2 + f * 3.0 * k3),
        )
    }
}

/// Radius of a ring over the ball's.
fn radius(ring: usize, rings: usize) -> f64 {
    RADII[0] + (RADII[1] - RADII[0]) * (ring as f64 + 0.5) / rings as f64
}

/// A ring less its own mean over a window, limited to ±1.5.
fn without_slow_part(row: &[f32]) -> Vec<f32> {
    let n = row.len();
    let half = (SLOW * n as f64) as usize;
    let width = (2 * half + 1) as f64;
    let mut sum: f64 = (0..=2 * half)
        .map(|k| f64::from(row[(n + k - half) % n]))
        .sum();
    (0..n)
        .map(|k| {
            let value = f64::from(row[k]) - sum / width;
            sum += f64::from(row[(k + half + 1) % n]) - f64::from(row[(n + k - half) % n]);
            value.clamp(-1.5, 1.5) as f32
        })
        .collect()
}

/// The turn in radians for which the coarse rings correlate best.
fn coarse_turn(a: &Rings, b: &Rings) -> f64 {
    let n = a.count;
    let scores: Vec<f32> = (0..n)
        .into_par_iter()
        .map(|shift| {
            (0..a.rings)
                .map(|ring| {
                    let (a, b) = (a.row(ring), b.row(ring));
                    let head: f32 = a[..n - shift]
                        .iter()
                        .zip(&b[shift..])
                        .map(|(x, y)| x * y)
                        .sum();
                    let tail: f32 = a[n - shift..]
                        .iter()
                        .zip(&b[..shift])
                        .map(|(x, y)| x * y)
                        .sum();
                    head + tail
                })
                .sum()
        })
        .collect();
    let best = (0..n).fold(0, |i, j| if scores[j] > scores[i] { j } else { i });
    let (left, at, right) = (
        f64::from(scores[(best + n - 1) % n]),
        f64::from(scores[best]),
        f64::from(scores[(best + 1) % n]),
    );
    let bend = left - 2.0 * at + right;
    let off = if bend < 0.0 {
        (0.5 * (left - right) / bend).clamp(-0.5, 0.5)
    } else {
        0.0
    };
    TAU * (best as f64 + off) / n as f64
}

/// Gauss-Newton for turn and shift from a turn in radians.
fn fine_turn(a: &Rings, b: &Rings, start: f64) -> Option<Roll> {
    let per_radian = a.count as f64 / TAU;
    let mut unknowns = DVec3::new(start, 0.0, 0.0);
    let mut last = None;
    let mut settled = false;
    for round in 0..ROUNDS {
        // The limit falls, so that at first everything is heard.
        let limit = [1.5, 0.8, 0.5, 0.35].get(round).copied().unwrap_or(0.3);
        let normal = normal_equations(a, b, unknowns, per_radian, limit);
        let step = normal.solve()?;
        unknowns += step;
        if unknowns.truncate().is_nan() || (unknowns.x - start).abs() > 0.1 {
            return None;
        }
        unknowns.y = unknowns.y.clamp(-0.03, 0.03);
        unknowns.z = unknowns.z.clamp(-0.03, 0.03);
        last = Some(normal);
        settled = step.x.abs() < 1e-5;
        if round > 4 && step.x.abs() < 1e-6 {
            break;
        }
    }
    let normal = last.filter(|_| settled)?;
    let sigma = normal.sigma()?;
    let confidence = normal.correlation();
    let mut radians = unknowns.x.rem_euclid(TAU);
    if radians > PI {
        radians -= TAU;
    }
    (confidence >= CONFIDENT && sigma <= LARGEST_SIGMA).then_some(Roll {
        radians,
        sigma,
        confidence,
    })
}

/// Sums over all samples.
#[derive(Clone, Copy, Default)]
struct Normal {
    matrix: DMat3,
    right: DVec3,
    weight: f64,
    squares: f64,
    aa: f64,
    ab: f64,
    bb: f64,
}

/// The sum of `weight · (b(at the turned, shifted place) − a)²`, linearised. The shift is over the ball's radius.
fn normal_equations(a: &Rings, b: &Rings, at: DVec3, per_radian: f64, limit: f64) -> Normal {
    let rings: Vec<Normal> = (1..a.rings - 1)
        .into_par_iter()
        .map(|ring| {
            let mut normal = Normal {
                matrix: DMat3::ZERO,
                ..Normal::default()
            };
            let r = radius(ring, a.rings);
            let per_ring = a.rings as f64 / (RADII[1] - RADII[0]);
            let row = a.row(ring);
            for (k, value) in row.iter().enumerate() {
                let angle = k as f64 / per_radian + at.x;
                let (sin, cos) = angle.sin_cos();
                // Where the shift takes a sample: along the ring, and to other rings.
                let along = (-sin * at.y + cos * at.z) / r;
                let across = (cos * at.y + sin * at.z) * per_ring;
                let place = (angle + along) * per_radian;
                let (here, slope) = b.at(ring, place);
                let (up, down) = (b.at(ring + 1, place).0, b.at(ring - 1, place).0);
                let outward = 0.5 * (up - down);
                let value_b = here + outward * across.clamp(-1.0, 1.0);
                let difference = value_b - f64::from(*value);
                let weight = 1.0 / (1.0 + (difference / limit).powi(2)).powi(2);
                let g_angle = slope * per_radian;
                let gradient = DVec3::new(
                    g_angle,
                    -g_angle * sin / r + outward * per_ring * cos,
                    g_angle * cos / r + outward * per_ring * sin,
                );
                let g = gradient * weight;
                normal.matrix += DMat3::from_cols(g * gradient.x, g * gradient.y, g * gradient.z);
                normal.right -= g * difference;
                normal.weight += weight;
                normal.squares += weight * difference * difference;
                normal.aa += weight * f64::from(*value).powi(2);
                normal.ab += weight * f64::from(*value) * value_b;
                normal.bb += weight * value_b * value_b;
            }
            normal
        })
        .collect();
    // In a fixed order: the same bits on any number of threads.
    rings.into_iter().fold(
        Normal {
            matrix: DMat3::ZERO,
            ..Normal::default()
        },
        |mut sum, n| {
            sum.matrix += n.matrix;
            sum.right += n.right;
            sum.weight += n.weight;
            sum.squares += n.squares;
            sum.aa += n.aa;
            sum.ab += n.ab;
            sum.bb += n.bb;
            sum
        },
    )
}

impl Normal {
    fn damped(&self) -> DMat3 {
        let trace = self.matrix.x_axis.x + self.matrix.y_axis.y + self.matrix.z_axis.z;
        self.matrix + DMat3::from_diagonal(DVec3::splat(1e-9 * trace))
    }

    fn solve(&self) -> Option<DVec3> {
        let matrix = self.damped();
        (matrix.determinant() > 0.0 && self.weight > 0.0).then(|| matrix.inverse() * self.right)
    }

    /// Standard error of the turn; neighbouring samples share their noise, four to one.
    fn sigma(&self) -> Option<f64> {
        let matrix = self.damped();
        let variance = 4.0 * self.squares / self.weight;
        let sigma = (matrix.inverse().x_axis.x * variance).sqrt();
        sigma.is_finite().then_some(sigma)
    }

    fn correlation(&self) -> f64 {
        let scale = (self.aa * self.bb).sqrt();
        if scale > 0.0 {
            (self.ab / scale).max(0.0)
        } else {
            0.0
        }
    }
}
