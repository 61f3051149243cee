// Made from Rust by naga-front-rust; do not edit. This command writes it: cargo run --release -p glimt-generate

struct BvhNode {
    min_x: vec4<f32>,
    min_y: vec4<f32>,
    min_z: vec4<f32>,
    max_x: vec4<f32>,
    max_y: vec4<f32>,
    max_z: vec4<f32>,
    children: array<u32, 4>,
}

struct Triangle {
    x: vec4<f32>,
    y: vec4<f32>,
    z: vec4<f32>,
    material: u32,
    object: u32,
    attributes: u32,
    run: u32,
}

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

struct PixelPattern {
    kind: u32,
    seed: u32,
    frame: u32,
    pixel: u32,
    ray: u32,
    rays: u32,
}

struct Reflected {
    lit: vec3<f32>,
    blocked: vec3<f32>,
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

struct HalfVector {
    cos2_theta: f32,
    sin2_theta: f32,
    wo_dot_h: f32,
}

struct LightSample {
    direction: vec3<f32>,
    contribution: vec3<f32>,
}

struct Ray {
    origin: vec3<f32>,
    direction: vec3<f32>,
    inverse_direction: vec3<f32>,
    key: u32,
}

struct Tuple_f32_f32_f32_ {
    fa: f32,
    fb: f32,
    fc: f32,
}

struct Met {
    children: u32,
    distances: array<f32, 4>,
}

struct Tuple_Vec4_Vec4_ {
    fa: vec4<f32>,
    fb: vec4<f32>,
}

struct Tuple_Vec4_Vec4_Vec4_ {
    fa: vec4<f32>,
    fb: vec4<f32>,
    fc: vec4<f32>,
}

struct Seen {
    a: vec3<f32>,
    edge_x: vec4<f32>,
    edge_y: vec4<f32>,
    edge_z: vec4<f32>,
    functions: vec4<f32>,
}

struct Tuple_u32_u32_ {
    fa: u32,
    fb: u32,
}

struct Attributes {
    uv: vec2<f32>,
    color: vec4<f32>,
}

struct Returned_MaterialView_new {
    value_words_start: u32,
    value_words_len: u32,
}

struct TextureView {
    first: u32,
    width: u32,
    height: u32,
    flags: u32,
}

struct Tuple_f32_f32_ {
    fa: f32,
    fb: f32,
}

struct OwenSobol {
    seed: u32,
    index: u32,
    dimension: u32,
}

struct Xoshiro128PlusPlus {
    state: vec4<u32>,
}

struct CameraView {
    eye: vec3<f32>,
    forward: vec3<f32>,
    right: vec3<f32>,
    up: vec3<f32>,
}

struct Returned_Environment_map {
    value_size: vec2<u32>,
    value_rotation: vec2<f32>,
}

struct Params {
    first: u32,
    count: u32,
    frame: FrameParams,
    floor: f32,
    particles_per_ray: u32,
    env_size: vec2<u32>,
    env_rotation: vec2<f32>,
}

@group(0) @binding(1) 
var<storage> env_texels: array<vec4<f32>>;
@group(0) @binding(2) 
var<storage> scene_nodes: array<BvhNode>;
@group(0) @binding(3) 
var<storage> scene_triangles: array<Triangle>;
@group(0) @binding(4) 
var<storage> scene_surface: array<u32>;
@group(0) @binding(5) 
var<storage> points: array<SmcPoint>;
@group(0) @binding(6) 
var<storage> states: array<RayState>;
@group(0) @binding(7) 
var<storage> particles: array<Particle>;
@group(0) @binding(8) 
var<storage, read_write> out: array<vec4<f32>>;
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

// glimt_sampling/src/hash.rs:34
fn hash3_(a_1: u32, b_1: u32, c: u32) -> u32 {

    // glimt_sampling/src/hash.rs:35
    let _e5 = hash2_(a_1, b_1);
    let _e7 = hash_u32_((_e5 + c));
    return _e7;
}

// glimt_render_gpu/src/kernels/pattern.rs:146
fn PixelPattern_key(this_3: PixelPattern, purpose: u32) -> u32 {

    // glimt_render_gpu/src/kernels/pattern.rs:147
    let _e5 = hash2_(this_3.seed, purpose);
    let _e8 = hash3_(_e5, this_3.frame, this_3.pixel);
    return _e8;
}

// glimt_render_gpu/src/kernels/pattern.rs:131
fn PixelPattern_ray_key(this_4: PixelPattern, purpose_1: u32) -> u32 {

    // glimt_render_gpu/src/kernels/pattern.rs:132
    let _e4 = PixelPattern_key(this_4, purpose_1);
    let _e6 = hash2_(_e4, this_4.ray);
    return _e6;
}

// glimt_smc/src/particle.rs:33
fn is_log_zero(log_weight: f32) -> bool {

    // glimt_smc/src/particle.rs:34
    return !((log_weight > (0.5f * -1000000000000000000000000000000f)));
}

// glimt_sampling/src/math.rs:45
fn ShadingFrame_from_normal(n_1: vec3<f32>) -> ShadingFrame {

    // glimt_sampling/src/math.rs:46
    let sign_ = bitcast<f32>(((bitcast<u32>(1f) & 2147483647u) | (bitcast<u32>(n_1.z) & 2147483648u)));
    // glimt_sampling/src/math.rs:47
    let a_2 = (-1f / (sign_ + n_1.z));
    // glimt_sampling/src/math.rs:48
    let c_1 = ((n_1.x * n_1.y) * a_2);
    // glimt_sampling/src/math.rs:49
    return ShadingFrame(vec3<f32>((1f + (((sign_ * n_1.x) * n_1.x) * a_2)), (sign_ * c_1), (-(sign_) * n_1.x)), vec3<f32>(c_1, (sign_ + ((n_1.y * n_1.y) * a_2)), -(n_1.y)), n_1);
}

// glimt_sampling/src/math.rs:66
fn ShadingFrame_to_local(this_5: ShadingFrame, v: vec3<f32>) -> vec3<f32> {

    // glimt_sampling/src/math.rs:67
    return vec3<f32>(dot(v, this_5.t), dot(v, this_5.b), dot(v, this_5.n));
}

// glimt_render_gpu/src/kernels/smc_point.rs:80
fn SmcPoint_shading_point(this_6: SmcPoint) -> ShadingPoint {

    // glimt_render_gpu/src/kernels/smc_point.rs:81
    let _e4 = ShadingFrame_from_normal(this_6.normal);
    // glimt_render_gpu/src/kernels/smc_point.rs:82
    let _e9 = ShadingFrame_to_local(_e4, this_6.wo);
    return ShadingPoint(this_6.origin, this_6.geometric_normal, _e4, _e9, BlinnPhong(this_6.diffuse, this_6.specular, this_6.exponent), this_6.emission);
}

// glimt_sampling/src/math.rs:16
fn luminance(rgb: vec3<f32>) -> f32 {

    // glimt_sampling/src/math.rs:17
    return (((0.2126f * rgb.x) + (0.7152f * rgb.y)) + (0.0722f * rgb.z));
}

// glimt_render_gpu/src/kernels/light_target.rs:26
fn LightLobe_of_point(point: ShadingPoint) -> LightLobe {

    // glimt_render_gpu/src/kernels/light_target.rs:27
    let _e7 = luminance(point.brdf.diffuse);
    let _e11 = luminance(point.brdf.specular);
    return LightLobe(point.frame, point.wo, BlinnPhong(vec3(_e7), vec3(_e11), point.brdf.exponent));
}

// glimt_probe/src/rotate.rs:33
fn rotate_z(d: vec3<f32>, cos_sin: vec2<f32>) -> vec3<f32> {

    // glimt_probe/src/rotate.rs:34
    return vec3<f32>(((d.x * cos_sin.x) - (d.y * cos_sin.y)), ((d.x * cos_sin.y) + (d.y * cos_sin.x)), d.z);
}

// glimt_render_gpu/src/kernels/environment.rs:89
fn Environment_to_map(size: vec2<u32>, rotation: vec2<f32>, direction: vec3<f32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/environment.rs:90
    let _e8 = rotate_z(direction, vec2<f32>(rotation.x, -(rotation.y)));
    return _e8;
}

// glimt_probe/src/latlong.rs:45
fn direction_to_uv(d_1: vec3<f32>) -> vec2<f32> {
    var chosen: f32;
    var chosen_1: f32;

    // glimt_probe/src/latlong.rs:46
    let horizontal = sqrt(((d_1.x * d_1.x) + (d_1.y * d_1.y)));
    // glimt_probe/src/latlong.rs:47
    if (horizontal <= 0f) {
        // glimt_probe/src/latlong.rs:48
        if (d_1.z < 0f) {
            chosen = 1f;
        } else {
            chosen = 0f;
        }
        let v_4 = chosen;
        // glimt_probe/src/latlong.rs:49
        return vec2<f32>(0.5f, v_4);
    }
    // glimt_probe/src/latlong.rs:52
    let v_5 = (atan2(horizontal, d_1.z) * 0.31830987f);
    // glimt_probe/src/latlong.rs:53
    let u_4 = (0.5f - ((0.5f * 0.31830987f) * atan2(d_1.y, d_1.x)));
    // glimt_probe/src/latlong.rs:54
    if (u_4 < 1f) {
        chosen_1 = max(u_4, 0f);
    } else {
        chosen_1 = 0f;
    }
    let _e47 = chosen_1;
    return vec2<f32>(_e47, clamp(v_5, 0f, 1f));
}

// glimt_probe/src/latlong.rs:68
fn direction_to_texel(d_2: vec3<f32>, size_1: vec2<u32>) -> vec2<u32> {

    // glimt_probe/src/latlong.rs:69
    let size_9 = max(size_1, vec2(1u));
    // glimt_probe/src/latlong.rs:70
    let _e8 = direction_to_uv(d_2);
    let position = (_e8 * vec2<f32>(size_9));
    // glimt_probe/src/latlong.rs:71
    return min(vec2<u32>(position), (size_9 - vec2(1u)));
}

// glimt_render_gpu/src/kernels/environment.rs:96
fn Environment_texel(size_2: vec2<u32>, rotation_1: vec2<f32>, direction_1: vec3<f32>) -> vec2<u32> {

    // glimt_render_gpu/src/kernels/environment.rs:97
    let _e5 = Environment_to_map(size_2, rotation_1, direction_1);
    let _e6 = direction_to_texel(_e5, size_2);
    return _e6;
}

// glimt_render_gpu/src/kernels/environment.rs:103
fn Environment_radiance(size_3: vec2<u32>, rotation_2: vec2<f32>, texel: vec2<u32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/environment.rs:104
    let _e11 = env_texels[((texel.y * size_3.x) + texel.x)];
    return _e11.xyz;
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
    var chosen_2: f32;

    // glimt_brdf/src/lobe.rs:60
    if (sin2_theta < (1f / 16f)) {
        // glimt_brdf/src/lobe.rs:62
        let t_4 = (sin2_theta / (2f - sin2_theta));
        // glimt_brdf/src/lobe.rs:63
        let t2_ = (t_4 * t_4);
        // glimt_brdf/src/lobe.rs:64
        chosen_2 = ((-2f * t_4) * (1f + (t2_ * ((1f / 3f) + (t2_ * (1f / 5f))))));
    } else {
        // glimt_brdf/src/lobe.rs:66
        chosen_2 = log(max(cos2_theta, 0.0000000000000000000000000000000000001f));
    }
    let log_cos2_ = chosen_2;
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
fn HalfVector_lobe(this_7: HalfVector, exponent_2: f32) -> f32 {

    // glimt_brdf/src/lobe.rs:33
    let _e6 = cosine_power(this_7.cos2_theta, this_7.sin2_theta, exponent_2);
    return _e6;
}

// glimt_brdf/src/blinn_phong.rs:59
fn BlinnPhong_eval(this_8: BlinnPhong, wo_1: vec3<f32>, wi_1: vec3<f32>) -> vec3<f32> {

    // glimt_brdf/src/blinn_phong.rs:60
    if ((wo_1.z <= 0f) || (wi_1.z <= 0f)) {
        // glimt_brdf/src/blinn_phong.rs:61
        return vec3(0f);
    }
    // glimt_brdf/src/blinn_phong.rs:63
    let diffuse = (this_8.diffuse * 0.31830987f);
    // glimt_brdf/src/blinn_phong.rs:65
    if (max(max(this_8.specular.x, this_8.specular.y), this_8.specular.z) <= 0f) {
        // glimt_brdf/src/blinn_phong.rs:66
        return diffuse;
    }
    // glimt_brdf/src/blinn_phong.rs:68
    let _e31 = normalisation(this_8.exponent);
    let _e32 = HalfVector_new(wo_1, wi_1);
    let _e34 = HalfVector_lobe(_e32, this_8.exponent);
    let lobe = (_e31 * _e34);
    // glimt_brdf/src/blinn_phong.rs:69
    return (diffuse + (this_8.specular * lobe));
}

// glimt_render_gpu/src/kernels/light_target.rs:57
fn LightLobe_value(this_9: LightLobe, direction_2: vec3<f32>) -> f32 {

    // glimt_render_gpu/src/kernels/light_target.rs:58
    let _e5 = ShadingFrame_to_local(this_9.frame, direction_2);
    // glimt_render_gpu/src/kernels/light_target.rs:59
    if !((_e5.z > 0f)) {
        // glimt_render_gpu/src/kernels/light_target.rs:60
        return 0f;
    }
    // glimt_render_gpu/src/kernels/light_target.rs:62
    let _e16 = BlinnPhong_eval(this_9.brdf, this_9.wo, _e5);
    return (_e16.x * _e5.z);
}

// glimt_render_gpu/src/kernels/estimator.rs:76
fn LightSample_new(point_1: ShadingPoint, direction_3: vec3<f32>, wi_2: vec3<f32>, radiance: vec3<f32>, density: f32) -> LightSample {

    // glimt_render_gpu/src/kernels/estimator.rs:83
    let in_front = ((wi_2.z > 0f) && (dot(point_1.geometric_normal, direction_3) > 0f));
    // glimt_render_gpu/src/kernels/estimator.rs:84
    if (!(in_front) || !((density > 0.000000000000000000000000000000000000011754944f))) {
        // glimt_render_gpu/src/kernels/estimator.rs:85
        return LightSample(vec3<f32>(0f, 0f, 1f), vec3(0f));
    }
    // glimt_render_gpu/src/kernels/estimator.rs:88
    let _e32 = BlinnPhong_eval(point_1.brdf, point_1.wo, wi_2);
    let weight = (_e32 * (wi_2.z / density));
    // glimt_render_gpu/src/kernels/estimator.rs:89
    return LightSample(direction_3, (radiance * weight));
}

// glimt_render_gpu/src/kernels/ray.rs:59
fn inverse(x_1: f32) -> f32 {

    // glimt_render_gpu/src/kernels/ray.rs:60
    return (1f / bitcast<f32>(((bitcast<u32>(max(abs(x_1), 0.000000000000000001f)) & 2147483647u) | (bitcast<u32>(x_1) & 2147483648u))));
}

// glimt_render_gpu/src/kernels/ray.rs:44
fn Ray_keyed(origin: vec3<f32>, direction_4: vec3<f32>, key: u32) -> Ray {

    // glimt_render_gpu/src/kernels/ray.rs:45
    let _e6 = inverse(direction_4.x);
    let _e8 = inverse(direction_4.y);
    let _e10 = inverse(direction_4.z);
    return Ray(origin, direction_4, vec3<f32>(_e6, _e8, _e10), key);
}

// glimt_render_gpu/src/kernels/bvh.rs:53
fn meet(node: BvhNode, ray_2: Ray, reach: f32) -> Met {
    var node_1: BvhNode;

    node_1 = node;
    // glimt_render_gpu/src/kernels/bvh.rs:54
    let _e12 = Tuple_f32_f32_f32_(ray_2.origin.x, ray_2.origin.y, ray_2.origin.z);
    let x_7 = _e12.fa;
    let y_1 = _e12.fb;
    let z_1 = _e12.fc;
    // glimt_render_gpu/src/kernels/bvh.rs:55
    let inverse_1 = ray_2.inverse_direction;
    // glimt_render_gpu/src/kernels/bvh.rs:56
    let _e20 = node_1.min_x;
    let to_min_x = ((_e20 - vec4(x_7)) * inverse_1.x);
    // glimt_render_gpu/src/kernels/bvh.rs:57
    let _e27 = node_1.max_x;
    let to_max_x = ((_e27 - vec4(x_7)) * inverse_1.x);
    // glimt_render_gpu/src/kernels/bvh.rs:58
    let _e34 = node_1.min_y;
    let to_min_y = ((_e34 - vec4(y_1)) * inverse_1.y);
    // glimt_render_gpu/src/kernels/bvh.rs:59
    let _e41 = node_1.max_y;
    let to_max_y = ((_e41 - vec4(y_1)) * inverse_1.y);
    // glimt_render_gpu/src/kernels/bvh.rs:60
    let _e48 = node_1.min_z;
    let to_min_z = ((_e48 - vec4(z_1)) * inverse_1.z);
    // glimt_render_gpu/src/kernels/bvh.rs:61
    let _e55 = node_1.max_z;
    let to_max_z = ((_e55 - vec4(z_1)) * inverse_1.z);
    // glimt_render_gpu/src/kernels/bvh.rs:62
    let near_x = min(to_min_x, to_max_x);
    // glimt_render_gpu/src/kernels/bvh.rs:63
    let near_y = min(to_min_y, to_max_y);
    // glimt_render_gpu/src/kernels/bvh.rs:64
    let near_z = min(to_min_z, to_max_z);
    // glimt_render_gpu/src/kernels/bvh.rs:65
    let far_x = max(to_min_x, to_max_x);
    // glimt_render_gpu/src/kernels/bvh.rs:66
    let far_y = max(to_min_y, to_max_y);
    // glimt_render_gpu/src/kernels/bvh.rs:67
    let far_z = max(to_min_z, to_max_z);
    // glimt_render_gpu/src/kernels/bvh.rs:68
    let distances = max(max(near_x, near_y), max(near_z, vec4(0f)));
    // glimt_render_gpu/src/kernels/bvh.rs:69
    let far = (min(min(far_x, far_y), far_z) * 1.0000004f);
    // glimt_render_gpu/src/kernels/bvh.rs:70
    let room = (min(far, vec4(reach)) - distances);
    // glimt_render_gpu/src/kernels/bvh.rs:71
    return Met((15u - dot((bitcast<vec4<u32>>(room) >> vec4(31u)), vec4<u32>(1u, 2u, 4u, 8u))), array<f32, 4>(distances.x, distances.y, distances.z, distances.w));
}

// glimt_render_gpu/src/kernels/triangle.rs:163
fn seen(triangle: Triangle, ray_3: Ray) -> Seen {

    // glimt_render_gpu/src/kernels/triangle.rs:164
    let x_8 = (triangle.x - vec4(ray_3.origin.x));
    // glimt_render_gpu/src/kernels/triangle.rs:165
    let y_2 = (triangle.y - vec4(ray_3.origin.y));
    // glimt_render_gpu/src/kernels/triangle.rs:166
    let z_2 = (triangle.z - vec4(ray_3.origin.z));
    // glimt_render_gpu/src/kernels/triangle.rs:168
    let _e24 = Tuple_Vec4_Vec4_(x_8.yzxw, x_8.zxyw);
    let x1_ = _e24.fa;
    let x2_ = _e24.fb;
    // glimt_render_gpu/src/kernels/triangle.rs:169
    let _e30 = Tuple_Vec4_Vec4_(y_2.yzxw, y_2.zxyw);
    let y1_ = _e30.fa;
    let y2_ = _e30.fb;
    // glimt_render_gpu/src/kernels/triangle.rs:170
    let _e36 = Tuple_Vec4_Vec4_(z_2.yzxw, z_2.zxyw);
    let z1_ = _e36.fa;
    let z2_ = _e36.fb;
    // glimt_render_gpu/src/kernels/triangle.rs:171
    let _e43 = Tuple_Vec4_Vec4_Vec4_((x1_ - x2_), (y1_ - y2_), (z1_ - z2_));
    let edge_x = _e43.fa;
    let edge_y = _e43.fb;
    let edge_z = _e43.fc;
    // glimt_render_gpu/src/kernels/triangle.rs:172
    let _e51 = Tuple_Vec4_Vec4_Vec4_((x1_ + x2_), (y1_ + y2_), (z1_ + z2_));
    let sum_x = _e51.fa;
    let sum_y = _e51.fb;
    let sum_z = _e51.fc;
    // glimt_render_gpu/src/kernels/triangle.rs:173
    let d_4 = ray_3.direction;
    // glimt_render_gpu/src/kernels/triangle.rs:174
    let functions = (((((edge_y * sum_z) - (edge_z * sum_y)) * d_4.x) + (((edge_z * sum_x) - (edge_x * sum_z)) * d_4.y)) + (((edge_x * sum_y) - (edge_y * sum_x)) * d_4.z));
    // glimt_render_gpu/src/kernels/triangle.rs:177
    return Seen(vec3<f32>(x_8.x, y_2.x, z_2.x), edge_x, edge_y, edge_z, functions);
}

// glimt_render_gpu/src/kernels/triangle.rs:191
fn intersect(triangle_1: Triangle, ray_4: Ray, t_max: f32) -> f32 {
    var chosen_3: f32;

    // glimt_render_gpu/src/kernels/triangle.rs:192
    let _e5 = seen(triangle_1, ray_4);
    // glimt_render_gpu/src/kernels/triangle.rs:193
    if ((min(min(min(_e5.functions.x, _e5.functions.y), _e5.functions.z), _e5.functions.w) < 0f) && (max(max(max(_e5.functions.x, _e5.functions.y), _e5.functions.z), _e5.functions.w) > 0f)) {
        // glimt_render_gpu/src/kernels/triangle.rs:194
        return 0x1.fffffep+127f;
    }
    // glimt_render_gpu/src/kernels/triangle.rs:196
    let from_a = vec3<f32>(_e5.edge_x.y, _e5.edge_y.y, _e5.edge_z.y);
    // glimt_render_gpu/src/kernels/triangle.rs:197
    let to_a = vec3<f32>(_e5.edge_x.z, _e5.edge_y.z, _e5.edge_z.z);
    // glimt_render_gpu/src/kernels/triangle.rs:198
    let normal = cross(from_a, to_a);
    // glimt_render_gpu/src/kernels/triangle.rs:199
    let slope = dot(normal, ray_4.direction);
    // glimt_render_gpu/src/kernels/triangle.rs:200
    if (slope == 0f) {
        // glimt_render_gpu/src/kernels/triangle.rs:201
        return 0x1.fffffep+127f;
    }
    // glimt_render_gpu/src/kernels/triangle.rs:203
    let t_5 = (dot(_e5.a, normal) / slope);
    // glimt_render_gpu/src/kernels/triangle.rs:204
    if ((t_5 > 0f) && (t_5 < t_max)) {
        chosen_3 = t_5;
    } else {
        chosen_3 = 0x1.fffffep+127f;
    }
    let _e67 = chosen_3;
    return _e67;
}

// glimt_render_gpu/src/kernels/triangle.rs:99
fn Triangle_is_see_through(this_10: Triangle) -> bool {

    // glimt_render_gpu/src/kernels/triangle.rs:100
    return ((this_10.object & 1073741824u) != 0u);
}

// glimt_render_gpu/src/kernels/triangle.rs:210
fn barycentrics(triangle_2: Triangle, ray_5: Ray) -> vec2<f32> {

    // glimt_render_gpu/src/kernels/triangle.rs:211
    let _e4 = seen(triangle_2, ray_5);
    let w_1 = _e4.functions.xyz;
    // glimt_render_gpu/src/kernels/triangle.rs:212
    let sum_4 = ((w_1.x + w_1.y) + w_1.z);
    // glimt_render_gpu/src/kernels/triangle.rs:213
    if (sum_4 == 0f) {
        // glimt_render_gpu/src/kernels/triangle.rs:215
        return vec2((1f / 3f));
    }
    // glimt_render_gpu/src/kernels/triangle.rs:217
    return (vec2<f32>(w_1.y, w_1.z) / vec2(sum_4));
}

// glimt_render_gpu/src/kernels/material.rs:141
fn Attributes_of_corner(first: u32) -> Attributes {

    // glimt_render_gpu/src/kernels/material.rs:142
    let _e7 = scene_surface[(first + 2u)];
    let _e12 = scene_surface[(first + 3u)];
    let _e13 = Tuple_u32_u32_(_e7, _e12);
    let low = _e13.fa;
    let high = _e13.fb;
    // glimt_render_gpu/src/kernels/material.rs:143
    let color = vec4<f32>(f32((low & 65535u)), f32((low >> 16u)), f32((high & 65535u)), f32((high >> 16u)));
    // glimt_render_gpu/src/kernels/material.rs:149
    let _e33 = scene_surface[first];
    let _e39 = scene_surface[(first + 1u)];
    return Attributes(vec2<f32>(bitcast<f32>(_e33), bitcast<f32>(_e39)), (color / vec4(65535f)));
}

// glimt_render_gpu/src/kernels/material.rs:129
fn Attributes_at(first_1: u32, u: f32, v_1: f32) -> Attributes {

    // glimt_render_gpu/src/kernels/material.rs:130
    let _e5 = Attributes_of_corner(first_1);
    // glimt_render_gpu/src/kernels/material.rs:131
    let _e9 = Attributes_of_corner((first_1 + 4u));
    // glimt_render_gpu/src/kernels/material.rs:132
    let _e15 = Attributes_of_corner((first_1 + (2u * 4u)));
    // glimt_render_gpu/src/kernels/material.rs:133
    let w_2 = ((1f - u) - v_1);
    // glimt_render_gpu/src/kernels/material.rs:134
    return Attributes((((_e5.uv * w_2) + (_e9.uv * u)) + (_e15.uv * v_1)), (((_e5.color * w_2) + (_e9.color * u)) + (_e15.color * v_1)));
}

// glimt_render_gpu/src/kernels/material.rs:172
fn MaterialView_new(index: u32) -> Returned_MaterialView_new {

    // glimt_render_gpu/src/kernels/material.rs:173
    let first_3 = (256u + (index * 76u));
    // glimt_render_gpu/src/kernels/material.rs:174
    return Returned_MaterialView_new(first_3, ((first_3 + 76u) - first_3));
}

// glimt_render_gpu/src/kernels/material.rs:181
fn MaterialView_number(words_start: u32, words_len: u32, word: u32) -> f32 {

    // glimt_render_gpu/src/kernels/material.rs:182
    let _e7 = scene_surface[(words_start + word)];
    return bitcast<f32>(_e7);
}

// glimt_render_gpu/src/kernels/material.rs:195
fn MaterialView_texture(words_start_1: u32, words_len_1: u32, word_1: u32) -> TextureView {

    // glimt_render_gpu/src/kernels/material.rs:196
    let _e7 = scene_surface[(words_start_1 + word_1)];
    let _e13 = scene_surface[(words_start_1 + (word_1 + 1u))];
    let _e19 = scene_surface[(words_start_1 + (word_1 + 2u))];
    let _e25 = scene_surface[(words_start_1 + (word_1 + 3u))];
    return TextureView(_e7, _e13, _e19, _e25);
}

// glimt_render_gpu/src/kernels/texture.rs:40
fn TextureView_exists(this_11: TextureView) -> bool {

    // glimt_render_gpu/src/kernels/texture.rs:41
    return (this_11.width > 0u);
}

// glimt_render_gpu/src/kernels/texture.rs:90
fn wrap(x_2: f32, mode: u32) -> f32 {

    // glimt_render_gpu/src/kernels/texture.rs:91
    if (mode == 2u) {
        // glimt_render_gpu/src/kernels/texture.rs:92
        return clamp(x_2, 0f, 1f);
    }
    // glimt_render_gpu/src/kernels/texture.rs:94
    if (mode == 1u) {
        // glimt_render_gpu/src/kernels/texture.rs:95
        let folded = (x_2 - (2f * floor((0.5f * x_2))));
        // glimt_render_gpu/src/kernels/texture.rs:96
        return clamp(min(folded, (2f - folded)), 0f, 1f);
    }
    // glimt_render_gpu/src/kernels/texture.rs:98
    return clamp((x_2 - floor(x_2)), 0f, 1f);
}

// glimt_render_gpu/src/kernels/texture.rs:103
fn neighbour(index_1: i32, size_4: u32, mode_1: u32) -> u32 {

    // glimt_render_gpu/src/kernels/texture.rs:104
    let last = (i32(size_4) - 1i);
    // glimt_render_gpu/src/kernels/texture.rs:105
    if (mode_1 == 0u) {
        // glimt_render_gpu/src/kernels/texture.rs:106
        if (index_1 < 0i) {
            // glimt_render_gpu/src/kernels/texture.rs:107
            return u32(last);
        }
        // glimt_render_gpu/src/kernels/texture.rs:109
        if (index_1 > last) {
            // glimt_render_gpu/src/kernels/texture.rs:110
            return 0u;
        }
    }
    // glimt_render_gpu/src/kernels/texture.rs:113
    return u32(clamp(index_1, 0i, last));
}

// glimt_render_gpu/src/kernels/texture.rs:69
fn TextureView_texel(this_12: TextureView, index_2: u32) -> vec4<f32> {
    var chosen_4: vec4<f32>;

    // glimt_render_gpu/src/kernels/texture.rs:70
    let word_3 = scene_surface[(this_12.first + index_2)];
    // glimt_render_gpu/src/kernels/texture.rs:71
    let r = (word_3 & 255u);
    // glimt_render_gpu/src/kernels/texture.rs:72
    let g = ((word_3 >> 8u) & 255u);
    // glimt_render_gpu/src/kernels/texture.rs:73
    let b_2 = ((word_3 >> 16u) & 255u);
    // glimt_render_gpu/src/kernels/texture.rs:74
    let alpha_2 = (f32((word_3 >> 24u)) / 255f);
    // glimt_render_gpu/src/kernels/texture.rs:75
    if ((this_12.flags & 1u) != 0u) {
        // glimt_render_gpu/src/kernels/texture.rs:76
        let _e38 = scene_surface[r];
        let _e42 = scene_surface[g];
        let _e46 = scene_surface[b_2];
        chosen_4 = vec4<f32>(bitcast<f32>(_e38), bitcast<f32>(_e42), bitcast<f32>(_e46), alpha_2);
    } else {
        // glimt_render_gpu/src/kernels/texture.rs:83
        chosen_4 = vec4<f32>((f32(r) / 255f), (f32(g) / 255f), (f32(b_2) / 255f), alpha_2);
    }
    let _e60 = chosen_4;
    return _e60;
}

// glimt_render_gpu/src/kernels/texture.rs:49
fn TextureView_sample(this_13: TextureView, uv: vec2<f32>) -> vec4<f32> {

    // glimt_render_gpu/src/kernels/texture.rs:50
    let wrap_u = ((this_13.flags >> 1u) & 3u);
    // glimt_render_gpu/src/kernels/texture.rs:51
    let wrap_v = ((this_13.flags >> ((1u + 2u) & 31u)) & 3u);
    // glimt_render_gpu/src/kernels/texture.rs:52
    let _e21 = wrap(uv.x, wrap_u);
    let x_9 = ((_e21 * f32(this_13.width)) - 0.5f);
    // glimt_render_gpu/src/kernels/texture.rs:53
    let _e29 = wrap(uv.y, wrap_v);
    let y_3 = ((_e29 * f32(this_13.height)) - 0.5f);
    // glimt_render_gpu/src/kernels/texture.rs:54
    let _e38 = Tuple_f32_f32_(floor(x_9), floor(y_3));
    let left = _e38.fa;
    let top = _e38.fb;
    // glimt_render_gpu/src/kernels/texture.rs:55
    let _e44 = neighbour(i32(left), this_13.width, wrap_u);
    // glimt_render_gpu/src/kernels/texture.rs:56
    let _e50 = neighbour((i32(left) + 1i), this_13.width, wrap_u);
    // glimt_render_gpu/src/kernels/texture.rs:57
    let _e54 = neighbour(i32(top), this_13.height, wrap_v);
    let row0_ = (_e54 * this_13.width);
    // glimt_render_gpu/src/kernels/texture.rs:58
    let _e62 = neighbour((i32(top) + 1i), this_13.height, wrap_v);
    let row1_ = (_e62 * this_13.width);
    // glimt_render_gpu/src/kernels/texture.rs:59
    let _e67 = TextureView_texel(this_13, (row0_ + _e44));
    let _e69 = TextureView_texel(this_13, (row0_ + _e50));
    let _e70 = (x_9 - left);
    let upper = ((_e67 * (1f - _e70)) + (_e69 * _e70));
    // glimt_render_gpu/src/kernels/texture.rs:62
    let _e78 = TextureView_texel(this_13, (row1_ + _e44));
    let _e80 = TextureView_texel(this_13, (row1_ + _e50));
    let _e81 = (x_9 - left);
    let lower = ((_e78 * (1f - _e81)) + (_e80 * _e81));
    // glimt_render_gpu/src/kernels/texture.rs:65
    let _e88 = (y_3 - top);
    return ((upper * (1f - _e88)) + (lower * _e88));
}

// glimt_render_gpu/src/kernels/material.rs:206
fn MaterialView_sample(words_start_2: u32, words_len_2: u32, word_2: u32, texture: TextureView, uv_1: vec2<f32>) -> vec4<f32> {
    var place: vec2<f32>;

    // glimt_render_gpu/src/kernels/material.rs:207
    place = uv_1;
    // glimt_render_gpu/src/kernels/material.rs:208
    if ((texture.flags & 65536u) != 0u) {
        // glimt_render_gpu/src/kernels/material.rs:209
        let t_6 = (word_2 + 4u);
        // glimt_render_gpu/src/kernels/material.rs:210
        let _e18 = MaterialView_number(words_start_2, words_len_2, t_6);
        let _e21 = MaterialView_number(words_start_2, words_len_2, (t_6 + 1u));
        let _e27 = MaterialView_number(words_start_2, words_len_2, (t_6 + 2u));
        let _e30 = MaterialView_number(words_start_2, words_len_2, (t_6 + 3u));
        let _e37 = MaterialView_number(words_start_2, words_len_2, (t_6 + 4u));
        let _e40 = MaterialView_number(words_start_2, words_len_2, (t_6 + 5u));
        place = (((vec2<f32>(_e18, _e21) * uv_1.x) + (vec2<f32>(_e27, _e30) * uv_1.y)) + vec2<f32>(_e37, _e40));
    }
    // glimt_render_gpu/src/kernels/material.rs:214
    let _e44 = place;
    let _e45 = TextureView_sample(texture, _e44);
    return _e45;
}

// glimt_render_gpu/src/kernels/material.rs:280
fn MaterialView_alpha(words_start_3: u32, words_len_3: u32, uv_2: vec2<f32>, vertex_alpha: f32) -> f32 {
    var alpha: f32;
    var chosen_5: f32;

    // glimt_render_gpu/src/kernels/material.rs:281
    let _e7 = MaterialView_number(words_start_3, words_len_3, 11u);
    alpha = (_e7 * vertex_alpha);
    // glimt_render_gpu/src/kernels/material.rs:282
    let _e12 = MaterialView_texture(words_start_3, words_len_3, 64u);
    // glimt_render_gpu/src/kernels/material.rs:283
    let _e14 = TextureView_exists(_e12);
    if _e14 {
        // glimt_render_gpu/src/kernels/material.rs:284
        let _e17 = MaterialView_sample(words_start_3, words_len_3, 64u, _e12, uv_2);
        let _e19 = alpha;
        alpha = (_e19 * _e17.w);
    }
    // glimt_render_gpu/src/kernels/material.rs:286
    let _e23 = MaterialView_number(words_start_3, words_len_3, 15u);
    // glimt_render_gpu/src/kernels/material.rs:287
    if (_e23 < 0f) {
        // glimt_render_gpu/src/kernels/material.rs:288
        let _e28 = alpha;
        return _e28;
    }
    // glimt_render_gpu/src/kernels/material.rs:290
    let _e31 = alpha;
    if (_e31 >= _e23) {
        chosen_5 = 1f;
    } else {
        chosen_5 = 0f;
    }
    let _e35 = chosen_5;
    return _e35;
}

// glimt_render_gpu/src/kernels/opacity.rs:14
fn alpha_at(triangle_3: Triangle, u_1: f32, v_2: f32) -> f32 {

    // glimt_render_gpu/src/kernels/opacity.rs:15
    let _e6 = Attributes_at(triangle_3.attributes, u_1, v_2);
    // glimt_render_gpu/src/kernels/opacity.rs:16
    let _e11 = MaterialView_new((triangle_3.material & 2147483647u));
    // glimt_render_gpu/src/kernels/opacity.rs:17
    let _e18 = MaterialView_alpha(_e11.value_words_start, _e11.value_words_len, _e6.uv, _e6.color.w);
    return _e18;
}

// glimt_sampling/src/uniform.rs:15
fn unit_f32_(u_2: u32) -> f32 {

    // glimt_sampling/src/uniform.rs:16
    return (f32((u_2 >> 8u)) * (1f / 16777216f));
}

// glimt_render_gpu/src/kernels/opacity.rs:26
fn passes(key_1: u32, index_3: u32, alpha_1: f32) -> bool {

    // glimt_render_gpu/src/kernels/opacity.rs:27
    let _e5 = hash2_(key_1, index_3);
    let _e6 = unit_f32_(_e5);
    return (_e6 >= alpha_1);
}

// glimt_render_gpu/src/kernels/opacity.rs:33
fn is_passed(index_4: u32, triangle_4: Triangle, ray_6: Ray) -> bool {

    // glimt_render_gpu/src/kernels/opacity.rs:34
    let _e5 = barycentrics(triangle_4, ray_6);
    // glimt_render_gpu/src/kernels/opacity.rs:35
    let _e9 = alpha_at(triangle_4, _e5.x, _e5.y);
    // glimt_render_gpu/src/kernels/opacity.rs:36
    let _e12 = passes(ray_6.key, index_4, _e9);
    return _e12;
}

// glimt_render_gpu/src/kernels/triangle.rs:85
fn Triangle_is_catcher(this_14: Triangle) -> bool {

    // glimt_render_gpu/src/kernels/triangle.rs:86
    return ((this_14.object & 2147483648u) != 0u);
}

// glimt_render_gpu/src/kernels/triangle.rs:71
fn Triangle_b(this_15: Triangle) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/triangle.rs:72
    return vec3<f32>(this_15.x.y, this_15.y.y, this_15.z.y);
}

// glimt_render_gpu/src/kernels/triangle.rs:64
fn Triangle_a(this_16: Triangle) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/triangle.rs:65
    return vec3<f32>(this_16.x.x, this_16.y.x, this_16.z.x);
}

// glimt_render_gpu/src/kernels/triangle.rs:78
fn Triangle_c(this_17: Triangle) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/triangle.rs:79
    return vec3<f32>(this_17.x.z, this_17.y.z, this_17.z.z);
}

// glimt_render_gpu/src/kernels/triangle.rs:140
fn Triangle_area_normal(this_18: Triangle) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/triangle.rs:141
    let _e3 = Triangle_b(this_18);
    let _e4 = Triangle_a(this_18);
    let _e6 = Triangle_c(this_18);
    let _e7 = Triangle_a(this_18);
    return cross((_e3 - _e4), (_e6 - _e7));
}

// glimt_render_gpu/src/kernels/triangle.rs:106
fn Triangle_ray_offset(this_19: Triangle) -> f32 {

    // glimt_render_gpu/src/kernels/triangle.rs:107
    let extent = max(max(abs(this_19.x), abs(this_19.y)), abs(this_19.z));
    // glimt_render_gpu/src/kernels/triangle.rs:108
    return (0.0000038146973f * max(max(max(extent.x, extent.y), extent.z), extent.w));
}

// glimt_render_gpu/src/kernels/triangle.rs:114
fn Triangle_setback(this_20: Triangle, ray_7: Ray, t: f32) -> f32 {

    // glimt_render_gpu/src/kernels/triangle.rs:115
    let _e5 = Triangle_area_normal(this_20);
    // glimt_render_gpu/src/kernels/triangle.rs:116
    let across = abs(dot(_e5, ray_7.direction));
    // glimt_render_gpu/src/kernels/triangle.rs:117
    let _e12 = Triangle_ray_offset(this_20);
    let apart = (2f * max(_e12, ((0.0000038146973f * t) * sqrt(dot(ray_7.direction, ray_7.direction)))));
    // glimt_render_gpu/src/kernels/triangle.rs:122
    return min(((apart * sqrt(dot(_e5, _e5))) / max(across, 0.000000000000000000000000000000000000011754944f)), t);
}

// glimt_render_gpu/src/kernels/bvh.rs:214
fn held(index_5: u32, triangle_5: Triangle, ray_8: Ray, t_1: f32, no_catcher: bool) -> f32 {
    var both: bool;

    // glimt_render_gpu/src/kernels/bvh.rs:222
    let _e7 = Triangle_is_see_through(triangle_5);
    both = _e7;
    if _e7 {
        let _e9 = is_passed(index_5, triangle_5, ray_8);
        both = _e9;
    }
    let _e10 = both;
    if _e10 {
        // glimt_render_gpu/src/kernels/bvh.rs:223
        return 0x1.fffffep+127f;
    }
    // glimt_render_gpu/src/kernels/bvh.rs:225
    let _e14 = Triangle_is_catcher(triangle_5);
    if !(_e14) {
        // glimt_render_gpu/src/kernels/bvh.rs:226
        return t_1;
    }
    // glimt_render_gpu/src/kernels/bvh.rs:228
    if no_catcher {
        // glimt_render_gpu/src/kernels/bvh.rs:229
        return 0x1.fffffep+127f;
    }
    // glimt_render_gpu/src/kernels/bvh.rs:231
    let _e21 = Triangle_setback(triangle_5, ray_8, t_1);
    return (t_1 + _e21);
}

// glimt_render_gpu/src/kernels/bvh.rs:187
fn visit_leaf(first_2: u32, ray_9: Ray, reach_1: ptr<function, f32>, best: u32, no_catcher_1: bool) -> u32 {
    var nearest: u32;
    var counter: u32;
    var t_2: f32;
    var both_1: bool;

    // glimt_render_gpu/src/kernels/bvh.rs:196
    nearest = best;
    // glimt_render_gpu/src/kernels/bvh.rs:197
    let _e12 = scene_triangles[first_2].run;
    counter = first_2;
    loop {
        let i = counter;
        if (i >= (first_2 + _e12)) {
            break;
        }
        // glimt_render_gpu/src/kernels/bvh.rs:198
        let _e20 = scene_triangles[i];
        let _e21 = (*reach_1);
        let _e22 = intersect(_e20, ray_9, _e21);
        t_2 = _e22;
        // glimt_render_gpu/src/kernels/bvh.rs:200
        let _e25 = t_2;
        let _e26 = (*reach_1);
        let _e27 = (_e25 < _e26);
        both_1 = _e27;
        if _e27 {
            let _e32 = scene_triangles[i].object;
            both_1 = (_e32 >= 1073741824u);
        }
        let _e35 = both_1;
        if _e35 {
            // glimt_render_gpu/src/kernels/bvh.rs:201
            let _e39 = scene_triangles[i];
            let _e40 = t_2;
            let _e41 = held(i, _e39, ray_9, _e40, no_catcher_1);
            t_2 = _e41;
        }
        // glimt_render_gpu/src/kernels/bvh.rs:203
        let _e43 = t_2;
        let _e44 = (*reach_1);
        if (_e43 < _e44) {
            // glimt_render_gpu/src/kernels/bvh.rs:204
            let _e47 = t_2;
            (*reach_1) = _e47;
            // glimt_render_gpu/src/kernels/bvh.rs:205
            nearest = i;
        }
        continuing {
            let _e49 = counter;
            counter = (_e49 + 1u);
        }
    }
    // glimt_render_gpu/src/kernels/bvh.rs:208
    let _e53 = nearest;
    return _e53;
}

// glimt_render_gpu/src/kernels/bvh.rs:125
fn traverse(ray_10: Ray, reach_2: ptr<function, f32>, any_: bool) -> u32 {
    var best_1: u32;
    var stack: array<u32, 64>;
    var height: u32;
    var at: u32;
    var next: u32;
    var node_2: BvhNode;
    var met: Met;
    var distance_: f32;
    var counter_1: u32;
    var waiting: u32;

    // glimt_render_gpu/src/kernels/bvh.rs:133
    if (arrayLength((&scene_nodes)) == 0u) {
        // glimt_render_gpu/src/kernels/bvh.rs:134
        return 4294967295u;
    }
    // glimt_render_gpu/src/kernels/bvh.rs:136
    best_1 = 4294967295u;
    // glimt_render_gpu/src/kernels/bvh.rs:137
    stack = array<u32, 64>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
    // glimt_render_gpu/src/kernels/bvh.rs:138
    height = 0u;
    // glimt_render_gpu/src/kernels/bvh.rs:139
    at = 0u;
    // glimt_render_gpu/src/kernels/bvh.rs:140
    loop {
        // glimt_render_gpu/src/kernels/bvh.rs:142
        next = 0u;
        // glimt_render_gpu/src/kernels/bvh.rs:143
        let _e29 = at;
        if (_e29 < 2147483648u) {
            // glimt_render_gpu/src/kernels/bvh.rs:144
            let _e33 = at;
            let _e36 = scene_nodes[_e33];
            node_2 = _e36;
            // glimt_render_gpu/src/kernels/bvh.rs:145
            let _e39 = node_2;
            let _e40 = (*reach_2);
            let _e41 = meet(_e39, ray_10, _e40);
            met = _e41;
            // glimt_render_gpu/src/kernels/bvh.rs:146
            distance_ = 0x1.fffffep+127f;
            // glimt_render_gpu/src/kernels/bvh.rs:148
            counter_1 = 0u;
            loop {
                let i_1 = counter_1;
                if (i_1 >= 4u) {
                    break;
                }
                // glimt_render_gpu/src/kernels/bvh.rs:149
                let child = node_2.children[i_1];
                // glimt_render_gpu/src/kernels/bvh.rs:150
                let _e58 = met.children;
                if (((_e58 >> (i_1 & 31u)) & 1u) != 0u) {
                    // glimt_render_gpu/src/kernels/bvh.rs:152
                    let _e67 = next;
                    waiting = _e67;
                    // glimt_render_gpu/src/kernels/bvh.rs:153
                    if any_ {
                        // glimt_render_gpu/src/kernels/bvh.rs:154
                        next = child;
                    } else {
                        let _e73 = met.distances[i_1];
                        let _e74 = distance_;
                        if (_e73 < _e74) {
                            // glimt_render_gpu/src/kernels/bvh.rs:156
                            let _e79 = met.distances[i_1];
                            distance_ = _e79;
                            // glimt_render_gpu/src/kernels/bvh.rs:157
                            next = child;
                        } else {
                            // glimt_render_gpu/src/kernels/bvh.rs:159
                            waiting = child;
                        }
                    }
                    // glimt_render_gpu/src/kernels/bvh.rs:161
                    let _e83 = waiting;
                    if (_e83 > 0u) {
                        // glimt_render_gpu/src/kernels/bvh.rs:162
                        let _e87 = waiting;
                        let _e88 = height;
                        stack[_e88] = _e87;
                        // glimt_render_gpu/src/kernels/bvh.rs:163
                        let _e92 = height;
                        height = (_e92 + 1u);
                    }
                }
                continuing {
                    let _e94 = counter_1;
                    counter_1 = (_e94 + 1u);
                }
            }
        } else {
            // glimt_render_gpu/src/kernels/bvh.rs:168
            let _e98 = at;
            let _e101 = best_1;
            let _e102 = visit_leaf((_e98 - 2147483648u), ray_10, reach_2, _e101, any_);
            best_1 = _e102;
            // glimt_render_gpu/src/kernels/bvh.rs:169
            let _e104 = best_1;
            if (any_ && (_e104 != 4294967295u)) {
                // glimt_render_gpu/src/kernels/bvh.rs:170
                let _e109 = best_1;
                return _e109;
            }
        }
        // glimt_render_gpu/src/kernels/bvh.rs:173
        let _e111 = next;
        if (_e111 == 0u) {
            // glimt_render_gpu/src/kernels/bvh.rs:174
            let _e115 = height;
            if (_e115 == 0u) {
                // glimt_render_gpu/src/kernels/bvh.rs:175
                let _e119 = best_1;
                return _e119;
            }
            // glimt_render_gpu/src/kernels/bvh.rs:177
            let _e122 = height;
            height = (_e122 - 1u);
            // glimt_render_gpu/src/kernels/bvh.rs:178
            let _e125 = height;
            let _e127 = stack[_e125];
            next = _e127;
        }
        // glimt_render_gpu/src/kernels/bvh.rs:180
        let _e129 = next;
        at = _e129;
    }
    return u32();
}

// glimt_render_gpu/src/kernels/bvh.rs:108
fn any_hit(ray_11: Ray, t_max_1: f32) -> bool {
    var t_3: f32;

    // glimt_render_gpu/src/kernels/bvh.rs:115
    t_3 = t_max_1;
    // glimt_render_gpu/src/kernels/bvh.rs:116
    let _e7 = traverse(ray_11, (&t_3), true);
    return (_e7 != 4294967295u);
}

// glimt_render_gpu/src/kernels/scene.rs:136
fn Scene_is_lit(point_2: ShadingPoint, direction_5: vec3<f32>, key_2: u32) -> bool {

    // glimt_render_gpu/src/kernels/scene.rs:137
    let _e6 = Ray_keyed(point_2.origin, direction_5, key_2);
    // glimt_render_gpu/src/kernels/scene.rs:138
    let _e9 = any_hit(_e6, 0x1.fffffep+127f);
    return !(_e9);
}

// glimt_render_gpu/src/kernels/estimator.rs:98
fn LightSample_traced(this_21: LightSample, point_3: ShadingPoint, key_3: u32) -> Reflected {
    var chosen_6: Reflected;

    // glimt_render_gpu/src/kernels/estimator.rs:99
    if !((max(max(this_21.contribution.x, this_21.contribution.y), this_21.contribution.z) > 0f)) {
        // glimt_render_gpu/src/kernels/estimator.rs:100
        return Reflected(vec3(0f), vec3(0f));
    }
    // glimt_render_gpu/src/kernels/estimator.rs:102
    let _e23 = Scene_is_lit(point_3, this_21.direction, key_3);
    if _e23 {
        // glimt_render_gpu/src/kernels/estimator.rs:103
        chosen_6 = Reflected(this_21.contribution, vec3(0f));
    } else {
        // glimt_render_gpu/src/kernels/estimator.rs:108
        chosen_6 = Reflected(vec3(0f), this_21.contribution);
    }
    let _e34 = chosen_6;
    return _e34;
}

// glimt_render_gpu/src/kernels/estimator.rs:37
fn Reflected_gather(this_22: ptr<function, Reflected>, light: Reflected) {

    // glimt_render_gpu/src/kernels/estimator.rs:38
    let _e6 = (*this_22).lit;
    (*this_22).lit = (_e6 + light.lit);
    // glimt_render_gpu/src/kernels/estimator.rs:39
    let _e11 = (*this_22).blocked;
    (*this_22).blocked = (_e11 + light.blocked);
    return;
}

// glimt_render_gpu/src/kernels/smc_gather.rs:18
fn estimate(seen_1: SmcPoint, log_normaliser: f32, floor_: f32, key_4: u32, env_size: vec2<u32>, env_rotation: vec2<f32>, particles_start: u32, particles_len: u32) -> Reflected {
    var sum: Reflected;
    var counter_2: u32;

    // glimt_render_gpu/src/kernels/smc_gather.rs:27
    sum = Reflected(vec3(0f), vec3(0f));
    // glimt_render_gpu/src/kernels/smc_gather.rs:28
    let _e17 = is_log_zero(log_normaliser);
    if _e17 {
        // glimt_render_gpu/src/kernels/smc_gather.rs:29
        let _e19 = sum;
        return _e19;
    }
    // glimt_render_gpu/src/kernels/smc_gather.rs:31
    let _e21 = SmcPoint_shading_point(seen_1);
    // glimt_render_gpu/src/kernels/smc_gather.rs:32
    let _e23 = LightLobe_of_point(_e21);
    // glimt_render_gpu/src/kernels/smc_gather.rs:33
    counter_2 = 0u;
    loop {
        let i_2 = counter_2;
        if (i_2 >= particles_len) {
            break;
        }
        // glimt_render_gpu/src/kernels/smc_gather.rs:34
        let particle = particles[(particles_start + i_2)];
        // glimt_render_gpu/src/kernels/smc_gather.rs:35
        let _e36 = is_log_zero(particle.log_weight);
        if !(_e36) {
            // glimt_render_gpu/src/kernels/smc_gather.rs:36
            let direction_7 = particle.state;
            // glimt_render_gpu/src/kernels/smc_gather.rs:37
            let _e41 = Environment_texel(env_size, env_rotation, direction_7);
            let _e42 = Environment_radiance(env_size, env_rotation, _e41);
            // glimt_render_gpu/src/kernels/smc_gather.rs:38
            let _e44 = luminance(_e42);
            let _e46 = LightLobe_value(_e23, direction_7);
            let target_ = ((_e44 + floor_) * _e46);
            // glimt_render_gpu/src/kernels/smc_gather.rs:39
            let density_1 = (target_ * exp(-((log_normaliser + particle.log_weight))));
            // glimt_render_gpu/src/kernels/smc_gather.rs:40
            let _e56 = ShadingFrame_to_local(_e21.frame, direction_7);
            // glimt_render_gpu/src/kernels/smc_gather.rs:41
            let _e58 = LightSample_new(_e21, direction_7, _e56, _e42, density_1);
            // glimt_render_gpu/src/kernels/smc_gather.rs:42
            let _e61 = LightSample_traced(_e58, _e21, (key_4 + i_2));
            Reflected_gather((&sum), _e61);
        }
        continuing {
            let _e62 = counter_2;
            counter_2 = (_e62 + 1u);
        }
    }
    // glimt_render_gpu/src/kernels/smc_gather.rs:45
    let _e66 = sum;
    return _e66;
}

// glimt_render_gpu/src/kernels/shade.rs:25
fn Vec4_of_surface(light_1: Reflected, _is_catcher: bool) -> vec4<f32> {

    // glimt_render_gpu/src/kernels/shade.rs:26
    return vec4<f32>(light_1.lit, 1f);
}

// glimt_sampling/src/sobol.rs:172
fn OwenSobol_new(seed: u32, frame: u32, pixel_1: u32, sample_index: u32) -> OwenSobol {

    // glimt_sampling/src/sobol.rs:173
    let _e6 = hash3_(seed, frame, pixel_1);
    let _e9 = hash2_(_e6, (sample_index >> 16u));
    return OwenSobol(_e9, (sample_index & 65535u), 0u);
}

// glimt_render_gpu/src/kernels/pattern.rs:136
fn PixelPattern_sobol_point(this_23: PixelPattern, purpose_2: u32, index_6: u32) -> OwenSobol {

    // glimt_render_gpu/src/kernels/pattern.rs:137
    let _e6 = hash2_(this_23.seed, purpose_2);
    let _e9 = OwenSobol_new(_e6, this_23.frame, this_23.pixel, index_6);
    return _e9;
}

// glimt_sampling/src/sobol.rs:21
fn owen_scramble_reversed(n_2: u32, scramble: u32) -> u32 {
    var x_3: u32;

    // glimt_sampling/src/sobol.rs:22
    x_3 = (n_2 ^ (n_2 * 1025551850u));
    // glimt_sampling/src/sobol.rs:23
    let _e9 = x_3;
    x_3 = (_e9 + scramble);
    // glimt_sampling/src/sobol.rs:24
    let _e12 = x_3;
    x_3 = (_e12 * ((scramble >> 16u) | 1u));
    // glimt_sampling/src/sobol.rs:25
    let _e19 = x_3;
    let _e22 = x_3;
    x_3 = (_e22 ^ (_e19 * 89287766u));
    // glimt_sampling/src/sobol.rs:26
    let _e25 = x_3;
    let _e26 = x_3;
    return (_e25 ^ (_e26 * 1403136100u));
}

// glimt_sampling/src/sobol.rs:104
fn shuffle(index_7: u32, seed_1: u32) -> u32 {

    // glimt_sampling/src/sobol.rs:105
    let _e7 = hash_u32_((seed_1 ^ 2043055690u));
    let _e8 = owen_scramble_reversed(reverseBits(index_7), _e7);
    return reverseBits(_e8);
}

// glimt_sampling/src/sobol.rs:56
fn pascal(index_8: u32) -> u32 {
    var x_4: u32;

    // glimt_sampling/src/sobol.rs:57
    x_4 = index_8;
    // glimt_sampling/src/sobol.rs:58
    let _e5 = x_4;
    let _e10 = x_4;
    x_4 = (_e10 ^ ((_e5 >> 1u) & 21845u));
    // glimt_sampling/src/sobol.rs:59
    let _e13 = x_4;
    let _e18 = x_4;
    x_4 = (_e18 ^ ((_e13 >> 2u) & 13107u));
    // glimt_sampling/src/sobol.rs:60
    let _e21 = x_4;
    let _e26 = x_4;
    x_4 = (_e26 ^ ((_e21 >> 4u) & 3855u));
    // glimt_sampling/src/sobol.rs:61
    let _e29 = x_4;
    let _e30 = x_4;
    return (_e29 ^ ((_e30 >> 8u) & 255u));
}

// glimt_sampling/src/sobol.rs:66
fn recurrence_2_(index_9: u32) -> u32 {
    var bits: u32;
    var v0_: u32;
    var v1_: u32;
    var sum_1: u32;
    var counter_3: i32;

    // glimt_sampling/src/sobol.rs:67
    bits = index_9;
    // glimt_sampling/src/sobol.rs:68
    v0_ = 1u;
    // glimt_sampling/src/sobol.rs:69
    v1_ = 3u;
    // glimt_sampling/src/sobol.rs:70
    sum_1 = 0u;
    // glimt_sampling/src/sobol.rs:72
    counter_3 = 0i;
    loop {
        let _e17 = counter_3;
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
            let _e44 = counter_3;
            counter_3 = (_e44 + 1i);
        }
    }
    // glimt_sampling/src/sobol.rs:79
    let _e48 = sum_1;
    return _e48;
}

// glimt_sampling/src/sobol.rs:84
fn recurrence_3_(index_10: u32) -> u32 {
    var bits_1: u32;
    var v0_1: u32;
    var v1_1: u32;
    var v2_: u32;
    var sum_2: u32;
    var counter_4: i32;

    // glimt_sampling/src/sobol.rs:85
    bits_1 = index_10;
    // glimt_sampling/src/sobol.rs:86
    v0_1 = 1u;
    // glimt_sampling/src/sobol.rs:87
    v1_1 = 3u;
    // glimt_sampling/src/sobol.rs:88
    v2_ = 4u;
    // glimt_sampling/src/sobol.rs:89
    sum_2 = 0u;
    // glimt_sampling/src/sobol.rs:90
    counter_4 = 0i;
    loop {
        let _e20 = counter_4;
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
            let _e49 = counter_4;
            counter_4 = (_e49 + 1i);
        }
    }
    // glimt_sampling/src/sobol.rs:98
    let _e53 = sum_2;
    return _e53;
}

// glimt_sampling/src/sobol.rs:43
fn sobol_reversed(index_11: u32, dimension: u32) -> u32 {
    var chosen_7: u32;

    // glimt_sampling/src/sobol.rs:44
    let index_15 = (index_11 & 65535u);
    // glimt_sampling/src/sobol.rs:45
    let _e8 = (dimension & 3u);
    if (_e8 == 0u) {
        // glimt_sampling/src/sobol.rs:47
        chosen_7 = index_15;
    } else {
        if (_e8 == 1u) {
            // glimt_sampling/src/sobol.rs:48
            let _e16 = pascal(index_15);
            chosen_7 = _e16;
        } else {
            if (_e8 == 2u) {
                // glimt_sampling/src/sobol.rs:49
                let _e20 = recurrence_2_(index_15);
                chosen_7 = _e20;
            } else {
                // glimt_sampling/src/sobol.rs:50
                let _e22 = recurrence_3_(index_15);
                chosen_7 = _e22;
            }
        }
    }
    let _e23 = chosen_7;
    return _e23;
}

// glimt_sampling/src/sobol.rs:110
fn scramble_1(reversed: u32, dimension_1: u32, seed_2: u32) -> u32 {
    var chosen_8: u32;

    // glimt_sampling/src/sobol.rs:111
    let _e6 = (dimension_1 & 3u);
    if (_e6 == 0u) {
        // glimt_sampling/src/sobol.rs:112
        chosen_8 = 2435803578u;
    } else {
        if (_e6 == 1u) {
            // glimt_sampling/src/sobol.rs:113
            chosen_8 = 391059627u;
        } else {
            if (_e6 == 2u) {
                // glimt_sampling/src/sobol.rs:114
                chosen_8 = 1763603146u;
            } else {
                // glimt_sampling/src/sobol.rs:115
                chosen_8 = 3020734904u;
            }
        }
    }
    let salt = chosen_8;
    // glimt_sampling/src/sobol.rs:118
    let _e27 = hash_u32_(((seed_2 * 2626628923u) ^ salt));
    // glimt_sampling/src/sobol.rs:119
    let _e29 = owen_scramble_reversed(reversed, _e27);
    return reverseBits(_e29);
}

// glimt_sampling/src/sobol.rs:191
fn OwenSobol_next_uvec2_(this_24: ptr<function, OwenSobol>) -> vec2<u32> {

    // glimt_sampling/src/sobol.rs:192
    let _e4 = (*this_24).dimension;
    let dimension_2 = ((_e4 + 1u) & 4294967294u);
    // glimt_sampling/src/sobol.rs:193
    (*this_24).dimension = (dimension_2 + 2u);
    // glimt_sampling/src/sobol.rs:194
    let _e15 = (*this_24).seed;
    let _e18 = hash2_(_e15, (dimension_2 >> 2u));
    // glimt_sampling/src/sobol.rs:195
    let _e21 = (*this_24).index;
    let _e22 = shuffle(_e21, _e18);
    // glimt_sampling/src/sobol.rs:196
    let _e24 = sobol_reversed(_e22, dimension_2);
    let _e25 = scramble_1(_e24, dimension_2, _e18);
    let _e28 = sobol_reversed(_e22, (dimension_2 + 1u));
    let _e31 = scramble_1(_e28, (dimension_2 + 1u), _e18);
    return vec2<u32>(_e25, _e31);
}

// glimt_sampling/src/hash.rs:50
fn hash_uvec4_(v_3: vec4<u32>) -> vec4<u32> {
    var x_5: u32;
    var y: u32;
    var z: u32;
    var w: u32;

    // glimt_sampling/src/hash.rs:51
    let _e4 = hash_u32_(v_3.x);
    x_5 = ((_e4 * 1664525u) + 1013904223u);
    // glimt_sampling/src/hash.rs:54
    let _e12 = hash_u32_(v_3.y);
    y = ((_e12 * 1664525u) + 1013904223u);
    // glimt_sampling/src/hash.rs:57
    let _e20 = hash_u32_(v_3.z);
    z = ((_e20 * 1664525u) + 1013904223u);
    // glimt_sampling/src/hash.rs:60
    let _e28 = hash_u32_(v_3.w);
    w = ((_e28 * 1664525u) + 1013904223u);
    // glimt_sampling/src/hash.rs:64
    let _e35 = x_5;
    let _e36 = y;
    let _e37 = w;
    x_5 = (_e35 + (_e36 * _e37));
    // glimt_sampling/src/hash.rs:65
    let _e41 = y;
    let _e42 = z;
    let _e43 = x_5;
    y = (_e41 + (_e42 * _e43));
    // glimt_sampling/src/hash.rs:66
    let _e47 = z;
    let _e48 = x_5;
    let _e49 = y;
    z = (_e47 + (_e48 * _e49));
    // glimt_sampling/src/hash.rs:67
    let _e53 = w;
    let _e54 = y;
    let _e55 = z;
    w = (_e53 + (_e54 * _e55));
    // glimt_sampling/src/hash.rs:68
    let _e59 = x_5;
    let _e62 = x_5;
    x_5 = (_e62 ^ (_e59 >> 16u));
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
    let _e83 = x_5;
    let _e84 = y;
    let _e85 = w;
    x_5 = (_e83 + (_e84 * _e85));
    // glimt_sampling/src/hash.rs:73
    let _e89 = y;
    let _e90 = z;
    let _e91 = x_5;
    y = (_e89 + (_e90 * _e91));
    // glimt_sampling/src/hash.rs:74
    let _e95 = z;
    let _e96 = x_5;
    let _e97 = y;
    z = (_e95 + (_e96 * _e97));
    // glimt_sampling/src/hash.rs:75
    let _e101 = w;
    let _e102 = y;
    let _e103 = z;
    w = (_e101 + (_e102 * _e103));
    // glimt_sampling/src/hash.rs:76
    let _e107 = x_5;
    let _e108 = x_5;
    let _e112 = y;
    let _e113 = y;
    let _e117 = z;
    let _e118 = z;
    let _e122 = w;
    let _e123 = w;
    return vec4<u32>((_e107 ^ (_e108 >> 16u)), (_e112 ^ (_e113 >> 16u)), (_e117 ^ (_e118 >> 16u)), (_e122 ^ (_e123 >> 16u)));
}

// glimt_sampling/src/xoshiro.rs:28
fn Xoshiro128PlusPlus_from_state(state: vec4<u32>) -> Xoshiro128PlusPlus {

    // glimt_sampling/src/xoshiro.rs:29
    let any_1 = (((state.x | state.y) | state.z) | state.w);
    // glimt_sampling/src/xoshiro.rs:30
    if (any_1 == 0u) {
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

// glimt_render_gpu/src/kernels/pattern.rs:141
fn PixelPattern_generator(this_25: PixelPattern, purpose_3: u32, index_12: u32) -> Xoshiro128PlusPlus {

    // glimt_render_gpu/src/kernels/pattern.rs:142
    let _e6 = hash3_(this_25.seed, purpose_3, index_12);
    let _e9 = Xoshiro128PlusPlus_stream(_e6, this_25.frame, this_25.pixel);
    return _e9;
}

// glimt_sampling/src/xoshiro.rs:56
fn Xoshiro128PlusPlus_next_u32_(this_26: ptr<function, Xoshiro128PlusPlus>) -> u32 {

    // glimt_sampling/src/xoshiro.rs:57
    let s = (*this_26).state;
    // glimt_sampling/src/xoshiro.rs:58
    let _e8 = (s.x + s.w);
    let result = (((_e8 << 7u) | (_e8 >> ((0u - 7u) & 31u))) + s.x);
    // glimt_sampling/src/xoshiro.rs:59
    let z_3 = (s.z ^ s.x);
    // glimt_sampling/src/xoshiro.rs:60
    let w_3 = (s.w ^ s.y);
    // glimt_sampling/src/xoshiro.rs:61
    (*this_26).state = vec4<u32>((s.x ^ w_3), (s.y ^ z_3), (z_3 ^ (s.y << 9u)), ((w_3 << 11u) | (w_3 >> ((0u - 11u) & 31u))));
    // glimt_sampling/src/xoshiro.rs:62
    return result;
}

// glimt_sampling/src/uniform.rs:34
fn Xoshiro128PlusPlus_next_uvec2_(this_27: ptr<function, Xoshiro128PlusPlus>) -> vec2<u32> {

    // glimt_sampling/src/uniform.rs:35
    let _e3 = Xoshiro128PlusPlus_next_u32_(this_27);
    // glimt_sampling/src/uniform.rs:36
    let _e5 = Xoshiro128PlusPlus_next_u32_(this_27);
    // glimt_sampling/src/uniform.rs:37
    return vec2<u32>(_e3, _e5);
}

// glimt_render_gpu/src/kernels/pattern.rs:221
fn permute(index_13: u32, length_: u32, key_5: u32) -> u32 {
    var x_6: u32;
    var round_key: u32;
    var counter_5: i32;

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
    x_6 = index_13;
    // glimt_render_gpu/src/kernels/pattern.rs:228
    loop {
        // glimt_render_gpu/src/kernels/pattern.rs:229
        round_key = key_5;
        // glimt_render_gpu/src/kernels/pattern.rs:230
        counter_5 = 0i;
        loop {
            let _e31 = counter_5;
            if (_e31 >= 3i) {
                break;
            }
            // glimt_render_gpu/src/kernels/pattern.rs:231
            let _e34 = round_key;
            let _e35 = hash_u32_(_e34);
            round_key = _e35;
            // glimt_render_gpu/src/kernels/pattern.rs:233
            let _e37 = x_6;
            let _e38 = round_key;
            x_6 = (((_e37 ^ _e38) * 2654435761u) & mask);
            // glimt_render_gpu/src/kernels/pattern.rs:234
            let _e44 = x_6;
            let _e46 = (bits_2 / 2u);
            let _e56 = x_6;
            x_6 = (_e56 ^ (_e44 >> (select(_e46, (_e46 + 1u), ((bits_2 % 2u) != 0u)) & 31u)));
            continuing {
                let _e58 = counter_5;
                counter_5 = (_e58 + 1i);
            }
        }
        // glimt_render_gpu/src/kernels/pattern.rs:236
        let _e62 = x_6;
        if (_e62 < length_) {
            // glimt_render_gpu/src/kernels/pattern.rs:237
            let _e65 = x_6;
            let _e67 = hash_u32_(~(key_5));
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
fn jittered_pair(index_14: u32, count_1: u32, jitter_1: vec2<u32>, key_6: u32) -> vec2<u32> {

    // glimt_render_gpu/src/kernels/pattern.rs:193
    let columns = max(u32(sqrt(f32(count_1))), 1u);
    // glimt_render_gpu/src/kernels/pattern.rs:194
    let _e12 = (count_1 / columns);
    let rows = select(_e12, (_e12 + 1u), ((count_1 % columns) != 0u));
    // glimt_render_gpu/src/kernels/pattern.rs:195
    let _e21 = hash2_(key_6, 1u);
    let _e22 = permute(index_14, count_1, _e21);
    // glimt_render_gpu/src/kernels/pattern.rs:196
    let _e26 = hash2_(key_6, 2u);
    let _e27 = permute((_e22 % columns), columns, _e26);
    // glimt_render_gpu/src/kernels/pattern.rs:197
    let _e31 = hash2_(key_6, 3u);
    let _e32 = permute((_e22 / columns), rows, _e31);
    // glimt_render_gpu/src/kernels/pattern.rs:198
    let _e38 = stratum(((_e27 * rows) + _e32), (columns * rows), jitter_1.x);
    let _e40 = stratum(_e22, count_1, jitter_1.y);
    return vec2<u32>(_e38, _e40);
}

// glimt_render_gpu/src/kernels/pattern.rs:67
fn PixelPattern_pair(this_28: PixelPattern, purpose_4: u32, sample: u32, samples: u32) -> vec2<u32> {
    var borrowed: OwenSobol;
    var borrowed_1: Xoshiro128PlusPlus;

    // glimt_render_gpu/src/kernels/pattern.rs:68
    let index_16 = ((this_28.ray * samples) + sample);
    // glimt_render_gpu/src/kernels/pattern.rs:69
    if (this_28.kind == 0u) {
        // glimt_render_gpu/src/kernels/pattern.rs:70
        let _e14 = PixelPattern_sobol_point(this_28, purpose_4, index_16);
        borrowed = _e14;
        let _e16 = OwenSobol_next_uvec2_((&borrowed));
        return _e16;
    }
    // glimt_render_gpu/src/kernels/pattern.rs:72
    let _e18 = PixelPattern_generator(this_28, purpose_4, index_16);
    borrowed_1 = _e18;
    let _e20 = Xoshiro128PlusPlus_next_uvec2_((&borrowed_1));
    // glimt_render_gpu/src/kernels/pattern.rs:73
    if (this_28.kind == 1u) {
        // glimt_render_gpu/src/kernels/pattern.rs:74
        return _e20;
    }
    // glimt_render_gpu/src/kernels/pattern.rs:76
    let _e29 = PixelPattern_key(this_28, purpose_4);
    let _e30 = jittered_pair(index_16, (this_28.rays * samples), _e20, _e29);
    return _e30;
}

// glimt_sampling/src/uniform.rs:22
fn unit_vec2_(u_3: vec2<u32>) -> vec2<f32> {

    // glimt_sampling/src/uniform.rs:23
    let _e4 = unit_f32_(u_3.x);
    let _e6 = unit_f32_(u_3.y);
    return vec2<f32>(_e4, _e6);
}

// glimt_render_gpu/src/kernels/camera.rs:23
fn CameraView_direction(this_29: CameraView, p: vec2<f32>, size_5: vec2<u32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/camera.rs:24
    let x_10 = (((2f * p.x) / f32(size_5.x)) - 1f);
    // glimt_render_gpu/src/kernels/camera.rs:25
    let y_4 = (((2f * p.y) / f32(size_5.y)) - 1f);
    // glimt_render_gpu/src/kernels/camera.rs:26
    return normalize(((this_29.forward + (this_29.right * x_10)) - (this_29.up * y_4)));
}

// glimt_render_gpu/src/kernels/frame.rs:161
fn FrameParams_direction(this_30: FrameParams, pixel_3: u32, place_1: vec2<f32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/frame.rs:162
    let corner = vec2<f32>(vec2<u32>((pixel_3 % this_30.width), (pixel_3 / this_30.width)));
    // glimt_render_gpu/src/kernels/frame.rs:163
    let view = CameraView(this_30.eye, this_30.forward, this_30.right, this_30.up);
    // glimt_render_gpu/src/kernels/frame.rs:169
    let _e22 = CameraView_direction(view, (corner + place_1), vec2<u32>(this_30.width, this_30.height));
    return _e22;
}

// glimt_render_gpu/src/kernels/frame.rs:144
fn FrameParams_camera_ray(this_31: FrameParams, pattern: PixelPattern) -> Ray {
    var chosen_9: vec2<f32>;

    // glimt_render_gpu/src/kernels/frame.rs:145
    let film = PixelPattern(pattern.kind, pattern.seed, this_31.film_frame, pattern.pixel, pattern.ray, pattern.rays);
    // glimt_render_gpu/src/kernels/frame.rs:149
    if (this_31.filter_ == 1u) {
        // glimt_render_gpu/src/kernels/frame.rs:150
        chosen_9 = vec2(0.5f);
    } else {
        // glimt_render_gpu/src/kernels/frame.rs:152
        let _e23 = PixelPattern_pair(film, 1u, 0u, 1u);
        let _e24 = unit_vec2_(_e23);
        chosen_9 = _e24;
    }
    let place_2 = chosen_9;
    // glimt_render_gpu/src/kernels/frame.rs:154
    let _e28 = FrameParams_direction(this_31, pattern.pixel, place_2);
    // glimt_render_gpu/src/kernels/frame.rs:155
    let _e32 = PixelPattern_ray_key(film, 8u);
    let _e33 = Ray_keyed(this_31.eye, _e28, _e32);
    return _e33;
}

// glimt_render_gpu/src/kernels/environment.rs:56
fn Environment_map(size_6: vec2<u32>, rotation_3: vec2<f32>) -> Returned_Environment_map {

    // glimt_render_gpu/src/kernels/environment.rs:57
    return Returned_Environment_map(size_6, rotation_3);
}

// glimt_render_gpu/src/kernels/environment.rs:146
fn bilinear(size_7: vec2<u32>, d_3: vec3<f32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/environment.rs:147
    let _e4 = direction_to_uv(d_3);
    let p_1 = ((_e4 * vec2<f32>(size_7)) - vec2(0.5f));
    // glimt_render_gpu/src/kernels/environment.rs:149
    let next_1 = vec2<u32>((p_1 + vec2(1f)));
    // glimt_render_gpu/src/kernels/environment.rs:150
    let f = ((p_1 + vec2(1f)) - vec2<f32>(next_1));
    // glimt_render_gpu/src/kernels/environment.rs:151
    let x0_ = (((next_1.x + size_7.x) - 1u) % size_7.x);
    // glimt_render_gpu/src/kernels/environment.rs:152
    let x1_1 = (next_1.x % size_7.x);
    // glimt_render_gpu/src/kernels/environment.rs:153
    let row0_1 = ((max(next_1.y, 1u) * size_7.x) - size_7.x);
    // glimt_render_gpu/src/kernels/environment.rs:154
    let row1_1 = (min(next_1.y, (size_7.y - 1u)) * size_7.x);
    // glimt_render_gpu/src/kernels/environment.rs:155
    let _e53 = env_texels[(row0_1 + x0_)];
    let _e57 = env_texels[(row0_1 + x1_1)];
    let upper_1 = ((_e53 * (1f - f.x)) + (_e57 * f.x));
    // glimt_render_gpu/src/kernels/environment.rs:156
    let _e68 = env_texels[(row1_1 + x0_)];
    let _e72 = env_texels[(row1_1 + x1_1)];
    let lower_1 = ((_e68 * (1f - f.x)) + (_e72 * f.x));
    // glimt_render_gpu/src/kernels/environment.rs:157
    return ((upper_1 * (1f - f.y)) + (lower_1 * f.y)).xyz;
}

// glimt_render_gpu/src/kernels/environment.rs:46
fn RadianceMap_background(size_8: vec2<u32>, rotation_4: vec2<f32>, direction_6: vec3<f32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/environment.rs:47
    let to_map = vec2<f32>(rotation_4.x, -(rotation_4.y));
    // glimt_render_gpu/src/kernels/environment.rs:48
    let _e10 = rotate_z(direction_6, to_map);
    let _e11 = bilinear(size_8, _e10);
    return _e11;
}

// glimt_render_gpu/src/kernels/shade.rs:30
fn Vec4_of_background(ray_12: Ray, frame_2: FrameParams, map_size: vec2<u32>, map_rotation: vec2<f32>) -> vec4<f32> {

    // glimt_render_gpu/src/kernels/shade.rs:31
    if (frame_2.background == 0u) {
        // glimt_render_gpu/src/kernels/shade.rs:32
        let _e11 = RadianceMap_background(map_size, map_rotation, ray_12.direction);
        return vec4<f32>(_e11, 1f);
    }
    // glimt_render_gpu/src/kernels/shade.rs:34
    return vec4(0f);
}

// glimt_render_gpu/src/kernels/smc_gather.rs:51
fn gather_smc_1(ray_13: u32, frame_3: FrameParams, floor_1: f32, particles_per_ray: u32, env_size_1: vec2<u32>, env_rotation_1: vec2<f32>) -> vec4<f32> {
    var light_2: Reflected;

    // glimt_render_gpu/src/kernels/smc_gather.rs:62
    let seen_2 = points[ray_13];
    // glimt_render_gpu/src/kernels/smc_gather.rs:63
    let _e12 = SmcPoint_is_hit(seen_2);
    if _e12 {
        // glimt_render_gpu/src/kernels/smc_gather.rs:64
        let first_4 = (ray_13 * particles_per_ray);
        // glimt_render_gpu/src/kernels/smc_gather.rs:65
        // glimt_render_gpu/src/kernels/smc_gather.rs:66
        let log_normaliser_1 = states[ray_13].log_normaliser;
        // glimt_render_gpu/src/kernels/smc_gather.rs:67
        let _e24 = FrameParams_pattern_of(frame_3, ray_13);
        let _e26 = PixelPattern_ray_key(_e24, 9u);
        // glimt_render_gpu/src/kernels/smc_gather.rs:68
        let _e28 = estimate(seen_2, log_normaliser_1, floor_1, _e26, env_size_1, env_rotation_1, first_4, ((first_4 + particles_per_ray) - first_4));
        light_2 = _e28;
        // glimt_render_gpu/src/kernels/smc_gather.rs:69
        let _e33 = light_2.lit;
        light_2.lit = (_e33 + seen_2.emission);
        // glimt_render_gpu/src/kernels/smc_gather.rs:70
        let _e36 = light_2;
        let _e40 = Vec4_of_surface(_e36, (seen_2.catcher != 0u));
        return _e40;
    }
    // glimt_render_gpu/src/kernels/smc_gather.rs:72
    let _e42 = FrameParams_pattern_of(frame_3, ray_13);
    let _e43 = FrameParams_camera_ray(frame_3, _e42);
    // glimt_render_gpu/src/kernels/smc_gather.rs:73
    let _e45 = Environment_map(env_size_1, env_rotation_1);
    let _e48 = Vec4_of_background(_e43, frame_3, _e45.value_size, _e45.value_rotation);
    return _e48;
}

@compute @workgroup_size(64, 1, 1) 
fn gather_smc(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let local = ((id.y * (groups.x * 64u)) + id.x);
    let _e11 = params.count;
    if (local >= _e11) {
        return;
    }
    let _e14 = params.first;
    let _e17 = params.frame;
    let _e19 = params.floor;
    let _e21 = params.particles_per_ray;
    let _e23 = params.env_size;
    let _e25 = params.env_rotation;
    let _e26 = gather_smc_1((_e14 + local), _e17, _e19, _e21, _e23, _e25);
    out[local] = _e26;
}
