//! Host file: what the keys of a simulated capture must fulfil beyond being well-formed.

use super::settings::{Shape, Synth};
use crate::error::{Error, Result};
use crate::shot::parse::Source;
use glam::Vec3;

/// Largest width or height of an image.
const MAX_SIDE: u32 = 32_768;
/// Most pixels of an image.
const MAX_PIXELS: u64 = 1 << 26;
/// Most samples of a pixel.
const MAX_SAMPLES: u32 = 64;

/// Checks every value.
///
/// # Errors
/// The first value that cannot be filmed, with its key, its place and what would do.
pub fn check(synth: &Synth, source: &Source) -> Result<()> {
    let keys = Keys(source);
    keys.require(
        "frames",
        (1..=1_000_000).contains(&synth.frames),
        "it is not between 1 and 1000000",
        "24 is usual",
    )?;
    keys.between("fps", synth.fps, 1e-3, 1000.0)?;
    keys.between("light.rotate_z_deg", synth.light.rotate_z_deg, -1e6, 1e6)?;
    keys.between("light.scale", synth.light.scale, 0.0, 1e12)?;
    capture(synth, &keys)?;
    surroundings(synth, &keys)?;
    for (i, lamp) in synth.lamps.iter().enumerate() {
        let key = |name: &str| format!("lamp.{i}.{name}");
        keys.between(&key("azimuth_deg"), lamp.azimuth_deg, -1e6, 1e6)?;
        keys.between(&key("elevation_deg"), lamp.elevation_deg, -90.0, 90.0)?;
        let ends = [
            ("to_azimuth_deg", lamp.to_azimuth_deg, 1e6),
            ("to_elevation_deg", lamp.to_elevation_deg, 90.0),
        ];
        for (name, end, most) in ends {
            keys.between(&key(name), end.unwrap_or(0.0), -most, most)?;
        }
        keys.between(&key("radius_deg"), lamp.radius_deg, 0.05, 60.0)?;
        keys.colour(&key("radiance"), lamp.radiance, 1e12)?;
        keys.between(&key("flicker"), lamp.flicker, 0.0, 1.0)?;
    }
    keys.between("clouds.cover", synth.clouds.cover, 0.0, 1.0)?;
    keys.between("clouds.depth", synth.clouds.depth, 0.0, 100.0)?;
    keys.between("clouds.scale", synth.clouds.scale, 1e-3, 1e3)?;
    keys.within("clouds.drift", &synth.clouds.drift, 1e6)?;
    let noise = &synth.noise;
    keys.require(
        "noise.exposures",
        noise.exposures <= 32,
        "it is above 32",
        "8 is usual; 0 turns noise off",
    )?;
    keys.between("noise.stops", noise.stops, 0.1, 12.0)?;
    keys.between("noise.full_well", noise.full_well, 100.0, 1e7)?;
    keys.between("noise.read_noise", noise.read_noise, 0.0, 1e4)?;
    keys.require(
        "noise.bits",
        (4..=24).contains(&noise.bits),
        "it is not between 4 and 24",
        "14 is usual",
    )?;
    if let Some(clip) = noise.clip_radiance {
        keys.between("noise.clip_radiance", clip, 1e-12, 1e12)?;
    }
    let plate = &synth.plate;
    keys.size("plate.size", plate.size)?;
    keys.between("plate.fov_x_deg", plate.fov_x_deg, 0.01, 179.0)?;
    keys.within("plate.offset_m", &plate.offset_m, 1e6)?;
    if let Some(direction) = plate.direction {
        keys.axes("plate.direction", direction, "capture.up", synth.capture.up)?;
    }
    keys.between("plate.exposure_ev", plate.exposure_ev, -100.0, 100.0)?;
    keys.require(
        "plate.rays_per_pixel",
        (1..=1024).contains(&plate.rays_per_pixel),
        "it is not between 1 and 1024",
        "4 is usual",
    )?;
    keys.size("truth.size", synth.truth.size)?;
    keys.require(
        "output.dir",
        !synth.output.dir.is_empty(),
        "it is empty",
        "\".\" is the folder of the settings",
    )
}

fn capture(synth: &Synth, keys: &Keys<'_>) -> Result<()> {
    let capture = &synth.capture;
    keys.size("capture.size", capture.size)?;
    keys.between("capture.pixel_um", capture.pixel_um, 1e-3, 1e6)?;
    keys.between("capture.lens_mm", capture.lens_mm, 1e-3, 1e7)?;
    keys.between("capture.distance_mm", capture.distance_mm, 1e-3, 1e7)?;
    keys.require(
        "capture.radius_mm",
        capture.radius_mm > 0.0 && capture.radius_mm <= 0.9 * capture.distance_mm,
        &format!(
            "it is not above 0 and below 0.9 of capture.distance_mm = {}",
            capture.distance_mm
        ),
        "50, 40 and 25 are the paper's",
    )?;
    keys.axes("capture.forward", capture.forward, "capture.up", capture.up)?;
    keys.between("capture.jitter_px", capture.jitter_px, 0.0, 1e4)?;
    let focal = super::geometry::focal_px(synth);
    keys.require(
        "capture.jitter_px",
        f64::from(capture.jitter_px) <= 0.02 * focal,
        &format!(
            "the camera would turn by more than a degree: its focal length is {focal:.0} pixels"
        ),
        "1 to 10 pixels are usual; a small image takes a larger capture.pixel_um and less of this",
    )?;
    keys.between(
        "capture.jitter_roll_deg",
        capture.jitter_roll_deg,
        0.0,
        20.0,
    )?;
    keys.require(
        "capture.supersampling",
        (1..=MAX_SAMPLES).contains(&capture.supersampling),
        &format!("it is not between 1 and {MAX_SAMPLES}"),
        "4 is usual",
    )?;
    keys.colour("ball.tint", synth.ball.tint, 1.0)?;
    keys.within("rig.half_size_m", &synth.rig.half_size_m, 1e6)?;
    keys.require(
        "rig.half_size_m",
        !synth.rig.on || synth.rig.half_size_m.iter().all(|h| *h > 0.0),
        "a side is not above 0",
        "rig.on = false leaves it out",
    )?;
    let free = 1e-3 * (capture.distance_mm - capture.radius_mm);
    keys.require(
        "rig.half_size_m",
        !synth.rig.on || synth.rig.half_size_m[2] < free,
        &format!("it reaches into the ball, whose surface is {free} m before the camera"),
        "make its last number smaller",
    )?;
    keys.between("rig.albedo", synth.rig.albedo, 0.0, 1.0)
}

fn surroundings(synth: &Synth, keys: &Keys<'_>) -> Result<()> {
    let stage = &synth.stage;
    for (key, v) in [
        ("stage.size_m", stage.size_m),
        ("stage.from_m", stage.from_m),
        ("stage.to_m", stage.to_m),
        ("occluder.from_m", synth.occluder.from_m),
        ("occluder.to_m", synth.occluder.to_m),
    ] {
        keys.within(key, &v, 1e6)?;
    }
    keys.require(
        "stage.size_m",
        stage.size_m.iter().all(|s| *s > 0.0),
        "a side is not above 0",
        "as [20, 20, 20]",
    )?;
    let half = 0.5 * Vec3::from(stage.size_m);
    let inside = |p: Vec3| match stage.shape {
        Shape::Infinite => true,
        Shape::Sphere => p.length() < half.x,
        Shape::Box => p.abs().cmplt(half).all(),
    };
    for (frame, key) in [(1, "stage.from_m"), (synth.frames, "stage.to_m")] {
        let (probe, eye) = super::geometry::probe_and_eye(synth, frame);
        keys.require(
            key,
            inside(probe.as_vec3()) && inside(eye.as_vec3()),
            "the ball or its camera would stand outside the stage",
            "enlarge stage.size_m, or move less",
        )?;
    }
    keys.between("occluder.radius_m", synth.occluder.radius_m, 0.0, 1e6)?;
    keys.colour("occluder.radiance", synth.occluder.radiance, 1e12)?;
    keys.between("sun.radius_deg", synth.sun.radius_deg, 0.05, 30.0)?;
    if let Some(irradiance) = synth.sun.irradiance {
        keys.colour("sun.irradiance", irradiance, 1e12)?;
    }
    for (key, angles) in [
        ("sun.from_deg", synth.sun.from_deg),
        ("sun.to_deg", synth.sun.to_deg),
    ] {
        let Some([azimuth, elevation]) = angles else {
            continue;
        };
        keys.between(key, azimuth, -1e6, 1e6)?;
        keys.between(key, elevation, -90.0, 90.0)?;
    }
    keys.require(
        "sun.to_deg",
        synth.light.map.is_empty() || synth.sun.to_deg.is_none() || synth.sun.from_deg.is_some(),
        "the arc has no beginning",
        "give sun.from_deg = [azimuth, elevation], too",
    )
}

/// Errors about keys.
struct Keys<'a>(&'a Source);

impl Keys<'_> {
    fn require(&self, key: &str, holds: bool, what: &str, fix: &str) -> Result<()> {
        match holds {
            true => Ok(()),
            false => Err(self.0.error(key, what).fix(fix)),
        }
    }

    fn between(&self, key: &str, value: f32, least: f32, most: f32) -> Result<()> {
        if value >= least && value <= most {
            return Ok(());
        }
        let what = format!("it is not between {least} and {most}");
        let error: Error = self.0.error(key, what);
        Err(error.fix("choose a number in between"))
    }

    fn within(&self, key: &str, values: &[f32], most: f32) -> Result<()> {
        let fine = values.iter().all(|v| v.abs() <= most);
        self.require(
            key,
            fine,
            &format!("a number is not finite, or beyond {most}"),
            "write plain numbers",
        )
    }

    fn colour(&self, key: &str, colour: [f32; 3], most: f32) -> Result<()> {
        let fine = colour.iter().all(|c| *c >= 0.0 && *c <= most);
        self.require(
            key,
            fine,
            &format!("a channel is not between 0 and {most}"),
            "as [0.7, 0.7, 0.7]",
        )
    }

    fn size(&self, key: &str, size: [u32; 2]) -> Result<()> {
        self.require(
            key,
            size.iter().all(|n| (1..=MAX_SIDE).contains(n)),
            "a side is 0 or above 32768",
            "as [1024, 512]",
        )?;
        self.require(
            key,
            u64::from(size[0]) * u64::from(size[1]) <= MAX_PIXELS,
            "it has more than 2^26 pixels",
            "as [1024, 512]",
        )
    }

    /// A direction, and one that is up beside it.
    fn axes(&self, key: &str, forward: [f32; 3], up_key: &str, up: [f32; 3]) -> Result<()> {
        self.within(key, &forward, 1e6)?;
        self.within(up_key, &up, 1e6)?;
        let (forward, up) = (Vec3::from(forward), Vec3::from(up));
        let across = forward.normalize_or_zero().cross(up.normalize_or_zero());
        self.require(
            key,
            across.length() > 1e-3,
            &format!("it has no length, or points along {up_key}"),
            "[1, 0, 0] with up = [0, 0, 1] looks along +x",
        )
    }
}
