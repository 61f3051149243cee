//! Host file: unwarping photographs of a mirror ball, against geometry in f64.

use glam::{DVec3, Mat3, UVec2, Vec2, Vec3, Vec4};
use glimt_probe::gather::ColourMatrix;
use glimt_probe::latlong::{texel_direction, texel_solid_angle_sr};
use glimt_probe::mirror_ball::MirrorBall;
use glimt_probe::unwarp::{Outline, Visibility};
use glimt_render_gpu::gpu::GpuUnwarp;
use glimt_render_gpu::prepare::unwarp::{BallPose, Look, UnwarpGrid, UnwarpMap, UnwarpOptions};
use glimt_tests::ball::{photograph, rolled};
use glimt_tests::gpu::adapter_or_skip;
use glimt_tests::stats::within;

fn axes() -> Vec<(Vec3, Vec3)> {
    vec![
        (Vec3::X, Vec3::Z),
        (Vec3::NEG_Y, Vec3::Z),
        (Vec3::new(0.3, -0.8, -0.5), Vec3::Z),
        (Vec3::Z, Vec3::X),
    ]
}

/// Smooth, and different in every direction.
fn radiance(d: DVec3) -> Vec4 {
    let light = 1.0 + 0.5 * d.z + 0.3 * (3.0 * d.x).sin() + 0.2 * (5.0 * d.y * d.x).cos();
    Vec4::new(light as f32, (2.0 + d.x) as f32, (1.5 + d.y) as f32, 1.0)
}

/// Relative RMS error over the texels that were seen, and the relative error of the whole flux.
fn errors(map: &UnwarpMap, texels: &[Vec4], truth: impl Fn(DVec3) -> Vec4) -> (f64, f64) {
    let size = map.size();
    let (mut square, mut norm, mut flux, mut true_flux) = (0.0, 0.0, 0.0, 0.0);
    for (i, texel) in texels.iter().enumerate() {
        let at = UVec2::new(i as u32 % size.x, i as u32 / size.x);
        let weight = f64::from(texel_solid_angle_sr(at.y, size));
        let expected = truth(texel_direction(at, size).as_dvec3());
        if map.visibility()[i] == Visibility::Seen {
            let difference = (*texel - expected).truncate().as_dvec3();
            square += weight * difference.length_squared();
            norm += weight * expected.truncate().as_dvec3().length_squared();
        }
        flux += weight * texel.truncate().as_dvec3().element_sum();
        true_flux += weight * expected.truncate().as_dvec3().element_sum();
    }
    ((square / norm).sqrt(), flux / true_flux - 1.0)
}

/// A ball of some size and place, filmed from somewhere.
struct Pose {
    ball: MirrorBall,
    pose: BallPose,
    photo: UVec2,
}

impl Pose {
    fn photograph(&self, radiance: impl Fn(DVec3) -> Vec4 + Sync) -> Vec<Vec4> {
        let ball = rolled(&self.ball, self.pose.roll);
        let beside = Vec4::new(0.0, 9.0, 0.0, 1.0);
        photograph(&ball, &self.pose.outline, self.photo, 4, beside, radiance)
    }

    fn map(&self, size: UVec2) -> UnwarpMap {
        let options = UnwarpOptions::default();
        let grid = UnwarpGrid::new(self.ball, size);
        grid.map(&self.pose, self.photo, &options)
            .expect("a ball in the photograph")
    }
}

fn poses() -> Vec<Pose> {
    let mut all = Vec::new();
    for (i, (forward, up)) in axes().into_iter().enumerate() {
        for ratio in [0.0, 0.04, 0.2] {
            let i = i as f32;
            all.push(Pose {
                ball: MirrorBall::new(forward, up, ratio),
                pose: BallPose {
                    outline: Outline {
                        centre: Vec2::new(190.3 + 3.7 * i, 155.8 - 2.3 * i),
                        radius: 130.4 + i,
                    },
                    roll: 0.3 * (i - 1.5),
                },
                photo: UVec2::new(400, 300),
            });
        }
    }
    all
}

#[test]
fn lat_long_to_ball_to_lat_long() {
    for pose in poses() {
        let map = pose.map(UVec2::new(128, 64));
        let photo = pose.photograph(radiance);
        let texels = map.apply(&photo, &Look::IDENTITY);
        let (rmse, flux) = errors(&map, &texels, radiance);
        assert!(rmse < 0.01, "{:?}: {rmse}", pose.pose);
        assert!(flux.abs() < 0.005, "{:?}: {flux}", pose.pose);
        // It would be found out: mirrored, a pixel aside, turned by half a degree.
        let mirrored = |d: DVec3| radiance(DVec3::new(d.x, -d.y, d.z));
        assert!(errors(&map, &texels, mirrored).0 > 0.1);
        let mut wrong = Pose { ..pose };
        wrong.pose.roll += 0.03;
        let turned = wrong.map(map.size()).apply(&photo, &Look::IDENTITY);
        assert!(errors(&map, &turned, radiance).0 > rmse + 0.002);
    }
}

#[test]
fn small_and_odd_maps_keep_the_flux() {
    let pose = &poses()[4];
    let photo = pose.photograph(radiance);
    for size in [
        UVec2::new(1, 1),
        UVec2::new(3, 2),
        UVec2::new(16, 8),
        UVec2::new(37, 50),
        UVec2::new(700, 350),
    ] {
        let map = pose.map(size);
        let texels = map.apply(&photo, &Look::IDENTITY);
        // The mean over texels of the truth, not its value in their middle.
        let fine = pose.map(UVec2::new(256, 128));
        let fine_texels = fine.apply(&photo, &Look::IDENTITY);
        let flux = |size: UVec2, texels: &[Vec4]| -> f64 {
            let rows = texels.chunks(size.x as usize).enumerate();
            rows.map(|(y, row)| {
                let sum: f64 = row.iter().map(|t| f64::from(t.x)).sum();
                sum * f64::from(texel_solid_angle_sr(y as u32, size))
            })
            .sum()
        };
        let ratio = flux(size, &texels) / flux(fine.size(), &fine_texels);
        within(ratio, 1.0, 0.01).unwrap_or_else(|e| panic!("{size}: {e:?}"));
    }
}

#[test]
fn a_constant_light_stays_constant() {
    for pose in poses().iter().take(6) {
        let map = pose.map(UVec2::new(64, 32));
        let photo = pose.photograph(|_| Vec4::ONE);
        for texel in map.apply(&photo, &Look::IDENTITY) {
            // The green beside the ball comes nowhere.
            assert!((texel - Vec4::ONE).abs().max_element() < 2e-5, "{texel}");
        }
    }
}

#[test]
fn what_is_never_seen_is_marked_and_filled_smoothly() {
    for pose in poses() {
        let size = UVec2::new(256, 128);
        let map = pose.map(size);
        // Harmonic on the sphere about the axis: a function of the direction across it.
        let across = pose.ball.right.as_dvec3();
        let harmonic = |d: DVec3| Vec4::splat((2.0 + d.dot(across)) as f32).with_w(1.0);
        let texels = map.apply(&pose.photograph(harmonic), &Look::IDENTITY);
        let (mut hidden, mut rim) = (0, 0);
        for (i, seen) in map.visibility().iter().enumerate() {
            let at = UVec2::new(i as u32 % size.x, i as u32 / size.x);
            let d = texel_direction(at, size);
            assert_eq!(*seen == Visibility::Hidden, pose.ball.is_hidden(d));
            hidden += u32::from(*seen == Visibility::Hidden);
            rim += u32::from(*seen == Visibility::Rim);
            if *seen != Visibility::Seen {
                let error = (texels[i] - harmonic(d.as_dvec3())).abs().max_element();
                assert!(error < 0.06, "{at}: {error} of {:?}", pose.pose);
            }
        }
        assert!(rim > 0);
        assert_eq!(hidden > 0, pose.ball.radius_over_distance > 0.0);
    }
}

#[test]
fn the_rig_is_filled() {
    let pose = &poses()[1];
    let camera = -pose.ball.forward.as_dvec3();
    let with_rig = |d: DVec3| {
        if d.dot(camera) > 0.2_f64.cos() {
            Vec4::W
        } else {
            Vec4::ONE
        }
    };
    let photo = pose.photograph(with_rig);
    let grid = UnwarpGrid::new(pose.ball, UVec2::new(128, 64));
    let options = UnwarpOptions {
        rig_half_angle: 0.25,
        ..UnwarpOptions::default()
    };
    let map = grid.map(&pose.pose, pose.photo, &options).unwrap();
    assert!(map.visibility().contains(&Visibility::Rig));
    let darkest = |map: &UnwarpMap| {
        let texels = map.apply(&photo, &Look::IDENTITY);
        texels.iter().map(|t| t.x).fold(1.0, f32::min)
    };
    assert!(darkest(&map) > 0.99);
    assert!(darkest(&pose.map(UVec2::new(128, 64))) < 0.01);
}

#[test]
fn a_cut_ball_is_refused() {
    let pose = &poses()[0];
    let grid = UnwarpGrid::new(pose.ball, UVec2::new(8, 4));
    let mut cut = pose.pose;
    cut.outline.centre.x = 100.0;
    assert!(
        grid.map(&cut, pose.photo, &UnwarpOptions::default())
            .is_err()
    );
    cut.outline.centre.x = f32::NAN;
    assert!(
        grid.map(&cut, pose.photo, &UnwarpOptions::default())
            .is_err()
    );
}

/// The table that the CPU reads, read by the GPU.
#[test]
fn a_light_map_is_the_same_on_both_processors() {
    let Some(context) = adapter_or_skip("unwarp") else {
        return;
    };
    let colour = ColourMatrix::from_mat3(Mat3::from_cols_array(&[
        1.1, 0.1, 0.0, -0.2, 0.9, 0.1, 0.0, 0.05, 1.3,
    ]));
    for pose in poses().iter().step_by(5) {
        let map = pose.map(UVec2::new(200, 100));
        let photo = pose.photograph(radiance);
        let look = Look {
            reflectance: Vec3::new(0.6, 0.7, 0.8),
            colour,
        };
        let cpu = map.apply(&photo, &look);
        let gpu = GpuUnwarp::new(&context, &map).unwrap();
        gpu.run(&context, &photo, &look).unwrap();
        let differ = |a: &[Vec4], b: &[Vec4]| {
            let pairs = a.iter().zip(b);
            pairs
                .map(|(a, b)| (*a - *b).abs().max_element() / a.max_element())
                .fold(0.0, f32::max)
        };
        let light = gpu.read(&context).unwrap();
        let largest = differ(&cpu, &light);
        assert!(largest < 2e-6, "{largest}");
        let other = map.apply(&photo, &Look::IDENTITY);
        assert!(differ(&other, &light) > 1e-2);
    }
}
