//! Host file: the shared functions that no frame shows agree on both processors.

use glimt_tests::gpu::adapter_or_skip;
use glimt_tests::shared_image::{self, atlas};

/// Largest difference relative to the value or to 1, for each page. Those that raise to a power follow the driver's `pow`.
/// The last adds up 36 values with weights up to 36.
const TOLERANCES: [f32; atlas::PAGES as usize] =
    [1e-5, 1e-5, 2e-3, 1e-5, 1e-4, 1e-5, 5e-3, 1e-5, 1e-4];

#[test]
fn the_atlas_is_the_same_on_both_processors() {
    let Some(context) = adapter_or_skip("atlas") else {
        return;
    };
    let pair = shared_image::atlas_pair(&shared_image::program(), &context);
    let page_words = (4 * atlas::PAGE_SIZE * atlas::PAGE_SIZE) as usize;
    let (cpu, gpu) = (pair.cpu.chunks(page_words), pair.gpu.chunks(page_words));
    for ((page, (cpu, gpu)), tolerance) in cpu.zip(gpu).enumerate().zip(TOLERANCES) {
        let largest = largest_difference(cpu, gpu);
        println!("page {page}: {largest:e}");
        assert!(
            largest <= tolerance,
            "page {page}: {largest:e} above {tolerance:e}"
        );
    }
}

#[test]
fn the_comparison_fails_where_it_should() {
    let one = [1.0_f32.to_bits()];
    assert!(!(largest_difference(&one, &[1.1_f32.to_bits()]) <= 0.01));
    assert!(!(largest_difference(&one, &[f32::NAN.to_bits()]) <= 0.01));
    assert!(!(largest_difference(&one, &[]) <= 0.01));
}

/// NaN where either side has one, or where the lengths differ.
fn largest_difference(cpu: &[u32], gpu: &[u32]) -> f32 {
    if cpu.len() != gpu.len() {
        return f32::NAN;
    }
    let differences = cpu.iter().zip(gpu).map(|(a, b)| {
        let (a, b) = (f32::from_bits(*a), f32::from_bits(*b));
        (a - b).abs() / a.abs().max(1.0)
    });
    // `!(…)` lets a NaN in, and keeps it.
    differences.fold(0.0, |largest: f32, d| {
        if !(largest >= d) && !largest.is_nan() {
            d
        } else {
            largest
        }
    })
}
