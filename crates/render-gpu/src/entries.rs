//! Host file: the kernels that are lowered to entry points, one `generated/NAME.wgsl` for each. It depends on nothing, so that what
//! writes those files can be built before they exist.

/// The methods without memory, one line each: a new one is added here.
///
/// `Settings in module = word, kernel, pass over rays, pass in layers`. The settings stand in `methods/<module>.rs`; the word names
/// the method in a shot. Of those in `rays`, which estimate each ray's light by itself, the kernel is an estimator, a path below
/// `kernels`. Of those in `groups`, which estimate a pixel's light at once from the hits of all its rays, it is the function that does.
/// The passes are made from the word.
#[macro_export]
macro_rules! each_estimator {
    ($then:ident) => {
        $then! {
            rays {
                Mis in mis = "mis", "mis::Mis", ShadeMis, ShadeMisLayers;
                Bis in bis = "bis", "bis::Bis", ShadeBis, ShadeBisLayers;
            }
            groups {
                Product in product = "product", "product::shade_product", ShadeProduct, ShadeProductLayers;
            }
        }
    };
}

/// What an entry is for. Whatever depends on it takes the digest of all entries of its role.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// Its results reach the pixels of a rendered frame.
    Pixels,
    /// It precomputes transfer.
    Bake,
    /// It films a simulated capture.
    Synth,
    /// It shows tests one stage of a kernel.
    Diagnosis,
}

/// An entry point to generate.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct EntrySpec {
    /// Name of the entry point and of its files.
    pub name: String,
    /// Path of the kernel, from the crate's name on.
    pub kernel: String,
    /// Invocations in a workgroup.
    pub workgroup_size: u32,
    /// What it is for.
    pub role: Role,
}

fn entry(role: Role, name: &str, kernel: &str) -> EntrySpec {
    EntrySpec {
        name: name.to_owned(),
        kernel: format!("glimt_render_gpu::kernels::{kernel}"),
        // Two warps, or one wave: a ray's traversal keeps many registers, and more per group would leave cores idle.
        workgroup_size: 64,
        role,
    }
}

macro_rules! words_and_kernels {
    (
        rays { $($_r:ident in $_rm:ident = $ray_word:literal, $estimator:literal, $_rf:ident, $_rl:ident;)+ }
        groups { $($_g:ident in $_gm:ident = $group_word:literal, $kernel:literal, $_gf:ident, $_gl:ident;)+ }
    ) => {
        const ESTIMATORS: &[(&str, &str)] = &[$(($ray_word, $estimator)),+];
        const GROUPS: &[(&str, &str)] = &[$(($group_word, $kernel)),+];
    };
}

each_estimator!(words_and_kernels);

/// A pass that makes samples of rays, over rays and in layers. `kernel` makes its path of the samples' type.
fn shading(word: &str, kernel: impl Fn(&str) -> String) -> [EntrySpec; 2] {
    let flat = kernel("glam::Vec4");
    let layers = kernel("glimt_render_gpu::kernels::layers::LayerSample");
    [
        entry(Role::Pixels, &format!("shade_{word}"), &flat),
        entry(Role::Pixels, &format!("shade_{word}_layers"), &layers),
    ]
}

/// All entry points.
#[must_use]
pub fn all() -> Vec<EntrySpec> {
    let mut list: Vec<EntrySpec> = Vec::new();
    for (word, estimator) in ESTIMATORS {
        list.extend(shading(word, |sample| {
            format!("shade::shade::<glimt_render_gpu::kernels::{estimator}, {sample}>")
        }));
    }
    for (word, kernel) in GROUPS {
        list.extend(shading(word, |sample| format!("{kernel}::<{sample}>")));
    }
    let of_role = |role: Role, entries: &[(&str, &str)]| -> Vec<EntrySpec> {
        let each = entries.iter();
        each.map(|(name, kernel)| entry(role, name, kernel))
            .collect()
    };
    list.extend(of_role(Role::Pixels, PIXELS));
    list.extend(of_role(Role::Bake, &[("transfer", "transfer::transfer")]));
    list.extend(of_role(Role::Synth, SYNTH));
    list.extend(of_role(Role::Diagnosis, DIAGNOSIS));
    list
}

const PIXELS: &[(&str, &str)] = &[
    ("see", "seen::see"),
    ("scout", "scout::scout"),
    ("see_in_tile", "scout::see_in_tile"),
    ("carry", "carry::carry"),
    ("pilot", "pilot::pilot"),
    ("expect", "expect::expect"),
    ("worth", "expect::worth"),
    ("add_worths", "expect::add_worths"),
    ("shade_cells", "cells::shade_cells::<glam::Vec4>"),
    (
        "shade_cells_layers",
        "cells::shade_cells::<glimt_render_gpu::kernels::layers::LayerSample>",
    ),
    ("diagnose_groups", "group_health::diagnose_groups"),
    ("find_smc", "smc_point::find_smc"),
    ("advance_smc", "smc::advance_smc"),
    ("gather_smc", "smc_gather::gather_smc::<glam::Vec4>"),
    (
        "gather_smc_layers",
        "smc_gather::gather_smc::<glimt_render_gpu::kernels::layers::LayerSample>",
    ),
    ("diagnose_smc", "smc::diagnose_smc"),
    ("reconstruct", "film::reconstruct"),
    ("tonemap", "film::tonemap"),
    ("unwarp", "unwarp::unwarp"),
    ("reconstruct_layers", "layers::reconstruct_layers"),
    ("composite_over_plate", "composite::composite_over_plate"),
    ("display_over_plate", "composite::display_over_plate"),
    ("composite_alone", "composite::composite_alone"),
    ("taps", "pyramid::taps"),
    ("halve", "pyramid::halve"),
    ("light_coefficient", "light_sh::light_coefficient"),
    ("vertex_light", "prt::vertex_light"),
    ("unpack_layers", "raster::unpack_layers"),
];

const SYNTH: &[(&str, &str)] = &[
    ("film_ball", "capture::film_ball"),
    ("film_plate", "capture::film_plate"),
    ("film_latlong", "capture::film_latlong"),
    ("expose", "sensor::expose"),
];

const DIAGNOSIS: &[(&str, &str)] = &[
    ("diagnose_uniforms", "diagnose::uniforms"),
    ("diagnose_env_sample", "diagnose::env_sample"),
    ("diagnose_primary_hit", "diagnose::primary_hit"),
    ("diagnose_surface", "diagnose::surface"),
    ("diagnose_brdf_sample", "diagnose::brdf_sample"),
];
