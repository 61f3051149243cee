// Made from Rust by naga-front-rust; do not edit. This command writes it: cargo run --release -p glimt-generate

struct BvhNode {
    min: vec3<f32>,
    count: u32,
    max: vec3<f32>,
    first: u32,
}

struct Triangle {
    v0_: vec3<f32>,
    material: u32,
    v1_: vec3<f32>,
    object: u32,
    v2_: vec3<f32>,
    ray_offset: f32,
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
}

struct LayerSample {
    radiance: vec3<f32>,
    alpha: f32,
    blocked: vec3<f32>,
    catcher: f32,
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
var<storage> points: array<SmcPoint>;
@group(0) @binding(5) 
var<storage> states: array<RayState>;
@group(0) @binding(6) 
var<storage> particles: array<Particle>;
@group(0) @binding(7) 
var<storage, read_write> out: array<LayerSample>;
@group(0) @binding(0) 
var<uniform> params: Params;

// glimt_render_gpu/src/kernels/smc_point.rs:67
fn SmcPoint_is_hit(this_: SmcPoint) -> bool {

    // glimt_render_gpu/src/kernels/smc_point.rs:68
    return (this_.depth > 0f);
}

// glimt_smc/src/particle.rs:33
fn is_log_zero(log_weight: f32) -> bool {

    // glimt_smc/src/particle.rs:34
    return !((log_weight > (0.5f * -1000000000000000000000000000000f)));
}

// glimt_sampling/src/math.rs:45
fn ShadingFrame_from_normal(n: vec3<f32>) -> ShadingFrame {

    // glimt_sampling/src/math.rs:46
    let sign_ = bitcast<f32>(((bitcast<u32>(1f) & 2147483647u) | (bitcast<u32>(n.z) & 2147483648u)));
    // glimt_sampling/src/math.rs:47
    let a_3 = (-1f / (sign_ + n.z));
    // glimt_sampling/src/math.rs:48
    let c_2 = ((n.x * n.y) * a_3);
    // glimt_sampling/src/math.rs:49
    return ShadingFrame(vec3<f32>((1f + (((sign_ * n.x) * n.x) * a_3)), (sign_ * c_2), (-(sign_) * n.x)), vec3<f32>(c_2, (sign_ + ((n.y * n.y) * a_3)), -(n.y)), n);
}

// glimt_sampling/src/math.rs:66
fn ShadingFrame_to_local(this_1: ShadingFrame, v: vec3<f32>) -> vec3<f32> {

    // glimt_sampling/src/math.rs:67
    return vec3<f32>(dot(v, this_1.t), dot(v, this_1.b), dot(v, this_1.n));
}

// glimt_render_gpu/src/kernels/smc_point.rs:74
fn SmcPoint_shading_point(this_2: SmcPoint) -> ShadingPoint {

    // glimt_render_gpu/src/kernels/smc_point.rs:75
    let _e4 = ShadingFrame_from_normal(this_2.normal);
    // glimt_render_gpu/src/kernels/smc_point.rs:76
    let _e9 = ShadingFrame_to_local(_e4, this_2.wo);
    return ShadingPoint(this_2.origin, this_2.geometric_normal, _e4, _e9, BlinnPhong(this_2.diffuse, this_2.specular, this_2.exponent));
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

// glimt_render_gpu/src/kernels/environment.rs:78
fn Environment_to_map(size: vec2<u32>, rotation: vec2<f32>, direction: vec3<f32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/environment.rs:79
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
        let v_2 = chosen;
        // glimt_probe/src/latlong.rs:49
        return vec2<f32>(0.5f, v_2);
    }
    // glimt_probe/src/latlong.rs:52
    let v_3 = (atan2(horizontal, d_1.z) * 0.31830987f);
    // glimt_probe/src/latlong.rs:53
    let u_2 = (0.5f - ((0.5f * 0.31830987f) * atan2(d_1.y, d_1.x)));
    // glimt_probe/src/latlong.rs:54
    if (u_2 < 1f) {
        chosen_1 = max(u_2, 0f);
    } else {
        chosen_1 = 0f;
    }
    let _e47 = chosen_1;
    return vec2<f32>(_e47, clamp(v_3, 0f, 1f));
}

// glimt_probe/src/latlong.rs:68
fn direction_to_texel(d_2: vec3<f32>, size_1: vec2<u32>) -> vec2<u32> {

    // glimt_probe/src/latlong.rs:69
    let size_6 = max(size_1, vec2(1u));
    // glimt_probe/src/latlong.rs:70
    let _e8 = direction_to_uv(d_2);
    let position = (_e8 * vec2<f32>(size_6));
    // glimt_probe/src/latlong.rs:71
    return min(vec2<u32>(position), (size_6 - vec2(1u)));
}

// glimt_render_gpu/src/kernels/environment.rs:85
fn Environment_texel(size_2: vec2<u32>, rotation_1: vec2<f32>, direction_1: vec3<f32>) -> vec2<u32> {

    // glimt_render_gpu/src/kernels/environment.rs:86
    let _e5 = Environment_to_map(size_2, rotation_1, direction_1);
    let _e6 = direction_to_texel(_e5, size_2);
    return _e6;
}

// glimt_render_gpu/src/kernels/environment.rs:92
fn Environment_radiance(size_3: vec2<u32>, rotation_2: vec2<f32>, texel: vec2<u32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/environment.rs:93
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
        let t_1 = (sin2_theta / (2f - sin2_theta));
        // glimt_brdf/src/lobe.rs:63
        let t2_ = (t_1 * t_1);
        // glimt_brdf/src/lobe.rs:64
        chosen_2 = ((-2f * t_1) * (1f + (t2_ * ((1f / 3f) + (t2_ * (1f / 5f))))));
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
fn HalfVector_lobe(this_3: HalfVector, exponent_2: f32) -> f32 {

    // glimt_brdf/src/lobe.rs:33
    let _e6 = cosine_power(this_3.cos2_theta, this_3.sin2_theta, exponent_2);
    return _e6;
}

// glimt_brdf/src/blinn_phong.rs:59
fn BlinnPhong_eval(this_4: BlinnPhong, wo_1: vec3<f32>, wi_1: vec3<f32>) -> vec3<f32> {

    // glimt_brdf/src/blinn_phong.rs:60
    if ((wo_1.z <= 0f) || (wi_1.z <= 0f)) {
        // glimt_brdf/src/blinn_phong.rs:61
        return vec3(0f);
    }
    // glimt_brdf/src/blinn_phong.rs:63
    let diffuse = (this_4.diffuse * 0.31830987f);
    // glimt_brdf/src/blinn_phong.rs:65
    if (max(max(this_4.specular.x, this_4.specular.y), this_4.specular.z) <= 0f) {
        // glimt_brdf/src/blinn_phong.rs:66
        return diffuse;
    }
    // glimt_brdf/src/blinn_phong.rs:68
    let _e31 = normalisation(this_4.exponent);
    let _e32 = HalfVector_new(wo_1, wi_1);
    let _e34 = HalfVector_lobe(_e32, this_4.exponent);
    let lobe = (_e31 * _e34);
    // glimt_brdf/src/blinn_phong.rs:69
    return (diffuse + (this_4.specular * lobe));
}

// glimt_render_gpu/src/kernels/light_target.rs:57
fn LightLobe_value(this_5: LightLobe, direction_2: vec3<f32>) -> f32 {

    // glimt_render_gpu/src/kernels/light_target.rs:58
    let _e5 = ShadingFrame_to_local(this_5.frame, direction_2);
    // glimt_render_gpu/src/kernels/light_target.rs:59
    if !((_e5.z > 0f)) {
        // glimt_render_gpu/src/kernels/light_target.rs:60
        return 0f;
    }
    // glimt_render_gpu/src/kernels/light_target.rs:62
    let _e16 = BlinnPhong_eval(this_5.brdf, this_5.wo, _e5);
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

// glimt_render_gpu/src/kernels/ray.rs:48
fn inverse(x: f32) -> f32 {

    // glimt_render_gpu/src/kernels/ray.rs:49
    return (1f / bitcast<f32>(((bitcast<u32>(max(abs(x), 0.000000000000000001f)) & 2147483647u) | (bitcast<u32>(x) & 2147483648u))));
}

// glimt_render_gpu/src/kernels/ray.rs:34
fn Ray_new(origin: vec3<f32>, direction_4: vec3<f32>) -> Ray {

    // glimt_render_gpu/src/kernels/ray.rs:35
    let _e5 = inverse(direction_4.x);
    let _e7 = inverse(direction_4.y);
    let _e9 = inverse(direction_4.z);
    return Ray(origin, direction_4, vec3<f32>(_e5, _e7, _e9));
}

// glimt_render_gpu/src/kernels/bvh.rs:29
fn box_distance(node: BvhNode, ray: Ray) -> f32 {
    var chosen_3: f32;

    // glimt_render_gpu/src/kernels/bvh.rs:30
    let to_min = ((node.min - ray.origin) * ray.inverse_direction);
    // glimt_render_gpu/src/kernels/bvh.rs:31
    let to_max = ((node.max - ray.origin) * ray.inverse_direction);
    // glimt_render_gpu/src/kernels/bvh.rs:32
    let _e16 = min(to_min, to_max);
    let near_1 = max(max(_e16.x, _e16.y), _e16.z);
    // glimt_render_gpu/src/kernels/bvh.rs:33
    let _e23 = max(to_min, to_max);
    let far_1 = (min(min(_e23.x, _e23.y), _e23.z) * 1.0000004f);
    // glimt_render_gpu/src/kernels/bvh.rs:34
    if ((far_1 >= near_1) && (far_1 >= 0f)) {
        // glimt_render_gpu/src/kernels/bvh.rs:35
        chosen_3 = near_1;
    } else {
        // glimt_render_gpu/src/kernels/bvh.rs:37
        chosen_3 = 0x1.fffffep+127f;
    }
    let _e40 = chosen_3;
    return _e40;
}

// glimt_render_gpu/src/kernels/triangle.rs:75
fn edge_functions(a: vec3<f32>, b: vec3<f32>, c: vec3<f32>, direction_5: vec3<f32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/triangle.rs:76
    return vec3<f32>(dot(cross((b - c), (b + c)), direction_5), dot(cross((c - a), (c + a)), direction_5), dot(cross((a - b), (a + b)), direction_5));
}

// glimt_render_gpu/src/kernels/triangle.rs:88
fn intersect(triangle: Triangle, ray_1: Ray, t_max: f32) -> f32 {
    var chosen_4: f32;

    // glimt_render_gpu/src/kernels/triangle.rs:89
    let a_4 = (triangle.v0_ - ray_1.origin);
    // glimt_render_gpu/src/kernels/triangle.rs:90
    let b_3 = (triangle.v1_ - ray_1.origin);
    // glimt_render_gpu/src/kernels/triangle.rs:91
    let c_3 = (triangle.v2_ - ray_1.origin);
    // glimt_render_gpu/src/kernels/triangle.rs:92
    let _e18 = edge_functions(a_4, b_3, c_3, ray_1.direction);
    // glimt_render_gpu/src/kernels/triangle.rs:93
    if ((min(min(_e18.x, _e18.y), _e18.z) < 0f) && (max(max(_e18.x, _e18.y), _e18.z) > 0f)) {
        // glimt_render_gpu/src/kernels/triangle.rs:94
        return 0x1.fffffep+127f;
    }
    // glimt_render_gpu/src/kernels/triangle.rs:96
    let normal = cross((c_3 - a_4), (a_4 - b_3));
    // glimt_render_gpu/src/kernels/triangle.rs:97
    let slope = dot(normal, ray_1.direction);
    // glimt_render_gpu/src/kernels/triangle.rs:98
    if (slope == 0f) {
        // glimt_render_gpu/src/kernels/triangle.rs:99
        return 0x1.fffffep+127f;
    }
    // glimt_render_gpu/src/kernels/triangle.rs:101
    let t_2 = (dot(a_4, normal) / slope);
    // glimt_render_gpu/src/kernels/triangle.rs:102
    if ((t_2 > 0f) && (t_2 < t_max)) {
        chosen_4 = t_2;
    } else {
        chosen_4 = 0x1.fffffep+127f;
    }
    let _e59 = chosen_4;
    return _e59;
}

// glimt_render_gpu/src/kernels/triangle.rs:38
fn Triangle_is_catcher(this_6: Triangle) -> bool {

    // glimt_render_gpu/src/kernels/triangle.rs:39
    return ((this_6.object & 2147483648u) != 0u);
}

// glimt_render_gpu/src/kernels/bvh.rs:145
fn visit_leaf(leaf: BvhNode, ray_2: Ray, reach: ptr<function, f32>, best: u32, no_catcher: bool) -> u32 {
    var nearest: u32;
    var counter: u32;
    var both: bool;
    var both_1: bool;

    // glimt_render_gpu/src/kernels/bvh.rs:153
    nearest = best;
    // glimt_render_gpu/src/kernels/bvh.rs:154
    counter = leaf.first;
    loop {
        let i = counter;
        if (i >= (leaf.first + leaf.count)) {
            break;
        }
        // glimt_render_gpu/src/kernels/bvh.rs:155
        let _e19 = scene_triangles[i];
        let _e20 = (*reach);
        let _e21 = intersect(_e19, ray_2, _e20);
        // glimt_render_gpu/src/kernels/bvh.rs:157
        let _e23 = (*reach);
        let _e24 = (_e21 < _e23);
        both = _e24;
        if _e24 {
            both_1 = no_catcher;
            if no_catcher {
                let _e29 = scene_triangles[i];
                let _e30 = Triangle_is_catcher(_e29);
                both_1 = _e30;
            }
            let _e31 = both_1;
            both = !(_e31);
        }
        let _e33 = both;
        if _e33 {
            // glimt_render_gpu/src/kernels/bvh.rs:158
            (*reach) = _e21;
            // glimt_render_gpu/src/kernels/bvh.rs:159
            nearest = i;
        }
        continuing {
            let _e36 = counter;
            counter = (_e36 + 1u);
        }
    }
    // glimt_render_gpu/src/kernels/bvh.rs:162
    let _e40 = nearest;
    return _e40;
}

// glimt_render_gpu/src/kernels/bvh.rs:77
fn traverse(ray_3: Ray, reach_1: ptr<function, f32>, any_: bool) -> u32 {
    var either: bool;
    var best_1: u32;
    var stack: array<u32, 64>;
    var height: u32;
    var pair: u32;
    var near: BvhNode;
    var far: BvhNode;
    var t_near: f32;
    var t_far: f32;
    var into_near: bool;
    var into_far: bool;

    // glimt_render_gpu/src/kernels/bvh.rs:84
    let _e8 = (arrayLength((&scene_nodes)) == 0u);
    either = _e8;
    if _e8 {
    } else {
        let _e13 = scene_nodes[0u];
        let _e14 = box_distance(_e13, ray_3);
        let _e15 = (*reach_1);
        either = (_e14 >= _e15);
    }
    let _e17 = either;
    if _e17 {
        // glimt_render_gpu/src/kernels/bvh.rs:85
        return 4294967295u;
    }
    // glimt_render_gpu/src/kernels/bvh.rs:87
    let root = scene_nodes[0u];
    // glimt_render_gpu/src/kernels/bvh.rs:88
    if (root.count > 0u) {
        // glimt_render_gpu/src/kernels/bvh.rs:89
        let _e31 = visit_leaf(root, ray_3, reach_1, 4294967295u, any_);
        return _e31;
    }
    // glimt_render_gpu/src/kernels/bvh.rs:91
    best_1 = 4294967295u;
    // glimt_render_gpu/src/kernels/bvh.rs:92
    stack = array<u32, 64>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
    // glimt_render_gpu/src/kernels/bvh.rs:93
    height = 0u;
    // glimt_render_gpu/src/kernels/bvh.rs:94
    pair = root.first;
    // glimt_render_gpu/src/kernels/bvh.rs:95
    loop {
        // glimt_render_gpu/src/kernels/bvh.rs:96
        let _e47 = pair;
        let _e50 = scene_nodes[_e47];
        near = _e50;
        // glimt_render_gpu/src/kernels/bvh.rs:97
        let _e53 = pair;
        let _e58 = scene_nodes[(_e53 + 1u)];
        far = _e58;
        // glimt_render_gpu/src/kernels/bvh.rs:98
        let _e61 = near;
        let _e62 = box_distance(_e61, ray_3);
        t_near = _e62;
        // glimt_render_gpu/src/kernels/bvh.rs:99
        let _e65 = far;
        let _e66 = box_distance(_e65, ray_3);
        t_far = _e66;
        // glimt_render_gpu/src/kernels/bvh.rs:101
        let _e69 = t_near;
        let _e70 = t_far;
        if (_e69 > _e70) {
            // glimt_render_gpu/src/kernels/bvh.rs:102
            let node_1 = near;
            // glimt_render_gpu/src/kernels/bvh.rs:103
            let _e75 = far;
            near = _e75;
            // glimt_render_gpu/src/kernels/bvh.rs:104
            far = node_1;
            // glimt_render_gpu/src/kernels/bvh.rs:105
            let t_3 = t_near;
            // glimt_render_gpu/src/kernels/bvh.rs:106
            let _e80 = t_far;
            t_near = _e80;
            // glimt_render_gpu/src/kernels/bvh.rs:107
            t_far = t_3;
        }
        // glimt_render_gpu/src/kernels/bvh.rs:109
        let _e83 = t_near;
        let _e84 = (*reach_1);
        into_near = (_e83 < _e84);
        // glimt_render_gpu/src/kernels/bvh.rs:110
        let _e88 = into_near;
        let _e90 = near.count;
        if (_e88 && (_e90 > 0u)) {
            // glimt_render_gpu/src/kernels/bvh.rs:111
            let _e95 = near;
            let _e96 = best_1;
            let _e97 = visit_leaf(_e95, ray_3, reach_1, _e96, any_);
            best_1 = _e97;
            // glimt_render_gpu/src/kernels/bvh.rs:112
            let _e99 = best_1;
            if (any_ && (_e99 != 4294967295u)) {
                // glimt_render_gpu/src/kernels/bvh.rs:113
                let _e104 = best_1;
                return _e104;
            }
            // glimt_render_gpu/src/kernels/bvh.rs:115
            into_near = false;
        }
        // glimt_render_gpu/src/kernels/bvh.rs:117
        let _e108 = t_far;
        let _e109 = (*reach_1);
        into_far = (_e108 < _e109);
        // glimt_render_gpu/src/kernels/bvh.rs:118
        let _e113 = into_far;
        let _e115 = far.count;
        if (_e113 && (_e115 > 0u)) {
            // glimt_render_gpu/src/kernels/bvh.rs:119
            let _e120 = far;
            let _e121 = best_1;
            let _e122 = visit_leaf(_e120, ray_3, reach_1, _e121, any_);
            best_1 = _e122;
            // glimt_render_gpu/src/kernels/bvh.rs:120
            let _e124 = best_1;
            if (any_ && (_e124 != 4294967295u)) {
                // glimt_render_gpu/src/kernels/bvh.rs:121
                let _e129 = best_1;
                return _e129;
            }
            // glimt_render_gpu/src/kernels/bvh.rs:123
            into_far = false;
        }
        // glimt_render_gpu/src/kernels/bvh.rs:125
        let _e133 = into_near;
        if _e133 {
            // glimt_render_gpu/src/kernels/bvh.rs:126
            let _e136 = near.first;
            pair = _e136;
            // glimt_render_gpu/src/kernels/bvh.rs:127
            let _e138 = into_far;
            if _e138 {
                // glimt_render_gpu/src/kernels/bvh.rs:128
                let _e141 = far.first;
                let _e142 = height;
                stack[_e142] = _e141;
                // glimt_render_gpu/src/kernels/bvh.rs:129
                let _e146 = height;
                height = (_e146 + 1u);
            }
        } else {
            let _e148 = into_far;
            if _e148 {
                // glimt_render_gpu/src/kernels/bvh.rs:132
                let _e151 = far.first;
                pair = _e151;
            } else {
                let _e152 = height;
                if (_e152 > 0u) {
                    // glimt_render_gpu/src/kernels/bvh.rs:134
                    let _e157 = height;
                    height = (_e157 - 1u);
                    // glimt_render_gpu/src/kernels/bvh.rs:135
                    let _e160 = height;
                    let _e162 = stack[_e160];
                    pair = _e162;
                } else {
                    // glimt_render_gpu/src/kernels/bvh.rs:137
                    let _e164 = best_1;
                    return _e164;
                }
            }
        }
    }
    return u32();
}

// glimt_render_gpu/src/kernels/bvh.rs:65
fn any_hit(ray_4: Ray, t_max_1: f32) -> bool {
    var t: f32;

    // glimt_render_gpu/src/kernels/bvh.rs:66
    t = t_max_1;
    // glimt_render_gpu/src/kernels/bvh.rs:67
    let _e7 = traverse(ray_4, (&t), true);
    return (_e7 != 4294967295u);
}

// glimt_render_gpu/src/kernels/scene.rs:110
fn Scene_is_lit(point_2: ShadingPoint, direction_6: vec3<f32>) -> bool {

    // glimt_render_gpu/src/kernels/scene.rs:111
    let _e5 = Ray_new(point_2.origin, direction_6);
    // glimt_render_gpu/src/kernels/scene.rs:112
    let _e8 = any_hit(_e5, 0x1.fffffep+127f);
    return !(_e8);
}

// glimt_render_gpu/src/kernels/estimator.rs:98
fn LightSample_traced(this_7: LightSample, point_3: ShadingPoint) -> Reflected {
    var chosen_5: Reflected;

    // glimt_render_gpu/src/kernels/estimator.rs:99
    if !((max(max(this_7.contribution.x, this_7.contribution.y), this_7.contribution.z) > 0f)) {
        // glimt_render_gpu/src/kernels/estimator.rs:100
        return Reflected(vec3(0f), vec3(0f));
    }
    // glimt_render_gpu/src/kernels/estimator.rs:102
    let _e22 = Scene_is_lit(point_3, this_7.direction);
    if _e22 {
        // glimt_render_gpu/src/kernels/estimator.rs:103
        chosen_5 = Reflected(this_7.contribution, vec3(0f));
    } else {
        // glimt_render_gpu/src/kernels/estimator.rs:108
        chosen_5 = Reflected(vec3(0f), this_7.contribution);
    }
    let _e33 = chosen_5;
    return _e33;
}

// glimt_render_gpu/src/kernels/estimator.rs:37
fn Reflected_gather(this_8: ptr<function, Reflected>, light: Reflected) {

    // glimt_render_gpu/src/kernels/estimator.rs:38
    let _e6 = (*this_8).lit;
    (*this_8).lit = (_e6 + light.lit);
    // glimt_render_gpu/src/kernels/estimator.rs:39
    let _e11 = (*this_8).blocked;
    (*this_8).blocked = (_e11 + light.blocked);
    return;
}

// glimt_render_gpu/src/kernels/smc_gather.rs:17
fn estimate(seen: SmcPoint, log_normaliser: f32, floor_: f32, env_size: vec2<u32>, env_rotation: vec2<f32>, particles_start: u32, particles_len: u32) -> Reflected {
    var sum: Reflected;
    var counter_1: u32;

    // glimt_render_gpu/src/kernels/smc_gather.rs:25
    sum = Reflected(vec3(0f), vec3(0f));
    // glimt_render_gpu/src/kernels/smc_gather.rs:26
    let _e16 = is_log_zero(log_normaliser);
    if _e16 {
        // glimt_render_gpu/src/kernels/smc_gather.rs:27
        let _e18 = sum;
        return _e18;
    }
    // glimt_render_gpu/src/kernels/smc_gather.rs:29
    let _e20 = SmcPoint_shading_point(seen);
    // glimt_render_gpu/src/kernels/smc_gather.rs:30
    let _e22 = LightLobe_of_point(_e20);
    // glimt_render_gpu/src/kernels/smc_gather.rs:31
    counter_1 = 0u;
    loop {
        let i_1 = counter_1;
        if (i_1 >= particles_len) {
            break;
        }
        // glimt_render_gpu/src/kernels/smc_gather.rs:32
        let particle = particles[(particles_start + i_1)];
        // glimt_render_gpu/src/kernels/smc_gather.rs:33
        let _e35 = is_log_zero(particle.log_weight);
        if !(_e35) {
            // glimt_render_gpu/src/kernels/smc_gather.rs:34
            let direction_7 = particle.state;
            // glimt_render_gpu/src/kernels/smc_gather.rs:35
            let _e40 = Environment_texel(env_size, env_rotation, direction_7);
            let _e41 = Environment_radiance(env_size, env_rotation, _e40);
            // glimt_render_gpu/src/kernels/smc_gather.rs:36
            let _e43 = luminance(_e41);
            let _e45 = LightLobe_value(_e22, direction_7);
            let target_ = ((_e43 + floor_) * _e45);
            // glimt_render_gpu/src/kernels/smc_gather.rs:37
            let density_1 = (target_ * exp(-((log_normaliser + particle.log_weight))));
            // glimt_render_gpu/src/kernels/smc_gather.rs:38
            let _e55 = ShadingFrame_to_local(_e20.frame, direction_7);
            // glimt_render_gpu/src/kernels/smc_gather.rs:39
            let _e57 = LightSample_new(_e20, direction_7, _e55, _e41, density_1);
            // glimt_render_gpu/src/kernels/smc_gather.rs:40
            let _e59 = LightSample_traced(_e57, _e20);
            Reflected_gather((&sum), _e59);
        }
        continuing {
            let _e60 = counter_1;
            counter_1 = (_e60 + 1u);
        }
    }
    // glimt_render_gpu/src/kernels/smc_gather.rs:43
    let _e64 = sum;
    return _e64;
}

// glimt_render_gpu/src/kernels/layers.rs:39
fn LayerSample_of(light_1: Reflected, is_catcher: bool) -> LayerSample {

    // glimt_render_gpu/src/kernels/layers.rs:40
    if is_catcher {
        // glimt_render_gpu/src/kernels/layers.rs:41
        return LayerSample(light_1.lit, 0f, light_1.blocked, 1f);
    }
    // glimt_render_gpu/src/kernels/layers.rs:48
    return LayerSample(light_1.lit, 1f, vec3(0f), 0f);
}

// glimt_render_gpu/src/kernels/shade.rs:41
fn LayerSample_of_surface(light_2: Reflected, is_catcher_1: bool) -> LayerSample {

    // glimt_render_gpu/src/kernels/shade.rs:42
    let _e4 = LayerSample_of(light_2, is_catcher_1);
    return _e4;
}

// glimt_render_gpu/src/kernels/frame.rs:120
fn FrameParams_pattern_of(this_9: FrameParams, ray_5: u32) -> PixelPattern {

    // glimt_render_gpu/src/kernels/frame.rs:121
    return PixelPattern(this_9.pattern, this_9.seed, this_9.frame, (this_9.first_pixel + (ray_5 / this_9.rays_per_pixel)), (ray_5 % this_9.rays_per_pixel), this_9.rays_per_pixel);
}

// glimt_sampling/src/hash.rs:15
fn hash_u32_(n_1: u32) -> u32 {
    var x_1: u32;

    // glimt_sampling/src/hash.rs:16
    x_1 = (n_1 ^ 3875421163u);
    // glimt_sampling/src/hash.rs:17
    let _e7 = x_1;
    let _e10 = x_1;
    x_1 = (_e10 ^ (_e7 >> 16u));
    // glimt_sampling/src/hash.rs:18
    let _e13 = x_1;
    x_1 = (_e13 * 2146121005u);
    // glimt_sampling/src/hash.rs:19
    let _e17 = x_1;
    let _e20 = x_1;
    x_1 = (_e20 ^ (_e17 >> 15u));
    // glimt_sampling/src/hash.rs:20
    let _e23 = x_1;
    x_1 = (_e23 * 2221713035u);
    // glimt_sampling/src/hash.rs:21
    let _e27 = x_1;
    let _e28 = x_1;
    return (_e27 ^ (_e28 >> 16u));
}

// glimt_sampling/src/hash.rs:27
fn hash2_(a_1: u32, b_1: u32) -> u32 {

    // glimt_sampling/src/hash.rs:28
    let _e4 = hash_u32_(a_1);
    let _e6 = hash_u32_((_e4 + b_1));
    return _e6;
}

// glimt_sampling/src/hash.rs:34
fn hash3_(a_2: u32, b_2: u32, c_1: u32) -> u32 {

    // glimt_sampling/src/hash.rs:35
    let _e5 = hash2_(a_2, b_2);
    let _e7 = hash_u32_((_e5 + c_1));
    return _e7;
}

// glimt_sampling/src/sobol.rs:171
fn OwenSobol_new(seed: u32, frame: u32, pixel: u32, sample_index: u32) -> OwenSobol {

    // glimt_sampling/src/sobol.rs:172
    let _e6 = hash3_(seed, frame, pixel);
    let _e9 = hash2_(_e6, (sample_index >> 16u));
    return OwenSobol(_e9, (sample_index & 65535u), 0u);
}

// glimt_render_gpu/src/kernels/pattern.rs:96
fn PixelPattern_sobol_point(this_10: PixelPattern, purpose: u32, index: u32) -> OwenSobol {

    // glimt_render_gpu/src/kernels/pattern.rs:97
    let _e6 = hash2_(this_10.seed, purpose);
    let _e9 = OwenSobol_new(_e6, this_10.frame, this_10.pixel, index);
    return _e9;
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

// glimt_sampling/src/sobol.rs:103
fn shuffle(index_1: u32, seed_1: u32) -> u32 {

    // glimt_sampling/src/sobol.rs:104
    let _e7 = hash_u32_((seed_1 ^ 2043055690u));
    let _e8 = owen_scramble_reversed(reverseBits(index_1), _e7);
    return reverseBits(_e8);
}

// glimt_sampling/src/sobol.rs:56
fn pascal(index_2: u32) -> u32 {
    var x_3: u32;

    // glimt_sampling/src/sobol.rs:57
    x_3 = index_2;
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
fn recurrence_2_(index_3: u32) -> u32 {
    var bits: u32;
    var v0_: u32;
    var v1_: u32;
    var sum_1: u32;

    // glimt_sampling/src/sobol.rs:67
    bits = index_3;
    // glimt_sampling/src/sobol.rs:68
    v0_ = 1u;
    // glimt_sampling/src/sobol.rs:69
    v1_ = 3u;
    // glimt_sampling/src/sobol.rs:70
    sum_1 = 0u;
    // glimt_sampling/src/sobol.rs:71
    loop {
        let _e14 = bits;
        if !((_e14 != 0u)) {
            break;
        }
        // glimt_sampling/src/sobol.rs:72
        let _e19 = v0_;
        let _e20 = bits;
        let _e26 = sum_1;
        sum_1 = (_e26 ^ (_e19 & (0u - (_e20 & 1u))));
        // glimt_sampling/src/sobol.rs:73
        let _e29 = v1_;
        let _e30 = v0_;
        let _e32 = v0_;
        let v2_1 = ((_e29 ^ _e30) ^ (_e32 << 2u));
        // glimt_sampling/src/sobol.rs:74
        let _e37 = v1_;
        v0_ = _e37;
        // glimt_sampling/src/sobol.rs:75
        v1_ = v2_1;
        // glimt_sampling/src/sobol.rs:76
        let _e40 = bits;
        bits = (_e40 >> 1u);
    }
    // glimt_sampling/src/sobol.rs:78
    let _e44 = sum_1;
    return _e44;
}

// glimt_sampling/src/sobol.rs:83
fn recurrence_3_(index_4: u32) -> u32 {
    var bits_1: u32;
    var v0_1: u32;
    var v1_1: u32;
    var v2_: u32;
    var sum_2: u32;

    // glimt_sampling/src/sobol.rs:84
    bits_1 = index_4;
    // glimt_sampling/src/sobol.rs:85
    v0_1 = 1u;
    // glimt_sampling/src/sobol.rs:86
    v1_1 = 3u;
    // glimt_sampling/src/sobol.rs:87
    v2_ = 4u;
    // glimt_sampling/src/sobol.rs:88
    sum_2 = 0u;
    // glimt_sampling/src/sobol.rs:89
    loop {
        let _e17 = bits_1;
        if !((_e17 != 0u)) {
            break;
        }
        // glimt_sampling/src/sobol.rs:90
        let _e22 = v0_1;
        let _e23 = bits_1;
        let _e29 = sum_2;
        sum_2 = (_e29 ^ (_e22 & (0u - (_e23 & 1u))));
        // glimt_sampling/src/sobol.rs:91
        let _e32 = v1_1;
        let _e33 = v0_1;
        let _e35 = v0_1;
        let v3_ = ((_e32 ^ _e33) ^ (_e35 << 3u));
        // glimt_sampling/src/sobol.rs:92
        let _e40 = v1_1;
        v0_1 = _e40;
        // glimt_sampling/src/sobol.rs:93
        let _e42 = v2_;
        v1_1 = _e42;
        // glimt_sampling/src/sobol.rs:94
        v2_ = v3_;
        // glimt_sampling/src/sobol.rs:95
        let _e45 = bits_1;
        bits_1 = (_e45 >> 1u);
    }
    // glimt_sampling/src/sobol.rs:97
    let _e49 = sum_2;
    return _e49;
}

// glimt_sampling/src/sobol.rs:43
fn sobol_reversed(index_5: u32, dimension: u32) -> u32 {
    var chosen_6: u32;

    // glimt_sampling/src/sobol.rs:44
    let index_9 = (index_5 & 65535u);
    // glimt_sampling/src/sobol.rs:45
    let _e8 = (dimension & 3u);
    if (_e8 == 0u) {
        // glimt_sampling/src/sobol.rs:47
        chosen_6 = index_9;
    } else {
        if (_e8 == 1u) {
            // glimt_sampling/src/sobol.rs:48
            let _e16 = pascal(index_9);
            chosen_6 = _e16;
        } else {
            if (_e8 == 2u) {
                // glimt_sampling/src/sobol.rs:49
                let _e20 = recurrence_2_(index_9);
                chosen_6 = _e20;
            } else {
                // glimt_sampling/src/sobol.rs:50
                let _e22 = recurrence_3_(index_9);
                chosen_6 = _e22;
            }
        }
    }
    let _e23 = chosen_6;
    return _e23;
}

// glimt_sampling/src/sobol.rs:109
fn scramble_1(reversed: u32, dimension_1: u32, seed_2: u32) -> u32 {
    var chosen_7: u32;

    // glimt_sampling/src/sobol.rs:110
    let _e6 = (dimension_1 & 3u);
    if (_e6 == 0u) {
        // glimt_sampling/src/sobol.rs:111
        chosen_7 = 2435803578u;
    } else {
        if (_e6 == 1u) {
            // glimt_sampling/src/sobol.rs:112
            chosen_7 = 391059627u;
        } else {
            if (_e6 == 2u) {
                // glimt_sampling/src/sobol.rs:113
                chosen_7 = 1763603146u;
            } else {
                // glimt_sampling/src/sobol.rs:114
                chosen_7 = 3020734904u;
            }
        }
    }
    let salt = chosen_7;
    // glimt_sampling/src/sobol.rs:117
    let _e27 = hash_u32_(((seed_2 * 2626628923u) ^ salt));
    // glimt_sampling/src/sobol.rs:118
    let _e29 = owen_scramble_reversed(reversed, _e27);
    return reverseBits(_e29);
}

// glimt_sampling/src/sobol.rs:190
fn OwenSobol_next_uvec2_(this_11: ptr<function, OwenSobol>) -> vec2<u32> {

    // glimt_sampling/src/sobol.rs:191
    let _e4 = (*this_11).dimension;
    let dimension_2 = ((_e4 + 1u) & 4294967294u);
    // glimt_sampling/src/sobol.rs:192
    (*this_11).dimension = (dimension_2 + 2u);
    // glimt_sampling/src/sobol.rs:193
    let _e15 = (*this_11).seed;
    let _e18 = hash2_(_e15, (dimension_2 >> 2u));
    // glimt_sampling/src/sobol.rs:194
    let _e21 = (*this_11).index;
    let _e22 = shuffle(_e21, _e18);
    // glimt_sampling/src/sobol.rs:195
    let _e24 = sobol_reversed(_e22, dimension_2);
    let _e25 = scramble_1(_e24, dimension_2, _e18);
    let _e28 = sobol_reversed(_e22, (dimension_2 + 1u));
    let _e31 = scramble_1(_e28, (dimension_2 + 1u), _e18);
    return vec2<u32>(_e25, _e31);
}

// glimt_sampling/src/hash.rs:50
fn hash_uvec4_(v_1: vec4<u32>) -> vec4<u32> {
    var x_4: u32;
    var y: u32;
    var z: u32;
    var w: u32;

    // glimt_sampling/src/hash.rs:51
    let _e4 = hash_u32_(v_1.x);
    x_4 = ((_e4 * 1664525u) + 1013904223u);
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
    let _e35 = x_4;
    let _e36 = y;
    let _e37 = w;
    x_4 = (_e35 + (_e36 * _e37));
    // glimt_sampling/src/hash.rs:65
    let _e41 = y;
    let _e42 = z;
    let _e43 = x_4;
    y = (_e41 + (_e42 * _e43));
    // glimt_sampling/src/hash.rs:66
    let _e47 = z;
    let _e48 = x_4;
    let _e49 = y;
    z = (_e47 + (_e48 * _e49));
    // glimt_sampling/src/hash.rs:67
    let _e53 = w;
    let _e54 = y;
    let _e55 = z;
    w = (_e53 + (_e54 * _e55));
    // glimt_sampling/src/hash.rs:68
    let _e59 = x_4;
    let _e62 = x_4;
    x_4 = (_e62 ^ (_e59 >> 16u));
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
    let _e83 = x_4;
    let _e84 = y;
    let _e85 = w;
    x_4 = (_e83 + (_e84 * _e85));
    // glimt_sampling/src/hash.rs:73
    let _e89 = y;
    let _e90 = z;
    let _e91 = x_4;
    y = (_e89 + (_e90 * _e91));
    // glimt_sampling/src/hash.rs:74
    let _e95 = z;
    let _e96 = x_4;
    let _e97 = y;
    z = (_e95 + (_e96 * _e97));
    // glimt_sampling/src/hash.rs:75
    let _e101 = w;
    let _e102 = y;
    let _e103 = z;
    w = (_e101 + (_e102 * _e103));
    // glimt_sampling/src/hash.rs:76
    let _e107 = x_4;
    let _e108 = x_4;
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
fn Xoshiro128PlusPlus_stream(seed_3: u32, frame_1: u32, pixel_1: u32) -> Xoshiro128PlusPlus {

    // glimt_sampling/src/xoshiro.rs:50
    let _e7 = hash_uvec4_(vec4<u32>(pixel_1, frame_1, seed_3, 2654435769u));
    let _e8 = Xoshiro128PlusPlus_from_state(_e7);
    return _e8;
}

// glimt_render_gpu/src/kernels/pattern.rs:101
fn PixelPattern_generator(this_12: PixelPattern, purpose_1: u32, index_6: u32) -> Xoshiro128PlusPlus {

    // glimt_render_gpu/src/kernels/pattern.rs:102
    let _e6 = hash3_(this_12.seed, purpose_1, index_6);
    let _e9 = Xoshiro128PlusPlus_stream(_e6, this_12.frame, this_12.pixel);
    return _e9;
}

// glimt_sampling/src/xoshiro.rs:56
fn Xoshiro128PlusPlus_next_u32_(this_13: ptr<function, Xoshiro128PlusPlus>) -> u32 {

    // glimt_sampling/src/xoshiro.rs:57
    let s = (*this_13).state;
    // glimt_sampling/src/xoshiro.rs:58
    let _e8 = (s.x + s.w);
    let result = (((_e8 << 7u) | (_e8 >> ((0u - 7u) & 31u))) + s.x);
    // glimt_sampling/src/xoshiro.rs:59
    let z_1 = (s.z ^ s.x);
    // glimt_sampling/src/xoshiro.rs:60
    let w_1 = (s.w ^ s.y);
    // glimt_sampling/src/xoshiro.rs:61
    (*this_13).state = vec4<u32>((s.x ^ w_1), (s.y ^ z_1), (z_1 ^ (s.y << 9u)), ((w_1 << 11u) | (w_1 >> ((0u - 11u) & 31u))));
    // glimt_sampling/src/xoshiro.rs:62
    return result;
}

// glimt_sampling/src/uniform.rs:34
fn Xoshiro128PlusPlus_next_uvec2_(this_14: ptr<function, Xoshiro128PlusPlus>) -> vec2<u32> {

    // glimt_sampling/src/uniform.rs:35
    let _e3 = Xoshiro128PlusPlus_next_u32_(this_14);
    // glimt_sampling/src/uniform.rs:36
    let _e5 = Xoshiro128PlusPlus_next_u32_(this_14);
    // glimt_sampling/src/uniform.rs:37
    return vec2<u32>(_e3, _e5);
}

// glimt_render_gpu/src/kernels/pattern.rs:106
fn PixelPattern_key(this_15: PixelPattern, purpose_2: u32) -> u32 {

    // glimt_render_gpu/src/kernels/pattern.rs:107
    let _e5 = hash2_(this_15.seed, purpose_2);
    let _e8 = hash3_(_e5, this_15.frame, this_15.pixel);
    return _e8;
}

// glimt_render_gpu/src/kernels/pattern.rs:181
fn permute(index_7: u32, length_: u32, key: u32) -> u32 {
    var x_5: u32;
    var round_key: u32;
    var counter_2: i32;

    // glimt_render_gpu/src/kernels/pattern.rs:182
    if (length_ <= 1u) {
        // glimt_render_gpu/src/kernels/pattern.rs:183
        return 0u;
    }
    // glimt_render_gpu/src/kernels/pattern.rs:185
    let bits_2 = (32u - countLeadingZeros((length_ - 1u)));
    // glimt_render_gpu/src/kernels/pattern.rs:186
    let mask = (4294967295u >> ((32u - bits_2) & 31u));
    // glimt_render_gpu/src/kernels/pattern.rs:187
    x_5 = index_7;
    // glimt_render_gpu/src/kernels/pattern.rs:188
    loop {
        // glimt_render_gpu/src/kernels/pattern.rs:189
        round_key = key;
        // glimt_render_gpu/src/kernels/pattern.rs:190
        counter_2 = 0i;
        loop {
            let _e31 = counter_2;
            if (_e31 >= 3i) {
                break;
            }
            // glimt_render_gpu/src/kernels/pattern.rs:191
            let _e34 = round_key;
            let _e35 = hash_u32_(_e34);
            round_key = _e35;
            // glimt_render_gpu/src/kernels/pattern.rs:193
            let _e37 = x_5;
            let _e38 = round_key;
            x_5 = (((_e37 ^ _e38) * 2654435761u) & mask);
            // glimt_render_gpu/src/kernels/pattern.rs:194
            let _e44 = x_5;
            let _e46 = (bits_2 / 2u);
            let _e56 = x_5;
            x_5 = (_e56 ^ (_e44 >> (select(_e46, (_e46 + 1u), ((bits_2 % 2u) != 0u)) & 31u)));
            continuing {
                let _e58 = counter_2;
                counter_2 = (_e58 + 1i);
            }
        }
        // glimt_render_gpu/src/kernels/pattern.rs:196
        let _e62 = x_5;
        if (_e62 < length_) {
            // glimt_render_gpu/src/kernels/pattern.rs:197
            let _e65 = x_5;
            let _e67 = hash_u32_(~(key));
            return ((_e65 + (_e67 % length_)) % length_);
        }
    }
    return u32();
}

// glimt_render_gpu/src/kernels/pattern.rs:172
fn stratum(cell: u32, count: u32, jitter: u32) -> u32 {

    // glimt_render_gpu/src/kernels/pattern.rs:173
    return ((cell * (4294967295u / count)) + (jitter / count));
}

// glimt_render_gpu/src/kernels/pattern.rs:152
fn jittered_pair(index_8: u32, count_1: u32, jitter_1: vec2<u32>, key_1: u32) -> vec2<u32> {

    // glimt_render_gpu/src/kernels/pattern.rs:153
    let columns = max(u32(sqrt(f32(count_1))), 1u);
    // glimt_render_gpu/src/kernels/pattern.rs:154
    let _e12 = (count_1 / columns);
    let rows = select(_e12, (_e12 + 1u), ((count_1 % columns) != 0u));
    // glimt_render_gpu/src/kernels/pattern.rs:155
    let _e21 = hash2_(key_1, 1u);
    let _e22 = permute(index_8, count_1, _e21);
    // glimt_render_gpu/src/kernels/pattern.rs:156
    let _e26 = hash2_(key_1, 2u);
    let _e27 = permute((_e22 % columns), columns, _e26);
    // glimt_render_gpu/src/kernels/pattern.rs:157
    let _e31 = hash2_(key_1, 3u);
    let _e32 = permute((_e22 / columns), rows, _e31);
    // glimt_render_gpu/src/kernels/pattern.rs:158
    let _e38 = stratum(((_e27 * rows) + _e32), (columns * rows), jitter_1.x);
    let _e40 = stratum(_e22, count_1, jitter_1.y);
    return vec2<u32>(_e38, _e40);
}

// glimt_render_gpu/src/kernels/pattern.rs:51
fn PixelPattern_pair(this_16: PixelPattern, purpose_3: u32, sample: u32, samples: u32) -> vec2<u32> {
    var borrowed: OwenSobol;
    var borrowed_1: Xoshiro128PlusPlus;

    // glimt_render_gpu/src/kernels/pattern.rs:52
    let index_10 = ((this_16.ray * samples) + sample);
    // glimt_render_gpu/src/kernels/pattern.rs:53
    if (this_16.kind == 0u) {
        // glimt_render_gpu/src/kernels/pattern.rs:54
        let _e14 = PixelPattern_sobol_point(this_16, purpose_3, index_10);
        borrowed = _e14;
        let _e16 = OwenSobol_next_uvec2_((&borrowed));
        return _e16;
    }
    // glimt_render_gpu/src/kernels/pattern.rs:56
    let _e18 = PixelPattern_generator(this_16, purpose_3, index_10);
    borrowed_1 = _e18;
    let _e20 = Xoshiro128PlusPlus_next_uvec2_((&borrowed_1));
    // glimt_render_gpu/src/kernels/pattern.rs:57
    if (this_16.kind == 1u) {
        // glimt_render_gpu/src/kernels/pattern.rs:58
        return _e20;
    }
    // glimt_render_gpu/src/kernels/pattern.rs:60
    let _e29 = PixelPattern_key(this_16, purpose_3);
    let _e30 = jittered_pair(index_10, (this_16.rays * samples), _e20, _e29);
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

// glimt_render_gpu/src/kernels/camera.rs:23
fn CameraView_direction(this_17: CameraView, p: vec2<f32>, size_4: vec2<u32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/camera.rs:24
    let x_6 = (((2f * p.x) / f32(size_4.x)) - 1f);
    // glimt_render_gpu/src/kernels/camera.rs:25
    let y_1 = (((2f * p.y) / f32(size_4.y)) - 1f);
    // glimt_render_gpu/src/kernels/camera.rs:26
    return normalize(((this_17.forward + (this_17.right * x_6)) - (this_17.up * y_1)));
}

// glimt_render_gpu/src/kernels/frame.rs:150
fn FrameParams_direction(this_18: FrameParams, pixel_2: u32, place: vec2<f32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/frame.rs:151
    let corner = vec2<f32>(vec2<u32>((pixel_2 % this_18.width), (pixel_2 / this_18.width)));
    // glimt_render_gpu/src/kernels/frame.rs:152
    let view = CameraView(this_18.eye, this_18.forward, this_18.right, this_18.up);
    // glimt_render_gpu/src/kernels/frame.rs:158
    let _e22 = CameraView_direction(view, (corner + place), vec2<u32>(this_18.width, this_18.height));
    return _e22;
}

// glimt_render_gpu/src/kernels/frame.rs:134
fn FrameParams_camera_ray(this_19: FrameParams, pattern: PixelPattern) -> Ray {
    var chosen_8: vec2<f32>;

    // glimt_render_gpu/src/kernels/frame.rs:135
    if (this_19.filter_ == 1u) {
        // glimt_render_gpu/src/kernels/frame.rs:136
        chosen_8 = vec2(0.5f);
    } else {
        // glimt_render_gpu/src/kernels/frame.rs:138
        let film = PixelPattern(pattern.kind, pattern.seed, this_19.film_frame, pattern.pixel, pattern.ray, pattern.rays);
        // glimt_render_gpu/src/kernels/frame.rs:142
        let _e23 = PixelPattern_pair(film, 1u, 0u, 1u);
        let _e24 = unit_vec2_(_e23);
        chosen_8 = _e24;
    }
    let place_1 = chosen_8;
    // glimt_render_gpu/src/kernels/frame.rs:144
    let _e29 = FrameParams_direction(this_19, pattern.pixel, place_1);
    let _e30 = Ray_new(this_19.eye, _e29);
    return _e30;
}

// glimt_render_gpu/src/kernels/environment.rs:56
fn Environment_map(size_5: vec2<u32>, rotation_3: vec2<f32>) -> Returned_Environment_map {

    // glimt_render_gpu/src/kernels/environment.rs:57
    return Returned_Environment_map(size_5, rotation_3);
}

// glimt_render_gpu/src/kernels/shade.rs:46
fn LayerSample_of_background(_ray: Ray, _frame: FrameParams, _map_size: vec2<u32>, _map_rotation: vec2<f32>) -> LayerSample {

    // glimt_render_gpu/src/kernels/shade.rs:47
    return LayerSample(vec3(0f), 0f, vec3(0f), 0f);
}

// glimt_render_gpu/src/kernels/smc_gather.rs:49
fn gather_smc(ray_6: u32, frame_2: FrameParams, floor_1: f32, particles_per_ray: u32, env_size_1: vec2<u32>, env_rotation_1: vec2<f32>) -> LayerSample {

    // glimt_render_gpu/src/kernels/smc_gather.rs:60
    let seen_1 = points[ray_6];
    // glimt_render_gpu/src/kernels/smc_gather.rs:61
    let _e12 = SmcPoint_is_hit(seen_1);
    if _e12 {
        // glimt_render_gpu/src/kernels/smc_gather.rs:62
        let first = (ray_6 * particles_per_ray);
        // glimt_render_gpu/src/kernels/smc_gather.rs:63
        // glimt_render_gpu/src/kernels/smc_gather.rs:64
        let log_normaliser_1 = states[ray_6].log_normaliser;
        // glimt_render_gpu/src/kernels/smc_gather.rs:65
        let _e24 = estimate(seen_1, log_normaliser_1, floor_1, env_size_1, env_rotation_1, first, ((first + particles_per_ray) - first));
        // glimt_render_gpu/src/kernels/smc_gather.rs:66
        let _e29 = LayerSample_of_surface(_e24, (seen_1.catcher != 0u));
        return _e29;
    }
    // glimt_render_gpu/src/kernels/smc_gather.rs:68
    let _e31 = FrameParams_pattern_of(frame_2, ray_6);
    let _e32 = FrameParams_camera_ray(frame_2, _e31);
    // glimt_render_gpu/src/kernels/smc_gather.rs:69
    let _e34 = Environment_map(env_size_1, env_rotation_1);
    let _e37 = LayerSample_of_background(_e32, frame_2, _e34.value_size, _e34.value_rotation);
    return _e37;
}

@compute @workgroup_size(64, 1, 1) 
fn gather_smc_layers(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
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
    let _e26 = gather_smc((_e14 + local), _e17, _e19, _e21, _e23, _e25);
    out[local] = _e26;
}
