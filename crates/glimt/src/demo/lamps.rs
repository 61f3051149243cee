//! Host file: coloured lamps that sway and flicker, written into the light map as discs.

use super::shot_time;
use crate::disc::add_disc;
use glam::{UVec2, Vec3, Vec4, dvec3, vec3};
use std::f64::consts::TAU;

/// A lamp far away: a disc of the light map.
struct Lamp {
    /// Angles in degrees: counter-clockwise seen from above from +x, above the horizon, and radius of the disc.
    azimuth: f64,
    elevation: f64,
    radius: f64,
    /// How far it sways to either side, in degrees, and how often in the shot.
    sway: f64,
    swings: f64,
    /// Radiance, before it flickers.
    radiance: Vec3,
    /// How much of the radiance the flicker takes away at most.
    flicker: f32,
}

const LAMPS: [Lamp; 4] = [
    // A fire, on the right behind the camera.
    Lamp {
        azimuth: 228.0,
        elevation: 14.0,
        radius: 3.0,
        sway: 1.0,
        swings: 3.0,
        radiance: vec3(1500.0, 550.0, 100.0),
        flicker: 0.6,
    },
    // A lantern that swings, left behind the camera.
    Lamp {
        azimuth: 142.0,
        elevation: 30.0,
        radius: 2.2,
        sway: 9.0,
        swings: 1.0,
        radiance: vec3(100.0, 700.0, 1000.0),
        flicker: 0.1,
    },
    // Magenta, on the right.
    Lamp {
        azimuth: 284.0,
        elevation: 24.0,
        radius: 2.6,
        sway: 5.0,
        swings: 1.5,
        radiance: vec3(1000.0, 100.0, 650.0),
        flicker: 0.25,
    },
    // A small white one, high behind the sculpture on the right.
    Lamp {
        azimuth: 312.0,
        elevation: 52.0,
        radius: 1.2,
        sway: 0.0,
        swings: 0.0,
        radiance: vec3(1500.0, 1350.0, 1150.0),
        flicker: 0.0,
    },
];

/// Adds the lamps of frame `frame` to a lat-long map.
pub(super) fn add(texels: &mut [Vec4], size: UVec2, frame: u32) {
    let time = f64::from(shot_time(frame));
    for (index, lamp) in LAMPS.iter().enumerate() {
        let swing = lamp.sway * (TAU * lamp.swings * time).sin();
        let (sin_a, cos_a) = (lamp.azimuth + swing).to_radians().sin_cos();
        let (sin_e, cos_e) = lamp.elevation.to_radians().sin_cos();
        let centre = dvec3(cos_e * cos_a, cos_e * sin_a, sin_e);
        let level = 1.0 - lamp.flicker * flicker(f64::from(frame), index as f64);
        add_disc(
            texels,
            size,
            centre,
            lamp.radius.to_radians(),
            level * lamp.radiance,
        );
    }
}

/// A restless number in [0, 1]: two sines whose periods share no multiple.
pub(crate) fn flicker(frame: f64, phase: f64) -> f32 {
    (0.5 + 0.25 * ((1.9 * frame + phase).sin() + (3.1 * frame + 2.0 * phase).sin())) as f32
}
