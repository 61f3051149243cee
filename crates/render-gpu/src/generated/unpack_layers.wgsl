// Made from Rust by naga-front-rust; do not edit. This command writes it: cargo run --release -p glimt-generate

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

struct DrawnLayout {
    map_size: vec2<u32>,
    pitch: u32,
    scale: f32,
}

struct CameraView {
    eye: vec3<f32>,
    forward: vec3<f32>,
    right: vec3<f32>,
    up: vec3<f32>,
}

struct PixelLayers {
    object: vec4<f32>,
    lit: vec3<f32>,
    catcher: f32,
    blocked: vec3<f32>,
    unused_a: u32,
    behind: vec3<f32>,
    unused_b: u32,
}

struct Params {
    first: u32,
    count: u32,
    frame: FrameParams,
    layout_: DrawnLayout,
    map_rotation: vec2<f32>,
}

@group(0) @binding(1) 
var<storage> map_texels: array<vec4<f32>>;
@group(0) @binding(2) 
var<storage> object: array<vec2<u32>>;
@group(0) @binding(3) 
var<storage> lit: array<vec2<u32>>;
@group(0) @binding(4) 
var<storage> blocked: array<vec2<u32>>;
@group(0) @binding(5) 
var<storage, read_write> out: array<PixelLayers>;
@group(0) @binding(0) 
var<uniform> params: Params;

// glimt_render_gpu/src/kernels/raster.rs:264
fn half(word: u32) -> f32 {
    var value: f32;
    var chosen: f32;

    // glimt_render_gpu/src/kernels/raster.rs:265
    let bits = (word & 32767u);
    // glimt_render_gpu/src/kernels/raster.rs:266
    value = (f32(bits) * (1f / 16777216f));
    // glimt_render_gpu/src/kernels/raster.rs:267
    if (bits >= 1024u) {
        // glimt_render_gpu/src/kernels/raster.rs:269
        value = bitcast<f32>(((bits << 13u) + 939524096u));
    }
    // glimt_render_gpu/src/kernels/raster.rs:271
    if ((word & 32768u) != 0u) {
        let _e27 = value;
        chosen = -(_e27);
    } else {
        let _e29 = value;
        chosen = _e29;
    }
    let _e30 = chosen;
    return _e30;
}

// glimt_render_gpu/src/kernels/raster.rs:249
fn unpack(words: vec2<u32>, scale: f32) -> vec4<f32> {

    // glimt_render_gpu/src/kernels/raster.rs:250
    let _e5 = half(words.x);
    let _e9 = half((words.x >> 16u));
    let _e11 = half(words.y);
    let radiance = vec3<f32>(_e5, _e9, _e11);
    // glimt_render_gpu/src/kernels/raster.rs:251
    let _e19 = half((words.y >> 16u));
    return vec4<f32>((radiance / vec3(scale)), _e19);
}

// glimt_render_gpu/src/kernels/camera.rs:23
fn CameraView_direction(this_: CameraView, p: vec2<f32>, size: vec2<u32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/camera.rs:24
    let x = (((2f * p.x) / f32(size.x)) - 1f);
    // glimt_render_gpu/src/kernels/camera.rs:25
    let y = (((2f * p.y) / f32(size.y)) - 1f);
    // glimt_render_gpu/src/kernels/camera.rs:26
    return normalize(((this_.forward + (this_.right * x)) - (this_.up * y)));
}

// glimt_render_gpu/src/kernels/frame.rs:161
fn FrameParams_direction(this_1: FrameParams, pixel: u32, place: vec2<f32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/frame.rs:162
    let corner = vec2<f32>(vec2<u32>((pixel % this_1.width), (pixel / this_1.width)));
    // glimt_render_gpu/src/kernels/frame.rs:163
    let view = CameraView(this_1.eye, this_1.forward, this_1.right, this_1.up);
    // glimt_render_gpu/src/kernels/frame.rs:169
    let _e22 = CameraView_direction(view, (corner + place), vec2<u32>(this_1.width, this_1.height));
    return _e22;
}

// glimt_probe/src/rotate.rs:33
fn rotate_z(d: vec3<f32>, cos_sin: vec2<f32>) -> vec3<f32> {

    // glimt_probe/src/rotate.rs:34
    return vec3<f32>(((d.x * cos_sin.x) - (d.y * cos_sin.y)), ((d.x * cos_sin.y) + (d.y * cos_sin.x)), d.z);
}

// glimt_probe/src/latlong.rs:45
fn direction_to_uv(d_1: vec3<f32>) -> vec2<f32> {
    var chosen_1: f32;
    var chosen_2: f32;

    // glimt_probe/src/latlong.rs:46
    let horizontal = sqrt(((d_1.x * d_1.x) + (d_1.y * d_1.y)));
    // glimt_probe/src/latlong.rs:47
    if (horizontal <= 0f) {
        // glimt_probe/src/latlong.rs:48
        if (d_1.z < 0f) {
            chosen_1 = 1f;
        } else {
            chosen_1 = 0f;
        }
        let v = chosen_1;
        // glimt_probe/src/latlong.rs:49
        return vec2<f32>(0.5f, v);
    }
    // glimt_probe/src/latlong.rs:52
    let v_1 = (atan2(horizontal, d_1.z) * 0.31830987f);
    // glimt_probe/src/latlong.rs:53
    let u = (0.5f - ((0.5f * 0.31830987f) * atan2(d_1.y, d_1.x)));
    // glimt_probe/src/latlong.rs:54
    if (u < 1f) {
        chosen_2 = max(u, 0f);
    } else {
        chosen_2 = 0f;
    }
    let _e47 = chosen_2;
    return vec2<f32>(_e47, clamp(v_1, 0f, 1f));
}

// glimt_render_gpu/src/kernels/environment.rs:146
fn bilinear(size_1: vec2<u32>, d_2: vec3<f32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/environment.rs:147
    let _e4 = direction_to_uv(d_2);
    let p_1 = ((_e4 * vec2<f32>(size_1)) - vec2(0.5f));
    // glimt_render_gpu/src/kernels/environment.rs:149
    let next = vec2<u32>((p_1 + vec2(1f)));
    // glimt_render_gpu/src/kernels/environment.rs:150
    let f = ((p_1 + vec2(1f)) - vec2<f32>(next));
    // glimt_render_gpu/src/kernels/environment.rs:151
    let x0_ = (((next.x + size_1.x) - 1u) % size_1.x);
    // glimt_render_gpu/src/kernels/environment.rs:152
    let x1_ = (next.x % size_1.x);
    // glimt_render_gpu/src/kernels/environment.rs:153
    let row0_ = ((max(next.y, 1u) * size_1.x) - size_1.x);
    // glimt_render_gpu/src/kernels/environment.rs:154
    let row1_ = (min(next.y, (size_1.y - 1u)) * size_1.x);
    // glimt_render_gpu/src/kernels/environment.rs:155
    let _e53 = map_texels[(row0_ + x0_)];
    let _e57 = map_texels[(row0_ + x1_)];
    let upper = ((_e53 * (1f - f.x)) + (_e57 * f.x));
    // glimt_render_gpu/src/kernels/environment.rs:156
    let _e68 = map_texels[(row1_ + x0_)];
    let _e72 = map_texels[(row1_ + x1_)];
    let lower = ((_e68 * (1f - f.x)) + (_e72 * f.x));
    // glimt_render_gpu/src/kernels/environment.rs:157
    return ((upper * (1f - f.y)) + (lower * f.y)).xyz;
}

// glimt_render_gpu/src/kernels/environment.rs:46
fn RadianceMap_background(size_2: vec2<u32>, rotation: vec2<f32>, direction: vec3<f32>) -> vec3<f32> {

    // glimt_render_gpu/src/kernels/environment.rs:47
    let to_map = vec2<f32>(rotation.x, -(rotation.y));
    // glimt_render_gpu/src/kernels/environment.rs:48
    let _e10 = rotate_z(direction, to_map);
    let _e11 = bilinear(size_2, _e10);
    return _e11;
}

// glimt_render_gpu/src/kernels/raster.rs:212
fn unpack_layers_1(pixel_1: u32, frame: FrameParams, layout_: DrawnLayout, map_rotation: vec2<f32>) -> PixelLayers {
    var behind: vec3<f32>;

    // glimt_render_gpu/src/kernels/raster.rs:222
    let at = (((pixel_1 / frame.width) * layout_.pitch) + (pixel_1 % frame.width));
    // glimt_render_gpu/src/kernels/raster.rs:223
    let _e16 = object[at];
    let _e18 = unpack(_e16, layout_.scale);
    // glimt_render_gpu/src/kernels/raster.rs:224
    let _e22 = lit[at];
    let _e24 = unpack(_e22, layout_.scale);
    // glimt_render_gpu/src/kernels/raster.rs:225
    let _e28 = blocked[at];
    let _e30 = unpack(_e28, layout_.scale);
    // glimt_render_gpu/src/kernels/raster.rs:226
    behind = vec3(0f);
    // glimt_render_gpu/src/kernels/raster.rs:227
    if ((frame.background == 0u) && (_e18.w < 1f)) {
        // glimt_render_gpu/src/kernels/raster.rs:228
        // glimt_render_gpu/src/kernels/raster.rs:233
        let _e50 = FrameParams_direction(frame, (frame.first_pixel + pixel_1), vec2(0.5f));
        // glimt_render_gpu/src/kernels/raster.rs:234
        let _e52 = RadianceMap_background(layout_.map_size, map_rotation, _e50);
        behind = _e52;
    }
    // glimt_render_gpu/src/kernels/raster.rs:236
    let _e58 = behind;
    return PixelLayers(_e18, _e24.xyz, _e24.w, _e30.xyz, 0u, _e58, 0u);
}

@compute @workgroup_size(64, 1, 1) 
fn unpack_layers(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let local = ((id.y * (groups.x * 64u)) + id.x);
    let _e11 = params.count;
    if (local >= _e11) {
        return;
    }
    let _e14 = params.first;
    let _e17 = params.frame;
    let _e19 = params.layout_;
    let _e21 = params.map_rotation;
    let _e22 = unpack_layers_1((_e14 + local), _e17, _e19, _e21);
    out[local] = _e22;
}
