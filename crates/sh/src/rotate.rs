//! Host file: turning a light.

use glam::{Mat3, Vec3};
use glimt_probe::trig::cos_sin_pi;

use crate::{LightCoefficients, MAX_COEFFICIENTS, basis, coefficient_band};

/// Nodes and weights of Gauss's rule of six points on [−1, 1], the positive half.
const GAUSS: [(f32, f64); 3] = [
    (0.238_619_186_083_197, 0.467_913_934_572_691),
    (0.661_209_386_466_265, 0.360_761_573_048_139),
    (0.932_469_514_203_152, 0.171_324_492_379_170),
];

/// Nodes around a ring. One more than the highest frequency of a product of two basis functions.
const AROUND: u32 = 11;

/// The coefficients of the light that `rotation` (a rotation or a reflection) makes of this one: its value along
/// `rotation · d` is the old one's along d. `Mat3::from_quat` makes a matrix of a quaternion.
///
/// Exact up to rounding, below 10⁻⁶ of a band's norm: a band stays a band when turned, and its new coefficients are
/// integrals of polynomials of degree 10 at most, which 6 × 11 points give exactly. A matrix that is not orthogonal gives
/// nothing that means anything.
///
/// ```
/// use glam::{Mat3, Vec3};
/// use glimt_sh::{evaluate, rotated};
/// let light: [Vec3; 36] = core::array::from_fn(|k| Vec3::splat(1.0 / (1 + k) as f32));
/// let rotation = Mat3::from_cols(Vec3::Y, Vec3::Z, Vec3::X);
/// let d = Vec3::new(0.48, -0.6, 0.64);
/// let (before, after) = (evaluate(&light, d), evaluate(&rotated(&light, &rotation), rotation * d));
/// assert!((before - after).length() < 1e-5);
/// ```
#[must_use]
pub fn rotated(light: &LightCoefficients, rotation: &Mat3) -> LightCoefficients {
    let inverse = rotation.transpose();
    let mut sums = [[0.0f64; 3]; MAX_COEFFICIENTS];
    for (height, weight) in GAUSS {
        let radius = libm::sqrtf(1.0 - height * height);
        let weight = weight * core::f64::consts::TAU / f64::from(AROUND);
        for i in 0..AROUND {
            let phi = radius * cos_sin_pi(2.0 * i as f32 / AROUND as f32 - 1.0);
            for z in [height, -height] {
                let d = Vec3::new(phi.x, phi.y, z);
                add_node(light, inverse * d, d, weight, &mut sums);
            }
        }
    }
    sums.map(|[r, g, b]| Vec3::new(r as f32, g as f32, b as f32))
}

/// Adds the product of each band's value at `from` with its functions at `to`. Bands are kept apart, so that rounding in
/// a bright one does not reach into a faint one.
fn add_node(
    light: &LightCoefficients,
    from: Vec3,
    to: Vec3,
    weight: f64,
    sums: &mut [[f64; 3]; MAX_COEFFICIENTS],
) {
    let (from, to) = (basis(from), basis(to));
    let mut values = [[0.0f64; 3]; 6];
    for (k, c) in light.iter().enumerate() {
        let value = &mut values[coefficient_band(k as u32) as usize];
        for (value, c) in value.iter_mut().zip(c.to_array()) {
            *value += f64::from(c) * f64::from(from[k]);
        }
    }
    for (k, sum) in sums.iter_mut().enumerate() {
        let value = values[coefficient_band(k as u32) as usize];
        for (sum, value) in sum.iter_mut().zip(value) {
            *sum += weight * value * f64::from(to[k]);
        }
    }
}
