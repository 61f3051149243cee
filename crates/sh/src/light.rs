//! Host file: a light's coefficients: values, products, windows, irradiance, time.

use glam::Vec3;

use crate::{MAX_COEFFICIENTS, basis, coefficient_band, cosine_lobe, hann, temporal_filter};

/// Coefficients of a light of three colours, at [`coefficient_index`](crate::coefficient_index); those of bands that it
/// does not have are 0.
pub type LightCoefficients = [Vec3; MAX_COEFFICIENTS];

/// `Σ_k c_k y_k(d)`, what the coefficients say of the unit vector `d`. It may be negative: a few bands ring.
///
/// ```
/// use glam::Vec3;
/// use glimt_sh::{LightCoefficients, evaluate};
/// let mut light: LightCoefficients = [Vec3::ZERO; 36];
/// light[0] = Vec3::splat((4.0 * core::f32::consts::PI).sqrt());
/// assert!((evaluate(&light, Vec3::X) - Vec3::ONE).abs().max_element() < 1e-6);
/// ```
#[must_use]
pub fn evaluate(light: &LightCoefficients, d: Vec3) -> Vec3 {
    dot(light, &basis(d))
}

/// `Σ_k c^L_k c^T_k`, the integral of the product of light and transfer (Hajisharif 2012, Eq. 2). Times albedo/π it is the
/// radiance that a diffuse point reflects (Eq. 14, where that factor is missing in print).
///
/// ```
/// use glam::Vec3;
/// use glimt_sh::dot;
/// let (mut light, mut transfer) = ([Vec3::ZERO; 36], [0.0; 36]);
/// (light[2], transfer[2]) = (Vec3::new(1.0, 2.0, 3.0), 0.5);
/// assert_eq!(dot(&light, &transfer), Vec3::new(0.5, 1.0, 1.5));
/// ```
#[must_use]
pub fn dot(light: &LightCoefficients, transfer: &[f32; MAX_COEFFICIENTS]) -> Vec3 {
    let mut sum = Vec3::ZERO;
    for (c, t) in light.iter().zip(transfer) {
        sum += *c * *t;
    }
    sum
}

/// The light with each band times its [`hann`] window (Sloan 2008). For a light of n bands `window = n` is usual; one
/// that is not above 0 leaves the light as it is.
///
/// ```
/// use glam::Vec3;
/// use glimt_sh::{hann, windowed};
/// let light = windowed(&[Vec3::ONE; 36], 5.0);
/// assert_eq!((light[0].x, light[5].x, light[25].x), (1.0, hann(2, 5.0), 0.0));
/// ```
#[must_use]
pub fn windowed(light: &LightCoefficients, window: f32) -> LightCoefficients {
    by_band(light, |l| hann(l, window))
}

/// The coefficients of irradiance as a function of the normal: `E_lm = A_l L_lm` (Ramamoorthi and Hanrahan 2001, Eq. 10),
/// of a point that sees the whole hemisphere. In W/m² where the light is in W/(m² sr).
///
/// ```
/// use glam::Vec3;
/// use glimt_sh::{evaluate, irradiance};
/// // Under a sky of radiance 1 all around it is π.
/// let mut light = [Vec3::ZERO; 36];
/// light[0] = Vec3::splat((4.0 * core::f32::consts::PI).sqrt());
/// let e = evaluate(&irradiance(&light), Vec3::Z);
/// assert!((e.x - core::f32::consts::PI).abs() < 1e-5);
/// ```
#[must_use]
pub fn irradiance(light: &LightCoefficients) -> LightCoefficients {
    by_band(light, cosine_lobe)
}

/// The filter over time (Hajisharif 2012, Eq. 13): `(c + α c_before)/(1 + α)`, with what this function returned for the
/// frame before.
///
/// ```
/// use glam::Vec3;
/// use glimt_sh::temporally_filtered;
/// let light = temporally_filtered(&[Vec3::ONE; 36], &[Vec3::ZERO; 36], 1.0);
/// assert_eq!(light[7], Vec3::splat(0.5));
/// ```
#[must_use]
pub fn temporally_filtered(
    light: &LightCoefficients,
    before: &LightCoefficients,
    alpha: f32,
) -> LightCoefficients {
    core::array::from_fn(|k| {
        let channel = |i: usize| temporal_filter(light[k][i], before[k][i], alpha);
        Vec3::new(channel(0), channel(1), channel(2))
    })
}

fn by_band(light: &LightCoefficients, factor: impl Fn(u32) -> f32) -> LightCoefficients {
    core::array::from_fn(|k| light[k] * factor(coefficient_band(k as u32)))
}
