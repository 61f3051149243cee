//! Host file: the poses of a whole shot from what was seen in each frame: one radius, lost frames filled, drifts and
//! changed exposures said.

use crate::find::{FindError, Found};
use crate::levels::{Levels, median};
use crate::robust::{Line, running_median_residuals, spread};
use crate::roll::Roll;
use glam::DVec2;

/// What was seen in a frame.
#[derive(Clone, Debug, PartialEq)]
pub struct Observation {
    /// Number of the frame.
    pub frame: i32,
    /// The ball, or why there is none.
    pub found: Result<Found, FindError>,
    /// Its turn against the shot's reference frame.
    pub roll: Option<Roll>,
    /// Its brightness, by which a changed exposure is noticed.
    pub levels: Option<Levels>,
}

/// How [`stabilise`] judges.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// Least share of the frames in which the ball must be found, in [0, 1].
    pub least_share: f64,
    /// A radius that is off by less than this many pixels is never rejected.
    pub tolerance_px: f64,
    /// Drifts smaller than this many pixels over the shot are not reported, nor turns that move the rim by less.
    pub drift_px: f64,
    /// Drifts smaller than this many standard errors are not reported.
    pub drift_sigmas: f64,
    /// Longest run of frames that is taken for one of another exposure.
    pub longest_jump: usize,
    /// Whether frames were compared for their roll, so that it is worth saying where none was measured.
    pub rolls: bool,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            least_share: 0.3,
            tolerance_px: 1.0,
            drift_px: 0.25,
            drift_sigmas: 3.0,
            longest_jump: 12,
            rolls: true,
        }
    }
}

/// Where a frame's pose comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum State {
    /// Measured in the frame.
    Measured,
    /// There was no ball: interpolated between frames that have it, or that of the nearest at the ends.
    Interpolated,
    /// The measurement contradicts the other frames', and is replaced likewise.
    Rejected,
}

/// The ball in a frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TrackedPose {
    /// Number of the frame.
    pub frame: i32,
    /// Centre in pixels.
    pub centre: DVec2,
    /// Radius in pixels.
    pub radius: f64,
    /// Turn against the reference frame in radians, from +x towards +y.
    pub roll: f64,
    /// Where it comes from.
    pub state: State,
}

/// Something that should stay the same over a shot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// x of the centre, in pixels.
    CentreX,
    /// y of the centre, in pixels.
    CentreY,
    /// Radius, in pixels.
    Radius,
    /// Turn, in radians.
    Roll,
}

/// A straight change over the whole shot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drift {
    /// What drifts.
    pub quantity: Quantity,
    /// Change from the first frame to the last.
    pub total: f64,
    /// Standard error of that.
    pub sigma: f64,
}

/// Frames whose ball is brighter or darker than before and after, everywhere by one factor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ExposureJump {
    /// First frame.
    pub first: i32,
    /// Last frame.
    pub last: i32,
    /// Their brightness over that of their neighbours.
    pub factor: f64,
}

/// A stabilised shot.
#[derive(Clone, Debug, PartialEq)]
pub struct Tracked {
    /// A pose for each observation, in their order.
    pub poses: Vec<TrackedPose>,
    /// The radius in pixels, in the middle of the shot if it drifts.
    pub radius: f64,
    /// Its standard error.
    pub radius_sigma: f64,
    /// All four drifts; see [`Tracked::significant`].
    pub drifts: Vec<Drift>,
    /// Those that are reported.
    pub significant: Vec<Drift>,
    /// Frames without a ball.
    pub lost: Vec<i32>,
    /// Frames whose measurement was rejected.
    pub rejected: Vec<i32>,
    /// Frames of another exposure. Nothing is corrected.
    pub exposure_jumps: Vec<ExposureJump>,
    /// All that is worth saying, each in a line.
    pub notes: Vec<String>,
}

/// Why a shot has no poses.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum TrackError {
    /// There are no observations.
    #[error("there are no frames to stabilise")]
    NoFrames,
    /// The frames' numbers do not rise.
    #[error("frame {0} does not come after the one before it")]
    Order(i32),
    /// The ball was found in too few frames.
    #[error("the ball was found in {found} of {of} frames; in frame {frame}: {error}")]
    Lost {
        /// Frames in which it was found.
        found: usize,
        /// Frames there are.
        of: usize,
        /// The first in which it was not.
        frame: i32,
        /// What was wrong there.
        error: FindError,
    },
}

/// Makes poses of observations: of all frames of a shot, in their order.
///
/// The rig that holds ball and camera is rigid, so the radius is one number, a robust mean over the frames weighed by their
/// standard errors; if it drifts beyond doubt it follows the line of its drift. The centre of each frame is the measured one,
/// since the camera's jitter is real and unwarping with it is what removes it; likewise the roll. Measurements whose radius
/// or centre contradicts the other frames' are rejected. Frames without a measurement are interpolated. Drifts are fitted as
/// robust lines, their standard errors widened where neighbouring frames move together.
///
/// # Errors
/// See [`TrackError`].
///
/// ```
/// use glimt_ball::{Options, TrackError, stabilise};
/// assert_eq!(stabilise(&[], &Options::default()), Err(TrackError::NoFrames));
/// ```
pub fn stabilise(observations: &[Observation], options: &Options) -> Result<Tracked, TrackError> {
    check(observations, options)?;
    let time: Vec<f64> = observations.iter().map(|o| f64::from(o.frame)).collect();
    let mut states: Vec<State> = observations
        .iter()
        .map(|o| match o.found {
            Ok(_) => State::Measured,
            Err(_) => State::Interpolated,
        })
        .collect();
    reject(observations, &time, options, &mut states);
    let kept: Vec<usize> = (0..states.len())
        .filter(|&i| states[i] == State::Measured)
        .collect();
    let found = |i: usize| observations[i].found.as_ref().ok();
    let pick = |f: fn(&Found) -> f64| -> Vec<(f64, f64)> {
        kept.iter()
            .filter_map(|&i| Some((time[i], f(found(i)?))))
            .collect()
    };
    let sigmas: Vec<f64> = kept
        .iter()
        .filter_map(|&i| Some(found(i)?.sigma_radius_px))
        .collect();
    let xs = pick(|f| f.circle.centre.x);
    let ys = pick(|f| f.circle.centre.y);
    let radii = pick(|f| f.circle.radius);
    let rolls = rolls(observations, &time, &kept);

    let radius_line = Line::fit(&radii, &sigmas);
    let lines = [
        (Quantity::CentreX, Line::fit(&xs, &[])),
        (Quantity::CentreY, Line::fit(&ys, &[])),
        (Quantity::Radius, radius_line),
        (Quantity::Roll, Line::fit(&rolls, &[])),
    ];
    let drifts = drifts(&lines, time[time.len() - 1] - time[0]);
    let significant: Vec<Drift> = drifts
        .iter()
        .filter(|drift| is_significant(drift, radius_line.mean, options))
        .copied()
        .collect();
    let follows = significant.iter().any(|d| d.quantity == Quantity::Radius);
    let poses = (0..observations.len())
        .map(|i| TrackedPose {
            frame: observations[i].frame,
            centre: DVec2::new(between(&xs, time[i]), between(&ys, time[i])),
            radius: if follows {
                radius_line.at(time[i])
            } else {
                radius_line.mean
            },
            roll: between(&rolls, time[i]),
            state: states[i],
        })
        .collect();
    let frames = |state: State| -> Vec<i32> {
        (0..states.len())
            .filter(|&i| states[i] == state)
            .map(|i| observations[i].frame)
            .collect()
    };
    let mut tracked = Tracked {
        poses,
        radius: radius_line.mean,
        radius_sigma: radius_line.mean_sigma,
        drifts,
        significant,
        lost: frames(State::Interpolated),
        rejected: frames(State::Rejected),
        exposure_jumps: exposure_jumps(observations, options.longest_jump),
        notes: Vec::new(),
    };
    let no_roll = options.rolls && rolls.is_empty() && observations.len() > 1;
    tracked.notes = notes(&tracked, observations, no_roll);
    Ok(tracked)
}

/// What the lines change over a shot, which spans `span` frames.
fn drifts(lines: &[(Quantity, Line)], span: f64) -> Vec<Drift> {
    let drift = |(quantity, line): &(Quantity, Line)| Drift {
        quantity: *quantity,
        total: line.slope * span,
        sigma: line.slope_sigma * span,
    };
    lines.iter().map(drift).collect()
}

/// Whether a drift moves the outline of a ball of this radius far enough, and is beyond doubt.
fn is_significant(drift: &Drift, radius: f64, options: &Options) -> bool {
    let px = match drift.quantity {
        Quantity::Roll => drift.total * radius,
        _ => drift.total,
    };
    px.abs() > options.drift_px && drift.total.abs() > options.drift_sigmas * drift.sigma
}

fn check(observations: &[Observation], options: &Options) -> Result<(), TrackError> {
    if observations.is_empty() {
        return Err(TrackError::NoFrames);
    }
    if let Some(pair) = observations.windows(2).find(|p| p[1].frame <= p[0].frame) {
        return Err(TrackError::Order(pair[1].frame));
    }
    let found = observations.iter().filter(|o| o.found.is_ok()).count();
    let of = observations.len();
    let first = observations
        .iter()
        .find_map(|o| Some((o.frame, o.found.as_ref().err()?.clone())));
    match first {
        Some((frame, error)) if found == 0 || (found as f64) < options.least_share * of as f64 => {
            Err(TrackError::Lost {
                found,
                of,
                frame,
                error,
            })
        }
        _ => Ok(()),
    }
}

/// Marks measurements that cannot be of the ball that the other frames show.
fn reject(observations: &[Observation], time: &[f64], options: &Options, states: &mut [State]) {
    let list: Vec<(usize, Found)> = observations
        .iter()
        .enumerate()
        .filter_map(|(i, o)| Some((i, *o.found.as_ref().ok()?)))
        .collect();
    if list.len() < 4 {
        return;
    }
    let radii: Vec<(f64, f64)> = list
        .iter()
        .map(|(i, f)| (time[*i], f.circle.radius))
        .collect();
    let line = Line::fit(&radii, &[]);
    let off: Vec<f64> = radii.iter().map(|(t, r)| r - line.at(*t)).collect();
    let limit = (6.0 * spread(&off)).max(options.tolerance_px);
    let x: Vec<f64> = list.iter().map(|(_, f)| f.circle.centre.x).collect();
    let y: Vec<f64> = list.iter().map(|(_, f)| f.circle.centre.y).collect();
    let (dx, dy) = (running_median_residuals(&x), running_median_residuals(&y));
    let far = |d: &[f64]| (8.0 * spread(d)).max(4.0 * options.tolerance_px);
    let (limit_x, limit_y) = (far(&dx), far(&dy));
    for (k, (i, _)) in list.iter().enumerate() {
        if off[k].abs() > limit || dx[k].abs() > limit_x || dy[k].abs() > limit_y {
            states[*i] = State::Rejected;
        }
    }
}

/// The most that a camera on a rig rolls against the frames around, in radians. Clouds that drift and lamps that swing can
/// make another turn look likelier, and in several frames.
const WILDEST_ROLL: f64 = 0.035;

/// Times and rolls of the frames that have one, without jumps by whole turns or outliers.
fn rolls(observations: &[Observation], time: &[f64], kept: &[usize]) -> Vec<(f64, f64)> {
    use std::f64::consts::{PI, TAU};
    let mut list: Vec<(f64, f64)> = Vec::new();
    for &i in kept {
        let Some(roll) = observations[i].roll else {
            continue;
        };
        let before = list.last().map_or(0.0, |last| last.1);
        let turn = (roll.radians - before + PI).rem_euclid(TAU) - PI;
        list.push((time[i], before + turn));
    }
    let values: Vec<f64> = list.iter().map(|(_, roll)| *roll).collect();
    let off = running_median_residuals(&values);
    let limit = (8.0 * spread(&off)).clamp(0.01, WILDEST_ROLL);
    let mut keep = off.iter().map(|d| d.abs() <= limit);
    list.retain(|_| keep.next().unwrap_or(true));
    list
}

/// Linear interpolation in a list of rising times; the nearest value beyond its ends, 0 if it is empty.
fn between(list: &[(f64, f64)], t: f64) -> f64 {
    let after = list.partition_point(|(time, _)| *time < t);
    match (after.checked_sub(1).map(|i| list[i]), list.get(after)) {
        (None, None) => 0.0,
        (Some(a), None) => a.1,
        (None, Some(b)) => b.1,
        (Some(a), Some(b)) => a.1 + (b.1 - a.1) * (t - a.0) / (b.0 - a.0),
    }
}

/// Runs of frames that are brighter or darker by one factor than the frames on both of their sides.
fn exposure_jumps(observations: &[Observation], longest: usize) -> Vec<ExposureJump> {
    let list: Vec<(i32, &Levels)> = observations
        .iter()
        .filter_map(|o| Some((o.frame, o.levels.as_ref()?)))
        .collect();
    let change = |to: usize, from: usize| list[to].1.change_from(list[from].1);
    let mut jumps = Vec::new();
    let mut i = 1;
    while i < list.len() {
        let start = change(i, i - 1).filter(|c| c.is_step());
        let end = start.and_then(|start| {
            (i + 1..list.len().min(i + 1 + longest)).find(|&j| {
                let back = change(j, j - 1).is_some_and(|c| {
                    (c.stops + start.stops).abs() < 0.25 * start.stops.abs() && c.is_uniform()
                });
                back && change(j, i - 1).is_some_and(|c| c.stops.abs() < 0.3 * start.stops.abs())
            })
        });
        match (start, end) {
            (Some(start), Some(j)) => {
                let mut stops: Vec<f64> = (i..j)
                    .filter_map(|k| change(k, i - 1).map(|c| c.stops))
                    .collect();
                let middle = if stops.is_empty() {
                    start.stops
                } else {
                    median(&mut stops)
                };
                jumps.push(ExposureJump {
                    first: list[i].0,
                    last: list[j - 1].0,
                    factor: middle.exp2(),
                });
                i = j + 1;
            }
            _ => i += 1,
        }
    }
    jumps
}

fn notes(tracked: &Tracked, observations: &[Observation], no_roll: bool) -> Vec<String> {
    let mut notes = Vec::new();
    if !tracked.lost.is_empty() {
        let first = observations.iter().find_map(|o| o.found.as_ref().err());
        let why = first.map(|e| format!(" (first: {e})")).unwrap_or_default();
        notes.push(format!(
            "the ball was not found in {}{why}; its place there is interpolated",
            frames_in_words(&tracked.lost)
        ));
    }
    if !tracked.rejected.is_empty() {
        notes.push(format!(
            "what was found in {} contradicts the other frames; the ball's place there is interpolated",
            frames_in_words(&tracked.rejected)
        ));
    }
    for drift in &tracked.significant {
        let (name, scale, unit) = match drift.quantity {
            Quantity::CentreX => ("centre drifts along x", 1.0, "px"),
            Quantity::CentreY => ("centre drifts along y", 1.0, "px"),
            Quantity::Radius => ("radius drifts", 1.0, "px"),
            Quantity::Roll => ("image turns", 180.0 / std::f64::consts::PI, "degrees"),
        };
        notes.push(format!(
            "the ball's {name} by {:+.2} ± {:.2} {unit} over the shot: check the rig",
            drift.total * scale,
            drift.sigma * scale
        ));
    }
    for jump in &tracked.exposure_jumps {
        let list: Vec<i32> = observations
            .iter()
            .map(|o| o.frame)
            .filter(|f| (jump.first..=jump.last).contains(f))
            .collect();
        notes.push(format!(
            "{} of another exposure: {:.2} times as bright as before and after; nothing is corrected",
            frames_in_words(&list),
            jump.factor
        ));
    }
    if no_roll {
        notes.push("the ball shows too little to measure its roll; none is assumed".to_owned());
    }
    notes
}

/// `frame 7`, or `frames 3-5, 9`.
fn frames_in_words(frames: &[i32]) -> String {
    let mut runs: Vec<(i32, i32)> = Vec::new();
    for &frame in frames {
        match runs.last_mut() {
            Some(run) if run.1 + 1 == frame => run.1 = frame,
            _ => runs.push((frame, frame)),
        }
    }
    let words: Vec<String> = runs
        .iter()
        .map(|(a, b)| {
            if a == b {
                a.to_string()
            } else {
                format!("{a}-{b}")
            }
        })
        .collect();
    let noun = if frames.len() == 1 { "frame" } else { "frames" };
    format!("{noun} {}", words.join(", "))
}
