//! Host file: the land under the built-in sky: two ridges of hills, and a paved place with a dial inlaid.
//!
//! It lies at infinity like all of the map, drawn as it is seen from [`EYE`]: what is placed on z = 0 and looked at from there
//! stands on the paving.

use super::dome::{Light, sky_rows};
use glam::{UVec2, Vec2, Vec3, Vec4, vec2, vec3};
use glimt_probe::latlong::uv_to_direction;
use glimt_sampling::hash::hash2;
use rayon::prelude::*;
use std::f32::consts::{FRAC_1_PI, TAU};

/// From where the paving is seen in its right perspective [m].
pub(super) const EYE: Vec3 = vec3(-7.2, -0.9, 1.8);

/// Diffuse albedo of the paving.
pub(super) const PAVING: Vec3 = vec3(0.33, 0.29, 0.25);
/// Albedo of the inlay, as a share of the paving's.
const INLAY: f32 = 0.35;
/// Albedo of meadow and wood.
const MEADOW: Vec3 = vec3(0.07, 0.11, 0.035);

/// Radius of the paved place about the origin [m]; meadow lies beyond.
const PLACE: f32 = 26.0;
/// Side of a slab [m], and of the joint around it as a share of that.
const SLAB: f32 = 1.1;
const JOINT: f32 = 0.035;

/// Points along each side of a texel.
const POINTS: u32 = 3;

/// Draws the land into the lower half and over the lowest part of the sky.
pub(super) fn fill(texels: &mut [Vec4], size: UVec2, light: &Light) {
    let columns = size.x as usize;
    // No ridge is higher than this.
    let highest = (0.5 - 0.05) * size.y as f32;
    let texel_size = TAU / size.x as f32;
    let sky = sky_rows(size);
    texels
        .par_chunks_mut(columns)
        .enumerate()
        .for_each(|(row, texels)| {
            if (row as f32) < highest.floor() && row < sky {
                return;
            }
            for (column, texel) in texels.iter_mut().enumerate() {
                let mut sum = Vec3::ZERO;
                for point in 0..POINTS * POINTS {
                    let inside = (UVec2::new(point % POINTS, point / POINTS).as_vec2() + 0.5)
                        / POINTS as f32;
                    let uv = (vec2(column as f32, row as f32) + inside) / size.as_vec2();
                    let d = uv_to_direction(uv);
                    // Where no land is, the sky stays as it was.
                    sum += seen(d, texel_size, light).unwrap_or(texel.truncate());
                }
                *texel = (sum / (POINTS * POINTS) as f32).extend(1.0);
            }
        });
}

/// Radiance of the land in a direction; `None` in the sky.
fn seen(d: Vec3, texel: f32, light: &Light) -> Option<Vec3> {
    let azimuth = d.y.atan2(d.x);
    if d.z < 0.0 {
        return Some(ground(d, texel, light));
    }
    let elevation = d.z.asin();
    let (near, far) = (
        ridge(azimuth, 7.0, 0.034),
        ridge(azimuth + 1.7, 11.0, 0.068),
    );
    let (height, haze) = match elevation {
        e if e < near => (near, 0.22),
        e if e < far => (far, 0.55),
        _ => return None,
    };
    // Slopes face the viewer, steeper towards their tops.
    let rise = 0.9 - 0.5 * elevation / height;
    let normal = vec3(-azimuth.cos(), -azimuth.sin(), rise).normalize();
    let slope = MEADOW * lit(normal, light);
    Some(slope.lerp(light.horizon, haze))
}

/// Height of a ridge above the horizon [rad]: five waves that close around the horizon.
fn ridge(azimuth: f32, waves: f32, height: f32) -> f32 {
    let sum = (waves * azimuth + 0.4).sin()
        + 0.6 * (2.0 * waves * azimuth + 2.1).sin()
        + 0.35 * ((3.0 * waves + 2.0) * azimuth).sin()
        + 0.12 * ((9.0 * waves + 1.0) * azimuth + 1.0).sin()
        + 0.05 * ((31.0 * waves) * azimuth + 2.0).sin();
    height * (0.55 + 0.21 * sum).max(0.05)
}

/// Irradiance over π on a matte surface of albedo 1.
fn lit(normal: Vec3, light: &Light) -> Vec3 {
    // A surface that leans sees less of the sky.
    let sky = light.sky * (0.5 + 0.5 * normal.z);
    (sky + light.sun * normal.dot(light.direction).max(0.0)) * FRAC_1_PI
}

fn ground(d: Vec3, texel: f32, light: &Light) -> Vec3 {
    let below = (-d.z).max(1e-5);
    let place = EYE.truncate() + d.truncate() * (EYE.z / below);
    // Extent of a texel on the ground, along the line of sight.
    let extent = texel * EYE.z / (below * below);
    let paved = 1.0 - smooth((place.length() - PLACE) / (0.4 + extent));
    let albedo = MEADOW.lerp(PAVING * pattern(place, extent), paved);
    let haze = 0.55 * (-below / 0.02).exp();
    (albedo * lit(Vec3::Z, light)).lerp(light.horizon, haze)
}

/// Albedo of the place as a share of the paving's, its detail fading where a texel is as wide as that.
fn pattern(place: Vec2, extent: f32) -> f32 {
    let cell = (place / SLAB).floor();
    let inside = place / SLAB - cell;
    let tone = hash2(cell.x as i32 as u32, cell.y as i32 as u32) as f32 / u32::MAX as f32;
    let border = inside.min(Vec2::ONE - inside).min_element();
    let joint = if border < JOINT { 0.45 } else { 1.0 };
    let share = 1.0 - (1.0 - 2.0 * JOINT).powi(2);
    let mean = 1.0 - 0.55 * share;
    let slab = fade((0.86 + 0.28 * tone) * joint, mean, extent / SLAB);

    let radius = place.length();
    let turn = place.y.atan2(place.x) / TAU;
    let ring = |at: f32, width: f32| ((radius - at).abs() < 0.5 * width) as u32 as f32;
    let ray = ((turn * 24.0 - (turn * 24.0).round()).abs() * TAU / 24.0 * radius < 0.04
        && (1.75..3.7).contains(&radius)) as u32 as f32;
    let inlay = ring(1.7, 0.1)
        .max(ring(3.7, 0.16))
        .max(ring(4.1, 0.05))
        .max(ray);
    slab * (1.0 - (1.0 - INLAY) * fade(inlay, 0.1, 0.3 * extent / 0.1))
}

/// `value` where a texel is small beside the detail, `mean` where it is large.
fn fade(value: f32, mean: f32, ratio: f32) -> f32 {
    mean + (value - mean) * (1.5 - ratio).clamp(0.0, 1.0)
}

/// 0 below −½, 1 above ½.
fn smooth(x: f32) -> f32 {
    let t = (x + 0.5).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}
