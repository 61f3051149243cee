//! Host file: the report for people: one page that needs nothing but itself, in light and in dark.

use super::Pictures;
use super::picture::viridis;
use super::svg::{Curve, chart, colour, escape};
use crate::compare::fit::Hold;
use crate::compare::flip;
use crate::compare::measures::{DEFINITIONS, LocalBias, Score};
use crate::compare::outcome::{Figures, Mode, Outcome, milliseconds, percent, plus_minus};
use crate::compare::shadow_rays::ShadowRays;
use crate::compare::statistics::Estimate;
use crate::output::SOFTWARE;

const STYLE: &str = "\
:root { color-scheme: light dark; --ground: #fff; --text: #1b1b1f; --faint: #5c5c66; --line: #d5d5dc; --mark: #f3f3f6; --bad: #a8200d; }
@media (prefers-color-scheme: dark) { :root { --ground: #17171b; --text: #e6e6ea; --faint: #a2a2ad; --line: #3a3a43; --mark: #212127; --bad: #ff8a70; } }
body { background: var(--ground); color: var(--text); font: 15px/1.5 system-ui, sans-serif; max-width: 78rem; margin: 2rem auto; padding: 0 1.2rem; }
h1 { font-size: 1.5rem; } h2 { font-size: 1.15rem; margin-top: 2.2rem; }
.verdict { font-size: 1.05rem; border-left: 4px solid #2c728e; padding: .5rem 1rem; background: var(--mark); }
.verdict.bad { border-color: var(--bad); color: inherit; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; font-size: .85rem; }
th, td { text-align: right; padding: .25rem .5rem; border-bottom: 1px solid var(--line); white-space: nowrap; }
th:first-child, td:first-child, .left { text-align: left; }
thead th { color: var(--faint); font-weight: 600; }
td .bad { color: var(--bad); } .faint { color: var(--faint); }
.key { display: inline-block; width: .8em; height: .8em; border-radius: 50%; margin-right: .4em; }
svg { width: 100%; max-width: 640px; } svg text { fill: var(--faint); font-size: 12px; stroke: none; }
.grid { stroke: var(--line); } .axis { stroke: var(--faint); fill: none; } polyline { stroke-width: 1.6; }
.charts { display: flex; flex-wrap: wrap; gap: 1rem; } .charts > figure { flex: 1 1 26rem; }
figure { margin: 0; } figcaption { color: var(--faint); font-size: .85rem; }
.strip { display: grid; grid-template-columns: repeat(auto-fill, minmax(15rem, 1fr)); gap: .8rem; margin-top: .6rem; }
.strip img { width: 100%; height: auto; display: block; image-rendering: pixelated; }
.scale { height: .9rem; max-width: 24rem; margin-top: .8rem; } .ends { display: flex; justify-content: space-between; max-width: 24rem; }
code { font-size: .85rem; overflow-wrap: anywhere; } dt { font-weight: 600; margin-top: .6rem; } dd { margin: 0; }
";

/// The page.
#[must_use]
pub fn page(outcome: &Outcome, pictures: &[Pictures]) -> String {
    let about = &outcome.about;
    let good = outcome.reference_criterion == Some(true)
        && outcome.time_criterion != Some(false)
        && outcome.biased().is_empty();
    let mut body = format!(
        "<p class=\"verdict{}\">{}</p>\n<h1>Estimators compared on {}</h1>\n<p>{}</p>\n",
        if good { "" } else { " bad" },
        escape(&outcome.verdict),
        escape(&about.shot),
        escape(&introduction(outcome))
    );
    for remark in &about.remarks {
        body.push_str(&format!("<p class=\"faint\">{}</p>\n", escape(remark)));
    }
    body.push_str(&summary(outcome));
    body.push_str(&curves(outcome));
    for pictures in pictures {
        body.push_str(&strip(outcome, pictures));
    }
    body.push_str(&times(outcome));
    body.push_str(&frames(outcome));
    body.push_str(&references(outcome));
    body.push_str(&again(outcome));
    body.push_str("<h2>Definitions</h2>\n<dl>\n");
    for (name, text) in DEFINITIONS {
        let text: Vec<&str> = text.split_whitespace().collect();
        body.push_str(&format!(
            "<dt>{name}</dt><dd>{}</dd>\n",
            escape(&text.join(" "))
        ));
    }
    body.push_str("</dl>\n");
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"generator\" content=\"{SOFTWARE}\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <title>glimt compare: {}</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n{body}</body>\n</html>\n",
        escape(&about.shot)
    )
}

fn introduction(outcome: &Outcome) -> String {
    let about = &outcome.about;
    let seeds = match about.seeds[..] {
        [first, .., last] => format!("seeds {first} to {last}"),
        _ => "one seed".to_owned(),
    };
    let frames: Vec<String> = about.frames.iter().map(i32::to_string).collect();
    let how = match (outcome.mode, outcome.budget) {
        (Mode::EqualTime, Some(budget)) => {
            format!("at equal time, {} a frame", milliseconds(budget))
        }
        _ => "at the counts of samples that are given".to_owned(),
    };
    format!(
        "{} contestants {how}; {} × {} pixels, filter “{}” for all; frames {}; {} independent scramblings ({seeds}). \
         Figures are means ± one standard error over the scramblings.",
        outcome.contestants.len(),
        about.size[0],
        about.size[1],
        about.filter,
        frames.join(", "),
        about.seeds.len()
    )
}

fn named(index: usize, figures: &Figures) -> String {
    format!(
        "<span class=\"key\" style=\"background:{}\"></span>{}",
        colour(index),
        escape(&figures.name)
    )
}

fn optional(estimate: Option<Estimate>) -> String {
    estimate.map_or("–".to_owned(), plus_minus)
}

fn probability(p: Option<f64>) -> String {
    match p {
        Some(p) if p < 1e-4 => format!("<span class=\"bad\">{p:.0e}</span>"),
        Some(p) if p < 0.01 => format!("<span class=\"bad\">{p:.4}</span>"),
        Some(p) => format!("{p:.3}"),
        None => "–".to_owned(),
    }
}

fn local(local: Option<LocalBias>) -> [String; 2] {
    match local {
        Some(l) => [
            format!(
                "{:.1} % of {}",
                100.0 * l.beyond as f64 / l.tiles.max(1) as f64,
                l.tiles
            ),
            format!("{:.1} (p {})", l.largest, probability(Some(l.p))),
        ],
        None => ["–".to_owned(), "–".to_owned()],
    }
}

/// A table; cells are HTML already.
fn table(head: &[&str], rows: &[Vec<String>]) -> String {
    let cells = |tag: &str, row: &[String]| {
        let cells = row.iter().map(|c| format!("<{tag}>{c}</{tag}>"));
        format!("<tr>{}</tr>\n", cells.collect::<String>())
    };
    let head: Vec<String> = head.iter().map(|h| escape(h)).collect();
    let rows: String = rows.iter().map(|r| cells("td", r)).collect();
    format!(
        "<div class=\"wide\"><table>\n<thead>{}</thead>\n<tbody>\n{rows}</tbody></table></div>\n",
        cells("th", &head)
    )
}

fn scores(score: &Score) -> Vec<String> {
    let [share, largest] = local(score.local);
    let mut cells = vec![
        plus_minus(score.error),
        percent(score.bias.of_image),
        probability(score.bias.p),
        share,
        largest,
        optional(score.flicker),
    ];
    let of_rays = |value: fn(ShadowRays) -> String| score.rays.map_or("–".to_owned(), value);
    cells.push(of_rays(|rays| format!("{:.1}", rays.all)));
    cells.push(of_rays(|rays| {
        format!("{:.0} %", 100.0 * rays.pilot_share())
    }));
    if flip::IS_THERE {
        cells.push(optional(score.flip));
    }
    cells
}

const SCORES: [&str; 9] = [
    "relative RMSE",
    "bias",
    "p",
    "tiles |z| > 2.58",
    "largest |z|",
    "flicker",
    "rays",
    "pilots",
    "FLIP",
];

fn score_names() -> &'static [&'static str] {
    &SCORES[..SCORES.len() - usize::from(!flip::IS_THERE)]
}

fn summary(outcome: &Outcome) -> String {
    let base = outcome.contestants.iter().find(|c| c.is_baseline);
    let base = base.map_or("", |b| b.name.as_str());
    let efficiency = format!("efficiency (× {base})");
    let mut head = vec!["contestant", "samples", "ms a frame", efficiency.as_str()];
    head.extend(score_names());
    let rows: Vec<Vec<String>> = outcome
        .contestants
        .iter()
        .enumerate()
        .map(|(i, c)| {
            let mut row = vec![
                named(i, c),
                escape(&c.samples),
                milliseconds(c.time.median).replace(" ms", ""),
                match c.is_baseline {
                    true => "1".to_owned(),
                    false => plus_minus(c.efficiency),
                },
            ];
            row.extend(scores(&c.overall));
            row
        })
        .collect();
    format!("<h2>All frames</h2>\n{}", table(&head, &rows))
}

/// Each measured frame; nothing where there is one alone.
fn by_frame(outcome: &Outcome) -> String {
    if outcome.about.frames.len() < 2 {
        return String::new();
    }
    let mut head = vec!["frame", "contestant"];
    head.extend(score_names());
    let mut rows = Vec::new();
    for (place, frame) in outcome.about.frames.iter().enumerate() {
        for (i, c) in outcome.contestants.iter().enumerate() {
            let mut row = vec![frame.to_string(), named(i, c)];
            row.extend(scores(&c.frames[place]));
            rows.push(row);
        }
    }
    let table = table(&head, &rows);
    format!("<details><summary>Figures of each frame</summary>\n{table}</details>\n")
}

fn curves(outcome: &Outcome) -> String {
    let chart_of = |title: &str, f: &dyn Fn(&Score) -> Option<Estimate>| {
        let curve = |c: &'_ Figures| -> Vec<(i32, Estimate)> {
            let pairs = c.frames.iter().zip(&outcome.about.frames);
            pairs
                .filter_map(|(s, frame)| Some((*frame, f(s)?)))
                .collect()
        };
        let all: Vec<Curve<'_>> = outcome
            .contestants
            .iter()
            .map(|c| Curve {
                name: &c.name,
                points: curve(c),
            })
            .collect();
        let svg = chart(title, title, &all);
        match svg.is_empty() {
            true => svg,
            false => format!(
                "<figure>{svg}<figcaption>{title} by frame, ± one standard error</figcaption></figure>\n"
            ),
        }
    };
    let keys: Vec<String> = outcome
        .contestants
        .iter()
        .enumerate()
        .map(|(i, c)| named(i, c))
        .collect();
    format!(
        "<h2>Over the frames</h2>\n<p>{}</p>\n<div class=\"charts\">\n{}{}{}</div>\n",
        keys.join(" &emsp; "),
        chart_of("relative RMSE", &|s| Some(s.error)),
        chart_of("flicker", &|s| s.flicker),
        chart_of("FLIP", &|s| s.flip)
    ) + &by_frame(outcome)
}

fn strip(outcome: &Outcome, pictures: &Pictures) -> String {
    let figure = |url: &str, caption: &str| {
        format!(
            "<figure><img src=\"{url}\" width=\"{}\" height=\"{}\" alt=\"{caption}\"><figcaption>{caption}</figcaption></figure>\n",
            pictures.size[0], pictures.size[1]
        )
    };
    let place = outcome
        .about
        .frames
        .iter()
        .position(|f| *f == pictures.frame);
    let mut images = figure(&pictures.reference, "reference");
    let mut maps = String::new();
    for (c, [image, map]) in outcome.contestants.iter().zip(&pictures.contestants) {
        let error = place.map_or(String::new(), |i| plus_minus(c.frames[i].error));
        images.push_str(&figure(image, &format!("{}: one image", escape(&c.name))));
        maps.push_str(&figure(map, &format!("{}: {error}", escape(&c.name))));
    }
    let stops: Vec<String> = (0..=8)
        .map(|i| {
            let [r, g, b] = viridis(f64::from(i) / 8.0);
            format!("rgb({r},{g},{b})")
        })
        .collect();
    let middle = (pictures.scale.low * pictures.scale.high).sqrt();
    format!(
        "<h2>Frame {}</h2>\n<p class=\"faint\">{}, as displayed, over black</p>\n<div class=\"strip\">{images}</div>\n\
         <p class=\"faint\">Error of each pixel: √ of the mean of (x − r)² over seeds and channels, over Ȳ, on a logarithmic scale; black: not \
         measured</p>\n<div class=\"strip\">{maps}</div>\n\
         <div class=\"scale\" style=\"background:linear-gradient(to right,{})\"></div>\
         <div class=\"ends faint\"><span>≤ {:.2e}</span><span>{middle:.2e}</span><span>≥ {:.2e}</span></div>\n",
        pictures.frame,
        escape(&pictures.caption),
        stops.join(","),
        pictures.scale.low,
        pictures.scale.high
    )
}

fn times(outcome: &Outcome) -> String {
    let mut names: Vec<&str> = Vec::new();
    for phase in outcome.contestants.iter().flat_map(|c| &c.phases) {
        if !names.contains(&phase.name.as_str()) {
            names.push(&phase.name);
        }
    }
    let mut head = vec![
        "contestant",
        "samples",
        "median",
        "quartiles",
        "rounds",
        "budget",
    ];
    head.extend(&names);
    let rows: Vec<Vec<String>> = outcome
        .contestants
        .iter()
        .enumerate()
        .map(|(i, c)| {
            let budget = match c.hold {
                Hold::Free => "–".to_owned(),
                Hold::Held => "within 5 %".to_owned(),
                Hold::Granular => "<span class=\"bad\">nearest whole count</span>".to_owned(),
                Hold::Fixed => "<span class=\"bad\">no count to change</span>".to_owned(),
                Hold::Missed => "<span class=\"bad\">missed</span>".to_owned(),
            };
            let mut row = vec![
                named(i, c),
                escape(&c.samples),
                milliseconds(c.time.median),
                format!(
                    "{} to {}",
                    milliseconds(c.time.lower),
                    milliseconds(c.time.upper)
                ),
                c.times.len().to_string(),
                budget,
            ];
            row.extend(names.iter().map(|name| {
                let phase = c.phases.iter().find(|p| p.name == *name);
                phase.map_or("–".to_owned(), |p| milliseconds(p.seconds.median))
            }));
            row
        })
        .collect();
    let without = match names.is_empty() {
        true => "<p class=\"faint\">This device does not tell phases apart.</p>\n",
        false => "",
    };
    format!("<h2>Time of a frame</h2>\n{}{without}", table(&head, &rows))
}

fn frames(outcome: &Outcome) -> String {
    let mut head = vec!["contestant", "frame"];
    head.extend(score_names());
    let mut rows = Vec::new();
    for (i, c) in outcome.contestants.iter().enumerate() {
        for (score, frame) in c.frames.iter().zip(&outcome.about.frames) {
            let mut row = vec![named(i, c), frame.to_string()];
            row.extend(scores(score));
            rows.push(row);
        }
    }
    format!("<h2>Frame by frame</h2>\n{}", table(&head, &rows))
}

fn references(outcome: &Outcome) -> String {
    let head = [
        "frame",
        "scramblings",
        "noise",
        "over the smallest error",
        "pixels",
        "mean luminance",
    ];
    let rows: Vec<Vec<String>> = outcome
        .references
        .iter()
        .map(|r| {
            let number = |v: Option<f64>| v.map_or("–".to_owned(), |v| format!("{v:.2e}"));
            vec![
                r.frame.to_string(),
                r.scramblings.to_string(),
                number(r.noise),
                r.share_of_error
                    .map_or("–".to_owned(), |s| format!("{s:.3}")),
                r.pixels.to_string(),
                format!("{:.4}", r.mean_luminance),
            ]
        })
        .collect();
    format!(
        "<h2>Reference</h2>\n<p>{}</p>\n{}",
        escape(&outcome.about.reference),
        table(&head, &rows)
    )
}

fn again(outcome: &Outcome) -> String {
    let about = &outcome.about;
    let seeds: Vec<String> = about.seeds.iter().map(u32::to_string).collect();
    let mut rows = vec![
        (
            "command",
            format!("<code>{}</code>", escape(&about.command)),
        ),
        ("program", escape(&about.software)),
        ("machine", escape(&about.machine)),
        ("device", escape(&about.device)),
        ("seeds", seeds.join(" ")),
    ];
    for c in &outcome.contestants {
        rows.push((
            "contestant",
            format!(
                "{}: <code>{}</code>",
                escape(&c.name),
                escape(&c.keys.join(" "))
            ),
        ));
    }
    let rows: String = rows
        .iter()
        .map(|(name, value)| format!("<dt>{name}</dt><dd>{value}</dd>\n"))
        .collect();
    format!("<h2>To do it again</h2>\n<dl>\n{rows}</dl>\n")
}
