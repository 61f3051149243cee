// Made from Rust by naga-front-rust; do not edit. To make it anew: cargo run --release -p glimt-tests --bin regenerate

struct TexelTaps {
    tap: u32,
    pixel: u32,
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
var<storage> params: Params;

// glimt_probe/src/gather.rs:113
fn weight(tap: u32) -> f32 {

    // glimt_probe/src/gather.rs:114
    return f32(i32((tap & 65535u)));
}

// glimt_probe/src/gather.rs:70
fn ColourMatrix_apply(this_: ColourMatrix, colour: vec4<f32>) -> vec4<f32> {

    // glimt_probe/src/gather.rs:71
    let changed = (((this_.red * colour.x) + (this_.green * colour.y)) + (this_.blue * colour.z));
    // glimt_probe/src/gather.rs:73
    return max(changed, vec4<f32>(0f, 0f, 0f, 1f));
}

// glimt_probe/src/gather.rs:91
fn gather(texel: u32, colour_1: ColourMatrix) -> vec4<f32> {
    var pixel: u32;
    var even: vec4<f32>;
    var odd: vec4<f32>;
    var i: u32;

    // glimt_probe/src/gather.rs:92
    let begin = map_texels[texel];
    // glimt_probe/src/gather.rs:93
    let end = map_texels[(texel + 1u)].tap;
    // glimt_probe/src/gather.rs:94
    // glimt_probe/src/gather.rs:95
    pixel = begin.pixel;
    // glimt_probe/src/gather.rs:97
    even = vec4(0f);
    // glimt_probe/src/gather.rs:98
    odd = vec4(0f);
    // glimt_probe/src/gather.rs:99
    i = 0u;
    // glimt_probe/src/gather.rs:100
    loop {
        let _e32 = i;
        if !(((_e32 + 2u) <= (end - begin.tap))) {
            break;
        }
        // glimt_probe/src/gather.rs:101
        let _e38 = pixel;
        let _e39 = i;
        let _e43 = map_taps[(begin.tap + _e39)];
        let a = (_e38 + (_e43 >> 16u));
        // glimt_probe/src/gather.rs:102
        let _e49 = i;
        let _e55 = map_taps[(begin.tap + (_e49 + 1u))];
        let b = (a + (_e55 >> 16u));
        // glimt_probe/src/gather.rs:103
        let _e63 = pixels[a];
        let _e64 = i;
        let _e68 = map_taps[(begin.tap + _e64)];
        let _e69 = weight(_e68);
        let _e71 = even;
        even = (_e71 + (_e63 * _e69));
        // glimt_probe/src/gather.rs:104
        let _e76 = pixels[b];
        let _e77 = i;
        let _e83 = map_taps[(begin.tap + (_e77 + 1u))];
        let _e84 = weight(_e83);
        let _e86 = odd;
        odd = (_e86 + (_e76 * _e84));
        // glimt_probe/src/gather.rs:105
        pixel = b;
        // glimt_probe/src/gather.rs:106
        let _e91 = i;
        i = (_e91 + 2u);
    }
    // glimt_probe/src/gather.rs:108
    let _e94 = even;
    let _e95 = odd;
    let _e99 = ColourMatrix_apply(colour_1, ((_e94 + _e95) * 0.000015259022f));
    return _e99;
}

// glimt_render_gpu/src/kernels/unwarp.rs:9
fn unwarp_1(texel_1: u32, colour_2: ColourMatrix) -> vec4<f32> {

    // glimt_render_gpu/src/kernels/unwarp.rs:10
    let _e4 = gather(texel_1, colour_2);
    return _e4;
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
    let _e18 = unwarp_1((_e14 + local), _e17);
    out[local] = _e18;
}
