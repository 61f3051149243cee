//! Host file: the claim that building the table of a 2048×1024 RGB map on 2 threads takes at most 4 times as long as reading the
//! map; and what the table of compensated weights, and that of the light's cells, cost beside it.

use glam::{UVec2, Vec3, Vec4};
use glimt_benches::{Contest, claim, inputs::procedural_map};
use glimt_envmap_cdf::{
    TableLen, build_marginal_into, build_row_into, compensated_weight, luminance_weights,
    mean_weight, required_len, weight_sum,
};
use glimt_light_cells::{build_band, required_words, split_bands, store_sums};
use rayon::prelude::*;

const SIZE: UVec2 = UVec2::new(2048, 1024);

fn main() {
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(2)
        .build()
        .expect("a pool of two threads");
    let map = procedural_map(SIZE);
    let columns = SIZE.x as usize;
    let [mut plain, mut compensated] = [Tables::new(), Tables::new()];

    let read = || pool.install(|| map.par_chunks(columns).map(sum_of_row).sum::<f32>());
    let build = || pool.install(|| plain.build(&map, |weight| weight));
    let compensate = || {
        pool.install(|| {
            let rows = map.par_chunks(columns);
            let sums: Vec<f64> = rows.map(|row| weight_sum(luminance_weights(row))).collect();
            let mean = mean_weight(&sums, SIZE.x);
            compensated.build(&map, |weight| compensated_weight(weight, mean));
        });
    };
    let texels = f64::from(SIZE.x * SIZE.y);
    let texels_of: Vec<Vec4> = map.iter().map(|t| Vec3::from(*t).extend(1.0)).collect();
    let mut words = vec![0; required_words(SIZE).expect("a size that tables have")];
    let cells = || pool.install(|| build_cells(&texels_of, &mut words));
    let scores = Contest::new(
        "Table of a 2048×1024 RGB f32 map, 2 threads",
        "texel",
        texels,
    )
    .entry("read-only pass (32 accumulators)", read)
    .entry("row and column tables", build)
    .entry("the same of compensated weights", compensate)
    .entry("cells of the light", cells)
    .run(41);
    claim(
        "the table costs at most 4 read-only passes",
        scores[1].ratio <= 4.0,
    );
    claim(
        "cells cost at most 1.3 times the table",
        scores[3].ratio <= 1.3 * scores[1].ratio,
    );
}

/// The cells of a map, their rows on all threads.
fn build_cells(texels: &[Vec4], words: &mut [u32]) {
    let (head, bands) = split_bands(SIZE, words).expect("as many words as needed");
    let row = |y: u32| &texels[(y * SIZE.x) as usize..][..SIZE.x as usize];
    let bands = bands.into_par_iter().enumerate();
    let sums: Vec<_> = bands
        .map(|(i, band)| build_band(SIZE, i as u32, row, band).expect("rows of the right length"))
        .collect();
    for (i, sums) in (0..).zip(&sums) {
        store_sums(SIZE, i, sums, head);
    }
}

/// The tables of a map.
struct Tables {
    marginal: Vec<u32>,
    conditional: Vec<u32>,
}

impl Tables {
    fn new() -> Self {
        let len: TableLen = required_len(SIZE.x, SIZE.y).expect("a size that tables have");
        Self {
            marginal: vec![0; len.marginal],
            conditional: vec![0; len.conditional],
        }
    }

    fn build(&mut self, map: &[[f32; 3]], weight: impl Fn(f32) -> f32 + Copy + Sync) {
        let columns = SIZE.x as usize;
        let rows = self.conditional.par_chunks_mut(columns + 1);
        let rows = rows.zip(map.par_chunks(columns));
        let sums = rows.map(|(edges, row)| {
            let report = build_row_into(luminance_weights(row).map(weight), edges);
            report.expect("rows of the right length").weight_sum
        });
        let sums: Vec<f64> = sums.collect();
        build_marginal_into(&sums, &mut self.marginal).expect("as many sums as rows");
    }
}

/// The sum of a row's channels in 32 accumulators: as fast as memory is read.
fn sum_of_row(row: &[[f32; 3]]) -> f32 {
    let values = row.as_flattened();
    let mut sums = [0.0; 32];
    let blocks = values.chunks_exact(32);
    let rest: f32 = blocks.remainder().iter().sum();
    for block in blocks {
        for (sum, value) in sums.iter_mut().zip(block) {
            *sum += value;
        }
    }
    rest + sums.iter().sum::<f32>()
}
