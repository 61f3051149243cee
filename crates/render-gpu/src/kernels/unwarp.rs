//! Shared file: a photograph resampled into a light map. One element is one texel.

use glam::Vec4;
use glimt_probe::gather::{ColourMatrix, GatherMap, gather};

/// Texel `texel` of the map: the pixels that belong to it over what the mirror reflects, their colours changed.
#[inline(always)]
#[must_use]
pub fn unwarp(
    texel: u32,
    map: GatherMap<'_>,
    colour: &ColourMatrix,
    reflectance: Vec4,
    pixels: &[Vec4],
) -> Vec4 {
    gather(texel, map, colour, reflectance, pixels)
}
