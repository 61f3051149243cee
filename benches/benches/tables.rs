//! Host file: the claim that building the table of a 2048×1024 RGB map on 2 threads takes at most 4 times as long as reading the
//! map.

use glam::UVec2;
use glimt_benches::{Contest, claim, inputs::procedural_map};
use glimt_envmap_cdf::{build_marginal_into, build_row_into, luminance_weights, required_len};
use rayon::prelude::*;

const SIZE: UVec2 = UVec2::new(2048, 1024);

fn main() {
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(2)
        .build()
        .expect("a pool of two threads");
    let map = procedural_map(SIZE);
    let columns = SIZE.x as usize;
    let len = required_len(SIZE.x, SIZE.y).expect("a size that tables have");
    let mut marginal = vec![0; len.marginal];
    let mut conditional = vec![0; len.conditional];
    let mut sums = vec![0.0; SIZE.y as usize];

    let read = || pool.install(|| map.par_chunks(columns).map(sum_of_row).sum::<f32>());
    let build = || {
        pool.install(|| {
            conditional
                .par_chunks_mut(columns + 1)
                .zip(&mut sums)
                .zip(map.par_chunks(columns))
                .for_each(|((edges, sum), row)| {
                    let report = build_row_into(luminance_weights(row), edges);
                    *sum = report.expect("rows of the right length").weight_sum;
                });
        });
        build_marginal_into(&sums, &mut marginal).expect("as many sums as rows")
    };
    let texels = f64::from(SIZE.x * SIZE.y);
    let scores = Contest::new(
        "Table of a 2048×1024 RGB f32 map, 2 threads",
        "texel",
        texels,
    )
    .entry("read-only pass (32 accumulators)", read)
    .entry("row and column tables", build)
    .run(41);
    claim(
        "the table costs at most 4 read-only passes",
        scores[1].ratio <= 4.0,
    );
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
