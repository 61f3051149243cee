//! Host file: the outline of a ball of full size, to a quarter of a pixel, on simulated captures with noise and shake.

mod common;

use glam::{DVec2, DVec3, UVec2, Vec4};
use glimt::device::Processor;
use glimt::input::read_image;
use glimt::notes::Notes;
use glimt::synth::{Filming, Synth};
use glimt_ball::{Circle, find};

/// A limit on the root mean square of each error, in pixels.
const LIMIT: f64 = 0.25;

/// Root mean squares of errors in x, y and radius.
fn rms(errors: &[DVec3]) -> DVec3 {
    let sum: DVec3 = errors.iter().map(|&e| e * e).sum();
    (sum / errors.len() as f64).map(f64::sqrt)
}

fn accurate(errors: &[DVec3]) -> bool {
    !errors.is_empty() && rms(errors).max_element() < LIMIT
}

/// The error of the outline of a ball of a radius, filmed at 2400 × 1700 in a map or in the built-in sky.
fn error_in(
    name: &str,
    map: Option<&(UVec2, Vec<Vec4>)>,
    radius_mm: f32,
    seed: u32,
    noise: bool,
) -> DVec3 {
    let mut synth = Synth {
        seed,
        ..Synth::default()
    };
    synth.capture.radius_mm = radius_mm;
    synth.capture.jitter_px = 5.0;
    if !noise {
        synth.noise.exposures = 0;
    }
    let filming = Filming::new(synth, map.cloned(), None);
    let frame = filming
        .film_frame(&Processor::Cpu, &filming.world(1), 1)
        .expect("the CPU films");
    let truth = Circle {
        centre: DVec2::from(frame.truth.centre_px),
        radius: frame.truth.radius_px,
    };
    let found = find(frame.size, &frame.pixels, None).expect("a ball");
    let error = (found.circle.centre - truth.centre).extend(found.circle.radius - truth.radius);
    println!("{name} {radius_mm} mm: {truth} is off by {error:.3}, {found:?}");
    error
}

#[test]
fn an_outline_of_full_size_to_a_quarter_of_a_pixel() {
    let mut errors = vec![
        error_in("sky", None, 50.0, 4101, true),
        error_in("sky", None, 40.0, 4102, true),
        error_in("sky", None, 25.0, 4103, true),
        error_in("sky", None, 50.0, 4104, false),
    ];
    if let Some(data) = common::shared_data() {
        let maps = [
            ("spruit_sunrise_1k", 50.0),
            ("kloppenheim_05_1k", 25.0),
            ("st_fagans_interior_1k", 40.0),
            ("potsdamer_platz_1k", 50.0),
        ];
        for (seed, (name, radius)) in (4105..).zip(maps) {
            let file = data.join(format!("hdri/{name}.hdr"));
            let image = read_image(&file, &mut Notes::default()).expect("a map");
            let map = (image.header.size, image.texels);
            errors.push(error_in(name, Some(&map), radius, seed, true));
        }
    }
    let all = rms(&errors);
    println!("RMS of x, y, radius: {all:.3}");
    assert!(accurate(&errors), "{all}");
    // The comparator fails on circles that are off by half a pixel.
    for off in [DVec3::X, DVec3::Y, DVec3::Z].map(|axis| 0.5 * axis) {
        let wrong: Vec<DVec3> = errors.iter().map(|&e| e + off).collect();
        assert!(!accurate(&wrong));
    }
}
