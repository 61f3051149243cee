// Made from Rust by naga-front-rust; do not edit. To make it anew: cargo run --release -p glimt-tests --bin regenerate

struct LightParams {
    rotation: vec2<f32>,
    window: f32,
    temporal: f32,
    bands: u32,
    unused_a: u32,
    unused_b: u32,
    unused_c: u32,
}

struct Tuple_f32_f32_ {
    fa: f32,
    fb: f32,
}

struct Params {
    first: u32,
    count: u32,
    light: LightParams,
}

@group(0) @binding(1) 
var<storage> sums: array<vec4<f32>>;
@group(0) @binding(2) 
var<storage> previous: array<vec4<f32>>;
@group(0) @binding(3) 
var<storage, read_write> out: array<vec4<f32>>;
@group(0) @binding(0) 
var<storage> params: Params;

// glimt_sh/src/basis.rs:105
fn turn(p: vec2<f32>, x: f32, y: f32) -> vec2<f32> {

    // glimt_sh/src/basis.rs:106
    return vec2<f32>(((p.x * x) - (p.y * y)), ((p.x * y) + (p.y * x)));
}

// glimt_sh/src/separable.rs:56
fn ring(x_1: f32, y_1: f32) -> array<f32, 11> {

    // glimt_sh/src/separable.rs:57
    let p1_ = vec2<f32>(x_1, y_1);
    // glimt_sh/src/separable.rs:58
    let _e6 = turn(p1_, x_1, y_1);
    // glimt_sh/src/separable.rs:59
    let _e8 = turn(_e6, x_1, y_1);
    // glimt_sh/src/separable.rs:60
    let _e10 = turn(_e8, x_1, y_1);
    // glimt_sh/src/separable.rs:61
    let _e12 = turn(_e10, x_1, y_1);
    // glimt_sh/src/separable.rs:62
    return array<f32, 11>(1f, x_1, y_1, _e6.x, _e6.y, _e8.x, _e8.y, _e10.x, _e10.y, _e12.x, _e12.y);
}

// glimt_sh/src/basis.rs:267
fn hann(l: u32, window: f32) -> f32 {
    var chosen: f32;
    var chosen_1: f32;

    // glimt_sh/src/basis.rs:268
    let l_2 = f32(l);
    // glimt_sh/src/basis.rs:269
    if !((window > 0f)) {
        // glimt_sh/src/basis.rs:270
        chosen = 1f;
    } else {
        if (l_2 < window) {
            // glimt_sh/src/basis.rs:272
            chosen_1 = (0.5f + (0.5f * cos(((3.1415927f * l_2) / window))));
        } else {
            // glimt_sh/src/basis.rs:274
            chosen_1 = 0f;
        }
        let _e25 = chosen_1;
        chosen = _e25;
    }
    let _e26 = chosen;
    return _e26;
}

// glimt_render_gpu/src/kernels/light_sh.rs:55
fn light_coefficient_1(k: u32, light: LightParams) -> vec4<f32> {
    var l_1: u32;
    var turn_1: array<f32, 11>;
    var value: vec4<f32>;

    // glimt_render_gpu/src/kernels/light_sh.rs:56
    if (k >= (light.bands * light.bands)) {
        // glimt_render_gpu/src/kernels/light_sh.rs:57
        return vec4(0f);
    }
    // glimt_render_gpu/src/kernels/light_sh.rs:59
    l_1 = 0u;
    // glimt_render_gpu/src/kernels/light_sh.rs:60
    loop {
        let _e15 = l_1;
        let _e18 = l_1;
        if !((((_e15 + 1u) * (_e18 + 1u)) <= k)) {
            break;
        }
        // glimt_render_gpu/src/kernels/light_sh.rs:61
        let _e26 = l_1;
        l_1 = (_e26 + 1u);
    }
    // glimt_render_gpu/src/kernels/light_sh.rs:64
    let _e29 = l_1;
    let _e30 = l_1;
    let centre = (_e29 * (_e30 + 1u));
    // glimt_render_gpu/src/kernels/light_sh.rs:65
    let _e39 = ring(light.rotation.x, light.rotation.y);
    turn_1 = _e39;
    // glimt_render_gpu/src/kernels/light_sh.rs:66
    let _e44 = sums[k];
    value = _e44;
    // glimt_render_gpu/src/kernels/light_sh.rs:67
    if (k > centre) {
        // glimt_render_gpu/src/kernels/light_sh.rs:68
        let m = (k - centre);
        // glimt_render_gpu/src/kernels/light_sh.rs:69
        let _e56 = turn_1[((2u * m) - 1u)];
        let _e60 = turn_1[(2u * m)];
        let _e61 = Tuple_f32_f32_(_e56, _e60);
        let c = _e61.fa;
        let s = _e61.fb;
        // glimt_render_gpu/src/kernels/light_sh.rs:70
        let _e65 = value;
        let _e70 = sums[(centre - m)];
        value = ((_e65 * c) - (_e70 * s));
    }
    // glimt_render_gpu/src/kernels/light_sh.rs:72
    if (k < centre) {
        // glimt_render_gpu/src/kernels/light_sh.rs:73
        let m_1 = (centre - k);
        // glimt_render_gpu/src/kernels/light_sh.rs:74
        let _e83 = turn_1[((2u * m_1) - 1u)];
        let _e87 = turn_1[(2u * m_1)];
        let _e88 = Tuple_f32_f32_(_e83, _e87);
        let c_1 = _e88.fa;
        let s_1 = _e88.fb;
        // glimt_render_gpu/src/kernels/light_sh.rs:75
        let _e92 = value;
        let _e97 = sums[(centre + m_1)];
        value = ((_e92 * c_1) + (_e97 * s_1));
    }
    // glimt_render_gpu/src/kernels/light_sh.rs:77
    let _e101 = l_1;
    let _e103 = hann(_e101, light.window);
    let _e104 = value;
    value = (_e104 * _e103);
    // glimt_render_gpu/src/kernels/light_sh.rs:78
    if (light.temporal > 0f) {
        // glimt_render_gpu/src/kernels/light_sh.rs:79
        let _e111 = value;
        let _e114 = previous[k];
        value = ((_e111 + (_e114 * light.temporal)) / vec4((1f + light.temporal)));
    }
    // glimt_render_gpu/src/kernels/light_sh.rs:81
    let _e124 = value;
    return vec4<f32>(_e124.xyz, 0f);
}

@compute @workgroup_size(64, 1, 1) 
fn light_coefficient(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let local = ((id.y * (groups.x * 64u)) + id.x);
    let _e11 = params.count;
    if (local >= _e11) {
        return;
    }
    let _e14 = params.first;
    let _e17 = params.light;
    let _e18 = light_coefficient_1((_e14 + local), _e17);
    out[local] = _e18;
}
