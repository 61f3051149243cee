// Made from Rust by naga-front-rust; do not edit. This command writes it: cargo run --release -p glimt-generate

struct Span {
    first: u32,
    before: f32,
    last: u32,
    within: f32,
}

struct Tuple_u32_u32_ {
    fa: u32,
    fb: u32,
}

struct Taps {
    first: u32,
    count: u32,
    weights: array<f32, 6>,
}

struct Params {
    first: u32,
    count: u32,
    size: vec2<u32>,
}

@group(0) @binding(1) 
var<storage, read_write> out: array<Taps>;
@group(0) @binding(0) 
var<uniform> params: Params;

// glimt_render_gpu/src/kernels/pyramid.rs:22
fn half_size(size: vec2<u32>) -> vec2<u32> {

    // glimt_render_gpu/src/kernels/pyramid.rs:23
    return vec2<u32>(max((size.x / 2u), 1u), max((size.y / 2u), 1u));
}

// glimt_render_gpu/src/kernels/pyramid.rs:122
fn Span_new(index: u32, size_1: u32, half: u32) -> Span {

    // glimt_render_gpu/src/kernels/pyramid.rs:123
    let _e9 = Tuple_u32_u32_((index * size_1), ((index + 1u) * size_1));
    let from_ = _e9.fa;
    let to = _e9.fb;
    // glimt_render_gpu/src/kernels/pyramid.rs:124
    return Span((from_ / half), (f32((from_ % half)) / f32(half)), (to / half), (f32((to % half)) / f32(half)));
}

// glimt_render_gpu/src/kernels/pyramid.rs:134
fn Span_end(this_: Span) -> u32 {
    var chosen: u32;

    // glimt_render_gpu/src/kernels/pyramid.rs:135
    if (this_.within > 0f) {
        // glimt_render_gpu/src/kernels/pyramid.rs:136
        chosen = (this_.last + 1u);
    } else {
        // glimt_render_gpu/src/kernels/pyramid.rs:138
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

// glimt_render_gpu/src/kernels/pyramid.rs:213
fn sine(half_rows: u32, rows: u32) -> f32 {

    // glimt_render_gpu/src/kernels/pyramid.rs:214
    let _e13 = cos_sin_pi((f32(min(half_rows, ((2u * rows) - half_rows))) / f32((2u * rows))));
    return _e13.y;
}

// glimt_render_gpu/src/kernels/pyramid.rs:219
fn area_above(row: u32, part: f32, rows_1: u32) -> f32 {

    // glimt_render_gpu/src/kernels/pyramid.rs:220
    if (part == 0f) {
        // glimt_render_gpu/src/kernels/pyramid.rs:221
        return 0f;
    }
    // glimt_render_gpu/src/kernels/pyramid.rs:224
    let from_pole = min((f32(row) + (0.5f * part)), (f32((rows_1 - row)) - (0.5f * part)));
    // glimt_render_gpu/src/kernels/pyramid.rs:225
    let _e25 = sine(((2u * row) + 1u), rows_1);
    let _e29 = cos_sin_pi((0.5f / f32(rows_1)));
    let whole = (_e25 * _e29.y);
    // glimt_render_gpu/src/kernels/pyramid.rs:226
    let _e35 = cos_sin_pi((from_pole / f32(rows_1)));
    let _e41 = cos_sin_pi(((0.5f * part) / f32(rows_1)));
    return ((_e35.y * _e41.y) / whole);
}

// glimt_render_gpu/src/kernels/pyramid.rs:170
fn Span_covers_row(this_1: Span, row_1: u32, rows_2: u32) -> f32 {

    // glimt_render_gpu/src/kernels/pyramid.rs:171
    if ((row_1 < this_1.first) || (row_1 > this_1.last)) {
        // glimt_render_gpu/src/kernels/pyramid.rs:172
        return 0f;
    }
    // glimt_render_gpu/src/kernels/pyramid.rs:174
    if (row_1 == this_1.last) {
        // glimt_render_gpu/src/kernels/pyramid.rs:175
        let _e17 = area_above(row_1, this_1.within, rows_2);
        return _e17;
    }
    // glimt_render_gpu/src/kernels/pyramid.rs:177
    if (row_1 == this_1.first) {
        // glimt_render_gpu/src/kernels/pyramid.rs:178
        let _e24 = area_above(row_1, this_1.before, rows_2);
        return (1f - _e24);
    }
    // glimt_render_gpu/src/kernels/pyramid.rs:180
    return 1f;
}

// glimt_render_gpu/src/kernels/pyramid.rs:204
fn across(difference: f32, row_2: u32, rows_3: u32) -> f32 {

    // glimt_render_gpu/src/kernels/pyramid.rs:205
    if (difference == 0f) {
        // glimt_render_gpu/src/kernels/pyramid.rs:206
        return 0f;
    }
    // glimt_render_gpu/src/kernels/pyramid.rs:208
    let _e12 = sine((2u * row_2), rows_3);
    return (difference * _e12);
}

// glimt_render_gpu/src/kernels/pyramid.rs:186
fn Span_weight_of_row(this_2: Span, row_3: u32, rows_4: u32) -> f32 {
    var weight: f32;

    // glimt_render_gpu/src/kernels/pyramid.rs:187
    let _e5 = Span_covers_row(this_2, row_3, rows_4);
    // glimt_render_gpu/src/kernels/pyramid.rs:188
    weight = 0f;
    // glimt_render_gpu/src/kernels/pyramid.rs:189
    if (_e5 > 0f) {
        // glimt_render_gpu/src/kernels/pyramid.rs:190
        let _e17 = sine(((2u * row_3) + 1u), rows_4);
        let _e19 = weight;
        weight = (_e19 + (_e5 * _e17));
    }
    // glimt_render_gpu/src/kernels/pyramid.rs:192
    if (row_3 > 0u) {
        // glimt_render_gpu/src/kernels/pyramid.rs:193
        let _e28 = Span_covers_row(this_2, (row_3 - 1u), rows_4);
        let _e30 = across((_e28 - _e5), row_3, rows_4);
        let _e32 = weight;
        weight = (_e32 + (0.25f * _e30));
    }
    // glimt_render_gpu/src/kernels/pyramid.rs:195
    if ((row_3 + 1u) < rows_4) {
        // glimt_render_gpu/src/kernels/pyramid.rs:196
        let _e42 = Span_covers_row(this_2, (row_3 + 1u), rows_4);
        let _e46 = across((_e42 - _e5), (row_3 + 1u), rows_4);
        let _e48 = weight;
        weight = (_e48 + (0.25f * _e46));
    }
    // glimt_render_gpu/src/kernels/pyramid.rs:198
    let _e51 = weight;
    return _e51;
}

// glimt_render_gpu/src/kernels/pyramid.rs:144
fn Span_covers_column(this_3: Span, next: u32) -> f32 {

    // glimt_render_gpu/src/kernels/pyramid.rs:145
    if ((next < (this_3.first + 1u)) || (next > (this_3.last + 1u))) {
        // glimt_render_gpu/src/kernels/pyramid.rs:146
        return 0f;
    }
    // glimt_render_gpu/src/kernels/pyramid.rs:148
    if (next == (this_3.last + 1u)) {
        // glimt_render_gpu/src/kernels/pyramid.rs:149
        return this_3.within;
    }
    // glimt_render_gpu/src/kernels/pyramid.rs:151
    if (next == (this_3.first + 1u)) {
        // glimt_render_gpu/src/kernels/pyramid.rs:152
        return (1f - this_3.before);
    }
    // glimt_render_gpu/src/kernels/pyramid.rs:154
    return 1f;
}

// glimt_render_gpu/src/kernels/pyramid.rs:159
fn Span_weight_of_column(this_4: Span, next_1: u32) -> f32 {
    var chosen_2: f32;

    // glimt_render_gpu/src/kernels/pyramid.rs:160
    if (next_1 > 0u) {
        // glimt_render_gpu/src/kernels/pyramid.rs:161
        let _e10 = Span_covers_column(this_4, (next_1 - 1u));
        chosen_2 = _e10;
    } else {
        // glimt_render_gpu/src/kernels/pyramid.rs:163
        chosen_2 = 0f;
    }
    let left = chosen_2;
    // glimt_render_gpu/src/kernels/pyramid.rs:165
    let _e16 = Span_covers_column(this_4, next_1);
    let _e21 = Span_covers_column(this_4, (next_1 + 1u));
    return ((0.5f * _e16) + (0.25f * (left + _e21)));
}

// glimt_render_gpu/src/kernels/pyramid.rs:40
fn taps_1(index_1: u32, size_2: vec2<u32>) -> Taps {
    var chosen_3: Span;
    var weights: array<f32, 6>;
    var count: u32;
    var sum: f32;
    var next_2: u32;
    var chosen_4: f32;
    var counter: i32;
    var chosen_5: u32;

    // glimt_render_gpu/src/kernels/pyramid.rs:41
    let _e4 = half_size(size_2);
    // glimt_render_gpu/src/kernels/pyramid.rs:42
    let is_row = (index_1 >= _e4.x);
    // glimt_render_gpu/src/kernels/pyramid.rs:43
    if is_row {
        // glimt_render_gpu/src/kernels/pyramid.rs:44
        let _e15 = Span_new((index_1 - _e4.x), size_2.y, _e4.y);
        chosen_3 = _e15;
    } else {
        // glimt_render_gpu/src/kernels/pyramid.rs:46
        let _e19 = Span_new(index_1, size_2.x, _e4.x);
        chosen_3 = _e19;
    }
    let span = chosen_3;
    // glimt_render_gpu/src/kernels/pyramid.rs:48
    weights = array<f32, 6>(0f, 0f, 0f, 0f, 0f, 0f);
    // glimt_render_gpu/src/kernels/pyramid.rs:49
    count = 0u;
    // glimt_render_gpu/src/kernels/pyramid.rs:50
    sum = 0f;
    // glimt_render_gpu/src/kernels/pyramid.rs:52
    next_2 = span.first;
    // glimt_render_gpu/src/kernels/pyramid.rs:53
    if is_row {
        // glimt_render_gpu/src/kernels/pyramid.rs:54
        let _e36 = next_2;
        next_2 = max(_e36, 1u);
    }
    // glimt_render_gpu/src/kernels/pyramid.rs:56
    let begin = next_2;
    // glimt_render_gpu/src/kernels/pyramid.rs:57
    loop {
        let _e42 = next_2;
        let _e43 = Span_end(span);
        let _e47 = count;
        let _e51 = next_2;
        if (((_e42 <= (_e43 + 1u)) && (_e47 < 6u)) && !((is_row && (_e51 > size_2.y)))) {
            // glimt_render_gpu/src/kernels/pyramid.rs:58
            if is_row {
                // glimt_render_gpu/src/kernels/pyramid.rs:59
                let _e60 = next_2;
                let _e64 = Span_weight_of_row(span, (_e60 - 1u), size_2.y);
                chosen_4 = _e64;
            } else {
                // glimt_render_gpu/src/kernels/pyramid.rs:61
                let _e66 = next_2;
                let _e67 = Span_weight_of_column(span, _e66);
                chosen_4 = _e67;
            }
            let weight_1 = chosen_4;
            // glimt_render_gpu/src/kernels/pyramid.rs:63
            let _e70 = count;
            weights[_e70] = weight_1;
            // glimt_render_gpu/src/kernels/pyramid.rs:64
            let _e73 = sum;
            sum = (_e73 + weight_1);
            // glimt_render_gpu/src/kernels/pyramid.rs:65
            let _e77 = count;
            count = (_e77 + 1u);
            // glimt_render_gpu/src/kernels/pyramid.rs:66
            let _e81 = next_2;
            next_2 = (_e81 + 1u);
        } else {
            break;
        }
    }
    // glimt_render_gpu/src/kernels/pyramid.rs:68
    counter = 0i;
    loop {
        let i = counter;
        if (i >= 6i) {
            break;
        }
        // glimt_render_gpu/src/kernels/pyramid.rs:69
        let _e90 = sum;
        let _e93 = weights[u32(i)];
        weights[u32(i)] = (_e93 / _e90);
        continuing {
            let _e95 = counter;
            counter = (_e95 + 1i);
        }
    }
    // glimt_render_gpu/src/kernels/pyramid.rs:71
    if is_row {
        // glimt_render_gpu/src/kernels/pyramid.rs:72
        chosen_5 = (begin - 1u);
    } else {
        // glimt_render_gpu/src/kernels/pyramid.rs:74
        chosen_5 = (((begin + size_2.x) - 1u) % size_2.x);
    }
    let first = chosen_5;
    // glimt_render_gpu/src/kernels/pyramid.rs:76
    let _e112 = count;
    let _e113 = weights;
    return Taps(first, _e112, _e113);
}

@compute @workgroup_size(64, 1, 1) 
fn taps(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let local = ((id.y * (groups.x * 64u)) + id.x);
    let _e11 = params.count;
    if (local >= _e11) {
        return;
    }
    let _e14 = params.first;
    let _e17 = params.size;
    let _e18 = taps_1((_e14 + local), _e17);
    out[local] = _e18;
}
