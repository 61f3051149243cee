// Made from Rust by naga-front-rust; do not edit. To make it anew: cargo run --release -p glimt-tests --bin regenerate

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

