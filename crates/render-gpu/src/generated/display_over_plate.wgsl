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

struct PlatePixel {
    linear: vec3<f32>,
    code: u32,
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
}

struct Params {
    first: u32,
    count: u32,
    frame: FrameParams,
}

@group(0) @binding(1) 
var<storage> layers: array<PixelLayers>;
@group(0) @binding(2) 
var<storage> plate: array<PlatePixel>;
@group(0) @binding(3) 
var<storage, read_write> out: array<u32>;
@group(0) @binding(0) 
var<uniform> params: Params;

// glimt_render_gpu/src/kernels/layers.rs:83
fn PixelLayers_is_plate(this_: PixelLayers) -> bool {

    // glimt_render_gpu/src/kernels/layers.rs:84
    return ((this_.object.w == 0f) && !((max(max(this_.blocked.x, this_.blocked.y), this_.blocked.z) > 0f)));
}

// glimt_render_gpu/src/kernels/composite.rs:73
fn exposed(frame: FrameParams, radiance: vec3<f32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/composite.rs:74
    return clamp((radiance * frame.exposure), vec3(0f), vec3(10000000000000000000000000000000000000f));
}

// glimt_render_gpu/src/kernels/film.rs:36
fn tone_curve(frame_1: FrameParams, exposed_1: vec3<f32>) -> vec3<f32> {
    var chosen: vec3<f32>;

    // glimt_render_gpu/src/kernels/film.rs:37
    if (frame_1.tonemap == 1u) {
        // glimt_render_gpu/src/kernels/film.rs:38
        chosen = (vec3(1f) - (vec3(1f) / (vec3(1f) + exposed_1)));
    } else {
        // glimt_render_gpu/src/kernels/film.rs:40
        chosen = min(exposed_1, vec3(1f));
    }
    let _e22 = chosen;
    return _e22;
}

// glimt_render_gpu/src/kernels/layers.rs:109
fn share(part: f32, rest: f32) -> f32 {
    var chosen_1: f32;

    // glimt_render_gpu/src/kernels/layers.rs:110
    if (part > 0f) {
        // glimt_render_gpu/src/kernels/layers.rs:111
        chosen_1 = (part / (part + rest));
    } else {
        // glimt_render_gpu/src/kernels/layers.rs:113
        chosen_1 = 0f;
    }
    let _e12 = chosen_1;
    return _e12;
}

// glimt_render_gpu/src/kernels/layers.rs:93
fn PixelLayers_transmission(this_1: PixelLayers) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/layers.rs:94
    let clear = (1f - this_1.object.w);
    // glimt_render_gpu/src/kernels/layers.rs:95
    if !((clear > 0f)) {
        // glimt_render_gpu/src/kernels/layers.rs:96
        return vec3(1f);
    }
    // glimt_render_gpu/src/kernels/layers.rs:98
    let _e19 = share(this_1.blocked.x, this_1.lit.x);
    let _e24 = share(this_1.blocked.y, this_1.lit.y);
    let _e29 = share(this_1.blocked.z, this_1.lit.z);
    let lost = vec3<f32>(_e19, _e24, _e29);
    // glimt_render_gpu/src/kernels/layers.rs:103
    return max((vec3(1f) - (lost * (this_1.catcher / clear))), vec3(0f));
}

// glimt_render_gpu/src/kernels/composite.rs:79
fn over(frame_2: FrameParams, layer: PixelLayers, object: vec3<f32>, behind: vec3<f32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/composite.rs:80
    let clear_1 = (1f - layer.object.w);
    // glimt_render_gpu/src/kernels/composite.rs:81
    if (frame_2.shadow == 1u) {
        // glimt_render_gpu/src/kernels/composite.rs:82
        let _e18 = exposed(frame_2, layer.blocked);
        return max(((object + (behind * clear_1)) - _e18), vec3(0f));
    }
    // glimt_render_gpu/src/kernels/composite.rs:84
    let _e24 = PixelLayers_transmission(layer);
    return (object + (behind * (_e24 * clear_1)));
}

// glimt_render_gpu/src/kernels/film.rs:58
fn srgb_encode(linear: f32) -> f32 {
    var chosen_2: f32;

    // glimt_render_gpu/src/kernels/film.rs:59
    if (linear <= 0.0031308f) {
        // glimt_render_gpu/src/kernels/film.rs:60
        chosen_2 = (12.92f * linear);
    } else {
        // glimt_render_gpu/src/kernels/film.rs:62
        chosen_2 = ((1.055f * pow(linear, (1f / 2.4f))) - 0.055f);
    }
    let _e18 = chosen_2;
    return _e18;
}

// glimt_render_gpu/src/kernels/film.rs:68
fn code(value: f32) -> u32 {

    // glimt_render_gpu/src/kernels/film.rs:69
    return u32(((clamp(value, 0f, 1f) * 255f) + 0.5f));
}

// glimt_render_gpu/src/kernels/film.rs:48
fn display_code(linear_1: vec3<f32>, alpha: f32) -> u32 {

    // glimt_render_gpu/src/kernels/film.rs:49
    let _e5 = srgb_encode(linear_1.x);
    let _e6 = code(_e5);
    let _e8 = srgb_encode(linear_1.y);
    let _e9 = code(_e8);
    let _e14 = srgb_encode(linear_1.z);
    let _e15 = code(_e14);
    let _e19 = code(alpha);
    return (((_e6 | (_e9 << 8u)) | (_e15 << 16u)) | (_e19 << 24u));
}

// glimt_render_gpu/src/kernels/composite.rs:51
fn display_over_plate_1(pixel: u32, frame_3: FrameParams) -> u32 {
    var object_1: vec3<f32>;

    // glimt_render_gpu/src/kernels/composite.rs:57
    let layer_1 = layers[pixel];
    // glimt_render_gpu/src/kernels/composite.rs:58
    let _e8 = PixelLayers_is_plate(layer_1);
    if _e8 {
        // glimt_render_gpu/src/kernels/composite.rs:59
        let _e13 = plate[pixel].code;
        return _e13;
    }
    // glimt_render_gpu/src/kernels/composite.rs:61
    let alpha_1 = layer_1.object.w;
    // glimt_render_gpu/src/kernels/composite.rs:62
    object_1 = vec3(0f);
    // glimt_render_gpu/src/kernels/composite.rs:63
    if (alpha_1 > 0f) {
        // glimt_render_gpu/src/kernels/composite.rs:64
        let _e29 = exposed(frame_3, (layer_1.object.xyz / vec3(alpha_1)));
        let _e30 = tone_curve(frame_3, _e29);
        object_1 = (_e30 * alpha_1);
    }
    // glimt_render_gpu/src/kernels/composite.rs:66
    let _e36 = plate[pixel].linear;
    let behind_1 = clamp(_e36, vec3(0f), vec3(1f));
    // glimt_render_gpu/src/kernels/composite.rs:67
    let _e43 = object_1;
    let _e44 = over(frame_3, layer_1, _e43, behind_1);
    // glimt_render_gpu/src/kernels/composite.rs:68
    let _e52 = display_code(clamp(_e44, vec3(0f), vec3(1f)), 1f);
    return _e52;
}

@compute @workgroup_size(64, 1, 1) 
fn display_over_plate(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let local = ((id.y * (groups.x * 64u)) + id.x);
    let _e11 = params.count;
    if (local >= _e11) {
        return;
    }
    let _e14 = params.first;
    let _e17 = params.frame;
    let _e18 = display_over_plate_1((_e14 + local), _e17);
    out[local] = _e18;
}
