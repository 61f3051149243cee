//! Shared file: what all estimators of reflected light have in common.

use glam::Vec3;

use super::environment::Environment;
use super::pattern::PixelPattern;
use super::scene::{Scene, ShadingPoint};

/// Light that a point reflects, parted by whether it arrives.
///
/// The two are sums over different samples of one set. So the light without the objects is `lit + blocked`, which where
/// nothing is blocked is `lit` to the last bit, whatever a compiler fuses; two sums over all samples would not promise it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reflected {
    /// Radiance by the light that arrives.
    pub lit: Vec3,
    /// Radiance by the light that objects keep away.
    pub blocked: Vec3,
}

impl Reflected {
    /// No light.
    pub const NONE: Reflected = Reflected {
        lit: Vec3::ZERO,
        blocked: Vec3::ZERO,
    };

    /// Radiance if there were no objects.
    #[inline]
    #[must_use]
    pub fn unoccluded(&self) -> Vec3 {
        self.lit + self.blocked
    }

    /// Adds one sample's light.
    #[inline]
    pub fn gather(&mut self, light: Reflected) {
        self.lit += light.lit;
        self.blocked += light.blocked;
    }
}

/// An estimator of reflected radiance, `L_r = ∫ L(ω) ρ(ωo, ω) V(ω) ⟨ω·n⟩ dω` (Kronander 2014, Eq. 1).
pub trait Estimator {
    /// Radiance that the point reflects towards ωo, by samples from the pattern: V, and 1 − V in its place.
    fn reflected(
        &self,
        point: &ShadingPoint,
        pattern: &PixelPattern,
        env: Environment<'_>,
        scene: Scene<'_>,
    ) -> Reflected;
}

/// A chosen direction with what it contributes if light from there arrives: what a shadow ray has to know.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightSample {
    /// Unit vector in the world.
    pub direction: Vec3,
    /// Contribution to the reflected radiance, without visibility.
    pub contribution: Vec3,
}

impl LightSample {
    /// A sample that contributes nothing.
    pub const IMPOSSIBLE: LightSample = LightSample {
        direction: Vec3::Z,
        contribution: Vec3::ZERO,
    };

    /// `radiance · ρ(ωo, ωi) ⟨ωi·n⟩ / density`, which is 0 for a direction behind the shading or the geometric normal.
    ///
    /// `direction` and `wi` are the same direction, in the world and in the point's frame.
    #[inline]
    #[must_use]
    pub fn new(
        point: &ShadingPoint,
        direction: Vec3,
        wi: Vec3,
        radiance: Vec3,
        density: f32,
    ) -> LightSample {
        let in_front = wi.z > 0.0 && point.geometric_normal.dot(direction) > 0.0;
        if !in_front || !(density > f32::MIN_POSITIVE) {
            return LightSample::IMPOSSIBLE;
        }
        // The quotient is bounded where the radiance may be huge, so it comes first.
        let weight = point.brdf.eval(point.wo, wi) * (wi.z / density);
        LightSample {
            direction,
            contribution: radiance * weight,
        }
    }

    /// The contribution, by whether it arrives along a shadow ray with this key, which is traced only where there is one.
    #[inline]
    #[must_use]
    pub fn traced(&self, point: &ShadingPoint, scene: Scene<'_>, key: u32) -> Reflected {
        if !(self.contribution.max_element() > 0.0) {
            return Reflected::NONE;
        }
        if scene.is_lit(point, self.direction, key) {
            Reflected {
                lit: self.contribution,
                blocked: Vec3::ZERO,
            }
        } else {
            Reflected {
                lit: Vec3::ZERO,
                blocked: self.contribution,
            }
        }
    }
}
