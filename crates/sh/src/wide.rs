//! Host file: a row's sums over φ in registers of eight floats, where the processor has them.
//!
//! The same sums as in `row.rs`, written in the processor's own instructions: what the compiler makes of plain loops
//! keeps the sums in memory, at a third of the pace.

use core::arch::x86_64::{
    __m128, __m256, _MM_HINT_T0, _mm_prefetch, _mm256_add_pd, _mm256_add_ps,
    _mm256_castps256_ps128, _mm256_cvtps_pd, _mm256_extractf128_ps, _mm256_fmadd_ps,
    _mm256_fnmadd_ps, _mm256_loadu_pd, _mm256_loadu_ps, _mm256_mul_ps, _mm256_setzero_ps,
    _mm256_storeu_pd, _mm256_sub_ps,
};

use crate::ring_table::{LANES, Layout, RingSums};
use crate::row::{BLOCK, Lanes, add_lanes, by_shape, quarters};

/// Bytes that come into the cache together.
const LINE: usize = 64;

/// The sums of a row's groups, as [`row::sum_groups`](crate::row::sum_groups) has them; `None` where the processor lacks the
/// instructions, or there are no groups.
pub(crate) fn sum_groups(
    layout: &Layout,
    bands: u32,
    row: &[f32],
    grouped: &[f32],
) -> Option<RingSums> {
    let has = std::is_x86_feature_detected!("avx2") && std::is_x86_feature_detected!("fma");
    if !has || layout.groups == 0 {
        return None;
    }
    let mut out = RingSums::default();
    // SAFETY: AVX2 and FMA were found just now.
    unsafe {
        by_shape!(layout.vectors, bands, sum(row, grouped, &mut out));
    }
    Some(out)
}

#[target_feature(enable = "avx2,fma")]
#[inline]
fn load(from: &[f32; LANES]) -> __m256 {
    // SAFETY: eight floats are read where eight floats are.
    unsafe { _mm256_loadu_ps(from.as_ptr()) }
}

#[target_feature(enable = "avx2,fma")]
#[inline]
fn add_to(sums: &mut [f64; 4], values: __m128) {
    // SAFETY: four f64 are read and written where four f64 are.
    unsafe {
        let sum = _mm256_add_pd(_mm256_loadu_pd(sums.as_ptr()), _mm256_cvtps_pd(values));
        _mm256_storeu_pd(sums.as_mut_ptr(), sum);
    }
}

/// `sum + a x + b y`. Where there are registers to spare the products come first: each sum then waits for one addition
/// and not for two.
#[target_feature(enable = "avx2,fma")]
#[inline]
fn plus<const K: usize>(sum: __m256, a: __m256, x: __m256, b: __m256, y: __m256) -> __m256 {
    if K <= 7 {
        _mm256_add_ps(sum, _mm256_fmadd_ps(b, y, _mm256_mul_ps(a, x)))
    } else {
        _mm256_fmadd_ps(b, y, _mm256_fmadd_ps(a, x, sum))
    }
}

/// `sum + a x − b y`.
#[target_feature(enable = "avx2,fma")]
#[inline]
fn minus<const K: usize>(sum: __m256, a: __m256, x: __m256, b: __m256, y: __m256) -> __m256 {
    if K <= 7 {
        _mm256_add_ps(sum, _mm256_fnmadd_ps(b, y, _mm256_mul_ps(a, x)))
    } else {
        _mm256_fnmadd_ps(b, y, _mm256_fmadd_ps(a, x, sum))
    }
}

/// As `row::sum`.
#[target_feature(enable = "avx2,fma")]
fn sum<const K: usize, const T: usize, const P: usize>(
    row: &[f32],
    grouped: &[f32],
    out: &mut RingSums,
) {
    let mut lanes: Lanes<K> = [[0.0; 12]; K];
    let [a, b, c, d] = quarters::<P>(row);
    let table = grouped.as_chunks::<LANES>().0.as_chunks::<T>().0;
    let table = table.as_chunks::<P>().0;
    let blocks = a.chunks(BLOCK).zip(b.chunks(BLOCK)).zip(c.chunks(BLOCK));
    let blocks = blocks.zip(d.chunks(BLOCK)).zip(table.chunks(BLOCK));
    // The row below, most likely the next to be summed, is asked for meanwhile, from its beginning to its end, as many bytes
    // a step as the step reads: four streams of a few kilobytes each are too short for the processor to foresee, and many
    // lines asked for at once wait for each other.
    let mut ahead = row.as_ptr_range().end.cast::<i8>();
    for ((((a, b), c), d), table) in blocks {
        for p in 0..P {
            let mut sums = [_mm256_setzero_ps(); K];
            for ((((a, b), c), d), table) in a.iter().zip(b).zip(c).zip(d).zip(table) {
                for line in 0..4 * LANES * size_of::<f32>() / LINE {
                    _mm_prefetch::<_MM_HINT_T0>(ahead.wrapping_add(line * LINE));
                }
                ahead = ahead.wrapping_add(4 * LANES * size_of::<f32>());
                let (a, b, c, d) = (load(&a[p]), load(&b[p]), load(&c[p]), load(&d[p]));
                let (even, odd) = (_mm256_add_ps(a, c), _mm256_add_ps(b, d));
                let all = _mm256_add_ps(even, odd);
                let alternating = _mm256_sub_ps(even, odd);
                let (along, across) = (_mm256_sub_ps(a, c), _mm256_sub_ps(b, d));
                let table = &table[p];
                sums[0] = _mm256_add_ps(sums[0], all);
                // m = 1
                let (cos, sin) = (load(&table[0]), load(&table[1]));
                sums[1] = plus::<K>(sums[1], along, cos, across, sin);
                sums[2] = minus::<K>(sums[2], along, sin, across, cos);
                if T > 2 {
                    let (cos, sin) = (load(&table[2]), load(&table[3]));
                    sums[3] = _mm256_fmadd_ps(alternating, cos, sums[3]);
                    sums[4] = _mm256_fmadd_ps(alternating, sin, sums[4]);
                }
                if T > 4 {
                    let (cos, sin) = (load(&table[4]), load(&table[5]));
                    sums[5] = minus::<K>(sums[5], along, cos, across, sin);
                    sums[6] = plus::<K>(sums[6], along, sin, across, cos);
                }
                if T > 6 {
                    let (cos, sin) = (load(&table[6]), load(&table[7]));
                    sums[7] = _mm256_fmadd_ps(all, cos, sums[7]);
                    sums[8] = _mm256_fmadd_ps(all, sin, sums[8]);
                }
                if T > 8 {
                    let (cos, sin) = (load(&table[8]), load(&table[9]));
                    sums[9] = plus::<K>(sums[9], along, cos, across, sin);
                    sums[10] = minus::<K>(sums[10], along, sin, across, cos);
                }
            }
            for k in 0..K {
                let [low, middle, high] = lanes[k].as_chunks_mut::<4>().0 else {
                    return;
                };
                let halves = (
                    _mm256_castps256_ps128(sums[k]),
                    _mm256_extractf128_ps::<1>(sums[k]),
                );
                let (first, second) = match p {
                    0 => (low, middle),
                    1 => (high, low),
                    _ => (middle, high),
                };
                add_to(first, halves.0);
                add_to(second, halves.1);
            }
        }
    }
    add_lanes::<K, P>(&lanes, out);
}
