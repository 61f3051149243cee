//! Shared file: a simulated image sensor: several exposures of one radiance, each with shot noise, read noise, clipping and
//! quantisation, fused into one radiance again.

use glam::Vec4;
use glimt_probe::trig::cos_sin_pi;
use glimt_sampling::hash::hash2;
use glimt_sampling::uniform::{UniformSource, unit_f32};
use glimt_sampling::xoshiro::Xoshiro128PlusPlus;

/// What uniforms are for: the noise of a pixel.
const NOISE: u32 = 11;

/// From this mean on, a Poisson distribution is drawn as a normal one.
const NORMAL_FROM: f32 = 50.0;

/// Exposures whose weight is below this share of the best ones' are left out: they would lessen the noise by a hundredth.
const LEAST_SHARE: f32 = 0.02;

/// A sensor and its series of exposures. 48 bytes.
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct SensorParams {
    /// Electrons that one unit of radiance frees in the longest exposure.
    pub longest_gain: f32,
    /// Factor from one exposure to the next shorter one, above 1.
    pub step: f32,
    /// Number of exposures; 0 for an ideal sensor without noise.
    pub exposures: u32,
    /// Electrons at which a pixel clips.
    pub full_well: f32,
    /// Standard deviation of the read noise in electrons.
    pub read_noise: f32,
    /// Electrons in one step of the converter.
    pub electrons_per_code: f32,
    /// First key of the noise.
    pub seed: u32,
    /// Second key of the noise.
    pub frame: u32,
    /// Fills 48 bytes.
    pub unused_a: u32,
    /// Fills 48 bytes.
    pub unused_b: u32,
    /// Fills 48 bytes.
    pub unused_c: u32,
    /// Fills 48 bytes.
    pub unused_d: u32,
}

/// What the sensor makes of a pixel. Alpha stays.
#[must_use]
pub fn expose(pixel: u32, sensor: &SensorParams, radiance: &[Vec4]) -> Vec4 {
    let value = radiance[pixel as usize];
    if sensor.exposures == 0 {
        return value;
    }
    let mut source = Xoshiro128PlusPlus::stream(hash2(sensor.seed, NOISE), sensor.frame, pixel);
    let r = sensor.fuse(value.x, &mut source);
    let g = sensor.fuse(value.y, &mut source);
    let b = sensor.fuse(value.z, &mut source);
    Vec4::new(r, g, b, value.w)
}

impl SensorParams {
    /// The mean of the exposures of a radiance, each weighted by the inverse of its variance.
    ///
    /// Weights and the choice of exposures come from the variance that the radiance has, not from the noisy values, so that
    /// the result is unbiased; exposures that may clip (five standard deviations) are left out, but the shortest. Radiance
    /// above what fills that one clips; a result below 0, which only read noise gives, is 0.
    #[inline]
    #[must_use]
    pub fn fuse(&self, radiance: f32, source: &mut Xoshiro128PlusPlus) -> f32 {
        let step_variance = self.electrons_per_code * self.electrons_per_code / 12.0;
        let floor_variance = self.read_noise * self.read_noise + step_variance;
        let mut sum = 0.0;
        let mut weights = 0.0;
        let mut relative_gain = 1.0;
        for i in 0..self.exposures {
            let gain = self.longest_gain * relative_gain;
            let mean = radiance * gain;
            let variance = mean + floor_variance;
            let fits = mean + 5.0 * libm::sqrtf(variance) < self.full_well;
            if fits || i + 1 == self.exposures {
                let weight = relative_gain * relative_gain / variance.max(1e-12);
                if weight < LEAST_SHARE * weights {
                    break;
                }
                sum += weight * self.read(mean, source) / gain;
                weights += weight;
            }
            relative_gain /= self.step;
        }
        (sum / weights.max(1e-38)).max(0.0)
    }

    /// What is read from a pixel that should hold `mean` electrons, in electrons.
    #[inline]
    fn read(&self, mean: f32, source: &mut Xoshiro128PlusPlus) -> f32 {
        let normal = draw_normal(source);
        let electrons = if mean < NORMAL_FROM {
            draw_poisson(mean, source) + self.read_noise * normal
        } else {
            mean + libm::sqrtf(mean + self.read_noise * self.read_noise) * normal
        };
        let clipped = electrons.clamp(-self.full_well, self.full_well);
        libm::floorf(clipped / self.electrons_per_code + 0.5) * self.electrons_per_code
    }
}

/// A standard normal number (Box and Muller 1958).
#[inline]
fn draw_normal(source: &mut Xoshiro128PlusPlus) -> f32 {
    let u = source.next_uvec2();
    // Half a step above zero, where the logarithm has no value.
    let radius = libm::sqrtf(-2.0 * libm::logf(unit_f32(u.x) + 3e-8));
    radius * cos_sin_pi(2.0 * unit_f32(u.y) - 1.0).x
}

/// A Poisson number of a mean below [`NORMAL_FROM`], by inversion.
#[inline]
fn draw_poisson(mean: f32, source: &mut Xoshiro128PlusPlus) -> f32 {
    let u = unit_f32(source.next_u32());
    let mut probability = libm::expf(-mean);
    let mut cumulated = probability;
    let mut n = 0.0;
    // No mean below the bound reaches this count in 2²⁴ draws.
    while u >= cumulated && n < 150.0 {
        n += 1.0;
        probability *= mean / n;
        cumulated += probability;
    }
    n
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn layout_is_that_of_wgsl() {
        assert_eq!(core::mem::size_of::<SensorParams>(), 48);
    }

    #[test]
    fn small_counts_are_poisson() {
        for mean in [0.0, 0.3, 7.0, 45.0] {
            let mut source = Xoshiro128PlusPlus::stream(1, 2, 3);
            let n = 40_000;
            let draws: Vec<f64> = (0..n)
                .map(|_| f64::from(draw_poisson(mean, &mut source)))
                .collect();
            let average = draws.iter().sum::<f64>() / f64::from(n);
            let variance = draws.iter().map(|d| (d - average).powi(2)).sum::<f64>() / f64::from(n);
            let error = (f64::from(mean) / f64::from(n)).sqrt();
            assert!(
                (average - f64::from(mean)).abs() <= 4.0 * error,
                "{average}"
            );
            assert!(
                (variance - f64::from(mean)).abs() <= 0.03 * f64::from(mean),
                "{variance}"
            );
        }
    }
}
