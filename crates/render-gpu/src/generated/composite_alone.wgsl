// Made from Rust by naga-front-rust; do not edit. This command writes it: cargo run --release -p glimt-generate

struct PixelLayers {
    object: vec4<f32>,
    lit: vec3<f32>,
    catcher: f32,
    blocked: vec3<f32>,
    unused_a: u32,
    behind: vec3<f32>,
    unused_b: u32,
}

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
var<storage> layers: array<PixelLayers>;
@group(0) @binding(2) 
var<storage, read_write> out: array<vec4<f32>>;
@group(0) @binding(0) 
var<uniform> params: Params;

// glimt_render_gpu/src/kernels/layers.rs:109
fn share(part: f32, rest: f32) -> f32 {
    var chosen: f32;

    // glimt_render_gpu/src/kernels/layers.rs:110
    if (part > 0f) {
        // glimt_render_gpu/src/kernels/layers.rs:111
        chosen = (part / (part + rest));
    } else {
        // glimt_render_gpu/src/kernels/layers.rs:113
        chosen = 0f;
    }
    let _e12 = chosen;
    return _e12;
}

// glimt_render_gpu/src/kernels/layers.rs:93
fn PixelLayers_transmission(this_: PixelLayers) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/layers.rs:94
    let clear = (1f - this_.object.w);
    // glimt_render_gpu/src/kernels/layers.rs:95
    if !((clear > 0f)) {
        // glimt_render_gpu/src/kernels/layers.rs:96
        return vec3(1f);
    }
    // glimt_render_gpu/src/kernels/layers.rs:98
    let _e19 = share(this_.blocked.x, this_.lit.x);
    let _e24 = share(this_.blocked.y, this_.lit.y);
    let _e29 = share(this_.blocked.z, this_.lit.z);
    let lost = vec3<f32>(_e19, _e24, _e29);
    // glimt_render_gpu/src/kernels/layers.rs:103
    return max((vec3(1f) - (lost * (this_.catcher / clear))), vec3(0f));
}

// glimt_sampling/src/math.rs:16
fn luminance(rgb: vec3<f32>) -> f32 {

    // glimt_sampling/src/math.rs:17
    return (((0.2126f * rgb.x) + (0.7152f * rgb.y)) + (0.0722f * rgb.z));
}

// glimt_render_gpu/src/kernels/composite.rs:110
fn composite_alone_1(pixel: u32, frame: FrameParams) -> vec4<f32> {

    // glimt_render_gpu/src/kernels/composite.rs:111
    let layer = layers[pixel];
    // glimt_render_gpu/src/kernels/composite.rs:112
    let object = layer.object.xyz;
    // glimt_render_gpu/src/kernels/composite.rs:113
    let clear_1 = (1f - layer.object.w);
    // glimt_render_gpu/src/kernels/composite.rs:114
    let _e16 = PixelLayers_transmission(layer);
    // glimt_render_gpu/src/kernels/composite.rs:115
    if (frame.background == 0u) {
        // glimt_render_gpu/src/kernels/composite.rs:116
        return vec4<f32>((object + (layer.behind * (_e16 * clear_1))), 1f);
    }
    // glimt_render_gpu/src/kernels/composite.rs:119
    let _e34 = luminance((vec3(1f) - _e16));
    return vec4<f32>(object, (layer.object.w + (clear_1 * _e34)));
}

@compute @workgroup_size(64, 1, 1) 
fn composite_alone(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let local = ((id.y * (groups.x * 64u)) + id.x);
    let _e11 = params.count;
    if (local >= _e11) {
        return;
    }
    let _e14 = params.first;
    let _e17 = params.frame;
    let _e18 = composite_alone_1((_e14 + local), _e17);
    out[local] = _e18;
}
