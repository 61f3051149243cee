//! Host file: the last tenths of a pixel of a sharp outline, by where the picture ceases to be the background.
//!
//! At the rim a ball reflects what lies straight behind it, with a reflectance of one. So there is no step to look for, and
//! what is inside is the world squeezed into a few pixels, which no few terms describe. But the background is smooth: in
//! each sector a plane through the pixels outside says, but for their noise, what those at the rim would be without a ball.
//! How far these are from it is random, with a variance that grows with the depth below the rim from nothing: the depth's
//! power that is taken makes little difference, as the rim lies where the difference begins. The pixels that count stay the
//! same while the circle moves, so that likelihoods can be compared. All is done in square roots of the luminance, in which
//! the noise is even.

use crate::circle::Circle;
use crate::plane::Plane;
use crate::refine::{Profile, Try, badness, covariance, least, minimum};
use glam::{DMat3, DMat4, DVec2, DVec3, DVec4};
use rayon::prelude::*;
use std::f64::consts::TAU;

/// Length of a sector along the rim, in pixels.
const ARC: f64 = 26.0;
/// Width of the band in which the background is fitted.
const BACKGROUND: f64 = 8.0;
/// The rim is searched this far on either side, each time about where it was found the last time.
const RANGES: [f64; 3] = [1.5, 0.8, 0.3];
/// Pixels count from this far inside the circle. The fewer of the world's there are, the less it matters what they show.
const INSIDE: [f64; 3] = [2.0, 0.8, 0.8];
/// Places on either side.
const PLACES: usize = 6;
/// Standard deviations of the blurs that are tried first.
const BLURS: [f64; 4] = [0.0, 0.35, 0.7, 1.05];
/// Those that are tried last, about the best of these.
const NEAR: f64 = 0.12;
/// What a pixel of blur costs a sector. Detail close to the rim passes for a little blur, so it takes more than a hint.
const BLUR_COST: f64 = 0.6;
/// Error of the background that a sector is taken to have at least, as a share of its value.
const FLOOR: f64 = 3e-4;
/// Degrees of freedom of Student's distribution, which the differences have.
const STUDENT: f64 = 4.0;
/// Pixels that err alike.
const ALIKE: f64 = 4.0;
/// A centre or a radius that moves further has found something else.
const FURTHEST: f64 = 1.5;
/// A standard error beyond this is no improvement.
const UNSURE: f64 = 0.3;
/// Standard errors from the scatter over the sectors are this much too small, as films of known outlines show.
const OPTIMISM: f64 = 2.0;
/// What remains beside them, in pixels: the world is not as random as it is taken to be.
const REST: f64 = 0.03;

/// A pixel of the band.
#[derive(Clone, Copy)]
struct Pixel {
    /// Distance from the circle outwards.
    r: f64,
    /// Place along the sector, −1…1.
    t: f64,
    /// Extents of the pixel's square as they project onto the radius.
    extent: [f64; 2],
    /// Root of the luminance.
    value: f64,
}

/// A pixel beside the background's fit.
struct Difference {
    r: f64,
    extent: [f64; 2],
    /// Squared difference from the background.
    square: f64,
    /// Its variance where there is no ball.
    noise: f64,
}

/// The pixels of a sector, and its angle.
struct Sector {
    angle: f64,
    pixels: Vec<Pixel>,
}

/// A circle, the covariance of (centre x, centre y, radius) in px², and the blur's standard deviation in pixels.
pub(crate) struct Polished {
    pub(crate) circle: Circle,
    pub(crate) covariance: DMat3,
    pub(crate) blur_px: f64,
}

/// The circle near `start`, which is off by no more than a pixel or so; `None` where the rim is not
/// sharp, hardly differs from the background, or lies elsewhere.
pub(crate) fn polish(plane: &Plane, start: Circle) -> Option<Polished> {
    let mut circle = start;
    let mut blurs = BLURS.to_vec();
    let mut result = None;
    for (round, (range, inside)) in RANGES.into_iter().zip(INSIDE).enumerate() {
        if round == RANGES.len() - 1 {
            let best = blurs[0];
            blurs.extend([(best - NEAR).max(0.0), best + NEAR]);
            blurs.dedup();
        }
        let widest = blurs.iter().copied().fold(0.0, f64::max);
        // Beyond this no pixel shows the ball, wherever in the range the rim is.
        let margin = range + 0.75 + 1.75 * widest;
        let sectors = gather(plane, circle, inside, margin + BACKGROUND);
        if (sectors.len() as f64) < 0.25 * count(circle) as f64 {
            return None;
        }
        let tries: Vec<Try> = blurs
            .iter()
            .enumerate()
            .map(|(index, &blur)| {
                let profiles: Vec<Profile> = sectors
                    .par_iter()
                    .map(|sector| profile(sector, range, margin, blur))
                    .collect();
                let at = minimum(&profiles, range);
                (index, profiles, at)
            })
            .collect();
        let mut sums = badness(&tries, range);
        for (sum, blur) in sums.iter_mut().zip(&blurs) {
            *sum += BLUR_COST * sectors.len() as f64 * blur;
        }
        let (index, profiles, at) = &tries[least(&sums)];
        if round == 0 && *index + 1 == BLURS.len() {
            return None;
        }
        circle.centre += at.truncate();
        circle.radius += at.z;
        let moved = at.truncate().length() + at.z.abs();
        result = (moved < range).then(|| (circle, covariance(profiles, *at, range)));
        blurs = vec![blurs[*index]];
    }
    let (circle, c) = result?;
    let c = c * OPTIMISM.powi(2) + DMat3::from_diagonal(DVec3::splat(REST.powi(2)));
    let moved = circle
        .centre
        .distance(start.centre)
        .max((circle.radius - start.radius).abs());
    let sigma = c.x_axis.x.max(c.y_axis.y).max(c.z_axis.z).max(0.0).sqrt();
    (moved < FURTHEST && sigma < UNSURE).then_some(Polished {
        circle,
        covariance: c,
        blur_px: blurs[0],
    })
}

fn count(circle: Circle) -> usize {
    ((TAU * circle.radius / ARC) as usize).clamp(24, 512)
}

/// The band's pixels by sector. Sectors that leave the image are left out.
fn gather(plane: &Plane, circle: Circle, inside: f64, outside: f64) -> Vec<Sector> {
    let count = count(circle);
    let mut sectors: Vec<Sector> = (0..count)
        .map(|k| Sector {
            angle: TAU * (k as f64 + 0.5) / count as f64,
            pixels: Vec::new(),
        })
        .collect();
    let Circle { centre: c, radius } = circle;
    let (near, far) = (radius - inside, radius + outside);
    let half = |reach: f64, dy: f64| (reach * reach - dy * dy).max(0.0).sqrt();
    let bottom = ((c.y + far).max(0.0) as usize + 1).min(plane.height);
    for j in (c.y - far).max(0.0) as usize..bottom {
        let dy = j as f64 + 0.5 - c.y;
        let (outer, inner) = (half(far, dy), half(near, dy));
        let mut span = |from: f64, to: f64| {
            let right = (to.max(0.0) as usize + 1).min(plane.width);
            for i in from.max(0.0) as usize..right {
                let dx = i as f64 + 0.5 - c.x;
                let distance = (dx * dx + dy * dy).sqrt();
                if distance < near || distance > far {
                    continue;
                }
                let turn = (dy.atan2(dx) / TAU).rem_euclid(1.0) * count as f64;
                let k = (turn as usize).min(count - 1);
                sectors[k].pixels.push(Pixel {
                    r: distance - radius,
                    t: 2.0 * (turn - k as f64) - 1.0,
                    extent: [dx, dy].map(|x| (x / distance).abs().max(0.02)),
                    value: f64::from(plane.data[j * plane.width + i]).sqrt(),
                });
            }
        };
        if inner > 2.0 {
            span(c.x - outer, c.x - inner + 1.0);
            span(c.x + inner - 1.0, c.x + outer);
        } else {
            span(c.x - outer, c.x + outer);
        }
    }
    let area = 0.5 * TAU * (far * far - near * near) / count as f64;
    sectors.retain(|sector| sector.pixels.len() as f64 > 0.9 * area);
    sectors
}

/// The pixels about the range as they differ from a plane through those beyond `margin`; none if the sector is black.
fn differences(pixels: &[Pixel], margin: f64) -> Vec<Difference> {
    let row = |p: &Pixel| {
        let x = 0.25 * (p.r - margin) - 1.0;
        DVec4::new(1.0, x, p.t, p.t * x)
    };
    let mut products = DMat4::ZERO;
    let mut values = DVec4::ZERO;
    let mut outside = 0.0;
    for p in pixels.iter().filter(|p| p.r > margin) {
        let row = row(p);
        products += DMat4::from_cols(row * row.x, row * row.y, row * row.z, row * row.w);
        values += row * p.value;
        outside += 1.0;
    }
    if !(outside > 12.0 && products.determinant() > 1e-6 && values.x > 0.0) {
        return Vec::new();
    }
    let inverse = products.inverse();
    let plane = inverse * values;
    let off = |p: &Pixel| (p.value - plane.dot(row(p))).powi(2);
    let squares: f64 = pixels.iter().filter(|p| p.r > margin).map(off).sum();
    let variance = squares / (outside - 4.0) + (FLOOR * values.x / outside).powi(2);
    pixels
        .iter()
        .filter(|p| p.r < margin + 0.5)
        .map(|p| Difference {
            r: p.r,
            extent: p.extent,
            square: off(p),
            noise: variance * (1.0 + row(p).dot(inverse * row(p))),
        })
        .collect()
}

/// How likely the rim of a sector is at every place of the range.
fn profile(sector: &Sector, range: f64, margin: f64, blur: f64) -> Profile {
    let list = differences(&sector.pixels, margin);
    let spacing = range / PLACES as f64;
    let mut growth = vec![0.0; list.len()];
    let costs = (0..=2 * PLACES).map(|place| {
        let rim = place as f64 * spacing - range;
        for (g, d) in growth.iter_mut().zip(&list) {
            *g = in_pixel(d.extent, blur, rim - d.r).powi(2);
        }
        cost(&list, &growth) * 2.0 / ALIKE
    });
    Profile::new(DVec2::from_angle(sector.angle), costs.collect(), spacing)
}

/// −ln of the likelihood of the differences, whose variances are their noise and a multiple of `growth`, the likeliest one.
fn cost(list: &[Difference], growth: &[f64]) -> f64 {
    let sum: f64 = growth.iter().sum();
    let mut factor = list.iter().map(|d| d.square).sum::<f64>() / sum.max(1e-9);
    for _ in 0..6 {
        let (mut over, mut under) = (0.0, 1e-30);
        for (d, &g) in list.iter().zip(growth) {
            let variance = 1.0 / (d.noise + factor * g);
            let square = d.square * (STUDENT + 1.0) / (STUDENT + d.square * variance);
            let weight = g * variance * variance;
            over += weight * (square - d.noise);
            under += weight * g;
        }
        factor = (over / under).max(0.0);
    }
    let each = |(d, &g): (&Difference, &f64)| {
        let variance = d.noise + factor * g;
        let tail = (1.0 + d.square / (STUDENT * variance)).ln();
        0.5 * (variance.ln() + (STUDENT + 1.0) * tail)
    };
    list.iter().zip(growth).map(each).sum()
}

/// Mean of the depth's root over a pixel's square, whose middle is at `depth`, blurred by a standard deviation.
///
/// Along the radius the square weighs like two boxes folded, and the blur is taken for a third. So the mean is a second, or
/// third, difference of what has been integrated as often.
fn in_pixel(extent: [f64; 2], blur: f64, depth: f64) -> f64 {
    let [u, v] = extent;
    let (a, b) = (0.5 * (u + v), 0.5 * (u - v));
    let w = 0.5 * 12.0_f64.sqrt() * blur;
    if depth + a + w <= 0.0 {
        return 0.0;
    }
    let second = |f: fn(f64) -> f64, x: f64| {
        let [far, near] = [f(x + a) + f(x - a), f(x + b) + f(x - b)];
        far - near
    };
    if blur < 0.02 {
        let twice = |x: f64| x * x * x.max(0.0).sqrt();
        return 4.0 / 15.0 * second(twice, depth) / (u * v);
    }
    let thrice = |x: f64| x * x * x * x.max(0.0).sqrt();
    let sum = second(thrice, depth + w) - second(thrice, depth - w);
    8.0 / 105.0 * sum / (u * v * 2.0 * w)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pixel_sees_the_mean_over_its_square() {
        for (angle, blur, depth) in [(0.1_f64, 0.0, 0.3), (0.6, 0.0, -0.4), (0.8, 0.5, 0.2)] {
            let extent = [angle.cos(), angle.sin()];
            let n = 64;
            let middle = |i: i32| (f64::from(i) + 0.5) / f64::from(n) - 0.5;
            let mut sum = 0.0;
            for k in 0..n * n * n {
                let (x, y, z) = (middle(k % n), middle(k / n % n), middle(k / n / n));
                let offset = x * extent[0] + y * extent[1] + z * 12.0_f64.sqrt() * blur;
                sum += (depth + offset).max(0.0).sqrt();
            }
            let mean = sum / f64::from(n).powi(3);
            let got = in_pixel(extent, blur, depth);
            assert!((got - mean).abs() < 2e-3, "{got} {mean}");
        }
    }
}
