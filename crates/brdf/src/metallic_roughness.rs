//! Shared file: glTF's metallic-roughness materials as Blinn-Phong.

use glam::Vec3;

use crate::blinn_phong::BlinnPhong;

/// Reflectance at normal incidence of every dielectric (glTF 2.0, Appendix B).
const DIELECTRIC: f32 = 0.04;

/// The smallest roughness: below it the exponent would exceed [`MAX_EXPONENT`](crate::MAX_EXPONENT).
const MIN_ROUGHNESS: f32 = 0.12;

impl BlinnPhong {
    /// The material of glTF 2.0's `baseColorFactor` (linear), `metallicFactor` and `roughnessFactor`, or of their
    /// textures at one point. Each is clamped to [0, 1], and roughness to no less than 0.12.
    ///
    /// `ks = mix(0.04, base, metallic)`, `kd = base (1 − metallic)(1 − 0.04)`, `e = 2/α² − 2` with `α = roughness²`: the
    /// exponent whose lobe is about as wide as a microfacet distribution of that α (Walter et al. 2007). `kd + ks ≤ 1`
    /// holds to rounding. There is no Fresnel term: a dielectric stays at 0.04 from every side.
    ///
    /// ```
    /// use glam::Vec3;
    /// use glimt_brdf::BlinnPhong;
    /// let plastic = BlinnPhong::from_metallic_roughness(Vec3::ONE, 0.0, 1.0);
    /// assert_eq!((plastic.specular, plastic.exponent), (Vec3::splat(0.04), 0.0));
    /// let gold = BlinnPhong::from_metallic_roughness(Vec3::new(1.0, 0.8, 0.3), 1.0, 0.5);
    /// assert_eq!((gold.diffuse, gold.specular.z, gold.exponent), (Vec3::ZERO, 0.3, 30.0));
    /// ```
    #[inline]
    #[must_use]
    pub fn from_metallic_roughness(base: Vec3, metallic: f32, roughness: f32) -> BlinnPhong {
        let base = base.clamp(Vec3::ZERO, Vec3::ONE);
        let metallic = metallic.clamp(0.0, 1.0);
        let roughness = roughness.clamp(MIN_ROUGHNESS, 1.0);
        let alpha = roughness * roughness;
        let dielectric = 1.0 - metallic;
        BlinnPhong {
            diffuse: base * (dielectric * (1.0 - DIELECTRIC)),
            specular: base * metallic + Vec3::splat(DIELECTRIC * dielectric),
            exponent: 2.0 / (alpha * alpha) - 2.0,
        }
    }
}
