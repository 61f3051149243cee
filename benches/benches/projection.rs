//! Host file: the claims that projecting a light map onto four bands runs at a fifth of the pace of reading it or more, and
//! 1.5 times as fast as a plain loop over its rows, on all threads.
//!
//! The loop is compiled for every processor of its kind, as a program is unless told otherwise, and once more for AVX2 and FMA,
//! which reading and projection use where they are. The path of the projection for processors without them runs beside.

use std::f32::consts::{PI, TAU};

use glam::{UVec2, Vec3};
use glimt_benches::{Contest, claim};
use glimt_render_gpu::prepare::projection::Projector;
use glimt_sh::separable::{meridian_index, ring_index};
use glimt_sh::{
    LightCoefficients, Projection, RingTable, build_ring_table_into, coefficient_index,
    ring_table_len,
};
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
    let mut table = vec![0.0; ring_table_len(size.x, BANDS, 3).expect("a map")];
    build_ring_table_into(size.x, BANDS, 3, &mut table).expect("a map");
    let table = RingTable::new(size.x, BANDS, 3, &table).expect("a map");
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
        .entry("the same, row_sums_plain", || portable(&table, size, &map))
        .entry("plain loop", || plain.project(&map, Plain::add_row))
        .entry("plain loop, AVX2 and FMA", || {
            plain.project(&map, Plain::add_row_wide)
        })
        .run(rounds);
    for score in &scores[1..] {
        let pace = 100.0 / score.ratio;
        println!("  {pace:.1} % of the pace of reading: {}", score.name);
    }
    let [_, ours, portable_path, base, wide] = [0, 1, 2, 3, 4].map(|i| scores[i].ratio);
    println!(
        "  projection: {:.2} times the plain loop, {:.2} times that for AVX2 and FMA; row_sums_plain: {:.2} and {:.2}",
        base / ours,
        wide / ours,
        base / portable_path,
        wide / portable_path
    );
    claim("at least 20 % of the pace of reading", ours <= 5.0);
    claim("at least 40 % of it, the aim", ours <= 2.5);
    claim("at least 1.5 times the plain loop", base >= 1.5 * ours);
    claim(
        "at least 1.5 times the plain loop for AVX2 and FMA",
        wide >= 1.5 * ours,
    );
    let found = projector.project(&map).expect("a map");
    let bound = 1e-5 * found[0].length();
    let others = [
        portable(&table, size, &map),
        plain.project(&map, Plain::add_row),
        plain.project(&map, Plain::add_row_wide),
    ];
    let agrees = |other: &LightCoefficients| {
        let pairs = found.iter().zip(other);
        pairs.into_iter().all(|(a, b)| (*a - *b).length() <= bound)
    };
    claim("all agree to 10⁻⁵", others.iter().all(agrees));
}

/// The projection by the path that every processor has.
fn portable(table: &RingTable<'_>, size: UVec2, map: &[[f32; 3]]) -> LightCoefficients {
    let width = size.x as usize;
    let parts = map.par_chunks(ROWS * width).enumerate();
    let parts: Vec<Projection> = parts
        .map(|(part, rows)| {
            let mut projection = Projection::new(BANDS, size).expect("a map");
            for (i, row) in rows.chunks(width).enumerate() {
                let sums = table.row_sums_plain(row.as_flattened()).expect("a row");
                let row = (part * ROWS + i) as u32;
                projection.add_row(row, &sums).expect("a row");
            }
            projection
        })
        .collect();
    let mut all = Projection::new(BANDS, size).expect("a map");
    for part in &parts {
        all.merge(part).expect("the same map");
    }
    all.coefficients()
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

/// Adds a row to sums.
type AddRow = fn(&Plain, usize, &[[f32; 3]], &mut LightCoefficients);

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

    fn project(&self, map: &[[f32; 3]], add_row: AddRow) -> LightCoefficients {
        let width = self.size.x as usize;
        let parts = map.par_chunks(ROWS * width).enumerate();
        let parts: Vec<LightCoefficients> = parts
            .map(|(part, rows)| {
                let mut out = [Vec3::ZERO; 36];
                for (i, row) in rows.chunks(width).enumerate() {
                    add_row(self, part * ROWS + i, row, &mut out);
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
        self.add(y, row, out);
    }

    /// The same, compiled for AVX2 and FMA.
    fn add_row_wide(&self, y: usize, row: &[[f32; 3]], out: &mut LightCoefficients) {
        #[cfg(target_arch = "x86_64")]
        if std::is_x86_feature_detected!("avx2") && std::is_x86_feature_detected!("fma") {
            // SAFETY: both were found just now.
            return unsafe { self.add_row_avx2(y, row, out) };
        }
        self.add(y, row, out);
    }

    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx2,fma")]
    fn add_row_avx2(&self, y: usize, row: &[[f32; 3]], out: &mut LightCoefficients) {
        self.add(y, row, out);
    }

    #[inline(always)]
    fn add(&self, y: usize, row: &[[f32; 3]], out: &mut LightCoefficients) {
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
