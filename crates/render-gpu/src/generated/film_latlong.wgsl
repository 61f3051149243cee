// Made from Rust by naga-front-rust; do not edit. This command writes it: cargo run --release -p glimt-generate

struct LatLongParams {
    position: vec3<f32>,
    grid: u32,
    size: vec2<u32>,
    unused: vec2<u32>,
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

struct Params {
    first: u32,
    count: u32,
    latlong: LatLongParams,
    stage_params: StageParams,
}

@group(0) @binding(1) 
var<storage> stage_texels: array<vec4<f32>>;
@group(0) @binding(2) 
var<storage, read_write> out: array<vec4<f32>>;
@group(0) @binding(0) 
var<uniform> params_4: Params;

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

// glimt_probe/src/latlong.rs:142
fn direction_in_texel(texel: vec2<u32>, size: vec2<u32>, r: vec2<f32>) -> vec3<f32> {
    var chosen_1: u32;
    var chosen_2: u32;
    var chosen_3: f32;

    // glimt_probe/src/latlong.rs:143
    let size_2 = max(size, vec2(1u));
    // glimt_probe/src/latlong.rs:144
    let row = min(texel.y, (size_2.y - 1u));
    // glimt_probe/src/latlong.rs:146
    let southern = ((2u * row) >= size_2.y);
    // glimt_probe/src/latlong.rs:147
    if southern {
        chosen_1 = (size_2.y - row);
    } else {
        chosen_1 = row;
    }
    let upper = chosen_1;
    // glimt_probe/src/latlong.rs:148
    if southern {
        chosen_2 = ((size_2.y - row) - 1u);
    } else {
        chosen_2 = (row + 1u);
    }
    let lower = chosen_2;
    // glimt_probe/src/latlong.rs:149
    let half_1 = (0.5f / f32(size_2.y));
    // glimt_probe/src/latlong.rs:150
    let _e41 = cos_sin_pi((f32(upper) * half_1));
    let sin_upper = _e41.y;
    // glimt_probe/src/latlong.rs:151
    let _e46 = cos_sin_pi((f32(lower) * half_1));
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
    let _e90 = cos_sin_pi((1f - ((2f * (f32(texel.x) + r.x)) / f32(size_2.x))));
    // glimt_probe/src/latlong.rs:161
    return vec3<f32>((sin_theta * _e90.x), (sin_theta * _e90.y), cos_theta);
}

// glimt_render_gpu/src/kernels/stage.rs:93
fn Stage_occluder_distance(params: StageParams, origin: vec3<f32>, d: vec3<f32>) -> f32 {
    var chosen_4: f32;

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
        chosen_4 = t;
    } else {
        chosen_4 = 1000000000000000000000000000000f;
    }
    let _e36 = chosen_4;
    return _e36;
}

// glimt_render_gpu/src/kernels/stage.rs:109
fn wall_distance(origin_1: f32, d_1: f32, half: f32) -> f32 {
    var chosen_5: f32;
    var chosen_6: f32;

    // glimt_render_gpu/src/kernels/stage.rs:110
    if (d_1 > 0.000000000001f) {
        // glimt_render_gpu/src/kernels/stage.rs:111
        chosen_5 = ((half - origin_1) / d_1);
    } else {
        if (d_1 < -0.000000000001f) {
            // glimt_render_gpu/src/kernels/stage.rs:113
            chosen_6 = ((-(half) - origin_1) / d_1);
        } else {
            // glimt_render_gpu/src/kernels/stage.rs:115
            chosen_6 = 1000000000000000000000000000000f;
        }
        let _e20 = chosen_6;
        chosen_5 = _e20;
    }
    let _e21 = chosen_5;
    return _e21;
}

// glimt_render_gpu/src/kernels/stage.rs:74
fn Stage_point_seen(params_1: StageParams, origin_2: vec3<f32>, d_2: vec3<f32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/stage.rs:75
    if (params_1.shape == 0u) {
        // glimt_render_gpu/src/kernels/stage.rs:76
        return d_2;
    }
    // glimt_render_gpu/src/kernels/stage.rs:78
    let half_2 = params_1.half_size;
    // glimt_render_gpu/src/kernels/stage.rs:79
    if (params_1.shape == 1u) {
        // glimt_render_gpu/src/kernels/stage.rs:80
        let b = dot(origin_2, d_2);
        // glimt_render_gpu/src/kernels/stage.rs:81
        let c_1 = (dot(origin_2, origin_2) - (half_2.x * half_2.x));
        // glimt_render_gpu/src/kernels/stage.rs:82
        return (origin_2 + (d_2 * (sqrt(max(((b * b) - c_1), 0f)) - b)));
    }
    // glimt_render_gpu/src/kernels/stage.rs:84
    let _e36 = wall_distance(origin_2.x, d_2.x, half_2.x);
    let _e40 = wall_distance(origin_2.y, d_2.y, half_2.y);
    let _e45 = wall_distance(origin_2.z, d_2.z, half_2.z);
    let t_1 = min(min(_e36, _e40), _e45);
    // glimt_render_gpu/src/kernels/stage.rs:87
    return (origin_2 + (d_2 * max(t_1, 0f)));
}

// glimt_probe/src/rotate.rs:33
fn rotate_z(d_3: vec3<f32>, cos_sin: vec2<f32>) -> vec3<f32> {

    // glimt_probe/src/rotate.rs:34
    return vec3<f32>(((d_3.x * cos_sin.x) - (d_3.y * cos_sin.y)), ((d_3.x * cos_sin.y) + (d_3.y * cos_sin.x)), d_3.z);
}

// glimt_probe/src/latlong.rs:45
fn direction_to_uv(d_4: vec3<f32>) -> vec2<f32> {
    var chosen_7: f32;
    var chosen_8: f32;

    // glimt_probe/src/latlong.rs:46
    let horizontal = sqrt(((d_4.x * d_4.x) + (d_4.y * d_4.y)));
    // glimt_probe/src/latlong.rs:47
    if (horizontal <= 0f) {
        // glimt_probe/src/latlong.rs:48
        if (d_4.z < 0f) {
            chosen_7 = 1f;
        } else {
            chosen_7 = 0f;
        }
        let v = chosen_7;
        // glimt_probe/src/latlong.rs:49
        return vec2<f32>(0.5f, v);
    }
    // glimt_probe/src/latlong.rs:52
    let v_1 = (atan2(horizontal, d_4.z) * 0.31830987f);
    // glimt_probe/src/latlong.rs:53
    let u = (0.5f - ((0.5f * 0.31830987f) * atan2(d_4.y, d_4.x)));
    // glimt_probe/src/latlong.rs:54
    if (u < 1f) {
        chosen_8 = max(u, 0f);
    } else {
        chosen_8 = 0f;
    }
    let _e47 = chosen_8;
    return vec2<f32>(_e47, clamp(v_1, 0f, 1f));
}

// glimt_render_gpu/src/kernels/environment.rs:146
fn bilinear(size_1: vec2<u32>, d_5: vec3<f32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/environment.rs:147
    let _e4 = direction_to_uv(d_5);
    let p = ((_e4 * vec2<f32>(size_1)) - vec2(0.5f));
    // glimt_render_gpu/src/kernels/environment.rs:149
    let next = vec2<u32>((p + vec2(1f)));
    // glimt_render_gpu/src/kernels/environment.rs:150
    let f = ((p + vec2(1f)) - vec2<f32>(next));
    // glimt_render_gpu/src/kernels/environment.rs:151
    let x0_ = (((next.x + size_1.x) - 1u) % size_1.x);
    // glimt_render_gpu/src/kernels/environment.rs:152
    let x1_ = (next.x % size_1.x);
    // glimt_render_gpu/src/kernels/environment.rs:153
    let row0_ = ((max(next.y, 1u) * size_1.x) - size_1.x);
    // glimt_render_gpu/src/kernels/environment.rs:154
    let row1_ = (min(next.y, (size_1.y - 1u)) * size_1.x);
    // glimt_render_gpu/src/kernels/environment.rs:155
    let _e53 = stage_texels[(row0_ + x0_)];
    let _e57 = stage_texels[(row0_ + x1_)];
    let upper_1 = ((_e53 * (1f - f.x)) + (_e57 * f.x));
    // glimt_render_gpu/src/kernels/environment.rs:156
    let _e68 = stage_texels[(row1_ + x0_)];
    let _e72 = stage_texels[(row1_ + x1_)];
    let lower_1 = ((_e68 * (1f - f.x)) + (_e72 * f.x));
    // glimt_render_gpu/src/kernels/environment.rs:157
    return ((upper_1 * (1f - f.y)) + (lower_1 * f.y)).xyz;
}

// glimt_render_gpu/src/kernels/stage.rs:64
fn Stage_map_radiance(params_2: StageParams, origin_3: vec3<f32>, d_6: vec3<f32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/stage.rs:65
    let back = vec2<f32>(params_2.rotation.x, -(params_2.rotation.y));
    // glimt_render_gpu/src/kernels/stage.rs:66
    let _e12 = Stage_point_seen(params_2, origin_3, d_6);
    let _e13 = rotate_z(_e12, back);
    // glimt_render_gpu/src/kernels/stage.rs:67
    let _e16 = bilinear(params_2.size, _e13);
    return _e16;
}

// glimt_render_gpu/src/kernels/stage.rs:54
fn Stage_radiance(params_3: StageParams, origin_4: vec3<f32>, d_7: vec3<f32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/stage.rs:55
    let _e5 = Stage_occluder_distance(params_3, origin_4, d_7);
    if (_e5 < 1000000000000000000000000000000f) {
        // glimt_render_gpu/src/kernels/stage.rs:56
        return params_3.occluder_radiance;
    }
    // glimt_render_gpu/src/kernels/stage.rs:58
    let _e11 = Stage_map_radiance(params_3, origin_4, d_7);
    return _e11;
}

// glimt_render_gpu/src/kernels/capture.rs:233
fn film_latlong_1(texel_1: u32, latlong: LatLongParams, stage_params: StageParams) -> vec4<f32> {
    var sum: vec3<f32>;
    var counter: u32;
    var counter_1: u32;

    // glimt_render_gpu/src/kernels/capture.rs:234
    let place = vec2<u32>((texel_1 % latlong.size.x), (texel_1 / latlong.size.x));
    // glimt_render_gpu/src/kernels/capture.rs:235
    sum = vec3(0f);
    // glimt_render_gpu/src/kernels/capture.rs:236
    counter = 0u;
    loop {
        let j = counter;
        if (j >= latlong.grid) {
            break;
        }
        // glimt_render_gpu/src/kernels/capture.rs:237
        counter_1 = 0u;
        loop {
            let i = counter_1;
            if (i >= latlong.grid) {
                break;
            }
            // glimt_render_gpu/src/kernels/capture.rs:238
            let inside = ((vec2<f32>(vec2<u32>(i, j)) + vec2(0.5f)) / vec2(f32(latlong.grid)));
            // glimt_render_gpu/src/kernels/capture.rs:239
            let _e40 = direction_in_texel(place, latlong.size, inside);
            // glimt_render_gpu/src/kernels/capture.rs:240
            let _e43 = Stage_radiance(stage_params, latlong.position, _e40);
            let _e44 = sum;
            sum = (_e44 + _e43);
            continuing {
                let _e46 = counter_1;
                counter_1 = (_e46 + 1u);
            }
        }
        continuing {
            let _e49 = counter;
            counter = (_e49 + 1u);
        }
    }
    // glimt_render_gpu/src/kernels/capture.rs:243
    let _e53 = sum;
    return vec4<f32>((_e53 / vec3(f32((latlong.grid * latlong.grid)))), 1f);
}

@compute @workgroup_size(64, 1, 1) 
fn film_latlong(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let local = ((id.y * (groups.x * 64u)) + id.x);
    let _e11 = params_4.count;
    if (local >= _e11) {
        return;
    }
    let _e14 = params_4.first;
    let _e17 = params_4.latlong;
    let _e19 = params_4.stage_params;
    let _e20 = film_latlong_1((_e14 + local), _e17, _e19);
    out[local] = _e20;
}
