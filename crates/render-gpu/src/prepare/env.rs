//! Host file: light maps and the tables that are made of them.

use std::f64::consts::PI;

use glam::{DVec3, UVec2, Vec2, Vec4};
use glimt_envmap_cdf::BuildError;
use glimt_probe::latlong::texel_solid_angle_sr;
use glimt_probe::rotate::cos_sin_degrees;
use rayon::prelude::*;

use super::light_tables::{self, BuiltTables, Light, TableBuffer};
use super::render::SettingsError;
use crate::kernels::environment::Environment;
use crate::methods::Method;

/// Largest radiance that a texel may have. It keeps every product of the estimators finite in f32.
pub const MAX_RADIANCE: f32 = 1e20;

/// A lat-long map of radiance: row 0 at +z, its centre along +x, its left half toward +y.
#[derive(Clone, Debug)]
pub struct EnvMap {
    size: UVec2,
    texels: Vec<Vec4>,
}

/// How bright a light map is, in its brightest channel.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Brightness {
    /// The mean over all directions.
    pub mean: f32,
    /// The brightest texel's.
    pub largest: f32,
}

/// Why a light map was refused.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum EnvError {
    /// There is no texel, or their number is not width × height.
    #[error("a map of {width} × {height} texels cannot hold {len} of them")]
    Size {
        /// Width that was asked for.
        width: u32,
        /// Height that was asked for.
        height: u32,
        /// Texels given.
        len: usize,
    },
    /// A texel is negative, not a number, or above [`MAX_RADIANCE`].
    #[error("texel ({column}, {row}) is negative, not finite, or above 1e20")]
    Texel {
        /// Column of the first such texel.
        column: u32,
        /// Row of the first such texel.
        row: u32,
    },
    /// Its tables cannot be built.
    #[error(transparent)]
    Table(#[from] BuildError),
}

impl EnvMap {
    /// A map of `size.x * size.y` linear RGB texels, rows from the top; their w is ignored.
    ///
    /// # Errors
    /// [`EnvError::Size`] and [`EnvError::Texel`].
    pub fn new(size: UVec2, texels: Vec<Vec4>) -> Result<Self, EnvError> {
        if texels.is_empty() || texels.len() as u64 != u64::from(size.x) * u64::from(size.y) {
            return Err(EnvError::Size {
                width: size.x,
                height: size.y,
                len: texels.len(),
            });
        }
        if let Some(bad) = texels.par_iter().position_first(|t| !is_radiance(*t)) {
            let bad = bad as u32;
            return Err(EnvError::Texel {
                column: bad % size.x,
                row: bad / size.x,
            });
        }
        Ok(Self { size, texels })
    }

    /// Sets every channel that [`EnvMap::new`] would refuse to 0 and says how many texels had one.
    pub fn repair(texels: &mut [Vec4]) -> usize {
        let channel = |c: f32| match c >= 0.0 && c <= MAX_RADIANCE {
            true => c,
            false => 0.0,
        };
        let repaired = |texel: &mut Vec4| {
            let is_bad = !is_radiance(*texel);
            if is_bad {
                *texel = Vec4::from_array(texel.to_array().map(channel));
            }
            usize::from(is_bad)
        };
        texels.par_iter_mut().map(repaired).sum()
    }

    /// Width and height in texels.
    pub fn size(&self) -> UVec2 {
        self.size
    }

    /// The texels, rows from the top.
    pub fn texels(&self) -> &[Vec4] {
        &self.texels
    }

    /// The map without tables, for what draws no directions from it: it is looked up as ever, and sampled as a black map. Methods
    /// that read a table refuse it.
    ///
    /// # Errors
    /// As [`EnvMap::prepare`].
    pub fn without_tables(self, rotate_z_deg: f32) -> Result<PreparedEnv, EnvError> {
        self.prepare_tables(rotate_z_deg, &|_| false)
    }

    /// Builds the map's tables for all methods, on all of rayon's threads, for a map that stands turned by `rotate_z_deg`,
    /// counter-clockwise seen from above.
    ///
    /// # Errors
    /// [`EnvError::Table`] for a map wider or higher than [`glimt_envmap_cdf::MAX_SIZE`].
    pub fn prepare(self, rotate_z_deg: f32) -> Result<PreparedEnv, EnvError> {
        self.prepare_tables(rotate_z_deg, &|_| true)
    }

    /// As [`EnvMap::prepare`], but builds those tables alone that a method reads with its settings. Others may refuse the map.
    ///
    /// # Errors
    /// As [`EnvMap::prepare`].
    pub fn prepare_for(self, method: &Method, rotate_z_deg: f32) -> Result<PreparedEnv, EnvError> {
        self.prepare_tables(rotate_z_deg, &|table| method.reads(table))
    }

    fn prepare_tables(
        self,
        rotate_z_deg: f32,
        wanted: &dyn Fn(&str) -> bool,
    ) -> Result<PreparedEnv, EnvError> {
        let Self { size, texels } = self;
        let mut light = Light {
            size,
            texels: &texels,
            row_luminance: Vec::new(),
        };
        let buffers = light_tables::build(&mut light, wanted)?;
        let rows = light.row_luminance.iter().zip(0..size.y);
        let energies = rows.map(|(sum, row)| sum * f64::from(texel_solid_angle_sr(row, size)));
        let mean_luminance = (energies.sum::<f64>() / (4.0 * PI)) as f32;
        Ok(PreparedEnv {
            size,
            texels,
            buffers,
            rotation: cos_sin_degrees(rotate_z_deg),
            mean_luminance,
        })
    }
}

/// A light map with its tables, ready for an executor.
#[derive(Clone, Debug)]
pub struct PreparedEnv {
    size: UVec2,
    texels: Vec<Vec4>,
    /// The first holds what is made of luminance as it is.
    buffers: Vec<TableBuffer>,
    rotation: Vec2,
    mean_luminance: f32,
}

impl PreparedEnv {
    /// The map's mean luminance over all directions, whatever its tables are of; 0 without tables.
    #[must_use]
    pub fn mean_luminance(&self) -> f32 {
        self.mean_luminance
    }

    /// How bright the map is: goes through all texels.
    #[must_use]
    pub fn brightness(&self) -> Brightness {
        brightness(self.size, &self.texels)
    }

    /// What kernels see of it, with the tables that draw in proportion to luminance. Where those were not built, they are black.
    pub fn view(&self) -> Environment<'_> {
        self.view_with(&self.buffers[0])
    }

    /// What the kernels of a method see of it, with the tables that the method reads.
    ///
    /// # Errors
    /// [`SettingsError::Tables`] where they were not built.
    pub fn view_for(&self, method: &Method) -> Result<Environment<'_>, SettingsError> {
        Ok(self.view_with(self.buffer_for(method)?))
    }

    /// The tables in [`PreparedEnv::view_for`], by name.
    pub(crate) fn tables_for(&self, method: &Method) -> Result<&BuiltTables, SettingsError> {
        Ok(&self.buffer_for(method)?.built)
    }

    fn buffer_for(&self, method: &Method) -> Result<&TableBuffer, SettingsError> {
        let mut buffers = self.buffers.iter();
        let serving = buffers.find(|buffer| buffer.built.serve(method));
        serving.ok_or(SettingsError::Tables)
    }

    fn view_with<'a>(&'a self, buffer: &'a TableBuffer) -> Environment<'a> {
        Environment {
            texels: &self.texels,
            tables: &buffer.words,
            size: self.size,
            rotation: self.rotation,
        }
    }
}

fn brightness(size: UVec2, texels: &[Vec4]) -> Brightness {
    let of_row = |(row, texels): (u32, &[Vec4])| {
        let start = (Vec4::ZERO, Vec4::ZERO);
        let add = |(sum, largest): (Vec4, Vec4), t: &Vec4| (sum + *t, largest.max(*t));
        let (sum, largest) = texels.iter().fold(start, add);
        let area = f64::from(texel_solid_angle_sr(row, size));
        (
            sum.truncate().as_dvec3() * area,
            largest.truncate().max_element(),
        )
    };
    let join =
        |(flux, largest): (DVec3, f32), (row, own): (DVec3, f32)| (flux + row, largest.max(own));
    let rows: Vec<_> = texels
        .par_chunks(size.x as usize)
        .enumerate()
        .with_min_len(64)
        .map(|(row, texels)| of_row((row as u32, texels)))
        .collect();
    let (flux, largest) = rows.into_iter().fold((DVec3::ZERO, 0.0), join);
    Brightness {
        mean: (flux.max_element() / (4.0 * PI)) as f32,
        largest,
    }
}

fn is_radiance(texel: Vec4) -> bool {
    texel.min_element() >= 0.0
        && texel.x <= MAX_RADIANCE
        && texel.y <= MAX_RADIANCE
        && texel.z <= MAX_RADIANCE
}
