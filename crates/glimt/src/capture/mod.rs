//! Host file: film of a mirror ball as light: photographs in, found and steadied, lat-long maps out.

pub mod locate;

use crate::error::{Error, Result};
use crate::shot;
use glam::{UVec2, Vec2, Vec3};
use glimt_probe::gather::ColourMatrix;
use glimt_probe::mirror_ball::MirrorBall;
use glimt_probe::unwarp::Outline;
use glimt_render_gpu::prepare::unwarp::{BallPose, Look, UnwarpGrid, UnwarpMap, UnwarpOptions};
use std::collections::BTreeMap;
use std::path::Path;
use std::sync::{Arc, Mutex, PoisonError};

/// Where the ball is in each frame.
#[derive(Clone, Debug, PartialEq)]
pub enum Poses {
    /// In the same place in all of them.
    Fixed(BallPose),
    /// As found.
    Found(BTreeMap<i32, BallPose>),
}

impl Poses {
    /// The place in a frame.
    pub fn of(&self, frame: i32) -> Option<BallPose> {
        match self {
            Self::Fixed(pose) => Some(*pose),
            Self::Found(poses) => poses.get(&frame).copied(),
        }
    }

    /// The pose that the keys of a shot give, if they do.
    pub fn given(keys: &shot::Ball) -> Option<Self> {
        let (centre, radius) = (keys.centre_px?, keys.radius_px?);
        Some(Self::Fixed(BallPose {
            outline: Outline {
                centre: Vec2::from(centre),
                radius,
            },
            roll: 0.0,
        }))
    }

    /// Radius in pixels in the first frame.
    fn radius(&self) -> f32 {
        match self {
            Self::Fixed(pose) => pose.outline.radius,
            Self::Found(poses) => poses.values().next().map_or(1.0, |p| p.outline.radius),
        }
    }
}

/// A camera that films a mirror ball, and where the ball is in its frames.
#[derive(Debug)]
pub struct Capture {
    grid: UnwarpGrid,
    options: UnwarpOptions,
    reflectance: Vec3,
    poses: Poses,
    /// The table that was made last: most frames of a steady camera share one.
    last: Mutex<Option<(BallPose, UVec2, Arc<UnwarpMap>)>>,
}

/// The ball and camera of a shot's keys.
pub fn mirror_ball(keys: &shot::Ball) -> MirrorBall {
    let ratio = keys.radius_mm / keys.distance_mm;
    MirrorBall::new(Vec3::from(keys.forward), Vec3::from(keys.up), ratio)
}

impl Capture {
    /// The capture that the keys of a shot describe.
    pub fn new(keys: &shot::Ball, poses: Poses) -> Self {
        let rows = poses.radius().round().clamp(1.0, 8192.0) as u32;
        let size = keys.size.map_or(UVec2::new(2 * rows, rows), UVec2::from);
        Self {
            grid: UnwarpGrid::new(mirror_ball(keys), size),
            options: UnwarpOptions {
                rim_px: keys.rim_px,
                rig_half_angle: keys.rig_deg.to_radians(),
            },
            reflectance: Vec3::from(keys.reflectance),
            poses,
            last: Mutex::new(None),
        }
    }

    /// Size of its light maps.
    pub fn size(&self) -> UVec2 {
        self.grid.size()
    }

    /// Where the ball is.
    pub fn poses(&self) -> &Poses {
        &self.poses
    }

    /// The table for a frame whose photograph has this size.
    ///
    /// # Errors
    /// The ball is not within it.
    pub fn map(&self, frame: i32, file: &Path, photo: UVec2) -> Result<Arc<UnwarpMap>> {
        let pose = self.poses.of(frame).ok_or_else(|| {
            Error::input(
                file,
                format!("the ball was not looked for in frame {frame}"),
            )
        })?;
        self.map_at(&pose, file, photo)
    }

    /// The table for a photograph in which the ball stands so.
    ///
    /// # Errors
    /// The ball is not within it.
    pub fn map_at(&self, pose: &BallPose, file: &Path, photo: UVec2) -> Result<Arc<UnwarpMap>> {
        let mut last = self.last.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((known, size, map)) = last.as_ref()
            && (known, *size) == (pose, photo)
        {
            return Ok(Arc::clone(map));
        }
        let map = self.grid.map(pose, photo, &self.options).map_err(|e| {
            let Outline { centre, radius } = pose.outline;
            let what = format!(
                "{e}: its centre is ({:.1}, {:.1}), its radius {radius:.1}",
                centre.x, centre.y
            );
            Error::input(file, what).fix(
                "film it whole; or check probe.ball.centre_px and radius_px, if they are given",
            )
        })?;
        let map = Arc::new(map);
        *last = Some((*pose, photo, Arc::clone(&map)));
        Ok(map)
    }

    /// How light that the ball reflected becomes light of the shot.
    pub fn look(&self, colour: &ColourMatrix) -> Look {
        Look {
            reflectance: self.reflectance,
            colour: *colour,
        }
    }
}
