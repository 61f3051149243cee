//! Shared file: the surroundings of a simulated capture: a lat-long map on a shell at a finite distance, so that moving shows
//! another parallax, and a ball of shadow that passes in front of it.

use glam::{UVec2, Vec2, Vec3, Vec4};
use glimt_probe::rotate::rotate_z;

use super::environment::bilinear;

/// [`StageParams::shape`]: the map lies at infinity.
pub const STAGE_INFINITE: u32 = 0;
/// [`StageParams::shape`]: the map lies on a sphere of radius `half_size.x`.
pub const STAGE_SPHERE: u32 = 1;
/// [`StageParams::shape`]: the map lies on a box.
pub const STAGE_BOX: u32 = 2;

/// The distance that means no hit.
pub const NO_HIT: f32 = 1e30;

/// The numbers of a stage. 64 bytes.
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct StageParams {
    /// Half of the shell's extent along x, y and z, in metres; its centre is the origin.
    pub half_size: Vec3,
    /// One of the `STAGE_…` constants.
    pub shape: u32,
    /// Centre of the ball that passes, in metres.
    pub occluder_centre: Vec3,
    /// Its radius in metres; 0 for none.
    pub occluder_radius: f32,
    /// Its radiance.
    pub occluder_radiance: Vec3,
    /// Fills 16 bytes.
    pub unused: f32,
    /// Width and height of the map in texels.
    pub size: UVec2,
    /// Cosine and sine of the angle by which the map is turned, counter-clockwise seen from above.
    pub rotation: Vec2,
}

/// What surrounds the probe.
#[derive(Clone, Copy, Debug)]
pub struct Stage<'a> {
    /// Linear RGB, row by row from +z, as seen from the origin.
    pub texels: &'a [Vec4],
    /// Its numbers.
    pub params: StageParams,
}

impl Stage<'_> {
    /// Radiance that arrives at `origin` from the direction `d` (unit length).
    #[inline]
    #[must_use]
    pub fn radiance(&self, origin: Vec3, d: Vec3) -> Vec3 {
        if self.occluder_distance(origin, d) < NO_HIT {
            return self.params.occluder_radiance;
        }
        self.map_radiance(origin, d)
    }

    /// The same without the ball that passes.
    #[inline]
    #[must_use]
    pub fn map_radiance(&self, origin: Vec3, d: Vec3) -> Vec3 {
        let back = Vec2::new(self.params.rotation.x, -self.params.rotation.y);
        let seen = rotate_z(self.point_seen(origin, d), back);
        bilinear(self.texels, self.params.size, seen)
    }

    /// The point of the shell that a ray meets on its way out, which is also the direction in which the origin sees it; `d`
    /// itself for a map at infinity. A ray that starts outside and misses gives the point nearest to it, or one near that.
    #[inline]
    #[must_use]
    pub fn point_seen(&self, origin: Vec3, d: Vec3) -> Vec3 {
        if self.params.shape == STAGE_INFINITE {
            return d;
        }
        let half = self.params.half_size;
        if self.params.shape == STAGE_SPHERE {
            let b = origin.dot(d);
            let c = origin.length_squared() - half.x * half.x;
            return origin + d * (libm::sqrtf((b * b - c).max(0.0)) - b);
        }
        let t = wall_distance(origin.x, d.x, half.x)
            .min(wall_distance(origin.y, d.y, half.y))
            .min(wall_distance(origin.z, d.z, half.z));
        origin + d * t.max(0.0)
    }

    /// Distance along a ray to the ball that passes; [`NO_HIT`] where it is missed, lies behind, or holds the origin.
    #[inline]
    #[must_use]
    pub fn occluder_distance(&self, origin: Vec3, d: Vec3) -> f32 {
        let radius = self.params.occluder_radius;
        if radius <= 0.0 {
            return NO_HIT;
        }
        let to_centre = self.params.occluder_centre - origin;
        let along = to_centre.dot(d);
        let aside = to_centre - d * along;
        let left = radius * radius - aside.length_squared();
        let t = along - libm::sqrtf(left.max(0.0));
        if left > 0.0 && t > 0.0 { t } else { NO_HIT }
    }
}

/// Distance to the wall that a ray runs towards along one axis.
#[inline]
fn wall_distance(origin: f32, d: f32, half: f32) -> f32 {
    if d > 1e-12 {
        (half - origin) / d
    } else if d < -1e-12 {
        (-half - origin) / d
    } else {
        NO_HIT
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn layout_is_that_of_wgsl() {
        assert_eq!(core::mem::size_of::<StageParams>(), 64);
        assert_eq!(core::mem::offset_of!(StageParams, occluder_centre), 16);
        assert_eq!(core::mem::offset_of!(StageParams, occluder_radiance), 32);
        assert_eq!(core::mem::offset_of!(StageParams, size), 48);
        assert_eq!(core::mem::offset_of!(StageParams, rotation), 56);
    }

    fn stage(shape: u32) -> Stage<'static> {
        Stage {
            texels: &[Vec4::ONE],
            params: StageParams {
                half_size: Vec3::new(2.0, 3.0, 4.0),
                shape,
                occluder_centre: Vec3::new(0.0, 1.5, 0.0),
                occluder_radius: 0.5,
                occluder_radiance: Vec3::ZERO,
                unused: 0.0,
                size: UVec2::ONE,
                rotation: Vec2::X,
            },
        }
    }

    #[test]
    fn rays_meet_the_shell_where_they_leave_it() {
        let origin = Vec3::new(1.0, 0.0, 0.0);
        let seen = |shape, d| stage(shape).point_seen(origin, d);
        assert_eq!(seen(STAGE_INFINITE, Vec3::Z), Vec3::Z);
        assert_eq!(seen(STAGE_SPHERE, Vec3::NEG_X), Vec3::new(-2.0, 0.0, 0.0));
        let up = seen(STAGE_SPHERE, Vec3::Z);
        assert!((up - Vec3::new(1.0, 0.0, 3f32.sqrt())).length() < 1e-6);
        assert_eq!(seen(STAGE_BOX, Vec3::X), Vec3::new(2.0, 0.0, 0.0));
        assert_eq!(seen(STAGE_BOX, Vec3::NEG_Y), Vec3::new(1.0, -3.0, 0.0));
    }

    #[test]
    fn what_passes_hides_what_is_behind_it() {
        let stage = stage(STAGE_INFINITE);
        assert_eq!(stage.radiance(Vec3::ZERO, Vec3::Y), Vec3::ZERO);
        assert_eq!(stage.occluder_distance(Vec3::ZERO, Vec3::Y), 1.0);
        for d in [Vec3::NEG_Y, Vec3::X, Vec3::Z] {
            assert_eq!(stage.radiance(Vec3::ZERO, d), Vec3::ONE);
        }
    }
}
