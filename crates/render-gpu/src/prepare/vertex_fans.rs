//! Host file: the triangles around each vertex of a mesh, and where rays start that leave it.
//!
//! All triangles around a vertex meet in it, and walls, floors and neighbours often pass through it, too: a ray from there
//! would begin on all of them at once. So it starts beside it.

use glam::Vec3;

use super::scene::Mesh;
use super::transfer::SurfaceVertex;
use crate::kernels::triangle::RAY_OFFSET;

/// How far rays start inside an edge of the surface, in units of their height above it, were the surface all on one side of the
/// vertex.
const INSET: f32 = 8.0;

/// What is known of the triangles around each vertex.
pub(super) struct Fans {
    fans: Vec<Fan>,
}

/// The triangles around one vertex.
#[derive(Clone, Copy, Default)]
struct Fan {
    normal: Vec3,
    /// The largest coordinate.
    extent: f32,
    /// From the vertex to the triangles' common centre, times their area.
    moment: Vec3,
    area: f32,
    /// The longest edge that meets the vertex.
    radius: f32,
    /// The way to the fan's middle leads below one of the triangles, so rays start straight above the vertex.
    is_edge_of_solid: bool,
}

impl Fans {
    /// Of a mesh with its vertices at `positions` in the world; `normal` gives those there.
    pub(super) fn new(mesh: &Mesh, positions: &[Vec3], normal: impl Fn(usize) -> Vec3) -> Self {
        let start = |i| Fan {
            normal: normal(i),
            ..Fan::default()
        };
        let mut fans: Vec<Fan> = (0..positions.len()).map(start).collect();
        for face in &mesh.indices {
            let corners = face.map(|i| positions[i as usize]);
            let [a, b, c] = corners;
            let area = (b - a).cross(c - a).length();
            let middle = (a + b + c) / 3.0;
            let extent = a.abs().max(b.abs()).max(c.abs()).max_element();
            for (k, &i) in face.iter().enumerate() {
                let fan = &mut fans[i as usize];
                let own = corners[k];
                let edges = [corners[(k + 1) % 3], corners[(k + 2) % 3]].map(|p| p.distance(own));
                fan.extent = fan.extent.max(extent);
                fan.moment += (middle - own) * area;
                fan.area += area;
                fan.radius = fan.radius.max(edges[0]).max(edges[1]);
            }
        }
        // A way to the fan's middle must not lead below its own triangles, as it would at the corner of a box whose sides share
        // a normal.
        for face in &mesh.indices {
            let [a, b, c] = face.map(|i| positions[i as usize]);
            let up = (b - a).cross(c - a).normalize_or_zero();
            for &i in face {
                let fan = &mut fans[i as usize];
                let slope = fan.normal.dot(up);
                let up = if slope < 0.0 { -up } else { up };
                let offset = RAY_OFFSET * fan.extent;
                let gained = fan.along(offset).dot(up);
                fan.is_edge_of_solid |= gained < -0.5 * offset * slope.abs();
            }
        }
        Self { fans }
    }

    /// The vertex `index`, at `position`, of an object.
    pub(super) fn vertex(&self, index: usize, position: Vec3, object: u32) -> SurfaceVertex {
        let fan = &self.fans[index];
        let offset = RAY_OFFSET * fan.extent;
        let along = match fan.is_edge_of_solid {
            true => Vec3::ZERO,
            false => fan.along(offset),
        };
        let middle = fan.middle();
        let far = middle.length();
        let inset = match far > 0.0 {
            true => middle * (0.5 * INSET * offset / far).min(0.25),
            false => Vec3::ZERO,
        };
        SurfaceVertex {
            position,
            normal: fan.normal,
            origin: position + fan.normal * offset + along,
            inner: position + inset - fan.normal * (2.0 * offset),
            object,
        }
    }
}

impl Fan {
    /// From the vertex to the triangles' common centre.
    fn middle(&self) -> Vec3 {
        match self.area > 0.0 {
            true => self.moment / self.area,
            false => Vec3::ZERO,
        }
    }

    /// How far along the surface rays start: to the fan's middle, the farther the more it lies on one side; where it lies all
    /// around, some way, so that no thin wall that stands on the vertex is missed by all of them.
    fn along(&self, offset: f32) -> Vec3 {
        if !(self.radius > 0.0) {
            return Vec3::ZERO;
        }
        let middle = self.middle();
        let tangential = middle - self.normal * self.normal.dot(middle);
        let way = tangential * (INSET * offset / self.radius);
        match way.length() >= offset {
            true => way,
            false => self.normal.any_orthogonal_vector().normalize_or_zero() * offset,
        }
    }
}
