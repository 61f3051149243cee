//! Host file: images of any size brought to another, in linear light.

use glam::{DVec3, UVec2, Vec3};
use rayon::prelude::*;

/// The part of a source image that fills the target: first pixel and size, in pixels of the source.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Window {
    /// Upper left corner.
    pub origin: [f64; 2],
    /// Width and height.
    pub size: [f64; 2],
}

impl Window {
    /// The whole image.
    pub fn whole(source: UVec2) -> Self {
        Self {
            origin: [0.0; 2],
            size: [f64::from(source.x), f64::from(source.y)],
        }
    }

    /// The largest part in the middle that has the target's proportions.
    pub fn middle(source: UVec2, target: UVec2) -> Self {
        let [w, h] = [source.x, source.y].map(f64::from);
        let [tw, th] = [target.x, target.y].map(f64::from);
        // Compared without division, so that equal proportions leave nothing out.
        let size = if w * th > h * tw {
            [h * tw / th, h]
        } else {
            [w, w * th / tw]
        };
        Self {
            origin: [0.5 * (w - size[0]), 0.5 * (h - size[1])],
            size,
        }
    }
}

/// Resamples a window of an image, rows from the top. Along each axis, a target pixel is the mean of what it covers where the
/// image is made smaller, and a linear interpolation between pixel centres where it is made larger. A window of the target's
/// size at whole pixels is copied.
pub fn resample(source: UVec2, pixels: &[Vec3], window: Window, target: UVec2) -> Vec<Vec3> {
    let columns = taps(window.origin[0], window.size[0], source.x, target.x);
    let rows = taps(window.origin[1], window.size[1], source.y, target.y);
    let width = source.x as usize;
    let used = rows.first().map_or(0, |t| t.first)..rows.last().map_or(0, Taps::end);
    let narrow: Vec<Vec3> = pixels[used.start * width..used.end * width]
        .par_chunks(width)
        .flat_map_iter(|row| columns.iter().map(|taps| taps.mean(|i| row[i])))
        .collect();
    let width = columns.len();
    let across = |row: &Taps, x: usize| row.mean(|y| narrow[(y - used.start) * width + x]);
    rows.par_iter()
        .flat_map_iter(|row| (0..width).map(move |x| across(row, x)))
        .collect()
}

/// The source pixels that a target pixel is made of, along one axis.
struct Taps {
    first: usize,
    weights: Vec<f64>,
}

impl Taps {
    fn end(&self) -> usize {
        self.first + self.weights.len()
    }

    /// Summed in f64 by weights that sum to one up to its rounding: a constant stays what it is.
    fn mean(&self, pixel: impl Fn(usize) -> Vec3) -> Vec3 {
        let pixels = (self.first..).zip(&self.weights);
        let sum: DVec3 = pixels.map(|(i, w)| pixel(i).as_dvec3() * *w).sum();
        sum.as_vec3()
    }
}

fn taps(origin: f64, length: f64, source: u32, target: u32) -> Vec<Taps> {
    let step = length / f64::from(target);
    let last = source as usize - 1;
    let covered = |i: u32| {
        let (a, b) = (
            origin + f64::from(i) * step,
            origin + f64::from(i + 1) * step,
        );
        let first = (a as usize).min(last);
        let end = (b.ceil() as usize).clamp(first + 1, last + 1);
        let share = |p: usize| ((p + 1) as f64).min(b) - (p as f64).max(a);
        let weights: Vec<f64> = (first..end).map(|p| share(p).max(0.0)).collect();
        let sum: f64 = weights.iter().sum();
        Taps {
            first,
            weights: weights.iter().map(|w| w / sum).collect(),
        }
    };
    let between = |i: u32| {
        let centre = origin + (f64::from(i) + 0.5) * step - 0.5;
        let place = centre.clamp(0.0, last as f64);
        let first = (place as usize).min(last);
        let f = place - first as f64;
        let weights = if f > 0.0 { vec![1.0 - f, f] } else { vec![1.0] };
        Taps { first, weights }
    };
    match step >= 1.0 {
        true => (0..target).map(covered).collect(),
        false => (0..target).map(between).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn image(size: UVec2, f: impl Fn(u32, u32) -> f32) -> Vec<Vec3> {
        let at = |i: u32| Vec3::new(1.0, 0.5, 2.0) * f(i % size.x, i / size.x);
        (0..size.x * size.y).map(at).collect()
    }

    fn mean(pixels: &[Vec3]) -> DVec3 {
        let sum: DVec3 = pixels.iter().map(|p| p.as_dvec3()).sum();
        sum / pixels.len() as f64
    }

    #[test]
    fn a_constant_stays_constant() {
        let size = UVec2::new(7, 5);
        let colour = Vec3::new(0.1, 1.0 / 3.0, 1e-7);
        for target in [[1, 1], [3, 2], [7, 5], [13, 4], [2, 11], [64, 64]] {
            let target = UVec2::from(target);
            for window in [Window::whole(size), Window::middle(size, target)] {
                let out = resample(size, &[colour; 35], window, target);
                assert_eq!(out, vec![colour; (target.x * target.y) as usize]);
            }
        }
    }

    #[test]
    fn equal_size_is_untouched() {
        let size = UVec2::new(6, 4);
        let source = image(size, |x, y| (x as f32 * 0.37 + y as f32).sin() * 1e3);
        for window in [Window::whole(size), Window::middle(size, size)] {
            let out = resample(size, &source, window, size);
            let bits = |list: &[Vec3]| -> Vec<_> {
                list.iter()
                    .map(|p| p.to_array().map(f32::to_bits))
                    .collect()
            };
            assert_eq!(bits(&out), bits(&source));
        }
    }

    #[test]
    fn energy_is_kept_when_made_smaller() {
        let size = UVec2::new(37, 23);
        // A lamp of one pixel must not fall between the others.
        let source = image(size, |x, y| if (x, y) == (17, 11) { 1e4 } else { 0.25 });
        for target in [[1, 1], [5, 4], [12, 23], [36, 22]] {
            let target = UVec2::from(target);
            let out = resample(size, &source, Window::whole(size), target);
            let (a, b) = (mean(&out), mean(&source));
            assert!(
                (a - b).abs().max_element() <= 1e-5 * b.max_element(),
                "{a} {b}"
            );
            // A point sample would lose or multiply the lamp.
            let point: Vec<Vec3> = (0..target.x * target.y)
                .map(|i| {
                    let at = UVec2::new(i % target.x, i / target.x) * size / target;
                    source[(at.y * size.x + at.x) as usize]
                })
                .collect();
            assert!((mean(&point) - b).abs().max_element() > 0.01 * b.max_element());
        }
    }

    #[test]
    fn larger_is_linear_between_centres() {
        let size = UVec2::new(4, 2);
        let ramp = image(size, |x, y| x as f32 + 10.0 * y as f32);
        let target = UVec2::new(12, 4);
        let out = resample(size, &ramp, Window::whole(size), target);
        for (i, pixel) in out.iter().enumerate() {
            let x = ((i % 12) as f32 + 0.5) / 3.0 - 0.5;
            let y = ((i / 12) as f32 + 0.5) / 2.0 - 0.5;
            let expected = x.clamp(0.0, 3.0) + 10.0 * y.clamp(0.0, 1.0);
            assert!((pixel.x - expected).abs() < 1e-5, "{pixel} {expected}");
        }
    }

    #[test]
    fn a_crop_takes_the_middle() {
        let wide = UVec2::new(8, 2);
        let window = Window::middle(wide, UVec2::new(3, 3));
        assert_eq!((window.origin, window.size), ([3.0, 0.0], [2.0, 2.0]));
        let out = resample(wide, &image(wide, |x, _| x as f32), window, UVec2::ONE);
        assert_eq!(out[0].x, 3.5);
        let tall = Window::middle(UVec2::new(2, 9), UVec2::new(4, 2));
        assert_eq!((tall.origin, tall.size), ([0.0, 4.0], [2.0, 1.0]));
    }
}
