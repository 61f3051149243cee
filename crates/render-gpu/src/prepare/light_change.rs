//! Host file: how much a light map differs from that of the frame before.

use glam::{UVec2, Vec2};
use glimt_probe::latlong::{direction_to_texel, texel_direction, texel_solid_angle_sr};
use glimt_probe::rotate::rotate_z;
use glimt_sampling::luminance;
use rayon::prelude::*;

use crate::kernels::environment::RadianceMap;

/// What a light map leaves to the next frame to compare itself with: the luminance of each texel.
#[derive(Clone, Debug)]
pub(crate) struct LightBefore {
    size: UVec2,
    rotation: Vec2,
    luminance: Vec<f32>,
}

impl LightBefore {
    /// Of this map.
    pub(crate) fn new(map: RadianceMap<'_>) -> Self {
        let luminance = map.texels.par_iter().map(|t| luminance(t.truncate()));
        Self {
            size: map.size,
            rotation: map.rotation,
            luminance: luminance.collect(),
        }
    }

    /// How much the distribution of light over directions of the world has changed: the total variation distance `½ ∫ |p − p′| dω`
    /// between this map's luminance p and `now`'s p′, each scaled to an integral of 1.
    ///
    /// 0 where `now` is this map times any factor, 1 where the two share no direction, and where one of them alone is black. Maps of
    /// unlike size or rotation are compared in the directions of the texels of `now`. The sums are in 64 bits and in one order on any
    /// number of threads.
    pub(crate) fn change(&self, now: RadianceMap<'_>) -> f32 {
        let aligned = now.size == self.size && now.rotation == self.rotation;
        let to_own = Vec2::new(self.rotation.x, -self.rotation.y);
        let before = |x: u32, y: u32| {
            let texel = match aligned {
                true => UVec2::new(x, y),
                false => {
                    let direction =
                        rotate_z(texel_direction(UVec2::new(x, y), now.size), now.rotation);
                    direction_to_texel(rotate_z(direction, to_own), self.size)
                }
            };
            f64::from(self.luminance[(texel.y * self.size.x + texel.x) as usize])
        };
        let here = |x: u32, y: u32| {
            let texel = now.texels[(y * now.size.x + x) as usize];
            f64::from(luminance(texel.truncate()))
        };
        let [old, new] = [integral(now.size, &before), integral(now.size, &here)];
        if !(old > 0.0 && new > 0.0) {
            return if old > 0.0 || new > 0.0 { 1.0 } else { 0.0 };
        }
        let apart = |x, y| (before(x, y) / old - here(x, y) / new).abs();
        (0.5 * integral(now.size, &apart)).min(1.0) as f32
    }
}

/// `∫ f dω` over all texels of a map of this size.
fn integral(size: UVec2, f: &(dyn Fn(u32, u32) -> f64 + Sync)) -> f64 {
    let of_row = |y| {
        let sum: f64 = (0..size.x).map(|x| f(x, y)).sum();
        sum * f64::from(texel_solid_angle_sr(y, size))
    };
    let rows: Vec<f64> = (0..size.y).into_par_iter().map(of_row).collect();
    rows.iter().sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec4;
    use glimt_probe::rotate::cos_sin_degrees;

    const SIZE: UVec2 = UVec2::new(16, 8);

    fn change(before: &[f32], now: &[f32], degrees: f32) -> f32 {
        let texels =
            |values: &[f32]| -> Vec<Vec4> { values.iter().map(|v| Vec4::splat(*v)).collect() };
        let (before, now) = (texels(before), texels(now));
        let map = |texels, degrees| RadianceMap {
            texels,
            size: SIZE,
            rotation: cos_sin_degrees(degrees),
        };
        LightBefore::new(map(&before, 0.0)).change(map(&now, degrees))
    }

    /// Light `a` in the left half of the map and `b` in the right.
    fn halves(a: f32, b: f32) -> Vec<f32> {
        (0..128).map(|i| if i % 16 < 8 { a } else { b }).collect()
    }

    #[test]
    fn it_is_the_share_of_the_light_that_moved() {
        let map = halves(1.0, 3.0);
        assert_eq!(change(&map, &map, 0.0), 0.0);
        // All lamps flicker together.
        assert!(change(&map, &halves(2.0, 6.0), 0.0) < 1e-6);
        // From a quarter and three quarters to a half each.
        assert!((change(&map, &halves(1.0, 1.0), 0.0) - 0.25).abs() < 1e-6);
        assert!((change(&map, &halves(3.0, 1.0), 0.0) - 0.5).abs() < 1e-6);
        assert!((change(&halves(1.0, 0.0), &halves(0.0, 1.0), 0.0) - 1.0).abs() < 1e-6);
    }

    #[test]
    fn black_maps_differ_from_all_others() {
        let (black, lit) = (halves(0.0, 0.0), halves(1.0, 0.0));
        assert_eq!(change(&black, &black, 0.0), 0.0);
        assert_eq!(change(&black, &lit, 0.0), 1.0);
        assert_eq!(change(&lit, &black, 0.0), 1.0);
    }

    #[test]
    fn a_turned_map_is_compared_in_the_directions_of_the_world() {
        let map = halves(1.0, 3.0);
        assert!((change(&map, &map, 180.0) - 0.5).abs() < 1e-6);
        assert!(change(&map, &halves(3.0, 1.0), 180.0) < 1e-6);
        let other = RadianceMap {
            texels: &[Vec4::ONE; 2],
            size: UVec2::new(2, 1),
            rotation: Vec2::X,
        };
        let before = RadianceMap {
            texels: &[Vec4::ONE; 128],
            size: SIZE,
            rotation: Vec2::X,
        };
        assert!(LightBefore::new(before).change(other) < 1e-6);
    }
}
