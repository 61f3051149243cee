//! Host file: which image of an OpenEXR file is a picture: its parts, layers and views, by their names.

use crate::error::{Error, Result};
use crate::input::Reading;
use crate::notes::Notes;
use ::exr::meta::MetaData;
use ::exr::meta::header::Header as Part;
use std::path::Path;

/// How the channels of a part make a colour.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Colour {
    /// Three channels: red, green, blue.
    Rgb([usize; 3]),
    /// Luminance, red minus and blue minus luminance over luminance.
    Chroma([usize; 3]),
    /// One channel for all three.
    Grey(usize),
}

impl Colour {
    /// The channels, in this order.
    pub(super) fn channels(&self) -> &[usize] {
        match self {
            Self::Rgb(three) | Self::Chroma(three) => three,
            Self::Grey(one) => std::slice::from_ref(one),
        }
    }
}

/// What a name says of an image.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Kind {
    /// It is the picture: it has no name, or one of those that renderers give to it.
    Picture,
    /// It may be anything.
    Unknown,
    /// It is what renderers note of surfaces, not light.
    Data,
}

/// An image of a file.
#[derive(Clone, Debug)]
struct Layer {
    part: usize,
    /// The part's name and the layer's.
    name: String,
    view: Option<String>,
    colour: Colour,
    kind: Kind,
    /// Whether its view is another than the first or left one.
    is_other_view: bool,
    /// Whether its channels have no prefix.
    is_plain: bool,
}

/// The image that is read.
#[derive(Clone, Debug)]
pub(super) struct Choice {
    pub(super) part: usize,
    pub(super) colour: Colour,
    /// Its name; empty for a file's only one.
    pub(super) name: String,
    /// The names of the others.
    pub(super) others: Vec<String>,
    /// Whether its name says that it is a picture, or it is the only one, or it was asked for.
    is_sure: bool,
}

impl Choice {
    /// Says which image was taken where there are several.
    ///
    /// # Errors
    /// That is a guess, and `notes` is strict.
    pub(super) fn note(&self, file: &Path, reading: &Reading, notes: &mut Notes) -> Result<()> {
        if self.others.is_empty() || !reading.layer.is_empty() {
            return Ok(());
        }
        let (taken, others) = (&self.name, self.others.join(", "));
        let chooses = format!("{} chooses", reading.key("layer"));
        if self.is_sure {
            let text = format!("its layer {taken} is taken; it also has {others} ({chooses})");
            notes.note(file, text);
            return Ok(());
        }
        let what = format!("no name says which of its layers is the picture: {taken}, {others}");
        notes.defect(file, &what, &format!("{taken} is taken ({chooses})"))
    }
}

/// The image to read: the one of this name, or the one that is a picture by its name: plain R, G, B before a named layer, the left
/// or first view before others.
///
/// # Errors
/// No layer has this name, or no layer holds light.
pub(super) fn choose(file: &Path, meta: &MetaData, reading: &Reading) -> Result<Choice> {
    let mut layers = layers(meta);
    // The sort is stable: equal ones stay in the order of the file.
    layers.sort_by_key(|layer| (layer.kind, layer.is_other_view, !layer.is_plain));
    let names: Vec<String> = layers.iter().map(Layer::told).collect();
    let at = match reading.layer.as_str() {
        "" => 0,
        wanted => layers
            .iter()
            .position(|layer| layer.is_called(wanted))
            .ok_or_else(|| {
                let known: Vec<&str> = names.iter().map(String::as_str).collect();
                let what = format!("it has no layer `{wanted}` ({})", reading.key("layer"));
                Error::input(file, what).fix_name(wanted, &known)
            })?,
    };
    // A depth or a mask alone is not a picture, and a layer's name would not choose it.
    let is_number =
        |layer: &Layer| layer.kind == Kind::Data && matches!(layer.colour, Colour::Grey(_));
    let chosen = layers.get(at);
    let chosen = chosen.filter(|layer| !reading.layer.is_empty() || !is_number(layer));
    let Some(chosen) = chosen else {
        let what = format!(
            "its channels ({}) hold no colour",
            channels(meta).join(", ")
        );
        return Err(Error::input(file, what).fix("export it with channels R, G, B, or Y alone"));
    };
    if chosen.kind == Kind::Data && reading.layer.is_empty() {
        let what = format!(
            "none of its layers is a picture by its name: {}",
            names.join(", ")
        );
        return Err(Error::input(file, what).fix(format!(
            "export the picture as R, G, B, or name one of them as {}",
            reading.key("layer")
        )));
    }
    let rivals = layers.iter().filter(|layer| layer.kind == chosen.kind);
    let is_sure = chosen.kind == Kind::Picture || rivals.count() == 1;
    let name = match layers.len() {
        1 if chosen.is_plain => String::new(),
        _ => names[at].clone(),
    };
    let others = names.iter().enumerate().filter(|(i, _)| *i != at);
    Ok(Choice {
        part: chosen.part,
        colour: chosen.colour.clone(),
        name,
        others: others.map(|(_, name)| name.clone()).collect(),
        is_sure,
    })
}

/// The names of all channels.
fn channels(meta: &MetaData) -> Vec<String> {
    let parts = meta.headers.iter();
    parts.flat_map(channel_names).collect()
}

fn channel_names(part: &Part) -> Vec<String> {
    let list = part.channels.list.iter();
    list.map(|channel| channel.name.to_string()).collect()
}

/// All images of a file that have a colour or a grey.
fn layers(meta: &MetaData) -> Vec<Layer> {
    let is_multipart = meta.headers.len() > 1;
    let mut layers = Vec::new();
    let mut hero = None;
    let flat = |(_, part): &(usize, &Part)| !part.deep;
    for (index, part) in meta.headers.iter().enumerate().filter(flat) {
        let own = &part.own_attributes;
        let views: Vec<String> = match &own.multi_view_names {
            Some(names) => names.iter().map(ToString::to_string).collect(),
            None => Vec::new(),
        };
        let of_part = own.view_name.as_ref().map(ToString::to_string);
        hero = hero.or_else(|| views.first().cloned());
        let part_name = match (&own.layer_name, is_multipart) {
            (Some(name), true) => name.to_string(),
            _ => String::new(),
        };
        let names = channel_names(part);
        let mut prefixes: Vec<&str> = Vec::new();
        for name in &names {
            let prefix = name.rfind('.').map_or("", |dot| &name[..=dot]);
            if !prefixes.contains(&prefix) {
                prefixes.push(prefix);
            }
        }
        for prefix in prefixes {
            let Some(colour) = colour(&names, prefix) else {
                continue;
            };
            let layer = prefix.trim_end_matches('.');
            let path: Vec<&str> = [part_name.as_str(), layer]
                .into_iter()
                .filter(|name| !name.is_empty())
                .collect();
            let name = match (&colour, path.is_empty()) {
                // A lone channel has no name but its own.
                (Colour::Grey(only), true) if !names[*only].eq_ignore_ascii_case("y") => {
                    names[*only].clone()
                }
                _ => path.join("."),
            };
            let is_view = |word: &str| {
                views.iter().any(|view| view == word)
                    || ["left", "right"]
                        .iter()
                        .any(|v| word.eq_ignore_ascii_case(v))
            };
            let words: Vec<&str> = name.split('.').collect();
            let view = words.iter().rfind(|word| is_view(word));
            let view = of_part.clone().or_else(|| view.map(|v| (*v).to_owned()));
            let last = words
                .iter()
                .rfind(|word| !is_view(word) && !word.is_empty());
            // A layer called "c" is a picture; a channel of that name is not.
            let is_lone = path.is_empty() && !name.is_empty();
            let kind = match (last, is_lone) {
                (Some(last), true) => kind(last).max(Kind::Unknown),
                (Some(last), false) => kind(last),
                (None, _) => Kind::Picture,
            };
            layers.push(Layer {
                part: index,
                name,
                view,
                colour,
                kind,
                is_other_view: false,
                is_plain: prefix.is_empty(),
            });
        }
    }
    for layer in &mut layers {
        layer.is_other_view = match (&layer.view, &hero) {
            (Some(view), Some(hero)) => view != hero,
            (Some(view), None) => view.eq_ignore_ascii_case("right"),
            (None, _) => false,
        };
    }
    layers
}

impl Layer {
    /// Its name in messages.
    fn told(&self) -> String {
        let view = self.view.as_ref().filter(|view| !self.name.contains(*view));
        match (self.name.as_str(), view) {
            ("", None) => "R, G, B".to_owned(),
            ("", Some(view)) => view.clone(),
            (name, None) => name.to_owned(),
            (name, Some(view)) => format!("{name}.{view}"),
        }
    }

    /// Whether a user who writes `wanted` means it: by its name, the last word of it, its part or its view.
    fn is_called(&self, wanted: &str) -> bool {
        let same = |name: &str| name.eq_ignore_ascii_case(wanted);
        same(&self.told())
            || same(&self.name)
            || self.name.split('.').any(same)
            || self.view.as_deref().is_some_and(same)
    }
}

/// What the last word of a layer's name says of it.
fn kind(word: &str) -> Kind {
    let word = word.to_ascii_lowercase();
    // Blender calls its picture "Combined", Arnold "RGBA", Maya and V-Ray "beauty", Redshift "Main", ILM "C".
    let pictures = [
        "beauty",
        "combined",
        "rgba",
        "rgb",
        "color",
        "colour",
        "c",
        "main",
        "image",
        "composite",
    ];
    if pictures.contains(&word.as_str()) || word.contains("beauty") || word.contains("combined") {
        return Kind::Picture;
    }
    let data = [
        "albedo",
        "normal",
        "depth",
        "crypto",
        "occlusion",
        "diffcol",
        "glosscol",
        "transcol",
        "position",
        "velocity",
        "motion",
        "variance",
        "indexob",
        "indexma",
        "object_id",
        "material_id",
        "basecolor",
        "base_color",
    ];
    let short = [
        "ao", "n", "p", "pos", "z", "uv", "st", "id", "a", "alpha", "mask", "matte", "mist",
        "vector", "shadow", "debug",
    ];
    match short.contains(&word.as_str()) || data.iter().any(|name| word.contains(name)) {
        true => Kind::Data,
        false => Kind::Unknown,
    }
}

fn find(names: &[String], wanted: &str) -> Option<usize> {
    names.iter().position(|n| n.eq_ignore_ascii_case(wanted))
}

/// How the channels with this prefix make a colour, if they do.
fn colour(names: &[String], prefix: &str) -> Option<Colour> {
    let channel = |c: &str| find(names, &format!("{prefix}{c}"));
    let long = |c: &str, name: &str| channel(c).or_else(|| channel(name));
    let rgb = || {
        Some(Colour::Rgb([
            long("R", "red")?,
            long("G", "green")?,
            long("B", "blue")?,
        ]))
    };
    let luminance = || {
        let y = channel("Y")?;
        match (channel("RY"), channel("BY")) {
            (Some(ry), Some(by)) => Some(Colour::Chroma([y, ry, by])),
            // X, Y, Z are a vector.
            _ => channel("X").is_none().then_some(Colour::Grey(y)),
        }
    };
    rgb().or_else(luminance).or_else(|| lone(names, prefix))
}

/// A single channel that is not alpha.
fn lone(names: &[String], prefix: &str) -> Option<Colour> {
    let own = |name: &str| {
        let rest = match prefix.is_empty() {
            true => Some(name).filter(|name| !name.contains('.')),
            false => name.strip_prefix(prefix),
        };
        rest.is_some_and(|rest| !rest.contains('.') && !rest.eq_ignore_ascii_case("a"))
    };
    let mut own = (0..names.len()).filter(|&i| own(&names[i]));
    match (own.next(), own.next()) {
        (Some(only), None) => Some(Colour::Grey(only)),
        _ => None,
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
        let rgb = Some(Colour::Rgb([3, 2, 1]));
        assert_eq!(colour(&names(&["A", "B", "G", "R"]), ""), rgb);
        assert_eq!(colour(&names(&["Y"]), ""), Some(Colour::Grey(0)));
        let chroma = Some(Colour::Chroma([2, 1, 0]));
        assert_eq!(colour(&names(&["BY", "RY", "Y"]), ""), chroma);
        let key = names(&["key.B", "key.G", "key.R"]);
        assert_eq!(colour(&key, "key."), Some(Colour::Rgb([2, 1, 0])));
        let light = names(&["A", "light"]);
        assert_eq!(colour(&light, ""), Some(Colour::Grey(1)));
        assert_eq!(colour(&names(&["u", "v"]), ""), None);
        assert_eq!(colour(&names(&["n.X", "n.Y", "n.Z"]), "n."), None);
    }

    #[test]
    fn names_tell_pictures_from_data() {
        for name in ["beauty", "Combined", "RGBA", "C", "Beauty_denoised"] {
            assert_eq!(kind(name), Kind::Picture, "{name}");
        }
        for name in ["albedo", "AO", "Normal", "DiffCol", "CryptoMaterial00", "Z"] {
            assert_eq!(kind(name), Kind::Data, "{name}");
        }
        assert_eq!(kind("key"), Kind::Unknown);
    }
}
