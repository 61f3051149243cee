//! Host file: the outline of a ball to a fraction of a pixel, from a circle that is a few pixels off.
//!
//! The rim is cut into sectors. In each the pixels of a band about the circle are fitted, by linear least squares, with a
//! smooth background outside and a polynomial in the root of the depth inside (`edge`), for every place of the
//! rim within the search range; what is left over, measured by the sector's own noise, says how likely each place is.
//! One circle for all sectors minimises the sum of that, each sector's share being bounded: a sector that shows the
//! mount, or a lamp's glare, does not pull.

use crate::circle::Circle;
use crate::edge::{BLURS, terms};
use crate::plane::Plane;
use glam::{DMat3, DVec2, DVec3};
use rayon::prelude::*;
use std::f64::consts::TAU;

/// How a refinement goes about it. All lengths are in pixels of the image that it looks at.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Search {
    /// The rim is searched this far on either side.
    pub(crate) range: f64,
    /// Width of the band outside, beyond the range.
    pub(crate) outside: f64,
    /// Depth of the band inside, beyond the range.
    pub(crate) inside: f64,
    /// Step of the searched places.
    pub(crate) step: f64,
    /// Index of the blur, or none to search for it.
    pub(crate) blur: Option<usize>,
}

/// A refined circle.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Refined {
    pub(crate) circle: Circle,
    /// Covariance of (centre x, centre y, radius) in px².
    pub(crate) covariance: DMat3,
    /// Share of the sectors inside the image that show a rim there, less the share that chance would give; in [0, 1].
    pub(crate) seen: f64,
    /// Share of all sectors that do.
    pub(crate) visible: f64,
    /// Index of the blur that fits best.
    pub(crate) blur: usize,
    /// Its standard deviation in pixels, between those that were tried.
    pub(crate) blur_px: f64,
}

/// Pixels of a sector whose distances from the centre are alike.
#[derive(Clone, Copy, Default)]
struct Bin {
    n: f64,
    /// Distance from the circle outwards, mean.
    r: f64,
    /// Place along the sector, −1…1, mean.
    t: f64,
    /// Value, mean.
    v: f64,
    /// Sum of squared differences from the mean.
    scatter: f64,
}

/// How far the pixels on one side of the rim are from what is fitted.
#[derive(Clone, Copy)]
struct Spread {
    /// Variance of a pixel about the mean of its bin: noise, and what changes along the sector.
    pixel: f64,
    /// Variance of a bin's mean about the fit: what changes across the rim in another way than the terms can say.
    misfit: f64,
}

struct Sector {
    cos: f64,
    sin: f64,
    bins: Vec<Bin>,
}

/// What is left over in a sector, for each place of the rim.
pub(crate) struct Profile {
    cos: f64,
    sin: f64,
    /// −2 ln of the likelihood, less its least.
    excess: Vec<f64>,
    /// Step between these in pixels.
    spacing: f64,
    /// Where it is least, in pixels outwards.
    best: f64,
    /// The least −2 ln of the likelihood.
    least: f64,
    /// By how much that is less than without a rim.
    gain: f64,
}

/// A blur's index, the sectors fitted with it, and the move for which their sum is least.
pub(crate) type Try = (usize, Vec<Profile>, DVec3);

/// Radial width of a bin in pixels.
const BIN: f64 = 0.3;
/// A sector's share is bounded by this.
const CAP: f64 = 12.0;
/// Error of the blur's form, over the step that is blurred.
const SHAPE: f64 = 0.02;
/// Constants that each sector is fitted with.
const UNKNOWNS: usize = 7;
/// A sector counts as seen from this gain on.
const GAIN: f64 = 30.0;

/// Finds the circle near `start`; `None` where less than a quarter of its rim lies in the image, or nothing is there.
pub(crate) fn refine(plane: &Plane, start: Circle, search: Search) -> Option<Refined> {
    if !(start.radius > 3.0) || !start.centre.is_finite() {
        return None;
    }
    let count = ((TAU * start.radius / 12.0) as usize).clamp(24, 96);
    let sectors = gather(plane, start, search, count);
    let in_image = sectors.len() as f64 / count as f64;
    if in_image < 0.25 {
        return None;
    }
    let mut tries: Vec<Try> = Vec::new();
    let attempt = |blur: usize| {
        let profiles: Vec<Profile> = sectors
            .par_iter()
            .map(|sector| profile(sector, search, blur))
            .collect();
        let at = minimum(&profiles, search.range);
        (blur, profiles, at)
    };
    if let Some(blur) = search.blur {
        tries.push(attempt(blur));
    } else {
        tries.extend((1..BLURS.len()).step_by(3).map(attempt));
        let about = tries[least(&badness(&tries, search.range))].0;
        tries.extend([about - 1, (about + 1).min(BLURS.len() - 1)].map(attempt));
    }
    let sums = badness(&tries, search.range);
    let best = least(&sums);
    let (blur, profiles, at) = &tries[best];
    let (at, blur_px) = between(&tries, &sums, best).unwrap_or((*at, BLURS[*blur]));
    let at = &at;
    let (seen, visible) = seen(profiles, *at, search.range, count);
    Some(Refined {
        circle: Circle {
            centre: start.centre + DVec2::new(at.x, at.y),
            radius: start.radius + at.z,
        },
        covariance: covariance(profiles, *at, search.range),
        seen,
        visible,
        blur: *blur,
        blur_px,
    })
}

/// The band's pixels by sector. Sectors that leave the image with more than the far part of their background are left out.
fn gather(plane: &Plane, circle: Circle, search: Search, count: usize) -> Vec<Sector> {
    let outer = search.range + search.outside;
    let inner = (search.range + search.inside).min(0.8 * circle.radius);
    let (r0, r1) = (circle.radius - inner, circle.radius + outer);
    let mut lists: Vec<Vec<[f32; 3]>> = vec![Vec::new(); count];
    let c = circle.centre;
    let rows = (c.y - r1).floor().max(0.0) as usize..(c.y + r1).ceil().max(0.0) as usize;
    for j in rows.start..rows.end.min(plane.height) {
        let dy = j as f64 + 0.5 - c.y;
        let far = (r1 * r1 - dy * dy).max(0.0).sqrt();
        let near = (r0 * r0 - dy * dy).max(0.0).sqrt();
        let mut span = |from: f64, to: f64| {
            let from = (from - 0.5).floor().max(0.0) as usize;
            let to = ((to - 0.5).ceil().max(-1.0) + 1.0) as usize;
            for i in from..to.min(plane.width) {
                let dx = i as f64 + 0.5 - c.x;
                let r = (dx * dx + dy * dy).sqrt();
                if !(r >= r0 && r < r1) {
                    continue;
                }
                let turn = (dy.atan2(dx) / TAU).rem_euclid(1.0) * count as f64;
                let k = (turn as usize).min(count - 1);
                let t = 2.0 * (turn - k as f64) - 1.0;
                let value = plane.data[j * plane.width + i];
                lists[k].push([(r - circle.radius) as f32, t as f32, value]);
            }
        };
        if near > 0.0 {
            span(c.x - far, c.x - near);
            span((c.x + near).max(c.x - near + 1.0), c.x + far);
        } else {
            span(c.x - far, c.x + far);
        }
    }
    let (w, h) = (plane.width as f64, plane.height as f64);
    let enough = |k: usize| {
        [0.0, 1.0].iter().all(|end| {
            let angle = TAU * (k as f64 + end) / count as f64;
            let p = c + (circle.radius + 0.6 * outer) * DVec2::new(angle.cos(), angle.sin());
            p.x >= 0.0 && p.y >= 0.0 && p.x <= w && p.y <= h
        })
    };
    (0..count)
        .filter(|&k| enough(k))
        .map(|k| {
            let angle = TAU * (k as f64 + 0.5) / count as f64;
            Sector {
                cos: angle.cos(),
                sin: angle.sin(),
                bins: bins(&lists[k], inner, outer),
            }
        })
        .collect()
}

/// Sorts a sector's pixels by distance. Their values are divided by the sector's brightness and bent, so that a lamp is not
/// a thousand times as loud as its surroundings.
fn bins(pixels: &[[f32; 3]], inner: f64, outer: f64) -> Vec<Bin> {
    let median = |outside: bool| -> f64 {
        let mut values: Vec<f32> = pixels
            .iter()
            .filter(|p| (p[0] > 0.0) == outside)
            .map(|p| p[2])
            .collect();
        if values.is_empty() {
            return 0.0;
        }
        let middle = values.len() / 2;
        f64::from(*values.select_nth_unstable_by(middle, f32::total_cmp).1)
    };
    let level = median(true).max(median(false)).max(1e-12);
    let mut bins = vec![Bin::default(); ((inner + outer) / BIN).ceil() as usize + 1];
    for &[r, t, value] in pixels {
        let x = f64::from(value) / level;
        let index = ((f64::from(r) + inner) / BIN).max(0.0) as usize;
        let last = bins.len() - 1;
        let bin = &mut bins[index.min(last)];
        bin.n += 1.0;
        bin.r += f64::from(r);
        bin.t += f64::from(t);
        let v = x / (1.0 + 0.2 * x);
        bin.v += v;
        bin.scatter += v * v;
    }
    bins.retain(|bin| bin.n > 0.0);
    for bin in &mut bins {
        bin.r /= bin.n;
        bin.t /= bin.n;
        bin.v /= bin.n;
        bin.scatter = (bin.scatter - bin.n * bin.v * bin.v).max(0.0);
    }
    bins
}

/// Fits the sector with the rim at every place of the range.
///
/// Outside, a picture is as smooth as its noise lets it be; inside, the whole world is squeezed into a few pixels, and no
/// few terms describe it. So either side has a variance of its own, taken where the range does not reach.
fn profile(
    sector: &Sector,
    Search {
        range,
        step: spacing,
        ..
    }: Search,
    blur: usize,
) -> Profile {
    let places = (2.0 * range / spacing).round() as usize + 1;
    let nothing = |excess: Vec<f64>| Profile {
        cos: sector.cos,
        sin: sector.sin,
        excess,
        spacing,
        best: f64::INFINITY,
        least: 0.0,
        gain: 0.0,
    };
    let margin = range + (0.5 + BLURS[blur]).min(1.0);
    let outside: Vec<Bin> = some(&sector.bins, |r| r > margin);
    let inside: Vec<Bin> = some(&sector.bins, |r| r < -margin);
    let (Some(out), Some(inn)) = (spread(&outside, false), spread(&inside, true)) else {
        return nothing(vec![0.0; places]);
    };
    let bins = &sector.bins;
    // No lens blurs quite like a Gaussian: where the two sides mix, a share of their difference is not known.
    let shape = (SHAPE * (mean(&outside) - mean(&inside))).powi(2);
    let mut left: Vec<f64> = (0..places)
        .map(|i| {
            let rim = i as f64 * spacing - range;
            left_over(bins, |bin, row: &mut [f64; UNKNOWNS]| {
                let [step, root, line, _] = terms(blur, rim - bin.r);
                *row = [
                    1.0,
                    bin.t,
                    0.1 * (bin.r - rim).max(0.0),
                    step,
                    root,
                    line,
                    bin.t * root,
                ];
                let pixel = out.pixel + (inn.pixel - out.pixel) * step;
                let misfit = out.misfit + (inn.misfit - out.misfit) * step;
                pixel / bin.n + misfit + shape * 4.0 * (step * (1.0 - step)).max(0.0)
            })
        })
        .collect();
    let smooth = left_over(bins, |bin, row: &mut [f64; 4]| {
        let x = 0.1 * bin.r;
        *row = [1.0, bin.t, x, x * x];
        out.pixel / bin.n + out.misfit
    });
    let (at, least) =
        left.iter().enumerate().fold(
            (0, f64::INFINITY),
            |a, (i, &b)| {
                if b < a.1 { (i, b) } else { a }
            },
        );
    for value in &mut left {
        *value -= least;
    }
    Profile {
        best: at as f64 * spacing - range,
        least,
        gain: smooth - least,
        ..nothing(left)
    }
}

fn mean(bins: &[Bin]) -> f64 {
    bins.iter().map(|bin| bin.v).sum::<f64>() / bins.len().max(1) as f64
}

fn some(bins: &[Bin], which: impl Fn(f64) -> bool) -> Vec<Bin> {
    bins.iter().filter(|bin| which(bin.r)).copied().collect()
}

/// The spread about a straight line outside, or about a parabola inside; `None` of too few bins.
fn spread(bins: &[Bin], inside: bool) -> Option<Spread> {
    let freedom = bins.len() as f64 - if inside { 4.0 } else { 3.0 };
    let pairs: f64 = bins.iter().map(|bin| bin.n - 1.0).sum();
    if freedom < 2.0 || pairs < 4.0 {
        return None;
    }
    let pixel = bins.iter().map(|bin| bin.scatter).sum::<f64>() / pairs + 1e-8;
    let middle = bins.iter().map(|bin| bin.r).sum::<f64>() / bins.len() as f64;
    let (squares, _) = fit(bins, |bin, row: &mut [f64; 4]| {
        let x = 0.2 * (bin.r - middle);
        *row = [1.0, bin.t, x, if inside { x * x } else { 0.0 }];
        pixel / bin.n
    });
    // Over the variance of the pixels alone; what is more than that is misfit.
    let mean: f64 = bins.iter().map(|bin| pixel / bin.n).sum::<f64>() / bins.len() as f64;
    let misfit = (squares / freedom - 1.0).max(0.0) * mean + 1e-8;
    Some(Spread { pixel, misfit })
}

/// −2 ln of the likelihood, integrated over what the terms are multiplied with, so that terms which follow the pixels near
/// the rim more closely than others gain nothing by it. `fill` writes a bin's terms and returns its variance.
fn left_over<const N: usize>(bins: &[Bin], fill: impl FnMut(&Bin, &mut [f64; N]) -> f64) -> f64 {
    let (squares, logs) = fit(bins, fill);
    squares + logs
}

/// Sum of squares over the variances that linear least squares leave, and what the likelihood adds to it.
#[expect(
    clippy::needless_range_loop,
    reason = "Cholesky reads as it is written in books"
)]
fn fit<const N: usize>(
    bins: &[Bin],
    mut fill: impl FnMut(&Bin, &mut [f64; N]) -> f64,
) -> (f64, f64) {
    let mut m = [[0.0; N]; N];
    let mut b = [0.0; N];
    let mut total = 0.0;
    let mut logs = 0.0;
    let mut row = [0.0; N];
    for bin in bins {
        let variance = fill(bin, &mut row);
        let weight = 1.0 / variance;
        logs += variance.ln();
        for i in 0..N {
            let weighted = weight * row[i];
            for j in 0..=i {
                m[i][j] += weighted * row[j];
            }
            b[i] += weighted * bin.v;
        }
        total += weight * bin.v * bin.v;
    }
    // Cholesky; a ridge far below any signal keeps terms apart that the pixels do not tell apart.
    let scale: f64 = (0..N).map(|i| m[i][i]).fold(0.0, f64::max);
    for i in 0..N {
        m[i][i] += 1e-9 * scale;
        for j in 0..=i {
            let mut sum = m[i][j];
            for k in 0..j {
                sum -= m[i][k] * m[j][k];
            }
            m[i][j] = if i == j {
                sum.max(1e-300).sqrt()
            } else {
                sum / m[j][j]
            };
        }
        let mut sum = b[i];
        for k in 0..i {
            sum -= m[i][k] * b[k];
        }
        b[i] = sum / m[i][i];
        total -= b[i] * b[i];
        logs += 2.0 * m[i][i].ln();
    }
    (total.max(0.0), logs)
}

impl Profile {
    /// A sector in a direction, and what each place of its rim costs.
    pub(crate) fn new(direction: DVec2, mut excess: Vec<f64>, spacing: f64) -> Self {
        let least = excess.iter().copied().fold(f64::INFINITY, f64::min);
        for value in &mut excess {
            *value -= least;
        }
        Self {
            cos: direction.x,
            sin: direction.y,
            excess,
            spacing,
            best: f64::INFINITY,
            least,
            gain: 0.0,
        }
    }

    /// Excess of a circle that is moved and grown by `at`, interpolated between the steps.
    fn excess_at(&self, at: DVec3, range: f64) -> f64 {
        let rho = at.z + at.x * self.cos + at.y * self.sin;
        let last = self.excess.len() - 1;
        let place = ((rho + range) / self.spacing).clamp(0.0, last as f64);
        let i = (place as usize).min(last - 1);
        let f = place - i as f64;
        let p = |k: usize| self.excess[k.min(last)];
        let (a, b, c, d) = (p(i.saturating_sub(1)), p(i), p(i + 1), p(i + 2));
        // Catmull-Rom.
        let value = b + 0.5
            * f
            * (c - a + f * (2.0 * a - 5.0 * b + 4.0 * c - d + f * (3.0 * (b - c) + d - a)));
        value.max(0.0)
    }
}

fn bounded(excess: f64) -> f64 {
    CAP * (1.0 - (-excess / CAP).exp())
}

fn total(profiles: &[Profile], at: DVec3, range: f64) -> f64 {
    profiles
        .iter()
        .map(|p| bounded(p.excess_at(at, range)))
        .sum()
}

/// Where the sum over the sectors is least: over a grid first, then in ever smaller steps.
pub(crate) fn minimum(profiles: &[Profile], range: f64) -> DVec3 {
    let step = if range > 2.0 { 0.5 } else { 0.25 };
    let n = (range / step) as i32;
    let axis = -n..=n;
    let grid: Vec<DVec3> = axis
        .clone()
        .flat_map(|x| {
            let axis = axis.clone();
            axis.clone().flat_map(move |y| {
                axis.clone()
                    .map(move |z| step * DVec3::new(f64::from(x), f64::from(y), f64::from(z)))
            })
        })
        .filter(|at| at.truncate().length() + at.z.abs() <= range)
        .collect();
    let (mut at, mut least) = grid
        .par_iter()
        .with_min_len(64)
        .map(|&at| (at, total(profiles, at, range)))
        .reduce(
            || (DVec3::ZERO, f64::INFINITY),
            |a, b| if b.1 < a.1 { b } else { a },
        );
    let mut step = 0.5 * step;
    while step > 0.002 {
        let from = at;
        for k in 0..27 {
            let unit = DVec3::new(
                f64::from(k % 3 - 1),
                f64::from(k / 3 % 3 - 1),
                f64::from(k / 9 - 1),
            );
            let there = from + step * unit;
            let value = total(profiles, there, range);
            if value < least {
                (at, least) = (there, value);
            }
        }
        if at == from {
            step *= 0.5;
        }
    }
    at
}

/// How badly each try fits the sectors, each sector's say being bounded.
pub(crate) fn badness(tries: &[Try], range: f64) -> Vec<f64> {
    let mut sums = vec![0.0; tries.len()];
    for k in 0..tries[0].1.len() {
        let fit: Vec<f64> = tries
            .iter()
            .map(|(_, profiles, at)| profiles[k].least + bounded(profiles[k].excess_at(*at, range)))
            .collect();
        let least = fit.iter().copied().fold(f64::INFINITY, f64::min);
        for (sum, f) in sums.iter_mut().zip(fit) {
            *sum += (f - least).min(30.0);
        }
    }
    sums
}

pub(crate) fn least(values: &[f64]) -> usize {
    (0..values.len()).fold(0, |a, b| if values[b] < values[a] { b } else { a })
}

/// The move and the blur at the lowest point of the parabola through the best blur and its neighbours. A rim that is
/// blurred by a fifth more looks much like one that lies a third of a pixel further in, so steps of the blur would show.
fn between(tries: &[Try], sums: &[f64], best: usize) -> Option<(DVec3, f64)> {
    let blur = tries[best].0;
    let find = |b: usize| (0..tries.len()).find(|&k| tries[k].0 == b);
    let (low, high) = (find(blur.checked_sub(1)?)?, find(blur + 1)?);
    let x = [low, best, high].map(|k| BLURS[tries[k].0]);
    let parabola = |y: [f64; 3]| {
        let first = (y[1] - y[0]) / (x[1] - x[0]);
        let second = ((y[2] - y[1]) / (x[2] - x[1]) - first) / (x[2] - x[0]);
        (first, second)
    };
    let (first, second) = parabola([low, best, high].map(|k| sums[k]));
    if !(second > 0.0) {
        return None;
    }
    let at = (0.5 * (x[0] + x[1]) - 0.5 * first / second).clamp(x[0], x[2]);
    let value = |axis: usize| {
        let y = [low, best, high].map(|k| tries[k].2[axis]);
        let (first, second) = parabola(y);
        y[0] + (at - x[0]) * (first + second * (at - x[1]))
    };
    Some((DVec3::new(value(0), value(1), value(2)), at))
}

/// Share of the sectors that show a rim where the circle says, of those in the image and of all.
fn seen(profiles: &[Profile], at: DVec3, range: f64, count: usize) -> (f64, f64) {
    let tolerance = 0.2 * range;
    let hits = profiles
        .iter()
        .filter(|p| {
            let rho = at.z + at.x * p.cos + at.y * p.sin;
            p.gain > GAIN && ((p.best - rho).abs() < tolerance || p.excess_at(at, range) < 4.0)
        })
        .count() as f64;
    let chance = tolerance / range;
    let net = |share: f64| ((share - chance) / (1.0 - chance)).max(0.0);
    (net(hits / profiles.len() as f64), hits / count as f64)
}

/// Covariance by the sandwich of curvature and scatter over the sectors, which needs no model of the noise.
pub(crate) fn covariance(profiles: &[Profile], at: DVec3, range: f64) -> DMat3 {
    let h = 0.125;
    let axes = [DVec3::X * h, DVec3::Y * h, DVec3::Z * h];
    let sum = |at| total(profiles, at, range);
    let mut curvature = DMat3::ZERO;
    for i in 0..3 {
        for j in 0..3 {
            let (a, b) = (axes[i], axes[j]);
            let second = sum(at + a + b) - sum(at + a - b) - sum(at - a + b) + sum(at - a - b);
            curvature.col_mut(i)[j] = second / (4.0 * h * h);
        }
    }
    let mut scatter = DMat3::ZERO;
    for p in profiles {
        let slope = axes.map(|a| {
            (bounded(p.excess_at(at + a, range)) - bounded(p.excess_at(at - a, range))) / (2.0 * h)
        });
        let g = DVec3::from_array(slope);
        scatter += DMat3::from_cols(g * g.x, g * g.y, g * g.z);
    }
    if !(curvature.determinant() > 1e-9) {
        return DMat3::from_diagonal(DVec3::splat(range * range));
    }
    let inverse = curvature.inverse();
    inverse * scatter * inverse
}
