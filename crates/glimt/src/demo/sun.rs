//! Host file: where the sun of the shot stands, and how bright a sun is.

use super::shot_time;
use crate::disc::add_disc;
use glam::{DVec3, UVec2, Vec3, Vec4, dvec3};
use std::f64::consts::PI;

/// Latitude of the place where the sculpture stands; its axis points at the celestial pole.
pub(super) const LATITUDE: f64 = 50.0 * PI / 180.0;

/// Angular radius of the sun's disc [rad]: about twice the real one, which softens shadows a little.
const RADIUS: f64 = 0.5 * PI / 180.0;

/// Irradiance of the sun above the atmosphere, in the sky model's unit (683 of it is one lux).
const EXTRATERRESTRIAL: f64 = 190.0;

/// The sky's turbidity: 1 is pure air.
pub(super) const TURBIDITY: f64 = 2.2;

/// Direction towards the sun in frame `frame`. +x is south, +y east: it climbs from the left into the picture, on the
/// circle that it describes about the celestial pole.
pub(super) fn direction(frame: u32) -> DVec3 {
    let declination = 14_f64.to_radians();
    let hour_angle = (-77.0 + 45.0 * f64::from(shot_time(frame))).to_radians();
    let (sin_l, cos_l) = LATITUDE.sin_cos();
    let (sin_d, cos_d) = declination.sin_cos();
    dvec3(
        cos_d * hour_angle.cos() * sin_l - sin_d * cos_l,
        -cos_d * hour_angle.sin(),
        sin_l * sin_d + cos_l * cos_d * hour_angle.cos(),
    )
}

/// Adds the sun of frame `frame` to a lat-long map.
pub(super) fn add(texels: &mut [Vec4], size: UVec2, frame: u32) {
    let sun = direction(frame);
    let radiance = irradiance(sun.z.asin()) / (PI * RADIUS.sin().powi(2)) as f32;
    add_disc(texels, size, sun, RADIUS, radiance);
}

/// Irradiance of a surface that faces the sun at an elevation [rad], red, green and blue.
///
/// Beer's law through molecules and haze: optical depths `0.008735 λ^−4.08` (Fröhlich and Shaw 1980) and
/// `(0.04608 T − 0.04586) λ^−1.3` for turbidity T (Preetham 1999, Appendix), λ in micrometres at the primaries'
/// dominant wavelengths, times the relative air mass of Kasten and Young 1989.
pub(crate) fn irradiance(elevation: f64) -> Vec3 {
    let degrees = elevation.to_degrees().max(0.0);
    let air_mass = 1.0 / (elevation.sin().max(0.0) + 0.50572 * (degrees + 6.07995).powf(-1.6364));
    let haze = 0.04608 * TURBIDITY - 0.04586;
    let channels = [0.612, 0.549, 0.465].map(|wavelength: f64| {
        let depth = 0.008735 * wavelength.powf(-4.08) + haze * wavelength.powf(-1.3);
        (EXTRATERRESTRIAL * (-depth * air_mass).exp()) as f32
    });
    Vec3::from_array(channels)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_sun_climbs_and_reddens_at_the_horizon() {
        assert!(direction(0).z > 0.1 && direction(0).z < direction(super::super::FRAMES - 1).z);
        let low = irradiance(0.05);
        let high = irradiance(0.8);
        assert!(low.z / low.x < 0.3 * high.z / high.x);
        assert!(high.x < EXTRATERRESTRIAL as f32);
    }
}
