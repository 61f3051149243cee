//! Host file: light and pictures by precomputed transfer: the map halved and made into coefficients; vertices, triangles and
//! layers of a small frame.

use std::sync::Arc;

use bytemuck::{NoUninit, bytes_of};
use glam::{UVec2, Vec2, Vec4};
use glimt_render_gpu::gpu::{Arg, GpuBuffer, GpuContext, GpuScene};
use glimt_render_gpu::kernels::layers::LayerSample;
use glimt_render_gpu::kernels::light_sh::{LightParams, light_coefficient};
use glimt_render_gpu::kernels::prt::{VertexLight, shade_prt, vertex_light};
use glimt_render_gpu::kernels::pyramid::{Taps, half_size, halve, taps};
use glimt_render_gpu::kernels::raster::{DrawnLayout, RasterParams, unpack_layers};
use glimt_render_gpu::prepare::render::{Pattern, Tonemap};
use glimt_render_gpu::prepare::transfer::Transfer;
use naga_front_rust::Program;

use super::frame::{RAYS, SIZE, environment, params, scene};
use super::{Output, Pair, drawn, launch, words};

const KERNELS: &str = "glimt_render_gpu::kernels";

/// A light map of odd size, halved; its factors; coefficients of it.
///
/// # Panics
/// Where the GPU or the front end fails.
#[must_use]
pub fn projection_pair(program: &Program, context: &GpuContext) -> Pair {
    let size = UVec2::new(27, 13);
    let half = half_size(size);
    let texel = |i: u32| Vec4::new((i % 7) as f32, (i % 11) as f32, (i % 5) as f32, 1.0);
    let texels: Vec<Vec4> = (0..size.x * size.y).map(texel).collect();
    let all_taps: Vec<Taps> = (0..half.x + half.y).map(|i| taps(i, size)).collect();
    let halved: Vec<Vec4> = (0..half.x * half.y)
        .map(|i| halve(i, size, &all_taps, &texels))
        .collect();
    let factors: Vec<[f32; 33]> = (0..size.x * size.y)
        .map(|i| drawn::factors(i, size))
        .collect();
    let light = LightParams {
        rotation: Vec2::new(0.8, 0.6),
        window: 6.5,
        temporal: 0.3,
        bands: 6,
        unused_a: 0,
        unused_b: 0,
        unused_c: 0,
    };
    let (sums, previous) = (&texels[..36], &texels[36..72]);
    let coefficients: Vec<Vec4> = (0..36)
        .map(|k| light_coefficient(k, &light, sums, previous))
        .collect();

    let (map, sums, previous) = (
        upload(context, &texels),
        upload(context, sums),
        upload(context, previous),
    );
    let count = half.x + half.y;
    let of_taps = Output::new::<Taps>(context, count);
    let args = [("size", Arg::Value(bytes_of(&size)))];
    let kernel = format!("{KERNELS}::pyramid::taps");
    launch(context, program, &kernel, &args, &of_taps.buffer, count);
    let args = [
        ("size", Arg::Value(bytes_of(&size))),
        ("taps", Arg::Buffer(&of_taps.buffer)),
        ("texels", Arg::Buffer(&map)),
        ("light", Arg::Value(bytes_of(&light))),
        ("sums", Arg::Buffer(&sums)),
        ("previous", Arg::Buffer(&previous)),
    ];
    let run = |kernel: &str, out: Output, count| {
        launch(context, program, kernel, &args, &out.buffer, count);
        out.read(context)
    };
    let count = half.x * half.y;
    let out = Output::new::<Vec4>(context, count);
    let mut gpu = run(&format!("{KERNELS}::pyramid::halve"), out, count);
    let count = size.x * size.y;
    let out = Output::new::<[f32; 33]>(context, count);
    gpu.extend(run("drawn::factors", out, count));
    let out = Output::new::<Vec4>(context, 36);
    gpu.extend(run(
        &format!("{KERNELS}::light_sh::light_coefficient"),
        out,
        36,
    ));
    Pair {
        name: "projection".to_owned(),
        cpu: [words(&halved), words(&factors), words(&coefficients)].concat(),
        gpu,
    }
}

/// Vertices, rays, triangles and layers of a scene that has a made-up transfer.
///
/// # Panics
/// Where the GPU or the front end fails.
#[must_use]
pub fn drawing_pair(program: &Program, context: &GpuContext) -> Pair {
    let (mut scene, env) = (scene(true), environment(30.0));
    let vertices: usize = scene.vertex_counts().iter().sum();
    let number = |i: usize| (i % 13) as f32 / 13.0 - 0.2;
    let transfer = Transfer {
        bands: 3,
        lit: (0..9 * vertices).map(number).collect(),
        blocked: (0..9 * vertices).map(|i| 0.3 * number(i + 5)).collect(),
    };
    let set = scene.set_transfer(Arc::new(transfer), &[0.0, 0.5, 0.2]);
    set.expect("a transfer that fits");
    let known = scene.transfer().expect("it was just set");
    let transfer = known.transfer();
    let coefficients: Vec<Vec4> = (0..9)
        .map(|k| Vec4::new(3.0, 2.0, 1.0, 0.0) / (k + 1) as f32)
        .collect();
    let (count, shadows) = (9, 1);
    let lights: Vec<VertexLight> = (0..vertices as u32)
        .map(|v| {
            let (lit, blocked) = (&transfer.lit, &transfer.blocked);
            vertex_light(v, count, shadows, &coefficients, lit, blocked)
        })
        .collect();
    let (map, surface) = (env.view().map(), known.surface(&lights));
    let frame = params(Pattern::OwenSobol, Tonemap::Srgb);
    let raster = RasterParams {
        frame,
        map_size: map.size,
        map_rotation: map.rotation,
        near: 0.1,
        scale: frame.exposure,
        samples: 1,
        unused: 0,
    };
    let rays = SIZE.x * SIZE.y * RAYS;
    let corners = scene.view().corners.len() as u32;
    let pixels = SIZE.x * SIZE.y;
    let layout = DrawnLayout {
        map_size: map.size,
        pitch: SIZE.x + 3,
        scale: frame.exposure,
    };
    let halves: Vec<UVec2> = (0..layout.pitch * SIZE.y)
        .map(|i| UVec2::new(0x3c00_0000 | (i % 0x7000), 0x3800_3400 ^ ((i % 3) << 24)))
        .collect();
    let view = scene.view();
    let cpu = [
        words(&lights),
        words(
            &(0..rays)
                .map(|ray| shade_prt(ray, &frame, map, view, surface))
                .collect::<Vec<Vec4>>(),
        ),
        words(
            &(0..rays)
                .map(|ray| shade_prt(ray, &frame, map, view, surface))
                .collect::<Vec<LayerSample>>(),
        ),
        words(
            &(0..corners)
                .map(|corner| drawn::drawn(corner, &raster, map.texels, view, surface))
                .collect::<Vec<_>>(),
        ),
        words(
            &(0..pixels)
                .map(|pixel| {
                    let [object, lit, blocked] = [&halves; 3];
                    let (rotation, texels) = (map.rotation, map.texels);
                    unpack_layers(
                        pixel, &frame, &layout, rotation, texels, object, lit, blocked,
                    )
                })
                .collect::<Vec<_>>(),
        ),
    ];

    let uploaded = GpuScene::new(context, &scene).expect("a small scene");
    let texels = upload(context, map.texels);
    let corner_vertices = upload(context, surface.corner_vertices);
    let reflections = upload(context, surface.reflections);
    let light = upload(context, &coefficients);
    let (lit, blocked) = (
        upload(context, &transfer.lit),
        upload(context, &transfer.blocked),
    );
    let halves = upload(context, &halves);
    let of_lights = Output::new::<VertexLight>(context, vertices as u32);
    let args = [
        ("coefficients", Arg::Value(bytes_of(&count))),
        ("shadows", Arg::Value(bytes_of(&shadows))),
        ("light", Arg::Buffer(&light)),
        ("lit", Arg::Buffer(&lit)),
        ("blocked", Arg::Buffer(&blocked)),
    ];
    let kernel = format!("{KERNELS}::prt::vertex_light");
    let out = &of_lights.buffer;
    launch(context, program, &kernel, &args, out, vertices as u32);

    let mut args = vec![
        ("frame", Arg::Value(bytes_of(&frame))),
        ("raster", Arg::Value(bytes_of(&raster))),
        ("layout", Arg::Value(bytes_of(&layout))),
        ("map.size", Arg::Value(bytes_of(&map.size))),
        ("map.rotation", Arg::Value(bytes_of(&map.rotation))),
        ("map.texels", Arg::Buffer(&texels)),
        ("map_rotation", Arg::Value(bytes_of(&map.rotation))),
        ("map_texels", Arg::Buffer(&texels)),
        ("texels", Arg::Buffer(&texels)),
        ("surface.corner_vertices", Arg::Buffer(&corner_vertices)),
        ("surface.reflections", Arg::Buffer(&reflections)),
        ("surface.lights", Arg::Buffer(&of_lights.buffer)),
        ("object", Arg::Buffer(&halves)),
        ("lit", Arg::Buffer(&halves)),
        ("blocked", Arg::Buffer(&halves)),
    ];
    args.extend(uploaded.args());
    let run = |kernel: &str, out: Output, count| {
        launch(context, program, kernel, &args, &out.buffer, count);
        out.read(context)
    };
    let gpu = [
        of_lights.read(context),
        run(
            &format!("{KERNELS}::prt::shade_prt::<glam::Vec4>"),
            Output::new::<Vec4>(context, rays),
            rays,
        ),
        run(
            &format!("{KERNELS}::prt::shade_prt::<{KERNELS}::layers::LayerSample>"),
            Output::new::<LayerSample>(context, rays),
            rays,
        ),
        run(
            "drawn::drawn",
            Output::new::<[Vec4; 4]>(context, corners),
            corners,
        ),
        run(
            &format!("{KERNELS}::raster::unpack_layers"),
            Output::new::<glimt_render_gpu::kernels::layers::PixelLayers>(context, pixels),
            pixels,
        ),
    ];
    Pair {
        name: "drawing".to_owned(),
        cpu: cpu.concat(),
        gpu: gpu.concat(),
    }
}

fn upload<T: NoUninit>(context: &GpuContext, values: &[T]) -> GpuBuffer {
    context.buffer_of("input", values).expect("a small buffer")
}
