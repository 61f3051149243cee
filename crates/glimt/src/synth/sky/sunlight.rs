//! Host file: how bright a sun is at an elevation.

use glam::Vec3;

/// Irradiance of the sun above the atmosphere, in the sky model's unit (683 of it is one lux).
const EXTRATERRESTRIAL: f64 = 190.0;

/// The sky's turbidity: 1 is pure air.
pub(super) const TURBIDITY: f64 = 2.2;

/// Irradiance of a surface that faces the sun at an elevation [rad], red, green and blue.
///
/// Beer's law through molecules and haze: optical depths `0.008735 λ^−4.08` (Fröhlich and Shaw 1980) and
/// `(0.04608 T − 0.04586) λ^−1.3` for turbidity T (Preetham 1999, Appendix), λ in micrometres at the primaries'
/// dominant wavelengths, times the relative air mass of Kasten and Young 1989.
pub(in crate::synth) fn irradiance(elevation: f64) -> Vec3 {
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
    fn the_sun_reddens_at_the_horizon() {
        let low = irradiance(0.05);
        let high = irradiance(0.8);
        assert!(low.z / low.x < 0.3 * high.z / high.x);
        assert!(high.x < EXTRATERRESTRIAL as f32);
    }
}
