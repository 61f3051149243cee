//! Host file: coefficients as text.

use super::Projected;
use crate::cli::{ShConvention, ShFlags, Up};
use crate::output::SOFTWARE;
use crate::report::shown;
use glam::{Mat3, Vec3};
use glimt_sh::{
    coefficient_band, coefficient_count, coefficient_order, condon_shortley, filament_irradiance,
};
use serde_json::{Value, json};
use std::fmt::Write;

/// What the nine coefficients of engines multiply.
const POLYNOMIALS: [&str; 9] = ["1", "y", "z", "x", "xy", "yz", "3zz-1", "zx", "xx-yy"];

const ENGINE: &str = "irradiance/pi of the unit normal (x, y, z) is e0 + e1 y + e2 z + e3 x + e4 xy + e5 yz + e6 (3zz-1) + e7 zx \
     + e8 (xx-yy); the clamped cosine (A_l/pi = 1, 2/3, 1/4) and the basis's constants are in them: times the albedo it is what a \
     diffuse surface reflects, to be clipped at 0, since three bands ring";

/// What the numbers are, and how a map lies in their axes, in one line.
fn meaning(convention: ShConvention, axes: &Mat3) -> String {
    let numbers = match convention {
        ShConvention::Glimt => {
            "radiance = sum of c_lm y_lm; real orthonormal basis without the Condon-Shortley sign: y_00 = 0.282095, y_1-1 = 0.488603 y, \
             y_10 = 0.488603 z, y_11 = 0.488603 x; order l(l+1)+m"
        }
        ShConvention::CondonShortley => {
            "radiance = sum of c_lm y_lm; real orthonormal basis with the Condon-Shortley sign (-1)^m: y_00 = 0.282095, \
             y_1-1 = -0.488603 y, y_10 = 0.488603 z, y_11 = -0.488603 x; order l(l+1)+m"
        }
        ShConvention::Directx => {
            "radiance = sum of c_lm y_lm with the basis of XMSHEvalDirection: order l*l+l+m, y_1-1 = -0.488603 y, y_10 = 0.488603 z, \
             y_11 = -0.488603 x"
        }
        ShConvention::Filament => ENGINE,
    };
    let (centre, left, up) = (along(axes.x_axis), along(axes.y_axis), along(axes.z_axis));
    format!(
        "{numbers}; right-handed axes, in which a light map's centre lies along {centre}, its left along {left}, its top along {up}"
    )
}

/// A direction with as many digits as a reader needs.
fn along(d: Vec3) -> String {
    // 0 is added, so that no zero is negative.
    let [x, y, z] = d.to_array().map(|c| (1e4 * c).round() / 1e4 + 0.0);
    format!("({x}, {y}, {z})")
}

fn converted(frame: &Projected, flags: &ShFlags) -> Vec<Vec3> {
    let light = &frame.coefficients;
    let count = coefficient_count(flags.bands) as usize;
    match flags.convention {
        ShConvention::Glimt => light[..count].to_vec(),
        ShConvention::CondonShortley | ShConvention::Directx => {
            condon_shortley(light)[..count].to_vec()
        }
        ShConvention::Filament => filament_irradiance(light).to_vec(),
    }
}

fn up(flags: &ShFlags) -> &'static str {
    match flags.up {
        Up::Z => "z",
        Up::Y => "y",
    }
}

/// The window's width, if there is one.
fn width(flags: &ShFlags) -> Option<f32> {
    Some(flags.window).filter(|width| *width > 0.0)
}

/// What was done to the coefficients, in words.
fn filters(flags: &ShFlags) -> String {
    let window = width(flags).map_or("off".to_owned(), |w| w.to_string());
    let (up, temporal) = (up(flags), flags.temporal);
    format!("up {up}, Hann window {window}, temporal alpha {temporal}")
}

/// A line a coefficient: frame, l, m, red, green, blue; lines before them that begin with # say what they are.
pub(super) fn csv(frames: &[Projected], flags: &ShFlags, axes: &Mat3) -> String {
    let mut out = format!("# {SOFTWARE} sh, {}\n", filters(flags));
    let _ = writeln!(out, "# {}", meaning(flags.convention, axes));
    for frame in frames.iter().filter(|frame| frame.still) {
        let file = shown(&frame.file).replace(char::is_control, " ");
        let _ = writeln!(out, "# frame {}: {file}", frame.frame);
    }
    out.push_str("frame,l,m,r,g,b\n");
    for frame in frames {
        for (k, c) in (0..).zip(converted(frame, flags)) {
            let (l, m) = (coefficient_band(k), coefficient_order(k));
            let _ = writeln!(out, "{},{l},{m},{},{},{}", frame.frame, c.x, c.y, c.z);
        }
    }
    out
}

/// One object, with a list of frames.
pub(super) fn json(frames: &[Projected], flags: &ShFlags, bands: u32, axes: &Mat3) -> String {
    let list = frames
        .iter()
        .map(|frame| entry(frame, "coefficients", &converted(frame, flags)));
    let convention = match flags.convention {
        ShConvention::Glimt => "glimt",
        ShConvention::CondonShortley => "condon-shortley",
        ShConvention::Directx => "directx",
        ShConvention::Filament => "filament",
    };
    let value = json!({
        "software": SOFTWARE, "convention": convention, "meaning": meaning(flags.convention, axes), "bands": bands,
        "up": up(flags), "window": width(flags), "temporal": flags.temporal,
    });
    with_frames(&value, list)
}

/// The nine coefficients that engines take for diffuse light.
pub(super) fn engine(frames: &[Projected], flags: &ShFlags, axes: &Mat3) -> String {
    let list = frames
        .iter()
        .map(|frame| entry(frame, "sh", &filament_irradiance(&frame.coefficients)));
    let value = json!({
        "software": SOFTWARE, "format": "irradiance over pi, as Filament's shaders take it", "meaning": meaning(ShConvention::Filament, axes),
        "order": POLYNOMIALS, "up": up(flags), "window": width(flags), "temporal": flags.temporal,
    });
    with_frames(&value, list)
}

/// The object with a list of frames behind its other keys, a line each.
fn with_frames(value: &Value, frames: impl Iterator<Item = Value>) -> String {
    let head = value.to_string();
    let head = head.trim_end_matches('}');
    let frames: Vec<String> = frames.map(|frame| frame.to_string()).collect();
    format!("{head},\"frames\":[\n{}\n]}}\n", frames.join(",\n"))
}

fn entry(frame: &Projected, name: &str, coefficients: &[Vec3]) -> Value {
    let list: Vec<Value> = coefficients.iter().map(|c| numbers(*c)).collect();
    let file = shown(&frame.file);
    json!({"frame": frame.frame, "file": file, "size": frame.size.to_array(), name: list})
}

/// With the digits of an f32: what it is as a double would show more than there are.
fn numbers(c: Vec3) -> Value {
    let short = |f: f32| f.to_string().parse::<f64>().unwrap_or(f64::from(f));
    json!([short(c.x), short(c.y), short(c.z)])
}
