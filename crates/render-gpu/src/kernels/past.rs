//! Shared file: what rays remember of the frame before, and where in it a point is found.

use glam::{Mat4, Vec2, Vec3};

use super::camera::CameraView;
use super::frame::FrameParams;
use super::pattern::PixelPattern;
use super::scene::ShadingPoint;

/// What a ray keeps from frame to frame beside its particles: the target that they stand for, and how they fare. 64 bytes.
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct RayState {
    /// Unit shading normal, on the side of ωo.
    pub normal: Vec3,
    /// ln Z; [`LOG_ZERO`](glimt_smc::LOG_ZERO) for Z = 0.
    pub log_normaliser: f32,
    /// ωo, in the world.
    pub wo: Vec3,
    /// Distance from the eye; 0 for a ray that hit nothing, and then the rest is 0, too.
    pub depth: f32,
    /// Luminance of the diffuse albedo.
    pub diffuse: f32,
    /// Luminance of the specular albedo.
    pub specular: f32,
    /// Blinn-Phong exponent.
    pub exponent: f32,
    /// Frames since the set was started; 0 in the frame that started it.
    pub age: u32,
    /// The least effective sample size on the way to this frame; N where no set was led into it.
    pub ess: f32,
    /// ln Z_t/Z_{t−1} as the sampler estimated it, also where the ratio itself then re-initialised the set; 0 where no set was led
    /// into this frame.
    pub log_ratio: f32,
    /// One of the `STARTED_…` constants.
    pub started: u32,
    /// Accepted moves, of N (K + 1); 0 where no set was led into this frame.
    pub accepted: u32,
}

/// [`RayState::started`]: not in this frame.
pub const STARTED_NOT: u32 = 0;
/// [`RayState::started`]: as the ray had no predecessor: the first frame, or a point that was not seen in the frame before.
pub const STARTED_WITHOUT_PAST: u32 = 1;
/// [`RayState::started`]: as the normaliser jumped, or all weights were 0. Only where the rule that is biased is asked for.
pub const STARTED_BY_RATIO: u32 = 2;
/// [`RayState::started`]: as it was the ray's turn, or the set had reached its greatest age.
pub const STARTED_BY_AGE: u32 = 3;
/// [`RayState::started`]: as the light map had changed too much.
pub const STARTED_BY_CHANGE: u32 = 4;

impl RayState {
    /// Of a ray that hits nothing.
    pub const NONE: RayState = RayState {
        normal: Vec3::ZERO,
        log_normaliser: 0.0,
        wo: Vec3::ZERO,
        depth: 0.0,
        diffuse: 0.0,
        specular: 0.0,
        exponent: 0.0,
        age: 0,
        ess: 0.0,
        log_ratio: 0.0,
        started: STARTED_NOT,
        accepted: 0,
    };
}

/// From where the frame before was seen, and which of its rays are available. 64 bytes.
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct PastView {
    /// [`CameraView::eye`](super::camera::CameraView::eye).
    pub eye: Vec3,
    /// Index in the image of the first pixel whose rays are available.
    pub first_pixel: u32,
    /// [`CameraView::forward`](super::camera::CameraView::forward).
    pub forward: Vec3,
    /// How many pixels' rays are available, one after the other; 0 where there is no frame before.
    pub pixels: u32,
    /// [`CameraView::right`](super::camera::CameraView::right).
    pub right: Vec3,
    /// How far off the surface that a ray saw a point may lie to be found there, as a share of its distance.
    pub depth_tolerance: f32,
    /// [`CameraView::up`](super::camera::CameraView::up).
    pub up: Vec3,
    /// The least cosine between its normal and that of the point.
    pub normal_cosine: f32,
}

/// The frame before, without its particles.
#[derive(Clone, Copy, Debug)]
pub struct Past<'a> {
    /// For each object of the scene, the map from where it is to where it was.
    pub motions: &'a [Mat4],
    /// Of each ray that is available.
    pub states: &'a [RayState],
}

/// How far beyond its own pixel, in pixels, a point may be found and still count as standing still: rounding must not send the
/// rays of a still image to their neighbours.
const STILL: f32 = 1.0 / 64.0;

impl PastView {
    /// Of a frame of which no rays are available.
    #[must_use]
    pub fn of(view: &CameraView) -> PastView {
        PastView {
            eye: view.eye,
            first_pixel: 0,
            forward: view.forward,
            pixels: 0,
            right: view.right,
            depth_tolerance: 0.0,
            up: view.up,
            normal_cosine: 0.0,
        }
    }

    /// Where the point `position` of an object, moved to where it was by `motion`, was seen in the frame before: the
    /// place in the image in pixels, and the distance from the eye; `None` behind the eye.
    #[inline]
    #[must_use]
    pub fn project(&self, was_at: Vec3, size: Vec2) -> Option<Vec3> {
        let v = was_at - self.eye;
        let along = v.dot(self.forward);
        if !(along > 0.0) {
            return None;
        }
        let x = v.dot(self.right) / (along * self.right.length_squared());
        let y = v.dot(self.up) / (along * self.up.length_squared());
        let place = Vec2::new(0.5 + 0.5 * x, 0.5 - 0.5 * y) * size;
        Some(place.extend(v.length()))
    }

    /// The ray, counted from the first that is available, that saw a point of an object in the frame before: the ray of the same number in the
    /// pixel where the point was. `None` where it was out of sight: beyond the image or what is available, or where that
    /// ray saw another surface, or one turned another way.
    #[inline]
    #[must_use]
    pub fn predecessor(
        &self,
        point: &ShadingPoint,
        object: u32,
        frame: &FrameParams,
        pattern: &PixelPattern,
        past: Past<'_>,
    ) -> Option<u32> {
        if self.pixels == 0 {
            return None;
        }
        let motion = past.motions[object as usize];
        let was_at = (motion * point.origin.extend(1.0)).truncate();
        let size = Vec2::new(frame.width as f32, frame.height as f32);
        let seen = self.project(was_at, size)?;
        let own = Vec2::new(
            (pattern.pixel % frame.width) as f32,
            (pattern.pixel / frame.width) as f32,
        );
        let off = seen.truncate() - own;
        let still = off.min_element() > -STILL && off.max_element() < 1.0 + STILL;
        let in_image = seen.x >= 0.0 && seen.y >= 0.0 && seen.x < size.x && seen.y < size.y;
        if !still && !in_image {
            return None;
        }
        let pixel = if still {
            pattern.pixel
        } else {
            seen.y as u32 * frame.width + seen.x as u32
        };
        if pixel < self.first_pixel || pixel - self.first_pixel >= self.pixels {
            return None;
        }
        let ray = (pixel - self.first_pixel) * pattern.rays + pattern.ray;
        let state = past.states[ray as usize];
        let turned = (motion * point.frame.n.extend(0.0)).truncate().normalize();
        // What that ray saw is a little piece of a plane, which may be seen flatly: depths of neighbours tell nothing then.
        let saw = self.eye - state.wo * state.depth;
        let off_plane = (was_at - saw).dot(state.normal).abs();
        let same_plane = off_plane <= self.depth_tolerance * seen.z;
        if state.depth > 0.0 && same_plane && turned.dot(state.normal) >= self.normal_cosine {
            Some(ray)
        } else {
            None
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::UVec2;

    #[test]
    fn layout_is_that_of_wgsl() {
        assert_eq!(core::mem::size_of::<RayState>(), 64);
        assert_eq!(core::mem::offset_of!(RayState, wo), 16);
        assert_eq!(core::mem::offset_of!(RayState, diffuse), 32);
        assert_eq!(core::mem::offset_of!(RayState, ess), 48);
        assert_eq!(core::mem::size_of::<PastView>(), 64);
        assert_eq!(core::mem::offset_of!(PastView, right), 32);
        assert_eq!(core::mem::offset_of!(PastView, normal_cosine), 60);
    }

    #[test]
    fn projection_is_the_inverse_of_the_camera() {
        let view = CameraView {
            eye: Vec3::new(1.0, -2.0, 0.5),
            forward: Vec3::new(0.6, 0.8, 0.0),
            right: Vec3::new(0.8, -0.6, 0.0) * 0.4,
            up: Vec3::Z * 0.3,
        };
        let past = PastView {
            eye: view.eye,
            first_pixel: 0,
            forward: view.forward,
            pixels: 1,
            right: view.right,
            depth_tolerance: 0.01,
            up: view.up,
            normal_cosine: 0.9,
        };
        let size = UVec2::new(64, 48);
        for p in [
            Vec2::new(0.3, 0.7),
            Vec2::new(63.5, 47.2),
            Vec2::new(20.0, 31.0),
        ] {
            let at = view.eye + 7.0 * view.direction(p, size);
            let seen = past.project(at, size.as_vec2()).unwrap();
            assert!((seen.truncate() - p).length() < 1e-4, "{seen} {p}");
            assert!((seen.z - 7.0).abs() < 1e-5);
        }
        assert_eq!(past.project(view.eye - view.forward, size.as_vec2()), None);
    }
}
