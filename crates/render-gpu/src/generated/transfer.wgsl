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

struct TransferVertex {
    origin: vec3<f32>,
    object: u32,
    normal: vec3<f32>,
    number: u32,
    inner: vec3<f32>,
    unused: f32,
}

struct TransferParams {
    bands: u32,
    directions: u32,
    rows: u32,
    seed: u32,
    first_row: u32,
    end_row: u32,
}

struct Tuple_u32_u32_ {
    fa: u32,
    fb: u32,
}

struct Ray {
    origin: vec3<f32>,
    direction: vec3<f32>,
    inverse_direction: vec3<f32>,
    key: u32,
}

struct Asked {
    object: u32,
    own: bool,
    near: f32,
    way: vec3<f32>,
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

struct Xoshiro128PlusPlus {
    state: vec4<u32>,
}

struct Params {
    first: u32,
    count: u32,
    state_len: u32,
    lit_len: u32,
    blocked_len: u32,
    @align(16) params: TransferParams,
}

@group(0) @binding(1) 
var<storage> nodes: array<BvhNode>;
@group(0) @binding(2) 
var<storage> triangles: array<Triangle>;
@group(0) @binding(3) 
var<storage> surface: array<u32>;
@group(0) @binding(4) 
var<storage> vertices: array<TransferVertex>;
@group(0) @binding(5) 
var<storage, read_write> state_1: array<u32>;
@group(0) @binding(6) 
var<storage, read_write> lit: array<f32>;
@group(0) @binding(7) 
var<storage, read_write> blocked: array<f32>;
@group(0) @binding(8) 
var<storage, read_write> out: array<u32>;
@group(0) @binding(0) 
var<uniform> params_2: Params;

// glimt_render_gpu/src/kernels/ray.rs:59
fn inverse(x: f32) -> f32 {

    // glimt_render_gpu/src/kernels/ray.rs:60
    return (1f / bitcast<f32>(((bitcast<u32>(max(abs(x), 0.000000000000000001f)) & 2147483647u) | (bitcast<u32>(x) & 2147483648u))));
}

// glimt_render_gpu/src/kernels/ray.rs:44
fn Ray_keyed(origin: vec3<f32>, direction: vec3<f32>, key: u32) -> Ray {

    // glimt_render_gpu/src/kernels/ray.rs:45
    let _e6 = inverse(direction.x);
    let _e8 = inverse(direction.y);
    let _e10 = inverse(direction.z);
    return Ray(origin, direction, vec3<f32>(_e6, _e8, _e10), key);
}

// glimt_render_gpu/src/kernels/ray.rs:37
fn Ray_new(origin_1: vec3<f32>, direction_1: vec3<f32>) -> Ray {

    // glimt_render_gpu/src/kernels/ray.rs:38
    let _e5 = Ray_keyed(origin_1, direction_1, 0u);
    return _e5;
}

// glimt_render_gpu/src/kernels/bvh.rs:53
fn meet(node: BvhNode, ray: Ray, reach: f32) -> Met {
    var node_1: BvhNode;

    node_1 = node;
    // glimt_render_gpu/src/kernels/bvh.rs:54
    let _e12 = Tuple_f32_f32_f32_(ray.origin.x, ray.origin.y, ray.origin.z);
    let x_6 = _e12.fa;
    let y_2 = _e12.fb;
    let z_5 = _e12.fc;
    // glimt_render_gpu/src/kernels/bvh.rs:55
    let inverse_1 = ray.inverse_direction;
    // glimt_render_gpu/src/kernels/bvh.rs:56
    let _e20 = node_1.min_x;
    let to_min_x = ((_e20 - vec4(x_6)) * inverse_1.x);
    // glimt_render_gpu/src/kernels/bvh.rs:57
    let _e27 = node_1.max_x;
    let to_max_x = ((_e27 - vec4(x_6)) * inverse_1.x);
    // glimt_render_gpu/src/kernels/bvh.rs:58
    let _e34 = node_1.min_y;
    let to_min_y = ((_e34 - vec4(y_2)) * inverse_1.y);
    // glimt_render_gpu/src/kernels/bvh.rs:59
    let _e41 = node_1.max_y;
    let to_max_y = ((_e41 - vec4(y_2)) * inverse_1.y);
    // glimt_render_gpu/src/kernels/bvh.rs:60
    let _e48 = node_1.min_z;
    let to_min_z = ((_e48 - vec4(z_5)) * inverse_1.z);
    // glimt_render_gpu/src/kernels/bvh.rs:61
    let _e55 = node_1.max_z;
    let to_max_z = ((_e55 - vec4(z_5)) * inverse_1.z);
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

// glimt_render_gpu/src/kernels/triangle.rs:85
fn Triangle_is_catcher(this_: Triangle) -> bool {

    // glimt_render_gpu/src/kernels/triangle.rs:86
    return ((this_.object & 2147483648u) != 0u);
}

// glimt_render_gpu/src/kernels/triangle.rs:92
fn Triangle_object_index(this_1: Triangle) -> u32 {

    // glimt_render_gpu/src/kernels/triangle.rs:93
    return (this_1.object & 536870911u);
}

// glimt_render_gpu/src/kernels/triangle.rs:163
fn seen(triangle: Triangle, ray_1: Ray) -> Seen {

    // glimt_render_gpu/src/kernels/triangle.rs:164
    let x_7 = (triangle.x - vec4(ray_1.origin.x));
    // glimt_render_gpu/src/kernels/triangle.rs:165
    let y_3 = (triangle.y - vec4(ray_1.origin.y));
    // glimt_render_gpu/src/kernels/triangle.rs:166
    let z_6 = (triangle.z - vec4(ray_1.origin.z));
    // glimt_render_gpu/src/kernels/triangle.rs:168
    let _e24 = Tuple_Vec4_Vec4_(x_7.yzxw, x_7.zxyw);
    let x1_ = _e24.fa;
    let x2_ = _e24.fb;
    // glimt_render_gpu/src/kernels/triangle.rs:169
    let _e30 = Tuple_Vec4_Vec4_(y_3.yzxw, y_3.zxyw);
    let y1_ = _e30.fa;
    let y2_ = _e30.fb;
    // glimt_render_gpu/src/kernels/triangle.rs:170
    let _e36 = Tuple_Vec4_Vec4_(z_6.yzxw, z_6.zxyw);
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
    let d_1 = ray_1.direction;
    // glimt_render_gpu/src/kernels/triangle.rs:174
    let functions = (((((edge_y * sum_z) - (edge_z * sum_y)) * d_1.x) + (((edge_z * sum_x) - (edge_x * sum_z)) * d_1.y)) + (((edge_x * sum_y) - (edge_y * sum_x)) * d_1.z));
    // glimt_render_gpu/src/kernels/triangle.rs:177
    return Seen(vec3<f32>(x_7.x, y_3.x, z_6.x), edge_x, edge_y, edge_z, functions);
}

// glimt_render_gpu/src/kernels/triangle.rs:191
fn intersect(triangle_1: Triangle, ray_2: Ray, t_max: f32) -> f32 {
    var chosen: f32;

    // glimt_render_gpu/src/kernels/triangle.rs:192
    let _e5 = seen(triangle_1, ray_2);
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
    let slope = dot(normal, ray_2.direction);
    // glimt_render_gpu/src/kernels/triangle.rs:200
    if (slope == 0f) {
        // glimt_render_gpu/src/kernels/triangle.rs:201
        return 0x1.fffffep+127f;
    }
    // glimt_render_gpu/src/kernels/triangle.rs:203
    let t_4 = (dot(_e5.a, normal) / slope);
    // glimt_render_gpu/src/kernels/triangle.rs:204
    if ((t_4 > 0f) && (t_4 < t_max)) {
        chosen = t_4;
    } else {
        chosen = 0x1.fffffep+127f;
    }
    let _e67 = chosen;
    return _e67;
}

// glimt_render_gpu/src/kernels/triangle.rs:99
fn Triangle_is_see_through(this_2: Triangle) -> bool {

    // glimt_render_gpu/src/kernels/triangle.rs:100
    return ((this_2.object & 1073741824u) != 0u);
}

// glimt_render_gpu/src/kernels/triangle.rs:210
fn barycentrics(triangle_2: Triangle, ray_3: Ray) -> vec2<f32> {

    // glimt_render_gpu/src/kernels/triangle.rs:211
    let _e4 = seen(triangle_2, ray_3);
    let w_1 = _e4.functions.xyz;
    // glimt_render_gpu/src/kernels/triangle.rs:212
    let sum = ((w_1.x + w_1.y) + w_1.z);
    // glimt_render_gpu/src/kernels/triangle.rs:213
    if (sum == 0f) {
        // glimt_render_gpu/src/kernels/triangle.rs:215
        return vec2((1f / 3f));
    }
    // glimt_render_gpu/src/kernels/triangle.rs:217
    return (vec2<f32>(w_1.y, w_1.z) / vec2(sum));
}

// glimt_render_gpu/src/kernels/material.rs:141
fn Attributes_of_corner(first: u32) -> Attributes {

    // glimt_render_gpu/src/kernels/material.rs:142
    let _e7 = surface[(first + 2u)];
    let _e12 = surface[(first + 3u)];
    let _e13 = Tuple_u32_u32_(_e7, _e12);
    let low = _e13.fa;
    let high = _e13.fb;
    // glimt_render_gpu/src/kernels/material.rs:143
    let color = vec4<f32>(f32((low & 65535u)), f32((low >> 16u)), f32((high & 65535u)), f32((high >> 16u)));
    // glimt_render_gpu/src/kernels/material.rs:149
    let _e33 = surface[first];
    let _e39 = surface[(first + 1u)];
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
    let w_2 = ((1f - u) - v);
    // glimt_render_gpu/src/kernels/material.rs:134
    return Attributes((((_e5.uv * w_2) + (_e9.uv * u)) + (_e15.uv * v)), (((_e5.color * w_2) + (_e9.color * u)) + (_e15.color * v)));
}

// glimt_render_gpu/src/kernels/material.rs:172
fn MaterialView_new(index: u32) -> Returned_MaterialView_new {

    // glimt_render_gpu/src/kernels/material.rs:173
    let first_4 = (256u + (index * 76u));
    // glimt_render_gpu/src/kernels/material.rs:174
    return Returned_MaterialView_new(first_4, ((first_4 + 76u) - first_4));
}

// glimt_render_gpu/src/kernels/material.rs:181
fn MaterialView_number(words_start: u32, words_len: u32, word: u32) -> f32 {

    // glimt_render_gpu/src/kernels/material.rs:182
    let _e7 = surface[(words_start + word)];
    return bitcast<f32>(_e7);
}

// glimt_render_gpu/src/kernels/material.rs:195
fn MaterialView_texture(words_start_1: u32, words_len_1: u32, word_1: u32) -> TextureView {

    // glimt_render_gpu/src/kernels/material.rs:196
    let _e7 = surface[(words_start_1 + word_1)];
    let _e13 = surface[(words_start_1 + (word_1 + 1u))];
    let _e19 = surface[(words_start_1 + (word_1 + 2u))];
    let _e25 = surface[(words_start_1 + (word_1 + 3u))];
    return TextureView(_e7, _e13, _e19, _e25);
}

// glimt_render_gpu/src/kernels/texture.rs:40
fn TextureView_exists(this_3: TextureView) -> bool {

    // glimt_render_gpu/src/kernels/texture.rs:41
    return (this_3.width > 0u);
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
fn TextureView_texel(this_4: TextureView, index_2: u32) -> vec4<f32> {
    var chosen_1: vec4<f32>;

    // glimt_render_gpu/src/kernels/texture.rs:70
    let word_3 = surface[(this_4.first + index_2)];
    // glimt_render_gpu/src/kernels/texture.rs:71
    let r = (word_3 & 255u);
    // glimt_render_gpu/src/kernels/texture.rs:72
    let g = ((word_3 >> 8u) & 255u);
    // glimt_render_gpu/src/kernels/texture.rs:73
    let b_2 = ((word_3 >> 16u) & 255u);
    // glimt_render_gpu/src/kernels/texture.rs:74
    let alpha_2 = (f32((word_3 >> 24u)) / 255f);
    // glimt_render_gpu/src/kernels/texture.rs:75
    if ((this_4.flags & 1u) != 0u) {
        // glimt_render_gpu/src/kernels/texture.rs:76
        let _e38 = surface[r];
        let _e42 = surface[g];
        let _e46 = surface[b_2];
        chosen_1 = vec4<f32>(bitcast<f32>(_e38), bitcast<f32>(_e42), bitcast<f32>(_e46), alpha_2);
    } else {
        // glimt_render_gpu/src/kernels/texture.rs:83
        chosen_1 = vec4<f32>((f32(r) / 255f), (f32(g) / 255f), (f32(b_2) / 255f), alpha_2);
    }
    let _e60 = chosen_1;
    return _e60;
}

// glimt_render_gpu/src/kernels/texture.rs:49
fn TextureView_sample(this_5: TextureView, uv: vec2<f32>) -> vec4<f32> {

    // glimt_render_gpu/src/kernels/texture.rs:50
    let wrap_u = ((this_5.flags >> 1u) & 3u);
    // glimt_render_gpu/src/kernels/texture.rs:51
    let wrap_v = ((this_5.flags >> ((1u + 2u) & 31u)) & 3u);
    // glimt_render_gpu/src/kernels/texture.rs:52
    let _e21 = wrap(uv.x, wrap_u);
    let x_8 = ((_e21 * f32(this_5.width)) - 0.5f);
    // glimt_render_gpu/src/kernels/texture.rs:53
    let _e29 = wrap(uv.y, wrap_v);
    let y_4 = ((_e29 * f32(this_5.height)) - 0.5f);
    // glimt_render_gpu/src/kernels/texture.rs:54
    let _e38 = Tuple_f32_f32_(floor(x_8), floor(y_4));
    let left = _e38.fa;
    let top = _e38.fb;
    // glimt_render_gpu/src/kernels/texture.rs:55
    let _e44 = neighbour(i32(left), this_5.width, wrap_u);
    // glimt_render_gpu/src/kernels/texture.rs:56
    let _e50 = neighbour((i32(left) + 1i), this_5.width, wrap_u);
    // glimt_render_gpu/src/kernels/texture.rs:57
    let _e54 = neighbour(i32(top), this_5.height, wrap_v);
    let row0_ = (_e54 * this_5.width);
    // glimt_render_gpu/src/kernels/texture.rs:58
    let _e62 = neighbour((i32(top) + 1i), this_5.height, wrap_v);
    let row1_ = (_e62 * this_5.width);
    // glimt_render_gpu/src/kernels/texture.rs:59
    let _e67 = TextureView_texel(this_5, (row0_ + _e44));
    let _e69 = TextureView_texel(this_5, (row0_ + _e50));
    let _e70 = (x_8 - left);
    let upper = ((_e67 * (1f - _e70)) + (_e69 * _e70));
    // glimt_render_gpu/src/kernels/texture.rs:62
    let _e78 = TextureView_texel(this_5, (row1_ + _e44));
    let _e80 = TextureView_texel(this_5, (row1_ + _e50));
    let _e81 = (x_8 - left);
    let lower = ((_e78 * (1f - _e81)) + (_e80 * _e81));
    // glimt_render_gpu/src/kernels/texture.rs:65
    let _e88 = (y_4 - top);
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
        let t_5 = (word_2 + 4u);
        // glimt_render_gpu/src/kernels/material.rs:210
        let _e18 = MaterialView_number(words_start_2, words_len_2, t_5);
        let _e21 = MaterialView_number(words_start_2, words_len_2, (t_5 + 1u));
        let _e27 = MaterialView_number(words_start_2, words_len_2, (t_5 + 2u));
        let _e30 = MaterialView_number(words_start_2, words_len_2, (t_5 + 3u));
        let _e37 = MaterialView_number(words_start_2, words_len_2, (t_5 + 4u));
        let _e40 = MaterialView_number(words_start_2, words_len_2, (t_5 + 5u));
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
    var chosen_2: f32;

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
        chosen_2 = 1f;
    } else {
        chosen_2 = 0f;
    }
    let _e35 = chosen_2;
    return _e35;
}

// glimt_render_gpu/src/kernels/opacity.rs:14
fn alpha_at(triangle_3: Triangle, u_1: f32, v_1: f32) -> f32 {

    // glimt_render_gpu/src/kernels/opacity.rs:15
    let _e6 = Attributes_at(triangle_3.attributes, u_1, v_1);
    // glimt_render_gpu/src/kernels/opacity.rs:16
    let _e11 = MaterialView_new((triangle_3.material & 2147483647u));
    // glimt_render_gpu/src/kernels/opacity.rs:17
    let _e18 = MaterialView_alpha(_e11.value_words_start, _e11.value_words_len, _e6.uv, _e6.color.w);
    return _e18;
}

// glimt_sampling/src/hash.rs:15
fn hash_u32_(n: u32) -> u32 {
    var x_2: u32;

    // glimt_sampling/src/hash.rs:16
    x_2 = (n ^ 3875421163u);
    // glimt_sampling/src/hash.rs:17
    let _e7 = x_2;
    let _e10 = x_2;
    x_2 = (_e10 ^ (_e7 >> 16u));
    // glimt_sampling/src/hash.rs:18
    let _e13 = x_2;
    x_2 = (_e13 * 2146121005u);
    // glimt_sampling/src/hash.rs:19
    let _e17 = x_2;
    let _e20 = x_2;
    x_2 = (_e20 ^ (_e17 >> 15u));
    // glimt_sampling/src/hash.rs:20
    let _e23 = x_2;
    x_2 = (_e23 * 2221713035u);
    // glimt_sampling/src/hash.rs:21
    let _e27 = x_2;
    let _e28 = x_2;
    return (_e27 ^ (_e28 >> 16u));
}

// glimt_sampling/src/hash.rs:27
fn hash2_(a: u32, b: u32) -> u32 {

    // glimt_sampling/src/hash.rs:28
    let _e4 = hash_u32_(a);
    let _e6 = hash_u32_((_e4 + b));
    return _e6;
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
fn is_passed(index_4: u32, triangle_4: Triangle, ray_4: Ray) -> bool {

    // glimt_render_gpu/src/kernels/opacity.rs:34
    let _e5 = barycentrics(triangle_4, ray_4);
    // glimt_render_gpu/src/kernels/opacity.rs:35
    let _e9 = alpha_at(triangle_4, _e5.x, _e5.y);
    // glimt_render_gpu/src/kernels/opacity.rs:36
    let _e12 = passes(ray_4.key, index_4, _e9);
    return _e12;
}

// glimt_render_gpu/src/kernels/triangle.rs:71
fn Triangle_b(this_6: Triangle) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/triangle.rs:72
    return vec3<f32>(this_6.x.y, this_6.y.y, this_6.z.y);
}

// glimt_render_gpu/src/kernels/triangle.rs:64
fn Triangle_a(this_7: Triangle) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/triangle.rs:65
    return vec3<f32>(this_7.x.x, this_7.y.x, this_7.z.x);
}

// glimt_render_gpu/src/kernels/triangle.rs:78
fn Triangle_c(this_8: Triangle) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/triangle.rs:79
    return vec3<f32>(this_8.x.z, this_8.y.z, this_8.z.z);
}

// glimt_render_gpu/src/kernels/triangle.rs:140
fn Triangle_area_normal(this_9: Triangle) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/triangle.rs:141
    let _e3 = Triangle_b(this_9);
    let _e4 = Triangle_a(this_9);
    let _e6 = Triangle_c(this_9);
    let _e7 = Triangle_a(this_9);
    return cross((_e3 - _e4), (_e6 - _e7));
}

// glimt_render_gpu/src/kernels/triangle.rs:128
fn Triangle_outward(this_10: Triangle) -> vec3<f32> {
    var chosen_3: vec3<f32>;

    // glimt_render_gpu/src/kernels/triangle.rs:129
    let _e3 = Triangle_area_normal(this_10);
    // glimt_render_gpu/src/kernels/triangle.rs:130
    if ((this_10.object & 536870912u) != 0u) {
        // glimt_render_gpu/src/kernels/triangle.rs:131
        chosen_3 = -(_e3);
    } else {
        // glimt_render_gpu/src/kernels/triangle.rs:133
        chosen_3 = _e3;
    }
    let _e14 = chosen_3;
    return _e14;
}

// glimt_render_gpu/src/kernels/bvh.rs:252
fn any_hit_of(ray_5: Ray, t_max_1: f32, asked: Asked) -> bool {
    var stack: array<u32, 64>;
    var height: u32;
    var node_2: BvhNode;
    var met: Met;
    var counter: u32;
    var both: bool;
    var counter_1: u32;
    var both_1: bool;
    var both_2: bool;
    var both_3: bool;
    var both_4: bool;
    var both_5: bool;

    // glimt_render_gpu/src/kernels/bvh.rs:260
    if (arrayLength((&nodes)) == 0u) {
        // glimt_render_gpu/src/kernels/bvh.rs:261
        return false;
    }
    // glimt_render_gpu/src/kernels/bvh.rs:263
    stack = array<u32, 64>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
    // glimt_render_gpu/src/kernels/bvh.rs:264
    height = 1u;
    // glimt_render_gpu/src/kernels/bvh.rs:265
    loop {
        let _e19 = height;
        if !((_e19 > 0u)) {
            break;
        }
        // glimt_render_gpu/src/kernels/bvh.rs:266
        let _e25 = height;
        height = (_e25 - 1u);
        // glimt_render_gpu/src/kernels/bvh.rs:267
        let _e28 = height;
        let at_1 = stack[_e28];
        // glimt_render_gpu/src/kernels/bvh.rs:268
        if (at_1 < 2147483648u) {
            // glimt_render_gpu/src/kernels/bvh.rs:269
            let _e37 = nodes[at_1];
            node_2 = _e37;
            // glimt_render_gpu/src/kernels/bvh.rs:270
            let _e40 = node_2;
            let _e41 = meet(_e40, ray_5, t_max_1);
            met = _e41;
            // glimt_render_gpu/src/kernels/bvh.rs:271
            counter = 0u;
            loop {
                let i = counter;
                if (i >= 4u) {
                    break;
                }
                // glimt_render_gpu/src/kernels/bvh.rs:272
                let _e51 = met.children;
                let _e58 = (((_e51 >> (i & 31u)) & 1u) != 0u);
                both = _e58;
                if _e58 {
                    let _e62 = node_2.children[i];
                    both = (_e62 > 0u);
                }
                let _e65 = both;
                if _e65 {
                    // glimt_render_gpu/src/kernels/bvh.rs:273
                    let _e69 = node_2.children[i];
                    let _e70 = height;
                    stack[_e70] = _e69;
                    // glimt_render_gpu/src/kernels/bvh.rs:274
                    let _e74 = height;
                    height = (_e74 + 1u);
                }
                continuing {
                    let _e76 = counter;
                    counter = (_e76 + 1u);
                }
            }
        } else {
            // glimt_render_gpu/src/kernels/bvh.rs:278
            let first_5 = (at_1 - 2147483648u);
            // glimt_render_gpu/src/kernels/bvh.rs:279
            let _e86 = triangles[first_5].run;
            counter_1 = first_5;
            loop {
                let i_1 = counter_1;
                if (i_1 >= (first_5 + _e86)) {
                    break;
                }
                // glimt_render_gpu/src/kernels/bvh.rs:280
                let triangle_6 = triangles[i_1];
                // glimt_render_gpu/src/kernels/bvh.rs:281
                let _e96 = Triangle_is_catcher(triangle_6);
                let _e97 = !(_e96);
                both_1 = _e97;
                if _e97 {
                    let _e99 = Triangle_object_index(triangle_6);
                    both_1 = ((_e99 == asked.object) == asked.own);
                }
                let _e104 = both_1;
                if _e104 {
                    // glimt_render_gpu/src/kernels/bvh.rs:283
                    let _e106 = intersect(triangle_6, ray_5, t_max_1);
                    // glimt_render_gpu/src/kernels/bvh.rs:284
                    let _e108 = (_e106 < t_max_1);
                    both_2 = _e108;
                    if _e108 {
                        let _e110 = Triangle_is_see_through(triangle_6);
                        both_3 = _e110;
                        if _e110 {
                            let _e112 = is_passed(i_1, triangle_6, ray_5);
                            both_3 = _e112;
                        }
                        let _e113 = both_3;
                        both_2 = !(_e113);
                    }
                    let is_met = both_2;
                    // glimt_render_gpu/src/kernels/bvh.rs:286
                    both_4 = is_met;
                    if is_met {
                        let _e119 = (_e106 < asked.near);
                        both_5 = _e119;
                        if _e119 {
                            let _e121 = Triangle_outward(triangle_6);
                            both_5 = (dot(_e121, asked.way) > 0f);
                        }
                        let _e126 = both_5;
                        both_4 = !(_e126);
                    }
                    let _e128 = both_4;
                    if _e128 {
                        // glimt_render_gpu/src/kernels/bvh.rs:287
                        return true;
                    }
                }
                continuing {
                    let _e131 = counter_1;
                    counter_1 = (_e131 + 1u);
                }
            }
        }
    }
    // glimt_render_gpu/src/kernels/bvh.rs:293
    return false;
}

// glimt_sampling/src/hash.rs:50
fn hash_uvec4_(v_2: vec4<u32>) -> vec4<u32> {
    var x_3: u32;
    var y: u32;
    var z: u32;
    var w: u32;

    // glimt_sampling/src/hash.rs:51
    let _e4 = hash_u32_(v_2.x);
    x_3 = ((_e4 * 1664525u) + 1013904223u);
    // glimt_sampling/src/hash.rs:54
    let _e12 = hash_u32_(v_2.y);
    y = ((_e12 * 1664525u) + 1013904223u);
    // glimt_sampling/src/hash.rs:57
    let _e20 = hash_u32_(v_2.z);
    z = ((_e20 * 1664525u) + 1013904223u);
    // glimt_sampling/src/hash.rs:60
    let _e28 = hash_u32_(v_2.w);
    w = ((_e28 * 1664525u) + 1013904223u);
    // glimt_sampling/src/hash.rs:64
    let _e35 = x_3;
    let _e36 = y;
    let _e37 = w;
    x_3 = (_e35 + (_e36 * _e37));
    // glimt_sampling/src/hash.rs:65
    let _e41 = y;
    let _e42 = z;
    let _e43 = x_3;
    y = (_e41 + (_e42 * _e43));
    // glimt_sampling/src/hash.rs:66
    let _e47 = z;
    let _e48 = x_3;
    let _e49 = y;
    z = (_e47 + (_e48 * _e49));
    // glimt_sampling/src/hash.rs:67
    let _e53 = w;
    let _e54 = y;
    let _e55 = z;
    w = (_e53 + (_e54 * _e55));
    // glimt_sampling/src/hash.rs:68
    let _e59 = x_3;
    let _e62 = x_3;
    x_3 = (_e62 ^ (_e59 >> 16u));
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
    let _e83 = x_3;
    let _e84 = y;
    let _e85 = w;
    x_3 = (_e83 + (_e84 * _e85));
    // glimt_sampling/src/hash.rs:73
    let _e89 = y;
    let _e90 = z;
    let _e91 = x_3;
    y = (_e89 + (_e90 * _e91));
    // glimt_sampling/src/hash.rs:74
    let _e95 = z;
    let _e96 = x_3;
    let _e97 = y;
    z = (_e95 + (_e96 * _e97));
    // glimt_sampling/src/hash.rs:75
    let _e101 = w;
    let _e102 = y;
    let _e103 = z;
    w = (_e101 + (_e102 * _e103));
    // glimt_sampling/src/hash.rs:76
    let _e107 = x_3;
    let _e108 = x_3;
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
fn Xoshiro128PlusPlus_stream(seed: u32, frame: u32, pixel: u32) -> Xoshiro128PlusPlus {

    // glimt_sampling/src/xoshiro.rs:50
    let _e7 = hash_uvec4_(vec4<u32>(pixel, frame, seed, 2654435769u));
    let _e8 = Xoshiro128PlusPlus_from_state(_e7);
    return _e8;
}

// glimt_render_gpu/src/kernels/transfer.rs:160
fn strata_of_row(params: TransferParams, row: u32) -> vec2<u32> {

    // glimt_render_gpu/src/kernels/transfer.rs:161
    let first_6 = ((row * params.directions) / params.rows);
    // glimt_render_gpu/src/kernels/transfer.rs:162
    let next_1 = (((row + 1u) * params.directions) / params.rows);
    // glimt_render_gpu/src/kernels/transfer.rs:163
    return vec2<u32>(first_6, (next_1 - first_6));
}

// glimt_sampling/src/xoshiro.rs:56
fn Xoshiro128PlusPlus_next_u32_(this_11: ptr<function, Xoshiro128PlusPlus>) -> u32 {

    // glimt_sampling/src/xoshiro.rs:57
    let s = (*this_11).state;
    // glimt_sampling/src/xoshiro.rs:58
    let _e8 = (s.x + s.w);
    let result = (((_e8 << 7u) | (_e8 >> ((0u - 7u) & 31u))) + s.x);
    // glimt_sampling/src/xoshiro.rs:59
    let z_7 = (s.z ^ s.x);
    // glimt_sampling/src/xoshiro.rs:60
    let w_3 = (s.w ^ s.y);
    // glimt_sampling/src/xoshiro.rs:61
    (*this_11).state = vec4<u32>((s.x ^ w_3), (s.y ^ z_7), (z_7 ^ (s.y << 9u)), ((w_3 << 11u) | (w_3 >> ((0u - 11u) & 31u))));
    // glimt_sampling/src/xoshiro.rs:62
    return result;
}

// glimt_sampling/src/uniform.rs:34
fn Xoshiro128PlusPlus_next_uvec2_(this_12: ptr<function, Xoshiro128PlusPlus>) -> vec2<u32> {

    // glimt_sampling/src/uniform.rs:35
    let _e3 = Xoshiro128PlusPlus_next_u32_(this_12);
    // glimt_sampling/src/uniform.rs:36
    let _e5 = Xoshiro128PlusPlus_next_u32_(this_12);
    // glimt_sampling/src/uniform.rs:37
    return vec2<u32>(_e3, _e5);
}

// glimt_sampling/src/uniform.rs:22
fn unit_vec2_(u_3: vec2<u32>) -> vec2<f32> {

    // glimt_sampling/src/uniform.rs:23
    let _e4 = unit_f32_(u_3.x);
    let _e6 = unit_f32_(u_3.y);
    return vec2<f32>(_e4, _e6);
}

// glimt_probe/src/trig.rs:25
fn cos_sin_pi(x_4: f32) -> vec2<f32> {
    var chosen_4: vec2<f32>;

    // glimt_probe/src/trig.rs:27
    let quarter = floor(((2f * x_4) + 0.5f));
    // glimt_probe/src/trig.rs:28
    let y_5 = (x_4 - (0.5f * quarter));
    // glimt_probe/src/trig.rs:29
    let y2_1 = (y_5 * y_5);
    // glimt_probe/src/trig.rs:31
    let c_1 = (1f + (y2_1 * (-4.934802f + (y2_1 * (4.058712f + (y2_1 * (-1.3352627f + (y2_1 * (0.23533063f + (y2_1 * -0.02580689f))))))))));
    // glimt_probe/src/trig.rs:34
    let s_1 = (y_5 * (3.1415927f + (y2_1 * (-5.1677127f + (y2_1 * (2.550164f + (y2_1 * (-0.5992645f + (y2_1 * 0.082145885f)))))))));
    // glimt_probe/src/trig.rs:37
    let _e49 = (i32(quarter) & 3i);
    if (_e49 == 0i) {
        // glimt_probe/src/trig.rs:38
        chosen_4 = vec2<f32>(c_1, (s_1 + 0f));
    } else {
        if (_e49 == 1i) {
            // glimt_probe/src/trig.rs:39
            chosen_4 = vec2<f32>((0f - s_1), c_1);
        } else {
            if (_e49 == 2i) {
                // glimt_probe/src/trig.rs:40
                chosen_4 = vec2<f32>((0f - c_1), (0f - s_1));
            } else {
                // glimt_probe/src/trig.rs:41
                chosen_4 = vec2<f32>((s_1 + 0f), (0f - c_1));
            }
        }
    }
    let _e77 = chosen_4;
    return _e77;
}

// glimt_render_gpu/src/kernels/transfer.rs:172
fn direction_in_row(n_1: u32, first_2: u32, columns: u32, column: u32, u_4: vec2<f32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/transfer.rs:173
    let down = ((f32(first_2) + (u_4.x * f32(columns))) / f32(n_1));
    // glimt_render_gpu/src/kernels/transfer.rs:174
    let radius = (2f * sqrt((down * (1f - down))));
    // glimt_render_gpu/src/kernels/transfer.rs:175
    let _e31 = cos_sin_pi((((f32(column) + u_4.y) * (2f / f32(columns))) - 1f));
    let around = (_e31 * radius);
    // glimt_render_gpu/src/kernels/transfer.rs:176
    return vec3<f32>(around.x, around.y, (1f - (2f * down)));
}

// glimt_sampling/src/hash.rs:34
fn hash3_(a_1: u32, b_1: u32, c: u32) -> u32 {

    // glimt_sampling/src/hash.rs:35
    let _e5 = hash2_(a_1, b_1);
    let _e7 = hash_u32_((_e5 + c));
    return _e7;
}

// glimt_render_gpu/src/kernels/triangle.rs:106
fn Triangle_ray_offset(this_13: Triangle) -> f32 {

    // glimt_render_gpu/src/kernels/triangle.rs:107
    let extent = max(max(abs(this_13.x), abs(this_13.y)), abs(this_13.z));
    // glimt_render_gpu/src/kernels/triangle.rs:108
    return (0.0000038146973f * max(max(max(extent.x, extent.y), extent.z), extent.w));
}

// glimt_render_gpu/src/kernels/triangle.rs:114
fn Triangle_setback(this_14: Triangle, ray_6: Ray, t: f32) -> f32 {

    // glimt_render_gpu/src/kernels/triangle.rs:115
    let _e5 = Triangle_area_normal(this_14);
    // glimt_render_gpu/src/kernels/triangle.rs:116
    let across = abs(dot(_e5, ray_6.direction));
    // glimt_render_gpu/src/kernels/triangle.rs:117
    let _e12 = Triangle_ray_offset(this_14);
    let apart = (2f * max(_e12, ((0.0000038146973f * t) * sqrt(dot(ray_6.direction, ray_6.direction)))));
    // glimt_render_gpu/src/kernels/triangle.rs:122
    return min(((apart * sqrt(dot(_e5, _e5))) / max(across, 0.000000000000000000000000000000000000011754944f)), t);
}

// glimt_render_gpu/src/kernels/bvh.rs:214
fn held(index_5: u32, triangle_5: Triangle, ray_7: Ray, t_1: f32, no_catcher: bool) -> f32 {
    var both_6: bool;

    // glimt_render_gpu/src/kernels/bvh.rs:222
    let _e7 = Triangle_is_see_through(triangle_5);
    both_6 = _e7;
    if _e7 {
        let _e9 = is_passed(index_5, triangle_5, ray_7);
        both_6 = _e9;
    }
    let _e10 = both_6;
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
    let _e21 = Triangle_setback(triangle_5, ray_7, t_1);
    return (t_1 + _e21);
}

// glimt_render_gpu/src/kernels/bvh.rs:187
fn visit_leaf(first_3: u32, ray_8: Ray, reach_1: ptr<function, f32>, best: u32, no_catcher_1: bool) -> u32 {
    var nearest: u32;
    var counter_2: u32;
    var t_2: f32;
    var both_7: bool;

    // glimt_render_gpu/src/kernels/bvh.rs:196
    nearest = best;
    // glimt_render_gpu/src/kernels/bvh.rs:197
    let _e12 = triangles[first_3].run;
    counter_2 = first_3;
    loop {
        let i_2 = counter_2;
        if (i_2 >= (first_3 + _e12)) {
            break;
        }
        // glimt_render_gpu/src/kernels/bvh.rs:198
        let _e20 = triangles[i_2];
        let _e21 = (*reach_1);
        let _e22 = intersect(_e20, ray_8, _e21);
        t_2 = _e22;
        // glimt_render_gpu/src/kernels/bvh.rs:200
        let _e25 = t_2;
        let _e26 = (*reach_1);
        let _e27 = (_e25 < _e26);
        both_7 = _e27;
        if _e27 {
            let _e32 = triangles[i_2].object;
            both_7 = (_e32 >= 1073741824u);
        }
        let _e35 = both_7;
        if _e35 {
            // glimt_render_gpu/src/kernels/bvh.rs:201
            let _e39 = triangles[i_2];
            let _e40 = t_2;
            let _e41 = held(i_2, _e39, ray_8, _e40, no_catcher_1);
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
            nearest = i_2;
        }
        continuing {
            let _e49 = counter_2;
            counter_2 = (_e49 + 1u);
        }
    }
    // glimt_render_gpu/src/kernels/bvh.rs:208
    let _e53 = nearest;
    return _e53;
}

// glimt_render_gpu/src/kernels/bvh.rs:125
fn traverse(ray_9: Ray, reach_2: ptr<function, f32>, any_: bool) -> u32 {
    var best_1: u32;
    var stack_1: array<u32, 64>;
    var height_1: u32;
    var at: u32;
    var next: u32;
    var node_3: BvhNode;
    var met_1: Met;
    var distance_: f32;
    var counter_3: u32;
    var waiting: u32;

    // glimt_render_gpu/src/kernels/bvh.rs:133
    if (arrayLength((&nodes)) == 0u) {
        // glimt_render_gpu/src/kernels/bvh.rs:134
        return 4294967295u;
    }
    // glimt_render_gpu/src/kernels/bvh.rs:136
    best_1 = 4294967295u;
    // glimt_render_gpu/src/kernels/bvh.rs:137
    stack_1 = array<u32, 64>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
    // glimt_render_gpu/src/kernels/bvh.rs:138
    height_1 = 0u;
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
            let _e36 = nodes[_e33];
            node_3 = _e36;
            // glimt_render_gpu/src/kernels/bvh.rs:145
            let _e39 = node_3;
            let _e40 = (*reach_2);
            let _e41 = meet(_e39, ray_9, _e40);
            met_1 = _e41;
            // glimt_render_gpu/src/kernels/bvh.rs:146
            distance_ = 0x1.fffffep+127f;
            // glimt_render_gpu/src/kernels/bvh.rs:148
            counter_3 = 0u;
            loop {
                let i_3 = counter_3;
                if (i_3 >= 4u) {
                    break;
                }
                // glimt_render_gpu/src/kernels/bvh.rs:149
                let child = node_3.children[i_3];
                // glimt_render_gpu/src/kernels/bvh.rs:150
                let _e58 = met_1.children;
                if (((_e58 >> (i_3 & 31u)) & 1u) != 0u) {
                    // glimt_render_gpu/src/kernels/bvh.rs:152
                    let _e67 = next;
                    waiting = _e67;
                    // glimt_render_gpu/src/kernels/bvh.rs:153
                    if any_ {
                        // glimt_render_gpu/src/kernels/bvh.rs:154
                        next = child;
                    } else {
                        let _e73 = met_1.distances[i_3];
                        let _e74 = distance_;
                        if (_e73 < _e74) {
                            // glimt_render_gpu/src/kernels/bvh.rs:156
                            let _e79 = met_1.distances[i_3];
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
                        let _e88 = height_1;
                        stack_1[_e88] = _e87;
                        // glimt_render_gpu/src/kernels/bvh.rs:163
                        let _e92 = height_1;
                        height_1 = (_e92 + 1u);
                    }
                }
                continuing {
                    let _e94 = counter_3;
                    counter_3 = (_e94 + 1u);
                }
            }
        } else {
            // glimt_render_gpu/src/kernels/bvh.rs:168
            let _e98 = at;
            let _e101 = best_1;
            let _e102 = visit_leaf((_e98 - 2147483648u), ray_9, reach_2, _e101, any_);
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
            let _e115 = height_1;
            if (_e115 == 0u) {
                // glimt_render_gpu/src/kernels/bvh.rs:175
                let _e119 = best_1;
                return _e119;
            }
            // glimt_render_gpu/src/kernels/bvh.rs:177
            let _e122 = height_1;
            height_1 = (_e122 - 1u);
            // glimt_render_gpu/src/kernels/bvh.rs:178
            let _e125 = height_1;
            let _e127 = stack_1[_e125];
            next = _e127;
        }
        // glimt_render_gpu/src/kernels/bvh.rs:180
        let _e129 = next;
        at = _e129;
    }
    return u32();
}

// glimt_render_gpu/src/kernels/bvh.rs:108
fn any_hit(ray_10: Ray, t_max_2: f32) -> bool {
    var t_3: f32;

    // glimt_render_gpu/src/kernels/bvh.rs:115
    t_3 = t_max_2;
    // glimt_render_gpu/src/kernels/bvh.rs:116
    let _e7 = traverse(ray_10, (&t_3), true);
    return (_e7 != 4294967295u);
}

// glimt_sh/src/basis.rs:132
fn turn(p: vec2<f32>, x_5: f32, y_1: f32) -> vec2<f32> {

    // glimt_sh/src/basis.rs:133
    return vec2<f32>(((p.x * x_5) - (p.y * y_1)), ((p.x * y_1) + (p.y * x_5)));
}

// glimt_sh/src/basis.rs:79
fn zonal_2_(z_1: f32) -> array<f32, 3> {

    // glimt_sh/src/basis.rs:80
    return array<f32, 3>((0.31539157f * (((3f * z_1) * z_1) - 1f)), (1.0925485f * z_1), 0.54627424f);
}

// glimt_sh/src/basis.rs:90
fn zonal_3_(z_2: f32) -> array<f32, 4> {

    // glimt_sh/src/basis.rs:91
    let t_6 = (z_2 * z_2);
    // glimt_sh/src/basis.rs:92
    return array<f32, 4>(((0.37317634f * z_2) * ((5f * t_6) - 3f)), (0.4570458f * ((5f * t_6) - 1f)), (1.4453057f * z_2), 0.5900436f);
}

// glimt_sh/src/basis.rs:103
fn zonal_4_(z_3: f32) -> array<f32, 5> {

    // glimt_sh/src/basis.rs:104
    let t_7 = (z_3 * z_3);
    // glimt_sh/src/basis.rs:105
    return array<f32, 5>((0.10578555f * ((((35f * t_7) - 30f) * t_7) + 3f)), ((0.6690465f * z_3) * ((7f * t_7) - 3f)), (0.47308734f * ((7f * t_7) - 1f)), (1.7701308f * z_3), 0.6258357f);
}

// glimt_sh/src/basis.rs:117
fn zonal_5_(z_4: f32) -> array<f32, 6> {

    // glimt_sh/src/basis.rs:118
    let t_8 = (z_4 * z_4);
    // glimt_sh/src/basis.rs:119
    return array<f32, 6>(((0.116950326f * z_4) * ((((63f * t_8) - 70f) * t_8) + 15f)), (0.45294666f * ((((21f * t_8) - 14f) * t_8) + 1f)), ((2.3967683f * z_4) * ((3f * t_8) - 1f)), (0.4892383f * ((9f * t_8) - 1f)), (2.0756624f * z_4), 0.6563821f);
}

// glimt_sh/src/basis.rs:224
fn add_basis(bands: u32, d: vec3<f32>, weight: f32, sums: ptr<function, array<f32, 36>>) {
    var q2_: array<f32, 3>;
    var q3_: array<f32, 4>;
    var q4_: array<f32, 5>;
    var q5_: array<f32, 6>;

    // glimt_sh/src/basis.rs:225
    if (bands > 0u) {
        // glimt_sh/src/basis.rs:226
        let _e12 = (*sums)[0];
        (*sums)[0] = (_e12 + (weight * 0.2820948f));
    }
    // glimt_sh/src/basis.rs:228
    if (bands > 1u) {
        // glimt_sh/src/basis.rs:229
        let p1_ = vec2<f32>(d.x, d.y);
        // glimt_sh/src/basis.rs:230
        let _e27 = (*sums)[1];
        (*sums)[1] = (_e27 + (weight * (0.48860252f * p1_.y)));
        // glimt_sh/src/basis.rs:231
        let _e35 = (*sums)[2];
        (*sums)[2] = (_e35 + (weight * (0.48860252f * d.z)));
        // glimt_sh/src/basis.rs:232
        let _e43 = (*sums)[3];
        (*sums)[3] = (_e43 + (weight * (0.48860252f * p1_.x)));
        // glimt_sh/src/basis.rs:233
        if (bands > 2u) {
            // glimt_sh/src/basis.rs:234
            let _e51 = turn(p1_, d.x, d.y);
            // glimt_sh/src/basis.rs:235
            let _e54 = zonal_2_(d.z);
            q2_ = _e54;
            // glimt_sh/src/basis.rs:236
            let _e58 = q2_[2];
            let _e63 = (*sums)[4];
            (*sums)[4] = (_e63 + (weight * (_e58 * _e51.y)));
            // glimt_sh/src/basis.rs:237
            let _e67 = q2_[1];
            let _e72 = (*sums)[5];
            (*sums)[5] = (_e72 + (weight * (_e67 * p1_.y)));
            // glimt_sh/src/basis.rs:238
            let _e76 = q2_[0];
            let _e79 = (*sums)[6];
            (*sums)[6] = (_e79 + (weight * _e76));
            // glimt_sh/src/basis.rs:239
            let _e83 = q2_[1];
            let _e88 = (*sums)[7];
            (*sums)[7] = (_e88 + (weight * (_e83 * p1_.x)));
            // glimt_sh/src/basis.rs:240
            let _e92 = q2_[2];
            let _e97 = (*sums)[8];
            (*sums)[8] = (_e97 + (weight * (_e92 * _e51.x)));
            // glimt_sh/src/basis.rs:241
            if (bands > 3u) {
                // glimt_sh/src/basis.rs:242
                let _e105 = turn(_e51, d.x, d.y);
                // glimt_sh/src/basis.rs:243
                let _e108 = zonal_3_(d.z);
                q3_ = _e108;
                // glimt_sh/src/basis.rs:244
                let _e112 = q3_[3];
                let _e117 = (*sums)[9];
                (*sums)[9] = (_e117 + (weight * (_e112 * _e105.y)));
                // glimt_sh/src/basis.rs:245
                let _e121 = q3_[2];
                let _e126 = (*sums)[10];
                (*sums)[10] = (_e126 + (weight * (_e121 * _e51.y)));
                // glimt_sh/src/basis.rs:246
                let _e130 = q3_[1];
                let _e135 = (*sums)[11];
                (*sums)[11] = (_e135 + (weight * (_e130 * p1_.y)));
                // glimt_sh/src/basis.rs:247
                let _e139 = q3_[0];
                let _e142 = (*sums)[12];
                (*sums)[12] = (_e142 + (weight * _e139));
                // glimt_sh/src/basis.rs:248
                let _e146 = q3_[1];
                let _e151 = (*sums)[13];
                (*sums)[13] = (_e151 + (weight * (_e146 * p1_.x)));
                // glimt_sh/src/basis.rs:249
                let _e155 = q3_[2];
                let _e160 = (*sums)[14];
                (*sums)[14] = (_e160 + (weight * (_e155 * _e51.x)));
                // glimt_sh/src/basis.rs:250
                let _e164 = q3_[3];
                let _e169 = (*sums)[15];
                (*sums)[15] = (_e169 + (weight * (_e164 * _e105.x)));
                // glimt_sh/src/basis.rs:251
                if (bands > 4u) {
                    // glimt_sh/src/basis.rs:252
                    let _e177 = turn(_e105, d.x, d.y);
                    // glimt_sh/src/basis.rs:253
                    let _e180 = zonal_4_(d.z);
                    q4_ = _e180;
                    // glimt_sh/src/basis.rs:254
                    let _e184 = q4_[4];
                    let _e189 = (*sums)[16];
                    (*sums)[16] = (_e189 + (weight * (_e184 * _e177.y)));
                    // glimt_sh/src/basis.rs:255
                    let _e193 = q4_[3];
                    let _e198 = (*sums)[17];
                    (*sums)[17] = (_e198 + (weight * (_e193 * _e105.y)));
                    // glimt_sh/src/basis.rs:256
                    let _e202 = q4_[2];
                    let _e207 = (*sums)[18];
                    (*sums)[18] = (_e207 + (weight * (_e202 * _e51.y)));
                    // glimt_sh/src/basis.rs:257
                    let _e211 = q4_[1];
                    let _e216 = (*sums)[19];
                    (*sums)[19] = (_e216 + (weight * (_e211 * p1_.y)));
                    // glimt_sh/src/basis.rs:258
                    let _e220 = q4_[0];
                    let _e223 = (*sums)[20];
                    (*sums)[20] = (_e223 + (weight * _e220));
                    // glimt_sh/src/basis.rs:259
                    let _e227 = q4_[1];
                    let _e232 = (*sums)[21];
                    (*sums)[21] = (_e232 + (weight * (_e227 * p1_.x)));
                    // glimt_sh/src/basis.rs:260
                    let _e236 = q4_[2];
                    let _e241 = (*sums)[22];
                    (*sums)[22] = (_e241 + (weight * (_e236 * _e51.x)));
                    // glimt_sh/src/basis.rs:261
                    let _e245 = q4_[3];
                    let _e250 = (*sums)[23];
                    (*sums)[23] = (_e250 + (weight * (_e245 * _e105.x)));
                    // glimt_sh/src/basis.rs:262
                    let _e254 = q4_[4];
                    let _e259 = (*sums)[24];
                    (*sums)[24] = (_e259 + (weight * (_e254 * _e177.x)));
                    // glimt_sh/src/basis.rs:263
                    if (bands > 5u) {
                        // glimt_sh/src/basis.rs:264
                        let _e267 = turn(_e177, d.x, d.y);
                        // glimt_sh/src/basis.rs:265
                        let _e270 = zonal_5_(d.z);
                        q5_ = _e270;
                        // glimt_sh/src/basis.rs:266
                        let _e274 = q5_[5];
                        let _e279 = (*sums)[25];
                        (*sums)[25] = (_e279 + (weight * (_e274 * _e267.y)));
                        // glimt_sh/src/basis.rs:267
                        let _e283 = q5_[4];
                        let _e288 = (*sums)[26];
                        (*sums)[26] = (_e288 + (weight * (_e283 * _e177.y)));
                        // glimt_sh/src/basis.rs:268
                        let _e292 = q5_[3];
                        let _e297 = (*sums)[27];
                        (*sums)[27] = (_e297 + (weight * (_e292 * _e105.y)));
                        // glimt_sh/src/basis.rs:269
                        let _e301 = q5_[2];
                        let _e306 = (*sums)[28];
                        (*sums)[28] = (_e306 + (weight * (_e301 * _e51.y)));
                        // glimt_sh/src/basis.rs:270
                        let _e310 = q5_[1];
                        let _e315 = (*sums)[29];
                        (*sums)[29] = (_e315 + (weight * (_e310 * p1_.y)));
                        // glimt_sh/src/basis.rs:271
                        let _e319 = q5_[0];
                        let _e322 = (*sums)[30];
                        (*sums)[30] = (_e322 + (weight * _e319));
                        // glimt_sh/src/basis.rs:272
                        let _e326 = q5_[1];
                        let _e331 = (*sums)[31];
                        (*sums)[31] = (_e331 + (weight * (_e326 * p1_.x)));
                        // glimt_sh/src/basis.rs:273
                        let _e335 = q5_[2];
                        let _e340 = (*sums)[32];
                        (*sums)[32] = (_e340 + (weight * (_e335 * _e51.x)));
                        // glimt_sh/src/basis.rs:274
                        let _e344 = q5_[3];
                        let _e349 = (*sums)[33];
                        (*sums)[33] = (_e349 + (weight * (_e344 * _e105.x)));
                        // glimt_sh/src/basis.rs:275
                        let _e353 = q5_[4];
                        let _e358 = (*sums)[34];
                        (*sums)[34] = (_e358 + (weight * (_e353 * _e177.x)));
                        // glimt_sh/src/basis.rs:276
                        let _e362 = q5_[5];
                        let _e367 = (*sums)[35];
                        (*sums)[35] = (_e367 + (weight * (_e362 * _e267.x)));
                    }
                }
            }
        }
    }
    return;
}

// glimt_render_gpu/src/kernels/transfer.rs:180
fn store(bands_1: u32, kept: f32, scale: f32, sums_1: array<f32, 36>, out_start: u32, out_len: u32) {
    var sums_2: array<f32, 36>;

    sums_2 = sums_1;
    // glimt_render_gpu/src/kernels/transfer.rs:181
    let _e12 = lit[(out_start + 0u)];
    let _e15 = sums_2[0];
    lit[(out_start + 0u)] = ((kept * _e12) + (scale * _e15));
    // glimt_render_gpu/src/kernels/transfer.rs:182
    if (bands_1 > 1u) {
        // glimt_render_gpu/src/kernels/transfer.rs:183
        let _e30 = lit[(out_start + 1u)];
        let _e33 = sums_2[1];
        lit[(out_start + 1u)] = ((kept * _e30) + (scale * _e33));
        // glimt_render_gpu/src/kernels/transfer.rs:184
        let _e45 = lit[(out_start + 2u)];
        let _e48 = sums_2[2];
        lit[(out_start + 2u)] = ((kept * _e45) + (scale * _e48));
        // glimt_render_gpu/src/kernels/transfer.rs:185
        let _e60 = lit[(out_start + 3u)];
        let _e63 = sums_2[3];
        lit[(out_start + 3u)] = ((kept * _e60) + (scale * _e63));
        // glimt_render_gpu/src/kernels/transfer.rs:186
        if (bands_1 > 2u) {
            // glimt_render_gpu/src/kernels/transfer.rs:187
            let _e78 = lit[(out_start + 4u)];
            let _e81 = sums_2[4];
            lit[(out_start + 4u)] = ((kept * _e78) + (scale * _e81));
            // glimt_render_gpu/src/kernels/transfer.rs:188
            let _e93 = lit[(out_start + 5u)];
            let _e96 = sums_2[5];
            lit[(out_start + 5u)] = ((kept * _e93) + (scale * _e96));
            // glimt_render_gpu/src/kernels/transfer.rs:189
            let _e108 = lit[(out_start + 6u)];
            let _e111 = sums_2[6];
            lit[(out_start + 6u)] = ((kept * _e108) + (scale * _e111));
            // glimt_render_gpu/src/kernels/transfer.rs:190
            let _e123 = lit[(out_start + 7u)];
            let _e126 = sums_2[7];
            lit[(out_start + 7u)] = ((kept * _e123) + (scale * _e126));
            // glimt_render_gpu/src/kernels/transfer.rs:191
            let _e138 = lit[(out_start + 8u)];
            let _e141 = sums_2[8];
            lit[(out_start + 8u)] = ((kept * _e138) + (scale * _e141));
            // glimt_render_gpu/src/kernels/transfer.rs:192
            if (bands_1 > 3u) {
                // glimt_render_gpu/src/kernels/transfer.rs:193
                let _e156 = lit[(out_start + 9u)];
                let _e159 = sums_2[9];
                lit[(out_start + 9u)] = ((kept * _e156) + (scale * _e159));
                // glimt_render_gpu/src/kernels/transfer.rs:194
                let _e171 = lit[(out_start + 10u)];
                let _e174 = sums_2[10];
                lit[(out_start + 10u)] = ((kept * _e171) + (scale * _e174));
                // glimt_render_gpu/src/kernels/transfer.rs:195
                let _e186 = lit[(out_start + 11u)];
                let _e189 = sums_2[11];
                lit[(out_start + 11u)] = ((kept * _e186) + (scale * _e189));
                // glimt_render_gpu/src/kernels/transfer.rs:196
                let _e201 = lit[(out_start + 12u)];
                let _e204 = sums_2[12];
                lit[(out_start + 12u)] = ((kept * _e201) + (scale * _e204));
                // glimt_render_gpu/src/kernels/transfer.rs:197
                let _e216 = lit[(out_start + 13u)];
                let _e219 = sums_2[13];
                lit[(out_start + 13u)] = ((kept * _e216) + (scale * _e219));
                // glimt_render_gpu/src/kernels/transfer.rs:198
                let _e231 = lit[(out_start + 14u)];
                let _e234 = sums_2[14];
                lit[(out_start + 14u)] = ((kept * _e231) + (scale * _e234));
                // glimt_render_gpu/src/kernels/transfer.rs:199
                let _e246 = lit[(out_start + 15u)];
                let _e249 = sums_2[15];
                lit[(out_start + 15u)] = ((kept * _e246) + (scale * _e249));
                // glimt_render_gpu/src/kernels/transfer.rs:200
                if (bands_1 > 4u) {
                    // glimt_render_gpu/src/kernels/transfer.rs:201
                    let _e264 = lit[(out_start + 16u)];
                    let _e267 = sums_2[16];
                    lit[(out_start + 16u)] = ((kept * _e264) + (scale * _e267));
                    // glimt_render_gpu/src/kernels/transfer.rs:202
                    let _e279 = lit[(out_start + 17u)];
                    let _e282 = sums_2[17];
                    lit[(out_start + 17u)] = ((kept * _e279) + (scale * _e282));
                    // glimt_render_gpu/src/kernels/transfer.rs:203
                    let _e294 = lit[(out_start + 18u)];
                    let _e297 = sums_2[18];
                    lit[(out_start + 18u)] = ((kept * _e294) + (scale * _e297));
                    // glimt_render_gpu/src/kernels/transfer.rs:204
                    let _e309 = lit[(out_start + 19u)];
                    let _e312 = sums_2[19];
                    lit[(out_start + 19u)] = ((kept * _e309) + (scale * _e312));
                    // glimt_render_gpu/src/kernels/transfer.rs:205
                    let _e324 = lit[(out_start + 20u)];
                    let _e327 = sums_2[20];
                    lit[(out_start + 20u)] = ((kept * _e324) + (scale * _e327));
                    // glimt_render_gpu/src/kernels/transfer.rs:206
                    let _e339 = lit[(out_start + 21u)];
                    let _e342 = sums_2[21];
                    lit[(out_start + 21u)] = ((kept * _e339) + (scale * _e342));
                    // glimt_render_gpu/src/kernels/transfer.rs:207
                    let _e354 = lit[(out_start + 22u)];
                    let _e357 = sums_2[22];
                    lit[(out_start + 22u)] = ((kept * _e354) + (scale * _e357));
                    // glimt_render_gpu/src/kernels/transfer.rs:208
                    let _e369 = lit[(out_start + 23u)];
                    let _e372 = sums_2[23];
                    lit[(out_start + 23u)] = ((kept * _e369) + (scale * _e372));
                    // glimt_render_gpu/src/kernels/transfer.rs:209
                    let _e384 = lit[(out_start + 24u)];
                    let _e387 = sums_2[24];
                    lit[(out_start + 24u)] = ((kept * _e384) + (scale * _e387));
                    // glimt_render_gpu/src/kernels/transfer.rs:210
                    if (bands_1 > 5u) {
                        // glimt_render_gpu/src/kernels/transfer.rs:211
                        let _e402 = lit[(out_start + 25u)];
                        let _e405 = sums_2[25];
                        lit[(out_start + 25u)] = ((kept * _e402) + (scale * _e405));
                        // glimt_render_gpu/src/kernels/transfer.rs:212
                        let _e417 = lit[(out_start + 26u)];
                        let _e420 = sums_2[26];
                        lit[(out_start + 26u)] = ((kept * _e417) + (scale * _e420));
                        // glimt_render_gpu/src/kernels/transfer.rs:213
                        let _e432 = lit[(out_start + 27u)];
                        let _e435 = sums_2[27];
                        lit[(out_start + 27u)] = ((kept * _e432) + (scale * _e435));
                        // glimt_render_gpu/src/kernels/transfer.rs:214
                        let _e447 = lit[(out_start + 28u)];
                        let _e450 = sums_2[28];
                        lit[(out_start + 28u)] = ((kept * _e447) + (scale * _e450));
                        // glimt_render_gpu/src/kernels/transfer.rs:215
                        let _e462 = lit[(out_start + 29u)];
                        let _e465 = sums_2[29];
                        lit[(out_start + 29u)] = ((kept * _e462) + (scale * _e465));
                        // glimt_render_gpu/src/kernels/transfer.rs:216
                        let _e477 = lit[(out_start + 30u)];
                        let _e480 = sums_2[30];
                        lit[(out_start + 30u)] = ((kept * _e477) + (scale * _e480));
                        // glimt_render_gpu/src/kernels/transfer.rs:217
                        let _e492 = lit[(out_start + 31u)];
                        let _e495 = sums_2[31];
                        lit[(out_start + 31u)] = ((kept * _e492) + (scale * _e495));
                        // glimt_render_gpu/src/kernels/transfer.rs:218
                        let _e507 = lit[(out_start + 32u)];
                        let _e510 = sums_2[32];
                        lit[(out_start + 32u)] = ((kept * _e507) + (scale * _e510));
                        // glimt_render_gpu/src/kernels/transfer.rs:219
                        let _e522 = lit[(out_start + 33u)];
                        let _e525 = sums_2[33];
                        lit[(out_start + 33u)] = ((kept * _e522) + (scale * _e525));
                        // glimt_render_gpu/src/kernels/transfer.rs:220
                        let _e537 = lit[(out_start + 34u)];
                        let _e540 = sums_2[34];
                        lit[(out_start + 34u)] = ((kept * _e537) + (scale * _e540));
                        // glimt_render_gpu/src/kernels/transfer.rs:221
                        let _e552 = lit[(out_start + 35u)];
                        let _e555 = sums_2[35];
                        lit[(out_start + 35u)] = ((kept * _e552) + (scale * _e555));
                    }
                }
            }
        }
    }
    return;
}

// glimt_render_gpu/src/kernels/transfer.rs:180
fn store_1(bands_2: u32, kept_1: f32, scale_1: f32, sums_3: array<f32, 36>, out_start_1: u32, out_len_1: u32) {
    var sums_4: array<f32, 36>;

    sums_4 = sums_3;
    // glimt_render_gpu/src/kernels/transfer.rs:181
    let _e12 = blocked[(out_start_1 + 0u)];
    let _e15 = sums_4[0];
    blocked[(out_start_1 + 0u)] = ((kept_1 * _e12) + (scale_1 * _e15));
    // glimt_render_gpu/src/kernels/transfer.rs:182
    if (bands_2 > 1u) {
        // glimt_render_gpu/src/kernels/transfer.rs:183
        let _e30 = blocked[(out_start_1 + 1u)];
        let _e33 = sums_4[1];
        blocked[(out_start_1 + 1u)] = ((kept_1 * _e30) + (scale_1 * _e33));
        // glimt_render_gpu/src/kernels/transfer.rs:184
        let _e45 = blocked[(out_start_1 + 2u)];
        let _e48 = sums_4[2];
        blocked[(out_start_1 + 2u)] = ((kept_1 * _e45) + (scale_1 * _e48));
        // glimt_render_gpu/src/kernels/transfer.rs:185
        let _e60 = blocked[(out_start_1 + 3u)];
        let _e63 = sums_4[3];
        blocked[(out_start_1 + 3u)] = ((kept_1 * _e60) + (scale_1 * _e63));
        // glimt_render_gpu/src/kernels/transfer.rs:186
        if (bands_2 > 2u) {
            // glimt_render_gpu/src/kernels/transfer.rs:187
            let _e78 = blocked[(out_start_1 + 4u)];
            let _e81 = sums_4[4];
            blocked[(out_start_1 + 4u)] = ((kept_1 * _e78) + (scale_1 * _e81));
            // glimt_render_gpu/src/kernels/transfer.rs:188
            let _e93 = blocked[(out_start_1 + 5u)];
            let _e96 = sums_4[5];
            blocked[(out_start_1 + 5u)] = ((kept_1 * _e93) + (scale_1 * _e96));
            // glimt_render_gpu/src/kernels/transfer.rs:189
            let _e108 = blocked[(out_start_1 + 6u)];
            let _e111 = sums_4[6];
            blocked[(out_start_1 + 6u)] = ((kept_1 * _e108) + (scale_1 * _e111));
            // glimt_render_gpu/src/kernels/transfer.rs:190
            let _e123 = blocked[(out_start_1 + 7u)];
            let _e126 = sums_4[7];
            blocked[(out_start_1 + 7u)] = ((kept_1 * _e123) + (scale_1 * _e126));
            // glimt_render_gpu/src/kernels/transfer.rs:191
            let _e138 = blocked[(out_start_1 + 8u)];
            let _e141 = sums_4[8];
            blocked[(out_start_1 + 8u)] = ((kept_1 * _e138) + (scale_1 * _e141));
            // glimt_render_gpu/src/kernels/transfer.rs:192
            if (bands_2 > 3u) {
                // glimt_render_gpu/src/kernels/transfer.rs:193
                let _e156 = blocked[(out_start_1 + 9u)];
                let _e159 = sums_4[9];
                blocked[(out_start_1 + 9u)] = ((kept_1 * _e156) + (scale_1 * _e159));
                // glimt_render_gpu/src/kernels/transfer.rs:194
                let _e171 = blocked[(out_start_1 + 10u)];
                let _e174 = sums_4[10];
                blocked[(out_start_1 + 10u)] = ((kept_1 * _e171) + (scale_1 * _e174));
                // glimt_render_gpu/src/kernels/transfer.rs:195
                let _e186 = blocked[(out_start_1 + 11u)];
                let _e189 = sums_4[11];
                blocked[(out_start_1 + 11u)] = ((kept_1 * _e186) + (scale_1 * _e189));
                // glimt_render_gpu/src/kernels/transfer.rs:196
                let _e201 = blocked[(out_start_1 + 12u)];
                let _e204 = sums_4[12];
                blocked[(out_start_1 + 12u)] = ((kept_1 * _e201) + (scale_1 * _e204));
                // glimt_render_gpu/src/kernels/transfer.rs:197
                let _e216 = blocked[(out_start_1 + 13u)];
                let _e219 = sums_4[13];
                blocked[(out_start_1 + 13u)] = ((kept_1 * _e216) + (scale_1 * _e219));
                // glimt_render_gpu/src/kernels/transfer.rs:198
                let _e231 = blocked[(out_start_1 + 14u)];
                let _e234 = sums_4[14];
                blocked[(out_start_1 + 14u)] = ((kept_1 * _e231) + (scale_1 * _e234));
                // glimt_render_gpu/src/kernels/transfer.rs:199
                let _e246 = blocked[(out_start_1 + 15u)];
                let _e249 = sums_4[15];
                blocked[(out_start_1 + 15u)] = ((kept_1 * _e246) + (scale_1 * _e249));
                // glimt_render_gpu/src/kernels/transfer.rs:200
                if (bands_2 > 4u) {
                    // glimt_render_gpu/src/kernels/transfer.rs:201
                    let _e264 = blocked[(out_start_1 + 16u)];
                    let _e267 = sums_4[16];
                    blocked[(out_start_1 + 16u)] = ((kept_1 * _e264) + (scale_1 * _e267));
                    // glimt_render_gpu/src/kernels/transfer.rs:202
                    let _e279 = blocked[(out_start_1 + 17u)];
                    let _e282 = sums_4[17];
                    blocked[(out_start_1 + 17u)] = ((kept_1 * _e279) + (scale_1 * _e282));
                    // glimt_render_gpu/src/kernels/transfer.rs:203
                    let _e294 = blocked[(out_start_1 + 18u)];
                    let _e297 = sums_4[18];
                    blocked[(out_start_1 + 18u)] = ((kept_1 * _e294) + (scale_1 * _e297));
                    // glimt_render_gpu/src/kernels/transfer.rs:204
                    let _e309 = blocked[(out_start_1 + 19u)];
                    let _e312 = sums_4[19];
                    blocked[(out_start_1 + 19u)] = ((kept_1 * _e309) + (scale_1 * _e312));
                    // glimt_render_gpu/src/kernels/transfer.rs:205
                    let _e324 = blocked[(out_start_1 + 20u)];
                    let _e327 = sums_4[20];
                    blocked[(out_start_1 + 20u)] = ((kept_1 * _e324) + (scale_1 * _e327));
                    // glimt_render_gpu/src/kernels/transfer.rs:206
                    let _e339 = blocked[(out_start_1 + 21u)];
                    let _e342 = sums_4[21];
                    blocked[(out_start_1 + 21u)] = ((kept_1 * _e339) + (scale_1 * _e342));
                    // glimt_render_gpu/src/kernels/transfer.rs:207
                    let _e354 = blocked[(out_start_1 + 22u)];
                    let _e357 = sums_4[22];
                    blocked[(out_start_1 + 22u)] = ((kept_1 * _e354) + (scale_1 * _e357));
                    // glimt_render_gpu/src/kernels/transfer.rs:208
                    let _e369 = blocked[(out_start_1 + 23u)];
                    let _e372 = sums_4[23];
                    blocked[(out_start_1 + 23u)] = ((kept_1 * _e369) + (scale_1 * _e372));
                    // glimt_render_gpu/src/kernels/transfer.rs:209
                    let _e384 = blocked[(out_start_1 + 24u)];
                    let _e387 = sums_4[24];
                    blocked[(out_start_1 + 24u)] = ((kept_1 * _e384) + (scale_1 * _e387));
                    // glimt_render_gpu/src/kernels/transfer.rs:210
                    if (bands_2 > 5u) {
                        // glimt_render_gpu/src/kernels/transfer.rs:211
                        let _e402 = blocked[(out_start_1 + 25u)];
                        let _e405 = sums_4[25];
                        blocked[(out_start_1 + 25u)] = ((kept_1 * _e402) + (scale_1 * _e405));
                        // glimt_render_gpu/src/kernels/transfer.rs:212
                        let _e417 = blocked[(out_start_1 + 26u)];
                        let _e420 = sums_4[26];
                        blocked[(out_start_1 + 26u)] = ((kept_1 * _e417) + (scale_1 * _e420));
                        // glimt_render_gpu/src/kernels/transfer.rs:213
                        let _e432 = blocked[(out_start_1 + 27u)];
                        let _e435 = sums_4[27];
                        blocked[(out_start_1 + 27u)] = ((kept_1 * _e432) + (scale_1 * _e435));
                        // glimt_render_gpu/src/kernels/transfer.rs:214
                        let _e447 = blocked[(out_start_1 + 28u)];
                        let _e450 = sums_4[28];
                        blocked[(out_start_1 + 28u)] = ((kept_1 * _e447) + (scale_1 * _e450));
                        // glimt_render_gpu/src/kernels/transfer.rs:215
                        let _e462 = blocked[(out_start_1 + 29u)];
                        let _e465 = sums_4[29];
                        blocked[(out_start_1 + 29u)] = ((kept_1 * _e462) + (scale_1 * _e465));
                        // glimt_render_gpu/src/kernels/transfer.rs:216
                        let _e477 = blocked[(out_start_1 + 30u)];
                        let _e480 = sums_4[30];
                        blocked[(out_start_1 + 30u)] = ((kept_1 * _e477) + (scale_1 * _e480));
                        // glimt_render_gpu/src/kernels/transfer.rs:217
                        let _e492 = blocked[(out_start_1 + 31u)];
                        let _e495 = sums_4[31];
                        blocked[(out_start_1 + 31u)] = ((kept_1 * _e492) + (scale_1 * _e495));
                        // glimt_render_gpu/src/kernels/transfer.rs:218
                        let _e507 = blocked[(out_start_1 + 32u)];
                        let _e510 = sums_4[32];
                        blocked[(out_start_1 + 32u)] = ((kept_1 * _e507) + (scale_1 * _e510));
                        // glimt_render_gpu/src/kernels/transfer.rs:219
                        let _e522 = blocked[(out_start_1 + 33u)];
                        let _e525 = sums_4[33];
                        blocked[(out_start_1 + 33u)] = ((kept_1 * _e522) + (scale_1 * _e525));
                        // glimt_render_gpu/src/kernels/transfer.rs:220
                        let _e537 = blocked[(out_start_1 + 34u)];
                        let _e540 = sums_4[34];
                        blocked[(out_start_1 + 34u)] = ((kept_1 * _e537) + (scale_1 * _e540));
                        // glimt_render_gpu/src/kernels/transfer.rs:221
                        let _e552 = blocked[(out_start_1 + 35u)];
                        let _e555 = sums_4[35];
                        blocked[(out_start_1 + 35u)] = ((kept_1 * _e552) + (scale_1 * _e555));
                    }
                }
            }
        }
    }
    return;
}

// glimt_render_gpu/src/kernels/transfer.rs:69
fn transfer_1(vertex: u32, params_1: TransferParams, state_start: u32, state_len: u32, lit_start: u32, lit_len: u32, blocked_start: u32, blocked_len: u32) -> u32 {
    var arrives: array<f32, 36>;
    var kept_away: array<f32, 36>;
    var rays: u32;
    var source: Xoshiro128PlusPlus;
    var kept_2: f32;
    var gone: u32;
    var counter_4: u32;
    var counter_5: u32;
    var chosen_5: bool;
    var either: bool;

    // glimt_render_gpu/src/kernels/transfer.rs:80
    let at_2 = vertices[vertex];
    // glimt_render_gpu/src/kernels/transfer.rs:81
    let _e15 = Tuple_u32_u32_(params_1.directions, params_1.bands);
    let n_2 = _e15.fa;
    let bands_3 = _e15.fb;
    // glimt_render_gpu/src/kernels/transfer.rs:82
    arrives = array<f32, 36>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
    // glimt_render_gpu/src/kernels/transfer.rs:83
    kept_away = array<f32, 36>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
    // glimt_render_gpu/src/kernels/transfer.rs:84
    rays = 0u;
    // glimt_render_gpu/src/kernels/transfer.rs:87
    let way = (at_2.origin - at_2.inner);
    // glimt_render_gpu/src/kernels/transfer.rs:88
    let _e35 = Ray_new(at_2.inner, way);
    // glimt_render_gpu/src/kernels/transfer.rs:89
    let others = Asked(at_2.object, false, 1f, way);
    // glimt_render_gpu/src/kernels/transfer.rs:95
    let _e43 = any_hit_of(_e35, 1f, others);
    // glimt_render_gpu/src/kernels/transfer.rs:96
    let own = Asked(others.object, true, 0f, others.way);
    // glimt_render_gpu/src/kernels/transfer.rs:101
    let height_2 = dot(at_2.normal, way);
    // glimt_render_gpu/src/kernels/transfer.rs:102
    let _e57 = Xoshiro128PlusPlus_stream(params_1.seed, 1953653102u, at_2.number);
    source = _e57;
    // glimt_render_gpu/src/kernels/transfer.rs:103
    kept_2 = 0f;
    // glimt_render_gpu/src/kernels/transfer.rs:104
    gone = 0u;
    // glimt_render_gpu/src/kernels/transfer.rs:105
    if (params_1.first_row > 0u) {
        // glimt_render_gpu/src/kernels/transfer.rs:106
        let _e74 = state_1[(state_start + 0u)];
        let _e79 = state_1[(state_start + 1u)];
        let _e84 = state_1[(state_start + 2u)];
        let _e89 = state_1[(state_start + 3u)];
        let words = vec4<u32>(_e74, _e79, _e84, _e89);
        // glimt_render_gpu/src/kernels/transfer.rs:107
        let _e92 = Xoshiro128PlusPlus_from_state(words);
        source = _e92;
        // glimt_render_gpu/src/kernels/transfer.rs:108
        kept_2 = 1f;
        // glimt_render_gpu/src/kernels/transfer.rs:109
        let _e100 = state_1[(state_start + 4u)];
        gone = _e100;
    }
    // glimt_render_gpu/src/kernels/transfer.rs:111
    counter_4 = params_1.first_row;
    loop {
        let row_1 = counter_4;
        if (row_1 >= params_1.end_row) {
            break;
        }
        // glimt_render_gpu/src/kernels/transfer.rs:112
        let _e108 = strata_of_row(params_1, row_1);
        // glimt_render_gpu/src/kernels/transfer.rs:113
        let _e112 = Tuple_u32_u32_(_e108.x, _e108.y);
        let first_7 = _e112.fa;
        let columns_1 = _e112.fb;
        // glimt_render_gpu/src/kernels/transfer.rs:114
        counter_5 = 0u;
        loop {
            let column_1 = counter_5;
            if (column_1 >= columns_1) {
                break;
            }
            // glimt_render_gpu/src/kernels/transfer.rs:115
            let _e122 = gone;
            gone = (_e122 + 1u);
            // glimt_render_gpu/src/kernels/transfer.rs:116
            let _e125 = Xoshiro128PlusPlus_next_uvec2_((&source));
            let _e126 = unit_vec2_(_e125);
            // glimt_render_gpu/src/kernels/transfer.rs:117
            let _e128 = direction_in_row(n_2, first_7, columns_1, column_1, _e126);
            // glimt_render_gpu/src/kernels/transfer.rs:118
            let cosine = dot(at_2.normal, _e128);
            // glimt_render_gpu/src/kernels/transfer.rs:119
            if (cosine > 0f) {
                // glimt_render_gpu/src/kernels/transfer.rs:120
                let _e137 = rays;
                rays = (_e137 + 1u);
                // glimt_render_gpu/src/kernels/transfer.rs:121
                let _e142 = gone;
                let _e143 = hash3_(params_1.seed, at_2.number, _e142);
                // glimt_render_gpu/src/kernels/transfer.rs:122
                let _e146 = Ray_keyed(at_2.origin, _e128, _e143);
                // glimt_render_gpu/src/kernels/transfer.rs:123
                if _e43 {
                    // glimt_render_gpu/src/kernels/transfer.rs:125
                    let above = Asked(others.object, others.own, (height_2 / cosine), others.way);
                    // glimt_render_gpu/src/kernels/transfer.rs:129
                    let _e157 = Ray_keyed(at_2.inner, _e128, _e143);
                    // glimt_render_gpu/src/kernels/transfer.rs:130
                    let _e160 = any_hit_of(_e157, 0x1.fffffep+127f, above);
                    either = _e160;
                    if _e160 {
                    } else {
                        let _e163 = any_hit_of(_e146, 0x1.fffffep+127f, own);
                        either = _e163;
                    }
                    let _e164 = either;
                    chosen_5 = _e164;
                } else {
                    // glimt_render_gpu/src/kernels/transfer.rs:133
                    let _e167 = any_hit(_e146, 0x1.fffffep+127f);
                    chosen_5 = _e167;
                }
                let is_blocked = chosen_5;
                // glimt_render_gpu/src/kernels/transfer.rs:135
                if is_blocked {
                    // glimt_render_gpu/src/kernels/transfer.rs:136
                    add_basis(bands_3, _e128, cosine, (&kept_away));
                } else {
                    // glimt_render_gpu/src/kernels/transfer.rs:138
                    add_basis(bands_3, _e128, cosine, (&arrives));
                }
            }
            continuing {
                let _e172 = counter_5;
                counter_5 = (_e172 + 1u);
            }
        }
        continuing {
            let _e175 = counter_4;
            counter_4 = (_e175 + 1u);
        }
    }
    // glimt_render_gpu/src/kernels/transfer.rs:143
    let scale_2 = ((4f * 3.1415927f) / f32(n_2));
    // glimt_render_gpu/src/kernels/transfer.rs:144
    let _e185 = kept_2;
    let _e186 = arrives;
    store(bands_3, _e185, scale_2, _e186, lit_start, lit_len);
    // glimt_render_gpu/src/kernels/transfer.rs:145
    let _e188 = kept_2;
    let _e189 = kept_away;
    store_1(bands_3, _e188, scale_2, _e189, blocked_start, blocked_len);
    // glimt_render_gpu/src/kernels/transfer.rs:146
    let _e193 = source.state.x;
    state_1[(state_start + 0u)] = _e193;
    // glimt_render_gpu/src/kernels/transfer.rs:147
    let _e201 = source.state.y;
    state_1[(state_start + 1u)] = _e201;
    // glimt_render_gpu/src/kernels/transfer.rs:148
    let _e209 = source.state.z;
    state_1[(state_start + 2u)] = _e209;
    // glimt_render_gpu/src/kernels/transfer.rs:149
    let _e217 = source.state.w;
    state_1[(state_start + 3u)] = _e217;
    // glimt_render_gpu/src/kernels/transfer.rs:150
    let _e223 = gone;
    state_1[(state_start + 4u)] = _e223;
    // glimt_render_gpu/src/kernels/transfer.rs:151
    let _e229 = rays;
    return _e229;
}

@compute @workgroup_size(64, 1, 1) 
fn transfer(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let local = ((id.y * (groups.x * 64u)) + id.x);
    let _e11 = params_2.count;
    if (local >= _e11) {
        return;
    }
    let _e14 = params_2.first;
    let _e17 = params_2.params;
    let _e19 = params_2.state_len;
    let _e22 = params_2.lit_len;
    let _e25 = params_2.blocked_len;
    let _e27 = transfer_1((_e14 + local), _e17, (local * _e19), _e19, (local * _e22), _e22, (local * _e25), _e25);
    out[local] = _e27;
}
