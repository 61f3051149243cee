// Made from Rust by naga-front-rust; do not edit. This command writes it: cargo run --release -p glimt-generate

struct LayerSample {
    radiance: vec3<f32>,
    alpha: f32,
    blocked: vec3<f32>,
    catcher: f32,
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

struct PixelPattern {
    kind: u32,
    seed: u32,
    frame: u32,
    pixel: u32,
    ray: u32,
    rays: u32,
}

struct OwenSobol {
    seed: u32,
    index: u32,
    dimension: u32,
}

struct Xoshiro128PlusPlus {
    state: vec4<u32>,
}

struct CameraView {
    eye: vec3<f32>,
    forward: vec3<f32>,
    right: vec3<f32>,
    up: vec3<f32>,
}

struct Ray {
    origin: vec3<f32>,
    direction: vec3<f32>,
    inverse_direction: vec3<f32>,
    key: u32,
}

struct Returned_Environment_map {
    value_size: vec2<u32>,
    value_rotation: vec2<f32>,
}

struct PixelLayers {
    object: vec4<f32>,
    lit: vec3<f32>,
    catcher: f32,
    blocked: vec3<f32>,
    unused_a: u32,
    behind: vec3<f32>,
    unused_b: u32,
}

struct Params {
    first: u32,
    count: u32,
    frame: FrameParams,
    env_size: vec2<u32>,
    env_rotation: vec2<f32>,
}

@group(0) @binding(1) 
var<storage> env_texels: array<vec4<f32>>;
@group(0) @binding(2) 
var<storage> samples_1: array<LayerSample>;
@group(0) @binding(3) 
var<storage, read_write> out: array<PixelLayers>;
@group(0) @binding(0) 
var<uniform> params: Params;

// glimt_render_gpu/src/kernels/frame.rs:130
fn FrameParams_pattern_at(this_: FrameParams, pixel: u32, ray: u32) -> PixelPattern {

    // glimt_render_gpu/src/kernels/frame.rs:131
    return PixelPattern(this_.pattern, this_.seed, this_.frame, pixel, ray, this_.rays_per_pixel);
}

// glimt_render_gpu/src/kernels/frame.rs:120
fn FrameParams_pattern_of(this_1: FrameParams, ray_1: u32) -> PixelPattern {

    // glimt_render_gpu/src/kernels/frame.rs:121
    let _e10 = FrameParams_pattern_at(this_1, (this_1.first_pixel + (ray_1 / this_1.rays_per_pixel)), (ray_1 % this_1.rays_per_pixel));
    return _e10;
}

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

// glimt_sampling/src/hash.rs:34
fn hash3_(a_1: u32, b_1: u32, c: u32) -> u32 {

    // glimt_sampling/src/hash.rs:35
    let _e5 = hash2_(a_1, b_1);
    let _e7 = hash_u32_((_e5 + c));
    return _e7;
}

// glimt_sampling/src/sobol.rs:172
fn OwenSobol_new(seed: u32, frame: u32, pixel_1: u32, sample_index: u32) -> OwenSobol {

    // glimt_sampling/src/sobol.rs:173
    let _e6 = hash3_(seed, frame, pixel_1);
    let _e9 = hash2_(_e6, (sample_index >> 16u));
    return OwenSobol(_e9, (sample_index & 65535u), 0u);
}

// glimt_render_gpu/src/kernels/pattern.rs:136
fn PixelPattern_sobol_point(this_2: PixelPattern, purpose: u32, index: u32) -> OwenSobol {

    // glimt_render_gpu/src/kernels/pattern.rs:137
    let _e6 = hash2_(this_2.seed, purpose);
    let _e9 = OwenSobol_new(_e6, this_2.frame, this_2.pixel, index);
    return _e9;
}

// glimt_sampling/src/sobol.rs:21
fn owen_scramble_reversed(n_1: u32, scramble: u32) -> u32 {
    var x_1: u32;

    // glimt_sampling/src/sobol.rs:22
    x_1 = (n_1 ^ (n_1 * 1025551850u));
    // glimt_sampling/src/sobol.rs:23
    let _e9 = x_1;
    x_1 = (_e9 + scramble);
    // glimt_sampling/src/sobol.rs:24
    let _e12 = x_1;
    x_1 = (_e12 * ((scramble >> 16u) | 1u));
    // glimt_sampling/src/sobol.rs:25
    let _e19 = x_1;
    let _e22 = x_1;
    x_1 = (_e22 ^ (_e19 * 89287766u));
    // glimt_sampling/src/sobol.rs:26
    let _e25 = x_1;
    let _e26 = x_1;
    return (_e25 ^ (_e26 * 1403136100u));
}

// glimt_sampling/src/sobol.rs:104
fn shuffle(index_1: u32, seed_1: u32) -> u32 {

    // glimt_sampling/src/sobol.rs:105
    let _e7 = hash_u32_((seed_1 ^ 2043055690u));
    let _e8 = owen_scramble_reversed(reverseBits(index_1), _e7);
    return reverseBits(_e8);
}

// glimt_sampling/src/sobol.rs:56
fn pascal(index_2: u32) -> u32 {
    var x_2: u32;

    // glimt_sampling/src/sobol.rs:57
    x_2 = index_2;
    // glimt_sampling/src/sobol.rs:58
    let _e5 = x_2;
    let _e10 = x_2;
    x_2 = (_e10 ^ ((_e5 >> 1u) & 21845u));
    // glimt_sampling/src/sobol.rs:59
    let _e13 = x_2;
    let _e18 = x_2;
    x_2 = (_e18 ^ ((_e13 >> 2u) & 13107u));
    // glimt_sampling/src/sobol.rs:60
    let _e21 = x_2;
    let _e26 = x_2;
    x_2 = (_e26 ^ ((_e21 >> 4u) & 3855u));
    // glimt_sampling/src/sobol.rs:61
    let _e29 = x_2;
    let _e30 = x_2;
    return (_e29 ^ ((_e30 >> 8u) & 255u));
}

// glimt_sampling/src/sobol.rs:66
fn recurrence_2_(index_3: u32) -> u32 {
    var bits: u32;
    var v0_: u32;
    var v1_: u32;
    var sum: u32;
    var counter: i32;

    // glimt_sampling/src/sobol.rs:67
    bits = index_3;
    // glimt_sampling/src/sobol.rs:68
    v0_ = 1u;
    // glimt_sampling/src/sobol.rs:69
    v1_ = 3u;
    // glimt_sampling/src/sobol.rs:70
    sum = 0u;
    // glimt_sampling/src/sobol.rs:72
    counter = 0i;
    loop {
        let _e17 = counter;
        if (_e17 >= 16i) {
            break;
        }
        // glimt_sampling/src/sobol.rs:73
        let _e20 = v0_;
        let _e21 = bits;
        let _e27 = sum;
        sum = (_e27 ^ (_e20 & (0u - (_e21 & 1u))));
        // glimt_sampling/src/sobol.rs:74
        let _e30 = v1_;
        let _e31 = v0_;
        let _e33 = v0_;
        let v2_1 = ((_e30 ^ _e31) ^ (_e33 << 2u));
        // glimt_sampling/src/sobol.rs:75
        let _e38 = v1_;
        v0_ = _e38;
        // glimt_sampling/src/sobol.rs:76
        v1_ = v2_1;
        // glimt_sampling/src/sobol.rs:77
        let _e41 = bits;
        bits = (_e41 >> 1u);
        continuing {
            let _e44 = counter;
            counter = (_e44 + 1i);
        }
    }
    // glimt_sampling/src/sobol.rs:79
    let _e48 = sum;
    return _e48;
}

// glimt_sampling/src/sobol.rs:84
fn recurrence_3_(index_4: u32) -> u32 {
    var bits_1: u32;
    var v0_1: u32;
    var v1_1: u32;
    var v2_: u32;
    var sum_1: u32;
    var counter_1: i32;

    // glimt_sampling/src/sobol.rs:85
    bits_1 = index_4;
    // glimt_sampling/src/sobol.rs:86
    v0_1 = 1u;
    // glimt_sampling/src/sobol.rs:87
    v1_1 = 3u;
    // glimt_sampling/src/sobol.rs:88
    v2_ = 4u;
    // glimt_sampling/src/sobol.rs:89
    sum_1 = 0u;
    // glimt_sampling/src/sobol.rs:90
    counter_1 = 0i;
    loop {
        let _e20 = counter_1;
        if (_e20 >= 16i) {
            break;
        }
        // glimt_sampling/src/sobol.rs:91
        let _e23 = v0_1;
        let _e24 = bits_1;
        let _e30 = sum_1;
        sum_1 = (_e30 ^ (_e23 & (0u - (_e24 & 1u))));
        // glimt_sampling/src/sobol.rs:92
        let _e33 = v1_1;
        let _e34 = v0_1;
        let _e36 = v0_1;
        let v3_ = ((_e33 ^ _e34) ^ (_e36 << 3u));
        // glimt_sampling/src/sobol.rs:93
        let _e41 = v1_1;
        v0_1 = _e41;
        // glimt_sampling/src/sobol.rs:94
        let _e43 = v2_;
        v1_1 = _e43;
        // glimt_sampling/src/sobol.rs:95
        v2_ = v3_;
        // glimt_sampling/src/sobol.rs:96
        let _e46 = bits_1;
        bits_1 = (_e46 >> 1u);
        continuing {
            let _e49 = counter_1;
            counter_1 = (_e49 + 1i);
        }
    }
    // glimt_sampling/src/sobol.rs:98
    let _e53 = sum_1;
    return _e53;
}

// glimt_sampling/src/sobol.rs:43
fn sobol_reversed(index_5: u32, dimension: u32) -> u32 {
    var chosen: u32;

    // glimt_sampling/src/sobol.rs:44
    let index_9 = (index_5 & 65535u);
    // glimt_sampling/src/sobol.rs:45
    let _e8 = (dimension & 3u);
    if (_e8 == 0u) {
        // glimt_sampling/src/sobol.rs:47
        chosen = index_9;
    } else {
        if (_e8 == 1u) {
            // glimt_sampling/src/sobol.rs:48
            let _e16 = pascal(index_9);
            chosen = _e16;
        } else {
            if (_e8 == 2u) {
                // glimt_sampling/src/sobol.rs:49
                let _e20 = recurrence_2_(index_9);
                chosen = _e20;
            } else {
                // glimt_sampling/src/sobol.rs:50
                let _e22 = recurrence_3_(index_9);
                chosen = _e22;
            }
        }
    }
    let _e23 = chosen;
    return _e23;
}

// glimt_sampling/src/sobol.rs:110
fn scramble_1(reversed: u32, dimension_1: u32, seed_2: u32) -> u32 {
    var chosen_1: u32;

    // glimt_sampling/src/sobol.rs:111
    let _e6 = (dimension_1 & 3u);
    if (_e6 == 0u) {
        // glimt_sampling/src/sobol.rs:112
        chosen_1 = 2435803578u;
    } else {
        if (_e6 == 1u) {
            // glimt_sampling/src/sobol.rs:113
            chosen_1 = 391059627u;
        } else {
            if (_e6 == 2u) {
                // glimt_sampling/src/sobol.rs:114
                chosen_1 = 1763603146u;
            } else {
                // glimt_sampling/src/sobol.rs:115
                chosen_1 = 3020734904u;
            }
        }
    }
    let salt = chosen_1;
    // glimt_sampling/src/sobol.rs:118
    let _e27 = hash_u32_(((seed_2 * 2626628923u) ^ salt));
    // glimt_sampling/src/sobol.rs:119
    let _e29 = owen_scramble_reversed(reversed, _e27);
    return reverseBits(_e29);
}

// glimt_sampling/src/sobol.rs:191
fn OwenSobol_next_uvec2_(this_3: ptr<function, OwenSobol>) -> vec2<u32> {

    // glimt_sampling/src/sobol.rs:192
    let _e4 = (*this_3).dimension;
    let dimension_2 = ((_e4 + 1u) & 4294967294u);
    // glimt_sampling/src/sobol.rs:193
    (*this_3).dimension = (dimension_2 + 2u);
    // glimt_sampling/src/sobol.rs:194
    let _e15 = (*this_3).seed;
    let _e18 = hash2_(_e15, (dimension_2 >> 2u));
    // glimt_sampling/src/sobol.rs:195
    let _e21 = (*this_3).index;
    let _e22 = shuffle(_e21, _e18);
    // glimt_sampling/src/sobol.rs:196
    let _e24 = sobol_reversed(_e22, dimension_2);
    let _e25 = scramble_1(_e24, dimension_2, _e18);
    let _e28 = sobol_reversed(_e22, (dimension_2 + 1u));
    let _e31 = scramble_1(_e28, (dimension_2 + 1u), _e18);
    return vec2<u32>(_e25, _e31);
}

// glimt_sampling/src/hash.rs:50
fn hash_uvec4_(v: vec4<u32>) -> vec4<u32> {
    var x_3: u32;
    var y: u32;
    var z: u32;
    var w: u32;

    // glimt_sampling/src/hash.rs:51
    let _e4 = hash_u32_(v.x);
    x_3 = ((_e4 * 1664525u) + 1013904223u);
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
    let _e35 = x_3;
    let _e36 = y;
    let _e37 = w;
    x_3 = (_e35 + (_e36 * _e37));
    // glimt_sampling/src/hash.rs:65
    let _e41 = y;
    let _e42 = z;
    let _e43 = x_3;
    y = (_e41 + (_e42 * _e43));
    // glimt_sampling/src/hash.rs:66
    let _e47 = z;
    let _e48 = x_3;
    let _e49 = y;
    z = (_e47 + (_e48 * _e49));
    // glimt_sampling/src/hash.rs:67
    let _e53 = w;
    let _e54 = y;
    let _e55 = z;
    w = (_e53 + (_e54 * _e55));
    // glimt_sampling/src/hash.rs:68
    let _e59 = x_3;
    let _e62 = x_3;
    x_3 = (_e62 ^ (_e59 >> 16u));
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
    let _e83 = x_3;
    let _e84 = y;
    let _e85 = w;
    x_3 = (_e83 + (_e84 * _e85));
    // glimt_sampling/src/hash.rs:73
    let _e89 = y;
    let _e90 = z;
    let _e91 = x_3;
    y = (_e89 + (_e90 * _e91));
    // glimt_sampling/src/hash.rs:74
    let _e95 = z;
    let _e96 = x_3;
    let _e97 = y;
    z = (_e95 + (_e96 * _e97));
    // glimt_sampling/src/hash.rs:75
    let _e101 = w;
    let _e102 = y;
    let _e103 = z;
    w = (_e101 + (_e102 * _e103));
    // glimt_sampling/src/hash.rs:76
    let _e107 = x_3;
    let _e108 = x_3;
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
fn Xoshiro128PlusPlus_stream(seed_3: u32, frame_1: u32, pixel_2: u32) -> Xoshiro128PlusPlus {

    // glimt_sampling/src/xoshiro.rs:50
    let _e7 = hash_uvec4_(vec4<u32>(pixel_2, frame_1, seed_3, 2654435769u));
    let _e8 = Xoshiro128PlusPlus_from_state(_e7);
    return _e8;
}

// glimt_render_gpu/src/kernels/pattern.rs:141
fn PixelPattern_generator(this_4: PixelPattern, purpose_1: u32, index_6: u32) -> Xoshiro128PlusPlus {

    // glimt_render_gpu/src/kernels/pattern.rs:142
    let _e6 = hash3_(this_4.seed, purpose_1, index_6);
    let _e9 = Xoshiro128PlusPlus_stream(_e6, this_4.frame, this_4.pixel);
    return _e9;
}

// glimt_sampling/src/xoshiro.rs:56
fn Xoshiro128PlusPlus_next_u32_(this_5: ptr<function, Xoshiro128PlusPlus>) -> u32 {

    // glimt_sampling/src/xoshiro.rs:57
    let s = (*this_5).state;
    // glimt_sampling/src/xoshiro.rs:58
    let _e8 = (s.x + s.w);
    let result = (((_e8 << 7u) | (_e8 >> ((0u - 7u) & 31u))) + s.x);
    // glimt_sampling/src/xoshiro.rs:59
    let z_1 = (s.z ^ s.x);
    // glimt_sampling/src/xoshiro.rs:60
    let w_1 = (s.w ^ s.y);
    // glimt_sampling/src/xoshiro.rs:61
    (*this_5).state = vec4<u32>((s.x ^ w_1), (s.y ^ z_1), (z_1 ^ (s.y << 9u)), ((w_1 << 11u) | (w_1 >> ((0u - 11u) & 31u))));
    // glimt_sampling/src/xoshiro.rs:62
    return result;
}

// glimt_sampling/src/uniform.rs:34
fn Xoshiro128PlusPlus_next_uvec2_(this_6: ptr<function, Xoshiro128PlusPlus>) -> vec2<u32> {

    // glimt_sampling/src/uniform.rs:35
    let _e3 = Xoshiro128PlusPlus_next_u32_(this_6);
    // glimt_sampling/src/uniform.rs:36
    let _e5 = Xoshiro128PlusPlus_next_u32_(this_6);
    // glimt_sampling/src/uniform.rs:37
    return vec2<u32>(_e3, _e5);
}

// glimt_render_gpu/src/kernels/pattern.rs:146
fn PixelPattern_key(this_7: PixelPattern, purpose_2: u32) -> u32 {

    // glimt_render_gpu/src/kernels/pattern.rs:147
    let _e5 = hash2_(this_7.seed, purpose_2);
    let _e8 = hash3_(_e5, this_7.frame, this_7.pixel);
    return _e8;
}

// glimt_render_gpu/src/kernels/pattern.rs:221
fn permute(index_7: u32, length_: u32, key: u32) -> u32 {
    var x_4: u32;
    var round_key: u32;
    var counter_2: i32;

    // glimt_render_gpu/src/kernels/pattern.rs:222
    if (length_ <= 1u) {
        // glimt_render_gpu/src/kernels/pattern.rs:223
        return 0u;
    }
    // glimt_render_gpu/src/kernels/pattern.rs:225
    let bits_2 = (32u - countLeadingZeros((length_ - 1u)));
    // glimt_render_gpu/src/kernels/pattern.rs:226
    let mask = (4294967295u >> ((32u - bits_2) & 31u));
    // glimt_render_gpu/src/kernels/pattern.rs:227
    x_4 = index_7;
    // glimt_render_gpu/src/kernels/pattern.rs:228
    loop {
        // glimt_render_gpu/src/kernels/pattern.rs:229
        round_key = key;
        // glimt_render_gpu/src/kernels/pattern.rs:230
        counter_2 = 0i;
        loop {
            let _e31 = counter_2;
            if (_e31 >= 3i) {
                break;
            }
            // glimt_render_gpu/src/kernels/pattern.rs:231
            let _e34 = round_key;
            let _e35 = hash_u32_(_e34);
            round_key = _e35;
            // glimt_render_gpu/src/kernels/pattern.rs:233
            let _e37 = x_4;
            let _e38 = round_key;
            x_4 = (((_e37 ^ _e38) * 2654435761u) & mask);
            // glimt_render_gpu/src/kernels/pattern.rs:234
            let _e44 = x_4;
            let _e46 = (bits_2 / 2u);
            let _e56 = x_4;
            x_4 = (_e56 ^ (_e44 >> (select(_e46, (_e46 + 1u), ((bits_2 % 2u) != 0u)) & 31u)));
            continuing {
                let _e58 = counter_2;
                counter_2 = (_e58 + 1i);
            }
        }
        // glimt_render_gpu/src/kernels/pattern.rs:236
        let _e62 = x_4;
        if (_e62 < length_) {
            // glimt_render_gpu/src/kernels/pattern.rs:237
            let _e65 = x_4;
            let _e67 = hash_u32_(~(key));
            return ((_e65 + (_e67 % length_)) % length_);
        }
    }
    return u32();
}

// glimt_render_gpu/src/kernels/pattern.rs:212
fn stratum(cell: u32, count: u32, jitter: u32) -> u32 {

    // glimt_render_gpu/src/kernels/pattern.rs:213
    return ((cell * (4294967295u / count)) + (jitter / count));
}

// glimt_render_gpu/src/kernels/pattern.rs:192
fn jittered_pair(index_8: u32, count_1: u32, jitter_1: vec2<u32>, key_1: u32) -> vec2<u32> {

    // glimt_render_gpu/src/kernels/pattern.rs:193
    let columns = max(u32(sqrt(f32(count_1))), 1u);
    // glimt_render_gpu/src/kernels/pattern.rs:194
    let _e12 = (count_1 / columns);
    let rows = select(_e12, (_e12 + 1u), ((count_1 % columns) != 0u));
    // glimt_render_gpu/src/kernels/pattern.rs:195
    let _e21 = hash2_(key_1, 1u);
    let _e22 = permute(index_8, count_1, _e21);
    // glimt_render_gpu/src/kernels/pattern.rs:196
    let _e26 = hash2_(key_1, 2u);
    let _e27 = permute((_e22 % columns), columns, _e26);
    // glimt_render_gpu/src/kernels/pattern.rs:197
    let _e31 = hash2_(key_1, 3u);
    let _e32 = permute((_e22 / columns), rows, _e31);
    // glimt_render_gpu/src/kernels/pattern.rs:198
    let _e38 = stratum(((_e27 * rows) + _e32), (columns * rows), jitter_1.x);
    let _e40 = stratum(_e22, count_1, jitter_1.y);
    return vec2<u32>(_e38, _e40);
}

// glimt_render_gpu/src/kernels/pattern.rs:67
fn PixelPattern_pair(this_8: PixelPattern, purpose_3: u32, sample: u32, samples: u32) -> vec2<u32> {
    var borrowed: OwenSobol;
    var borrowed_1: Xoshiro128PlusPlus;

    // glimt_render_gpu/src/kernels/pattern.rs:68
    let index_10 = ((this_8.ray * samples) + sample);
    // glimt_render_gpu/src/kernels/pattern.rs:69
    if (this_8.kind == 0u) {
        // glimt_render_gpu/src/kernels/pattern.rs:70
        let _e14 = PixelPattern_sobol_point(this_8, purpose_3, index_10);
        borrowed = _e14;
        let _e16 = OwenSobol_next_uvec2_((&borrowed));
        return _e16;
    }
    // glimt_render_gpu/src/kernels/pattern.rs:72
    let _e18 = PixelPattern_generator(this_8, purpose_3, index_10);
    borrowed_1 = _e18;
    let _e20 = Xoshiro128PlusPlus_next_uvec2_((&borrowed_1));
    // glimt_render_gpu/src/kernels/pattern.rs:73
    if (this_8.kind == 1u) {
        // glimt_render_gpu/src/kernels/pattern.rs:74
        return _e20;
    }
    // glimt_render_gpu/src/kernels/pattern.rs:76
    let _e29 = PixelPattern_key(this_8, purpose_3);
    let _e30 = jittered_pair(index_10, (this_8.rays * samples), _e20, _e29);
    return _e30;
}

// glimt_sampling/src/uniform.rs:15
fn unit_f32_(u: u32) -> f32 {

    // glimt_sampling/src/uniform.rs:16
    return (f32((u >> 8u)) * (1f / 16777216f));
}

// glimt_sampling/src/uniform.rs:22
fn unit_vec2_(u_1: vec2<u32>) -> vec2<f32> {

    // glimt_sampling/src/uniform.rs:23
    let _e4 = unit_f32_(u_1.x);
    let _e6 = unit_f32_(u_1.y);
    return vec2<f32>(_e4, _e6);
}

// glimt_render_gpu/src/kernels/camera.rs:23
fn CameraView_direction(this_9: CameraView, p: vec2<f32>, size: vec2<u32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/camera.rs:24
    let x_6 = (((2f * p.x) / f32(size.x)) - 1f);
    // glimt_render_gpu/src/kernels/camera.rs:25
    let y_1 = (((2f * p.y) / f32(size.y)) - 1f);
    // glimt_render_gpu/src/kernels/camera.rs:26
    return normalize(((this_9.forward + (this_9.right * x_6)) - (this_9.up * y_1)));
}

// glimt_render_gpu/src/kernels/frame.rs:161
fn FrameParams_direction(this_10: FrameParams, pixel_3: u32, place: vec2<f32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/frame.rs:162
    let corner = vec2<f32>(vec2<u32>((pixel_3 % this_10.width), (pixel_3 / this_10.width)));
    // glimt_render_gpu/src/kernels/frame.rs:163
    let view = CameraView(this_10.eye, this_10.forward, this_10.right, this_10.up);
    // glimt_render_gpu/src/kernels/frame.rs:169
    let _e22 = CameraView_direction(view, (corner + place), vec2<u32>(this_10.width, this_10.height));
    return _e22;
}

// glimt_render_gpu/src/kernels/pattern.rs:131
fn PixelPattern_ray_key(this_11: PixelPattern, purpose_4: u32) -> u32 {

    // glimt_render_gpu/src/kernels/pattern.rs:132
    let _e4 = PixelPattern_key(this_11, purpose_4);
    let _e6 = hash2_(_e4, this_11.ray);
    return _e6;
}

// glimt_render_gpu/src/kernels/ray.rs:59
fn inverse(x_5: f32) -> f32 {

    // glimt_render_gpu/src/kernels/ray.rs:60
    return (1f / bitcast<f32>(((bitcast<u32>(max(abs(x_5), 0.000000000000000001f)) & 2147483647u) | (bitcast<u32>(x_5) & 2147483648u))));
}

// glimt_render_gpu/src/kernels/ray.rs:44
fn Ray_keyed(origin: vec3<f32>, direction: vec3<f32>, key_2: u32) -> Ray {

    // glimt_render_gpu/src/kernels/ray.rs:45
    let _e6 = inverse(direction.x);
    let _e8 = inverse(direction.y);
    let _e10 = inverse(direction.z);
    return Ray(origin, direction, vec3<f32>(_e6, _e8, _e10), key_2);
}

// glimt_render_gpu/src/kernels/frame.rs:144
fn FrameParams_camera_ray(this_12: FrameParams, pattern: PixelPattern) -> Ray {
    var chosen_2: vec2<f32>;

    // glimt_render_gpu/src/kernels/frame.rs:145
    let film = PixelPattern(pattern.kind, pattern.seed, this_12.film_frame, pattern.pixel, pattern.ray, pattern.rays);
    // glimt_render_gpu/src/kernels/frame.rs:149
    if (this_12.filter_ == 1u) {
        // glimt_render_gpu/src/kernels/frame.rs:150
        chosen_2 = vec2(0.5f);
    } else {
        // glimt_render_gpu/src/kernels/frame.rs:152
        let _e23 = PixelPattern_pair(film, 1u, 0u, 1u);
        let _e24 = unit_vec2_(_e23);
        chosen_2 = _e24;
    }
    let place_1 = chosen_2;
    // glimt_render_gpu/src/kernels/frame.rs:154
    let _e28 = FrameParams_direction(this_12, pattern.pixel, place_1);
    // glimt_render_gpu/src/kernels/frame.rs:155
    let _e32 = PixelPattern_ray_key(film, 8u);
    let _e33 = Ray_keyed(this_12.eye, _e28, _e32);
    return _e33;
}

// glimt_render_gpu/src/kernels/environment.rs:56
fn Environment_map(size_1: vec2<u32>, rotation: vec2<f32>) -> Returned_Environment_map {

    // glimt_render_gpu/src/kernels/environment.rs:57
    return Returned_Environment_map(size_1, rotation);
}

// glimt_probe/src/rotate.rs:33
fn rotate_z(d: vec3<f32>, cos_sin: vec2<f32>) -> vec3<f32> {

    // glimt_probe/src/rotate.rs:34
    return vec3<f32>(((d.x * cos_sin.x) - (d.y * cos_sin.y)), ((d.x * cos_sin.y) + (d.y * cos_sin.x)), d.z);
}

// glimt_probe/src/latlong.rs:45
fn direction_to_uv(d_1: vec3<f32>) -> vec2<f32> {
    var chosen_3: f32;
    var chosen_4: f32;

    // glimt_probe/src/latlong.rs:46
    let horizontal = sqrt(((d_1.x * d_1.x) + (d_1.y * d_1.y)));
    // glimt_probe/src/latlong.rs:47
    if (horizontal <= 0f) {
        // glimt_probe/src/latlong.rs:48
        if (d_1.z < 0f) {
            chosen_3 = 1f;
        } else {
            chosen_3 = 0f;
        }
        let v_1 = chosen_3;
        // glimt_probe/src/latlong.rs:49
        return vec2<f32>(0.5f, v_1);
    }
    // glimt_probe/src/latlong.rs:52
    let v_2 = (atan2(horizontal, d_1.z) * 0.31830987f);
    // glimt_probe/src/latlong.rs:53
    let u_2 = (0.5f - ((0.5f * 0.31830987f) * atan2(d_1.y, d_1.x)));
    // glimt_probe/src/latlong.rs:54
    if (u_2 < 1f) {
        chosen_4 = max(u_2, 0f);
    } else {
        chosen_4 = 0f;
    }
    let _e47 = chosen_4;
    return vec2<f32>(_e47, clamp(v_2, 0f, 1f));
}

// glimt_render_gpu/src/kernels/environment.rs:146
fn bilinear(size_2: vec2<u32>, d_2: vec3<f32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/environment.rs:147
    let _e4 = direction_to_uv(d_2);
    let p_1 = ((_e4 * vec2<f32>(size_2)) - vec2(0.5f));
    // glimt_render_gpu/src/kernels/environment.rs:149
    let next = vec2<u32>((p_1 + vec2(1f)));
    // glimt_render_gpu/src/kernels/environment.rs:150
    let f = ((p_1 + vec2(1f)) - vec2<f32>(next));
    // glimt_render_gpu/src/kernels/environment.rs:151
    let x0_ = (((next.x + size_2.x) - 1u) % size_2.x);
    // glimt_render_gpu/src/kernels/environment.rs:152
    let x1_ = (next.x % size_2.x);
    // glimt_render_gpu/src/kernels/environment.rs:153
    let row0_ = ((max(next.y, 1u) * size_2.x) - size_2.x);
    // glimt_render_gpu/src/kernels/environment.rs:154
    let row1_ = (min(next.y, (size_2.y - 1u)) * size_2.x);
    // glimt_render_gpu/src/kernels/environment.rs:155
    let _e53 = env_texels[(row0_ + x0_)];
    let _e57 = env_texels[(row0_ + x1_)];
    let upper = ((_e53 * (1f - f.x)) + (_e57 * f.x));
    // glimt_render_gpu/src/kernels/environment.rs:156
    let _e68 = env_texels[(row1_ + x0_)];
    let _e72 = env_texels[(row1_ + x1_)];
    let lower = ((_e68 * (1f - f.x)) + (_e72 * f.x));
    // glimt_render_gpu/src/kernels/environment.rs:157
    return ((upper * (1f - f.y)) + (lower * f.y)).xyz;
}

// glimt_render_gpu/src/kernels/environment.rs:46
fn RadianceMap_background(size_3: vec2<u32>, rotation_1: vec2<f32>, direction_1: vec3<f32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/environment.rs:47
    let to_map = vec2<f32>(rotation_1.x, -(rotation_1.y));
    // glimt_render_gpu/src/kernels/environment.rs:48
    let _e10 = rotate_z(direction_1, to_map);
    let _e11 = bilinear(size_3, _e10);
    return _e11;
}

// glimt_render_gpu/src/kernels/environment.rs:123
fn Environment_background(size_4: vec2<u32>, rotation_2: vec2<f32>, direction_2: vec3<f32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/environment.rs:124
    let _e5 = Environment_map(size_4, rotation_2);
    let _e8 = RadianceMap_background(_e5.value_size, _e5.value_rotation, direction_2);
    return _e8;
}

// glimt_render_gpu/src/kernels/layers.rs:119
fn reconstruct_layers_1(pixel_4: u32, frame_2: FrameParams, env_size: vec2<u32>, env_rotation: vec2<f32>) -> PixelLayers {
    var object: vec4<f32>;
    var lit: vec3<f32>;
    var catcher: f32;
    var blocked: vec3<f32>;
    var behind: vec3<f32>;
    var clear: f32;
    var counter_3: u32;

    // glimt_render_gpu/src/kernels/layers.rs:125
    let first = (pixel_4 * frame_2.rays_per_pixel);
    // glimt_render_gpu/src/kernels/layers.rs:126
    object = vec4(0f);
    // glimt_render_gpu/src/kernels/layers.rs:127
    lit = vec3(0f);
    // glimt_render_gpu/src/kernels/layers.rs:128
    catcher = 0f;
    // glimt_render_gpu/src/kernels/layers.rs:129
    blocked = vec3(0f);
    // glimt_render_gpu/src/kernels/layers.rs:130
    behind = vec3(0f);
    // glimt_render_gpu/src/kernels/layers.rs:131
    clear = 0f;
    // glimt_render_gpu/src/kernels/layers.rs:132
    counter_3 = first;
    loop {
        let ray_2 = counter_3;
        if (ray_2 >= (first + frame_2.rays_per_pixel)) {
            break;
        }
        // glimt_render_gpu/src/kernels/layers.rs:133
        let sample_1 = samples_1[ray_2];
        // glimt_render_gpu/src/kernels/layers.rs:134
        if (sample_1.catcher > 0f) {
            // glimt_render_gpu/src/kernels/layers.rs:135
            let _e46 = lit;
            lit = (_e46 + sample_1.radiance);
            // glimt_render_gpu/src/kernels/layers.rs:136
            let _e50 = blocked;
            blocked = (_e50 + sample_1.blocked);
            // glimt_render_gpu/src/kernels/layers.rs:137
            let _e54 = catcher;
            catcher = (_e54 + 1f);
        } else {
            // glimt_render_gpu/src/kernels/layers.rs:139
            let _e60 = object;
            object = (_e60 + vec4<f32>(sample_1.radiance, sample_1.alpha));
        }
        // glimt_render_gpu/src/kernels/layers.rs:141
        if ((frame_2.background == 0u) && (sample_1.alpha == 0f)) {
            // glimt_render_gpu/src/kernels/layers.rs:142
            let _e71 = FrameParams_pattern_of(frame_2, ray_2);
            let _e72 = FrameParams_camera_ray(frame_2, _e71);
            let direction_3 = _e72.direction;
            // glimt_render_gpu/src/kernels/layers.rs:143
            let _e75 = Environment_background(env_size, env_rotation, direction_3);
            let _e76 = behind;
            behind = (_e76 + _e75);
            // glimt_render_gpu/src/kernels/layers.rs:144
            let _e80 = clear;
            clear = (_e80 + 1f);
        }
        continuing {
            let _e82 = counter_3;
            counter_3 = (_e82 + 1u);
        }
    }
    // glimt_render_gpu/src/kernels/layers.rs:147
    let rays = f32(frame_2.rays_per_pixel);
    // glimt_render_gpu/src/kernels/layers.rs:148
    let _e89 = object;
    let _e92 = lit;
    let _e95 = catcher;
    let _e97 = blocked;
    let _e101 = behind;
    let _e102 = clear;
    return PixelLayers((_e89 / vec4(rays)), (_e92 / vec3(rays)), (_e95 / rays), (_e97 / vec3(rays)), 0u, (_e101 / vec3(max(_e102, 1f))), 0u);
}

@compute @workgroup_size(64, 1, 1) 
fn reconstruct_layers(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let local = ((id.y * (groups.x * 64u)) + id.x);
    let _e11 = params.count;
    if (local >= _e11) {
        return;
    }
    let _e14 = params.first;
    let _e17 = params.frame;
    let _e19 = params.env_size;
    let _e21 = params.env_rotation;
    let _e22 = reconstruct_layers_1((_e14 + local), _e17, _e19, _e21);
    out[local] = _e22;
}
