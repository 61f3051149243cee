//! Host file: what a filmed mirror ball says of the light, against the light itself: a simulated capture, unwarped by the
//! true and by the found pose, and compared with the map that an ideal probe in the ball's place records.
//!
//! Three comparisons, over the directions that the ball shows: the relative RMS difference of radiance away from lamps, by
//! solid angle; the flux; and where the brightest region is.

use glam::{DVec3, UVec2, Vec4};
use glimt::capture::{Capture, Poses};
use glimt::device::Processor;
use glimt::input::light_image::LightImage;
use glimt::input::read_image;
use glimt::notes::Notes;
use glimt::shot;
use glimt::synth::{Filming, Synth, SynthFrame, rig_half_angle};
use glimt_ball::find;
use glimt_probe::gather::ColourMatrix;
use glimt_probe::latlong::{texel_direction, texel_solid_angle_sr};
use glimt_probe::unwarp::{Outline, Visibility};
use glimt_render_gpu::prepare::unwarp::BallPose;
use glimt_sampling::luminance;
use glimt_tests::data::data_or_skip;
use rayon::prelude::*;
use std::path::Path;

/// Bounds of the three comparisons.
const RMSE: f64 = 0.02;
const FLUX: f64 = 0.01;
const SUN_DEG: f64 = 0.3;

/// Radiance over the mean above which a texel is a lamp's, and how far around it texels are left out of the RMSE.
const LAMP: f64 = 20.0;
const AROUND_LAMP_DEG: f64 = 4.0;

/// A filmed frame and what it should show.
struct Filmed {
    synth: Synth,
    frame: SynthFrame,
    size: UVec2,
    truth: Vec<Vec4>,
}

/// How a map differs from the truth.
#[derive(Clone, Copy, Debug)]
struct Difference {
    /// Relative RMS difference away from lamps.
    rmse: f64,
    /// The largest relative difference of a channel's flux.
    flux: f64,
    /// Angle between the brightest regions' middles, in degrees.
    sun_deg: f64,
}

impl std::fmt::Display for Difference {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self {
            rmse,
            flux,
            sun_deg,
        } = self;
        write!(
            f,
            "RMSE {:.3} %, flux {:+.3} %, sun {sun_deg:.3}°",
            100.0 * rmse,
            100.0 * flux
        )
    }
}

impl Filmed {
    fn new(synth: Synth, light: Option<&Path>, size: UVec2, frame: u32) -> Self {
        let map = light.map(|file| {
            let image = read_image(file, &mut Notes::default()).expect("a light map");
            (image.header.size, image.texels)
        });
        let filming = Filming::new(synth.clone(), map, None);
        let world = filming.world(frame);
        let truth = filming.truth_map(&Processor::Cpu, &world, frame, size);
        Self {
            frame: filming
                .film_frame(&Processor::Cpu, &world, frame)
                .expect("the CPU films"),
            truth: truth.expect("the CPU films"),
            synth,
            size,
        }
    }

    fn true_pose(&self) -> BallPose {
        let truth = &self.frame.truth;
        BallPose {
            outline: Outline {
                centre: glam::DVec2::from(truth.centre_px).as_vec2(),
                radius: truth.radius_px as f32,
            },
            roll: truth.roll_deg.to_radians() as f32,
        }
    }

    /// The outline that the program finds. A roll shows between frames alone: it is taken as it is.
    fn found_pose(&self) -> BallPose {
        let found = find(self.frame.size, &self.frame.pixels, None).expect("a ball");
        BallPose {
            outline: Outline {
                centre: found.circle.centre.as_vec2(),
                radius: found.circle.radius as f32,
            },
            ..self.true_pose()
        }
    }

    /// The keys of the shot that goes with the capture.
    fn keys(&self) -> shot::Ball {
        shot::Ball {
            distance_mm: self.synth.capture.distance_mm,
            radius_mm: self.synth.capture.radius_mm,
            size: Some(self.size.to_array()),
            reflectance: self.synth.ball.tint,
            rig_deg: rig_half_angle(&self.synth).to_degrees(),
            ..shot::Ball::default()
        }
    }

    /// The map that the program makes, and what became of each of its texels.
    fn unwarp(&self, keys: &shot::Ball, pose: BallPose) -> (Vec<Vec4>, Vec<Visibility>) {
        let capture = Capture::new(keys, Poses::Fixed(pose));
        let photo = LightImage {
            size: self.frame.size,
            pixels: self.frame.pixels.clone(),
            hash: [0; 32],
        };
        let file = Path::new("a frame");
        let map = capture.map(1, file, photo.size).expect("a whole ball");
        let texels = map.apply(&photo.pixels, &capture.look(&ColourMatrix::IDENTITY));
        (texels, map.visibility().to_vec())
    }

    fn difference_of(&self, keys: &shot::Ball, pose: BallPose) -> Difference {
        let (texels, seen) = self.unwarp(keys, pose);
        difference(&texels, &self.truth, &seen, self.size)
    }
}

fn directions(size: UVec2) -> Vec<DVec3> {
    (0..size.x * size.y)
        .map(|i| texel_direction(UVec2::new(i % size.x, i / size.x), size).as_dvec3())
        .collect()
}

fn brightness(texel: &Vec4) -> f64 {
    f64::from(luminance(texel.truncate()))
}

/// `map` against `truth`, where `seen` says that it is.
fn difference(map: &[Vec4], truth: &[Vec4], seen: &[Visibility], size: UVec2) -> Difference {
    let directions = directions(size);
    let weight = |i: usize| f64::from(texel_solid_angle_sr(i as u32 / size.x, size));
    let shown: Vec<usize> = (0..truth.len())
        .filter(|i| seen[*i] == Visibility::Seen)
        .collect();
    // Nearly all of the sphere: else there is nothing to compare.
    assert!(shown.len() > truth.len() * 9 / 10);

    let all: f64 = (0..truth.len()).map(weight).sum();
    let mean = (0..truth.len())
        .map(|i| weight(i) * brightness(&truth[i]))
        .sum::<f64>()
        / all;
    let lamps: Vec<DVec3> = (0..truth.len())
        .filter(|i| brightness(&truth[*i]) > LAMP * mean)
        .map(|i| directions[i])
        .collect();
    let near = AROUND_LAMP_DEG.to_radians().cos();
    let away: Vec<usize> = shown
        .par_iter()
        .copied()
        .filter(|i| lamps.iter().all(|lamp| lamp.dot(directions[*i]) < near))
        .collect();
    assert!(away.len() > truth.len() / 2, "lamps are everywhere");
    let square = |v: Vec4| v.truncate().as_dvec3().length_squared();
    let sum = |f: &dyn Fn(usize) -> f64| away.iter().map(|i| weight(*i) * f(*i)).sum::<f64>();
    let rmse = (sum(&|i| square(map[i] - truth[i])) / sum(&|i| square(truth[i]))).sqrt();

    let flux = |texels: &[Vec4]| -> DVec3 {
        let one = |i: &usize| texels[*i].truncate().as_dvec3() * weight(*i);
        shown.iter().map(one).sum()
    };
    let off = flux(map) / flux(truth) - 1.0;
    let flux = [off.x, off.y, off.z]
        .into_iter()
        .max_by(|a, b| a.abs().total_cmp(&b.abs()))
        .unwrap_or_default();

    let centres = [map, truth].map(|texels| brightest(texels, seen, size, &directions));
    Difference {
        rmse,
        flux,
        sun_deg: centres[0].angle_between(centres[1]).to_degrees(),
    }
}

/// Middle of the light of the region around the brightest texel that is at least a tenth as bright.
fn brightest(texels: &[Vec4], seen: &[Visibility], size: UVec2, directions: &[DVec3]) -> DVec3 {
    let shown = |i: &usize| seen[*i] == Visibility::Seen;
    let level = |i: usize| brightness(&texels[i]);
    let top = (0..texels.len())
        .filter(shown)
        .max_by(|a, b| level(*a).total_cmp(&level(*b)))
        .expect("a texel that is seen");
    let mut taken = vec![false; texels.len()];
    let mut next = vec![top];
    taken[top] = true;
    let mut sum = DVec3::ZERO;
    let [w, h] = size.to_array().map(|n| n as usize);
    while let Some(i) = next.pop() {
        let weight = f64::from(texel_solid_angle_sr((i / w) as u32, size));
        sum += directions[i] * weight * level(i);
        let (x, y) = (i % w, i / w);
        let mut neighbours = vec![y * w + (x + 1) % w, y * w + (x + w - 1) % w];
        neighbours.extend(y.checked_sub(1).map(|y| y * w + x));
        neighbours.extend((y + 1 < h).then_some((y + 1) * w + x));
        for j in neighbours {
            if !taken[j] && shown(&j) && level(j) >= 0.1 * level(top) {
                taken[j] = true;
                next.push(j);
            }
        }
    }
    sum.normalize()
}

/// A frame of the default rig at this width, with noise, its rig, tint and Fresnel, and a camera that shakes by `jitter_px`.
fn capture(width: u32, jitter_px: f32) -> Synth {
    let mut synth = Synth::default();
    synth.capture.size = [width, width * 17 / 24];
    synth.capture.pixel_um = 5.0 * 2400.0 / width as f32;
    synth.capture.jitter_px = jitter_px;
    synth.plate.on = false;
    synth
}

/// Frame of the captures that is looked at.
const FRAME: u32 = 3;

/// Says how far a map is from the truth.
fn told(name: &str, what: &str, d: Difference) -> Difference {
    println!("{name}, {what}: {d}");
    d
}

/// By the true pose and by the found one all bounds hold, and nothing wrong passes.
fn compare(name: &str, filmed: &Filmed) {
    let (keys, pose) = (filmed.keys(), filmed.true_pose());
    let d = told(name, "true pose", filmed.difference_of(&keys, pose));
    assert!(d.rmse < RMSE, "{name}: {d}");
    assert!(d.flux.abs() < FLUX, "{name}: {d}");
    assert!(d.sun_deg < SUN_DEG, "{name}: {d}");

    let found = filmed.found_pose();
    let aside = found.outline.centre - pose.outline.centre;
    let larger = found.outline.radius - pose.outline.radius;
    println!("{name}: the centre is found {aside:+.2} px aside, the radius {larger:+.2} px larger");
    let d = told(name, "found pose", filmed.difference_of(&keys, found));
    assert!(d.flux.abs() < FLUX, "{name}: {d}");
    assert!(d.rmse < RMSE, "{name}: {d}");
    assert!(d.sun_deg < SUN_DEG, "{name}: {d}");

    // A ball taken to be three pixels aside: another picture, of much the same light.
    let mut aside = pose;
    aside.outline.centre.x += 3.0;
    let d = told(name, "3 px aside", filmed.difference_of(&keys, aside));
    assert!(d.rmse > RMSE, "{name}: {d}");
    // A ball taken for a perfect mirror.
    let perfect = shot::Ball {
        reflectance: [1.0; 3],
        ..keys.clone()
    };
    let d = told(name, "reflectance 1", filmed.difference_of(&perfect, pose));
    assert!(d.rmse > RMSE && d.flux.abs() > FLUX, "{name}: {d}");
    // Left for right.
    let (mut texels, seen) = filmed.unwarp(&keys, pose);
    for row in texels.chunks_mut(filmed.size.x as usize) {
        row.reverse();
    }
    let d = difference(&texels, &filmed.truth, &seen, filmed.size);
    let d = told(name, "mirrored", d);
    assert!(d.rmse > RMSE && d.sun_deg > SUN_DEG, "{name}: {d}");
}

#[test]
fn the_procedural_sky_comes_back() {
    let mut synth = capture(1200, 2.5);
    let size = UVec2::new(512, 256);
    let filmed = Filmed::new(synth.clone(), None, size, FRAME);
    compare("sky", &filmed);
    // The rig's reflection is taken for light where it is not filled; without noise the same bounds hold.
    let keys = shot::Ball {
        rig_deg: 0.0,
        ..filmed.keys()
    };
    let d = filmed.difference_of(&keys, filmed.true_pose());
    assert!(told("sky", "rig left in", d).rmse > RMSE);
    synth.noise.exposures = 0;
    let clean = Filmed::new(synth, None, size, FRAME);
    let d = clean.difference_of(&clean.keys(), clean.true_pose());
    told("sky", "true pose, no noise", d);
    assert!(d.rmse < RMSE && d.flux.abs() < FLUX && d.sun_deg < SUN_DEG);
}

/// A photographed map, filmed at full size.
fn photographed(test: &str, name: &str) {
    let Some(file) = data_or_skip(test, &format!("hdri/{name}")) else {
        return;
    };
    let size = UVec2::new(512, 256);
    let filmed = Filmed::new(capture(2400, 5.0), Some(&file), size, FRAME);
    compare(name, &filmed);
}

#[test]
fn a_sunrise_comes_back() {
    photographed("a_sunrise_comes_back", "spruit_sunrise_1k.hdr");
}

#[test]
fn clouds_come_back() {
    photographed("clouds_come_back", "kloppenheim_05_1k.hdr");
}

#[test]
fn lamps_come_back() {
    photographed("lamps_come_back", "studio_small_03_1k.hdr");
}
