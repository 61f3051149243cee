//! Shared file: the shading point of a ray, kept from one pass of the sequential sampler to the next, and the pass that finds it.

use glam::Vec3;
use glimt_brdf::BlinnPhong;
use glimt_sampling::math::ShadingFrame;

use super::frame::FrameParams;
use super::past::{Past, PastView, RayState};
use super::scene::{Scene, ShadingPoint};

/// [`SmcPoint::predecessor`] of a point that was not seen in the frame before.
pub const NO_PREDECESSOR: u32 = u32::MAX;

/// What a ray hits, and what it continues from. 176 bytes; all 0 for a ray that hits nothing.
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct SmcPoint {
    /// [`ShadingPoint::origin`].
    pub origin: Vec3,
    /// Distance from the eye; 0 for a ray that hits nothing.
    pub depth: f32,
    /// [`ShadingPoint::geometric_normal`].
    pub geometric_normal: Vec3,
    /// 1 on a catcher, else 0.
    pub catcher: u32,
    /// Unit shading normal, on the side of ωo.
    pub normal: Vec3,
    /// [`BlinnPhong::exponent`].
    pub exponent: f32,
    /// ωo, in the world.
    pub wo: Vec3,
    /// The ray of the frame before that saw this point, counted from the first that is available; or [`NO_PREDECESSOR`].
    pub predecessor: u32,
    /// [`BlinnPhong::diffuse`].
    pub diffuse: Vec3,
    /// Fills 16 bytes.
    pub unused_a: u32,
    /// [`BlinnPhong::specular`].
    pub specular: Vec3,
    /// Fills 16 bytes.
    pub unused_b: u32,
    /// [`ShadingPoint::emission`]; 0 on a catcher.
    pub emission: Vec3,
    /// Fills 16 bytes.
    pub unused_c: u32,
    /// What the predecessor kept; [`RayState::NONE`] without one.
    pub before: RayState,
}

impl SmcPoint {
    /// Of a ray that hits nothing.
    pub const NONE: SmcPoint = SmcPoint {
        origin: Vec3::ZERO,
        depth: 0.0,
        geometric_normal: Vec3::ZERO,
        catcher: 0,
        normal: Vec3::ZERO,
        exponent: 0.0,
        wo: Vec3::ZERO,
        predecessor: 0,
        diffuse: Vec3::ZERO,
        unused_a: 0,
        specular: Vec3::ZERO,
        unused_b: 0,
        emission: Vec3::ZERO,
        unused_c: 0,
        before: RayState::NONE,
    };

    /// Whether the ray hits something.
    #[inline]
    #[must_use]
    pub fn is_hit(&self) -> bool {
        self.depth > 0.0
    }

    /// The point, as the first pass shaded it.
    #[inline]
    #[must_use]
    pub fn shading_point(&self) -> ShadingPoint {
        let frame = ShadingFrame::from_normal(self.normal);
        ShadingPoint {
            origin: self.origin,
            geometric_normal: self.geometric_normal,
            frame,
            wo: frame.to_local(self.wo),
            brdf: BlinnPhong {
                diffuse: self.diffuse,
                specular: self.specular,
                exponent: self.exponent,
            },
            emission: self.emission,
        }
    }
}

/// Pass 1 of the sequential sampler: what the tile's ray `ray` hits, and the ray of the frame before that saw the same point.
#[must_use]
pub fn find_smc(
    ray: u32,
    frame: &FrameParams,
    view: &PastView,
    scene: Scene<'_>,
    past: Past<'_>,
) -> SmcPoint {
    let pattern = frame.pattern_of(ray);
    let camera_ray = frame.camera_ray(&pattern);
    let Some(hit) = scene.closest_hit(&camera_ray) else {
        return SmcPoint::NONE;
    };
    let point = scene.shading_point(&camera_ray, &hit);
    let triangle = &scene.triangles[hit.triangle as usize];
    let mut predecessor = NO_PREDECESSOR;
    let mut before = RayState::NONE;
    if let Some(found) = view.predecessor(&point, triangle.object_index(), frame, &pattern, past) {
        predecessor = found;
        before = past.states[found as usize];
    }
    SmcPoint {
        origin: point.origin,
        depth: hit.t,
        geometric_normal: point.geometric_normal,
        catcher: if triangle.is_catcher() { 1 } else { 0 },
        normal: point.frame.n,
        exponent: point.brdf.exponent,
        wo: -camera_ray.direction,
        predecessor,
        diffuse: point.brdf.diffuse,
        unused_a: 0,
        specular: point.brdf.specular,
        unused_b: 0,
        emission: if triangle.is_catcher() {
            Vec3::ZERO
        } else {
            point.emission
        },
        unused_c: 0,
        before,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn layout_is_that_of_wgsl() {
        assert_eq!(core::mem::size_of::<SmcPoint>(), 176);
        assert_eq!(core::mem::offset_of!(SmcPoint, geometric_normal), 16);
        assert_eq!(core::mem::offset_of!(SmcPoint, wo), 48);
        assert_eq!(core::mem::offset_of!(SmcPoint, specular), 80);
        assert_eq!(core::mem::offset_of!(SmcPoint, before), 112);
    }

    #[test]
    fn a_ray_that_hits_nothing_is_zero() {
        let zero: SmcPoint = bytemuck::Zeroable::zeroed();
        assert_eq!(SmcPoint::NONE, zero);
        assert!(!zero.is_hit());
    }
}
