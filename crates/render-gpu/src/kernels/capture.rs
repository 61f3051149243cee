//! Shared file: a simulated camera that films a mirror ball, a second one that films a backplate, and the lat-long map that an
//! ideal probe in the ball's place records. One element is one pixel of the image, or one texel of the map.

use glam::{UVec2, Vec2, Vec3, Vec4};
use glimt_probe::latlong::direction_in_texel;
use glimt_probe::mirror_ball::MirrorBall;

use super::frame::FrameParams;
use super::stage::{NO_HIT, Stage};

/// The most samples along a side of a pixel.
const MOST_ALONG_SIDE: f32 = 32.0;

/// The camera before the ball, in metres and pixels. 176 bytes.
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct CaptureParams {
    /// First row of the shake: how the steady camera's image x depends on the shaken camera's (x, y, depth).
    pub shake_x: Vec3,
    /// Width of the image in pixels.
    pub width: u32,
    /// Second row of the shake, for y, which points down.
    pub shake_y: Vec3,
    /// Height of the image in pixels.
    pub height: u32,
    /// Third row of the shake, for the depth.
    pub shake_z: Vec3,
    /// Focal length in pixels.
    pub focal_px: f32,
    /// The ball's centre.
    pub ball_centre: Vec3,
    /// The ball's radius.
    pub ball_radius: f32,
    /// From the camera to the ball's centre, unit length.
    pub forward: Vec3,
    /// The ball's radius over its distance.
    pub radius_over_distance: f32,
    /// To the right in the image, unit length.
    pub right: Vec3,
    /// Tangent of the angle between the ball's centre and its outline.
    pub outline: f32,
    /// Up in the image, unit length.
    pub up: Vec3,
    /// Samples of a pixel that shows one texel of the map.
    pub samples: u32,
    /// The ball's reflectance at normal incidence, for each channel.
    pub tint: Vec3,
    /// 1 where the reflectance rises to 1 towards the rim (Schlick 1994), 0 where it is the same everywhere.
    pub fresnel: f32,
    /// Centre of projection, about which the box of the rig stands.
    pub eye: Vec3,
    /// Fills 16 bytes.
    pub unused_a: u32,
    /// Half of the rig's extent to the right, up and forward; zero for none.
    pub rig_half_size: Vec3,
    /// Fills 16 bytes.
    pub unused_b: u32,
    /// The rig's radiance.
    pub rig_radiance: Vec3,
    /// Fills 16 bytes.
    pub unused_c: u32,
}

impl CaptureParams {
    /// The ball as the steady camera sees it.
    #[inline]
    #[must_use]
    pub fn ball(&self) -> MirrorBall {
        MirrorBall {
            forward: self.forward,
            radius_over_distance: self.radius_over_distance,
            right: self.right,
            up: self.up,
        }
    }

    /// The ball's image point (see [`MirrorBall`]) at a pixel position. Exact for every shake: the point lies on the plane
    /// across the line to the ball's centre.
    #[inline]
    #[must_use]
    pub fn image_point(&self, pixel: Vec2) -> Vec2 {
        let middle = Vec2::new(self.width as f32, self.height as f32) * 0.5;
        let on_sensor = ((pixel - middle) / self.focal_px).extend(1.0);
        let depth = self.shake_z.dot(on_sensor).max(1e-6);
        Vec2::new(self.shake_x.dot(on_sensor), self.shake_y.dot(on_sensor)) / (depth * self.outline)
    }

    /// Samples along each side of a pixel whose centre is the image point `p`. Their square is about `samples` where the pixel
    /// shows one texel of the map, in proportion where it shows less or more, and more towards the rim, where it shows a long
    /// thin part. One where it shows the background.
    #[inline]
    #[must_use]
    pub fn samples_along_side(&self, p: Vec2, map_size: UVec2) -> u32 {
        let radius_px = self.focal_px * self.outline;
        let reach = 0.75 / radius_px;
        let s = p.length();
        if s > 1.0 + reach {
            return 1;
        }
        let texel_sr = 19.739_21 / (map_size.x as f32 * map_size.y as f32);
        let inside = p * (1.0 - reach).max(0.0);
        let pixel_sr = self.ball().solid_angle_sr_per_area(inside) / (radius_px * radius_px);
        let stretch = 1.0 / libm::sqrtf((1.0 - inside.length_squared()).max(0.004));
        let wanted = self.samples as f32 * (pixel_sr / texel_sr).max(0.25) * stretch;
        (libm::sqrtf(wanted) + 0.5).clamp(1.0, MOST_ALONG_SIDE) as u32
    }

    /// Radiance that the camera sees at an image point.
    #[inline]
    #[must_use]
    pub fn radiance(&self, p: Vec2, stage: Stage<'_>) -> Vec3 {
        let flat = p * self.outline;
        let direction = (self.forward + self.right * flat.x - self.up * flat.y).normalize();
        let before = stage.occluder_distance(self.eye, direction);
        let distance = self.ball_radius / self.radius_over_distance;
        if let Some(seen) = self.ball().reflect(p) {
            if before < distance {
                return stage.params.occluder_radiance;
            }
            let point = self.ball_centre + seen.normal * self.ball_radius;
            return self.reflectance(seen.cos_incidence)
                * self.reflected(point, seen.direction, stage);
        }
        stage.radiance(self.eye, direction)
    }

    /// Radiance that arrives at a point of the ball.
    #[inline]
    fn reflected(&self, point: Vec3, direction: Vec3, stage: Stage<'_>) -> Vec3 {
        let rig = self.rig_distance(point, direction);
        if rig < stage.occluder_distance(point, direction) {
            return self.rig_radiance;
        }
        stage.radiance(point, direction)
    }

    /// The share of light that is reflected, for each channel.
    #[inline]
    #[must_use]
    pub fn reflectance(&self, cos_incidence: f32) -> Vec3 {
        let m = (1.0 - cos_incidence).clamp(0.0, 1.0);
        let m2 = m * m;
        self.tint + (Vec3::ONE - self.tint) * (self.fresnel * m2 * m2 * m)
    }

    /// Distance along a ray to the rig's box; [`NO_HIT`] where it is missed or there is none.
    #[inline]
    #[must_use]
    pub fn rig_distance(&self, origin: Vec3, d: Vec3) -> f32 {
        let from = origin - self.eye;
        let half = self.rig_half_size;
        if half.min_element() <= 0.0 {
            return NO_HIT;
        }
        let x = slab(from.dot(self.right), d.dot(self.right), half.x);
        let y = slab(from.dot(self.up), d.dot(self.up), half.y);
        let z = slab(from.dot(self.forward), d.dot(self.forward), half.z);
        let near = x.x.max(y.x).max(z.x);
        let far = x.y.min(y.y).min(z.y);
        if near <= far && near > 0.0 {
            near
        } else {
            NO_HIT
        }
    }
}

/// Where along a ray a coordinate enters `[-half, half]`, and where it leaves it.
#[inline]
fn slab(from: f32, d: f32, half: f32) -> Vec2 {
    if d.abs() < 1e-12 {
        // Always inside, or never.
        let inside = from.abs() <= half;
        return if inside {
            Vec2::new(-NO_HIT, NO_HIT)
        } else {
            Vec2::new(NO_HIT, -NO_HIT)
        };
    }
    let a = (-half - from) / d;
    let b = (half - from) / d;
    Vec2::new(a.min(b), a.max(b))
}

/// One pixel of the ball's image: linear RGB, alpha 1.
///
/// Its samples stand on a grid, and not where a pattern scatters them: that is exact to the second order, so that a pixel shows
/// what is in its middle, and a sun of one texel keeps its energy.
#[must_use]
pub fn film_ball(pixel: u32, capture: &CaptureParams, stage: Stage<'_>) -> Vec4 {
    let corner = UVec2::new(pixel % capture.width, pixel / capture.width).as_vec2();
    let middle = capture.image_point(corner + Vec2::splat(0.5));
    let side = capture.samples_along_side(middle, stage.params.size);
    let mut sum = Vec3::ZERO;
    for j in 0..side {
        for i in 0..side {
            let inside = (UVec2::new(i, j).as_vec2() + Vec2::splat(0.5)) / side as f32;
            sum += capture.radiance(capture.image_point(corner + inside), stage);
        }
    }
    (sum / (side * side) as f32).extend(1.0)
}

/// One pixel of the backplate: linear RGB, alpha 1.
#[must_use]
pub fn film_plate(pixel: u32, frame: &FrameParams, stage: Stage<'_>) -> Vec4 {
    let first = pixel * frame.rays_per_pixel;
    let mut sum = Vec3::ZERO;
    for i in first..first + frame.rays_per_pixel {
        let ray = frame.camera_ray(&frame.pattern_of(i));
        sum += stage.radiance(ray.origin, ray.direction);
    }
    (sum / frame.rays_per_pixel as f32).extend(1.0)
}

/// What a lat-long map of the surroundings is made with. 32 bytes.
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct LatLongParams {
    /// Where the probe stands, in metres.
    pub position: Vec3,
    /// Samples along each side of a texel.
    pub grid: u32,
    /// Width and height of the map in texels.
    pub size: UVec2,
    /// Fills 16 bytes.
    pub unused: UVec2,
}

/// One texel of the map that an ideal probe records: the mean radiance over the texel, by samples that stand on a grid of
/// equal solid angles. Linear RGB, alpha 1.
#[must_use]
pub fn film_latlong(texel: u32, latlong: &LatLongParams, stage: Stage<'_>) -> Vec4 {
    let place = UVec2::new(texel % latlong.size.x, texel / latlong.size.x);
    let mut sum = Vec3::ZERO;
    for j in 0..latlong.grid {
        for i in 0..latlong.grid {
            let inside = (UVec2::new(i, j).as_vec2() + Vec2::splat(0.5)) / latlong.grid as f32;
            let direction = direction_in_texel(place, latlong.size, inside);
            sum += stage.radiance(latlong.position, direction);
        }
    }
    (sum / (latlong.grid * latlong.grid) as f32).extend(1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn layout_is_that_of_wgsl() {
        assert_eq!(core::mem::size_of::<CaptureParams>(), 176);
        assert_eq!(core::mem::offset_of!(CaptureParams, shake_y), 16);
        assert_eq!(core::mem::offset_of!(CaptureParams, ball_centre), 48);
        assert_eq!(core::mem::offset_of!(CaptureParams, up), 96);
        assert_eq!(core::mem::offset_of!(CaptureParams, rig_radiance), 160);
        assert_eq!(core::mem::size_of::<LatLongParams>(), 32);
        assert_eq!(core::mem::offset_of!(LatLongParams, size), 16);
    }
}
