//! Host file: clouds that drift before sky and sun: a smooth random field of attenuation on a flat layer above the ground.

use super::settings::Clouds;
use glam::{DVec2, Vec3, dvec2};
use glimt_sampling::hash::hash3;

/// Octaves of the noise.
const OCTAVES: u32 = 5;

/// The share of light that the clouds let through, from direction `d` (unit length, z up) at time `time`, 0 in the first frame
/// and 1 in the last. It is 1 below the horizon, and fades to 1 just above it, where the layer is far away.
pub(super) fn transmittance(clouds: &Clouds, seed: u32, d: Vec3, time: f64) -> f32 {
    if clouds.cover <= 0.0 || d.z <= 0.0 {
        return 1.0;
    }
    let d = d.as_dvec3();
    let drift = dvec2(f64::from(clouds.drift[0]), f64::from(clouds.drift[1]));
    let place = (dvec2(d.x, d.y) / (d.z + 0.05) + drift * time) / f64::from(clouds.scale);
    // The noise is near to normal about 1/2; the threshold lets through the share that is asked for.
    let threshold = 0.5 + 0.27 * (0.5 - f64::from(clouds.cover)) * 2.0;
    let density = smooth_step((noise(seed, place) - threshold + 0.1) / 0.2);
    let near = smooth_step(d.z / 0.08);
    (-f64::from(clouds.depth) * density * near).exp() as f32
}

/// 0 below 0, 1 above 1, smooth between.
fn smooth_step(x: f64) -> f64 {
    let x = x.clamp(0.0, 1.0);
    x * x * (3.0 - 2.0 * x)
}

/// Value noise of several octaves (Perlin's fractal sum), in [0, 1].
fn noise(seed: u32, place: DVec2) -> f64 {
    let (mut sum, mut weight, mut scale) = (0.0, 0.5, 1.0);
    let mut total = 0.0;
    for octave in 0..OCTAVES {
        sum += weight * value_noise(seed.wrapping_add(octave), place * scale);
        total += weight;
        weight *= 0.5;
        scale *= 2.03;
    }
    sum / total
}

/// Random values at the points of a grid, joined smoothly.
fn value_noise(seed: u32, place: DVec2) -> f64 {
    let corner = place.floor();
    let f = place - corner;
    let value = |dx: f64, dy: f64| {
        let key = |c: f64| (c as i64 as u64 & u64::from(u32::MAX)) as u32;
        let hash = hash3(seed, key(corner.x + dx), key(corner.y + dy));
        f64::from(hash) / f64::from(u32::MAX)
    };
    let (u, v) = (smooth_step(f.x), smooth_step(f.y));
    let upper = value(0.0, 0.0) * (1.0 - u) + value(1.0, 0.0) * u;
    let lower = value(0.0, 1.0) * (1.0 - u) + value(1.0, 1.0) * u;
    upper * (1.0 - v) + lower * v
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The share of a patch of sky that is darker than half the clouds' depth makes it.
    fn share(cover: f32) -> f64 {
        let clouds = Clouds {
            cover,
            ..Clouds::default()
        };
        let n = 200;
        let dark = (0..n * n).filter(|i| {
            let x = f64::from(i % n) / f64::from(n) * 2.0 - 1.0;
            let y = f64::from(i / n) / f64::from(n) * 2.0 - 1.0;
            let d = Vec3::new(x as f32, y as f32, 0.5).normalize();
            let mean: f32 = (0..8)
                .map(|t| transmittance(&clouds, 3, d, f64::from(t) * 7.0))
                .sum();
            mean < 8.0 * (-0.5 * clouds.depth).exp()
        });
        dark.count() as f64 / f64::from(n * n)
    }

    #[test]
    fn more_cover_is_more_cloud_and_none_is_none() {
        assert_eq!(share(0.0), 0.0);
        assert!(
            share(0.2) < 0.2 && share(0.95) > 0.8,
            "{} {}",
            share(0.2),
            share(0.95)
        );
        let clouds = Clouds {
            cover: 0.5,
            ..Clouds::default()
        };
        assert_eq!(transmittance(&clouds, 1, Vec3::NEG_Z, 0.0), 1.0);
        assert_eq!(transmittance(&clouds, 1, Vec3::X, 0.0), 1.0);
    }

    #[test]
    fn the_field_is_smooth_and_moves() {
        let clouds = Clouds {
            cover: 0.5,
            ..Clouds::default()
        };
        let at = |x: f32, t: f64| transmittance(&clouds, 1, Vec3::new(x, 0.1, 1.0).normalize(), t);
        for i in 0..2000 {
            let x = -1.0 + 1e-3 * i as f32;
            assert!((at(x, 0.0) - at(x + 1e-3, 0.0)).abs() < 0.06);
        }
        assert!(
            (0..100).any(|i| (at(0.01 * i as f32, 0.0) - at(0.01 * i as f32, 1.0)).abs() > 0.2)
        );
    }
}
