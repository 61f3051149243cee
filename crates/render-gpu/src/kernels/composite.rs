//! Shared file: layers laid over a plate, or made ready to be laid over one. One element is one pixel.

use glam::{Vec3, Vec4};
use glimt_probe::gather::ColourMatrix;
use glimt_sampling::math::luminance;

use super::film::{display_code, displayed, tone_curve};
use super::frame::{Background, FrameParams, Shadow};
use super::layers::PixelLayers;

/// One pixel of a plate. 16 bytes.
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct PlatePixel {
    /// Linear colour.
    pub linear: Vec3,
    /// How it is displayed: red, green, blue and 255, red in the lowest byte. It is made on the host, since a GPU's `pow` is
    /// not exact, and plates have to come through untouched.
    pub code: u32,
}

/// Linear value of the tile's pixel `pixel` over the plate, in the plate's units, with alpha 1.
///
/// `object · exposure + plate · t (1 − a)`, or, for shadows that are added, `object · exposure + plate (1 − a) − blocked ·
/// exposure`, at least 0. Where nothing of the scene touches the pixel, it is the plate bit by bit.
#[must_use]
pub fn composite_over_plate(
    pixel: u32,
    frame: &FrameParams,
    layers: &[PixelLayers],
    plate: &[PlatePixel],
) -> Vec4 {
    let behind = plate[pixel as usize].linear;
    if layers[pixel as usize].is_plate() {
        return behind.extend(1.0);
    }
    let layer = in_primaries(&frame.to_plate, &layers[pixel as usize]);
    over(
        frame,
        &layer,
        exposed(frame, layer.object.truncate()),
        behind,
    )
    .extend(1.0)
}

/// Display value of the tile's pixel `pixel` over the plate, red in the lowest byte and 255 in the highest.
///
/// The formulas are those of [`composite_over_plate`], for the objects' colours after the tonemap and the plate's clipped to
/// [0, 1], both linear and with the display's primaries; then the sRGB curve. An untouched plate keeps its codes.
#[must_use]
pub fn display_over_plate(
    pixel: u32,
    frame: &FrameParams,
    layers: &[PixelLayers],
    plate: &[PlatePixel],
) -> u32 {
    if layers[pixel as usize].is_plate() {
        return plate[pixel as usize].code;
    }
    let layer = in_primaries(&frame.to_plate, &layers[pixel as usize]);
    let alpha = layer.object.w;
    let mut object = Vec3::ZERO;
    if alpha > 0.0 {
        let radiance = exposed(frame, layer.object.truncate() / alpha);
        object = tone_curve(frame, displayed(frame, radiance)) * alpha;
    }
    let behind = displayed(frame, plate[pixel as usize].linear).min(Vec3::ONE);
    let linear = over(frame, &layer, object, behind);
    display_code(linear.clamp(Vec3::ZERO, Vec3::ONE), 1.0)
}

/// Layers with other primaries. Channels that are negative there, of colours outside the gamut, become 0.
#[must_use]
pub fn in_primaries(matrix: &ColourMatrix, layer: &PixelLayers) -> PixelLayers {
    let object = matrix.apply(layer.object).truncate();
    PixelLayers {
        object: object.extend(layer.object.w),
        lit: matrix.apply(layer.lit.extend(1.0)).truncate(),
        catcher: layer.catcher,
        blocked: matrix.apply(layer.blocked.extend(1.0)).truncate(),
        unused_a: 0,
        behind: layer.behind,
        unused_b: 0,
    }
}

/// Radiance in the plate's units, at least 0. The bound keeps what any exposure makes of any radiance finite.
#[inline]
fn exposed(frame: &FrameParams, radiance: Vec3) -> Vec3 {
    (radiance * frame.exposure).clamp(Vec3::ZERO, Vec3::splat(1e37))
}

/// An object's premultiplied colour over a plate in shadow.
#[inline]
fn over(frame: &FrameParams, layer: &PixelLayers, object: Vec3, behind: Vec3) -> Vec3 {
    let clear = 1.0 - layer.object.w;
    if frame.shadow == Shadow::Add {
        return (object + behind * clear - exposed(frame, layer.blocked)).max(Vec3::ZERO);
    }
    object + behind * (layer.transmission() * clear)
}

/// Linear value of the tile's pixel `pixel` without a plate, not exposed.
///
/// Before the environment the light map takes the plate's place, with alpha 1. Before a transparent background the shadow
/// becomes alpha, black in colour: `a + (1 − a) (1 − Y(t))`, Y the luminance. One alpha cannot carry a coloured shadow; this
/// one gives a grey plate the right luminance.
#[must_use]
pub fn composite_alone(pixel: u32, frame: &FrameParams, layers: &[PixelLayers]) -> Vec4 {
    let layer = layers[pixel as usize];
    let object = layer.object.truncate();
    let clear = 1.0 - layer.object.w;
    let t = layer.transmission();
    if frame.background == Background::Environment {
        return (object + layer.behind * (t * clear)).extend(1.0);
    }
    // By what is lost, which is exactly 0 where nothing is.
    object.extend(layer.object.w + clear * luminance(Vec3::ONE - t))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn layout_is_that_of_wgsl() {
        assert_eq!(core::mem::size_of::<PlatePixel>(), 16);
        assert_eq!(core::mem::offset_of!(PlatePixel, code), 12);
    }
}
