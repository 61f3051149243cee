// Made from Rust by naga-front-rust; do not edit. This command writes it: cargo run --release -p glimt-generate

struct DirectionSample {
    direction: vec3<f32>,
    pdf_sr: f32,
}

// glimt_sh/src/basis.rs:132
fn turn(p: vec2<f32>, x: f32, y: f32) -> vec2<f32> {

    // glimt_sh/src/basis.rs:133
    return vec2<f32>(((p.x * x) - (p.y * y)), ((p.x * y) + (p.y * x)));
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

// glimt_sh/src/basis.rs:154
fn sh_basis(d: vec3<f32>) -> array<f32, 36> {
    var q2_: array<f32, 3>;
    var q3_: array<f32, 4>;
    var q4_: array<f32, 5>;
    var q5_: array<f32, 6>;

    // glimt_sh/src/basis.rs:155
    let p1_ = vec2<f32>(d.x, d.y);
    // glimt_sh/src/basis.rs:156
    let _e9 = turn(p1_, d.x, d.y);
    // glimt_sh/src/basis.rs:157
    let _e13 = turn(_e9, d.x, d.y);
    // glimt_sh/src/basis.rs:158
    let _e17 = turn(_e13, d.x, d.y);
    // glimt_sh/src/basis.rs:159
    let _e21 = turn(_e17, d.x, d.y);
    // glimt_sh/src/basis.rs:160
    let _e24 = zonal_2_(d.z);
    q2_ = _e24;
    // glimt_sh/src/basis.rs:161
    let _e28 = zonal_3_(d.z);
    q3_ = _e28;
    // glimt_sh/src/basis.rs:162
    let _e32 = zonal_4_(d.z);
    q4_ = _e32;
    // glimt_sh/src/basis.rs:163
    let _e36 = zonal_5_(d.z);
    q5_ = _e36;
    // glimt_sh/src/basis.rs:164
    let _e50 = q2_[2];
    let _e54 = q2_[1];
    let _e58 = q2_[0];
    let _e60 = q2_[1];
    let _e64 = q2_[2];
    let _e68 = q3_[3];
    let _e72 = q3_[2];
    let _e76 = q3_[1];
    let _e80 = q3_[0];
    let _e82 = q3_[1];
    let _e86 = q3_[2];
    let _e90 = q3_[3];
    let _e94 = q4_[4];
    let _e98 = q4_[3];
    let _e102 = q4_[2];
    let _e106 = q4_[1];
    let _e110 = q4_[0];
    let _e112 = q4_[1];
    let _e116 = q4_[2];
    let _e120 = q4_[3];
    let _e124 = q4_[4];
    let _e128 = q5_[5];
    let _e132 = q5_[4];
    let _e136 = q5_[3];
    let _e140 = q5_[2];
    let _e144 = q5_[1];
    let _e148 = q5_[0];
    let _e150 = q5_[1];
    let _e154 = q5_[2];
    let _e158 = q5_[3];
    let _e162 = q5_[4];
    let _e166 = q5_[5];
    return array<f32, 36>(0.2820948f, (0.48860252f * p1_.y), (0.48860252f * d.z), (0.48860252f * p1_.x), (_e50 * _e9.y), (_e54 * p1_.y), _e58, (_e60 * p1_.x), (_e64 * _e9.x), (_e68 * _e13.y), (_e72 * _e9.y), (_e76 * p1_.y), _e80, (_e82 * p1_.x), (_e86 * _e9.x), (_e90 * _e13.x), (_e94 * _e17.y), (_e98 * _e13.y), (_e102 * _e9.y), (_e106 * p1_.y), _e110, (_e112 * p1_.x), (_e116 * _e9.x), (_e120 * _e13.x), (_e124 * _e17.x), (_e128 * _e21.y), (_e132 * _e17.y), (_e136 * _e13.y), (_e140 * _e9.y), (_e144 * p1_.y), _e148, (_e150 * p1_.x), (_e154 * _e9.x), (_e158 * _e13.x), (_e162 * _e17.x), (_e166 * _e21.x));
}

// glimt_sh/src/basis.rs:224
fn sh_add_basis(bands: u32, d_1: vec3<f32>, weight: f32, sums: ptr<function, array<f32, 36>>) {
    var q2_1: array<f32, 3>;
    var q3_1: array<f32, 4>;
    var q4_1: array<f32, 5>;
    var q5_1: array<f32, 6>;

    // glimt_sh/src/basis.rs:225
    if (bands > 0u) {
        // glimt_sh/src/basis.rs:226
        let _e12 = (*sums)[0];
        (*sums)[0] = (_e12 + (weight * 0.2820948f));
    }
    // glimt_sh/src/basis.rs:228
    if (bands > 1u) {
        // glimt_sh/src/basis.rs:229
        let p1_1 = vec2<f32>(d_1.x, d_1.y);
        // glimt_sh/src/basis.rs:230
        let _e27 = (*sums)[1];
        (*sums)[1] = (_e27 + (weight * (0.48860252f * p1_1.y)));
        // glimt_sh/src/basis.rs:231
        let _e35 = (*sums)[2];
        (*sums)[2] = (_e35 + (weight * (0.48860252f * d_1.z)));
        // glimt_sh/src/basis.rs:232
        let _e43 = (*sums)[3];
        (*sums)[3] = (_e43 + (weight * (0.48860252f * p1_1.x)));
        // glimt_sh/src/basis.rs:233
        if (bands > 2u) {
            // glimt_sh/src/basis.rs:234
            let _e51 = turn(p1_1, d_1.x, d_1.y);
            // glimt_sh/src/basis.rs:235
            let _e54 = zonal_2_(d_1.z);
            q2_1 = _e54;
            // glimt_sh/src/basis.rs:236
            let _e58 = q2_1[2];
            let _e63 = (*sums)[4];
            (*sums)[4] = (_e63 + (weight * (_e58 * _e51.y)));
            // glimt_sh/src/basis.rs:237
            let _e67 = q2_1[1];
            let _e72 = (*sums)[5];
            (*sums)[5] = (_e72 + (weight * (_e67 * p1_1.y)));
            // glimt_sh/src/basis.rs:238
            let _e76 = q2_1[0];
            let _e79 = (*sums)[6];
            (*sums)[6] = (_e79 + (weight * _e76));
            // glimt_sh/src/basis.rs:239
            let _e83 = q2_1[1];
            let _e88 = (*sums)[7];
            (*sums)[7] = (_e88 + (weight * (_e83 * p1_1.x)));
            // glimt_sh/src/basis.rs:240
            let _e92 = q2_1[2];
            let _e97 = (*sums)[8];
            (*sums)[8] = (_e97 + (weight * (_e92 * _e51.x)));
            // glimt_sh/src/basis.rs:241
            if (bands > 3u) {
                // glimt_sh/src/basis.rs:242
                let _e105 = turn(_e51, d_1.x, d_1.y);
                // glimt_sh/src/basis.rs:243
                let _e108 = zonal_3_(d_1.z);
                q3_1 = _e108;
                // glimt_sh/src/basis.rs:244
                let _e112 = q3_1[3];
                let _e117 = (*sums)[9];
                (*sums)[9] = (_e117 + (weight * (_e112 * _e105.y)));
                // glimt_sh/src/basis.rs:245
                let _e121 = q3_1[2];
                let _e126 = (*sums)[10];
                (*sums)[10] = (_e126 + (weight * (_e121 * _e51.y)));
                // glimt_sh/src/basis.rs:246
                let _e130 = q3_1[1];
                let _e135 = (*sums)[11];
                (*sums)[11] = (_e135 + (weight * (_e130 * p1_1.y)));
                // glimt_sh/src/basis.rs:247
                let _e139 = q3_1[0];
                let _e142 = (*sums)[12];
                (*sums)[12] = (_e142 + (weight * _e139));
                // glimt_sh/src/basis.rs:248
                let _e146 = q3_1[1];
                let _e151 = (*sums)[13];
                (*sums)[13] = (_e151 + (weight * (_e146 * p1_1.x)));
                // glimt_sh/src/basis.rs:249
                let _e155 = q3_1[2];
                let _e160 = (*sums)[14];
                (*sums)[14] = (_e160 + (weight * (_e155 * _e51.x)));
                // glimt_sh/src/basis.rs:250
                let _e164 = q3_1[3];
                let _e169 = (*sums)[15];
                (*sums)[15] = (_e169 + (weight * (_e164 * _e105.x)));
                // glimt_sh/src/basis.rs:251
                if (bands > 4u) {
                    // glimt_sh/src/basis.rs:252
                    let _e177 = turn(_e105, d_1.x, d_1.y);
                    // glimt_sh/src/basis.rs:253
                    let _e180 = zonal_4_(d_1.z);
                    q4_1 = _e180;
                    // glimt_sh/src/basis.rs:254
                    let _e184 = q4_1[4];
                    let _e189 = (*sums)[16];
                    (*sums)[16] = (_e189 + (weight * (_e184 * _e177.y)));
                    // glimt_sh/src/basis.rs:255
                    let _e193 = q4_1[3];
                    let _e198 = (*sums)[17];
                    (*sums)[17] = (_e198 + (weight * (_e193 * _e105.y)));
                    // glimt_sh/src/basis.rs:256
                    let _e202 = q4_1[2];
                    let _e207 = (*sums)[18];
                    (*sums)[18] = (_e207 + (weight * (_e202 * _e51.y)));
                    // glimt_sh/src/basis.rs:257
                    let _e211 = q4_1[1];
                    let _e216 = (*sums)[19];
                    (*sums)[19] = (_e216 + (weight * (_e211 * p1_1.y)));
                    // glimt_sh/src/basis.rs:258
                    let _e220 = q4_1[0];
                    let _e223 = (*sums)[20];
                    (*sums)[20] = (_e223 + (weight * _e220));
                    // glimt_sh/src/basis.rs:259
                    let _e227 = q4_1[1];
                    let _e232 = (*sums)[21];
                    (*sums)[21] = (_e232 + (weight * (_e227 * p1_1.x)));
                    // glimt_sh/src/basis.rs:260
                    let _e236 = q4_1[2];
                    let _e241 = (*sums)[22];
                    (*sums)[22] = (_e241 + (weight * (_e236 * _e51.x)));
                    // glimt_sh/src/basis.rs:261
                    let _e245 = q4_1[3];
                    let _e250 = (*sums)[23];
                    (*sums)[23] = (_e250 + (weight * (_e245 * _e105.x)));
                    // glimt_sh/src/basis.rs:262
                    let _e254 = q4_1[4];
                    let _e259 = (*sums)[24];
                    (*sums)[24] = (_e259 + (weight * (_e254 * _e177.x)));
                    // glimt_sh/src/basis.rs:263
                    if (bands > 5u) {
                        // glimt_sh/src/basis.rs:264
                        let _e267 = turn(_e177, d_1.x, d_1.y);
                        // glimt_sh/src/basis.rs:265
                        let _e270 = zonal_5_(d_1.z);
                        q5_1 = _e270;
                        // glimt_sh/src/basis.rs:266
                        let _e274 = q5_1[5];
                        let _e279 = (*sums)[25];
                        (*sums)[25] = (_e279 + (weight * (_e274 * _e267.y)));
                        // glimt_sh/src/basis.rs:267
                        let _e283 = q5_1[4];
                        let _e288 = (*sums)[26];
                        (*sums)[26] = (_e288 + (weight * (_e283 * _e177.y)));
                        // glimt_sh/src/basis.rs:268
                        let _e292 = q5_1[3];
                        let _e297 = (*sums)[27];
                        (*sums)[27] = (_e297 + (weight * (_e292 * _e105.y)));
                        // glimt_sh/src/basis.rs:269
                        let _e301 = q5_1[2];
                        let _e306 = (*sums)[28];
                        (*sums)[28] = (_e306 + (weight * (_e301 * _e51.y)));
                        // glimt_sh/src/basis.rs:270
                        let _e310 = q5_1[1];
                        let _e315 = (*sums)[29];
                        (*sums)[29] = (_e315 + (weight * (_e310 * p1_1.y)));
                        // glimt_sh/src/basis.rs:271
                        let _e319 = q5_1[0];
                        let _e322 = (*sums)[30];
                        (*sums)[30] = (_e322 + (weight * _e319));
                        // glimt_sh/src/basis.rs:272
                        let _e326 = q5_1[1];
                        let _e331 = (*sums)[31];
                        (*sums)[31] = (_e331 + (weight * (_e326 * p1_1.x)));
                        // glimt_sh/src/basis.rs:273
                        let _e335 = q5_1[2];
                        let _e340 = (*sums)[32];
                        (*sums)[32] = (_e340 + (weight * (_e335 * _e51.x)));
                        // glimt_sh/src/basis.rs:274
                        let _e344 = q5_1[3];
                        let _e349 = (*sums)[33];
                        (*sums)[33] = (_e349 + (weight * (_e344 * _e105.x)));
                        // glimt_sh/src/basis.rs:275
                        let _e353 = q5_1[4];
                        let _e358 = (*sums)[34];
                        (*sums)[34] = (_e358 + (weight * (_e353 * _e177.x)));
                        // glimt_sh/src/basis.rs:276
                        let _e362 = q5_1[5];
                        let _e367 = (*sums)[35];
                        (*sums)[35] = (_e367 + (weight * (_e362 * _e267.x)));
                    }
                }
            }
        }
    }
    return;
}

// glimt_sh/src/separable.rs:51
fn sh_ring(x_1: f32, y_1: f32) -> array<f32, 11> {

    // glimt_sh/src/separable.rs:52
    let p1_2 = vec2<f32>(x_1, y_1);
    // glimt_sh/src/separable.rs:53
    let _e6 = turn(p1_2, x_1, y_1);
    // glimt_sh/src/separable.rs:54
    let _e8 = turn(_e6, x_1, y_1);
    // glimt_sh/src/separable.rs:55
    let _e10 = turn(_e8, x_1, y_1);
    // glimt_sh/src/separable.rs:56
    let _e12 = turn(_e10, x_1, y_1);
    // glimt_sh/src/separable.rs:57
    return array<f32, 11>(1f, x_1, y_1, _e6.x, _e6.y, _e8.x, _e8.y, _e10.x, _e10.y, _e12.x, _e12.y);
}

// glimt_sh/src/separable.rs:73
fn sh_meridian(z_4: f32, s: f32) -> array<f32, 21> {
    var q2_2: array<f32, 3>;
    var q3_2: array<f32, 4>;
    var q4_2: array<f32, 5>;
    var q5_2: array<f32, 6>;

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
    q2_2 = _e12;
    // glimt_sh/src/separable.rs:79
    let _e15 = zonal_3_(z_4);
    q3_2 = _e15;
    // glimt_sh/src/separable.rs:80
    let _e18 = zonal_4_(z_4);
    q4_2 = _e18;
    // glimt_sh/src/separable.rs:81
    let _e21 = zonal_5_(z_4);
    q5_2 = _e21;
    // glimt_sh/src/separable.rs:82
    let _e30 = q2_2[0];
    let _e32 = q2_2[1];
    let _e35 = q2_2[2];
    let _e38 = q3_2[0];
    let _e40 = q3_2[1];
    let _e43 = q3_2[2];
    let _e46 = q3_2[3];
    let _e49 = q4_2[0];
    let _e51 = q4_2[1];
    let _e54 = q4_2[2];
    let _e57 = q4_2[3];
    let _e60 = q4_2[4];
    let _e63 = q5_2[0];
    let _e65 = q5_2[1];
    let _e68 = q5_2[2];
    let _e71 = q5_2[3];
    let _e74 = q5_2[4];
    let _e77 = q5_2[5];
    return array<f32, 21>(0.2820948f, (0.48860252f * z_4), (0.48860252f * s), _e30, (_e32 * s), (_e35 * s2_), _e38, (_e40 * s), (_e43 * s2_), (_e46 * s3_), _e49, (_e51 * s), (_e54 * s2_), (_e57 * s3_), (_e60 * s4_), _e63, (_e65 * s), (_e68 * s2_), (_e71 * s3_), (_e74 * s4_), (_e77 * s5_));
}

// glimt_sh/src/filter.rs:19
fn sh_hann(l: u32, window: f32) -> f32 {
    var chosen: f32;
    var chosen_1: f32;

    // glimt_sh/src/filter.rs:20
    let l_3 = f32(l);
    // glimt_sh/src/filter.rs:21
    if !((window > 0f)) {
        // glimt_sh/src/filter.rs:22
        chosen = 1f;
    } else {
        if (l_3 < window) {
            // glimt_sh/src/filter.rs:24
            chosen_1 = (0.5f + (0.5f * cos(((3.1415927f * l_3) / window))));
        } else {
            // glimt_sh/src/filter.rs:26
            chosen_1 = 0f;
        }
        let _e25 = chosen_1;
        chosen = _e25;
    }
    let _e26 = chosen;
    return _e26;
}

// glimt_sh/src/filter.rs:43
fn sh_cosine_lobe(l_1: u32) -> f32 {
    var chosen_2: f32;

    // glimt_sh/src/filter.rs:44
    if (l_1 == 0u) {
        // glimt_sh/src/filter.rs:45
        chosen_2 = 3.1415927f;
    } else {
        if (l_1 == 1u) {
            // glimt_sh/src/filter.rs:46
            chosen_2 = ((2f / 3f) * 3.1415927f);
        } else {
            if (l_1 == 2u) {
                // glimt_sh/src/filter.rs:47
                chosen_2 = (0.25f * 3.1415927f);
            } else {
                if (l_1 == 4u) {
                    // glimt_sh/src/filter.rs:48
                    chosen_2 = (-3.1415927f / 24f);
                } else {
                    // glimt_sh/src/filter.rs:49
                    chosen_2 = 0f;
                }
            }
        }
    }
    let _e30 = chosen_2;
    return _e30;
}

// glimt_sh/src/basis.rs:50
fn sh_coefficient_band(k: u32) -> u32 {
    var l_2: u32;

    // glimt_sh/src/basis.rs:51
    l_2 = 0u;
    // glimt_sh/src/basis.rs:52
    loop {
        let _e6 = l_2;
        let _e9 = l_2;
        let _e12 = l_2;
        if ((_e6 < 5u) && (k >= ((_e9 + 1u) * (_e12 + 1u)))) {
            // glimt_sh/src/basis.rs:53
            let _e20 = l_2;
            l_2 = (_e20 + 1u);
        } else {
            break;
        }
    }
    // glimt_sh/src/basis.rs:55
    let _e23 = l_2;
    return _e23;
}

// glimt_sh/src/basis.rs:66
fn sh_coefficient_order(k_1: u32) -> i32 {

    // glimt_sh/src/basis.rs:67
    let _e3 = sh_coefficient_band(k_1);
    // glimt_sh/src/basis.rs:68
    return (i32(k_1) - i32((_e3 * (_e3 + 1u))));
}

// glimt_sh/src/filter.rs:68
fn sh_temporal_filter(current: f32, before: f32, alpha: f32) -> f32 {

    // glimt_sh/src/filter.rs:69
    if !((alpha > 0f)) {
        // glimt_sh/src/filter.rs:70
        return current;
    }
    // glimt_sh/src/filter.rs:72
    return (before + ((current - before) / (1f + alpha)));
}

// glimt_sh/src/filter.rs:88
fn sh_rotate_z(m: i32, own: f32, opposite: f32, angle: vec2<f32>) -> f32 {
    var whole: vec2<f32>;
    var counter: i32;
    var chosen_3: f32;

    // glimt_sh/src/filter.rs:89
    whole = vec2<f32>(1f, 0f);
    // glimt_sh/src/filter.rs:90
    counter = 0i;
    loop {
        let _e14 = counter;
        if (_e14 >= abs(m)) {
            break;
        }
        // glimt_sh/src/filter.rs:91
        let _e17 = whole;
        let _e20 = turn(_e17, angle.x, angle.y);
        whole = _e20;
        continuing {
            let _e21 = counter;
            counter = (_e21 + 1i);
        }
    }
    // glimt_sh/src/filter.rs:93
    if (m > 0i) {
        // glimt_sh/src/filter.rs:94
        let _e30 = whole.x;
        let _e33 = whole.y;
        chosen_3 = ((own * _e30) - (opposite * _e33));
    } else {
        // glimt_sh/src/filter.rs:96
        let _e38 = whole.x;
        let _e41 = whole.y;
        chosen_3 = ((own * _e38) + (opposite * _e41));
    }
    let _e44 = chosen_3;
    return _e44;
}

// glimt_sampling/src/warp.rs:182
fn cos_sin_turns(turns: f32) -> vec2<f32> {
    var chosen_4: f32;

    // glimt_sampling/src/warp.rs:183
    if (turns < 0.5f) {
        chosen_4 = turns;
    } else {
        chosen_4 = (turns - 1f);
    }
    let signed = chosen_4;
    // glimt_sampling/src/warp.rs:184
    let phi = (6.2831855f * signed);
    // glimt_sampling/src/warp.rs:185
    return vec2<f32>(cos(phi), sin(phi));
}

// glimt_sampling/src/warp.rs:169
fn sample_cap(u: vec2<f32>, height: f32) -> DirectionSample {

    // glimt_sampling/src/warp.rs:170
    let h = (u.x * height);
    // glimt_sampling/src/warp.rs:172
    let sin_theta = sqrt(max((h * (2f - h)), 0f));
    // glimt_sampling/src/warp.rs:173
    let _e15 = cos_sin_turns(u.y);
    // glimt_sampling/src/warp.rs:174
    return DirectionSample(vec3<f32>((sin_theta * _e15.x), (sin_theta * _e15.y), (1f - h)), ((0.5f * 0.31830987f) / height));
}

// glimt_sampling/src/warp.rs:125
fn sample_uniform_sphere(u_1: vec2<f32>) -> DirectionSample {

    // glimt_sampling/src/warp.rs:126
    let _e4 = sample_cap(u_1, 2f);
    return _e4;
}

// glimt_sh/src/directions.rs:20
fn sh_stratified_direction(i: u32, strata: vec2<u32>, u_2: vec2<f32>) -> vec3<f32> {

    // glimt_sh/src/directions.rs:21
    let strata_1 = max(strata, vec2(1u));
    // glimt_sh/src/directions.rs:22
    let part = vec2<f32>(f32(((i / strata_1.y) % strata_1.x)), f32((i % strata_1.y)));
    // glimt_sh/src/directions.rs:23
    let _e22 = sample_uniform_sphere(((part + u_2) / vec2<f32>(strata_1)));
    return _e22.direction;
}

