//! Shared file: what a camera ray hits, kept from one pass to the next, and the pass that finds it.

use glam::Vec3;
use glimt_brdf::BlinnPhong;
use glimt_sampling::math::ShadingFrame;

use super::frame::FrameParams;
use super::pattern::PixelPattern;
use super::scene::{Scene, ShadingPoint};

/// [`SeenPoint::surface`] where a ray hits nothing.
pub const NO_SURFACE: u32 = 0;

/// Bit of [`SeenPoint::flags`]: the ray belongs to a group.
pub const GROUPED: u32 = 1;
/// Bit of [`SeenPoint::flags`]: it hits a catcher.
pub const CATCHER: u32 = 2;
/// The lowest bit of [`SeenPoint::flags`] that tells the slot.
pub const SLOT_SHIFT: u32 = 2;

/// What a ray hits, and its place among the groups of its pixel. 112 bytes; all 0 for a ray that hits nothing.
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct SeenPoint {
    /// [`ShadingPoint::origin`].
    pub origin: Vec3,
    /// One more than the index of its object; [`NO_SURFACE`] for a ray that hits nothing.
    pub surface: u32,
    /// [`ShadingPoint::geometric_normal`].
    pub geometric_normal: Vec3,
    /// [`GROUPED`], [`CATCHER`], and from bit [`SLOT_SHIFT`] on the slot of what is known of the visibility around it.
    pub flags: u32,
    /// Unit shading normal, on the side of ωo.
    pub normal: Vec3,
    /// [`BlinnPhong::exponent`].
    pub exponent: f32,
    /// ωo, in the world.
    pub wo: Vec3,
    /// Material of its triangle.
    pub material: u32,
    /// [`BlinnPhong::diffuse`].
    pub diffuse: Vec3,
    /// Of the list of all hits of the pixel, group by group: the ray whose place is this one's number.
    pub order: u32,
    /// [`BlinnPhong::specular`].
    pub specular: Vec3,
    /// Of the first member of a group that was shaded: its shadow rays.
    pub shadow_rays: u32,
    /// [`ShadingPoint::emission`]; 0 on a catcher.
    pub emission: Vec3,
    /// Of the first member of a group that was shaded: the standard deviation, in luminance, that one of its rays was expected to have,
    /// times the group's share of the pixel.
    pub residual: f32,
}

impl SeenPoint {
    /// Of a ray that hits nothing.
    pub const NONE: SeenPoint = SeenPoint {
        origin: Vec3::ZERO,
        surface: NO_SURFACE,
        geometric_normal: Vec3::ZERO,
        flags: 0,
        normal: Vec3::ZERO,
        exponent: 0.0,
        wo: Vec3::ZERO,
        material: 0,
        diffuse: Vec3::ZERO,
        order: 0,
        specular: Vec3::ZERO,
        shadow_rays: 0,
        emission: Vec3::ZERO,
        residual: 0.0,
    };

    /// Whether the ray hits something.
    #[inline]
    #[must_use]
    pub fn is_hit(&self) -> bool {
        self.surface != NO_SURFACE
    }

    /// Whether it is on a catcher.
    #[inline]
    #[must_use]
    pub fn is_catcher(&self) -> bool {
        self.flags & CATCHER != 0
    }

    /// Where what is known of the visibility around it lies among the entries of its tile, counted from 1; 0 for nowhere.
    #[inline]
    #[must_use]
    pub fn slot(&self) -> u32 {
        self.flags >> SLOT_SHIFT
    }

    /// The point, as the pass that found it shaded it.
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

/// What the tile's ray `ray` hits.
#[must_use]
pub fn see(ray: u32, frame: &FrameParams, scene: Scene<'_>) -> SeenPoint {
    see_by(&frame.pattern_of(ray), frame, scene)
}

/// As [`see`], of the ray that a pattern belongs to.
#[inline]
#[must_use]
pub fn see_by(pattern: &PixelPattern, frame: &FrameParams, scene: Scene<'_>) -> SeenPoint {
    let camera_ray = frame.camera_ray(pattern);
    let Some(hit) = scene.closest_hit(&camera_ray) else {
        return SeenPoint::NONE;
    };
    let point = scene.shading_point(&camera_ray, &hit);
    let triangle = &scene.triangles[hit.triangle as usize];
    let is_catcher = triangle.is_catcher();
    SeenPoint {
        origin: point.origin,
        surface: triangle.object_index() + 1,
        geometric_normal: point.geometric_normal,
        flags: if is_catcher { CATCHER } else { 0 },
        normal: point.frame.n,
        exponent: point.brdf.exponent,
        wo: -camera_ray.direction,
        material: triangle.material,
        diffuse: point.brdf.diffuse,
        order: 0,
        specular: point.brdf.specular,
        shadow_rays: 0,
        emission: if is_catcher {
            Vec3::ZERO
        } else {
            point.emission
        },
        residual: 0.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn layout_is_that_of_wgsl() {
        assert_eq!(core::mem::size_of::<SeenPoint>(), 112);
        assert_eq!(core::mem::offset_of!(SeenPoint, geometric_normal), 16);
        assert_eq!(core::mem::offset_of!(SeenPoint, wo), 48);
        assert_eq!(core::mem::offset_of!(SeenPoint, emission), 96);
    }

    #[test]
    fn a_ray_that_hits_nothing_is_zero() {
        let zero: SeenPoint = bytemuck::Zeroable::zeroed();
        assert_eq!(SeenPoint::NONE, zero);
        assert!(!zero.is_hit());
    }
}
