//! Host file: what an image holds.

use crate::colour::primaries::REC_709;
use crate::error::Result;
use crate::input::plate::{self, Colours};
use crate::input::{BadTexels, Header, Reading, format_of, read_as};
use crate::notes::Notes;
use crate::report::shown;
use glam::{UVec2, Vec4};
use glimt_probe::latlong;
use glimt_sampling::math::luminance;
use serde::Serialize;
use serde_json::{Value, json};
use std::path::Path;

/// Luminance of an image taken as a lat-long map.
#[derive(Clone, Debug, PartialEq, Serialize)]
struct Light {
    /// Mean over the sphere, weighted by solid angle.
    mean: f64,
    /// The largest.
    max: f32,
    /// From the first percentile of the positive ones to the largest, in factors of two.
    stops: f64,
    /// Column and row of the brightest texel.
    brightest_texel: [u32; 2],
    /// The direction that it shows.
    brightest_direction: [f32; 3],
}

/// Lines of names and texts.
#[derive(Default)]
struct Lines(Vec<String>);

impl Lines {
    fn line(&mut self, name: &str, text: String) {
        self.0.push(format!("{name:<12}{text}"));
    }
}

pub(super) fn describe(file: &Path, notes: &mut Notes) -> Result<(Value, String)> {
    if !format_of(file)?.is_hdr() {
        return describe_display(file, notes);
    }
    let mut image = read_as(file, &Reading::default(), notes)?;
    let bad = BadTexels::count(&image.texels);
    image.convert_to(&REC_709);
    let header = &image.header;
    let light = measure(header.size, &image.texels);

    let mut lines = Lines::default();
    let mut line = |name: &str, text: String| lines.line(name, text);
    line("format", format!("{}, {}", header.format, header.storage));
    line("size", size(header.size, header.pixel_aspect));
    line("channels", header.channels.join(", "));
    for (name, text) in layers(header) {
        line(name, text);
    }
    line("primaries", header.primaries.clone());
    line("transfer", header.transfer.clone());
    if !header.data_is_display() {
        line(
            "windows",
            format!(
                "data {} × {} from {:?}, display from {:?}",
                header.data_size.x, header.data_size.y, header.data_origin, header.display_origin
            ),
        );
    }
    for remark in &header.remarks {
        line("", remark.clone());
    }
    let texels = image.texels.len();
    line(
        "bad texels",
        match bad.total() {
            0 => "none".to_owned(),
            n => format!("{n} of {texels}: {bad}"),
        },
    );
    match &light {
        None => line("luminance", "black".to_owned()),
        Some(light) => {
            let [x, y, z] = light.brightest_direction;
            let [column, row] = light.brightest_texel;
            line(
                "luminance",
                format!(
                    "mean {:.4}, max {:.4}, {:.1} stops",
                    light.mean, light.max, light.stops
                ),
            );
            line(
                "brightest",
                format!(
                    "texel ({column}, {row}), direction ({x:.3}, {y:.3}, {z:.3}) as a lat-long map"
                ),
            );
        }
    }
    let value = json!({"file": shown(file), "kind": "image", "header": header, "bad_texels": bad, "light": light});
    Ok((value, lines.0.join("\n")))
}

/// Width and height, and the shape of pixels that are not square.
fn size(size: UVec2, pixel_aspect: f32) -> String {
    let shape = match size.x == 2 * size.y {
        true => " (2:1)",
        false => "",
    };
    let pixels = match pixel_aspect == 1.0 {
        true => String::new(),
        false => format!(", pixels {pixel_aspect} times as wide as high"),
    };
    format!("{} × {}{shape}{pixels}", size.x, size.y)
}

/// The parts and layers of a file that has more than one.
fn layers(header: &Header) -> Vec<(&'static str, String)> {
    let mut lines = Vec::new();
    if header.parts > 1 {
        lines.push(("parts", header.parts.to_string()));
    }
    if !header.layer.is_empty() {
        lines.push(("layer", format!("{} (the one that is read)", header.layer)));
    }
    if !header.other_layers.is_empty() {
        lines.push(("layers", header.other_layers.join(", ")));
    }
    lines
}

/// An image of a display, as plates are: PNG, JPEG or TIFF.
fn describe_display(file: &Path, notes: &mut Notes) -> Result<(Value, String)> {
    let reading = Reading::default();
    let header = plate::read_plate_header(file, &reading)?;
    let image = plate::read(file, &reading, notes)?;
    let bits = match image.colours {
        Colours::Srgb8(_) => "codes of 8 bits",
        Colours::Linear(_) => "linear when read",
    };
    let mut lines = Lines::default();
    let mut line = |name: &str, text: String| lines.line(name, text);
    line("format", format!("{}, {bits}", header.storage));
    line("size", size(header.size, header.pixel_aspect));
    line("primaries", header.primaries.clone());
    line("transfer", header.transfer.clone());
    let value = json!({
        "file": shown(file), "kind": "display image", "storage": header.storage, "size": header.size.to_array(),
        "primaries": header.primaries, "transfer": header.transfer, "pixel_aspect": header.pixel_aspect,
    });
    Ok((value, lines.0.join("\n")))
}

/// Bad texels count as black. `None` for a black image.
fn measure(size: UVec2, texels: &[Vec4]) -> Option<Light> {
    let mut positive = Vec::new();
    let (mut sum, mut brightest, mut max) = (0.0, 0, 0.0);
    for (i, texel) in texels.iter().enumerate() {
        let value = luminance(texel.truncate());
        if !(value > 0.0 && value.is_finite()) {
            continue;
        }
        let row = i as u32 / size.x;
        sum += f64::from(value) * f64::from(latlong::texel_solid_angle_sr(row, size));
        positive.push(value);
        if value > max {
            (max, brightest) = (value, i as u32);
        }
    }
    if positive.is_empty() {
        return None;
    }
    let index = positive.len() / 100;
    let (_, first_percentile, _) = positive.select_nth_unstable_by(index, f32::total_cmp);
    let texel = UVec2::new(brightest % size.x, brightest / size.x);
    Some(Light {
        mean: sum / (4.0 * std::f64::consts::PI),
        max,
        stops: (f64::from(max) / f64::from(*first_percentile)).log2(),
        brightest_texel: texel.to_array(),
        brightest_direction: latlong::texel_direction(texel, size).to_array(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_lamp_is_found() {
        let size = UVec2::new(8, 4);
        let mut texels = vec![Vec4::new(1.0, 1.0, 1.0, 1.0); 32];
        texels[8 + 3] = Vec4::new(1024.0, 1024.0, 1024.0, 1.0);
        texels[0] = Vec4::splat(f32::NAN);
        let light = measure(size, &texels).unwrap();
        assert_eq!(light.brightest_texel, [3, 1]);
        assert!((light.stops - 10.0).abs() < 1e-6);
        // Left of the centre, above the horizon: ahead, toward +y, up.
        let [x, y, z] = light.brightest_direction;
        assert!(x > 0.0 && y > 0.0 && z > 0.0);
        assert_eq!(measure(size, &[Vec4::ZERO; 32]), None);
    }
}
