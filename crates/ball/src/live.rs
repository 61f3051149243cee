//! Host file: the ball in frames as they come in: each pose from this frame and those before it.

use crate::circle::Circle;
use crate::find::{FindError, Found};
use crate::find::{find_in, reduced};
use crate::plane::Pyramid;
use crate::roll::Reference;
use crate::track::State;
use glam::{DVec2, UVec2, Vec4};

/// How a [`Tracker`] goes about it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TrackerOptions {
    /// Frames over which the radius is averaged.
    pub memory: u32,
    /// A radius that is off by more than this share of it, and by more than a pixel, is a mistake; the frame counts as
    /// rejected.
    pub tolerance: f64,
    /// After this many lost or rejected frames in a row the past is forgotten: the next ball may be of any size.
    pub patience: u32,
    /// Whether the roll is measured too.
    pub roll: bool,
}

impl Default for TrackerOptions {
    fn default() -> Self {
        Self {
            memory: 100,
            tolerance: 0.01,
            patience: 25,
            roll: true,
        }
    }
}

/// The ball in a frame.
#[derive(Clone, Debug, PartialEq)]
pub struct Pose {
    /// Number of the frame.
    pub frame: i32,
    /// Centre in pixels: the measured one, or the last that was.
    pub centre: DVec2,
    /// Radius in pixels, averaged over the frames so far.
    pub radius: f64,
    /// Turn against the first frame in radians, from +x towards +y.
    pub roll: f64,
    /// Whether this frame was measured; [`State::Interpolated`] here means held from before.
    pub state: State,
    /// What was measured.
    pub found: Result<Found, FindError>,
}

/// Follows a ball through frames.
#[derive(Clone, Debug)]
pub struct Tracker {
    options: TrackerOptions,
    last: Option<Circle>,
    count: u32,
    radius: f64,
    scatter: f64,
    missed: u32,
    roll: f64,
    /// The frame that rolls are measured against, and its own roll.
    key: Option<(Reference, f64)>,
    /// The frame before, likewise.
    before: Option<(Reference, f64)>,
}

/// Below this correlation with the key frame the one before is asked, and becomes the key.
const KEY_CONFIDENCE: f64 = 0.6;

impl Tracker {
    /// A tracker that has seen nothing.
    #[must_use]
    pub fn new(options: TrackerOptions) -> Self {
        Self {
            options,
            last: None,
            count: 0,
            radius: 0.0,
            scatter: 0.5,
            missed: 0,
            roll: 0.0,
            key: None,
            before: None,
        }
    }

    /// The pose in the next frame: `pixels` is the image, rows from the top.
    ///
    /// The centre is this frame's. The radius is a running mean over the last frames in which no frame moves it by more than
    /// its share of three standard deviations. In a frame without a ball centre and roll are those of the last one that had
    /// it.
    ///
    /// # Errors
    /// The reason why there is no ball, as long as there has not been one.
    pub fn push(&mut self, frame: i32, size: UVec2, pixels: &[Vec4]) -> Result<Pose, FindError> {
        let pyramid = reduced(size, pixels)?;
        let found = find_in(&pyramid, self.last);
        let state = match &found {
            Ok(found) if self.accepts(found) => State::Measured,
            Ok(_) => State::Rejected,
            Err(_) => State::Interpolated,
        };
        match (&found, state) {
            (Ok(found), State::Measured) => {
                self.missed = 0;
                self.learn(found.circle);
                if self.options.roll {
                    self.turn(&pyramid, found.circle);
                }
            }
            _ => {
                self.missed += 1;
                if self.missed > self.options.patience {
                    self.count = 0;
                }
            }
        }
        let Some(last) = self.last else {
            return Err(found.err().unwrap_or(FindError::NoBall { best: None }));
        };
        Ok(Pose {
            frame,
            centre: last.centre,
            radius: self.radius,
            roll: self.roll,
            state,
            found,
        })
    }

    fn accepts(&self, found: &Found) -> bool {
        let off = (found.circle.radius - self.radius).abs();
        self.count < 3 || off < (self.options.tolerance * self.radius).max(1.0)
    }

    fn learn(&mut self, circle: Circle) {
        self.last = Some(circle);
        self.count += 1;
        if self.count == 1 {
            self.radius = circle.radius;
            return;
        }
        let gain = 1.0 / f64::from(self.count.min(self.options.memory.max(1)));
        let off = circle.radius - self.radius;
        // The first frames find the scatter; later ones cannot pull beyond it.
        let limit = if self.count < 8 {
            f64::INFINITY
        } else {
            3.0 * self.scatter
        };
        self.radius += gain * off.clamp(-limit, limit);
        let size = 1.2533 * off.abs().min(limit);
        self.scatter += gain.max(0.05) * (size.max(0.01) - self.scatter);
    }

    fn turn(&mut self, pyramid: &Pyramid, circle: Circle) {
        let Some(now) = Reference::of(pyramid, circle) else {
            return;
        };
        let Some((key, base)) = &self.key else {
            self.key = Some((now.clone(), self.roll));
            self.before = Some((now, self.roll));
            return;
        };
        let by_key = key.roll_of(&now).map(|roll| (roll, base + roll.radians));
        match by_key.filter(|(roll, _)| roll.confidence > KEY_CONFIDENCE) {
            Some((_, total)) => self.roll = total,
            None => {
                let by_before = self.before.as_ref().and_then(|(before, base)| {
                    let roll = before.roll_of(&now)?;
                    Some(base + roll.radians)
                });
                if let Some(total) = by_before.or(by_key.map(|(_, total)| total)) {
                    self.roll = total;
                }
                self.key.clone_from(&self.before);
            }
        }
        self.before = Some((now, self.roll));
    }
}
