// Made from Rust by naga-front-rust; do not edit. This command writes it: cargo run --release -p glimt-generate

struct MirrorBall {
    forward: vec3<f32>,
    radius_over_distance: f32,
    right: vec3<f32>,
    up: vec3<f32>,
}

struct Reflection {
    direction: vec3<f32>,
    normal: vec3<f32>,
    cos_incidence: f32,
}

struct Option_Reflection {
    is_some: bool,
    value: Reflection,
}

struct Option_Vec3_ {
    is_some: bool,
    value: vec3<f32>,
}

struct Option_Vec2_ {
    is_some: bool,
    value: vec2<f32>,
}

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

@group(0) @binding(1) 
var<storage> map_texels: array<TexelTaps>;
@group(0) @binding(2) 
var<storage> map_taps: array<u32>;
@group(0) @binding(3) 
var<storage> pixels: array<vec4<f32>>;

// glimt_probe/src/trig.rs:25
fn cos_sin_pi(x: f32) -> vec2<f32> {
    var chosen: vec2<f32>;

    // glimt_probe/src/trig.rs:27
    let quarter = floor(((2f * x) + 0.5f));
    // glimt_probe/src/trig.rs:28
    let y = (x - (0.5f * quarter));
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

// glimt_probe/src/latlong.rs:26
fn lat_long_direction(uv: vec2<f32>) -> vec3<f32> {

    // glimt_probe/src/latlong.rs:27
    let _e4 = cos_sin_pi(uv.y);
    // glimt_probe/src/latlong.rs:28
    let _e11 = cos_sin_pi((1f - (2f * uv.x)));
    // glimt_probe/src/latlong.rs:29
    return vec3<f32>((_e4.y * _e11.x), (_e4.y * _e11.y), _e4.x);
}

// glimt_probe/src/latlong.rs:45
fn lat_long_uv(d: vec3<f32>) -> vec2<f32> {
    var chosen_1: f32;
    var chosen_2: f32;

    // glimt_probe/src/latlong.rs:46
    let horizontal = sqrt(((d.x * d.x) + (d.y * d.y)));
    // glimt_probe/src/latlong.rs:47
    if (horizontal <= 0f) {
        // glimt_probe/src/latlong.rs:48
        if (d.z < 0f) {
            chosen_1 = 1f;
        } else {
            chosen_1 = 0f;
        }
        let v = chosen_1;
        // glimt_probe/src/latlong.rs:49
        return vec2<f32>(0.5f, v);
    }
    // glimt_probe/src/latlong.rs:52
    let v_1 = (atan2(horizontal, d.z) * 0.31830987f);
    // glimt_probe/src/latlong.rs:53
    let u = (0.5f - ((0.5f * 0.31830987f) * atan2(d.y, d.x)));
    // glimt_probe/src/latlong.rs:54
    if (u < 1f) {
        chosen_2 = max(u, 0f);
    } else {
        chosen_2 = 0f;
    }
    let _e47 = chosen_2;
    return vec2<f32>(_e47, clamp(v_1, 0f, 1f));
}

// glimt_probe/src/latlong.rs:68
fn lat_long_texel(d_1: vec3<f32>, size: vec2<u32>) -> vec2<u32> {

    // glimt_probe/src/latlong.rs:69
    let size_3 = max(size, vec2(1u));
    // glimt_probe/src/latlong.rs:70
    let _e8 = lat_long_uv(d_1);
    let position = (_e8 * vec2<f32>(size_3));
    // glimt_probe/src/latlong.rs:71
    return min(vec2<u32>(position), (size_3 - vec2(1u)));
}

// glimt_probe/src/latlong.rs:84
fn lat_long_texel_direction(texel: vec2<u32>, size_1: vec2<u32>) -> vec3<f32> {

    // glimt_probe/src/latlong.rs:85
    let _e13 = lat_long_direction(((vec2<f32>(texel) + vec2(0.5f)) / vec2<f32>(max(size_1, vec2(1u)))));
    return _e13;
}

// glimt_probe/src/latlong.rs:121
fn lat_long_texel_solid_angle_sr(row: u32, size_2: vec2<u32>) -> f32 {

    // glimt_probe/src/latlong.rs:122
    let size_4 = max(size_2, vec2(1u));
    // glimt_probe/src/latlong.rs:123
    let row_1 = min(row, (size_4.y - 1u));
    // glimt_probe/src/latlong.rs:124
    let from_pole = min(row_1, ((size_4.y - 1u) - row_1));
    // glimt_probe/src/latlong.rs:125
    let half_row = (0.5f / f32(size_4.y));
    // glimt_probe/src/latlong.rs:126
    let middle = (f32(((2u * from_pole) + 1u)) * half_row);
    // glimt_probe/src/latlong.rs:127
    let _e37 = cos_sin_pi(middle);
    let _e40 = cos_sin_pi(half_row);
    return ((((4f * 3.1415927f) / f32(size_4.x)) * _e37.y) * _e40.y);
}

// glimt_probe/src/mirror_ball.rs:139
fn MirrorBall_reflect(this_: MirrorBall, p: vec2<f32>) -> Option_Reflection {
    var chosen_3: vec3<f32>;

    // glimt_probe/src/mirror_ball.rs:140
    let s2_ = dot(p, p);
    // glimt_probe/src/mirror_ball.rs:141
    if (s2_ > 1f) {
        // glimt_probe/src/mirror_ball.rs:142
        return Option_Reflection();
    }
    // glimt_probe/src/mirror_ball.rs:144
    let k = this_.radius_over_distance;
    // glimt_probe/src/mirror_ball.rs:145
    let k2_ = (k * k);
    // glimt_probe/src/mirror_ball.rs:147
    let scale = (1f / sqrt((1f - (k2_ * (1f - s2_)))));
    // glimt_probe/src/mirror_ball.rs:148
    let s_1 = sqrt(s2_);
    // glimt_probe/src/mirror_ball.rs:149
    let sin_i_1 = (s_1 * scale);
    // glimt_probe/src/mirror_ball.rs:150
    let cos_i_1 = (sqrt(((1f - s2_) * (1f - k2_))) * scale);
    // glimt_probe/src/mirror_ball.rs:151
    let sin_beta = (k * sin_i_1);
    // glimt_probe/src/mirror_ball.rs:152
    let cos_beta = sqrt((1f - (sin_beta * sin_beta)));
    // glimt_probe/src/mirror_ball.rs:154
    let sin_n = ((sin_i_1 * cos_beta) - (cos_i_1 * sin_beta));
    // glimt_probe/src/mirror_ball.rs:155
    let cos_n = ((cos_i_1 * cos_beta) + (sin_i_1 * sin_beta));
    // glimt_probe/src/mirror_ball.rs:156
    let sin_d = ((sin_i_1 * cos_n) + (cos_i_1 * sin_n));
    // glimt_probe/src/mirror_ball.rs:157
    let cos_d = ((cos_i_1 * cos_n) - (sin_i_1 * sin_n));
    // glimt_probe/src/mirror_ball.rs:158
    if (s_1 > 0f) {
        // glimt_probe/src/mirror_ball.rs:159
        chosen_3 = (((this_.right * p.x) - (this_.up * p.y)) / vec3(s_1));
    } else {
        // glimt_probe/src/mirror_ball.rs:161
        chosen_3 = this_.right;
    }
    let across = chosen_3;
    // glimt_probe/src/mirror_ball.rs:163
    return Option_Reflection(true, Reflection(((across * sin_d) - (this_.forward * cos_d)), ((across * sin_n) - (this_.forward * cos_n)), cos_i_1));
}

// glimt_probe/src/mirror_ball.rs:120
fn mirror_ball_direction(this_1: MirrorBall, p_1: vec2<f32>) -> Option_Vec3_ {
    var chosen_4: Reflection;

    // glimt_probe/src/mirror_ball.rs:121
    let _e4 = MirrorBall_reflect(this_1, p_1);
    let value = _e4.value;
    if _e4.is_some {
        chosen_4 = value;
    } else {
        return Option_Vec3_();
    }
    let reflection = chosen_4;
    // glimt_probe/src/mirror_ball.rs:122
    return Option_Vec3_(true, reflection.direction);
}

// glimt_probe/src/mirror_ball.rs:112
fn MirrorBall_is_hidden(this_2: MirrorBall, d_2: vec3<f32>) -> bool {

    // glimt_probe/src/mirror_ball.rs:113
    let k_1 = this_2.radius_over_distance;
    // glimt_probe/src/mirror_ball.rs:114
    return (dot(d_2, this_2.forward) > sqrt((1f - (k_1 * k_1))));
}

// glimt_probe/src/mirror_ball.rs:194
fn mirror_ball_image(this_3: MirrorBall, d_3: vec3<f32>) -> Option_Vec2_ {
    var chosen_5: f32;
    var sin_i: f32;
    var chosen_6: f32;
    var cos_i: f32;
    var counter: u32;
    var chosen_7: f32;
    var chosen_8: Option_Vec2_;

    // glimt_probe/src/mirror_ball.rs:195
    let _e4 = MirrorBall_is_hidden(this_3, d_3);
    if _e4 {
        // glimt_probe/src/mirror_ball.rs:196
        return Option_Vec2_();
    }
    // glimt_probe/src/mirror_ball.rs:198
    let side = vec2<f32>(dot(d_3, this_3.right), -(dot(d_3, this_3.up)));
    // glimt_probe/src/mirror_ball.rs:199
    let sin_d_1 = length(side);
    // glimt_probe/src/mirror_ball.rs:200
    let cos_d_1 = -(dot(d_3, this_3.forward));
    // glimt_probe/src/mirror_ball.rs:201
    let k_2 = this_3.radius_over_distance;
    // glimt_probe/src/mirror_ball.rs:203
    let larger = sqrt((0.5f * (1f + abs(cos_d_1))));
    // glimt_probe/src/mirror_ball.rs:204
    let smaller = ((0.5f * sin_d_1) / larger);
    // glimt_probe/src/mirror_ball.rs:205
    if (cos_d_1 < 0f) {
        chosen_5 = larger;
    } else {
        chosen_5 = smaller;
    }
    let _e37 = chosen_5;
    sin_i = _e37;
    // glimt_probe/src/mirror_ball.rs:206
    if (cos_d_1 < 0f) {
        chosen_6 = smaller;
    } else {
        chosen_6 = larger;
    }
    let _e43 = chosen_6;
    cos_i = _e43;
    // glimt_probe/src/mirror_ball.rs:207
    counter = 0u;
    loop {
        let _e49 = counter;
        if (_e49 >= 5u) {
            break;
        }
        // glimt_probe/src/mirror_ball.rs:208
        let _e52 = sin_i;
        let sin_beta_1 = (k_2 * _e52);
        // glimt_probe/src/mirror_ball.rs:209
        let cos_beta_1 = sqrt(max((1f - (sin_beta_1 * sin_beta_1)), 0f));
        // glimt_probe/src/mirror_ball.rs:211
        let _e63 = sin_i;
        let _e65 = cos_i;
        let sin_2i = ((2f * _e63) * _e65);
        // glimt_probe/src/mirror_ball.rs:212
        let _e68 = cos_i;
        let _e69 = sin_i;
        let _e71 = cos_i;
        let _e72 = sin_i;
        let cos_2i = ((_e68 - _e69) * (_e71 + _e72));
        // glimt_probe/src/mirror_ball.rs:213
        let sin_t = ((sin_2i * cos_beta_1) - (cos_2i * sin_beta_1));
        // glimt_probe/src/mirror_ball.rs:214
        let cos_t = ((cos_2i * cos_beta_1) + (sin_2i * sin_beta_1));
        // glimt_probe/src/mirror_ball.rs:215
        let error = ((sin_t * cos_d_1) - (cos_t * sin_d_1));
        // glimt_probe/src/mirror_ball.rs:216
        let _e89 = cos_i;
        let step_ = (error / (2f - ((k_2 * _e89) / max(cos_beta_1, 0.001f))));
        // glimt_probe/src/mirror_ball.rs:217
        let _e97 = cos_i;
        let _e98 = sin_i;
        let _e101 = sin_i;
        let _e102 = cos_i;
        let turned = normalize(vec2<f32>((_e97 + (step_ * _e98)), (_e101 - (step_ * _e102))));
        // glimt_probe/src/mirror_ball.rs:218
        cos_i = turned.x;
        // glimt_probe/src/mirror_ball.rs:219
        sin_i = turned.y;
        continuing {
            let _e111 = counter;
            counter = (_e111 + 1u);
        }
    }
    // glimt_probe/src/mirror_ball.rs:221
    let _e115 = sin_i;
    let sin_beta_2 = (k_2 * _e115);
    // glimt_probe/src/mirror_ball.rs:222
    let _e118 = sin_i;
    let s_2 = (_e118 * sqrt(((1f - (k_2 * k_2)) / (1f - (sin_beta_2 * sin_beta_2)))));
    // glimt_probe/src/mirror_ball.rs:224
    let _e130 = cos_i;
    if (_e130 > 0f) {
        chosen_7 = clamp(s_2, 0f, 1f);
    } else {
        chosen_7 = 1f;
    }
    let s_3 = chosen_7;
    // glimt_probe/src/mirror_ball.rs:225
    if (sin_d_1 > 0f) {
        // glimt_probe/src/mirror_ball.rs:226
        chosen_8 = Option_Vec2_(true, (side * (s_3 / sin_d_1)));
    } else {
        // glimt_probe/src/mirror_ball.rs:228
        chosen_8 = Option_Vec2_(true, vec2<f32>(s_3, 0f));
    }
    let _e152 = chosen_8;
    return _e152;
}

// glimt_probe/src/mirror_ball.rs:247
fn mirror_ball_solid_angle_sr_per_area(this_4: MirrorBall, p_2: vec2<f32>) -> f32 {

    // glimt_probe/src/mirror_ball.rs:248
    let s2_1 = dot(p_2, p_2);
    // glimt_probe/src/mirror_ball.rs:249
    if (s2_1 > 1f) {
        // glimt_probe/src/mirror_ball.rs:250
        return 0f;
    }
    // glimt_probe/src/mirror_ball.rs:252
    let s2_2 = min(s2_1, 0.999998f);
    // glimt_probe/src/mirror_ball.rs:253
    let k_3 = this_4.radius_over_distance;
    // glimt_probe/src/mirror_ball.rs:254
    let k2_1 = (k_3 * k_3);
    // glimt_probe/src/mirror_ball.rs:255
    let w = (1f / (1f - (k2_1 * (1f - s2_2))));
    // glimt_probe/src/mirror_ball.rs:256
    let sin2_i = (s2_2 * w);
    // glimt_probe/src/mirror_ball.rs:257
    let cos_i_2 = sqrt((((1f - s2_2) * (1f - k2_1)) * w));
    // glimt_probe/src/mirror_ball.rs:258
    let cos_beta_2 = sqrt((1f - (k2_1 * sin2_i)));
    // glimt_probe/src/mirror_ball.rs:260
    let sin_over_s = ((((2f * cos_i_2) * cos_beta_2) - ((1f - (2f * sin2_i)) * k_3)) * sqrt(w));
    // glimt_probe/src/mirror_ball.rs:261
    let slope = (((((2f / cos_i_2) - (k_3 / cos_beta_2)) * (1f - k2_1)) * w) * sqrt(w));
    // glimt_probe/src/mirror_ball.rs:262
    return clamp((sin_over_s * slope), 0f, ((4f * 3.1415927f) * 10000f));
}

// glimt_probe/src/gather.rs:129
fn weight(tap: u32) -> f32 {

    // glimt_probe/src/gather.rs:130
    return f32(i32((tap & 65535u)));
}

// glimt_probe/src/gather.rs:72
fn ColourMatrix_apply(this_5: ColourMatrix, colour: vec4<f32>) -> vec4<f32> {

    // glimt_probe/src/gather.rs:73
    let changed = (((this_5.red * colour.x) + (this_5.green * colour.y)) + (this_5.blue * colour.z));
    // glimt_probe/src/gather.rs:75
    return max(changed, vec4<f32>(0f, 0f, 0f, 1f));
}

// glimt_probe/src/gather.rs:100
fn gather_texel(texel_1: u32, colour_1: ColourMatrix, reflectance: vec4<f32>) -> vec4<f32> {
    var pixel: u32;
    var even: vec4<f32>;
    var odd: vec4<f32>;
    var i: u32;

    // glimt_probe/src/gather.rs:107
    let begin = map_texels[texel_1];
    // glimt_probe/src/gather.rs:108
    let end = map_texels[(texel_1 + 1u)].tap;
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

