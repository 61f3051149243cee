//! Shared file: the mirror ball: which direction of the world a point of its photograph shows, and where a direction lies in it.
//!
//! The camera looks at the ball's centre from the distance D; the ball has radius r. Image points `p` are measured from the
//! centre of the ball's outline in units of the outline's radius: `x` to the right, `y` *down*, `|p| ≤ 1` on the ball. They
//! lie in a plane across the line from the camera to the ball's centre; a photograph in which the ball stands a little aside
//! differs from that by the square of a small angle.
//!
//! With `i` the angle of incidence on the mirror, a ray at the angle β from the axis has `sin β = (r/D) sin i`, and is
//! reflected to the angle `θ = 2i − β` from the direction back to the camera (law of sines in the triangle of camera, centre
//! and point hit). So `θ ≤ π − asin(r/D)`: a cone of half-angle `asin(r/D)` behind the ball is hidden. `r/D = 0` is an
//! orthographic camera: `|p| = sin(θ/2)`, every pixel shows the same solid angle, and the rim is one direction.

use core::f32::consts::PI;

use glam::{Vec2, Vec3};

/// A mirror ball and the camera that films it. It is no buffer type: Rust and WGSL may lay it out differently.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MirrorBall {
    /// Unit vector in the world from the camera to the ball's centre.
    pub forward: Vec3,
    /// Radius of the ball over its distance, r/D in [0, 1): the sine of the hidden cone's half-angle.
    pub radius_over_distance: f32,
    /// Unit vector in the world that is to the right in the image.
    pub right: Vec3,
    /// Unit vector in the world that is up in the image, `right × forward`.
    pub up: Vec3,
}

/// What the camera sees at a point of the ball.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reflection {
    /// Where the reflected ray goes: the direction that the image point shows. Unit length.
    pub direction: Vec3,
    /// The ball's normal where it is hit, which is also the point's place in units of r from the centre. Unit length.
    pub normal: Vec3,
    /// Cosine of the angle of incidence: 1 in the middle, 0 at the rim.
    pub cos_incidence: f32,
}

/// Newton steps from the orthographic solution. Four leave less than 1e-6 for every r/D up to 0.95.
const STEPS: u32 = 5;

impl MirrorBall {
    /// A ball seen along `forward`, with `up` up in the image (need not be perpendicular, only not parallel).
    ///
    /// `radius_over_distance` is clamped to [0, 0.95]. Axes that say nothing (zero, parallel, not finite) give those of a
    /// camera that looks along +x with +z up.
    ///
    /// ```
    /// use glam::{Vec2, Vec3};
    /// use glimt_probe::mirror_ball::MirrorBall;
    /// let ball = MirrorBall::new(Vec3::X, Vec3::Z, 0.0);
    /// // The middle shows the camera, the point at 45° between middle and rim what is to the side.
    /// assert_eq!(ball.image_to_direction(Vec2::ZERO), Some(Vec3::NEG_X));
    /// let right = ball.image_to_direction(Vec2::new(0.5_f32.sqrt(), 0.0)).unwrap();
    /// assert!((right - Vec3::NEG_Y).length() < 1e-6);
    /// ```
    #[must_use]
    pub fn new(forward: Vec3, up: Vec3, radius_over_distance: f32) -> MirrorBall {
        let across = forward.cross(up);
        let size = across.length_squared();
        let fine = size > 1e-12 * forward.length_squared() * up.length_squared() && size < f32::MAX;
        let f = if fine { forward.normalize() } else { Vec3::X };
        let r = if fine {
            across.normalize()
        } else {
            Vec3::NEG_Y
        };
        MirrorBall {
            forward: f,
            radius_over_distance: radius_over_distance.clamp(0.0, 0.95),
            right: r,
            up: r.cross(f),
        }
    }

    /// The same ball, its image turned by the angle whose cosine and sine are given, counter-clockwise: the camera rolled
    /// the other way.
    ///
    /// ```
    /// use glam::{Vec2, Vec3};
    /// use glimt_probe::mirror_ball::MirrorBall;
    /// let ball = MirrorBall::new(Vec3::X, Vec3::Z, 0.0);
    /// // What was on the right is up in the turned image.
    /// let turned = ball.image_turned(Vec2::new(0.0, 1.0));
    /// assert_eq!(
    ///     turned.image_to_direction(Vec2::new(0.0, -0.5)),
    ///     ball.image_to_direction(Vec2::new(0.5, 0.0)),
    /// );
    /// ```
    #[inline]
    #[must_use]
    pub fn image_turned(&self, cos_sin: Vec2) -> MirrorBall {
        MirrorBall {
            right: self.right * cos_sin.x - self.up * cos_sin.y,
            up: self.right * cos_sin.y + self.up * cos_sin.x,
            ..*self
        }
    }

    /// Half-angle in radians of the cone behind the ball, about `forward`, that no image point shows: `asin(r/D)`.
    #[inline]
    #[must_use]
    pub fn hidden_half_angle(&self) -> f32 {
        libm::asinf(self.radius_over_distance)
    }

    /// Whether the direction `d` (unit length) lies in the hidden cone.
    #[inline]
    #[must_use]
    pub fn is_hidden(&self, d: Vec3) -> bool {
        let k = self.radius_over_distance;
        d.dot(self.forward) > libm::sqrtf(1.0 - k * k)
    }

    /// Direction (unit length) that the image point `p` shows; `None` off the ball, `|p| > 1`.
    #[inline]
    #[must_use]
    pub fn image_to_direction(&self, p: Vec2) -> Option<Vec3> {
        let reflection = self.reflect(p)?;
        Some(reflection.direction)
    }

    /// What the camera sees at the image point `p`; `None` off the ball, `|p| > 1`.
    ///
    /// ```
    /// use glam::{Vec2, Vec3};
    /// use glimt_probe::mirror_ball::MirrorBall;
    /// let ball = MirrorBall::new(Vec3::X, Vec3::Z, 0.04);
    /// let rim = ball.reflect(Vec2::new(0.0, -1.0)).unwrap();
    /// assert_eq!(rim.cos_incidence, 0.0);
    /// // A grazing ray goes on as it came: on the edge of the hidden cone.
    /// assert!((rim.direction.angle_between(Vec3::X) - ball.hidden_half_angle()).abs() < 1e-3);
    /// assert!(ball.reflect(Vec2::new(0.8, 0.8)).is_none());
    /// ```
    #[inline]
    #[must_use]
    pub fn reflect(&self, p: Vec2) -> Option<Reflection> {
        let s2 = p.length_squared();
        if s2 > 1.0 {
            return None;
        }
        let k = self.radius_over_distance;
        let k2 = k * k;
        // sin i = s / √(1 − k²(1 − s²)); its cosine from the difference itself, which is exact towards the rim.
        let scale = 1.0 / libm::sqrtf(1.0 - k2 * (1.0 - s2));
        let s = libm::sqrtf(s2);
        let sin_i = s * scale;
        let cos_i = libm::sqrtf((1.0 - s2) * (1.0 - k2)) * scale;
        let sin_beta = k * sin_i;
        let cos_beta = libm::sqrtf(1.0 - sin_beta * sin_beta);
        // The normal stands at i − β, the reflected ray at i + (i − β).
        let sin_n = sin_i * cos_beta - cos_i * sin_beta;
        let cos_n = cos_i * cos_beta + sin_i * sin_beta;
        let sin_d = sin_i * cos_n + cos_i * sin_n;
        let cos_d = cos_i * cos_n - sin_i * sin_n;
        let across = if s > 0.0 {
            (self.right * p.x - self.up * p.y) / s
        } else {
            self.right
        };
        Some(Reflection {
            direction: across * sin_d - self.forward * cos_d,
            normal: across * sin_n - self.forward * cos_n,
            cos_incidence: cos_i,
        })
    }

    /// Cosine of the angle of incidence at which the mirror is seen at the image point `p`; 0 off the ball.
    #[inline]
    #[must_use]
    pub fn cos_incidence(&self, p: Vec2) -> f32 {
        let s2 = p.length_squared().min(1.0);
        let k2 = self.radius_over_distance * self.radius_over_distance;
        libm::sqrtf((1.0 - s2) * (1.0 - k2) / (1.0 - k2 * (1.0 - s2)))
    }

    /// Image point that shows the direction `d` (unit length); `None` in the hidden cone.
    ///
    /// Straight behind an orthographic camera's ball, where the whole rim would do, it is the rightmost point. The inverse
    /// of [`MirrorBall::image_to_direction`] to 2·10⁻⁶, but at the rim, where a wide angle is seen on a thin ring.
    ///
    /// ```
    /// use glam::{Vec2, Vec3};
    /// use glimt_probe::mirror_ball::MirrorBall;
    /// let ball = MirrorBall::new(Vec3::X, Vec3::Z, 0.04);
    /// assert_eq!(ball.direction_to_image(Vec3::NEG_X), Some(Vec2::ZERO));
    /// assert_eq!(ball.direction_to_image(Vec3::X), None);
    /// // What lies above is seen in the upper half.
    /// assert!(ball.direction_to_image(Vec3::Z).unwrap().y < -0.7);
    /// ```
    #[must_use]
    pub fn direction_to_image(&self, d: Vec3) -> Option<Vec2> {
        if self.is_hidden(d) {
            return None;
        }
        let side = Vec2::new(d.dot(self.right), -d.dot(self.up));
        let sin_d = side.length();
        let cos_d = -d.dot(self.forward);
        let k = self.radius_over_distance;
        // Half of θ is i where k = 0; from the larger of its sine and cosine, so that neither loses precision.
        let larger = libm::sqrtf(0.5 * (1.0 + cos_d.abs()));
        let smaller = 0.5 * sin_d / larger;
        let mut sin_i = if cos_d < 0.0 { larger } else { smaller };
        let mut cos_i = if cos_d < 0.0 { smaller } else { larger };
        for _ in 0..STEPS {
            let sin_beta = k * sin_i;
            let cos_beta = libm::sqrtf((1.0 - sin_beta * sin_beta).max(0.0));
            // sin(2i − β − θ), which is the error in θ once that is small.
            let sin_2i = 2.0 * sin_i * cos_i;
            let cos_2i = (cos_i - sin_i) * (cos_i + sin_i);
            let sin_t = sin_2i * cos_beta - cos_2i * sin_beta;
            let cos_t = cos_2i * cos_beta + sin_2i * sin_beta;
            let error = sin_t * cos_d - cos_t * sin_d;
            let step = error / (2.0 - k * cos_i / cos_beta.max(1e-3));
            let turned = Vec2::new(cos_i + step * sin_i, sin_i - step * cos_i).normalize();
            cos_i = turned.x;
            sin_i = turned.y;
        }
        let sin_beta = k * sin_i;
        let s = sin_i * libm::sqrtf((1.0 - k * k) / (1.0 - sin_beta * sin_beta));
        // A direction within rounding of the hidden cone may come out beyond the rim.
        let s = if cos_i > 0.0 { s.clamp(0.0, 1.0) } else { 1.0 };
        if sin_d > 0.0 {
            Some(side * (s / sin_d))
        } else {
            Some(Vec2::new(s, 0.0))
        }
    }

    /// Solid angle that the neighbourhood of the image point `p` shows, per unit of its area, in steradians; divided by
    /// the square of the outline's radius in pixels it is that of one pixel. 0 off the ball.
    ///
    /// `(sin θ / s) dθ/ds`. For an orthographic camera it is 4 everywhere; otherwise it grows without bound towards the
    /// rim, so it is taken at `|p| ≤ 0.999999`. Its integral over the disc is `2π (1 + √(1 − (r/D)²))`, all but the hidden
    /// cone.
    ///
    /// ```
    /// use glam::{Vec2, Vec3};
    /// use glimt_probe::mirror_ball::MirrorBall;
    /// let ball = MirrorBall::new(Vec3::X, Vec3::Z, 0.0);
    /// assert!((ball.solid_angle_sr_per_area(Vec2::new(0.3, 0.4)) - 4.0).abs() < 1e-5);
    /// assert_eq!(ball.solid_angle_sr_per_area(Vec2::ONE), 0.0);
    /// ```
    #[must_use]
    pub fn solid_angle_sr_per_area(&self, p: Vec2) -> f32 {
        let s2 = p.length_squared();
        if s2 > 1.0 {
            return 0.0;
        }
        let s2 = s2.min(0.999_998);
        let k = self.radius_over_distance;
        let k2 = k * k;
        let w = 1.0 / (1.0 - k2 * (1.0 - s2));
        let sin2_i = s2 * w;
        let cos_i = libm::sqrtf((1.0 - s2) * (1.0 - k2) * w);
        let cos_beta = libm::sqrtf(1.0 - k2 * sin2_i);
        // sin θ = 2 sin i cos i cos β − (1 − 2 sin² i) k sin i, and sin i / s = √w.
        let sin_over_s = (2.0 * cos_i * cos_beta - (1.0 - 2.0 * sin2_i) * k) * libm::sqrtf(w);
        let slope = (2.0 / cos_i - k / cos_beta) * (1.0 - k2) * w * libm::sqrtf(w);
        (sin_over_s * slope).clamp(0.0, 4.0 * PI * 1e4)
    }
}

/// Image point, in units of the outline's radius, of the pixel position `pixel` (pixel (i, j)'s centre at (i + ½, j + ½))
/// on a ball whose outline has the centre `centre` and the radius `radius`, both in pixels.
///
/// ```
/// use glam::Vec2;
/// use glimt_probe::mirror_ball::{image_to_pixel, pixel_to_image};
/// let (centre, radius) = (Vec2::new(100.0, 80.0), 50.0);
/// assert_eq!(pixel_to_image(Vec2::new(125.0, 80.0), centre, radius), Vec2::new(0.5, 0.0));
/// assert_eq!(image_to_pixel(Vec2::new(0.0, -1.0), centre, radius), Vec2::new(100.0, 30.0));
/// ```
#[inline]
#[must_use]
pub fn pixel_to_image(pixel: Vec2, centre: Vec2, radius: f32) -> Vec2 {
    (pixel - centre) / radius.max(1e-6)
}

/// Pixel position of an image point; the inverse of [`pixel_to_image`].
#[inline]
#[must_use]
pub fn image_to_pixel(p: Vec2, centre: Vec2, radius: f32) -> Vec2 {
    p * radius + centre
}
