//! Host file: the layers of a frame that a compositor needs to lay it over its plate once more.

use crate::shot::{Aov, Shadow};
use glam::Vec3;
use glimt_probe::gather::ColourMatrix;
use glimt_render_gpu::kernels::composite::in_primaries;
use glimt_render_gpu::kernels::group_health::GroupHealth;
use glimt_render_gpu::kernels::layers::PixelLayers;
use glimt_render_gpu::kernels::smc::SmcHealth;
use glimt_render_gpu::prepare::render::{Diagnostics, FrameImage, RenderSettings};
use std::borrow::Cow;

/// Key of the formula in the EXR.
pub const FORMULA_KEY: &str = "glimtComposite";

/// The layer of what is displayed, in codes of 8 bits over 255: in EXRs over a plate, from which it cannot be computed again.
pub const DISPLAY: &str = "display";

/// A channel of an EXR.
#[derive(Clone, Debug, PartialEq)]
pub struct Channel {
    /// Its name, as `object.R`.
    pub name: String,
    /// Its samples, rows from the top.
    pub samples: Vec<f32>,
    /// Whether 16 bits hold them.
    pub half: bool,
}

/// Name of a layer's first channel, by which a file is known to have it.
pub fn first_channel(aov: Aov) -> String {
    let name = name(aov);
    match aov.is_diagnostic() {
        true => name.to_owned(),
        false => format!("{name}.R"),
    }
}

/// Name of the first channel of [`DISPLAY`].
pub fn first_display_channel() -> String {
    format!("{DISPLAY}.R")
}

/// The layer's name; of one with a single channel, that channel's.
pub fn name(aov: Aov) -> &'static str {
    match aov {
        Aov::Object => "object",
        Aov::Catcher => "catcher",
        Aov::Difference => "difference",
        Aov::Ess => "smc.ess",
        Aov::ZRatio => "smc.log_z_ratio",
        Aov::Age => "smc.age",
        Aov::Started => "smc.started",
        Aov::ZSpread => "smc.z_spread",
        Aov::Rays => "cells.rays",
        Aov::VisibilityError => "cells.visibility_error",
    }
}

/// What it is of [`FrameImage::diagnostics`]; nothing of those of another method.
fn diagnostic(aov: Aov, diagnostics: Option<&Diagnostics>) -> Vec<f32> {
    let of_particles = |value: fn(&SmcHealth) -> f32| match diagnostics {
        Some(Diagnostics::Particles(pixels)) => pixels.iter().map(value).collect(),
        _ => Vec::new(),
    };
    let of_groups = |value: fn(&GroupHealth) -> f32| match diagnostics {
        Some(Diagnostics::Groups { pixels, .. }) => pixels.iter().map(value).collect(),
        _ => Vec::new(),
    };
    match aov {
        Aov::Ess => of_particles(|health| health.ess),
        Aov::ZRatio => of_particles(|health| health.log_ratio),
        Aov::Age => of_particles(|health| health.age),
        Aov::Started => of_particles(|health| health.started),
        Aov::ZSpread => of_particles(|health| health.spread),
        Aov::Rays => of_groups(|health| health.rays),
        Aov::VisibilityError => of_groups(|health| health.residual),
        Aov::Object | Aov::Catcher | Aov::Difference => Vec::new(),
    }
}

/// Whether some of them are layers of the composite.
pub fn any_layer(aovs: &[Aov]) -> bool {
    aovs.iter().any(|aov| !aov.is_diagnostic())
}

/// Whether some of them say how the method fares.
pub fn any_diagnostic(aovs: &[Aov]) -> bool {
    aovs.iter().any(|aov| aov.is_diagnostic())
}

/// How the image is made of its layers.
pub fn formula(shadow: Shadow) -> &'static str {
    match shadow {
        Shadow::Multiply => "out = object.rgb + plate * catcher * (1 - object.a)",
        Shadow::Add => "out = max(0, object.rgb + plate * (1 - object.a) + difference)",
    }
}

/// The channels of the layers asked for, in the units of the image: over a plate they are exposed. `to_written` leads from the
/// primaries that were rendered with to those of the file.
pub fn channels(
    image: &FrameImage,
    aovs: &[Aov],
    settings: &RenderSettings,
    over_plate: bool,
    to_written: &ColourMatrix,
) -> Vec<Channel> {
    let layers = image.layers.as_deref().unwrap_or_default();
    let layers: Cow<'_, [PixelLayers]> = match *to_written == ColourMatrix::IDENTITY {
        true => Cow::Borrowed(layers),
        false => layers
            .iter()
            .map(|layer| in_primaries(to_written, layer))
            .collect(),
    };
    let exposure = if over_plate {
        settings.exposure_ev.exp2()
    } else {
        1.0
    };
    let rgb = |layer: &str, value: &dyn Fn(&PixelLayers) -> Vec3| {
        ["R", "G", "B"]
            .into_iter()
            .enumerate()
            .map(|(c, letter)| Channel {
                name: format!("{layer}.{letter}"),
                samples: layers.iter().map(|l| value(l)[c]).collect(),
                half: false,
            })
            .collect::<Vec<_>>()
    };
    let mut list = Vec::new();
    for &aov in aovs {
        let layer = name(aov);
        list.extend(match aov {
            Aov::Object => rgb(layer, &|l| finite(l.object.truncate() * exposure)),
            Aov::Catcher => rgb(layer, &PixelLayers::transmission),
            Aov::Difference => rgb(layer, &|l| finite(-l.blocked * exposure)),
            _ => vec![Channel {
                name: layer.to_owned(),
                samples: diagnostic(aov, image.diagnostics.as_ref()),
                half: false,
            }],
        });
        if aov == Aov::Object {
            list.push(Channel {
                name: format!("{layer}.A"),
                samples: layers.iter().map(|l| l.object.w).collect(),
                half: false,
            });
        }
    }
    // A layer that is asked for twice is there once.
    list.sort_by(|a, b| a.name.cmp(&b.name));
    list.dedup_by(|a, b| a.name == b.name);
    list
}

/// Within the bound that the composite has.
fn finite(value: Vec3) -> Vec3 {
    value.clamp(Vec3::splat(-1e37), Vec3::splat(1e37))
}

/// The channels of [`DISPLAY`].
pub fn display(image: &FrameImage) -> Vec<Channel> {
    let channel = |(c, letter): (usize, &str)| Channel {
        name: format!("{DISPLAY}.{letter}"),
        samples: image
            .display
            .iter()
            .map(|p| f32::from(p[c]) / 255.0)
            .collect(),
        half: true,
    };
    ["R", "G", "B"]
        .into_iter()
        .enumerate()
        .map(channel)
        .collect()
}
