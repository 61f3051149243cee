//! Host file: triangle meshes of smooth parametric patches: turned solids, rings, rods.

use glam::{DMat3, DVec2, DVec3, UVec2, dvec2, dvec3};
use glimt_render_gpu::prepare::scene::Mesh;
use std::f64::consts::TAU;

/// A mesh under construction.
#[derive(Default)]
pub(super) struct Solid {
    mesh: Mesh,
}

impl Solid {
    pub(super) fn named(name: &str) -> Self {
        Self {
            mesh: Mesh {
                name: name.to_owned(),
                ..Mesh::default()
            },
        }
    }

    pub(super) fn into_mesh(self) -> Mesh {
        self.mesh
    }

    /// Adds the image of the unit square under `surface`, cut into `cells.x × cells.y` quadrilaterals.
    ///
    /// The outside is where `∂/∂u × ∂/∂v` points. Normals are the surface's own, so an edge between two patches is sharp
    /// and a periodic surface (which must be defined a little beyond the square) closes without a seam. Where a side of
    /// the square shrinks to a point, the triangles without area are left out.
    pub(super) fn patch(&mut self, material: u32, cells: UVec2, surface: impl Fn(DVec2) -> DVec3) {
        let first = self.mesh.positions.len() as u32;
        for j in 0..=cells.y {
            for i in 0..=cells.x {
                let uv = dvec2(f64::from(i), f64::from(j)) / cells.as_dvec2();
                self.mesh.positions.push(surface(uv).as_vec3());
                self.mesh.normals.push(normal(&surface, uv).as_vec3());
            }
        }
        let stride = cells.x + 1;
        for j in 0..cells.y {
            for i in 0..cells.x {
                let a = first + j * stride + i;
                let (b, c, d) = (a + 1, a + 1 + stride, a + stride);
                self.triangle(material, [a, b, c]);
                self.triangle(material, [a, c, d]);
            }
        }
    }

    fn triangle(&mut self, material: u32, corners: [u32; 3]) {
        let [a, b, c] = corners.map(|i| self.mesh.positions[i as usize]);
        if (b - a).cross(c - a).length_squared() > 1e-16 {
            self.mesh.indices.push(corners);
            self.mesh.materials.push(material);
        }
    }

    /// Adds a surface turned about the z axis. `profile` gives radius and height for its parameter in [0, 1]; walked
    /// upwards, the outside is away from the axis.
    pub(super) fn lathe(&mut self, material: u32, cells: UVec2, profile: impl Fn(f64) -> DVec2) {
        self.patch(material, cells, |uv| {
            let p = profile(uv.y);
            around_z(uv.x, p.x) + p.y * DVec3::Z
        });
    }

    /// Adds a ring about the z axis of `place`, then turned and moved by it.
    pub(super) fn ring(&mut self, material: u32, cells: UVec2, ring: &Ring, place: &Placement) {
        let Ring {
            radius,
            half,
            knurl,
        } = *ring;
        self.patch(material, cells, |uv| {
            let section = half * rounded_square(TAU * uv.y);
            let outer = (section.x / half.x).max(0.0);
            let notch =
                knurl.depth * outer * outer * (0.5 - 0.5 * (TAU * knurl.count * uv.x).cos());
            place.at(around_z(uv.x, radius + section.x - notch) + section.y * DVec3::Z)
        });
    }

    /// Adds a ball.
    pub(super) fn ball(&mut self, material: u32, cells: UVec2, radius: f64, place: &Placement) {
        self.patch(material, cells, |uv| {
            let theta = (1.0 - uv.y) * std::f64::consts::PI;
            place.at(around_z(uv.x, radius * theta.sin()) + radius * theta.cos() * DVec3::Z)
        });
    }

    /// Adds a rod along the z axis of `place` whose radius at height z is `radius(z)`, open at both ends.
    pub(super) fn rod(
        &mut self,
        material: u32,
        cells: UVec2,
        heights: [f64; 2],
        radius: impl Fn(f64) -> f64,
        place: &Placement,
    ) {
        self.patch(material, cells, |uv| {
            let z = heights[0] + (heights[1] - heights[0]) * uv.y;
            place.at(around_z(uv.x, radius(z)) + z * DVec3::Z)
        });
    }
}

/// A ring whose section is a rounded rectangle.
#[derive(Clone, Copy)]
pub(super) struct Ring {
    /// From its axis to the middle of its section.
    pub(super) radius: f64,
    /// Half its thickness along the radius, and half its width along the axis.
    pub(super) half: DVec2,
    /// Notches around its outer face.
    pub(super) knurl: Knurl,
}

impl Ring {
    /// Without notches.
    pub(super) fn plain(radius: f64, half: DVec2) -> Self {
        Self {
            radius,
            half,
            knurl: Knurl::NONE,
        }
    }
}

/// Notches around the outside of a ring.
#[derive(Clone, Copy)]
pub(super) struct Knurl {
    pub(super) count: f64,
    pub(super) depth: f64,
}

impl Knurl {
    pub(super) const NONE: Self = Self {
        count: 0.0,
        depth: 0.0,
    };
}

/// A rotation, then a translation.
#[derive(Clone, Copy)]
pub(super) struct Placement {
    pub(super) turn: DMat3,
    pub(super) origin: DVec3,
}

impl Placement {
    /// Where it is.
    pub(super) const IDENTITY: Self = Self {
        turn: DMat3::IDENTITY,
        origin: DVec3::ZERO,
    };

    /// Moved up the z axis.
    pub(super) fn at_height(height: f64) -> Self {
        Self::IDENTITY.raised(height)
    }

    pub(super) fn at(&self, local: DVec3) -> DVec3 {
        self.turn * local + self.origin
    }

    /// The same place with another rotation applied first.
    pub(super) fn turned(&self, turn: DMat3) -> Self {
        Self {
            turn: self.turn * turn,
            ..*self
        }
    }

    /// The same place moved along its own z axis.
    pub(super) fn raised(&self, by: f64) -> Self {
        Self {
            origin: self.at(by * DVec3::Z),
            ..*self
        }
    }
}

/// The point at `radius` from the z axis after `turns` turns from +x towards +y.
pub(super) fn around_z(turns: f64, radius: f64) -> DVec3 {
    let (sin, cos) = (TAU * turns).sin_cos();
    dvec3(radius * cos, radius * sin, 0.0)
}

/// A point of the curve x⁶ + y⁶ = 1, counter-clockwise from +x.
pub(super) fn rounded_square(angle: f64) -> DVec2 {
    let (sin, cos) = angle.sin_cos();
    dvec2(cos, sin) / (cos.powi(6) + sin.powi(6)).powf(1.0 / 6.0)
}

/// The unit normal of a surface, from central differences. At a pole, where one of them is nothing, that of a place
/// beside it.
fn normal(surface: &impl Fn(DVec2) -> DVec3, uv: DVec2) -> DVec3 {
    let step = 1e-5;
    let cross_at = |uv: DVec2| {
        let du = surface(uv + dvec2(step, 0.0)) - surface(uv - dvec2(step, 0.0));
        let dv = surface(uv + dvec2(0.0, step)) - surface(uv - dvec2(0.0, step));
        (du.cross(dv), du.length() * dv.length())
    };
    let beside = uv + dvec2(0.0, (0.5 - uv.y) * 1e-3);
    let (cross, scale) = cross_at(uv);
    let (cross, _) = if scale > 1e-14 && cross.length() > 1e-3 * scale {
        (cross, scale)
    } else {
        cross_at(beside)
    };
    cross.normalize_or(DVec3::Z)
}
