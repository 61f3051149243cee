// Made from Rust by naga-front-rust; do not edit. This command writes it: cargo run --release -p glimt-generate

struct Bin {
    index: u32,
    first: u32,
    units: u32,
}

struct Tuple_u32_u32_ {
    fa: u32,
    fb: u32,
}

struct TexelDraw {
    texel: vec2<u32>,
    pmf: f32,
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

struct CellTerms {
    cosine: vec4<f32>,
    full: vec4<f32>,
    live: vec4<f32>,
    lobe: vec4<f32>,
    lobe_spread: vec4<f32>,
    cosine_spread: vec4<f32>,
}

@group(0) @binding(1) 
var<storage> words: array<u32>;

// glimt_envmap_cdf/src/search.rs:31
fn find_bin(start: u32, bins: u32, u: u32) -> Bin {
    var at: u32;
    var left: u32;

    // glimt_envmap_cdf/src/search.rs:33
    at = start;
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
        let _e22 = words[(_e18 + half)];
        if (_e22 <= u) {
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
    let first_1 = words[_e31];
    // glimt_envmap_cdf/src/search.rs:43
    let _e36 = at;
    let _e38 = at;
    let _e43 = words[(_e38 + 1u)];
    return Bin((_e36 - start), first_1, (_e43 - first_1));
}

// glimt_light_cells/src/partition.rs:100
fn column_of(x: u32, width: u32) -> u32 {

    // glimt_light_cells/src/partition.rs:101
    return (((32u * (x + 1u)) - 1u) / width);
}

// glimt_light_cells/src/partition.rs:134
fn cell_of(size: vec2<u32>, start_1: u32, texel: vec2<u32>) -> u32 {

    // glimt_light_cells/src/partition.rs:135
    let _e7 = find_bin(start_1, 16u, texel.y);
    let row_2 = _e7.index;
    // glimt_light_cells/src/partition.rs:136
    let _e14 = column_of(texel.x, size.x);
    return ((row_2 * 32u) + _e14);
}

// glimt_light_cells/src/partition.rs:141
fn LightCells_texel_rows(size_1: vec2<u32>, start_2: u32, row: u32) -> vec2<u32> {

    // glimt_light_cells/src/partition.rs:142
    let at_2 = (start_2 + row);
    // glimt_light_cells/src/partition.rs:143
    let _e8 = words[at_2];
    let _e13 = words[(at_2 + 1u)];
    return vec2<u32>(_e8, _e13);
}

// glimt_light_cells/src/partition.rs:74
fn first_row_word() -> u32 {

    // glimt_light_cells/src/partition.rs:75
    return (32u + (20u * 512u));
}

// glimt_light_cells/src/partition.rs:148
fn LightCells_row_edges(size_2: vec2<u32>, start_3: u32, cell: u32, rows: vec2<u32>) -> u32 {

    // glimt_light_cells/src/partition.rs:149
    let _e9 = Tuple_u32_u32_((cell % 32u), (cell / 32u));
    let column_1 = _e9.fa;
    let row_3 = _e9.fb;
    // glimt_light_cells/src/partition.rs:150
    let of_band = (32u * (rows.x + row_3));
    // glimt_light_cells/src/partition.rs:151
    let _e18 = first_row_word();
    return (((start_3 + _e18) + of_band) + (column_1 * ((rows.y - rows.x) + 1u)));
}

// glimt_light_cells/src/partition.rs:93
fn first_column(column: u32, width_1: u32) -> u32 {

    // glimt_light_cells/src/partition.rs:94
    return ((column * width_1) / 32u);
}

// glimt_light_cells/src/partition.rs:106
fn column_unit(u_1: u32) -> u32 {

    // glimt_light_cells/src/partition.rs:107
    return (u_1 >> 17u);
}

// glimt_light_cells/src/partition.rs:80
fn first_column_word(size_3: vec2<u32>) -> u32 {

    // glimt_light_cells/src/partition.rs:81
    let _e3 = first_row_word();
    return (_e3 + (32u * (size_3.y + 16u)));
}

// glimt_light_cells/src/partition.rs:86
fn column_words(width_2: u32) -> u32 {

    // glimt_light_cells/src/partition.rs:87
    let _e4 = (width_2 / 2u);
    return select(_e4, (_e4 + 1u), ((width_2 % 2u) != 0u));
}

// glimt_light_cells/src/partition.rs:156
fn LightCells_column_edge(size_4: vec2<u32>, start_4: u32, x_1: u32, y: u32) -> u32 {

    // glimt_light_cells/src/partition.rs:157
    let _e6 = first_column_word(size_4);
    let _e9 = column_words(size_4.x);
    let at_3 = (((start_4 + _e6) + (y * _e9)) + (x_1 / 2u));
    // glimt_light_cells/src/partition.rs:158
    let _e18 = words[at_3];
    return ((_e18 >> ((16u * (x_1 & 1u)) & 31u)) & 65535u);
}

// glimt_light_cells/src/partition.rs:210
fn LightCells_pmf(size_5: vec2<u32>, start_5: u32, row_1: Bin, texel_1: vec2<u32>, first: u32) -> f32 {
    var chosen: u32;

    // glimt_light_cells/src/partition.rs:211
    if (texel_1.x > first) {
        // glimt_light_cells/src/partition.rs:212
        let _e15 = LightCells_column_edge(size_5, start_5, (texel_1.x - 1u), texel_1.y);
        chosen = _e15;
    } else {
        // glimt_light_cells/src/partition.rs:214
        chosen = 0u;
    }
    let lower = chosen;
    // glimt_light_cells/src/partition.rs:216
    let _e22 = LightCells_column_edge(size_5, start_5, texel_1.x, texel_1.y);
    let units = (_e22 - lower);
    // glimt_light_cells/src/partition.rs:217
    return ((f32(row_1.units) * (1f / 2147483600f)) * (f32(units) * (1f / 32768f)));
}

// glimt_light_cells/src/partition.rs:164
fn cell_sample(size_6: vec2<u32>, start_6: u32, cell_1: u32, u_2: vec2<u32>) -> TexelDraw {
    var at_1: u32;
    var left_1: u32;

    // glimt_light_cells/src/partition.rs:165
    let _e8 = LightCells_texel_rows(size_6, start_6, (cell_1 / 32u));
    // glimt_light_cells/src/partition.rs:166
    let _e10 = LightCells_row_edges(size_6, start_6, cell_1, _e8);
    // glimt_light_cells/src/partition.rs:167
    let _e18 = find_bin(_e10, (_e8.y - _e8.x), (u_2.y >> 1u));
    // glimt_light_cells/src/partition.rs:173
    let y_1 = (_e8.x + _e18.index);
    // glimt_light_cells/src/partition.rs:174
    let column_2 = (cell_1 % 32u);
    // glimt_light_cells/src/partition.rs:175
    let _e28 = first_column(column_2, size_6.x);
    // glimt_light_cells/src/partition.rs:177
    let _e31 = column_unit(u_2.x);
    // glimt_light_cells/src/partition.rs:178
    at_1 = _e28;
    // glimt_light_cells/src/partition.rs:179
    let _e38 = first_column((column_2 + 1u), size_6.x);
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
        let _e55 = LightCells_column_edge(size_6, start_6, ((_e51 + half_1) - 1u), y_1);
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
    let _e68 = LightCells_pmf(size_6, start_6, _e18, vec2<u32>(_e66, y_1), _e28);
    return TexelDraw(vec2<u32>(_e64, y_1), _e68);
}

// glimt_light_cells/src/partition.rs:196
fn cell_pmf(size_7: vec2<u32>, start_7: u32, texel_2: vec2<u32>, cell_2: u32) -> f32 {

    // glimt_light_cells/src/partition.rs:197
    let _e8 = LightCells_texel_rows(size_7, start_7, (cell_2 / 32u));
    // glimt_light_cells/src/partition.rs:198
    let _e10 = LightCells_row_edges(size_7, start_7, cell_2, _e8);
    let at_4 = ((_e10 + texel_2.y) - _e8.x);
    // glimt_light_cells/src/partition.rs:199
    let _e22 = words[(at_4 + 1u)];
    let _e25 = words[at_4];
    let of_row = Bin(0u, 0u, (_e22 - _e25));
    // glimt_light_cells/src/partition.rs:204
    let _e32 = first_column((cell_2 % 32u), size_7.x);
    // glimt_light_cells/src/partition.rs:205
    let _e34 = LightCells_pmf(size_7, start_7, of_row, texel_2, _e32);
    return _e34;
}

// glimt_light_cells/src/partition.rs:114
fn cell_quad(size_8: vec2<u32>, start_8: u32, list: u32, quad: u32) -> vec4<f32> {

    // glimt_light_cells/src/partition.rs:115
    let at_5 = (((start_8 + 32u) + (list * 512u)) + (4u * quad));
    // glimt_light_cells/src/partition.rs:116
    let _e16 = words[at_5];
    let _e22 = words[(at_5 + 1u)];
    let _e28 = words[(at_5 + 2u)];
    let _e34 = words[(at_5 + 3u)];
    return vec4<f32>(bitcast<f32>(_e16), bitcast<f32>(_e22), bitcast<f32>(_e28), bitcast<f32>(_e34));
}

// glimt_brdf/src/lobe.rs:86
fn normalisation(exponent: f32) -> f32 {

    // glimt_brdf/src/lobe.rs:87
    let tail = exp2(max((-0.5f * exponent), -60f));
    // glimt_brdf/src/lobe.rs:88
    return ((((exponent + 2f) * (exponent + 4f)) * (0.125f * 0.31830987f)) / (tail + exponent));
}

// glimt_light_cells/src/surface.rs:105
fn cell_surface(normal: vec3<f32>, wo: vec3<f32>, kd: f32, ks: f32, exponent_1: f32, mean_length: f32, horizon: f32) -> CellSurface {

    // glimt_light_cells/src/surface.rs:115
    let r = clamp(mean_length, 0.001f, 1f);
    // glimt_light_cells/src/surface.rs:116
    let widened = ((exponent_1 * r) / (r + (exponent_1 * (1f - r))));
    // glimt_light_cells/src/surface.rs:117
    let _e22 = normalisation(widened);
    return CellSurface(normal, wo, (kd * 0.31830987f), ks, widened, _e22, sqrt((2f * (1f - r))), horizon, 1f);
}

// glimt_light_cells/src/surface.rs:52
fn step_(x_2: vec4<f32>) -> vec4<f32> {

    // glimt_light_cells/src/surface.rs:54
    return clamp((x_2 * 1000000000000000000000000000000f), vec4(0f), vec4(1f));
}

// glimt_light_cells/src/surface.rs:59
fn sqrt_(x_3: vec4<f32>) -> vec4<f32> {

    // glimt_light_cells/src/surface.rs:60
    return vec4<f32>(sqrt(x_3.x), sqrt(x_3.y), sqrt(x_3.z), sqrt(x_3.w));
}

// glimt_light_cells/src/surface.rs:82
fn cosine_power4_(sin2_theta: vec4<f32>, exponent_2: vec4<f32>) -> vec4<f32> {

    // glimt_light_cells/src/surface.rs:84
    let s = clamp(sin2_theta, vec4(0f), vec4(1f));
    // glimt_light_cells/src/surface.rs:85
    let log_ = ((s * (vec4(6f) - s)) / (vec4(12f) - (8f * s)));
    // glimt_light_cells/src/surface.rs:86
    let t = (min((exponent_2 * log_), vec4(40f)) * (1f / 256f));
    // glimt_light_cells/src/surface.rs:88
    let x_4 = (vec4(1f) - (t * (vec4(1f) - (t * (vec4(0.5f) - (t * (1f / 6f)))))));
    // glimt_light_cells/src/surface.rs:89
    let x2_ = (x_4 * x_4);
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
fn cell_terms(size_9: vec2<u32>, start_9: u32, surface: CellSurface, quad_1: u32) -> CellTerms {

    // glimt_light_cells/src/surface.rs:174
    let _e7 = cell_quad(size_9, start_9, 15u, quad_1);
    // glimt_light_cells/src/surface.rs:175
    let _e12 = cell_quad(size_9, start_9, (15u + 1u), quad_1);
    // glimt_light_cells/src/surface.rs:176
    let _e17 = cell_quad(size_9, start_9, (15u + 2u), quad_1);
    // glimt_light_cells/src/surface.rs:177
    let _e20 = cell_quad(size_9, start_9, 18u, quad_1);
    // glimt_light_cells/src/surface.rs:178
    let _e23 = cell_quad(size_9, start_9, 19u, quad_1);
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

// glimt_light_cells/src/surface.rs:133
fn cell_product_weights(this_: CellSurface, terms: CellTerms, flux: vec4<f32>) -> vec4<f32> {

    // glimt_light_cells/src/surface.rs:134
    let reflected = ((terms.cosine * this_.diffuse) + (terms.lobe * this_.specular));
    // glimt_light_cells/src/surface.rs:135
    return ((flux * terms.live) * (reflected + (terms.cosine_spread * this_.diffuse)));
}

// glimt_light_cells/src/surface.rs:162
fn CellSurface_shape_variance(this_1: CellSurface, terms_1: CellTerms) -> vec4<f32> {

    // glimt_light_cells/src/surface.rs:163
    let diffuse = (terms_1.cosine_spread * this_1.diffuse);
    // glimt_light_cells/src/surface.rs:164
    let lobe_1 = ((terms_1.lobe * terms_1.lobe_spread) * this_1.specular);
    // glimt_light_cells/src/surface.rs:165
    return ((diffuse * diffuse) + (lobe_1 * lobe_1));
}

// glimt_light_cells/src/surface.rs:142
fn cell_residual_weights(this_2: CellSurface, terms_2: CellTerms, flux_1: vec4<f32>, visibility: vec4<f32>) -> vec4<f32> {

    // glimt_light_cells/src/surface.rs:143
    let reflected_1 = ((terms_2.cosine * this_2.diffuse) + (terms_2.lobe * this_2.specular));
    // glimt_light_cells/src/surface.rs:144
    let by_visibility = ((visibility * (vec4(1f) - visibility)) + vec4(0.0002f));
    // glimt_light_cells/src/surface.rs:145
    let _e22 = CellSurface_shape_variance(this_2, terms_2);
    let by_shape = (_e22 * max(visibility, vec4(0.02f)));
    // glimt_light_cells/src/surface.rs:146
    let _e33 = sqrt_((((reflected_1 * reflected_1) * by_visibility) + by_shape));
    return ((flux_1 * terms_2.live) * _e33);
}

