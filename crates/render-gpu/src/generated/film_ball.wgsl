// Made from Rust by naga-front-rust; do not edit. To make it anew: cargo run --release -p glimt-tests --bin regenerate

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
    seed: u32,
    rig_half_size: vec3<f32>,
    frame: u32,
    rig_radiance: vec3<f32>,
    unused: f32,
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
    unused_a: f32,
    up: vec3<f32>,
    unused_b: f32,
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
var<storage> params_4: Params;

// glimt_render_gpu/src/kernels/capture.rs:85
fn CaptureParams_image_point(this_: CaptureParams, pixel: vec2<f32>) -> vec2<f32> {

    // glimt_render_gpu/src/kernels/capture.rs:86
    let middle = (vec2<f32>(f32(this_.width), f32(this_.height)) * 0.5f);
    // glimt_render_gpu/src/kernels/capture.rs:87
    let on_sensor = vec3<f32>(((pixel - middle) / vec2(this_.focal_px)), 1f);
    // glimt_render_gpu/src/kernels/capture.rs:88
    let depth = max(dot(this_.shake_z, on_sensor), 0.000001f);
    // glimt_render_gpu/src/kernels/capture.rs:89
    return (vec2<f32>(dot(this_.shake_x, on_sensor), dot(this_.shake_y, on_sensor)) / vec2((depth * this_.outline)));
}

// glimt_render_gpu/src/kernels/capture.rs:70
fn CaptureParams_ball(this_1: CaptureParams) -> MirrorBall {

    // glimt_render_gpu/src/kernels/capture.rs:71
    return MirrorBall(this_1.forward, this_1.radius_over_distance, this_1.right, 0f, this_1.up, 0f);
}

// glimt_probe/src/mirror_ball.rs:245
fn MirrorBall_solid_angle_sr_per_area(this_2: MirrorBall, p: vec2<f32>) -> f32 {

    // glimt_probe/src/mirror_ball.rs:246
    let s2_ = dot(p, p);
    // glimt_probe/src/mirror_ball.rs:247
    if (s2_ > 1f) {
        // glimt_probe/src/mirror_ball.rs:248
        return 0f;
    }
    // glimt_probe/src/mirror_ball.rs:250
    let s2_1 = min(s2_, 0.9998f);
    // glimt_probe/src/mirror_ball.rs:251
    let k = this_2.radius_over_distance;
    // glimt_probe/src/mirror_ball.rs:252
    let k2_ = (k * k);
    // glimt_probe/src/mirror_ball.rs:253
    let w_1 = (1f / (1f - (k2_ * (1f - s2_1))));
    // glimt_probe/src/mirror_ball.rs:254
    let sin2_i = (s2_1 * w_1);
    // glimt_probe/src/mirror_ball.rs:255
    let cos_i = sqrt((((1f - s2_1) * (1f - k2_)) * w_1));
    // glimt_probe/src/mirror_ball.rs:256
    let cos_beta = sqrt((1f - (k2_ * sin2_i)));
    // glimt_probe/src/mirror_ball.rs:258
    let sin_over_s = ((((2f * cos_i) * cos_beta) - ((1f - (2f * sin2_i)) * k)) * sqrt(w_1));
    // glimt_probe/src/mirror_ball.rs:259
    let slope = (((((2f / cos_i) - (k / cos_beta)) * (1f - k2_)) * w_1) * sqrt(w_1));
    // glimt_probe/src/mirror_ball.rs:260
    return clamp((sin_over_s * slope), 0f, ((4f * 3.1415927f) * 10000f));
}

// glimt_render_gpu/src/kernels/capture.rs:96
fn CaptureParams_samples_at(this_3: CaptureParams, p_1: vec2<f32>, map_size: vec2<u32>) -> u32 {

    // glimt_render_gpu/src/kernels/capture.rs:97
    let radius_px = (this_3.focal_px * this_3.outline);
    // glimt_render_gpu/src/kernels/capture.rs:98
    let reach = (0.75f / radius_px);
    // glimt_render_gpu/src/kernels/capture.rs:99
    let s = length(p_1);
    // glimt_render_gpu/src/kernels/capture.rs:100
    if (s > (1f + reach)) {
        // glimt_render_gpu/src/kernels/capture.rs:101
        return 1u;
    }
    // glimt_render_gpu/src/kernels/capture.rs:103
    let texel_sr = (19.73921f / (f32(map_size.x) * f32(map_size.y)));
    // glimt_render_gpu/src/kernels/capture.rs:104
    let inside = (p_1 * max((1f - reach), 0f));
    // glimt_render_gpu/src/kernels/capture.rs:105
    let _e34 = CaptureParams_ball(this_3);
    let _e35 = MirrorBall_solid_angle_sr_per_area(_e34, inside);
    let pixel_sr = (_e35 / (radius_px * radius_px));
    // glimt_render_gpu/src/kernels/capture.rs:106
    let stretch = (1f / sqrt(max((1f - dot(inside, inside)), 0.004f)));
    // glimt_render_gpu/src/kernels/capture.rs:107
    let wanted = ((f32(this_3.samples) * max((pixel_sr / texel_sr), 1f)) * stretch);
    // glimt_render_gpu/src/kernels/capture.rs:108
    return u32(clamp(wanted, 1f, 1024f));
}

// glimt_render_gpu/src/kernels/stage.rs:93
fn Stage_occluder_distance(params: StageParams, origin: vec3<f32>, d: vec3<f32>) -> f32 {
    var chosen: f32;

    // glimt_render_gpu/src/kernels/stage.rs:94
    let radius = params.occluder_radius;
    // glimt_render_gpu/src/kernels/stage.rs:95
    let to_centre = (params.occluder_centre - origin);
    // glimt_render_gpu/src/kernels/stage.rs:96
    let along = dot(to_centre, d);
    // glimt_render_gpu/src/kernels/stage.rs:97
    let aside = (to_centre - (d * along));
    // glimt_render_gpu/src/kernels/stage.rs:98
    let left = ((radius * radius) - dot(aside, aside));
    // glimt_render_gpu/src/kernels/stage.rs:99
    let t = (along - sqrt(max(left, 0f)));
    // glimt_render_gpu/src/kernels/stage.rs:100
    if ((left > 0f) && (t > 0f)) {
        chosen = t;
    } else {
        chosen = 1000000000000000000000000000000f;
    }
    let _e31 = chosen;
    return _e31;
}

// glimt_probe/src/mirror_ball.rs:146
fn MirrorBall_reflect(this_4: MirrorBall, p_2: vec2<f32>) -> Option_Reflection {
    var chosen_1: vec3<f32>;

    // glimt_probe/src/mirror_ball.rs:147
    let s2_2 = dot(p_2, p_2);
    // glimt_probe/src/mirror_ball.rs:148
    if (s2_2 > 1f) {
        // glimt_probe/src/mirror_ball.rs:149
        return Option_Reflection();
    }
    // glimt_probe/src/mirror_ball.rs:151
    let k_1 = this_4.radius_over_distance;
    // glimt_probe/src/mirror_ball.rs:152
    let k2_1 = (k_1 * k_1);
    // glimt_probe/src/mirror_ball.rs:154
    let scale = (1f / sqrt((1f - (k2_1 * (1f - s2_2)))));
    // glimt_probe/src/mirror_ball.rs:155
    let s_1 = sqrt(s2_2);
    // glimt_probe/src/mirror_ball.rs:156
    let sin_i = (s_1 * scale);
    // glimt_probe/src/mirror_ball.rs:157
    let cos_i_1 = (sqrt(((1f - s2_2) * (1f - k2_1))) * scale);
    // glimt_probe/src/mirror_ball.rs:158
    let sin_beta = (k_1 * sin_i);
    // glimt_probe/src/mirror_ball.rs:159
    let cos_beta_1 = sqrt((1f - (sin_beta * sin_beta)));
    // glimt_probe/src/mirror_ball.rs:161
    let sin_n = ((sin_i * cos_beta_1) - (cos_i_1 * sin_beta));
    // glimt_probe/src/mirror_ball.rs:162
    let cos_n = ((cos_i_1 * cos_beta_1) + (sin_i * sin_beta));
    // glimt_probe/src/mirror_ball.rs:163
    let sin_d = ((sin_i * cos_n) + (cos_i_1 * sin_n));
    // glimt_probe/src/mirror_ball.rs:164
    let cos_d = ((cos_i_1 * cos_n) - (sin_i * sin_n));
    // glimt_probe/src/mirror_ball.rs:165
    if (s_1 > 0f) {
        // glimt_probe/src/mirror_ball.rs:166
        chosen_1 = (((this_4.right * p_2.x) - (this_4.up * p_2.y)) / vec3(s_1));
    } else {
        // glimt_probe/src/mirror_ball.rs:168
        chosen_1 = this_4.right;
    }
    let across = chosen_1;
    // glimt_probe/src/mirror_ball.rs:170
    return Option_Reflection(true, Reflection(((across * sin_d) - (this_4.forward * cos_d)), ((across * sin_n) - (this_4.forward * cos_n)), cos_i_1));
}

// glimt_render_gpu/src/kernels/capture.rs:143
fn CaptureParams_reflectance(this_5: CaptureParams, cos_incidence: f32) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/capture.rs:144
    let m = clamp((1f - cos_incidence), 0f, 1f);
    // glimt_render_gpu/src/kernels/capture.rs:145
    let m2_ = (m * m);
    // glimt_render_gpu/src/kernels/capture.rs:146
    return (this_5.tint + ((vec3(1f) - this_5.tint) * (((this_5.fresnel * m2_) * m2_) * m)));
}

// glimt_render_gpu/src/kernels/capture.rs:169
fn slab(from_: f32, d_1: f32, half: f32) -> vec2<f32> {
    var chosen_2: vec2<f32>;

    // glimt_render_gpu/src/kernels/capture.rs:170
    if (abs(d_1) < 0.000000000001f) {
        // glimt_render_gpu/src/kernels/capture.rs:172
        let inside_1 = (abs(from_) <= half);
        // glimt_render_gpu/src/kernels/capture.rs:173
        if inside_1 {
            // glimt_render_gpu/src/kernels/capture.rs:174
            chosen_2 = vec2<f32>(-1000000000000000000000000000000f, 1000000000000000000000000000000f);
        } else {
            // glimt_render_gpu/src/kernels/capture.rs:176
            chosen_2 = vec2<f32>(1000000000000000000000000000000f, -1000000000000000000000000000000f);
        }
        let _e21 = chosen_2;
        return _e21;
    }
    // glimt_render_gpu/src/kernels/capture.rs:179
    let a_2 = ((-(half) - from_) / d_1);
    // glimt_render_gpu/src/kernels/capture.rs:180
    let b_2 = ((half - from_) / d_1);
    // glimt_render_gpu/src/kernels/capture.rs:181
    return vec2<f32>(min(a_2, b_2), max(a_2, b_2));
}

// glimt_render_gpu/src/kernels/capture.rs:152
fn CaptureParams_rig_distance(this_6: CaptureParams, origin_1: vec3<f32>, d_2: vec3<f32>) -> f32 {
    var chosen_3: f32;

    // glimt_render_gpu/src/kernels/capture.rs:153
    let from_1 = (origin_1 - this_6.eye);
    // glimt_render_gpu/src/kernels/capture.rs:154
    let half_2 = this_6.rig_half_size;
    // glimt_render_gpu/src/kernels/capture.rs:155
    if (min(min(half_2.x, half_2.y), half_2.z) <= 0f) {
        // glimt_render_gpu/src/kernels/capture.rs:156
        return 1000000000000000000000000000000f;
    }
    // glimt_render_gpu/src/kernels/capture.rs:158
    let _e25 = slab(dot(from_1, this_6.right), dot(d_2, this_6.right), half_2.x);
    // glimt_render_gpu/src/kernels/capture.rs:159
    let _e32 = slab(dot(from_1, this_6.up), dot(d_2, this_6.up), half_2.y);
    // glimt_render_gpu/src/kernels/capture.rs:160
    let _e39 = slab(dot(from_1, this_6.forward), dot(d_2, this_6.forward), half_2.z);
    // glimt_render_gpu/src/kernels/capture.rs:161
    let near = max(max(_e25.x, _e32.x), _e39.x);
    // glimt_render_gpu/src/kernels/capture.rs:162
    let far = min(min(_e25.y, _e32.y), _e39.y);
    // glimt_render_gpu/src/kernels/capture.rs:163
    if ((near <= far) && (near > 0f)) {
        chosen_3 = near;
    } else {
        chosen_3 = 1000000000000000000000000000000f;
    }
    let _e59 = chosen_3;
    return _e59;
}

// glimt_render_gpu/src/kernels/stage.rs:106
fn wall_distance(origin_2: f32, d_3: f32, half_1: f32) -> f32 {
    var chosen_4: f32;
    var chosen_5: f32;

    // glimt_render_gpu/src/kernels/stage.rs:107
    if (d_3 > 0.000000000001f) {
        // glimt_render_gpu/src/kernels/stage.rs:108
        chosen_4 = ((half_1 - origin_2) / d_3);
    } else {
        if (d_3 < -0.000000000001f) {
            // glimt_render_gpu/src/kernels/stage.rs:110
            chosen_5 = ((-(half_1) - origin_2) / d_3);
        } else {
            // glimt_render_gpu/src/kernels/stage.rs:112
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
        let b_3 = dot(origin_3, d_4);
        // glimt_render_gpu/src/kernels/stage.rs:81
        let c_1 = (dot(origin_3, origin_3) - (half_3.x * half_3.x));
        // glimt_render_gpu/src/kernels/stage.rs:82
        return (origin_3 + (d_4 * (sqrt(max(((b_3 * b_3) - c_1), 0f)) - b_3)));
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
        let v_1 = chosen_6;
        // glimt_probe/src/latlong.rs:49
        return vec2<f32>(0.5f, v_1);
    }
    // glimt_probe/src/latlong.rs:52
    let v_2 = (atan2(horizontal, d_6.z) * 0.31830987f);
    // glimt_probe/src/latlong.rs:53
    let u_2 = (0.5f - ((0.5f * 0.31830987f) * atan2(d_6.y, d_6.x)));
    // glimt_probe/src/latlong.rs:54
    if (u_2 < 1f) {
        chosen_7 = max(u_2, 0f);
    } else {
        chosen_7 = 0f;
    }
    let _e47 = chosen_7;
    return vec2<f32>(_e47, clamp(v_2, 0f, 1f));
}

// glimt_render_gpu/src/kernels/environment.rs:66
fn bilinear(size: vec2<u32>, d_7: vec3<f32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/environment.rs:67
    let _e4 = direction_to_uv(d_7);
    let p_4 = ((_e4 * vec2<f32>(size)) - vec2(0.5f));
    // glimt_render_gpu/src/kernels/environment.rs:68
    let corner = floor(p_4);
    // glimt_render_gpu/src/kernels/environment.rs:69
    let f = (p_4 - corner);
    // glimt_render_gpu/src/kernels/environment.rs:71
    let x0_ = (u32((corner.x + f32(size.x))) % size.x);
    // glimt_render_gpu/src/kernels/environment.rs:72
    let x1_ = ((x0_ + 1u) % size.x);
    // glimt_render_gpu/src/kernels/environment.rs:73
    let row0_ = (u32(max(corner.y, 0f)) * size.x);
    // glimt_render_gpu/src/kernels/environment.rs:74
    let row1_ = (min(u32((corner.y + 1f)), (size.y - 1u)) * size.x);
    // glimt_render_gpu/src/kernels/environment.rs:75
    let _e49 = stage_texels[(row0_ + x0_)];
    let _e53 = stage_texels[(row0_ + x1_)];
    let upper = ((_e49 * (1f - f.x)) + (_e53 * f.x));
    // glimt_render_gpu/src/kernels/environment.rs:76
    let _e64 = stage_texels[(row1_ + x0_)];
    let _e68 = stage_texels[(row1_ + x1_)];
    let lower = ((_e64 * (1f - f.x)) + (_e68 * f.x));
    // glimt_render_gpu/src/kernels/environment.rs:77
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

// glimt_render_gpu/src/kernels/capture.rs:132
fn CaptureParams_reflected(this_7: CaptureParams, point: vec3<f32>, direction: vec3<f32>, stage_params: StageParams) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/capture.rs:133
    let _e6 = CaptureParams_rig_distance(this_7, point, direction);
    // glimt_render_gpu/src/kernels/capture.rs:134
    let _e8 = Stage_occluder_distance(stage_params, point, direction);
    if (_e6 < _e8) {
        // glimt_render_gpu/src/kernels/capture.rs:135
        return this_7.rig_radiance;
    }
    // glimt_render_gpu/src/kernels/capture.rs:137
    let _e13 = Stage_radiance(stage_params, point, direction);
    return _e13;
}

// glimt_render_gpu/src/kernels/capture.rs:114
fn CaptureParams_radiance(this_8: CaptureParams, p_3: vec2<f32>, stage_params_1: StageParams) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/capture.rs:115
    let flat = (p_3 * this_8.outline);
    // glimt_render_gpu/src/kernels/capture.rs:116
    let direction_1 = normalize(((this_8.forward + (this_8.right * flat.x)) - (this_8.up * flat.y)));
    // glimt_render_gpu/src/kernels/capture.rs:117
    let _e20 = Stage_occluder_distance(stage_params_1, this_8.eye, direction_1);
    // glimt_render_gpu/src/kernels/capture.rs:118
    let distance_ = (this_8.ball_radius / this_8.radius_over_distance);
    // glimt_render_gpu/src/kernels/capture.rs:119
    let _e26 = CaptureParams_ball(this_8);
    let _e27 = MirrorBall_reflect(_e26, p_3);
    let seen = _e27.value;
    if _e27.is_some {
        // glimt_render_gpu/src/kernels/capture.rs:120
        if (_e20 < distance_) {
            // glimt_render_gpu/src/kernels/capture.rs:121
            return stage_params_1.occluder_radiance;
        }
        // glimt_render_gpu/src/kernels/capture.rs:123
        let point_1 = (this_8.ball_centre + (seen.normal * this_8.ball_radius));
        // glimt_render_gpu/src/kernels/capture.rs:124
        let _e43 = CaptureParams_reflectance(this_8, seen.cos_incidence);
        let _e45 = CaptureParams_reflected(this_8, point_1, seen.direction, stage_params_1);
        return (_e43 * _e45);
    }
    // glimt_render_gpu/src/kernels/capture.rs:127
    let _e49 = Stage_radiance(stage_params_1, this_8.eye, direction_1);
    return _e49;
}

// glimt_sampling/src/hash.rs:15
fn hash_u32_(n: u32) -> u32 {
    var x: u32;

    // glimt_sampling/src/hash.rs:16
    x = (n ^ 3875421163u);
    // glimt_sampling/src/hash.rs:17
    let _e7 = x;
    let _e11 = x;
    x = (_e11 ^ (_e7 >> 16u));
    // glimt_sampling/src/hash.rs:18
    let _e14 = x;
    x = (_e14 * 2146121005u);
    // glimt_sampling/src/hash.rs:19
    let _e18 = x;
    let _e22 = x;
    x = (_e22 ^ (_e18 >> 15u));
    // glimt_sampling/src/hash.rs:20
    let _e25 = x;
    x = (_e25 * 2221713035u);
    // glimt_sampling/src/hash.rs:21
    let _e29 = x;
    let _e30 = x;
    return (_e29 ^ (_e30 >> 16u));
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

// glimt_sampling/src/sobol.rs:171
fn OwenSobol_new(seed: u32, frame: u32, pixel_1: u32, sample_index: u32) -> OwenSobol {

    // glimt_sampling/src/sobol.rs:172
    let _e6 = hash3_(seed, frame, pixel_1);
    let _e10 = hash2_(_e6, (sample_index >> 16u));
    return OwenSobol(_e10, (sample_index & 65535u), 0u);
}

// glimt_render_gpu/src/kernels/pattern.rs:75
fn PixelPattern_sobol_point(this_9: PixelPattern, purpose: u32, index: u32) -> OwenSobol {

    // glimt_render_gpu/src/kernels/pattern.rs:76
    let _e6 = hash2_(this_9.seed, purpose);
    let _e9 = OwenSobol_new(_e6, this_9.frame, this_9.pixel, index);
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
    let _e20 = x_1;
    let _e23 = x_1;
    x_1 = (_e23 ^ (_e20 * 89287766u));
    // glimt_sampling/src/sobol.rs:26
    let _e26 = x_1;
    let _e27 = x_1;
    return (_e26 ^ (_e27 * 1403136100u));
}

// glimt_sampling/src/sobol.rs:103
fn shuffle(index_1: u32, seed_1: u32) -> u32 {

    // glimt_sampling/src/sobol.rs:104
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
    let _e11 = x_2;
    x_2 = (_e11 ^ ((_e5 >> 1u) & 21845u));
    // glimt_sampling/src/sobol.rs:59
    let _e14 = x_2;
    let _e20 = x_2;
    x_2 = (_e20 ^ ((_e14 >> 2u) & 13107u));
    // glimt_sampling/src/sobol.rs:60
    let _e23 = x_2;
    let _e29 = x_2;
    x_2 = (_e29 ^ ((_e23 >> 4u) & 3855u));
    // glimt_sampling/src/sobol.rs:61
    let _e32 = x_2;
    let _e33 = x_2;
    return (_e32 ^ ((_e33 >> 8u) & 255u));
}

// glimt_sampling/src/sobol.rs:66
fn recurrence_2_(index_3: u32) -> u32 {
    var bits: u32;
    var v0_: u32;
    var v1_: u32;
    var sum: u32;

    // glimt_sampling/src/sobol.rs:67
    bits = index_3;
    // glimt_sampling/src/sobol.rs:68
    v0_ = 1u;
    // glimt_sampling/src/sobol.rs:69
    v1_ = 3u;
    // glimt_sampling/src/sobol.rs:70
    sum = 0u;
    // glimt_sampling/src/sobol.rs:71
    loop {
        let _e14 = bits;
        if !((_e14 != 0u)) {
            break;
        }
        // glimt_sampling/src/sobol.rs:72
        let _e19 = v0_;
        let _e20 = bits;
        let _e26 = sum;
        sum = (_e26 ^ (_e19 & (0u - (_e20 & 1u))));
        // glimt_sampling/src/sobol.rs:73
        let _e29 = v1_;
        let _e30 = v0_;
        let _e32 = v0_;
        let v2_1 = ((_e29 ^ _e30) ^ (_e32 << 2u));
        // glimt_sampling/src/sobol.rs:74
        let _e38 = v1_;
        v0_ = _e38;
        // glimt_sampling/src/sobol.rs:75
        v1_ = v2_1;
        // glimt_sampling/src/sobol.rs:76
        let _e42 = bits;
        bits = (_e42 >> 1u);
    }
    // glimt_sampling/src/sobol.rs:78
    let _e46 = sum;
    return _e46;
}

// glimt_sampling/src/sobol.rs:83
fn recurrence_3_(index_4: u32) -> u32 {
    var bits_1: u32;
    var v0_1: u32;
    var v1_1: u32;
    var v2_: u32;
    var sum_1: u32;

    // glimt_sampling/src/sobol.rs:84
    bits_1 = index_4;
    // glimt_sampling/src/sobol.rs:85
    v0_1 = 1u;
    // glimt_sampling/src/sobol.rs:86
    v1_1 = 3u;
    // glimt_sampling/src/sobol.rs:87
    v2_ = 4u;
    // glimt_sampling/src/sobol.rs:88
    sum_1 = 0u;
    // glimt_sampling/src/sobol.rs:89
    loop {
        let _e17 = bits_1;
        if !((_e17 != 0u)) {
            break;
        }
        // glimt_sampling/src/sobol.rs:90
        let _e22 = v0_1;
        let _e23 = bits_1;
        let _e29 = sum_1;
        sum_1 = (_e29 ^ (_e22 & (0u - (_e23 & 1u))));
        // glimt_sampling/src/sobol.rs:91
        let _e32 = v1_1;
        let _e33 = v0_1;
        let _e35 = v0_1;
        let v3_ = ((_e32 ^ _e33) ^ (_e35 << 3u));
        // glimt_sampling/src/sobol.rs:92
        let _e41 = v1_1;
        v0_1 = _e41;
        // glimt_sampling/src/sobol.rs:93
        let _e43 = v2_;
        v1_1 = _e43;
        // glimt_sampling/src/sobol.rs:94
        v2_ = v3_;
        // glimt_sampling/src/sobol.rs:95
        let _e47 = bits_1;
        bits_1 = (_e47 >> 1u);
    }
    // glimt_sampling/src/sobol.rs:97
    let _e51 = sum_1;
    return _e51;
}

// glimt_sampling/src/sobol.rs:43
fn sobol_reversed(index_5: u32, dimension: u32) -> u32 {
    var chosen_8: u32;

    // glimt_sampling/src/sobol.rs:44
    let index_9 = (index_5 & 65535u);
    // glimt_sampling/src/sobol.rs:45
    let _e8 = (dimension & 3u);
    if (_e8 == 0u) {
        // glimt_sampling/src/sobol.rs:47
        chosen_8 = index_9;
    } else {
        if (_e8 == 1u) {
            // glimt_sampling/src/sobol.rs:48
            let _e16 = pascal(index_9);
            chosen_8 = _e16;
        } else {
            if (_e8 == 2u) {
                // glimt_sampling/src/sobol.rs:49
                let _e20 = recurrence_2_(index_9);
                chosen_8 = _e20;
            } else {
                // glimt_sampling/src/sobol.rs:50
                let _e22 = recurrence_3_(index_9);
                chosen_8 = _e22;
            }
        }
    }
    let _e23 = chosen_8;
    return _e23;
}

// glimt_sampling/src/sobol.rs:109
fn scramble_1(reversed: u32, dimension_1: u32, seed_2: u32) -> u32 {
    var chosen_9: u32;

    // glimt_sampling/src/sobol.rs:110
    let _e6 = (dimension_1 & 3u);
    if (_e6 == 0u) {
        // glimt_sampling/src/sobol.rs:111
        chosen_9 = 2435803578u;
    } else {
        if (_e6 == 1u) {
            // glimt_sampling/src/sobol.rs:112
            chosen_9 = 391059627u;
        } else {
            if (_e6 == 2u) {
                // glimt_sampling/src/sobol.rs:113
                chosen_9 = 1763603146u;
            } else {
                // glimt_sampling/src/sobol.rs:114
                chosen_9 = 3020734904u;
            }
        }
    }
    let salt = chosen_9;
    // glimt_sampling/src/sobol.rs:117
    let _e27 = hash_u32_(((seed_2 * 2626628923u) ^ salt));
    // glimt_sampling/src/sobol.rs:118
    let _e29 = owen_scramble_reversed(reversed, _e27);
    return reverseBits(_e29);
}

// glimt_sampling/src/sobol.rs:190
fn OwenSobol_next_uvec2_(this_10: ptr<function, OwenSobol>) -> vec2<u32> {

    // glimt_sampling/src/sobol.rs:191
    let _e4 = (*this_10).dimension;
    let dimension_2 = ((_e4 + 1u) & 4294967294u);
    // glimt_sampling/src/sobol.rs:192
    (*this_10).dimension = (dimension_2 + 2u);
    // glimt_sampling/src/sobol.rs:193
    let _e15 = (*this_10).seed;
    let _e19 = hash2_(_e15, (dimension_2 >> 2u));
    // glimt_sampling/src/sobol.rs:194
    let _e22 = (*this_10).index;
    let _e23 = shuffle(_e22, _e19);
    // glimt_sampling/src/sobol.rs:195
    let _e25 = sobol_reversed(_e23, dimension_2);
    let _e26 = scramble_1(_e25, dimension_2, _e19);
    let _e29 = sobol_reversed(_e23, (dimension_2 + 1u));
    let _e32 = scramble_1(_e29, (dimension_2 + 1u), _e19);
    return vec2<u32>(_e26, _e32);
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
    let _e63 = x_3;
    x_3 = (_e63 ^ (_e59 >> 16u));
    // glimt_sampling/src/hash.rs:69
    let _e66 = y;
    let _e70 = y;
    y = (_e70 ^ (_e66 >> 16u));
    // glimt_sampling/src/hash.rs:70
    let _e73 = z;
    let _e77 = z;
    z = (_e77 ^ (_e73 >> 16u));
    // glimt_sampling/src/hash.rs:71
    let _e80 = w;
    let _e84 = w;
    w = (_e84 ^ (_e80 >> 16u));
    // glimt_sampling/src/hash.rs:72
    let _e87 = x_3;
    let _e88 = y;
    let _e89 = w;
    x_3 = (_e87 + (_e88 * _e89));
    // glimt_sampling/src/hash.rs:73
    let _e93 = y;
    let _e94 = z;
    let _e95 = x_3;
    y = (_e93 + (_e94 * _e95));
    // glimt_sampling/src/hash.rs:74
    let _e99 = z;
    let _e100 = x_3;
    let _e101 = y;
    z = (_e99 + (_e100 * _e101));
    // glimt_sampling/src/hash.rs:75
    let _e105 = w;
    let _e106 = y;
    let _e107 = z;
    w = (_e105 + (_e106 * _e107));
    // glimt_sampling/src/hash.rs:76
    let _e111 = x_3;
    let _e112 = x_3;
    let _e117 = y;
    let _e118 = y;
    let _e123 = z;
    let _e124 = z;
    let _e129 = w;
    let _e130 = w;
    return vec4<u32>((_e111 ^ (_e112 >> 16u)), (_e117 ^ (_e118 >> 16u)), (_e123 ^ (_e124 >> 16u)), (_e129 ^ (_e130 >> 16u)));
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

// glimt_render_gpu/src/kernels/pattern.rs:80
fn PixelPattern_generator(this_11: PixelPattern, purpose_1: u32, index_6: u32) -> Xoshiro128PlusPlus {

    // glimt_render_gpu/src/kernels/pattern.rs:81
    let _e6 = hash3_(this_11.seed, purpose_1, index_6);
    let _e9 = Xoshiro128PlusPlus_stream(_e6, this_11.frame, this_11.pixel);
    return _e9;
}

// glimt_sampling/src/xoshiro.rs:56
fn Xoshiro128PlusPlus_next_u32_(this_12: ptr<function, Xoshiro128PlusPlus>) -> u32 {

    // glimt_sampling/src/xoshiro.rs:57
    let s_2 = (*this_12).state;
    // glimt_sampling/src/xoshiro.rs:58
    let _e8 = (s_2.x + s_2.w);
    let result = (((_e8 << 7u) | (_e8 >> ((0u - 7u) & 31u))) + s_2.x);
    // glimt_sampling/src/xoshiro.rs:59
    let z_1 = (s_2.z ^ s_2.x);
    // glimt_sampling/src/xoshiro.rs:60
    let w_2 = (s_2.w ^ s_2.y);
    // glimt_sampling/src/xoshiro.rs:61
    (*this_12).state = vec4<u32>((s_2.x ^ w_2), (s_2.y ^ z_1), (z_1 ^ (s_2.y << 9u)), ((w_2 << 11u) | (w_2 >> ((0u - 11u) & 31u))));
    // glimt_sampling/src/xoshiro.rs:62
    return result;
}

// glimt_sampling/src/uniform.rs:34
fn Xoshiro128PlusPlus_next_uvec2_(this_13: ptr<function, Xoshiro128PlusPlus>) -> vec2<u32> {

    // glimt_sampling/src/uniform.rs:35
    let _e3 = Xoshiro128PlusPlus_next_u32_(this_13);
    // glimt_sampling/src/uniform.rs:36
    let _e5 = Xoshiro128PlusPlus_next_u32_(this_13);
    // glimt_sampling/src/uniform.rs:37
    return vec2<u32>(_e3, _e5);
}

// glimt_render_gpu/src/kernels/pattern.rs:85
fn PixelPattern_key(this_14: PixelPattern, purpose_2: u32) -> u32 {

    // glimt_render_gpu/src/kernels/pattern.rs:86
    let _e5 = hash2_(this_14.seed, purpose_2);
    let _e8 = hash3_(_e5, this_14.frame, this_14.pixel);
    return _e8;
}

// glimt_render_gpu/src/kernels/pattern.rs:122
fn permute(index_7: u32, length_: u32, key: u32) -> u32 {
    var x_4: u32;
    var round_key: u32;
    var counter: i32;

    // glimt_render_gpu/src/kernels/pattern.rs:123
    if (length_ <= 1u) {
        // glimt_render_gpu/src/kernels/pattern.rs:124
        return 0u;
    }
    // glimt_render_gpu/src/kernels/pattern.rs:126
    let bits_2 = (32u - countLeadingZeros((length_ - 1u)));
    // glimt_render_gpu/src/kernels/pattern.rs:127
    let mask = (4294967295u >> ((32u - bits_2) & 31u));
    // glimt_render_gpu/src/kernels/pattern.rs:128
    x_4 = index_7;
    // glimt_render_gpu/src/kernels/pattern.rs:129
    loop {
        // glimt_render_gpu/src/kernels/pattern.rs:130
        round_key = key;
        // glimt_render_gpu/src/kernels/pattern.rs:131
        counter = 0i;
        loop {
            let _e31 = counter;
            if (_e31 >= 3i) {
                break;
            }
            // glimt_render_gpu/src/kernels/pattern.rs:132
            let _e34 = round_key;
            let _e35 = hash_u32_(_e34);
            round_key = _e35;
            // glimt_render_gpu/src/kernels/pattern.rs:134
            let _e37 = x_4;
            let _e38 = round_key;
            x_4 = (((_e37 ^ _e38) * 2654435761u) & mask);
            // glimt_render_gpu/src/kernels/pattern.rs:135
            let _e44 = x_4;
            let _e46 = (bits_2 / 2u);
            let _e56 = x_4;
            x_4 = (_e56 ^ (_e44 >> (select(_e46, (_e46 + 1u), ((bits_2 % 2u) != 0u)) & 31u)));
            continuing {
                let _e58 = counter;
                counter = (_e58 + 1i);
            }
        }
        // glimt_render_gpu/src/kernels/pattern.rs:137
        let _e62 = x_4;
        if (_e62 < length_) {
            // glimt_render_gpu/src/kernels/pattern.rs:138
            let _e65 = x_4;
            let _e67 = hash_u32_(~(key));
            return ((_e65 + (_e67 % length_)) % length_);
        }
    }
    return u32();
}

// glimt_render_gpu/src/kernels/pattern.rs:113
fn stratum(cell: u32, count: u32, jitter: u32) -> u32 {

    // glimt_render_gpu/src/kernels/pattern.rs:114
    return ((cell * (4294967295u / count)) + (jitter / count));
}

// glimt_render_gpu/src/kernels/pattern.rs:93
fn jittered_pair(index_8: u32, count_1: u32, jitter_1: vec2<u32>, key_1: u32) -> vec2<u32> {

    // glimt_render_gpu/src/kernels/pattern.rs:94
    let columns = max(u32(sqrt(f32(count_1))), 1u);
    // glimt_render_gpu/src/kernels/pattern.rs:95
    let _e12 = (count_1 / columns);
    let rows = select(_e12, (_e12 + 1u), ((count_1 % columns) != 0u));
    // glimt_render_gpu/src/kernels/pattern.rs:96
    let _e21 = hash2_(key_1, 1u);
    let _e22 = permute(index_8, count_1, _e21);
    // glimt_render_gpu/src/kernels/pattern.rs:97
    let _e26 = hash2_(key_1, 2u);
    let _e27 = permute((_e22 % columns), columns, _e26);
    // glimt_render_gpu/src/kernels/pattern.rs:98
    let _e31 = hash2_(key_1, 3u);
    let _e32 = permute((_e22 / columns), rows, _e31);
    // glimt_render_gpu/src/kernels/pattern.rs:99
    let _e38 = stratum(((_e27 * rows) + _e32), (columns * rows), jitter_1.x);
    let _e40 = stratum(_e22, count_1, jitter_1.y);
    return vec2<u32>(_e38, _e40);
}

// glimt_render_gpu/src/kernels/pattern.rs:42
fn PixelPattern_pair(this_15: PixelPattern, purpose_3: u32, sample: u32, samples: u32) -> vec2<u32> {
    var borrowed: OwenSobol;
    var borrowed_1: Xoshiro128PlusPlus;

    // glimt_render_gpu/src/kernels/pattern.rs:43
    let index_10 = ((this_15.ray * samples) + sample);
    // glimt_render_gpu/src/kernels/pattern.rs:44
    if (this_15.kind == 0u) {
        // glimt_render_gpu/src/kernels/pattern.rs:45
        let _e14 = PixelPattern_sobol_point(this_15, purpose_3, index_10);
        borrowed = _e14;
        let _e16 = OwenSobol_next_uvec2_((&borrowed));
        return _e16;
    }
    // glimt_render_gpu/src/kernels/pattern.rs:47
    let _e18 = PixelPattern_generator(this_15, purpose_3, index_10);
    borrowed_1 = _e18;
    let _e20 = Xoshiro128PlusPlus_next_uvec2_((&borrowed_1));
    // glimt_render_gpu/src/kernels/pattern.rs:48
    if (this_15.kind == 1u) {
        // glimt_render_gpu/src/kernels/pattern.rs:49
        return _e20;
    }
    // glimt_render_gpu/src/kernels/pattern.rs:51
    let _e29 = PixelPattern_key(this_15, purpose_3);
    let _e30 = jittered_pair(index_10, (this_15.rays * samples), _e20, _e29);
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

// glimt_render_gpu/src/kernels/capture.rs:186
fn film_ball_1(pixel_3: u32, capture: CaptureParams, stage_params_2: StageParams) -> vec4<f32> {
    var sum_2: vec3<f32>;
    var counter_1: u32;

    // glimt_render_gpu/src/kernels/capture.rs:187
    let corner_1 = vec2<f32>(vec2<u32>((pixel_3 % capture.width), (pixel_3 / capture.width)));
    // glimt_render_gpu/src/kernels/capture.rs:188
    let _e15 = CaptureParams_image_point(capture, (corner_1 + vec2(0.5f)));
    // glimt_render_gpu/src/kernels/capture.rs:189
    let _e18 = CaptureParams_samples_at(capture, _e15, stage_params_2.size);
    // glimt_render_gpu/src/kernels/capture.rs:190
    if (_e18 == 1u) {
        // glimt_render_gpu/src/kernels/capture.rs:191
        let _e23 = CaptureParams_radiance(capture, _e15, stage_params_2);
        return vec4<f32>(_e23, 1f);
    }
    // glimt_render_gpu/src/kernels/capture.rs:193
    sum_2 = vec3(0f);
    // glimt_render_gpu/src/kernels/capture.rs:194
    counter_1 = 0u;
    loop {
        let ray = counter_1;
        if (ray >= _e18) {
            break;
        }
        // glimt_render_gpu/src/kernels/capture.rs:195
        let pattern = PixelPattern(0u, capture.seed, capture.frame, pixel_3, ray, _e18);
        // glimt_render_gpu/src/kernels/capture.rs:203
        let _e44 = PixelPattern_pair(pattern, 1u, 0u, 1u);
        let _e45 = unit_vec2_(_e44);
        // glimt_render_gpu/src/kernels/capture.rs:204
        let _e48 = CaptureParams_image_point(capture, (corner_1 + _e45));
        let _e49 = CaptureParams_radiance(capture, _e48, stage_params_2);
        let _e50 = sum_2;
        sum_2 = (_e50 + _e49);
        continuing {
            let _e52 = counter_1;
            counter_1 = (_e52 + 1u);
        }
    }
    // glimt_render_gpu/src/kernels/capture.rs:206
    let _e56 = sum_2;
    return vec4<f32>((_e56 / vec3(f32(_e18))), 1f);
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
