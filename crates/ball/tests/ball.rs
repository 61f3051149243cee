//! Host file: the mirror ball is found, followed and its roll measured, on drawn films and on two photographs.

mod ball_scene;

use ball_scene::{Random, Scene, World};
use glam::{DVec2, DVec3, UVec2, Vec4};
use glimt_ball::levels::Levels;
use glimt_ball::roll::{Reference, Roll};
use glimt_ball::{
    Circle, FindError, Found, Observation, Options, Quantity, Side, State, TrackError, Tracker,
    TrackerOptions, find, stabilise,
};
use std::path::Path;

const SMALL: UVec2 = UVec2::new(640, 450);

fn circle(x: f64, y: f64, radius: f64) -> Circle {
    Circle {
        centre: DVec2::new(x, y),
        radius,
    }
}

/// Root mean squares of the errors in x, y and radius, and how many were found.
fn errors(list: &[(Circle, Result<Found, FindError>)]) -> (DVec3, usize) {
    let mut sum = DVec3::ZERO;
    let mut count = 0;
    for (truth, found) in list {
        if let Ok(found) = found {
            let e = (found.circle.centre - truth.centre).extend(found.circle.radius - truth.radius);
            sum += e * e;
            count += 1;
        }
    }
    let mean = sum / f64::from(count).max(1.0);
    (
        DVec3::new(mean.x.sqrt(), mean.y.sqrt(), mean.z.sqrt()),
        count as usize,
    )
}

/// Whether all were found with errors below `limit`.
fn accurate(list: &[(Circle, Result<Found, FindError>)], limit: f64) -> bool {
    let (rms, count) = errors(list);
    count == list.len() && rms.max_element() < limit
}

/// Poses that were drawn after the finder was tuned.
fn film(
    seed: u64,
    count: usize,
    size: UVec2,
    radius: f64,
) -> Vec<(Circle, Result<Found, FindError>)> {
    let mut random = Random(seed);
    (0..count)
        .map(|_| {
            let world = World::drawn(random.bits());
            let centre = size.as_dvec2() * 0.5 + random.gauss2() * 5.0;
            let truth = circle(centre.x, centre.y, radius + random.between(-3.0, 3.0));
            let mut scene = Scene::new(&world, size, truth);
            scene.azimuth = random.between(0.0, 6.0);
            scene.roll = 0.02 * random.gauss();
            scene.blur = random.between(0.0, 0.6);
            scene.noise = random.between(0.005, 0.02);
            scene.samples = 2;
            scene.seed = random.bits();
            let found = find(size, &scene.film(), None);
            println!("{truth}: {found:?}");
            (truth, found)
        })
        .collect()
}

#[test]
fn centre_and_radius_to_a_quarter_of_a_pixel() {
    let list = film(0x00ba_1102, 5, UVec2::new(1200, 850), 400.0);
    let (rms, _) = errors(&list);
    println!("RMS of x, y, radius: {rms:.3}");
    assert!(accurate(&list, 0.25), "{rms}");
    // The comparator fails on a circle that is off by half a pixel.
    for off in [DVec3::X, DVec3::Y, DVec3::Z].map(|axis| 0.6 * axis) {
        let mut wrong = list.clone();
        for (truth, _) in &mut wrong {
            truth.centre += off.truncate();
            truth.radius += off.z;
        }
        assert!(!accurate(&wrong, 0.25));
    }
}

#[test]
fn a_hint_gives_what_the_whole_search_gives() {
    let world = World::drawn(3);
    let truth = circle(322.3, 221.4, 198.2);
    let image = Scene::new(&world, SMALL, truth).film();
    let whole = find(SMALL, &image, None).expect("a ball");
    let hint = circle(327.0, 218.0, 199.0);
    let hinted = find(SMALL, &image, Some(hint)).expect("a ball");
    assert!(hinted.circle.centre.distance(whole.circle.centre) < 0.2);
    assert!((hinted.circle.radius - whole.circle.radius).abs() < 0.2);
    // A hint that is wrong does no harm.
    let lost = find(SMALL, &image, Some(circle(100.0, 90.0, 60.0))).expect("a ball");
    assert!(lost.circle.centre.distance(whole.circle.centre) < 0.01);
}

#[test]
fn mount_clipped_lamps_and_busy_background() {
    let world = World::drawn(8);
    let truth = circle(318.7, 224.1, 196.6);
    let mut scene = Scene::new(&world, SMALL, truth);
    scene.mount = true;
    scene.clip = 2.0;
    scene.busy = 20.0;
    let found = find(SMALL, &scene.film(), None).expect("a ball");
    println!("{found:?}");
    assert!(
        found.circle.centre.distance(truth.centre) < 1.0,
        "{found:?}"
    );
    assert!(
        (found.circle.radius - truth.radius).abs() < 1.0,
        "{found:?}"
    );
    assert!(found.visible_fraction < 1.0);
}

#[test]
fn what_is_no_single_ball_is_an_error() {
    let plain = vec![Vec4::splat(0.3); 640 * 450];
    assert_eq!(
        find(SMALL, &plain, None),
        Err(FindError::NoBall { best: None })
    );
    let black = vec![Vec4::ZERO; 640 * 450];
    assert_eq!(
        find(SMALL, &black, None),
        Err(FindError::NoBall { best: None })
    );
    let broken = vec![Vec4::splat(f32::NAN); 640 * 450];
    assert!(matches!(
        find(SMALL, &broken, None),
        Err(FindError::NoBall { .. })
    ));
    assert!(matches!(
        find(SMALL, &plain[1..], None),
        Err(FindError::Size { .. })
    ));
    let tiny = UVec2::new(40, 40);
    assert_eq!(
        find(tiny, &plain[..1600], None),
        Err(FindError::ImageTooSmall(tiny))
    );
    let mut random = Random(77);
    let noise: Vec<Vec4> = (0..640 * 450)
        .map(|_| Vec4::splat(random.uniform() as f32))
        .collect();
    assert!(matches!(
        find(SMALL, &noise, None),
        Err(FindError::NoBall { .. })
    ));

    let world = World::drawn(8);
    // A ball far outside: the picture is the background alone.
    let mut none = Scene::new(&world, SMALL, circle(-900.0, 225.0, 200.0));
    none.busy = 8.0;
    let found = find(SMALL, &none.film(), None);
    assert!(matches!(found, Err(FindError::NoBall { .. })), "{found:?}");

    let cut = Scene::new(&world, SMALL, circle(120.0, 226.0, 190.0)).film();
    let error = find(SMALL, &cut, None).expect_err("cut");
    println!("{error}");
    assert!(
        matches!(&error, FindError::Cut { sides, .. } if sides == &[Side::Left]),
        "{error}"
    );

    let mut two = Scene::new(&world, SMALL, circle(170.0, 220.0, 120.0));
    two.second = Some(circle(460.0, 230.0, 130.0));
    let error = find(SMALL, &two.film(), None).expect_err("two");
    println!("{error}");
    assert!(matches!(error, FindError::Two(..)), "{error}");
}

#[test]
fn roll_to_a_fiftieth_of_a_degree_while_the_light_changes() {
    let mut world = World::drawn(21);
    let truth = circle(320.4, 224.8, 199.3);
    let mut random = Random(5);
    let first = Scene::new(&world, SMALL, truth).film();
    let reference = Reference::new(SMALL, &first, truth).expect("texture");
    let mut squares = 0.0;
    for k in 0..6 {
        if let World::Drawn(drawn) = &mut world {
            drawn.sun = random.direction();
            drawn.lamp_gain = [1.0, 0.1, 3.0][k % 3];
        }
        let roll = 0.1_f64.to_radians() * random.gauss();
        let there = circle(320.4 + random.gauss(), 224.8 + random.gauss(), 199.3);
        let mut scene = Scene::new(&world, SMALL, there);
        scene.roll = roll;
        scene.seed = 100 + k as u64;
        scene.exposure = 1.0 + 0.2 * k as f64;
        // The centre is not known exactly either.
        let measured = circle(there.centre.x + 0.2, there.centre.y - 0.2, 199.3);
        let got = reference
            .roll(SMALL, &scene.film(), measured)
            .expect("a roll");
        let off = (got.radians - roll).to_degrees();
        println!("roll {:.4}° off {off:.4}° {got:?}", roll.to_degrees());
        squares += off * off;
    }
    let rms = (squares / 6.0_f64).sqrt();
    println!("RMS of the roll: {rms:.4}°");
    assert!(rms < 0.02, "{rms}");

    // A large one, and something without texture.
    let mut scene = Scene::new(&world, SMALL, truth);
    scene.roll = 0.4;
    let got = reference.roll(SMALL, &scene.film(), truth).expect("a roll");
    assert!((got.radians - 0.4).abs() < 1e-3, "{got:?}");
    let plain = World::Plain(DVec3::ONE);
    let mut scene = Scene::new(&plain, SMALL, truth);
    scene.noise = 0.0;
    assert_eq!(reference.roll(SMALL, &scene.film(), truth), None);
}

fn observation(frame: i32, x: f64, y: f64, radius: f64, roll: f64) -> Observation {
    Observation {
        frame,
        found: Ok(Found {
            circle: circle(x, y, radius),
            confidence: 0.9,
            sigma_px: 0.1,
            sigma_radius_px: 0.1,
            visible_fraction: 0.9,
            blur_px: 0.5,
        }),
        roll: Some(Roll {
            radians: roll,
            sigma: 1e-4,
            confidence: 0.9,
        }),
        levels: None,
    }
}

fn shot(drift: f64) -> Vec<Observation> {
    let mut random = Random(9);
    (1..=100)
        .map(|frame| {
            let c = DVec2::new(1200.0, 850.0) + random.gauss2() * 5.0;
            let along = drift * f64::from(frame) / 99.0;
            let radius = 800.0 + 0.1 * random.gauss() + along;
            observation(
                frame,
                c.x,
                c.y,
                radius,
                0.001 * random.gauss() + 0.004 * along,
            )
        })
        .collect()
}

#[test]
fn jitter_is_kept_and_the_radius_is_one() {
    let list = shot(0.0);
    let tracked = stabilise(&list, &Options::default()).expect("poses");
    assert!((tracked.radius - 800.0).abs() < 4.0 * tracked.radius_sigma);
    assert!(tracked.radius_sigma < 0.03);
    assert!(tracked.notes.is_empty(), "{:?}", tracked.notes);
    for (pose, seen) in tracked.poses.iter().zip(&list) {
        assert_eq!(
            pose.centre,
            seen.found.as_ref().expect("found").circle.centre
        );
        assert_eq!(pose.radius, tracked.radius);
        assert_eq!(pose.state, State::Measured);
    }
}

#[test]
fn a_drift_is_said() {
    let tracked = stabilise(&shot(1.0), &Options::default()).expect("poses");
    let said = |q: Quantity| tracked.significant.iter().find(|d| d.quantity == q);
    let radius = said(Quantity::Radius).expect("a drift of the radius");
    assert!(
        (radius.total - 1.0).abs() < 4.0 * radius.sigma,
        "{radius:?}"
    );
    let roll = said(Quantity::Roll).expect("a drift of the roll");
    assert!((roll.total - 0.004).abs() < 4.0 * roll.sigma, "{roll:?}");
    assert!(said(Quantity::CentreX).is_none());
    assert!(
        tracked
            .notes
            .iter()
            .any(|n| n.contains("radius drifts by +"))
    );
    assert!(tracked.poses[99].radius - tracked.poses[0].radius > 0.8);
}

#[test]
fn lost_frames_are_interpolated_and_wrong_ones_rejected() {
    let mut list = shot(0.0);
    for i in [0, 40, 41, 42] {
        list[i].found = Err(FindError::NoBall { best: None });
    }
    list[70] = observation(71, 300.0, 200.0, 180.0, 0.0);
    let tracked = stabilise(&list, &Options::default()).expect("poses");
    assert_eq!(tracked.lost, [1, 41, 42, 43]);
    assert_eq!(tracked.rejected, [71]);
    let poses = &tracked.poses;
    assert_eq!(poses[0].centre, poses[1].centre);
    let middle = 0.5 * (poses[39].centre + poses[43].centre);
    assert!(poses[41].centre.distance(middle) < 1e-9);
    assert!(poses[70].centre.distance(DVec2::new(1200.0, 850.0)) < 20.0);
    assert!(
        tracked.notes[0].contains("frames 1, 41-43"),
        "{:?}",
        tracked.notes
    );
    assert!(tracked.notes[1].contains("frame 71"), "{:?}", tracked.notes);

    for o in &mut list[5..] {
        o.found = Err(FindError::NoBall { best: None });
    }
    let error = stabilise(&list, &Options::default()).expect_err("too few");
    assert!(
        matches!(
            error,
            TrackError::Lost {
                found: 4,
                of: 100,
                ..
            }
        ),
        "{error}"
    );
    let twice = [list[1].clone(), list[1].clone()];
    assert_eq!(
        stabilise(&twice, &Options::default()),
        Err(TrackError::Order(2))
    );
}

#[test]
fn frames_of_another_exposure_are_named() {
    let world = World::drawn(4);
    let truth = circle(160.0, 113.0, 100.0);
    let size = UVec2::new(320, 226);
    let list: Vec<Observation> = (1..=9_i32)
        .map(|frame| {
            let mut scene = Scene::new(&world, size, truth);
            scene.seed = frame as u64;
            scene.exposure = if (4..=5).contains(&frame) { 0.5 } else { 1.0 };
            let mut o = observation(frame, 160.0, 113.0, 100.0, 0.0);
            o.levels = Some(Levels::new(size, &scene.film(), truth));
            o
        })
        .collect();
    let tracked = stabilise(&list, &Options::default()).expect("poses");
    assert_eq!(tracked.exposure_jumps.len(), 1);
    let jump = tracked.exposure_jumps[0];
    assert_eq!((jump.first, jump.last), (4, 5));
    assert!((jump.factor - 0.5).abs() < 0.02, "{jump:?}");
    assert!(tracked.notes[0].contains("frames 4-5 of another exposure"));
}

#[test]
fn a_live_tracker_follows() {
    let world = World::drawn(31);
    let mut random = Random(12);
    let mut tracker = Tracker::new(TrackerOptions::default());
    let black = vec![Vec4::ZERO; 640 * 450];
    assert!(tracker.push(0, SMALL, &black).is_err());
    for frame in 1..=6 {
        let c = SMALL.as_dvec2() * 0.5 + random.gauss2() * 3.0;
        let mut scene = Scene::new(&world, SMALL, circle(c.x, c.y, 200.0));
        scene.roll = 0.002 * f64::from(frame - 1);
        scene.seed = frame as u64;
        let pose = tracker.push(frame, SMALL, &scene.film()).expect("a pose");
        println!("true {c} roll {} {pose:?}", scene.roll);
        assert_eq!(pose.state, State::Measured);
        assert!(pose.centre.distance(c) < 0.7, "{pose:?} {c}");
        assert!((pose.roll - scene.roll).abs() < 5e-4, "{pose:?}");
    }
    let held = tracker.push(7, SMALL, &black).expect("a pose");
    assert_eq!(held.state, State::Interpolated);
}

#[test]
fn two_photographs() {
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/data");
    if !data.is_dir() {
        println!("skipped: {} is not there", data.display());
        return;
    }
    // Looked at with the circle drawn over them.
    let truths = [
        ("room", circle(2042.7, 2051.0, 1980.0)),
        ("lamp", circle(2061.4, 2065.0, 1914.3)),
    ];
    for (name, truth) in truths {
        let file = data.join(format!("mirrorball_ldr/{name}.jpg"));
        let photo = image::open(&file).expect("a photograph").to_rgb8();
        let linear = |c: u8| {
            let c = f32::from(c) / 255.0;
            if c <= 0.04045 {
                c / 12.92
            } else {
                ((c + 0.055) / 1.055).powf(2.4)
            }
        };
        let pixels: Vec<Vec4> = photo
            .pixels()
            .map(|p| Vec4::new(linear(p[0]), linear(p[1]), linear(p[2]), 1.0))
            .collect();
        let size = UVec2::new(photo.width(), photo.height());
        let found = find(size, &pixels, None).expect("a ball");
        println!("{name}: {found:?}");
        assert!(
            found.circle.centre.distance(truth.centre) < 3.0,
            "{found:?}"
        );
        assert!(
            (found.circle.radius - truth.radius).abs() < 3.0,
            "{found:?}"
        );
        assert!(found.visible_fraction < 0.95);
    }
}
