//! Host file: a scene of a square, a box and a sphere whose rays are traced in closed form, in f64, and the same scene as
//! meshes for the renderer.
//!
//! It shares no code with the renderer, so that the two can disagree.

use std::f64::consts::{PI, TAU};

use glam::{DVec3, Mat4, Vec3};
use glimt_render_gpu::prepare::scene::{Material, Mesh, Object, Reflection, SceneDescription};

use crate::quadrature::{Integral, direction};

/// Half the side of the square ground, at z = 0 around the origin.
const GROUND: f64 = 40.0;

/// A ground with a box and a sphere, all of one material.
#[derive(Clone, Copy, Debug)]
pub struct AnalyticScene {
    /// Lower and upper corner of the box.
    pub cuboid: [DVec3; 2],
    /// Centre of the sphere.
    pub centre: DVec3,
    /// Its radius.
    pub radius: f64,
    /// Diffuse albedo of everything.
    pub diffuse: DVec3,
    /// Specular albedo of everything.
    pub specular: DVec3,
    /// Blinn-Phong exponent of everything.
    pub exponent: f64,
}

/// A lat-long map of radiance.
#[derive(Clone, Debug)]
pub struct AnalyticMap {
    /// Width and height.
    pub size: [u32; 2],
    /// RGB, rows from +z.
    pub texels: Vec<DVec3>,
}

impl AnalyticMap {
    /// Integral of one channel of the radiance times `f`, by `(32 refinement)²` points in every texel, and 64 times
    /// as many in texels above ten times the median.
    fn integral(&self, channel: usize, refinement: u32, f: impl Fn(DVec3) -> f64) -> f64 {
        let [width, height] = self.size;
        let mut sorted: Vec<f64> = self.texels.iter().map(|t| t[channel]).collect();
        sorted.sort_by(f64::total_cmp);
        let bright = 10.0 * sorted[sorted.len() / 2];
        let mut sum = 0.0;
        for row in 0..height {
            let edge = |row: u32| (PI * f64::from(row) / f64::from(height)).cos();
            let (upper, lower) = (edge(row), edge(row + 1));
            for column in 0..width {
                let radiance = self.texels[(row * width + column) as usize][channel];
                if radiance == 0.0 {
                    continue;
                }
                let n = 32 * refinement * if radiance > bright { 8 } else { 1 };
                // Roberts' additive sequence: no edge of a shadow can run along its points.
                let inside: f64 = (0..n * n)
                    .map(|i| {
                        let i = f64::from(i);
                        let x = (0.5 + i * 0.754_877_666_246_692_8).fract();
                        let z =
                            upper + (lower - upper) * (0.5 + i * 0.569_840_290_998_053_3).fract();
                        let phi = PI - TAU * (f64::from(column) + x) / f64::from(width);
                        f(DVec3::from_array(direction(z, phi)))
                    })
                    .sum();
                let area = (upper - lower) * TAU / f64::from(width);
                sum += radiance * area * inside / f64::from(n * n);
            }
        }
        sum
    }
}

/// Where a ray hits: distance and outward normal.
type Hit = (f64, DVec3);

impl AnalyticScene {
    /// The first hit of a ray.
    #[must_use]
    pub fn hit(&self, origin: DVec3, direction: DVec3) -> Option<Hit> {
        let hits = [
            hit_ground(origin, direction),
            hit_box(self.cuboid, origin, direction),
            hit_sphere(self.centre, self.radius, origin, direction),
        ];
        hits.into_iter()
            .flatten()
            .min_by(|a, b| a.0.total_cmp(&b.0))
    }

    /// `ρ(wo, wi)` of the material for unit directions above the surface.
    fn brdf(&self, n: DVec3, wo: DVec3, wi: DVec3, channel: usize) -> f64 {
        let e = self.exponent;
        let cos_h = (wo + wi).normalize().dot(n).max(0.0);
        let normalisation = (e + 2.0) * (e + 4.0) / (8.0 * PI * ((-0.5 * e).exp2() + e));
        self.diffuse[channel] / PI + self.specular[channel] * normalisation * cos_h.powf(e)
    }

    /// One channel of the radiance that the surface, hit by a ray from `eye`, reflects towards it: `None` for a miss.
    ///
    /// Points are spread evenly over the solid angle of each texel, more where it is bright. The error is the difference
    /// from a quarter as many.
    #[must_use]
    pub fn reflected(
        &self,
        eye: DVec3,
        direction: DVec3,
        map: &AnalyticMap,
        channel: usize,
    ) -> Option<Integral> {
        let (t, n) = self.hit(eye, direction)?;
        let point = eye + t * direction + 1e-9 * n;
        let integrand = |wi: DVec3| {
            let cos = wi.dot(n);
            if cos <= 0.0 || self.hit(point, wi).is_some() {
                return 0.0;
            }
            self.brdf(n, -direction, wi, channel) * cos
        };
        let [coarse, value] = [1, 2].map(|refinement| map.integral(channel, refinement, integrand));
        Some(Integral {
            value,
            error: (value - coarse).abs(),
        })
    }

    /// The scene as meshes. The sphere has `2 rings²` faces and smooth normals.
    #[must_use]
    pub fn describe(&self, rings: u32) -> SceneDescription {
        let object = |mesh| Object {
            mesh,
            transform: Mat4::IDENTITY,
            material: None,
            catcher: false,
        };
        SceneDescription {
            meshes: vec![
                ground_mesh(),
                box_mesh(self.cuboid),
                sphere_mesh(self.centre, self.radius, rings),
            ],
            materials: vec![Material::from(Reflection::BlinnPhong {
                diffuse: self.diffuse.as_vec3(),
                specular: self.specular.as_vec3(),
                exponent: self.exponent as f32,
            })],
            textures: vec![],
            objects: vec![object(0), object(1), object(2)],
        }
    }
}

fn hit_ground(origin: DVec3, direction: DVec3) -> Option<Hit> {
    let t = -origin.z / direction.z;
    let p = origin + t * direction;
    let inside = p.x.abs() <= GROUND && p.y.abs() <= GROUND;
    (t > 0.0 && inside).then(|| (t, DVec3::Z * origin.z.signum()))
}

fn hit_box([low, high]: [DVec3; 2], origin: DVec3, direction: DVec3) -> Option<Hit> {
    let (mut enter, mut leave, mut normal) = (0.0, f64::INFINITY, DVec3::ZERO);
    for axis in 0..3 {
        let a = (low[axis] - origin[axis]) / direction[axis];
        let b = (high[axis] - origin[axis]) / direction[axis];
        if a.min(b) > enter {
            enter = a.min(b);
            normal = DVec3::ZERO;
            normal[axis] = -direction[axis].signum();
        }
        leave = leave.min(a.max(b));
    }
    (enter > 0.0 && enter < leave).then_some((enter, normal))
}

fn hit_sphere(centre: DVec3, radius: f64, origin: DVec3, direction: DVec3) -> Option<Hit> {
    let to_centre = centre - origin;
    let along = to_centre.dot(direction);
    let half_chord2 = radius * radius - (to_centre - along * direction).length_squared();
    if half_chord2 < 0.0 {
        return None;
    }
    let t = along - half_chord2.sqrt();
    (t > 0.0).then(|| (t, (origin + t * direction - centre) / radius))
}

fn ground_mesh() -> Mesh {
    let g = GROUND as f32;
    Mesh {
        name: "ground".into(),
        positions: [(-g, -g), (g, -g), (g, g), (-g, g)]
            .map(|(x, y)| Vec3::new(x, y, 0.0))
            .to_vec(),
        indices: vec![[0, 1, 2], [0, 2, 3]],
        materials: vec![0],
        ..Mesh::default()
    }
}

fn box_mesh([low, high]: [DVec3; 2]) -> Mesh {
    let mut mesh = Mesh {
        name: "box".into(),
        materials: vec![0],
        ..Mesh::default()
    };
    for axis in 0..3 {
        for side in [low, high] {
            let first = mesh.positions.len() as u32;
            for corner in 0..4 {
                let mut p = side;
                p[(axis + 1) % 3] = if corner & 1 == 0 { low } else { high }[(axis + 1) % 3];
                p[(axis + 2) % 3] = if corner & 2 == 0 { low } else { high }[(axis + 2) % 3];
                mesh.positions.push(p.as_vec3());
            }
            mesh.indices
                .extend([[first, first + 1, first + 3], [first, first + 3, first + 2]]);
        }
    }
    mesh
}

fn sphere_mesh(centre: DVec3, radius: f64, rings: u32) -> Mesh {
    let mut mesh = Mesh {
        name: "sphere".into(),
        materials: vec![0],
        ..Mesh::default()
    };
    let columns = 2 * rings;
    for ring in 0..=rings {
        for column in 0..columns {
            let theta = PI * f64::from(ring) / f64::from(rings);
            let phi = PI * f64::from(column) / f64::from(rings);
            let n = DVec3::new(
                theta.sin() * phi.cos(),
                theta.sin() * phi.sin(),
                theta.cos(),
            );
            mesh.positions.push((centre + radius * n).as_vec3());
            mesh.normals.push(n.as_vec3());
        }
    }
    for ring in 0..rings {
        for column in 0..columns {
            let next = (column + 1) % columns;
            let [a, b] = [column, next].map(|c| ring * columns + c);
            let [c, d] = [column, next].map(|c| (ring + 1) * columns + c);
            if ring > 0 {
                mesh.indices.push([a, c, b]);
            }
            if ring + 1 < rings {
                mesh.indices.push([b, c, d]);
            }
        }
    }
    mesh
}
