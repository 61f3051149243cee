//! Shared file: a pixel's hits in groups that share one proposal.

use glam::Vec3;
use glimt_brdf::normalisation;
use glimt_light_cells::CellSurface;
use glimt_sampling::math::luminance;

use super::environment::Environment;
use super::seen::{GROUPED, SeenPoint};

/// Cosine of the largest angle between the normal of a group's first member and that of another: 20°.
const NEAR: f32 = 0.939_692_6;

/// What is added to μ beside a fiftieth, so that no rounding leaves a member's horizon out.
const MARGIN: f32 = 1e-3;

/// Hits of one pixel on one material of one object, with normals near that of the first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Group {
    /// Its first place in the list of the pixel's hits.
    pub first: u32,
    /// Its members.
    pub members: u32,
}

/// What a group's members have in common.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Representative {
    /// Mean of the unit normals, in the map's coordinates.
    pub mean_normal: Vec3,
    /// Mean kd.
    pub diffuse: Vec3,
    /// Mean ks.
    pub specular: Vec3,
    /// Mean exponent, which nothing has widened.
    pub exponent: f32,
    /// `c(e)` of that.
    pub peak: f32,
    /// What cells see of it.
    pub surface: CellSurface,
}

impl Representative {
    /// Of one surface alone, of which nothing else is asked. Of its colours, the luminance is enough.
    #[inline]
    #[must_use]
    pub fn alone(
        normal: Vec3,
        wo: Vec3,
        diffuse: f32,
        specular: f32,
        exponent: f32,
        env: Environment<'_>,
    ) -> Representative {
        let (normal, wo) = (env.to_map(normal), env.to_map(wo));
        let surface = CellSurface::new(normal, wo, diffuse, specular, exponent, 1.0, 0.0);
        Representative {
            mean_normal: normal,
            diffuse: Vec3::splat(diffuse),
            specular: Vec3::splat(specular),
            exponent,
            peak: surface.peak,
            surface,
        }
    }
}

/// Whether a ray may join a group.
#[inline]
fn belongs(leader: &SeenPoint, point: &SeenPoint) -> bool {
    point.flags & GROUPED == 0
        && point.surface == leader.surface
        && point.material == leader.material
        && point.normal.dot(leader.normal) >= NEAR
}

/// The group of the first ray from `from` on that hits something and has none yet, of which the members take places `first` on
/// in the list of hits; no members where there is no such ray. `from` becomes that ray.
#[inline]
#[must_use]
pub fn next_group(points: &mut [SeenPoint], from: &mut u32, first: u32) -> Group {
    let rays = points.len() as u32;
    let mut leader = *from;
    while leader < rays
        && (points[leader as usize].flags & GROUPED != 0 || !points[leader as usize].is_hit())
    {
        leader += 1;
    }
    *from = leader;
    let mut members = 0;
    if leader < rays {
        let own = points[leader as usize];
        for ray in leader..rays {
            if belongs(&own, &points[ray as usize]) {
                points[(first + members) as usize].order = ray;
                points[ray as usize].flags |= GROUPED;
                members += 1;
            }
        }
    }
    Group { first, members }
}

impl Group {
    /// The ray of member `k`.
    #[inline]
    #[must_use]
    pub fn ray(&self, k: u32, points: &mut [SeenPoint]) -> u32 {
        points[(self.first + k) as usize].order
    }

    /// What its members have in common. It has one at least.
    #[inline]
    #[must_use]
    pub fn representative(&self, points: &mut [SeenPoint], env: Environment<'_>) -> Representative {
        let mut normal = Vec3::ZERO;
        let mut wo = Vec3::ZERO;
        let mut diffuse = Vec3::ZERO;
        let mut specular = Vec3::ZERO;
        let mut exponent = 0.0;
        for k in 0..self.members {
            let ray = self.ray(k, points);
            let point = points[ray as usize];
            normal += point.normal;
            wo += point.wo;
            diffuse += point.diffuse;
            specular += point.specular;
            exponent += point.exponent;
        }
        let share = 1.0 / self.members as f32;
        normal *= share;
        diffuse *= share;
        specular *= share;
        let length = normal.length();
        let unit = normal / length.max(1e-6);
        let mut horizon = 0.0_f32;
        if self.members > 1 {
            for k in 0..self.members {
                let ray = self.ray(k, points);
                let point = points[ray as usize];
                horizon = horizon.max(unit.cross(point.normal).length());
            }
            horizon = 1.02 * horizon + MARGIN;
        }
        let surface = CellSurface::new(
            env.to_map(unit),
            env.to_map(wo.normalize()),
            luminance(diffuse),
            luminance(specular),
            exponent * share,
            length,
            horizon,
        );
        Representative {
            mean_normal: env.to_map(normal),
            diffuse,
            specular,
            exponent: exponent * share,
            peak: normalisation(exponent * share),
            surface,
        }
    }
}
