//! Host file: how a file's numbers stand for light: the curve that they were encoded by, and the primaries of their colours, by
//! the names that files and shots have for them.

use super::primaries::{ADOBE_RGB, AP0, AP1, P3_D65, Primaries, REC_709, REC_2020};
use glimt_render_gpu::prepare::plate::srgb_decode;
use std::fmt;

/// The curve between light and a file's numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Transfer {
    /// None.
    Linear,
    /// That of sRGB (IEC 61966-2-1).
    Srgb,
    /// That of a camera by Rec. 709, the same as by Rec. 601 and Rec. 2020.
    Rec709,
    /// A power: light is the number to this exponent.
    Gamma(f32),
}

impl Transfer {
    /// Light of an encoded number. Negative numbers are those of negative light; the curves are continued beyond 1.
    #[must_use]
    pub fn decode(self, encoded: f64) -> f64 {
        let size = encoded.abs();
        let light = match self {
            Self::Linear => return encoded,
            Self::Srgb => srgb_decode(size),
            Self::Rec709 if size < 0.081 => size / 4.5,
            Self::Rec709 => ((size + 0.099) / 1.099).powf(1.0 / 0.45),
            Self::Gamma(exponent) => size.powf(f64::from(exponent)),
        };
        light.copysign(encoded)
    }
}

impl fmt::Display for Transfer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Linear => f.write_str("linear"),
            Self::Srgb => f.write_str("sRGB curve"),
            Self::Rec709 => f.write_str("Rec. 709 curve"),
            Self::Gamma(exponent) => write!(f, "gamma {exponent:.3}"),
        }
    }
}

/// What the name of a colour space says.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Space {
    /// It is known. Some names say nothing of the primaries.
    Known(Transfer, Option<Primaries>),
    /// Its curve reaches beyond white by conventions that are not read here: PQ, HLG, or a camera's logarithm.
    Refused,
    /// It is not known.
    Unknown,
}

/// What an EXR's `colorInteropID` says, as `lin_ap1_scene` or `srgb_rec709_display`.
#[must_use]
pub fn of_interop_id(id: &str) -> Space {
    let id = id.trim().to_ascii_lowercase();
    let mut words = id.split('_');
    let transfer = match words.next().unwrap_or_default() {
        "lin" => Transfer::Linear,
        "srgb" => Transfer::Srgb,
        "g18" => Transfer::Gamma(1.8),
        "g22" => Transfer::Gamma(2.2),
        "g24" => Transfer::Gamma(2.4),
        "g26" => Transfer::Gamma(2.6),
        "pq" | "hlg" => return Space::Refused,
        _ => return Space::Unknown,
    };
    let primaries = match words.next().unwrap_or_default() {
        "rec709" => REC_709,
        "ap1" => AP1,
        "ap0" => AP0,
        "rec2020" => REC_2020,
        "p3d65" => P3_D65,
        "adobergb" => ADOBE_RGB,
        _ => return Space::Unknown,
    };
    Space::Known(transfer, Some(primaries))
}

/// What an `oiio:ColorSpace` says: a role or a name of a colour configuration.
#[must_use]
pub fn of_colour_space(name: &str) -> Space {
    if let known @ (Space::Known(..) | Space::Refused) = of_interop_id(name) {
        return known;
    }
    let plain: String = name
        .chars()
        .filter(|c| c.is_ascii_alphanumeric())
        .map(|c| c.to_ascii_lowercase())
        .collect();
    // Configurations of ACES put a family before the name, as in "ACES - ACEScg".
    let plain = plain.strip_prefix("utility").unwrap_or(&plain);
    let of_family = plain.strip_prefix("aces");
    let plain = of_family
        .filter(|rest| rest.starts_with("aces"))
        .unwrap_or(plain);
    let known = |transfer, primaries| Space::Known(transfer, Some(primaries));
    match plain {
        "linear" | "scenelinear" | "raw" => Space::Known(Transfer::Linear, None),
        "acescg" | "linap1" | "linearap1" => known(Transfer::Linear, AP1),
        "aces20651" | "aces" | "linap0" | "linearap0" => known(Transfer::Linear, AP0),
        "linrec709" | "linsrgb" | "linearrec709" | "linearsrgb" | "linearrec709srgb"
        | "srgblinear" | "linrec709srgb" => known(Transfer::Linear, REC_709),
        "linrec2020" | "linearrec2020" => known(Transfer::Linear, REC_2020),
        "linp3d65" | "linearp3d65" => known(Transfer::Linear, P3_D65),
        "linadobergb" | "linearadobergb" => known(Transfer::Linear, ADOBE_RGB),
        "srgb" | "srgbtexture" | "srgbencodedrec709srgb" => known(Transfer::Srgb, REC_709),
        "rec709" => known(Transfer::Rec709, REC_709),
        "acescc" | "acescct" | "log" => Space::Refused,
        log if log.ends_with("log") || log.contains("logc") || log.contains("slog") => {
            Space::Refused
        }
        pq if pq.contains("pq") || pq.contains("hlg") || pq.contains("st2084") => Space::Refused,
        _ => match name.to_ascii_lowercase().strip_prefix("gamma") {
            Some(exponent) => match exponent.parse::<f32>() {
                Ok(exponent) if exponent > 0.1 && exponent < 10.0 => {
                    known(Transfer::Gamma(exponent), REC_709)
                }
                _ => Space::Unknown,
            },
            None => Space::Unknown,
        },
    }
}

/// The primaries of a PNG's `cICP` chunk, by ITU-T H.273.
#[must_use]
pub fn cicp_primaries(code: u8) -> Option<Primaries> {
    match code {
        1 => Some(REC_709),
        9 => Some(REC_2020),
        12 => Some(P3_D65),
        _ => None,
    }
}

/// The curve of a PNG's `cICP` chunk, by ITU-T H.273.
#[must_use]
pub fn cicp_transfer(code: u8) -> Space {
    match code {
        1 | 6 | 14 | 15 => Space::Known(Transfer::Rec709, None),
        4 => Space::Known(Transfer::Gamma(2.2), None),
        8 => Space::Known(Transfer::Linear, None),
        13 => Space::Known(Transfer::Srgb, None),
        9..=12 | 16 | 18 => Space::Refused,
        _ => Space::Unknown,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_spaces_are_understood() {
        let linear = |primaries| Space::Known(Transfer::Linear, Some(primaries));
        assert_eq!(of_interop_id("lin_ap1_scene"), linear(AP1));
        assert_eq!(of_interop_id("pq_rec2020_display"), Space::Refused);
        assert_eq!(of_interop_id("data"), Space::Unknown);
        for (name, primaries) in [
            ("ACEScg", AP1),
            ("ACES - ACEScg", AP1),
            ("ACES2065-1", AP0),
            ("ACES - ACES2065-1", AP0),
            ("lin_rec709", REC_709),
            ("Linear Rec.709 (sRGB)", REC_709),
            ("Linear Rec.2020", REC_2020),
        ] {
            assert_eq!(of_colour_space(name), linear(primaries), "{name}");
        }
        assert_eq!(
            of_colour_space("Linear"),
            Space::Known(Transfer::Linear, None)
        );
        let gamma = Space::Known(Transfer::Gamma(2.2), Some(REC_709));
        assert_eq!(of_colour_space("Gamma2.2"), gamma);
        for name in ["ACEScct", "KodakLog", "ARRI LogC3", "hlg_rec2020_display"] {
            assert_eq!(of_colour_space(name), Space::Refused, "{name}");
        }
        assert_eq!(of_colour_space("my show's look"), Space::Unknown);
    }

    #[test]
    fn curves_are_continuous_and_odd() {
        for curve in [
            Transfer::Srgb,
            Transfer::Rec709,
            Transfer::Gamma(2.2),
            Transfer::Linear,
        ] {
            assert!((curve.decode(1.0) - 1.0).abs() < 1e-9);
            assert_eq!(curve.decode(-0.5), -curve.decode(0.5));
            let mut last = 0.0;
            for i in 1..=1000 {
                let next = curve.decode(f64::from(i) / 1000.0);
                assert!(
                    next > last && next - last < 3e-3,
                    "{curve} at {i}: {last} {next}"
                );
                last = next;
            }
        }
        // ITU-R BT.709-6: a camera's half is 0.2595 of the light.
        assert!((Transfer::Rec709.decode(0.5) - 0.259_59).abs() < 1e-4);
    }
}
