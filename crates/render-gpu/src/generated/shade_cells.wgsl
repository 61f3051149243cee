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

struct Tuple_u32_u32_ {
    fa: u32,
    fb: u32,
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

struct Drawn {
    cells: u32,
    lobes: u32,
}

struct Group {
    first: u32,
    members: u32,
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

struct Returned_Expected_at_slot {
    value_first: u32,
    value_slot: u32,
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

struct CellAt {
    weight: f32,
    live: f32,
    cosine: f32,
    is_full: bool,
    lobe: f32,
    visibility: f32,
}

struct Look {
    of_map: vec3<f32>,
    direction: vec3<f32>,
    texel: vec2<u32>,
    at: CellAt,
    cell: u32,
    ray: u32,
    is_possible: bool,
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

struct DirectionSample {
    direction: vec3<f32>,
    pdf_sr: f32,
}

struct HalfVector {
    cos2_theta: f32,
    sin2_theta: f32,
    wo_dot_h: f32,
}

struct BrdfSample {
    wi: vec3<f32>,
    pdf_sr: f32,
}

struct Bin {
    index: u32,
    first: u32,
    units: u32,
}

struct Place {
    target_: f32,
    sum: f32,
    index: u32,
    first: f32,
    width: f32,
    is_found: bool,
}

struct TexelDraw {
    texel: vec2<u32>,
    pmf: f32,
}

struct CellDraw {
    at: CellAt,
    direction: vec3<f32>,
    texel: vec2<u32>,
    cell: u32,
}

struct Reflected {
    lit: vec3<f32>,
    blocked: vec3<f32>,
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
    points_len: u32,
    samples_len: u32,
    frame: FrameParams,
    cells: CellParams,
    env_size: vec2<u32>,
    env_rotation: vec2<f32>,
}

@group(0) @binding(1) 
var<storage> env_texels: array<vec4<f32>>;
@group(0) @binding(2) 
var<storage> env_tables: array<u32>;
@group(0) @binding(3) 
var<storage> scene_nodes: array<BvhNode>;
@group(0) @binding(4) 
var<storage> scene_triangles: array<Triangle>;
@group(0) @binding(5) 
var<storage> scene_surface: array<u32>;
@group(0) @binding(6) 
var<storage> visibility_4: array<u32>;
@group(0) @binding(7) 
var<storage, read_write> points: array<SeenPoint>;
@group(0) @binding(8) 
var<storage, read_write> samples_1: array<vec4<f32>>;
@group(0) @binding(0) 
var<uniform> params: Params;

// glimt_render_gpu/src/kernels/scout.rs:47
fn CellParams_tile_of(this_: CellParams, pixel: u32, frame: FrameParams) -> u32 {

    // glimt_render_gpu/src/kernels/scout.rs:48
    let _e9 = Tuple_u32_u32_((pixel % frame.width), (pixel / frame.width));
    let x_12 = _e9.fa;
    let y_2 = _e9.fb;
    // glimt_render_gpu/src/kernels/scout.rs:49
    return (((y_2 / 10u) * this_.tiles_across) + (x_12 / 16u));
}

// glimt_render_gpu/src/kernels/expect.rs:138
fn threshold(frame_1: FrameParams, cells: CellParams, parts: u32) -> f32 {
    var sum: f32;
    var counter: u32;

    // glimt_render_gpu/src/kernels/expect.rs:139
    if (cells.is_adaptive == 0u) {
        // glimt_render_gpu/src/kernels/expect.rs:140
        return 0f;
    }
    // glimt_render_gpu/src/kernels/expect.rs:142
    let behind = ((cells.tiles * 3u) * 128u);
    // glimt_render_gpu/src/kernels/expect.rs:143
    sum = 0f;
    // glimt_render_gpu/src/kernels/expect.rs:144
    counter = 0u;
    loop {
        let part = counter;
        if (part >= parts) {
            break;
        }
        // glimt_render_gpu/src/kernels/expect.rs:145
        let _e28 = visibility_4[(behind + part)];
        let _e30 = sum;
        sum = (_e30 + bitcast<f32>(_e28));
        continuing {
            let _e32 = counter;
            counter = (_e32 + 1u);
        }
    }
    // glimt_render_gpu/src/kernels/expect.rs:147
    let _e36 = sum;
    return (_e36 / (f32((frame_1.width * frame_1.height)) * cells.rays));
}

// glimt_render_gpu/src/kernels/environment.rs:78
fn Environment_cells(size: vec2<u32>, rotation: vec2<f32>) -> Returned_Environment_cells {

    // glimt_render_gpu/src/kernels/environment.rs:79
    return Returned_Environment_cells(size, 0u);
}

// glimt_render_gpu/src/kernels/frame.rs:130
fn FrameParams_pattern_at(this_1: FrameParams, pixel_1: u32, ray: u32) -> PixelPattern {

    // glimt_render_gpu/src/kernels/frame.rs:131
    return PixelPattern(this_1.pattern, this_1.seed, this_1.frame, pixel_1, ray, this_1.rays_per_pixel);
}

// glimt_render_gpu/src/kernels/frame.rs:120
fn FrameParams_pattern_of(this_2: FrameParams, ray_1: u32) -> PixelPattern {

    // glimt_render_gpu/src/kernels/frame.rs:121
    let _e10 = FrameParams_pattern_at(this_2, (this_2.first_pixel + (ray_1 / this_2.rays_per_pixel)), (ray_1 % this_2.rays_per_pixel));
    return _e10;
}

// glimt_render_gpu/src/kernels/seen.rs:78
fn SeenPoint_is_hit(this_3: SeenPoint) -> bool {

    // glimt_render_gpu/src/kernels/seen.rs:79
    return (this_3.surface != 0u);
}

// glimt_render_gpu/src/kernels/groups.rs:70
fn belongs(leader: SeenPoint, point: SeenPoint) -> bool {

    // glimt_render_gpu/src/kernels/groups.rs:71
    return (((((point.flags & 1u) == 0u) && (point.surface == leader.surface)) && (point.material == leader.material)) && (dot(point.normal, leader.normal) >= 0.9396926f));
}

// glimt_render_gpu/src/kernels/groups.rs:81
fn next_group(points_start: u32, points_len: u32, from_: ptr<function, u32>, first: u32) -> Group {
    var leader_1: u32;
    var both: bool;
    var either: bool;
    var members: u32;
    var counter_1: u32;

    // glimt_render_gpu/src/kernels/groups.rs:82
    // glimt_render_gpu/src/kernels/groups.rs:83
    let _e7 = (*from_);
    leader_1 = _e7;
    // glimt_render_gpu/src/kernels/groups.rs:84
    loop {
        let _e10 = leader_1;
        let _e11 = (_e10 < points_len);
        both = _e11;
        if _e11 {
            let _e13 = leader_1;
            let _e18 = points[(points_start + _e13)].flags;
            let _e22 = ((_e18 & 1u) != 0u);
            either = _e22;
            if _e22 {
            } else {
                let _e24 = leader_1;
                let _e28 = points[(points_start + _e24)];
                let _e29 = SeenPoint_is_hit(_e28);
                either = !(_e29);
            }
            let _e31 = either;
            both = _e31;
        }
        let _e32 = both;
        if _e32 {
            // glimt_render_gpu/src/kernels/groups.rs:87
            let _e35 = leader_1;
            leader_1 = (_e35 + 1u);
        } else {
            break;
        }
    }
    // glimt_render_gpu/src/kernels/groups.rs:89
    let _e38 = leader_1;
    (*from_) = _e38;
    // glimt_render_gpu/src/kernels/groups.rs:90
    members = 0u;
    // glimt_render_gpu/src/kernels/groups.rs:91
    let _e43 = leader_1;
    if (_e43 < points_len) {
        // glimt_render_gpu/src/kernels/groups.rs:92
        let _e46 = leader_1;
        let own = points[(points_start + _e46)];
        // glimt_render_gpu/src/kernels/groups.rs:93
        let _e52 = leader_1;
        counter_1 = _e52;
        loop {
            let ray_13 = counter_1;
            if (ray_13 >= points_len) {
                break;
            }
            // glimt_render_gpu/src/kernels/groups.rs:94
            let _e60 = points[(points_start + ray_13)];
            let _e61 = belongs(own, _e60);
            if _e61 {
                // glimt_render_gpu/src/kernels/groups.rs:95
                let _e63 = members;
                points[(points_start + (first + _e63))].order = ray_13;
                // glimt_render_gpu/src/kernels/groups.rs:96
                let _e75 = points[(points_start + ray_13)].flags;
                points[(points_start + ray_13)].flags = (_e75 | 1u);
                // glimt_render_gpu/src/kernels/groups.rs:97
                let _e79 = members;
                members = (_e79 + 1u);
            }
            continuing {
                let _e81 = counter_1;
                counter_1 = (_e81 + 1u);
            }
        }
    }
    // glimt_render_gpu/src/kernels/groups.rs:101
    let _e85 = members;
    return Group(first, _e85);
}

// glimt_render_gpu/src/kernels/groups.rs:108
fn Group_ray(this_4: Group, k: u32, points_start_1: u32, points_len_1: u32) -> u32 {

    // glimt_render_gpu/src/kernels/groups.rs:109
    let _e11 = points[(points_start_1 + (this_4.first + k))].order;
    return _e11;
}

// glimt_probe/src/rotate.rs:33
fn rotate_z(d: vec3<f32>, cos_sin: vec2<f32>) -> vec3<f32> {

    // glimt_probe/src/rotate.rs:34
    return vec3<f32>(((d.x * cos_sin.x) - (d.y * cos_sin.y)), ((d.x * cos_sin.y) + (d.y * cos_sin.x)), d.z);
}

// glimt_render_gpu/src/kernels/environment.rs:89
fn Environment_to_map(size_1: vec2<u32>, rotation_1: vec2<f32>, direction: vec3<f32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/environment.rs:90
    let _e8 = rotate_z(direction, vec2<f32>(rotation_1.x, -(rotation_1.y)));
    return _e8;
}

// glimt_sampling/src/math.rs:16
fn luminance(rgb: vec3<f32>) -> f32 {

    // glimt_sampling/src/math.rs:17
    return (((0.2126f * rgb.x) + (0.7152f * rgb.y)) + (0.0722f * rgb.z));
}

// glimt_brdf/src/lobe.rs:86
fn normalisation(exponent: f32) -> f32 {

    // glimt_brdf/src/lobe.rs:87
    let tail = exp2(max((-0.5f * exponent), -60f));
    // glimt_brdf/src/lobe.rs:88
    return ((((exponent + 2f) * (exponent + 4f)) * (0.125f * 0.31830987f)) / (tail + exponent));
}

// glimt_light_cells/src/surface.rs:105
fn CellSurface_new(normal: vec3<f32>, wo: vec3<f32>, kd: f32, ks: f32, exponent_1: f32, mean_length: f32, horizon: f32) -> CellSurface {

    // glimt_light_cells/src/surface.rs:115
    let r_1 = clamp(mean_length, 0.001f, 1f);
    // glimt_light_cells/src/surface.rs:116
    let widened = ((exponent_1 * r_1) / (r_1 + (exponent_1 * (1f - r_1))));
    // glimt_light_cells/src/surface.rs:117
    let _e22 = normalisation(widened);
    return CellSurface(normal, wo, (kd * 0.31830987f), ks, widened, _e22, sqrt((2f * (1f - r_1))), horizon, 1f);
}

// glimt_render_gpu/src/kernels/groups.rs:115
fn Group_representative(this_5: Group, points_start_2: u32, points_len_2: u32, env_size: vec2<u32>, env_rotation: vec2<f32>) -> Representative {
    var normal_1: vec3<f32>;
    var wo_1: vec3<f32>;
    var diffuse: vec3<f32>;
    var specular: vec3<f32>;
    var exponent_2: f32;
    var counter_2: u32;
    var horizon_1: f32;
    var counter_3: u32;

    // glimt_render_gpu/src/kernels/groups.rs:116
    normal_1 = vec3(0f);
    // glimt_render_gpu/src/kernels/groups.rs:117
    wo_1 = vec3(0f);
    // glimt_render_gpu/src/kernels/groups.rs:118
    diffuse = vec3(0f);
    // glimt_render_gpu/src/kernels/groups.rs:119
    specular = vec3(0f);
    // glimt_render_gpu/src/kernels/groups.rs:120
    exponent_2 = 0f;
    // glimt_render_gpu/src/kernels/groups.rs:121
    counter_2 = 0u;
    loop {
        let k_1 = counter_2;
        if (k_1 >= this_5.members) {
            break;
        }
        // glimt_render_gpu/src/kernels/groups.rs:122
        let _e32 = Group_ray(this_5, k_1, points_start_2, points_len_2);
        // glimt_render_gpu/src/kernels/groups.rs:123
        let point_5 = points[(points_start_2 + _e32)];
        // glimt_render_gpu/src/kernels/groups.rs:124
        let _e40 = normal_1;
        normal_1 = (_e40 + point_5.normal);
        // glimt_render_gpu/src/kernels/groups.rs:125
        let _e44 = wo_1;
        wo_1 = (_e44 + point_5.wo);
        // glimt_render_gpu/src/kernels/groups.rs:126
        let _e48 = diffuse;
        diffuse = (_e48 + point_5.diffuse);
        // glimt_render_gpu/src/kernels/groups.rs:127
        let _e52 = specular;
        specular = (_e52 + point_5.specular);
        // glimt_render_gpu/src/kernels/groups.rs:128
        let _e56 = exponent_2;
        exponent_2 = (_e56 + point_5.exponent);
        continuing {
            let _e58 = counter_2;
            counter_2 = (_e58 + 1u);
        }
    }
    // glimt_render_gpu/src/kernels/groups.rs:130
    let share_1 = (1f / f32(this_5.members));
    // glimt_render_gpu/src/kernels/groups.rs:131
    let _e67 = normal_1;
    normal_1 = (_e67 * share_1);
    // glimt_render_gpu/src/kernels/groups.rs:132
    let _e70 = diffuse;
    diffuse = (_e70 * share_1);
    // glimt_render_gpu/src/kernels/groups.rs:133
    let _e73 = specular;
    specular = (_e73 * share_1);
    // glimt_render_gpu/src/kernels/groups.rs:134
    let _e76 = normal_1;
    let length_1 = length(_e76);
    // glimt_render_gpu/src/kernels/groups.rs:135
    let _e79 = normal_1;
    let unit = (_e79 / vec3(max(length_1, 0.000001f)));
    // glimt_render_gpu/src/kernels/groups.rs:136
    horizon_1 = 0f;
    // glimt_render_gpu/src/kernels/groups.rs:137
    if (this_5.members > 1u) {
        // glimt_render_gpu/src/kernels/groups.rs:138
        counter_3 = 0u;
        loop {
            let k_2 = counter_3;
            if (k_2 >= this_5.members) {
                break;
            }
            // glimt_render_gpu/src/kernels/groups.rs:139
            let _e98 = Group_ray(this_5, k_2, points_start_2, points_len_2);
            // glimt_render_gpu/src/kernels/groups.rs:140
            let point_6 = points[(points_start_2 + _e98)];
            // glimt_render_gpu/src/kernels/groups.rs:141
            let _e105 = horizon_1;
            horizon_1 = max(_e105, length(cross(unit, point_6.normal)));
            continuing {
                let _e110 = counter_3;
                counter_3 = (_e110 + 1u);
            }
        }
        // glimt_render_gpu/src/kernels/groups.rs:143
        let _e115 = horizon_1;
        horizon_1 = ((1.02f * _e115) + 0.001f);
    }
    // glimt_render_gpu/src/kernels/groups.rs:145
    let _e120 = Environment_to_map(env_size, env_rotation, unit);
    let _e121 = wo_1;
    let _e123 = Environment_to_map(env_size, env_rotation, normalize(_e121));
    let _e124 = diffuse;
    let _e125 = luminance(_e124);
    let _e126 = specular;
    let _e127 = luminance(_e126);
    let _e128 = exponent_2;
    let _e130 = horizon_1;
    let _e131 = CellSurface_new(_e120, _e123, _e125, _e127, (_e128 * share_1), length_1, _e130);
    // glimt_render_gpu/src/kernels/groups.rs:154
    let _e133 = normal_1;
    let _e134 = Environment_to_map(env_size, env_rotation, _e133);
    let _e135 = diffuse;
    let _e136 = specular;
    let _e137 = exponent_2;
    let _e139 = exponent_2;
    let _e141 = normalisation((_e139 * share_1));
    return Representative(_e134, _e135, _e136, (_e137 * share_1), _e141, _e131);
}

// glimt_render_gpu/src/kernels/seen.rs:92
fn SeenPoint_slot(this_6: SeenPoint) -> u32 {

    // glimt_render_gpu/src/kernels/seen.rs:93
    return (this_6.flags >> 2u);
}

// glimt_render_gpu/src/kernels/cell_state.rs:248
fn Expected_at_slot(first_1: u32, slot: u32, slot_1: u32) -> Returned_Expected_at_slot {

    // glimt_render_gpu/src/kernels/cell_state.rs:249
    return Returned_Expected_at_slot(first_1, slot_1);
}

// glimt_render_gpu/src/kernels/seen.rs:85
fn SeenPoint_is_catcher(this_7: SeenPoint) -> bool {

    // glimt_render_gpu/src/kernels/seen.rs:86
    return ((this_7.flags & 2u) != 0u);
}

// glimt_light_cells/src/partition.rs:114
fn LightCells_quad(size_2: vec2<u32>, start: u32, list: u32, quad: u32) -> vec4<f32> {

    // glimt_light_cells/src/partition.rs:115
    let at_5 = (((start + 32u) + (list * 512u)) + (4u * quad));
    // glimt_light_cells/src/partition.rs:116
    let _e16 = env_tables[at_5];
    let _e22 = env_tables[(at_5 + 1u)];
    let _e28 = env_tables[(at_5 + 2u)];
    let _e34 = env_tables[(at_5 + 3u)];
    return vec4<f32>(bitcast<f32>(_e16), bitcast<f32>(_e22), bitcast<f32>(_e28), bitcast<f32>(_e34));
}

// glimt_light_cells/src/surface.rs:52
fn step_(x: vec4<f32>) -> vec4<f32> {

    // glimt_light_cells/src/surface.rs:54
    return clamp((x * 1000000000000000000000000000000f), vec4(0f), vec4(1f));
}

// glimt_light_cells/src/surface.rs:59
fn sqrt_(x_1: vec4<f32>) -> vec4<f32> {

    // glimt_light_cells/src/surface.rs:60
    return vec4<f32>(sqrt(x_1.x), sqrt(x_1.y), sqrt(x_1.z), sqrt(x_1.w));
}

// glimt_light_cells/src/surface.rs:82
fn cosine_power4_(sin2_theta: vec4<f32>, exponent_3: vec4<f32>) -> vec4<f32> {

    // glimt_light_cells/src/surface.rs:84
    let s = clamp(sin2_theta, vec4(0f), vec4(1f));
    // glimt_light_cells/src/surface.rs:85
    let log_ = ((s * (vec4(6f) - s)) / (vec4(12f) - (8f * s)));
    // glimt_light_cells/src/surface.rs:86
    let t_5 = (min((exponent_3 * log_), vec4(40f)) * (1f / 256f));
    // glimt_light_cells/src/surface.rs:88
    let x_13 = (vec4(1f) - (t_5 * (vec4(1f) - (t_5 * (vec4(0.5f) - (t_5 * (1f / 6f)))))));
    // glimt_light_cells/src/surface.rs:89
    let x2_ = (x_13 * x_13);
    // glimt_light_cells/src/surface.rs:90
    let x4_ = (x2_ * x2_);
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
fn LightCells_terms(size_3: vec2<u32>, start_1: u32, surface: CellSurface, quad_1: u32) -> CellTerms {

    // glimt_light_cells/src/surface.rs:174
    let _e7 = LightCells_quad(size_3, start_1, 15u, quad_1);
    // glimt_light_cells/src/surface.rs:175
    let _e12 = LightCells_quad(size_3, start_1, (15u + 1u), quad_1);
    // glimt_light_cells/src/surface.rs:176
    let _e17 = LightCells_quad(size_3, start_1, (15u + 2u), quad_1);
    // glimt_light_cells/src/surface.rs:177
    let _e20 = LightCells_quad(size_3, start_1, 18u, quad_1);
    // glimt_light_cells/src/surface.rs:178
    let _e23 = LightCells_quad(size_3, start_1, 19u, quad_1);
    // glimt_light_cells/src/surface.rs:179
    let n_3 = surface.normal;
    // glimt_light_cells/src/surface.rs:180
    let c_1 = (((_e7 * n_3.x) + (_e12 * n_3.y)) + (_e17 * n_3.z));
    // glimt_light_cells/src/surface.rs:181
    let reach_3 = (_e20 + vec4(surface.horizon));
    // glimt_light_cells/src/surface.rs:182
    let up = max((c_1 + reach_3), vec4(0f));
    // glimt_light_cells/src/surface.rs:183
    let _e45 = step_(up);
    // glimt_light_cells/src/surface.rs:184
    let _e48 = step_((c_1 - reach_3));
    // glimt_light_cells/src/surface.rs:185
    let cosine = max(c_1, vec4(0f));
    // glimt_light_cells/src/surface.rs:186
    let half_spread = vec4((0.5f * surface.spread));
    // glimt_light_cells/src/surface.rs:187
    let cosine_spread = ((_e48 * half_spread) + ((vec4(1f) - _e48) * (0.35f * min(up, (2f * _e23)))));
    // glimt_light_cells/src/surface.rs:188
    if !((surface.specular > 0f)) {
        // glimt_light_cells/src/surface.rs:189
        return CellTerms(cosine, _e48, _e45, vec4(0f), vec4(0f), cosine_spread);
    }
    // glimt_light_cells/src/surface.rs:199
    let lifted = max(c_1, (0.25f * up));
    // glimt_light_cells/src/surface.rs:200
    let v_5 = surface.wo;
    // glimt_light_cells/src/surface.rs:201
    let nv = dot(n_3, v_5);
    // glimt_light_cells/src/surface.rs:202
    let dv = ((((_e7 * v_5.x) + (_e12 * v_5.y)) + (_e17 * v_5.z)) + ((lifted - c_1) * nv));
    // glimt_light_cells/src/surface.rs:203
    let _e111 = sqrt_(max(((vec4(1f) + (lifted * lifted)) - (c_1 * c_1)), vec4(0.000001f)));
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
    let e = max(surface.exponent, 0.001f);
    // glimt_light_cells/src/surface.rs:210
    let seen_1 = (vec4(4f) / (vec4((4f / e)) + (0.7f * r2_)));
    // glimt_light_cells/src/surface.rs:211
    let _e157 = cosine_power4_(sin2_, seen_1);
    let lobe = (((_e157 * seen_1) * (lifted * _e45)) * ((surface.share * surface.peak) / e));
    // glimt_light_cells/src/surface.rs:213
    let _e171 = sqrt_((sin2_ / max(cos2_, vec4(0.0001f))));
    // glimt_light_cells/src/surface.rs:214
    let near = (vec4((((0.1f * e) * surface.spread) * surface.spread)) + ((0.06f * e) * r2_));
    // glimt_light_cells/src/surface.rs:215
    let slope = (((0.5f * e) * _e171) * ((0.5f * _e23) + half_spread));
    // glimt_light_cells/src/surface.rs:216
    return CellTerms(cosine, _e48, _e45, lobe, min((slope + near), vec4(1f)), cosine_spread);
}

// glimt_render_gpu/src/kernels/cell_state.rs:98
fn bytes_of(word: u32) -> vec4<f32> {

    // glimt_render_gpu/src/kernels/cell_state.rs:99
    return vec4<f32>(f32((word & 255u)), f32(((word >> 8u) & 255u)), f32(((word >> 16u) & 255u)), f32((word >> 24u)));
}

// glimt_render_gpu/src/kernels/cell_state.rs:253
fn Expected_quad(first_2: u32, slot_2: u32, quad_2: u32) -> vec4<f32> {

    // glimt_render_gpu/src/kernels/cell_state.rs:254
    if (slot_2 == 0u) {
        // glimt_render_gpu/src/kernels/cell_state.rs:255
        return vec4(0.75f);
    }
    // glimt_render_gpu/src/kernels/cell_state.rs:257
    let entry = ((first_2 + slot_2) - 1u);
    // glimt_render_gpu/src/kernels/cell_state.rs:258
    let word_5 = visibility_4[((entry * 128u) + quad_2)];
    // glimt_render_gpu/src/kernels/cell_state.rs:259
    let _e22 = bytes_of(word_5);
    return (_e22 * (1f / 255f));
}

// glimt_light_cells/src/surface.rs:162
fn CellSurface_shape_variance(this_8: CellSurface, terms: CellTerms) -> vec4<f32> {

    // glimt_light_cells/src/surface.rs:163
    let diffuse_2 = (terms.cosine_spread * this_8.diffuse);
    // glimt_light_cells/src/surface.rs:164
    let lobe_1 = ((terms.lobe * terms.lobe_spread) * this_8.specular);
    // glimt_light_cells/src/surface.rs:165
    return ((diffuse_2 * diffuse_2) + (lobe_1 * lobe_1));
}

// glimt_light_cells/src/surface.rs:153
fn CellSurface_blocked_weights(this_9: CellSurface, terms_1: CellTerms, flux: vec4<f32>, visibility: vec4<f32>) -> vec4<f32> {

    // glimt_light_cells/src/surface.rs:154
    let reflected = ((terms_1.cosine * this_9.diffuse) + (terms_1.lobe * this_9.specular));
    // glimt_light_cells/src/surface.rs:155
    let blocked_2 = ((vec4(1f) - (visibility * visibility)) + vec4(0.0002f));
    // glimt_light_cells/src/surface.rs:156
    let _e22 = CellSurface_shape_variance(this_9, terms_1);
    // glimt_light_cells/src/surface.rs:157
    let _e29 = sqrt_((((reflected * reflected) * blocked_2) + _e22));
    return ((flux * terms_1.live) * _e29);
}

// glimt_light_cells/src/surface.rs:142
fn CellSurface_residual_weights(this_10: CellSurface, terms_2: CellTerms, flux_1: vec4<f32>, visibility_1: vec4<f32>) -> vec4<f32> {

    // glimt_light_cells/src/surface.rs:143
    let reflected_1 = ((terms_2.cosine * this_10.diffuse) + (terms_2.lobe * this_10.specular));
    // glimt_light_cells/src/surface.rs:144
    let by_visibility = ((visibility_1 * (vec4(1f) - visibility_1)) + vec4(0.0002f));
    // glimt_light_cells/src/surface.rs:145
    let _e22 = CellSurface_shape_variance(this_10, terms_2);
    let by_shape = (_e22 * max(visibility_1, vec4(0.02f)));
    // glimt_light_cells/src/surface.rs:146
    let _e33 = sqrt_((((reflected_1 * reflected_1) * by_visibility) + by_shape));
    return ((flux_1 * terms_2.live) * _e33);
}

// glimt_light_cells/src/surface.rs:133
fn CellSurface_product_weights(this_11: CellSurface, terms_3: CellTerms, flux_2: vec4<f32>) -> vec4<f32> {

    // glimt_light_cells/src/surface.rs:134
    let reflected_2 = ((terms_3.cosine * this_11.diffuse) + (terms_3.lobe * this_11.specular));
    // glimt_light_cells/src/surface.rs:135
    return ((flux_2 * terms_3.live) * (reflected_2 + (terms_3.cosine_spread * this_11.diffuse)));
}

// glimt_render_gpu/src/kernels/proposal.rs:256
fn weights(surface_1: CellSurface, terms_4: CellTerms, flux_3: vec4<f32>, visibility_2: vec4<f32>, is_catcher: bool) -> vec4<f32> {
    var chosen: vec4<f32>;
    var chosen_1: vec4<f32>;

    // glimt_render_gpu/src/kernels/proposal.rs:263
    if (true && is_catcher) {
        // glimt_render_gpu/src/kernels/proposal.rs:264
        let _e11 = CellSurface_blocked_weights(surface_1, terms_4, flux_3, visibility_2);
        chosen = _e11;
    } else {
        if true {
            // glimt_render_gpu/src/kernels/proposal.rs:266
            let _e15 = CellSurface_residual_weights(surface_1, terms_4, flux_3, visibility_2);
            chosen_1 = _e15;
        } else {
            // glimt_render_gpu/src/kernels/proposal.rs:268
            let _e17 = CellSurface_product_weights(surface_1, terms_4, flux_3);
            chosen_1 = _e17;
        }
        let _e18 = chosen_1;
        chosen = _e18;
    }
    let _e19 = chosen;
    return _e19;
}

// glimt_render_gpu/src/kernels/proposal.rs:154
fn channel_sum(cells_size: vec2<u32>, cells_start: u32, quad_3: u32, channel: u32, normal_2: vec3<f32>, full: vec4<f32>, cut: vec4<f32>) -> f32 {

    // glimt_render_gpu/src/kernels/proposal.rs:162
    let list_1 = (4u + (3u * channel));
    // glimt_render_gpu/src/kernels/proposal.rs:163
    let _e14 = LightCells_quad(cells_size, cells_start, list_1, quad_3);
    let _e19 = LightCells_quad(cells_size, cells_start, (list_1 + 1u), quad_3);
    let _e25 = LightCells_quad(cells_size, cells_start, (list_1 + 2u), quad_3);
    let moment = (((_e14 * normal_2.x) + (_e19 * normal_2.y)) + (_e25 * normal_2.z));
    // glimt_render_gpu/src/kernels/proposal.rs:166
    let _e32 = LightCells_quad(cells_size, cells_start, (1u + channel), quad_3);
    // glimt_render_gpu/src/kernels/proposal.rs:167
    let _e36 = ((full * moment) + (cut * _e32));
    return (((_e36.x + _e36.y) + _e36.z) + _e36.w);
}

// glimt_render_gpu/src/kernels/proposal.rs:172
fn diffuse_sum(cells_size_1: vec2<u32>, cells_start_1: u32, quad_4: u32, normal_3: vec3<f32>, full_1: vec4<f32>, cut_1: vec4<f32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/proposal.rs:173
    let _e9 = channel_sum(cells_size_1, cells_start_1, quad_4, 0u, normal_3, full_1, cut_1);
    let _e11 = channel_sum(cells_size_1, cells_start_1, quad_4, 1u, normal_3, full_1, cut_1);
    let _e13 = channel_sum(cells_size_1, cells_start_1, quad_4, 2u, normal_3, full_1, cut_1);
    return vec3<f32>(_e9, _e11, _e13);
}

// glimt_render_gpu/src/kernels/proposal.rs:182
fn radiance_sum(cells_size_2: vec2<u32>, cells_start_2: u32, quad_5: u32, factors: vec4<f32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/proposal.rs:183
    let _e7 = LightCells_quad(cells_size_2, cells_start_2, 1u, quad_5);
    let _e8 = (_e7 * factors);
    let _e19 = LightCells_quad(cells_size_2, cells_start_2, (1u + 1u), quad_5);
    let _e20 = (_e19 * factors);
    let _e31 = LightCells_quad(cells_size_2, cells_start_2, (1u + 2u), quad_5);
    let _e32 = (_e31 * factors);
    return vec3<f32>((((_e8.x + _e8.y) + _e8.z) + _e8.w), (((_e20.x + _e20.y) + _e20.z) + _e20.w), (((_e32.x + _e32.y) + _e32.z) + _e32.w));
}

// glimt_render_gpu/src/kernels/proposal.rs:191
fn weigh(of_: Representative, cells_size_3: vec2<u32>, cells_start_3: u32, expected_first: u32, expected_slot: u32, is_catcher_1: bool) -> Totals {
    var t: Totals;
    var counter_4: u32;

    // glimt_render_gpu/src/kernels/proposal.rs:197
    let surface_3 = of_.surface;
    // glimt_render_gpu/src/kernels/proposal.rs:198
    let has_lobe = (surface_3.specular > 0f);
    // glimt_render_gpu/src/kernels/proposal.rs:199
    t = Totals(array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f), array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f), 0f, 0f, 0f, 0f, 0f, 0f, 0f, vec3(0f), vec3(0f), vec3(0f), vec3(0f));
    // glimt_render_gpu/src/kernels/proposal.rs:214
    counter_4 = 0u;
    loop {
        let quad_6 = counter_4;
        if (quad_6 >= 128u) {
            break;
        }
        // glimt_render_gpu/src/kernels/proposal.rs:215
        let _e43 = LightCells_quad(cells_size_3, cells_start_3, 0u, quad_6);
        // glimt_render_gpu/src/kernels/proposal.rs:216
        let _e45 = LightCells_terms(cells_size_3, cells_start_3, surface_3, quad_6);
        // glimt_render_gpu/src/kernels/proposal.rs:217
        let _e48 = (_e43 * _e45.live);
        let live = (((_e48.x + _e48.y) + _e48.z) + _e48.w);
        // glimt_render_gpu/src/kernels/proposal.rs:219
        if (live > 0f) {
            // glimt_render_gpu/src/kernels/proposal.rs:220
            let _e60 = Expected_quad(expected_first, expected_slot, quad_6);
            // glimt_render_gpu/src/kernels/proposal.rs:221
            let _e62 = weights(surface_3, _e45, _e43, _e60, is_catcher_1);
            // glimt_render_gpu/src/kernels/proposal.rs:222
            let weight_1 = (((_e62.x + _e62.y) + _e62.z) + _e62.w);
            // glimt_render_gpu/src/kernels/proposal.rs:223
            if true {
                // glimt_render_gpu/src/kernels/proposal.rs:224
                let full_2 = (_e45.full * _e60);
                // glimt_render_gpu/src/kernels/proposal.rs:225
                let cut_2 = ((_e60 - full_2) * _e45.cosine);
                // glimt_render_gpu/src/kernels/proposal.rs:226
                let _e83 = diffuse_sum(cells_size_3, cells_start_3, quad_6, of_.mean_normal, full_2, cut_2);
                let _e84 = t.diffuse;
                t.diffuse = (_e84 + _e83);
                // glimt_render_gpu/src/kernels/proposal.rs:227
                if is_catcher_1 {
                    // glimt_render_gpu/src/kernels/proposal.rs:228
                    let cut_3 = ((vec4(1f) - _e45.full) * _e45.cosine);
                    // glimt_render_gpu/src/kernels/proposal.rs:229
                    let _e97 = diffuse_sum(cells_size_3, cells_start_3, quad_6, of_.mean_normal, _e45.full, cut_3);
                    // glimt_render_gpu/src/kernels/proposal.rs:230
                    let _e100 = t.open_diffuse;
                    t.open_diffuse = (_e100 + _e97);
                    // glimt_render_gpu/src/kernels/proposal.rs:231
                    let _e105 = radiance_sum(cells_size_3, cells_start_3, quad_6, _e45.lobe);
                    let _e106 = t.open_specular;
                    t.open_specular = (_e106 + _e105);
                }
            }
            // glimt_render_gpu/src/kernels/proposal.rs:234
            if has_lobe {
                // glimt_render_gpu/src/kernels/proposal.rs:235
                let a_3 = (_e45.lobe * _e43);
                // glimt_render_gpu/src/kernels/proposal.rs:236
                let spread = ((a_3 * _e45.lobe_spread) * _e45.lobe_spread);
                // glimt_render_gpu/src/kernels/proposal.rs:237
                let _e126 = t.lobe;
                t.lobe = (_e126 + (((a_3.x + a_3.y) + a_3.z) + a_3.w));
                // glimt_render_gpu/src/kernels/proposal.rs:238
                let _e137 = t.lobe_spread;
                t.lobe_spread = (_e137 + (((spread.x + spread.y) + spread.z) + spread.w));
                // glimt_render_gpu/src/kernels/proposal.rs:239
                let _e140 = (a_3 * _e60);
                let _e149 = t.lobe_visible;
                t.lobe_visible = (_e149 + (((_e140.x + _e140.y) + _e140.z) + _e140.w));
                // glimt_render_gpu/src/kernels/proposal.rs:240
                let _e154 = LightCells_quad(cells_size_3, cells_start_3, 13u, quad_6);
                let _e155 = (_e45.lobe * _e154);
                let _e164 = t.lobe_square;
                t.lobe_square = (_e164 + (((_e155.x + _e155.y) + _e155.z) + _e155.w));
                // glimt_render_gpu/src/kernels/proposal.rs:241
                let _e169 = LightCells_quad(cells_size_3, cells_start_3, 14u, quad_6);
                let _e170 = (_e45.lobe * _e169);
                let _e179 = t.lobe_area;
                t.lobe_area = (_e179 + (((_e170.x + _e170.y) + _e170.z) + _e170.w));
                // glimt_render_gpu/src/kernels/proposal.rs:242
                if true {
                    // glimt_render_gpu/src/kernels/proposal.rs:243
                    let _e187 = radiance_sum(cells_size_3, cells_start_3, quad_6, (_e45.lobe * _e60));
                    let _e188 = t.specular;
                    t.specular = (_e188 + _e187);
                }
            }
            // glimt_render_gpu/src/kernels/proposal.rs:246
            t.quads[quad_6] = weight_1;
            // glimt_render_gpu/src/kernels/proposal.rs:247
            t.lives[quad_6] = live;
            // glimt_render_gpu/src/kernels/proposal.rs:248
            let _e198 = t.weight;
            t.weight = (_e198 + weight_1);
            // glimt_render_gpu/src/kernels/proposal.rs:249
            let _e202 = t.live;
            t.live = (_e202 + live);
        }
        continuing {
            let _e204 = counter_4;
            counter_4 = (_e204 + 1u);
        }
    }
    // glimt_render_gpu/src/kernels/proposal.rs:252
    let _e208 = t;
    return _e208;
}

// glimt_render_gpu/src/kernels/proposal.rs:275
fn worth(a: f32, visible: f32, variance: f32) -> f32 {

    // glimt_render_gpu/src/kernels/proposal.rs:276
    if true {
        // glimt_render_gpu/src/kernels/proposal.rs:277
        return (a * sqrt(((visible * (1f - visible)) + (visible * variance))));
    }
    // glimt_render_gpu/src/kernels/proposal.rs:280
    return (a * sqrt((1f + (2f * variance))));
}

// glimt_render_gpu/src/kernels/proposal.rs:285
fn is_sharp(surface_2: CellSurface) -> bool {

    // glimt_render_gpu/src/kernels/proposal.rs:286
    let is_flat = (dot(surface_2.normal, surface_2.wo) < 0.3f);
    // glimt_render_gpu/src/kernels/proposal.rs:287
    return ((surface_2.specular > 0f) && (is_flat || (surface_2.exponent > 40f)));
}

// glimt_render_gpu/src/kernels/proposal.rs:294
fn Proposal_new(of_1: Representative, cells_size_4: vec2<u32>, cells_start_4: u32, expected_first_1: u32, expected_slot_1: u32, is_catcher_2: bool) -> Proposal {
    var of_2: Representative;
    var sums: Totals;
    var first_3: Totals;
    var lobe_worth: f32;
    var least_share: f32;
    var share: f32;
    var defence: f32;
    var total: f32;
    var quads: array<f32, 128>;
    var rows: array<f32, 16>;
    var counter_5: u32;
    var of_row: f32;
    var counter_6: u32;
    var lobe_share: f32;

    // glimt_render_gpu/src/kernels/proposal.rs:300
    of_2 = of_1;
    // glimt_render_gpu/src/kernels/proposal.rs:301
    let _e10 = of_2;
    let _e11 = weigh(_e10, cells_size_4, cells_start_4, expected_first_1, expected_slot_1, is_catcher_2);
    sums = _e11;
    // glimt_render_gpu/src/kernels/proposal.rs:302
    let _e14 = sums;
    first_3 = _e14;
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
        let a_4 = (_e75 * _e78);
        // glimt_render_gpu/src/kernels/proposal.rs:318
        let _e82 = sums.lobe_visible;
        let _e84 = sums.lobe;
        let visible_1 = min((_e82 / _e84), 1f);
        // glimt_render_gpu/src/kernels/proposal.rs:319
        let _e89 = share;
        if (_e89 < 1f) {
            // glimt_render_gpu/src/kernels/proposal.rs:320
            let _e94 = share;
            let _e96 = worth(a_4, visible_1, by_lobe);
            lobe_worth = ((1f - _e94) * _e96);
            // glimt_render_gpu/src/kernels/proposal.rs:321
            let _e99 = share;
            of_2.surface.share = _e99;
            // glimt_render_gpu/src/kernels/proposal.rs:322
            let _e103 = of_2;
            let _e104 = weigh(_e103, cells_size_4, cells_start_4, expected_first_1, expected_slot_1, is_catcher_2);
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
    counter_5 = 0u;
    loop {
        let row_3 = counter_5;
        if (row_3 >= 16u) {
            break;
        }
        // glimt_render_gpu/src/kernels/proposal.rs:336
        of_row = 0f;
        // glimt_render_gpu/src/kernels/proposal.rs:337
        counter_6 = (row_3 * 8u);
        loop {
            let quad_7 = counter_6;
            if (quad_7 >= ((row_3 + 1u) * 8u)) {
                break;
            }
            // glimt_render_gpu/src/kernels/proposal.rs:338
            let _e160 = sums.quads[quad_7];
            let _e161 = defence;
            let _e164 = sums.lives[quad_7];
            let weight_2 = (_e160 + (_e161 * _e164));
            // glimt_render_gpu/src/kernels/proposal.rs:339
            quads[quad_7] = weight_2;
            // glimt_render_gpu/src/kernels/proposal.rs:340
            let _e170 = of_row;
            of_row = (_e170 + weight_2);
            continuing {
                let _e172 = counter_6;
                counter_6 = (_e172 + 1u);
            }
        }
        // glimt_render_gpu/src/kernels/proposal.rs:342
        let _e176 = of_row;
        rows[row_3] = _e176;
        // glimt_render_gpu/src/kernels/proposal.rs:343
        let _e179 = of_row;
        let _e180 = total;
        total = (_e180 + _e179);
        continuing {
            let _e182 = counter_5;
            counter_5 = (_e182 + 1u);
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
    let _e215 = first_3.diffuse;
    let _e218 = of_2.specular;
    let _e220 = first_3.specular;
    let _e221 = share;
    let _e226 = first_3.open_diffuse;
    let _e229 = of_2.specular;
    let _e231 = first_3.open_specular;
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
fn hash2_(a_1: u32, b: u32) -> u32 {

    // glimt_sampling/src/hash.rs:28
    let _e4 = hash_u32_(a_1);
    let _e6 = hash_u32_((_e4 + b));
    return _e6;
}

// glimt_sampling/src/hash.rs:34
fn hash3_(a_2: u32, b_1: u32, c: u32) -> u32 {

    // glimt_sampling/src/hash.rs:35
    let _e5 = hash2_(a_2, b_1);
    let _e7 = hash_u32_((_e5 + c));
    return _e7;
}

// glimt_sampling/src/sobol.rs:172
fn OwenSobol_new(seed: u32, frame_2: u32, pixel_2: u32, sample_index: u32) -> OwenSobol {

    // glimt_sampling/src/sobol.rs:173
    let _e6 = hash3_(seed, frame_2, pixel_2);
    let _e9 = hash2_(_e6, (sample_index >> 16u));
    return OwenSobol(_e9, (sample_index & 65535u), 0u);
}

// glimt_render_gpu/src/kernels/pattern.rs:136
fn PixelPattern_sobol_point(this_12: PixelPattern, purpose: u32, index: u32) -> OwenSobol {

    // glimt_render_gpu/src/kernels/pattern.rs:137
    let _e6 = hash2_(this_12.seed, purpose);
    let _e9 = OwenSobol_new(_e6, this_12.frame, this_12.pixel, index);
    return _e9;
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
fn Xoshiro128PlusPlus_stream(seed_1: u32, frame_3: u32, pixel_3: u32) -> Xoshiro128PlusPlus {

    // glimt_sampling/src/xoshiro.rs:50
    let _e7 = hash_uvec4_(vec4<u32>(pixel_3, frame_3, seed_1, 2654435769u));
    let _e8 = Xoshiro128PlusPlus_from_state(_e7);
    return _e8;
}

// glimt_render_gpu/src/kernels/pattern.rs:141
fn PixelPattern_generator(this_13: PixelPattern, purpose_1: u32, index_1: u32) -> Xoshiro128PlusPlus {

    // glimt_render_gpu/src/kernels/pattern.rs:142
    let _e6 = hash3_(this_13.seed, purpose_1, index_1);
    let _e9 = Xoshiro128PlusPlus_stream(_e6, this_13.frame, this_13.pixel);
    return _e9;
}

// glimt_render_gpu/src/kernels/pattern.rs:105
fn PixelPattern_point(this_14: PixelPattern, purpose_2: u32, index_2: u32) -> PatternSource {

    // glimt_render_gpu/src/kernels/pattern.rs:106
    let _e8 = PixelPattern_sobol_point(this_14, purpose_2, index_2);
    let _e9 = PixelPattern_generator(this_14, purpose_2, index_2);
    return PatternSource((this_14.kind == 0u), _e8, _e9);
}

// glimt_sampling/src/sobol.rs:21
fn owen_scramble_reversed(n_1: u32, scramble: u32) -> u32 {
    var x_4: u32;

    // glimt_sampling/src/sobol.rs:22
    x_4 = (n_1 ^ (n_1 * 1025551850u));
    // glimt_sampling/src/sobol.rs:23
    let _e9 = x_4;
    x_4 = (_e9 + scramble);
    // glimt_sampling/src/sobol.rs:24
    let _e12 = x_4;
    x_4 = (_e12 * ((scramble >> 16u) | 1u));
    // glimt_sampling/src/sobol.rs:25
    let _e19 = x_4;
    let _e22 = x_4;
    x_4 = (_e22 ^ (_e19 * 89287766u));
    // glimt_sampling/src/sobol.rs:26
    let _e25 = x_4;
    let _e26 = x_4;
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
    var x_5: u32;

    // glimt_sampling/src/sobol.rs:57
    x_5 = index_4;
    // glimt_sampling/src/sobol.rs:58
    let _e5 = x_5;
    let _e10 = x_5;
    x_5 = (_e10 ^ ((_e5 >> 1u) & 21845u));
    // glimt_sampling/src/sobol.rs:59
    let _e13 = x_5;
    let _e18 = x_5;
    x_5 = (_e18 ^ ((_e13 >> 2u) & 13107u));
    // glimt_sampling/src/sobol.rs:60
    let _e21 = x_5;
    let _e26 = x_5;
    x_5 = (_e26 ^ ((_e21 >> 4u) & 3855u));
    // glimt_sampling/src/sobol.rs:61
    let _e29 = x_5;
    let _e30 = x_5;
    return (_e29 ^ ((_e30 >> 8u) & 255u));
}

// glimt_sampling/src/sobol.rs:66
fn recurrence_2_(index_5: u32) -> u32 {
    var bits: u32;
    var v0_: u32;
    var v1_: u32;
    var sum_1: u32;
    var counter_7: i32;

    // glimt_sampling/src/sobol.rs:67
    bits = index_5;
    // glimt_sampling/src/sobol.rs:68
    v0_ = 1u;
    // glimt_sampling/src/sobol.rs:69
    v1_ = 3u;
    // glimt_sampling/src/sobol.rs:70
    sum_1 = 0u;
    // glimt_sampling/src/sobol.rs:72
    counter_7 = 0i;
    loop {
        let _e17 = counter_7;
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
            let _e44 = counter_7;
            counter_7 = (_e44 + 1i);
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
    var counter_8: i32;

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
    counter_8 = 0i;
    loop {
        let _e20 = counter_8;
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
            let _e49 = counter_8;
            counter_8 = (_e49 + 1i);
        }
    }
    // glimt_sampling/src/sobol.rs:98
    let _e53 = sum_2;
    return _e53;
}

// glimt_sampling/src/sobol.rs:43
fn sobol_reversed(index_7: u32, dimension: u32) -> u32 {
    var chosen_2: u32;

    // glimt_sampling/src/sobol.rs:44
    let index_21 = (index_7 & 65535u);
    // glimt_sampling/src/sobol.rs:45
    let _e8 = (dimension & 3u);
    if (_e8 == 0u) {
        // glimt_sampling/src/sobol.rs:47
        chosen_2 = index_21;
    } else {
        if (_e8 == 1u) {
            // glimt_sampling/src/sobol.rs:48
            let _e16 = pascal(index_21);
            chosen_2 = _e16;
        } else {
            if (_e8 == 2u) {
                // glimt_sampling/src/sobol.rs:49
                let _e20 = recurrence_2_(index_21);
                chosen_2 = _e20;
            } else {
                // glimt_sampling/src/sobol.rs:50
                let _e22 = recurrence_3_(index_21);
                chosen_2 = _e22;
            }
        }
    }
    let _e23 = chosen_2;
    return _e23;
}

// glimt_sampling/src/sobol.rs:110
fn scramble_1(reversed: u32, dimension_1: u32, seed_3: u32) -> u32 {
    var chosen_3: u32;

    // glimt_sampling/src/sobol.rs:111
    let _e6 = (dimension_1 & 3u);
    if (_e6 == 0u) {
        // glimt_sampling/src/sobol.rs:112
        chosen_3 = 2435803578u;
    } else {
        if (_e6 == 1u) {
            // glimt_sampling/src/sobol.rs:113
            chosen_3 = 391059627u;
        } else {
            if (_e6 == 2u) {
                // glimt_sampling/src/sobol.rs:114
                chosen_3 = 1763603146u;
            } else {
                // glimt_sampling/src/sobol.rs:115
                chosen_3 = 3020734904u;
            }
        }
    }
    let salt = chosen_3;
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
fn OwenSobol_next_u32_(this_15: ptr<function, OwenSobol>) -> u32 {

    // glimt_sampling/src/sobol.rs:184
    let dimension_3 = (*this_15).dimension;
    // glimt_sampling/src/sobol.rs:185
    (*this_15).dimension = (dimension_3 + 1u);
    // glimt_sampling/src/sobol.rs:186
    let _e11 = (*this_15).index;
    let _e13 = (*this_15).seed;
    let _e16 = hash2_(_e13, (dimension_3 >> 2u));
    let _e17 = owen_sobol(_e11, dimension_3, _e16);
    return _e17;
}

// glimt_sampling/src/xoshiro.rs:56
fn Xoshiro128PlusPlus_next_u32_(this_16: ptr<function, Xoshiro128PlusPlus>) -> u32 {

    // glimt_sampling/src/xoshiro.rs:57
    let s_1 = (*this_16).state;
    // glimt_sampling/src/xoshiro.rs:58
    let _e8 = (s_1.x + s_1.w);
    let result = (((_e8 << 7u) | (_e8 >> ((0u - 7u) & 31u))) + s_1.x);
    // glimt_sampling/src/xoshiro.rs:59
    let z_1 = (s_1.z ^ s_1.x);
    // glimt_sampling/src/xoshiro.rs:60
    let w_1 = (s_1.w ^ s_1.y);
    // glimt_sampling/src/xoshiro.rs:61
    (*this_16).state = vec4<u32>((s_1.x ^ w_1), (s_1.y ^ z_1), (z_1 ^ (s_1.y << 9u)), ((w_1 << 11u) | (w_1 >> ((0u - 11u) & 31u))));
    // glimt_sampling/src/xoshiro.rs:62
    return result;
}

// glimt_render_gpu/src/kernels/pattern.rs:171
fn PatternSource_next_u32_(this_17: ptr<function, PatternSource>) -> u32 {
    var chosen_4: u32;
    var borrowed: OwenSobol;
    var borrowed_1: Xoshiro128PlusPlus;

    // glimt_render_gpu/src/kernels/pattern.rs:172
    let _e5 = (*this_17).is_sobol;
    if _e5 {
        // glimt_render_gpu/src/kernels/pattern.rs:173
        let _e9 = (*this_17).point;
        borrowed = _e9;
        let _e10 = OwenSobol_next_u32_((&borrowed));
        let _e11 = borrowed;
        (*this_17).point = _e11;
        chosen_4 = _e10;
    } else {
        // glimt_render_gpu/src/kernels/pattern.rs:175
        let _e15 = (*this_17).generator;
        borrowed_1 = _e15;
        let _e16 = Xoshiro128PlusPlus_next_u32_((&borrowed_1));
        let _e17 = borrowed_1;
        (*this_17).generator = _e17;
        chosen_4 = _e16;
    }
    let _e18 = chosen_4;
    return _e18;
}

// glimt_sampling/src/uniform.rs:15
fn unit_f32_(u: u32) -> f32 {

    // glimt_sampling/src/uniform.rs:16
    return (f32((u >> 8u)) * (1f / 16777216f));
}

// glimt_render_gpu/src/kernels/proposal.rs:381
fn Proposal_is_sharp(this_18: Proposal) -> bool {
    var self_: Proposal;

    self_ = this_18;
    // glimt_render_gpu/src/kernels/proposal.rs:382
    let _e6 = self_.of_.surface;
    let _e7 = is_sharp(_e6);
    return _e7;
}

// glimt_render_gpu/src/kernels/proposal.rs:371
fn Proposal_round_share(this_19: ptr<function, Proposal>, count: u32) {

    // glimt_render_gpu/src/kernels/proposal.rs:372
    let _e5 = (*this_19).lobe_share;
    let lobes_1 = floor(((_e5 * f32(count)) + 0.5f));
    // glimt_render_gpu/src/kernels/proposal.rs:373
    if ((lobes_1 > 0f) && (lobes_1 < f32(count))) {
        // glimt_render_gpu/src/kernels/proposal.rs:374
        (*this_19).lobe_share = (lobes_1 / f32(count));
    }
    return;
}

// glimt_render_gpu/src/kernels/pattern.rs:146
fn PixelPattern_key(this_20: PixelPattern, purpose_3: u32) -> u32 {

    // glimt_render_gpu/src/kernels/pattern.rs:147
    let _e5 = hash2_(this_20.seed, purpose_3);
    let _e8 = hash3_(_e5, this_20.frame, this_20.pixel);
    return _e8;
}

// glimt_render_gpu/src/kernels/pattern.rs:131
fn PixelPattern_ray_key(this_21: PixelPattern, purpose_4: u32) -> u32 {

    // glimt_render_gpu/src/kernels/pattern.rs:132
    let _e4 = PixelPattern_key(this_21, purpose_4);
    let _e6 = hash2_(_e4, this_21.ray);
    return _e6;
}

// glimt_sampling/src/sobol.rs:191
fn OwenSobol_next_uvec2_(this_22: ptr<function, OwenSobol>) -> vec2<u32> {

    // glimt_sampling/src/sobol.rs:192
    let _e4 = (*this_22).dimension;
    let dimension_4 = ((_e4 + 1u) & 4294967294u);
    // glimt_sampling/src/sobol.rs:193
    (*this_22).dimension = (dimension_4 + 2u);
    // glimt_sampling/src/sobol.rs:194
    let _e15 = (*this_22).seed;
    let _e18 = hash2_(_e15, (dimension_4 >> 2u));
    // glimt_sampling/src/sobol.rs:195
    let _e21 = (*this_22).index;
    let _e22 = shuffle(_e21, _e18);
    // glimt_sampling/src/sobol.rs:196
    let _e24 = sobol_reversed(_e22, dimension_4);
    let _e25 = scramble_1(_e24, dimension_4, _e18);
    let _e28 = sobol_reversed(_e22, (dimension_4 + 1u));
    let _e31 = scramble_1(_e28, (dimension_4 + 1u), _e18);
    return vec2<u32>(_e25, _e31);
}

// glimt_sampling/src/uniform.rs:34
fn Xoshiro128PlusPlus_next_uvec2_(this_23: ptr<function, Xoshiro128PlusPlus>) -> vec2<u32> {

    // glimt_sampling/src/uniform.rs:35
    let _e3 = Xoshiro128PlusPlus_next_u32_(this_23);
    // glimt_sampling/src/uniform.rs:36
    let _e5 = Xoshiro128PlusPlus_next_u32_(this_23);
    // glimt_sampling/src/uniform.rs:37
    return vec2<u32>(_e3, _e5);
}

// glimt_render_gpu/src/kernels/pattern.rs:116
fn PixelPattern_point_triple(this_24: PixelPattern, purpose_5: u32, index_9: u32) -> vec3<u32> {
    var point_1: OwenSobol;
    var generator: Xoshiro128PlusPlus;

    // glimt_render_gpu/src/kernels/pattern.rs:117
    if (this_24.kind == 0u) {
        // glimt_render_gpu/src/kernels/pattern.rs:118
        let _e9 = PixelPattern_sobol_point(this_24, purpose_5, index_9);
        point_1 = _e9;
        // glimt_render_gpu/src/kernels/pattern.rs:119
        let _e12 = OwenSobol_next_uvec2_((&point_1));
        // glimt_render_gpu/src/kernels/pattern.rs:120
        let _e14 = OwenSobol_next_u32_((&point_1));
        return vec3<u32>(_e12, _e14);
    }
    // glimt_render_gpu/src/kernels/pattern.rs:122
    let _e17 = PixelPattern_generator(this_24, purpose_5, index_9);
    generator = _e17;
    // glimt_render_gpu/src/kernels/pattern.rs:123
    let _e20 = Xoshiro128PlusPlus_next_uvec2_((&generator));
    // glimt_render_gpu/src/kernels/pattern.rs:124
    let _e22 = Xoshiro128PlusPlus_next_u32_((&generator));
    return vec3<u32>(_e20, _e22);
}

// glimt_sampling/src/uniform.rs:22
fn unit_vec2_(u_1: vec2<u32>) -> vec2<f32> {

    // glimt_sampling/src/uniform.rs:23
    let _e4 = unit_f32_(u_1.x);
    let _e6 = unit_f32_(u_1.y);
    return vec2<f32>(_e4, _e6);
}

// glimt_render_gpu/src/kernels/group_light.rs:165
fn GroupLight_member(env_size_1: vec2<u32>, env_rotation_1: vec2<f32>, cells_size_5: vec2<u32>, cells_start_5: u32, pattern: PixelPattern, rays: f32, threshold_1: f32, group: Group, word_1: u32, points_start_3: u32, points_len_3: u32) -> u32 {

    // glimt_render_gpu/src/kernels/group_light.rs:166
    let _e6 = unit_f32_(word_1);
    let k_3 = u32((_e6 * f32(group.members)));
    // glimt_render_gpu/src/kernels/group_light.rs:167
    let _e16 = Group_ray(group, min(k_3, (group.members - 1u)), points_start_3, points_len_3);
    return _e16;
}

// glimt_sampling/src/math.rs:45
fn ShadingFrame_from_normal(n_2: vec3<f32>) -> ShadingFrame {

    // glimt_sampling/src/math.rs:46
    let sign_ = bitcast<f32>(((bitcast<u32>(1f) & 2147483647u) | (bitcast<u32>(n_2.z) & 2147483648u)));
    // glimt_sampling/src/math.rs:47
    let a_5 = (-1f / (sign_ + n_2.z));
    // glimt_sampling/src/math.rs:48
    let c_2 = ((n_2.x * n_2.y) * a_5);
    // glimt_sampling/src/math.rs:49
    return ShadingFrame(vec3<f32>((1f + (((sign_ * n_2.x) * n_2.x) * a_5)), (sign_ * c_2), (-(sign_) * n_2.x)), vec3<f32>(c_2, (sign_ + ((n_2.y * n_2.y) * a_5)), -(n_2.y)), n_2);
}

// glimt_sampling/src/math.rs:66
fn ShadingFrame_to_local(this_25: ShadingFrame, v_1: vec3<f32>) -> vec3<f32> {

    // glimt_sampling/src/math.rs:67
    return vec3<f32>(dot(v_1, this_25.t), dot(v_1, this_25.b), dot(v_1, this_25.n));
}

// glimt_render_gpu/src/kernels/seen.rs:99
fn SeenPoint_shading_point(this_26: SeenPoint) -> ShadingPoint {

    // glimt_render_gpu/src/kernels/seen.rs:100
    let _e4 = ShadingFrame_from_normal(this_26.normal);
    // glimt_render_gpu/src/kernels/seen.rs:101
    let _e9 = ShadingFrame_to_local(_e4, this_26.wo);
    return ShadingPoint(this_26.origin, this_26.geometric_normal, _e4, _e9, BlinnPhong(this_26.diffuse, this_26.specular, this_26.exponent), this_26.emission);
}

// glimt_render_gpu/src/kernels/group_light.rs:73
fn lobe_of(point_2: ShadingPoint) -> BlinnPhong {

    // glimt_render_gpu/src/kernels/group_light.rs:74
    return BlinnPhong(vec3(0f), point_2.brdf.specular, point_2.brdf.exponent);
}

// glimt_brdf/src/blinn_phong.rs:116
fn BlinnPhong_pmf_specular(this_27: BlinnPhong) -> f32 {
    var chosen_5: f32;

    // glimt_brdf/src/blinn_phong.rs:117
    let _e4 = luminance(this_27.specular);
    // glimt_brdf/src/blinn_phong.rs:118
    let _e7 = luminance(this_27.diffuse);
    let both_4 = (_e7 + _e4);
    // glimt_brdf/src/blinn_phong.rs:119
    if (both_4 > 0f) {
        chosen_5 = (_e4 / both_4);
    } else {
        chosen_5 = 0f;
    }
    let _e15 = chosen_5;
    return _e15;
}

// glimt_sampling/src/warp.rs:190
fn height_of(direction_1: vec3<f32>) -> f32 {
    var chosen_6: f32;

    // glimt_sampling/src/warp.rs:191
    if (direction_1.z > 0f) {
        // glimt_sampling/src/warp.rs:192
        chosen_6 = (((direction_1.x * direction_1.x) + (direction_1.y * direction_1.y)) / (1f + direction_1.z));
    } else {
        // glimt_sampling/src/warp.rs:194
        chosen_6 = (1f - direction_1.z);
    }
    let _e23 = chosen_6;
    return _e23;
}

// glimt_sampling/src/warp.rs:201
fn ln_cos_theta(direction_2: vec3<f32>) -> f32 {

    // glimt_sampling/src/warp.rs:202
    let _e3 = height_of(direction_2);
    // glimt_sampling/src/warp.rs:203
    if (_e3 < 0.1f) {
        // glimt_sampling/src/warp.rs:204
        let tail_1 = ((1f / 3f) + (_e3 * (0.25f + (_e3 * (0.2f + (_e3 * ((1f / 6f) + (_e3 / 7f))))))));
        // glimt_sampling/src/warp.rs:205
        return (0f - (_e3 * (1f + (_e3 * (0.5f + (_e3 * tail_1))))));
    }
    // glimt_sampling/src/warp.rs:207
    return log(direction_2.z);
}

// glimt_sampling/src/warp.rs:289
fn pdf_power_cosine_sr(direction_3: vec3<f32>, exponent_4: f32) -> f32 {
    var chosen_7: f32;

    // glimt_sampling/src/warp.rs:290
    let normalisation_1 = ((exponent_4 + 1f) * (0.5f * 0.31830987f));
    // glimt_sampling/src/warp.rs:291
    if (exponent_4 <= 0f) {
        // glimt_sampling/src/warp.rs:292
        if (direction_3.z >= 0f) {
            // glimt_sampling/src/warp.rs:293
            chosen_7 = normalisation_1;
        } else {
            // glimt_sampling/src/warp.rs:295
            chosen_7 = 0f;
        }
        let _e21 = chosen_7;
        return _e21;
    }
    // glimt_sampling/src/warp.rs:298
    if (direction_3.z <= 0f) {
        // glimt_sampling/src/warp.rs:299
        return 0f;
    }
    // glimt_sampling/src/warp.rs:301
    let _e29 = ln_cos_theta(direction_3);
    return (normalisation_1 * exp((exponent_4 * _e29)));
}

// glimt_sampling/src/warp.rs:182
fn cos_sin_turns(turns: f32) -> vec2<f32> {
    var chosen_8: f32;

    // glimt_sampling/src/warp.rs:183
    if (turns < 0.5f) {
        chosen_8 = turns;
    } else {
        chosen_8 = (turns - 1f);
    }
    let signed = chosen_8;
    // glimt_sampling/src/warp.rs:184
    let phi = (6.2831855f * signed);
    // glimt_sampling/src/warp.rs:185
    return vec2<f32>(cos(phi), sin(phi));
}

// glimt_sampling/src/warp.rs:257
fn sample_power_cosine(u_2: vec2<f32>, exponent_5: f32) -> DirectionSample {
    var sin2_theta_1: f32;
    var cos_theta: f32;

    // glimt_sampling/src/warp.rs:258
    if (u_2.x <= 0f) {
        // glimt_sampling/src/warp.rs:259
        let _e16 = pdf_power_cosine_sr(vec3<f32>(1f, 0f, 0f), exponent_5);
        return DirectionSample(vec3<f32>(1f, 0f, 0f), _e16);
    }
    // glimt_sampling/src/warp.rs:266
    let t_6 = ((2f / (exponent_5 + 1f)) * (0f - log(u_2.x)));
    // glimt_sampling/src/warp.rs:269
    if (t_6 < 0.25f) {
        // glimt_sampling/src/warp.rs:270
        let tail_2 = ((1f / 6f) - (t_6 * ((1f / 24f) - (t_6 * ((1f / 120f) - (t_6 / 720f))))));
        // glimt_sampling/src/warp.rs:271
        sin2_theta_1 = max((t_6 * (1f - (t_6 * (0.5f - (t_6 * tail_2))))), 0f);
        // glimt_sampling/src/warp.rs:272
        let _e62 = sin2_theta_1;
        cos_theta = sqrt((1f - _e62));
    } else {
        // glimt_sampling/src/warp.rs:274
        cos_theta = exp((-0.5f * t_6));
        // glimt_sampling/src/warp.rs:275
        let _e71 = cos_theta;
        let _e72 = cos_theta;
        sin2_theta_1 = (1f - (_e71 * _e72));
    }
    // glimt_sampling/src/warp.rs:277
    let _e76 = sin2_theta_1;
    let sin_theta = sqrt(_e76);
    // glimt_sampling/src/warp.rs:278
    let _e80 = cos_sin_turns(u_2.y);
    // glimt_sampling/src/warp.rs:279
    let _e86 = cos_theta;
    let direction_10 = vec3<f32>((sin_theta * _e80.x), (sin_theta * _e80.y), _e86);
    // glimt_sampling/src/warp.rs:280
    let _e89 = pdf_power_cosine_sr(direction_10, exponent_5);
    return DirectionSample(direction_10, _e89);
}

// glimt_sampling/src/warp.rs:31
fn sample_concentric_disk(u_3: vec2<f32>) -> vec2<f32> {

    // glimt_sampling/src/warp.rs:32
    let a_6 = ((2f * u_3.x) - 1f);
    // glimt_sampling/src/warp.rs:33
    let b_2 = ((2f * u_3.y) - 1f);
    // glimt_sampling/src/warp.rs:34
    if ((a_6 == 0f) && (b_2 == 0f)) {
        // glimt_sampling/src/warp.rs:35
        return vec2(0f);
    }
    // glimt_sampling/src/warp.rs:37
    if ((a_6 * a_6) > (b_2 * b_2)) {
        // glimt_sampling/src/warp.rs:38
        let phi_1 = (0.7853982f * (b_2 / a_6));
        // glimt_sampling/src/warp.rs:39
        return vec2<f32>((a_6 * cos(phi_1)), (a_6 * sin(phi_1)));
    }
    // glimt_sampling/src/warp.rs:41
    let phi_2 = (0.7853982f * (a_6 / b_2));
    // glimt_sampling/src/warp.rs:42
    return vec2<f32>((b_2 * sin(phi_2)), (b_2 * cos(phi_2)));
}

// glimt_sampling/src/warp.rs:88
fn sample_cosine_hemisphere(u_4: vec2<f32>) -> DirectionSample {

    // glimt_sampling/src/warp.rs:89
    let _e3 = sample_concentric_disk(u_4);
    // glimt_sampling/src/warp.rs:92
    let _e10 = abs(((2f * u_4) - vec2(1f)));
    let r_2 = max(_e10.x, _e10.y);
    // glimt_sampling/src/warp.rs:93
    let z_2 = sqrt(((1f - r_2) * (1f + r_2)));
    // glimt_sampling/src/warp.rs:94
    return DirectionSample(vec3<f32>(_e3, z_2), (z_2 * 0.31830987f));
}

// glimt_sampling/src/warp.rs:103
fn pdf_cosine_hemisphere_sr(direction_4: vec3<f32>) -> f32 {

    // glimt_sampling/src/warp.rs:104
    return (max(direction_4.z, 0f) * 0.31830987f);
}

// glimt_brdf/src/lobe.rs:20
fn HalfVector_new(wo_2: vec3<f32>, wi: vec3<f32>) -> HalfVector {

    // glimt_brdf/src/lobe.rs:21
    let sum_3 = (wo_2 + wi);
    // glimt_brdf/src/lobe.rs:23
    let length2_ = max(dot(sum_3, sum_3), 0.00000000000000000001f);
    // glimt_brdf/src/lobe.rs:24
    return HalfVector(((sum_3.z * sum_3.z) / length2_), (((sum_3.x * sum_3.x) + (sum_3.y * sum_3.y)) / length2_), (0.5f * sqrt(length2_)));
}

// glimt_brdf/src/lobe.rs:59
fn cosine_power(cos2_theta: f32, sin2_theta_2: f32, exponent_6: f32) -> f32 {
    var chosen_9: f32;

    // glimt_brdf/src/lobe.rs:60
    if (sin2_theta_2 < (1f / 16f)) {
        // glimt_brdf/src/lobe.rs:62
        let t_7 = (sin2_theta_2 / (2f - sin2_theta_2));
        // glimt_brdf/src/lobe.rs:63
        let t2_ = (t_7 * t_7);
        // glimt_brdf/src/lobe.rs:64
        chosen_9 = ((-2f * t_7) * (1f + (t2_ * ((1f / 3f) + (t2_ * (1f / 5f))))));
    } else {
        // glimt_brdf/src/lobe.rs:66
        chosen_9 = log(max(cos2_theta, 0.0000000000000000000000000000000000001f));
    }
    let log_cos2_ = chosen_9;
    // glimt_brdf/src/lobe.rs:68
    let log_power = ((0.5f * exponent_6) * log_cos2_);
    // glimt_brdf/src/lobe.rs:69
    if (log_power < -85f) {
        // glimt_brdf/src/lobe.rs:70
        return 0f;
    }
    // glimt_brdf/src/lobe.rs:72
    return exp(log_power);
}

// glimt_brdf/src/lobe.rs:32
fn HalfVector_lobe(this_28: HalfVector, exponent_7: f32) -> f32 {

    // glimt_brdf/src/lobe.rs:33
    let _e6 = cosine_power(this_28.cos2_theta, this_28.sin2_theta, exponent_7);
    return _e6;
}

// glimt_brdf/src/lobe.rs:37
fn HalfVector_pdf_sr(this_29: HalfVector, exponent_8: f32) -> f32 {

    // glimt_brdf/src/lobe.rs:38
    let _e10 = HalfVector_lobe(this_29, exponent_8);
    return ((((exponent_8 + 1f) * (0.5f * 0.31830987f)) * _e10) / (4f * this_29.wo_dot_h));
}

// glimt_brdf/src/blinn_phong.rs:99
fn BlinnPhong_pdf_sr(this_30: BlinnPhong, wo_3: vec3<f32>, wi_1: vec3<f32>) -> f32 {

    // glimt_brdf/src/blinn_phong.rs:100
    if ((wo_3.z <= 0f) || (wi_1.z <= 0f)) {
        // glimt_brdf/src/blinn_phong.rs:101
        return 0f;
    }
    // glimt_brdf/src/blinn_phong.rs:103
    let _e15 = pdf_cosine_hemisphere_sr(wi_1);
    // glimt_brdf/src/blinn_phong.rs:104
    let _e17 = BlinnPhong_pmf_specular(this_30);
    // glimt_brdf/src/blinn_phong.rs:105
    if (_e17 <= 0f) {
        // glimt_brdf/src/blinn_phong.rs:106
        return _e15;
    }
    // glimt_brdf/src/blinn_phong.rs:108
    let _e23 = HalfVector_new(wo_3, wi_1);
    let _e25 = HalfVector_pdf_sr(_e23, this_30.exponent);
    // glimt_brdf/src/blinn_phong.rs:109
    return ((_e17 * _e25) + ((1f - _e17) * _e15));
}

// glimt_brdf/src/blinn_phong.rs:80
fn BlinnPhong_sample(this_31: BlinnPhong, wo_4: vec3<f32>, u_lobe: u32, u_5: vec2<f32>) -> BrdfSample {
    var chosen_10: vec3<f32>;

    // glimt_brdf/src/blinn_phong.rs:81
    let _e7 = unit_f32_(u_lobe);
    let _e8 = BlinnPhong_pmf_specular(this_31);
    if (_e7 < _e8) {
        // glimt_brdf/src/blinn_phong.rs:82
        let _e12 = sample_power_cosine(u_5, this_31.exponent);
        let h = _e12.direction;
        // glimt_brdf/src/blinn_phong.rs:83
        chosen_10 = (((2f * dot(wo_4, h)) * h) - wo_4);
    } else {
        // glimt_brdf/src/blinn_phong.rs:85
        let _e21 = sample_cosine_hemisphere(u_5);
        chosen_10 = _e21.direction;
    }
    let wi_4 = chosen_10;
    // glimt_brdf/src/blinn_phong.rs:87
    let _e25 = BlinnPhong_pdf_sr(this_31, wo_4, wi_4);
    return BrdfSample(wi_4, _e25);
}

// glimt_sampling/src/math.rs:59
fn ShadingFrame_to_world(this_32: ShadingFrame, v_2: vec3<f32>) -> vec3<f32> {

    // glimt_sampling/src/math.rs:60
    return (((this_32.t * v_2.x) + (this_32.b * v_2.y)) + (this_32.n * v_2.z));
}

// glimt_probe/src/latlong.rs:45
fn direction_to_uv(d_1: vec3<f32>) -> vec2<f32> {
    var chosen_11: f32;
    var chosen_12: f32;

    // glimt_probe/src/latlong.rs:46
    let horizontal = sqrt(((d_1.x * d_1.x) + (d_1.y * d_1.y)));
    // glimt_probe/src/latlong.rs:47
    if (horizontal <= 0f) {
        // glimt_probe/src/latlong.rs:48
        if (d_1.z < 0f) {
            chosen_11 = 1f;
        } else {
            chosen_11 = 0f;
        }
        let v_6 = chosen_11;
        // glimt_probe/src/latlong.rs:49
        return vec2<f32>(0.5f, v_6);
    }
    // glimt_probe/src/latlong.rs:52
    let v_7 = (atan2(horizontal, d_1.z) * 0.31830987f);
    // glimt_probe/src/latlong.rs:53
    let u_12 = (0.5f - ((0.5f * 0.31830987f) * atan2(d_1.y, d_1.x)));
    // glimt_probe/src/latlong.rs:54
    if (u_12 < 1f) {
        chosen_12 = max(u_12, 0f);
    } else {
        chosen_12 = 0f;
    }
    let _e47 = chosen_12;
    return vec2<f32>(_e47, clamp(v_7, 0f, 1f));
}

// glimt_probe/src/latlong.rs:68
fn direction_to_texel(d_2: vec3<f32>, size_4: vec2<u32>) -> vec2<u32> {

    // glimt_probe/src/latlong.rs:69
    let size_22 = max(size_4, vec2(1u));
    // glimt_probe/src/latlong.rs:70
    let _e8 = direction_to_uv(d_2);
    let position = (_e8 * vec2<f32>(size_22));
    // glimt_probe/src/latlong.rs:71
    return min(vec2<u32>(position), (size_22 - vec2(1u)));
}

// glimt_render_gpu/src/kernels/environment.rs:96
fn Environment_texel(size_5: vec2<u32>, rotation_2: vec2<f32>, direction_5: vec3<f32>) -> vec2<u32> {

    // glimt_render_gpu/src/kernels/environment.rs:97
    let _e5 = Environment_to_map(size_5, rotation_2, direction_5);
    let _e6 = direction_to_texel(_e5, size_5);
    return _e6;
}

// glimt_envmap_cdf/src/search.rs:31
fn find_bin(start_2: u32, bins: u32, u_6: u32) -> Bin {
    var at: u32;
    var left: u32;

    // glimt_envmap_cdf/src/search.rs:33
    at = start_2;
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
        if (_e22 <= u_6) {
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
    let first_8 = env_tables[_e31];
    // glimt_envmap_cdf/src/search.rs:43
    let _e36 = at;
    let _e38 = at;
    let _e43 = env_tables[(_e38 + 1u)];
    return Bin((_e36 - start_2), first_8, (_e43 - first_8));
}

// glimt_light_cells/src/partition.rs:100
fn column_of(x_6: u32, width: u32) -> u32 {

    // glimt_light_cells/src/partition.rs:101
    return (((32u * (x_6 + 1u)) - 1u) / width);
}

// glimt_light_cells/src/partition.rs:134
fn LightCells_cell_of(size_6: vec2<u32>, start_3: u32, texel: vec2<u32>) -> u32 {

    // glimt_light_cells/src/partition.rs:135
    let _e7 = find_bin(start_3, 16u, texel.y);
    let row_4 = _e7.index;
    // glimt_light_cells/src/partition.rs:136
    let _e14 = column_of(texel.x, size_6.x);
    return ((row_4 * 32u) + _e14);
}

// glimt_render_gpu/src/kernels/proposal.rs:81
fn CellAt_new(lane: u32, weight: vec4<f32>, flux_4: vec4<f32>, terms_5: CellTerms, visibility_3: vec4<f32>) -> CellAt {

    // glimt_render_gpu/src/kernels/proposal.rs:82
    return CellAt(weight[lane], (flux_4 * terms_5.live)[lane], terms_5.cosine[lane], (terms_5.full[lane] > 0.5f), terms_5.lobe[lane], visibility_3[lane]);
}

// glimt_render_gpu/src/kernels/proposal.rs:388
fn Proposal_cell(this_33: Proposal, cell: u32, cells_size_6: vec2<u32>, cells_start_6: u32, expected_first_2: u32, expected_slot_2: u32) -> CellAt {
    var self_1: Proposal;

    self_1 = this_33;
    // glimt_render_gpu/src/kernels/proposal.rs:389
    let quad_8 = (cell / 4u);
    // glimt_render_gpu/src/kernels/proposal.rs:390
    let _e13 = LightCells_quad(cells_size_6, cells_start_6, 0u, quad_8);
    // glimt_render_gpu/src/kernels/proposal.rs:391
    let _e17 = self_1.of_.surface;
    let _e18 = LightCells_terms(cells_size_6, cells_start_6, _e17, quad_8);
    // glimt_render_gpu/src/kernels/proposal.rs:392
    let _e20 = Expected_quad(expected_first_2, expected_slot_2, quad_8);
    // glimt_render_gpu/src/kernels/proposal.rs:393
    let _e24 = self_1.of_.surface;
    let _e26 = self_1.is_catcher;
    let _e27 = weights(_e24, _e18, _e13, _e20, _e26);
    // glimt_render_gpu/src/kernels/proposal.rs:394
    let _e31 = CellAt_new((cell % 4u), _e27, _e13, _e18, _e20);
    return _e31;
}

// glimt_render_gpu/src/kernels/group_light.rs:194
fn GroupLight_look_by_lobe(env_size_2: vec2<u32>, env_rotation_2: vec2<f32>, cells_size_7: vec2<u32>, cells_start_7: u32, pattern_1: PixelPattern, rays_1: f32, threshold_2: f32, group_1: Group, proposal: Proposal, expected_first_3: u32, expected_slot_3: u32, index_10: u32, points_start_4: u32, points_len_4: u32) -> Look {
    var proposal_1: Proposal;

    proposal_1 = proposal;
    // glimt_render_gpu/src/kernels/group_light.rs:202
    let _e18 = PixelPattern_point_triple(pattern_1, 11u, index_10);
    // glimt_render_gpu/src/kernels/group_light.rs:203
    let _e21 = unit_vec2_(_e18.xy);
    // glimt_render_gpu/src/kernels/group_light.rs:204
    let _e24 = GroupLight_member(env_size_2, env_rotation_2, cells_size_7, cells_start_7, pattern_1, rays_1, threshold_2, group_1, _e18.z, points_start_4, points_len_4);
    // glimt_render_gpu/src/kernels/group_light.rs:205
    let _e29 = points[(points_start_4 + _e24)];
    let _e30 = SeenPoint_shading_point(_e29);
    // glimt_render_gpu/src/kernels/group_light.rs:206
    let _e32 = lobe_of(_e30);
    let _e35 = BlinnPhong_sample(_e32, _e30.wo, 0u, _e21);
    // glimt_render_gpu/src/kernels/group_light.rs:207
    let _e39 = ShadingFrame_to_world(_e30.frame, _e35.wi);
    // glimt_render_gpu/src/kernels/group_light.rs:208
    let _e41 = Environment_texel(env_size_2, env_rotation_2, _e39);
    // glimt_render_gpu/src/kernels/group_light.rs:209
    let _e43 = LightCells_cell_of(cells_size_7, cells_start_7, _e41);
    // glimt_render_gpu/src/kernels/group_light.rs:210
    let _e45 = Environment_to_map(env_size_2, env_rotation_2, _e39);
    let _e46 = proposal_1;
    let _e47 = Proposal_cell(_e46, _e43, cells_size_7, cells_start_7, expected_first_3, expected_slot_3);
    return Look(_e45, _e39, _e41, _e47, _e43, _e24, (_e35.pdf_sr > 0f));
}

// glimt_render_gpu/src/kernels/proposal.rs:498
fn Place_new(target_: f32) -> Place {

    // glimt_render_gpu/src/kernels/proposal.rs:499
    return Place(target_, 0f, 0u, 0f, 0f, false);
}

// glimt_render_gpu/src/kernels/proposal.rs:511
fn Place_offer(this_34: ptr<function, Place>, index_11: u32, width_1: f32) {

    // glimt_render_gpu/src/kernels/proposal.rs:512
    let _e8 = (*this_34).is_found;
    if ((width_1 > 0f) && !(_e8)) {
        // glimt_render_gpu/src/kernels/proposal.rs:513
        (*this_34).index = index_11;
        // glimt_render_gpu/src/kernels/proposal.rs:514
        let _e15 = (*this_34).sum;
        (*this_34).first = _e15;
        // glimt_render_gpu/src/kernels/proposal.rs:515
        (*this_34).width = width_1;
    }
    // glimt_render_gpu/src/kernels/proposal.rs:517
    let _e21 = (*this_34).sum;
    (*this_34).sum = (_e21 + width_1);
    // glimt_render_gpu/src/kernels/proposal.rs:518
    let _e25 = (*this_34).is_found;
    let _e27 = (*this_34).sum;
    let _e29 = (*this_34).target_;
    (*this_34).is_found = (_e25 || (_e27 > _e29));
    return;
}

// glimt_render_gpu/src/kernels/proposal.rs:524
fn Place_word(this_35: Place, whole: f32, fraction: u32) -> u32 {

    // glimt_render_gpu/src/kernels/proposal.rs:525
    let unit_1 = (whole * (1f / 16777216f));
    // glimt_render_gpu/src/kernels/proposal.rs:526
    let fine = ((this_35.target_ - this_35.first) + (unit_1 * (f32(fraction) * (1f / 65536f))));
    // glimt_render_gpu/src/kernels/proposal.rs:527
    let place_2 = clamp((fine / max(this_35.width, 0.000000000000000000000000000000000000011754944f)), 0f, 0.99999994f);
    // glimt_render_gpu/src/kernels/proposal.rs:528
    return ((u32((place_2 * 16777216f)) << 8u) | (fraction & 255u));
}

// glimt_light_cells/src/partition.rs:141
fn LightCells_texel_rows(size_7: vec2<u32>, start_4: u32, row: u32) -> vec2<u32> {

    // glimt_light_cells/src/partition.rs:142
    let at_6 = (start_4 + row);
    // glimt_light_cells/src/partition.rs:143
    let _e8 = env_tables[at_6];
    let _e13 = env_tables[(at_6 + 1u)];
    return vec2<u32>(_e8, _e13);
}

// glimt_light_cells/src/partition.rs:74
fn first_row_word() -> u32 {

    // glimt_light_cells/src/partition.rs:75
    return (32u + (20u * 512u));
}

// glimt_light_cells/src/partition.rs:148
fn LightCells_row_edges(size_8: vec2<u32>, start_5: u32, cell_1: u32, rows_1: vec2<u32>) -> u32 {

    // glimt_light_cells/src/partition.rs:149
    let _e9 = Tuple_u32_u32_((cell_1 % 32u), (cell_1 / 32u));
    let column_1 = _e9.fa;
    let row_5 = _e9.fb;
    // glimt_light_cells/src/partition.rs:150
    let of_band = (32u * (rows_1.x + row_5));
    // glimt_light_cells/src/partition.rs:151
    let _e18 = first_row_word();
    return (((start_5 + _e18) + of_band) + (column_1 * ((rows_1.y - rows_1.x) + 1u)));
}

// glimt_light_cells/src/partition.rs:93
fn first_column(column: u32, width_2: u32) -> u32 {

    // glimt_light_cells/src/partition.rs:94
    return ((column * width_2) / 32u);
}

// glimt_light_cells/src/partition.rs:106
fn column_unit(u_7: u32) -> u32 {

    // glimt_light_cells/src/partition.rs:107
    return (u_7 >> 17u);
}

// glimt_light_cells/src/partition.rs:80
fn first_column_word(size_9: vec2<u32>) -> u32 {

    // glimt_light_cells/src/partition.rs:81
    let _e3 = first_row_word();
    return (_e3 + (32u * (size_9.y + 16u)));
}

// glimt_light_cells/src/partition.rs:86
fn column_words(width_3: u32) -> u32 {

    // glimt_light_cells/src/partition.rs:87
    let _e4 = (width_3 / 2u);
    return select(_e4, (_e4 + 1u), ((width_3 % 2u) != 0u));
}

// glimt_light_cells/src/partition.rs:156
fn LightCells_column_edge(size_10: vec2<u32>, start_6: u32, x_7: u32, y_1: u32) -> u32 {

    // glimt_light_cells/src/partition.rs:157
    let _e6 = first_column_word(size_10);
    let _e9 = column_words(size_10.x);
    let at_7 = (((start_6 + _e6) + (y_1 * _e9)) + (x_7 / 2u));
    // glimt_light_cells/src/partition.rs:158
    let _e18 = env_tables[at_7];
    return ((_e18 >> ((16u * (x_7 & 1u)) & 31u)) & 65535u);
}

// glimt_light_cells/src/partition.rs:210
fn LightCells_pmf(size_11: vec2<u32>, start_7: u32, row_1: Bin, texel_1: vec2<u32>, first_4: u32) -> f32 {
    var chosen_13: u32;

    // glimt_light_cells/src/partition.rs:211
    if (texel_1.x > first_4) {
        // glimt_light_cells/src/partition.rs:212
        let _e15 = LightCells_column_edge(size_11, start_7, (texel_1.x - 1u), texel_1.y);
        chosen_13 = _e15;
    } else {
        // glimt_light_cells/src/partition.rs:214
        chosen_13 = 0u;
    }
    let lower = chosen_13;
    // glimt_light_cells/src/partition.rs:216
    let _e22 = LightCells_column_edge(size_11, start_7, texel_1.x, texel_1.y);
    let units = (_e22 - lower);
    // glimt_light_cells/src/partition.rs:217
    return ((f32(row_1.units) * (1f / 2147483600f)) * (f32(units) * (1f / 32768f)));
}

// glimt_light_cells/src/partition.rs:164
fn LightCells_sample(size_12: vec2<u32>, start_8: u32, cell_2: u32, u_8: vec2<u32>) -> TexelDraw {
    var at_1: u32;
    var left_1: u32;

    // glimt_light_cells/src/partition.rs:165
    let _e8 = LightCells_texel_rows(size_12, start_8, (cell_2 / 32u));
    // glimt_light_cells/src/partition.rs:166
    let _e10 = LightCells_row_edges(size_12, start_8, cell_2, _e8);
    // glimt_light_cells/src/partition.rs:167
    let _e18 = find_bin(_e10, (_e8.y - _e8.x), (u_8.y >> 1u));
    // glimt_light_cells/src/partition.rs:173
    let y_3 = (_e8.x + _e18.index);
    // glimt_light_cells/src/partition.rs:174
    let column_2 = (cell_2 % 32u);
    // glimt_light_cells/src/partition.rs:175
    let _e28 = first_column(column_2, size_12.x);
    // glimt_light_cells/src/partition.rs:177
    let _e31 = column_unit(u_8.x);
    // glimt_light_cells/src/partition.rs:178
    at_1 = _e28;
    // glimt_light_cells/src/partition.rs:179
    let _e38 = first_column((column_2 + 1u), size_12.x);
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
        let _e51 = at_1;
        let _e55 = LightCells_column_edge(size_12, start_8, ((_e51 + half_1) - 1u), y_3);
        if (_e55 <= _e31) {
            // glimt_light_cells/src/partition.rs:183
            let _e58 = at_1;
            at_1 = (_e58 + half_1);
        }
        // glimt_light_cells/src/partition.rs:185
        let _e61 = left_1;
        left_1 = (_e61 - half_1);
    }
    // glimt_light_cells/src/partition.rs:187
    let _e64 = at_1;
    let _e66 = at_1;
    let _e68 = LightCells_pmf(size_12, start_8, _e18, vec2<u32>(_e66, y_3), _e28);
    return TexelDraw(vec2<u32>(_e64, y_3), _e68);
}

// glimt_probe/src/trig.rs:25
fn cos_sin_pi(x_8: f32) -> vec2<f32> {
    var chosen_14: vec2<f32>;

    // glimt_probe/src/trig.rs:27
    let quarter = floor(((2f * x_8) + 0.5f));
    // glimt_probe/src/trig.rs:28
    let y_4 = (x_8 - (0.5f * quarter));
    // glimt_probe/src/trig.rs:29
    let y2_ = (y_4 * y_4);
    // glimt_probe/src/trig.rs:31
    let c_3 = (1f + (y2_ * (-4.934802f + (y2_ * (4.058712f + (y2_ * (-1.3352627f + (y2_ * (0.23533063f + (y2_ * -0.02580689f))))))))));
    // glimt_probe/src/trig.rs:34
    let s_2 = (y_4 * (3.1415927f + (y2_ * (-5.1677127f + (y2_ * (2.550164f + (y2_ * (-0.5992645f + (y2_ * 0.082145885f)))))))));
    // glimt_probe/src/trig.rs:37
    let _e49 = (i32(quarter) & 3i);
    if (_e49 == 0i) {
        // glimt_probe/src/trig.rs:38
        chosen_14 = vec2<f32>(c_3, (s_2 + 0f));
    } else {
        if (_e49 == 1i) {
            // glimt_probe/src/trig.rs:39
            chosen_14 = vec2<f32>((0f - s_2), c_3);
        } else {
            if (_e49 == 2i) {
                // glimt_probe/src/trig.rs:40
                chosen_14 = vec2<f32>((0f - c_3), (0f - s_2));
            } else {
                // glimt_probe/src/trig.rs:41
                chosen_14 = vec2<f32>((s_2 + 0f), (0f - c_3));
            }
        }
    }
    let _e77 = chosen_14;
    return _e77;
}

// glimt_probe/src/latlong.rs:142
fn direction_in_texel(texel_2: vec2<u32>, size_13: vec2<u32>, r: vec2<f32>) -> vec3<f32> {
    var chosen_15: u32;
    var chosen_16: u32;
    var chosen_17: f32;

    // glimt_probe/src/latlong.rs:143
    let size_23 = max(size_13, vec2(1u));
    // glimt_probe/src/latlong.rs:144
    let row_6 = min(texel_2.y, (size_23.y - 1u));
    // glimt_probe/src/latlong.rs:146
    let southern = ((2u * row_6) >= size_23.y);
    // glimt_probe/src/latlong.rs:147
    if southern {
        chosen_15 = (size_23.y - row_6);
    } else {
        chosen_15 = row_6;
    }
    let upper = chosen_15;
    // glimt_probe/src/latlong.rs:148
    if southern {
        chosen_16 = ((size_23.y - row_6) - 1u);
    } else {
        chosen_16 = (row_6 + 1u);
    }
    let lower_1 = chosen_16;
    // glimt_probe/src/latlong.rs:149
    let half_2 = (0.5f / f32(size_23.y));
    // glimt_probe/src/latlong.rs:150
    let _e41 = cos_sin_pi((f32(upper) * half_2));
    let sin_upper = _e41.y;
    // glimt_probe/src/latlong.rs:151
    let _e46 = cos_sin_pi((f32(lower_1) * half_2));
    let sin_lower = _e46.y;
    // glimt_probe/src/latlong.rs:152
    let s_upper = (sin_upper * sin_upper);
    // glimt_probe/src/latlong.rs:153
    let s_3 = (s_upper + (((sin_lower * sin_lower) - s_upper) * r.y));
    // glimt_probe/src/latlong.rs:154
    let sin_theta_1 = (2f * sqrt(max((s_3 * (1f - s_3)), 0f)));
    // glimt_probe/src/latlong.rs:155
    if southern {
        // glimt_probe/src/latlong.rs:156
        chosen_17 = ((2f * s_3) - 1f);
    } else {
        // glimt_probe/src/latlong.rs:158
        chosen_17 = (1f - (2f * s_3));
    }
    let cos_theta_1 = chosen_17;
    // glimt_probe/src/latlong.rs:160
    let _e90 = cos_sin_pi((1f - ((2f * (f32(texel_2.x) + r.x)) / f32(size_23.x))));
    // glimt_probe/src/latlong.rs:161
    return vec3<f32>((sin_theta_1 * _e90.x), (sin_theta_1 * _e90.y), cos_theta_1);
}

// glimt_render_gpu/src/kernels/proposal.rs:432
fn Proposal_sample_cells(this_36: Proposal, u_9: vec2<u32>, cells_size_8: vec2<u32>, cells_start_8: u32, expected_first_4: u32, expected_slot_4: u32) -> CellDraw {
    var self_2: Proposal;
    var row_place: Place;
    var counter_9: u32;
    var quad_place: Place;
    var counter_10: u32;
    var cell_place: Place;

    self_2 = this_36;
    // glimt_render_gpu/src/kernels/proposal.rs:439
    let _e10 = unit_f32_(u_9.y);
    let _e12 = self_2.total;
    let _e14 = Place_new((_e10 * _e12));
    row_place = _e14;
    // glimt_render_gpu/src/kernels/proposal.rs:440
    counter_9 = 0u;
    loop {
        let row_7 = counter_9;
        if (row_7 >= 16u) {
            break;
        }
        // glimt_render_gpu/src/kernels/proposal.rs:441
        let _e25 = self_2.rows[row_7];
        Place_offer((&row_place), row_7, _e25);
        continuing {
            let _e26 = counter_9;
            counter_9 = (_e26 + 1u);
        }
    }
    // glimt_render_gpu/src/kernels/proposal.rs:443
    let _e31 = row_place.index;
    let first_9 = (_e31 * 8u);
    // glimt_render_gpu/src/kernels/proposal.rs:444
    let _e36 = unit_f32_(u_9.x);
    let _e38 = row_place.width;
    let target_1 = (_e36 * _e38);
    // glimt_render_gpu/src/kernels/proposal.rs:445
    let _e41 = Place_new(target_1);
    quad_place = _e41;
    // glimt_render_gpu/src/kernels/proposal.rs:446
    counter_10 = first_9;
    loop {
        let quad_9 = counter_10;
        if (quad_9 >= (first_9 + 8u)) {
            break;
        }
        // glimt_render_gpu/src/kernels/proposal.rs:447
        let _e52 = self_2.quads[quad_9];
        Place_offer((&quad_place), quad_9, _e52);
        continuing {
            let _e53 = counter_10;
            counter_10 = (_e53 + 1u);
        }
    }
    // glimt_render_gpu/src/kernels/proposal.rs:449
    let quad_10 = quad_place.index;
    // glimt_render_gpu/src/kernels/proposal.rs:450
    let _e61 = LightCells_quad(cells_size_8, cells_start_8, 0u, quad_10);
    // glimt_render_gpu/src/kernels/proposal.rs:451
    let _e65 = self_2.of_.surface;
    let _e66 = LightCells_terms(cells_size_8, cells_start_8, _e65, quad_10);
    // glimt_render_gpu/src/kernels/proposal.rs:452
    let _e68 = Expected_quad(expected_first_4, expected_slot_4, quad_10);
    // glimt_render_gpu/src/kernels/proposal.rs:453
    let surface_4 = self_2.of_.surface;
    // glimt_render_gpu/src/kernels/proposal.rs:454
    let _e75 = self_2.is_catcher;
    let _e76 = weights(surface_4, _e66, _e61, _e68, _e75);
    // glimt_render_gpu/src/kernels/proposal.rs:455
    let _e81 = self_2.defence;
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
    let cell_6 = ((4u * quad_10) + lane_1);
    // glimt_render_gpu/src/kernels/proposal.rs:466
    let _e117 = hash2_(u_9.x, u_9.y);
    // glimt_render_gpu/src/kernels/proposal.rs:467
    let _e119 = cell_place;
    let _e121 = row_place.width;
    let _e124 = Place_word(_e119, _e121, (_e117 & 65535u));
    let _e125 = row_place;
    let _e127 = self_2.total;
    let _e130 = Place_word(_e125, _e127, (_e117 >> 16u));
    let within = vec2<u32>(_e124, _e130);
    // glimt_render_gpu/src/kernels/proposal.rs:471
    let _e133 = LightCells_sample(cells_size_8, cells_start_8, cell_6, within);
    // glimt_render_gpu/src/kernels/proposal.rs:472
    let _e136 = hash2_(_e117, u_9.x);
    // glimt_render_gpu/src/kernels/proposal.rs:473
    let place_3 = vec2<u32>((_e136 << 16u), (_e136 & 4294901760u));
    // glimt_render_gpu/src/kernels/proposal.rs:474
    let _e145 = unit_vec2_(place_3);
    let _e146 = direction_in_texel(_e133.texel, cells_size_8, _e145);
    let _e148 = CellAt_new(lane_1, _e76, _e61, _e66, _e68);
    return CellDraw(_e148, _e146, _e133.texel, cell_6);
}

// glimt_render_gpu/src/kernels/group_light.rs:171
fn GroupLight_look_by_cells(env_size_3: vec2<u32>, env_rotation_3: vec2<f32>, cells_size_9: vec2<u32>, cells_start_9: u32, pattern_2: PixelPattern, rays_2: f32, threshold_3: f32, group_2: Group, proposal_2: Proposal, expected_first_5: u32, expected_slot_5: u32, index_12: u32, points_start_5: u32, points_len_5: u32) -> Look {
    var proposal_3: Proposal;

    proposal_3 = proposal_2;
    // glimt_render_gpu/src/kernels/group_light.rs:179
    let _e18 = PixelPattern_point_triple(pattern_2, 10u, index_12);
    // glimt_render_gpu/src/kernels/group_light.rs:180
    let _e21 = GroupLight_member(env_size_3, env_rotation_3, cells_size_9, cells_start_9, pattern_2, rays_2, threshold_3, group_2, _e18.z, points_start_5, points_len_5);
    // glimt_render_gpu/src/kernels/group_light.rs:181
    let _e23 = proposal_3;
    let _e25 = Proposal_sample_cells(_e23, _e18.xy, cells_size_9, cells_start_9, expected_first_5, expected_slot_5);
    // glimt_render_gpu/src/kernels/group_light.rs:182
    let _e29 = rotate_z(_e25.direction, env_rotation_3);
    return Look(_e25.direction, _e29, _e25.texel, _e25.at, _e25.cell, _e21, true);
}

// glimt_light_cells/src/partition.rs:196
fn LightCells_pmf_in_cell(size_14: vec2<u32>, start_9: u32, texel_3: vec2<u32>, cell_3: u32) -> f32 {

    // glimt_light_cells/src/partition.rs:197
    let _e8 = LightCells_texel_rows(size_14, start_9, (cell_3 / 32u));
    // glimt_light_cells/src/partition.rs:198
    let _e10 = LightCells_row_edges(size_14, start_9, cell_3, _e8);
    let at_8 = ((_e10 + texel_3.y) - _e8.x);
    // glimt_light_cells/src/partition.rs:199
    let _e22 = env_tables[(at_8 + 1u)];
    let _e25 = env_tables[at_8];
    let of_row_1 = Bin(0u, 0u, (_e22 - _e25));
    // glimt_light_cells/src/partition.rs:204
    let _e32 = first_column((cell_3 % 32u), size_14.x);
    // glimt_light_cells/src/partition.rs:205
    let _e34 = LightCells_pmf(size_14, start_9, of_row_1, texel_3, _e32);
    return _e34;
}

// glimt_probe/src/latlong.rs:121
fn texel_solid_angle_sr(row_2: u32, size_15: vec2<u32>) -> f32 {

    // glimt_probe/src/latlong.rs:122
    let size_24 = max(size_15, vec2(1u));
    // glimt_probe/src/latlong.rs:123
    let row_8 = min(row_2, (size_24.y - 1u));
    // glimt_probe/src/latlong.rs:124
    let from_pole = min(row_8, ((size_24.y - 1u) - row_8));
    // glimt_probe/src/latlong.rs:125
    let half_row = (0.5f / f32(size_24.y));
    // glimt_probe/src/latlong.rs:126
    let middle = (f32(((2u * from_pole) + 1u)) * half_row);
    // glimt_probe/src/latlong.rs:127
    let _e37 = cos_sin_pi(middle);
    let _e40 = cos_sin_pi(half_row);
    return ((((4f * 3.1415927f) / f32(size_24.x)) * _e37.y) * _e40.y);
}

// glimt_render_gpu/src/kernels/proposal.rs:400
fn Proposal_cells_pdf_sr(this_37: Proposal, texel_4: vec2<u32>, cell_4: u32, at_2: CellAt, cells_size_10: vec2<u32>, cells_start_10: u32) -> f32 {
    var self_3: Proposal;

    self_3 = this_37;
    // glimt_render_gpu/src/kernels/proposal.rs:407
    let _e10 = self_3.total;
    if !((_e10 > 0f)) {
        // glimt_render_gpu/src/kernels/proposal.rs:408
        return 0f;
    }
    // glimt_render_gpu/src/kernels/proposal.rs:410
    let _e19 = self_3.defence;
    let weight_3 = (at_2.weight + (_e19 * at_2.live));
    // glimt_render_gpu/src/kernels/proposal.rs:411
    let _e25 = self_3.total;
    let _e27 = LightCells_pmf_in_cell(cells_size_10, cells_start_10, texel_4, cell_4);
    let pmf = ((weight_3 / _e25) * _e27);
    // glimt_render_gpu/src/kernels/proposal.rs:412
    let _e31 = texel_solid_angle_sr(texel_4.y, cells_size_10);
    return (pmf / _e31);
}

// glimt_render_gpu/src/kernels/environment.rs:103
fn Environment_radiance(size_16: vec2<u32>, rotation_3: vec2<f32>, texel_5: vec2<u32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/environment.rs:104
    let _e11 = env_texels[((texel_5.y * size_16.x) + texel_5.x)];
    return _e11.xyz;
}

// glimt_brdf/src/blinn_phong.rs:59
fn BlinnPhong_eval(this_38: BlinnPhong, wo_5: vec3<f32>, wi_2: vec3<f32>) -> vec3<f32> {

    // glimt_brdf/src/blinn_phong.rs:60
    if ((wo_5.z <= 0f) || (wi_2.z <= 0f)) {
        // glimt_brdf/src/blinn_phong.rs:61
        return vec3(0f);
    }
    // glimt_brdf/src/blinn_phong.rs:63
    let diffuse_3 = (this_38.diffuse * 0.31830987f);
    // glimt_brdf/src/blinn_phong.rs:65
    if (max(max(this_38.specular.x, this_38.specular.y), this_38.specular.z) <= 0f) {
        // glimt_brdf/src/blinn_phong.rs:66
        return diffuse_3;
    }
    // glimt_brdf/src/blinn_phong.rs:68
    let _e31 = normalisation(this_38.exponent);
    let _e32 = HalfVector_new(wo_5, wi_2);
    let _e34 = HalfVector_lobe(_e32, this_38.exponent);
    let lobe_2 = (_e31 * _e34);
    // glimt_brdf/src/blinn_phong.rs:69
    return (diffuse_3 + (this_38.specular * lobe_2));
}

// glimt_render_gpu/src/kernels/group_light.rs:82
fn reflectance(point_3: ShadingPoint, wi_3: vec3<f32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/group_light.rs:83
    if (wi_3.z > 0f) {
        // glimt_render_gpu/src/kernels/group_light.rs:84
        let _e10 = BlinnPhong_eval(point_3.brdf, point_3.wo, wi_3);
        return (_e10 * wi_3.z);
    }
    // glimt_render_gpu/src/kernels/group_light.rs:86
    return vec3(0f);
}

// glimt_render_gpu/src/kernels/ray.rs:59
fn inverse(x_9: f32) -> f32 {

    // glimt_render_gpu/src/kernels/ray.rs:60
    return (1f / bitcast<f32>(((bitcast<u32>(max(abs(x_9), 0.000000000000000001f)) & 2147483647u) | (bitcast<u32>(x_9) & 2147483648u))));
}

// glimt_render_gpu/src/kernels/ray.rs:44
fn Ray_keyed(origin: vec3<f32>, direction_6: vec3<f32>, key: u32) -> Ray {

    // glimt_render_gpu/src/kernels/ray.rs:45
    let _e6 = inverse(direction_6.x);
    let _e8 = inverse(direction_6.y);
    let _e10 = inverse(direction_6.z);
    return Ray(origin, direction_6, vec3<f32>(_e6, _e8, _e10), key);
}

// glimt_render_gpu/src/kernels/bvh.rs:53
fn meet(node: BvhNode, ray_2: Ray, reach: f32) -> Met {
    var node_1: BvhNode;

    node_1 = node;
    // glimt_render_gpu/src/kernels/bvh.rs:54
    let _e12 = Tuple_f32_f32_f32_(ray_2.origin.x, ray_2.origin.y, ray_2.origin.z);
    let x_14 = _e12.fa;
    let y_5 = _e12.fb;
    let z_3 = _e12.fc;
    // glimt_render_gpu/src/kernels/bvh.rs:55
    let inverse_1 = ray_2.inverse_direction;
    // glimt_render_gpu/src/kernels/bvh.rs:56
    let _e20 = node_1.min_x;
    let to_min_x = ((_e20 - vec4(x_14)) * inverse_1.x);
    // glimt_render_gpu/src/kernels/bvh.rs:57
    let _e27 = node_1.max_x;
    let to_max_x = ((_e27 - vec4(x_14)) * inverse_1.x);
    // glimt_render_gpu/src/kernels/bvh.rs:58
    let _e34 = node_1.min_y;
    let to_min_y = ((_e34 - vec4(y_5)) * inverse_1.y);
    // glimt_render_gpu/src/kernels/bvh.rs:59
    let _e41 = node_1.max_y;
    let to_max_y = ((_e41 - vec4(y_5)) * inverse_1.y);
    // glimt_render_gpu/src/kernels/bvh.rs:60
    let _e48 = node_1.min_z;
    let to_min_z = ((_e48 - vec4(z_3)) * inverse_1.z);
    // glimt_render_gpu/src/kernels/bvh.rs:61
    let _e55 = node_1.max_z;
    let to_max_z = ((_e55 - vec4(z_3)) * inverse_1.z);
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
    let x_15 = (triangle.x - vec4(ray_3.origin.x));
    // glimt_render_gpu/src/kernels/triangle.rs:165
    let y_6 = (triangle.y - vec4(ray_3.origin.y));
    // glimt_render_gpu/src/kernels/triangle.rs:166
    let z_4 = (triangle.z - vec4(ray_3.origin.z));
    // glimt_render_gpu/src/kernels/triangle.rs:168
    let _e24 = Tuple_Vec4_Vec4_(x_15.yzxw, x_15.zxyw);
    let x1_ = _e24.fa;
    let x2_1 = _e24.fb;
    // glimt_render_gpu/src/kernels/triangle.rs:169
    let _e30 = Tuple_Vec4_Vec4_(y_6.yzxw, y_6.zxyw);
    let y1_ = _e30.fa;
    let y2_1 = _e30.fb;
    // glimt_render_gpu/src/kernels/triangle.rs:170
    let _e36 = Tuple_Vec4_Vec4_(z_4.yzxw, z_4.zxyw);
    let z1_ = _e36.fa;
    let z2_ = _e36.fb;
    // glimt_render_gpu/src/kernels/triangle.rs:171
    let _e43 = Tuple_Vec4_Vec4_Vec4_((x1_ - x2_1), (y1_ - y2_1), (z1_ - z2_));
    let edge_x = _e43.fa;
    let edge_y = _e43.fb;
    let edge_z = _e43.fc;
    // glimt_render_gpu/src/kernels/triangle.rs:172
    let _e51 = Tuple_Vec4_Vec4_Vec4_((x1_ + x2_1), (y1_ + y2_1), (z1_ + z2_));
    let sum_x = _e51.fa;
    let sum_y = _e51.fb;
    let sum_z = _e51.fc;
    // glimt_render_gpu/src/kernels/triangle.rs:173
    let d_4 = ray_3.direction;
    // glimt_render_gpu/src/kernels/triangle.rs:174
    let functions = (((((edge_y * sum_z) - (edge_z * sum_y)) * d_4.x) + (((edge_z * sum_x) - (edge_x * sum_z)) * d_4.y)) + (((edge_x * sum_y) - (edge_y * sum_x)) * d_4.z));
    // glimt_render_gpu/src/kernels/triangle.rs:177
    return Seen(vec3<f32>(x_15.x, y_6.x, z_4.x), edge_x, edge_y, edge_z, functions);
}

// glimt_render_gpu/src/kernels/triangle.rs:191
fn intersect(triangle_1: Triangle, ray_4: Ray, t_max: f32) -> f32 {
    var chosen_18: f32;

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
    let normal_4 = cross(from_a, to_a);
    // glimt_render_gpu/src/kernels/triangle.rs:199
    let slope_1 = dot(normal_4, ray_4.direction);
    // glimt_render_gpu/src/kernels/triangle.rs:200
    if (slope_1 == 0f) {
        // glimt_render_gpu/src/kernels/triangle.rs:201
        return 0x1.fffffep+127f;
    }
    // glimt_render_gpu/src/kernels/triangle.rs:203
    let t_8 = (dot(_e5.a, normal_4) / slope_1);
    // glimt_render_gpu/src/kernels/triangle.rs:204
    if ((t_8 > 0f) && (t_8 < t_max)) {
        chosen_18 = t_8;
    } else {
        chosen_18 = 0x1.fffffep+127f;
    }
    let _e67 = chosen_18;
    return _e67;
}

// glimt_render_gpu/src/kernels/triangle.rs:99
fn Triangle_is_see_through(this_39: Triangle) -> bool {

    // glimt_render_gpu/src/kernels/triangle.rs:100
    return ((this_39.object & 1073741824u) != 0u);
}

// glimt_render_gpu/src/kernels/triangle.rs:210
fn barycentrics(triangle_2: Triangle, ray_5: Ray) -> vec2<f32> {

    // glimt_render_gpu/src/kernels/triangle.rs:211
    let _e4 = seen(triangle_2, ray_5);
    let w_2 = _e4.functions.xyz;
    // glimt_render_gpu/src/kernels/triangle.rs:212
    let sum_4 = ((w_2.x + w_2.y) + w_2.z);
    // glimt_render_gpu/src/kernels/triangle.rs:213
    if (sum_4 == 0f) {
        // glimt_render_gpu/src/kernels/triangle.rs:215
        return vec2((1f / 3f));
    }
    // glimt_render_gpu/src/kernels/triangle.rs:217
    return (vec2<f32>(w_2.y, w_2.z) / vec2(sum_4));
}

// glimt_render_gpu/src/kernels/material.rs:141
fn Attributes_of_corner(first_5: u32) -> Attributes {

    // glimt_render_gpu/src/kernels/material.rs:142
    let _e7 = scene_surface[(first_5 + 2u)];
    let _e12 = scene_surface[(first_5 + 3u)];
    let _e13 = Tuple_u32_u32_(_e7, _e12);
    let low = _e13.fa;
    let high = _e13.fb;
    // glimt_render_gpu/src/kernels/material.rs:143
    let color = vec4<f32>(f32((low & 65535u)), f32((low >> 16u)), f32((high & 65535u)), f32((high >> 16u)));
    // glimt_render_gpu/src/kernels/material.rs:149
    let _e33 = scene_surface[first_5];
    let _e39 = scene_surface[(first_5 + 1u)];
    return Attributes(vec2<f32>(bitcast<f32>(_e33), bitcast<f32>(_e39)), (color / vec4(65535f)));
}

// glimt_render_gpu/src/kernels/material.rs:129
fn Attributes_at(first_6: u32, u_10: f32, v_3: f32) -> Attributes {

    // glimt_render_gpu/src/kernels/material.rs:130
    let _e5 = Attributes_of_corner(first_6);
    // glimt_render_gpu/src/kernels/material.rs:131
    let _e9 = Attributes_of_corner((first_6 + 4u));
    // glimt_render_gpu/src/kernels/material.rs:132
    let _e15 = Attributes_of_corner((first_6 + (2u * 4u)));
    // glimt_render_gpu/src/kernels/material.rs:133
    let w_3 = ((1f - u_10) - v_3);
    // glimt_render_gpu/src/kernels/material.rs:134
    return Attributes((((_e5.uv * w_3) + (_e9.uv * u_10)) + (_e15.uv * v_3)), (((_e5.color * w_3) + (_e9.color * u_10)) + (_e15.color * v_3)));
}

// glimt_render_gpu/src/kernels/material.rs:172
fn MaterialView_new(index_13: u32) -> Returned_MaterialView_new {

    // glimt_render_gpu/src/kernels/material.rs:173
    let first_10 = (256u + (index_13 * 76u));
    // glimt_render_gpu/src/kernels/material.rs:174
    return Returned_MaterialView_new(first_10, ((first_10 + 76u) - first_10));
}

// glimt_render_gpu/src/kernels/material.rs:181
fn MaterialView_number(words_start: u32, words_len: u32, word_2: u32) -> f32 {

    // glimt_render_gpu/src/kernels/material.rs:182
    let _e7 = scene_surface[(words_start + word_2)];
    return bitcast<f32>(_e7);
}

// glimt_render_gpu/src/kernels/material.rs:195
fn MaterialView_texture(words_start_1: u32, words_len_1: u32, word_3: u32) -> TextureView {

    // glimt_render_gpu/src/kernels/material.rs:196
    let _e7 = scene_surface[(words_start_1 + word_3)];
    let _e13 = scene_surface[(words_start_1 + (word_3 + 1u))];
    let _e19 = scene_surface[(words_start_1 + (word_3 + 2u))];
    let _e25 = scene_surface[(words_start_1 + (word_3 + 3u))];
    return TextureView(_e7, _e13, _e19, _e25);
}

// glimt_render_gpu/src/kernels/texture.rs:40
fn TextureView_exists(this_40: TextureView) -> bool {

    // glimt_render_gpu/src/kernels/texture.rs:41
    return (this_40.width > 0u);
}

// glimt_render_gpu/src/kernels/texture.rs:90
fn wrap(x_10: f32, mode: u32) -> f32 {

    // glimt_render_gpu/src/kernels/texture.rs:91
    if (mode == 2u) {
        // glimt_render_gpu/src/kernels/texture.rs:92
        return clamp(x_10, 0f, 1f);
    }
    // glimt_render_gpu/src/kernels/texture.rs:94
    if (mode == 1u) {
        // glimt_render_gpu/src/kernels/texture.rs:95
        let folded = (x_10 - (2f * floor((0.5f * x_10))));
        // glimt_render_gpu/src/kernels/texture.rs:96
        return clamp(min(folded, (2f - folded)), 0f, 1f);
    }
    // glimt_render_gpu/src/kernels/texture.rs:98
    return clamp((x_10 - floor(x_10)), 0f, 1f);
}

// glimt_render_gpu/src/kernels/texture.rs:103
fn neighbour(index_14: i32, size_17: u32, mode_1: u32) -> u32 {

    // glimt_render_gpu/src/kernels/texture.rs:104
    let last = (i32(size_17) - 1i);
    // glimt_render_gpu/src/kernels/texture.rs:105
    if (mode_1 == 0u) {
        // glimt_render_gpu/src/kernels/texture.rs:106
        if (index_14 < 0i) {
            // glimt_render_gpu/src/kernels/texture.rs:107
            return u32(last);
        }
        // glimt_render_gpu/src/kernels/texture.rs:109
        if (index_14 > last) {
            // glimt_render_gpu/src/kernels/texture.rs:110
            return 0u;
        }
    }
    // glimt_render_gpu/src/kernels/texture.rs:113
    return u32(clamp(index_14, 0i, last));
}

// glimt_render_gpu/src/kernels/texture.rs:69
fn TextureView_texel(this_41: TextureView, index_15: u32) -> vec4<f32> {
    var chosen_19: vec4<f32>;

    // glimt_render_gpu/src/kernels/texture.rs:70
    let word_6 = scene_surface[(this_41.first + index_15)];
    // glimt_render_gpu/src/kernels/texture.rs:71
    let r_3 = (word_6 & 255u);
    // glimt_render_gpu/src/kernels/texture.rs:72
    let g = ((word_6 >> 8u) & 255u);
    // glimt_render_gpu/src/kernels/texture.rs:73
    let b_3 = ((word_6 >> 16u) & 255u);
    // glimt_render_gpu/src/kernels/texture.rs:74
    let alpha_2 = (f32((word_6 >> 24u)) / 255f);
    // glimt_render_gpu/src/kernels/texture.rs:75
    if ((this_41.flags & 1u) != 0u) {
        // glimt_render_gpu/src/kernels/texture.rs:76
        let _e38 = scene_surface[r_3];
        let _e42 = scene_surface[g];
        let _e46 = scene_surface[b_3];
        chosen_19 = vec4<f32>(bitcast<f32>(_e38), bitcast<f32>(_e42), bitcast<f32>(_e46), alpha_2);
    } else {
        // glimt_render_gpu/src/kernels/texture.rs:83
        chosen_19 = vec4<f32>((f32(r_3) / 255f), (f32(g) / 255f), (f32(b_3) / 255f), alpha_2);
    }
    let _e60 = chosen_19;
    return _e60;
}

// glimt_render_gpu/src/kernels/texture.rs:49
fn TextureView_sample(this_42: TextureView, uv: vec2<f32>) -> vec4<f32> {

    // glimt_render_gpu/src/kernels/texture.rs:50
    let wrap_u = ((this_42.flags >> 1u) & 3u);
    // glimt_render_gpu/src/kernels/texture.rs:51
    let wrap_v = ((this_42.flags >> ((1u + 2u) & 31u)) & 3u);
    // glimt_render_gpu/src/kernels/texture.rs:52
    let _e21 = wrap(uv.x, wrap_u);
    let x_16 = ((_e21 * f32(this_42.width)) - 0.5f);
    // glimt_render_gpu/src/kernels/texture.rs:53
    let _e29 = wrap(uv.y, wrap_v);
    let y_7 = ((_e29 * f32(this_42.height)) - 0.5f);
    // glimt_render_gpu/src/kernels/texture.rs:54
    let _e38 = Tuple_f32_f32_(floor(x_16), floor(y_7));
    let left_2 = _e38.fa;
    let top = _e38.fb;
    // glimt_render_gpu/src/kernels/texture.rs:55
    let _e44 = neighbour(i32(left_2), this_42.width, wrap_u);
    // glimt_render_gpu/src/kernels/texture.rs:56
    let _e50 = neighbour((i32(left_2) + 1i), this_42.width, wrap_u);
    // glimt_render_gpu/src/kernels/texture.rs:57
    let _e54 = neighbour(i32(top), this_42.height, wrap_v);
    let row0_ = (_e54 * this_42.width);
    // glimt_render_gpu/src/kernels/texture.rs:58
    let _e62 = neighbour((i32(top) + 1i), this_42.height, wrap_v);
    let row1_ = (_e62 * this_42.width);
    // glimt_render_gpu/src/kernels/texture.rs:59
    let _e67 = TextureView_texel(this_42, (row0_ + _e44));
    let _e69 = TextureView_texel(this_42, (row0_ + _e50));
    let _e70 = (x_16 - left_2);
    let upper_1 = ((_e67 * (1f - _e70)) + (_e69 * _e70));
    // glimt_render_gpu/src/kernels/texture.rs:62
    let _e78 = TextureView_texel(this_42, (row1_ + _e44));
    let _e80 = TextureView_texel(this_42, (row1_ + _e50));
    let _e81 = (x_16 - left_2);
    let lower_2 = ((_e78 * (1f - _e81)) + (_e80 * _e81));
    // glimt_render_gpu/src/kernels/texture.rs:65
    let _e88 = (y_7 - top);
    return ((upper_1 * (1f - _e88)) + (lower_2 * _e88));
}

// glimt_render_gpu/src/kernels/material.rs:206
fn MaterialView_sample(words_start_2: u32, words_len_2: u32, word_4: u32, texture: TextureView, uv_1: vec2<f32>) -> vec4<f32> {
    var place: vec2<f32>;

    // glimt_render_gpu/src/kernels/material.rs:207
    place = uv_1;
    // glimt_render_gpu/src/kernels/material.rs:208
    if ((texture.flags & 65536u) != 0u) {
        // glimt_render_gpu/src/kernels/material.rs:209
        let t_9 = (word_4 + 4u);
        // glimt_render_gpu/src/kernels/material.rs:210
        let _e18 = MaterialView_number(words_start_2, words_len_2, t_9);
        let _e21 = MaterialView_number(words_start_2, words_len_2, (t_9 + 1u));
        let _e27 = MaterialView_number(words_start_2, words_len_2, (t_9 + 2u));
        let _e30 = MaterialView_number(words_start_2, words_len_2, (t_9 + 3u));
        let _e37 = MaterialView_number(words_start_2, words_len_2, (t_9 + 4u));
        let _e40 = MaterialView_number(words_start_2, words_len_2, (t_9 + 5u));
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
    var chosen_20: f32;

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
        chosen_20 = 1f;
    } else {
        chosen_20 = 0f;
    }
    let _e35 = chosen_20;
    return _e35;
}

// glimt_render_gpu/src/kernels/opacity.rs:14
fn alpha_at(triangle_3: Triangle, u_11: f32, v_4: f32) -> f32 {

    // glimt_render_gpu/src/kernels/opacity.rs:15
    let _e6 = Attributes_at(triangle_3.attributes, u_11, v_4);
    // glimt_render_gpu/src/kernels/opacity.rs:16
    let _e11 = MaterialView_new((triangle_3.material & 2147483647u));
    // glimt_render_gpu/src/kernels/opacity.rs:17
    let _e18 = MaterialView_alpha(_e11.value_words_start, _e11.value_words_len, _e6.uv, _e6.color.w);
    return _e18;
}

// glimt_render_gpu/src/kernels/opacity.rs:26
fn passes(key_1: u32, index_16: u32, alpha_1: f32) -> bool {

    // glimt_render_gpu/src/kernels/opacity.rs:27
    let _e5 = hash2_(key_1, index_16);
    let _e6 = unit_f32_(_e5);
    return (_e6 >= alpha_1);
}

// glimt_render_gpu/src/kernels/opacity.rs:33
fn is_passed(index_17: u32, triangle_4: Triangle, ray_6: Ray) -> bool {

    // glimt_render_gpu/src/kernels/opacity.rs:34
    let _e5 = barycentrics(triangle_4, ray_6);
    // glimt_render_gpu/src/kernels/opacity.rs:35
    let _e9 = alpha_at(triangle_4, _e5.x, _e5.y);
    // glimt_render_gpu/src/kernels/opacity.rs:36
    let _e12 = passes(ray_6.key, index_17, _e9);
    return _e12;
}

// glimt_render_gpu/src/kernels/triangle.rs:85
fn Triangle_is_catcher(this_43: Triangle) -> bool {

    // glimt_render_gpu/src/kernels/triangle.rs:86
    return ((this_43.object & 2147483648u) != 0u);
}

// glimt_render_gpu/src/kernels/triangle.rs:71
fn Triangle_b(this_44: Triangle) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/triangle.rs:72
    return vec3<f32>(this_44.x.y, this_44.y.y, this_44.z.y);
}

// glimt_render_gpu/src/kernels/triangle.rs:64
fn Triangle_a(this_45: Triangle) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/triangle.rs:65
    return vec3<f32>(this_45.x.x, this_45.y.x, this_45.z.x);
}

// glimt_render_gpu/src/kernels/triangle.rs:78
fn Triangle_c(this_46: Triangle) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/triangle.rs:79
    return vec3<f32>(this_46.x.z, this_46.y.z, this_46.z.z);
}

// glimt_render_gpu/src/kernels/triangle.rs:140
fn Triangle_area_normal(this_47: Triangle) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/triangle.rs:141
    let _e3 = Triangle_b(this_47);
    let _e4 = Triangle_a(this_47);
    let _e6 = Triangle_c(this_47);
    let _e7 = Triangle_a(this_47);
    return cross((_e3 - _e4), (_e6 - _e7));
}

// glimt_render_gpu/src/kernels/triangle.rs:106
fn Triangle_ray_offset(this_48: Triangle) -> f32 {

    // glimt_render_gpu/src/kernels/triangle.rs:107
    let extent = max(max(abs(this_48.x), abs(this_48.y)), abs(this_48.z));
    // glimt_render_gpu/src/kernels/triangle.rs:108
    return (0.0000038146973f * max(max(max(extent.x, extent.y), extent.z), extent.w));
}

// glimt_render_gpu/src/kernels/triangle.rs:114
fn Triangle_setback(this_49: Triangle, ray_7: Ray, t_1: f32) -> f32 {

    // glimt_render_gpu/src/kernels/triangle.rs:115
    let _e5 = Triangle_area_normal(this_49);
    // glimt_render_gpu/src/kernels/triangle.rs:116
    let across = abs(dot(_e5, ray_7.direction));
    // glimt_render_gpu/src/kernels/triangle.rs:117
    let _e12 = Triangle_ray_offset(this_49);
    let apart = (2f * max(_e12, ((0.0000038146973f * t_1) * sqrt(dot(ray_7.direction, ray_7.direction)))));
    // glimt_render_gpu/src/kernels/triangle.rs:122
    return min(((apart * sqrt(dot(_e5, _e5))) / max(across, 0.000000000000000000000000000000000000011754944f)), t_1);
}

// glimt_render_gpu/src/kernels/bvh.rs:214
fn held(index_18: u32, triangle_5: Triangle, ray_8: Ray, t_2: f32, no_catcher: bool) -> f32 {
    var both_1: bool;

    // glimt_render_gpu/src/kernels/bvh.rs:222
    let _e7 = Triangle_is_see_through(triangle_5);
    both_1 = _e7;
    if _e7 {
        let _e9 = is_passed(index_18, triangle_5, ray_8);
        both_1 = _e9;
    }
    let _e10 = both_1;
    if _e10 {
        // glimt_render_gpu/src/kernels/bvh.rs:223
        return 0x1.fffffep+127f;
    }
    // glimt_render_gpu/src/kernels/bvh.rs:225
    let _e14 = Triangle_is_catcher(triangle_5);
    if !(_e14) {
        // glimt_render_gpu/src/kernels/bvh.rs:226
        return t_2;
    }
    // glimt_render_gpu/src/kernels/bvh.rs:228
    if no_catcher {
        // glimt_render_gpu/src/kernels/bvh.rs:229
        return 0x1.fffffep+127f;
    }
    // glimt_render_gpu/src/kernels/bvh.rs:231
    let _e21 = Triangle_setback(triangle_5, ray_8, t_2);
    return (t_2 + _e21);
}

// glimt_render_gpu/src/kernels/bvh.rs:187
fn visit_leaf(first_7: u32, ray_9: Ray, reach_1: ptr<function, f32>, best: u32, no_catcher_1: bool) -> u32 {
    var nearest: u32;
    var counter_11: u32;
    var t_3: f32;
    var both_2: bool;

    // glimt_render_gpu/src/kernels/bvh.rs:196
    nearest = best;
    // glimt_render_gpu/src/kernels/bvh.rs:197
    let _e12 = scene_triangles[first_7].run;
    counter_11 = first_7;
    loop {
        let i = counter_11;
        if (i >= (first_7 + _e12)) {
            break;
        }
        // glimt_render_gpu/src/kernels/bvh.rs:198
        let _e20 = scene_triangles[i];
        let _e21 = (*reach_1);
        let _e22 = intersect(_e20, ray_9, _e21);
        t_3 = _e22;
        // glimt_render_gpu/src/kernels/bvh.rs:200
        let _e25 = t_3;
        let _e26 = (*reach_1);
        let _e27 = (_e25 < _e26);
        both_2 = _e27;
        if _e27 {
            let _e32 = scene_triangles[i].object;
            both_2 = (_e32 >= 1073741824u);
        }
        let _e35 = both_2;
        if _e35 {
            // glimt_render_gpu/src/kernels/bvh.rs:201
            let _e39 = scene_triangles[i];
            let _e40 = t_3;
            let _e41 = held(i, _e39, ray_9, _e40, no_catcher_1);
            t_3 = _e41;
        }
        // glimt_render_gpu/src/kernels/bvh.rs:203
        let _e43 = t_3;
        let _e44 = (*reach_1);
        if (_e43 < _e44) {
            // glimt_render_gpu/src/kernels/bvh.rs:204
            let _e47 = t_3;
            (*reach_1) = _e47;
            // glimt_render_gpu/src/kernels/bvh.rs:205
            nearest = i;
        }
        continuing {
            let _e49 = counter_11;
            counter_11 = (_e49 + 1u);
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
    var at_3: u32;
    var next: u32;
    var node_2: BvhNode;
    var met: Met;
    var distance_: f32;
    var counter_12: u32;
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
    at_3 = 0u;
    // glimt_render_gpu/src/kernels/bvh.rs:140
    loop {
        // glimt_render_gpu/src/kernels/bvh.rs:142
        next = 0u;
        // glimt_render_gpu/src/kernels/bvh.rs:143
        let _e29 = at_3;
        if (_e29 < 2147483648u) {
            // glimt_render_gpu/src/kernels/bvh.rs:144
            let _e33 = at_3;
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
            counter_12 = 0u;
            loop {
                let i_1 = counter_12;
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
                    let _e94 = counter_12;
                    counter_12 = (_e94 + 1u);
                }
            }
        } else {
            // glimt_render_gpu/src/kernels/bvh.rs:168
            let _e98 = at_3;
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
        at_3 = _e129;
    }
    return u32();
}

// glimt_render_gpu/src/kernels/bvh.rs:108
fn any_hit(ray_11: Ray, t_max_1: f32) -> bool {
    var t_4: f32;

    // glimt_render_gpu/src/kernels/bvh.rs:115
    t_4 = t_max_1;
    // glimt_render_gpu/src/kernels/bvh.rs:116
    let _e7 = traverse(ray_11, (&t_4), true);
    return (_e7 != 4294967295u);
}

// glimt_render_gpu/src/kernels/scene.rs:136
fn Scene_is_lit(point_4: ShadingPoint, direction_7: vec3<f32>, key_2: u32) -> bool {

    // glimt_render_gpu/src/kernels/scene.rs:137
    let _e6 = Ray_keyed(point_4.origin, direction_7, key_2);
    // glimt_render_gpu/src/kernels/scene.rs:138
    let _e9 = any_hit(_e6, 0x1.fffffep+127f);
    return !(_e9);
}

// glimt_render_gpu/src/kernels/proposal.rs:418
fn Proposal_open_control(this_50: Proposal, direction_8: vec3<f32>, at_4: CellAt) -> vec3<f32> {
    var self_4: Proposal;
    var chosen_21: f32;

    self_4 = this_50;
    // glimt_render_gpu/src/kernels/proposal.rs:419
    if at_4.is_full {
        // glimt_render_gpu/src/kernels/proposal.rs:420
        let _e11 = self_4.of_.mean_normal;
        chosen_21 = dot(_e11, direction_8);
    } else {
        // glimt_render_gpu/src/kernels/proposal.rs:422
        chosen_21 = at_4.cosine;
    }
    let cosine_1 = chosen_21;
    // glimt_render_gpu/src/kernels/proposal.rs:424
    let _e19 = self_4.of_.diffuse;
    let kd_2 = (_e19 * 0.31830987f);
    // glimt_render_gpu/src/kernels/proposal.rs:425
    let _e26 = self_4.of_.specular;
    return ((kd_2 * cosine_1) + (_e26 * at_4.lobe));
}

// glimt_render_gpu/src/kernels/group_light.rs:277
fn GroupLight_of_others(env_size_4: vec2<u32>, env_rotation_4: vec2<f32>, cells_size_11: vec2<u32>, cells_start_11: u32, pattern_3: PixelPattern, rays_3: f32, threshold_4: f32, group_3: Group, proposal_4: Proposal, look: Look, points_start_6: u32, points_len_6: u32) -> vec3<f32> {
    var proposal_5: Proposal;
    var diffuse_1: vec3<f32>;
    var lobes: f32;
    var own_diffuse: vec3<f32>;
    var own_lobe: f32;
    var counter_13: u32;
    var cosines: array<f32, 4>;
    var halves: array<f32, 4>;
    var is_own: array<f32, 4>;
    var counter_14: u32;

    proposal_5 = proposal_4;
    // glimt_render_gpu/src/kernels/group_light.rs:284
    if (group_3.members < 2u) {
        // glimt_render_gpu/src/kernels/group_light.rs:285
        return vec3(0f);
    }
    // glimt_render_gpu/src/kernels/group_light.rs:287
    let of_3 = proposal_5.of_;
    // glimt_render_gpu/src/kernels/group_light.rs:288
    let spread_1 = of_3.surface.spread;
    // glimt_render_gpu/src/kernels/group_light.rs:289
    let _e27 = proposal_5.lobe_share;
    let with_lobes = (((of_3.surface.specular > 0f) && !((_e27 > 0f))) && (spread_1 > 0.001f));
    // glimt_render_gpu/src/kernels/group_light.rs:290
    if !((with_lobes || (spread_1 > 0.035f))) {
        // glimt_render_gpu/src/kernels/group_light.rs:291
        let normal_5 = points[(points_start_6 + look.ray)].normal;
        // glimt_render_gpu/src/kernels/group_light.rs:292
        let apart_1 = (dot(of_3.mean_normal, look.of_map) - dot(normal_5, look.direction));
        // glimt_render_gpu/src/kernels/group_light.rs:293
        return (of_3.diffuse * (0.31830987f * apart_1));
    }
    // glimt_render_gpu/src/kernels/group_light.rs:295
    let half_3 = (look.of_map + of_3.surface.wo);
    // glimt_render_gpu/src/kernels/group_light.rs:296
    let _e70 = rotate_z((half_3 / vec3(max(length(half_3), 0.000001f))), env_rotation_4);
    // glimt_render_gpu/src/kernels/group_light.rs:297
    diffuse_1 = vec3(0f);
    // glimt_render_gpu/src/kernels/group_light.rs:298
    lobes = 0f;
    // glimt_render_gpu/src/kernels/group_light.rs:299
    own_diffuse = vec3(0f);
    // glimt_render_gpu/src/kernels/group_light.rs:300
    own_lobe = 0f;
    // glimt_render_gpu/src/kernels/group_light.rs:301
    let _e89 = (group_3.members / 4u);
    counter_13 = 0u;
    loop {
        let quad_11 = counter_13;
        if (quad_11 >= select(_e89, (_e89 + 1u), ((group_3.members % 4u) != 0u))) {
            break;
        }
        // glimt_render_gpu/src/kernels/group_light.rs:302
        cosines = array<f32, 4>(0f, 0f, 0f, 0f);
        // glimt_render_gpu/src/kernels/group_light.rs:303
        halves = array<f32, 4>(0f, 0f, 0f, 0f);
        // glimt_render_gpu/src/kernels/group_light.rs:304
        is_own = array<f32, 4>(0f, 0f, 0f, 0f);
        // glimt_render_gpu/src/kernels/group_light.rs:305
        counter_14 = 0u;
        loop {
            let lane_2 = counter_14;
            if (lane_2 >= 4u) {
                break;
            }
            // glimt_render_gpu/src/kernels/group_light.rs:306
            let k_4 = ((4u * quad_11) + lane_2);
            // glimt_render_gpu/src/kernels/group_light.rs:307
            if (k_4 < group_3.members) {
                // glimt_render_gpu/src/kernels/group_light.rs:308
                let _e125 = Group_ray(group_3, k_4, points_start_6, points_len_6);
                // glimt_render_gpu/src/kernels/group_light.rs:309
                let other = points[(points_start_6 + _e125)];
                // glimt_render_gpu/src/kernels/group_light.rs:310
                let cosine_2 = max(dot(other.normal, look.direction), 0f);
                // glimt_render_gpu/src/kernels/group_light.rs:311
                cosines[lane_2] = cosine_2;
                // glimt_render_gpu/src/kernels/group_light.rs:312
                halves[lane_2] = max(dot(other.normal, _e70), 0f);
                // glimt_render_gpu/src/kernels/group_light.rs:313
                let _e148 = diffuse_1;
                diffuse_1 = (_e148 + (other.diffuse * cosine_2));
                // glimt_render_gpu/src/kernels/group_light.rs:314
                if (_e125 == look.ray) {
                    // glimt_render_gpu/src/kernels/group_light.rs:315
                    own_diffuse = (other.diffuse * cosine_2);
                    // glimt_render_gpu/src/kernels/group_light.rs:316
                    is_own[lane_2] = 1f;
                }
            }
            continuing {
                let _e159 = counter_14;
                counter_14 = (_e159 + 1u);
            }
        }
        // glimt_render_gpu/src/kernels/group_light.rs:320
        if with_lobes {
            // glimt_render_gpu/src/kernels/group_light.rs:321
            let _e165 = cosines[0];
            let _e167 = cosines[1];
            let _e169 = cosines[2];
            let _e171 = cosines[3];
            let cosine_3 = vec4<f32>(_e165, _e167, _e169, _e171);
            // glimt_render_gpu/src/kernels/group_light.rs:322
            let _e175 = halves[0];
            let _e177 = halves[1];
            let _e179 = halves[2];
            let _e181 = halves[3];
            let half_4 = vec4<f32>(_e175, _e177, _e179, _e181);
            // glimt_render_gpu/src/kernels/group_light.rs:323
            let _e185 = is_own[0];
            let _e187 = is_own[1];
            let _e189 = is_own[2];
            let _e191 = is_own[3];
            let own_1 = vec4<f32>(_e185, _e187, _e189, _e191);
            // glimt_render_gpu/src/kernels/group_light.rs:324
            let _e200 = cosine_power4_((vec4(1f) - (half_4 * half_4)), vec4(of_3.exponent));
            // glimt_render_gpu/src/kernels/group_light.rs:325
            let _e202 = (_e200 * cosine_3);
            let _e210 = lobes;
            lobes = (_e210 + (((_e202.x + _e202.y) + _e202.z) + _e202.w));
            // glimt_render_gpu/src/kernels/group_light.rs:326
            let _e214 = ((_e200 * cosine_3) * own_1);
            let _e222 = own_lobe;
            own_lobe = (_e222 + (((_e214.x + _e214.y) + _e214.z) + _e214.w));
        }
        continuing {
            let _e224 = counter_13;
            counter_13 = (_e224 + 1u);
        }
    }
    // glimt_render_gpu/src/kernels/group_light.rs:329
    let share_2 = (1f / f32(group_3.members));
    // glimt_render_gpu/src/kernels/group_light.rs:330
    let _e233 = diffuse_1;
    let _e235 = own_diffuse;
    let _e241 = lobes;
    let _e243 = own_lobe;
    return ((((_e233 * share_2) - _e235) * 0.31830987f) + (of_3.specular * (of_3.peak * ((_e241 * share_2) - _e243))));
}

// glimt_render_gpu/src/kernels/group_light.rs:223
fn GroupLight_sample(env_size_5: vec2<u32>, env_rotation_5: vec2<f32>, cells_size_12: vec2<u32>, cells_start_12: u32, pattern_4: PixelPattern, rays_4: f32, threshold_5: f32, group_4: Group, proposal_6: Proposal, look_1: Look, key_3: u32, points_start_7: u32, points_len_7: u32) -> Reflected {
    var proposal_7: Proposal;
    var pdf_sr: f32;
    var both_3: bool;
    var lit: vec3<f32>;
    var blocked: vec3<f32>;

    proposal_7 = proposal_6;
    // glimt_render_gpu/src/kernels/group_light.rs:231
    let _e20 = points[(points_start_7 + look_1.ray)];
    let _e21 = SeenPoint_shading_point(_e20);
    // glimt_render_gpu/src/kernels/group_light.rs:232
    let _e25 = ShadingFrame_to_local(_e21.frame, look_1.direction);
    // glimt_render_gpu/src/kernels/group_light.rs:233
    let at_9 = look_1.at;
    // glimt_render_gpu/src/kernels/group_light.rs:234
    let share_3 = proposal_7.lobe_share;
    // glimt_render_gpu/src/kernels/group_light.rs:235
    pdf_sr = 0f;
    // glimt_render_gpu/src/kernels/group_light.rs:236
    if (share_3 < 1f) {
        // glimt_render_gpu/src/kernels/group_light.rs:237
        let _e38 = proposal_7;
        let _e41 = Proposal_cells_pdf_sr(_e38, look_1.texel, look_1.cell, at_9, cells_size_12, cells_start_12);
        // glimt_render_gpu/src/kernels/group_light.rs:238
        pdf_sr = ((1f - share_3) * _e41);
    }
    // glimt_render_gpu/src/kernels/group_light.rs:240
    if (share_3 > 0f) {
        // glimt_render_gpu/src/kernels/group_light.rs:241
        let _e50 = lobe_of(_e21);
        let _e52 = BlinnPhong_pdf_sr(_e50, _e21.wo, _e25);
        let _e54 = pdf_sr;
        pdf_sr = (_e54 + (share_3 * _e52));
    }
    // glimt_render_gpu/src/kernels/group_light.rs:243
    let _e57 = pdf_sr;
    if !((_e57 > 0.000000000000000000000000000000000000011754944f)) {
        // glimt_render_gpu/src/kernels/group_light.rs:244
        return Reflected(vec3(0f), vec3(0f));
    }
    // glimt_render_gpu/src/kernels/group_light.rs:246
    let _e69 = Environment_radiance(env_size_5, env_rotation_5, look_1.texel);
    // glimt_render_gpu/src/kernels/group_light.rs:247
    let _e71 = reflectance(_e21, _e25);
    // glimt_render_gpu/src/kernels/group_light.rs:248
    let is_seen = ((max(max(_e71.x, _e71.y), _e71.z) > 0f) && (dot(_e21.geometric_normal, look_1.direction) > 0f));
    // glimt_render_gpu/src/kernels/group_light.rs:249
    both_3 = is_seen;
    if is_seen {
        let _e89 = Scene_is_lit(_e21, look_1.direction, key_3);
        both_3 = _e89;
    }
    let arrives = both_3;
    // glimt_render_gpu/src/kernels/group_light.rs:250
    lit = vec3(0f);
    // glimt_render_gpu/src/kernels/group_light.rs:251
    blocked = vec3(0f);
    // glimt_render_gpu/src/kernels/group_light.rs:252
    if arrives {
        // glimt_render_gpu/src/kernels/group_light.rs:253
        lit = _e71;
    } else {
        if is_seen {
            // glimt_render_gpu/src/kernels/group_light.rs:255
            blocked = _e71;
        }
    }
    // glimt_render_gpu/src/kernels/group_light.rs:257
    if true {
        // glimt_render_gpu/src/kernels/group_light.rs:258
        let _e105 = proposal_7;
        let _e107 = Proposal_open_control(_e105, look_1.of_map, at_9);
        // glimt_render_gpu/src/kernels/group_light.rs:259
        let _e109 = proposal_7;
        let _e110 = GroupLight_of_others(env_size_5, env_rotation_5, cells_size_12, cells_start_12, pattern_4, rays_4, threshold_5, group_4, _e109, look_1, points_start_7, points_len_7);
        // glimt_render_gpu/src/kernels/group_light.rs:260
        let _e113 = proposal_7.is_catcher;
        if _e113 {
            // glimt_render_gpu/src/kernels/group_light.rs:261
            lit = ((_e71 - _e107) + _e110);
        } else {
            // glimt_render_gpu/src/kernels/group_light.rs:263
            let _e121 = lit;
            lit = (_e121 + ((_e110 - _e107) * at_9.visibility));
        }
    }
    // glimt_render_gpu/src/kernels/group_light.rs:267
    let _e124 = lit;
    let _e125 = pdf_sr;
    let _e129 = blocked;
    let _e130 = pdf_sr;
    return Reflected((_e69 * (_e124 / vec3(_e125))), (_e69 * (_e129 / vec3(_e130))));
}

// glimt_render_gpu/src/kernels/group_light.rs:94
fn GroupLight_reflected(env_size_6: vec2<u32>, env_rotation_6: vec2<f32>, cells_size_13: vec2<u32>, cells_start_13: u32, pattern_5: PixelPattern, rays_5: f32, threshold_6: f32, group_5: Group, number: u32, expected_first_6: u32, expected_slot_6: u32, points_start_8: u32, points_len_8: u32, drawn: ptr<function, Drawn>) -> Reflected {
    var proposal_8: Proposal;
    var source: PatternSource;
    var worth_1: f32;
    var chosen_22: f32;
    var lit_1: vec3<f32>;
    var blocked_1: vec3<f32>;
    var counter_15: u32;
    var chosen_23: Look;

    // glimt_render_gpu/src/kernels/group_light.rs:102
    let _e16 = Group_representative(group_5, points_start_8, points_len_8, env_size_6, env_rotation_6);
    // glimt_render_gpu/src/kernels/group_light.rs:103
    let _e19 = Group_ray(group_5, 0u, points_start_8, points_len_8);
    // glimt_render_gpu/src/kernels/group_light.rs:104
    let leader_3 = points[(points_start_8 + _e19)];
    // glimt_render_gpu/src/kernels/group_light.rs:105
    let _e26 = SeenPoint_slot(leader_3);
    let _e27 = Expected_at_slot(expected_first_6, expected_slot_6, _e26);
    // glimt_render_gpu/src/kernels/group_light.rs:106
    let _e31 = SeenPoint_is_catcher(leader_3);
    // glimt_render_gpu/src/kernels/group_light.rs:107
    let _e33 = Proposal_new(_e16, cells_size_13, cells_start_13, _e27.value_first, _e27.value_slot, _e31);
    proposal_8 = _e33;
    // glimt_render_gpu/src/kernels/group_light.rs:108
    let _e37 = PixelPattern_point(pattern_5, 12u, number);
    source = _e37;
    // glimt_render_gpu/src/kernels/group_light.rs:109
    let _e40 = PatternSource_next_u32_((&source));
    let _e41 = unit_f32_(_e40);
    // glimt_render_gpu/src/kernels/group_light.rs:110
    let share_4 = (f32(group_5.members) / f32(pattern_5.rays));
    // glimt_render_gpu/src/kernels/group_light.rs:111
    worth_1 = (rays_5 * share_4);
    // glimt_render_gpu/src/kernels/group_light.rs:112
    if (threshold_6 > 0f) {
        // glimt_render_gpu/src/kernels/group_light.rs:113
        let _e56 = proposal_8.total;
        let _e58 = proposal_8.lobe_worth;
        worth_1 = (((_e56 + _e58) * share_4) / threshold_6);
    }
    // glimt_render_gpu/src/kernels/group_light.rs:115
    let _e63 = proposal_8;
    let _e64 = Proposal_is_sharp(_e63);
    if _e64 {
        // glimt_render_gpu/src/kernels/group_light.rs:116
        let _e66 = worth_1;
        worth_1 = max(_e66, ((0.25f * rays_5) * share_4));
    }
    // glimt_render_gpu/src/kernels/group_light.rs:118
    let _e72 = worth_1;
    worth_1 = clamp(_e72, 0.02f, 256f);
    // glimt_render_gpu/src/kernels/group_light.rs:119
    let _e78 = proposal_8.total;
    let _e83 = proposal_8.lobe_share;
    if (!((_e78 > 0f)) && !((_e83 > 0f))) {
        // glimt_render_gpu/src/kernels/group_light.rs:120
        worth_1 = 0f;
    }
    // glimt_render_gpu/src/kernels/group_light.rs:122
    let _e91 = worth_1;
    let _e92 = PatternSource_next_u32_((&source));
    let _e93 = unit_f32_(_e92);
    let count_3 = u32((_e91 + _e93));
    // glimt_render_gpu/src/kernels/group_light.rs:123
    Proposal_round_share((&proposal_8), count_3);
    // glimt_render_gpu/src/kernels/group_light.rs:124
    let _e99 = worth_1;
    if (_e99 < 1f) {
        let _e102 = worth_1;
        chosen_22 = _e102;
    } else {
        chosen_22 = f32(count_3);
    }
    let divisor = chosen_22;
    // glimt_render_gpu/src/kernels/group_light.rs:125
    let _e107 = PixelPattern_ray_key(pattern_5, 9u);
    let _e108 = hash2_(_e107, number);
    // glimt_render_gpu/src/kernels/group_light.rs:126
    lit_1 = vec3(0f);
    // glimt_render_gpu/src/kernels/group_light.rs:127
    blocked_1 = vec3(0f);
    // glimt_render_gpu/src/kernels/group_light.rs:128
    counter_15 = 0u;
    loop {
        let s_4 = counter_15;
        if (s_4 >= count_3) {
            break;
        }
        // glimt_render_gpu/src/kernels/group_light.rs:129
        let _e125 = proposal_8.lobe_share;
        let before = u32(((f32(s_4) * _e125) + _e41));
        // glimt_render_gpu/src/kernels/group_light.rs:130
        let _e134 = proposal_8.lobe_share;
        let after = u32(((f32((s_4 + 1u)) * _e134) + _e41));
        // glimt_render_gpu/src/kernels/group_light.rs:131
        if (after > before) {
            // glimt_render_gpu/src/kernels/group_light.rs:132
            let _e144 = (*drawn).lobes;
            (*drawn).lobes = (_e144 + 1u);
            // glimt_render_gpu/src/kernels/group_light.rs:133
            let _e147 = proposal_8;
            let _e149 = (*drawn).lobes;
            let _e152 = GroupLight_look_by_lobe(env_size_6, env_rotation_6, cells_size_13, cells_start_13, pattern_5, rays_5, threshold_6, group_5, _e147, _e27.value_first, _e27.value_slot, (_e149 - 1u), points_start_8, points_len_8);
            chosen_23 = _e152;
        } else {
            // glimt_render_gpu/src/kernels/group_light.rs:135
            let _e156 = (*drawn).cells;
            (*drawn).cells = (_e156 + 1u);
            // glimt_render_gpu/src/kernels/group_light.rs:136
            let _e159 = proposal_8;
            let _e161 = (*drawn).cells;
            let _e164 = GroupLight_look_by_cells(env_size_6, env_rotation_6, cells_size_13, cells_start_13, pattern_5, rays_5, threshold_6, group_5, _e159, _e27.value_first, _e27.value_slot, (_e161 - 1u), points_start_8, points_len_8);
            chosen_23 = _e164;
        }
        let look_2 = chosen_23;
        // glimt_render_gpu/src/kernels/group_light.rs:138
        if look_2.is_possible {
            // glimt_render_gpu/src/kernels/group_light.rs:139
            let own_2 = (_e108 + s_4);
            // glimt_render_gpu/src/kernels/group_light.rs:140
            let _e171 = proposal_8;
            let _e172 = GroupLight_sample(env_size_6, env_rotation_6, cells_size_13, cells_start_13, pattern_5, rays_5, threshold_6, group_5, _e171, look_2, own_2, points_start_8, points_len_8);
            // glimt_render_gpu/src/kernels/group_light.rs:141
            let _e175 = lit_1;
            lit_1 = (_e175 + _e172.lit);
            // glimt_render_gpu/src/kernels/group_light.rs:142
            let _e179 = blocked_1;
            blocked_1 = (_e179 + _e172.blocked);
        }
        continuing {
            let _e181 = counter_15;
            counter_15 = (_e181 + 1u);
        }
    }
    // glimt_render_gpu/src/kernels/group_light.rs:145
    points[(points_start_8 + _e19)].shadow_rays = count_3;
    // glimt_render_gpu/src/kernels/group_light.rs:146
    let _e191 = proposal_8.total;
    let _e193 = proposal_8.lobe_worth;
    points[(points_start_8 + _e19)].residual = ((_e191 + _e193) * share_4);
    // glimt_render_gpu/src/kernels/group_light.rs:147
    if (count_3 > 0u) {
        // glimt_render_gpu/src/kernels/group_light.rs:148
        let _e204 = lit_1;
        lit_1 = (_e204 / vec3(divisor));
        // glimt_render_gpu/src/kernels/group_light.rs:149
        let _e208 = blocked_1;
        blocked_1 = (_e208 / vec3(divisor));
    }
    // glimt_render_gpu/src/kernels/group_light.rs:151
    if (true && _e31) {
        // glimt_render_gpu/src/kernels/group_light.rs:153
        let _e216 = proposal_8.open_integral;
        let _e217 = lit_1;
        let _e219 = blocked_1;
        let _e221 = blocked_1;
        return Reflected(((_e216 + _e217) - _e219), _e221);
    }
    // glimt_render_gpu/src/kernels/group_light.rs:158
    let _e225 = proposal_8.integral;
    let _e226 = lit_1;
    let _e228 = blocked_1;
    return Reflected((_e225 + _e226), _e228);
}

// glimt_render_gpu/src/kernels/shade.rs:25
fn Vec4_of_surface(light: Reflected, _is_catcher: bool) -> vec4<f32> {

    // glimt_render_gpu/src/kernels/shade.rs:26
    return vec4<f32>(light.lit, 1f);
}

// glimt_render_gpu/src/kernels/pattern.rs:221
fn permute(index_19: u32, length_: u32, key_4: u32) -> u32 {
    var x_11: u32;
    var round_key: u32;
    var counter_16: i32;

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
    x_11 = index_19;
    // glimt_render_gpu/src/kernels/pattern.rs:228
    loop {
        // glimt_render_gpu/src/kernels/pattern.rs:229
        round_key = key_4;
        // glimt_render_gpu/src/kernels/pattern.rs:230
        counter_16 = 0i;
        loop {
            let _e31 = counter_16;
            if (_e31 >= 3i) {
                break;
            }
            // glimt_render_gpu/src/kernels/pattern.rs:231
            let _e34 = round_key;
            let _e35 = hash_u32_(_e34);
            round_key = _e35;
            // glimt_render_gpu/src/kernels/pattern.rs:233
            let _e37 = x_11;
            let _e38 = round_key;
            x_11 = (((_e37 ^ _e38) * 2654435761u) & mask);
            // glimt_render_gpu/src/kernels/pattern.rs:234
            let _e44 = x_11;
            let _e46 = (bits_2 / 2u);
            let _e56 = x_11;
            x_11 = (_e56 ^ (_e44 >> (select(_e46, (_e46 + 1u), ((bits_2 % 2u) != 0u)) & 31u)));
            continuing {
                let _e58 = counter_16;
                counter_16 = (_e58 + 1i);
            }
        }
        // glimt_render_gpu/src/kernels/pattern.rs:236
        let _e62 = x_11;
        if (_e62 < length_) {
            // glimt_render_gpu/src/kernels/pattern.rs:237
            let _e65 = x_11;
            let _e67 = hash_u32_(~(key_4));
            return ((_e65 + (_e67 % length_)) % length_);
        }
    }
    return u32();
}

// glimt_render_gpu/src/kernels/pattern.rs:212
fn stratum(cell_5: u32, count_1: u32, jitter: u32) -> u32 {

    // glimt_render_gpu/src/kernels/pattern.rs:213
    return ((cell_5 * (4294967295u / count_1)) + (jitter / count_1));
}

// glimt_render_gpu/src/kernels/pattern.rs:192
fn jittered_pair(index_20: u32, count_2: u32, jitter_1: vec2<u32>, key_5: u32) -> vec2<u32> {

    // glimt_render_gpu/src/kernels/pattern.rs:193
    let columns = max(u32(sqrt(f32(count_2))), 1u);
    // glimt_render_gpu/src/kernels/pattern.rs:194
    let _e12 = (count_2 / columns);
    let rows_2 = select(_e12, (_e12 + 1u), ((count_2 % columns) != 0u));
    // glimt_render_gpu/src/kernels/pattern.rs:195
    let _e21 = hash2_(key_5, 1u);
    let _e22 = permute(index_20, count_2, _e21);
    // glimt_render_gpu/src/kernels/pattern.rs:196
    let _e26 = hash2_(key_5, 2u);
    let _e27 = permute((_e22 % columns), columns, _e26);
    // glimt_render_gpu/src/kernels/pattern.rs:197
    let _e31 = hash2_(key_5, 3u);
    let _e32 = permute((_e22 / columns), rows_2, _e31);
    // glimt_render_gpu/src/kernels/pattern.rs:198
    let _e38 = stratum(((_e27 * rows_2) + _e32), (columns * rows_2), jitter_1.x);
    let _e40 = stratum(_e22, count_2, jitter_1.y);
    return vec2<u32>(_e38, _e40);
}

// glimt_render_gpu/src/kernels/pattern.rs:67
fn PixelPattern_pair(this_51: PixelPattern, purpose_6: u32, sample: u32, samples: u32) -> vec2<u32> {
    var borrowed_2: OwenSobol;
    var borrowed_3: Xoshiro128PlusPlus;

    // glimt_render_gpu/src/kernels/pattern.rs:68
    let index_22 = ((this_51.ray * samples) + sample);
    // glimt_render_gpu/src/kernels/pattern.rs:69
    if (this_51.kind == 0u) {
        // glimt_render_gpu/src/kernels/pattern.rs:70
        let _e14 = PixelPattern_sobol_point(this_51, purpose_6, index_22);
        borrowed_2 = _e14;
        let _e16 = OwenSobol_next_uvec2_((&borrowed_2));
        return _e16;
    }
    // glimt_render_gpu/src/kernels/pattern.rs:72
    let _e18 = PixelPattern_generator(this_51, purpose_6, index_22);
    borrowed_3 = _e18;
    let _e20 = Xoshiro128PlusPlus_next_uvec2_((&borrowed_3));
    // glimt_render_gpu/src/kernels/pattern.rs:73
    if (this_51.kind == 1u) {
        // glimt_render_gpu/src/kernels/pattern.rs:74
        return _e20;
    }
    // glimt_render_gpu/src/kernels/pattern.rs:76
    let _e29 = PixelPattern_key(this_51, purpose_6);
    let _e30 = jittered_pair(index_22, (this_51.rays * samples), _e20, _e29);
    return _e30;
}

// glimt_render_gpu/src/kernels/camera.rs:23
fn CameraView_direction(this_52: CameraView, p: vec2<f32>, size_18: vec2<u32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/camera.rs:24
    let x_17 = (((2f * p.x) / f32(size_18.x)) - 1f);
    // glimt_render_gpu/src/kernels/camera.rs:25
    let y_8 = (((2f * p.y) / f32(size_18.y)) - 1f);
    // glimt_render_gpu/src/kernels/camera.rs:26
    return normalize(((this_52.forward + (this_52.right * x_17)) - (this_52.up * y_8)));
}

// glimt_render_gpu/src/kernels/frame.rs:161
fn FrameParams_direction(this_53: FrameParams, pixel_4: u32, place_1: vec2<f32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/frame.rs:162
    let corner = vec2<f32>(vec2<u32>((pixel_4 % this_53.width), (pixel_4 / this_53.width)));
    // glimt_render_gpu/src/kernels/frame.rs:163
    let view = CameraView(this_53.eye, this_53.forward, this_53.right, this_53.up);
    // glimt_render_gpu/src/kernels/frame.rs:169
    let _e22 = CameraView_direction(view, (corner + place_1), vec2<u32>(this_53.width, this_53.height));
    return _e22;
}

// glimt_render_gpu/src/kernels/frame.rs:144
fn FrameParams_camera_ray(this_54: FrameParams, pattern_6: PixelPattern) -> Ray {
    var chosen_24: vec2<f32>;

    // glimt_render_gpu/src/kernels/frame.rs:145
    let film = PixelPattern(pattern_6.kind, pattern_6.seed, this_54.film_frame, pattern_6.pixel, pattern_6.ray, pattern_6.rays);
    // glimt_render_gpu/src/kernels/frame.rs:149
    if (this_54.filter_ == 1u) {
        // glimt_render_gpu/src/kernels/frame.rs:150
        chosen_24 = vec2(0.5f);
    } else {
        // glimt_render_gpu/src/kernels/frame.rs:152
        let _e23 = PixelPattern_pair(film, 1u, 0u, 1u);
        let _e24 = unit_vec2_(_e23);
        chosen_24 = _e24;
    }
    let place_4 = chosen_24;
    // glimt_render_gpu/src/kernels/frame.rs:154
    let _e28 = FrameParams_direction(this_54, pattern_6.pixel, place_4);
    // glimt_render_gpu/src/kernels/frame.rs:155
    let _e32 = PixelPattern_ray_key(film, 8u);
    let _e33 = Ray_keyed(this_54.eye, _e28, _e32);
    return _e33;
}

// glimt_render_gpu/src/kernels/environment.rs:56
fn Environment_map(size_19: vec2<u32>, rotation_4: vec2<f32>) -> Returned_Environment_map {

    // glimt_render_gpu/src/kernels/environment.rs:57
    return Returned_Environment_map(size_19, rotation_4);
}

// glimt_render_gpu/src/kernels/environment.rs:146
fn bilinear(size_20: vec2<u32>, d_3: vec3<f32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/environment.rs:147
    let _e4 = direction_to_uv(d_3);
    let p_1 = ((_e4 * vec2<f32>(size_20)) - vec2(0.5f));
    // glimt_render_gpu/src/kernels/environment.rs:149
    let next_1 = vec2<u32>((p_1 + vec2(1f)));
    // glimt_render_gpu/src/kernels/environment.rs:150
    let f = ((p_1 + vec2(1f)) - vec2<f32>(next_1));
    // glimt_render_gpu/src/kernels/environment.rs:151
    let x0_ = (((next_1.x + size_20.x) - 1u) % size_20.x);
    // glimt_render_gpu/src/kernels/environment.rs:152
    let x1_1 = (next_1.x % size_20.x);
    // glimt_render_gpu/src/kernels/environment.rs:153
    let row0_1 = ((max(next_1.y, 1u) * size_20.x) - size_20.x);
    // glimt_render_gpu/src/kernels/environment.rs:154
    let row1_1 = (min(next_1.y, (size_20.y - 1u)) * size_20.x);
    // glimt_render_gpu/src/kernels/environment.rs:155
    let _e53 = env_texels[(row0_1 + x0_)];
    let _e57 = env_texels[(row0_1 + x1_1)];
    let upper_2 = ((_e53 * (1f - f.x)) + (_e57 * f.x));
    // glimt_render_gpu/src/kernels/environment.rs:156
    let _e68 = env_texels[(row1_1 + x0_)];
    let _e72 = env_texels[(row1_1 + x1_1)];
    let lower_3 = ((_e68 * (1f - f.x)) + (_e72 * f.x));
    // glimt_render_gpu/src/kernels/environment.rs:157
    return ((upper_2 * (1f - f.y)) + (lower_3 * f.y)).xyz;
}

// glimt_render_gpu/src/kernels/environment.rs:46
fn RadianceMap_background(size_21: vec2<u32>, rotation_5: vec2<f32>, direction_9: vec3<f32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/environment.rs:47
    let to_map = vec2<f32>(rotation_5.x, -(rotation_5.y));
    // glimt_render_gpu/src/kernels/environment.rs:48
    let _e10 = rotate_z(direction_9, to_map);
    let _e11 = bilinear(size_21, _e10);
    return _e11;
}

// glimt_render_gpu/src/kernels/shade.rs:30
fn Vec4_of_background(ray_12: Ray, frame_4: FrameParams, map_size: vec2<u32>, map_rotation: vec2<f32>) -> vec4<f32> {

    // glimt_render_gpu/src/kernels/shade.rs:31
    if (frame_4.background == 0u) {
        // glimt_render_gpu/src/kernels/shade.rs:32
        let _e11 = RadianceMap_background(map_size, map_rotation, ray_12.direction);
        return vec4<f32>(_e11, 1f);
    }
    // glimt_render_gpu/src/kernels/shade.rs:34
    return vec4(0f);
}

// glimt_render_gpu/src/kernels/product.rs:55
fn shade_groups(pixel_5: u32, frame_5: FrameParams, rays_6: f32, threshold_7: f32, expected_first_7: u32, expected_slot_7: u32, env_size_7: vec2<u32>, env_rotation_7: vec2<f32>, points_start_9: u32, points_len_9: u32, samples_start: u32, samples_len: u32) {
    var drawn_1: Drawn;
    var leader_2: u32;
    var filled: u32;
    var number_1: u32;
    var group_6: Group;
    var counter_17: u32;
    var counter_18: u32;

    // glimt_render_gpu/src/kernels/product.rs:66
    let first_11 = (pixel_5 * frame_5.rays_per_pixel);
    // glimt_render_gpu/src/kernels/product.rs:67
    let _e16 = Environment_cells(env_size_7, env_rotation_7);
    let _e19 = FrameParams_pattern_of(frame_5, first_11);
    // glimt_render_gpu/src/kernels/product.rs:75
    drawn_1 = Drawn(0u, 0u);
    // glimt_render_gpu/src/kernels/product.rs:76
    leader_2 = 0u;
    // glimt_render_gpu/src/kernels/product.rs:77
    filled = 0u;
    // glimt_render_gpu/src/kernels/product.rs:78
    number_1 = 0u;
    // glimt_render_gpu/src/kernels/product.rs:79
    let _e35 = filled;
    let _e36 = next_group(points_start_9, points_len_9, (&leader_2), _e35);
    group_6 = _e36;
    // glimt_render_gpu/src/kernels/product.rs:80
    loop {
        let _e40 = group_6.members;
        if !((_e40 > 0u)) {
            break;
        }
        // glimt_render_gpu/src/kernels/product.rs:81
        let _e45 = group_6;
        let _e46 = number_1;
        let _e47 = GroupLight_reflected(env_size_7, env_rotation_7, _e16.value_size, _e16.value_start, _e19, rays_6, threshold_7, _e45, _e46, expected_first_7, expected_slot_7, points_start_9, points_len_9, (&drawn_1));
        // glimt_render_gpu/src/kernels/product.rs:82
        let _e51 = group_6.members;
        counter_17 = 0u;
        loop {
            let k_5 = counter_17;
            if (k_5 >= _e51) {
                break;
            }
            // glimt_render_gpu/src/kernels/product.rs:83
            let _e56 = group_6;
            let _e57 = Group_ray(_e56, k_5, points_start_9, points_len_9);
            // glimt_render_gpu/src/kernels/product.rs:84
            let point_7 = points[(points_start_9 + _e57)];
            // glimt_render_gpu/src/kernels/product.rs:85
            let own_3 = Reflected((_e47.lit + point_7.emission), _e47.blocked);
            // glimt_render_gpu/src/kernels/product.rs:89
            let _e70 = SeenPoint_is_catcher(point_7);
            let _e71 = Vec4_of_surface(own_3, _e70);
            samples_1[(samples_start + _e57)] = _e71;
            continuing {
                let _e75 = counter_17;
                counter_17 = (_e75 + 1u);
            }
        }
        // glimt_render_gpu/src/kernels/product.rs:91
        let _e80 = group_6.members;
        let _e81 = filled;
        filled = (_e81 + _e80);
        // glimt_render_gpu/src/kernels/product.rs:92
        let _e85 = number_1;
        number_1 = (_e85 + 1u);
        // glimt_render_gpu/src/kernels/product.rs:93
        let _e88 = filled;
        let _e89 = next_group(points_start_9, points_len_9, (&leader_2), _e88);
        group_6 = _e89;
    }
    // glimt_render_gpu/src/kernels/product.rs:95
    counter_18 = 0u;
    loop {
        let ray_14 = counter_18;
        if (ray_14 >= frame_5.rays_per_pixel) {
            break;
        }
        // glimt_render_gpu/src/kernels/product.rs:96
        let _e100 = points[(points_start_9 + ray_14)];
        let _e101 = SeenPoint_is_hit(_e100);
        if !(_e101) {
            // glimt_render_gpu/src/kernels/product.rs:97
            let _e105 = FrameParams_pattern_of(frame_5, (first_11 + ray_14));
            let _e106 = FrameParams_camera_ray(frame_5, _e105);
            // glimt_render_gpu/src/kernels/product.rs:98
            let _e108 = Environment_map(env_size_7, env_rotation_7);
            let _e111 = Vec4_of_background(_e106, frame_5, _e108.value_size, _e108.value_rotation);
            samples_1[(samples_start + ray_14)] = _e111;
        }
        continuing {
            let _e115 = counter_18;
            counter_18 = (_e115 + 1u);
        }
    }
    return;
}

// glimt_render_gpu/src/kernels/cells.rs:18
fn shade_cells_1(pixel_6: u32, frame_6: FrameParams, cells_1: CellParams, env_size_8: vec2<u32>, env_rotation_8: vec2<f32>, points_start_10: u32, points_len_10: u32, samples_start_1: u32, samples_len_1: u32) {

    // glimt_render_gpu/src/kernels/cells.rs:28
    let _e13 = CellParams_tile_of(cells_1, (frame_6.first_pixel + pixel_6), frame_6);
    // glimt_render_gpu/src/kernels/cells.rs:29
    // glimt_render_gpu/src/kernels/cells.rs:34
    let _e20 = threshold(frame_6, cells_1, 64u);
    // glimt_render_gpu/src/kernels/cells.rs:35
    shade_groups(pixel_6, frame_6, cells_1.rays, _e20, (_e13 * 3u), 0u, env_size_8, env_rotation_8, points_start_10, points_len_10, samples_start_1, samples_len_1);
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn shade_cells(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
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
    let _e25 = params.points_len;
    let _e28 = params.samples_len;
    shade_cells_1((_e14 + local), _e17, _e19, _e21, _e23, (local * _e25), _e25, (local * _e28), _e28);
}
