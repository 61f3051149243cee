// Made from Rust by naga-front-rust; do not edit. This command writes it: cargo run --release -p glimt-generate

struct SensorParams {
    longest_gain: f32,
    step: f32,
    exposures: u32,
    full_well: f32,
    read_noise: f32,
    electrons_per_code: f32,
    seed: u32,
    frame: u32,
    unused_a: u32,
    unused_b: u32,
    unused_c: u32,
    unused_d: u32,
}

struct Xoshiro128PlusPlus {
    state: vec4<u32>,
}

struct Params {
    first: u32,
    count: u32,
    @align(16) sensor: SensorParams,
}

@group(0) @binding(1) 
var<storage> radiance_1: array<vec4<f32>>;
@group(0) @binding(2) 
var<storage, read_write> out: array<vec4<f32>>;
@group(0) @binding(0) 
var<uniform> params: Params;

// glimt_sampling/src/hash.rs:15
fn hash_u32_(n: u32) -> u32 {
    var x: u32;

    // glimt_sampling/src/hash.rs:16
    x = (n ^ 3875421163u);
    // glimt_sampling/src/hash.rs:17
    let _e7 = x;
    let _e10 = x;
    x = (_e10 ^ (_e7 >> 16u));
    // glimt_sampling/src/hash.rs:18
    let _e13 = x;
    x = (_e13 * 2146121005u);
    // glimt_sampling/src/hash.rs:19
    let _e17 = x;
    let _e20 = x;
    x = (_e20 ^ (_e17 >> 15u));
    // glimt_sampling/src/hash.rs:20
    let _e23 = x;
    x = (_e23 * 2221713035u);
    // glimt_sampling/src/hash.rs:21
    let _e27 = x;
    let _e28 = x;
    return (_e27 ^ (_e28 >> 16u));
}

// glimt_sampling/src/hash.rs:27
fn hash2_(a: u32, b: u32) -> u32 {

    // glimt_sampling/src/hash.rs:28
    let _e4 = hash_u32_(a);
    let _e6 = hash_u32_((_e4 + b));
    return _e6;
}

// glimt_sampling/src/hash.rs:50
fn hash_uvec4_(v: vec4<u32>) -> vec4<u32> {
    var x_1: u32;
    var y: u32;
    var z: u32;
    var w: u32;

    // glimt_sampling/src/hash.rs:51
    let _e4 = hash_u32_(v.x);
    x_1 = ((_e4 * 1664525u) + 1013904223u);
    // glimt_sampling/src/hash.rs:54
    let _e12 = hash_u32_(v.y);
    y = ((_e12 * 1664525u) + 1013904223u);
    // glimt_sampling/src/hash.rs:57
    let _e20 = hash_u32_(v.z);
    z = ((_e20 * 1664525u) + 1013904223u);
    // glimt_sampling/src/hash.rs:60
    let _e28 = hash_u32_(v.w);
    w = ((_e28 * 1664525u) + 1013904223u);
    // glimt_sampling/src/hash.rs:64
    let _e35 = x_1;
    let _e36 = y;
    let _e37 = w;
    x_1 = (_e35 + (_e36 * _e37));
    // glimt_sampling/src/hash.rs:65
    let _e41 = y;
    let _e42 = z;
    let _e43 = x_1;
    y = (_e41 + (_e42 * _e43));
    // glimt_sampling/src/hash.rs:66
    let _e47 = z;
    let _e48 = x_1;
    let _e49 = y;
    z = (_e47 + (_e48 * _e49));
    // glimt_sampling/src/hash.rs:67
    let _e53 = w;
    let _e54 = y;
    let _e55 = z;
    w = (_e53 + (_e54 * _e55));
    // glimt_sampling/src/hash.rs:68
    let _e59 = x_1;
    let _e62 = x_1;
    x_1 = (_e62 ^ (_e59 >> 16u));
    // glimt_sampling/src/hash.rs:69
    let _e65 = y;
    let _e68 = y;
    y = (_e68 ^ (_e65 >> 16u));
    // glimt_sampling/src/hash.rs:70
    let _e71 = z;
    let _e74 = z;
    z = (_e74 ^ (_e71 >> 16u));
    // glimt_sampling/src/hash.rs:71
    let _e77 = w;
    let _e80 = w;
    w = (_e80 ^ (_e77 >> 16u));
    // glimt_sampling/src/hash.rs:72
    let _e83 = x_1;
    let _e84 = y;
    let _e85 = w;
    x_1 = (_e83 + (_e84 * _e85));
    // glimt_sampling/src/hash.rs:73
    let _e89 = y;
    let _e90 = z;
    let _e91 = x_1;
    y = (_e89 + (_e90 * _e91));
    // glimt_sampling/src/hash.rs:74
    let _e95 = z;
    let _e96 = x_1;
    let _e97 = y;
    z = (_e95 + (_e96 * _e97));
    // glimt_sampling/src/hash.rs:75
    let _e101 = w;
    let _e102 = y;
    let _e103 = z;
    w = (_e101 + (_e102 * _e103));
    // glimt_sampling/src/hash.rs:76
    let _e107 = x_1;
    let _e108 = x_1;
    let _e112 = y;
    let _e113 = y;
    let _e117 = z;
    let _e118 = z;
    let _e122 = w;
    let _e123 = w;
    return vec4<u32>((_e107 ^ (_e108 >> 16u)), (_e112 ^ (_e113 >> 16u)), (_e117 ^ (_e118 >> 16u)), (_e122 ^ (_e123 >> 16u)));
}

// glimt_sampling/src/xoshiro.rs:28
fn Xoshiro128PlusPlus_from_state(state: vec4<u32>) -> Xoshiro128PlusPlus {

    // glimt_sampling/src/xoshiro.rs:29
    let any_ = (((state.x | state.y) | state.z) | state.w);
    // glimt_sampling/src/xoshiro.rs:30
    if (any_ == 0u) {
        // glimt_sampling/src/xoshiro.rs:31
        return Xoshiro128PlusPlus(vec4<u32>(2065550767u, 3793791033u, 2713282036u, 1853398634u));
    }
    // glimt_sampling/src/xoshiro.rs:35
    return Xoshiro128PlusPlus(state);
}

// glimt_sampling/src/xoshiro.rs:49
fn Xoshiro128PlusPlus_stream(seed: u32, frame: u32, pixel: u32) -> Xoshiro128PlusPlus {

    // glimt_sampling/src/xoshiro.rs:50
    let _e7 = hash_uvec4_(vec4<u32>(pixel, frame, seed, 2654435769u));
    let _e8 = Xoshiro128PlusPlus_from_state(_e7);
    return _e8;
}

// glimt_sampling/src/xoshiro.rs:56
fn Xoshiro128PlusPlus_next_u32_(this_: ptr<function, Xoshiro128PlusPlus>) -> u32 {

    // glimt_sampling/src/xoshiro.rs:57
    let s = (*this_).state;
    // glimt_sampling/src/xoshiro.rs:58
    let _e8 = (s.x + s.w);
    let result = (((_e8 << 7u) | (_e8 >> ((0u - 7u) & 31u))) + s.x);
    // glimt_sampling/src/xoshiro.rs:59
    let z_1 = (s.z ^ s.x);
    // glimt_sampling/src/xoshiro.rs:60
    let w_1 = (s.w ^ s.y);
    // glimt_sampling/src/xoshiro.rs:61
    (*this_).state = vec4<u32>((s.x ^ w_1), (s.y ^ z_1), (z_1 ^ (s.y << 9u)), ((w_1 << 11u) | (w_1 >> ((0u - 11u) & 31u))));
    // glimt_sampling/src/xoshiro.rs:62
    return result;
}

// glimt_sampling/src/uniform.rs:34
fn Xoshiro128PlusPlus_next_uvec2_(this_1: ptr<function, Xoshiro128PlusPlus>) -> vec2<u32> {

    // glimt_sampling/src/uniform.rs:35
    let _e3 = Xoshiro128PlusPlus_next_u32_(this_1);
    // glimt_sampling/src/uniform.rs:36
    let _e5 = Xoshiro128PlusPlus_next_u32_(this_1);
    // glimt_sampling/src/uniform.rs:37
    return vec2<u32>(_e3, _e5);
}

// glimt_sampling/src/uniform.rs:15
fn unit_f32_(u: u32) -> f32 {

    // glimt_sampling/src/uniform.rs:16
    return (f32((u >> 8u)) * (1f / 16777216f));
}

// glimt_probe/src/trig.rs:25
fn cos_sin_pi(x_2: f32) -> vec2<f32> {
    var chosen: vec2<f32>;

    // glimt_probe/src/trig.rs:27
    let quarter = floor(((2f * x_2) + 0.5f));
    // glimt_probe/src/trig.rs:28
    let y_1 = (x_2 - (0.5f * quarter));
    // glimt_probe/src/trig.rs:29
    let y2_ = (y_1 * y_1);
    // glimt_probe/src/trig.rs:31
    let c = (1f + (y2_ * (-4.934802f + (y2_ * (4.058712f + (y2_ * (-1.3352627f + (y2_ * (0.23533063f + (y2_ * -0.02580689f))))))))));
    // glimt_probe/src/trig.rs:34
    let s_1 = (y_1 * (3.1415927f + (y2_ * (-5.1677127f + (y2_ * (2.550164f + (y2_ * (-0.5992645f + (y2_ * 0.082145885f)))))))));
    // glimt_probe/src/trig.rs:37
    let _e49 = (i32(quarter) & 3i);
    if (_e49 == 0i) {
        // glimt_probe/src/trig.rs:38
        chosen = vec2<f32>(c, (s_1 + 0f));
    } else {
        if (_e49 == 1i) {
            // glimt_probe/src/trig.rs:39
            chosen = vec2<f32>((0f - s_1), c);
        } else {
            if (_e49 == 2i) {
                // glimt_probe/src/trig.rs:40
                chosen = vec2<f32>((0f - c), (0f - s_1));
            } else {
                // glimt_probe/src/trig.rs:41
                chosen = vec2<f32>((s_1 + 0f), (0f - c));
            }
        }
    }
    let _e77 = chosen;
    return _e77;
}

// glimt_render_gpu/src/kernels/sensor.rs:111
fn draw_normal(source: ptr<function, Xoshiro128PlusPlus>) -> f32 {

    // glimt_render_gpu/src/kernels/sensor.rs:112
    let _e3 = Xoshiro128PlusPlus_next_uvec2_(source);
    // glimt_render_gpu/src/kernels/sensor.rs:114
    let _e7 = unit_f32_(_e3.x);
    let radius = sqrt((-2f * log((_e7 + 0.00000003f))));
    // glimt_render_gpu/src/kernels/sensor.rs:115
    let _e16 = unit_f32_(_e3.y);
    let _e20 = cos_sin_pi(((2f * _e16) - 1f));
    return (radius * _e20.x);
}

// glimt_render_gpu/src/kernels/sensor.rs:120
fn draw_poisson(mean: f32, source_1: ptr<function, Xoshiro128PlusPlus>) -> f32 {
    var probability: f32;
    var cumulated: f32;
    var n_1: f32;

    // glimt_render_gpu/src/kernels/sensor.rs:121
    let _e4 = Xoshiro128PlusPlus_next_u32_(source_1);
    let _e5 = unit_f32_(_e4);
    // glimt_render_gpu/src/kernels/sensor.rs:122
    probability = exp(-(mean));
    // glimt_render_gpu/src/kernels/sensor.rs:123
    let _e11 = probability;
    cumulated = _e11;
    // glimt_render_gpu/src/kernels/sensor.rs:124
    n_1 = 0f;
    // glimt_render_gpu/src/kernels/sensor.rs:126
    loop {
        let _e17 = cumulated;
        let _e19 = n_1;
        if ((_e5 >= _e17) && (_e19 < 150f)) {
            // glimt_render_gpu/src/kernels/sensor.rs:127
            let _e25 = n_1;
            n_1 = (_e25 + 1f);
            // glimt_render_gpu/src/kernels/sensor.rs:128
            let _e28 = n_1;
            let _e30 = probability;
            probability = (_e30 * (mean / _e28));
            // glimt_render_gpu/src/kernels/sensor.rs:129
            let _e33 = probability;
            let _e34 = cumulated;
            cumulated = (_e34 + _e33);
        } else {
            break;
        }
    }
    // glimt_render_gpu/src/kernels/sensor.rs:131
    let _e37 = n_1;
    return _e37;
}

// glimt_render_gpu/src/kernels/sensor.rs:97
fn SensorParams_read(this_2: SensorParams, mean_1: f32, source_2: ptr<function, Xoshiro128PlusPlus>) -> f32 {
    var chosen_1: f32;

    // glimt_render_gpu/src/kernels/sensor.rs:98
    let _e5 = draw_normal(source_2);
    // glimt_render_gpu/src/kernels/sensor.rs:99
    if (mean_1 < 50f) {
        // glimt_render_gpu/src/kernels/sensor.rs:100
        let _e11 = draw_poisson(mean_1, source_2);
        chosen_1 = (_e11 + (this_2.read_noise * _e5));
    } else {
        // glimt_render_gpu/src/kernels/sensor.rs:102
        chosen_1 = (mean_1 + (sqrt((mean_1 + (this_2.read_noise * this_2.read_noise))) * _e5));
    }
    let electrons = chosen_1;
    // glimt_render_gpu/src/kernels/sensor.rs:104
    let clipped = clamp(electrons, -(this_2.full_well), this_2.full_well);
    // glimt_render_gpu/src/kernels/sensor.rs:105
    return (floor(((clipped / this_2.electrons_per_code) + 0.5f)) * this_2.electrons_per_code);
}

// glimt_render_gpu/src/kernels/sensor.rs:71
fn SensorParams_fuse(this_3: SensorParams, radiance: f32, source_3: ptr<function, Xoshiro128PlusPlus>) -> f32 {
    var sum: f32;
    var weights: f32;
    var relative_gain: f32;
    var counter: u32;

    // glimt_render_gpu/src/kernels/sensor.rs:72
    let step_variance = ((this_3.electrons_per_code * this_3.electrons_per_code) / 12f);
    // glimt_render_gpu/src/kernels/sensor.rs:73
    let floor_variance = ((this_3.read_noise * this_3.read_noise) + step_variance);
    // glimt_render_gpu/src/kernels/sensor.rs:74
    sum = 0f;
    // glimt_render_gpu/src/kernels/sensor.rs:75
    weights = 0f;
    // glimt_render_gpu/src/kernels/sensor.rs:76
    relative_gain = 1f;
    // glimt_render_gpu/src/kernels/sensor.rs:77
    counter = 0u;
    loop {
        let i = counter;
        if (i >= this_3.exposures) {
            break;
        }
        // glimt_render_gpu/src/kernels/sensor.rs:78
        let _e32 = relative_gain;
        let gain = (this_3.longest_gain * _e32);
        // glimt_render_gpu/src/kernels/sensor.rs:79
        let mean_2 = (radiance * gain);
        // glimt_render_gpu/src/kernels/sensor.rs:80
        let variance = (mean_2 + floor_variance);
        // glimt_render_gpu/src/kernels/sensor.rs:81
        let fits = ((mean_2 + (5f * sqrt(variance))) < this_3.full_well);
        // glimt_render_gpu/src/kernels/sensor.rs:82
        if (fits || ((i + 1u) == this_3.exposures)) {
            // glimt_render_gpu/src/kernels/sensor.rs:83
            let _e52 = relative_gain;
            let _e53 = relative_gain;
            let weight = ((_e52 * _e53) / max(variance, 0.000000000001f));
            // glimt_render_gpu/src/kernels/sensor.rs:84
            let _e60 = weights;
            if (weight < (0.02f * _e60)) {
                // glimt_render_gpu/src/kernels/sensor.rs:85
                break;
            }
            // glimt_render_gpu/src/kernels/sensor.rs:87
            let _e65 = SensorParams_read(this_3, mean_2, source_3);
            let _e68 = sum;
            sum = (_e68 + ((weight * _e65) / gain));
            // glimt_render_gpu/src/kernels/sensor.rs:88
            let _e71 = weights;
            weights = (_e71 + weight);
        }
        // glimt_render_gpu/src/kernels/sensor.rs:90
        let _e75 = relative_gain;
        relative_gain = (_e75 / this_3.step);
        continuing {
            let _e77 = counter;
            counter = (_e77 + 1u);
        }
    }
    // glimt_render_gpu/src/kernels/sensor.rs:92
    let _e81 = sum;
    let _e82 = weights;
    return max((_e81 / max(_e82, 0.00000000000000000000000000000000000001f)), 0f);
}

// glimt_render_gpu/src/kernels/sensor.rs:51
fn expose_1(pixel_1: u32, sensor: SensorParams) -> vec4<f32> {
    var source_4: Xoshiro128PlusPlus;

    // glimt_render_gpu/src/kernels/sensor.rs:52
    let value = radiance_1[pixel_1];
    // glimt_render_gpu/src/kernels/sensor.rs:53
    if (sensor.exposures == 0u) {
        // glimt_render_gpu/src/kernels/sensor.rs:54
        return value;
    }
    // glimt_render_gpu/src/kernels/sensor.rs:56
    let _e15 = hash2_(sensor.seed, 11u);
    let _e17 = Xoshiro128PlusPlus_stream(_e15, sensor.frame, pixel_1);
    source_4 = _e17;
    // glimt_render_gpu/src/kernels/sensor.rs:57
    let _e21 = SensorParams_fuse(sensor, value.x, (&source_4));
    // glimt_render_gpu/src/kernels/sensor.rs:58
    let _e24 = SensorParams_fuse(sensor, value.y, (&source_4));
    // glimt_render_gpu/src/kernels/sensor.rs:59
    let _e27 = SensorParams_fuse(sensor, value.z, (&source_4));
    // glimt_render_gpu/src/kernels/sensor.rs:60
    return vec4<f32>(_e21, _e24, _e27, value.w);
}

@compute @workgroup_size(64, 1, 1) 
fn expose(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let local = ((id.y * (groups.x * 64u)) + id.x);
    let _e11 = params.count;
    if (local >= _e11) {
        return;
    }
    let _e14 = params.first;
    let _e17 = params.sensor;
    let _e18 = expose_1((_e14 + local), _e17);
    out[local] = _e18;
}
