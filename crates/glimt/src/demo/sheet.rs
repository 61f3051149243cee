//! Host file: the contact sheet: for some frames a row of probe, unwarped map, render and composite.

use super::frame_file;
use crate::error::{Error, Result};
use crate::input::Reading;
use crate::input::light_image::read_photo;
use crate::input::plate;
use crate::input::read_image;
use crate::input::resample::{Window, resample};
use crate::notes::Notes;
use crate::output::png;
use crate::output::target::Target;
use ::exr::prelude::read_first_flat_layer_from_file;
use glam::{UVec2, Vec3};
use glimt_ball::find;
use glimt_render_gpu::prepare::plate::linear_to_srgb8;
use rayon::prelude::*;
use std::path::Path;

/// Rows at most.
const ROWS: usize = 5;
/// Height of a panel, and the space around it, in pixels.
const HEIGHT: u32 = 216;
const GAP: u32 = 10;
/// Linear value of what is between the panels, and of the ground on which a render without its plate is shown.
const SURROUND: f32 = 0.012;
const GROUND: f32 = 0.35;
/// Exposure of probe and map: a little below the shot's, so that the sky keeps its blue.
const EXPOSURE: f32 = 1.0 / 32.0;

/// A picture of linear colours.
struct Panel {
    size: UVec2,
    pixels: Vec<Vec3>,
}

impl Panel {
    /// The picture, or a part of it, at the sheet's height.
    fn fitted(size: UVec2, pixels: &[Vec3], window: Window) -> Self {
        let width = (window.size[0] / window.size[1] * f64::from(HEIGHT)).round() as u32;
        let target = UVec2::new(width.max(1), HEIGHT);
        Self {
            size: target,
            pixels: resample(size, pixels, window, target),
        }
    }
}

/// Writes the sheet of up to five of these frames, spread evenly.
///
/// # Errors
/// A picture cannot be read, or the sheet not written.
pub(super) fn write(file: &Target, out: &Path, frames: &[i32]) -> Result<()> {
    let rows = ROWS.min(frames.len());
    let chosen = (0..rows).map(|i| frames[i * (frames.len() - 1) / (rows - 1).max(1)]);
    let chosen: Vec<i32> = chosen.collect();
    let panels: Vec<[Panel; 4]> = chosen
        .par_iter()
        .map(|&frame| {
            Ok([
                probe(out, frame)?,
                map(out, frame)?,
                render(out, frame)?,
                composite(out, frame)?,
            ])
        })
        .collect::<Result<_>>()?;
    let width = |row: &[Panel; 4]| row.iter().map(|p| p.size.x + GAP).sum::<u32>() + GAP;
    let size = UVec2::new(
        panels.iter().map(width).max().unwrap_or(GAP),
        panels.len() as u32 * (HEIGHT + GAP) + GAP,
    );
    let mut sheet = vec![Vec3::splat(SURROUND); (size.x * size.y) as usize];
    for (y, row) in panels.iter().enumerate() {
        let top = GAP + y as u32 * (HEIGHT + GAP);
        let mut left = GAP;
        for panel in row {
            let lines = panel.pixels.chunks(panel.size.x as usize);
            for (line, pixels) in lines.enumerate() {
                let start = ((top + line as u32) * size.x + left) as usize;
                sheet[start..start + pixels.len()].copy_from_slice(pixels);
            }
            left += panel.size.x + GAP;
        }
    }
    let codes: Vec<[u8; 3]> = sheet
        .par_iter()
        .map(|colour| colour.to_array().map(linear_to_srgb8))
        .collect();
    png::write_rgb(file, size, codes.as_flattened())
}

/// The photograph around the ball.
fn probe(out: &Path, frame: i32) -> Result<Panel> {
    let file = frame_file(&out.join("film/capture"), "ball", frame, "exr");
    let photo = read_photo(&file, &Reading::default(), &mut Notes::default())?;
    let pixels: Vec<Vec3> = photo
        .pixels
        .iter()
        .map(|p| p.truncate() * EXPOSURE)
        .collect();
    let size = photo.size.as_dvec2();
    let (middle, reach) = match find(photo.size, &photo.pixels, None) {
        Ok(found) => (found.circle.centre, 1.04 * found.circle.radius),
        Err(_) => (0.5 * size, 0.5 * size.min_element()),
    };
    let reach = reach.min(0.5 * size.min_element());
    let corner = (middle - reach).clamp(glam::DVec2::ZERO, size - 2.0 * reach);
    let window = Window {
        origin: corner.to_array(),
        size: [2.0 * reach; 2],
    };
    Ok(Panel::fitted(photo.size, &pixels, window))
}

/// The light map.
fn map(out: &Path, frame: i32) -> Result<Panel> {
    let file = frame_file(&out.join("light"), "latlong", frame, "exr");
    let image = read_image(&file, &mut Notes::default())?;
    let pixels: Vec<Vec3> = image
        .texels
        .iter()
        .map(|p| p.truncate() * EXPOSURE)
        .collect();
    let size = image.header.size;
    Ok(Panel::fitted(size, &pixels, Window::whole(size)))
}

/// The objects and their shadow on grey ground, from the layers of the frame.
fn render(out: &Path, frame: i32) -> Result<Panel> {
    let file = frame_file(out, "frame", frame, "exr");
    let broken = |e: ::exr::error::Error| Error::input(&file, e).fix("remove it, and run again");
    let layer = read_first_flat_layer_from_file(&file)
        .map_err(broken)?
        .layer_data;
    let plane = |name: &str| -> Result<Vec<f32>> {
        let channel = layer.channel_data.list.iter().find(|c| c.name.eq(name));
        channel
            .map(|c| c.sample_data.values_as_f32().collect())
            .ok_or_else(|| {
                Error::input(&file, format!("it has no layer {name}"))
                    .fix("leave output.aovs as it is")
            })
    };
    let rgb = |layer: &str| -> Result<Vec<Vec3>> {
        let [r, g, b] = ["R", "G", "B"].map(|c| plane(&format!("{layer}.{c}")));
        let (r, g, b) = (r?, g?, b?);
        Ok((0..r.len()).map(|i| Vec3::new(r[i], g[i], b[i])).collect())
    };
    let (object, catcher, alpha) = (rgb("object")?, rgb("catcher")?, plane("object.A")?);
    let over = |i: usize| object[i] + catcher[i] * (GROUND * (1.0 - alpha[i]));
    let pixels: Vec<Vec3> = (0..object.len()).map(over).collect();
    let size = UVec2::new(layer.size.x() as u32, layer.size.y() as u32);
    Ok(Panel::fitted(size, &pixels, Window::whole(size)))
}

/// The frame as it is shown.
fn composite(out: &Path, frame: i32) -> Result<Panel> {
    let file = frame_file(out, "frame", frame, "png");
    let image = plate::read(&file, &Reading::default(), &mut Notes::default())?;
    let size = image.size;
    let pixels = image.colours.into_linear();
    Ok(Panel::fitted(size, &pixels, Window::whole(size)))
}
