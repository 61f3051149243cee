//! Host file: all that a sequence needs to know of one frame, from one reduction of its image.

use crate::circle::Circle;
use crate::find::{FindError, Found};
use crate::find::{find_in, reduced};
use crate::levels::Levels;
use crate::roll::Reference;
use glam::{UVec2, Vec4};

/// A frame, looked at.
#[derive(Clone, Debug)]
pub struct Look {
    /// The ball, or why there is none.
    pub found: Result<Found, FindError>,
    /// Its brightness; none without a ball.
    pub levels: Option<Levels>,
    /// Its rings, by which rolls are measured; none without a ball, or where they show nothing.
    pub rings: Option<Reference>,
}

/// Finds the ball as [`find`](crate::find()) does, and takes its levels and, where they are asked for, its rings.
#[must_use]
pub fn look(size: UVec2, pixels: &[Vec4], hint: Option<Circle>, rings: bool) -> Look {
    let pyramid = reduced(size, pixels);
    let found = pyramid
        .as_ref()
        .map_err(Clone::clone)
        .and_then(|pyramid| find_in(pyramid, hint));
    let seen = pyramid.as_ref().ok().zip(found.as_ref().ok());
    Look {
        levels: seen.map(|(pyramid, found)| Levels::of(pyramid, found.circle)),
        rings: seen
            .filter(|_| rings)
            .and_then(|(pyramid, found)| Reference::of(pyramid, found.circle)),
        found,
    }
}
