//! Host file: curves over frames, as SVG inside a page. Colours of axes and text are the page's.

use crate::compare::statistics::Estimate;

/// Colours that are distinguished with any kind of colour vision (Okabe and Ito 2008), and on dark and light ground.
const COLOURS: [&str; 7] = [
    "#0072b2", "#e69f00", "#009e73", "#d55e00", "#cc79a7", "#56b4e9", "#999933",
];

const WIDTH: f64 = 640.0;
const HEIGHT: f64 = 300.0;
const LEFT: f64 = 64.0;
const RIGHT: f64 = 16.0;
const TOP: f64 = 12.0;
const BOTTOM: f64 = 44.0;

/// The colour of a contestant.
#[must_use]
pub fn colour(index: usize) -> &'static str {
    COLOURS[index % COLOURS.len()]
}

/// A contestant's values at frames.
pub struct Curve<'a> {
    /// Its name.
    pub name: &'a str,
    /// Frames and values.
    pub points: Vec<(i32, Estimate)>,
}

/// Curves with bars of one standard error each way, on a logarithmic scale. Empty if there is no value above 0.
#[must_use]
pub fn chart(title: &str, unit: &str, curves: &[Curve<'_>]) -> String {
    let Some(axes) = Axes::of(curves) else {
        return String::new();
    };
    let mut svg = format!(
        "<svg viewBox=\"0 0 {WIDTH} {HEIGHT}\" role=\"img\" aria-label=\"{}\">\n",
        escape(title)
    );
    axes.draw(unit, &mut svg);
    for (i, curve) in curves.iter().enumerate() {
        // Side by side where there is no line to follow.
        let aside = (i as f64 - 0.5 * (curves.len() as f64 - 1.0))
            * if axes.frames.len() == 1 { 14.0 } else { 3.0 };
        axes.draw_curve(curve, colour(i), aside, &mut svg);
    }
    svg.push_str("</svg>\n");
    svg
}

/// Where frames and values lie in the drawing.
struct Axes {
    /// The frames, in order.
    frames: Vec<i32>,
    /// Decimal logarithms of the least and the largest value.
    range: [f64; 2],
}

impl Axes {
    /// Those that hold all points; `None` if there is no value above 0.
    fn of(curves: &[Curve<'_>]) -> Option<Self> {
        let points = || curves.iter().flat_map(|c| &c.points);
        let values = || points().map(|p| p.1.value);
        let positive = || values().filter(|v| *v > 0.0 && v.is_finite());
        let (least, most) = (positive().reduce(f64::min)?, positive().reduce(f64::max)?);
        let mut frames: Vec<i32> = points().map(|p| p.0).collect();
        frames.sort_unstable();
        frames.dedup();
        Some(Self {
            frames,
            range: [(least * 0.8).log10(), (most * 1.25).log10()],
        })
    }

    fn x(&self, frame: i32) -> f64 {
        let [first, last] = [self.frames[0], self.frames[self.frames.len() - 1]].map(f64::from);
        let span = (last - first).max(1.0);
        let offset = if last > first { 0.0 } else { 0.5 };
        LEFT + 10.0 + (WIDTH - LEFT - RIGHT - 20.0) * ((f64::from(frame) - first) / span + offset)
    }

    fn y(&self, value: f64) -> f64 {
        let [low, high] = self.range;
        let share = (value.max(1e-300).log10() - low) / (high - low);
        HEIGHT - BOTTOM - (HEIGHT - TOP - BOTTOM) * share.clamp(0.0, 1.0)
    }

    /// Lines at round values, the numbers of frames, and what the axes show.
    fn draw(&self, unit: &str, svg: &mut String) {
        let bottom = HEIGHT - BOTTOM;
        for tick in ticks(self.range[0], self.range[1]) {
            let at = self.y(tick);
            svg.push_str(&format!(
                "<line class=\"grid\" x1=\"{LEFT}\" x2=\"{:.1}\" y1=\"{at:.1}\" y2=\"{at:.1}\"/>\
                 <text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"end\">{}</text>\n",
                WIDTH - RIGHT,
                LEFT - 6.0,
                at + 4.0,
                plain(tick)
            ));
        }
        let every = self.frames.len().div_ceil(12);
        for &frame in self.frames.iter().step_by(every) {
            svg.push_str(&format!(
                "<text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"middle\">{frame}</text>\n",
                self.x(frame),
                bottom + 16.0
            ));
        }
        svg.push_str(&format!(
            "<text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"middle\">frame</text>\
             <text transform=\"translate(13 {:.1}) rotate(-90)\" text-anchor=\"middle\">{}</text>\
             <path class=\"axis\" d=\"M{LEFT} {TOP}V{bottom}H{}\"/>\n",
            0.5 * (LEFT + WIDTH - RIGHT),
            HEIGHT - 8.0,
            0.5 * (TOP + bottom),
            escape(unit),
            WIDTH - RIGHT
        ));
    }

    /// A line through a curve's points, moved `aside`, with their bars.
    fn draw_curve(&self, curve: &Curve<'_>, colour: &str, aside: f64, svg: &mut String) {
        let place = |p: &(i32, Estimate)| (self.x(p.0) + aside, self.y(p.1.value));
        let line: Vec<String> = curve
            .points
            .iter()
            .map(|p| {
                let (px, py) = place(p);
                format!("{px:.1},{py:.1}")
            })
            .collect();
        svg.push_str(&format!(
            "<g stroke=\"{colour}\" fill=\"{colour}\"><title>{}</title><polyline fill=\"none\" points=\"{}\"/>",
            escape(curve.name),
            line.join(" ")
        ));
        for point in &curve.points {
            let (px, py) = place(point);
            let error = point.1.error.unwrap_or(0.0);
            svg.push_str(&format!(
                "<line x1=\"{px:.1}\" x2=\"{px:.1}\" y1=\"{:.1}\" y2=\"{:.1}\"/><circle cx=\"{px:.1}\" cy=\"{py:.1}\" r=\"2.6\"/>",
                self.y(point.1.value + error),
                self.y(point.1.value - error)
            ));
        }
        svg.push_str("</g>\n");
    }
}

/// 1, 2 and 5 times powers of ten, fewer where that would be many, and more where it would be few.
fn ticks(low: f64, high: f64) -> Vec<f64> {
    let steps: &[f64] = if high - low > 2.5 {
        &[1.0]
    } else {
        &[1.0, 2.0, 5.0]
    };
    let decades = low.floor() as i32..=high.ceil() as i32;
    decades
        .flat_map(|d| steps.iter().map(move |s| s * 10f64.powi(d)))
        .filter(|t| (low..=high).contains(&t.log10()))
        .collect()
}

/// A tick without needless digits.
fn plain(value: f64) -> String {
    match value {
        v if v >= 1e-4 && v < 1e5 => format!("{}", (v * 1e6).round() / 1e6),
        v => format!("{v:e}"),
    }
}

/// Text as HTML and SVG have it.
#[must_use]
pub fn escape(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            '\'' => escaped.push_str("&#39;"),
            c => escaped.push(c),
        }
    }
    escaped
}
