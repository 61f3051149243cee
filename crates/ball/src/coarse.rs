//! Host file: circles that a reduced image may hold: edges vote along their gradient for centres and radii.
//!
//! The votes are on the logarithm of the luminance and saturate, so that a lamp's outline counts no more than a rim that is
//! hardly darker than what surrounds it. An edge votes on both of its sides: the ball may be the brighter or the darker one.

use crate::circle::Circle;
use crate::plane::Plane;
use glam::DVec2;
use rayon::prelude::*;
use std::f64::consts::TAU;

/// An edge pixel: where it is, the direction of its gradient, and its weight in [0, 1].
#[derive(Clone, Copy)]
struct Edge {
    at: DVec2,
    along: DVec2,
    weight: f64,
}

/// Width of a cell of centres and radii in pixels.
const CELL: f64 = 2.0;
/// Radii that are looked for, over the shorter side of the image.
const RADII: [f64; 2] = [0.05, 0.75];
/// Centres are looked for this far outside of the image, over its sides.
const MARGIN: f64 = 0.25;

/// Candidates, the best first, with the share of the outline that has edges: at most `count`, none much like another.
pub(crate) fn candidates(plane: &Plane, count: usize) -> Vec<(Circle, f64)> {
    if plane.width < 16 || plane.height < 16 {
        return Vec::new();
    }
    let edges = edges(plane);
    if edges.is_empty() {
        return Vec::new();
    }
    let short = plane.width.min(plane.height) as f64;
    let first = (RADII[0] * short).max(5.0);
    let layers = ((RADII[1] * short - first) / CELL).max(1.0) as usize;
    let (w, h) = (plane.width as f64, plane.height as f64);
    let origin = DVec2::new(-MARGIN * w, -MARGIN * h);
    let nx = ((1.0 + 2.0 * MARGIN) * w / CELL) as usize + 1;
    let ny = ((1.0 + 2.0 * MARGIN) * h / CELL) as usize + 1;
    let votes: Vec<Vec<f32>> = (0..layers)
        .into_par_iter()
        .map(|layer| {
            let radius = first + CELL * layer as f64;
            let mut votes = vec![0.0_f32; nx * ny];
            for edge in &edges {
                for side in [-radius, radius] {
                    let p = (edge.at + side * edge.along - origin) / CELL;
                    let (x, y) = (p.x as usize, p.y as usize);
                    if p.x >= 0.0 && p.y >= 0.0 && x < nx && y < ny {
                        votes[y * nx + x] += edge.weight as f32;
                    }
                }
            }
            // A vote lands beside its cell as often as in it.
            smooth(&votes, nx, ny, (1.0 / (TAU * radius)) as f32)
        })
        .collect();
    let peaks = peaks(&votes, nx, ny);
    let mut found: Vec<(Circle, f64)> = peaks
        .into_par_iter()
        .map(|(layer, y, x)| {
            let circle = Circle {
                centre: origin + CELL * DVec2::new(x as f64 + 0.5, y as f64 + 0.5),
                radius: first + CELL * layer as f64,
            };
            best_nearby(circle, &edges)
        })
        .collect();
    // By chance a short outline is covered more easily than a long one.
    let rank = |(circle, score): &(Circle, f64)| score * circle.radius.sqrt();
    found.sort_by(|a, b| rank(b).total_cmp(&rank(a)));
    let mut kept: Vec<(Circle, f64)> = Vec::new();
    for (circle, score) in found {
        let alike = kept.iter().any(|(other, _)| {
            let apart = other.centre.distance(circle.centre) + (other.radius - circle.radius).abs();
            apart < 0.06 * other.radius.max(circle.radius) + 1.5
        });
        if !alike {
            kept.push((circle, score));
        }
        if kept.len() == count {
            break;
        }
    }
    kept
}

fn edges(plane: &Plane) -> Vec<Edge> {
    let (w, h) = (plane.width, plane.height);
    let mut sorted = plane.data.clone();
    let middle = sorted.len() / 2;
    let median = *sorted.select_nth_unstable_by(middle, f32::total_cmp).1;
    let mean = plane.data.iter().sum::<f32>() / plane.data.len() as f32;
    let floor = if median > 0.0 { median } else { mean };
    if !(floor > 0.0) {
        return Vec::new();
    }
    let logs: Vec<f64> = plane
        .data
        .iter()
        .map(|&l| f64::from(l / floor + 0.02).ln())
        .collect();
    let mut gradients = vec![DVec2::ZERO; w * h];
    for y in 1..h - 1 {
        for x in 1..w - 1 {
            let l = |i: usize, j: usize| logs[(y + j - 1) * w + x + i - 1];
            gradients[y * w + x] = DVec2::new(
                3.0 * (l(2, 0) - l(0, 0)) + 10.0 * (l(2, 1) - l(0, 1)) + 3.0 * (l(2, 2) - l(0, 2)),
                3.0 * (l(0, 2) - l(0, 0)) + 10.0 * (l(1, 2) - l(1, 0)) + 3.0 * (l(2, 2) - l(2, 0)),
            ) / 32.0;
        }
    }
    let mut sizes: Vec<f64> = gradients.iter().map(|g| g.length()).collect();
    let at = sizes.len() / 3;
    let low = *sizes.select_nth_unstable_by(at, f64::total_cmp).1;
    let least = (2.5 * low).max(2e-3);
    let mut edges = Vec::new();
    for y in 1..h - 1 {
        for x in 1..w - 1 {
            let g = gradients[y * w + x];
            let size = g.length();
            if size < least {
                continue;
            }
            let along = g / size;
            // Thin: only where the gradient is largest along its own direction.
            let (sx, sy) = (along.x.round() as isize, along.y.round() as isize);
            let neighbour = |s: isize| {
                let j = (y as isize + s * sy) as usize;
                let i = (x as isize + s * sx) as usize;
                gradients[j * w + i].length()
            };
            if neighbour(1) > size || neighbour(-1) > size {
                continue;
            }
            edges.push(Edge {
                at: DVec2::new(x as f64 + 0.5, y as f64 + 0.5),
                along,
                weight: size / (size + 2.0 * least),
            });
        }
    }
    edges
}

/// Sums over 3 × 3 cells, times a factor.
fn smooth(votes: &[f32], nx: usize, ny: usize, factor: f32) -> Vec<f32> {
    let mut rows = vec![0.0; nx * ny];
    for y in 0..ny {
        for x in 1..nx - 1 {
            let i = y * nx + x;
            rows[i] = votes[i - 1] + votes[i] + votes[i + 1];
        }
    }
    let mut out = vec![0.0; nx * ny];
    for y in 1..ny - 1 {
        for x in 0..nx {
            let i = y * nx + x;
            out[i] = factor * (rows[i - nx] + rows[i] + rows[i + nx]);
        }
    }
    out
}

/// The highest local maxima: layer, row, column.
fn peaks(votes: &[Vec<f32>], nx: usize, ny: usize) -> Vec<(usize, usize, usize)> {
    let mut all: Vec<(f32, (usize, usize, usize))> = (0..votes.len())
        .into_par_iter()
        .flat_map_iter(|k| {
            let mut list = Vec::new();
            for y in 1..ny - 1 {
                for x in 1..nx - 1 {
                    let v = votes[k][y * nx + x];
                    if v < 0.08 {
                        continue;
                    }
                    let rank = v * (k as f32 + 3.0).sqrt();
                    let around = (0..9).all(|n| {
                        let i = (y + n / 3 - 1) * nx + x + n % 3 - 1;
                        let below = k == 0 || votes[k - 1][i] <= v;
                        let above = k + 1 == votes.len() || votes[k + 1][i] <= v;
                        votes[k][i] <= v && below && above
                    });
                    if around {
                        list.push((rank, (k, y, x)));
                    }
                }
            }
            list
        })
        .collect();
    all.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
    all.truncate(80);
    all.into_iter().map(|(_, at)| at).collect()
}

/// Moves the circle by up to a cell to where most of its outline has edges across it, and says how much of it has.
fn best_nearby(circle: Circle, edges: &[Edge]) -> (Circle, f64) {
    let near: Vec<Edge> = edges
        .iter()
        .filter(|e| (e.at.distance(circle.centre) - circle.radius).abs() < 6.0)
        .copied()
        .collect();
    let mut best = (circle, coverage(circle, &near));
    for _ in 0..3 {
        let from = best.0;
        for k in 0..27 {
            let d = DVec2::new(f64::from(k % 3 - 1), f64::from(k / 3 % 3 - 1));
            let there = Circle {
                centre: from.centre + d,
                radius: from.radius + f64::from(k / 9 - 1),
            };
            let score = coverage(there, &near);
            if score > best.1 {
                best = (there, score);
            }
        }
    }
    best
}

/// Mean over sectors of the heaviest edge that lies on the circle and across it.
fn coverage(circle: Circle, edges: &[Edge]) -> f64 {
    let count = ((TAU * circle.radius / 3.0) as usize).clamp(16, 96);
    let mut sectors = vec![0.0_f64; count];
    for edge in edges {
        let to = edge.at - circle.centre;
        let r = to.length();
        let off = (r - circle.radius).abs();
        if off > 2.0 || r < 1.0 {
            continue;
        }
        let across = (to.dot(edge.along) / r).abs();
        if across < 0.9 {
            continue;
        }
        let k = ((to.y.atan2(to.x) / TAU).rem_euclid(1.0) * count as f64) as usize;
        let value = edge.weight.sqrt() * (1.0 - 0.35 * off);
        let sector = &mut sectors[k.min(count - 1)];
        *sector = sector.max(value);
    }
    sectors.iter().sum::<f64>() / count as f64
}
