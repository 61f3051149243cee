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

struct Returned_TileEntry_remembered {
    value_from: u32,
    value_turned: u32,
}

struct Returned_Environment_cells {
    value_size: vec2<u32>,
    value_start: u32,
}

struct PixelPattern {
    kind: u32,
    seed: u32,
    frame: u32,
    pixel: u32,
    ray: u32,
    rays: u32,
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

struct Tuple_Vec3_Vec3_ {
    fa: vec3<f32>,
    fb: vec3<f32>,
}

struct CellSurface {
    normal: vec3<f32>,
    wo: vec3<f32>,
    diffuse: f32,
    specular: f32,
    exponent: f32,
    peak: f32,
    spread: f32,
    horizon: f32,
    share: f32,
}

struct Representative {
    mean_normal: vec3<f32>,
    diffuse: vec3<f32>,
    specular: vec3<f32>,
    exponent: f32,
    peak: f32,
    surface: CellSurface,
}

struct Totals {
    quads: array<f32, 128>,
    lives: array<f32, 128>,
    weight: f32,
    live: f32,
    lobe: f32,
    lobe_spread: f32,
    lobe_visible: f32,
    lobe_square: f32,
    lobe_area: f32,
    diffuse: vec3<f32>,
    specular: vec3<f32>,
    open_diffuse: vec3<f32>,
    open_specular: vec3<f32>,
}

struct CellTerms {
    cosine: vec4<f32>,
    full: vec4<f32>,
    live: vec4<f32>,
    lobe: vec4<f32>,
    lobe_spread: vec4<f32>,
    cosine_spread: vec4<f32>,
}

struct QuadCounts {
    rays: vec4<f32>,
    arrived: vec4<f32>,
}

struct Proposal {
    of_: Representative,
    quads: array<f32, 128>,
    rows: array<f32, 16>,
    total: f32,
    defence: f32,
    lobe_worth: f32,
    lobe_share: f32,
    integral: vec3<f32>,
    open_integral: vec3<f32>,
    is_catcher: bool,
}

struct PatternSource {
    is_sobol: bool,
    point: OwenSobol,
    generator: Xoshiro128PlusPlus,
}

struct Place {
    target_: f32,
    sum: f32,
    index: u32,
    first: f32,
    width: f32,
    is_found: bool,
}

struct Bin {
    index: u32,
    first: u32,
    units: u32,
}

struct TexelDraw {
    texel: vec2<u32>,
    pmf: f32,
}

struct CellAt {
    weight: f32,
    live: f32,
    cosine: f32,
    is_full: bool,
    lobe: f32,
    visibility: f32,
}

struct CellDraw {
    at: CellAt,
    direction: vec3<f32>,
    texel: vec2<u32>,
    cell: u32,
}

struct Params {
    first: u32,
    count: u32,
    counts_len: u32,
    frame: FrameParams,
    cells: CellParams,
    env_size: vec2<u32>,
    env_rotation: vec2<f32>,
}

@group(0) @binding(1) 
var<storage> env_tables: array<u32>;
@group(0) @binding(2) 
var<storage> scene_nodes: array<BvhNode>;
@group(0) @binding(3) 
var<storage> scene_triangles: array<Triangle>;
@group(0) @binding(4) 
var<storage> scene_corners: array<Corner>;
@group(0) @binding(5) 
var<storage> scene_surface: array<u32>;
@group(0) @binding(6) 
var<storage> entries: array<TileEntry>;
@group(0) @binding(7) 
var<storage> past_counts: array<u32>;
@group(0) @binding(8) 
var<storage, read_write> counts: array<u32>;
@group(0) @binding(0) 
var<uniform> params: Params;

// glimt_render_gpu/src/kernels/cell_state.rs:200
fn TileEntry_remembered(this_: TileEntry, turned: u32) -> Returned_TileEntry_remembered {

    // glimt_render_gpu/src/kernels/cell_state.rs:201
    return Returned_TileEntry_remembered(this_.from_, turned);
}

// glimt_render_gpu/src/kernels/cell_state.rs:149
fn remembered(n: u32, s: u32) -> u32 {

    // glimt_render_gpu/src/kernels/cell_state.rs:150
    if (n <= 64u) {
        // glimt_render_gpu/src/kernels/cell_state.rs:151
        return (n | (s << 8u));
    }
    // glimt_render_gpu/src/kernels/cell_state.rs:153
    return (64u | (((((2u * s) * 64u) + n) / (2u * n)) << 8u));
}

// glimt_render_gpu/src/kernels/cell_state.rs:170
fn Remembered_cell(from_: u32, turned_1: u32, cell: u32) -> u32 {

    // glimt_render_gpu/src/kernels/cell_state.rs:171
    let column_1 = ((((cell % 32u) + 32u) - turned_1) % 32u);
    // glimt_render_gpu/src/kernels/cell_state.rs:172
    let was = (((cell / 32u) * 32u) + column_1);
    // glimt_render_gpu/src/kernels/cell_state.rs:173
    let word_7 = past_counts[(((from_ - 1u) * 256u) + (was / 2u))];
    // glimt_render_gpu/src/kernels/cell_state.rs:174
    let own = ((word_7 >> ((16u * (was & 1u)) & 31u)) & 65535u);
    // glimt_render_gpu/src/kernels/cell_state.rs:175
    let _e44 = remembered((own & 255u), (own >> 8u));
    return _e44;
}

// glimt_render_gpu/src/kernels/cell_state.rs:181
fn Remembered_word(from_1: u32, turned_2: u32, word: u32) -> u32 {

    // glimt_render_gpu/src/kernels/cell_state.rs:182
    if (from_1 == 0u) {
        // glimt_render_gpu/src/kernels/cell_state.rs:183
        return 0u;
    }
    // glimt_render_gpu/src/kernels/cell_state.rs:185
    let _e12 = Remembered_cell(from_1, turned_2, (2u * word));
    let _e17 = Remembered_cell(from_1, turned_2, ((2u * word) + 1u));
    return (_e12 | (_e17 << 16u));
}

// glimt_render_gpu/src/kernels/scout.rs:37
fn CellParams_corner(this_1: CellParams, tile: u32) -> vec2<u32> {

    // glimt_render_gpu/src/kernels/scout.rs:38
    return vec2<u32>(((tile % this_1.tiles_across) * 16u), ((tile / this_1.tiles_across) * 10u));
}

// glimt_render_gpu/src/kernels/scout.rs:56
fn tile_end(corner: vec2<u32>, frame: FrameParams) -> vec2<u32> {

    // glimt_render_gpu/src/kernels/scout.rs:57
    return vec2<u32>(min((corner.x + 16u), frame.width), min((corner.y + 10u), frame.height));
}

// glimt_render_gpu/src/kernels/environment.rs:78
fn Environment_cells(size: vec2<u32>, rotation: vec2<f32>) -> Returned_Environment_cells {

    // glimt_render_gpu/src/kernels/environment.rs:79
    return Returned_Environment_cells(size, 0u);
}

// glimt_render_gpu/src/kernels/frame.rs:130
fn FrameParams_pattern_at(this_2: FrameParams, pixel: u32, ray: u32) -> PixelPattern {

    // glimt_render_gpu/src/kernels/frame.rs:131
    return PixelPattern(this_2.pattern, this_2.seed, this_2.frame, pixel, ray, this_2.rays_per_pixel);
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

// glimt_sampling/src/sobol.rs:172
fn OwenSobol_new(seed: u32, frame_1: u32, pixel_1: u32, sample_index: u32) -> OwenSobol {

    // glimt_sampling/src/sobol.rs:173
    let _e6 = hash3_(seed, frame_1, pixel_1);
    let _e9 = hash2_(_e6, (sample_index >> 16u));
    return OwenSobol(_e9, (sample_index & 65535u), 0u);
}

// glimt_render_gpu/src/kernels/pattern.rs:136
fn PixelPattern_sobol_point(this_3: PixelPattern, purpose: u32, index: u32) -> OwenSobol {

    // glimt_render_gpu/src/kernels/pattern.rs:137
    let _e6 = hash2_(this_3.seed, purpose);
    let _e9 = OwenSobol_new(_e6, this_3.frame, this_3.pixel, index);
    return _e9;
}

// glimt_sampling/src/sobol.rs:21
fn owen_scramble_reversed(n_2: u32, scramble: u32) -> u32 {
    var x_1: u32;

    // glimt_sampling/src/sobol.rs:22
    x_1 = (n_2 ^ (n_2 * 1025551850u));
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
    let index_17 = (index_5 & 65535u);
    // glimt_sampling/src/sobol.rs:45
    let _e8 = (dimension & 3u);
    if (_e8 == 0u) {
        // glimt_sampling/src/sobol.rs:47
        chosen = index_17;
    } else {
        if (_e8 == 1u) {
            // glimt_sampling/src/sobol.rs:48
            let _e16 = pascal(index_17);
            chosen = _e16;
        } else {
            if (_e8 == 2u) {
                // glimt_sampling/src/sobol.rs:49
                let _e20 = recurrence_2_(index_17);
                chosen = _e20;
            } else {
                // glimt_sampling/src/sobol.rs:50
                let _e22 = recurrence_3_(index_17);
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
fn OwenSobol_next_uvec2_(this_4: ptr<function, OwenSobol>) -> vec2<u32> {

    // glimt_sampling/src/sobol.rs:192
    let _e4 = (*this_4).dimension;
    let dimension_2 = ((_e4 + 1u) & 4294967294u);
    // glimt_sampling/src/sobol.rs:193
    (*this_4).dimension = (dimension_2 + 2u);
    // glimt_sampling/src/sobol.rs:194
    let _e15 = (*this_4).seed;
    let _e18 = hash2_(_e15, (dimension_2 >> 2u));
    // glimt_sampling/src/sobol.rs:195
    let _e21 = (*this_4).index;
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
fn PixelPattern_generator(this_5: PixelPattern, purpose_1: u32, index_6: u32) -> Xoshiro128PlusPlus {

    // glimt_render_gpu/src/kernels/pattern.rs:142
    let _e6 = hash3_(this_5.seed, purpose_1, index_6);
    let _e9 = Xoshiro128PlusPlus_stream(_e6, this_5.frame, this_5.pixel);
    return _e9;
}

// glimt_sampling/src/xoshiro.rs:56
fn Xoshiro128PlusPlus_next_u32_(this_6: ptr<function, Xoshiro128PlusPlus>) -> u32 {

    // glimt_sampling/src/xoshiro.rs:57
    let s_2 = (*this_6).state;
    // glimt_sampling/src/xoshiro.rs:58
    let _e8 = (s_2.x + s_2.w);
    let result = (((_e8 << 7u) | (_e8 >> ((0u - 7u) & 31u))) + s_2.x);
    // glimt_sampling/src/xoshiro.rs:59
    let z_1 = (s_2.z ^ s_2.x);
    // glimt_sampling/src/xoshiro.rs:60
    let w_1 = (s_2.w ^ s_2.y);
    // glimt_sampling/src/xoshiro.rs:61
    (*this_6).state = vec4<u32>((s_2.x ^ w_1), (s_2.y ^ z_1), (z_1 ^ (s_2.y << 9u)), ((w_1 << 11u) | (w_1 >> ((0u - 11u) & 31u))));
    // glimt_sampling/src/xoshiro.rs:62
    return result;
}

// glimt_sampling/src/uniform.rs:34
fn Xoshiro128PlusPlus_next_uvec2_(this_7: ptr<function, Xoshiro128PlusPlus>) -> vec2<u32> {

    // glimt_sampling/src/uniform.rs:35
    let _e3 = Xoshiro128PlusPlus_next_u32_(this_7);
    // glimt_sampling/src/uniform.rs:36
    let _e5 = Xoshiro128PlusPlus_next_u32_(this_7);
    // glimt_sampling/src/uniform.rs:37
    return vec2<u32>(_e3, _e5);
}

// glimt_render_gpu/src/kernels/pattern.rs:146
fn PixelPattern_key(this_8: PixelPattern, purpose_2: u32) -> u32 {

    // glimt_render_gpu/src/kernels/pattern.rs:147
    let _e5 = hash2_(this_8.seed, purpose_2);
    let _e8 = hash3_(_e5, this_8.frame, this_8.pixel);
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
fn stratum(cell_1: u32, count: u32, jitter: u32) -> u32 {

    // glimt_render_gpu/src/kernels/pattern.rs:213
    return ((cell_1 * (4294967295u / count)) + (jitter / count));
}

// glimt_render_gpu/src/kernels/pattern.rs:192
fn jittered_pair(index_8: u32, count_1: u32, jitter_1: vec2<u32>, key_1: u32) -> vec2<u32> {

    // glimt_render_gpu/src/kernels/pattern.rs:193
    let columns = max(u32(sqrt(f32(count_1))), 1u);
    // glimt_render_gpu/src/kernels/pattern.rs:194
    let _e12 = (count_1 / columns);
    let rows_2 = select(_e12, (_e12 + 1u), ((count_1 % columns) != 0u));
    // glimt_render_gpu/src/kernels/pattern.rs:195
    let _e21 = hash2_(key_1, 1u);
    let _e22 = permute(index_8, count_1, _e21);
    // glimt_render_gpu/src/kernels/pattern.rs:196
    let _e26 = hash2_(key_1, 2u);
    let _e27 = permute((_e22 % columns), columns, _e26);
    // glimt_render_gpu/src/kernels/pattern.rs:197
    let _e31 = hash2_(key_1, 3u);
    let _e32 = permute((_e22 / columns), rows_2, _e31);
    // glimt_render_gpu/src/kernels/pattern.rs:198
    let _e38 = stratum(((_e27 * rows_2) + _e32), (columns * rows_2), jitter_1.x);
    let _e40 = stratum(_e22, count_1, jitter_1.y);
    return vec2<u32>(_e38, _e40);
}

// glimt_render_gpu/src/kernels/pattern.rs:67
fn PixelPattern_pair(this_9: PixelPattern, purpose_3: u32, sample: u32, samples: u32) -> vec2<u32> {
    var borrowed: OwenSobol;
    var borrowed_1: Xoshiro128PlusPlus;

    // glimt_render_gpu/src/kernels/pattern.rs:68
    let index_18 = ((this_9.ray * samples) + sample);
    // glimt_render_gpu/src/kernels/pattern.rs:69
    if (this_9.kind == 0u) {
        // glimt_render_gpu/src/kernels/pattern.rs:70
        let _e14 = PixelPattern_sobol_point(this_9, purpose_3, index_18);
        borrowed = _e14;
        let _e16 = OwenSobol_next_uvec2_((&borrowed));
        return _e16;
    }
    // glimt_render_gpu/src/kernels/pattern.rs:72
    let _e18 = PixelPattern_generator(this_9, purpose_3, index_18);
    borrowed_1 = _e18;
    let _e20 = Xoshiro128PlusPlus_next_uvec2_((&borrowed_1));
    // glimt_render_gpu/src/kernels/pattern.rs:73
    if (this_9.kind == 1u) {
        // glimt_render_gpu/src/kernels/pattern.rs:74
        return _e20;
    }
    // glimt_render_gpu/src/kernels/pattern.rs:76
    let _e29 = PixelPattern_key(this_9, purpose_3);
    let _e30 = jittered_pair(index_18, (this_9.rays * samples), _e20, _e29);
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
fn CameraView_direction(this_10: CameraView, p: vec2<f32>, size_1: vec2<u32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/camera.rs:24
    let x_11 = (((2f * p.x) / f32(size_1.x)) - 1f);
    // glimt_render_gpu/src/kernels/camera.rs:25
    let y_2 = (((2f * p.y) / f32(size_1.y)) - 1f);
    // glimt_render_gpu/src/kernels/camera.rs:26
    return normalize(((this_10.forward + (this_10.right * x_11)) - (this_10.up * y_2)));
}

// glimt_render_gpu/src/kernels/frame.rs:161
fn FrameParams_direction(this_11: FrameParams, pixel_3: u32, place: vec2<f32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/frame.rs:162
    let corner_1 = vec2<f32>(vec2<u32>((pixel_3 % this_11.width), (pixel_3 / this_11.width)));
    // glimt_render_gpu/src/kernels/frame.rs:163
    let view = CameraView(this_11.eye, this_11.forward, this_11.right, this_11.up);
    // glimt_render_gpu/src/kernels/frame.rs:169
    let _e22 = CameraView_direction(view, (corner_1 + place), vec2<u32>(this_11.width, this_11.height));
    return _e22;
}

// glimt_render_gpu/src/kernels/pattern.rs:131
fn PixelPattern_ray_key(this_12: PixelPattern, purpose_4: u32) -> u32 {

    // glimt_render_gpu/src/kernels/pattern.rs:132
    let _e4 = PixelPattern_key(this_12, purpose_4);
    let _e6 = hash2_(_e4, this_12.ray);
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
fn FrameParams_camera_ray(this_13: FrameParams, pattern: PixelPattern) -> Ray {
    var chosen_2: vec2<f32>;

    // glimt_render_gpu/src/kernels/frame.rs:145
    let film = PixelPattern(pattern.kind, pattern.seed, this_13.film_frame, pattern.pixel, pattern.ray, pattern.rays);
    // glimt_render_gpu/src/kernels/frame.rs:149
    if (this_13.filter_ == 1u) {
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
    let _e28 = FrameParams_direction(this_13, pattern.pixel, place_2);
    // glimt_render_gpu/src/kernels/frame.rs:155
    let _e32 = PixelPattern_ray_key(film, 8u);
    let _e33 = Ray_keyed(this_13.eye, _e28, _e32);
    return _e33;
}

// glimt_render_gpu/src/kernels/bvh.rs:53
fn meet(node: BvhNode, ray_1: Ray, reach: f32) -> Met {
    var node_1: BvhNode;

    node_1 = node;
    // glimt_render_gpu/src/kernels/bvh.rs:54
    let _e12 = Tuple_f32_f32_f32_(ray_1.origin.x, ray_1.origin.y, ray_1.origin.z);
    let x_12 = _e12.fa;
    let y_3 = _e12.fb;
    let z_2 = _e12.fc;
    // glimt_render_gpu/src/kernels/bvh.rs:55
    let inverse_1 = ray_1.inverse_direction;
    // glimt_render_gpu/src/kernels/bvh.rs:56
    let _e20 = node_1.min_x;
    let to_min_x = ((_e20 - vec4(x_12)) * inverse_1.x);
    // glimt_render_gpu/src/kernels/bvh.rs:57
    let _e27 = node_1.max_x;
    let to_max_x = ((_e27 - vec4(x_12)) * inverse_1.x);
    // glimt_render_gpu/src/kernels/bvh.rs:58
    let _e34 = node_1.min_y;
    let to_min_y = ((_e34 - vec4(y_3)) * inverse_1.y);
    // glimt_render_gpu/src/kernels/bvh.rs:59
    let _e41 = node_1.max_y;
    let to_max_y = ((_e41 - vec4(y_3)) * inverse_1.y);
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
    let x_13 = (triangle.x - vec4(ray_2.origin.x));
    // glimt_render_gpu/src/kernels/triangle.rs:165
    let y_4 = (triangle.y - vec4(ray_2.origin.y));
    // glimt_render_gpu/src/kernels/triangle.rs:166
    let z_3 = (triangle.z - vec4(ray_2.origin.z));
    // glimt_render_gpu/src/kernels/triangle.rs:168
    let _e24 = Tuple_Vec4_Vec4_(x_13.yzxw, x_13.zxyw);
    let x1_ = _e24.fa;
    let x2_ = _e24.fb;
    // glimt_render_gpu/src/kernels/triangle.rs:169
    let _e30 = Tuple_Vec4_Vec4_(y_4.yzxw, y_4.zxyw);
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
    let d_1 = ray_2.direction;
    // glimt_render_gpu/src/kernels/triangle.rs:174
    let functions = (((((edge_y * sum_z) - (edge_z * sum_y)) * d_1.x) + (((edge_z * sum_x) - (edge_x * sum_z)) * d_1.y)) + (((edge_x * sum_y) - (edge_y * sum_x)) * d_1.z));
    // glimt_render_gpu/src/kernels/triangle.rs:177
    return Seen(vec3<f32>(x_13.x, y_4.x, z_3.x), edge_x, edge_y, edge_z, functions);
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
    let normal_6 = cross(from_a, to_a);
    // glimt_render_gpu/src/kernels/triangle.rs:199
    let slope = dot(normal_6, ray_3.direction);
    // glimt_render_gpu/src/kernels/triangle.rs:200
    if (slope == 0f) {
        // glimt_render_gpu/src/kernels/triangle.rs:201
        return 0x1.fffffep+127f;
    }
    // glimt_render_gpu/src/kernels/triangle.rs:203
    let t_6 = (dot(_e5.a, normal_6) / slope);
    // glimt_render_gpu/src/kernels/triangle.rs:204
    if ((t_6 > 0f) && (t_6 < t_max)) {
        chosen_3 = t_6;
    } else {
        chosen_3 = 0x1.fffffep+127f;
    }
    let _e67 = chosen_3;
    return _e67;
}

// glimt_render_gpu/src/kernels/triangle.rs:99
fn Triangle_is_see_through(this_14: Triangle) -> bool {

    // glimt_render_gpu/src/kernels/triangle.rs:100
    return ((this_14.object & 1073741824u) != 0u);
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
    let first_7 = (256u + (index_9 * 76u));
    // glimt_render_gpu/src/kernels/material.rs:174
    return Returned_MaterialView_new(first_7, ((first_7 + 76u) - first_7));
}

// glimt_render_gpu/src/kernels/material.rs:181
fn MaterialView_number(words_start: u32, words_len: u32, word_1: u32) -> f32 {

    // glimt_render_gpu/src/kernels/material.rs:182
    let _e7 = scene_surface[(words_start + word_1)];
    return bitcast<f32>(_e7);
}

// glimt_render_gpu/src/kernels/material.rs:195
fn MaterialView_texture(words_start_1: u32, words_len_1: u32, word_2: u32) -> TextureView {

    // glimt_render_gpu/src/kernels/material.rs:196
    let _e7 = scene_surface[(words_start_1 + word_2)];
    let _e13 = scene_surface[(words_start_1 + (word_2 + 1u))];
    let _e19 = scene_surface[(words_start_1 + (word_2 + 2u))];
    let _e25 = scene_surface[(words_start_1 + (word_2 + 3u))];
    return TextureView(_e7, _e13, _e19, _e25);
}

// glimt_render_gpu/src/kernels/texture.rs:40
fn TextureView_exists(this_15: TextureView) -> bool {

    // glimt_render_gpu/src/kernels/texture.rs:41
    return (this_15.width > 0u);
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
fn neighbour(index_10: i32, size_2: u32, mode_1: u32) -> u32 {

    // glimt_render_gpu/src/kernels/texture.rs:104
    let last = (i32(size_2) - 1i);
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
fn TextureView_texel(this_16: TextureView, index_11: u32) -> vec4<f32> {
    var chosen_4: vec4<f32>;

    // glimt_render_gpu/src/kernels/texture.rs:70
    let word_8 = scene_surface[(this_16.first + index_11)];
    // glimt_render_gpu/src/kernels/texture.rs:71
    let r_1 = (word_8 & 255u);
    // glimt_render_gpu/src/kernels/texture.rs:72
    let g = ((word_8 >> 8u) & 255u);
    // glimt_render_gpu/src/kernels/texture.rs:73
    let b_2 = ((word_8 >> 16u) & 255u);
    // glimt_render_gpu/src/kernels/texture.rs:74
    let alpha_2 = (f32((word_8 >> 24u)) / 255f);
    // glimt_render_gpu/src/kernels/texture.rs:75
    if ((this_16.flags & 1u) != 0u) {
        // glimt_render_gpu/src/kernels/texture.rs:76
        let _e38 = scene_surface[r_1];
        let _e42 = scene_surface[g];
        let _e46 = scene_surface[b_2];
        chosen_4 = vec4<f32>(bitcast<f32>(_e38), bitcast<f32>(_e42), bitcast<f32>(_e46), alpha_2);
    } else {
        // glimt_render_gpu/src/kernels/texture.rs:83
        chosen_4 = vec4<f32>((f32(r_1) / 255f), (f32(g) / 255f), (f32(b_2) / 255f), alpha_2);
    }
    let _e60 = chosen_4;
    return _e60;
}

// glimt_render_gpu/src/kernels/texture.rs:49
fn TextureView_sample(this_17: TextureView, uv: vec2<f32>) -> vec4<f32> {

    // glimt_render_gpu/src/kernels/texture.rs:50
    let wrap_u = ((this_17.flags >> 1u) & 3u);
    // glimt_render_gpu/src/kernels/texture.rs:51
    let wrap_v = ((this_17.flags >> ((1u + 2u) & 31u)) & 3u);
    // glimt_render_gpu/src/kernels/texture.rs:52
    let _e21 = wrap(uv.x, wrap_u);
    let x_14 = ((_e21 * f32(this_17.width)) - 0.5f);
    // glimt_render_gpu/src/kernels/texture.rs:53
    let _e29 = wrap(uv.y, wrap_v);
    let y_5 = ((_e29 * f32(this_17.height)) - 0.5f);
    // glimt_render_gpu/src/kernels/texture.rs:54
    let _e38 = Tuple_f32_f32_(floor(x_14), floor(y_5));
    let left_2 = _e38.fa;
    let top = _e38.fb;
    // glimt_render_gpu/src/kernels/texture.rs:55
    let _e44 = neighbour(i32(left_2), this_17.width, wrap_u);
    // glimt_render_gpu/src/kernels/texture.rs:56
    let _e50 = neighbour((i32(left_2) + 1i), this_17.width, wrap_u);
    // glimt_render_gpu/src/kernels/texture.rs:57
    let _e54 = neighbour(i32(top), this_17.height, wrap_v);
    let row0_ = (_e54 * this_17.width);
    // glimt_render_gpu/src/kernels/texture.rs:58
    let _e62 = neighbour((i32(top) + 1i), this_17.height, wrap_v);
    let row1_ = (_e62 * this_17.width);
    // glimt_render_gpu/src/kernels/texture.rs:59
    let _e67 = TextureView_texel(this_17, (row0_ + _e44));
    let _e69 = TextureView_texel(this_17, (row0_ + _e50));
    let _e70 = (x_14 - left_2);
    let upper = ((_e67 * (1f - _e70)) + (_e69 * _e70));
    // glimt_render_gpu/src/kernels/texture.rs:62
    let _e78 = TextureView_texel(this_17, (row1_ + _e44));
    let _e80 = TextureView_texel(this_17, (row1_ + _e50));
    let _e81 = (x_14 - left_2);
    let lower = ((_e78 * (1f - _e81)) + (_e80 * _e81));
    // glimt_render_gpu/src/kernels/texture.rs:65
    let _e88 = (y_5 - top);
    return ((upper * (1f - _e88)) + (lower * _e88));
}

// glimt_render_gpu/src/kernels/material.rs:206
fn MaterialView_sample(words_start_2: u32, words_len_2: u32, word_3: u32, texture: TextureView, uv_1: vec2<f32>) -> vec4<f32> {
    var place_1: vec2<f32>;

    // glimt_render_gpu/src/kernels/material.rs:207
    place_1 = uv_1;
    // glimt_render_gpu/src/kernels/material.rs:208
    if ((texture.flags & 65536u) != 0u) {
        // glimt_render_gpu/src/kernels/material.rs:209
        let t_7 = (word_3 + 4u);
        // glimt_render_gpu/src/kernels/material.rs:210
        let _e18 = MaterialView_number(words_start_2, words_len_2, t_7);
        let _e21 = MaterialView_number(words_start_2, words_len_2, (t_7 + 1u));
        let _e27 = MaterialView_number(words_start_2, words_len_2, (t_7 + 2u));
        let _e30 = MaterialView_number(words_start_2, words_len_2, (t_7 + 3u));
        let _e37 = MaterialView_number(words_start_2, words_len_2, (t_7 + 4u));
        let _e40 = MaterialView_number(words_start_2, words_len_2, (t_7 + 5u));
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
fn Triangle_is_catcher(this_18: Triangle) -> bool {

    // glimt_render_gpu/src/kernels/triangle.rs:86
    return ((this_18.object & 2147483648u) != 0u);
}

// glimt_render_gpu/src/kernels/triangle.rs:71
fn Triangle_b(this_19: Triangle) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/triangle.rs:72
    return vec3<f32>(this_19.x.y, this_19.y.y, this_19.z.y);
}

// glimt_render_gpu/src/kernels/triangle.rs:64
fn Triangle_a(this_20: Triangle) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/triangle.rs:65
    return vec3<f32>(this_20.x.x, this_20.y.x, this_20.z.x);
}

// glimt_render_gpu/src/kernels/triangle.rs:78
fn Triangle_c(this_21: Triangle) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/triangle.rs:79
    return vec3<f32>(this_21.x.z, this_21.y.z, this_21.z.z);
}

// glimt_render_gpu/src/kernels/triangle.rs:140
fn Triangle_area_normal(this_22: Triangle) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/triangle.rs:141
    let _e3 = Triangle_b(this_22);
    let _e4 = Triangle_a(this_22);
    let _e6 = Triangle_c(this_22);
    let _e7 = Triangle_a(this_22);
    return cross((_e3 - _e4), (_e6 - _e7));
}

// glimt_render_gpu/src/kernels/triangle.rs:106
fn Triangle_ray_offset(this_23: Triangle) -> f32 {

    // glimt_render_gpu/src/kernels/triangle.rs:107
    let extent = max(max(abs(this_23.x), abs(this_23.y)), abs(this_23.z));
    // glimt_render_gpu/src/kernels/triangle.rs:108
    return (0.0000038146973f * max(max(max(extent.x, extent.y), extent.z), extent.w));
}

// glimt_render_gpu/src/kernels/triangle.rs:114
fn Triangle_setback(this_24: Triangle, ray_6: Ray, t: f32) -> f32 {

    // glimt_render_gpu/src/kernels/triangle.rs:115
    let _e5 = Triangle_area_normal(this_24);
    // glimt_render_gpu/src/kernels/triangle.rs:116
    let across = abs(dot(_e5, ray_6.direction));
    // glimt_render_gpu/src/kernels/triangle.rs:117
    let _e12 = Triangle_ray_offset(this_24);
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
fn Triangle_outward(this_25: Triangle) -> vec3<f32> {
    var chosen_6: vec3<f32>;

    // glimt_render_gpu/src/kernels/triangle.rs:129
    let _e3 = Triangle_area_normal(this_25);
    // glimt_render_gpu/src/kernels/triangle.rs:130
    if ((this_25.object & 536870912u) != 0u) {
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
    let t_8 = normalize(across_1);
    // glimt_render_gpu/src/kernels/material.rs:305
    let b_3 = (cross(normal, t_8) * handedness);
    // glimt_render_gpu/src/kernels/material.rs:306
    let _e30 = MaterialView_sample(words_start_4, words_len_4, 40u, _e9, uv_3);
    let bump = ((_e30.xyz * 2f) - vec3(1f));
    // glimt_render_gpu/src/kernels/material.rs:307
    let _e44 = MaterialView_number(words_start_4, words_len_4, 14u);
    let tilt = (((t_8 * bump.x) + (b_3 * bump.y)) * _e44);
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
fn ShadingFrame_from_normal(n_3: vec3<f32>) -> ShadingFrame {

    // glimt_sampling/src/math.rs:46
    let sign_ = bitcast<f32>(((bitcast<u32>(1f) & 2147483647u) | (bitcast<u32>(n_3.z) & 2147483648u)));
    // glimt_sampling/src/math.rs:47
    let a_3 = (-1f / (sign_ + n_3.z));
    // glimt_sampling/src/math.rs:48
    let c_1 = ((n_3.x * n_3.y) * a_3);
    // glimt_sampling/src/math.rs:49
    return ShadingFrame(vec3<f32>((1f + (((sign_ * n_3.x) * n_3.x) * a_3)), (sign_ * c_1), (-(sign_) * n_3.x)), vec3<f32>(c_1, (sign_ + ((n_3.y * n_3.y) * a_3)), -(n_3.y)), n_3);
}

// glimt_sampling/src/math.rs:66
fn ShadingFrame_to_local(this_26: ShadingFrame, v_4: vec3<f32>) -> vec3<f32> {

    // glimt_sampling/src/math.rs:67
    return vec3<f32>(dot(v_4, this_26.t), dot(v_4, this_26.b), dot(v_4, this_26.n));
}

// glimt_render_gpu/src/kernels/material.rs:186
fn MaterialView_vector(words_start_5: u32, words_len_5: u32, word_4: u32) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/material.rs:187
    let _e5 = MaterialView_number(words_start_5, words_len_5, word_4);
    let _e8 = MaterialView_number(words_start_5, words_len_5, (word_4 + 1u));
    let _e11 = MaterialView_number(words_start_5, words_len_5, (word_4 + 2u));
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
    let first_8 = (3u * hit.triangle);
    // glimt_render_gpu/src/kernels/scene.rs:91
    let a_4 = scene_corners[first_8];
    // glimt_render_gpu/src/kernels/scene.rs:92
    let b_4 = scene_corners[(first_8 + 1u)];
    // glimt_render_gpu/src/kernels/scene.rs:93
    let c_2 = scene_corners[(first_8 + 2u)];
    // glimt_render_gpu/src/kernels/scene.rs:94
    let _e33 = Tuple_f32_f32_(hit.barycentrics.x, hit.barycentrics.y);
    let u_8 = _e33.fa;
    let v_5 = _e33.fb;
    // glimt_render_gpu/src/kernels/scene.rs:95
    let w_4 = ((1f - u_8) - v_5);
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
    let _e63 = unit_or((((a_4.normal * w_4) + (b_4.normal * u_8)) + (c_2.normal * v_5)), outward);
    // glimt_render_gpu/src/kernels/scene.rs:103
    let uv_7 = vec2<f32>((((a_4.u * w_4) + (b_4.u * u_8)) + (c_2.u * v_5)), (((a_4.v * w_4) + (b_4.v * u_8)) + (c_2.v * v_5)));
    // glimt_render_gpu/src/kernels/scene.rs:104
    let _e86 = MaterialView_new((triangle_7.material & 2147483647u));
    // glimt_render_gpu/src/kernels/scene.rs:105
    let tangent_1 = (((a_4.tangent * w_4) + (b_4.tangent * u_8)) + (c_2.tangent * v_5));
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
        let _e128 = Attributes_at(triangle_7.attributes, u_8, v_5);
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
    let edges = (((_e135 - _e136) * u_8) + ((_e139 - _e140) * v_5));
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
fn Triangle_object_index(this_27: Triangle) -> u32 {

    // glimt_render_gpu/src/kernels/triangle.rs:93
    return (this_27.object & 536870911u);
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

// glimt_render_gpu/src/kernels/cell_state.rs:83
fn slot_of(surface: u32, first_3: u32) -> u32 {
    var slot: u32;
    var counter_5: u32;

    // glimt_render_gpu/src/kernels/cell_state.rs:84
    slot = 0u;
    // glimt_render_gpu/src/kernels/cell_state.rs:85
    counter_5 = 0u;
    loop {
        let i_2 = counter_5;
        if (i_2 >= 3u) {
            break;
        }
        // glimt_render_gpu/src/kernels/cell_state.rs:86
        let own_1 = entries[(first_3 + i_2)].surface;
        // glimt_render_gpu/src/kernels/cell_state.rs:88
        let _e19 = slot;
        if ((_e19 == 0u) && ((own_1 == surface) || ((i_2 == (3u - 1u)) && (own_1 != 0u)))) {
            // glimt_render_gpu/src/kernels/cell_state.rs:89
            slot = (i_2 + 1u);
        }
        continuing {
            let _e35 = counter_5;
            counter_5 = (_e35 + 1u);
        }
    }
    // glimt_render_gpu/src/kernels/cell_state.rs:92
    let _e39 = slot;
    return _e39;
}

// glimt_render_gpu/src/kernels/seen.rs:78
fn SeenPoint_is_hit(this_28: SeenPoint) -> bool {

    // glimt_render_gpu/src/kernels/seen.rs:79
    return (this_28.surface != 0u);
}

// glimt_render_gpu/src/kernels/seen.rs:99
fn SeenPoint_shading_point(this_29: SeenPoint) -> ShadingPoint {

    // glimt_render_gpu/src/kernels/seen.rs:100
    let _e4 = ShadingFrame_from_normal(this_29.normal);
    // glimt_render_gpu/src/kernels/seen.rs:101
    let _e9 = ShadingFrame_to_local(_e4, this_29.wo);
    return ShadingPoint(this_29.origin, this_29.geometric_normal, _e4, _e9, BlinnPhong(this_29.diffuse, this_29.specular, this_29.exponent), this_29.emission);
}

// glimt_sampling/src/math.rs:16
fn luminance(rgb: vec3<f32>) -> f32 {

    // glimt_sampling/src/math.rs:17
    return (((0.2126f * rgb.x) + (0.7152f * rgb.y)) + (0.0722f * rgb.z));
}

// glimt_probe/src/rotate.rs:33
fn rotate_z(d: vec3<f32>, cos_sin: vec2<f32>) -> vec3<f32> {

    // glimt_probe/src/rotate.rs:34
    return vec3<f32>(((d.x * cos_sin.x) - (d.y * cos_sin.y)), ((d.x * cos_sin.y) + (d.y * cos_sin.x)), d.z);
}

// glimt_render_gpu/src/kernels/environment.rs:89
fn Environment_to_map(size_3: vec2<u32>, rotation_1: vec2<f32>, direction_1: vec3<f32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/environment.rs:90
    let _e8 = rotate_z(direction_1, vec2<f32>(rotation_1.x, -(rotation_1.y)));
    return _e8;
}

// glimt_brdf/src/lobe.rs:86
fn normalisation(exponent: f32) -> f32 {

    // glimt_brdf/src/lobe.rs:87
    let tail = exp2(max((-0.5f * exponent), -60f));
    // glimt_brdf/src/lobe.rs:88
    return ((((exponent + 2f) * (exponent + 4f)) * (0.125f * 0.31830987f)) / (tail + exponent));
}

// glimt_light_cells/src/surface.rs:105
fn CellSurface_new(normal_2: vec3<f32>, wo: vec3<f32>, kd: f32, ks: f32, exponent_1: f32, mean_length: f32, horizon: f32) -> CellSurface {

    // glimt_light_cells/src/surface.rs:115
    let r_2 = clamp(mean_length, 0.001f, 1f);
    // glimt_light_cells/src/surface.rs:116
    let widened = ((exponent_1 * r_2) / (r_2 + (exponent_1 * (1f - r_2))));
    // glimt_light_cells/src/surface.rs:117
    let _e22 = normalisation(widened);
    return CellSurface(normal_2, wo, (kd * 0.31830987f), ks, widened, _e22, sqrt((2f * (1f - r_2))), horizon, 1f);
}

// glimt_render_gpu/src/kernels/groups.rs:47
fn Representative_alone(normal_3: vec3<f32>, wo_1: vec3<f32>, diffuse: f32, specular: f32, exponent_2: f32, env_size: vec2<u32>, env_rotation: vec2<f32>) -> Representative {

    // glimt_render_gpu/src/kernels/groups.rs:55
    let _e9 = Environment_to_map(env_size, env_rotation, normal_3);
    let _e10 = Environment_to_map(env_size, env_rotation, wo_1);
    let _e11 = Tuple_Vec3_Vec3_(_e9, _e10);
    let normal_7 = _e11.fa;
    let wo_2 = _e11.fb;
    // glimt_render_gpu/src/kernels/groups.rs:56
    let _e17 = CellSurface_new(normal_7, wo_2, diffuse, specular, exponent_2, 1f, 0f);
    // glimt_render_gpu/src/kernels/groups.rs:57
    return Representative(normal_7, vec3(diffuse), vec3(specular), exponent_2, _e17.peak, _e17);
}

// glimt_render_gpu/src/kernels/seen.rs:85
fn SeenPoint_is_catcher(this_30: SeenPoint) -> bool {

    // glimt_render_gpu/src/kernels/seen.rs:86
    return ((this_30.flags & 2u) != 0u);
}

// glimt_light_cells/src/partition.rs:114
fn LightCells_quad(size_4: vec2<u32>, start: u32, list: u32, quad: u32) -> vec4<f32> {

    // glimt_light_cells/src/partition.rs:115
    let at_3 = (((start + 32u) + (list * 512u)) + (4u * quad));
    // glimt_light_cells/src/partition.rs:116
    let _e16 = env_tables[at_3];
    let _e22 = env_tables[(at_3 + 1u)];
    let _e28 = env_tables[(at_3 + 2u)];
    let _e34 = env_tables[(at_3 + 3u)];
    return vec4<f32>(bitcast<f32>(_e16), bitcast<f32>(_e22), bitcast<f32>(_e28), bitcast<f32>(_e34));
}

// glimt_light_cells/src/surface.rs:52
fn step_(x_7: vec4<f32>) -> vec4<f32> {

    // glimt_light_cells/src/surface.rs:54
    return clamp((x_7 * 1000000000000000000000000000000f), vec4(0f), vec4(1f));
}

// glimt_light_cells/src/surface.rs:59
fn sqrt_(x_8: vec4<f32>) -> vec4<f32> {

    // glimt_light_cells/src/surface.rs:60
    return vec4<f32>(sqrt(x_8.x), sqrt(x_8.y), sqrt(x_8.z), sqrt(x_8.w));
}

// glimt_light_cells/src/surface.rs:82
fn cosine_power4_(sin2_theta: vec4<f32>, exponent_3: vec4<f32>) -> vec4<f32> {

    // glimt_light_cells/src/surface.rs:84
    let s_3 = clamp(sin2_theta, vec4(0f), vec4(1f));
    // glimt_light_cells/src/surface.rs:85
    let log_ = ((s_3 * (vec4(6f) - s_3)) / (vec4(12f) - (8f * s_3)));
    // glimt_light_cells/src/surface.rs:86
    let t_9 = (min((exponent_3 * log_), vec4(40f)) * (1f / 256f));
    // glimt_light_cells/src/surface.rs:88
    let x_15 = (vec4(1f) - (t_9 * (vec4(1f) - (t_9 * (vec4(0.5f) - (t_9 * (1f / 6f)))))));
    // glimt_light_cells/src/surface.rs:89
    let x2_1 = (x_15 * x_15);
    // glimt_light_cells/src/surface.rs:90
    let x4_ = (x2_1 * x2_1);
    // glimt_light_cells/src/surface.rs:91
    let x8_ = (x4_ * x4_);
    // glimt_light_cells/src/surface.rs:92
    let x16_ = (x8_ * x8_);
    // glimt_light_cells/src/surface.rs:93
    let x32_ = (x16_ * x16_);
    // glimt_light_cells/src/surface.rs:94
    let x64_ = (x32_ * x32_);
    // glimt_light_cells/src/surface.rs:95
    let x128_ = (x64_ * x64_);
    // glimt_light_cells/src/surface.rs:96
    return (x128_ * x128_);
}

// glimt_light_cells/src/surface.rs:173
fn LightCells_terms(size_5: vec2<u32>, start_1: u32, surface_1: CellSurface, quad_1: u32) -> CellTerms {

    // glimt_light_cells/src/surface.rs:174
    let _e7 = LightCells_quad(size_5, start_1, 15u, quad_1);
    // glimt_light_cells/src/surface.rs:175
    let _e12 = LightCells_quad(size_5, start_1, (15u + 1u), quad_1);
    // glimt_light_cells/src/surface.rs:176
    let _e17 = LightCells_quad(size_5, start_1, (15u + 2u), quad_1);
    // glimt_light_cells/src/surface.rs:177
    let _e20 = LightCells_quad(size_5, start_1, 18u, quad_1);
    // glimt_light_cells/src/surface.rs:178
    let _e23 = LightCells_quad(size_5, start_1, 19u, quad_1);
    // glimt_light_cells/src/surface.rs:179
    let n_5 = surface_1.normal;
    // glimt_light_cells/src/surface.rs:180
    let c_3 = (((_e7 * n_5.x) + (_e12 * n_5.y)) + (_e17 * n_5.z));
    // glimt_light_cells/src/surface.rs:181
    let reach_3 = (_e20 + vec4(surface_1.horizon));
    // glimt_light_cells/src/surface.rs:182
    let up = max((c_3 + reach_3), vec4(0f));
    // glimt_light_cells/src/surface.rs:183
    let _e45 = step_(up);
    // glimt_light_cells/src/surface.rs:184
    let _e48 = step_((c_3 - reach_3));
    // glimt_light_cells/src/surface.rs:185
    let cosine_1 = max(c_3, vec4(0f));
    // glimt_light_cells/src/surface.rs:186
    let half_spread = vec4((0.5f * surface_1.spread));
    // glimt_light_cells/src/surface.rs:187
    let cosine_spread = ((_e48 * half_spread) + ((vec4(1f) - _e48) * (0.35f * min(up, (2f * _e23)))));
    // glimt_light_cells/src/surface.rs:188
    if !((surface_1.specular > 0f)) {
        // glimt_light_cells/src/surface.rs:189
        return CellTerms(cosine_1, _e48, _e45, vec4(0f), vec4(0f), cosine_spread);
    }
    // glimt_light_cells/src/surface.rs:199
    let lifted = max(c_3, (0.25f * up));
    // glimt_light_cells/src/surface.rs:200
    let v_6 = surface_1.wo;
    // glimt_light_cells/src/surface.rs:201
    let nv = dot(n_5, v_6);
    // glimt_light_cells/src/surface.rs:202
    let dv = ((((_e7 * v_6.x) + (_e12 * v_6.y)) + (_e17 * v_6.z)) + ((lifted - c_3) * nv));
    // glimt_light_cells/src/surface.rs:203
    let _e111 = sqrt_(max(((vec4(1f) + (lifted * lifted)) - (c_3 * c_3)), vec4(0.000001f)));
    // glimt_light_cells/src/surface.rs:204
    let half2_ = max((vec4(2f) + ((2f * dv) / _e111)), vec4(0.000001f));
    // glimt_light_cells/src/surface.rs:205
    let _e129 = sqrt_(half2_);
    let nh = (max((vec4(nv) + (lifted / _e111)), vec4(0f)) / _e129);
    // glimt_light_cells/src/surface.rs:206
    let cos2_ = min((nh * nh), vec4(1f));
    // glimt_light_cells/src/surface.rs:207
    let sin2_ = (vec4(1f) - cos2_);
    // glimt_light_cells/src/surface.rs:208
    let r2_ = (_e23 * _e23);
    // glimt_light_cells/src/surface.rs:209
    let e = max(surface_1.exponent, 0.001f);
    // glimt_light_cells/src/surface.rs:210
    let seen_2 = (vec4(4f) / (vec4((4f / e)) + (0.7f * r2_)));
    // glimt_light_cells/src/surface.rs:211
    let _e157 = cosine_power4_(sin2_, seen_2);
    let lobe = (((_e157 * seen_2) * (lifted * _e45)) * ((surface_1.share * surface_1.peak) / e));
    // glimt_light_cells/src/surface.rs:213
    let _e171 = sqrt_((sin2_ / max(cos2_, vec4(0.0001f))));
    // glimt_light_cells/src/surface.rs:214
    let near = (vec4((((0.1f * e) * surface_1.spread) * surface_1.spread)) + ((0.06f * e) * r2_));
    // glimt_light_cells/src/surface.rs:215
    let slope_1 = (((0.5f * e) * _e171) * ((0.5f * _e23) + half_spread));
    // glimt_light_cells/src/surface.rs:216
    return CellTerms(cosine_1, _e48, _e45, lobe, min((slope_1 + near), vec4(1f)), cosine_spread);
}

// glimt_render_gpu/src/kernels/cell_state.rs:98
fn bytes_of(word_5: u32) -> vec4<f32> {

    // glimt_render_gpu/src/kernels/cell_state.rs:99
    return vec4<f32>(f32((word_5 & 255u)), f32(((word_5 >> 8u) & 255u)), f32(((word_5 >> 16u) & 255u)), f32((word_5 >> 24u)));
}

// glimt_render_gpu/src/kernels/cell_state.rs:119
fn quad_counts(first_4: u32, second: u32) -> QuadCounts {

    // glimt_render_gpu/src/kernels/cell_state.rs:120
    let _e4 = bytes_of(first_4);
    let _e5 = bytes_of(second);
    let _e6 = Tuple_Vec4_Vec4_(_e4, _e5);
    let low_1 = _e6.fa;
    let high_1 = _e6.fb;
    // glimt_render_gpu/src/kernels/cell_state.rs:121
    return QuadCounts(vec4<f32>(low_1.x, low_1.z, high_1.x, high_1.z), vec4<f32>(low_1.y, low_1.w, high_1.y, high_1.w));
}

// glimt_render_gpu/src/kernels/cell_state.rs:191
fn Remembered_counts(from_2: u32, turned_3: u32, quad_2: u32) -> QuadCounts {

    // glimt_render_gpu/src/kernels/cell_state.rs:192
    let _e7 = Remembered_word(from_2, turned_3, (2u * quad_2));
    let _e12 = Remembered_word(from_2, turned_3, ((2u * quad_2) + 1u));
    let _e13 = quad_counts(_e7, _e12);
    return _e13;
}

// glimt_render_gpu/src/kernels/cell_state.rs:219
fn Remembered_quad(from_3: u32, turned_4: u32, quad_3: u32) -> vec4<f32> {

    // glimt_render_gpu/src/kernels/cell_state.rs:220
    let _e5 = Remembered_counts(from_3, turned_4, quad_3);
    // glimt_render_gpu/src/kernels/cell_state.rs:221
    return ((_e5.arrived + vec4((4f * 0.75f))) / (_e5.rays + vec4(4f)));
}

// glimt_light_cells/src/surface.rs:162
fn CellSurface_shape_variance(this_31: CellSurface, terms: CellTerms) -> vec4<f32> {

    // glimt_light_cells/src/surface.rs:163
    let diffuse_1 = (terms.cosine_spread * this_31.diffuse);
    // glimt_light_cells/src/surface.rs:164
    let lobe_1 = ((terms.lobe * terms.lobe_spread) * this_31.specular);
    // glimt_light_cells/src/surface.rs:165
    return ((diffuse_1 * diffuse_1) + (lobe_1 * lobe_1));
}

// glimt_light_cells/src/surface.rs:153
fn CellSurface_blocked_weights(this_32: CellSurface, terms_1: CellTerms, flux: vec4<f32>, visibility: vec4<f32>) -> vec4<f32> {

    // glimt_light_cells/src/surface.rs:154
    let reflected = ((terms_1.cosine * this_32.diffuse) + (terms_1.lobe * this_32.specular));
    // glimt_light_cells/src/surface.rs:155
    let blocked = ((vec4(1f) - (visibility * visibility)) + vec4(0.0002f));
    // glimt_light_cells/src/surface.rs:156
    let _e22 = CellSurface_shape_variance(this_32, terms_1);
    // glimt_light_cells/src/surface.rs:157
    let _e29 = sqrt_((((reflected * reflected) * blocked) + _e22));
    return ((flux * terms_1.live) * _e29);
}

// glimt_light_cells/src/surface.rs:142
fn CellSurface_residual_weights(this_33: CellSurface, terms_2: CellTerms, flux_1: vec4<f32>, visibility_1: vec4<f32>) -> vec4<f32> {

    // glimt_light_cells/src/surface.rs:143
    let reflected_1 = ((terms_2.cosine * this_33.diffuse) + (terms_2.lobe * this_33.specular));
    // glimt_light_cells/src/surface.rs:144
    let by_visibility = ((visibility_1 * (vec4(1f) - visibility_1)) + vec4(0.0002f));
    // glimt_light_cells/src/surface.rs:145
    let _e22 = CellSurface_shape_variance(this_33, terms_2);
    let by_shape = (_e22 * max(visibility_1, vec4(0.02f)));
    // glimt_light_cells/src/surface.rs:146
    let _e33 = sqrt_((((reflected_1 * reflected_1) * by_visibility) + by_shape));
    return ((flux_1 * terms_2.live) * _e33);
}

// glimt_light_cells/src/surface.rs:133
fn CellSurface_product_weights(this_34: CellSurface, terms_3: CellTerms, flux_2: vec4<f32>) -> vec4<f32> {

    // glimt_light_cells/src/surface.rs:134
    let reflected_2 = ((terms_3.cosine * this_34.diffuse) + (terms_3.lobe * this_34.specular));
    // glimt_light_cells/src/surface.rs:135
    return ((flux_2 * terms_3.live) * (reflected_2 + (terms_3.cosine_spread * this_34.diffuse)));
}

// glimt_render_gpu/src/kernels/proposal.rs:256
fn weights(surface_2: CellSurface, terms_4: CellTerms, flux_3: vec4<f32>, visibility_2: vec4<f32>, is_catcher: bool) -> vec4<f32> {
    var chosen_13: vec4<f32>;
    var chosen_14: vec4<f32>;

    // glimt_render_gpu/src/kernels/proposal.rs:263
    if (true && is_catcher) {
        // glimt_render_gpu/src/kernels/proposal.rs:264
        let _e11 = CellSurface_blocked_weights(surface_2, terms_4, flux_3, visibility_2);
        chosen_13 = _e11;
    } else {
        if true {
            // glimt_render_gpu/src/kernels/proposal.rs:266
            let _e15 = CellSurface_residual_weights(surface_2, terms_4, flux_3, visibility_2);
            chosen_14 = _e15;
        } else {
            // glimt_render_gpu/src/kernels/proposal.rs:268
            let _e17 = CellSurface_product_weights(surface_2, terms_4, flux_3);
            chosen_14 = _e17;
        }
        let _e18 = chosen_14;
        chosen_13 = _e18;
    }
    let _e19 = chosen_13;
    return _e19;
}

// glimt_render_gpu/src/kernels/proposal.rs:154
fn channel_sum(cells_size: vec2<u32>, cells_start: u32, quad_4: u32, channel: u32, normal_4: vec3<f32>, full: vec4<f32>, cut: vec4<f32>) -> f32 {

    // glimt_render_gpu/src/kernels/proposal.rs:162
    let list_1 = (4u + (3u * channel));
    // glimt_render_gpu/src/kernels/proposal.rs:163
    let _e14 = LightCells_quad(cells_size, cells_start, list_1, quad_4);
    let _e19 = LightCells_quad(cells_size, cells_start, (list_1 + 1u), quad_4);
    let _e25 = LightCells_quad(cells_size, cells_start, (list_1 + 2u), quad_4);
    let moment = (((_e14 * normal_4.x) + (_e19 * normal_4.y)) + (_e25 * normal_4.z));
    // glimt_render_gpu/src/kernels/proposal.rs:166
    let _e32 = LightCells_quad(cells_size, cells_start, (1u + channel), quad_4);
    // glimt_render_gpu/src/kernels/proposal.rs:167
    let _e36 = ((full * moment) + (cut * _e32));
    return (((_e36.x + _e36.y) + _e36.z) + _e36.w);
}

// glimt_render_gpu/src/kernels/proposal.rs:172
fn diffuse_sum(cells_size_1: vec2<u32>, cells_start_1: u32, quad_5: u32, normal_5: vec3<f32>, full_1: vec4<f32>, cut_1: vec4<f32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/proposal.rs:173
    let _e9 = channel_sum(cells_size_1, cells_start_1, quad_5, 0u, normal_5, full_1, cut_1);
    let _e11 = channel_sum(cells_size_1, cells_start_1, quad_5, 1u, normal_5, full_1, cut_1);
    let _e13 = channel_sum(cells_size_1, cells_start_1, quad_5, 2u, normal_5, full_1, cut_1);
    return vec3<f32>(_e9, _e11, _e13);
}

// glimt_render_gpu/src/kernels/proposal.rs:182
fn radiance_sum(cells_size_2: vec2<u32>, cells_start_2: u32, quad_6: u32, factors: vec4<f32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/proposal.rs:183
    let _e7 = LightCells_quad(cells_size_2, cells_start_2, 1u, quad_6);
    let _e8 = (_e7 * factors);
    let _e19 = LightCells_quad(cells_size_2, cells_start_2, (1u + 1u), quad_6);
    let _e20 = (_e19 * factors);
    let _e31 = LightCells_quad(cells_size_2, cells_start_2, (1u + 2u), quad_6);
    let _e32 = (_e31 * factors);
    return vec3<f32>((((_e8.x + _e8.y) + _e8.z) + _e8.w), (((_e20.x + _e20.y) + _e20.z) + _e20.w), (((_e32.x + _e32.y) + _e32.z) + _e32.w));
}

// glimt_render_gpu/src/kernels/proposal.rs:191
fn weigh(of_: Representative, cells_size_3: vec2<u32>, cells_start_3: u32, expected_from: u32, expected_turned: u32, is_catcher_1: bool) -> Totals {
    var t_4: Totals;
    var counter_6: u32;

    // glimt_render_gpu/src/kernels/proposal.rs:197
    let surface_4 = of_.surface;
    // glimt_render_gpu/src/kernels/proposal.rs:198
    let has_lobe = (surface_4.specular > 0f);
    // glimt_render_gpu/src/kernels/proposal.rs:199
    t_4 = Totals(array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f), array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f), 0f, 0f, 0f, 0f, 0f, 0f, 0f, vec3(0f), vec3(0f), vec3(0f), vec3(0f));
    // glimt_render_gpu/src/kernels/proposal.rs:214
    counter_6 = 0u;
    loop {
        let quad_7 = counter_6;
        if (quad_7 >= 128u) {
            break;
        }
        // glimt_render_gpu/src/kernels/proposal.rs:215
        let _e43 = LightCells_quad(cells_size_3, cells_start_3, 0u, quad_7);
        // glimt_render_gpu/src/kernels/proposal.rs:216
        let _e45 = LightCells_terms(cells_size_3, cells_start_3, surface_4, quad_7);
        // glimt_render_gpu/src/kernels/proposal.rs:217
        let _e48 = (_e43 * _e45.live);
        let live = (((_e48.x + _e48.y) + _e48.z) + _e48.w);
        // glimt_render_gpu/src/kernels/proposal.rs:219
        if (live > 0f) {
            // glimt_render_gpu/src/kernels/proposal.rs:220
            let _e60 = Remembered_quad(expected_from, expected_turned, quad_7);
            // glimt_render_gpu/src/kernels/proposal.rs:221
            let _e62 = weights(surface_4, _e45, _e43, _e60, is_catcher_1);
            // glimt_render_gpu/src/kernels/proposal.rs:222
            let weight_1 = (((_e62.x + _e62.y) + _e62.z) + _e62.w);
            // glimt_render_gpu/src/kernels/proposal.rs:223
            if true {
                // glimt_render_gpu/src/kernels/proposal.rs:224
                let full_2 = (_e45.full * _e60);
                // glimt_render_gpu/src/kernels/proposal.rs:225
                let cut_2 = ((_e60 - full_2) * _e45.cosine);
                // glimt_render_gpu/src/kernels/proposal.rs:226
                let _e83 = diffuse_sum(cells_size_3, cells_start_3, quad_7, of_.mean_normal, full_2, cut_2);
                let _e84 = t_4.diffuse;
                t_4.diffuse = (_e84 + _e83);
                // glimt_render_gpu/src/kernels/proposal.rs:227
                if is_catcher_1 {
                    // glimt_render_gpu/src/kernels/proposal.rs:228
                    let cut_3 = ((vec4(1f) - _e45.full) * _e45.cosine);
                    // glimt_render_gpu/src/kernels/proposal.rs:229
                    let _e97 = diffuse_sum(cells_size_3, cells_start_3, quad_7, of_.mean_normal, _e45.full, cut_3);
                    // glimt_render_gpu/src/kernels/proposal.rs:230
                    let _e100 = t_4.open_diffuse;
                    t_4.open_diffuse = (_e100 + _e97);
                    // glimt_render_gpu/src/kernels/proposal.rs:231
                    let _e105 = radiance_sum(cells_size_3, cells_start_3, quad_7, _e45.lobe);
                    let _e106 = t_4.open_specular;
                    t_4.open_specular = (_e106 + _e105);
                }
            }
            // glimt_render_gpu/src/kernels/proposal.rs:234
            if has_lobe {
                // glimt_render_gpu/src/kernels/proposal.rs:235
                let a_5 = (_e45.lobe * _e43);
                // glimt_render_gpu/src/kernels/proposal.rs:236
                let spread = ((a_5 * _e45.lobe_spread) * _e45.lobe_spread);
                // glimt_render_gpu/src/kernels/proposal.rs:237
                let _e126 = t_4.lobe;
                t_4.lobe = (_e126 + (((a_5.x + a_5.y) + a_5.z) + a_5.w));
                // glimt_render_gpu/src/kernels/proposal.rs:238
                let _e137 = t_4.lobe_spread;
                t_4.lobe_spread = (_e137 + (((spread.x + spread.y) + spread.z) + spread.w));
                // glimt_render_gpu/src/kernels/proposal.rs:239
                let _e140 = (a_5 * _e60);
                let _e149 = t_4.lobe_visible;
                t_4.lobe_visible = (_e149 + (((_e140.x + _e140.y) + _e140.z) + _e140.w));
                // glimt_render_gpu/src/kernels/proposal.rs:240
                let _e154 = LightCells_quad(cells_size_3, cells_start_3, 13u, quad_7);
                let _e155 = (_e45.lobe * _e154);
                let _e164 = t_4.lobe_square;
                t_4.lobe_square = (_e164 + (((_e155.x + _e155.y) + _e155.z) + _e155.w));
                // glimt_render_gpu/src/kernels/proposal.rs:241
                let _e169 = LightCells_quad(cells_size_3, cells_start_3, 14u, quad_7);
                let _e170 = (_e45.lobe * _e169);
                let _e179 = t_4.lobe_area;
                t_4.lobe_area = (_e179 + (((_e170.x + _e170.y) + _e170.z) + _e170.w));
                // glimt_render_gpu/src/kernels/proposal.rs:242
                if true {
                    // glimt_render_gpu/src/kernels/proposal.rs:243
                    let _e187 = radiance_sum(cells_size_3, cells_start_3, quad_7, (_e45.lobe * _e60));
                    let _e188 = t_4.specular;
                    t_4.specular = (_e188 + _e187);
                }
            }
            // glimt_render_gpu/src/kernels/proposal.rs:246
            t_4.quads[quad_7] = weight_1;
            // glimt_render_gpu/src/kernels/proposal.rs:247
            t_4.lives[quad_7] = live;
            // glimt_render_gpu/src/kernels/proposal.rs:248
            let _e198 = t_4.weight;
            t_4.weight = (_e198 + weight_1);
            // glimt_render_gpu/src/kernels/proposal.rs:249
            let _e202 = t_4.live;
            t_4.live = (_e202 + live);
        }
        continuing {
            let _e204 = counter_6;
            counter_6 = (_e204 + 1u);
        }
    }
    // glimt_render_gpu/src/kernels/proposal.rs:252
    let _e208 = t_4;
    return _e208;
}

// glimt_render_gpu/src/kernels/proposal.rs:275
fn worth(a_2: f32, visible: f32, variance: f32) -> f32 {

    // glimt_render_gpu/src/kernels/proposal.rs:276
    if true {
        // glimt_render_gpu/src/kernels/proposal.rs:277
        return (a_2 * sqrt(((visible * (1f - visible)) + (visible * variance))));
    }
    // glimt_render_gpu/src/kernels/proposal.rs:280
    return (a_2 * sqrt((1f + (2f * variance))));
}

// glimt_render_gpu/src/kernels/proposal.rs:285
fn is_sharp(surface_3: CellSurface) -> bool {

    // glimt_render_gpu/src/kernels/proposal.rs:286
    let is_flat = (dot(surface_3.normal, surface_3.wo) < 0.3f);
    // glimt_render_gpu/src/kernels/proposal.rs:287
    return ((surface_3.specular > 0f) && (is_flat || (surface_3.exponent > 40f)));
}

// glimt_render_gpu/src/kernels/proposal.rs:294
fn Proposal_new(of_1: Representative, cells_size_4: vec2<u32>, cells_start_4: u32, expected_from_1: u32, expected_turned_1: u32, is_catcher_2: bool) -> Proposal {
    var of_2: Representative;
    var sums: Totals;
    var first_5: Totals;
    var lobe_worth: f32;
    var least_share: f32;
    var share: f32;
    var defence: f32;
    var total: f32;
    var quads: array<f32, 128>;
    var rows: array<f32, 16>;
    var counter_7: u32;
    var of_row: f32;
    var counter_8: u32;
    var lobe_share: f32;

    // glimt_render_gpu/src/kernels/proposal.rs:300
    of_2 = of_1;
    // glimt_render_gpu/src/kernels/proposal.rs:301
    let _e10 = of_2;
    let _e11 = weigh(_e10, cells_size_4, cells_start_4, expected_from_1, expected_turned_1, is_catcher_2);
    sums = _e11;
    // glimt_render_gpu/src/kernels/proposal.rs:302
    let _e14 = sums;
    first_5 = _e14;
    // glimt_render_gpu/src/kernels/proposal.rs:303
    lobe_worth = 0f;
    // glimt_render_gpu/src/kernels/proposal.rs:304
    least_share = 0f;
    // glimt_render_gpu/src/kernels/proposal.rs:305
    share = 1f;
    // glimt_render_gpu/src/kernels/proposal.rs:306
    let _e28 = of_2.surface.specular;
    let _e32 = sums.lobe;
    if ((_e28 > 0f) && (_e32 > 0f)) {
        // glimt_render_gpu/src/kernels/proposal.rs:308
        let _e38 = sums.lobe_spread;
        let _e40 = sums.lobe;
        let by_cells = (_e38 / _e40);
        // glimt_render_gpu/src/kernels/proposal.rs:309
        let _e44 = sums.lobe_square;
        let _e46 = sums.lobe;
        let _e49 = sums.lobe_area;
        let _e51 = sums.lobe;
        let by_lobe = clamp((((_e44 / _e46) * (_e49 / _e51)) - 1f), 0.0001f, 1000000f);
        // glimt_render_gpu/src/kernels/proposal.rs:311
        share = (by_lobe / (by_lobe + by_cells));
        // glimt_render_gpu/src/kernels/proposal.rs:312
        let _e63 = share;
        if (_e63 > 0.9f) {
            // glimt_render_gpu/src/kernels/proposal.rs:313
            share = 1f;
        } else {
            let _e68 = share;
            if (_e68 < 0.1f) {
                // glimt_render_gpu/src/kernels/proposal.rs:315
                share = 0f;
            }
        }
        // glimt_render_gpu/src/kernels/proposal.rs:317
        let _e75 = sums.lobe;
        let _e78 = of_2.surface.specular;
        let a_6 = (_e75 * _e78);
        // glimt_render_gpu/src/kernels/proposal.rs:318
        let _e82 = sums.lobe_visible;
        let _e84 = sums.lobe;
        let visible_1 = min((_e82 / _e84), 1f);
        // glimt_render_gpu/src/kernels/proposal.rs:319
        let _e89 = share;
        if (_e89 < 1f) {
            // glimt_render_gpu/src/kernels/proposal.rs:320
            let _e94 = share;
            let _e96 = worth(a_6, visible_1, by_lobe);
            lobe_worth = ((1f - _e94) * _e96);
            // glimt_render_gpu/src/kernels/proposal.rs:321
            let _e99 = share;
            of_2.surface.share = _e99;
            // glimt_render_gpu/src/kernels/proposal.rs:322
            let _e103 = of_2;
            let _e104 = weigh(_e103, cells_size_4, cells_start_4, expected_from_1, expected_turned_1, is_catcher_2);
            sums = _e104;
        }
    }
    // glimt_render_gpu/src/kernels/proposal.rs:325
    let _e107 = of_2.surface;
    let _e108 = is_sharp(_e107);
    if _e108 {
        // glimt_render_gpu/src/kernels/proposal.rs:326
        least_share = 0.2f;
    }
    // glimt_render_gpu/src/kernels/proposal.rs:328
    defence = 0f;
    // glimt_render_gpu/src/kernels/proposal.rs:329
    let _e116 = sums.live;
    if (_e116 > 0f) {
        // glimt_render_gpu/src/kernels/proposal.rs:330
        let _e122 = sums.weight;
        let _e125 = sums.live;
        defence = ((0.001f * _e122) / _e125);
    }
    // glimt_render_gpu/src/kernels/proposal.rs:332
    total = 0f;
    // glimt_render_gpu/src/kernels/proposal.rs:333
    quads = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
    // glimt_render_gpu/src/kernels/proposal.rs:334
    rows = array<f32, 16>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
    // glimt_render_gpu/src/kernels/proposal.rs:335
    counter_7 = 0u;
    loop {
        let row_2 = counter_7;
        if (row_2 >= 16u) {
            break;
        }
        // glimt_render_gpu/src/kernels/proposal.rs:336
        of_row = 0f;
        // glimt_render_gpu/src/kernels/proposal.rs:337
        counter_8 = (row_2 * 8u);
        loop {
            let quad_8 = counter_8;
            if (quad_8 >= ((row_2 + 1u) * 8u)) {
                break;
            }
            // glimt_render_gpu/src/kernels/proposal.rs:338
            let _e160 = sums.quads[quad_8];
            let _e161 = defence;
            let _e164 = sums.lives[quad_8];
            let weight_2 = (_e160 + (_e161 * _e164));
            // glimt_render_gpu/src/kernels/proposal.rs:339
            quads[quad_8] = weight_2;
            // glimt_render_gpu/src/kernels/proposal.rs:340
            let _e170 = of_row;
            of_row = (_e170 + weight_2);
            continuing {
                let _e172 = counter_8;
                counter_8 = (_e172 + 1u);
            }
        }
        // glimt_render_gpu/src/kernels/proposal.rs:342
        let _e176 = of_row;
        rows[row_2] = _e176;
        // glimt_render_gpu/src/kernels/proposal.rs:343
        let _e179 = of_row;
        let _e180 = total;
        total = (_e180 + _e179);
        continuing {
            let _e182 = counter_7;
            counter_7 = (_e182 + 1u);
        }
    }
    // glimt_render_gpu/src/kernels/proposal.rs:345
    let _e186 = total;
    let _e187 = lobe_worth;
    let all_ = (_e186 + _e187);
    // glimt_render_gpu/src/kernels/proposal.rs:346
    lobe_share = 0f;
    // glimt_render_gpu/src/kernels/proposal.rs:347
    if (all_ > 0f) {
        // glimt_render_gpu/src/kernels/proposal.rs:348
        let _e196 = lobe_worth;
        let _e198 = least_share;
        lobe_share = clamp((_e196 / all_), _e198, 0.95f);
        // glimt_render_gpu/src/kernels/proposal.rs:349
        let _e202 = total;
        if !((_e202 > 0f)) {
            // glimt_render_gpu/src/kernels/proposal.rs:350
            lobe_share = 1f;
        }
    }
    // glimt_render_gpu/src/kernels/proposal.rs:353
    let _e210 = of_2.diffuse;
    let kd_1 = (_e210 * 0.31830987f);
    // glimt_render_gpu/src/kernels/proposal.rs:354
    let _e215 = first_5.diffuse;
    let _e218 = of_2.specular;
    let _e220 = first_5.specular;
    let _e221 = share;
    let _e226 = first_5.open_diffuse;
    let _e229 = of_2.specular;
    let _e231 = first_5.open_specular;
    let _e232 = share;
    let _e236 = of_2;
    let _e237 = quads;
    let _e238 = rows;
    let _e239 = total;
    let _e240 = defence;
    let _e241 = lobe_worth;
    let _e242 = lobe_share;
    return Proposal(_e236, _e237, _e238, _e239, _e240, _e241, _e242, ((kd_1 * _e215) + (_e218 * (_e220 * _e221))), ((kd_1 * _e226) + (_e229 * (_e231 * _e232))), is_catcher_2);
}

// glimt_render_gpu/src/kernels/pattern.rs:105
fn PixelPattern_point(this_35: PixelPattern, purpose_5: u32, index_15: u32) -> PatternSource {

    // glimt_render_gpu/src/kernels/pattern.rs:106
    let _e8 = PixelPattern_sobol_point(this_35, purpose_5, index_15);
    let _e9 = PixelPattern_generator(this_35, purpose_5, index_15);
    return PatternSource((this_35.kind == 0u), _e8, _e9);
}

// glimt_render_gpu/src/kernels/pattern.rs:180
fn PatternSource_next_uvec2_(this_36: ptr<function, PatternSource>) -> vec2<u32> {
    var chosen_15: vec2<u32>;
    var borrowed_2: OwenSobol;
    var borrowed_3: Xoshiro128PlusPlus;

    // glimt_render_gpu/src/kernels/pattern.rs:181
    let _e5 = (*this_36).is_sobol;
    if _e5 {
        // glimt_render_gpu/src/kernels/pattern.rs:182
        let _e9 = (*this_36).point;
        borrowed_2 = _e9;
        let _e10 = OwenSobol_next_uvec2_((&borrowed_2));
        let _e11 = borrowed_2;
        (*this_36).point = _e11;
        chosen_15 = _e10;
    } else {
        // glimt_render_gpu/src/kernels/pattern.rs:184
        let _e15 = (*this_36).generator;
        borrowed_3 = _e15;
        let _e16 = Xoshiro128PlusPlus_next_uvec2_((&borrowed_3));
        let _e17 = borrowed_3;
        (*this_36).generator = _e17;
        chosen_15 = _e16;
    }
    let _e18 = chosen_15;
    return _e18;
}

// glimt_render_gpu/src/kernels/proposal.rs:498
fn Place_new(target_: f32) -> Place {

    // glimt_render_gpu/src/kernels/proposal.rs:499
    return Place(target_, 0f, 0u, 0f, 0f, false);
}

// glimt_render_gpu/src/kernels/proposal.rs:511
fn Place_offer(this_37: ptr<function, Place>, index_16: u32, width: f32) {

    // glimt_render_gpu/src/kernels/proposal.rs:512
    let _e8 = (*this_37).is_found;
    if ((width > 0f) && !(_e8)) {
        // glimt_render_gpu/src/kernels/proposal.rs:513
        (*this_37).index = index_16;
        // glimt_render_gpu/src/kernels/proposal.rs:514
        let _e15 = (*this_37).sum;
        (*this_37).first = _e15;
        // glimt_render_gpu/src/kernels/proposal.rs:515
        (*this_37).width = width;
    }
    // glimt_render_gpu/src/kernels/proposal.rs:517
    let _e21 = (*this_37).sum;
    (*this_37).sum = (_e21 + width);
    // glimt_render_gpu/src/kernels/proposal.rs:518
    let _e25 = (*this_37).is_found;
    let _e27 = (*this_37).sum;
    let _e29 = (*this_37).target_;
    (*this_37).is_found = (_e25 || (_e27 > _e29));
    return;
}

// glimt_render_gpu/src/kernels/proposal.rs:524
fn Place_word(this_38: Place, whole: f32, fraction: u32) -> u32 {

    // glimt_render_gpu/src/kernels/proposal.rs:525
    let unit = (whole * (1f / 16777216f));
    // glimt_render_gpu/src/kernels/proposal.rs:526
    let fine = ((this_38.target_ - this_38.first) + (unit * (f32(fraction) * (1f / 65536f))));
    // glimt_render_gpu/src/kernels/proposal.rs:527
    let place_3 = clamp((fine / max(this_38.width, 0.000000000000000000000000000000000000011754944f)), 0f, 0.99999994f);
    // glimt_render_gpu/src/kernels/proposal.rs:528
    return ((u32((place_3 * 16777216f)) << 8u) | (fraction & 255u));
}

// glimt_light_cells/src/partition.rs:141
fn LightCells_texel_rows(size_6: vec2<u32>, start_2: u32, row: u32) -> vec2<u32> {

    // glimt_light_cells/src/partition.rs:142
    let at_4 = (start_2 + row);
    // glimt_light_cells/src/partition.rs:143
    let _e8 = env_tables[at_4];
    let _e13 = env_tables[(at_4 + 1u)];
    return vec2<u32>(_e8, _e13);
}

// glimt_light_cells/src/partition.rs:74
fn first_row_word() -> u32 {

    // glimt_light_cells/src/partition.rs:75
    return (32u + (20u * 512u));
}

// glimt_light_cells/src/partition.rs:148
fn LightCells_row_edges(size_7: vec2<u32>, start_3: u32, cell_2: u32, rows_1: vec2<u32>) -> u32 {

    // glimt_light_cells/src/partition.rs:149
    let _e9 = Tuple_u32_u32_((cell_2 % 32u), (cell_2 / 32u));
    let column_2 = _e9.fa;
    let row_3 = _e9.fb;
    // glimt_light_cells/src/partition.rs:150
    let of_band = (32u * (rows_1.x + row_3));
    // glimt_light_cells/src/partition.rs:151
    let _e18 = first_row_word();
    return (((start_3 + _e18) + of_band) + (column_2 * ((rows_1.y - rows_1.x) + 1u)));
}

// glimt_envmap_cdf/src/search.rs:31
fn find_bin(start_4: u32, bins: u32, u_4: u32) -> Bin {
    var at_1: u32;
    var left: u32;

    // glimt_envmap_cdf/src/search.rs:33
    at_1 = start_4;
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
        let _e18 = at_1;
        let _e22 = env_tables[(_e18 + half)];
        if (_e22 <= u_4) {
            // glimt_envmap_cdf/src/search.rs:38
            let _e25 = at_1;
            at_1 = (_e25 + half);
        }
        // glimt_envmap_cdf/src/search.rs:40
        let _e28 = left;
        left = (_e28 - half);
    }
    // glimt_envmap_cdf/src/search.rs:42
    let _e31 = at_1;
    let first_9 = env_tables[_e31];
    // glimt_envmap_cdf/src/search.rs:43
    let _e36 = at_1;
    let _e38 = at_1;
    let _e43 = env_tables[(_e38 + 1u)];
    return Bin((_e36 - start_4), first_9, (_e43 - first_9));
}

// glimt_light_cells/src/partition.rs:93
fn first_column(column: u32, width_1: u32) -> u32 {

    // glimt_light_cells/src/partition.rs:94
    return ((column * width_1) / 32u);
}

// glimt_light_cells/src/partition.rs:106
fn column_unit(u_5: u32) -> u32 {

    // glimt_light_cells/src/partition.rs:107
    return (u_5 >> 17u);
}

// glimt_light_cells/src/partition.rs:80
fn first_column_word(size_8: vec2<u32>) -> u32 {

    // glimt_light_cells/src/partition.rs:81
    let _e3 = first_row_word();
    return (_e3 + (32u * (size_8.y + 16u)));
}

// glimt_light_cells/src/partition.rs:86
fn column_words(width_2: u32) -> u32 {

    // glimt_light_cells/src/partition.rs:87
    let _e4 = (width_2 / 2u);
    return select(_e4, (_e4 + 1u), ((width_2 % 2u) != 0u));
}

// glimt_light_cells/src/partition.rs:156
fn LightCells_column_edge(size_9: vec2<u32>, start_5: u32, x_9: u32, y_1: u32) -> u32 {

    // glimt_light_cells/src/partition.rs:157
    let _e6 = first_column_word(size_9);
    let _e9 = column_words(size_9.x);
    let at_5 = (((start_5 + _e6) + (y_1 * _e9)) + (x_9 / 2u));
    // glimt_light_cells/src/partition.rs:158
    let _e18 = env_tables[at_5];
    return ((_e18 >> ((16u * (x_9 & 1u)) & 31u)) & 65535u);
}

// glimt_light_cells/src/partition.rs:210
fn LightCells_pmf(size_10: vec2<u32>, start_6: u32, row_1: Bin, texel: vec2<u32>, first_6: u32) -> f32 {
    var chosen_16: u32;

    // glimt_light_cells/src/partition.rs:211
    if (texel.x > first_6) {
        // glimt_light_cells/src/partition.rs:212
        let _e15 = LightCells_column_edge(size_10, start_6, (texel.x - 1u), texel.y);
        chosen_16 = _e15;
    } else {
        // glimt_light_cells/src/partition.rs:214
        chosen_16 = 0u;
    }
    let lower_1 = chosen_16;
    // glimt_light_cells/src/partition.rs:216
    let _e22 = LightCells_column_edge(size_10, start_6, texel.x, texel.y);
    let units = (_e22 - lower_1);
    // glimt_light_cells/src/partition.rs:217
    return ((f32(row_1.units) * (1f / 2147483600f)) * (f32(units) * (1f / 32768f)));
}

// glimt_light_cells/src/partition.rs:164
fn LightCells_sample(size_11: vec2<u32>, start_7: u32, cell_3: u32, u_6: vec2<u32>) -> TexelDraw {
    var at_2: u32;
    var left_1: u32;

    // glimt_light_cells/src/partition.rs:165
    let _e8 = LightCells_texel_rows(size_11, start_7, (cell_3 / 32u));
    // glimt_light_cells/src/partition.rs:166
    let _e10 = LightCells_row_edges(size_11, start_7, cell_3, _e8);
    // glimt_light_cells/src/partition.rs:167
    let _e18 = find_bin(_e10, (_e8.y - _e8.x), (u_6.y >> 1u));
    // glimt_light_cells/src/partition.rs:173
    let y_6 = (_e8.x + _e18.index);
    // glimt_light_cells/src/partition.rs:174
    let column_3 = (cell_3 % 32u);
    // glimt_light_cells/src/partition.rs:175
    let _e28 = first_column(column_3, size_11.x);
    // glimt_light_cells/src/partition.rs:177
    let _e31 = column_unit(u_6.x);
    // glimt_light_cells/src/partition.rs:178
    at_2 = _e28;
    // glimt_light_cells/src/partition.rs:179
    let _e38 = first_column((column_3 + 1u), size_11.x);
    left_1 = (_e38 - _e28);
    // glimt_light_cells/src/partition.rs:180
    loop {
        let _e42 = left_1;
        if !((_e42 > 1u)) {
            break;
        }
        // glimt_light_cells/src/partition.rs:181
        let _e47 = left_1;
        let half_1 = (_e47 / 2u);
        // glimt_light_cells/src/partition.rs:182
        let _e51 = at_2;
        let _e55 = LightCells_column_edge(size_11, start_7, ((_e51 + half_1) - 1u), y_6);
        if (_e55 <= _e31) {
            // glimt_light_cells/src/partition.rs:183
            let _e58 = at_2;
            at_2 = (_e58 + half_1);
        }
        // glimt_light_cells/src/partition.rs:185
        let _e61 = left_1;
        left_1 = (_e61 - half_1);
    }
    // glimt_light_cells/src/partition.rs:187
    let _e64 = at_2;
    let _e66 = at_2;
    let _e68 = LightCells_pmf(size_11, start_7, _e18, vec2<u32>(_e66, y_6), _e28);
    return TexelDraw(vec2<u32>(_e64, y_6), _e68);
}

// glimt_probe/src/trig.rs:25
fn cos_sin_pi(x_10: f32) -> vec2<f32> {
    var chosen_17: vec2<f32>;

    // glimt_probe/src/trig.rs:27
    let quarter = floor(((2f * x_10) + 0.5f));
    // glimt_probe/src/trig.rs:28
    let y_7 = (x_10 - (0.5f * quarter));
    // glimt_probe/src/trig.rs:29
    let y2_1 = (y_7 * y_7);
    // glimt_probe/src/trig.rs:31
    let c_4 = (1f + (y2_1 * (-4.934802f + (y2_1 * (4.058712f + (y2_1 * (-1.3352627f + (y2_1 * (0.23533063f + (y2_1 * -0.02580689f))))))))));
    // glimt_probe/src/trig.rs:34
    let s_4 = (y_7 * (3.1415927f + (y2_1 * (-5.1677127f + (y2_1 * (2.550164f + (y2_1 * (-0.5992645f + (y2_1 * 0.082145885f)))))))));
    // glimt_probe/src/trig.rs:37
    let _e49 = (i32(quarter) & 3i);
    if (_e49 == 0i) {
        // glimt_probe/src/trig.rs:38
        chosen_17 = vec2<f32>(c_4, (s_4 + 0f));
    } else {
        if (_e49 == 1i) {
            // glimt_probe/src/trig.rs:39
            chosen_17 = vec2<f32>((0f - s_4), c_4);
        } else {
            if (_e49 == 2i) {
                // glimt_probe/src/trig.rs:40
                chosen_17 = vec2<f32>((0f - c_4), (0f - s_4));
            } else {
                // glimt_probe/src/trig.rs:41
                chosen_17 = vec2<f32>((s_4 + 0f), (0f - c_4));
            }
        }
    }
    let _e77 = chosen_17;
    return _e77;
}

// glimt_probe/src/latlong.rs:142
fn direction_in_texel(texel_1: vec2<u32>, size_12: vec2<u32>, r: vec2<f32>) -> vec3<f32> {
    var chosen_18: u32;
    var chosen_19: u32;
    var chosen_20: f32;

    // glimt_probe/src/latlong.rs:143
    let size_13 = max(size_12, vec2(1u));
    // glimt_probe/src/latlong.rs:144
    let row_4 = min(texel_1.y, (size_13.y - 1u));
    // glimt_probe/src/latlong.rs:146
    let southern = ((2u * row_4) >= size_13.y);
    // glimt_probe/src/latlong.rs:147
    if southern {
        chosen_18 = (size_13.y - row_4);
    } else {
        chosen_18 = row_4;
    }
    let upper_1 = chosen_18;
    // glimt_probe/src/latlong.rs:148
    if southern {
        chosen_19 = ((size_13.y - row_4) - 1u);
    } else {
        chosen_19 = (row_4 + 1u);
    }
    let lower_2 = chosen_19;
    // glimt_probe/src/latlong.rs:149
    let half_2 = (0.5f / f32(size_13.y));
    // glimt_probe/src/latlong.rs:150
    let _e41 = cos_sin_pi((f32(upper_1) * half_2));
    let sin_upper = _e41.y;
    // glimt_probe/src/latlong.rs:151
    let _e46 = cos_sin_pi((f32(lower_2) * half_2));
    let sin_lower = _e46.y;
    // glimt_probe/src/latlong.rs:152
    let s_upper = (sin_upper * sin_upper);
    // glimt_probe/src/latlong.rs:153
    let s_5 = (s_upper + (((sin_lower * sin_lower) - s_upper) * r.y));
    // glimt_probe/src/latlong.rs:154
    let sin_theta = (2f * sqrt(max((s_5 * (1f - s_5)), 0f)));
    // glimt_probe/src/latlong.rs:155
    if southern {
        // glimt_probe/src/latlong.rs:156
        chosen_20 = ((2f * s_5) - 1f);
    } else {
        // glimt_probe/src/latlong.rs:158
        chosen_20 = (1f - (2f * s_5));
    }
    let cos_theta = chosen_20;
    // glimt_probe/src/latlong.rs:160
    let _e90 = cos_sin_pi((1f - ((2f * (f32(texel_1.x) + r.x)) / f32(size_13.x))));
    // glimt_probe/src/latlong.rs:161
    return vec3<f32>((sin_theta * _e90.x), (sin_theta * _e90.y), cos_theta);
}

// glimt_render_gpu/src/kernels/proposal.rs:81
fn CellAt_new(lane: u32, weight: vec4<f32>, flux_4: vec4<f32>, terms_5: CellTerms, visibility_3: vec4<f32>) -> CellAt {

    // glimt_render_gpu/src/kernels/proposal.rs:82
    return CellAt(weight[lane], (flux_4 * terms_5.live)[lane], terms_5.cosine[lane], (terms_5.full[lane] > 0.5f), terms_5.lobe[lane], visibility_3[lane]);
}

// glimt_render_gpu/src/kernels/proposal.rs:432
fn Proposal_sample_cells(this_39: Proposal, u_7: vec2<u32>, cells_size_5: vec2<u32>, cells_start_5: u32, expected_from_2: u32, expected_turned_2: u32) -> CellDraw {
    var self_: Proposal;
    var row_place: Place;
    var counter_9: u32;
    var quad_place: Place;
    var counter_10: u32;
    var cell_place: Place;

    self_ = this_39;
    // glimt_render_gpu/src/kernels/proposal.rs:439
    let _e10 = unit_f32_(u_7.y);
    let _e12 = self_.total;
    let _e14 = Place_new((_e10 * _e12));
    row_place = _e14;
    // glimt_render_gpu/src/kernels/proposal.rs:440
    counter_9 = 0u;
    loop {
        let row_5 = counter_9;
        if (row_5 >= 16u) {
            break;
        }
        // glimt_render_gpu/src/kernels/proposal.rs:441
        let _e25 = self_.rows[row_5];
        Place_offer((&row_place), row_5, _e25);
        continuing {
            let _e26 = counter_9;
            counter_9 = (_e26 + 1u);
        }
    }
    // glimt_render_gpu/src/kernels/proposal.rs:443
    let _e31 = row_place.index;
    let first_10 = (_e31 * 8u);
    // glimt_render_gpu/src/kernels/proposal.rs:444
    let _e36 = unit_f32_(u_7.x);
    let _e38 = row_place.width;
    let target_1 = (_e36 * _e38);
    // glimt_render_gpu/src/kernels/proposal.rs:445
    let _e41 = Place_new(target_1);
    quad_place = _e41;
    // glimt_render_gpu/src/kernels/proposal.rs:446
    counter_10 = first_10;
    loop {
        let quad_9 = counter_10;
        if (quad_9 >= (first_10 + 8u)) {
            break;
        }
        // glimt_render_gpu/src/kernels/proposal.rs:447
        let _e52 = self_.quads[quad_9];
        Place_offer((&quad_place), quad_9, _e52);
        continuing {
            let _e53 = counter_10;
            counter_10 = (_e53 + 1u);
        }
    }
    // glimt_render_gpu/src/kernels/proposal.rs:449
    let quad_10 = quad_place.index;
    // glimt_render_gpu/src/kernels/proposal.rs:450
    let _e61 = LightCells_quad(cells_size_5, cells_start_5, 0u, quad_10);
    // glimt_render_gpu/src/kernels/proposal.rs:451
    let _e65 = self_.of_.surface;
    let _e66 = LightCells_terms(cells_size_5, cells_start_5, _e65, quad_10);
    // glimt_render_gpu/src/kernels/proposal.rs:452
    let _e68 = Remembered_quad(expected_from_2, expected_turned_2, quad_10);
    // glimt_render_gpu/src/kernels/proposal.rs:453
    let surface_5 = self_.of_.surface;
    // glimt_render_gpu/src/kernels/proposal.rs:454
    let _e75 = self_.is_catcher;
    let _e76 = weights(surface_5, _e66, _e61, _e68, _e75);
    // glimt_render_gpu/src/kernels/proposal.rs:455
    let _e81 = self_.defence;
    let all_1 = (_e76 + ((_e61 * _e66.live) * _e81));
    // glimt_render_gpu/src/kernels/proposal.rs:456
    let _e86 = quad_place.first;
    let _e87 = Place_new(target_1);
    cell_place = Place(_e87.target_, _e86, _e87.index, _e87.first, _e87.width, _e87.is_found);
    // glimt_render_gpu/src/kernels/proposal.rs:460
    Place_offer((&cell_place), 0u, all_1.x);
    // glimt_render_gpu/src/kernels/proposal.rs:461
    Place_offer((&cell_place), 1u, all_1.y);
    // glimt_render_gpu/src/kernels/proposal.rs:462
    Place_offer((&cell_place), 2u, all_1.z);
    // glimt_render_gpu/src/kernels/proposal.rs:463
    Place_offer((&cell_place), 3u, all_1.w);
    // glimt_render_gpu/src/kernels/proposal.rs:464
    let lane_1 = cell_place.index;
    // glimt_render_gpu/src/kernels/proposal.rs:465
    let cell_5 = ((4u * quad_10) + lane_1);
    // glimt_render_gpu/src/kernels/proposal.rs:466
    let _e117 = hash2_(u_7.x, u_7.y);
    // glimt_render_gpu/src/kernels/proposal.rs:467
    let _e119 = cell_place;
    let _e121 = row_place.width;
    let _e124 = Place_word(_e119, _e121, (_e117 & 65535u));
    let _e125 = row_place;
    let _e127 = self_.total;
    let _e130 = Place_word(_e125, _e127, (_e117 >> 16u));
    let within = vec2<u32>(_e124, _e130);
    // glimt_render_gpu/src/kernels/proposal.rs:471
    let _e133 = LightCells_sample(cells_size_5, cells_start_5, cell_5, within);
    // glimt_render_gpu/src/kernels/proposal.rs:472
    let _e136 = hash2_(_e117, u_7.x);
    // glimt_render_gpu/src/kernels/proposal.rs:473
    let place_4 = vec2<u32>((_e136 << 16u), (_e136 & 4294901760u));
    // glimt_render_gpu/src/kernels/proposal.rs:474
    let _e145 = unit_vec2_(place_4);
    let _e146 = direction_in_texel(_e133.texel, cells_size_5, _e145);
    let _e148 = CellAt_new(lane_1, _e76, _e61, _e66, _e68);
    return CellDraw(_e148, _e146, _e133.texel, cell_5);
}

// glimt_render_gpu/src/kernels/bvh.rs:108
fn any_hit(ray_13: Ray, t_max_2: f32) -> bool {
    var t_5: f32;

    // glimt_render_gpu/src/kernels/bvh.rs:115
    t_5 = t_max_2;
    // glimt_render_gpu/src/kernels/bvh.rs:116
    let _e7 = traverse(ray_13, (&t_5), true);
    return (_e7 != 4294967295u);
}

// glimt_render_gpu/src/kernels/scene.rs:136
fn Scene_is_lit(point: ShadingPoint, direction_2: vec3<f32>, key_4: u32) -> bool {

    // glimt_render_gpu/src/kernels/scene.rs:137
    let _e6 = Ray_keyed(point.origin, direction_2, key_4);
    // glimt_render_gpu/src/kernels/scene.rs:138
    let _e9 = any_hit(_e6, 0x1.fffffep+127f);
    return !(_e9);
}

// glimt_render_gpu/src/kernels/cell_state.rs:129
fn counted(n_4: u32, s_1: u32, arrives: u32) -> u32 {
    var chosen_21: u32;
    var chosen_22: u32;

    // glimt_render_gpu/src/kernels/cell_state.rs:130
    let is_full = (n_4 >= 255u);
    // glimt_render_gpu/src/kernels/cell_state.rs:132
    if is_full {
        chosen_21 = (n_4 / 2u);
    } else {
        chosen_21 = n_4;
    }
    let _e11 = chosen_21;
    let n_6 = (_e11 + 1u);
    // glimt_render_gpu/src/kernels/cell_state.rs:133
    if is_full {
        chosen_22 = (s_1 / 2u);
    } else {
        chosen_22 = s_1;
    }
    let _e18 = chosen_22;
    let s_6 = (_e18 + arrives);
    // glimt_render_gpu/src/kernels/cell_state.rs:134
    return (n_6 | (s_6 << 8u));
}

// glimt_render_gpu/src/kernels/cell_state.rs:140
fn count_2(word_6: u32, cell_4: u32, arrives_1: bool) -> u32 {
    var chosen_23: u32;

    // glimt_render_gpu/src/kernels/cell_state.rs:141
    let shift = (16u * (cell_4 & 1u));
    // glimt_render_gpu/src/kernels/cell_state.rs:142
    let own_2 = ((word_6 >> (shift & 31u)) & 65535u);
    // glimt_render_gpu/src/kernels/cell_state.rs:143
    if arrives_1 {
        chosen_23 = 1u;
    } else {
        chosen_23 = 0u;
    }
    let _e23 = chosen_23;
    let _e24 = counted((own_2 & 255u), (own_2 >> 8u), _e23);
    // glimt_render_gpu/src/kernels/cell_state.rs:144
    return ((word_6 & ~((65535u << (shift & 31u)))) | (_e24 << (shift & 31u)));
}

// glimt_render_gpu/src/kernels/pilot.rs:28
fn pilot_1(tile_1: u32, frame_4: FrameParams, cells: CellParams, env_size_1: vec2<u32>, env_rotation_1: vec2<f32>, counts_start: u32, counts_len: u32) {
    var counter_11: u32;
    var counter_12: u32;
    var counter_13: u32;
    var seen_1: SeenPoint;
    var proposal: Proposal;
    var chosen_24: u32;
    var counter_14: u32;
    var borrowed_4: PatternSource;

    // glimt_render_gpu/src/kernels/pilot.rs:38
    let first_11 = (tile_1 * 3u);
    // glimt_render_gpu/src/kernels/pilot.rs:39
    counter_11 = 0u;
    loop {
        let slot_1 = counter_11;
        if (slot_1 >= 3u) {
            break;
        }
        // glimt_render_gpu/src/kernels/pilot.rs:40
        let _e20 = entries[(first_11 + slot_1)];
        let _e22 = TileEntry_remembered(_e20, cells.turned);
        // glimt_render_gpu/src/kernels/pilot.rs:41
        counter_12 = 0u;
        loop {
            let word_9 = counter_12;
            if (word_9 >= 256u) {
                break;
            }
            // glimt_render_gpu/src/kernels/pilot.rs:42
            let _e32 = Remembered_word(_e22.value_from, _e22.value_turned, word_9);
            counts[(counts_start + ((slot_1 * 256u) + word_9))] = _e32;
            continuing {
                let _e39 = counter_12;
                counter_12 = (_e39 + 1u);
            }
        }
        continuing {
            let _e42 = counter_11;
            counter_11 = (_e42 + 1u);
        }
    }
    // glimt_render_gpu/src/kernels/pilot.rs:45
    let _e46 = CellParams_corner(cells, tile_1);
    // glimt_render_gpu/src/kernels/pilot.rs:46
    let _e48 = tile_end(_e46, frame_4);
    // glimt_render_gpu/src/kernels/pilot.rs:47
    let _e52 = (_e48.x - _e46.x);
    let _e54 = (_e52 / 2u);
    let columns_1 = select(_e54, (_e54 + 1u), ((_e52 % 2u) != 0u));
    // glimt_render_gpu/src/kernels/pilot.rs:48
    let _e64 = (_e48.y - _e46.y);
    let _e66 = (_e64 / 2u);
    let rows_3 = select(_e66, (_e66 + 1u), ((_e64 % 2u) != 0u));
    // glimt_render_gpu/src/kernels/pilot.rs:49
    let _e74 = Environment_cells(env_size_1, env_rotation_1);
    // glimt_render_gpu/src/kernels/pilot.rs:50
    counter_13 = 0u;
    loop {
        let i_3 = counter_13;
        if (i_3 >= 64u) {
            break;
        }
        // glimt_render_gpu/src/kernels/pilot.rs:52
        let place_5 = (reverseBits(i_3) >> ((32u - 6u) & 31u));
        // glimt_render_gpu/src/kernels/pilot.rs:53
        let pixel_4 = ((((_e46.y + ((place_5 / columns_1) * 2u)) * frame_4.width) + _e46.x) + ((place_5 % columns_1) * 2u));
        // glimt_render_gpu/src/kernels/pilot.rs:55
        let _e107 = FrameParams_pattern_at(frame_4, pixel_4, 0u);
        // glimt_render_gpu/src/kernels/pilot.rs:56
        seen_1 = SeenPoint(vec3(0f), 0u, vec3(0f), 0u, vec3(0f), 0f, vec3(0f), 0u, vec3(0f), 0u, vec3(0f), 0u, vec3(0f), 0f);
        // glimt_render_gpu/src/kernels/pilot.rs:57
        if (place_5 < (columns_1 * rows_3)) {
            // glimt_render_gpu/src/kernels/pilot.rs:58
            let _e136 = see_by(_e107, frame_4);
            seen_1 = _e136;
        }
        // glimt_render_gpu/src/kernels/pilot.rs:60
        let _e139 = seen_1.surface;
        let _e140 = slot_of(_e139, first_11);
        // glimt_render_gpu/src/kernels/pilot.rs:61
        let _e142 = seen_1;
        let _e143 = SeenPoint_is_hit(_e142);
        if (_e143 && (_e140 > 0u)) {
            // glimt_render_gpu/src/kernels/pilot.rs:62
            let entry = entries[((first_11 + _e140) - 1u)];
            // glimt_render_gpu/src/kernels/pilot.rs:63
            let base_2 = ((_e140 - 1u) * 256u);
            // glimt_render_gpu/src/kernels/pilot.rs:64
            let _e161 = TileEntry_remembered(entry, cells.turned);
            // glimt_render_gpu/src/kernels/pilot.rs:65
            let _e165 = seen_1;
            let _e166 = SeenPoint_shading_point(_e165);
            // glimt_render_gpu/src/kernels/pilot.rs:66
            let _e169 = seen_1.normal;
            let _e171 = seen_1.wo;
            let _e173 = seen_1.diffuse;
            let _e174 = luminance(_e173);
            let _e176 = seen_1.specular;
            let _e177 = luminance(_e176);
            let _e179 = seen_1.exponent;
            let _e180 = Representative_alone(_e169, _e171, _e174, _e177, _e179, env_size_1, env_rotation_1);
            // glimt_render_gpu/src/kernels/pilot.rs:74
            let _e182 = seen_1;
            let _e183 = SeenPoint_is_catcher(_e182);
            let _e184 = Proposal_new(_e180, _e74.value_size, _e74.value_start, _e161.value_from, _e161.value_turned, _e183);
            proposal = _e184;
            // glimt_render_gpu/src/kernels/pilot.rs:75
            let _e188 = PixelPattern_ray_key(_e107, 14u);
            // glimt_render_gpu/src/kernels/pilot.rs:76
            let _e192 = proposal.total;
            if (_e192 > 0f) {
                // glimt_render_gpu/src/kernels/pilot.rs:77
                chosen_24 = entry.pilots;
            } else {
                // glimt_render_gpu/src/kernels/pilot.rs:79
                chosen_24 = 0u;
            }
            let rays = chosen_24;
            // glimt_render_gpu/src/kernels/pilot.rs:81
            counter_14 = 0u;
            loop {
                let s_7 = counter_14;
                if (s_7 >= rays) {
                    break;
                }
                // glimt_render_gpu/src/kernels/pilot.rs:82
                let _e207 = PixelPattern_point(_e107, 13u, s_7);
                borrowed_4 = _e207;
                let _e209 = PatternSource_next_uvec2_((&borrowed_4));
                // glimt_render_gpu/src/kernels/pilot.rs:83
                let _e211 = proposal;
                let _e212 = Proposal_sample_cells(_e211, _e209, _e74.value_size, _e74.value_start, _e161.value_from, _e161.value_turned);
                // glimt_render_gpu/src/kernels/pilot.rs:84
                let _e215 = rotate_z(_e212.direction, env_rotation_1);
                // glimt_render_gpu/src/kernels/pilot.rs:85
                if ((dot(_e166.frame.n, _e215) > 0f) && (dot(_e166.geometric_normal, _e215) > 0f)) {
                    // glimt_render_gpu/src/kernels/pilot.rs:87
                    let _e229 = Scene_is_lit(_e166, _e215, (_e188 + s_7));
                    // glimt_render_gpu/src/kernels/pilot.rs:88
                    let at_6 = (base_2 + (_e212.cell / 2u));
                    // glimt_render_gpu/src/kernels/pilot.rs:89
                    let _e239 = counts[(counts_start + at_6)];
                    let _e241 = count_2(_e239, _e212.cell, _e229);
                    counts[(counts_start + at_6)] = _e241;
                }
                continuing {
                    let _e245 = counter_14;
                    counter_14 = (_e245 + 1u);
                }
            }
        }
        continuing {
            let _e248 = counter_13;
            counter_13 = (_e248 + 1u);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn pilot(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let local = ((id.y * (groups.x * 64u)) + id.x);
    let _e11 = params.count;
    if (local >= _e11) {
        return;
    }
    let _e14 = params.first;
    let _e17 = params.frame;
    let _e19 = params.cells;
    let _e21 = params.env_size;
    let _e23 = params.env_rotation;
    let _e25 = params.counts_len;
    pilot_1((_e14 + local), _e17, _e19, _e21, _e23, (local * _e25), _e25);
}
