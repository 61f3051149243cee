// Made from Rust by naga-front-rust; do not edit. To make it anew: cargo run --release -p glimt-tests --bin regenerate

struct Tuple_u32_u32_ {
    fa: u32,
    fb: u32,
}

struct Span {
    first: u32,
    before: f32,
    last: u32,
    within: f32,
}

struct Params {
    first: u32,
    count: u32,
    size: vec2<u32>,
}

@group(0) @binding(1) 
var<storage> texels: array<vec4<f32>>;
@group(0) @binding(2) 
var<storage, read_write> out: array<vec4<f32>>;
@group(0) @binding(0) 
var<storage> params: Params;

// glimt_render_gpu/src/kernels/pyramid.rs:22
fn half_size(size: vec2<u32>) -> vec2<u32> {

    // glimt_render_gpu/src/kernels/pyramid.rs:23
    return vec2<u32>(max((size.x / 2u), 1u), max((size.y / 2u), 1u));
}

// glimt_render_gpu/src/kernels/pyramid.rs:70
fn Span_new(index: u32, size_1: u32, half: u32) -> Span {

    // glimt_render_gpu/src/kernels/pyramid.rs:71
    let _e9 = Tuple_u32_u32_((index * size_1), ((index + 1u) * size_1));
    let from_ = _e9.fa;
    let to = _e9.fb;
    // glimt_render_gpu/src/kernels/pyramid.rs:72
    return Span((from_ / half), (f32((from_ % half)) / f32(half)), (to / half), (f32((to % half)) / f32(half)));
}

// glimt_render_gpu/src/kernels/pyramid.rs:82
fn Span_end(this_: Span) -> u32 {
    var chosen: u32;

    // glimt_render_gpu/src/kernels/pyramid.rs:83
    if (this_.within > 0f) {
        // glimt_render_gpu/src/kernels/pyramid.rs:84
        chosen = (this_.last + 1u);
    } else {
        // glimt_render_gpu/src/kernels/pyramid.rs:86
        chosen = this_.last;
    }
    let _e13 = chosen;
    return _e13;
}

// glimt_probe/src/trig.rs:25
fn cos_sin_pi(x: f32) -> vec2<f32> {
    var chosen_1: vec2<f32>;

    // glimt_probe/src/trig.rs:27
    let quarter = floor(((2f * x) + 0.5f));
    // glimt_probe/src/trig.rs:28
    let y = (x - (0.5f * quarter));
    // glimt_probe/src/trig.rs:29
    let y2_ = (y * y);
    // glimt_probe/src/trig.rs:31
    let c = (1f + (y2_ * (-4.934802f + (y2_ * (4.058712f + (y2_ * (-1.3352627f + (y2_ * (0.23533063f + (y2_ * -0.02580689f))))))))));
    // glimt_probe/src/trig.rs:34
    let s = (y * (3.1415927f + (y2_ * (-5.1677127f + (y2_ * (2.550164f + (y2_ * (-0.5992645f + (y2_ * 0.082145885f)))))))));
    // glimt_probe/src/trig.rs:37
    let _e49 = (i32(quarter) & 3i);
    if (_e49 == 0i) {
        // glimt_probe/src/trig.rs:38
        chosen_1 = vec2<f32>(c, (s + 0f));
    } else {
        if (_e49 == 1i) {
            // glimt_probe/src/trig.rs:39
            chosen_1 = vec2<f32>((0f - s), c);
        } else {
            if (_e49 == 2i) {
                // glimt_probe/src/trig.rs:40
                chosen_1 = vec2<f32>((0f - c), (0f - s));
            } else {
                // glimt_probe/src/trig.rs:41
                chosen_1 = vec2<f32>((s + 0f), (0f - c));
            }
        }
    }
    let _e77 = chosen_1;
    return _e77;
}

// glimt_render_gpu/src/kernels/pyramid.rs:149
fn sine(half_rows: u32, rows: u32) -> f32 {

    // glimt_render_gpu/src/kernels/pyramid.rs:150
    let _e13 = cos_sin_pi((f32(min(half_rows, ((2u * rows) - half_rows))) / f32((2u * rows))));
    return _e13.y;
}

// glimt_render_gpu/src/kernels/pyramid.rs:155
fn area_above(row: u32, part: f32, rows_1: u32) -> f32 {

    // glimt_render_gpu/src/kernels/pyramid.rs:156
    if (part == 0f) {
        // glimt_render_gpu/src/kernels/pyramid.rs:157
        return 0f;
    }
    // glimt_render_gpu/src/kernels/pyramid.rs:160
    let from_pole = min((f32(row) + (0.5f * part)), (f32((rows_1 - row)) - (0.5f * part)));
    // glimt_render_gpu/src/kernels/pyramid.rs:161
    let _e25 = sine(((2u * row) + 1u), rows_1);
    let _e29 = cos_sin_pi((0.5f / f32(rows_1)));
    let whole = (_e25 * _e29.y);
    // glimt_render_gpu/src/kernels/pyramid.rs:162
    let _e35 = cos_sin_pi((from_pole / f32(rows_1)));
    let _e41 = cos_sin_pi(((0.5f * part) / f32(rows_1)));
    return ((_e35.y * _e41.y) / whole);
}

// glimt_render_gpu/src/kernels/pyramid.rs:118
fn Span_covers_row(this_1: Span, row_1: u32, rows_2: u32) -> f32 {

    // glimt_render_gpu/src/kernels/pyramid.rs:119
    if ((row_1 < this_1.first) || (row_1 > this_1.last)) {
        // glimt_render_gpu/src/kernels/pyramid.rs:120
        return 0f;
    }
    // glimt_render_gpu/src/kernels/pyramid.rs:122
    if (row_1 == this_1.last) {
        // glimt_render_gpu/src/kernels/pyramid.rs:123
        let _e17 = area_above(row_1, this_1.within, rows_2);
        return _e17;
    }
    // glimt_render_gpu/src/kernels/pyramid.rs:125
    if (row_1 == this_1.first) {
        // glimt_render_gpu/src/kernels/pyramid.rs:126
        let _e24 = area_above(row_1, this_1.before, rows_2);
        return (1f - _e24);
    }
    // glimt_render_gpu/src/kernels/pyramid.rs:128
    return 1f;
}

// glimt_render_gpu/src/kernels/pyramid.rs:134
fn Span_weight_of_row(this_2: Span, row_2: u32, rows_3: u32) -> f32 {
    var weight: f32;

    // glimt_render_gpu/src/kernels/pyramid.rs:135
    let _e5 = Span_covers_row(this_2, row_2, rows_3);
    // glimt_render_gpu/src/kernels/pyramid.rs:136
    let _e11 = sine(((2u * row_2) + 1u), rows_3);
    weight = (_e5 * _e11);
    // glimt_render_gpu/src/kernels/pyramid.rs:137
    if (row_2 > 0u) {
        // glimt_render_gpu/src/kernels/pyramid.rs:138
        let _e21 = sine((2u * row_2), rows_3);
        let _e25 = Span_covers_row(this_2, (row_2 - 1u), rows_3);
        let _e28 = weight;
        weight = (_e28 + ((0.25f * _e21) * (_e25 - _e5)));
    }
    // glimt_render_gpu/src/kernels/pyramid.rs:140
    if ((row_2 + 1u) < rows_3) {
        // glimt_render_gpu/src/kernels/pyramid.rs:141
        let _e40 = sine(((2u * row_2) + 2u), rows_3);
        let _e44 = Span_covers_row(this_2, (row_2 + 1u), rows_3);
        let _e47 = weight;
        weight = (_e47 + ((0.25f * _e40) * (_e44 - _e5)));
    }
    // glimt_render_gpu/src/kernels/pyramid.rs:143
    let _e50 = weight;
    return _e50;
}

// glimt_render_gpu/src/kernels/pyramid.rs:92
fn Span_covers_column(this_3: Span, next: u32) -> f32 {

    // glimt_render_gpu/src/kernels/pyramid.rs:93
    if ((next < (this_3.first + 1u)) || (next > (this_3.last + 1u))) {
        // glimt_render_gpu/src/kernels/pyramid.rs:94
        return 0f;
    }
    // glimt_render_gpu/src/kernels/pyramid.rs:96
    if (next == (this_3.last + 1u)) {
        // glimt_render_gpu/src/kernels/pyramid.rs:97
        return this_3.within;
    }
    // glimt_render_gpu/src/kernels/pyramid.rs:99
    if (next == (this_3.first + 1u)) {
        // glimt_render_gpu/src/kernels/pyramid.rs:100
        return (1f - this_3.before);
    }
    // glimt_render_gpu/src/kernels/pyramid.rs:102
    return 1f;
}

// glimt_render_gpu/src/kernels/pyramid.rs:107
fn Span_weight_of_column(this_4: Span, next_1: u32) -> f32 {
    var chosen_2: f32;

    // glimt_render_gpu/src/kernels/pyramid.rs:108
    if (next_1 > 0u) {
        // glimt_render_gpu/src/kernels/pyramid.rs:109
        let _e10 = Span_covers_column(this_4, (next_1 - 1u));
        chosen_2 = _e10;
    } else {
        // glimt_render_gpu/src/kernels/pyramid.rs:111
        chosen_2 = 0f;
    }
    let left = chosen_2;
    // glimt_render_gpu/src/kernels/pyramid.rs:113
    let _e16 = Span_covers_column(this_4, next_1);
    let _e21 = Span_covers_column(this_4, (next_1 + 1u));
    return ((0.5f * _e16) + (0.25f * (left + _e21)));
}

// glimt_render_gpu/src/kernels/pyramid.rs:28
fn halve_1(texel: u32, size_2: vec2<u32>) -> vec4<f32> {
    var sum: vec4<f32>;
    var weights: f32;
    var row_3: u32;
    var both: bool;
    var of_row: vec4<f32>;
    var of_weights: f32;
    var next_2: u32;

    // glimt_render_gpu/src/kernels/pyramid.rs:29
    let _e4 = half_size(size_2);
    // glimt_render_gpu/src/kernels/pyramid.rs:30
    let _e10 = Span_new((texel % _e4.x), size_2.x, _e4.x);
    // glimt_render_gpu/src/kernels/pyramid.rs:31
    let _e16 = Span_new((texel / _e4.x), size_2.y, _e4.y);
    // glimt_render_gpu/src/kernels/pyramid.rs:32
    sum = vec4(0f);
    // glimt_render_gpu/src/kernels/pyramid.rs:33
    weights = 0f;
    // glimt_render_gpu/src/kernels/pyramid.rs:34
    row_3 = (max(_e16.first, 1u) - 1u);
    // glimt_render_gpu/src/kernels/pyramid.rs:35
    loop {
        let _e32 = row_3;
        let _e34 = (_e32 < size_2.y);
        both = _e34;
        if _e34 {
            let _e36 = row_3;
            let _e37 = Span_end(_e16);
            both = (_e36 <= _e37);
        }
        let _e39 = both;
        if _e39 {
            // glimt_render_gpu/src/kernels/pyramid.rs:36
            let _e41 = row_3;
            let _e43 = Span_weight_of_row(_e16, _e41, size_2.y);
            // glimt_render_gpu/src/kernels/pyramid.rs:37
            of_row = vec4(0f);
            // glimt_render_gpu/src/kernels/pyramid.rs:38
            of_weights = 0f;
            // glimt_render_gpu/src/kernels/pyramid.rs:40
            next_2 = _e10.first;
            // glimt_render_gpu/src/kernels/pyramid.rs:41
            loop {
                let _e55 = next_2;
                let _e56 = Span_end(_e10);
                if !((_e55 <= (_e56 + 1u))) {
                    break;
                }
                // glimt_render_gpu/src/kernels/pyramid.rs:42
                let _e62 = next_2;
                let _e63 = Span_weight_of_column(_e10, _e62);
                // glimt_render_gpu/src/kernels/pyramid.rs:43
                let _e65 = row_3;
                let _e68 = next_2;
                let _e78 = texels[((_e65 * size_2.x) + (((_e68 + size_2.x) - 1u) % size_2.x))];
                let _e80 = of_row;
                of_row = (_e80 + (_e78 * _e63));
                // glimt_render_gpu/src/kernels/pyramid.rs:44
                let _e83 = of_weights;
                of_weights = (_e83 + _e63);
                // glimt_render_gpu/src/kernels/pyramid.rs:45
                let _e87 = next_2;
                next_2 = (_e87 + 1u);
            }
            // glimt_render_gpu/src/kernels/pyramid.rs:47
            let _e90 = of_row;
            let _e92 = sum;
            sum = (_e92 + (_e90 * _e43));
            // glimt_render_gpu/src/kernels/pyramid.rs:48
            let _e95 = of_weights;
            let _e97 = weights;
            weights = (_e97 + (_e95 * _e43));
            // glimt_render_gpu/src/kernels/pyramid.rs:49
            let _e101 = row_3;
            row_3 = (_e101 + 1u);
        } else {
            break;
        }
    }
    // glimt_render_gpu/src/kernels/pyramid.rs:51
    let _e104 = sum;
    let _e105 = weights;
    return (_e104 / vec4(_e105));
}

@compute @workgroup_size(64, 1, 1) 
fn halve(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let local = ((id.y * (groups.x * 64u)) + id.x);
    let _e11 = params.count;
    if (local >= _e11) {
        return;
    }
    let _e14 = params.first;
    let _e17 = params.size;
    let _e18 = halve_1((_e14 + local), _e17);
    out[local] = _e18;
}
