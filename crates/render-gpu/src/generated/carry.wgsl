// Made from Rust by naga-front-rust; do not edit. This command writes it: cargo run --release -p glimt-generate

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

struct PastView {
    eye: vec3<f32>,
    first_pixel: u32,
    forward: vec3<f32>,
    pixels: u32,
    right: vec3<f32>,
    depth_tolerance: f32,
    up: vec3<f32>,
    normal_cosine: f32,
}

struct Option_Vec3_ {
    is_some: bool,
    value: vec3<f32>,
}

struct Tuple_u32_u32_ {
    fa: u32,
    fb: u32,
}

struct Returned_Environment_cells {
    value_size: vec2<u32>,
    value_start: u32,
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

struct CellTerms {
    cosine: vec4<f32>,
    full: vec4<f32>,
    live: vec4<f32>,
    lobe: vec4<f32>,
    lobe_spread: vec4<f32>,
    cosine_spread: vec4<f32>,
}

struct Tuple_Vec4_Vec4_ {
    fa: vec4<f32>,
    fb: vec4<f32>,
}

struct QuadCounts {
    rays: vec4<f32>,
    arrived: vec4<f32>,
}

struct Params {
    first: u32,
    count: u32,
    entries_len: u32,
    frame: FrameParams,
    cells: CellParams,
    view: PastView,
    env_size: vec2<u32>,
    env_rotation: vec2<f32>,
}

@group(0) @binding(1) 
var<storage> env_tables: array<u32>;
@group(0) @binding(2) 
var<storage> motions: array<mat4x4<f32>>;
@group(0) @binding(3) 
var<storage> past_entries: array<TileEntry>;
@group(0) @binding(4) 
var<storage> past_counts: array<u32>;
@group(0) @binding(5) 
var<storage, read_write> entries: array<TileEntry>;
@group(0) @binding(0) 
var<uniform> params: Params;

// glimt_render_gpu/src/kernels/past.rs:125
fn PastView_project(this_: PastView, was_at: vec3<f32>, size: vec2<f32>) -> Option_Vec3_ {

    // glimt_render_gpu/src/kernels/past.rs:126
    let v = (was_at - this_.eye);
    // glimt_render_gpu/src/kernels/past.rs:127
    let along = dot(v, this_.forward);
    // glimt_render_gpu/src/kernels/past.rs:128
    if !((along > 0f)) {
        // glimt_render_gpu/src/kernels/past.rs:129
        return Option_Vec3_();
    }
    // glimt_render_gpu/src/kernels/past.rs:131
    let x_2 = (dot(v, this_.right) / (along * dot(this_.right, this_.right)));
    // glimt_render_gpu/src/kernels/past.rs:132
    let y = (dot(v, this_.up) / (along * dot(this_.up, this_.up)));
    // glimt_render_gpu/src/kernels/past.rs:133
    let place = (vec2<f32>((0.5f + (0.5f * x_2)), (0.5f - (0.5f * y))) * size);
    // glimt_render_gpu/src/kernels/past.rs:134
    return Option_Vec3_(true, vec3<f32>(place, length(v)));
}

// glimt_render_gpu/src/kernels/cell_state.rs:83
fn slot_of(surface: u32, first: u32) -> u32 {
    var slot: u32;
    var counter: u32;

    // glimt_render_gpu/src/kernels/cell_state.rs:84
    slot = 0u;
    // glimt_render_gpu/src/kernels/cell_state.rs:85
    counter = 0u;
    loop {
        let i = counter;
        if (i >= 3u) {
            break;
        }
        // glimt_render_gpu/src/kernels/cell_state.rs:86
        let own = past_entries[(first + i)].surface;
        // glimt_render_gpu/src/kernels/cell_state.rs:88
        let _e19 = slot;
        if ((_e19 == 0u) && ((own == surface) || ((i == (3u - 1u)) && (own != 0u)))) {
            // glimt_render_gpu/src/kernels/cell_state.rs:89
            slot = (i + 1u);
        }
        continuing {
            let _e35 = counter;
            counter = (_e35 + 1u);
        }
    }
    // glimt_render_gpu/src/kernels/cell_state.rs:92
    let _e39 = slot;
    return _e39;
}

// glimt_render_gpu/src/kernels/carry.rs:56
fn came_from(entry: TileEntry, frame: FrameParams, cells: CellParams, view: PastView) -> u32 {
    var chosen: u32;

    // glimt_render_gpu/src/kernels/carry.rs:64
    if (cells.has_past == 0u) {
        // glimt_render_gpu/src/kernels/carry.rs:65
        return 0u;
    }
    // glimt_render_gpu/src/kernels/carry.rs:67
    let motion = motions[(entry.surface - 1u)];
    // glimt_render_gpu/src/kernels/carry.rs:68
    let was_at_1 = (motion * vec4<f32>(entry.position, 1f)).xyz;
    // glimt_render_gpu/src/kernels/carry.rs:69
    let size_5 = vec2<f32>(f32(frame.width), f32(frame.height));
    // glimt_render_gpu/src/kernels/carry.rs:70
    let _e31 = PastView_project(view, was_at_1, size_5);
    if !(_e31.is_some) {
        // glimt_render_gpu/src/kernels/carry.rs:71
        return 0u;
    }
    let seen = _e31.value;
    // glimt_render_gpu/src/kernels/carry.rs:73
    if !(((((seen.x >= 0f) && (seen.y >= 0f)) && (seen.x < size_5.x)) && (seen.y < size_5.y))) {
        // glimt_render_gpu/src/kernels/carry.rs:74
        return 0u;
    }
    // glimt_render_gpu/src/kernels/carry.rs:76
    let _e65 = Tuple_u32_u32_((u32(seen.x) / 16u), (u32(seen.y) / 10u));
    let column = _e65.fa;
    let row = _e65.fb;
    // glimt_render_gpu/src/kernels/carry.rs:77
    let first_2 = (((row * cells.tiles_across) + column) * 3u);
    // glimt_render_gpu/src/kernels/carry.rs:78
    let _e76 = slot_of(entry.surface, first_2);
    // glimt_render_gpu/src/kernels/carry.rs:79
    if (_e76 == 0u) {
        chosen = 0u;
    } else {
        chosen = (first_2 + _e76);
    }
    let _e83 = chosen;
    return _e83;
}

// glimt_render_gpu/src/kernels/environment.rs:78
fn Environment_cells(size_1: vec2<u32>, rotation: vec2<f32>) -> Returned_Environment_cells {

    // glimt_render_gpu/src/kernels/environment.rs:79
    return Returned_Environment_cells(size_1, 0u);
}

// glimt_probe/src/rotate.rs:33
fn rotate_z(d: vec3<f32>, cos_sin: vec2<f32>) -> vec3<f32> {

    // glimt_probe/src/rotate.rs:34
    return vec3<f32>(((d.x * cos_sin.x) - (d.y * cos_sin.y)), ((d.x * cos_sin.y) + (d.y * cos_sin.x)), d.z);
}

// glimt_render_gpu/src/kernels/environment.rs:89
fn Environment_to_map(size_2: vec2<u32>, rotation_1: vec2<f32>, direction: vec3<f32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/environment.rs:90
    let _e8 = rotate_z(direction, vec2<f32>(rotation_1.x, -(rotation_1.y)));
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
fn CellSurface_new(normal: vec3<f32>, wo: vec3<f32>, kd: f32, ks: f32, exponent_1: f32, mean_length: f32, horizon: f32) -> CellSurface {

    // glimt_light_cells/src/surface.rs:115
    let r = clamp(mean_length, 0.001f, 1f);
    // glimt_light_cells/src/surface.rs:116
    let widened = ((exponent_1 * r) / (r + (exponent_1 * (1f - r))));
    // glimt_light_cells/src/surface.rs:117
    let _e22 = normalisation(widened);
    return CellSurface(normal, wo, (kd * 0.31830987f), ks, widened, _e22, sqrt((2f * (1f - r))), horizon, 1f);
}

// glimt_render_gpu/src/kernels/groups.rs:47
fn Representative_alone(normal_1: vec3<f32>, wo_1: vec3<f32>, diffuse: f32, specular: f32, exponent_2: f32, env_size: vec2<u32>, env_rotation: vec2<f32>) -> Representative {

    // glimt_render_gpu/src/kernels/groups.rs:55
    let _e9 = Environment_to_map(env_size, env_rotation, normal_1);
    let _e10 = Environment_to_map(env_size, env_rotation, wo_1);
    let _e11 = Tuple_Vec3_Vec3_(_e9, _e10);
    let normal_2 = _e11.fa;
    let wo_2 = _e11.fb;
    // glimt_render_gpu/src/kernels/groups.rs:56
    let _e17 = CellSurface_new(normal_2, wo_2, diffuse, specular, exponent_2, 1f, 0f);
    // glimt_render_gpu/src/kernels/groups.rs:57
    return Representative(normal_2, vec3(diffuse), vec3(specular), exponent_2, _e17.peak, _e17);
}

// glimt_render_gpu/src/kernels/expect.rs:79
fn representative_of(entry_1: TileEntry, frame_1: FrameParams, env_size_1: vec2<u32>, env_rotation_1: vec2<f32>) -> Representative {

    // glimt_render_gpu/src/kernels/expect.rs:84
    let wo_3 = normalize((frame_1.eye - entry_1.position));
    // glimt_render_gpu/src/kernels/expect.rs:85
    let _e15 = Representative_alone(entry_1.normal, wo_3, entry_1.diffuse, entry_1.specular, entry_1.exponent, env_size_1, env_rotation_1);
    return _e15;
}

// glimt_light_cells/src/partition.rs:114
fn LightCells_quad(size_3: vec2<u32>, start: u32, list: u32, quad: u32) -> vec4<f32> {

    // glimt_light_cells/src/partition.rs:115
    let at = (((start + 32u) + (list * 512u)) + (4u * quad));
    // glimt_light_cells/src/partition.rs:116
    let _e16 = env_tables[at];
    let _e22 = env_tables[(at + 1u)];
    let _e28 = env_tables[(at + 2u)];
    let _e34 = env_tables[(at + 3u)];
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
    let s_1 = clamp(sin2_theta, vec4(0f), vec4(1f));
    // glimt_light_cells/src/surface.rs:85
    let log_ = ((s_1 * (vec4(6f) - s_1)) / (vec4(12f) - (8f * s_1)));
    // glimt_light_cells/src/surface.rs:86
    let t = (min((exponent_3 * log_), vec4(40f)) * (1f / 256f));
    // glimt_light_cells/src/surface.rs:88
    let x_3 = (vec4(1f) - (t * (vec4(1f) - (t * (vec4(0.5f) - (t * (1f / 6f)))))));
    // glimt_light_cells/src/surface.rs:89
    let x2_ = (x_3 * x_3);
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
fn LightCells_terms(size_4: vec2<u32>, start_1: u32, surface_1: CellSurface, quad_1: u32) -> CellTerms {

    // glimt_light_cells/src/surface.rs:174
    let _e7 = LightCells_quad(size_4, start_1, 15u, quad_1);
    // glimt_light_cells/src/surface.rs:175
    let _e12 = LightCells_quad(size_4, start_1, (15u + 1u), quad_1);
    // glimt_light_cells/src/surface.rs:176
    let _e17 = LightCells_quad(size_4, start_1, (15u + 2u), quad_1);
    // glimt_light_cells/src/surface.rs:177
    let _e20 = LightCells_quad(size_4, start_1, 18u, quad_1);
    // glimt_light_cells/src/surface.rs:178
    let _e23 = LightCells_quad(size_4, start_1, 19u, quad_1);
    // glimt_light_cells/src/surface.rs:179
    let n_1 = surface_1.normal;
    // glimt_light_cells/src/surface.rs:180
    let c = (((_e7 * n_1.x) + (_e12 * n_1.y)) + (_e17 * n_1.z));
    // glimt_light_cells/src/surface.rs:181
    let reach = (_e20 + vec4(surface_1.horizon));
    // glimt_light_cells/src/surface.rs:182
    let up = max((c + reach), vec4(0f));
    // glimt_light_cells/src/surface.rs:183
    let _e45 = step_(up);
    // glimt_light_cells/src/surface.rs:184
    let _e48 = step_((c - reach));
    // glimt_light_cells/src/surface.rs:185
    let cosine = max(c, vec4(0f));
    // glimt_light_cells/src/surface.rs:186
    let half_spread = vec4((0.5f * surface_1.spread));
    // glimt_light_cells/src/surface.rs:187
    let cosine_spread = ((_e48 * half_spread) + ((vec4(1f) - _e48) * (0.35f * min(up, (2f * _e23)))));
    // glimt_light_cells/src/surface.rs:188
    if !((surface_1.specular > 0f)) {
        // glimt_light_cells/src/surface.rs:189
        return CellTerms(cosine, _e48, _e45, vec4(0f), vec4(0f), cosine_spread);
    }
    // glimt_light_cells/src/surface.rs:199
    let lifted = max(c, (0.25f * up));
    // glimt_light_cells/src/surface.rs:200
    let v_1 = surface_1.wo;
    // glimt_light_cells/src/surface.rs:201
    let nv = dot(n_1, v_1);
    // glimt_light_cells/src/surface.rs:202
    let dv = ((((_e7 * v_1.x) + (_e12 * v_1.y)) + (_e17 * v_1.z)) + ((lifted - c) * nv));
    // glimt_light_cells/src/surface.rs:203
    let _e111 = sqrt_(max(((vec4(1f) + (lifted * lifted)) - (c * c)), vec4(0.000001f)));
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
    let seen_1 = (vec4(4f) / (vec4((4f / e)) + (0.7f * r2_)));
    // glimt_light_cells/src/surface.rs:211
    let _e157 = cosine_power4_(sin2_, seen_1);
    let lobe = (((_e157 * seen_1) * (lifted * _e45)) * ((surface_1.share * surface_1.peak) / e));
    // glimt_light_cells/src/surface.rs:213
    let _e171 = sqrt_((sin2_ / max(cos2_, vec4(0.0001f))));
    // glimt_light_cells/src/surface.rs:214
    let near = (vec4((((0.1f * e) * surface_1.spread) * surface_1.spread)) + ((0.06f * e) * r2_));
    // glimt_light_cells/src/surface.rs:215
    let slope = (((0.5f * e) * _e171) * ((0.5f * _e23) + half_spread));
    // glimt_light_cells/src/surface.rs:216
    return CellTerms(cosine, _e48, _e45, lobe, min((slope + near), vec4(1f)), cosine_spread);
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
fn Remembered_cell(from_: u32, turned: u32, cell: u32) -> u32 {

    // glimt_render_gpu/src/kernels/cell_state.rs:171
    let column_1 = ((((cell % 32u) + 32u) - turned) % 32u);
    // glimt_render_gpu/src/kernels/cell_state.rs:172
    let was = (((cell / 32u) * 32u) + column_1);
    // glimt_render_gpu/src/kernels/cell_state.rs:173
    let word_2 = past_counts[(((from_ - 1u) * 256u) + (was / 2u))];
    // glimt_render_gpu/src/kernels/cell_state.rs:174
    let own_1 = ((word_2 >> ((16u * (was & 1u)) & 31u)) & 65535u);
    // glimt_render_gpu/src/kernels/cell_state.rs:175
    let _e44 = remembered((own_1 & 255u), (own_1 >> 8u));
    return _e44;
}

// glimt_render_gpu/src/kernels/cell_state.rs:181
fn Remembered_word(from_1: u32, turned_1: u32, word: u32) -> u32 {

    // glimt_render_gpu/src/kernels/cell_state.rs:182
    if (from_1 == 0u) {
        // glimt_render_gpu/src/kernels/cell_state.rs:183
        return 0u;
    }
    // glimt_render_gpu/src/kernels/cell_state.rs:185
    let _e12 = Remembered_cell(from_1, turned_1, (2u * word));
    let _e17 = Remembered_cell(from_1, turned_1, ((2u * word) + 1u));
    return (_e12 | (_e17 << 16u));
}

// glimt_render_gpu/src/kernels/cell_state.rs:98
fn bytes_of(word_1: u32) -> vec4<f32> {

    // glimt_render_gpu/src/kernels/cell_state.rs:99
    return vec4<f32>(f32((word_1 & 255u)), f32(((word_1 >> 8u) & 255u)), f32(((word_1 >> 16u) & 255u)), f32((word_1 >> 24u)));
}

// glimt_render_gpu/src/kernels/cell_state.rs:119
fn quad_counts(first_1: u32, second: u32) -> QuadCounts {

    // glimt_render_gpu/src/kernels/cell_state.rs:120
    let _e4 = bytes_of(first_1);
    let _e5 = bytes_of(second);
    let _e6 = Tuple_Vec4_Vec4_(_e4, _e5);
    let low = _e6.fa;
    let high = _e6.fb;
    // glimt_render_gpu/src/kernels/cell_state.rs:121
    return QuadCounts(vec4<f32>(low.x, low.z, high.x, high.z), vec4<f32>(low.y, low.w, high.y, high.w));
}

// glimt_render_gpu/src/kernels/cell_state.rs:191
fn Remembered_counts(from_2: u32, turned_2: u32, quad_2: u32) -> QuadCounts {

    // glimt_render_gpu/src/kernels/cell_state.rs:192
    let _e7 = Remembered_word(from_2, turned_2, (2u * quad_2));
    let _e12 = Remembered_word(from_2, turned_2, ((2u * quad_2) + 1u));
    let _e13 = quad_counts(_e7, _e12);
    return _e13;
}

// glimt_render_gpu/src/kernels/cell_state.rs:219
fn Remembered_quad(from_3: u32, turned_3: u32, quad_3: u32) -> vec4<f32> {

    // glimt_render_gpu/src/kernels/cell_state.rs:220
    let _e5 = Remembered_counts(from_3, turned_3, quad_3);
    // glimt_render_gpu/src/kernels/cell_state.rs:221
    return ((_e5.arrived + vec4((4f * 0.75f))) / (_e5.rays + vec4(4f)));
}

// glimt_light_cells/src/surface.rs:162
fn CellSurface_shape_variance(this_1: CellSurface, terms: CellTerms) -> vec4<f32> {

    // glimt_light_cells/src/surface.rs:163
    let diffuse_1 = (terms.cosine_spread * this_1.diffuse);
    // glimt_light_cells/src/surface.rs:164
    let lobe_1 = ((terms.lobe * terms.lobe_spread) * this_1.specular);
    // glimt_light_cells/src/surface.rs:165
    return ((diffuse_1 * diffuse_1) + (lobe_1 * lobe_1));
}

// glimt_light_cells/src/surface.rs:142
fn CellSurface_residual_weights(this_2: CellSurface, terms_1: CellTerms, flux: vec4<f32>, visibility: vec4<f32>) -> vec4<f32> {

    // glimt_light_cells/src/surface.rs:143
    let reflected = ((terms_1.cosine * this_2.diffuse) + (terms_1.lobe * this_2.specular));
    // glimt_light_cells/src/surface.rs:144
    let by_visibility = ((visibility * (vec4(1f) - visibility)) + vec4(0.0002f));
    // glimt_light_cells/src/surface.rs:145
    let _e22 = CellSurface_shape_variance(this_2, terms_1);
    let by_shape = (_e22 * max(visibility, vec4(0.02f)));
    // glimt_light_cells/src/surface.rs:146
    let _e33 = sqrt_((((reflected * reflected) * by_visibility) + by_shape));
    return ((flux * terms_1.live) * _e33);
}

// glimt_render_gpu/src/kernels/carry.rs:84
fn unknown(entry_2: TileEntry, frame_2: FrameParams, env_size_2: vec2<u32>, env_rotation_2: vec2<f32>, remembered_from: u32, remembered_turned: u32) -> f32 {
    var all_: f32;
    var unseen: f32;
    var counter_1: u32;
    var chosen_1: f32;

    // glimt_render_gpu/src/kernels/carry.rs:90
    let _e8 = Environment_cells(env_size_2, env_rotation_2);
    // glimt_render_gpu/src/kernels/carry.rs:91
    let _e12 = representative_of(entry_2, frame_2, env_size_2, env_rotation_2);
    let surface_2 = _e12.surface;
    // glimt_render_gpu/src/kernels/carry.rs:92
    all_ = 0f;
    // glimt_render_gpu/src/kernels/carry.rs:93
    unseen = 0f;
    // glimt_render_gpu/src/kernels/carry.rs:94
    counter_1 = 0u;
    loop {
        let quad_4 = counter_1;
        if (quad_4 >= 128u) {
            break;
        }
        // glimt_render_gpu/src/kernels/carry.rs:95
        let _e28 = LightCells_quad(_e8.value_size, _e8.value_start, 0u, quad_4);
        // glimt_render_gpu/src/kernels/carry.rs:96
        let _e30 = LightCells_terms(_e8.value_size, _e8.value_start, surface_2, quad_4);
        // glimt_render_gpu/src/kernels/carry.rs:97
        let _e32 = Remembered_quad(remembered_from, remembered_turned, quad_4);
        let _e33 = CellSurface_residual_weights(surface_2, _e30, _e28, _e32);
        // glimt_render_gpu/src/kernels/carry.rs:98
        let _e42 = all_;
        all_ = (_e42 + (((_e33.x + _e33.y) + _e33.z) + _e33.w));
        // glimt_render_gpu/src/kernels/carry.rs:99
        let _e45 = Remembered_counts(remembered_from, remembered_turned, quad_4);
        let _e50 = (_e33 / (_e45.rays + vec4(1f)));
        let _e58 = unseen;
        unseen = (_e58 + (((_e50.x + _e50.y) + _e50.z) + _e50.w));
        continuing {
            let _e60 = counter_1;
            counter_1 = (_e60 + 1u);
        }
    }
    // glimt_render_gpu/src/kernels/carry.rs:102
    let _e65 = all_;
    if (_e65 > 0f) {
        let _e68 = unseen;
        let _e69 = all_;
        chosen_1 = (_e68 / _e69);
    } else {
        chosen_1 = 0f;
    }
    let _e72 = chosen_1;
    return _e72;
}

// glimt_render_gpu/src/kernels/carry.rs:23
fn carry_1(_tile: u32, frame_3: FrameParams, cells_1: CellParams, view_1: PastView, env_size_3: vec2<u32>, env_rotation_3: vec2<f32>, entries_start: u32, entries_len: u32) {
    var counter_2: u32;
    var share: f32;
    var both: bool;
    var chosen_2: u32;

    // glimt_render_gpu/src/kernels/carry.rs:34
    counter_2 = 0u;
    loop {
        let slot_1 = counter_2;
        if (slot_1 >= 3u) {
            break;
        }
        // glimt_render_gpu/src/kernels/carry.rs:35
        let entry_3 = entries[(entries_start + slot_1)];
        // glimt_render_gpu/src/kernels/carry.rs:36
        if (entry_3.surface != 0u) {
            // glimt_render_gpu/src/kernels/carry.rs:37
            let _e23 = came_from(entry_3, frame_3, cells_1, view_1);
            // glimt_render_gpu/src/kernels/carry.rs:38
            // glimt_render_gpu/src/kernels/carry.rs:43
            share = cells_1.pilot;
            // glimt_render_gpu/src/kernels/carry.rs:44
            let _e31 = (_e23 > 0u);
            both = _e31;
            if _e31 {
                let _e33 = unknown(entry_3, frame_3, env_size_3, env_rotation_3, _e23, cells_1.turned);
                both = (_e33 <= 0.4f);
            }
            let _e36 = both;
            if _e36 {
                // glimt_render_gpu/src/kernels/carry.rs:45
                share = cells_1.upkeep;
            }
            // glimt_render_gpu/src/kernels/carry.rs:47
            let _e41 = share;
            let rays = ((cells_1.rays * _e41) * f32((2u * 2u)));
            // glimt_render_gpu/src/kernels/carry.rs:48
            entries[(entries_start + slot_1)].from_ = _e23;
            // glimt_render_gpu/src/kernels/carry.rs:49
            let _e55 = share;
            if (_e55 > 0f) {
                chosen_2 = u32(max(rays, 1f));
            } else {
                chosen_2 = 0u;
            }
            let _e62 = chosen_2;
            entries[(entries_start + slot_1)].pilots = _e62;
        }
        continuing {
            let _e67 = counter_2;
            counter_2 = (_e67 + 1u);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn carry(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let local = ((id.y * (groups.x * 64u)) + id.x);
    let _e11 = params.count;
    if (local >= _e11) {
        return;
    }
    let _e14 = params.first;
    let _e17 = params.frame;
    let _e19 = params.cells;
    let _e21 = params.view;
    let _e23 = params.env_size;
    let _e25 = params.env_rotation;
    let _e27 = params.entries_len;
    carry_1((_e14 + local), _e17, _e19, _e21, _e23, _e25, (local * _e27), _e27);
}
