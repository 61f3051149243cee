// Made from Rust by naga-front-rust; do not edit. This command writes it: cargo run --release -p glimt-generate

struct ShadingFrame {
    t: vec3<f32>,
    b: vec3<f32>,
    n: vec3<f32>,
}

struct DirectionSample {
    direction: vec3<f32>,
    pdf_sr: f32,
}

struct OwenSobol {
    seed: u32,
    index: u32,
    dimension: u32,
}

struct Xoshiro128PlusPlus {
    state: vec4<u32>,
}

struct RisSum {
    sum: f32,
    candidates: u32,
    end: u32,
}

struct Word {
    f0_: u32,
}

struct Comb {
    scheme: u32,
    picks: u32,
    teeth: u32,
    made: u32,
    next: f32,
    reach: f32,
    state: f32,
}

struct RisPicks {
    comb: Comb,
    sum: f32,
    samples: f32,
    left: u32,
    candidate: u32,
    end: u32,
}

// glimt_sampling/src/uniform.rs:15
fn unit_float(u: u32) -> f32 {

    // glimt_sampling/src/uniform.rs:16
    return (f32((u >> 8u)) * (1f / 16777216f));
}

// glimt_sampling/src/uniform.rs:22
fn unit_pair(u_1: vec2<u32>) -> vec2<f32> {

    // glimt_sampling/src/uniform.rs:23
    let _e4 = unit_float(u_1.x);
    let _e6 = unit_float(u_1.y);
    return vec2<f32>(_e4, _e6);
}

// glimt_sampling/src/mis.rs:17
fn balance_heuristic(n_f: u32, pdf_f: f32, n_g: u32, pdf_g: f32) -> f32 {
    var chosen: f32;

    // glimt_sampling/src/mis.rs:18
    let f = (f32(n_f) * pdf_f);
    // glimt_sampling/src/mis.rs:19
    let sum_2 = (f + (f32(n_g) * pdf_g));
    // glimt_sampling/src/mis.rs:20
    if (sum_2 > 0f) {
        chosen = (f / sum_2);
    } else {
        chosen = 0f;
    }
    let _e18 = chosen;
    return _e18;
}

// glimt_sampling/src/mis.rs:34
fn power_heuristic(n_f_1: u32, pdf_f_1: f32, n_g_1: u32, pdf_g_1: f32) -> f32 {

    // glimt_sampling/src/mis.rs:35
    let f_1 = (f32(n_f_1) * pdf_f_1);
    // glimt_sampling/src/mis.rs:36
    let g = (f32(n_g_1) * pdf_g_1);
    // glimt_sampling/src/mis.rs:37
    if (f_1 > g) {
        // glimt_sampling/src/mis.rs:38
        let ratio = (g / f_1);
        // glimt_sampling/src/mis.rs:39
        return (1f / (1f + (ratio * ratio)));
    }
    // glimt_sampling/src/mis.rs:41
    if (g > 0f) {
        // glimt_sampling/src/mis.rs:42
        let ratio_1 = (f_1 / g);
        // glimt_sampling/src/mis.rs:43
        return ((ratio_1 * ratio_1) / (1f + (ratio_1 * ratio_1)));
    }
    // glimt_sampling/src/mis.rs:45
    return 0f;
}

// glimt_sampling/src/math.rs:45
fn shading_frame(n: vec3<f32>) -> ShadingFrame {

    // glimt_sampling/src/math.rs:46
    let sign_ = bitcast<f32>(((bitcast<u32>(1f) & 2147483647u) | (bitcast<u32>(n.z) & 2147483648u)));
    // glimt_sampling/src/math.rs:47
    let a_2 = (-1f / (sign_ + n.z));
    // glimt_sampling/src/math.rs:48
    let c_1 = ((n.x * n.y) * a_2);
    // glimt_sampling/src/math.rs:49
    return ShadingFrame(vec3<f32>((1f + (((sign_ * n.x) * n.x) * a_2)), (sign_ * c_1), (-(sign_) * n.x)), vec3<f32>(c_1, (sign_ + ((n.y * n.y) * a_2)), -(n.y)), n);
}

// glimt_sampling/src/warp.rs:182
fn cos_sin_turns(turns: f32) -> vec2<f32> {
    var chosen_1: f32;

    // glimt_sampling/src/warp.rs:183
    if (turns < 0.5f) {
        chosen_1 = turns;
    } else {
        chosen_1 = (turns - 1f);
    }
    let signed = chosen_1;
    // glimt_sampling/src/warp.rs:184
    let phi = (6.2831855f * signed);
    // glimt_sampling/src/warp.rs:185
    return vec2<f32>(cos(phi), sin(phi));
}

// glimt_sampling/src/warp.rs:169
fn sample_cap(u_2: vec2<f32>, height: f32) -> DirectionSample {

    // glimt_sampling/src/warp.rs:170
    let h = (u_2.x * height);
    // glimt_sampling/src/warp.rs:172
    let sin_theta = sqrt(max((h * (2f - h)), 0f));
    // glimt_sampling/src/warp.rs:173
    let _e15 = cos_sin_turns(u_2.y);
    // glimt_sampling/src/warp.rs:174
    return DirectionSample(vec3<f32>((sin_theta * _e15.x), (sin_theta * _e15.y), (1f - h)), ((0.5f * 0.31830987f) / height));
}

// glimt_sampling/src/hash.rs:15
fn hash_u32_(n_1: u32) -> u32 {
    var x: u32;

    // glimt_sampling/src/hash.rs:16
    x = (n_1 ^ 3875421163u);
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
fn owen_sobol(seed: u32, frame: u32, pixel: u32, sample_index: u32) -> OwenSobol {

    // glimt_sampling/src/sobol.rs:173
    let _e6 = hash3_(seed, frame, pixel);
    let _e9 = hash2_(_e6, (sample_index >> 16u));
    return OwenSobol(_e9, (sample_index & 65535u), 0u);
}

// glimt_sampling/src/sobol.rs:21
fn owen_scramble_reversed(n_2: u32, scramble: u32) -> u32 {
    var x_1: u32;

    // glimt_sampling/src/sobol.rs:22
    x_1 = (n_2 ^ (n_2 * 1025551850u));
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
fn shuffle(index: u32, seed_1: u32) -> u32 {

    // glimt_sampling/src/sobol.rs:105
    let _e7 = hash_u32_((seed_1 ^ 2043055690u));
    let _e8 = owen_scramble_reversed(reverseBits(index), _e7);
    return reverseBits(_e8);
}

// glimt_sampling/src/sobol.rs:56
fn pascal(index_1: u32) -> u32 {
    var x_2: u32;

    // glimt_sampling/src/sobol.rs:57
    x_2 = index_1;
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
fn recurrence_2_(index_2: u32) -> u32 {
    var bits: u32;
    var v0_: u32;
    var v1_: u32;
    var sum: u32;
    var counter: i32;

    // glimt_sampling/src/sobol.rs:67
    bits = index_2;
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
fn recurrence_3_(index_3: u32) -> u32 {
    var bits_1: u32;
    var v0_1: u32;
    var v1_1: u32;
    var v2_: u32;
    var sum_1: u32;
    var counter_1: i32;

    // glimt_sampling/src/sobol.rs:85
    bits_1 = index_3;
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
fn sobol_reversed(index_4: u32, dimension: u32) -> u32 {
    var chosen_2: u32;

    // glimt_sampling/src/sobol.rs:44
    let index_5 = (index_4 & 65535u);
    // glimt_sampling/src/sobol.rs:45
    let _e8 = (dimension & 3u);
    if (_e8 == 0u) {
        // glimt_sampling/src/sobol.rs:47
        chosen_2 = index_5;
    } else {
        if (_e8 == 1u) {
            // glimt_sampling/src/sobol.rs:48
            let _e16 = pascal(index_5);
            chosen_2 = _e16;
        } else {
            if (_e8 == 2u) {
                // glimt_sampling/src/sobol.rs:49
                let _e20 = recurrence_2_(index_5);
                chosen_2 = _e20;
            } else {
                // glimt_sampling/src/sobol.rs:50
                let _e22 = recurrence_3_(index_5);
                chosen_2 = _e22;
            }
        }
    }
    let _e23 = chosen_2;
    return _e23;
}

// glimt_sampling/src/sobol.rs:110
fn scramble_1(reversed: u32, dimension_1: u32, seed_2: u32) -> u32 {
    var chosen_3: u32;

    // glimt_sampling/src/sobol.rs:111
    let _e6 = (dimension_1 & 3u);
    if (_e6 == 0u) {
        // glimt_sampling/src/sobol.rs:112
        chosen_3 = 2435803578u;
    } else {
        if (_e6 == 1u) {
            // glimt_sampling/src/sobol.rs:113
            chosen_3 = 391059627u;
        } else {
            if (_e6 == 2u) {
                // glimt_sampling/src/sobol.rs:114
                chosen_3 = 1763603146u;
            } else {
                // glimt_sampling/src/sobol.rs:115
                chosen_3 = 3020734904u;
            }
        }
    }
    let salt = chosen_3;
    // glimt_sampling/src/sobol.rs:118
    let _e27 = hash_u32_(((seed_2 * 2626628923u) ^ salt));
    // glimt_sampling/src/sobol.rs:119
    let _e29 = owen_scramble_reversed(reversed, _e27);
    return reverseBits(_e29);
}

// glimt_sampling/src/sobol.rs:191
fn owen_sobol_next(this_: ptr<function, OwenSobol>) -> vec2<u32> {

    // glimt_sampling/src/sobol.rs:192
    let _e4 = (*this_).dimension;
    let dimension_2 = ((_e4 + 1u) & 4294967294u);
    // glimt_sampling/src/sobol.rs:193
    (*this_).dimension = (dimension_2 + 2u);
    // glimt_sampling/src/sobol.rs:194
    let _e15 = (*this_).seed;
    let _e18 = hash2_(_e15, (dimension_2 >> 2u));
    // glimt_sampling/src/sobol.rs:195
    let _e21 = (*this_).index;
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
fn xoshiro_stream(seed_3: u32, frame_1: u32, pixel_1: u32) -> Xoshiro128PlusPlus {

    // glimt_sampling/src/xoshiro.rs:50
    let _e7 = hash_uvec4_(vec4<u32>(pixel_1, frame_1, seed_3, 2654435769u));
    let _e8 = Xoshiro128PlusPlus_from_state(_e7);
    return _e8;
}

// glimt_sampling/src/xoshiro.rs:56
fn xoshiro_next(this_1: ptr<function, Xoshiro128PlusPlus>) -> u32 {

    // glimt_sampling/src/xoshiro.rs:57
    let s = (*this_1).state;
    // glimt_sampling/src/xoshiro.rs:58
    let _e8 = (s.x + s.w);
    let result = (((_e8 << 7u) | (_e8 >> ((0u - 7u) & 31u))) + s.x);
    // glimt_sampling/src/xoshiro.rs:59
    let z_1 = (s.z ^ s.x);
    // glimt_sampling/src/xoshiro.rs:60
    let w_1 = (s.w ^ s.y);
    // glimt_sampling/src/xoshiro.rs:61
    (*this_1).state = vec4<u32>((s.x ^ w_1), (s.y ^ z_1), (z_1 ^ (s.y << 9u)), ((w_1 << 11u) | (w_1 >> ((0u - 11u) & 31u))));
    // glimt_sampling/src/xoshiro.rs:62
    return result;
}

// glimt_sampling/src/ris.rs:61
fn ris_sum() -> RisSum {

    // glimt_sampling/src/ris.rs:62
    return RisSum(0f, 0u, 0u);
}

// glimt_sampling/src/ris.rs:72
fn ris_add(this_2: ptr<function, RisSum>, weight: f32) {

    // glimt_sampling/src/ris.rs:73
    let _e6 = (*this_2).candidates;
    (*this_2).candidates = (_e6 + 1u);
    // glimt_sampling/src/ris.rs:74
    if (weight > 0f) {
        // glimt_sampling/src/ris.rs:75
        let _e13 = (*this_2).sum;
        (*this_2).sum = (_e13 + weight);
        // glimt_sampling/src/ris.rs:76
        let _e17 = (*this_2).candidates;
        (*this_2).end = _e17;
    }
    return;
}

// glimt_sampling/src/ris.rs:83
fn ris_normaliser(this_3: RisSum) -> f32 {
    var chosen_4: f32;

    // glimt_sampling/src/ris.rs:84
    if (this_3.candidates > 0u) {
        // glimt_sampling/src/ris.rs:85
        chosen_4 = (this_3.sum / f32(this_3.candidates));
    } else {
        // glimt_sampling/src/ris.rs:87
        chosen_4 = 0f;
    }
    let _e14 = chosen_4;
    return _e14;
}

// glimt_sampling/src/ris.rs:109
fn Word_next_u32_(this_4: ptr<function, Word>) -> u32 {

    // glimt_sampling/src/ris.rs:110
    let _e4 = (*this_4).f0_;
    return _e4;
}

// glimt_sampling/src/resample.rs:136
fn Comb_place_tooth(this_5: ptr<function, Comb>, source: ptr<function, Word>) {

    // glimt_sampling/src/resample.rs:137
    let _e5 = (*this_5).made;
    let _e7 = (*this_5).teeth;
    if (_e5 >= _e7) {
        // glimt_sampling/src/resample.rs:138
        return;
    }
    // glimt_sampling/src/resample.rs:140
    let _e12 = (*this_5).made;
    let first = f32(_e12);
    // glimt_sampling/src/resample.rs:141
    let _e16 = (*this_5).scheme;
    if (_e16 == 0u) {
        // glimt_sampling/src/resample.rs:142
        let _e21 = (*this_5).state;
        (*this_5).next = (first + _e21);
    } else {
        let _e25 = (*this_5).scheme;
        if (_e25 == 1u) {
            // glimt_sampling/src/resample.rs:144
            let _e29 = Word_next_u32_(source);
            let _e30 = unit_float(_e29);
            (*this_5).next = (first + _e30);
        } else {
            // glimt_sampling/src/resample.rs:147
            let _e35 = Word_next_u32_(source);
            let _e36 = unit_float(_e35);
            let v_1 = (1f - _e36);
            // glimt_sampling/src/resample.rs:148
            let _e40 = (*this_5).teeth;
            let _e42 = (*this_5).made;
            let left = f32((_e40 - _e42));
            // glimt_sampling/src/resample.rs:149
            let _e50 = (*this_5).state;
            (*this_5).state = (_e50 * pow(v_1, (1f / left)));
            // glimt_sampling/src/resample.rs:150
            let _e55 = (*this_5).state;
            let _e58 = (*this_5).teeth;
            (*this_5).next = ((1f - _e55) * f32(_e58));
        }
    }
    return;
}

// glimt_sampling/src/resample.rs:85
fn Comb_new(scheme: u32, picks: u32, sure: u32, source_1: ptr<function, Word>) -> Comb {
    var comb: Comb;

    // glimt_sampling/src/resample.rs:86
    comb = Comb(scheme, picks, (max(picks, sure) - sure), 0u, 0f, 0f, 1f);
    // glimt_sampling/src/resample.rs:95
    if (scheme == 0u) {
        // glimt_sampling/src/resample.rs:96
        let _e18 = Word_next_u32_(source_1);
        let _e19 = unit_float(_e18);
        comb.state = _e19;
    }
    // glimt_sampling/src/resample.rs:98
    Comb_place_tooth((&comb), source_1);
    // glimt_sampling/src/resample.rs:99
    let _e23 = comb;
    return _e23;
}

// glimt_sampling/src/ris.rs:118
fn ris_picks(weights: RisSum, samples: u32, u_3: u32) -> RisPicks {
    var borrowed: Word;
    var chosen_5: u32;

    // glimt_sampling/src/ris.rs:119
    let possible = (weights.sum > 0f);
    // glimt_sampling/src/ris.rs:120
    borrowed = Word(u_3);
    let _e13 = Comb_new(0u, samples, 0u, (&borrowed));
    if possible {
        // glimt_sampling/src/ris.rs:124
        chosen_5 = samples;
    } else {
        chosen_5 = 0u;
    }
    let _e19 = chosen_5;
    return RisPicks(_e13, weights.sum, f32(samples), _e19, 0u, weights.end);
}

// glimt_sampling/src/resample.rs:45
fn sure_copies(scheme_1: u32, expected: f32) -> u32 {
    var chosen_6: u32;

    // glimt_sampling/src/resample.rs:46
    if (scheme_1 == 3u) {
        // glimt_sampling/src/resample.rs:47
        chosen_6 = u32(expected);
    } else {
        // glimt_sampling/src/resample.rs:49
        chosen_6 = 0u;
    }
    let _e11 = chosen_6;
    return _e11;
}

// glimt_sampling/src/resample.rs:106
fn Comb_take(this_6: ptr<function, Comb>, expected_1: f32, source_2: ptr<function, Word>) -> u32 {

    // glimt_sampling/src/resample.rs:107
    let _e6 = (*this_6).scheme;
    let _e7 = sure_copies(_e6, expected_1);
    // glimt_sampling/src/resample.rs:108
    let _e12 = (*this_6).reach;
    (*this_6).reach = (_e12 + (expected_1 - f32(_e7)));
    // glimt_sampling/src/resample.rs:109
    let before = (*this_6).made;
    // glimt_sampling/src/resample.rs:110
    loop {
        let _e19 = (*this_6).made;
        let _e21 = (*this_6).teeth;
        let _e24 = (*this_6).next;
        let _e26 = (*this_6).reach;
        if ((_e19 < _e21) && (_e24 < _e26)) {
            // glimt_sampling/src/resample.rs:111
            let _e32 = (*this_6).made;
            (*this_6).made = (_e32 + 1u);
            // glimt_sampling/src/resample.rs:112
            Comb_place_tooth(this_6, source_2);
        } else {
            break;
        }
    }
    // glimt_sampling/src/resample.rs:114
    let _e37 = (*this_6).made;
    return (_e7 + (_e37 - before));
}

// glimt_sampling/src/ris.rs:133
fn ris_take(this_7: ptr<function, RisPicks>, weight_1: f32) -> u32 {
    var chosen_7: u32;
    var borrowed_1: Comb;
    var borrowed_2: Word;

    // glimt_sampling/src/ris.rs:134
    let _e6 = (*this_7).candidate;
    (*this_7).candidate = (_e6 + 1u);
    // glimt_sampling/src/ris.rs:135
    let _e13 = (*this_7).left;
    if (!((weight_1 > 0f)) || (_e13 == 0u)) {
        // glimt_sampling/src/ris.rs:136
        return 0u;
    }
    // glimt_sampling/src/ris.rs:138
    let _e22 = (*this_7).candidate;
    let _e24 = (*this_7).end;
    if (_e22 == _e24) {
        // glimt_sampling/src/ris.rs:139
        let _e28 = (*this_7).left;
        chosen_7 = _e28;
    } else {
        // glimt_sampling/src/ris.rs:142
        let _e32 = (*this_7).comb;
        borrowed_1 = _e32;
        let _e34 = (*this_7).sum;
        let _e37 = (*this_7).samples;
        borrowed_2 = Word(0u);
        let _e42 = Comb_take((&borrowed_1), ((weight_1 / _e34) * _e37), (&borrowed_2));
        let _e43 = borrowed_1;
        (*this_7).comb = _e43;
        let _e45 = (*this_7).left;
        chosen_7 = min(_e42, _e45);
    }
    let picks_2 = chosen_7;
    // glimt_sampling/src/ris.rs:146
    let _e50 = (*this_7).left;
    (*this_7).left = (_e50 - picks_2);
    // glimt_sampling/src/ris.rs:147
    return picks_2;
}

// glimt_sampling/src/ris.rs:153
fn ris_is_done(this_8: RisPicks) -> bool {

    // glimt_sampling/src/ris.rs:154
    return (this_8.left == 0u);
}

// glimt_sampling/src/resample.rs:136
fn Comb_place_tooth_1(this_9: ptr<function, Comb>, source_3: ptr<function, Xoshiro128PlusPlus>) {

    // glimt_sampling/src/resample.rs:137
    let _e5 = (*this_9).made;
    let _e7 = (*this_9).teeth;
    if (_e5 >= _e7) {
        // glimt_sampling/src/resample.rs:138
        return;
    }
    // glimt_sampling/src/resample.rs:140
    let _e12 = (*this_9).made;
    let first_1 = f32(_e12);
    // glimt_sampling/src/resample.rs:141
    let _e16 = (*this_9).scheme;
    if (_e16 == 0u) {
        // glimt_sampling/src/resample.rs:142
        let _e21 = (*this_9).state;
        (*this_9).next = (first_1 + _e21);
    } else {
        let _e25 = (*this_9).scheme;
        if (_e25 == 1u) {
            // glimt_sampling/src/resample.rs:144
            let _e29 = xoshiro_next(source_3);
            let _e30 = unit_float(_e29);
            (*this_9).next = (first_1 + _e30);
        } else {
            // glimt_sampling/src/resample.rs:147
            let _e35 = xoshiro_next(source_3);
            let _e36 = unit_float(_e35);
            let v_2 = (1f - _e36);
            // glimt_sampling/src/resample.rs:148
            let _e40 = (*this_9).teeth;
            let _e42 = (*this_9).made;
            let left_1 = f32((_e40 - _e42));
            // glimt_sampling/src/resample.rs:149
            let _e50 = (*this_9).state;
            (*this_9).state = (_e50 * pow(v_2, (1f / left_1)));
            // glimt_sampling/src/resample.rs:150
            let _e55 = (*this_9).state;
            let _e58 = (*this_9).teeth;
            (*this_9).next = ((1f - _e55) * f32(_e58));
        }
    }
    return;
}

// glimt_sampling/src/resample.rs:85
fn resample_comb(scheme_2: u32, picks_1: u32, sure_1: u32, source_4: ptr<function, Xoshiro128PlusPlus>) -> Comb {
    var comb_1: Comb;

    // glimt_sampling/src/resample.rs:86
    comb_1 = Comb(scheme_2, picks_1, (max(picks_1, sure_1) - sure_1), 0u, 0f, 0f, 1f);
    // glimt_sampling/src/resample.rs:95
    if (scheme_2 == 0u) {
        // glimt_sampling/src/resample.rs:96
        let _e18 = xoshiro_next(source_4);
        let _e19 = unit_float(_e18);
        comb_1.state = _e19;
    }
    // glimt_sampling/src/resample.rs:98
    Comb_place_tooth_1((&comb_1), source_4);
    // glimt_sampling/src/resample.rs:99
    let _e23 = comb_1;
    return _e23;
}

// glimt_sampling/src/resample.rs:106
fn resample_take(this_10: ptr<function, Comb>, expected_2: f32, source_5: ptr<function, Xoshiro128PlusPlus>) -> u32 {

    // glimt_sampling/src/resample.rs:107
    let _e6 = (*this_10).scheme;
    let _e7 = sure_copies(_e6, expected_2);
    // glimt_sampling/src/resample.rs:108
    let _e12 = (*this_10).reach;
    (*this_10).reach = (_e12 + (expected_2 - f32(_e7)));
    // glimt_sampling/src/resample.rs:109
    let before_1 = (*this_10).made;
    // glimt_sampling/src/resample.rs:110
    loop {
        let _e19 = (*this_10).made;
        let _e21 = (*this_10).teeth;
        let _e24 = (*this_10).next;
        let _e26 = (*this_10).reach;
        if ((_e19 < _e21) && (_e24 < _e26)) {
            // glimt_sampling/src/resample.rs:111
            let _e32 = (*this_10).made;
            (*this_10).made = (_e32 + 1u);
            // glimt_sampling/src/resample.rs:112
            Comb_place_tooth_1(this_10, source_5);
        } else {
            break;
        }
    }
    // glimt_sampling/src/resample.rs:114
    let _e37 = (*this_10).made;
    return (_e7 + (_e37 - before_1));
}

// glimt_sampling/src/resample.rs:121
fn resample_finish(this_11: ptr<function, Comb>, source_6: ptr<function, Xoshiro128PlusPlus>) -> u32 {
    var counter_2: u32;

    // glimt_sampling/src/resample.rs:122
    let _e5 = (*this_11).teeth;
    let _e7 = (*this_11).made;
    let left_2 = (_e5 - _e7);
    // glimt_sampling/src/resample.rs:123
    let _e11 = (*this_11).scheme;
    if (_e11 != 0u) {
        // glimt_sampling/src/resample.rs:125
        let _e16 = (*this_11).teeth;
        let _e18 = (*this_11).made;
        let drawn = min(_e16, (_e18 + 1u));
        // glimt_sampling/src/resample.rs:126
        let _e24 = (*this_11).picks;
        counter_2 = drawn;
        loop {
            let _e26 = counter_2;
            if (_e26 >= _e24) {
                break;
            }
            // glimt_sampling/src/resample.rs:127
            let _e29 = xoshiro_next(source_6);
            continuing {
                let _e30 = counter_2;
                counter_2 = (_e30 + 1u);
            }
        }
    }
    // glimt_sampling/src/resample.rs:130
    let _e35 = (*this_11).teeth;
    (*this_11).made = _e35;
    // glimt_sampling/src/resample.rs:131
    return left_2;
}

