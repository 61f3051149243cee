//! Host file: a light map unwarped from a small photograph of a mirror ball, on both processors.

use bytemuck::NoUninit;
use glam::{Mat3, UVec2, Vec2, Vec3, Vec4};
use glimt_probe::gather::{ColourMatrix, TexelTaps};
use glimt_probe::mirror_ball::MirrorBall;
use glimt_probe::unwarp::Outline;
use glimt_render_gpu::gpu::{Arg, GpuContext};
use glimt_render_gpu::prepare::unwarp::{BallPose, Look, UnwarpGrid, UnwarpOptions};
use naga_front_rust::Program;

use super::{Output, Pair, launch, words};

/// The light map of a photograph of 40 × 30 pixels.
///
/// # Panics
/// Where the GPU or the front end fails.
#[must_use]
pub fn light_pair(program: &Program, context: &GpuContext) -> Pair {
    let photo = UVec2::new(40, 30);
    let pixel = |i: u32| Vec3::new((i % 7) as f32, (i % 11) as f32, 1.0).extend(1.0);
    let pixels: Vec<Vec4> = (0..photo.x * photo.y).map(pixel).collect();
    let pose = BallPose {
        outline: Outline {
            centre: Vec2::new(20.3, 14.6),
            radius: 13.4,
        },
        roll: 0.2,
    };
    let grid = UnwarpGrid::new(MirrorBall::new(Vec3::X, Vec3::Z, 0.1), UVec2::new(32, 16));
    let map = grid
        .map(&pose, photo, &UnwarpOptions::default())
        .expect("a ball in the photograph");
    let colour = ColourMatrix::from_mat3(Mat3::from_cols_array(&[
        0.9, 0.1, 0.0, 0.2, 1.1, -0.3, 0.0, 0.1, 0.8,
    ]));
    let reflectance = Vec3::new(0.7, 0.8, 0.6);
    let cpu = map.apply(
        &pixels,
        &Look {
            reflectance,
            colour,
        },
    );
    let reflectance = reflectance.extend(1.0);

    let view = map.view();
    let texels = upload::<TexelTaps>(context, view.texels);
    let taps = upload(context, view.taps);
    let photo = upload(context, &pixels);
    let args = [
        ("colour", Arg::Value(bytemuck::bytes_of(&colour))),
        ("reflectance", Arg::Value(bytemuck::bytes_of(&reflectance))),
        ("map.texels", Arg::Buffer(&texels)),
        ("map.taps", Arg::Buffer(&taps)),
        ("pixels", Arg::Buffer(&photo)),
    ];
    let out = Output::new::<Vec4>(context, cpu.len() as u32);
    let kernel = "glimt_render_gpu::kernels::unwarp::unwarp";
    launch(
        context,
        program,
        kernel,
        &args,
        &out.buffer,
        cpu.len() as u32,
    );
    Pair {
        name: "light".to_owned(),
        cpu: words(&cpu),
        gpu: out.read(context),
    }
}

fn upload<T: NoUninit>(context: &GpuContext, values: &[T]) -> glimt_render_gpu::gpu::GpuBuffer {
    context.buffer_of("input", values).expect("a small buffer")
}
