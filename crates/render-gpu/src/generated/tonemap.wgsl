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
var<storage> linear_2: array<vec4<f32>>;
@group(0) @binding(2) 
var<storage, read_write> out: array<u32>;
@group(0) @binding(0) 
var<uniform> params: Params;

// glimt_probe/src/gather.rs:72
fn ColourMatrix_apply(this_: ColourMatrix, colour: vec4<f32>) -> vec4<f32> {

    // glimt_probe/src/gather.rs:73
    let changed = (((this_.red * colour.x) + (this_.green * colour.y)) + (this_.blue * colour.z));
    // glimt_probe/src/gather.rs:75
    return max(changed, vec4<f32>(0f, 0f, 0f, 1f));
}

// glimt_render_gpu/src/kernels/film.rs:36
fn displayed(frame: FrameParams, colour_1: vec3<f32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/film.rs:37
    let _e7 = ColourMatrix_apply(frame.to_display, vec4<f32>(colour_1, 1f));
    return _e7.xyz;
}

// glimt_render_gpu/src/kernels/film.rs:43
fn tone_curve(frame_1: FrameParams, exposed: vec3<f32>) -> vec3<f32> {
    var chosen: vec3<f32>;

    // glimt_render_gpu/src/kernels/film.rs:44
    if (frame_1.tonemap == 1u) {
        // glimt_render_gpu/src/kernels/film.rs:45
        chosen = (vec3(1f) - (vec3(1f) / (vec3(1f) + exposed)));
    } else {
        // glimt_render_gpu/src/kernels/film.rs:47
        chosen = min(exposed, vec3(1f));
    }
    let _e22 = chosen;
    return _e22;
}

// glimt_render_gpu/src/kernels/film.rs:65
fn srgb_encode(linear: f32) -> f32 {
    var chosen_1: f32;

    // glimt_render_gpu/src/kernels/film.rs:66
    if (linear <= 0.0031308f) {
        // glimt_render_gpu/src/kernels/film.rs:67
        chosen_1 = (12.92f * linear);
    } else {
        // glimt_render_gpu/src/kernels/film.rs:69
        chosen_1 = ((1.055f * pow(linear, (1f / 2.4f))) - 0.055f);
    }
    let _e18 = chosen_1;
    return _e18;
}

// glimt_render_gpu/src/kernels/film.rs:75
fn code(value: f32) -> u32 {

    // glimt_render_gpu/src/kernels/film.rs:76
    return u32(((clamp(value, 0f, 1f) * 255f) + 0.5f));
}

// glimt_render_gpu/src/kernels/film.rs:55
fn display_code(linear_1: vec3<f32>, alpha: f32) -> u32 {

    // glimt_render_gpu/src/kernels/film.rs:56
    let _e5 = srgb_encode(linear_1.x);
    let _e6 = code(_e5);
    let _e8 = srgb_encode(linear_1.y);
    let _e9 = code(_e8);
    let _e14 = srgb_encode(linear_1.z);
    let _e15 = code(_e14);
    let _e19 = code(alpha);
    return (((_e6 | (_e9 << 8u)) | (_e15 << 16u)) | (_e19 << 24u));
}

// glimt_render_gpu/src/kernels/film.rs:23
fn tonemap_1(pixel: u32, frame_2: FrameParams) -> u32 {

    // glimt_render_gpu/src/kernels/film.rs:24
    let value_1 = linear_2[pixel];
    // glimt_render_gpu/src/kernels/film.rs:25
    let alpha_1 = clamp(value_1.w, 0f, 1f);
    // glimt_render_gpu/src/kernels/film.rs:26
    if (alpha_1 == 0f) {
        // glimt_render_gpu/src/kernels/film.rs:27
        return 0u;
    }
    // glimt_render_gpu/src/kernels/film.rs:29
    let exposed_1 = clamp(((value_1.xyz / vec3(alpha_1)) * frame_2.exposure), vec3(0f), vec3(10000000000000000000000000000000000000f));
    // glimt_render_gpu/src/kernels/film.rs:30
    let _e29 = displayed(frame_2, exposed_1);
    let _e30 = tone_curve(frame_2, _e29);
    let _e31 = display_code(_e30, alpha_1);
    return _e31;
}

@compute @workgroup_size(64, 1, 1) 
fn tonemap(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let local = ((id.y * (groups.x * 64u)) + id.x);
    let _e11 = params.count;
    if (local >= _e11) {
        return;
    }
    let _e14 = params.first;
    let _e17 = params.frame;
    let _e18 = tonemap_1((_e14 + local), _e17);
    out[local] = _e18;
}
