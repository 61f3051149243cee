//! Host file: checked construction of materials.

use core::fmt;

use glam::Vec3;

use crate::blinn_phong::BlinnPhong;
use crate::lambert::Lambert;
use crate::lobe::MAX_EXPONENT;

/// How far above 1 an albedo may lie, for sums that are 1 but for rounding.
const ROUNDING: f32 = 1e-5;

/// Why a material was refused.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MaterialError {
    /// A diffuse or specular albedo is negative or not a number.
    Albedo(f32),
    /// An exponent is negative or not a number.
    Exponent(f32),
    /// Diffuse and specular albedo together exceed 1 in some channel; the greatest sum.
    Energy(f32),
}

impl fmt::Display for MaterialError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Albedo(found) => write!(f, "an albedo of {found}: it must lie in 0 to 1"),
            Self::Exponent(found) => write!(f, "an exponent of {found}: it must be 0 or more"),
            Self::Energy(found) => write!(
                f,
                "diffuse and specular albedo add up to {found}: together they must not exceed 1"
            ),
        }
    }
}

impl core::error::Error for MaterialError {}

fn check_albedo(albedo: Vec3) -> Result<(), MaterialError> {
    match albedo.to_array().into_iter().find(|a| !(*a >= 0.0)) {
        Some(found) => Err(MaterialError::Albedo(found)),
        None => Ok(()),
    }
}

fn check_energy(albedo: Vec3) -> Result<(), MaterialError> {
    let greatest = albedo.max_element();
    if greatest <= 1.0 + ROUNDING {
        Ok(())
    } else {
        Err(MaterialError::Energy(greatest))
    }
}

impl BlinnPhong {
    /// A material of diffuse albedo `diffuse`, specular albedo `specular` at normal incidence, and an exponent, which is
    /// clamped to [`MAX_EXPONENT`].
    ///
    /// # Errors
    /// [`MaterialError`], where an albedo or the exponent is negative or NaN, or where `diffuse + specular` exceeds 1 in
    /// a channel (by more than rounding, 10⁻⁵).
    ///
    /// ```
    /// use glam::Vec3;
    /// use glimt_brdf::{BlinnPhong, MaterialError};
    /// let half = Vec3::splat(0.5);
    /// assert_eq!(BlinnPhong::new(half, half, 1e9).unwrap().exponent, 1e4);
    /// assert_eq!(BlinnPhong::new(half, Vec3::ONE, 5.0).unwrap_err(), MaterialError::Energy(1.5));
    /// ```
    pub fn new(diffuse: Vec3, specular: Vec3, exponent: f32) -> Result<Self, MaterialError> {
        check_albedo(diffuse)?;
        check_albedo(specular)?;
        if !(exponent >= 0.0) {
            return Err(MaterialError::Exponent(exponent));
        }
        check_energy(diffuse + specular)?;
        Ok(Self {
            diffuse,
            specular,
            exponent: exponent.min(MAX_EXPONENT),
        })
    }

    /// As [`BlinnPhong::new`], for a material that reflects too much, as files of the Phong era hold them: `diffuse` and
    /// `specular` are multiplied by the second result, the greatest factor up to 1 with which no channel exceeds 1.
    ///
    /// # Errors
    /// [`MaterialError`], where an albedo or the exponent is negative or NaN, or an albedo infinite.
    ///
    /// ```
    /// use glam::Vec3;
    /// use glimt_brdf::BlinnPhong;
    /// let (brdf, scale) = BlinnPhong::new_scaled(Vec3::new(0.2, 0.5, 1.0), Vec3::ONE, 40.0).unwrap();
    /// assert_eq!((scale, brdf.albedo().z, brdf.diffuse.x), (0.5, 1.0, 0.1));
    /// ```
    pub fn new_scaled(
        diffuse: Vec3,
        specular: Vec3,
        exponent: f32,
    ) -> Result<(Self, f32), MaterialError> {
        check_albedo(diffuse)?;
        check_albedo(specular)?;
        let greatest = (diffuse + specular).max_element();
        if !(greatest <= f32::MAX) {
            return Err(MaterialError::Energy(greatest));
        }
        let scale = 1.0 / greatest.max(1.0);
        let brdf = Self::new(diffuse * scale, specular * scale, exponent)?;
        Ok((brdf, scale))
    }
}

impl Lambert {
    /// A diffuse material of albedo `diffuse`.
    ///
    /// # Errors
    /// [`MaterialError`], where the albedo is negative, NaN, or above 1 in a channel (by more than rounding, 10⁻⁵).
    ///
    /// ```
    /// use glam::Vec3;
    /// assert!(glimt_brdf::Lambert::new(Vec3::splat(0.8)).is_ok());
    /// assert!(glimt_brdf::Lambert::new(Vec3::splat(1.2)).is_err());
    /// ```
    pub fn new(diffuse: Vec3) -> Result<Self, MaterialError> {
        check_albedo(diffuse)?;
        check_energy(diffuse)?;
        Ok(Self { diffuse })
    }
}
