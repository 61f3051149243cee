//! Host file: the claims that projecting a light map onto four bands runs at a fifth of the pace of reading it or more, and
//! 1.5 times as fast as a plain loop over its rows, on all threads.

use std::f32::consts::{PI, TAU};

use glam::{UVec2, Vec3};
use glimt_benches::{Contest, claim};
use glimt_render_gpu::host::projection::Projector;
use glimt_sh::separable::{meridian_index, ring_index};
use glimt_sh::{LightCoefficients, coefficient_index};
use rayon::prelude::*;

/// What is compared: four bands, 16 coefficients.
const BANDS: u32 = 4;
/// Rows in a task, of every contestant.
const ROWS: usize = 16;

fn main() {
    println!("{} threads", rayon::current_num_threads());
    contest(UVec2::new(1024, 512), 401);
    contest(UVec2::new(4096, 2048), 61);
}

fn contest(size: UVec2, rounds: usize) {
    let width = size.x as usize;
    let map: Vec<[f32; 3]> = (0..size.x * size.y)
        .map(|i| {
            let (x, y) = ((i % size.x) as f32, (i / size.x) as f32);
            [1.0 + (0.01 * x).sin(), 1.0 + (0.013 * y).cos(), 0.5]
        })
        .collect();
    let projector = Projector::new(size, BANDS, 3).expect("a map");
    let plain = Plain::new(size);
    let bytes = size_of_val(&map[..]) as f64;
    let title = format!("Projecting {} × {} RGB floats", size.x, size.y);
    let scores = Contest::new(&title, "byte", bytes)
        .entry("reading: the sum of all floats", || {
            map.par_chunks(ROWS * width)
                .map(|rows| sum(rows.as_flattened()))
                .sum::<f32>()
        })
        .entry("projection, 4 bands", || projector.project(&map))
        .entry("plain separable loop, 4 bands", || plain.project(&map))
        .run(rounds);
    let (ours, theirs) = (scores[1].ratio, scores[2].ratio);
    println!(
        "  {:.1} % of the pace of reading; {:.2} times the plain loop",
        100.0 / ours,
        theirs / ours
    );
    claim("at least 20 % of the pace of reading", ours <= 5.0);
    claim("at least 40 % of it, the aim", ours <= 2.5);
    claim("at least 1.5 times the plain loop", theirs >= 1.5 * ours);
    let (a, b) = (projector.project(&map).expect("a map"), plain.project(&map));
    let bound = 1e-5 * a[0].length();
    let agree = a.iter().zip(&b).all(|(a, b)| (*a - *b).length() <= bound);
    claim("the two agree to 10⁻⁵", agree);
}

/// The sum of floats with as many sums side by side as hide the latency of adding, in the widest registers that there are.
fn sum(floats: &[f32]) -> f32 {
    #[cfg(target_arch = "x86_64")]
    if std::is_x86_feature_detected!("avx2") {
        // SAFETY: AVX2 was found just now.
        return unsafe { sum_avx2(floats) };
    }
    sum_lanes(floats)
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
fn sum_avx2(floats: &[f32]) -> f32 {
    sum_lanes(floats)
}

#[inline(always)]
fn sum_lanes(floats: &[f32]) -> f32 {
    let (chunks, rest) = floats.as_chunks::<64>();
    let mut sums = [0.0f32; 64];
    for chunk in chunks {
        for (sum, value) in sums.iter_mut().zip(chunk) {
            *sum += value;
        }
    }
    sums.iter().chain(rest).sum()
}

/// What one writes from the formula: a table of cosines and sines, seven sums a channel over each row, then the factors
/// of θ.
struct Plain {
    size: UVec2,
    ring: Vec<[f32; 7]>,
}

impl Plain {
    fn new(size: UVec2) -> Self {
        let ring = (0..size.x).map(|j| {
            let phi = PI - TAU * (j as f32 + 0.5) / size.x as f32;
            let harmonic = |m: f32| [(m * phi).cos(), (m * phi).sin()];
            let ([c1, s1], [c2, s2], [c3, s3]) = (harmonic(1.0), harmonic(2.0), harmonic(3.0));
            [1.0, c1, s1, c2, s2, c3, s3]
        });
        Self {
            size,
            ring: ring.collect(),
        }
    }

    fn project(&self, map: &[[f32; 3]]) -> LightCoefficients {
        let width = self.size.x as usize;
        let parts = map.par_chunks(ROWS * width).enumerate();
        let parts: Vec<LightCoefficients> = parts
            .map(|(part, rows)| {
                let mut out = [Vec3::ZERO; 36];
                for (i, row) in rows.chunks(width).enumerate() {
                    self.add_row(part * ROWS + i, row, &mut out);
                }
                out
            })
            .collect();
        let mut out = [Vec3::ZERO; 36];
        for part in parts {
            for (sum, value) in out.iter_mut().zip(part) {
                *sum += value;
            }
        }
        out
    }

    fn add_row(&self, y: usize, row: &[[f32; 3]], out: &mut LightCoefficients) {
        let mut sums = [[0.0f32; 3]; 7];
        for (texel, ring) in row.iter().zip(&self.ring) {
            for (sum, factor) in sums.iter_mut().zip(ring) {
                for (sum, value) in sum.iter_mut().zip(texel) {
                    *sum += factor * value;
                }
            }
        }
        let edge = |y: usize| (PI * y as f32 / self.size.y as f32).cos();
        let area = TAU / self.size.x as f32 * (edge(y) - edge(y + 1));
        let theta = PI * (y as f32 + 0.5) / self.size.y as f32;
        let meridian = glimt_sh::meridian(theta.cos(), theta.sin());
        for l in 0..BANDS {
            for m in -(l as i32)..=l as i32 {
                let ring = Vec3::from_array(sums[ring_index(m) as usize]);
                let factor = area * meridian[meridian_index(l, m.unsigned_abs()) as usize];
                out[coefficient_index(l, m) as usize] += factor * ring;
            }
        }
    }
}
