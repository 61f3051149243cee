//! Host file: films as targets of a sampler, and densities to draw their candidates from.

#![allow(dead_code, reason = "each test file takes what it needs")]

use glam::{UVec3, Vec3};
use glimt_sampling::warp::{
    pdf_cosine_hemisphere_sr, pdf_power_cosine_sr, pdf_uniform_sphere_sr, sample_cosine_hemisphere,
    sample_power_cosine, sample_uniform_sphere,
};
use glimt_sampling::{ShadingFrame, unit_vec2};
use glimt_smc::{Endpoints, Sampled, StateSampler, Target, split_word};
use glimt_statistics::films::{Film, Glossy, light};

/// γ_{t−1} and γ_t of a film, times a constant.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Between<'a, F: ?Sized> {
    pub(crate) film: &'a F,
    pub(crate) t: u32,
    pub(crate) scale: f32,
}

impl<F: Film + ?Sized> Target for Between<'_, F> {
    fn densities(&self, state: Vec3) -> Endpoints {
        Endpoints {
            previous: self.scale * self.film.gamma(self.t - 1, state),
            current: self.scale * self.film.gamma(self.t, state),
        }
    }
}

/// The density of a von Mises-Fisher lobe of the given κ times unit axis.
pub(crate) fn pdf_lobe_sr(axis: Vec3, d: Vec3) -> f32 {
    let k = axis.length();
    k / (std::f32::consts::TAU * (1.0 - (-2.0 * k).exp())) * (axis.dot(d) - k).exp()
}

/// A direction of that density.
pub(crate) fn sample_lobe(axis: Vec3, u: UVec3) -> Vec3 {
    let k = axis.length();
    let u = unit_vec2(u.truncate());
    let z = (1.0 + (u.x + (1.0 - u.x) * (-2.0 * k).exp()).max(1e-30).ln() / k).max(-1.0);
    let (r, phi) = ((1.0 - z * z).max(0.0).sqrt(), std::f32::consts::TAU * u.y);
    let local = Vec3::new(r * phi.cos(), r * phi.sin(), z);
    ShadingFrame::from_normal(axis / k)
        .to_world(local)
        .normalize()
}

/// Where candidates and independent proposals come from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Candidates {
    /// The whole sphere evenly.
    Uniform,
    /// The hemisphere by the cosine or a lobe about the mirrored direction, half each; what lies below the horizon is impossible.
    Brdf,
    /// Half as `Brdf`, half a lobe of the light in frame t, of the whole sphere.
    Mixture(u32),
}

impl Candidates {
    fn lobe_axis(t: u32) -> Vec3 {
        2.5 * light(t)
    }

    fn impossible() -> Sampled {
        Sampled {
            state: Vec3::NEG_Z,
            pdf: 0.0,
        }
    }
}

impl StateSampler for Candidates {
    fn sample(&self, u: UVec3) -> Sampled {
        let plane = unit_vec2(u.truncate());
        let state = match self {
            Candidates::Uniform => sample_uniform_sphere(plane).direction,
            Candidates::Brdf => {
                let split = split_word(u.z, 0.5);
                let state = if split.first {
                    sample_cosine_hemisphere(plane).direction
                } else {
                    let local = sample_power_cosine(plane, Glossy::EXPONENT).direction;
                    ShadingFrame::from_normal(Glossy::MIRRORED).to_world(local)
                };
                if !(state.z > 0.0) {
                    return Self::impossible();
                }
                state
            }
            Candidates::Mixture(t) => {
                let split = split_word(u.z, 0.5);
                let rest = UVec3::new(u.x, u.y, split.word);
                if split.first {
                    let drawn = Candidates::Brdf.sample(rest);
                    if drawn.pdf == 0.0 {
                        return drawn;
                    }
                    drawn.state
                } else {
                    sample_lobe(Self::lobe_axis(*t), rest)
                }
            }
        };
        Sampled {
            state,
            pdf: self.pdf(state),
        }
    }

    fn pdf(&self, d: Vec3) -> f32 {
        match self {
            Candidates::Uniform => pdf_uniform_sphere_sr(),
            Candidates::Brdf => {
                if !(d.z > 0.0) {
                    return 0.0;
                }
                let local = ShadingFrame::from_normal(Glossy::MIRRORED).to_local(d);
                0.5 * pdf_cosine_hemisphere_sr(d)
                    + 0.5 * pdf_power_cosine_sr(local, Glossy::EXPONENT)
            }
            Candidates::Mixture(t) => {
                0.5 * Candidates::Brdf.pdf(d) + 0.5 * pdf_lobe_sr(Self::lobe_axis(*t), d)
            }
        }
    }
}
