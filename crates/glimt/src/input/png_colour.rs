//! Host file: what a PNG's chunks say of its colours and the shape of its pixels.

use crate::colour::encoding::{Space, Transfer, cicp_primaries, cicp_transfer};
use crate::colour::primaries::{Primaries, REC_709};
use crate::error::{Error, Result};
use std::io::{BufRead, Seek};
use std::path::Path;

/// What a file of a display says of its colours and pixels.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct DisplayColours {
    pub(super) primaries: Primaries,
    pub(super) transfer: Transfer,
    /// Where that is known from.
    pub(super) source: &'static str,
    pub(super) pixel_aspect: f32,
    /// Whether a profile of the file may be mentioned: a chunk that comes before it says otherwise.
    pub(super) has_profile: bool,
    /// What is not used.
    pub(super) remarks: Vec<String>,
}

impl DisplayColours {
    /// Those of files that say nothing.
    pub(super) fn srgb() -> Self {
        Self {
            primaries: REC_709,
            transfer: Transfer::Srgb,
            source: "the file names none",
            pixel_aspect: 1.0,
            has_profile: true,
            remarks: Vec::new(),
        }
    }
}

/// The value of `gAMA` that goes with sRGB, 1/2.2 in units of 10⁻⁵: its curve is meant by it.
const SRGB_GAMMA: u32 = 45_455;

/// Reads the chunks before the picture: `cICP` before `iCCP` before `sRGB` before `gAMA` and `cHRM` (PNG, third edition, § 4.3). A
/// PNG that cannot be read says nothing here: whoever decodes it will say why.
///
/// # Errors
/// Its numbers are encoded by PQ or HLG.
pub(super) fn read(file: &Path, reader: impl BufRead + Seek) -> Result<DisplayColours> {
    let mut found = DisplayColours::srgb();
    let decoder = png::Decoder::new(reader);
    let Ok(reader) = decoder.read_info() else {
        return Ok(found);
    };
    let info = reader.info();
    if let Some(dims) = info.pixel_dims.filter(|d| d.xppu > 0 && d.yppu > 0) {
        let aspect = f64::from(dims.yppu) / f64::from(dims.xppu);
        // Numbers of pixels to the metre are rounded.
        if (aspect - 1.0).abs() > 1e-3 && (0.01..100.0).contains(&aspect) {
            found.pixel_aspect = aspect as f32;
        }
    }
    if let Some(cicp) = info.coding_independent_code_points {
        found.source = "cICP";
        found.has_profile = false;
        match cicp_transfer(cicp.transfer_function) {
            Space::Known(transfer, _) => found.transfer = transfer,
            Space::Refused => {
                return Err(Error::input(
                    file,
                    "its cICP chunk says that it is encoded by PQ, HLG or a logarithm",
                )
                .fix("convert it to linear light as OpenEXR, or to sRGB"));
            }
            Space::Unknown => found.remarks.push(format!(
                "the transfer function {} of its cICP chunk is not known",
                cicp.transfer_function
            )),
        }
        match cicp_primaries(cicp.color_primaries) {
            Some(primaries) => found.primaries = primaries,
            None => found.remarks.push(format!(
                "the primaries {} of its cICP chunk are not known",
                cicp.color_primaries
            )),
        }
        return Ok(found);
    }
    if info.icc_profile.is_some() || info.srgb.is_some() {
        return Ok(found);
    }
    if let Some(gamma) = info.gama_chunk.map(|gamma| gamma.into_scaled()) {
        found.transfer = match gamma {
            0 => Transfer::Srgb,
            gamma if gamma.abs_diff(SRGB_GAMMA) <= 100 => Transfer::Srgb,
            100_000 => Transfer::Linear,
            gamma => Transfer::Gamma(1e5 / gamma as f32),
        };
        if found.transfer != Transfer::Srgb {
            found.source = "gAMA";
        }
    }
    if let Some(points) = info.chrm_chunk {
        let xy = |p: (png::ScaledFloat, png::ScaledFloat)| [p.0.into_value(), p.1.into_value()];
        let named = Primaries([points.red, points.green, points.blue, points.white].map(xy));
        match named.are_possible() {
            true if !named.is(&REC_709) => {
                found.primaries = named;
                found.source = "cHRM";
            }
            true => {}
            false => found
                .remarks
                .push("its cHRM chunk is impossible".to_owned()),
        }
    }
    Ok(found)
}
