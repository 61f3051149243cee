//! Host file: who is compared: named sets of keys of the shot.

use super::count::Knob;
use crate::bake;
use crate::cli::{CompareFlags, RenderFlags};
use crate::error::{Error, Kind, Place, Result, nearest};
use crate::input::footage;
use crate::setup;
use crate::shot::digest::Hash;
use crate::shot::parse::{self, Source};
use crate::shot::{Background, Filter, Method, Shot, check, digest};
use std::path::Path;

/// Contestants under one word, as --preset takes them: the word, their names, their keys.
///
/// All keys are spelled out. `render.preset` would not do: it yields to the keys that a shot gives.
const BUILT_IN: [(&str, &str, &[&str]); 8] = [
    (
        "kronander-mis",
        "kronander MIS",
        &[
            "render.method=mis",
            "image.rays_per_pixel=1",
            "render.brdf_samples=15",
            "render.env_samples=15",
            "render.compensation=false",
            "render.pattern=independent",
        ],
    ),
    (
        "kronander-bis",
        "kronander BIS",
        &[
            "render.method=bis",
            "image.rays_per_pixel=1",
            "render.bis.candidates=400",
            "render.bis.samples=20",
            "render.pattern=independent",
        ],
    ),
    (
        "kronander-smc",
        "kronander SMC",
        &[
            "render.method=smc",
            "image.rays_per_pixel=1",
            "render.smc.particles=8",
            "render.smc.intermediate=3",
            "render.smc.reinitialise=1.25",
            "render.smc.max_age=0",
            "render.smc.max_change=1",
            "render.pattern=independent",
        ],
    ),
    (
        STRATIFIED,
        "stratified MIS",
        &[
            "render.method=mis",
            "image.rays_per_pixel=1",
            "render.brdf_samples=15",
            "render.env_samples=15",
            "render.compensation=false",
            "render.pattern=stratified",
        ],
    ),
    (
        "owen-sobol",
        "Owen-Sobol MIS",
        &[
            "render.method=mis",
            "image.rays_per_pixel=16",
            "render.brdf_samples=1",
            "render.env_samples=1",
            "render.compensation=true",
            "render.pattern=owen-sobol",
        ],
    ),
    (
        "product",
        "product sampling",
        &[
            "render.method=product",
            "image.rays_per_pixel=16",
            "render.product.rays=32",
            "render.pattern=owen-sobol",
        ],
    ),
    (
        "cells",
        "light cells",
        &[
            "render.method=cells",
            "image.rays_per_pixel=16",
            "render.cells.rays=32",
            "render.pattern=owen-sobol",
        ],
    ),
    ("shot", "the shot's own", &[]),
];

/// The contestant that efficiency is relative to, where it takes part.
const STRATIFIED: &str = "stratified";

/// The word for the three methods of the paper.
const KRONANDER: &str = "kronander";

/// The words that --preset takes.
fn words() -> impl Iterator<Item = &'static str> {
    [KRONANDER].into_iter().chain(BUILT_IN.map(|b| b.0))
}

/// Who takes part.
#[derive(Clone, Debug)]
pub struct Contestant {
    /// Its name, for people.
    pub name: String,
    /// Its keys.
    pub set: Vec<String>,
    /// The shot with those keys, the common filter, and nothing behind the objects.
    pub shot: Shot,
    /// What it is given more of when it is given more time.
    pub knob: Knob,
    /// Whether efficiency is relative to it.
    pub is_baseline: bool,
    /// The hash of its precomputed transfer, where it renders by one.
    bake: Option<Hash>,
    source: Source,
}

/// A contestant that is asked for.
struct Asked {
    name: String,
    set: Vec<String>,
    is_baseline: bool,
    /// Whether it was named; what is there by default may be left out.
    named: bool,
}

/// What all contestants share.
pub struct Field<'a> {
    /// The shot's file.
    pub file: &'a Path,
    /// Flags that hold for all.
    pub flags: &'a RenderFlags,
    /// Where in its pixel a ray passes, for all.
    pub filter: Filter,
}

/// The contestants that are asked for, checked; and what to say about those that are left out.
///
/// # Errors
/// One that was named is wrong or refused; or none is left.
pub fn gather(
    field: &Field<'_>,
    flags: &CompareFlags,
    remarks: &mut Vec<String>,
) -> Result<Vec<Contestant>> {
    let mut list: Vec<Contestant> = Vec::new();
    for asked in asked(flags)? {
        let contestant = match field.contestant(&asked) {
            Err(e) if !asked.named => {
                remarks.push(format!("`{}` does not take part: {e}", asked.name));
                continue;
            }
            other => other?,
        };
        let same = |other: &&Contestant| other.digest() == contestant.digest();
        if let Some(other) = list.iter().find(same) {
            remarks.push(format!(
                "`{}` does not take part: `{}` has the same settings",
                contestant.name, other.name
            ));
            continue;
        }
        if list.iter().any(|other| other.name == contestant.name) {
            return Err(
                Error::usage(format!("two contestants are named `{}`", contestant.name))
                    .at("--contestant")
                    .fix("give each a name of its own"),
            );
        }
        list.push(contestant);
    }
    if list.is_empty() {
        return Err(Error::usage("no contestant is left").fix(
            "name some, as --preset stratified --contestant 'ours: render.pattern=owen-sobol'",
        ));
    }
    if !list.iter().any(|c| c.is_baseline) {
        list[0].is_baseline = true;
    }
    Ok(list)
}

fn asked(flags: &CompareFlags) -> Result<Vec<Asked>> {
    let built_in = |word: &str, named: bool| -> Option<Asked> {
        let (_, name, set) = BUILT_IN.into_iter().find(|b| b.0 == word)?;
        Some(Asked {
            name: name.to_owned(),
            set: set.iter().map(|s| (*s).to_owned()).collect(),
            is_baseline: word == STRATIFIED,
            named,
        })
    };
    let paper = ["kronander-mis", "kronander-bis", "kronander-smc"];
    let mut list = Vec::new();
    for word in &flags.preset {
        if word == KRONANDER {
            // As a word for three it takes those that there are.
            list.extend(paper.iter().filter_map(|w| built_in(w, false)));
            continue;
        }
        list.push(built_in(word, true).ok_or_else(|| {
            let error = Error::usage(format!("there is no preset `{word}`")).at("--preset");
            match nearest(word, words()) {
                Some(near) => error.fix(format!("did you mean `{near}`?")),
                None => error.fix(format!("known: {}", words().collect::<Vec<_>>().join(", "))),
            }
        })?);
    }
    for text in &flags.contestant {
        list.push(read(text)?);
    }
    if list.is_empty() {
        let default = paper.into_iter().chain([STRATIFIED, "shot"]);
        list.extend(default.filter_map(|w| built_in(w, w == "shot")));
    }
    Ok(list)
}

/// Reads `NAME: key=value key=value`.
fn read(text: &str) -> Result<Asked> {
    let wrong = |what: &str| {
        Error::usage(what).at(format!("--contestant '{text}'")).fix(
            "write it as --contestant 'NAME: render.pattern=owen-sobol image.rays_per_pixel=8'",
        )
    };
    let (name, keys) = text
        .split_once(':')
        .ok_or_else(|| wrong("it has no name"))?;
    let name = name.trim();
    if name.is_empty() {
        return Err(wrong("its name is empty"));
    }
    let set: Vec<String> = keys.split_whitespace().map(str::to_owned).collect();
    for item in &set {
        let Some((key, _)) = item.split_once('=') else {
            return Err(wrong(&format!("there is no `=` in `{item}`")));
        };
        let of_all = ["render.seed", "render.frames"];
        let of_one = key.starts_with("render.") || key == "image.rays_per_pixel";
        if !of_one || of_all.contains(&key) {
            return Err(Error::usage(format!(
                "`{key}` is the same for all contestants: they differ in render.* and image.rays_per_pixel alone"
            ))
            .at(format!("--contestant '{text}'"))
            .fix(format!("set it for all, as --set {item}")));
        }
    }
    Ok(Asked {
        name: name.to_owned(),
        set,
        is_baseline: false,
        named: true,
    })
}

impl Field<'_> {
    fn contestant(&self, asked: &Asked) -> Result<Contestant> {
        let (shot, source) = self
            .shot(&asked.set)
            .map_err(|e| of_contestant(e, &asked.name, &asked.set))?;
        let bake = (shot.render.method == Method::Prt).then(|| bake::hash_of(&shot, &source));
        let bake = bake.transpose();
        Ok(Contestant {
            bake: bake.map_err(|e| of_contestant(e, &asked.name, &asked.set))?,
            name: asked.name.clone(),
            set: asked.set.clone(),
            knob: Knob::of(&shot),
            is_baseline: asked.is_baseline,
            shot,
            source,
        })
    }

    /// The shot with further keys, as it is compared.
    ///
    /// # Errors
    /// The shot is refused.
    pub fn shot(&self, set: &[String]) -> Result<(Shot, Source)> {
        let mut all = setup::overrides(self.flags);
        all.extend_from_slice(set);
        let (mut shot, source) = parse::read(self.file, &all)?;
        footage::adopt_size(&mut shot, &source)?;
        check::check(&shot, &source)?;
        shot.image.filter = self.filter;
        shot.image.background = Background::Transparent;
        shot.output.aovs.clear();
        Ok((shot, source))
    }

    /// A contestant with another count.
    ///
    /// # Errors
    /// The shot is refused.
    pub fn with_count(&self, contestant: &Contestant, count: u32) -> Result<Contestant> {
        let keys = contestant.knob.keys(count);
        let name = |item: &str| item.split('=').next().unwrap_or_default().to_owned();
        let replaced: Vec<String> = keys.iter().map(|k| name(k)).collect();
        let mut set = contestant.set.clone();
        set.retain(|item| !replaced.contains(&name(item)));
        set.extend(keys);
        let (shot, source) = self
            .shot(&set)
            .map_err(|e| of_contestant(e, &contestant.name, &set))?;
        Ok(Contestant {
            set,
            shot,
            source,
            ..contestant.clone()
        })
    }
}

impl Contestant {
    /// The hash of what makes its images what they are, beside the frames' inputs.
    #[must_use]
    pub fn digest(&self) -> Hash {
        let shot = digest::of_shot(&self.shot);
        digest::join([&shot].into_iter().chain(&self.bake))
    }

    /// Whether it continues from the frame before.
    #[must_use]
    pub fn is_stateful(&self) -> bool {
        self.shot.render.continues()
    }

    /// What the renderer says of its settings.
    pub fn refused(&self, why: impl std::fmt::Display) -> Error {
        of_contestant(self.source.error("render", why), &self.name, &self.set)
    }

    /// Its count now.
    #[must_use]
    pub fn count(&self) -> u32 {
        Knob::of(&self.shot).count()
    }

    /// A name for files.
    #[must_use]
    pub fn slug(&self) -> String {
        let letters = self.name.chars().map(|c| match c {
            'a'..='z' | 'A'..='Z' | '0'..='9' | '-' | '_' => c,
            _ => '-',
        });
        letters.take(40).collect()
    }
}

/// Errors of its own keys are those of the contestant, not of a --set that no one gave.
fn of_contestant(mut error: Error, name: &str, set: &[String]) -> Error {
    let own = |place: &Place| match place {
        Place::Named(text) => set
            .iter()
            .find(|item| *text == format!("--set {item}"))
            .cloned(),
        Place::LineColumn(..) => None,
    };
    let at = match error.place.as_ref().and_then(own) {
        Some(item) => format!("contestant `{name}`, {item}"),
        None if error.kind == Kind::Usage && error.place.is_none() => {
            format!("contestant `{name}`")
        }
        None => return error,
    };
    error.place = Some(Place::Named(at));
    error
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn contestants_are_read() {
        let ours = read("ours: render.pattern=stratified image.rays_per_pixel=8").unwrap();
        assert_eq!(ours.name, "ours");
        let keys = ["render.pattern=stratified", "image.rays_per_pixel=8"];
        assert_eq!(ours.set, keys);
        let message = |text: &str| read(text).err().unwrap().to_string();
        assert!(message("ours").contains("it has no name"));
        assert!(message("a: render.pattern").contains("there is no `=` in `render.pattern`"));
        assert!(message("a: image.size=[4,4]").contains("--set image.size=[4,4]"));
        assert!(message("a: render.seed=4").contains("the same for all"));
    }

    /// A contestant whose keys are wrong says so in its own name.
    #[test]
    fn errors_are_the_contestants() {
        let set = ["render.method=bis".to_owned()];
        let error = Error::usage("no").at("--set render.method=bis");
        let error = of_contestant(error, "theirs", &set).to_string();
        assert_eq!(error, "contestant `theirs`, render.method=bis: no");
        let error = Error::usage("no").at("--set image.size=[0,0]");
        let error = of_contestant(error, "theirs", &set).to_string();
        assert_eq!(error, "--set image.size=[0,0]: no");
    }

    #[test]
    fn presets_are_known() {
        let of = |words: &[&str]| {
            let flags = CompareFlags {
                preset: words.iter().map(|w| (*w).to_owned()).collect(),
                ..CompareFlags::default()
            };
            asked(&flags)
        };
        let names = |list: Vec<Asked>| list.into_iter().map(|a| a.name).collect::<Vec<_>>();
        let all = names(of(&[]).unwrap());
        let expected = [
            "kronander MIS",
            "kronander BIS",
            "kronander SMC",
            "stratified MIS",
            "the shot's own",
        ];
        assert_eq!(all, expected);
        assert_eq!(names(of(&["kronander"]).unwrap()), expected[..3]);
        let error = of(&["stratifed"]).err().unwrap().to_string();
        assert!(error.contains("did you mean `stratified`?"), "{error}");
    }
}
