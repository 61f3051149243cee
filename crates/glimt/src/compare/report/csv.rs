//! Host file: the figures as a table for other programs: a row for each contestant and frame, and one for all frames.

use crate::compare::measures::Score;
use crate::compare::outcome::{Figures, Outcome};
use crate::compare::statistics::Estimate;

const HEAD: &str = "contestant,frame,samples,time_ms_median,time_ms_lower_quartile,time_ms_upper_quartile,\
time_holds,relative_rmse,relative_rmse_se,bias,bias_se,bias_p,tiles,tiles_beyond,tile_largest_z,tile_p,\
flicker,flicker_se,flip,flip_se,rays,pilot_share,efficiency,efficiency_se,reference_noise,keys";

/// Comma-separated values (RFC 4180). What is not known is empty.
#[must_use]
pub fn table(outcome: &Outcome) -> String {
    let mut text = format!("{HEAD}\n");
    for figures in &outcome.contestants {
        text.push_str(&row(
            figures,
            "all",
            &figures.overall,
            Some(figures.efficiency),
            None,
        ));
        for (score, reference) in figures.frames.iter().zip(&outcome.references) {
            let frame = reference.frame.to_string();
            text.push_str(&row(figures, &frame, score, None, reference.noise));
        }
    }
    text
}

fn row(
    figures: &Figures,
    frame: &str,
    score: &Score,
    efficiency: Option<Estimate>,
    noise: Option<f64>,
) -> String {
    let number = |v: Option<f64>| {
        v.filter(|v| v.is_finite())
            .map_or(String::new(), |v| format!("{v:.6e}"))
    };
    let pair = |e: Option<Estimate>| [number(e.map(|e| e.value)), number(e.and_then(|e| e.error))];
    let ms = |seconds: f64| number(Some(seconds * 1e3));
    let local = score.local;
    let mut cells = vec![
        quoted(&figures.name),
        frame.to_owned(),
        quoted(&figures.samples),
        ms(figures.time.median),
        ms(figures.time.lower),
        ms(figures.time.upper),
        format!("{:?}", figures.hold).to_lowercase(),
    ];
    cells.extend(pair(Some(score.error)));
    cells.extend(pair(Some(score.bias.of_image)));
    cells.push(number(score.bias.p));
    cells.push(local.map_or(String::new(), |l| l.tiles.to_string()));
    cells.push(local.map_or(String::new(), |l| l.beyond.to_string()));
    cells.push(number(local.map(|l| l.largest)));
    cells.push(number(local.map(|l| l.p)));
    cells.extend(pair(score.flicker));
    cells.extend(pair(score.flip));
    cells.push(number(score.rays.map(|rays| rays.all)));
    cells.push(number(score.rays.map(|rays| rays.pilot_share())));
    cells.extend(pair(efficiency));
    cells.push(number(noise));
    cells.push(quoted(&figures.keys.join(" ")));
    cells.join(",") + "\n"
}

fn quoted(text: &str) -> String {
    match text.contains([',', '"', '\n', '\r']) {
        true => format!("\"{}\"", text.replace('"', "\"\"")),
        false => text.to_owned(),
    }
}
