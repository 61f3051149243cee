//! Host file: the mirror ball in filmed frames: where it is to a fraction of a pixel, how far it is rolled, and what a whole
//! sequence says about both.
//!
//! A mirror ball films the light around it. To make a light map of such a film, its reader has to know the ball's outline in each
//! frame, and how the camera turned. This crate measures both in HDR frames, and needs nothing else of the scene.
//!
//! ```
//! use glam::{DVec2, UVec2, Vec4};
//! use glimt_ball::{Observation, Options, find, stabilise};
//!
//! // A dark ball before a bright wall; its sky is brighter than its ground.
//! let (size, centre, radius) = (UVec2::new(160, 120), DVec2::new(82.3, 59.6), 40.0);
//! let pixel = |i: u32| {
//!     let p = (DVec2::new((i % size.x).into(), (i / size.x).into()) + 0.5 - centre) / radius;
//!     let inside = (0.5 + (1.0 - p.length()) * radius).clamp(0.0, 1.0);
//!     let ball = 0.2 - 0.1 * p.y;
//!     Vec4::splat((1.0 + (ball - 1.0) * inside) as f32)
//! };
//! let frame: Vec<Vec4> = (0..size.x * size.y).map(pixel).collect();
//!
//! let found = find(size, &frame, None)?;
//! assert!(found.circle.centre.distance(centre) < 0.25);
//! assert!((found.circle.radius - radius).abs() < 0.25);
//!
//! // All frames of a shot, each with what was found in it: one pose a frame.
//! let seen = |frame| Observation { frame, found: Ok(found), roll: None, levels: None };
//! let tracked = stabilise(&[seen(1), seen(2)], &Options::default())?;
//! assert_eq!(tracked.poses.len(), 2);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # What is here
//!
//! | item | what it does |
//! |---|---|
//! | [`find`] | finds the outline of the ball in one frame, with its standard error, or says why there is none |
//! | [`roll::Reference`] | measures how far the ball of a frame is turned against another's |
//! | [`levels::Levels`] | tells a frame of another exposure from changed light |
//! | [`look()`] | does all three for one frame, and reduces its image once |
//! | [`stabilise`] | takes what was seen in all frames of a shot, and returns one pose a frame, with what is wrong said |
//! | [`Tracker`] | does the same while frames come in |
//!
//! # Conventions
//!
//! - An image is a size and its pixels, rows from the top: linear radiance in x, y and z; w is not read. Negative values and NaN
//!   count as black, and what is infinite as 10²⁰.
//! - Positions are in pixels: pixel (i, j), j from the top, has its centre at (i + ½, j + ½).
//! - Angles are radians. A positive roll turns the image from +x towards +y, which is clockwise on a screen.
//! - The ball lies in the frame as a whole, and its radius is at least 20 pixels.
//! - Work is done by rayon's threads; results do not depend on their number.

#![deny(unsafe_code)]

mod circle;
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

pub use circle::Circle;
pub use find::{FindError, Found, Side, find};
pub use live::{Pose, Tracker, TrackerOptions};
pub use look::{Look, look};
pub use track::{
    Drift, ExposureJump, Observation, Options, Quantity, State, TrackError, Tracked, TrackedPose,
    stabilise,
};
