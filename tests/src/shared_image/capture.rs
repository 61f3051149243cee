//! Host file: a small simulated capture: ball, backplate, map and sensor, with all that may stand in the way.

use glam::{UVec2, Vec3, Vec4, vec3};
use glimt_render_gpu::gpu::{Arg, GpuContext};
use glimt_render_gpu::kernels::capture::{
    CaptureParams, LatLongParams, film_ball, film_latlong, film_plate,
};
use glimt_render_gpu::kernels::sensor::{SensorParams, expose};
use glimt_render_gpu::kernels::stage::{STAGE_BOX, STAGE_SPHERE, Stage, StageParams};
use glimt_render_gpu::prepare::render::RenderSettings;
use glimt_render_gpu::prepare::scene::Camera;
use naga_front_rust::Program;

use super::{Output, Pair, launch, words};

const SIZE: UVec2 = UVec2::new(40, 30);

/// The four kernels, one after the other in one image.
///
/// # Panics
/// Where the GPU or the front end fails.
#[must_use]
pub fn capture_pair(program: &Program, context: &GpuContext) -> Pair {
    let map = UVec2::new(32, 16);
    let texels: Vec<Vec4> = (0..map.x * map.y)
        .map(|i| vec3(0.2 + 0.03 * (i % 32) as f32, 0.05 * (i / 32) as f32, 0.5).extend(1.0))
        .collect();
    let upload = context.buffer_of("texels", &texels).expect("a small map");
    let count = SIZE.x * SIZE.y;
    let (mut cpu, mut gpu) = (Vec::new(), Vec::new());
    for shape in [STAGE_SPHERE, STAGE_BOX] {
        let stage = Stage {
            texels: &texels,
            params: stage_params(shape, map),
        };
        let shared = [
            (
                "stage.params",
                Arg::Value(bytemuck::bytes_of(&stage.params)),
            ),
            ("stage.texels", Arg::Buffer(&upload)),
        ];
        let mut run = |kernel: &str, args: &[(&'static str, Arg<'_>)], values: Vec<Vec4>| {
            let out = Output::new::<Vec4>(context, count);
            let args = [args, &shared[..]].concat();
            let kernel = format!("glimt_render_gpu::kernels::{kernel}");
            launch(context, program, &kernel, &args, &out.buffer, count);
            cpu.extend(words(&values));
            gpu.extend(out.read(context));
            values
        };
        let of = |element: &dyn Fn(u32) -> Vec4| (0..count).map(element).collect::<Vec<_>>();

        let capture = capture_params();
        let arg = [("capture", Arg::Value(bytemuck::bytes_of(&capture)))];
        let ball = of(&|i| film_ball(i, &capture, stage));
        let ball = run("capture::film_ball", &arg, ball);

        let camera = Camera {
            eye: vec3(-1.0, 0.2, 0.3),
            target: Vec3::ZERO,
            up: Vec3::Z,
            fov_x: 1.2,
        };
        let frame = RenderSettings::new(SIZE, camera).frame_params();
        let frame = frame.expect("settings that are right");
        let arg = [("frame", Arg::Value(bytemuck::bytes_of(&frame)))];
        run(
            "capture::film_plate",
            &arg,
            of(&|i| film_plate(i, &frame, stage)),
        );

        let latlong = LatLongParams {
            position: vec3(0.3, 0.2, -0.1),
            grid: 2,
            size: SIZE,
            unused: UVec2::ZERO,
        };
        let arg = [("latlong", Arg::Value(bytemuck::bytes_of(&latlong)))];
        run(
            "capture::film_latlong",
            &arg,
            of(&|i| film_latlong(i, &latlong, stage)),
        );

        let sensor = sensor_params();
        let radiance = context.buffer_of("radiance", &ball).expect("a small image");
        let args = [
            ("sensor", Arg::Value(bytemuck::bytes_of(&sensor))),
            ("radiance", Arg::Buffer(&radiance)),
        ];
        run("sensor::expose", &args, of(&|i| expose(i, &sensor, &ball)));
    }
    Pair {
        name: "capture".to_owned(),
        cpu,
        gpu,
    }
}

fn stage_params(shape: u32, size: UVec2) -> StageParams {
    StageParams {
        half_size: vec3(3.0, 2.5, 2.0),
        shape,
        occluder_centre: vec3(-0.5, -1.5, 0.5),
        occluder_radius: 0.6,
        occluder_radiance: Vec3::splat(0.1),
        unused: 0.0,
        size,
        rotation: glimt_probe::rotate::cos_sin_degrees(20.0),
    }
}

fn capture_params() -> CaptureParams {
    let k: f32 = 0.04;
    CaptureParams {
        shake_x: vec3(0.999, 0.01, 0.001),
        width: SIZE.x,
        shake_y: vec3(-0.01, 0.999, -0.001),
        height: SIZE.y,
        shake_z: vec3(-0.001, 0.001, 1.0),
        focal_px: 300.0,
        ball_centre: Vec3::ZERO,
        ball_radius: 0.05,
        forward: Vec3::X,
        radius_over_distance: k,
        right: Vec3::NEG_Y,
        outline: k / (1.0 - k * k).sqrt(),
        up: Vec3::Z,
        samples: 2,
        tint: vec3(0.7, 0.6, 0.5),
        fresnel: 1.0,
        eye: vec3(-1.25, 0.0, 0.0),
        unused_a: 0,
        rig_half_size: vec3(0.2, 0.1, 0.1),
        unused_b: 0,
        rig_radiance: Vec3::splat(0.02),
        unused_c: 0,
    }
}

fn sensor_params() -> SensorParams {
    SensorParams {
        longest_gain: 4000.0,
        step: 8.0,
        exposures: 4,
        full_well: 2000.0,
        read_noise: 3.0,
        electrons_per_code: 0.5,
        seed: 1,
        frame: 1,
        unused_a: 0,
        unused_b: 0,
        unused_c: 0,
        unused_d: 0,
    }
}
