//! Host file: the layers of a frame that a compositor needs to lay it over its plate once more.

use crate::shot::{Aov, Shadow};
use glam::Vec3;
use glimt_render_gpu::host::render::{FrameImage, RenderSettings};
use glimt_render_gpu::kernels::layers::PixelLayers;

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
pub fn first_channel(layer: &str) -> String {
    format!("{layer}.R")
}

/// The layer's name.
pub fn name(aov: Aov) -> &'static str {
    match aov {
        Aov::Object => "object",
        Aov::Catcher => "catcher",
        Aov::Difference => "difference",
    }
}

/// How the image is made of its layers.
pub fn formula(shadow: Shadow) -> &'static str {
    match shadow {
        Shadow::Multiply => "out = object.rgb + plate * catcher * (1 - object.a)",
        Shadow::Add => "out = max(0, object.rgb + plate * (1 - object.a) + difference)",
    }
}

/// The channels of the layers asked for, in the units of the image: over a plate they are exposed.
pub fn channels(
    image: &FrameImage,
    aovs: &[Aov],
    settings: &RenderSettings,
    over_plate: bool,
) -> Vec<Channel> {
    let layers = image.layers.as_deref().unwrap_or_default();
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
