//! Host file: the built-in surroundings: a clear sky, and what it lights.

mod dome;
mod land;
mod sunlight;

pub(super) use sunlight::irradiance as sun_irradiance;

use dome::Light;
use glam::{UVec2, Vec3, Vec4};

/// Width and height of the built-in surroundings in texels: a texel is 0.18° wide at the horizon.
pub(super) const SIZE: UVec2 = UVec2::new(2048, 1024);

/// The sky of Hosek and Wilkie 2012 over hills and a paved place: `size.x × size.y` texels, best 2:1. There is no disc of the sun
/// and no lamp in it. The sun stands in direction `sun` (unit length; below the horizon counts as on it), and lights the
/// ground with `irradiance` on what faces it.
pub(super) fn clear_sky(size: UVec2, sun: Vec3, irradiance: Vec3) -> Vec<Vec4> {
    let mut texels = vec![Vec4::ZERO; size.x as usize * size.y as usize];
    if !texels.is_empty() {
        dome::fill(&mut texels, size, sun, land::PAVING);
        let light = Light::under(&texels, size, sun, irradiance);
        land::fill(&mut texels, size, &light);
    }
    texels
}

#[cfg(test)]
mod tests {
    use super::*;
    use glimt_probe::latlong::texel_solid_angle_sr;

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
        let (fine, coarse) = (flux(SIZE / 2), flux(SIZE / 16));
        assert!((fine / coarse - 1.0).abs() < 0.02, "{fine} {coarse}");
    }
}
