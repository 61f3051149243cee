//! Host file: luminance alone, in one float a pixel, and its reductions by two.

use crate::circle::Circle;
use glam::{UVec2, Vec4};
use glimt_sampling::math::luminance;
use rayon::prelude::*;

/// Values that no light reaches, so that sums of them stay finite.
const LARGEST: f32 = 1e20;

/// Luminance of an image, rows from the top. Pixels that are no light (negative, NaN) are 0, infinite ones 1e20.
#[derive(Clone, Debug)]
pub(crate) struct Plane {
    pub(crate) width: usize,
    pub(crate) height: usize,
    pub(crate) data: Vec<f32>,
}

impl Plane {
    /// `pixels` must hold as many as `size` says.
    pub(crate) fn new(size: UVec2, pixels: &[Vec4]) -> Self {
        let one = |p: &Vec4| {
            let l = luminance(p.truncate());
            if l > 0.0 { l.min(LARGEST) } else { 0.0 }
        };
        Self {
            width: size.x as usize,
            height: size.y as usize,
            data: pixels.par_iter().with_min_len(1 << 14).map(one).collect(),
        }
    }

    /// Half as large, each pixel the mean of four: a point `p` comes to lie at `p / 2`. An odd last row or column is lost.
    pub(crate) fn half(&self) -> Self {
        let (width, height) = (self.width / 2, self.height / 2);
        let mut data = vec![0.0; width * height];
        if width > 0 {
            data.par_chunks_mut(width)
                .with_min_len(16)
                .enumerate()
                .for_each(|(y, row)| {
                    let a = &self.data[2 * y * self.width..];
                    let b = &self.data[(2 * y + 1) * self.width..];
                    for (x, out) in row.iter_mut().enumerate() {
                        *out = 0.25 * (a[2 * x] + a[2 * x + 1] + b[2 * x] + b[2 * x + 1]);
                    }
                });
        }
        Self {
            width,
            height,
            data,
        }
    }

    /// Value at a point by bilinear interpolation, of the nearest pixels outside the image.
    pub(crate) fn at(&self, x: f64, y: f64) -> f32 {
        let fx = (x - 0.5).clamp(0.0, (self.width - 1) as f64);
        let fy = (y - 0.5).clamp(0.0, (self.height - 1) as f64);
        let (i, j) = (fx as usize, fy as usize);
        let (i1, j1) = ((i + 1).min(self.width - 1), (j + 1).min(self.height - 1));
        let (u, v) = ((fx - i as f64) as f32, (fy - j as f64) as f32);
        let (a, b) = (
            self.data[j * self.width + i],
            self.data[j * self.width + i1],
        );
        let (c, d) = (
            self.data[j1 * self.width + i],
            self.data[j1 * self.width + i1],
        );
        (a + (b - a) * u) * (1.0 - v) + (c + (d - c) * u) * v
    }
}

/// An image and its reductions by 2, 4, 8…; level 0 is the image.
#[derive(Clone, Debug)]
pub(crate) struct Pyramid {
    pub(crate) levels: Vec<Plane>,
}

/// The longer side of the smallest level is at most this, in pixels.
const COARSEST: usize = 400;

impl Pyramid {
    pub(crate) fn new(size: UVec2, pixels: &[Vec4]) -> Self {
        let mut levels = vec![Plane::new(size, pixels)];
        loop {
            let last = &levels[levels.len() - 1];
            if last.width.max(last.height) <= COARSEST {
                return Self { levels };
            }
            let next = last.half();
            levels.push(next);
        }
    }

    /// The finest level on which the circle's radius is at most `radius` pixels, and the circle there.
    pub(crate) fn at_radius(&self, circle: Circle, radius: f64) -> (&Plane, Circle) {
        let mut level = 0;
        let mut on_level = circle;
        while on_level.radius > radius && level + 1 < self.levels.len() {
            level += 1;
            on_level = on_level.scaled(0.5);
        }
        (&self.levels[level], on_level)
    }
}
