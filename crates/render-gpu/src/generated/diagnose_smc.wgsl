// Made from Rust by naga-front-rust; do not edit. This command writes it: cargo run --release -p glimt-generate

struct RayState {
    normal: vec3<f32>,
    log_normaliser: f32,
    wo: vec3<f32>,
    depth: f32,
    diffuse: f32,
    specular: f32,
    exponent: f32,
    age: u32,
    ess: f32,
    log_ratio: f32,
    started: u32,
    accepted: u32,
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

struct SmcHealth {
    ess: f32,
    log_ratio: f32,
    age: f32,
    started: f32,
    spread: f32,
}

struct Params {
    first: u32,
    count: u32,
    frame: FrameParams,
    particles_per_ray: u32,
}

@group(0) @binding(1) 
var<storage> states: array<RayState>;
@group(0) @binding(2) 
var<storage, read_write> out: array<SmcHealth>;
@group(0) @binding(0) 
var<uniform> params: Params;

// glimt_smc/src/particle.rs:33
fn is_log_zero(log_weight: f32) -> bool {

    // glimt_smc/src/particle.rs:34
    return !((log_weight > (0.5f * -1000000000000000000000000000000f)));
}

// glimt_render_gpu/src/kernels/smc.rs:288
fn diagnose_smc_1(pixel: u32, frame: FrameParams, particles_per_ray: u32) -> SmcHealth {
    var sum: vec4<f32>;
    var hits: f32;
    var largest: f32;
    var counter: u32;
    var chosen: f32;
    var spread: f32;
    var both: bool;
    var total: f32;
    var squares: f32;
    var counter_1: u32;
    var both_1: bool;

    // glimt_render_gpu/src/kernels/smc.rs:294
    let first = (pixel * frame.rays_per_pixel);
    // glimt_render_gpu/src/kernels/smc.rs:295
    let end = (first + frame.rays_per_pixel);
    // glimt_render_gpu/src/kernels/smc.rs:296
    sum = vec4(0f);
    // glimt_render_gpu/src/kernels/smc.rs:297
    hits = 0f;
    // glimt_render_gpu/src/kernels/smc.rs:298
    largest = -1000000000000000000000000000000f;
    // glimt_render_gpu/src/kernels/smc.rs:299
    counter = first;
    loop {
        let ray = counter;
        if (ray >= end) {
            break;
        }
        // glimt_render_gpu/src/kernels/smc.rs:300
        let state = states[ray];
        // glimt_render_gpu/src/kernels/smc.rs:301
        if (state.depth > 0f) {
            // glimt_render_gpu/src/kernels/smc.rs:302
            if (state.started == 0u) {
                // glimt_render_gpu/src/kernels/smc.rs:303
                chosen = 0f;
            } else {
                // glimt_render_gpu/src/kernels/smc.rs:305
                chosen = 1f;
            }
            let started = chosen;
            // glimt_render_gpu/src/kernels/smc.rs:308
            let ratio = clamp(state.log_ratio, -100f, 100f);
            // glimt_render_gpu/src/kernels/smc.rs:309
            let _e52 = sum;
            sum = (_e52 + vec4<f32>(state.ess, ratio, f32(state.age), started));
            // glimt_render_gpu/src/kernels/smc.rs:310
            let _e56 = hits;
            hits = (_e56 + 1f);
            // glimt_render_gpu/src/kernels/smc.rs:311
            let _e59 = largest;
            largest = max(_e59, state.log_normaliser);
        }
        continuing {
            let _e62 = counter;
            counter = (_e62 + 1u);
        }
    }
    // glimt_render_gpu/src/kernels/smc.rs:314
    let _e66 = sum;
    let _e67 = hits;
    let mean = (_e66 / vec4(max(_e67, 1f)));
    // glimt_render_gpu/src/kernels/smc.rs:315
    spread = 0f;
    // glimt_render_gpu/src/kernels/smc.rs:316
    let _e76 = hits;
    let _e78 = (_e76 > 1f);
    both = _e78;
    if _e78 {
        let _e80 = largest;
        let _e81 = is_log_zero(_e80);
        both = !(_e81);
    }
    let _e83 = both;
    if _e83 {
        // glimt_render_gpu/src/kernels/smc.rs:318
        total = 0f;
        // glimt_render_gpu/src/kernels/smc.rs:319
        squares = 0f;
        // glimt_render_gpu/src/kernels/smc.rs:320
        counter_1 = first;
        loop {
            let ray_1 = counter_1;
            if (ray_1 >= end) {
                break;
            }
            // glimt_render_gpu/src/kernels/smc.rs:321
            let state_1 = states[ray_1];
            // glimt_render_gpu/src/kernels/smc.rs:322
            let _e101 = (state_1.depth > 0f);
            both_1 = _e101;
            if _e101 {
                let _e104 = is_log_zero(state_1.log_normaliser);
                both_1 = !(_e104);
            }
            let _e106 = both_1;
            if _e106 {
                // glimt_render_gpu/src/kernels/smc.rs:323
                let _e109 = largest;
                let z = exp((state_1.log_normaliser - _e109));
                // glimt_render_gpu/src/kernels/smc.rs:324
                let _e113 = total;
                total = (_e113 + z);
                // glimt_render_gpu/src/kernels/smc.rs:325
                let _e117 = squares;
                squares = (_e117 + (z * z));
            }
            continuing {
                let _e119 = counter_1;
                counter_1 = (_e119 + 1u);
            }
        }
        // glimt_render_gpu/src/kernels/smc.rs:328
        let _e123 = squares;
        let _e124 = total;
        let _e125 = total;
        let _e127 = hits;
        let _e130 = hits;
        let variance = ((_e123 - ((_e124 * _e125) / _e127)) / (_e130 - 1f));
        // glimt_render_gpu/src/kernels/smc.rs:329
        let _e138 = hits;
        let _e140 = total;
        spread = ((sqrt(max(variance, 0f)) * _e138) / _e140);
    }
    // glimt_render_gpu/src/kernels/smc.rs:331
    let _e149 = spread;
    return SmcHealth((mean.x / f32(particles_per_ray)), mean.y, mean.z, mean.w, _e149);
}

@compute @workgroup_size(64, 1, 1) 
fn diagnose_smc(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let local = ((id.y * (groups.x * 64u)) + id.x);
    let _e11 = params.count;
    if (local >= _e11) {
        return;
    }
    let _e14 = params.first;
    let _e17 = params.frame;
    let _e19 = params.particles_per_ray;
    let _e20 = diagnose_smc_1((_e14 + local), _e17, _e19);
    out[local] = _e20;
}
