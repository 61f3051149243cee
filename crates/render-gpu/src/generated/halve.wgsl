// Made from Rust by naga-front-rust; do not edit. This command writes it: cargo run --release -p glimt-generate

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
var<storage> taps: array<Taps>;
@group(0) @binding(2) 
var<storage> texels: array<vec4<f32>>;
@group(0) @binding(3) 
var<storage, read_write> out: array<vec4<f32>>;
@group(0) @binding(0) 
var<uniform> params: Params;

// glimt_render_gpu/src/kernels/pyramid.rs:22
fn half_size(size: vec2<u32>) -> vec2<u32> {

    // glimt_render_gpu/src/kernels/pyramid.rs:23
    return vec2<u32>(max((size.x / 2u), 1u), max((size.y / 2u), 1u));
}

// glimt_render_gpu/src/kernels/pyramid.rs:85
fn halve_1(texel: u32, size_1: vec2<u32>) -> vec4<f32> {
    var columns: Taps;
    var rows: Taps;
    var sum: vec4<f32>;
    var counter: u32;
    var of_row: vec4<f32>;
    var column: u32;
    var counter_1: u32;

    // glimt_render_gpu/src/kernels/pyramid.rs:86
    let _e4 = half_size(size_1);
    // glimt_render_gpu/src/kernels/pyramid.rs:87
    let _e10 = taps[(texel % _e4.x)];
    columns = _e10;
    // glimt_render_gpu/src/kernels/pyramid.rs:88
    let _e19 = taps[(_e4.x + (texel / _e4.x))];
    rows = _e19;
    // glimt_render_gpu/src/kernels/pyramid.rs:89
    sum = vec4(0f);
    // glimt_render_gpu/src/kernels/pyramid.rs:90
    let _e28 = rows.count;
    counter = 0u;
    loop {
        let j = counter;
        if (j >= _e28) {
            break;
        }
        // glimt_render_gpu/src/kernels/pyramid.rs:91
        let _e34 = rows.first;
        let row = ((_e34 + j) * size_1.x);
        // glimt_render_gpu/src/kernels/pyramid.rs:92
        of_row = vec4(0f);
        // glimt_render_gpu/src/kernels/pyramid.rs:93
        let _e44 = columns.first;
        column = _e44;
        // glimt_render_gpu/src/kernels/pyramid.rs:94
        let _e49 = columns.count;
        counter_1 = 0u;
        loop {
            let i = counter_1;
            if (i >= _e49) {
                break;
            }
            // glimt_render_gpu/src/kernels/pyramid.rs:95
            let _e54 = column;
            let _e58 = texels[(row + _e54)];
            let _e61 = columns.weights[i];
            let _e63 = of_row;
            of_row = (_e63 + (_e58 * _e61));
            // glimt_render_gpu/src/kernels/pyramid.rs:96
            let _e67 = column;
            column = (_e67 + 1u);
            // glimt_render_gpu/src/kernels/pyramid.rs:97
            let _e70 = column;
            if (_e70 == size_1.x) {
                // glimt_render_gpu/src/kernels/pyramid.rs:98
                column = 0u;
            }
            continuing {
                let _e75 = counter_1;
                counter_1 = (_e75 + 1u);
            }
        }
        // glimt_render_gpu/src/kernels/pyramid.rs:101
        let _e79 = of_row;
        let _e82 = rows.weights[j];
        let _e84 = sum;
        sum = (_e84 + (_e79 * _e82));
        continuing {
            let _e86 = counter;
            counter = (_e86 + 1u);
        }
    }
    // glimt_render_gpu/src/kernels/pyramid.rs:103
    let _e90 = sum;
    return _e90;
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
