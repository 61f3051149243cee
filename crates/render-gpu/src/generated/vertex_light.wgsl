// Made from Rust by naga-front-rust; do not edit. This command writes it: cargo run --release -p glimt-generate

struct VertexLight {
    lit: vec3<f32>,
    unused_a: f32,
    blocked: vec3<f32>,
    unused_b: f32,
}

struct Params {
    first: u32,
    count: u32,
    coefficients: u32,
    shadows: u32,
}

@group(0) @binding(1) 
var<storage> light: array<vec4<f32>>;
@group(0) @binding(2) 
var<storage> lit: array<f32>;
@group(0) @binding(3) 
var<storage> blocked: array<f32>;
@group(0) @binding(4) 
var<storage, read_write> out: array<VertexLight>;
@group(0) @binding(0) 
var<uniform> params: Params;

// glimt_render_gpu/src/kernels/prt.rs:45
fn vertex_light_1(vertex: u32, coefficients: u32, shadows: u32) -> VertexLight {
    var arrives: vec3<f32>;
    var kept_away: vec3<f32>;
    var counter: u32;

    // glimt_render_gpu/src/kernels/prt.rs:53
    let first = (vertex * coefficients);
    // glimt_render_gpu/src/kernels/prt.rs:54
    arrives = vec3(0f);
    // glimt_render_gpu/src/kernels/prt.rs:55
    kept_away = vec3(0f);
    // glimt_render_gpu/src/kernels/prt.rs:56
    counter = 0u;
    loop {
        let k = counter;
        if (k >= coefficients) {
            break;
        }
        // glimt_render_gpu/src/kernels/prt.rs:57
        let _e22 = light[k];
        let radiance = _e22.xyz;
        // glimt_render_gpu/src/kernels/prt.rs:58
        let _e28 = lit[(first + k)];
        let _e30 = arrives;
        arrives = (_e30 + (radiance * _e28));
        // glimt_render_gpu/src/kernels/prt.rs:59
        let _e36 = blocked[(first + k)];
        let _e38 = kept_away;
        kept_away = (_e38 + (radiance * _e36));
        continuing {
            let _e40 = counter;
            counter = (_e40 + 1u);
        }
    }
    // glimt_render_gpu/src/kernels/prt.rs:61
    if (shadows == 0u) {
        // glimt_render_gpu/src/kernels/prt.rs:62
        let _e47 = kept_away;
        let _e48 = arrives;
        arrives = (_e48 + _e47);
        // glimt_render_gpu/src/kernels/prt.rs:63
        kept_away = vec3(0f);
    }
    // glimt_render_gpu/src/kernels/prt.rs:65
    let _e54 = arrives;
    let _e56 = kept_away;
    return VertexLight(_e54, 0f, _e56, 0f);
}

@compute @workgroup_size(64, 1, 1) 
fn vertex_light(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let local = ((id.y * (groups.x * 64u)) + id.x);
    let _e11 = params.count;
    if (local >= _e11) {
        return;
    }
    let _e14 = params.first;
    let _e17 = params.coefficients;
    let _e19 = params.shadows;
    let _e20 = vertex_light_1((_e14 + local), _e17, _e19);
    out[local] = _e20;
}
