//! Host file: the mirror ball in frames as they come, and what is said when it is not where it should be.

use crate::capture::{Poses, locate};
use crate::error::{Error, Result};
use crate::input::light_image::LightImage;
use crate::notes::Notes;
use crate::shot;
use glimt_ball::levels::Levels;
use glimt_ball::{Circle, State, Tracker, TrackerOptions};
use glimt_render_gpu::prepare::unwarp::BallPose;
use std::path::Path;

/// Frames further apart than this are not compared: the light itself may have changed, as when the sun has moved on.
const NEAR: i32 = 4;

/// Follows the ball of a shot.
pub(super) struct Ball {
    /// Its place, if the shot gives it.
    given: Option<BallPose>,
    tracker: Tracker,
    /// How bright it was in the last frame that showed it.
    levels: Option<(i32, Levels)>,
}

impl Ball {
    /// The ball of these keys.
    pub(super) fn new(keys: &shot::Ball) -> Self {
        let options = TrackerOptions {
            roll: keys.steady,
            ..TrackerOptions::default()
        };
        Self {
            given: Poses::given(keys).and_then(|poses| poses.of(1)),
            tracker: Tracker::new(options),
            levels: None,
        }
    }

    /// Where it is in a frame: as the shot says, or found; where it was before, if it is lost.
    ///
    /// # Errors
    /// It has not been seen yet.
    pub(super) fn locate(
        &mut self,
        frame: i32,
        file: &Path,
        photo: &LightImage,
        notes: &mut Notes,
    ) -> Result<BallPose> {
        if let Some(given) = self.given {
            return Ok(given);
        }
        let pose = self
            .tracker
            .push(frame, photo.size, &photo.pixels)
            .map_err(|e| Error::input(file, e))?;
        match (&pose.found, pose.state) {
            (Ok(found), State::Measured) => {
                self.compare(frame, file, photo, found.circle, notes);
            }
            (Ok(found), _) => notes.warn(
                file,
                format!(
                    "what is found, {}, is not the ball's radius of {:.1} px: its last place is held",
                    found.circle, pose.radius
                ),
            ),
            (Err(lost), _) => {
                notes.warn(
                    file,
                    format!("the ball is lost: {lost}; its last place is held"),
                );
            }
        }
        Ok(locate::pose_of(pose.centre, pose.radius, pose.roll))
    }

    /// Says so where the whole ball became brighter or darker by one factor.
    fn compare(
        &mut self,
        frame: i32,
        file: &Path,
        photo: &LightImage,
        circle: Circle,
        notes: &mut Notes,
    ) {
        let levels = Levels::new(photo.size, &photo.pixels, circle);
        if let Some((before, then)) = &self.levels
            && frame.saturating_sub(*before) <= NEAR
            && let Some(change) = levels.change_from(then).filter(|c| c.is_step())
        {
            let factor = change.stops.exp2();
            notes.warn(
                file,
                format!(
                    "all of the ball is {factor:.2} times as bright as in frame {before}: another exposure? Nothing is corrected"
                ),
            );
        }
        self.levels = Some((frame, levels));
    }
}
