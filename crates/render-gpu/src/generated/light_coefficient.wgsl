// Made from Rust by naga-front-rust; do not edit. This command writes it: cargo run --release -p glimt-generate

struct LightParams {
    rotation: vec2<f32>,
    window: f32,
    temporal: f32,
    bands: u32,
    unused_a: u32,
    unused_b: u32,
    unused_c: u32,
}

struct Tuple_u32_i32_ {
    fa: u32,
    fb: i32,
}

struct Params {
    first: u32,
    count: u32,
    @align(16) light: LightParams,
}

@group(0) @binding(1) 
var<storage> sums: array<vec4<f32>>;
@group(0) @binding(2) 
var<storage> previous: array<vec4<f32>>;
@group(0) @binding(3) 
var<storage, read_write> out: array<vec4<f32>>;
@group(0) @binding(0) 
var<uniform> params: Params;

// glimt_sh/src/basis.rs:50
fn coefficient_band(k: u32) -> u32 {
    var l: u32;

    // glimt_sh/src/basis.rs:51
    l = 0u;
    // glimt_sh/src/basis.rs:52
    loop {
        let _e6 = l;
        let _e9 = l;
        let _e12 = l;
        if ((_e6 < 5u) && (k >= ((_e9 + 1u) * (_e12 + 1u)))) {
            // glimt_sh/src/basis.rs:53
            let _e20 = l;
            l = (_e20 + 1u);
        } else {
            break;
        }
    }
    // glimt_sh/src/basis.rs:55
    let _e23 = l;
    return _e23;
}

// glimt_sh/src/basis.rs:66
fn coefficient_order(k_1: u32) -> i32 {

    // glimt_sh/src/basis.rs:67
    let _e3 = coefficient_band(k_1);
    // glimt_sh/src/basis.rs:68
    return (i32(k_1) - i32((_e3 * (_e3 + 1u))));
}

// glimt_sh/src/basis.rs:38
fn coefficient_index(l_1: u32, m: i32) -> u32 {

    // glimt_sh/src/basis.rs:39
    return u32((i32((l_1 * (l_1 + 1u))) + m));
}

// glimt_sh/src/basis.rs:132
fn turn(p: vec2<f32>, x: f32, y: f32) -> vec2<f32> {

    // glimt_sh/src/basis.rs:133
    return vec2<f32>(((p.x * x) - (p.y * y)), ((p.x * y) + (p.y * x)));
}

// glimt_sh/src/filter.rs:88
fn rotate_z(m_1: i32, own: f32, opposite: f32, angle: vec2<f32>) -> f32 {
    var whole: vec2<f32>;
    var counter: i32;
    var chosen: f32;

    // glimt_sh/src/filter.rs:89
    whole = vec2<f32>(1f, 0f);
    // glimt_sh/src/filter.rs:90
    counter = 0i;
    loop {
        let _e14 = counter;
        if (_e14 >= abs(m_1)) {
            break;
        }
        // glimt_sh/src/filter.rs:91
        let _e17 = whole;
        let _e20 = turn(_e17, angle.x, angle.y);
        whole = _e20;
        continuing {
            let _e21 = counter;
            counter = (_e21 + 1i);
        }
    }
    // glimt_sh/src/filter.rs:93
    if (m_1 > 0i) {
        // glimt_sh/src/filter.rs:94
        let _e30 = whole.x;
        let _e33 = whole.y;
        chosen = ((own * _e30) - (opposite * _e33));
    } else {
        // glimt_sh/src/filter.rs:96
        let _e38 = whole.x;
        let _e41 = whole.y;
        chosen = ((own * _e38) + (opposite * _e41));
    }
    let _e44 = chosen;
    return _e44;
}

// glimt_sh/src/filter.rs:19
fn hann(l_2: u32, window: f32) -> f32 {
    var chosen_1: f32;
    var chosen_2: f32;

    // glimt_sh/src/filter.rs:20
    let l_3 = f32(l_2);
    // glimt_sh/src/filter.rs:21
    if !((window > 0f)) {
        // glimt_sh/src/filter.rs:22
        chosen_1 = 1f;
    } else {
        if (l_3 < window) {
            // glimt_sh/src/filter.rs:24
            chosen_2 = (0.5f + (0.5f * cos(((3.1415927f * l_3) / window))));
        } else {
            // glimt_sh/src/filter.rs:26
            chosen_2 = 0f;
        }
        let _e25 = chosen_2;
        chosen_1 = _e25;
    }
    let _e26 = chosen_1;
    return _e26;
}

// glimt_sh/src/filter.rs:68
fn temporal_filter(current: f32, before: f32, alpha: f32) -> f32 {

    // glimt_sh/src/filter.rs:69
    if !((alpha > 0f)) {
        // glimt_sh/src/filter.rs:70
        return current;
    }
    // glimt_sh/src/filter.rs:72
    return (before + ((current - before) / (1f + alpha)));
}

// glimt_render_gpu/src/kernels/light_sh.rs:31
fn light_coefficient_1(k_2: u32, light: LightParams) -> vec4<f32> {

    // glimt_render_gpu/src/kernels/light_sh.rs:32
    if (k_2 >= (light.bands * light.bands)) {
        // glimt_render_gpu/src/kernels/light_sh.rs:33
        return vec4(0f);
    }
    // glimt_render_gpu/src/kernels/light_sh.rs:36
    let _e12 = coefficient_band(k_2);
    let _e13 = coefficient_order(k_2);
    let _e14 = Tuple_u32_i32_(_e12, _e13);
    let l_4 = _e14.fa;
    let m_2 = _e14.fb;
    // glimt_render_gpu/src/kernels/light_sh.rs:37
    let own_1 = sums[k_2];
    // glimt_render_gpu/src/kernels/light_sh.rs:38
    let _e23 = coefficient_index(l_4, -(m_2));
    let opposite_1 = sums[_e23];
    // glimt_render_gpu/src/kernels/light_sh.rs:39
    let _e31 = rotate_z(m_2, own_1.x, opposite_1.x, light.rotation);
    let _e35 = rotate_z(m_2, own_1.y, opposite_1.y, light.rotation);
    let _e39 = rotate_z(m_2, own_1.z, opposite_1.z, light.rotation);
    let turned = vec3<f32>(_e31, _e35, _e39);
    // glimt_render_gpu/src/kernels/light_sh.rs:44
    let _e43 = hann(l_4, light.window);
    let now = (turned * _e43);
    // glimt_render_gpu/src/kernels/light_sh.rs:45
    let before_1 = previous[k_2];
    // glimt_render_gpu/src/kernels/light_sh.rs:46
    let _e53 = temporal_filter(now.x, before_1.x, light.temporal);
    let _e57 = temporal_filter(now.y, before_1.y, light.temporal);
    let _e61 = temporal_filter(now.z, before_1.z, light.temporal);
    return vec4<f32>(_e53, _e57, _e61, 0f);
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
