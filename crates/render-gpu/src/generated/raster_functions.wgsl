// Made from Rust by naga-front-rust; do not edit. This command writes it: cargo run --release -p glimt-generate

struct Triangle {
    v0_: vec3<f32>,
    material: u32,
    v1_: vec3<f32>,
    object: u32,
    v2_: vec3<f32>,
    ray_offset: f32,
}

struct Corner {
    normal: vec3<f32>,
    u: f32,
    tangent: vec3<f32>,
    v: f32,
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

struct VertexLight {
    lit: vec3<f32>,
    unused_a: f32,
    blocked: vec3<f32>,
    unused_b: f32,
}

struct RasterParams {
    frame: FrameParams,
    map_size: vec2<u32>,
    map_rotation: vec2<f32>,
    near: f32,
    scale: f32,
    unused_a: f32,
    unused_b: f32,
}

struct Ray {
    origin: vec3<f32>,
    direction: vec3<f32>,
    inverse_direction: vec3<f32>,
}

struct Hit {
    triangle: u32,
    t: f32,
    barycentrics: vec2<f32>,
}

struct Tuple_f32_f32_ {
    fa: f32,
    fb: f32,
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

struct Reflected {
    lit: vec3<f32>,
    blocked: vec3<f32>,
}

struct LayerSample {
    radiance: vec3<f32>,
    alpha: f32,
    blocked: vec3<f32>,
    catcher: f32,
}

struct Drawn {
    object: vec4<f32>,
    lit: vec4<f32>,
    blocked: vec4<f32>,
}

@group(0) @binding(1) 
var<storage> scene_triangles: array<Triangle>;
@group(0) @binding(2) 
var<storage> scene_corners: array<Corner>;
@group(0) @binding(3) 
var<storage> scene_surface: array<u32>;
@group(0) @binding(7) 
var<storage> texels: array<vec4<f32>>;
@group(0) @binding(4) 
var<storage> surface_corner_vertices: array<u32>;
@group(0) @binding(5) 
var<storage> surface_reflections: array<f32>;
@group(0) @binding(6) 
var<storage> surface_lights: array<VertexLight>;

// glimt_render_gpu/src/kernels/raster.rs:54
fn corner_position(corner: u32) -> vec3<f32> {
    var chosen: vec3<f32>;

    // glimt_render_gpu/src/kernels/raster.rs:55
    let triangle_1 = scene_triangles[(corner / 3u)];
    // glimt_render_gpu/src/kernels/raster.rs:56
    let _e10 = (corner % 3u);
    if (_e10 == 0u) {
        // glimt_render_gpu/src/kernels/raster.rs:57
        chosen = triangle_1.v0_;
    } else {
        if (_e10 == 1u) {
            // glimt_render_gpu/src/kernels/raster.rs:58
            chosen = triangle_1.v1_;
        } else {
            // glimt_render_gpu/src/kernels/raster.rs:59
            chosen = triangle_1.v2_;
        }
    }
    let _e22 = chosen;
    return _e22;
}

// glimt_render_gpu/src/kernels/raster.rs:66
fn corner_weights(corner_1: u32) -> vec2<f32> {
    var chosen_1: vec2<f32>;

    // glimt_render_gpu/src/kernels/raster.rs:67
    let _e4 = (corner_1 % 3u);
    if (_e4 == 0u) {
        // glimt_render_gpu/src/kernels/raster.rs:68
        chosen_1 = vec2(0f);
    } else {
        if (_e4 == 1u) {
            // glimt_render_gpu/src/kernels/raster.rs:69
            chosen_1 = vec2<f32>(1f, 0f);
        } else {
            // glimt_render_gpu/src/kernels/raster.rs:70
            chosen_1 = vec2<f32>(0f, 1f);
        }
    }
    let _e21 = chosen_1;
    return _e21;
}

// glimt_render_gpu/src/kernels/raster.rs:91
fn clip_position(frame: FrameParams, near: f32, p: vec3<f32>) -> vec4<f32> {

    // glimt_render_gpu/src/kernels/raster.rs:92
    let d_3 = (p - frame.eye);
    // glimt_render_gpu/src/kernels/raster.rs:93
    return vec4<f32>((dot(d_3, frame.right) / dot(frame.right, frame.right)), (dot(d_3, frame.up) / dot(frame.up, frame.up)), near, dot(d_3, frame.forward));
}

// glimt_render_gpu/src/kernels/ray.rs:48
fn inverse(x: f32) -> f32 {

    // glimt_render_gpu/src/kernels/ray.rs:49
    return (1f / bitcast<f32>(((bitcast<u32>(max(abs(x), 0.000000000000000001f)) & 2147483647u) | (bitcast<u32>(x) & 2147483648u))));
}

// glimt_render_gpu/src/kernels/ray.rs:34
fn Ray_new(origin: vec3<f32>, direction: vec3<f32>) -> Ray {

    // glimt_render_gpu/src/kernels/ray.rs:35
    let _e5 = inverse(direction.x);
    let _e7 = inverse(direction.y);
    let _e9 = inverse(direction.z);
    return Ray(origin, direction, vec3<f32>(_e5, _e7, _e9));
}

// glimt_render_gpu/src/kernels/triangle.rs:64
fn Triangle_area_normal(this_: Triangle) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/triangle.rs:65
    return cross((this_.v1_ - this_.v0_), (this_.v2_ - this_.v0_));
}

// glimt_render_gpu/src/kernels/scene.rs:118
fn unit_or(v: vec3<f32>, otherwise: vec3<f32>) -> vec3<f32> {
    var chosen_2: vec3<f32>;

    // glimt_render_gpu/src/kernels/scene.rs:119
    let length_squared = dot(v, v);
    // glimt_render_gpu/src/kernels/scene.rs:120
    if (length_squared > 0.000000000001f) {
        // glimt_render_gpu/src/kernels/scene.rs:121
        chosen_2 = (v / vec3(sqrt(length_squared)));
    } else {
        // glimt_render_gpu/src/kernels/scene.rs:123
        chosen_2 = otherwise;
    }
    let _e14 = chosen_2;
    return _e14;
}

// glimt_render_gpu/src/kernels/material.rs:83
fn MaterialView_new(index: u32) -> Returned_MaterialView_new {

    // glimt_render_gpu/src/kernels/material.rs:84
    let first = (256u + (index * 24u));
    // glimt_render_gpu/src/kernels/material.rs:85
    return Returned_MaterialView_new(first, ((first + 24u) - first));
}

// glimt_render_gpu/src/kernels/material.rs:106
fn MaterialView_texture(words_start: u32, words_len: u32, word: u32) -> TextureView {

    // glimt_render_gpu/src/kernels/material.rs:107
    let _e7 = scene_surface[(words_start + word)];
    let _e13 = scene_surface[(words_start + (word + 1u))];
    let _e19 = scene_surface[(words_start + (word + 2u))];
    let _e25 = scene_surface[(words_start + (word + 3u))];
    return TextureView(_e7, _e13, _e19, _e25);
}

// glimt_render_gpu/src/kernels/texture.rs:40
fn TextureView_exists(this_1: TextureView) -> bool {

    // glimt_render_gpu/src/kernels/texture.rs:41
    return (this_1.width > 0u);
}

// glimt_render_gpu/src/kernels/texture.rs:90
fn wrap(x_1: f32, mode: u32) -> f32 {

    // glimt_render_gpu/src/kernels/texture.rs:91
    if (mode == 2u) {
        // glimt_render_gpu/src/kernels/texture.rs:92
        return clamp(x_1, 0f, 1f);
    }
    // glimt_render_gpu/src/kernels/texture.rs:94
    if (mode == 1u) {
        // glimt_render_gpu/src/kernels/texture.rs:95
        let folded = (x_1 - (2f * floor((0.5f * x_1))));
        // glimt_render_gpu/src/kernels/texture.rs:96
        return clamp(min(folded, (2f - folded)), 0f, 1f);
    }
    // glimt_render_gpu/src/kernels/texture.rs:98
    return clamp((x_1 - floor(x_1)), 0f, 1f);
}

// glimt_render_gpu/src/kernels/texture.rs:103
fn neighbour(index_1: i32, size: u32, mode_1: u32) -> u32 {

    // glimt_render_gpu/src/kernels/texture.rs:104
    let last = (i32(size) - 1i);
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
fn TextureView_texel(this_2: TextureView, index_2: u32) -> vec4<f32> {
    var chosen_3: vec4<f32>;

    // glimt_render_gpu/src/kernels/texture.rs:70
    let word_3 = scene_surface[(this_2.first + index_2)];
    // glimt_render_gpu/src/kernels/texture.rs:71
    let r = (word_3 & 255u);
    // glimt_render_gpu/src/kernels/texture.rs:72
    let g = ((word_3 >> 8u) & 255u);
    // glimt_render_gpu/src/kernels/texture.rs:73
    let b = ((word_3 >> 16u) & 255u);
    // glimt_render_gpu/src/kernels/texture.rs:74
    let alpha = (f32((word_3 >> 24u)) / 255f);
    // glimt_render_gpu/src/kernels/texture.rs:75
    if ((this_2.flags & 1u) != 0u) {
        // glimt_render_gpu/src/kernels/texture.rs:76
        let _e38 = scene_surface[r];
        let _e42 = scene_surface[g];
        let _e46 = scene_surface[b];
        chosen_3 = vec4<f32>(bitcast<f32>(_e38), bitcast<f32>(_e42), bitcast<f32>(_e46), alpha);
    } else {
        // glimt_render_gpu/src/kernels/texture.rs:83
        chosen_3 = vec4<f32>((f32(r) / 255f), (f32(g) / 255f), (f32(b) / 255f), alpha);
    }
    let _e60 = chosen_3;
    return _e60;
}

// glimt_render_gpu/src/kernels/texture.rs:49
fn TextureView_sample(this_3: TextureView, uv: vec2<f32>) -> vec4<f32> {

    // glimt_render_gpu/src/kernels/texture.rs:50
    let wrap_u = ((this_3.flags >> 1u) & 3u);
    // glimt_render_gpu/src/kernels/texture.rs:51
    let wrap_v = ((this_3.flags >> ((1u + 2u) & 31u)) & 3u);
    // glimt_render_gpu/src/kernels/texture.rs:52
    let _e21 = wrap(uv.x, wrap_u);
    let x_2 = ((_e21 * f32(this_3.width)) - 0.5f);
    // glimt_render_gpu/src/kernels/texture.rs:53
    let _e29 = wrap(uv.y, wrap_v);
    let y = ((_e29 * f32(this_3.height)) - 0.5f);
    // glimt_render_gpu/src/kernels/texture.rs:54
    let _e38 = Tuple_f32_f32_(floor(x_2), floor(y));
    let left = _e38.fa;
    let top = _e38.fb;
    // glimt_render_gpu/src/kernels/texture.rs:55
    let _e44 = neighbour(i32(left), this_3.width, wrap_u);
    // glimt_render_gpu/src/kernels/texture.rs:56
    let _e50 = neighbour((i32(left) + 1i), this_3.width, wrap_u);
    // glimt_render_gpu/src/kernels/texture.rs:57
    let _e54 = neighbour(i32(top), this_3.height, wrap_v);
    let row0_ = (_e54 * this_3.width);
    // glimt_render_gpu/src/kernels/texture.rs:58
    let _e62 = neighbour((i32(top) + 1i), this_3.height, wrap_v);
    let row1_ = (_e62 * this_3.width);
    // glimt_render_gpu/src/kernels/texture.rs:59
    let _e67 = TextureView_texel(this_3, (row0_ + _e44));
    let _e69 = TextureView_texel(this_3, (row0_ + _e50));
    let _e70 = (x_2 - left);
    let upper = ((_e67 * (1f - _e70)) + (_e69 * _e70));
    // glimt_render_gpu/src/kernels/texture.rs:62
    let _e78 = TextureView_texel(this_3, (row1_ + _e44));
    let _e80 = TextureView_texel(this_3, (row1_ + _e50));
    let _e81 = (x_2 - left);
    let lower = ((_e78 * (1f - _e81)) + (_e80 * _e81));
    // glimt_render_gpu/src/kernels/texture.rs:65
    let _e88 = (y - top);
    return ((upper * (1f - _e88)) + (lower * _e88));
}

// glimt_render_gpu/src/kernels/material.rs:92
fn MaterialView_number(words_start_1: u32, words_len_1: u32, word_1: u32) -> f32 {

    // glimt_render_gpu/src/kernels/material.rs:93
    let _e7 = scene_surface[(words_start_1 + word_1)];
    return bitcast<f32>(_e7);
}

// glimt_render_gpu/src/kernels/material.rs:147
fn MaterialView_bumped_normal(words_start_2: u32, words_len_2: u32, uv_1: vec2<f32>, normal: vec3<f32>, tangent: vec3<f32>, handedness: f32) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/material.rs:148
    let _e9 = MaterialView_texture(words_start_2, words_len_2, 20u);
    // glimt_render_gpu/src/kernels/material.rs:149
    let across = (tangent - (normal * dot(normal, tangent)));
    // glimt_render_gpu/src/kernels/material.rs:150
    let _e15 = TextureView_exists(_e9);
    if (!(_e15) || !((dot(across, across) > 0.000000000001f))) {
        // glimt_render_gpu/src/kernels/material.rs:151
        return normal;
    }
    // glimt_render_gpu/src/kernels/material.rs:153
    let t = normalize(across);
    // glimt_render_gpu/src/kernels/material.rs:154
    let b_1 = (cross(normal, t) * handedness);
    // glimt_render_gpu/src/kernels/material.rs:155
    let _e29 = TextureView_sample(_e9, uv_1);
    let bump = ((_e29.xyz * 2f) - vec3(1f));
    // glimt_render_gpu/src/kernels/material.rs:156
    let _e43 = MaterialView_number(words_start_2, words_len_2, 10u);
    let tilt = (((t * bump.x) + (b_1 * bump.y)) * _e43);
    // glimt_render_gpu/src/kernels/material.rs:157
    let _e49 = unit_or((tilt + (normal * bump.z)), normal);
    return _e49;
}

// glimt_sampling/src/math.rs:45
fn ShadingFrame_from_normal(n: vec3<f32>) -> ShadingFrame {

    // glimt_sampling/src/math.rs:46
    let sign_ = bitcast<f32>(((bitcast<u32>(1f) & 2147483647u) | (bitcast<u32>(n.z) & 2147483648u)));
    // glimt_sampling/src/math.rs:47
    let a = (-1f / (sign_ + n.z));
    // glimt_sampling/src/math.rs:48
    let c = ((n.x * n.y) * a);
    // glimt_sampling/src/math.rs:49
    return ShadingFrame(vec3<f32>((1f + (((sign_ * n.x) * n.x) * a)), (sign_ * c), (-(sign_) * n.x)), vec3<f32>(c, (sign_ + ((n.y * n.y) * a)), -(n.y)), n);
}

// glimt_sampling/src/math.rs:66
fn ShadingFrame_to_local(this_4: ShadingFrame, v_1: vec3<f32>) -> vec3<f32> {

    // glimt_sampling/src/math.rs:67
    return vec3<f32>(dot(v_1, this_4.t), dot(v_1, this_4.b), dot(v_1, this_4.n));
}

// glimt_render_gpu/src/kernels/material.rs:97
fn MaterialView_vector(words_start_3: u32, words_len_3: u32, word_2: u32) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/material.rs:98
    let _e5 = MaterialView_number(words_start_3, words_len_3, word_2);
    let _e8 = MaterialView_number(words_start_3, words_len_3, (word_2 + 1u));
    let _e11 = MaterialView_number(words_start_3, words_len_3, (word_2 + 2u));
    return vec3<f32>(_e5, _e8, _e11);
}

// glimt_brdf/src/metallic_roughness.rs:31
fn BlinnPhong_from_metallic_roughness(base: vec3<f32>, metallic: f32, roughness: f32) -> BlinnPhong {

    // glimt_brdf/src/metallic_roughness.rs:32
    let base_1 = clamp(base, vec3(0f), vec3(1f));
    // glimt_brdf/src/metallic_roughness.rs:33
    let metallic_2 = clamp(metallic, 0f, 1f);
    // glimt_brdf/src/metallic_roughness.rs:34
    let roughness_2 = clamp(roughness, 0.12f, 1f);
    // glimt_brdf/src/metallic_roughness.rs:35
    let alpha_1 = (roughness_2 * roughness_2);
    // glimt_brdf/src/metallic_roughness.rs:36
    let dielectric = (1f - metallic_2);
    // glimt_brdf/src/metallic_roughness.rs:37
    return BlinnPhong((base_1 * (dielectric * (1f - 0.04f))), ((base_1 * metallic_2) + vec3((0.04f * dielectric))), ((2f / (alpha_1 * alpha_1)) - 2f));
}

// glimt_render_gpu/src/kernels/material.rs:118
fn MaterialView_brdf(words_start_4: u32, words_len_4: u32, uv_2: vec2<f32>) -> BlinnPhong {
    var color: vec3<f32>;
    var metallic_1: f32;
    var roughness_1: f32;

    // glimt_render_gpu/src/kernels/material.rs:119
    let _e6 = MaterialView_vector(words_start_4, words_len_4, 0u);
    color = _e6;
    // glimt_render_gpu/src/kernels/material.rs:120
    let _e13 = scene_surface[(words_start_4 + 3u)];
    if (_e13 == 0u) {
        // glimt_render_gpu/src/kernels/material.rs:121
        let _e17 = color;
        let _e19 = MaterialView_vector(words_start_4, words_len_4, 4u);
        let _e21 = MaterialView_number(words_start_4, words_len_4, 7u);
        return BlinnPhong(_e17, _e19, _e21);
    }
    // glimt_render_gpu/src/kernels/material.rs:127
    let _e25 = MaterialView_texture(words_start_4, words_len_4, 12u);
    // glimt_render_gpu/src/kernels/material.rs:128
    let _e27 = TextureView_exists(_e25);
    if _e27 {
        // glimt_render_gpu/src/kernels/material.rs:129
        let _e29 = TextureView_sample(_e25, uv_2);
        let _e31 = color;
        color = (_e31 * _e29.xyz);
    }
    // glimt_render_gpu/src/kernels/material.rs:131
    let _e35 = MaterialView_number(words_start_4, words_len_4, 8u);
    metallic_1 = _e35;
    // glimt_render_gpu/src/kernels/material.rs:132
    let _e39 = MaterialView_number(words_start_4, words_len_4, 9u);
    roughness_1 = _e39;
    // glimt_render_gpu/src/kernels/material.rs:133
    let _e43 = MaterialView_texture(words_start_4, words_len_4, 16u);
    // glimt_render_gpu/src/kernels/material.rs:134
    let _e45 = TextureView_exists(_e43);
    if _e45 {
        // glimt_render_gpu/src/kernels/material.rs:135
        let _e47 = TextureView_sample(_e43, uv_2);
        // glimt_render_gpu/src/kernels/material.rs:136
        let _e50 = roughness_1;
        roughness_1 = (_e50 * _e47.y);
        // glimt_render_gpu/src/kernels/material.rs:137
        let _e54 = metallic_1;
        metallic_1 = (_e54 * _e47.z);
    }
    // glimt_render_gpu/src/kernels/material.rs:139
    let _e57 = color;
    let _e58 = metallic_1;
    let _e59 = roughness_1;
    let _e60 = BlinnPhong_from_metallic_roughness(_e57, _e58, _e59);
    return _e60;
}

// glimt_render_gpu/src/kernels/scene.rs:67
fn Scene_shading_point(ray: Ray, hit: Hit) -> ShadingPoint {
    var chosen_4: vec3<f32>;
    var chosen_5: f32;
    var chosen_6: vec3<f32>;

    // glimt_render_gpu/src/kernels/scene.rs:68
    let triangle_2 = scene_triangles[hit.triangle];
    // glimt_render_gpu/src/kernels/scene.rs:69
    let first_1 = (3u * hit.triangle);
    // glimt_render_gpu/src/kernels/scene.rs:70
    let a_1 = scene_corners[first_1];
    // glimt_render_gpu/src/kernels/scene.rs:71
    let b_2 = scene_corners[(first_1 + 1u)];
    // glimt_render_gpu/src/kernels/scene.rs:72
    let c_1 = scene_corners[(first_1 + 2u)];
    // glimt_render_gpu/src/kernels/scene.rs:73
    let _e33 = Tuple_f32_f32_(hit.barycentrics.x, hit.barycentrics.y);
    let u = _e33.fa;
    let v_3 = _e33.fb;
    // glimt_render_gpu/src/kernels/scene.rs:74
    let w = ((1f - u) - v_3);
    // glimt_render_gpu/src/kernels/scene.rs:76
    let to_eye = -(ray.direction);
    // glimt_render_gpu/src/kernels/scene.rs:77
    let _e44 = Triangle_area_normal(triangle_2);
    let face = normalize(_e44);
    // glimt_render_gpu/src/kernels/scene.rs:78
    if (dot(face, to_eye) < 0f) {
        chosen_4 = -(face);
    } else {
        chosen_4 = face;
    }
    let geometric_normal = chosen_4;
    // glimt_render_gpu/src/kernels/scene.rs:79
    let _e62 = unit_or((((a_1.normal * w) + (b_2.normal * u)) + (c_1.normal * v_3)), face);
    // glimt_render_gpu/src/kernels/scene.rs:81
    let uv_3 = vec2<f32>((((a_1.u * w) + (b_2.u * u)) + (c_1.u * v_3)), (((a_1.v * w) + (b_2.v * u)) + (c_1.v * v_3)));
    // glimt_render_gpu/src/kernels/scene.rs:82
    let _e85 = MaterialView_new((triangle_2.material & 2147483647u));
    // glimt_render_gpu/src/kernels/scene.rs:83
    let tangent_1 = (((a_1.tangent * w) + (b_2.tangent * u)) + (c_1.tangent * v_3));
    // glimt_render_gpu/src/kernels/scene.rs:84
    if ((triangle_2.material & 2147483648u) != 0u) {
        // glimt_render_gpu/src/kernels/scene.rs:85
        chosen_5 = -1f;
    } else {
        // glimt_render_gpu/src/kernels/scene.rs:87
        chosen_5 = 1f;
    }
    let handedness_1 = chosen_5;
    // glimt_render_gpu/src/kernels/scene.rs:89
    let _e110 = MaterialView_bumped_normal(_e85.value_words_start, _e85.value_words_len, uv_3, _e62, tangent_1, handedness_1);
    // glimt_render_gpu/src/kernels/scene.rs:90
    if (dot(_e110, to_eye) < 0f) {
        // glimt_render_gpu/src/kernels/scene.rs:91
        chosen_6 = -(_e110);
    } else {
        // glimt_render_gpu/src/kernels/scene.rs:93
        chosen_6 = _e110;
    }
    let normal_1 = chosen_6;
    // glimt_render_gpu/src/kernels/scene.rs:96
    let _e121 = ShadingFrame_from_normal(normal_1);
    // glimt_render_gpu/src/kernels/scene.rs:97
    let edges = (((triangle_2.v1_ - triangle_2.v0_) * u) + ((triangle_2.v2_ - triangle_2.v0_) * v_3));
    // glimt_render_gpu/src/kernels/scene.rs:98
    let _e138 = ShadingFrame_to_local(_e121, to_eye);
    let _e139 = MaterialView_brdf(_e85.value_words_start, _e85.value_words_len, uv_3);
    return ShadingPoint(((triangle_2.v0_ + edges) + (geometric_normal * triangle_2.ray_offset)), geometric_normal, _e121, _e138, _e139);
}

// glimt_render_gpu/src/kernels/prt.rs:113
fn Surface_light_at(hit_1: Hit) -> VertexLight {

    // glimt_render_gpu/src/kernels/prt.rs:114
    let first_2 = (3u * hit_1.triangle);
    // glimt_render_gpu/src/kernels/prt.rs:115
    let _e9 = surface_corner_vertices[first_2];
    let a_2 = surface_lights[_e9];
    // glimt_render_gpu/src/kernels/prt.rs:116
    let _e18 = surface_corner_vertices[(first_2 + 1u)];
    let b_3 = surface_lights[_e18];
    // glimt_render_gpu/src/kernels/prt.rs:117
    let _e27 = surface_corner_vertices[(first_2 + 2u)];
    let c_2 = surface_lights[_e27];
    // glimt_render_gpu/src/kernels/prt.rs:118
    let _e36 = Tuple_f32_f32_(hit_1.barycentrics.x, hit_1.barycentrics.y);
    let u_1 = _e36.fa;
    let v_4 = _e36.fb;
    // glimt_render_gpu/src/kernels/prt.rs:119
    let w_1 = ((1f - u_1) - v_4);
    // glimt_render_gpu/src/kernels/prt.rs:120
    return VertexLight((((a_2.lit * w_1) + (b_3.lit * u_1)) + (c_2.lit * v_4)), 0f, (((a_2.blocked * w_1) + (b_3.blocked * u_1)) + (c_2.blocked * v_4)), 0f);
}

// glimt_render_gpu/src/kernels/triangle.rs:45
fn Triangle_object_index(this_5: Triangle) -> u32 {

    // glimt_render_gpu/src/kernels/triangle.rs:46
    return (this_5.object & 1073741823u);
}

// glimt_render_gpu/src/kernels/prt.rs:131
fn Surface_reflection(object: u32) -> f32 {

    // glimt_render_gpu/src/kernels/prt.rs:132
    let _e5 = surface_reflections[object];
    return _e5;
}

// glimt_render_gpu/src/kernels/prt.rs:79
fn diffuse(albedo: vec3<f32>, lit: vec3<f32>, blocked: vec3<f32>) -> Reflected {

    // glimt_render_gpu/src/kernels/prt.rs:80
    let arrives = max(lit, vec3(0f));
    // glimt_render_gpu/src/kernels/prt.rs:81
    let all_ = max((lit + blocked), vec3(0f));
    // glimt_render_gpu/src/kernels/prt.rs:82
    let scale_1 = (albedo * 0.31830987f);
    // glimt_render_gpu/src/kernels/prt.rs:83
    return Reflected((arrives * scale_1), (max((all_ - arrives), vec3(0f)) * scale_1));
}

// glimt_sampling/src/math.rs:59
fn ShadingFrame_to_world(this_6: ShadingFrame, v_2: vec3<f32>) -> vec3<f32> {

    // glimt_sampling/src/math.rs:60
    return (((this_6.t * v_2.x) + (this_6.b * v_2.y)) + (this_6.n * v_2.z));
}

// glimt_probe/src/rotate.rs:33
fn rotate_z(d: vec3<f32>, cos_sin: vec2<f32>) -> vec3<f32> {

    // glimt_probe/src/rotate.rs:34
    return vec3<f32>(((d.x * cos_sin.x) - (d.y * cos_sin.y)), ((d.x * cos_sin.y) + (d.y * cos_sin.x)), d.z);
}

// glimt_probe/src/latlong.rs:45
fn direction_to_uv(d_1: vec3<f32>) -> vec2<f32> {
    var chosen_7: f32;
    var chosen_8: f32;

    // glimt_probe/src/latlong.rs:46
    let horizontal = sqrt(((d_1.x * d_1.x) + (d_1.y * d_1.y)));
    // glimt_probe/src/latlong.rs:47
    if (horizontal <= 0f) {
        // glimt_probe/src/latlong.rs:48
        if (d_1.z < 0f) {
            chosen_7 = 1f;
        } else {
            chosen_7 = 0f;
        }
        let v_5 = chosen_7;
        // glimt_probe/src/latlong.rs:49
        return vec2<f32>(0.5f, v_5);
    }
    // glimt_probe/src/latlong.rs:52
    let v_6 = (atan2(horizontal, d_1.z) * 0.31830987f);
    // glimt_probe/src/latlong.rs:53
    let u_2 = (0.5f - ((0.5f * 0.31830987f) * atan2(d_1.y, d_1.x)));
    // glimt_probe/src/latlong.rs:54
    if (u_2 < 1f) {
        chosen_8 = max(u_2, 0f);
    } else {
        chosen_8 = 0f;
    }
    let _e47 = chosen_8;
    return vec2<f32>(_e47, clamp(v_6, 0f, 1f));
}

// glimt_render_gpu/src/kernels/environment.rs:135
fn bilinear(size_1: vec2<u32>, d_2: vec3<f32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/environment.rs:136
    let _e4 = direction_to_uv(d_2);
    let p_1 = ((_e4 * vec2<f32>(size_1)) - vec2(0.5f));
    // glimt_render_gpu/src/kernels/environment.rs:138
    let next = vec2<u32>((p_1 + vec2(1f)));
    // glimt_render_gpu/src/kernels/environment.rs:139
    let f = ((p_1 + vec2(1f)) - vec2<f32>(next));
    // glimt_render_gpu/src/kernels/environment.rs:140
    let x0_ = (((next.x + size_1.x) - 1u) % size_1.x);
    // glimt_render_gpu/src/kernels/environment.rs:141
    let x1_ = (next.x % size_1.x);
    // glimt_render_gpu/src/kernels/environment.rs:142
    let row0_1 = ((max(next.y, 1u) * size_1.x) - size_1.x);
    // glimt_render_gpu/src/kernels/environment.rs:143
    let row1_1 = (min(next.y, (size_1.y - 1u)) * size_1.x);
    // glimt_render_gpu/src/kernels/environment.rs:144
    let _e53 = texels[(row0_1 + x0_)];
    let _e57 = texels[(row0_1 + x1_)];
    let upper_1 = ((_e53 * (1f - f.x)) + (_e57 * f.x));
    // glimt_render_gpu/src/kernels/environment.rs:145
    let _e68 = texels[(row1_1 + x0_)];
    let _e72 = texels[(row1_1 + x1_)];
    let lower_1 = ((_e68 * (1f - f.x)) + (_e72 * f.x));
    // glimt_render_gpu/src/kernels/environment.rs:146
    return ((upper_1 * (1f - f.y)) + (lower_1 * f.y)).xyz;
}

// glimt_render_gpu/src/kernels/environment.rs:46
fn RadianceMap_background(size_2: vec2<u32>, rotation: vec2<f32>, direction_1: vec3<f32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/environment.rs:47
    let to_map = vec2<f32>(rotation.x, -(rotation.y));
    // glimt_render_gpu/src/kernels/environment.rs:48
    let _e10 = rotate_z(direction_1, to_map);
    let _e11 = bilinear(size_2, _e10);
    return _e11;
}

// glimt_render_gpu/src/kernels/prt.rs:93
fn reflected(point: ShadingPoint, lit_1: vec3<f32>, blocked_1: vec3<f32>, reflection: f32, map_size: vec2<u32>, map_rotation: vec2<f32>) -> Reflected {
    var light: Reflected;

    // glimt_render_gpu/src/kernels/prt.rs:100
    let _e10 = diffuse(point.brdf.diffuse, lit_1, blocked_1);
    light = _e10;
    // glimt_render_gpu/src/kernels/prt.rs:101
    if (reflection > 0f) {
        // glimt_render_gpu/src/kernels/prt.rs:102
        let wo = point.wo;
        // glimt_render_gpu/src/kernels/prt.rs:103
        let _e25 = ShadingFrame_to_world(point.frame, vec3<f32>(-(wo.x), -(wo.y), wo.z));
        // glimt_render_gpu/src/kernels/prt.rs:104
        let _e28 = RadianceMap_background(map_size, map_rotation, _e25);
        let _e30 = light.lit;
        light.lit = (_e30 + (_e28 * reflection));
    }
    // glimt_render_gpu/src/kernels/prt.rs:106
    let _e33 = light;
    return _e33;
}

// glimt_render_gpu/src/kernels/prt.rs:157
fn at_hit(ray_1: Ray, hit_2: Hit, map_size_1: vec2<u32>, map_rotation_1: vec2<f32>) -> Reflected {

    // glimt_render_gpu/src/kernels/prt.rs:164
    let _e6 = Scene_shading_point(ray_1, hit_2);
    // glimt_render_gpu/src/kernels/prt.rs:165
    let _e8 = Surface_light_at(hit_2);
    // glimt_render_gpu/src/kernels/prt.rs:166
    let _e13 = scene_triangles[hit_2.triangle];
    let _e14 = Triangle_object_index(_e13);
    let _e15 = Surface_reflection(_e14);
    // glimt_render_gpu/src/kernels/prt.rs:167
    let _e19 = reflected(_e6, _e8.lit, _e8.blocked, _e15, map_size_1, map_rotation_1);
    return _e19;
}

// glimt_render_gpu/src/kernels/triangle.rs:38
fn Triangle_is_catcher(this_7: Triangle) -> bool {

    // glimt_render_gpu/src/kernels/triangle.rs:39
    return ((this_7.object & 2147483648u) != 0u);
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

// glimt_render_gpu/src/kernels/raster.rs:141
fn fitting_scale(radiance: vec3<f32>, scale: f32) -> f32 {

    // glimt_render_gpu/src/kernels/raster.rs:142
    let largest = (max(max(radiance.x, radiance.y), radiance.z) * scale);
    // glimt_render_gpu/src/kernels/raster.rs:143
    if (largest > 65504f) {
        // glimt_render_gpu/src/kernels/raster.rs:144
        return (scale * (65504f / largest));
    }
    // glimt_render_gpu/src/kernels/raster.rs:146
    return scale;
}

// glimt_render_gpu/src/kernels/raster.rs:104
fn draw(triangle: u32, weights: vec2<f32>, raster: RasterParams) -> Drawn {

    // glimt_render_gpu/src/kernels/raster.rs:112
    let u_3 = clamp(weights.x, 0f, 1f);
    // glimt_render_gpu/src/kernels/raster.rs:113
    let v_7 = clamp(weights.y, 0f, (1f - u_3));
    // glimt_render_gpu/src/kernels/raster.rs:114
    let at = scene_triangles[triangle];
    // glimt_render_gpu/src/kernels/raster.rs:115
    let p_2 = ((at.v0_ + ((at.v1_ - at.v0_) * u_3)) + ((at.v2_ - at.v0_) * v_7));
    // glimt_render_gpu/src/kernels/raster.rs:116
    let to_point = (p_2 - raster.frame.eye);
    // glimt_render_gpu/src/kernels/raster.rs:117
    let _e39 = Ray_new(raster.frame.eye, normalize(to_point));
    // glimt_render_gpu/src/kernels/raster.rs:118
    let hit_3 = Hit(triangle, length(to_point), vec2<f32>(u_3, v_7));
    // glimt_render_gpu/src/kernels/raster.rs:123
    // glimt_render_gpu/src/kernels/raster.rs:128
    let _e48 = at_hit(_e39, hit_3, raster.map_size, raster.map_rotation);
    // glimt_render_gpu/src/kernels/raster.rs:129
    let _e50 = Triangle_is_catcher(at);
    let _e51 = LayerSample_of(_e48, _e50);
    // glimt_render_gpu/src/kernels/raster.rs:130
    let _e57 = fitting_scale(max(_e51.radiance, _e51.blocked), raster.scale);
    // glimt_render_gpu/src/kernels/raster.rs:131
    let radiance_1 = (_e51.radiance * _e57);
    // glimt_render_gpu/src/kernels/raster.rs:132
    return Drawn(vec4<f32>((radiance_1 * _e51.alpha), _e51.alpha), vec4<f32>((radiance_1 * _e51.catcher), _e51.catcher), vec4<f32>((_e51.blocked * _e57), 0f));
}

