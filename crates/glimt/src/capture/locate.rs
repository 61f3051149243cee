//! Host file: where the mirror ball is in each frame of a capture.

use super::Poses;
use crate::error::{Error, Result};
use crate::input::Reading;
use crate::input::frames::FrameFiles;
use crate::input::light_image::read_photo;
use crate::notes::Notes;
use crate::shot;
use glam::DVec2;
use glimt_ball::roll::Reference;
use glimt_ball::{
    FindError, Look, Observation, Options, TrackError, Tracked, TrackedPose, look, stabilise,
};
use glimt_probe::unwarp::Outline;
use glimt_render_gpu::prepare::unwarp::BallPose;

/// Finds the ball in all of these frames and steadies what was found; `progress` is called with how many frames are done, and of
/// how many.
///
/// # Errors
/// A frame cannot be read, or too few of them show a ball.
pub fn track(
    files: &FrameFiles,
    frames: &[i32],
    steady: bool,
    reading: &Reading,
    notes: &mut Notes,
    progress: &(dyn Fn(usize, usize) + Sync),
) -> Result<Tracked> {
    let mut observations = Vec::with_capacity(frames.len());
    let mut hint = None;
    let mut reference: Option<Reference> = None;
    // A still is one image for all frames.
    let looked_at = if files.is_still() {
        &frames[..1]
    } else {
        frames
    };
    for (done, &frame) in looked_at.iter().enumerate() {
        let photo = read_photo(&files.path(frame), reading, notes)?;
        let Look {
            found,
            levels,
            rings,
        } = look(photo.size, &photo.pixels, hint, steady);
        hint = found.as_ref().map_or(hint, |found| Some(found.circle));
        let mut roll = None;
        match (&reference, rings) {
            (Some(reference), Some(own)) => roll = reference.roll_of(&own),
            (None, own) => reference = own,
            _ => {}
        }
        observations.push(Observation {
            frame,
            found,
            roll,
            levels,
        });
        progress(done + 1, looked_at.len());
    }
    let options = Options {
        rolls: steady,
        ..Options::default()
    };
    let tracked =
        stabilise(&observations, &options).map_err(|e| refused(&e, files, &observations))?;
    for text in &tracked.notes {
        notes.warn(&files.path(frames[0]), text);
    }
    Ok(tracked)
}

/// The reason of the first frame without a ball, where there is one: it says more than their number.
fn refused(error: &TrackError, files: &FrameFiles, observations: &[Observation]) -> Error {
    let failed = observations
        .iter()
        .find_map(|o| o.found.as_ref().err().map(|e| (o.frame, e)));
    let Some((frame, reason)) = failed else {
        return Error::input(
            &files.path(observations.first().map_or(1, |o| o.frame)),
            error,
        );
    };
    let fix = match reason {
        FindError::Two(..) => "crop the frames, or give probe.ball.centre_px and radius_px",
        FindError::Cut { .. } => "film the ball whole, with some background around it",
        _ => "give probe.ball.centre_px and radius_px, or leave out the frames without a ball",
    };
    let error = match observations.len() {
        1 => Error::input(&files.path(frame), reason),
        _ => Error::input(&files.path(frame), format!("{reason} ({error})")),
    };
    error.fix(fix)
}

/// The poses of a capture whose shot does not give them.
///
/// # Errors
/// As [`track`].
pub fn poses(
    files: &FrameFiles,
    frames: &[i32],
    keys: &shot::Ball,
    reading: &Reading,
    notes: &mut Notes,
    progress: &(dyn Fn(usize, usize) + Sync),
) -> Result<Poses> {
    let tracked = track(files, frames, keys.steady, reading, notes, progress)?;
    if files.is_still() {
        return Ok(Poses::Fixed(pose(&tracked.poses[0])));
    }
    Ok(of_track(&tracked))
}

/// The poses of a track. A camera that shakes is upright on average, not in the frame that the others were compared with.
pub fn of_track(tracked: &Tracked) -> Poses {
    let count = tracked.poses.len() as f64;
    let mean = tracked.poses.iter().map(|p| p.roll).sum::<f64>() / count;
    let upright = |tracked: &TrackedPose| {
        let roll = tracked.roll - mean;
        (tracked.frame, pose(&TrackedPose { roll, ..*tracked }))
    };
    Poses::Found(tracked.poses.iter().map(upright).collect())
}

/// A tracked ball as the renderer takes it.
pub fn pose(tracked: &TrackedPose) -> BallPose {
    pose_of(tracked.centre, tracked.radius, tracked.roll)
}

/// A ball as the renderer takes it, whose roll counts the other way round.
pub fn pose_of(centre: DVec2, radius: f64, roll: f64) -> BallPose {
    BallPose {
        outline: Outline {
            centre: centre.as_vec2(),
            radius: radius as f32,
        },
        roll: -roll as f32,
    }
}
