// A lat-long map projected onto spherical harmonics (Hajisharif 2012, Eq. 11): partial sums, and their reduction. The functions
// that are called are made from Rust: generated/projection_functions.wgsl stands before this text.

struct Projection {
    // Of the map.
    size: vec2<u32>,
    // n.
    bands: u32,
    // Workgroups that project.
    parts: u32,
}

@group(0) @binding(0) var<storage, read> params: Projection;
// Texels, or partial sums.
@group(0) @binding(1) var<storage, read> values: array<vec4<f32>>;
@group(0) @binding(2) var<storage, read_write> out: array<vec4<f32>>;

// A workgroup has 16 rows; each of its 16 threads a row has this many texels, 16 columns apart, so that a row's threads read
// what lies together.
const TEXELS: u32 = 16u;
// Sums that are reduced at a time: three of 256 threads and the rows' take 15 KiB, and 16 are sure to be there.
const BATCH: u32 = 3u;

var<workgroup> scratch: array<vec4<f32>, 768>;
// Of each row its 11 sums over φ.
var<workgroup> rows: array<vec4<f32>, 176>;

// Sums over a row's threads: into `rows`, from number `first` on. One thread adds up a row's sixteen: a tree would be shorter, but
// wait for all threads at each of its steps.
fn reduce(first: u32, a: vec3<f32>, b: vec3<f32>, c: vec3<f32>, index: u32) {
    let at = BATCH * index;
    scratch[at] = vec4(a, 0.0);
    scratch[at + 1u] = vec4(b, 0.0);
    scratch[at + 2u] = vec4(c, 0.0);
    workgroupBarrier();
    let row = index / BATCH;
    let own = first + index % BATCH;
    if row < 16u && own < 11u {
        let start = 16u * BATCH * row + index % BATCH;
        var sum = vec4(0.0);
        for (var i = 0u; i < 16u; i++) {
            sum += scratch[start + BATCH * i];
        }
        rows[11u * row + own] = sum;
    }
    workgroupBarrier();
}

// Sums over the texels of one workgroup: 36 values, of which the first n² are written.
@compute @workgroup_size(16, 16)
fn project(
    @builtin(local_invocation_id) local: vec3<u32>,
    @builtin(local_invocation_index) index: u32,
    @builtin(workgroup_id) group: vec3<u32>,
    @builtin(num_workgroups) groups: vec3<u32>,
) {
    let size = params.size;
    let bands = params.bands;
    let row = 16u * group.y + local.y;
    // With one θ, a row needs 2n - 1 sums over φ.
    var sums: array<vec3<f32>, 11>;
    if row < size.y {
        for (var i = 0u; i < TEXELS; i++) {
            let column = 16u * (TEXELS * group.x + i) + local.x;
            if column >= size.x {
                break;
            }
            let texel = values[row * size.x + column].xyz;
            let phi = column_ring(column, size.x);
            sums[0] += texel;
            sums[1] += texel * phi[1];
            sums[2] += texel * phi[2];
            if bands > 2u {
                sums[3] += texel * phi[3];
                sums[4] += texel * phi[4];
                sums[5] += texel * phi[5];
                sums[6] += texel * phi[6];
            }
            if bands > 4u {
                sums[7] += texel * phi[7];
                sums[8] += texel * phi[8];
                sums[9] += texel * phi[9];
                sums[10] += texel * phi[10];
            }
        }
    }
    reduce(0u, sums[0], sums[1], sums[2], index);
    if bands > 2u {
        reduce(3u, sums[3], sums[4], sums[5], index);
        reduce(6u, sums[6], sums[7], sums[8], index);
    }
    if bands > 4u {
        reduce(9u, sums[9], sums[10], vec3(0.0), index);
    }

    // The rows' factors of θ, in the scratch that is free now.
    if index < 16u {
        let own = 16u * group.y + index;
        var area = 0.0;
        if own < size.y {
            area = row_area(own, size);
        }
        var theta = row_meridian(own, size);
        for (var i = 0u; i < 21u; i++) {
            scratch[21u * index + i] = vec4(theta[i] * area);
        }
    }
    workgroupBarrier();
    if index < bands * bands {
        let order = coefficient_order(index);
        let ring = ring_index(order);
        let factor = meridian_index(coefficient_band(index), u32(abs(order)));
        var sum = vec3(0.0);
        for (var y = 0u; y < 16u; y++) {
            sum += rows[11u * y + ring].xyz * scratch[21u * y + factor].x;
        }
        out[36u * (group.y * groups.x + group.x) + index] = vec4(sum, 0.0);
    }
}

// Coefficient `group.x`: the sum of all workgroups' parts.
@compute @workgroup_size(256)
fn sum_parts(
    @builtin(local_invocation_index) index: u32,
    @builtin(workgroup_id) group: vec3<u32>,
) {
    var sum = vec4(0.0);
    for (var i = index; i < params.parts; i += 256u) {
        sum += values[36u * i + group.x];
    }
    scratch[index] = sum;
    for (var half = 128u; half > 0u; half /= 2u) {
        workgroupBarrier();
        if index < half {
            scratch[index] += scratch[index + half];
        }
    }
    if index == 0u {
        out[group.x] = scratch[0];
    }
}
