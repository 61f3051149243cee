//! Shared file: small mathematics that several crates need.

use glam::Vec3;

/// Luminance of linear RGB with Rec. 709 primaries: `0.2126 R + 0.7152 G + 0.0722 B` (ITU-R BT.709), in the unit of
/// `rgb`.
///
/// ```
/// use glam::Vec3;
/// use glimt_sampling::math::luminance;
/// assert!((luminance(Vec3::ONE) - 1.0).abs() < 1e-6);
/// assert_eq!(luminance(Vec3::Y), 0.7152);
/// ```
#[inline]
#[must_use]
pub fn luminance(rgb: Vec3) -> f32 {
    0.2126 * rgb.x + 0.7152 * rgb.y + 0.0722 * rgb.z
}

/// A right-handed orthonormal frame around a normal: `t × b = n`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShadingFrame {
    /// Tangent, local +x.
    pub t: Vec3,
    /// Bitangent, local +y.
    pub b: Vec3,
    /// Normal, local +z.
    pub n: Vec3,
}

impl ShadingFrame {
    /// A frame around the unit vector `n` (Duff et al. 2017, listing 3): no branch, no division by zero for any `n`.
    ///
    /// The tangents turn over where `n.z` changes sign, so they suit isotropic lobes only. An `n` that is not of unit
    /// length gives a frame that is not orthonormal.
    ///
    /// ```
    /// use glam::Vec3;
    /// use glimt_sampling::math::ShadingFrame;
    /// let frame = ShadingFrame::from_normal(Vec3::NEG_Z);
    /// assert_eq!(frame.t.cross(frame.b), Vec3::NEG_Z);
    /// ```
    #[inline]
    #[must_use]
    pub fn from_normal(n: Vec3) -> ShadingFrame {
        let sign = 1.0f32.copysign(n.z);
        let a = -1.0 / (sign + n.z);
        let c = n.x * n.y * a;
        ShadingFrame {
            t: Vec3::new(1.0 + sign * n.x * n.x * a, sign * c, -sign * n.x),
            b: Vec3::new(c, sign + n.y * n.y * a, -n.y),
            n,
        }
    }

    /// A local vector in world coordinates: `x t + y b + z n`.
    #[inline]
    #[must_use]
    pub fn to_world(&self, v: Vec3) -> Vec3 {
        self.t * v.x + self.b * v.y + self.n * v.z
    }

    /// A world vector in local coordinates, the inverse of [`ShadingFrame::to_world`].
    #[inline]
    #[must_use]
    pub fn to_local(&self, v: Vec3) -> Vec3 {
        Vec3::new(v.dot(self.t), v.dot(self.b), v.dot(self.n))
    }
}
