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

// glimt_probe/src/gather.rs:72
fn ColourMatrix_apply(this_1: ColourMatrix, colour: vec4<f32>) -> vec4<f32> {

    // glimt_probe/src/gather.rs:73
    let changed = (((this_1.red * colour.x) + (this_1.green * colour.y)) + (this_1.blue * colour.z));
    // glimt_probe/src/gather.rs:75
    return max(changed, vec4<f32>(0f, 0f, 0f, 1f));
}

// glimt_render_gpu/src/kernels/composite.rs:75
fn in_primaries(matrix: ColourMatrix, layer: PixelLayers) -> PixelLayers {

    // glimt_render_gpu/src/kernels/composite.rs:76
    let _e5 = ColourMatrix_apply(matrix, layer.object);
    let object_2 = _e5.xyz;
    // glimt_render_gpu/src/kernels/composite.rs:77
    let _e14 = ColourMatrix_apply(matrix, vec4<f32>(layer.lit, 1f));
    let _e20 = ColourMatrix_apply(matrix, vec4<f32>(layer.blocked, 1f));
    return PixelLayers(vec4<f32>(object_2, layer.object.w), _e14.xyz, layer.catcher, _e20.xyz, 0u, layer.behind, 0u);
}

// glimt_render_gpu/src/kernels/composite.rs:90
fn exposed(frame: FrameParams, radiance: vec3<f32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/composite.rs:91
    return clamp((radiance * frame.exposure), vec3(0f), vec3(10000000000000000000000000000000000000f));
}

// glimt_render_gpu/src/kernels/film.rs:36
fn displayed(frame_1: FrameParams, colour_1: vec3<f32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/film.rs:37
    let _e7 = ColourMatrix_apply(frame_1.to_display, vec4<f32>(colour_1, 1f));
    return _e7.xyz;
}

// glimt_render_gpu/src/kernels/film.rs:43
fn tone_curve(frame_2: FrameParams, exposed_1: vec3<f32>) -> vec3<f32> {
    var chosen: vec3<f32>;

    // glimt_render_gpu/src/kernels/film.rs:44
    if (frame_2.tonemap == 1u) {
        // glimt_render_gpu/src/kernels/film.rs:45
        chosen = (vec3(1f) - (vec3(1f) / (vec3(1f) + exposed_1)));
    } else {
        // glimt_render_gpu/src/kernels/film.rs:47
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
fn PixelLayers_transmission(this_2: PixelLayers) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/layers.rs:94
    let clear = (1f - this_2.object.w);
    // glimt_render_gpu/src/kernels/layers.rs:95
    if !((clear > 0f)) {
        // glimt_render_gpu/src/kernels/layers.rs:96
        return vec3(1f);
    }
    // glimt_render_gpu/src/kernels/layers.rs:98
    let _e19 = share(this_2.blocked.x, this_2.lit.x);
    let _e24 = share(this_2.blocked.y, this_2.lit.y);
    let _e29 = share(this_2.blocked.z, this_2.lit.z);
    let lost = vec3<f32>(_e19, _e24, _e29);
    // glimt_render_gpu/src/kernels/layers.rs:103
    return max((vec3(1f) - (lost * (this_2.catcher / clear))), vec3(0f));
}

// glimt_render_gpu/src/kernels/composite.rs:96
fn over(frame_3: FrameParams, layer_1: PixelLayers, object: vec3<f32>, behind: vec3<f32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/composite.rs:97
    let clear_1 = (1f - layer_1.object.w);
    // glimt_render_gpu/src/kernels/composite.rs:98
    if (frame_3.shadow == 1u) {
        // glimt_render_gpu/src/kernels/composite.rs:99
        let _e18 = exposed(frame_3, layer_1.blocked);
        return max(((object + (behind * clear_1)) - _e18), vec3(0f));
    }
    // glimt_render_gpu/src/kernels/composite.rs:101
    let _e24 = PixelLayers_transmission(layer_1);
    return (object + (behind * (_e24 * clear_1)));
}

// glimt_render_gpu/src/kernels/film.rs:65
fn srgb_encode(linear: f32) -> f32 {
    var chosen_2: f32;

    // glimt_render_gpu/src/kernels/film.rs:66
    if (linear <= 0.0031308f) {
        // glimt_render_gpu/src/kernels/film.rs:67
        chosen_2 = (12.92f * linear);
    } else {
        // glimt_render_gpu/src/kernels/film.rs:69
        chosen_2 = ((1.055f * pow(linear, (1f / 2.4f))) - 0.055f);
    }
    let _e18 = chosen_2;
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

// glimt_render_gpu/src/kernels/composite.rs:52
fn display_over_plate_1(pixel: u32, frame_4: FrameParams) -> u32 {
    var object_1: vec3<f32>;

    // glimt_render_gpu/src/kernels/composite.rs:58
    let _e6 = layers[pixel];
    let _e7 = PixelLayers_is_plate(_e6);
    if _e7 {
        // glimt_render_gpu/src/kernels/composite.rs:59
        let _e12 = plate[pixel].code;
        return _e12;
    }
    // glimt_render_gpu/src/kernels/composite.rs:61
    let _e17 = layers[pixel];
    let _e18 = in_primaries(frame_4.to_plate, _e17);
    // glimt_render_gpu/src/kernels/composite.rs:62
    let alpha_1 = _e18.object.w;
    // glimt_render_gpu/src/kernels/composite.rs:63
    object_1 = vec3(0f);
    // glimt_render_gpu/src/kernels/composite.rs:64
    if (alpha_1 > 0f) {
        // glimt_render_gpu/src/kernels/composite.rs:65
        let _e34 = exposed(frame_4, (_e18.object.xyz / vec3(alpha_1)));
        // glimt_render_gpu/src/kernels/composite.rs:66
        let _e36 = displayed(frame_4, _e34);
        let _e37 = tone_curve(frame_4, _e36);
        object_1 = (_e37 * alpha_1);
    }
    // glimt_render_gpu/src/kernels/composite.rs:68
    let _e43 = plate[pixel].linear;
    let _e44 = displayed(frame_4, _e43);
    let behind_1 = min(_e44, vec3(1f));
    // glimt_render_gpu/src/kernels/composite.rs:69
    let _e49 = object_1;
    let _e50 = over(frame_4, _e18, _e49, behind_1);
    // glimt_render_gpu/src/kernels/composite.rs:70
    let _e58 = display_code(clamp(_e50, vec3(0f), vec3(1f)), 1f);
    return _e58;
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
