//! Host file: the claims that unwarping a photograph of a mirror ball runs at half the pace of a nearest gather or more, and
//! at 30 frames per second from 2400×1700 pixels to 1628×814 texels on 2 threads. Decoding the photograph is apart.

use glam::{UVec2, Vec2, Vec3, Vec4};
use glimt::input::Reading;
use glimt::input::light_image::read_photo;
use glimt::notes::Notes;
use glimt::output::target::Guard;
use glimt::output::{Stamp, exr};
use glimt_benches::{Contest, claim};
use glimt_probe::gather::ColourMatrix;
use glimt_probe::mirror_ball::MirrorBall;
use glimt_probe::unwarp::Outline;
use glimt_render_gpu::prepare::unwarp::{BallPose, Look, UnwarpGrid, UnwarpMap, UnwarpOptions};
use rayon::prelude::*;

const PHOTO: UVec2 = UVec2::new(2400, 1700);
const SIZE: UVec2 = UVec2::new(1628, 814);

fn main() {
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(2)
        .build()
        .expect("a pool of two threads");
    pool.install(run);
}

fn run() {
    // A ball of 50 mm at 1250 mm, seen by a lens of 100 mm on pixels of 5 µm (Hajisharif 2012, § 4.1).
    let ball = MirrorBall::new(Vec3::X, Vec3::Z, 0.04);
    let pose = |shift: f32| BallPose {
        outline: Outline {
            centre: Vec2::new(1200.3 + shift, 849.6),
            radius: 800.6,
        },
        roll: 0.001,
    };
    let grid = UnwarpGrid::new(ball, SIZE);
    let options = UnwarpOptions::default();
    let map = grid
        .map(&pose(0.0), PHOTO, &options)
        .expect("a ball in the photograph");
    let photo: Vec<Vec4> = (0..PHOTO.x * PHOTO.y)
        .map(|i| {
            let (x, y) = ((i % PHOTO.x) as f32, (i / PHOTO.x) as f32);
            Vec4::new(1.0 + (0.01 * x).sin(), 1.0 + (0.013 * y).cos(), 0.5, 1.0)
        })
        .collect();
    let texels = f64::from(SIZE.x * SIZE.y);
    println!(
        "{} taps, {:.2} a texel, {:.1} MB",
        map.view().taps.len(),
        map.view().taps.len() as f64 / texels,
        map.view().taps.len() as f64 * 4e-6
    );
    let nearest = heaviest(&map);
    let mut bare = vec![Vec4::ZERO; nearest.len()];
    let mut near = vec![Vec4::ZERO; nearest.len()];
    let mut mean = near.clone();
    let width = SIZE.x as usize;
    let scores = Contest::new(
        "Unwarp 2400×1700 → 1628×814, the map ready, 2 threads",
        "texel",
        texels,
    )
    .entry("nearest gather and colour matrix", || {
        near.par_chunks_mut(width)
            .zip(nearest.par_chunks(width))
            .for_each(|(row, indices)| {
                for (texel, &pixel) in row.iter_mut().zip(indices) {
                    *texel = ColourMatrix::IDENTITY.apply(photo[pixel as usize]);
                }
            });
    })
    .entry("nearest gather alone", || {
        bare.par_chunks_mut(width)
            .zip(nearest.par_chunks(width))
            .for_each(|(row, indices)| {
                for (texel, &pixel) in row.iter_mut().zip(indices) {
                    *texel = photo[pixel as usize];
                }
            });
    })
    .entry("area-correct gather and colour matrix", || {
        map.apply_into(&photo, &Look::IDENTITY, &mut mean);
    })
    .run(41);
    claim(
        "at least half the pace of the nearest gather",
        scores[2].ratio <= 2.0,
    );
    claim(
        "at least 30 frames per second",
        scores[2].median.as_secs_f64() <= 1.0 / 30.0,
    );
    // The two see the same picture.
    let difference: f32 = near
        .iter()
        .zip(&mean)
        .map(|(a, b)| (*a - *b).abs().max_element())
        .sum();
    claim(
        "the two agree to a hundredth on a smooth picture",
        difference / (texels as f32) < 0.01,
    );

    let mut shift = 0.0;
    Contest::new("Making what a frame needs", "texel", texels)
        .entry("the grid, once for a capture", || {
            UnwarpGrid::new(ball, SIZE)
        })
        .entry("the map, once for a place of the ball", || {
            shift += 0.1;
            grid.map(&pose(shift), PHOTO, &options)
        })
        .run(5);
    decode(&photo);
}

/// What reading the photograph takes, which the claims leave apart.
fn decode(photo: &[Vec4]) {
    let folder = std::env::temp_dir();
    let stamp = Stamp {
        hash: String::new(),
        frame: 1,
    };
    let file = |name: &str, storage| {
        let file = folder.join(format!("glimt-bench-{name}-{}.exr", std::process::id()));
        let target = Guard::new(true).target(&file).expect("a file of its own");
        exr::write_rgb(&target, PHOTO, photo, &stamp, storage).expect("room for a photograph");
        file
    };
    let plain = file("plain", exr::Storage::Noisy);
    let half = file("half", exr::Storage::Half);
    let read = |file| {
        read_photo(file, &Reading::default(), &mut Notes::default()).map(|photo| photo.pixels.len())
    };
    Contest::new(
        "Reading a photograph of 2400×1700 pixels",
        "pixel",
        f64::from(PHOTO.x * PHOTO.y),
    )
    .entry("EXR, 32-bit floats as they are", || read(&plain))
    .entry("EXR, 16-bit floats, ZIP", || read(&half))
    .run(5);
    for file in [plain, half] {
        // What is left in the folder of temporary files does no harm.
        let _ = std::fs::remove_file(file);
    }
}

/// The pixel that counts most in each texel.
fn heaviest(map: &UnwarpMap) -> Vec<u32> {
    let view = map.view();
    let ends = view.texels.windows(2);
    ends.map(|w| {
        let mut pixel = w[0].pixel;
        let taps = view.taps[w[0].tap as usize..w[1].tap as usize].iter();
        let placed = taps.map(|tap| {
            pixel += tap >> 16;
            (tap & 0xffff, pixel)
        });
        placed.max().map_or(0, |(_, pixel)| pixel)
    })
    .collect()
}
