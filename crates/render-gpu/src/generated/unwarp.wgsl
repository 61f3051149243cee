// Made from Rust by naga-front-rust; do not edit. This command writes it: cargo run --release -p glimt-tests --bin regenerate

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
    // glimt_probe/src/gather.rs:110
    pixel = begin.pixel;
    // glimt_probe/src/gather.rs:112
    even = vec4(0f);
    // glimt_probe/src/gather.rs:113
    odd = vec4(0f);
    // glimt_probe/src/gather.rs:114
    i = 0u;
    // glimt_probe/src/gather.rs:115
    loop {
        let _e33 = i;
        if !(((_e33 + 2u) <= (end - begin.tap))) {
            break;
        }
        // glimt_probe/src/gather.rs:116
        let _e39 = pixel;
        let _e40 = i;
        let _e44 = map_taps[(begin.tap + _e40)];
        let a = (_e39 + (_e44 >> 16u));
        // glimt_probe/src/gather.rs:117
        let _e49 = i;
        let _e55 = map_taps[(begin.tap + (_e49 + 1u))];
        let b = (a + (_e55 >> 16u));
        // glimt_probe/src/gather.rs:118
        let _e62 = pixels[a];
        let _e63 = i;
        let _e67 = map_taps[(begin.tap + _e63)];
        let _e68 = weight(_e67);
        let _e70 = even;
        even = (_e70 + (_e62 * _e68));
        // glimt_probe/src/gather.rs:119
        let _e75 = pixels[b];
        let _e76 = i;
        let _e82 = map_taps[(begin.tap + (_e76 + 1u))];
        let _e83 = weight(_e82);
        let _e85 = odd;
        odd = (_e85 + (_e75 * _e83));
        // glimt_probe/src/gather.rs:120
        pixel = b;
        // glimt_probe/src/gather.rs:121
        let _e90 = i;
        i = (_e90 + 2u);
    }
    // glimt_probe/src/gather.rs:123
    let reflected = (reflectance + ((vec4(1f) - reflectance) * begin.grazing));
    // glimt_probe/src/gather.rs:124
    let _e100 = even;
    let _e101 = odd;
    let _e106 = ColourMatrix_apply(colour_1, (((_e100 + _e101) * 0.000015259022f) / reflected));
    return _e106;
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
