//! Shared file: the scene's buffers, and what lies where a ray hits.

use glam::{Vec2, Vec3};
use glimt_brdf::BlinnPhong;
use glimt_sampling::math::ShadingFrame;

use super::bvh::{BvhNode, any_hit, closest_hit};
use super::material::{Attributes, MaterialView};
use super::ray::{Hit, Ray};
use super::triangle::Triangle;

/// Bit of [`Triangle::material`] that says that the bitangent is `−n × t`; the rest is the material's index.
pub const MIRRORED: u32 = 1 << 31;

/// What interpolation needs of one corner of a triangle. 32 bytes, three in a row for each triangle.
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct Corner {
    /// Unit shading normal.
    pub normal: Vec3,
    /// Texture coordinate u.
    pub u: f32,
    /// Tangent along growing u; zero where no material needs it.
    pub tangent: Vec3,
    /// Texture coordinate v.
    pub v: f32,
}

/// A view of the buffers that hold a scene.
#[derive(Clone, Copy, Debug)]
pub struct Scene<'a> {
    /// The tree; the root first.
    pub nodes: &'a [BvhNode],
    /// Triangles in the order of the leaves.
    pub triangles: &'a [Triangle],
    /// Three corners for each triangle.
    pub corners: &'a [Corner],
    /// Materials, textures and colours: the surface buffer of [`material`](super::material).
    pub surface: &'a [u32],
}

/// A point of a surface with all that an estimator of its reflected light needs.
#[derive(Clone, Copy, Debug)]
pub struct ShadingPoint {
    /// Where rays that leave the surface start: moved off it along the geometric normal.
    pub origin: Vec3,
    /// Unit normal of the face, on the side of ωo.
    pub geometric_normal: Vec3,
    /// Frame about the shading normal, on the side of ωo.
    pub frame: ShadingFrame,
    /// ωo in that frame: where the ray came from.
    pub wo: Vec3,
    /// The reflection model, in that frame.
    pub brdf: BlinnPhong,
    /// Radiance that the surface itself sends to all sides.
    pub emission: Vec3,
}

/// The least cosine between the shading normal and ωo, as far as the face itself is not seen more flatly.
const LEAST_COSINE: f32 = 0.01;

/// The shading normal as the eye may see it: `normal`, which lies on the side of the face that faces the eye, or, where it leans away
/// from the eye, bent towards it as far as needed.
///
/// The eye sees the face, so a normal that leans away is an artefact of interpolation. A normal that were turned round in its place would
/// be lit from the wrong side. Cycles bends normals for the same reason.
#[inline]
#[must_use]
pub fn bent_towards(normal: Vec3, to_eye: Vec3, geometric_normal: Vec3) -> Vec3 {
    let least = LEAST_COSINE.min(0.9 * geometric_normal.dot(to_eye));
    let cosine = normal.dot(to_eye);
    if cosine >= least {
        return normal;
    }
    unit_or(normal + to_eye * (least - cosine), geometric_normal)
}

impl Scene<'_> {
    /// What the ray hits first.
    #[inline]
    #[must_use]
    pub fn closest_hit(&self, ray: &Ray) -> Option<Hit> {
        closest_hit(self.nodes, self.triangles, self.surface, ray, f32::MAX)
    }

    /// The shading point where a ray of unit direction hits.
    #[must_use]
    pub fn shading_point(&self, ray: &Ray, hit: &Hit) -> ShadingPoint {
        let triangle = &self.triangles[hit.triangle as usize];
        let first = 3 * hit.triangle as usize;
        let a = &self.corners[first];
        let b = &self.corners[first + 1];
        let c = &self.corners[first + 2];
        let (u, v) = (hit.barycentrics.x, hit.barycentrics.y);
        let w = 1.0 - u - v;

        let to_eye = -ray.direction;
        let outward = triangle.outward().normalize();
        let is_inside = outward.dot(to_eye) < 0.0;
        let geometric_normal = if is_inside { -outward } else { outward };
        let smooth = unit_or(a.normal * w + b.normal * u + c.normal * v, outward);

        let uv = Vec2::new(a.u * w + b.u * u + c.u * v, a.v * w + b.v * u + c.v * v);
        let material = MaterialView::new(self.surface, triangle.material & !MIRRORED);
        let tangent = a.tangent * w + b.tangent * u + c.tangent * v;
        let handedness = if triangle.material & MIRRORED != 0 {
            -1.0
        } else {
            1.0
        };
        let bumped = material.bumped_normal(uv, smooth, tangent, handedness);
        // The face decides which side is seen: the normal itself may lean beyond its horizon.
        let sided = if is_inside { -bumped } else { bumped };
        let normal = bent_towards(sided, to_eye, geometric_normal);

        let mut vertex_color = Vec3::ONE;
        if triangle.attributes != 0 {
            let attributes = Attributes::at(self.surface, triangle.attributes, u, v);
            vertex_color = attributes.color.truncate();
        }
        let frame = ShadingFrame::from_normal(normal);
        let edges = (triangle.b() - triangle.a()) * u + (triangle.c() - triangle.a()) * v;
        ShadingPoint {
            origin: triangle.a() + edges + geometric_normal * triangle.ray_offset(),
            geometric_normal,
            frame,
            wo: frame.to_local(to_eye),
            brdf: material.brdf(uv, vertex_color),
            emission: material.emission(uv, vertex_color),
        }
    }

    /// Whether light from `direction` reaches the point, by a ray with this key.
    #[inline]
    #[must_use]
    pub fn is_lit(&self, point: &ShadingPoint, direction: Vec3, key: u32) -> bool {
        let ray = Ray::keyed(point.origin, direction, key);
        !any_hit(self.nodes, self.triangles, self.surface, &ray, f32::MAX)
    }
}

/// `v` at unit length, or `otherwise` where it has none to speak of.
#[inline]
pub(super) fn unit_or(v: Vec3, otherwise: Vec3) -> Vec3 {
    let length_squared = v.length_squared();
    if length_squared > 1e-12 {
        v / libm::sqrtf(length_squared)
    } else {
        otherwise
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn layout_is_that_of_wgsl() {
        assert_eq!(core::mem::size_of::<Corner>(), 32);
        assert_eq!(core::mem::offset_of!(Corner, u), 12);
        assert_eq!(core::mem::offset_of!(Corner, tangent), 16);
        assert_eq!(core::mem::offset_of!(Corner, v), 28);
    }
}
