//! Host file: OpenEXR images of any channel layout, tiled or not, of which the largest level is read.

use super::{HdrImage, Header};
use crate::error::{Error, Result};
use crate::notes::Notes;
use ::exr::image::read::read;
use ::exr::image::{AnyChannel, FlatSamples};
use ::exr::math::Vec2;
use ::exr::meta::attribute::LevelMode;
use ::exr::meta::attribute::{Chromaticities, EnvironmentMap};
use ::exr::meta::header::Header as Part;
use ::exr::meta::{BlockDescription, MetaData};
use ::exr::prelude::{ReadChannels, ReadLayers};
use glam::{DMat3, DVec3, UVec2, Vec3, Vec4};
use std::path::Path;

/// The CIE xy coordinates of Rec. 709: red, green, blue, white (D65).
pub const REC_709: [[f32; 2]; 4] = [[0.64, 0.33], [0.3, 0.6], [0.15, 0.06], [0.3127, 0.329]];

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
    Ok(header(&meta, part))
}

/// Reads the image: the first part and layer that holds a colour, converted to Rec. 709 primaries.
///
/// # Errors
/// It is broken or truncated, or holds no colour that is understood.
pub fn read_image(file: &Path, notes: &mut Notes) -> Result<HdrImage> {
    let meta = read_meta(file)?;
    let (part, colour) = choose(file, &meta)?;
    let header = header(&meta, part);
    if meta.headers[part].own_attributes.environment_map == Some(EnvironmentMap::Cube) {
        return Err(Error::input(file, "it is a cube map").fix("convert it to a lat-long map"));
    }
    let image = read()
        .no_deep_data()
        .largest_resolution_level()
        .all_channels()
        .all_layers()
        .all_attributes()
        .from_file(file)
        .map_err(|e| broken(file, &e))?;
    let channels = &image.layer_data[part].channel_data.list;

    let size = header.size;
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
    let mut image = HdrImage { header, texels };
    if let (Some(chromaticities), false) = (chromaticities, matches!(colour, Colour::Grey(_))) {
        to_rec_709(file, &mut image.texels, chromaticities, notes);
    }
    Ok(image)
}

fn texels(size: UVec2, colour: impl Fn(u32, u32) -> Vec3) -> Vec<Vec4> {
    (0..size.y)
        .flat_map(|y| (0..size.x).map(move |x| (x, y)))
        .map(|(x, y)| colour(x, y).extend(1.0))
        .collect()
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
    let meta = MetaData::read_from_file(file, false).map_err(|e| broken(file, &e))?;
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

fn header(meta: &MetaData, index: usize) -> Header {
    let part = &meta.headers[index];
    let display = part.shared_attributes.display_window;
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
    Header {
        format: "OpenEXR",
        size: UVec2::new(part.layer_size.x() as u32, part.layer_size.y() as u32),
        channels: part.channels.list.iter().map(channel).collect(),
        storage: format!("{}, {blocks}", part.compression),
        data_origin: {
            let p = part.own_attributes.layer_position;
            [p.x(), p.y()]
        },
        display_origin: [display.position.x(), display.position.y()],
        display_size: [display.size.x() as u32, display.size.y() as u32],
        layers: meta.headers.len(),
        remarks,
    }
}

fn xy(v: Vec2<f32>) -> String {
    format!("({:.4}, {:.4})", v.x(), v.y())
}

fn points(c: Chromaticities) -> [[f32; 2]; 4] {
    [c.red, c.green, c.blue, c.white].map(|v| [v.x(), v.y()])
}

fn is_rec_709(c: Chromaticities) -> bool {
    let near = |a: f32, b: f32| (a - b).abs() <= 1e-3;
    points(c)
        .iter()
        .zip(REC_709)
        .all(|(p, q)| near(p[0], q[0]) && near(p[1], q[1]))
}

/// RGB of the given primaries to CIE XYZ, white at Y = 1 (SMPTE RP 177-1993).
fn rgb_to_xyz(points: [[f32; 2]; 4]) -> DMat3 {
    let column = |p: [f32; 2]| {
        let (x, y) = (f64::from(p[0]), f64::from(p[1]));
        DVec3::new(x / y, 1.0, (1.0 - x - y) / y)
    };
    let primaries = DMat3::from_cols(column(points[0]), column(points[1]), column(points[2]));
    primaries * DMat3::from_diagonal(primaries.inverse() * column(points[3]))
}

/// The matrix to Rec. 709, whites adapted by the Bradford transform; `None` for impossible primaries.
fn matrix_to_rec_709(c: Chromaticities) -> Option<DMat3> {
    // Rows of the Bradford matrix: long, medium and short cone responses.
    let bradford = DMat3::from_cols(
        DVec3::new(0.8951, -0.7502, 0.0389),
        DVec3::new(0.2664, 1.7135, -0.0685),
        DVec3::new(-0.1614, 0.0367, 1.0296),
    );
    let source = rgb_to_xyz(points(c));
    let target = rgb_to_xyz(REC_709);
    let gain = (bradford * (target * DVec3::ONE)) / (bradford * (source * DVec3::ONE));
    let adapt = bradford.inverse() * DMat3::from_diagonal(gain) * bradford;
    let matrix = target.inverse() * adapt * source;
    matrix.is_finite().then_some(matrix)
}

fn luminance_weights(c: Option<Chromaticities>) -> Vec3 {
    let weights = rgb_to_xyz(c.map_or(REC_709, points)).row(1).as_vec3();
    if weights.is_finite() && weights.y > 0.0 {
        return weights;
    }
    Vec3::new(0.2126, 0.7152, 0.0722)
}

fn to_rec_709(file: &Path, texels: &mut [Vec4], c: Chromaticities, notes: &mut Notes) {
    if is_rec_709(c) {
        return;
    }
    let Some(matrix) = matrix_to_rec_709(c) else {
        notes.warn(
            file,
            "its chromaticities are impossible; Rec. 709 is assumed",
        );
        return;
    };
    let mut outside = 0_usize;
    for texel in texels.iter_mut() {
        let colour = texel.truncate().as_dvec3();
        // A texel that is no light stays as it is, to be counted as such.
        if !(colour.min_element() >= 0.0 && colour.is_finite()) {
            continue;
        }
        let converted = matrix * colour;
        outside += usize::from(converted.min_element() < 0.0);
        *texel = converted.max(DVec3::ZERO).as_vec3().extend(1.0);
    }
    notes.note(file, "its primaries are converted to Rec. 709");
    if outside > 0 {
        notes.note(
            file,
            format!(
                "{outside} texels have colours outside Rec. 709; their negative channels are 0"
            ),
        );
    }
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

    #[test]
    fn white_stays_white_and_rec_709_stays() {
        // ACES AP0, white near D60.
        let aces = Chromaticities {
            red: Vec2(0.7347, 0.2653),
            green: Vec2(0.0, 1.0),
            blue: Vec2(0.0001, -0.077),
            white: Vec2(0.32168, 0.33767),
        };
        let white = matrix_to_rec_709(aces).unwrap() * DVec3::ONE;
        assert!((white - DVec3::ONE).length() < 1e-4, "{white}");
        let [red, green, blue, white] = REC_709.map(|p| Vec2(p[0], p[1]));
        let own = Chromaticities {
            red,
            green,
            blue,
            white,
        };
        let matrix = matrix_to_rec_709(own).unwrap();
        assert!(matrix.abs_diff_eq(DMat3::IDENTITY, 1e-6));
        let weights = luminance_weights(None);
        assert!((weights - Vec3::new(0.2126, 0.7152, 0.0722)).length() < 1e-3);
    }
}
