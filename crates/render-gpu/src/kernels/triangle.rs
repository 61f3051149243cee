//! Shared file: a triangle in a buffer, and the ray's test against it.

use glam::{Vec2, Vec3, Vec4, Vec4Swizzles};

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

/// A triangle in world coordinates, in the order of the tree's leaves. 64 bytes.
///
/// Its corners lie side by side, so that vector operations compute all three edges at once.
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct Triangle {
    /// x of its corners, and of the first one again.
    pub x: Vec4,
    /// y, likewise.
    pub y: Vec4,
    /// z, likewise.
    pub z: Vec4,
    /// Index of its material.
    pub material: u32,
    /// Index of the object that it belongs to, below 2²⁹; with the bits [`CATCHER`], where that is a shadow catcher,
    /// [`INSIDE_OUT`] and [`SEE_THROUGH`].
    pub object: u32,
    /// Word of the surface buffer at which the [attributes](super::material::Attributes) of its corners begin; 0 where it has none.
    pub attributes: u32,
    /// How many triangles of its leaf there are from this one on.
    pub run: u32,
}

impl Triangle {
    /// The triangle with these corners, of material 0 and object 0, alone in its leaf.
    #[inline]
    #[must_use]
    pub fn new(a: Vec3, b: Vec3, c: Vec3) -> Triangle {
        Triangle {
            x: Vec4::new(a.x, b.x, c.x, a.x),
            y: Vec4::new(a.y, b.y, c.y, a.y),
            z: Vec4::new(a.z, b.z, c.z, a.z),
            material: 0,
            object: 0,
            attributes: 0,
            run: 1,
        }
    }

    /// Its first corner.
    #[inline]
    #[must_use]
    pub fn a(&self) -> Vec3 {
        Vec3::new(self.x.x, self.y.x, self.z.x)
    }

    /// Its second corner.
    #[inline]
    #[must_use]
    pub fn b(&self) -> Vec3 {
        Vec3::new(self.x.y, self.y.y, self.z.y)
    }

    /// Its third corner.
    #[inline]
    #[must_use]
    pub fn c(&self) -> Vec3 {
        Vec3::new(self.x.z, self.y.z, self.z.z)
    }

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
        let extent = self.x.abs().max(self.y.abs()).max(self.z.abs());
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
        (self.b() - self.a()).cross(self.c() - self.a())
    }
}

/// A triangle as a ray sees it.
struct Seen {
    /// The first corner, from the ray's origin.
    a: Vec3,
    /// The edges opposite the first, second and third corner, each from the third of the three that follow one another: x, y and z.
    edge_x: Vec4,
    edge_y: Vec4,
    edge_z: Vec4,
    /// Edge functions of the corners: twice the volumes that the direction spans with each opposite edge, in proportion to the
    /// barycentric weights. The last is 0.
    functions: Vec4,
}

/// The triangle from where the ray starts.
///
/// The edge functions are Plücker inner products about the ray's origin (as in Woop, Benthin and Wald 2013, without their shear). Two
/// triangles that share an edge compute the same number for it up to its sign, so no ray slips between them.
#[inline(always)]
fn seen(triangle: &Triangle, ray: &Ray) -> Seen {
    let x = triangle.x - ray.origin.x;
    let y = triangle.y - ray.origin.y;
    let z = triangle.z - ray.origin.z;
    // The corners of each edge: those that follow the opposite one.
    let (x1, x2) = (x.yzxw(), x.zxyw());
    let (y1, y2) = (y.yzxw(), y.zxyw());
    let (z1, z2) = (z.yzxw(), z.zxyw());
    let (edge_x, edge_y, edge_z) = (x1 - x2, y1 - y2, z1 - z2);
    let (sum_x, sum_y, sum_z) = (x1 + x2, y1 + y2, z1 + z2);
    let d = ray.direction;
    let functions = (edge_y * sum_z - edge_z * sum_y) * d.x
        + (edge_z * sum_x - edge_x * sum_z) * d.y
        + (edge_x * sum_y - edge_y * sum_x) * d.z;
    Seen {
        a: Vec3::new(x.x, y.x, z.x),
        edge_x,
        edge_y,
        edge_z,
        functions,
    }
}

/// Distance in `(0, t_max)` at which the ray hits the triangle, from either side; [`f32::MAX`] where it does not.
///
/// A triangle without area, or seen edge-on, is never hit.
#[inline(always)]
#[must_use]
pub fn intersect(triangle: &Triangle, ray: &Ray, t_max: f32) -> f32 {
    let seen = seen(triangle, ray);
    if seen.functions.min_element() < 0.0 && seen.functions.max_element() > 0.0 {
        return f32::MAX;
    }
    let from_a = Vec3::new(seen.edge_x.y, seen.edge_y.y, seen.edge_z.y);
    let to_a = Vec3::new(seen.edge_x.z, seen.edge_y.z, seen.edge_z.z);
    let normal = from_a.cross(to_a);
    let slope = normal.dot(ray.direction);
    if slope == 0.0 {
        return f32::MAX;
    }
    let t = seen.a.dot(normal) / slope;
    if t > 0.0 && t < t_max { t } else { f32::MAX }
}

/// Barycentric weights of the second and third corner where the ray crosses the triangle, which it is known to hit.
#[inline]
#[must_use]
pub fn barycentrics(triangle: &Triangle, ray: &Ray) -> Vec2 {
    let w = seen(triangle, ray).functions.truncate();
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
        let face = Triangle::new(Vec3::ZERO, Vec3::X * 8.0, Vec3::Y * 8.0);
        let straight = Ray::new(Vec3::new(1.0, 1.0, 2.0), Vec3::NEG_Z);
        let expected = 2.0 * 8.0 * RAY_OFFSET;
        assert_eq!(face.setback(&straight, 2.0), expected);
        // Half as long a direction: twice as many of them.
        let half = Ray::new(Vec3::new(1.0, 1.0, 2.0), Vec3::NEG_Z * 0.5);
        assert_eq!(face.setback(&half, 4.0), 2.0 * expected);
        let flat = Ray::new(Vec3::new(1.0, 1.0, 2.0), Vec3::X);
        assert_eq!(face.setback(&flat, 2.0), 2.0);
    }

    #[test]
    fn layout_is_that_of_wgsl() {
        assert_eq!(core::mem::size_of::<Triangle>(), 64);
        assert_eq!(core::mem::offset_of!(Triangle, y), 16);
        assert_eq!(core::mem::offset_of!(Triangle, material), 48);
        assert_eq!(core::mem::offset_of!(Triangle, attributes), 56);
    }

    #[test]
    fn barycentrics_and_distance_from_both_sides() {
        let face = Triangle::new(Vec3::ZERO, Vec3::X, Vec3::Y);
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
        let left = Triangle::new(p, q, Vec3::new(0.3, 2.0, -1.0));
        let right = Triangle::new(q, p, Vec3::new(0.9, -2.0, 1.1));
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
        let point = Triangle::new(Vec3::X * 0.5, Vec3::X * 0.5, Vec3::X * 0.5);
        let line = Triangle::new(Vec3::ZERO, Vec3::X, Vec3::X * 0.5);
        let edge_on = Triangle::new(Vec3::ZERO, Vec3::X, Vec3::Z);
        for face in [point, line, edge_on] {
            assert_eq!(intersect(&face, &ray, f32::MAX), f32::MAX);
        }
    }
}
