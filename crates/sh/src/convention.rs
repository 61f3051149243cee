//! Host file: the same coefficients as others write them.
//!
//! Only signs, order and scale differ; axes are the caller's. [`rotated`](crate::rotated) turns a light whose z is up
//! into one whose y is: by the matrix with the columns X, −Z, Y, which takes +z to +y.

use core::f32::consts::FRAC_1_PI;

use glam::{Mat3, Vec3};

use crate::basis::{Y_00, Y_1, zonal_2};
use crate::{LightCoefficients, coefficient_order, cosine_lobe};

/// Takes z up to y up: (x, y, z) to (x, z, −y), as glTF's worlds stand.
pub const Z_UP_TO_Y_UP: Mat3 = Mat3::from_cols(Vec3::X, Vec3::NEG_Z, Vec3::Y);

/// `(−1)^m` times this crate's coefficients: those for a basis with the Condon–Shortley sign, in which
/// `y_{1,1} = −√(3/4π) x`. The same function leads back.
///
/// DirectXMath's basis (`XMSHEvalDirection`, and D3DX's before it), in the order l² + l + m, is of that kind. Axes are not
/// turned: a left-handed world needs one of them mirrored first, by [`rotated`](crate::rotated) with a reflection.
///
/// ```
/// use glam::Vec3;
/// use glimt_sh::condon_shortley;
/// let c = condon_shortley(&[Vec3::ONE; 36]);
/// assert_eq!([c[0].x, c[1].x, c[2].x, c[3].x, c[4].x], [1.0, -1.0, 1.0, -1.0, 1.0]);
/// ```
#[doc(alias = "directx")]
#[must_use]
pub fn condon_shortley(light: &LightCoefficients) -> LightCoefficients {
    core::array::from_fn(|k| {
        let odd = coefficient_order(k as u32) & 1 == 1;
        if odd { -light[k] } else { light[k] }
    })
}

/// Nine coefficients e that give irradiance over π, as Filament's and Babylon's shaders take it:
/// `E(n)/π = e0 + e1 y + e2 z + e3 x + e4 xy + e5 yz + e6 (3z² − 1) + e7 zx + e8 (x² − y²)` of the unit normal (x, y, z).
///
/// `e_k = A_l/π · K_k · L_k`, with [`cosine_lobe`] A and the basis functions' constants K: 0.282095 L for l = 0, 0.325735
/// L for l = 1, and 0.273137 L, 0.273137 L, 0.078848 L, 0.273137 L, 0.136569 L for l = 2. Times the albedo it is the
/// radiance that a diffuse surface reflects.
///
/// ```
/// use glam::Vec3;
/// use glimt_sh::{evaluate, filament_irradiance, irradiance};
/// let light: [Vec3; 36] = core::array::from_fn(|k| if k < 9 { Vec3::splat(1.0 / (1 + k) as f32) } else { Vec3::ZERO });
/// let (e, n) = (filament_irradiance(&light), Vec3::new(0.48, -0.6, 0.64));
/// let polynomial = e[0] + e[1] * n.y + e[2] * n.z + e[3] * n.x + e[4] * (n.x * n.y) + e[5] * (n.y * n.z)
///     + e[6] * (3.0 * n.z * n.z - 1.0) + e[7] * (n.z * n.x) + e[8] * (n.x * n.x - n.y * n.y);
/// let expected = evaluate(&irradiance(&light), n) / core::f32::consts::PI;
/// assert!((polynomial - expected).abs().max_element() < 1e-6);
/// ```
#[must_use]
pub fn filament_irradiance(light: &LightCoefficients) -> [Vec3; 9] {
    let scales = filament_scales();
    core::array::from_fn(|k| light[k] * scales[k])
}

/// The light of which [`filament_irradiance`] made these coefficients, in its first three bands.
///
/// ```
/// use glam::Vec3;
/// use glimt_sh::{filament_irradiance, from_filament_irradiance};
/// let mut light = [Vec3::ZERO; 36];
/// light[6] = Vec3::new(1.0, 2.0, 3.0);
/// assert!((from_filament_irradiance(&filament_irradiance(&light))[6] - light[6]).length() < 1e-6);
/// ```
#[must_use]
pub fn from_filament_irradiance(coefficients: &[Vec3; 9]) -> LightCoefficients {
    let scales = filament_scales();
    core::array::from_fn(|k| {
        if k < 9 {
            coefficients[k] / scales[k]
        } else {
            Vec3::ZERO
        }
    })
}

/// `A_l/π · K_k`.
fn filament_scales() -> [f32; 9] {
    let [_, k_21, k_22] = zonal_2(1.0);
    // zonal_2(1)[0] is K (3 − 1); x² − y² stands as it is, and 2xy as xy.
    let k_20 = 0.5 * zonal_2(1.0)[0];
    let constants = [Y_00, Y_1, Y_1, Y_1, 2.0 * k_22, k_21, k_20, k_21, k_22];
    core::array::from_fn(|k| {
        let l = crate::coefficient_band(k as u32);
        constants[k] * cosine_lobe(l) * FRAC_1_PI
    })
}
