//! Host file: the clear sky above the horizon, and what of it lights the land.

use super::sunlight::TURBIDITY;
use glam::{UVec2, Vec3, Vec4};
use glimt_probe::latlong::{texel_direction, texel_solid_angle_sr};
use hw_skymodel::rgb::{Channel, SkyParams, SkyState};
use rayon::prelude::*;
use std::f32::consts::FRAC_PI_2;

/// What lights the land.
#[derive(Clone, Copy, Debug)]
pub(super) struct Light {
    /// Irradiance of the sky on level ground.
    pub(super) sky: Vec3,
    /// Irradiance of the sun on what faces it.
    pub(super) sun: Vec3,
    /// Where it stands.
    pub(super) direction: Vec3,
    /// Mean radiance of the sky just above the horizon: what haze takes on.
    pub(super) horizon: Vec3,
}

impl Light {
    pub(super) fn under(texels: &[Vec4], size: UVec2, direction: Vec3, sun: Vec3) -> Self {
        let columns = size.x as usize;
        let mut light = Self {
            sky: Vec3::ZERO,
            sun,
            direction,
            horizon: Vec3::ZERO,
        };
        for (row, texels) in texels[..sky_rows(size) * columns]
            .chunks(columns)
            .enumerate()
        {
            let sum: Vec3 = texels.iter().map(|t| t.truncate()).sum();
            let cosine = texel_direction(UVec2::new(0, row as u32), size).z.max(0.0);
            light.sky += sum * cosine * texel_solid_angle_sr(row as u32, size);
            light.horizon = sum / columns as f32;
        }
        light
    }
}

/// Rows whose centre is above the horizon.
pub(super) fn sky_rows(size: UVec2) -> usize {
    size.y.div_ceil(2) as usize
}

/// Fills the upper half with the sky above ground of this albedo.
pub(super) fn fill(texels: &mut [Vec4], size: UVec2, sun: Vec3, ground: Vec3) {
    let state = SkyState::new(&SkyParams {
        elevation: sun.z.asin().clamp(0.0, FRAC_PI_2),
        turbidity: TURBIDITY as f32,
        albedo: ground.to_array(),
    })
    .expect("the sun stands above the horizon and the constants lie in the model's range");
    let columns = size.x as usize;
    texels[..sky_rows(size) * columns]
        .par_chunks_mut(columns)
        .enumerate()
        .for_each(|(row, texels)| {
            for (column, texel) in texels.iter_mut().enumerate() {
                let d = texel_direction(UVec2::new(column as u32, row as u32), size);
                let theta = d.z.max(0.0).acos();
                let gamma = d.dot(sun).clamp(-1.0, 1.0).acos();
                let radiance = |channel| state.radiance(theta, gamma, channel).max(0.0);
                *texel = Vec4::new(
                    radiance(Channel::R),
                    radiance(Channel::G),
                    radiance(Channel::B),
                    1.0,
                );
            }
        });
}
