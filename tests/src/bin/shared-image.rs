//! Host file: prints one line for each image of the shared code: its name, a hash of its pixels from the CPU, and one of
//! those from a shader made of the same text.

use glimt_tests::gpu::adapter_or_skip;
use glimt_tests::shared_image::{self, Pair};

fn main() {
    let Some(context) = adapter_or_skip("shared-image") else {
        return;
    };
    let program = shared_image::program();
    // Whoever reads the lines may have seen enough after a few.
    let show = |image: Pair| {
        let (cpu, gpu) = (hash(&image.cpu), hash(&image.gpu));
        println!("{} {cpu:016x} {gpu:016x}", image.name);
    };
    show(shared_image::atlas_pair(&program, &context));
    show(shared_image::light_pair(&program, &context));
    show(shared_image::transfer_pair(&program, &context));
    show(shared_image::capture_pair(&program, &context));
    show(shared_image::sampler_pair(&program, &context));
    show(shared_image::projection_pair(&program, &context));
    show(shared_image::drawing_pair(&program, &context));
    shared_image::frame_pairs(&program, &context, &show);
}

/// FNV-1a over the words.
fn hash(words: &[u32]) -> u64 {
    words.iter().fold(0xcbf2_9ce4_8422_2325, |hash, word| {
        (hash ^ u64::from(*word)).wrapping_mul(0x100_0000_01b3)
    })
}
