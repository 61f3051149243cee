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

struct Corner {
    normal: vec3<f32>,
    u: f32,
    tangent: vec3<f32>,
    v: f32,
}

struct TileEntry {
    position: vec3<f32>,
    surface: u32,
    normal: vec3<f32>,
    exponent: f32,
    diffuse: f32,
    specular: f32,
    hits: u32,
    off_centre: f32,
    from_: u32,
    pilots: u32,
    catcher: u32,
    unused: u32,
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

struct CellParams {
    rays: f32,
    pilot: f32,
    upkeep: f32,
    tiles_across: u32,
    tiles: u32,
    is_adaptive: u32,
    has_past: u32,
    turned: u32,
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

struct Hit {
    triangle: u32,
    t: f32,
    barycentrics: vec2<f32>,
}

struct Option_Hit {
    is_some: bool,
    value: Hit,
}

struct SeenPoint {
    origin: vec3<f32>,
    surface: u32,
    geometric_normal: vec3<f32>,
    flags: u32,
    normal: vec3<f32>,
    exponent: f32,
    wo: vec3<f32>,
    material: u32,
    diffuse: vec3<f32>,
    order: u32,
    specular: vec3<f32>,
    shadow_rays: u32,
    emission: vec3<f32>,
    residual: f32,
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

struct Params {
    first: u32,
    count: u32,
    entries_len: u32,
    frame: FrameParams,
    cells: CellParams,
}

@group(0) @binding(1) 
var<storage> scene_nodes: array<BvhNode>;
@group(0) @binding(2) 
var<storage> scene_triangles: array<Triangle>;
@group(0) @binding(3) 
var<storage> scene_corners: array<Corner>;
@group(0) @binding(4) 
var<storage> scene_surface: array<u32>;
@group(0) @binding(5) 
var<storage, read_write> entries: array<TileEntry>;
@group(0) @binding(0) 
var<uniform> params: Params;

// glimt_render_gpu/src/kernels/scout.rs:37
fn CellParams_corner(this_: CellParams, tile: u32) -> vec2<u32> {

    // glimt_render_gpu/src/kernels/scout.rs:38
    return vec2<u32>(((tile % this_.tiles_across) * 16u), ((tile / this_.tiles_across) * 10u));
}

// glimt_render_gpu/src/kernels/scout.rs:56
fn tile_end(corner: vec2<u32>, frame: FrameParams) -> vec2<u32> {

    // glimt_render_gpu/src/kernels/scout.rs:57
    return vec2<u32>(min((corner.x + 16u), frame.width), min((corner.y + 10u), frame.height));
}

// glimt_render_gpu/src/kernels/frame.rs:130
fn FrameParams_pattern_at(this_1: FrameParams, pixel: u32, ray: u32) -> PixelPattern {

    // glimt_render_gpu/src/kernels/frame.rs:131
    return PixelPattern(this_1.pattern, this_1.seed, this_1.frame, pixel, ray, this_1.rays_per_pixel);
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

// glimt_sampling/src/sobol.rs:172
fn OwenSobol_new(seed: u32, frame_1: u32, pixel_1: u32, sample_index: u32) -> OwenSobol {

    // glimt_sampling/src/sobol.rs:173
    let _e6 = hash3_(seed, frame_1, pixel_1);
    let _e9 = hash2_(_e6, (sample_index >> 16u));
    return OwenSobol(_e9, (sample_index & 65535u), 0u);
}

// glimt_render_gpu/src/kernels/pattern.rs:136
fn PixelPattern_sobol_point(this_2: PixelPattern, purpose: u32, index: u32) -> OwenSobol {

    // glimt_render_gpu/src/kernels/pattern.rs:137
    let _e6 = hash2_(this_2.seed, purpose);
    let _e9 = OwenSobol_new(_e6, this_2.frame, this_2.pixel, index);
    return _e9;
}

// glimt_sampling/src/sobol.rs:21
fn owen_scramble_reversed(n_1: u32, scramble: u32) -> u32 {
    var x_1: u32;

    // glimt_sampling/src/sobol.rs:22
    x_1 = (n_1 ^ (n_1 * 1025551850u));
    // glimt_sampling/src/sobol.rs:23
    let _e9 = x_1;
    x_1 = (_e9 + scramble);
    // glimt_sampling/src/sobol.rs:24
    let _e12 = x_1;
    x_1 = (_e12 * ((scramble >> 16u) | 1u));
    // glimt_sampling/src/sobol.rs:25
    let _e19 = x_1;
    let _e22 = x_1;
    x_1 = (_e22 ^ (_e19 * 89287766u));
    // glimt_sampling/src/sobol.rs:26
    let _e25 = x_1;
    let _e26 = x_1;
    return (_e25 ^ (_e26 * 1403136100u));
}

// glimt_sampling/src/sobol.rs:104
fn shuffle(index_1: u32, seed_1: u32) -> u32 {

    // glimt_sampling/src/sobol.rs:105
    let _e7 = hash_u32_((seed_1 ^ 2043055690u));
    let _e8 = owen_scramble_reversed(reverseBits(index_1), _e7);
    return reverseBits(_e8);
}

// glimt_sampling/src/sobol.rs:56
fn pascal(index_2: u32) -> u32 {
    var x_2: u32;

    // glimt_sampling/src/sobol.rs:57
    x_2 = index_2;
    // glimt_sampling/src/sobol.rs:58
    let _e5 = x_2;
    let _e10 = x_2;
    x_2 = (_e10 ^ ((_e5 >> 1u) & 21845u));
    // glimt_sampling/src/sobol.rs:59
    let _e13 = x_2;
    let _e18 = x_2;
    x_2 = (_e18 ^ ((_e13 >> 2u) & 13107u));
    // glimt_sampling/src/sobol.rs:60
    let _e21 = x_2;
    let _e26 = x_2;
    x_2 = (_e26 ^ ((_e21 >> 4u) & 3855u));
    // glimt_sampling/src/sobol.rs:61
    let _e29 = x_2;
    let _e30 = x_2;
    return (_e29 ^ ((_e30 >> 8u) & 255u));
}

// glimt_sampling/src/sobol.rs:66
fn recurrence_2_(index_3: u32) -> u32 {
    var bits: u32;
    var v0_: u32;
    var v1_: u32;
    var sum: u32;
    var counter: i32;

    // glimt_sampling/src/sobol.rs:67
    bits = index_3;
    // glimt_sampling/src/sobol.rs:68
    v0_ = 1u;
    // glimt_sampling/src/sobol.rs:69
    v1_ = 3u;
    // glimt_sampling/src/sobol.rs:70
    sum = 0u;
    // glimt_sampling/src/sobol.rs:72
    counter = 0i;
    loop {
        let _e17 = counter;
        if (_e17 >= 16i) {
            break;
        }
        // glimt_sampling/src/sobol.rs:73
        let _e20 = v0_;
        let _e21 = bits;
        let _e27 = sum;
        sum = (_e27 ^ (_e20 & (0u - (_e21 & 1u))));
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
            let _e44 = counter;
            counter = (_e44 + 1i);
        }
    }
    // glimt_sampling/src/sobol.rs:79
    let _e48 = sum;
    return _e48;
}

// glimt_sampling/src/sobol.rs:84
fn recurrence_3_(index_4: u32) -> u32 {
    var bits_1: u32;
    var v0_1: u32;
    var v1_1: u32;
    var v2_: u32;
    var sum_1: u32;
    var counter_1: i32;

    // glimt_sampling/src/sobol.rs:85
    bits_1 = index_4;
    // glimt_sampling/src/sobol.rs:86
    v0_1 = 1u;
    // glimt_sampling/src/sobol.rs:87
    v1_1 = 3u;
    // glimt_sampling/src/sobol.rs:88
    v2_ = 4u;
    // glimt_sampling/src/sobol.rs:89
    sum_1 = 0u;
    // glimt_sampling/src/sobol.rs:90
    counter_1 = 0i;
    loop {
        let _e20 = counter_1;
        if (_e20 >= 16i) {
            break;
        }
        // glimt_sampling/src/sobol.rs:91
        let _e23 = v0_1;
        let _e24 = bits_1;
        let _e30 = sum_1;
        sum_1 = (_e30 ^ (_e23 & (0u - (_e24 & 1u))));
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
            let _e49 = counter_1;
            counter_1 = (_e49 + 1i);
        }
    }
    // glimt_sampling/src/sobol.rs:98
    let _e53 = sum_1;
    return _e53;
}

// glimt_sampling/src/sobol.rs:43
fn sobol_reversed(index_5: u32, dimension: u32) -> u32 {
    var chosen: u32;

    // glimt_sampling/src/sobol.rs:44
    let index_15 = (index_5 & 65535u);
    // glimt_sampling/src/sobol.rs:45
    let _e8 = (dimension & 3u);
    if (_e8 == 0u) {
        // glimt_sampling/src/sobol.rs:47
        chosen = index_15;
    } else {
        if (_e8 == 1u) {
            // glimt_sampling/src/sobol.rs:48
            let _e16 = pascal(index_15);
            chosen = _e16;
        } else {
            if (_e8 == 2u) {
                // glimt_sampling/src/sobol.rs:49
                let _e20 = recurrence_2_(index_15);
                chosen = _e20;
            } else {
                // glimt_sampling/src/sobol.rs:50
                let _e22 = recurrence_3_(index_15);
                chosen = _e22;
            }
        }
    }
    let _e23 = chosen;
    return _e23;
}

// glimt_sampling/src/sobol.rs:110
fn scramble_1(reversed: u32, dimension_1: u32, seed_2: u32) -> u32 {
    var chosen_1: u32;

    // glimt_sampling/src/sobol.rs:111
    let _e6 = (dimension_1 & 3u);
    if (_e6 == 0u) {
        // glimt_sampling/src/sobol.rs:112
        chosen_1 = 2435803578u;
    } else {
        if (_e6 == 1u) {
            // glimt_sampling/src/sobol.rs:113
            chosen_1 = 391059627u;
        } else {
            if (_e6 == 2u) {
                // glimt_sampling/src/sobol.rs:114
                chosen_1 = 1763603146u;
            } else {
                // glimt_sampling/src/sobol.rs:115
                chosen_1 = 3020734904u;
            }
        }
    }
    let salt = chosen_1;
    // glimt_sampling/src/sobol.rs:118
    let _e27 = hash_u32_(((seed_2 * 2626628923u) ^ salt));
    // glimt_sampling/src/sobol.rs:119
    let _e29 = owen_scramble_reversed(reversed, _e27);
    return reverseBits(_e29);
}

// glimt_sampling/src/sobol.rs:191
fn OwenSobol_next_uvec2_(this_3: ptr<function, OwenSobol>) -> vec2<u32> {

    // glimt_sampling/src/sobol.rs:192
    let _e4 = (*this_3).dimension;
    let dimension_2 = ((_e4 + 1u) & 4294967294u);
    // glimt_sampling/src/sobol.rs:193
    (*this_3).dimension = (dimension_2 + 2u);
    // glimt_sampling/src/sobol.rs:194
    let _e15 = (*this_3).seed;
    let _e18 = hash2_(_e15, (dimension_2 >> 2u));
    // glimt_sampling/src/sobol.rs:195
    let _e21 = (*this_3).index;
    let _e22 = shuffle(_e21, _e18);
    // glimt_sampling/src/sobol.rs:196
    let _e24 = sobol_reversed(_e22, dimension_2);
    let _e25 = scramble_1(_e24, dimension_2, _e18);
    let _e28 = sobol_reversed(_e22, (dimension_2 + 1u));
    let _e31 = scramble_1(_e28, (dimension_2 + 1u), _e18);
    return vec2<u32>(_e25, _e31);
}

// glimt_sampling/src/hash.rs:50
fn hash_uvec4_(v: vec4<u32>) -> vec4<u32> {
    var x_3: u32;
    var y: u32;
    var z: u32;
    var w: u32;

    // glimt_sampling/src/hash.rs:51
    let _e4 = hash_u32_(v.x);
    x_3 = ((_e4 * 1664525u) + 1013904223u);
    // glimt_sampling/src/hash.rs:54
    let _e12 = hash_u32_(v.y);
    y = ((_e12 * 1664525u) + 1013904223u);
    // glimt_sampling/src/hash.rs:57
    let _e20 = hash_u32_(v.z);
    z = ((_e20 * 1664525u) + 1013904223u);
    // glimt_sampling/src/hash.rs:60
    let _e28 = hash_u32_(v.w);
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
fn Xoshiro128PlusPlus_stream(seed_3: u32, frame_2: u32, pixel_2: u32) -> Xoshiro128PlusPlus {

    // glimt_sampling/src/xoshiro.rs:50
    let _e7 = hash_uvec4_(vec4<u32>(pixel_2, frame_2, seed_3, 2654435769u));
    let _e8 = Xoshiro128PlusPlus_from_state(_e7);
    return _e8;
}

// glimt_render_gpu/src/kernels/pattern.rs:141
fn PixelPattern_generator(this_4: PixelPattern, purpose_1: u32, index_6: u32) -> Xoshiro128PlusPlus {

    // glimt_render_gpu/src/kernels/pattern.rs:142
    let _e6 = hash3_(this_4.seed, purpose_1, index_6);
    let _e9 = Xoshiro128PlusPlus_stream(_e6, this_4.frame, this_4.pixel);
    return _e9;
}

// glimt_sampling/src/xoshiro.rs:56
fn Xoshiro128PlusPlus_next_u32_(this_5: ptr<function, Xoshiro128PlusPlus>) -> u32 {

    // glimt_sampling/src/xoshiro.rs:57
    let s = (*this_5).state;
    // glimt_sampling/src/xoshiro.rs:58
    let _e8 = (s.x + s.w);
    let result = (((_e8 << 7u) | (_e8 >> ((0u - 7u) & 31u))) + s.x);
    // glimt_sampling/src/xoshiro.rs:59
    let z_1 = (s.z ^ s.x);
    // glimt_sampling/src/xoshiro.rs:60
    let w_1 = (s.w ^ s.y);
    // glimt_sampling/src/xoshiro.rs:61
    (*this_5).state = vec4<u32>((s.x ^ w_1), (s.y ^ z_1), (z_1 ^ (s.y << 9u)), ((w_1 << 11u) | (w_1 >> ((0u - 11u) & 31u))));
    // glimt_sampling/src/xoshiro.rs:62
    return result;
}

// glimt_sampling/src/uniform.rs:34
fn Xoshiro128PlusPlus_next_uvec2_(this_6: ptr<function, Xoshiro128PlusPlus>) -> vec2<u32> {

    // glimt_sampling/src/uniform.rs:35
    let _e3 = Xoshiro128PlusPlus_next_u32_(this_6);
    // glimt_sampling/src/uniform.rs:36
    let _e5 = Xoshiro128PlusPlus_next_u32_(this_6);
    // glimt_sampling/src/uniform.rs:37
    return vec2<u32>(_e3, _e5);
}

// glimt_render_gpu/src/kernels/pattern.rs:146
fn PixelPattern_key(this_7: PixelPattern, purpose_2: u32) -> u32 {

    // glimt_render_gpu/src/kernels/pattern.rs:147
    let _e5 = hash2_(this_7.seed, purpose_2);
    let _e8 = hash3_(_e5, this_7.frame, this_7.pixel);
    return _e8;
}

// glimt_render_gpu/src/kernels/pattern.rs:221
fn permute(index_7: u32, length_: u32, key: u32) -> u32 {
    var x_4: u32;
    var round_key: u32;
    var counter_2: i32;

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
    x_4 = index_7;
    // glimt_render_gpu/src/kernels/pattern.rs:228
    loop {
        // glimt_render_gpu/src/kernels/pattern.rs:229
        round_key = key;
        // glimt_render_gpu/src/kernels/pattern.rs:230
        counter_2 = 0i;
        loop {
            let _e31 = counter_2;
            if (_e31 >= 3i) {
                break;
            }
            // glimt_render_gpu/src/kernels/pattern.rs:231
            let _e34 = round_key;
            let _e35 = hash_u32_(_e34);
            round_key = _e35;
            // glimt_render_gpu/src/kernels/pattern.rs:233
            let _e37 = x_4;
            let _e38 = round_key;
            x_4 = (((_e37 ^ _e38) * 2654435761u) & mask);
            // glimt_render_gpu/src/kernels/pattern.rs:234
            let _e44 = x_4;
            let _e46 = (bits_2 / 2u);
            let _e56 = x_4;
            x_4 = (_e56 ^ (_e44 >> (select(_e46, (_e46 + 1u), ((bits_2 % 2u) != 0u)) & 31u)));
            continuing {
                let _e58 = counter_2;
                counter_2 = (_e58 + 1i);
            }
        }
        // glimt_render_gpu/src/kernels/pattern.rs:236
        let _e62 = x_4;
        if (_e62 < length_) {
            // glimt_render_gpu/src/kernels/pattern.rs:237
            let _e65 = x_4;
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
fn jittered_pair(index_8: u32, count_1: u32, jitter_1: vec2<u32>, key_1: u32) -> vec2<u32> {

    // glimt_render_gpu/src/kernels/pattern.rs:193
    let columns = max(u32(sqrt(f32(count_1))), 1u);
    // glimt_render_gpu/src/kernels/pattern.rs:194
    let _e12 = (count_1 / columns);
    let rows = select(_e12, (_e12 + 1u), ((count_1 % columns) != 0u));
    // glimt_render_gpu/src/kernels/pattern.rs:195
    let _e21 = hash2_(key_1, 1u);
    let _e22 = permute(index_8, count_1, _e21);
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

// glimt_render_gpu/src/kernels/pattern.rs:67
fn PixelPattern_pair(this_8: PixelPattern, purpose_3: u32, sample: u32, samples: u32) -> vec2<u32> {
    var borrowed: OwenSobol;
    var borrowed_1: Xoshiro128PlusPlus;

    // glimt_render_gpu/src/kernels/pattern.rs:68
    let index_16 = ((this_8.ray * samples) + sample);
    // glimt_render_gpu/src/kernels/pattern.rs:69
    if (this_8.kind == 0u) {
        // glimt_render_gpu/src/kernels/pattern.rs:70
        let _e14 = PixelPattern_sobol_point(this_8, purpose_3, index_16);
        borrowed = _e14;
        let _e16 = OwenSobol_next_uvec2_((&borrowed));
        return _e16;
    }
    // glimt_render_gpu/src/kernels/pattern.rs:72
    let _e18 = PixelPattern_generator(this_8, purpose_3, index_16);
    borrowed_1 = _e18;
    let _e20 = Xoshiro128PlusPlus_next_uvec2_((&borrowed_1));
    // glimt_render_gpu/src/kernels/pattern.rs:73
    if (this_8.kind == 1u) {
        // glimt_render_gpu/src/kernels/pattern.rs:74
        return _e20;
    }
    // glimt_render_gpu/src/kernels/pattern.rs:76
    let _e29 = PixelPattern_key(this_8, purpose_3);
    let _e30 = jittered_pair(index_16, (this_8.rays * samples), _e20, _e29);
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
fn CameraView_direction(this_9: CameraView, p: vec2<f32>, size: vec2<u32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/camera.rs:24
    let x_7 = (((2f * p.x) / f32(size.x)) - 1f);
    // glimt_render_gpu/src/kernels/camera.rs:25
    let y_1 = (((2f * p.y) / f32(size.y)) - 1f);
    // glimt_render_gpu/src/kernels/camera.rs:26
    return normalize(((this_9.forward + (this_9.right * x_7)) - (this_9.up * y_1)));
}

// glimt_render_gpu/src/kernels/frame.rs:161
fn FrameParams_direction(this_10: FrameParams, pixel_3: u32, place: vec2<f32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/frame.rs:162
    let corner_1 = vec2<f32>(vec2<u32>((pixel_3 % this_10.width), (pixel_3 / this_10.width)));
    // glimt_render_gpu/src/kernels/frame.rs:163
    let view = CameraView(this_10.eye, this_10.forward, this_10.right, this_10.up);
    // glimt_render_gpu/src/kernels/frame.rs:169
    let _e22 = CameraView_direction(view, (corner_1 + place), vec2<u32>(this_10.width, this_10.height));
    return _e22;
}

// glimt_render_gpu/src/kernels/pattern.rs:131
fn PixelPattern_ray_key(this_11: PixelPattern, purpose_4: u32) -> u32 {

    // glimt_render_gpu/src/kernels/pattern.rs:132
    let _e4 = PixelPattern_key(this_11, purpose_4);
    let _e6 = hash2_(_e4, this_11.ray);
    return _e6;
}

// glimt_render_gpu/src/kernels/ray.rs:59
fn inverse(x_5: f32) -> f32 {

    // glimt_render_gpu/src/kernels/ray.rs:60
    return (1f / bitcast<f32>(((bitcast<u32>(max(abs(x_5), 0.000000000000000001f)) & 2147483647u) | (bitcast<u32>(x_5) & 2147483648u))));
}

// glimt_render_gpu/src/kernels/ray.rs:44
fn Ray_keyed(origin: vec3<f32>, direction: vec3<f32>, key_2: u32) -> Ray {

    // glimt_render_gpu/src/kernels/ray.rs:45
    let _e6 = inverse(direction.x);
    let _e8 = inverse(direction.y);
    let _e10 = inverse(direction.z);
    return Ray(origin, direction, vec3<f32>(_e6, _e8, _e10), key_2);
}

// glimt_render_gpu/src/kernels/frame.rs:144
fn FrameParams_camera_ray(this_12: FrameParams, pattern: PixelPattern) -> Ray {
    var chosen_2: vec2<f32>;

    // glimt_render_gpu/src/kernels/frame.rs:145
    let film = PixelPattern(pattern.kind, pattern.seed, this_12.film_frame, pattern.pixel, pattern.ray, pattern.rays);
    // glimt_render_gpu/src/kernels/frame.rs:149
    if (this_12.filter_ == 1u) {
        // glimt_render_gpu/src/kernels/frame.rs:150
        chosen_2 = vec2(0.5f);
    } else {
        // glimt_render_gpu/src/kernels/frame.rs:152
        let _e23 = PixelPattern_pair(film, 1u, 0u, 1u);
        let _e24 = unit_vec2_(_e23);
        chosen_2 = _e24;
    }
    let place_2 = chosen_2;
    // glimt_render_gpu/src/kernels/frame.rs:154
    let _e28 = FrameParams_direction(this_12, pattern.pixel, place_2);
    // glimt_render_gpu/src/kernels/frame.rs:155
    let _e32 = PixelPattern_ray_key(film, 8u);
    let _e33 = Ray_keyed(this_12.eye, _e28, _e32);
    return _e33;
}

// glimt_render_gpu/src/kernels/bvh.rs:53
fn meet(node: BvhNode, ray_1: Ray, reach: f32) -> Met {
    var node_1: BvhNode;

    node_1 = node;
    // glimt_render_gpu/src/kernels/bvh.rs:54
    let _e12 = Tuple_f32_f32_f32_(ray_1.origin.x, ray_1.origin.y, ray_1.origin.z);
    let x_8 = _e12.fa;
    let y_2 = _e12.fb;
    let z_2 = _e12.fc;
    // glimt_render_gpu/src/kernels/bvh.rs:55
    let inverse_1 = ray_1.inverse_direction;
    // glimt_render_gpu/src/kernels/bvh.rs:56
    let _e20 = node_1.min_x;
    let to_min_x = ((_e20 - vec4(x_8)) * inverse_1.x);
    // glimt_render_gpu/src/kernels/bvh.rs:57
    let _e27 = node_1.max_x;
    let to_max_x = ((_e27 - vec4(x_8)) * inverse_1.x);
    // glimt_render_gpu/src/kernels/bvh.rs:58
    let _e34 = node_1.min_y;
    let to_min_y = ((_e34 - vec4(y_2)) * inverse_1.y);
    // glimt_render_gpu/src/kernels/bvh.rs:59
    let _e41 = node_1.max_y;
    let to_max_y = ((_e41 - vec4(y_2)) * inverse_1.y);
    // glimt_render_gpu/src/kernels/bvh.rs:60
    let _e48 = node_1.min_z;
    let to_min_z = ((_e48 - vec4(z_2)) * inverse_1.z);
    // glimt_render_gpu/src/kernels/bvh.rs:61
    let _e55 = node_1.max_z;
    let to_max_z = ((_e55 - vec4(z_2)) * inverse_1.z);
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
fn seen(triangle: Triangle, ray_2: Ray) -> Seen {

    // glimt_render_gpu/src/kernels/triangle.rs:164
    let x_9 = (triangle.x - vec4(ray_2.origin.x));
    // glimt_render_gpu/src/kernels/triangle.rs:165
    let y_3 = (triangle.y - vec4(ray_2.origin.y));
    // glimt_render_gpu/src/kernels/triangle.rs:166
    let z_3 = (triangle.z - vec4(ray_2.origin.z));
    // glimt_render_gpu/src/kernels/triangle.rs:168
    let _e24 = Tuple_Vec4_Vec4_(x_9.yzxw, x_9.zxyw);
    let x1_ = _e24.fa;
    let x2_ = _e24.fb;
    // glimt_render_gpu/src/kernels/triangle.rs:169
    let _e30 = Tuple_Vec4_Vec4_(y_3.yzxw, y_3.zxyw);
    let y1_ = _e30.fa;
    let y2_ = _e30.fb;
    // glimt_render_gpu/src/kernels/triangle.rs:170
    let _e36 = Tuple_Vec4_Vec4_(z_3.yzxw, z_3.zxyw);
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
    let d = ray_2.direction;
    // glimt_render_gpu/src/kernels/triangle.rs:174
    let functions = (((((edge_y * sum_z) - (edge_z * sum_y)) * d.x) + (((edge_z * sum_x) - (edge_x * sum_z)) * d.y)) + (((edge_x * sum_y) - (edge_y * sum_x)) * d.z));
    // glimt_render_gpu/src/kernels/triangle.rs:177
    return Seen(vec3<f32>(x_9.x, y_3.x, z_3.x), edge_x, edge_y, edge_z, functions);
}

// glimt_render_gpu/src/kernels/triangle.rs:191
fn intersect(triangle_1: Triangle, ray_3: Ray, t_max: f32) -> f32 {
    var chosen_3: f32;

    // glimt_render_gpu/src/kernels/triangle.rs:192
    let _e5 = seen(triangle_1, ray_3);
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
    let normal_2 = cross(from_a, to_a);
    // glimt_render_gpu/src/kernels/triangle.rs:199
    let slope = dot(normal_2, ray_3.direction);
    // glimt_render_gpu/src/kernels/triangle.rs:200
    if (slope == 0f) {
        // glimt_render_gpu/src/kernels/triangle.rs:201
        return 0x1.fffffep+127f;
    }
    // glimt_render_gpu/src/kernels/triangle.rs:203
    let t_4 = (dot(_e5.a, normal_2) / slope);
    // glimt_render_gpu/src/kernels/triangle.rs:204
    if ((t_4 > 0f) && (t_4 < t_max)) {
        chosen_3 = t_4;
    } else {
        chosen_3 = 0x1.fffffep+127f;
    }
    let _e67 = chosen_3;
    return _e67;
}

// glimt_render_gpu/src/kernels/triangle.rs:99
fn Triangle_is_see_through(this_13: Triangle) -> bool {

    // glimt_render_gpu/src/kernels/triangle.rs:100
    return ((this_13.object & 1073741824u) != 0u);
}

// glimt_render_gpu/src/kernels/triangle.rs:210
fn barycentrics(triangle_2: Triangle, ray_4: Ray) -> vec2<f32> {

    // glimt_render_gpu/src/kernels/triangle.rs:211
    let _e4 = seen(triangle_2, ray_4);
    let w_2 = _e4.functions.xyz;
    // glimt_render_gpu/src/kernels/triangle.rs:212
    let sum_2 = ((w_2.x + w_2.y) + w_2.z);
    // glimt_render_gpu/src/kernels/triangle.rs:213
    if (sum_2 == 0f) {
        // glimt_render_gpu/src/kernels/triangle.rs:215
        return vec2((1f / 3f));
    }
    // glimt_render_gpu/src/kernels/triangle.rs:217
    return (vec2<f32>(w_2.y, w_2.z) / vec2(sum_2));
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
fn Attributes_at(first_1: u32, u_2: f32, v_1: f32) -> Attributes {

    // glimt_render_gpu/src/kernels/material.rs:130
    let _e5 = Attributes_of_corner(first_1);
    // glimt_render_gpu/src/kernels/material.rs:131
    let _e9 = Attributes_of_corner((first_1 + 4u));
    // glimt_render_gpu/src/kernels/material.rs:132
    let _e15 = Attributes_of_corner((first_1 + (2u * 4u)));
    // glimt_render_gpu/src/kernels/material.rs:133
    let w_3 = ((1f - u_2) - v_1);
    // glimt_render_gpu/src/kernels/material.rs:134
    return Attributes((((_e5.uv * w_3) + (_e9.uv * u_2)) + (_e15.uv * v_1)), (((_e5.color * w_3) + (_e9.color * u_2)) + (_e15.color * v_1)));
}

// glimt_render_gpu/src/kernels/material.rs:172
fn MaterialView_new(index_9: u32) -> Returned_MaterialView_new {

    // glimt_render_gpu/src/kernels/material.rs:173
    let first_3 = (256u + (index_9 * 76u));
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
fn TextureView_exists(this_14: TextureView) -> bool {

    // glimt_render_gpu/src/kernels/texture.rs:41
    return (this_14.width > 0u);
}

// glimt_render_gpu/src/kernels/texture.rs:90
fn wrap(x_6: f32, mode: u32) -> f32 {

    // glimt_render_gpu/src/kernels/texture.rs:91
    if (mode == 2u) {
        // glimt_render_gpu/src/kernels/texture.rs:92
        return clamp(x_6, 0f, 1f);
    }
    // glimt_render_gpu/src/kernels/texture.rs:94
    if (mode == 1u) {
        // glimt_render_gpu/src/kernels/texture.rs:95
        let folded = (x_6 - (2f * floor((0.5f * x_6))));
        // glimt_render_gpu/src/kernels/texture.rs:96
        return clamp(min(folded, (2f - folded)), 0f, 1f);
    }
    // glimt_render_gpu/src/kernels/texture.rs:98
    return clamp((x_6 - floor(x_6)), 0f, 1f);
}

// glimt_render_gpu/src/kernels/texture.rs:103
fn neighbour(index_10: i32, size_1: u32, mode_1: u32) -> u32 {

    // glimt_render_gpu/src/kernels/texture.rs:104
    let last = (i32(size_1) - 1i);
    // glimt_render_gpu/src/kernels/texture.rs:105
    if (mode_1 == 0u) {
        // glimt_render_gpu/src/kernels/texture.rs:106
        if (index_10 < 0i) {
            // glimt_render_gpu/src/kernels/texture.rs:107
            return u32(last);
        }
        // glimt_render_gpu/src/kernels/texture.rs:109
        if (index_10 > last) {
            // glimt_render_gpu/src/kernels/texture.rs:110
            return 0u;
        }
    }
    // glimt_render_gpu/src/kernels/texture.rs:113
    return u32(clamp(index_10, 0i, last));
}

// glimt_render_gpu/src/kernels/texture.rs:69
fn TextureView_texel(this_15: TextureView, index_11: u32) -> vec4<f32> {
    var chosen_4: vec4<f32>;

    // glimt_render_gpu/src/kernels/texture.rs:70
    let word_4 = scene_surface[(this_15.first + index_11)];
    // glimt_render_gpu/src/kernels/texture.rs:71
    let r = (word_4 & 255u);
    // glimt_render_gpu/src/kernels/texture.rs:72
    let g = ((word_4 >> 8u) & 255u);
    // glimt_render_gpu/src/kernels/texture.rs:73
    let b_2 = ((word_4 >> 16u) & 255u);
    // glimt_render_gpu/src/kernels/texture.rs:74
    let alpha_2 = (f32((word_4 >> 24u)) / 255f);
    // glimt_render_gpu/src/kernels/texture.rs:75
    if ((this_15.flags & 1u) != 0u) {
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
fn TextureView_sample(this_16: TextureView, uv: vec2<f32>) -> vec4<f32> {

    // glimt_render_gpu/src/kernels/texture.rs:50
    let wrap_u = ((this_16.flags >> 1u) & 3u);
    // glimt_render_gpu/src/kernels/texture.rs:51
    let wrap_v = ((this_16.flags >> ((1u + 2u) & 31u)) & 3u);
    // glimt_render_gpu/src/kernels/texture.rs:52
    let _e21 = wrap(uv.x, wrap_u);
    let x_10 = ((_e21 * f32(this_16.width)) - 0.5f);
    // glimt_render_gpu/src/kernels/texture.rs:53
    let _e29 = wrap(uv.y, wrap_v);
    let y_4 = ((_e29 * f32(this_16.height)) - 0.5f);
    // glimt_render_gpu/src/kernels/texture.rs:54
    let _e38 = Tuple_f32_f32_(floor(x_10), floor(y_4));
    let left = _e38.fa;
    let top = _e38.fb;
    // glimt_render_gpu/src/kernels/texture.rs:55
    let _e44 = neighbour(i32(left), this_16.width, wrap_u);
    // glimt_render_gpu/src/kernels/texture.rs:56
    let _e50 = neighbour((i32(left) + 1i), this_16.width, wrap_u);
    // glimt_render_gpu/src/kernels/texture.rs:57
    let _e54 = neighbour(i32(top), this_16.height, wrap_v);
    let row0_ = (_e54 * this_16.width);
    // glimt_render_gpu/src/kernels/texture.rs:58
    let _e62 = neighbour((i32(top) + 1i), this_16.height, wrap_v);
    let row1_ = (_e62 * this_16.width);
    // glimt_render_gpu/src/kernels/texture.rs:59
    let _e67 = TextureView_texel(this_16, (row0_ + _e44));
    let _e69 = TextureView_texel(this_16, (row0_ + _e50));
    let _e70 = (x_10 - left);
    let upper = ((_e67 * (1f - _e70)) + (_e69 * _e70));
    // glimt_render_gpu/src/kernels/texture.rs:62
    let _e78 = TextureView_texel(this_16, (row1_ + _e44));
    let _e80 = TextureView_texel(this_16, (row1_ + _e50));
    let _e81 = (x_10 - left);
    let lower = ((_e78 * (1f - _e81)) + (_e80 * _e81));
    // glimt_render_gpu/src/kernels/texture.rs:65
    let _e88 = (y_4 - top);
    return ((upper * (1f - _e88)) + (lower * _e88));
}

// glimt_render_gpu/src/kernels/material.rs:206
fn MaterialView_sample(words_start_2: u32, words_len_2: u32, word_2: u32, texture: TextureView, uv_1: vec2<f32>) -> vec4<f32> {
    var place_1: vec2<f32>;

    // glimt_render_gpu/src/kernels/material.rs:207
    place_1 = uv_1;
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
        place_1 = (((vec2<f32>(_e18, _e21) * uv_1.x) + (vec2<f32>(_e27, _e30) * uv_1.y)) + vec2<f32>(_e37, _e40));
    }
    // glimt_render_gpu/src/kernels/material.rs:214
    let _e44 = place_1;
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
fn alpha_at(triangle_3: Triangle, u_3: f32, v_2: f32) -> f32 {

    // glimt_render_gpu/src/kernels/opacity.rs:15
    let _e6 = Attributes_at(triangle_3.attributes, u_3, v_2);
    // glimt_render_gpu/src/kernels/opacity.rs:16
    let _e11 = MaterialView_new((triangle_3.material & 2147483647u));
    // glimt_render_gpu/src/kernels/opacity.rs:17
    let _e18 = MaterialView_alpha(_e11.value_words_start, _e11.value_words_len, _e6.uv, _e6.color.w);
    return _e18;
}

// glimt_render_gpu/src/kernels/opacity.rs:26
fn passes(key_3: u32, index_12: u32, alpha_1: f32) -> bool {

    // glimt_render_gpu/src/kernels/opacity.rs:27
    let _e5 = hash2_(key_3, index_12);
    let _e6 = unit_f32_(_e5);
    return (_e6 >= alpha_1);
}

// glimt_render_gpu/src/kernels/opacity.rs:33
fn is_passed(index_13: u32, triangle_4: Triangle, ray_5: Ray) -> bool {

    // glimt_render_gpu/src/kernels/opacity.rs:34
    let _e5 = barycentrics(triangle_4, ray_5);
    // glimt_render_gpu/src/kernels/opacity.rs:35
    let _e9 = alpha_at(triangle_4, _e5.x, _e5.y);
    // glimt_render_gpu/src/kernels/opacity.rs:36
    let _e12 = passes(ray_5.key, index_13, _e9);
    return _e12;
}

// glimt_render_gpu/src/kernels/triangle.rs:85
fn Triangle_is_catcher(this_17: Triangle) -> bool {

    // glimt_render_gpu/src/kernels/triangle.rs:86
    return ((this_17.object & 2147483648u) != 0u);
}

// glimt_render_gpu/src/kernels/triangle.rs:71
fn Triangle_b(this_18: Triangle) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/triangle.rs:72
    return vec3<f32>(this_18.x.y, this_18.y.y, this_18.z.y);
}

// glimt_render_gpu/src/kernels/triangle.rs:64
fn Triangle_a(this_19: Triangle) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/triangle.rs:65
    return vec3<f32>(this_19.x.x, this_19.y.x, this_19.z.x);
}

// glimt_render_gpu/src/kernels/triangle.rs:78
fn Triangle_c(this_20: Triangle) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/triangle.rs:79
    return vec3<f32>(this_20.x.z, this_20.y.z, this_20.z.z);
}

// glimt_render_gpu/src/kernels/triangle.rs:140
fn Triangle_area_normal(this_21: Triangle) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/triangle.rs:141
    let _e3 = Triangle_b(this_21);
    let _e4 = Triangle_a(this_21);
    let _e6 = Triangle_c(this_21);
    let _e7 = Triangle_a(this_21);
    return cross((_e3 - _e4), (_e6 - _e7));
}

// glimt_render_gpu/src/kernels/triangle.rs:106
fn Triangle_ray_offset(this_22: Triangle) -> f32 {

    // glimt_render_gpu/src/kernels/triangle.rs:107
    let extent = max(max(abs(this_22.x), abs(this_22.y)), abs(this_22.z));
    // glimt_render_gpu/src/kernels/triangle.rs:108
    return (0.0000038146973f * max(max(max(extent.x, extent.y), extent.z), extent.w));
}

// glimt_render_gpu/src/kernels/triangle.rs:114
fn Triangle_setback(this_23: Triangle, ray_6: Ray, t: f32) -> f32 {

    // glimt_render_gpu/src/kernels/triangle.rs:115
    let _e5 = Triangle_area_normal(this_23);
    // glimt_render_gpu/src/kernels/triangle.rs:116
    let across = abs(dot(_e5, ray_6.direction));
    // glimt_render_gpu/src/kernels/triangle.rs:117
    let _e12 = Triangle_ray_offset(this_23);
    let apart = (2f * max(_e12, ((0.0000038146973f * t) * sqrt(dot(ray_6.direction, ray_6.direction)))));
    // glimt_render_gpu/src/kernels/triangle.rs:122
    return min(((apart * sqrt(dot(_e5, _e5))) / max(across, 0.000000000000000000000000000000000000011754944f)), t);
}

// glimt_render_gpu/src/kernels/bvh.rs:214
fn held(index_14: u32, triangle_5: Triangle, ray_7: Ray, t_1: f32, no_catcher: bool) -> f32 {
    var both: bool;

    // glimt_render_gpu/src/kernels/bvh.rs:222
    let _e7 = Triangle_is_see_through(triangle_5);
    both = _e7;
    if _e7 {
        let _e9 = is_passed(index_14, triangle_5, ray_7);
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
    let _e21 = Triangle_setback(triangle_5, ray_7, t_1);
    return (t_1 + _e21);
}

// glimt_render_gpu/src/kernels/bvh.rs:187
fn visit_leaf(first_2: u32, ray_8: Ray, reach_1: ptr<function, f32>, best: u32, no_catcher_1: bool) -> u32 {
    var nearest: u32;
    var counter_3: u32;
    var t_2: f32;
    var both_1: bool;

    // glimt_render_gpu/src/kernels/bvh.rs:196
    nearest = best;
    // glimt_render_gpu/src/kernels/bvh.rs:197
    let _e12 = scene_triangles[first_2].run;
    counter_3 = first_2;
    loop {
        let i = counter_3;
        if (i >= (first_2 + _e12)) {
            break;
        }
        // glimt_render_gpu/src/kernels/bvh.rs:198
        let _e20 = scene_triangles[i];
        let _e21 = (*reach_1);
        let _e22 = intersect(_e20, ray_8, _e21);
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
            let _e41 = held(i, _e39, ray_8, _e40, no_catcher_1);
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
            let _e49 = counter_3;
            counter_3 = (_e49 + 1u);
        }
    }
    // glimt_render_gpu/src/kernels/bvh.rs:208
    let _e53 = nearest;
    return _e53;
}

// glimt_render_gpu/src/kernels/bvh.rs:125
fn traverse(ray_9: Ray, reach_2: ptr<function, f32>, any_: bool) -> u32 {
    var best_1: u32;
    var stack: array<u32, 64>;
    var height: u32;
    var at: u32;
    var next: u32;
    var node_2: BvhNode;
    var met: Met;
    var distance_: f32;
    var counter_4: u32;
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
            let _e41 = meet(_e39, ray_9, _e40);
            met = _e41;
            // glimt_render_gpu/src/kernels/bvh.rs:146
            distance_ = 0x1.fffffep+127f;
            // glimt_render_gpu/src/kernels/bvh.rs:148
            counter_4 = 0u;
            loop {
                let i_1 = counter_4;
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
                    let _e94 = counter_4;
                    counter_4 = (_e94 + 1u);
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

// glimt_render_gpu/src/kernels/bvh.rs:82
fn closest_hit(ray_10: Ray, t_max_1: f32) -> Option_Hit {
    var t_3: f32;

    // glimt_render_gpu/src/kernels/bvh.rs:89
    t_3 = t_max_1;
    // glimt_render_gpu/src/kernels/bvh.rs:90
    let _e7 = traverse(ray_10, (&t_3), false);
    // glimt_render_gpu/src/kernels/bvh.rs:91
    if (_e7 == 4294967295u) {
        // glimt_render_gpu/src/kernels/bvh.rs:92
        return Option_Hit();
    }
    // glimt_render_gpu/src/kernels/bvh.rs:94
    let triangle_6 = scene_triangles[_e7];
    // glimt_render_gpu/src/kernels/bvh.rs:95
    let _e18 = Triangle_is_catcher(triangle_6);
    if _e18 {
        // glimt_render_gpu/src/kernels/bvh.rs:97
        let _e21 = intersect(triangle_6, ray_10, 0x1.fffffep+127f);
        t_3 = _e21;
    }
    // glimt_render_gpu/src/kernels/bvh.rs:99
    let _e23 = t_3;
    let _e24 = barycentrics(triangle_6, ray_10);
    return Option_Hit(true, Hit(_e7, _e23, _e24));
}

// glimt_render_gpu/src/kernels/scene.rs:82
fn Scene_closest_hit(ray_11: Ray) -> Option_Hit {

    // glimt_render_gpu/src/kernels/scene.rs:83
    let _e4 = closest_hit(ray_11, 0x1.fffffep+127f);
    return _e4;
}

// glimt_render_gpu/src/kernels/triangle.rs:128
fn Triangle_outward(this_24: Triangle) -> vec3<f32> {
    var chosen_6: vec3<f32>;

    // glimt_render_gpu/src/kernels/triangle.rs:129
    let _e3 = Triangle_area_normal(this_24);
    // glimt_render_gpu/src/kernels/triangle.rs:130
    if ((this_24.object & 536870912u) != 0u) {
        // glimt_render_gpu/src/kernels/triangle.rs:131
        chosen_6 = -(_e3);
    } else {
        // glimt_render_gpu/src/kernels/triangle.rs:133
        chosen_6 = _e3;
    }
    let _e14 = chosen_6;
    return _e14;
}

// glimt_render_gpu/src/kernels/scene.rs:144
fn unit_or(v_3: vec3<f32>, otherwise: vec3<f32>) -> vec3<f32> {
    var chosen_7: vec3<f32>;

    // glimt_render_gpu/src/kernels/scene.rs:145
    let length_squared = dot(v_3, v_3);
    // glimt_render_gpu/src/kernels/scene.rs:146
    if (length_squared > 0.000000000001f) {
        // glimt_render_gpu/src/kernels/scene.rs:147
        chosen_7 = (v_3 / vec3(sqrt(length_squared)));
    } else {
        // glimt_render_gpu/src/kernels/scene.rs:149
        chosen_7 = otherwise;
    }
    let _e14 = chosen_7;
    return _e14;
}

// glimt_render_gpu/src/kernels/material.rs:298
fn MaterialView_bumped_normal(words_start_4: u32, words_len_4: u32, uv_3: vec2<f32>, normal: vec3<f32>, tangent: vec3<f32>, handedness: f32) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/material.rs:299
    let _e9 = MaterialView_texture(words_start_4, words_len_4, 40u);
    // glimt_render_gpu/src/kernels/material.rs:300
    let across_1 = (tangent - (normal * dot(normal, tangent)));
    // glimt_render_gpu/src/kernels/material.rs:301
    let _e15 = TextureView_exists(_e9);
    if (!(_e15) || !((dot(across_1, across_1) > 0.000000000001f))) {
        // glimt_render_gpu/src/kernels/material.rs:302
        return normal;
    }
    // glimt_render_gpu/src/kernels/material.rs:304
    let t_6 = normalize(across_1);
    // glimt_render_gpu/src/kernels/material.rs:305
    let b_3 = (cross(normal, t_6) * handedness);
    // glimt_render_gpu/src/kernels/material.rs:306
    let _e30 = MaterialView_sample(words_start_4, words_len_4, 40u, _e9, uv_3);
    let bump = ((_e30.xyz * 2f) - vec3(1f));
    // glimt_render_gpu/src/kernels/material.rs:307
    let _e44 = MaterialView_number(words_start_4, words_len_4, 14u);
    let tilt = (((t_6 * bump.x) + (b_3 * bump.y)) * _e44);
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
fn ShadingFrame_from_normal(n_2: vec3<f32>) -> ShadingFrame {

    // glimt_sampling/src/math.rs:46
    let sign_ = bitcast<f32>(((bitcast<u32>(1f) & 2147483647u) | (bitcast<u32>(n_2.z) & 2147483648u)));
    // glimt_sampling/src/math.rs:47
    let a_2 = (-1f / (sign_ + n_2.z));
    // glimt_sampling/src/math.rs:48
    let c_1 = ((n_2.x * n_2.y) * a_2);
    // glimt_sampling/src/math.rs:49
    return ShadingFrame(vec3<f32>((1f + (((sign_ * n_2.x) * n_2.x) * a_2)), (sign_ * c_1), (-(sign_) * n_2.x)), vec3<f32>(c_1, (sign_ + ((n_2.y * n_2.y) * a_2)), -(n_2.y)), n_2);
}

// glimt_sampling/src/math.rs:66
fn ShadingFrame_to_local(this_25: ShadingFrame, v_4: vec3<f32>) -> vec3<f32> {

    // glimt_sampling/src/math.rs:67
    return vec3<f32>(dot(v_4, this_25.t), dot(v_4, this_25.b), dot(v_4, this_25.n));
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
fn Scene_shading_point(ray_12: Ray, hit: Hit) -> ShadingPoint {
    var chosen_8: vec3<f32>;
    var chosen_9: f32;
    var chosen_10: vec3<f32>;
    var vertex_color_3: vec3<f32>;

    // glimt_render_gpu/src/kernels/scene.rs:89
    let triangle_7 = scene_triangles[hit.triangle];
    // glimt_render_gpu/src/kernels/scene.rs:90
    let first_4 = (3u * hit.triangle);
    // glimt_render_gpu/src/kernels/scene.rs:91
    let a_3 = scene_corners[first_4];
    // glimt_render_gpu/src/kernels/scene.rs:92
    let b_4 = scene_corners[(first_4 + 1u)];
    // glimt_render_gpu/src/kernels/scene.rs:93
    let c_2 = scene_corners[(first_4 + 2u)];
    // glimt_render_gpu/src/kernels/scene.rs:94
    let _e33 = Tuple_f32_f32_(hit.barycentrics.x, hit.barycentrics.y);
    let u_4 = _e33.fa;
    let v_5 = _e33.fb;
    // glimt_render_gpu/src/kernels/scene.rs:95
    let w_4 = ((1f - u_4) - v_5);
    // glimt_render_gpu/src/kernels/scene.rs:97
    let to_eye_1 = -(ray_12.direction);
    // glimt_render_gpu/src/kernels/scene.rs:98
    let _e44 = Triangle_outward(triangle_7);
    let outward = normalize(_e44);
    // glimt_render_gpu/src/kernels/scene.rs:99
    let is_inside = (dot(outward, to_eye_1) < 0f);
    // glimt_render_gpu/src/kernels/scene.rs:100
    if is_inside {
        chosen_8 = -(outward);
    } else {
        chosen_8 = outward;
    }
    let geometric_normal_1 = chosen_8;
    // glimt_render_gpu/src/kernels/scene.rs:101
    let _e63 = unit_or((((a_3.normal * w_4) + (b_4.normal * u_4)) + (c_2.normal * v_5)), outward);
    // glimt_render_gpu/src/kernels/scene.rs:103
    let uv_7 = vec2<f32>((((a_3.u * w_4) + (b_4.u * u_4)) + (c_2.u * v_5)), (((a_3.v * w_4) + (b_4.v * u_4)) + (c_2.v * v_5)));
    // glimt_render_gpu/src/kernels/scene.rs:104
    let _e86 = MaterialView_new((triangle_7.material & 2147483647u));
    // glimt_render_gpu/src/kernels/scene.rs:105
    let tangent_1 = (((a_3.tangent * w_4) + (b_4.tangent * u_4)) + (c_2.tangent * v_5));
    // glimt_render_gpu/src/kernels/scene.rs:106
    if ((triangle_7.material & 2147483648u) != 0u) {
        // glimt_render_gpu/src/kernels/scene.rs:107
        chosen_9 = -1f;
    } else {
        // glimt_render_gpu/src/kernels/scene.rs:109
        chosen_9 = 1f;
    }
    let handedness_1 = chosen_9;
    // glimt_render_gpu/src/kernels/scene.rs:111
    let _e111 = MaterialView_bumped_normal(_e86.value_words_start, _e86.value_words_len, uv_7, _e63, tangent_1, handedness_1);
    // glimt_render_gpu/src/kernels/scene.rs:113
    if is_inside {
        chosen_10 = -(_e111);
    } else {
        chosen_10 = _e111;
    }
    let sided = chosen_10;
    // glimt_render_gpu/src/kernels/scene.rs:114
    let _e117 = bent_towards(sided, to_eye_1, geometric_normal_1);
    // glimt_render_gpu/src/kernels/scene.rs:116
    vertex_color_3 = vec3(1f);
    // glimt_render_gpu/src/kernels/scene.rs:117
    if (triangle_7.attributes != 0u) {
        // glimt_render_gpu/src/kernels/scene.rs:118
        let _e128 = Attributes_at(triangle_7.attributes, u_4, v_5);
        // glimt_render_gpu/src/kernels/scene.rs:119
        vertex_color_3 = _e128.color.xyz;
    }
    // glimt_render_gpu/src/kernels/scene.rs:121
    let _e133 = ShadingFrame_from_normal(_e117);
    // glimt_render_gpu/src/kernels/scene.rs:122
    let _e135 = Triangle_b(triangle_7);
    let _e136 = Triangle_a(triangle_7);
    let _e139 = Triangle_c(triangle_7);
    let _e140 = Triangle_a(triangle_7);
    let edges = (((_e135 - _e136) * u_4) + ((_e139 - _e140) * v_5));
    // glimt_render_gpu/src/kernels/scene.rs:123
    let _e145 = Triangle_a(triangle_7);
    let _e147 = Triangle_ray_offset(triangle_7);
    let _e150 = ShadingFrame_to_local(_e133, to_eye_1);
    let _e151 = vertex_color_3;
    let _e152 = MaterialView_brdf(_e86.value_words_start, _e86.value_words_len, uv_7, _e151);
    let _e153 = vertex_color_3;
    let _e154 = MaterialView_emission(_e86.value_words_start, _e86.value_words_len, uv_7, _e153);
    return ShadingPoint(((_e145 + edges) + (geometric_normal_1 * _e147)), geometric_normal_1, _e133, _e150, _e152, _e154);
}

// glimt_render_gpu/src/kernels/triangle.rs:92
fn Triangle_object_index(this_26: Triangle) -> u32 {

    // glimt_render_gpu/src/kernels/triangle.rs:93
    return (this_26.object & 536870911u);
}

// glimt_render_gpu/src/kernels/seen.rs:125
fn see_by(pattern_1: PixelPattern, frame_3: FrameParams) -> SeenPoint {
    var chosen_11: u32;
    var chosen_12: vec3<f32>;

    // glimt_render_gpu/src/kernels/seen.rs:126
    let _e4 = FrameParams_camera_ray(frame_3, pattern_1);
    // glimt_render_gpu/src/kernels/seen.rs:127
    let _e6 = Scene_closest_hit(_e4);
    if !(_e6.is_some) {
        // glimt_render_gpu/src/kernels/seen.rs:128
        return SeenPoint(vec3(0f), 0u, vec3(0f), 0u, vec3(0f), 0f, vec3(0f), 0u, vec3(0f), 0u, vec3(0f), 0u, vec3(0f), 0f);
    }
    let hit_1 = _e6.value;
    // glimt_render_gpu/src/kernels/seen.rs:130
    let _e34 = Scene_shading_point(_e4, hit_1);
    // glimt_render_gpu/src/kernels/seen.rs:131
    let triangle_8 = scene_triangles[hit_1.triangle];
    // glimt_render_gpu/src/kernels/seen.rs:132
    let _e41 = Triangle_is_catcher(triangle_8);
    // glimt_render_gpu/src/kernels/seen.rs:133
    let _e44 = Triangle_object_index(triangle_8);
    if _e41 {
        // glimt_render_gpu/src/kernels/seen.rs:137
        chosen_11 = 2u;
    } else {
        chosen_11 = 0u;
    }
    let _e52 = chosen_11;
    if _e41 {
        // glimt_render_gpu/src/kernels/seen.rs:147
        chosen_12 = vec3(0f);
    } else {
        // glimt_render_gpu/src/kernels/seen.rs:149
        chosen_12 = _e34.emission;
    }
    let _e72 = chosen_12;
    return SeenPoint(_e34.origin, (_e44 + 1u), _e34.geometric_normal, _e52, _e34.frame.n, _e34.brdf.exponent, -(_e4.direction), triangle_8.material, _e34.brdf.diffuse, 0u, _e34.brdf.specular, 0u, _e72, 0f);
}

// glimt_render_gpu/src/kernels/seen.rs:78
fn SeenPoint_is_hit(this_27: SeenPoint) -> bool {

    // glimt_render_gpu/src/kernels/seen.rs:79
    return (this_27.surface != 0u);
}

// glimt_sampling/src/math.rs:16
fn luminance(rgb: vec3<f32>) -> f32 {

    // glimt_sampling/src/math.rs:17
    return (((0.2126f * rgb.x) + (0.7152f * rgb.y)) + (0.0722f * rgb.z));
}

// glimt_render_gpu/src/kernels/seen.rs:85
fn SeenPoint_is_catcher(this_28: SeenPoint) -> bool {

    // glimt_render_gpu/src/kernels/seen.rs:86
    return ((this_28.flags & 2u) != 0u);
}

// glimt_render_gpu/src/kernels/scout.rs:90
fn enter(point: SeenPoint, off_centre: f32, entries_start: u32, entries_len: u32) {
    var at_1: u32;
    var is_found: bool;
    var counter_5: u32;
    var chosen_13: u32;

    // glimt_render_gpu/src/kernels/scout.rs:91
    at_1 = (3u - 1u);
    // glimt_render_gpu/src/kernels/scout.rs:92
    is_found = false;
    // glimt_render_gpu/src/kernels/scout.rs:93
    counter_5 = 0u;
    loop {
        let i_2 = counter_5;
        if (i_2 >= 3u) {
            break;
        }
        // glimt_render_gpu/src/kernels/scout.rs:94
        let own = entries[(entries_start + i_2)].surface;
        // glimt_render_gpu/src/kernels/scout.rs:95
        let _e25 = is_found;
        if (!(_e25) && ((own == point.surface) || (own == 0u))) {
            // glimt_render_gpu/src/kernels/scout.rs:96
            at_1 = i_2;
            // glimt_render_gpu/src/kernels/scout.rs:97
            is_found = true;
        }
        continuing {
            let _e36 = counter_5;
            counter_5 = (_e36 + 1u);
        }
    }
    // glimt_render_gpu/src/kernels/scout.rs:100
    let _e40 = at_1;
    let old = entries[(entries_start + _e40)];
    // glimt_render_gpu/src/kernels/scout.rs:101
    let hits = (old.hits + 1u);
    // glimt_render_gpu/src/kernels/scout.rs:102
    if ((old.surface == 0u) || ((old.surface == point.surface) && (off_centre < old.off_centre))) {
        // glimt_render_gpu/src/kernels/scout.rs:103
        let _e66 = luminance(point.diffuse);
        let _e68 = luminance(point.specular);
        let _e72 = SeenPoint_is_catcher(point);
        if _e72 {
            // glimt_render_gpu/src/kernels/scout.rs:114
            chosen_13 = 1u;
        } else {
            chosen_13 = 0u;
        }
        let _e76 = chosen_13;
        let _e79 = at_1;
        entries[(entries_start + _e79)] = TileEntry(point.origin, point.surface, point.normal, point.exponent, _e66, _e68, hits, off_centre, 0u, 0u, _e76, 0u);
    } else {
        // glimt_render_gpu/src/kernels/scout.rs:118
        let _e84 = at_1;
        entries[(entries_start + _e84)].hits = hits;
    }
    return;
}

// glimt_render_gpu/src/kernels/scout.rs:64
fn scout_1(tile_1: u32, frame_4: FrameParams, cells: CellParams, entries_start_1: u32, entries_len_1: u32) {
    var counter_6: u32;
    var counter_7: u32;
    var counter_8: u32;

    // glimt_render_gpu/src/kernels/scout.rs:71
    counter_6 = 0u;
    loop {
        let i_3 = counter_6;
        if (i_3 >= 3u) {
            break;
        }
        // glimt_render_gpu/src/kernels/scout.rs:72
        entries[(entries_start_1 + i_3)] = TileEntry(vec3(0f), 0u, vec3(0f), 0f, 0f, 0f, 0u, 0f, 0u, 0u, 0u, 0u);
        continuing {
            let _e31 = counter_6;
            counter_6 = (_e31 + 1u);
        }
    }
    // glimt_render_gpu/src/kernels/scout.rs:74
    let _e35 = CellParams_corner(cells, tile_1);
    // glimt_render_gpu/src/kernels/scout.rs:75
    let _e37 = tile_end(_e35, frame_4);
    // glimt_render_gpu/src/kernels/scout.rs:76
    counter_7 = _e35.y;
    loop {
        let y_5 = counter_7;
        if (y_5 >= _e37.y) {
            break;
        }
        // glimt_render_gpu/src/kernels/scout.rs:77
        counter_8 = _e35.x;
        loop {
            let x_11 = counter_8;
            if (x_11 >= _e37.x) {
                break;
            }
            // glimt_render_gpu/src/kernels/scout.rs:78
            let _e55 = FrameParams_pattern_at(frame_4, ((y_5 * frame_4.width) + x_11), 0u);
            let _e56 = see_by(_e55, frame_4);
            // glimt_render_gpu/src/kernels/scout.rs:79
            let _e58 = SeenPoint_is_hit(_e56);
            if _e58 {
                // glimt_render_gpu/src/kernels/scout.rs:80
                let across_2 = ((f32(x_11) + 0.5f) - (0.5f * f32((_e35.x + _e37.x))));
                // glimt_render_gpu/src/kernels/scout.rs:81
                let down = ((f32(y_5) + 0.5f) - (0.5f * f32((_e35.y + _e37.y))));
                // glimt_render_gpu/src/kernels/scout.rs:82
                enter(_e56, ((across_2 * across_2) + (down * down)), entries_start_1, entries_len_1);
            }
            continuing {
                let _e85 = counter_8;
                counter_8 = (_e85 + 1u);
            }
        }
        continuing {
            let _e88 = counter_7;
            counter_7 = (_e88 + 1u);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn scout(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let local = ((id.y * (groups.x * 64u)) + id.x);
    let _e11 = params.count;
    if (local >= _e11) {
        return;
    }
    let _e14 = params.first;
    let _e17 = params.frame;
    let _e19 = params.cells;
    let _e21 = params.entries_len;
    scout_1((_e14 + local), _e17, _e19, (local * _e21), _e21);
}
