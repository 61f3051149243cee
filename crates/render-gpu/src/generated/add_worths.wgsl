// Made from Rust by naga-front-rust; do not edit. This command writes it: cargo run --release -p glimt-generate

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

struct Params {
    first: u32,
    count: u32,
    @align(16) cells: CellParams,
    parts: u32,
}

@group(0) @binding(1) 
var<storage> worths: array<f32>;
@group(0) @binding(2) 
var<storage, read_write> out: array<u32>;
@group(0) @binding(0) 
var<uniform> params: Params;

// glimt_render_gpu/src/kernels/expect.rs:124
fn add_worths_1(part: u32, cells: CellParams, parts: u32) -> u32 {
    var sum: f32;
    var counter: u32;

    // glimt_render_gpu/src/kernels/expect.rs:125
    sum = 0f;
    // glimt_render_gpu/src/kernels/expect.rs:126
    let _e10 = (cells.tiles / parts);
    counter = 0u;
    loop {
        let i = counter;
        if (i >= select(_e10, (_e10 + 1u), ((cells.tiles % parts) != 0u))) {
            break;
        }
        // glimt_render_gpu/src/kernels/expect.rs:127
        let tile = ((i * parts) + part);
        // glimt_render_gpu/src/kernels/expect.rs:128
        if (tile < cells.tiles) {
            // glimt_render_gpu/src/kernels/expect.rs:129
            let _e29 = worths[tile];
            let _e30 = sum;
            sum = (_e30 + _e29);
        }
        continuing {
            let _e32 = counter;
            counter = (_e32 + 1u);
        }
    }
    // glimt_render_gpu/src/kernels/expect.rs:132
    let _e36 = sum;
    return bitcast<u32>(_e36);
}

@compute @workgroup_size(64, 1, 1) 
fn add_worths(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let local = ((id.y * (groups.x * 64u)) + id.x);
    let _e11 = params.count;
    if (local >= _e11) {
        return;
    }
    let _e14 = params.first;
    let _e17 = params.cells;
    let _e19 = params.parts;
    let _e20 = add_worths_1((_e14 + local), _e17, _e19);
    out[local] = _e20;
}
