// Made from Rust by naga-front-rust; do not edit. To make it anew: cargo run --release -p glimt-tests --bin regenerate

struct FrameParams {
    eye: vec3<f32>,
    width: u32,
    forward: vec3<f32>,
    height: u32,
    right: vec3<f32>,
    rays_per_pixel: u32,
    up: vec3<f32>,
    first_pixel: u32,
    brdf_samples: u32,
    env_samples: u32,
    pattern: u32,
    filter_: u32,
    background: u32,
    seed: u32,
    frame: u32,
    tonemap: u32,
    exposure: f32,
    unused_a: u32,
    unused_b: u32,
    unused_c: u32,
}

struct Params {
    first: u32,
    count: u32,
    frame: FrameParams,
}

@group(0) @binding(1) 
var<storage> linear_1: array<vec4<f32>>;
@group(0) @binding(2) 
var<storage, read_write> out: array<u32>;
@group(0) @binding(0) 
var<storage> params: Params;

// glimt_render_gpu/src/kernels/film.rs:44
fn srgb_encode(linear: f32) -> f32 {
    var chosen: f32;

    // glimt_render_gpu/src/kernels/film.rs:45
    if (linear <= 0.0031308f) {
        // glimt_render_gpu/src/kernels/film.rs:46
        chosen = (12.92f * linear);
    } else {
        // glimt_render_gpu/src/kernels/film.rs:48
        chosen = ((1.055f * pow(linear, (1f / 2.4f))) - 0.055f);
    }
    let _e18 = chosen;
    return _e18;
}

// glimt_render_gpu/src/kernels/film.rs:54
fn code(value: f32) -> u32 {

    // glimt_render_gpu/src/kernels/film.rs:55
    return u32(((clamp(value, 0f, 1f) * 255f) + 0.5f));
}

// glimt_render_gpu/src/kernels/film.rs:23
fn tonemap_1(pixel: u32, frame: FrameParams) -> u32 {
    var chosen_1: vec3<f32>;

    // glimt_render_gpu/src/kernels/film.rs:24
    let value_1 = linear_1[pixel];
    // glimt_render_gpu/src/kernels/film.rs:25
    let alpha = clamp(value_1.w, 0f, 1f);
    // glimt_render_gpu/src/kernels/film.rs:26
    if (alpha == 0f) {
        // glimt_render_gpu/src/kernels/film.rs:27
        return 0u;
    }
    // glimt_render_gpu/src/kernels/film.rs:29
    let exposed = max(((value_1.xyz / vec3(alpha)) * frame.exposure), vec3(0f));
    // glimt_render_gpu/src/kernels/film.rs:30
    if (frame.tonemap == 1u) {
        // glimt_render_gpu/src/kernels/film.rs:31
        chosen_1 = (vec3(1f) - (vec3(1f) / (vec3(1f) + exposed)));
    } else {
        // glimt_render_gpu/src/kernels/film.rs:33
        chosen_1 = min(exposed, vec3(1f));
    }
    let mapped = chosen_1;
    // glimt_render_gpu/src/kernels/film.rs:35
    let _e48 = srgb_encode(mapped.x);
    let _e49 = code(_e48);
    let _e51 = srgb_encode(mapped.y);
    let _e52 = code(_e51);
    let _e58 = srgb_encode(mapped.z);
    let _e59 = code(_e58);
    let _e64 = code(alpha);
    return (((_e49 | (_e52 << 8u)) | (_e59 << 16u)) | (_e64 << 24u));
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
