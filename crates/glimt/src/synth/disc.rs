//! Host file: round lights, written into lat-long maps with their exact energy.

use glam::{DVec3, UVec2, Vec3, Vec4};
use glimt_probe::latlong::texel_solid_angle_sr;
use std::f64::consts::{PI, TAU};

/// Adds a disc of constant radiance to a lat-long map: every texel gets the share of its solid angle that lies inside
/// the cap of angular radius `radius` (in radians) about `centre`. The energy added does not depend on where the disc stands,
/// however small it is beside a texel.
pub(super) fn add_disc(
    texels: &mut [Vec4],
    size: UVec2,
    centre: DVec3,
    radius: f64,
    radiance: Vec3,
) {
    let shares = disc_coverage(size, centre, radius);
    let covered: f64 = shares
        .iter()
        .map(|&(column_row, share)| share * f64::from(texel_solid_angle_sr(column_row.y, size)))
        .sum();
    // What is left of the quadrature's error is spread over the disc.
    let exact = TAU * 2.0 * (0.5 * radius).sin().powi(2);
    for (texel, share) in shares {
        let weight = (share * exact / covered) as f32;
        texels[(texel.y * size.x + texel.x) as usize] += (radiance * weight).extend(0.0);
    }
}

/// The texels that a cap touches and how much of each it covers. A cap meets a circle of constant θ in one interval of
/// φ, known exactly; the part of a row that it may meet is cut into 32 bands of equal area, each of which counts as its
/// middle circle.
fn disc_coverage(size: UVec2, centre: DVec3, radius: f64) -> Vec<(UVec2, f64)> {
    const CIRCLES: u32 = 32;
    let (width, height) = (f64::from(size.x), f64::from(size.y));
    let theta = centre.z.clamp(-1.0, 1.0).acos();
    let (north, south) = ((theta - radius).max(0.0), (theta + radius).min(PI));
    let first = (north / PI * height) as u32;
    let last = ((south / PI * height) as u32).min(size.y - 1);
    let middle = (0.5 - centre.y.atan2(centre.x) / TAU) * width;
    let mut shares = Vec::new();
    for row in first..=last {
        let mut row_shares = vec![0.0; size.x as usize];
        let [top, bottom] = [row, row + 1].map(|edge| PI * f64::from(edge) / height);
        let (from_z, to_z) = (top.max(north).cos(), bottom.min(south).cos());
        let circle_share = (from_z - to_z) / (top.cos() - bottom.cos()) / f64::from(CIRCLES);
        for circle in 0..CIRCLES {
            let z = from_z + (to_z - from_z) * (f64::from(circle) + 0.5) / f64::from(CIRCLES);
            let radii = ((1.0 - z * z) * (1.0 - centre.z * centre.z)).sqrt();
            let cos_half = (radius.cos() - z * centre.z) / radii.max(1e-30);
            let half = cos_half.clamp(-1.0, 1.0).acos() / TAU * width;
            let (from, to) = (middle - half, middle + half);
            for column in from.floor() as i64..to.ceil() as i64 {
                let overlap = to.min((column + 1) as f64) - from.max(column as f64);
                row_shares[column.rem_euclid(i64::from(size.x)) as usize] +=
                    overlap.max(0.0) * circle_share;
            }
        }
        let lit = row_shares.into_iter().enumerate().filter(|(_, s)| *s > 0.0);
        shares.extend(lit.map(|(column, share)| (UVec2::new(column as u32, row), share)));
    }
    shares
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::dvec3;

    /// Energy and mean direction of a map that holds one disc.
    fn moments(size: UVec2, centre: DVec3, radius: f64) -> (f64, DVec3) {
        let mut texels = vec![Vec4::ZERO; (size.x * size.y) as usize];
        add_disc(&mut texels, size, centre, radius, Vec3::ONE);
        let mut flux = 0.0;
        let mut mean = DVec3::ZERO;
        for (i, texel) in texels.iter().enumerate() {
            let at = UVec2::new(i as u32 % size.x, i as u32 / size.x);
            let power = f64::from(texel.x) * f64::from(texel_solid_angle_sr(at.y, size));
            flux += power;
            mean += power * glimt_probe::latlong::texel_direction(at, size).as_dvec3();
        }
        (flux, mean.normalize())
    }

    #[test]
    fn a_disc_keeps_its_energy_and_its_place() {
        let size = UVec2::new(256, 128);
        let texel = PI / 128.0;
        for radius in [0.1 * texel, 0.7 * texel, 4.0 * texel] {
            let cap = TAU * (1.0 - radius.cos());
            for step in 0..50 {
                let a = 0.37 * f64::from(step);
                // Spirals from pole to pole and crosses the seam many times.
                let z = 1.0 - f64::from(step) / 24.5;
                let s = (1.0 - z * z).max(0.0).sqrt();
                let centre = dvec3(-s * a.cos(), s * a.sin(), z);
                let (flux, mean) = moments(size, centre, radius);
                assert!((flux / cap - 1.0).abs() < 1e-5, "{radius} {centre}: {flux}");
                assert!(
                    mean.angle_between(centre) < 0.75 * texel,
                    "{radius} {centre}: {mean}"
                );
            }
        }
    }
}
