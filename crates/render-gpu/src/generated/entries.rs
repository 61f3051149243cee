//! Host file: the compute shaders.
//!
//! Made from Rust by naga-front-rust; do not edit. This command writes it: cargo run --release -p glimt-generate

use std::borrow::Cow::Borrowed;

use glimt_executor::{BufferSlot, Entry, ParamField, ParamsSpace};

/// `shade::shade::<crate::kernels::mis::Mis, glam::Vec4>` as a compute entry point.
pub static SHADE_MIS: Entry = Entry {
    name: Borrowed("shade_mis"),
    kernel: Borrowed("glimt_render_gpu::kernels::shade::shade::<glimt_render_gpu::kernels::mis::Mis, glam::Vec4>"),
    wgsl: Borrowed(include_str!("shade_mis.wgsl")),
    workgroup_size: 64,
    params_size: 256,
    params_space: ParamsSpace::Uniform,
    params: Borrowed(&[
        ParamField::new("first", 0, 4),
        ParamField::new("count", 4, 4),
        ParamField::new("frame", 16, 208),
        ParamField::new("estimator", 224, 8),
        ParamField::new("env.size", 240, 8),
        ParamField::new("env.rotation", 248, 8),
    ]),
    buffers: Borrowed(&[
        BufferSlot::new("env.texels", 1, 16, false),
        BufferSlot::new("env.tables", 2, 4, false),
        BufferSlot::new("scene.nodes", 3, 112, false),
        BufferSlot::new("scene.triangles", 4, 64, false),
        BufferSlot::new("scene.corners", 5, 32, false),
        BufferSlot::new("scene.surface", 6, 4, false),
        BufferSlot::new("out", 7, 16, true),
    ]),
};

/// `shade::shade::<crate::kernels::mis::Mis, crate::kernels::layers::LayerSample>` as a compute entry point.
pub static SHADE_MIS_LAYERS: Entry = Entry {
    name: Borrowed("shade_mis_layers"),
    kernel: Borrowed("glimt_render_gpu::kernels::shade::shade::<glimt_render_gpu::kernels::mis::Mis, glimt_render_gpu::kernels::layers::LayerSample>"),
    wgsl: Borrowed(include_str!("shade_mis_layers.wgsl")),
    workgroup_size: 64,
    params_size: 256,
    params_space: ParamsSpace::Uniform,
    params: Borrowed(&[
        ParamField::new("first", 0, 4),
        ParamField::new("count", 4, 4),
        ParamField::new("frame", 16, 208),
        ParamField::new("estimator", 224, 8),
        ParamField::new("env.size", 240, 8),
        ParamField::new("env.rotation", 248, 8),
    ]),
    buffers: Borrowed(&[
        BufferSlot::new("env.texels", 1, 16, false),
        BufferSlot::new("env.tables", 2, 4, false),
        BufferSlot::new("scene.nodes", 3, 112, false),
        BufferSlot::new("scene.triangles", 4, 64, false),
        BufferSlot::new("scene.corners", 5, 32, false),
        BufferSlot::new("scene.surface", 6, 4, false),
        BufferSlot::new("out", 7, 32, true),
    ]),
};

/// `shade::shade::<crate::kernels::bis::Bis, glam::Vec4>` as a compute entry point.
pub static SHADE_BIS: Entry = Entry {
    name: Borrowed("shade_bis"),
    kernel: Borrowed("glimt_render_gpu::kernels::shade::shade::<glimt_render_gpu::kernels::bis::Bis, glam::Vec4>"),
    wgsl: Borrowed(include_str!("shade_bis.wgsl")),
    workgroup_size: 64,
    params_size: 256,
    params_space: ParamsSpace::Uniform,
    params: Borrowed(&[
        ParamField::new("first", 0, 4),
        ParamField::new("count", 4, 4),
        ParamField::new("frame", 16, 208),
        ParamField::new("estimator", 224, 12),
        ParamField::new("env.size", 240, 8),
        ParamField::new("env.rotation", 248, 8),
    ]),
    buffers: Borrowed(&[
        BufferSlot::new("env.texels", 1, 16, false),
        BufferSlot::new("env.tables", 2, 4, false),
        BufferSlot::new("scene.nodes", 3, 112, false),
        BufferSlot::new("scene.triangles", 4, 64, false),
        BufferSlot::new("scene.corners", 5, 32, false),
        BufferSlot::new("scene.surface", 6, 4, false),
        BufferSlot::new("out", 7, 16, true),
    ]),
};

/// `shade::shade::<crate::kernels::bis::Bis, crate::kernels::layers::LayerSample>` as a compute entry point.
pub static SHADE_BIS_LAYERS: Entry = Entry {
    name: Borrowed("shade_bis_layers"),
    kernel: Borrowed("glimt_render_gpu::kernels::shade::shade::<glimt_render_gpu::kernels::bis::Bis, glimt_render_gpu::kernels::layers::LayerSample>"),
    wgsl: Borrowed(include_str!("shade_bis_layers.wgsl")),
    workgroup_size: 64,
    params_size: 256,
    params_space: ParamsSpace::Uniform,
    params: Borrowed(&[
        ParamField::new("first", 0, 4),
        ParamField::new("count", 4, 4),
        ParamField::new("frame", 16, 208),
        ParamField::new("estimator", 224, 12),
        ParamField::new("env.size", 240, 8),
        ParamField::new("env.rotation", 248, 8),
    ]),
    buffers: Borrowed(&[
        BufferSlot::new("env.texels", 1, 16, false),
        BufferSlot::new("env.tables", 2, 4, false),
        BufferSlot::new("scene.nodes", 3, 112, false),
        BufferSlot::new("scene.triangles", 4, 64, false),
        BufferSlot::new("scene.corners", 5, 32, false),
        BufferSlot::new("scene.surface", 6, 4, false),
        BufferSlot::new("out", 7, 32, true),
    ]),
};

/// `product::shade_product::<glam::Vec4>` as a compute entry point.
pub static SHADE_PRODUCT: Entry = Entry {
    name: Borrowed("shade_product"),
    kernel: Borrowed("glimt_render_gpu::kernels::product::shade_product::<glam::Vec4>"),
    wgsl: Borrowed(include_str!("shade_product.wgsl")),
    workgroup_size: 64,
    params_size: 256,
    params_space: ParamsSpace::Uniform,
    params: Borrowed(&[
        ParamField::new("first", 0, 4),
        ParamField::new("count", 4, 4),
        ParamField::new("points_len", 8, 4),
        ParamField::new("samples_len", 12, 4),
        ParamField::new("frame", 16, 208),
        ParamField::new("product", 224, 16),
        ParamField::new("env.size", 240, 8),
        ParamField::new("env.rotation", 248, 8),
    ]),
    buffers: Borrowed(&[
        BufferSlot::new("env.texels", 1, 16, false),
        BufferSlot::new("env.tables", 2, 4, false),
        BufferSlot::new("scene.nodes", 3, 112, false),
        BufferSlot::new("scene.triangles", 4, 64, false),
        BufferSlot::new("scene.surface", 5, 4, false),
        BufferSlot::new("points", 6, 112, true),
        BufferSlot::new("samples", 7, 16, true),
    ]),
};

/// `product::shade_product::<crate::kernels::layers::LayerSample>` as a compute entry point.
pub static SHADE_PRODUCT_LAYERS: Entry = Entry {
    name: Borrowed("shade_product_layers"),
    kernel: Borrowed("glimt_render_gpu::kernels::product::shade_product::<glimt_render_gpu::kernels::layers::LayerSample>"),
    wgsl: Borrowed(include_str!("shade_product_layers.wgsl")),
    workgroup_size: 64,
    params_size: 256,
    params_space: ParamsSpace::Uniform,
    params: Borrowed(&[
        ParamField::new("first", 0, 4),
        ParamField::new("count", 4, 4),
        ParamField::new("points_len", 8, 4),
        ParamField::new("samples_len", 12, 4),
        ParamField::new("frame", 16, 208),
        ParamField::new("product", 224, 16),
        ParamField::new("env.size", 240, 8),
        ParamField::new("env.rotation", 248, 8),
    ]),
    buffers: Borrowed(&[
        BufferSlot::new("env.texels", 1, 16, false),
        BufferSlot::new("env.tables", 2, 4, false),
        BufferSlot::new("scene.nodes", 3, 112, false),
        BufferSlot::new("scene.triangles", 4, 64, false),
        BufferSlot::new("scene.surface", 5, 4, false),
        BufferSlot::new("points", 6, 112, true),
        BufferSlot::new("samples", 7, 32, true),
    ]),
};

/// `seen::see` as a compute entry point.
pub static SEE: Entry = Entry {
    name: Borrowed("see"),
    kernel: Borrowed("glimt_render_gpu::kernels::seen::see"),
    wgsl: Borrowed(include_str!("see.wgsl")),
    workgroup_size: 64,
    params_size: 224,
    params_space: ParamsSpace::Uniform,
    params: Borrowed(&[
        ParamField::new("first", 0, 4),
        ParamField::new("count", 4, 4),
        ParamField::new("frame", 16, 208),
    ]),
    buffers: Borrowed(&[
        BufferSlot::new("scene.nodes", 1, 112, false),
        BufferSlot::new("scene.triangles", 2, 64, false),
        BufferSlot::new("scene.corners", 3, 32, false),
        BufferSlot::new("scene.surface", 4, 4, false),
        BufferSlot::new("out", 5, 112, true),
    ]),
};

/// `scout::scout` as a compute entry point.
pub static SCOUT: Entry = Entry {
    name: Borrowed("scout"),
    kernel: Borrowed("glimt_render_gpu::kernels::scout::scout"),
    wgsl: Borrowed(include_str!("scout.wgsl")),
    workgroup_size: 64,
    params_size: 256,
    params_space: ParamsSpace::Uniform,
    params: Borrowed(&[
        ParamField::new("first", 0, 4),
        ParamField::new("count", 4, 4),
        ParamField::new("entries_len", 8, 4),
        ParamField::new("frame", 16, 208),
        ParamField::new("cells", 224, 32),
    ]),
    buffers: Borrowed(&[
        BufferSlot::new("scene.nodes", 1, 112, false),
        BufferSlot::new("scene.triangles", 2, 64, false),
        BufferSlot::new("scene.corners", 3, 32, false),
        BufferSlot::new("scene.surface", 4, 4, false),
        BufferSlot::new("entries", 5, 64, true),
    ]),
};

/// `scout::see_in_tile` as a compute entry point.
pub static SEE_IN_TILE: Entry = Entry {
    name: Borrowed("see_in_tile"),
    kernel: Borrowed("glimt_render_gpu::kernels::scout::see_in_tile"),
    wgsl: Borrowed(include_str!("see_in_tile.wgsl")),
    workgroup_size: 64,
    params_size: 256,
    params_space: ParamsSpace::Uniform,
    params: Borrowed(&[
        ParamField::new("first", 0, 4),
        ParamField::new("count", 4, 4),
        ParamField::new("frame", 16, 208),
        ParamField::new("cells", 224, 32),
    ]),
    buffers: Borrowed(&[
        BufferSlot::new("scene.nodes", 1, 112, false),
        BufferSlot::new("scene.triangles", 2, 64, false),
        BufferSlot::new("scene.corners", 3, 32, false),
        BufferSlot::new("scene.surface", 4, 4, false),
        BufferSlot::new("entries", 5, 64, false),
        BufferSlot::new("out", 6, 112, true),
    ]),
};

/// `carry::carry` as a compute entry point.
pub static CARRY: Entry = Entry {
    name: Borrowed("carry"),
    kernel: Borrowed("glimt_render_gpu::kernels::carry::carry"),
    wgsl: Borrowed(include_str!("carry.wgsl")),
    workgroup_size: 64,
    params_size: 336,
    params_space: ParamsSpace::Uniform,
    params: Borrowed(&[
        ParamField::new("first", 0, 4),
        ParamField::new("count", 4, 4),
        ParamField::new("entries_len", 8, 4),
        ParamField::new("frame", 16, 208),
        ParamField::new("cells", 224, 32),
        ParamField::new("view", 256, 64),
        ParamField::new("env.size", 320, 8),
        ParamField::new("env.rotation", 328, 8),
    ]),
    buffers: Borrowed(&[
        BufferSlot::new("env.tables", 1, 4, false),
        BufferSlot::new("motions", 2, 64, false),
        BufferSlot::new("past_entries", 3, 64, false),
        BufferSlot::new("past_counts", 4, 4, false),
        BufferSlot::new("entries", 5, 64, true),
    ]),
};

/// `pilot::pilot` as a compute entry point.
pub static PILOT: Entry = Entry {
    name: Borrowed("pilot"),
    kernel: Borrowed("glimt_render_gpu::kernels::pilot::pilot"),
    wgsl: Borrowed(include_str!("pilot.wgsl")),
    workgroup_size: 64,
    params_size: 272,
    params_space: ParamsSpace::Uniform,
    params: Borrowed(&[
        ParamField::new("first", 0, 4),
        ParamField::new("count", 4, 4),
        ParamField::new("counts_len", 8, 4),
        ParamField::new("frame", 16, 208),
        ParamField::new("cells", 224, 32),
        ParamField::new("env.size", 256, 8),
        ParamField::new("env.rotation", 264, 8),
    ]),
    buffers: Borrowed(&[
        BufferSlot::new("env.tables", 1, 4, false),
        BufferSlot::new("scene.nodes", 2, 112, false),
        BufferSlot::new("scene.triangles", 3, 64, false),
        BufferSlot::new("scene.corners", 4, 32, false),
        BufferSlot::new("scene.surface", 5, 4, false),
        BufferSlot::new("entries", 6, 64, false),
        BufferSlot::new("past_counts", 7, 4, false),
        BufferSlot::new("counts", 8, 4, true),
    ]),
};

/// `expect::expect` as a compute entry point.
pub static EXPECT: Entry = Entry {
    name: Borrowed("expect"),
    kernel: Borrowed("glimt_render_gpu::kernels::expect::expect"),
    wgsl: Borrowed(include_str!("expect.wgsl")),
    workgroup_size: 64,
    params_size: 48,
    params_space: ParamsSpace::Uniform,
    params: Borrowed(&[
        ParamField::new("first", 0, 4),
        ParamField::new("count", 4, 4),
        ParamField::new("visibility_len", 8, 4),
        ParamField::new("cells", 16, 32),
    ]),
    buffers: Borrowed(&[
        BufferSlot::new("entries", 1, 64, false),
        BufferSlot::new("counts", 2, 4, false),
        BufferSlot::new("visibility", 3, 4, true),
    ]),
};

/// `expect::worth` as a compute entry point.
pub static WORTH: Entry = Entry {
    name: Borrowed("worth"),
    kernel: Borrowed("glimt_render_gpu::kernels::expect::worth"),
    wgsl: Borrowed(include_str!("worth.wgsl")),
    workgroup_size: 64,
    params_size: 240,
    params_space: ParamsSpace::Uniform,
    params: Borrowed(&[
        ParamField::new("first", 0, 4),
        ParamField::new("count", 4, 4),
        ParamField::new("frame", 16, 208),
        ParamField::new("env.size", 224, 8),
        ParamField::new("env.rotation", 232, 8),
    ]),
    buffers: Borrowed(&[
        BufferSlot::new("env.tables", 1, 4, false),
        BufferSlot::new("entries", 2, 64, false),
        BufferSlot::new("visibility", 3, 4, false),
        BufferSlot::new("out", 4, 4, true),
    ]),
};

/// `expect::add_worths` as a compute entry point.
pub static ADD_WORTHS: Entry = Entry {
    name: Borrowed("add_worths"),
    kernel: Borrowed("glimt_render_gpu::kernels::expect::add_worths"),
    wgsl: Borrowed(include_str!("add_worths.wgsl")),
    workgroup_size: 64,
    params_size: 64,
    params_space: ParamsSpace::Uniform,
    params: Borrowed(&[
        ParamField::new("first", 0, 4),
        ParamField::new("count", 4, 4),
        ParamField::new("cells", 16, 32),
        ParamField::new("parts", 48, 4),
    ]),
    buffers: Borrowed(&[
        BufferSlot::new("worths", 1, 4, false),
        BufferSlot::new("out", 2, 4, true),
    ]),
};

/// `cells::shade_cells::<glam::Vec4>` as a compute entry point.
pub static SHADE_CELLS: Entry = Entry {
    name: Borrowed("shade_cells"),
    kernel: Borrowed("glimt_render_gpu::kernels::cells::shade_cells::<glam::Vec4>"),
    wgsl: Borrowed(include_str!("shade_cells.wgsl")),
    workgroup_size: 64,
    params_size: 272,
    params_space: ParamsSpace::Uniform,
    params: Borrowed(&[
        ParamField::new("first", 0, 4),
        ParamField::new("count", 4, 4),
        ParamField::new("points_len", 8, 4),
        ParamField::new("samples_len", 12, 4),
        ParamField::new("frame", 16, 208),
        ParamField::new("cells", 224, 32),
        ParamField::new("env.size", 256, 8),
        ParamField::new("env.rotation", 264, 8),
    ]),
    buffers: Borrowed(&[
        BufferSlot::new("env.texels", 1, 16, false),
        BufferSlot::new("env.tables", 2, 4, false),
        BufferSlot::new("scene.nodes", 3, 112, false),
        BufferSlot::new("scene.triangles", 4, 64, false),
        BufferSlot::new("scene.surface", 5, 4, false),
        BufferSlot::new("visibility", 6, 4, false),
        BufferSlot::new("points", 7, 112, true),
        BufferSlot::new("samples", 8, 16, true),
    ]),
};

/// `cells::shade_cells::<crate::kernels::layers::LayerSample>` as a compute entry point.
pub static SHADE_CELLS_LAYERS: Entry = Entry {
    name: Borrowed("shade_cells_layers"),
    kernel: Borrowed("glimt_render_gpu::kernels::cells::shade_cells::<glimt_render_gpu::kernels::layers::LayerSample>"),
    wgsl: Borrowed(include_str!("shade_cells_layers.wgsl")),
    workgroup_size: 64,
    params_size: 272,
    params_space: ParamsSpace::Uniform,
    params: Borrowed(&[
        ParamField::new("first", 0, 4),
        ParamField::new("count", 4, 4),
        ParamField::new("points_len", 8, 4),
        ParamField::new("samples_len", 12, 4),
        ParamField::new("frame", 16, 208),
        ParamField::new("cells", 224, 32),
        ParamField::new("env.size", 256, 8),
        ParamField::new("env.rotation", 264, 8),
    ]),
    buffers: Borrowed(&[
        BufferSlot::new("env.texels", 1, 16, false),
        BufferSlot::new("env.tables", 2, 4, false),
        BufferSlot::new("scene.nodes", 3, 112, false),
        BufferSlot::new("scene.triangles", 4, 64, false),
        BufferSlot::new("scene.surface", 5, 4, false),
        BufferSlot::new("visibility", 6, 4, false),
        BufferSlot::new("points", 7, 112, true),
        BufferSlot::new("samples", 8, 32, true),
    ]),
};

/// `group_health::diagnose_groups` as a compute entry point.
pub static DIAGNOSE_GROUPS: Entry = Entry {
    name: Borrowed("diagnose_groups"),
    kernel: Borrowed("glimt_render_gpu::kernels::group_health::diagnose_groups"),
    wgsl: Borrowed(include_str!("diagnose_groups.wgsl")),
    workgroup_size: 64,
    params_size: 224,
    params_space: ParamsSpace::Uniform,
    params: Borrowed(&[
        ParamField::new("first", 0, 4),
        ParamField::new("count", 4, 4),
        ParamField::new("frame", 16, 208),
    ]),
    buffers: Borrowed(&[
        BufferSlot::new("points", 1, 112, false),
        BufferSlot::new("out", 2, 8, true),
    ]),
};

/// `smc_point::find_smc` as a compute entry point.
pub static FIND_SMC: Entry = Entry {
    name: Borrowed("find_smc"),
    kernel: Borrowed("glimt_render_gpu::kernels::smc_point::find_smc"),
    wgsl: Borrowed(include_str!("find_smc.wgsl")),
    workgroup_size: 64,
    params_size: 288,
    params_space: ParamsSpace::Uniform,
    params: Borrowed(&[
        ParamField::new("first", 0, 4),
        ParamField::new("count", 4, 4),
        ParamField::new("frame", 16, 208),
        ParamField::new("view", 224, 64),
    ]),
    buffers: Borrowed(&[
        BufferSlot::new("scene.nodes", 1, 112, false),
        BufferSlot::new("scene.triangles", 2, 64, false),
        BufferSlot::new("scene.corners", 3, 32, false),
        BufferSlot::new("scene.surface", 4, 4, false),
        BufferSlot::new("past.motions", 5, 64, false),
        BufferSlot::new("past.states", 6, 64, false),
        BufferSlot::new("out", 7, 176, true),
    ]),
};

/// `smc::advance_smc` as a compute entry point.
pub static ADVANCE_SMC: Entry = Entry {
    name: Borrowed("advance_smc"),
    kernel: Borrowed("glimt_render_gpu::kernels::smc::advance_smc"),
    wgsl: Borrowed(include_str!("advance_smc.wgsl")),
    workgroup_size: 64,
    params_size: 320,
    params_space: ParamsSpace::Uniform,
    params: Borrowed(&[
        ParamField::new("first", 0, 4),
        ParamField::new("count", 4, 4),
        ParamField::new("state_len", 8, 4),
        ParamField::new("particles_len", 12, 4),
        ParamField::new("frame", 16, 208),
        ParamField::new("smc", 224, 64),
        ParamField::new("env.size", 288, 8),
        ParamField::new("env.rotation", 296, 8),
        ParamField::new("before.size", 304, 8),
        ParamField::new("before.rotation", 312, 8),
    ]),
    buffers: Borrowed(&[
        BufferSlot::new("env.texels", 1, 16, false),
        BufferSlot::new("env.tables", 2, 4, false),
        BufferSlot::new("before.texels", 3, 16, false),
        BufferSlot::new("points", 4, 176, false),
        BufferSlot::new("past_particles", 5, 16, false),
        BufferSlot::new("state", 6, 64, true),
        BufferSlot::new("particles", 7, 16, true),
    ]),
};

/// `smc_gather::gather_smc::<glam::Vec4>` as a compute entry point.
pub static GATHER_SMC: Entry = Entry {
    name: Borrowed("gather_smc"),
    kernel: Borrowed("glimt_render_gpu::kernels::smc_gather::gather_smc::<glam::Vec4>"),
    wgsl: Borrowed(include_str!("gather_smc.wgsl")),
    workgroup_size: 64,
    params_size: 256,
    params_space: ParamsSpace::Uniform,
    params: Borrowed(&[
        ParamField::new("first", 0, 4),
        ParamField::new("count", 4, 4),
        ParamField::new("frame", 16, 208),
        ParamField::new("floor", 224, 4),
        ParamField::new("particles_per_ray", 228, 4),
        ParamField::new("env.size", 232, 8),
        ParamField::new("env.rotation", 240, 8),
    ]),
    buffers: Borrowed(&[
        BufferSlot::new("env.texels", 1, 16, false),
        BufferSlot::new("scene.nodes", 2, 112, false),
        BufferSlot::new("scene.triangles", 3, 64, false),
        BufferSlot::new("scene.surface", 4, 4, false),
        BufferSlot::new("points", 5, 176, false),
        BufferSlot::new("states", 6, 64, false),
        BufferSlot::new("particles", 7, 16, false),
        BufferSlot::new("out", 8, 16, true),
    ]),
};

/// `smc_gather::gather_smc::<crate::kernels::layers::LayerSample>` as a compute entry point.
pub static GATHER_SMC_LAYERS: Entry = Entry {
    name: Borrowed("gather_smc_layers"),
    kernel: Borrowed("glimt_render_gpu::kernels::smc_gather::gather_smc::<glimt_render_gpu::kernels::layers::LayerSample>"),
    wgsl: Borrowed(include_str!("gather_smc_layers.wgsl")),
    workgroup_size: 64,
    params_size: 256,
    params_space: ParamsSpace::Uniform,
    params: Borrowed(&[
        ParamField::new("first", 0, 4),
        ParamField::new("count", 4, 4),
        ParamField::new("frame", 16, 208),
        ParamField::new("floor", 224, 4),
        ParamField::new("particles_per_ray", 228, 4),
        ParamField::new("env.size", 232, 8),
        ParamField::new("env.rotation", 240, 8),
    ]),
    buffers: Borrowed(&[
        BufferSlot::new("env.texels", 1, 16, false),
        BufferSlot::new("scene.nodes", 2, 112, false),
        BufferSlot::new("scene.triangles", 3, 64, false),
        BufferSlot::new("scene.surface", 4, 4, false),
        BufferSlot::new("points", 5, 176, false),
        BufferSlot::new("states", 6, 64, false),
        BufferSlot::new("particles", 7, 16, false),
        BufferSlot::new("out", 8, 32, true),
    ]),
};

/// `smc::diagnose_smc` as a compute entry point.
pub static DIAGNOSE_SMC: Entry = Entry {
    name: Borrowed("diagnose_smc"),
    kernel: Borrowed("glimt_render_gpu::kernels::smc::diagnose_smc"),
    wgsl: Borrowed(include_str!("diagnose_smc.wgsl")),
    workgroup_size: 64,
    params_size: 240,
    params_space: ParamsSpace::Uniform,
    params: Borrowed(&[
        ParamField::new("first", 0, 4),
        ParamField::new("count", 4, 4),
        ParamField::new("frame", 16, 208),
        ParamField::new("particles_per_ray", 224, 4),
    ]),
    buffers: Borrowed(&[
        BufferSlot::new("states", 1, 64, false),
        BufferSlot::new("out", 2, 20, true),
    ]),
};

/// `film::reconstruct` as a compute entry point.
pub static RECONSTRUCT: Entry = Entry {
    name: Borrowed("reconstruct"),
    kernel: Borrowed("glimt_render_gpu::kernels::film::reconstruct"),
    wgsl: Borrowed(include_str!("reconstruct.wgsl")),
    workgroup_size: 64,
    params_size: 224,
    params_space: ParamsSpace::Uniform,
    params: Borrowed(&[
        ParamField::new("first", 0, 4),
        ParamField::new("count", 4, 4),
        ParamField::new("frame", 16, 208),
    ]),
    buffers: Borrowed(&[
        BufferSlot::new("samples", 1, 16, false),
        BufferSlot::new("out", 2, 16, true),
    ]),
};

/// `film::tonemap` as a compute entry point.
pub static TONEMAP: Entry = Entry {
    name: Borrowed("tonemap"),
    kernel: Borrowed("glimt_render_gpu::kernels::film::tonemap"),
    wgsl: Borrowed(include_str!("tonemap.wgsl")),
    workgroup_size: 64,
    params_size: 224,
    params_space: ParamsSpace::Uniform,
    params: Borrowed(&[
        ParamField::new("first", 0, 4),
        ParamField::new("count", 4, 4),
        ParamField::new("frame", 16, 208),
    ]),
    buffers: Borrowed(&[
        BufferSlot::new("linear", 1, 16, false),
        BufferSlot::new("out", 2, 4, true),
    ]),
};

/// `unwarp::unwarp` as a compute entry point.
pub static UNWARP: Entry = Entry {
    name: Borrowed("unwarp"),
    kernel: Borrowed("glimt_render_gpu::kernels::unwarp::unwarp"),
    wgsl: Borrowed(include_str!("unwarp.wgsl")),
    workgroup_size: 64,
    params_size: 80,
    params_space: ParamsSpace::Uniform,
    params: Borrowed(&[
        ParamField::new("first", 0, 4),
        ParamField::new("count", 4, 4),
        ParamField::new("colour", 16, 48),
        ParamField::new("reflectance", 64, 16),
    ]),
    buffers: Borrowed(&[
        BufferSlot::new("map.texels", 1, 12, false),
        BufferSlot::new("map.taps", 2, 4, false),
        BufferSlot::new("pixels", 3, 16, false),
        BufferSlot::new("out", 4, 16, true),
    ]),
};

/// `layers::reconstruct_layers` as a compute entry point.
pub static RECONSTRUCT_LAYERS: Entry = Entry {
    name: Borrowed("reconstruct_layers"),
    kernel: Borrowed("glimt_render_gpu::kernels::layers::reconstruct_layers"),
    wgsl: Borrowed(include_str!("reconstruct_layers.wgsl")),
    workgroup_size: 64,
    params_size: 240,
    params_space: ParamsSpace::Uniform,
    params: Borrowed(&[
        ParamField::new("first", 0, 4),
        ParamField::new("count", 4, 4),
        ParamField::new("frame", 16, 208),
        ParamField::new("env.size", 224, 8),
        ParamField::new("env.rotation", 232, 8),
    ]),
    buffers: Borrowed(&[
        BufferSlot::new("env.texels", 1, 16, false),
        BufferSlot::new("samples", 2, 32, false),
        BufferSlot::new("out", 3, 64, true),
    ]),
};

/// `composite::composite_over_plate` as a compute entry point.
pub static COMPOSITE_OVER_PLATE: Entry = Entry {
    name: Borrowed("composite_over_plate"),
    kernel: Borrowed("glimt_render_gpu::kernels::composite::composite_over_plate"),
    wgsl: Borrowed(include_str!("composite_over_plate.wgsl")),
    workgroup_size: 64,
    params_size: 224,
    params_space: ParamsSpace::Uniform,
    params: Borrowed(&[
        ParamField::new("first", 0, 4),
        ParamField::new("count", 4, 4),
        ParamField::new("frame", 16, 208),
    ]),
    buffers: Borrowed(&[
        BufferSlot::new("layers", 1, 64, false),
        BufferSlot::new("plate", 2, 16, false),
        BufferSlot::new("out", 3, 16, true),
    ]),
};

/// `composite::display_over_plate` as a compute entry point.
pub static DISPLAY_OVER_PLATE: Entry = Entry {
    name: Borrowed("display_over_plate"),
    kernel: Borrowed("glimt_render_gpu::kernels::composite::display_over_plate"),
    wgsl: Borrowed(include_str!("display_over_plate.wgsl")),
    workgroup_size: 64,
    params_size: 224,
    params_space: ParamsSpace::Uniform,
    params: Borrowed(&[
        ParamField::new("first", 0, 4),
        ParamField::new("count", 4, 4),
        ParamField::new("frame", 16, 208),
    ]),
    buffers: Borrowed(&[
        BufferSlot::new("layers", 1, 64, false),
        BufferSlot::new("plate", 2, 16, false),
        BufferSlot::new("out", 3, 4, true),
    ]),
};

/// `composite::composite_alone` as a compute entry point.
pub static COMPOSITE_ALONE: Entry = Entry {
    name: Borrowed("composite_alone"),
    kernel: Borrowed("glimt_render_gpu::kernels::composite::composite_alone"),
    wgsl: Borrowed(include_str!("composite_alone.wgsl")),
    workgroup_size: 64,
    params_size: 224,
    params_space: ParamsSpace::Uniform,
    params: Borrowed(&[
        ParamField::new("first", 0, 4),
        ParamField::new("count", 4, 4),
        ParamField::new("frame", 16, 208),
    ]),
    buffers: Borrowed(&[
        BufferSlot::new("layers", 1, 64, false),
        BufferSlot::new("out", 2, 16, true),
    ]),
};

/// `pyramid::taps` as a compute entry point.
pub static TAPS: Entry = Entry {
    name: Borrowed("taps"),
    kernel: Borrowed("glimt_render_gpu::kernels::pyramid::taps"),
    wgsl: Borrowed(include_str!("taps.wgsl")),
    workgroup_size: 64,
    params_size: 16,
    params_space: ParamsSpace::Uniform,
    params: Borrowed(&[
        ParamField::new("first", 0, 4),
        ParamField::new("count", 4, 4),
        ParamField::new("size", 8, 8),
    ]),
    buffers: Borrowed(&[
        BufferSlot::new("out", 1, 32, true),
    ]),
};

/// `pyramid::halve` as a compute entry point.
pub static HALVE: Entry = Entry {
    name: Borrowed("halve"),
    kernel: Borrowed("glimt_render_gpu::kernels::pyramid::halve"),
    wgsl: Borrowed(include_str!("halve.wgsl")),
    workgroup_size: 64,
    params_size: 16,
    params_space: ParamsSpace::Uniform,
    params: Borrowed(&[
        ParamField::new("first", 0, 4),
        ParamField::new("count", 4, 4),
        ParamField::new("size", 8, 8),
    ]),
    buffers: Borrowed(&[
        BufferSlot::new("taps", 1, 32, false),
        BufferSlot::new("texels", 2, 16, false),
        BufferSlot::new("out", 3, 16, true),
    ]),
};

/// `light_sh::light_coefficient` as a compute entry point.
pub static LIGHT_COEFFICIENT: Entry = Entry {
    name: Borrowed("light_coefficient"),
    kernel: Borrowed("glimt_render_gpu::kernels::light_sh::light_coefficient"),
    wgsl: Borrowed(include_str!("light_coefficient.wgsl")),
    workgroup_size: 64,
    params_size: 48,
    params_space: ParamsSpace::Uniform,
    params: Borrowed(&[
        ParamField::new("first", 0, 4),
        ParamField::new("count", 4, 4),
        ParamField::new("light", 16, 32),
    ]),
    buffers: Borrowed(&[
        BufferSlot::new("sums", 1, 16, false),
        BufferSlot::new("previous", 2, 16, false),
        BufferSlot::new("out", 3, 16, true),
    ]),
};

/// `prt::vertex_light` as a compute entry point.
pub static VERTEX_LIGHT: Entry = Entry {
    name: Borrowed("vertex_light"),
    kernel: Borrowed("glimt_render_gpu::kernels::prt::vertex_light"),
    wgsl: Borrowed(include_str!("vertex_light.wgsl")),
    workgroup_size: 64,
    params_size: 16,
    params_space: ParamsSpace::Uniform,
    params: Borrowed(&[
        ParamField::new("first", 0, 4),
        ParamField::new("count", 4, 4),
        ParamField::new("coefficients", 8, 4),
        ParamField::new("shadows", 12, 4),
    ]),
    buffers: Borrowed(&[
        BufferSlot::new("light", 1, 16, false),
        BufferSlot::new("lit", 2, 4, false),
        BufferSlot::new("blocked", 3, 4, false),
        BufferSlot::new("out", 4, 32, true),
    ]),
};

/// `raster::unpack_layers` as a compute entry point.
pub static UNPACK_LAYERS: Entry = Entry {
    name: Borrowed("unpack_layers"),
    kernel: Borrowed("glimt_render_gpu::kernels::raster::unpack_layers"),
    wgsl: Borrowed(include_str!("unpack_layers.wgsl")),
    workgroup_size: 64,
    params_size: 256,
    params_space: ParamsSpace::Uniform,
    params: Borrowed(&[
        ParamField::new("first", 0, 4),
        ParamField::new("count", 4, 4),
        ParamField::new("frame", 16, 208),
        ParamField::new("layout", 224, 16),
        ParamField::new("map_rotation", 240, 8),
    ]),
    buffers: Borrowed(&[
        BufferSlot::new("map_texels", 1, 16, false),
        BufferSlot::new("object", 2, 8, false),
        BufferSlot::new("lit", 3, 8, false),
        BufferSlot::new("blocked", 4, 8, false),
        BufferSlot::new("out", 5, 64, true),
    ]),
};

/// `transfer::transfer` as a compute entry point.
pub static TRANSFER: Entry = Entry {
    name: Borrowed("transfer"),
    kernel: Borrowed("glimt_render_gpu::kernels::transfer::transfer"),
    wgsl: Borrowed(include_str!("transfer.wgsl")),
    workgroup_size: 64,
    params_size: 64,
    params_space: ParamsSpace::Uniform,
    params: Borrowed(&[
        ParamField::new("first", 0, 4),
        ParamField::new("count", 4, 4),
        ParamField::new("state_len", 8, 4),
        ParamField::new("lit_len", 12, 4),
        ParamField::new("blocked_len", 16, 4),
        ParamField::new("params", 32, 24),
    ]),
    buffers: Borrowed(&[
        BufferSlot::new("nodes", 1, 112, false),
        BufferSlot::new("triangles", 2, 64, false),
        BufferSlot::new("surface", 3, 4, false),
        BufferSlot::new("vertices", 4, 48, false),
        BufferSlot::new("state", 5, 4, true),
        BufferSlot::new("lit", 6, 4, true),
        BufferSlot::new("blocked", 7, 4, true),
        BufferSlot::new("out", 8, 4, true),
    ]),
};

/// `capture::film_ball` as a compute entry point.
pub static FILM_BALL: Entry = Entry {
    name: Borrowed("film_ball"),
    kernel: Borrowed("glimt_render_gpu::kernels::capture::film_ball"),
    wgsl: Borrowed(include_str!("film_ball.wgsl")),
    workgroup_size: 64,
    params_size: 256,
    params_space: ParamsSpace::Uniform,
    params: Borrowed(&[
        ParamField::new("first", 0, 4),
        ParamField::new("count", 4, 4),
        ParamField::new("capture", 16, 176),
        ParamField::new("stage.params", 192, 64),
    ]),
    buffers: Borrowed(&[
        BufferSlot::new("stage.texels", 1, 16, false),
        BufferSlot::new("out", 2, 16, true),
    ]),
};

/// `capture::film_plate` as a compute entry point.
pub static FILM_PLATE: Entry = Entry {
    name: Borrowed("film_plate"),
    kernel: Borrowed("glimt_render_gpu::kernels::capture::film_plate"),
    wgsl: Borrowed(include_str!("film_plate.wgsl")),
    workgroup_size: 64,
    params_size: 288,
    params_space: ParamsSpace::Uniform,
    params: Borrowed(&[
        ParamField::new("first", 0, 4),
        ParamField::new("count", 4, 4),
        ParamField::new("frame", 16, 208),
        ParamField::new("stage.params", 224, 64),
    ]),
    buffers: Borrowed(&[
        BufferSlot::new("stage.texels", 1, 16, false),
        BufferSlot::new("out", 2, 16, true),
    ]),
};

/// `capture::film_latlong` as a compute entry point.
pub static FILM_LATLONG: Entry = Entry {
    name: Borrowed("film_latlong"),
    kernel: Borrowed("glimt_render_gpu::kernels::capture::film_latlong"),
    wgsl: Borrowed(include_str!("film_latlong.wgsl")),
    workgroup_size: 64,
    params_size: 112,
    params_space: ParamsSpace::Uniform,
    params: Borrowed(&[
        ParamField::new("first", 0, 4),
        ParamField::new("count", 4, 4),
        ParamField::new("latlong", 16, 32),
        ParamField::new("stage.params", 48, 64),
    ]),
    buffers: Borrowed(&[
        BufferSlot::new("stage.texels", 1, 16, false),
        BufferSlot::new("out", 2, 16, true),
    ]),
};

/// `sensor::expose` as a compute entry point.
pub static EXPOSE: Entry = Entry {
    name: Borrowed("expose"),
    kernel: Borrowed("glimt_render_gpu::kernels::sensor::expose"),
    wgsl: Borrowed(include_str!("expose.wgsl")),
    workgroup_size: 64,
    params_size: 64,
    params_space: ParamsSpace::Uniform,
    params: Borrowed(&[
        ParamField::new("first", 0, 4),
        ParamField::new("count", 4, 4),
        ParamField::new("sensor", 16, 48),
    ]),
    buffers: Borrowed(&[
        BufferSlot::new("radiance", 1, 16, false),
        BufferSlot::new("out", 2, 16, true),
    ]),
};

/// `diagnose::uniforms` as a compute entry point.
pub static DIAGNOSE_UNIFORMS: Entry = Entry {
    name: Borrowed("diagnose_uniforms"),
    kernel: Borrowed("glimt_render_gpu::kernels::diagnose::uniforms"),
    wgsl: Borrowed(include_str!("diagnose_uniforms.wgsl")),
    workgroup_size: 64,
    params_size: 240,
    params_space: ParamsSpace::Uniform,
    params: Borrowed(&[
        ParamField::new("first", 0, 4),
        ParamField::new("count", 4, 4),
        ParamField::new("frame", 16, 208),
        ParamField::new("mis", 224, 8),
    ]),
    buffers: Borrowed(&[
        BufferSlot::new("out", 1, 16, true),
    ]),
};

/// `diagnose::env_sample` as a compute entry point.
pub static DIAGNOSE_ENV_SAMPLE: Entry = Entry {
    name: Borrowed("diagnose_env_sample"),
    kernel: Borrowed("glimt_render_gpu::kernels::diagnose::env_sample"),
    wgsl: Borrowed(include_str!("diagnose_env_sample.wgsl")),
    workgroup_size: 64,
    params_size: 256,
    params_space: ParamsSpace::Uniform,
    params: Borrowed(&[
        ParamField::new("first", 0, 4),
        ParamField::new("count", 4, 4),
        ParamField::new("frame", 16, 208),
        ParamField::new("mis", 224, 8),
        ParamField::new("env.size", 240, 8),
        ParamField::new("env.rotation", 248, 8),
    ]),
    buffers: Borrowed(&[
        BufferSlot::new("env.tables", 1, 4, false),
        BufferSlot::new("out", 2, 32, true),
    ]),
};

/// `diagnose::primary_hit` as a compute entry point.
pub static DIAGNOSE_PRIMARY_HIT: Entry = Entry {
    name: Borrowed("diagnose_primary_hit"),
    kernel: Borrowed("glimt_render_gpu::kernels::diagnose::primary_hit"),
    wgsl: Borrowed(include_str!("diagnose_primary_hit.wgsl")),
    workgroup_size: 64,
    params_size: 224,
    params_space: ParamsSpace::Uniform,
    params: Borrowed(&[
        ParamField::new("first", 0, 4),
        ParamField::new("count", 4, 4),
        ParamField::new("frame", 16, 208),
    ]),
    buffers: Borrowed(&[
        BufferSlot::new("scene.nodes", 1, 112, false),
        BufferSlot::new("scene.triangles", 2, 64, false),
        BufferSlot::new("scene.surface", 3, 4, false),
        BufferSlot::new("out", 4, 16, true),
    ]),
};

/// `diagnose::surface` as a compute entry point.
pub static DIAGNOSE_SURFACE: Entry = Entry {
    name: Borrowed("diagnose_surface"),
    kernel: Borrowed("glimt_render_gpu::kernels::diagnose::surface"),
    wgsl: Borrowed(include_str!("diagnose_surface.wgsl")),
    workgroup_size: 64,
    params_size: 224,
    params_space: ParamsSpace::Uniform,
    params: Borrowed(&[
        ParamField::new("first", 0, 4),
        ParamField::new("count", 4, 4),
        ParamField::new("frame", 16, 208),
    ]),
    buffers: Borrowed(&[
        BufferSlot::new("scene.nodes", 1, 112, false),
        BufferSlot::new("scene.triangles", 2, 64, false),
        BufferSlot::new("scene.corners", 3, 32, false),
        BufferSlot::new("scene.surface", 4, 4, false),
        BufferSlot::new("out", 5, 64, true),
    ]),
};

/// `diagnose::brdf_sample` as a compute entry point.
pub static DIAGNOSE_BRDF_SAMPLE: Entry = Entry {
    name: Borrowed("diagnose_brdf_sample"),
    kernel: Borrowed("glimt_render_gpu::kernels::diagnose::brdf_sample"),
    wgsl: Borrowed(include_str!("diagnose_brdf_sample.wgsl")),
    workgroup_size: 64,
    params_size: 240,
    params_space: ParamsSpace::Uniform,
    params: Borrowed(&[
        ParamField::new("first", 0, 4),
        ParamField::new("count", 4, 4),
        ParamField::new("frame", 16, 208),
        ParamField::new("mis", 224, 8),
    ]),
    buffers: Borrowed(&[
        BufferSlot::new("scene.nodes", 1, 112, false),
        BufferSlot::new("scene.triangles", 2, 64, false),
        BufferSlot::new("scene.corners", 3, 32, false),
        BufferSlot::new("scene.surface", 4, 4, false),
        BufferSlot::new("out", 5, 16, true),
    ]),
};
