//! Shared file: what a cell's light is worth to a surface: diffuse, with one Blinn-Phong lobe.

use core::f32::consts::FRAC_1_PI;

use glam::{Vec3, Vec4};
use glimt_brdf::normalisation;

use crate::partition::{LightCells, field};

/// A surface, or the mean of several that lie close together, as cells see it. Directions are in the map's coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CellSurface {
    /// Unit mean normal.
    pub normal: Vec3,
    /// Unit mean direction towards the eye.
    pub wo: Vec3,
    /// `kd/π` in luminance.
    pub diffuse: f32,
    /// `ks` in luminance.
    pub specular: f32,
    /// Exponent of the lobe, which the spread of normals has widened.
    pub exponent: f32,
    /// `c(e)` of that exponent.
    pub peak: f32,
    /// σ, the spread of the normals in radians; 0 for one surface.
    pub spread: f32,
    /// μ, no less than the sine of the largest angle between the mean normal and a normal; 0 for one surface.
    pub horizon: f32,
    /// β, the share of the lobe that cells sample, 0 to 1.
    pub share: f32,
}

/// Four cells as a surface sees them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CellTerms {
    /// Cosine of the cells' mean directions, at least 0.
    pub cosine: Vec4,
    /// 1 where the surface sees all of the cell, else 0.
    pub full: Vec4,
    /// 1 where it may see any of it, else 0.
    pub live: Vec4,
    /// `s`, the lobe times the cosine as seen through the cell, in 1/sr, times β; ks is not in it.
    pub lobe: Vec4,
    /// κ, the lobe's relative spread over the cell, 0 to 1.
    pub lobe_spread: Vec4,
    /// ℓ, the spread of the cosine over the cell.
    pub cosine_spread: Vec4,
}

/// 1 where `x > 0`, else 0.
#[inline]
fn step(x: Vec4) -> Vec4 {
    // What is closer to 0 than 10⁻³⁰ is neither: no angle is.
    (x * 1e30).clamp(Vec4::ZERO, Vec4::ONE)
}

/// Roots, component by component.
#[inline]
fn sqrt(x: Vec4) -> Vec4 {
    Vec4::new(
        libm::sqrtf(x.x),
        libm::sqrtf(x.y),
        libm::sqrtf(x.z),
        libm::sqrtf(x.w),
    )
}

/// About `cosᵉ θ`, for `1 − cos² θ` and e up to a few hundred: within 1 % where it is above 10⁻³.
///
/// It has no branch and no table, and is the same function wherever it stands, which is all that a control variate asks for.
///
/// ```
/// use glam::Vec4;
/// use glimt_light_cells::cosine_power4;
/// let cos = Vec4::new(1.0, 0.95, 0.8, 0.3);
/// let power = cosine_power4(Vec4::ONE - cos * cos, Vec4::splat(12.0));
/// let wanted = [1.0, 0.95_f32.powi(12), 0.8_f32.powi(12), 0.3_f32.powi(12)];
/// assert!((power - Vec4::from_array(wanted)).abs().max_element() < 2e-3);
/// ```
#[inline]
#[must_use]
pub fn cosine_power4(sin2_theta: Vec4, exponent: Vec4) -> Vec4 {
    // −ln(1 − s)/2 by a Padé approximant.
    let s = sin2_theta.clamp(Vec4::ZERO, Vec4::ONE);
    let log = s * (Vec4::splat(6.0) - s) / (Vec4::splat(12.0) - 8.0 * s);
    let t = (exponent * log).min(Vec4::splat(40.0)) * (1.0 / 256.0);
    // e^−t to the third order, then squared eight times.
    let x = Vec4::ONE - t * (Vec4::ONE - t * (Vec4::splat(0.5) - t * (1.0 / 6.0)));
    let x2 = x * x;
    let x4 = x2 * x2;
    let x8 = x4 * x4;
    let x16 = x8 * x8;
    let x32 = x16 * x16;
    let x64 = x32 * x32;
    let x128 = x64 * x64;
    x128 * x128
}

impl CellSurface {
    /// A surface of unit `normal`, seen from the unit direction `wo`, with `kd` and `ks` in luminance and exponent e, whose normals
    /// vary so that their mean has the length `mean_length`; `horizon` is μ. The lobe widens by Toksvig's rule,
    /// `e' = e R/(R + e (1 − R))`.
    #[inline]
    #[must_use]
    pub fn new(
        normal: Vec3,
        wo: Vec3,
        kd: f32,
        ks: f32,
        exponent: f32,
        mean_length: f32,
        horizon: f32,
    ) -> CellSurface {
        // A mean of unit vectors may come out longer than 1.
        let r = mean_length.clamp(1e-3, 1.0);
        let widened = exponent * r / (r + exponent * (1.0 - r));
        CellSurface {
            normal,
            wo,
            diffuse: kd * FRAC_1_PI,
            specular: ks,
            exponent: widened,
            peak: normalisation(widened),
            spread: libm::sqrtf(2.0 * (1.0 - r)),
            horizon,
            share: 1.0,
        }
    }

    /// Weights in proportion to what the surface reflects of each cell's light: those of product sampling.
    #[inline]
    #[must_use]
    pub fn product_weights(&self, terms: &CellTerms, flux: Vec4) -> Vec4 {
        let reflected = terms.cosine * self.diffuse + terms.lobe * self.specular;
        flux * terms.live * (reflected + terms.cosine_spread * self.diffuse)
    }

    /// Weights in proportion to the standard deviation that a control variate leaves of each cell's light, where `visibility` is the
    /// share of it that is expected to arrive.
    #[inline]
    #[must_use]
    pub fn residual_weights(&self, terms: &CellTerms, flux: Vec4, visibility: Vec4) -> Vec4 {
        let reflected = terms.cosine * self.diffuse + terms.lobe * self.specular;
        let by_visibility = visibility * (Vec4::ONE - visibility) + Vec4::splat(UNKNOWN_VISIBILITY);
        let by_shape = self.shape_variance(terms) * visibility.max(Vec4::splat(0.02));
        flux * terms.live * sqrt(reflected * reflected * by_visibility + by_shape)
    }

    /// As [`CellSurface::residual_weights`], where the light that is blocked is estimated without a control variate: as of surfaces that
    /// must stay as they are where nothing is blocked.
    #[inline]
    #[must_use]
    pub fn blocked_weights(&self, terms: &CellTerms, flux: Vec4, visibility: Vec4) -> Vec4 {
        let reflected = terms.cosine * self.diffuse + terms.lobe * self.specular;
        let blocked = Vec4::ONE - visibility * visibility + Vec4::splat(UNKNOWN_VISIBILITY);
        let by_shape = self.shape_variance(terms);
        flux * terms.live * sqrt(reflected * reflected * blocked + by_shape)
    }

    /// The variance over a cell of what the surface reflects of it.
    #[inline]
    fn shape_variance(&self, terms: &CellTerms) -> Vec4 {
        let diffuse = terms.cosine_spread * self.diffuse;
        let lobe = terms.lobe * terms.lobe_spread * self.specular;
        diffuse * diffuse + lobe * lobe
    }
}

impl LightCells<'_> {
    /// Cells `4 · quad` to `4 · quad + 3` as a surface sees them.
    #[inline]
    #[must_use]
    pub fn terms(&self, surface: &CellSurface, quad: u32) -> CellTerms {
        let x = self.quad(field::DIRECTION, quad);
        let y = self.quad(field::DIRECTION + 1, quad);
        let z = self.quad(field::DIRECTION + 2, quad);
        let radius = self.quad(field::RADIUS, quad);
        let extent = self.quad(field::SPREAD, quad);
        let n = surface.normal;
        let c = x * n.x + y * n.y + z * n.z;
        let reach = radius + Vec4::splat(surface.horizon);
        let up = (c + reach).max(Vec4::ZERO);
        let live = step(up);
        let full = step(c - reach);
        let cosine = c.max(Vec4::ZERO);
        let half_spread = Vec4::splat(0.5 * surface.spread);
        let cosine_spread = full * half_spread + (Vec4::ONE - full) * (0.35 * up.min(2.0 * extent));
        if !(surface.specular > 0.0) {
            return CellTerms {
                cosine,
                full,
                live,
                lobe: Vec4::ZERO,
                lobe_spread: Vec4::ZERO,
                cosine_spread,
            };
        }
        // The mean direction, lifted to a quarter of the highest elevation in the cell at least.
        let lifted = c.max(0.25 * up);
        let v = surface.wo;
        let nv = n.dot(v);
        let dv = x * v.x + y * v.y + z * v.z + (lifted - c) * nv;
        let length = sqrt((Vec4::ONE + lifted * lifted - c * c).max(Vec4::splat(1e-6)));
        let half2 = (Vec4::splat(2.0) + 2.0 * dv / length).max(Vec4::splat(1e-6));
        let nh = ((Vec4::splat(nv) + lifted / length).max(Vec4::ZERO)) / sqrt(half2);
        let cos2 = (nh * nh).min(Vec4::ONE);
        let sin2 = Vec4::ONE - cos2;
        let r2 = extent * extent;
        let e = surface.exponent.max(1e-3);
        let seen = Vec4::splat(4.0) / (Vec4::splat(4.0 / e) + 0.7 * r2);
        let lobe =
            cosine_power4(sin2, seen) * seen * (lifted * live) * (surface.share * surface.peak / e);
        let tangent = sqrt(sin2 / cos2.max(Vec4::splat(1e-4)));
        let near = Vec4::splat(0.1 * e * surface.spread * surface.spread) + 0.06 * e * r2;
        let slope = (0.5 * e) * tangent * (0.5 * extent + half_spread);
        CellTerms {
            cosine,
            full,
            live,
            lobe,
            lobe_spread: (slope + near).min(Vec4::ONE),
            cosine_spread,
        }
    }
}

/// What `p (1 − p)` of a visibility grows by, as no count of rays is certain.
pub const UNKNOWN_VISIBILITY: f32 = 0.0002;
