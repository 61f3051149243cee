// Made from Rust by naga-front-rust; do not edit. This command writes it: cargo run --release -p glimt-generate

struct TexelTaps {
    tap: u32,
    pixel: u32,
    grazing: f32,
}

struct ColourMatrix {
    red: vec4<f32>,
    green: vec4<f32>,
    blue: vec4<f32>,
}

struct Tuple_u32_u32_ {
    fa: u32,
    fb: u32,
}

struct Params {
    first: u32,
    count: u32,
    colour: ColourMatrix,
    reflectance: vec4<f32>,
}

@group(0) @binding(1) 
var<storage> map_texels: array<TexelTaps>;
@group(0) @binding(2) 
var<storage> map_taps: array<u32>;
@group(0) @binding(3) 
var<storage> pixels: array<vec4<f32>>;
@group(0) @binding(4) 
var<storage, read_write> out: array<vec4<f32>>;
@group(0) @binding(0) 
var<uniform> params: Params;

// glimt_probe/src/gather.rs:129
fn weight(tap: u32) -> f32 {

    // glimt_probe/src/gather.rs:130
    return f32(i32((tap & 65535u)));
}

// glimt_probe/src/gather.rs:72
fn ColourMatrix_apply(this_: ColourMatrix, colour: vec4<f32>) -> vec4<f32> {

    // glimt_probe/src/gather.rs:73
    let changed = (((this_.red * colour.x) + (this_.green * colour.y)) + (this_.blue * colour.z));
    // glimt_probe/src/gather.rs:75
    return max(changed, vec4<f32>(0f, 0f, 0f, 1f));
}

// glimt_probe/src/gather.rs:100
fn gather(texel: u32, colour_1: ColourMatrix, reflectance: vec4<f32>) -> vec4<f32> {
    var pixel: u32;
    var even: vec4<f32>;
    var odd: vec4<f32>;
    var i: u32;

    // glimt_probe/src/gather.rs:107
    let begin = map_texels[texel];
    // glimt_probe/src/gather.rs:108
    let end = map_texels[(texel + 1u)].tap;
    // glimt_probe/src/gather.rs:109
    pixel = begin.pixel;
    // glimt_probe/src/gather.rs:111
    even = vec4(0f);
    // glimt_probe/src/gather.rs:112
    odd = vec4(0f);
    // glimt_probe/src/gather.rs:113
    i = begin.tap;
    // glimt_probe/src/gather.rs:114
    loop {
        let _e30 = i;
        if !(((_e30 + 2u) <= end)) {
            break;
        }
        // glimt_probe/src/gather.rs:115
        let _e36 = i;
        let _e39 = map_taps[_e36];
        let _e40 = i;
        let _e45 = map_taps[(_e40 + 1u)];
        let _e46 = Tuple_u32_u32_(_e39, _e45);
        let tap_a = _e46.fa;
        let tap_b = _e46.fb;
        // glimt_probe/src/gather.rs:116
        let _e50 = pixel;
        let a = (_e50 + (tap_a >> 16u));
        // glimt_probe/src/gather.rs:117
        let b = (a + (tap_b >> 16u));
        // glimt_probe/src/gather.rs:118
        let _e61 = pixels[a];
        let _e62 = weight(tap_a);
        let _e64 = even;
        even = (_e64 + (_e61 * _e62));
        // glimt_probe/src/gather.rs:119
        let _e69 = pixels[b];
        let _e70 = weight(tap_b);
        let _e72 = odd;
        odd = (_e72 + (_e69 * _e70));
        // glimt_probe/src/gather.rs:120
        pixel = b;
        // glimt_probe/src/gather.rs:121
        let _e77 = i;
        i = (_e77 + 2u);
    }
    // glimt_probe/src/gather.rs:123
    let reflected = (reflectance + ((vec4(1f) - reflectance) * begin.grazing));
    // glimt_probe/src/gather.rs:124
    let _e87 = even;
    let _e88 = odd;
    let _e93 = ColourMatrix_apply(colour_1, (((_e87 + _e88) * 0.000015259022f) / reflected));
    return _e93;
}

// glimt_render_gpu/src/kernels/unwarp.rs:9
fn unwarp_1(texel_1: u32, colour_2: ColourMatrix, reflectance_1: vec4<f32>) -> vec4<f32> {

    // glimt_render_gpu/src/kernels/unwarp.rs:16
    let _e5 = gather(texel_1, colour_2, reflectance_1);
    return _e5;
}

@compute @workgroup_size(64, 1, 1) 
fn unwarp(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let local = ((id.y * (groups.x * 64u)) + id.x);
    let _e11 = params.count;
    if (local >= _e11) {
        return;
    }
    let _e14 = params.first;
    let _e17 = params.colour;
    let _e19 = params.reflectance;
    let _e20 = unwarp_1((_e14 + local), _e17, _e19);
    out[local] = _e20;
}
