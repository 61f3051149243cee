// Made from Rust by naga-front-rust; do not edit. This command writes it: cargo run --release -p glimt-generate

struct RayState {
    normal: vec3<f32>,
    log_normaliser: f32,
    wo: vec3<f32>,
    depth: f32,
    diffuse: f32,
    specular: f32,
    exponent: f32,
    age: u32,
    ess: f32,
    log_ratio: f32,
    started: u32,
    accepted: u32,
}

struct SmcPoint {
    origin: vec3<f32>,
    depth: f32,
    geometric_normal: vec3<f32>,
    catcher: u32,
    normal: vec3<f32>,
    exponent: f32,
    wo: vec3<f32>,
    predecessor: u32,
    diffuse: vec3<f32>,
    unused_a: u32,
    specular: vec3<f32>,
    unused_b: u32,
    emission: vec3<f32>,
    unused_c: u32,
    before: RayState,
}

struct Particle {
    state: vec3<f32>,
    log_weight: f32,
}

struct ColourMatrix {
    red: vec4<f32>,
    green: vec4<f32>,
    blue: vec4<f32>,
}

struct FrameParams {
    eye: vec3<f32>,
    width: u32,
    forward: vec3<f32>,
    height: u32,
    right: vec3<f32>,
    rays_per_pixel: u32,
    up: vec3<f32>,
    first_pixel: u32,
    pattern: u32,
    filter_: u32,
    background: u32,
    seed: u32,
    frame: u32,
    tonemap: u32,
    exposure: f32,
    shadow: u32,
    film_frame: u32,
    unused_a: u32,
    unused_b: u32,
    unused_c: u32,
    to_plate: ColourMatrix,
    to_display: ColourMatrix,
}

struct SmcParams {
    intermediate: u32,
    path: u32,
    scheme: u32,
    ess_threshold: f32,
    floor: f32,
    previous_floor: f32,
    cap_height: f32,
    cap_share: f32,
    light_share: f32,
    band: f32,
    max_age: u32,
    candidates: u32,
    source: u32,
    changed: u32,
    unused_a: u32,
    unused_b: u32,
}

struct PixelPattern {
    kind: u32,
    seed: u32,
    frame: u32,
    pixel: u32,
    ray: u32,
    rays: u32,
}

struct ShadingFrame {
    t: vec3<f32>,
    b: vec3<f32>,
    n: vec3<f32>,
}

struct BlinnPhong {
    diffuse: vec3<f32>,
    specular: vec3<f32>,
    exponent: f32,
}

struct ShadingPoint {
    origin: vec3<f32>,
    geometric_normal: vec3<f32>,
    frame: ShadingFrame,
    wo: vec3<f32>,
    brdf: BlinnPhong,
    emission: vec3<f32>,
}

struct LightLobe {
    frame: ShadingFrame,
    wo: vec3<f32>,
    brdf: BlinnPhong,
}

struct OwenSobol {
    seed: u32,
    index: u32,
    dimension: u32,
}

struct Xoshiro128PlusPlus {
    state: vec4<u32>,
}

struct PatternSource {
    is_sobol: bool,
    point: OwenSobol,
    generator: Xoshiro128PlusPlus,
}

struct CapMove {
    height: f32,
}

struct BrdfDraw {
    frame: ShadingFrame,
    wo: vec3<f32>,
    brdf: BlinnPhong,
}

struct Independent_BrdfDraw {
    sampler: BrdfDraw,
}

struct Bridge {
    path: u32,
    intermediate: u32,
}

struct Sampler {
    bridge: Bridge,
    scheme: u32,
    ess_threshold: f32,
}

struct Report {
    log_ratio: f32,
    ess: f32,
    resampled: u32,
    accepted: u32,
}

struct HalfVector {
    cos2_theta: f32,
    sin2_theta: f32,
    wo_dot_h: f32,
}

struct Endpoints {
    previous: f32,
    current: f32,
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

struct Split {
    first: bool,
    word: u32,
}

struct Proposed {
    state: vec3<f32>,
    forward: f32,
    backward: f32,
}

struct DirectionSample {
    direction: vec3<f32>,
    pdf_sr: f32,
}

struct Returned_Environment_cdf {
    value_size: vec2<u32>,
    value_conditional_start: u32,
    value_conditional_len: u32,
}

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

struct Sampled {
    state: vec3<f32>,
    pdf: f32,
}

struct BrdfSample {
    wi: vec3<f32>,
    pdf_sr: f32,
}

struct Candidates {
    count: u32,
    source: u32,
    floor: f32,
}

struct RisSum {
    sum: f32,
    candidates: u32,
    end: u32,
}

struct Tuple_UVec2_u32_ {
    fa: vec2<u32>,
    fb: u32,
}

struct Tuple_u32_u32_ {
    fa: u32,
    fb: u32,
}

struct Candidate {
    direction: vec3<f32>,
    wi: vec3<f32>,
    radiance: vec3<f32>,
    target_: f32,
    weight: f32,
}

struct Word {
    f0_: u32,
}

struct RisPicks {
    comb: Comb,
    sum: f32,
    samples: f32,
    left: u32,
    candidate: u32,
    end: u32,
}

struct Params {
    first: u32,
    count: u32,
    state_len: u32,
    particles_len: u32,
    frame: FrameParams,
    smc: SmcParams,
    env_size: vec2<u32>,
    env_rotation: vec2<f32>,
    before_size: vec2<u32>,
    before_rotation: vec2<f32>,
}

@group(0) @binding(1) 
var<storage> env_texels: array<vec4<f32>>;
@group(0) @binding(2) 
var<storage> env_tables: array<u32>;
@group(0) @binding(3) 
var<storage> before_texels: array<vec4<f32>>;
@group(0) @binding(4) 
var<storage> points: array<SmcPoint>;
@group(0) @binding(5) 
var<storage> past_particles: array<Particle>;
@group(0) @binding(6) 
var<storage, read_write> state_5: array<RayState>;
@group(0) @binding(7) 
var<storage, read_write> particles: array<Particle>;
@group(0) @binding(0) 
var<uniform> params: Params;

// glimt_render_gpu/src/kernels/smc_point.rs:73
fn SmcPoint_is_hit(this_: SmcPoint) -> bool {

    // glimt_render_gpu/src/kernels/smc_point.rs:74
    return (this_.depth > 0f);
}

// glimt_render_gpu/src/kernels/frame.rs:130
fn FrameParams_pattern_at(this_1: FrameParams, pixel: u32, ray: u32) -> PixelPattern {

    // glimt_render_gpu/src/kernels/frame.rs:131
    return PixelPattern(this_1.pattern, this_1.seed, this_1.frame, pixel, ray, this_1.rays_per_pixel);
}

// glimt_render_gpu/src/kernels/frame.rs:120
fn FrameParams_pattern_of(this_2: FrameParams, ray_1: u32) -> PixelPattern {

    // glimt_render_gpu/src/kernels/frame.rs:121
    let _e10 = FrameParams_pattern_at(this_2, (this_2.first_pixel + (ray_1 / this_2.rays_per_pixel)), (ray_1 % this_2.rays_per_pixel));
    return _e10;
}

// glimt_sampling/src/math.rs:45
fn ShadingFrame_from_normal(n: vec3<f32>) -> ShadingFrame {

    // glimt_sampling/src/math.rs:46
    let sign_ = bitcast<f32>(((bitcast<u32>(1f) & 2147483647u) | (bitcast<u32>(n.z) & 2147483648u)));
    // glimt_sampling/src/math.rs:47
    let a_2 = (-1f / (sign_ + n.z));
    // glimt_sampling/src/math.rs:48
    let c_1 = ((n.x * n.y) * a_2);
    // glimt_sampling/src/math.rs:49
    return ShadingFrame(vec3<f32>((1f + (((sign_ * n.x) * n.x) * a_2)), (sign_ * c_1), (-(sign_) * n.x)), vec3<f32>(c_1, (sign_ + ((n.y * n.y) * a_2)), -(n.y)), n);
}

// glimt_sampling/src/math.rs:66
fn ShadingFrame_to_local(this_3: ShadingFrame, v: vec3<f32>) -> vec3<f32> {

    // glimt_sampling/src/math.rs:67
    return vec3<f32>(dot(v, this_3.t), dot(v, this_3.b), dot(v, this_3.n));
}

// glimt_render_gpu/src/kernels/smc_point.rs:80
fn SmcPoint_shading_point(this_4: SmcPoint) -> ShadingPoint {

    // glimt_render_gpu/src/kernels/smc_point.rs:81
    let _e4 = ShadingFrame_from_normal(this_4.normal);
    // glimt_render_gpu/src/kernels/smc_point.rs:82
    let _e9 = ShadingFrame_to_local(_e4, this_4.wo);
    return ShadingPoint(this_4.origin, this_4.geometric_normal, _e4, _e9, BlinnPhong(this_4.diffuse, this_4.specular, this_4.exponent), this_4.emission);
}

// glimt_sampling/src/math.rs:16
fn luminance(rgb: vec3<f32>) -> f32 {

    // glimt_sampling/src/math.rs:17
    return (((0.2126f * rgb.x) + (0.7152f * rgb.y)) + (0.0722f * rgb.z));
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

// glimt_render_gpu/src/kernels/smc.rs:84
fn SmcParams_is_due(this_5: SmcParams, age: u32, pattern: PixelPattern) -> bool {

    // glimt_render_gpu/src/kernels/smc.rs:85
    if (this_5.max_age == 0u) {
        // glimt_render_gpu/src/kernels/smc.rs:86
        return false;
    }
    // glimt_render_gpu/src/kernels/smc.rs:88
    let _e13 = hash2_(pattern.seed, 15u);
    let _e16 = hash3_(_e13, pattern.pixel, pattern.ray);
    let phase = (_e16 % this_5.max_age);
    // glimt_render_gpu/src/kernels/smc.rs:89
    let turn = ((pattern.frame + phase) % this_5.max_age);
    // glimt_render_gpu/src/kernels/smc.rs:90
    return ((age >= this_5.max_age) || (turn == 0u));
}

// glimt_render_gpu/src/kernels/light_target.rs:41
fn LightLobe_of_state(state: RayState) -> LightLobe {

    // glimt_render_gpu/src/kernels/light_target.rs:42
    let _e4 = ShadingFrame_from_normal(state.normal);
    // glimt_render_gpu/src/kernels/light_target.rs:43
    let _e7 = ShadingFrame_to_local(_e4, state.wo);
    return LightLobe(_e4, _e7, BlinnPhong(vec3(state.diffuse), vec3(state.specular), state.exponent));
}

// glimt_render_gpu/src/kernels/light_target.rs:26
fn LightLobe_of_point(point: ShadingPoint) -> LightLobe {

    // glimt_render_gpu/src/kernels/light_target.rs:27
    let _e7 = luminance(point.brdf.diffuse);
    let _e11 = luminance(point.brdf.specular);
    return LightLobe(point.frame, point.wo, BlinnPhong(vec3(_e7), vec3(_e11), point.brdf.exponent));
}

// glimt_sampling/src/sobol.rs:172
fn OwenSobol_new(seed: u32, frame: u32, pixel_1: u32, sample_index: u32) -> OwenSobol {

    // glimt_sampling/src/sobol.rs:173
    let _e6 = hash3_(seed, frame, pixel_1);
    let _e9 = hash2_(_e6, (sample_index >> 16u));
    return OwenSobol(_e9, (sample_index & 65535u), 0u);
}

// glimt_render_gpu/src/kernels/pattern.rs:136
fn PixelPattern_sobol_point(this_6: PixelPattern, purpose: u32, index: u32) -> OwenSobol {

    // glimt_render_gpu/src/kernels/pattern.rs:137
    let _e6 = hash2_(this_6.seed, purpose);
    let _e9 = OwenSobol_new(_e6, this_6.frame, this_6.pixel, index);
    return _e9;
}

// glimt_sampling/src/hash.rs:50
fn hash_uvec4_(v_1: vec4<u32>) -> vec4<u32> {
    var x_1: u32;
    var y: u32;
    var z: u32;
    var w: u32;

    // glimt_sampling/src/hash.rs:51
    let _e4 = hash_u32_(v_1.x);
    x_1 = ((_e4 * 1664525u) + 1013904223u);
    // glimt_sampling/src/hash.rs:54
    let _e12 = hash_u32_(v_1.y);
    y = ((_e12 * 1664525u) + 1013904223u);
    // glimt_sampling/src/hash.rs:57
    let _e20 = hash_u32_(v_1.z);
    z = ((_e20 * 1664525u) + 1013904223u);
    // glimt_sampling/src/hash.rs:60
    let _e28 = hash_u32_(v_1.w);
    w = ((_e28 * 1664525u) + 1013904223u);
    // glimt_sampling/src/hash.rs:64
    let _e35 = x_1;
    let _e36 = y;
    let _e37 = w;
    x_1 = (_e35 + (_e36 * _e37));
    // glimt_sampling/src/hash.rs:65
    let _e41 = y;
    let _e42 = z;
    let _e43 = x_1;
    y = (_e41 + (_e42 * _e43));
    // glimt_sampling/src/hash.rs:66
    let _e47 = z;
    let _e48 = x_1;
    let _e49 = y;
    z = (_e47 + (_e48 * _e49));
    // glimt_sampling/src/hash.rs:67
    let _e53 = w;
    let _e54 = y;
    let _e55 = z;
    w = (_e53 + (_e54 * _e55));
    // glimt_sampling/src/hash.rs:68
    let _e59 = x_1;
    let _e62 = x_1;
    x_1 = (_e62 ^ (_e59 >> 16u));
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
    let _e83 = x_1;
    let _e84 = y;
    let _e85 = w;
    x_1 = (_e83 + (_e84 * _e85));
    // glimt_sampling/src/hash.rs:73
    let _e89 = y;
    let _e90 = z;
    let _e91 = x_1;
    y = (_e89 + (_e90 * _e91));
    // glimt_sampling/src/hash.rs:74
    let _e95 = z;
    let _e96 = x_1;
    let _e97 = y;
    z = (_e95 + (_e96 * _e97));
    // glimt_sampling/src/hash.rs:75
    let _e101 = w;
    let _e102 = y;
    let _e103 = z;
    w = (_e101 + (_e102 * _e103));
    // glimt_sampling/src/hash.rs:76
    let _e107 = x_1;
    let _e108 = x_1;
    let _e112 = y;
    let _e113 = y;
    let _e117 = z;
    let _e118 = z;
    let _e122 = w;
    let _e123 = w;
    return vec4<u32>((_e107 ^ (_e108 >> 16u)), (_e112 ^ (_e113 >> 16u)), (_e117 ^ (_e118 >> 16u)), (_e122 ^ (_e123 >> 16u)));
}

// glimt_sampling/src/xoshiro.rs:28
fn Xoshiro128PlusPlus_from_state(state_1: vec4<u32>) -> Xoshiro128PlusPlus {

    // glimt_sampling/src/xoshiro.rs:29
    let any_ = (((state_1.x | state_1.y) | state_1.z) | state_1.w);
    // glimt_sampling/src/xoshiro.rs:30
    if (any_ == 0u) {
        // glimt_sampling/src/xoshiro.rs:31
        return Xoshiro128PlusPlus(vec4<u32>(2065550767u, 3793791033u, 2713282036u, 1853398634u));
    }
    // glimt_sampling/src/xoshiro.rs:35
    return Xoshiro128PlusPlus(state_1);
}

// glimt_sampling/src/xoshiro.rs:49
fn Xoshiro128PlusPlus_stream(seed_1: u32, frame_1: u32, pixel_2: u32) -> Xoshiro128PlusPlus {

    // glimt_sampling/src/xoshiro.rs:50
    let _e7 = hash_uvec4_(vec4<u32>(pixel_2, frame_1, seed_1, 2654435769u));
    let _e8 = Xoshiro128PlusPlus_from_state(_e7);
    return _e8;
}

// glimt_render_gpu/src/kernels/pattern.rs:141
fn PixelPattern_generator(this_7: PixelPattern, purpose_1: u32, index_1: u32) -> Xoshiro128PlusPlus {

    // glimt_render_gpu/src/kernels/pattern.rs:142
    let _e6 = hash3_(this_7.seed, purpose_1, index_1);
    let _e9 = Xoshiro128PlusPlus_stream(_e6, this_7.frame, this_7.pixel);
    return _e9;
}

// glimt_render_gpu/src/kernels/pattern.rs:105
fn PixelPattern_point(this_8: PixelPattern, purpose_2: u32, index_2: u32) -> PatternSource {

    // glimt_render_gpu/src/kernels/pattern.rs:106
    let _e8 = PixelPattern_sobol_point(this_8, purpose_2, index_2);
    let _e9 = PixelPattern_generator(this_8, purpose_2, index_2);
    return PatternSource((this_8.kind == 0u), _e8, _e9);
}

// glimt_render_gpu/src/kernels/pattern.rs:97
fn PixelPattern_source(this_9: PixelPattern, purpose_3: u32) -> PatternSource {

    // glimt_render_gpu/src/kernels/pattern.rs:98
    let _e5 = PixelPattern_point(this_9, purpose_3, this_9.ray);
    return _e5;
}

// glimt_render_gpu/src/kernels/smc.rs:96
fn SmcParams_sampler(this_10: SmcParams) -> Sampler {

    // glimt_render_gpu/src/kernels/smc.rs:97
    return Sampler(Bridge(this_10.path, this_10.intermediate), this_10.scheme, this_10.ess_threshold);
}

// glimt_smc/src/bridge.rs:48
fn Bridge_steps(this_11: Bridge) -> u32 {

    // glimt_smc/src/bridge.rs:49
    return (this_11.intermediate + 1u);
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
    let sum_3 = (wo + wi);
    // glimt_brdf/src/lobe.rs:23
    let length2_ = max(dot(sum_3, sum_3), 0.00000000000000000001f);
    // glimt_brdf/src/lobe.rs:24
    return HalfVector(((sum_3.z * sum_3.z) / length2_), (((sum_3.x * sum_3.x) + (sum_3.y * sum_3.y)) / length2_), (0.5f * sqrt(length2_)));
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
fn HalfVector_lobe(this_12: HalfVector, exponent_2: f32) -> f32 {

    // glimt_brdf/src/lobe.rs:33
    let _e6 = cosine_power(this_12.cos2_theta, this_12.sin2_theta, exponent_2);
    return _e6;
}

// glimt_brdf/src/blinn_phong.rs:59
fn BlinnPhong_eval(this_13: BlinnPhong, wo_1: vec3<f32>, wi_1: vec3<f32>) -> vec3<f32> {

    // glimt_brdf/src/blinn_phong.rs:60
    if ((wo_1.z <= 0f) || (wi_1.z <= 0f)) {
        // glimt_brdf/src/blinn_phong.rs:61
        return vec3(0f);
    }
    // glimt_brdf/src/blinn_phong.rs:63
    let diffuse = (this_13.diffuse * 0.31830987f);
    // glimt_brdf/src/blinn_phong.rs:65
    if (max(max(this_13.specular.x, this_13.specular.y), this_13.specular.z) <= 0f) {
        // glimt_brdf/src/blinn_phong.rs:66
        return diffuse;
    }
    // glimt_brdf/src/blinn_phong.rs:68
    let _e31 = normalisation(this_13.exponent);
    let _e32 = HalfVector_new(wo_1, wi_1);
    let _e34 = HalfVector_lobe(_e32, this_13.exponent);
    let lobe_3 = (_e31 * _e34);
    // glimt_brdf/src/blinn_phong.rs:69
    return (diffuse + (this_13.specular * lobe_3));
}

// glimt_render_gpu/src/kernels/light_target.rs:57
fn LightLobe_value(this_14: LightLobe, direction: vec3<f32>) -> f32 {

    // glimt_render_gpu/src/kernels/light_target.rs:58
    let _e5 = ShadingFrame_to_local(this_14.frame, direction);
    // glimt_render_gpu/src/kernels/light_target.rs:59
    if !((_e5.z > 0f)) {
        // glimt_render_gpu/src/kernels/light_target.rs:60
        return 0f;
    }
    // glimt_render_gpu/src/kernels/light_target.rs:62
    let _e16 = BlinnPhong_eval(this_14.brdf, this_14.wo, _e5);
    return (_e16.x * _e5.z);
}

// glimt_probe/src/rotate.rs:33
fn rotate_z(d: vec3<f32>, cos_sin: vec2<f32>) -> vec3<f32> {

    // glimt_probe/src/rotate.rs:34
    return vec3<f32>(((d.x * cos_sin.x) - (d.y * cos_sin.y)), ((d.x * cos_sin.y) + (d.y * cos_sin.x)), d.z);
}

// glimt_probe/src/latlong.rs:45
fn direction_to_uv(d_1: vec3<f32>) -> vec2<f32> {
    var chosen_1: f32;
    var chosen_2: f32;

    // glimt_probe/src/latlong.rs:46
    let horizontal = sqrt(((d_1.x * d_1.x) + (d_1.y * d_1.y)));
    // glimt_probe/src/latlong.rs:47
    if (horizontal <= 0f) {
        // glimt_probe/src/latlong.rs:48
        if (d_1.z < 0f) {
            chosen_1 = 1f;
        } else {
            chosen_1 = 0f;
        }
        let v_3 = chosen_1;
        // glimt_probe/src/latlong.rs:49
        return vec2<f32>(0.5f, v_3);
    }
    // glimt_probe/src/latlong.rs:52
    let v_4 = (atan2(horizontal, d_1.z) * 0.31830987f);
    // glimt_probe/src/latlong.rs:53
    let u_22 = (0.5f - ((0.5f * 0.31830987f) * atan2(d_1.y, d_1.x)));
    // glimt_probe/src/latlong.rs:54
    if (u_22 < 1f) {
        chosen_2 = max(u_22, 0f);
    } else {
        chosen_2 = 0f;
    }
    let _e47 = chosen_2;
    return vec2<f32>(_e47, clamp(v_4, 0f, 1f));
}

// glimt_probe/src/latlong.rs:68
fn direction_to_texel(d_2: vec3<f32>, size: vec2<u32>) -> vec2<u32> {

    // glimt_probe/src/latlong.rs:69
    let size_16 = max(size, vec2(1u));
    // glimt_probe/src/latlong.rs:70
    let _e8 = direction_to_uv(d_2);
    let position = (_e8 * vec2<f32>(size_16));
    // glimt_probe/src/latlong.rs:71
    return min(vec2<u32>(position), (size_16 - vec2(1u)));
}

// glimt_render_gpu/src/kernels/environment.rs:37
fn RadianceMap_radiance(size_1: vec2<u32>, rotation: vec2<f32>, direction_1: vec3<f32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/environment.rs:38
    let to_map = vec2<f32>(rotation.x, -(rotation.y));
    // glimt_render_gpu/src/kernels/environment.rs:39
    let _e10 = rotate_z(direction_1, to_map);
    let _e11 = direction_to_texel(_e10, size_1);
    // glimt_render_gpu/src/kernels/environment.rs:40
    let _e20 = before_texels[((_e11.y * size_1.x) + _e11.x)];
    return _e20.xyz;
}

// glimt_render_gpu/src/kernels/light_target.rs:101
fn LightTarget_previous(previous_light_size: vec2<u32>, previous_light_rotation: vec2<f32>, previous_floor: f32, previous_lobe: LightLobe, light_size: vec2<u32>, light_rotation: vec2<f32>, floor_: f32, lobe: LightLobe, direction_2: vec3<f32>) -> f32 {

    // glimt_render_gpu/src/kernels/light_target.rs:102
    let _e7 = LightLobe_value(previous_lobe, direction_2);
    // glimt_render_gpu/src/kernels/light_target.rs:103
    if !((_e7 > 0f)) {
        // glimt_render_gpu/src/kernels/light_target.rs:104
        return 0f;
    }
    // glimt_render_gpu/src/kernels/light_target.rs:106
    let _e15 = RadianceMap_radiance(previous_light_size, previous_light_rotation, direction_2);
    let _e16 = luminance(_e15);
    return ((_e16 + previous_floor) * _e7);
}

// glimt_render_gpu/src/kernels/environment.rs:89
fn Environment_to_map(size_2: vec2<u32>, rotation_1: vec2<f32>, direction_3: vec3<f32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/environment.rs:90
    let _e8 = rotate_z(direction_3, vec2<f32>(rotation_1.x, -(rotation_1.y)));
    return _e8;
}

// glimt_render_gpu/src/kernels/environment.rs:96
fn Environment_texel(size_3: vec2<u32>, rotation_2: vec2<f32>, direction_4: vec3<f32>) -> vec2<u32> {

    // glimt_render_gpu/src/kernels/environment.rs:97
    let _e5 = Environment_to_map(size_3, rotation_2, direction_4);
    let _e6 = direction_to_texel(_e5, size_3);
    return _e6;
}

// glimt_render_gpu/src/kernels/environment.rs:103
fn Environment_radiance(size_4: vec2<u32>, rotation_3: vec2<f32>, texel: vec2<u32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/environment.rs:104
    let _e11 = env_texels[((texel.y * size_4.x) + texel.x)];
    return _e11.xyz;
}

// glimt_render_gpu/src/kernels/light_target.rs:89
fn LightTarget_current(previous_light_size_1: vec2<u32>, previous_light_rotation_1: vec2<f32>, previous_floor_1: f32, previous_lobe_1: LightLobe, light_size_1: vec2<u32>, light_rotation_1: vec2<f32>, floor_1: f32, lobe_1: LightLobe, direction_5: vec3<f32>) -> f32 {

    // glimt_render_gpu/src/kernels/light_target.rs:90
    let _e7 = LightLobe_value(lobe_1, direction_5);
    // glimt_render_gpu/src/kernels/light_target.rs:91
    if !((_e7 > 0f)) {
        // glimt_render_gpu/src/kernels/light_target.rs:92
        return 0f;
    }
    // glimt_render_gpu/src/kernels/light_target.rs:94
    let _e15 = Environment_texel(light_size_1, light_rotation_1, direction_5);
    let _e16 = Environment_radiance(light_size_1, light_rotation_1, _e15);
    // glimt_render_gpu/src/kernels/light_target.rs:95
    let _e18 = luminance(_e16);
    return ((_e18 + floor_1) * _e7);
}

// glimt_render_gpu/src/kernels/light_target.rs:112
fn LightTarget_densities(previous_light_size_2: vec2<u32>, previous_light_rotation_2: vec2<f32>, previous_floor_2: f32, previous_lobe_2: LightLobe, light_size_2: vec2<u32>, light_rotation_2: vec2<f32>, floor_2: f32, lobe_2: LightLobe, state_2: vec3<f32>) -> Endpoints {

    // glimt_render_gpu/src/kernels/light_target.rs:113
    let _e11 = LightTarget_previous(previous_light_size_2, previous_light_rotation_2, previous_floor_2, previous_lobe_2, light_size_2, light_rotation_2, floor_2, lobe_2, state_2);
    let _e12 = LightTarget_current(previous_light_size_2, previous_light_rotation_2, previous_floor_2, previous_lobe_2, light_size_2, light_rotation_2, floor_2, lobe_2, state_2);
    return Endpoints(_e11, _e12);
}

// glimt_smc/src/bridge.rs:65
fn Bridge_density(this_15: Bridge, k: u32, ends: Endpoints) -> f32 {

    // glimt_smc/src/bridge.rs:66
    if (k == 0u) {
        // glimt_smc/src/bridge.rs:67
        return ends.previous;
    }
    // glimt_smc/src/bridge.rs:69
    let _e10 = Bridge_steps(this_15);
    if (k >= _e10) {
        // glimt_smc/src/bridge.rs:70
        return ends.current;
    }
    // glimt_smc/src/bridge.rs:72
    let _e16 = Bridge_steps(this_15);
    let beta = (f32(k) / f32(_e16));
    // glimt_smc/src/bridge.rs:73
    if (this_15.path == 0u) {
        // glimt_smc/src/bridge.rs:74
        return (((1f - beta) * ends.previous) + (beta * ends.current));
    }
    // glimt_smc/src/bridge.rs:76
    if (!((ends.previous > 0f)) || !((ends.current > 0f))) {
        // glimt_smc/src/bridge.rs:77
        return 0f;
    }
    // glimt_smc/src/bridge.rs:79
    return (pow(ends.previous, (1f - beta)) * pow(ends.current, beta));
}

// glimt_smc/src/particle.rs:33
fn is_log_zero(log_weight: f32) -> bool {

    // glimt_smc/src/particle.rs:34
    return !((log_weight > (0.5f * -1000000000000000000000000000000f)));
}

// glimt_smc/src/weights.rs:28
fn normalise(particles_start: u32, particles_len: u32) -> f32 {
    var largest: f32;
    var counter: u32;
    var sum: f32;
    var counter_1: u32;
    var counter_2: u32;

    // glimt_smc/src/weights.rs:29
    // glimt_smc/src/weights.rs:30
    largest = -1000000000000000000000000000000f;
    // glimt_smc/src/weights.rs:31
    counter = 0u;
    loop {
        let i = counter;
        if (i >= particles_len) {
            break;
        }
        // glimt_smc/src/weights.rs:32
        let _e13 = largest;
        let _e18 = particles[(particles_start + i)].log_weight;
        largest = max(_e13, _e18);
        continuing {
            let _e20 = counter;
            counter = (_e20 + 1u);
        }
    }
    // glimt_smc/src/weights.rs:34
    let _e24 = largest;
    let _e25 = is_log_zero(_e24);
    if _e25 {
        // glimt_smc/src/weights.rs:35
        return -1000000000000000000000000000000f;
    }
    // glimt_smc/src/weights.rs:37
    sum = 0f;
    // glimt_smc/src/weights.rs:38
    counter_1 = 0u;
    loop {
        let i_1 = counter_1;
        if (i_1 >= particles_len) {
            break;
        }
        // glimt_smc/src/weights.rs:39
        let _e41 = particles[(particles_start + i_1)].log_weight;
        let _e42 = largest;
        let _e45 = sum;
        sum = (_e45 + exp((_e41 - _e42)));
        continuing {
            let _e47 = counter_1;
            counter_1 = (_e47 + 1u);
        }
    }
    // glimt_smc/src/weights.rs:41
    let _e51 = sum;
    let rest = log(_e51);
    // glimt_smc/src/weights.rs:42
    counter_2 = 0u;
    loop {
        let i_2 = counter_2;
        if (i_2 >= particles_len) {
            break;
        }
        // glimt_smc/src/weights.rs:43
        let _e63 = particles[(particles_start + i_2)].log_weight;
        let _e64 = is_log_zero(_e63);
        if !(_e64) {
            // glimt_smc/src/weights.rs:45
            let _e71 = particles[(particles_start + i_2)].log_weight;
            let _e72 = largest;
            particles[(particles_start + i_2)].log_weight = ((_e71 - _e72) - rest);
        }
        continuing {
            let _e79 = counter_2;
            counter_2 = (_e79 + 1u);
        }
    }
    // glimt_smc/src/weights.rs:48
    let _e83 = largest;
    return (_e83 + rest);
}

// glimt_smc/src/reweight.rs:13
fn reweight(k_1: u32, bridge: Bridge, target_previous_light_size: vec2<u32>, target_previous_light_rotation: vec2<f32>, target_previous_floor: f32, target_previous_lobe: LightLobe, target_light_size: vec2<u32>, target_light_rotation: vec2<f32>, target_floor: f32, target_lobe: LightLobe, particles_start_1: u32, particles_len_1: u32) -> f32 {
    var counter_3: u32;
    var chosen_3: f32;
    var both: bool;

    // glimt_smc/src/reweight.rs:14
    counter_3 = 0u;
    loop {
        let i_3 = counter_3;
        if (i_3 >= particles_len_1) {
            break;
        }
        // glimt_smc/src/reweight.rs:15
        let _e23 = particles[(particles_start_1 + i_3)].state;
        let _e24 = LightTarget_densities(target_previous_light_size, target_previous_light_rotation, target_previous_floor, target_previous_lobe, target_light_size, target_light_rotation, target_floor, target_lobe, _e23);
        // glimt_smc/src/reweight.rs:16
        let _e28 = Bridge_density(bridge, (k_1 - 1u), _e24);
        // glimt_smc/src/reweight.rs:17
        let _e30 = Bridge_density(bridge, k_1, _e24);
        // glimt_smc/src/reweight.rs:18
        let old = particles[(particles_start_1 + i_3)].log_weight;
        // glimt_smc/src/reweight.rs:19
        let _e43 = ((_e28 > 0f) && (_e30 > 0f));
        both = _e43;
        if _e43 {
            let _e45 = is_log_zero(old);
            both = !(_e45);
        }
        let _e47 = both;
        if _e47 {
            // glimt_smc/src/reweight.rs:20
            chosen_3 = (old + (log(_e30) - log(_e28)));
        } else {
            // glimt_smc/src/reweight.rs:22
            chosen_3 = -1000000000000000000000000000000f;
        }
        let _e55 = chosen_3;
        particles[(particles_start_1 + i_3)].log_weight = _e55;
        continuing {
            let _e60 = counter_3;
            counter_3 = (_e60 + 1u);
        }
    }
    // glimt_smc/src/reweight.rs:25
    let _e64 = normalise(particles_start_1, particles_len_1);
    return _e64;
}

// glimt_smc/src/particle.rs:25
fn Particle_weight(this_16: Particle) -> f32 {

    // glimt_smc/src/particle.rs:26
    return exp(this_16.log_weight);
}

// glimt_smc/src/weights.rs:65
fn ess(particles_start_2: u32, particles_len_2: u32) -> f32 {
    var squares: f32;
    var counter_4: u32;
    var chosen_4: f32;

    // glimt_smc/src/weights.rs:66
    squares = 0f;
    // glimt_smc/src/weights.rs:67
    counter_4 = 0u;
    loop {
        let i_4 = counter_4;
        if (i_4 >= particles_len_2) {
            break;
        }
        // glimt_smc/src/weights.rs:68
        let _e15 = particles[(particles_start_2 + i_4)];
        let _e16 = Particle_weight(_e15);
        // glimt_smc/src/weights.rs:69
        let _e19 = squares;
        squares = (_e19 + (_e16 * _e16));
        continuing {
            let _e21 = counter_4;
            counter_4 = (_e21 + 1u);
        }
    }
    // glimt_smc/src/weights.rs:71
    let _e26 = squares;
    if (_e26 > 0f) {
        let _e30 = squares;
        chosen_4 = (1f / _e30);
    } else {
        chosen_4 = 0f;
    }
    let _e33 = chosen_4;
    return _e33;
}

// glimt_sampling/src/resample.rs:45
fn sure_copies(scheme: u32, expected: f32) -> u32 {
    var chosen_5: u32;

    // glimt_sampling/src/resample.rs:46
    if (scheme == 3u) {
        // glimt_sampling/src/resample.rs:47
        chosen_5 = u32(expected);
    } else {
        // glimt_sampling/src/resample.rs:49
        chosen_5 = 0u;
    }
    let _e11 = chosen_5;
    return _e11;
}

// glimt_sampling/src/sobol.rs:21
fn owen_scramble_reversed(n_2: u32, scramble: u32) -> u32 {
    var x_2: u32;

    // glimt_sampling/src/sobol.rs:22
    x_2 = (n_2 ^ (n_2 * 1025551850u));
    // glimt_sampling/src/sobol.rs:23
    let _e9 = x_2;
    x_2 = (_e9 + scramble);
    // glimt_sampling/src/sobol.rs:24
    let _e12 = x_2;
    x_2 = (_e12 * ((scramble >> 16u) | 1u));
    // glimt_sampling/src/sobol.rs:25
    let _e19 = x_2;
    let _e22 = x_2;
    x_2 = (_e22 ^ (_e19 * 89287766u));
    // glimt_sampling/src/sobol.rs:26
    let _e25 = x_2;
    let _e26 = x_2;
    return (_e25 ^ (_e26 * 1403136100u));
}

// glimt_sampling/src/sobol.rs:104
fn shuffle(index_3: u32, seed_2: u32) -> u32 {

    // glimt_sampling/src/sobol.rs:105
    let _e7 = hash_u32_((seed_2 ^ 2043055690u));
    let _e8 = owen_scramble_reversed(reverseBits(index_3), _e7);
    return reverseBits(_e8);
}

// glimt_sampling/src/sobol.rs:56
fn pascal(index_4: u32) -> u32 {
    var x_3: u32;

    // glimt_sampling/src/sobol.rs:57
    x_3 = index_4;
    // glimt_sampling/src/sobol.rs:58
    let _e5 = x_3;
    let _e10 = x_3;
    x_3 = (_e10 ^ ((_e5 >> 1u) & 21845u));
    // glimt_sampling/src/sobol.rs:59
    let _e13 = x_3;
    let _e18 = x_3;
    x_3 = (_e18 ^ ((_e13 >> 2u) & 13107u));
    // glimt_sampling/src/sobol.rs:60
    let _e21 = x_3;
    let _e26 = x_3;
    x_3 = (_e26 ^ ((_e21 >> 4u) & 3855u));
    // glimt_sampling/src/sobol.rs:61
    let _e29 = x_3;
    let _e30 = x_3;
    return (_e29 ^ ((_e30 >> 8u) & 255u));
}

// glimt_sampling/src/sobol.rs:66
fn recurrence_2_(index_5: u32) -> u32 {
    var bits: u32;
    var v0_: u32;
    var v1_: u32;
    var sum_1: u32;
    var counter_5: i32;

    // glimt_sampling/src/sobol.rs:67
    bits = index_5;
    // glimt_sampling/src/sobol.rs:68
    v0_ = 1u;
    // glimt_sampling/src/sobol.rs:69
    v1_ = 3u;
    // glimt_sampling/src/sobol.rs:70
    sum_1 = 0u;
    // glimt_sampling/src/sobol.rs:72
    counter_5 = 0i;
    loop {
        let _e17 = counter_5;
        if (_e17 >= 16i) {
            break;
        }
        // glimt_sampling/src/sobol.rs:73
        let _e20 = v0_;
        let _e21 = bits;
        let _e27 = sum_1;
        sum_1 = (_e27 ^ (_e20 & (0u - (_e21 & 1u))));
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
            let _e44 = counter_5;
            counter_5 = (_e44 + 1i);
        }
    }
    // glimt_sampling/src/sobol.rs:79
    let _e48 = sum_1;
    return _e48;
}

// glimt_sampling/src/sobol.rs:84
fn recurrence_3_(index_6: u32) -> u32 {
    var bits_1: u32;
    var v0_1: u32;
    var v1_1: u32;
    var v2_: u32;
    var sum_2: u32;
    var counter_6: i32;

    // glimt_sampling/src/sobol.rs:85
    bits_1 = index_6;
    // glimt_sampling/src/sobol.rs:86
    v0_1 = 1u;
    // glimt_sampling/src/sobol.rs:87
    v1_1 = 3u;
    // glimt_sampling/src/sobol.rs:88
    v2_ = 4u;
    // glimt_sampling/src/sobol.rs:89
    sum_2 = 0u;
    // glimt_sampling/src/sobol.rs:90
    counter_6 = 0i;
    loop {
        let _e20 = counter_6;
        if (_e20 >= 16i) {
            break;
        }
        // glimt_sampling/src/sobol.rs:91
        let _e23 = v0_1;
        let _e24 = bits_1;
        let _e30 = sum_2;
        sum_2 = (_e30 ^ (_e23 & (0u - (_e24 & 1u))));
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
            let _e49 = counter_6;
            counter_6 = (_e49 + 1i);
        }
    }
    // glimt_sampling/src/sobol.rs:98
    let _e53 = sum_2;
    return _e53;
}

// glimt_sampling/src/sobol.rs:43
fn sobol_reversed(index_7: u32, dimension: u32) -> u32 {
    var chosen_6: u32;

    // glimt_sampling/src/sobol.rs:44
    let index_14 = (index_7 & 65535u);
    // glimt_sampling/src/sobol.rs:45
    let _e8 = (dimension & 3u);
    if (_e8 == 0u) {
        // glimt_sampling/src/sobol.rs:47
        chosen_6 = index_14;
    } else {
        if (_e8 == 1u) {
            // glimt_sampling/src/sobol.rs:48
            let _e16 = pascal(index_14);
            chosen_6 = _e16;
        } else {
            if (_e8 == 2u) {
                // glimt_sampling/src/sobol.rs:49
                let _e20 = recurrence_2_(index_14);
                chosen_6 = _e20;
            } else {
                // glimt_sampling/src/sobol.rs:50
                let _e22 = recurrence_3_(index_14);
                chosen_6 = _e22;
            }
        }
    }
    let _e23 = chosen_6;
    return _e23;
}

// glimt_sampling/src/sobol.rs:110
fn scramble_1(reversed: u32, dimension_1: u32, seed_3: u32) -> u32 {
    var chosen_7: u32;

    // glimt_sampling/src/sobol.rs:111
    let _e6 = (dimension_1 & 3u);
    if (_e6 == 0u) {
        // glimt_sampling/src/sobol.rs:112
        chosen_7 = 2435803578u;
    } else {
        if (_e6 == 1u) {
            // glimt_sampling/src/sobol.rs:113
            chosen_7 = 391059627u;
        } else {
            if (_e6 == 2u) {
                // glimt_sampling/src/sobol.rs:114
                chosen_7 = 1763603146u;
            } else {
                // glimt_sampling/src/sobol.rs:115
                chosen_7 = 3020734904u;
            }
        }
    }
    let salt = chosen_7;
    // glimt_sampling/src/sobol.rs:118
    let _e27 = hash_u32_(((seed_3 * 2626628923u) ^ salt));
    // glimt_sampling/src/sobol.rs:119
    let _e29 = owen_scramble_reversed(reversed, _e27);
    return reverseBits(_e29);
}

// glimt_sampling/src/sobol.rs:136
fn owen_sobol(index_8: u32, dimension_2: u32, seed_4: u32) -> u32 {

    // glimt_sampling/src/sobol.rs:137
    let _e5 = shuffle(index_8, seed_4);
    let _e6 = sobol_reversed(_e5, dimension_2);
    let _e7 = scramble_1(_e6, dimension_2, seed_4);
    return _e7;
}

// glimt_sampling/src/sobol.rs:183
fn OwenSobol_next_u32_(this_17: ptr<function, OwenSobol>) -> u32 {

    // glimt_sampling/src/sobol.rs:184
    let dimension_3 = (*this_17).dimension;
    // glimt_sampling/src/sobol.rs:185
    (*this_17).dimension = (dimension_3 + 1u);
    // glimt_sampling/src/sobol.rs:186
    let _e11 = (*this_17).index;
    let _e13 = (*this_17).seed;
    let _e16 = hash2_(_e13, (dimension_3 >> 2u));
    let _e17 = owen_sobol(_e11, dimension_3, _e16);
    return _e17;
}

// glimt_sampling/src/xoshiro.rs:56
fn Xoshiro128PlusPlus_next_u32_(this_18: ptr<function, Xoshiro128PlusPlus>) -> u32 {

    // glimt_sampling/src/xoshiro.rs:57
    let s = (*this_18).state;
    // glimt_sampling/src/xoshiro.rs:58
    let _e8 = (s.x + s.w);
    let result = (((_e8 << 7u) | (_e8 >> ((0u - 7u) & 31u))) + s.x);
    // glimt_sampling/src/xoshiro.rs:59
    let z_1 = (s.z ^ s.x);
    // glimt_sampling/src/xoshiro.rs:60
    let w_1 = (s.w ^ s.y);
    // glimt_sampling/src/xoshiro.rs:61
    (*this_18).state = vec4<u32>((s.x ^ w_1), (s.y ^ z_1), (z_1 ^ (s.y << 9u)), ((w_1 << 11u) | (w_1 >> ((0u - 11u) & 31u))));
    // glimt_sampling/src/xoshiro.rs:62
    return result;
}

// glimt_render_gpu/src/kernels/pattern.rs:171
fn PatternSource_next_u32_(this_19: ptr<function, PatternSource>) -> u32 {
    var chosen_8: u32;
    var borrowed: OwenSobol;
    var borrowed_1: Xoshiro128PlusPlus;

    // glimt_render_gpu/src/kernels/pattern.rs:172
    let _e5 = (*this_19).is_sobol;
    if _e5 {
        // glimt_render_gpu/src/kernels/pattern.rs:173
        let _e9 = (*this_19).point;
        borrowed = _e9;
        let _e10 = OwenSobol_next_u32_((&borrowed));
        let _e11 = borrowed;
        (*this_19).point = _e11;
        chosen_8 = _e10;
    } else {
        // glimt_render_gpu/src/kernels/pattern.rs:175
        let _e15 = (*this_19).generator;
        borrowed_1 = _e15;
        let _e16 = Xoshiro128PlusPlus_next_u32_((&borrowed_1));
        let _e17 = borrowed_1;
        (*this_19).generator = _e17;
        chosen_8 = _e16;
    }
    let _e18 = chosen_8;
    return _e18;
}

// glimt_sampling/src/uniform.rs:15
fn unit_f32_(u: u32) -> f32 {

    // glimt_sampling/src/uniform.rs:16
    return (f32((u >> 8u)) * (1f / 16777216f));
}

// glimt_sampling/src/resample.rs:136
fn Comb_place_tooth(this_20: ptr<function, Comb>, source: ptr<function, PatternSource>) {

    // glimt_sampling/src/resample.rs:137
    let _e5 = (*this_20).made;
    let _e7 = (*this_20).teeth;
    if (_e5 >= _e7) {
        // glimt_sampling/src/resample.rs:138
        return;
    }
    // glimt_sampling/src/resample.rs:140
    let _e12 = (*this_20).made;
    let first_1 = f32(_e12);
    // glimt_sampling/src/resample.rs:141
    let _e16 = (*this_20).scheme;
    if (_e16 == 0u) {
        // glimt_sampling/src/resample.rs:142
        let _e21 = (*this_20).state;
        (*this_20).next = (first_1 + _e21);
    } else {
        let _e25 = (*this_20).scheme;
        if (_e25 == 1u) {
            // glimt_sampling/src/resample.rs:144
            let _e29 = PatternSource_next_u32_(source);
            let _e30 = unit_f32_(_e29);
            (*this_20).next = (first_1 + _e30);
        } else {
            // glimt_sampling/src/resample.rs:147
            let _e35 = PatternSource_next_u32_(source);
            let _e36 = unit_f32_(_e35);
            let v_5 = (1f - _e36);
            // glimt_sampling/src/resample.rs:148
            let _e40 = (*this_20).teeth;
            let _e42 = (*this_20).made;
            let left_2 = f32((_e40 - _e42));
            // glimt_sampling/src/resample.rs:149
            let _e50 = (*this_20).state;
            (*this_20).state = (_e50 * pow(v_5, (1f / left_2)));
            // glimt_sampling/src/resample.rs:150
            let _e55 = (*this_20).state;
            let _e58 = (*this_20).teeth;
            (*this_20).next = ((1f - _e55) * f32(_e58));
        }
    }
    return;
}

// glimt_sampling/src/resample.rs:85
fn Comb_new(scheme_1: u32, picks: u32, sure: u32, source_1: ptr<function, PatternSource>) -> Comb {
    var comb: Comb;

    // glimt_sampling/src/resample.rs:86
    comb = Comb(scheme_1, picks, (max(picks, sure) - sure), 0u, 0f, 0f, 1f);
    // glimt_sampling/src/resample.rs:95
    if (scheme_1 == 0u) {
        // glimt_sampling/src/resample.rs:96
        let _e18 = PatternSource_next_u32_(source_1);
        let _e19 = unit_f32_(_e18);
        comb.state = _e19;
    }
    // glimt_sampling/src/resample.rs:98
    Comb_place_tooth((&comb), source_1);
    // glimt_sampling/src/resample.rs:99
    let _e23 = comb;
    return _e23;
}

// glimt_sampling/src/resample.rs:106
fn Comb_take(this_21: ptr<function, Comb>, expected_1: f32, source_2: ptr<function, PatternSource>) -> u32 {

    // glimt_sampling/src/resample.rs:107
    let _e6 = (*this_21).scheme;
    let _e7 = sure_copies(_e6, expected_1);
    // glimt_sampling/src/resample.rs:108
    let _e12 = (*this_21).reach;
    (*this_21).reach = (_e12 + (expected_1 - f32(_e7)));
    // glimt_sampling/src/resample.rs:109
    let before = (*this_21).made;
    // glimt_sampling/src/resample.rs:110
    loop {
        let _e19 = (*this_21).made;
        let _e21 = (*this_21).teeth;
        let _e24 = (*this_21).next;
        let _e26 = (*this_21).reach;
        if ((_e19 < _e21) && (_e24 < _e26)) {
            // glimt_sampling/src/resample.rs:111
            let _e32 = (*this_21).made;
            (*this_21).made = (_e32 + 1u);
            // glimt_sampling/src/resample.rs:112
            Comb_place_tooth(this_21, source_2);
        } else {
            break;
        }
    }
    // glimt_sampling/src/resample.rs:114
    let _e37 = (*this_21).made;
    return (_e7 + (_e37 - before));
}

// glimt_sampling/src/resample.rs:121
fn Comb_finish(this_22: ptr<function, Comb>, source_3: ptr<function, PatternSource>) -> u32 {
    var counter_7: u32;

    // glimt_sampling/src/resample.rs:122
    let _e5 = (*this_22).teeth;
    let _e7 = (*this_22).made;
    let left_3 = (_e5 - _e7);
    // glimt_sampling/src/resample.rs:123
    let _e11 = (*this_22).scheme;
    if (_e11 != 0u) {
        // glimt_sampling/src/resample.rs:125
        let _e16 = (*this_22).teeth;
        let _e18 = (*this_22).made;
        let drawn = min(_e16, (_e18 + 1u));
        // glimt_sampling/src/resample.rs:126
        let _e24 = (*this_22).picks;
        counter_7 = drawn;
        loop {
            let _e26 = counter_7;
            if (_e26 >= _e24) {
                break;
            }
            // glimt_sampling/src/resample.rs:127
            let _e29 = PatternSource_next_u32_(source_3);
            continuing {
                let _e30 = counter_7;
                counter_7 = (_e30 + 1u);
            }
        }
    }
    // glimt_sampling/src/resample.rs:130
    let _e35 = (*this_22).teeth;
    (*this_22).made = _e35;
    // glimt_sampling/src/resample.rs:131
    return left_3;
}

// glimt_smc/src/resample.rs:45
fn spread(particles_start_3: u32, particles_len_3: u32) {
    var donor: u32;
    var counter_8: u32;
    var both_1: bool;

    // glimt_smc/src/resample.rs:46
    // glimt_smc/src/resample.rs:47
    donor = 0u;
    // glimt_smc/src/resample.rs:48
    counter_8 = 0u;
    loop {
        let i_5 = counter_8;
        if (i_5 >= particles_len_3) {
            break;
        }
        // glimt_smc/src/resample.rs:49
        let _e17 = particles[(particles_start_3 + i_5)].log_weight;
        if (_e17 == 0f) {
            // glimt_smc/src/resample.rs:50
            loop {
                let _e21 = donor;
                let _e22 = (_e21 < particles_len_3);
                both_1 = _e22;
                if _e22 {
                    let _e24 = donor;
                    let _e29 = particles[(particles_start_3 + _e24)].log_weight;
                    both_1 = (_e29 < 2f);
                }
                let _e32 = both_1;
                if _e32 {
                    // glimt_smc/src/resample.rs:51
                    let _e35 = donor;
                    donor = (_e35 + 1u);
                } else {
                    break;
                }
            }
            // glimt_smc/src/resample.rs:53
            let _e38 = donor;
            if (_e38 == particles_len_3) {
                // glimt_smc/src/resample.rs:54
                return;
            }
            // glimt_smc/src/resample.rs:56
            let _e43 = donor;
            let _e48 = particles[(particles_start_3 + _e43)].log_weight;
            particles[(particles_start_3 + _e43)].log_weight = (_e48 - 1f);
            // glimt_smc/src/resample.rs:57
            let _e51 = donor;
            let _e56 = particles[(particles_start_3 + _e51)].state;
            particles[(particles_start_3 + i_5)].state = _e56;
            // glimt_smc/src/resample.rs:58
            particles[(particles_start_3 + i_5)].log_weight = 1f;
        }
        continuing {
            let _e67 = counter_8;
            counter_8 = (_e67 + 1u);
        }
    }
    return;
}

// glimt_smc/src/weights.rs:7
fn make_equal(particles_start_4: u32, particles_len_4: u32) {
    var counter_9: u32;

    // glimt_smc/src/weights.rs:8
    // glimt_smc/src/weights.rs:9
    let log_weight_1 = -(log(f32(particles_len_4)));
    // glimt_smc/src/weights.rs:10
    counter_9 = 0u;
    loop {
        let i_6 = counter_9;
        if (i_6 >= particles_len_4) {
            break;
        }
        // glimt_smc/src/weights.rs:11
        particles[(particles_start_4 + i_6)].log_weight = log_weight_1;
        continuing {
            let _e18 = counter_9;
            counter_9 = (_e18 + 1u);
        }
    }
    return;
}

// glimt_smc/src/resample.rs:16
fn resample(scheme_2: u32, particles_start_5: u32, particles_len_5: u32, source_4: ptr<function, PatternSource>) {
    var sure_1: u32;
    var counter_10: u32;
    var comb_1: Comb;
    var last: u32;
    var picks_1: u32;
    var counter_11: u32;

    // glimt_smc/src/resample.rs:17
    // glimt_smc/src/resample.rs:18
    let scale = f32(particles_len_5);
    // glimt_smc/src/resample.rs:19
    sure_1 = 0u;
    // glimt_smc/src/resample.rs:20
    counter_10 = 0u;
    loop {
        let i_7 = counter_10;
        if (i_7 >= particles_len_5) {
            break;
        }
        // glimt_smc/src/resample.rs:21
        let _e20 = particles[(particles_start_5 + i_7)];
        let _e21 = Particle_weight(_e20);
        let _e23 = sure_copies(scheme_2, (_e21 * scale));
        let _e24 = sure_1;
        sure_1 = (_e24 + _e23);
        continuing {
            let _e26 = counter_10;
            counter_10 = (_e26 + 1u);
        }
    }
    // glimt_smc/src/resample.rs:23
    let _e30 = sure_1;
    let _e31 = Comb_new(scheme_2, particles_len_5, _e30, source_4);
    comb_1 = _e31;
    // glimt_smc/src/resample.rs:24
    last = particles_len_5;
    // glimt_smc/src/resample.rs:25
    picks_1 = 0u;
    // glimt_smc/src/resample.rs:26
    counter_11 = 0u;
    loop {
        let i_8 = counter_11;
        if (i_8 >= particles_len_5) {
            break;
        }
        // glimt_smc/src/resample.rs:27
        let _e47 = particles[(particles_start_5 + i_8)];
        let _e48 = Particle_weight(_e47);
        // glimt_smc/src/resample.rs:28
        let _e51 = Comb_take((&comb_1), (_e48 * scale), source_4);
        // glimt_smc/src/resample.rs:29
        particles[(particles_start_5 + i_8)].log_weight = f32(_e51);
        // glimt_smc/src/resample.rs:30
        let _e59 = picks_1;
        picks_1 = (_e59 + _e51);
        // glimt_smc/src/resample.rs:31
        if (_e48 > 0f) {
            // glimt_smc/src/resample.rs:32
            last = i_8;
        }
        continuing {
            let _e65 = counter_11;
            counter_11 = (_e65 + 1u);
        }
    }
    // glimt_smc/src/resample.rs:35
    let _e69 = Comb_finish((&comb_1), source_4);
    // glimt_smc/src/resample.rs:36
    let _e71 = last;
    if (_e71 < particles_len_5) {
        // glimt_smc/src/resample.rs:37
        let _e74 = picks_1;
        let _e78 = last;
        let _e83 = particles[(particles_start_5 + _e78)].log_weight;
        particles[(particles_start_5 + _e78)].log_weight = (_e83 + f32((max(particles_len_5, _e74) - _e74)));
        // glimt_smc/src/resample.rs:38
        spread(particles_start_5, particles_len_5);
    }
    // glimt_smc/src/resample.rs:40
    make_equal(particles_start_5, particles_len_5);
    return;
}

// glimt_sampling/src/resample.rs:26
fn words(scheme_3: u32, picks_2: u32) -> u32 {
    var chosen_9: u32;

    // glimt_sampling/src/resample.rs:27
    if (scheme_3 == 0u) {
        // glimt_sampling/src/resample.rs:28
        chosen_9 = 1u;
    } else {
        // glimt_sampling/src/resample.rs:30
        chosen_9 = picks_2;
    }
    let _e10 = chosen_9;
    return _e10;
}

// glimt_sampling/src/resample.rs:36
fn skip(scheme_4: u32, picks_3: u32, source_5: ptr<function, PatternSource>) {
    var counter_12: u32;

    // glimt_sampling/src/resample.rs:37
    let _e6 = words(scheme_4, picks_3);
    counter_12 = 0u;
    loop {
        let _e8 = counter_12;
        if (_e8 >= _e6) {
            break;
        }
        // glimt_sampling/src/resample.rs:38
        let _e11 = PatternSource_next_u32_(source_5);
        continuing {
            let _e12 = counter_12;
            counter_12 = (_e12 + 1u);
        }
    }
    return;
}

// glimt_sampling/src/sobol.rs:191
fn OwenSobol_next_uvec2_(this_23: ptr<function, OwenSobol>) -> vec2<u32> {

    // glimt_sampling/src/sobol.rs:192
    let _e4 = (*this_23).dimension;
    let dimension_4 = ((_e4 + 1u) & 4294967294u);
    // glimt_sampling/src/sobol.rs:193
    (*this_23).dimension = (dimension_4 + 2u);
    // glimt_sampling/src/sobol.rs:194
    let _e15 = (*this_23).seed;
    let _e18 = hash2_(_e15, (dimension_4 >> 2u));
    // glimt_sampling/src/sobol.rs:195
    let _e21 = (*this_23).index;
    let _e22 = shuffle(_e21, _e18);
    // glimt_sampling/src/sobol.rs:196
    let _e24 = sobol_reversed(_e22, dimension_4);
    let _e25 = scramble_1(_e24, dimension_4, _e18);
    let _e28 = sobol_reversed(_e22, (dimension_4 + 1u));
    let _e31 = scramble_1(_e28, (dimension_4 + 1u), _e18);
    return vec2<u32>(_e25, _e31);
}

// glimt_sampling/src/uniform.rs:34
fn Xoshiro128PlusPlus_next_uvec2_(this_24: ptr<function, Xoshiro128PlusPlus>) -> vec2<u32> {

    // glimt_sampling/src/uniform.rs:35
    let _e3 = Xoshiro128PlusPlus_next_u32_(this_24);
    // glimt_sampling/src/uniform.rs:36
    let _e5 = Xoshiro128PlusPlus_next_u32_(this_24);
    // glimt_sampling/src/uniform.rs:37
    return vec2<u32>(_e3, _e5);
}

// glimt_render_gpu/src/kernels/pattern.rs:180
fn PatternSource_next_uvec2_(this_25: ptr<function, PatternSource>) -> vec2<u32> {
    var chosen_10: vec2<u32>;
    var borrowed_2: OwenSobol;
    var borrowed_3: Xoshiro128PlusPlus;

    // glimt_render_gpu/src/kernels/pattern.rs:181
    let _e5 = (*this_25).is_sobol;
    if _e5 {
        // glimt_render_gpu/src/kernels/pattern.rs:182
        let _e9 = (*this_25).point;
        borrowed_2 = _e9;
        let _e10 = OwenSobol_next_uvec2_((&borrowed_2));
        let _e11 = borrowed_2;
        (*this_25).point = _e11;
        chosen_10 = _e10;
    } else {
        // glimt_render_gpu/src/kernels/pattern.rs:184
        let _e15 = (*this_25).generator;
        borrowed_3 = _e15;
        let _e16 = Xoshiro128PlusPlus_next_uvec2_((&borrowed_3));
        let _e17 = borrowed_3;
        (*this_25).generator = _e17;
        chosen_10 = _e16;
    }
    let _e18 = chosen_10;
    return _e18;
}

// glimt_smc/src/proposal.rs:136
fn split_word(word: u32, pmf_first: f32) -> Split {
    var chosen_11: u32;
    var chosen_12: u32;

    // glimt_smc/src/proposal.rs:138
    let edge = u32((clamp(pmf_first, 0f, 1f) * 65536f));
    // glimt_smc/src/proposal.rs:139
    let first_2 = ((word >> 16u) < edge);
    // glimt_smc/src/proposal.rs:140
    if first_2 {
        chosen_11 = edge;
    } else {
        chosen_11 = (65536u - edge);
    }
    let width = chosen_11;
    // glimt_smc/src/proposal.rs:142
    if first_2 {
        // glimt_smc/src/proposal.rs:143
        chosen_12 = word;
    } else {
        // glimt_smc/src/proposal.rs:145
        chosen_12 = (word - (edge << 16u));
    }
    let place = chosen_12;
    // glimt_smc/src/proposal.rs:147
    let width_1 = max(width, 1u);
    // glimt_smc/src/proposal.rs:148
    let upper = (place / width_1);
    // glimt_smc/src/proposal.rs:149
    let lower = (((place % width_1) * 65536u) / width_1);
    // glimt_smc/src/proposal.rs:150
    return Split(first_2, ((upper << 16u) + lower));
}

// glimt_sampling/src/uniform.rs:22
fn unit_vec2_(u_1: vec2<u32>) -> vec2<f32> {

    // glimt_sampling/src/uniform.rs:23
    let _e4 = unit_f32_(u_1.x);
    let _e6 = unit_f32_(u_1.y);
    return vec2<f32>(_e4, _e6);
}

// glimt_sampling/src/warp.rs:182
fn cos_sin_turns(turns: f32) -> vec2<f32> {
    var chosen_13: f32;

    // glimt_sampling/src/warp.rs:183
    if (turns < 0.5f) {
        chosen_13 = turns;
    } else {
        chosen_13 = (turns - 1f);
    }
    let signed = chosen_13;
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

// glimt_sampling/src/math.rs:59
fn ShadingFrame_to_world(this_26: ShadingFrame, v_2: vec3<f32>) -> vec3<f32> {

    // glimt_sampling/src/math.rs:60
    return (((this_26.t * v_2.x) + (this_26.b * v_2.y)) + (this_26.n * v_2.z));
}

// glimt_smc/src/proposal.rs:43
fn CapMove_propose(this_27: CapMove, from_: vec3<f32>, u_3: vec3<u32>) -> Proposed {

    // glimt_smc/src/proposal.rs:44
    let _e6 = unit_vec2_(u_3.xy);
    let _e8 = sample_cap(_e6, this_27.height);
    let local = _e8.direction;
    // glimt_smc/src/proposal.rs:45
    let _e11 = ShadingFrame_from_normal(from_);
    let _e12 = ShadingFrame_to_world(_e11, local);
    return Proposed(normalize(_e12), 1f, 1f);
}

// glimt_render_gpu/src/kernels/environment.rs:131
fn marginal_words(size_5: vec2<u32>) -> u32 {

    // glimt_render_gpu/src/kernels/environment.rs:132
    return (size_5.y + 1u);
}

// glimt_render_gpu/src/kernels/environment.rs:67
fn Environment_cdf(size_6: vec2<u32>, rotation_4: vec2<f32>) -> Returned_Environment_cdf {

    // glimt_render_gpu/src/kernels/environment.rs:68
    let _e3 = marginal_words(size_6);
    return Returned_Environment_cdf(size_6, _e3, (arrayLength((&env_tables)) - _e3));
}

// glimt_envmap_cdf/src/env_cdf.rs:48
fn EnvCdf_is_black(size_7: vec2<u32>, conditional_start: u32, conditional_len: u32) -> bool {

    // glimt_envmap_cdf/src/env_cdf.rs:49
    let _e6 = env_tables[size_7.y];
    return (_e6 == 0u);
}

// glimt_envmap_cdf/src/search.rs:31
fn find_bin(start: u32, bins: u32, u_4: u32) -> Bin {
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
        let _e22 = env_tables[(_e18 + half)];
        if (_e22 <= u_4) {
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
    let first_3 = env_tables[_e31];
    // glimt_envmap_cdf/src/search.rs:43
    let _e36 = at;
    let _e38 = at;
    let _e43 = env_tables[(_e38 + 1u)];
    return Bin((_e36 - start), first_3, (_e43 - first_3));
}

// glimt_envmap_cdf/src/search.rs:31
fn find_bin_1(edges_start: u32, edges_len: u32, start_1: u32, bins_1: u32, u_5: u32) -> Bin {
    var at_1: u32;
    var left_1: u32;

    // glimt_envmap_cdf/src/search.rs:33
    at_1 = start_1;
    // glimt_envmap_cdf/src/search.rs:34
    left_1 = bins_1;
    // glimt_envmap_cdf/src/search.rs:35
    loop {
        let _e10 = left_1;
        if !((_e10 > 1u)) {
            break;
        }
        // glimt_envmap_cdf/src/search.rs:36
        let _e15 = left_1;
        let half_1 = (_e15 / 2u);
        // glimt_envmap_cdf/src/search.rs:37
        let _e19 = at_1;
        let _e24 = env_tables[(edges_start + (_e19 + half_1))];
        if (_e24 <= u_5) {
            // glimt_envmap_cdf/src/search.rs:38
            let _e27 = at_1;
            at_1 = (_e27 + half_1);
        }
        // glimt_envmap_cdf/src/search.rs:40
        let _e30 = left_1;
        left_1 = (_e30 - half_1);
    }
    // glimt_envmap_cdf/src/search.rs:42
    let _e33 = at_1;
    let first_4 = env_tables[(edges_start + _e33)];
    // glimt_envmap_cdf/src/search.rs:43
    let _e39 = at_1;
    let _e41 = at_1;
    let _e47 = env_tables[(edges_start + (_e41 + 1u))];
    return Bin((_e39 - start_1), first_4, (_e47 - first_4));
}

// glimt_envmap_cdf/src/env_cdf.rs:172
fn place_in_bin(bin: Bin, u_6: u32, fraction: u32) -> f32 {

    // glimt_envmap_cdf/src/env_cdf.rs:173
    let below_unit = (f32(fraction) * (1f / 65536f));
    // glimt_envmap_cdf/src/env_cdf.rs:174
    return min(((f32((u_6 - bin.first)) + below_unit) / f32(bin.units)), 0.99999994f);
}

// glimt_probe/src/trig.rs:25
fn cos_sin_pi(x_4: f32) -> vec2<f32> {
    var chosen_14: vec2<f32>;

    // glimt_probe/src/trig.rs:27
    let quarter = floor(((2f * x_4) + 0.5f));
    // glimt_probe/src/trig.rs:28
    let y_1 = (x_4 - (0.5f * quarter));
    // glimt_probe/src/trig.rs:29
    let y2_ = (y_1 * y_1);
    // glimt_probe/src/trig.rs:31
    let c_2 = (1f + (y2_ * (-4.934802f + (y2_ * (4.058712f + (y2_ * (-1.3352627f + (y2_ * (0.23533063f + (y2_ * -0.02580689f))))))))));
    // glimt_probe/src/trig.rs:34
    let s_1 = (y_1 * (3.1415927f + (y2_ * (-5.1677127f + (y2_ * (2.550164f + (y2_ * (-0.5992645f + (y2_ * 0.082145885f)))))))));
    // glimt_probe/src/trig.rs:37
    let _e49 = (i32(quarter) & 3i);
    if (_e49 == 0i) {
        // glimt_probe/src/trig.rs:38
        chosen_14 = vec2<f32>(c_2, (s_1 + 0f));
    } else {
        if (_e49 == 1i) {
            // glimt_probe/src/trig.rs:39
            chosen_14 = vec2<f32>((0f - s_1), c_2);
        } else {
            if (_e49 == 2i) {
                // glimt_probe/src/trig.rs:40
                chosen_14 = vec2<f32>((0f - c_2), (0f - s_1));
            } else {
                // glimt_probe/src/trig.rs:41
                chosen_14 = vec2<f32>((s_1 + 0f), (0f - c_2));
            }
        }
    }
    let _e77 = chosen_14;
    return _e77;
}

// glimt_probe/src/latlong.rs:142
fn direction_in_texel(texel_1: vec2<u32>, size_8: vec2<u32>, r: vec2<f32>) -> vec3<f32> {
    var chosen_15: u32;
    var chosen_16: u32;
    var chosen_17: f32;

    // glimt_probe/src/latlong.rs:143
    let size_17 = max(size_8, vec2(1u));
    // glimt_probe/src/latlong.rs:144
    let row_2 = min(texel_1.y, (size_17.y - 1u));
    // glimt_probe/src/latlong.rs:146
    let southern = ((2u * row_2) >= size_17.y);
    // glimt_probe/src/latlong.rs:147
    if southern {
        chosen_15 = (size_17.y - row_2);
    } else {
        chosen_15 = row_2;
    }
    let upper_1 = chosen_15;
    // glimt_probe/src/latlong.rs:148
    if southern {
        chosen_16 = ((size_17.y - row_2) - 1u);
    } else {
        chosen_16 = (row_2 + 1u);
    }
    let lower_1 = chosen_16;
    // glimt_probe/src/latlong.rs:149
    let half_2 = (0.5f / f32(size_17.y));
    // glimt_probe/src/latlong.rs:150
    let _e41 = cos_sin_pi((f32(upper_1) * half_2));
    let sin_upper = _e41.y;
    // glimt_probe/src/latlong.rs:151
    let _e46 = cos_sin_pi((f32(lower_1) * half_2));
    let sin_lower = _e46.y;
    // glimt_probe/src/latlong.rs:152
    let s_upper = (sin_upper * sin_upper);
    // glimt_probe/src/latlong.rs:153
    let s_2 = (s_upper + (((sin_lower * sin_lower) - s_upper) * r.y));
    // glimt_probe/src/latlong.rs:154
    let sin_theta_1 = (2f * sqrt(max((s_2 * (1f - s_2)), 0f)));
    // glimt_probe/src/latlong.rs:155
    if southern {
        // glimt_probe/src/latlong.rs:156
        chosen_17 = ((2f * s_2) - 1f);
    } else {
        // glimt_probe/src/latlong.rs:158
        chosen_17 = (1f - (2f * s_2));
    }
    let cos_theta_1 = chosen_17;
    // glimt_probe/src/latlong.rs:160
    let _e90 = cos_sin_pi((1f - ((2f * (f32(texel_1.x) + r.x)) / f32(size_17.x))));
    // glimt_probe/src/latlong.rs:161
    return vec3<f32>((sin_theta_1 * _e90.x), (sin_theta_1 * _e90.y), cos_theta_1);
}

// glimt_probe/src/latlong.rs:121
fn texel_solid_angle_sr(row: u32, size_9: vec2<u32>) -> f32 {

    // glimt_probe/src/latlong.rs:122
    let size_18 = max(size_9, vec2(1u));
    // glimt_probe/src/latlong.rs:123
    let row_3 = min(row, (size_18.y - 1u));
    // glimt_probe/src/latlong.rs:124
    let from_pole = min(row_3, ((size_18.y - 1u) - row_3));
    // glimt_probe/src/latlong.rs:125
    let half_row = (0.5f / f32(size_18.y));
    // glimt_probe/src/latlong.rs:126
    let middle = (f32(((2u * from_pole) + 1u)) * half_row);
    // glimt_probe/src/latlong.rs:127
    let _e37 = cos_sin_pi(middle);
    let _e40 = cos_sin_pi(half_row);
    return ((((4f * 3.1415927f) / f32(size_18.x)) * _e37.y) * _e40.y);
}

// glimt_envmap_cdf/src/env_cdf.rs:165
fn density_sr(row_units: u32, column_units: u32, row_1: u32, size_10: vec2<u32>) -> f32 {

    // glimt_envmap_cdf/src/env_cdf.rs:166
    let pmf = ((f32(row_units) * 0.0000000004656613f) * (f32(column_units) * 0.0000000004656613f));
    // glimt_envmap_cdf/src/env_cdf.rs:167
    let _e14 = texel_solid_angle_sr(row_1, size_10);
    return (pmf / _e14);
}

// glimt_envmap_cdf/src/env_cdf.rs:61
fn EnvCdf_sample(size_11: vec2<u32>, conditional_start_1: u32, conditional_len_1: u32, u_7: vec2<u32>) -> EnvSample {

    // glimt_envmap_cdf/src/env_cdf.rs:62
    let _e6 = EnvCdf_is_black(size_11, conditional_start_1, conditional_len_1);
    if _e6 {
        // glimt_envmap_cdf/src/env_cdf.rs:63
        return EnvSample(vec2(0u), vec3<f32>(0f, 0f, 1f), 0f);
    }
    // glimt_envmap_cdf/src/env_cdf.rs:69
    let _e22 = find_bin(0u, size_11.y, (u_7.y >> 1u));
    // glimt_envmap_cdf/src/env_cdf.rs:70
    let row_start = (_e22.index * (size_11.x + 1u));
    // glimt_envmap_cdf/src/env_cdf.rs:71
    let _e34 = find_bin_1(conditional_start_1, conditional_len_1, row_start, size_11.x, (u_7.x >> 1u));
    // glimt_envmap_cdf/src/env_cdf.rs:72
    let texel_5 = vec2<u32>(_e34.index, _e22.index);
    // glimt_envmap_cdf/src/env_cdf.rs:73
    let _e42 = hash2_(u_7.x, u_7.y);
    // glimt_envmap_cdf/src/env_cdf.rs:74
    let _e49 = place_in_bin(_e34, (u_7.x >> 1u), (_e42 & 65535u));
    let _e55 = place_in_bin(_e22, (u_7.y >> 1u), (_e42 >> 16u));
    let place_1 = vec2<f32>(_e49, _e55);
    // glimt_envmap_cdf/src/env_cdf.rs:78
    let _e58 = direction_in_texel(texel_5, size_11, place_1);
    let _e62 = density_sr(_e22.units, _e34.units, _e22.index, size_11);
    return EnvSample(texel_5, _e58, _e62);
}

// glimt_render_gpu/src/kernels/environment.rs:110
fn Environment_sample(size_12: vec2<u32>, rotation_5: vec2<f32>, u_8: vec2<u32>) -> EnvSample {

    // glimt_render_gpu/src/kernels/environment.rs:111
    let _e5 = Environment_cdf(size_12, rotation_5);
    let _e9 = EnvCdf_sample(_e5.value_size, _e5.value_conditional_start, _e5.value_conditional_len, u_8);
    // glimt_render_gpu/src/kernels/environment.rs:112
    let _e12 = rotate_z(_e9.direction, rotation_5);
    return EnvSample(_e9.texel, _e12, _e9.pdf_sr);
}

// glimt_render_gpu/src/kernels/light_target.rs:156
fn LightDraw_sample(light_size_3: vec2<u32>, light_rotation_3: vec2<f32>, u_9: vec3<u32>) -> Sampled {

    // glimt_render_gpu/src/kernels/light_target.rs:157
    let _e8 = Environment_sample(light_size_3, light_rotation_3, vec2<u32>(u_9.x, u_9.y));
    // glimt_render_gpu/src/kernels/light_target.rs:158
    return Sampled(_e8.direction, _e8.pdf_sr);
}

// glimt_envmap_cdf/src/env_cdf.rs:143
fn EnvCdf_row(size_13: vec2<u32>, conditional_start_2: u32, conditional_len_2: u32, texel_2: vec2<u32>) -> Bin {

    // glimt_envmap_cdf/src/env_cdf.rs:144
    let y_2 = texel_2.y;
    // glimt_envmap_cdf/src/env_cdf.rs:145
    let _e8 = env_tables[y_2];
    let _e13 = env_tables[(y_2 + 1u)];
    let _e16 = env_tables[y_2];
    return Bin(texel_2.y, _e8, (_e13 - _e16));
}

// glimt_envmap_cdf/src/env_cdf.rs:153
fn EnvCdf_column(size_14: vec2<u32>, conditional_start_3: u32, conditional_len_3: u32, texel_3: vec2<u32>) -> Bin {

    // glimt_envmap_cdf/src/env_cdf.rs:154
    let x_6 = ((texel_3.y * (size_14.x + 1u)) + texel_3.x);
    // glimt_envmap_cdf/src/env_cdf.rs:155
    let _e17 = env_tables[(conditional_start_3 + x_6)];
    let _e23 = env_tables[(conditional_start_3 + (x_6 + 1u))];
    let _e27 = env_tables[(conditional_start_3 + x_6)];
    return Bin(texel_3.x, _e17, (_e23 - _e27));
}

// glimt_envmap_cdf/src/env_cdf.rs:119
fn EnvCdf_texel_pdf_sr(size_15: vec2<u32>, conditional_start_4: u32, conditional_len_4: u32, texel_4: vec2<u32>) -> f32 {

    // glimt_envmap_cdf/src/env_cdf.rs:120
    let _e6 = EnvCdf_row(size_15, conditional_start_4, conditional_len_4, texel_4);
    // glimt_envmap_cdf/src/env_cdf.rs:121
    let _e8 = EnvCdf_column(size_15, conditional_start_4, conditional_len_4, texel_4);
    // glimt_envmap_cdf/src/env_cdf.rs:122
    let _e13 = density_sr(_e6.units, _e8.units, texel_4.y, size_15);
    return _e13;
}

// glimt_render_gpu/src/kernels/light_target.rs:165
fn LightDraw_pdf(light_size_4: vec2<u32>, light_rotation_4: vec2<f32>, state_3: vec3<f32>) -> f32 {

    // glimt_render_gpu/src/kernels/light_target.rs:166
    let _e5 = Environment_cdf(light_size_4, light_rotation_4);
    let _e9 = Environment_texel(light_size_4, light_rotation_4, state_3);
    let _e10 = EnvCdf_texel_pdf_sr(_e5.value_size, _e5.value_conditional_start, _e5.value_conditional_len, _e9);
    return _e10;
}

// glimt_smc/src/proposal.rs:81
fn Independent_LightDraw_propose(sampler_light_size: vec2<u32>, sampler_light_rotation: vec2<f32>, from_1: vec3<f32>, u_10: vec3<u32>) -> Proposed {

    // glimt_smc/src/proposal.rs:82
    let _e6 = LightDraw_sample(sampler_light_size, sampler_light_rotation, u_10);
    // glimt_smc/src/proposal.rs:83
    let _e10 = LightDraw_pdf(sampler_light_size, sampler_light_rotation, from_1);
    return Proposed(_e6.state, _e6.pdf, _e10);
}

// glimt_brdf/src/blinn_phong.rs:116
fn BlinnPhong_pmf_specular(this_28: BlinnPhong) -> f32 {
    var chosen_18: f32;

    // glimt_brdf/src/blinn_phong.rs:117
    let _e4 = luminance(this_28.specular);
    // glimt_brdf/src/blinn_phong.rs:118
    let _e7 = luminance(this_28.diffuse);
    let both_2 = (_e7 + _e4);
    // glimt_brdf/src/blinn_phong.rs:119
    if (both_2 > 0f) {
        chosen_18 = (_e4 / both_2);
    } else {
        chosen_18 = 0f;
    }
    let _e15 = chosen_18;
    return _e15;
}

// glimt_sampling/src/warp.rs:190
fn height_of(direction_6: vec3<f32>) -> f32 {
    var chosen_19: f32;

    // glimt_sampling/src/warp.rs:191
    if (direction_6.z > 0f) {
        // glimt_sampling/src/warp.rs:192
        chosen_19 = (((direction_6.x * direction_6.x) + (direction_6.y * direction_6.y)) / (1f + direction_6.z));
    } else {
        // glimt_sampling/src/warp.rs:194
        chosen_19 = (1f - direction_6.z);
    }
    let _e23 = chosen_19;
    return _e23;
}

// glimt_sampling/src/warp.rs:201
fn ln_cos_theta(direction_7: vec3<f32>) -> f32 {

    // glimt_sampling/src/warp.rs:202
    let _e3 = height_of(direction_7);
    // glimt_sampling/src/warp.rs:203
    if (_e3 < 0.1f) {
        // glimt_sampling/src/warp.rs:204
        let tail_1 = ((1f / 3f) + (_e3 * (0.25f + (_e3 * (0.2f + (_e3 * ((1f / 6f) + (_e3 / 7f))))))));
        // glimt_sampling/src/warp.rs:205
        return (0f - (_e3 * (1f + (_e3 * (0.5f + (_e3 * tail_1))))));
    }
    // glimt_sampling/src/warp.rs:207
    return log(direction_7.z);
}

// glimt_sampling/src/warp.rs:289
fn pdf_power_cosine_sr(direction_8: vec3<f32>, exponent_3: f32) -> f32 {
    var chosen_20: f32;

    // glimt_sampling/src/warp.rs:290
    let normalisation_1 = ((exponent_3 + 1f) * (0.5f * 0.31830987f));
    // glimt_sampling/src/warp.rs:291
    if (exponent_3 <= 0f) {
        // glimt_sampling/src/warp.rs:292
        if (direction_8.z >= 0f) {
            // glimt_sampling/src/warp.rs:293
            chosen_20 = normalisation_1;
        } else {
            // glimt_sampling/src/warp.rs:295
            chosen_20 = 0f;
        }
        let _e21 = chosen_20;
        return _e21;
    }
    // glimt_sampling/src/warp.rs:298
    if (direction_8.z <= 0f) {
        // glimt_sampling/src/warp.rs:299
        return 0f;
    }
    // glimt_sampling/src/warp.rs:301
    let _e29 = ln_cos_theta(direction_8);
    return (normalisation_1 * exp((exponent_3 * _e29)));
}

// glimt_sampling/src/warp.rs:257
fn sample_power_cosine(u_11: vec2<f32>, exponent_4: f32) -> DirectionSample {
    var sin2_theta_1: f32;
    var cos_theta: f32;

    // glimt_sampling/src/warp.rs:258
    if (u_11.x <= 0f) {
        // glimt_sampling/src/warp.rs:259
        let _e16 = pdf_power_cosine_sr(vec3<f32>(1f, 0f, 0f), exponent_4);
        return DirectionSample(vec3<f32>(1f, 0f, 0f), _e16);
    }
    // glimt_sampling/src/warp.rs:266
    let t_1 = ((2f / (exponent_4 + 1f)) * (0f - log(u_11.x)));
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
    let sin_theta_2 = sqrt(_e76);
    // glimt_sampling/src/warp.rs:278
    let _e80 = cos_sin_turns(u_11.y);
    // glimt_sampling/src/warp.rs:279
    let _e86 = cos_theta;
    let direction_11 = vec3<f32>((sin_theta_2 * _e80.x), (sin_theta_2 * _e80.y), _e86);
    // glimt_sampling/src/warp.rs:280
    let _e89 = pdf_power_cosine_sr(direction_11, exponent_4);
    return DirectionSample(direction_11, _e89);
}

// glimt_sampling/src/warp.rs:31
fn sample_concentric_disk(u_12: vec2<f32>) -> vec2<f32> {

    // glimt_sampling/src/warp.rs:32
    let a_3 = ((2f * u_12.x) - 1f);
    // glimt_sampling/src/warp.rs:33
    let b_2 = ((2f * u_12.y) - 1f);
    // glimt_sampling/src/warp.rs:34
    if ((a_3 == 0f) && (b_2 == 0f)) {
        // glimt_sampling/src/warp.rs:35
        return vec2(0f);
    }
    // glimt_sampling/src/warp.rs:37
    if ((a_3 * a_3) > (b_2 * b_2)) {
        // glimt_sampling/src/warp.rs:38
        let phi_1 = (0.7853982f * (b_2 / a_3));
        // glimt_sampling/src/warp.rs:39
        return vec2<f32>((a_3 * cos(phi_1)), (a_3 * sin(phi_1)));
    }
    // glimt_sampling/src/warp.rs:41
    let phi_2 = (0.7853982f * (a_3 / b_2));
    // glimt_sampling/src/warp.rs:42
    return vec2<f32>((b_2 * sin(phi_2)), (b_2 * cos(phi_2)));
}

// glimt_sampling/src/warp.rs:88
fn sample_cosine_hemisphere(u_13: vec2<f32>) -> DirectionSample {

    // glimt_sampling/src/warp.rs:89
    let _e3 = sample_concentric_disk(u_13);
    // glimt_sampling/src/warp.rs:92
    let _e10 = abs(((2f * u_13) - vec2(1f)));
    let r_1 = max(_e10.x, _e10.y);
    // glimt_sampling/src/warp.rs:93
    let z_2 = sqrt(((1f - r_1) * (1f + r_1)));
    // glimt_sampling/src/warp.rs:94
    return DirectionSample(vec3<f32>(_e3, z_2), (z_2 * 0.31830987f));
}

// glimt_sampling/src/warp.rs:103
fn pdf_cosine_hemisphere_sr(direction_9: vec3<f32>) -> f32 {

    // glimt_sampling/src/warp.rs:104
    return (max(direction_9.z, 0f) * 0.31830987f);
}

// glimt_brdf/src/lobe.rs:37
fn HalfVector_pdf_sr(this_29: HalfVector, exponent_5: f32) -> f32 {

    // glimt_brdf/src/lobe.rs:38
    let _e10 = HalfVector_lobe(this_29, exponent_5);
    return ((((exponent_5 + 1f) * (0.5f * 0.31830987f)) * _e10) / (4f * this_29.wo_dot_h));
}

// glimt_brdf/src/blinn_phong.rs:99
fn BlinnPhong_pdf_sr(this_30: BlinnPhong, wo_2: vec3<f32>, wi_2: vec3<f32>) -> f32 {

    // glimt_brdf/src/blinn_phong.rs:100
    if ((wo_2.z <= 0f) || (wi_2.z <= 0f)) {
        // glimt_brdf/src/blinn_phong.rs:101
        return 0f;
    }
    // glimt_brdf/src/blinn_phong.rs:103
    let _e15 = pdf_cosine_hemisphere_sr(wi_2);
    // glimt_brdf/src/blinn_phong.rs:104
    let _e17 = BlinnPhong_pmf_specular(this_30);
    // glimt_brdf/src/blinn_phong.rs:105
    if (_e17 <= 0f) {
        // glimt_brdf/src/blinn_phong.rs:106
        return _e15;
    }
    // glimt_brdf/src/blinn_phong.rs:108
    let _e23 = HalfVector_new(wo_2, wi_2);
    let _e25 = HalfVector_pdf_sr(_e23, this_30.exponent);
    // glimt_brdf/src/blinn_phong.rs:109
    return ((_e17 * _e25) + ((1f - _e17) * _e15));
}

// glimt_brdf/src/blinn_phong.rs:80
fn BlinnPhong_sample(this_31: BlinnPhong, wo_3: vec3<f32>, u_lobe: u32, u_14: vec2<f32>) -> BrdfSample {
    var chosen_21: vec3<f32>;

    // glimt_brdf/src/blinn_phong.rs:81
    let _e7 = unit_f32_(u_lobe);
    let _e8 = BlinnPhong_pmf_specular(this_31);
    if (_e7 < _e8) {
        // glimt_brdf/src/blinn_phong.rs:82
        let _e12 = sample_power_cosine(u_14, this_31.exponent);
        let h_1 = _e12.direction;
        // glimt_brdf/src/blinn_phong.rs:83
        chosen_21 = (((2f * dot(wo_3, h_1)) * h_1) - wo_3);
    } else {
        // glimt_brdf/src/blinn_phong.rs:85
        let _e21 = sample_cosine_hemisphere(u_14);
        chosen_21 = _e21.direction;
    }
    let wi_4 = chosen_21;
    // glimt_brdf/src/blinn_phong.rs:87
    let _e25 = BlinnPhong_pdf_sr(this_31, wo_3, wi_4);
    return BrdfSample(wi_4, _e25);
}

// glimt_render_gpu/src/kernels/light_target.rs:133
fn BrdfDraw_sample(this_32: BrdfDraw, u_15: vec3<u32>) -> Sampled {

    // glimt_render_gpu/src/kernels/light_target.rs:134
    let _e8 = unit_vec2_(u_15.xy);
    let _e9 = BlinnPhong_sample(this_32.brdf, this_32.wo, u_15.z, _e8);
    // glimt_render_gpu/src/kernels/light_target.rs:135
    let _e13 = ShadingFrame_to_world(this_32.frame, _e9.wi);
    return Sampled(_e13, _e9.pdf_sr);
}

// glimt_render_gpu/src/kernels/light_target.rs:142
fn BrdfDraw_pdf(this_33: BrdfDraw, state_4: vec3<f32>) -> f32 {

    // glimt_render_gpu/src/kernels/light_target.rs:143
    let _e7 = ShadingFrame_to_local(this_33.frame, state_4);
    let _e8 = BlinnPhong_pdf_sr(this_33.brdf, this_33.wo, _e7);
    return _e8;
}

// glimt_smc/src/proposal.rs:81
fn Independent_BrdfDraw_propose(this_34: Independent_BrdfDraw, from_2: vec3<f32>, u_16: vec3<u32>) -> Proposed {

    // glimt_smc/src/proposal.rs:82
    let _e6 = BrdfDraw_sample(this_34.sampler, u_16);
    // glimt_smc/src/proposal.rs:83
    let _e11 = BrdfDraw_pdf(this_34.sampler, from_2);
    return Proposed(_e6.state, _e6.pdf, _e11);
}

// glimt_smc/src/proposal.rs:106
fn Mixture_Independent_LightDraw_Independent_BrdfDraw_propose(pmf_first_1: f32, first_sampler_light_size: vec2<u32>, first_sampler_light_rotation: vec2<f32>, second: Independent_BrdfDraw, from_3: vec3<f32>, u_17: vec3<u32>) -> Proposed {
    var chosen_22: Proposed;

    // glimt_smc/src/proposal.rs:107
    let _e9 = split_word(u_17.z, pmf_first_1);
    // glimt_smc/src/proposal.rs:108
    let rest_1 = vec3<u32>(u_17.x, u_17.y, _e9.word);
    // glimt_smc/src/proposal.rs:109
    if _e9.first {
        // glimt_smc/src/proposal.rs:110
        let _e19 = Independent_LightDraw_propose(first_sampler_light_size, first_sampler_light_rotation, from_3, rest_1);
        chosen_22 = _e19;
    } else {
        // glimt_smc/src/proposal.rs:112
        let _e21 = Independent_BrdfDraw_propose(second, from_3, rest_1);
        chosen_22 = _e21;
    }
    let _e22 = chosen_22;
    return _e22;
}

// glimt_smc/src/proposal.rs:106
fn Mixture_CapMove_Mixture_Independent_LightDraw_Independent_BrdfDraw_propose(pmf_first_2: f32, first: CapMove, second_pmf_first: f32, second_first_sampler_light_size: vec2<u32>, second_first_sampler_light_rotation: vec2<f32>, second_second: Independent_BrdfDraw, from_4: vec3<f32>, u_18: vec3<u32>) -> Proposed {
    var chosen_23: Proposed;

    // glimt_smc/src/proposal.rs:107
    let _e11 = split_word(u_18.z, pmf_first_2);
    // glimt_smc/src/proposal.rs:108
    let rest_2 = vec3<u32>(u_18.x, u_18.y, _e11.word);
    // glimt_smc/src/proposal.rs:109
    if _e11.first {
        // glimt_smc/src/proposal.rs:110
        let _e21 = CapMove_propose(first, from_4, rest_2);
        chosen_23 = _e21;
    } else {
        // glimt_smc/src/proposal.rs:112
        let _e23 = Mixture_Independent_LightDraw_Independent_BrdfDraw_propose(second_pmf_first, second_first_sampler_light_size, second_first_sampler_light_rotation, second_second, from_4, rest_2);
        chosen_23 = _e23;
    }
    let _e24 = chosen_23;
    return _e24;
}

// glimt_smc/src/metropolis.rs:25
fn accept(u_19: f32, density: f32, forward: f32, proposed_density: f32, backward: f32) -> bool {

    // glimt_smc/src/metropolis.rs:26
    return ((forward > 0f) && ((u_19 * (density * forward)) < (proposed_density * backward)));
}

// glimt_smc/src/metropolis.rs:32
fn metropolis(k_2: u32, bridge_1: Bridge, target_previous_light_size_1: vec2<u32>, target_previous_light_rotation_1: vec2<f32>, target_previous_floor_1: f32, target_previous_lobe_1: LightLobe, target_light_size_1: vec2<u32>, target_light_rotation_1: vec2<f32>, target_floor_1: f32, target_lobe_1: LightLobe, proposal_pmf_first: f32, proposal_first: CapMove, proposal_second_pmf_first: f32, proposal_second_first_sampler_light_size: vec2<u32>, proposal_second_first_sampler_light_rotation: vec2<f32>, proposal_second_second: Independent_BrdfDraw, particle: ptr<function, Particle>, u_20: vec4<u32>) -> bool {

    // glimt_smc/src/metropolis.rs:40
    let _e21 = (*particle).state;
    let _e23 = Mixture_CapMove_Mixture_Independent_LightDraw_Independent_BrdfDraw_propose(proposal_pmf_first, proposal_first, proposal_second_pmf_first, proposal_second_first_sampler_light_size, proposal_second_first_sampler_light_rotation, proposal_second_second, _e21, u_20.xyz);
    // glimt_smc/src/metropolis.rs:41
    let _e26 = (*particle).state;
    let _e27 = LightTarget_densities(target_previous_light_size_1, target_previous_light_rotation_1, target_previous_floor_1, target_previous_lobe_1, target_light_size_1, target_light_rotation_1, target_floor_1, target_lobe_1, _e26);
    let _e28 = Bridge_density(bridge_1, k_2, _e27);
    // glimt_smc/src/metropolis.rs:42
    let _e31 = LightTarget_densities(target_previous_light_size_1, target_previous_light_rotation_1, target_previous_floor_1, target_previous_lobe_1, target_light_size_1, target_light_rotation_1, target_floor_1, target_lobe_1, _e23.state);
    let _e32 = Bridge_density(bridge_1, k_2, _e31);
    // glimt_smc/src/metropolis.rs:43
    let _e35 = unit_f32_(u_20.w);
    let _e38 = accept(_e35, _e28, _e23.forward, _e32, _e23.backward);
    // glimt_smc/src/metropolis.rs:50
    if _e38 {
        // glimt_smc/src/metropolis.rs:51
        (*particle).state = _e23.state;
    }
    // glimt_smc/src/metropolis.rs:53
    return _e38;
}

// glimt_smc/src/sampler.rs:47
fn Sampler_step(this_35: Sampler, k_3: u32, target_previous_light_size_2: vec2<u32>, target_previous_light_rotation_2: vec2<f32>, target_previous_floor_2: f32, target_previous_lobe_2: LightLobe, target_light_size_2: vec2<u32>, target_light_rotation_2: vec2<f32>, target_floor_2: f32, target_lobe_2: LightLobe, proposal_pmf_first_1: f32, proposal_first_1: CapMove, proposal_second_pmf_first_1: f32, proposal_second_first_sampler_light_size_1: vec2<u32>, proposal_second_first_sampler_light_rotation_1: vec2<f32>, proposal_second_second_1: Independent_BrdfDraw, particles_start_6: u32, particles_len_6: u32, source_6: ptr<function, PatternSource>) -> Report {
    var accepted: u32;
    var counter_13: u32;
    var borrowed_4: Particle;
    var chosen_24: u32;

    // glimt_smc/src/sampler.rs:55
    // glimt_smc/src/sampler.rs:56
    let _e23 = reweight(k_3, this_35.bridge, target_previous_light_size_2, target_previous_light_rotation_2, target_previous_floor_2, target_previous_lobe_2, target_light_size_2, target_light_rotation_2, target_floor_2, target_lobe_2, particles_start_6, particles_len_6);
    // glimt_smc/src/sampler.rs:57
    let _e25 = ess(particles_start_6, particles_len_6);
    // glimt_smc/src/sampler.rs:58
    let resampled = ((_e25 < (this_35.ess_threshold * f32(particles_len_6))) && (_e25 > 0f));
    // glimt_smc/src/sampler.rs:59
    if resampled {
        // glimt_smc/src/sampler.rs:60
        resample(this_35.scheme, particles_start_6, particles_len_6, source_6);
    } else {
        // glimt_smc/src/sampler.rs:62
        skip(this_35.scheme, particles_len_6, source_6);
    }
    // glimt_smc/src/sampler.rs:64
    accepted = 0u;
    // glimt_smc/src/sampler.rs:65
    counter_13 = 0u;
    loop {
        let i_9 = counter_13;
        if (i_9 >= particles_len_6) {
            break;
        }
        // glimt_smc/src/sampler.rs:66
        let _e48 = PatternSource_next_uvec2_(source_6);
        // glimt_smc/src/sampler.rs:67
        let _e50 = PatternSource_next_u32_(source_6);
        // glimt_smc/src/sampler.rs:68
        let _e52 = PatternSource_next_u32_(source_6);
        // glimt_smc/src/sampler.rs:69
        let u_23 = vec4<u32>(_e48.x, _e48.y, _e50, _e52);
        // glimt_smc/src/sampler.rs:70
        let _e63 = particles[(particles_start_6 + i_9)];
        borrowed_4 = _e63;
        let _e64 = metropolis(k_3, this_35.bridge, target_previous_light_size_2, target_previous_light_rotation_2, target_previous_floor_2, target_previous_lobe_2, target_light_size_2, target_light_rotation_2, target_floor_2, target_lobe_2, proposal_pmf_first_1, proposal_first_1, proposal_second_pmf_first_1, proposal_second_first_sampler_light_size_1, proposal_second_first_sampler_light_rotation_1, proposal_second_second_1, (&borrowed_4), u_23);
        let _e65 = borrowed_4;
        particles[(particles_start_6 + i_9)] = _e65;
        if _e64 {
            // glimt_smc/src/sampler.rs:71
            let _e68 = accepted;
            accepted = (_e68 + 1u);
        }
        continuing {
            let _e70 = counter_13;
            counter_13 = (_e70 + 1u);
        }
    }
    // glimt_smc/src/sampler.rs:74
    if resampled {
        // glimt_smc/src/sampler.rs:77
        chosen_24 = 1u;
    } else {
        chosen_24 = 0u;
    }
    let _e78 = chosen_24;
    let _e79 = accepted;
    return Report(_e23, _e25, _e78, _e79);
}

// glimt_smc/src/sampler.rs:85
fn Sampler_advance(this_36: Sampler, target_previous_light_size_3: vec2<u32>, target_previous_light_rotation_3: vec2<f32>, target_previous_floor_3: f32, target_previous_lobe_3: LightLobe, target_light_size_3: vec2<u32>, target_light_rotation_3: vec2<f32>, target_floor_3: f32, target_lobe_3: LightLobe, proposal_pmf_first_2: f32, proposal_first_2: CapMove, proposal_second_pmf_first_2: f32, proposal_second_first_sampler_light_size_2: vec2<u32>, proposal_second_first_sampler_light_rotation_2: vec2<f32>, proposal_second_second_2: Independent_BrdfDraw, particles_start_7: u32, particles_len_7: u32, source_7: ptr<function, PatternSource>) -> Report {
    var frame_2: Report;
    var counter_14: u32;
    var chosen_25: f32;
    var either: bool;

    // glimt_smc/src/sampler.rs:92
    frame_2 = Report(0f, f32(particles_len_7), 0u, 0u);
    // glimt_smc/src/sampler.rs:98
    let _e29 = Bridge_steps(this_36.bridge);
    counter_14 = 1u;
    loop {
        let k_4 = counter_14;
        if (k_4 >= (_e29 + 1u)) {
            break;
        }
        // glimt_smc/src/sampler.rs:99
        let _e36 = Sampler_step(this_36, k_4, target_previous_light_size_3, target_previous_light_rotation_3, target_previous_floor_3, target_previous_lobe_3, target_light_size_3, target_light_rotation_3, target_floor_3, target_lobe_3, proposal_pmf_first_2, proposal_first_2, proposal_second_pmf_first_2, proposal_second_first_sampler_light_size_2, proposal_second_first_sampler_light_rotation_2, proposal_second_second_2, particles_start_7, particles_len_7, source_7);
        // glimt_smc/src/sampler.rs:100
        let _e40 = is_log_zero(_e36.log_ratio);
        either = _e40;
        if _e40 {
        } else {
            let _e43 = frame_2.log_ratio;
            let _e44 = is_log_zero(_e43);
            either = _e44;
        }
        let _e45 = either;
        if _e45 {
            // glimt_smc/src/sampler.rs:101
            chosen_25 = -1000000000000000000000000000000f;
        } else {
            // glimt_smc/src/sampler.rs:103
            let _e50 = frame_2.log_ratio;
            chosen_25 = (_e50 + _e36.log_ratio);
        }
        let _e53 = chosen_25;
        frame_2.log_ratio = _e53;
        // glimt_smc/src/sampler.rs:105
        let _e57 = frame_2.ess;
        frame_2.ess = min(_e57, _e36.ess);
        // glimt_smc/src/sampler.rs:106
        let _e64 = frame_2.resampled;
        frame_2.resampled = (_e64 + _e36.resampled);
        // glimt_smc/src/sampler.rs:107
        let _e69 = frame_2.accepted;
        frame_2.accepted = (_e69 + _e36.accepted);
        continuing {
            let _e71 = counter_14;
            counter_14 = (_e71 + 1u);
        }
    }
    // glimt_smc/src/sampler.rs:109
    let _e75 = frame_2;
    return _e75;
}

// glimt_render_gpu/src/kernels/smc.rs:110
fn SmcParams_advance(this_37: SmcParams, target_previous_light_size_4: vec2<u32>, target_previous_light_rotation_4: vec2<f32>, target_previous_floor_4: f32, target_previous_lobe_4: LightLobe, target_light_size_4: vec2<u32>, target_light_rotation_4: vec2<f32>, target_floor_4: f32, target_lobe_4: LightLobe, point_1: ShadingPoint, particles_start_8: u32, particles_len_8: u32, source_8: ptr<function, PatternSource>) -> Report {

    // glimt_render_gpu/src/kernels/smc.rs:117
    // glimt_render_gpu/src/kernels/smc.rs:138
    let _e25 = SmcParams_sampler(this_37);
    let _e26 = Sampler_advance(_e25, target_previous_light_size_4, target_previous_light_rotation_4, target_previous_floor_4, target_previous_lobe_4, target_light_size_4, target_light_rotation_4, target_floor_4, target_lobe_4, this_37.cap_share, CapMove(this_37.cap_height), this_37.light_share, target_light_size_4, target_light_rotation_4, Independent_BrdfDraw(BrdfDraw(point_1.frame, point_1.wo, point_1.brdf)), particles_start_8, particles_len_8, source_8);
    return _e26;
}

// glimt_sampling/src/ris.rs:61
fn RisSum_new() -> RisSum {

    // glimt_sampling/src/ris.rs:62
    return RisSum(0f, 0u, 0u);
}

// glimt_render_gpu/src/kernels/candidates.rs:65
fn Candidates_of_brdf(this_38: Candidates) -> u32 {
    var chosen_26: u32;
    var chosen_27: u32;

    // glimt_render_gpu/src/kernels/candidates.rs:66
    if (this_38.source == 0u) {
        // glimt_render_gpu/src/kernels/candidates.rs:67
        chosen_26 = this_38.count;
    } else {
        if (this_38.source == 1u) {
            // glimt_render_gpu/src/kernels/candidates.rs:69
            chosen_27 = 0u;
        } else {
            // glimt_render_gpu/src/kernels/candidates.rs:71
            let _e18 = (this_38.count / 2u);
            chosen_27 = select(_e18, (_e18 + 1u), ((this_38.count % 2u) != 0u));
        }
        let _e25 = chosen_27;
        chosen_26 = _e25;
    }
    let _e26 = chosen_26;
    return _e26;
}

// glimt_render_gpu/src/kernels/pattern.rs:116
fn PixelPattern_point_triple(this_39: PixelPattern, purpose_4: u32, index_9: u32) -> vec3<u32> {
    var point_2: OwenSobol;
    var generator: Xoshiro128PlusPlus;

    // glimt_render_gpu/src/kernels/pattern.rs:117
    if (this_39.kind == 0u) {
        // glimt_render_gpu/src/kernels/pattern.rs:118
        let _e9 = PixelPattern_sobol_point(this_39, purpose_4, index_9);
        point_2 = _e9;
        // glimt_render_gpu/src/kernels/pattern.rs:119
        let _e12 = OwenSobol_next_uvec2_((&point_2));
        // glimt_render_gpu/src/kernels/pattern.rs:120
        let _e14 = OwenSobol_next_u32_((&point_2));
        return vec3<u32>(_e12, _e14);
    }
    // glimt_render_gpu/src/kernels/pattern.rs:122
    let _e17 = PixelPattern_generator(this_39, purpose_4, index_9);
    generator = _e17;
    // glimt_render_gpu/src/kernels/pattern.rs:123
    let _e20 = Xoshiro128PlusPlus_next_uvec2_((&generator));
    // glimt_render_gpu/src/kernels/pattern.rs:124
    let _e22 = Xoshiro128PlusPlus_next_u32_((&generator));
    return vec3<u32>(_e20, _e22);
}

// glimt_render_gpu/src/kernels/pattern.rs:146
fn PixelPattern_key(this_40: PixelPattern, purpose_5: u32) -> u32 {

    // glimt_render_gpu/src/kernels/pattern.rs:147
    let _e5 = hash2_(this_40.seed, purpose_5);
    let _e8 = hash3_(_e5, this_40.frame, this_40.pixel);
    return _e8;
}

// glimt_render_gpu/src/kernels/pattern.rs:221
fn permute(index_10: u32, length_: u32, key: u32) -> u32 {
    var x_5: u32;
    var round_key: u32;
    var counter_15: i32;

    // glimt_render_gpu/src/kernels/pattern.rs:222
    if (length_ <= 1u) {
        // glimt_render_gpu/src/kernels/pattern.rs:223
        return 0u;
    }
    // glimt_render_gpu/src/kernels/pattern.rs:225
    let bits_2 = (32u - countLeadingZeros((length_ - 1u)));
    // glimt_render_gpu/src/kernels/pattern.rs:226
    let mask = (4294967295u >> ((32u - bits_2) & 31u));
    // glimt_render_gpu/src/kernels/pattern.rs:227
    x_5 = index_10;
    // glimt_render_gpu/src/kernels/pattern.rs:228
    loop {
        // glimt_render_gpu/src/kernels/pattern.rs:229
        round_key = key;
        // glimt_render_gpu/src/kernels/pattern.rs:230
        counter_15 = 0i;
        loop {
            let _e31 = counter_15;
            if (_e31 >= 3i) {
                break;
            }
            // glimt_render_gpu/src/kernels/pattern.rs:231
            let _e34 = round_key;
            let _e35 = hash_u32_(_e34);
            round_key = _e35;
            // glimt_render_gpu/src/kernels/pattern.rs:233
            let _e37 = x_5;
            let _e38 = round_key;
            x_5 = (((_e37 ^ _e38) * 2654435761u) & mask);
            // glimt_render_gpu/src/kernels/pattern.rs:234
            let _e44 = x_5;
            let _e46 = (bits_2 / 2u);
            let _e56 = x_5;
            x_5 = (_e56 ^ (_e44 >> (select(_e46, (_e46 + 1u), ((bits_2 % 2u) != 0u)) & 31u)));
            continuing {
                let _e58 = counter_15;
                counter_15 = (_e58 + 1i);
            }
        }
        // glimt_render_gpu/src/kernels/pattern.rs:236
        let _e62 = x_5;
        if (_e62 < length_) {
            // glimt_render_gpu/src/kernels/pattern.rs:237
            let _e65 = x_5;
            let _e67 = hash_u32_(~(key));
            return ((_e65 + (_e67 % length_)) % length_);
        }
    }
    return u32();
}

// glimt_render_gpu/src/kernels/pattern.rs:212
fn stratum(cell: u32, count: u32, jitter: u32) -> u32 {

    // glimt_render_gpu/src/kernels/pattern.rs:213
    return ((cell * (4294967295u / count)) + (jitter / count));
}

// glimt_render_gpu/src/kernels/pattern.rs:192
fn jittered_pair(index_11: u32, count_1: u32, jitter_1: vec2<u32>, key_1: u32) -> vec2<u32> {

    // glimt_render_gpu/src/kernels/pattern.rs:193
    let columns = max(u32(sqrt(f32(count_1))), 1u);
    // glimt_render_gpu/src/kernels/pattern.rs:194
    let _e12 = (count_1 / columns);
    let rows = select(_e12, (_e12 + 1u), ((count_1 % columns) != 0u));
    // glimt_render_gpu/src/kernels/pattern.rs:195
    let _e21 = hash2_(key_1, 1u);
    let _e22 = permute(index_11, count_1, _e21);
    // glimt_render_gpu/src/kernels/pattern.rs:196
    let _e26 = hash2_(key_1, 2u);
    let _e27 = permute((_e22 % columns), columns, _e26);
    // glimt_render_gpu/src/kernels/pattern.rs:197
    let _e31 = hash2_(key_1, 3u);
    let _e32 = permute((_e22 / columns), rows, _e31);
    // glimt_render_gpu/src/kernels/pattern.rs:198
    let _e38 = stratum(((_e27 * rows) + _e32), (columns * rows), jitter_1.x);
    let _e40 = stratum(_e22, count_1, jitter_1.y);
    return vec2<u32>(_e38, _e40);
}

// glimt_render_gpu/src/kernels/pattern.rs:206
fn jittered(index_12: u32, count_2: u32, jitter_2: u32, key_2: u32) -> u32 {

    // glimt_render_gpu/src/kernels/pattern.rs:207
    let _e7 = hash2_(key_2, 4u);
    let _e8 = permute(index_12, count_2, _e7);
    let _e9 = stratum(_e8, count_2, jitter_2);
    return _e9;
}

// glimt_render_gpu/src/kernels/pattern.rs:82
fn PixelPattern_triple(this_41: PixelPattern, purpose_6: u32, sample: u32, samples: u32) -> vec3<u32> {

    // glimt_render_gpu/src/kernels/pattern.rs:83
    let index_15 = ((this_41.ray * samples) + sample);
    // glimt_render_gpu/src/kernels/pattern.rs:84
    let _e10 = PixelPattern_point_triple(this_41, purpose_6, index_15);
    // glimt_render_gpu/src/kernels/pattern.rs:85
    if (this_41.kind != 2u) {
        // glimt_render_gpu/src/kernels/pattern.rs:86
        return _e10;
    }
    // glimt_render_gpu/src/kernels/pattern.rs:88
    let _e19 = Tuple_UVec2_u32_(_e10.xy, _e10.z);
    let jitter_3 = _e19.fa;
    let single = _e19.fb;
    // glimt_render_gpu/src/kernels/pattern.rs:89
    let _e25 = PixelPattern_key(this_41, purpose_6);
    let _e26 = Tuple_u32_u32_((this_41.rays * samples), _e25);
    let count_3 = _e26.fa;
    let key_3 = _e26.fb;
    // glimt_render_gpu/src/kernels/pattern.rs:90
    let _e30 = jittered_pair(index_15, count_3, jitter_3, key_3);
    let _e31 = jittered(index_15, count_3, single, key_3);
    return vec3<u32>(_e30, _e31);
}

// glimt_render_gpu/src/kernels/pattern.rs:67
fn PixelPattern_pair(this_42: PixelPattern, purpose_7: u32, sample_1: u32, samples_1: u32) -> vec2<u32> {
    var borrowed_5: OwenSobol;
    var borrowed_6: Xoshiro128PlusPlus;

    // glimt_render_gpu/src/kernels/pattern.rs:68
    let index_16 = ((this_42.ray * samples_1) + sample_1);
    // glimt_render_gpu/src/kernels/pattern.rs:69
    if (this_42.kind == 0u) {
        // glimt_render_gpu/src/kernels/pattern.rs:70
        let _e14 = PixelPattern_sobol_point(this_42, purpose_7, index_16);
        borrowed_5 = _e14;
        let _e16 = OwenSobol_next_uvec2_((&borrowed_5));
        return _e16;
    }
    // glimt_render_gpu/src/kernels/pattern.rs:72
    let _e18 = PixelPattern_generator(this_42, purpose_7, index_16);
    borrowed_6 = _e18;
    let _e20 = Xoshiro128PlusPlus_next_uvec2_((&borrowed_6));
    // glimt_render_gpu/src/kernels/pattern.rs:73
    if (this_42.kind == 1u) {
        // glimt_render_gpu/src/kernels/pattern.rs:74
        return _e20;
    }
    // glimt_render_gpu/src/kernels/pattern.rs:76
    let _e29 = PixelPattern_key(this_42, purpose_7);
    let _e30 = jittered_pair(index_16, (this_42.rays * samples_1), _e20, _e29);
    return _e30;
}

// glimt_render_gpu/src/kernels/candidates.rs:78
fn Candidates_draw(this_43: Candidates, index_13: u32, point_3: ShadingPoint, pattern_1: PixelPattern, env_size: vec2<u32>, env_rotation: vec2<f32>) -> Candidate {
    var density_1: f32;
    var direction_10: vec3<f32>;
    var wi_3: vec3<f32>;
    var radiance: vec3<f32>;

    // glimt_render_gpu/src/kernels/candidates.rs:85
    let _e8 = Candidates_of_brdf(this_43);
    // glimt_render_gpu/src/kernels/candidates.rs:86
    let of_env = (this_43.count - _e8);
    // glimt_render_gpu/src/kernels/candidates.rs:88
    density_1 = 0f;
    // glimt_render_gpu/src/kernels/candidates.rs:92
    if (index_13 < _e8) {
        // glimt_render_gpu/src/kernels/candidates.rs:93
        let _e22 = PixelPattern_triple(pattern_1, 4u, index_13, _e8);
        // glimt_render_gpu/src/kernels/candidates.rs:94
        let _e28 = unit_vec2_(_e22.xy);
        let _e29 = BlinnPhong_sample(point_3.brdf, point_3.wo, _e22.z, _e28);
        // glimt_render_gpu/src/kernels/candidates.rs:95
        if !((_e29.pdf_sr > 0f)) {
            // glimt_render_gpu/src/kernels/candidates.rs:96
            return Candidate(vec3<f32>(0f, 0f, 1f), vec3<f32>(0f, 0f, 1f), vec3(0f), 0f, 0f);
        }
        // glimt_render_gpu/src/kernels/candidates.rs:98
        wi_3 = _e29.wi;
        // glimt_render_gpu/src/kernels/candidates.rs:99
        let _e53 = wi_3;
        let _e54 = ShadingFrame_to_world(point_3.frame, _e53);
        direction_10 = _e54;
        // glimt_render_gpu/src/kernels/candidates.rs:100
        let _e56 = direction_10;
        let _e57 = Environment_texel(env_size, env_rotation, _e56);
        // glimt_render_gpu/src/kernels/candidates.rs:101
        let _e59 = Environment_radiance(env_size, env_rotation, _e57);
        radiance = _e59;
        // glimt_render_gpu/src/kernels/candidates.rs:102
        let _e64 = density_1;
        density_1 = (_e64 + (f32(_e8) * _e29.pdf_sr));
        // glimt_render_gpu/src/kernels/candidates.rs:103
        if (of_env > 0u) {
            // glimt_render_gpu/src/kernels/candidates.rs:104
            let _e71 = Environment_cdf(env_size, env_rotation);
            let _e75 = EnvCdf_texel_pdf_sr(_e71.value_size, _e71.value_conditional_start, _e71.value_conditional_len, _e57);
            let _e77 = density_1;
            density_1 = (_e77 + (f32(of_env) * _e75));
        }
    } else {
        // glimt_render_gpu/src/kernels/candidates.rs:107
        let _e82 = PixelPattern_pair(pattern_1, 5u, (index_13 - _e8), of_env);
        // glimt_render_gpu/src/kernels/candidates.rs:108
        let _e84 = Environment_sample(env_size, env_rotation, _e82);
        // glimt_render_gpu/src/kernels/candidates.rs:109
        if !((_e84.pdf_sr > 0f)) {
            // glimt_render_gpu/src/kernels/candidates.rs:110
            return Candidate(vec3<f32>(0f, 0f, 1f), vec3<f32>(0f, 0f, 1f), vec3(0f), 0f, 0f);
        }
        // glimt_render_gpu/src/kernels/candidates.rs:112
        direction_10 = _e84.direction;
        // glimt_render_gpu/src/kernels/candidates.rs:113
        let _e108 = direction_10;
        let _e109 = ShadingFrame_to_local(point_3.frame, _e108);
        wi_3 = _e109;
        // glimt_render_gpu/src/kernels/candidates.rs:114
        let _e112 = Environment_radiance(env_size, env_rotation, _e84.texel);
        radiance = _e112;
        // glimt_render_gpu/src/kernels/candidates.rs:115
        let _e117 = density_1;
        density_1 = (_e117 + (f32(of_env) * _e84.pdf_sr));
        // glimt_render_gpu/src/kernels/candidates.rs:116
        if (_e8 > 0u) {
            // glimt_render_gpu/src/kernels/candidates.rs:117
            let _e126 = wi_3;
            let _e127 = BlinnPhong_pdf_sr(point_3.brdf, point_3.wo, _e126);
            let _e129 = density_1;
            density_1 = (_e129 + (f32(_e8) * _e127));
        }
    }
    // glimt_render_gpu/src/kernels/candidates.rs:120
    let _e133 = wi_3.z;
    if !((_e133 > 0f)) {
        // glimt_render_gpu/src/kernels/candidates.rs:121
        return Candidate(vec3<f32>(0f, 0f, 1f), vec3<f32>(0f, 0f, 1f), vec3(0f), 0f, 0f);
    }
    // glimt_render_gpu/src/kernels/candidates.rs:123
    let _e154 = wi_3;
    let _e155 = BlinnPhong_eval(point_3.brdf, point_3.wo, _e154);
    let _e156 = luminance(_e155);
    let _e158 = wi_3.z;
    let reflected = (_e156 * _e158);
    // glimt_render_gpu/src/kernels/candidates.rs:124
    let _e161 = radiance;
    let _e162 = luminance(_e161);
    let target_ = ((_e162 + this_43.floor) * reflected);
    // glimt_render_gpu/src/kernels/candidates.rs:125
    let _e167 = direction_10;
    let _e168 = wi_3;
    let _e169 = radiance;
    let _e172 = density_1;
    return Candidate(_e167, _e168, _e169, target_, (target_ * (f32(this_43.count) / _e172)));
}

// glimt_sampling/src/ris.rs:72
fn RisSum_add(this_44: ptr<function, RisSum>, weight: f32) {

    // glimt_sampling/src/ris.rs:73
    let _e6 = (*this_44).candidates;
    (*this_44).candidates = (_e6 + 1u);
    // glimt_sampling/src/ris.rs:74
    if (weight > 0f) {
        // glimt_sampling/src/ris.rs:75
        let _e13 = (*this_44).sum;
        (*this_44).sum = (_e13 + weight);
        // glimt_sampling/src/ris.rs:76
        let _e17 = (*this_44).candidates;
        (*this_44).end = _e17;
    }
    return;
}

// glimt_sampling/src/ris.rs:83
fn RisSum_normaliser(this_45: RisSum) -> f32 {
    var chosen_28: f32;

    // glimt_sampling/src/ris.rs:84
    if (this_45.candidates > 0u) {
        // glimt_sampling/src/ris.rs:85
        chosen_28 = (this_45.sum / f32(this_45.candidates));
    } else {
        // glimt_sampling/src/ris.rs:87
        chosen_28 = 0f;
    }
    let _e14 = chosen_28;
    return _e14;
}

// glimt_sampling/src/ris.rs:109
fn Word_next_u32_(this_46: ptr<function, Word>) -> u32 {

    // glimt_sampling/src/ris.rs:110
    let _e4 = (*this_46).f0_;
    return _e4;
}

// glimt_sampling/src/resample.rs:136
fn Comb_place_tooth_1(this_47: ptr<function, Comb>, source_9: ptr<function, Word>) {

    // glimt_sampling/src/resample.rs:137
    let _e5 = (*this_47).made;
    let _e7 = (*this_47).teeth;
    if (_e5 >= _e7) {
        // glimt_sampling/src/resample.rs:138
        return;
    }
    // glimt_sampling/src/resample.rs:140
    let _e12 = (*this_47).made;
    let first_5 = f32(_e12);
    // glimt_sampling/src/resample.rs:141
    let _e16 = (*this_47).scheme;
    if (_e16 == 0u) {
        // glimt_sampling/src/resample.rs:142
        let _e21 = (*this_47).state;
        (*this_47).next = (first_5 + _e21);
    } else {
        let _e25 = (*this_47).scheme;
        if (_e25 == 1u) {
            // glimt_sampling/src/resample.rs:144
            let _e29 = Word_next_u32_(source_9);
            let _e30 = unit_f32_(_e29);
            (*this_47).next = (first_5 + _e30);
        } else {
            // glimt_sampling/src/resample.rs:147
            let _e35 = Word_next_u32_(source_9);
            let _e36 = unit_f32_(_e35);
            let v_6 = (1f - _e36);
            // glimt_sampling/src/resample.rs:148
            let _e40 = (*this_47).teeth;
            let _e42 = (*this_47).made;
            let left_4 = f32((_e40 - _e42));
            // glimt_sampling/src/resample.rs:149
            let _e50 = (*this_47).state;
            (*this_47).state = (_e50 * pow(v_6, (1f / left_4)));
            // glimt_sampling/src/resample.rs:150
            let _e55 = (*this_47).state;
            let _e58 = (*this_47).teeth;
            (*this_47).next = ((1f - _e55) * f32(_e58));
        }
    }
    return;
}

// glimt_sampling/src/resample.rs:85
fn Comb_new_1(scheme_5: u32, picks_4: u32, sure_2: u32, source_10: ptr<function, Word>) -> Comb {
    var comb_2: Comb;

    // glimt_sampling/src/resample.rs:86
    comb_2 = Comb(scheme_5, picks_4, (max(picks_4, sure_2) - sure_2), 0u, 0f, 0f, 1f);
    // glimt_sampling/src/resample.rs:95
    if (scheme_5 == 0u) {
        // glimt_sampling/src/resample.rs:96
        let _e18 = Word_next_u32_(source_10);
        let _e19 = unit_f32_(_e18);
        comb_2.state = _e19;
    }
    // glimt_sampling/src/resample.rs:98
    Comb_place_tooth_1((&comb_2), source_10);
    // glimt_sampling/src/resample.rs:99
    let _e23 = comb_2;
    return _e23;
}

// glimt_sampling/src/ris.rs:118
fn RisPicks_new(weights: RisSum, samples_2: u32, u_21: u32) -> RisPicks {
    var borrowed_7: Word;
    var chosen_29: u32;

    // glimt_sampling/src/ris.rs:119
    let possible = (weights.sum > 0f);
    // glimt_sampling/src/ris.rs:120
    borrowed_7 = Word(u_21);
    let _e13 = Comb_new_1(0u, samples_2, 0u, (&borrowed_7));
    if possible {
        // glimt_sampling/src/ris.rs:124
        chosen_29 = samples_2;
    } else {
        chosen_29 = 0u;
    }
    let _e19 = chosen_29;
    return RisPicks(_e13, weights.sum, f32(samples_2), _e19, 0u, weights.end);
}

// glimt_sampling/src/resample.rs:106
fn Comb_take_1(this_48: ptr<function, Comb>, expected_2: f32, source_11: ptr<function, Word>) -> u32 {

    // glimt_sampling/src/resample.rs:107
    let _e6 = (*this_48).scheme;
    let _e7 = sure_copies(_e6, expected_2);
    // glimt_sampling/src/resample.rs:108
    let _e12 = (*this_48).reach;
    (*this_48).reach = (_e12 + (expected_2 - f32(_e7)));
    // glimt_sampling/src/resample.rs:109
    let before_1 = (*this_48).made;
    // glimt_sampling/src/resample.rs:110
    loop {
        let _e19 = (*this_48).made;
        let _e21 = (*this_48).teeth;
        let _e24 = (*this_48).next;
        let _e26 = (*this_48).reach;
        if ((_e19 < _e21) && (_e24 < _e26)) {
            // glimt_sampling/src/resample.rs:111
            let _e32 = (*this_48).made;
            (*this_48).made = (_e32 + 1u);
            // glimt_sampling/src/resample.rs:112
            Comb_place_tooth_1(this_48, source_11);
        } else {
            break;
        }
    }
    // glimt_sampling/src/resample.rs:114
    let _e37 = (*this_48).made;
    return (_e7 + (_e37 - before_1));
}

// glimt_sampling/src/ris.rs:133
fn RisPicks_take(this_49: ptr<function, RisPicks>, weight_1: f32) -> u32 {
    var chosen_30: u32;
    var borrowed_8: Comb;
    var borrowed_9: Word;

    // glimt_sampling/src/ris.rs:134
    let _e6 = (*this_49).candidate;
    (*this_49).candidate = (_e6 + 1u);
    // glimt_sampling/src/ris.rs:135
    let _e13 = (*this_49).left;
    if (!((weight_1 > 0f)) || (_e13 == 0u)) {
        // glimt_sampling/src/ris.rs:136
        return 0u;
    }
    // glimt_sampling/src/ris.rs:138
    let _e22 = (*this_49).candidate;
    let _e24 = (*this_49).end;
    if (_e22 == _e24) {
        // glimt_sampling/src/ris.rs:139
        let _e28 = (*this_49).left;
        chosen_30 = _e28;
    } else {
        // glimt_sampling/src/ris.rs:142
        let _e32 = (*this_49).comb;
        borrowed_8 = _e32;
        let _e34 = (*this_49).sum;
        let _e37 = (*this_49).samples;
        borrowed_9 = Word(0u);
        let _e42 = Comb_take_1((&borrowed_8), ((weight_1 / _e34) * _e37), (&borrowed_9));
        let _e43 = borrowed_8;
        (*this_49).comb = _e43;
        let _e45 = (*this_49).left;
        chosen_30 = min(_e42, _e45);
    }
    let picks_6 = chosen_30;
    // glimt_sampling/src/ris.rs:146
    let _e50 = (*this_49).left;
    (*this_49).left = (_e50 - picks_6);
    // glimt_sampling/src/ris.rs:147
    return picks_6;
}

// glimt_render_gpu/src/kernels/smc.rs:144
fn SmcParams_start(this_50: SmcParams, point_4: ShadingPoint, pattern_2: PixelPattern, env_size_1: vec2<u32>, env_rotation_1: vec2<f32>, particles_start_9: u32, particles_len_9: u32) -> f32 {
    var weights_1: RisSum;
    var counter_16: u32;
    var counter_17: u32;
    var picks_5: RisPicks;
    var filled: u32;
    var counter_18: u32;
    var counter_19: u32;

    // glimt_render_gpu/src/kernels/smc.rs:151
    // glimt_render_gpu/src/kernels/smc.rs:152
    let candidates = Candidates(this_50.candidates, this_50.source, this_50.floor);
    // glimt_render_gpu/src/kernels/smc.rs:157
    let _e15 = RisSum_new();
    weights_1 = _e15;
    // glimt_render_gpu/src/kernels/smc.rs:158
    counter_16 = 0u;
    loop {
        let j = counter_16;
        if (j >= this_50.candidates) {
            break;
        }
        // glimt_render_gpu/src/kernels/smc.rs:159
        let _e24 = Candidates_draw(candidates, j, point_4, pattern_2, env_size_1, env_rotation_1);
        RisSum_add((&weights_1), _e24.weight);
        continuing {
            let _e26 = counter_16;
            counter_16 = (_e26 + 1u);
        }
    }
    // glimt_render_gpu/src/kernels/smc.rs:161
    let _e30 = weights_1;
    let _e31 = RisSum_normaliser(_e30);
    // glimt_render_gpu/src/kernels/smc.rs:162
    if !((_e31 > 0f)) {
        // glimt_render_gpu/src/kernels/smc.rs:163
        counter_17 = 0u;
        loop {
            let i_10 = counter_17;
            if (i_10 >= particles_len_9) {
                break;
            }
            // glimt_render_gpu/src/kernels/smc.rs:164
            particles[(particles_start_9 + i_10)] = Particle(point_4.frame.n, -1000000000000000000000000000000f);
            continuing {
                let _e49 = counter_17;
                counter_17 = (_e49 + 1u);
            }
        }
        // glimt_render_gpu/src/kernels/smc.rs:169
        return -1000000000000000000000000000000f;
    }
    // glimt_render_gpu/src/kernels/smc.rs:171
    let _e55 = weights_1;
    let _e59 = PixelPattern_pair(pattern_2, 6u, 0u, 1u);
    let _e61 = RisPicks_new(_e55, particles_len_9, _e59.x);
    picks_5 = _e61;
    // glimt_render_gpu/src/kernels/smc.rs:172
    filled = 0u;
    // glimt_render_gpu/src/kernels/smc.rs:173
    counter_18 = 0u;
    loop {
        let j_1 = counter_18;
        if (j_1 >= this_50.candidates) {
            break;
        }
        // glimt_render_gpu/src/kernels/smc.rs:174
        let _e73 = Candidates_draw(candidates, j_1, point_4, pattern_2, env_size_1, env_rotation_1);
        // glimt_render_gpu/src/kernels/smc.rs:175
        let _e76 = RisPicks_take((&picks_5), _e73.weight);
        // glimt_render_gpu/src/kernels/smc.rs:176
        counter_19 = 0u;
        loop {
            let _e80 = counter_19;
            if (_e80 >= _e76) {
                break;
            }
            // glimt_render_gpu/src/kernels/smc.rs:177
            let _e84 = filled;
            particles[(particles_start_9 + _e84)].state = _e73.direction;
            // glimt_render_gpu/src/kernels/smc.rs:178
            let _e91 = filled;
            filled = (_e91 + 1u);
            continuing {
                let _e93 = counter_19;
                counter_19 = (_e93 + 1u);
            }
        }
        continuing {
            let _e96 = counter_18;
            counter_18 = (_e96 + 1u);
        }
    }
    // glimt_render_gpu/src/kernels/smc.rs:181
    make_equal(particles_start_9, particles_len_9);
    // glimt_render_gpu/src/kernels/smc.rs:182
    return log(_e31);
}

// glimt_render_gpu/src/kernels/smc.rs:189
fn advance_smc_1(ray_2: u32, frame_3: FrameParams, smc: SmcParams, env_size_2: vec2<u32>, env_rotation_2: vec2<f32>, before_size: vec2<u32>, before_rotation: vec2<f32>, state_start: u32, state_len: u32, particles_start_10: u32, particles_len_10: u32) {
    var now: RayState;
    var chosen_31: u32;
    var chosen_32: u32;
    var counter_20: u32;
    var source_12: PatternSource;
    var either_1: bool;
    var chosen_33: f32;

    // glimt_render_gpu/src/kernels/smc.rs:200
    let seen = points[ray_2];
    // glimt_render_gpu/src/kernels/smc.rs:201
    let _e16 = SmcPoint_is_hit(seen);
    if !(_e16) {
        // glimt_render_gpu/src/kernels/smc.rs:202
        state_5[(state_start + 0u)] = RayState(vec3(0f), 0f, vec3(0f), 0f, 0f, 0f, 0f, 0u, 0f, 0f, 0u, 0u);
        // glimt_render_gpu/src/kernels/smc.rs:203
        return;
    }
    // glimt_render_gpu/src/kernels/smc.rs:205
    let _e40 = FrameParams_pattern_of(frame_3, ray_2);
    // glimt_render_gpu/src/kernels/smc.rs:206
    let _e42 = SmcPoint_shading_point(seen);
    // glimt_render_gpu/src/kernels/smc.rs:207
    // glimt_render_gpu/src/kernels/smc.rs:208
    let _e51 = luminance(_e42.brdf.diffuse);
    let _e54 = luminance(_e42.brdf.specular);
    now = RayState(seen.normal, -1000000000000000000000000000000f, seen.wo, seen.depth, _e51, _e54, _e42.brdf.exponent, 0u, f32(particles_len_10), 0f, 1u, 0u);
    // glimt_render_gpu/src/kernels/smc.rs:222
    if (seen.predecessor != 4294967295u) {
        // glimt_render_gpu/src/kernels/smc.rs:223
        let old_1 = seen.before;
        // glimt_render_gpu/src/kernels/smc.rs:224
        now.age = (old_1.age + 1u);
        // glimt_render_gpu/src/kernels/smc.rs:225
        if (smc.changed != 0u) {
            // glimt_render_gpu/src/kernels/smc.rs:226
            chosen_31 = 4u;
        } else {
            let _e84 = now.age;
            let _e85 = SmcParams_is_due(smc, _e84, _e40);
            if _e85 {
                // glimt_render_gpu/src/kernels/smc.rs:228
                chosen_32 = 3u;
            } else {
                // glimt_render_gpu/src/kernels/smc.rs:230
                chosen_32 = 0u;
            }
            let _e90 = chosen_32;
            chosen_31 = _e90;
        }
        let _e91 = chosen_31;
        now.started = _e91;
    }
    // glimt_render_gpu/src/kernels/smc.rs:233
    let _e95 = now.started;
    if (_e95 == 0u) {
        // glimt_render_gpu/src/kernels/smc.rs:234
        let old_2 = seen.before;
        // glimt_render_gpu/src/kernels/smc.rs:235
        let first_6 = (seen.predecessor * particles_len_10);
        // glimt_render_gpu/src/kernels/smc.rs:236
        counter_20 = 0u;
        loop {
            let i_11 = counter_20;
            if (i_11 >= particles_len_10) {
                break;
            }
            // glimt_render_gpu/src/kernels/smc.rs:237
            let _e112 = past_particles[(first_6 + i_11)];
            particles[(particles_start_10 + i_11)] = _e112;
            continuing {
                let _e116 = counter_20;
                counter_20 = (_e116 + 1u);
            }
        }
        // glimt_render_gpu/src/kernels/smc.rs:239
        let _e121 = LightLobe_of_state(old_2);
        let _e123 = LightLobe_of_point(_e42);
        // glimt_render_gpu/src/kernels/smc.rs:247
        let _e126 = PixelPattern_source(_e40, 7u);
        source_12 = _e126;
        // glimt_render_gpu/src/kernels/smc.rs:248
        let _e129 = SmcParams_advance(smc, before_size, before_rotation, smc.previous_floor, _e121, env_size_2, env_rotation_2, smc.floor, _e123, _e42, particles_start_10, particles_len_10, (&source_12));
        // glimt_render_gpu/src/kernels/smc.rs:249
        let _e132 = is_log_zero(_e129.log_ratio);
        either_1 = _e132;
        if _e132 {
        } else {
            let _e135 = is_log_zero(old_2.log_normaliser);
            either_1 = _e135;
        }
        let dead = either_1;
        // glimt_render_gpu/src/kernels/smc.rs:250
        now.log_ratio = _e129.log_ratio;
        // glimt_render_gpu/src/kernels/smc.rs:251
        now.ess = _e129.ess;
        // glimt_render_gpu/src/kernels/smc.rs:252
        now.accepted = _e129.accepted;
        // glimt_render_gpu/src/kernels/smc.rs:253
        if ((smc.band > 0f) && (dead || (abs(_e129.log_ratio) > smc.band))) {
            // glimt_render_gpu/src/kernels/smc.rs:254
            now.started = 2u;
        }
        // glimt_render_gpu/src/kernels/smc.rs:256
        if dead {
            // glimt_render_gpu/src/kernels/smc.rs:257
            chosen_33 = -1000000000000000000000000000000f;
        } else {
            // glimt_render_gpu/src/kernels/smc.rs:259
            chosen_33 = (old_2.log_normaliser + _e129.log_ratio);
        }
        let _e167 = chosen_33;
        now.log_normaliser = _e167;
    }
    // glimt_render_gpu/src/kernels/smc.rs:262
    let _e171 = now.started;
    if (_e171 != 0u) {
        // glimt_render_gpu/src/kernels/smc.rs:263
        now.age = 0u;
        // glimt_render_gpu/src/kernels/smc.rs:264
        let _e178 = SmcParams_start(smc, _e42, _e40, env_size_2, env_rotation_2, particles_start_10, particles_len_10);
        now.log_normaliser = _e178;
    }
    // glimt_render_gpu/src/kernels/smc.rs:266
    let _e181 = now;
    state_5[(state_start + 0u)] = _e181;
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn advance_smc(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let local_1 = ((id.y * (groups.x * 64u)) + id.x);
    let _e11 = params.count;
    if (local_1 >= _e11) {
        return;
    }
    let _e14 = params.first;
    let _e17 = params.frame;
    let _e19 = params.smc;
    let _e21 = params.env_size;
    let _e23 = params.env_rotation;
    let _e25 = params.before_size;
    let _e27 = params.before_rotation;
    let _e29 = params.state_len;
    let _e32 = params.particles_len;
    advance_smc_1((_e14 + local_1), _e17, _e19, _e21, _e23, _e25, _e27, (local_1 * _e29), _e29, (local_1 * _e32), _e32);
}
