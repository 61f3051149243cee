//! Host file: from where a shot is seen: a camera that stands, one that follows keyframes, or one of a glTF file.

use crate::error::{Error, Result};
use crate::mesh::animation::hermite;
use crate::shot::parse::Source;
use crate::shot::{self, Interpolation, Shot};
use glam::{DVec3, Mat3, Mat4, Vec3};
use glimt_render_gpu::prepare::scene::Camera;

/// The direction from which objects are looked at when a shot does not say: along +x, the middle of a lat-long map, from
/// a little to the side and above.
const VIEW_FROM: Vec3 = Vec3::new(-1.0, -0.45, 0.35);

/// From where a shot is seen.
#[derive(Clone, Debug)]
pub enum View {
    /// From one place.
    Fixed(Camera),
    /// Along keyframes.
    Keys(Track),
    /// As a camera of a mesh file.
    Model {
        /// Index of the object of the shot.
        object: usize,
        /// Index of its node.
        node: usize,
        /// Vertical field of view, in radians.
        fov_y: f32,
        /// Width of the image over its height.
        aspect: f32,
    },
}

/// A camera in one of the mesh files.
#[derive(Clone, Debug)]
pub struct FileCamera {
    /// Its name.
    pub name: String,
    /// Index of the object of the shot.
    pub object: usize,
    /// Index of its node.
    pub node: usize,
    /// Vertical field of view, in radians.
    pub fov_y: f32,
}

impl View {
    /// What the shot says, relative to `origin`; without a word of it, a camera that sees `bounds`.
    ///
    /// # Errors
    /// There is no glTF camera of that name.
    pub fn new(
        shot: &Shot,
        source: &Source,
        (low, high): (Vec3, Vec3),
        origin: DVec3,
        cameras: &[FileCamera],
    ) -> Result<Self> {
        let keys = &shot.camera;
        let [width, height] = shot.image.size.map(|n| n as f32);
        // In heights of a pixel.
        let width = width * shot.image.pixel_aspect;
        if !keys.gltf.is_empty() {
            let Some(found) = cameras.iter().find(|camera| camera.name == keys.gltf) else {
                let what = format!("no glTF file of the shot has a camera `{}`", keys.gltf);
                let names: Vec<&str> = cameras.iter().map(|c| c.name.as_str()).collect();
                let error = source.error("camera.gltf", what);
                return Err(match names.is_empty() {
                    true => error.fix("there is none at all: give eye and target"),
                    false => error.fix_name(&keys.gltf, &names),
                });
            };
            return Ok(Self::Model {
                object: found.object,
                node: found.node,
                fov_y: found.fov_y,
                aspect: width / height,
            });
        }
        if !keys.keys.is_empty() {
            return Ok(Self::Keys(Track::new(keys, origin)));
        }
        let fov_x = keys.fov_x_deg.to_radians();
        let target = keys
            .target
            .map_or((low + high) * 0.5, |p| relative(p, origin));
        let eye = keys.eye.map_or_else(
            || {
                // A sphere around the bounds fills most of the narrower side.
                let radius = ((high - low).length() * 0.5).max(1e-6);
                let half_x = (0.5 * fov_x).tan();
                let half = half_x.min(half_x * height / width).atan();
                target + VIEW_FROM.normalize() * (radius / half.sin())
            },
            |p| relative(p, origin),
        );
        Ok(Self::Fixed(Camera {
            eye,
            target,
            up: keys.up.into(),
            fov_x,
        }))
    }

    /// The camera of a frame; `place` says where a node of an object of the shot stands then.
    ///
    /// # Errors
    /// It looks nowhere, along its own up, or through no angle.
    pub fn at(
        &self,
        frame: i32,
        source: &Source,
        place: impl Fn(usize, usize) -> Mat4,
    ) -> Result<Camera> {
        match self {
            Self::Fixed(camera) => check(*camera, |key, what| {
                source.error(&format!("camera.{key}"), what)
            }),
            Self::Keys(track) => check(track.at(frame), |key, what| {
                let what = format!("in frame {frame} the {key} is wrong: {what}");
                source.error("camera.key", what)
            }),
            Self::Model {
                object,
                node,
                fov_y,
                aspect,
            } => {
                let to_world = place(*object, *node);
                let axes = Mat3::from_mat4(to_world);
                let eye = to_world.transform_point3(Vec3::ZERO);
                let camera = Camera {
                    eye,
                    target: eye - axes.z_axis.normalize(),
                    up: axes.y_axis.normalize(),
                    fov_x: 2.0 * ((0.5 * fov_y).tan() * aspect).atan(),
                };
                check(camera, |_, _| {
                    let what = format!("in frame {frame} its node is flattened to nothing");
                    source.error("camera.gltf", what)
                })
            }
        }
    }
}

fn relative(point: [f64; 3], origin: DVec3) -> Vec3 {
    (DVec3::from(point) - origin).as_vec3()
}

/// Refuses a camera that sees nothing; `error` makes the message of a key and what is wrong with it.
fn check(camera: Camera, error: impl Fn(&str, &str) -> Error) -> Result<Camera> {
    let Camera {
        eye, target, up, ..
    } = camera;
    if eye == target || !(eye.is_finite() && target.is_finite()) {
        return Err(error("target", "it is where the eye is")
            .fix("the camera must look somewhere: move one of them"));
    }
    let forward = (target.as_dvec3() - eye.as_dvec3()).normalize();
    if !(forward.cross(up.as_dvec3().normalize()).length() > 1e-6) {
        let across = match forward.abs().min_position() {
            0 => "[1, 0, 0]",
            1 => "[0, 1, 0]",
            _ => "[0, 0, 1]",
        };
        return Err(error("up", "it lies along the line of sight")
            .fix(format!("choose a direction across it, as {across}")));
    }
    if !(camera.fov_x > 0.0 && camera.fov_x < std::f32::consts::PI) {
        return Err(error("fov_x_deg", "it is not between 0 and 180").fix(
            "the curve through the keys overshoots: add a key, or set interpolation = \"linear\"",
        ));
    }
    Ok(camera)
}

/// A camera on a curve through keyframes, held before the first and after the last.
#[derive(Clone, Debug)]
pub struct Track {
    frames: Vec<f32>,
    /// Eye, target, up and field of view of each key.
    values: Vec<Numbers>,
    interpolation: Interpolation,
}

/// What of a camera is interpolated: eye, target, up, horizontal field of view in radians.
#[derive(Clone, Copy, Debug)]
struct Numbers([f32; 10]);

impl std::ops::Add for Numbers {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self(std::array::from_fn(|i| self.0[i] + other.0[i]))
    }
}

impl std::ops::Mul<f32> for Numbers {
    type Output = Self;
    fn mul(self, factor: f32) -> Self {
        Self(self.0.map(|n| n * factor))
    }
}

impl Track {
    /// The keys of a shot, at least one, their frames growing; relative to `origin`.
    fn new(keys: &shot::Camera, origin: DVec3) -> Self {
        let numbers = |key: &shot::CameraKey| {
            let mut list = [0.0; 10];
            list[..3].copy_from_slice(&relative(key.eye, origin).to_array());
            list[3..6].copy_from_slice(&relative(key.target, origin).to_array());
            list[6..9].copy_from_slice(&key.up.unwrap_or(keys.up));
            list[9] = key.fov_x_deg.unwrap_or(keys.fov_x_deg).to_radians();
            Numbers(list)
        };
        Self {
            frames: keys.keys.iter().map(|key| key.frame as f32).collect(),
            values: keys.keys.iter().map(numbers).collect(),
            interpolation: keys.interpolation,
        }
    }

    fn at(&self, frame: i32) -> Camera {
        let [ex, ey, ez, tx, ty, tz, ux, uy, uz, fov_x] = self.numbers(frame as f32).0;
        Camera {
            eye: Vec3::new(ex, ey, ez),
            target: Vec3::new(tx, ty, tz),
            up: Vec3::new(ux, uy, uz),
            fov_x,
        }
    }

    fn numbers(&self, frame: f32) -> Numbers {
        let after = self.frames.partition_point(|&key| key <= frame);
        if after == 0 {
            return self.values[0];
        }
        let key = after - 1;
        if after == self.frames.len() {
            return self.values[key];
        }
        let span = self.frames[after] - self.frames[key];
        let s = (frame - self.frames[key]) / span;
        let ends = [self.values[key], self.values[after]];
        match self.interpolation {
            Interpolation::Linear => ends[0] * (1.0 - s) + ends[1] * s,
            Interpolation::Smooth => {
                let slopes = [self.slope(key) * span, self.slope(after) * span];
                hermite(s, ends, slopes)
            }
        }
    }

    /// The derivative by frames at a key: of the parabola through it and both its neighbours; at an end that of the line to the
    /// only one.
    fn slope(&self, key: usize) -> Numbers {
        let line = |from: usize| {
            let span = self.frames[from + 1] - self.frames[from];
            let change = self.values[from + 1] + self.values[from] * -1.0;
            (change * (1.0 / span), span)
        };
        let before = key.checked_sub(1).map(line);
        let behind = (key + 1 < self.frames.len()).then(|| line(key));
        match (before, behind) {
            (Some((a, span_a)), Some((b, span_b))) => {
                (a * span_b + b * span_a) * (1.0 / (span_a + span_b))
            }
            (Some((only, _)), None) | (None, Some((only, _))) => only,
            (None, None) => self.values[key] * 0.0,
        }
    }
}
