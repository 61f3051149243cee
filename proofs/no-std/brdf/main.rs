//! Host file: `glimt-brdf` linked alone, without std and alloc.

#![no_std]
#![no_main]

#[path = "../rt.rs"]
mod rt;

use core::hint::black_box;
use glam::{Vec2, Vec3};
use glimt_brdf::BlinnPhong;

/// A glossy surface is sampled, and the density of the sample is what the density function says.
fn is_right() -> bool {
    let (diffuse, specular) = black_box((Vec3::splat(0.4), Vec3::splat(0.5)));
    let Ok(surface) = BlinnPhong::new(diffuse, specular, 50.0) else {
        return false;
    };
    let wo = Vec3::new(0.6, 0.0, 0.8);
    let sample = surface.sample(wo, black_box(1 << 30), black_box(Vec2::new(0.3, 0.7)));
    let pdf_sr = surface.pdf_sr(wo, sample.wi);
    let too_bright = BlinnPhong::new(Vec3::ONE, Vec3::ONE, 50.0).is_err();
    too_bright && sample.pdf_sr > 0.0 && (sample.pdf_sr / pdf_sr - 1.0).abs() < 1e-4
}
