//! Shared file: the light map, looked up and sampled.

use glam::{UVec2, Vec2, Vec3, Vec4};
use glimt_envmap_cdf::{EnvCdf, EnvSample};
use glimt_probe::latlong::{direction_to_texel, direction_to_uv};
use glimt_probe::rotate::rotate_z;

/// A lat-long map of radiance with its tables, turned about the vertical.
#[derive(Clone, Copy, Debug)]
pub struct Environment<'a> {
    /// Linear RGB, row by row from +z; as many texels as the tables' size says.
    pub texels: &'a [Vec4],
    /// Its tables.
    pub cdf: EnvCdf<'a>,
    /// Cosine and sine of the angle by which it is turned, counter-clockwise seen from above.
    pub rotation: Vec2,
}

impl Environment<'_> {
    /// The direction in the map's own coordinates of a direction in the world.
    #[inline]
    #[must_use]
    pub fn to_map(&self, direction: Vec3) -> Vec3 {
        rotate_z(direction, Vec2::new(self.rotation.x, -self.rotation.y))
    }

    /// The texel that a direction of the world falls into.
    #[inline]
    #[must_use]
    pub fn texel(&self, direction: Vec3) -> UVec2 {
        direction_to_texel(self.to_map(direction), self.cdf.size)
    }

    /// Radiance of a texel.
    #[inline]
    #[must_use]
    pub fn radiance(&self, texel: UVec2) -> Vec3 {
        self.texels[(texel.y * self.cdf.size.x + texel.x) as usize].truncate()
    }

    /// A direction of the world, drawn in proportion to the map's luminance. Its radiance is that of its texel.
    #[inline]
    #[must_use]
    pub fn sample(&self, u: UVec2) -> EnvSample {
        let sample = self.cdf.sample(u);
        EnvSample {
            direction: rotate_z(sample.direction, self.rotation),
            ..sample
        }
    }

    /// Radiance in a direction of the world, filtered bilinearly: for the eye alone, as no density belongs to it.
    ///
    /// The filter wraps around sideways and stops at the poles.
    #[inline]
    #[must_use]
    pub fn background(&self, direction: Vec3) -> Vec3 {
        let size = self.cdf.size;
        let p = direction_to_uv(self.to_map(direction)) * size.as_vec2() - Vec2::splat(0.5);
        let corner = p.floor();
        let f = p - corner;
        // One map's width more, so that the column left of the seam is not negative.
        let x0 = (corner.x + size.x as f32) as u32 % size.x;
        let x1 = (x0 + 1) % size.x;
        let y0 = corner.y.max(0.0) as u32;
        let y1 = ((corner.y + 1.0) as u32).min(size.y - 1);
        let upper = self
            .radiance(UVec2::new(x0, y0))
            .lerp(self.radiance(UVec2::new(x1, y0)), f.x);
        let lower = self
            .radiance(UVec2::new(x0, y1))
            .lerp(self.radiance(UVec2::new(x1, y1)), f.x);
        upper.lerp(lower, f.y)
    }
}
