//! Host file: how a file is changed: anywhere, or where its format keeps what readers trust.

mod bytes;
mod json;
mod places;
pub(crate) mod repair;
mod text;

use glimt_tests::random::Random;

/// What kind of file it is, by its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    Exr,
    Png,
    Jpeg,
    Tiff,
    WebP,
    /// A picture with a header of text: Radiance, PFM.
    TextHeader,
    /// PLY, in text or in bytes.
    Ply,
    /// Any of these, packed.
    Gzip,
    Stl,
    Glb,
    Json,
    /// A state of a sampler.
    State,
    /// Text of lines: OBJ, MTL, TOML.
    Text,
    /// Bytes without a form of their own.
    Bytes,
}

impl Kind {
    pub(crate) fn of(name: &str) -> Self {
        match name.rsplit_once('.').map_or("", |(_, extension)| extension) {
            "exr" => Self::Exr,
            "png" => Self::Png,
            "jpg" => Self::Jpeg,
            "tif" => Self::Tiff,
            "webp" => Self::WebP,
            "hdr" | "pfm" => Self::TextHeader,
            "ply" => Self::Ply,
            "gz" => Self::Gzip,
            "stl" => Self::Stl,
            "glb" => Self::Glb,
            "gltf" => Self::Json,
            "state" => Self::State,
            "obj" | "mtl" | "toml" => Self::Text,
            _ => Self::Bytes,
        }
    }
}

/// The longest file that a mutation makes: longer ones would only take time.
const LONGEST: usize = 1 << 18;

/// A file that differs from `before` in a few places. `other` is a file of the same kind.
pub(crate) fn mutate(kind: Kind, before: &[u8], other: &[u8], random: &mut Random) -> Vec<u8> {
    if kind == Kind::Gzip && !random.one_in(4) {
        return repair::repacked(before, |inner| mutate(Kind::Ply, inner, inner, random));
    }
    let mut bytes = before.to_vec();
    // Most files have one fault; some have several, which may have to come together.
    let faults = 1 + random.below(4).saturating_sub(random.below(4));
    for _ in 0..faults {
        once(kind, &mut bytes, other, random);
        bytes.truncate(LONGEST);
    }
    // What checks itself would refuse nearly every mutation at once.
    if !random.one_in(8) {
        repair::repair(kind, &mut bytes);
    }
    bytes
}

/// Changes one place, of the kinds that the format has.
fn once(kind: Kind, bytes: &mut Vec<u8>, other: &[u8], random: &mut Random) {
    let text = text_of(kind, bytes);
    let has_json = matches!(kind, Kind::Json | Kind::Glb | Kind::State) && !text.is_empty();
    match random.below(6) {
        0 | 1 => bytes::anywhere(bytes, other, random),
        2 if has_json => replace(kind, bytes, text, |text| json::change(text, random)),
        2 | 3 if !text.is_empty() => replace(kind, bytes, text, |t| text::number(t, random)),
        4 if !text.is_empty() => replace(kind, bytes, text, |t| text::lines(t, random)),
        _ => {
            let places = places::find(kind, bytes);
            match places.is_empty() {
                true if text.is_empty() => bytes::anywhere(bytes, other, random),
                true => replace(kind, bytes, text, |t| text::number(t, random)),
                false => bytes::number(bytes, *random.pick(&places), random),
            }
        }
    }
}

/// Where a file has text.
fn text_of(kind: Kind, bytes: &[u8]) -> std::ops::Range<usize> {
    let word = |at: usize| {
        let word = bytes.get(at..at + 4).and_then(|w| w.first_chunk::<4>());
        word.map_or(0, |w| u32::from_le_bytes(*w) as usize)
    };
    let range = match kind {
        Kind::Json | Kind::Text => 0..bytes.len(),
        Kind::TextHeader => 0..bytes.len().min(220),
        Kind::Ply => match find(bytes, b"end_header\n") {
            Some(end) if find(bytes, b"binary_").is_some() => 0..end + 11,
            _ => 0..bytes.len(),
        },
        Kind::Stl if bytes.starts_with(b"solid") => 0..bytes.len(),
        Kind::Glb => 20..20usize.saturating_add(word(12)),
        Kind::State => {
            let start = repair::STATE_MAGIC + 4;
            start..start.saturating_add(word(repair::STATE_MAGIC))
        }
        _ => 0..0,
    };
    match range.end <= bytes.len() && range.start < range.end {
        true => range,
        false => 0..0,
    }
}

fn find(bytes: &[u8], what: &[u8]) -> Option<usize> {
    bytes.windows(what.len()).position(|w| w == what)
}

/// Puts another text in the place of one, and says its length where the file does.
fn replace(
    kind: Kind,
    bytes: &mut Vec<u8>,
    range: std::ops::Range<usize>,
    change: impl FnOnce(&str) -> String,
) {
    let old = String::from_utf8_lossy(&bytes[range.clone()]).into_owned();
    let mut new = change(&old).into_bytes();
    new.truncate(LONGEST);
    if kind == Kind::Glb {
        new.resize(new.len().next_multiple_of(4), b' ');
    }
    let length = (new.len() as u32).to_le_bytes();
    bytes.splice(range, new);
    match kind {
        Kind::Glb => bytes[12..16].copy_from_slice(&length),
        Kind::State => bytes[repair::STATE_MAGIC..][..4].copy_from_slice(&length),
        _ => {}
    }
}

/// Where a number stands.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Place {
    at: usize,
    /// Bytes: 1, 2, 4 or 8.
    width: usize,
    is_big_endian: bool,
}
