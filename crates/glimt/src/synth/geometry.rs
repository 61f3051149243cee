//! Host file: where the ball, the cameras and what passes are in a frame, and how the camera shakes.

use super::settings::Synth;
use glam::{DMat3, DVec2, DVec3, UVec2, Vec3, dvec2};
use glimt_probe::mirror_ball::MirrorBall;
use glimt_render_gpu::kernels::capture::CaptureParams;
use glimt_render_gpu::prepare::scene::Camera;
use glimt_sampling::hash::hash2;
use glimt_sampling::uniform::UniformSource;
use glimt_sampling::xoshiro::Xoshiro128PlusPlus;
use serde::Serialize;
use std::f64::consts::TAU;

/// What uniforms are for: the camera's shake.
const SHAKE: u32 = 12;

/// What is true of a frame.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct FrameTruth {
    /// The frame's number.
    pub frame: u32,
    /// Centre of the ball's outline in pixels; pixel (i, j)'s centre is (i + ½, j + ½).
    pub centre_px: [f64; 2],
    /// Radius of the outline in pixels. The outline is an ellipse; its axes differ by 10⁻⁶ of this.
    pub radius_px: f64,
    /// Angle by which the image is turned, counter-clockwise, in degrees: what `MirrorBall::image_turned` takes.
    pub roll_deg: f64,
    /// Axes of the shaken camera in the world: right, up, forward.
    pub camera: [[f64; 3]; 3],
    /// Its centre of projection in metres.
    pub eye_m: [f64; 3],
    /// The ball's centre in metres.
    pub probe_m: [f64; 3],
    /// The sun; none where there is none.
    pub sun: Option<SunTruth>,
}

/// Where the sun stands and what it gives.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct SunTruth {
    /// Direction towards it in the world, unit length.
    pub direction: [f64; 3],
    /// Irradiance on what faces it, above that of the sky behind it, before clouds; linear RGB.
    pub irradiance: [f64; 3],
}

/// How the camera stands in a frame, against where it was set up: turned about its centre of projection.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shake {
    /// Columns: the shaken camera's axes (right, down, forward) in those of the steady one.
    pub axes: DMat3,
}

impl Shake {
    /// The shake of a frame: normal numbers by (seed, frame).
    pub fn of_frame(synth: &Synth, frame: u32) -> Self {
        let mut source = Xoshiro128PlusPlus::stream(hash2(synth.seed, SHAKE), frame, 0);
        let mut normal = || {
            let mut unit = || f64::from(source.next_u32()) / 2f64.powi(32);
            let (a, b) = (unit(), unit());
            (-2.0 * (1.0 - a).ln()).sqrt() * (TAU * b).cos()
        };
        let angle = f64::from(synth.capture.jitter_px) / focal_px(synth);
        let roll = f64::from(synth.capture.jitter_roll_deg).to_radians();
        let pan = DMat3::from_rotation_y(angle * normal());
        let tilt = DMat3::from_rotation_x(angle * normal());
        Self {
            axes: pan * tilt * DMat3::from_rotation_z(roll * normal()),
        }
    }

    /// The rows that kernels take: the steady camera's coordinates of the shaken one's.
    fn rows(&self) -> [Vec3; 3] {
        let rows = self.axes.transpose();
        [rows.x_axis, rows.y_axis, rows.z_axis].map(|row| row.as_vec3())
    }
}

/// Focal length in pixels.
pub(super) fn focal_px(synth: &Synth) -> f64 {
    f64::from(synth.capture.lens_mm) * 1000.0 / f64::from(synth.capture.pixel_um)
}

/// Sine of the angle between the ball's centre and its outline, r/D.
pub(super) fn radius_over_distance(synth: &Synth) -> f64 {
    f64::from(synth.capture.radius_mm) / f64::from(synth.capture.distance_mm)
}

/// The ball as the steady camera sees it.
pub(super) fn ball(synth: &Synth) -> MirrorBall {
    MirrorBall::new(
        Vec3::from(synth.capture.forward),
        Vec3::from(synth.capture.up),
        radius_over_distance(synth) as f32,
    )
}

/// Place of a frame in the capture: 0 at its first frame, 1 at its last.
pub(super) fn time_of(synth: &Synth, frame: u32) -> f64 {
    f64::from(frame.saturating_sub(1)) / f64::from(synth.frames.saturating_sub(1).max(1))
}

/// The point between two, at a frame's time.
pub(super) fn on_path(synth: &Synth, frame: u32, from: [f32; 3], to: [f32; 3]) -> DVec3 {
    let ends = [from, to].map(|p| Vec3::from(p).as_dvec3());
    ends[0].lerp(ends[1], time_of(synth, frame))
}

/// The ball's centre, and the ball camera's centre of projection, in metres.
pub(super) fn probe_and_eye(synth: &Synth, frame: u32) -> (DVec3, DVec3) {
    let probe = on_path(synth, frame, synth.stage.from_m, synth.stage.to_m);
    let distance = f64::from(synth.capture.distance_mm) * 1e-3;
    (probe, probe - ball(synth).forward.as_dvec3() * distance)
}

/// Centre and radius in pixels of the ball's outline: the ellipse in which the image plane cuts the cone around the ball.
fn outline(synth: &Synth, shake: &Shake) -> (DVec2, f64) {
    // The ball's direction for the shaken camera: x right, y down, z forward.
    let to_ball = shake.axes.transpose().z_axis;
    let half_angle = radius_over_distance(synth).asin();
    let aside = dvec2(to_ball.x, to_ball.y);
    let tilt = aside.length().atan2(to_ball.z);
    // From tan(tilt − half angle) to tan(tilt + half angle) along the tilt.
    let sum = (2.0 * tilt).cos() + (2.0 * half_angle).cos();
    let along = (2.0 * half_angle).sin() / sum;
    // Across it, the cone at the ellipse's middle: cos²(half angle) (z sin tilt + cos tilt)² ≤ ... solved for the half width.
    let middle = (2.0 * tilt).sin() / sum;
    let reach = (middle * tilt.sin() + tilt.cos()) / half_angle.cos();
    let across = (reach * reach - middle * middle - 1.0).max(0.0).sqrt();
    let focal = focal_px(synth);
    let image = UVec2::from(synth.capture.size).as_dvec2() * 0.5;
    let direction = aside.try_normalize().unwrap_or(DVec2::ZERO);
    (
        image + direction * (middle * focal),
        0.5 * (along + across) * focal,
    )
}

/// What is true of a frame whose sun is known.
pub(super) fn truth_of(synth: &Synth, frame: u32, sun: Option<SunTruth>) -> FrameTruth {
    let shake = Shake::of_frame(synth, frame);
    let (centre, radius_px) = outline(synth, &shake);
    let (probe, eye) = probe_and_eye(synth, frame);
    let steady = ball(synth);
    let world = |v: DVec3| {
        let [right, up, forward] = [steady.right, steady.up, steady.forward].map(|a| a.as_dvec3());
        (right * v.x - up * v.y + forward * v.z).to_array()
    };
    let axes = shake.axes;
    // The steady camera's right in the image of the shaken one; y points down.
    let turned = axes.transpose().x_axis;
    FrameTruth {
        frame,
        centre_px: centre.to_array(),
        radius_px,
        roll_deg: (-turned.y).atan2(turned.x).to_degrees(),
        camera: [world(axes.x_axis), world(-axes.y_axis), world(axes.z_axis)],
        eye_m: eye.to_array(),
        probe_m: probe.to_array(),
        sun,
    }
}

/// What the filming kernel takes for a frame, under a given radiance of the rig.
pub(super) fn capture_params(synth: &Synth, frame: u32, rig_radiance: Vec3) -> CaptureParams {
    let (probe, eye) = probe_and_eye(synth, frame);
    let [shake_x, shake_y, shake_z] = Shake::of_frame(synth, frame).rows();
    let (capture, steady) = (&synth.capture, ball(synth));
    let k = radius_over_distance(synth);
    CaptureParams {
        shake_x,
        width: capture.size[0],
        shake_y,
        height: capture.size[1],
        shake_z,
        focal_px: focal_px(synth) as f32,
        ball_centre: probe.as_vec3(),
        ball_radius: capture.radius_mm * 1e-3,
        forward: steady.forward,
        radius_over_distance: steady.radius_over_distance,
        right: steady.right,
        outline: k.asin().tan() as f32,
        up: steady.up,
        samples: capture.supersampling,
        tint: Vec3::from(synth.ball.tint),
        fresnel: f32::from(u8::from(synth.ball.fresnel)),
        eye: eye.as_vec3(),
        unused_a: 0,
        rig_half_size: if synth.rig.on {
            Vec3::from(synth.rig.half_size_m)
        } else {
            Vec3::ZERO
        },
        unused_b: 0,
        rig_radiance,
        unused_c: 0,
    }
}

/// The plate's camera in a frame.
pub(super) fn plate_camera(synth: &Synth, frame: u32) -> Camera {
    let (_, eye) = probe_and_eye(synth, frame);
    let steady = ball(synth);
    let offset = Vec3::from(synth.plate.offset_m);
    let eye =
        eye.as_vec3() + steady.right * offset.x + steady.up * offset.y + steady.forward * offset.z;
    let direction = synth.plate.direction.map_or(steady.forward, Vec3::from);
    Camera {
        eye,
        target: eye + direction.normalize_or(Vec3::X),
        up: Vec3::from(synth.capture.up),
        fov_x: synth.plate.fov_x_deg.to_radians(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::dvec3;

    /// The outline's centre and radius are those of points that graze the ball, projected one by one.
    #[test]
    fn the_outline_is_where_rays_graze() {
        let mut synth = Synth::default();
        synth.capture.jitter_px = 10.0;
        for (frame, radius_mm) in [(1, 50.0), (2, 40.0), (3, 25.0), (4, 400.0)] {
            synth.capture.radius_mm = radius_mm;
            let shake = Shake::of_frame(&synth, frame);
            let truth = truth_of(&synth, frame, None);
            let k = radius_over_distance(&synth);
            let outline = k.asin().tan();
            let centre = DVec2::from(truth.centre_px);
            for i in 0..16 {
                let (sin, cos) = (TAU * f64::from(i) / 16.0).sin_cos();
                let steady = dvec3(outline * cos, outline * sin, 1.0);
                let seen = shake.axes.transpose() * steady;
                let pixel = dvec2(seen.x, seen.y) / seen.z * focal_px(&synth)
                    + UVec2::from(synth.capture.size).as_dvec2() * 0.5;
                let off = pixel.distance(centre) - truth.radius_px;
                assert!(off.abs() < 2e-6 * truth.radius_px, "{frame} {i}: {off}");
            }
        }
        assert_eq!(truth_of(&synth, 9, None), truth_of(&synth, 9, None));
        assert_ne!(
            truth_of(&synth, 9, None).roll_deg,
            truth_of(&synth, 8, None).roll_deg
        );
    }

    #[test]
    fn the_shake_has_the_size_that_is_asked_for() {
        let synth = Synth {
            frames: 4000,
            ..Synth::default()
        };
        let n = f64::from(synth.frames);
        let sum = |f: &dyn Fn(&FrameTruth) -> f64| {
            (1..=synth.frames)
                .map(|frame| f(&truth_of(&synth, frame, None)).powi(2))
                .sum::<f64>()
        };
        let rms = |f: &dyn Fn(&FrameTruth) -> f64| (sum(f) / n).sqrt();
        assert!((rms(&|t| t.centre_px[0] - 1200.0) - 2.0).abs() < 0.1);
        assert!((rms(&|t| t.centre_px[1] - 850.0) - 2.0).abs() < 0.1);
        assert!((rms(&|t| t.roll_deg) - 0.1).abs() < 0.005);
    }
}
