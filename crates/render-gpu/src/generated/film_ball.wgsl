// Made from Rust by naga-front-rust; do not edit. This command writes it: cargo run --release -p glimt-generate

struct CaptureParams {
    shake_x: vec3<f32>,
    width: u32,
    shake_y: vec3<f32>,
    height: u32,
    shake_z: vec3<f32>,
    focal_px: f32,
    ball_centre: vec3<f32>,
    ball_radius: f32,
    forward: vec3<f32>,
    radius_over_distance: f32,
    right: vec3<f32>,
    outline: f32,
    up: vec3<f32>,
    samples: u32,
    tint: vec3<f32>,
    fresnel: f32,
    eye: vec3<f32>,
    unused_a: u32,
    rig_half_size: vec3<f32>,
    unused_b: u32,
    rig_radiance: vec3<f32>,
    unused_c: u32,
}

struct StageParams {
    half_size: vec3<f32>,
    shape: u32,
    occluder_centre: vec3<f32>,
    occluder_radius: f32,
    occluder_radiance: vec3<f32>,
    unused: f32,
    size: vec2<u32>,
    rotation: vec2<f32>,
}

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

struct Params {
    first: u32,
    count: u32,
    capture: CaptureParams,
    stage_params: StageParams,
}

@group(0) @binding(1) 
var<storage> stage_texels: array<vec4<f32>>;
@group(0) @binding(2) 
var<storage, read_write> out: array<vec4<f32>>;
@group(0) @binding(0) 
var<uniform> params_4: Params;

// glimt_render_gpu/src/kernels/capture.rs:81
fn CaptureParams_image_point(this_: CaptureParams, pixel: vec2<f32>) -> vec2<f32> {

    // glimt_render_gpu/src/kernels/capture.rs:82
    let middle = (vec2<f32>(f32(this_.width), f32(this_.height)) * 0.5f);
    // glimt_render_gpu/src/kernels/capture.rs:83
    let on_sensor = vec3<f32>(((pixel - middle) / vec2(this_.focal_px)), 1f);
    // glimt_render_gpu/src/kernels/capture.rs:84
    let depth = max(dot(this_.shake_z, on_sensor), 0.000001f);
    // glimt_render_gpu/src/kernels/capture.rs:85
    return (vec2<f32>(dot(this_.shake_x, on_sensor), dot(this_.shake_y, on_sensor)) / vec2((depth * this_.outline)));
}

// glimt_render_gpu/src/kernels/capture.rs:68
fn CaptureParams_ball(this_1: CaptureParams) -> MirrorBall {

    // glimt_render_gpu/src/kernels/capture.rs:69
    return MirrorBall(this_1.forward, this_1.radius_over_distance, this_1.right, this_1.up);
}

// glimt_probe/src/mirror_ball.rs:247
fn MirrorBall_solid_angle_sr_per_area(this_2: MirrorBall, p: vec2<f32>) -> f32 {

    // glimt_probe/src/mirror_ball.rs:248
    let s2_ = dot(p, p);
    // glimt_probe/src/mirror_ball.rs:249
    if (s2_ > 1f) {
        // glimt_probe/src/mirror_ball.rs:250
        return 0f;
    }
    // glimt_probe/src/mirror_ball.rs:252
    let s2_1 = min(s2_, 0.999998f);
    // glimt_probe/src/mirror_ball.rs:253
    let k = this_2.radius_over_distance;
    // glimt_probe/src/mirror_ball.rs:254
    let k2_ = (k * k);
    // glimt_probe/src/mirror_ball.rs:255
    let w = (1f / (1f - (k2_ * (1f - s2_1))));
    // glimt_probe/src/mirror_ball.rs:256
    let sin2_i = (s2_1 * w);
    // glimt_probe/src/mirror_ball.rs:257
    let cos_i = sqrt((((1f - s2_1) * (1f - k2_)) * w));
    // glimt_probe/src/mirror_ball.rs:258
    let cos_beta = sqrt((1f - (k2_ * sin2_i)));
    // glimt_probe/src/mirror_ball.rs:260
    let sin_over_s = ((((2f * cos_i) * cos_beta) - ((1f - (2f * sin2_i)) * k)) * sqrt(w));
    // glimt_probe/src/mirror_ball.rs:261
    let slope = (((((2f / cos_i) - (k / cos_beta)) * (1f - k2_)) * w) * sqrt(w));
    // glimt_probe/src/mirror_ball.rs:262
    return clamp((sin_over_s * slope), 0f, ((4f * 3.1415927f) * 10000f));
}

// glimt_render_gpu/src/kernels/capture.rs:93
fn CaptureParams_samples_along_side(this_3: CaptureParams, p_1: vec2<f32>, map_size: vec2<u32>) -> u32 {

    // glimt_render_gpu/src/kernels/capture.rs:94
    let radius_px = (this_3.focal_px * this_3.outline);
    // glimt_render_gpu/src/kernels/capture.rs:95
    let reach = (0.75f / radius_px);
    // glimt_render_gpu/src/kernels/capture.rs:96
    let s = length(p_1);
    // glimt_render_gpu/src/kernels/capture.rs:97
    if (s > (1f + reach)) {
        // glimt_render_gpu/src/kernels/capture.rs:98
        return 1u;
    }
    // glimt_render_gpu/src/kernels/capture.rs:100
    let texel_sr = (19.73921f / (f32(map_size.x) * f32(map_size.y)));
    // glimt_render_gpu/src/kernels/capture.rs:101
    let inside = (p_1 * max((1f - reach), 0f));
    // glimt_render_gpu/src/kernels/capture.rs:102
    let _e34 = CaptureParams_ball(this_3);
    let _e35 = MirrorBall_solid_angle_sr_per_area(_e34, inside);
    let pixel_sr = (_e35 / (radius_px * radius_px));
    // glimt_render_gpu/src/kernels/capture.rs:103
    let stretch = (1f / sqrt(max((1f - dot(inside, inside)), 0.004f)));
    // glimt_render_gpu/src/kernels/capture.rs:104
    let wanted = ((f32(this_3.samples) * max((pixel_sr / texel_sr), 0.25f)) * stretch);
    // glimt_render_gpu/src/kernels/capture.rs:105
    return u32(clamp((sqrt(wanted) + 0.5f), 1f, 32f));
}

// glimt_render_gpu/src/kernels/stage.rs:93
fn Stage_occluder_distance(params: StageParams, origin: vec3<f32>, d: vec3<f32>) -> f32 {
    var chosen: f32;

    // glimt_render_gpu/src/kernels/stage.rs:94
    let radius = params.occluder_radius;
    // glimt_render_gpu/src/kernels/stage.rs:95
    if (radius <= 0f) {
        // glimt_render_gpu/src/kernels/stage.rs:96
        return 1000000000000000000000000000000f;
    }
    // glimt_render_gpu/src/kernels/stage.rs:98
    let to_centre = (params.occluder_centre - origin);
    // glimt_render_gpu/src/kernels/stage.rs:99
    let along = dot(to_centre, d);
    // glimt_render_gpu/src/kernels/stage.rs:100
    let aside = (to_centre - (d * along));
    // glimt_render_gpu/src/kernels/stage.rs:101
    let left = ((radius * radius) - dot(aside, aside));
    // glimt_render_gpu/src/kernels/stage.rs:102
    let t = (along - sqrt(max(left, 0f)));
    // glimt_render_gpu/src/kernels/stage.rs:103
    if ((left > 0f) && (t > 0f)) {
        chosen = t;
    } else {
        chosen = 1000000000000000000000000000000f;
    }
    let _e36 = chosen;
    return _e36;
}

// glimt_probe/src/mirror_ball.rs:139
fn MirrorBall_reflect(this_4: MirrorBall, p_2: vec2<f32>) -> Option_Reflection {
    var chosen_1: vec3<f32>;

    // glimt_probe/src/mirror_ball.rs:140
    let s2_2 = dot(p_2, p_2);
    // glimt_probe/src/mirror_ball.rs:141
    if (s2_2 > 1f) {
        // glimt_probe/src/mirror_ball.rs:142
        return Option_Reflection();
    }
    // glimt_probe/src/mirror_ball.rs:144
    let k_1 = this_4.radius_over_distance;
    // glimt_probe/src/mirror_ball.rs:145
    let k2_1 = (k_1 * k_1);
    // glimt_probe/src/mirror_ball.rs:147
    let scale = (1f / sqrt((1f - (k2_1 * (1f - s2_2)))));
    // glimt_probe/src/mirror_ball.rs:148
    let s_1 = sqrt(s2_2);
    // glimt_probe/src/mirror_ball.rs:149
    let sin_i = (s_1 * scale);
    // glimt_probe/src/mirror_ball.rs:150
    let cos_i_1 = (sqrt(((1f - s2_2) * (1f - k2_1))) * scale);
    // glimt_probe/src/mirror_ball.rs:151
    let sin_beta = (k_1 * sin_i);
    // glimt_probe/src/mirror_ball.rs:152
    let cos_beta_1 = sqrt((1f - (sin_beta * sin_beta)));
    // glimt_probe/src/mirror_ball.rs:154
    let sin_n = ((sin_i * cos_beta_1) - (cos_i_1 * sin_beta));
    // glimt_probe/src/mirror_ball.rs:155
    let cos_n = ((cos_i_1 * cos_beta_1) + (sin_i * sin_beta));
    // glimt_probe/src/mirror_ball.rs:156
    let sin_d = ((sin_i * cos_n) + (cos_i_1 * sin_n));
    // glimt_probe/src/mirror_ball.rs:157
    let cos_d = ((cos_i_1 * cos_n) - (sin_i * sin_n));
    // glimt_probe/src/mirror_ball.rs:158
    if (s_1 > 0f) {
        // glimt_probe/src/mirror_ball.rs:159
        chosen_1 = (((this_4.right * p_2.x) - (this_4.up * p_2.y)) / vec3(s_1));
    } else {
        // glimt_probe/src/mirror_ball.rs:161
        chosen_1 = this_4.right;
    }
    let across = chosen_1;
    // glimt_probe/src/mirror_ball.rs:163
    return Option_Reflection(true, Reflection(((across * sin_d) - (this_4.forward * cos_d)), ((across * sin_n) - (this_4.forward * cos_n)), cos_i_1));
}

// glimt_render_gpu/src/kernels/capture.rs:140
fn CaptureParams_reflectance(this_5: CaptureParams, cos_incidence: f32) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/capture.rs:141
    let m = clamp((1f - cos_incidence), 0f, 1f);
    // glimt_render_gpu/src/kernels/capture.rs:142
    let m2_ = (m * m);
    // glimt_render_gpu/src/kernels/capture.rs:143
    return (this_5.tint + ((vec3(1f) - this_5.tint) * (((this_5.fresnel * m2_) * m2_) * m)));
}

// glimt_render_gpu/src/kernels/capture.rs:170
fn slab(from_: f32, d_1: f32, half: f32) -> vec2<f32> {
    var chosen_2: vec2<f32>;

    // glimt_render_gpu/src/kernels/capture.rs:171
    if (abs(d_1) < 0.000000000001f) {
        // glimt_render_gpu/src/kernels/capture.rs:173
        let inside_1 = (abs(from_) <= half);
        // glimt_render_gpu/src/kernels/capture.rs:174
        if inside_1 {
            // glimt_render_gpu/src/kernels/capture.rs:175
            chosen_2 = vec2<f32>(-1000000000000000000000000000000f, 1000000000000000000000000000000f);
        } else {
            // glimt_render_gpu/src/kernels/capture.rs:177
            chosen_2 = vec2<f32>(1000000000000000000000000000000f, -1000000000000000000000000000000f);
        }
        let _e21 = chosen_2;
        return _e21;
    }
    // glimt_render_gpu/src/kernels/capture.rs:180
    let a = ((-(half) - from_) / d_1);
    // glimt_render_gpu/src/kernels/capture.rs:181
    let b = ((half - from_) / d_1);
    // glimt_render_gpu/src/kernels/capture.rs:182
    return vec2<f32>(min(a, b), max(a, b));
}

// glimt_render_gpu/src/kernels/capture.rs:149
fn CaptureParams_rig_distance(this_6: CaptureParams, origin_1: vec3<f32>, d_2: vec3<f32>) -> f32 {
    var chosen_3: f32;

    // glimt_render_gpu/src/kernels/capture.rs:150
    let from_1 = (origin_1 - this_6.eye);
    // glimt_render_gpu/src/kernels/capture.rs:151
    let half_2 = this_6.rig_half_size;
    // glimt_render_gpu/src/kernels/capture.rs:152
    if (min(min(half_2.x, half_2.y), half_2.z) <= 0f) {
        // glimt_render_gpu/src/kernels/capture.rs:153
        return 1000000000000000000000000000000f;
    }
    // glimt_render_gpu/src/kernels/capture.rs:155
    let _e25 = slab(dot(from_1, this_6.right), dot(d_2, this_6.right), half_2.x);
    // glimt_render_gpu/src/kernels/capture.rs:156
    let _e32 = slab(dot(from_1, this_6.up), dot(d_2, this_6.up), half_2.y);
    // glimt_render_gpu/src/kernels/capture.rs:157
    let _e39 = slab(dot(from_1, this_6.forward), dot(d_2, this_6.forward), half_2.z);
    // glimt_render_gpu/src/kernels/capture.rs:158
    let near = max(max(_e25.x, _e32.x), _e39.x);
    // glimt_render_gpu/src/kernels/capture.rs:159
    let far = min(min(_e25.y, _e32.y), _e39.y);
    // glimt_render_gpu/src/kernels/capture.rs:160
    if ((near <= far) && (near > 0f)) {
        // glimt_render_gpu/src/kernels/capture.rs:161
        chosen_3 = near;
    } else {
        // glimt_render_gpu/src/kernels/capture.rs:163
        chosen_3 = 1000000000000000000000000000000f;
    }
    let _e61 = chosen_3;
    return _e61;
}

// glimt_render_gpu/src/kernels/stage.rs:109
fn wall_distance(origin_2: f32, d_3: f32, half_1: f32) -> f32 {
    var chosen_4: f32;
    var chosen_5: f32;

    // glimt_render_gpu/src/kernels/stage.rs:110
    if (d_3 > 0.000000000001f) {
        // glimt_render_gpu/src/kernels/stage.rs:111
        chosen_4 = ((half_1 - origin_2) / d_3);
    } else {
        if (d_3 < -0.000000000001f) {
            // glimt_render_gpu/src/kernels/stage.rs:113
            chosen_5 = ((-(half_1) - origin_2) / d_3);
        } else {
            // glimt_render_gpu/src/kernels/stage.rs:115
            chosen_5 = 1000000000000000000000000000000f;
        }
        let _e20 = chosen_5;
        chosen_4 = _e20;
    }
    let _e21 = chosen_4;
    return _e21;
}

// glimt_render_gpu/src/kernels/stage.rs:74
fn Stage_point_seen(params_1: StageParams, origin_3: vec3<f32>, d_4: vec3<f32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/stage.rs:75
    if (params_1.shape == 0u) {
        // glimt_render_gpu/src/kernels/stage.rs:76
        return d_4;
    }
    // glimt_render_gpu/src/kernels/stage.rs:78
    let half_3 = params_1.half_size;
    // glimt_render_gpu/src/kernels/stage.rs:79
    if (params_1.shape == 1u) {
        // glimt_render_gpu/src/kernels/stage.rs:80
        let b_1 = dot(origin_3, d_4);
        // glimt_render_gpu/src/kernels/stage.rs:81
        let c = (dot(origin_3, origin_3) - (half_3.x * half_3.x));
        // glimt_render_gpu/src/kernels/stage.rs:82
        return (origin_3 + (d_4 * (sqrt(max(((b_1 * b_1) - c), 0f)) - b_1)));
    }
    // glimt_render_gpu/src/kernels/stage.rs:84
    let _e36 = wall_distance(origin_3.x, d_4.x, half_3.x);
    let _e40 = wall_distance(origin_3.y, d_4.y, half_3.y);
    let _e45 = wall_distance(origin_3.z, d_4.z, half_3.z);
    let t_1 = min(min(_e36, _e40), _e45);
    // glimt_render_gpu/src/kernels/stage.rs:87
    return (origin_3 + (d_4 * max(t_1, 0f)));
}

// glimt_probe/src/rotate.rs:33
fn rotate_z(d_5: vec3<f32>, cos_sin: vec2<f32>) -> vec3<f32> {

    // glimt_probe/src/rotate.rs:34
    return vec3<f32>(((d_5.x * cos_sin.x) - (d_5.y * cos_sin.y)), ((d_5.x * cos_sin.y) + (d_5.y * cos_sin.x)), d_5.z);
}

// glimt_probe/src/latlong.rs:45
fn direction_to_uv(d_6: vec3<f32>) -> vec2<f32> {
    var chosen_6: f32;
    var chosen_7: f32;

    // glimt_probe/src/latlong.rs:46
    let horizontal = sqrt(((d_6.x * d_6.x) + (d_6.y * d_6.y)));
    // glimt_probe/src/latlong.rs:47
    if (horizontal <= 0f) {
        // glimt_probe/src/latlong.rs:48
        if (d_6.z < 0f) {
            chosen_6 = 1f;
        } else {
            chosen_6 = 0f;
        }
        let v = chosen_6;
        // glimt_probe/src/latlong.rs:49
        return vec2<f32>(0.5f, v);
    }
    // glimt_probe/src/latlong.rs:52
    let v_1 = (atan2(horizontal, d_6.z) * 0.31830987f);
    // glimt_probe/src/latlong.rs:53
    let u = (0.5f - ((0.5f * 0.31830987f) * atan2(d_6.y, d_6.x)));
    // glimt_probe/src/latlong.rs:54
    if (u < 1f) {
        chosen_7 = max(u, 0f);
    } else {
        chosen_7 = 0f;
    }
    let _e47 = chosen_7;
    return vec2<f32>(_e47, clamp(v_1, 0f, 1f));
}

// glimt_render_gpu/src/kernels/environment.rs:146
fn bilinear(size: vec2<u32>, d_7: vec3<f32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/environment.rs:147
    let _e4 = direction_to_uv(d_7);
    let p_4 = ((_e4 * vec2<f32>(size)) - vec2(0.5f));
    // glimt_render_gpu/src/kernels/environment.rs:149
    let next = vec2<u32>((p_4 + vec2(1f)));
    // glimt_render_gpu/src/kernels/environment.rs:150
    let f = ((p_4 + vec2(1f)) - vec2<f32>(next));
    // glimt_render_gpu/src/kernels/environment.rs:151
    let x0_ = (((next.x + size.x) - 1u) % size.x);
    // glimt_render_gpu/src/kernels/environment.rs:152
    let x1_ = (next.x % size.x);
    // glimt_render_gpu/src/kernels/environment.rs:153
    let row0_ = ((max(next.y, 1u) * size.x) - size.x);
    // glimt_render_gpu/src/kernels/environment.rs:154
    let row1_ = (min(next.y, (size.y - 1u)) * size.x);
    // glimt_render_gpu/src/kernels/environment.rs:155
    let _e53 = stage_texels[(row0_ + x0_)];
    let _e57 = stage_texels[(row0_ + x1_)];
    let upper = ((_e53 * (1f - f.x)) + (_e57 * f.x));
    // glimt_render_gpu/src/kernels/environment.rs:156
    let _e68 = stage_texels[(row1_ + x0_)];
    let _e72 = stage_texels[(row1_ + x1_)];
    let lower = ((_e68 * (1f - f.x)) + (_e72 * f.x));
    // glimt_render_gpu/src/kernels/environment.rs:157
    return ((upper * (1f - f.y)) + (lower * f.y)).xyz;
}

// glimt_render_gpu/src/kernels/stage.rs:64
fn Stage_map_radiance(params_2: StageParams, origin_4: vec3<f32>, d_8: vec3<f32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/stage.rs:65
    let back = vec2<f32>(params_2.rotation.x, -(params_2.rotation.y));
    // glimt_render_gpu/src/kernels/stage.rs:66
    let _e12 = Stage_point_seen(params_2, origin_4, d_8);
    let _e13 = rotate_z(_e12, back);
    // glimt_render_gpu/src/kernels/stage.rs:67
    let _e16 = bilinear(params_2.size, _e13);
    return _e16;
}

// glimt_render_gpu/src/kernels/stage.rs:54
fn Stage_radiance(params_3: StageParams, origin_5: vec3<f32>, d_9: vec3<f32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/stage.rs:55
    let _e5 = Stage_occluder_distance(params_3, origin_5, d_9);
    if (_e5 < 1000000000000000000000000000000f) {
        // glimt_render_gpu/src/kernels/stage.rs:56
        return params_3.occluder_radiance;
    }
    // glimt_render_gpu/src/kernels/stage.rs:58
    let _e11 = Stage_map_radiance(params_3, origin_5, d_9);
    return _e11;
}

// glimt_render_gpu/src/kernels/capture.rs:129
fn CaptureParams_reflected(this_7: CaptureParams, point: vec3<f32>, direction: vec3<f32>, stage_params: StageParams) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/capture.rs:130
    let _e6 = CaptureParams_rig_distance(this_7, point, direction);
    // glimt_render_gpu/src/kernels/capture.rs:131
    let _e8 = Stage_occluder_distance(stage_params, point, direction);
    if (_e6 < _e8) {
        // glimt_render_gpu/src/kernels/capture.rs:132
        return this_7.rig_radiance;
    }
    // glimt_render_gpu/src/kernels/capture.rs:134
    let _e13 = Stage_radiance(stage_params, point, direction);
    return _e13;
}

// glimt_render_gpu/src/kernels/capture.rs:111
fn CaptureParams_radiance(this_8: CaptureParams, p_3: vec2<f32>, stage_params_1: StageParams) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/capture.rs:112
    let flat = (p_3 * this_8.outline);
    // glimt_render_gpu/src/kernels/capture.rs:113
    let direction_1 = normalize(((this_8.forward + (this_8.right * flat.x)) - (this_8.up * flat.y)));
    // glimt_render_gpu/src/kernels/capture.rs:114
    let _e20 = Stage_occluder_distance(stage_params_1, this_8.eye, direction_1);
    // glimt_render_gpu/src/kernels/capture.rs:115
    let distance_ = (this_8.ball_radius / this_8.radius_over_distance);
    // glimt_render_gpu/src/kernels/capture.rs:116
    let _e26 = CaptureParams_ball(this_8);
    let _e27 = MirrorBall_reflect(_e26, p_3);
    let seen = _e27.value;
    if _e27.is_some {
        // glimt_render_gpu/src/kernels/capture.rs:117
        if (_e20 < distance_) {
            // glimt_render_gpu/src/kernels/capture.rs:118
            return stage_params_1.occluder_radiance;
        }
        // glimt_render_gpu/src/kernels/capture.rs:120
        let point_1 = (this_8.ball_centre + (seen.normal * this_8.ball_radius));
        // glimt_render_gpu/src/kernels/capture.rs:121
        let _e42 = CaptureParams_reflectance(this_8, seen.cos_incidence);
        let _e44 = CaptureParams_reflected(this_8, point_1, seen.direction, stage_params_1);
        return (_e42 * _e44);
    }
    // glimt_render_gpu/src/kernels/capture.rs:124
    let _e48 = Stage_radiance(stage_params_1, this_8.eye, direction_1);
    return _e48;
}

// glimt_render_gpu/src/kernels/capture.rs:190
fn film_ball_1(pixel_1: u32, capture: CaptureParams, stage_params_2: StageParams) -> vec4<f32> {
    var sum: vec3<f32>;
    var counter: u32;
    var counter_1: u32;

    // glimt_render_gpu/src/kernels/capture.rs:191
    let corner = vec2<f32>(vec2<u32>((pixel_1 % capture.width), (pixel_1 / capture.width)));
    // glimt_render_gpu/src/kernels/capture.rs:192
    let _e15 = CaptureParams_image_point(capture, (corner + vec2(0.5f)));
    // glimt_render_gpu/src/kernels/capture.rs:193
    let _e18 = CaptureParams_samples_along_side(capture, _e15, stage_params_2.size);
    // glimt_render_gpu/src/kernels/capture.rs:194
    sum = vec3(0f);
    // glimt_render_gpu/src/kernels/capture.rs:195
    counter = 0u;
    loop {
        let j = counter;
        if (j >= _e18) {
            break;
        }
        // glimt_render_gpu/src/kernels/capture.rs:196
        counter_1 = 0u;
        loop {
            let i = counter_1;
            if (i >= _e18) {
                break;
            }
            // glimt_render_gpu/src/kernels/capture.rs:197
            let inside_2 = ((vec2<f32>(vec2<u32>(i, j)) + vec2(0.5f)) / vec2(f32(_e18)));
            // glimt_render_gpu/src/kernels/capture.rs:198
            let _e44 = CaptureParams_image_point(capture, (corner + inside_2));
            let _e45 = CaptureParams_radiance(capture, _e44, stage_params_2);
            let _e46 = sum;
            sum = (_e46 + _e45);
            continuing {
                let _e48 = counter_1;
                counter_1 = (_e48 + 1u);
            }
        }
        continuing {
            let _e51 = counter;
            counter = (_e51 + 1u);
        }
    }
    // glimt_render_gpu/src/kernels/capture.rs:201
    let _e55 = sum;
    return vec4<f32>((_e55 / vec3(f32((_e18 * _e18)))), 1f);
}

@compute @workgroup_size(64, 1, 1) 
fn film_ball(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let local = ((id.y * (groups.x * 64u)) + id.x);
    let _e11 = params_4.count;
    if (local >= _e11) {
        return;
    }
    let _e14 = params_4.first;
    let _e17 = params_4.capture;
    let _e19 = params_4.stage_params;
    let _e20 = film_ball_1((_e14 + local), _e17, _e19);
    out[local] = _e20;
}
