//! Host file: OpenEXR images of any channel layout, tiled or not, of which the largest level is read.

use super::primaries::{is_rec_709, luminance_weights, to_rec_709};
use super::{HdrImage, Header, MAX_TEXELS, require_room};
use crate::error::{Error, Result};
use crate::notes::Notes;
use crate::shot::digest;
use ::exr::image::read::read;
use ::exr::image::{AnyChannel, FlatSamples};
use ::exr::math::Vec2;
use ::exr::meta::attribute::EnvironmentMap;
use ::exr::meta::attribute::LevelMode;
use ::exr::meta::header::Header as Part;
use ::exr::meta::{BlockDescription, MetaData};
use ::exr::prelude::{ReadChannels, ReadLayers};
use glam::{I64Vec2, IVec2, UVec2, Vec3, Vec4};
use rayon::prelude::*;
use std::io::Cursor;
use std::path::Path;

/// How the channels of a part make a colour.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Colour {
    /// Three channels: red, green, blue.
    Rgb([usize; 3]),
    /// Luminance, red minus and blue minus luminance over luminance.
    Chroma([usize; 3]),
    /// One channel for all three.
    Grey(usize),
}

/// Reads the header.
///
/// # Errors
/// It is broken or truncated.
pub fn read_header(file: &Path) -> Result<Header> {
    let meta = read_meta(file)?;
    let (part, _) = choose(file, &meta)?;
    header(file, &meta, part)
}

/// Decodes the image that was read from `file`: the first part and layer that holds a colour, converted to Rec. 709 primaries.
///
/// # Errors
/// It is broken or truncated, or holds no colour that is understood.
pub fn decode(file: &Path, bytes: &[u8], notes: &mut Notes) -> Result<HdrImage> {
    let meta = check_meta(file, MetaData::read_from_buffered(bytes, false))?;
    let (part, colour) = choose(file, &meta)?;
    let header = header(file, &meta, part)?;
    if meta.headers[part].own_attributes.environment_map == Some(EnvironmentMap::Cube) {
        return Err(Error::input(file, "it is a cube map").fix("convert it to a lat-long map"));
    }
    require_room(file, header.size)?;
    require_room(file, header.data_size)?;
    let image = read()
        .no_deep_data()
        .largest_resolution_level()
        .all_channels()
        .all_layers()
        .all_attributes()
        .from_buffered(Cursor::new(bytes))
        .map_err(|e| broken(file, &e))?;
    let channels = &image.layer_data[part].channel_data.list;

    let size = header.data_size;
    let plane = |index: usize| Plane::new(file, &channels[index], size);
    let chromaticities = image.attributes.chromaticities;
    let texels = match colour {
        Colour::Rgb(rgb) => {
            let [r, g, b] = [plane(rgb[0])?, plane(rgb[1])?, plane(rgb[2])?];
            texels(size, |x, y| Vec3::new(r.at(x, y), g.at(x, y), b.at(x, y)))
        }
        Colour::Chroma(yc) => {
            let [luma, red, blue] = [plane(yc[0])?, plane(yc[1])?, plane(yc[2])?];
            let weights = luminance_weights(chromaticities);
            texels(size, |x, y| {
                let y0 = luma.at(x, y);
                let r = (red.at(x, y) + 1.0) * y0;
                let b = (blue.at(x, y) + 1.0) * y0;
                let g = (y0 - r * weights.x - b * weights.z) / weights.y;
                Vec3::new(r, g, b)
            })
        }
        Colour::Grey(index) => {
            let grey = plane(index)?;
            let name = channels[index].name.to_string();
            notes.note(
                file,
                format!("its channel {name} alone is taken as grey light"),
            );
            texels(size, |x, y| Vec3::splat(grey.at(x, y)))
        }
    };
    let texels = match header.data_is_display() {
        true => texels,
        false => {
            notes.note(file, windows(&header));
            in_display_window(&header, &texels)
        }
    };
    let mut image = HdrImage {
        header,
        texels,
        hash: digest::of_bytes(bytes),
    };
    if let (Some(chromaticities), false) = (chromaticities, matches!(colour, Colour::Grey(_))) {
        to_rec_709(file, &mut image.texels, chromaticities, notes);
    }
    Ok(image)
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

fn texels(size: UVec2, colour: impl Fn(u32, u32) -> Vec3 + Sync) -> Vec<Vec4> {
    let mut texels = vec![Vec4::W; size.x as usize * size.y as usize];
    let rows = texels.par_chunks_mut(size.x.max(1) as usize);
    rows.zip(0..size.y).for_each(|(row, y)| {
        for (texel, x) in row.iter_mut().zip(0..) {
            *texel = colour(x, y).extend(1.0);
        }
    });
    texels
}

/// The samples of one channel, which may be stored for every nth texel only.
struct Plane<'a> {
    samples: &'a FlatSamples,
    step: UVec2,
    width: u32,
}

impl<'a> Plane<'a> {
    fn new(file: &Path, channel: &'a AnyChannel<FlatSamples>, size: UVec2) -> Result<Self> {
        let step = UVec2::new(channel.sampling.x() as u32, channel.sampling.y() as u32);
        let stored = size / step.max(UVec2::ONE);
        let samples = &channel.sample_data;
        if samples.len() as u64 != u64::from(stored.x) * u64::from(stored.y)
            || step * stored != size
        {
            let what = format!("channel {} is subsampled unevenly", channel.name);
            return Err(Error::input(file, what).fix("export it with plain R, G, B channels"));
        }
        Ok(Self {
            samples,
            step,
            width: stored.x,
        })
    }

    fn at(&self, x: u32, y: u32) -> f32 {
        let index = (y / self.step.y * self.width + x / self.step.x) as usize;
        match self.samples {
            FlatSamples::F16(s) => s[index].to_f32(),
            FlatSamples::F32(s) => s[index],
            FlatSamples::U32(s) => s[index] as f32,
        }
    }
}

fn read_meta(file: &Path) -> Result<MetaData> {
    check_meta(file, MetaData::read_from_file(file, false))
}

fn check_meta(file: &Path, meta: ::exr::error::Result<MetaData>) -> Result<MetaData> {
    let meta = meta.map_err(|e| broken(file, &e))?;
    if meta.headers.iter().all(|part| part.deep) {
        return Err(Error::input(file, "deep images are not supported").fix("flatten it first"));
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

/// Finds a colour among the names of a part's channels.
type Rule = fn(&[String]) -> Option<Colour>;

/// The part and the channels to read: plain R, G, B before Y, before those of a layer, before a lone channel.
fn choose(file: &Path, meta: &MetaData) -> Result<(usize, Colour)> {
    let names = |part: &Part| -> Vec<String> {
        let list = part.channels.list.iter();
        list.map(|c| c.name.to_string()).collect()
    };
    let parts: Vec<(usize, Vec<String>)> = meta
        .headers
        .iter()
        .enumerate()
        .filter(|(_, part)| !part.deep)
        .map(|(i, part)| (i, names(part)))
        .collect();
    let rules: [Rule; 4] = [plain_rgb, luminance, layer_rgb, lone];
    rules
        .iter()
        .find_map(|rule| parts.iter().find_map(|(i, n)| rule(n).map(|c| (*i, c))))
        .ok_or_else(|| {
            let all: Vec<String> = parts.into_iter().flat_map(|(_, n)| n).collect();
            let what = format!("its channels ({}) hold no colour", all.join(", "));
            Error::input(file, what).fix("export it with channels R, G, B, or Y alone")
        })
}

fn find(names: &[String], wanted: &str) -> Option<usize> {
    names.iter().position(|n| n.eq_ignore_ascii_case(wanted))
}

fn rgb(names: &[String], prefix: &str) -> Option<Colour> {
    let channel = |c: &str| find(names, &format!("{prefix}{c}"));
    let long = |c: &str, name: &str| channel(c).or_else(|| channel(name));
    Some(Colour::Rgb([
        long("R", "red")?,
        long("G", "green")?,
        long("B", "blue")?,
    ]))
}

fn plain_rgb(names: &[String]) -> Option<Colour> {
    rgb(names, "")
}

fn luminance(names: &[String]) -> Option<Colour> {
    let y = find(names, "Y")?;
    match (find(names, "RY"), find(names, "BY")) {
        (Some(ry), Some(by)) => Some(Colour::Chroma([y, ry, by])),
        _ => Some(Colour::Grey(y)),
    }
}

fn layer_rgb(names: &[String]) -> Option<Colour> {
    let prefixes = names.iter().filter_map(|n| n.rfind('.').map(|i| &n[..=i]));
    prefixes.into_iter().find_map(|prefix| rgb(names, prefix))
}

/// A single channel that is not alpha or depth.
fn lone(names: &[String]) -> Option<Colour> {
    let is_light = |n: &str| {
        let last = n.rsplit('.').next().unwrap_or(n);
        !["A", "Z", "id"]
            .iter()
            .any(|x| last.eq_ignore_ascii_case(x))
    };
    let mut light = (0..names.len()).filter(|&i| is_light(&names[i]));
    match (light.next(), light.next()) {
        (Some(only), None) => Some(Colour::Grey(only)),
        _ => None,
    }
}

fn header(file: &Path, meta: &MetaData, index: usize) -> Result<Header> {
    let part = &meta.headers[index];
    let display = part.shared_attributes.display_window;
    let size = [display.size.x(), display.size.y()];
    if size[0].saturating_mul(size[1]) as u64 > MAX_TEXELS || size.contains(&0) {
        let what = format!("its display window is {} × {} texels", size[0], size[1]);
        return Err(
            Error::input(file, what).fix("copy or export it again, with a sound display window")
        );
    }
    let mut remarks = Vec::new();
    if let Some(c) = part.shared_attributes.chromaticities
        && !is_rec_709(c)
    {
        remarks.push(format!(
            "primaries R {} G {} B {} W {} (converted to Rec. 709)",
            xy(c.red),
            xy(c.green),
            xy(c.blue),
            xy(c.white)
        ));
    }
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
    Ok(Header {
        format: "OpenEXR",
        size: UVec2::from(size.map(|n| n as u32)),
        channels: part.channels.list.iter().map(channel).collect(),
        storage: format!("{}, {blocks}", part.compression),
        data_origin: {
            let p = part.own_attributes.layer_position;
            [p.x(), p.y()]
        },
        data_size: UVec2::new(part.layer_size.x() as u32, part.layer_size.y() as u32),
        display_origin: [display.position.x(), display.position.y()],
        layers: meta.headers.len(),
        remarks,
    })
}

fn xy(v: Vec2<f32>) -> String {
    format!("({:.4}, {:.4})", v.x(), v.y())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(list: &[&str]) -> Vec<String> {
        list.iter().map(|s| (*s).to_owned()).collect()
    }

    #[test]
    fn channels_are_found() {
        assert_eq!(
            plain_rgb(&names(&["A", "B", "G", "R"])),
            Some(Colour::Rgb([3, 2, 1]))
        );
        assert_eq!(luminance(&names(&["Y"])), Some(Colour::Grey(0)));
        assert_eq!(
            luminance(&names(&["BY", "RY", "Y"])),
            Some(Colour::Chroma([2, 1, 0]))
        );
        assert_eq!(
            layer_rgb(&names(&["key.B", "key.G", "key.R"])),
            Some(Colour::Rgb([2, 1, 0]))
        );
        assert_eq!(lone(&names(&["A", "light"])), Some(Colour::Grey(1)));
        assert_eq!(lone(&names(&["u", "v"])), None);
    }
}
