// Made from Rust by naga-front-rust; do not edit. This command writes it: cargo run --release -p glimt-generate

// glimt_probe/src/trig.rs:25
fn cos_sin_pi(x: f32) -> vec2<f32> {
    var chosen: vec2<f32>;

    // glimt_probe/src/trig.rs:27
    let quarter = floor(((2f * x) + 0.5f));
    // glimt_probe/src/trig.rs:28
    let y_2 = (x - (0.5f * quarter));
    // glimt_probe/src/trig.rs:29
    let y2_ = (y_2 * y_2);
    // glimt_probe/src/trig.rs:31
    let c = (1f + (y2_ * (-4.934802f + (y2_ * (4.058712f + (y2_ * (-1.3352627f + (y2_ * (0.23533063f + (y2_ * -0.02580689f))))))))));
    // glimt_probe/src/trig.rs:34
    let s_1 = (y_2 * (3.1415927f + (y2_ * (-5.1677127f + (y2_ * (2.550164f + (y2_ * (-0.5992645f + (y2_ * 0.082145885f)))))))));
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

// glimt_sh/src/basis.rs:132
fn turn(p: vec2<f32>, x_1: f32, y: f32) -> vec2<f32> {

    // glimt_sh/src/basis.rs:133
    return vec2<f32>(((p.x * x_1) - (p.y * y)), ((p.x * y) + (p.y * x_1)));
}

// glimt_sh/src/separable.rs:51
fn ring(x_2: f32, y_1: f32) -> array<f32, 11> {

    // glimt_sh/src/separable.rs:52
    let p1_ = vec2<f32>(x_2, y_1);
    // glimt_sh/src/separable.rs:53
    let _e6 = turn(p1_, x_2, y_1);
    // glimt_sh/src/separable.rs:54
    let _e8 = turn(_e6, x_2, y_1);
    // glimt_sh/src/separable.rs:55
    let _e10 = turn(_e8, x_2, y_1);
    // glimt_sh/src/separable.rs:56
    let _e12 = turn(_e10, x_2, y_1);
    // glimt_sh/src/separable.rs:57
    return array<f32, 11>(1f, x_2, y_1, _e6.x, _e6.y, _e8.x, _e8.y, _e10.x, _e10.y, _e12.x, _e12.y);
}

// glimt_sh/src/separable.rs:117
fn column_ring(column: u32, width: u32) -> array<f32, 11> {

    // glimt_sh/src/separable.rs:118
    let _e13 = cos_sin_pi((1f - (f32(((2u * column) + 1u)) / f32(width))));
    // glimt_sh/src/separable.rs:119
    let _e17 = ring(_e13.x, _e13.y);
    return _e17;
}

// glimt_sh/src/basis.rs:79
fn zonal_2_(z: f32) -> array<f32, 3> {

    // glimt_sh/src/basis.rs:80
    return array<f32, 3>((0.31539157f * (((3f * z) * z) - 1f)), (1.0925485f * z), 0.54627424f);
}

// glimt_sh/src/basis.rs:90
fn zonal_3_(z_1: f32) -> array<f32, 4> {

    // glimt_sh/src/basis.rs:91
    let t = (z_1 * z_1);
    // glimt_sh/src/basis.rs:92
    return array<f32, 4>(((0.37317634f * z_1) * ((5f * t) - 3f)), (0.4570458f * ((5f * t) - 1f)), (1.4453057f * z_1), 0.5900436f);
}

// glimt_sh/src/basis.rs:103
fn zonal_4_(z_2: f32) -> array<f32, 5> {

    // glimt_sh/src/basis.rs:104
    let t_1 = (z_2 * z_2);
    // glimt_sh/src/basis.rs:105
    return array<f32, 5>((0.10578555f * ((((35f * t_1) - 30f) * t_1) + 3f)), ((0.6690465f * z_2) * ((7f * t_1) - 3f)), (0.47308734f * ((7f * t_1) - 1f)), (1.7701308f * z_2), 0.6258357f);
}

// glimt_sh/src/basis.rs:117
fn zonal_5_(z_3: f32) -> array<f32, 6> {

    // glimt_sh/src/basis.rs:118
    let t_2 = (z_3 * z_3);
    // glimt_sh/src/basis.rs:119
    return array<f32, 6>(((0.116950326f * z_3) * ((((63f * t_2) - 70f) * t_2) + 15f)), (0.45294666f * ((((21f * t_2) - 14f) * t_2) + 1f)), ((2.3967683f * z_3) * ((3f * t_2) - 1f)), (0.4892383f * ((9f * t_2) - 1f)), (2.0756624f * z_3), 0.6563821f);
}

// glimt_sh/src/separable.rs:73
fn meridian(z_4: f32, s: f32) -> array<f32, 21> {
    var q2_: array<f32, 3>;
    var q3_: array<f32, 4>;
    var q4_: array<f32, 5>;
    var q5_: array<f32, 6>;

    // glimt_sh/src/separable.rs:74
    let s2_ = (s * s);
    // glimt_sh/src/separable.rs:75
    let s3_ = (s2_ * s);
    // glimt_sh/src/separable.rs:76
    let s4_ = (s2_ * s2_);
    // glimt_sh/src/separable.rs:77
    let s5_ = (s4_ * s);
    // glimt_sh/src/separable.rs:78
    let _e12 = zonal_2_(z_4);
    q2_ = _e12;
    // glimt_sh/src/separable.rs:79
    let _e15 = zonal_3_(z_4);
    q3_ = _e15;
    // glimt_sh/src/separable.rs:80
    let _e18 = zonal_4_(z_4);
    q4_ = _e18;
    // glimt_sh/src/separable.rs:81
    let _e21 = zonal_5_(z_4);
    q5_ = _e21;
    // glimt_sh/src/separable.rs:82
    let _e30 = q2_[0];
    let _e32 = q2_[1];
    let _e35 = q2_[2];
    let _e38 = q3_[0];
    let _e40 = q3_[1];
    let _e43 = q3_[2];
    let _e46 = q3_[3];
    let _e49 = q4_[0];
    let _e51 = q4_[1];
    let _e54 = q4_[2];
    let _e57 = q4_[3];
    let _e60 = q4_[4];
    let _e63 = q5_[0];
    let _e65 = q5_[1];
    let _e68 = q5_[2];
    let _e71 = q5_[3];
    let _e74 = q5_[4];
    let _e77 = q5_[5];
    return array<f32, 21>(0.2820948f, (0.48860252f * z_4), (0.48860252f * s), _e30, (_e32 * s), (_e35 * s2_), _e38, (_e40 * s), (_e43 * s2_), (_e46 * s3_), _e49, (_e51 * s), (_e54 * s2_), (_e57 * s3_), (_e60 * s4_), _e63, (_e65 * s), (_e68 * s2_), (_e71 * s3_), (_e74 * s4_), (_e77 * s5_));
}

// glimt_sh/src/separable.rs:133
fn row_meridian(row: u32, size: vec2<u32>) -> array<f32, 21> {

    // glimt_sh/src/separable.rs:134
    let _e14 = cos_sin_pi((f32(((2u * row) + 1u)) / f32((2u * size.y))));
    // glimt_sh/src/separable.rs:135
    let _e18 = meridian(_e14.x, _e14.y);
    return _e18;
}

// glimt_probe/src/latlong.rs:121
fn row_area(row_1: u32, size_1: vec2<u32>) -> f32 {

    // glimt_probe/src/latlong.rs:122
    let size_2 = max(size_1, vec2(1u));
    // glimt_probe/src/latlong.rs:123
    let row_2 = min(row_1, (size_2.y - 1u));
    // glimt_probe/src/latlong.rs:124
    let from_pole = min(row_2, ((size_2.y - 1u) - row_2));
    // glimt_probe/src/latlong.rs:125
    let half_row = (0.5f / f32(size_2.y));
    // glimt_probe/src/latlong.rs:126
    let middle = (f32(((2u * from_pole) + 1u)) * half_row);
    // glimt_probe/src/latlong.rs:127
    let _e37 = cos_sin_pi(middle);
    let _e40 = cos_sin_pi(half_row);
    return ((((4f * 3.1415927f) / f32(size_2.x)) * _e37.y) * _e40.y);
}

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

// glimt_sh/src/separable.rs:19
fn ring_index(m: i32) -> u32 {
    var chosen_1: u32;

    // glimt_sh/src/separable.rs:20
    if (m > 0i) {
        // glimt_sh/src/separable.rs:21
        chosen_1 = u32(((2i * m) - 1i));
    } else {
        // glimt_sh/src/separable.rs:23
        chosen_1 = u32((-2i * m));
    }
    let _e16 = chosen_1;
    return _e16;
}

// glimt_sh/src/separable.rs:35
fn meridian_index(l_1: u32, m_1: u32) -> u32 {

    // glimt_sh/src/separable.rs:36
    return (((l_1 * (l_1 + 1u)) / 2u) + m_1);
}

