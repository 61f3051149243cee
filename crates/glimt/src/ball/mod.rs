//! Host file: the mirror ball in filmed frames: where it is to a fraction of a pixel, how far it is rolled, and what a whole
//! sequence says about both.
//!
//! [`find`] looks at one frame. [`roll::Reference`] compares a frame with another. [`stabilise`] takes what was seen in all
//! frames of a shot and returns one pose a frame, with what is wrong said; [`Tracker`] does the same while frames come in.
//!
//! Positions are in pixels: pixel (i, j), j from the top, has its centre at (i + ½, j + ½). Angles are radians; a positive
//! roll turns the image from +x towards +y, which is clockwise on a screen.

mod coarse;
mod edge;
mod find;
pub mod levels;
mod live;
mod look;
mod plane;
mod polish;
mod refine;
mod robust;
pub mod roll;
mod track;

pub use find::{FindError, Found, Side, find};
pub use live::{Pose, Tracker, TrackerOptions};
pub use look::{Look, look};
pub use track::{
    Drift, ExposureJump, Observation, Options, Quantity, State, TrackError, Tracked, TrackedPose,
    stabilise,
};

use glam::DVec2;

/// The outline of a ball.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Circle {
    /// Centre in pixels.
    pub centre: DVec2,
    /// Radius in pixels.
    pub radius: f64,
}

impl Circle {
    /// The same circle in an image whose pixels are `1 / factor` times as large.
    #[must_use]
    pub fn scaled(self, factor: f64) -> Self {
        Self {
            centre: self.centre * factor,
            radius: self.radius * factor,
        }
    }
}

impl std::fmt::Display for Circle {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { centre, radius } = self;
        write!(f, "({:.1}, {:.1}) r {radius:.1} px", centre.x, centre.y)
    }
}
