//! Host file: OpenEXR images of any channel layout, tiled or not, of which the largest level is read.

mod layers;
mod planes;

use super::{HdrImage, Header, Reading, apply_transfer, require_bound, require_room};
use crate::colour::encoding::{self, Space, Transfer};
use crate::colour::primaries::{Primaries, REC_709};
use crate::error::{Error, Result};
use crate::notes::Notes;
use crate::shot::digest;
use ::exr::meta::attribute::{AttributeValue, Chromaticities, EnvironmentMap, LevelMode, Text};
use ::exr::meta::header::Header as Part;
use ::exr::meta::{BlockDescription, MetaData};
use glam::{I64Vec2, IVec2, UVec2, Vec3, Vec4};
use layers::{Choice, Colour, choose};
use rayon::prelude::*;
use std::path::Path;

/// Reads the header.
///
/// # Errors
/// It is broken or truncated, or of an image that is larger than `reading` allows.
pub fn read_header(file: &Path, reading: &Reading) -> Result<Header> {
    let meta = check_meta(file, MetaData::read_from_file(file, false), reading)?;
    let choice = choose(file, &meta, reading)?;
    let colours = colours(&meta.headers[choice.part]);
    header(file, &meta, &choice, &colours, reading)
}

/// Decodes the image that was read from `file`: the layer that `reading` names, or the one that is a picture. Its colours have the
/// primaries of the file.
///
/// # Errors
/// It is broken or truncated, holds no colour that is understood, or is larger than `reading` allows.
pub fn decode(file: &Path, bytes: &[u8], reading: &Reading, notes: &mut Notes) -> Result<HdrImage> {
    let meta = check_meta(file, MetaData::read_from_buffered(bytes, false), reading)?;
    let choice = choose(file, &meta, reading)?;
    choice.note(file, reading, notes)?;
    let Choice { part, colour, .. } = &choice;
    let colours = colours(&meta.headers[*part]);
    let header = header(file, &meta, &choice, &colours, reading)?;
    require_room(file, header.size, reading)?;
    require_room(file, header.data_size, reading)?;
    let (primaries, transfer) = colours.resolve(file, reading, notes)?;
    if transfer != Transfer::Linear {
        let text = format!("its numbers are made linear: they are encoded by {transfer}");
        notes.note(file, text);
    }
    let (hash, texels) = rayon::join(
        || digest::of_bytes(bytes),
        || planes::read(file, bytes, *part, colour.channels()),
    );
    let mut texels = texels?;
    match colour {
        Colour::Rgb(_) => {}
        Colour::Chroma(_) => {
            let weights = primaries.luminance_weights();
            texels.par_iter_mut().for_each(|texel| {
                let y0 = texel.x;
                let r = (texel.y + 1.0) * y0;
                let b = (texel.z + 1.0) * y0;
                let g = (y0 - r * weights.x - b * weights.z) / weights.y;
                *texel = Vec4::new(r, g, b, 1.0);
            });
        }
        Colour::Grey(index) => {
            let name = meta.headers[*part].channels.list[*index].name.to_string();
            notes.note(
                file,
                format!("its channel {name} alone is taken as grey light"),
            );
            texels
                .par_iter_mut()
                .for_each(|texel| *texel = Vec3::splat(texel.x).extend(1.0));
        }
    }
    apply_transfer(&mut texels, transfer);
    if !header.data_is_display() {
        notes.note(file, windows(&header));
        texels = in_display_window(&header, &texels);
    }
    Ok(HdrImage {
        header,
        texels,
        primaries: match colour {
            // Grey is grey with any primaries.
            Colour::Grey(_) => REC_709,
            _ => primaries,
        },
        hash,
    })
}

/// What the attributes of a part say of its colours.
struct Colours {
    chromaticities: Option<Primaries>,
    interop_id: Option<String>,
    colour_space: Option<String>,
}

fn colours(part: &Part) -> Colours {
    let text = |name: &str| {
        let name = Text::from(name);
        let own = part.own_attributes.other.get(&name);
        let value = own.or_else(|| part.shared_attributes.other.get(&name));
        match value {
            Some(AttributeValue::Text(text)) => Some(text.to_string()),
            _ => None,
        }
    };
    let points =
        |c: Chromaticities| Primaries([c.red, c.green, c.blue, c.white].map(|v| [v.x(), v.y()]));
    Colours {
        chromaticities: part.shared_attributes.chromaticities.map(points),
        interop_id: text("colorInteropID"),
        colour_space: text("oiio:ColorSpace"),
    }
}

impl Colours {
    /// The primaries, the curve, and which attribute says so: `colorInteropID` before `chromaticities` before `oiio:ColorSpace`.
    /// `say` gets what is not understood.
    fn read(&self, say: &mut dyn FnMut(String)) -> (Primaries, Space, &'static str) {
        let mut named = None;
        for (key, value, space) in [
            (
                "colorInteropID",
                &self.interop_id,
                encoding::of_interop_id as fn(&str) -> Space,
            ),
            (
                "oiio:ColorSpace",
                &self.colour_space,
                encoding::of_colour_space,
            ),
        ] {
            let Some(value) = value else { continue };
            match space(value) {
                Space::Unknown => say(format!("its {key} `{value}` is not known, and not used")),
                known => named = named.or(Some((key, known))),
            }
        }
        let possible = self.chromaticities.filter(Primaries::are_possible);
        if possible.is_none() && self.chromaticities.is_some() {
            say("its chromaticities are impossible, and not used".to_owned());
        }
        let of_name = match named {
            Some((_, Space::Known(_, primaries))) => primaries,
            _ => None,
        };
        let space = named.map_or(Space::Known(Transfer::Linear, None), |(_, space)| space);
        match (named, of_name, possible) {
            (Some((key @ "colorInteropID", _)), Some(of_name), own) => {
                if own.is_some_and(|own| !own.is(&of_name)) {
                    say(format!(
                        "its chromaticities are not those of its {key}, which is used"
                    ));
                }
                (of_name, space, key)
            }
            (_, _, Some(own)) => (own, space, "chromaticities"),
            (Some((key, _)), Some(of_name), None) => (of_name, space, key),
            _ => (REC_709, space, "no attribute names them"),
        }
    }

    /// The primaries and the curve that the image is read with.
    fn resolve(
        &self,
        file: &Path,
        reading: &Reading,
        notes: &mut Notes,
    ) -> Result<(Primaries, Transfer)> {
        let mut unused = Vec::new();
        let (primaries, space, source) = self.read(&mut |what| unused.push(what));
        for what in unused.iter().filter(|_| reading.primaries.is_none()) {
            let taken = format!(
                "{primaries} is taken ({source}; {} chooses)",
                reading.key("primaries")
            );
            notes.defect(file, what, &taken)?;
        }
        let transfer = match (reading.transfer, space) {
            (Some(given), _) => given,
            (None, Space::Known(transfer, _)) => transfer,
            (None, _) => {
                return Err(Error::input(file, format!("its colours are encoded as {}", self.told()))
                    .fix("convert it to linear light, as ACEScg, with ffmpeg, OpenColorIO or the program that made it"));
            }
        };
        Ok((reading.primaries.unwrap_or(primaries), transfer))
    }

    fn told(&self) -> String {
        let names = [&self.interop_id, &self.colour_space];
        let names: Vec<&str> = names.into_iter().flatten().map(String::as_str).collect();
        names.join(", ")
    }
}

/// What became of an image whose windows differ.
fn windows(header: &Header) -> String {
    let window = |size: UVec2, [x, y]: [i32; 2]| format!("{} × {} from ({x}, {y})", size.x, size.y);
    format!(
        "its data window is {}, its display window {}: the latter is taken, black where there is no data",
        window(header.data_size, header.data_origin),
        window(header.size, header.display_origin)
    )
}

/// The texels of the display window: those of the data window where the two overlap, black elsewhere.
fn in_display_window(header: &Header, texels: &[Vec4]) -> Vec<Vec4> {
    let stored = header.data_size.as_i64vec2();
    let shift = IVec2::from(header.display_origin).as_i64vec2()
        - IVec2::from(header.data_origin).as_i64vec2();
    let at = |x: u32, y: u32| {
        let place = UVec2::new(x, y).as_i64vec2() + shift;
        let inside = place.cmpge(I64Vec2::ZERO).all() && place.cmplt(stored).all();
        match inside {
            true => texels[(place.y * stored.x + place.x) as usize],
            false => Vec4::W,
        }
    };
    (0..header.size.y)
        .flat_map(|y| (0..header.size.x).map(move |x| (x, y)))
        .map(|(x, y)| at(x, y))
        .collect()
}

fn check_meta(
    file: &Path,
    meta: ::exr::error::Result<MetaData>,
    reading: &Reading,
) -> Result<MetaData> {
    let meta = meta.map_err(|e| broken(file, &e))?;
    if meta.headers.iter().all(|part| part.deep) {
        return Err(Error::input(file, "deep images are not supported").fix("flatten it first"));
    }
    // Of all parts: the reader walks through the blocks of each.
    for part in &meta.headers {
        let side = |n: usize| u32::try_from(n).unwrap_or(u32::MAX);
        let stored = UVec2::new(side(part.layer_size.x()), side(part.layer_size.y()));
        require_bound(file, stored, reading).map_err(|e| e.at("data window"))?;
        let display = part.shared_attributes.display_window.size;
        let shown = UVec2::new(side(display.x()), side(display.y()));
        require_bound(file, shown, reading).map_err(|e| e.at("display window"))?;
    }
    Ok(meta)
}

fn broken(file: &Path, error: &::exr::error::Error) -> Error {
    use ::exr::error::Error as E;
    match error {
        E::Io(e) => Error::reading(file, e),
        E::NotSupported(what) => Error::input(file, format!("not supported: {what}"))
            .fix("export it with ZIP compression and plain R, G, B channels"),
        E::Invalid(what) if what.contains("missing bytes") => {
            Error::input(file, "the file ends too early")
                .fix("it is probably truncated: copy or export it again")
        }
        e => Error::input(file, format!("it is broken: {e}")).fix("copy or export it again"),
    }
}

fn header(
    file: &Path,
    meta: &MetaData,
    choice: &Choice,
    colours: &Colours,
    reading: &Reading,
) -> Result<Header> {
    let part = &meta.headers[choice.part];
    if part.own_attributes.environment_map == Some(EnvironmentMap::Cube)
        && reading.table != "backplate"
    {
        return Err(Error::input(
            file,
            "its envmap attribute says that it is a cube map of OpenEXR's own layout",
        )
        .fix("convert it to a lat-long map with exrenvmap -latlong"));
    }
    let display = part.shared_attributes.display_window;
    let size = UVec2::new(display.size.x() as u32, display.size.y() as u32);
    let mut remarks = Vec::new();
    if let Some(map) = part.own_attributes.environment_map {
        remarks.push(match map {
            EnvironmentMap::LatitudeLongitude => "marked as a lat-long map".to_owned(),
            EnvironmentMap::Cube => "marked as a cube map".to_owned(),
        });
    }
    if let Some(software) = &part.own_attributes.software_name {
        remarks.push(format!("written by {software}"));
    }
    let blocks = match part.blocks {
        BlockDescription::ScanLines => "scan lines".to_owned(),
        BlockDescription::Tiles(tiles) => {
            let levels = match tiles.level_mode {
                LevelMode::Singular => "",
                LevelMode::MipMap => ", mip-mapped",
                LevelMode::RipMap => ", rip-mapped",
            };
            format!(
                "tiles of {} × {}{levels}",
                tiles.tile_size.x(),
                tiles.tile_size.y()
            )
        }
    };
    let channel = |c: &::exr::meta::attribute::ChannelDescription| {
        let kind = format!("{:?}", c.sample_type).to_lowercase();
        format!("{} {kind}", c.name)
    };
    let (of_file, space, source) = colours.read(&mut |what| remarks.push(what));
    let transfer = match (reading.transfer, space) {
        (Some(given), _) => given.to_string(),
        (None, Space::Known(transfer, _)) => transfer.to_string(),
        (None, _) => format!("{} (not read)", colours.told()),
    };
    Ok(Header {
        format: "OpenEXR",
        size,
        channels: part.channels.list.iter().map(channel).collect(),
        storage: format!("{}, {blocks}", part.compression),
        data_origin: {
            let p = part.own_attributes.layer_position;
            [p.x(), p.y()]
        },
        data_size: UVec2::new(part.layer_size.x() as u32, part.layer_size.y() as u32),
        display_origin: [display.position.x(), display.position.y()],
        parts: meta.headers.len(),
        layer: choice.name.clone(),
        other_layers: choice.others.clone(),
        primaries: reading.told_primaries(of_file, source),
        transfer,
        pixel_aspect: part.shared_attributes.pixel_aspect,
        remarks,
    })
}
