// Made from Rust by naga-front-rust; do not edit. This command writes it: cargo run --release -p glimt-generate

struct BlinnPhong {
    diffuse: vec3<f32>,
    specular: vec3<f32>,
    exponent: f32,
}

struct HalfVector {
    cos2_theta: f32,
    sin2_theta: f32,
    wo_dot_h: f32,
}

struct DirectionSample {
    direction: vec3<f32>,
    pdf_sr: f32,
}

struct BrdfSample {
    wi: vec3<f32>,
    pdf_sr: f32,
}

struct Lambert {
    diffuse: vec3<f32>,
}

// glimt_brdf/src/lobe.rs:86
fn normalisation(exponent: f32) -> f32 {

    // glimt_brdf/src/lobe.rs:87
    let tail = exp2(max((-0.5f * exponent), -60f));
    // glimt_brdf/src/lobe.rs:88
    return ((((exponent + 2f) * (exponent + 4f)) * (0.125f * 0.31830987f)) / (tail + exponent));
}

// glimt_brdf/src/lobe.rs:20
fn HalfVector_new(wo: vec3<f32>, wi: vec3<f32>) -> HalfVector {

    // glimt_brdf/src/lobe.rs:21
    let sum = (wo + wi);
    // glimt_brdf/src/lobe.rs:23
    let length2_ = max(dot(sum, sum), 0.00000000000000000001f);
    // glimt_brdf/src/lobe.rs:24
    return HalfVector(((sum.z * sum.z) / length2_), (((sum.x * sum.x) + (sum.y * sum.y)) / length2_), (0.5f * sqrt(length2_)));
}

// glimt_brdf/src/lobe.rs:59
fn cosine_power(cos2_theta: f32, sin2_theta: f32, exponent_1: f32) -> f32 {
    var chosen: f32;

    // glimt_brdf/src/lobe.rs:60
    if (sin2_theta < (1f / 16f)) {
        // glimt_brdf/src/lobe.rs:62
        let t = (sin2_theta / (2f - sin2_theta));
        // glimt_brdf/src/lobe.rs:63
        let t2_ = (t * t);
        // glimt_brdf/src/lobe.rs:64
        chosen = ((-2f * t) * (1f + (t2_ * ((1f / 3f) + (t2_ * (1f / 5f))))));
    } else {
        // glimt_brdf/src/lobe.rs:66
        chosen = log(max(cos2_theta, 0.0000000000000000000000000000000000001f));
    }
    let log_cos2_ = chosen;
    // glimt_brdf/src/lobe.rs:68
    let log_power = ((0.5f * exponent_1) * log_cos2_);
    // glimt_brdf/src/lobe.rs:69
    if (log_power < -85f) {
        // glimt_brdf/src/lobe.rs:70
        return 0f;
    }
    // glimt_brdf/src/lobe.rs:72
    return exp(log_power);
}

// glimt_brdf/src/lobe.rs:32
fn HalfVector_lobe(this_: HalfVector, exponent_2: f32) -> f32 {

    // glimt_brdf/src/lobe.rs:33
    let _e6 = cosine_power(this_.cos2_theta, this_.sin2_theta, exponent_2);
    return _e6;
}

// glimt_brdf/src/blinn_phong.rs:59
fn blinn_phong_eval(this_1: BlinnPhong, wo_1: vec3<f32>, wi_1: vec3<f32>) -> vec3<f32> {

    // glimt_brdf/src/blinn_phong.rs:60
    if ((wo_1.z <= 0f) || (wi_1.z <= 0f)) {
        // glimt_brdf/src/blinn_phong.rs:61
        return vec3(0f);
    }
    // glimt_brdf/src/blinn_phong.rs:63
    let diffuse = (this_1.diffuse * 0.31830987f);
    // glimt_brdf/src/blinn_phong.rs:65
    if (max(max(this_1.specular.x, this_1.specular.y), this_1.specular.z) <= 0f) {
        // glimt_brdf/src/blinn_phong.rs:66
        return diffuse;
    }
    // glimt_brdf/src/blinn_phong.rs:68
    let _e31 = normalisation(this_1.exponent);
    let _e32 = HalfVector_new(wo_1, wi_1);
    let _e34 = HalfVector_lobe(_e32, this_1.exponent);
    let lobe = (_e31 * _e34);
    // glimt_brdf/src/blinn_phong.rs:69
    return (diffuse + (this_1.specular * lobe));
}

// glimt_sampling/src/uniform.rs:15
fn unit_f32_(u: u32) -> f32 {

    // glimt_sampling/src/uniform.rs:16
    return (f32((u >> 8u)) * (1f / 16777216f));
}

// glimt_sampling/src/math.rs:16
fn luminance(rgb: vec3<f32>) -> f32 {

    // glimt_sampling/src/math.rs:17
    return (((0.2126f * rgb.x) + (0.7152f * rgb.y)) + (0.0722f * rgb.z));
}

// glimt_brdf/src/blinn_phong.rs:116
fn BlinnPhong_pmf_specular(this_2: BlinnPhong) -> f32 {
    var chosen_1: f32;

    // glimt_brdf/src/blinn_phong.rs:117
    let _e4 = luminance(this_2.specular);
    // glimt_brdf/src/blinn_phong.rs:118
    let _e7 = luminance(this_2.diffuse);
    let both = (_e7 + _e4);
    // glimt_brdf/src/blinn_phong.rs:119
    if (both > 0f) {
        chosen_1 = (_e4 / both);
    } else {
        chosen_1 = 0f;
    }
    let _e15 = chosen_1;
    return _e15;
}

// glimt_sampling/src/warp.rs:190
fn height_of(direction: vec3<f32>) -> f32 {
    var chosen_2: f32;

    // glimt_sampling/src/warp.rs:191
    if (direction.z > 0f) {
        // glimt_sampling/src/warp.rs:192
        chosen_2 = (((direction.x * direction.x) + (direction.y * direction.y)) / (1f + direction.z));
    } else {
        // glimt_sampling/src/warp.rs:194
        chosen_2 = (1f - direction.z);
    }
    let _e23 = chosen_2;
    return _e23;
}

// glimt_sampling/src/warp.rs:201
fn ln_cos_theta(direction_1: vec3<f32>) -> f32 {

    // glimt_sampling/src/warp.rs:202
    let _e3 = height_of(direction_1);
    // glimt_sampling/src/warp.rs:203
    if (_e3 < 0.1f) {
        // glimt_sampling/src/warp.rs:204
        let tail_1 = ((1f / 3f) + (_e3 * (0.25f + (_e3 * (0.2f + (_e3 * ((1f / 6f) + (_e3 / 7f))))))));
        // glimt_sampling/src/warp.rs:205
        return (0f - (_e3 * (1f + (_e3 * (0.5f + (_e3 * tail_1))))));
    }
    // glimt_sampling/src/warp.rs:207
    return log(direction_1.z);
}

// glimt_sampling/src/warp.rs:289
fn pdf_power_cosine_sr(direction_2: vec3<f32>, exponent_3: f32) -> f32 {
    var chosen_3: f32;

    // glimt_sampling/src/warp.rs:290
    let normalisation_1 = ((exponent_3 + 1f) * (0.5f * 0.31830987f));
    // glimt_sampling/src/warp.rs:291
    if (exponent_3 <= 0f) {
        // glimt_sampling/src/warp.rs:292
        if (direction_2.z >= 0f) {
            // glimt_sampling/src/warp.rs:293
            chosen_3 = normalisation_1;
        } else {
            // glimt_sampling/src/warp.rs:295
            chosen_3 = 0f;
        }
        let _e21 = chosen_3;
        return _e21;
    }
    // glimt_sampling/src/warp.rs:298
    if (direction_2.z <= 0f) {
        // glimt_sampling/src/warp.rs:299
        return 0f;
    }
    // glimt_sampling/src/warp.rs:301
    let _e29 = ln_cos_theta(direction_2);
    return (normalisation_1 * exp((exponent_3 * _e29)));
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

// glimt_sampling/src/warp.rs:257
fn sample_power_cosine(u_1: vec2<f32>, exponent_4: f32) -> DirectionSample {
    var sin2_theta_1: f32;
    var cos_theta: f32;

    // glimt_sampling/src/warp.rs:258
    if (u_1.x <= 0f) {
        // glimt_sampling/src/warp.rs:259
        let _e16 = pdf_power_cosine_sr(vec3<f32>(1f, 0f, 0f), exponent_4);
        return DirectionSample(vec3<f32>(1f, 0f, 0f), _e16);
    }
    // glimt_sampling/src/warp.rs:266
    let t_1 = ((2f / (exponent_4 + 1f)) * (0f - log(u_1.x)));
    // glimt_sampling/src/warp.rs:269
    if (t_1 < 0.25f) {
        // glimt_sampling/src/warp.rs:270
        let tail_2 = ((1f / 6f) - (t_1 * ((1f / 24f) - (t_1 * ((1f / 120f) - (t_1 / 720f))))));
        // glimt_sampling/src/warp.rs:271
        sin2_theta_1 = max((t_1 * (1f - (t_1 * (0.5f - (t_1 * tail_2))))), 0f);
        // glimt_sampling/src/warp.rs:272
        let _e62 = sin2_theta_1;
        cos_theta = sqrt((1f - _e62));
    } else {
        // glimt_sampling/src/warp.rs:274
        cos_theta = exp((-0.5f * t_1));
        // glimt_sampling/src/warp.rs:275
        let _e71 = cos_theta;
        let _e72 = cos_theta;
        sin2_theta_1 = (1f - (_e71 * _e72));
    }
    // glimt_sampling/src/warp.rs:277
    let _e76 = sin2_theta_1;
    let sin_theta = sqrt(_e76);
    // glimt_sampling/src/warp.rs:278
    let _e80 = cos_sin_turns(u_1.y);
    // glimt_sampling/src/warp.rs:279
    let _e86 = cos_theta;
    let direction_4 = vec3<f32>((sin_theta * _e80.x), (sin_theta * _e80.y), _e86);
    // glimt_sampling/src/warp.rs:280
    let _e89 = pdf_power_cosine_sr(direction_4, exponent_4);
    return DirectionSample(direction_4, _e89);
}

// glimt_sampling/src/warp.rs:31
fn sample_concentric_disk(u_2: vec2<f32>) -> vec2<f32> {

    // glimt_sampling/src/warp.rs:32
    let a = ((2f * u_2.x) - 1f);
    // glimt_sampling/src/warp.rs:33
    let b = ((2f * u_2.y) - 1f);
    // glimt_sampling/src/warp.rs:34
    if ((a == 0f) && (b == 0f)) {
        // glimt_sampling/src/warp.rs:35
        return vec2(0f);
    }
    // glimt_sampling/src/warp.rs:37
    if ((a * a) > (b * b)) {
        // glimt_sampling/src/warp.rs:38
        let phi_1 = (0.7853982f * (b / a));
        // glimt_sampling/src/warp.rs:39
        return vec2<f32>((a * cos(phi_1)), (a * sin(phi_1)));
    }
    // glimt_sampling/src/warp.rs:41
    let phi_2 = (0.7853982f * (a / b));
    // glimt_sampling/src/warp.rs:42
    return vec2<f32>((b * sin(phi_2)), (b * cos(phi_2)));
}

// glimt_sampling/src/warp.rs:88
fn sample_cosine_hemisphere(u_3: vec2<f32>) -> DirectionSample {

    // glimt_sampling/src/warp.rs:89
    let _e3 = sample_concentric_disk(u_3);
    // glimt_sampling/src/warp.rs:92
    let _e10 = abs(((2f * u_3) - vec2(1f)));
    let r = max(_e10.x, _e10.y);
    // glimt_sampling/src/warp.rs:93
    let z = sqrt(((1f - r) * (1f + r)));
    // glimt_sampling/src/warp.rs:94
    return DirectionSample(vec3<f32>(_e3, z), (z * 0.31830987f));
}

// glimt_sampling/src/warp.rs:103
fn pdf_cosine_hemisphere_sr(direction_3: vec3<f32>) -> f32 {

    // glimt_sampling/src/warp.rs:104
    return (max(direction_3.z, 0f) * 0.31830987f);
}

// glimt_brdf/src/lobe.rs:37
fn HalfVector_pdf_sr(this_3: HalfVector, exponent_5: f32) -> f32 {

    // glimt_brdf/src/lobe.rs:38
    let _e10 = HalfVector_lobe(this_3, exponent_5);
    return ((((exponent_5 + 1f) * (0.5f * 0.31830987f)) * _e10) / (4f * this_3.wo_dot_h));
}

// glimt_brdf/src/blinn_phong.rs:99
fn blinn_phong_pdf_sr(this_4: BlinnPhong, wo_2: vec3<f32>, wi_2: vec3<f32>) -> f32 {

    // glimt_brdf/src/blinn_phong.rs:100
    if ((wo_2.z <= 0f) || (wi_2.z <= 0f)) {
        // glimt_brdf/src/blinn_phong.rs:101
        return 0f;
    }
    // glimt_brdf/src/blinn_phong.rs:103
    let _e15 = pdf_cosine_hemisphere_sr(wi_2);
    // glimt_brdf/src/blinn_phong.rs:104
    let _e17 = BlinnPhong_pmf_specular(this_4);
    // glimt_brdf/src/blinn_phong.rs:105
    if (_e17 <= 0f) {
        // glimt_brdf/src/blinn_phong.rs:106
        return _e15;
    }
    // glimt_brdf/src/blinn_phong.rs:108
    let _e23 = HalfVector_new(wo_2, wi_2);
    let _e25 = HalfVector_pdf_sr(_e23, this_4.exponent);
    // glimt_brdf/src/blinn_phong.rs:109
    return ((_e17 * _e25) + ((1f - _e17) * _e15));
}

// glimt_brdf/src/blinn_phong.rs:80
fn blinn_phong_sample(this_5: BlinnPhong, wo_3: vec3<f32>, u_lobe: u32, u_4: vec2<f32>) -> BrdfSample {
    var chosen_5: vec3<f32>;

    // glimt_brdf/src/blinn_phong.rs:81
    let _e7 = unit_f32_(u_lobe);
    let _e8 = BlinnPhong_pmf_specular(this_5);
    if (_e7 < _e8) {
        // glimt_brdf/src/blinn_phong.rs:82
        let _e12 = sample_power_cosine(u_4, this_5.exponent);
        let h = _e12.direction;
        // glimt_brdf/src/blinn_phong.rs:83
        chosen_5 = (((2f * dot(wo_3, h)) * h) - wo_3);
    } else {
        // glimt_brdf/src/blinn_phong.rs:85
        let _e21 = sample_cosine_hemisphere(u_4);
        chosen_5 = _e21.direction;
    }
    let wi_5 = chosen_5;
    // glimt_brdf/src/blinn_phong.rs:87
    let _e25 = blinn_phong_pdf_sr(this_5, wo_3, wi_5);
    return BrdfSample(wi_5, _e25);
}

// glimt_brdf/src/lambert.rs:30
fn lambert_eval(this_6: Lambert, wo_4: vec3<f32>, wi_3: vec3<f32>) -> vec3<f32> {
    var chosen_6: vec3<f32>;

    // glimt_brdf/src/lambert.rs:31
    if ((wo_4.z > 0f) && (wi_3.z > 0f)) {
        // glimt_brdf/src/lambert.rs:32
        chosen_6 = (this_6.diffuse * 0.31830987f);
    } else {
        // glimt_brdf/src/lambert.rs:34
        chosen_6 = vec3(0f);
    }
    let _e20 = chosen_6;
    return _e20;
}

// glimt_brdf/src/lambert.rs:52
fn lambert_pdf_sr(this_7: Lambert, wo_5: vec3<f32>, wi_4: vec3<f32>) -> f32 {
    var chosen_7: f32;

    // glimt_brdf/src/lambert.rs:53
    if (wo_5.z > 0f) {
        // glimt_brdf/src/lambert.rs:54
        let _e9 = pdf_cosine_hemisphere_sr(wi_4);
        chosen_7 = _e9;
    } else {
        // glimt_brdf/src/lambert.rs:56
        chosen_7 = 0f;
    }
    let _e12 = chosen_7;
    return _e12;
}

// glimt_brdf/src/lambert.rs:41
fn lambert_sample(this_8: Lambert, wo_6: vec3<f32>, u_5: vec2<f32>) -> BrdfSample {

    // glimt_brdf/src/lambert.rs:42
    let _e5 = sample_cosine_hemisphere(u_5);
    let wi_6 = _e5.direction;
    // glimt_brdf/src/lambert.rs:43
    let _e8 = lambert_pdf_sr(this_8, wo_6, wi_6);
    return BrdfSample(wi_6, _e8);
}

