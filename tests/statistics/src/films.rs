//! Host file: unnormalised densities over the sphere that change from frame to frame, with exact integrals.

use std::f64::consts::TAU;

use glam::Vec3;

use crate::quadrature::{Direction, integrate_band};

/// What is integrated: γ_t times one of these.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Phi {
    /// 1: the normaliser.
    One,
    /// The direction's x.
    X,
    /// 1 where z > ¼, 0 elsewhere: vanishes where γ does not.
    Visible,
}

/// All of them.
pub const PHIS: [Phi; 3] = [Phi::One, Phi::X, Phi::Visible];

/// The edge between the third and the fourth of eight rows of equal area.
const VISIBLE_Z: f64 = 0.25;

impl Phi {
    /// φ in the direction `d` (unit length).
    #[must_use]
    pub fn at(self, d: Vec3) -> f64 {
        match self {
            Phi::One => 1.0,
            Phi::X => f64::from(d.x),
            Phi::Visible => f64::from(u8::from(f64::from(d.z) > VISIBLE_Z)),
        }
    }
}

/// A density γ_t, t = 0, 1, …
pub trait Film: Sync {
    /// γ_t in the direction `d` (unit length).
    fn gamma(&self, t: u32, d: Vec3) -> f32;

    /// At least γ_t anywhere, for any t.
    fn bound(&self) -> f32;

    /// ∫ γ_t φ, in f64.
    fn exact(&self, t: u32, phi: Phi) -> f64;
}

fn to_f64(v: Vec3) -> Direction {
    [f64::from(v.x), f64::from(v.y), f64::from(v.z)]
}

fn dot(a: Direction, b: Direction) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The integral of a smooth function times φ over z from `from` to 1.
fn integral(f: impl Fn(Direction) -> f64, from: f64, phi: Phi) -> f64 {
    let from = if phi == Phi::Visible { VISIBLE_Z } else { from };
    let weighted = |d: Direction| f(d) * if phi == Phi::X { d[0] } else { 1.0 };
    let integral = integrate_band(weighted, [from, 1.0], 1e-9);
    // An integral may be near 0 with φ = x.
    let limit = 1e-9 * (integral.value.abs() + 1e-3);
    assert!(integral.error <= limit, "{integral:?}");
    integral.value
}

/// Where the light is in frame t: it climbs and turns.
#[must_use]
pub fn light(t: u32) -> Vec3 {
    let angle = 0.4 + 0.08 * t as f32;
    Vec3::new(angle.sin() * 0.8, 0.6 * angle.sin(), angle.cos())
}

/// The product of two von Mises-Fisher lobes, of which one moves: `exp(κ_1 (μ_t·ω − 1) + κ_2 (m·ω − 1))`, itself such a lobe.
#[derive(Clone, Copy, Debug)]
pub struct Product;

impl Product {
    const KAPPA: [f32; 2] = [3.5, 1.5];
    const FIXED: Vec3 = Vec3::new(0.48, -0.6, 0.64);

    /// `κ_1 μ_t + κ_2 m`.
    #[must_use]
    pub fn axis(t: u32) -> Vec3 {
        Self::KAPPA[0] * light(t) + Self::KAPPA[1] * Self::FIXED
    }
}

impl Film for Product {
    fn gamma(&self, t: u32, d: Vec3) -> f32 {
        (Self::KAPPA[0] * (light(t).dot(d) - 1.0)).exp()
            * (Self::KAPPA[1] * (Self::FIXED.dot(d) - 1.0)).exp()
    }

    fn bound(&self) -> f32 {
        1.0
    }

    fn exact(&self, t: u32, phi: Phi) -> f64 {
        let axis = to_f64(Self::axis(t));
        let kappas = f64::from(Self::KAPPA[0] + Self::KAPPA[1]);
        if phi == Phi::Visible {
            return integral(|d| (dot(axis, d) - kappas).exp(), -1.0, phi);
        }
        let k = dot(axis, axis).sqrt();
        let normaliser = TAU / k * ((k - kappas).exp() - (-k - kappas).exp());
        // The mean direction of such a lobe is its axis times `coth k − 1/k`.
        match phi {
            Phi::X => normaliser * (1.0 / k.tanh() - 1.0 / k) * axis[0] / k,
            _ => normaliser,
        }
    }
}

/// Light that moves above a glossy surface: `(exp(κ (μ_t·ω − 1)) + ε) (k_d/π + k_s lobe) ⟨ω·n⟩`, 0 below the horizon.
#[derive(Clone, Copy, Debug)]
pub struct Glossy;

impl Glossy {
    const KAPPA: f64 = 8.0;
    const FLOOR: f64 = 0.05;
    /// The exponent of a cosine lobe about [`Glossy::MIRRORED`] to draw from.
    pub const EXPONENT: f32 = 3.0;
    /// The axis of the surface's lobe.
    pub const MIRRORED: Vec3 = Vec3::new(-0.48, 0.64, 0.6);

    fn value(t: u32, d: Direction) -> f64 {
        let light = (Self::KAPPA * (dot(to_f64(light(t)), d) - 1.0)).exp() + Self::FLOOR;
        // A smooth lobe, so that the quadrature converges.
        let lobe = (4.0 * (dot(to_f64(Self::MIRRORED), d) - 1.0)).exp();
        light * (0.2 + 0.8 * lobe) * d[2].max(0.0)
    }
}

impl Film for Glossy {
    fn gamma(&self, t: u32, d: Vec3) -> f32 {
        let light = (Self::KAPPA as f32 * (light(t).dot(d) - 1.0)).exp() + Self::FLOOR as f32;
        let lobe = (4.0 * (Self::MIRRORED.dot(d) - 1.0)).exp();
        light * (0.2 + 0.8 * lobe) * d.z.max(0.0)
    }

    fn bound(&self) -> f32 {
        1.05
    }

    fn exact(&self, t: u32, phi: Phi) -> f64 {
        integral(|d| Self::value(t, d), 0.0, phi)
    }
}

/// A map of 16 × 8 texels of equal area: a dim pattern with black texels, and a bright block that moves by a column a frame.
#[derive(Clone, Copy, Debug)]
pub struct Map;

impl Map {
    const COLUMNS: u32 = 16;
    const ROWS: u32 = 8;

    /// Radiance; a texel that is black is so in all frames.
    fn texel(t: u32, column: u32, row: u32) -> f32 {
        let pattern = (column * 7 + row * 5) % 9;
        if pattern == 0 {
            return 0.0;
        }
        let distance = (column + 16 - (t + 2) % 16) % 16;
        let bright = distance < 3 && (row == 2 || row == 3);
        0.1 + 0.05 * pattern as f32 + if bright { 0.8 } else { 0.0 }
    }
}

impl Film for Map {
    fn gamma(&self, t: u32, d: Vec3) -> f32 {
        let row = (1.0 - d.z) * 0.5 * Self::ROWS as f32;
        let column = (d.y.atan2(d.x) / std::f32::consts::TAU + 0.5) * Self::COLUMNS as f32;
        Self::texel(
            t,
            (column as u32).min(Self::COLUMNS - 1),
            (row as u32).min(Self::ROWS - 1),
        )
    }

    fn bound(&self) -> f32 {
        1.4
    }

    fn exact(&self, t: u32, phi: Phi) -> f64 {
        let mut sum = 0.0;
        for row in 0..Self::ROWS {
            let z = [row, row + 1].map(|r| 1.0 - 2.0 * f64::from(r) / f64::from(Self::ROWS));
            if phi == Phi::Visible && z[1] < VISIBLE_Z {
                break;
            }
            for column in 0..Self::COLUMNS {
                let turn = |c: u32| TAU * (f64::from(c) / f64::from(Self::COLUMNS) - 0.5);
                let phis = [column, column + 1].map(turn);
                let integral = if phi == Phi::X {
                    let disc = |z: f64| 0.5 * (z * (1.0 - z * z).max(0.0).sqrt() + z.asin());
                    (disc(z[0]) - disc(z[1])) * (phis[1].sin() - phis[0].sin())
                } else {
                    (z[0] - z[1]) * (phis[1] - phis[0])
                };
                sum += f64::from(Self::texel(t, column, row)) * integral;
            }
        }
        sum
    }
}
