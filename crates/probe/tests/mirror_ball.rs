//! Host file: the mirror ball, against geometry in f64.

use std::f64::consts::{PI, TAU};

use glam::{DVec2, DVec3, Vec2, Vec3};
use glimt_probe::mirror_ball::MirrorBall;
use glimt_sampling::{UniformSource, Xoshiro128PlusPlus, unit_vec2, warp};
use glimt_statistics::mirror_ball;
use glimt_statistics::stats::within;

/// r/D: orthographic, 25, 40 and 50 mm at 1250 mm, and much nearer.
const RATIOS: [f32; 7] = [0.0, 0.02, 0.032, 0.04, 0.2, 0.5, 0.9];

fn axes() -> Vec<(Vec3, Vec3)> {
    vec![
        (Vec3::X, Vec3::Z),
        (Vec3::NEG_Y, Vec3::Z),
        (Vec3::new(0.3, -0.8, -0.5), Vec3::Z),
        (Vec3::Z, Vec3::X),
    ]
}

fn points(count: u32, seed: u32) -> impl Iterator<Item = Vec2> {
    let mut source = Xoshiro128PlusPlus::stream(seed, 1, 2);
    (0..count).map(move |_| warp::sample_concentric_disk(unit_vec2(source.next_uvec2())))
}

/// The direction that the image point `p` shows.
fn reflected(ball: &MirrorBall, p: DVec2) -> Option<DVec3> {
    let axes = [ball.forward, ball.right, ball.up].map(|v| v.as_dvec3());
    mirror_ball::reflected(axes, f64::from(ball.radius_over_distance), p)
}

#[test]
fn image_points_show_what_a_ray_meets() {
    for ratio in RATIOS {
        for (forward, up) in axes() {
            let ball = MirrorBall::new(forward, up, ratio);
            for p in points(2000, 1) {
                let (Some(d), Some(truth)) =
                    (ball.image_to_direction(p), reflected(&ball, p.as_dvec2()))
                else {
                    continue;
                };
                // Near the rim a rounding of p turns the ray by its square root.
                let tolerance = 2e-6 + 6e-7 / f64::from((1.0 - p.length()).max(1e-7)).sqrt();
                within((d.as_dvec3() - truth).length(), 0.0, tolerance)
                    .unwrap_or_else(|e| panic!("{ratio} {p}: {e:?}"));
                let normal = ball.reflect(p).unwrap().normal;
                assert!((normal.length() - 1.0).abs() < 1e-5);
            }
        }
    }
}

#[test]
fn directions_come_back() {
    let mut source = Xoshiro128PlusPlus::stream(3, 1, 4);
    for ratio in RATIOS {
        for (forward, up) in axes() {
            let ball = MirrorBall::new(forward, up, ratio);
            let mut worst = 0.0f32;
            for _ in 0..5000 {
                let d = warp::sample_uniform_sphere(unit_vec2(source.next_uvec2())).direction;
                let Some(p) = ball.direction_to_image(d) else {
                    assert!(ball.is_hidden(d));
                    continue;
                };
                assert!(p.length() <= 1.000_001, "{ratio} {d}: {p}");
                let back = ball.image_to_direction(p * 0.999_999_9).unwrap();
                let rim = (1.0 - p.length()).max(1e-7);
                worst = worst.max((back - d).length() * rim.sqrt());
            }
            assert!(worst < 2e-6, "{ratio}: {worst}");
            for p in points(5000, 5) {
                let Some(d) = ball.image_to_direction(p) else {
                    continue;
                };
                // Rounding of the direction may put a point of the last ring into the hidden cone.
                let Some(back) = ball.direction_to_image(d.normalize()) else {
                    assert!(p.length() > 0.999, "{ratio} {p}");
                    continue;
                };
                assert!((back - p).length() < 3e-6, "{ratio} {p}: {back}");
            }
        }
    }
}

/// The middle looks back, up is up, right is right; and what is right of the camera is seen on the right.
#[test]
fn a_mirror_shows_left_on_the_left() {
    let ball = MirrorBall::new(Vec3::X, Vec3::Z, 0.04);
    assert_eq!(ball.right, Vec3::NEG_Y);
    let right = ball.direction_to_image(Vec3::NEG_Y).unwrap();
    assert!(right.x > 0.7 && right.y.abs() < 1e-6);
    let above = ball.direction_to_image(Vec3::Z).unwrap();
    assert!(above.y < -0.7 && above.x.abs() < 1e-6);
}

#[test]
fn exactly_the_cone_is_hidden() {
    for ratio in RATIOS.into_iter().filter(|k| *k > 0.0) {
        let ball = MirrorBall::new(Vec3::Y, Vec3::Z, ratio);
        within(
            f64::from(ball.hidden_half_angle()),
            f64::from(ratio).asin(),
            1e-6,
        )
        .unwrap();
        for (factor, hidden) in [(0.98f32, true), (1.02, false)] {
            let angle = ball.hidden_half_angle() * factor;
            let d = ball.forward * angle.cos() + ball.right * angle.sin();
            assert_eq!(ball.direction_to_image(d).is_none(), hidden);
            assert_eq!(ball.is_hidden(d), hidden);
        }
    }
}

#[test]
fn solid_angles_sum_to_what_is_seen() {
    for ratio in RATIOS {
        let ball = MirrorBall::new(Vec3::X, Vec3::Z, ratio);
        // Equal rings in the angle of incidence, in which the density has no pole.
        let rings = 20_000;
        let k = f64::from(ratio);
        let s = |i: f64| i.sin() * ((1.0 - k * k) / (1.0 - (k * i.sin()).powi(2))).sqrt();
        let mut sum = 0.0;
        for ring in 0..rings {
            let [a, m, b] =
                [0.0, 0.5, 1.0].map(|t| s(PI / 2.0 * (f64::from(ring) + t) / f64::from(rings)));
            let density = ball.solid_angle_sr_per_area(Vec2::new(m as f32, 0.0));
            sum += f64::from(density) * PI * (b * b - a * a);
        }
        let seen = TAU * (1.0 + (1.0 - k * k).sqrt());
        within(sum / seen, 1.0, 2e-3).unwrap_or_else(|e| panic!("{ratio}: {e:?}"));
        // And a pixel in particular: the solid angle between the directions of its corners.
        for p in [
            Vec2::new(0.2, 0.1),
            Vec2::new(-0.5, 0.6),
            Vec2::new(0.1, -0.9),
        ] {
            let h = 1e-3;
            let [a, b, c] = [(0.0, 0.0), (h, 0.0), (0.0, h)]
                .map(|(x, y)| reflected(&ball, p.as_dvec2() + DVec2::new(x, y)).unwrap());
            let area = (b - a).cross(c - a).length() / (h * h);
            let density = ball.solid_angle_sr_per_area(p + Vec2::splat(h as f32 / 3.0));
            within(f64::from(density) / area, 1.0, 5e-3)
                .unwrap_or_else(|e| panic!("{ratio} {p}: {e:?}"));
        }
    }
}
