// Made from Rust by naga-front-rust; do not edit. This command writes it: cargo run --release -p glimt-generate

struct Triangle {
    x: vec4<f32>,
    y: vec4<f32>,
    z: vec4<f32>,
    material: u32,
    object: u32,
    attributes: u32,
    run: u32,
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

struct RasterParams {
    frame: FrameParams,
    map_size: vec2<u32>,
    map_rotation: vec2<f32>,
    near: f32,
    scale: f32,
    samples: u32,
    unused: u32,
}

struct PixelPattern {
    kind: u32,
    seed: u32,
    frame: u32,
    pixel: u32,
    ray: u32,
    rays: u32,
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

struct VertexLight {
    lit: vec3<f32>,
    unused_a: f32,
    blocked: vec3<f32>,
    unused_b: f32,
}

struct Ray {
    origin: vec3<f32>,
    direction: vec3<f32>,
    inverse_direction: vec3<f32>,
    key: u32,
}

struct Hit {
    triangle: u32,
    t: f32,
    barycentrics: vec2<f32>,
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

// glimt_render_gpu/src/kernels/triangle.rs:64
fn Triangle_a(this_: Triangle) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/triangle.rs:65
    return vec3<f32>(this_.x.x, this_.y.x, this_.z.x);
}

// glimt_render_gpu/src/kernels/triangle.rs:71
fn Triangle_b(this_1: Triangle) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/triangle.rs:72
    return vec3<f32>(this_1.x.y, this_1.y.y, this_1.z.y);
}

// glimt_render_gpu/src/kernels/triangle.rs:78
fn Triangle_c(this_2: Triangle) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/triangle.rs:79
    return vec3<f32>(this_2.x.z, this_2.y.z, this_2.z.z);
}

// glimt_render_gpu/src/kernels/raster.rs:59
fn corner_position(corner: u32) -> vec3<f32> {
    var chosen: vec3<f32>;

    // glimt_render_gpu/src/kernels/raster.rs:60
    let triangle_3 = scene_triangles[(corner / 3u)];
    // glimt_render_gpu/src/kernels/raster.rs:61
    let _e10 = (corner % 3u);
    if (_e10 == 0u) {
        // glimt_render_gpu/src/kernels/raster.rs:62
        let _e15 = Triangle_a(triangle_3);
        chosen = _e15;
    } else {
        if (_e10 == 1u) {
            // glimt_render_gpu/src/kernels/raster.rs:63
            let _e19 = Triangle_b(triangle_3);
            chosen = _e19;
        } else {
            // glimt_render_gpu/src/kernels/raster.rs:64
            let _e21 = Triangle_c(triangle_3);
            chosen = _e21;
        }
    }
    let _e22 = chosen;
    return _e22;
}

// glimt_render_gpu/src/kernels/raster.rs:71
fn corner_weights(corner_1: u32) -> vec2<f32> {
    var chosen_1: vec2<f32>;

    // glimt_render_gpu/src/kernels/raster.rs:72
    let _e4 = (corner_1 % 3u);
    if (_e4 == 0u) {
        // glimt_render_gpu/src/kernels/raster.rs:73
        chosen_1 = vec2(0f);
    } else {
        if (_e4 == 1u) {
            // glimt_render_gpu/src/kernels/raster.rs:74
            chosen_1 = vec2<f32>(1f, 0f);
        } else {
            // glimt_render_gpu/src/kernels/raster.rs:75
            chosen_1 = vec2<f32>(0f, 1f);
        }
    }
    let _e21 = chosen_1;
    return _e21;
}

// glimt_render_gpu/src/kernels/raster.rs:139
fn clip_position(frame: FrameParams, near: f32, p: vec3<f32>) -> vec4<f32> {

    // glimt_render_gpu/src/kernels/raster.rs:140
    let d_3 = (p - frame.eye);
    // glimt_render_gpu/src/kernels/raster.rs:141
    return vec4<f32>((dot(d_3, frame.right) / dot(frame.right, frame.right)), (dot(d_3, frame.up) / dot(frame.up, frame.up)), near, dot(d_3, frame.forward));
}

// glimt_render_gpu/src/kernels/triangle.rs:85
fn Triangle_is_catcher(this_3: Triangle) -> bool {

    // glimt_render_gpu/src/kernels/triangle.rs:86
    return ((this_3.object & 2147483648u) != 0u);
}

// glimt_render_gpu/src/kernels/raster.rs:82
fn corner_near(corner_2: u32, near_1: f32) -> f32 {

    // glimt_render_gpu/src/kernels/raster.rs:83
    let _e8 = scene_triangles[(corner_2 / 3u)];
    let _e9 = Triangle_is_catcher(_e8);
    if _e9 {
        // glimt_render_gpu/src/kernels/raster.rs:84
        return (near_1 * (1f - 0.000015258789f));
    }
    // glimt_render_gpu/src/kernels/raster.rs:86
    return near_1;
}

// glimt_render_gpu/src/kernels/triangle.rs:99
fn Triangle_is_see_through(this_4: Triangle) -> bool {

    // glimt_render_gpu/src/kernels/triangle.rs:100
    return ((this_4.object & 1073741824u) != 0u);
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
fn Attributes_at(first_1: u32, u: f32, v: f32) -> Attributes {

    // glimt_render_gpu/src/kernels/material.rs:130
    let _e5 = Attributes_of_corner(first_1);
    // glimt_render_gpu/src/kernels/material.rs:131
    let _e9 = Attributes_of_corner((first_1 + 4u));
    // glimt_render_gpu/src/kernels/material.rs:132
    let _e15 = Attributes_of_corner((first_1 + (2u * 4u)));
    // glimt_render_gpu/src/kernels/material.rs:133
    let w = ((1f - u) - v);
    // glimt_render_gpu/src/kernels/material.rs:134
    return Attributes((((_e5.uv * w) + (_e9.uv * u)) + (_e15.uv * v)), (((_e5.color * w) + (_e9.color * u)) + (_e15.color * v)));
}

// glimt_render_gpu/src/kernels/material.rs:172
fn MaterialView_new(index: u32) -> Returned_MaterialView_new {

    // glimt_render_gpu/src/kernels/material.rs:173
    let first_2 = (256u + (index * 76u));
    // glimt_render_gpu/src/kernels/material.rs:174
    return Returned_MaterialView_new(first_2, ((first_2 + 76u) - first_2));
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
fn TextureView_exists(this_5: TextureView) -> bool {

    // glimt_render_gpu/src/kernels/texture.rs:41
    return (this_5.width > 0u);
}

// glimt_render_gpu/src/kernels/texture.rs:90
fn wrap(x: f32, mode: u32) -> f32 {

    // glimt_render_gpu/src/kernels/texture.rs:91
    if (mode == 2u) {
        // glimt_render_gpu/src/kernels/texture.rs:92
        return clamp(x, 0f, 1f);
    }
    // glimt_render_gpu/src/kernels/texture.rs:94
    if (mode == 1u) {
        // glimt_render_gpu/src/kernels/texture.rs:95
        let folded = (x - (2f * floor((0.5f * x))));
        // glimt_render_gpu/src/kernels/texture.rs:96
        return clamp(min(folded, (2f - folded)), 0f, 1f);
    }
    // glimt_render_gpu/src/kernels/texture.rs:98
    return clamp((x - floor(x)), 0f, 1f);
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
fn TextureView_texel(this_6: TextureView, index_2: u32) -> vec4<f32> {
    var chosen_2: vec4<f32>;

    // glimt_render_gpu/src/kernels/texture.rs:70
    let word_4 = scene_surface[(this_6.first + index_2)];
    // glimt_render_gpu/src/kernels/texture.rs:71
    let r = (word_4 & 255u);
    // glimt_render_gpu/src/kernels/texture.rs:72
    let g = ((word_4 >> 8u) & 255u);
    // glimt_render_gpu/src/kernels/texture.rs:73
    let b_2 = ((word_4 >> 16u) & 255u);
    // glimt_render_gpu/src/kernels/texture.rs:74
    let alpha_2 = (f32((word_4 >> 24u)) / 255f);
    // glimt_render_gpu/src/kernels/texture.rs:75
    if ((this_6.flags & 1u) != 0u) {
        // glimt_render_gpu/src/kernels/texture.rs:76
        let _e38 = scene_surface[r];
        let _e42 = scene_surface[g];
        let _e46 = scene_surface[b_2];
        chosen_2 = vec4<f32>(bitcast<f32>(_e38), bitcast<f32>(_e42), bitcast<f32>(_e46), alpha_2);
    } else {
        // glimt_render_gpu/src/kernels/texture.rs:83
        chosen_2 = vec4<f32>((f32(r) / 255f), (f32(g) / 255f), (f32(b_2) / 255f), alpha_2);
    }
    let _e60 = chosen_2;
    return _e60;
}

// glimt_render_gpu/src/kernels/texture.rs:49
fn TextureView_sample(this_7: TextureView, uv: vec2<f32>) -> vec4<f32> {

    // glimt_render_gpu/src/kernels/texture.rs:50
    let wrap_u = ((this_7.flags >> 1u) & 3u);
    // glimt_render_gpu/src/kernels/texture.rs:51
    let wrap_v = ((this_7.flags >> ((1u + 2u) & 31u)) & 3u);
    // glimt_render_gpu/src/kernels/texture.rs:52
    let _e21 = wrap(uv.x, wrap_u);
    let x_3 = ((_e21 * f32(this_7.width)) - 0.5f);
    // glimt_render_gpu/src/kernels/texture.rs:53
    let _e29 = wrap(uv.y, wrap_v);
    let y = ((_e29 * f32(this_7.height)) - 0.5f);
    // glimt_render_gpu/src/kernels/texture.rs:54
    let _e38 = Tuple_f32_f32_(floor(x_3), floor(y));
    let left = _e38.fa;
    let top = _e38.fb;
    // glimt_render_gpu/src/kernels/texture.rs:55
    let _e44 = neighbour(i32(left), this_7.width, wrap_u);
    // glimt_render_gpu/src/kernels/texture.rs:56
    let _e50 = neighbour((i32(left) + 1i), this_7.width, wrap_u);
    // glimt_render_gpu/src/kernels/texture.rs:57
    let _e54 = neighbour(i32(top), this_7.height, wrap_v);
    let row0_ = (_e54 * this_7.width);
    // glimt_render_gpu/src/kernels/texture.rs:58
    let _e62 = neighbour((i32(top) + 1i), this_7.height, wrap_v);
    let row1_ = (_e62 * this_7.width);
    // glimt_render_gpu/src/kernels/texture.rs:59
    let _e67 = TextureView_texel(this_7, (row0_ + _e44));
    let _e69 = TextureView_texel(this_7, (row0_ + _e50));
    let _e70 = (x_3 - left);
    let upper = ((_e67 * (1f - _e70)) + (_e69 * _e70));
    // glimt_render_gpu/src/kernels/texture.rs:62
    let _e78 = TextureView_texel(this_7, (row1_ + _e44));
    let _e80 = TextureView_texel(this_7, (row1_ + _e50));
    let _e81 = (x_3 - left);
    let lower = ((_e78 * (1f - _e81)) + (_e80 * _e81));
    // glimt_render_gpu/src/kernels/texture.rs:65
    let _e88 = (y - top);
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
        let t = (word_2 + 4u);
        // glimt_render_gpu/src/kernels/material.rs:210
        let _e18 = MaterialView_number(words_start_2, words_len_2, t);
        let _e21 = MaterialView_number(words_start_2, words_len_2, (t + 1u));
        let _e27 = MaterialView_number(words_start_2, words_len_2, (t + 2u));
        let _e30 = MaterialView_number(words_start_2, words_len_2, (t + 3u));
        let _e37 = MaterialView_number(words_start_2, words_len_2, (t + 4u));
        let _e40 = MaterialView_number(words_start_2, words_len_2, (t + 5u));
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
    var chosen_3: f32;

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
        chosen_3 = 1f;
    } else {
        chosen_3 = 0f;
    }
    let _e35 = chosen_3;
    return _e35;
}

// glimt_render_gpu/src/kernels/opacity.rs:14
fn alpha_at(triangle: Triangle, u_1: f32, v_1: f32) -> f32 {

    // glimt_render_gpu/src/kernels/opacity.rs:15
    let _e6 = Attributes_at(triangle.attributes, u_1, v_1);
    // glimt_render_gpu/src/kernels/opacity.rs:16
    let _e11 = MaterialView_new((triangle.material & 2147483647u));
    // glimt_render_gpu/src/kernels/opacity.rs:17
    let _e18 = MaterialView_alpha(_e11.value_words_start, _e11.value_words_len, _e6.uv, _e6.color.w);
    return _e18;
}

// glimt_sampling/src/hash.rs:15
fn hash_u32_(n: u32) -> u32 {
    var x_1: u32;

    // glimt_sampling/src/hash.rs:16
    x_1 = (n ^ 3875421163u);
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
fn PixelPattern_key(this_8: PixelPattern, purpose: u32) -> u32 {

    // glimt_render_gpu/src/kernels/pattern.rs:147
    let _e5 = hash2_(this_8.seed, purpose);
    let _e8 = hash3_(_e5, this_8.frame, this_8.pixel);
    return _e8;
}

// glimt_render_gpu/src/kernels/pattern.rs:131
fn PixelPattern_ray_key(this_9: PixelPattern, purpose_1: u32) -> u32 {

    // glimt_render_gpu/src/kernels/pattern.rs:132
    let _e4 = PixelPattern_key(this_9, purpose_1);
    let _e6 = hash2_(_e4, this_9.ray);
    return _e6;
}

// glimt_sampling/src/uniform.rs:15
fn unit_f32_(u_2: u32) -> f32 {

    // glimt_sampling/src/uniform.rs:16
    return (f32((u_2 >> 8u)) * (1f / 16777216f));
}

// glimt_render_gpu/src/kernels/opacity.rs:26
fn passes(key: u32, index_3: u32, alpha_1: f32) -> bool {

    // glimt_render_gpu/src/kernels/opacity.rs:27
    let _e5 = hash2_(key, index_3);
    let _e6 = unit_f32_(_e5);
    return (_e6 >= alpha_1);
}

// glimt_render_gpu/src/kernels/raster.rs:92
fn keeps_sample(triangle_1: u32, weights: vec2<f32>, pixel: vec2<u32>, sample: u32, raster: RasterParams) -> u32 {
    var chosen_4: u32;

    // glimt_render_gpu/src/kernels/raster.rs:100
    let at = scene_triangles[triangle_1];
    // glimt_render_gpu/src/kernels/raster.rs:101
    let _e11 = Triangle_is_see_through(at);
    if !(_e11) {
        // glimt_render_gpu/src/kernels/raster.rs:102
        return 1u;
    }
    // glimt_render_gpu/src/kernels/raster.rs:104
    let u_3 = clamp(weights.x, 0f, 1f);
    // glimt_render_gpu/src/kernels/raster.rs:105
    let v_5 = clamp(weights.y, 0f, (1f - u_3));
    // glimt_render_gpu/src/kernels/raster.rs:106
    let pattern = PixelPattern(raster.frame.pattern, raster.frame.seed, raster.frame.film_frame, ((pixel.y * raster.frame.width) + pixel.x), sample, raster.samples);
    // glimt_render_gpu/src/kernels/raster.rs:114
    let _e42 = alpha_at(at, u_3, v_5);
    // glimt_render_gpu/src/kernels/raster.rs:115
    let _e46 = PixelPattern_ray_key(pattern, 8u);
    let _e47 = passes(_e46, triangle_1, _e42);
    if _e47 {
        // glimt_render_gpu/src/kernels/raster.rs:116
        chosen_4 = 0u;
    } else {
        // glimt_render_gpu/src/kernels/raster.rs:118
        chosen_4 = 1u;
    }
    let _e52 = chosen_4;
    return _e52;
}

// glimt_render_gpu/src/kernels/ray.rs:59
fn inverse(x_2: f32) -> f32 {

    // glimt_render_gpu/src/kernels/ray.rs:60
    return (1f / bitcast<f32>(((bitcast<u32>(max(abs(x_2), 0.000000000000000001f)) & 2147483647u) | (bitcast<u32>(x_2) & 2147483648u))));
}

// glimt_render_gpu/src/kernels/ray.rs:44
fn Ray_keyed(origin: vec3<f32>, direction: vec3<f32>, key_1: u32) -> Ray {

    // glimt_render_gpu/src/kernels/ray.rs:45
    let _e6 = inverse(direction.x);
    let _e8 = inverse(direction.y);
    let _e10 = inverse(direction.z);
    return Ray(origin, direction, vec3<f32>(_e6, _e8, _e10), key_1);
}

// glimt_render_gpu/src/kernels/ray.rs:37
fn Ray_new(origin_1: vec3<f32>, direction_1: vec3<f32>) -> Ray {

    // glimt_render_gpu/src/kernels/ray.rs:38
    let _e5 = Ray_keyed(origin_1, direction_1, 0u);
    return _e5;
}

// glimt_render_gpu/src/kernels/triangle.rs:140
fn Triangle_area_normal(this_10: Triangle) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/triangle.rs:141
    let _e3 = Triangle_b(this_10);
    let _e4 = Triangle_a(this_10);
    let _e6 = Triangle_c(this_10);
    let _e7 = Triangle_a(this_10);
    return cross((_e3 - _e4), (_e6 - _e7));
}

// glimt_render_gpu/src/kernels/triangle.rs:128
fn Triangle_outward(this_11: Triangle) -> vec3<f32> {
    var chosen_5: vec3<f32>;

    // glimt_render_gpu/src/kernels/triangle.rs:129
    let _e3 = Triangle_area_normal(this_11);
    // glimt_render_gpu/src/kernels/triangle.rs:130
    if ((this_11.object & 536870912u) != 0u) {
        // glimt_render_gpu/src/kernels/triangle.rs:131
        chosen_5 = -(_e3);
    } else {
        // glimt_render_gpu/src/kernels/triangle.rs:133
        chosen_5 = _e3;
    }
    let _e14 = chosen_5;
    return _e14;
}

// glimt_render_gpu/src/kernels/scene.rs:144
fn unit_or(v_2: vec3<f32>, otherwise: vec3<f32>) -> vec3<f32> {
    var chosen_6: vec3<f32>;

    // glimt_render_gpu/src/kernels/scene.rs:145
    let length_squared = dot(v_2, v_2);
    // glimt_render_gpu/src/kernels/scene.rs:146
    if (length_squared > 0.000000000001f) {
        // glimt_render_gpu/src/kernels/scene.rs:147
        chosen_6 = (v_2 / vec3(sqrt(length_squared)));
    } else {
        // glimt_render_gpu/src/kernels/scene.rs:149
        chosen_6 = otherwise;
    }
    let _e14 = chosen_6;
    return _e14;
}

// glimt_render_gpu/src/kernels/material.rs:298
fn MaterialView_bumped_normal(words_start_4: u32, words_len_4: u32, uv_3: vec2<f32>, normal: vec3<f32>, tangent: vec3<f32>, handedness: f32) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/material.rs:299
    let _e9 = MaterialView_texture(words_start_4, words_len_4, 40u);
    // glimt_render_gpu/src/kernels/material.rs:300
    let across = (tangent - (normal * dot(normal, tangent)));
    // glimt_render_gpu/src/kernels/material.rs:301
    let _e15 = TextureView_exists(_e9);
    if (!(_e15) || !((dot(across, across) > 0.000000000001f))) {
        // glimt_render_gpu/src/kernels/material.rs:302
        return normal;
    }
    // glimt_render_gpu/src/kernels/material.rs:304
    let t_1 = normalize(across);
    // glimt_render_gpu/src/kernels/material.rs:305
    let b_3 = (cross(normal, t_1) * handedness);
    // glimt_render_gpu/src/kernels/material.rs:306
    let _e30 = MaterialView_sample(words_start_4, words_len_4, 40u, _e9, uv_3);
    let bump = ((_e30.xyz * 2f) - vec3(1f));
    // glimt_render_gpu/src/kernels/material.rs:307
    let _e44 = MaterialView_number(words_start_4, words_len_4, 14u);
    let tilt = (((t_1 * bump.x) + (b_3 * bump.y)) * _e44);
    // glimt_render_gpu/src/kernels/material.rs:308
    let _e50 = unit_or((tilt + (normal * bump.z)), normal);
    return _e50;
}

// glimt_render_gpu/src/kernels/scene.rs:69
fn bent_towards(normal_1: vec3<f32>, to_eye: vec3<f32>, geometric_normal: vec3<f32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/scene.rs:70
    let least = min(0.01f, (0.9f * dot(geometric_normal, to_eye)));
    // glimt_render_gpu/src/kernels/scene.rs:71
    let cosine = dot(normal_1, to_eye);
    // glimt_render_gpu/src/kernels/scene.rs:72
    if (cosine >= least) {
        // glimt_render_gpu/src/kernels/scene.rs:73
        return normal_1;
    }
    // glimt_render_gpu/src/kernels/scene.rs:75
    let _e19 = unit_or((normal_1 + (to_eye * (least - cosine))), geometric_normal);
    return _e19;
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

// glimt_render_gpu/src/kernels/triangle.rs:106
fn Triangle_ray_offset(this_12: Triangle) -> f32 {

    // glimt_render_gpu/src/kernels/triangle.rs:107
    let extent = max(max(abs(this_12.x), abs(this_12.y)), abs(this_12.z));
    // glimt_render_gpu/src/kernels/triangle.rs:108
    return (0.0000038146973f * max(max(max(extent.x, extent.y), extent.z), extent.w));
}

// glimt_sampling/src/math.rs:66
fn ShadingFrame_to_local(this_13: ShadingFrame, v_3: vec3<f32>) -> vec3<f32> {

    // glimt_sampling/src/math.rs:67
    return vec3<f32>(dot(v_3, this_13.t), dot(v_3, this_13.b), dot(v_3, this_13.n));
}

// glimt_render_gpu/src/kernels/material.rs:186
fn MaterialView_vector(words_start_5: u32, words_len_5: u32, word_3: u32) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/material.rs:187
    let _e5 = MaterialView_number(words_start_5, words_len_5, word_3);
    let _e8 = MaterialView_number(words_start_5, words_len_5, (word_3 + 1u));
    let _e11 = MaterialView_number(words_start_5, words_len_5, (word_3 + 2u));
    return vec3<f32>(_e5, _e8, _e11);
}

// glimt_render_gpu/src/kernels/material.rs:219
fn MaterialView_color(words_start_6: u32, words_len_6: u32, uv_4: vec2<f32>, vertex_color: vec3<f32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/material.rs:220
    let _e7 = MaterialView_vector(words_start_6, words_len_6, 0u);
    let color_1 = (_e7 * vertex_color);
    // glimt_render_gpu/src/kernels/material.rs:221
    let _e11 = MaterialView_texture(words_start_6, words_len_6, 16u);
    // glimt_render_gpu/src/kernels/material.rs:222
    let _e13 = TextureView_exists(_e11);
    if _e13 {
        // glimt_render_gpu/src/kernels/material.rs:223
        let _e16 = MaterialView_sample(words_start_6, words_len_6, 16u, _e11, uv_4);
        return (color_1 * _e16.xyz);
    }
    // glimt_render_gpu/src/kernels/material.rs:225
    return color_1;
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
    let alpha_3 = (roughness_2 * roughness_2);
    // glimt_brdf/src/metallic_roughness.rs:36
    let dielectric = (1f - metallic_2);
    // glimt_brdf/src/metallic_roughness.rs:37
    return BlinnPhong((base_1 * (dielectric * (1f - 0.04f))), ((base_1 * metallic_2) + vec3((0.04f * dielectric))), ((2f / (alpha_3 * alpha_3)) - 2f));
}

// glimt_render_gpu/src/kernels/material.rs:231
fn MaterialView_brdf(words_start_7: u32, words_len_7: u32, uv_5: vec2<f32>, vertex_color_1: vec3<f32>) -> BlinnPhong {
    var metallic_1: f32;
    var roughness_1: f32;

    // glimt_render_gpu/src/kernels/material.rs:232
    let _e10 = scene_surface[(words_start_7 + 3u)];
    let kind = (_e10 & 2147483647u);
    // glimt_render_gpu/src/kernels/material.rs:233
    if (kind == 0u) {
        // glimt_render_gpu/src/kernels/material.rs:234
        let _e18 = MaterialView_vector(words_start_7, words_len_7, 0u);
        let _e21 = MaterialView_vector(words_start_7, words_len_7, 4u);
        let _e23 = MaterialView_number(words_start_7, words_len_7, 7u);
        return BlinnPhong((_e18 * vertex_color_1), _e21, _e23);
    }
    // glimt_render_gpu/src/kernels/material.rs:240
    if (kind == 2u) {
        // glimt_render_gpu/src/kernels/material.rs:241
        return BlinnPhong(vec3(0f), vec3(0f), 0f);
    }
    // glimt_render_gpu/src/kernels/material.rs:247
    let _e36 = MaterialView_color(words_start_7, words_len_7, uv_5, vertex_color_1);
    // glimt_render_gpu/src/kernels/material.rs:248
    let _e39 = MaterialView_number(words_start_7, words_len_7, 12u);
    metallic_1 = _e39;
    // glimt_render_gpu/src/kernels/material.rs:249
    let _e43 = MaterialView_number(words_start_7, words_len_7, 13u);
    roughness_1 = _e43;
    // glimt_render_gpu/src/kernels/material.rs:250
    let _e47 = MaterialView_texture(words_start_7, words_len_7, 28u);
    // glimt_render_gpu/src/kernels/material.rs:251
    let _e49 = TextureView_exists(_e47);
    if _e49 {
        // glimt_render_gpu/src/kernels/material.rs:252
        let _e52 = MaterialView_sample(words_start_7, words_len_7, 28u, _e47, uv_5);
        // glimt_render_gpu/src/kernels/material.rs:253
        let _e55 = roughness_1;
        roughness_1 = (_e55 * _e52.y);
        // glimt_render_gpu/src/kernels/material.rs:254
        let _e59 = metallic_1;
        metallic_1 = (_e59 * _e52.z);
    }
    // glimt_render_gpu/src/kernels/material.rs:256
    let _e62 = metallic_1;
    let _e63 = roughness_1;
    let _e64 = BlinnPhong_from_metallic_roughness(_e36, _e62, _e63);
    return _e64;
}

// glimt_render_gpu/src/kernels/material.rs:262
fn MaterialView_emission(words_start_8: u32, words_len_8: u32, uv_6: vec2<f32>, vertex_color_2: vec3<f32>) -> vec3<f32> {
    var radiance: vec3<f32>;

    // glimt_render_gpu/src/kernels/material.rs:263
    radiance = vec3(0f);
    // glimt_render_gpu/src/kernels/material.rs:264
    let _e14 = scene_surface[(words_start_8 + 3u)];
    if ((_e14 & 2147483648u) != 0u) {
        // glimt_render_gpu/src/kernels/material.rs:265
        let _e21 = MaterialView_vector(words_start_8, words_len_8, 8u);
        radiance = _e21;
        // glimt_render_gpu/src/kernels/material.rs:266
        let _e24 = MaterialView_texture(words_start_8, words_len_8, 52u);
        // glimt_render_gpu/src/kernels/material.rs:267
        let _e26 = TextureView_exists(_e24);
        if _e26 {
            // glimt_render_gpu/src/kernels/material.rs:268
            let _e29 = MaterialView_sample(words_start_8, words_len_8, 52u, _e24, uv_6);
            let _e31 = radiance;
            radiance = (_e31 * _e29.xyz);
        }
    }
    // glimt_render_gpu/src/kernels/material.rs:271
    let _e38 = scene_surface[(words_start_8 + 3u)];
    if ((_e38 & 2147483647u) == 2u) {
        // glimt_render_gpu/src/kernels/material.rs:272
        let _e44 = MaterialView_color(words_start_8, words_len_8, uv_6, vertex_color_2);
        let _e45 = radiance;
        radiance = (_e45 + _e44);
    }
    // glimt_render_gpu/src/kernels/material.rs:274
    let _e48 = radiance;
    return _e48;
}

// glimt_render_gpu/src/kernels/scene.rs:88
fn Scene_shading_point(ray: Ray, hit: Hit) -> ShadingPoint {
    var chosen_7: vec3<f32>;
    var chosen_8: f32;
    var chosen_9: vec3<f32>;
    var vertex_color_3: vec3<f32>;

    // glimt_render_gpu/src/kernels/scene.rs:89
    let triangle_4 = scene_triangles[hit.triangle];
    // glimt_render_gpu/src/kernels/scene.rs:90
    let first_3 = (3u * hit.triangle);
    // glimt_render_gpu/src/kernels/scene.rs:91
    let a_3 = scene_corners[first_3];
    // glimt_render_gpu/src/kernels/scene.rs:92
    let b_4 = scene_corners[(first_3 + 1u)];
    // glimt_render_gpu/src/kernels/scene.rs:93
    let c_2 = scene_corners[(first_3 + 2u)];
    // glimt_render_gpu/src/kernels/scene.rs:94
    let _e33 = Tuple_f32_f32_(hit.barycentrics.x, hit.barycentrics.y);
    let u_4 = _e33.fa;
    let v_6 = _e33.fb;
    // glimt_render_gpu/src/kernels/scene.rs:95
    let w_1 = ((1f - u_4) - v_6);
    // glimt_render_gpu/src/kernels/scene.rs:97
    let to_eye_1 = -(ray.direction);
    // glimt_render_gpu/src/kernels/scene.rs:98
    let _e44 = Triangle_outward(triangle_4);
    let outward = normalize(_e44);
    // glimt_render_gpu/src/kernels/scene.rs:99
    let is_inside = (dot(outward, to_eye_1) < 0f);
    // glimt_render_gpu/src/kernels/scene.rs:100
    if is_inside {
        chosen_7 = -(outward);
    } else {
        chosen_7 = outward;
    }
    let geometric_normal_1 = chosen_7;
    // glimt_render_gpu/src/kernels/scene.rs:101
    let _e63 = unit_or((((a_3.normal * w_1) + (b_4.normal * u_4)) + (c_2.normal * v_6)), outward);
    // glimt_render_gpu/src/kernels/scene.rs:103
    let uv_7 = vec2<f32>((((a_3.u * w_1) + (b_4.u * u_4)) + (c_2.u * v_6)), (((a_3.v * w_1) + (b_4.v * u_4)) + (c_2.v * v_6)));
    // glimt_render_gpu/src/kernels/scene.rs:104
    let _e86 = MaterialView_new((triangle_4.material & 2147483647u));
    // glimt_render_gpu/src/kernels/scene.rs:105
    let tangent_1 = (((a_3.tangent * w_1) + (b_4.tangent * u_4)) + (c_2.tangent * v_6));
    // glimt_render_gpu/src/kernels/scene.rs:106
    if ((triangle_4.material & 2147483648u) != 0u) {
        // glimt_render_gpu/src/kernels/scene.rs:107
        chosen_8 = -1f;
    } else {
        // glimt_render_gpu/src/kernels/scene.rs:109
        chosen_8 = 1f;
    }
    let handedness_1 = chosen_8;
    // glimt_render_gpu/src/kernels/scene.rs:111
    let _e111 = MaterialView_bumped_normal(_e86.value_words_start, _e86.value_words_len, uv_7, _e63, tangent_1, handedness_1);
    // glimt_render_gpu/src/kernels/scene.rs:113
    if is_inside {
        chosen_9 = -(_e111);
    } else {
        chosen_9 = _e111;
    }
    let sided = chosen_9;
    // glimt_render_gpu/src/kernels/scene.rs:114
    let _e117 = bent_towards(sided, to_eye_1, geometric_normal_1);
    // glimt_render_gpu/src/kernels/scene.rs:116
    vertex_color_3 = vec3(1f);
    // glimt_render_gpu/src/kernels/scene.rs:117
    if (triangle_4.attributes != 0u) {
        // glimt_render_gpu/src/kernels/scene.rs:118
        let _e128 = Attributes_at(triangle_4.attributes, u_4, v_6);
        // glimt_render_gpu/src/kernels/scene.rs:119
        vertex_color_3 = _e128.color.xyz;
    }
    // glimt_render_gpu/src/kernels/scene.rs:121
    let _e133 = ShadingFrame_from_normal(_e117);
    // glimt_render_gpu/src/kernels/scene.rs:122
    let _e135 = Triangle_b(triangle_4);
    let _e136 = Triangle_a(triangle_4);
    let _e139 = Triangle_c(triangle_4);
    let _e140 = Triangle_a(triangle_4);
    let edges = (((_e135 - _e136) * u_4) + ((_e139 - _e140) * v_6));
    // glimt_render_gpu/src/kernels/scene.rs:123
    let _e145 = Triangle_a(triangle_4);
    let _e147 = Triangle_ray_offset(triangle_4);
    let _e150 = ShadingFrame_to_local(_e133, to_eye_1);
    let _e151 = vertex_color_3;
    let _e152 = MaterialView_brdf(_e86.value_words_start, _e86.value_words_len, uv_7, _e151);
    let _e153 = vertex_color_3;
    let _e154 = MaterialView_emission(_e86.value_words_start, _e86.value_words_len, uv_7, _e153);
    return ShadingPoint(((_e145 + edges) + (geometric_normal_1 * _e147)), geometric_normal_1, _e133, _e150, _e152, _e154);
}

// glimt_render_gpu/src/kernels/prt.rs:113
fn Surface_light_at(hit_1: Hit) -> VertexLight {

    // glimt_render_gpu/src/kernels/prt.rs:114
    let first_4 = (3u * hit_1.triangle);
    // glimt_render_gpu/src/kernels/prt.rs:115
    let _e9 = surface_corner_vertices[first_4];
    let a_4 = surface_lights[_e9];
    // glimt_render_gpu/src/kernels/prt.rs:116
    let _e18 = surface_corner_vertices[(first_4 + 1u)];
    let b_5 = surface_lights[_e18];
    // glimt_render_gpu/src/kernels/prt.rs:117
    let _e27 = surface_corner_vertices[(first_4 + 2u)];
    let c_3 = surface_lights[_e27];
    // glimt_render_gpu/src/kernels/prt.rs:118
    let _e36 = Tuple_f32_f32_(hit_1.barycentrics.x, hit_1.barycentrics.y);
    let u_5 = _e36.fa;
    let v_7 = _e36.fb;
    // glimt_render_gpu/src/kernels/prt.rs:119
    let w_2 = ((1f - u_5) - v_7);
    // glimt_render_gpu/src/kernels/prt.rs:120
    return VertexLight((((a_4.lit * w_2) + (b_5.lit * u_5)) + (c_3.lit * v_7)), 0f, (((a_4.blocked * w_2) + (b_5.blocked * u_5)) + (c_3.blocked * v_7)), 0f);
}

// glimt_render_gpu/src/kernels/triangle.rs:92
fn Triangle_object_index(this_14: Triangle) -> u32 {

    // glimt_render_gpu/src/kernels/triangle.rs:93
    return (this_14.object & 536870911u);
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
fn ShadingFrame_to_world(this_15: ShadingFrame, v_4: vec3<f32>) -> vec3<f32> {

    // glimt_sampling/src/math.rs:60
    return (((this_15.t * v_4.x) + (this_15.b * v_4.y)) + (this_15.n * v_4.z));
}

// glimt_probe/src/rotate.rs:33
fn rotate_z(d: vec3<f32>, cos_sin: vec2<f32>) -> vec3<f32> {

    // glimt_probe/src/rotate.rs:34
    return vec3<f32>(((d.x * cos_sin.x) - (d.y * cos_sin.y)), ((d.x * cos_sin.y) + (d.y * cos_sin.x)), d.z);
}

// glimt_probe/src/latlong.rs:45
fn direction_to_uv(d_1: vec3<f32>) -> vec2<f32> {
    var chosen_10: f32;
    var chosen_11: f32;

    // glimt_probe/src/latlong.rs:46
    let horizontal = sqrt(((d_1.x * d_1.x) + (d_1.y * d_1.y)));
    // glimt_probe/src/latlong.rs:47
    if (horizontal <= 0f) {
        // glimt_probe/src/latlong.rs:48
        if (d_1.z < 0f) {
            chosen_10 = 1f;
        } else {
            chosen_10 = 0f;
        }
        let v_8 = chosen_10;
        // glimt_probe/src/latlong.rs:49
        return vec2<f32>(0.5f, v_8);
    }
    // glimt_probe/src/latlong.rs:52
    let v_9 = (atan2(horizontal, d_1.z) * 0.31830987f);
    // glimt_probe/src/latlong.rs:53
    let u_6 = (0.5f - ((0.5f * 0.31830987f) * atan2(d_1.y, d_1.x)));
    // glimt_probe/src/latlong.rs:54
    if (u_6 < 1f) {
        chosen_11 = max(u_6, 0f);
    } else {
        chosen_11 = 0f;
    }
    let _e47 = chosen_11;
    return vec2<f32>(_e47, clamp(v_9, 0f, 1f));
}

// glimt_render_gpu/src/kernels/environment.rs:146
fn bilinear(size_1: vec2<u32>, d_2: vec3<f32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/environment.rs:147
    let _e4 = direction_to_uv(d_2);
    let p_1 = ((_e4 * vec2<f32>(size_1)) - vec2(0.5f));
    // glimt_render_gpu/src/kernels/environment.rs:149
    let next = vec2<u32>((p_1 + vec2(1f)));
    // glimt_render_gpu/src/kernels/environment.rs:150
    let f = ((p_1 + vec2(1f)) - vec2<f32>(next));
    // glimt_render_gpu/src/kernels/environment.rs:151
    let x0_ = (((next.x + size_1.x) - 1u) % size_1.x);
    // glimt_render_gpu/src/kernels/environment.rs:152
    let x1_ = (next.x % size_1.x);
    // glimt_render_gpu/src/kernels/environment.rs:153
    let row0_1 = ((max(next.y, 1u) * size_1.x) - size_1.x);
    // glimt_render_gpu/src/kernels/environment.rs:154
    let row1_1 = (min(next.y, (size_1.y - 1u)) * size_1.x);
    // glimt_render_gpu/src/kernels/environment.rs:155
    let _e53 = texels[(row0_1 + x0_)];
    let _e57 = texels[(row0_1 + x1_)];
    let upper_1 = ((_e53 * (1f - f.x)) + (_e57 * f.x));
    // glimt_render_gpu/src/kernels/environment.rs:156
    let _e68 = texels[(row1_1 + x0_)];
    let _e72 = texels[(row1_1 + x1_)];
    let lower_1 = ((_e68 * (1f - f.x)) + (_e72 * f.x));
    // glimt_render_gpu/src/kernels/environment.rs:157
    return ((upper_1 * (1f - f.y)) + (lower_1 * f.y)).xyz;
}

// glimt_render_gpu/src/kernels/environment.rs:46
fn RadianceMap_background(size_2: vec2<u32>, rotation: vec2<f32>, direction_2: vec3<f32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/environment.rs:47
    let to_map = vec2<f32>(rotation.x, -(rotation.y));
    // glimt_render_gpu/src/kernels/environment.rs:48
    let _e10 = rotate_z(direction_2, to_map);
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
    var light_1: Reflected;

    // glimt_render_gpu/src/kernels/prt.rs:164
    let _e6 = Scene_shading_point(ray_1, hit_2);
    // glimt_render_gpu/src/kernels/prt.rs:165
    let triangle_5 = scene_triangles[hit_2.triangle];
    // glimt_render_gpu/src/kernels/prt.rs:166
    let _e13 = Surface_light_at(hit_2);
    // glimt_render_gpu/src/kernels/prt.rs:167
    let _e15 = Triangle_object_index(triangle_5);
    let _e16 = Surface_reflection(_e15);
    // glimt_render_gpu/src/kernels/prt.rs:168
    let _e20 = reflected(_e6, _e13.lit, _e13.blocked, _e16, map_size_1, map_rotation_1);
    light_1 = _e20;
    // glimt_render_gpu/src/kernels/prt.rs:169
    let _e23 = Triangle_is_catcher(triangle_5);
    if !(_e23) {
        // glimt_render_gpu/src/kernels/prt.rs:170
        let _e28 = light_1.lit;
        light_1.lit = (_e28 + _e6.emission);
    }
    // glimt_render_gpu/src/kernels/prt.rs:172
    let _e31 = light_1;
    return _e31;
}

// glimt_render_gpu/src/kernels/layers.rs:39
fn LayerSample_of(light_2: Reflected, is_catcher: bool) -> LayerSample {

    // glimt_render_gpu/src/kernels/layers.rs:40
    if is_catcher {
        // glimt_render_gpu/src/kernels/layers.rs:41
        return LayerSample(light_2.lit, 0f, light_2.blocked, 1f);
    }
    // glimt_render_gpu/src/kernels/layers.rs:48
    return LayerSample(light_2.lit, 1f, vec3(0f), 0f);
}

// glimt_render_gpu/src/kernels/raster.rs:189
fn fitting_scale(radiance_1: vec3<f32>, scale: f32) -> f32 {

    // glimt_render_gpu/src/kernels/raster.rs:190
    let largest = (max(max(radiance_1.x, radiance_1.y), radiance_1.z) * scale);
    // glimt_render_gpu/src/kernels/raster.rs:191
    if (largest > 65504f) {
        // glimt_render_gpu/src/kernels/raster.rs:192
        return (scale * (65504f / largest));
    }
    // glimt_render_gpu/src/kernels/raster.rs:194
    return scale;
}

// glimt_render_gpu/src/kernels/raster.rs:152
fn draw(triangle_2: u32, weights_1: vec2<f32>, raster_1: RasterParams) -> Drawn {

    // glimt_render_gpu/src/kernels/raster.rs:160
    let u_7 = clamp(weights_1.x, 0f, 1f);
    // glimt_render_gpu/src/kernels/raster.rs:161
    let v_10 = clamp(weights_1.y, 0f, (1f - u_7));
    // glimt_render_gpu/src/kernels/raster.rs:162
    let at_1 = scene_triangles[triangle_2];
    // glimt_render_gpu/src/kernels/raster.rs:163
    let _e20 = Triangle_a(at_1);
    let _e21 = Triangle_b(at_1);
    let _e22 = Triangle_a(at_1);
    let _e26 = Triangle_c(at_1);
    let _e27 = Triangle_a(at_1);
    let p_2 = ((_e20 + ((_e21 - _e22) * u_7)) + ((_e26 - _e27) * v_10));
    // glimt_render_gpu/src/kernels/raster.rs:164
    let to_point = (p_2 - raster_1.frame.eye);
    // glimt_render_gpu/src/kernels/raster.rs:165
    let _e39 = Ray_new(raster_1.frame.eye, normalize(to_point));
    // glimt_render_gpu/src/kernels/raster.rs:166
    let hit_3 = Hit(triangle_2, length(to_point), vec2<f32>(u_7, v_10));
    // glimt_render_gpu/src/kernels/raster.rs:171
    // glimt_render_gpu/src/kernels/raster.rs:176
    let _e48 = at_hit(_e39, hit_3, raster_1.map_size, raster_1.map_rotation);
    // glimt_render_gpu/src/kernels/raster.rs:177
    let _e50 = Triangle_is_catcher(at_1);
    let _e51 = LayerSample_of(_e48, _e50);
    // glimt_render_gpu/src/kernels/raster.rs:178
    let _e57 = fitting_scale(max(_e51.radiance, _e51.blocked), raster_1.scale);
    // glimt_render_gpu/src/kernels/raster.rs:179
    let radiance_2 = (_e51.radiance * _e57);
    // glimt_render_gpu/src/kernels/raster.rs:180
    return Drawn(vec4<f32>((radiance_2 * _e51.alpha), _e51.alpha), vec4<f32>((radiance_2 * _e51.catcher), _e51.catcher), vec4<f32>((_e51.blocked * _e57), 0f));
}

