//! Host file: a real panorama, seen through the camera, reads the right way round.
//!
//! The reference is a plain crop of a photograph, with no mapping code at all: near the horizon and in a narrow field of
//! view a lat-long crop is nearly what a perspective camera sees. A test image of one's own making could not tell a
//! mirrored convention from the right one.

use glam::{UVec2, Vec3};
use glimt_probe::latlong;
use glimt_sampling::luminance;
use image::{DynamicImage, Rgb32FImage};

const WIDTH: u32 = 96;
const HEIGHT: u32 = 54;
const FOV_X_DEG: f32 = 40.0;

/// The data that is not part of the project; `None`, with a printed line, where it is absent.
fn open(path: &str) -> Option<DynamicImage> {
    let full = glimt_tests::data::data_or_skip("orientation", path)?;
    Some(image::open(&full).unwrap_or_else(|e| panic!("{}: {e}", full.display())))
}

/// What the display would show, on a scale of stops: the logarithm of the clipped luminance.
fn log_luminance(rgb: Vec3) -> f64 {
    f64::from(luminance(rgb)).clamp(1.0 / 256.0, 1.0).log2()
}

/// The map through the camera that looks along +x with +z up.
fn through_camera(map: &Rgb32FImage) -> Vec<f64> {
    let size = UVec2::new(map.width(), map.height());
    let dir = Vec3::X;
    let right = dir.cross(Vec3::Z).normalize();
    let up = right.cross(dir);
    let (w, h) = (WIDTH as f32, HEIGHT as f32);
    let t = (0.5 * FOV_X_DEG.to_radians()).tan();
    let mut pixels = Vec::new();
    for j in 0..HEIGHT {
        for i in 0..WIDTH {
            let across = (2.0 * (i as f32 + 0.5) / w - 1.0) * t;
            let down = (2.0 * (j as f32 + 0.5) / h - 1.0) * t * (h / w);
            let texel = latlong::direction_to_texel(dir + across * right - down * up, size);
            pixels.push(log_luminance(Vec3::from_array(
                map.get_pixel(texel.x, texel.y).0,
            )));
        }
    }
    pixels
}

/// The middle of the photograph, as wide and high as the camera's field of view, averaged down to the same pixels.
fn plain_crop(photograph: &DynamicImage) -> Vec<f64> {
    let photograph = photograph.to_rgb8();
    let per_degree = photograph.width() as f32 / 360.0;
    let fov_y_deg = 2.0
        * ((0.5 * FOV_X_DEG.to_radians()).tan() * HEIGHT as f32 / WIDTH as f32)
            .atan()
            .to_degrees();
    let (w, h) = (FOV_X_DEG * per_degree, fov_y_deg * per_degree);
    let (left, top) = (
        0.5 * (photograph.width() as f32 - w),
        0.5 * (photograph.height() as f32 - h),
    );
    let decode = |code: u8| {
        let c = f32::from(code) / 255.0;
        if c <= 0.040_45 {
            c / 12.92
        } else {
            ((c + 0.055) / 1.055).powf(2.4)
        }
    };
    let mut pixels = Vec::new();
    for j in 0..HEIGHT {
        for i in 0..WIDTH {
            let columns = |i: u32| (left + i as f32 * w / WIDTH as f32) as u32;
            let rows = |j: u32| (top + j as f32 * h / HEIGHT as f32) as u32;
            let (mut sum, mut n) = (Vec3::ZERO, 0.0);
            for y in rows(j)..rows(j + 1) {
                for x in columns(i)..columns(i + 1) {
                    sum += Vec3::from_array(photograph.get_pixel(x, y).0.map(decode));
                    n += 1.0;
                }
            }
            pixels.push(log_luminance(sum / n));
        }
    }
    pixels
}

fn correlation(a: &[f64], b: &[f64]) -> f64 {
    let mean = |x: &[f64]| x.iter().sum::<f64>() / x.len() as f64;
    let (ma, mb) = (mean(a), mean(b));
    let sum =
        |f: &dyn Fn(f64, f64) -> f64| a.iter().zip(b).map(|(a, b)| f(a - ma, b - mb)).sum::<f64>();
    sum(&|a, b| a * b) / (sum(&|a, _| a * a) * sum(&|_, b| b * b)).sqrt()
}

#[test]
fn a_photograph_is_seen_unmirrored_and_upright() {
    let (Some(map), Some(photograph)) = (
        open("hdri/spruit_sunrise_1k.hdr"),
        open("backplate/spruit_sunrise_4k.jpg"),
    ) else {
        return;
    };
    let seen = through_camera(&map.to_rgb32f());
    let expected = plain_crop(&photograph);
    let right_way = correlation(&seen, &expected);
    let mirrored: Vec<f64> = seen
        .chunks(WIDTH as usize)
        .flat_map(|row| row.iter().rev().copied())
        .collect();
    let flipped: Vec<f64> = seen
        .chunks(WIDTH as usize)
        .rev()
        .flatten()
        .copied()
        .collect();
    let (mirrored, flipped) = (
        correlation(&mirrored, &expected),
        correlation(&flipped, &expected),
    );
    println!("correlation {right_way:.4}, mirrored {mirrored:.4}, upside down {flipped:.4}");
    assert!(right_way > 0.95);
    assert!(mirrored < right_way - 0.1);
    assert!(flipped < right_way - 0.1);
}
