//! Host file: films of a mirror ball, drawn in f64 by intersecting rays with a sphere: no code in common with what is tested.
#![allow(
    dead_code,
    unreachable_pub,
    reason = "each test program uses a part of it"
)]

use glam::{DVec2, DVec3, UVec2, Vec4};
use glimt_ball::Circle;
use rayon::prelude::*;
use std::f64::consts::TAU;

/// A small generator of one's own (splitmix64).
#[derive(Clone, Copy)]
pub struct Random(pub u64);

impl Random {
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// In [0, 1).
    pub fn uniform(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub fn between(&mut self, a: f64, b: f64) -> f64 {
        a + (b - a) * self.uniform()
    }

    pub fn gauss(&mut self) -> f64 {
        let radius = (-2.0 * (1.0 - self.uniform()).ln()).sqrt();
        radius * (TAU * self.uniform()).cos()
    }

    pub fn gauss2(&mut self) -> DVec2 {
        DVec2::new(self.gauss(), self.gauss())
    }

    pub fn direction(&mut self) -> DVec3 {
        DVec3::new(self.gauss(), self.gauss(), self.gauss()).normalize()
    }
}

/// What surrounds the ball.
pub enum World {
    /// Sky, sun, lamps, textures, something like writing.
    Drawn(Box<Drawn>),
    /// A lat-long map, interpolated: width, height, luminance in three channels; turned about z by radians.
    Map(usize, usize, Vec<[f32; 3]>, f64),
    /// One colour everywhere.
    Plain(DVec3),
}

pub struct Drawn {
    waves: Vec<(DVec3, f64, f64)>,
    lamps: Vec<(DVec3, f64, f64)>,
    pub sun: DVec3,
    pub sun_radiance: f64,
    pub lamp_gain: f64,
    contrast: f64,
    ground: f64,
}

impl World {
    pub fn drawn(seed: u64) -> Self {
        let mut random = Random(seed);
        let waves = (0..9)
            .map(|i| {
                let frequency = 2.0 * 1.75_f64.powi(i) * random.between(0.7, 1.3);
                let weight = 0.5 / (1.0 + 0.35 * f64::from(i));
                (
                    random.direction() * frequency,
                    random.between(0.0, TAU),
                    weight,
                )
            })
            .collect();
        let lamps = (0..5)
            .map(|_| {
                let cos = random.between(0.02, 0.15).cos();
                (
                    random.direction(),
                    cos,
                    10.0_f64.powf(random.between(0.5, 2.5)),
                )
            })
            .collect();
        let mut sun = random.direction();
        sun.z = sun.z.abs();
        Self::Drawn(Box::new(Drawn {
            waves,
            lamps,
            sun,
            sun_radiance: 1e5,
            lamp_gain: 1.0,
            contrast: random.between(0.25, 1.0),
            ground: random.between(0.05, 0.5),
        }))
    }

    pub fn radiance(&self, d: DVec3) -> DVec3 {
        match self {
            Self::Plain(colour) => *colour,
            Self::Map(w, h, texels, turn) => {
                let phi = d.y.atan2(d.x) + turn;
                let u = (0.5 - phi / TAU).rem_euclid(1.0) * *w as f64 - 0.5;
                let v = d.z.clamp(-1.0, 1.0).acos() / (0.5 * TAU) * *h as f64 - 0.5;
                let (x, y) = (u.floor(), v.floor());
                let at = |i: f64, j: f64| {
                    let i = i.rem_euclid(*w as f64) as usize;
                    let j = j.clamp(0.0, *h as f64 - 1.0) as usize;
                    DVec3::from_array(texels[j * w + i].map(f64::from))
                };
                let top = at(x, y).lerp(at(x + 1.0, y), u - x);
                let low = at(x, y + 1.0).lerp(at(x + 1.0, y + 1.0), u - x);
                top.lerp(low, v - y)
            }
            Self::Drawn(world) => world.radiance(d),
        }
    }
}

impl Drawn {
    fn radiance(&self, d: DVec3) -> DVec3 {
        let mut log = 0.0;
        for (k, phase, weight) in &self.waves {
            log += weight * (k.dot(d) + phase).sin();
        }
        let texture = (self.contrast * log).exp();
        // The horizon is sharp; the sky is smoother than the ground.
        let sky = DVec3::new(0.5, 0.7, 1.0) * (1.0 + 1.5 * (-4.0 * d.z.abs()).exp());
        let ground = DVec3::new(0.9, 0.8, 0.6) * self.ground;
        let up = ((d.z + 0.002) / 0.004).clamp(0.0, 1.0);
        let mut light = (ground * texture).lerp(sky * texture.sqrt(), up);
        // Something like writing: cells of half a degree, black on white, in a belt.
        if d.z > 0.05 && d.z < 0.25 {
            let row = ((d.z - 0.05) * 100.0).floor();
            let column = (d.y.atan2(d.x) * 115.0).floor();
            let cell = Random((row as i64 as u64) << 32 ^ column as i64 as u64).bits();
            if row as i64 % 3 != 0 {
                light = DVec3::splat(if cell & 1 == 0 { 0.05 } else { 0.8 });
            }
        }
        for (to, cos, radiance) in &self.lamps {
            if d.dot(*to) > *cos {
                light = DVec3::new(1.0, 0.9, 0.8) * *radiance * self.lamp_gain;
            }
        }
        if d.dot(self.sun) > 0.999_989 {
            light = DVec3::splat(self.sun_radiance);
        }
        light
    }
}

/// Powers of the inverse of the root of x⁵ = x + 1.
const KRONECKER: [f64; 4] = [
    0.856_674_883_854_502_9,
    0.733_891_856_627_126_1,
    0.628_706_721_040_381_2,
    0.538_597_257_223_614_4,
];

/// A frame of the film.
pub struct Scene<'a> {
    pub world: &'a World,
    pub size: UVec2,
    pub circle: Circle,
    /// r/D; 0 is orthographic.
    pub radius_over_distance: f64,
    /// The image is turned by this, from +x to +y.
    pub roll: f64,
    /// Where the camera looks, turned about z.
    pub azimuth: f64,
    /// Elevation of the camera's view in radians.
    pub pitch: f64,
    pub tint: f64,
    /// The camera's own front in the middle, its radius over the ball's.
    pub rig: f64,
    /// Standard deviation of the lens's blur in pixels.
    pub blur: f64,
    pub mount: bool,
    /// Light above this is clipped.
    pub clip: f64,
    /// Relative noise of mid grey.
    pub noise: f64,
    pub exposure: f64,
    /// The background is seen this many times less magnified, and textured.
    pub busy: f64,
    /// Samples along each side of a pixel, at the rim twice as many.
    pub samples: u32,
    pub seed: u64,
    pub second: Option<Circle>,
}

impl<'a> Scene<'a> {
    pub fn new(world: &'a World, size: UVec2, circle: Circle) -> Self {
        Self {
            world,
            size,
            circle,
            radius_over_distance: 0.04,
            roll: 0.0,
            azimuth: 0.3,
            pitch: 0.0,
            tint: 0.95,
            rig: 0.22,
            blur: 0.4,
            mount: false,
            clip: f64::INFINITY,
            noise: 0.01,
            exposure: 1.0,
            busy: 1.0,
            samples: 4,
            seed: 1,
            second: None,
        }
    }

    fn frame(&self) -> (DVec3, DVec3, DVec3) {
        let forward =
            DVec3::new(self.azimuth.cos(), self.azimuth.sin(), self.pitch.tan()).normalize();
        let right = forward.cross(DVec3::Z).normalize();
        let down = forward.cross(right);
        let (s, c) = self.roll.sin_cos();
        // The image turned from +x towards +y by the roll.
        (forward, right * c - down * s, right * s + down * c)
    }

    fn seen(&self, p: DVec2) -> DVec3 {
        let (forward, right, down) = self.frame();
        for circle in [Some(self.circle), self.second].into_iter().flatten() {
            let q = (p - circle.centre) / circle.radius;
            if self.mount && q.x.abs() < 0.16 && q.y > 0.93 {
                return DVec3::splat(0.25 + 0.5 * q.x);
            }
            if let Some(colour) = self.on_ball(q, forward, right, down) {
                return colour;
            }
        }
        let q = (p - self.circle.centre) / self.circle.radius * self.busy;
        let t = tangent(self.radius_over_distance);
        let d = forward + (right * q.x + down * q.y) * t;
        self.world.radiance(d.normalize())
    }

    fn on_ball(&self, q: DVec2, forward: DVec3, right: DVec3, down: DVec3) -> Option<DVec3> {
        let k = self.radius_over_distance;
        let (origin, ray) = if k > 0.0 {
            let t = tangent(k);
            let ray = forward + (right * q.x + down * q.y) * t;
            (-forward / k, ray.normalize())
        } else {
            (-forward * 10.0 + right * q.x + down * q.y, forward)
        };
        // The sphere of radius 1 about 0.
        let b = origin.dot(ray);
        let gap = b * b - (origin.length_squared() - 1.0);
        if gap < 0.0 {
            return None;
        }
        let normal = origin + ray * (-b - gap.sqrt());
        let cos = -ray.dot(normal);
        let out = ray + normal * (2.0 * cos);
        if q.length() < self.rig {
            // The rig does not turn with the roll.
            let stripes = (q.x * 60.0).sin() * (q.y * 45.0).sin();
            return Some(DVec3::splat(0.06 + 0.04 * stripes));
        }
        let schlick = 0.7 + 0.3 * (1.0 - cos).max(0.0).powi(5);
        Some(self.world.radiance(out.normalize()) * (self.tint * schlick))
    }

    pub fn film(&self) -> Vec<Vec4> {
        let (w, h) = (self.size.x as usize, self.size.y as usize);
        let mut pixels = vec![Vec4::ZERO; w * h];
        pixels.par_chunks_mut(w).enumerate().for_each(|(j, row)| {
            let mut random = Random(self.seed.wrapping_mul(0x1234_5677) ^ ((j as u64) << 20));
            for (i, pixel) in row.iter_mut().enumerate() {
                let corner = DVec2::new(i as f64, j as f64);
                let rim = |c: Circle| (corner.distance(c.centre) - c.radius).abs() < 4.0;
                let outside = corner.distance(self.circle.centre) > self.circle.radius + 4.0;
                let n = if rim(self.circle) || self.second.is_some_and(rim) {
                    2 * self.samples
                } else if outside && self.busy == 1.0 && self.second.is_none() && !self.mount {
                    1
                } else {
                    self.samples
                };
                let mut sum = DVec3::ZERO;
                // A Kronecker sequence in pixel and lens, shifted: the blur of a bright edge must not be noise.
                let shift: [f64; 4] = std::array::from_fn(|_| random.uniform());
                for k in 0..n * n {
                    let u: [f64; 4] =
                        std::array::from_fn(|d| (shift[d] + f64::from(k) * KRONECKER[d]).fract());
                    let lens = self.blur * (-2.0 * (1.0 - u[2]).ln()).sqrt();
                    let (sin, cos) = (TAU * u[3]).sin_cos();
                    let p = corner + DVec2::new(u[0] + lens * cos, u[1] + lens * sin);
                    sum += self.seen(p);
                }
                let value = sum / f64::from(n * n) * self.exposure;
                let noisy = value.to_array().map(|v| {
                    let shot = self.noise * (0.3 * v * self.exposure).sqrt();
                    let sigma = (shot * shot + (0.3 * self.noise * v).powi(2) + 1e-8).sqrt();
                    (v + sigma * random.gauss()).min(self.clip) as f32
                });
                *pixel = Vec4::new(noisy[0], noisy[1], noisy[2], 1.0);
            }
        });
        pixels
    }
}

/// Tangent of the outline's half-angle, by which image points are multiplied; 0.04 for an orthographic camera's background.
fn tangent(k: f64) -> f64 {
    if k > 0.0 { k.asin().tan() } else { 0.04 }
}
