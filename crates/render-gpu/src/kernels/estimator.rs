//! Shared file: what all estimators of reflected light have in common.

use glam::Vec3;

use super::environment::Environment;
use super::pattern::PixelPattern;
use super::scene::{Scene, ShadingPoint};

/// An estimator of reflected radiance, `L_r = ∫ L(ω) ρ(ωo, ω) V(ω) ⟨ω·n⟩ dω` (Kronander 2014, Eq. 1).
pub trait Estimator {
    /// Radiance that the point reflects towards ωo, by samples from the pattern.
    fn reflected(
        &self,
        point: &ShadingPoint,
        pattern: &PixelPattern,
        env: Environment<'_>,
        scene: Scene<'_>,
    ) -> Vec3;
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

    /// What arrives of the contribution. The shadow ray is traced only where there is one.
    #[inline]
    #[must_use]
    pub fn traced(&self, point: &ShadingPoint, scene: Scene<'_>) -> Vec3 {
        if self.contribution.max_element() > 0.0 && scene.is_lit(point, self.direction) {
            self.contribution
        } else {
            Vec3::ZERO
        }
    }
}
