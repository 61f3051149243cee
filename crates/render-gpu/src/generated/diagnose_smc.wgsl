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

struct Params {
    first: u32,
    count: u32,
    frame: FrameParams,
    particles_per_ray: u32,
}

@group(0) @binding(1) 
var<storage> states: array<RayState>;
@group(0) @binding(2) 
var<storage, read_write> out: array<vec4<f32>>;
@group(0) @binding(0) 
var<uniform> params: Params;

// glimt_render_gpu/src/kernels/smc.rs:239
fn diagnose_smc_1(pixel: u32, frame: FrameParams, particles_per_ray: u32) -> vec4<f32> {
    var sum: vec4<f32>;
    var hits: f32;
    var counter: u32;
    var chosen: f32;

    // glimt_render_gpu/src/kernels/smc.rs:245
    let first = (pixel * frame.rays_per_pixel);
    // glimt_render_gpu/src/kernels/smc.rs:246
    sum = vec4(0f);
    // glimt_render_gpu/src/kernels/smc.rs:247
    hits = 0f;
    // glimt_render_gpu/src/kernels/smc.rs:248
    counter = first;
    loop {
        let ray = counter;
        if (ray >= (first + frame.rays_per_pixel)) {
            break;
        }
        // glimt_render_gpu/src/kernels/smc.rs:249
        let state = states[ray];
        // glimt_render_gpu/src/kernels/smc.rs:250
        if (state.depth > 0f) {
            // glimt_render_gpu/src/kernels/smc.rs:251
            if (state.started == 0u) {
                // glimt_render_gpu/src/kernels/smc.rs:252
                chosen = 0f;
            } else {
                // glimt_render_gpu/src/kernels/smc.rs:254
                chosen = 1f;
            }
            let started = chosen;
            // glimt_render_gpu/src/kernels/smc.rs:257
            let ratio = clamp(state.log_ratio, -100f, 100f);
            // glimt_render_gpu/src/kernels/smc.rs:258
            let _e48 = sum;
            sum = (_e48 + vec4<f32>(state.ess, ratio, f32(state.age), started));
            // glimt_render_gpu/src/kernels/smc.rs:259
            let _e52 = hits;
            hits = (_e52 + 1f);
        }
        continuing {
            let _e54 = counter;
            counter = (_e54 + 1u);
        }
    }
    // glimt_render_gpu/src/kernels/smc.rs:262
    let n = f32(particles_per_ray);
    // glimt_render_gpu/src/kernels/smc.rs:263
    let _e60 = sum;
    let _e61 = hits;
    let mean = (_e60 / vec4(max(_e61, 1f)));
    // glimt_render_gpu/src/kernels/smc.rs:264
    return vec4<f32>((mean.x / n), mean.y, mean.z, mean.w);
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
