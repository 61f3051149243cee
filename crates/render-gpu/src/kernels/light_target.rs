//! Shared file: light that a point reflects, as a target of the sequential sampler, and the draws that propose directions.

use glam::{UVec2, UVec3, Vec3};
use glimt_brdf::BlinnPhong;
use glimt_sampling::math::{ShadingFrame, luminance};
use glimt_sampling::uniform::unit_vec2;
use glimt_smc::{Endpoints, Sampled, StateSampler, Target};

use super::environment::{Environment, RadianceMap};
use super::past::RayState;
use super::scene::ShadingPoint;

/// `Y(ρ(ωo, ω)) ⟨ω·n⟩`: what a point makes of light, in luminance. All that a target keeps of the point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightLobe {
    frame: ShadingFrame,
    wo: Vec3,
    /// Grey, of the material's luminance.
    brdf: BlinnPhong,
}

impl LightLobe {
    /// That of a shading point.
    #[inline]
    #[must_use]
    pub fn of_point(point: &ShadingPoint) -> LightLobe {
        LightLobe {
            frame: point.frame,
            wo: point.wo,
            brdf: BlinnPhong {
                diffuse: Vec3::splat(luminance(point.brdf.diffuse)),
                specular: Vec3::splat(luminance(point.brdf.specular)),
                exponent: point.brdf.exponent,
            },
        }
    }

    /// That of the point that a ray's state remembers.
    #[inline]
    #[must_use]
    pub fn of_state(state: &RayState) -> LightLobe {
        let frame = ShadingFrame::from_normal(state.normal);
        LightLobe {
            frame,
            wo: frame.to_local(state.wo),
            brdf: BlinnPhong {
                diffuse: Vec3::splat(state.diffuse),
                specular: Vec3::splat(state.specular),
                exponent: state.exponent,
            },
        }
    }

    /// Its value in 1/sr at a direction of the world; 0 behind the shading normal.
    #[inline]
    #[must_use]
    pub fn value(&self, direction: Vec3) -> f32 {
        let wi = self.frame.to_local(direction);
        if !(wi.z > 0.0) {
            return 0.0;
        }
        self.brdf.eval(self.wo, wi).x * wi.z
    }
}

/// `γ(ω) = (Y(L(ω)) + floor) Y(ρ(ωo, ω)) ⟨ω·n⟩` of this frame and of the frame before, each with its own light, point and floor.
///
/// Differs from the paper, which has no floor: light that moves onto directions where the old target was zero is then lost.
#[derive(Clone, Copy, Debug)]
pub struct LightTarget<'a> {
    /// The light of the frame before.
    pub previous_light: RadianceMap<'a>,
    /// Its floor.
    pub previous_floor: f32,
    /// The point that the particles come from.
    pub previous_lobe: LightLobe,
    /// This frame's light.
    pub light: Environment<'a>,
    /// Its floor.
    pub floor: f32,
    /// The point that the particles go to.
    pub lobe: LightLobe,
}

impl LightTarget<'_> {
    /// γ of this frame.
    #[inline]
    #[must_use]
    pub fn current(&self, direction: Vec3) -> f32 {
        let lobe = self.lobe.value(direction);
        if !(lobe > 0.0) {
            return 0.0;
        }
        let radiance = self.light.radiance(self.light.texel(direction));
        (luminance(radiance) + self.floor) * lobe
    }

    /// γ of the frame before.
    #[inline]
    #[must_use]
    pub fn previous(&self, direction: Vec3) -> f32 {
        let lobe = self.previous_lobe.value(direction);
        if !(lobe > 0.0) {
            return 0.0;
        }
        (luminance(self.previous_light.radiance(direction)) + self.previous_floor) * lobe
    }
}

impl Target for LightTarget<'_> {
    #[inline]
    fn densities(&self, state: Vec3) -> Endpoints {
        Endpoints {
            previous: self.previous(state),
            current: self.current(state),
        }
    }
}

/// Independent draws from the BRDF.
#[derive(Clone, Copy, Debug)]
pub struct BrdfDraw {
    /// Where.
    pub frame: ShadingFrame,
    /// ωo, in that frame.
    pub wo: Vec3,
    /// Of what.
    pub brdf: BlinnPhong,
}

impl StateSampler for BrdfDraw {
    #[inline]
    fn sample(&self, u: UVec3) -> Sampled {
        let drawn = self.brdf.sample(self.wo, u.z, unit_vec2(u.truncate()));
        Sampled {
            state: self.frame.to_world(drawn.wi),
            pdf: drawn.pdf_sr,
        }
    }

    #[inline]
    fn pdf(&self, state: Vec3) -> f32 {
        self.brdf.pdf_sr(self.wo, self.frame.to_local(state))
    }
}

/// Independent draws from a light map's tables.
#[derive(Clone, Copy, Debug)]
pub struct LightDraw<'a> {
    /// The light.
    pub light: Environment<'a>,
}

impl StateSampler for LightDraw<'_> {
    #[inline]
    fn sample(&self, u: UVec3) -> Sampled {
        let drawn = self.light.sample(UVec2::new(u.x, u.y));
        Sampled {
            state: drawn.direction,
            pdf: drawn.pdf_sr,
        }
    }

    #[inline]
    fn pdf(&self, state: Vec3) -> f32 {
        self.light.cdf().texel_pdf_sr(self.light.texel(state))
    }
}
