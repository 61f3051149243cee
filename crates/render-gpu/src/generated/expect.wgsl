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
    visibility_len: u32,
    @align(16) cells: CellParams,
}

@group(0) @binding(1) 
var<storage> entries: array<TileEntry>;
@group(0) @binding(2) 
var<storage> counts: array<u32>;
@group(0) @binding(3) 
var<storage, read_write> visibility_1: array<u32>;
@group(0) @binding(0) 
var<uniform> params: Params;

// glimt_render_gpu/src/kernels/cell_state.rs:98
fn bytes_of(word: u32) -> vec4<f32> {

    // glimt_render_gpu/src/kernels/cell_state.rs:99
    return vec4<f32>(f32((word & 255u)), f32(((word >> 8u) & 255u)), f32(((word >> 16u) & 255u)), f32((word >> 24u)));
}

// glimt_render_gpu/src/kernels/cell_state.rs:119
fn quad_counts(first: u32, second: u32) -> QuadCounts {

    // glimt_render_gpu/src/kernels/cell_state.rs:120
    let _e4 = bytes_of(first);
    let _e5 = bytes_of(second);
    let _e6 = Tuple_Vec4_Vec4_(_e4, _e5);
    let low = _e6.fa;
    let high = _e6.fb;
    // glimt_render_gpu/src/kernels/cell_state.rs:121
    return QuadCounts(vec4<f32>(low.x, low.z, high.x, high.z), vec4<f32>(low.y, low.w, high.y, high.w));
}

// glimt_render_gpu/src/kernels/cell_state.rs:228
fn pack(visibility: vec4<f32>) -> u32 {

    // glimt_render_gpu/src/kernels/cell_state.rs:229
    let codes = vec4<u32>(((clamp(visibility, vec4(0f), vec4(1f)) * 255f) + vec4(0.5f)));
    // glimt_render_gpu/src/kernels/cell_state.rs:230
    return (((codes.x | (codes.y << 8u)) | (codes.z << 16u)) | (codes.w << 24u));
}

// glimt_render_gpu/src/kernels/expect.rs:22
fn expect_1(tile: u32, cells: CellParams, visibility_start: u32, visibility_len: u32) {
    var counter: u32;
    var near: array<u32, 9>;
    var found: i32;
    var counter_1: u32;
    var counter_2: u32;
    var counter_3: u32;
    var n: vec4<f32>;
    var s: vec4<f32>;
    var all_n: vec4<f32>;
    var all_s: vec4<f32>;
    var counter_4: i32;

    // glimt_render_gpu/src/kernels/expect.rs:29
    counter = 0u;
    loop {
        let slot = counter;
        if (slot >= 3u) {
            break;
        }
        // glimt_render_gpu/src/kernels/expect.rs:30
        let own = ((tile * 3u) + slot);
        // glimt_render_gpu/src/kernels/expect.rs:31
        let surface = entries[own].surface;
        // glimt_render_gpu/src/kernels/expect.rs:32
        if (surface != 0u) {
            // glimt_render_gpu/src/kernels/expect.rs:33
            near = array<u32, 9>(own, own, own, own, own, own, own, own, own);
            // glimt_render_gpu/src/kernels/expect.rs:34
            found = 0i;
            // glimt_render_gpu/src/kernels/expect.rs:35
            let _e33 = Tuple_u32_u32_((tile % cells.tiles_across), (tile / cells.tiles_across));
            let x = _e33.fa;
            let y = _e33.fb;
            // glimt_render_gpu/src/kernels/expect.rs:36
            counter_1 = 0u;
            loop {
                let i = counter_1;
                if (i >= 9u) {
                    break;
                }
                // glimt_render_gpu/src/kernels/expect.rs:38
                let column = (x + (i % 3u));
                // glimt_render_gpu/src/kernels/expect.rs:39
                let row = (y + (i / 3u));
                // glimt_render_gpu/src/kernels/expect.rs:40
                let rows = (cells.tiles / cells.tiles_across);
                // glimt_render_gpu/src/kernels/expect.rs:41
                if ((((column > 0u) && (row > 0u)) && (column <= cells.tiles_across)) && (row <= rows)) {
                    // glimt_render_gpu/src/kernels/expect.rs:42
                    let other = (((((row - 1u) * cells.tiles_across) + column) - 1u) * 3u);
                    // glimt_render_gpu/src/kernels/expect.rs:43
                    counter_2 = other;
                    loop {
                        let k = counter_2;
                        if (k >= (other + 3u)) {
                            break;
                        }
                        // glimt_render_gpu/src/kernels/expect.rs:44
                        let _e85 = entries[k].surface;
                        if (_e85 == surface) {
                            // glimt_render_gpu/src/kernels/expect.rs:45
                            let _e88 = found;
                            near[u32(_e88)] = k;
                            // glimt_render_gpu/src/kernels/expect.rs:46
                            let _e93 = found;
                            found = (_e93 + 1i);
                        }
                        continuing {
                            let _e95 = counter_2;
                            counter_2 = (_e95 + 1u);
                        }
                    }
                }
                continuing {
                    let _e98 = counter_1;
                    counter_1 = (_e98 + 1u);
                }
            }
            // glimt_render_gpu/src/kernels/expect.rs:51
            counter_3 = 0u;
            loop {
                let word_1 = counter_3;
                if (word_1 >= 128u) {
                    break;
                }
                // glimt_render_gpu/src/kernels/expect.rs:53
                n = vec4(0f);
                // glimt_render_gpu/src/kernels/expect.rs:54
                s = vec4(0f);
                // glimt_render_gpu/src/kernels/expect.rs:55
                all_n = vec4(1f);
                // glimt_render_gpu/src/kernels/expect.rs:56
                all_s = vec4(0.75f);
                // glimt_render_gpu/src/kernels/expect.rs:57
                let _e125 = found;
                counter_4 = 0i;
                loop {
                    let i_1 = counter_4;
                    if (i_1 >= _e125) {
                        break;
                    }
                    // glimt_render_gpu/src/kernels/expect.rs:58
                    let entry = near[u32(i_1)];
                    // glimt_render_gpu/src/kernels/expect.rs:59
                    let at = ((entry * 256u) + (2u * word_1));
                    // glimt_render_gpu/src/kernels/expect.rs:60
                    let _e142 = counts[at];
                    let _e147 = counts[(at + 1u)];
                    let _e148 = quad_counts(_e142, _e147);
                    // glimt_render_gpu/src/kernels/expect.rs:61
                    let _e151 = all_n;
                    all_n = (_e151 + _e148.rays);
                    // glimt_render_gpu/src/kernels/expect.rs:62
                    let _e155 = all_s;
                    all_s = (_e155 + _e148.arrived);
                    // glimt_render_gpu/src/kernels/expect.rs:63
                    if (entry == own) {
                        // glimt_render_gpu/src/kernels/expect.rs:64
                        n = _e148.rays;
                        // glimt_render_gpu/src/kernels/expect.rs:65
                        s = _e148.arrived;
                    }
                    continuing {
                        let _e163 = counter_4;
                        counter_4 = (_e163 + 1i);
                    }
                }
                // glimt_render_gpu/src/kernels/expect.rs:68
                let _e167 = all_s;
                let _e168 = all_n;
                let prior = (_e167 / _e168);
                // glimt_render_gpu/src/kernels/expect.rs:69
                let _e171 = s;
                let _e175 = n;
                let expected = ((_e171 + (prior * 4f)) / (_e175 + vec4(4f)));
                // glimt_render_gpu/src/kernels/expect.rs:70
                let _e181 = pack(expected);
                visibility_1[(visibility_start + ((slot * 128u) + word_1))] = _e181;
                continuing {
                    let _e188 = counter_3;
                    counter_3 = (_e188 + 1u);
                }
            }
        }
        continuing {
            let _e191 = counter;
            counter = (_e191 + 1u);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn expect(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let local = ((id.y * (groups.x * 64u)) + id.x);
    let _e11 = params.count;
    if (local >= _e11) {
        return;
    }
    let _e14 = params.first;
    let _e17 = params.cells;
    let _e19 = params.visibility_len;
    expect_1((_e14 + local), _e17, (local * _e19), _e19);
}
