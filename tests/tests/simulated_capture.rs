//! Host file: the simulated capture against what it should be: rays in f64, energies, angles and statistics that are worked
//! out here; and the frames of the GPU against the CPU's.

use glam::{DVec2, DVec3, UVec2, Vec2, Vec3, Vec4, dvec2, dvec3};
use glimt::device::Processor;
use glimt::synth::{Filming, Lamp, Shape, Synth, SynthFrame};
use glimt_probe::latlong::{texel_direction, texel_solid_angle_sr};
use glimt_probe::mirror_ball::{MirrorBall, pixel_to_image};
use glimt_probe::rotate::cos_sin_degrees;
use glimt_render_gpu::kernels::sensor::expose;
use glimt_sampling::{UniformSource, Xoshiro128PlusPlus};
use glimt_tests::gpu::adapter_or_skip;
use std::f64::consts::PI;

const MAP: UVec2 = UVec2::new(64, 32);

/// A small capture without noise, rig and shake, of an ideal mirror.
fn plain(size: [u32; 2]) -> Synth {
    let mut synth = Synth::default();
    synth.capture.size = size;
    synth.capture.pixel_um = 5.0 * 2400.0 / size[0] as f32;
    synth.capture.jitter_px = 0.0;
    synth.capture.jitter_roll_deg = 0.0;
    synth.ball.tint = [1.0; 3];
    synth.ball.fresnel = false;
    synth.rig.on = false;
    synth.noise.exposures = 0;
    synth.plate.on = false;
    synth
}

/// A map of random texels.
fn noisy_map() -> Vec<Vec4> {
    let mut source = Xoshiro128PlusPlus::stream(5, 6, 7);
    let mut unit = || source.next_u32() as f32 / u32::MAX as f32;
    (0..MAP.x * MAP.y)
        .map(|_| Vec4::new(unit(), unit(), unit(), 1.0))
        .collect()
}

fn film(synth: &Synth, size: UVec2, texels: &[Vec4], frame: u32) -> SynthFrame {
    let filming = Filming::new(synth.clone(), Some((size, texels.to_vec())), None);
    let world = filming.world(frame);
    filming
        .film_frame(&Processor::Cpu, &world, frame)
        .expect("the CPU films")
}

/// The map's bilinear value in a direction, as its definition says.
fn look_up(texels: &[Vec4], d: DVec3) -> DVec3 {
    let d = d.normalize();
    let u = (0.5 - d.y.atan2(d.x) / (2.0 * PI)) * f64::from(MAP.x) - 0.5;
    let v = d.z.clamp(-1.0, 1.0).acos() / PI * f64::from(MAP.y) - 0.5;
    let texel = |x: f64, y: f64| {
        let x = (x as i64).rem_euclid(i64::from(MAP.x));
        let y = (y as i64).clamp(0, i64::from(MAP.y) - 1);
        texels[(y * i64::from(MAP.x) + x) as usize]
            .truncate()
            .as_dvec3()
    };
    let (x, y) = (u.floor(), v.floor());
    let (f, g) = (u - x, v - y);
    let upper = texel(x, y) * (1.0 - f) + texel(x + 1.0, y) * f;
    let lower = texel(x, y + 1.0) * (1.0 - f) + texel(x + 1.0, y + 1.0) * f;
    upper * (1.0 - g) + lower * g
}

/// What surrounds the ball, for rays in f64.
enum Walls {
    Infinite,
    Sphere(f64),
    Box(DVec3),
}

impl Walls {
    fn direction(&self, origin: DVec3, d: DVec3) -> DVec3 {
        match *self {
            Walls::Infinite => d,
            Walls::Sphere(radius) => {
                let b = origin.dot(d);
                let c = origin.dot(origin) - radius * radius;
                origin + d * (-b + (b * b - c).sqrt())
            }
            Walls::Box(half) => {
                let t = (0..3)
                    .map(|i| (half[i] * d[i].signum() - origin[i]) / d[i])
                    .fold(f64::MAX, f64::min);
                origin + d * t
            }
        }
    }
}

/// Ray and sphere, then the mirror, all in f64: radiance at a pixel position, and whether the ball is seen there.
fn traced(
    synth: &Synth,
    frame: &SynthFrame,
    walls: &Walls,
    texels: &[Vec4],
    pixel: DVec2,
) -> (DVec3, bool) {
    let focal = f64::from(synth.capture.lens_mm) * 1000.0 / f64::from(synth.capture.pixel_um);
    let at = (pixel - frame.size.as_dvec2() * 0.5) / focal;
    let [right, up, forward] = frame.truth.camera.map(DVec3::from);
    let d = (forward + right * at.x - up * at.y).normalize();
    let eye = DVec3::from(frame.truth.eye_m);
    let centre = DVec3::from(frame.truth.probe_m);
    let radius = f64::from(synth.capture.radius_mm) * 1e-3;
    let from = eye - centre;
    let (b, c) = (from.dot(d), from.dot(from) - radius * radius);
    let root = b * b - c;
    if root < 0.0 {
        return (look_up(texels, walls.direction(eye, d)), false);
    }
    let hit = eye + d * (-b - root.sqrt());
    let normal = (hit - centre).normalize();
    let reflected = d - normal * (2.0 * d.dot(normal));
    let tint = Vec3::from(synth.ball.tint).as_dvec3();
    let rise = if synth.ball.fresnel { 1.0 } else { 0.0 };
    let schlick = tint + (DVec3::ONE - tint) * rise * (1.0 + d.dot(normal)).powi(5);
    let radiance = look_up(texels, walls.direction(hit, reflected));
    (schlick * radiance, true)
}

/// The largest difference of filmed pixels from traced ones, where one ray in the pixel's middle is all: on the ball up to 0.9
/// of its radius, and clear of its outline beside it.
fn worst(synth: &Synth, told: &Synth, walls: &Walls) -> f64 {
    let texels = noisy_map();
    let frame = film(synth, MAP, &texels, 3);
    let mut worst: f64 = 0.0;
    let (mut on, mut off) = (0, 0);
    for (i, value) in frame.pixels.iter().enumerate() {
        let at = UVec2::new(i as u32 % frame.size.x, i as u32 / frame.size.x);
        let pixel = at.as_dvec2() + 0.5;
        let s = pixel.distance(DVec2::from(frame.truth.centre_px)) / frame.truth.radius_px;
        if s > 0.9 && s < 1.05 {
            continue;
        }
        let (expected, hit) = traced(told, &frame, walls, &texels, pixel);
        assert_eq!(hit, s < 1.0);
        if hit {
            on += 1
        } else {
            off += 1
        }
        worst = worst.max((value.truncate().as_dvec3() - expected).abs().max_element());
    }
    assert!(on > 1000 && off > 1000);
    worst
}

#[test]
fn pixels_are_what_reflected_rays_see() {
    let mut synth = plain([240, 170]);
    synth.capture.supersampling = 1;
    synth.capture.jitter_px = 3.0;
    synth.capture.jitter_roll_deg = 2.0;
    synth.ball.tint = [0.7, 0.6, 0.5];
    synth.ball.fresnel = true;
    synth.capture.forward = [0.8, -0.5, 0.3];
    synth.stage.from_m = [0.2, -0.1, 0.3];
    synth.stage.to_m = [-0.4, 0.3, 0.1];
    assert!(worst(&synth, &synth, &Walls::Infinite) < 2e-4);
    synth.stage.shape = Shape::Sphere;
    synth.stage.size_m = [6.0, 1.0, 1.0];
    assert!(worst(&synth, &synth, &Walls::Sphere(3.0)) < 2e-4);
    synth.stage.shape = Shape::Box;
    synth.stage.size_m = [6.0, 5.0, 4.0];
    let walls = Walls::Box(dvec3(3.0, 2.5, 2.0));
    assert!(worst(&synth, &synth, &walls) < 2e-4);
    // Neither another ball, nor another stage, nor another surface passes for it.
    let mut other = synth.clone();
    other.capture.radius_mm *= 1.01;
    assert!(!(worst(&synth, &other, &walls) < 2e-4));
    assert!(!(worst(&synth, &synth, &Walls::Infinite) < 2e-4));
    other = synth.clone();
    other.ball.fresnel = false;
    assert!(!(worst(&synth, &other, &walls) < 2e-4));
}

#[test]
fn a_far_camera_is_orthographic() {
    let mut synth = plain([240, 170]);
    synth.capture.supersampling = 1;
    // A thousand times as far through a lens a thousand times as long.
    synth.capture.distance_mm *= 1000.0;
    synth.capture.lens_mm *= 1000.0;
    let texels = noisy_map();
    let frame = film(&synth, MAP, &texels, 1);
    assert!((frame.truth.radius_px - 80.0).abs() < 0.01);
    let worst = |scale: f64| {
        let mut worst: f64 = 0.0;
        for (i, value) in frame.pixels.iter().enumerate() {
            let pixel = dvec2(f64::from(i as u32 % 240), f64::from(i as u32 / 240)) + 0.5;
            let p = (pixel - dvec2(120.0, 85.0)) / frame.truth.radius_px * scale;
            if p.length() > 0.9 {
                continue;
            }
            // |p| = sin(θ/2), θ from the direction back to the camera, −x; image right is −y, image down −z.
            let theta = 2.0 * p.length().asin();
            let aside = if p.length() > 0.0 { p.normalize() } else { p };
            let d = dvec3(-theta.cos(), -aside.x * theta.sin(), -aside.y * theta.sin());
            // At the poles of the map a small angle is many texels.
            if d.z.abs() > 0.98 {
                continue;
            }
            let difference = value.truncate().as_dvec3() - look_up(&texels, d);
            worst = worst.max(difference.abs().max_element());
        }
        worst
    };
    assert!(worst(1.0) < 2e-3, "{}", worst(1.0));
    assert!(!(worst(1.01) < 2e-3));
}

/// Sum of a frame's pixels times the solid angle that each shows.
fn ball_flux(synth: &Synth, frame: &SynthFrame) -> DVec3 {
    let k = synth.capture.radius_mm / synth.capture.distance_mm;
    let ball = MirrorBall::new(Vec3::X, Vec3::Z, k);
    let centre = DVec2::from(frame.truth.centre_px).as_vec2();
    let radius = frame.truth.radius_px as f32;
    let mut sum = DVec3::ZERO;
    for (i, value) in frame.pixels.iter().enumerate() {
        let corner = UVec2::new(i as u32 % frame.size.x, i as u32 / frame.size.x).as_vec2();
        let mut area = 0.0;
        for sub in 0..64 {
            let inside = (Vec2::new((sub % 8) as f32, (sub / 8) as f32) + 0.5) / 8.0;
            let p = pixel_to_image(corner + inside, centre, radius);
            area += f64::from(ball.solid_angle_sr_per_area(p)) / 64.0;
        }
        let area = area / (frame.truth.radius_px * frame.truth.radius_px);
        sum += value.truncate().as_dvec3() * area;
    }
    sum
}

#[test]
fn the_ball_holds_the_energy_of_all_but_the_hidden_cone() {
    let synth = plain([480, 340]);
    let size = UVec2::new(256, 128);
    let constant = vec![Vec4::ONE; 256 * 128];
    // A sky, a ground, a window, and a sun of one texel.
    let real: Vec<Vec4> = (0..256 * 128)
        .map(|i: u32| {
            let (x, y) = (i % 256, i / 256);
            match (x, y) {
                (150, 40) => Vec4::new(9000.0, 8000.0, 7000.0, 1.0),
                (30..60, 50..60) => Vec4::new(20.0, 22.0, 25.0, 1.0),
                (_, 0..64) => Vec4::new(0.4, 0.6, 1.0, 1.0) * (1.0 + y as f32 / 64.0),
                _ => Vec4::new(0.2, 0.15, 0.1, 1.0),
            }
        })
        .collect();
    let k = f64::from(synth.capture.radius_mm / synth.capture.distance_mm);
    for (name, texels) in [("constant", &constant), ("real", &real)] {
        let mut expected = DVec3::ZERO;
        for (i, texel) in texels.iter().enumerate() {
            let at = UVec2::new(i as u32 % 256, i as u32 / 256);
            // The cone is small beside the map: its share is taken from the middle of the map.
            let area = f64::from(texel_solid_angle_sr(at.y, size));
            expected += texel.truncate().as_dvec3() * area;
        }
        let ahead = texels[64 * 256 + 128].truncate() + texels[63 * 256 + 128].truncate();
        let cone = 2.0 * PI * (1.0 - (1.0 - k * k).sqrt());
        expected -= ahead.as_dvec3() * 0.5 * cone;
        let frame = film(&synth, size, texels, 1);
        let ratio = ball_flux(&synth, &frame) / expected;
        let off = (ratio - 1.0).abs().max_element();
        assert!(off < 5e-3, "{name}: {ratio}");
        // A hundredth more is not taken for it.
        assert!(!((ratio * 1.01 - 1.0).abs().max_element() < 5e-3));
    }
}

/// What is above in the world is above in the picture; the ball's right shows what lies to the camera's right.
#[test]
fn the_picture_is_a_mirror_s() {
    let synth = plain([240, 170]);
    let texels: Vec<Vec4> = (0..MAP.x * MAP.y)
        .map(|i| {
            let d = texel_direction(UVec2::new(i % MAP.x, i / MAP.x), MAP);
            (d * 0.5 + 0.5).extend(1.0)
        })
        .collect();
    let frame = film(&synth, MAP, &texels, 1);
    let direction = |x: f64, y: f64| {
        let p = dvec2(120.0, 85.0) + dvec2(x, y) * frame.truth.radius_px;
        let value = frame.pixels[p.y as usize * 240 + p.x as usize];
        value.truncate() * 2.0 - 1.0
    };
    assert!(direction(0.0, 0.0).x < -0.98);
    assert!(direction(0.7, 0.0).y < -0.98);
    assert!(direction(-0.7, 0.0).y > 0.98);
    assert!(direction(0.0, -0.7).z > 0.98);
    assert!(direction(0.0, 0.7).z < -0.98);
    // Beside the ball is what lies behind it.
    assert!(direction(1.4, 0.0).x > 0.98);
}

/// Direction of the mean of a lat-long map's light above a level.
fn centroid(texels: &[Vec4], size: UVec2) -> DVec3 {
    let mut sum = DVec3::ZERO;
    for (i, texel) in texels.iter().enumerate() {
        let at = UVec2::new(i as u32 % size.x, i as u32 / size.x);
        let light = f64::from((texel.x - 1.0).max(0.0) * texel_solid_angle_sr(at.y, size));
        sum += texel_direction(at, size).as_dvec3() * light;
    }
    sum.normalize()
}

#[test]
fn a_moved_probe_sees_a_near_lamp_under_another_angle() {
    for shape in [Shape::Infinite, Shape::Sphere, Shape::Box] {
        let mut synth = plain([24, 17]);
        synth.stage.shape = shape;
        synth.stage.size_m = [8.0, 8.0, 8.0];
        synth.stage.to_m = [0.3, 1.0, -0.5];
        synth.lamps = vec![Lamp {
            azimuth_deg: 130.0,
            elevation_deg: 20.0,
            radius_deg: 1.5,
            radiance: [1000.0; 3],
            flicker: 0.0,
            ..Lamp::default()
        }];
        let grey = (UVec2::new(512, 256), vec![Vec4::splat(0.1); 512 * 256]);
        let filming = Filming::new(synth.clone(), Some(grey), None);
        let size = UVec2::new(512, 256);
        let seen = |frame: u32| {
            let world = filming.world(frame);
            let map = filming.truth_map(&Processor::Cpu, &world, frame, size);
            centroid(&map.expect("the CPU films"), size)
        };
        let (sin_a, cos_a) = 130_f64.to_radians().sin_cos();
        let (sin_e, cos_e) = 20_f64.to_radians().sin_cos();
        let lamp = dvec3(cos_e * cos_a, cos_e * sin_a, sin_e);
        assert!(seen(1).angle_between(lamp) < 2e-3);
        let place = match shape {
            Shape::Infinite => lamp * 1e9,
            Shape::Sphere => lamp * 4.0,
            Shape::Box => lamp * (4.0 / lamp.abs().max_element()),
        };
        let expected = (place - dvec3(0.3, 1.0, -0.5)).normalize();
        let off = seen(24).angle_between(expected);
        // A disc on a slanted wall is seen a little nearer on one side.
        assert!(off < 5e-3, "{shape:?}: {off}");
        if shape != Shape::Infinite {
            assert!(!(seen(24).angle_between(lamp) < 5e-3));
        }
    }
}

/// Mean and standard error of what the sensor makes of a radiance.
fn exposed(filming: &Filming, radiance: f32) -> (f64, f64) {
    let sensor = filming.sensor(2);
    let values = vec![Vec4::splat(radiance); 1];
    let n = 20_000;
    let draw = |i: u32| {
        let sensor = glimt_render_gpu::kernels::sensor::SensorParams { frame: i, ..sensor };
        f64::from(expose(0, &sensor, &values).x)
    };
    let draws: Vec<f64> = (0..n).map(draw).collect();
    let mean = draws.iter().sum::<f64>() / f64::from(n);
    let variance = draws.iter().map(|d| (d - mean).powi(2)).sum::<f64>() / f64::from(n - 1);
    (mean, (variance / f64::from(n)).sqrt())
}

#[test]
fn the_sensor_is_unbiased_over_24_stops_and_clips_above() {
    let mut synth = plain([24, 17]);
    synth.noise = glimt::synth::Noise {
        clip_radiance: Some(1000.0),
        ..Default::default()
    };
    let filming = Filming::new(synth, Some((UVec2::ONE, vec![Vec4::ONE])), None);
    for stop in 1..=24 {
        let radiance = 900.0 * 0.5_f32.powi(stop);
        let (mean, error) = exposed(&filming, radiance);
        let truth = f64::from(radiance);
        // f32 sums and codes of 14 bits leave 10⁻⁶.
        let off = (mean - truth).abs() - 2e-6 * truth;
        assert!(off < 4.5 * error, "{stop}: {mean} is not {truth} ± {error}");
        assert!(
            error > 0.0 && error * 141.0 < 0.03 * truth,
            "{stop}: {error}"
        );
        // A hundredth more is not taken for it.
        assert!(!((mean - 1.01 * truth).abs() < 4.5 * error), "{stop}");
    }
    let (mean, error) = exposed(&filming, 4000.0);
    assert!(
        (mean - 1000.0).abs() < 1.0 && error < 1e-6,
        "{mean} ± {error}"
    );
    let (mean, _) = exposed(&filming, 0.0);
    assert!((0.0..1e-5).contains(&mean), "{mean}");
}

#[test]
fn the_ideal_probe_keeps_the_map_s_energy() {
    let synth = plain([24, 17]);
    let texels = noisy_map();
    let filming = Filming::new(synth, Some((MAP, texels.clone())), None);
    let size = UVec2::new(128, 64);
    let map = filming.truth_map(&Processor::Cpu, &filming.world(1), 1, size);
    let map = map.expect("the CPU films");
    let flux = |texels: &[Vec4], size: UVec2| -> DVec3 {
        let rows = texels.chunks(size.x as usize).enumerate();
        rows.map(|(row, texels)| {
            let sum: DVec3 = texels.iter().map(|t| t.truncate().as_dvec3()).sum();
            sum * f64::from(texel_solid_angle_sr(row as u32, size))
        })
        .sum()
    };
    let ratio = flux(&map, size) / flux(&texels, MAP);
    assert!((ratio - 1.0).abs().max_element() < 2e-3, "{ratio}");
}

#[test]
fn frames_come_out_the_same_alone_and_differ_by_seed() {
    let mut synth = plain([60, 42]);
    synth.noise.exposures = 8;
    synth.capture.jitter_px = 1.0;
    let texels = noisy_map();
    let first = film(&synth, MAP, &texels, 5);
    assert_eq!(first.pixels, film(&synth, MAP, &texels, 5).pixels);
    assert_ne!(first.pixels, film(&synth, MAP, &texels, 6).pixels);
    synth.seed = 2;
    assert_ne!(first.pixels, film(&synth, MAP, &texels, 5).pixels);
}

/// Centre, radius and roll of the truth, put into the mapping that unwraps, show what the film shows.
#[test]
fn the_truth_unwraps_the_frame() {
    let mut synth = plain([480, 340]);
    synth.capture.jitter_px = 4.0;
    synth.capture.jitter_roll_deg = 3.0;
    // Directions as colours: smooth, so that a pixel is its middle.
    let size = UVec2::new(512, 256);
    let texels: Vec<Vec4> = (0..512 * 256)
        .map(|i| {
            let d = texel_direction(UVec2::new(i % 512, i / 512), size);
            (d + 2.0).extend(1.0)
        })
        .collect();
    let k = synth.capture.radius_mm / synth.capture.distance_mm;
    for frame in 1..=3 {
        let filmed = film(&synth, size, &texels, frame);
        let worst = |roll_deg: f64| {
            let ball =
                MirrorBall::new(Vec3::X, Vec3::Z, k).image_turned(cos_sin_degrees(roll_deg as f32));
            let centre = DVec2::from(filmed.truth.centre_px).as_vec2();
            let mut worst: f32 = 0.0;
            for (i, value) in filmed.pixels.iter().enumerate() {
                let at = UVec2::new(i as u32 % 480, i as u32 / 480).as_vec2() + 0.5;
                let p = pixel_to_image(at, centre, filmed.truth.radius_px as f32);
                if p.length() < 0.8 {
                    let d = ball.image_to_direction(p).expect("a point on the ball");
                    // The map holds no direction nearer to a pole than its first row.
                    if d.z.abs() > 0.995 {
                        continue;
                    }
                    let seen = value.truncate() - 2.0;
                    worst = worst.max((seen - d).length());
                }
            }
            worst
        };
        let truth = filmed.truth.roll_deg;
        assert!(worst(truth) < 2.5e-3, "{frame}: {}", worst(truth));
        assert!(!(worst(truth + 0.3) < 2.5e-3), "{frame}");
        assert!(!(worst(-truth) < 2.5e-3), "{frame}");
    }
}

#[test]
fn the_gpu_films_what_the_cpu_films() {
    let Some(gpu) = adapter_or_skip("the_gpu_films_what_the_cpu_films") else {
        return;
    };
    let gpu = Processor::Gpu(std::sync::Arc::new(gpu));
    let mut synth = plain([96, 68]);
    synth.capture.jitter_px = 1.0;
    synth.ball.fresnel = true;
    synth.ball.tint = [0.7, 0.6, 0.5];
    synth.rig.on = true;
    synth.stage.shape = Shape::Box;
    synth.stage.size_m = [9.0, 8.0, 7.0];
    synth.occluder.radius_m = 0.4;
    synth.plate.size = [40, 30];
    let texels = noisy_map();
    for exposures in [0, 8] {
        synth.noise.exposures = exposures;
        let filming = Filming::new(synth.clone(), Some((MAP, texels.clone())), None);
        let world = filming.world(12);
        let film = |processor: &Processor| {
            let ball = filming.film_frame(processor, &world, 12).expect("a frame");
            let plate = filming.film_plate(processor, &world, 12).expect("a plate");
            let size = UVec2::new(32, 16);
            let map = filming
                .truth_map(processor, &world, 12, size)
                .expect("a map");
            [ball.pixels, plate.linear, map].concat()
        };
        let (a, b) = (film(&Processor::Cpu), film(&gpu));
        // A ray that grazes something may fall on its other side, and a count of electrons one code off.
        let different = |b: &[Vec4]| {
            let pairs = a.iter().zip(b);
            let far = pairs.filter(|(a, b)| !((**a - **b).abs().max_element() <= 2e-4));
            far.count() as f64 / a.len() as f64
        };
        let share = different(&b);
        assert!(share < 0.005, "{exposures}: {share}");
        let brighter: Vec<Vec4> = b.iter().map(|p| *p * 1.01).collect();
        assert!(!(different(&brighter) < 0.005));
    }
}
