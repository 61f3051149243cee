//! Host file: functions that are exported for shaders that people write themselves.

/// A crate's functions for people who write their own shaders.
pub(crate) struct Export {
    /// File, from the workspace's root.
    pub(crate) file: &'static str,
    pub(crate) functions: &'static [(&'static str, &'static str)],
    /// Group and binding of each buffer.
    pub(crate) buffers: &'static [(&'static str, u32, u32)],
}

pub(crate) const EXPORTS: &[Export] = &[
    Export {
        file: "crates/envmap-cdf/wgsl/envmap_cdf.wgsl",
        functions: &[
            ("env_sample", "glimt_envmap_cdf::EnvCdf::sample"),
            ("env_pdf_sr", "glimt_envmap_cdf::EnvCdf::pdf_sr"),
            ("env_texel_pdf_sr", "glimt_envmap_cdf::EnvCdf::texel_pdf_sr"),
            ("env_invert", "glimt_envmap_cdf::EnvCdf::invert"),
            ("env_is_black", "glimt_envmap_cdf::EnvCdf::is_black"),
        ],
        buffers: &[("marginal", 0, 1), ("conditional", 0, 2)],
    },
    Export {
        file: "crates/brdf/wgsl/brdf.wgsl",
        functions: &[
            ("blinn_phong_eval", "glimt_brdf::BlinnPhong::eval"),
            ("blinn_phong_sample", "glimt_brdf::BlinnPhong::sample"),
            ("blinn_phong_pdf_sr", "glimt_brdf::BlinnPhong::pdf_sr"),
            ("lambert_eval", "glimt_brdf::Lambert::eval"),
            ("lambert_sample", "glimt_brdf::Lambert::sample"),
            ("lambert_pdf_sr", "glimt_brdf::Lambert::pdf_sr"),
        ],
        buffers: &[],
    },
    Export {
        file: "crates/light-cells/wgsl/light_cells.wgsl",
        functions: &[
            ("cell_of", "glimt_light_cells::LightCells::cell_of"),
            ("cell_sample", "glimt_light_cells::LightCells::sample"),
            ("cell_pmf", "glimt_light_cells::LightCells::pmf_in_cell"),
            ("cell_quad", "glimt_light_cells::LightCells::quad"),
            ("cell_surface", "glimt_light_cells::CellSurface::new"),
            ("cell_terms", "glimt_light_cells::LightCells::terms"),
            (
                "cell_product_weights",
                "glimt_light_cells::CellSurface::product_weights",
            ),
            (
                "cell_residual_weights",
                "glimt_light_cells::CellSurface::residual_weights",
            ),
        ],
        buffers: &[("words", 0, 1)],
    },
    Export {
        file: "crates/probe/wgsl/probe.wgsl",
        functions: &[
            (
                "lat_long_direction",
                "glimt_probe::latlong::uv_to_direction",
            ),
            ("lat_long_uv", "glimt_probe::latlong::direction_to_uv"),
            ("lat_long_texel", "glimt_probe::latlong::direction_to_texel"),
            (
                "lat_long_texel_direction",
                "glimt_probe::latlong::texel_direction",
            ),
            (
                "lat_long_texel_solid_angle_sr",
                "glimt_probe::latlong::texel_solid_angle_sr",
            ),
            (
                "mirror_ball_direction",
                "glimt_probe::mirror_ball::MirrorBall::image_to_direction",
            ),
            (
                "mirror_ball_image",
                "glimt_probe::mirror_ball::MirrorBall::direction_to_image",
            ),
            (
                "mirror_ball_solid_angle_sr_per_area",
                "glimt_probe::mirror_ball::MirrorBall::solid_angle_sr_per_area",
            ),
            ("gather_texel", "glimt_probe::gather::gather"),
        ],
        buffers: &[("map_texels", 0, 1), ("map_taps", 0, 2), ("pixels", 0, 3)],
    },
    Export {
        file: "crates/sampling/wgsl/sampling.wgsl",
        functions: &[
            ("unit_float", "glimt_sampling::uniform::unit_f32"),
            ("unit_pair", "glimt_sampling::uniform::unit_vec2"),
            (
                "balance_heuristic",
                "glimt_sampling::mis::balance_heuristic",
            ),
            ("power_heuristic", "glimt_sampling::mis::power_heuristic"),
            (
                "shading_frame",
                "glimt_sampling::math::ShadingFrame::from_normal",
            ),
            ("sample_cap", "glimt_sampling::warp::sample_cap"),
            ("owen_sobol", "glimt_sampling::sobol::OwenSobol::new"),
            (
                "owen_sobol_next",
                "<glimt_sampling::sobol::OwenSobol as glimt_sampling::uniform::UniformSource>::next_uvec2",
            ),
            (
                "xoshiro_stream",
                "glimt_sampling::xoshiro::Xoshiro128PlusPlus::stream",
            ),
            (
                "xoshiro_next",
                "<glimt_sampling::xoshiro::Xoshiro128PlusPlus as glimt_sampling::uniform::UniformSource>::next_u32",
            ),
            ("ris_sum", "glimt_sampling::ris::RisSum::new"),
            ("ris_add", "glimt_sampling::ris::RisSum::add"),
            ("ris_normaliser", "glimt_sampling::ris::RisSum::normaliser"),
            ("ris_picks", "glimt_sampling::ris::RisPicks::new"),
            ("ris_take", "glimt_sampling::ris::RisPicks::take"),
            ("ris_is_done", "glimt_sampling::ris::RisPicks::is_done"),
            (
                "resample_comb",
                "glimt_sampling::resample::Comb::new::<glimt_sampling::xoshiro::Xoshiro128PlusPlus>",
            ),
            (
                "resample_take",
                "glimt_sampling::resample::Comb::take::<glimt_sampling::xoshiro::Xoshiro128PlusPlus>",
            ),
            (
                "resample_finish",
                "glimt_sampling::resample::Comb::finish::<glimt_sampling::xoshiro::Xoshiro128PlusPlus>",
            ),
        ],
        buffers: &[],
    },
    Export {
        file: "crates/smc/wgsl/smc.wgsl",
        functions: &[
            ("smc_accept", "glimt_smc::metropolis::accept"),
            ("smc_bridge_density", "glimt_smc::Bridge::density"),
            ("smc_bridge_steps", "glimt_smc::Bridge::steps"),
            ("smc_split_word", "glimt_smc::split_word"),
            ("smc_particle_weight", "glimt_smc::Particle::weight"),
            ("smc_is_log_zero", "glimt_smc::is_log_zero"),
        ],
        buffers: &[],
    },
    Export {
        file: "crates/sh/wgsl/sh.wgsl",
        functions: &[
            ("sh_basis", "glimt_sh::basis::basis"),
            ("sh_add_basis", "glimt_sh::basis::add_basis"),
            ("sh_ring", "glimt_sh::separable::ring"),
            ("sh_meridian", "glimt_sh::separable::meridian"),
            ("sh_hann", "glimt_sh::hann"),
            ("sh_cosine_lobe", "glimt_sh::cosine_lobe"),
            ("sh_coefficient_band", "glimt_sh::coefficient_band"),
            ("sh_coefficient_order", "glimt_sh::coefficient_order"),
            ("sh_temporal_filter", "glimt_sh::temporal_filter"),
            ("sh_rotate_z", "glimt_sh::rotate_z"),
            ("sh_stratified_direction", "glimt_sh::stratified_direction"),
        ],
        buffers: &[],
    },
    // What the stages that are written by hand call.
    Export {
        file: "crates/render-gpu/src/generated/projection_functions.wgsl",
        functions: &[
            ("column_ring", "glimt_sh::separable::column_ring"),
            ("row_meridian", "glimt_sh::separable::row_meridian"),
            ("row_area", "glimt_probe::latlong::texel_solid_angle_sr"),
            ("coefficient_band", "glimt_sh::coefficient_band"),
            ("coefficient_order", "glimt_sh::coefficient_order"),
            ("ring_index", "glimt_sh::separable::ring_index"),
            ("meridian_index", "glimt_sh::separable::meridian_index"),
        ],
        buffers: &[],
    },
    Export {
        file: "crates/render-gpu/src/generated/raster_functions.wgsl",
        functions: &[
            (
                "corner_position",
                "glimt_render_gpu::kernels::raster::corner_position",
            ),
            (
                "corner_weights",
                "glimt_render_gpu::kernels::raster::corner_weights",
            ),
            (
                "clip_position",
                "glimt_render_gpu::kernels::raster::clip_position",
            ),
            (
                "corner_near",
                "glimt_render_gpu::kernels::raster::corner_near",
            ),
            (
                "keeps_sample",
                "glimt_render_gpu::kernels::raster::keeps_sample",
            ),
            ("draw", "glimt_render_gpu::kernels::raster::draw"),
        ],
        buffers: &[
            ("scene_triangles", 0, 1),
            ("scene_corners", 0, 2),
            ("scene_surface", 0, 3),
            ("surface_corner_vertices", 0, 4),
            ("surface_reflections", 0, 5),
            ("surface_lights", 0, 6),
            ("texels", 0, 7),
        ],
    },
];
