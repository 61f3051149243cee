//! Shared file: a triangle in a buffer, and the ray's test against it.

use glam::{Vec2, Vec3};

use super::ray::Ray;

/// Bit of [`Triangle::object`] that says that it stands for something in the footage: it is seen and shaded, but blocks no
/// light, since the light map was filmed with it in place. The rest is the object's index.
pub const CATCHER: u32 = 1 << 31;

/// Bit of [`Triangle::object`] that says that its material lets light pass somewhere (glTF's alpha modes `MASK` and `BLEND`).
pub const SEE_THROUGH: u32 = 1 << 30;

/// How far from a surface a ray starts that leaves it, as a share of the triangle's largest coordinate: 64 units in the last place, of
/// which about ten may be lost in the hit and in the next ray's test.
pub const RAY_OFFSET: f32 = 1.0 / 262_144.0;

/// Bit of [`Triangle::object`] that says that its corners run clockwise seen from where its vertices' normals point, as in a mesh
/// that is mirrored.
pub const INSIDE_OUT: u32 = 1 << 29;

/// A triangle in world coordinates, in the order of the tree's leaves.
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct Triangle {
    /// First corner.
    pub v0: Vec3,
    /// Index of its material.
    pub material: u32,
    /// Second corner.
    pub v1: Vec3,
    /// Index of the object that it belongs to, below 2²⁹; with the bits [`CATCHER`], where that is a shadow catcher,
    /// [`INSIDE_OUT`] and [`SEE_THROUGH`].
    pub object: u32,
    /// Third corner.
    pub v2: Vec3,
    /// Word of the surface buffer at which the [attributes](super::material::Attributes) of its corners begin; 0 where it has none.
    pub attributes: u32,
}

impl Triangle {
    /// Whether it belongs to a shadow catcher.
    #[inline]
    #[must_use]
    pub fn is_catcher(&self) -> bool {
        self.object & CATCHER != 0
    }

    /// Index of the object that it belongs to.
    #[inline]
    #[must_use]
    pub fn object_index(&self) -> u32 {
        self.object & !(CATCHER | INSIDE_OUT | SEE_THROUGH)
    }

    /// Whether its material lets light pass somewhere.
    #[inline]
    #[must_use]
    pub fn is_see_through(&self) -> bool {
        self.object & SEE_THROUGH != 0
    }

    /// How far from the surface a ray starts that leaves it, along the geometric normal.
    #[inline]
    #[must_use]
    pub fn ray_offset(&self) -> f32 {
        let extent = self.v0.abs().max(self.v1.abs()).max(self.v2.abs());
        RAY_OFFSET * extent.max_element()
    }

    /// How much further than it is a catcher counts as being along a ray that hits it at `t`, so that what lies on it is seen before it.
    #[inline]
    #[must_use]
    pub fn setback(&self, ray: &Ray, t: f32) -> f32 {
        let normal = self.area_normal();
        let across = normal.dot(ray.direction).abs();
        let apart = 2.0
            * self
                .ray_offset()
                .max(RAY_OFFSET * t * libm::sqrtf(ray.direction.length_squared()));
        // Seen at a flat angle, a small gap is a long way; but no longer than the way so far.
        (apart * libm::sqrtf(normal.length_squared()) / across.max(f32::MIN_POSITIVE)).min(t)
    }

    /// Where its outside is: the face's normal on the side of its vertices' normals. Of any length.
    #[inline]
    #[must_use]
    pub fn outward(&self) -> Vec3 {
        let normal = self.area_normal();
        if self.object & INSIDE_OUT != 0 {
            -normal
        } else {
            normal
        }
    }

    /// The normal of the face, right-handed about the corners' order; its length is twice the area.
    #[inline]
    #[must_use]
    pub fn area_normal(&self) -> Vec3 {
        (self.v1 - self.v0).cross(self.v2 - self.v0)
    }
}

/// Edge functions of the triangle's corners seen along the ray (x belongs to the first): twice the volumes that the
/// direction spans with each opposite edge, in proportion to the barycentric weights.
///
/// They are Plücker inner products about the ray's origin (as in Woop, Benthin and Wald 2013, without their shear). Two
/// triangles that share an edge compute the same number for it up to its sign, so no ray slips between them.
#[inline(always)]
fn edge_functions(a: Vec3, b: Vec3, c: Vec3, direction: Vec3) -> Vec3 {
    Vec3::new(
        (b - c).cross(b + c).dot(direction),
        (c - a).cross(c + a).dot(direction),
        (a - b).cross(a + b).dot(direction),
    )
}

/// Distance in `(0, t_max)` at which the ray hits the triangle, from either side; [`f32::MAX`] where it does not.
///
/// A triangle without area, or seen edge-on, is never hit.
#[inline(always)]
#[must_use]
pub fn intersect(triangle: &Triangle, ray: &Ray, t_max: f32) -> f32 {
    let a = triangle.v0 - ray.origin;
    let b = triangle.v1 - ray.origin;
    let c = triangle.v2 - ray.origin;
    let w = edge_functions(a, b, c, ray.direction);
    if w.min_element() < 0.0 && w.max_element() > 0.0 {
        return f32::MAX;
    }
    let normal = (c - a).cross(a - b);
    let slope = normal.dot(ray.direction);
    if slope == 0.0 {
        return f32::MAX;
    }
    let t = a.dot(normal) / slope;
    if t > 0.0 && t < t_max { t } else { f32::MAX }
}

/// Barycentric weights of the second and third corner where the ray crosses the triangle, which it is known to hit.
#[inline]
#[must_use]
pub fn barycentrics(triangle: &Triangle, ray: &Ray) -> Vec2 {
    let w = edge_functions(
        triangle.v0 - ray.origin,
        triangle.v1 - ray.origin,
        triangle.v2 - ray.origin,
        ray.direction,
    );
    let sum = w.element_sum();
    if sum == 0.0 {
        // Only rounding can hit a triangle whose edges all look the same way: any of its points will do.
        return Vec2::splat(1.0 / 3.0);
    }
    Vec2::new(w.y, w.z) / sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_catcher_counts_as_a_little_further() {
        let face = triangle(Vec3::ZERO, Vec3::X * 8.0, Vec3::Y * 8.0);
        let straight = Ray::new(Vec3::new(1.0, 1.0, 2.0), Vec3::NEG_Z);
        let expected = 2.0 * 8.0 * RAY_OFFSET;
        assert_eq!(face.setback(&straight, 2.0), expected);
        // Half as long a direction: twice as many of them.
        let half = Ray::new(Vec3::new(1.0, 1.0, 2.0), Vec3::NEG_Z * 0.5);
        assert_eq!(face.setback(&half, 4.0), 2.0 * expected);
        let flat = Ray::new(Vec3::new(1.0, 1.0, 2.0), Vec3::X);
        assert_eq!(face.setback(&flat, 2.0), 2.0);
    }

    fn triangle(v0: Vec3, v1: Vec3, v2: Vec3) -> Triangle {
        Triangle {
            v0,
            material: 0,
            v1,
            object: 0,
            v2,
            attributes: 0,
        }
    }

    #[test]
    fn layout_is_that_of_wgsl() {
        assert_eq!(core::mem::size_of::<Triangle>(), 48);
        assert_eq!(core::mem::offset_of!(Triangle, material), 12);
        assert_eq!(core::mem::offset_of!(Triangle, v1), 16);
        assert_eq!(core::mem::offset_of!(Triangle, object), 28);
        assert_eq!(core::mem::offset_of!(Triangle, v2), 32);
        assert_eq!(core::mem::offset_of!(Triangle, attributes), 44);
    }

    #[test]
    fn barycentrics_and_distance_from_both_sides() {
        let face = triangle(Vec3::ZERO, Vec3::X, Vec3::Y);
        for z in [2.0, -2.0] {
            let ray = Ray::new(Vec3::new(0.25, 0.5, z), Vec3::new(0.0, 0.0, -z));
            assert_eq!(intersect(&face, &ray, f32::MAX), 1.0);
            assert_eq!(intersect(&face, &ray, 1.0), f32::MAX);
            assert_eq!(barycentrics(&face, &ray), Vec2::new(0.25, 0.5));
        }
        let behind = Ray::new(Vec3::new(0.25, 0.5, 2.0), Vec3::Z);
        assert_eq!(intersect(&face, &behind, f32::MAX), f32::MAX);
    }

    #[test]
    fn a_shared_edge_has_no_gap() {
        let (p, q) = (Vec3::new(0.1, 0.2, 0.3), Vec3::new(1.7, -0.4, 0.9));
        let left = triangle(p, q, Vec3::new(0.3, 2.0, -1.0));
        let right = triangle(q, p, Vec3::new(0.9, -2.0, 1.1));
        let eye = Vec3::new(0.5, 0.3, 7.0);
        for k in 1..4000 {
            let on_edge = p + (q - p) * (k as f32 / 4000.0);
            let ray = Ray::new(eye, on_edge - eye);
            let hits = [left, right].map(|t| intersect(&t, &ray, f32::MAX) < f32::MAX);
            assert!(hits[0] || hits[1], "slipped through at {k}");
        }
    }

    #[test]
    fn degenerate_triangles_are_never_hit() {
        let ray = Ray::new(Vec3::new(0.5, 0.0, 1.0), Vec3::NEG_Z);
        let point = triangle(Vec3::X * 0.5, Vec3::X * 0.5, Vec3::X * 0.5);
        let line = triangle(Vec3::ZERO, Vec3::X, Vec3::X * 0.5);
        let edge_on = triangle(Vec3::ZERO, Vec3::X, Vec3::Z);
        for face in [point, line, edge_on] {
            assert_eq!(intersect(&face, &ray, f32::MAX), f32::MAX);
        }
    }
}
