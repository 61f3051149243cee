// Made from Rust by naga-front-rust; do not edit. This command writes it: cargo run --release -p glimt-generate

struct EnvSample {
    texel: vec2<u32>,
    direction: vec3<f32>,
    pdf_sr: f32,
}

struct Bin {
    index: u32,
    first: u32,
    units: u32,
}

@group(0) @binding(1) 
var<storage> marginal: array<u32>;
@group(0) @binding(2) 
var<storage> conditional: array<u32>;

// glimt_envmap_cdf/src/env_cdf.rs:48
fn env_is_black(size: vec2<u32>) -> bool {

    // glimt_envmap_cdf/src/env_cdf.rs:49
    let _e6 = marginal[size.y];
    return (_e6 == 0u);
}

// glimt_envmap_cdf/src/search.rs:31
fn find_bin(start: u32, bins: u32, u: u32) -> Bin {
    var at: u32;
    var left: u32;

    // glimt_envmap_cdf/src/search.rs:33
    at = start;
    // glimt_envmap_cdf/src/search.rs:34
    left = bins;
    // glimt_envmap_cdf/src/search.rs:35
    loop {
        let _e9 = left;
        if !((_e9 > 1u)) {
            break;
        }
        // glimt_envmap_cdf/src/search.rs:36
        let _e14 = left;
        let half = (_e14 / 2u);
        // glimt_envmap_cdf/src/search.rs:37
        let _e18 = at;
        let _e22 = marginal[(_e18 + half)];
        if (_e22 <= u) {
            // glimt_envmap_cdf/src/search.rs:38
            let _e25 = at;
            at = (_e25 + half);
        }
        // glimt_envmap_cdf/src/search.rs:40
        let _e28 = left;
        left = (_e28 - half);
    }
    // glimt_envmap_cdf/src/search.rs:42
    let _e31 = at;
    let first = marginal[_e31];
    // glimt_envmap_cdf/src/search.rs:43
    let _e36 = at;
    let _e38 = at;
    let _e43 = marginal[(_e38 + 1u)];
    return Bin((_e36 - start), first, (_e43 - first));
}

// glimt_envmap_cdf/src/search.rs:31
fn find_bin_1(start_1: u32, bins_1: u32, u_1: u32) -> Bin {
    var at_1: u32;
    var left_1: u32;

    // glimt_envmap_cdf/src/search.rs:33
    at_1 = start_1;
    // glimt_envmap_cdf/src/search.rs:34
    left_1 = bins_1;
    // glimt_envmap_cdf/src/search.rs:35
    loop {
        let _e9 = left_1;
        if !((_e9 > 1u)) {
            break;
        }
        // glimt_envmap_cdf/src/search.rs:36
        let _e14 = left_1;
        let half_1 = (_e14 / 2u);
        // glimt_envmap_cdf/src/search.rs:37
        let _e18 = at_1;
        let _e22 = conditional[(_e18 + half_1)];
        if (_e22 <= u_1) {
            // glimt_envmap_cdf/src/search.rs:38
            let _e25 = at_1;
            at_1 = (_e25 + half_1);
        }
        // glimt_envmap_cdf/src/search.rs:40
        let _e28 = left_1;
        left_1 = (_e28 - half_1);
    }
    // glimt_envmap_cdf/src/search.rs:42
    let _e31 = at_1;
    let first_1 = conditional[_e31];
    // glimt_envmap_cdf/src/search.rs:43
    let _e36 = at_1;
    let _e38 = at_1;
    let _e43 = conditional[(_e38 + 1u)];
    return Bin((_e36 - start_1), first_1, (_e43 - first_1));
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

// glimt_envmap_cdf/src/env_cdf.rs:172
fn place_in_bin(bin: Bin, u_2: u32, fraction: u32) -> f32 {

    // glimt_envmap_cdf/src/env_cdf.rs:173
    let below_unit = (f32(fraction) * (1f / 65536f));
    // glimt_envmap_cdf/src/env_cdf.rs:174
    return min(((f32((u_2 - bin.first)) + below_unit) / f32(bin.units)), 0.99999994f);
}

// glimt_probe/src/trig.rs:25
fn cos_sin_pi(x_1: f32) -> vec2<f32> {
    var chosen: vec2<f32>;

    // glimt_probe/src/trig.rs:27
    let quarter = floor(((2f * x_1) + 0.5f));
    // glimt_probe/src/trig.rs:28
    let y = (x_1 - (0.5f * quarter));
    // glimt_probe/src/trig.rs:29
    let y2_ = (y * y);
    // glimt_probe/src/trig.rs:31
    let c = (1f + (y2_ * (-4.934802f + (y2_ * (4.058712f + (y2_ * (-1.3352627f + (y2_ * (0.23533063f + (y2_ * -0.02580689f))))))))));
    // glimt_probe/src/trig.rs:34
    let s = (y * (3.1415927f + (y2_ * (-5.1677127f + (y2_ * (2.550164f + (y2_ * (-0.5992645f + (y2_ * 0.082145885f)))))))));
    // glimt_probe/src/trig.rs:37
    let _e49 = (i32(quarter) & 3i);
    if (_e49 == 0i) {
        // glimt_probe/src/trig.rs:38
        chosen = vec2<f32>(c, (s + 0f));
    } else {
        if (_e49 == 1i) {
            // glimt_probe/src/trig.rs:39
            chosen = vec2<f32>((0f - s), c);
        } else {
            if (_e49 == 2i) {
                // glimt_probe/src/trig.rs:40
                chosen = vec2<f32>((0f - c), (0f - s));
            } else {
                // glimt_probe/src/trig.rs:41
                chosen = vec2<f32>((s + 0f), (0f - c));
            }
        }
    }
    let _e77 = chosen;
    return _e77;
}

// glimt_probe/src/latlong.rs:142
fn direction_in_texel(texel: vec2<u32>, size_1: vec2<u32>, r: vec2<f32>) -> vec3<f32> {
    var chosen_1: u32;
    var chosen_2: u32;
    var chosen_3: f32;

    // glimt_probe/src/latlong.rs:143
    let size_11 = max(size_1, vec2(1u));
    // glimt_probe/src/latlong.rs:144
    let row_3 = min(texel.y, (size_11.y - 1u));
    // glimt_probe/src/latlong.rs:146
    let southern = ((2u * row_3) >= size_11.y);
    // glimt_probe/src/latlong.rs:147
    if southern {
        chosen_1 = (size_11.y - row_3);
    } else {
        chosen_1 = row_3;
    }
    let upper = chosen_1;
    // glimt_probe/src/latlong.rs:148
    if southern {
        chosen_2 = ((size_11.y - row_3) - 1u);
    } else {
        chosen_2 = (row_3 + 1u);
    }
    let lower = chosen_2;
    // glimt_probe/src/latlong.rs:149
    let half_2 = (0.5f / f32(size_11.y));
    // glimt_probe/src/latlong.rs:150
    let _e41 = cos_sin_pi((f32(upper) * half_2));
    let sin_upper = _e41.y;
    // glimt_probe/src/latlong.rs:151
    let _e46 = cos_sin_pi((f32(lower) * half_2));
    let sin_lower = _e46.y;
    // glimt_probe/src/latlong.rs:152
    let s_upper = (sin_upper * sin_upper);
    // glimt_probe/src/latlong.rs:153
    let s_1 = (s_upper + (((sin_lower * sin_lower) - s_upper) * r.y));
    // glimt_probe/src/latlong.rs:154
    let sin_theta = (2f * sqrt(max((s_1 * (1f - s_1)), 0f)));
    // glimt_probe/src/latlong.rs:155
    if southern {
        // glimt_probe/src/latlong.rs:156
        chosen_3 = ((2f * s_1) - 1f);
    } else {
        // glimt_probe/src/latlong.rs:158
        chosen_3 = (1f - (2f * s_1));
    }
    let cos_theta = chosen_3;
    // glimt_probe/src/latlong.rs:160
    let _e90 = cos_sin_pi((1f - ((2f * (f32(texel.x) + r.x)) / f32(size_11.x))));
    // glimt_probe/src/latlong.rs:161
    return vec3<f32>((sin_theta * _e90.x), (sin_theta * _e90.y), cos_theta);
}

// glimt_probe/src/latlong.rs:121
fn texel_solid_angle_sr(row: u32, size_2: vec2<u32>) -> f32 {

    // glimt_probe/src/latlong.rs:122
    let size_12 = max(size_2, vec2(1u));
    // glimt_probe/src/latlong.rs:123
    let row_4 = min(row, (size_12.y - 1u));
    // glimt_probe/src/latlong.rs:124
    let from_pole = min(row_4, ((size_12.y - 1u) - row_4));
    // glimt_probe/src/latlong.rs:125
    let half_row = (0.5f / f32(size_12.y));
    // glimt_probe/src/latlong.rs:126
    let middle = (f32(((2u * from_pole) + 1u)) * half_row);
    // glimt_probe/src/latlong.rs:127
    let _e37 = cos_sin_pi(middle);
    let _e40 = cos_sin_pi(half_row);
    return ((((4f * 3.1415927f) / f32(size_12.x)) * _e37.y) * _e40.y);
}

// glimt_envmap_cdf/src/env_cdf.rs:165
fn density_sr(row_units: u32, column_units: u32, row_1: u32, size_3: vec2<u32>) -> f32 {

    // glimt_envmap_cdf/src/env_cdf.rs:166
    let pmf = ((f32(row_units) * 0.0000000004656613f) * (f32(column_units) * 0.0000000004656613f));
    // glimt_envmap_cdf/src/env_cdf.rs:167
    let _e14 = texel_solid_angle_sr(row_1, size_3);
    return (pmf / _e14);
}

// glimt_envmap_cdf/src/env_cdf.rs:61
fn env_sample(size_4: vec2<u32>, u_3: vec2<u32>) -> EnvSample {

    // glimt_envmap_cdf/src/env_cdf.rs:62
    let _e4 = env_is_black(size_4);
    if _e4 {
        // glimt_envmap_cdf/src/env_cdf.rs:63
        return EnvSample(vec2(0u), vec3<f32>(0f, 0f, 1f), 0f);
    }
    // glimt_envmap_cdf/src/env_cdf.rs:69
    let _e20 = find_bin(0u, size_4.y, (u_3.y >> 1u));
    // glimt_envmap_cdf/src/env_cdf.rs:70
    let row_start = (_e20.index * (size_4.x + 1u));
    // glimt_envmap_cdf/src/env_cdf.rs:71
    let _e32 = find_bin_1(row_start, size_4.x, (u_3.x >> 1u));
    // glimt_envmap_cdf/src/env_cdf.rs:72
    let texel_4 = vec2<u32>(_e32.index, _e20.index);
    // glimt_envmap_cdf/src/env_cdf.rs:73
    let _e40 = hash2_(u_3.x, u_3.y);
    // glimt_envmap_cdf/src/env_cdf.rs:74
    let _e47 = place_in_bin(_e32, (u_3.x >> 1u), (_e40 & 65535u));
    let _e53 = place_in_bin(_e20, (u_3.y >> 1u), (_e40 >> 16u));
    let place_1 = vec2<f32>(_e47, _e53);
    // glimt_envmap_cdf/src/env_cdf.rs:78
    let _e56 = direction_in_texel(texel_4, size_4, place_1);
    let _e60 = density_sr(_e20.units, _e32.units, _e20.index, size_4);
    return EnvSample(texel_4, _e56, _e60);
}

// glimt_probe/src/latlong.rs:45
fn direction_to_uv(d: vec3<f32>) -> vec2<f32> {
    var chosen_4: f32;
    var chosen_5: f32;

    // glimt_probe/src/latlong.rs:46
    let horizontal = sqrt(((d.x * d.x) + (d.y * d.y)));
    // glimt_probe/src/latlong.rs:47
    if (horizontal <= 0f) {
        // glimt_probe/src/latlong.rs:48
        if (d.z < 0f) {
            chosen_4 = 1f;
        } else {
            chosen_4 = 0f;
        }
        let v_1 = chosen_4;
        // glimt_probe/src/latlong.rs:49
        return vec2<f32>(0.5f, v_1);
    }
    // glimt_probe/src/latlong.rs:52
    let v_2 = (atan2(horizontal, d.z) * 0.31830987f);
    // glimt_probe/src/latlong.rs:53
    let u_4 = (0.5f - ((0.5f * 0.31830987f) * atan2(d.y, d.x)));
    // glimt_probe/src/latlong.rs:54
    if (u_4 < 1f) {
        chosen_5 = max(u_4, 0f);
    } else {
        chosen_5 = 0f;
    }
    let _e47 = chosen_5;
    return vec2<f32>(_e47, clamp(v_2, 0f, 1f));
}

// glimt_probe/src/latlong.rs:68
fn direction_to_texel(d_1: vec3<f32>, size_5: vec2<u32>) -> vec2<u32> {

    // glimt_probe/src/latlong.rs:69
    let size_13 = max(size_5, vec2(1u));
    // glimt_probe/src/latlong.rs:70
    let _e8 = direction_to_uv(d_1);
    let position = (_e8 * vec2<f32>(size_13));
    // glimt_probe/src/latlong.rs:71
    return min(vec2<u32>(position), (size_13 - vec2(1u)));
}

// glimt_envmap_cdf/src/env_cdf.rs:143
fn EnvCdf_row(size_6: vec2<u32>, texel_1: vec2<u32>) -> Bin {

    // glimt_envmap_cdf/src/env_cdf.rs:144
    let y_1 = texel_1.y;
    // glimt_envmap_cdf/src/env_cdf.rs:145
    let _e8 = marginal[y_1];
    let _e13 = marginal[(y_1 + 1u)];
    let _e16 = marginal[y_1];
    return Bin(texel_1.y, _e8, (_e13 - _e16));
}

// glimt_envmap_cdf/src/env_cdf.rs:153
fn EnvCdf_column(size_7: vec2<u32>, texel_2: vec2<u32>) -> Bin {

    // glimt_envmap_cdf/src/env_cdf.rs:154
    let x_2 = ((texel_2.y * (size_7.x + 1u)) + texel_2.x);
    // glimt_envmap_cdf/src/env_cdf.rs:155
    let _e15 = conditional[x_2];
    let _e20 = conditional[(x_2 + 1u)];
    let _e23 = conditional[x_2];
    return Bin(texel_2.x, _e15, (_e20 - _e23));
}

// glimt_envmap_cdf/src/env_cdf.rs:119
fn env_texel_pdf_sr(size_8: vec2<u32>, texel_3: vec2<u32>) -> f32 {

    // glimt_envmap_cdf/src/env_cdf.rs:120
    let _e4 = EnvCdf_row(size_8, texel_3);
    // glimt_envmap_cdf/src/env_cdf.rs:121
    let _e6 = EnvCdf_column(size_8, texel_3);
    // glimt_envmap_cdf/src/env_cdf.rs:122
    let _e11 = density_sr(_e4.units, _e6.units, texel_3.y, size_8);
    return _e11;
}

// glimt_envmap_cdf/src/env_cdf.rs:111
fn env_pdf_sr(size_9: vec2<u32>, d_2: vec3<f32>) -> f32 {

    // glimt_envmap_cdf/src/env_cdf.rs:112
    let _e4 = direction_to_texel(d_2, size_9);
    let _e5 = env_texel_pdf_sr(size_9, _e4);
    return _e5;
}

// glimt_envmap_cdf/src/env_cdf.rs:179
fn word_in_bin(bin_1: Bin, place: f32) -> u32 {

    // glimt_envmap_cdf/src/env_cdf.rs:180
    let last = (max(bin_1.units, 1u) - 1u);
    // glimt_envmap_cdf/src/env_cdf.rs:181
    let unit = min(u32((place * f32(bin_1.units))), last);
    // glimt_envmap_cdf/src/env_cdf.rs:183
    return (min((bin_1.first + unit), 2147483647u) << 1u);
}

// glimt_envmap_cdf/src/env_cdf.rs:188
fn area_above(row_2: u32, height: u32, v: f32) -> f32 {
    var chosen_6: u32;
    var chosen_7: f32;
    var chosen_8: f32;

    // glimt_envmap_cdf/src/env_cdf.rs:190
    let half_3 = (0.5f / f32(height));
    // glimt_envmap_cdf/src/env_cdf.rs:191
    let southern_1 = ((2u * row_2) >= height);
    // glimt_envmap_cdf/src/env_cdf.rs:192
    if southern_1 {
        chosen_6 = ((height - 1u) - row_2);
    } else {
        chosen_6 = row_2;
    }
    let from_pole_1 = chosen_6;
    // glimt_envmap_cdf/src/env_cdf.rs:193
    if southern_1 {
        chosen_7 = (1f - v);
    } else {
        chosen_7 = v;
    }
    let f = chosen_7;
    // glimt_envmap_cdf/src/env_cdf.rs:194
    let edge = f32((2u * from_pole_1));
    // glimt_envmap_cdf/src/env_cdf.rs:195
    let _e30 = cos_sin_pi(((edge + f) * half_3));
    let _e33 = cos_sin_pi((f * half_3));
    let part = (_e30.y * _e33.y);
    // glimt_envmap_cdf/src/env_cdf.rs:196
    let _e40 = cos_sin_pi(((edge + 1f) * half_3));
    let _e42 = cos_sin_pi(half_3);
    let band = (_e40.y * _e42.y);
    // glimt_envmap_cdf/src/env_cdf.rs:197
    let share = (part / band);
    // glimt_envmap_cdf/src/env_cdf.rs:198
    if southern_1 {
        chosen_8 = (1f - share);
    } else {
        chosen_8 = share;
    }
    let _e51 = chosen_8;
    return _e51;
}

// glimt_envmap_cdf/src/env_cdf.rs:132
fn env_invert(size_10: vec2<u32>, d_3: vec3<f32>) -> vec2<u32> {

    // glimt_envmap_cdf/src/env_cdf.rs:133
    let _e4 = direction_to_texel(d_3, size_10);
    // glimt_envmap_cdf/src/env_cdf.rs:134
    let _e6 = direction_to_uv(d_3);
    let position_1 = ((_e6 * vec2<f32>(size_10)) - vec2<f32>(_e4));
    // glimt_envmap_cdf/src/env_cdf.rs:135
    let place_2 = clamp(position_1, vec2(0f), vec2(1f));
    // glimt_envmap_cdf/src/env_cdf.rs:136
    let _e18 = EnvCdf_column(size_10, _e4);
    let _e20 = word_in_bin(_e18, place_2.x);
    let _e21 = EnvCdf_row(size_10, _e4);
    let _e25 = area_above(_e4.y, size_10.y, place_2.y);
    let _e26 = word_in_bin(_e21, _e25);
    return vec2<u32>(_e20, _e26);
}

