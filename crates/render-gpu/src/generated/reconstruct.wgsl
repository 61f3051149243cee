// Made from Rust by naga-front-rust; do not edit. This command writes it: cargo run --release -p glimt-generate

struct ColourMatrix {
    red: vec4<f32>,
    green: vec4<f32>,
    blue: vec4<f32>,
}

struct FrameParams {
    eye: vec3<f32>,
    width: u32,
    forward: vec3<f32>,
    height: u32,
    right: vec3<f32>,
    rays_per_pixel: u32,
    up: vec3<f32>,
    first_pixel: u32,
    pattern: u32,
    filter_: u32,
    background: u32,
    seed: u32,
    frame: u32,
    tonemap: u32,
    exposure: f32,
    shadow: u32,
    film_frame: u32,
    unused_a: u32,
    unused_b: u32,
    unused_c: u32,
    to_plate: ColourMatrix,
    to_display: ColourMatrix,
}

struct Params {
    first: u32,
    count: u32,
    frame: FrameParams,
}

@group(0) @binding(1) 
var<storage> samples: array<vec4<f32>>;
@group(0) @binding(2) 
var<storage, read_write> out: array<vec4<f32>>;
@group(0) @binding(0) 
var<uniform> params: Params;

// glimt_render_gpu/src/kernels/film.rs:10
fn reconstruct_1(pixel: u32, frame: FrameParams) -> vec4<f32> {
    var sum: vec4<f32>;
    var counter: u32;

    // glimt_render_gpu/src/kernels/film.rs:11
    let first = (pixel * frame.rays_per_pixel);
    // glimt_render_gpu/src/kernels/film.rs:12
    sum = vec4(0f);
    // glimt_render_gpu/src/kernels/film.rs:13
    counter = first;
    loop {
        let i = counter;
        if (i >= (first + frame.rays_per_pixel)) {
            break;
        }
        // glimt_render_gpu/src/kernels/film.rs:14
        let _e19 = samples[i];
        let _e20 = sum;
        sum = (_e20 + _e19);
        continuing {
            let _e22 = counter;
            counter = (_e22 + 1u);
        }
    }
    // glimt_render_gpu/src/kernels/film.rs:16
    let _e26 = sum;
    return (_e26 / vec4(f32(frame.rays_per_pixel)));
}

@compute @workgroup_size(64, 1, 1) 
fn reconstruct(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let local = ((id.y * (groups.x * 64u)) + id.x);
    let _e11 = params.count;
    if (local >= _e11) {
        return;
    }
    let _e14 = params.first;
    let _e17 = params.frame;
    let _e18 = reconstruct_1((_e14 + local), _e17);
    out[local] = _e18;
}
