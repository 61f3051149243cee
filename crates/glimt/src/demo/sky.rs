//! Host file: the light of the shot: a clear sky, the sun, lamps, and the ground that they light.

use super::{armillary, lamps, sun};
use glam::{UVec2, Vec3, Vec4};
use glimt_probe::latlong::{texel_direction, texel_solid_angle_sr};
use glimt_render_gpu::host::env::{EnvError, EnvMap};
use hw_skymodel::rgb::{Channel, SkyParams, SkyState};
use rayon::prelude::*;
use std::f32::consts::{FRAC_1_PI, FRAC_PI_2};

/// The lat-long light map of a frame: `size.x × size.y` texels, best 2:1 ([`super::ENV_SIZE`]).
///
/// The upper half is the sky of Hosek and Wilkie 2012 with our own sun and lamps; the lower is ground as bright as the
/// floor of the scene where nothing shades it, so that the floor meets the horizon without an edge.
///
/// # Errors
/// [`EnvError::Size`] for an empty map.
pub fn environment(frame: u32, size: UVec2) -> Result<EnvMap, EnvError> {
    let mut texels = vec![Vec4::ZERO; size.x as usize * size.y as usize];
    if !texels.is_empty() {
        fill_sky(&mut texels, size, sun::direction(frame).as_vec3());
        sun::add(&mut texels, size, frame);
        lamps::add(&mut texels, size, frame);
        fill_ground(&mut texels, size, Vec3::ZERO);
    }
    EnvMap::new(size, texels)
}

/// The same sky and ground with nothing in the sky: no disc of the sun and no lamps. The sun stands in direction `sun` (unit
/// length; below the horizon counts as on it), and `irradiance` on what faces it is counted on the ground.
pub(crate) fn clear_sky(size: UVec2, sun: Vec3, irradiance: Vec3) -> Vec<Vec4> {
    let mut texels = vec![Vec4::ZERO; size.x as usize * size.y as usize];
    if !texels.is_empty() {
        fill_sky(&mut texels, size, sun);
        fill_ground(&mut texels, size, irradiance * sun.z.max(0.0));
    }
    texels
}

/// Rows whose centre is above the horizon.
fn sky_rows(size: UVec2) -> usize {
    size.y.div_ceil(2) as usize
}

fn fill_sky(texels: &mut [Vec4], size: UVec2, sun: Vec3) {
    let state = SkyState::new(&SkyParams {
        elevation: sun.z.asin().clamp(0.0, FRAC_PI_2),
        turbidity: sun::TURBIDITY as f32,
        albedo: armillary::FLOOR.to_array(),
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

/// Fills the lower half with the radiance of the floor under the upper half, with a little haze towards the horizon.
/// `further` is irradiance on it that the map does not hold.
fn fill_ground(texels: &mut [Vec4], size: UVec2, further: Vec3) {
    let columns = size.x as usize;
    let (sky, ground) = texels.split_at_mut(sky_rows(size) * columns);
    let mut irradiance = further;
    let mut horizon = Vec3::ZERO;
    for (row, texels) in sky.chunks(columns).enumerate() {
        let sum: Vec3 = texels.iter().map(|t| t.truncate()).sum();
        let cosine = texel_direction(UVec2::new(0, row as u32), size).z.max(0.0);
        irradiance += sum * cosine * texel_solid_angle_sr(row as u32, size);
        horizon = sum / columns as f32;
    }
    let floor = armillary::FLOOR * irradiance * FRAC_1_PI;
    for (row, texels) in ground.chunks_mut(columns).enumerate() {
        let row = (sky_rows(size) + row) as u32;
        let below = -texel_direction(UVec2::new(0, row), size).z;
        let haze = 0.6 * (-below / 0.02).exp();
        texels.fill(floor.lerp(horizon, haze).extend(1.0));
    }
}

#[cfg(test)]
mod tests {
    use super::super::{ENV_SIZE, FRAMES};
    use super::*;

    #[test]
    fn every_frame_is_a_map_with_a_strong_sun() {
        for frame in [0, FRAMES / 2, FRAMES - 1] {
            let map = environment(frame, ENV_SIZE).expect("a map");
            let brightest = map.texels().iter().map(|t| t.y).fold(0.0, f32::max);
            let zenith = map.texels()[0].y;
            assert!(brightest > 1e4 * zenith, "{brightest} {zenith}");
            assert!(map.texels().last().expect("a texel").min_element() > 0.0);
        }
        assert!(environment(0, UVec2::ZERO).is_err());
        assert!(environment(0, UVec2::ONE).is_ok());
    }

    /// What lights the floor does not depend on how finely the map is cut.
    #[test]
    fn two_resolutions_carry_the_same_energy() {
        let flux = |size: UVec2| {
            let map = environment(5, size).expect("a map");
            let texels = map.texels().iter().enumerate();
            let power = texels.map(|(i, t)| {
                let row = i as u32 / size.x;
                f64::from(t.y) * f64::from(texel_solid_angle_sr(row, size))
            });
            power.sum::<f64>()
        };
        let (fine, coarse) = (flux(ENV_SIZE), flux(ENV_SIZE / 8));
        assert!((fine / coarse - 1.0).abs() < 0.01, "{fine} {coarse}");
    }
}
