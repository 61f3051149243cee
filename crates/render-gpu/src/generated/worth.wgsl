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

struct Params {
    first: u32,
    count: u32,
    frame: FrameParams,
    env_size: vec2<u32>,
    env_rotation: vec2<f32>,
}

@group(0) @binding(1) 
var<storage> env_tables: array<u32>;
@group(0) @binding(2) 
var<storage> entries: array<TileEntry>;
@group(0) @binding(3) 
var<storage> visibility_3: array<u32>;
@group(0) @binding(4) 
var<storage, read_write> out: array<f32>;
@group(0) @binding(0) 
var<uniform> params: Params;

// glimt_render_gpu/src/kernels/environment.rs:78
fn Environment_cells(size: vec2<u32>, rotation: vec2<f32>) -> Returned_Environment_cells {

    // glimt_render_gpu/src/kernels/environment.rs:79
    return Returned_Environment_cells(size, 0u);
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
    let normal_4 = _e11.fa;
    let wo_2 = _e11.fb;
    // glimt_render_gpu/src/kernels/groups.rs:56
    let _e17 = CellSurface_new(normal_4, wo_2, diffuse, specular, exponent_2, 1f, 0f);
    // glimt_render_gpu/src/kernels/groups.rs:57
    return Representative(normal_4, vec3(diffuse), vec3(specular), exponent_2, _e17.peak, _e17);
}

// glimt_render_gpu/src/kernels/expect.rs:79
fn representative_of(entry: TileEntry, frame: FrameParams, env_size_1: vec2<u32>, env_rotation_1: vec2<f32>) -> Representative {

    // glimt_render_gpu/src/kernels/expect.rs:84
    let wo_3 = normalize((frame.eye - entry.position));
    // glimt_render_gpu/src/kernels/expect.rs:85
    let _e15 = Representative_alone(entry.normal, wo_3, entry.diffuse, entry.specular, entry.exponent, env_size_1, env_rotation_1);
    return _e15;
}

// glimt_light_cells/src/partition.rs:114
fn LightCells_quad(size_2: vec2<u32>, start: u32, list: u32, quad: u32) -> vec4<f32> {

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
    let s = clamp(sin2_theta, vec4(0f), vec4(1f));
    // glimt_light_cells/src/surface.rs:85
    let log_ = ((s * (vec4(6f) - s)) / (vec4(12f) - (8f * s)));
    // glimt_light_cells/src/surface.rs:86
    let t_1 = (min((exponent_3 * log_), vec4(40f)) * (1f / 256f));
    // glimt_light_cells/src/surface.rs:88
    let x_2 = (vec4(1f) - (t_1 * (vec4(1f) - (t_1 * (vec4(0.5f) - (t_1 * (1f / 6f)))))));
    // glimt_light_cells/src/surface.rs:89
    let x2_ = (x_2 * x_2);
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
    let n = surface.normal;
    // glimt_light_cells/src/surface.rs:180
    let c = (((_e7 * n.x) + (_e12 * n.y)) + (_e17 * n.z));
    // glimt_light_cells/src/surface.rs:181
    let reach = (_e20 + vec4(surface.horizon));
    // glimt_light_cells/src/surface.rs:182
    let up = max((c + reach), vec4(0f));
    // glimt_light_cells/src/surface.rs:183
    let _e45 = step_(up);
    // glimt_light_cells/src/surface.rs:184
    let _e48 = step_((c - reach));
    // glimt_light_cells/src/surface.rs:185
    let cosine = max(c, vec4(0f));
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
    let lifted = max(c, (0.25f * up));
    // glimt_light_cells/src/surface.rs:200
    let v = surface.wo;
    // glimt_light_cells/src/surface.rs:201
    let nv = dot(n, v);
    // glimt_light_cells/src/surface.rs:202
    let dv = ((((_e7 * v.x) + (_e12 * v.y)) + (_e17 * v.z)) + ((lifted - c) * nv));
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
    let e = max(surface.exponent, 0.001f);
    // glimt_light_cells/src/surface.rs:210
    let seen = (vec4(4f) / (vec4((4f / e)) + (0.7f * r2_)));
    // glimt_light_cells/src/surface.rs:211
    let _e157 = cosine_power4_(sin2_, seen);
    let lobe = (((_e157 * seen) * (lifted * _e45)) * ((surface.share * surface.peak) / e));
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
fn Expected_quad(first: u32, slot: u32, quad_2: u32) -> vec4<f32> {

    // glimt_render_gpu/src/kernels/cell_state.rs:254
    if (slot == 0u) {
        // glimt_render_gpu/src/kernels/cell_state.rs:255
        return vec4(0.75f);
    }
    // glimt_render_gpu/src/kernels/cell_state.rs:257
    let entry_1 = ((first + slot) - 1u);
    // glimt_render_gpu/src/kernels/cell_state.rs:258
    let word_1 = visibility_3[((entry_1 * 128u) + quad_2)];
    // glimt_render_gpu/src/kernels/cell_state.rs:259
    let _e22 = bytes_of(word_1);
    return (_e22 * (1f / 255f));
}

// glimt_light_cells/src/surface.rs:162
fn CellSurface_shape_variance(this_: CellSurface, terms: CellTerms) -> vec4<f32> {

    // glimt_light_cells/src/surface.rs:163
    let diffuse_1 = (terms.cosine_spread * this_.diffuse);
    // glimt_light_cells/src/surface.rs:164
    let lobe_1 = ((terms.lobe * terms.lobe_spread) * this_.specular);
    // glimt_light_cells/src/surface.rs:165
    return ((diffuse_1 * diffuse_1) + (lobe_1 * lobe_1));
}

// glimt_light_cells/src/surface.rs:153
fn CellSurface_blocked_weights(this_1: CellSurface, terms_1: CellTerms, flux: vec4<f32>, visibility: vec4<f32>) -> vec4<f32> {

    // glimt_light_cells/src/surface.rs:154
    let reflected = ((terms_1.cosine * this_1.diffuse) + (terms_1.lobe * this_1.specular));
    // glimt_light_cells/src/surface.rs:155
    let blocked = ((vec4(1f) - (visibility * visibility)) + vec4(0.0002f));
    // glimt_light_cells/src/surface.rs:156
    let _e22 = CellSurface_shape_variance(this_1, terms_1);
    // glimt_light_cells/src/surface.rs:157
    let _e29 = sqrt_((((reflected * reflected) * blocked) + _e22));
    return ((flux * terms_1.live) * _e29);
}

// glimt_light_cells/src/surface.rs:142
fn CellSurface_residual_weights(this_2: CellSurface, terms_2: CellTerms, flux_1: vec4<f32>, visibility_1: vec4<f32>) -> vec4<f32> {

    // glimt_light_cells/src/surface.rs:143
    let reflected_1 = ((terms_2.cosine * this_2.diffuse) + (terms_2.lobe * this_2.specular));
    // glimt_light_cells/src/surface.rs:144
    let by_visibility = ((visibility_1 * (vec4(1f) - visibility_1)) + vec4(0.0002f));
    // glimt_light_cells/src/surface.rs:145
    let _e22 = CellSurface_shape_variance(this_2, terms_2);
    let by_shape = (_e22 * max(visibility_1, vec4(0.02f)));
    // glimt_light_cells/src/surface.rs:146
    let _e33 = sqrt_((((reflected_1 * reflected_1) * by_visibility) + by_shape));
    return ((flux_1 * terms_2.live) * _e33);
}

// glimt_light_cells/src/surface.rs:133
fn CellSurface_product_weights(this_3: CellSurface, terms_3: CellTerms, flux_2: vec4<f32>) -> vec4<f32> {

    // glimt_light_cells/src/surface.rs:134
    let reflected_2 = ((terms_3.cosine * this_3.diffuse) + (terms_3.lobe * this_3.specular));
    // glimt_light_cells/src/surface.rs:135
    return ((flux_2 * terms_3.live) * (reflected_2 + (terms_3.cosine_spread * this_3.diffuse)));
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
    var counter: u32;

    // glimt_render_gpu/src/kernels/proposal.rs:197
    let surface_3 = of_.surface;
    // glimt_render_gpu/src/kernels/proposal.rs:198
    let has_lobe = (surface_3.specular > 0f);
    // glimt_render_gpu/src/kernels/proposal.rs:199
    t = Totals(array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f), array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f), 0f, 0f, 0f, 0f, 0f, 0f, 0f, vec3(0f), vec3(0f), vec3(0f), vec3(0f));
    // glimt_render_gpu/src/kernels/proposal.rs:214
    counter = 0u;
    loop {
        let quad_6 = counter;
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
            let weight = (((_e62.x + _e62.y) + _e62.z) + _e62.w);
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
                let a_1 = (_e45.lobe * _e43);
                // glimt_render_gpu/src/kernels/proposal.rs:236
                let spread = ((a_1 * _e45.lobe_spread) * _e45.lobe_spread);
                // glimt_render_gpu/src/kernels/proposal.rs:237
                let _e126 = t.lobe;
                t.lobe = (_e126 + (((a_1.x + a_1.y) + a_1.z) + a_1.w));
                // glimt_render_gpu/src/kernels/proposal.rs:238
                let _e137 = t.lobe_spread;
                t.lobe_spread = (_e137 + (((spread.x + spread.y) + spread.z) + spread.w));
                // glimt_render_gpu/src/kernels/proposal.rs:239
                let _e140 = (a_1 * _e60);
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
            t.quads[quad_6] = weight;
            // glimt_render_gpu/src/kernels/proposal.rs:247
            t.lives[quad_6] = live;
            // glimt_render_gpu/src/kernels/proposal.rs:248
            let _e198 = t.weight;
            t.weight = (_e198 + weight);
            // glimt_render_gpu/src/kernels/proposal.rs:249
            let _e202 = t.live;
            t.live = (_e202 + live);
        }
        continuing {
            let _e204 = counter;
            counter = (_e204 + 1u);
        }
    }
    // glimt_render_gpu/src/kernels/proposal.rs:252
    let _e208 = t;
    return _e208;
}

// glimt_render_gpu/src/kernels/proposal.rs:275
fn worth_1(a: f32, visible: f32, variance: f32) -> f32 {

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
    var first_1: Totals;
    var lobe_worth: f32;
    var least_share: f32;
    var share: f32;
    var defence: f32;
    var total: f32;
    var quads: array<f32, 128>;
    var rows: array<f32, 16>;
    var counter_1: u32;
    var of_row: f32;
    var counter_2: u32;
    var lobe_share: f32;

    // glimt_render_gpu/src/kernels/proposal.rs:300
    of_2 = of_1;
    // glimt_render_gpu/src/kernels/proposal.rs:301
    let _e10 = of_2;
    let _e11 = weigh(_e10, cells_size_4, cells_start_4, expected_first_1, expected_slot_1, is_catcher_2);
    sums = _e11;
    // glimt_render_gpu/src/kernels/proposal.rs:302
    let _e14 = sums;
    first_1 = _e14;
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
        let a_2 = (_e75 * _e78);
        // glimt_render_gpu/src/kernels/proposal.rs:318
        let _e82 = sums.lobe_visible;
        let _e84 = sums.lobe;
        let visible_1 = min((_e82 / _e84), 1f);
        // glimt_render_gpu/src/kernels/proposal.rs:319
        let _e89 = share;
        if (_e89 < 1f) {
            // glimt_render_gpu/src/kernels/proposal.rs:320
            let _e94 = share;
            let _e96 = worth_1(a_2, visible_1, by_lobe);
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
    counter_1 = 0u;
    loop {
        let row = counter_1;
        if (row >= 16u) {
            break;
        }
        // glimt_render_gpu/src/kernels/proposal.rs:336
        of_row = 0f;
        // glimt_render_gpu/src/kernels/proposal.rs:337
        counter_2 = (row * 8u);
        loop {
            let quad_7 = counter_2;
            if (quad_7 >= ((row + 1u) * 8u)) {
                break;
            }
            // glimt_render_gpu/src/kernels/proposal.rs:338
            let _e160 = sums.quads[quad_7];
            let _e161 = defence;
            let _e164 = sums.lives[quad_7];
            let weight_1 = (_e160 + (_e161 * _e164));
            // glimt_render_gpu/src/kernels/proposal.rs:339
            quads[quad_7] = weight_1;
            // glimt_render_gpu/src/kernels/proposal.rs:340
            let _e170 = of_row;
            of_row = (_e170 + weight_1);
            continuing {
                let _e172 = counter_2;
                counter_2 = (_e172 + 1u);
            }
        }
        // glimt_render_gpu/src/kernels/proposal.rs:342
        let _e176 = of_row;
        rows[row] = _e176;
        // glimt_render_gpu/src/kernels/proposal.rs:343
        let _e179 = of_row;
        let _e180 = total;
        total = (_e180 + _e179);
        continuing {
            let _e182 = counter_1;
            counter_1 = (_e182 + 1u);
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
    let _e215 = first_1.diffuse;
    let _e218 = of_2.specular;
    let _e220 = first_1.specular;
    let _e221 = share;
    let _e226 = first_1.open_diffuse;
    let _e229 = of_2.specular;
    let _e231 = first_1.open_specular;
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

// glimt_render_gpu/src/kernels/expect.rs:97
fn worth_2(tile: u32, frame_1: FrameParams, env_size_2: vec2<u32>, env_rotation_2: vec2<f32>) -> f32 {
    var sum: f32;
    var counter_3: u32;
    var proposal: Proposal;

    // glimt_render_gpu/src/kernels/expect.rs:104
    let _e6 = Environment_cells(env_size_2, env_rotation_2);
    // glimt_render_gpu/src/kernels/expect.rs:105
    sum = 0f;
    // glimt_render_gpu/src/kernels/expect.rs:106
    counter_3 = 0u;
    loop {
        let slot_1 = counter_3;
        if (slot_1 >= 3u) {
            break;
        }
        // glimt_render_gpu/src/kernels/expect.rs:107
        let entry_2 = entries[((tile * 3u) + slot_1)];
        // glimt_render_gpu/src/kernels/expect.rs:108
        if (entry_2.surface != 0u) {
            // glimt_render_gpu/src/kernels/expect.rs:109
            // glimt_render_gpu/src/kernels/expect.rs:114
            let _e35 = representative_of(entry_2, frame_1, env_size_2, env_rotation_2);
            // glimt_render_gpu/src/kernels/expect.rs:115
            let _e40 = Proposal_new(_e35, _e6.value_size, _e6.value_start, (tile * 3u), (slot_1 + 1u), (entry_2.catcher != 0u));
            proposal = _e40;
            // glimt_render_gpu/src/kernels/expect.rs:116
            let _e46 = proposal.total;
            let _e48 = proposal.lobe_worth;
            let _e51 = sum;
            sum = (_e51 + (f32(entry_2.hits) * (_e46 + _e48)));
        }
        continuing {
            let _e53 = counter_3;
            counter_3 = (_e53 + 1u);
        }
    }
    // glimt_render_gpu/src/kernels/expect.rs:119
    let _e57 = sum;
    return _e57;
}

@compute @workgroup_size(64, 1, 1) 
fn worth(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let local = ((id.y * (groups.x * 64u)) + id.x);
    let _e11 = params.count;
    if (local >= _e11) {
        return;
    }
    let _e14 = params.first;
    let _e17 = params.frame;
    let _e19 = params.env_size;
    let _e21 = params.env_rotation;
    let _e22 = worth_2((_e14 + local), _e17, _e19, _e21);
    out[local] = _e22;
}
