//! Host file: what a comparison found, written: for programs, for tables, for people.

pub mod csv;
pub mod html;
pub mod picture;
pub mod svg;
pub mod text;

use super::contestants::Contestant;
use super::course::Findings;
use super::measures::error_map;
use super::reference::Reference;
use super::trial_renderer::TrialRenderer;
use super::trials::Trial;
use crate::error::{Error, Result};
use crate::output::target::Guard;
use crate::output::write_text;
use picture::{Crop, Scale};
use std::path::{Path, PathBuf};

/// Most frames that are shown in pictures.
const SHOWN: usize = 4;

/// Pictures of a frame, as data URLs.
#[derive(Clone, Debug)]
pub struct Pictures {
    /// The frame.
    pub frame: i32,
    /// The reference.
    pub reference: String,
    /// Of each contestant: one image, and the map of its error.
    pub contestants: Vec<[String; 2]>,
    /// Width and height of each.
    pub size: [u32; 2],
    /// What part of the image it is.
    pub caption: String,
    /// What the colours of the maps mean.
    pub scale: Scale,
}

/// Of the files of a report, which are called compare.
pub const EXTENSIONS: [&str; 3] = ["html", "json", "csv"];

/// Writes compare.html, compare.json and compare.csv; says where they are.
///
/// # Errors
/// One cannot be written.
pub fn write(
    out: &Path,
    guard: &Guard,
    findings: &Findings,
    renderer: &TrialRenderer<'_>,
) -> Result<Vec<PathBuf>> {
    let Findings {
        outcome,
        contestants,
        trials,
        ..
    } = findings;
    let is_measured = |r: &&Reference| outcome.about.frames.contains(&r.frame);
    let references: Vec<&Reference> = findings.references.iter().filter(is_measured).collect();
    let mut pictures = Vec::new();
    let shown = references.len().min(SHOWN);
    for k in 0..shown {
        let i = (k + 1) * references.len() / shown - 1;
        let of_frame: Vec<&Trial> = trials.iter().map(|t| &t[i]).collect();
        pictures.push(draw(contestants, references[i], &of_frame, renderer)?);
    }
    let [html, json, csv] = EXTENSIONS.map(|e| out.join(format!("compare.{e}")));
    let value = serde_json::to_string_pretty(outcome).map_err(|e| Error::output(&json, e))?;
    write_text(&guard.target(&json)?, &(value + "\n"))?;
    write_text(&guard.target(&csv)?, &csv::table(outcome))?;
    write_text(&guard.target(&html)?, &html::page(outcome, &pictures))?;
    Ok(vec![html, json, csv])
}

fn draw(
    contestants: &[Contestant],
    reference: &Reference,
    trials: &[&Trial],
    renderer: &TrialRenderer<'_>,
) -> Result<Pictures> {
    let size = renderer.size();
    let maps: Vec<Vec<f64>> = trials
        .iter()
        .map(|t| error_map(&t.moments, reference))
        .collect();
    let crop = Crop::of(size, &maps);
    let scale = Scale::of(&maps, &reference.pixels);
    let covered = |p: usize| reference.moments.mean[p].w > 0.0;
    let png = |bytes: &[u8]| picture::data_url(crop.size(), bytes);
    let shown = renderer.display(&contestants[0].shot, &reference.moments.mean)?;
    let mut of_all = Vec::new();
    for ((contestant, trial), map) in contestants.iter().zip(trials).zip(&maps) {
        let sample = trial.sample.as_ref().unwrap_or(&trial.moments.mean);
        let picture = renderer.display(&contestant.shot, sample)?;
        let colours: Vec<u8> = map
            .iter()
            .enumerate()
            .flat_map(|(p, error)| match covered(p) {
                true => scale.colour(*error),
                false => [0; 3],
            })
            .collect();
        of_all.push([png(&crop.cut(&picture)), png(&crop.cut(&colours))]);
    }
    Ok(Pictures {
        frame: reference.frame,
        reference: png(&crop.cut(&shown)),
        contestants: of_all,
        size: crop.size().to_array(),
        caption: crop.describe(size),
        scale,
    })
}
