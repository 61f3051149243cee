//! Shared file: the light map, looked up and sampled.

use glam::{UVec2, Vec2, Vec3, Vec4};
use glimt_envmap_cdf::{EnvCdf, EnvSample};
use glimt_light_cells::LightCells;
use glimt_probe::latlong::{direction_to_texel, direction_to_uv};
use glimt_probe::rotate::rotate_z;

/// A lat-long map of radiance with its tables, turned about the vertical.
#[derive(Clone, Copy, Debug)]
pub struct Environment<'a> {
    /// Linear RGB, row by row from +z.
    pub texels: &'a [Vec4],
    /// The tables that its method reads: those of [`Environment::cdf`], or those of [`Environment::cells`].
    pub tables: &'a [u32],
    /// Its columns and rows.
    pub size: UVec2,
    /// Cosine and sine of the angle by which it is turned, counter-clockwise seen from above.
    pub rotation: Vec2,
}

/// A light map without tables: one that directions are looked up in.
#[derive(Clone, Copy, Debug)]
pub struct RadianceMap<'a> {
    /// Linear RGB, row by row from +z.
    pub texels: &'a [Vec4],
    /// Its columns and rows.
    pub size: UVec2,
    /// Cosine and sine of the angle by which it is turned, as [`Environment::rotation`].
    pub rotation: Vec2,
}

impl RadianceMap<'_> {
    /// Radiance of the texel that a direction of the world falls into.
    #[inline]
    #[must_use]
    pub fn radiance(&self, direction: Vec3) -> Vec3 {
        let to_map = Vec2::new(self.rotation.x, -self.rotation.y);
        let texel = direction_to_texel(rotate_z(direction, to_map), self.size);
        self.texels[(texel.y * self.size.x + texel.x) as usize].truncate()
    }

    /// Radiance in a direction of the world, filtered as [`Environment::background`].
    #[inline]
    #[must_use]
    pub fn background(&self, direction: Vec3) -> Vec3 {
        let to_map = Vec2::new(self.rotation.x, -self.rotation.y);
        bilinear(self.texels, self.size, rotate_z(direction, to_map))
    }
}

impl<'a> Environment<'a> {
    /// The map without its tables.
    #[inline]
    #[must_use]
    pub fn map(&self) -> RadianceMap<'a> {
        RadianceMap {
            texels: self.texels,
            size: self.size,
            rotation: self.rotation,
        }
    }

    /// The tables that draw directions in proportion to the map's luminance, or to what of it is above the mean.
    #[inline]
    #[must_use]
    pub fn cdf(&self) -> EnvCdf<'a> {
        EnvCdf {
            size: self.size,
            marginal: self.tables,
            conditional: &self.tables[marginal_words(self.size) as usize..],
        }
    }

    /// The map's cells, where its tables are those.
    #[inline]
    #[must_use]
    pub fn cells(&self) -> LightCells<'a> {
        LightCells {
            size: self.size,
            words: self.tables,
            start: 0,
        }
    }

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
        direction_to_texel(self.to_map(direction), self.size)
    }

    /// Radiance of a texel.
    #[inline]
    #[must_use]
    pub fn radiance(&self, texel: UVec2) -> Vec3 {
        self.texels[(texel.y * self.size.x + texel.x) as usize].truncate()
    }

    /// A direction of the world, drawn by [`Environment::cdf`]. Its radiance is that of its texel.
    #[inline]
    #[must_use]
    pub fn sample(&self, u: UVec2) -> EnvSample {
        let sample = self.cdf().sample(u);
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
        self.map().background(direction)
    }
}

/// Words of the table of rows of a map of this size: the first of [`Environment::tables`].
#[inline]
#[must_use]
pub fn marginal_words(size: UVec2) -> u32 {
    size.y + 1
}

/// Words of the table of rows and of the tables of columns: where a table that follows them begins.
#[inline]
#[must_use]
pub fn cdf_words(size: UVec2) -> u32 {
    marginal_words(size) + size.y * (size.x + 1)
}

/// A lat-long map's colour in the direction `d` of its own coordinates (any length but zero), filtered bilinearly: values
/// stand at texel centres. The filter wraps around sideways and stops at the poles.
#[inline]
#[must_use]
pub fn bilinear(texels: &[Vec4], size: UVec2, d: Vec3) -> Vec3 {
    let p = direction_to_uv(d) * size.as_vec2() - Vec2::splat(0.5);
    // One more than the texel on the left and above: p begins at −½.
    let next = (p + Vec2::ONE).as_uvec2();
    let f = p + Vec2::ONE - next.as_vec2();
    let x0 = (next.x + size.x - 1) % size.x;
    let x1 = next.x % size.x;
    let row0 = next.y.max(1) * size.x - size.x;
    let row1 = next.y.min(size.y - 1) * size.x;
    let upper = texels[(row0 + x0) as usize].lerp(texels[(row0 + x1) as usize], f.x);
    let lower = texels[(row1 + x0) as usize].lerp(texels[(row1 + x1) as usize], f.x);
    upper.lerp(lower, f.y).truncate()
}
