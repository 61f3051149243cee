//! Host file: finds the ball in one frame, coarse to fine.

use crate::circle::Circle;
use crate::coarse::candidates;
use crate::edge::{BLURS, USUAL_BLUR, nearest};
use crate::plane::Pyramid;
use crate::polish::polish;
use crate::refine::{Refined, Search, refine};
use glam::{UVec2, Vec4};
use rayon::prelude::*;

/// A ball that was found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Found {
    /// Its outline.
    pub circle: Circle,
    /// How sure it is that this is a ball, in [0, 1]: the share of the outline that shows a rim where the circle says,
    /// less what chance would give. Balls have 0.5 and more, other things seldom 0.4.
    pub confidence: f64,
    /// Standard error of either coordinate of the centre in pixels, from the scatter along the outline.
    pub sigma_px: f64,
    /// Standard error of the radius in pixels.
    pub sigma_radius_px: f64,
    /// Share of the outline that shows a rim, in [0, 1]. The rest is covered by a mount, or has no contrast.
    pub visible_fraction: f64,
    /// Blur of the rim beyond a pixel's own width, the standard deviation in pixels.
    pub blur_px: f64,
}

/// A side of the image.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// x = 0.
    Left,
    /// x = the width.
    Right,
    /// y = 0.
    Top,
    /// y = the height.
    Bottom,
}

/// Why no single whole ball was found.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum FindError {
    /// The slice has not as many pixels as the size says.
    #[error("the image has {pixels} pixels, and {} × {} need {}", size.x, size.y, u64::from(size.x) * u64::from(size.y))]
    Size {
        /// Size that was given.
        size: UVec2,
        /// Pixels that were given.
        pixels: usize,
    },
    /// The image is too small for a ball that could be measured.
    #[error("the image is {} × {}, too small to find a ball in; it takes 64 × 64", .0.x, .0.y)]
    ImageTooSmall(UVec2),
    /// There is no ball, or one that is hardly seen.
    #[error(
        "no mirror ball was found; give its centre and radius by hand if there is one{}",
        .best.map(|c| format!(" (the likeliest circle was {c})")).unwrap_or_default()
    )]
    NoBall {
        /// The circle that was most like one.
        best: Option<Circle>,
    },
    /// The outline leaves the image.
    #[error("the ball {circle} is cut by the border ({}); it has to lie in the frame as a whole", names(.sides))]
    Cut {
        /// The outline as far as it is seen.
        circle: Circle,
        /// The sides it crosses.
        sides: Vec<Side>,
    },
    /// There are two balls, the likelier one first.
    #[error(
        "two balls were found, {0} and {1}; crop the frames to one, or give its centre and radius"
    )]
    Two(Circle, Circle),
    /// The ball is so small that a pixel of it shows several degrees.
    #[error("the ball {0} is too small; a radius of 20 px is the least")]
    TooSmall(Circle),
}

fn names(sides: &[Side]) -> String {
    let words: Vec<String> = sides
        .iter()
        .map(|side| format!("{side:?}").to_lowercase())
        .collect();
    words.join(", ")
}

/// Least confidence of a ball.
const CONFIDENT: f64 = 0.4;
/// The same in the reduced image.
const HOPEFUL: f64 = 0.25;
/// Least radius of a ball in pixels.
const SMALLEST: f64 = 20.0;
/// Least radius of a ball in pixels whose outline is polished.
const POLISHED: f64 = 250.0;
/// Candidates of the coarse search that are looked at closely.
const CANDIDATES: usize = 16;

/// Finds the outline of the one mirror ball in an image of linear radiance.
///
/// `size` and `pixels`: the image, rows from the top; w is not read, and pixels that are no light count as black. `hint`:
/// where the ball was in the frame before; near it (2 % of its radius and at least 12 px) the outline is searched first,
/// and the whole image only where it is not there. A hint also chooses between two balls.
///
/// Circles are voted for by edges of the image reduced to 400 pixels; the best are refined there, and the likeliest from
/// level to level down to whole pixels, each time by fitting the rim's own form in sectors. Where the rim is blurred over
/// many pixels, the last levels say no more and are left out; where it is sharp, the last tenths of a pixel come from where
/// the picture ceases to be the smooth background.
///
/// # Errors
/// See [`FindError`]. An image of one colour, or black, has [`FindError::NoBall`].
///
/// ```
/// use glam::{UVec2, Vec4};
/// use glimt_ball::{FindError, find};
/// let grey = vec![Vec4::splat(0.5); 128 * 96];
/// assert_eq!(find(UVec2::new(128, 96), &grey, None), Err(FindError::NoBall { best: None }));
/// ```
pub fn find(size: UVec2, pixels: &[Vec4], hint: Option<Circle>) -> Result<Found, FindError> {
    find_in(&reduced(size, pixels)?, hint)
}

/// The image and its reductions, if a ball could be found in it at all.
pub(crate) fn reduced(size: UVec2, pixels: &[Vec4]) -> Result<Pyramid, FindError> {
    if pixels.len() as u64 != u64::from(size.x) * u64::from(size.y) {
        let pixels = pixels.len();
        return Err(FindError::Size { size, pixels });
    }
    if size.min_element() < 64 {
        return Err(FindError::ImageTooSmall(size));
    }
    Ok(Pyramid::new(size, pixels))
}

/// [`find`] in an image whose reductions are there already.
pub(crate) fn find_in(pyramid: &Pyramid, hint: Option<Circle>) -> Result<Found, FindError> {
    if let Some(found) = hint.and_then(|hint| near(pyramid, hint)) {
        return Ok(found);
    }
    let coarsest = pyramid.levels.len() - 1;
    let plane = &pyramid.levels[coarsest];
    let mut list: Vec<(Circle, Refined)> = candidates(plane, CANDIDATES)
        .par_iter()
        .filter_map(|(circle, _)| {
            let refined = refine(plane, *circle, COARSE)?;
            Some((*circle, refined))
        })
        .collect();
    // A longer outline that is seen says more than a short one.
    let rank = |r: &Refined| {
        let sure = if r.seen >= HOPEFUL { 1e6 } else { 0.0 };
        sure + r.seen * r.circle.radius.sqrt()
    };
    list.sort_by(|a, b| rank(&b.1).total_cmp(&rank(&a.1)));
    let scale = f64::from(1_u32 << coarsest);
    let Some(best) = choose(&list) else {
        return Err(FindError::NoBall { best: None });
    };
    let circle = best.circle.scaled(scale);
    if best.seen < HOPEFUL {
        return Err(FindError::NoBall { best: Some(circle) });
    }
    if let Some(error) = cut(pyramid, circle, 0.01 * circle.radius + 1.0) {
        return Err(error);
    }
    let other = list.iter().map(|(_, r)| r).find(|r| {
        let apart = r.circle.centre.distance(best.circle.centre);
        let disjoint = apart > 0.95 * (r.circle.radius + best.circle.radius);
        disjoint
            && r.circle.radius > 0.4 * best.circle.radius
            && r.seen > CONFIDENT.max(0.7 * best.seen)
    });
    if let Some(other) = other {
        return Err(FindError::Two(circle, other.circle.scaled(scale)));
    }
    let Some(found) = descend(pyramid, best.circle, coarsest) else {
        return Err(FindError::NoBall { best: Some(circle) });
    };
    if let Some(error) = cut(pyramid, found.circle, 0.5) {
        return Err(error);
    }
    if found.circle.radius < SMALLEST {
        return Err(FindError::TooSmall(found.circle));
    }
    if found.confidence < CONFIDENT {
        let best = Some(found.circle);
        return Err(FindError::NoBall { best });
    }
    Ok(found)
}

const COARSE: Search = Search {
    range: 3.0,
    outside: 4.5,
    inside: 4.0,
    step: 0.25,
    blur: Some(USUAL_BLUR),
};
const MIDDLE: Search = Search {
    range: 3.0,
    outside: 5.0,
    inside: 4.0,
    step: 0.25,
    blur: Some(USUAL_BLUR),
};
const FINE: Search = Search {
    range: 1.5,
    outside: 7.0,
    inside: 4.5,
    step: 0.25,
    blur: None,
};
/// The likeliest of refined candidates. A mirror ball shows circles: lamps, and the camera's own round front in the middle.
/// So a circle that holds a likelier one, and is itself likely, comes first.
fn choose(list: &[(Circle, Refined)]) -> Option<Refined> {
    let mut best = list.first()?.1;
    for (_, r) in list {
        let holds = r.circle.centre.distance(best.circle.centre) + best.circle.radius
            < 1.03 * r.circle.radius;
        let larger = r.circle.radius > 1.03 * best.circle.radius;
        if holds && larger && r.seen > HOPEFUL {
            best = *r;
        }
    }
    Some(best)
}

/// Refines a circle of the given level on that and all finer ones.
fn descend(pyramid: &Pyramid, circle: Circle, level: usize) -> Option<Found> {
    let mut at = circle;
    let mut blur = None;
    let mut last: Option<(Refined, usize)> = None;
    for level in (0..=level).rev() {
        let plane = &pyramid.levels[level];
        let wide = refine(
            plane,
            at,
            Search {
                blur: Some(blur.unwrap_or(USUAL_BLUR)),
                ..MIDDLE
            },
        )?;
        let mut fine = refine(plane, wide.circle, FINE)?;
        let moved = fine.circle.centre.distance(wide.circle.centre)
            + (fine.circle.radius - wide.circle.radius).abs();
        if level == 0 && moved > 0.4 {
            // Once more from where it ended: sectors and bands are laid about the start.
            fine = refine(plane, fine.circle, FINE)?;
        }
        // The wider search shows best whether the sectors agree, on whichever level has their contrast; within a pixel
        // they scatter by themselves.
        let before = last.map_or((0.0, 0.0), |(r, _)| (r.seen, r.visible));
        fine.seen = fine.seen.max(wide.seen).max(before.0);
        fine.visible = fine.visible.max(wide.visible).max(before.1);
        if last.is_some() && too_blurred(fine.blur) && wide.seen < before.0 {
            // Blurred beyond what the terms know: what was found on the level above is better.
            break;
        }
        last = Some((fine, level));
        if too_blurred(fine.blur) {
            break;
        }
        blur = Some(nearest(2.0 * BLURS[fine.blur]));
        at = fine.circle.scaled(2.0);
    }
    let (mut refined, level) = last?;
    if level == 0 && refined.seen >= CONFIDENT && refined.circle.radius >= POLISHED {
        let polished = polish(&pyramid.levels[0], refined.circle);
        if let Some(polished) = polished {
            refined.circle = polished.circle;
            refined.covariance = polished.covariance;
            refined.blur_px = polished.blur_px;
        }
    }
    let scale = f64::from(1_u32 << level);
    let c = refined.covariance;
    Some(Found {
        circle: refined.circle.scaled(scale),
        confidence: refined.seen.min(1.0),
        sigma_px: (0.5 * (c.x_axis.x + c.y_axis.y)).max(0.0).sqrt() * scale,
        sigma_radius_px: c.z_axis.z.max(0.0).sqrt() * scale,
        visible_fraction: refined.visible.min(1.0),
        blur_px: refined.blur_px * scale,
    })
}

/// Whether it is among the largest blurs, the next level of which is not known.
fn too_blurred(blur: usize) -> bool {
    blur + 2 >= BLURS.len()
}

/// The ball near where it was, if it is there.
fn near(pyramid: &Pyramid, hint: Circle) -> Option<Found> {
    if !(hint.radius >= SMALLEST) || !hint.centre.is_finite() {
        return None;
    }
    // The level whose search range is as wide as the ball may have moved.
    let reach = (0.02 * hint.radius).max(12.0);
    let level = (reach / MIDDLE.range).log2().ceil().max(0.0) as usize;
    let level = level.min(pyramid.levels.len() - 1);
    let found = descend(pyramid, hint.scaled(0.5_f64.powi(level as i32)), level)?;
    let same = (found.circle.radius / hint.radius - 1.0).abs() < 0.03
        && found.circle.centre.distance(hint.centre) < 2.0 * reach;
    let whole = cut(pyramid, found.circle, 0.5).is_none();
    (same && whole && found.confidence > CONFIDENT + 0.1).then_some(found)
}

/// The error of a circle that leaves the image by more than `slack` pixels.
fn cut(pyramid: &Pyramid, circle: Circle, slack: f64) -> Option<FindError> {
    let (w, h) = (pyramid.levels[0].width, pyramid.levels[0].height);
    let Circle { centre, radius } = circle;
    let over = [
        (Side::Left, radius - centre.x),
        (Side::Right, centre.x + radius - w as f64),
        (Side::Top, radius - centre.y),
        (Side::Bottom, centre.y + radius - h as f64),
    ];
    let sides: Vec<Side> = over
        .into_iter()
        .filter(|(_, by)| *by > slack)
        .map(|(side, _)| side)
        .collect();
    (!sides.is_empty()).then_some(FindError::Cut { circle, sides })
}
