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
var<storage, read_write> out: array<vec4<f32>>;
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
    let object_1 = _e5.xyz;
    // glimt_render_gpu/src/kernels/composite.rs:77
    let _e14 = ColourMatrix_apply(matrix, vec4<f32>(layer.lit, 1f));
    let _e20 = ColourMatrix_apply(matrix, vec4<f32>(layer.blocked, 1f));
    return PixelLayers(vec4<f32>(object_1, layer.object.w), _e14.xyz, layer.catcher, _e20.xyz, 0u, layer.behind, 0u);
}

// glimt_render_gpu/src/kernels/composite.rs:90
fn exposed(frame: FrameParams, radiance: vec3<f32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/composite.rs:91
    return clamp((radiance * frame.exposure), vec3(0f), vec3(10000000000000000000000000000000000000f));
}

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
fn over(frame_1: FrameParams, layer_1: PixelLayers, object: vec3<f32>, behind: vec3<f32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/composite.rs:97
    let clear_1 = (1f - layer_1.object.w);
    // glimt_render_gpu/src/kernels/composite.rs:98
    if (frame_1.shadow == 1u) {
        // glimt_render_gpu/src/kernels/composite.rs:99
        let _e18 = exposed(frame_1, layer_1.blocked);
        return max(((object + (behind * clear_1)) - _e18), vec3(0f));
    }
    // glimt_render_gpu/src/kernels/composite.rs:101
    let _e24 = PixelLayers_transmission(layer_1);
    return (object + (behind * (_e24 * clear_1)));
}

// glimt_render_gpu/src/kernels/composite.rs:27
fn composite_over_plate_1(pixel: u32, frame_2: FrameParams) -> vec4<f32> {

    // glimt_render_gpu/src/kernels/composite.rs:33
    let behind_1 = plate[pixel].linear;
    // glimt_render_gpu/src/kernels/composite.rs:34
    let _e11 = layers[pixel];
    let _e12 = PixelLayers_is_plate(_e11);
    if _e12 {
        // glimt_render_gpu/src/kernels/composite.rs:35
        return vec4<f32>(behind_1, 1f);
    }
    // glimt_render_gpu/src/kernels/composite.rs:37
    let _e20 = layers[pixel];
    let _e21 = in_primaries(frame_2.to_plate, _e20);
    // glimt_render_gpu/src/kernels/composite.rs:38
    let _e25 = exposed(frame_2, _e21.object.xyz);
    let _e26 = over(frame_2, _e21, _e25, behind_1);
    return vec4<f32>(_e26, 1f);
}

@compute @workgroup_size(64, 1, 1) 
fn composite_over_plate(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let local = ((id.y * (groups.x * 64u)) + id.x);
    let _e11 = params.count;
    if (local >= _e11) {
        return;
    }
    let _e14 = params.first;
    let _e17 = params.frame;
    let _e18 = composite_over_plate_1((_e14 + local), _e17);
    out[local] = _e18;
}
