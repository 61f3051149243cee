//! Host file: the built-in surroundings: a clear sky, and what it lights.

use super::{land, sun};
use glam::{UVec2, Vec3, Vec4};
use glimt_probe::latlong::{texel_direction, texel_solid_angle_sr};
use hw_skymodel::rgb::{Channel, SkyParams, SkyState};
use rayon::prelude::*;
use std::f32::consts::FRAC_PI_2;

/// The sky of Hosek and Wilkie 2012 over hills and a paved place: `size.x × size.y` texels, best 2:1. There is no disc of the sun
/// and no lamp in it. The sun stands in direction `sun` (unit length; below the horizon counts as on it), and lights the
/// ground with `irradiance` on what faces it.
pub(crate) fn clear_sky(size: UVec2, sun: Vec3, irradiance: Vec3) -> Vec<Vec4> {
    let mut texels = vec![Vec4::ZERO; size.x as usize * size.y as usize];
    if !texels.is_empty() {
        fill_sky(&mut texels, size, sun);
        let light = Light::under(&texels, size, sun, irradiance);
        land::fill(&mut texels, size, &light);
    }
    texels
}

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
    fn under(texels: &[Vec4], size: UVec2, direction: Vec3, sun: Vec3) -> Self {
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

fn fill_sky(texels: &mut [Vec4], size: UVec2, sun: Vec3) {
    let state = SkyState::new(&SkyParams {
        elevation: sun.z.asin().clamp(0.0, FRAC_PI_2),
        turbidity: sun::TURBIDITY as f32,
        albedo: land::PAVING.to_array(),
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

#[cfg(test)]
mod tests {
    use super::super::ENV_SIZE;
    use super::*;

    #[test]
    fn every_texel_is_light() {
        for elevation in [0.1_f32, 0.8] {
            let sun = Vec3::new(elevation.cos(), 0.0, elevation.sin());
            for size in [UVec2::new(128, 64), UVec2::ONE, UVec2::new(3, 5)] {
                let texels = clear_sky(size, sun, Vec3::splat(100.0));
                assert!(
                    texels
                        .iter()
                        .all(|t| t.min_element() > 0.0 && t.is_finite())
                );
            }
        }
    }

    /// What lights the floor does not depend on how finely the map is cut.
    #[test]
    fn two_resolutions_carry_the_same_energy() {
        let sun = Vec3::new(0.6, 0.6, 0.5).normalize();
        let flux = |size: UVec2| {
            let texels = clear_sky(size, sun, Vec3::splat(100.0));
            let power = texels.iter().enumerate().map(|(i, t)| {
                let row = i as u32 / size.x;
                f64::from(t.y) * f64::from(texel_solid_angle_sr(row, size))
            });
            power.sum::<f64>()
        };
        let (fine, coarse) = (flux(ENV_SIZE / 2), flux(ENV_SIZE / 16));
        assert!((fine / coarse - 1.0).abs() < 0.02, "{fine} {coarse}");
    }
}
