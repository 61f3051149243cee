//! Host file: from TOML and `--set key=value` to a shot, or another document of keys. What is not understood is an error that says where and names
//! the nearest thing that would be.

use super::Shot;
use crate::error::{Error, Result, nearest};
use glimt_render_gpu::methods::Mis;
use serde::de::DeserializeOwned;
use std::path::Path;
use toml::de::{DeTable, DeValue};
use toml::{Table, Value};

/// What is read from TOML and `--set`: a shot, or the settings of another command. Every key has a default.
pub trait Document: DeserializeOwned {
    /// What it is, for messages: "a shot".
    const NAME: &'static str;
    /// A setting of it, for messages.
    const EXAMPLE: &'static str;
    /// Its arrays of tables.
    const LISTS: &'static [&'static str];
    /// Fills in what some keys mean for others that are not given.
    fn complete(_table: &mut Table) {}
}

impl Document for Shot {
    const NAME: &'static str = "a shot";
    const EXAMPLE: &'static str = "image.rays_per_pixel=64";
    const LISTS: &'static [&'static str] = &["object", "key", "spin"];
    fn complete(table: &mut Table) {
        apply_preset(table);
        choose_method(table);
    }
}

/// A document with the text that it was read from, for messages about its keys.
#[derive(Clone, Debug)]
pub struct Source {
    /// The file's name.
    pub file: std::path::PathBuf,
    text: String,
    set: Vec<String>,
    given: Table,
}

/// Reads a file and applies `key=value` overrides.
///
/// # Errors
/// The first unknown key, wrong type or syntax error, with its line and column or the override it stands in.
pub fn read<T: Document>(file: &Path, set: &[String]) -> Result<(T, Source)> {
    let text = std::fs::read_to_string(file).map_err(|e| match e.kind() {
        std::io::ErrorKind::InvalidData => {
            Error::input(file, "it is not a text file").fix(format!("{} is a TOML file", T::NAME))
        }
        _ => Error::reading(file, &e),
    })?;
    parse(file, text, set)
}

/// The same for a text already in memory; `file` is its name in messages.
///
/// # Errors
/// As [`read`].
pub fn parse<T: Document>(file: &Path, text: String, set: &[String]) -> Result<(T, Source)> {
    let in_file = |error: toml::de::Error| {
        let (line, column) = position(&text, error.span().map_or(0, |s| s.start));
        explain(error.message()).file(file).at_line(line, column)
    };
    let mut table: Table = toml::from_str(&text).map_err(in_file)?;
    // Read once for the places of its errors; the overrides are applied to the table and read again.
    toml::from_str::<T>(&text).map_err(in_file)?;
    for item in set {
        override_key::<T>(&mut table, item)?;
    }
    T::complete(&mut table);
    let document = read_table(&table).map_err(|e| explain(e.message()).file(file))?;
    let source = Source {
        file: file.to_owned(),
        text,
        set: set.to_vec(),
        given: table,
    };
    Ok((document, source))
}

impl Source {
    /// The overrides of keys that are among those under `keys`, as `render.prt`, or hold them.
    pub fn overrides_of<'a>(&'a self, keys: &'a [&str]) -> impl Iterator<Item = &'a str> {
        let is_within = |inner: &str, outer: &str| {
            let rest = inner.strip_prefix(outer);
            rest.is_some_and(|rest| rest.is_empty() || rest.starts_with('.'))
        };
        let concerns = move |item: &&str| {
            let set = normalise(item.split('=').next().unwrap_or_default());
            let mut keys = keys.iter();
            keys.any(|key| is_within(&set, key) || is_within(key, &set))
        };
        self.set.iter().map(String::as_str).filter(concerns)
    }

    /// The folder of the file, which paths in it are relative to.
    pub fn folder(&self) -> &Path {
        self.file.parent().unwrap_or(Path::new(""))
    }

    /// Whether a key, as `image.size`, is given: in the file, by an override or by a preset.
    pub fn gives(&self, key: &str) -> bool {
        let mut table = Some(&self.given);
        let mut found = false;
        for part in key.split('.') {
            let value = table.and_then(|t| t.get(part));
            found = value.is_some();
            table = value.and_then(Value::as_table);
        }
        found
    }

    /// An error about the value of a key, as `image.size` or `object.0.scale`, at its place in the file.
    pub fn error(&self, key: &str, what: impl std::fmt::Display) -> Error {
        let error = Error::usage(format!("{key}: {what}"));
        if let Some(item) = self.set.iter().rev().find(|item| {
            let set_key = item.split('=').next().unwrap_or_default();
            normalise(set_key) == key || key.starts_with(&format!("{}.", normalise(set_key)))
        }) {
            return error.at(format!("--set {item}"));
        }
        let error = error.file(&self.file);
        match locate(&self.text, key) {
            Some((line, column)) => error.at_line(line, column),
            None => error,
        }
    }
}

fn read_table<T: Document>(table: &Table) -> std::result::Result<T, toml::de::Error> {
    Value::Table(table.clone()).try_into()
}

/// Sets one key from `key=value`. A value that is not TOML, or not of the key's type, is taken as a string.
fn override_key<T: Document>(table: &mut Table, item: &str) -> Result<()> {
    let wrong = |error: Error| error.at(format!("--set {item}"));
    let Some((key, text)) = item.split_once('=') else {
        return Err(wrong(
            Error::usage("there is no `=`").fix(format!("write it as --set {}", T::EXAMPLE)),
        ));
    };
    let key = normalise(key);
    let text = text.trim();
    let as_string = Value::String(text.to_owned());
    let value = toml::from_str::<Table>(&format!("value = {text}"))
        .ok()
        .and_then(|mut t| t.remove("value"))
        .unwrap_or_else(|| as_string.clone());

    let mut changed = table.clone();
    insert(&mut changed, T::LISTS, &key, value).map_err(wrong)?;
    if let Err(error) = read_table::<T>(&changed) {
        let mut quoted = table.clone();
        insert(&mut quoted, T::LISTS, &key, as_string).map_err(wrong)?;
        if read_table::<T>(&quoted).is_err() {
            return Err(wrong(explain(error.message())));
        }
        changed = quoted;
    }
    *table = changed;
    Ok(())
}

/// `object[0].scale` is `object.0.scale`.
fn normalise(key: &str) -> String {
    key.trim().replace('[', ".").replace(']', "")
}

fn insert(table: &mut Table, lists: &[&str], key: &str, value: Value) -> Result<()> {
    let (path, last) = key.rsplit_once('.').unwrap_or(("", key));
    let mut here = table;
    let mut parts = path.split('.').filter(|p| !p.is_empty()).peekable();
    while let Some(part) = parts.next() {
        let slot = match part {
            list if lists.contains(&list)
                && (parts.peek().is_some() || last.parse::<usize>().is_ok()) =>
            {
                here.entry(list).or_insert_with(|| Value::Array(Vec::new()))
            }
            _ => here
                .entry(part)
                .or_insert_with(|| Value::Table(Table::new())),
        };
        here = match slot {
            Value::Table(table) => table,
            Value::Array(array) => element(array, part, parts.next().unwrap_or(last))?,
            _ => {
                return Err(Error::usage(format!(
                    "`{part}` is a value, not a table: it has no key `{last}`"
                )));
            }
        };
    }
    here.insert(last.to_owned(), value);
    Ok(())
}

/// The table at `index` of an array of tables; the one after the last is made.
fn element<'a>(array: &'a mut Vec<Value>, name: &str, index: &str) -> Result<&'a mut Table> {
    let len = array.len();
    let Ok(index) = index.parse::<usize>() else {
        return Err(
            Error::usage(format!("`{name}` is a list: `{index}` is no index"))
                .fix(format!("name one of its {len} by number, as {name}.0")),
        );
    };
    if index > len {
        return Err(Error::usage(format!(
            "`{name}.{index}` does not exist: there are {len}, counted from 0"
        )));
    }
    if index == len {
        array.push(Value::Table(Table::new()));
    }
    match &mut array[index] {
        Value::Table(table) => Ok(table),
        _ => Err(Error::usage(format!("`{name}.{index}` is not a table"))),
    }
}

/// Fills in what a preset means, where the key itself is not given.
fn apply_preset(table: &mut Table) {
    let preset = table.get("render").and_then(|r| r.get("preset"));
    let (pattern, is_papers) = match preset.and_then(Value::as_str) {
        Some("kronander") => ("independent", true),
        Some("stratified") => ("stratified", false),
        _ => return,
    };
    let word = |word: &str| Value::String(word.into());
    let settings: [(&[&str], &str, Value); 15] = [
        (&["image"], "rays_per_pixel", Value::Integer(1)),
        (&["image"], "filter", word("centre")),
        (&["render"], "pattern", word(pattern)),
        (&["render"], "brdf_samples", Value::Integer(15)),
        (&["render"], "env_samples", Value::Integer(15)),
        (&["render"], "compensation", Value::Boolean(false)),
        (&["render", "bis"], "candidates", Value::Integer(400)),
        (&["render", "bis"], "samples", Value::Integer(20)),
        (&["render", "bis"], "source", word("brdf")),
        (&["render", "smc"], "particles", Value::Integer(8)),
        (&["render", "smc"], "intermediate", Value::Integer(3)),
        (&["render", "smc"], "path", word("linear")),
        (&["render", "smc"], "resampling", word("systematic")),
        (&["render", "smc"], "ess_threshold", Value::Float(2.0 / 3.0)),
        (&["render", "smc"], "candidates", Value::Integer(400)),
    ];
    // The paper's rule is biased, so it comes with the paper's preset alone.
    let by_ratio: [(&[&str], &str, Value); 3] = [
        (&["render", "smc"], "reinitialise", Value::Float(1.25)),
        (&["render", "smc"], "max_age", Value::Integer(0)),
        (&["render", "smc"], "max_change", Value::Float(1.0)),
    ];
    let by_ratio = by_ratio.into_iter().filter(|_| is_papers);
    for (path, key, value) in settings.into_iter().chain(by_ratio) {
        if let Some(section) = section(table, path) {
            section.entry(key).or_insert(value);
        }
    }
}

/// Fills in the method where it is not given but a key of "mis" is. Fills in a memory of "cells" where a method is given: a shot that names
/// none has frames that may each be rendered alone.
fn choose_method(table: &mut Table) {
    let Some(render) = section(table, &["render"]) else {
        return;
    };
    let is_named = render.contains_key("method");
    if !is_named && Mis::KEYS.iter().any(|key| render.contains_key(*key)) {
        render.insert("method".into(), Value::String("mis".into()));
    }
    if let Some(cells) = section(render, &["cells"]) {
        let memory = cells.entry("memory");
        memory.or_insert(Value::Boolean(is_named));
    }
}

/// A table in a table, made where it is not there; `None` where something else is.
fn section<'a>(table: &'a mut Table, path: &[&str]) -> Option<&'a mut Table> {
    let Some((first, rest)) = path.split_first() else {
        return Some(table);
    };
    let inner = table
        .entry(*first)
        .or_insert_with(|| Value::Table(Table::new()));
    match inner {
        Value::Table(inner) => section(inner, rest),
        _ => None,
    }
}

/// Turns a message of the deserialiser into ours: an unknown word gets the nearest known one.
fn explain(message: &str) -> Error {
    let kinds = [
        ("unknown field `", "unknown key"),
        ("unknown variant `", "unknown value"),
    ];
    for (start, name) in kinds {
        let Some(rest) = message.strip_prefix(start) else {
            continue;
        };
        let Some((word, known)) = rest.split_once('`') else {
            continue;
        };
        // The known words stand between backquotes, so in every second piece.
        let known: Vec<&str> = known.split('`').skip(1).step_by(2).collect();
        let error = Error::usage(format!("{name} `{word}`"));
        return match nearest(word, known.iter().copied()) {
            Some(near) => error.fix(format!("did you mean `{near}`?")),
            None => error.fix(format!("known here: {}", known.join(", "))),
        };
    }
    Error::usage(message)
}

/// Line and column, from 1, of a byte of the text.
fn position(text: &str, byte: usize) -> (usize, usize) {
    let before = &text[..text.floor_char_boundary(byte.min(text.len()))];
    let line = before.matches('\n').count() + 1;
    let start = before.rfind('\n').map_or(0, |i| i + 1);
    (line, before[start..].chars().count() + 1)
}

/// Where a key stands in the text, or the nearest table around it.
fn locate(text: &str, key: &str) -> Option<(usize, usize)> {
    let document = DeTable::parse(text).ok()?;
    let mut span = None;
    let mut table = Some(document.get_ref());
    let mut array = None;
    for part in key.split('.') {
        let value: &DeValue<'_> = if let Some(t) = table {
            let Some((k, v)) = t.iter().find(|(k, _)| k.get_ref() == part) else {
                break;
            };
            span = Some(k.span());
            v.get_ref()
        } else {
            let a: &toml::de::DeArray<'_> = array?;
            let Some(v) = part.parse::<usize>().ok().and_then(|i| a.get(i)) else {
                break;
            };
            span = Some(v.span());
            v.get_ref()
        };
        (table, array) = (value.as_table(), value.as_array());
        if table.is_none() && array.is_none() {
            break;
        }
    }
    span.map(|s| position(text, s.start))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shot::Method;

    fn shot(text: &str, set: &[&str]) -> Result<Shot> {
        let set: Vec<String> = set.iter().map(|s| (*s).to_owned()).collect();
        parse(Path::new("s.toml"), text.to_owned(), &set).map(|(shot, _)| shot)
    }

    #[test]
    fn an_empty_shot_has_all_defaults() {
        assert_eq!(shot("", &[]).unwrap(), Shot::default());
    }

    #[test]
    fn the_method_is_that_of_the_keys_that_are_given() {
        let method = |text: &str, set: &[&str]| {
            let render = shot(text, set).unwrap().render;
            (render.method, render.cells.memory)
        };
        assert_eq!(method("", &[]), (Method::Cells, false));
        let by_name = "[render]\nmethod = \"cells\"\n";
        assert_eq!(method(by_name, &[]), (Method::Cells, true));
        let asked = ["render.cells.memory=true"];
        assert_eq!(method("", &asked), (Method::Cells, true));
        for text in [
            "[render]\nbrdf_samples = 4\n",
            "[render]\ncompensation = false\n",
            "[render]\npreset = \"kronander\"\n",
        ] {
            assert_eq!(method(text, &[]).0, Method::Mis, "{text}");
        }
        assert_eq!(method("", &["render.env_samples=2"]).0, Method::Mis);
        let other = "[render]\nmethod = \"smc\"\nbrdf_samples = 4\n";
        assert_eq!(method(other, &[]).0, Method::Smc);
    }

    #[test]
    fn unknown_keys_and_values_name_the_nearest() {
        let error = shot("[image]\n  siez = [1, 2]\n", &[]).unwrap_err();
        let expected = "s.toml:2:3: unknown key `siez`; did you mean `size`?";
        assert_eq!(error.to_string(), expected);
        let error = shot("[image]\nfilter = \"center\"", &[]).unwrap_err();
        assert!(error.to_string().contains("did you mean `centre`?"));
        let error = shot("[image]\nsize = \"big\"", &[]).unwrap_err();
        assert!(error.to_string().starts_with("s.toml:2:8: invalid type"));
    }

    #[test]
    fn overrides_reach_every_key() {
        let text = "[[object]]\nmesh = \"a.obj\"\n";
        let set = [
            "image.size=[4, 2]",
            "object.0.scale=2",
            "object[0].up=z",
            "object.0.material.diffuse=[1,0,0]",
            "object.1.mesh=plane",
            "render.frames=7",
            "probe.frames=light.exr",
        ];
        let shot = shot(text, &set).unwrap();
        assert_eq!(shot.image.size, [4, 2]);
        assert_eq!(shot.objects[0].scale, 2.0);
        assert_eq!(shot.objects[0].up, Some(super::super::Up::Z));
        assert_eq!(
            shot.objects[0].material.as_ref().unwrap().diffuse,
            [1.0, 0.0, 0.0]
        );
        assert_eq!(shot.objects[1].mesh, "plane");
        assert_eq!(shot.render.frames, "7");
        assert_eq!(shot.probe.frames, "light.exr");
    }

    #[test]
    fn overrides_are_checked() {
        let message = |set: &str| shot("", &[set]).unwrap_err().to_string();
        assert_eq!(
            message("image.siez=3"),
            "--set image.siez=3: unknown key `siez`; did you mean `size`?"
        );
        assert!(message("image").contains("there is no `=`"));
        assert!(message("object.2.scale=1").contains("does not exist"));
        assert!(message("image.size=big").starts_with("--set image.size=big: invalid type"));
    }

    #[test]
    fn overrides_of_some_keys_are_picked() {
        let set = [
            "object[0].scale=2",
            "objects=1",
            "camera.fov_x_deg=9",
            "render.seed=2",
            "render.prt.bands=3",
            "render={}",
        ];
        let source = Source {
            file: "s.toml".into(),
            text: String::new(),
            set: set.map(str::to_owned).to_vec(),
            given: Table::new(),
        };
        let picked: Vec<&str> = source.overrides_of(&["object", "render.prt"]).collect();
        assert_eq!(picked, [set[0], set[4], set[5]]);
    }

    #[test]
    fn a_preset_yields_to_given_keys() {
        let text = "[render]\npreset = \"kronander\"\nenv_samples = 3\n";
        let shot = shot(text, &["image.rays_per_pixel=2"]).unwrap();
        assert_eq!(shot.render.brdf_samples, 15);
        assert_eq!(shot.render.env_samples, 3);
        assert!(!shot.render.compensation);
        assert_eq!(shot.image.rays_per_pixel, 2);
        assert_eq!(shot.image.filter, super::super::Filter::Centre);
        let smc = shot.render.smc;
        assert_eq!((smc.reinitialise, smc.max_age), (1.25, 0));
        let text = "[render]\npreset = \"stratified\"\nbis = { samples = 3 }\n";
        let render = self::shot(text, &[]).unwrap().render;
        assert_eq!(render.pattern, super::super::Pattern::Stratified);
        assert_eq!((render.bis.candidates, render.bis.samples), (400, 3));
        assert_eq!(render.smc.reinitialise, 0.0);
    }

    #[test]
    fn values_are_located() {
        let text = "[image]\nsize = [1, 1]\n\n[[object]]\nmesh = \"a\"\n[[object]]\nscale = 0\n";
        assert_eq!(locate(text, "image.size"), Some((2, 1)));
        assert_eq!(locate(text, "object.1.scale"), Some((7, 1)));
        assert_eq!(locate(text, "camera.eye"), None);
    }
}
