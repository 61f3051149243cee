//! Host file: the outcome in a terminal.

use crate::compare::outcome::{Outcome, milliseconds, percent, plus_minus};

/// The verdict, and a line for each contestant.
#[must_use]
pub fn table(outcome: &Outcome) -> String {
    let head = [
        "contestant",
        "samples",
        "time",
        "relative RMSE",
        "bias",
        "efficiency",
    ];
    let mut rows = vec![head.map(str::to_owned)];
    for c in &outcome.contestants {
        rows.push([
            c.name.clone(),
            c.samples.clone(),
            milliseconds(c.time.median),
            plus_minus(c.overall.error),
            percent(c.overall.bias.of_image),
            match c.is_baseline {
                true => "1 (baseline)".to_owned(),
                false => plus_minus(c.efficiency),
            },
        ]);
    }
    let width = |column: usize| {
        rows.iter()
            .map(|r| r[column].chars().count())
            .max()
            .unwrap_or(0)
    };
    let widths: Vec<usize> = (0..head.len()).map(width).collect();
    let line = |row: &[String; 6]| {
        let cells = row
            .iter()
            .zip(&widths)
            .map(|(cell, w)| format!("{cell:<w$}"));
        cells.collect::<Vec<_>>().join("  ").trim_end().to_owned()
    };
    let lines: Vec<String> = rows.iter().map(line).collect();
    format!("{}\n{}", outcome.verdict, lines.join("\n"))
}
