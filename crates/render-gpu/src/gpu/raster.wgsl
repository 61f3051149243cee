// Triangles, pulled from the scene's buffers and drawn into layers. The functions that are called are made from Rust:
// generated/raster_functions.wgsl stands before this text.

@group(0) @binding(0) var<uniform> params: RasterParams;

struct DrawnCorner {
    @builtin(position) position: vec4<f32>,
    // Inside the triangle, also where it covers some of a pixel's samples and not the centre.
    @location(0) @interpolate(perspective, centroid) weights: vec2<f32>,
    @location(1) @interpolate(flat) triangle: u32,
}

struct Layers {
    @location(0) object: vec4<f32>,
    @location(1) lit: vec4<f32>,
    @location(2) blocked: vec4<f32>,
}

@vertex
fn place_corner(@builtin(vertex_index) corner: u32) -> DrawnCorner {
    let near = corner_near(corner, params.near);
    let position = clip_position(params.frame, near, corner_position(corner));
    return DrawnCorner(position, corner_weights(corner), corner / 3u);
}

@fragment
fn shade_layers(in: DrawnCorner) -> Layers {
    let drawn = draw(in.triangle, in.weights, params);
    return Layers(drawn.object, drawn.lit, drawn.blocked);
}

// For scenes with surfaces that let light pass: runs for each sample, and drops those that a surface does not keep. What drops
// samples keeps the GPU from testing depth before it, so other scenes do without.
@fragment
fn shade_kept_layers(in: DrawnCorner, @builtin(sample_index) sample: u32) -> Layers {
    let pixel = vec2<u32>(in.position.xy);
    if keeps_sample(in.triangle, in.weights, pixel, sample, params) == 0u {
        discard;
    }
    let drawn = draw(in.triangle, in.weights, params);
    return Layers(drawn.object, drawn.lit, drawn.blocked);
}
