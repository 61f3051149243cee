//! Host file: a compute shader for rust-gpu that calls each algorithm crate, unchanged. It is type-checked, never run.

#![no_std]

use glam::{UVec2, UVec3, Vec3, Vec4};
use glimt_brdf::BlinnPhong;
use glimt_envmap_cdf::EnvCdf;
use glimt_light_cells::{CellSurface, LightCells, field};
use glimt_probe::gather::{ColourMatrix, GatherMap, TexelTaps, gather};
use glimt_probe::latlong::direction_to_texel;
use glimt_sampling::mis::multi_sample_density;
use glimt_sampling::resample::Scheme;
use glimt_sampling::ris::{RisPicks, RisSum};
use glimt_sampling::{OwenSobol, UniformSource, Xoshiro128PlusPlus, unit_vec2};
use glimt_smc::{Bridge, CapMove, Endpoints, Particle, Sampler, Target};
use spirv_std::spirv;

/// What all elements of a launch share.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct Params {
    /// Size of the light map in texels.
    pub map_size: UVec2,
    /// Number of the frame.
    pub frame: u32,
    /// Seed of the random streams.
    pub seed: u32,
    /// Towards the camera.
    pub wo: Vec3,
    /// Blinn-Phong exponent of the surface.
    pub exponent: f32,
}

/// Particles of each element.
const PARTICLES: usize = 8;

/// The light that a surface reflects, in a map that does not change.
struct Reflected<'a> {
    map_size: UVec2,
    radiance: &'a [Vec4],
    surface: BlinnPhong,
    wo: Vec3,
}

impl Reflected<'_> {
    fn at(&self, wi: Vec3) -> Vec3 {
        let texel = direction_to_texel(wi, self.map_size);
        let radiance = self.radiance[(texel.y * self.map_size.x + texel.x) as usize];
        radiance.truncate() * self.surface.eval(self.wo, wi) * wi.z.max(0.0)
    }
}

impl Target for Reflected<'_> {
    fn densities(&self, state: Vec3) -> Endpoints {
        let density = self.at(state).element_sum();
        Endpoints {
            previous: density,
            current: density,
        }
    }
}

/// One surface element an invocation: multiple importance sampling, a resampled candidate, a step of the sequential sampler and
/// spherical harmonics, all under one light map.
#[spirv(compute(threads(64)))]
pub fn reflect(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] params: &Params,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] marginal: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] conditional: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] radiance: &[Vec4],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] light: &[Vec4],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] particles: &mut [Particle],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 6)] out: &mut [Vec4],
) {
    let element = id.x;
    let target = Reflected {
        map_size: params.map_size,
        radiance,
        surface: BlinnPhong {
            diffuse: Vec3::splat(0.4),
            specular: Vec3::splat(0.5),
            exponent: params.exponent,
        },
        wo: params.wo,
    };
    let env = EnvCdf {
        size: params.map_size,
        marginal,
        conditional,
    };
    let mut points = OwenSobol::new(params.seed, params.frame, element, 0);
    let direct = by_both(&target, &env, &mut points);

    let mut words = Xoshiro128PlusPlus::stream(params.seed, params.frame, element);
    let resampled = by_candidates(&target, &env, &mut words);

    // Copied: rust-gpu refuses a part of a buffer's slice.
    let own = element as usize * PARTICLES;
    let mut set = [particles[own]; PARTICLES];
    for i in 1..PARTICLES {
        set[i] = particles[own + i];
    }
    let sampler = Sampler {
        bridge: Bridge::linear(1),
        scheme: Scheme::Systematic,
        ess_threshold: 0.5,
    };
    let report = sampler.advance(&target, &CapMove { height: 0.05 }, &mut set, &mut words);
    for i in 0..PARTICLES {
        particles[own + i] = set[i];
    }

    let cells = LightCells {
        size: params.map_size,
        words: marginal,
        start: element,
    };
    let surface = CellSurface::new(Vec3::Z, params.wo, 0.4, 0.5, params.exponent, 1.0, 0.0);
    let flux = cells.quad(field::FLUX, 0);
    let weight = surface
        .product_weights(&cells.terms(&surface, 0), flux)
        .element_sum();
    let drawn = cells.sample(0, UVec2::new(element, params.seed));

    let mut smooth = Vec3::splat(weight * drawn.pmf);
    let basis = glimt_sh::basis(Vec3::Z);
    for k in 0..9 {
        smooth += light[k].truncate() * (basis[k] * glimt_sh::cosine_lobe(band(k as u32)));
    }
    out[element as usize] = (direct + resampled + smooth).extend(report.ess);
}

#[cfg(not(feature = "control-type"))]
fn band(k: u32) -> u32 {
    glimt_sh::coefficient_band(k)
}

#[cfg(feature = "control-type")]
fn band(k: u32) -> u32 {
    glimt_sh::coefficient_band(k as f32)
}

/// One sample of the light and one of the surface, by the balance heuristic.
fn by_both(target: &Reflected<'_>, env: &EnvCdf<'_>, source: &mut impl UniformSource) -> Vec3 {
    let of_light = env.sample(source.next_uvec2());
    let lobe = source.next_u32();
    let of_surface = target
        .surface
        .sample(target.wo, lobe, unit_vec2(source.next_uvec2()));
    let mut sum = Vec3::ZERO;
    if of_light.pdf_sr > 0.0 {
        let other = target.surface.pdf_sr(target.wo, of_light.direction);
        sum += target.at(of_light.direction) / multi_sample_density(1, of_light.pdf_sr, 1, other);
    }
    if of_surface.pdf_sr > 0.0 {
        let other = env.pdf_sr(of_surface.wi);
        sum += target.at(of_surface.wi) / multi_sample_density(1, of_surface.pdf_sr, 1, other);
    }
    sum
}

/// One direction picked from eight candidates of the light.
fn by_candidates(
    target: &Reflected<'_>,
    env: &EnvCdf<'_>,
    source: &mut impl UniformSource,
) -> Vec3 {
    let mut directions = [Vec3::Z; 8];
    let mut weights = [0.0; 8];
    let mut sum = RisSum::new();
    for i in 0..8 {
        let drawn = env.sample(source.next_uvec2());
        directions[i] = drawn.direction;
        if drawn.pdf_sr > 0.0 {
            weights[i] = target.at(drawn.direction).element_sum() / drawn.pdf_sr;
        }
        sum.add(weights[i]);
    }
    let mut picks = RisPicks::new(&sum, 1, source.next_u32());
    let mut estimate = Vec3::ZERO;
    for i in 0..8 {
        if picks.take(weights[i]) > 0 {
            let reflected = target.at(directions[i]);
            estimate = reflected / reflected.element_sum().max(1e-30) * sum.normaliser();
        }
    }
    estimate
}

/// One texel an invocation: a photograph of a mirror ball resampled into a light map.
#[spirv(compute(threads(64)))]
pub fn unwarp(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] colour: &ColourMatrix,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] texels: &[TexelTaps],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] taps: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] pixels: &[Vec4],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] out: &mut [Vec4],
) {
    let map = GatherMap { texels, taps };
    out[id.x as usize] = gather(id.x, map, colour, Vec4::ONE, pixels);
}
