// Made from Rust by naga-front-rust; do not edit. This command writes it: cargo run --release -p glimt-generate

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
    record: u32,
    emission: vec3<f32>,
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
    tiles_across: u32,
    tiles: u32,
    is_adaptive: u32,
    unused_a: u32,
    unused_b: u32,
    unused_c: u32,
}

struct Params {
    first: u32,
    count: u32,
    counts_len: u32,
    frame: FrameParams,
    cells: CellParams,
}

@group(0) @binding(1) 
var<storage> points: array<SeenPoint>;
@group(0) @binding(2) 
var<storage, read_write> counts: array<u32>;
@group(0) @binding(0) 
var<uniform> params: Params;

// glimt_render_gpu/src/kernels/scout.rs:37
fn CellParams_corner(this_: CellParams, tile: u32) -> vec2<u32> {

    // glimt_render_gpu/src/kernels/scout.rs:38
    return vec2<u32>(((tile % this_.tiles_across) * 16u), ((tile / this_.tiles_across) * 8u));
}

// glimt_render_gpu/src/kernels/scout.rs:56
fn tile_end(corner: vec2<u32>, frame: FrameParams) -> vec2<u32> {

    // glimt_render_gpu/src/kernels/scout.rs:57
    return vec2<u32>(min((corner.x + 16u), frame.width), min((corner.y + 8u), frame.height));
}

// glimt_render_gpu/src/kernels/seen.rs:98
fn SeenPoint_slot(this_1: SeenPoint) -> u32 {

    // glimt_render_gpu/src/kernels/seen.rs:99
    return (this_1.flags >> 2u);
}

// glimt_render_gpu/src/kernels/cell_state.rs:100
fn counted(n: u32, s: u32, arrives: u32) -> u32 {
    var chosen: u32;
    var chosen_1: u32;

    // glimt_render_gpu/src/kernels/cell_state.rs:101
    let is_full = (n >= 255u);
    // glimt_render_gpu/src/kernels/cell_state.rs:103
    if is_full {
        chosen = (n / 2u);
    } else {
        chosen = n;
    }
    let _e11 = chosen;
    let n_2 = (_e11 + 1u);
    // glimt_render_gpu/src/kernels/cell_state.rs:104
    if is_full {
        chosen_1 = (s / 2u);
    } else {
        chosen_1 = s;
    }
    let _e18 = chosen_1;
    let s_2 = (_e18 + arrives);
    // glimt_render_gpu/src/kernels/cell_state.rs:105
    return (n_2 | (s_2 << 8u));
}

// glimt_render_gpu/src/kernels/cell_state.rs:111
fn count(word: u32, cell: u32, arrives_1: bool) -> u32 {
    var chosen_2: u32;

    // glimt_render_gpu/src/kernels/cell_state.rs:112
    let shift = (16u * (cell & 1u));
    // glimt_render_gpu/src/kernels/cell_state.rs:113
    let own = ((word >> (shift & 31u)) & 65535u);
    // glimt_render_gpu/src/kernels/cell_state.rs:114
    if arrives_1 {
        chosen_2 = 1u;
    } else {
        chosen_2 = 0u;
    }
    let _e23 = chosen_2;
    let _e24 = counted((own & 255u), (own >> 8u), _e23);
    // glimt_render_gpu/src/kernels/cell_state.rs:115
    return ((word & ~((65535u << (shift & 31u)))) | (_e24 << (shift & 31u)));
}

// glimt_render_gpu/src/kernels/cell_state.rs:120
fn capped(n_1: u32, s_1: u32) -> u32 {

    // glimt_render_gpu/src/kernels/cell_state.rs:121
    if (n_1 <= 64u) {
        // glimt_render_gpu/src/kernels/cell_state.rs:122
        return (n_1 | (s_1 << 8u));
    }
    // glimt_render_gpu/src/kernels/cell_state.rs:124
    return (64u | (((((2u * s_1) * 64u) + n_1) / (2u * n_1)) << 8u));
}

// glimt_render_gpu/src/kernels/cell_state.rs:130
fn cap(word_1: u32) -> u32 {

    // glimt_render_gpu/src/kernels/cell_state.rs:131
    let _e9 = capped((word_1 & 255u), ((word_1 >> 8u) & 255u));
    let _e16 = capped(((word_1 >> 16u) & 255u), (word_1 >> 24u));
    return (_e9 | (_e16 << 16u));
}

// glimt_render_gpu/src/kernels/cells.rs:43
fn gather_cells_1(tile_1: u32, frame_1: FrameParams, cells: CellParams, counts_start: u32, counts_len: u32) {
    var counter: u32;
    var counter_1: u32;
    var counter_2: u32;
    var counter_3: i32;
    var counter_4: u32;

    // glimt_render_gpu/src/kernels/cells.rs:50
    let first_row = (frame_1.first_pixel / frame_1.width);
    // glimt_render_gpu/src/kernels/cells.rs:51
    let _e15 = CellParams_corner(cells, (((first_row / 8u) * cells.tiles_across) + tile_1));
    // glimt_render_gpu/src/kernels/cells.rs:52
    let _e17 = tile_end(_e15, frame_1);
    // glimt_render_gpu/src/kernels/cells.rs:53
    counter = _e15.y;
    loop {
        let y = counter;
        if (y >= _e17.y) {
            break;
        }
        // glimt_render_gpu/src/kernels/cells.rs:54
        counter_1 = _e15.x;
        loop {
            let x = counter_1;
            if (x >= _e17.x) {
                break;
            }
            // glimt_render_gpu/src/kernels/cells.rs:55
            let pixel = (((y - first_row) * frame_1.width) + x);
            // glimt_render_gpu/src/kernels/cells.rs:56
            let first = (pixel * frame_1.rays_per_pixel);
            // glimt_render_gpu/src/kernels/cells.rs:57
            counter_2 = first;
            loop {
                let ray = counter_2;
                if (ray >= (first + frame_1.rays_per_pixel)) {
                    break;
                }
                // glimt_render_gpu/src/kernels/cells.rs:58
                let word_2 = points[ray].record;
                // glimt_render_gpu/src/kernels/cells.rs:59
                let _e52 = points[ray];
                let _e53 = SeenPoint_slot(_e52);
                // glimt_render_gpu/src/kernels/cells.rs:60
                if ((word_2 != 0u) && (_e53 > 0u)) {
                    // glimt_render_gpu/src/kernels/cells.rs:61
                    let base = ((_e53 - 1u) * 256u);
                    // glimt_render_gpu/src/kernels/cells.rs:62
                    counter_3 = 0i;
                    loop {
                        let half = counter_3;
                        if (half >= 2i) {
                            break;
                        }
                        // glimt_render_gpu/src/kernels/cells.rs:63
                        let found = (word_2 >> (u32((16i * half)) & 31u));
                        // glimt_render_gpu/src/kernels/cells.rs:64
                        if ((found & 32768u) != 0u) {
                            // glimt_render_gpu/src/kernels/cells.rs:65
                            let cell_1 = (found & 511u);
                            // glimt_render_gpu/src/kernels/cells.rs:66
                            let at = (base + (cell_1 / 2u));
                            // glimt_render_gpu/src/kernels/cells.rs:67
                            let _e94 = counts[(counts_start + at)];
                            let _e99 = count(_e94, cell_1, ((found & 16384u) != 0u));
                            counts[(counts_start + at)] = _e99;
                        }
                        continuing {
                            let _e103 = counter_3;
                            counter_3 = (_e103 + 1i);
                        }
                    }
                }
                continuing {
                    let _e106 = counter_2;
                    counter_2 = (_e106 + 1u);
                }
            }
            continuing {
                let _e109 = counter_1;
                counter_1 = (_e109 + 1u);
            }
        }
        continuing {
            let _e112 = counter;
            counter = (_e112 + 1u);
        }
    }
    // glimt_render_gpu/src/kernels/cells.rs:74
    counter_4 = 0u;
    loop {
        let i = counter_4;
        if (i >= (3u * 256u)) {
            break;
        }
        // glimt_render_gpu/src/kernels/cells.rs:75
        let _e127 = counts[(counts_start + i)];
        let _e128 = cap(_e127);
        counts[(counts_start + i)] = _e128;
        continuing {
            let _e132 = counter_4;
            counter_4 = (_e132 + 1u);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn gather_cells(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let local = ((id.y * (groups.x * 64u)) + id.x);
    let _e11 = params.count;
    if (local >= _e11) {
        return;
    }
    let _e14 = params.first;
    let _e17 = params.frame;
    let _e19 = params.cells;
    let _e21 = params.counts_len;
    gather_cells_1((_e14 + local), _e17, _e19, (local * _e21), _e21);
}
