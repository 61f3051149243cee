//! Host file: the mappings of `glimt-probe`.

use std::f64::consts::{PI, TAU};

use glam::{UVec2, Vec2, Vec3};
use glimt_probe::{angular, latlong, rotate, trig};
use glimt_sampling::{UniformSource, Xoshiro128PlusPlus, unit_f32, unit_vec2, warp};
use glimt_statistics::quadrature::{Direction, integrate_patch};
use glimt_statistics::stats::{SphereBins, chi_square, kolmogorov_smirnov, sidak, within};

const SIZES: [UVec2; 9] = [
    UVec2::new(1, 1),
    UVec2::new(3, 2),
    UVec2::new(2, 3),
    UVec2::new(64, 32),
    UVec2::new(101, 50),
    UVec2::new(1628, 814),
    UVec2::new(2048, 1024),
    UVec2::new(4096, 4097),
    UVec2::new(16_384, 8192),
];

fn random_direction(source: &mut Xoshiro128PlusPlus) -> Vec3 {
    warp::sample_uniform_sphere(unit_vec2(source.next_uvec2())).direction
}

fn to_f64(d: Vec3) -> Direction {
    [f64::from(d.x), f64::from(d.y), f64::from(d.z)]
}

/// Directions where a mapping breaks first: axes, both sides of the seam, the neighbourhood of the poles.
fn awkward_directions() -> Vec<Vec3> {
    let mut all = vec![
        Vec3::X,
        Vec3::Y,
        Vec3::Z,
        Vec3::NEG_X,
        Vec3::NEG_Y,
        Vec3::NEG_Z,
        Vec3::new(-1.0, -0.0, 0.0),
        Vec3::new(-1.0, 0.0, -0.0),
    ];
    for tiny in [1e-3f32, 1e-6, 1e-9, 1e-20, 1e-38] {
        for sign in [-1.0, 1.0] {
            all.push(Vec3::new(-1.0, sign * tiny, 0.0));
            all.push(Vec3::new(-0.6, sign * tiny, 0.8));
            all.push(Vec3::new(1.0, sign * tiny, tiny));
            if tiny > 1e-19 {
                all.push(Vec3::new(sign * tiny, tiny, 1.0));
                all.push(Vec3::new(tiny, sign * tiny, -1.0));
            }
        }
    }
    all.into_iter().map(Vec3::normalize).collect()
}

#[test]
fn polynomial_is_precise() {
    let mut worst = 0.0f64;
    for i in -1_000_000..=1_000_000i32 {
        let x = i as f32 * 1e-6;
        let approximate = trig::cos_sin_pi(x);
        // The argument reduced in f64, where π·x near ±1 would lose the sine's digits.
        let exact = PI * f64::from(x);
        let sine = if x.abs() > 0.5 {
            (PI * (1.0 - f64::from(x.abs()))).sin().copysign(exact)
        } else {
            exact.sin()
        };
        let cosine = (PI * (0.5 - f64::from(x.abs()))).sin();
        for (value, truth) in [(approximate.x, cosine), (approximate.y, sine)] {
            let error = (f64::from(value) - truth).abs() / truth.abs().max(1e-30);
            worst = if truth == 0.0 && value == 0.0 {
                worst
            } else {
                worst.max(error)
            };
        }
    }
    println!("largest relative error: {worst:.2e}");
    assert!(worst <= 3e-7);
}

#[test]
fn texel_areas_are_exact() {
    for size in SIZES {
        let mut total = 0.0;
        let (w, h) = (f64::from(size.x), f64::from(size.y));
        for row in 0..size.y {
            let area = f64::from(latlong::texel_solid_angle_sr(row, size));
            // cos θ₀ − cos θ₁ as a product, to keep f64's digits too.
            let middle = PI * (f64::from(row) + 0.5) / h;
            let truth = TAU / w * 2.0 * middle.sin() * (0.5 * PI / h).sin();
            assert!(
                (area - truth).abs() <= 5e-7 * truth,
                "{size}, row {row}: {area} against {truth}"
            );
            assert_eq!(
                latlong::texel_solid_angle_sr(row, size),
                latlong::texel_solid_angle_sr(size.y - 1 - row, size)
            );
            total += w * area;
        }
        within(total, 2.0 * TAU, 1e-6 * 2.0 * TAU).unwrap_or_else(|e| panic!("{size}: {e}"));
    }
}

#[test]
fn row_edges_are_exact_at_poles_and_equator() {
    for height in [1, 2, 3, 4, 1024, 4097, 8192] {
        assert_eq!(latlong::row_cos_theta(0, height), 1.0);
        assert_eq!(latlong::row_cos_theta(height, height), -1.0);
        for edge in 0..=height {
            let z = latlong::row_cos_theta(edge, height);
            let truth = (PI * f64::from(edge) / f64::from(height)).cos();
            assert!((f64::from(z) - truth).abs() <= 2e-7, "{edge} of {height}");
            assert_eq!(z, -latlong::row_cos_theta(height - edge, height));
            if 2 * edge == height {
                assert_eq!(z, 0.0);
            }
        }
    }
}

#[test]
fn the_axes_stand_where_the_convention_says() {
    let axes = [
        (Vec2::new(0.5, 0.5), Vec3::X),
        (Vec2::new(0.25, 0.5), Vec3::Y),
        (Vec2::new(0.0, 0.5), Vec3::NEG_X),
        (Vec2::new(0.75, 0.5), Vec3::NEG_Y),
        (Vec2::new(0.5, 0.0), Vec3::Z),
        (Vec2::new(0.5, 1.0), Vec3::NEG_Z),
    ];
    for (uv, d) in axes {
        assert_eq!(latlong::uv_to_direction(uv), d);
        assert_eq!(latlong::direction_to_uv(d), uv);
    }
    // The right edge is the left edge.
    assert_eq!(latlong::uv_to_direction(Vec2::new(1.0, 0.5)), Vec3::NEG_X);
    assert_eq!(latlong::direction_to_uv(Vec3::ZERO), Vec2::new(0.5, 0.0));
}

#[test]
fn directions_survive_the_round_trip() {
    let mut source = Xoshiro128PlusPlus::stream(1, 0, 0);
    let random = (0..200_000).map(|_| random_direction(&mut source));
    for d in random.chain(awkward_directions()) {
        let uv = latlong::direction_to_uv(d);
        assert!(
            uv.x >= 0.0 && uv.x < 1.0 && uv.y >= 0.0 && uv.y <= 1.0,
            "{d} → {uv}"
        );
        let back = latlong::uv_to_direction(uv);
        assert!((back - d).length() <= 1e-6, "{d} → {uv} → {back}");
        let texel = latlong::direction_to_texel(d, UVec2::new(8192, 4096));
        assert!(texel.x < 8192 && texel.y < 4096);

        let uv = angular::direction_to_uv(d);
        let Some(back) = angular::uv_to_direction(uv) else {
            // Rounding may put the rim itself outside.
            assert!(d.x < -0.999_999, "{d} → {uv} → nowhere");
            continue;
        };
        assert!((back - d).length() <= 2e-6, "{d} → {uv} → {back}");
    }
}

#[test]
fn image_points_survive_the_round_trip() {
    let mut source = Xoshiro128PlusPlus::stream(1, 0, 1);
    for _ in 0..200_000 {
        let uv = unit_vec2(source.next_uvec2());
        let back = latlong::direction_to_uv(latlong::uv_to_direction(uv));
        // A turn of the azimuth moves a direction by less the nearer it is to a pole.
        let across = f64::from((back.x - uv.x).abs());
        let across = across.min(1.0 - across) * (PI * f64::from(uv.y)).sin();
        assert!(
            across <= 3e-7 && (back.y - uv.y).abs() <= 3e-7,
            "{uv} → {back}"
        );
        if let Some(d) = angular::uv_to_direction(uv) {
            let back = angular::direction_to_uv(d);
            // Next to the rim, −x, the direction no longer says which way the axis was left.
            let r = (2.0 * uv - Vec2::ONE).length();
            assert!(
                (back - uv).length() <= 3e-7 + 2e-7 / (1.0 - r).max(1e-7),
                "{uv} → {back}"
            );
        }
    }
}

#[test]
fn texel_centres_fall_into_their_texels() {
    for size in SIZES {
        let (step_x, step_y) = ((size.x / 97).max(1), (size.y / 89).max(1));
        for y in (0..size.y).filter(|y| y % step_y == 0 || *y + 1 == size.y) {
            for x in (0..size.x).filter(|x| x % step_x == 0 || *x + 1 == size.x) {
                let texel = UVec2::new(x, y);
                let d = latlong::texel_direction(texel, size);
                assert_eq!(latlong::direction_to_texel(d, size), texel, "{size}");
            }
        }
    }
}

#[test]
fn directions_in_a_texel_stay_there() {
    let mut source = Xoshiro128PlusPlus::stream(1, 0, 2);
    let last = unit_f32(u32::MAX);
    for size in SIZES {
        // Rounding moves a direction by about 2·10⁻⁷, which is some part of a texel.
        let slack = size.max_element() as f32 * 3e-7;
        for _ in 0..2000 {
            let mut texel = UVec2::new(source.next_u32() % size.x, source.next_u32() % size.y);
            let mut r = unit_vec2(source.next_uvec2());
            match source.next_u32() % 8 {
                0 => texel.y = 0,
                1 => texel.y = size.y - 1,
                2 => texel.x = 0,
                3 => texel.x = size.x - 1,
                4 => r = Vec2::ZERO,
                5 => r = Vec2::splat(last),
                _ => {}
            }
            let d = latlong::direction_in_texel(texel, size, r);
            assert!((d.length() - 1.0).abs() <= 1e-6);
            let place = latlong::direction_to_uv(d) * size.as_vec2() - texel.as_vec2();
            assert!(
                place.y >= -slack && place.y <= 1.0 + slack,
                "{texel} of {size} at {r}: {d}"
            );
            // At the pole itself the azimuth is lost.
            let sin_theta = d.truncate().length();
            let slack = slack + size.x as f32 * 1e-7 / sin_theta.max(1e-30);
            let wraps = place.x.abs() >= size.x as f32 - 1.0 - slack;
            assert!(
                place.x >= -slack && place.x <= 1.0 + slack || wraps || sin_theta == 0.0,
                "{texel} of {size} at {r}: {d}"
            );
        }
    }
}

/// Inside a texel, polar ones of a large map too, directions are uniform in solid angle.
#[test]
fn directions_in_a_texel_are_uniform() {
    const N: usize = 50_000;
    let texels = [
        (UVec2::new(0, 0), UVec2::new(1, 1)),
        (UVec2::new(1, 1), UVec2::new(3, 2)),
        (UVec2::new(5, 0), UVec2::new(16, 8)),
        (UVec2::new(15, 7), UVec2::new(16, 8)),
        (UVec2::new(77, 0), UVec2::new(16_384, 8192)),
        (UVec2::new(12, 8191), UVec2::new(16_384, 8192)),
        (UVec2::new(9000, 1), UVec2::new(16_384, 8192)),
        (UVec2::new(40, 31), UVec2::new(64, 64)),
    ];
    let alpha = sidak(0.01, 3 * texels.len());
    for (k, (texel, size)) in texels.into_iter().enumerate() {
        let mut source = Xoshiro128PlusPlus::stream(2, 0, k as u32);
        let half = 0.5 * PI / f64::from(size.y);
        // sin²(θ/2), from the nearer pole, is uniform between those of the texel's edges.
        let south = 2 * texel.y >= size.y;
        let edges = if south {
            [size.y - texel.y - 1, size.y - texel.y]
        } else {
            [texel.y, texel.y + 1]
        };
        let edges = edges.map(|edge| (half * f64::from(edge)).sin().powi(2));
        let (mut heights, mut azimuths, mut counts) = (Vec::new(), Vec::new(), vec![0u64; 256]);
        for _ in 0..N {
            let r = unit_vec2(source.next_uvec2());
            let d = to_f64(latlong::direction_in_texel(texel, size, r));
            let horizontal = d[0].hypot(d[1]);
            let theta = horizontal.atan2(if south { -d[2] } else { d[2] });
            let height = ((0.5 * theta).sin().powi(2) - edges[0]) / (edges[1] - edges[0]);
            let turns = (PI - d[1].atan2(d[0])) / TAU;
            let azimuth = turns * f64::from(size.x) - f64::from(texel.x);
            let bin = |x: f64| (x * 16.0).clamp(0.0, 15.0) as usize;
            counts[bin(height) * 16 + bin(azimuth)] += 1;
            heights.push(height);
            azimuths.push(azimuth);
        }
        let name = format!("{texel} of {size}");
        kolmogorov_smirnov(&mut heights, |x| x, alpha).unwrap_or_else(|e| panic!("{name}: {e}"));
        kolmogorov_smirnov(&mut azimuths, |x| x, alpha).unwrap_or_else(|e| panic!("{name}: {e}"));
        chi_square(&counts, &vec![N as f64 / 256.0; 256], alpha)
            .unwrap_or_else(|e| panic!("{name}: {e}"));
    }
}

/// Texels drawn by their area, directions uniform inside: uniform over the sphere.
#[test]
fn areas_and_places_make_the_uniform_sphere() {
    let size = UVec2::new(7, 5);
    let mut cumulative = Vec::new();
    let mut total = 0.0;
    for row in 0..size.y {
        total += f64::from(latlong::texel_solid_angle_sr(row, size) * size.x as f32);
        cumulative.push(total);
    }
    let mut source = Xoshiro128PlusPlus::stream(3, 0, 0);
    let samples = (0..400_000).map(|_| {
        let choice = f64::from(source.next_u32()) / 4_294_967_296.0 * total;
        let row = cumulative.iter().position(|edge| choice < *edge).unwrap() as u32;
        let texel = UVec2::new(source.next_u32() % size.x, row);
        let d = latlong::direction_in_texel(texel, size, unit_vec2(source.next_uvec2()));
        Some(to_f64(d))
    });
    let bins = SphereBins {
        rows: 24,
        columns: 48,
    };
    bins.chi_square(samples, |_| 0.25 / PI, 0.01).unwrap();
}

#[test]
fn angular_map_covers_the_sphere() {
    let mut total = 0.0;
    let n = 512;
    for j in 0..n {
        for i in 0..n {
            let uv = Vec2::new(i as f32 + 0.5, j as f32 + 0.5) / n as f32;
            total += f64::from(angular::solid_angle_sr_per_uv(uv)) / f64::from(n * n);
        }
    }
    within(total, 4.0 * PI, 2e-4).unwrap();
    // And locally: the solid angle of a small rectangle of the image is that of its direction's spread.
    let mut source = Xoshiro128PlusPlus::stream(4, 0, 0);
    for _ in 0..1000 {
        let uv = unit_vec2(source.next_uvec2());
        let step = 1e-2;
        let corner = |x: f32, y: f32| angular::uv_to_direction(uv + Vec2::new(x, y) * step);
        let (Some(c), Some(l), Some(r), Some(t), Some(b)) = (
            angular::uv_to_direction(uv),
            corner(-0.5, 0.0),
            corner(0.5, 0.0),
            corner(0.0, -0.5),
            corner(0.0, 0.5),
        ) else {
            continue;
        };
        let area = (r - l).cross(b - t).dot(c) / (step * step);
        let stated = angular::solid_angle_sr_per_uv(uv);
        // Right × down points inwards for one who looks from inside: the picture is not mirrored.
        assert!(
            (area.abs() - stated).abs() <= 2e-3 * 4.0 * std::f32::consts::PI.powi(2),
            "{uv}"
        );
        assert!(area > 0.0, "{uv}: mirrored");
    }
}

/// The lat-long map has the same handedness as the angular one, and a texel's area is the integral over its patch.
#[test]
fn latlong_is_not_mirrored() {
    let size = UVec2::new(16, 8);
    for y in 0..size.y {
        for x in 0..size.x {
            let at = |fx: f32, fy: f32| {
                latlong::uv_to_direction(Vec2::new(x as f32 + fx, y as f32 + fy) / size.as_vec2())
            };
            let (right, down) = (at(0.6, 0.5) - at(0.4, 0.5), at(0.5, 0.6) - at(0.5, 0.4));
            assert!(right.cross(down).dot(at(0.5, 0.5)) > 0.0);
        }
        let z = [y + 1, y].map(|edge| f64::from(latlong::row_cos_theta(edge, size.y)));
        let patch = integrate_patch(|_| 1.0, z, [0.0, TAU / f64::from(size.x)], 1e-12);
        within(
            f64::from(latlong::texel_solid_angle_sr(y, size)),
            patch.value,
            1e-6,
        )
        .unwrap();
    }
}

#[test]
fn turning_is_counter_clockwise_seen_from_above() {
    for degrees in [0.0f32, 30.0, 90.0, -135.0, 360.0, 725.0] {
        let turn = rotate::cos_sin_degrees(degrees);
        let angle = f64::from(degrees).to_radians();
        assert!((f64::from(turn.x) - angle.cos()).abs() <= 1e-6);
        assert!((f64::from(turn.y) - angle.sin()).abs() <= 1e-6);
        let d = Vec3::new(0.48, 0.6, 0.64);
        let turned = rotate::rotate_z(d, turn);
        assert!((turned.length() - 1.0).abs() <= 1e-6 && turned.z == d.z);
        assert!((rotate::rotate_z(turned, turn * Vec2::new(1.0, -1.0)) - d).length() <= 1e-6);
        // In the image what turns counter-clockwise moves to the left.
        let moved = latlong::direction_to_uv(d).x - latlong::direction_to_uv(turned).x;
        let lap = f64::from(moved) - f64::from(degrees) / 360.0;
        assert!((lap - lap.round()).abs() <= 1e-6);
    }
}
