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
    shadow_rays: u32,
    emission: vec3<f32>,
    residual: f32,
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

struct GroupHealth {
    rays: f32,
    residual: f32,
}

struct Params {
    first: u32,
    count: u32,
    frame: FrameParams,
}

@group(0) @binding(1) 
var<storage> points: array<SeenPoint>;
@group(0) @binding(2) 
var<storage, read_write> out: array<GroupHealth>;
@group(0) @binding(0) 
var<uniform> params: Params;

// glimt_render_gpu/src/kernels/group_health.rs:18
fn diagnose_groups_1(pixel: u32, frame: FrameParams) -> GroupHealth {
    var rays: u32;
    var residual: f32;
    var counter: u32;

    // glimt_render_gpu/src/kernels/group_health.rs:19
    let first = (pixel * frame.rays_per_pixel);
    // glimt_render_gpu/src/kernels/group_health.rs:20
    rays = 0u;
    // glimt_render_gpu/src/kernels/group_health.rs:21
    residual = 0f;
    // glimt_render_gpu/src/kernels/group_health.rs:22
    counter = first;
    loop {
        let ray = counter;
        if (ray >= (first + frame.rays_per_pixel)) {
            break;
        }
        // glimt_render_gpu/src/kernels/group_health.rs:23
        let _e22 = points[ray].shadow_rays;
        let _e23 = rays;
        rays = (_e23 + _e22);
        // glimt_render_gpu/src/kernels/group_health.rs:24
        let _e29 = points[ray].residual;
        let _e30 = residual;
        residual = (_e30 + _e29);
        continuing {
            let _e32 = counter;
            counter = (_e32 + 1u);
        }
    }
    // glimt_render_gpu/src/kernels/group_health.rs:26
    let _e36 = rays;
    let _e38 = residual;
    return GroupHealth(f32(_e36), _e38);
}

@compute @workgroup_size(64, 1, 1) 
fn diagnose_groups(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let local = ((id.y * (groups.x * 64u)) + id.x);
    let _e11 = params.count;
    if (local >= _e11) {
        return;
    }
    let _e14 = params.first;
    let _e17 = params.frame;
    let _e18 = diagnose_groups_1((_e14 + local), _e17);
    out[local] = _e18;
}
