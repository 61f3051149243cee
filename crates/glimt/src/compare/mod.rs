//! Host file: `glimt compare`: estimators side by side on one shot, in figures that can be cited and made again.
//!
//! [`contestants`] says who takes part, [`fit`] finds the counts that make them equally long, [`mod@reference`] renders what they are
//! held against, [`trials`] renders them, [`measures`] defines the figures, [`statistics`] their spreads, and [`report`] writes all
//! of it. What is rendered is kept below the outputs as [`moments`]; a run that was stopped continues there.

mod comparison;
pub mod contestants;
pub mod count;
mod course;
pub mod fit;
pub mod flip;
pub mod lineage;
mod machine;
pub mod measures;
pub mod moments;
pub mod outcome;
pub mod progress;
pub mod reference;
pub mod report;
pub mod shadow_rays;
pub mod statistics;
mod times;
pub mod trial_renderer;
pub mod trials;

pub use course::Findings;

use crate::cli::{CompareFlags, RenderFlags};
use crate::error::Result;
use crate::output::atomic::{self, Folder};
use crate::output::target::Guard;
use crate::output::{SOFTWARE, Stamp, exr};
use crate::printable::path_in_line;
use crate::report::{Reporter, shown};
use comparison::{Comparison, common_filter, filter_name};
use contestants::{Contestant, Field};
use course::Course;
use outcome::About;
use serde_json::json;
use std::path::{Path, PathBuf};
use std::time::Instant;
use times::Times;

/// Compares what the flags say and writes the report.
///
/// # Errors
/// The flags, the shot or a contestant is wrong, or something cannot be rendered or written. What is rendered stays.
pub fn run(
    file: &Path,
    flags: &RenderFlags,
    compare: &CompareFlags,
    reporter: &Reporter,
) -> Result<()> {
    let began = Instant::now();
    let base = file.parent().unwrap_or(Path::new(""));
    let out = flags.out.clone().unwrap_or_else(|| base.join("compare"));
    let field = Field {
        file,
        flags,
        filter: common_filter(file, flags)?,
    };
    let mut remarks = Vec::new();
    let contestants = contestants::gather(&field, compare, &mut remarks)?;
    for remark in &remarks {
        reporter.remark(remark);
    }
    let _folder = Folder::claim(&out, flags.write.share)?;
    let mut comparison = Comparison::open(&field, compare, &trials::cache(&out), reporter)?;
    comparison.check(&contestants)?;
    for extension in report::EXTENSIONS {
        let file = out.join(format!("compare.{extension}"));
        comparison.plan.guard.target(&file)?;
    }
    let names: Vec<String> = contestants.iter().map(|c| c.name.clone()).collect();
    let frames = comparison.plan.measured.clone();
    reporter.start_comparing(&names, frames.len(), &out, &comparison.renderer.device());

    let times = Times::measure(&mut comparison, &contestants)?;
    let contestants: Vec<Contestant> = contestants
        .iter()
        .zip(&times.fitted)
        .map(|(c, fitted)| field.with_count(c, fitted.count))
        .collect::<Result<_>>()?;
    let about = about(&comparison, &contestants[0], remarks);
    let (findings, comparison) = Course::new(comparison, contestants, times, about).run()?;

    let written = report::write(
        &out,
        &comparison.plan.guard,
        &findings,
        &comparison.renderer,
    )?;
    if compare.keep {
        keep(&out, &comparison.plan.guard, &findings, &frames)?;
    }
    let outcome = &findings.outcome;
    let summary = json!({
        "verdict": outcome.verdict, "reference_criterion": outcome.reference_criterion,
        "time_criterion": outcome.time_criterion, "out": shown(&out), "files": written.iter().map(|file| shown(file)).collect::<Vec<_>>(),
        "seconds": began.elapsed().as_secs_f64(),
    });
    let text = format!(
        "{}\n{}",
        report::text::table(outcome),
        path_in_line(&written[0])
    );
    reporter.finish(summary, &text);
    Ok(())
}

/// The run, but for how its reference is made. The seeds are those of `first`.
fn about(comparison: &Comparison<'_>, first: &Contestant, remarks: Vec<String>) -> About {
    let Comparison {
        field,
        plan,
        renderer,
        ..
    } = comparison;
    About {
        shot: field.file.display().to_string(),
        command: machine::command_line(),
        software: SOFTWARE.to_owned(),
        machine: machine::description(),
        device: renderer.device(),
        size: renderer.size().to_array(),
        filter: filter_name(field.filter).to_owned(),
        frames: plan.measured.clone(),
        seeds: (0..plan.seeds).map(|k| plan.seed(first, k)).collect(),
        reference: String::new(),
        remarks,
    }
}

/// Writes means and references as EXR.
fn keep(out: &Path, guard: &Guard, findings: &Findings, frames: &[i32]) -> Result<()> {
    let first = findings.contestants.first();
    let picture = first.map_or_else(exr::Picture::default, |contestant| exr::Picture {
        primaries: contestant.shot.image.primaries.primaries(),
        pixel_aspect: contestant.shot.image.pixel_aspect,
    });
    let write = |folder: PathBuf, frame: i32, moments: &moments::Moments| {
        atomic::prepare_folder(&folder)?;
        let stamp = Stamp {
            hash: String::new(),
            frame,
        };
        let file = guard.target(&folder.join(format!("frame.{frame:04}.exr")))?;
        exr::write(
            &file,
            moments.size,
            &moments.mean,
            exr::Layers {
                picture,
                ..exr::Layers::default()
            },
            &stamp,
        )
    };
    for reference in &findings.references {
        write(out.join("reference"), reference.frame, &reference.moments)?;
    }
    for (contestant, trials) in findings.contestants.iter().zip(&findings.trials) {
        for (trial, &frame) in trials.iter().zip(frames) {
            write(
                out.join("mean").join(contestant.slug()),
                frame,
                &trial.moments,
            )?;
        }
    }
    Ok(())
}
