//! Host file: the sun of a map: its brightest blob is found, measured and taken out, so that its energy can move.

use super::settings::Sun;
use glam::{DVec3, UVec2, Vec3, Vec4, dvec3};
use glimt_probe::latlong::{texel_direction, texel_solid_angle_sr};
use glimt_sampling::luminance;
use std::f64::consts::PI;

/// The blob reaches no further than this from the brightest texel, or than two texels of a coarse map.
const REACH: f64 = 6.0 * PI / 180.0;
/// The ring around it, from where it ends to half as far again, is what is behind it.
const RING: f64 = 1.5;
/// Texels of the blob are at least this share of the brightest above the ring.
const EDGE: f32 = 0.02;

/// A sun: where it stands and what it gives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Blob {
    /// Direction towards it, unit length.
    pub direction: DVec3,
    /// Irradiance on what faces it, above that of what is behind it.
    pub irradiance: DVec3,
}

/// Finds the brightest blob of a map: the texels around the brightest one that stand out from a ring around them. `None` for a
/// map in which nothing stands out.
pub(super) fn find(texels: &[Vec4], size: UVec2) -> Option<Blob> {
    let (blob, _, _) = outline(texels, size)?;
    Some(blob)
}

/// Puts what is behind it in the place of the brightest blob; gives back the blob.
pub(super) fn take_out(texels: &mut [Vec4], size: UVec2) -> Option<Blob> {
    let (blob, members, behind) = outline(texels, size)?;
    for index in members {
        texels[index] = behind.extend(texels[index].w);
    }
    Some(blob)
}

/// The blob, its texels, and the radiance of the ring.
fn outline(texels: &[Vec4], size: UVec2) -> Option<(Blob, Vec<usize>, Vec3)> {
    let light = |index: usize| luminance(texels[index].truncate());
    let direction = |index: usize| {
        texel_direction(
            UVec2::new(index as u32 % size.x, index as u32 / size.x),
            size,
        )
    };
    let area = |index: usize| f64::from(texel_solid_angle_sr(index as u32 / size.x, size));
    let brightest = (0..texels.len()).max_by(|&a, &b| light(a).total_cmp(&light(b)))?;
    let peak = direction(brightest).as_dvec3();

    let reach = REACH.max(2.0 * PI / f64::from(size.y));
    let rim = RING * reach;
    let rows_of = |angle: f64| {
        let row = brightest as u32 / size.x;
        let reach = (angle / PI * f64::from(size.y)).ceil() as u32 + 1;
        let rows = row.saturating_sub(reach)..(row + reach + 1).min(size.y);
        (rows.start * size.x) as usize..(rows.end * size.x) as usize
    };
    let (mut ring, mut ring_area) = (DVec3::ZERO, 0.0);
    for index in rows_of(rim) {
        let angle = direction(index).as_dvec3().angle_between(peak);
        if angle > reach && angle <= rim {
            ring += texels[index].truncate().as_dvec3() * area(index);
            ring_area += area(index);
        }
    }
    if ring_area <= 0.0 {
        return None;
    }
    let behind = (ring / ring_area).as_vec3();
    let edge = luminance(behind) + EDGE * (light(brightest) - luminance(behind));
    if !(light(brightest) > 2.0 * luminance(behind)) {
        return None;
    }
    let members: Vec<usize> = rows_of(reach)
        .filter(|&i| light(i) > edge && direction(i).as_dvec3().angle_between(peak) <= reach)
        .collect();
    let mut mean = DVec3::ZERO;
    for &index in &members {
        let above = f64::from((light(index) - luminance(behind)).max(0.0));
        mean += direction(index).as_dvec3() * above * area(index);
    }
    let centre = mean.normalize();
    let mut irradiance = DVec3::ZERO;
    for &index in &members {
        let above = (texels[index].truncate() - behind).as_dvec3();
        irradiance += above * area(index) * direction(index).as_dvec3().dot(centre);
    }
    let blob = Blob {
        direction: centre,
        irradiance: irradiance.max(DVec3::ZERO),
    };
    Some((blob, members, behind))
}

/// The unit vector at an azimuth (counter-clockwise from +x, seen from above) and an elevation, in degrees.
pub(super) fn from_angles(azimuth_deg: f64, elevation_deg: f64) -> DVec3 {
    let (sin_a, cos_a) = azimuth_deg.to_radians().sin_cos();
    let (sin_e, cos_e) = elevation_deg.to_radians().sin_cos();
    dvec3(cos_e * cos_a, cos_e * sin_a, sin_e)
}

/// Where the sun stands at time `time` (0 in the first frame, 1 in the last) on the great circle of its arc; `None` where it has
/// no arc.
pub(super) fn on_arc(sun: &Sun, time: f64) -> Option<DVec3> {
    let at = |angles: [f32; 2]| from_angles(f64::from(angles[0]), f64::from(angles[1]));
    let from = at(sun.from_deg?);
    let to = at(sun.to_deg.or(sun.from_deg)?);
    let angle = from.angle_between(to);
    let aside = to - from * from.dot(to);
    if aside.length() < 1e-9 {
        return Some(from);
    }
    let (sin, cos) = (angle * time).sin_cos();
    Some((from * cos + aside.normalize() * sin).normalize())
}

/// Radiance of a disc of angular radius `radius_deg` that gives an irradiance to what faces it.
pub(super) fn disc_radiance(irradiance: DVec3, radius_deg: f32) -> Vec3 {
    let sin = f64::from(radius_deg).to_radians().sin();
    (irradiance / (PI * sin * sin)).as_vec3()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::synth::disc::add_disc;

    #[test]
    fn a_disc_on_a_sky_is_found_and_taken_out() {
        let size = UVec2::new(1024, 512);
        let plain = vec![Vec4::ONE; 1024 * 512];
        assert_eq!(find(&plain, size), None);
        for (azimuth, elevation) in [(20.0, 30.0), (179.9, 5.0), (-60.0, 88.0)] {
            let centre = from_angles(azimuth, elevation);
            let irradiance = dvec3(3.0, 2.0, 1.0);
            let mut texels = plain.clone();
            let radiance = disc_radiance(irradiance, 0.5);
            add_disc(&mut texels, size, centre, 0.5_f64.to_radians(), radiance);
            let blob = take_out(&mut texels, size).unwrap();
            assert!(blob.direction.angle_between(centre) < 5e-4, "{blob:?}");
            // Texels with less than a fiftieth of the disc are left to the sky.
            assert!(
                (blob.irradiance / irradiance - 1.0).abs().max_element() < 5e-3,
                "{blob:?}"
            );
            assert!(texels.iter().all(|t| t.x < 1.0 + 1.1 * EDGE * radiance.x));
        }
    }

    #[test]
    fn the_arc_leads_from_one_end_to_the_other() {
        let sun = Sun {
            from_deg: Some([90.0, 10.0]),
            to_deg: Some([0.0, 50.0]),
            ..Sun::default()
        };
        let at = |t| on_arc(&sun, t).unwrap();
        assert!((at(0.0) - from_angles(90.0, 10.0)).length() < 1e-12);
        assert!((at(1.0) - from_angles(0.0, 50.0)).length() < 1e-12);
        assert!(
            (at(0.3).angle_between(at(0.0)) - 0.3 * at(1.0).angle_between(at(0.0))).abs() < 1e-12
        );
        assert_eq!(on_arc(&Sun::default(), 0.5), None);
    }
}
